/*
 * Step 5: the depth buffer.
 *
 * Every pixel remembers the depth of what it shows. A triangle changes a pixel only where it is
 * nearer than what is there, so the order in which triangles come no longer matters.
 *
 * Scenes: `rows` shows the idea in one dimension: three segments of a plane, seen from above, in
 * one row of pixels. `zbuffer` is lesson 4 with a depth buffer. `depth` shows the depths
 * themselves.
 *
 * Depth: larger is nearer; minus infinity where nothing has been drawn.
 */
#include "program.h"

#include <math.h>
#include <stdlib.h>

/* ---- Light: as in step 4 ---- */

/* How directly the light falls on a face: 1 straight, 0 along the face, negative from behind.
 * `light` has length 1 and is the direction in which the light travels. The normal is taken so that
 * it points into the model; it agrees with `light` where the light falls on the outside. */
static double face_intensity(const struct model *model, size_t face, struct vec3 light) {
    struct vec3 w0 = model_position(model, face, 0), w1 = model_position(model, face, 1);
    struct vec3 w2 = model_position(model, face, 2);
    struct vec3 normal = vec3_normalized(vec3_cross(vec3_sub(w2, w0), vec3_sub(w1, w0)));
    return vec3_dot(normal, light);
}

/* ---- Triangles ---- */

/* A corner of a triangle that is to be drawn. */
struct vertex {
    struct fixed2 position; /* on the screen */
    double depth;           /* larger is nearer */
};

/* What is drawn on, and the work done on it. */
struct canvas {
    struct image *image;
    double *depth;          /* one a pixel, row by row from the bottom */
    uint64_t pixels_tested; /* covered by a triangle */
    uint64_t pixels_written;
};

static void clear_depth(double *depth, size_t pixel_count) {
    for (size_t i = 0; i < pixel_count; i++) {
        depth[i] = -INFINITY;
    }
}

/* The triangle of step 4 with a depth at each corner, interpolated and compared at every pixel. At
 * equal depth what was there stays. False when no pixel centre can be inside. */
static bool triangle(struct canvas *canvas, const struct vertex v[3], struct color color) {
    struct image *image = canvas->image;
    struct edges edges;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                     image->height)) {
        return false;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        double *row = canvas->depth + (size_t)y * image->width;
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(&edges, x, y);
            double depth = interpolate(weight, v[0].depth, v[1].depth, v[2].depth);
            canvas->pixels_tested++;
            if (!(depth > row[x])) {
                continue;
            }
            row[x] = depth;
            image_set(image, x, y, color);
            canvas->pixels_written++;
        }
    }
    return true;
}

/* Memory of a scene that is used again at every drawing. */
struct state {
    double *depth; /* one a pixel */
    struct color *row;
};

/* ---- Scene: rows ---- */

/* A line in a plane seen from above: x to the right, y towards the viewer, who looks down. */
struct segment {
    struct vec2 a, b; /* a.x < b.x; in a plane of ROWS_WIDTH x ROWS_PLANE */
    struct color color;
};

/* The picture of this scene, in pixels of a picture of the usual size: the plane on top, then the
 * row of colours and the row of depths as strips. */
enum {
    ROWS_WIDTH = 800,
    ROWS_HEIGHT = 640,
    ROWS_PLANE = 500, /* height of the plane; its y is the depth */
    ROWS_PLANE_BOTTOM = 140,
    ROWS_COLOR_BOTTOM = 80,
    ROWS_DEPTH_BOTTOM = 20,
    ROWS_STRIP = 40 /* height of a strip */
};

/* One row of the depth buffer: what triangle() does, in one dimension. A pixel is covered when its
 * centre x + 0.5 lies in a.x <= x + 0.5 < b.x. */
