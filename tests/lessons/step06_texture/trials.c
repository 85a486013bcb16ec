/* Lesson 6's scenes that find wrong programs. */
#ifndef LESSON
#define LESSON "../step06_texture/main.c"
#endif
#include "more_scenes.h"

/* ---- The lesson's scenes ---- */

/* Copies the pixels of a face drawn alone that are nearer than what is there, and forgets their
 * depths. Returns how many the face has. */
static uint64_t try_to_copy(const struct canvas *to, const struct canvas *alone,
                            const struct vertex v[3]) {
    uint64_t count = 0;
    struct edges edges;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, to->image->width,
                     to->image->height)) {
        return 0;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        const struct span span = edges_span(&edges, y);
        for (int x = span.begin; x < span.end; x++) {
            const size_t i = (size_t)y * to->image->width + (size_t)x;
            if (alone->depth[i] > to->depth[i]) {
                to->depth[i] = alone->depth[i];
                image_set(to->image, x, y, image_get(alone->image, x, y));
            }
            alone->depth[i] = -INFINITY;
            count++;
        }
    }
    return count;
}

/* All faces are placed, in the light or not, and each is drawn alone, where nothing hides it: so
 * all of its pixels are shaded. */
static uint64_t try_all_faces(struct drawing *drawing, const struct canvas *to,
                              const struct canvas *alone) {
    const struct vec3 light = vec3_normalized(drawing->light);
    uint64_t shaded = 0;
    for (size_t part = 0; drawing_take_part(drawing, part); part++) {
        for (size_t face = 0; face < drawing->model->face_count; face++) {
            struct vertex v[3];
            const bool placed = place_face(drawing->model, face, to->image, v);
            const double intensity = model_face_intensity(drawing->model, face, light);
            if (placed && intensity > 0) {
                triangle(alone, v, drawing->diffuse, intensity);
                shaded += try_to_copy(to, alone, v);
            }
        }
    }
    return shaded;
}

/* With --no-skip what is hidden is shaded, too. */
static bool try_texture(struct drawing *drawing, struct image *image, struct error *error) {
    if (drawing->skip) {
        return draw_texture(drawing, image, error);
    }
    const size_t pixels = image->width * image->height;
    struct image second;
    double *depth = malloc(pixels * sizeof *depth);
    if (depth == NULL) {
        return error_out_of_memory(error);
    }
    const bool made = image_create(&second, image->width, image->height, IMAGE_BGR, error);
    if (made) {
        depth_clear(depth, pixels);
        const struct canvas to = {.image = image, .depth = drawing->depth};
        const struct canvas alone = {.image = &second, .depth = depth};
        drawing_count(drawing, "pixels_shaded", try_all_faces(drawing, &to, &alone));
        image_free(&second);
    }
    free(depth);
    return made;
}

/* Draw a board that faces us, at this intensity. */
static bool try_board(struct drawing *drawing, struct image *image, const struct surface *board,
                      double intensity, struct error *error) {
    const struct canvas canvas = {.image = image, .depth = drawing->depth};
    struct texture texture;
    struct vertex v[4];
    if (!paint(&texture, board->pattern, error)) {
        return false;
    }
    place_surface(board, image, v);
    triangle(&canvas, (struct vertex[]){v[0], v[1], v[2]}, &texture, intensity);
    triangle(&canvas, (struct vertex[]){v[0], v[2], v[3]}, &texture, intensity);
    texture_free(&texture);
    return true;
}

/* The large board again, darker: it is no nearer, so it must stay hidden. */
static bool try_letters(struct drawing *drawing, struct image *image, struct error *error) {
    return draw_letters(drawing, image, error) && try_board(drawing, image, &boards[0], 0.5, error);
}

/* ---- Small images ---- */

/* A board that is larger than the image on all sides, and shows nearly all of its pattern. */
static bool try_covered(struct drawing *drawing, struct image *image, struct error *error) {
    const double width = (double)image->width, height = (double)image->height;
    const struct surface board = {
        &small_cloth,
        {{-0.4 * width, -0.7 * height, 0},
         {1.6 * width, -0.3 * height, 0},
         {1.4 * width, 1.8 * height, 0},
         {-0.3 * width, 1.4 * height, 0}},
        {{-0.3, -0.4}, {1.5, -0.2}, {1.4, 1.5}, {-0.2, 1.3}},
    };
    return try_board(drawing, image, &board, 1, error);
}

/* ---- The scenes ---- */

static const struct scene trials[] = {
    {.name = "texture", .draw = try_texture},
    {.name = "letters", .draw = try_letters},
    /* Not square, and odd: a square or a large picture hides some mistakes. */
    {.name = "wide", .needs = MODEL_AND_COLORS, .width = 203, .height = 67, .draw = draw_texture},
    {.name = "high", .width = 61, .height = 181, .draw = draw_mipmapped},
    {.name = "small", .needs = NEEDS_DEPTH, .width = 23, .height = 13, .draw = try_covered},
    {.name = "one_pixel", .needs = NEEDS_DEPTH, .width = 1, .height = 1, .draw = try_covered},
};

MAIN_WITH(trials)
