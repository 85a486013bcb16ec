/* The pictures of step 3's README that are not references, and the numbers of its tables. */
#include "../tests/bench/figures.h"

#define LESSON "../step03_triangle/main.c"
#include "../tests/lesson.h"

#include "attempts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GRID = 60 }; /* grey level of the lines between enlarged pixels */

/* ---- Meshes on the screen ---- */

/* Triangles with corners in pixels, already snapped to 1/256, so that all attempts get the same. */
struct mesh {
    struct vec2 (*corners)[3];
    size_t count;
};

static void mesh_free(struct mesh *mesh) {
    free(mesh->corners);
    *mesh = (struct mesh){0};
}

static bool mesh_create(struct mesh *mesh, size_t limit, struct error *error) {
    *mesh = (struct mesh){.corners = malloc(limit * sizeof *mesh->corners)};
    if (mesh->corners == NULL) {
        error_out_of_memory(error);
    }
    return mesh->corners != NULL;
}

/* The faces of the model that show their outside. */
static bool mesh_from_model(struct mesh *mesh, const struct model *model, const struct image *image,
                            struct error *error) {
    if (!mesh_create(mesh, model->face_count, error)) {
        return false;
    }
    for (size_t face = 0; face < model->face_count; face++) {
        struct fixed2 corner[3];
        uint64_t turned_away = 0;
        if (!place_face(model, face, image, corner, &turned_away)) {
            continue;
        }
        for (int i = 0; i < 3; i++) {
            mesh->corners[mesh->count][i] = in_pixels(corner[i]);
        }
        mesh->count++;
    }
    return true;
}

/* A mesh of the scenes. */
static bool mesh_from_scene(struct mesh *mesh, mesh_function *place, int count,
                            const struct image *image, struct error *error) {
    if (!mesh_create(mesh, (size_t)count, error)) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        struct fixed2 corner[3];
        place(i, image, corner);
        for (int k = 0; k < 3; k++) {
            mesh->corners[mesh->count][k] = in_pixels(corner[k]);
        }
        mesh->count++;
    }
    return true;
}

/* ---- Counting how often each pixel is drawn ---- */

typedef void attempt_function(struct target *target, const struct vec2 corner[3],
                              struct color color);

/* The edges of a triangle of a mesh. False when it certainly covers no pixel. */
static bool corners_setup(struct edges *edges, const struct vec2 corner[3],
                          const struct image *image) {
    struct fixed2 p[3];
    for (int i = 0; i < 3; i++) {
        if (!screen_snap(corner[i], &p[i])) {
            return false;
        }
    }
    return triangle_setup(edges, p[0], p[1], p[2], image->width, image->height);
}

/* The good version: spans. */
static void draw_spans(struct target *target, const struct vec2 corner[3], struct color color) {
    struct edges edges;
    if (corners_setup(&edges, corner, target->image)) {
        for (int y = edges.y_begin; y < edges.y_end; y++) {
            struct span span = triangle_span(&edges, y);
            for (int x = span.begin; x < span.end; x++) {
                target_put(target, x, y, color);
            }
        }
    }
}

/* Draw a mesh, each triangle in its own colour, and count. `draws` may be NULL. */
static void draw_mesh(const struct mesh *mesh, attempt_function *draw, struct image *image,
                      uint8_t *draws) {
    struct target target = {.image = image, .draws = draws};
    if (draws != NULL) {
        memset(draws, 0, image->width * image->height);
    }
    image_clear(image, color_grey(0));
    for (size_t i = 0; i < mesh->count; i++) {
        draw(&target, mesh->corners[i], face_color(i));
    }
}

/* How often each pixel must be drawn: the three edge functions, asked at every pixel. */
static void count_exactly(const struct mesh *mesh, const struct image *image, uint8_t *draws) {
    int width = (int)image->width;
    memset(draws, 0, image->width * image->height);
    for (size_t i = 0; i < mesh->count; i++) {
        struct edges edges;
        if (!corners_setup(&edges, mesh->corners[i], image)) {
            continue;
        }
        for (int y = edges.y_begin; y < edges.y_end; y++) {
            for (int x = 0; x < width; x++) {
                draws[y * width + x] = (uint8_t)(draws[y * width + x] + edges_cover(&edges, x, y));
            }
        }
    }
}

/* Compare two counts as a picture: grey where they agree, orange where a pixel was drawn too often,
 * magenta where it was drawn too rarely. */
static void show_draws(struct image *image, const uint8_t *draws, const uint8_t *exact) {
    for (int y = 0; y < (int)image->height; y++) {
        for (int x = 0; x < (int)image->width; x++) {
            size_t i = (size_t)y * image->width + (size_t)x;
            struct color c = color_grey((uint8_t)(exact[i] > 0 ? 90 + 30 * (exact[i] - 1) : 0));
            c = draws[i] > exact[i] ? color_rgb(255, 150, 0) : c;
            c = draws[i] < exact[i] ? color_rgb(255, 0, 160) : c;
            image_set(image, x, y, c);
        }
    }
}

