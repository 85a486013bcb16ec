/* The triangles of step 9: see lesson.h and recorder.h. */
#include "bench/opengl/include_lesson.h"
#include "bench/opengl/recorder.h"

#include "../../../step09_shaders/main.c"

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
    const struct program *program = NULL;
    lesson_main(0, (char **)&program);
    return record_scene(program, scene, drawing, image, picture, error);
}

lesson_function lesson_step09;
struct lesson lesson_step09(void) {
    const struct program *program = NULL;
    lesson_main(0, (char **)&program);
    return (struct lesson){program, sizeof(struct recorder), NULL, left_out, NULL, build, NULL};
}
