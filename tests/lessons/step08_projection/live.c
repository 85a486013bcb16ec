/* Lesson 8 under the mouse: a matrix of one's own, a near plane, attempts, and each space that a
 * corner goes through. */
#ifndef LESSON
#define LESSON "../step08_projection/main.c"
#endif
#include "more_scenes.h"

#include "../step08_projection/attempts.h"

/* ---- Scene: house ---- */

/* The columns of a matrix are points to drag: where (1,0), (0,1) and (0,0) go. */
static const struct scene_value live_house_values[] = {
    {"right_x", "column 1", -2, 2, 0.05, 1},
    {"right_y", "column 1", -2, 2, 0.05, 0},
    {"up_x", "column 2", -2, 2, 0.05, 0},
    {"up_y", "column 2", -2, 2, 0.05, 1},
    {"move_x", "last column", -2, 2, 0.05, 0},
    {"move_y", "last column", -2, 2, 0.05, 0},
    {"w_by_1", "last row: w gains this times x", -0.4, 0.4, 0.02, 0},
    {"w_by_2", "last row: w gains this times y", -0.4, 0.4, 0.02, 0},
    {"space", "also x, y and w in space, with the plane w = 1", 0, 1, 1, 0},
    {.name = NULL},
};

/* How the house's corner next to the probed pixel gets there: by the matrix, then onto w = 1. */
static void live_note_mapped(struct drawing *drawing, const struct plane *plane,
                             const struct mat4 *map) {
    const struct mat4 to_screen = mat4_mul(plane->to_screen, *map);
    double least = INFINITY;
    struct vec2 nearest = {0, 0};
    for (size_t i = 0; drawing->probed && i < 4 * (size_t)HOUSE_PARTS; i++) {
        const struct vec2 corner = house[i / 4].corner[i % 4];
        const struct vec2 at = to_pixels(&to_screen, corner);
        const double distance = hypot(at.x - 0.5 - drawing->probe.x, at.y - 0.5 - drawing->probe.y);
        if (distance < least) {
            least = distance;
            nearest = corner;
        }
    }
    if (least < INFINITY) {
        const struct vec4 p = mat4_point(map, (struct vec3){nearest.x, nearest.y, 0});
        drawing_note(drawing, "corner %.2f %.2f  w 1", nearest.x, nearest.y);
        drawing_note(drawing, "mapped %.3f %.3f  w %.3f", p.x, p.y, p.w);
        drawing_note(drawing, "on the plane w = 1: %.3f %.3f", p.x / p.w, p.y / p.w);
        for (int row = 0; row < 4; row += row == 1 ? 2 : 1) { /* all but z */
            const double *m = map->m[row];
            drawing_note(drawing, "| %5.2f %5.2f %5.2f |", m[0], m[1], m[3]);
        }
    }
}

/* A corner of the picture shows x, y and w in space: w goes up and y to the back. The mapped house
 * is an outline; rays from the origin through its corners meet the plane w = 1 in the picture. */
