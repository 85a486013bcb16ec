/*
 * Step 9: how a shader's pixels are computed and called, what is shaded and by how many threads.
 *
 * The first two panels shade the same list of visible pixels, which is found once; the loops are
 * those of step09_loops.h. The last one is the pipeline as it is. All are judged by the same exact
 * picture: what is visible decided by whole numbers and double, its colours found in long double.
 */
#define LESSON "../step09_shaders/main.c"
#include "lesson.h"

#include "../../../step09_shaders/attempts.h"

#include "base/array.h"
#include "bench/bench.h"
#include "bench/frame/child.h"
#include "files/model_file.h"
#include "files/normals.h"
#include "oracle/oracle.h"
#include "ways.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROW_OF_BUSTS = 4, INTENSITY = 2 };

/* A model with its shader's uniforms, what is visible of it, and the exact pictures (BGRA, black
 * where nothing is). */
struct subject {
    struct model model;
    struct uniforms uniforms;
    struct draw_call call;
    struct visible visible;
    struct image exact[LOOKS];
};

/* What the pipeline draws on, and with. */
struct target {
    struct pipeline pipeline;
    struct image image;
};

/* With one thread, with two, and with half of the width and height. */
enum { ONE_THREAD, TWO_THREADS, HALF_OF_IT, TARGETS };

/* Mesa's renderer: what it draws, and with how many threads. */
enum peer { PEER_FAR_FIRST, PEER_NEAR_FIRST, PEER_TWO_THREADS, PEERS };

enum way {
    SINGLE_CALL,
    SINGLE_RUN,
    SINGLE,
    SIXTEEN_CALL,
    SIXTEEN_RUN,
    SIXTEEN,
    IN_DOUBLE,
    DIVISION_EVERY_8,
    DIVISION_EVERY_16,
    AFFINE,
    HALF_RATE,
    WAYS
};

struct work {
    struct subject bust, far_first, near_first; /* one bust, and rows of them */
    void *planes[LOOKS][WAYS];
    enum look drawn_look; /* by the last version of the first two panels */
    bool drawn;           /* by the last version, without running out of memory */
    struct target targets[TARGETS];
    struct image enlarged; /* from half of the width and height */
    struct child peers[PEERS];
    bool has_peers;
    /* What simple_draw() and its attempts draw on, and with. */
    struct image simple_image;
    double *depth;
    struct attempt_memory memory;
};

/* ---- The visible pixels, in so many ways ---- */

struct chosen {
    const struct ways *ways;
    enum planes_kind kind;
    shade_way *shade;
};

static struct chosen choose(enum look look, enum way way) {
    const struct ways *f = &ways_float[look], *s = &ways_single[look], *d = &ways_double[look];
    const struct chosen all[WAYS] = {
        [SINGLE_CALL] = {s, AS_THEY_ARE, s->call},
        [SINGLE_RUN] = {s, AS_THEY_ARE, s->run},
        [SINGLE] = {s, AS_THEY_ARE, s->inlined},
        [SIXTEEN_CALL] = {f, AS_THEY_ARE, f->call},
        [SIXTEEN_RUN] = {f, AS_THEY_ARE, f->run},
        [SIXTEEN] = {f, AS_THEY_ARE, f->inlined},
        [IN_DOUBLE] = {d, AS_THEY_ARE, d->inlined},
        [DIVISION_EVERY_8] = {f, AS_THEY_ARE, f->every_8},
        [DIVISION_EVERY_16] = {f, AS_THEY_ARE, f->every_16},
        [AFFINE] = {f, FLAT_ON_SCREEN, f->affine},
        [HALF_RATE] = {f, EVERY_SECOND, f->half},
    };
    return all[way];
}

/* A choice is a way and, times WAYS, a look. */
static void run_pixels(void *state, int choice) {
    struct work *work = state;
    work->drawn_look = (enum look)(choice / WAYS);
    struct chosen chosen = choose(work->drawn_look, (enum way)(choice % WAYS));
    chosen.shade(&work->bust.visible, work->planes[work->drawn_look][choice % WAYS]);
}

