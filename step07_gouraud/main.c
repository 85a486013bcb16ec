/*
 * Step 7: light at the corners, smooth between them.
 *
 * A flat face shows that it is flat. Where the light is computed at the corners, from a normal that
 * all faces around a corner share, and interpolated in between, the same mesh looks round (Gouraud,
 * "Continuous shading of curved surfaces", 1971).
 *
 * Scenes: `gouraud` has one intensity at each corner. `lit` adds up three kinds of light at each
 * corner, with a light and a camera at points: the ambient, the diffuse and the specular part, and
 * their sum, are four pictures in one.
 */
#include "program.h"

#include <math.h>
#include <stdlib.h>

/* ---- Light at a corner ---- */

/* How much light a surface takes. `normal` and `to_light` have length 1; the result is the cosine
 * of the angle between them, and 0 where the surface looks away from the light. */
static double corner_intensity(struct vec3 normal, struct vec3 to_light) {
    double cosine = vec3_dot(normal, to_light);
    return cosine > 0 ? cosine : 0;
}

/* The surface and the light of scene lit. */
struct material {
    double ambient, diffuse, specular;      /* weights of the three kinds of light: aa, ad, as */
    int diffuse_power, specular_power;      /* kd and ks */
    struct vec3 surface_color, light_color; /* c and cl: red, green, blue in levels 0..255 */
};

static const struct material clay = {
    .ambient = 0.2,
    .diffuse = 0.7,
    .specular = 0.4,
    .diffuse_power = 1,
    .specular_power = 8,
    .surface_color = {225, 165, 130},
    .light_color = {255, 255, 255},
};

/* What differs from corner to corner; the ambient part does not. */
struct light_parts {
    double diffuse, specular; /* ad * <n,l>^kd and as * <s,t>^ks */
};

/* 1 * base * base * ... * base. pow() of the C library may round differently on another machine; a
 * product never does. */
static double integer_power(double base, int power) {
    double product = 1;
    for (int i = 0; i < power; i++) {
        product *= base;
    }
    return product;
}

/* The light that a point sends to the camera (Phong, "Illumination for computer generated
 * pictures", 1975). With n the normal, l the direction to the light, s = 2 <n,l> n - l the mirrored
 * direction, and t the direction to the camera. A negative product counts as 0, and what looks away
 * from the light does not shine. */
static struct light_parts corner_light(struct vec3 position, struct vec3 normal, struct vec3 light,
                                       struct vec3 camera, const struct material *material) {
    struct vec3 to_light = vec3_normalized(vec3_sub(light, position));
    struct vec3 to_camera = vec3_normalized(vec3_sub(camera, position));
    struct light_parts parts = {0, 0};
    double facing = vec3_dot(normal, to_light);
    if (!(facing > 0)) {
        return parts;
    }
    parts.diffuse = material->diffuse * integer_power(facing, material->diffuse_power);
    struct vec3 mirrored = vec3_sub(vec3_scale(normal, 2 * facing), to_light);
    double shining = vec3_dot(mirrored, to_camera);
    if (shining > 0) {
        parts.specular = material->specular * integer_power(shining, material->specular_power);
    }
    return parts;
}

/* ---- Triangles ---- */

/* A corner of a triangle that is to be drawn. */
struct vertex {
    struct fixed2 position;   /* on the screen */
    double depth;             /* larger is nearer */
    double intensity;         /* scene gouraud: 0..1 */
    struct light_parts parts; /* scene lit */
};

/* What is drawn on, and the work done on it. */
struct canvas {
    struct image *image;
    size_t width, height;   /* pixels of the image, or of one of the four pictures in it */
    double *depth;          /* width * height, row by row from the bottom */
    bool skip;              /* compute a colour only where it will be seen */
    uint64_t pixels_tested; /* covered by a triangle */
    uint64_t pixels_shaded;
    uint64_t pixels_written;
};

static void clear_depth(double *depth, size_t pixel_count) {
    for (size_t i = 0; i < pixel_count; i++) {
        depth[i] = -INFINITY;
    }
}

/* The triangle of step 5 with an intensity at each corner, interpolated like the depth. */
static void triangle(struct canvas *canvas, const struct edges *edges, const struct vertex v[3]) {
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        struct span span = edges_span(edges, y);
        double *row = canvas->depth + (size_t)y * canvas->width;
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(edges, x, y);
            double depth = interpolate(weight, v[0].depth, v[1].depth, v[2].depth);
            bool seen = depth > row[x];
            struct color color = {0};
            canvas->pixels_tested++;
            if (seen || !canvas->skip) { /* what is hidden needs no colour */
                double intensity =
                    interpolate(weight, v[0].intensity, v[1].intensity, v[2].intensity);
                color = color_grey(level_from(intensity * 255));
                canvas->pixels_shaded++;
            }
            if (!seen) {
                continue;
            }
            row[x] = depth;
            image_set(canvas->image, x, y, color);
            canvas->pixels_written++;
        }
    }
}

/* The four pictures of scene lit, and which parts each of them shows. */
enum { PANEL_COUNT = 4 };

