/* Lesson 3's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step03_triangle/main.c"
#endif
#include "numbers.h"

static const struct color called_white = {255, 255, 255, 255};

/* Edges as triangle_setup() finds them: of the triangle that the text computes by hand, of the same
 * one given clockwise, of one outside the image, and of one that reaches far beyond it. */
static const struct edges called_by_hand = {
    .edge = {{1245184, -196608, -262144, 1}, {-196608, 196608, 0, 0}, {-262144, 0, 262144, 1}},
    .area = 786432,
    .y_begin = 1,
    .y_end = 5,
    .width = 8};
static const struct edges called_turned = {
    .edge = {{1245184, -196608, -262144, 1}, {-262144, 0, 262144, 1}, {-196608, 196608, 0, 0}},
    .area = 786432,
    .clockwise = true,
    .y_begin = 1,
    .y_end = 5,
    .width = 8};
static const struct edges called_at_the_right = {
    .edge = {{15728640, -786432, 0, 1}, {-3145728, 786432, -1048576, 0}, {0, 0, 1048576, 1}},
    .area = 12582912,
    .y_end = 8,
    .width = 8};
static const struct edges called_far_away = {
    .edge = {{65536000000000000, 65536458752, 65536000000, 0},
             {65536000000000000, -65536459008, 65536000000, 1},
             {917760000000, 256, -131072000000, 0}},
    .area = 131072917760000000,
    .y_end = 8,
    .width = 8};

/* ---- Part a ---- */

static struct shown called_line_drawn(struct pixel a, struct pixel b) {
    struct image image = black_image(8, 8);
    unsigned long long count = draw_line(&image, a, b, called_white);
    return show("%llu: %.150s", count, show_pixels(&image).text);
}

static struct shown called_box_drawn(struct vec2 a, struct vec2 b, struct vec2 c) {
    struct image image = black_image(8, 8);
    unsigned long long count = box_triangle(&image, (struct vec2[3]){a, b, c}, called_white);
    return show("%llu: %.150s", count, show_pixels(&image).text);
}

/* The whole image. */
static uint64_t called_boxed(void) {
    struct image image = black_image(8, 8);
    uint64_t count =
        box_triangle(&image, (struct vec2[3]){{-9, -9}, {30, -9}, {-9, 30}}, called_white);
    image_free(&image);
    return count;
}

static struct shown called_turned_away(struct vec2 a, struct vec2 b, struct vec2 c) {
    return show_truth(is_turned_away((struct vec2[3]){a, b, c}));
}

/* ---- Part b ---- */

static struct fixed2 called_on(int x, int y) {
    return (struct fixed2){x, y};
}

static struct shown called_edge_made(struct fixed2 p, struct fixed2 q, int sign) {
    struct edge e = make_edge(p, q, sign);
    return show("origin %lld, dx %lld, dy %lld, least %lld", (long long)e.origin, (long long)e.dx,
                (long long)e.dy, (long long)e.least);
}

static bool called_same_edge(struct edge a, struct edge b) {
    return a.origin == b.origin && a.dx == b.dx && a.dy == b.dy && a.least == b.least;
}

/* Are these what make_edge() gives, right or wrong? */
static bool called_has_edges(const struct edges *edges, struct fixed2 a, struct fixed2 b,
                             struct fixed2 c, int sign) {
    return called_same_edge(edges->edge[0], make_edge(b, c, sign)) &&
           called_same_edge(edges->edge[1], make_edge(c, a, sign)) &&
           called_same_edge(edges->edge[2], make_edge(a, b, sign));
}

static struct shown called_set_up(struct fixed2 a, struct fixed2 b, struct fixed2 c, int sign) {
    struct edges edges = {.y_begin = 0};
    if (!triangle_setup(&edges, a, b, c, 40, 8)) {
        return show("false");
    }
    return show("area %lld, clockwise %d, rows %d to %d, width %d, edges %s", (long long)edges.area,
                edges.clockwise, edges.y_begin, edges.y_end, edges.width,
                called_has_edges(&edges, a, b, c, sign) ? sign > 0 ? "with sign 1" : "with sign -1"
                : called_has_edges(&edges, a, b, c, -sign) ? "with the other sign"
                                                           : "in another order");
}

