/* The triangles of step 8: see compared.h. */
#include "bench/opengl/compared.h"

#define LESSON "../step08_projection/main.c"
#include "lesson.h"

#include <string.h>

static bool is_one_of(const char *scene, const char *const *names) {
    while (*names != NULL && strcmp(scene, *names) != 0) {
        names++;
    }
    return *names != NULL;
}

static const char *skipped(const char *scene) {
    static const char *const panels[] = {"house",      "scale",      "shear",      "turn",
                                         "scale_turn", "turn_scale", "turn_about", "move_turn",
                                         "turn_move",  "divided",    NULL};
    static const char *const quads[] = {"crossing", "wall", "endless", NULL};
    if (is_one_of(scene, panels)) {
        return "it is a panel of transforms";
    }
    return is_one_of(scene, quads) ? "its few faces are not the model's" : NULL;
}

static const char *left_out(const char *scene) {
    return strcmp(scene, "transforms") == 0
               ? "the lines: between whole pixels, where OpenGL has another rule"
           : strcmp(scene, "narrow") == 0     ? "the leaves, which are not the model's"
           : strcmp(scene, "above") == 0      ? "the small views in the corners"
           : strcmp(scene, "projection") == 0 ? "the small view in a corner"
                                              : NULL;
}

/* One view of the model: the whole image in perspective, or a pane of it in the parallel view. */
struct view {
    struct canvas canvas;
    struct mat4 to_clip;
    bool perspective;
};

static double buffer_depth(const struct view *view, const struct vertex *v) {
    return view->perspective ? NEAR_W * v->recip_w : parallel_depth(v->depth);
}

/* The corner that a part of a face has at `weight`. */
static struct corner_data part_corner(const struct view *view, const struct face_attributes *a,
                                      const struct vertex *v, struct vec3 weight) {
    const double *n = a->intensity;
    struct vec2 uv = vec2_interpolate(weight, a->uv[0], a->uv[1], a->uv[2]);
    return (struct corner_data){
        .placed = {v->position, buffer_depth(view, v), v->recip_w},
        .varyings = {uv.x, uv.y, interpolate(weight, n[0], n[1], n[2])},
    };
}

/* The triangles that are left of a face when it is clipped, as in draw_clipped(). */
static bool add_parts(struct batch *batch, const struct view *view, size_t face,
                      const struct face_attributes *attributes, const struct vec4 clip[3],
                      const struct mat4 *to_screen, struct error *error) {
    const struct polygon polygon = clip_face(clip[0], clip[1], clip[2]);
    struct corner_data corners[POLYGON_LIMIT];
    for (size_t i = 0; i < polygon.count; i++) {
        struct vertex v;
        if (!place(polygon.corner[i].clip, to_screen, &v)) {
            return error_set(error, "face %zu lies too far off the picture", face);
        }
        corners[i] = part_corner(view, attributes, &v, polygon.corner[i].weight);
    }
    for (size_t i = 2; i < polygon.count; i++) {
        const struct corner_data part[3] = {corners[0], corners[i - 1], corners[i]};
        if (!batch_add_snapped(batch, face, part, error)) {
            return false;
        }
    }
    return true;
}

