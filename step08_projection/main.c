/*
 * Step 8: matrices, perspective and the camera.
 *
 * A point goes through a chain of matrices, from the model to the screen:
 *
 *     clip   = projection * lookat * point      the camera; w says how far away it is
 *     ndc    = clip / w                         -1..1 over the picture
 *     screen = viewport * ndc                   pixels
 *
 * What lies behind the camera has no place on the screen: it is cut off before the division.
 *
 * Scenes: `transforms` shows what matrices do to a small house. `viewport` draws a model into
 * several rectangles, without perspective. `projection` adds perspective, `lookat` a camera
 * anywhere, and `closeup` a camera so near that faces pass behind it.
 */
#include "program.h"
#include "texture.h"

#include <math.h>
#include <stdlib.h>

/* ---- The three matrices of the camera ---- */

/* NDC (-1..1) to a picture of width x height pixels whose lower left corner is at (0,0). */
static struct mat4 viewport(size_t width, size_t height) {
    double half_width = (double)width / 2, half_height = (double)height / 2;
    return (struct mat4){{{half_width, 0, 0, half_width},
                          {0, half_height, 0, half_height},
                          {0, 0, 1, 0},
                          {0, 0, 0, 1}}};
}

/* A camera at (0, 0, distance) that looks along -z: w = 1 - z / distance. An infinite distance
 * gives the parallel view. */
static struct mat4 projection(double distance) {
    struct mat4 projection = mat4_identity();
    projection.m[3][2] = -1 / distance;
    return projection;
}

/* The world axis most nearly perpendicular to a direction. */
static struct vec3 perpendicular_axis(struct vec3 direction) {
    struct vec3 d = {fabs(direction.x), fabs(direction.y), fabs(direction.z)};
    if (d.y <= d.x && d.y <= d.z) {
        return (struct vec3){0, 1, 0};
    }
    return d.x <= d.z ? (struct vec3){1, 0, 0} : (struct vec3){0, 0, 1};
}

/* Half the difference of two points: the difference itself could overflow. */
static struct vec3 half_difference(struct vec3 a, struct vec3 b) {
    return vec3_sub(vec3_scale(a, 0.5), vec3_scale(b, 0.5));
}

/* Bring a vector that is nearly of length 1 to the last bit or two: one step of Newton's method for
 * 1 / length. Zero stays zero. */
static struct vec3 unit_length(struct vec3 a) {
    return vec3_scale(a, 1.5 - 0.5 * vec3_dot(a, a));
}

/* The world as the camera sees it: `center` becomes the origin, the direction from there to `eye`
 * becomes z, and `up` appears upwards. The rows are the camera's own axes x, y, z. */
static struct mat4 lookat(struct vec3 eye, struct vec3 center, struct vec3 up) {
    struct vec3 z = unit_length(vec3_normalized(half_difference(eye, center)));
    if (vec3_dot(z, z) == 0) {
        z = (struct vec3){0, 0, 1};
    }
    struct vec3 x = vec3_cross(vec3_normalized(up), z);
    if (vec3_dot(x, x) < 1e-20) { /* up is parallel to the view direction, as near as it matters */
        x = vec3_cross(perpendicular_axis(z), z);
    }
    x = vec3_normalized(x);
    /* A short cross product has lost digits: make x perpendicular to z once more. */
    x = unit_length(vec3_sub(x, vec3_scale(z, vec3_dot(x, z))));
    struct vec3 y = unit_length(vec3_cross(z, x));
    return (struct mat4){{{x.x, x.y, x.z, -vec3_dot(x, center)},
                          {y.x, y.y, y.z, -vec3_dot(y, center)},
                          {z.x, z.y, z.z, -vec3_dot(z, center)},
                          {0, 0, 0, 1}}};
}

/* ---- Perspective inside a triangle ---- */

/* The weights of the corners in the plane of the triangle, from those on the screen: a corner far
 * away counts for less (Blinn, "Hyperbolic Interpolation", 1992). */
static struct vec3 correct_weights(struct vec3 screen, const double recip_w[3]) {
    double a = screen.x * recip_w[0], b = screen.y * recip_w[1], c = screen.z * recip_w[2];
    double scale = 1 / (a + b + c);
    return (struct vec3){a * scale, b * scale, c * scale};
}

