/*
 * For the lessons that draw with the pipeline: writes down what they hand to pipeline_draw().
 *
 * The scenes of steps 9 and 10 know what they draw only while they draw it. Included before such a
 * lesson's main.c, this puts a function of ours in the place of pipeline_draw(); where a recorder
 * listens, the call is written down, otherwise it goes through. The file that includes this must
 * define
 *     static bool describe_shader(const struct shader *shader, const void *uniforms,
 *                                 struct batch *batch);
 * which sets the look and its values.
 */
#ifndef OPENGL_RECORDER_H
#define OPENGL_RECORDER_H

#include "picture.h"

#include <stdlib.h>
#include <string.h>

/* The state of a scene in these lessons is a pipeline; here the recorder stands behind it. */
struct recorder {
    struct pipeline pipeline; /* first, so that its address is that of the recorder */
    struct picture *picture;  /* NULL: draw */
};

static bool describe_shader(const struct shader *shader, const void *uniforms, struct batch *batch);

/* The three corners of a face. False where one is behind the eye or too far off: such faces would
 * have to be clipped, which the scenes of these lessons never need. */
static inline bool record_corners(const struct draw_call *call, const struct shader *shader,
                                  const void *uniforms, size_t face,
                                  struct corner_data corners[3]) {
    for (size_t i = 0; i < 3; i++) {
        double varyings[VARYING_LIMIT] = {0};
        corners[i].position = model_position(call->model, face, i);
        struct vec4 clip = mat4_point(&call->to_clip, corners[i].position);
        if (!(clip.w >= NEAR_W) || fabs(clip.x) > 64 * clip.w || fabs(clip.y) > 64 * clip.w ||
            !place_in_viewport(clip, &call->viewport, &corners[i].placed)) {
            return false;
        }
        shader->vertex(uniforms, face, i, varyings);
        for (size_t k = 0; k < VARYINGS; k++) {
            corners[i].varyings[k] = varyings[k];
        }
    }
    return true;
}

static inline bool record_draw(struct picture *picture, const struct draw_call *call,
                               const struct shader *shader, const void *uniforms,
                               struct error *error) {
    struct batch settings = {
        .depth_test = true,
        .cull = call->cull,
        .viewport = call->viewport,
        .to_clip = perspective_clip(call->to_clip),
    };
    if (!describe_shader(shader, uniforms, &settings)) {
        return error_set(error, "a shader that this comparison does not know");
    }
    struct batch *batch = picture_add_batch(picture, &settings, error);
    for (size_t face = 0; batch != NULL && face < call->model->face_count; face++) {
        struct corner_data corners[3];
        if (!record_corners(call, shader, uniforms, face, corners)) {
            return error_set(error, "face %zu would have to be clipped", face);
        }
        if (!batch_add_face(batch, face, corners, error)) {
            return false;
        }
    }
    return batch != NULL;
}

/* Never inlined: an extra scene, which is not recorded, has pipelines with no recorder behind them,
 * and the compiler would see it. */
static __attribute__((noinline)) bool
draw_or_record(struct pipeline *pipeline, const struct draw_call *call, const struct shader *shader,
               const void *uniforms, size_t size, struct error *error) {
    struct picture *picture = ((struct recorder *)pipeline)->picture;
    return picture != NULL ? record_draw(picture, call, shader, uniforms, error)
                           : pipeline_draw(pipeline, call, shader, uniforms, size, error);
}

#define pipeline_draw draw_or_record

/* Draw the scene once with the recorder listening. */
static inline bool record_scene(const struct program *program, const char *name,
                                struct drawing *drawing, struct image *image,
                                struct picture *picture, struct error *error) {
    struct recorder *recorder = drawing->state;
    bool done = false;
    recorder->picture = picture;
    for (size_t i = 0; i < program->scene_count; i++) {
        if (strcmp(program->scenes[i].name, name) == 0) {
            drawing->counter_count = 0;
            done = program->scenes[i].draw(drawing, image, error);
        }
    }
    recorder->picture = NULL;
    return done;
}

#endif
