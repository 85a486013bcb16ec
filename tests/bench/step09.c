/*
 * Step 9: how varyings are interpolated, how a shader is called, what is shaded and by how many
 * threads.
 *
 * The first two panels shade the same runs of visible pixels, which are found once: their loops
 * are the benchmark's own, and their exact answers long double. The last one is the pipeline as it
 * is; its error is taken against a picture drawn in the most patient way: one thread, everything
 * shaded as it comes, a call through a pointer for every pixel.
 */
#define main step09_main
int step09_main(int argc, char **argv);
#include "../../step09_shaders/main.c"
#undef main

#include "../../step09_shaders/attempts.h"

#include "array.h"
#include "bench.h"
#include "model_file.h"
#include "normals.h"
#include "oracle.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = 800, ROW_OF_BUSTS = 4 };

/* What a corner hands over: u, v and the intensity. RECIP_W is interpolated like them. */
enum { INTENSITY = 2, VALUES = 3, RECIP_W = VALUES };

/* A face that is seen somewhere. */
struct seen {
    struct fixed2 corner[3];
    struct edges edges;
    double depth[3], recip_w[3], value[VALUES][3];
};

/* Pixels of row y in which one face is nearest. */
struct run {
    const struct seen *face;
    struct span span;
    int y;
};

/* A model, and the right picture of it. */
struct subject {
    struct model model;
    struct uniforms uniforms;
    struct draw_call call;
    struct image right;
};

/* The varyings of the pixels of a run, one array for each. */
struct varyings {
    double of[VALUES][SIDE];
};

/* What is drawn on, and with. */
struct target {
    struct pipeline pipeline;
    struct image image;
};

enum { TARGETS = 3 };

struct work {
    struct subject bust;
    struct seen *faces;
    struct run *runs;
    size_t face_count, run_count;
    struct varyings varyings;
    struct image right_gouraud;           /* of the bust; bust.right is textured */
    struct subject far_first, near_first; /* rows of busts */
    bool drawn;                           /* by the last version, without running out of memory */
    struct target targets[TARGETS];       /* each next has half of the width and height */
};

/* A picture's error in levels, root mean square: over the pixels of the runs. */
static double levels_wrong(const struct work *work, const struct image *right) {
    double sum = 0, count = 0;
    for (size_t i = 0; i < work->run_count; i++) {
        const struct run *run = &work->runs[i];
        size_t begin = 3 * ((size_t)run->y * SIDE + (size_t)run->span.begin);
        size_t end = 3 * ((size_t)run->y * SIDE + (size_t)run->span.end);
        for (size_t k = begin; k < end; k++) {
            double difference = work->targets[0].image.pixels[k] - right->pixels[k];
            sum += difference * difference;
            count++;
        }
    }
    return sqrt(sum / count);
}

static double units_pixels(const void *state) {
    const struct work *work = state;
    double pixels = 0;
    for (size_t i = 0; i < work->run_count; i++) {
        pixels += work->runs[i].span.end - work->runs[i].span.begin;
    }
    return pixels;
}

/* ---- The varyings of a run, in several types of number ---- */

/* What is linear along a row: begin + step * (pixels from the run's first). */
struct along {
    double begin[VALUES + 1], step[VALUES + 1];
};

/* The values and 1/w; in perspective the values are divided by w. */
static inline struct along along_run(const struct run *run, bool perspective) {
    const struct seen *face = run->face;
    const double scale = 1 / (double)face->edges.area;
    const struct edge *e = face->edges.edge;
    struct vec3 weight = edges_weights(&face->edges, run->span.begin, run->y);
    struct vec3 step = {(double)e[0].dx * scale, (double)e[1].dx * scale, (double)e[2].dx * scale};
    const double one[3] = {1, 1, 1}, *w = perspective ? face->recip_w : one;
    struct along along;
    for (int i = 0; i <= VALUES; i++) {
        const double *at = i < VALUES ? face->value[i] : one;
        double a = at[0] * w[0], b = at[1] * w[1], c = at[2] * w[2];
        along.begin[i] = interpolate(weight, a, b, c);
        along.step[i] = interpolate(step, a, b, c);
    }
    return along;
}

enum { BLOCK = 8 };

/* For `way`, a constant where this is inlined: a division for each pixel; one for every 8 pixels
 * and straight between; none, straight on the screen. */
