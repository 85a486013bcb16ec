/*
 * Step 9: the loops over visible pixels, in one type of number (REAL) and for so many pixels at
 * once (LANES). Included by files that define these and the name of their table, WAYS.
 *
 * All of them read the same list of what is visible, and have the planes of all faces ready.
 */
#define LESSON "../step09_shaders/main.c"
#include "lesson.h"

#include "ways.h"

#include <stdlib.h>

static struct uniforms uniforms_of(const struct visible *v) {
    return (struct uniforms){.model = v->model,
                             .diffuse = v->diffuse,
                             .diffuse_level = v->diffuse_level,
                             .to_light = v->to_light};
}

static const struct shader *const shader_of_look[LOOKS] = {&gouraud_textured, &gouraud};

/* The planes of a face: those of all lie as planes_number() says. */
static struct planes *planes_of_face(const struct planes *planes, const struct shader *shader,
                                     uint32_t number) {
    return planes_number((struct planes *)planes, shader, number);
}

/* 1/w of all positions, as the pipeline keeps them; 1 where there is no perspective. */
static double *find_all_recip_w(const struct visible *v, enum planes_kind kind) {
    double *recip_w = malloc(v->model->position_count * sizeof *recip_w);
    for (size_t i = 0; recip_w != NULL && i < v->model->position_count; i++) {
        double w = mat4_point(&v->to_clip, v->model->positions[i]).w;
        recip_w[i] = kind == FLAT_ON_SCREEN ? 1 : 1 / w;
    }
    return recip_w;
}

static void *make_planes(const struct visible *v, enum look look, enum planes_kind kind) {
    const struct shader *shader = shader_of_look[look];
    struct uniforms u = uniforms_of(v);
    struct draw draw = {.call = {.model = v->model, .to_clip = v->to_clip}};
    struct pipeline pipeline = {.recip_w.data = find_all_recip_w(v, kind)};
    struct pixel_work work = {0};
    struct shading shading = {.pipeline = &pipeline, .draw = &draw, .uniforms = &u, .work = &work};
    struct planes *planes = malloc((v->face_count + 1) * sizeof *planes);
    bool whole = planes != NULL && pipeline.recip_w.data != NULL;
    for (size_t i = 0; whole && i < v->face_count; i++) {
        const struct seen *face = &v->faces[i];
        struct piece piece = {.corner = {face->corner[0], face->corner[1], face->corner[2]},
                              .face = face->face,
                              .clipped = NOT_CLIPPED,
                              .face_corner = {0, 1, 2}};
        struct planes *at = planes_of_face(planes, shader, (uint32_t)i + 1);
        fetch_planes(&shading, shader, &piece, at);
        for (size_t k = 0; kind == EVERY_SECOND && k <= shader->varying_count; k++) {
            at->four[k / FOUR].dx[k % FOUR] *= 2;
        }
        at->x0 = kind == EVERY_SECOND ? at->x0 / 2 : at->x0;
    }
    free(pipeline.recip_w.data);
    if (!whole) {
        free(planes);
        return NULL;
    }
    return planes;
}

/* ---- The varyings of LANES pixels at x, of which a run belongs to the face ---- */

/* A division for each pixel; for every so many, and straight between them; none. */
enum division { EACH_PIXEL = 1, EVERY_8 = 8, EVERY_16 = 16, NEVER = 0 };

/* At the first pixel of a run and at every `step`-th from there, and at its last one; straight
 * between them. The run lies within a chunk: lanes first..last of LANES pixels at x. */
LANES_INLINE void interpolate_every(int step, const struct shader *shader,
                                    const struct planes *planes, int x, int y, int first, int last,
                                    lanes *varyings) {
    size_t n = shader->varying_count;
    const int parts = CHUNK / step;
    const struct varying_plane bottom = varying_plane(planes, n);
    real up = (real)y - planes->y0, right[CHUNK / 8 + 1], w[CHUNK / 8 + 1];
    lanes share[CHUNK / 8] = {0}; /* of the way from one of these pixels to the next */
    for (int i = 0; i <= parts; i++) {
        int lane = first + i * step < last ? first + i * step : last;
        right[i] = (real)(x + lane) - planes->x0;
        w[i] = 1 / (right[i] * bottom.dx + (bottom.origin + bottom.dy * up));
    }
    for (int i = 0; i < parts; i++) {
        real length = right[i + 1] - right[i];
        share[i] = ((lanes_from(x) - planes->x0) - right[i]) * (1 / (length > 0 ? length : 1));
    }
    for (size_t k = 0; k < n; k++) {
        const struct varying_plane top = varying_plane(planes, k);
        real begin_of_row = top.origin + top.dy * up, at[CHUNK / 8 + 1] = {0};
        for (int i = 0; i <= parts; i++) {
            at[i] = top.corner + (right[i] * top.dx + begin_of_row) * w[i];
        }
        varyings[k] = at[0] + share[0] * (at[1] - at[0]);
        for (int i = 1; i < parts; i++) {
            lanes later = at[i] + share[i] * (at[i + 1] - at[i]);
            varyings[k] = lanes_select(share[i] > 0, later, varyings[k]);
        }
    }
}

