/*
 * Step 8: precision on the way to the screen, inverses, perspective inside a triangle, clipping.
 *
 * The exact answers are long double; for the clipped picture they come from a ray through every
 * pixel, which needs no clipping and no snapping.
 */
#define main step08_main
int step08_main(int argc, char **argv);
#include "../../step08_projection/main.c"
#undef main

#include "../../step08_projection/attempts.h"

#include "bench.h"

enum { SIDE = 800, CAMERAS = 2, MATRICES = 64, WALL_SIDE = 256, CUBE_CORNERS = 8 };

struct camera {
    struct vec3 eye, center, up;
};

/* Those of scenes lookat and closeup. */
static const struct camera cameras[CAMERAS] = {
    {{1, 1, 2}, {0, 0, 0}, {0, 1, 0}},
    {{0.03, 0.47, 0.46}, {0.03, -0.3, 0.4}, {0, 0, 1}},
};

/* What a ray finds behind the centre of a pixel. */
struct found {
    long double depth;     /* z/w; minus infinity where there is nothing */
    long double tolerance; /* what the depth may be off when corners are moved by 1/128 pixel */
};

struct work {
    struct model model;
    struct state state; /* of the lesson's program */
    struct drawing drawing;
    double *depth;
    struct image image;
    struct mat4 to_clip[CAMERAS], to_screen;
    struct vec2 *screen; /* one a position of the model */
    struct mat4 matrices[MATRICES], inverses[MATRICES];
    bool inverted[MATRICES];
    struct texture tiles;
    struct vertex wall[4];
    struct vec4 wall_clip[4];
    struct found *found; /* in scene closeup */
};

/* ---- Corners to the screen ---- */

enum { IN_FLOAT, IN_DOUBLE };

static void run_chain(void *state, int choice) {
    struct work *work = state;
    const struct mat4 to_screen = work->to_screen;
    for (int k = 0; k < CAMERAS; k++) {
        const struct mat4 to_clip = work->to_clip[k];
        for (size_t i = 0; i < work->model.position_count; i++) {
            struct vec3 point = work->model.positions[i];
            work->screen[i] = choice == IN_FLOAT ? attempt_1_float(&to_clip, &to_screen, point)
                                                 : attempt_2_double(&to_clip, &to_screen, point);
        }
    }
}

static double units_chain(const void *state) {
    return (double)CAMERAS * (double)((const struct work *)state)->model.position_count;
}

static long double larger(long double a, long double b) {
    return a > b ? a : b;
}

/* The largest error of what can be seen. */
static double error_chain(void *state, int choice) {
    const struct work *work = state;
    long double worst = 0;
    for (int k = 0; k < CAMERAS; k++) {
        const struct mat4 *to_clip = &work->to_clip[k];
        for (size_t i = 0; i < work->model.position_count; i++) {
            struct vec3 point = work->model.positions[i];
            long double exact[2];
            if (find_beyond(mat4_point(to_clip, point)) != 0) {
                continue;
            }
            struct vec2 screen = choice == IN_FLOAT
                                     ? attempt_1_float(to_clip, &work->to_screen, point)
                                     : attempt_2_double(to_clip, &work->to_screen, point);
            attempt_exact(to_clip, &work->to_screen, point, exact);
            worst = larger(worst, fabsl(screen.x - exact[0]));
            worst = larger(worst, fabsl(screen.y - exact[1]));
        }
    }
    return (double)worst * SUBPIXELS;
}

/* ---- Inverses ---- */

enum { COFACTORS_FLOAT, COFACTORS, ELIMINATION };

static attempt_inverse *const inverters[] = {
    [COFACTORS_FLOAT] = attempt_4_cofactors_float,
    [COFACTORS] = attempt_3_cofactors,
    [ELIMINATION] = mat4_inverse,
};

/* World to clip for cameras near and far, and for models that are flatter and flatter. */
static void make_matrices(struct work *work) {
    for (int i = 0; i < MATRICES; i++) {
        double flat = 1.0 / (1 << (i % 16)), distance = 1 << (i / 16);
        struct vec2 d = turn_direction(i / 16.0 + 0.03);
        struct vec3 eye = {distance * d.x, distance * (0.3 + d.y), distance * d.y};
        struct mat4 view = lookat(eye, (struct vec3){0, 0, 0}, (struct vec3){0, 1, 0});
        struct mat4 tilted = mat4_rotation((struct vec3){1, 2, 3}, 0.1);
        struct mat4 squeezed = mat4_mul(mat4_scaling((struct vec3){1, flat, 1}), tilted);
        work->matrices[i] = mat4_mul(mat4_mul(projection(vec3_length(eye)), view), squeezed);
    }
}