/* ---- Clipping: only what lies in front of the camera can be divided by w ---- */

/* Nearer than this share of the camera's distance nothing is drawn: there 1/w grows without bound.
 */
static const double near_w = 1.0 / 128;

/* Faces are cut where they leave NDC -64..64: far outside the image, so that few are, but within
 * SCREEN_LIMIT for the largest image. */
static const double guard_band = 64;

enum { CLIP_PLANES = 5 };

/* A convex polygon gains at most one corner at each plane. Where coordinates differ by many
 * orders of magnitude, rounding can make the polygon not convex, and n corners become up to n +
 * n/2 at each of the five planes: 3, 4, 6, 9, 13, 19. */
enum { POLYGON_LIMIT = 19 };

/* A corner of a polygon while it is clipped. */
struct clip_corner {
    struct vec4 clip;
    struct vec3 weight; /* of the face's corners; sum 1 */
};

struct polygon {
    struct clip_corner corner[POLYGON_LIMIT];
    size_t count;
};

/* Signed distances to the planes, positive inside. */
static double plane_distance(struct vec4 p, int plane) {
    switch (plane) {
    case 0:
        return p.w - near_w;
    case 1:
        return guard_band * p.w + p.x;
    case 2:
        return guard_band * p.w - p.x;
    case 3:
        return guard_band * p.w + p.y;
    default:
        return guard_band * p.w - p.y;
    }
}

static double mix(double from, double to, double t) {
    return from + t * (to - from);
}

/* Where an edge crosses the plane. Always computed from the corner inside to the one outside, so
 * that both faces of an edge find the very same point, and no gap opens between them. */
static struct clip_corner cut_edge(const struct clip_corner *inside,
                                   const struct clip_corner *outside, double inside_distance,
                                   double outside_distance) {
    double t = inside_distance / (inside_distance - outside_distance);
    struct vec4 p = inside->clip, q = outside->clip;
    struct vec3 v = inside->weight, w = outside->weight;
    return (struct clip_corner){
        .clip = {mix(p.x, q.x, t), mix(p.y, q.y, t), mix(p.z, q.z, t), mix(p.w, q.w, t)},
        .weight = {mix(v.x, w.x, t), mix(v.y, w.y, t), mix(v.z, w.z, t)},
    };
}

/* The part of a polygon on the inner side of a plane (Sutherland and Hodgman, "Reentrant Polygon
 * Clipping", 1974). */
static struct polygon clip_at_plane(const struct polygon *polygon, int plane) {
    struct polygon result = {.count = 0};
    for (size_t i = 0; i < polygon->count; i++) {
        const struct clip_corner *a = &polygon->corner[i];
        const struct clip_corner *b = &polygon->corner[(i + 1) % polygon->count];
        double a_distance = plane_distance(a->clip, plane);
        double b_distance = plane_distance(b->clip, plane);
        bool a_inside = a_distance >= 0, b_inside = b_distance >= 0;
        if (a_inside) {
            result.corner[result.count++] = *a;
        }
        if (a_inside && !b_inside) {
            result.corner[result.count++] = cut_edge(a, b, a_distance, b_distance);
        } else if (!a_inside && b_inside) {
            result.corner[result.count++] = cut_edge(b, a, b_distance, a_distance);
        }
    }
    return result;
}

/* ---- Triangles ---- */

/* A corner of a triangle that is to be drawn. */
struct vertex {
    struct fixed2 position; /* on the screen */
    double depth;           /* z/w, linear on the screen; larger is nearer */
    double recip_w;         /* 1/w */
    double intensity;       /* 0..1 */
    struct vec2 uv;
};

/* A part of the image, in pixels: left and bottom inclusive, right and top exclusive. */
struct area {
    int left, bottom, right, top;
};

/* What is drawn on, and the work done on it. */
struct canvas {
    struct image *image;
    struct area area;              /* nothing is drawn outside */
    struct mat4 to_screen;         /* from NDC */
    double *depth;                 /* one a pixel of the image, row by row from the bottom */
    const struct texture *texture; /* NULL: white */
    bool skip;                     /* compute a colour only where it will be seen */
    uint64_t pixels_tested;        /* covered by a triangle */
    uint64_t pixels_shaded;
    uint64_t pixels_written;
};

