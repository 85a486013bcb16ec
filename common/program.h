/*
 * What the main() of every step shares: options, loading, timing, counting, saving, errors.
 *
 * A step describes itself in a struct program: its scenes, what each of them needs and the function
 * that draws it. program_main() does the rest:
 *
 *     static bool draw_flat(struct drawing *drawing, struct image *image, struct error *error) {
 *         ...
 *     }
 *
 *     static const struct scene scenes[] = {
 *         {.name = "flat", .needs = NEEDS_MODEL, .draw = draw_flat},
 *     };
 *
 *     static const struct program step04_flat = {
 *         .name = "step04_flat",
 *         .summary = "one grey level a face",
 *         .defaults = {.width = 800, .height = 800, .light = {0, 0, -1}},
 *         .scenes = scenes,
 *         .scene_count = sizeof scenes / sizeof scenes[0],
 *     };
 *
 *     int main(int argc, char **argv) {
 *         return program_main(&step04_flat, argc, argv);
 *     }
 */
#ifndef COMMON_PROGRAM_H
#define COMMON_PROGRAM_H

#include "run/scene.h"

/* Run the program: read the options, draw the scenes, save the images. Returns the exit status:
 * 0 done, 1 an input or an output failed, 2 wrong usage. */
int program_main(const struct program *program, int argc, char **argv);

#endif
