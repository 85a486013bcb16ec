/*
 * For `make MINE=1`: lesson 10 draws through the pipeline that a student wrote in part d of
 * lesson 9.
 *
 * Draw calls are recorded. At the end of a frame all that share a viewport are drawn together, on
 * a picture of that size: one more varying says to which call a pixel belongs. A fragment function
 * gets the same varyings in all lanes. A frame that has a face behind the eye, discards pixels or
 * keeps its depths is drawn by our pipeline: part d has no clipping.
 */
struct recorded {
    struct pipeline *pipeline;
    struct draw_call call;
    const struct shader *shader;
    void *uniforms;
    size_t first_face; /* all faces of a frame are numbered */
};

static struct recorded *records;
static size_t record_count, call_varying; /* behind the varyings of all shaders */

static bool visible_record(struct pipeline *pipeline, const struct draw_call *call,
                           const struct shader *shader, const void *uniforms, size_t size,
                           struct error *error) {
    struct recorded *more = realloc(records, (record_count + 1) * sizeof *records);
    void *copy = malloc(size + 1);
    records = more != NULL ? more : records;
    if (more == NULL || copy == NULL) {
        free(copy);
        return error_out_of_memory(error);
    }
    memcpy(copy, uniforms, size);
    records[record_count++] = (struct recorded){pipeline, *call, shader, copy, 0};
    return pipeline_draw(pipeline, call, shader, uniforms, size, error);
}

static bool is_for_part_d(const struct recorded *r) {
    bool done = !r->shader->discards && r->shader->varying_count < VARYING_LIMIT &&
                !r->pipeline->keep_depth;
    for (size_t i = 0; done && i < r->call.model->position_count; i++) {
        done = mat4_point(&r->call.to_clip, r->call.model->positions[i]).w >= 1.0 / 128;
    }
    return done;
}

static void record_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    (void)uniforms;
    size_t i = record_count - 1;
    while (face < records[i].first_face) {
        i--;
    }
    const struct recorded *r = &records[i];
    memset(varyings, 0, (call_varying + 1) * sizeof *varyings);
    r->shader->vertex(r->uniforms, face - r->first_face, r->shader->flat ? 0 : corner, varyings);
    varyings[call_varying] = (double)i;
}

static bool record_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    (void)uniforms;
    const struct recorded *r = &records[(size_t)(varyings[call_varying] + 0.5)];
    lanes all[VARYING_LIMIT];
    lanes_texel texel;
    for (size_t i = 0; i < r->shader->varying_count; i++) {
        all[i] = lanes_all((real)varyings[i]);
    }
    if (r->shader->prepare != NULL) {
        r->shader->prepare(r->uniforms, all);
    }
    r->shader->fragment(r->uniforms, all, &texel);
    const struct color color = color_from_texel(lanes_texel_at(texel, 0));
    *rgb = (struct vec3){color.r, color.g, color.b};
    return true;
}

static bool is_same_place(struct rectangle a, struct rectangle b) {
    return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

/* Draw the frame's calls that share the viewport of the first one. */
static bool draw_viewport(const struct pipeline *pipeline, size_t first, struct image *image,
                          struct error *error) {
    const struct rectangle place = records[first].call.viewport;
    const size_t width = (size_t)place.width, height = (size_t)place.height;
    struct image part;
    size_t faces = 0, count = 0;
    call_varying = 0;
    for (size_t i = 0; i < record_count; i++) {
        const size_t varyings = records[i].shader->varying_count;
        call_varying = varyings > call_varying ? varyings : call_varying;
        records[i].first_face = faces;
        faces += records[i].call.model->face_count;
    }
    if (!image_create(&part, width, height, IMAGE_BGRA, error)) {
        return false;
    }
    struct kept_face *kept = malloc((faces + 1) * sizeof *kept);
    struct canvas canvas = {&part, malloc(width * height * sizeof(double))};
    struct band band = {
        {0, 32}, width, canvas.depth, malloc(width * height * sizeof *band.nearest)};
    const bool done = (kept != NULL && canvas.depth != NULL && band.nearest != NULL) ||
                      error_out_of_memory(error);
    for (size_t i = first; done && i < record_count; i++) {
        struct draw_call call = records[i].call;
        if (records[i].pipeline == pipeline && is_same_place(call.viewport, place)) {
            call.viewport = (struct rectangle){0, 0, place.width, place.height};
            const size_t more = keep_faces(&canvas, &call, kept + count);
            for (size_t k = count; k < count + more; k++) {
                kept[k].face += records[i].first_face;
            }
            count += more;
        }
    }
    if (done) {
        const struct simple_shader shader = {call_varying + 1, record_vertex, record_pixel};
        visible_draw(&canvas, band, kept, (uint32_t)count, &shader, NULL);
    }
    for (int i = 0; done && i < place.width * place.height; i++) {
        const struct color color = image_get(&part, i % place.width, i / place.width);
        if (color.a > 0) {
            image_set(image, place.x + i % place.width, place.y + i / place.width, color);
        }
    }
    free(band.nearest);
    free(canvas.depth);
    free(kept);
    image_free(&part);
    return done;
}

static bool visible_finish(struct pipeline *pipeline, struct image *image, struct error *error) {
    bool hers = true, done = true;
    size_t others = 0;
    for (size_t i = 0; i < record_count; i++) {
        hers = hers && (records[i].pipeline != pipeline || is_for_part_d(&records[i]));
    }
    for (size_t i = 0; hers && done && i < record_count; i++) {
        const struct rectangle place = records[i].call.viewport;
        bool is_first = records[i].pipeline == pipeline && place.width > 0 && place.height > 0;
        for (size_t k = 0; k < i; k++) {
            is_first = is_first && (records[k].pipeline != pipeline ||
                                    !is_same_place(records[k].call.viewport, place));
        }
        done = !is_first || draw_viewport(pipeline, i, image, error);
    }
    if (!hers) {
        done = pipeline_finish(pipeline, image, error);
    }
    for (size_t i = 0; i < record_count; i++) {
        if (records[i].pipeline == pipeline) {
            free(records[i].uniforms);
        } else {
            records[others++] = records[i];
        }
    }
    record_count = others;
    return done;
}
