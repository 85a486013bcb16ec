/*
 * Lesson 9, the given part: its scenes and the program.
 *
 * A scene is a grid of cells, and in each cell the model as one shader draws it. `loops`, `looks`
 * and `more_looks` are drawn by simple_draw(), `heads` by visible_draw(), the others by the
 * pipeline: `four`, `toon` and `normalmap` show shaders, `culling` which faces may be left out.
 */

#include "extra_looks.h"

/* The shader for a normal map, as it is, or for a model that has none. */
static const struct shader *mapped_by(const struct texture *normal_map) {
    return normal_map == NULL          ? &gouraud_textured
           : normal_map->tangent_space ? &tangent_mapped
                                       : &normal_mapped;
}

/* ---- Drawing ---- */

/* What the shaders of the lesson read, for a model that is seen over so many pixels. */
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

/* One cell of a picture. */
struct cell {
    const struct shader *shader;
    enum cull cull;
};

/* Record `side` rows of `side` cells, the first one top left. */
static bool record_cells(struct drawing *drawing, struct pipeline *pipeline,
                         const struct image *image, const struct cell *cells, int side, double zoom,
                         struct error *error) {
    bool done = true;
    for (int i = 0; done && i < side * side; i++) {
        struct rectangle place = grid_cell(image->width, image->height, side, side, i);
        for (size_t part = 0; drawing_take_part(drawing, part); part++) {
            struct draw_call call = pipeline_call(drawing, place, zoom, cells[i].cull);
            struct uniforms u = make_uniforms(drawing, zoom * place.width);
            done = done && pipeline_draw(pipeline, &call, cells[i].shader, &u, sizeof u, error);
        }
    }
    return done;
}

static bool draw_cells(struct drawing *drawing, struct image *image, const struct cell *cells,
                       int side, double zoom, struct error *error) {
    struct pipeline *pipeline = pipeline_begin(drawing);
    bool done = record_cells(drawing, pipeline, image, cells, side, zoom, error);
    return pipeline_end(drawing, done, image, error);
}

/* ---- Two faces next to a head ---- */

/* A model of two faces, and what shaders read of it. */
struct pair {
    struct vec3 positions[6];
    float normals[1][3];
    struct face faces[2];
    struct model model; /* of these */
    struct uniforms uniforms;
};

/* Normals and light have the same direction: the intensity is exactly 1. */
static void pair_create(struct pair *pair, const struct vec3 positions[2][3]) {
    *pair = (struct pair){
        .normals = {{0, 0, 1}},
        .uniforms = {.model = &pair->model, .to_light = {0, 0, 1}},
    };
    for (uint32_t i = 0; i < 6; i++) {
        pair->positions[i] = positions[i / 3][i % 3];
        pair->faces[i / 3].corner[i % 3] = (struct corner){.position = i};
    }
    pair->model = (struct model){
        .position_count = 6,
        .positions = pair->positions,
        .normal_count = 1,
        .normals = pair->normals,
        .face_count = 2,
        .faces = pair->faces,
    };
}

/* A square in the upper left or the upper right corner of a cell, which lies half as far from the
 * cell's edges as its side is long. */
static struct rectangle corner_of(struct rectangle cell, bool at_right) {
    const int most = cell.height / 2, size = cell.width / 10 < most ? cell.width / 10 : most;
    const int margin = size / 2, right = cell.width - margin - size;
    return (struct rectangle){cell.x + (at_right ? right : margin),
                              cell.y + cell.height - margin - size, size, size};
}

/* Two faces in such a corner. In the parallel view their corners are given in NDC. */
struct beside {
    bool in_perspective, at_right;
    struct vec3 positions[2][3];
};

/* A square that fills the corner. */
static const struct beside full_square = {
    .positions = {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}, {{-1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}},
};

/* Two triangles of which a corner is too far for the screen: nothing of them is drawn. */
static const struct beside too_far = {
    .positions = {{{1, -1, 0}, {-1, 1, 0}, {-1, -1e9, 0}}, {{1e9, 1, 0}, {-1, 1, 0}, {1, -1, 0}}},
};

/* In the parallel view two triangles that lean, one to the left and one to the right: they cross
 * near the middle. There w is 1 everywhere, and says nothing of the depth. */
