/*
 * Lesson 4's benchmark: ways to find the intensity of a face, against long double.
 *
 * The error is the largest difference of a grey level (before it is rounded to a whole one) over
 * all faces and a few directions of the light. The second panel has the same faces on a tiny model,
 * whose squared lengths are too small for a float.
 */
#define main step04_main
int step04_main(int argc, char **argv);
#include "../../step04_flat/main.c"
#undef main

#include "../../step04_flat/attempts.h"

#include "bench.h"

#include <stdlib.h>

enum { LIGHT_COUNT = 4, HOUSE = 0 }; /* choices 1 to 7 are the attempts */

static const double tiny = 1e-12; /* size of the second model */

struct faces {
    struct model model, tiny_model;
    struct vec3 light[LIGHT_COUNT]; /* of length 1, as well as a double can say that */
    double *levels;                 /* one a face: what the last run found, 0..255 */
};

/* ---- The versions ---- */

typedef double intensity_function(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                  struct vec3 light);

/* Called with a constant function, so that compilers make a loop without calls of it. */
static inline void faces_shade(const struct model *model, struct vec3 light, double *levels,
                               intensity_function *intensity) {
    for (size_t face = 0; face < model->face_count; face++) {
        levels[face] =
            255 * intensity(model_position(model, face, 0), model_position(model, face, 1),
                            model_position(model, face, 2), light);
    }
}

static void faces_find_levels(const struct model *model, struct vec3 light, double *levels,
                              int choice) {
    switch (choice) {
    case 1:
        faces_shade(model, light, levels, attempt_1_not_normalized);
        break;
    case 2:
        faces_shade(model, light, levels, attempt_2_outward);
        break;
    case 3:
        faces_shade(model, light, levels, attempt_3_absolute);
        break;
    case 4:
        faces_shade(model, light, levels, attempt_4_float);
        break;
    case 5:
        faces_shade(model, light, levels, attempt_5_root_0);
        break;
    case 6:
        faces_shade(model, light, levels, attempt_6_root_1);
        break;
    case 7:
        faces_shade(model, light, levels, attempt_7_root_2);
        break;
    default:
        for (size_t face = 0; face < model->face_count; face++) {
            levels[face] = 255 * face_intensity(model, face, light);
        }
    }
}

static void run_usual(void *state, int choice) {
    struct faces *faces = state;
    faces_find_levels(&faces->model, faces->light[0], faces->levels, choice);
}

static void run_tiny(void *state, int choice) {
    struct faces *faces = state;
    faces_find_levels(&faces->tiny_model, faces->light[0], faces->levels, choice);
}

/* ---- The errors ---- */

struct long_vec3 {
    long double x, y, z;
};

static struct long_vec3 long_difference(struct vec3 a, struct vec3 b) {
    return (struct long_vec3){(long double)a.x - b.x, (long double)a.y - b.y,
                              (long double)a.z - b.z};
}

/* How directly light falls on a face: minus the cosine of the angle between the light's direction
 * and the outward normal. 0 for a face without area. */
static long double exact_intensity(const struct model *model, size_t face, struct vec3 light) {
    struct vec3 origin = model_position(model, face, 0);
    struct long_vec3 a = long_difference(model_position(model, face, 1), origin);
    struct long_vec3 b = long_difference(model_position(model, face, 2), origin);
    long double x = a.y * b.z - a.z * b.y, y = a.z * b.x - a.x * b.z, z = a.x * b.y - a.y * b.x;
    long double lx = light.x, ly = light.y, lz = light.z;
    long double length = sqrtl(x * x + y * y + z * z) * sqrtl(lx * lx + ly * ly + lz * lz);
    return length > 0 ? -(x * lx + y * ly + z * lz) / length : 0;
}

/* A level as the picture can show it; what is not a number is shown as 0. */
static double shown_level(double level) {
    return level > 0 ? fmin(level, 255) : 0;
}

