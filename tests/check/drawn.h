/*
 * Drawing a step: its program run in an empty directory, and the pictures that it left there.
 *
 * Shared by the check and by the program that redraws the references.
 */
#ifndef TESTS_CHECK_DRAWN_H
#define TESTS_CHECK_DRAWN_H

#include "base/error.h"
#include "run.h"
#include "tgaimage.h"

#include <stdbool.h>
#include <stddef.h>

enum { DRAWN_PATH_LIMIT = 4096 };

/* The absolute path of a program in the directory `programs`: it runs in another one. */
struct drawn_path {
    char text[DRAWN_PATH_LIMIT];
};
bool drawn_program(struct drawn_path *path, const char *programs, const char *name,
                   struct error *error);

/* Run `PROGRAM -o DIRECTORY` in the directory, with the limits of an untrusted program. `programs`
 * is the directory of the programs, `step` the program's name; with a scene that is not "" the
 * program is told `--only SCENE`, too, and where `output` is not NULL `--stats`: what it prints
 * becomes that new file. The caller frees result->messages, also on an error. */
bool drawn_run(const char *programs, const char *step, const char *directory, const char *scene,
               const char *output, const struct run_limits *limits, struct run_result *result,
               struct error *error);

enum drawn_state { DRAWN_READ, DRAWN_MISSING, DRAWN_UNREADABLE, DRAWN_WRONG_SIZE };

/* Read DIRECTORY/SCENE.tga. With `wanted` not NULL, a picture of another size than that one is
 * DRAWN_WRONG_SIZE: it is read too if it is not huge, otherwise `image` is empty. Without it, any
 * size will do. What is wrong is in `error`. The caller frees the image. */
enum drawn_state drawn_read(struct image *image, const char *directory, const char *scene,
                            const struct image *wanted, struct error *error);

/* The first line of a text that says something (holds a letter), made safe to print: cut to one
 * line of at most 200 bytes, with a blank for what text_make_printable() replaces. */
struct message_line {
    char text[208];
};
struct message_line drawn_message(const char *text);

/* Where the line begins in which `at` points; `text` is where the first one does. */
const char *message_line_start(const char *text, const char *at);

#endif