static const struct beside leaning = {
    .at_right = true,
    .positions = {{{-0.9, -0.9, 0.5}, {0.8, 0, -0.4}, {-0.9, 0.9, 0.5}},
                  {{0.9, -0.9, 0.4}, {0.9, 0.9, 0.4}, {-0.8, 0, -0.4}}},
};

/* A triangle that faces us and is larger than the corner, and one that lies: it comes from far
 * behind, through the other one. */
static const struct beside crossing = {
    .in_perspective = true,
    .positions = {{{-3, -2, -0.3}, {4, -2, -0.3}, {-1, 5, -0.3}},
                  {{0.9, 3, -9}, {-0.5, -0.5, 0.6}, {0.5, -0.5, 0.6}}},
};

/* Two triangles, each with a corner just before the eye, where w is 1/240 and 1/1200. */
static const struct beside near_eye = {
    .in_perspective = true,
    .positions = {{{-0.8, -0.8, 0}, {0.8, -0.8, 0}, {0.002, 0.001, 1.195}},
                  {{0.8, 0.8, 0}, {-0.8, 0.8, 0}, {-0.0005, -0.0002, 1.199}}},
};

static struct draw_call beside_call(struct pair *pair, const struct beside *faces,
                                    struct rectangle cell) {
    const struct vec3 eye = {0, 0, 1.2}, center = {0, 0, 0}, up = {0, 1, 0};
    pair_create(pair, faces->positions);
    struct draw_call call =
        camera_call(&pair->model, eye, center, up, 1, corner_of(cell, faces->at_right), CULL_NONE);
    call.to_clip = faces->in_perspective ? call.to_clip : mat4_identity();
    return call;
}

/* A square nearer than the full one, and to its right: half of that is covered. The intensity is
 * not 0, but so small that it is rounded to black. */
static struct draw_call dim_call(struct pair *dim, struct rectangle cell) {
    struct draw_call call = beside_call(dim, &full_square, cell);
    call.to_clip = mat4_translation((struct vec3){1, 0, 0.5});
    for (int i = 0; i < 16; i++) { /* the same places, with a w of 0.5: nearer by that, too */
        call.to_clip.m[i / 4][i % 4] *= 0.5;
    }
    dim->uniforms.to_light = (struct vec3){0, 0, 0.001};
    return call;
}

/* ---- Scenes of simple_draw() ---- */

/* Each corner of a face has its own colour: what is in between shows the weights. The colour is
 * in the first three varyings and in the last three of as many as there may be. The last ones are
 * read: they are black where only some varyings are interpolated. */
static void corner_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    (void)uniforms, (void)face;
    for (size_t i = 0; i < VARYING_LIMIT; i++) {
        varyings[i] = 0;
    }
    varyings[corner] = varyings[VARYING_LIMIT - 3 + corner] = 255;
}

static bool corner_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    const double *last = varyings + VARYING_LIMIT - 3;
    (void)uniforms;
    *rgb = (struct vec3){last[0], last[1], last[2]};
    return true;
}

static const struct simple_shader simple_corners = {VARYING_LIMIT, corner_vertex, corner_pixel};

/* One cell of such a picture. */
struct simple_cell {
    const struct simple_shader *shader;
    enum cull cull;
    double zoom;
    struct vec3 eye; /* zero: that of the drawing */
};

static void draw_simple_cell(const struct drawing *drawing, const struct canvas *canvas,
                             const struct simple_cell *cell, struct rectangle place) {
    bool has_eye = vec3_dot(cell->eye, cell->eye) > 0;
    struct draw_call call =
        camera_call(drawing->model, has_eye ? cell->eye : drawing->eye, drawing->center,
                    drawing->up, cell->zoom, place, cell->cull);
    struct uniforms u = make_uniforms(drawing, cell->zoom * place.width);
    u.normal_level++; /* not the texture's: exchanged levels show */
    const struct texture *map = drawing->normal_map;
    const struct simple_shader *shader = cell->shader != &simple_normal_mapped ? cell->shader
                                         : map == NULL        ? &simple_gouraud_textured
                                         : map->tangent_space ? &simple_tangent_mapped
                                                              : cell->shader;
    simple_draw(canvas, &call, shader, &u);
}

