/* A step that is being judged, for judge.c and diagnose.c. */
#ifndef TESTS_CHECK_JUDGING_H
#define TESTS_CHECK_JUDGING_H

#include "looks.h"
#include "mistakes.h"
#include "options.h"
#include "result.h"
#include "run.h"
#include "scenes.h"

/* What is known of a step before its program runs, which could change files. */
struct judging {
    const struct options *options;
    const struct checked_step *step;
    struct step_result *result;
    struct image *references;     /* one a scene, empty where there is none: it is an ERROR */
    struct mistake_list mistakes; /* that are known, */
    struct looks *looks;          /* and what they look like in each scene */
    struct bytes source;          /* main.c, a NUL at its end */
    struct run_limits limits;
    struct run_directory directory; /* where the program draws */
};

/* Let the program draw a scene once more, "" for all, and count: `output` becomes what it prints,
 * with a NUL at its end. The caller frees output, and end->messages. */
bool judging_count(const struct judging *judging, const char *scene, struct bytes *output,
                   struct run_result *end, struct error *error);

bool judging_ended_well(const struct run_result *end);

/* Remove the file; a picture that is not there has no name, which is no file's. */
void judging_drop_picture(struct result_path *path);

/* Add to a file, "" for none, which whoever keeps limits and signs of mistakes has asked for. */
void judging_append(const char *path, const char *format, ...) PRINTF_LIKE(2, 3);

#endif