static struct shown called_found(const struct edges *edges, int y) {
    struct span span = triangle_span(edges, y);
    return span.begin == span.end ? show("empty") : show("%d to %d", span.begin, span.end);
}

static struct shown called_filled(struct fixed2 a, struct fixed2 b, struct fixed2 c) {
    struct image image = black_image(8, 8);
    unsigned long long count = triangle(&image, (struct fixed2[3]){a, b, c}, called_white);
    return show("%llu: %.150s", count, show_pixels(&image).text);
}

/* There is one more row above the image, for programs that draw there. */
static uint64_t called_counted(struct fixed2 a, struct fixed2 b, struct fixed2 c) {
    struct image image = black_image(8, 9);
    image.height = 8;
    uint64_t count = triangle(&image, (struct fixed2[3]){a, b, c}, called_white);
    image_free(&image);
    return count;
}

/* ---- Part c ---- */

static struct shown called_mixed(struct vec3 weight, struct color a, struct color b,
                                 struct color c) {
    return show_color(mix_colors(weight, (struct color[3]){a, b, c}));
}

/* How many pixels, and the colour of one, whose x is not its y. */
static struct shown called_gradient(struct fixed2 a, struct fixed2 b, struct fixed2 c, int x,
                                    int y) {
    struct image image = black_image(8, 8);
    const struct color colors[3] = {rgb(255, 0, 0), rgb(0, 255, 0), rgb(0, 0, 255)};
    unsigned long long count = gradient_triangle(&image, (struct fixed2[3]){a, b, c}, colors);
    struct color color = image_get(&image, x, y);
    image_free(&image);
    return show("%llu pixels, (%d,%d) is %s", count, x, y, show_color(color).text);
}

#define BOX(a, b, c, right)                                                                        \
    TEXT("3a.3", "box_triangle(image, " #a " " #b " " #c ", white)",                               \
         called_box_drawn(xy a, xy b, xy c), right)
#define TURNED_AWAY(a, b, c, right)                                                                \
    TEXT("3a.4", "is_turned_away(" #a " " #b " " #c ")", called_turned_away(xy a, xy b, xy c),     \
         right)
#define EDGE(p, q, sign, right)                                                                    \
    TEXT("3b.1", "make_edge(" #p ", " #q ", " #sign ")",                                           \
         called_edge_made(called_on p, called_on q, sign), right)
#define SET_UP(a, b, c, sign, right)                                                               \
    TEXT("3b.2", "triangle_setup(&edges, " #a ", " #b ", " #c ", 40, 8)",                          \
         called_set_up(called_on a, called_on b, called_on c, sign), right)
