/*
 * How fast files are read and written: `make bench-files` prints the median of many rounds, in
 * which all rows take their turn, and the quartiles. What is read is the course's model, many times
 * over in one file, with its textures, and some of the pictures that the lessons draw. The rows
 * `bytes alone` read or write the same bytes and do nothing else, as cat does: nobody is faster.
 *
 * BENCH_SECONDS in the environment: for the whole, 20 where it is not set.
 */
#include "base/file.h"
#include "bench/measure.h"
#include "files/image_file.h"
#include "files/model_file.h"
#include "files/png.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is done with the files of a group, one after the other. */
enum { READ, READ_BYTES, WRITE, WRITE_BYTES, WORKS };

enum { OBJ, TEXTURES, TGA, PNG, GROUPS };
enum { FILES_LIMIT = 4, OBJ_BYTES = 15000000 /* of the model's file, at least */ };

/* The names of what is read first, below the build directory. */
static const char *const names[GROUPS][FILES_LIMIT] = {
    [OBJ] = {"models/bust.obj"},
    [TEXTURES] = {"models/bust_diffuse.tga", "models/bust_nm.tga", "models/bust_spec.tga"},
    [TGA] = {"out/step04_flat/flat.tga", "out/step06_texture/texture.tga",
             "out/step07_gouraud/gouraud.tga", "out/step10_phong/four.tga"},
    [PNG] = {"out/step04_flat/flat.tga", "out/step06_texture/texture.tga",
             "out/step07_gouraud/gouraud.tga", "out/step10_phong/four.tga"},
};

struct file {
    struct bytes bytes;
    struct image image;
    char path[32]; /* below the build directory */
};

struct files {
    struct file file[GROUPS][FILES_LIMIT];
};

/* All that is measured has been done once before; what fails now makes the figures worthless. */
static void must(bool done, const struct error *error) {
    if (!done) {
        fprintf(stderr, "bench-files: %s\n", error->message);
        exit(1);
    }
}

/* ---- The work ---- */

static void path_of(const char *name, char path[1024]) {
    snprintf(path, 1024, "%s/%s", COURSE_BUILD, name);
}

static void read_file(const struct file *file, int group) {
    struct error error;
    struct model model = {0};
    struct image image = {0};
    must(group == OBJ ? model_decode(&model, file->bytes.data, file->bytes.size, &error)
                      : image_decode(&image, file->bytes.data, file->bytes.size, &error),
         &error);
    model_free(&model);
    image_free(&image);
}

static void write_file(const struct file *file, int group) {
    struct error error;
    struct bytes out = {0};
    must(group == PNG ? png_encode(&file->image, &out, &error)
                      : tga_encode(&file->image, &out, &error),
         &error);
    bytes_free(&out);
}

static void copy_bytes(const struct file *file, bool writes) {
    struct error error;
    struct bytes bytes = {0};
    char path[1024];
    path_of(file->path, path);
    must(writes ? file_write(path, file->bytes.data, file->bytes.size, &error)
                : file_read(path, &bytes, &error),
         &error);
    bytes_free(&bytes);
}

static void run(void *state, int choice) {
    const struct files *files = state;
    int group = choice / WORKS, work = choice % WORKS;
    for (int i = 0; i < FILES_LIMIT && names[group][i] != NULL; i++) {
        const struct file *file = &files->file[group][i];
        if (work == READ) {
            read_file(file, group);
        } else if (work == WRITE) {
            write_file(file, group);
        } else {
            copy_bytes(file, work == WRITE_BYTES);
        }
    }
}

/* Instead of an error: the bytes of text, or of pixels as they lie in memory. */
static double bytes_of(void *state, int choice) {
    const struct files *files = state;
    double sum = 0;
    for (int i = 0; i < FILES_LIMIT; i++) {
        const struct file *file = &files->file[choice / WORKS][i];
        size_t pixels = file->image.width * file->image.height * (size_t)file->image.format;
        sum += (double)(pixels > 0 ? pixels : file->bytes.size);
    }
    return sum;
}

/* ---- What is read and written ---- */

