/*
 * Lesson 7, the given part: its scenes and the program.
 *
 * `gouraud` has one intensity at each corner, `colors` a colour. `lit` adds up three kinds of light
 * at each corner, with a light and a camera at points: the ambient, the diffuse and the specular
 * part, and their sum, are four pictures in one. In `behind` the light is behind the model, the
 * camera at its side, and the surface another one. `wide`, `high`, `small` and `one_pixel` draw the
 * same in images of other shapes.
 */

#include <stdlib.h>

/* ---- Faces ---- */

/* The corners of a face in the parallel view; z is the depth. False for a corner too far off the
 * picture to draw. */
static bool place_face(const struct model *model, size_t face, const struct canvas *canvas,
                       struct vertex vertices[3]) {
    for (size_t i = 0; i < 3; i++) {
        struct vec3 world = model_position(model, face, i);
        vertices[i] = (struct vertex){.depth = world.z};
        if (!screen_snap(parallel_view(world, canvas->width, canvas->height),
                         &vertices[i].position)) {
            return false;
        }
    }
    return true;
}

/* Place a face and find its edges. False when there is nothing to draw: the face is too far off, it
 * covers no pixel centre, or its corners run clockwise on the screen: we look at its inside. */
static bool begin_face(const struct model *model, size_t face, const struct canvas *canvas,
                       struct vertex vertices[3], struct edges *edges) {
    return place_face(model, face, canvas, vertices) &&
           edges_setup(edges, vertices[0].position, vertices[1].position, vertices[2].position,
                       canvas->width, canvas->height) &&
           !edges->clockwise;
}

/* A canvas of that size on the image. */
static struct canvas canvas_on(struct image *image, size_t width, size_t height,
                               const struct drawing *drawing) {
    return (struct canvas){
        .image = image,
        .width = width,
        .height = height,
        .depth = drawing->depth,
        .skip = drawing->skip,
    };
}

static void count_pixels(struct drawing *drawing, const struct canvas *canvas) {
    drawing_count(drawing, "pixels_tested", canvas->pixels_tested);
    drawing_count(drawing, "pixels_shaded", canvas->pixels_shaded);
}

/* ---- Scenes gouraud and lit: light at the corners ---- */

/* Where the light and the camera are: `light` is a direction of length 1 towards the light in scene
 * gouraud, and a point in scene lit. */
struct lighting {
    bool at_points;
    struct vec3 light, camera;
    const struct material *material; /* at points */
};

/* The light at a corner that has been computed before. A normal is shared by all faces around its
 * corner: its light is computed once and not six times. */
struct known_corner {
    uint32_t position; /* the corner's position; MODEL_NONE when nothing is known */
    double intensity;
    struct light_parts parts;
};

/* Memory of a scene that is used again at every drawing. */
struct state {
    struct known_corner *known; /* one a normal of the model, and one more: there may be none */
    uint64_t corners_lit, corners_reused;
};

static void forget_corners(const struct drawing *drawing) {
    struct state *state = drawing->state;
    for (size_t i = 0; i < drawing->model->normal_count; i++) {
        state->known[i] = (struct known_corner){.position = MODEL_NONE};
    }
    state->corners_lit = state->corners_reused = 0;
}

static void light_corner(const struct model *model, size_t face, size_t corner,
                         const struct lighting *lighting, struct known_corner *result) {
    struct vec3 normal = vec3_normalized(model_normal(model, face, corner));
    result->position = model->faces[face].corner[corner].position;
    if (lighting->at_points) {
        result->parts = corner_light(model_position(model, face, corner), normal, lighting->light,
                                     lighting->camera, lighting->material);
    } else {
        result->intensity = corner_intensity(normal, lighting->light);
    }
}

/* The light at the three corners, from memory where it is known. */
static void light_face(const struct drawing *drawing, size_t face, const struct lighting *lighting,
                       struct vertex vertices[3]) {
    struct state *state = drawing->state;
    for (size_t i = 0; i < 3; i++) {
        struct corner corner = drawing->model->faces[face].corner[i];
        struct known_corner *known = &state->known[corner.normal];
        if (drawing->skip && known->position == corner.position) {
            state->corners_reused++;
        } else {
            light_corner(drawing->model, face, i, lighting, known);
            state->corners_lit++;
        }
        vertices[i].intensity = known->intensity;
        vertices[i].parts = known->parts;
    }
}

static void draw_faces(struct drawing *drawing, struct canvas *canvas,
                       const struct lighting *lighting) {
    const struct model *model = drawing->model;
    const struct state *state = drawing->state;
    forget_corners(drawing);
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        struct edges edges;
        bool drawn = begin_face(model, face, canvas, vertices, &edges);
        if (!drawn && drawing->skip) {
            continue; /* its light is not needed */
        }
        light_face(drawing, face, lighting, vertices);
        if (drawn && lighting->at_points) {
            lit_triangle(canvas, &edges, vertices);
        } else if (drawn) {
            triangle(canvas, &edges, vertices);
        }
    }
    drawing_count(drawing, "corners_lit", state->corners_lit);
    drawing_count(drawing, "corners_reused", state->corners_reused);
    count_pixels(drawing, canvas);
}

#include "attempts.h"

static const struct scene_value gouraud_values[] = {
    {"attempt",
     "0 triangle(), 1 flat, 2 a normal for each pixel, 3 clamped at the pixel, 4 not clamped", 0, 4,
     1, 0},
    {.name = NULL},
};

