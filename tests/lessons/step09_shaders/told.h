/* Lesson 9 under the mouse: what contains answers of its tasks, so that no hand-out has it. */

static const struct scene_value told_toon_values[] = {
    {"steps", "steps of the light", 2, 16, 1, 5},
    {.name = NULL},
};

/* The light in another number of steps than five. */
struct told_steps {
    struct uniforms uniforms; /* for gouraud_vertex() */
    double steps;
};

static lanes_mask told_steps_fragment(const void *uniforms, const lanes *varyings,
                                      lanes_texel *color) {
    const struct told_steps *u = uniforms;
    const float most = (float)u->steps - 1;
    lanes step = lanes_min(lanes_floor(varyings[0] * (most + 1)), lanes_all(most));
    *color = shade(lanes3_all((struct vec3){255, 155, 0}), step / most);
    return lanes_all_set();
}

static const struct shader told_in_steps = {
    .varying_count = 1, .vertex = gouraud_vertex, .fragment = told_steps_fragment};

static bool told_toon(struct drawing *drawing, struct image *image, struct error *error) {
    const struct rectangle whole = grid_cell(image->width, image->height, 1, 1, 0);
    const struct draw_call call = pipeline_call(drawing, whole, 0.85, CULL_BACK);
    const struct told_steps u = {make_uniforms(drawing, 0.85 * whole.width),
                                 drawing_value(drawing, "steps")};
    if (u.steps == 5) {
        return draw_toon(drawing, image, error);
    }
    pipeline_begin(drawing);
    bool done = pipeline_draw(drawing->state, &call, &told_in_steps, &u, sizeof u, error) &&
                record_beside(drawing, flat_call(&full_square, corner_of(image, 1, 0, false)),
                              &toon, error);
    return pipeline_end(drawing, done, image, error);
}