/* Draw two rows of two cells, the first one top left. */
static bool draw_simple_cells(struct drawing *drawing, struct image *image,
                              const struct simple_cell cells[4]) {
    const struct canvas canvas = {image, drawing->depth};
    for (int i = 0; i < 4; i++) {
        struct rectangle place = grid_cell(image->width, image->height, 2, 2, i);
        for (size_t part = 0; drawing_take_part(drawing, part); part++) {
            draw_simple_cell(drawing, &canvas, &cells[i], place);
        }
    }
    return true;
}

/* Above: the corners, and next to the head two triangles that cross, at the left in perspective and
 * at the right in the parallel view; the normals, and two triangles that reach too far. Below: the
 * corners from so near that perspective is strong, and a shoulder is behind the eye; the inside of
 * the back of the head, and two triangles that reach to the eye. */
static bool draw_loops(struct drawing *drawing, struct image *image, struct error *error) {
    const struct vec3 over_the_shoulder = {0.5, -0.2, 0.5};
    const struct simple_cell cells[4] = {{&simple_corners, CULL_BACK, 0.8, {0, 0, 0}},
                                         {&simple_normals, CULL_BACK, 0.8, {0, 0, 0}},
                                         {&simple_corners, CULL_BACK, 1.2, over_the_shoulder},
                                         {&simple_normals, CULL_FRONT, 1.15, {0, 0, 0}}};
    static const struct {
        const struct beside *faces;
        const struct simple_shader *shader;
        int cell;
    } beside[] = {
        {&crossing, &simple_corners, 0},
        {&crossing, &simple_normals, 0}, /* what is no nearer than what is there stays hidden */
        {&leaning, &simple_corners, 0},
        {&too_far, &simple_corners, 1},
        {&near_eye, &simple_corners, 3},
    };
    const struct canvas canvas = {image, drawing->depth};
    (void)error;
    for (size_t i = 0; i < sizeof beside / sizeof beside[0]; i++) {
        struct pair pair;
        struct draw_call call = beside_call(
            &pair, beside[i].faces, grid_cell(image->width, image->height, 2, 2, beside[i].cell));
        simple_draw(&canvas, &call, beside[i].shader, &pair.uniforms);
    }
    return draw_simple_cells(drawing, image, cells);
}

static bool draw_looks(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct simple_cell cells[4] = {
        {&simple_flat, CULL_BACK, 0.8, {0, 0, 0}},
        {&simple_gouraud, CULL_BACK, 0.8, {0, 0, 0}},
        {&simple_flat_textured, CULL_BACK, 0.8, {0, 0, 0}},
        {&simple_gouraud_textured, CULL_BACK, 0.8, {0, 0, 0}}};
    (void)error;
    return draw_simple_cells(drawing, image, cells);
}

/* One triangle at both sides of a cell, in two lights: what a shader found for a face must not be
 * kept for the next drawing. */
static void draw_in_two_lights(const struct canvas *canvas, struct rectangle cell) {
    struct pair triangle;
    struct draw_call call = beside_call(&triangle, &full_square, cell);
    triangle.model.face_count = 1;
    simple_draw(canvas, &call, &simple_flat, &triangle.uniforms);
    call.viewport = corner_of(cell, true);
    triangle.uniforms.to_light = (struct vec3){0, 0, 0.4};
    simple_draw(canvas, &call, &simple_flat, &triangle.uniforms);
}

/* The first one has a square in full light next to it, the third one a triangle in two lights. The
 * last one is seen from where no light falls: what is left is the inside of the lit half; next to
 * it, a square that gets next to none. */
static bool draw_more_looks(struct drawing *drawing, struct image *image, struct error *error) {
    const struct vec3 from_the_dark_side = {-2.5, 0.5, 1.8};
    const struct simple_cell cells[4] = {{&simple_toon, CULL_BACK, 0.8, {0, 0, 0}},
                                         {&simple_normal_mapped, CULL_BACK, 0.8, {0, 0, 0}},
                                         {&simple_two_sided, CULL_FRONT, 0.8, {0, 0, 0}},
                                         {&simple_lit_only, CULL_NONE, 0.8, from_the_dark_side}};
    const struct canvas canvas = {image, drawing->depth};
    struct pair square;
    (void)error;
    struct draw_call call =
        beside_call(&square, &full_square, grid_cell(image->width, image->height, 2, 2, 0));
    simple_draw(&canvas, &call, &simple_toon, &square.uniforms);
    draw_in_two_lights(&canvas, grid_cell(image->width, image->height, 2, 2, 2));
    struct pair dim;
    const struct rectangle last = grid_cell(image->width, image->height, 2, 2, 3);
    struct draw_call lit_call = beside_call(&square, &full_square, last),
                     over_call = dim_call(&dim, last);
    simple_draw(&canvas, &lit_call, &simple_toon, &square.uniforms);
    simple_draw(&canvas, &over_call, &simple_lit_only, &dim.uniforms);
    return draw_simple_cells(drawing, image, cells);
}

