/* Lesson 6's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step06_texture/main.c"
#endif
#include "numbers.h"

/* What is drawn on. */
enum { CALLED_SIDE = 8 };
static uint8_t called_bytes[3 * CALLED_SIDE * CALLED_SIDE];
static double called_depths[CALLED_SIDE * CALLED_SIDE];
static struct image called_sheet = {CALLED_SIDE, CALLED_SIDE, IMAGE_BGR, called_bytes};

/* A texture whose texel (x,y) is `texel(x, y)`. */
static struct texture called_made(int width, int height, struct color (*texel)(int x, int y)) {
    struct texture texture;
    struct error error;
    if (!paint(&texture, &(struct pattern){width, height, texel, false}, &error)) {
        exit(1);
    }
    return texture;
}

/* Red is the column and green the row, ten times both. */
static struct color called_numbered(int x, int y) {
    return rgb(10 * x, 10 * y, 250);
}

/* Red from the left is that of the text's drawing; green and alpha tell the row. */
static struct color called_drawing(int x, int y) {
    const int red[] = {0, 100, 200, 100};
    return (struct color){
        .r = (uint8_t)red[x], .g = (uint8_t)(100 * y), .b = 7, .a = (uint8_t)(255 - 200 * y)};
}

/* Only in the middle of the last column is 250 red, 150 green and 50 blue. */
enum { CALLED_COLUMNS = 200 };
static struct color called_framed(int x, int y) {
    return x == CALLED_COLUMNS - 1 && y % 3 > 0 ? rgb(250, 150, 50) : rgb(10, 20, 30);
}

/* Level 0 is of this colour, 0xAARRGGBB, and each level of the one before plus `more`. */
static struct texture called_levels(uint32_t color, uint32_t more) {
    struct texture texture = called_made(4, 4, called_numbered);
    for (size_t i = 0; i < texture.level_count; i++, color += more) {
        for (size_t k = 0; k < texture.level[i].pitch * texture.level[i].height; k++) {
            texture.level[i].texels[k] = color;
        }
    }
    return texture;
}

/* Lesson 3's example, whose corners lie on centres of pixels: at pixel (2,2) the weights are 5/12,
 * 3/12 and 4/12. Its place in the texture is this one; with other weights it is not 250 there. */
static const struct vec2 called_place = {0.9975, 0.45};
static struct canvas called_canvas;

static void called_begin(double depth) {
    called_canvas = (struct canvas){&called_sheet, called_depths, SAMPLE_TRILINEAR};
    memset(called_bytes, 0, sizeof called_bytes);
    for (int i = 0; i < CALLED_SIDE * CALLED_SIDE; i++) {
        called_depths[i] = depth;
    }
}

static void called_draw(const struct texture *texture, double intensity) {
    const struct vertex v[3] = {
        {{384, 384}, 0.6, {0, 3}},
        {{1408, 384}, 0, {3, 0}},
        {{384, 1152}, -0.3, {0.7425, -2.4}},
    };
    triangle(&called_canvas, v, texture, intensity);
}

/* Pixel (2,2) of it where that depth is before: its red. */
static struct shown called_drawn(const struct texture *texture, double intensity, double depth) {
    called_begin(depth);
    called_draw(texture, intensity);
    return show("%d", image_get(&called_sheet, 2, 2).r);
}

/* The red of this pixel as your sample_nearest() gives it, right or wrong. */
static struct shown called_own(const struct texture *texture, double intensity) {
    return show("%d", level_from(sample_nearest(texture, called_place).r * intensity));
}

/* Pixel (2,2) of two, the second one darker and as near. */
static struct shown called_drawn_twice(const struct texture *texture) {
    called_begin(-1);
    called_draw(texture, 1);
    called_draw(texture, 0.2);
    return show_color(image_get(&called_sheet, 2, 2));
}

/* The depths of 5 x 3 pixels under a triangle that is larger, whatever colour they have. */
static struct shown called_wide(const struct texture *texture) {
    const struct vertex v[3] = {{.position = {-384, -384}, .depth = -21},
                                {.position = {4736, -384}, .depth = -1},
                                {.position = {-384, 4736}, .depth = 179}};
    struct image wide = {5, 3, IMAGE_BGR, called_bytes};
    called_begin(-1);
    called_canvas.image = &wide;
    triangle(&called_canvas, v, texture, 1);
    return show("%.150s, behind %.5g", show_joined(called_depths, 15, " ").text, called_depths[15]);
}