enum way { EACH_PIXEL, EVERY_8, AFFINE, WAYS };

/* The loops in a type of number; ROUND brings the result of an operation to its digits. */
#define FILL(name, real, ROUND)                                                                    \
    static inline void name##_block(const real begin[], const real step[], int from, int count,    \
                                    real at[], struct varyings *out) {                             \
        real i = (real)(from + count);                                                             \
        real w = ROUND(1 / ROUND(begin[RECIP_W] + ROUND(step[RECIP_W] * i)));                      \
        real part = count == BLOCK ? (real)1 / BLOCK : ROUND(1 / (real)count);                     \
        for (int k = 0; k < VALUES; k++) {                                                         \
            real end = ROUND(ROUND(begin[k] + ROUND(step[k] * i)) * w);                            \
            real slope = ROUND(ROUND(end - at[k]) * part);                                         \
            for (int j = 0; j < count; j++) {                                                      \
                out->of[k][from + j] = (double)ROUND(at[k] + ROUND(slope * (real)j));              \
            }                                                                                      \
            at[k] = end;                                                                           \
        }                                                                                          \
    }                                                                                              \
    static inline void name(const struct run *run, struct varyings *out, enum way way) {           \
        struct along along = along_run(run, way != AFFINE);                                        \
        int count = run->span.end - run->span.begin;                                               \
        real begin[VALUES + 1], step[VALUES + 1], at[VALUES];                                      \
        for (int k = 0; k <= VALUES; k++) {                                                        \
            begin[k] = ROUND((real)along.begin[k]);                                                \
            step[k] = ROUND((real)along.step[k]);                                                  \
        }                                                                                          \
        if (way == EVERY_8) {                                                                      \
            for (int k = 0; k < VALUES; k++) {                                                     \
                at[k] = ROUND(begin[k] / begin[RECIP_W]);                                          \
            }                                                                                      \
            for (int i = 0; i < count; i += BLOCK) {                                               \
                name##_block(begin, step, i, count - i < BLOCK ? count - i : BLOCK, at, out);      \
            }                                                                                      \
            return;                                                                                \
        }                                                                                          \
        for (int i = 0; i < count; i++) {                                                          \
            real w = way == AFFINE                                                                 \
                         ? 1                                                                       \
                         : ROUND(1 / ROUND(begin[RECIP_W] + ROUND(step[RECIP_W] * (real)i)));      \
            for (int k = 0; k < VALUES; k++) {                                                     \
                real value = ROUND(begin[k] + ROUND(step[k] * (real)i));                           \
                out->of[k][i] = (double)(way == AFFINE ? value : ROUND(value * w));                \
            }                                                                                      \
        }                                                                                          \
    }

#define AS_IT_IS(value) (value)

/* The nearest number of 11 binary digits, as half has them (Dekker, "A Floating-Point Technique for
 * Extending the Available Precision", 1971). The smaller range of half is not imitated. */
static inline float to_half(float value) {
    float large = value * 8193;
    return large - (large - value);
}

FILL(fill_double, double, AS_IT_IS)
FILL(fill_float, float, AS_IT_IS)
FILL(fill_half, float, to_half)

/* 16.16: 16 binary digits after the point. */
static inline int32_t to_fixed(double value) {
    return (int32_t)floor(value * 65536 + 0.5);
}

static inline double from_fixed(int64_t value) {
    return (double)value * 0x1p-16;
}

static inline int64_t divide_fixed(int32_t value, int32_t recip_w) {
    return (int64_t)value * 65536 / recip_w;
}

static inline void fill_fixed_block(const int32_t begin[], const int32_t step[], int from,
                                    int count, int64_t at[], struct varyings *out) {
    int i = from + count;
    for (int k = 0; k < VALUES; k++) {
        int64_t end = divide_fixed(begin[k] + step[k] * i, begin[RECIP_W] + step[RECIP_W] * i);
        int64_t slope = count == BLOCK ? (end - at[k]) / BLOCK : (end - at[k]) / count;
        for (int j = 0; j < count; j++) {
            out->of[k][from + j] = from_fixed(at[k] + slope * j);
        }
        at[k] = end;
    }
}