static double units_pixels(const void *state, int base) {
    (void)base;
    return (double)((const struct work *)state)->bust.visible.pixels;
}

/* ---- How far a picture is from the exact one ---- */

struct levels_off {
    double mean; /* of the channels of the pixels that either shows */
    int largest;
};

static struct levels_off compare(const struct image *image, const struct image *exact) {
    struct levels_off off = {0, 0};
    double sum = 0, count = 0;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        const uint8_t *a = image->pixels + i * image->format, *b = exact->pixels + i * IMAGE_BGRA;
        int here = 0;
        for (int k = 0; k < 3; k++) {
            int difference = abs(a[k] - b[k]);
            sum += difference;
            here = difference > here ? difference : here;
        }
        count += (a[0] | a[1] | a[2] | b[0] | b[1] | b[2]) != 0 ? 3 : 0;
        off.largest = here > off.largest ? here : off.largest;
    }
    off.mean = sum / count;
    return off;
}

static struct levels_off pixels_off(const struct work *work) {
    return compare(&work->bust.visible.image, &work->bust.exact[work->drawn_look]);
}

static double error_pixels(void *state, int choice) {
    (void)choice;
    return pixels_off(state).mean;
}

static double size_pixels(const void *state, int choice) {
    (void)choice;
    return pixels_off(state).largest;
}

/* ---- The pipeline: at once or visible only, in which order, by how many threads ---- */

/* Each pixel of a small picture becomes a square of the large one. */
static void enlarge(const struct image *small, struct image *large) {
    size_t factor = large->width / small->width;
    for (size_t y = 0; y < large->height; y++) {
        for (size_t x = 0; x < large->width; x++) {
            memcpy(large->pixels + IMAGE_BGRA * (y * large->width + x),
                   small->pixels + IMAGE_BGRA * (y / factor * small->width + x / factor),
                   IMAGE_BGRA);
        }
    }
}

enum order { FAR_FIRST, NEAR_FIRST };
enum kind { CALLED, AT_ONCE, VISIBLE, KINDS };

/* The numbers of the pipeline's versions, and behind them those of llvmpipe's. */
#define ROW(kind, order, target) ((int)(kind) + (int)KINDS * ((int)(order) + 2 * (int)(target)))
#define PEER(peer)               (ROW(0, 0, TARGETS) + (int)(peer))

static bool draw_kind(enum kind kind, struct target *target, const struct draw_call *call,
                      const struct uniforms *u) {
    struct error error;
    struct shader called = attempt_3_called(&gouraud_textured);
    const struct shader *shaders[KINDS] = {&called, &attempt_4_at_once, &gouraud_textured};
    struct pipeline *p = &target->pipeline;
    p->shortcuts = kind == AT_ONCE ? SHORTCUTS & ~(unsigned)SHORTCUT_VISIBLE : SHORTCUTS;
    bool done = pipeline_draw(p, call, shaders[kind], u, sizeof *u, &error);
    return done && pipeline_finish(p, &target->image, &error);
}

static bool draw_row(struct target *target, const struct subject *row, enum kind kind) {
    struct draw_call call = row->call;
    struct uniforms uniforms = row->uniforms;
    call.viewport = grid_cell(target->image.width, target->image.height, 1, 1, 0, 0);
    uniforms.diffuse_level += target->image.width < SIDE; /* texels as large as pixels */
    pipeline_clear(&target->pipeline);
    memset(target->image.pixels, 0, target->image.width * target->image.height * IMAGE_BGRA);
    return draw_kind(kind, target, &call, &uniforms);
}

static void run_row(void *state, int choice) {
    struct work *work = state;
    struct target *target = &work->targets[choice / KINDS / 2];
    bool near_first = choice / KINDS % 2 == NEAR_FIRST;
    work->drawn = draw_row(target, near_first ? &work->near_first : &work->far_first,
                           (enum kind)(choice % KINDS));
    if (target->image.width < SIDE) {
        enlarge(&target->image, &work->enlarged);
    }
}

