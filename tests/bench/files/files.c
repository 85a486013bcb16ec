/*
 * How fast files are read and written, and what is done with pictures in between: `make
 * bench-files` prints the median of many rounds, in which all rows of a group take their turn, and
 * the quartiles. What is read is the course's model, many times over in one file, with its
 * textures, and some of the pictures that the lessons draw. PNG is compared with libpng, where that
 * was installed when this was compiled; and all files with reading and writing their bytes and
 * nothing else, as cat does: no program is faster.
 *
 * BENCH_SECONDS in the environment: for the whole, 20 where it is not set.
 */
#include "base/file.h"
#include "bench/report.h"
#include "check/compare.h"
#include "files/image_file.h"
#include "files/model_file.h"
#include "files/png.h"
#include "libpng.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define LENGTH(array) (sizeof(array) / sizeof((array)[0]))

static const char *const texture_names[] = {"models/bust_diffuse.tga", "models/bust_nm.tga",
                                            "models/bust_spec.tga"};
static const char *const picture_names[] = {
    "out/step04_flat/flat.tga", "out/step06_texture/texture.tga", "out/step07_gouraud/gouraud.tga",
    "out/step10_phong/four.tga"};

enum { TEXTURES = LENGTH(texture_names), PICTURES = LENGTH(picture_names) };
enum { OBJ_BYTES = 15000000 }; /* of the model's file, at least */

/* The files: one of the model, one of each texture, two of each picture. */
enum { OBJ, TEXTURE, TGA = TEXTURE + TEXTURES, PNG = TGA + PICTURES, FILES = PNG + PICTURES };
enum { BY_LIBPNG = FILES }; /* added to the file where libpng does the work */

struct files {
    struct {
        struct bytes bytes;
        char *path;
    } file[FILES];
    struct image images[FILES]; /* of those that are images */
    struct image noise;         /* as large as a picture, and without any likeness to it */
    size_t size;                /* of the files that the last run has read or written */
    struct error error;
};

/* ---- The work. `first` is the file, or the first of the pictures. ---- */

/* Pictures are read and written one after the other. */
static int file_count(int first) {
    return first == TGA || first == PNG ? PICTURES : 1;
}

/* All that is measured has been done once before; what fails now makes the figures worthless. */
static void must(bool done, const struct error *error) {
    if (!done) {
        fprintf(stderr, "bench-files: %s\n", error->message);
        exit(1);
    }
}

static void read_model(void *state, int file) {
    struct files *files = state;
    const struct bytes *bytes = &files->file[file].bytes;
    struct model model;
    must(model_decode(&model, bytes->data, bytes->size, &files->error), &files->error);
    model_free(&model);
    files->size = bytes->size;
}

typedef bool decode_function(struct image *image, const void *data, size_t size,
                             struct error *error);

static void decode_all(struct files *files, int first, decode_function *decode) {
    files->size = 0;
    for (int i = first; i < first + file_count(first); i++) {
        const struct bytes *bytes = &files->file[i].bytes;
        struct image image;
        must(decode(&image, bytes->data, bytes->size, &files->error), &files->error);
        image_free(&image);
        files->size += bytes->size;
    }
}

static void read_images(void *state, int first) {
    decode_all(state, first, image_decode);
}

static void read_by_libpng(void *state, int choice) {
    if (libpng_version != NULL) {
        decode_all(state, choice - BY_LIBPNG, libpng_decode);
    }
}

typedef bool encode_function(const struct image *image, struct bytes *out, struct error *error);

static void encode_all(struct files *files, int first, encode_function *encode) {
    files->size = 0;
    for (int i = first; i < first + file_count(first); i++) {
        struct bytes out = {0};
        must(encode(&files->images[i], &out, &files->error), &files->error);
        files->size += out.size;
        bytes_free(&out);
    }
}

static bool encode_tga(const struct image *image, struct bytes *out, struct error *error) {
    return tga_encode(image, out, error);
}

static void write_tga(void *state, int first) {
    encode_all(state, first, encode_tga);
}

static void write_png(void *state, int first) {
    encode_all(state, first, png_encode);
}

static void write_by_libpng(void *state, int choice) {
    if (libpng_version != NULL) {
        encode_all(state, choice - BY_LIBPNG, libpng_encode);
    }
}

static void write_quickly_by_libpng(void *state, int choice) {
    if (libpng_version != NULL) {
        encode_all(state, choice - BY_LIBPNG, libpng_encode_quickly);
    }
}

static void read_bytes(void *state, int first) {
    struct files *files = state;
    files->size = 0;
    for (int i = first; i < first + file_count(first); i++) {
        struct bytes bytes;
        must(file_read(files->file[i].path, &bytes, &files->error), &files->error);
        files->size += bytes.size;
        bytes_free(&bytes);
    }
}

static void write_bytes(void *state, int first) {
    struct files *files = state;
    files->size = 0;
    for (int i = first; i < first + file_count(first); i++) {
        const struct bytes *bytes = &files->file[i].bytes;
        must(file_write(files->file[i].path, bytes->data, bytes->size, &files->error),
             &files->error);
        files->size += bytes->size;
    }
}