static const struct panel {
    int column, row;                   /* 0 is left, 0 is below */
    double ambient, diffuse, specular; /* 1 or 0: shown or not */
} panels[PANEL_COUNT] = {
    {.column = 0, .row = 1, .ambient = 1},
    {.column = 1, .row = 1, .diffuse = 1},
    {.column = 0, .row = 0, .specular = 1},
    {.column = 1, .row = 0, .ambient = 1, .diffuse = 1, .specular = 1},
};

/* ambient * c + diffuse * c + specular * cl for each channel, with the parts that the panel shows.
 */
static struct color panel_color(const struct panel *panel, struct light_parts parts,
                                const struct material *material) {
    struct vec3 c = material->surface_color, cl = material->light_color;
    double surface = panel->ambient * material->ambient + panel->diffuse * parts.diffuse;
    double shine = panel->specular * parts.specular;
    return color_rgb(level_from(surface * c.x + shine * cl.x),
                     level_from(surface * c.y + shine * cl.y),
                     level_from(surface * c.z + shine * cl.z));
}

/* The same with the two parts interpolated. The panels from `first` to before `end` show the same
 * triangles, so one depth test serves them all. */
static void lit_triangle(struct canvas *canvas, const struct edges *edges, const struct vertex v[3],
                         size_t first, size_t end) {
    for (int y = edges->y_begin; y < edges->y_end; y++) {
        struct span span = edges_span(edges, y);
        double *row = canvas->depth + (size_t)y * canvas->width;
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(edges, x, y);
            double depth = interpolate(weight, v[0].depth, v[1].depth, v[2].depth);
            bool seen = depth > row[x];
            canvas->pixels_tested++;
            if (!seen && canvas->skip) {
                continue;
            }
            struct light_parts parts = {
                interpolate(weight, v[0].parts.diffuse, v[1].parts.diffuse, v[2].parts.diffuse),
                interpolate(weight, v[0].parts.specular, v[1].parts.specular, v[2].parts.specular),
            };
            canvas->pixels_shaded++;
            if (!seen) {
                continue;
            }
            row[x] = depth;
            for (size_t i = first; i < end; i++) {
                image_set(canvas->image, x + panels[i].column * (int)canvas->width,
                          y + panels[i].row * (int)canvas->height,
                          panel_color(&panels[i], parts, &clay));
                canvas->pixels_written++;
            }
        }
    }
}

/* ---- Scenes ---- */

/* The light at a corner that has been computed before. A normal is shared by all faces around its
 * corner: its light is computed once and not six times. */
struct known_corner {
    uint32_t position; /* the corner's position; MODEL_NONE when nothing is known */
    double intensity;
    struct light_parts parts;
};

/* Memory of a scene that is used again at every drawing. */
struct state {
    double *depth;              /* one a pixel */
    struct known_corner *known; /* one a normal of the model */
};

/* What happened to the faces and their corners. */
struct tally {
    uint64_t off_limits, turned_away, without_pixel;
    uint64_t corners_lit, corners_reused;
};

/* Parallel view: x and y in -1..1 fill the picture, and z is the depth. False for a corner too far
 * off the picture to draw. */
static bool place_corner(const struct model *model, size_t face, size_t corner,
                         const struct canvas *canvas, struct vertex *vertex) {
    struct vec3 world = model_position(model, face, corner);
    struct vec2 screen = {(world.x + 1) * (double)canvas->width / 2,
                          (world.y + 1) * (double)canvas->height / 2};
    vertex->depth = world.z;
    return screen_snap(screen, &vertex->position);
}

static bool place_face(const struct model *model, size_t face, const struct canvas *canvas,
                       struct vertex vertices[3]) {
    for (size_t i = 0; i < 3; i++) {
        if (!place_corner(model, face, i, canvas, &vertices[i])) {
            return false;
        }
    }
    return true;
}

/* Place a face and find its edges. False when there is nothing to draw: the face is too far off, it
 * covers no pixel centre, or its corners run clockwise on the screen, so that it shows its inside.
 */
static bool begin_face(const struct model *model, size_t face, const struct canvas *canvas,
                       struct vertex vertices[3], struct edges *edges, struct tally *tally) {
    if (!place_face(model, face, canvas, vertices)) {
        tally->off_limits++;
        return false;
    }
    if (!edges_setup(edges, vertices[0].position, vertices[1].position, vertices[2].position,
                     canvas->width, canvas->height)) {
        tally->without_pixel++;
        return false;
    }
    tally->turned_away += edges->clockwise;
    return !edges->clockwise;
}

/* Where the light and the camera are: `light` is a direction of length 1 towards the light in scene
 * gouraud, and a point in scene lit. */
struct lighting {
    bool at_points;
    struct vec3 light, camera;
};

static void light_corner(const struct model *model, size_t face, size_t corner,
                         const struct lighting *lighting, struct known_corner *result) {
    struct vec3 normal = vec3_normalized(model_normal(model, face, corner));
    result->position = model->faces[face].corner[corner].position;
    if (lighting->at_points) {
        result->parts = corner_light(model_position(model, face, corner), normal, lighting->light,
                                     lighting->camera, &clay);
    } else {
        result->intensity = corner_intensity(normal, lighting->light);
    }
}

