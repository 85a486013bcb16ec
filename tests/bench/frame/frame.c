/*
 * The time of a frame: this course's pipeline and Mesa's llvmpipe on the same scenes.
 *
 *     bench-frame [options] [model]     --help prints the options
 *
 * Draws a head in three looks (scene.h), at three sizes, with three numbers of triangles. A frame
 * is: clear colour and depth, draw, all of it in memory; nothing is read back or saved in that
 * time. The sides take turns, so that what disturbs the machine disturbs both alike. A side draws
 * two frames when it is its turn, and the second one is timed: before, the other has used the
 * caches. What counts is the smaller of the time on the wall and that of all threads together, so
 * that other programs disturb little.
 *
 * Fair: the same mesh with shared vertices, matrix, viewport and culling, 32 bits a pixel with blue
 * first, bilinear samples of the same mip level. What does not change from frame to frame is made
 * ready by both before the clock runs (normals of length 1, buffers, textures). The formulas are
 * the same, with the power 10 written out as products on both sides. llvmpipe's depth is a 32-bit
 * float and its specular map has one byte a texel; other formats were no faster. Both clear the
 * whole image before each frame. (One thing is not equal: this course asks for large pages of
 * memory, which Mesa does not; see large_pages.h.)
 *
 * Then both pictures are compared with the exact one (exact.h). Times are only shown: nothing fails
 * because of them.
 */
#define _DEFAULT_SOURCE /* clock_gettime, getloadavg */
#include "exact.h"
#include "llvmpipe.h"
#include "ours.h"
#include "skipping.h"
#include "table.h"

#include "bench/memory.h"
#include "bench/timing.h"
#include "check/arguments.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is measured, and only the first of both where it must be quick: sizes of the image, and
 * about how many triangles. */
enum { STEPS = 3 };
static const size_t widths[STEPS] = {800, 1920, 3840}, heights[STEPS] = {800, 1080, 2160};
static const size_t triangles[STEPS] = {2500, 40000, 640000};

enum { THREADS_LIMIT = 16 };

struct options {
    const char *model;
    enum frame_look look; /* this one alone; FRAME_LOOKS: all */
    size_t frames;        /* timed of each, 1..FRAMES_LIMIT */
    size_t threads;       /* that draw, on both sides, 1..THREADS_LIMIT */
    bool quick;           /* at the first size, of the model as it is */
    bool skipping;        /* measure only what shortcuts are worth */
    bool help;            /* nothing but that */
};

struct bench {
    struct options options;
    struct frame_model heads[STEPS]; /* one for each number of triangles */
    struct ours ours;
    struct llvmpipe *mesa; /* NULL where it cannot draw */
    double seconds[SIDES][FRAMES_LIMIT];
    struct table table;
};

/* ---- Those who draw ---- */

static size_t side_count(const struct bench *b) {
    return b->table.has_mesa ? SIDES : MESA;
}

static bool load_sides(struct bench *b, const struct frame_scene *scene, struct error *error) {
    return ours_load(&b->ours, scene, b->options.threads, error) &&
           (b->mesa == NULL || llvmpipe->load(b->mesa, scene, error));
}

static bool draw_side(struct bench *b, size_t side, struct error *error) {
    if (side == OURS) {
        return ours_draw(&b->ours, error);
    }
    llvmpipe->draw(b->mesa);
    return true;
}

/* Two frames, of which the second is timed. */
static bool time_side(struct bench *b, size_t side, double *seconds, struct error *error) {
    bool done = draw_side(b, side, error);
    struct stopwatch start = stopwatch_start();
    done = done && draw_side(b, side, error);
    *seconds = stopwatch_seconds(start);
    return done;
}

/* ---- A cell of the table ---- */

static struct summary summarize(const struct bench *b, double *seconds) {
    size_t count = b->options.frames;
    sort_doubles(seconds, count);
    return (struct summary){
        .median = 1e3 * quantile(seconds, count, 0.5),
        .range = 1e3 * (quantile(seconds, count, 0.75) - quantile(seconds, count, 0.25)),
    };
}

