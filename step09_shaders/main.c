/*
 * Step 9: shaders.
 *
 * Steps 4 to 8 repeated one loop over faces and one over pixels, and changed only what a corner
 * hands over and what a pixel makes of it. Here the loops are common/pipeline.h, and the two parts
 * that change are the functions of a `shader`.
 */
#include "pipeline.h"
#include "program.h"

/* What is the same for all pixels of a drawing. */
struct uniforms {
    const struct model *model;
    const struct texture *diffuse, *normal_map; /* NULL where the shader reads none */
    size_t diffuse_level, normal_level;         /* mip levels */
    struct vec3 to_light;                       /* of length 1 */
};

/* ---- Shared by the shaders ---- */

/* How much light a surface with this normal (of any length) gets: 0 when it is turned away. */
static double lambert(struct vec3 normal, struct vec3 to_light) {
    double intensity = vec3_dot(vec3_normalized(normal), to_light);
    return intensity > 0 ? intensity : 0;
}

static struct vec3 face_normal(const struct model *model, size_t face) {
    struct vec3 a = model_position(model, face, 0);
    struct vec3 b = model_position(model, face, 1);
    struct vec3 c = model_position(model, face, 2);
    return vec3_cross(vec3_sub(b, a), vec3_sub(c, a));
}

/* Red, green, blue 0..255, times an intensity. */
static struct color shade(struct vec4 rgb, double intensity) {
    return color_rgb(level_from(rgb.x * intensity), level_from(rgb.y * intensity),
                     level_from(rgb.z * intensity));
}

static const struct vec4 white = {255, 255, 255, 255};

/* ---- Flat: one intensity for a face ---- */

static void flat_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    (void)corner;
    varyings[0] = lambert(face_normal(u->model, face), u->to_light);
}

static bool white_fragment(const void *uniforms, const double *varyings, struct color *color) {
    (void)uniforms;
    *color = shade(white, varyings[0]);
    return true;
}

SHADER(flat, 1, flat_vertex, white_fragment);

/* ---- Gouraud: an intensity for each corner ---- */

static void gouraud_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    varyings[0] = lambert(model_normal(u->model, face, corner), u->to_light);
}

SHADER(gouraud, 1, gouraud_vertex, white_fragment);

/* ---- The same two with the texture's colours ---- */

static void pass_uv(const struct uniforms *u, size_t face, size_t corner, double *varyings) {
    struct vec2 uv = model_uv(u->model, face, corner);
    varyings[0] = uv.x;
    varyings[1] = uv.y;
}

static void flat_textured_vertex(const void *uniforms, size_t face, size_t corner,
                                 double *varyings) {
    pass_uv(uniforms, face, corner, varyings);
    flat_vertex(uniforms, face, corner, varyings + 2);
}

static void gouraud_textured_vertex(const void *uniforms, size_t face, size_t corner,
                                    double *varyings) {
    pass_uv(uniforms, face, corner, varyings);
    gouraud_vertex(uniforms, face, corner, varyings + 2);
}

static bool textured_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec2 uv = {varyings[0], varyings[1]};
    *color = shade(texture_bilinear(u->diffuse, uv, u->diffuse_level), varyings[2]);
    return true;
}

SHADER(flat_textured, 3, flat_textured_vertex, textured_fragment);
SHADER(gouraud_textured, 3, gouraud_textured_vertex, textured_fragment);

/* ---- Toon: Gouraud in five levels ---- */

static bool toon_fragment(const void *uniforms, const double *varyings, struct color *color) {
    static const struct vec4 orange = {255, 155, 0, 255};
    (void)uniforms;
    double step = floor(varyings[0] * 5);
    *color = shade(orange, (step < 4 ? step : 4) / 4);
    return true;
}

SHADER(toon, 1, gouraud_vertex, toon_fragment);

/* ---- Normals from the normal map, pixel by pixel ---- */

static void uv_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    pass_uv(uniforms, face, corner, varyings);
}