static bool draw_gouraud(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    static attempt_function *const attempts[] = {attempt_1_flat, attempt_3_normal, attempt_5_late,
                                                 attempt_6_wrapped};
    const struct lighting lighting = {.light = vec3_normalized(drawing->light)};
    const int attempt = (int)drawing_value(drawing, "attempt");
    struct canvas canvas = canvas_on(image, image->width, image->height, drawing);
    if (attempt > 0) {
        attempt_model(&canvas, drawing->model, lighting.light, attempts[attempt - 1]);
    } else {
        draw_faces(drawing, &canvas, &lighting);
    }
    return true;
}

static void draw_lit_as(struct drawing *drawing, struct image *image,
                        const struct material *material) {
    const struct lighting lighting = {
        .at_points = true, .light = drawing->light, .camera = drawing->eye, .material = material};
    struct canvas canvas = canvas_on(image, image->width / 2, image->height / 2, drawing);
    canvas.material = material;
    draw_faces(drawing, &canvas, &lighting);
}

/* In the lower left corner the powers 0 to 31 of 0.9, row by row from below. */
static void draw_powers(struct image *image) {
    enum { COLUMNS = 8, ROWS = 4 };
    int side = (int)image->width / 40;
    for (int y = 0; y < ROWS * side && y < (int)image->height; y++) {
        for (int column = 0; column < COLUMNS; column++) {
            double product = integer_power(0.9, y / side * COLUMNS + column);
            image_fill_row(image, y, column * side, (column + 1) * side,
                           color_grey(level_from(255 * product)));
        }
    }
}

static bool draw_lit(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_lit_as(drawing, image, &clay);
    draw_powers(image);
    return true;
}

static bool draw_behind(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    draw_lit_as(drawing, image, &satin);
    return true;
}

/* ---- Scene colors ---- */

static bool draw_colors(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct model *model = drawing->model;
    struct canvas canvas = canvas_on(image, image->width, image->height, drawing);
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        struct edges edges;
        if (begin_face(model, face, &canvas, vertices, &edges)) {
            for (size_t i = 0; i < 3; i++) {
                vertices[i].color = model_color(model, face, i);
            }
            color_triangle(&canvas, &edges, vertices);
        }
    }
    count_pixels(drawing, &canvas);
    return true;
}

/* ---- Scene sphere: how many triangles are enough? ---- */

static const struct scene_value sphere_values[] = {
    {"cuts", "how often each face is cut into four", 0, 6, 1, 2},
    {"look", "0 flat, 1 light at the corners, 2 a normal at each pixel", 0, 2, 1, 1},
    {.name = NULL},
};

static bool draw_sphere(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    static attempt_function *const looks[] = {attempt_1_flat, attempt_2_gouraud, attempt_3_normal};
    const int cuts = (int)drawing_value(drawing, "cuts");
    const struct vec3 to_light = vec3_normalized(drawing->light);
    struct canvas canvas = canvas_on(image, image->width, image->height, drawing);
    attempt_sphere(&canvas, cuts, to_light, looks[(int)drawing_value(drawing, "look")]);
    drawing_count(drawing, "triangles", UINT64_C(8) << 2 * cuts);
    drawing_count(drawing, "error_in_thousandths",
                  (uint64_t)(1000 * sphere_error(&canvas, to_light)));
    return true;
}

/* ---- The program ---- */

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    (void)width, (void)height;
    struct state *state = drawing->state;
    if (drawing->model == NULL) {
        return true;
    }
    state->known = calloc(drawing->model->normal_count + 1, sizeof *state->known);
    return state->known != NULL || error_out_of_memory(error);
}

static void finish(struct drawing *drawing) {
    struct state *state = drawing->state;
    free(state->known);
}

static const struct scene scenes[] = {
    {
        .name = "gouraud",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
        .values = gouraud_values,
        .draw = draw_gouraud,
    },
    {
        .name = "colors",
        .needs = NEEDS_MODEL | NEEDS_COLORS | NEEDS_DEPTH,
        .model = "knot.off",
        .draw = draw_colors,
    },
    {
        .name = "lit",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
        .light = {-2, 2, 3},
        .eye = {0, 0, 3},
        .draw = draw_lit,
    },
    {
        .name = "behind",
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
        .width = 800,
        .height = 720,
        .light = {-2, 2, -3},
        .eye = {1.2, -0.6, 2.5},
        .draw = draw_behind,
    },
    /* Not square, and odd: what a square or large picture hides shows here. */
    {
        .name = "wide",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_COLORS | NEEDS_DEPTH,
        .model = "knot.off",
        .width = 203,
        .height = 67,
        .draw = draw_colors,
    },
    {
        .name = "high",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
        .width = 61,
        .height = 181,
        .draw = draw_gouraud,
    },
    {
        .name = "small",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
        .width = 13,
        .height = 23,
        .light = {-2, 2, 3},
        .eye = {0, 0, 3},
        .draw = draw_lit,
    },
    {
        .name = "one_pixel",
        .detail = true,
        .needs = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DEPTH,
        .width = 1,
        .height = 1,
        .draw = draw_gouraud,
    },
    {
        .name = "sphere",
        .extra = true,
        .needs = NEEDS_DEPTH,
        .light = {1, 2, 2},
        .values = sphere_values,
        .draw = draw_sphere,
    },
};

static const struct program step07_gouraud = {
    .name = "step07_gouraud",
    .summary = "light at the corners, smooth between them",
    .takes_light = true,
    .defaults = {.width = 800, .height = 800, .light = {0, 0, 1}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
    .state_size = sizeof(struct state),
    .prepare = prepare,
    .finish = finish,
};
