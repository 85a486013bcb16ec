/*
 * Lesson 8, the given part: its scenes and the program.
 *
 * Part a: `house` shows a small house, `scale` to `divided` show it through nine matrices, and
 * `transforms` shows all nine together.
 *
 * Part b: `viewport` draws a model into several rectangles, without perspective. `projection` adds
 * perspective, with d infinite in a corner. `crossing` has planes that hide each other in part,
 * and two faces without a place on the screen. A face has one colour, or w is 1, so no weights are
 * needed.
 *
 * Part c: `wall` needs the correct weights. `narrow` needs the normals of a model that is not
 * scaled alike in all directions, and of a leaf that is flattened.
 *
 * Part d: `lookat`, `tilted` and `above` need a camera anywhere. Before them, and in `endless`, the
 * camera is in front.
 *
 * Part e: in `closeup` and `endless` faces pass behind the camera.
 *
 * `wide`, `high`, `small` and `one_pixel` draw `viewport`, `lookat`, `closeup` and `wall` in images
 * of other shapes.
 */
#include <stdlib.h>

/* From NDC to a part of the image: the viewport, moved there. */
static struct mat4 area_to_screen(struct rectangle area) {
    const struct vec3 corner = {area.x, area.y, 0};
    return mat4_mul(mat4_translation(corner), viewport((size_t)area.width, (size_t)area.height));
}

static struct rectangle whole_image(const struct image *image) {
    return (struct rectangle){0, 0, (int)image->width, (int)image->height};
}

static void fill_area(struct image *image, struct rectangle area, struct color color) {
    for (int y = area.y; y < area.y + area.height; y++) {
        image_fill_row(image, y, area.x, area.x + area.width, color);
    }
}

/* ---- Scene: transforms ---- */

/* The house: convex polygons, from back to front. */
enum { PART_CORNERS = 4 };

static const struct part {
    struct vec2 corner[PART_CORNERS]; /* counterclockwise; a triangle repeats its last corner */
    struct color color;
} house[] = {
    {{{0.74, 0.9}, {0.9, 0.9}, {0.9, 1.3}, {0.74, 1.3}}, {.r = 150, .g = 110, .b = 95, .a = 255}},
    {{{0, 0}, {1, 0}, {1, 0.8}, {0, 0.8}}, {.r = 236, .g = 196, .b = 110, .a = 255}},
    {{{-0.15, 0.8}, {1.15, 0.8}, {0.5, 1.35}, {0.5, 1.35}}, {.r = 206, .g = 74, .b = 52, .a = 255}},
    {{{0.14, 0}, {0.42, 0}, {0.42, 0.56}, {0.14, 0.56}}, {.r = 96, .g = 62, .b = 40, .a = 255}},
    {{{0.58, 0.32}, {0.86, 0.32}, {0.86, 0.6}, {0.58, 0.6}},
     {.r = 110, .g = 180, .b = 225, .a = 255}},
};

enum { HOUSE_PARTS = sizeof house / sizeof house[0] };

/* A part of the image that shows a part of the plane. */
struct plane {
    struct image *image;
    struct rectangle area; /* nothing is drawn outside */
};

static void plane_pixel(const struct plane *plane, int x, int y, struct color color) {
    const struct rectangle *area = &plane->area;
    if (x >= area->x && x < area->x + area->width && y >= area->y && y < area->y + area->height) {
        image_set(plane->image, x, y, color);
    }
}

/* A line between the pixels to which the map takes two points. */
static void plane_line(const struct plane *plane, const struct mat4 *map, struct vec2 from,
                       struct vec2 to, struct color color) {
    struct vec2 a = to_pixels(map, from), b = to_pixels(map, to);
    struct pixel p = {(int)floor(a.x), (int)floor(a.y)}, q = {(int)floor(b.x), (int)floor(b.y)};
    struct line_walk walk;
    bool more = line_begin(&walk, p, q, plane->image->width, plane->image->height);
    for (; more; more = line_next(&walk)) {
        plane_pixel(plane, walk.x, walk.y, color);
    }
}

static void plane_triangle(const struct plane *plane, const struct mat4 *map, struct vec2 a,
                           struct vec2 b, struct vec2 c, struct color color) {
    struct fixed2 p[3] = {{0, 0}};
    struct edges edges;
    /* The points are never beyond the limit. */
    screen_snap(to_pixels(map, a), &p[0]);
    screen_snap(to_pixels(map, b), &p[1]);
    screen_snap(to_pixels(map, c), &p[2]);
    if (!edges_setup(&edges, p[0], p[1], p[2], plane->image->width, plane->image->height)) {
        return;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        for (int x = span.begin; x < span.end; x++) {
            plane_pixel(plane, x, y, color);
        }
    }
}

static void draw_house(const struct plane *plane, const struct mat4 *map) {
    for (size_t i = 0; i < HOUSE_PARTS; i++) {
        const struct vec2 *c = house[i].corner;
        plane_triangle(plane, map, c[0], c[1], c[2], house[i].color);
        plane_triangle(plane, map, c[0], c[2], c[3], house[i].color);
    }
}

static void outline_house(const struct plane *plane, const struct mat4 *map, struct color color) {
    for (size_t i = 0; i < HOUSE_PARTS; i++) {
        const struct vec2 *c = house[i].corner;
        for (size_t k = 0; k < PART_CORNERS; k++) {
            plane_line(plane, map, c[k], c[(k + 1) % PART_CORNERS], color);
        }
    }
}

/* A cross of two short lines. */
static void mark_point(const struct plane *plane, const struct mat4 *map, struct vec3 p,
                       struct color color) {
    const double left = p.x - 0.08, right = p.x + 0.08, below = p.y - 0.08, above = p.y + 0.08;
    plane_line(plane, map, (struct vec2){left, below}, (struct vec2){right, above}, color);
    plane_line(plane, map, (struct vec2){left, above}, (struct vec2){right, below}, color);
}

enum { PANEL_COLUMNS = 3, PANEL_COUNT = 9, PANEL_MARGIN = 4, PANEL_OF_PIVOT = 5 };