static inline void fill_fixed(const struct run *run, struct varyings *out, enum way way) {
    struct along along = along_run(run, way != AFFINE);
    int count = run->span.end - run->span.begin;
    int32_t begin[VALUES + 1], step[VALUES + 1];
    int64_t at[VALUES];
    for (int k = 0; k <= VALUES; k++) {
        begin[k] = to_fixed(along.begin[k]);
        step[k] = to_fixed(along.step[k]);
    }
    if (way == EVERY_8) {
        for (int k = 0; k < VALUES; k++) {
            at[k] = divide_fixed(begin[k], begin[RECIP_W]);
        }
        for (int i = 0; i < count; i += BLOCK) {
            fill_fixed_block(begin, step, i, count - i < BLOCK ? count - i : BLOCK, at, out);
        }
        return;
    }
    for (int i = 0; i < count; i++) {
        int32_t recip_w = begin[RECIP_W] + step[RECIP_W] * i;
        for (int k = 0; k < VALUES; k++) {
            int32_t value = begin[k] + step[k] * i;
            out->of[k][i] = from_fixed(way == AFFINE ? value : divide_fixed(value, recip_w));
        }
    }
}

/* The weights of the corners, as the pipeline finds them at each pixel. */
static inline struct vec3 exact_weights(const struct seen *face, int x, int y) {
    const struct edge *e = face->edges.edge;
    struct vec3 screen = {(double)(e[0].origin + e[0].dx * x + e[0].dy * y),
                          (double)(e[1].origin + e[1].dx * x + e[1].dy * y),
                          (double)(e[2].origin + e[2].dx * x + e[2].dy * y)};
    return perspective_weights(screen, face->recip_w);
}

static inline void fill_by_weights(const struct run *run, struct varyings *out, enum way way) {
    (void)way;
    for (int x = run->span.begin; x < run->span.end; x++) {
        struct vec3 weight = exact_weights(run->face, x, run->y);
        for (int k = 0; k < VALUES; k++) {
            const double *at = run->face->value[k];
            out->of[k][x - run->span.begin] = interpolate(weight, at[0], at[1], at[2]);
        }
    }
}

/* A function for each way, with the type of number and the way inlined. */
#define FILLED(name, fill, way)                                                                    \
    static void name(const struct run *run, struct varyings *out) {                                \
        fill(run, out, way);                                                                       \
    }

FILLED(by_weights, fill_by_weights, EACH_PIXEL)
FILLED(double_each, fill_double, EACH_PIXEL)
FILLED(double_8, fill_double, EVERY_8)
FILLED(double_affine, fill_double, AFFINE)
FILLED(float_each, fill_float, EACH_PIXEL)
FILLED(float_8, fill_float, EVERY_8)
FILLED(float_affine, fill_float, AFFINE)
FILLED(half_each, fill_half, EACH_PIXEL)
FILLED(half_8, fill_half, EVERY_8)
FILLED(half_affine, fill_half, AFFINE)
FILLED(fixed_each, fill_fixed, EACH_PIXEL)
FILLED(fixed_8, fill_fixed, EVERY_8)
FILLED(fixed_affine, fill_fixed, AFFINE)

enum number { BY_WEIGHTS, IN_DOUBLE, IN_FLOAT, IN_HALF, IN_FIXED, NUMBERS };

typedef void fill_function(const struct run *run, struct varyings *out);

static fill_function *const fills[NUMBERS][WAYS] = {
    [BY_WEIGHTS] = {by_weights},
    [IN_DOUBLE] = {double_each, double_8, double_affine},
    [IN_FLOAT] = {float_each, float_8, float_affine},
    [IN_HALF] = {half_each, half_8, half_affine},
    [IN_FIXED] = {fixed_each, fixed_8, fixed_affine},
};

#define VARYING(number, way) ((int)(number)*WAYS + (int)(way))

/* The varyings of all pixels. */
static void run_varying(void *state, int choice) {
    struct work *work = state;
    fill_function *fill = fills[choice / WAYS][choice % WAYS];
    for (size_t i = 0; i < work->run_count; i++) {
        fill(&work->runs[i], &work->varyings);
    }
}

static inline void write_color(struct image *image, int x, int y, struct color color) {
    uint8_t *pixel = image->pixels + 3 * ((size_t)y * SIDE + (size_t)x);
    pixel[0] = color.b;
    pixel[1] = color.g;
    pixel[2] = color.r;
}

