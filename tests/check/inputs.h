/*
 * What programs are given to draw that nobody has seen before: lines, triangles, models with their
 * textures, all from a seed, the same on every machine.
 *
 * Each can be written in variants that must give the same picture: in another order, with the
 * corners of each triangle turned, or moved by whole pixels.
 */
#ifndef TESTS_CHECK_INPUTS_H
#define TESTS_CHECK_INPUTS_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum input_kind {
    INPUT_LINES,          /* a text scene: lines of one colour each */
    INPUT_ODD_LINES,      /* such that no pixel of them is half-way between two others */
    INPUT_AXIS_LINES,     /* points, and lines along the axes and diagonals */
    INPUT_GRADIENT_LINES, /* lines of two colours */
    INPUT_TRIANGLES,      /* a text scene: triangles of one colour, the same for all */
    INPUT_GRADIENT_TRIANGLES,
    INPUT_MODEL,    /* an OBJ with coordinates, normals and textures: two bodies in each other */
    INPUT_MODEL_OFF /* an OFF: positions and faces alone */
};

/* All zero: as it comes. */
struct variant {
    bool shuffled; /* shapes in another order */
    int turned;    /* the first corner of each triangle is number 0, 1 or 2 of before */
    bool reversed; /* the ends of each line exchanged */
    int right, up; /* moved by so many pixels of an image of INPUT_SIZE */
};

enum { INPUT_SIZE = 256 }; /* pixels of a side, for which `right` and `up` count; a power of two */

/* Numbers that look random: G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number
 * generators" (2014). */
struct random {
    uint64_t state;
};
uint64_t random_next(struct random *random);
int random_between(struct random *random, int least, int most); /* both inclusive */

/* Write the input as `path`, a model's textures next to it: `name.obj` has `name_diffuse.tga`,
 * `name_nm.tga` and `name_spec.tga`. A text scene of lines has the size width x height. */
bool input_write(const char *path, enum input_kind kind, uint64_t seed,
                 const struct variant *variant, struct error *error);

/* "scene.txt", "scene.obj" or "scene.off". */
const char *input_name(enum input_kind kind);

#endif
