/* Model files: see model_file.h. */
#include "files/model_file.h"

#include "base/text.h"
#include "files/find.h"
#include "files/fit.h"
#include "files/image_file.h"
#include "files/known.h"
#include "files/mtl.h"
#include "files/obj.h"
#include "files/off.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Reading ---- */

/* Say what a file without faces has instead. */
static bool error_no_faces(const char *path, const void *data, size_t size, struct error *error) {
    static const struct {
        const char *keyword, *what;
    } others[] = {
        {"l", "lines and no faces, which only lesson 2 draws"},
        {"cstype", "curves or surfaces and no faces: export polygons"},
        {"curv", "curves or surfaces and no faces: export polygons"},
        {"surf", "curves or surfaces and no faces: export polygons"},
        {"f", "a face of fewer than 3 corners, and no other"},
        {"p", "points and no faces, which no lesson draws"},
    };
    struct text text;
    double number;
    size_t least = sizeof others / sizeof others[0], line = 0, words = 0; /* where it is first */
    text_peek(&text, data, size);
    while (text_next_line(&text)) {
        struct word word = text_next_word(&text);
        if (word.length > 0 && words++ == 0 && word_to_double(word, &number)) {
            return error_set(error, "begins with a number, as neither OBJ nor OFF does");
        }
        for (size_t i = 0; i < least; i++) {
            if (word_is(word, others[i].keyword)) {
                least = i;
                line = text.line;
            }
        }
    }
    if (line > 0) {
        return text_error(error, line, "%s", others[least].what);
    }
    bool lacks_keyword = name_ends(path, "off") && !off_recognize(data, size);
    return error_set(error, size == 0       ? "is empty"
                            : lacks_keyword ? "does not begin with the word OFF"
                                            : "holds no faces");
}

/* Bytes of a text that others write as UTF-16. False when memory runs out. */
static bool make_utf8(struct bytes *bytes) {
    struct bytes utf8 = {0};
    if (!text_is_utf16(bytes->data, bytes->size)) {
        return true;
    }
    bool done = text_from_utf16(&utf8, bytes->data, bytes->size);
    bytes_free(bytes);
    *bytes = utf8;
    return done;
}

/* The path, which is not read, may tell what the file should be. */
static bool decode(struct model *model, const char *path, const void *data, size_t size,
                   unsigned parts, struct error *error) {
    *model = (struct model){0};
    bool is_off = off_recognize(data, size);
    bool done = is_off ? off_decode(model, data, size, parts, error)
                       : obj_decode(model, data, size, parts, error);
    if (done && model->face_count == 0 && model->line_count == 0) {
        done = error_no_faces(path, data, size, error);
    }
    if (!done) {
        model_free(model);
        (void)(!is_off && known_recognize(data, size, path, true, error));
    }
    return done;
}

const char *model_warning_text(enum model_warning warning) {
    static const char *const texts[] = {
        [MODEL_SHORT_FACES] = "a face of fewer than 3 corners is not drawn",
        [MODEL_UVS_MISSING] =
            "a face names a texture coordinate that the file does not have; it is (0, 0) instead",
        [MODEL_NORMALS_MISSING] =
            "a face names a normal that the file does not have; it is computed instead",
        [MODEL_NORMALS_WRONG] = "a normal has no direction; it is computed instead",
        [MODEL_LIBRARY_MISSING] = "is a file of materials that is not there: none of it is drawn",
        [MODEL_MATERIAL_MISSING] =
            "is a material that no file of them has; its faces are drawn without it",
        [MODEL_GLASSY] = "a material that is transparent in part is drawn opaque",
    };
    return texts[warning];
}

bool model_decode(struct model *model, const void *data, size_t size, struct error *error) {
    return decode(model, "", data, size, MODEL_ALL_PARTS, error);
}

/* ---- Materials ---- */

/* Read a file of materials that the model names. False when memory runs out; sets whether it is
 * there. */
static bool read_library(struct model *model, struct word name, bool *found, struct error *error) {
    char *path = find_named(name, model->path, false, found);
    struct bytes bytes = {0};
    struct error reason = {.message = ""}; /* of a file that cannot be read: it counts as missing */
    *found = *found && file_read(path, &bytes, &reason);
    bool done =
        (path != NULL || name.length == 0) && !error_is_out_of_memory(&reason) &&
        (!*found || (make_utf8(&bytes) && mtl_decode(model, bytes.data, bytes.size, path, error)));
    bytes_free(&bytes);
    free(path);
    return done || error_out_of_memory(error);
}

