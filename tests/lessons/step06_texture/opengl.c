/* The triangles of step 6: see compared.h. */
#include "bench/opengl/compared.h"

#define LESSON "../step06_texture/main.c"
#include "lesson.h"

#include <string.h>

static const char *left_out(const char *scene) {
    if (strcmp(scene, "softer") == 0) {
        return "the level of a pixel is not that of a triangle";
    }
    return strcmp(scene, "room") == 0 ? "no look here repeats a picture by its nearest texel"
                                      : NULL;
}

static bool build_texture(struct drawing *drawing, struct image *image, struct picture *picture,
                          struct error *error) {
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    struct batch settings = parallel_batch(
        LOOK_NEAREST, (struct rectangle){0, 0, (int)image->width, (int)image->height});
    settings.values.diffuse_map = drawing->diffuse;
    struct batch *batch = picture_add_batch(picture, &settings, error);
    for (size_t face = 0; batch != NULL && face < model->face_count; face++) {
        double intensity = model_face_intensity(model, face, light);
        struct vertex vertices[3];
        if (!(intensity > 0) || !place_face(model, face, image, vertices)) {
            continue;
        }
        struct corner_data corners[3];
        for (size_t i = 0; i < 3; i++) {
            corners[i] = (struct corner_data){
                .position = model_position(model, face, i),
                .placed = {vertices[i].position, parallel_depth(vertices[i].depth), 1},
                .varyings = {vertices[i].uv.x, vertices[i].uv.y, intensity},
            };
        }
        if (!batch_add_face(batch, face, corners, error)) {
            return false;
        }
    }
    return batch != NULL;
}

/* Two triangles, of four corners that have been placed. */
static bool add_quad(struct batch *batch, size_t first_face, const struct corner_data corners[4],
                     struct error *error) {
    const struct corner_data first[3] = {corners[0], corners[1], corners[2]};
    const struct corner_data second[3] = {corners[0], corners[2], corners[3]};
    return batch_add_face(batch, first_face, first, error) &&
           batch_add_face(batch, first_face + 1, second, error);
}

/* ---- Scene letters ---- */

/* A board that faces us, of four corners that have been placed. */
static bool add_board(struct picture *picture, const struct image *image,
                      const struct vertex board[4], const struct texture *texture,
                      size_t first_face, struct error *error) {
    double width = (double)image->width * SUBPIXELS, height = (double)image->height * SUBPIXELS;
    struct corner_data corners[4];
    struct batch settings = parallel_batch(
        LOOK_NEAREST, (struct rectangle){0, 0, (int)image->width, (int)image->height});
    settings.values.diffuse_map = texture;
    struct batch *batch = picture_add_batch(picture, &settings, error);
    for (int i = 0; i < 4; i++) {
        struct fixed2 screen = board[i].position;
        corners[i] = (struct corner_data){
            .position = {2 * screen.x / width - 1, 2 * screen.y / height - 1, 0},
            .placed = {screen, parallel_depth(0), 1},
            .varyings = {board[i].uv.x, board[i].uv.y, 1},
        };
    }
    return batch != NULL && add_quad(batch, first_face, corners, error);
}

static bool build_letters(struct drawing *drawing, struct image *image, struct picture *picture,
                          struct error *error) {
    const struct state *state = drawing->state;
    struct vertex board[4], cloth[4], far[2][4];
    place_board(image, board);
    place_cloth(image, cloth);
    place_far_board(image, 0, far[0]);
    place_far_board(image, 1, far[1]);
    return add_board(picture, image, board, &state->bordered, 0, error) &&
           add_board(picture, image, cloth, &state->cloth, 2, error) &&
           add_board(picture, image, far[0], &state->bordered, 4, error) &&
           add_board(picture, image, far[1], &state->bordered, 6, error);
}

/* ---- Scenes in perspective ---- */

/* place_in_room() as a matrix: from (side, distance, height) to clip space, with w the distance. */
static struct mat4 room_to_clip(void) {
    return (struct mat4){{{PLANE_COSINE, 0, -PLANE_SINE, PLANE_SINE * PLANE_BELOW},
                          {PLANE_SINE, 0.5, PLANE_COSINE, -PLANE_COSINE * PLANE_BELOW},
                          {0, 0, 0, NEAR_W},
                          {0, 1, 0, 0}}};
}

