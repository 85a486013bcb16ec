/*
 * Lesson 10, the given part: its scenes and the program.
 *
 * A scene is a square of cells, and in each cell the model as one shader draws it, with a material.
 */
#include "extra_probe.h"
#include "extra_tangent.h"

#include <stdlib.h>
#include <string.h>

/* ---- Drawing ---- */

static const struct material plain_material = {0.1, 1, 0.5, 10, {255, 128, 255}};
static const struct material textured_material = {0.1, 1, 1, 10, {255, 255, 255}};

/* What the shaders of the lesson read, for a model that is seen over so many pixels. */
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

/* The shader; for a model without normal map one that draws by the mesh's normals, and for a map in
 * tangent space one that reads it so. */
static const struct shader *drawn_by(const struct drawing *drawing, const struct shader *shader) {
    if (drawing->normal_map != NULL && drawing->normal_map->tangent_space) {
        return in_tangent_space(shader);
    }
    if (drawing->normal_map != NULL || shader == &plain) {
        return shader;
    }
    return shader == &mapped ? &plain : &textured;
}

/* ---- Materials whose ambient light has colours of its own: see MORE.md ---- */

/* What a shader of the lesson reads, to draw without ambient light, and the light on top of it. */
struct ambient_uniforms {
    struct uniforms without;
    const struct shader *shader;
    const struct texture *colors;
    double weight;
};

static void ambient_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct ambient_uniforms *a = uniforms;
    memset(varyings, 0, (5 + TANGENT_VARYINGS) * sizeof *varyings);
    a->shader->vertex(&a->without, face, corner, varyings);
}

static lanes_mask ambient_fragment(const void *uniforms, const lanes *varyings,
                                   lanes_texel *color) {
    const struct ambient_uniforms *a = uniforms;
    const lanes weight = lanes_all((real)a->weight);
    struct lanes3 light = texture_lanes(a->colors, uv_of(varyings), a->without.diffuse_level);
    a->shader->fragment(&a->without, varyings, color);
    *color = lanes_rgb(lanes_from_int((lanes_int)(*color >> 16 & 255)) + weight * light.x,
                       lanes_from_int((lanes_int)(*color >> 8 & 255)) + weight * light.y,
                       lanes_from_int((lanes_int)(*color & 255)) + weight * light.z);
    return lanes_all_set();
}

static const struct shader own_ambient = {
    .varying_count = 5 + TANGENT_VARYINGS, .vertex = ambient_vertex, .fragment = ambient_fragment};

/* Record a call with a shader of the lesson, as the drawing's material and maps want it. */
static bool draw_part(struct drawing *drawing, const struct draw_call *call,
                      const struct shader *shader, const struct uniforms *u, struct error *error) {
    const struct shader *drawn = drawn_by(drawing, shader);
    if (drawing->ambient == NULL || shader == &plain || shader == &mapped) {
        return pipeline_draw(drawing->state, call, drawn, u, sizeof *u, error);
    }
    struct ambient_uniforms own = {*u, drawn, drawing->ambient, u->material.ambient};
    own.without.material.ambient = 0;
    return pipeline_draw(drawing->state, call, &own_ambient, &own, sizeof own, error);
}

/* One cell of a picture. */
struct cell {
    const struct shader *shader;
    struct material material;
    const struct model *model;      /* NULL: the drawing's */
    const struct texture *specular; /* NULL: the drawing's */
};

/* What a part's own material says, instead of the lesson's. */
static struct material own_material(const struct drawing *drawing, struct material material) {
    const double most = 200;
    if (drawing->parts != NULL && drawing->specular_weight >= 0) {
        material.specular *= drawing->specular_weight;
    }
    if (drawing->parts != NULL && drawing->power > 0) {
        material.power = (int)fmax(1, fmin(drawing->power, most));
    }
    return material;
}

/* Record the drawing's model, or a part of it, as one cell has it. */
static bool record_cell(struct drawing *drawing, const struct image *image, const struct cell *cell,
                        struct rectangle place, double zoom, struct error *error) {
    struct draw_call call = pipeline_call(drawing, place, zoom, CULL_BACK);
    bool textured_cell = cell->shader != &plain && cell->shader != &mapped;
    struct uniforms u =
        make_uniforms(drawing, zoom * place.width,
                      textured_cell ? own_material(drawing, cell->material) : cell->material);
    if (cell->model != NULL) {
        call.model = u.model = cell->model;
    }
    if (cell->shader == &weight_mapped || cell->shader == &power_mapped) {
        u.normal_level += 1; /* three different levels: exchanged, they show */
        u.specular_level += 2;
    }
    if (cell->specular != NULL) {
        u.specular = cell->specular;
        u.specular_level = 0;
    }
    note_light(drawing, image, &call, &u);
    return draw_part(drawing, &call, cell->shader, &u, error);
}

