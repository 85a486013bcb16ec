/*
 * Lesson 4's benchmark: ways to find the intensity of a face, against long double.
 *
 * The first panel has the lesson's attempts. The next two have the root alone, of normals that are
 * prepared as each version wants them: in float, in double, or of length 1 and stored in few bits.
 * In the last one the model becomes so small that the squares of lengths leave the range of a
 * float. Every run lights all faces from four directions, and its levels, kept in double, are what
 * is judged before they are rounded to whole ones.
 */
#define LESSON "../step04_flat/main.c"
#include "lesson.h"

#include "../../../step04_flat/attempts.h"

#include "bench/bench.h"
#include "oracle/reals.h"

#include <stdlib.h>

enum { LIGHT_COUNT = 4, SIZE_COUNT = 5, TABLE_SIZE = 512 };

/* Of the model, for the last panel. */
static const double sizes[SIZE_COUNT] = {1, 1e-8, 1e-9, 1e-10, 1e-12};

/* Normals that are not of length 1 yet, each coordinate apart. */
struct float_normals {
    float *x, *y, *z;
};

struct double_normals {
    double *x, *y, *z;
};

/* Normals of length 1, rounded to a few bits: 3 bytes, 10 bits each in a word, 6 bytes. */
struct stored_normals {
    int8_t *byte[3];
    uint32_t *word;
    int16_t *half[3];
};

struct faces {
    struct model models[SIZE_COUNT];
    size_t count;
    struct vec3 light[LIGHT_COUNT]; /* of length 1, as well as a double can say that */
    double *levels;                 /* one a face and light: what the last run found, 0..255 */

    struct float_normals floats;
    struct double_normals doubles;
    struct stored_normals stored;
    float table[TABLE_SIZE]; /* 1 / sqrt() of 1 to 4 */
};

/* ---- The attempts ---- */

enum { HOUSE = 0, SCALED_FIRST = 8 }; /* choices 1 to 7 are the attempts */

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

/* Attempt 4 with the normal first divided by its largest coordinate: no square is too small. */
static inline double scaled_first(struct vec3 w0, struct vec3 w1, struct vec3 w2,
                                  struct vec3 light) {
    struct attempt_vec3 n = attempt_normal(w0, w1, w2);
    float x = fabsf(n.x), y = fabsf(n.y), z = fabsf(n.z), largest = x > y ? x : y;
    largest = largest > z ? largest : z;
    float scale = largest > 0 ? 1 / largest : 0;
    n = (struct attempt_vec3){n.x * scale, n.y * scale, n.z * scale};
    float square = attempt_square(n);
    return square > 0 ? (double)(attempt_dot(n, light) / sqrtf(square)) : 0;
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
    case SCALED_FIRST:
        faces_shade(model, light, levels, scaled_first);
        break;
    default:
        for (size_t face = 0; face < model->face_count; face++) {
            levels[face] = 255 * face_intensity(model, face, light);
        }
    }
}

static void run_attempt(void *state, int choice) {
    struct faces *faces = state;
    for (size_t i = 0; i < LIGHT_COUNT; i++) {
        faces_find_levels(&faces->models[0], faces->light[i], faces->levels + i * faces->count,
                          choice);
    }
}

/* Choices of the last panel: the version, and the size of the model. */
static void run_size(void *state, int choice) {
    struct faces *faces = state;
    for (size_t i = 0; i < LIGHT_COUNT; i++) {
        faces_find_levels(&faces->models[choice % SIZE_COUNT], faces->light[i],
                          faces->levels + i * faces->count, choice / SIZE_COUNT);
    }
}

static const char *series_of_size(int choice) {
    switch (choice / SIZE_COUNT) {
    case HOUSE:
        return "double (main.c)";
    case SCALED_FIRST:
        return "float, scaled first";
    case 4:
        return "4: float";
    default:
        return "7: two Newton steps";
    }
}

/* ---- The root alone ---- */

enum root_version {
    FLOAT_NEWTON,      /* and 1, 2, 3: so many steps */
    DOUBLE_NEWTON = 4, /* the same */
    FLOAT_ROOT = 8,
    DOUBLE_ROOT,
    NORMALIZED,
    FLOAT_TABLE,
    FLOAT_TABLE_STEP,
    STORED_8,
    STORED_10,
    STORED_16,
    ROOTS_WORST = 32 /* added to them where the worst face is judged, and not the mean */
};