/* ---- Scenes of the pipeline ---- */

static const struct scene_value four_values[] = {
    {"shader", "0 all four, 1 flat, 2 Gouraud, 3 flat textured, 4 Gouraud textured", 0, 4, 1, 0},
    {.name = NULL},
};

static bool draw_four(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct cell cells[] = {{&flat, CULL_BACK},
                                        {&gouraud, CULL_BACK},
                                        {&flat_textured, CULL_BACK},
                                        {&gouraud_textured, CULL_BACK}};
    const int one = (int)drawing_value(drawing, "shader");
    return one > 0 ? draw_cells(drawing, image, &cells[one - 1], 1, 0.8, error)
                   : draw_cells(drawing, image, cells, 2, 0.8, error); /* 0.4 of the picture */
}

static const struct scene_value toon_values[] = {
    {"steps", "steps of the light", 2, 16, 1, 5},
    {.name = NULL},
};

/* With a square in full light next to it. */
static bool draw_toon(struct drawing *drawing, struct image *image, struct error *error) {
    struct pipeline *pipeline = pipeline_begin(drawing);
    const struct rectangle place = grid_cell(image->width, image->height, 1, 1, 0);
    struct draw_call call = pipeline_call(drawing, place, 0.85, CULL_BACK);
    struct uniforms u = make_uniforms(drawing, 0.85 * place.width);
    struct pair square;
    struct draw_call beside = beside_call(&square, &full_square, place);
    const struct steps steps = {u, drawing_value(drawing, "steps")};
    bool done = (steps.steps == 5
                     ? pipeline_draw(pipeline, &call, &toon, &u, sizeof u, error)
                     : pipeline_draw(pipeline, &call, &in_steps, &steps, sizeof steps, error)) &&
                pipeline_draw(pipeline, &beside, &toon, &square.uniforms, sizeof u, error);
    return pipeline_end(drawing, done, image, error);
}