/* Rounds in which each side has its turn, each round beginning with another one. */
static bool time_cell(struct bench *b, struct cell *cell, struct error *error) {
    size_t sides = side_count(b);
    for (size_t i = 0; i < b->options.frames; i++) {
        for (size_t k = 0; k < sides; k++) {
            size_t side = (i + k) % sides;
            if (!time_side(b, side, &b->seconds[side][i], error)) {
                return false;
            }
        }
    }
    for (size_t side = 0; side < sides; side++) {
        cell->sides[side] = summarize(b, b->seconds[side]);
    }
    return true;
}

/* The pictures that were drawn last. */
static bool judge_cell(struct bench *b, const struct frame_scene *scene, struct cell *cell,
                       struct error *error) {
    struct exact exact = {0};
    uint8_t *theirs = bench_memory(scene->width * scene->height, IMAGE_BGRA);
    const uint8_t *const pictures[SIDES] = {b->ours.image.pixels, theirs};
    bool done = (b->mesa == NULL || llvmpipe->read(b->mesa, theirs, error)) &&
                exact_begin(&exact, scene, error);
    if (done) {
        exact_compare(&exact, pictures, side_count(b), cell->deviations);
        cell->visible = exact.visible;
    }
    exact_end(&exact);
    free(theirs);
    return done;
}

static bool measure_cell(struct bench *b, const struct frame_scene *scene, struct cell *cell,
                         struct error *error) {
    *cell = (struct cell){.look = scene->look,
                          .width = scene->width,
                          .height = scene->height,
                          .faces = scene->call.model->face_count};
    return load_sides(b, scene, error) && time_cell(b, cell, error) &&
           judge_cell(b, scene, cell, error);
}

/* ---- All cells ---- */

static size_t step_count(const struct bench *b) {
    return b->options.quick ? 1 : STEPS;
}

static bool measure_look(struct bench *b, enum frame_look look, struct error *error) {
    const size_t steps = step_count(b);
    for (size_t k = 0; k < steps * steps; k++) {
        struct frame_scene scene =
            frame_scene(look, widths[k / steps], heights[k / steps], &b->heads[k % steps]);
        struct cell *cell = &b->table.cells[b->table.count];
        if (!measure_cell(b, &scene, cell, error)) {
            return false;
        }
        table_print_times(&b->table, cell);
        b->table.count++;
    }
    return true;
}

static bool measure_all(struct bench *b, struct error *error) {
    const struct options *o = &b->options;
    table_print_time_head(o->threads, o->frames);
    for (enum frame_look look = FRAME_FLAT; look < FRAME_LOOKS; look++) {
        if (o->look != FRAME_LOOKS && o->look != look) {
            continue;
        }
        if (!frame_look_is_possible(look, &b->heads[0].model)) {
            printf("%-7s left out: the model lacks a texture\n", frame_look_name[look]);
        } else if (!measure_look(b, look, error)) {
            return false;
        }
    }
    table_print_errors(&b->table);
    table_print_least(&b->table);
    return true;
}

/* ---- Setting up ---- */

static bool read_heads(struct bench *b, struct error *error) {
    bool done = true;
    for (size_t i = 0; done && i < step_count(b); i++) {
        done = frame_model_read(&b->heads[i], b->options.model, triangles[i], error);
    }
    return done;
}

static void start_mesa(struct bench *b) {
    struct error error;
    if (llvmpipe != NULL) {
        b->mesa = llvmpipe->open((int)b->options.threads, &error);
        printf("%s%s\n", b->mesa != NULL ? "" : "llvmpipe is left out: ",
               b->mesa != NULL ? llvmpipe->name(b->mesa) : error.message);
    }
    b->table.has_mesa = b->mesa != NULL;
}