static double error_peer(const struct work *work, enum peer peer) {
    const struct child *child = &work->peers[peer];
    struct error error;
    if (!work->drawn || !child_read(child, &error)) {
        return (double)INFINITY;
    }
    const struct image image = {SIDE, SIDE, IMAGE_BGRA, child->pixels};
    return compare(&image, &work->far_first.exact[TEXTURED]).mean;
}

static double error_row(void *state, int choice) {
    const struct work *work = state;
    if (choice >= PEER(0)) {
        return error_peer(work, (enum peer)(choice - PEER(0)));
    }
    const struct image *image = &work->targets[choice / KINDS / 2].image;
    image = image->width < SIDE ? &work->enlarged : image;
    return work->drawn ? compare(image, &work->far_first.exact[TEXTURED]).mean : (double)INFINITY;
}

static double run_peer(void *state, int choice) {
    struct work *work = state;
    struct error error;
    double seconds;
    work->drawn = child_draw(&work->peers[choice - PEER(0)], &seconds, &error);
    return work->drawn ? seconds : (double)INFINITY;
}

static double size_peer(const struct work *work, enum peer peer) {
    struct error error;
    uint64_t passed;
    return child_count(&work->peers[peer], &passed, &error) ? (double)passed / 1000 : 0;
}

/* Pixels shaded. */
static double size_row(const void *state, int choice) {
    const struct work *work = state;
    if (choice >= PEER(0)) {
        return size_peer(work, (enum peer)(choice - PEER(0)));
    }
    const struct pipeline *pipeline = &work->targets[choice / KINDS / 2].pipeline;
    return (double)pipeline->stats[STAT_PIXELS_SHADED] / 1000;
}

/* ---- From simple_draw() to the pipeline ---- */

enum stage { SIMPLE, POSITIONS_ONCE, VISIBLE_FIRST, SIMPLE_STAGES };

#define STAGE(row) ((int)SIMPLE_STAGES + (row))

static void draw_stage(struct work *work, enum stage stage, const struct simple_shader *shader,
                       const void *uniforms) {
    const size_t pixels = (size_t)SIDE * SIDE;
    const struct canvas canvas = {&work->simple_image, work->depth};
    const struct draw_call *call = &work->far_first.call;
    memset(work->simple_image.pixels, 0, pixels * IMAGE_BGRA);
    depth_clear(work->depth, pixels);
    if (stage == SIMPLE) {
        simple_draw(&canvas, call, shader, uniforms);
    } else if (stage == POSITIONS_ONCE) {
        attempt_1_positions_once(&canvas, call, shader, uniforms, &work->memory);
    } else {
        memset(work->memory.nearest, 0, pixels * sizeof *work->memory.nearest);
        attempt_2_visible_first(&canvas, call, shader, uniforms, &work->memory);
    }
}

static void run_stage(void *state, int choice) {
    struct work *work = state;
    if (choice >= SIMPLE_STAGES) {
        run_row(state, choice - SIMPLE_STAGES);
    } else {
        draw_stage(work, (enum stage)choice, &simple_gouraud_textured, &work->far_first.uniforms);
    }
}

static double error_stage(void *state, int choice) {
    const struct work *work = state;
    return choice >= SIMPLE_STAGES
               ? error_row(state, choice - SIMPLE_STAGES)
               : compare(&work->simple_image, &work->far_first.exact[TEXTURED]).mean;
}

/* The lesson's shader that counts its pixels. */
struct counting_uniforms {
    struct uniforms u; /* first, so that the shader finds what it knows */
    uint64_t *count;
};

static bool counting_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    const struct counting_uniforms *u = uniforms;
    ++*u->count;
    return textured_pixel(&u->u, varyings, rgb);
}

static double size_stage(const void *state, int choice) {
    struct work work = *(const struct work *)state;
    const struct simple_shader counting = {3, gouraud_textured_vertex, counting_pixel};
    uint64_t count = 0;
    const struct counting_uniforms uniforms = {work.far_first.uniforms, &count};
    if (choice >= SIMPLE_STAGES) {
        return size_row(state, choice - SIMPLE_STAGES);
    }
    draw_stage(&work, (enum stage)choice, &counting, &uniforms);
    return (double)count / 1000;
}

/* ---- Setting up ---- */