/* The same varyings, and the texture's colours in their light. */
static double error_varying(void *state, int choice) {
    struct work *work = state;
    for (size_t i = 0; i < work->run_count; i++) {
        const struct run *run = &work->runs[i];
        fills[choice / WAYS][choice % WAYS](run, &work->varyings);
        for (int x = run->span.begin, k = 0; x < run->span.end; x++, k++) {
            struct color color;
            const double here[VALUES] = {work->varyings.of[0][k], work->varyings.of[1][k],
                                         work->varyings.of[2][k]};
            textured_fragment(&work->bust.uniforms, here, &color);
            write_color(&work->targets[0].image, x, run->y, color);
        }
    }
    return levels_wrong(work, &work->bust.right);
}

/* ---- Calls of a shader, on the same runs: Gouraud, which does little for a pixel ---- */

typedef bool fragment_function(const void *uniforms, const double *varyings, struct color *color);
typedef void shade_run_function(const struct run *run, fragment_function *fragment,
                                struct work *work);

#if defined(__GNUC__)
#define INLINED static inline __attribute__((always_inline))
#else
#define INLINED static inline
#endif

/* Shade the middle one of every `step` pixels, and give the others its colour. */
INLINED void shade_run_by(int step, const struct run *run, fragment_function *fragment,
                          struct work *work) {
    const double *at = run->face->value[INTENSITY];
    for (int begin = run->span.begin; begin < run->span.end; begin += step) {
        int end = step < run->span.end - begin ? begin + step : run->span.end;
        struct vec3 weight = exact_weights(run->face, (begin + end) / 2, run->y);
        double varying = interpolate(weight, at[0], at[1], at[2]);
        struct color color;
        fragment(&work->bust.uniforms, &varying, &color);
        for (int x = begin; x < end; x++) {
            write_color(&work->targets[0].image, x, run->y, color);
        }
    }
}

/* The loop over pixels with the fragment function inlined, but itself called for each run. */
static void shade_run_of_gouraud(const struct run *run, fragment_function *fragment,
                                 struct work *work) {
    (void)fragment;
    shade_run_by(1, run, white_fragment, work);
}

enum { CALL_PER_PIXEL, CALL_PER_RUN, INLINED_1, INLINED_2, INLINED_4, INLINED_8 };

static void run_call(void *state, int choice) {
    struct work *work = state;
    /* The compiler must not know whom they call. */
    fragment_function *volatile hidden = white_fragment;
    shade_run_function *volatile hidden_run = shade_run_of_gouraud;
    fragment_function *fragment = hidden;
    shade_run_function *shade_run_called = hidden_run;
    for (size_t i = 0; i < work->run_count; i++) {
        const struct run *run = &work->runs[i];
        switch (choice) {
        case CALL_PER_PIXEL:
            shade_run_by(1, run, fragment, work);
            break;
        case CALL_PER_RUN:
            shade_run_called(run, fragment, work);
            break;
        case INLINED_1:
            shade_run_by(1, run, white_fragment, work);
            break;
        case INLINED_2:
            shade_run_by(2, run, white_fragment, work);
            break;
        case INLINED_4:
            shade_run_by(4, run, white_fragment, work);
            break;
        default:
            shade_run_by(8, run, white_fragment, work);
        }
    }
}

static double error_call(void *state, int choice) {
    struct work *work = state;
    (void)choice;
    return levels_wrong(work, &work->right_gouraud);
}

/* ---- The pipeline: at once or visible only, in which order, by how many threads ---- */

static void use_threads(struct work *work, int thread_count) {
    for (size_t i = 0; i < sizeof work->targets / sizeof work->targets[0]; i++) {
        pipeline_use_threads(&work->targets[i].pipeline, (size_t)thread_count);
    }
}

/* Each pixel of a small picture becomes a square of the large one. */
static void enlarge(const struct image *small, struct image *large) {
    size_t factor = large->width / small->width;
    for (size_t y = 0; y < large->height; y++) {
        for (size_t x = 0; x < large->width; x++) {
            memcpy(large->pixels + 3 * (y * large->width + x),
                   small->pixels + 3 * (y / factor * small->width + x / factor), 3);
        }
    }
}