/* The panel's part of an image. In a very small image its width or height may be negative. */
static struct rectangle panel_area(const struct image *image, int panel) {
    struct rectangle cell =
        grid_cell(image->width, image->height, PANEL_COLUMNS, PANEL_COLUMNS, panel);
    return (struct rectangle){cell.x + PANEL_MARGIN, cell.y + PANEL_MARGIN,
                              cell.width - 2 * PANEL_MARGIN, cell.height - 2 * PANEL_MARGIN};
}

/* A panel shows -2..2 in x and y. */
static struct mat4 panel_to_screen(struct rectangle area) {
    return mat4_mul(area_to_screen(area), mat4_scaling((struct vec3){0.5, 0.5, 1}));
}

/* Axes, the house through a map, and the outline of the house as it was. */
static void draw_mapped(const struct plane *plane, const struct mat4 *map) {
    const struct color axis = color_grey(90), outline = color_grey(165);
    const struct mat4 to_screen = panel_to_screen(plane->area);
    const struct mat4 mapped = mat4_mul(to_screen, *map);
    fill_area(plane->image, plane->area, color_grey(26));
    plane_line(plane, &to_screen, (struct vec2){-2, 0}, (struct vec2){2, 0}, axis);
    plane_line(plane, &to_screen, (struct vec2){0, -2}, (struct vec2){0, 2}, axis);
    draw_house(plane, &mapped);
    outline_house(plane, &to_screen, outline);
}

static void draw_panel(const struct plane *plane, int panel) {
    const struct mat4 to_screen = panel_to_screen(plane->area), map = panel_map(panel);
    draw_mapped(plane, &map);
    if (panel == PANEL_OF_PIVOT) {
        mark_point(plane, &to_screen, pivot, color_grey(255));
    }
}

/* One panel by itself, chosen by the scene's number. */
static bool draw_alone(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct plane plane = {image, whole_image(image)};
    draw_panel(&plane, drawing->number);
    return true;
}

