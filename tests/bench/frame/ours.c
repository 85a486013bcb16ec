/* The course's side: see ours.h. Everything that knows the pipeline is here. */
#include "ours.h"

/* ---- Shaders; the uniforms are the scene itself ---- */

static double light_on(const struct frame_scene *scene, const float normal[3]) {
    double light = vec3_dot((struct vec3){normal[0], normal[1], normal[2]}, scene->to_light);
    return light > 0 ? light : 0;
}

LANES_INLINE struct texels fetch(const struct frame_scene *scene, enum model_texture_kind kind,
                                 struct lanes2 uv, struct texel_place *place) {
    return texture_fetch(scene->textures[kind].texture, uv, scene->textures[kind].level, place);
}

static void flat_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct frame_scene *scene = uniforms;
    (void)corner;
    varyings[0] = light_on(scene, scene->head->face_normals[face]);
}

static lanes_mask flat_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    lanes level = 255 * varyings[0];
    *color = lanes_rgb(level, level, level);
    return lanes_all_set();
}

static void gouraud_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct frame_scene *scene = uniforms;
    const struct model *model = scene->call.model;
    struct vec2 uv = model_uv(model, face, corner);
    varyings[0] = light_on(scene, model->normals[model->faces[face].corner[corner].normal]);
    varyings[1] = uv.x;
    varyings[2] = uv.y;
}

static lanes_mask gouraud_fragment(const void *uniforms, const lanes *varyings,
                                   lanes_texel *color) {
    const struct frame_texture *diffuse =
        &((const struct frame_scene *)uniforms)->textures[MODEL_DIFFUSE];
    struct lanes2 uv = {varyings[1], varyings[2]};
    struct lanes3 rgb = texture_lanes(diffuse->texture, uv, diffuse->level);
    *color = lanes_rgb(rgb.x * varyings[0], rgb.y * varyings[0], rgb.z * varyings[0]);
    return lanes_all_set();
}

static void phong_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct frame_scene *scene = uniforms;
    const struct model *model = scene->call.model;
    struct vec3 to_eye = vec3_sub(scene->eye, model_position(model, face, corner));
    struct vec2 uv = model_uv(model, face, corner);
    varyings[0] = to_eye.x;
    varyings[1] = to_eye.y;
    varyings[2] = to_eye.z;
    varyings[3] = uv.x;
    varyings[4] = uv.y;
}

static lanes tenth_power(lanes x) {
    lanes square = x * x, fourth = square * square;
    return fourth * fourth * square;
}

static lanes_mask phong_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct frame_scene *scene = uniforms;
    struct lanes2 uv = {varyings[3], varyings[4]};
    struct texel_place place = {0};
    struct texels diffuse = fetch(scene, MODEL_DIFFUSE, uv, &place);
    struct texels map = fetch(scene, MODEL_NORMAL_MAP, uv, &place);
    struct texels specular = fetch(scene, MODEL_SPECULAR, uv, &place);
    struct lanes3 rgb = texels_mix(&diffuse), n = texels_mix(&map), zero = {0};
    struct lanes3 normal =
        lanes3_normalized((struct lanes3){n.x - 127.5f, n.y - 127.5f, n.z - 127.5f});
    struct lanes3 to_eye =
        lanes3_normalized((struct lanes3){varyings[0], varyings[1], varyings[2]});
    struct lanes3 to_light = lanes3_all(scene->to_light);
    lanes light = lanes3_dot(normal, to_light);
    struct lanes3 mirrored = lanes3_sub(lanes3_scale(normal, 2 * light), to_light);
    lanes near = lanes_max(lanes3_dot(mirrored, to_eye), zero.x);
    lanes shine = lanes_select(light > 0, texels_mix(&specular).z * tenth_power(near), zero.x);
    lanes scattered = (real)AMBIENT + lanes_max(light, zero.x);
    *color =
        lanes_rgb(rgb.x * scattered + shine, rgb.y * scattered + shine, rgb.z * scattered + shine);
    return lanes_all_set();
}

SHADER(flat, .varying_count = 1, .flat = true, .vertex = flat_vertex, .fragment = flat_fragment);
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
    ours->pipeline.clears_image = true;
    pipeline_use_threads(&ours->pipeline, threads);
    return true;
}

bool ours_draw(struct ours *ours, struct error *error) {
    pipeline_clear(&ours->pipeline);
    return pipeline_draw(&ours->pipeline, &ours->scene.call, shaders[ours->scene.look],
                         &ours->scene, sizeof ours->scene, error) &&
           pipeline_finish(&ours->pipeline, &ours->image, error);
}

void ours_free(struct ours *ours) {
    pipeline_free(&ours->pipeline);
    image_free(&ours->image);
    *ours = (struct ours){0};
}
