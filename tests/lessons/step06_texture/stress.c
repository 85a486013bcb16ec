/* Step 6: its samplers are lent to textures.c; here triangles, mip levels and perspective. */
#define LESSON "../step06_texture/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <stdio.h>
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
}

static int texel_that_holds(long double coordinate) {
    long double place = floorl(coordinate * SIDE);
    return place < 0 ? 0 : place >= SIDE ? SIDE - 1 : (int)place;
}

/* Is it the colour of the texel that holds the place? Near the border of two texels either is. */
static bool is_texel_at(const struct texture_case *c, struct color color, long double u,
                        long double v, double intensity) {
    for (int i = 0; i < 4; i++) {
        int x = texel_that_holds(u + (i % 2 ? 1e-12L : -1e-12L));
        int y = texel_that_holds(v + (i / 2 ? 1e-12L : -1e-12L));
        uint32_t texel = c->texels[y * SIDE + x];
        struct real3 exact = {texel >> 16 & 255, texel >> 8 & 255, texel & 255};
        if (color_is_right(color, real3_scale(exact, intensity))) {
            return true;
        }
    }
    return false;
}

static bool may_have_color(const struct texture_case *c, int layer, int x, int y,
                           struct color color) {
    const struct vec2 *uv = c->uv[layer];
    const double us[3] = {uv[0].x, uv[1].x, uv[2].x}, vs[3] = {uv[0].y, uv[1].y, uv[2].y};
    return layer_may_show(&c->layers, layer, x, y) &&
           is_texel_at(c, color, layer_value(&c->layers, layer, us, x, y),
                       layer_value(&c->layers, layer, vs, x, y), c->intensity[layer]);
}

/* Draw all; returns the work done (its depths are gone). */
static struct canvas draw_layers(const struct texture_case *c, bool skip, struct image *image) {
    double depth[PIXELS];
    uint32_t texels[TEXELS];
    memcpy(texels, c->texels, sizeof texels);
    struct texture texture = texture_from(texels, SIDE, SIDE);
    struct canvas canvas = {.image = image, .depth = depth, .skip = skip};
    depth_clear(depth, PIXELS);
    for (int i = 0; i < LAYER_COUNT; i++) {
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = (struct vertex){c->layers.corner[i][k], c->layers.depth[i][k], c->uv[i][k],
                                   .recip_w = NAN};
        }
        triangle(&canvas, v, &texture, c->intensity[i]);
    }
    return canvas;
}

static bool textured_is_right(const void *tried) {
    const struct texture_case *c = tried;
    uint8_t pixels[3 * PIXELS] = {0}, all_pixels[3 * PIXELS] = {0};
    struct image image = {SCREEN_WIDTH, SCREEN_HEIGHT, IMAGE_BGR, pixels};
    struct image all_image = {SCREEN_WIDTH, SCREEN_HEIGHT, IMAGE_BGR, all_pixels};
    struct canvas canvas = draw_layers(c, true, &image), all = draw_layers(c, false, &all_image);
    uint64_t covered = layers_pixel_count(&c->layers);
    if (memcmp(pixels, all_pixels, sizeof pixels) != 0 || all.texels_fetched != covered ||
        all.pixels_tested != covered || canvas.pixels_tested != covered ||
        canvas.texels_fetched != canvas.pixels_written) {
        return false;
    }
    for (int i = 0; i < PIXELS; i++) {
        struct color color = color_rgb(pixels[3 * i + 2], pixels[3 * i + 1], pixels[3 * i]);
        bool right = false, empty = true;
        for (int k = 0; k < LAYER_COUNT; k++) {
            int x = i % SCREEN_WIDTH, y = i / SCREEN_WIDTH;
            empty = empty && !layer_may_show(&c->layers, k, x, y);
            right = right || may_have_color(c, k, x, y, color);
        }
        if (empty ? (color.r | color.g | color.b) != 0 : !right) {
            return false;
        }
    }
    return true;
}

