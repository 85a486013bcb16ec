/* Lesson 2's scenes that find wrong programs. */
#ifndef LESSON
#define LESSON "../step02_wireframe/main.c"
#endif
#include "more_scenes.h"

/* ---- Points ---- */

/* Too far away, by a little or by much: these have no pixel. */
static const struct vec3 try_too_far[] = {
    {6e6, 0, 0}, {0, -1e7, 0}, {-4194303, 1e7, 0}, {-1e30, 0, 0}, {0, 1e30, 0}, {1e30, -1e30, 0},
};
enum { TRY_TOO_FAR = sizeof try_too_far / sizeof try_too_far[0] };

/* Green, and bluer where x or y is odd. */
static struct color try_color(struct pixel p) {
    return color_rgb(0, 255, (uint8_t)((p.x & 1) * 128 + (p.y & 1) * 64));
}

/* The i-th box, if `position` has a pixel; red if it has none, but the pixel was changed. */
static void try_far(struct image *image, int i, struct vec3 position) {
    struct pixel p = {-7, -7};
    if (to_pixel(position, FAR_WIDTH, FAR_HEIGHT, &p)) {
        draw_box(image, i, try_color(p));
    } else if (p.x != -7 || p.y != -7) {
        draw_box(image, i, color_rgb(255, 0, 0));
    }
}

/* More boxes where something is found wrongly: one for a position that is too far; and bluer where
 * a far pixel, which is even, is odd. */
static bool try_points(struct drawing *drawing, struct image *image, struct error *error) {
    for (int i = 0; i < FAR_POSITIONS; i++) { /* the scene draws over those that have a pixel */
        try_far(image, i, far_positions[i]);
    }
    for (int i = 0; i < TRY_TOO_FAR; i++) {
        try_far(image, FAR_POSITIONS + i, try_too_far[i]);
    }
    const bool done = draw_points(drawing, image, error);
    for (int i = 0; i < FAR_POSITIONS; i++) {
        struct pixel p = {0, 0};
        if (to_pixel(far_positions[i], FAR_WIDTH, FAR_HEIGHT, &p) && ((p.x | p.y) & 1) != 0) {
            draw_box(image, i, try_color(p));
        }
    }
    return done;
}

/* ---- Wireframes ---- */

static struct side try_greatest(const struct wireframe *wireframe) {
    struct side greatest = {0, 0};
    for (size_t i = 0; i < wireframe->side_count; i++) {
        const struct side side = wireframe->sides[i];
        if (side.low > greatest.low || (side.low == greatest.low && side.high > greatest.high)) {
            greatest = side;
        }
    }
    return greatest;
}

/* The sides of a model, each once, or with --no-skip as often as there are faces that have it. The
 * greatest side is repeated behind the list: code that reads beyond the end takes that for an equal
 * one. */
static bool try_model(struct drawing *drawing, const struct model *model, struct view view,
                      struct image *image, struct error *error) {
    struct wireframe wireframe;
    if (!wireframe_create(&wireframe, model, error)) {
        return false;
    }
    const size_t all = wireframe.side_count;
    wireframe.sides[all] = try_greatest(&wireframe);
    if (drawing->skip) {
        wireframe.side_count = keep_one_of_each(wireframe.sides, all);
    }
    draw_sides(drawing, &wireframe, model->positions, view, line, image);
    drawing_count(drawing, "lines_shared_skipped", all - wireframe.side_count);
    free(wireframe.sides);
    return true;
}

static bool try_wireframe(struct drawing *drawing, struct image *image, struct error *error) {
    return drawing->skip ? draw_wireframe(drawing, image, error)
                         : try_model(drawing, drawing->model, (struct view){0, 0, 1}, image, error);
}

/* The square of the text, in a model with many positions: the greatest number is `greatest`. The
 * first face is repeated, front and back, so its sides belong to many faces; the other one comes
 * last. */
static bool try_two_faces(struct drawing *drawing, uint32_t greatest, size_t face_count,
                          struct view view, struct image *image, struct error *error) {
    enum { D = 1, B = 2, C = 501 };
    const uint32_t kinds[3][3] = {{greatest, B, C}, {C, B, greatest}, {greatest, C, D}};
    struct vec3 *positions = calloc(greatest + 1, sizeof *positions);
    struct face *faces = calloc(face_count, sizeof *faces);
    if (positions == NULL || faces == NULL) {
        free(positions);
        free(faces);
        return error_out_of_memory(error);
    }
    positions[greatest] = (struct vec3){-0.5, -0.5, 0};
    positions[B] = (struct vec3){0.5, -0.5, 0};
    positions[C] = (struct vec3){0.5, 0.5, 0};
    positions[D] = (struct vec3){-0.5, 0.5, 0};
    for (size_t i = 0; i < 3 * face_count; i++) {
        const uint32_t *corners = kinds[i / 3 == face_count - 1 ? 2 : i / 3 % 2];
        faces[i / 3].corner[i % 3].position = corners[i % 3];
    }
    const struct model model = {.positions = positions,
                                .position_count = greatest + 1,
                                .faces = faces,
                                .face_count = face_count};
    bool done = try_model(drawing, &model, view, image, error);
    free(positions);
    free(faces);
    return done;
}

/* Once as it is; once so large that its upper right corner is seen, and others are far away; once
 * with its lower left corner some pixels, and a part of one, outside. Numbers of positions with up
 * to five digits, and more than 16 bits; and more sides than the bust has. */
static bool try_square(struct drawing *drawing, struct image *image, struct error *error) {
    struct view whole = {0, 0, 1}, large = {0.5 - 2e-5, 0.5 - 2.4e-5, 3e4};
    return try_two_faces(drawing, 1501, 3, whole, image, error) &&
           try_two_faces(drawing, 10501, 3, large, image, error) &&
           try_two_faces(drawing, 66037, 6000, (struct view){1.2836, 1.4869, 0.61}, image, error);
}

static bool try_border(struct drawing *drawing, struct image *image, struct error *error) {
    const struct model part = quarter_of(drawing->model);
    return try_model(drawing, &part, (struct view){0.26, 0.1, 2.4}, image, error);
}

/* ---- The scenes ---- */

static const struct scene trials[] = {
    {.name = "points", .draw = try_points},
    {.name = "wireframe", .draw = try_wireframe},
    {.name = "border", .draw = try_border},
    {.name = "square", .width = 100, .height = 100, .draw = try_square},
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {.name = "wide", .needs = NEEDS_MODEL, .width = 203, .height = 67, .draw = try_wireframe},
    {.name = "high", .needs = NEEDS_MODEL, .width = 61, .height = 181, .draw = try_wireframe},
    {.name = "small", .needs = NEEDS_MODEL, .width = 23, .height = 13, .draw = try_wireframe},
    {.name = "one_pixel", .needs = NEEDS_MODEL, .width = 1, .height = 1, .draw = try_wireframe},
};

MAIN_WITH(trials)