static bool normal_map_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct uniforms *u = uniforms;
    struct vec2 uv = {varyings[0], varyings[1]};
    struct vec4 n = texture_bilinear(u->normal_map, uv, u->normal_level);
    struct vec3 normal = {n.x / 127.5 - 1, n.y / 127.5 - 1, n.z / 127.5 - 1};
    *color =
        shade(texture_bilinear(u->diffuse, uv, u->diffuse_level), lambert(normal, u->to_light));
    return true;
}

SHADER(normal_mapped, 2, uv_vertex, normal_map_fragment);

/* ---- Two-sided: a face seen from behind is lit as if its normal pointed to that side ---- */

static void two_sided_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    (void)corner;
    varyings[0] = fabs(vec3_dot(vec3_normalized(face_normal(u->model, face)), u->to_light));
}

SHADER(two_sided, 1, two_sided_vertex, white_fragment);

/* ---- Culled by the light, as in steps 4 to 7: what gets no light is not drawn at all ---- */

static bool lit_only_fragment(const void *uniforms, const double *varyings, struct color *color) {
    (void)uniforms;
    *color = shade(white, varyings[0]);
    return varyings[0] > 0; /* false discards the pixel */
}

DISCARDING_SHADER(culled_by_light, 1, flat_vertex, lit_only_fragment);

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

/* The drawing's camera, in one cell of a grid over the image. */
static struct draw_call call_in_cell(const struct drawing *drawing, struct rectangle cell,
                                     double zoom, enum cull cull) {
    return camera_call(drawing->model, drawing->eye, drawing->center, drawing->up, zoom, cell,
                       cull);
}

enum { NEEDS_NORMALS = 1, NEEDS_DIFFUSE = 2, NEEDS_NORMAL_MAP = 4 };

/* Load what the shader reads, and nothing else. */
static bool make_uniforms(struct drawing *drawing, unsigned needs, double pixels,
                          struct uniforms *uniforms, struct error *error) {
    struct model *model = drawing->model;
    *uniforms = (struct uniforms){.model = model, .to_light = vec3_normalized(drawing->light)};
    if ((needs & NEEDS_NORMALS) != 0 && !model_need_normals(model, error)) {
        return false;
    }
    if ((needs & NEEDS_DIFFUSE) != 0) {
        uniforms->diffuse = model_texture(model, MODEL_DIFFUSE, error);
        if (uniforms->diffuse == NULL) {
            return false;
        }
        uniforms->diffuse_level = wrapped_level(uniforms->diffuse, pixels);
    }
    if ((needs & NEEDS_NORMAL_MAP) != 0) {
        uniforms->normal_map = model_texture(model, MODEL_NORMAL_MAP, error);
        if (uniforms->normal_map == NULL) {
            return false;
        }
        uniforms->normal_level = wrapped_level(uniforms->normal_map, pixels);
    }
    return true;
}

static void count_stats(struct drawing *drawing, const struct pipeline *pipeline) {
    for (int i = 0; i < PIPELINE_STATS; i++) {
        count(drawing, pipeline_stat_name[i], pipeline->stats[i]);
    }
}

static struct pipeline *begin_frame(struct drawing *drawing) {
    struct state *state = drawing->state;
    state->pipeline.skip = drawing->skip;
    pipeline_clear(&state->pipeline);
    return &state->pipeline;
}

static bool draw_four(struct drawing *drawing, struct image *image, struct error *error) {
    struct pipeline *p = begin_frame(drawing);
    struct uniforms u;
    const double zoom = 0.8; /* of a quarter: 0.4 of the picture */
    if (!make_uniforms(drawing, NEEDS_NORMALS | NEEDS_DIFFUSE, 0.4 * (double)image->width, &u,
                       error)) {
        return false;
    }
    struct draw_call call[4];
    for (int i = 0; i < 4; i++) {
        call[i] = call_in_cell(drawing, grid_cell(image->width, image->height, 2, 2, i % 2, i / 2),
                               zoom, CULL_BACK);
    }
    bool done = pipeline_draw(p, &call[0], &flat, &u, image, error) &&
                pipeline_draw(p, &call[1], &gouraud, &u, image, error) &&
                pipeline_draw(p, &call[2], &flat_textured, &u, image, error) &&
                pipeline_draw(p, &call[3], &gouraud_textured, &u, image, error);
    count_stats(drawing, p);
    return done;
}

