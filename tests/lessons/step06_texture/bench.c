/*
 * Lesson 6: samplers, and texture coordinates in perspective.
 *
 * Samplers are held against the mean of many samples a pixel of what the texture is a picture of: a
 * hill of colours, given by a formula, or the tiles of scene checker, hit by rays. No triangle and
 * no texture takes part in it. Ways to find the coordinates are held against the same texels, found
 * in long double: there a sampler's own error does not count.
 */
#include "bench/bench.h"
#include "texture.h"

struct neighbours;
struct quotients;
struct vertex;
INLINED struct color sample_nearest(const struct texture *texture, struct vec2 uv);
INLINED struct vec4 mix_in_row(const struct texture_level *level, size_t row, struct neighbours x);
INLINED struct vec4 sample_bilinear(const struct texture *texture, struct vec2 uv, size_t number);
INLINED struct vec4 sample_trilinear(const struct texture *texture, struct vec2 uv, double level);
INLINED double mip_level(struct vec2 right, struct vec2 up, const struct texture *texture);
INLINED struct vec2 plane_uv(const struct quotients *plane, int x, int y, double *w);
typedef struct color attempt_sampler(const struct texture *texture, struct vec2 uv);
INLINED void attempt_perspective(struct image *image, const struct vertex *v,
                                 const struct texture *texture, attempt_sampler *sampler);

#define LESSON "../step06_texture/main.c"
#include "lesson.h"

#include "../../../step06_texture/attempts.h"
#include "oracle/oracle.h"

enum { HILL_SIDE = 512, HILL_TEXELS = 16, HILL_SAMPLES = 16 }; /* 16 * 16 samples a pixel */
enum { FAR_SIDE = 400, FAR_RAYS = 32, TILES_SIDE = 800 };

/* A picture to draw, and its exact colours. */
struct target {
    struct image image;
    struct vertex corners[4];
    struct texture texture;
    struct vec3 *exact; /* red, green, blue of each pixel; red is negative where there is none */
    size_t pixels;      /* that are drawn */
};

enum { HILL, FAR, TILES, TARGETS };

static struct target targets[TARGETS];

/* ---- Triangles ---- */

/* The other versions of perspective show the nearest texel: a cheap sampler hides no time. */
static inline void set_nearest(struct image *image, int x, int y, const struct texture *texture,
                               struct vec2 uv) {
    image_set(image, x, y, sample_nearest(texture, uv));
}

static inline struct vec2 divided(struct vec3 over_w) {
    return vec2_scale((struct vec2){over_w.x, over_w.y}, 1 / over_w.z);
}

/* u/w, v/w and 1/w so many pixels after the first of a row. */
static inline struct vec3 stepped(struct vec3 first, const struct quotients *plane, int pixels) {
    return vec3_add(first, vec3_scale(plane->right, pixels));
}

static struct vec3 first_of_row(const struct quotients *plane, int x, int y) {
    const struct vec3 *c = plane->corner;
    return vec3_interpolate(edges_weights(&plane->edges, x, y), c[0], c[1], c[2]);
}

/* A row with a division at every pixel, and u/w, v/w and 1/w stepped from its first pixel. */
static void draw_row(struct image *image, const struct quotients *plane, struct span span, int y,
                     const struct texture *texture) {
    const struct vec3 first = first_of_row(plane, span.begin, y);
    for (int x = span.begin; x < span.end; x++) {
        set_nearest(image, x, y, texture, divided(stepped(first, plane, x - span.begin)));
    }
}

/* A row with a division at every `step`-th pixel, and u and v linear between. */
INLINED void draw_row_every(struct image *image, const struct quotients *plane, struct span span,
                            int y, const struct texture *texture, int step) {
    const struct vec3 first = first_of_row(plane, span.begin, y);
    struct vec2 begin = divided(first);
    for (int x = span.begin; x < span.end; x += step) {
        /* The last piece ends at the last pixel: beyond the edge 1/w may reach 0. */
        int left = span.end - 1 - x, length = left < step ? left : step;
        struct vec2 end = divided(stepped(first, plane, x + length - span.begin));
        double share = length == step ? 1.0 / step : length > 0 ? 1.0 / length : 0;
        struct vec2 gain = vec2_scale((struct vec2){end.x - begin.x, end.y - begin.y}, share);
        for (int i = 0; i < (left < step ? left + 1 : step); i++) {
            set_nearest(image, x + i, y, texture, vec2_add(begin, vec2_scale(gain, i)));
        }
        begin = end;
    }
}