static void draw_segment(const struct segment *s, struct color *colors, double *depths,
                         size_t width) {
    for (size_t x = 0; x < width; x++) {
        double center = (double)x + 0.5;
        if (center < s->a.x || center >= s->b.x) {
            continue;
        }
        double along = (center - s->a.x) / (s->b.x - s->a.x); /* 0 at a, 1 at b */
        double depth = s->a.y + (s->b.y - s->a.y) * along;
        if (depth > depths[x]) {
            depths[x] = depth;
            colors[x] = s->color;
        }
    }
}

/* The segment itself, three pixels thick. */
static void draw_plane_line(const struct segment *s, struct image *image, int bottom) {
    for (int shift = -1; shift <= 1; shift++) {
        struct pixel a = {(int)floor(s->a.x), bottom + (int)floor(s->a.y) + shift};
        struct pixel b = {(int)floor(s->b.x), bottom + (int)floor(s->b.y) + shift};
        struct line_walk walk;
        bool more = line_begin(&walk, a, b, image->width, image->height);
        for (; more; more = line_next(&walk)) {
            image_set(image, walk.x, walk.y, s->color);
        }
    }
}

/* A row of pixels `height` times, one above the other, so that it can be seen. */
static void draw_strip(struct image *image, const struct color *row, int bottom, int height) {
    for (int y = bottom; y < bottom + height; y++) {
        for (int x = 0; x < (int)image->width; x++) {
            image_set(image, x, y, row[x]);
        }
    }
}

static bool draw_rows(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    static const struct segment segments[] = {
        {{20, 34}, {744, 400}, {.r = 255, .a = 255}},
        {{120, 434}, {444, 400}, {.g = 255, .a = 255}},
        {{330, 463}, {594, 200}, {.b = 255, .a = 255}},
    };
    const struct state *state = drawing->state;
    size_t width = image->width;
    /* Another size than the usual one shows the same picture, smaller or larger. */
    double across = (double)width / ROWS_WIDTH, up = (double)image->height / ROWS_HEIGHT;
    int strip = (int)(ROWS_STRIP * up), plane_bottom = (int)(ROWS_PLANE_BOTTOM * up);
    clear_depth(state->depth, width);
    for (size_t x = 0; x < width; x++) {
        state->row[x] = color_rgb(0, 0, 0);
    }
    for (size_t i = 0; i < sizeof segments / sizeof segments[0]; i++) {
        struct segment s = segments[i];
        s.a = (struct vec2){s.a.x * across, s.a.y * up};
        s.b = (struct vec2){s.b.x * across, s.b.y * up};
        draw_plane_line(&s, image, plane_bottom);
        draw_segment(&s, state->row, state->depth, width);
    }
    draw_strip(image, state->row, (int)(ROWS_COLOR_BOTTOM * up), strip);
    for (size_t x = 0; x < width; x++) {
        state->row[x] = color_grey(level_from(state->depth[x] * 255 / (ROWS_PLANE * up)));
    }
    draw_strip(image, state->row, (int)(ROWS_DEPTH_BOTTOM * up), strip);
    return true;
}

/* ---- Scenes: zbuffer and depth ---- */

/* Parallel view: x and y in -1..1 fill the image, and z is the depth. False for a corner too far
 * off the image to draw. */
static bool place_corner(const struct model *model, size_t face, size_t corner,
                         const struct image *image, struct vertex *vertex) {
    struct vec3 world = model_position(model, face, corner);
    struct vec2 screen = {(world.x + 1) * (double)image->width / 2,
                          (world.y + 1) * (double)image->height / 2};
    vertex->depth = world.z;
    return screen_snap(screen, &vertex->position);
}

static bool place_face(const struct model *model, size_t face, const struct image *image,
                       struct vertex vertices[3]) {
    for (size_t i = 0; i < 3; i++) {
        if (!place_corner(model, face, i, image, &vertices[i])) {
            return false;
        }
    }
    return true;
}

