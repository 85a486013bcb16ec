/*
 * Lesson 9, the given part: the pictures of README.md, and the program.
 *
 * A picture is a grid of cells, and each cell shows the model as one shader draws it. In corners of
 * some cells two small faces show what a head has little of: full light, faces that cross each
 * other or reach to the eye, a face drawn twice in two lights.
 */
#include "extra_maps.h"

#include <stdlib.h>

/* What the shaders of the lesson read, for a model that is about so many pixels wide. */
static struct uniforms make_uniforms(const struct drawing *drawing, double pixels) {
    const double one_picture = pixels / fmax(drawing->repeats, 1);
    return (struct uniforms){
        .model = drawing->model,
        .diffuse = drawing->diffuse,
        .normal_map = drawing->normal_map,
        .diffuse_level = texture_wrapped_level(drawing->diffuse, one_picture),
        .normal_level = texture_wrapped_level(drawing->normal_map, one_picture),
        .to_light = vec3_normalized(drawing->light),
    };
}

/* ---- Two faces next to a head ---- */

static float along_z[][3] = {{0, 0, 1}};
static struct face two_faces[] = {{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}},
                                  {{{3, 0, 0}, {4, 0, 0}, {5, 0, 0}}}};

/* A model of two faces, by the positions of their corners. All normals look along z. */
#define TWO_FACES(...)                                                                             \
    {                                                                                              \
        .positions = (struct vec3[6]){__VA_ARGS__}, .position_count = 6, .normals = along_z,       \
        .normal_count = 1, .faces = two_faces, .face_count = 2                                     \
    }

static const struct model full_square =
    TWO_FACES({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
static const struct model left_half =
    TWO_FACES({-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, -1, 0}, {0, 1, 0}, {-1, 1, 0});

/* Where two faces are drawn: a square in the upper left or the upper right corner of cell `i`, in a
 * grid of `side` rows of `side` cells. */
static struct rectangle corner_of(const struct image *image, int side, int i, bool at_right) {
    const struct rectangle cell = grid_cell(image->width, image->height, side, side, i);
    const int most = cell.height / 2, size = cell.width / 10 < most ? cell.width / 10 : most;
    const int margin = size / 2, right = cell.width - margin - size;
    return (struct rectangle){cell.x + (at_right ? right : margin),
                              cell.y + cell.height - margin - size, size, size};
}

/* A call that draws the faces as they are: their positions are NDC. */
static struct draw_call flat_call(const struct model *model, struct rectangle place) {
    return (struct draw_call){model, mat4_identity(), place, CULL_NONE};
}

/* A call that draws the faces in perspective, from the front. */
static struct draw_call near_call(const struct model *model, struct rectangle place) {
    const struct vec3 eye = {0, 0, 1.2}, center = {0, 0, 0}, up = {0, 1, 0};
    return camera_call(model, eye, center, up, 1, place, CULL_NONE);
}

/* ---- Scenes of simple_draw() ---- */

struct simple_cell {
    const struct simple_shader *shader;
    enum cull cull;
    double zoom;
    struct vec3 eye;
};

/* Draw two rows of two cells, the first one top left. */
static bool draw_simple_cells(struct drawing *drawing, struct image *image,
                              const struct simple_cell cells[4]) {
    const struct canvas canvas = {image, drawing->depth};
    for (int i = 0; i < 4; i++) {
        const struct simple_cell *cell = &cells[i];
        struct rectangle place = grid_cell(image->width, image->height, 2, 2, i);
        for (size_t part = 0; drawing_take_part(drawing, part); part++) {
            struct draw_call call = camera_call(drawing->model, cell->eye, drawing->center,
                                                drawing->up, cell->zoom, place, cell->cull);
            struct uniforms u = make_uniforms(drawing, cell->zoom * place.width);
            u.normal_level++; /* not the texture's: exchanged levels show */
            simple_draw(&canvas, &call,
                        cell->shader == &simple_normal_mapped
                            ? simple_mapped_by(drawing->normal_map)
                            : cell->shader,
                        &u);
        }
    }
    return true;
}

/* Draw two faces whose light has just this intensity. */
static void draw_beside(const struct canvas *canvas, struct draw_call call,
                        const struct simple_shader *shader, double intensity) {
    const struct uniforms u = {.model = call.model, .to_light = {0, 0, intensity}};
    simple_draw(canvas, &call, shader, &u);
}

/* Each corner of a face has its own colour: what is in between shows the weights. */
static void corner_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    (void)uniforms, (void)face;
    varyings[0] = varyings[1] = varyings[2] = 0;
    varyings[corner] = 255;
}

static bool corner_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    (void)uniforms;
    *rgb = (struct vec3){varyings[0], varyings[1], varyings[2]};
    return true;
}

