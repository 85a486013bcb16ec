/*
 * Draws the pictures of step 2's README that are not references, and prints its tables:
 * `make figures`, or figures OUTDIR.
 */
#define main step_main
int step_main(int argc, char **argv);
#include "main.c"
#undef main

#include "attempts.h"
#include "png.h"

#include <stdio.h>
#include <string.h>

#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif

enum { SMALL = 400, SMALLER = 160 }; /* pixels of a side of the pictures */

static const struct color white = {255, 255, 255, 255};
static const struct color grey = {130, 130, 130, 255};
static const struct color orange = {0, 150, 255, 255};
static const struct color sky = {255, 160, 60, 255};

/* Save the image with every pixel as a block of `scale` x `scale`, in a grid where there is room
 * for one. */
static bool save(const char *directory, const char *name, const struct image *image, size_t scale,
                 struct error *error) {
    const struct color grid = color_grey(56);
    char path[1024];
    struct image large;
    if (snprintf(path, sizeof path, "%s/%s.png", directory, name) >= (int)sizeof path) {
        return error_set(error, "%s: the name is too long", directory);
    }
    if (!image_create(&large, image->width * scale, image->height * scale, image->format, error)) {
        return false;
    }
    for (size_t y = 0; y < large.height; y++) {
        for (size_t x = 0; x < large.width; x++) {
            bool border = scale >= 6 && (x % scale == 0 || y % scale == 0);
            struct color color = image_get(image, (int)(x / scale), (int)(y / scale));
            image_set(&large, (int)x, (int)y, border ? grid : color);
        }
    }
    bool done = png_write(&large, path, error);
    image_free(&large);
    return done;
}

/* ---- Wrong pictures ---- */

/* How a wrong program gets a pixel from a corner of a face. */
typedef bool corner_function(const struct model *model, const struct corner *corner,
                             struct pixel *pixel);

/* OBJ counts from 1, arrays from 0; here 1 was not taken away. (The last one would lie outside the
 * array: here it becomes the first.) */
static bool corner_one_too_far(const struct model *model, const struct corner *corner,
                               struct pixel *pixel) {
    size_t position = (corner->position + (size_t)1) % model->position_count;
    return to_pixel(model->positions[position], SMALL, SMALL, pixel);
}

/* Of `1/2/3` the second number was taken for the position. */
static bool corner_from_uv(const struct model *model, const struct corner *corner,
                           struct pixel *pixel) {
    return to_pixel(model->positions[corner->uv % model->position_count], SMALL, SMALL, pixel);
}

/* x * width / 2 without adding 1 first: the middle of the model comes to the corner of the image.
 */
static bool corner_not_shifted(const struct model *model, const struct corner *corner,
                               struct pixel *pixel) {
    const float *position = model->positions[corner->position];
    const float shifted[3] = {position[0] - 1, position[1] - 1, position[2]};
    return to_pixel(shifted, SMALL, SMALL, pixel);
}

/* y counted from the top. */
static bool corner_upside_down(const struct model *model, const struct corner *corner,
                               struct pixel *pixel) {
    if (!to_pixel(model->positions[corner->position], SMALL, SMALL, pixel)) {
        return false;
    }
    pixel->y = SMALL - 1 - pixel->y;
    return true;
}

static bool draw_wrong(const char *directory, const char *name, const struct model *model,
                       corner_function *find, struct error *error) {
    struct image image;
    if (!image_create(&image, SMALL, SMALL, IMAGE_GREY, error)) {
        return false;
    }
    for (size_t i = 0; i < model->face_count; i++) {
        for (size_t j = 0; j < 3; j++) {
            struct pixel a, b;
            if (find(model, &model->faces[i].corner[j], &a) &&
                find(model, &model->faces[i].corner[(j + 1) % 3], &b)) {
                line(&image, a, b, white);
            }
        }
    }
    bool done = save(directory, name, &image, 1, error);
    image_free(&image);
    return done;
}

/* ---- The rounded cut ---- */

/* Pixels of two pictures: how many are drawn in both, and only in one. */
struct difference {
    unsigned long both, only_first, only_second;
};