static void run_inverse(void *state, int choice) {
    struct work *work = state;
    for (int i = 0; i < MATRICES; i++) {
        work->inverted[i] = inverters[choice](work->matrices[i], &work->inverses[i]);
    }
}

static double units_inverse(const void *state) {
    (void)state;
    return MATRICES;
}

static void apply_exactly(const struct mat4 *a, const long double p[4], long double result[4]) {
    for (int row = 0; row < 4; row++) {
        result[row] = 0;
        for (int k = 0; k < 4; k++) {
            result[row] += a->m[row][k] * p[k];
        }
    }
}

/* From a point to clip space, back by the inverse, and to clip space again, all but the inverse in
 * long double: how far on the screen is it from where it was? */
static long double there_and_back(const struct mat4 *to_clip, const struct mat4 *inverse,
                                  const long double point[4]) {
    long double before[4], back[4], after[4], worst = 0;
    apply_exactly(to_clip, point, before);
    apply_exactly(inverse, before, back);
    apply_exactly(to_clip, back, after);
    if (before[3] < near_w) {
        return 0; /* behind the camera */
    }
    for (int k = 0; k < 2; k++) {
        worst = larger(worst, fabsl(after[k] / after[3] - before[k] / before[3]));
    }
    return worst * SIDE / 2 * SUBPIXELS;
}

static double error_inverse(void *state, int choice) {
    struct work *work = state;
    long double worst = 0;
    run_inverse(state, choice);
    for (int i = 0; i < MATRICES; i++) {
        for (int k = 0; k < CUBE_CORNERS; k++) {
            const long double point[4] = {k & 1 ? 0.5L : -0.5L, k & 2 ? 0.5L : -0.5L,
                                          k & 4 ? 0.5L : -0.5L, 1};
            if (!work->inverted[i]) {
                return (double)INFINITY;
            }
            worst = larger(worst, there_and_back(&work->matrices[i], &work->inverses[i], point));
        }
    }
    return (double)worst;
}

/* ---- Perspective inside a triangle: a wall of two triangles ---- */

enum { AFFINE, CORRECT };

static bool make_wall(struct work *work, struct error *error) {
    static const struct vec3 corners[4] = {
        {-0.9, -0.47, 1.07}, {0.93, -0.47, -1.9}, {0.93, 0.43, -1.9}, {-0.9, 0.43, 1.07}};
    struct image image;
    struct mat4 to_clip = projection(2);
    for (int i = 0; i < 4; i++) {
        work->wall_clip[i] = mat4_point(&to_clip, corners[i]);
        place(work->wall_clip[i], &work->to_screen, &work->wall[i]);
        work->wall[i].uv = (struct vec2){i == 1 || i == 2, i >= 2};
        work->wall[i].intensity = 1;
    }
    if (!image_create(&image, WALL_SIDE, WALL_SIDE, IMAGE_BGR, error)) {
        return false;
    }
    for (int y = 0; y < WALL_SIDE; y++) {
        for (int x = 0; x < WALL_SIDE; x++) {
            image_set(&image, x, y, color_grey((x / 32 + y / 32) % 2 == 0 ? 230 : 60));
        }
    }
    bool done = texture_create(&work->tiles, &image, error);
    image_free(&image);
    return done;
}

/* One half of the wall: corners 0, 1, 2 or 0, 2, 3. */
static bool wall_half(const struct work *work, int half, struct vertex v[3], struct vec4 clip[3],
                      struct edges *edges) {
    for (int i = 0; i < 3; i++) {
        int corner = i == 0 ? 0 : i + half;
        v[i] = work->wall[corner];
        clip[i] = work->wall_clip[corner];
    }
    return edges_setup(edges, v[0].position, v[1].position, v[2].position, SIDE, SIDE);
}

