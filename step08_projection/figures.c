/* The pictures of step 8's README that are not references. */
#include "../tests/bench/figures.h"

#define LESSON "../step08_projection/main.c"
#include "../tests/lesson.h"

#include "attempts.h"
#include "files/model_file.h"
#include "files/normals.h"

enum { SIDE = 260, SMALL_SIDE = 200, GAP = 6 }; /* pixels of a panel, and between two panels */

/* A row of square panels. */
static bool row_create(struct sheet *sheet, size_t side, size_t columns, struct error *error) {
    *sheet =
        (struct sheet){.width = side, .height = side, .columns = columns, .rows = 1, .gap = GAP};
    return sheet_create(sheet, error);
}

/* ---- Cameras ---- */

struct camera {
    struct vec3 eye, center, up;
};

static const struct camera front = {{0, 0, 2}, {0, 0, 0}, {0, 1, 0}};
static const struct camera close_up = {{0.03, 0.47, 0.46}, {0.03, -0.3, 0.4}, {0, 0, 1}};

static double camera_distance(const struct camera *c) {
    return vec3_length(vec3_sub(c->eye, c->center));
}

static struct mat4 camera_frame(const struct camera *c) {
    return lookat(c->eye, c->center, c->up);
}

static struct mat4 camera_clip(const struct camera *c) {
    return mat4_mul(projection(camera_distance(c)), camera_frame(c));
}

/* Draw the model into the whole image. */
static void draw_with(struct drawing *drawing, struct image *image, struct mat4 to_clip,
                      attempt_draw *draw) {
    struct canvas canvas = make_canvas(drawing, image, whole_image(image));
    depth_clear(drawing->depth, image->width * image->height);
    draw(drawing, &canvas, &to_clip);
}

/* ---- The figures with the model ---- */

/* The same head from three distances, and from infinitely far away. */
static bool draw_distances(struct drawing *drawing, const char *directory, struct error *error) {
    static const double distances[4] = {1, 2, 4, INFINITY};
    struct sheet sheet;
    bool done = row_create(&sheet, SMALL_SIDE, 4, error);
    for (int i = 0; done && i < 4; i++) {
        draw_with(drawing, &sheet.panel, mat4_mul(projection(distances[i]), camera_frame(&front)),
                  draw_model);
        sheet_add(&sheet);
    }
    return sheet_end(&sheet, done, directory, "distances", error);
}

static bool draw_clipping(struct drawing *drawing, const char *directory, struct error *error) {
    static attempt_draw *const draws[] = {attempt_7_unclipped, attempt_8_left_out, draw_model};
    struct sheet sheet;
    bool done = row_create(&sheet, SIDE, 3, error);
    for (int i = 0; done && i < 3; i++) {
        draw_with(drawing, &sheet.panel, camera_clip(&close_up), draws[i]);
        sheet_add(&sheet);
    }
    return sheet_end(&sheet, done, directory, "clipping", error);
}

/* ---- Perspective: lines on a wall ---- */

/* Where a point of the wall appears, in pixels. */
static struct pixel wall_pixel(const struct plane *plane, attempt_perspective *see, double u,
                               double v) {
    const struct vec3 left = wall.corner[0], right = wall.corner[2];
    struct vec3 p = {left.x + u * (right.x - left.x), left.y + v * (right.y - left.y),
                     left.z + u * (right.z - left.z)};
    const struct mat4 to_screen = area_to_screen(plane->area), still = mat4_identity();
    struct vec2 seen = to_pixels(&still, see(p, camera_distance(&front)));
    struct vec2 screen = to_pixels(&to_screen, seen);
    return (struct pixel){(int)floor(screen.x), (int)floor(screen.y)};
}

static void draw_wall_line(const struct plane *plane, struct pixel p, struct pixel q) {
    struct line_walk walk;
    bool more = line_begin(&walk, p, q, plane->image->width, plane->image->height);
    for (; more; more = line_next(&walk)) {
        plane_pixel(plane, walk.x, walk.y, color_rgb(255, 170, 60));
    }
}

static void draw_wall_lines(struct image *image, attempt_perspective *see) {
    enum { LINES = 8, PIECES = 64 };
    const struct plane plane = {image, whole_image(image)};
    for (int i = 0; i <= LINES; i++) {
        for (int k = 0; k < PIECES; k++) {
            double at = (double)i / LINES, from = (double)k / PIECES, to = (k + 1.0) / PIECES;
            draw_wall_line(&plane, wall_pixel(&plane, see, from, at),
                           wall_pixel(&plane, see, to, at));
            draw_wall_line(&plane, wall_pixel(&plane, see, at, from),
                           wall_pixel(&plane, see, at, to));
        }
    }
}

static bool draw_evenly(const char *directory, struct error *error) {
    static attempt_perspective *const versions[] = {attempt_1_evenly, attempt_14_divided};
    struct sheet sheet;
    bool done = row_create(&sheet, SIDE, 2, error);
    for (int i = 0; done && i < 2; i++) {
        draw_wall_lines(&sheet.panel, versions[i]);
        sheet_add(&sheet);
    }
    return sheet_end(&sheet, done, directory, "evenly", error);
}

/* ---- The wall without and with perspective ---- */

static bool draw_parallel(const struct drawing *drawing, const char *directory,
                          struct error *error) {
    const struct mat4 to_clip[2] = {camera_frame(&front), camera_clip(&front)};
    struct quad_model made;
    struct texture tiles = {0};
    struct sheet sheet = {0};
    quad_model_make(&made, &wall, 1, drawing->light);
    struct drawing of_quads = drawing_of_quads(drawing, &made, &tiles);
    bool done = make_tiles(&tiles, error) && row_create(&sheet, SIDE, 2, error);
    for (int i = 0; done && i < 2; i++) {
        draw_with(&of_quads, &sheet.panel, to_clip[i], draw_model);
        sheet_add(&sheet);
    }
    texture_free(&tiles);
    return sheet_end(&sheet, done, directory, "parallel", error);
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

static bool draw_normals(const char *directory, struct error *error) {
    static attempt_normal *const versions[] = {attempt_4_same_matrix, attempt_13_inverse_transpose};
    struct sheet sheet;
    bool done = row_create(&sheet, SIDE, 2, error);
    for (int i = 0; done && i < 2; i++) {
        draw_normals_of(&sheet.panel, versions[i]);
        sheet_add(&sheet);
    }
    return sheet_end(&sheet, done, directory, "normals", error);
}

/* ---- The program ---- */

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    struct state state = {0};
    struct drawing drawing = {.light = {1, 1, 2}, .skip = true, .model = bust, .state = &state};
    drawing.depth = malloc(800 * 800 * sizeof *drawing.depth);
    drawing.diffuse = model_texture(bust, MODEL_DIFFUSE, error);
    bool done = drawing.depth != NULL || error_out_of_memory(error);
    done = done && drawing.diffuse != NULL && model_need_normals(bust, error) &&
           prepare(&drawing, 800, 800, error);
    done = done && draw_distances(&drawing, directory, error) &&
           draw_parallel(&drawing, directory, error) && draw_evenly(directory, error) &&
           draw_clipping(&drawing, directory, error) && draw_normals(directory, error);
    finish(&drawing);
    free(drawing.depth);
    return done;
}
