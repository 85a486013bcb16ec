/* Lesson 6 under the mouse: samplers and attempts, a walk, and the pixel under the cursor. */
#ifndef LESSON
#define LESSON "../step06_texture/main.c"
#endif
#include "more_scenes.h"

#include "../step06_texture/attempts.h"

/* What one can change in perspective: every scene has its own sampler. */
#define LIVE_VALUES(sampler)                                                                       \
    {                                                                                              \
        {"sampler", "0 nearest, 1 bilinear, 2 with mip levels", 0, 2, 1, sampler},                 \
            {"attempt", "0 the sampler, 1 nearest by rounding, 2 bilinear from corners", 0, 2, 1,  \
             0},                                                                                   \
            {"affine", "u and v are mixed without 1/w", 0, 1, 1, 0},                               \
            {"level", "the finest mip level that is read", 0, 8, 1, 0},                            \
            {"colors", "every mip level has its own colour", 0, 1, 1, 0},                          \
            {"footprint", "the pixel under the cursor on the texture", 0, 1, 1, 0},                \
            {"walk", "how far the camera walks ahead", -2, 0.5, 0.05, 0}, {                        \
            .name = NULL                                                                           \
        }                                                                                          \
    }
static const struct scene_value live_nearest_values[] = LIVE_VALUES(SAMPLE_NEAREST);
static const struct scene_value live_bilinear_values[] = LIVE_VALUES(SAMPLE_BILINEAR);
static const struct scene_value live_trilinear_values[] = LIVE_VALUES(SAMPLE_TRILINEAR);

/* ---- The pixel under the cursor ---- */

/* What the probed pixel covers of a pattern: a parallelogram. */
struct live_footprint {
    const struct pattern *pattern; /* NULL: of none */
    struct vec2 uv, right, up;     /* its middle, and its sides */
};

/* A point of the footprint, `right` and `up` from its middle, in texels. */
static struct vec2 live_texel(const struct live_footprint *f, double right, double up) {
    return (struct vec2){(right * f->right.x + up * f->up.x) * f->pattern->width,
                         (right * f->right.y + up * f->up.y) * f->pattern->height};
}

/* Texel i of a pattern that repeats. */
static int live_repeated(double i, int size) {
    return (int)(i - floor(i / size) * size);
}