static const struct simple_shader simple_corners = {3, corner_vertex, corner_pixel};

/* A triangle that faces us and is larger than its place, and one that lies: it comes from far
 * behind, through the other one. */
static const struct model crossing = TWO_FACES({-3, -2, -0.3}, {4, -2, -0.3}, {-1, 5, -0.3},
                                               {0.9, 3, -9}, {-0.5, -0.5, 0.6}, {0.5, -0.5, 0.6});

/* Two triangles that lean, one to the left and one to the right, and cross near the middle. Their w
 * is 1 everywhere, and says nothing of the depth. */
static const struct model leaning = TWO_FACES({-0.9, -0.9, 0.5}, {0.8, 0, -0.4}, {-0.9, 0.9, 0.5},
                                              {0.9, -0.9, 0.4}, {0.9, 0.9, 0.4}, {-0.8, 0, -0.4});

/* Two triangles, each with a corner just before the eye, where w is 1/240 and 1/1200. */
static const struct model near_eye =
    TWO_FACES({-0.8, -0.8, 0}, {0.8, -0.8, 0}, {0.002, 0.001, 1.195}, {0.8, 0.8, 0}, {-0.8, 0.8, 0},
              {-0.0005, -0.0002, 1.199});

/* In the lower row the left head is so near that perspective is strong, and a shoulder is behind
 * the eye; the right one shows the inside of the back of the head. */
static bool draw_loops_by(const struct simple_shader *corners, struct drawing *drawing,
                          struct image *image) {
    const struct canvas canvas = {image, drawing->depth};
    const struct vec3 eye = drawing->eye, over_the_shoulder = {0.5, -0.2, 0.5};
    const struct simple_cell cells[4] = {{corners, CULL_BACK, 0.8, eye},
                                         {&simple_normals, CULL_BACK, 0.8, eye},
                                         {corners, CULL_BACK, 1.2, over_the_shoulder},
                                         {&simple_normals, CULL_FRONT, 1.15, eye}};
    draw_beside(&canvas, near_call(&crossing, corner_of(image, 2, 0, false)), corners, 1);
    draw_beside(&canvas, flat_call(&leaning, corner_of(image, 2, 0, true)), corners, 1);
    draw_beside(&canvas, near_call(&near_eye, corner_of(image, 2, 3, false)), corners, 1);
    return draw_simple_cells(drawing, image, cells);
}

static bool draw_loops(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    return draw_loops_by(&simple_corners, drawing, image);
}

static bool draw_looks(struct drawing *drawing, struct image *image, struct error *error) {
    const struct vec3 eye = drawing->eye;
    const struct simple_cell cells[4] = {{&simple_flat, CULL_BACK, 0.8, eye},
                                         {&simple_gouraud, CULL_BACK, 0.8, eye},
                                         {&simple_flat_textured, CULL_BACK, 0.8, eye},
                                         {&simple_gouraud_textured, CULL_BACK, 0.8, eye}};
    (void)error;
    return draw_simple_cells(drawing, image, cells);
}

static const struct model lone_triangle = TWO_FACES({-1, -1, 0}, {1, -1, 0}, {1, 1, 0});

/* The last head is seen from where no light falls: what is left is the inside of the lit half. */
static bool draw_more_looks(struct drawing *drawing, struct image *image, struct error *error) {
    const struct canvas canvas = {image, drawing->depth};
    const struct vec3 eye = drawing->eye, from_the_dark_side = {-2.5, 0.5, 1.8};
    const struct simple_cell cells[4] = {{&simple_toon, CULL_BACK, 0.8, eye},
                                         {&simple_normal_mapped, CULL_BACK, 0.8, eye},
                                         {&simple_two_sided, CULL_FRONT, 0.8, eye},
                                         {&simple_lit_only, CULL_NONE, 0.8, from_the_dark_side}};
    (void)error;
    draw_beside(&canvas, flat_call(&full_square, corner_of(image, 2, 0, false)), &simple_toon, 1);
    draw_beside(&canvas, flat_call(&lone_triangle, corner_of(image, 2, 2, false)), &simple_flat, 1);
    draw_beside(&canvas, flat_call(&lone_triangle, corner_of(image, 2, 2, true)), &simple_flat,
                0.4);
    draw_beside(&canvas, flat_call(&left_half, corner_of(image, 2, 3, false)), &simple_toon, 1);
    return draw_simple_cells(drawing, image, cells);
}

/* ---- Scenes of the pipeline ---- */