static inline float newton_step(float root, float square) {
    return root * (1.5F - 0.5F * square * root * root);
}

/* As attempt_reciprocal_root() in 64 bits. */
static inline double double_reciprocal_root(double square, int newton_steps) {
    uint64_t bits;
    double root;
    memcpy(&bits, &square, sizeof bits);
    bits = 0x5fe6eb50c7b537a9U - (bits >> 1);
    memcpy(&root, &bits, sizeof root);
    for (int i = 0; i < newton_steps; i++) {
        root = root * (1.5 - 0.5 * square * root * root);
    }
    return root;
}

/* The exponent is halved and negated; its lowest bit and the first eight after the point find the
 * rest in a table. */
static inline float table_reciprocal_root(const float table[TABLE_SIZE], float square) {
    uint32_t bits;
    float scale;
    memcpy(&bits, &square, sizeof bits);
    uint32_t scale_bits = (191 - (((bits >> 23) + 1) >> 1)) << 23;
    memcpy(&scale, &scale_bits, sizeof scale);
    return table[(bits >> 15) & (TABLE_SIZE - 1)] * scale;
}

static void table_fill(float table[TABLE_SIZE]) {
    for (int i = 0; i < TABLE_SIZE; i++) {
        double middle = 1 + (i % 256 + 0.5) / 256; /* of the numbers that find this place */
        table[i] = (float)(1 / sqrt(i >= 256 ? middle : 2 * middle));
    }
}

/* Like faces_shade(): `version` is a constant where it is called. */
static inline void shade_floats(const struct faces *faces, struct vec3 light, double *levels,
                                enum root_version version) {
    const struct float_normals n = faces->floats;
    const float lx = (float)light.x, ly = (float)light.y, lz = (float)light.z;
    for (size_t i = 0; i < faces->count; i++) {
        float x = n.x[i], y = n.y[i], z = n.z[i];
        float square = x * x + y * y + z * z, dot = 255 * (x * lx + y * ly + z * lz);
        if (version == FLOAT_ROOT) {
            levels[i] = dot / sqrtf(square);
        } else if (version < DOUBLE_NEWTON) {
            levels[i] = dot * attempt_reciprocal_root(square, (int)version);
        } else {
            float root = table_reciprocal_root(faces->table, square);
            levels[i] = dot * (version == FLOAT_TABLE ? root : newton_step(root, square));
        }
    }
}

static inline void shade_doubles(const struct faces *faces, struct vec3 light, double *levels,
                                 enum root_version version) {
    const struct double_normals n = faces->doubles;
    for (size_t i = 0; i < faces->count; i++) {
        struct vec3 normal = {n.x[i], n.y[i], n.z[i]};
        double square = vec3_dot(normal, normal), dot = 255 * vec3_dot(normal, light);
        if (version == NORMALIZED) {
            levels[i] = 255 * vec3_dot(vec3_normalized(normal), light);
        } else if (version == DOUBLE_ROOT) {
            levels[i] = dot / sqrt(square);
        } else {
            levels[i] = dot * double_reciprocal_root(square, (int)version - DOUBLE_NEWTON);
        }
    }
}

static inline int stored_part(uint32_t word, int place) {
    return (int)(word >> (10 * place) & 1023) - 511;
}

static inline void shade_stored(const struct faces *faces, struct vec3 light, double *levels,
                                enum root_version version) {
    const struct stored_normals *n = &faces->stored;
    int most = version == STORED_8 ? 127 : version == STORED_10 ? 511 : 32767;
    const float scale = 255 / (float)most, lx = scale * (float)light.x;
    const float ly = scale * (float)light.y, lz = scale * (float)light.z;
    for (size_t i = 0; i < faces->count; i++) {
        int x = version == STORED_8 ? n->byte[0][i] : n->half[0][i];
        int y = version == STORED_8 ? n->byte[1][i] : n->half[1][i];
        int z = version == STORED_8 ? n->byte[2][i] : n->half[2][i];
        if (version == STORED_10) {
            x = stored_part(n->word[i], 0);
            y = stored_part(n->word[i], 1);
            z = stored_part(n->word[i], 2);
        }
        levels[i] = (float)x * lx + (float)y * ly + (float)z * lz;
    }
}