static bool add_face(struct batch *batch, const struct view *view, const struct drawing *drawing,
                     size_t face, struct error *error) {
    const struct mat4 *to_screen = &view->canvas.to_screen;
    const struct model *model = drawing->model;
    const struct face_attributes attributes = fetch_face(drawing, &view->canvas, face);
    struct vec4 clip[3];
    struct corner_data corners[3];
    unsigned beyond_all = ~0u, beyond_any = 0;
    for (size_t i = 0; i < 3; i++) {
        clip[i] = mat4_point(&view->to_clip, model_position(model, face, i));
        beyond_all &= find_beyond(clip[i]);
        beyond_any |= find_beyond(clip[i]);
        struct vertex v = {.recip_w = 1};
        if ((find_beyond(clip[i]) & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0) {
            place(clip[i], to_screen, &v);
        }
        corners[i] = part_corner(view, &attributes, &v, whole_face[i]);
        corners[i].position = model_position(model, face, i);
    }
    if ((beyond_all & ~(unsigned)BEYOND_GUARD_BAND) != 0) {
        return true;
    }
    if (!batch_add_whole(batch, face, corners, error)) {
        return false;
    }
    return (beyond_any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0
               ? batch_add_snapped(batch, face, corners, error)
               : add_parts(batch, view, face, &attributes, clip, to_screen, error);
}

static bool add_view(const struct drawing *drawing, const struct view *view,
                     struct picture *picture, struct error *error) {
    struct batch settings = {
        .look = LOOK_BILINEAR,
        .values = {.diffuse_map = drawing->diffuse},
        .depth_test = true,
        .cull = CULL_BACK,
        .viewport = view->canvas.area,
        .to_clip =
            view->perspective ? perspective_clip(view->to_clip) : parallel_clip(view->to_clip),
    };
    struct batch *batch = picture_add_batch(picture, &settings, error);
    for (size_t face = 0; batch != NULL && face < drawing->model->face_count; face++) {
        if (!add_face(batch, view, drawing, face, error)) {
            return false;
        }
    }
    return batch != NULL;
}

/* ---- Scene transforms: the houses without the lines ---- */

/* A panel's map, and from there to clip space or to the screen, as in draw_panel(). */
static struct mat4 map_to_clip(int panel) {
    return mat4_mul(mat4_scaling((struct vec3){0.5, 0.5, 1}), panel_map(panel));
}

static struct mat4 map_to_screen(struct rectangle area, int panel) {
    return mat4_mul(panel_to_screen(area), panel_map(panel));
}

static bool draw_houses(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    for (int i = 0; i < PANEL_COUNT; i++) {
        const struct plane plane = {image, panel_area(image, i)};
        struct mat4 to_screen = map_to_screen(plane.area, i);
        draw_house(&plane, &to_screen);
    }
    return true;
}

static struct corner_data house_corner(const struct mat4 *to_screen, struct vec2 p) {
    double w = mat4_point(to_screen, (struct vec3){p.x, p.y, 0}).w;
    struct corner_data corner = {.position = {p.x, p.y, 0}, .placed = {.recip_w = 1 / w}};
    screen_snap(to_pixels(to_screen, p), &corner.placed.screen); /* never beyond the limit */
    return corner;
}

static bool add_part(struct picture *picture, struct rectangle area, int panel, size_t part,
                     struct error *error) {
    const struct mat4 to_screen = map_to_screen(area, panel);
    const struct vec2 *c = house[part].corner;
    const struct color color = house[part].color;
    struct batch settings = {
        .look = LOOK_LIT,
        .values = {.ambient = 1, .color = {color.r, color.g, color.b}},
        .viewport = area,
        .to_clip = map_to_clip(panel),
    };
    struct batch *batch = picture_add_batch(picture, &settings, error);
    for (size_t i = 2; batch != NULL && i < PART_CORNERS; i++) {
        const struct corner_data corners[3] = {house_corner(&to_screen, c[0]),
                                               house_corner(&to_screen, c[i - 1]),
                                               house_corner(&to_screen, c[i])};
        if (!batch_add_face(batch, 2 * part + i - 2, corners, error)) {
            return false;
        }
    }
    return batch != NULL;
}

static bool add_houses(struct picture *picture, const struct image *image, struct error *error) {
    for (int panel = 0; panel < PANEL_COUNT; panel++) {
        struct rectangle area = panel_area(image, panel);
        for (size_t part = 0; part < HOUSE_PARTS; part++) {
            if (!add_part(picture, area, panel, part, error)) {
                return false;
            }
        }
    }
    return true;
}

/* ---- All scenes ---- */

static bool draw_narrow_alone(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_narrow_head(drawing, image);
    return true;
}

static bool draw_projection_alone(struct drawing *drawing, struct image *image,
                                  struct error *error) {
    (void)error;
    draw_facets(drawing, image, whole_image(image), eye_distance(drawing));
    return true;
}

static draw_function *rest(const char *scene) {
    return strcmp(scene, "transforms") == 0   ? draw_houses
           : strcmp(scene, "narrow") == 0     ? draw_narrow_alone
           : strcmp(scene, "projection") == 0 ? draw_projection_alone
                                              : draw_view;
}

static bool build(const char *scene, struct drawing *drawing, struct image *image,
                  struct picture *picture, struct error *error) {
    if (strcmp(scene, "transforms") == 0) {
        return add_houses(picture, image, error);
    }
    if (strcmp(scene, "viewport") != 0) {
        bool narrow = strcmp(scene, "narrow") == 0;
        const struct mat4 to_world = narrow ? narrow_to_world() : mat4_identity();
        struct view view = {make_canvas(drawing, image, whole_image(image)),
                            mat4_mul(perspective_camera(drawing), to_world), true};
        view.canvas.normals_to_world = normals_to_world(to_world);
        view.canvas.one_color = strcmp(scene, "projection") == 0;
        return add_view(drawing, &view, picture, error);
    }
    for (size_t i = 0; i < sizeof panes / sizeof panes[0]; i++) {
        const struct view view = {make_canvas(drawing, image, pane_area(panes[i].eighths, image)),
                                  camera(drawing, INFINITY), false};
        if (!add_view(drawing, &view, picture, error)) {
            return false;
        }
    }
    return true;
}

/* The panes of scene viewport are filled, so that only the depth tells. The houses are drawn over
 * black, in other colours. */
static bool covered(const struct drawing *drawing, const struct image *image, size_t pixel) {
    const uint8_t *bgr = image->pixels + 3 * pixel;
    return drawing->depth != NULL ? drawing->depth[pixel] > -INFINITY
                                  : (bgr[0] | bgr[1] | bgr[2]) != 0;
}

const struct lesson lesson_step08 = {
    .program = &step08_projection,
    .skipped = skipped,
    .left_out = left_out,
    .rest = rest,
    .build = build,
    .covered = covered,
};