static struct batch perspective_batch(const struct texture *texture, const struct image *image) {
    return (struct batch){
        .look = LOOK_CHECKER,
        .values = {.diffuse_map = texture},
        .viewport = {0, 0, (int)image->width, (int)image->height},
        .to_clip = room_to_clip(),
    };
}

static struct corner_data perspective_corner(const struct vertex *v, struct vec3 position) {
    return (struct corner_data){
        .position = position,
        .placed = {v->position, NEAR_W * v->recip_w, v->recip_w},
        .varyings = {v->uv.x, v->uv.y},
    };
}

static bool build_checker(struct drawing *drawing, struct image *image, struct picture *picture,
                          struct error *error) {
    const struct state *state = drawing->state;
    struct vertex plane[4];
    struct corner_data corners[4];
    struct batch settings = perspective_batch(&state->checker, image);
    struct batch *batch = picture_add_batch(picture, &settings, error);
    place_plane(image, plane);
    for (int i = 0; i < 4; i++) {
        corners[i] = perspective_corner(&plane[i], (struct vec3){plane[i].uv.x, plane[i].uv.y, 0});
    }
    return batch != NULL && add_quad(batch, 0, corners, error);
}

static bool build_close(struct drawing *drawing, struct image *image, struct picture *picture,
                        struct error *error) {
    const struct state *state = drawing->state;
    struct vertex wall[4];
    struct corner_data corners[4];
    struct batch settings = perspective_batch(&state->letters, image);
    struct batch *batch = picture_add_batch(picture, &settings, error);
    place_close(image, wall);
    for (int i = 0; i < 4; i++) {
        struct vec3 place = {2 * wall[i].uv.x, 1 / wall[i].recip_w, 1.2 * wall[i].uv.y};
        corners[i] = perspective_corner(&wall[i], place);
    }
    return batch != NULL && add_quad(batch, 0, corners, error);
}

/* Scene mipmapped. */
static bool build_room(struct drawing *drawing, struct image *image, struct picture *picture,
                       struct error *error) {
    const struct state *state = drawing->state;
    struct vertex back[4], ground[4], wall[4];
    struct corner_data on_back[4], on_ground[4], on_wall[4];
    struct batch settings = perspective_batch(&state->mosaic, image);
    struct batch *batch = picture_add_batch(picture, &settings, error);
    place_back(image, back);
    for (int i = 0; i < 4; i++) {
        on_back[i] = perspective_corner(
            &back[i], (struct vec3){0.9 * back[i].uv.x, 1 / back[i].recip_w, 0.9 * back[i].uv.y});
    }
    if (batch == NULL || !add_quad(batch, 0, on_back, error)) {
        return false;
    }
    settings = perspective_batch(&state->letters, image);
    batch = picture_add_batch(picture, &settings, error);
    place_floor(image, ground);
    place_wall(image, wall);
    for (int i = 0; i < 4; i++) {
        double side = 2 * ground[i].uv.x, height = 1.2 * (wall[i].uv.y + 3);
        on_ground[i] =
            perspective_corner(&ground[i], (struct vec3){side, 1 / ground[i].recip_w, 0});
        on_wall[i] =
            perspective_corner(&wall[i], (struct vec3){ROOM_LEFT, 1 / wall[i].recip_w, height});
    }
    return batch != NULL && add_quad(batch, 2, on_ground, error) &&
           add_quad(batch, 4, on_wall, error);
}

static bool build(const char *scene, struct drawing *drawing, struct image *image,
                  struct picture *picture, struct error *error) {
    if (strcmp(scene, "texture") == 0) {
        return build_texture(drawing, image, picture, error);
    }
    if (strcmp(scene, "letters") == 0) {
        return build_letters(drawing, image, picture, error);
    }
    if (strcmp(scene, "close") == 0) {
        return build_close(drawing, image, picture, error);
    }
    return strcmp(scene, "checker") == 0 ? build_checker(drawing, image, picture, error)
                                         : build_room(drawing, image, picture, error);
}

const struct lesson lesson_step06 = {
    .program = &step06_texture,
    .left_out = left_out,
    .build = build,
};
