/*
 * What the main() of every step shares: options, loading, timing, counting, saving, errors.
 *
 * A step describes itself in a struct program: its scenes, each with a function that draws it, and
 * which options make sense for it. program_main() does the rest:
 *
 *     static bool draw_pixel(struct drawing *drawing, struct image *image, struct error *error) {
 *         ...
 *     }
 *
 *     int main(int argc, char **argv) {
 *         static const struct scene scenes[] = {
 *             {.name = "pixel", .width = 100, .height = 100, .draw = draw_pixel},
 *         };
 *         static const struct program program = {
 *             .name = "step01_line", .summary = "...", .scenes = scenes, .scene_count = 1,
 *         };
 *         return program_main(&program, argc, argv);
 *     }
 */
#ifndef COMMON_PROGRAM_H
#define COMMON_PROGRAM_H

#include "file.h"
#include "geometry.h"
#include "model.h"
#include "raster.h"
#include "text_scene.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { COUNTER_LIMIT = 32 }; /* different names that one scene counts */

struct counter {
    const char *name;
    uint64_t value;
};

/* What a scene is drawn from. The draw function reads all of it and may change `state`. */
struct drawing {
    struct model *model;           /* loaded when the scene needs it, otherwise NULL */
    const struct text_scene *text; /* the text scene named on the command line, otherwise NULL */
    struct vec3 eye, center, up;   /* the scene's own values, or those of the options */
    struct vec3 light;             /* direction, as given: not normalised */
    bool skip;                     /* false with --no-skip: do all the work; same image */
    size_t frame;                  /* of an animation, from 0 */
    void *state;                   /* program.state_size bytes for this scene, zero at first */
    struct counter counters[COUNTER_LIMIT];
    size_t counter_count;
};

/* Add to the counter of that name (a string constant), for --stats. */
void count(struct drawing *drawing, const char *name, uint64_t amount);

struct scene {
    const char *name;     /* of the scene and of its image file */
    size_t width, height; /* of the image, unless -s says otherwise; a sheet's frames share it */
    enum image_format format; /* 0 means IMAGE_BGR */
    size_t frames; /* of an animation, drawn as a sheet or, in PNG, moving; 0, 1: one picture */
    bool needs_model;
    struct vec3 eye, center, up; /* the camera, in steps that have one */
    struct vec3 light;           /* in steps that have one */
    /* Draw into the image, which is black and of the right size and format. */
    bool (*draw)(struct drawing *drawing, struct image *image, struct error *error);
};

struct program {
    const char *name;    /* "step04_flat": of the program and of its output directory */
    const char *summary; /* one line for --help */
    bool takes_model;    /* the argument is a model, instead of the course's own */
    bool takes_light;    /* --light */
    bool takes_camera;   /* --eye --center --up */
    /* Steps whose argument is a text scene give the function that draws it; its `draw` finds the
     * shapes in drawing->text, its width and height count where the text has no `size`. */
    enum text_scene_kind text_kind;
    struct scene text_scene; /* .draw is NULL in a step without text scenes */
    const struct scene *scenes;
    size_t scene_count;
    /* Memory of a scene that outlives one drawing of it (buffers, textures), so that --repeat
     * measures drawing alone. `prepare` is called once per scene before the drawing, `finish`
     * always after a call of `prepare`, even a failed one. Both may be NULL. */
    size_t state_size;
    bool (*prepare)(struct drawing *drawing, size_t width, size_t height, struct error *error);
    void (*finish)(struct drawing *drawing);
};

/* Run the program: read the options, draw the scenes, save the images. Returns the exit status:
 * 0 done, 1 an input or an output failed, 2 wrong usage. */
int program_main(const struct program *program, int argc, char **argv);

#endif