/* ---- The pictures ---- */

/* Which of the three edge functions are positive (red, green, blue: edges 0, 1, 2); inside all
 * three the pixel is white. */
static bool draw_half_planes(const char *directory, struct error *error) {
    struct image image;
    struct edges edges = {0};
    const struct fixed2 a = {5 * 256 / 2, 5 * 256 / 2}, b = {43 * 256 / 2, 9 * 256 / 2};
    const struct fixed2 c = {17 * 256 / 2, 33 * 256 / 2};
    if (!image_create(&image, 24, 19, IMAGE_BGR, error)) {
        return false;
    }
    triangle_setup(&edges, a, b, c, image.width, image.height);
    for (int y = 0; y < (int)image.height; y++) {
        for (int x = 0; x < (int)image.width; x++) {
            uint8_t level[3];
            for (int i = 0; i < 3; i++) {
                const struct edge *e = &edges.edge[i];
                level[i] = e->origin + e->dx * x + e->dy * y >= e->least ? 255 : 70;
            }
            image_set(&image, x, y, color_rgb(level[0], level[1], level[2]));
        }
    }
    bool done = figure_save_detail(&image, detail_of_whole(&image, 20, GRID), directory,
                                   "half_planes", error);
    image_free(&image);
    return done;
}

/* The count of draws of one version, as a picture. */
static bool draw_counts(const struct mesh *mesh, attempt_function *draw, struct image *image,
                        struct detail part, const char *directory, const char *name,
                        struct error *error) {
    size_t pixel_count = image->width * image->height;
    assert(pixel_count > 0);
    uint8_t *draws = malloc(pixel_count), *exact = malloc(pixel_count);
    bool done = draws != NULL && exact != NULL;
    if (done) {
        count_exactly(mesh, image, exact);
        draw_mesh(mesh, draw, image, draws);
        show_draws(image, draws, exact);
    }
    free(draws);
    free(exact);
    return done ? figure_save_detail(image, part, directory, name, error)
                : error_out_of_memory(error);
}

/* What two rules make of the sheet, and what float sums make of the long sides of the fan:
 * their edge values need more digits. */
static bool draw_meshes(const char *directory, struct error *error) {
    struct mesh sheet = {0}, fan = {0};
    struct image image = {0};
    struct detail part = {12, 12, 64, 64, .zoom = 5}, whole = {0, 0, 200, 200, .zoom = 2};
    bool done =
        image_create(&image, 200, 200, IMAGE_BGR, error) &&
        mesh_from_scene(&sheet, place_in_sheet, SHEET_TRIANGLES, &image, error) &&
        mesh_from_scene(&fan, place_in_fan, FAN_BLADES, &image, error) &&
        draw_counts(&sheet, attempt_4_box_double, &image, part, directory, "sheet_closed", error) &&
        draw_counts(&sheet, attempt_5_box_open, &image, part, directory, "sheet_open", error) &&
        draw_counts(&sheet, draw_spans, &image, part, directory, "sheet_exact", error) &&
        draw_counts(&fan, attempt_7_edges_float, &image, whole, directory, "fan_edges_float",
                    error);
    mesh_free(&sheet);
    mesh_free(&fan);
    image_free(&image);
    return done;
}

/* A white ring, for the reader's eye. */
static void draw_ring(struct image *image, int x, int y, int radius) {
    for (int v = -radius; v <= radius; v++) {
        for (int u = -radius; u <= radius; u++) {
            if (fabs(hypot(u, v) - radius) < 0.5) {
                image_set(image, x + u, y + v, color_grey(255));
            }
        }
    }
}

/* The eye of the bust. The rings show where the versions differ most. */
static bool draw_eye(const struct mesh *bust, attempt_function *draw, struct image *image,
                     const char *directory, const char *name, struct error *error) {
    const struct detail eye = {300, 480, 130, 100, .zoom = 4};
    draw_mesh(bust, draw, image, NULL);
    draw_ring(image, 339, 542, 12); /* the iris */
    draw_ring(image, 400, 500, 12); /* the ridge of the nose */
    return figure_save_detail(image, eye, directory, name, error);
}

/* Part of the bust in colours: whole-number sweep, and spans. */
static bool draw_bust_details(const struct model *bust, const char *directory,
                              struct error *error) {
    struct mesh mesh = {0};
    struct image image = {0};
    bool done =
        image_create(&image, 800, 800, IMAGE_BGR, error) &&
        mesh_from_model(&mesh, bust, &image, error) &&
        draw_eye(&mesh, attempt_1_sweep_whole, &image, directory, "bust_sweep_whole", error) &&
        draw_eye(&mesh, draw_spans, &image, directory, "bust_spans", error);
    mesh_free(&mesh);
    image_free(&image);
    return done;
}

bool draw_figures(const char *directory, struct model *bust, struct error *error) {
    return draw_half_planes(directory, error) && draw_meshes(directory, error) &&
           draw_bust_details(bust, directory, error);
}
