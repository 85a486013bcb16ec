/* The pictures of step 8's README that are not references, and the errors of the attempts. */
#include "../tests/bench/figures.h"

#define LESSON "../step08_projection/main.c"
#include "../tests/lesson.h"

#include "attempts.h"
#include "files/model_file.h"
#include "files/normals.h"

#include <stdio.h>
#include <string.h>

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
static const struct camera side = {{1, 1, 2}, {0, 0, 0}, {0, 1, 0}};
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
    done = done && figure_save(&sheet.image, directory, "distances", error);
    sheet_free(&sheet);
    return done;
}

static bool draw_clipping(struct drawing *drawing, const char *directory, struct error *error) {
    static attempt_draw *const draws[] = {attempt_7_unclipped, attempt_8_left_out, draw_model};
    struct sheet sheet;
    bool done = row_create(&sheet, SIDE, 3, error);
    for (int i = 0; done && i < 3; i++) {
        draw_with(drawing, &sheet.panel, camera_clip(&close_up), draws[i]);
        sheet_add(&sheet);
    }
    done = done && figure_save(&sheet.image, directory, "clipping", error);
    sheet_free(&sheet);
    return done;
}

/* Left the attempt, right the lesson's camera. */
static bool draw_frames(struct drawing *drawing, const char *directory, const char *name,
                        const struct camera *c, attempt_lookat *attempt, struct error *error) {
    struct sheet sheet;
    const struct mat4 to_clip[2] = {
        mat4_mul(projection(camera_distance(c)), attempt(c->eye, c->center, c->up)),
        camera_clip(c),
    };
    bool done = row_create(&sheet, SIDE, 2, error);
    for (int i = 0; done && i < 2; i++) {
        draw_with(drawing, &sheet.panel, to_clip[i], draw_model);
        sheet_add(&sheet);
    }
    done = done && figure_save(&sheet.image, directory, name, error);
    sheet_free(&sheet);
    return done;
}

/* Left the normals sent through the matrix of the points, right through its inverse transpose. */
static bool draw_narrow_normals(struct drawing *drawing, const char *directory,
                                struct error *error) {
    const struct mat4 to_world = narrow_to_world();
    const struct mat4 to_clip = mat4_mul(camera_clip(&front), to_world);
    const struct mat4 normals[2] = {to_world, normals_to_world(to_world)};
    struct sheet sheet;
    bool done = row_create(&sheet, SIDE, 2, error);
    for (int i = 0; done && i < 2; i++) {
        struct canvas canvas = make_canvas(drawing, &sheet.panel, whole_image(&sheet.panel));
        canvas.normals_to_world = normals[i];
        depth_clear(drawing->depth, sheet.panel.width * sheet.panel.height);
        draw_model(drawing, &canvas, &to_clip);
        sheet_add(&sheet);
    }
    done = done && figure_save(&sheet.image, directory, "narrow", error);
    sheet_free(&sheet);
    return done;
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
    done = done && figure_save(&sheet.image, directory, "evenly", error);
    sheet_free(&sheet);
    return done;
}

/* ---- Quads ---- */

/* Two pictures of quads, each with its own matrix and way to draw. */
struct pair {
    const char *name;
    const struct quad *quads;
    size_t quad_count;
    struct mat4 to_clip[2];
    attempt_draw *draw[2];
};

static bool draw_pair(const struct drawing *drawing, const char *directory, const struct pair *pair,
                      struct error *error) {
    struct quad_model made;
    struct texture tiles = {0};
    struct sheet sheet = {0};
    quad_model_make(&made, pair->quads, pair->quad_count, drawing->light);
    struct drawing of_quads = drawing_of_quads(drawing, &made, &tiles);
    bool done = make_tiles(&tiles, error) && row_create(&sheet, SIDE, 2, error);
    for (int i = 0; done && i < 2; i++) {
        draw_with(&of_quads, &sheet.panel, pair->to_clip[i], pair->draw[i]);
        sheet_add(&sheet);
    }
    done = done && figure_save(&sheet.image, directory, pair->name, error);
    sheet_free(&sheet);
    texture_free(&tiles);
    return done;
}