static bool make_face(struct seen *seen, const struct subject *subject, size_t face) {
    seen->face = (uint32_t)face;
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

/* There are at most as many runs, and as many chunks with a visible pixel, as pixels. */
static void find_row_runs(struct visible *v, int y) {
    const uint32_t *row = v->number + y * SIDE;
    for (struct span span = {0, 0}; span.begin < SIDE; span.begin = span.end) {
        while (span.end < SIDE && row[span.end] == row[span.begin]) {
            span.end++;
        }
        if (row[span.begin] != 0) {
            v->runs[v->run_count++] = (struct run){row[span.begin], span, y};
            v->pixels += (size_t)(span.end - span.begin);
        }
    }
}

static void find_places(struct visible *v, int y) {
    const uint32_t *row = v->number + y * SIDE;
    for (int x = 0; x < SIDE; x += CHUNK) {
        uint32_t any = 0;
        for (int i = 0; i < CHUNK; i++) {
            any |= row[x + i];
        }
        if (any != 0) {
            v->places[v->place_count++] = (struct place){x, y};
        }
    }
}

static bool find_visible(struct subject *subject, struct error *error) {
    struct visible *v = &subject->visible;
    size_t pixels = (size_t)SIDE * SIDE;
    double *depths = malloc(pixels * sizeof *depths);
    *v = (struct visible){
        .model = &subject->model,
        .to_clip = subject->call.to_clip,
        .diffuse = subject->uniforms.diffuse,
        .diffuse_level = subject->uniforms.diffuse_level,
        .to_light = subject->uniforms.to_light,
        .faces = malloc(subject->model.face_count * sizeof *v->faces),
        .number = calloc(pixels + 1, sizeof *v->number),
        .same = malloc((subject->model.face_count + 1) * sizeof *v->same),
        .runs = malloc(pixels * sizeof *v->runs),
        .places = malloc(pixels * sizeof *v->places),
    };
    if (depths == NULL || v->faces == NULL || v->number == NULL || v->same == NULL ||
        v->runs == NULL || v->places == NULL) {
        free(depths);
        return error_out_of_memory(error);
    }
    depth_clear(depths, pixels);
    for (size_t i = 0; i < subject->model.face_count; i++) {
        struct seen *face = &v->faces[v->face_count];
        if (make_face(face, subject, i)) {
            cover(face, (uint32_t)++v->face_count, depths, v->number);
        }
    }
    free(depths);
    for (uint32_t i = 0; i <= v->face_count; i++) {
        v->same[i] = i;
    }
    for (int y = 0; y < SIDE; y++) {
        find_row_runs(v, y);
        find_places(v, y);
    }
    return image_create(&v->image, SIDE, SIDE, IMAGE_BGRA, error);
}

/* ---- The exact pictures ---- */

struct exact_place {
    size_t lower, upper;
    long double fraction;
};

static struct exact_place place_between(long double coordinate, size_t size) {
    long double last = (long double)(size - 1), place = coordinate * (long double)size - 0.5L;
    place = place < 0 ? 0 : place > last ? last : place;
    size_t lower = (size_t)place;
    return (struct exact_place){lower, lower + 1 < size ? lower + 1 : lower,
                                place - (long double)lower};
}

/* A channel of the bilinear sample. */
static long double exact_sample(const struct texture_level *level, long double u, long double v,
                                int shift) {
    struct exact_place x = place_between(u, level->width), y = place_between(v, level->height);
    const uint32_t *lower = level->texels + y.lower * level->pitch;
    const uint32_t *upper = level->texels + y.upper * level->pitch;
    long double a = lower[x.lower] >> shift & 255, b = lower[x.upper] >> shift & 255;
    long double c = upper[x.lower] >> shift & 255, d = upper[x.upper] >> shift & 255;
    long double below = a + (b - a) * x.fraction, above = c + (d - c) * x.fraction;
    return below + (above - below) * y.fraction;
}

static uint8_t exact_level(long double value) {
    return value >= 255 ? 255 : value > 0 ? (uint8_t)(value + 0.5L) : 0;
}

static void exact_pixel(struct subject *subject, const struct seen *face, int x, int y) {
    const struct texture *texture = subject->uniforms.diffuse;
    const struct texture_level *level = &texture->level[subject->uniforms.diffuse_level];
    long double at[VALUES];
    for (int k = 0; k < VALUES; k++) {
        at[k] = oracle_interpolate(face->corner, face->recip_w, face->value[k], x, y);
    }
    size_t first = IMAGE_BGRA * ((size_t)y * SIDE + (size_t)x);
    for (int k = 0; k < 3; k++) { /* blue, green, red */
        long double color = exact_sample(level, at[0], at[1], 8 * k);
        subject->exact[TEXTURED].pixels[first + (size_t)k] = exact_level(color * at[INTENSITY]);
        subject->exact[WHITE].pixels[first + (size_t)k] = exact_level(255 * at[INTENSITY]);
    }
}

static bool draw_exactly(struct subject *subject, struct error *error) {
    const struct visible *v = &subject->visible;
    if (!image_create(&subject->exact[TEXTURED], SIDE, SIDE, IMAGE_BGRA, error) ||
        !image_create(&subject->exact[WHITE], SIDE, SIDE, IMAGE_BGRA, error)) {
        return false;
    }
    for (size_t i = 0; i < v->run_count; i++) {
        for (int x = v->runs[i].span.begin; x < v->runs[i].span.end; x++) {
            exact_pixel(subject, &v->faces[v->runs[i].number - 1], x, v->runs[i].y);
        }
    }
    return true;
}

/* ---- Models ---- */

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
    frame_unit_normals(&subject->model);
    subject->uniforms = make_uniforms(&drawing, SIDE);
    subject->call = pipeline_call(&drawing, grid_cell(SIDE, SIDE, 1, 1, 0, 0), 0.85, CULL_BACK);
    return find_visible(subject, error) && draw_exactly(subject, error);
}

