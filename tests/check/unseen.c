/* A program given something new to draw: see unseen.h. */
#define _POSIX_C_SOURCE 200809L
#include "unseen.h"
#include "base/file.h"

#include <stdio.h>
#include <string.h>

bool unseen_begin(struct unseen_place *place, struct error *error) {
    if (!run_directory_create(&place->whole, error)) {
        return false;
    }
    snprintf(place->input, sizeof place->input, "%s/input", place->whole.path);
    snprintf(place->pictures, sizeof place->pictures, "%s/pictures", place->whole.path);
    if (!directory_create(place->input, error) || !directory_create(place->pictures, error)) {
        unseen_end(place);
        return false;
    }
    return true;
}

void unseen_end(const struct unseen_place *place) {
    run_directory_remove(place->whole.path);
}

bool unseen_draw(struct unseen_place *place, const char *program, const char *const *options,
                 enum input_kind kind, uint64_t seed, const struct variant *variant,
                 const struct run_limits *limits, struct run_result *result, struct error *error) {
    char path[DRAWN_PATH_LIMIT + 32];
    const char *arguments[UNSEEN_OPTION_LIMIT + 5] = {program, "-o", place->pictures};
    size_t count = 3;
    *result = (struct run_result){.end = RUN_EXITED};
    for (; *options != NULL && count < UNSEEN_OPTION_LIMIT + 3; options++) {
        arguments[count++] = *options;
    }
    snprintf(path, sizeof path, "%s/%s", place->input, input_name(kind));
    arguments[count] = path;
    run_directory_remove(place->pictures);
    if (!directory_create(place->pictures, error) ||
        !input_write(path, kind, seed, variant, error)) {
        return false;
    }
    struct run_command command = {
        .arguments = arguments, .directory = place->pictures, .contained = true, .limits = *limits};
    return run(&command, result, error);
}

bool unseen_takes_text(const char *step) {
    return strncmp(step, "step01_", 7) == 0 || strncmp(step, "step03_", 7) == 0;
}