/* `step` 1 is a division at every pixel. */
INLINED void draw_every(struct image *image, const struct vertex v[3],
                        const struct texture *texture, int step) {
    struct quotients plane;
    if (!plane_begin(&plane, image, v)) {
        return;
    }
    for (int y = plane.edges.y_begin; y < plane.edges.y_end; y++) {
        struct span span = edges_span(&plane.edges, y);
        if (span.begin < span.end && step == 1) {
            draw_row(image, &plane, span, y, texture);
        } else if (span.begin < span.end) {
            draw_row_every(image, &plane, span, y, texture, step);
        }
    }
}

/* No perspective: as if all corners were equally far, and then w is 1 everywhere. */
static void draw_affine(struct image *image, const struct vertex v[3],
                        const struct texture *texture) {
    struct vertex same[3] = {v[0], v[1], v[2]};
    same[0].recip_w = same[1].recip_w = same[2].recip_w = 1;
    struct quotients plane;
    if (!plane_begin(&plane, image, same)) {
        return;
    }
    for (int y = plane.edges.y_begin; y < plane.edges.y_end; y++) {
        struct span span = edges_span(&plane.edges, y);
        const struct vec3 first = first_of_row(&plane, span.begin, y);
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 uv = stepped(first, &plane, x - span.begin);
            set_nearest(image, x, y, texture, (struct vec2){uv.x, uv.y});
        }
    }
}

#define DRAW_EVERY(name, step)                                                                     \
    static void name(struct image *image, const struct vertex v[3],                                \
                     const struct texture *texture) {                                              \
        draw_every(image, v, texture, step);                                                       \
    }
DRAW_EVERY(draw_every_1, 1)
DRAW_EVERY(draw_every_8, 8)
DRAW_EVERY(draw_every_16, 16)

enum {
    ROUNDING,
    NEAREST,
    HALF_OFF,
    BILINEAR,
    HOUSE,
    EVERY_1,
    EVERY_8,
    EVERY_16,
    AFFINE,
};

static attempt_function *const draws[] = {
    [ROUNDING] = attempt_1_rounded,   [NEAREST] = attempt_2_nearest,
    [HALF_OFF] = attempt_3_unshifted, [BILINEAR] = attempt_4_no_levels,
    [HOUSE] = attempt_6_levels,       [EVERY_1] = draw_every_1,
    [EVERY_8] = draw_every_8,         [EVERY_16] = draw_every_16,
    [AFFINE] = draw_affine,
};

static void draw_target(struct target *target, int way) {
    attempt_quad(&target->image, target->corners, &target->texture, draws[way]);
}

/* Root of the mean squared error of the three channels of what was drawn last. */
static double target_error(const struct target *target) {
    double sum = 0, pixels = 0;
    for (size_t i = 0; i < target->image.width * target->image.height; i++) {
        const uint8_t *p = target->image.pixels + 3 * i;
        if (target->exact[i].x >= 0) {
            struct vec3 error = vec3_sub((struct vec3){p[2], p[1], p[0]}, target->exact[i]);
            sum += vec3_dot(error, error) / 3;
            pixels++;
        }
    }
    return sqrt(sum / pixels);
}

/* ---- The hill: smooth, so that its texels are much larger than what is to be seen ---- */

static struct vec3 hill_color(double u, double v) {
    double hill = 16 * u * (1 - u) * v * (1 - v);
    return (struct vec3){255 * hill, 255 * u, 255 * v * v};
}

/* The mean colour of one cell, when the hill is cut into side x side cells: 256 samples. */
static struct vec3 hill_mean(size_t column, size_t row, size_t side) {
    struct vec3 sum = {0, 0, 0};
    for (int i = 0; i < HILL_SAMPLES * HILL_SAMPLES; i++) {
        int across = i % HILL_SAMPLES, up = i / HILL_SAMPLES;
        double u = (double)column + (across + 0.5) / HILL_SAMPLES;
        double v = (double)row + (up + 0.5) / HILL_SAMPLES;
        sum = vec3_add(sum, hill_color(u / (double)side, v / (double)side));
    }
    return vec3_scale(sum, 1.0 / (HILL_SAMPLES * HILL_SAMPLES));
}

