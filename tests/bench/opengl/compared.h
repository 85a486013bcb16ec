/*
 * The lessons as the comparison sees them: their scenes, and the triangles of each.
 *
 * Each lesson's main.c is included whole by a file of its own here, so that the static functions of
 * one do not meet those of another (see ../lesson.h).
 */
#ifndef OPENGL_COMPARED_H
#define OPENGL_COMPARED_H

#include "picture.h"
#include "program.h"

typedef bool draw_function(struct drawing *drawing, struct image *image, struct error *error);

struct lesson {
    const struct program *program;
    size_t state_size; /* of `drawing->state`, where it is to be larger than the program's */
    /* Why a scene is not compared; NULL when it is. May be NULL itself: all are. */
    const char *(*skipped)(const char *scene);
    /* What of a scene is not triangles and is left out; NULL when it is all triangles. */
    const char *(*left_out)(const char *scene);
    /* What draws such a scene without what is left out. NULL: nothing remains of any, they are not
     * compared. */
    draw_function *(*rest)(const char *scene);
    /* Collect the triangles of a scene, for an image of that size. To be called after `prepare` of
     * the program and after the scene was drawn once. `picture` is empty and has its size. */
    bool (*build)(const char *scene, struct drawing *drawing, struct image *image,
                  struct picture *picture, struct error *error);
    /* Does the lesson's own picture show a triangle at this pixel? NULL where a picture drawn over
     * black and over white tells: what is the same in both was drawn. */
    bool (*covered)(const struct drawing *drawing, const struct image *image, size_t pixel);
};

/* All of them in order, then NULL: stepNN.c defines lesson_stepNN. The Makefile writes this list
 * from the names of the files. */
extern const struct lesson *const lessons[];

#endif