enum order { FAR_FIRST, NEAR_FIRST };
enum kind { PER_PIXEL, PER_RUN, AT_ONCE, VISIBLE, HALF_SIZE, QUARTER_SIZE, KINDS };

#define ROW(kind, order, threads) ((int)(kind) + (int)KINDS * ((int)(order) + 2 * (threads)))

static bool draw_kind(enum kind kind, struct pipeline *p, const struct draw_call *call,
                      const struct uniforms *u, struct image *image) {
    struct error error;
    switch (kind) {
    case PER_PIXEL:
        return attempt_1_call_per_pixel(p, call, &gouraud_textured, u, image, &error);
    case PER_RUN:
        return attempt_2_call_per_run(p, call, &gouraud_textured, u, image, &error);
    case AT_ONCE:
        return attempt_3_shade_at_once(p, call, u, image, &error);
    default:
        return pipeline_draw(p, call, &gouraud_textured, u, image, &error);
    }
}

/* 1 for half of the width and height, 2 for a quarter. */
static size_t target_of(enum kind kind) {
    return kind == HALF_SIZE ? 1 : kind == QUARTER_SIZE ? 2 : 0;
}

static bool draw_row(struct work *work, const struct subject *row, enum kind kind) {
    size_t smaller = target_of(kind);
    struct target *target = &work->targets[smaller];
    struct draw_call call = row->call;
    struct uniforms uniforms = row->uniforms;
    call.viewport = grid_cell(target->image.width, target->image.height, 1, 1, 0, 0);
    uniforms.diffuse_level += smaller; /* texels as large as pixels */
    pipeline_clear(&target->pipeline);
    memset(target->image.pixels, 0, target->image.width * target->image.height * IMAGE_BGR);
    bool done = draw_kind(kind, &target->pipeline, &call, &uniforms, &target->image);
    if (smaller > 0) {
        enlarge(&target->image, &work->targets[0].image);
    }
    return done;
}

static void run_row(void *state, int choice) {
    struct work *work = state;
    use_threads(work, choice / KINDS / 2);
    bool near_first = choice / KINDS % 2 == NEAR_FIRST;
    work->drawn = draw_row(work, near_first ? &work->near_first : &work->far_first,
                           (enum kind)(choice % KINDS));
}

/* Over the pixels that any of the two pictures shows. */
static double error_row(void *state, int choice) {
    const struct work *work = state;
    const struct image *right = &work->far_first.right;
    double sum = 0, count = 0;
    (void)choice;
    for (size_t i = 0; i < (size_t)SIDE * SIDE * 3; i++) {
        double difference = work->targets[0].image.pixels[i] - right->pixels[i];
        sum += difference * difference;
        count += work->targets[0].image.pixels[i] != 0 || right->pixels[i] != 0;
    }
    return work->drawn ? sqrt(sum / count) : (double)INFINITY;
}

/* Pixels shaded. */
static double size_row(const void *state, int choice) {
    const struct work *work = state;
    const struct target *target = &work->targets[target_of((enum kind)(choice % KINDS))];
    return (double)target->pipeline.stats[STAT_PIXELS_SHADED] / 1000;
}

/* ---- Setting up ---- */

static bool make_face(struct seen *seen, const struct subject *subject, size_t face) {
    for (size_t i = 0; i < 3; i++) {
        struct vec4 clip =
            mat4_point(&subject->call.to_clip, model_position(&subject->model, face, i));
        double recip_w = 1 / clip.w, varyings[VALUES];
        struct vec2 screen = {(clip.x * recip_w + 1) * SIDE / 2, (clip.y * recip_w + 1) * SIDE / 2};
        gouraud_textured_vertex(&subject->uniforms, face, i, varyings);
        for (int k = 0; k < VALUES; k++) {
            seen->value[k][i] = varyings[k];
        }
        seen->recip_w[i] = recip_w;
        seen->depth[i] = clip.z * recip_w;
        if (!(clip.w > 0) || !screen_snap(screen, &seen->corner[i])) {
            return false;
        }
    }
    return edges_setup(&seen->edges, seen->corner[0], seen->corner[1], seen->corner[2], SIDE,
                       SIDE) &&
           !seen->edges.clockwise;
}