static bool make_row(struct subject *row, enum order order, struct error *error) {
    static const struct vec3 backwards = {-0.35, -0.1, -0.9};
    return bench_read_model(&row->model, "bust.obj", error) &&
           repeat_model(&row->model, ROW_OF_BUSTS, backwards, order, error) &&
           prepare_subject(row, error);
}

static bool make_targets(struct work *work, struct error *error) {
    bool done = image_create(&work->enlarged, SIDE, SIDE, IMAGE_BGRA, error);
    for (int i = 0; done && i < TARGETS; i++) {
        struct target *target = &work->targets[i];
        size_t side = i == HALF_OF_IT ? SIDE / 2 : SIDE;
        done = image_create(&target->image, side, side, IMAGE_BGRA, error) &&
               pipeline_create(&target->pipeline, side, side, error);
        pipeline_use_threads(&target->pipeline, i == TWO_THREADS ? 2 : 1);
    }
    return done;
}

/* When the row of busts is there. */
static bool make_memory(struct work *work, struct error *error) {
    const size_t pixels = (size_t)SIDE * SIDE;
    const size_t positions = work->far_first.model.position_count;
    work->depth = malloc(pixels * sizeof *work->depth);
    work->memory.nearest = malloc(pixels * sizeof *work->memory.nearest);
    work->memory.positions = malloc(positions * sizeof *work->memory.positions);
    if (work->depth == NULL || work->memory.nearest == NULL || work->memory.positions == NULL) {
        return error_out_of_memory(error);
    }
    return image_create(&work->simple_image, SIDE, SIDE, IMAGE_BGRA, error);
}

static bool start_peer(struct child *peer, const struct subject *row, int threads,
                       struct error *error) {
    const struct frame_model model = {.model = row->model};
    const struct frame_scene scene = {
        .look = FRAME_GOURAUD,
        .width = SIDE,
        .height = SIDE,
        .head = &model,
        .textures[MODEL_DIFFUSE] = {row->uniforms.diffuse, row->uniforms.diffuse_level},
        .call = row->call,
        .to_light = row->uniforms.to_light,
    };
    return child_start(peer, threads, (size_t)SIDE * SIDE, error) &&
           child_load(peer, &scene, error);
}

