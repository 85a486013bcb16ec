/*
 * NAME: models turn under a light, a picture that moves. This program is yours: change all of it.
 *
 *     make NAME                          draws the course's head
 *     make NAME MODEL='a.obj b.off'      draws other models, side by side
 */
#include "base/file.h"
#include "files/fit.h"
#include "files/model_file.h"
#include "files/normals.h"
#include "files/png.h"
#include "pipeline.h"

#include <stdio.h>

#define OUTPUT COURSE_BUILD "/out/NAME"
enum { SIZE = 400, FRAMES = 36, DELAY_MS = 80, MODEL_LIMIT = 4 };

/* What the shader reads. */
struct uniforms {
    const struct model *model;
    struct mat4 place;    /* from the model's own space into the world */
    struct vec3 to_light; /* in the world, of length 1 */
};

/* A corner hands over its normal in the world. */
static void vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    struct vec3 normal = mat4_direction(&u->place, model_normal(u->model, face, corner));
    varyings[0] = normal.x;
    varyings[1] = normal.y;
    varyings[2] = normal.z;
}

/* Blue away from the light, yellow towards it (Gooch, Gooch, Shirley, Cohen, "A Non-Photorealistic
 * Lighting Model for Automatic Technical Illustration", SIGGRAPH 1998). */
static lanes_mask fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct lanes3 normal = {varyings[0], varyings[1], varyings[2]};
    lanes cosine = lanes3_dot(lanes3_normalized(normal), lanes3_all(u->to_light));
    lanes warm = 0.5f + 0.5f * cosine;
    *color = lanes_rgb(25 + 230 * warm, 35 + 180 * warm, 120 + 20 * warm);
    return lanes_all_set();
}

SHADER(gooch, .varying_count = 3, .vertex = vertex, .fragment = fragment);

/* Record a model for the frame: number `index` of `count` in a row, after so many whole turns. */
static bool draw(struct pipeline *pipeline, const struct model *model, int index, int count,
                 double turns, struct error *error) {
    const struct vec3 eye = {0, 1, 4}, center = {0, 0, 0}, up = {0, 1, 0}, light = {-2, 1, 1};
    const struct vec3 right = {2 * index - (count - 1), 0, 0}, narrow = {1.0 / count, 1, 1};
    struct rectangle whole = {0, 0, SIZE * count, SIZE};
    struct uniforms u = {
        .model = model,
        .place = mat4_mul(mat4_translation(right), mat4_rotation(up, turns)),
        .to_light = vec3_normalized(light),
    };
    struct draw_call call = camera_call(model, eye, center, up, 0.9, whole, CULL_BACK);
    call.to_clip = mat4_mul(mat4_scaling(narrow), mat4_mul(call.to_clip, u.place));
    return pipeline_draw(pipeline, &call, &gooch, &u, sizeof u, error);
}

int main(int argc, char **argv) {
    static char *head[] = {COURSE_BUILD "/models/bust.obj"};
    static struct model models[MODEL_LIMIT];
    static struct image frames[FRAMES];
    char **paths = argc > 1 ? argv + 1 : head;
    int count = argc > 1 ? argc - 1 : 1;
    struct pipeline pipeline = {0};
    struct error error;
    bool done = count <= MODEL_LIMIT || error_set(&error, "at most %d models", MODEL_LIMIT);
    for (int i = 0; done && i < count; i++) {
        done = model_read(&models[i], paths[i], &error) && model_need_normals(&models[i], &error);
        model_fit(&models[i], true);
    }
    done = done && pipeline_create(&pipeline, (size_t)(SIZE * count), SIZE, &error);
    for (int frame = 0; done && frame < FRAMES; frame++) {
        pipeline_clear(&pipeline);
        for (int i = 0; done && i < count; i++) {
            done = draw(&pipeline, &models[i], i, count, (double)frame / FRAMES, &error);
        }
        done = done &&
               image_create(&frames[frame], pipeline.width, pipeline.height, IMAGE_BGR, &error) &&
               pipeline_finish(&pipeline, &frames[frame], &error);
    }
    done = done && directory_create(OUTPUT, &error) &&
           apng_write(frames, FRAMES, DELAY_MS, OUTPUT "/turn.png", &error);
    fprintf(done ? stdout : stderr, "%s\n", done ? OUTPUT "/turn.png" : error.message);
    for (int i = 0; i < FRAMES; i++) {
        image_free(&frames[i]);
    }
    for (int i = 0; i < MODEL_LIMIT; i++) {
        model_free(&models[i]);
    }
    pipeline_free(&pipeline);
    return done ? 0 : 1;
}