static void live_draw_space(struct image *image, const struct mat4 *map) {
    const struct rectangle area = {0, 0, (int)image->width / 2, (int)image->height / 2};
    const struct mat4 aside = {{{0.36, 0.16, 0, 0}, {0, 0.26, 0, 0.9}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const struct mat4 to_screen =
        mat4_mul(area_to_screen(area), mat4_translation((struct vec3){0, -0.8, 0}));
    const struct vec2 corners[4] = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
    const struct plane space = {image, area, to_screen};
    const struct plane ground = {image, area, mat4_mul(to_screen, aside)};
    const struct plane divided = {image, area, mat4_mul(ground.to_screen, *map)};
    struct mat4 undivided = mat4_mul(aside, *map);
    for (int i = 0; i < 4; i++) {
        undivided.m[3][i] = i == 3; /* w is a third coordinate here, by which nothing is divided */
    }
    plane_polygon(&ground, corners, color_grey(60));
    draw_house(&divided);
    for (int i = 0; i < 8; i++) { /* of the wall and the roof */
        const struct vec2 c = house[1 + i / 4].corner[i % 4];
        const struct vec4 end = mat4_point(&undivided, (struct vec3){c.x, c.y, 0});
        const struct vec4 on = mat4_point(map, (struct vec3){c.x, c.y, 0});
        const double longer = fmax(1, 1 / on.w);
        plane_line(&space, (struct vec2){0, 0}, (struct vec2){end.x * longer, end.y * longer},
                   color_grey(120));
    }
    outline_house(&(struct plane){image, area, mat4_mul(to_screen, undivided)}, color_grey(255));
}

static bool live_house(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct plane plane = plane_in(image, whole_image(image));
    const struct vec2 right = drawing_point(drawing, "right"), up = drawing_point(drawing, "up");
    const struct vec2 move = drawing_point(drawing, "move");
    const struct mat4 map = {
        {{right.x, up.x, 0, move.x},
         {right.y, up.y, 0, move.y},
         {0, 0, 1, 0},
         {drawing_value(drawing, "w_by_1"), drawing_value(drawing, "w_by_2"), 0, 1}}};
    draw_mapped(&plane, map);
    if (drawing_value(drawing, "space") != 0) {
        live_draw_space(image, &map);
    }
    live_note_mapped(drawing, &plane, &map);
    return true;
}

/* ---- Faces: how they are clipped ---- */

#define LIVE_VIEW_VALUES                                                                           \
    {"near", "w of the near plane", 1.0 / 128, 1, 1.0 / 128, 1.0 / 128},                           \
        {"attempt", "0 cut, 1 divided by any w, 2 left out", 0, 2, 1, 0}, {                        \
        "affine", "mixed without 1/w", 0, 1, 1, 0                                                  \
    }
static const struct scene_value live_wall_values[] = {
    {"far", "w of the wall's far end", 0.5, 8, 0.1, 2},
    LIVE_VIEW_VALUES,
    {.name = NULL},
};
static const struct scene_value live_view_values[] = {LIVE_VIEW_VALUES, {.name = NULL}};

/* A matrix times a number gives the same picture, but is cut where w is that much less: so the near
 * plane is chosen. */
static double live_scale(const struct drawing *drawing) {
    const double near = drawing_value(drawing, "near");
    return near > 0 ? near_w / near : 1;
}

static struct canvas live_canvas(const struct drawing *drawing, struct image *image,
                                 struct rectangle area) {
    struct mat4 to_clip = camera_clip(drawing);
    for (int i = 0; i < 16; i++) {
        to_clip.m[i / 4][i % 4] *= live_scale(drawing);
    }
    struct canvas canvas = make_canvas(drawing, image, area, to_clip);
    canvas.affine = drawing_value(drawing, "affine") != 0;
    return canvas;
}

enum { LIVE_CUT, LIVE_UNCLIPPED, LIVE_LEFT_OUT };

/* What an attempt leaves of a face. */
static struct polygon live_clip(const struct drawing *drawing, const struct canvas *canvas,
                                const struct face_corner corner[3]) {
    static attempt_clipping *const attempts[] = {
        [LIVE_CUT] = clip_face,
        [LIVE_UNCLIPPED] = attempt_7_unclipped,
        [LIVE_LEFT_OUT] = attempt_8_left_out,
    };
    struct polygon polygon = transform_face(canvas, corner);
    attempts[(int)drawing_value(drawing, "attempt")](&polygon);
    return polygon;
}

enum live_fate { LIVE_OUTSIDE, LIVE_CLIPPED, LIVE_WHOLE };

static enum live_fate live_fate(const struct drawing *drawing, const struct canvas *canvas,
                                const struct face_corner corner[3]) {
    const struct polygon face = transform_face(canvas, corner);
    const unsigned beyond = find_beyond(face.corner[0].clip) | find_beyond(face.corner[1].clip) |
                            find_beyond(face.corner[2].clip);
    const bool crosses = (beyond & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0;
    return live_clip(drawing, canvas, corner).count < 3               ? LIVE_OUTSIDE
           : crosses && drawing_value(drawing, "attempt") == LIVE_CUT ? LIVE_CLIPPED
                                                                      : LIVE_WHOLE;
}

/* ---- What there is to say ---- */

/* The faces of a drawing that is done, and the corner next to the probed pixel. */
struct live_told {
    struct drawing *drawing;
    const struct canvas *canvas;
    uint64_t faces, outside, clipped;
    double least; /* how far the corner is from the pixel; infinite: none is seen */
    size_t index;
    struct vec3 position;
    struct fixed2 screen;
};

/* Was this corner drawn, and is it not behind something else? */
static bool live_is_seen(const struct live_told *told, const struct vertex *v) {
    const struct image *image = told->canvas->image;
    const double x = floor((double)v->position.x / SUBPIXELS);
    const double y = floor((double)v->position.y / SUBPIXELS), width = (double)image->width;
    return x >= 0 && x < width && y >= 0 && y < (double)image->height &&
           v->depth > told->drawing->depth[(size_t)(y * width + x)] - 0.01;
}

static void live_look_at_corner(struct live_told *told, struct vec3 position, size_t index) {
    const struct pixel probe = told->drawing->probe;
    const struct vec4 clip = mat4_point(&told->canvas->to_clip, position);
    struct vertex v;
    if (place(clip, &told->canvas->to_screen, &v) && live_is_seen(told, &v)) {
        const double distance = hypot((double)v.position.x / SUBPIXELS - 0.5 - probe.x,
                                      (double)v.position.y / SUBPIXELS - 0.5 - probe.y);
        if (distance < told->least || (distance == told->least && index < told->index)) {
            told->least = distance;
            told->index = index;
            told->position = position;
            told->screen = v.position;
        }
    }
}

static bool live_is_probed(const struct drawing *drawing, struct rectangle area) {
    const struct pixel p = drawing->probe;
    return drawing->probed && p.x >= area.x && p.x < area.x + area.width && p.y >= area.y &&
           p.y < area.y + area.height;
}

/* Count a face. The corners of a whole one are looked at. */
static void live_look_at(struct live_told *told, const struct face_corner corner[3],
                         const size_t index[3]) {
    const enum live_fate fate = live_fate(told->drawing, told->canvas, corner);
    const bool looks = fate == LIVE_WHOLE && live_is_probed(told->drawing, told->canvas->area);
    told->faces++;
    told->outside += fate == LIVE_OUTSIDE;
    told->clipped += fate == LIVE_CLIPPED;
    for (size_t i = 0; i < 3 && looks; i++) {
        live_look_at_corner(told, corner[i].position, index[i]);
    }
}

/* How the nearest corner came to the screen. */
static void live_tell(const struct live_told *told) {
    struct drawing *drawing = told->drawing;
    drawing_count(drawing, "faces", told->faces);
    drawing_count(drawing, "faces_outside", told->outside);
    drawing_count(drawing, "faces_clipped", told->clipped);
    if (told->least < INFINITY) {
        const struct vec3 m = told->position;
        const struct vec4 c = mat4_point(&told->canvas->to_clip, m);
        const double scale = live_scale(drawing); /* which projection() does not know of */
        drawing_note(drawing, "corner %zu: %.3f %.3f %.3f", told->index, m.x, m.y, m.z);
        drawing_note(drawing, "view   %.3f %.3f %.3f", c.x / scale, c.y / scale, c.z / scale);
        drawing_note(drawing, "clip   %.3f %.3f %.3f  w %.3f", c.x, c.y, c.z, c.w);
        drawing_note(drawing, "NDC    %.3f %.3f %.3f", c.x / c.w, c.y / c.w, c.z / c.w);
        drawing_note(drawing, "screen %.2f %.2f", (double)told->screen.x / SUBPIXELS,
                     (double)told->screen.y / SUBPIXELS);
    }
}

static void live_tell_model(struct drawing *drawing, const struct canvas *canvas) {
    struct live_told told = {.drawing = drawing, .canvas = canvas, .least = INFINITY};
    for (size_t face = 0; face < drawing->model->face_count; face++) {
        const struct corner *c = drawing->model->faces[face].corner;
        struct face_corner corner[3];
        fetch_face(drawing->model, face, corner);
        live_look_at(&told, corner, (size_t[]){c[0].position, c[1].position, c[2].position});
    }
    live_tell(&told);
}

/* How the probed pixel comes to u and v, where this face has it. */
static void live_tell_texel(struct drawing *drawing, const struct canvas *canvas,
                            const struct face_corner corner[3]) {
    const struct polygon face = transform_face(canvas, corner);
    const int x = drawing->probe.x, y = drawing->probe.y;
    struct vertex v[3];
    struct edges edges;
    if (live_fate(drawing, canvas, corner) != LIVE_WHOLE ||
        !place(face.corner[0].clip, &canvas->to_screen, &v[0]) ||
        !place(face.corner[1].clip, &canvas->to_screen, &v[1]) ||
        !place(face.corner[2].clip, &canvas->to_screen, &v[2]) ||
        !edges_setup(&edges, v[0].position, v[1].position, v[2].position, canvas->image->width,
                     canvas->image->height) ||
        !edges_cover(&edges, x, y)) {
        return;
    }
    const double recip_w[3] = {v[0].recip_w, v[1].recip_w, v[2].recip_w};
    const struct vec3 screen = edges_weights(&edges, x, y), w = correct_weights(screen, recip_w);
    const struct vec2 affine = vec2_interpolate(screen, corner[0].uv, corner[1].uv, corner[2].uv);
    const struct vec2 right = vec2_interpolate(w, corner[0].uv, corner[1].uv, corner[2].uv);
    const double by_w = interpolate(screen, recip_w[0], recip_w[1], recip_w[2]);
    drawing_note(drawing, "u/w %.4f  v/w %.4f  1/w %.4f", right.x * by_w, right.y * by_w, by_w);
    drawing_note(drawing, "u %.4f  v %.4f  w %.4f", right.x, right.y, 1 / by_w);
    drawing_note(drawing, "affine: u %.4f  v %.4f", affine.x, affine.y);
}

static void live_tell_quads(struct drawing *drawing, const struct canvas *canvas,
                            const struct quad *quads, size_t count) {
    struct live_told told = {.drawing = drawing, .canvas = canvas, .least = INFINITY};
    struct face_corner corner[3];
    for (size_t face = 0; face < 2 * count; face++) {
        const size_t first = face / 2 * 4, second = first + 1 + face % 2;
        fetch_quad_face(quads, face, canvas->light, corner);
        live_look_at(&told, corner, (size_t[]){first, second, second + 1});
    }
    live_tell(&told);
    for (size_t face = 0; drawing->probed && face < 2 * count; face++) {
        fetch_quad_face(quads, face, canvas->light, corner);
        live_tell_texel(drawing, canvas, corner);
    }
}

/* ---- The scenes ---- */

static bool live_projection(struct drawing *drawing, struct image *image, struct error *error) {
    const bool done = draw_projection(drawing, image, error);
    const struct canvas large = live_canvas(drawing, image, whole_image(image));
    const struct canvas small = make_canvas(drawing, image, small_area(image, 0, 1),
                                            mat4_mul(projection(INFINITY), camera_view(drawing)));
    live_tell_model(drawing, &large);
    live_tell_model(drawing, &small);
    return done;
}

static bool live_view(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct canvas canvas = live_canvas(drawing, image, whole_image(image));
    for (size_t i = 0; drawing_take_part(drawing, i); i++) {
        canvas.texture = drawing->diffuse;
        for (size_t face = 0; face < drawing->model->face_count; face++) {
            struct face_corner corner[3];
            fetch_face(drawing->model, face, corner);
            const struct polygon polygon = live_clip(drawing, &canvas, corner);
            draw_polygon(&canvas, corner, &polygon);
        }
    }
    live_tell_model(drawing, &canvas);
    return true;
}

static bool live_draw_quads(struct drawing *drawing, const struct canvas *canvas,
                            const struct quad *quads, size_t count, struct error *error) {
    struct texture tiles;
    struct canvas tiled = *canvas;
    tiled.texture = &tiles;
    if (!make_tiles(&tiles, error)) {
        return false;
    }
    for (size_t face = 0; face < 2 * count; face++) {
        struct face_corner corner[3];
        fetch_quad_face(quads, face, canvas->light, corner);
        const struct polygon polygon = live_clip(drawing, canvas, corner);
        draw_polygon(&tiled, corner, &polygon);
    }
    live_tell_quads(drawing, canvas, quads, count);
    texture_free(&tiles);
    return true;
}

static bool live_wall(struct drawing *drawing, struct image *image, struct error *error) {
    const struct canvas canvas = live_canvas(drawing, image, whole_image(image));
    struct quad quads[2] = {wall[0], wall[1]};
    quads[0].corner[1].z = quads[0].corner[2].z = 2 - 2 * drawing_value(drawing, "far");
    return live_draw_quads(drawing, &canvas, quads, 2, error);
}

static bool live_endless(struct drawing *drawing, struct image *image, struct error *error) {
    const struct canvas canvas = live_canvas(drawing, image, whole_image(image));
    const struct canvas small = live_canvas(drawing, image, sail_area(image));
    return live_draw_quads(drawing, &canvas, endless, 4, error) &&
           live_draw_quads(drawing, &small, &sail, 1, error);
}

static const struct scene live[] = {
    {.name = "house", .values = live_house_values, .draw = live_house},
    {.name = "projection", .draw = live_projection},
    {.name = "wall", .values = live_wall_values, .draw = live_wall},
    {.name = "lookat", .values = live_view_values, .draw = live_view},
    {.name = "closeup", .values = live_view_values, .draw = live_view},
    {.name = "endless", .values = live_view_values, .draw = live_endless},
};

MAIN_WITH(live)
