/* Lesson 3's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step03_triangle/main.c"
#endif
#include "numbers.h"

static const struct color called_white = {255, 255, 255, 255};

enum { CALLED_WIDTH = 9, CALLED_HEIGHT = 5 }; /* of an image that is not square */

/* ---- Part a ---- */

static struct shown called_line_drawn(struct pixel a, struct pixel b) {
    struct image image = black_image(CALLED_WIDTH, CALLED_HEIGHT);
    unsigned long long count = draw_line(&image, a, b, called_white);
    return show("%llu: %.150s", count, show_pixels(&image).text);
}

/* "6: (1,1) (2,1)": how many it returns, and which it sets in an image of that size. */
static struct shown called_box_drawn(struct vec2 a, struct vec2 b, struct vec2 c, size_t width,
                                     size_t height) {
    struct image image = black_image(width, height);
    unsigned long long count = box_triangle(&image, (struct vec2[3]){a, b, c}, called_white);
    return show("%llu: %.150s", count, show_pixels(&image).text);
}

/* What it must give with a side_of() that is right or wrong. */
static struct shown called_box_by_sides(struct vec2 a, struct vec2 b, struct vec2 c, size_t width,
                                        size_t height) {
    struct image image = black_image(width, height);
    struct span columns =
        pixels_between(fmin(a.x, fmin(b.x, c.x)), fmax(a.x, fmax(b.x, c.x)), width);
    struct span rows = pixels_between(fmin(a.y, fmin(b.y, c.y)), fmax(a.y, fmax(b.y, c.y)), height);
    double area = side_of(a, b, c), sign = area > 0 ? 1 : -1;
    unsigned count = 0;
    for (int y = rows.begin; area != 0 && y < rows.end; y++) {
        for (int x = columns.begin; x < columns.end; x++) {
            struct vec2 center = {x + 0.5, y + 0.5};
            if (sign * side_of(b, c, center) >= 0 && sign * side_of(c, a, center) >= 0 &&
                sign * side_of(a, b, center) >= 0) {
                image_set(&image, x, y, called_white);
                count++;
            }
        }
    }
    return show("%u: %.150s", count, show_pixels(&image).text);
}

/* "45": without the pixels. */
static struct shown called_count(struct shown shown) {
    shown.text[strcspn(shown.text, ":")] = '\0';
    return shown;
}

static struct shown called_turned_away(struct vec2 a, struct vec2 b, struct vec2 c) {
    return show_truth(is_turned_away((struct vec2[3]){a, b, c}));
}

