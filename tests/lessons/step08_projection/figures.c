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

/* The whole of a panel, with nothing drawn yet. */
static struct canvas canvas_of(const struct drawing *drawing, struct image *image,
                               struct mat4 to_clip) {
    depth_clear(drawing->depth, image->width * image->height);
    return make_canvas(drawing, image, whole_image(image), to_clip);
}

/* ---- The figures with the model ---- */

/* The same head from three distances, and from infinitely far away. */
static void draw_distances(struct drawing *drawing) {
    static const double distances[4] = {1, 2, 4, INFINITY};
    struct sheet sheet = row_create(SMALL_SIDE, 4);
    for (int i = 0; i < 4; i++) {
        struct canvas canvas = canvas_of(drawing, &sheet.panel, projection(distances[i]));
        draw_model(drawing, &canvas, false);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "distances");
}

static void draw_clipping(const struct drawing *drawing) {
    static attempt_clipping *const versions[] = {attempt_7_unclipped, attempt_8_left_out,
                                                 clip_face};
    const struct drawing close = seen_close_up(drawing);
    struct sheet sheet = row_create(SIDE, 3);
    for (int i = 0; i < 3; i++) {
        const struct canvas canvas = canvas_of(&close, &sheet.panel, camera_clip(&close));
        for (size_t face = 0; face < close.model->face_count; face++) {
            struct face_corner corner[3];
            fetch_face(close.model, face, corner);
            struct polygon polygon = transform_face(&canvas, corner);
            versions[i](&polygon);
            draw_polygon(&canvas, corner, &polygon);
        }
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
static void draw_behind_red(const struct drawing *drawing, struct image *image,
                            const struct mat4 *to_clip, const struct mat4 *close_clip) {
    const struct texture red = make_red();
    struct canvas canvas = canvas_of(drawing, image, *to_clip);
    for (size_t i = 0; i < drawing->model->face_count; i++) {
        struct face_corner corner[3];
        fetch_face(drawing->model, i, corner);
        canvas.texture =
            mat4_point(close_clip, corner[0].position).w < near_w ? &red : drawing->diffuse;
        draw_face(&canvas, corner);
    }
}

/* The plane through the camera, and the lower and the upper side of what it sees. */
static void draw_close_camera(struct image *image, const struct mat4 *to_clip,
                              const struct drawing *close) {
    const struct mat4 to_screen = area_to_screen(whole_image(image));
    const struct plane plane = {image, whole_image(image), mat4_identity()};
    const struct mat4 back = mat4_transpose(lookat(close->eye, close->center, close->up));
    const struct vec3 ends[] = {{0, -3, 0}, {0, 3, 0}, {0, -1, -1}, {0, 1, -1}};
    const struct vec4 eye = mat4_point(to_clip, close->eye);
    const double distance = vec3_length(vec3_sub(close->eye, close->center));
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        double along = i < 2 ? 0 : distance - 1; /* ends at z = -distance */
        struct vec3 step = mat4_direction(&back, vec3_sub(ends[i], (struct vec3){0, 0, along}));
        struct vec4 q = mat4_point(to_clip, vec3_add(close->eye, step));
        struct vec2 from = to_pixels(&to_screen, (struct vec2){eye.x, eye.y});
        plane_line(&plane, from, to_pixels(&to_screen, (struct vec2){q.x, q.y}),
                   i < 2 ? color_rgb(255, 90, 70) : color_rgb(120, 200, 255));
    }
}

/* Left panel: the head from the side, with the camera of closeup. Right: what that camera sees. */
static void draw_close(struct drawing *drawing) {
    const struct mat4 from_side =
        lookat((struct vec3){3, 0.4, 0.35}, (struct vec3){0, 0.4, 0.35}, (struct vec3){0, 1, 0});
    const struct mat4 to_clip = mat4_mul(mat4_scaling((struct vec3){1.6, 1.6, 1}), from_side);
    struct drawing close = seen_close_up(drawing);
    const struct mat4 close_clip = camera_clip(&close);
    struct sheet sheet = row_create(LARGE_SIDE, 2);
    draw_behind_red(drawing, &sheet.panel, &to_clip, &close_clip);
    draw_close_camera(&sheet.panel, &to_clip, &close);
    sheet_add(&sheet);
    struct canvas canvas = canvas_of(&close, &sheet.panel, close_clip);
    draw_model(&close, &canvas, false);
    sheet_add(&sheet);
    figure_save(&sheet.image, "close");
}

/* ---- Perspective: lines on a wall ---- */

/* By w. */
static struct vec2 divide_by_w(struct vec3 view, double distance) {
    const struct mat4 to_clip = projection(distance);
    const struct vec4 clip = mat4_point(&to_clip, view);
    return (struct vec2){clip.x / clip.w, clip.y / clip.w};
}

/* Where a point of the wall appears. */
static struct vec2 wall_point(attempt_perspective *see, double u, double v) {
    const struct vec3 left = wall[0].corner[0], right = wall[0].corner[2];
    struct vec3 p = {left.x + u * (right.x - left.x), left.y + v * (right.y - left.y),
                     left.z + u * (right.z - left.z)};
    return see(p, 2); /* the distance of the scenes' camera */
}

static void draw_wall_lines(struct image *image, attempt_perspective *see) {
    enum { LINES = 8, PIECES = 64 };
    const struct rectangle area = whole_image(image);
    const struct plane plane = {image, area, area_to_screen(area)};
    const struct color orange = color_rgb(255, 170, 60);
    for (int i = 0; i <= LINES; i++) {
        for (int k = 0; k < PIECES; k++) {
            double at = (double)i / LINES, from = (double)k / PIECES, to = (k + 1.0) / PIECES;
            plane_line(&plane, wall_point(see, from, at), wall_point(see, to, at), orange);
            plane_line(&plane, wall_point(see, at, from), wall_point(see, at, to), orange);
        }
    }
}

static void draw_evenly(void) {
    static attempt_perspective *const versions[] = {attempt_1_evenly, divide_by_w};
    struct sheet sheet = row_create(SIDE, 2);
    for (int i = 0; i < 2; i++) {
        draw_wall_lines(&sheet.panel, versions[i]);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "evenly");
}

/* ---- The wall without and with perspective ---- */

static void draw_parallel(const struct drawing *drawing) {
    const struct mat4 to_clip[2] = {mat4_identity(), camera_clip(drawing)};
    struct sheet sheet = row_create(SIDE, 2);
    for (int i = 0; i < 2; i++) {
        const struct canvas canvas = canvas_of(drawing, &sheet.panel, to_clip[i]);
        figure_need(draw_quads(&canvas, wall, 1, &figure_error));
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "parallel");
}

/* ---- Normals of a circle that is made an ellipse ---- */

static struct vec3 by_inverse_transpose(const struct mat4 *map, struct vec3 normal) {
    const struct mat4 matrix = normals_to_world(*map);
    return vec3_normalized(mat4_direction(&matrix, normal));
}

static void draw_normals_of(struct image *image, attempt_normal *normal_of) {
    enum { SEGMENTS = 96, NORMALS = 24 };
    const struct mat4 map = mat4_scaling((struct vec3){1.4, 0.5, 1});
    const struct plane plane = plane_in(image, whole_image(image));
    const struct plane mapped = {image, plane.area, mat4_mul(plane.to_screen, map)};
    for (int i = 0; i < SEGMENTS; i++) {
        struct vec2 a = turn_direction((double)i / SEGMENTS);
        struct vec2 b = turn_direction((double)(i + 1) / SEGMENTS);
        plane_line(&mapped, a, b, color_grey(200));
    }
    for (int i = 0; i < NORMALS; i++) {
        struct vec2 n = turn_direction((double)i / NORMALS); /* the point and the normal there */
        struct vec4 p = mat4_point(&map, (struct vec3){n.x, n.y, 0});
        struct vec3 normal = vec3_scale(normal_of(&map, (struct vec3){n.x, n.y, 0}), 0.4);
        plane_line(&plane, (struct vec2){p.x, p.y}, (struct vec2){p.x + normal.x, p.y + normal.y},
                   color_rgb(255, 170, 60));
    }
}

static void draw_normals(void) {
    static attempt_normal *const versions[] = {attempt_4_same_matrix, by_inverse_transpose};
    struct sheet sheet = row_create(SIDE, 2);
    for (int i = 0; i < 2; i++) {
        draw_normals_of(&sheet.panel, versions[i]);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "normals");
}

/* ---- Two frames ---- */

/* An arrow of width 0.05 without a head. */
static void draw_axis(const struct plane *plane, struct vec2 from, struct vec2 axis,
                      struct color color) {
    const struct vec2 to = vec2_add(from, axis), side = {-0.025 * axis.y, 0.025 * axis.x};
    const struct vec2 corner[4] = {vec2_sub(from, side), vec2_sub(to, side), vec2_add(to, side),
                                   vec2_add(from, side)};
    plane_polygon(plane, corner, color);
}

static void draw_dot(const struct plane *plane, struct vec2 p, struct color color) {
    enum { SEGMENTS = 16 };
    for (int i = 0; i < SEGMENTS; i++) {
        const struct vec2 a = vec2_scale(turn_direction((double)i / SEGMENTS), 0.07);
        const struct vec2 b = vec2_scale(turn_direction((double)(i + 1) / SEGMENTS), 0.07);
        const struct vec2 corner[4] = {p, vec2_add(p, a), vec2_add(p, b), vec2_add(p, b)};
        plane_polygon(plane, corner, color);
    }
}

/* The house, the axes of the world and those of a person at c, and how the person measures the
 * house's corner at (1,0). */
static void draw_frame(const struct plane *plane, struct vec2 c, struct vec2 right,
                       struct vec2 ahead) {
    const struct vec2 corner = {1, 0}, q = vec2_sub(corner, c);
    const double along = q.x * right.x + q.y * right.y;
    fill_area(plane->image, plane->area, color_grey(26));
    plane_line(plane, (struct vec2){-9, 0}, (struct vec2){9, 0}, color_grey(120));
    plane_line(plane, (struct vec2){0, -9}, (struct vec2){0, 9}, color_grey(120));
    draw_house(plane);
    draw_axis(plane, c, right, color_rgb(255, 150, 40));
    draw_axis(plane, c, ahead, color_rgb(70, 210, 110));
    plane_line(plane, c, vec2_add(c, vec2_scale(right, along)), color_grey(255));
    plane_line(plane, corner, vec2_add(c, vec2_scale(right, along)), color_grey(255));
    draw_dot(plane, c, color_grey(160));
    draw_dot(plane, corner, color_grey(255));
}

/* Left with the world's axes upright, right with the person's. */
static void draw_frames(void) {
    const struct vec2 c = {0, -1}, right = {0.8, 0.6}, ahead = {-0.6, 0.8};
    const struct mat4 rows = {
        {{right.x, right.y, 0, 0}, {ahead.x, ahead.y, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const struct mat4 aside = mat4_translation((struct vec3){-0.5, -0.1, 0});
    const struct mat4 maps[2] = {mat4_identity(),
                                 mat4_mul(rows, mat4_translation((struct vec3){-c.x, -c.y, 0}))};
    struct sheet sheet = row_create(LARGE_SIDE, 2);
    for (int i = 0; i < 2; i++) {
        struct plane plane = plane_in(&sheet.panel, whole_image(&sheet.panel));
        plane.to_screen = mat4_mul(plane.to_screen, mat4_mul(aside, maps[i]));
        draw_frame(&plane, c, right, ahead);
        sheet_add(&sheet);
    }
    figure_save(&sheet.image, "frames");
}

/* ---- The program ---- */

void draw_figures(struct model *bust) {
    struct drawing drawing = {.eye = {0, 0, 2}, .up = {0, 1, 0}, .light = {1, 1, 2}, .model = bust};
    drawing.depth = figure_memory(LARGE_SIDE * LARGE_SIDE, sizeof *drawing.depth);
    drawing.diffuse = model_texture(bust, MODEL_DIFFUSE, &figure_error);
    figure_need(drawing.diffuse != NULL && model_need_normals(bust, &figure_error));
    draw_distances(&drawing);
    draw_parallel(&drawing);
    draw_evenly();
    draw_close(&drawing);
    draw_clipping(&drawing);
    draw_normals();
    draw_frames();
}
