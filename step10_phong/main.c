/*
 * Step 10: Phong's reflection model, at every pixel.
 *
 * The light that a pixel sends to the eye is the sum of three parts: ambient (from everywhere),
 * diffuse (scattered by the surface) and specular (mirrored towards the eye, more or less sharply).
 * The normal comes from the mesh or from the normal map, the colour from a constant or the texture.
 */
#include "pipeline.h"
#include "program.h"

/* How a surface answers to light. */
struct material {
    double ambient, diffuse, specular; /* weights of the three parts */
    int power;         /* of the specular part: larger makes smaller, sharper lights */
    struct vec4 color; /* red, green, blue 0..255, where no texture is used */
};

/* What is the same for all pixels of a drawing. */
struct uniforms {
    const struct model *model;
    const struct texture *diffuse, *normal_map, *specular; /* NULL where none is used */
    size_t diffuse_level, normal_level, specular_level;    /* mip levels */
    struct vec3 eye;
    struct vec3 to_light; /* of length 1 */
    struct material material;
};

/* ---- The technique ---- */

/* base to a small whole power, by multiplying: base^0 is 1. */
static double integer_power(double base, int power) {
    double result = 1;
    for (; power > 0; power /= 2) {
        if (power % 2 == 1) {
            result *= base;
        }
        base *= base;
    }
    return result;
}

/* Where light from direction `to_light` goes after a mirror: r = 2 (n . l) n - l. */
static struct vec3 reflect(struct vec3 normal, struct vec3 to_light) {
    return vec3_sub(vec3_scale(normal, 2 * vec3_dot(normal, to_light)), to_light);
}

/* Diffuse and specular intensity of a point (Phong, "Illumination for Computer Generated Pictures",
 * CACM 18(6), 1975). All vectors of length 1. A surface turned away from the light gets neither. */
static struct vec2 phong(struct vec3 normal, struct vec3 to_light, struct vec3 to_eye, int power) {
    double diffuse = vec3_dot(normal, to_light);
    if (!(diffuse > 0)) {
        return (struct vec2){0, 0};
    }
    double mirrored = vec3_dot(reflect(normal, to_light), to_eye);
    return (struct vec2){diffuse, integer_power(mirrored > 0 ? mirrored : 0, power)};
}

/* Add up the three parts. The specular part has the colour of the light, which is white. */
static struct color illuminate(const struct uniforms *u, struct vec4 rgb, struct vec3 normal,
                               struct vec3 position, double specular_weight) {
    struct vec3 to_eye = vec3_normalized(vec3_sub(u->eye, position));
    struct vec2 light = phong(normal, u->to_light, to_eye, u->material.power);
    double scattered = u->material.ambient + u->material.diffuse * light.x;
    double mirrored = 255 * specular_weight * light.y;
    return color_rgb(level_from(rgb.x * scattered + mirrored),
                     level_from(rgb.y * scattered + mirrored),
                     level_from(rgb.z * scattered + mirrored));
}

/* ---- Varyings: position, texture coordinates, normal ---- */

static void vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    struct vec3 position = model_position(u->model, face, corner);
    struct vec2 uv = model_uv(u->model, face, corner);
    varyings[0] = position.x;
    varyings[1] = position.y;
    varyings[2] = position.z;
    varyings[3] = uv.x;
    varyings[4] = uv.y;
}

static void vertex_with_normal(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    vertex(uniforms, face, corner, varyings);
    struct vec3 normal = vec3_normalized(model_normal(u->model, face, corner));
    varyings[5] = normal.x;
    varyings[6] = normal.y;
    varyings[7] = normal.z;
}

static struct vec3 position_of(const double *varyings) {
    return (struct vec3){varyings[0], varyings[1], varyings[2]};
}

static struct vec2 uv_of(const double *varyings) {
    return (struct vec2){varyings[3], varyings[4]};
}

/* The mean of unit vectors is shorter than 1: bring it back to length 1. */
static struct vec3 mesh_normal(const double *varyings) {
    return vec3_normalized((struct vec3){varyings[5], varyings[6], varyings[7]});
}

static struct vec3 mapped_normal(const struct uniforms *u, struct vec2 uv) {
    struct vec4 n = texture_bilinear(u->normal_map, uv, u->normal_level);
    return vec3_normalized((struct vec3){n.x / 127.5 - 1, n.y / 127.5 - 1, n.z / 127.5 - 1});
}

/* ---- Shaders ---- */

static bool plain_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    *color = illuminate(u, u->material.color, mesh_normal(varyings), position_of(varyings),
                        u->material.specular);
    return true;
}

