/*
 * The time of a frame: this course's pipeline and Mesa's llvmpipe on the same scenes.
 *
 *     bench-frame [options] [model]     --help prints the options
 *
 * Draws a head in three looks (scene.h), at three sizes, with three numbers of triangles, each side
 * with one thread and with two. A frame is: clear colour and depth, draw, all of it in memory;
 * nothing is read back or saved in that time. The sides take turns, frame by frame, so that what
 * disturbs the machine disturbs all alike. A side draws two frames when it is its turn, and the
 * second one is timed: in between the others have used the caches.
 *
 * Fair: the same mesh with shared vertices, matrix, viewport, culling and 32 bits a pixel, blue
 * first; bilinear samples of the same mip level; what does not change from frame to frame is made
 * ready by both before the clock runs (normals of length 1, buffers, textures). The formulas are the
 * same, with the power 10 written out as products on both sides. llvmpipe's depth is a 32-bit float,
 * and its specular map has one byte a texel.
 *
 * Then both pictures are compared with the exact one (exact.h). Times are only shown: nothing fails
 * because of them.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "child.h"
#include "exact.h"
#include "ours.h"
#include "png.h"

#include "../timing.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

/* ---- Options ---- */

enum { LIST_LIMIT = 8, FRAMES_DEFAULT = 15, FRAMES_LIMIT = 1000, SUBDIVISIONS_LIMIT = 6 };

struct size {
    size_t width, height;
};

struct options {
    const char *model, *directory; /* NULL: no pictures */
    enum frame_look looks[LIST_LIMIT];
    struct size sizes[LIST_LIMIT];
    size_t triangles[LIST_LIMIT]; /* about */
    size_t look_count, size_count, triangle_count, frames;
    enum llvmpipe_filter filter;
    bool help;
};

static const struct options defaults = {
    .model = COURSE_BUILD "/models/bust.obj",
    .looks = {FRAME_FLAT, FRAME_GOURAUD, FRAME_PHONG},
    .look_count = FRAME_LOOKS,
    .sizes = {{800, 800}, {1920, 1080}, {3840, 2160}},
    .size_count = 3,
    .triangles = {2500, 40000, 640000},
    .triangle_count = 3,
    .frames = FRAMES_DEFAULT,
};

static const char help[] =
    "usage: bench-frame [options] [model]\n"
    "\n"
    "The time of a frame: this course's pipeline and, where Mesa is installed, llvmpipe.\n"
    "\n"
    "  --look NAME        only this look: flat, gouraud or phong (may be repeated)\n"
    "  --size WxH         only images of this size (may be repeated)\n"
    "  --triangles N      each face cut into four until there are about N (may be repeated)\n"
    "  --frames N         frames that are timed of each (default 15)\n"
    "  --quick            3 frames at 800x800 of the model as it is\n"
    "  --nearest          llvmpipe takes the nearest texel\n"
    "  -o DIR             save the pictures of both sides there, as PNG\n"
    "  -h, --help         this text\n"
    "\n"
    "The model is an OBJ file, by default the bust; a look whose textures it lacks is left out.\n";

static bool read_number(const char *text, size_t least, size_t most, size_t *number) {
    char *end;
    unsigned long long value = strtoull(text, &end, 10);
    *number = (size_t)value;
    return text[0] >= '0' && text[0] <= '9' && *end == '\0' && value >= least && value <= most;
}

static bool read_size(const char *text, struct size *size) {
    char width[8];
    size_t digits = strcspn(text, "x");
    if (digits >= sizeof width || text[digits] == '\0') {
        return false;
    }
    memcpy(width, text, digits);
    width[digits] = '\0';
    return read_number(width, 1, DRAW_LIMIT, &size->width) &&
           read_number(text + digits + 1, 1, DRAW_LIMIT, &size->height);
}

static bool read_look(const char *text, enum frame_look *look) {
    for (int i = 0; i < FRAME_LOOKS; i++) {
        if (strcmp(text, frame_look_name[i]) == 0) {
            *look = (enum frame_look)i;
            return true;
        }
    }
    return false;
}

/* What was chosen for a list; it replaces the default when it is over. */
struct chosen {
    size_t looks, sizes, triangles;
};