static struct shown called_turned_by_sides(struct vec2 a, struct vec2 b, struct vec2 c) {
    return show_truth(side_of(a, b, c) < 0);
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

/* What triangle_setup() should find over 8 x 8 pixels, by common's version, which this lesson does
 * not give (common/given/later.h). */
#undef edges_setup
static struct edges called_edges(struct fixed2 a, struct fixed2 b, struct fixed2 c) {
    struct edges edges = {.y_begin = 0};
    edges_setup(&edges, a, b, c, 8, 8);
    return edges;
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

/* There is one more row above the image, for programs that draw there. */
static struct image called_image(size_t width, size_t height) {
    struct image image = black_image(width, height + 1);
    image.height = height;
    return image;
}

static struct shown called_filled(struct fixed2 a, struct fixed2 b, struct fixed2 c, size_t width,
                                  size_t height) {
    struct image image = called_image(width, height);
    unsigned long long count = triangle(&image, (struct fixed2[3]){a, b, c}, called_white);
    return show("%llu: %.150s", count, show_pixels(&image).text);
}

/* The triangle by the functions that triangle() calls, right or wrong: its pixels in white, or in
 * the colours that are mixed there. Returns their number. */
static unsigned called_by_spans(struct image *image, const struct fixed2 corner[3],
                                const struct color *colors) {
    struct edges edges = {.y_begin = 0};
    unsigned count = 0;
    if (!triangle_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        return 0;
    }
    for (int y = edges.y_begin; y < edges.y_end && y < (int)image->height; y++) {
        struct span span = triangle_span(&edges, y);
        count += (unsigned)(span.end - span.begin);
        for (int x = 0; x < (int)image->width; x++) {
            if (x >= span.begin && x < span.end) {
                image_set(image, x, y,
                          colors == NULL ? called_white
                                         : mix_colors(triangle_weights(&edges, x, y), colors));
            }
        }
    }
    return count;
}

static struct shown called_filled_by_spans(struct fixed2 a, struct fixed2 b, struct fixed2 c,
                                           size_t width, size_t height) {
    struct image image = called_image(width, height);
    unsigned count = called_by_spans(&image, (struct fixed2[3]){a, b, c}, NULL);
    return show("%u: %.150s", count, show_pixels(&image).text);
}

/* ---- Part c ---- */

static struct shown called_mixed(struct vec3 weight, struct color a, struct color b,
                                 struct color c) {
    return show_color(mix_colors(weight, (struct color[3]){a, b, c}));
}

static const struct color called_colors[3] = {
    {.r = 255, .a = 255}, {.g = 255, .a = 255}, {.b = 255, .a = 255}};

/* How many pixels, and the colour of one, whose x is not its y. */
static struct shown called_gradient(struct fixed2 a, struct fixed2 b, struct fixed2 c, int x, int y,
                                    bool by_spans) {
    struct image image = called_image(CALLED_WIDTH, CALLED_HEIGHT);
    const struct fixed2 corner[3] = {a, b, c};
    unsigned long long count = by_spans ? called_by_spans(&image, corner, called_colors)
                                        : gradient_triangle(&image, corner, called_colors);
    struct color color = image_get(&image, x, y);
    image_free(&image);
    return show("%llu pixels, (%d,%d) is %s", count, x, y, show_color(color).text);
}

/* How many pixels, and which. */
static struct shown called_shaded(struct fixed2 a, struct fixed2 b, struct fixed2 c,
                                  bool by_spans) {
    struct image image = called_image(CALLED_WIDTH, CALLED_HEIGHT);
    const struct fixed2 corner[3] = {a, b, c};
    unsigned long long count = by_spans ? called_by_spans(&image, corner, called_colors)
                                        : gradient_triangle(&image, corner, called_colors);
    return show("%llu: %.150s", count, show_pixels(&image).text);
}

#define BOX(a, b, c, right)                                                                        \
    TEXT_WITH("3a.3", "box_triangle(image, " #a " " #b " " #c ", white)",                          \
              called_box_drawn(xy a, xy b, xy c, 8, 8), right,                                     \
              called_box_by_sides(xy a, xy b, xy c, 8, 8))
#define TURNED_AWAY(a, b, c, right)                                                                \
    TEXT_WITH("3a.4", "is_turned_away(" #a " " #b " " #c ")",                                      \
              called_turned_away(xy a, xy b, xy c), right,                                         \
              called_turned_by_sides(xy a, xy b, xy c))
#define EDGE(p, q, sign, right)                                                                    \
    TEXT("3b.1", "make_edge(" #p ", " #q ", " #sign ")",                                           \
         called_edge_made(called_on p, called_on q, sign), right)
#define SET_UP(a, b, c, sign, right)                                                               \
    TEXT("3b.2", "triangle_setup(&edges, " #a ", " #b ", " #c ", 40, 8)",                          \
         called_set_up(called_on a, called_on b, called_on c, sign), right)
#define EDGES(a, b, c) called_edges(called_on a, called_on b, called_on c)
#define SPAN(edges, name, y, right)                                                                \
    TEXT("3b.3", "triangle_span(edges of " name ", " #y ")", called_found(&(edges), y), right)
#define FILLED(a, b, c, right)                                                                     \
    TEXT_WITH("3b.4", "triangle(image, " #a " " #b " " #c ", white)",                              \
              called_filled(called_on a, called_on b, called_on c, CALLED_WIDTH, CALLED_HEIGHT),   \
              right,                                                                               \
              called_filled_by_spans(called_on a, called_on b, called_on c, CALLED_WIDTH,          \
                                     CALLED_HEIGHT))
#define COUNTED(a, b, c, width, height, right)                                                     \
    TEXT_WITH("3b.4", "triangle(image of " #width " x " #height ", " #a " " #b " " #c ", white)",  \
              called_count(called_filled(called_on a, called_on b, called_on c, width, height)),   \
              right,                                                                               \
              called_count(                                                                        \
                  called_filled_by_spans(called_on a, called_on b, called_on c, width, height)))
#define WEIGHTS(edges, name, x, y, right)                                                          \
    AS_VECTOR("3c.1", "triangle_weights(" name ", " #x ", " #y ")", vec3,                          \
              triangle_weights(&(edges), x, y), right)
#define GRADIENT(a, b, c, x, y, right)                                                             \
    TEXT_WITH("3c.3", "gradient_triangle(image, " #a " " #b " " #c ", red green blue)",            \
              called_gradient(called_on a, called_on b, called_on c, x, y, false), right,          \
              called_gradient(called_on a, called_on b, called_on c, x, y, true))
#define SHADED(a, b, c, right)                                                                     \
    TEXT_WITH("3c.3", "pixels of gradient_triangle(image, " #a " " #b " " #c ", red green blue)",  \
              called_shaded(called_on a, called_on b, called_on c, false), right,                  \
              called_shaded(called_on a, called_on b, called_on c, true))
#define COUNT_SHADED(a, b, c, right)                                                               \
    TEXT_WITH("3c.3", "count of gradient_triangle(image, " #a " " #b " " #c ", red green blue)",   \
              called_count(called_shaded(called_on a, called_on b, called_on c, false)), right,    \
              called_count(called_shaded(called_on a, called_on b, called_on c, true)))

static void numbers(void) {
    const struct edges by_hand = EDGES((384, 384), (1408, 384), (384, 1152));
    const struct edges turned = EDGES((384, 384), (384, 1152), (1408, 384));
    const struct edges at_the_right = EDGES((1152, 128), (5248, 128), (5248, 3200));
    /* Its right edge leaves the image at the left. */
    const struct edges at_the_left = EDGES((-2000, 0), (512, 0), (-2000, 3000));
    /* Its upper edge runs through pixel centres. */
    const struct edges level = EDGES((384, 384), (1408, 1152), (384, 1152));
    /* A pixel centre is as near to its right edge as one can be. */
    const struct edges near = EDGES((725, 1568), (-84, 1399), (2153, 163));
    /* A float has too few digits for these. */
    const struct edges far_and_near =
        EDGES((384, 896), (162925964, -162412007), (-120982037, 145894675));
    /* An edge meets row 0 at an x that does not fit in an int. */
    const struct edges nearly_level = EDGES((-256000000, 1793), (0, -256000000), (256000000, 1792));
    const struct edges far_away = EDGES((256000128, 1921), (-255999872, 1920), (128, -255999872));

    TEXT("3a.1", "draw_line(image, (0, 0), (5, 2), white)", called_line_drawn(at(0, 0), at(5, 2)),
         "6: (0,0) (1,0) (2,1) (3,1) (4,2) (5,2)");
    TEXT("3a.1", "draw_line(image, (-5, 1), (-1, 2), white)",
         called_line_drawn(at(-5, 1), at(-1, 2)), "0: none");
    TEXT("3a.1", "draw_line(image of 9 x 5, (3, -2), (8, 8), white)",
         called_line_drawn(at(3, -2), at(8, 8)), "5: (4,0) (4,1) (5,2) (5,3) (6,4)");
    TEXT("3a.1", "draw_line(image of 9 x 5, (12, 5), (6, 2), white)",
         called_line_drawn(at(12, 5), at(6, 2)), "3: (6,2) (7,2) (8,3)");
    REAL("3a.2", side_of(xy(1, 1), xy(5, 1), xy(1, 4)), 12);
    REAL("3a.2", side_of(xy(5, 1), xy(1, 4), xy(2, 2)), 5);
    REAL("3a.2", side_of(xy(5, 1), xy(1, 4), xy(3, 3)), -2);
    REAL("3a.2", side_of(xy(1, 4), xy(1, 1), xy(1, 2)), 0);
    BOX((1, 1), (5, 1), (1, 4), "6: (1,1) (2,1) (3,1) (1,2) (2,2) (1,3)");
    BOX((1, 1), (1, 4), (5, 1), "6: (1,1) (2,1) (3,1) (1,2) (2,2) (1,3)");
    BOX((7, 1), (2, 3), (2, 1), "5: (2,1) (3,1) (4,1) (5,1) (2,2)");
    BOX((2, 3), (2, 1), (7, 1), "5: (2,1) (3,1) (4,1) (5,1) (2,2)");
    BOX((2.3, 3.3), (2.9, 3.3), (2.5, 3.8), "1: (2,3)");
    BOX((0.5, 2.5), (4.5, 2.5), (6.5, 2.5), "0: none");
    TEXT_WITH("3a.3", "box_triangle(image of 9 x 5, (-9, -9) (30, -9) (-9, 30), white)",
              called_count(called_box_drawn(xy(-9, -9), xy(30, -9), xy(-9, 30), 9, 5)), "45",
              called_count(called_box_by_sides(xy(-9, -9), xy(30, -9), xy(-9, 30), 9, 5)));
    TURNED_AWAY((1, 1), (5, 1), (1, 4), "false");
    TURNED_AWAY((1, 1), (1, 4), (5, 1), "true");
    TURNED_AWAY((0, 0), (0, 0.5), (0.5, 0), "true");
    TURNED_AWAY((1, 1), (3, 1), (5, 1), "false");

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
    SET_UP((383, 383), (385, 383), (384, 385), 1,
           "area 4, clockwise 0, rows 1 to 2, width 40, edges with sign 1");
    SET_UP((-1000, 100), (-1000, 1000), (3000, 500), -1,
           "area 3600000, clockwise 1, rows 0 to 4, width 40, edges with sign -1");
    SET_UP((0, 0), (102400, 0), (0, 102400), 1,
           "area 10485760000, clockwise 0, rows 0 to 8, width 40, edges with sign 1");
    SET_UP((-230400000, -230400000), (230400000, 230399990), (230400000, 230400010), 1,
           "area 9216000000, clockwise 0, rows 0 to 8, width 40, edges with sign 1");
    SPAN(by_hand, "the example", 2, "1 to 4");
    SPAN(by_hand, "the example", 4, "empty");
    SPAN(turned, "the example given clockwise", 1, "empty");
    SPAN(level, "(384, 384) (1408, 1152) (384, 1152)", 4, "1 to 5");
    SPAN(at_the_left, "(-2000, 0) (512, 0) (-2000, 3000)", 2, "empty");
    SPAN(at_the_left, "(-2000, 0) (512, 0) (-2000, 3000)", 3, "empty");
    SPAN(near, "(725, 1568) (-84, 1399) (2153, 163)", 3, "3 to 6");
    SPAN(far_and_near, "(384, 896) (162925964, -162412007) (-120982037, 145894675)", 3, "1 to 8");
    SPAN(at_the_right, "(4,0) (20,0) (20,12)", 1, "6 to 8");
    SPAN(at_the_right, "(4,0) (20,0) (20,12)", 6, "empty");
    SPAN(far_away, "(1e6,7) (-1e6,7) (0,-1e6)", 0, "0 to 8");
    SPAN(nearly_level, "(-256000000, 1793) (0, -256000000) (256000000, 1792)", 0, "0 to 8");
    FILLED((384, 384), (1408, 384), (384, 1152), "5: (1,2) (2,2) (3,2) (1,3) (2,3)");
    FILLED((384, 384), (384, 1152), (1408, 384), "5: (1,2) (2,2) (3,2) (1,3) (2,3)");
    FILLED((421, 53), (122, 639), (152, 694), "2: (1,0) (0,2)");
    COUNTED((1152, 128), (5248, 128), (5248, 3200), 9, 5, "5");
    COUNTED((-2048, -2048), (8192, -2048), (-2048, 8192), 9, 5, "45");
    COUNTED((-2048, -2048), (8192, -2048), (-2048, 8192), 5, 9, "45");

    WEIGHTS(by_hand, "edges of the example", 2, 2, xyz(5 / 12.0, 3 / 12.0, 4 / 12.0));
    WEIGHTS(by_hand, "edges of the example", 1, 1, xyz(1, 0, 0));
    WEIGHTS(turned, "the same given clockwise", 2, 3, xyz(1 / 12.0, 8 / 12.0, 3 / 12.0));
    TEXT("3c.2", "mix_colors((0.5, 0.25, 0.25), 10,20,30 90,60,30 50,40,90)",
         called_mixed(xyz(0.5, 0.25, 0.25), rgb(10, 20, 30), rgb(90, 60, 30), rgb(50, 40, 90)),
         "40,35,45");
    TEXT("3c.2", "mix_colors((5/12, 3/12, 4/12), red green blue)",
         called_mixed(xyz(5 / 12.0, 3 / 12.0, 4 / 12.0), rgb(255, 0, 0), rgb(0, 255, 0),
                      rgb(0, 0, 255)),
         "106,64,85");
    GRADIENT((384, 384), (1408, 384), (384, 1152), 2, 3, "5 pixels, (2,3) is 21,64,170");
    GRADIENT((256, 256), (256, 1280), (1280, 256), 1, 3, "6 pixels, (1,3) is 64,159,32");
    SHADED((384, 384), (1408, 384), (384, 1152), "5: (1,2) (2,2) (3,2) (1,3) (2,3)");
    COUNT_SHADED((-2048, -2048), (8192, -2048), (-2048, 8192), "45");
}
