/* Lesson 10 by OpenGL: see picture.h and recorder.h. */
#include "bench/opengl/recorder.h"

#define LESSON "../step10_phong/main.c"
#include "lesson.h"

static const struct known_fragment known[] = {
    {plain_fragment, "illuminate(color, mesh_normal(), weights.z, power)"},
    {mapped_fragment, "illuminate(color, mapped_normal(), weights.z, power)"},
    {textured_fragment, "illuminate(textured(), mesh_normal(), weights.z, power)"},
    {full_fragment, "illuminate(textured(), mapped_normal(), weights.z, power)"},
    {weight_map_fragment,
     "illuminate(textured(), mapped_normal(), specular_value() / 255.0 * weights.z, power)"},
    {power_map_fragment, "illuminate(textured(), mapped_normal(), weights.z, power_of_map())"},
    {NULL, NULL},
};

static struct gl_part describe(const struct shader *shader, const void *uniforms) {
    const struct uniforms *u = uniforms;
    const struct material *m = &u->material;
    return (struct gl_part){
        .formula = formula_of(shader, known),
        .maps = {u->diffuse, u->normal_map, u->specular},
        .levels = {(double)u->diffuse_level, (double)u->normal_level, (double)u->specular_level},
        .weights = {m->ambient, m->diffuse, m->specular},
        .to_light = u->to_light,
        .color = m->color,
        .power = m->power,
    };
}

static const struct compared_scene table[] = {
    {"matt", .build = record},
    {"parts", .build = record},
    {"shine", .build = record},
    {"four", .build = record},
    {"behind", .build = record},
    {"powers", .build = record},
    {"turn", .build = record},
    {"near", .left_out = "two of its maps exist only while the lesson draws it"},
    {.name = NULL},
};

const struct lesson lesson_step10 = {&step10_phong, table};