/* Show the texels around the footprint in a corner of the image, with its outline. */
static void live_show(struct image *image, const struct live_footprint *f) {
    static const double half[][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    const int width = f->pattern->width, height = f->pattern->height;
    const int side = (int)image->height / 3;
    struct vec2 corner[4];
    double reach = 2;
    for (int i = 0; i < 4; i++) {
        corner[i] = live_texel(f, half[i][0], half[i][1]);
        reach = fmax(reach, fmax(fabs(corner[i].x), fabs(corner[i].y)));
    }
    const double texels = 4 * reach / side; /* in a pixel */
    for (int i = 0; i < side * side; i++) {
        const double x = f->uv.x * width + (i % side + 0.5 - side / 2.0) * texels;
        const double y = f->uv.y * height + (i / side + 0.5 - side / 2.0) * texels;
        image_set(
            image, i % side, i / side,
            f->pattern->color(live_repeated(floor(x), width), live_repeated(floor(y), height)));
    }
    for (int i = 0; i < 4; i++) {
        const struct vec2 a = corner[i], b = corner[(i + 1) % 4];
        const struct pixel from = {side / 2 + (int)floor(a.x / texels),
                                   side / 2 + (int)floor(a.y / texels)};
        const struct pixel to = {side / 2 + (int)floor(b.x / texels),
                                 side / 2 + (int)floor(b.y / texels)};
        struct line_walk walk;
        bool more = line_begin(&walk, from, to, image->width, image->height);
        for (; more; more = line_next(&walk)) {
            image_set(image, walk.x, walk.y, color_rgb(255, 0, 255));
        }
    }
}

/* What the probed pixel shows of a triangle. */
static void live_note(struct drawing *drawing, const struct image *image, const struct vertex v[3],
                      const struct pattern *pattern, const struct texture *texture,
                      struct live_footprint *footprint) {
    const int x = drawing->probe.x, y = drawing->probe.y;
    struct quotients plane;
    if (!drawing->probed || !plane_begin(&plane, image, v) || !edges_cover(&plane.edges, x, y)) {
        return;
    }
    double w;
    const struct vec2 uv = plane_uv(&plane, x, y, &w);
    const struct vec2 right = uv_step(plane.right, uv, w), up = uv_step(plane.up, uv, w);
    *footprint = (struct live_footprint){pattern, uv, right, up};
    const struct vec2 r = live_texel(footprint, 1, 0), u = live_texel(footprint, 0, 1);
    drawing_note(drawing, "u %.4f  v %.4f  w %.4f", uv.x, uv.y, w);
    drawing_note(drawing, "u/w %.4f  v/w %.4f  1/w %.4f", uv.x / w, uv.y / w, 1 / w);
    drawing_note(drawing, "texels to the next pixel: right (%.2f, %.2f), up (%.2f, %.2f)", r.x, r.y,
                 u.x, u.y);
    drawing_note(drawing, "mip level %.2f", mip_level(right, up, texture));
}

/* ---- Surfaces in perspective ---- */

/* The texture without the levels below that one. */
static struct texture live_from_level(const struct texture *texture, size_t first) {
    struct texture coarse = *texture;
    first = first < texture->level_count ? first : texture->level_count - 1;
    coarse.level_count -= first;
    for (size_t i = 0; i < coarse.level_count; i++) {
        coarse.level[i] = texture->level[first + i];
    }
    return coarse;
}

/* Where the corners of the surface are after the walk. */
static void live_place(const struct drawing *drawing, const struct image *image,
                       const struct surface *surface, struct vertex v[4]) {
    struct surface walked = *surface;
    for (int i = 0; i < 4; i++) {
        walked.place[i].z -= drawing_value(drawing, "walk");
    }
    place_surface(&walked, image, v);
    for (int i = 0; i < 4 && drawing_value(drawing, "affine") != 0; i++) {
        v[i].recip_w = 1;
    }
}

/* By an attempt, or by what the lesson writes. */
static void live_quad(const struct drawing *drawing, struct image *image, const struct vertex v[4],
                      const struct texture *texture) {
    static attempt_function *const attempts[] = {attempt_1_rounded, attempt_3_unshifted};
    const struct texture coarse = live_from_level(texture, (size_t)drawing_value(drawing, "level"));
    const int attempt = (int)drawing_value(drawing, "attempt");
    const enum sampler sampler = (enum sampler)drawing_value(drawing, "sampler");
    const struct canvas canvas = {.image = image, .sampler = sampler};
    if (attempt > 0) {
        attempt_quad(image, v, &coarse, attempts[attempt - 1]);
        return;
    }
    perspective_triangle(&canvas, (struct vertex[]){v[0], v[1], v[2]}, &coarse);
    perspective_triangle(&canvas, (struct vertex[]){v[0], v[2], v[3]}, &coarse);
}

static bool live_surface(struct drawing *drawing, struct image *image,
                         const struct surface *surface, struct live_footprint *footprint,
                         struct error *error) {
    const struct pattern *pattern = surface->pattern;
    const bool colors = drawing_value(drawing, "colors") != 0;
    struct texture texture;
    struct vertex v[4];
    if (!paint(&texture, pattern, error)) {
        return false;
    }
    live_place(drawing, image, surface, v);
    const struct vertex lower[3] = {v[0], v[1], v[2]}, upper[3] = {v[0], v[2], v[3]};
    live_note(drawing, image, lower, pattern, &texture, footprint);
    live_note(drawing, image, upper, pattern, &texture, footprint);
    if (colors) { /* of the tiles, whatever else the surface shows */
        texture_free(&texture);
        if (!paint(&texture, &checker, error)) {
            return false;
        }
        attempt_color_levels(&texture);
    }
    live_quad(drawing, image, v, &texture);
    texture_free(&texture);
    return true;
}

/* A scene, and the footprint after all else that the probed pixel may show. */
static bool live_surfaces(struct drawing *drawing, struct image *image,
                          const struct surface *surfaces, size_t count, bool chart,
                          struct error *error) {
    struct live_footprint footprint = {.pattern = NULL};
    for (size_t i = 0; i < count; i++) {
        if (!live_surface(drawing, image, &surfaces[i], &footprint, error)) {
            return false;
        }
    }
    if (chart) {
        struct texture texture;
        if (!paint(&texture, &lettered, error)) {
            return false;
        }
        draw_chart(image, &texture);
        texture_free(&texture);
    }
    if (footprint.pattern != NULL && drawing_value(drawing, "footprint") != 0) {
        live_show(image, &footprint);
    }
    return true;
}

/* ---- The scenes ---- */

static bool live_room(struct drawing *drawing, struct image *image, struct error *error) {
    return live_surfaces(drawing, image, room, ROOM_SURFACES, true, error);
}

static bool live_close(struct drawing *drawing, struct image *image, struct error *error) {
    return live_surfaces(drawing, image, &close_wall, 1, false, error);
}

static bool live_mipmapped(struct drawing *drawing, struct image *image, struct error *error) {
    return live_surfaces(drawing, image, room, ROOM_SURFACES, false, error);
}

static bool live_checker(struct drawing *drawing, struct image *image, struct error *error) {
    return live_surfaces(drawing, image, &plane_of_tiles, 1, false, error);
}

static const struct scene live[] = {
    {.name = "room", .values = live_nearest_values, .draw = live_room},
    {.name = "close", .values = live_bilinear_values, .draw = live_close},
    {.name = "mipmapped", .values = live_trilinear_values, .draw = live_mipmapped},
    {.name = "checker", .values = live_trilinear_values, .draw = live_checker},
};

MAIN_WITH(live)