static bool draw_pairs(const struct drawing *drawing, const char *directory, struct error *error) {
    const struct mat4 frame = camera_frame(&front), seen = camera_clip(&front);
    const struct pair pairs[] = {
        /* as lesson 7 sees it, and in perspective */
        {"parallel", &wall, 1, {frame, seen}, {draw_model, draw_model}},
        {"affine", &wall, 1, {seen, seen}, {attempt_3_affine, draw_model}},
        {"crossing", crossing, CROSSING_QUADS, {seen, seen}, {attempt_2_depth_z, draw_model}},
    };
    bool done = true;
    for (size_t i = 0; done && i < sizeof pairs / sizeof pairs[0]; i++) {
        done = draw_pair(drawing, directory, &pairs[i], error);
    }
    return done;
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
    done = done && figure_save(&sheet.image, directory, "normals", error);
    sheet_free(&sheet);
    return done;
}

/* ---- Numbers ---- */

/* The greatest error in 1/256 pixel, and how many corners are snapped to another place than the
 * exact ones. Where long double has no more bits than double the second version looks exact. */
static void print_chain(const struct model *model, const char *scene, const struct camera *c,
                        const char *name, attempt_chain *chain) {
    const struct mat4 to_clip = camera_clip(c), to_screen = viewport(800, 800);
    double worst = 0;
    size_t seen = 0, elsewhere = 0;
    for (size_t i = 0; i < model->position_count; i++) {
        struct vec3 p = model->positions[i];
        if (find_beyond(mat4_point(&to_clip, p)) != 0) {
            continue;
        }
        long double exact[2];
        struct fixed2 a = {0, 0}, b = {0, 0};
        struct vec2 screen = chain(&to_clip, &to_screen, p);
        attempt_exact(&to_clip, &to_screen, p, exact);
        double x = (double)(screen.x - exact[0]), y = (double)(screen.y - exact[1]);
        double error = fmax(fabs(x), fabs(y)) * SUBPIXELS;
        worst = error > worst ? error : worst;
        screen_snap(screen, &a);
        screen_snap((struct vec2){(double)exact[0], (double)exact[1]}, &b);
        elsewhere += a.x != b.x || a.y != b.y;
        seen++;
    }
    printf("    %-8s %-8s %10.1e %10zu of %zu\n", scene, name, worst, elsewhere, seen);
}

/* To the clip space of a matrix, back by its inverse, and to the screen again: how far is the point
 * from where it was? */
static void print_inverse(const struct model *model, const char *matrix, struct mat4 to_clip,
                          const char *name, attempt_inverse *invert) {
    const struct mat4 to_screen = viewport(800, 800);
    struct mat4 inverse;
    if (!invert(to_clip, &inverse)) {
        printf("    %-16s %-18s   no inverse\n", matrix, name);
        return;
    }
    long double worst = 0;
    for (size_t i = 0; i < model->position_count; i++) {
        long double before[2], after[2];
        struct vec3 p = model->positions[i];
        struct vec4 clip = mat4_point(&to_clip, p), back = mat4_apply(&inverse, clip);
        struct vec3 q = {back.x / back.w, back.y / back.w, back.z / back.w};
        attempt_exact(&to_clip, &to_screen, p, before);
        attempt_exact(&to_clip, &to_screen, q, after);
        for (int k = 0; k < 2; k++) {
            long double error = after[k] - before[k];
            error = error < 0 ? -error : error;
            worst = error > worst ? error : worst;
        }
    }
    printf("    %-16s %-18s %10.1e\n", matrix, name, (double)worst * SUBPIXELS);
}

/* Flat like a sheet of paper, and leaning: x, y and z are hard to tell apart. */
static struct mat4 nearly_flat(void) {
    struct mat4 flat = mat4_identity();
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) {
            flat.m[row][column] = (row == column ? 1e-5 : 0) + 1.0 / (1 + row + column);
        }
    }
    flat.m[2][0] = flat.m[0][0] + flat.m[1][0] + 1e-6;
    flat.m[2][1] = flat.m[0][1] + flat.m[1][1];
    flat.m[2][2] = flat.m[0][2] + flat.m[1][2];
    return flat;
}

/* A model in very small units: the determinant is 1e-360, less than any double. */
static struct mat4 tiny_units(void) {
    struct mat4 tiny = mat4_scaling((struct vec3){1e-90, 1e-90, 1e-90});
    tiny.m[3][3] = 1e-90;
    return tiny;
}