/* When the rows of busts are there. Without Mesa, or where it cannot draw, the others are measured
 * alone. */
static void start_peers(struct work *work) {
    struct error error;
    work->has_peers = llvmpipe != NULL;
    for (int i = 0; work->has_peers && i < PEERS; i++) {
        const struct subject *row = i == PEER_NEAR_FIRST ? &work->near_first : &work->far_first;
        work->has_peers = start_peer(&work->peers[i], row, i == PEER_TWO_THREADS ? 2 : 0, &error);
        if (!work->has_peers) {
            printf("llvmpipe is left out: %s\n", error.message);
        }
    }
}

static bool make_all_planes(struct work *work, struct error *error) {
    for (int i = 0; i < LOOKS * WAYS; i++) {
        enum look look = (enum look)(i / WAYS);
        struct chosen chosen = choose(look, (enum way)(i % WAYS));
        void *planes = chosen.ways->make_planes(&work->bust.visible, look, chosen.kind);
        work->planes[look][i % WAYS] = planes;
        if (planes == NULL) {
            return error_out_of_memory(error);
        }
    }
    return true;
}

static bool setup(void *state, struct error *error) {
    struct work *work = state;
    bool done = make_targets(work, error) &&
                bench_read_model(&work->bust.model, "bust.obj", error) &&
                prepare_subject(&work->bust, error) && make_all_planes(work, error) &&
                make_row(&work->far_first, FAR_FIRST, error) &&
                make_row(&work->near_first, NEAR_FIRST, error) && make_memory(work, error);
    if (done) {
        start_peers(work);
    }
    return done;
}

static void subject_free(struct subject *subject) {
    free(subject->visible.faces);
    free(subject->visible.number);
    free(subject->visible.same);
    free(subject->visible.runs);
    free(subject->visible.places);
    image_free(&subject->visible.image);
    image_free(&subject->exact[TEXTURED]);
    image_free(&subject->exact[WHITE]);
    model_free(&subject->model);
}

static void teardown(void *state) {
    struct work *work = state;
    subject_free(&work->bust);
    subject_free(&work->far_first);
    subject_free(&work->near_first);
    for (int i = 0; i < LOOKS * WAYS; i++) {
        free(work->planes[i / WAYS][i % WAYS]);
    }
    for (int i = 0; i < TARGETS; i++) {
        image_free(&work->targets[i].image);
        pipeline_free(&work->targets[i].pipeline);
    }
    for (int i = 0; i < PEERS; i++) {
        child_end(&work->peers[i]);
    }
    image_free(&work->enlarged);
    image_free(&work->simple_image);
    free(work->depth);
    free(work->memory.nearest);
    free(work->memory.positions);
}

/* ---- The panels ---- */

static const char *pixels_series(int choice) {
    int way = choice % WAYS;
    return way <= SINGLE                                         ? "one pixel"
           : way <= SIXTEEN                                      ? "sixteen"
           : way >= DIVISION_EVERY_8 && way <= DIVISION_EVERY_16 ? "division every"
                                                                 : NULL;
}

static const struct bench_version pixels_versions[] = {
    VERSION("call for each", SINGLE_CALL),
    VERSION("call for each run", SINGLE_RUN),
    VERSION("no call", SINGLE),
    VERSION("call for all 16", SIXTEEN_CALL),
    VERSION("call for each run", SIXTEEN_RUN),
    HOUSE_VERSION("no call", SIXTEEN),
    VERSION("sixteen, in double", IN_DOUBLE),
    VERSION("8 pixels", DIVISION_EVERY_8),
    VERSION("16 pixels", DIVISION_EVERY_16),
    VERSION("no division: affine", AFFINE),
    VERSION("every second pixel", HALF_RATE),
};

