/* The course's side: see ours.h. All that knows the pipeline stands here. */
#include "ours.h"

#include <string.h>

/* ---- Shaders; the uniforms are the scene itself ---- */

static double light_on(const struct frame_scene *scene, const float normal[3]) {
    double light = vec3_dot((struct vec3){normal[0], normal[1], normal[2]}, scene->to_light);
    return light > 0 ? light : 0;
}

static struct vec4 sample(const struct frame_scene *scene, enum model_texture_kind kind,
                          struct vec2 uv) {
    return texture_bilinear(scene->textures[kind].texture, uv, scene->textures[kind].level);
}

static void flat_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct frame_scene *scene = uniforms;
    (void)corner;
    varyings[0] = light_on(scene, scene->head->face_normals[face]);
}

static bool flat_fragment(const void *uniforms, const double *varyings, struct color *color) {
    (void)uniforms;
    *color = color_grey(level_from(255 * varyings[0]));
    return true;
}

static void gouraud_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct frame_scene *scene = uniforms;
    const struct model *model = scene->call.model;
    struct vec2 uv = model_uv(model, face, corner);
    varyings[0] = light_on(scene, model->normals[model->faces[face].corner[corner].normal]);
    varyings[1] = uv.x;
    varyings[2] = uv.y;
}

static bool gouraud_fragment(const void *uniforms, const double *varyings, struct color *color) {
    struct vec4 rgb = sample(uniforms, MODEL_DIFFUSE, (struct vec2){varyings[1], varyings[2]});
    *color = color_rgb(level_from(rgb.x * varyings[0]), level_from(rgb.y * varyings[0]),
                       level_from(rgb.z * varyings[0]));
    return true;
}

static void phong_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct model *model = ((const struct frame_scene *)uniforms)->call.model;
    struct vec3 position = model_position(model, face, corner);
    struct vec2 uv = model_uv(model, face, corner);
    varyings[0] = position.x;
    varyings[1] = position.y;
    varyings[2] = position.z;
    varyings[3] = uv.x;
    varyings[4] = uv.y;
}

static double tenth_power(double x) {
    double square = x * x, fourth = square * square;
    return fourth * fourth * square;
}

static bool phong_fragment(const void *uniforms, const double *varyings, struct color *color) {
    const struct frame_scene *scene = uniforms;
    struct vec3 position = {varyings[0], varyings[1], varyings[2]};
    struct vec2 uv = {varyings[3], varyings[4]};
    struct vec4 rgb = sample(scene, MODEL_DIFFUSE, uv), n = sample(scene, MODEL_NORMAL_MAP, uv);
    double weight = sample(scene, MODEL_SPECULAR, uv).x;
    struct vec3 normal =
        vec3_normalized((struct vec3){n.x / 127.5 - 1, n.y / 127.5 - 1, n.z / 127.5 - 1});
    struct vec3 to_eye = vec3_normalized(vec3_sub(scene->eye, position));
    double light = vec3_dot(normal, scene->to_light);
    struct vec3 mirrored = vec3_sub(vec3_scale(normal, 2 * light), scene->to_light);
    double near = vec3_dot(mirrored, to_eye);
    double shine = light > 0 && near > 0 ? weight * tenth_power(near) : 0;
    double scattered = AMBIENT + (light > 0 ? light : 0);
    *color = color_rgb(level_from(rgb.x * scattered + shine), level_from(rgb.y * scattered + shine),
                       level_from(rgb.z * scattered + shine));
    return true;
}

SHADER(flat, .varying_count = 1, .vertex = flat_vertex, .fragment = flat_fragment);
SHADER(gouraud, .varying_count = 3, .vertex = gouraud_vertex, .fragment = gouraud_fragment);
SHADER(phong, .varying_count = 5, .vertex = phong_vertex, .fragment = phong_fragment);

static const struct shader *const shaders[FRAME_LOOKS] = {
    [FRAME_FLAT] = &flat, [FRAME_GOURAUD] = &gouraud, [FRAME_PHONG] = &phong};

/* ---- Frames ---- */

bool ours_load(struct ours *ours, const struct frame_scene *scene, size_t threads,
               struct error *error) {
    ours_free(ours);
    ours->scene = *scene;
    if (!image_create(&ours->image, scene->width, scene->height, IMAGE_BGRA, error) ||
        !pipeline_create(&ours->pipeline, scene->width, scene->height, error)) {
        return false;
    }
    pipeline_use_threads(&ours->pipeline, threads);
    return true;
}

bool ours_draw(struct ours *ours, struct error *error) {
    memset(ours->image.pixels, 0, ours->image.width * ours->image.height * IMAGE_BGRA);
    pipeline_clear(&ours->pipeline);
    return pipeline_draw(&ours->pipeline, &ours->scene.call, shaders[ours->scene.look],
                         &ours->scene, &ours->image, error);
}

void ours_free(struct ours *ours) {
    pipeline_free(&ours->pipeline);
    image_free(&ours->image);
    *ours = (struct ours){0};
}