static void run_wall(void *state, int choice) {
    struct work *work = state;
    struct canvas canvas = make_canvas(&work->drawing, &work->image, whole_image(&work->image));
    canvas.texture = &work->tiles;
    depth_clear(work->depth, (size_t)SIDE * SIDE);
    for (int half = 0; half < 2; half++) {
        struct vertex v[3];
        struct vec4 clip[3];
        struct edges edges;
        if (wall_half(work, half, v, clip, &edges)) {
            (choice == AFFINE ? attempt_12_affine_triangle : triangle)(&canvas, &edges, v);
        }
    }
}

static double units_wall(const void *state) {
    double pixels = 0;
    for (int half = 0; half < 2; half++) {
        struct vertex v[3];
        struct vec4 clip[3];
        struct edges edges;
        bool seen = wall_half(state, half, v, clip, &edges);
        for (int y = edges.y_begin; seen && y < edges.y_end; y++) {
            struct span span = edges_span(&edges, y);
            pixels += span.begin < span.end ? span.end - span.begin : 0;
        }
    }
    return pixels;
}

/* How far from the centre of a pixel does the point lie that the weights give? */
static long double weights_error(struct vec3 weight, const struct vec4 clip[3], int x, int y) {
    long double p[3] = {0, 0, 0};
    const double w[3] = {weight.x, weight.y, weight.z};
    for (int i = 0; i < 3; i++) {
        p[0] += (long double)w[i] * clip[i].x;
        p[1] += (long double)w[i] * clip[i].y;
        p[2] += (long double)w[i] * clip[i].w;
    }
    long double right = (p[0] / p[2] + 1) * SIDE / 2 - (x + 0.5L);
    long double up = (p[1] / p[2] + 1) * SIDE / 2 - (y + 0.5L);
    return sqrtl(right * right + up * up) * SUBPIXELS;
}

static double error_wall(void *state, int choice) {
    const struct work *work = state;
    long double worst = 0;
    for (int half = 0; half < 2; half++) {
        struct vertex v[3];
        struct vec4 clip[3];
        struct edges edges;
        if (!wall_half(work, half, v, clip, &edges)) {
            continue;
        }
        const double recip_w[3] = {v[0].recip_w, v[1].recip_w, v[2].recip_w};
        for (int y = edges.y_begin; y < edges.y_end; y++) {
            struct span span = edges_span(&edges, y);
            for (int x = span.begin; x < span.end; x++) {
                struct vec3 weight = edges_weights(&edges, x, y);
                weight = choice == AFFINE ? weight : correct_weights(weight, recip_w);
                worst = larger(worst, weights_error(weight, clip, x, y));
            }
        }
    }
    return (double)worst;
}

/* ---- Clipping: scene closeup ---- */

enum { UNCLIPPED, LEFT_OUT, CLIPPED };

static attempt_draw *const draws[] = {
    [UNCLIPPED] = attempt_6_unclipped, [LEFT_OUT] = attempt_7_left_out, [CLIPPED] = draw_model};

static void run_clip(void *state, int choice) {
    struct work *work = state;
    struct canvas canvas = make_canvas(&work->drawing, &work->image, whole_image(&work->image));
    depth_clear(work->depth, (size_t)SIDE * SIDE);
    work->drawing.counter_count = 0;
    draws[choice](&work->drawing, &canvas, &work->to_clip[1]);
}

/* A face as rays see it: the ray through ndc (x, y) meets its plane at the sum of weight[i] times
 * corner i, where each weight is a linear function of x and y. The point's w is 1 / (sum of the
 * weights), so behind the camera it is negative. (Olano and Greer, "Triangle Scan Conversion using
 * 2D Homogeneous Coordinates", 1997.) */
struct ray_face {
    long double weight[3][3]; /* times x, times y, and what is added */
    long double z[3];
};

/* False where the face is seen from behind, or from the side. */
static bool make_ray_face(const struct vec4 clip[3], struct ray_face *face) {
    long double c[3][3], determinant = 0;
    for (int i = 0; i < 3; i++) {
        c[i][0] = clip[i].x;
        c[i][1] = clip[i].y;
        c[i][2] = clip[i].w;
        face->z[i] = clip[i].z;
    }
    for (int i = 0; i < 3; i++) {
        const long double *a = c[(i + 1) % 3], *b = c[(i + 2) % 3];
        face->weight[i][0] = a[1] * b[2] - a[2] * b[1];
        face->weight[i][1] = a[2] * b[0] - a[0] * b[2];
        face->weight[i][2] = a[0] * b[1] - a[1] * b[0];
    }
    for (int k = 0; k < 3; k++) {
        determinant += c[0][k] * face->weight[0][k];
    }
    for (int i = 0; i < 3 && determinant > 0; i++) {
        for (int k = 0; k < 3; k++) {
            face->weight[i][k] /= determinant;
        }
    }
    return determinant > 0;
}