static void shade_roots(const struct faces *faces, struct vec3 light, double *levels, int choice) {
    switch (choice) {
    case FLOAT_NEWTON:
        shade_floats(faces, light, levels, FLOAT_NEWTON);
        break;
    case FLOAT_NEWTON + 1:
        shade_floats(faces, light, levels, FLOAT_NEWTON + 1);
        break;
    case FLOAT_NEWTON + 2:
        shade_floats(faces, light, levels, FLOAT_NEWTON + 2);
        break;
    case FLOAT_NEWTON + 3:
        shade_floats(faces, light, levels, FLOAT_NEWTON + 3);
        break;
    case FLOAT_ROOT:
        shade_floats(faces, light, levels, FLOAT_ROOT);
        break;
    case FLOAT_TABLE:
        shade_floats(faces, light, levels, FLOAT_TABLE);
        break;
    case FLOAT_TABLE_STEP:
        shade_floats(faces, light, levels, FLOAT_TABLE_STEP);
        break;
    case DOUBLE_NEWTON:
        shade_doubles(faces, light, levels, DOUBLE_NEWTON);
        break;
    case DOUBLE_NEWTON + 1:
        shade_doubles(faces, light, levels, DOUBLE_NEWTON + 1);
        break;
    case DOUBLE_NEWTON + 2:
        shade_doubles(faces, light, levels, DOUBLE_NEWTON + 2);
        break;
    case DOUBLE_NEWTON + 3:
        shade_doubles(faces, light, levels, DOUBLE_NEWTON + 3);
        break;
    case DOUBLE_ROOT:
        shade_doubles(faces, light, levels, DOUBLE_ROOT);
        break;
    case STORED_8:
        shade_stored(faces, light, levels, STORED_8);
        break;
    case STORED_10:
        shade_stored(faces, light, levels, STORED_10);
        break;
    case STORED_16:
        shade_stored(faces, light, levels, STORED_16);
        break;
    default:
        shade_doubles(faces, light, levels, NORMALIZED);
    }
}

static void run_root(void *state, int choice) {
    struct faces *faces = state;
    for (size_t i = 0; i < LIGHT_COUNT; i++) {
        shade_roots(faces, faces->light[i], faces->levels + i * faces->count, choice % ROOTS_WORST);
    }
}

static const char *series_of_root(int choice) {
    choice %= ROOTS_WORST;
    if (choice == NORMALIZED) {
        return NULL;
    }
    if (choice == FLOAT_TABLE || choice == FLOAT_TABLE_STEP) {
        return "table";
    }
    if (choice >= STORED_8) {
        return "stored";
    }
    return choice < DOUBLE_NEWTON || choice == FLOAT_ROOT ? "float" : "double";
}

/* Of a normal, as it is read. */
static double root_bytes(const void *state, int choice) {
    (void)state;
    choice %= ROOTS_WORST;
    if (choice >= STORED_8) {
        return choice == STORED_8 ? 3 : choice == STORED_10 ? 4 : 6;
    }
    bool is_double = (choice >= DOUBLE_NEWTON && choice < FLOAT_ROOT) || choice == DOUBLE_ROOT ||
                     choice == NORMALIZED;
    return is_double ? 24 : 12;
}

/* ---- The errors ---- */

/* How directly light falls on a face: minus the cosine of the angle between the light's direction
 * and the outward normal. 0 for a face without area. */
static long double exact_intensity(const struct model *model, size_t face, struct vec3 light) {
    struct real3 origin = real3_from(model_position(model, face, 0));
    struct real3 a = real3_sub(real3_from(model_position(model, face, 1)), origin);
    struct real3 b = real3_sub(real3_from(model_position(model, face, 2)), origin);
    struct real3 normal = real3_cross(a, b), to = real3_from(light);
    long double length = real3_length(normal) * real3_length(to);
    return length > 0 ? -real3_dot(normal, to) / length : 0;
}

/* A level as the picture can show it; what is not a number is shown as 0. */
static double shown_level(double level) {
    return level > 0 ? fmin(level, 255) : 0;
}

/* The errors of the last run's levels: the largest, and the root of the mean square. */
struct errors {
    double worst, mean;
};

static struct errors faces_errors(const struct faces *faces, const struct model *model) {
    struct errors errors = {0, 0};
    for (size_t i = 0; i < LIGHT_COUNT; i++) {
        for (size_t face = 0; face < faces->count; face++) {
            long double right = 255 * exact_intensity(model, face, faces->light[i]);
            double level = shown_level(faces->levels[i * faces->count + face]);
            double error = (double)fabsl(level - (right > 0 ? right : 0));
            errors.worst = fmax(errors.worst, error);
            errors.mean += error * error;
        }
    }
    errors.mean = sqrt(errors.mean / (double)(LIGHT_COUNT * faces->count));
    return errors;
}

