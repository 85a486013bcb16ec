/* Lesson 4 by OpenGL: see picture.h. */
#include "bench/opengl/picture.h"

#define LESSON "../step04_flat/main.c"
#include "lesson.h"

static bool build(struct picture *picture) {
    return picture_add_lit_faces(
        picture, (struct gl_part){.formula = "vec3(255.0 * first.x)", .no_depth_test = true});
}

static const struct compared_scene table[] = {
    {"flat", .build = build},
    {"side", "faces that are not the model's", draw_flat, .build = build},
    {.name = NULL},
};

const struct lesson lesson_step04 = {&step04_flat, table};