static void clear_depth(double *depth, size_t pixel_count) {
    for (size_t i = 0; i < pixel_count; i++) {
        depth[i] = -INFINITY;
    }
}

/* The texture's colour times the intensity. */
static struct color shade(const struct texture *texture, struct vec2 uv, double intensity) {
    const struct vec4 white = {255, 255, 255, 255};
    struct vec4 c = texture != NULL ? texture_bilinear(texture, uv, 0) : white;
    return color_rgb(level_from(c.x * intensity), level_from(c.y * intensity),
                     level_from(c.z * intensity));
}

/* The triangles of steps 6 and 7 in one. The depth is interpolated with the weights on the screen,
 * all else with the correct weights. */
static void triangle(struct canvas *canvas, const struct edges *edges, const struct vertex v[3]) {
    const double recip_w[3] = {v[0].recip_w, v[1].recip_w, v[2].recip_w};
    const struct area *area = &canvas->area;
    int y_begin = edges->y_begin > area->bottom ? edges->y_begin : area->bottom;
    int y_end = edges->y_end < area->top ? edges->y_end : area->top;
    for (int y = y_begin; y < y_end; y++) {
        struct span span = edges_span(edges, y);
        int x_begin = span.begin > area->left ? span.begin : area->left;
        int x_end = span.end < area->right ? span.end : area->right;
        double *row = canvas->depth + (size_t)y * canvas->image->width;
        for (int x = x_begin; x < x_end; x++) {
            struct vec3 weight = edges_weights(edges, x, y);
            double depth = interpolate(weight, v[0].depth, v[1].depth, v[2].depth);
            bool seen = depth > row[x];
            struct color color = {0};
            canvas->pixels_tested++;
            if (seen || !canvas->skip) { /* what is hidden needs no colour */
                struct vec3 correct = correct_weights(weight, recip_w);
                double intensity =
                    interpolate(correct, v[0].intensity, v[1].intensity, v[2].intensity);
                color = shade(canvas->texture, vec2_interpolate(correct, v[0].uv, v[1].uv, v[2].uv),
                              intensity);
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

/* ---- Positions ---- */

/* Sides of the view that a position is beyond. */
enum {
    BEYOND_LEFT = 1,
    BEYOND_RIGHT = 2,
    BEYOND_BOTTOM = 4,
    BEYOND_TOP = 8,
    BEYOND_NEAR = 16,
    BEYOND_GUARD_BAND = 32
};

/* Written so that what is not a number is beyond everything. */
static unsigned find_beyond(struct vec4 p) {
    unsigned beyond = 0;
    beyond |= p.x >= -p.w ? 0 : BEYOND_LEFT;
    beyond |= p.x <= p.w ? 0 : BEYOND_RIGHT;
    beyond |= p.y >= -p.w ? 0 : BEYOND_BOTTOM;
    beyond |= p.y <= p.w ? 0 : BEYOND_TOP;
    beyond |= p.w >= near_w ? 0 : BEYOND_NEAR;
    double guard = guard_band * p.w;
    beyond |= fabs(p.x) <= guard && fabs(p.y) <= guard ? 0 : BEYOND_GUARD_BAND;
    return beyond;
}

/* Clip space to the screen: here is the division. False when there is no such place on the screen:
 * coordinates too large to compute with. */
static bool place(struct vec4 clip, const struct mat4 *to_screen, struct vertex *vertex) {
    vertex->recip_w = 1 / clip.w;
    vertex->depth = clip.z * vertex->recip_w;
    struct vec3 ndc = {clip.x * vertex->recip_w, clip.y * vertex->recip_w, vertex->depth};
    struct vec4 screen = mat4_point(to_screen, ndc);
    return isfinite(vertex->depth) &&
           screen_snap((struct vec2){screen.x, screen.y}, &vertex->position);
}

/* A position of the model, transformed. The last three are for place_once(). */
struct position {
    struct vec4 clip;
    unsigned beyond;
    bool tried, placed;   /* place() was called, and gave a place on the screen */
    struct vertex vertex; /* without intensity and uv */
};

/* Memory of a scene that is used again at every drawing. */
struct state {
    double *depth;                 /* one a pixel */
    struct position *positions;    /* one a position of the model */
    double *intensities;           /* one a normal of the model; negative when not known yet */
    const struct texture *texture; /* belongs to the model; NULL without texture coordinates */
};

/* Each position is transformed once, however many faces share it. */
static void transform_positions(const struct drawing *drawing, const struct mat4 *to_clip) {
    const struct state *state = drawing->state;
    const struct model *model = drawing->model;
    for (size_t i = 0; i < model->position_count; i++) {
        const float *p = model->positions[i];
        struct position *position = &state->positions[i];
        position->clip = mat4_point(to_clip, (struct vec3){p[0], p[1], p[2]});
        position->beyond = find_beyond(position->clip);
        position->tried = position->placed = false;
    }
}

/* The division by w, when the first face needs this position. False when it has no place on the
 * screen. */
static bool place_once(struct position *position, const struct mat4 *to_screen) {
    if (!position->tried) {
        position->tried = true;
        position->placed = place(position->clip, to_screen, &position->vertex);
    }
    return position->placed;
}

/* ---- Faces ---- */

/* What happened to the faces. A face that is clipped becomes several triangles, or none. */
struct tally {
    uint64_t outside, clipped, off_limits;
    uint64_t triangles, turned_away, without_pixel;
    uint64_t normals_lit, intensities_reused;
};

/* How much light a surface takes, as in step 7. Both vectors have length 1. */
static double corner_intensity(struct vec3 normal, struct vec3 to_light) {
    double cosine = vec3_dot(normal, to_light);
    return cosine > 0 ? cosine : 0;
}

/* The intensity at a corner, from memory where its normal has been lit before. */
static double light_corner(const struct drawing *drawing, size_t face, size_t corner,
                           struct vec3 to_light, struct tally *tally) {
    const struct state *state = drawing->state;
    double *known = &state->intensities[drawing->model->faces[face].corner[corner].normal];
    if (drawing->skip && *known >= 0) {
        tally->intensities_reused++;
    } else {
        struct vec3 normal = vec3_normalized(model_normal(drawing->model, face, corner));
        *known = corner_intensity(normal, to_light);
        tally->normals_lit++;
    }
    return *known;
}

/* A face on its way to the screen. Intensities and texture coordinates are fetched when the first
 * of its triangles turns out to be drawn. */
struct face_in_view {
    size_t index;
    bool fetched;
    double intensity[3];
    struct vec2 uv[3];
};

static void fetch_face(const struct drawing *drawing, struct face_in_view *face,
                       struct vec3 to_light, struct tally *tally) {
    if (face->fetched) {
        return;
    }
    for (size_t i = 0; i < 3; i++) {
        face->intensity[i] = light_corner(drawing, face->index, i, to_light, tally);
        face->uv[i] = model_uv(drawing->model, face->index, i);
    }
    face->fetched = true;
}

/* Draw a triangle of a face: the face itself, or a part that clipping left. `weight` says where its
 * corners lie between those of the face. A triangle whose corners run clockwise on the screen shows
 * its inside: in a closed body something else is in front of it. */
static void draw_part(struct drawing *drawing, struct canvas *canvas, struct face_in_view *face,
                      struct vertex v[3], const struct vec3 weight[3], struct tally *tally) {
    struct edges edges;
    tally->triangles++;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, canvas->image->width,
                     canvas->image->height)) {
        tally->without_pixel++;
        return;
    }
    tally->turned_away += edges.clockwise;
    if (edges.clockwise && drawing->skip) {
        return; /* before its light is computed */
    }
    fetch_face(drawing, face, vec3_normalized(drawing->light), tally);
    for (int i = 0; i < 3; i++) {
        const double *n = face->intensity;
        v[i].intensity = interpolate(weight[i], n[0], n[1], n[2]);
        v[i].uv = vec2_interpolate(weight[i], face->uv[0], face->uv[1], face->uv[2]);
    }
    if (!edges.clockwise) {
        triangle(canvas, &edges, v);
    }
}

/* Cut a face at all planes and draw what is left as a fan of triangles around its first corner. */
static void draw_clipped(struct drawing *drawing, struct canvas *canvas, struct face_in_view *face,
                         struct position *const corner[3], struct tally *tally) {
    struct polygon polygon = {.corner = {{corner[0]->clip, {1, 0, 0}},
                                         {corner[1]->clip, {0, 1, 0}},
                                         {corner[2]->clip, {0, 0, 1}}},
                              .count = 3};
    for (int plane = 0; plane < CLIP_PLANES && polygon.count > 0; plane++) {
        polygon = clip_at_plane(&polygon, plane);
    }
    if (polygon.count < 3) {
        tally->outside++;
        return;
    }
    tally->clipped++;
    struct vertex vertices[POLYGON_LIMIT];
    for (size_t i = 0; i < polygon.count; i++) {
        if (!place(polygon.corner[i].clip, &canvas->to_screen, &vertices[i])) {
            tally->off_limits++;
            return;
        }
    }
    for (size_t i = 2; i < polygon.count; i++) {
        struct vertex v[3] = {vertices[0], vertices[i - 1], vertices[i]};
        const struct vec3 weight[3] = {polygon.corner[0].weight, polygon.corner[i - 1].weight,
                                       polygon.corner[i].weight};
        draw_part(drawing, canvas, face, v, weight, tally);
    }
}

static void draw_face(struct drawing *drawing, struct canvas *canvas, size_t index,
                      struct tally *tally) {
    static const struct vec3 whole[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const struct state *state = drawing->state;
    const struct corner *c = drawing->model->faces[index].corner;
    struct position *corner[3] = {&state->positions[c[0].position],
                                  &state->positions[c[1].position],
                                  &state->positions[c[2].position]};
    struct face_in_view face = {.index = index};
    unsigned beyond_all = corner[0]->beyond & corner[1]->beyond & corner[2]->beyond;
    unsigned beyond_any = corner[0]->beyond | corner[1]->beyond | corner[2]->beyond;
    if (drawing->skip && (beyond_all & ~(unsigned)BEYOND_GUARD_BAND) != 0) {
        tally->outside++; /* all of it lies beyond one side */
    } else if ((beyond_any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0) {
        draw_clipped(drawing, canvas, &face, corner, tally);
    } else if (!place_once(corner[0], &canvas->to_screen) ||
               !place_once(corner[1], &canvas->to_screen) ||
               !place_once(corner[2], &canvas->to_screen)) {
        tally->off_limits++;
    } else {
        struct vertex v[3] = {corner[0]->vertex, corner[1]->vertex, corner[2]->vertex};
        draw_part(drawing, canvas, &face, v, whole, tally);
    }
}

/* How many positions were divided by w. */
static uint64_t count_tried(const struct drawing *drawing) {
    const struct state *state = drawing->state;
    uint64_t tried = 0;
    for (size_t i = 0; i < drawing->model->position_count; i++) {
        tried += state->positions[i].tried;
    }
    return tried;
}

/* Draw the model, transformed by to_clip, into the canvas's area. */
static void draw_model(struct drawing *drawing, struct canvas *canvas, const struct mat4 *to_clip) {
    const struct model *model = drawing->model;
    struct tally tally = {0};
    transform_positions(drawing, to_clip);
    for (size_t face = 0; face < model->face_count; face++) {
        draw_face(drawing, canvas, face, &tally);
    }
    count(drawing, "positions_transformed", model->position_count);
    count(drawing, "positions_divided", count_tried(drawing));
    count(drawing, "faces", model->face_count);
    count(drawing, "faces_outside", tally.outside);
    count(drawing, "faces_clipped", tally.clipped);
    count(drawing, "faces_off_limits", tally.off_limits);
    count(drawing, "triangles", tally.triangles);
    count(drawing, "triangles_turned_away", tally.turned_away);
    count(drawing, "triangles_without_pixel", tally.without_pixel);
    count(drawing, "normals_lit", tally.normals_lit);
    count(drawing, "intensities_reused", tally.intensities_reused);
    count(drawing, "pixels_tested", canvas->pixels_tested);
    count(drawing, "pixels_shaded", canvas->pixels_shaded);
    count(drawing, "pixels_written", canvas->pixels_written);
}

/* ---- Scenes with the model ---- */

static void forget_intensities(const struct drawing *drawing) {
    const struct state *state = drawing->state;
    for (size_t i = 0; i < drawing->model->normal_count; i++) {
        state->intensities[i] = -1;
    }
}

/* A canvas that draws into one rectangle of the image: the viewport, moved to the rectangle. */
static struct canvas make_canvas(const struct drawing *drawing, struct image *image,
                                 struct area area) {
    const struct state *state = drawing->state;
    const struct vec3 corner = {area.left, area.bottom, 0};
    size_t width = (size_t)(area.right - area.left), height = (size_t)(area.top - area.bottom);
    return (struct canvas){
        .image = image,
        .area = area,
        .to_screen = mat4_mul(mat4_translation(corner), viewport(width, height)),
        .depth = state->depth,
        .texture = state->texture,
        .skip = drawing->skip,
    };
}

static struct area whole_image(const struct image *image) {
    return (struct area){.right = (int)image->width, .top = (int)image->height};
}

/* The drawing's camera, at a distance that may be infinite. */
static struct mat4 camera(const struct drawing *drawing, double distance) {
    return mat4_mul(projection(distance), lookat(drawing->eye, drawing->center, drawing->up));
}

static void begin_picture(const struct drawing *drawing, const struct image *image) {
    const struct state *state = drawing->state;
    clear_depth(state->depth, image->width * image->height);
    forget_intensities(drawing);
}

/* Scenes projection, lookat and closeup: they differ in their eye, center and up. */
static bool draw_view(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    struct canvas canvas = make_canvas(drawing, image, whole_image(image));
    struct mat4 to_clip = camera(drawing, vec3_length(vec3_sub(drawing->eye, drawing->center)));
    begin_picture(drawing, image);
    draw_model(drawing, &canvas, &to_clip);
    return true;
}

/* The rectangles of scene viewport, in eighths of the image, and what they are filled with. */
static const struct pane {
    struct area eighths;
    struct color color;
} panes[] = {
    {{.left = 0, .bottom = 3, .right = 5, .top = 8}, {.r = 34, .g = 44, .b = 62, .a = 255}},
    {{.left = 5, .bottom = 3, .right = 8, .top = 8}, {.r = 62, .g = 40, .b = 34, .a = 255}},
    {{.left = 0, .bottom = 0, .right = 5, .top = 3}, {.r = 36, .g = 56, .b = 40, .a = 255}},
    {{.left = 5, .bottom = 0, .right = 8, .top = 3}, {.r = 54, .g = 50, .b = 30, .a = 255}},
};

/* A rectangle of the image from eighths of its size, rounded down. */
static struct area pane_area(struct area eighths, const struct image *image) {
    int width = (int)image->width, height = (int)image->height;
    return (struct area){
        .left = width * eighths.left / 8,
        .bottom = height * eighths.bottom / 8,
        .right = width * eighths.right / 8,
        .top = height * eighths.top / 8,
    };
}

static void fill_area(struct image *image, struct area area, struct color color) {
    for (int y = area.bottom; y < area.top; y++) {
        for (int x = area.left; x < area.right; x++) {
            image_set(image, x, y, color);
        }
    }
}

/* The same view in each pane, without perspective: only the viewport differs. */
static bool draw_viewport(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct mat4 to_clip = camera(drawing, INFINITY);
    begin_picture(drawing, image);
    for (size_t i = 0; i < sizeof panes / sizeof panes[0]; i++) {
        struct area area = pane_area(panes[i].eighths, image);
        struct canvas canvas = make_canvas(drawing, image, area);
        fill_area(image, area, panes[i].color);
        draw_model(drawing, &canvas, &to_clip);
    }
    return true;
}

/* ---- Scene: transforms ---- */

/* The house: convex polygons, those in front last. */
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

/* Moves x by y * amount; y stays. */
static struct mat4 shear(double amount) {
    struct mat4 shear = mat4_identity();
    shear.m[0][1] = amount;
    return shear;
}

/* In the plane, about the origin, counterclockwise. */
static struct mat4 rotate(double turns) {
    return mat4_rotation((struct vec3){0, 0, 1}, turns);
}

/* About another point: move it to the origin, rotate, move back. */
static struct mat4 rotate_about(struct vec3 point, double turns) {
    struct mat4 there = mat4_translation(vec3_scale(point, -1)), back = mat4_translation(point);
    return mat4_mul(back, mat4_mul(rotate(turns), there));
}

enum { PANEL_COLUMNS = 3, PANEL_COUNT = 9 };

static const struct vec3 pivot = {1, 0.8, 0}; /* of the rotation about a point */

/* What the panels show, row by row from the top left. */
static struct mat4 panel_map(int panel) {
    const struct mat4 scale = mat4_scaling((struct vec3){1.5, 0.5, 1});
    const struct mat4 move = mat4_translation((struct vec3){-0.8, -1.3, 0});
    struct mat4 map = mat4_identity();
    switch (panel) {
    case 0:
        return scale;
    case 1:
        return shear(0.6);
    case 2:
        return rotate(0.125);
    case 3:
        return mat4_mul(rotate(0.125), scale); /* scaled first */
    case 4:
        return mat4_mul(scale, rotate(0.125)); /* rotated first */
    case 5:
        return rotate_about(pivot, 0.125);
    case 6:
        return mat4_mul(rotate(0.125), move); /* moved first */
    case 7:
        return mat4_mul(move, rotate(0.125)); /* rotated first */
    default:
        map.m[3][0] = 0.5; /* w = 1 + x/2: not linear, a first look at perspective */
        return map;
    }
}

static struct vec2 to_pixels(const struct mat4 *map, struct vec2 p) {
    struct vec4 q = mat4_point(map, (struct vec3){p.x, p.y, 0});
    return (struct vec2){q.x / q.w, q.y / q.w};
}

/* A line between two points of the plane, in the pixels in which its mapped ends lie. */
static void plane_line(struct image *image, const struct area *area, const struct mat4 *map,
                       struct vec2 from, struct vec2 to, struct color color) {
    struct vec2 a = to_pixels(map, from), b = to_pixels(map, to);
    struct pixel p = {(int)floor(a.x), (int)floor(a.y)}, q = {(int)floor(b.x), (int)floor(b.y)};
    struct line_walk walk;
    bool more = line_begin(&walk, p, q, image->width, image->height);
    for (; more; more = line_next(&walk)) {
        if (walk.x >= area->left && walk.x < area->right && walk.y >= area->bottom &&
            walk.y < area->top) {
            image_set(image, walk.x, walk.y, color);
        }
    }
}

/* A triangle of one colour, cut to the area. */
static void plane_triangle(struct image *image, const struct area *area, const struct mat4 *map,
                           const struct vec2 corner[3], struct color color) {
    struct fixed2 p[3] = {{0, 0}};
    struct edges edges;
    for (int i = 0; i < 3; i++) {
        screen_snap(to_pixels(map, corner[i]), &p[i]); /* never beyond the limit */
    }
    if (!edges_setup(&edges, p[0], p[1], p[2], image->width, image->height)) {
        return;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        for (int x = span.begin; x < span.end; x++) {
            if (x >= area->left && x < area->right && y >= area->bottom && y < area->top) {
                image_set(image, x, y, color);
            }
        }
    }
}

static void draw_house(struct image *image, const struct area *area, const struct mat4 *map) {
    for (size_t i = 0; i < HOUSE_PARTS; i++) {
        const struct vec2 *c = house[i].corner;
        const struct vec2 lower[3] = {c[0], c[1], c[2]}, upper[3] = {c[0], c[2], c[3]};
        plane_triangle(image, area, map, lower, house[i].color);
        plane_triangle(image, area, map, upper, house[i].color);
    }
}

static void outline_house(struct image *image, const struct area *area, const struct mat4 *map,
                          struct color color) {
    for (size_t i = 0; i < HOUSE_PARTS; i++) {
        for (size_t k = 0; k < PART_CORNERS; k++) {
            plane_line(image, area, map, house[i].corner[k],
                       house[i].corner[(k + 1) % PART_CORNERS], color);
        }
    }
}

/* A cross of two short lines. */
static void mark_point(struct image *image, const struct area *area, const struct mat4 *map,
                       struct vec3 p, struct color color) {
    const double size = 0.08;
    plane_line(image, area, map, (struct vec2){p.x - size, p.y - size},
               (struct vec2){p.x + size, p.y + size}, color);
    plane_line(image, area, map, (struct vec2){p.x - size, p.y + size},
               (struct vec2){p.x + size, p.y - size}, color);
}

/* Each panel shows -2..2 in x and y: axes, the house through the map, and its outline without. */
static void draw_panel(struct image *image, const struct area *area, int panel) {
    const struct color axis = color_grey(90), outline = color_grey(165);
    const struct vec3 corner = {area->left, area->bottom, 0};
    size_t width = (size_t)(area->right - area->left), height = (size_t)(area->top - area->bottom);
    struct mat4 to_screen =
        mat4_mul(mat4_translation(corner),
                 mat4_mul(viewport(width, height), mat4_scaling((struct vec3){0.5, 0.5, 1})));
    struct mat4 mapped = mat4_mul(to_screen, panel_map(panel));
    plane_line(image, area, &to_screen, (struct vec2){-2, 0}, (struct vec2){2, 0}, axis);
    plane_line(image, area, &to_screen, (struct vec2){0, -2}, (struct vec2){0, 2}, axis);
    draw_house(image, area, &mapped);
    outline_house(image, area, &to_screen, outline);
    if (panel == 5) {
        mark_point(image, area, &to_screen, pivot, color_rgb(255, 255, 255));
    }
}

static bool draw_transforms(struct drawing *drawing, struct image *image, struct error *error) {
    (void)drawing, (void)error;
    int width = (int)image->width, height = (int)image->height;
    const int margin = 4; /* between the panels */
    for (int i = 0; i < PANEL_COUNT; i++) {
        int column = i % PANEL_COLUMNS, row = PANEL_COLUMNS - 1 - i / PANEL_COLUMNS;
        struct area area = {
            .left = width * column / PANEL_COLUMNS + margin,
            .bottom = height * row / PANEL_COLUMNS + margin,
            .right = width * (column + 1) / PANEL_COLUMNS - margin,
            .top = height * (row + 1) / PANEL_COLUMNS - margin,
        };
        if (area.left < area.right && area.bottom < area.top) {
            fill_area(image, area, color_grey(26));
            draw_panel(image, &area, i);
        }
    }
    return true;
}

/* ---- The program ---- */

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    struct state *state = drawing->state;
    struct model *model = drawing->model;
    if (model == NULL) {
        return true;
    }
    if (!model_need_normals(model, error)) {
        return false;
    }
    state->depth = calloc(width * height, sizeof *state->depth);
    state->positions = calloc(model->position_count, sizeof *state->positions);
    state->intensities = calloc(model->normal_count, sizeof *state->intensities);
    if (state->depth == NULL || state->positions == NULL || state->intensities == NULL) {
        return error_set(error, "not enough memory for a picture of %zux%zu pixels", width, height);
    }
    if (model->uv_count == 0) {
        return true; /* no corner says where it lies in a picture: none is read */
    }
    state->texture = model_texture(model, MODEL_DIFFUSE, error);
    return state->texture != NULL;
}

static void finish(struct drawing *drawing) {
    struct state *state = drawing->state;
    free(state->depth);
    free(state->positions);
    free(state->intensities);
}

int main(int argc, char **argv) {
    static const struct scene scenes[] = {
        {
            .name = "transforms",
            .width = 800,
            .height = 800,
            .eye = {0, 0, 2}, /* not used; --eye and --center are for the others */
            .draw = draw_transforms,
        },
        {
            .name = "viewport",
            .width = 800,
            .height = 800,
            .needs_model = true,
            .eye = {0, 0, 2},
            .up = {0, 1, 0},
            .light = {1, 1, 2},
            .draw = draw_viewport,
        },
        {
            .name = "projection",
            .width = 800,
            .height = 800,
            .needs_model = true,
            .eye = {0, 0, 2},
            .up = {0, 1, 0},
            .light = {1, 1, 2},
            .draw = draw_view,
        },
        {
            .name = "lookat",
            .width = 800,
            .height = 800,
            .needs_model = true,
            .eye = {1, 1, 2},
            .up = {0, 1, 0},
            .light = {1, 1, 2},
            .draw = draw_view,
        },
        {
            .name = "closeup",
            .width = 800,
            .height = 800,
            .needs_model = true,
            .eye = {0.03, 0.47, 0.46}, /* between the eyebrows, looking down the nose */
            .center = {0.03, -0.3, 0.4},
            .up = {0, 0, 1},
            .light = {1, 1, 2},
            .draw = draw_view,
        },
    };
    static const struct program program = {
        .name = "step08_projection",
        .summary = "matrices, perspective, and a camera anywhere",
        .takes_model = true,
        .takes_light = true,
        .takes_camera = true,
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
        .state_size = sizeof(struct state),
        .prepare = prepare,
        .finish = finish,
    };
    return program_main(&program, argc, argv);
}
