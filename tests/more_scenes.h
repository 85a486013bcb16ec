/*
 * A lesson's program with more scenes than its own: what tests/lessons/stepNN_name/trials.c is made
 * of, whose scenes find wrong programs, and live.c, whose scenes can be dragged and turned.
 *
 *     #ifndef LESSON
 *     #define LESSON "../step05_zbuffer/main.c"
 *     #endif
 *     #include "more_scenes.h"
 *
 *     static bool try_deep(...) { ... draw_zbuffer(...) ... }
 *
 *     static const struct scene trials[] = {{.name = "deep", .draw = try_deep, ...}};
 *
 *     MAIN_WITH(trials)
 *
 * The lesson's main.c is included, and its main() called: what it hands to program_main() comes to
 * main_with_more(). A student's function may have any name: those of trials.c begin with try_, and
 * those of live.c with live_. One file can have one lesson.
 */
#ifndef TESTS_MORE_SCENES_H
#define TESTS_MORE_SCENES_H

#include "program.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int main_with_more(const struct program *program, int argc, char **argv);

#define program_main main_with_more
#include "lesson.h"
#undef program_main

/* Of her names, too. */
#pragma GCC diagnostic ignored "-Wshadow"

/* A program of several lessons gives each main() a name of its own. */
#ifndef MORE_MAIN
#define MORE_MAIN main
#endif
int MORE_MAIN(int argc, char **argv) {
    return lesson_main(argc, argv);
}

/* Run the program with these scenes, too. One that has the name of a scene of the lesson takes its
 * place: its values and what draws it. The others are trials: drawn when --only names them, or
 * all. */
static inline int main_with(const struct program *program, const struct scene *more, size_t count,
                            int argc, char **argv) {
    struct program whole = *program;
    struct scene *joined = calloc(program->scene_count + count, sizeof *joined);
    if (joined == NULL) {
        fprintf(stderr, "%s: out of memory\n", program->name);
        return 1;
    }
    memcpy(joined, program->scenes, program->scene_count * sizeof *joined);
    for (size_t i = 0; i < count; i++) {
        size_t place = 0;
        while (place < program->scene_count && strcmp(joined[place].name, more[i].name) != 0) {
            place++;
        }
        struct scene *scene = &joined[place];
        if (place == program->scene_count) {
            scene = &joined[whole.scene_count++];
            *scene = more[i];
            scene->trial = true;
        } else {
            scene->values = more[i].values;
            scene->draw = more[i].draw;
        }
    }
    whole.scenes = joined;
    int status = program_main(&whole, argc, argv);
    free(joined);
    return status;
}

/* The last line of such a file. One that changes more than scenes has a main_with_more(). */
#define MAIN_WITH(more)                                                                            \
    static int main_with_more(const struct program *program, int argc, char **argv) {              \
        return main_with(program, more, sizeof(more) / sizeof(more)[0], argc, argv);               \
    }

#endif