static void print_numbers(const struct drawing *drawing) {
    const struct model *model = drawing->model;
    const struct {
        const char *name;
        attempt_inverse *invert;
    } inverses[] = {{"cofactors, float", attempt_12_cofactors_float},
                    {"cofactors, double", attempt_11_cofactors},
                    {"mat4_inverse()", mat4_inverse}};
    printf("step08_projection: where the model's corners lie on 800x800 pixels\n");
    printf("    scene    version   1/256 px  snapped elsewhere\n");
    print_chain(model, "lookat", &side, "float", attempt_9_float);
    print_chain(model, "lookat", &side, "double", attempt_10_double);
    print_chain(model, "closeup", &close_up, "float", attempt_9_float);
    print_chain(model, "closeup", &close_up, "double", attempt_10_double);
    printf("step08_projection: there and back by the inverse\n");
    printf("    matrix           version              1/256 px\n");
    for (size_t i = 0; i < 3; i++) {
        print_inverse(model, "camera of lookat", camera_clip(&side), inverses[i].name,
                      inverses[i].invert);
        print_inverse(model, "nearly flat", nearly_flat(), inverses[i].name, inverses[i].invert);
        print_inverse(model, "tiny units", tiny_units(), inverses[i].name, inverses[i].invert);
    }
}

/* Pixels that are black in an image and not in the right one. */
static size_t missing_pixels(const struct image *right, const struct image *image) {
    static const uint8_t black[3] = {0, 0, 0};
    size_t missing = 0;
    for (size_t i = 0; i < 3 * image->width * image->height; i += 3) {
        missing +=
            memcmp(image->pixels + i, black, 3) == 0 && memcmp(right->pixels + i, black, 3) != 0;
    }
    return missing;
}

/* Pixels that differ so much that the check minds: by more than 4 in some channel. */
static size_t clearly_different_pixels(const struct image *right, const struct image *image) {
    size_t different = 0;
    for (size_t i = 0; i < 3 * image->width * image->height; i += 3) {
        bool clearly = false;
        for (size_t k = i; k < i + 3; k++) {
            clearly |= abs(right->pixels[k] - image->pixels[k]) > 4;
        }
        different += clearly;
    }
    return different;
}

/* Compare a version's picture with the lesson's. */
static bool print_picture(struct drawing *drawing, const char *scene, const struct camera *c,
                          const char *name, attempt_draw *draw, struct error *error) {
    struct image right = {0}, image = {0};
    bool done = image_create(&right, 800, 800, IMAGE_BGR, error) &&
                image_create(&image, 800, 800, IMAGE_BGR, error);
    if (done) {
        draw_with(drawing, &right, camera_clip(c), draw_model);
        draw_with(drawing, &image, camera_clip(c), draw);
        printf("    %-8s %-10s %8zu %8zu %8zu\n", scene, name, different_pixels(&right, &image),
               clearly_different_pixels(&right, &image), missing_pixels(&right, &image));
    }
    image_free(&right);
    image_free(&image);
    return done;
}

static bool print_pictures(struct drawing *drawing, struct error *error) {
    printf("step08_projection: pixels that differ from the lesson's picture\n");
    printf("    scene    version     differ  clearly  missing\n");
    return print_picture(drawing, "lookat", &side, "affine", attempt_3_affine, error) &&
           print_picture(drawing, "closeup", &close_up, "unclipped", attempt_7_unclipped, error) &&
           print_picture(drawing, "closeup", &close_up, "left out", attempt_8_left_out, error);
}

/* ---- The program ---- */

static bool draw_all(struct drawing *drawing, const char *directory, struct error *error) {
    static const struct camera off_center = {{1, 1.3, 2}, {0.1, 0.3, 0.2}, {0, 1, 0}};
    static const struct camera above = {{0, 2, 0}, {0, 0, 0}, {0, 1, 0}};
    return draw_distances(drawing, directory, error) && draw_pairs(drawing, directory, error) &&
           draw_evenly(directory, error) && draw_narrow_normals(drawing, directory, error) &&
           draw_clipping(drawing, directory, error) &&
           draw_frames(drawing, directory, "unrotated", &off_center, attempt_5_unrotated, error) &&
           draw_frames(drawing, directory, "careless", &above, attempt_6_careless, error) &&
           draw_normals(directory, error);
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    struct state state = {0};
    struct drawing drawing = {.light = {1, 1, 2}, .skip = true, .model = bust, .state = &state};
    drawing.depth = malloc(800 * 800 * sizeof *drawing.depth);
    drawing.diffuse = model_texture(bust, MODEL_DIFFUSE, error);
    bool done = drawing.depth != NULL || error_out_of_memory(error);
    done = done && drawing.diffuse != NULL && model_need_normals(bust, error) &&
           prepare(&drawing, 800, 800, error);
    if (done) {
        print_numbers(&drawing);
        done = print_pictures(&drawing, error) && draw_all(&drawing, directory, error);
    }
    finish(&drawing);
    free(drawing.depth);
    return done;
}