struct box {
    struct span columns, rows;
};

/* Keep the face where it is nearest so far. */
static void find_face(const struct ray_face *face, struct box box, struct found *found) {
    long double right = 0, up = 0; /* what the depth gains */
    for (int i = 0; i < 3; i++) {
        right += face->weight[i][0] * face->z[i];
        up += face->weight[i][1] * face->z[i];
    }
    for (int y = box.rows.begin; y < box.rows.end; y++) {
        for (int x = box.columns.begin; x < box.columns.end; x++) {
            long double ndc_x = (x + 0.5L) * 2 / SIDE - 1, ndc_y = (y + 0.5L) * 2 / SIDE - 1;
            long double sum = 0, depth = 0;
            bool inside = true;
            for (int i = 0; i < 3; i++) {
                const long double *f = face->weight[i];
                long double weight = f[0] * ndc_x + f[1] * ndc_y + f[2];
                inside = inside && weight >= 0;
                sum += weight;
                depth += weight * face->z[i];
            }
            struct found *here = &found[y * SIDE + x];
            if (inside && sum * near_w <= 1 && depth > here->depth) {
                *here = (struct found){depth, (fabsl(right) + fabsl(up)) * 2 / SIDE / 128};
            }
        }
    }
}

/* Let a span of pixels reach this place. */
static void widen(struct span *span, double place) {
    int first = (int)fmin(fmax(place, 0), SIDE), end = (int)fmin(fmax(place, 0) + 1, SIDE);
    span->begin = first < span->begin ? first : span->begin;
    span->end = end > span->end ? end : span->end;
}

/* Where a face may be seen: everywhere when it reaches behind the near plane. */
static struct box face_box(const struct vec4 clip[3]) {
    struct box box = {.columns = {SIDE, 0}, .rows = {SIDE, 0}};
    for (int i = 0; i < 3; i++) {
        if (clip[i].w < near_w) {
            return (struct box){.columns = {0, SIDE}, .rows = {0, SIDE}};
        }
        widen(&box.columns, (clip[i].x / clip[i].w + 1) * SIDE / 2);
        widen(&box.rows, (clip[i].y / clip[i].w + 1) * SIDE / 2);
    }
    return box;
}

static void find_all(struct work *work) {
    for (int i = 0; i < SIDE * SIDE; i++) {
        work->found[i] = (struct found){-(long double)INFINITY, 0};
    }
    for (size_t face = 0; face < work->model.face_count; face++) {
        struct vec4 clip[3];
        struct ray_face ray_face;
        bool in_front = false;
        for (size_t i = 0; i < 3; i++) {
            clip[i] = mat4_point(&work->to_clip[1], model_position(&work->model, face, i));
            in_front = in_front || clip[i].w >= near_w;
        }
        if (in_front && make_ray_face(clip, &ray_face)) {
            find_face(&ray_face, face_box(clip), work->found);
        }
    }
}

/* Pixels whose depth is not that of the exact point, or that show something where nothing is. */
static double error_clip(void *state, int choice) {
    struct work *work = state;
    size_t wrong = 0;
    run_clip(state, choice);
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        long double depth = work->depth[i], exact = work->found[i].depth;
        bool right = isinf(exact) ? depth == exact
                                  : fabsl(depth - exact) <= work->found[i].tolerance + 1e-9L;
        wrong += !right;
    }
    return (double)wrong;
}

/* ---- Setting up ---- */

