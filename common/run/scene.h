/*
 * What a program is made of: its scenes, what each of them needs, and what its draw function gets.
 * program.h runs it; read that first.
 */
#ifndef COMMON_RUN_SCENE_H
#define COMMON_RUN_SCENE_H

#include "base/error.h"
#include "geometry.h"
#include "model.h"
#include "raster.h"
#include "run/text_scene.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a scene is drawn from. It is loaded before the drawing, so that --repeat measures drawing
 * alone; what no chosen scene needs is not read. All but the depth needs the model too. */
enum need {
    NEEDS_MODEL = 1,
    NEEDS_NORMALS = 2, /* at every corner: computed where the file has none */
    NEEDS_COLORS = 4,  /* at every position: its materials' or made of normals where it has none */
    NEEDS_PICTURE = 8, /* the diffuse texture next to the model, at mip level 0 */
    NEEDS_LEVELS = 256,
    NEEDS_DIFFUSE = NEEDS_PICTURE | NEEDS_LEVELS, /* all its levels; what is missing is replaced */
    NEEDS_NORMAL_MAP = 16,
    NEEDS_SPECULAR = 32,
    NEEDS_DEPTH = 64, /* a depth buffer */
    NEEDS_LINES = 128 /* lines, too, and a model of lines alone will do */
};

/* A number of a scene that --set changes, within its range. A list of them ends with one that has
 * no name; every scene has its own list, or none. Two that are called NAME_x and NAME_y are a point
 * to drag: their ranges are the picture, from left to right and from the bottom up. A help that
 * names each number, "0 flat, 1 smooth", gets a button for each. */
struct scene_value {
    const char *name;                /* letters, digits and '_' */
    const char *help;                /* what it is, in a few words */
    double least, most, step, value; /* step: by how much it changes at a time */
};

enum {
    COUNTER_LIMIT = 32, /* different names that one scene counts */
    VALUE_LIMIT = 16,   /* numbers in a scene's list */
    NOTES_LIMIT = 1024, /* bytes of notes about a pixel */
    MODELS_LIMIT = 4    /* of one command line */
};

struct counter {
    const char *name;
    uint64_t value;
};

/* The faces of one material. */
struct drawing_part {
    struct model model; /* these faces alone; it shares the rest with the whole */
    struct texture diffuse, normal_map, specular,
        ambient;                   /* shared; empty where there is none, but diffuse */
    double specular_weight, power; /* of the material; negative or 0: unknown */
    double repeats;                /* pictures side by side across the model: parts_repeats() */
};

/* What a draw function works with. It reads all of it and may change `depth` and `state`. */
struct drawing {
    const struct model *model; /* NULL where the scene needs none, as everything below */
    const struct model *models[MODELS_LIMIT]; /* of a program that takes_models: this one first */
    size_t model_count;
    const struct texture *diffuse;    /* one white texel where there is none */
    const struct texture *normal_map; /* NULL where there is none: draw by the mesh's normals */
    const struct texture *specular;   /* one texel where there is none */
    const struct texture *ambient;    /* a part's colours in ambient light; NULL: as in diffuse */
    const struct drawing_part *parts; /* of a model with materials: see drawing_take_part() */
    size_t part_count;
    const struct texture *whole_normal_map, *whole_specular; /* of parts that have none */
    double specular_weight, power;    /* of a part's material; negative or 0: unknown */
    double repeats;                   /* pictures side by side across the model; below 1: one */
    double *depth;                    /* one a pixel, row by row from the bottom: -INFINITY */
    const struct text_scene *text;    /* the text scene of the command line, otherwise NULL */
    struct vec3 eye, center, up;      /* the camera: options, the scene's or the program's */
    struct vec3 light;                /* as given: not normalised */
    bool skip;                        /* false with --no-skip: do all the work; same image */
    bool stats;                       /* with --stats: count what takes time to count, too */
    size_t frame;                     /* of an animation, from 0 */
    int number;                       /* the scene's */
    const struct scene_value *values; /* the scene's, */
    double value[VALUE_LIMIT];        /* and what they are now: see drawing_value() */
    void *state;                      /* program.state_size bytes, zero at first */
    bool probed;                      /* by --probe: note what there is to say about a pixel */
    struct pixel probe;               /* this one */
    char notes[NOTES_LIMIT];          /* lines: see drawing_note() */
    struct counter counters[COUNTER_LIMIT];
    size_t counter_count;
};

