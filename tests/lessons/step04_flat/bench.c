/*
 * Lesson 4's benchmark: ways to find the intensity of a face, against long double.
 *
 * Every run lights all faces from four directions, and its levels, kept in double, are what is
 * judged before they are rounded to whole ones.
 */
#define LESSON "../step04_flat/main.c"
#include "lesson.h"

#include "../../../step04_flat/attempts.h"

#include "bench/bench.h"
#include "oracle/reals.h"

enum { LIGHT_COUNT = 4 };

static struct {
    struct model model;
    struct vec3 light[LIGHT_COUNT]; /* of length 1, as well as a double can say that */
    size_t level_count;             /* one a face and light */
    double *levels;                 /* what the last run found, 0..255 */
} faces;

/* ---- The attempts ---- */

enum { HOUSE = 0 }; /* ways 1 to 7 are the attempts */

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
                              int way) {
    switch (way) {
    case 1:
        faces_shade(model, light, levels, attempt_1_not_normalized);
        break;
    case 2:
        faces_shade(model, light, levels, attempt_2_inward);
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

static void run(struct bench_choice choice) {
    for (size_t i = 0; i < LIGHT_COUNT; i++) {
        faces_find_levels(&faces.model, faces.light[i], faces.levels + i * faces.model.face_count,
                          choice.way);
    }
}

/* ---- The error ---- */

/* How directly light falls on a face: the cosine of the angle between the direction to the light
 * and the outward normal. 0 for a face without area. */
static long double exact_intensity(const struct model *model, size_t face, struct vec3 light) {
    struct real3 origin = real3_from(model_position(model, face, 0));
    struct real3 a = real3_sub(real3_from(model_position(model, face, 1)), origin);
    struct real3 b = real3_sub(real3_from(model_position(model, face, 2)), origin);
    struct real3 normal = real3_cross(a, b), to = real3_from(light);
    long double length = real3_length(normal) * real3_length(to);
    return length > 0 ? real3_dot(normal, to) / length : 0;
}

/* A level as the picture can show it; NaN is shown as 0. */
static double shown_level(double level) {
    return level > 0 ? fmin(level, 255) : 0;
}

/* The largest error of the last run's levels. */
static double error_of(struct bench_choice choice) {
    const size_t count = faces.model.face_count;
    double worst = 0;
    (void)choice;
    for (size_t i = 0; i < faces.level_count; i++) {
        long double right = 255 * exact_intensity(&faces.model, i % count, faces.light[i / count]);
        double error = (double)fabsl(shown_level(faces.levels[i]) - (right > 0 ? right : 0));
        worst = fmax(worst, error);
    }
    return worst;
}

/* ---- The lesson ---- */

static bool faces_setup(struct error *error) {
    static const struct vec3 directions[LIGHT_COUNT] = {
        {0, 0, 1}, {1, 1, 1}, {-3, 1, 2}, {0.1, -1, 0.3}};
    for (int i = 0; i < LIGHT_COUNT; i++) {
        faces.light[i] = vec3_normalized(directions[i]);
    }
    if (!model_read(&faces.model, BENCH_MODEL("bust.obj"), error)) {
        return false;
    }
    faces.level_count = LIGHT_COUNT * faces.model.face_count;
    faces.levels = bench_memory(faces.level_count, sizeof *faces.levels);
    return true;
}

static const struct bench_version attempt_versions[] = {
    VERSION("1: not normalised", 1),   VERSION("2: pointing inwards", 2),
    VERSION("3: sign thrown away", 3), VERSION("4: float", 4),
    VERSION("5: guessed root", 5),     VERSION("6: one Newton step", 6),
    VERSION("7: two Newton steps", 7), HOUSE_VERSION("double (main.c)", HOUSE),
};

static const struct bench_panel faces_panels[] = {
    {
        .title = "The attempts: the faces of the bust, lit from four directions",
        .error_label = "largest error in grey values",
        .time_label = "ns per face",
        .against = "long double",
        .house_within = 1e-12,
        .run = run,
        .error = error_of,
        .units = &faces.level_count,
        BENCH_VERSIONS(attempt_versions),
    },
};

const struct bench_lesson bench_step04 =
    BENCH_LESSON("step04_flat", "Lesson 4: flat shading", faces_setup, faces_panels);