/* Grey where both are drawn, orange where only the first is, blue where only the second is. */
static struct difference draw_difference(struct image *image, const struct image *first,
                                         const struct image *second) {
    struct difference difference = {0};
    for (int y = 0; y < (int)image->height; y++) {
        for (int x = 0; x < (int)image->width; x++) {
            bool in_first = image_get(first, x, y).g != 0;
            bool in_second = image_get(second, x, y).g != 0;
            if (in_first && in_second) {
                image_set(image, x, y, grey);
                difference.both++;
            } else if (in_first) {
                image_set(image, x, y, orange);
                difference.only_first++;
            } else if (in_second) {
                image_set(image, x, y, sky);
                difference.only_second++;
            }
        }
    }
    return difference;
}

/* Three images of one size: two versions and what differs. */
struct panel {
    struct image first, second, shown;
};

static bool panel_create(struct panel *panel, size_t width, size_t height, struct error *error) {
    *panel = (struct panel){0};
    return image_create(&panel->first, width, height, IMAGE_GREY, error) &&
           image_create(&panel->second, width, height, IMAGE_GREY, error) &&
           image_create(&panel->shown, width, height, IMAGE_BGR, error);
}

static void panel_free(struct panel *panel) {
    image_free(&panel->first);
    image_free(&panel->second);
    image_free(&panel->shown);
}

/* One line that reaches out of the image on both sides. */
static bool draw_rounded_line(const char *directory, struct error *error) {
    const struct pixel a = {-17, -9}, b = {89, 31};
    struct panel panel;
    bool done = panel_create(&panel, 60, 24, error);
    if (done) {
        attempt_line_ends_rounded(&panel.first, a, b, white);
        line(&panel.second, a, b, white);
        struct difference found = draw_difference(&panel.shown, &panel.first, &panel.second);
        printf("line (-17,-9)-(89,31) on 60x24: %lu pixels right, %lu wrong, %lu missing\n",
               found.both, found.only_first, found.only_second);
        done = save(directory, "rounded_line", &panel.shown, 12, error);
    }
    panel_free(&panel);
    return done;
}

/* Move and scale all positions; z is not used here. */
static void change_positions(struct model *model, float scale, float x, float y) {
    for (size_t i = 0; i < model->position_count; i++) {
        model->positions[i][0] = (model->positions[i][0] - x) * scale;
        model->positions[i][1] = (model->positions[i][1] - y) * scale;
    }
}

/* The model, much larger than the image, with both cuts. */
static bool draw_rounded_model(const char *directory, const struct model *model,
                               struct error *error) {
    struct panel panel;
    bool done = panel_create(&panel, SMALLER, SMALLER, error);
    for (size_t i = 0; done && i < model->face_count; i++) {
        for (size_t j = 0; j < 3; j++) {
            struct pixel a, b;
            const struct corner *corner = model->faces[i].corner;
            if (to_pixel(model->positions[corner[j].position], SMALLER, SMALLER, &a) &&
                to_pixel(model->positions[corner[(j + 1) % 3].position], SMALLER, SMALLER, &b)) {
                attempt_line_ends_rounded(&panel.first, a, b, white);
                line(&panel.second, a, b, white);
            }
        }
    }
    if (done) {
        struct difference found = draw_difference(&panel.shown, &panel.first, &panel.second);
        printf("bust x16 on %dx%d: %lu pixels right, %lu wrong, %lu missing\n", SMALLER, SMALLER,
               found.both, found.only_first, found.only_second);
        done = save(directory, "rounded_model", &panel.shown, 3, error);
    }
    panel_free(&panel);
    return done;
}

/* ---- The table of work ---- */

static void print_work(const char *name, const struct work *work) {
    printf("%-24s %8llu %12llu %12llu\n", name, (unsigned long long)work->lines,
           (unsigned long long)work->tested, (unsigned long long)work->written);
}

/* main.c's own way: the list of sides, cut. */
static struct work each_once_cut(struct image *image, const struct model *model,
                                 const struct side *sides, size_t side_count) {
    struct work work = {0};
    for (size_t i = 0; i < side_count; i++) {
        attempt_side(image, model, sides[i].low, sides[i].high, true, &work);
    }
    return work;
}