/* The model's text again and again: more faces of the same corners. */
static void repeat_text(struct bytes *text, struct error *error) {
    size_t size = text->size;
    char *once = malloc(size);
    if (once != NULL) {
        memcpy(once, text->data, size);
    }
    must(once != NULL || error_out_of_memory(error), error);
    while (text->size < OBJ_BYTES) {
        must(bytes_append(text, once, size) || error_out_of_memory(error), error);
    }
    free(once);
}

static void load(struct file *file, int group, const char *name) {
    struct error error;
    char path[1024];
    path_of(name, path);
    must(file_read(path, &file->bytes, &error), &error);
    if (group == OBJ) {
        repeat_text(&file->bytes, &error);
        return;
    }
    must(image_decode(&file->image, file->bytes.data, file->bytes.size, &error), &error);
    if (group == PNG) {
        file->bytes.size = 0;
        must(png_encode(&file->image, &file->bytes, &error), &error);
    }
}

/* All of them also as files, for reading and writing bytes alone. */
static bool setup(void *state, struct error *error) {
    struct files *files = state;
    char path[1024];
    path_of("files", path);
    must(directory_create(path, error), error);
    for (int i = 0; i < GROUPS * FILES_LIMIT; i++) {
        struct file *file = &files->file[i / FILES_LIMIT][i % FILES_LIMIT];
        if (names[i / FILES_LIMIT][i % FILES_LIMIT] != NULL) {
            load(file, i / FILES_LIMIT, names[i / FILES_LIMIT][i % FILES_LIMIT]);
            snprintf(file->path, sizeof file->path, "files/%d", i);
            copy_bytes(file, true);
        }
    }
    return true;
}

static void teardown(void *state) {
    struct files *files = state;
    for (int i = 0; i < GROUPS * FILES_LIMIT; i++) {
        struct file *file = &files->file[i / FILES_LIMIT][i % FILES_LIMIT];
        bytes_free(&file->bytes);
        image_free(&file->image);
    }
}

/* ---- The program ---- */

#define ROWS(group)                                                                                \
    VERSION("read", (group)*WORKS + READ), VERSION("bytes alone", (group)*WORKS + READ_BYTES)
#define WRITTEN(group)                                                                             \
    ROWS(group), VERSION("write", (group)*WORKS + WRITE),                                          \
        VERSION("bytes alone", (group)*WORKS + WRITE_BYTES)

static const struct bench_version obj_rows[] = {ROWS(OBJ)}, texture_rows[] = {ROWS(TEXTURES)};
static const struct bench_version tga_rows[] = {WRITTEN(TGA)}, png_rows[] = {WRITTEN(PNG)};

#define GROUP(heading, rows)                                                                       \
    { .title = (heading), BENCH_VERSIONS(rows), .run = run, .error = bytes_of }

static const struct bench_panel groups[GROUPS] = {
    GROUP("OBJ", obj_rows),
    GROUP("TGA, three textures of 1024x1024", texture_rows),
    GROUP("TGA, four pictures of 800x800", tga_rows),
    GROUP("PNG, four pictures of 800x800", png_rows),
};

static const struct bench_lesson lesson = {.title = "Files",
                                           .state_size = sizeof(struct files),
                                           .setup = setup,
                                           .teardown = teardown,
                                           .panels = groups,
                                           .panel_count = GROUPS};

int main(void) {
    struct bench_results results;
    struct error error;
    const char *wanted = getenv("BENCH_SECONDS");
    if (!bench_measure(&lesson, wanted != NULL ? strtod(wanted, NULL) : 20, &results, &error)) {
        fprintf(stderr, "bench-files: %s\n", error.message);
        return 1;
    }
    printf("%-16s%9s %9s %9s %9s\n", "", "ms", "quartile", "quartile", "MB/s");
    for (size_t i = 0; i < GROUPS; i++) {
        printf("%s\n", groups[i].title);
        for (size_t k = 0; k < groups[i].version_count; k++) {
            const struct bench_result *r = &results.of[i][k];
            printf("  %-14s%9.2f %9.2f %9.2f %9.0f\n", groups[i].versions[k].name, r->median,
                   r->lower, r->upper, r->error / r->median / 1000);
        }
    }
    printf("MB/s: of text, or of pixels as they lie in memory.\n");
    return 0;
}
