/* What the properties of the lessons share: see lessons.h. */
#include "lessons.h"

#include "stress.h"

#include <string.h>

/* ---- Numbers ---- */

bool is_near(double got, long double exact, long double slack) {
    return fabsl(exact - (long double)got) <= slack;
}

bool is_snapped(int32_t position, long double pixels) {
    long double exact = pixels * SUBPIXELS;
    return fabsl(exact - position) <= 0.5L + 1e-13L * (SUBPIXELS + fabsl(exact));
}

long double real_slack(long double roundings) {
    return roundings * (sizeof(real) == sizeof(float) ? 0x1p-24L : 0x1p-53L);
}

static bool level_is_near(uint8_t level, long double exact, long double slack) {
    long double bounded = exact > 0 ? (exact < 255 ? exact : 255) : 0;
    return fabsl(level - bounded) <= 0.5L + slack;
}

bool level_is_right(uint8_t level, long double exact) {
    return level_is_near(level, exact, 1e-9L);
}

bool color_is_right(struct color color, struct real3 exact) {
    return level_is_right(color.r, exact.x) && level_is_right(color.g, exact.y) &&
           level_is_right(color.b, exact.z);
}

bool color_is_near(struct color color, struct real3 exact, long double roundings) {
    long double slack = fmaxl(1e-9L, 255 * real_slack(roundings));
    return level_is_near(color.r, exact.x, slack) && level_is_near(color.g, exact.y, slack) &&
           level_is_near(color.b, exact.z, slack);
}

enum { JUDGED_LANE = LANES / 3 };

/* A number for the judged lane; the others hold other numbers. */
static lanes lanes_holding(double value) {
    real numbers[LANES];
    lanes result;
    for (int i = 0; i < LANES; i++) {
        numbers[i] = i == JUDGED_LANE ? (real)value : (real)i / 4 - 1;
    }
    memcpy(&result, numbers, sizeof result);
    return result;
}

struct pixel_color shade_pixel(fragment_function *fragment, const void *uniforms,
                               const double *varyings, size_t count) {
    lanes given[8];
    lanes_texel texels;
    for (size_t i = 0; i < count; i++) {
        given[i] = lanes_holding(varyings[i]);
    }
    lanes_mask drawn = fragment(uniforms, given, &texels);
    return (struct pixel_color){color_from_texel(lanes_texel_at(texels, JUDGED_LANE)),
                                lanes_is_set(drawn, JUDGED_LANE)};
}

long double exact_power(long double base, int power) {
    return power == 0 ? 1 : base * exact_power(base, power - 1);
}

struct vec3 random_direction(struct random *random) {
    struct vec3 v;
    do {
        v = random_vec3(random, 1);
    } while (vec3_dot(v, v) > 1 || vec3_dot(v, v) < 0.01);
    return vec3_scale(v, 1 / sqrt(vec3_dot(v, v)));
}

struct vec3 random_vector(struct random *random, int reach) {
    double length = ldexp(random_real(random, 0.5, 1), (int)random_between(random, -reach, reach));
    return vec3_scale(random_direction(random), random_bits(random) % 64 == 0 ? 0 : length);
}

/* ---- Layers ---- */

enum { PIXELS = SCREEN_WIDTH * SCREEN_HEIGHT };

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

