/* What the properties of the lessons share: see lessons.h. */
#include "lessons.h"

#include "stress.h"

#include <stdio.h>
#include <string.h>

/* ---- Numbers ---- */

bool level_is_right(uint8_t level, long double exact) {
    long double bounded = exact > 0 ? (exact < 255 ? exact : 255) : 0;
    return fabsl(level - bounded) <= 0.5L + 1e-9L;
}

bool color_is_right(struct color color, struct real3 exact) {
    return level_is_right(color.r, exact.x) && level_is_right(color.g, exact.y) &&
           level_is_right(color.b, exact.z);
}

long double real_slack(long double roundings, long double if_double) {
    return sizeof(real) == sizeof(float) ? roundings * real_ulp : if_double;
}

static bool level_is_near(uint8_t level, long double exact, long double roundings) {
    long double bounded = exact > 0 ? (exact < 255 ? exact : 255) : 0;
    return fabsl(level - bounded) <= 0.5L + real_slack(255 * roundings, 1e-9L);
}

bool color_is_near(struct color color, struct real3 exact, long double roundings) {
    return level_is_near(color.r, exact.x, roundings) &&
           level_is_near(color.g, exact.y, roundings) && level_is_near(color.b, exact.z, roundings);
}

enum { JUDGED_LANE = LANES / 3 };

lanes lanes_holding(double value) {
    real numbers[LANES];
    lanes result;
    for (int i = 0; i < LANES; i++) {
        numbers[i] = i == JUDGED_LANE ? (real)value : (real)i / 4 - 1;
    }
    memcpy(&result, numbers, sizeof result);
    return result;
}

double lane_of(lanes value) {
    real numbers[LANES];
    memcpy(numbers, &value, sizeof numbers);
    return (double)numbers[JUDGED_LANE];
}

struct pixel_color shade_pixel(lanes_mask (*fragment)(const void *, const lanes *, lanes_texel *),
                               const void *uniforms, const double *varyings, size_t count) {
    lanes given[8];
    lanes_texel texels;
    for (size_t i = 0; i < count; i++) {
        given[i] = lanes_holding(varyings[i]);
    }
    lanes_mask drawn = fragment(uniforms, given, &texels);
    uint32_t texel = lanes_texel_at(texels, JUDGED_LANE);
    return (struct pixel_color){
        .color = {.b = (uint8_t)texel,
                  .g = (uint8_t)(texel >> 8),
                  .r = (uint8_t)(texel >> 16),
                  .a = (uint8_t)(texel >> 24)},
        .drawn = lanes_is_set(drawn, JUDGED_LANE),
    };
}

struct vec3 random_direction(struct random *random) {
    struct vec3 v;
    do {
        v = (struct vec3){random_real(random, -1, 1), random_real(random, -1, 1),
                          random_real(random, -1, 1)};
    } while (vec3_dot(v, v) > 1 || vec3_dot(v, v) < 0.01);
    return vec3_scale(v, 1 / sqrt(vec3_dot(v, v)));
}

struct vec3 random_vector(struct random *random, int reach) {
    double length = ldexp(random_real(random, 0.5, 1), (int)random_between(random, -reach, reach));
    return vec3_scale(random_direction(random), random_bits(random) % 64 == 0 ? 0 : length);
}

/* ---- Layers ---- */

static double any_depth(struct random *random, uint64_t kind) {
    switch (kind) {
    case 0: /* many ties */
        return (double)random_between(random, -2, 2);
    case 1: /* close together, far from zero */
        return 1000 + random_real(random, -1e-9, 1e-9);
    case 2:
        return ldexp(random_real(random, -1, 1), (int)random_between(random, -300, 300));
    default:
        return random_real(random, -1, 1);
    }
}

void make_layers(struct random *random, uint64_t index, struct layers *layers) {
    for (int i = 0; i < LAYER_COUNT; i++) {
        random_triangle(random, random_bits(random), layers->corner[i]);
        uint64_t kind = index % 8;
        for (int k = 0; k < 3; k++) {
            layers->depth[i][k] = any_depth(random, kind);
        }
        if (i > 0 && random_bits(random) % 4 == 0) {
            int earlier = (int)random_between(random, 0, i - 1);
            memcpy(layers->corner[i], layers->corner[earlier], sizeof layers->corner[i]);
            memcpy(layers->depth[i], layers->depth[earlier], sizeof layers->depth[i]);
        }
    }
}

long double layer_value(const struct layers *layers, int layer, const double value[3], int x,
                        int y) {
    static const double no_perspective[3] = {1, 1, 1};
    return oracle_interpolate(layers->corner[layer], no_perspective, value, x, y);
}

double layer_tolerance(const struct layers *layers, int layer) {
    const double *depth = layers->depth[layer];
    return fmax(fabs(depth[0]), fmax(fabs(depth[1]), fabs(depth[2]))) * 0x1p-49;
}

