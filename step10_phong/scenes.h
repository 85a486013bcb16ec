/*
 * Lesson 10, the given part: the pictures of README.md, and the program.
 *
 * A picture is a grid of cells, and each cell shows the model as one shader draws it, with a
 * material.
 */
#include "extra_materials.h"

/* ---- Cells ---- */

static const struct material plain_material = {0.1, 1, 0.5, 10, {255, 128, 255}};
static const struct material textured_material = {0.1, 1, 1, 10, {255, 255, 255}};

/* What the shaders of the lesson read, for a model that is about so many pixels wide. */
static struct uniforms make_uniforms(const struct drawing *drawing, double pixels,
                                     struct material material) {
    const double one_picture = pixels / fmax(drawing->repeats, 1);
    return (struct uniforms){
        .model = drawing->model,
        .diffuse = drawing->diffuse,
        .normal_map = drawing->normal_map,
        .specular = drawing->specular,
        .diffuse_level = texture_wrapped_level(drawing->diffuse, one_picture),
        .normal_level = texture_wrapped_level(drawing->normal_map, one_picture),
        .specular_level = texture_wrapped_level(drawing->specular, one_picture),
        .eye = drawing->eye,
        .to_light = vec3_normalized(drawing->light),
        .material = material,
    };
}

struct cell {
    const struct shader *shader;
    struct material material;
    const struct model *model;      /* NULL: the drawing's */
    const struct texture *specular; /* NULL: the drawing's */
};

/* What they read for the drawing's model in a cell, or for a part of it. */
static struct uniforms cell_uniforms(const struct drawing *drawing, const struct cell *cell,
                                     double pixels) {
    struct uniforms u = make_uniforms(drawing, pixels, cell->material);
    if (cell->shader != &plain && cell->shader != &mapped) {
        u.material = own_material(drawing, cell->material);
    }
    if (cell->shader == &weight_mapped || cell->shader == &power_mapped) {
        u.normal_level += 1; /* three different levels: exchanged, they show */
        u.specular_level += 2;
    }
    if (cell->model != NULL) {
        u.model = cell->model;
    }
    if (cell->specular != NULL) {
        u.specular = cell->specular;
        u.specular_level = 0;
    }
    return u;
}

/* Draw rows of cells, the first one top left. */
static bool draw_cells(struct drawing *drawing, struct image *image, const struct cell *cells,
                       int columns, int rows, double zoom, struct error *error) {
    bool done = true;
    pipeline_begin(drawing);
    for (int i = 0; done && i < columns * rows; i++) {
        struct rectangle place = grid_cell(image->width, image->height, columns, rows, i);
        for (size_t part = 0; drawing_take_part(drawing, part); part++) {
            struct draw_call call = pipeline_call(drawing, place, zoom, CULL_BACK);
            struct uniforms u = cell_uniforms(drawing, &cells[i], zoom * place.width);
            call.model = u.model;
            done = done && draw_part(drawing, &call, cells[i].shader, &u, error);
        }
    }
    return pipeline_end(drawing, done, image, error);
}

/* ---- Scenes ---- */

static struct cell plain_cell(int power) {
    struct cell cell = {&plain, plain_material, NULL, NULL};
    cell.material.power = power;
    return cell;
}

/* Ambient and diffuse light. Nothing shines, and integer_power() is not needed yet. */
static struct cell matt_cell(void) {
    struct cell cell = plain_cell(-1);
    cell.material.specular = 0;
    return cell;
}

static bool draw_matt(struct drawing *drawing, struct image *image, struct error *error) {
    const struct cell cell = matt_cell();
    return draw_cells(drawing, image, &cell, 1, 1, 0.8, error);
}

/* The three parts alone, and their sum. */
static void make_parts(struct cell cells[4]) {
    cells[0] = cells[1] = cells[2] = cells[3] = plain_cell(10);
    cells[0].material.diffuse = cells[0].material.specular = 0;
    cells[1].material.ambient = cells[1].material.specular = 0;
    cells[2].material.ambient = cells[2].material.diffuse = 0;
}

/* Four powers of one light, which comes from the side and from behind. */
static void make_shine(struct cell cells[4]) {
    static const int powers[] = {0, 2, 40, 80};
    for (int i = 0; i < 4; i++) {
        cells[i] = plain_cell(powers[i]);
    }
}

/* Phong alone, with the normal map, with the texture, and with both. */
static void make_four(struct cell cells[4]) {
    cells[0] = (struct cell){&plain, plain_material, NULL, NULL};
    cells[1] = (struct cell){&mapped, plain_material, NULL, NULL};
    cells[2] = (struct cell){&textured, textured_material, NULL, NULL};
    cells[3] = (struct cell){&full, textured_material, NULL, NULL};
}

/* By the numbers of scenes with four heads. */
enum { FOUR, PARTS, SHINE };
static void (*const make_heads[])(struct cell cells[4]) = {
    [FOUR] = make_four, [PARTS] = make_parts, [SHINE] = make_shine};

static bool draw_heads(struct drawing *drawing, struct image *image, struct error *error) {
    struct cell cells[4];
    make_heads[drawing->number](cells);
    return draw_cells(drawing, image, cells, 2, 2, 0.8, error);
}

/* Powers 0 to 10 and three large ones; then the textured head with the weight, and with the power,
 * from the specular map. */
static bool draw_powers(struct drawing *drawing, struct image *image, struct error *error) {
    static const int powers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 40, 80};
    struct cell cells[16];
    for (int i = 0; i < 14; i++) {
        cells[i] = plain_cell(powers[i]);
    }
    cells[14] = (struct cell){&weight_mapped, textured_material, NULL, NULL};
    cells[14].material.specular = 1.5; /* times what the map says */
    cells[15] = (struct cell){&power_mapped, textured_material, NULL, NULL};
    return draw_cells(drawing, image, cells, 4, 4, 0.8, error);
}

