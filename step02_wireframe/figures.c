/* The pictures of step 2's README that are not references, and its tables. */
#include "../tests/bench/figures.h"

#define LESSON "../step02_wireframe/main.c"
#include "../tests/lesson.h"

#include "attempts.h"

#include <stdio.h>
#include <string.h>

enum { SMALL = 400, SMALLER = 160 }; /* pixels of a side of the pictures */

static const struct color white = {255, 255, 255, 255};
static const struct color grey = {130, 130, 130, 255};

/* ---- The rounded cut ---- */

/* One line that reaches out of the image on both sides. */
static bool draw_rounded_line(const char *directory, struct error *error) {
    const struct pixel a = {-17, -9}, b = {89, 31};
    struct comparison compared;
    bool done = comparison_create(&compared, 60, 24, error);
    if (done) {
        attempt_line_ends_rounded(&compared.first, a, b, white);
        line(&compared.second, a, b, white);
        comparison_show(&compared, grey);
        printf("line (-17,-9)-(89,31) on 60x24: %zu pixels right, %zu wrong, %zu missing\n",
               compared.both, compared.only_first, compared.only_second);
        done = figure_save_detail(&compared.shown, detail_of_whole(&compared.shown, 12, 56),
                                  directory, "rounded_line", error);
    }
    comparison_free(&compared);
    return done;
}

/* Move and scale all positions; z is not used here. */
static void change_positions(struct model *model, double scale, double x, double y) {
    for (size_t i = 0; i < model->position_count; i++) {
        struct vec3 *p = &model->positions[i];
        *p = (struct vec3){(p->x - x) * scale, (p->y - y) * scale, p->z};
    }
}

/* The model, much larger than the image, with both cuts. */
static bool draw_rounded_model(const char *directory, const struct model *model,
                               struct error *error) {
    struct comparison compared;
    bool done = comparison_create(&compared, SMALLER, SMALLER, error);
    for (size_t i = 0; done && i < model->face_count; i++) {
        for (size_t j = 0; j < 3; j++) {
            struct pixel a, b;
            if (to_pixel(model_position(model, i, j), SMALLER, SMALLER, &a) &&
                to_pixel(model_position(model, i, (j + 1) % 3), SMALLER, SMALLER, &b)) {
                attempt_line_ends_rounded(&compared.first, a, b, white);
                line(&compared.second, a, b, white);
            }
        }
    }
    if (done) {
        comparison_show(&compared, grey);
        printf("bust x16 on %dx%d: %zu pixels right, %zu wrong, %zu missing\n", SMALLER, SMALLER,
               compared.both, compared.only_first, compared.only_second);
        done = figure_save_detail(&compared.shown, detail_of_whole(&compared.shown, 3, 0),
                                  directory, "rounded_model", error);
    }
    comparison_free(&compared);
    return done;
}

/* A scene without a model, enlarged. */
static bool draw_small_scene(const char *directory, const char *name,
                             bool (*draw)(struct drawing *, struct image *, struct error *),
                             size_t width, size_t height, struct error *error) {
    struct image image;
    struct drawing drawing = {.skip = true};
    bool done = image_create(&image, width, height, IMAGE_BGR, error) &&
                draw(&drawing, &image, error) &&
                figure_save_detail(&image, detail_of_whole(&image, 4, 0), directory, name, error);
    image_free(&image);
    return done;
}

/* ---- A mesh with a border ---- */

/* The scene `border`: what is missing when a side is drawn in one direction only. Moves the
 * positions of `part`, which are its own. */
static bool compare_border(const char *directory, struct model *part, struct error *error) {
    part->faces += part->face_count / 8;
    part->face_count = (part->face_count + 3) / 4;
    change_positions(part, 2.4, 0.26, 0.1);
    struct comparison compared;
    bool done = comparison_create(&compared, 480, 360, error);
    if (done) {
        attempt_4_one_direction(&compared.first, part);
        attempt_1_every_side_tested(&compared.second, part);
        comparison_show(&compared, grey);
        done = figure_save_detail(&compared.shown, (struct detail){86, 30, 170, 100, .zoom = 4},
                                  directory, "one_direction", error);
    }
    comparison_free(&compared);
    return done;
}

static bool draw_one_direction(const char *directory, const struct model *model,
                               struct error *error) {
    struct model part = *model;
    size_t size = part.position_count * sizeof *part.positions;
    part.positions = malloc(size);
    if (part.positions == NULL) {
        return error_out_of_memory(error);
    }
    memcpy(part.positions, model->positions, size);
    bool done = compare_border(directory, &part, error);
    free(part.positions);
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
                              : error_out_of_memory(error);
    model->face_count = face_count;
    free(sides);
    return done;
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    size_t side_count = 0;
    struct side *sides = make_sides(bust, &side_count);
    if (sides == NULL) {
        return error_out_of_memory(error);
    }
    bool done = draw_rounded_line(directory, error) &&
                draw_small_scene(directory, "square", draw_square, 100, 100, error) &&
                draw_small_scene(directory, "cut_lines", draw_cut, CUT_WIDTH, CUT_HEIGHT, error) &&
                draw_one_direction(directory, bust, error) &&
                print_versions("step02_wireframe: the bust", bust, sides, side_count, error);
    done = done && print_open_mesh(bust, error);
    if (done) { /* the face, sixteen times as large */
        change_positions(bust, 16, 0, 0.25);
        done = draw_rounded_model(directory, bust, error) &&
               print_versions("step02_wireframe: the bust x16", bust, sides, side_count, error);
    }
    free(sides);
    return done;
}
