/* Lists of triangles for Mesa: see picture.h. */
#include "picture.h"

#include <stdlib.h>

static const double snapped_half_size = SNAPPED_VIEWPORT / 2.0;

/* ---- Memory ---- */

/* Room for three more of `count` elements; the array's new place, or NULL. */
static void *grow(void *array, size_t count, size_t *capacity, size_t element_size,
                  struct error *error) {
    if (count + 3 <= *capacity) {
        return array;
    }
    size_t larger = *capacity * 2 + 3072;
    void *moved = larger <= SIZE_MAX / element_size ? realloc(array, larger * element_size) : NULL;
    if (moved == NULL) {
        error_set(error, "out of memory");
        return NULL;
    }
    *capacity = larger;
    return moved;
}

struct batch *picture_add_batch(struct picture *picture, const struct batch *settings,
                                struct error *error) {
    struct batch *batches =
        realloc(picture->batches, (picture->batch_count + 1) * sizeof *picture->batches);
    if (batches == NULL) {
        error_set(error, "out of memory");
        return NULL;
    }
    picture->batches = batches;
    struct batch *batch = &batches[picture->batch_count++];
    *batch = *settings;
    double shift = (double)picture->shift / SUBPIXELS;
    batch->snapped_center =
        (struct vec2){(double)(picture->width / 2) - shift, (double)(picture->height / 2) - shift};
    return batch;
}

void picture_free(struct picture *picture) {
    for (size_t i = 0; i < picture->batch_count; i++) {
        free(picture->batches[i].whole);
        free(picture->batches[i].snapped);
        free(picture->batches[i].placed);
    }
    free(picture->batches);
    *picture = (struct picture){0};
}

/* ---- Triangles ---- */

static struct gl_corner make_corner(const struct corner_data *data, struct vec4 position,
                                    size_t face) {
    struct gl_corner corner = {
        .position = {(float)position.x, (float)position.y, (float)position.z, (float)position.w},
        .face = (float)(face + 1),
    };
    for (int i = 0; i < VARYINGS; i++) {
        corner.varyings[i] = (float)data->varyings[i];
    }
    return corner;
}

bool batch_add_whole(struct batch *batch, size_t face, const struct corner_data corners[3],
                     struct error *error) {
    struct gl_corner *whole =
        grow(batch->whole, batch->whole_count, &batch->whole_capacity, sizeof *batch->whole, error);
    if (whole == NULL) {
        return false;
    }
    batch->whole = whole;
    for (int i = 0; i < 3; i++) {
        struct vec3 p = corners[i].position;
        whole[batch->whole_count++] =
            make_corner(&corners[i], (struct vec4){p.x, p.y, p.z, 1}, face);
    }
    return true;
}

/* The position in clip space that lands on the placed corner. The division by w and the way back to
 * pixels are done by OpenGL in float; what that rounds is far below 1/512 pixel near the
 * picture. */
static struct vec4 snapped_position(const struct placed *placed, struct vec2 center) {
    double w = (double)(float)(1 / placed->recip_w);
    double x = ((double)placed->screen.x / SUBPIXELS - center.x) / snapped_half_size;
    double y = ((double)placed->screen.y / SUBPIXELS - center.y) / snapped_half_size;
    return (struct vec4){x * w, y * w, placed->depth * w, w};
}

bool batch_add_snapped(struct batch *batch, size_t face, const struct corner_data corners[3],
                       struct error *error) {
    size_t capacity = batch->snapped_capacity;
    struct gl_corner *snapped =
        grow(batch->snapped, batch->snapped_count, &capacity, sizeof *batch->snapped, error);
    if (snapped == NULL) {
        return false;
    }
    batch->snapped = snapped;
    struct placed *placed = grow(batch->placed, batch->snapped_count, &batch->snapped_capacity,
                                 sizeof *batch->placed, error);
    if (placed == NULL) {
        return false;
    }
    batch->placed = placed;
    for (int i = 0; i < 3; i++) {
        struct vec4 position = snapped_position(&corners[i].placed, batch->snapped_center);
        placed[batch->snapped_count] = corners[i].placed;
        snapped[batch->snapped_count++] = make_corner(&corners[i], position, face);
    }
    return true;
}

bool batch_add_face(struct batch *batch, size_t face, const struct corner_data corners[3],
                    struct error *error) {
    return batch_add_whole(batch, face, corners, error) &&
           batch_add_snapped(batch, face, corners, error);
}

/* ---- Depth and matrices ---- */

struct mat4 parallel_clip(struct mat4 to_clip) {
    for (int column = 0; column < 4; column++) {
        to_clip.m[2][column] = to_clip.m[2][column] / 4 + to_clip.m[3][column] / 2;
    }
    return to_clip;
}

struct mat4 perspective_clip(struct mat4 to_clip) {
    for (int column = 0; column < 4; column++) {
        to_clip.m[2][column] = column == 3 ? NEAR_W : 0;
    }
    return to_clip;
}

struct batch parallel_batch(enum look look, struct rectangle viewport) {
    return (struct batch){
        .look = look,
        .depth_test = true,
        .viewport = viewport,
        .to_clip = parallel_clip(mat4_identity()),
    };
}

bool place_in_viewport(struct vec4 clip, const struct rectangle *viewport, struct placed *placed) {
    placed->recip_w = 1 / clip.w;
    placed->depth = NEAR_W * placed->recip_w;
    double half_width = viewport->width / 2.0, half_height = viewport->height / 2.0;
    struct vec2 position = {viewport->x + (clip.x * placed->recip_w + 1) * half_width,
                            viewport->y + (clip.y * placed->recip_w + 1) * half_height};
    return screen_snap(position, &placed->screen);
}
