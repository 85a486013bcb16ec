/*
 * Step 6: the pictures of the lesson that are not references, and its numbers.
 *
 *     figures DIR    writes DIR/NAME.png and prints the errors of the attempts
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

enum { GAP = 8, GAP_LEVEL = 255 }; /* white between the panels of a figure */

typedef void draw_function(struct image *image, const struct vertex v[3],
                           const struct texture *texture);

/* A picture of `count` panels side by side, `columns` in a row, the first one top left. */
static bool make_figure(struct image *figure, size_t width, size_t height, size_t columns,
                        size_t count, struct error *error) {
    size_t rows = (count + columns - 1) / columns;
    if (!image_create(figure, columns * (width + GAP) - GAP, rows * (height + GAP) - GAP, IMAGE_BGR,
                      error)) {
        return false;
    }
    image_clear(figure, color_grey(GAP_LEVEL));
    return true;
}

/* Copy a part of `from` (its left bottom corner at left, bottom) into panel `index`, each pixel as
 * a square of `zoom` pixels. */
static void place_panel(struct image *figure, const struct image *from, struct pixel corner,
                        size_t width, size_t height, int zoom, size_t index, size_t columns) {
    size_t to_x = index % columns * (width + GAP);
    size_t to_y = figure->height - height - index / columns * (height + GAP);
    for (size_t y = 0; y < height; y++) {
        for (size_t x = 0; x < width; x++) {
            image_set(figure, (int)(to_x + x), (int)(to_y + y),
                      image_get(from, corner.x + (int)x / zoom, corner.y + (int)y / zoom));
        }
    }
}

static bool save_figure(const char *directory, const char *name, const struct image *figure,
                        struct error *error) {
    char path[1024];
    if (snprintf(path, sizeof path, "%s/%s.png", directory, name) >= (int)sizeof path) {
        return error_set(error, "the directory's name is too long");
    }
    return png_write(figure, path, error);
}

/* The good version, with the attempts' parameters. */
static void draw_good(struct image *image, const struct vertex v[3],
                      const struct texture *texture) {
    struct canvas canvas = {.image = image, .skip = true};
    perspective_triangle(&canvas, v, texture);
}

static void draw_quad(struct image *image, const struct vertex corners[4],
                      const struct texture *texture, draw_function *draw) {
    const struct vertex first[3] = {corners[0], corners[1], corners[2]};
    const struct vertex second[3] = {corners[0], corners[2], corners[3]};
    draw(image, first, texture);
    draw(image, second, texture);
}

/* ---- Samplers: a picture of 4x4 texels on a square ---- */

static bool make_small_texture(struct texture *texture, struct error *error) {
    struct image image;
    if (!image_create(&image, 4, 4, IMAGE_BGR, error)) {
        return false;
    }
    for (int y = 0; y < 4; y++) {
        for (int x = 0; x < 4; x++) {
            struct color bright = color_rgb((uint8_t)(75 + 60 * x), (uint8_t)(75 + 60 * y), 60);
            struct color blue = color_rgb(20, (uint8_t)(30 * y), (uint8_t)(120 + 40 * x));
            image_set(&image, x, y, (x + y) % 2 == 0 ? bright : blue);
        }
    }
    bool done = texture_create(texture, &image, error);
    image_free(&image);
    return done;
}

static bool draw_samplers(const char *directory, struct error *error) {
    enum { SIDE = 192 };
    static draw_function *const draws[] = {attempt_1_rounded, attempt_2_nearest,
                                           attempt_3_unshifted, attempt_4_no_levels};
    struct texture texture = {0};
    struct image panel = {0}, figure = {0};
    bool done = make_small_texture(&texture, error) &&
                image_create(&panel, SIDE, SIDE, IMAGE_BGR, error) &&
                make_figure(&figure, SIDE, SIDE, 4, 4, error);
    const int32_t end = SIDE * SUBPIXELS;
    const struct vertex corners[4] = {
        {.position = {0, 0}, .uv = {0, 0}, .recip_w = 1},
        {.position = {end, 0}, .uv = {1, 0}, .recip_w = 1},
        {.position = {end, end}, .uv = {1, 1}, .recip_w = 1},
        {.position = {0, end}, .uv = {0, 1}, .recip_w = 1},
    };
    for (size_t i = 0; done && i < 4; i++) {
        draw_quad(&panel, corners, &texture, draws[i]);
        place_panel(&figure, &panel, (struct pixel){0, 0}, SIDE, SIDE, 1, i, 4);
    }
    done = done && save_figure(directory, "samplers", &figure, error);
    image_free(&figure);
    image_free(&panel);
    texture_free(&texture);
    return done;
}