static bool draw_toon(struct drawing *drawing, struct image *image, struct error *error) {
    struct pipeline *p = begin_frame(drawing);
    struct uniforms u;
    if (!make_uniforms(drawing, NEEDS_NORMALS, (double)image->width, &u, error)) {
        return false;
    }
    struct draw_call call =
        call_in_cell(drawing, grid_cell(image->width, image->height, 1, 1, 0, 0), 0.85, CULL_BACK);
    bool done = pipeline_draw(p, &call, &toon, &u, image, error);
    count_stats(drawing, p);
    return done;
}

static bool draw_normal_map(struct drawing *drawing, struct image *image, struct error *error) {
    struct pipeline *p = begin_frame(drawing);
    struct uniforms u;
    if (!make_uniforms(drawing, NEEDS_DIFFUSE | NEEDS_NORMAL_MAP, (double)image->width, &u,
                       error)) {
        return false;
    }
    struct draw_call call =
        call_in_cell(drawing, grid_cell(image->width, image->height, 1, 1, 0, 0), 0.85, CULL_BACK);
    bool done = pipeline_draw(p, &call, &normal_mapped, &u, image, error);
    count_stats(drawing, p);
    return done;
}

/* Above: without the faces turned away from the camera; without those turned towards it. Below:
 * with all faces (the same picture as the first, with more work); culled by the light. */
static bool draw_culling(struct drawing *drawing, struct image *image, struct error *error) {
    static const enum cull culls[] = {CULL_BACK, CULL_FRONT, CULL_NONE, CULL_NONE};
    struct pipeline *p = begin_frame(drawing);
    struct uniforms u;
    if (!make_uniforms(drawing, 0, (double)image->width / 2, &u, error)) {
        return false;
    }
    struct draw_call call[4];
    for (int i = 0; i < 4; i++) {
        struct rectangle cell = grid_cell(image->width, image->height, 2, 2, i % 2, i / 2);
        call[i] = call_in_cell(drawing, cell, 0.85, culls[i]);
    }
    bool done = pipeline_draw(p, &call[0], &two_sided, &u, image, error) &&
                pipeline_draw(p, &call[1], &two_sided, &u, image, error) &&
                pipeline_draw(p, &call[2], &two_sided, &u, image, error) &&
                pipeline_draw(p, &call[3], &culled_by_light, &u, image, error);
    count_stats(drawing, p);
    return done;
}

/* Where the camera of all scenes is. */
#define CAMERA .eye = {1, 0.5, 3}, .center = {0, 0, 0}, .up = {0, 1, 0}, .needs_model = true

int main(int argc, char **argv) {
    static const struct scene scenes[] = {
        {.name = "four",
         .width = 800,
         .height = 800,
         .draw = draw_four,
         CAMERA,
         .light = {1, 1, 1}},
        {.name = "toon",
         .width = 800,
         .height = 800,
         .draw = draw_toon,
         CAMERA,
         .light = {1, 1, 1}},
        {.name = "normalmap",
         .width = 800,
         .height = 800,
         .draw = draw_normal_map,
         CAMERA,
         .light = {1, 1, 1}},
        {.name = "culling", /* with the light from the side */
         .width = 800,
         .height = 800,
         .draw = draw_culling,
         CAMERA,
         .light = {1, 0.2, 0}},
    };
    static const struct program program = {
        .name = "step09_shaders",
        .summary = "one pipeline, many looks: shaders",
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
