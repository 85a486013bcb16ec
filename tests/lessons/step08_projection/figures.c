/* The pictures of lesson 8 that are not references. */
#include "bench/figures.h"

#define LESSON "../step08_projection/main.c"
#include "lesson.h"

#include "../../../step08_projection/attempts.h"
#include "files/model_file.h"
#include "files/normals.h"

enum { LARGE_SIDE = 390, SIDE = 260, SMALL_SIDE = 200, GAP = 6 }; /* pixels; GAP: between panels */

/* A row of square panels. */
static struct sheet row_create(size_t side, size_t columns) {
    struct sheet sheet = {.width = side, .height = side, .columns = columns, .rows = 1, .gap = GAP};
    sheet_create(&sheet);
    return sheet;
}

/* The drawing, seen by the camera of closeup. */
static struct drawing seen_close_up(const struct drawing *drawing) {
    struct drawing close = *drawing;
    close.eye = (struct vec3){0.03, 0.47, 0.46};
    close.center = (struct vec3){0.03, -0.3, 0.4};
    close.up = (struct vec3){0, 0, 1};
    return close;
}

/* Draw the model into the whole image. */
static void draw_with(struct drawing *drawing, struct image *image, struct mat4 to_clip) {
    struct canvas canvas = make_canvas(drawing, image, whole_image(image));
    depth_clear(drawing->depth, image->width * image->height);
    draw_model(drawing, &canvas, &to_clip);
}

/* ---- The figures with the model ---- */

/* The same head from three distances, and from infinitely far away. */
static void draw_distances(struct drawing *drawing) {
    static const double distances[4] = {1, 2, 4, INFINITY};
    struct sheet sheet = row_create(SMALL_SIDE, 4);
    for (int i = 0; i < 4; i++) {
        draw_with(drawing, &sheet.panel, camera(drawing, distances[i]));
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "distances");
}

static void draw_clipping(const struct drawing *drawing) {
    static const enum attempt attempts[] = {UNCLIPPED, LEFT_OUT, CUT};
    struct drawing close = seen_close_up(drawing);
    struct sheet sheet = row_create(SIDE, 3);
    close.values = attempt_values;
    for (int i = 0; i < 3; i++) {
        close.value[0] = attempts[i];
        draw_with(&close, &sheet.panel, perspective_camera(&close));
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "clipping");
}

/* ---- Where the camera of closeup is ---- */

static struct texture make_red(void) {
    struct texture texture;
    struct image image = figure_image(1, 1);
    image_set(&image, 0, 0, color_rgb(255, 90, 70));
    figure_need(texture_create(&texture, &image, &figure_error));
    return texture;
}

/* The head, with those faces red that are behind the close camera. */
static void draw_behind_red(struct drawing *drawing, struct image *image,
                            const struct mat4 *to_clip, const struct mat4 *close_clip) {
    const struct texture red = make_red();
    struct canvas canvas = make_canvas(drawing, image, whole_image(image));
    depth_clear(drawing->depth, image->width * image->height);
    transform_positions(drawing, to_clip);
    for (size_t i = 0; i < drawing->model->face_count; i++) {
        const struct corner *c = drawing->model->faces[i].corner;
        struct vec4 seen = mat4_point(close_clip, drawing->model->positions[c[0].position]);
        canvas.texture = seen.w < near_w ? &red : drawing->diffuse;
        draw_face(drawing, &canvas, i);
    }
}

/* The plane through the camera, and the lower and the upper side of what it sees. */
static void draw_close_camera(struct image *image, const struct mat4 *to_clip,
                              const struct drawing *close) {
    const struct plane plane = {image, whole_image(image)};
    const struct mat4 to_screen = area_to_screen(plane.area), still = mat4_identity();
    const struct mat4 back = mat4_transpose(lookat(close->eye, close->center, close->up));
    const struct vec3 ends[] = {{0, -3, 0}, {0, 3, 0}, {0, -1, -1}, {0, 1, -1}};
    const struct vec4 eye = mat4_point(to_clip, close->eye);
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        double along = i < 2 ? 0 : eye_distance(close) - 1; /* ends at z = -distance */
        struct vec3 step = mat4_direction(&back, vec3_sub(ends[i], (struct vec3){0, 0, along}));
        struct vec4 q = mat4_point(to_clip, vec3_add(close->eye, step));
        struct vec2 from = to_pixels(&to_screen, (struct vec2){eye.x, eye.y});
        plane_line(&plane, &still, from, to_pixels(&to_screen, (struct vec2){q.x, q.y}),
                   i < 2 ? color_rgb(255, 90, 70) : color_rgb(120, 200, 255));
    }
}

/* Left panel: the head from the side, with the camera of closeup. Right: what that camera sees. */
static void draw_close(struct drawing *drawing) {
    const struct mat4 from_side =
        lookat((struct vec3){3, 0.4, 0.35}, (struct vec3){0, 0.4, 0.35}, (struct vec3){0, 1, 0});
    const struct mat4 to_clip = mat4_mul(mat4_scaling((struct vec3){1.6, 1.6, 1}), from_side);
    struct drawing close = seen_close_up(drawing);
    const struct mat4 close_clip = perspective_camera(&close);
    struct sheet sheet = row_create(LARGE_SIDE, 2);
    draw_behind_red(drawing, &sheet.panel, &to_clip, &close_clip);
    draw_close_camera(&sheet.panel, &to_clip, &close);
    sheet_add(&sheet);
    draw_with(&close, &sheet.panel, close_clip);
    sheet_add(&sheet);
    figure_save(&sheet.image, "close");
}