/* ---- Affine: a board of 5 x 6 tiles ---- */

static bool draw_affine(const char *directory, const struct texture *checker, struct error *error) {
    enum { SIDE = 320 };
    static draw_function *const draws[] = {attempt_5_affine, draw_good};
    struct image panel = {0}, figure = {0};
    bool done = image_create(&panel, SIDE, SIDE, IMAGE_BGR, error) &&
                make_figure(&figure, SIDE, SIDE, 2, 2, error);
    for (size_t i = 0; done && i < 2; i++) {
        const struct vertex corners[4] = {
            place_on_plane(-1.7, 1.25, &panel),
            place_on_plane(0.8, 1.25, &panel),
            place_on_plane(0.8, 4.25, &panel),
            place_on_plane(-1.7, 4.25, &panel),
        };
        image_clear(&panel, color_grey(0));
        draw_quad(&panel, corners, checker, draws[i]);
        place_panel(&figure, &panel, (struct pixel){0, 0}, SIDE, SIDE, 1, i, 2);
    }
    done = done && save_figure(directory, "affine", &figure, error);
    image_free(&figure);
    image_free(&panel);
    return done;
}

/* ---- The whole scene by every version ---- */

static const struct version {
    const char *name;
    draw_function *draw;
} versions[] = {
    {"nearest by rounding", attempt_1_rounded},
    {"nearest", attempt_2_nearest},
    {"bilinear without the half texel", attempt_3_unshifted},
    {"bilinear", attempt_4_no_levels},
    {"affine, bilinear", attempt_5_affine},
    {"mip levels, exact every 16 pixels", attempt_6_every_16},
    {"mip levels, exact every 8 pixels", attempt_7_every_8},
    {"mip levels, exact at every pixel", draw_good},
};

enum { VERSION_COUNT = sizeof versions / sizeof versions[0], SCENE_SIDE = 800 };
enum { VERSION_NEAREST = 1, VERSION_BILINEAR = 3, VERSION_EVERY_16 = 5, VERSION_GOOD = 7 };

static bool draw_versions(struct image images[VERSION_COUNT], const struct texture *checker,
                          struct error *error) {
    for (size_t i = 0; i < VERSION_COUNT; i++) {
        if (!image_create(&images[i], SCENE_SIDE, SCENE_SIDE, IMAGE_BGR, error)) {
            return false;
        }
        struct vertex corners[4];
        place_plane(&images[i], corners);
        draw_quad(&images[i], corners, checker, versions[i].draw);
        printf("%-36s error %6.2f levels\n", versions[i].name, checker_error(&images[i]));
    }
    return true;
}

/* Parts of the whole scene, enlarged. */
static bool draw_parts(const char *directory, const char *name, const struct image *images,
                       const size_t *which, size_t count, struct pixel corner, int zoom,
                       struct error *error) {
    enum { WIDTH = 324, HEIGHT = 240 };
    struct image figure = {0};
    bool done = make_figure(&figure, WIDTH, HEIGHT, count, count, error);
    for (size_t i = 0; done && i < count; i++) {
        place_panel(&figure, &images[which[i]], corner, WIDTH, HEIGHT, zoom, i, count);
    }
    done = done && save_figure(directory, name, &figure, error);
    image_free(&figure);
    return done;
}

/* ---- The levels that the scene uses, each in its colour ---- */

