/*
 * Step 9, the given part: its scenes and the program.
 *
 * A scene is a grid of cells, and in each cell the model as one shader draws it. `loops`, `looks`
 * and `more_looks` are drawn by simple_draw(); the others by the pipeline: `four`, `toon` and
 * `normalmap` show shaders, `culling` which faces may be left out.
 */

/* ---- Drawing ---- */

/* What the shaders of the lesson read, for a model that is seen over so many pixels. */
static struct uniforms make_uniforms(const struct drawing *drawing, double pixels) {
    return (struct uniforms){
        .model = drawing->model,
        .diffuse = drawing->diffuse,
        .normal_map = drawing->normal_map,
        .diffuse_level = wrapped_level(drawing->diffuse, pixels),
        .normal_level = wrapped_level(drawing->normal_map, pixels),
        .to_light = vec3_normalized(drawing->light),
    };
}

/* One cell of a picture. */
struct cell {
    const struct shader *shader;
    enum cull cull;
};

/* Draw `side` rows of `side` cells, the first one top left. */
static bool draw_cells(struct drawing *drawing, struct image *image, const struct cell *cells,
                       int side, double zoom, struct error *error) {
    struct pipeline *pipeline = pipeline_begin(drawing);
    bool done = true;
    for (int i = 0; done && i < side * side; i++) {
        struct rectangle place =
            grid_cell(image->width, image->height, side, side, i % side, i / side);
        struct draw_call call = pipeline_call(drawing, place, zoom, cells[i].cull);
        struct uniforms u = make_uniforms(drawing, zoom * place.width);
        done = pipeline_draw(pipeline, &call, cells[i].shader, &u, sizeof u, error);
    }
    return pipeline_end(drawing, done, image, error);
}

/* ---- Scenes of simple_draw() ---- */

/* Each corner of a face in a colour of its own: what is in between shows the weights. */
static void corner_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    (void)uniforms, (void)face;
    for (size_t i = 0; i < 3; i++) {
        varyings[i] = i == corner ? 255 : 0;
    }
}

static bool corner_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    (void)uniforms;
    *rgb = (struct vec3){varyings[0], varyings[1], varyings[2]};
    return true;
}

static const struct simple_shader simple_corners = {3, corner_vertex, corner_pixel};

/* One cell of such a picture. */
struct simple_cell {
    const struct simple_shader *shader;
    enum cull cull;
    double zoom;
    struct vec3 eye; /* zero: that of the drawing */
};

/* Draw two rows of two cells, the first one top left. */
static bool draw_simple_cells(const struct drawing *drawing, struct image *image,
                              const struct simple_cell cells[4]) {
    const struct canvas canvas = {image, drawing->depth};
    for (int i = 0; i < 4; i++) {
        const struct simple_cell *cell = &cells[i];
        struct rectangle place = grid_cell(image->width, image->height, 2, 2, i % 2, i / 2);
        bool has_eye = vec3_dot(cell->eye, cell->eye) > 0;
        struct draw_call call =
            camera_call(drawing->model, has_eye ? cell->eye : drawing->eye, drawing->center,
                        drawing->up, cell->zoom, place, cell->cull);
        struct uniforms u = make_uniforms(drawing, cell->zoom * place.width);
        simple_draw(&canvas, &call, cell->shader, &u);
    }
    return true;
}

/* Above: the corners, the normals. Below: the corners from so near that the face fills the cell and
 * perspective is strong; the inside of the back of the head. */
static bool draw_loops(struct drawing *drawing, struct image *image, struct error *error) {
    const struct vec3 near_the_nose = {0.25, -0.1, 0.75};
    const struct simple_cell cells[4] = {{&simple_corners, CULL_BACK, 0.8, {0, 0, 0}},
                                         {&simple_normals, CULL_BACK, 0.8, {0, 0, 0}},
                                         {&simple_corners, CULL_BACK, 1.2, near_the_nose},
                                         {&simple_normals, CULL_FRONT, 1.15, {0, 0, 0}}};
    (void)error;
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

/* The last one is seen from where no light falls: what is left is the inside of the lit half. */
static bool draw_more_looks(struct drawing *drawing, struct image *image, struct error *error) {
    const struct vec3 from_the_dark_side = {-2.5, 0.5, 1.8};
    const struct simple_cell cells[4] = {{&simple_toon, CULL_BACK, 0.8, {0, 0, 0}},
                                         {&simple_normal_mapped, CULL_BACK, 0.8, {0, 0, 0}},
                                         {&simple_two_sided, CULL_FRONT, 0.8, {0, 0, 0}},
                                         {&simple_lit_only, CULL_NONE, 0.8, from_the_dark_side}};
    (void)error;
    return draw_simple_cells(drawing, image, cells);
}

/* ---- Scenes of the pipeline ---- */

static bool draw_four(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct cell cells[] = {{&flat, CULL_BACK},
                                        {&gouraud, CULL_BACK},
                                        {&flat_textured, CULL_BACK},
                                        {&gouraud_textured, CULL_BACK}};
    return draw_cells(drawing, image, cells, 2, 0.8, error); /* of a quarter: 0.4 of the picture */
}

static bool draw_toon(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct cell cell = {&toon, CULL_BACK};
    return draw_cells(drawing, image, &cell, 1, 0.85, error);
}

static bool draw_normal_map(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct cell cell = {&normal_mapped, CULL_BACK};
    return draw_cells(drawing, image, &cell, 1, 0.85, error);
}

/* Above: without the faces turned away from the camera; without those turned towards it. Below:
 * with all faces (the same picture as the first, with more work); culled by the light. */
static bool draw_culling(struct drawing *drawing, struct image *image, struct error *error) {
    static const struct cell cells[] = {{&two_sided, CULL_BACK},
                                        {&two_sided, CULL_FRONT},
                                        {&two_sided, CULL_NONE},
                                        {&culled_by_light, CULL_NONE}};
    return draw_cells(drawing, image, cells, 2, 0.85, error);
}

/* ---- The program ---- */

static const struct scene scenes[] = {
    {
        .name = "loops",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
        .height = 720, /* not the width: who exchanges them sees it */
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
    {.name = "four", .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE, .draw = draw_four},
    {.name = "toon", .needs = NEEDS_MODEL | NEEDS_NORMALS, .draw = draw_toon},
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
};

int main(int argc, char **argv) {
    static const struct program program = {
        .name = "step09_shaders",
        .summary = "one pipeline, many looks: shaders",
        .takes_light = true,
        .takes_camera = true,
        .defaults =
            {.width = 800, .height = 800, .eye = {1, 0.5, 3}, .up = {0, 1, 0}, .light = {1, 1, 1}},
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
        .state_size = sizeof(struct pipeline),
        .prepare = pipeline_begin_drawing,
        .finish = pipeline_end_drawing,
    };
    return program_main(&program, argc, argv);
}
