/* Files of materials; see mtl.h. */
#include "files/mtl.h"

#include "base/text.h"
#include "files/find.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The material of that name or else, since a name may hold anything, of the same name with a
 * comment behind it here or there. */
static struct model_material *find_material(struct model *model, struct word name) {
    struct model_material *similar = NULL;
    for (size_t i = 0; i < model->material_count; i++) {
        const char *own = model->materials[i].name;
        struct word other = name_without_rest(word_of(own));
        if (word_is(name, own)) {
            return &model->materials[i];
        }
        if (word_is(name_without_rest(name), own) ||
            (name.length == other.length && memcmp(name.start, own, name.length) == 0)) {
            similar = &model->materials[i];
        }
    }
    return similar;
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

/* The options before a texture's name, each of them with what follows it. */
static void read_options(struct text *text, struct model_material *material, float *bump) {
    float ignored[2] = {0};
    *bump = 1;
    for (;;) {
        struct text ahead = *text;
        struct word option = text_next_word(&ahead);
        if (option.length < 2 || option.start[0] != '-') {
            return;
        }
        float *pair = word_is(option, "-s")   ? material->scale
                      : word_is(option, "-o") ? material->offset
                      : word_is(option, "-t") ? ignored
                                              : NULL;
        if (pair != NULL) {
            read_pair(&ahead, pair);
        } else if (word_is(option, "-bm")) {
            double number;
            text_next_number(&ahead, &number);
            *bump = number > 0 && number <= 100 ? (float)number : 1;
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

/* A map of the material: its options, and its path instead of the last one. */
static bool read_map(struct text *text, struct model_material *options, float *bump,
                     const char *library, char **path) {
    read_options(text, options, bump);
    struct word name = text_rest_of_line(text);
    bool found;
    free(*path);
    *path = find_named(name, library, true, &found);
    return name.length == 0 || *path != NULL;
}

/* Keywords are written in small or capital letters. False when memory runs out. */
static bool read_statement(struct text *text, struct word keyword, const char *library,
                           struct model_material *material) {
    double number;
    struct model_material others = {0}; /* the options of other maps than that of colours, */
    float ignored;                      /* and -bm of other maps than bumps, count for nothing */
    bool is_norm = word_matches(keyword, "norm");
    bool is_bump = word_matches(keyword, "map_Bump") || word_matches(keyword, "bump");
    if (word_matches(keyword, "Kd")) {
        read_color(text, material->color);
    } else if (word_matches(keyword, "Ka")) {
        material->has_ambient =
            read_color(text, material->ambient) && !is_usual_ambient(material->ambient);
    } else if (word_matches(keyword, "Ks")) {
        float color[3] = {0};
        read_color(text, color);
        material->specular = (color[0] + color[1] + color[2]) / 3;
    } else if (word_matches(keyword, "Ns")) {
        bool given = text_next_number(text, &number).length > 0 && number >= 0 && number <= 1e4;
        material->power = given ? (float)number : material->power;
    } else if (word_matches(keyword, "d") || word_matches(keyword, "Tr")) {
        bool given = text_next_number(text, &number).length > 0;
        material->hidden = word_matches(keyword, "d") ? given && number <= 0 : material->hidden;
        material->glassy = material->glassy || (given && number > 0 && number < 1);
    } else if (word_matches(keyword, "map_d")) {
        material->glassy = true;
    } else if (word_matches(keyword, "map_Kd")) {
        return read_map(text, material, &ignored, library, &material->texture);
    } else if (word_matches(keyword, "map_Ks") || word_matches(keyword, "map_Ns")) {
        return read_map(text, &others, &ignored, library, &material->shine);
    } else if (is_norm || (is_bump && !material->is_norm)) {
        material->is_norm = is_norm;
        return read_map(text, &others, &material->bump, library, &material->bumps);
    }
    return true;
}

bool mtl_decode(struct model *model, const void *data, size_t size, const char *path,
                struct error *error) {
    struct text text;
    struct error ignored;
    struct model_material *material = NULL;
    if (!text_begin(&text, data, size, false, &ignored)) {
        return true; /* no text, and nothing is known */
    }
    while (text_next_line(&text)) {
        struct word keyword = text_next_word(&text);
        if (word_matches(keyword, "newmtl")) {
            material = find_material(model, text_rest_of_line(&text));
            if (material != NULL) {
                material->known = true;
            }
        } else if (material != NULL && !read_statement(&text, keyword, path, material)) {
            return error_out_of_memory(error);
        }
    }
    return true;
}
