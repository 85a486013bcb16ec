/*
 * Draws the reference images again: what `make references` calls, and never a check.
 *
 *     references [--root DIR] [--scenes FILE] [--references DIR] [--programs DIR] [STEP ...]
 *
 * Runs each step's program, which must be built, as the check does, and turns its TGA pictures into
 * the PNG files DIR/stepNN_name/scene.png. A reference that already shows the same picture is left
 * alone, so that only what has changed is written. All pictures of a step are read before any is
 * written: a step that fails changes nothing. Whoever runs this should look at every picture that
 * it names before it is committed.
 *
 * Exit status: 0 done, 1 a step failed, 2 wrong usage.
 */
#define _POSIX_C_SOURCE 200809L

#include "arguments.h"
#include "base/file.h"
#include "compare.h"
#include "drawn.h"
#include "files/image_file.h"
#include "files/png.h"
#include "run.h"
#include "scenes.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct options {
    const char *root, *scenes, *references, *programs;
};

/* Generous: here nobody's mistakes are to be found. */
static const struct run_limits limits = {
    .seconds = 300, .file_bytes = (size_t)256 * 1000 * 1000, .processes = 64};

/* The same look in the same size? Alpha counts for nothing, as in the check. */
static bool same_picture(const struct image *a, const struct image *b) {
    return a->width == b->width && a->height == b->height &&
           compare_images(a, b).differing.count == 0;
}

static bool save_picture(const struct options *options, const char *step, const char *scene,
                         const struct image *image, struct error *error) {
    char directory[DRAWN_PATH_LIMIT], path[DRAWN_PATH_LIMIT];
    snprintf(directory, sizeof directory, "%s/%s", options->references, step);
    if ((size_t)snprintf(path, sizeof path, "%s/%s/%s.png", options->references, step, scene) >=
        sizeof path) {
        return error_set(error, "%s: name too long", options->references);
    }
    struct image old;
    struct error ignored;
    bool exists = access(path, F_OK) == 0;
    bool same = image_read(&old, path, &ignored) && same_picture(&old, image);
    image_free(&old);
    if (!same && (!directory_create(directory, error) || !png_write(image, path, error))) {
        return false;
    }
    printf("%-9s  %s\n", same ? "unchanged" : (exists ? "changed" : "new"), path);
    return true;
}

/* Read all pictures of the step; false, with a message, when one is missing or blank. */
static bool read_pictures(const char *directory, const struct checked_step *step,
                          struct image *images, struct error *error) {
    for (size_t i = 0; i < step->scene_count; i++) {
        struct error reason;
        const char *scene = step->scenes[i].name;
        if (drawn_read(&images[i], directory, scene, NULL, &reason) != DRAWN_READ) {
            return error_set(error, "%s: %.900s", scene, reason.message);
        }
        if (image_is_blank(&images[i])) {
            return error_set(error, "%s: the picture is blank", scene);
        }
    }
    return true;
}

static bool draw_step(const struct options *options, const char *directory,
                      const struct checked_step *step, struct image *images, struct error *error) {
    struct run_result end;
    bool done = drawn_run(options->programs, step->name, directory, "", &limits, &end, error);
    if (done && (end.end != RUN_EXITED || end.number != 0)) {
        const char *said = (const char *)end.messages.data;
        done = error_set(error, "the program did not end well: %s", drawn_message(said).text);
    }
    bytes_free(&end.messages);
    return done && read_pictures(directory, step, images, error);
}

static bool redraw_step(const struct options *options, const struct checked_step *step,
                        struct error *error) {
    struct run_directory directory;
    struct image *images = calloc(step->scene_count, sizeof *images);
    if (images == NULL) {
        return error_set(error, "out of memory");
    }
    bool done = run_directory_create(&directory, error);
    if (done) {
        done = draw_step(options, directory.path, step, images, error);
        run_directory_remove(directory.path);
    }
    for (size_t i = 0; i < step->scene_count && done; i++) {
        done = save_picture(options, step->name, step->scenes[i].name, &images[i], error);
    }
    for (size_t i = 0; i < step->scene_count; i++) {
        image_free(&images[i]);
    }
    free(images);
    return done;
}

int main(int argc, char **argv) {
    struct options options = {.root = ".",
                              .scenes = "tests/check/scenes.txt",
                              .references = "tests/reference",
                              .programs = "build"};
    struct scene_table table;
    struct error error;
    const struct argument known[] = {
        {"--root", "DIR", "", argument_text, &options.root},
        {"--scenes", "FILE", "", argument_text, &options.scenes},
        {"--references", "DIR", "", argument_text, &options.references},
        {"--programs", "DIR", "", argument_text, &options.programs},
    };
    if (!run_open_standard_files()) {
        return 2;
    }
    int step_count = arguments_read(known, sizeof known / sizeof known[0], argc, argv, &error);
    if (step_count < 0) {
        fprintf(stderr, "Usage: references [--root DIR] [--scenes FILE] [--references DIR] "
                        "[--programs DIR] [STEP ...]\n");
        return 2;
    }
    if (chdir(options.root) != 0) {
        fprintf(stderr, "references: %s: %s\n", options.root, strerror(errno));
        return 2;
    }
    if (!scene_table_read(&table, options.scenes, &error)) {
        fprintf(stderr, "references: %s\n", error.message);
        return 2;
    }
    bool any = false;
    for (int i = 1; i <= step_count; i++) {
        any |= argv[i][0] != '\0';
        if (!scene_table_select(&table, argv[i], &error)) {
            fprintf(stderr, "references: %s\n", error.message);
            scene_table_free(&table);
            return 2;
        }
    }
    if (!any) {
        scene_table_select_all(&table);
    }
    run_catch_signals();
    int status = 0;
    for (size_t i = 0; i < table.step_count && run_caught_signal() == 0; i++) {
        if (table.steps[i].selected && !redraw_step(&options, &table.steps[i], &error)) {
            fprintf(stderr, "references: %s: %s\n", table.steps[i].name, error.message);
            status = 1;
        }
    }
    scene_table_free(&table);
    if (run_caught_signal() != 0) {
        run_die_of_signal();
    }
    return status;
}
