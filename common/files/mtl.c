/* Files of materials; see mtl.h. */
#include "files/mtl.h"

#include "base/file.h"
#include "base/text.h"

#include <ctype.h>
#include <limits.h>
#include <math.h>
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

/* "r g b", or one number for all three, or levels where one is above 2. Colours are cut to 0..1.
 * False where one was, and where there is none, as after "spectral": then the colour stays. */
static bool read_color(struct text *text, float color[3]) {
    double number[3], last = NAN, most = 0;
    bool right = true;
    for (int i = 0; i < 3; i++) {
        double next;
        last = text_next_number(text, &next).length > 0 ? next : last;
        number[i] = last;
        most = fmax(most, last);
        right = right && last >= 0 && last <= 1;
    }
    for (int i = 0; i < 3 && !isnan(number[0]); i++) {
        double share = most > 2 ? number[i] / 255 : number[i];
        color[i] = share > 0 ? (share < 1 ? (float)share : 1) : 0; /* NaN is 0 */
    }
    return right;
}

/* Programs write a Ka of 0, 0.2 or 1 with every material, and mean nothing by it. */
static bool is_usual_ambient(const float color[3]) {
    float grey = color[0];
    return grey == color[1] && grey == color[2] && (grey == 0 || grey == 0.2F || grey == 1);
}

/* Up to three numbers. Only the first two count. */
static void read_pair(struct text *text, float pair[2]) {
    for (int i = 0; i < 3; i++) {
        struct text ahead = *text;
        double number;
        if (!word_to_double(text_next_word(&ahead), &number)) {
            return;
        }
        if (i < 2 && number >= -1e6 && number <= 1e6) {
            pair[i] = (float)number;
        }
        *text = ahead;
    }
}

/* The options before a texture's name, each of them with what follows it. `material` gets those
 * that count. */
static void read_options(struct text *text, struct model_material *material) {
    float ignored[2];
    for (;;) {
        struct text ahead = *text;
        struct word option = text_next_word(&ahead);
        if (option.length < 2 || option.start[0] != '-') {
            return;
        }
        if (word_is(option, "-s")) {
            read_pair(&ahead, material->scale);
        } else if (word_is(option, "-o")) {
            read_pair(&ahead, material->offset);
        } else if (word_is(option, "-t")) {
            read_pair(&ahead, ignored);
        } else if (word_is(option, "-bm")) {
            double number;
            text_next_number(&ahead, &number);
            material->bump = number > 0 && number <= 100 ? (float)number : 1;
        } else if (word_is(option, "-clamp")) {
            material->clamp = word_is(text_next_word(&ahead), "on");
        } else { /* every other one has one argument, or two */
            text_next_word(&ahead);
            if (word_is(option, "-mm")) {
                text_next_word(&ahead);
            }
        }
        *text = ahead;
    }
}

/* Is the file there, perhaps with its extension in small or in capital letters? Then the path has
 * these. */
static bool find_in_any_case(char *path) {
    char *dot = strrchr(path, '.'), given[8];
    if (file_exists(path) || dot == NULL || strlen(dot) >= sizeof given) {
        return file_exists(path);
    }
    strcpy(given, dot);
    for (int letter = 0x20; letter >= 0; letter -= 0x20) {
        for (size_t i = 1; given[i] != '\0'; i++) {
            dot[i] =
                isalpha((unsigned char)given[i]) ? (char)((given[i] & ~0x20) | letter) : given[i];
        }
        if (file_exists(path)) {
            return true;
        }
    }
    strcpy(dot, given);
    return false;
}

char *mtl_path(struct word name, const char *directory) {
    bool quoted = name.length > 1 && name.start[0] == '"' && name.start[name.length - 1] == '"';
    int length = name.length > INT_MAX ? 0 : (int)name.length - (quoted ? 2 : 0);
    char *path =
        name.length == 0 ? NULL : string_format("%s%.*s", directory, length, name.start + quoted);
    for (char *p = path; p != NULL && *p != '\0'; p++) {
        if (*p == '\\') {
            *p = '/';
        }
    }
    const char *slash = path == NULL ? NULL : strrchr(path, '/');
    if (path == NULL || find_in_any_case(path) || slash == NULL) {
        return path;
    }
    char *next_to = string_format("%s%s", directory, slash + 1);
    if (next_to != NULL && !find_in_any_case(next_to)) {
        free(next_to);
        return path; /* as it is written, for messages */
    }
    free(path);
    return next_to;
}