static const struct bench_version row_versions[] = {
    VERSION("at once, farthest first", ROW(AT_ONCE, FAR_FIRST, ONE_THREAD)),
    VERSION("at once, nearest first", ROW(AT_ONCE, NEAR_FIRST, ONE_THREAD)),
    VERSION("visible, called", ROW(CALLED, FAR_FIRST, ONE_THREAD)),
    HOUSE_VERSION("visible, farthest first", ROW(VISIBLE, FAR_FIRST, ONE_THREAD)),
    HOUSE_VERSION("visible, nearest first", ROW(VISIBLE, NEAR_FIRST, ONE_THREAD)),
    VERSION("at once, 2 threads", ROW(AT_ONCE, FAR_FIRST, TWO_THREADS)),
    HOUSE_VERSION("visible, 2 threads", ROW(VISIBLE, FAR_FIRST, TWO_THREADS)),
    VERSION("400x400, enlarged", ROW(VISIBLE, FAR_FIRST, HALF_OF_IT)),
    PEER_VERSION("llvmpipe, farthest first", PEER(PEER_FAR_FIRST)),
    PEER_VERSION("llvmpipe, nearest first", PEER(PEER_NEAR_FIRST)),
    PEER_VERSION("llvmpipe, 2 threads", PEER(PEER_TWO_THREADS)),
};

static size_t row_versions_here(const void *state) {
    const struct work *work = state;
    return sizeof row_versions / sizeof row_versions[0] - (work->has_peers ? 0 : PEERS);
}

static const struct bench_version stage_versions[] = {
    VERSION("stage 0: simple_draw()", SIMPLE),
    VERSION("stage 1: positions once", POSITIONS_ONCE),
    VERSION("stage 2: visible first", VISIBLE_FIRST),
    VERSION("stage 4: by 16, in bands", STAGE(ROW(CALLED, FAR_FIRST, ONE_THREAD))),
    HOUSE_VERSION("stage 5: no call", STAGE(ROW(VISIBLE, FAR_FIRST, ONE_THREAD))),
    HOUSE_VERSION("stage 6: 2 threads", STAGE(ROW(VISIBLE, FAR_FIRST, TWO_THREADS))),
};

/* A level in a thousand that is not the nearest. */
#define HOUSE_WITHIN 0.001

static const struct bench_panel bench_panels[] = {
    {.title = "From your draw() to the pipeline: four busts one behind another, textured",
     .error_label = "values of 0..255, mean",
     .time_label = "ms per frame",
     .against = "long double",
     .run = run_stage,
     .error = error_stage,
     BENCH_VERSIONS(stage_versions),
     .size = size_stage,
     .size_label = "thousand pixels shaded",
     .house_within = HOUSE_WITHIN},
    {.title = "The bust, Gouraud and texture: its visible pixels",
     .error_label = "values of 0..255, mean",
     .time_label = "ns per pixel",
     .against = "long double",
     .base = TEXTURED * WAYS,
     .run = run_pixels,
     .error = error_pixels,
     .units = units_pixels,
     BENCH_VERSIONS(pixels_versions),
     .series = pixels_series,
     .size = size_pixels,
     .size_label = "the largest difference",
     .house_within = HOUSE_WITHIN},
    {.title = "The same, Gouraud alone: a shader that does little",
     .error_label = "values of 0..255, mean",
     .time_label = "ns per pixel",
     .against = "long double",
     .base = WHITE * WAYS,
     .run = run_pixels,
     .error = error_pixels,
     .units = units_pixels,
     BENCH_VERSIONS(pixels_versions),
     .series = pixels_series,
     .size = size_pixels,
     .size_label = "the largest difference",
     .house_within = HOUSE_WITHIN},
    {.title = "Four busts one behind another, textured: the pipeline, 800x800 pixels",
     .error_label = "values of 0..255, mean",
     .time_label = "ms per frame",
     .against = "long double",
     .run = run_row,
     .error = error_row,
     BENCH_VERSIONS(row_versions),
     .size = size_row,
     .size_label = "thousand pixels shaded",
     .versions_here = row_versions_here,
     .run_elsewhere = run_peer,
     .house_within = HOUSE_WITHIN},
};

const struct bench_lesson bench_step09 = {
    .step = "step09_shaders",
    .title = "Step 9: shaders",
    .state_size = sizeof(struct work),
    .setup = setup,
    .teardown = teardown,
    .panels = bench_panels,
    .panel_count = sizeof bench_panels / sizeof bench_panels[0],
};