/* A map of one texel, clamped: nothing is mixed, however it is compiled. */
static bool make_map(struct texture *texture, uint8_t value, struct error *error) {
    const struct image image = {.width = 1, .height = 1, .format = IMAGE_GREY, .pixels = &value};
    bool done = texture_create(texture, &image, error);
    texture_set_clamp(texture, true);
    return done;
}

/* A board of two faces that are far larger than their distance from the eye. Its normal points to
 * where the light is mirrored into the eye. */
static const struct model *near_board(void) {
    static struct vec3 positions[] = {{0.2, -0.75, 0}, {4, -0.75, 0}, {4, 2.5, 0}, {0.2, 2.5, 0}};
    static float normals[][3] = {{0.39f, 0.59f, 0.71f}}, uvs[][2] = {{0, 0}};
    static struct face faces[] = {{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}},
                                  {{{0, 0, 0}, {2, 0, 0}, {3, 0, 0}}}};
    static const struct model board = {
        .positions = positions,
        .position_count = 4,
        .uvs = uvs,
        .uv_count = 1,
        .normals = normals,
        .normal_count = 1,
        .faces = faces,
        .face_count = 2,
    };
    return &board;
}

/* A shoulder so near that its faces are large: with a large power, with the largest power that a
 * map can say, and with the least value that says 2. On the right a board is nearer still. */
static void make_near(struct cell cells[4], const struct texture *map_of_255,
                      const struct texture *map_of_8) {
    cells[0] = plain_cell(200);
    cells[1] = (struct cell){&power_mapped, textured_material, NULL, map_of_255};
    cells[2] = (struct cell){&power_mapped, textured_material, NULL, map_of_8};
    cells[3] = (struct cell){&plain, plain_material, near_board(), NULL};
}

static bool draw_large_faces(struct drawing *drawing, struct image *image, struct error *error) {
    struct texture map_of_255 = {0}, map_of_8 = {0};
    struct cell cells[4];
    make_near(cells, &map_of_255, &map_of_8);
    bool done = make_map(&map_of_255, 255, error) && make_map(&map_of_8, 8, error) &&
                draw_cells(drawing, image, cells, 4, 1, 2.5, error);
    texture_free(&map_of_255);
    texture_free(&map_of_8);
    return done;
}

enum { TURN_FRAMES = 100 };

/* The light goes once around the head. */
static bool draw_turn(struct drawing *drawing, struct image *image, struct error *error) {
    const struct rectangle whole = grid_cell(image->width, image->height, 1, 1, 0);
    const struct vec3 to_light = turning_light((double)drawing->frame / TURN_FRAMES);
    bool done = true;
    pipeline_begin(drawing);
    for (size_t part = 0; drawing_take_part(drawing, part); part++) {
        struct draw_call call = pipeline_call(drawing, whole, 0.85, CULL_BACK);
        struct uniforms u =
            make_uniforms(drawing, 0.85 * whole.width, own_material(drawing, textured_material));
        u.to_light = to_light;
        done = done && draw_part(drawing, &call, &weight_mapped, &u, error);
    }
    return pipeline_end(drawing, done, image, error);
}

/* Beyond the lesson: see BEYOND.md. */
#include "extra_samples.h"
#include "extra_shadow.h"

/* ---- The program ---- */

enum {
    MESH = NEEDS_MODEL | NEEDS_NORMALS,
    MAPPED_MODEL = NEEDS_MODEL | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
    MAPPED_MESH = MAPPED_MODEL | NEEDS_NORMALS,
};

static const struct scene scenes[] = {
    {
        .name = "matt",
        .needs = MESH,
        .width = 600,
        .height = 500,
        .light = {-1, 0.5, 0.4}, /* from the side: a part of what is seen is dark */
        .draw = draw_matt,
    },
    {.name = "parts", .needs = MESH, .number = PARTS, .draw = draw_heads},
    /* What is turned away from this light must not shine. */
    {.name = "shine", .needs = MESH, .number = SHINE, .light = {-1, 0.6, -0.2}, .draw = draw_heads},
    {.name = "four", .needs = MAPPED_MESH, .draw = draw_heads},
    {.name = "behind", .needs = MAPPED_MESH, .light = {-2, 2, -3}, .draw = draw_heads},
    {.name = "powers", .needs = MAPPED_MESH | NEEDS_SPECULAR, .draw = draw_powers},
    {
        .name = "near",
        .detail = true,
        .needs = MAPPED_MESH,
        .width = 1600,
        .height = 400,
        .eye = {0.5, -0.25, 0.35},
        .center = {0.42, -0.5, 0},
        .draw = draw_large_faces,
    },
    {
        .name = "turn",
        .needs = MAPPED_MODEL | NEEDS_SPECULAR,
        .frames = TURN_FRAMES,
        .draw = draw_turn,
    },
    {
        .name = "shadow",
        .extra = true,
        .needs = MAPPED_MESH,
        .light = {-1, 1, 1}, /* the head is between it and a shoulder */
        .draw = draw_shadow,
    },
    {
        .name = "samples",
        .extra = true,
        .needs = MAPPED_MODEL | NEEDS_SPECULAR,
        .draw = draw_samples,
    },
};

static const struct program step10_phong = {
    .name = "step10_phong",
    .summary = "Phong's light at every pixel, normal map, texture, and a turning light",
    .defaults =
        {.width = 800, .height = 800, .eye = {1, 0.5, 3}, .up = {0, 1, 0}, .light = {1, 1, 1}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
    PIPELINE_PROGRAM,
};
