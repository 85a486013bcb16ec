/* The command line: see options.h. */
#include "options.h"

#include "check/arguments.h"

#include <stdio.h>
#include <string.h>

static bool read_frames(const char *value, void *target) {
    return argument_number(value, target) && *(size_t *)target <= FRAMES_LIMIT;
}

static bool read_threads(const char *value, void *target) {
    return argument_number(value, target) && *(size_t *)target <= THREADS_LIMIT;
}

static bool read_look(const char *value, void *target) {
    enum frame_look look = FRAME_FLAT;
    while (look < FRAME_LOOKS && strcmp(value, frame_look_name[look]) != 0) {
        look++;
    }
    *(enum frame_look *)target = look;
    return look < FRAME_LOOKS;
}

static bool be_quick(const char *value, void *target) {
    struct options *options = target;
    (void)value;
    options->frames = 3;
    options->quick = true;
    return true;
}

bool options_read(struct options *o, int argc, char **argv, struct error *error) {
    const struct argument known[] = {
        {"--look", "NAME", "only this look: flat, gouraud or phong", read_look, &o->look},
        {"--frames", "N", "frames that are timed of each (default 15)", read_frames, &o->frames},
        {"--threads", "N", "that draw, on both sides (default 1)", read_threads, &o->threads},
        {"--quick", "", "3 frames, at the first size, of the model as it is", be_quick, o},
        {"--skipping", "",
         "only what each shortcut is worth, and what a frame of ever more faces does",
         argument_flag, &o->skipping},
    };
    const size_t known_count = sizeof known / sizeof known[0];
    *o = (struct options){.look = FRAME_LOOKS, .frames = 15, .threads = 1};
    o->help = arguments_want_help(argc, argv);
    if (o->help) {
        puts("usage: bench-frame [options] [model]\n\n"
             "The time of a frame: this course's pipeline and, where Mesa is installed, "
             "llvmpipe.\n");
        arguments_print_help(known, known_count);
        puts("\nThe model is an OBJ file, by default the bust; a look whose textures it lacks is "
             "left out.");
        return true;
    }
    int models = arguments_read(known, known_count, argc, argv, error);
    if (models > 1) {
        return error_set(error, "more than one model");
    }
    o->model = models == 1 ? argv[1] : COURSE_BUILD "/models/bust.obj";
    return models >= 0;
}
