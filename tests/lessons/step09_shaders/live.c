/* Lesson 9 under the mouse: one shader alone, steps of toon, and what part d skips, in colours. */
#ifndef LESSON
#define LESSON "../step09_shaders/main.c"
#endif
#include "more_scenes.h"

/* Toon in any number of steps would say how five are made: a hand-out does without. */
#if __has_include("told.h")
#include "told.h"
#endif

/* ---- Scene: four ---- */

static const struct scene_value live_four_values[] = {
    {"shader", "0 all four, 1 flat, 2 Gouraud, 3 flat textured, 4 Gouraud textured", 0, 4, 1, 0},
    {.name = NULL},
};

static bool live_four(struct drawing *drawing, struct image *image, struct error *error) {
    const int one = (int)drawing_value(drawing, "shader");
    if (one == 0) {
        return draw_four(drawing, image, error);
    }
    pipeline_begin(drawing);
    bool done = record_cells(drawing, image, &four_cells[one - 1], 1, 0.8, error);
    return pipeline_end(drawing, done, image, error);
}

/* ---- Scene: skipped ---- */

enum live_fate { LIVE_OUTSIDE, LIVE_TURNED_AWAY, LIVE_HIDDEN, LIVE_SEEN, LIVE_FATES };

/* Counted by these names. A face that covers no pixel's centre counts as outside. */
static const struct {
    const char *name;
    struct vec3 color;
} live_fates[LIVE_FATES] = {{"outside_red", {255, 60, 40}},
                            {"turned_away_blue", {70, 110, 255}},
                            {"hidden_yellow", {250, 200, 0}},
                            {"seen_white", {255, 255, 255}}};

struct live_colored {
    struct uniforms uniforms;
    struct vec3 color;
};

static void live_colored_vertex(const void *uniforms, size_t face, size_t corner,
                                double *varyings) {
    const struct live_colored *c = uniforms;
    const struct vec3 normal = vec3_normalized(model_face_normal(c->uniforms.model, face));
    (void)corner;
    varyings[0] = 0.6 + 0.4 * vec3_dot(normal, c->uniforms.to_light);
}

static bool live_colored_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    *rgb = vec3_scale(((const struct live_colored *)uniforms)->color, varyings[0]);
    return true;
}

static const struct simple_shader live_colored = {1, live_colored_vertex, live_colored_pixel};

/* Find out what becomes of each face of the heads, as visible_draw() does with one band. */
static bool live_find_fates(const struct drawing *drawing, const struct canvas *canvas,
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
                      ? LIVE_TURNED_AWAY
                      : LIVE_OUTSIDE;
    }
    for (size_t head = 0; done && head < HEADS; head++) {
        const size_t count = keep_faces(canvas, &calls[head], kept);
        for (size_t i = 0; i < count; i++) {
            const size_t place = head * faces + kept[i].face;
            fate[place] = LIVE_HIDDEN;
            cover_face(&band, &kept[i], (uint32_t)place + 1);
        }
    }
    for (size_t i = 0; done && i < pixels; i++) {
        if (band.nearest[i] > 0) {
            fate[band.nearest[i] - 1] = LIVE_SEEN;
        }
    }
    free(kept);
    free(band.nearest);
    return done || error_out_of_memory(error);
}

/* Draw the faces of a head that have this fate, gathered at `some`. */
static size_t live_draw_fate(const struct drawing *drawing, const struct canvas *canvas,
                             struct draw_call call, const unsigned char *fate,
                             enum live_fate wanted, struct face *some) {
    struct model part = *drawing->model;
    part.faces = some;
    part.face_count = 0;
    for (size_t face = 0; face < drawing->model->face_count; face++) {
        if (fate[face] == wanted) {
            some[part.face_count++] = drawing->model->faces[face];
        }
    }
    struct live_colored colored = {make_uniforms(drawing, 1), live_fates[wanted].color};
    colored.uniforms.model = call.model = &part;
    simple_draw(canvas, &call, &live_colored, &colored);
    return part.face_count;
}

static const struct scene_value live_skipped_values[] = {
    {"around", "degrees round the heads, from their camera", -180, 180, 5, 60},
    {.name = NULL},
};

/* What the camera of scene `heads` sees and skips, from elsewhere. */
static bool live_skipped(struct drawing *drawing, struct image *image, struct error *error) {
    const size_t faces = drawing->model->face_count;
    const struct canvas canvas = {image, drawing->depth};
    struct face *some = malloc((faces + 1) * sizeof *some);
    unsigned char *fate = malloc(HEADS * faces + 1);
    bool done = (some != NULL && fate != NULL) || error_out_of_memory(error);
    done = done && live_find_fates(drawing, &canvas, fate, error);
    depth_clear(drawing->depth, image->width * image->height);
    const struct mat4 around =
        mat4_rotation((struct vec3){0, 1, 0}, drawing_value(drawing, "around") / 360);
    struct drawing beside = *drawing;
    beside.eye = mat4_direction(&around, drawing->eye);
    struct draw_call calls[HEADS];
    make_head_calls(&beside, image, 0.5, calls);
    for (size_t i = 0; done && i < HEADS * LIVE_FATES; i++) {
        const size_t head = i / LIVE_FATES;
        drawing_count(drawing, live_fates[i % LIVE_FATES].name,
                      live_draw_fate(drawing, &canvas, calls[head], fate + head * faces,
                                     (enum live_fate)(i % LIVE_FATES), some));
    }
    free(some);
    free(fate);
    return done;
}

/* ---- The scenes ---- */

static const struct scene live[] = {
    {.name = "four", .values = live_four_values, .draw = live_four},
#if __has_include("told.h")
    {.name = "toon", .values = told_toon_values, .draw = told_toon},
#endif
    {
        .name = "skipped",
        .extra = true,
        .needs = NEEDS_MODEL | NEEDS_DEPTH,
        .values = live_skipped_values,
        .draw = live_skipped,
    },
};

MAIN_WITH(live)