static void be_quick(struct options *o) {
    o->frames = 3;
    o->size_count = o->triangle_count = 1;
}

/* An option with a value. */
static bool read_value(struct options *o, struct chosen *chosen, const char *name,
                       const char *value) {
    if (strcmp(name, "--look") == 0) {
        return chosen->looks < LIST_LIMIT && read_look(value, &o->looks[chosen->looks++]);
    }
    if (strcmp(name, "--size") == 0) {
        return chosen->sizes < LIST_LIMIT && read_size(value, &o->sizes[chosen->sizes++]);
    }
    if (strcmp(name, "--triangles") == 0) {
        return chosen->triangles < LIST_LIMIT &&
               read_number(value, 1, 100000000, &o->triangles[chosen->triangles++]);
    }
    if (strcmp(name, "--frames") == 0) {
        return read_number(value, 1, FRAMES_LIMIT, &o->frames);
    }
    o->directory = value;
    return strcmp(name, "-o") == 0;
}

/* An option without a value, or the model. */
static bool read_flag(struct options *o, const char *name) {
    if (strcmp(name, "--quick") == 0) {
        be_quick(o);
    } else if (strcmp(name, "--nearest") == 0) {
        o->filter = FILTER_NEAREST;
    } else if (strcmp(name, "-h") == 0 || strcmp(name, "--help") == 0) {
        o->help = true;
    } else {
        o->model = name;
        return name[0] != '-';
    }
    return true;
}

static bool takes_value(const char *name) {
    return strcmp(name, "--look") == 0 || strcmp(name, "--size") == 0 ||
           strcmp(name, "--triangles") == 0 || strcmp(name, "--frames") == 0 ||
           strcmp(name, "-o") == 0;
}

static bool read_options(struct options *o, int argc, char **argv, struct error *error) {
    struct chosen chosen = {0, 0, 0};
    *o = defaults;
    for (int i = 1; i < argc; i++) {
        if (!takes_value(argv[i])) {
            if (!read_flag(o, argv[i])) {
                return error_set(error, "there is no option %s", argv[i]);
            }
        } else if (i + 1 == argc) {
            return error_set(error, "%s lacks its value", argv[i]);
        } else if (!read_value(o, &chosen, argv[i], argv[i + 1])) {
            return error_set(error, "%s %s: not understood", argv[i], argv[i + 1]);
        } else {
            i++;
        }
    }
    o->look_count = chosen.looks > 0 ? chosen.looks : o->look_count;
    o->size_count = chosen.sizes > 0 ? chosen.sizes : o->size_count;
    o->triangle_count = chosen.triangles > 0 ? chosen.triangles : o->triangle_count;
    return true;
}

/* ---- Those who draw ---- */

/* In the order of the table; the second two only where Mesa is installed. */
enum side { OURS_1, OURS_2, MESA_1, MESA_2, SIDES };

struct bench {
    struct options options;
    struct frame_model given;             /* as read, with the textures */
    struct frame_model finer[LIST_LIMIT]; /* cut, empty where it need not be */
    struct ours ours[2];                  /* one thread, two */
    struct child mesa[2];
    bool has_mesa;
    void *fill[2]; /* as large as colour and depth of the largest picture */
};

static bool load_side(struct bench *b, enum side side, const struct frame_scene *scene,
                      struct error *error) {
    return side <= OURS_2 ? ours_load(&b->ours[side - OURS_1], scene, side - OURS_1 + 1, error)
                          : child_load(&b->mesa[side - MESA_1], scene, error);
}

/* Two frames, of which the second is timed. */
static bool draw_side(struct bench *b, enum side side, double *seconds, struct error *error) {
    if (side >= MESA_1) {
        return child_draw(&b->mesa[side - MESA_1], seconds, error);
    }
    bool done = ours_draw(&b->ours[side - OURS_1], error);
    double start = now();
    done = done && ours_draw(&b->ours[side - OURS_1], error);
    *seconds = now() - start;
    return done;
}

/* The picture that was drawn last, and NULL where that fails. */
static const uint8_t *read_side(struct bench *b, enum side side, struct error *error) {
    if (side <= OURS_2) {
        return b->ours[side - OURS_1].image.pixels;
    }
    struct child *child = &b->mesa[side - MESA_1];
    return child_read(child, error) ? child->pixels : NULL;
}