/* The columns of a matrix are points to drag: where (1,0), (0,1) and (0,0) go. */
static const struct scene_value matrix_values[] = {
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
static void note_mapped(struct drawing *drawing, const struct image *image,
                        const struct mat4 *map) {
    const struct mat4 to_screen = mat4_mul(panel_to_screen(whole_image(image)), *map);
    double least = INFINITY;
    struct vec2 nearest = {0, 0};
    for (size_t i = 0; drawing->probed && i < (size_t)HOUSE_PARTS * PART_CORNERS; i++) {
        const struct vec2 corner = house[i / PART_CORNERS].corner[i % PART_CORNERS];
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
static void draw_space(struct image *image, const struct mat4 *map) {
    const struct plane plane = {image, {0, 0, (int)image->width / 2, (int)image->height / 2}};
    const struct mat4 aside = {{{0.36, 0.16, 0, 0}, {0, 0.26, 0, 0.9}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const struct mat4 to_screen =
        mat4_mul(area_to_screen(plane.area), mat4_translation((struct vec3){0, -0.8, 0}));
    const struct mat4 ground = mat4_mul(to_screen, aside), divided = mat4_mul(ground, *map);
    struct mat4 undivided = mat4_mul(aside, *map);
    const struct vec2 corner[] = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
    for (int i = 0; i < 4; i++) {
        undivided.m[3][i] = i == 3; /* w is a third coordinate here, by which nothing is divided */
    }
    plane_triangle(&plane, &ground, corner[0], corner[1], corner[2], color_grey(60));
    plane_triangle(&plane, &ground, corner[0], corner[2], corner[3], color_grey(60));
    draw_house(&plane, &divided);
    for (int i = 0; i < 2 * PART_CORNERS; i++) { /* of the wall and the roof */
        const struct vec2 c = house[1 + i / PART_CORNERS].corner[i % PART_CORNERS];
        const struct vec4 end = mat4_point(&undivided, (struct vec3){c.x, c.y, 0});
        const struct vec4 on = mat4_point(map, (struct vec3){c.x, c.y, 0});
        const double longer = fmax(1, 1 / on.w);
        plane_line(&plane, &to_screen, (struct vec2){0, 0},
                   (struct vec2){end.x * longer, end.y * longer}, color_grey(120));
    }
    undivided = mat4_mul(to_screen, undivided);
    outline_house(&plane, &undivided, color_grey(255));
}

/* The house as it is, unless the matrix is another. */
static bool draw_unmapped(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct plane plane = {image, whole_image(image)};
    const struct vec2 right = drawing_point(drawing, "right"), up = drawing_point(drawing, "up");
    const struct vec2 move = drawing_point(drawing, "move");
    const struct mat4 map = {
        {{right.x, up.x, 0, move.x},
         {right.y, up.y, 0, move.y},
         {0, 0, 1, 0},
         {drawing_value(drawing, "w_by_1"), drawing_value(drawing, "w_by_2"), 0, 1}}};
    struct mat4 twice = mat4_identity(); /* which moves no point: w is 2 */
    for (int i = 0; i < 4; i++) {
        twice.m[i][i] = 2;
    }
    const struct mat4 mapped = mat4_mul(twice, map);
    draw_mapped(&plane, &mapped);
    if (drawing_value(drawing, "space") != 0) {
        draw_space(image, &map);
    }
    note_mapped(drawing, image, &map);
    return true;
}

static bool draw_transforms(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    for (int i = 0; i < PANEL_COUNT; i++) {
        const struct plane plane = {image, panel_area(image, i)};
        if (plane.area.width > 0 && plane.area.height > 0) {
            draw_panel(&plane, i);
        }
    }
    return true;
}

/* ---- Positions of the model ---- */

/* A transformed position. place_once() uses the last three fields. */
struct position {
    struct vec4 clip;
    unsigned beyond;
    bool tried, placed;   /* place() was called, and found a place on the screen */
    struct vertex vertex; /* without intensity and uv */
};

/* What becomes of a face that crosses the near plane: it is cut. Attempt 7 divides by any w, and
 * attempt 8 leaves the face out. */
enum attempt { CUT, UNCLIPPED, LEFT_OUT };

struct state {
    struct position *positions; /* one for each position of the model */
    enum attempt attempt;
};

/* Each position is transformed once, however many faces share it. */
static void transform_positions(const struct drawing *drawing, const struct mat4 *to_clip) {
    const struct state *state = drawing->state;
    for (size_t i = 0; i < drawing->model->position_count; i++) {
        struct vec4 clip = mat4_point(to_clip, drawing->model->positions[i]);
        state->positions[i] = (struct position){.clip = clip, .beyond = find_beyond(clip)};
    }
}

/* The division by w, when the first face needs this position. False when it has no place on the
 * screen. */
static bool place_once(struct position *position, struct canvas *canvas) {
    if (!position->tried) {
        position->tried = true;
        position->placed = place(position->clip, &canvas->to_screen, &position->vertex);
        canvas->positions_divided++;
    }
    return position->placed;
}

static bool place_face(struct position *const corner[3], struct canvas *canvas) {
    return place_once(corner[0], canvas) && place_once(corner[1], canvas) &&
           place_once(corner[2], canvas);
}

/* ---- Faces ---- */

/* What is interpolated between the corners of a face. */
struct face_attributes {
    double intensity[3];
    struct vec2 uv[3];
};

/* The intensity of lesson 7, with the normal taken to the world. */
static double light_on(const struct drawing *drawing, const struct canvas *canvas,
                       struct vec3 model_normal) {
    struct vec3 normal = vec3_normalized(mat4_direction(&canvas->normals_to_world, model_normal));
    double cosine = vec3_dot(normal, vec3_normalized(drawing->light));
    return cosine > 0 ? cosine : 0;
}

static struct face_attributes fetch_corners(const struct drawing *drawing,
                                            const struct canvas *canvas, size_t face) {
    struct face_attributes attributes;
    for (size_t i = 0; i < 3; i++) {
        struct vec3 normal = model_normal(drawing->model, face, i);
        attributes.intensity[i] = light_on(drawing, canvas, normal);
        attributes.uv[i] = model_uv(drawing->model, face, i);
    }
    return attributes;
}

/* The same at all corners, so that no weights can be wrong. */
static struct face_attributes fetch_middle(const struct drawing *drawing,
                                           const struct canvas *canvas, size_t face) {
    const struct vec3 third = {1.0 / 3, 1.0 / 3, 1.0 / 3};
    const struct model *model = drawing->model;
    double intensity = light_on(drawing, canvas, model_face_normal(model, face));
    struct vec2 uv = vec2_interpolate(third, model_uv(model, face, 0), model_uv(model, face, 1),
                                      model_uv(model, face, 2));
    return (struct face_attributes){{intensity, intensity, intensity}, {uv, uv, uv}};
}

static struct face_attributes fetch_face(const struct drawing *drawing, const struct canvas *canvas,
                                         size_t face) {
    return canvas->one_color ? fetch_middle(drawing, canvas, face)
                             : fetch_corners(drawing, canvas, face);
}

/* The weights of a face's own corners. */
static const struct vec3 whole_face[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/* Draw a triangle of a face: the face itself, or a part that clipping left. `weight` says where its
 * corners are between those of the face. A triangle whose corners run clockwise on the screen shows
 * its inside, and a closed body always has something else in front of it. */
static void draw_part(const struct drawing *drawing, struct canvas *canvas, size_t face,
                      struct vertex v[3], const struct vec3 weight[3]) {
    struct edges edges;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, canvas->image->width,
                     canvas->image->height)) {
        return;
    }
    canvas->triangles_turned_away += edges.clockwise;
    if (edges.clockwise && drawing->skip) {
        return; /* before its light is computed */
    }
    const struct face_attributes a = fetch_face(drawing, canvas, face);
    for (int i = 0; i < 3; i++) {
        v[i].intensity = interpolate(weight[i], a.intensity[0], a.intensity[1], a.intensity[2]);
        v[i].uv = vec2_interpolate(weight[i], a.uv[0], a.uv[1], a.uv[2]);
    }
    if (!edges.clockwise) {
        triangle(canvas, &edges, v);
    }
}

/* A face with these corners in clip space, cut at all planes. */
static struct polygon clip_face(struct vec4 a, struct vec4 b, struct vec4 c) {
    struct polygon polygon = {
        .corner = {{a, whole_face[0]}, {b, whole_face[1]}, {c, whole_face[2]}}, .count = 3};
    for (int plane = 0; plane < CLIP_PLANES && polygon.count > 0; plane++) {
        polygon = clip_at_plane(&polygon, plane);
    }
    return polygon;
}

/* Draw what clipping leaves of a face, as a fan of triangles around its first corner. */
static void draw_clipped(const struct drawing *drawing, struct canvas *canvas, size_t face,
                         const struct polygon *polygon) {
    struct vertex vertices[POLYGON_LIMIT];
    if (polygon->count < 3) {
        canvas->faces_outside++;
        return;
    }
    canvas->faces_clipped++;
    for (size_t i = 0; i < polygon->count; i++) {
        if (!place(polygon->corner[i].clip, &canvas->to_screen, &vertices[i])) {
            return;
        }
    }
    for (size_t i = 2; i < polygon->count; i++) {
        struct vertex v[3] = {vertices[0], vertices[i - 1], vertices[i]};
        const struct vec3 weight[3] = {polygon->corner[0].weight, polygon->corner[i - 1].weight,
                                       polygon->corner[i].weight};
        draw_part(drawing, canvas, face, v, weight);
    }
}

/* Draw a face that needs no clipping, unless a corner has no place on the screen. */
static void draw_whole(const struct drawing *drawing, struct canvas *canvas, size_t face,
                       struct position *const corner[3]) {
    if (place_face(corner, canvas)) {
        struct vertex v[3] = {corner[0]->vertex, corner[1]->vertex, corner[2]->vertex};
        draw_part(drawing, canvas, face, v, whole_face);
    }
}

static void draw_face(const struct drawing *drawing, struct canvas *canvas, size_t face) {
    const struct state *state = drawing->state;
    const struct corner *c = drawing->model->faces[face].corner;
    struct position *corner[3] = {&state->positions[c[0].position],
                                  &state->positions[c[1].position],
                                  &state->positions[c[2].position]};
    unsigned beyond_all = corner[0]->beyond & corner[1]->beyond & corner[2]->beyond;
    unsigned beyond_any = corner[0]->beyond | corner[1]->beyond | corner[2]->beyond;
    const bool clips = state->attempt != UNCLIPPED;
    const bool crosses = clips && (beyond_any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0;
    if ((clips && drawing->skip && (beyond_all & ~(unsigned)BEYOND_GUARD_BAND) != 0) ||
        (crosses && state->attempt == LEFT_OUT)) {
        canvas->faces_outside++; /* all of it is beyond one side, or it is left out */
    } else if (crosses) {
        struct polygon polygon = clip_face(corner[0]->clip, corner[1]->clip, corner[2]->clip);
        draw_clipped(drawing, canvas, face, &polygon);
    } else {
        draw_whole(drawing, canvas, face, corner);
    }
}

/* Is the corner in the picture, and not behind what is drawn there? */
static bool is_seen(const struct drawing *drawing, const struct image *image,
                    const struct position *position) {
    const struct fixed2 p = position->vertex.position;
    const double x = floor((double)p.x / SUBPIXELS), y = floor((double)p.y / SUBPIXELS);
    const double width = (double)image->width;
    return position->placed && x >= 0 && x < width && y >= 0 && y < (double)image->height &&
           position->vertex.depth > drawing->depth[(size_t)(y * width + x)] - 0.01;
}

/* A matrix times a number gives the same picture, but is cut where w is that much less: so the near
 * plane is chosen. */
static double scale_for_near(const struct drawing *drawing) {
    const double near = drawing_value(drawing, "near");
    return near > 0 ? near_w / near : 1;
}

/* How the corner next to the probed pixel came to the screen. */
static void note_corner(struct drawing *drawing, const struct canvas *canvas,
                        const struct state *state, const struct model *model) {
    const struct rectangle area = canvas->area;
    const struct pixel probe = drawing->probe;
    const bool here = drawing->probed && probe.x >= area.x && probe.x < area.x + area.width &&
                      probe.y >= area.y && probe.y < area.y + area.height;
    double least = INFINITY;
    size_t nearest = 0;
    for (size_t i = 0; here && i < model->position_count; i++) {
        const struct fixed2 p = state->positions[i].vertex.position;
        double distance =
            hypot((double)p.x / SUBPIXELS - 0.5 - probe.x, (double)p.y / SUBPIXELS - 0.5 - probe.y);
        if (distance < least && is_seen(drawing, canvas->image, &state->positions[i])) {
            least = distance;
            nearest = i;
        }
    }
    if (least < INFINITY) {
        const struct vec3 m = model->positions[nearest];
        const struct position *p = &state->positions[nearest];
        const struct vec4 c = p->clip;
        drawing_note(drawing, "corner %zu: %.3f %.3f %.3f", nearest, m.x, m.y, m.z);
        const double scale = scale_for_near(drawing); /* which projection() does not know of */
        drawing_note(drawing, "view   %.3f %.3f %.3f", c.x / scale, c.y / scale, c.z / scale);
        drawing_note(drawing, "clip   %.3f %.3f %.3f  w %.3f", c.x, c.y, c.z, c.w);
        drawing_note(drawing, "NDC    %.3f %.3f %.3f", c.x / c.w, c.y / c.w, c.z / c.w);
        drawing_note(drawing, "screen %.2f %.2f", (double)p->vertex.position.x / SUBPIXELS,
                     (double)p->vertex.position.y / SUBPIXELS);
    }
}

static void draw_faces(struct drawing *drawing, struct canvas *canvas, const struct mat4 *to_clip) {
    struct state *state = drawing->state;
    state->attempt = (enum attempt)drawing_value(drawing, "attempt");
    transform_positions(drawing, to_clip);
    for (size_t i = 0; drawing_take_part(drawing, i); i++) {
        canvas->texture = drawing->diffuse;
        for (size_t face = 0; face < drawing->model->face_count; face++) {
            draw_face(drawing, canvas, face);
        }
    }
}

static void count_work(struct drawing *drawing, const struct canvas *canvas,
                       const struct model *model) {
    drawing_count(drawing, "positions", model->position_count);
    drawing_count(drawing, "positions_divided", canvas->positions_divided);
    drawing_count(drawing, "faces", model->face_count);
    drawing_count(drawing, "faces_outside", canvas->faces_outside);
    drawing_count(drawing, "faces_clipped", canvas->faces_clipped);
    drawing_count(drawing, "triangles_turned_away", canvas->triangles_turned_away);
}

/* Draw the model, transformed by to_clip, into the canvas's area. */
static void draw_model(struct drawing *drawing, struct canvas *canvas, const struct mat4 *to_clip) {
    draw_faces(drawing, canvas, to_clip);
    count_work(drawing, canvas, drawing->model);
    note_corner(drawing, canvas, drawing->state, drawing->model);
}

/* ---- Scenes with the model ---- */

static struct canvas make_canvas(const struct drawing *drawing, struct image *image,
                                 struct rectangle area) {
    return (struct canvas){
        .image = image,
        .depth = drawing->depth,
        .area = area,
        .to_screen = area_to_screen(area),
        .texture = drawing->diffuse,
        .normals_to_world = mat4_identity(),
        .affine = drawing_value(drawing, "affine") != 0,
    };
}

/* Is the camera where lookat() has nothing to do? Then lookat() is not called, so that a mistake
 * in it costs no scene of the parts before it. */
static bool stands_in_front(const struct drawing *drawing) {
    const struct vec3 eye = drawing->eye, center = drawing->center, up = drawing->up;
    return eye.x == 0 && eye.y == 0 && eye.z > 0 && vec3_dot(center, center) == 0 && up.x == 0 &&
           up.y > 0 && up.z == 0;
}

/* The drawing's camera, at a distance that may be infinite. */
static struct mat4 camera(const struct drawing *drawing, double distance) {
    if (stands_in_front(drawing)) {
        return projection(distance);
    }
    return mat4_mul(projection(distance), lookat(drawing->eye, drawing->center, drawing->up));
}

static double eye_distance(const struct drawing *drawing) {
    return vec3_length(vec3_sub(drawing->eye, drawing->center));
}

/* In perspective, at the distance between eye and center. */
static struct mat4 perspective_camera(const struct drawing *drawing) {
    struct mat4 to_clip = camera(drawing, eye_distance(drawing));
    const double scale = scale_for_near(drawing);
    for (int i = 0; i < 16; i++) {
        to_clip.m[i / 4][i % 4] *= scale;
    }
    return to_clip;
}

/* Scenes lookat, tilted and closeup, and most of above: they differ in their eye, center and up. */
static bool draw_view(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct canvas canvas = make_canvas(drawing, image, whole_image(image));
    struct mat4 to_clip = perspective_camera(drawing);
    draw_model(drawing, &canvas, &to_clip);
    return true;
}

/* A small view in a corner of the image: column and row are 0 or 1. */
static void draw_small_view(struct drawing *drawing, struct image *image, int column, int row,
                            struct vec3 from_center, struct vec3 up) {
    struct drawing small = *drawing;
    const int size = (int)image->width / 5;
    const struct rectangle corner = {column * ((int)image->width - size),
                                     row * ((int)image->height - size), size, size};
    struct canvas canvas = make_canvas(&small, image, corner);
    small.eye = vec3_add(drawing->center, from_center);
    small.up = up;
    struct mat4 to_clip = perspective_camera(&small);
    draw_faces(&small, &canvas, &to_clip);
    count_work(drawing, &canvas, drawing->model);
}

/* In the corners an `up` against a view that is aslant (the axis nearest to perpendicular is not
 * that of the large view, nor that of the eye's place), one that is 9 degrees off, one that is
 * almost along the view, but just not so near that it does not count, and, from the same eye, one
 * that is far from it. */
static bool draw_above(struct drawing *drawing, struct image *image, struct error *error) {
    const struct vec3 aslant = {1.5, 1.35, 1.9}, upwards = {0, 2.5, 0};
    bool done = draw_view(drawing, image, error);
    draw_small_view(drawing, image, 0, 0, aslant, vec3_scale(aslant, -1));
    draw_small_view(drawing, image, 1, 0, (struct vec3){1.2, 1.8, 1.5}, (struct vec3){0.5, 1, 1});
    draw_small_view(drawing, image, 0, 1, upwards, (struct vec3){2e-10, 1, 1e-10});
    draw_small_view(drawing, image, 1, 1, upwards, (struct vec3){0, 0, -1});
    return done;
}

/* The head of many facets, each of one colour. */
static void draw_facets(struct drawing *drawing, struct image *image, struct rectangle area,
                        double distance) {
    struct canvas canvas = make_canvas(drawing, image, area);
    const struct mat4 to_clip = camera(drawing, distance);
    canvas.one_color = canvas.affine = true;
    draw_model(drawing, &canvas, &to_clip);
}

/* Once large; and small, from infinitely far away, next to it. */
static bool draw_projection(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const int size = (int)image->width / 5;
    const struct rectangle corner = {0, (int)image->height - size, size, size};
    draw_facets(drawing, image, whole_image(image), eye_distance(drawing));
    draw_facets(drawing, image, corner, INFINITY);
    return true;
}

/* The rectangles of scene viewport, in eighths of the image, and their backgrounds. */
static const struct pane {
    struct rectangle eighths;
    struct color color;
} panes[] = {
    {{0, 3, 5, 5}, {.r = 34, .g = 44, .b = 62, .a = 255}},
    {{5, 3, 3, 5}, {.r = 62, .g = 40, .b = 34, .a = 255}},
    {{0, 0, 5, 3}, {.r = 36, .g = 56, .b = 40, .a = 255}},
    {{5, 0, 3, 3}, {.r = 54, .g = 50, .b = 30, .a = 255}},
};

/* A rectangle of the image from eighths of its size, its sides rounded down. */
static struct rectangle pane_area(struct rectangle eighths, const struct image *image) {
    int width = (int)image->width, height = (int)image->height;
    int left = width * eighths.x / 8, right = width * (eighths.x + eighths.width) / 8;
    int bottom = height * eighths.y / 8, top = height * (eighths.y + eighths.height) / 8;
    return (struct rectangle){left, bottom, right - left, top - bottom};
}

/* Without perspective. */
static struct mat4 parallel_camera(const struct drawing *drawing) {
    return stands_in_front(drawing) ? mat4_identity() : camera(drawing, INFINITY);
}

/* The same view in each pane, without perspective: only the viewport differs. */
static bool draw_viewport(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct mat4 to_clip = parallel_camera(drawing);
    for (size_t i = 0; i < sizeof panes / sizeof panes[0]; i++) {
        struct rectangle area = pane_area(panes[i].eighths, image);
        struct canvas canvas = make_canvas(drawing, image, area);
        canvas.affine = true;
        fill_area(image, area, panes[i].color);
        draw_model(drawing, &canvas, &to_clip);
    }
    return true;
}

/* ---- Scenes of a few large quads ---- */

struct quad {
    struct vec3 corner[4]; /* counterclockwise as the camera sees them */
    struct vec2 uv[4];
};

enum { QUAD_LIMIT = 4, QUAD_CORNERS = 4 * QUAD_LIMIT };

/* A model of quads, and its transformed positions. */
struct quad_model {
    struct model model;
    struct vec3 positions[QUAD_CORNERS];
    float uvs[QUAD_CORNERS][2], normals[1][3];
    struct face faces[2 * QUAD_LIMIT];
    struct position places[QUAD_CORNERS];
    struct state state;
};

/* All normals point to the light, so that the tiles have their own colours. */
static void quad_model_make(struct quad_model *made, const struct quad *quads, size_t count,
                            struct vec3 light) {
    *made = (struct quad_model){.model = {.position_count = 4 * count, .face_count = 2 * count}};
    for (uint32_t i = 0; i < 4 * count; i++) {
        const struct quad *quad = &quads[i / 4];
        made->positions[i] = quad->corner[i % 4];
        made->uvs[i][0] = (float)quad->uv[i % 4].x;
        made->uvs[i][1] = (float)quad->uv[i % 4].y;
    }
    for (uint32_t i = 0; i < 2 * count; i++) { /* corners 0 1 2 and 0 2 3 */
        const uint32_t first = i / 2 * 4, second = first + 1 + i % 2;
        made->faces[i] =
            (struct face){{{first, first, 0}, {second, second, 0}, {second + 1, second + 1, 0}}};
    }
    int exponent; /* any length fits into floats then, and no bit is lost */
    frexp(fmax(fabs(light.x), fmax(fabs(light.y), fabs(light.z))), &exponent);
    made->normals[0][0] = (float)ldexp(light.x, -exponent);
    made->normals[0][1] = (float)ldexp(light.y, -exponent);
    made->normals[0][2] = (float)ldexp(light.z, -exponent);
    made->model.positions = made->positions;
    made->model.uvs = made->uvs;
    made->model.normals = made->normals;
    made->model.faces = made->faces;
    made->state.positions = made->places;
}

enum { TILES = 8, TILE = 16 }; /* a side of the texture, in tiles, and of a tile, in texels */

/* Light tiles and dark ones; redder to the right, bluer upwards. */
static bool make_tiles(struct texture *texture, struct error *error) {
    struct image image;
    if (!image_create(&image, TILES * TILE, TILES * TILE, IMAGE_BGR, error)) {
        return false;
    }
    for (int y = 0; y < TILES * TILE; y++) {
        for (int x = 0; x < TILES * TILE; x++) {
            int column = x / TILE, row = y / TILE, dark = (column + row) % 2;
            double red = 150 + 15 * column, green = 190, blue = 80 + 20 * row;
            double part = dark ? 0.45 : 1;
            image_set(&image, x, y,
                      color_rgb(level_from(red * part), level_from(green * part),
                                level_from(blue * part)));
        }
    }
    bool done = texture_create(texture, &image, error);
    texture_set_clamp(texture, true);
    image_free(&image);
    return done;
}

/* The same drawing of another model. */
static struct drawing drawing_of_quads(const struct drawing *drawing, struct quad_model *quads,
                                       const struct texture *tiles) {
    struct drawing of_quads = *drawing;
    of_quads.parts = NULL;
    of_quads.model = &quads->model;
    of_quads.diffuse = tiles;
    of_quads.state = &quads->state;
    return of_quads;
}

/* How the probed pixel comes to u and v, where a triangle of the quads has it. */
static void note_texel(struct drawing *drawing, const struct canvas *canvas,
                       const struct quad_model *made) {
    const int x = drawing->probe.x, y = drawing->probe.y;
    for (size_t face = 0; drawing->probed && face < made->model.face_count; face++) {
        const struct position *p[3];
        struct vec2 uv[3];
        double recip_w[3];
        struct edges edges;
        for (size_t i = 0; i < 3; i++) {
            p[i] = &made->places[made->model.faces[face].corner[i].position];
            uv[i] = model_uv(&made->model, face, i);
            recip_w[i] = p[i]->vertex.recip_w;
        }
        if (!p[0]->placed || !p[1]->placed || !p[2]->placed ||
            !edges_setup(&edges, p[0]->vertex.position, p[1]->vertex.position,
                         p[2]->vertex.position, canvas->image->width, canvas->image->height) ||
            !edges_cover(&edges, x, y)) {
            continue;
        }
        const struct vec3 screen = edges_weights(&edges, x, y),
                          w = correct_weights(screen, recip_w);
        const struct vec2 affine = vec2_interpolate(screen, uv[0], uv[1], uv[2]);
        const struct vec2 right = vec2_interpolate(w, uv[0], uv[1], uv[2]);
        const double by_w = interpolate(screen, recip_w[0], recip_w[1], recip_w[2]);
        drawing_note(drawing, "u/w %.4f  v/w %.4f  1/w %.4f", right.x * by_w, right.y * by_w, by_w);
        drawing_note(drawing, "u %.4f  v %.4f  w %.4f", right.x, right.y, 1 / by_w);
        drawing_note(drawing, "affine: u %.4f  v %.4f", affine.x, affine.y);
    }
}

/* Draw the quads, transformed by to_clip, with tiles on them. */
static bool draw_quads(struct drawing *drawing, const struct canvas *canvas,
                       const struct quad *quads, size_t count, const struct mat4 *to_clip,
                       struct error *error) {
    struct texture tiles;
    struct quad_model made;
    if (!make_tiles(&tiles, error)) {
        return false;
    }
    quad_model_make(&made, quads, count, drawing->light);
    struct drawing of_quads = drawing_of_quads(drawing, &made, &tiles);
    struct canvas tiled = *canvas;
    draw_faces(&of_quads, &tiled, to_clip);
    count_work(drawing, &tiled, &made.model);
    note_corner(drawing, &tiled, &made.state, &made.model);
    note_texel(drawing, &tiled, &made);
    texture_free(&tiles);
    return true;
}

/* Planes that cross, each of the colour of one tile. */
static const struct quad crossing[] = {
    {{{-0.7, -0.6, 0.2}, {0.7, -0.6, 0.2}, {0.7, 0.6, 0.2}, {-0.7, 0.6, 0.2}},
     {{0.0625, 0.0625}, {0.0625, 0.0625}, {0.0625, 0.0625}, {0.0625, 0.0625}}},
    {{{-0.4, -0.3, 1.3}, {1.6, -0.9, -2}, {1.6, 0.9, -2}, {-0.4, 0.3, 1.3}},
     {{0.8125, 0.0625}, {0.8125, 0.0625}, {0.8125, 0.0625}, {0.8125, 0.0625}}},
    {{{-0.3, -0.4, 1.3}, {0.3, -0.4, 1.3}, {1.2, 1.4, -3}, {-1.2, 1.4, -3}},
     {{0.3125, 0.9375}, {0.3125, 0.9375}, {0.3125, 0.9375}, {0.3125, 0.9375}}},
};

enum { CROSSING_QUADS = sizeof crossing / sizeof crossing[0] };

/* Two faces that must not be seen, on a screen far larger than the image: NDC 0 is pixel 0, and NDC
 * 1 is pixel 2^22. One corner is too far for the screen, one has no finite depth. */
static bool draw_nowhere(struct drawing *drawing, struct image *image, struct error *error) {
    const int side = 1 << 22;
    const double pixel = 1.0 / side;
    const struct quad nowhere[] = {
        {{{600 * pixel, 100 * pixel, 0},
          {200 * pixel, 700 * pixel, 0},
          {-0.9, -0.9, 0},
          {-1, -1, 0}},
         {{0.4375, 0.0625}, {0.4375, 0.0625}, {0.4375, 0.0625}, {0.4375, 0.0625}}},
        {{{150 * pixel, 150 * pixel, 0},
          {650 * pixel, 150 * pixel, 0},
          {400 * pixel, 600 * pixel, 1e308},
          {200 * pixel, 600 * pixel, 1e308}},
         {{0.5625, 0.0625}, {0.5625, 0.0625}, {0.5625, 0.0625}, {0.5625, 0.0625}}},
    };
    const struct mat4 to_clip = mat4_scaling((struct vec3){1, 1, 10});
    struct canvas canvas =
        make_canvas(drawing, image, (struct rectangle){-side, -side, 2 * side, 2 * side});
    canvas.affine = true;
    return draw_quads(drawing, &canvas, nowhere, sizeof nowhere / sizeof nowhere[0], &to_clip,
                      error);
}

static bool draw_crossing(struct drawing *drawing, struct image *image, struct error *error) {
    struct canvas canvas = make_canvas(drawing, image, whole_image(image));
    struct mat4 to_clip = perspective_camera(drawing);
    canvas.affine = true;
    return draw_quads(drawing, &canvas, crossing, CROSSING_QUADS, &to_clip, error) &&
           draw_nowhere(drawing, image, error);
}

/* It leads away from the viewer. */
static const struct quad wall = {
    {{-0.9, -0.45, 1.1}, {0.9, -0.45, -2}, {0.9, 0.45, -2}, {-0.9, 0.45, 1.1}},
    {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/* It nearly faces the viewer. There is little to correct, but enough to see. */
static const struct quad poster = {
    {{0, 0.45, 0}, {0.98, 0.45, -0.09}, {0.98, 0.98, -0.09}, {0, 0.98, 0}},
    {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/* Quads that are in the world as they are given. */
static bool draw_standing(struct drawing *drawing, struct image *image, const struct quad *quads,
                          size_t count, struct error *error) {
    struct canvas canvas = make_canvas(drawing, image, whole_image(image));
    struct mat4 to_clip = perspective_camera(drawing);
    return draw_quads(drawing, &canvas, quads, count, &to_clip, error);
}

static bool draw_wall(struct drawing *drawing, struct image *image, struct error *error) {
    struct quad quads[] = {wall, poster};
    quads[0].corner[1].z = quads[0].corner[2].z = 2 - 2 * drawing_value(drawing, "far");
    return draw_standing(drawing, image, quads, sizeof quads / sizeof quads[0], error);
}

/* The model made narrow, then turned: its matrix comes before those of the camera. */
static struct mat4 narrow_to_world(void) {
    return mat4_mul(mat4_rotation((struct vec3){0, 1, 0}, 0.05),
                    mat4_scaling((struct vec3){0.5, 1, 1}));
}

/* Leaves that are scaled. The first one is flattened by a map without an inverse, and keeps the
 * light of the leaf as it was. The map of the other one has the determinant 1, like a rotation. */
static const struct leaf {
    struct vec3 scale;
    struct quad quad;
} leaves[] = {
    {{1, 1, 0},
     {{{-0.9, -0.9, 0.3}, {-0.6, -0.9, 0}, {-0.6, -0.6, -0.3}, {-0.9, -0.6, 0}},
      {{0, 0}, {0.375, 0}, {0.375, 0.375}, {0, 0.375}}}},
    {{0.25, 1, 4},
     {{{-3.6, 0.6, 0}, {-2.4, 0.6, 0}, {-2.4, 0.9, 0}, {-3.6, 0.9, 0}},
      {{0, 0}, {0.375, 0}, {0.375, 0.375}, {0, 0.375}}}},
};

static bool draw_leaf(struct drawing *drawing, struct image *image, const struct leaf *leaf,
                      struct error *error) {
    const struct mat4 to_world = mat4_scaling(leaf->scale);
    struct canvas canvas = make_canvas(drawing, image, whole_image(image));
    struct mat4 to_clip = mat4_mul(perspective_camera(drawing), to_world);
    canvas.normals_to_world = normals_to_world(to_world);
    return draw_quads(drawing, &canvas, &leaf->quad, 1, &to_clip, error);
}

static void draw_narrow_head(struct drawing *drawing, struct image *image) {
    const struct mat4 to_world = narrow_to_world();
    struct canvas canvas = make_canvas(drawing, image, whole_image(image));
    struct mat4 to_clip = mat4_mul(perspective_camera(drawing), to_world);
    canvas.normals_to_world = normals_to_world(to_world);
    draw_model(drawing, &canvas, &to_clip);
}

static bool draw_narrow(struct drawing *drawing, struct image *image, struct error *error) {
    draw_narrow_head(drawing, image);
    return draw_leaf(drawing, image, &leaves[0], error) &&
           draw_leaf(drawing, image, &leaves[1], error);
}

/* A sail that all five planes cut, in a small view where it hides all behind it. Its three corners
 * become eight, and the last ones show. */
static bool draw_eight_corners(struct drawing *drawing, struct image *image, struct error *error) {
    const int width = (int)image->width, height = (int)image->height;
    const struct rectangle area = {width * 44 / 100, height * 47 / 100, width / 9, height / 9};
    const struct quad sail = {
        {{830, -840, -30}, {-2.3, 19, 13}, {-6, 1.6, -1.1}, {-6, 1.6, -1.1}},
        {{2630, -2640}, {-24, 43}, {-14, 10}, {-14, 10}},
    };
    struct canvas canvas = make_canvas(drawing, image, area);
    struct mat4 to_clip = perspective_camera(drawing);
    return draw_quads(drawing, &canvas, &sail, 1, &to_clip, error);
}

/* A floor and a wall that have no end behind the camera, a leaf right before its lens, and a sail
 * (with three corners) that four planes cut: its three corners become six, and each shows. */
static bool draw_endless(struct drawing *drawing, struct image *image, struct error *error) {
    const double far = 1e14, wide = 1e15, u = wide / 4, v = far / 8;
    const struct quad quads[] = {
        {{{-wide, -0.5, far}, {wide, -0.5, far}, {8, -0.5, -14}, {-8, -0.5, -14}},
         {{-u, -v}, {u, -v}, {2.5, 2}, {-1.5, 2}}},
        {{{0.9, -wide, far}, {0.9, wide, far}, {0.9, 4, -14}, {0.9, -4, -14}},
         {{-v, -u}, {-v, u}, {2, 1.44}, {2, -0.56}}},
        {{{-0.009, 0.004, 1.97},
          {-0.002, 0.002, 1.97},
          {-0.001, 0.003, 1.997},
          {-0.002, 0.003, 1.997}},
         {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
        {{{87, 38, -22}, {-4346, 112, 4278}, {-325, 61, -724}, {-325, 61, -724}},
         {{0.5, 0.25}, {-22, -10}, {-1.5, 2}, {-1.5, 2}}},
    };
    return draw_standing(drawing, image, quads, sizeof quads / sizeof quads[0], error) &&
           draw_eight_corners(drawing, image, error);
}

/* ---- The program ---- */

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    (void)width, (void)height;
    struct state *state = drawing->state;
    if (drawing->model == NULL) {
        return true;
    }
    state->positions = calloc(drawing->model->position_count, sizeof *state->positions);
    if (state->positions == NULL) {
        error_out_of_memory(error);
    }
    return state->positions != NULL;
}

static void finish(struct drawing *drawing) {
    struct state *state = drawing->state;
    free(state->positions);
}

enum { NEEDS_VIEW = NEEDS_MODEL | NEEDS_NORMALS | NEEDS_DIFFUSE | NEEDS_DEPTH };

#define VIEW_VALUES                                                                                \
    {"near", "w of the near plane", 1.0 / 128, 1, 1.0 / 128, 1.0 / 128},                           \
        {"attempt", "0 cut, 1 divided by any w, 2 left out", 0, 2, 1, 0}, {                        \
        "affine", "mixed without 1/w", 0, 1, 1, 0                                                  \
    }
static const struct scene_value wall_values[] = {
    {"far", "w of the wall's far end", 0.5, 8, 0.1, 2},
    VIEW_VALUES,
    {.name = NULL},
};
static const struct scene_value view_values[] = {VIEW_VALUES, {.name = NULL}};

static const struct scene scenes[] = {
    /* Not square, and odd: exchanged or halved sizes show. */
    {
        .name = "house",
        .width = 405,
        .height = 363,
        .values = matrix_values,
        .draw = draw_unmapped,
    },
    /* The panels one by one. */
    {.name = "scale", .number = 0, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "shear", .number = 1, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "turn", .number = 2, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "scale_turn", .number = 3, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "turn_scale", .number = 4, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "turn_about", .number = 5, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "move_turn", .number = 6, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "turn_move", .number = 7, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "divided", .number = 8, .width = 400, .height = 400, .draw = draw_alone},
    {.name = "transforms", .draw = draw_transforms},
    {.name = "viewport", .needs = NEEDS_VIEW, .draw = draw_viewport},
    {.name = "projection", .needs = NEEDS_VIEW, .draw = draw_projection},
    {.name = "crossing", .needs = NEEDS_DEPTH, .draw = draw_crossing},
    {.name = "wall", .needs = NEEDS_DEPTH, .values = wall_values, .draw = draw_wall},
    {.name = "narrow", .needs = NEEDS_VIEW, .draw = draw_narrow},
    {
        .name = "lookat",
        .needs = NEEDS_VIEW,
        .eye = {1, 1, 2},
        .values = view_values,
        .draw = draw_view,
    },
    {
        .name = "tilted",
        .needs = NEEDS_VIEW,
        .eye = {-2, 0.5, 0.8},
        .up = {0, 2, 1},
        .light = {-2, 1, 1},
        .draw = draw_view,
    },
    {
        .name = "above",
        .needs = NEEDS_VIEW,
        .eye = {0.1, 2.3, 0.2}, /* looks along `up`, as near as it matters */
        .center = {0.1, 0.3, 0.2},
        .up = {0, 1, 1e-12},
        .light = {1, 3, 2},
        .draw = draw_above,
    },
    {
        .name = "closeup",
        .detail = true,
        .needs = NEEDS_VIEW,
        .eye = {0.03, 0.47, 0.46}, /* between the eyebrows, looking down the nose */
        .center = {0.03, -0.3, 0.4},
        .up = {0, 0, 1},
        .values = view_values,
        .draw = draw_view,
    },
    {.name = "endless", .needs = NEEDS_DEPTH, .values = view_values, .draw = draw_endless},
    /* Not square, and odd: what a square or large picture hides shows here. */
    {
        .name = "wide",
        .detail = true,
        .needs = NEEDS_VIEW,
        .width = 203,
        .height = 67,
        .draw = draw_viewport,
    },
    {
        .name = "high",
        .detail = true,
        .needs = NEEDS_VIEW,
        .width = 61,
        .height = 181,
        .eye = {1, 1, 2},
        .draw = draw_view,
    },
    {
        .name = "small",
        .detail = true,
        .needs = NEEDS_VIEW,
        .width = 23,
        .height = 13,
        .eye = {0.03, 0.47, 0.46},
        .center = {0.03, -0.3, 0.4},
        .up = {0, 0, 1},
        .draw = draw_view,
    },
    {
        .name = "one_pixel",
        .needs = NEEDS_DEPTH,
        .width = 1,
        .height = 1,
        .values = wall_values,
        .draw = draw_wall,
    },
};

static const struct program step08_projection = {
    .name = "step08_projection",
    .summary = "matrices, perspective, and a camera anywhere",
    .takes_light = true,
    .takes_camera = true,
    .defaults =
        {.width = 800, .height = 800, .eye = {0, 0, 2}, .up = {0, 1, 0}, .light = {1, 1, 2}},
    .scenes = scenes,
    .scene_count = sizeof scenes / sizeof scenes[0],
    .state_size = sizeof(struct state),
    .prepare = prepare,
    .finish = finish,
};