/* In the corner once more, small: there the maps are not read at the same level. */
static bool draw_normal_map(struct drawing *drawing, struct image *image, struct error *error) {
    struct pipeline *pipeline = pipeline_begin(drawing);
    const struct rectangle place = grid_cell(image->width, image->height, 1, 1, 0);
    const struct rectangle corner = corner_of(place, false);
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

/* Above: without the faces turned away from the camera; without those turned towards it. Below:
 * with all faces (the same picture as the first, with more work); culled by the light, next to a
 * square that gets next to none. */
static bool draw_culling(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct cell cells[] = {{&two_sided, CULL_BACK},
                                        {&two_sided, CULL_FRONT},
                                        {&two_sided, CULL_NONE},
                                        {&culled_by_light, CULL_NONE}};
    struct pipeline *pipeline = pipeline_begin(drawing);
    const struct rectangle last = grid_cell(image->width, image->height, 2, 2, 3);
    struct pair square, dim;
    struct draw_call lit_call = beside_call(&square, &full_square, last),
                     over_call = dim_call(&dim, last);
    bool done = record_cells(drawing, pipeline, image, cells, 2, 0.85, error) &&
                pipeline_draw(pipeline, &lit_call, &two_sided, &square.uniforms,
                              sizeof(struct uniforms), error) &&
                pipeline_draw(pipeline, &over_call, &culled_by_light, &dim.uniforms,
                              sizeof(struct uniforms), error);
    return pipeline_end(drawing, done, image, error);
}

/* ---- Four heads, in four ways ---- */

enum { HEADS = 4, BAND_ROWS = 32 };

/* What draws them: see `way` below. */
enum way { WAY_SIMPLE = 1, WAY_VISIBLE, WAY_BANDS, WAY_PIPELINE };

/* One behind another, the farthest first. */
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

/* visible_draw(), with its memory. */
static bool draw_heads_visibly(struct drawing *drawing, const struct canvas *canvas,
                               const struct draw_call calls[HEADS], int band_rows,
                               const struct uniforms *u, struct error *error) {
    const size_t pixels = canvas->image->width * canvas->image->height;
    struct kept_face *kept = malloc((HEADS * drawing->model->face_count + 1) * sizeof *kept);
    struct band band = {
        {0, band_rows}, canvas->image->width, canvas->depth, malloc(pixels * sizeof *band.nearest)};
    bool done = kept != NULL && band.nearest != NULL;
    size_t count = 0;
    for (int i = 0; done && i < HEADS; i++) {
        count += keep_faces(canvas, &calls[i], kept + count);
    }
    if (done) {
        visible_draw(canvas, band, kept, (uint32_t)count, &simple_gouraud_textured, u);
        if (count > 0) { /* these are the depths of the last band, which may be empty */
            canvas->depth[0] = 0;
        }
    } else {
        error_out_of_memory(error);
    }
    drawing_count(drawing, "faces_kept", count);
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
        return draw_heads_visibly(drawing, &canvas, calls, rows, &u, error);
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

/* ---- What is skipped of them, in colours ---- */

enum fate { OUTSIDE, TURNED_AWAY, HIDDEN, SEEN, FATES };

/* Counted by these names. A face that covers no pixel's centre counts as outside. */
static const struct {
    const char *name;
    struct vec3 color;
} fates[FATES] = {{"outside_red", {255, 60, 40}},
                  {"turned_away_blue", {70, 110, 255}},
                  {"hidden_yellow", {250, 200, 0}},
                  {"seen_white", {255, 255, 255}}};

struct colored {
    struct uniforms uniforms;
    struct vec3 color;
};

static void colored_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct colored *c = uniforms;
    const struct vec3 normal = vec3_normalized(model_face_normal(c->uniforms.model, face));
    (void)corner;
    varyings[0] = 0.6 + 0.4 * vec3_dot(normal, c->uniforms.to_light);
}

static bool colored_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    *rgb = vec3_scale(((const struct colored *)uniforms)->color, varyings[0]);
    return true;
}

static const struct simple_shader simple_colored = {1, colored_vertex, colored_pixel};

/* Find out what becomes of each face of the heads, as visible_draw() does with one band. */
static bool find_fates(const struct drawing *drawing, const struct canvas *canvas,
                       unsigned char *fate, struct error *error) {
    const size_t faces = drawing->model->face_count;
    const size_t pixels = canvas->image->width * canvas->image->height;
    struct draw_call calls[HEADS];
    struct kept_face *kept = malloc((faces + 1) * sizeof *kept); /* of one head */
    struct band band = {{0, (int)canvas->image->height},
                        canvas->image->width,
                        canvas->depth,
                        calloc(pixels, sizeof *band.nearest)};
    bool done = kept != NULL && band.nearest != NULL;
    make_head_calls(drawing, canvas->image, 0.68, calls);
    for (size_t i = 0; done && i < HEADS * faces; i++) {
        struct placed_face placed;
        struct edges edges;
        const struct fixed2 *corner = placed.position;
        fate[i] = place_face(&calls[i / faces], i % faces, &placed) &&
                          edges_setup(&edges, corner[0], corner[1], corner[2], band.width,
                                      canvas->image->height)
                      ? TURNED_AWAY
                      : OUTSIDE;
    }
    for (size_t head = 0; done && head < HEADS; head++) {
        const size_t count = keep_faces(canvas, &calls[head], kept);
        for (size_t i = 0; i < count; i++) {
            const size_t place = head * faces + kept[i].face;
            fate[place] = HIDDEN;
            cover_face(&band, &kept[i], (uint32_t)place + 1);
        }
    }
    for (size_t i = 0; done && i < pixels; i++) {
        if (band.nearest[i] > 0) {
            fate[band.nearest[i] - 1] = SEEN;
        }
    }
    free(kept);
    free(band.nearest);
    return done || error_out_of_memory(error);
}