/* What it takes to set colour and depth of a picture at all, 4 bytes each. */
static double fill_memory(struct bench *b, const struct frame_scene *scene) {
    double start = 0;
    for (int turn = 0; turn < 2; turn++) {
        start = now();
        for (int i = 0; i < 2; i++) {
            memset(b->fill[i], turn, scene->width * scene->height * 4);
            /* The compiler must not leave out what nobody reads. */
            ((volatile char *)b->fill[i])[scene->width] = 1;
        }
    }
    return now() - start;
}

/* ---- A cell of the table ---- */

struct summary {
    double median, range; /* milliseconds; from the first quartile to the third */
};

struct cell {
    enum frame_look look;
    size_t width, height, faces, visible;
    struct summary sides[SIDES], fill;
    struct deviation deviations[SIDES];
    bool same[2]; /* one thread and two: the same bytes (ours, llvmpipe) */
};

static struct summary summarize(double *seconds, size_t count) {
    sort_doubles(seconds, count);
    return (struct summary){
        .median = 1e3 * quantile(seconds, count, 0.5),
        .range = 1e3 * (quantile(seconds, count, 0.75) - quantile(seconds, count, 0.25)),
    };
}

static size_t side_count(const struct bench *b) {
    return b->has_mesa ? SIDES : MESA_1;
}

/* Rounds in which each side has its turn, each round beginning with another one. */
static bool time_cell(struct bench *b, const struct frame_scene *scene, struct cell *cell,
                      struct error *error) {
    static double seconds[SIDES][FRAMES_LIMIT], fill[FRAMES_LIMIT];
    size_t frames = b->options.frames, sides = side_count(b);
    for (size_t i = 0; i < frames; i++) {
        for (size_t k = 0; k < sides; k++) {
            enum side side = (enum side)((i + k) % sides);
            if (!draw_side(b, side, &seconds[side][i], error)) {
                return false;
            }
        }
        fill[i] = fill_memory(b, scene);
    }
    for (size_t side = 0; side < sides; side++) {
        cell->sides[side] = summarize(seconds[side], frames);
    }
    cell->fill = summarize(fill, frames);
    return true;
}

static bool save_picture(const struct bench *b, const struct cell *cell, const char *side,
                         const uint8_t *pixels, struct error *error) {
    const struct image image = {cell->width, cell->height, IMAGE_BGRA, (uint8_t *)pixels};
    char *path =
        string_format("%s/%s_%zux%zu_%zu_%s.png", b->options.directory, frame_look_name[cell->look],
                      cell->width, cell->height, cell->faces, side);
    bool done = path != NULL ? png_write(&image, path, error) : error_out_of_memory(error);
    free(path);
    return done;
}

static bool save_pictures(const struct bench *b, const struct cell *cell,
                          const uint8_t *const *pictures, struct error *error) {
    return b->options.directory == NULL ||
           (directory_create(b->options.directory, error) &&
            save_picture(b, cell, "ours", pictures[OURS_1], error) &&
            (!b->has_mesa || save_picture(b, cell, "llvmpipe", pictures[MESA_1], error)));
}

static bool judge_cell(struct bench *b, const struct frame_scene *scene, struct cell *cell,
                       struct error *error) {
    const uint8_t *pictures[SIDES];
    size_t bytes = scene->width * scene->height * IMAGE_BGRA;
    struct exact exact;
    for (size_t side = 0; side < side_count(b); side++) {
        pictures[side] = read_side(b, (enum side)side, error);
        if (pictures[side] == NULL) {
            return false;
        }
    }
    bool done = save_pictures(b, cell, pictures, error) && exact_begin(&exact, scene, error);
    if (done) {
        exact_compare(&exact, pictures, side_count(b), cell->deviations);
        cell->visible = exact.visible;
        cell->same[0] = memcmp(pictures[OURS_1], pictures[OURS_2], bytes) == 0;
        cell->same[1] = !b->has_mesa || memcmp(pictures[MESA_1], pictures[MESA_2], bytes) == 0;
    }
    exact_end(&exact);
    return done;
}