/* Draw rows of cells, the first one top left. */
static bool draw_cells(struct drawing *drawing, struct image *image, const struct cell *cells,
                       int columns, int rows, double zoom, struct error *error) {
    bool done = true;
    pipeline_begin(drawing);
    for (int i = 0; done && i < columns * rows; i++) {
        struct rectangle place = grid_cell(image->width, image->height, columns, rows, i);
        for (size_t part = 0; drawing_take_part(drawing, part); part++) {
            done = done && record_cell(drawing, image, &cells[i], place, zoom, error);
        }
    }
    return pipeline_end(drawing, done, image, error);
}

/* ---- Scenes ---- */

/* The model with normals a quarter, once and 4 times as long: a file may give them so. (Products
 * with these are exact: normalised, each is what it was.) Free its normals. */
static bool stretch_normals(struct model *stretched, const struct model *model,
                            struct error *error) {
    static const float factor[] = {0.25f, 1, 4};
    *stretched = *model;
    stretched->normals = malloc(model->normal_count * sizeof *stretched->normals);
    if (stretched->normals == NULL) {
        return error_out_of_memory(error);
    }
    for (size_t i = 0; i < model->normal_count; i++) {
        for (size_t k = 0; k < 3; k++) {
            stretched->normals[i][k] = model->normals[i][k] * factor[i % 3];
        }
    }
    return true;
}

/* Ambient and diffuse light: nothing shines. */
static bool draw_matt(struct drawing *drawing, struct image *image, struct error *error) {
    struct model stretched;
    struct cell cell = {&plain, plain_material, &stretched, NULL};
    cell.material.specular = 0;
    cell.material.power = -1; /* so that integer_power() is not needed yet */
    if (!stretch_normals(&stretched, drawing->model, error)) {
        return false;
    }
    bool done = draw_cells(drawing, image, &cell, 1, 1, 0.8, error);
    free(stretched.normals);
    return done;
}

/* The three parts alone, and their sum. */
static bool draw_parts(struct drawing *drawing, struct image *image, struct error *error) {
    struct cell cells[4];
    for (int i = 0; i < 4; i++) {
        cells[i] = (struct cell){&plain, plain_material, NULL, NULL};
    }
    cells[0].material.diffuse = cells[0].material.specular = 0;
    cells[1].material.ambient = cells[1].material.specular = 0;
    cells[2].material.ambient = cells[2].material.diffuse = 0;
    return draw_cells(drawing, image, cells, 2, 2, 0.8, error);
}

/* A cell for each of these powers. */
static void make_power_cells(struct cell *cells, const int *powers, int count) {
    for (int i = 0; i < count; i++) {
        cells[i] = (struct cell){&plain, plain_material, NULL, NULL};
        cells[i].material.power = powers[i];
    }
}

/* Four powers of one light, which comes from the side and from behind. */
static bool draw_shine(struct drawing *drawing, struct image *image, struct error *error) {
    struct cell cells[4];
    make_power_cells(cells, (const int[]){0, 2, 40, 80}, 4);
    return draw_cells(drawing, image, cells, 2, 2, 0.8, error);
}

static const struct scene_value light_values[] = {
    {"shader", "0 all four, 1 plain, 2 normal map, 3 texture, 4 both", 0, 4, 1, 0},
    {"ambient", "weight of the ambient light", 0, 1, 0.01, 0.1},
    {"diffuse", "weight of the diffuse light", 0, 2, 0.01, 1},
    {"specular", "times as much specular light", 0, 3, 0.01, 1},
    {"power", "power of the specular light", 0, 200, 1, 10},
    {.name = NULL},
};

/* The material, with the drawing's numbers for it. */
static struct material chosen_material(const struct drawing *drawing, struct material material) {
    material.ambient = drawing_value(drawing, "ambient");
    material.diffuse = drawing_value(drawing, "diffuse");
    material.specular *= drawing_value(drawing, "specular");
    material.power = (int)drawing_value(drawing, "power");
    return material;
}

/* Phong alone, with the normal map, with the texture, and with both. */
static bool draw_four(struct drawing *drawing, struct image *image, struct error *error) {
    const struct material white = chosen_material(drawing, plain_material);
    const struct material colored = chosen_material(drawing, textured_material);
    const struct cell cells[] = {{&plain, white, NULL, NULL},
                                 {&mapped, white, NULL, NULL},
                                 {&textured, colored, NULL, NULL},
                                 {&full, colored, NULL, NULL}};
    const int one = (int)drawing_value(drawing, "shader");
    return one > 0 ? draw_cells(drawing, image, &cells[one - 1], 1, 1, 0.8, error)
                   : draw_cells(drawing, image, cells, 2, 2, 0.8, error); /* 0.4 of the picture */
}