static bool layer_covers(const struct layers *layers, int layer, int x, int y) {
    const struct fixed2 *c = layers->corner[layer];
    return oracle_covers(c[0], c[1], c[2], x, y);
}

static bool is_copy(const struct layers *layers, int layer, int earlier) {
    return memcmp(layers->corner[layer], layers->corner[earlier], sizeof layers->corner[0]) == 0 &&
           memcmp(layers->depth[layer], layers->depth[earlier], sizeof layers->depth[0]) == 0;
}

static bool hides(const struct layers *layers, int front, int behind, int x, int y) {
    if (front == behind || !layer_covers(layers, front, x, y)) {
        return false;
    }
    if (front < behind && is_copy(layers, behind, front)) {
        return true;
    }
    long double front_depth = layer_value(layers, front, layers->depth[front], x, y);
    long double behind_depth = layer_value(layers, behind, layers->depth[behind], x, y);
    long double tolerance = layer_tolerance(layers, front) + layer_tolerance(layers, behind);
    return front_depth > behind_depth + tolerance;
}

bool layer_may_show(const struct layers *layers, int layer, int x, int y) {
    if (!layer_covers(layers, layer, x, y)) {
        return false;
    }
    for (int i = 0; i < LAYER_COUNT; i++) {
        if (hides(layers, i, layer, x, y)) {
            return false;
        }
    }
    return true;
}

uint64_t layers_pixel_count(const struct layers *layers) {
    uint64_t count = 0;
    for (int i = 0; i < LAYER_COUNT; i++) {
        for (int k = 0; k < SCREEN_WIDTH * SCREEN_HEIGHT; k++) {
            count += layer_covers(layers, i, k % SCREEN_WIDTH, k / SCREEN_WIDTH);
        }
    }
    return count;
}

void print_layers(const struct layers *layers) {
    for (int i = 0; i < LAYER_COUNT; i++) {
        printf("    corners (1/256 pixel) and depths:");
        for (int k = 0; k < 3; k++) {
            printf(" (%d %d %.17g)", (int)layers->corner[i][k].x, (int)layers->corner[i][k].y,
                   layers->depth[i][k]);
        }
        printf("\n");
    }
}

/* ---- Models and textures ---- */

void mesh_from(struct mesh *mesh, struct mesh_data *data, size_t face_count) {
    for (uint32_t i = 0; i < face_count; i++) {
        for (uint32_t k = 0; k < 3; k++) {
            uint32_t n = 3 * i + k;
            mesh->faces[i].corner[k] = (struct corner){n, n, n};
        }
    }
    mesh->model = (struct model){
        .positions = data->position,
        .uvs = data->uv,
        .normals = data->normal,
        .position_count = 3 * face_count,
        .uv_count = 3 * face_count,
        .normal_count = 3 * face_count,
        .faces = mesh->faces,
        .face_count = face_count,
    };
}

void mesh_set(float to[3], struct vec3 from) {
    to[0] = (float)from.x;
    to[1] = (float)from.y;
    to[2] = (float)from.z;
}

struct real3 mesh_get(const float from[3]) {
    return (struct real3){from[0], from[1], from[2]};
}

struct texture texture_from(uint32_t *texels, size_t width, size_t height) {
    const struct texture_level level = {
        .width = width, .height = height, .pitch = width, .texels = texels};
    return (struct texture){.level_count = 1, .level = {level}, .texels = texels};
}

void make_picture(struct random *random, struct picture_data *picture) {
    for (int i = 0; i < PICTURE_SIDE * PICTURE_SIDE; i++) {
        uint64_t bits = random_bits(random);
        memcpy(picture->level[i], &bits, sizeof picture->level[i]);
    }
}

bool texture_of_picture(const struct picture_data *picture, struct texture *texture) {
    struct picture_data copy = *picture;
    struct image image = {PICTURE_SIDE, PICTURE_SIDE, IMAGE_BGRA, copy.level[0]};
    struct error error;
    return texture_create(texture, &image, &error);
}

struct real3 exact_color(const struct texture *texture, size_t level, struct vec2 uv) {
    struct sample sample = exact_bilinear(&texture->level[level], uv.x, uv.y);
    return (struct real3){sample.channel[0], sample.channel[1], sample.channel[2]};
}

static struct real3 mapped_direction(const struct texture *texture, size_t level, struct vec2 uv) {
    struct real3 c = real3_scale(exact_color(texture, level, uv), 2 / 255.0L);
    return (struct real3){c.x - 1, c.y - 1, c.z - 1};
}

struct real3 exact_normal(const struct texture *texture, size_t level, struct vec2 uv) {
    return real3_unit(mapped_direction(texture, level, uv));
}

/* A component is off by twice what a texel is, since it goes from -1 to 1. */
long double normal_roundings(const struct texture *texture, size_t level, struct vec2 uv) {
    return 2 * TEXEL_ROUNDINGS / real3_length(mapped_direction(texture, level, uv)) + 8;
}
