/* Files of materials; see mtl.h. */
#include "files/mtl.h"

#include "base/file.h"
#include "base/text.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

static struct model_material *find_material(struct model *model, struct word name) {
    for (size_t i = 0; i < model->material_count; i++) {
        if (word_is(name, model->materials[i].name)) {
            return &model->materials[i];
        }
    }
    return NULL;
}

/* "r g b", or one number for all three. Colours are cut to 0..1. */
static void read_color(struct text *text, float color[3]) {
    double number = 0;
    for (int i = 0; i < 3; i++) {
        double next;
        if (text_next_number(text, &next).length > 0) {
            number = next;
        }
        color[i] = number > 0 ? (number < 1 ? (float)number : 1) : 0; /* NaN is 0 */
    }
}

/* Over the options before a texture's name, each of them with what follows it. */
static void skip_options(struct text *text) {
    for (;;) {
        struct text ahead = *text;
        struct word option = text_next_word(&ahead);
        if (option.length < 2 || option.start[0] != '-') {
            return;
        }
        bool numbers = word_is(option, "-o") || word_is(option, "-s") || word_is(option, "-t");
        text_next_word(&ahead); /* every option has one argument at least */
        if (word_is(option, "-mm")) {
            text_next_word(&ahead);
        }
        for (int i = 0; numbers && i < 2; i++) { /* these have up to three numbers */
            struct text behind = ahead;
            double number;
            if (word_to_double(text_next_word(&behind), &number)) {
                ahead = behind;
            }
        }
        *text = ahead;
    }
}

/* The path of a texture: beside the materials or, where it is not there (many files name
 * directories of their maker's machine), by its last part alone. The caller frees it. */
static char *texture_path(struct word name, const char *directory) {
    if (name.length == 0 || name.length > INT_MAX) {
        return NULL;
    }
    char *path = string_format("%s%.*s", directory, (int)name.length, name.start);
    for (char *p = path; p != NULL && *p != '\0'; p++) {
        if (*p == '\\') {
            *p = '/';
        }
    }
    const char *slash = path == NULL ? NULL : strrchr(path, '/');
    if (slash == NULL || file_exists(path)) {
        return path;
    }
    char *beside = string_format("%s%s", directory, slash + 1);
    if (beside == NULL || !file_exists(beside)) {
        free(beside);
        return path; /* as it is written, for messages */
    }
    free(path);
    return beside;
}

bool mtl_decode(struct model *model, const void *data, size_t size, const char *directory,
                struct error *error) {
    struct text text;
    struct error ignored;
    struct model_material *material = NULL;
    if (!text_begin(&text, data, size, false, &ignored)) {
        return true; /* no text, and nothing is known */
    }
    while (text_next_line(&text)) {
        struct word keyword = text_next_word(&text);
        if (word_is(keyword, "newmtl")) {
            material = find_material(model, text_rest_of_line(&text));
            if (material != NULL) {
                material->known = true;
            }
        } else if (material != NULL && word_is(keyword, "Kd")) {
            read_color(&text, material->color);
        } else if (material != NULL && word_is(keyword, "map_Kd")) {
            skip_options(&text);
            struct word name = text_rest_of_line(&text);
            free(material->texture);
            material->texture = texture_path(name, directory);
            if (name.length > 0 && material->texture == NULL) {
                return error_out_of_memory(error);
            }
        }
    }
    return true;
}