/* ---- Perspective ---- */

/* A triangle of that width and height, each corner with that u, v and 1/w. Its depths are for
 * whoever takes them for 1/w: what follows from the corners can be told from nothing at all. */
static struct quotients called_begun(int width, int height, struct vec3 p, struct vec3 q,
                                     struct vec3 r) {
    const struct vertex v[3] = {
        {{128, 128}, 2, xy(p.x, p.y), p.z},
        {{128 + 256 * width, 128}, 3, xy(q.x, q.y), q.z},
        {{128, 128 + 256 * height}, 5, xy(r.x, r.y), r.z},
    };
    struct quotients plane = {0};
    plane_begin(&plane, &called_sheet, v);
    return plane;
}

static struct vec3 called_corner(int i) {
    return called_begun(4, 4, xyz(0, 3, 1), xyz(1, 3, 0.25), xyz(-3, 2, 0.5)).corner[i];
}

/* A triangle with a corner at pixel (0,0) that has these quotients there, and gains so much in a
 * step. */
static struct quotients called_plane(struct vec3 there, struct vec3 right, struct vec3 up) {
    struct quotients plane = {.right = right, .up = up};
    plane.corner[0] = there;
    plane.corner[1] = vec3_add(there, vec3_scale(right, 4));
    plane.corner[2] = vec3_add(there, vec3_scale(up, 4));
    edges_setup(&plane.edges, (struct fixed2){128, 128}, (struct fixed2){1152, 128},
                (struct fixed2){128, 1152}, CALLED_SIDE, CALLED_SIDE);
    return plane;
}

/* u, v and w in the middle between two corners, whose quotients are given. */
static struct vec3 called_middle(int x, int y) {
    const struct quotients plane =
        called_plane(xyz(0, 3, 1), xyz(0.0625, -0.5625, -0.1875), xyz(-0.375, -0.5, -0.125));
    double w = 0;
    struct vec2 uv = plane_uv(&plane, x, y, &w);
    return xyz(uv.x, uv.y, w);
}

/* A plane whose pixel (0,0) shows (1000.25, -600.5) at w = 2. In a texture of 4 x 4 texels the
 * steps are `right` texels to the right and `up` texels up, along both u and v. The picture begins
 * again there: a step from a repeated place is another one. */
static struct quotients called_steps(double right, double up) {
    const double gain = 1 / 4096.0, u = 1000.25, v = -600.5;
    return called_plane(xyz(u / 2, v / 2, 0.5),
                        xyz(right / 8 + u * gain, right / 8 + v * gain, gain),
                        xyz(up / 8 + u * gain, up / 8 + v * gain, gain));
}

static struct color called_color(const struct quotients *plane, const struct texture *texture) {
    called_begin(-1);
    return color_at(&called_canvas, plane, 0, 0, texture);
}

/* What color_at() should make of your own plane_uv(), mip_level() and sample_trilinear(). */
static struct color called_own_color(const struct quotients *plane, const struct texture *texture) {
    double w;
    struct vec2 uv = plane_uv(plane, 0, 0, &w);
    double level = mip_level(uv_step(plane->right, uv, w), uv_step(plane->up, uv, w), texture);
    struct vec4 c = sample_trilinear(texture, uv, level);
    return color_rgb(level_from(c.x), level_from(c.y), level_from(c.z));
}

/* ---- Mixed by what another task finds ---- */

static struct shown called_bilinear(const struct texture *texture, struct vec2 uv) {
    const struct vec4 c = sample_bilinear(texture, uv, 0);
    return show_reals((const double[]){c.x, c.y, c.z, c.w}, 4);
}

static struct shown called_trilinear(const struct texture *texture, double level) {
    return show("%.4g", sample_trilinear(texture, xy(0.5, 0.5), level).x);
}

/* The mixture of what your sample_bilinear() finds on two levels. */
static struct shown called_own_trilinear(const struct texture *texture, size_t finer,
                                         size_t coarser, double part) {
    const double a = sample_bilinear(texture, xy(0.5, 0.5), finer).x;
    return show("%.4g", a + part * (sample_bilinear(texture, xy(0.5, 0.5), coarser).x - a));
}