/* Draw the faces of a head that have this fate, gathered at `some`. */
static size_t draw_fate(const struct drawing *drawing, const struct canvas *canvas,
                        struct draw_call call, const unsigned char *fate, enum fate wanted,
                        struct face *some) {
    struct model part = *drawing->model;
    part.faces = some;
    part.face_count = 0;
    for (size_t face = 0; face < drawing->model->face_count; face++) {
        if (fate[face] == wanted) {
            some[part.face_count++] = drawing->model->faces[face];
        }
    }
    struct colored colored = {make_uniforms(drawing, 1), fates[wanted].color};
    colored.uniforms.model = call.model = &part;
    simple_draw(canvas, &call, &simple_colored, &colored);
    return part.face_count;
}

/* What the scene's camera sees and skips, from elsewhere. */
static bool draw_skipped(struct drawing *drawing, struct image *image, struct error *error) {
    const size_t faces = drawing->model->face_count;
    const struct canvas canvas = {image, drawing->depth};
    struct face *some = malloc((faces + 1) * sizeof *some);
    unsigned char *fate = malloc(HEADS * faces + 1);
    bool done = (some != NULL && fate != NULL) || error_out_of_memory(error);
    done = done && find_fates(drawing, &canvas, fate, error);
    depth_clear(drawing->depth, image->width * image->height);
    const struct mat4 around =
        mat4_rotation((struct vec3){0, 1, 0}, drawing_value(drawing, "around") / 360);
    struct drawing beside = *drawing;
    beside.eye = mat4_direction(&around, drawing->eye);
    struct draw_call calls[HEADS];
    make_head_calls(&beside, image, 0.5, calls);
    for (size_t i = 0; done && i < HEADS * FATES; i++) {
        const size_t head = i / FATES;
        drawing_count(drawing, fates[i % FATES].name,
                      draw_fate(drawing, &canvas, calls[head], fate + head * faces,
                                (enum fate)(i % FATES), some));
    }
    free(some);
    free(fate);
    return done;
}

/* ---- The program ---- */

static const struct scene_value around_value[] = {
    {"around", "degrees round the heads, from their camera", -180, 180, 5, 60},
    {.name = NULL},
};

static const struct scene_value way_value[] = {
    {"way", "1 simple_draw(), 2 visible_draw(), 3 in bands, 4 the pipeline", 1, 4, 1, 3},
    {.name = NULL},
};

static const struct scene scenes[] = {
    {
        .name = "loops",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
        .width = 806, /* cells of odd sizes, which differ: exchanged or halved, they show */
        .height = 662,
        .draw = draw_loops,
    },
    {
        .name = "looks",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_DEPTH,
        .draw = draw_looks,
    },
    {
        .name = "more_looks",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP | NEEDS_DEPTH,
        .light = {1, 0.2, 0.5}, /* from the side; x, y, z all differ */
        .draw = draw_more_looks,
    },
    {
        .name = "four",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE,
        .values = four_values,
        .draw = draw_four,
    },
    {
        .name = "toon",
        .needs = NEEDS_MODEL | NEEDS_NORMALS,
        .values = toon_values,
        .draw = draw_toon,
    },
    {
        .name = "normalmap",
        .needs = NEEDS_MODEL | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
        .light = {1, 0.2, 0.5},
        .draw = draw_normal_map,
    },
    {
        .name = "culling",
        .needs = NEEDS_MODEL,
        .light = {1, 0.2, 0}, /* from the side */
        .draw = draw_culling,
    },
    {
        .name = "heads",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_DEPTH,
        .height = 790, /* the last band is lower than the others */
        .width = 800,
        .values = way_value,
        .draw = draw_heads,
    },
    {
        .name = "wide",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
        .width = 203,
        .height = 67,
        .draw = draw_loops,
    },
    {
        .name = "high",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
        .width = 61,
        .height = 181,
        .draw = draw_loops,
    },
    {
        .name = "small",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_DEPTH,
        .width = 23, /* no band is as high: the first one is the last, and cut */
        .height = 13,
        .values = way_value,
        .draw = draw_heads,
    },
    {
        .name = "one_pixel",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_DEPTH,
        .width = 1,
        .height = 1,
        .values = way_value,
        .draw = draw_heads,
    },
    {
        .name = "skipped",
        .extra = true,
        .needs = NEEDS_MODEL | NEEDS_DEPTH,
        .values = around_value,
        .draw = draw_skipped,
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
