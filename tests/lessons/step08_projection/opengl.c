/*
 * Lesson 8 by OpenGL: see picture.h.
 *
 * A program gives to OpenGL what the lesson computes with: for each corner its position, u, v and
 * the light on it; a matrix from the model to clip space; a viewport; and which faces to cull.
 * OpenGL does the rest: it cuts faces at the near plane, divides by w, finds the pixels, keeps the
 * nearest and interpolates with the correct weights. The formula is shade().
 */
#include "bench/opengl/context.h"
#include "bench/opengl/picture.h"

#define LESSON "../step08_projection/main.c"
#include "lesson.h"

/* ---- The model ---- */

struct view {
    const struct drawing *drawing;
    struct mat4 normals_to_world;
    bool one_color; /* a face: that of its middle */
};

/* Varyings: u, v, intensity. */
static bool model_corner(const void *given, size_t face, size_t corner, struct corner_data *to) {
    const struct view *view = given;
    const struct model *model = view->drawing->model;
    struct vec3 normal = model_normal(model, face, corner);
    struct vec2 uv = model_uv(model, face, corner);
    if (view->one_color) {
        normal = model_face_normal(model, face);
        uv = vec2_interpolate((struct vec3){1.0 / 3, 1.0 / 3, 1.0 / 3}, model_uv(model, face, 0),
                              model_uv(model, face, 1), model_uv(model, face, 2));
    }
    normal = vec3_normalized(mat4_direction(&view->normals_to_world, normal));
    double intensity = fmax(vec3_dot(normal, vec3_normalized(view->drawing->light)), 0);
    *to = (struct corner_data){model_position(model, face, corner), {uv.x, uv.y, intensity}};
    return true;
}

static bool add_model(struct picture *picture, const struct view *view, struct rectangle viewport,
                      struct mat4 to_clip) {
    const struct gl_part part = {
        .formula = "bilinear(diffuse_map, first.xy, 0.0) * first.z",
        .maps = {picture->drawing->diffuse},
        .cull = CULL_BACK,
        .viewport = viewport,
        .to_clip = to_clip,
    };
    return picture_add(picture, &part, picture->drawing->model->face_count, model_corner, view);
}

/* ---- Scenes ---- */

/* The model moved by a matrix, seen by the camera in perspective. */
static bool add_view(struct picture *picture, struct mat4 to_world, bool one_color) {
    const struct drawing *d = picture->drawing;
    const double distance = vec3_length(vec3_sub(d->eye, d->center));
    struct mat4 inverse;
    mat4_inverse(to_world, &inverse);
    const struct view view = {d, mat4_transpose(inverse), one_color};
    const struct mat4 camera =
        mat4_mul(mat4_projection(distance), mat4_lookat(d->eye, d->center, d->up));
    return add_model(picture, &view, whole_picture(picture),
                     perspective_clip(mat4_mul(camera, to_world)));
}

static bool build_view(struct picture *picture) {
    return add_view(picture, mat4_identity(), false);
}

static bool build_narrow(struct picture *picture) {
    return add_view(picture, narrow_to_world(), false);
}

static bool build_projection(struct picture *picture) {
    return add_view(picture, mat4_identity(), true);
}

/* Panes in the parallel view. */
static bool build_viewport(struct picture *picture) {
    const struct drawing *d = picture->drawing;
    const struct view view = {d, mat4_identity(), false};
    const struct mat4 to_clip = parallel_clip(mat4_lookat(d->eye, d->center, d->up));
    bool done = true;
    for (size_t i = 0; done && i < sizeof panes / sizeof panes[0]; i++) {
        done = add_model(picture, &view, pane_area(panes[i].eighths, picture->image), to_clip);
    }
    return done;
}

/* ---- Scene transforms: the houses without the lines ---- */

static bool house_corner(const void *given, size_t face, size_t corner, struct corner_data *to) {
    const struct part *part = &house[face / 2]; /* of four corners, as two faces */
    struct vec2 p = part->corner[corner > 0 ? corner + face % 2 : 0];
    const struct color c = part->color;
    (void)given;
    *to = (struct corner_data){{p.x, p.y, 0}, {c.r / 255.0, c.g / 255.0, c.b / 255.0}};
    return true;
}

static bool build_houses(struct picture *picture) {
    bool done = true;
    for (int i = 0; done && i < PANEL_COUNT; i++) {
        const struct gl_part part = {
            .formula = "255.0 * first.rgb",
            .no_depth_test = true,
            .viewport = panel_area(picture->image, i),
            .to_clip = mat4_mul(mat4_scaling((struct vec3){0.5, 0.5, 1}), panel_map(i)),
        };
        done = picture_add(picture, &part, 2 * HOUSE_PARTS, house_corner, NULL);
    }
    return done;
}

/* ---- Scenes without what is left out ---- */

static bool draw_houses(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    for (int i = 0; i < PANEL_COUNT; i++) {
        const struct plane plane = {image, panel_area(image, i)};
        struct mat4 to_screen = mat4_mul(panel_to_screen(plane.area), panel_map(i));
        draw_house(&plane, &to_screen);
    }
    return true;
}

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

static const char lines[] = "the lines: between whole pixels, where OpenGL has another rule";

static const struct compared_scene table[] = {
    {"transforms", lines, draw_houses, .build = build_houses},
    {"viewport", .build = build_viewport, .fills = true},
    {"projection", "the small view in a corner", draw_projection_alone, .build = build_projection},
    {"narrow", "the leaves, which are not the model's", draw_narrow_alone, .build = build_narrow},
    {"lookat", .build = build_view},
    {"tilted", .build = build_view},
    {"above", "the small views in the corners", draw_view, .build = build_view},
    {"closeup", .build = build_view},
    {.left_out = "it is a panel of transforms, or its few faces are not the model's"},
};

const struct lesson lesson_step08 = {&step08_projection, table};
