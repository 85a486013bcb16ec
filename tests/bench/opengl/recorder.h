/*
 * For the lessons that draw with the pipeline: a scene is drawn once more, and what it hands to
 * pipeline_draw() becomes parts of a picture.
 *
 * Included before such a lesson's main.c, this puts a function of ours in the place of
 * pipeline_draw(). The file that includes it defines describe().
 */
#ifndef OPENGL_RECORDER_H
#define OPENGL_RECORDER_H

#include "context.h"
#include "picture.h"

#include <string.h>

static struct picture *recording; /* NULL: draw */

/* What a fragment function of a lesson is as a formula. A list of them ends with NULL. */
struct known_fragment {
    lanes_mask (*fragment)(const void *uniforms, const lanes *varyings, lanes_texel *color);
    const char *formula;
};

/* NULL for a shader that is not known. */
static const char *formula_of(const struct shader *shader, const struct known_fragment *known) {
    while (known->fragment != NULL && known->fragment != shader->fragment) {
        known++;
    }
    return known->formula;
}

/* The formula of a shader and what it reads. */
static struct gl_part describe(const struct shader *shader, const void *uniforms);

struct shaded_model {
    const struct model *model;
    const struct shader *shader;
    const void *uniforms;
};

/* A shader that discards does so where its first varying, the same at all corners of a face, is not
 * above 0. */
static bool shaded_corner(const void *given, size_t face, size_t corner, struct corner_data *to) {
    const struct shaded_model *shaded = given;
    double all[VARYING_LIMIT] = {0};
    shaded->shader->vertex(shaded->uniforms, face, corner, all);
    memcpy(to->varyings, all, sizeof to->varyings);
    to->position = model_position(shaded->model, face, corner);
    return !shaded->shader->discards || all[0] > 0;
}

static bool draw_or_record(struct pipeline *pipeline, const struct draw_call *call,
                           const struct shader *shader, const void *uniforms, size_t size,
                           struct error *error) {
    if (recording == NULL) {
        return pipeline_draw(pipeline, call, shader, uniforms, size, error);
    }
    const struct shaded_model shaded = {call->model, shader, uniforms};
    struct gl_part part = describe(shader, uniforms);
    part.cull = call->cull;
    part.viewport = call->viewport;
    part.to_clip = perspective_clip(call->to_clip);
    return part.formula != NULL
               ? picture_add(recording, &part, call->model->face_count, shaded_corner, &shaded)
               : error_set(error, "a shader that this comparison does not know");
}

#define pipeline_draw draw_or_record

/* Builds a scene: see struct compared_scene. */
static bool record(struct picture *picture) {
    recording = picture;
    picture->drawing->counter_count = 0;
    bool done = picture->draw(picture->drawing, picture->image, picture->error);
    recording = NULL;
    return done;
}

#endif