static bool measure_cell(struct bench *b, const struct frame_scene *scene, struct cell *cell,
                         struct error *error) {
    bool done = true;
    *cell = (struct cell){.look = scene->look,
                          .width = scene->width,
                          .height = scene->height,
                          .faces = scene->call.model->face_count};
    for (size_t side = 0; done && side < side_count(b); side++) {
        done = load_side(b, (enum side)side, scene, error);
    }
    return done && time_cell(b, scene, cell, error) && judge_cell(b, scene, cell, error);
}

/* ---- The tables ---- */

static void print_scene(const struct cell *cell) {
    char size[32];
    snprintf(size, sizeof size, "%zux%zu", cell->width, cell->height);
    printf("%-8s %-10s %9zu", frame_look_name[cell->look], size, cell->faces);
}

static void print_time_head(const struct bench *b) {
    printf("\nMilliseconds a frame: median of %zu and, in brackets, the middle half of them\n\n",
           b->options.frames);
    printf("%29s | %-45s | %-45s | %-13s |\n", "", "one thread", "two threads", "1 to 2 threads");
    printf("%-8s %-10s %9s | %15s  %15s %11s | %15s  %15s %11s | %6s %7s | %s\n", "look", "size",
           "triangles", "ours", "llvmpipe", "times", "ours", "llvmpipe", "times", "ours", "llvmp.",
           "memset");
}

static void print_pair(struct summary ours, struct summary mesa, bool has_mesa) {
    printf(" | %7.2f (%5.2f)", ours.median, ours.range);
    if (has_mesa) {
        printf("  %7.2f (%5.2f) %11.2f", mesa.median, mesa.range, mesa.median / ours.median);
    } else {
        printf("  %15s %11s", "-", "-");
    }
}

static void print_times(const struct bench *b, const struct cell *cell) {
    const struct summary *s = cell->sides;
    print_scene(cell);
    print_pair(s[OURS_1], s[MESA_1], b->has_mesa);
    print_pair(s[OURS_2], s[MESA_2], b->has_mesa);
    printf(" | %6.2f", s[OURS_1].median / s[OURS_2].median);
    if (b->has_mesa) {
        printf(" %7.2f", s[MESA_1].median / s[MESA_2].median);
    } else {
        printf(" %7s", "-");
    }
    printf(" | %6.2f\n", cell->fill.median);
    fflush(stdout);
}

static void print_error_head(void) {
    printf("\nAgainst the exact answer, in long double: pixels of the outline that differ; of the\n"
           "others, pixels of 1,000 with a level that is not the nearest one; how far the worst\n"
           "level lies beyond the 0.5 of rounding; the mean distance from the nearest level\n\n");
    printf("%29s | %8s | %-33s | %-33s\n", "", "", "ours", "llvmpipe");
    printf("%-8s %-10s %9s | %8s |", "look", "size", "triangles", "pixels");
    for (int i = 0; i < 2; i++) {
        printf(" %7s %9s %7s %7s |", "outline", "of 1,000", "beyond", "mean");
    }
    printf("\n");
}

static void print_deviation(const struct deviation *d) {
    printf(" %7zu %9.3f %7.3f %7.4f |", d->outline,
           1e3 * (double)d->rounded / fmax((double)d->compared, 1), fmax(d->beyond, 0), d->mean);
}

static void print_errors(const struct bench *b, const struct cell *cell) {
    print_scene(cell);
    printf(" | %8zu |", cell->visible);
    print_deviation(&cell->deviations[OURS_1]);
    if (b->has_mesa) {
        print_deviation(&cell->deviations[MESA_1]);
    }
    printf("%s%s\n", cell->same[0] ? "" : " TWO THREADS DRAW ANOTHER PICTURE (ours)",
           cell->same[1] ? "" : " two threads draw another picture (llvmpipe)");
}

/* ---- All cells ---- */

/* The model of the i-th number of triangles. */
static const struct frame_model *head_of(const struct bench *b, size_t i) {
    return b->finer[i].model.face_count > 0 ? &b->finer[i] : &b->given;
}

