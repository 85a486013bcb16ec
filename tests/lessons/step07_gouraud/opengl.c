/* Lesson 7 by OpenGL: see picture.h. */
#include "bench/opengl/picture.h"

#define LESSON "../step07_gouraud/main.c"
#include "lesson.h"

/* A model and what falls on it. */
struct lit_model {
    const struct model *model;
    struct lighting lighting;
};

static bool color_corner(const void *given, size_t face, size_t corner, struct corner_data *to) {
    const struct lit_model *lit = given;
    struct vec3 c = model_color(lit->model, face, corner);
    *to = (struct corner_data){model_position(lit->model, face, corner), {c.x, c.y, c.z}};
    return true;
}

static bool lit_corner(const void *given, size_t face, size_t corner, struct corner_data *to) {
    const struct lit_model *lit = given;
    struct known_corner known = {0};
    light_corner(lit->model, face, corner, &lit->lighting, &known);
    double first = lit->lighting.at_points ? known.parts.diffuse : known.intensity;
    *to = (struct corner_data){model_position(lit->model, face, corner),
                               {first, known.parts.specular}};
    return true;
}

static bool add_model(struct picture *picture, struct gl_part part, corner_function *corner,
                      struct lighting lighting) {
    const struct lit_model lit = {picture->drawing->model, lighting};
    part.cull = CULL_BACK;
    part.to_clip = parallel_clip(mat4_identity());
    return picture_add(picture, &part, lit.model->face_count, corner, &lit);
}

static bool build_gouraud(struct picture *picture) {
    const struct lighting lighting = {.light = vec3_normalized(picture->drawing->light)};
    const struct gl_part part = {.formula = "vec3(255.0 * first.x)",
                                 .viewport = whole_picture(picture)};
    return add_model(picture, part, lit_corner, lighting);
}

static bool build_colors(struct picture *picture) {
    const struct gl_part part = {.formula = "255.0 * first.rgb",
                                 .viewport = whole_picture(picture)};
    return add_model(picture, part, color_corner, (struct lighting){0});
}

static bool add_panels(struct picture *picture, const struct material *material) {
    const struct drawing *drawing = picture->drawing;
    const struct lighting lighting = {true, drawing->light, drawing->eye, material};
    const int width = (int)picture->width / 2, height = (int)picture->height / 2;
    bool done = true;
    for (size_t i = 0; done && i < PANEL_COUNT; i++) {
        const struct panel *panel = &panels[i];
        const struct gl_part part = {
            .formula =
                "(weights.x + weights.y * first.x) * color + weights.z * first.y * light_color",
            .color = material->surface_color,
            .light_color = material->light_color,
            .weights = {panel->ambient * material->ambient, panel->diffuse, panel->specular},
            .viewport = {panel->column * width, panel->row * height, width, height},
        };
        done = add_model(picture, part, lit_corner, lighting);
    }
    return done;
}

static bool build_lit(struct picture *picture) {
    return add_panels(picture, &clay);
}

static bool build_behind(struct picture *picture) {
    return add_panels(picture, &satin);
}

static bool draw_clay(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_lit_as(drawing, image, &clay);
    return true;
}

static const struct compared_scene table[] = {
    {"gouraud", .build = build_gouraud},
    {"colors", .build = build_colors},
    {"lit", "the powers in the corner", draw_clay, .build = build_lit},
    {"behind", .build = build_behind},
    {.name = NULL},
};

const struct lesson lesson_step07 = {&step07_gouraud, table};
