/* Model files: see model_file.h. */
#include "files/model_file.h"

#include "base/text.h"
#include "files/image_file.h"
#include "files/known.h"
#include "files/obj.h"
#include "files/off.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* ---- Reading ---- */

static bool is_named_off(const char *path) {
    const char *dot = strrchr(path, '.');
    return dot != NULL && (strcmp(dot, ".off") == 0 || strcmp(dot, ".OFF") == 0);
}

/* Say what a file without faces has instead. */
static bool error_no_faces(const char *path, const void *data, size_t size, struct error *error) {
    struct text text;
    struct error ignored;
    double number;
    bool begun = text_begin(&text, data, size, true, &ignored), first = true;
    while (begun && text_next_line(&text)) {
        struct word word = text_next_word(&text);
        if (first && word_to_double(word, &number)) {
            return error_set(error, "begins with a number, as neither OBJ nor OFF does");
        }
        if (word_is(word, "l")) {
            return text_error(error, text.line, "lines and no faces, which only lesson 2 draws");
        }
        first = first && word.length == 0;
    }
    if (is_named_off(path) && !off_recognize(data, size)) {
        return error_set(error, "does not begin with the word OFF");
    }
    return error_set(error, "holds no faces");
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
        (void)(!is_off && error_known_file(error, data, size, "an OBJ or OFF file"));
    }
    return done;
}

const char *model_warning_text(enum model_warning warning) {
    static const char *const texts[] = {
        [MODEL_SHORT_FACES] = "a face of fewer than 3 corners is not drawn",
        [MODEL_UVS_MISSING] = "a face names a texture coordinate that the file does not have",
        [MODEL_NORMALS_MISSING] =
            "a face names a normal that the file does not have; it is computed instead",
        [MODEL_NORMALS_WRONG] = "a normal has no direction; it is computed instead",
    };
    return texts[warning];
}

bool model_decode(struct model *model, const void *data, size_t size, struct error *error) {
    return decode(model, "", data, size, MODEL_ALL_PARTS, error);
}

static bool keep_path(struct model *model, const char *path, struct error *error) {
    model->path = string_format("%s", path);
    if (model->path == NULL) {
        model_free(model);
        return error_out_of_memory(error);
    }
    return true;
}

bool model_read_parts(struct model *model, const char *path, unsigned parts, struct error *error) {
    struct bytes bytes;
    *model = (struct model){0};
    if (!file_read(path, &bytes, error)) {
        return false;
    }
    bool done = decode(model, path, bytes.data, bytes.size, parts, error);
    model->bytes_read = bytes.size;
    bytes_free(&bytes);
    return (done && keep_path(model, path, error)) || error_name_input(error, path);
}

bool model_read(struct model *model, const char *path, struct error *error) {
    return model_read_parts(model, path, MODEL_ALL_PARTS, error);
}

/* ---- Textures ---- */

/* The names that textures have behind that of their model, the one that is looked for first as the
 * first. JPEG is looked for, too, though it cannot be read: its message says what to do. */
static const char *const texture_suffixes[MODEL_TEXTURE_KINDS][4] = {
    [MODEL_DIFFUSE] = {"_diffuse", "_albedo", "_basecolor"},
    [MODEL_NORMAL_MAP] = {"_nm", "_normal"},
    [MODEL_SPECULAR] = {"_spec", "_specular"},
};
static const char *const texture_extensions[] = {"tga", "png", "TGA", "PNG", "Tga",
                                                 "Png", "jpg", "JPG", "jpeg"};

/* "DIRECTORY/NAME" and what follows it for a model at "DIRECTORY/NAME.obj"; the caller frees it. */
static char *texture_path(const char *model_path, const char *suffix, const char *extension) {
    const char *slash = strrchr(model_path, '/');
    const char *name = slash == NULL ? model_path : slash + 1;
    const char *dot = strrchr(name, '.');
    size_t length = dot == NULL || dot == name ? strlen(model_path) : (size_t)(dot - model_path);
    return length > INT_MAX
               ? NULL
               : string_format("%.*s%s.%s", (int)length, model_path, suffix, extension);
}

static bool read_texture(struct texture *texture, const char *path, struct error *error) {
    struct image image;
    if (!image_read(&image, path, error)) {
        return false;
    }
    bool done = texture_create(texture, &image, error) || error_name_file(error, path);
    image_free(&image);
    return done;
}

/* The first name under which there is a file, or the first of all, so that a message can say what
 * was looked for; the caller frees it. NULL when memory runs out. */
static char *find_texture(const char *model_path, enum model_texture_kind kind, bool *found) {
    const char *const *suffixes = texture_suffixes[kind];
    const size_t count = sizeof texture_extensions / sizeof texture_extensions[0];
    *found = false;
    for (size_t i = 0; i < 4 && suffixes[i] != NULL; i++) {
        for (size_t k = 0; k < count; k++) {
            char *path = texture_path(model_path, suffixes[i], texture_extensions[k]);
            *found = path != NULL && file_exists(path);
            if (path == NULL || *found) {
                return path;
            }
            free(path);
        }
    }
    return texture_path(model_path, suffixes[0], texture_extensions[0]);
}

size_t model_textures_present(const struct model *model) {
    size_t present = 0;
    for (int kind = 0; model->path != NULL && kind < MODEL_TEXTURE_KINDS; kind++) {
        bool found;
        free(find_texture(model->path, (enum model_texture_kind)kind, &found));
        present += found;
    }
    return present;
}

const struct texture *model_texture(struct model *model, enum model_texture_kind kind,
                                    struct error *error) {
    struct texture *texture = &model->textures[kind];
    const char *named = model->texture_files[kind];
    if (texture->level_count > 0) {
        return texture;
    }
    if (model->path == NULL) {
        error_set(error, "a model that was not read from a file has no textures");
        return NULL;
    }
    bool found = named != NULL;
    char *path = found ? string_format("%s", named) : find_texture(model->path, kind, &found);
    bool done = false;
    if (path == NULL) {
        error_out_of_memory(error);
    } else if (!found) {
        error_set(error, "no such file, nor one of another usual name");
        error_name_file(error, path);
    } else {
        done = read_texture(texture, path, error);
        model->bytes_read += done ? file_size(path) : 0;
    }
    free(path);
    return done ? texture : NULL;
}