/* What else the machine does. */
static void print_load(void) {
    double load;
    if (getloadavg(&load, 1) == 1) {
        printf("Load of the machine before this: %.1f%s\n", load,
               load > 0.5 ? "; while it is busy, two threads show no gain" : "");
    }
}

static bool set_up(struct bench *b, struct error *error) {
    if (!read_heads(b, error)) {
        return false;
    }
    printf("%s, seen from (1,1,3), in the middle square of the image\n", b->options.model);
    print_load();
    start_mesa(b);
    return true;
}

static void tear_down(struct bench *b) {
    ours_free(&b->ours);
    if (b->mesa != NULL) {
        llvmpipe->close(b->mesa);
    }
    for (size_t i = 0; i < STEPS; i++) {
        frame_model_free(&b->heads[i]);
    }
    free(b);
}

static bool run(const struct options *options, struct error *error) {
    if (options->skipping) {
        return skipping_measure(options->model, options->frames, error);
    }
    struct bench *bench = bench_memory(1, sizeof *bench);
    bench->options = *options;
    bool done = set_up(bench, error) && measure_all(bench, error);
    tear_down(bench);
    return done;
}

/* ---- The command line ---- */

static bool read_frames(const char *value, void *target) {
    return argument_number(value, target) && *(size_t *)target <= FRAMES_LIMIT;
}

static bool read_threads(const char *value, void *target) {
    return argument_number(value, target) && *(size_t *)target <= THREADS_LIMIT;
}

static bool read_look(const char *value, void *target) {
    enum frame_look look = FRAME_FLAT;
    while (look < FRAME_LOOKS && strcmp(value, frame_look_name[look]) != 0) {
        look++;
    }
    *(enum frame_look *)target = look;
    return look < FRAME_LOOKS;
}

static bool be_quick(const char *value, void *target) {
    struct options *options = target;
    (void)value;
    options->frames = 3;
    options->quick = true;
    return true;
}

/* Print the help where that is wanted. False, with a message, where the command line is wrong. */
static bool read_options(struct options *o, int argc, char **argv, struct error *error) {
    const struct argument known[] = {
        {"--look", "NAME", "only this look: flat, gouraud or phong", read_look, &o->look},
        {"--frames", "N", "frames that are timed of each (default 15)", read_frames, &o->frames},
        {"--threads", "N", "that draw, on both sides (default 1)", read_threads, &o->threads},
        {"--quick", "", "3 frames, at the first size, of the model as it is", be_quick, o},
        {"--skipping", "",
         "only what each shortcut is worth, and what a frame of ever more faces does",
         argument_flag, &o->skipping},
    };
    const size_t known_count = sizeof known / sizeof known[0];
    *o = (struct options){.look = FRAME_LOOKS, .frames = 15, .threads = 1};
    o->help = arguments_want_help(argc, argv);
    if (o->help) {
        puts("usage: bench-frame [options] [model]\n\n"
             "The time of a frame: this course's pipeline and, where Mesa is installed, "
             "llvmpipe.\n");
        arguments_print_help(known, known_count);
        puts("\nThe model is an OBJ file, by default the bust; a look whose textures it lacks is "
             "left out.");
        return true;
    }
    int models = arguments_read(known, known_count, argc, argv, error);
    if (models > 1) {
        return error_set(error, "more than one model");
    }
    o->model = models == 1 ? argv[1] : COURSE_BUILD "/models/bust.obj";
    return models >= 0;
}

int main(int argc, char **argv) {
    struct options options;
    struct error error;
    if (!read_options(&options, argc, argv, &error)) {
        fprintf(stderr, "bench-frame: %s; --help prints the options\n", error.message);
        return 2;
    }
    if (options.help) {
        return 0;
    }
    if (!run(&options, &error)) {
        fprintf(stderr, "bench-frame: %s\n", error.message);
        return 1;
    }
    return 0;
}
