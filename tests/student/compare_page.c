/*
 * Writes a page of HTML with the pictures of scenes: yours, the reference, and their difference.
 *
 *     compare_page PAGE TITLE SCENE YOURS REFERENCE [SCENE YOURS REFERENCE ...]
 *
 * YOURS and REFERENCE are image files; one that does not exist is left out. In the course's
 * directory, TITLE a step's name, what counts as wrong is what the check counts.
 *
 * Exit status: 0 written, 1 a file cannot be read or written, 2 wrong usage.
 */
#include "base/file.h"
#include "check/page/page.h"
#include "check/page/pictures.h"

#include <stdio.h>
#include <stdlib.h>

enum { STATUS_FAILED = 1, STATUS_USAGE = 2, BEFORE_SCENES = 3, SCENE_ARGUMENTS = 3 };

static bool add_scene(struct bytes *page, const char *step, char **argument, struct error *error) {
    struct pictures pictures;
    struct scene_table table;
    const struct checked_item *rule = pictures_rule(&table, step, argument[0]);
    bool done = pictures_read(&pictures, argument[1], argument[2], rule, error);
    scene_table_free(&table);
    if (!done) {
        return false;
    }
    const struct picture_words words = pictures_describe(&pictures);
    const struct page_scene scene = {
        .name = argument[0], .note = words.text, .level = 2, .pictures = &pictures};
    done = page_scene(page, &scene, error);
    pictures_free(&pictures);
    return done;
}

int main(int argc, char **argv) {
    struct bytes page = {.data = NULL};
    struct error error;
    if (argc < BEFORE_SCENES + SCENE_ARGUMENTS || (argc - BEFORE_SCENES) % SCENE_ARGUMENTS != 0) {
        fputs("usage: compare_page PAGE TITLE SCENE YOURS REFERENCE ...\n", stderr);
        return STATUS_USAGE;
    }
    bool done = page_begin(&page, argv[2]) || error_out_of_memory(&error);
    for (int i = BEFORE_SCENES; i < argc && done; i += SCENE_ARGUMENTS) {
        done = add_scene(&page, argv[2], argv + i, &error);
    }
    done = done && (page_end(&page) || error_out_of_memory(&error)) &&
           file_write(argv[1], page.data, page.size, &error);
    bytes_free(&page);
    if (!done) {
        fprintf(stderr, "compare_page: %s\n", error.message);
        return STATUS_FAILED;
    }
    return EXIT_SUCCESS;
}