/* One cell of a picture. */
struct cell {
    const struct shader *shader;
    enum cull cull;
};

/* Record `side` rows of `side` cells, the first one top left. */
static bool record_cells(struct drawing *drawing, const struct image *image,
                         const struct cell *cells, int side, double zoom, struct error *error) {
    bool done = true;
    for (int i = 0; done && i < side * side; i++) {
        struct rectangle place = grid_cell(image->width, image->height, side, side, i);
        for (size_t part = 0; drawing_take_part(drawing, part); part++) {
            struct draw_call call = pipeline_call(drawing, place, zoom, cells[i].cull);
            struct uniforms u = make_uniforms(drawing, zoom * place.width);
            done =
                done && pipeline_draw(drawing->state, &call, cells[i].shader, &u, sizeof u, error);
        }
    }
    return done;
}

/* Record two faces in full light. */
static bool record_beside(struct drawing *drawing, struct draw_call call,
                          const struct shader *shader, struct error *error) {
    const struct uniforms u = {.model = call.model, .to_light = {0, 0, 1}};
    return pipeline_draw(drawing->state, &call, shader, &u, sizeof u, error);
}

static const struct cell four_cells[] = {{&flat, CULL_BACK},
                                         {&gouraud, CULL_BACK},
                                         {&flat_textured, CULL_BACK},
                                         {&gouraud_textured, CULL_BACK}};

static bool draw_four(struct drawing *drawing, struct image *image, struct error *error) {
    pipeline_begin(drawing);
    bool done = record_cells(drawing, image, four_cells, 2, 0.8, error);
    return pipeline_end(drawing, done, image, error);
}

static bool draw_toon(struct drawing *drawing, struct image *image, struct error *error) {
    const struct cell cell = {&toon, CULL_BACK};
    const struct rectangle corner = corner_of(image, 1, 0, false);
    pipeline_begin(drawing);
    bool done = record_cells(drawing, image, &cell, 1, 0.85, error) &&
                record_beside(drawing, flat_call(&full_square, corner), &toon, error);
    return pipeline_end(drawing, done, image, error);
}

/* Draw the head, and once more small in the corner, where the maps are read at other levels. */
static bool draw_normal_map(struct drawing *drawing, struct image *image, struct error *error) {
    struct pipeline *pipeline = pipeline_begin(drawing);
    const struct rectangle place = grid_cell(image->width, image->height, 1, 1, 0);
    const struct rectangle corner = corner_of(image, 1, 0, false);
    bool done = true;
    for (size_t part = 0; drawing_take_part(drawing, part); part++) {
        const struct shader *shader = mapped_by(drawing->normal_map);
        struct draw_call call = pipeline_call(drawing, place, 0.85, CULL_BACK);
        struct draw_call small_call = pipeline_call(drawing, corner, 1, CULL_BACK);
        struct uniforms u = make_uniforms(drawing, 0.85 * place.width);
        struct uniforms small = make_uniforms(drawing, corner.width);
        small.diffuse_level++; /* exchanged levels show */
        done = done && pipeline_draw(pipeline, &call, shader, &u, sizeof u, error) &&
               pipeline_draw(pipeline, &small_call, shader, &small, sizeof small, error);
    }
    return pipeline_end(drawing, done, image, error);
}

/* In the upper row, the head without the faces that turn away from the camera, and without those
 * that turn towards it. In the lower row, all faces (the first picture again, with more work), and
 * those that the light culls. */
static bool draw_culling(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct cell cells[] = {{&two_sided, CULL_BACK},
                                        {&two_sided, CULL_FRONT},
                                        {&two_sided, CULL_NONE},
                                        {&culled_by_light, CULL_NONE}};
    const struct rectangle corner = corner_of(image, 2, 3, false);
    pipeline_begin(drawing);
    bool done = record_cells(drawing, image, cells, 2, 0.85, error) &&
                record_beside(drawing, flat_call(&left_half, corner), &two_sided, error);
    return pipeline_end(drawing, done, image, error);
}

/* ---- Four heads, in four ways ---- */

enum { HEADS = 4, BAND_ROWS = 32 };

enum way { WAY_SIMPLE = 1, WAY_VISIBLE, WAY_BANDS, WAY_PIPELINE };

static const struct scene_value way_value[] = {
    {"way", "1 simple_draw(), 2 visible_draw(), 3 in bands, 4 the pipeline", 1, 4, 1, 3},
    {.name = NULL},
};

