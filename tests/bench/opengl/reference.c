/* The triangles of a picture drawn with the course's edges: see reference.h. */
#include "reference.h"

#include <stdlib.h>

static void draw_triangle(struct reference *reference, const struct picture *picture,
                          const struct batch *batch, size_t first) {
    const struct placed *corners = &batch->placed[first];
    const struct gl_corner *given = &batch->snapped[first];
    const float face = given->face;
    /* Such a face has the same intensity at all corners. */
    const bool discarded = batch->look == LOOK_LIT_ONLY && !(given->varyings[0] > 0);
    struct edges edges;
    const struct rectangle *r = &batch->viewport;
    if (!edges_setup(&edges, corners[0].screen, corners[1].screen, corners[2].screen,
                     picture->width, picture->height) ||
        batch->cull == (edges.clockwise ? CULL_BACK : CULL_FRONT)) {
        return;
    }
    int y_begin = edges.y_begin > r->y ? edges.y_begin : r->y;
    int y_end = edges.y_end < r->y + r->height ? edges.y_end : r->y + r->height;
    for (int y = y_begin; y < y_end; y++) {
        struct span span = edges_span(&edges, y);
        int x_begin = span.begin > r->x ? span.begin : r->x;
        int x_end = span.end < r->x + r->width ? span.end : r->x + r->width;
        for (int x = x_begin; x < x_end; x++) {
            size_t i = (size_t)y * picture->width + (size_t)x;
            double depth = interpolate_depth(edges_weights(&edges, x, y), corners[0].depth,
                                             corners[1].depth, corners[2].depth);
            reference->layers[i][0] += 1;
            reference->layers[i][1] += face;
            if (discarded) {
                continue;
            }
            if (!batch->depth_test || depth > reference->depths[i]) {
                reference->faces[i] = face;
                reference->depths[i] = depth;
            }
        }
    }
}

bool reference_draw(struct reference *reference, const struct picture *picture,
                    struct error *error) {
    size_t pixel_count = picture->width * picture->height;
    *reference = (struct reference){
        .faces = calloc(pixel_count, sizeof *reference->faces),
        .depths = calloc(pixel_count, sizeof *reference->depths),
        .layers = calloc(pixel_count, sizeof *reference->layers),
    };
    if (reference->faces == NULL || reference->depths == NULL || reference->layers == NULL) {
        reference_free(reference);
        return error_set(error, "out of memory");
    }
    for (size_t i = 0; i < picture->batch_count; i++) {
        const struct batch *batch = &picture->batches[i];
        for (size_t corner = 0; corner < batch->snapped_count; corner += 3) {
            draw_triangle(reference, picture, batch, corner);
        }
    }
    return true;
}

void reference_free(struct reference *reference) {
    free(reference->faces);
    free(reference->depths);
    free(reference->layers);
    *reference = (struct reference){0};
}