/* Keep the number of the face (from 1) in each pixel where it is nearest so far. */
static void cover(const struct seen *face, uint32_t number, double *depths, uint32_t *nearest) {
    for (int y = face->edges.y_begin; y < face->edges.y_end; y++) {
        struct span span = edges_span(&face->edges, y);
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 w = edges_weights(&face->edges, x, y);
            double depth = interpolate_depth(w, face->depth[0], face->depth[1], face->depth[2]);
            if (depth > depths[y * SIDE + x]) {
                depths[y * SIDE + x] = depth;
                nearest[y * SIDE + x] = number;
            }
        }
    }
}

static bool add_runs_of_row(struct work *work, size_t *capacity, const uint32_t *nearest, int y,
                            struct error *error) {
    for (struct span span = {0, 0}; span.begin < SIDE; span.begin = span.end) {
        while (span.end < SIDE && nearest[span.end] == nearest[span.begin]) {
            span.end++;
        }
        if (nearest[span.begin] == 0) {
            continue;
        }
        struct run *grown =
            array_reserve(work->runs, capacity, work->run_count + 1, sizeof *work->runs);
        if (grown == NULL) {
            return error_out_of_memory(error);
        }
        work->runs = grown;
        work->runs[work->run_count++] =
            (struct run){&work->faces[nearest[span.begin] - 1], span, y};
    }
    return true;
}

static bool find_runs_with(struct work *work, double *depths, uint32_t *nearest,
                           struct error *error) {
    const struct subject *bust = &work->bust;
    size_t capacity = 0;
    bool done = true;
    depth_clear(depths, (size_t)SIDE * SIDE);
    for (size_t i = 0; i < bust->model.face_count; i++) {
        struct seen *face = &work->faces[work->face_count];
        if (make_face(face, bust, i)) {
            cover(face, (uint32_t)++work->face_count, depths, nearest);
        }
    }
    for (int y = 0; done && y < SIDE; y++) {
        done = add_runs_of_row(work, &capacity, nearest + y * SIDE, y, error);
    }
    return done;
}

/* What is visible of the bust. */
static bool find_runs(struct work *work, struct error *error) {
    uint32_t *nearest = calloc((size_t)SIDE * SIDE, sizeof *nearest);
    double *depths = malloc((size_t)SIDE * SIDE * sizeof *depths);
    work->faces = malloc(work->bust.model.face_count * sizeof *work->faces);
    bool done = nearest != NULL && depths != NULL && work->faces != NULL
                    ? find_runs_with(work, depths, nearest, error)
                    : error_out_of_memory(error);
    free(nearest);
    free(depths);
    return done;
}

/* Varyings in long double. */
static void shade_exactly(struct work *work, const struct run *run, int x) {
    const struct seen *face = run->face;
    struct color textured, white;
    double varyings[VALUES];
    for (int k = 0; k < VALUES; k++) {
        varyings[k] =
            (double)oracle_interpolate(face->corner, face->recip_w, face->value[k], x, run->y);
    }
    textured_fragment(&work->bust.uniforms, varyings, &textured);
    white_fragment(&work->bust.uniforms, varyings + INTENSITY, &white);
    write_color(&work->bust.right, x, run->y, textured);
    write_color(&work->right_gouraud, x, run->y, white);
}

static bool make_right_pictures(struct work *work, struct error *error) {
    if (!image_create(&work->bust.right, SIDE, SIDE, IMAGE_BGR, error) ||
        !image_create(&work->right_gouraud, SIDE, SIDE, IMAGE_BGR, error)) {
        return false;
    }
    for (size_t i = 0; i < work->run_count; i++) {
        for (int x = work->runs[i].span.begin; x < work->runs[i].span.end; x++) {
            shade_exactly(work, &work->runs[i], x);
        }
    }
    return true;
}