/* Those that one statement names: a name may hold blanks, or there are several. */
static bool read_line_of_libraries(struct model *model, struct model_library line,
                                   struct error *error) {
    const struct word whole = word_of(line.name);
    struct text text;
    bool found, each, done = read_library(model, whole, &found, error);
    text_peek(&text, whole.start, whole.length);
    for (bool several = !found; done && several && text_find_word(&text); found |= each) {
        done = read_library(model, text_next_word(&text), &each, error);
    }
    if (!found) {
        model_warn(model, MODEL_LIBRARY_MISSING, line.line, line.name);
    }
    return done;
}

/* What programs write for faces that have no material. */
static bool is_name_of_none(const char *name) {
    return name[0] == '\0' || strcmp(name, "None") == 0 || strcmp(name, "(null)") == 0;
}

/* Read all that the model names, if faces have materials; say what is missing. */
static bool read_libraries(struct model *model, struct error *error) {
    bool done = true;
    for (size_t i = 0; done && model->material_count > 0 && i < model->library_count; i++) {
        done = read_line_of_libraries(model, model->libraries[i], error);
    }
    for (size_t i = 0; i < model->material_count; i++) {
        const struct model_material *material = &model->materials[i];
        if (material->glassy && !material->hidden) {
            model_warn(model, MODEL_GLASSY, material->line, NULL);
        }
        if (!material->known && !is_name_of_none(material->name) &&
            model->warning_line[MODEL_LIBRARY_MISSING] == 0) {
            model_warn(model, MODEL_MATERIAL_MISSING, material->line, material->name);
        }
    }
    return done;
}

bool model_read_parts(struct model *model, const char *path, unsigned parts, struct error *error) {
    struct bytes bytes;
    *model = (struct model){0};
    if (!file_read(path, &bytes, error)) {
        return false;
    }
    bool done = make_utf8(&bytes) ? decode(model, path, bytes.data, bytes.size, parts, error)
                                  : error_out_of_memory(error);
    bytes_free(&bytes);
    model->path = done ? string_format("%s", path) : NULL;
    done = done && (model->path != NULL || error_out_of_memory(error));
    model->level_limit = (parts & MODEL_LEVELS) == 0;
    if (done && ((parts & (MODEL_UVS | MODEL_MATERIALS)) == 0 || read_libraries(model, error))) {
        return true;
    }
    model_free(model);
    return error_name_input(error, path);
}

bool model_read(struct model *model, const char *path, struct error *error) {
    return model_read_parts(model, path, MODEL_ALL_PARTS, error);
}

/* ---- Textures ---- */

/* What follows the model's name in the name of a texture, in the order of search. JPEG is looked
 * for, too, though it cannot be read: its message says what to do. */
static const char *const texture_suffixes[MODEL_TEXTURE_KINDS][4] = {
    [MODEL_DIFFUSE] = {"_diffuse", "_albedo", "_basecolor"},
    [MODEL_NORMAL_MAP] = {"_nm", "_normal", "_nm_tangent", "_normal_tangent"},
    [MODEL_SPECULAR] = {"_spec", "_specular"},
};
static const char *const texture_extensions[] = {"tga", "png", "ppm", "pgm", "jpg", "jpeg"};

enum {
    EXTENSIONS = sizeof texture_extensions / sizeof texture_extensions[0],
    SUFFIXES = sizeof texture_suffixes[0] / sizeof texture_suffixes[0][0]
};

/* Turn the normals that a picture holds, as levels (coordinate + 1) * 127.5. */
static void turn_normals(struct image *image, const int turns[3]) {
    for (size_t i = 0; i < image->width * image->height; i++) {
        const int x = (int)(i % image->width), y = (int)(i / image->width);
        struct color c = image_get(image, x, y);
        struct vec3 n = {c.r - 127.5, c.g - 127.5, c.b - 127.5};
        n = vec3_quarter_turned(n, turns);
        c.r = (uint8_t)(n.x + 127.5);
        c.g = (uint8_t)(n.y + 127.5);
        c.b = (uint8_t)(n.z + 127.5);
        image_set(image, x, y, c);
    }
}

static bool make_texture(struct texture *texture, struct image *image, const char *path,
                         size_t level_limit, struct error *error) {
    bool done =
        texture_create_levels(texture, image, level_limit, error) || error_name_file(error, path);
    image_free(image);
    return done;
}

bool model_read_texture(struct texture *texture, const char *path, size_t level_limit,
                        struct error *error) {
    struct image image;
    return image_read(&image, path, error) &&
           make_texture(texture, &image, path, level_limit, error);
}

/* Does a picture look like one of normals, at some of its pixels? All have a length of about 1:
 * what is far from it is a background, and what is so in the mean is something else; heights are
 * grey. In tangent space nearly all are about (0, 0, 1), while those of an object go all around. */