#define SPAN(edges, name, y, right)                                                                \
    TEXT("3b.3", "triangle_span(edges of " name ", " #y ")", called_found(&(edges), y), right)
#define FILLED(a, b, c, right)                                                                     \
    TEXT("3b.4", "triangle(image, " #a " " #b " " #c ", white)",                                   \
         called_filled(called_on a, called_on b, called_on c), right)
#define COUNTED(a, b, c, right)                                                                    \
    AS_WHOLE("3b.4", "triangle(image, " #a " " #b " " #c ", white)",                               \
             called_counted(called_on a, called_on b, called_on c), right)
#define WEIGHTS(edges, name, x, y, right)                                                          \
    AS_VECTOR("3c.1", "triangle_weights(" name ", " #x ", " #y ")", vec3,                          \
              triangle_weights(&(edges), x, y), right)
#define GRADIENT(a, b, c, x, y, right)                                                             \
    TEXT("3c.3", "gradient_triangle(image, " #a " " #b " " #c ", red green blue)",                 \
         called_gradient(called_on a, called_on b, called_on c, x, y), right)

static void numbers(void) {
    TEXT("3a.1", "draw_line(image, (0, 0), (5, 2), white)", called_line_drawn(at(0, 0), at(5, 2)),
         "6: (0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    TEXT("3a.1", "draw_line(image, (-5, 1), (-1, 2), white)",
         called_line_drawn(at(-5, 1), at(-1, 2)), "0: none");
    REAL("3a.2", side_of(xy(1, 1), xy(5, 1), xy(1, 4)), 12);
    REAL("3a.2", side_of(xy(5, 1), xy(1, 4), xy(2, 2)), 5);
    REAL("3a.2", side_of(xy(5, 1), xy(1, 4), xy(3, 3)), -2);
    REAL("3a.2", side_of(xy(1, 4), xy(1, 1), xy(1, 2)), 0);
    BOX((1, 1), (5, 1), (1, 4), "6: (1,1) (2,1) (3,1) (1,2) (2,2) (1,3)");
    BOX((1, 1), (1, 4), (5, 1), "6: (1,1) (2,1) (3,1) (1,2) (2,2) (1,3)");
    BOX((0.5, 2.5), (4.5, 2.5), (6.5, 2.5), "0: none");
    AS_WHOLE("3a.3", "box_triangle(image, (-9, -9) (30, -9) (-9, 30), white)", called_boxed(), 64);
    TURNED_AWAY((1, 1), (5, 1), (1, 4), "false");
    TURNED_AWAY((1, 1), (1, 4), (5, 1), "true");
    TURNED_AWAY((0, 0), (0, 0.5), (0.5, 0), "true");

    EDGE((1408, 384), (384, 1152), 1, "origin 1245184, dx -196608, dy -262144, least 1");
    EDGE((384, 1152), (384, 384), 1, "origin -196608, dx 196608, dy 0, least 0");
    EDGE((384, 384), (1408, 384), 1, "origin -262144, dx 0, dy 262144, least 1");
    EDGE((384, 384), (1408, 384), -1, "origin 262144, dx 0, dy -262144, least 0");
    EDGE((384, 384), (384, 1152), -1, "origin -196608, dx 196608, dy 0, least 0");
    EDGE((500000000, 0), (-500000000, 300000000), 1,
         "origin 149999833600000000, dx -76800000000, dy -256000000000, least 1");
    SET_UP((384, 384), (1408, 384), (384, 1152), 1,
           "area 786432, clockwise 0, rows 1 to 5, width 40, edges with sign 1");
    SET_UP((384, 384), (384, 1152), (1408, 384), -1,
           "area 786432, clockwise 1, rows 1 to 5, width 40, edges with sign -1");
    SET_UP((384, 384), (1408, 384), (2432, 384), 1, "false");
    SPAN(called_by_hand, "the example", 2, "1 to 4");
    SPAN(called_by_hand, "the example", 4, "empty");
    SPAN(called_at_the_right, "(4,0) (20,0) (20,12)", 1, "6 to 8");
    SPAN(called_at_the_right, "(4,0) (20,0) (20,12)", 6, "empty");
    SPAN(called_far_away, "(1e6,7) (-1e6,7) (0,-1e6)", 0, "0 to 8");
    FILLED((384, 384), (1408, 384), (384, 1152), "5: (1,2) (2,2) (3,2) (1,3) (2,3)");
    FILLED((384, 384), (384, 1152), (1408, 384), "5: (1,2) (2,2) (3,2) (1,3) (2,3)");
    COUNTED((1152, 128), (5248, 128), (5248, 3200), 3);
    COUNTED((-2048, -2048), (8192, -2048), (-2048, 8192), 64);

    WEIGHTS(called_by_hand, "edges of the example", 2, 2, xyz(5 / 12.0, 3 / 12.0, 4 / 12.0));
    WEIGHTS(called_by_hand, "edges of the example", 1, 1, xyz(1, 0, 0));
    WEIGHTS(called_turned, "the same given clockwise", 2, 3, xyz(1 / 12.0, 8 / 12.0, 3 / 12.0));
    TEXT("3c.2", "mix_colors((0.5, 0.25, 0.25), 10,20,30 90,60,30 50,40,90)",
         called_mixed(xyz(0.5, 0.25, 0.25), rgb(10, 20, 30), rgb(90, 60, 30), rgb(50, 40, 90)),
         "40,35,45");
    TEXT("3c.2", "mix_colors((5/12, 3/12, 4/12), red green blue)",
         called_mixed(xyz(5 / 12.0, 3 / 12.0, 4 / 12.0), rgb(255, 0, 0), rgb(0, 255, 0),
                      rgb(0, 0, 255)),
         "106,64,85");
    GRADIENT((384, 384), (1408, 384), (384, 1152), 2, 3, "5 pixels, (2,3) is 21,64,170");
    GRADIENT((256, 256), (256, 1280), (1280, 256), 1, 3, "6 pixels, (1,3) is 64,159,32");
}