/* The light at the three corners, from memory where it is known. */
static void light_face(const struct drawing *drawing, size_t face, const struct lighting *lighting,
                       struct vertex vertices[3], struct tally *tally) {
    const struct state *state = drawing->state;
    for (size_t i = 0; i < 3; i++) {
        struct corner corner = drawing->model->faces[face].corner[i];
        struct known_corner *known = &state->known[corner.normal];
        if (drawing->skip && known->position == corner.position) {
            tally->corners_reused++;
        } else {
            light_corner(drawing->model, face, i, lighting, known);
            tally->corners_lit++;
        }
        vertices[i].intensity = known->intensity;
        vertices[i].parts = known->parts;
    }
}

/* One drawing of all faces: scene gouraud, or the panels first..end of scene lit. */
static void draw_faces(struct drawing *drawing, struct canvas *canvas,
                       const struct lighting *lighting, size_t first, size_t end) {
    const struct model *model = drawing->model;
    struct tally tally = {0};
    clear_depth(canvas->depth, canvas->width * canvas->height);
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        struct edges edges;
        bool drawn = begin_face(model, face, canvas, vertices, &edges, &tally);
        if (!drawn && drawing->skip) {
            continue; /* its light is not needed */
        }
        light_face(drawing, face, lighting, vertices, &tally);
        if (drawn && lighting->at_points) {
            lit_triangle(canvas, &edges, vertices, first, end);
        } else if (drawn) {
            triangle(canvas, &edges, vertices);
        }
    }
    count(drawing, "faces", model->face_count);
    count(drawing, "faces_off_limits", tally.off_limits);
    count(drawing, "faces_turned_away", tally.turned_away);
    count(drawing, "faces_without_pixel", tally.without_pixel);
    count(drawing, "corners_lit", tally.corners_lit);
    count(drawing, "corners_reused", tally.corners_reused);
}

static void count_pixels(struct drawing *drawing, const struct canvas *canvas) {
    count(drawing, "pixels_tested", canvas->pixels_tested);
    count(drawing, "pixels_shaded", canvas->pixels_shaded);
    count(drawing, "pixels_written", canvas->pixels_written);
}

static void forget_corners(const struct drawing *drawing) {
    const struct state *state = drawing->state;
    for (size_t i = 0; i < drawing->model->normal_count; i++) {
        state->known[i] = (struct known_corner){.position = MODEL_NONE};
    }
}

static bool draw_gouraud(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct state *state = drawing->state;
    const struct lighting lighting = {.light = vec3_normalized(drawing->light)};
    struct canvas canvas = {
        .image = image,
        .width = image->width,
        .height = image->height,
        .depth = state->depth,
        .skip = drawing->skip,
    };
    forget_corners(drawing);
    draw_faces(drawing, &canvas, &lighting, 0, 0);
    count_pixels(drawing, &canvas);
    return true;
}

/* The four panels show the same faces: all are drawn together, or one by one with --no-skip. */
static bool draw_lit(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct state *state = drawing->state;
    const struct lighting lighting = {
        .at_points = true, .light = drawing->light, .camera = drawing->eye};
    struct canvas canvas = {
        .image = image,
        .width = image->width / 2,
        .height = image->height / 2,
        .depth = state->depth,
        .skip = drawing->skip,
    };
    size_t together = drawing->skip ? PANEL_COUNT : 1;
    forget_corners(drawing);
    for (size_t first = 0; first < PANEL_COUNT; first += together) {
        draw_faces(drawing, &canvas, &lighting, first, first + together);
    }
    count_pixels(drawing, &canvas);
    return true;
}

/* ---- The program ---- */

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    struct state *state = drawing->state;
    if (!model_need_normals(drawing->model, error)) {
        return false;
    }
    state->depth = malloc(width * height * sizeof *state->depth);
    state->known = calloc(drawing->model->normal_count, sizeof *state->known);
    if (state->depth == NULL || state->known == NULL) {
        return error_set(error, "not enough memory for a depth buffer of %zux%zu pixels", width,
                         height);
    }
    return true;
}

static void finish(struct drawing *drawing) {
    struct state *state = drawing->state;
    free(state->depth);
    free(state->known);
}

int main(int argc, char **argv) {
    static const struct scene scenes[] = {
        {
            .name = "gouraud",
            .width = 800,
            .height = 800,
            .needs_model = true,
            .light = {0, 0, 1},
            .draw = draw_gouraud,
        },
        {
            .name = "lit",
            .width = 800,
            .height = 800,
            .needs_model = true,
            .light = {-2, 2, 3},
            .eye = {0, 0, 3},
            .draw = draw_lit,
        },
    };
    static const struct program program = {
        .name = "step07_gouraud",
        .summary = "light at the corners, smooth between them",
        .takes_model = true,
        .takes_light = true,
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
        .state_size = sizeof(struct state),
        .prepare = prepare,
        .finish = finish,
    };
    return program_main(&program, argc, argv);
}