/* Make the model a row of `count` copies of itself, moved by `offset` each. */
static bool repeat_model(struct model *model, size_t count, struct vec3 offset, enum order order,
                         struct error *error) {
    size_t positions = model->position_count, faces = model->face_count;
    void *grown = realloc(model->positions, count * positions * sizeof *model->positions);
    if (grown != NULL) {
        model->positions = grown;
    }
    struct face *all = realloc(model->faces, count * faces * sizeof *all);
    if (all != NULL) {
        model->faces = all;
    }
    if (grown == NULL || all == NULL) {
        return error_out_of_memory(error);
    }
    /* The last copy first: copy 0 is what the others are made of. */
    for (size_t copy = count; copy-- > 0;) {
        struct vec3 by = vec3_scale(offset, (double)(order == FAR_FIRST ? count - 1 - copy : copy));
        for (size_t i = 0; i < positions; i++) {
            model->positions[copy * positions + i] = vec3_add(model->positions[i], by);
        }
        for (size_t i = 0; i < faces; i++) {
            struct face *face = &model->faces[copy * faces + i];
            *face = model->faces[i];
            for (int k = 0; k < 3; k++) {
                face->corner[k].position += (uint32_t)(copy * positions);
            }
        }
    }
    model->position_count = count * positions;
    model->face_count = count * faces;
    return true;
}

/* The scenes' camera. */
static bool prepare_subject(struct subject *subject, struct error *error) {
    struct drawing drawing = {
        .model = &subject->model,
        .diffuse = model_texture(&subject->model, MODEL_DIFFUSE, error),
        .eye = {1, 0.5, 3},
        .up = {0, 1, 0},
        .light = {1, 1, 1},
    };
    if (drawing.diffuse == NULL || !model_need_normals(&subject->model, error)) {
        return false;
    }
    subject->uniforms = make_uniforms(&drawing, SIDE);
    subject->call = pipeline_call(&drawing, grid_cell(SIDE, SIDE, 1, 1, 0, 0), 0.85, CULL_BACK);
    return true;
}

static bool make_row(struct subject *row, enum order order, struct error *error) {
    static const struct vec3 backwards = {-0.35, -0.1, -0.9};
    return bench_read_model(&row->model, "bust.obj", error) &&
           repeat_model(&row->model, ROW_OF_BUSTS, backwards, order, error) &&
           prepare_subject(row, error);
}

/* The most patient drawing. */
static bool draw_patiently(struct work *work, struct error *error) {
    struct target *target = &work->targets[0];
    use_threads(work, 1);
    target->pipeline.skip = false;
    bool done = draw_row(work, &work->far_first, PER_PIXEL);
    target->pipeline.skip = true;
    return (done || error_out_of_memory(error)) &&
           image_copy(&work->far_first.right, &target->image, error);
}

static bool make_targets(struct work *work, struct error *error) {
    bool done = true;
    for (size_t i = 0; done && i < TARGETS; i++) {
        size_t side = (size_t)SIDE >> i;
        done = image_create(&work->targets[i].image, side, side, IMAGE_BGR, error) &&
               pipeline_create(&work->targets[i].pipeline, side, side, error);
    }
    return done;
}

static bool setup(void **state, struct error *error) {
    struct work *work = calloc(1, sizeof *work);
    *state = work;
    if (work == NULL) {
        return error_out_of_memory(error);
    }
    return make_targets(work, error) && bench_read_model(&work->bust.model, "bust.obj", error) &&
           prepare_subject(&work->bust, error) && find_runs(work, error) &&
           make_right_pictures(work, error) && make_row(&work->far_first, FAR_FIRST, error) &&
           make_row(&work->near_first, NEAR_FIRST, error) && draw_patiently(work, error);
}

static void teardown(void *state) {
    struct work *work = state;
    if (work != NULL) {
        struct subject *subjects[] = {&work->bust, &work->far_first, &work->near_first};
        for (int i = 0; i < 3; i++) {
            model_free(&subjects[i]->model);
            image_free(&subjects[i]->right);
        }
        for (int i = 0; i < TARGETS; i++) {
            image_free(&work->targets[i].image);
            pipeline_free(&work->targets[i].pipeline);
        }
        free(work->faces);
        free(work->runs);
        image_free(&work->right_gouraud);
    }
    free(work);
}

/* ---- The panels ---- */

#define VERSION(label, of, number, house)                                                          \
    {                                                                                              \
        .name = (label), .choice = (number), .is_house = (house), .run = run_##of,                 \
        .error = error_##of                                                                        \
    }

static const char *varying_series(int choice) {
    static const char *const names[NUMBERS] = {[IN_DOUBLE] = "double",
                                               [IN_FLOAT] = "float",
                                               [IN_HALF] = "half's digits",
                                               [IN_FIXED] = "16.16"};
    return names[choice / WAYS];
}

