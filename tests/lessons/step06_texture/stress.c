/* Step 6: its samplers are lent to textures.c; its triangles to triangles.c; here mip levels. */
#define LESSON "../step06_texture/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <stdio.h>

struct color lesson06_nearest(const struct texture *texture, struct vec2 uv) {
    return sample_nearest(texture, uv);
}

struct vec4 lesson06_bilinear(const struct texture *texture, struct vec2 uv, size_t level) {
    return sample_bilinear(texture, uv, level);
}

struct vec4 lesson06_trilinear(const struct texture *texture, struct vec2 uv, double level) {
    return sample_trilinear(texture, uv, level);
}

uint64_t lesson06_triangle(const struct depth_image *on, const struct fixed2 corner[3],
                           const double depth[3], uint8_t level) {
    uint32_t texel = level * 0x010101U;
    const struct texture texture = {
        .level_count = 1,
        .level = {{.width = 1, .height = 1, .pitch = 1, .texels = &texel}},
        .texels = &texel,
    };
    struct canvas canvas = {.image = on->image, .depth = on->depth, .skip = on->skip};
    struct vertex v[3];
    for (int i = 0; i < 3; i++) {
        v[i] = (struct vertex){.position = corner[i], .depth = depth[i]};
    }
    triangle(&canvas, v, &texture, 1);
    return canvas.pixels_tested;
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

/* ---- Texels ---- */

struct magnified_case {
    struct fixed2 corner[3];
};

static void make_magnified(struct random *random, uint64_t index, void *made) {
    random_triangle(random, index, ((struct magnified_case *)made)->corner);
}

/* One place of the texture fills the triangle, at mip level 0: no second level need be read. */
static bool one_level_is_read(const void *tried) {
    const struct fixed2 *corner = ((const struct magnified_case *)tried)->corner;
    uint8_t texels[4] = {10, 20, 30, 255}, pixels[3 * SCREEN_WIDTH * SCREEN_HEIGHT];
    struct image picture = {1, 1, IMAGE_BGRA, texels};
    struct image image = {SCREEN_WIDTH, SCREEN_HEIGHT, IMAGE_BGR, pixels};
    struct texture texture;
    struct error error;
    struct vertex v[3];
    for (int i = 0; i < 3; i++) {
        v[i] = (struct vertex){.position = corner[i], .uv = {0.3, 0.4}, .recip_w = 1};
    }
    if (!texture_create(&texture, &picture, &error)) {
        return false;
    }
    struct canvas canvas = {.image = &image, .sampler = SAMPLE_TRILINEAR, .skip = true};
    struct canvas all = {.image = &image, .sampler = SAMPLE_TRILINEAR};
    perspective_triangle(&canvas, v, &texture);
    perspective_triangle(&all, v, &texture);
    texture_free(&texture);
    return canvas.texels_fetched == 4 * canvas.pixels_written &&
           all.texels_fetched == 8 * canvas.pixels_written;
}

static void print_magnified(const void *failing) {
    const struct fixed2 *c = ((const struct magnified_case *)failing)->corner;
    for (int i = 0; i < 3; i++) {
        printf("    corner (%d %d)/256\n", (int)c[i].x, (int)c[i].y);
    }
}

static const struct case_kind mip_cases = {sizeof(struct mip_case), make_mip, print_mip};
static const struct case_kind magnified_cases = {sizeof(struct magnified_case), make_magnified,
                                                 print_magnified};

const struct property lesson06_properties[] = {
    PROPERTY("lesson06: mip level", AGAINST_LONG_DOUBLE, 300000, mip_cases, .holds = mip_is_right),
    PROPERTY("lesson06: texels read", AGAINST_BOUNDS, 100000, magnified_cases,
             .holds = one_level_is_read),
    {.name = NULL},
};
