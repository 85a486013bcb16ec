/* The command line: see options.h. */
#include "options.h"

#include "check/arguments.h"

#include <stdio.h>
#include <string.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

static const struct options defaults = {
    .model = COURSE_BUILD "/models/bust.obj",
    .looks = {FRAME_FLAT, FRAME_GOURAUD, FRAME_PHONG},
    .look_count = FRAME_LOOKS,
    .sizes = {{800, 800}, {1920, 1080}, {3840, 2160}},
    .size_count = 3,
    .triangles = {2500, 40000, 640000},
    .triangle_count = 3,
    .frames = 15,
    .clearing = CLEAR_LAST_FRAME,
};

/* A whole number in the first characters of the text. */
static bool read_number(const char *text, size_t length, size_t most, size_t *number) {
    char digits[16];
    bool fits = length < sizeof digits;
    snprintf(digits, sizeof digits, "%.*s", fits ? (int)length : 0, text);
    return argument_number(digits, number) && *number <= most;
}

static bool read_frames(const char *value, void *target) {
    return read_number(value, strlen(value), FRAMES_LIMIT, target);
}

static bool read_size(const char *text, struct size *size) {
    size_t digits = strcspn(text, "x");
    return text[digits] == 'x' && read_number(text, digits, DRAW_LIMIT, &size->width) &&
           read_number(text + digits + 1, strlen(text + digits + 1), DRAW_LIMIT, &size->height);
}

static bool read_look(const char *text, enum frame_look *look) {
    for (int i = 0; i < FRAME_LOOKS; i++) {
        if (strcmp(text, frame_look_name[i]) == 0) {
            *look = (enum frame_look)i;
            return true;
        }
    }
    return false;
}

/* What is named replaces the defaults: how many were named of each list. */
struct adding {
    struct options *options;
    size_t looks, sizes, triangles;
};

static bool add_look(const char *value, void *target) {
    struct adding *adding = target;
    bool added =
        adding->looks < LIST_LIMIT && read_look(value, &adding->options->looks[adding->looks]);
    adding->options->look_count = ++adding->looks;
    return added;
}

static bool add_size(const char *value, void *target) {
    struct adding *adding = target;
    bool added =
        adding->sizes < LIST_LIMIT && read_size(value, &adding->options->sizes[adding->sizes]);
    adding->options->size_count = ++adding->sizes;
    return added;
}

static bool add_triangles(const char *value, void *target) {
    struct adding *adding = target;
    bool added = adding->triangles < LIST_LIMIT &&
                 read_number(value, strlen(value), TRIANGLES_LIMIT,
                             &adding->options->triangles[adding->triangles]);
    adding->options->triangle_count = ++adding->triangles;
    return added;
}

static bool be_quick(const char *value, void *target) {
    struct options *options = target;
    (void)value;
    options->frames = 3;
    options->size_count = options->triangle_count = 1;
    return true;
}

static bool clear_all(const char *value, void *target) {
    (void)value;
    *(enum clearing *)target = CLEAR_ALL;
    return true;
}

bool options_read(struct options *o, int argc, char **argv, struct error *error) {
    struct adding adding = {.options = o};
    const struct argument known[] = {
        {"--look", "NAME", "only this look: flat, gouraud or phong (may be repeated)", add_look,
         &adding},
        {"--size", "WxH", "only images of this size (may be repeated)", add_size, &adding},
        {"--triangles", "N", "each face cut into four until there are about N (may be repeated)",
         add_triangles, &adding},
        {"--frames", "N", "frames that are timed of each (default 15)", read_frames, &o->frames},
        {"--quick", "", "3 frames, at the first size, of the model as it is", be_quick, o},
        {"--skipping", "", "only what each shortcut is worth, where much is hidden or off screen",
         argument_flag, &o->skipping},
        {"--clear-all", "",
         "clear all of the image, not only what the last frame has drawn, as\nllvmpipe does",
         clear_all, &o->clearing},
    };
    const size_t known_count = sizeof known / sizeof known[0];
    *o = defaults;
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
    o->model = models == 1 ? argv[1] : o->model;
    return models >= 0;
}
