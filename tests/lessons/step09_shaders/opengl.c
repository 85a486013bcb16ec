/* Lesson 9 by OpenGL: see picture.h and recorder.h. */
#include "bench/opengl/recorder.h"

#define LESSON "../step09_shaders/main.c"
#include "lesson.h"

#define TEXEL "bilinear(diffuse_map, first.xy, levels.x)"

static const struct known_fragment known[] = {
    {white_fragment, "vec3(255.0 * first.x)"},
    {lit_only_fragment, "vec3(255.0 * first.x)"},
    {textured_fragment, TEXEL " * first.z"},
    {toon_fragment, "toon()"},
    {normal_map_fragment, TEXEL " * max(dot(map_normal(first.xy), to_light), 0.0)"},
    {NULL, NULL},
};

static struct gl_part describe(const struct shader *shader, const void *uniforms) {
    const struct uniforms *u = uniforms;
    return (struct gl_part){
        .formula = formula_of(shader, known),
        .maps = {u->diffuse, u->normal_map},
        .levels = {(double)u->diffuse_level, (double)u->normal_level, 0},
        .to_light = u->to_light,
    };
}

static const struct compared_scene table[] = {
    {"four", .build = record},
    {"toon", .build = record},
    {"normalmap", .build = record},
    {"culling", .build = record},
    {.left_out = "drawn without the pipeline; the other scenes have the same looks"},
};

const struct lesson lesson_step09 = {&step09_shaders, table};