/* Powers 0 to 10 and three large ones; then the textured head with the weight, and with the power,
 * from the specular map. */
static bool draw_powers(struct drawing *drawing, struct image *image, struct error *error) {
    static const int powers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 40, 80};
    struct cell cells[16];
    make_power_cells(cells, powers, 14);
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

/* A shoulder, so near that its faces are large: with a large power, with the largest power that a
 * map can say, and with the least value that says 2. On the right a board that is nearer still. */
static bool draw_large_faces(struct drawing *drawing, struct image *image, struct error *error) {
    struct texture map_of_255 = {0}, map_of_8 = {0};
    struct cell cells[] = {{&plain, plain_material, NULL, NULL},
                           {&power_mapped, textured_material, NULL, &map_of_255},
                           {&power_mapped, textured_material, NULL, &map_of_8},
                           {&plain, plain_material, near_board(), NULL}};
    cells[0].material.power = 200;
    bool done = make_map(&map_of_255, 255, error) && make_map(&map_of_8, 8, error) &&
                draw_cells(drawing, image, cells, 4, 1, 2.5, error);
    texture_free(&map_of_255);
    texture_free(&map_of_8);
    return done;
}

enum { TURN_FRAMES = 100 };

/* The light goes once around the head. For each frame it is asked for another place first: it must
 * not count how often it is asked. */
static bool draw_turn(struct drawing *drawing, struct image *image, struct error *error) {
    struct rectangle whole = grid_cell(image->width, image->height, 1, 1, 0);
    bool done = true;
    pipeline_begin(drawing);
    (void)turning_light(0.5);
    struct vec3 to_light = turning_light((double)drawing->frame / TURN_FRAMES);
    for (size_t part = 0; drawing_take_part(drawing, part); part++) {
        struct draw_call call = pipeline_call(drawing, whole, 0.85, CULL_BACK);
        struct uniforms u =
            make_uniforms(drawing, 0.85 * whole.width, own_material(drawing, textured_material));
        u.to_light = to_light;
        done = done && draw_part(drawing, &call, &weight_mapped, &u, error);
    }
    return pipeline_end(drawing, done, image, error);
}

/* ---- Beyond the lesson: see BEYOND.md ---- */

#include "extra_samples.h"
#include "extra_shadow.h"

/* ---- The program ---- */

static const struct scene scenes[] = {
    {
        .name = "matt",
        .needs = NEEDS_MODEL | NEEDS_NORMALS,
        .width = 600,
        .height = 500,
        .light = {-1, 0.5, 0.4}, /* from the side: a part of what is seen is dark */
        .draw = draw_matt,
    },
    {.name = "parts", .needs = NEEDS_MODEL | NEEDS_NORMALS, .draw = draw_parts},
    {
        .name = "shine",
        .needs = NEEDS_MODEL | NEEDS_NORMALS,
        .light = {-1, 0.6, -0.2}, /* what is turned away from it must not shine */
        .draw = draw_shine,
    },
    {
        .name = "four",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
        .values = light_values,
        .draw = draw_four,
    },
    {
        .name = "behind",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
        .light = {-2, 2, -3},
        .values = light_values,
        .draw = draw_four,
    },
    {
        .name = "powers",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP | NEEDS_SPECULAR,
        .draw = draw_powers,
    },
    {
        .name = "near",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
        .width = 1600,
        .height = 400,
        .eye = {0.5, -0.25, 0.35},
        .center = {0.42, -0.5, 0},
        .light = {1, 1, 1},
        .draw = draw_large_faces,
    },
    {
        .name = "turn",
        .needs = NEEDS_MODEL | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP | NEEDS_SPECULAR,
        .frames = TURN_FRAMES,
        .draw = draw_turn,
    },
    {
        .name = "wide",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
        .width = 203,
        .height = 67,
        .values = light_values,
        .draw = draw_four,
    },
    {
        .name = "high",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
        .width = 61,
        .height = 181,
        .values = light_values,
        .draw = draw_four,
    },
    {
        .name = "small",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS,
        .width = 23,
        .height = 13,
        .light = {-1, 0.5, 0.4},
        .draw = draw_matt,
    },
    {
        .name = "one_pixel",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS,
        .width = 1,
        .height = 1,
        .draw = draw_matt,
    },
    {
        .name = "shadow",
        .extra = true,
        .needs = NEEDS_MODEL | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
        .light = {-1, 1, 1}, /* the head is between it and a shoulder */
        .draw = draw_shadow,
    },
    {
        .name = "samples",
        .extra = true,
        .needs = NEEDS_MODEL | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP | NEEDS_SPECULAR,
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