static bool check_normals(const struct image *image, bool *looks_tangent, struct error *error) {
    const int across = (int)image->width / 32 + 1, along = (int)image->height / 32 + 1;
    struct vec3 sum = {0, 0, 0};
    double count = 0, length_sum = 0;
    bool grey = true;
    for (int y = 0; y < (int)image->height; y += along) {
        for (int x = 0; x < (int)image->width; x += across) {
            struct color c = image_get(image, x, y);
            struct vec3 n = {c.r / 127.5 - 1, c.g / 127.5 - 1, c.b / 127.5 - 1};
            double length = vec3_length(n);
            grey = grey && c.r == c.g && c.g == c.b;
            if (length > 0.4 && length < 1.6) {
                sum = vec3_add(sum, n);
                length_sum += length;
                count++;
            }
        }
    }
    bool of_length_1 = length_sum >= 0.85 * count && length_sum <= 1.15 * count;
    *looks_tangent = sum.z > 0.7 * count && fabs(sum.x) < 0.3 * count && fabs(sum.y) < 0.3 * count;
    return (!grey && of_length_1) ||
           error_set(error, grey ? "grey values: perhaps heights, but not normals"
                                 : "no normals, whose values would have length 1");
}

bool model_read_normal_map(struct texture *texture, const char *path, const int turns[3],
                           struct error *error) {
    const char *slash = strrchr(path, '/');
    bool named = strstr(slash == NULL ? path : slash, "_tangent.") != NULL, looks_tangent;
    struct image image;
    if (!image_read(&image, path, error)) {
        return false;
    }
    if (!check_normals(&image, &looks_tangent, error)) {
        image_free(&image);
        return error_name_file(error, path);
    }
    if (!named && !looks_tangent && (turns[0] != 0 || turns[1] != 0 || turns[2] != 0)) {
        turn_normals(&image, turns);
    }
    bool done = make_texture(texture, &image, path, 0, error);
    texture->tangent_space = named || looks_tangent;
    texture->space_guessed = !named && looks_tangent;
    return done;
}

char *model_find_texture(const struct model *model, enum model_texture_kind kind, bool *found) {
    const char *chosen = model->texture_files[kind], *name = model->path;
    const struct word ending = name_ending(word_of(name));
    const int stem = (int)(ending.start - name) - (ending.length > 0);
    char *path = chosen != NULL ? string_format("%s", chosen) : NULL;
    *found = chosen != NULL;
    for (size_t i = 0; !*found && i <= SUFFIXES * EXTENSIONS; i++) { /* at last the first again */
        const char *suffix = texture_suffixes[kind][i / EXTENSIONS % SUFFIXES];
        if (suffix == NULL) {
            continue;
        }
        free(path);
        path = string_format("%.*s%s.%s", stem, name, suffix, texture_extensions[i % EXTENSIONS]);
        if (path == NULL) {
            return NULL;
        }
        *found = i < SUFFIXES * EXTENSIONS && file_find(path);
    }
    return path;
}

size_t model_textures_present(const struct model *model) {
    size_t present = 0;
    for (int kind = 0; model->path != NULL && kind < MODEL_TEXTURE_KINDS; kind++) {
        bool found;
        free(model_find_texture(model, (enum model_texture_kind)kind, &found));
        present += found;
    }
    return present;
}

const struct texture *model_texture(struct model *model, enum model_texture_kind kind,
                                    struct error *error) {
    struct texture *texture = &model->textures[kind];
    if (texture->level_count > 0) {
        return texture;
    }
    if (model->path == NULL) {
        error_set(error, "a model that was not read from a file has no textures");
        return NULL;
    }
    bool found, done = false;
    char *path = model_find_texture(model, kind, &found);
    if (path == NULL) {
        error_out_of_memory(error);
    } else if (!found) {
        error_set(error, "no such file, nor one of another usual name");
        error_name_file(error, path);
    } else {
        done = kind == MODEL_NORMAL_MAP
                   ? model_read_normal_map(texture, path, model->turns, error)
                   : model_read_texture(texture, path, model->level_limit, error);
    }
    free(path);
    return done ? texture : NULL;
}

bool model_has_materials(const struct model *model) {
    bool known = false, textured = false, beside = false;
    for (size_t i = 0; i < model->material_count; i++) {
        known = known || model->materials[i].known;
        textured = textured || model->materials[i].texture != NULL;
    }
    if (known && !textured && model->uv_count > 0 && model->path != NULL) {
        free(model_find_texture(model, MODEL_DIFFUSE, &beside));
    }
    return known && !beside;
}
