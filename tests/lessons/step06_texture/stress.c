/* Lesson 6: its samplers are lent to textures.c; here triangles, mip levels and perspective. */
#define LESSON "../step06_texture/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <string.h>

struct color lesson06_nearest(const struct texture *texture, struct vec2 uv) {
    return sample_nearest(texture, uv);
}

struct vec4 lesson06_bilinear(const struct texture *texture, struct vec2 uv, size_t level) {
    return sample_bilinear(texture, uv, level);
}

struct vec4 lesson06_trilinear(const struct texture *texture, struct vec2 uv, double level) {
    return sample_trilinear(texture, uv, level);
}

enum { PIXELS = SCREEN_WIDTH * SCREEN_HEIGHT, SIDE = 8, TEXELS = SIDE * SIDE };

/* ---- Triangles with a texture ---- */

struct texture_case {
    struct layers layers;
    struct vec2 uv[LAYER_COUNT][3];
    double intensity[LAYER_COUNT];
    uint32_t texels[TEXELS];
    bool clamp;
};

static void make_textured(struct random *random, uint64_t index, void *made) {
    struct texture_case *c = made;
    make_layers(random, index, &c->layers);
    for (int i = 0; i < LAYER_COUNT; i++) {
        for (int k = 0; k < 3; k++) {
            c->uv[i][k].x = random_real(random, -0.3, 1.3);
            c->uv[i][k].y = random_real(random, -0.3, 1.3);
        }
        c->intensity[i] = random_real(random, 0, 1);
    }
    for (int i = 0; i < TEXELS; i++) {
        c->texels[i] = (uint32_t)random_bits(random);
    }
    c->clamp = index % 2 == 0;
}

static void draw_layers(const void *tried, struct image *image, double *depth) {
    const struct texture_case *c = tried;
    uint32_t texels[TEXELS];
    memcpy(texels, c->texels, sizeof texels);
    struct texture texture = texture_from(texels, SIDE, SIDE);
    texture.clamp = c->clamp;
    struct canvas canvas = {.image = image};
    canvas.depth = depth;
    for (int i = 0; i < LAYER_COUNT; i++) {
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = (struct vertex){c->layers.corner[i][k], c->layers.depth[i][k], c->uv[i][k],
                                   .recip_w = NAN};
        }
        triangle(&canvas, v, &texture, c->intensity[i]);
    }
}

static int texel_that_holds(long double coordinate, bool clamp) {
    long double place = floorl((clamp ? coordinate : coordinate - floorl(coordinate)) * SIDE);
    return place < 0 ? 0 : place >= SIDE ? SIDE - 1 : (int)place;
}

/* Is it the colour of the texel that holds the place? Near the border of two texels either is. */
static bool is_texel(const void *tried, int layer, int picture, int x, int y, struct color color) {
    const struct texture_case *c = tried;
    const struct vec2 *uv = c->uv[layer];
    const double us[3] = {uv[0].x, uv[1].x, uv[2].x}, vs[3] = {uv[0].y, uv[1].y, uv[2].y};
    long double u = layer_value(&c->layers, layer, us, x, y);
    long double v = layer_value(&c->layers, layer, vs, x, y);
    bool right = false;
    (void)picture;
    for (int i = 0; i < 4; i++) {
        int column = texel_that_holds(u + (i % 2 ? 1e-12L : -1e-12L), c->clamp);
        int row = texel_that_holds(v + (i / 2 ? 1e-12L : -1e-12L), c->clamp);
        struct color texel = color_from_texel(c->texels[row * SIDE + column]);
        struct real3 exact = {texel.r, texel.g, texel.b};
        right = right || color_is_right(color, real3_scale(exact, c->intensity[layer]));
    }
    return right;
}

static bool textured_is_right(const void *tried) {
    const struct texture_case *c = tried;
    const struct layered layered = {&c->layers, c, 1, draw_layers, is_texel};
    return layers_are_right(&layered);
}

/* ---- Mip levels ---- */

struct mip_case {
    struct vec2 right, up;
    size_t width, height, level_count;
};

static double any_step(struct random *random, uint64_t kind) {
    static const double special[] = {NAN, INFINITY, -INFINITY, 0, 1e-320, 1e200, -1e308};
    if (kind == 0 && random_bits(random) % 4 == 0) {
        return special[random_bits(random) % 7];
    }
    double size = ldexp(1, (int)random_between(random, -14, 14));
    return kind == 1 ? size : size * random_real(random, -1, 1);
}

