/*
 * A scene on its stage: everything it needs is loaded, and it can be drawn again and again. Private
 * to program.c and live.c.
 */
#ifndef COMMON_RUN_STAGE_H
#define COMMON_RUN_STAGE_H

#include "run/options.h"
#include "run/parts.h"
#include "run/scene.h"

/* What was read, for --stats. */
struct loaded {
    uint64_t textures_read, textures_present;
};

/* What the scenes of one run share. Set the first part, leave the second zero. */
struct run {
    struct options options;        /* of the command line, which say how a model is placed */
    struct options request;        /* of --live: the one that is answered */
    const struct options *asked;   /* which of both a scene is drawn with */
    const struct text_scene *text; /* NULL unless it is a text scene */
    unsigned needs; /* of all scenes that will be drawn, so that a model is read once; 0: unknown */

    struct model model[MODELS_LIMIT]; /* loaded when the first scene needs them */
    size_t model_count;
    const char *model_file;      /* which file the first is; NULL while none is loaded */
    unsigned model_parts;        /* what of it is loaded, of enum model_part */
    struct loaded unloaded;      /* of models that made room for others */
    bool has_materials;          /* the model has, and is drawn by them, part for part */
    bool has_places;             /* its corners have places in pictures */
    struct parts parts;          /* as the last scene had them */
    struct texture white, shiny; /* of one texel, for a model without textures; empty at first */
    /* Textures that the model has not, or that cannot be read: why, and what is drawn instead. The
     * message is empty once it is said. */
    struct error replaced[MODEL_TEXTURE_KINDS];
    bool is_replaced[MODEL_TEXTURE_KINDS];
    bool fit_suggested; /* the model was looked at, whether --fit would help */
    const char *advice; /* the last one where nothing was drawn; NULL: none yet */
};

/* What was read up to now. */
struct loaded run_loaded(const struct run *run);

/* Free what was loaded. */
void run_free(struct run *run);

/* The scene of the options' program with what they say, then its own values, then the program's. */
struct scene scene_complete(const struct options *options, const struct scene *scene);

/* Is the scene drawn from a model? */
bool scene_needs_model(const struct scene *scene);

struct stage {
    const struct program *program;
    struct scene scene;     /* complete */
    struct drawing drawing; /* what the scene's draw function gets */
    size_t pixel_count;     /* of a frame */
    bool prepared;          /* the program's prepare() was called */
};

/* Load what the scene (a complete one) needs for frames of width x height pixels. stage_end() must
 * be called, also after an error. */
bool stage_begin(struct stage *stage, struct run *run, const struct scene *scene, size_t width,
                 size_t height, struct error *error);

/* Draw a frame over what is in the image: with a cleared depth buffer, counting on. */
bool stage_draw(struct stage *stage, struct image *image, size_t frame, struct error *error);

void stage_end(struct stage *stage);

#endif
