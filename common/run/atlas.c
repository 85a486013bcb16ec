/* Pictures of colours: see atlas.h. */
#include "run/atlas.h"

#include "base/array.h"

#include <math.h>

/* A face's place is a square of cells, whose corners are texels. The face is its lower left half,
 * so that bilinear sampling gives the colours between its corners: exactly, except in the cells on
 * the diagonal, whose upper right texel may have to be cut to 0..1. Hence many cells for few
 * faces. */
enum { MOST_CELLS = 32, TEXELS_WANTED = 1 << 22 };

struct places {
    size_t cells, side, across; /* in a place and of a row; texels of a place; places in a row */
    size_t width, height;       /* of the picture */
};

static struct places lay_out(size_t count) {
    struct places p = {.cells = MOST_CELLS, .across = (size_t)ceil(sqrt((double)count))};
    while (p.cells > 1 && (uint64_t)count * (p.cells + 1) * (p.cells + 1) > TEXELS_WANTED) {
        p.cells /= 2;
    }
    p.side = p.cells + 1;
    p.width = p.across * p.side;
    p.height = (count + p.across - 1) / p.across * p.side;
    return p;
}

void find_tint(const float color[3], float tint[3]) {
    bool grey = color[0] == color[1] && color[1] == color[2];
    for (int i = 0; i < 3; i++) {
        tint[i] = grey ? 1 : color[i];
    }
}

/* The colours of a face's corners. */
static void find_colors(const struct model *model, size_t face, struct vec3 color[3]) {
    uint32_t material = model->face_materials == NULL ? MODEL_NONE : model->face_materials[face];
    float tint[3] = {1, 1, 1};
    if (material != MODEL_NONE) {
        find_tint(model->materials[material].color, tint);
    }
    for (size_t i = 0; i < 3; i++) {
        struct vec3 c = model_color(model, face, i);
        color[i] =
            (struct vec3){c.x * (double)tint[0], c.y * (double)tint[1], c.z * (double)tint[2]};
    }
}

static uint8_t level_of(double value) {
    return (uint8_t)(255 * (value > 0 ? value < 1 ? value : 1 : 0) + 0.5);
}

static void paint(struct image *image, const struct places *places, size_t left, size_t bottom,
                  const struct vec3 color[3]) {
    struct vec3 right = vec3_sub(color[1], color[0]), up = vec3_sub(color[2], color[0]);
    for (size_t y = 0; y < places->side; y++) {
        for (size_t x = 0; x < places->side; x++) {
            double u = (double)x / (double)places->cells, v = (double)y / (double)places->cells;
            struct vec3 c = vec3_add(color[0], vec3_add(vec3_scale(right, u), vec3_scale(up, v)));
            image_set(image, (int)(left + x), (int)(bottom + y),
                      color_rgb(level_of(c.x), level_of(c.y), level_of(c.z)));
        }
    }
}

/* Behind the others, coordinates of the place, at whose corners are centres of texels. */
static void give_coordinates(struct model *model, size_t face, const struct places *places,
                             size_t left, size_t bottom) {
    for (size_t i = 0; i < 3; i++) {
        float *uv = model->uvs[model->uv_count];
        uv[0] = (float)(((double)(left + (i == 1) * places->cells) + 0.5) / (double)places->width);
        uv[1] =
            (float)(((double)(bottom + (i == 2) * places->cells) + 0.5) / (double)places->height);
        model->faces[face].corner[i].uv = (uint32_t)model->uv_count++;
    }
}

bool atlas_make(struct texture *atlas, struct model *model, const uint8_t *painted,
                struct error *error) {
    size_t count = 0, capacity = model->uv_count, done = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        count += painted == NULL || painted[i];
    }
    if (count > (MODEL_NONE - 1 - model->uv_count) / 3) {
        return error_set(error, "%zu faces are too many for a picture of their colours", count);
    }
    const struct places places = lay_out(count);
    struct image image;
    if (!array_extend(&model->uvs, &capacity, model->uv_count + 3 * count, sizeof *model->uvs)) {
        return error_out_of_memory(error);
    }
    if (!image_create(&image, places.width, places.height, IMAGE_BGR, error)) {
        return false;
    }
    for (size_t i = 0; i < model->face_count; i++) {
        if (painted == NULL || painted[i]) {
            size_t left = done % places.across * places.side;
            size_t bottom = done / places.across * places.side;
            struct vec3 color[3];
            find_colors(model, i, color);
            paint(&image, &places, left, bottom, color);
            give_coordinates(model, i, &places, left, bottom);
            done++;
        }
    }
    /* Other levels would mix faces that are no neighbours. */
    bool made = texture_create_levels(atlas, &image, 1, error);
    image_free(&image);
    return made;
}