/* With a repeat() that does not leave this place alone, whatever comes is right. */
#define REPEATED(u, v, right)                                                                      \
    TEXT_WITH("6c.1", "sample_bilinear(repeated, (" #u ", " #v "), 0)",                            \
              called_bilinear(repeated, xy(u, v)), right,                                          \
              is_near(repeat(xy(u, v)).x, u) && is_near(repeat(xy(u, v)).y, v) ? show("") : yours)
#define TRILINEAR(level, finer, coarser, part, right)                                              \
    TEXT_WITH("6d.1", "sample_trilinear(texture, (0.5, 0.5), " #level ").x",                       \
              called_trilinear(texture, level), right,                                             \
              called_own_trilinear(texture, finer, coarser, part))
#define TEXTURED(intensity, depth, right)                                                          \
    TEXT_WITH("6a.2+6a.1", "triangle(), texel 250, intensity " #intensity ": pixel (2,2)",         \
              called_drawn(&framed, intensity, depth), right, called_own(&framed, intensity))
#define AT_LEVEL(name, right_step, up_step, right)                                                 \
    do {                                                                                           \
        const struct quotients plane = called_steps(right_step, up_step);                          \
        TEXT_WITH("6e.3+6b.3,6c.1,6d.1,6e.1,6e.2", "color_at() at " name,                          \
                  show_color(called_color(&plane, texture)), right,                                \
                  show_color(called_own_color(&plane, texture)));                                  \
    } while (0)

static bool called_near(struct vec3 yours, struct vec3 right) {
    return is_near(yours.x, right.x) && is_near(yours.y, right.y) && is_near(yours.z, right.z);
}

/* In the triangle of 4 x 2 pixels. It's right, too, where it follows from your corners. */
#define GAIN(step, other, pixels, wanted)                                                          \
    do {                                                                                           \
        const struct vec3 right_one = wanted;                                                      \
        if (number_begin("6e.1", "plane_begin(), 4 x 2 pixels: " #step,                            \
                         show_reals(&right_one.x, 3))) {                                           \
            const struct quotients plane =                                                         \
                called_begun(4, 2, xyz(0, 0, 1), xyz(1, 0, 1), xyz(0, 1, 1));                      \
            const struct vec3 of_corners =                                                         \
                vec3_scale(vec3_sub(plane.corner[other], plane.corner[0]), 1 / (pixels));          \
            const struct shown yours = show_reals(&plane.step.x, 3);                               \
            number_end(yours,                                                                      \
                       called_near(plane.step, right_one) ||                                       \
                           (called_near(plane.step, of_corners) && !says_nothing(yours.text)));    \
        }                                                                                          \
    } while (0)