static bool mapped_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec3 normal = mapped_normal(u, uv_of(varyings));
    *color = illuminate(u, u->material.color, normal, position_of(varyings), u->material.specular);
    return true;
}

static bool textured_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec4 rgb = texture_bilinear(u->diffuse, uv_of(varyings), u->diffuse_level);
    *color = illuminate(u, rgb, mesh_normal(varyings), position_of(varyings), u->material.specular);
    return true;
}

static bool full_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec2 uv = uv_of(varyings);
    struct vec4 rgb = texture_bilinear(u->diffuse, uv, u->diffuse_level);
    *color = illuminate(u, rgb, mapped_normal(u, uv), position_of(varyings), u->material.specular);
    return true;
}

/* The same with the weight of the specular part read from the specular map. */
static bool weight_map_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec2 uv = uv_of(varyings);
    struct vec4 rgb = texture_bilinear(u->diffuse, uv, u->diffuse_level);
    double weight = texture_bilinear(u->specular, uv, u->specular_level).x / 255;
    *color = illuminate(u, rgb, mapped_normal(u, uv), position_of(varyings),
                        weight * u->material.specular);
    return true;
}

/* The same with the power read from it: 1 for level 0 to 32 for level 255. */
static bool power_map_fragment(const void *uniforms, const double *varyings, struct color *color) {
    struct uniforms u = *(const struct uniforms *)uniforms;
    struct vec2 uv = uv_of(varyings);
    struct vec4 rgb = texture_bilinear(u.diffuse, uv, u.diffuse_level);
    u.material.power = 1 + (int)texture_bilinear(u.specular, uv, u.specular_level).x / 8;
    *color = illuminate(&u, rgb, mapped_normal(&u, uv), position_of(varyings), u.material.specular);
    return true;
}

SHADER(plain, 8, vertex_with_normal, plain_fragment);
SHADER(mapped, 5, vertex, mapped_fragment);
SHADER(textured, 8, vertex_with_normal, textured_fragment);
SHADER(full, 5, vertex, full_fragment);
SHADER(weight_mapped, 5, vertex, weight_map_fragment);
SHADER(power_mapped, 5, vertex, power_map_fragment);

static const struct material plain_material = {0.1, 1, 0.5, 10, {255, 128, 255, 255}};
static const struct material textured_material = {0.1, 1, 1, 10, {255, 255, 255, 255}};

/* ---- Scenes ---- */

struct state {
    struct pipeline pipeline;
};

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    struct state *state = drawing->state;
    return pipeline_create(&state->pipeline, width, height, error);
}

static void finish(struct drawing *drawing) {
    struct state *state = drawing->state;
    pipeline_free(&state->pipeline);
}

enum { NEEDS_NORMALS = 1, NEEDS_DIFFUSE = 2, NEEDS_NORMAL_MAP = 4, NEEDS_SPECULAR = 8 };

/* A texture of the model and the mip level for a model that is seen over so many pixels. */
static bool need_texture(struct model *model, enum model_texture_kind kind, double pixels,
                         const struct texture **texture, size_t *level, struct error *error) {
    *texture = model_texture(model, kind, error);
    if (*texture != NULL) {
        *level = wrapped_level(*texture, pixels);
    }
    return *texture != NULL;
}

/* Load what the shaders of a scene read, and nothing else. */
static bool make_uniforms(struct drawing *drawing, unsigned needs, double pixels,
                          struct uniforms *u, struct error *error) {
    struct model *model = drawing->model;
    *u = (struct uniforms){.model = model,
                           .eye = drawing->eye,
                           .to_light = vec3_normalized(drawing->light),
                           .material = plain_material};
    return ((needs & NEEDS_NORMALS) == 0 || model_need_normals(model, error)) &&
           ((needs & NEEDS_DIFFUSE) == 0 ||
            need_texture(model, MODEL_DIFFUSE, pixels, &u->diffuse, &u->diffuse_level, error)) &&
           ((needs & NEEDS_NORMAL_MAP) == 0 ||
            need_texture(model, MODEL_NORMAL_MAP, pixels, &u->normal_map, &u->normal_level,
                         error)) &&
           ((needs & NEEDS_SPECULAR) == 0 ||
            need_texture(model, MODEL_SPECULAR, pixels, &u->specular, &u->specular_level, error));
}

static struct pipeline *begin_frame(struct drawing *drawing) {
    struct state *state = drawing->state;
    state->pipeline.skip = drawing->skip;
    pipeline_clear(&state->pipeline);
    return &state->pipeline;
}