/* The name before a comment, or before options where some write them. (Names may hold blanks.) */
static struct word without_rest(struct word name) {
    for (size_t i = 1; i + 1 < name.length; i++) {
        const char *p = name.start + i;
        if (p[-1] == ' ' && (*p == '#' || (*p == '-' && isalpha((unsigned char)p[1])))) {
            for (name.length = i; name.length > 0 && name.start[name.length - 1] == ' ';) {
                name.length--;
            }
        }
    }
    return name;
}

/* A map of the material: its options, and its path instead of the last one. */
static bool read_map(struct text *text, struct model_material *options, const char *directory,
                     char **path) {
    read_options(text, options);
    struct word name = text_rest_of_line(text);
    free(*path);
    *path = mtl_path(name, directory);
    if (*path != NULL && !file_exists(*path)) {
        free(*path);
        *path = mtl_path(without_rest(name), directory);
    }
    return name.length == 0 || *path != NULL;
}

/* Small and capital letters are the same, as in many files. */
static bool is_keyword(struct word word, const char *name) {
    return word.length == strlen(name) && word_begins(word, name);
}

/* False when memory runs out. */
static bool read_statement(struct text *text, struct word keyword, const char *directory,
                           struct model_material *material) {
    double number;
    struct model_material options = {.bump = 1}; /* of other maps than that of the colours */
    bool is_norm = is_keyword(keyword, "norm");
    bool is_bump = is_keyword(keyword, "map_Bump") || is_keyword(keyword, "bump");
    if (is_keyword(keyword, "Kd")) {
        read_color(text, material->color);
    } else if (is_keyword(keyword, "Ka")) {
        material->has_ambient =
            read_color(text, material->ambient) && !is_usual_ambient(material->ambient);
    } else if (is_keyword(keyword, "Ks")) {
        float color[3] = {0};
        read_color(text, color);
        material->specular = (color[0] + color[1] + color[2]) / 3;
    } else if (is_keyword(keyword, "Ns")) {
        bool given = text_next_number(text, &number).length > 0 && number >= 0 && number <= 1e4;
        material->power = given ? (float)number : material->power;
    } else if (is_keyword(keyword, "d") || is_keyword(keyword, "Tr")) {
        bool given = text_next_number(text, &number).length > 0;
        material->hidden = is_keyword(keyword, "d") ? given && number <= 0 : material->hidden;
        material->glassy = material->glassy || (given && number > 0 && number < 1);
    } else if (is_keyword(keyword, "map_d")) {
        material->glassy = true;
    } else if (is_keyword(keyword, "map_Kd")) {
        options.bump = material->bump; /* is not its own */
        bool done = read_map(text, material, directory, &material->texture);
        material->bump = options.bump;
        return done;
    } else if (is_keyword(keyword, "map_Ks") || is_keyword(keyword, "map_Ns")) {
        return read_map(text, &options, directory, &material->shine);
    } else if (is_norm || (is_bump && !material->is_norm)) {
        material->is_norm = is_norm;
        bool done = read_map(text, &options, directory, &material->bumps);
        material->bump = options.bump;
        return done;
    }
    return true;
}

/* Where the first of them is named. */
static void warn_of_glass(struct model *model) {
    size_t *line = &model->warning_line[MODEL_GLASSY];
    for (size_t i = 0; i < model->material_count; i++) {
        const struct model_material *material = &model->materials[i];
        if (material->glassy && !material->hidden && (*line == 0 || material->line < *line)) {
            *line = material->line;
        }
    }
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
        if (is_keyword(keyword, "newmtl")) {
            material = find_material(model, text_rest_of_line(&text));
            if (material != NULL) {
                material->known = true;
            }
        } else if (material != NULL && !read_statement(&text, keyword, directory, material)) {
            return error_out_of_memory(error);
        }
    }
    warn_of_glass(model);
    return true;
}