static bool measure_all(struct bench *b, struct cell *cells, size_t *count, struct error *error) {
    const struct options *o = &b->options;
    for (size_t i = 0; i < o->look_count; i++) {
        if (!frame_look_is_possible(o->looks[i], &b->given.model)) {
            printf("%-8s left out: the model lacks a texture\n", frame_look_name[o->looks[i]]);
            continue;
        }
        for (size_t k = 0; k < o->size_count * o->triangle_count; k++) {
            struct size size = o->sizes[k / o->triangle_count];
            struct frame_scene scene =
                frame_scene(o->looks[i], size.width, size.height, head_of(b, k % o->triangle_count),
                            &b->given.model);
            if (!measure_cell(b, &scene, &cells[*count], error)) {
                return false;
            }
            print_times(b, &cells[(*count)++]);
        }
    }
    return true;
}

static bool print_all(struct bench *b, struct error *error) {
    static struct cell cells[FRAME_LOOKS * LIST_LIMIT * LIST_LIMIT];
    size_t count = 0;
    print_time_head(b);
    bool done = measure_all(b, cells, &count, error);
    if (done) {
        print_error_head();
    }
    for (size_t i = 0; done && i < count; i++) {
        print_errors(b, &cells[i]);
    }
    return done;
}

/* ---- Setting up ---- */

/* How often each face is cut into four, to come nearest to that many. */
static int subdivisions_for(size_t faces, size_t wanted) {
    int times = 0;
    for (double count = (double)faces; times < SUBDIVISIONS_LIMIT && (double)wanted > 2 * count;
         count *= 4) {
        times++;
    }
    return times;
}

static bool read_heads(struct bench *b, struct error *error) {
    if (!frame_model_read(&b->given, b->options.model, error)) {
        return false;
    }
    for (size_t i = 0; i < b->options.triangle_count; i++) {
        int times = subdivisions_for(b->given.model.face_count, b->options.triangles[i]);
        if (times > 0 && !frame_model_subdivide(&b->finer[i], &b->given, times, error)) {
            return false;
        }
    }
    return true;
}

static size_t most_pixels(const struct options *o) {
    size_t most = 0;
    for (size_t i = 0; i < o->size_count; i++) {
        size_t pixels = o->sizes[i].width * o->sizes[i].height;
        most = pixels > most ? pixels : most;
    }
    return most;
}

/* Before any thread is started here, and after all models were read. */
static void start_mesa(struct bench *b) {
    static const int threads[2] = {0, 2}; /* 0: none but the one that calls */
    struct error error;
    b->has_mesa = llvmpipe != NULL;
    for (int i = 0; b->has_mesa && i < 2; i++) {
        b->has_mesa = child_start(&b->mesa[i], threads[i], b->options.filter,
                                  most_pixels(&b->options), &error);
        if (!b->has_mesa) {
            printf("llvmpipe is left out: %s\n", error.message);
        }
    }
    if (b->has_mesa) {
        printf("%s\n", b->mesa[0].name);
    }
}

static bool set_up(struct bench *b, struct error *error) {
    if (!read_heads(b, error)) {
        return false;
    }
    printf("%s, seen from (1,1,3), in the middle square of the image, which is cleared as a "
           "whole\n",
           b->options.model);
    start_mesa(b);
    for (int i = 0; i < 2; i++) {
        b->fill[i] = malloc(4 * most_pixels(&b->options));
        if (b->fill[i] == NULL) {
            return error_out_of_memory(error);
        }
    }
    return true;
}

static void tear_down(struct bench *b) {
    for (int i = 0; i < 2; i++) {
        child_end(&b->mesa[i]);
        ours_free(&b->ours[i]);
        free(b->fill[i]);
    }
    for (size_t i = 0; i < LIST_LIMIT; i++) {
        frame_model_free(&b->finer[i]);
    }
    frame_model_free(&b->given);
}

int main(int argc, char **argv) {
    static struct bench bench;
    struct error error;
    if (!read_options(&bench.options, argc, argv, &error)) {
        fprintf(stderr, "bench-frame: %s\n%s", error.message, help);
        return 2;
    }
    if (bench.options.help) {
        fputs(help, stdout);
        return 0;
    }
    signal(SIGPIPE, SIG_IGN); /* a child that has ended is an error, not our end */
    bool done = set_up(&bench, &error) && print_all(&bench, &error);
    if (!done) {
        fprintf(stderr, "bench-frame: %s\n", error.message);
    }
    tear_down(&bench);
    return done ? 0 : 1;
}