static void numbers(void) {
    struct texture four = called_made(4, 3, called_numbered),
                   two = called_made(4, 2, called_drawing),
                   wide = called_made(16, 8, called_numbered);
    struct texture levels = called_levels(0xff282828, 0x646464),
                   colors = called_levels(0xff2800c8, 0x631300 - 0x61),
                   small = called_made(4, 2, called_drawing),
                   framed = called_made(CALLED_COLUMNS, 4, called_framed);
    struct texture drawn_again = two;
    texture_set_clamp(&four, true);
    texture_set_clamp(&two, true);
    const struct texture *texture = &four, *repeated = &drawn_again;
    COLOR("6a.1", sample_nearest(texture, xy(0.2, 0.4)), rgb(0, 10, 250));
    COLOR("6a.1", sample_nearest(texture, xy(0.75, 0.5)), rgb(30, 10, 250));
    COLOR("6a.1", sample_nearest(texture, xy(1, 1)), rgb(30, 20, 250));
    COLOR("6a.1", sample_nearest(texture, xy(-0.2, 1e12)), rgb(0, 20, 250));
    TEXTURED(0.5, -1, "125");
    TEXTURED(0.925, 0.1, "231");
    TEXT("6a.2", "triangle(), behind depth 0.2: pixel (2,2)", called_drawn(&framed, 1, 0.2), "0");
    TEXT_WITH("6a.2+6a.1", "triangle(), texel 250,150,50, and again, darker: pixel (2,2)",
              called_drawn_twice(&framed), "250,150,50",
              show_color(sample_nearest(&framed, called_place)));
    TEXT("6a.2", "triangle() over all of 5 x 3 pixels: their depths", called_wide(&framed),
         "1 2 3 4 5 11 12 13 14 15 21 22 23 24 25, behind -1");
    VECTOR("6b.1", vec2, repeat(xy(0.3, 1.3)), xy(0.3, 0.3));
    VECTOR("6b.1", vec2, repeat(xy(-0.7, -1)), xy(0.3, 0));
    VECTOR("6b.1", vec2, repeat(xy(2, -2.25)), xy(0, 0.75));
    AS_VECTOR("6b.2", "plane_begin(): c[1] of uv (1, 3), recip_w 0.25", vec3, called_corner(1),
              xyz(0.25, 0.75, 0.25));
    AS_VECTOR("6b.2", "plane_begin(): c[2] of uv (-3, 2), recip_w 0.5", vec3, called_corner(2),
              xyz(-1.5, 1, 0.5));
    AS_VECTOR("6b.3", "plane_uv(): u, v, w halfway from (0, 3, 1) to (0.25, 0.75, 0.25)", vec3,
              called_middle(2, 0), xyz(0.2, 3, 1.6));
    AS_VECTOR("6b.3", "plane_uv(): u, v, w halfway from (0, 3, 1) to (-1.5, 1, 0.5)", vec3,
              called_middle(0, 2), xyz(-1, 8 / 3.0, 4 / 3.0));
    texture = &two;
    VECTOR("6c.1", vec4, sample_bilinear(texture, xy(0.45, 0.5), 0), xyzw(130, 50, 7, 155));
    VECTOR("6c.1", vec4, sample_bilinear(texture, xy(0.451, 0.3), 0), xyzw(130.4, 10, 7, 235));
    VECTOR("6c.1", vec4, sample_bilinear(texture, xy(0, 0), 0), xyzw(0, 0, 7, 255));
    VECTOR("6c.1", vec4, sample_bilinear(texture, xy(0.5, 1.5), 0), xyzw(150, 100, 7, 55));
    VECTOR("6c.1", vec4, sample_bilinear(texture, xy(0.5, 0.5), 1), xyzw(100, 50, 7, 155));
    REPEATED(0.95, 0.5, "(70, 50, 7, 155)");
    REPEATED(0, 0, "(50, 50, 7, 155)");
    texture = &levels;
    TRILINEAR(0.25, 0, 1, 0.25, "65");
    TRILINEAR(1.5, 1, 2, 0.5, "190");
    TRILINEAR(-1, 0, 0, 0, "40");
    TRILINEAR(7, 2, 2, 0, "240");
    VECTOR("6e.1", vec2, uv_step(xyz(0.5, 0.25, -0.125), xy(2, -1), 2), xy(1.5, 0.25));
    VECTOR("6e.1", vec2, uv_step(xyz(1, 0, 0), xy(5, 5), 3), xy(3, 0));
    GAIN(right, 1, 4.0, xyz(0.25, 0, 0));
    GAIN(up, 2, 2.0, xyz(0, 0.5, 0));
    texture = &wide;
    REAL("6e.2", mip_level(xy(0.25, 0), xy(0, 0.25), texture), 2);
    TEXT("6e.2", "mip_level((0.34375, 0.125), (0, 0), texture) to one place",
         show("%.1f", mip_level(xy(0.34375, 0.125), xy(0, 0), texture)), "2.5");
    REAL("6e.2", mip_level(xy(0.25, 0), xy(0, 1), texture), 3);
    REAL("6e.2", mip_level(xy(0.01, 0), xy(0, 0.01), texture), 0);
    REAL("6e.2", mip_level(xy(0, 9), xy(1, 0), texture), 4);
    texture = &small;
    TEXT("6e.2", "mip_level((0, 9), (1, 0), texture of 4 x 2 texels)",
         show("%.5g", mip_level(xy(0, 9), xy(1, 0), texture)), "2");
    texture = &colors;
    AT_LEVEL("level 0.75, by the step up: from 40,0,200 to 139,19,103", 0.25, sqrt(1.5),
             "114,14,127");
    AT_LEVEL("level 0.75, by the step right: from 40,0,200 to 139,19,103", sqrt(1.5), 0.25,
             "114,14,127");
    AT_LEVEL("level 0, by both steps: 40,0,200", 0.25, 0.25, "40,0,200");
}