/* Draw with all versions; says so when a picture differs from the first. */
static bool print_versions(const char *title, const struct model *model, const struct side *sides,
                           size_t side_count, struct error *error) {
    enum { VERSIONS = 5, SIZE = 800 };
    static const char *const names[VERSIONS] = {"1 every side, tested", "2 every side, cut",
                                                "3 each once, tested", "4 one direction, cut",
                                                "each once, cut"};
    struct image images[VERSIONS] = {{0}};
    bool done = true;
    for (int i = 0; i < VERSIONS; i++) {
        done = done && image_create(&images[i], SIZE, SIZE, IMAGE_GREY, error);
    }
    if (done) {
        struct work work[VERSIONS] = {
            attempt_1_every_side_tested(&images[0], model),
            attempt_2_every_side_cut(&images[1], model),
            attempt_3_each_once_tested(&images[2], model, sides, side_count),
            attempt_4_one_direction(&images[3], model),
            each_once_cut(&images[4], model, sides, side_count),
        };
        printf("%s\n%-24s %8s %12s %12s\n", title, "version", "lines", "tested", "written");
        for (int i = 0; i < VERSIONS; i++) {
            print_work(names[i], &work[i]);
            if (memcmp(images[i].pixels, images[0].pixels, SIZE * SIZE) != 0) {
                printf("    (not the same picture)\n");
            }
        }
    }
    for (int i = 0; i < VERSIONS; i++) {
        image_free(&images[i]);
    }
    return done;
}

/* The sides once each; the caller frees them. NULL when memory runs out. */
static struct side *make_sides(const struct model *model, size_t *side_count) {
    struct side *sides = calloc(3 * model->face_count + 1, sizeof *sides);
    if (sides != NULL) {
        list_sides(model, sides);
        *side_count = keep_one_of_each(sides, 3 * model->face_count);
    }
    return sides;
}

/* A mesh with a border: the first third of the faces only. */
static bool print_open_mesh(struct model *model, struct error *error) {
    size_t face_count = model->face_count, side_count = 0;
    model->face_count = face_count / 3;
    struct side *sides = make_sides(model, &side_count);
    bool done = sides != NULL ? print_versions("step02_wireframe: a third of the faces", model,
                                               sides, side_count, error)
                              : error_set(error, "not enough memory");
    model->face_count = face_count;
    free(sides);
    return done;
}

/* ---- All of them ---- */

static bool draw_all(const char *directory, struct model *model, struct error *error) {
    size_t side_count = 0;
    struct side *sides = make_sides(model, &side_count);
    if (sides == NULL) {
        return error_set(error, "not enough memory");
    }
    bool done = draw_wrong(directory, "one_too_far", model, corner_one_too_far, error) &&
                draw_wrong(directory, "second_number", model, corner_from_uv, error) &&
                draw_wrong(directory, "not_shifted", model, corner_not_shifted, error) &&
                draw_wrong(directory, "upside_down", model, corner_upside_down, error) &&
                draw_rounded_line(directory, error) &&
                print_versions("step02_wireframe: the bust", model, sides, side_count, error);
    if (done) {
        done = print_open_mesh(model, error);
    }
    if (done) {
        /* The face, sixteen times as large. */
        change_positions(model, 16, 0, 0.25f);
        done = draw_rounded_model(directory, model, error) &&
               print_versions("step02_wireframe: the bust x16", model, sides, side_count, error);
    }
    free(sides);
    return done;
}

int main(int argc, char **argv) {
    struct error error = {0};
    if (argc != 2) {
        fprintf(stderr, "usage: %s OUTDIR\n", argv[0]);
        return 2;
    }
    struct model model;
    bool done = model_read(&model, COURSE_BUILD "/models/bust.obj", &error) &&
                draw_all(argv[1], &model, &error);
    model_free(&model);
    if (!done) {
        fprintf(stderr, "%s: %s\n", argv[0], error.message);
    }
    return done ? 0 : 1;
}