static void make_mip(struct random *random, uint64_t index, void *made) {
    struct mip_case *c = made;
    c->right = (struct vec2){any_step(random, index % 4), any_step(random, index % 4)};
    c->up = (struct vec2){any_step(random, index % 4), any_step(random, index % 4)};
    if (index % 4 == 1) { /* a power of two in one direction, where the level is exact */
        c->right.y = c->up.x = 0;
        *(random_bits(random) % 2 ? &c->right.x : &c->up.y) = 0;
    }
    c->width = index % 4 == 1 ? 256 : (size_t)random_between(random, 1, 2048);
    c->height = index % 4 == 1 ? 64 : (size_t)random_between(random, 1, 2048);
    c->level_count = (size_t)random_between(random, 1, TEXTURE_LEVEL_LIMIT);
}

/* log2 of e * (1 + f) is taken as e + f, which is too small by at most 0.0861 where f is 0.44: half
 * of it for the square. */
static bool mip_is_right(const void *tried) {
    const struct mip_case *c = tried;
    struct texture texture = {.level_count = c->level_count,
                              .level = {{.width = c->width, .height = c->height}}};
    double got = mip_level(c->right, c->up, &texture);
    long double w = c->width, h = c->height, last = (long double)c->level_count - 1;
    long double across = hypotl(c->right.x * w, c->right.y * h);
    long double along = hypotl(c->up.x * w, c->up.y * h);
    if (isnan(c->right.x + c->right.y) || isnan(c->up.x + c->up.y)) { /* inf - inf too */
        return got >= 0 && (long double)got <= last; /* a colour must come of it, no more */
    }
    long double level = log2l(fmaxl(across, along));
    long double exact = level > 0 ? (level < last ? level : last) : 0;
    long double least = level > 0 ? (level - 0.0431L < last ? level - 0.0431L : last) : 0;
    bool power_of_two = level == floorl(level);
    return (long double)got <= exact + 1e-12L &&
           (long double)got >= (power_of_two ? exact : least) - 1e-12L;
}

/* ---- Triangles in perspective ---- */

struct perspective_case {
    struct fixed2 corner[3];
    struct vec2 uv[3];
    double recip_w[3];
    uint8_t texels[TEXELS][4];
};

static void make_perspective(struct random *random, uint64_t index, void *made) {
    struct perspective_case *c = made;
    (void)index;
    random_triangle(random, random_bits(random), c->corner);
    double reach = ldexp(1, (int)random_between(random, -4, 4));
    for (int i = 0; i < 3; i++) {
        c->uv[i] =
            (struct vec2){random_real(random, -reach, reach), random_real(random, -reach, reach)};
        c->recip_w[i] = ldexp(random_real(random, 1, 2), (int)random_between(random, -6, 3));
    }
    for (int i = 0; i < TEXELS; i++) {
        uint64_t bits = random_bits(random);
        memcpy(c->texels[i], &bits, sizeof c->texels[i]);
    }
}

/* What is linear in perspective at a pixel, and what it gains in a step to the right and in one up:
 * a = n / d, both linear on the screen, so that a' = (n' - a d') / d. */
struct gains {
    long double here, right, up;
};

static struct gains exact_gains(const struct perspective_case *c, const double a[3], int x, int y) {
    static const double one[3] = {1, 1, 1};
    const double *d = c->recip_w;
    const double n[3] = {a[0] * d[0], a[1] * d[1], a[2] * d[2]};
    long double here = oracle_interpolate(c->corner, d, a, x, y);
    long double below = oracle_interpolate(c->corner, one, d, x, y), gain[2];
    for (int i = 0; i < 2; i++) {
        int to_x = x + 1 - i, to_y = y + i;
        gain[i] = (oracle_interpolate(c->corner, one, n, to_x, to_y) - here * below -
                   here * (oracle_interpolate(c->corner, one, d, to_x, to_y) - below)) /
                  below;
    }
    return (struct gains){here, gain[0], gain[1]};
}

/* u, v and w at a pixel, and what they gain: they choose the mip level. A gain is the difference of
 * what may be far larger outside a small triangle. */