/* ---- Perspective: lines on a wall ---- */

/* Where a point of the wall appears. */
static struct vec2 wall_point(attempt_perspective *see, double u, double v) {
    const struct vec3 left = wall.corner[0], right = wall.corner[2];
    struct vec3 p = {left.x + u * (right.x - left.x), left.y + v * (right.y - left.y),
                     left.z + u * (right.z - left.z)};
    return see(p, 2); /* the distance of the scenes' camera */
}

static void draw_wall_lines(struct image *image, attempt_perspective *see) {
    enum { LINES = 8, PIECES = 64 };
    const struct plane plane = {image, whole_image(image)};
    const struct mat4 to_screen = area_to_screen(plane.area);
    const struct color orange = color_rgb(255, 170, 60);
    for (int i = 0; i <= LINES; i++) {
        for (int k = 0; k < PIECES; k++) {
            double at = (double)i / LINES, from = (double)k / PIECES, to = (k + 1.0) / PIECES;
            plane_line(&plane, &to_screen, wall_point(see, from, at), wall_point(see, to, at),
                       orange);
            plane_line(&plane, &to_screen, wall_point(see, at, from), wall_point(see, at, to),
                       orange);
        }
    }
}

static void draw_evenly(void) {
    static attempt_perspective *const versions[] = {attempt_1_evenly, attempt_14_divided};
    struct sheet sheet = row_create(SIDE, 2);
    for (int i = 0; i < 2; i++) {
        draw_wall_lines(&sheet.panel, versions[i]);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "evenly");
}

/* ---- The wall without and with perspective ---- */

static void draw_parallel(const struct drawing *drawing) {
    const struct mat4 to_clip[2] = {parallel_camera(drawing), perspective_camera(drawing)};
    struct quad_model made;
    struct texture tiles;
    struct sheet sheet = row_create(SIDE, 2);
    figure_need(make_tiles(&tiles, &figure_error));
    quad_model_make(&made, &wall, 1, drawing->light);
    struct drawing of_quads = drawing_of_quads(drawing, &made, &tiles);
    for (int i = 0; i < 2; i++) {
        draw_with(&of_quads, &sheet.panel, to_clip[i]);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "parallel");
}

/* ---- Normals of a circle that is made an ellipse ---- */

static void draw_normals_of(struct image *image, attempt_normal *normal_of) {
    enum { SEGMENTS = 96, NORMALS = 24 };
    const struct plane plane = {image, whole_image(image)};
    const struct mat4 map = mat4_scaling((struct vec3){1.4, 0.5, 1});
    const struct mat4 to_screen = panel_to_screen(plane.area);
    for (int i = 0; i < SEGMENTS; i++) {
        struct vec2 a = turn_direction((double)i / SEGMENTS);
        struct vec2 b = turn_direction((double)(i + 1) / SEGMENTS);
        const struct mat4 mapped = mat4_mul(to_screen, map);
        plane_line(&plane, &mapped, a, b, color_grey(200));
    }
    for (int i = 0; i < NORMALS; i++) {
        struct vec2 n = turn_direction((double)i / NORMALS); /* the point and the normal there */
        struct vec4 p = mat4_point(&map, (struct vec3){n.x, n.y, 0});
        struct vec3 normal = vec3_scale(normal_of(&map, (struct vec3){n.x, n.y, 0}), 0.4);
        plane_line(&plane, &to_screen, (struct vec2){p.x, p.y},
                   (struct vec2){p.x + normal.x, p.y + normal.y}, color_rgb(255, 170, 60));
    }
}

static void draw_normals(void) {
    static attempt_normal *const versions[] = {attempt_4_same_matrix, attempt_13_inverse_transpose};
    struct sheet sheet = row_create(SIDE, 2);
    for (int i = 0; i < 2; i++) {
        draw_normals_of(&sheet.panel, versions[i]);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "normals");
}

/* ---- The program ---- */

void draw_figures(struct model *bust) {
    struct state state = {0};
    struct drawing drawing = {.eye = {0, 0, 2},
                              .up = {0, 1, 0},
                              .light = {1, 1, 2},
                              .skip = true,
                              .model = bust,
                              .state = &state};
    drawing.depth = figure_memory(LARGE_SIDE * LARGE_SIDE, sizeof *drawing.depth);
    drawing.diffuse = model_texture(bust, MODEL_DIFFUSE, &figure_error);
    figure_need(drawing.diffuse != NULL && model_need_normals(bust, &figure_error) &&
                prepare(&drawing, 800, 800, &figure_error));
    draw_distances(&drawing);
    draw_parallel(&drawing);
    draw_evenly();
    draw_close(&drawing);
    draw_clipping(&drawing);
    draw_normals();
}
