/* The command line: see options.h. */
#include "options.h"

#include <stdlib.h>
#include <string.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

const char options_help[] =
    "usage: bench-frame [options] [model]\n"
    "\n"
    "The time of a frame: this course's pipeline and, where Mesa is installed, llvmpipe.\n"
    "\n"
    "  --look NAME        only this look: flat, gouraud or phong (may be repeated)\n"
    "  --size WxH         only images of this size (may be repeated)\n"
    "  --triangles N      each face cut into four until there are about N (may be repeated)\n"
    "  --frames N         frames that are timed of each (default 15)\n"
    "  --quick            3 frames, at the first size, of the model as it is\n"
    "  --skipping         only what each shortcut is worth, where much is hidden or off screen\n"
    "  --least            show the least time instead of the median: for a busy machine\n"
    "  --clear-all        clear all of the image, not only what the last frame has drawn, as\n"
    "                     llvmpipe does\n"
    "  --nearest          llvmpipe takes the nearest texel, this course still four\n"
    "  -o DIR             save the pictures of both there, as PNG\n"
    "  -h, --help         this text\n"
    "\n"
    "The model is an OBJ file, by default the bust; a look whose textures it lacks is left out.\n";

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

/* A whole number of at most `digits` characters. */
static bool read_number(const char *text, size_t digits, size_t most, size_t *number) {
    *number = 0;
    for (size_t i = 0; i < digits; i++) {
        if (text[i] < '0' || text[i] > '9' || *number > most) {
            return false;
        }
        *number = 10 * *number + (size_t)(text[i] - '0');
    }
    return digits > 0 && *number >= 1 && *number <= most;
}

static bool read_whole(const char *text, size_t most, size_t *number) {
    return read_number(text, strlen(text), most, number);
}

static bool read_size(const char *text, struct size *size) {
    size_t digits = strcspn(text, "x");
    return text[digits] == 'x' && read_number(text, digits, DRAW_LIMIT, &size->width) &&
           read_whole(text + digits + 1, DRAW_LIMIT, &size->height);
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

/* How many were named of each list; what is named replaces the defaults. */
struct named {
    size_t looks, sizes, triangles;
};

enum value { NOT_UNDERSTOOD, UNDERSTOOD, TAKES_NO_VALUE };

/* An option with a value. */
static enum value read_value(struct options *o, struct named *named, const char *name,
                             const char *value) {
    bool understood = false;
    if (strcmp(name, "--look") == 0) {
        understood = named->looks < LIST_LIMIT && read_look(value, &o->looks[named->looks]);
        o->look_count = ++named->looks;
    } else if (strcmp(name, "--size") == 0) {
        understood = named->sizes < LIST_LIMIT && read_size(value, &o->sizes[named->sizes]);
        o->size_count = ++named->sizes;
    } else if (strcmp(name, "--triangles") == 0) {
        understood = named->triangles < LIST_LIMIT &&
                     read_whole(value, 100000000, &o->triangles[named->triangles]);
        o->triangle_count = ++named->triangles;
    } else if (strcmp(name, "--frames") == 0) {
        understood = read_whole(value, FRAMES_LIMIT, &o->frames);
    } else if (strcmp(name, "-o") == 0) {
        o->directory = value;
        understood = *value != '\0';
    } else {
        return TAKES_NO_VALUE;
    }
    return understood ? UNDERSTOOD : NOT_UNDERSTOOD;
}

/* An option without a value, or the model. */
static bool read_flag(struct options *o, const char *name) {
    if (strcmp(name, "--quick") == 0) {
        o->frames = 3;
        o->size_count = o->triangle_count = 1;
    } else if (strcmp(name, "--least") == 0) {
        o->least = true;
    } else if (strcmp(name, "--clear-all") == 0) {
        o->clearing = CLEAR_ALL;
    } else if (strcmp(name, "--skipping") == 0) {
        o->skipping = true;
    } else if (strcmp(name, "--nearest") == 0) {
        o->filter = FILTER_NEAREST;
    } else if (strcmp(name, "-h") == 0 || strcmp(name, "--help") == 0) {
        o->help = true;
    } else {
        o->model = name;
        return name[0] != '-';
    }
    return true;
}

bool options_read(struct options *o, int argc, char **argv, struct error *error) {
    struct named named = {0, 0, 0};
    *o = defaults;
    for (int i = 1; i < argc; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : "";
        switch (read_value(o, &named, argv[i], value)) {
        case UNDERSTOOD:
            i++;
            break;
        case NOT_UNDERSTOOD:
            return error_set(error, "%s %s: not understood", argv[i], value);
        case TAKES_NO_VALUE:
            if (!read_flag(o, argv[i])) {
                return error_set(error, "there is no option %s", argv[i]);
            }
        }
    }
    return true;
}
