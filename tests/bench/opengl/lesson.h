/*
 * The lessons as the comparison sees them: their scenes, and the triangles of each.
 *
 * Each lesson's main.c is included whole by a file of its own here, so that the static functions of
 * one do not meet those of another. Its main() then hands its table of scenes to lesson_capture()
 * instead of running it.
 */
#ifndef OPENGL_LESSON_H
#define OPENGL_LESSON_H

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

/* Stands in for program_main(): `argv` is the address of a `const struct program *`, which is
 * set. */
int lesson_capture(const struct program *program, int argc, char **argv);

/* Describes a lesson; that of stepNN.c is called lesson_stepNN(). */
typedef struct lesson lesson_function(void);

/* All of them in order, then NULL. The Makefile writes this list from the names of the files. */
extern lesson_function *const lesson_functions[];

#endif