static void make_texture(void *state, int file) {
    struct files *files = state;
    struct texture texture;
    must(texture_create(&texture, &files->images[file], &files->error), &files->error);
    texture_free(&texture);
    files->size = 0;
}

/* By the rule of `make check`. */
static void compare_equal(void *state, int file) {
    struct files *files = state;
    const struct image *picture = &files->images[file];
    error_set(&files->error, "the rule finds a difference where there is none");
    must(compare_images(picture, picture).wrong.count == 0, &files->error);
    files->size = 0;
}

static void compare_noise(void *state, int file) {
    struct files *files = state;
    struct comparison found = compare_images(&files->images[file], &files->noise);
    error_set(&files->error, "the rule finds noise like a picture");
    must(found.wrong.count > found.drawn / 2, &files->error);
    files->size = 0;
}

/* Not a number where libpng is wanted and missing. */
static double size_of_files(void *state, int choice) {
    const struct files *files = state;
    return choice >= BY_LIBPNG && libpng_version == NULL ? NAN : (double)files->size;
}

/* The bytes of text or of pixels. */
static double work_of(const void *state, int choice) {
    const struct files *files = state;
    const int first = choice % FILES;
    double sum = first == OBJ ? (double)files->file[OBJ].bytes.size : 0;
    for (int i = first; i < first + file_count(first); i++) {
        const struct image *image = &files->images[i];
        sum += (double)(image->width * image->height * (size_t)image->format);
    }
    return sum;
}

/* ---- What is measured ---- */

#define GROUP(heading, rows)                                                                       \
    { .title = (heading), BENCH_VERSIONS(rows), .error = size_of_files, .size = work_of }
#define ROW(label, file, how)                                                                      \
    { .name = (label), .choice = (file), .run = (how) }
#define LIBPNG(label, file, how) ROW(label, (file) + BY_LIBPNG, how)

static const struct bench_version model_rows[] = {
    ROW("read", OBJ, read_model),
    ROW("bytes alone", OBJ, read_bytes),
};
static const struct bench_version texture_rows[] = {
    ROW("read colours", TEXTURE, read_images),
    ROW("bytes alone", TEXTURE, read_bytes),
    ROW("read normals", TEXTURE + 1, read_images),
    ROW("bytes alone", TEXTURE + 1, read_bytes),
    ROW("read grey", TEXTURE + 2, read_images),
    ROW("bytes alone", TEXTURE + 2, read_bytes),
    ROW("colours to mip levels", TEXTURE, make_texture),
};
static const struct bench_version tga_rows[] = {
    ROW("read", TGA, read_images),
    ROW("bytes alone", TGA, read_bytes),
    ROW("write", TGA, write_tga),
    ROW("bytes alone", TGA, write_bytes),
};
static const struct bench_version png_rows[] = {
    ROW("read", PNG, read_images),          LIBPNG("libpng", PNG, read_by_libpng),
    ROW("bytes alone", PNG, read_bytes),    ROW("write", PNG, write_png),
    LIBPNG("libpng", PNG, write_by_libpng), LIBPNG("libpng, level 1", PNG, write_quickly_by_libpng),
    ROW("bytes alone", PNG, write_bytes),
};
static const struct bench_version check_rows[] = {
    ROW("equal", PNG - 1, compare_equal),
    ROW("all wrong", PNG - 1, compare_noise),
};
static const struct bench_panel groups[] = {
    GROUP("OBJ", model_rows),
    GROUP("TGA, textures of 1024x1024", texture_rows),
    GROUP("TGA, pictures of 800x800", tga_rows),
    GROUP("PNG, pictures of 800x800", png_rows),
    GROUP("make check, the rule, 800x800", check_rows),
};

/* ---- What is read and written ---- */

/* One more copy of the model at the end of the text, whose faces name its own corners. */
static void append_model(struct files *files, const struct model *model, size_t copy) {
    struct bytes *text = &files->file[OBJ].bytes;
    struct error *error = &files->error;
    size_t position = 1 + copy * model->position_count, uv = 1 + copy * model->uv_count;
    size_t normal = 1 + copy * model->normal_count;
    for (size_t i = 0; i < model->position_count; i++) {
        struct vec3 p = model->positions[i];
        must(report_append(text, error, "v %.6f %.6f %.6f\n", p.x, p.y, p.z), error);
    }
    for (size_t i = 0; i < model->uv_count; i++) {
        const float *p = model->uvs[i];
        must(report_append(text, error, "vt %.6f %.6f\n", p[0], p[1]), error);
    }
    for (size_t i = 0; i < model->normal_count; i++) {
        const float *n = model->normals[i];
        must(report_append(text, error, "vn %.6f %.6f %.6f\n", n[0], n[1], n[2]), error);
    }
    for (size_t i = 0; i < model->face_count; i++) {
        const struct corner *c = model->faces[i].corner;
        must(report_append(text, error, "f %zu/%zu/%zu %zu/%zu/%zu %zu/%zu/%zu\n",
                           position + c[0].position, uv + c[0].uv, normal + c[0].normal,
                           position + c[1].position, uv + c[1].uv, normal + c[1].normal,
                           position + c[2].position, uv + c[2].uv, normal + c[2].normal),
             error);
    }
}

