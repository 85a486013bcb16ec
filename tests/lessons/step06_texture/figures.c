/* The pictures of lesson 6 that are not references. */
#include "bench/figures.h"

#define LESSON "../step06_texture/main.c"
#include "lesson.h"

#include "../../../step06_texture/attempts.h"
#include "files/model_file.h"

enum { GAP = 8 }; /* pixels between the panels of a figure */

/* ---- Samplers: a picture of 4x4 texels on a square ---- */

static struct color small_color(int x, int y) {
    struct color bright = color_rgb((uint8_t)(75 + 60 * x), (uint8_t)(75 + 60 * y), 60);
    struct color blue = color_rgb(20, (uint8_t)(30 * y), (uint8_t)(120 + 40 * x));
    return (x + y) % 2 == 0 ? bright : blue;
}

static void draw_samplers(void) {
    enum { SIDE = 192 };
    static attempt_function *const attempts[] = {attempt_1_rounded, attempt_2_nearest,
                                                 attempt_3_unshifted, attempt_4_no_levels};
    struct texture texture;
    struct sheet sheet = {.width = SIDE, .height = SIDE, .columns = 4, .rows = 1, .gap = GAP};
    figure_need(paint(&texture, &(struct pattern){4, 4, small_color, true}, &figure_error));
    sheet_create(&sheet);
    struct vertex corners[4];
    attempt_square(corners, SIDE);
    for (size_t i = 0; i < 4; i++) {
        attempt_quad(&sheet.panel, corners, &texture, attempts[i]);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "samplers");
}

/* ---- Affine: a board of 5 x 6 tiles ---- */

static void draw_affine(const struct texture *tiles) {
    enum { SIDE = 320 };
    static attempt_function *const attempts[] = {attempt_5_affine, attempt_6_levels};
    static const struct surface board = {
        &checker,
        {{-1.7, 0, 1.25}, {0.8, 0, 1.25}, {0.8, 0, 4.25}, {-1.7, 0, 4.25}},
        {{-1.7, 1.25}, {0.8, 1.25}, {0.8, 4.25}, {-1.7, 4.25}},
    };
    struct sheet sheet = {.width = SIDE, .height = SIDE, .columns = 2, .rows = 1, .gap = GAP};
    sheet_create(&sheet);
    for (size_t i = 0; i < 2; i++) {
        struct vertex corners[4];
        place_surface(&board, &sheet.panel, corners);
        attempt_quad(&sheet.panel, corners, tiles, attempts[i]);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "affine");
}

/* ---- The horizon of scene checker ---- */

static void draw_horizon(const struct texture *tiles) {
    static attempt_function *const attempts[] = {attempt_2_nearest, attempt_4_no_levels,
                                                 attempt_6_levels};
    const struct detail far = {200, 440, 162, 120, .zoom = 2};
    struct sheet sheet = {.width = (size_t)(far.width * far.zoom),
                          .height = (size_t)(far.height * far.zoom),
                          .columns = 3,
                          .rows = 1,
                          .gap = GAP};
    struct image image = figure_image(800, 800);
    sheet_create(&sheet);
    for (size_t i = 0; i < 3; i++) {
        struct vertex corners[4];
        place_surface(&plane_of_tiles, &image, corners);
        image_clear(&image, color_grey(0));
        attempt_quad(&image, corners, tiles, attempts[i]);
        sheet_add_detail(&sheet, &image, far);
    }
    figure_save(&sheet.image, "horizon");
}

/* ---- The textures themselves ---- */

/* The finest level that is not wider than the image, into its lower left corner. */
static void show_texture(struct image *image, const struct texture *texture) {
    size_t number = 0;
    while (texture->level[number].width > image->width) {
        number++;
    }
    const struct texture_level *level = &texture->level[number];
    for (size_t y = 0; y < level->height; y++) {
        for (size_t x = 0; x < level->width; x++) {
            image_set(image, (int)x, (int)y, color_from_texel(texture_texel(level, x, y)));
        }
    }
}

/* The levels that scene checker uses, each in its colour. Drawn twice as large as it is shown,
 * which is as the next level. */
static void draw_levels(void) {
    enum { SIDE = 800, SHOWN = 400 };
    struct texture texture, drawn;
    struct image panel = figure_image(SIDE, SIDE), shown = figure_image(SHOWN, SHOWN);
    struct vertex corners[4];
    figure_need(paint(&texture, &checker, &figure_error));
    attempt_color_levels(&texture);
    place_surface(&plane_of_tiles, &panel, corners);
    attempt_quad(&panel, corners, &texture, attempt_6_levels);
    figure_need(texture_create(&drawn, &panel, &figure_error));
    show_texture(&shown, &drawn);
    figure_save(&shown, "levels");
}

static void draw_textures(struct model *bust) {
    static const enum model_texture_kind kinds[] = {MODEL_DIFFUSE, MODEL_NORMAL_MAP,
                                                    MODEL_SPECULAR};
    struct sheet sheet = {.width = 256, .height = 256, .columns = 3, .rows = 1, .gap = GAP};
    sheet_create(&sheet);
    for (size_t i = 0; i < 3; i++) {
        const struct texture *texture = model_texture(bust, kinds[i], &figure_error);
        figure_need(texture != NULL);
        show_texture(&sheet.panel, texture);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "textures");
}

/* Half the texture's colour, half blue: the same, however often an edge is drawn. On the right: the
 * head is symmetric, and on the left one sees what is below. */
static void draw_uv_edge(struct image *image, const struct image *below, struct vec2 a,
                         struct vec2 b) {
    double side = (double)image->width;
    struct pixel from = {(int)floor(a.x * side), (int)floor(a.y * side)};
    struct pixel to = {(int)floor(b.x * side), (int)floor(b.y * side)};
    struct line_walk walk;
    bool more = line_begin(&walk, from, to, image->width, image->height);
    for (; more; more = line_next(&walk)) {
        if (2 * walk.x >= (int)image->width) {
            struct color c = image_get(below, walk.x, walk.y);
            image_set(image, walk.x, walk.y,
                      color_rgb((uint8_t)(c.r / 2), (uint8_t)(c.g / 2), (uint8_t)(c.b / 2 + 127)));
        }
    }
}

/* All faces of the bust where they lie in its texture. */
static void draw_uv_mesh(struct model *bust) {
    enum { SIDE = 512 };
    struct image below = figure_image(SIDE, SIDE), image = figure_image(SIDE, SIDE);
    const struct texture *texture = model_texture(bust, MODEL_DIFFUSE, &figure_error);
    figure_need(texture != NULL);
    show_texture(&below, texture);
    show_texture(&image, texture);
    for (size_t face = 0; face < bust->face_count; face++) {
        for (size_t i = 0; i < 3; i++) {
            draw_uv_edge(&image, &below, model_uv(bust, face, i),
                         model_uv(bust, face, (i + 1) % 3));
        }
    }
    figure_save(&image, "uv_mesh");
}

void draw_figures(struct model *bust) {
    struct texture tiles;
    figure_need(paint(&tiles, &checker, &figure_error));
    draw_horizon(&tiles);
    draw_samplers();
    draw_affine(&tiles);
    draw_levels();
    draw_textures(bust);
    draw_uv_mesh(bust);
}