static const struct bench_version varying_versions[] = {
    VERSION("exact weights, double", varying, VARYING(BY_WEIGHTS, EACH_PIXEL), true),
    VERSION("each pixel", varying, VARYING(IN_DOUBLE, EACH_PIXEL), false),
    VERSION("every 8", varying, VARYING(IN_DOUBLE, EVERY_8), false),
    VERSION("affine", varying, VARYING(IN_DOUBLE, AFFINE), false),
    VERSION("each pixel", varying, VARYING(IN_FLOAT, EACH_PIXEL), false),
    VERSION("every 8", varying, VARYING(IN_FLOAT, EVERY_8), false),
    VERSION("affine", varying, VARYING(IN_FLOAT, AFFINE), false),
    VERSION("each pixel", varying, VARYING(IN_HALF, EACH_PIXEL), false),
    VERSION("every 8", varying, VARYING(IN_HALF, EVERY_8), false),
    VERSION("affine", varying, VARYING(IN_HALF, AFFINE), false),
    VERSION("each pixel", varying, VARYING(IN_FIXED, EACH_PIXEL), false),
    VERSION("every 8", varying, VARYING(IN_FIXED, EVERY_8), false),
    VERSION("affine", varying, VARYING(IN_FIXED, AFFINE), false),
};

static const char *call_series(int choice) {
    return choice >= INLINED_1 ? "inlined, 1 pixel shaded of" : NULL;
}

static const struct bench_version call_versions[] = {
    VERSION("a call for every pixel", call, CALL_PER_PIXEL, false),
    VERSION("a call for every run", call, CALL_PER_RUN, false),
    VERSION("1", call, INLINED_1, true),
    VERSION("2", call, INLINED_2, false),
    VERSION("4", call, INLINED_4, false),
    VERSION("8", call, INLINED_8, false),
};

static const struct bench_version row_versions[] = {
    VERSION("a call for every pixel", row, ROW(PER_PIXEL, FAR_FIRST, 1), false),
    VERSION("a call for every run", row, ROW(PER_RUN, FAR_FIRST, 1), false),
    VERSION("at once, farthest first", row, ROW(AT_ONCE, FAR_FIRST, 1), false),
    VERSION("at once, nearest first", row, ROW(AT_ONCE, NEAR_FIRST, 1), false),
    VERSION("visible, farthest first", row, ROW(VISIBLE, FAR_FIRST, 1), true),
    VERSION("visible, nearest first", row, ROW(VISIBLE, NEAR_FIRST, 1), true),
    VERSION("at once, 2 threads", row, ROW(AT_ONCE, FAR_FIRST, 2), false),
    VERSION("visible, 2 threads", row, ROW(VISIBLE, FAR_FIRST, 2), true),
    VERSION("400x400, enlarged", row, ROW(HALF_SIZE, FAR_FIRST, 1), false),
    VERSION("200x200, enlarged", row, ROW(QUARTER_SIZE, FAR_FIRST, 1), false),
};

static const struct bench_panel bench_panels[] = {
    {.title = "The textured bust: u, v and intensity of its pixels",
     .error_label = "levels, root mean square",
     .time_label = "ns per pixel",
     .against = "long double",
     .units = units_pixels,
     .versions = varying_versions,
     .version_count = sizeof varying_versions / sizeof varying_versions[0],
     .series = varying_series},
    {.title = "The bust by Gouraud: calls of the fragment function",
     .error_label = "levels, root mean square",
     .time_label = "ns per pixel",
     .against = "long double",
     .units = units_pixels,
     .versions = call_versions,
     .version_count = sizeof call_versions / sizeof call_versions[0],
     .series = call_series},
    {.title = "Four busts in a row, textured: the pipeline, 800x800 pixels",
     .error_label = "levels, root mean square",
     .time_label = "ms per frame",
     .against = "the most patient drawing",
     .versions = row_versions,
     .version_count = sizeof row_versions / sizeof row_versions[0],
     .size = size_row,
     .size_label = "thousand pixels shaded"},
};

const struct bench_lesson bench_step09 = {
    .step = "step09_shaders",
    .title = "Step 9: shaders",
    .setup = setup,
    .teardown = teardown,
    .panels = bench_panels,
    .panel_count = sizeof bench_panels / sizeof bench_panels[0],
};
