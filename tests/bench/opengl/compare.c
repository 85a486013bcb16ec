/*
 * Draws the scenes of steps 4 to 10 a second time, with OpenGL (Mesa, no window), from the same
 * meshes and matrices, and compares:
 *
 *     compare-opengl [-o DIR] [--shift N] [model]
 *
 * -o writes both pictures of each scene as PNG; --shift moves Mesa's triangles by N/256 pixel, so
 * that one can see the comparison fail. Exit status 0: the same pixels are covered everywhere and
 * no level differs by more than LEVEL_BOUND; 1: something differs; 2: Mesa is missing.
 *
 * Each scene is drawn by Mesa twice. With the plain matrices Mesa places the corners itself, in
 * float: now and then one is snapped to the next 1/256 pixel, and a pixel or two change sides; more
 * than one in PLAIN_BOUND is an error. Told the positions that the course has snapped, Mesa must
 * cover the same pixels; all the rest is compared in this second picture.
 *
 * Coverage is compared for every face, hidden ones too: at each pixel the number of faces that
 * cover it and the sum of their numbers must agree, and a pixel of the lesson's own picture must be
 * drawn exactly where Mesa draws one.
 *
 * Levels are compared where both show the same face. Mesa computes with floats of 24 bits and the
 * course with doubles: a value close to a half may be rounded to the next level, which is the
 * LEVEL_BOUND of 1. Two cases are counted apart. Where two faces have the same depth as far as
 * float can tell, either may be seen. And where a formula jumps (nearest texel, toon step, the
 * edge of the light), the shader says so (see looks.c), and the pixel may fall on either side.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "compared.h"
#include "files/png.h"
#include "mesa.h"
#include "reference.h"
#include "run/stage.h"

#include "bench/timing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

enum { STATUS_SAME = 0, STATUS_DIFFERENT = 1, STATUS_MISSING = 2 };
enum { LEVEL_BOUND = 1 };
/* With the plain matrices one pixel of so many may be covered differently. */
enum { PLAIN_BOUND = 500 };
enum { REPEATS = 15 };

/* Depths in float that are this near to each other, as a part of their size, count as equal. */
static const double depth_tolerance = 2e-6;

struct options {
    const char *directory; /* NULL: write no pictures */
    const char *model;
    int shift; /* 1/256 pixel */
};

/* What was found in one scene, over all its frames. */
struct findings {
    size_t covered;         /* pixels that show a face */
    size_t layers;          /* pixels of all faces, hidden ones too */
    size_t plain_coverage;  /* pixels covered differently when Mesa places the corners itself */
    size_t coverage;        /* and when it is told the snapped positions */
    size_t equal_depth;     /* another face is seen, at the same depth in float */
    size_t wrong_face;      /* another face is seen, at another depth */
    size_t at_jump;         /* levels differ by more than LEVEL_BOUND at a jump */
    size_t beyond_bound;    /* and where there is no jump */
    size_t different;       /* levels differ by any amount, other than at a jump */
    int largest_difference; /* of levels, other than at a jump */
    double ours_ms, mesa_ms;
};

/* ---- A scene and what belongs to it while it is compared ---- */

struct subject {
    const struct lesson *lesson;
    struct stage stage;
    struct image image; /* the lesson's own picture */
    bool *covered;      /* one a pixel: does the lesson show a face there? */
    struct picture picture;
};

/* The lesson's own picture, over a background that is all black or all white. */
static bool draw_over(struct subject *s, uint8_t level, struct error *error) {
    memset(s->image.pixels, level, s->image.width * s->image.height * s->image.format);
    s->stage.drawing.counter_count = 0;
    return stage_draw(&s->stage, &s->image, s->stage.drawing.frame, error);
}

/* Draw the lesson's own picture and find which pixels it has drawn. */
static bool draw_ours(struct subject *s, struct error *error) {
    size_t pixel_count = s->image.width * s->image.height, format = s->image.format;
    struct image over_white = {0};
    bool done = draw_over(s, 255, error) && image_copy(&over_white, &s->image, error) &&
                draw_over(s, 0, error);
    for (size_t i = 0; done && i < pixel_count; i++) {
        bool same =
            memcmp(over_white.pixels + i * format, s->image.pixels + i * format, format) == 0;
        s->covered[i] =
            s->lesson->covered != NULL ? s->lesson->covered(&s->stage.drawing, &s->image, i) : same;
    }
    image_free(&over_white);
    return done;
}

/* ---- Comparing ---- */

/* Step 5 shows depth as grey: the farthest that is seen is 55, the nearest 255, nothing 0. The same
 * for what Mesa's depth buffer holds. */
