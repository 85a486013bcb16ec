/*
 * The options of the command line; private to program.c and stage.c.
 *
 * options.c has them in one table: a name, what it wants, a line of help, a function that
 * reads it. To add an option: a row there and a field here.
 */
#ifndef COMMON_RUN_OPTIONS_H
#define COMMON_RUN_OPTIONS_H

#include "files/image_file.h"
#include "run/scene.h"

/* --help ends with it; .github/CHANGELOG.md says what changed. */
#define COURSE_VERSION "1.0"

/* The Makefile tells where it builds, so that a step runs from any working directory. */
#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif
#define OUTPUT_DIRECTORY COURSE_BUILD "/out"
#define MODELS_DIRECTORY COURSE_BUILD "/models"
#define DEFAULT_MODEL    "bust.obj" /* for scenes that name none */

/* NAME=VALUE of a --set. */
struct chosen_value {
    const char *name; /* of `length` bytes */
    size_t length;
    double value;
};

/* The number of a list that this chooses; NULL where it has none of that name. */
const struct scene_value *find_value(const struct scene_value *values,
                                     const struct chosen_value *chosen);

struct vec3_option {
    bool given;
    struct vec3 value;
};

struct size_option {
    size_t width, height; /* 0 where none was given */
};

struct angle_option {
    bool given;
    double degrees;
};

struct pixel_option {
    bool given;
    struct pixel value;
};

struct options {
    const struct program *program;
    const char *input[MODELS_LIMIT]; /* models, or a text scene; NULL behind the last */
    size_t input_count;
    const char *directory;    /* NULL for the default */
    const struct scene *only; /* NULL for several: with `all`, those besides, too */
    struct size_option size;
    const struct image_file_format *format;
    struct vec3_option eye, center, up, light;
    const char *textures[MODEL_TEXTURE_KINDS]; /* files; NULL for those next to the model */
    struct angle_option smooth; /* of the hardest edge that is not hard: see normals.h */
    struct chosen_value set[VALUE_LIMIT];
    size_t set_count;
    int turns[3];  /* quarter turns of the model: see fit.h */
    size_t repeat; /* 0 without --repeat */
    struct pixel_option probe;
    size_t frame; /* 1 and on, of an animation; 0 without --frame */
    bool fit, two_sided, all, stats, no_skip, live, help;
};

/* What one scene needs or another. */
unsigned program_needs(const struct program *program);

/* Read the command line; "--" ends the options. False, with a message, where it is wrong. */
bool options_parse(struct options *options, const struct program *program, int argc, char **argv,
                   struct error *error);

/* Print what --help says. */
void options_print_help(const struct program *program);

#endif
