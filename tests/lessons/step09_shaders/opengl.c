/* The triangles of step 9: see compared.h and recorder.h. */
#include "bench/opengl/compared.h"
#include "bench/opengl/recorder.h"

#define LESSON "../step09_shaders/main.c"
#include "lesson.h"

#include <string.h>

static const char *left_out(const char *scene) {
    static const char *const simple[] = {"loops", "looks", "more_looks"};
    for (size_t i = 0; i < sizeof simple / sizeof simple[0]; i++) {
        if (strcmp(scene, simple[i]) == 0) {
            return "all of it: drawn without the pipeline; the other scenes have the same looks";
        }
    }
    return NULL;
}

static bool describe_shader(const struct shader *shader, const void *uniforms,
                            struct batch *batch) {
    const struct uniforms *u = uniforms;
    batch->values = (struct look_values){
        .diffuse_map = u->diffuse,
        .normal_map = u->normal_map,
        .diffuse_level = u->diffuse_level,
        .normal_level = u->normal_level,
        .to_light = u->to_light,
    };
    if (shader->fragment == white_fragment) {
        batch->look = LOOK_WHITE;
    } else if (shader->fragment == lit_only_fragment) {
        batch->look = LOOK_LIT_ONLY;
    } else if (shader->fragment == textured_fragment) {
        batch->look = LOOK_BILINEAR;
    } else if (shader->fragment == toon_fragment) {
        batch->look = LOOK_TOON;
    } else if (shader->fragment == normal_map_fragment) {
        batch->look = LOOK_NORMAL_MAP;
    } else {
        return false;
    }
    return true;
}

static bool build(const char *scene, struct drawing *drawing, struct image *image,
                  struct picture *picture, struct error *error) {
    return record_scene(&step09_shaders, scene, drawing, image, picture, error);
}

const struct lesson lesson_step09 = {
    .program = &step09_shaders,
    .state_size = sizeof(struct recorder),
    .left_out = left_out,
    .build = build,
};