static bool make_state(struct work *work, struct error *error) {
    struct model *model = &work->model;
    if (!bench_read_model(model, "bust.obj", error) || !model_need_normals(model, error)) {
        return false;
    }
    work->depth = malloc((size_t)SIDE * SIDE * sizeof *work->depth);
    work->screen = calloc(model->position_count, sizeof *work->screen);
    work->found = malloc((size_t)SIDE * SIDE * sizeof *work->found);
    if (work->depth == NULL || work->screen == NULL || work->found == NULL) {
        return error_out_of_memory(error);
    }
    work->drawing = (struct drawing){
        .model = model,
        .diffuse = model_texture(model, MODEL_DIFFUSE, error),
        .depth = work->depth,
        .light = {1, 1, 2},
        .skip = true,
        .state = &work->state,
    };
    return work->drawing.diffuse != NULL && prepare(&work->drawing, SIDE, SIDE, error) &&
           image_create(&work->image, SIDE, SIDE, IMAGE_BGR, error);
}

static bool setup(void **state, struct error *error) {
    struct work *work = calloc(1, sizeof *work);
    *state = work;
    if (work == NULL) {
        return error_out_of_memory(error);
    }
    for (int i = 0; i < CAMERAS; i++) {
        struct vec3 eye = cameras[i].eye, center = cameras[i].center;
        work->to_clip[i] = mat4_mul(projection(vec3_length(vec3_sub(eye, center))),
                                    lookat(eye, center, cameras[i].up));
    }
    work->to_screen = viewport(SIDE, SIDE);
    make_matrices(work);
    if (!make_state(work, error) || !make_wall(work, error)) {
        return false;
    }
    find_all(work);
    return true;
}

static void teardown(void *state) {
    struct work *work = state;
    if (work != NULL) {
        free(work->state.positions);
        free(work->depth);
        model_free(&work->model);
        image_free(&work->image);
        texture_free(&work->tiles);
        free(work->screen);
        free(work->found);
    }
    free(work);
}

/* ---- The panels ---- */

#define VERSION(label, of, number, house)                                                          \
    {                                                                                              \
        .name = (label), .choice = (number), .is_house = (house), .run = run_##of,                 \
        .error = error_##of                                                                        \
    }

static const struct bench_version chain_versions[] = {
    VERSION("float", chain, IN_FLOAT, false),
    VERSION("double", chain, IN_DOUBLE, true),
};

static const struct bench_version inverse_versions[] = {
    VERSION("cofactors, float", inverse, COFACTORS_FLOAT, false),
    VERSION("cofactors, double", inverse, COFACTORS, false),
    VERSION("elimination, double", inverse, ELIMINATION, true),
};

static const struct bench_version wall_versions[] = {
    VERSION("affine", wall, AFFINE, false),
    VERSION("perspective-correct", wall, CORRECT, true),
};

static const struct bench_version clip_versions[] = {
    VERSION("not clipped", clip, UNCLIPPED, false),
    VERSION("crossing faces left out", clip, LEFT_OUT, false),
    VERSION("clipped", clip, CLIPPED, true),
};

static const struct bench_panel bench_panels[] = {
    {.title = "Corners of the bust to the screen, by two cameras",
     .error_label = "1/256 pixel, the largest",
     .time_label = "ns per corner",
     .against = "long double",
     .units = units_chain,
     .versions = chain_versions,
     .version_count = sizeof chain_versions / sizeof chain_versions[0]},
    {.title = "Inverse of 64 cameras, some of flat models",
     .error_label = "1/256 pixel, the largest, there and back",
     .time_label = "ns per inverse",
     .against = "long double",
     .units = units_inverse,
     .versions = inverse_versions,
     .version_count = sizeof inverse_versions / sizeof inverse_versions[0]},
    {.title = "A wall of two triangles",
     .error_label = "1/256 pixel, the largest",
     .time_label = "ns per pixel",
     .against = "long double",
     .units = units_wall,
     .versions = wall_versions,
     .version_count = sizeof wall_versions / sizeof wall_versions[0]},
    {.title = "Close up: faces reach behind the camera, 800x800 pixels",
     .error_label = "pixels wrong of 640,000",
     .time_label = "ms per frame",
     .against = "rays, long double",
     .versions = clip_versions,
     .version_count = sizeof clip_versions / sizeof clip_versions[0]},
};

const struct bench_lesson bench_step08 = {
    .step = "step08_projection",
    .title = "Step 8: perspective",
    .setup = setup,
    .teardown = teardown,
    .panels = bench_panels,
    .panel_count = sizeof bench_panels / sizeof bench_panels[0],
};