LANES_INLINE void interpolate_affine(const struct shader *shader, const struct planes *planes,
                                     int x, int y, lanes *varyings) {
    lanes right = lanes_from(x) - planes->x0;
    real up = (real)y - planes->y0;
    for (size_t k = 0; k < shader->varying_count; k++) {
        const struct varying_plane top = varying_plane(planes, k);
        varyings[k] = right * top.dx + (top.corner + top.origin + top.dy * up);
    }
}

LANES_INLINE void interpolate_by(enum division division, const struct shader *shader,
                                 const struct planes *planes, int x, int y, struct span run,
                                 lanes *varyings) {
    if (division == NEVER) {
        interpolate_affine(shader, planes, x, y, varyings);
    } else {
        interpolate_every((int)division, shader, planes, x, y, run.begin, run.end - 1, varyings);
    }
}

/* ---- Chunks: all faces of LANES neighbours blended ---- */

/* With a division for each pixel, as the pipeline does it; otherwise run by run. */
LANES_INLINE bool gather(enum division division, const struct shading *s,
                         const struct shader *shader, const uint32_t number[LANES + 1], int x,
                         int y, lanes *varyings) {
    if (division == EACH_PIXEL) {
        return gather_varyings(s, shader, number, x, y, varyings);
    }
    bool found = false;
    for (uint32_t runs = find_runs(number); runs != 0; runs &= runs - 1) {
        uint32_t rest = runs & (runs - 1);
        struct span run = {__builtin_ctz(runs), rest != 0 ? __builtin_ctz(rest) : LANES};
        const struct planes *face = planes_of_face(s->scratch->planes, shader, number[run.begin]);
        lanes of_run[VARYING_LIMIT];
        if (number[run.begin] == 0) {
            continue;
        }
        interpolate_by(division, shader, face, x, y, run, found ? of_run : varyings);
        lanes_mask later = lanes_from(0) >= (real)run.begin;
        for (size_t k = 0; found && k < shader->varying_count; k++) {
            varyings[k] = lanes_select(later, of_run[k], varyings[k]);
        }
        found = true;
    }
    return found;
}

/* All faces are of one draw call, whose number n has planes number n. */
static struct shading shading_of(const struct visible *v, struct scratch *scratch) {
    return (struct shading){.scratch = scratch, .numbers = {0, (int)v->face_count}};
}

typedef lanes_mask fragment_function(const void *uniforms, const lanes *varyings,
                                     lanes_texel *color);

LANES_INLINE void shade_chunks(enum division division, const struct shader *shader,
                               fragment_function *fragment, const struct visible *v,
                               const struct planes *planes) {
    struct uniforms u = uniforms_of(v);
    struct image image = v->image;
    struct scratch scratch = {.fetched = v->same, .planes = (struct planes *)planes};
    const struct shading s = shading_of(v, &scratch);
    for (size_t i = 0; i < v->place_count; i++) {
        struct place place = v->places[i];
        for (int lane = 0; lane < CHUNK; lane += LANES) {
            const uint32_t *number = v->number + place.y * SIDE + place.x + lane;
            lanes varyings[VARYING_LIMIT];
            lanes_texel color, numbers;
            if (gather(division, &s, shader, number, place.x + lane, place.y, varyings)) {
                memcpy(&numbers, number, sizeof numbers);
                fragment(&u, varyings, &color);
                write_lanes(&image, place.x + lane, place.y, color, (lanes_int)(numbers != 0));
            }
        }
    }
}

/* ---- Runs: begun at their own first pixels ---- */

LANES_INLINE void shade_run(const struct shader *shader, const struct uniforms *u,
                            const struct visible *v, const struct planes *planes,
                            const struct run *run) {
    struct image image = v->image;
    const struct planes *face = planes_of_face(planes, shader, run->number);
    for (int x = run->span.begin; x < run->span.end; x += LANES) {
        lanes varyings[VARYING_LIMIT];
        lanes_texel color;
        interpolate_varyings(shader, face, x, run->y, varyings);
        shader->fragment(u, varyings, &color);
        write_lanes(&image, x, run->y, color,
                    (lanes_int)(lanes_int_from(0) < (int32_t)(run->span.end - x)));
    }
}

typedef void shade_run_function(const struct uniforms *u, const struct visible *v,
                                const struct planes *planes, const struct run *run);

