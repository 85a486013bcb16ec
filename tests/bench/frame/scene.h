/*
 * What `make bench-frame` draws: a head in one of three looks, of any size, with any number of
 * triangles. Both sides draw it from this description alone.
 */
#ifndef TESTS_BENCH_FRAME_SCENE_H
#define TESTS_BENCH_FRAME_SCENE_H

#include "base/error.h"
#include "geometry.h"
#include "model.h"
#include "pipeline.h"
#include "texture.h"

#include <stdbool.h>
#include <stddef.h>

/* The light of a pixel, in levels 0..255; n . l is not below 0:
 *
 *   FLAT      255 (n . l), with the normal of the face
 *   GOURAUD   texture * (n . l at the corners, interpolated)
 *   PHONG     texture * (AMBIENT + n . l) + 255 weight (r . v)^10, normal and weight from maps;
 *             the last part only where n . l is above 0 */
enum frame_look { FRAME_FLAT, FRAME_GOURAUD, FRAME_PHONG, FRAME_LOOKS };

#define AMBIENT 0.1

extern const char *const frame_look_name[FRAME_LOOKS];

/* A model at one fineness, with what a program that draws it often would make ready once. */
struct frame_model {
    struct model model;       /* normals of length 1, one at each corner */
    float (*face_normals)[3]; /* of length 1; one a face */
};

/* A texture at the one mip level that is read. */
struct frame_texture {
    const struct texture *texture; /* NULL where the model has none */
    size_t level;
};

struct frame_scene {
    enum frame_look look;
    size_t width, height; /* of the image; cleared as a whole */
    const struct frame_model *head;
    struct frame_texture textures[MODEL_TEXTURE_KINDS];
    struct draw_call call; /* matrix, culling, and the viewport: a square in the middle */
    struct vec3 eye;
    struct vec3 to_light; /* of length 1 */
};

/* Read a model with the textures that it has, and cut each face into four until there are about
 * `triangles`: real shared vertices, and every attribute half-way between those of an edge's ends.
 * `head` is freed with frame_model_free(). */
bool frame_model_read(struct frame_model *head, const char *path, size_t triangles,
                      struct error *error);
void frame_model_free(struct frame_model *head);

/* The head as lesson 10 shows it, in an image of that size. */
struct frame_scene frame_scene(enum frame_look look, size_t width, size_t height,
                               const struct frame_model *head);

/* Does the model have the textures that the look reads? */
bool frame_look_is_possible(enum frame_look look, const struct model *textured);

#endif
