/* The triangles of step 10: see compared.h and recorder.h. */
#include "bench/opengl/compared.h"
#include "bench/opengl/recorder.h"

#define LESSON "../step10_phong/main.c"
#include "lesson.h"

static const char *left_out(const char *scene) {
    return strcmp(scene, "near") == 0 ? "some of its faces are cut at the near plane" : NULL;
}

static bool describe_shader(const struct shader *shader, const void *uniforms,
                            struct batch *batch) {
    const struct uniforms *u = uniforms;
    const struct material *m = &u->material;
    batch->values = (struct look_values){
        .diffuse_map = u->diffuse,
        .normal_map = u->normal_map,
        .specular_map = u->specular,
        .diffuse_level = u->diffuse_level,
        .normal_level = u->normal_level,
        .specular_level = u->specular_level,
        .to_light = u->to_light,
        .ambient = m->ambient,
        .diffuse = m->diffuse,
        .specular = m->specular,
        .power = m->power,
        .color = {m->color.x, m->color.y, m->color.z},
    };
    if (shader->fragment == plain_fragment) {
        batch->look = LOOK_PHONG_PLAIN;
    } else if (shader->fragment == mapped_fragment) {
        batch->look = LOOK_PHONG_MAPPED;
    } else if (shader->fragment == textured_fragment) {
        batch->look = LOOK_PHONG_TEXTURED;
    } else if (shader->fragment == full_fragment) {
        batch->look = LOOK_PHONG_FULL;
    } else if (shader->fragment == weight_map_fragment) {
        batch->look = LOOK_PHONG_WEIGHT_MAP;
    } else if (shader->fragment == power_map_fragment) {
        batch->look = LOOK_PHONG_POWER_MAP;
    } else {
        return false;
    }
    return true;
}

static bool build(const char *scene, struct drawing *drawing, struct image *image,
                  struct picture *picture, struct error *error) {
    return record_scene(&step10_phong, scene, drawing, image, picture, error);
}

const struct lesson lesson_step10 = {
    .program = &step10_phong,
    .state_size = sizeof(struct recorder),
    .left_out = left_out,
    .build = build,
};