static void show_depths(const float *depths, size_t pixel_count, uint8_t *pixels) {
    float far = 1, near = 0;
    for (size_t i = 0; i < pixel_count; i++) {
        if (depths[i] > 0) {
            far = depths[i] < far ? depths[i] : far;
            near = depths[i] > near ? depths[i] : near;
        }
    }
    for (size_t i = 0; i < pixel_count; i++) {
        double level = 55 + ((double)depths[i] - far) * 200 / (near > far ? near - far : 1);
        memset(pixels + 4 * i, depths[i] > 0 ? level_from(level) : 0, 3);
    }
}

static bool coverage_differs(const struct subject *s, const struct reference *ours,
                             const struct mesa_result *mesa, size_t pixel) {
    return s->covered[pixel] != (mesa->pixels[4 * pixel + 3] != 0) ||
           s->covered[pixel] != (ours->faces[pixel] > 0) ||
           ours->layers[pixel][0] != mesa->layers[pixel][0] ||
           ours->layers[pixel][1] != mesa->layers[pixel][1];
}

static size_t count_coverage(const struct subject *s, const struct reference *ours,
                             const struct mesa_result *mesa) {
    size_t different = 0;
    for (size_t i = 0; i < s->picture.width * s->picture.height; i++) {
        different += coverage_differs(s, ours, mesa, i);
    }
    return different;
}

/* The largest difference of the three channels. Mesa's pixels are red, green, blue, alpha. */
static int level_difference(const struct image *ours, const struct mesa_result *mesa,
                            size_t pixel) {
    int largest = 0;
    for (size_t channel = 0; channel < 3; channel++) {
        size_t in_ours = ours->format == IMAGE_GREY ? 0 : 2 - channel;
        int difference = abs((int)ours->pixels[pixel * ours->format + in_ours] -
                             (int)mesa->pixels[4 * pixel + channel]);
        largest = difference > largest ? difference : largest;
    }
    return largest;
}

/* Everything that is compared with the snapped positions. */
static void compare(const struct subject *s, const struct reference *ours,
                    const struct mesa_result *mesa, struct findings *f) {
    f->coverage += count_coverage(s, ours, mesa);
    for (size_t i = 0; i < s->picture.width * s->picture.height; i++) {
        f->layers += (size_t)ours->layers[i][0];
        if (!s->covered[i] || mesa->pixels[4 * i + 3] == 0) {
            continue;
        }
        f->covered++;
        if (ours->faces[i] != mesa->faces[i]) {
            double distance = fabs(ours->depths[i] - (double)mesa->depths[i]);
            bool equal = distance <= depth_tolerance * ours->depths[i];
            f->equal_depth += equal;
            f->wrong_face += !equal;
            continue;
        }
        int difference = level_difference(&s->image, mesa, i);
        bool at_jump = mesa->pixels[4 * i + 3] == 254;
        if (difference > LEVEL_BOUND && at_jump) {
            f->at_jump++;
            continue;
        }
        f->beyond_bound += difference > LEVEL_BOUND;
        f->different += difference > 0;
        f->largest_difference =
            difference > f->largest_difference ? difference : f->largest_difference;
    }
}

/* ---- Pictures for the eye ---- */

static bool save_mesa(const struct subject *s, const struct mesa_result *mesa, const char *path,
                      struct error *error) {
    struct image image;
    if (!image_create(&image, s->picture.width, s->picture.height, IMAGE_BGR, error)) {
        return false;
    }
    for (size_t i = 0; i < image.width * image.height; i++) {
        const uint8_t *rgb = mesa->pixels + 4 * i;
        memcpy(image.pixels + 3 * i, (const uint8_t[3]){rgb[2], rgb[1], rgb[0]}, 3);
    }
    bool done = png_write(&image, path, error);
    image_free(&image);
    return done;
}

static bool save_both(const struct subject *s, const struct mesa_result *mesa,
                      const char *directory, struct error *error) {
    char ours_path[1024], mesa_path[1024];
    const char *step = s->lesson->program->name, *scene = s->stage.scene.name;
    snprintf(ours_path, sizeof ours_path, "%s/%s_%s_course.png", directory, step, scene);
    snprintf(mesa_path, sizeof mesa_path, "%s/%s_%s_mesa.png", directory, step, scene);
    return png_write(&s->image, ours_path, error) && save_mesa(s, mesa, mesa_path, error);
}

/* ---- One scene ---- */

static double median_ms(double times[REPEATS]) {
    sort_doubles(times, REPEATS);
    return 1e3 * quantile(times, REPEATS, 0.5);
}

static bool time_ours(struct subject *s, double *ms, struct error *error) {
    double times[REPEATS];
    for (int i = 0; i < REPEATS; i++) {
        double begin = now();
        if (!draw_over(s, 0, error)) {
            return false;
        }
        times[i] = now() - begin;
    }
    *ms = median_ms(times);
    return true;
}

