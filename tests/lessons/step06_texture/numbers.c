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
    if (!paint_picture(&texture, width, height, texel, &error)) {
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

/* 250 is in the middle of 4 x 4 texels, so that it does not matter how a texture is turned. */
static struct color called_framed(int x, int y) {
    return color_grey(x % 3 > 0 && y % 3 > 0 ? 250 : 10);
}

/* Levels 0, 1 and 2 are grey 0, 100 and 200. */
static struct texture called_greys(void) {
    struct texture texture = called_made(4, 4, called_framed);
    for (uint32_t i = 0; i < texture.level_count; i++) {
        for (size_t k = 0; k < texture.level[i].pitch * texture.level[i].height; k++) {
            texture.level[i].texels[k] = 0xff000000 | 0x646464 * i;
        }
    }
    return texture;
}

/* Lesson 3's example, whose corners lie on centres of pixels: at pixel (2,2) the weights are 5/12,
 * 3/12 and 4/12. Its place in the texture is (0.45, 0.45); with other weights it is not `inner`. */
static int called_drawn(const struct texture *texture, double intensity, double depth) {
    const struct vertex v[3] = {
        {{384, 384}, 0.6, {0, 3}},
        {{1408, 384}, 0, {3, 0}},
        {{384, 1152}, -0.3, {-0.9, -2.4}},
    };
    struct canvas canvas = {.image = &called_sheet, .depth = called_depths, .skip = true};
    memset(called_bytes, 0, sizeof called_bytes);
    for (int i = 0; i < CALLED_SIDE * CALLED_SIDE; i++) {
        called_depths[i] = depth;
    }
    triangle(&canvas, v, texture, intensity);
    return image_get(&called_sheet, 2, 2).r;
}

/* ---- Perspective ---- */

/* A triangle of that width and height, each corner with that u, v and 1/w. */
static struct quotients called_begun(int width, int height, struct vec3 p, struct vec3 q,
                                     struct vec3 r) {
    const struct vertex v[3] = {
        {{128, 128}, 0, xy(p.x, p.y), p.z},
        {{128 + 256 * width, 128}, 0, xy(q.x, q.y), q.z},
        {{128, 128 + 256 * height}, 0, xy(r.x, r.y), r.z},
    };
    struct quotients plane = {0};
    plane_begin(&plane, &called_sheet, v);
    return plane;
}

static struct vec3 called_corner(int i) {
    return called_begun(4, 4, xyz(0, 3, 1), xyz(1, 3, 0.25), xyz(-3, 2, 0.5)).corner[i];
}

/* u, v and w in the middle between two corners, whose quotients are given. */
static struct vec3 called_middle(int x, int y) {
    struct quotients plane = {
        .corner = {{0, 3, 1}, {0.25, 0.75, 0.25}, {-1.5, 1, 0.5}},
    };
    double w = 0;
    edges_setup(&plane.edges, (struct fixed2){128, 128}, (struct fixed2){1152, 128},
                (struct fixed2){128, 1152}, CALLED_SIDE, CALLED_SIDE);
    struct vec2 uv = plane_uv(&plane, x, y, &w);
    return xyz(uv.x, uv.y, w);
}

static void numbers(void) {
    struct texture four = called_made(4, 3, called_numbered),
                   two = called_made(4, 2, called_drawing),
                   wide = called_made(16, 8, called_numbered);
    struct texture levels = called_greys(), inner = called_made(4, 4, called_framed);
    struct texture drawn_again = two;
    texture_set_clamp(&four, true);
    texture_set_clamp(&two, true);
    const struct texture *texture = &four, *repeated = &drawn_again;
    COLOR("6a.1", sample_nearest(texture, xy(0.2, 0.4)), rgb(0, 10, 250));
    COLOR("6a.1", sample_nearest(texture, xy(0.75, 0.5)), rgb(30, 10, 250));
    COLOR("6a.1", sample_nearest(texture, xy(1, 1)), rgb(30, 20, 250));
    COLOR("6a.1", sample_nearest(texture, xy(-0.2, 1e12)), rgb(0, 20, 250));
    AS_WHOLE("6a.2", "triangle(), texel 250, intensity 0.5: pixel (2,2)",
             called_drawn(&inner, 0.5, -1), 125);
    AS_WHOLE("6a.2", "triangle(), texel 250, intensity 0.925: pixel (2,2)",
             called_drawn(&inner, 0.925, 0.1), 231);
    AS_WHOLE("6a.2", "triangle(), behind depth 0.2: pixel (2,2)", called_drawn(&inner, 1, 0.2), 0);
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
    VECTOR("6c.1", vec4, sample_bilinear(texture, xy(0, 0), 0), xyzw(0, 0, 7, 255));
    VECTOR("6c.1", vec4, sample_bilinear(texture, xy(0.5, 1.5), 0), xyzw(150, 100, 7, 55));
    VECTOR("6c.1", vec4, sample_bilinear(texture, xy(0.5, 0.5), 1), xyzw(100, 50, 7, 155));
    VECTOR("6c.1", vec4, sample_bilinear(repeated, xy(0.95, 0.5), 0), xyzw(70, 50, 7, 155));
    VECTOR("6c.1", vec4, sample_bilinear(repeated, xy(0, 0), 0), xyzw(50, 50, 7, 155));
    texture = &levels;
    REAL("6d.1", sample_trilinear(texture, xy(0.5, 0.5), 0.25).x, 25);
    REAL("6d.1", sample_trilinear(texture, xy(0.5, 0.5), 1.5).x, 150);
    REAL("6d.1", sample_trilinear(texture, xy(0.5, 0.5), -1).x, 0);
    REAL("6d.1", sample_trilinear(texture, xy(0.5, 0.5), 7).x, 200);
    VECTOR("6e.1", vec2, uv_step(xyz(0.5, 0.25, -0.125), xy(2, -1), 2), xy(1.5, 0.25));
    VECTOR("6e.1", vec2, uv_step(xyz(1, 0, 0), xy(5, 5), 3), xy(3, 0));
    AS_VECTOR("6e.1", "plane_begin(), 4 x 2 pixels: right", vec3,
              called_begun(4, 2, xyz(0, 0, 1), xyz(1, 0, 1), xyz(0, 1, 1)).right, xyz(0.25, 0, 0));
    AS_VECTOR("6e.1", "plane_begin(), 4 x 2 pixels: up", vec3,
              called_begun(4, 2, xyz(0, 0, 1), xyz(1, 0, 1), xyz(0, 1, 1)).up, xyz(0, 0.5, 0));
    texture = &wide;
    REAL("6e.2", mip_level(xy(0.25, 0), xy(0, 0.25), texture), 2);
    TEXT("6e.2", "mip_level((0.34375, 0.125), (0, 0), texture) to one place",
         show("%.1f", mip_level(xy(0.34375, 0.125), xy(0, 0), texture)), "2.5");
    REAL("6e.2", mip_level(xy(0.25, 0), xy(0, 1), texture), 3);
    REAL("6e.2", mip_level(xy(0.01, 0), xy(0, 0.01), texture), 0);
    REAL("6e.2", mip_level(xy(0, 9), xy(1, 0), texture), 4);
}