/* Add to the drawing's counter of that name (a string constant), for --stats. */
void drawing_count(struct drawing *drawing, const char *name, uint64_t amount);

/* Add a line, as printf makes it, to what is said about the pixel; it is cut where that is full. */
void drawing_note(struct drawing *drawing, const char *format, ...) PRINTF_LIKE(2, 3);

/* Set the drawing's model and textures to part `i`, counted from 0. Behind the last part they are
 * set to the whole model again, and the result is false. A model without materials is one part. So
 * a scene draws a model of several materials:
 * for (size_t i = 0; drawing_take_part(drawing, i); i++). */
bool drawing_take_part(struct drawing *drawing, size_t i);

/* The scene's number of that name, as --set has chosen it, or its default; 0 where the scene has no
 * such number. */
double drawing_value(const struct drawing *drawing, const char *name);

/* The point whose coordinates are the scene's numbers NAME_x and NAME_y. */
struct vec2 drawing_point(const struct drawing *drawing, const char *name);

/* Where a field is zero, the program's default holds. */
struct scene {
    const char *name;     /* of the scene and of its image file */
    unsigned needs;       /* of enum need, joined with | */
    const char *model;    /* a file of the course's; "bust.obj" by default */
    size_t width, height; /* of the image, unless -s says otherwise; a sheet's frames share it */
    enum image_format format; /* IMAGE_BGR by default */
    size_t frames;            /* of an animation, drawn as a sheet or, in PNG, moving */
    bool extra;               /* no part of the lesson: drawn when --only names it */
    bool trial;               /* finds wrong programs: drawn with --only all, or by its name */
    bool detail; /* of the course's model, so of another one drawn when --only names it */
    struct vec3 eye, center, up;      /* the camera, in steps that have one */
    struct vec3 light;                /* in steps that have one */
    const struct scene_value *values; /* that --set changes; NULL: none */
    int number; /* which of the scenes that share a draw function; it says of what */
    /* Draw into the image, which is black and of the right size and format. */
    bool (*draw)(struct drawing *drawing, struct image *image, struct error *error);
};

struct program {
    const char *name;      /* "step04_flat": of the program and of its output directory */
    const char *summary;   /* one line for --help */
    bool takes_light;      /* --light */
    bool takes_camera;     /* --eye --center --up */
    bool skips;            /* --no-skip makes it do more, also under the mouse */
    bool takes_models;     /* up to MODELS_LIMIT of them; textures are those of the first */
    struct scene defaults; /* what the scenes leave at zero */
    const struct scene *scenes;
    size_t scene_count;
    /* Only in a step whose argument is a text scene and no model: draws the shapes that are in
     * drawing->text. The default size counts where the text has no `size`. */
    bool (*draw_text)(struct drawing *drawing, struct image *image, struct error *error);
    enum text_scene_kind text_kind;
    const struct scene_value *text_values; /* of every text scene; NULL: none */
    const char *text;                      /* with which a reader begins, to drag its points */
    /* Memory of a scene that outlives one drawing of it: made before the drawing, so that it is not
     * measured. `prepare` is called once for each scene when all it needs is loaded, `finish`
     * always after a call of `prepare`, even a failed one. Both may be NULL. */
    size_t state_size;
    bool (*prepare)(struct drawing *drawing, size_t width, size_t height, struct error *error);
    void (*finish)(struct drawing *drawing);
};

#endif