/* Call for the heads one behind another, the farthest first. */
static void make_head_calls(const struct drawing *drawing, const struct image *image, double zoom,
                            struct draw_call calls[HEADS]) {
    const struct vec3 behind = {-0.62, 0.06, -0.6}; /* from head to head */
    const struct rectangle whole = grid_cell(image->width, image->height, 1, 1, 0);
    for (int i = 0; i < HEADS; i++) {
        struct mat4 moved =
            mat4_translation(vec3_add((struct vec3){0, 0.27, 0}, vec3_scale(behind, 2 - i)));
        calls[i] = pipeline_call(drawing, whole, zoom, CULL_BACK);
        calls[i].to_clip = mat4_mul(calls[i].to_clip, moved);
    }
}

/* Draw the heads by visible_draw(), with the memory that it needs. */
static bool draw_heads_visibly(const struct canvas *canvas, const struct draw_call calls[HEADS],
                               int band_rows, const struct uniforms *u, struct error *error) {
    const size_t pixels = canvas->image->width * canvas->image->height;
    struct kept_face *kept = malloc((HEADS * u->model->face_count + 1) * sizeof *kept);
    struct band band = {
        {0, band_rows}, canvas->image->width, canvas->depth, malloc(pixels * sizeof *band.nearest)};
    bool done = (kept != NULL && band.nearest != NULL) || error_out_of_memory(error);
    size_t count = 0;
    for (int i = 0; done && i < HEADS; i++) {
        count += keep_faces(canvas, &calls[i], kept + count);
    }
    if (done) {
        visible_draw(canvas, band, kept, (uint32_t)count, &simple_gouraud_textured, u);
    }
    if (count > 0) { /* the depths are those of the last band, which may be empty */
        canvas->depth[0] = 0;
    }
    free(band.nearest);
    free(kept);
    return done;
}

static bool draw_heads(struct drawing *drawing, struct image *image, struct error *error) {
    const enum way way = (enum way)drawing_value(drawing, "way");
    const struct canvas canvas = {image, drawing->depth};
    const struct uniforms u = make_uniforms(drawing, 0.85 * (double)image->width);
    struct draw_call calls[HEADS];
    make_head_calls(drawing, image, 0.68, calls);
    if (way == WAY_VISIBLE || way == WAY_BANDS) {
        const int rows = way == WAY_BANDS ? BAND_ROWS : (int)image->height;
        return draw_heads_visibly(&canvas, calls, rows, &u, error);
    }
    struct pipeline *pipeline = pipeline_begin(drawing);
    bool done = true;
    for (int i = 0; done && i < HEADS; i++) {
        if (way == WAY_SIMPLE) {
            simple_draw(&canvas, &calls[i], &simple_gouraud_textured, &u);
        } else {
            done = pipeline_draw(pipeline, &calls[i], &gouraud_textured, &u, sizeof u, error);
        }
    }
    return way == WAY_SIMPLE || pipeline_end(drawing, done, image, error);
}

/* ---- The program ---- */

enum {
    MESH = NEEDS_MODEL | NEEDS_NORMALS,
    TEXTURED_MESH = MESH | NEEDS_DIFFUSE,
};

static const struct scene scenes[] = {
    /* Cells of odd sizes, which differ: exchanged or halved, they show. */
    {.name = "loops", .needs = MESH | NEEDS_DEPTH, .width = 806, .height = 662, .draw = draw_loops},
    {.name = "looks", .needs = TEXTURED_MESH | NEEDS_DEPTH, .draw = draw_looks},
    {
        .name = "more_looks",
        .needs = TEXTURED_MESH | NEEDS_NORMAL_MAP | NEEDS_DEPTH,
        .light = {1, 0.2, 0.5}, /* from the side; x, y, z all differ */
        .draw = draw_more_looks,
    },
    {.name = "four", .needs = TEXTURED_MESH, .draw = draw_four},
    {.name = "toon", .needs = MESH, .draw = draw_toon},
    {
        .name = "normalmap",
        .needs = NEEDS_MODEL | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
        .light = {1, 0.2, 0.5},
        .draw = draw_normal_map,
    },
    {.name = "culling", .needs = NEEDS_MODEL, .light = {1, 0.2, 0}, .draw = draw_culling},
    {
        .name = "heads",
        .needs = TEXTURED_MESH | NEEDS_DEPTH,
        .height = 790, /* the last band is lower than the others */
        .values = way_value,
        .draw = draw_heads,
    },
};

static const struct program step09_shaders = {
    .name = "step09_shaders",
    .summary = "one pipeline, many looks: shaders",
    .defaults =
        {.width = 800, .height = 800, .eye = {1, 0.5, 3}, .up = {0, 1, 0}, .light = {1, 1, 1}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
    PIPELINE_PROGRAM,
};