static double error_worst(void *state, int choice) {
    const struct faces *faces = state;
    (void)choice;
    return faces_errors(faces, &faces->models[0]).worst;
}

static double error_of_root(void *state, int choice) {
    const struct faces *faces = state;
    struct errors errors = faces_errors(faces, &faces->models[0]);
    return choice >= ROOTS_WORST ? errors.worst : errors.mean;
}

static double error_of_size(void *state, int choice) {
    const struct faces *faces = state;
    return faces_errors(faces, &faces->models[choice % SIZE_COUNT]).worst;
}

/* ---- The lesson ---- */

static bool read_models(struct faces *faces, struct error *error) {
    for (size_t k = 0; k < SIZE_COUNT; k++) {
        struct model *model = &faces->models[k];
        if (!bench_read_model(model, "bust.obj", error)) {
            return false;
        }
        for (size_t i = 0; i < model->position_count; i++) {
            model->positions[i] = vec3_scale(model->positions[i], sizes[k]);
        }
    }
    faces->count = faces->models[0].face_count;
    return true;
}

static bool allocate(struct faces *faces, struct error *error) {
    size_t count = faces->count + 1;
    float **floats[] = {&faces->floats.x, &faces->floats.y, &faces->floats.z};
    double **doubles[] = {&faces->doubles.x, &faces->doubles.y, &faces->doubles.z};
    faces->levels = calloc(LIGHT_COUNT * count, sizeof *faces->levels);
    faces->stored.word = calloc(count, sizeof *faces->stored.word);
    bool done = faces->levels != NULL && faces->stored.word != NULL;
    for (int i = 0; i < 3; i++) {
        *floats[i] = calloc(count, sizeof **floats[i]);
        *doubles[i] = calloc(count, sizeof **doubles[i]);
        faces->stored.byte[i] = calloc(count, sizeof *faces->stored.byte[i]);
        faces->stored.half[i] = calloc(count, sizeof *faces->stored.half[i]);
        done = done && *floats[i] != NULL && *doubles[i] != NULL && faces->stored.byte[i] != NULL &&
               faces->stored.half[i] != NULL;
    }
    return done || error_set(error, "out of memory for normals");
}

static int rounded_to(double value, int most) {
    return (int)floor(value * most + 0.5);
}

static void prepare_normals(struct faces *faces) {
    const struct model *model = &faces->models[0];
    for (size_t i = 0; i < faces->count; i++) {
        struct vec3 w0 = model_position(model, i, 0), w1 = model_position(model, i, 1);
        struct vec3 normal =
            vec3_cross(vec3_sub(model_position(model, i, 2), w0), vec3_sub(w1, w0));
        struct vec3 unit = vec3_normalized(normal);
        const double part[3] = {unit.x, unit.y, unit.z};
        faces->doubles.x[i] = normal.x;
        faces->doubles.y[i] = normal.y;
        faces->doubles.z[i] = normal.z;
        faces->floats.x[i] = (float)normal.x;
        faces->floats.y[i] = (float)normal.y;
        faces->floats.z[i] = (float)normal.z;
        for (int j = 0; j < 3; j++) {
            faces->stored.byte[j][i] = (int8_t)rounded_to(part[j], 127);
            faces->stored.half[j][i] = (int16_t)rounded_to(part[j], 32767);
            faces->stored.word[i] |= (uint32_t)(rounded_to(part[j], 511) + 511) << (10 * j);
        }
    }
}

static bool faces_setup(void *state, struct error *error) {
    static const struct vec3 directions[LIGHT_COUNT] = {
        {0, 0, -1}, {-1, -1, -1}, {3, -1, -2}, {-0.1, 1, -0.3}};
    struct faces *faces = state;
    for (int i = 0; i < LIGHT_COUNT; i++) {
        faces->light[i] = vec3_normalized(directions[i]);
    }
    if (!read_models(faces, error) || !allocate(faces, error)) {
        return false;
    }
    prepare_normals(faces);
    table_fill(faces->table);
    return true;
}

