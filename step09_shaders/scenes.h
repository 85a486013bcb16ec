/*
 * Step 9, the given part: its scenes and the program.
 *
 * A scene is a square of cells, and in each cell the model as one shader draws it. `four`, `toon`
 * and `normalmap` show shaders, `culling` which faces may be left out.
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

/* ---- Scenes ---- */

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
    {.name = "four", .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE, .draw = draw_four},
    {.name = "toon", .needs = NEEDS_MODEL | NEEDS_NORMALS, .draw = draw_toon},
    {
        .name = "normalmap",
        .needs = NEEDS_MODEL | NEEDS_DIFFUSE | NEEDS_NORMAL_MAP,
        .light = {1, 0.2, 0.5}, /* x, y, z all differ: none can stand in for another */
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