/* A texture whose level i is full of the colour of level i. */
static bool paint_levels(struct texture *texture, struct error *error) {
    static const uint32_t colors[] = {0xFFFFFF, 0xF0E442, 0x56B4E9, 0x009E73, 0xE69F00,
                                      0xD55E00, 0xCC79A7, 0x0072B2, 0x404040};
    if (!make_checker(texture, error)) {
        return false;
    }
    for (size_t i = 0; i < texture->level_count; i++) {
        const struct texture_level *level = &texture->level[i];
        for (size_t j = 0; j < level->width * level->height; j++) {
            level->texels[j] = colors[i % (sizeof colors / sizeof colors[0])] | 0xFF000000;
        }
    }
    return true;
}

static bool draw_levels(const char *directory, struct error *error) {
    enum { SIDE = 800, SHOWN = 400 };
    struct texture texture = {0};
    struct image panel = {0};
    bool done = paint_levels(&texture, error) && image_create(&panel, SIDE, SIDE, IMAGE_BGR, error);
    if (done) {
        struct vertex corners[4];
        place_plane(&panel, corners);
        draw_quad(&panel, corners, &texture, draw_good);
        done = image_scale(&panel, SHOWN, SHOWN, error) &&
               save_figure(directory, "levels", &panel, error);
    }
    image_free(&panel);
    texture_free(&texture);
    return done;
}

/* ---- Mistakes ---- */

static bool draw_mistakes(const char *directory, struct error *error) {
    enum { SIDE = 256 };
    struct model model = {0};
    struct image panel = {0}, figure = {0};
    double *depth = malloc(SIDE * SIDE * sizeof *depth);
    const struct texture *texture = NULL;
    bool done = depth != NULL;
    if (!done) {
        error_set(error, "out of memory");
    }
    done = done && model_read(&model, COURSE_BUILD "/models/bust.obj", error);
    done = done && (texture = model_texture(&model, MODEL_DIFFUSE, error)) != NULL;
    done = done && image_create(&panel, SIDE, SIDE, IMAGE_BGR, error) &&
           make_figure(&figure, SIDE, SIDE, MISTAKE_COUNT, MISTAKE_COUNT, error);
    for (size_t i = 0; done && i < MISTAKE_COUNT; i++) {
        image_clear(&panel, color_grey(0));
        draw_mistake(&panel, depth, &model, texture, (enum texture_mistake)i);
        place_panel(&figure, &panel, (struct pixel){0, 0}, SIDE, SIDE, 1, i, MISTAKE_COUNT);
    }
    done = done && save_figure(directory, "mistakes", &figure, error);
    image_free(&figure);
    image_free(&panel);
    model_free(&model);
    free(depth);
    return done;
}

int main(int argc, char **argv) {
    static const size_t horizon[] = {VERSION_NEAREST, VERSION_BILINEAR, VERSION_GOOD};
    static const size_t waves[] = {VERSION_EVERY_16, VERSION_GOOD};
    struct error error = {0};
    struct texture checker = {0};
    struct image images[VERSION_COUNT];
    memset(images, 0, sizeof images);
    if (argc != 2) {
        fprintf(stderr, "usage: figures DIR\n");
        return 2;
    }
    const char *directory = argv[1];
    bool done =
        make_checker(&checker, &error) && draw_versions(images, &checker, &error) &&
        draw_samplers(directory, &error) && draw_affine(directory, &checker, &error) &&
        draw_parts(directory, "horizon", images, horizon, 3, (struct pixel){200, 440}, 2, &error) &&
        draw_parts(directory, "waves", images, waves, 2, (struct pixel){0, 350}, 3, &error) &&
        draw_levels(directory, &error) && draw_mistakes(directory, &error);
    for (size_t i = 0; i < VERSION_COUNT; i++) {
        image_free(&images[i]);
    }
    texture_free(&checker);
    if (!done) {
        fprintf(stderr, "figures: %s\n", error.message);
        return 1;
    }
    return 0;
}