static void count_stats(struct drawing *drawing, const struct pipeline *pipeline) {
    for (int i = 0; i < PIPELINE_STATS; i++) {
        count(drawing, pipeline_stat_name[i], pipeline->stats[i]);
    }
}

/* The drawing's camera, in one cell of a grid over the image. */
static struct draw_call call_in_cell(const struct drawing *drawing, struct rectangle cell,
                                     double zoom) {
    return camera_call(drawing->model, drawing->eye, drawing->center, drawing->up, zoom, cell,
                       CULL_BACK);
}

/* Phong alone, with the normal map, with the texture, and with both. */
static bool draw_four(struct drawing *drawing, struct image *image, struct error *error) {
    struct pipeline *p = begin_frame(drawing);
    struct uniforms u;
    if (!make_uniforms(drawing, NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
                       0.4 * (double)image->width, &u, error)) {
        return false;
    }
    struct draw_call call[4];
    for (int i = 0; i < 4; i++) {
        struct rectangle cell = grid_cell(image->width, image->height, 2, 2, i % 2, i / 2);
        call[i] = call_in_cell(drawing, cell, 0.8); /* of a quarter: 0.4 of the picture */
    }
    bool done = pipeline_draw(p, &call[0], &plain, &u, image, error) &&
                pipeline_draw(p, &call[1], &mapped, &u, image, error);
    u.material = textured_material;
    done = done && pipeline_draw(p, &call[2], &textured, &u, image, error) &&
           pipeline_draw(p, &call[3], &full, &u, image, error);
    count_stats(drawing, p);
    return done;
}

/* Powers 0 to 10 and three large ones; then the textured head with the weight, and with the power,
 * from the specular map. */
static bool draw_powers(struct drawing *drawing, struct image *image, struct error *error) {
    static const int powers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 40, 80};
    struct pipeline *p = begin_frame(drawing);
    struct uniforms u;
    bool done =
        make_uniforms(drawing, NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP | NEEDS_SPECULAR,
                      0.2 * (double)image->width, &u, error);
    for (int i = 0; done && i < 16; i++) {
        struct rectangle cell = grid_cell(image->width, image->height, 4, 4, i % 4, i / 4);
        struct draw_call call = call_in_cell(drawing, cell, 0.8);
        if (i < 14) {
            u.material.power = powers[i];
            done = pipeline_draw(p, &call, &plain, &u, image, error);
        } else {
            u.material = textured_material;
            done =
                pipeline_draw(p, &call, i == 14 ? &weight_mapped : &power_mapped, &u, image, error);
        }
    }
    count_stats(drawing, p);
    return done;
}

enum { TURN_FRAMES = 100 };

/* The light goes once around the head: (sin a, 0, cos a). */
static bool draw_turn(struct drawing *drawing, struct image *image, struct error *error) {
    struct pipeline *p = begin_frame(drawing);
    struct uniforms u;
    if (!make_uniforms(drawing, NEEDS_DIFFUSE | NEEDS_NORMAL_MAP | NEEDS_SPECULAR,
                       0.8 * (double)image->width, &u, error)) {
        return false;
    }
    struct vec2 direction = turn_direction((double)drawing->frame / TURN_FRAMES);
    u.to_light = (struct vec3){direction.y, 0, direction.x};
    u.material = textured_material;
    struct rectangle whole = grid_cell(image->width, image->height, 1, 1, 0, 0);
    struct draw_call call = call_in_cell(drawing, whole, 0.85);
    bool done = pipeline_draw(p, &call, &weight_mapped, &u, image, error);
    count_stats(drawing, p);
    return done;
}

/* Where the camera and the light of all scenes are. */
#define CAMERA                                                                                     \
    .eye = {1, 0.5, 3}, .center = {0, 0, 0}, .up = {0, 1, 0}, .light = {1, 1, 1},                  \
    .needs_model = true

int main(int argc, char **argv) {
    static const struct scene scenes[] = {
        {.name = "four", .width = 800, .height = 800, .draw = draw_four, CAMERA},
        {.name = "powers", .width = 800, .height = 800, .draw = draw_powers, CAMERA},
        {.name = "turn",
         .width = 800,
         .height = 800,
         .frames = TURN_FRAMES,
         .draw = draw_turn,
         CAMERA},
    };
    static const struct program program = {
        .name = "step10_phong",
        .summary = "Phong's light at every pixel, normal map, texture, and a turning light",
        .takes_model = true,
        .takes_light = true,
        .takes_camera = true,
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
        .state_size = sizeof(struct state),
        .prepare = prepare,
        .finish = finish,
    };
    return program_main(&program, argc, argv);
}