static void shade_runs(shade_run_function *shade_this, const struct visible *v,
                       const struct planes *planes) {
    struct uniforms u = uniforms_of(v);
    for (size_t i = 0; i < v->run_count; i++) {
        shade_this(&u, v, planes, &v->runs[i]);
    }
}

/* ---- Half the rate: every second pixel of a row, and its neighbour copies ---- */

/* Pixels are shaded as those of a picture of half the width. */
LANES_INLINE void shade_pair(const struct shader *shader, const struct uniforms *u,
                             const struct visible *v, const struct shading *s, int x, int y) {
    struct image image = v->image;
    const uint32_t *pair = v->number + y * SIDE + x;
    uint32_t number[LANES + 1] = {0}, colors[LANES], twice[2 * LANES];
    lanes varyings[VARYING_LIMIT] = {lanes_all(0)};
    lanes_texel color;
    for (int i = 0; i < LANES; i++) {
        number[i] = pair[2 * i] != 0 ? pair[2 * i] : pair[2 * i + 1];
    }
    if (!gather(EACH_PIXEL, s, shader, number, x / 2, y, varyings)) {
        return;
    }
    shader->fragment(u, varyings, &color);
    memcpy(colors, &color, sizeof colors);
    for (int i = 0; i < 2 * LANES; i++) {
        twice[i] = colors[i / 2];
    }
    for (int i = 0; i < 2 * LANES; i += LANES) {
        lanes_texel numbers;
        memcpy(&color, twice + i, sizeof color);
        memcpy(&numbers, pair + i, sizeof numbers);
        write_lanes(&image, x + i, y, color, (lanes_int)(numbers != 0));
    }
}

/* Two chunks at a time: of two in a list that are neighbours, the first one shades both. */
LANES_INLINE void shade_half(const struct shader *shader, const struct visible *v,
                             const struct planes *planes) {
    struct uniforms u = uniforms_of(v);
    struct scratch scratch = {.fetched = v->same, .planes = (struct planes *)planes};
    const struct shading s = shading_of(v, &scratch);
    for (size_t i = 0; i < v->place_count; i++) {
        struct place place = v->places[i];
        int left = place.x / (2 * CHUNK) * (2 * CHUNK);
        if (place.x > left && i > 0 && v->places[i - 1].x == left &&
            v->places[i - 1].y == place.y) {
            continue;
        }
        for (int x = left; x < left + 2 * CHUNK; x += 2 * LANES) {
            shade_pair(shader, &u, v, &s, x, place.y);
        }
    }
}

/* ---- A function for each way and each look ---- */

/* The compiler must not know whom they call. */
#define WAYS_OF(look)                                                                              \
    static FLATTEN void look##_inlined(const struct visible *v, const void *planes) {              \
        shade_chunks(EACH_PIXEL, &(look), (look).fragment, v, planes);                             \
    }                                                                                              \
    static FLATTEN void look##_every_8(const struct visible *v, const void *planes) {              \
        shade_chunks(EVERY_8, &(look), (look).fragment, v, planes);                                \
    }                                                                                              \
    static FLATTEN void look##_every_16(const struct visible *v, const void *planes) {             \
        shade_chunks(EVERY_16, &(look), (look).fragment, v, planes);                               \
    }                                                                                              \
    static FLATTEN void look##_affine(const struct visible *v, const void *planes) {               \
        shade_chunks(NEVER, &(look), (look).fragment, v, planes);                                  \
    }                                                                                              \
    static FLATTEN void look##_half(const struct visible *v, const void *planes) {                 \
        shade_half(&(look), v, planes);                                                            \
    }                                                                                              \
    static void look##_call(const struct visible *v, const void *planes) {                         \
        fragment_function *volatile hidden = (look).fragment;                                      \
        shade_chunks(EACH_PIXEL, &(look), hidden, v, planes);                                      \
    }                                                                                              \
    static FLATTEN void look##_one_run(const struct uniforms *u, const struct visible *v,          \
                                       const struct planes *planes, const struct run *run) {       \
        shade_run(&(look), u, v, planes, run);                                                     \
    }                                                                                              \
    static void look##_run(const struct visible *v, const void *planes) {                          \
        shade_run_function *volatile hidden = look##_one_run;                                      \
        shade_runs(hidden, v, planes);                                                             \
    }

WAYS_OF(gouraud_textured)
WAYS_OF(gouraud)

#define ROW_OF_WAYS(look)                                                                          \
    {                                                                                              \
        .make_planes = make_planes, .call = look##_call, .run = look##_run,                        \
        .inlined = look##_inlined, .every_8 = look##_every_8, .every_16 = look##_every_16,         \
        .affine = look##_affine, .half = look##_half                                               \
    }

const struct ways WAYS[LOOKS] = {ROW_OF_WAYS(gouraud_textured), ROW_OF_WAYS(gouraud)};