static char *course_path(const char *name) {
    static const struct error no_memory = {.message = "out of memory"};
    char *path = string_format("%s/%s", COURSE_BUILD, name);
    must(path != NULL, &no_memory);
    return path;
}

static void make_model(struct files *files) {
    struct model model;
    char *path = course_path("models/bust.obj");
    must(model_read(&model, path, &files->error), &files->error);
    for (size_t copy = 0; files->file[OBJ].bytes.size < OBJ_BYTES; copy++) {
        append_model(files, &model, copy);
    }
    model_free(&model);
    free(path);
}

/* The image of that name, its file's bytes where they are wanted. */
static void load_image(struct files *files, int file, const char *name) {
    struct bytes *bytes = &files->file[file].bytes;
    char *path = course_path(name);
    must(file_read(path, bytes, &files->error), &files->error);
    must(image_decode(&files->images[file], bytes->data, bytes->size, &files->error),
         &files->error);
    free(path);
}

static void load_images(struct files *files) {
    for (int i = 0; i < TEXTURES; i++) {
        load_image(files, TEXTURE + i, texture_names[i]);
    }
    for (int i = 0; i < PICTURES; i++) {
        load_image(files, TGA + i, picture_names[i]);
        load_image(files, PNG + i, picture_names[i]);
        files->file[PNG + i].bytes.size = 0;
        must(png_encode(&files->images[PNG + i], &files->file[PNG + i].bytes, &files->error),
             &files->error);
    }
}

static void make_noise(struct files *files) {
    struct image *noise = &files->noise;
    uint32_t random = 1;
    const struct image *like = &files->images[PNG];
    must(image_create(noise, like->width, like->height, like->format, &files->error),
         &files->error);
    for (size_t i = 0; i < noise->width * noise->height * (size_t)noise->format; i++) {
        random = random * 1664525u + 1013904223u;
        noise->pixels[i] = (uint8_t)(random >> 24);
    }
}

/* All of them in files, for who reads and writes no more than bytes. */
static void save(struct files *files) {
    char *directory = course_path("files");
    must(directory_create(directory, &files->error), &files->error);
    for (int i = 0; i < FILES; i++) {
        const struct bytes *bytes = &files->file[i].bytes;
        files->file[i].path = string_format("%s/%d", directory, i);
        error_out_of_memory(&files->error);
        must(files->file[i].path != NULL, &files->error);
        must(file_write(files->file[i].path, bytes->data, bytes->size, &files->error),
             &files->error);
    }
    free(directory);
}

static bool setup(void *state, struct error *error) {
    struct files *files = state;
    (void)error;
    make_model(files);
    load_images(files);
    make_noise(files);
    save(files);
    return true;
}

static void teardown(void *state) {
    struct files *files = state;
    for (int i = 0; i < FILES; i++) {
        bytes_free(&files->file[i].bytes);
        image_free(&files->images[i]);
        free(files->file[i].path);
    }
    image_free(&files->noise);
}

/* ---- The program ---- */

static const struct bench_lesson lesson = {.step = "files",
                                           .title = "Files",
                                           .state_size = sizeof(struct files),
                                           .setup = setup,
                                           .teardown = teardown,
                                           .panels = groups,
                                           .panel_count = LENGTH(groups)};

static void print_row(const struct bench_version *row, const struct bench_result *result) {
    const int files = file_count(row->choice % FILES);
    printf("  %-24s", row->name);
    if (isnan(result->error)) {
        printf(" not installed; on Debian: apt-get install libpng-dev\n");
        return;
    }
    printf("%9.2f %9.2f %9.2f %9.0f", result->median / files, result->lower / files,
           result->upper / files, result->size / result->median / 1000);
    printf(result->error > 0 ? " %12.0f\n" : "\n", result->error / files);
}

int main(void) {
    struct bench_results results;
    struct error error;
    const char *wanted = getenv("BENCH_SECONDS");
    double seconds = wanted != NULL ? strtod(wanted, NULL) : 20;
    if (!bench_measure(&lesson, seconds, &results, &error)) {
        fprintf(stderr, "bench-files: %s\n", error.message);
        return 1;
    }
    printf("%-26s%9s %9s %9s %9s %12s\n", "one file", "ms", "quartile", "quartile", "MB/s",
           "bytes of it");
    for (size_t i = 0; i < LENGTH(groups); i++) {
        printf("%s\n", groups[i].title);
        for (size_t k = 0; k < groups[i].version_count; k++) {
            print_row(&groups[i].versions[k], &results.of[i][k]);
        }
    }
    printf("MB/s: of text, or of pixels as they lie in memory. ");
    printf("libpng: %s.\n", libpng_version != NULL ? libpng_version : "none");
    return 0;
}