void make_layers(struct random *random, uint64_t index, void *made) {
    struct layers *layers = made;
    for (int i = 0; i < LAYER_COUNT; i++) {
        random_triangle(random, random_bits(random), layers->corner[i]);
        for (int k = 0; k < 3; k++) {
            layers->depth[i][k] = any_depth(random, index % 8);
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

/* How far a depth of a layer may be off. */
static double depth_tolerance(const struct layers *layers, int layer) {
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
    long double tolerance = depth_tolerance(layers, front) + depth_tolerance(layers, behind);
    return front_depth > behind_depth + tolerance;
}

static bool may_show(const struct layers *layers, int layer, int x, int y) {
    bool shows = layer_covers(layers, layer, x, y);
    for (int i = 0; i < LAYER_COUNT && shows; i++) {
        shows = !hides(layers, i, layer, x, y);
    }
    return shows;
}

uint64_t layers_cover(const struct layers *layers) {
    uint64_t count = 0;
    for (int i = 0; i < LAYER_COUNT * PIXELS; i++) {
        int pixel = i % PIXELS;
        count += layer_covers(layers, i / PIXELS, pixel % SCREEN_WIDTH, pixel / SCREEN_WIDTH);
    }
    return count;
}

/* Does the pixel show this layer, or none where it is -1, in all pictures? */
static bool shows_layer(const struct layered *l, int layer, int x, int y, const struct image *image,
                        double depth) {
    bool right = layer < 0
                     ? depth == -INFINITY
                     : is_near(depth, layer_value(l->layers, layer, l->layers->depth[layer], x, y),
                               (long double)depth_tolerance(l->layers, layer));
    for (int i = 0; i < l->side * l->side && right; i++) {
        struct color color =
            image_get(image, x + i % l->side * SCREEN_WIDTH, y + i / l->side * SCREEN_HEIGHT);
        right = layer < 0 ? (color.r | color.g | color.b) == 0
                          : l->has_color(l->tried, layer, i, x, y, color);
    }
    return right;
}

static bool pixel_is_right(const struct layered *l, int x, int y, const struct image *image,
                           double depth) {
    bool right = false, empty = true;
    for (int i = 0; i < LAYER_COUNT && !right; i++) {
        bool may = may_show(l->layers, i, x, y);
        empty = empty && !may;
        right = may && shows_layer(l, i, x, y, image, depth);
    }
    return right || (empty && shows_layer(l, -1, x, y, image, depth));
}

bool layers_are_right(const struct layered *l) {
    uint8_t pixels[4 * 3 * PIXELS] = {0}, once[sizeof pixels];
    double depth[PIXELS];
    size_t width = (size_t)l->side * SCREEN_WIDTH, height = (size_t)l->side * SCREEN_HEIGHT;
    struct image image = {width, height, IMAGE_BGR, pixels};
    depth_clear(depth, PIXELS);
    l->draw(l->tried, &image, depth);
    memcpy(once, pixels, sizeof once);
    l->draw(l->tried, &image, depth);
    bool right = memcmp(pixels, once, sizeof once) == 0;
    for (int i = 0; i < PIXELS && right; i++) {
        right = pixel_is_right(l, i % SCREEN_WIDTH, i / SCREEN_WIDTH, &image, depth[i]);
    }
    return right;
}

/* ---- A model of one face ---- */

void make_face(struct random *random, uint64_t index, struct one_face *face) {
    struct vec3 *p = face->position;
    for (uint32_t i = 0; i < 3; i++) {
        struct vec3 normal = random_vector(random, index % 2 ? 1 : 60);
        p[i] = random_vector(random, index % 4 == 0 ? 100 : 2);
        face->normal[i][0] = (float)normal.x;
        face->normal[i][1] = (float)normal.y;
        face->normal[i][2] = (float)normal.z;
        face->uv[i][0] = (float)random_real(random, -1, 2);
        face->uv[i][1] = (float)random_real(random, -1, 2);
        face->face.corner[i] = (struct corner){i, i, i};
    }
    if (index % 4 == 1) { /* a sliver */
        struct vec3 along = vec3_scale(vec3_sub(p[1], p[0]), random_real(random, 0, 1));
        p[2] = vec3_add(p[0], vec3_add(along, random_vector(random, 20)));
    }
    if (index % 16 == 2) { /* a line or a point */
        p[1] = p[random_bits(random) % 2 ? 0 : 2];
    }
}

struct model model_of(struct one_face *face) {
    return (struct model){
        .positions = face->position,
        .uvs = face->uv,
        .normals = face->normal,
        .position_count = 3,
        .uv_count = 3,
        .normal_count = 3,
        .faces = &face->face,
        .face_count = 1,
    };
}

struct real3 face_normal(const struct one_face *face, size_t corner) {
    const float *n = face->normal[corner];
    return real3_unit((struct real3){n[0], n[1], n[2]});
}

struct real3 face_cross(const struct one_face *face, long double *uncertainty) {
    struct real3 first = real3_from(face->position[0]);
    struct real3 a = real3_sub(real3_from(face->position[1]), first);
    struct real3 b = real3_sub(real3_from(face->position[2]), first);
    struct real3 cross = real3_cross(a, b);
    long double area = real3_length(cross);
    *uncertainty = area > 0 ? real3_length(a) * real3_length(b) / area : 0;
    return cross;
}

/* ---- Textures ---- */

struct texture texture_from(uint32_t *texels, size_t width, size_t height) {
    const struct texture_level level = {
        .width = width, .height = height, .pitch = width, .texels = texels};
    return (struct texture){.level_count = 1, .level = {level}, .clamp = true, .texels = texels};
}

void make_picture(struct random *random, struct picture *picture) {
    picture->width = (size_t)random_between(random, 1, PICTURE_SIDE);
    picture->height = (size_t)random_between(random, 1, PICTURE_SIDE);
    bool has_two_levels = picture->width > 1 || picture->height > 1;
    picture->level = has_two_levels ? random_bits(random) % 2 : 0;
    picture->clamp = random_bits(random) % 2 == 0;
    for (int i = 0; i < PICTURE_SIDE * PICTURE_SIDE; i++) {
        uint64_t bits = random_bits(random);
        memcpy(picture->channel[i], &bits, sizeof picture->channel[i]);
    }
}

struct vec2 random_uv(struct random *random) {
    double reach = random_bits(random) % 8 == 0 ? 2 : 0.2;
    struct vec2 uv = {random_real(random, -reach, 1 + reach),
                      random_real(random, -reach, 1 + reach)};
    if (random_bits(random) % 8 == 0) {
        uv.x = (double)random_between(random, 0, 2 * PICTURE_SIDE) / (2 * PICTURE_SIDE);
    }
    return uv;
}

bool texture_of_picture(const struct picture *picture, struct texture *texture) {
    struct picture copy = *picture;
    struct image image = {copy.width, copy.height, IMAGE_BGRA, copy.channel[0]};
    struct error error;
    bool made = texture_create(texture, &image, &error);
    texture_set_clamp(texture, copy.clamp);
    return made;
}

struct real3 exact_color(const struct texture *texture, size_t level, struct vec2 uv) {
    struct sample sample = exact_bilinear(texture, level, uv.x, uv.y);
    return (struct real3){sample.channel[0], sample.channel[1], sample.channel[2]};
}

/* A component is off by twice what a texel is, since it goes from -1 to 1. */
struct real3 exact_normal(const struct texture *texture, size_t level, struct vec2 uv,
                          long double *roundings) {
    struct real3 c = real3_scale(exact_color(texture, level, uv), 2 / 255.0L);
    struct real3 direction = {c.x - 1, c.y - 1, c.z - 1};
    *roundings = 2 * TEXEL_ROUNDINGS / real3_length(direction) + 8;
    return real3_unit(direction);
}