/* With the plain matrices, as a program that uses OpenGL would draw. The picture of the depths is
 * made of what is read back, which is part of its time. */
static void time_mesa(const struct subject *s, struct mesa *mesa, struct mesa_result *result,
                      double *ms) {
    double times[REPEATS];
    mesa_draw(mesa, &s->picture, POSITIONS_WHOLE); /* compiles the shaders for this state */
    for (int i = 0; i < REPEATS; i++) {
        double begin = now();
        mesa_draw(mesa, &s->picture, POSITIONS_WHOLE);
        if (s->picture.shows_depth) {
            mesa_read_depths(mesa, &s->picture, result->depths);
            show_depths(result->depths, s->picture.width * s->picture.height, result->pixels);
        }
        times[i] = now() - begin;
    }
    *ms = median_ms(times);
}

/* Draw the picture that is loaded both ways and compare. */
static bool compare_loaded(struct subject *s, struct mesa *mesa, const struct options *options,
                           struct findings *f, struct error *error) {
    size_t pixel_count = s->picture.width * s->picture.height;
    struct reference ours = {0};
    struct mesa_result plain = {0}, snapped = {0};
    bool done = reference_draw(&ours, &s->picture, error) &&
                mesa_draw_and_read(mesa, &s->picture, POSITIONS_WHOLE, &plain, error) &&
                mesa_draw_and_read(mesa, &s->picture, POSITIONS_SNAPPED, &snapped, error);
    if (!done) {
        goto end;
    }
    if (s->picture.shows_depth) {
        show_depths(snapped.depths, pixel_count, snapped.pixels);
    }
    f->plain_coverage += count_coverage(s, &ours, &plain);
    compare(s, &ours, &snapped, f);
    if (s->stage.drawing.frame == 0) {
        done = options->directory == NULL || save_both(s, &snapped, options->directory, error);
        time_mesa(s, mesa, &plain, &f->mesa_ms);
        done = done && time_ours(s, &f->ours_ms, error);
    }
end:
    reference_free(&ours);
    mesa_result_free(&plain);
    mesa_result_free(&snapped);
    return done;
}

static bool compare_frame(struct subject *s, struct mesa *mesa, const struct options *options,
                          struct findings *f, struct error *error) {
    s->picture = (struct picture){
        .width = s->image.width, .height = s->image.height, .shift = options->shift};
    bool done =
        draw_ours(s, error) &&
        s->lesson->build(s->stage.scene.name, &s->stage.drawing, &s->image, &s->picture, error) &&
        mesa_load(mesa, &s->picture, error) && compare_loaded(s, mesa, options, f, error);
    mesa_unload(mesa);
    picture_free(&s->picture);
    return done;
}

static bool compare_scene(const struct lesson *lesson, const struct scene *given, struct run *run,
                          struct mesa *mesa, const struct options *options, struct findings *f,
                          struct error *error) {
    struct scene scene = scene_complete(lesson->program, given);
    struct subject s = {.lesson = lesson};
    if (lesson->left_out(scene.name) != NULL) {
        /* cppcheck-suppress assignBoolToPointer */
        scene.draw = lesson->rest(scene.name);
    }
    s.covered = calloc(scene.width * scene.height, sizeof *s.covered);
    bool done = s.covered != NULL || error_out_of_memory(error);
    done = done && image_create(&s.image, scene.width, scene.height, scene.format, error) &&
           stage_begin(&s.stage, run, &scene, scene.width, scene.height, error);
    for (size_t i = 0; done && i < scene.frames; i++) {
        s.stage.drawing.frame = i;
        done = compare_frame(&s, mesa, options, f, error);
    }
    stage_end(&s.stage);
    image_free(&s.image);
    free(s.covered);
    return done;
}

/* ---- All scenes ---- */

static bool findings_are_good(const struct findings *f) {
    return f->coverage == 0 && f->wrong_face == 0 && f->beyond_bound == 0 && f->covered > 0 &&
           f->plain_coverage * PLAIN_BOUND <= f->covered;
}

static void print_findings(const char *step, const char *scene, const struct findings *f) {
    printf("%s %s: coverage differs in %zu pixels, largest level difference %d (in %zu of %zu "
           "pixels), ours %.2f ms, Mesa %.2f ms",
           step, scene, f->coverage, f->largest_difference, f->different, f->covered, f->ours_ms,
           f->mesa_ms);
    printf("; with plain matrices coverage differs in %zu", f->plain_coverage);
    if (f->equal_depth > 0) {
        printf("; another face at equal depth in %zu", f->equal_depth);
    }
    if (f->at_jump > 0) {
        printf("; other side of a jump in %zu", f->at_jump);
    }
    if (f->wrong_face > 0) {
        printf("; WRONG FACE in %zu", f->wrong_face);
    }
    if (f->beyond_bound > 0) {
        printf("; MORE THAN %d LEVEL in %zu", LEVEL_BOUND, f->beyond_bound);
    }
    printf("\n");
    fflush(stdout);
}