static void faces_teardown(void *state) {
    struct faces *faces = state;
    for (size_t k = 0; k < SIZE_COUNT; k++) {
        model_free(&faces->models[k]);
    }
    for (int i = 0; i < 3; i++) {
        free(faces->stored.byte[i]);
        free(faces->stored.half[i]);
    }
    free(faces->floats.x);
    free(faces->floats.y);
    free(faces->floats.z);
    free(faces->doubles.x);
    free(faces->doubles.y);
    free(faces->doubles.z);
    free(faces->stored.word);
    free(faces->levels);
}

static double faces_units(const void *state, int base) {
    (void)base;
    return (double)(LIGHT_COUNT * ((const struct faces *)state)->count);
}

static const struct bench_version attempt_versions[] = {
    VERSION("1: not normalised", 1),   VERSION("2: pointing outwards", 2),
    VERSION("3: sign thrown away", 3), VERSION("4: float", 4),
    VERSION("5: guessed root", 5),     VERSION("6: one Newton step", 6),
    VERSION("7: two Newton steps", 7), HOUSE_VERSION("double (main.c)", HOUSE),
};

static const struct bench_version root_versions[] = {
    VERSION("guess", FLOAT_NEWTON),        VERSION("1 step", FLOAT_NEWTON + 1),
    VERSION("2 steps", FLOAT_NEWTON + 2),  VERSION("3 steps", FLOAT_NEWTON + 3),
    VERSION("root", FLOAT_ROOT),           VERSION("guess", DOUBLE_NEWTON),
    VERSION("1 step", DOUBLE_NEWTON + 1),  VERSION("2 steps", DOUBLE_NEWTON + 2),
    VERSION("3 steps", DOUBLE_NEWTON + 3), VERSION("root", DOUBLE_ROOT),
    VERSION("alone", FLOAT_TABLE),         VERSION("1 step", FLOAT_TABLE_STEP),
    VERSION("8 bits", STORED_8),           VERSION("10 bits", STORED_10),
    VERSION("16 bits", STORED_16),         HOUSE_VERSION("vec3_normalized()", NORMALIZED),
};

#define SIZES(OF, version)                                                                         \
    OF("1", (version)*SIZE_COUNT), OF("1e-8", (version)*SIZE_COUNT + 1),                           \
        OF("1e-9", (version)*SIZE_COUNT + 2), OF("1e-10", (version)*SIZE_COUNT + 3),               \
        OF("1e-12", (version)*SIZE_COUNT + 4)

static const struct bench_version size_versions[] = {SIZES(VERSION, 4), SIZES(VERSION, 7),
                                                     SIZES(VERSION, SCALED_FIRST),
                                                     SIZES(HOUSE_VERSION, HOUSE)};

static const struct bench_panel faces_panels[] = {
    {
        .title = "The attempts: the faces of the bust, lit from four directions",
        .error_label = "largest error in grey levels",
        .time_label = "ns per face",
        .against = "long double",
        .house_within = 1e-12,
        .run = run_attempt,
        .error = error_worst,
        .units = faces_units,
        BENCH_VERSIONS(attempt_versions),
    },
    {
        .title = "The root alone, of the same faces' normals",
        .error_label = "grey levels, root mean square",
        .time_label = "ns per face",
        .against = "long double",
        .house_within = 1e-12,
        .run = run_root,
        .error = error_of_root,
        .units = faces_units,
        BENCH_VERSIONS(root_versions),
        .series = series_of_root,
        .size = root_bytes,
        .size_label = "bytes of a normal",
    },
    {
        .title = "The same, the worst face",
        .error_label = "largest error in grey levels",
        .time_label = "ns per face",
        .against = "long double",
        .house_within = 1e-12,
        .base = ROOTS_WORST,
        .run = run_root,
        .error = error_of_root,
        .units = faces_units,
        BENCH_VERSIONS(root_versions),
        .series = series_of_root,
        .size = root_bytes,
        .size_label = "bytes of a normal",
    },
    {
        .title = "The whole face again, the model scaled to a size of 1 down to 1e-12",
        .error_label = "largest error in grey levels",
        .time_label = "ns per face",
        .against = "long double",
        .house_within = 1e-12,
        .run = run_size,
        .error = error_of_size,
        .units = faces_units,
        BENCH_VERSIONS(size_versions),
        .series = series_of_size,
    },
};

const struct bench_lesson bench_step04 = {
    .step = "step04_flat",
    .title = "Step 4: flat shading",
    .state_size = sizeof(struct faces),
    .setup = faces_setup,
    .teardown = faces_teardown,
    .panels = faces_panels,
    .panel_count = sizeof faces_panels / sizeof faces_panels[0],
};