static struct color hill_texel(int x, int y) {
    struct vec3 c = hill_mean((size_t)x, (size_t)y, HILL_TEXELS);
    return color_rgb(level_from(c.x), level_from(c.y), level_from(c.z));
}

static const struct pattern hill_pattern = {HILL_TEXELS, HILL_TEXELS, hill_texel, true};

/* ---- Setting up ---- */

static bool target_create(struct target *target, size_t side, struct error *error) {
    target->exact = bench_memory(side * side, sizeof *target->exact);
    return image_create(&target->image, side, side, IMAGE_BGR, error);
}

static bool make_hill(struct target *hill, struct error *error) {
    if (!target_create(hill, HILL_SIDE, error) || !paint(&hill->texture, &hill_pattern, error)) {
        return false;
    }
    attempt_square(hill->corners, HILL_SIDE);
    for (size_t i = 0; i < (size_t)HILL_SIDE * HILL_SIDE; i++) {
        hill->exact[i] = hill_mean(i % HILL_SIDE, i / HILL_SIDE, HILL_SIDE);
    }
    hill->pixels = (size_t)HILL_SIDE * HILL_SIDE;
    return true;
}

/* ---- The tiles of scene checker, by rays, and by their texels in long double ---- */

static void count_pixels_of(struct target *target) {
    draw_target(target, HOUSE);
    for (size_t i = 0; i < target->image.width * target->image.height; i++) {
        target->pixels += target->image.pixels[3 * i] != 0; /* no colour of a tile has blue 0 */
    }
}

/* The scene's surface, and no exact colours yet. */
static bool begin_checker(struct target *target, size_t side, struct error *error) {
    if (!target_create(target, side, error) || !paint(&target->texture, &checker, error)) {
        return false;
    }
    place_surface(&plane_of_tiles, &target->image, target->corners);
    for (size_t i = 0; i < side * side; i++) {
        target->exact[i] = (struct vec3){-1, -1, -1};
    }
    return true;
}

/* The mean colour (red, green, blue) of a pixel of scene checker, from `rays` * `rays` rays to the
 * plane itself and without any triangle or texture. False where some ray misses the plane. */
static bool exact_checker(size_t x, size_t y, size_t width, size_t height, int rays,
                          struct vec3 *mean) {
    const struct vec3 light = {245, 235, 215}, dark = {150, 45, 30};
    const struct vec3 first = plane_of_tiles.place[0], last = plane_of_tiles.place[2];
    int light_count = 0;
    for (int i = 0; i < rays * rays; i++) {
        double screen_x = (double)x + (i % rays + 0.5) / rays;
        double screen_y = (double)y + (i / rays + 0.5) / rays;
        /* The ray to (a, b, -1) * distance, in the frame of the plane, which is 1.5 below it. */
        double a = (screen_x / (double)width - 0.5) * 2;
        double b = (screen_y / (double)height - 0.75) * 2;
        double down = 0.28 * a - 0.96 * b, distance = 1.5 / down;
        double side = (0.96 * a + 0.28 * b) * distance;
        if (down <= 0 || distance < first.z || distance > last.z || fabs(side) > last.x) {
            return false;
        }
        double tile = floor(2 * side + 0.5) + floor(2 * distance + 0.5);
        light_count += floor(tile / 2) * 2 == tile;
    }
    double share = (double)light_count / (rays * rays);
    *mean = vec3_add(vec3_scale(light, share), vec3_scale(dark, 1 - share));
    return true;
}

static bool make_far(struct target *far, struct error *error) {
    if (!begin_checker(far, FAR_SIDE, error)) {
        return false;
    }
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic)
#endif
    for (int y = 0; y < FAR_SIDE; y++) {
        for (int x = 0; x < FAR_SIDE; x++) {
            exact_checker((size_t)x, (size_t)y, FAR_SIDE, FAR_SIDE, FAR_RAYS,
                          &far->exact[y * FAR_SIDE + x]);
        }
    }
    count_pixels_of(far);
    return true;
}