static bool place_is_right(const struct perspective_case *c, const struct quotients *plane, int x,
                           int y, struct vec2 *uv, double *level, const struct texture *texture) {
    const double us[3] = {c->uv[0].x, c->uv[1].x, c->uv[2].x};
    const double vs[3] = {c->uv[0].y, c->uv[1].y, c->uv[2].y};
    const double ws[3] = {1 / c->recip_w[0], 1 / c->recip_w[1], 1 / c->recip_w[2]};
    struct gains u = exact_gains(c, us, x, y), v = exact_gains(c, vs, x, y);
    long double slack = 1e-12L * 16; /* coordinates are up to 16 */
    long double gains = fabsl(u.right) + fabsl(u.up) + fabsl(v.right) + fabsl(v.up);
    long double gain_slack = (1e-12L * gains + slack) * 64 * SUBPIXELS * SUBPIXELS;
    double w;
    *uv = plane_uv(plane, x, y, &w);
    struct vec2 right = uv_step(plane->right, *uv, w), up = uv_step(plane->up, *uv, w);
    *level = mip_level(right, up, texture);
    return is_near(w, oracle_interpolate(c->corner, c->recip_w, ws, x, y), 1e-9L) &&
           is_near(uv->x, u.here, slack) && is_near(uv->y, v.here, slack) &&
           is_near(right.x, u.right, gain_slack) && is_near(right.y, v.right, gain_slack) &&
           is_near(up.x, u.up, gain_slack) && is_near(up.y, v.up, gain_slack);
}

/* A sample of two levels, also where main.c reads only one, because the other counts for nothing:
 * the colour is the same to the last bit. */
static bool sample_is_right(const struct perspective_case *c, const struct quotients *plane, int x,
                            int y, struct color color, const struct texture *texture) {
    struct vec2 uv;
    double level;
    bool right = place_is_right(c, plane, x, y, &uv, &level, texture);
    struct vec4 sample = sample_trilinear(texture, uv, level);
    return right && color.r == level_from(sample.x) && color.g == level_from(sample.y) &&
           color.b == level_from(sample.z);
}

static bool perspective_picture_is_right(const struct perspective_case *c,
                                         const struct vertex vertices[3],
                                         const struct texture *texture) {
    uint8_t pixels[3 * PIXELS] = {0};
    struct image image = {SCREEN_WIDTH, SCREEN_HEIGHT, IMAGE_BGR, pixels};
    const struct canvas canvas = {.image = &image, .sampler = SAMPLE_TRILINEAR};
    struct quotients plane;
    perspective_triangle(&canvas, vertices, texture);
    bool drawn = plane_begin(&plane, &image, vertices), right = true;
    for (int i = 0; i < PIXELS && right; i++) {
        int x = i % SCREEN_WIDTH, y = i / SCREEN_WIDTH;
        struct color color = image_get(&image, x, y);
        right = oracle_covers(c->corner[0], c->corner[1], c->corner[2], x, y)
                    ? drawn && sample_is_right(c, &plane, x, y, color, texture)
                    : (color.r | color.g | color.b) == 0;
    }
    return right;
}

static bool perspective_is_right(const void *tried) {
    const struct perspective_case *c = tried;
    uint8_t texels[sizeof c->texels];
    struct image picture = {SIDE, SIDE, IMAGE_BGRA, texels};
    struct texture texture;
    struct error error;
    struct vertex vertices[3];
    memcpy(texels, c->texels, sizeof texels);
    for (int i = 0; i < 3; i++) {
        vertices[i] = (struct vertex){c->corner[i], NAN, c->uv[i], c->recip_w[i]};
    }
    if (!texture_create(&texture, &picture, &error)) {
        return false;
    }
    bool right = perspective_picture_is_right(c, vertices, &texture);
    texture_free(&texture);
    return right;
}

const struct property lesson06_properties[] = {
    PROPERTY("lesson06: texture, nearest triangle", AGAINST_LONG_DOUBLE, 100000,
             struct texture_case, make_textured, .holds = textured_is_right),
    PROPERTY("lesson06: mip level", AGAINST_LONG_DOUBLE, 300000, struct mip_case, make_mip,
             .holds = mip_is_right),
    PROPERTY("lesson06: perspective", AGAINST_LONG_DOUBLE, 100000, struct perspective_case,
             make_perspective, .holds = perspective_is_right),
    {.name = NULL},
};