static double faces_error(const struct faces *faces, const struct model *model, int choice) {
    double worst = 0;
    for (int i = 0; i < LIGHT_COUNT; i++) {
        struct vec3 light = faces->light[i];
        faces_find_levels(model, light, faces->levels, choice);
        for (size_t face = 0; face < model->face_count; face++) {
            long double exact = 255 * exact_intensity(model, face, light);
            long double right = exact > 0 ? exact : 0;
            double error = (double)fabsl(shown_level(faces->levels[face]) - right);
            worst = fmax(worst, error);
        }
    }
    return worst;
}

static double error_usual(void *state, int choice) {
    struct faces *faces = state;
    return faces_error(faces, &faces->model, choice);
}

static double error_tiny(void *state, int choice) {
    struct faces *faces = state;
    return faces_error(faces, &faces->tiny_model, choice);
}

/* ---- The lesson ---- */

static bool faces_setup(void **state, struct error *error) {
    static const struct vec3 directions[LIGHT_COUNT] = {
        {0, 0, -1}, {-1, -1, -1}, {3, -1, -2}, {-0.1, 1, -0.3}};
    struct faces *faces = calloc(1, sizeof *faces);
    *state = faces;
    if (faces == NULL) {
        return error_set(error, "out of memory for faces");
    }
    for (int i = 0; i < LIGHT_COUNT; i++) {
        faces->light[i] = vec3_normalized(directions[i]);
    }
    if (!bench_read_model(&faces->model, "bust.obj", error) ||
        !bench_read_model(&faces->tiny_model, "bust.obj", error)) {
        return false;
    }
    for (size_t i = 0; i < faces->tiny_model.position_count; i++) {
        struct vec3 *position = &faces->tiny_model.positions[i];
        *position = vec3_scale(*position, tiny);
    }
    faces->levels = calloc(faces->model.face_count + 1, sizeof *faces->levels);
    return faces->levels != NULL || error_set(error, "out of memory for levels");
}

static void faces_teardown(void *state) {
    struct faces *faces = state;
    if (faces != NULL) {
        model_free(&faces->model);
        model_free(&faces->tiny_model);
        free(faces->levels);
    }
    free(faces);
}

static double faces_units(const void *state) {
    return (double)((const struct faces *)state)->model.face_count;
}

static const struct bench_version usual_versions[] = {
    {"1: not normalised", 1, false, run_usual, error_usual},
    {"2: pointing outwards", 2, false, run_usual, error_usual},
    {"3: sign thrown away", 3, false, run_usual, error_usual},
    {"4: float", 4, false, run_usual, error_usual},
    {"5: guessed root", 5, false, run_usual, error_usual},
    {"6: one Newton step", 6, false, run_usual, error_usual},
    {"7: two Newton steps", 7, false, run_usual, error_usual},
    {"double (main.c)", HOUSE, true, run_usual, error_usual},
};

static const struct bench_version tiny_versions[] = {
    {"4: float", 4, false, run_tiny, error_tiny},
    {"5: guessed root", 5, false, run_tiny, error_tiny},
    {"6: one Newton step", 6, false, run_tiny, error_tiny},
    {"7: two Newton steps", 7, false, run_tiny, error_tiny},
    {"double (main.c)", HOUSE, true, run_tiny, error_tiny},
};

static const struct bench_panel faces_panels[] = {
    {
        .title = "The faces of the bust, lit from four directions",
        .error_label = "largest error in grey levels",
        .time_label = "ns per face",
        .against = "long double",
        .units = faces_units,
        .versions = usual_versions,
        .version_count = sizeof usual_versions / sizeof usual_versions[0],
    },
    {
        .title = "The same faces, the model scaled to a size of 1e-12",
        .error_label = "largest error in grey levels",
        .time_label = "ns per face",
        .against = "long double",
        .units = faces_units,
        .versions = tiny_versions,
        .version_count = sizeof tiny_versions / sizeof tiny_versions[0],
        .budget = 0.6,
    },
};

const struct bench_lesson bench_step04 = {
    .step = "step04_flat",
    .title = "Step 4: flat shading",
    .setup = faces_setup,
    .teardown = faces_teardown,
    .panels = faces_panels,
    .panel_count = sizeof faces_panels / sizeof faces_panels[0],
};
