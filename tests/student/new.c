/*
 * NAME: models turn under a light, a picture that moves. This program is yours: change all of it.
 *
 *     make NAME                          draws the course's head
 *     make NAME MODEL='a.obj b.off'      draws other models, side by side
 */
#include "pipeline_program.h"

/* What the shader reads. */
struct uniforms {
    const struct model *model;
    struct mat4 normals_to_world; /* from the model's own space */
    struct vec3 to_light;         /* in the world, of length 1 */
};

/* A corner hands over its normal in the world. */
static void vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    struct vec3 normal = mat4_direction(&u->normals_to_world, model_normal(u->model, face, corner));
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

/* A frame: the models in a row, each turned by as much as all frames before have turned it. */
static bool draw(struct drawing *drawing, struct image *image, struct error *error) {
    struct pipeline *pipeline = pipeline_begin(drawing);
    struct rectangle whole = {0, 0, (int)image->width, (int)image->height};
    const double count = (double)drawing->model_count, turns = (double)drawing->frame / 36;
    bool done = true;
    for (size_t i = 0; done && i < drawing->model_count; i++) {
        struct draw_call call = pipeline_call(drawing, whole, 0.9 / count, CULL_BACK);
        struct mat4 right = mat4_translation((struct vec3){2 * (double)i - (count - 1), 0, 0});
        struct mat4 place = mat4_mul(right, mat4_rotation(drawing->up, turns)), inverse = place;
        mat4_inverse(place, &inverse); /* its transpose turns normals, also where it stretches */
        struct uniforms u = {drawing->models[i], mat4_transpose(inverse),
                             vec3_normalized(drawing->light)};
        call.model = u.model;
        call.to_clip = mat4_mul(call.to_clip, place);
        done = pipeline_draw(pipeline, &call, &gooch, &u, sizeof u, error);
    }
    return pipeline_end(drawing, done, image, error);
}

int main(int argc, char **argv) {
    static const struct scene turn = {
        .name = "turn", .needs = NEEDS_MODEL | NEEDS_NORMALS, .frames = 36, .draw = draw};
    static const struct program program = {
        PIPELINE_PROGRAM,
        .name = "NAME",
        .summary = "models turn under a light",
        .takes_models = true,
        .defaults =
            {.width = 400, .height = 400, .eye = {0, 1, 4}, .up = {0, 1, 0}, .light = {-2, 1, 1}},
        .scenes = &turn,
        .scene_count = 1,
    };
    return program_main(&program, argc, argv);
}