static void add_findings(struct findings *total, const struct findings *f) {
    total->covered += f->covered;
    total->layers += f->layers;
    total->plain_coverage += f->plain_coverage;
    total->coverage += f->coverage;
    total->equal_depth += f->equal_depth;
    total->wrong_face += f->wrong_face;
    total->at_jump += f->at_jump;
    total->beyond_bound += f->beyond_bound;
    total->different += f->different;
    total->largest_difference = f->largest_difference > total->largest_difference
                                    ? f->largest_difference
                                    : total->largest_difference;
}

static bool compare_lesson(const struct lesson *lesson, struct mesa *mesa,
                           const struct options *options, struct findings *total, bool *good,
                           struct error *error) {
    struct program program = *lesson->program;
    struct run run = {.program = &program, .input = options->model};
    bool done = true;
    program.state_size =
        lesson->state_size > program.state_size ? lesson->state_size : program.state_size;
    for (size_t i = 0; done && i < program.scene_count; i++) {
        const struct scene *scene = &program.scenes[i];
        const char *left_out = lesson->left_out(scene->name);
        const char *skipped = lesson->skipped != NULL ? lesson->skipped(scene->name) : NULL;
        struct findings found = {0};
        if (scene->extra) {
            continue;
        }
        if (skipped != NULL) {
            printf("%s %s: not compared: %s\n", program.name, scene->name, skipped);
            continue;
        }
        if (left_out != NULL) {
            printf("%s %s: left out: %s\n", program.name, scene->name, left_out);
        }
        if (left_out != NULL && lesson->rest == NULL) {
            continue;
        }
        done = compare_scene(lesson, scene, &run, mesa, options, &found, error);
        if (done) {
            print_findings(program.name, scene->name, &found);
            *good = *good && findings_are_good(&found);
            add_findings(total, &found);
        }
    }
    run_free(&run);
    return done;
}

static int compare_all(struct mesa *mesa, const struct options *options) {
    struct findings total = {0};
    bool good = true;
    struct error error = {0};
    printf("%s\n", mesa_name(mesa));
    for (size_t i = 0; lessons[i] != NULL; i++) {
        if (!compare_lesson(lessons[i], mesa, options, &total, &good, &error)) {
            fprintf(stderr, "compare-opengl: %s: %s\n", lessons[i]->program->name, error.message);
            return STATUS_DIFFERENT;
        }
    }
    printf("total: coverage differs in %zu of %zu pixels (%zu with hidden faces), largest level "
           "difference %d (in %zu pixels); with plain matrices coverage differs in %zu; another "
           "face at equal depth in %zu; other side of a jump in %zu\n",
           total.coverage, total.covered, total.layers, total.largest_difference, total.different,
           total.plain_coverage, total.equal_depth, total.at_jump);
    printf("Times: medians of %d draws on this machine, both on the CPU. Mesa's are with the plain "
           "matrices;\nthe light at corners is computed beforehand for Mesa, and in our time.\n",
           REPEATS);
    return good ? STATUS_SAME : STATUS_DIFFERENT;
}

static bool parse_options(int argc, char **argv, struct options *options) {
    *options = (struct options){0};
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "-o") == 0 && i + 1 < argc) {
            options->directory = argv[++i];
        } else if (strcmp(argv[i], "--shift") == 0 && i + 1 < argc) {
            options->shift = (int)strtol(argv[++i], NULL, 10);
        } else if (argv[i][0] != '-' && i + 1 == argc) {
            options->model = argv[i];
        } else {
            return false;
        }
    }
    return true;
}

int main(int argc, char **argv) {
    struct options options;
    struct error error = {0};
    if (!parse_options(argc, argv, &options)) {
        fprintf(stderr, "usage: compare-opengl [-o DIR] [--shift N] [model]\n");
        return STATUS_MISSING;
    }
    struct mesa *mesa = mesa_open(&error);
    if (mesa == NULL) {
        fprintf(stderr,
                "compare-opengl: %s\nInstall Mesa; on Debian: apt-get install libegl-dev libgl-dev "
                "libegl-mesa0 libgl1-mesa-dri\n",
                error.message);
        return STATUS_MISSING;
    }
    int status = compare_all(mesa, &options);
    mesa_close(mesa);
    return status;
}