/* All faces on which light falls, as in step 4. */
static void draw_faces(struct drawing *drawing, struct canvas *canvas) {
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    uint64_t unlit = 0, placed = 0, off_limits = 0, without_pixel = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        double intensity = face_intensity(model, face, light);
        bool lit = intensity > 0;
        unlit += !lit;
        if (!lit && drawing->skip) {
            continue; /* it will not be drawn: where it lies does not matter */
        }
        placed++;
        if (!place_face(model, face, canvas->image, vertices)) {
            off_limits += lit;
        } else if (lit && !triangle(canvas, vertices, color_grey(level_from(intensity * 255)))) {
            without_pixel++;
        }
    }
    count(drawing, "faces", model->face_count);
    count(drawing, "faces_unlit", unlit);
    count(drawing, "faces_placed", placed);
    count(drawing, "faces_off_limits", off_limits);
    count(drawing, "faces_without_pixel", without_pixel);
    count(drawing, "pixels_tested", canvas->pixels_tested);
    count(drawing, "pixels_hidden", canvas->pixels_tested - canvas->pixels_written);
    count(drawing, "pixels_written", canvas->pixels_written);
}

static bool draw_zbuffer(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct state *state = drawing->state;
    struct canvas canvas = {.image = image, .depth = state->depth};
    clear_depth(state->depth, image->width * image->height);
    draw_faces(drawing, &canvas);
    return true;
}

/* The farthest and the nearest depth that is seen; far > near when nothing is. */
static void depth_range(const double *depth, size_t pixel_count, double *far, double *near) {
    *far = INFINITY;
    *near = -INFINITY;
    for (size_t i = 0; i < pixel_count; i++) {
        if (depth[i] > -INFINITY) {
            *far = depth[i] < *far ? depth[i] : *far;
            *near = depth[i] > *near ? depth[i] : *near;
        }
    }
}

enum { DEPTH_LEVEL_FAR = 55, DEPTH_LEVEL_NEAR = 255 };

/* Grey for depth: the farthest that is seen is 55, the nearest 255, nothing 0. */
static bool draw_depth(struct drawing *drawing, struct image *image, struct error *error) {
    const struct state *state = drawing->state;
    size_t pixel_count = image->width * image->height;
    double far, near;
    if (!draw_zbuffer(drawing, image, error)) {
        return false;
    }
    depth_range(state->depth, pixel_count, &far, &near);
    double levels = DEPTH_LEVEL_NEAR - DEPTH_LEVEL_FAR;
    double range = near > far ? near - far : 1; /* a single depth becomes DEPTH_LEVEL_FAR */
    for (size_t i = 0; i < pixel_count; i++) {
        bool seen = state->depth[i] > -INFINITY;
        double level = DEPTH_LEVEL_FAR + (state->depth[i] - far) * levels / range;
        image->pixels[i] = seen ? level_from(level) : 0;
    }
    return true;
}

/* ---- The program ---- */

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    struct state *state = drawing->state;
    state->depth = malloc(width * height * sizeof *state->depth);
    state->row = malloc(width * sizeof *state->row);
    if (state->depth == NULL || state->row == NULL) {
        return error_set(error, "not enough memory for a depth buffer of %zux%zu pixels", width,
                         height);
    }
    return true;
}

static void finish(struct drawing *drawing) {
    struct state *state = drawing->state;
    free(state->depth);
    free(state->row);
}

int main(int argc, char **argv) {
    static const struct scene scenes[] = {
        {.name = "rows", .width = ROWS_WIDTH, .height = ROWS_HEIGHT, .draw = draw_rows},
        {
            .name = "zbuffer",
            .width = 800,
            .height = 800,
            .needs_model = true,
            .light = {0, 0, -1},
            .draw = draw_zbuffer,
        },
        {
            .name = "depth",
            .width = 800,
            .height = 800,
            .format = IMAGE_GREY,
            .needs_model = true,
            .light = {0, 0, -1},
            .draw = draw_depth,
        },
    };
    static const struct program program = {
        .name = "step05_zbuffer",
        .summary = "a depth for every pixel: the nearest triangle is seen",
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