static void print_textured(const void *failing) {
    const struct texture_case *c = failing;
    print_layers(&c->layers);
    for (int i = 0; i < LAYER_COUNT; i++) {
        printf("    uv (%.17g %.17g) (%.17g %.17g) (%.17g %.17g), intensity %.17g\n", c->uv[i][0].x,
               c->uv[i][0].y, c->uv[i][1].x, c->uv[i][1].y, c->uv[i][2].x, c->uv[i][2].y,
               c->intensity[i]);
    }
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

static void print_mip(const void *failing) {
    const struct mip_case *c = failing;
    printf("    right %.17g %.17g, up %.17g %.17g, of %zux%zu texels, %zu levels\n", c->right.x,
           c->right.y, c->up.x, c->up.y, c->width, c->height, c->level_count);
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
    (void)index;
}

/* A value that is linear in perspective, at a pixel. */
static long double in_perspective(const struct perspective_case *c, const double value[3], int x,
                                  int y) {
    return oracle_interpolate(c->corner, c->recip_w, value, x, y);
}

/* What u gains in a step to the right and in one up: u = n / d, both linear on the screen, so that
 * u' = (n' - u d') / d. */
static void exact_gains(const struct perspective_case *c, const double u[3], int x, int y,
                        long double *right, long double *up) {
    static const double one[3] = {1, 1, 1};
    double n[3];
    for (int i = 0; i < 3; i++) {
        n[i] = u[i] * c->recip_w[i];
    }
    long double d = oracle_interpolate(c->corner, one, c->recip_w, x, y);
    long double here = in_perspective(c, u, x, y), n_here = here * d;
    *right = (oracle_interpolate(c->corner, one, n, x + 1, y) - n_here -
              here * (oracle_interpolate(c->corner, one, c->recip_w, x + 1, y) - d)) /
             d;
    *up = (oracle_interpolate(c->corner, one, n, x, y + 1) - n_here -
           here * (oracle_interpolate(c->corner, one, c->recip_w, x, y + 1) - d)) /
          d;
}

/* The largest coordinate. */
static double reach_of(const struct perspective_case *c) {
    double reach = 0;
    for (int i = 0; i < 3; i++) {
        reach = fmax(reach, fmax(fabs(c->uv[i].x), fabs(c->uv[i].y)));
    }
    return reach;
}

static bool is_near(double got, long double exact, double scale) {
    return fabsl(exact - (long double)got) <= 1e-12L * (long double)scale;
}

/* u, v and w at a pixel, and what they gain: they choose the mip level. */
static bool place_is_right(const struct perspective_case *c, const struct quotients *plane, int x,
                           int y, struct vec2 *uv, double *level, const struct texture *texture) {
    const double u[3] = {c->uv[0].x, c->uv[1].x, c->uv[2].x};
    const double v[3] = {c->uv[0].y, c->uv[1].y, c->uv[2].y};
    const double w[3] = {1 / c->recip_w[0], 1 / c->recip_w[1], 1 / c->recip_w[2]};
    double reach = reach_of(c), got_w;
    *uv = plane_uv(plane, x, y, &got_w);
    struct vec2 right = uv_step(plane->right, *uv, got_w), up = uv_step(plane->up, *uv, got_w);
    long double u_right, u_up, v_right, v_up;
    exact_gains(c, u, x, y, &u_right, &u_up);
    exact_gains(c, v, x, y, &v_right, &v_up);
    double gain = (double)(fabsl(u_right) + fabsl(u_up) + fabsl(v_right) + fabsl(v_up)) + reach;
    /* A gain is the difference of what may be far larger outside a small triangle. */
    double size = gain * 64 * SUBPIXELS * SUBPIXELS;
    *level = mip_level(right, up, texture);
    return is_near(got_w, in_perspective(c, w, x, y), 1024) &&
           is_near(uv->x, in_perspective(c, u, x, y), reach) &&
           is_near(uv->y, in_perspective(c, v, x, y), reach) && is_near(right.x, u_right, size) &&
           is_near(up.x, u_up, size) && is_near(right.y, v_right, size) &&
           is_near(up.y, v_up, size);
}

static bool perspective_is_right(const void *tried) {
    const struct perspective_case *c = tried;
    uint8_t texels[sizeof c->texels], pixels[3 * PIXELS] = {0}, all_pixels[3 * PIXELS] = {0};
    struct image picture = {SIDE, SIDE, IMAGE_BGRA, texels};
    struct image image = {SCREEN_WIDTH, SCREEN_HEIGHT, IMAGE_BGR, pixels}, all_image = image;
    struct texture texture;
    struct error error;
    struct vertex vertices[3];
    all_image.pixels = all_pixels;
    memcpy(texels, c->texels, sizeof texels);
    for (int i = 0; i < 3; i++) {
        vertices[i] = (struct vertex){c->corner[i], NAN, c->uv[i], c->recip_w[i]};
    }
    if (!texture_create(&texture, &picture, &error)) {
        return false;
    }
    struct canvas canvas = {.image = &image, .sampler = SAMPLE_TRILINEAR, .skip = true};
    struct canvas all = {.image = &all_image, .sampler = SAMPLE_TRILINEAR};
    perspective_triangle(&canvas, vertices, &texture);
    perspective_triangle(&all, vertices, &texture);
    struct quotients plane;
    bool drawn = plane_begin(&plane, &image, vertices), right = true;
    uint64_t fetched = 0;
    for (int i = 0; i < PIXELS && right; i++) {
        int x = i % SCREEN_WIDTH, y = i / SCREEN_WIDTH;
        struct color color = image_get(&image, x, y);
        if (!oracle_covers(c->corner[0], c->corner[1], c->corner[2], x, y)) {
            right = color.r == 0 && color.g == 0 && color.b == 0;
            continue;
        }
        struct vec2 uv = {0, 0};
        double level = 0;
        right = drawn && place_is_right(c, &plane, x, y, &uv, &level, &texture);
        struct vec2 part = {uv.x - floor(uv.x), uv.y - floor(uv.y)};
        struct vec4 sample = sample_trilinear(&texture, part, level);
        fetched += level > 0 ? 8 : 4;
        right = right && color_is_right(color, (struct real3){sample.x, sample.y, sample.z});
    }
    texture_free(&texture);
    return right && memcmp(pixels, all_pixels, sizeof pixels) == 0 &&
           all.texels_fetched == 8 * all.pixels_written &&
           canvas.pixels_written == all.pixels_written && canvas.texels_fetched == fetched;
}

static void print_perspective(const void *failing) {
    const struct perspective_case *c = failing;
    for (int i = 0; i < 3; i++) {
        printf("    corner (%d %d)/256, uv %.17g %.17g, 1/w %.17g\n", (int)c->corner[i].x,
               (int)c->corner[i].y, c->uv[i].x, c->uv[i].y, c->recip_w[i]);
    }
}

static const struct case_kind textured_cases = {sizeof(struct texture_case), make_textured,
                                                print_textured, NULL};
static const struct case_kind mip_cases = {sizeof(struct mip_case), make_mip, print_mip, NULL};
static const struct case_kind perspective_cases = {sizeof(struct perspective_case),
                                                   make_perspective, print_perspective, NULL};

const struct property lesson06_properties[] = {
    PROPERTY("lesson06: texture, nearest triangle", AGAINST_LONG_DOUBLE, 100000, textured_cases,
             .holds = textured_is_right),
    PROPERTY("lesson06: mip level", AGAINST_LONG_DOUBLE, 300000, mip_cases, .holds = mip_is_right),
    PROPERTY("lesson06: perspective", AGAINST_LONG_DOUBLE, 100000, perspective_cases,
             .holds = perspective_is_right),
    {.name = NULL},
};
