/* Lesson 7's scenes that find wrong programs. */
#ifndef LESSON
#define LESSON "../step07_gouraud/main.c"
#endif
#include "more_scenes.h"

/* ---- The lesson's scenes, with nothing skipped ---- */

/* Copies the pixels of a face drawn alone that are nearer than what is there, in all pictures of
 * the image, and forgets their depths. Returns how many the face has in one of them. */
static uint64_t try_to_copy(const struct canvas *to, const struct canvas *alone,
                            const struct edges *edges) {
    const int width = (int)to->width, height = (int)to->height;
    const int columns = (int)to->image->width / width, rows = (int)to->image->height / height;
    uint64_t count = 0;
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        const struct span span = edges_span(edges, y);
        for (int x = span.begin; x < span.end; x++) {
            const size_t place = (size_t)y * to->width + (size_t)x;
            const bool nearer = alone->depth[place] > to->depth[place];
            for (int i = 0; nearer && i < columns * rows; i++) {
                const int there_x = x + i % columns * width, there_y = y + i / columns * height;
                image_set(to->image, there_x, there_y, image_get(alone->image, there_x, there_y));
            }
            to->depth[place] = nearer ? alone->depth[place] : to->depth[place];
            alone->depth[place] = -INFINITY;
            count++;
        }
    }
    return count;
}

/* The light at all corners of all faces is computed, whether they are drawn or not. Each face is
 * drawn alone, where nothing hides it: so all of its pixels are shaded. Without a material, it is
 * drawn as in scene gouraud. */
static void try_all_faces(struct drawing *drawing, const struct canvas *to,
                          const struct canvas *alone) {
    const struct model *model = drawing->model;
    const struct vec3 direction = vec3_normalized(drawing->light);
    uint64_t shaded = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex v[3];
        struct edges edges;
        const bool drawn = begin_face(model, face, to, v, &edges);
        for (size_t i = 0; i < 3; i++) {
            const struct vec3 normal = vec3_normalized(model_normal(model, face, i));
            if (to->material == NULL) {
                v[i].intensity = corner_intensity(normal, direction);
            } else {
                v[i].parts = corner_light(model_position(model, face, i), normal, drawing->light,
                                          drawing->eye, to->material);
            }
        }
        if (drawn) {
            (to->material == NULL ? triangle : lit_triangle)(alone, &edges, v);
            shaded += try_to_copy(to, alone, &edges);
        }
    }
    drawing_count(drawing, "corners_lit", 3 * model->face_count);
    drawing_count(drawing, "pixels_shaded", shaded);
}

/* In pictures of that size. */
static bool try_without_skipping(struct drawing *drawing, struct image *image, size_t width,
                                 size_t height, const struct material *material,
                                 struct error *error) {
    struct image second;
    double *depth = malloc((width * height + 1) * sizeof *depth);
    if (depth == NULL) {
        return error_out_of_memory(error);
    }
    const bool made = image_create(&second, image->width, image->height, image->format, error);
    if (made) {
        const struct canvas to = {image, width, height, drawing->depth, material};
        const struct canvas alone = {&second, width, height, depth, material};
        depth_clear(depth, width * height);
        try_all_faces(drawing, &to, &alone);
        image_free(&second);
    }
    free(depth);
    return made;
}

static bool try_gouraud(struct drawing *drawing, struct image *image, struct error *error) {
    return drawing->skip
               ? draw_gouraud(drawing, image, error)
               : try_without_skipping(drawing, image, image->width, image->height, NULL, error);
}

static bool try_behind(struct drawing *drawing, struct image *image, struct error *error) {
    return drawing->skip ? draw_behind(drawing, image, error)
                         : try_without_skipping(drawing, image, image->width / 2, image->height / 2,
                                                &satin, error);
}

/* ---- The scenes ---- */

static const struct scene trials[] = {
    {.name = "gouraud", .draw = try_gouraud},
    {.name = "behind", .draw = try_behind},
    /* Not square, and odd: what a square or large picture hides shows here. */
    {
        .name = "wide",
        .needs = MODEL_AND_COLORS,
        .model = "knot.off",
        .width = 203,
        .height = 67,
        .draw = draw_colors,
    },
    {.name = "high", .needs = MODEL_AND_NORMALS, .width = 61, .height = 181, .draw = draw_gouraud},
    {
        .name = "small",
        .needs = MODEL_AND_NORMALS,
        .width = 13,
        .height = 23,
        .light = {-2, 2, 3},
        .eye = {0, 0, 3},
        .draw = draw_lit,
    },
    {.name = "one_pixel",
     .needs = MODEL_AND_NORMALS,
     .width = 1,
     .height = 1,
     .draw = draw_gouraud},
};

MAIN_WITH(trials)