static size_t exact_texel(const struct vertex v[3], const double value[3], int x, int y) {
    const struct fixed2 corner[3] = {v[0].position, v[1].position, v[2].position};
    const double recip_w[3] = {v[0].recip_w, v[1].recip_w, v[2].recip_w};
    long double place = oracle_interpolate(corner, recip_w, value, x, y);
    const size_t size = (size_t)checker.width;
    return (size_t)((place - floorl(place)) * (long double)size) % size;
}

/* The nearest texel of each pixel that the triangle covers. */
static void find_exact_texels(struct target *target, struct vertex a, struct vertex b,
                              struct vertex c) {
    const struct vertex v[3] = {a, b, c};
    const double u_of[3] = {a.uv.x, b.uv.x, c.uv.x}, v_of[3] = {a.uv.y, b.uv.y, c.uv.y};
    const uint32_t *texels = target->texture.level[0].texels;
    size_t pitch = target->texture.level[0].pitch;
    for (int y = 0; y < TILES_SIDE; y++) {
        for (int x = 0; x < TILES_SIDE; x++) {
            if (oracle_covers(a.position, b.position, c.position, x, y)) {
                size_t column = exact_texel(v, u_of, x, y), row = exact_texel(v, v_of, x, y);
                struct color color = color_from_texel(texels[row * pitch + column]);
                target->exact[y * TILES_SIDE + x] = (struct vec3){color.r, color.g, color.b};
            }
        }
    }
}

static bool make_tiles(struct target *tiles, struct error *error) {
    if (!begin_checker(tiles, TILES_SIDE, error)) {
        return false;
    }
    const struct vertex *c = tiles->corners;
    find_exact_texels(tiles, c[0], c[1], c[2]);
    find_exact_texels(tiles, c[0], c[2], c[3]);
    count_pixels_of(tiles);
    return true;
}

static bool setup(struct error *error) {
    return make_hill(&targets[HILL], error) && make_far(&targets[FAR], error) &&
           make_tiles(&targets[TILES], error);
}

/* ---- The panels ---- */

static void run(struct bench_choice choice) {
    draw_target(&targets[choice.on], choice.way);
}

static double error_of(struct bench_choice choice) {
    return target_error(&targets[choice.on]);
}

static const struct bench_version near_versions[] = {
    VERSION("nearest, rounding", ROUNDING),        VERSION("nearest, floor", NEAREST),
    VERSION("bilinear, half texel off", HALF_OFF), VERSION("bilinear", BILINEAR),
    HOUSE_VERSION("mip levels (main.c)", HOUSE),
};

static const struct bench_version far_versions[] = {
    VERSION("nearest", NEAREST),
    VERSION("bilinear", BILINEAR),
    HOUSE_VERSION("mip levels (main.c)", HOUSE),
};

static const char stepped_series[] = "stepped along a row";

static const struct bench_version perspective_versions[] = {
    HOUSE_VERSION("every pixel, from weights", NEAREST),
    VERSION_OF(stepped_series, "every pixel", EVERY_1, 0),
    VERSION_OF(stepped_series, "every 8", EVERY_8, 0),
    VERSION_OF(stepped_series, "16", EVERY_16, 0),
    VERSION_OF(stepped_series, "affine", AFFINE, 0),
};

/* The picture of a target; what else a panel has comes behind. */
#define PANEL(target, list, ...)                                                                   \
    {                                                                                              \
        .error_label = "values, root mean square", .time_label = "ns per pixel", .on = (target),   \
        .run = run, .error = error_of, .units = &targets[target].pixels, BENCH_VERSIONS(list),     \
        __VA_ARGS__                                                                                \
    }

static const struct bench_panel bench_panels[] = {
    PANEL(HILL, near_versions, .title = "Near: 16x16 texels, enlarged to 512x512 pixels",
          .against = "256 samples a pixel"),
    PANEL(FAR, far_versions, .title = "Far: tiles towards the horizon, 400x400 pixels",
          .against = "1024 rays a pixel", .budget = 2),
    PANEL(TILES, perspective_versions,
          .title = "Perspective: divided how often? The tiles, nearest texel, 800x800",
          .against = "the same texels, found in long double", .budget = 2,
          .house_within = BENCH_EXACT),
};

const struct bench_lesson bench_step06 =
    BENCH_LESSON("step06_texture", "Lesson 6: textures", setup, bench_panels);
