/*
 * Lesson 8: matrices, perspective and the camera.
 *
 * A point goes through a chain of matrices, from the model to the screen:
 *
 *     world  = to_world * point                 the model's place and size
 *     clip   = projection * lookat * world      the camera; w says how far away the point is
 *     ndc    = clip / w                         -1..1 over the picture
 *     screen = viewport * ndc                   pixels
 *
 * A point behind the camera has no place on the screen, so triangles are cut before the division.
 */
#include "program.h"
#include "texture.h"

#include <math.h>

/* ---- The viewport ---- */

/* NDC (-1..1) to a picture of width x height pixels whose lower left corner is at (0,0). */
static struct mat4 viewport(size_t width, size_t height) {
    /* BEGIN SOLUTION 8a.1 viewport */
    double half_width = (double)width / 2, half_height = (double)height / 2;
    return (struct mat4){{{half_width, 0, 0, half_width},
                          {0, half_height, 0, half_height},
                          {0, 0, 1, 0},
                          {0, 0, 0, 1}}};
    /* STARTER
    (void)width, (void)height; // to do 8a.1: the matrix
    return mat4_identity();
    END SOLUTION */
}

/* ---- Maps of the plane: scene transforms ---- */

/* Where a map takes a point of the plane z = 0. In the scenes the map ends at pixels. */
static struct vec2 to_pixels(const struct mat4 *map, struct vec2 p) {
    /* BEGIN SOLUTION 8a.2 point through a map */
    struct vec4 q = mat4_point(map, (struct vec3){p.x, p.y, 0});
    return (struct vec2){q.x / q.w, q.y / q.w};
    /* STARTER
    (void)map, (void)p; // to do 8a.2: apply the map to (x, y, 0, 1) and divide by w
    return (struct vec2){0, 0};
    END SOLUTION */
}

static const struct vec3 pivot = {1, 0.8, 0}; /* the house of `turn_about` turns about it */

/* BEGIN SOLUTION 8a.3 maps of the plane */
/* Moves x by y * amount; y stays. */
static struct mat4 shear(double amount) {
    struct mat4 shear = mat4_identity();
    shear.m[0][1] = amount;
    return shear;
}

/* About the origin, counterclockwise. */
static struct mat4 rotate(double turns) {
    return mat4_rotation((struct vec3){0, 0, 1}, turns);
}

/* About another point: move it to the origin, rotate, move back. */
static struct mat4 rotate_about(struct vec3 point, double turns) {
    struct mat4 there = mat4_translation(vec3_scale(point, -1)), back = mat4_translation(point);
    return mat4_mul(back, mat4_mul(rotate(turns), there));
}
/* END SOLUTION */

/* The map of panel 0..8, row by row from the top left. Each panel is also a scene. S
 * scales x by 1.5 and y by 0.5; R turns by 0.125 of a whole turn about the axis (0,0,1),
 * counterclockwise; M moves by (-0.8, -1.3). */
static struct mat4 panel_map(int panel) {
    /* BEGIN SOLUTION 8a.3 maps of the plane */
    const struct mat4 scale = mat4_scaling((struct vec3){1.5, 0.5, 1}), turn = rotate(0.125);
    const struct mat4 move = mat4_translation((struct vec3){-0.8, -1.3, 0});
    struct mat4 perspective = mat4_identity();
    perspective.m[3][0] = 0.5; /* w = 1 + x/2: not linear, a first look at perspective */
    const struct mat4 maps[] = {
        scale,
        shear(0.6),
        turn,
        mat4_mul(turn, scale), /* scaled first */
        mat4_mul(scale, turn), /* rotated first */
        rotate_about(pivot, 0.125),
        mat4_mul(turn, move), /* moved first */
        mat4_mul(move, turn), /* rotated first */
        perspective,
    };
    return maps[panel];
    /* STARTER
    const struct mat4 maps[] = {
        // to do 8a.3: the map of each panel
        mat4_identity(), // scale: S
        mat4_identity(), // shear: x becomes x + 0.6 y
        mat4_identity(), // turn: R
        mat4_identity(), // scale_turn: S first, then R
        mat4_identity(), // turn_scale: R first, then S
        mat4_identity(), // turn_about: R, but about the point `pivot`
        mat4_identity(), // move_turn: M first, then R
        mat4_identity(), // turn_move: R first, then M
        mat4_identity(), // divided: the identity with the last row (0.5, 0, 0, 1)
    };
    return maps[panel];
    END SOLUTION */
}

/* ---- From clip space to the screen ---- */

/* A corner of a triangle on the screen. */
struct vertex {
    struct fixed2 position; /* on the screen */
    double depth;           /* z/w, linear on the screen; larger is nearer */
    double recip_w;         /* 1/w */
    double intensity;       /* 0..1 */
    struct vec2 uv;
};

/* The division by w: sets recip_w, depth and, by `to_screen` from NDC, position. False when the
 * point has no place on the screen, because its coordinates are too large to compute with. */
static bool place(struct vec4 clip, const struct mat4 *to_screen, struct vertex *vertex) {
    /* BEGIN SOLUTION 8b.1 division by w */
    vertex->recip_w = 1 / clip.w;
    vertex->depth = clip.z * vertex->recip_w;
    struct vec3 ndc = {clip.x * vertex->recip_w, clip.y * vertex->recip_w, 0};
    struct vec4 screen = mat4_point(to_screen, ndc);
    return isfinite(vertex->depth) &&
           screen_snap((struct vec2){screen.x, screen.y}, &vertex->position);
    /* STARTER
    (void)clip, (void)to_screen, (void)vertex;
    return false; // to do 8b.1: true when depth is finite and screen_snap() has found the position
    END SOLUTION */
}

/* ---- Perspective ---- */

/* A camera at (0, 0, distance) that looks along -z. It makes w, how far away a point is along the
 * direction of view, counted in distances. An infinite one gives the parallel view, with w = 1. */
static struct mat4 projection(double distance) {
    /* BEGIN SOLUTION 8b.2 perspective */
    struct mat4 projection = mat4_identity();
    projection.m[3][2] = -1 / distance;
    return projection;
    /* STARTER
    (void)distance; // to do 8b.2: the matrix that makes w
    return mat4_identity();
    END SOLUTION */
}

/* ---- Perspective inside a triangle ---- */

/* The weights of the corners in the plane of the triangle, from the weights on the screen: a far
 * corner counts for less (Blinn, "Hyperbolic Interpolation", 1992). */
static struct vec3 correct_weights(struct vec3 screen, const double recip_w[3]) {
    /* BEGIN SOLUTION 8c.1 correct weights */
    double a = screen.x * recip_w[0], b = screen.y * recip_w[1], c = screen.z * recip_w[2];
    double scale = 1 / (a + b + c);
    return (struct vec3){a * scale, b * scale, c * scale};
    /* STARTER
    (void)recip_w; // to do 8c.1: the weights in the plane of the triangle
    return screen;
    END SOLUTION */
}

/* Where to draw, and what a model goes through on its way there. */
struct canvas {
    struct image *image;
    double *depth;                 /* of each pixel, row by row from the bottom */
    struct rectangle area;         /* of the image: nothing is drawn outside */
    struct mat4 to_clip;           /* from the model */
    struct mat4 to_screen;         /* from NDC to the area */
    struct mat4 normals_to_world;  /* from the model */
    struct vec3 light;             /* to the light, in the world; of length 1 */
    const struct texture *texture; /* the colour of the surface */
    bool affine; /* the weights on the screen will do: w is 1, or faces have one colour */
};

/* The texture's colour times the intensity. */
static struct color shade(const struct texture *texture, struct vec2 uv, double intensity) {
    struct vec4 c = texture_bilinear(texture, uv, 0);
    return color_rgb(level_from(c.x * intensity), level_from(c.y * intensity),
                     level_from(c.z * intensity));
}

/* The triangles of lessons 6 and 7 in one. The depth is interpolated with the weights on the
 * screen, everything else with the correct weights. */
static void triangle(const struct canvas *canvas, const struct edges *edges,
                     const struct vertex v[3]) {
    const double recip_w[3] = {v[0].recip_w, v[1].recip_w, v[2].recip_w};
    const struct rectangle area = canvas->area;
    const struct span columns = {area.x, area.x + area.width};
    const struct span rows = span_overlap((struct span){edges->y_begin, edges->y_end},
                                          (struct span){area.y, area.y + area.height});
    for (int y = rows.begin; y < rows.end; y++) {
        struct span span = span_overlap(edges_span(edges, y), columns);
        double *row = canvas->depth + (size_t)y * canvas->image->width;
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(edges, x, y);
            double depth = interpolate_depth(weight, v[0].depth, v[1].depth, v[2].depth);
            if (depth > row[x]) {
                struct vec3 w = canvas->affine ? weight : correct_weights(weight, recip_w);
                double intensity = interpolate(w, v[0].intensity, v[1].intensity, v[2].intensity);
                struct vec2 uv = vec2_interpolate(w, v[0].uv, v[1].uv, v[2].uv);
                row[x] = depth;
                image_set(canvas->image, x, y, shade(canvas->texture, uv, intensity));
            }
        }
    }
}

/* ---- Normals of a model that is scaled ---- */

/* The matrix for normals where to_world is the matrix for points: the inverse transpose keeps them
 * perpendicular to the surface. A map without an inverse leaves normals as they are. */
static struct mat4 normals_to_world(struct mat4 to_world) {
    /* BEGIN SOLUTION 8c.2 normals */
    struct mat4 inverse = mat4_identity();
    mat4_inverse(to_world, &inverse);
    return mat4_transpose(inverse);
    /* STARTER
    return to_world; // to do 8c.2: the inverse transpose
    END SOLUTION */
}

/* ---- The camera ---- */

/* The world as the camera sees it: `center` becomes the origin, the direction from there to `eye`
 * becomes z, and `up` appears upwards. The rows are the camera's own axes x, y, z. */
static struct mat4 lookat(struct vec3 eye, struct vec3 center, struct vec3 up) {
    /* BEGIN SOLUTION 8d.1 camera anywhere */
    struct vec3 z = vec3_renormalized(vec3_normalized(vec3_half_difference(eye, center)));
    if (vec3_dot(z, z) == 0) {
        z = (struct vec3){0, 0, 1};
    }
    struct vec3 x = vec3_cross(vec3_normalized(up), z);
    if (vec3_dot(x, x) < 1e-20) { /* up is parallel to the view direction, as near as it matters */
        x = vec3_cross(vec3_perpendicular_axis(z), z);
    }
    x = vec3_normalized(x);
    /* A short cross product has lost digits: make x perpendicular to z once more. */
    x = vec3_renormalized(vec3_sub(x, vec3_scale(z, vec3_dot(x, z))));
    struct vec3 y = vec3_renormalized(vec3_cross(z, x));
    return (struct mat4){{{x.x, x.y, x.z, -vec3_dot(x, center)},
                          {y.x, y.y, y.z, -vec3_dot(y, center)},
                          {z.x, z.y, z.z, -vec3_dot(z, center)},
                          {0, 0, 0, 1}}};
    /* STARTER
    (void)eye, (void)center, (void)up; // to do 8d.1: the three axes, then the matrix
    return mat4_identity();
    END SOLUTION */
}

/* ---- Clipping: only what is in front of the camera can be divided by w ---- */

/* The near plane: nothing nearer is drawn, or 1/w would grow without bound. */
static const double near_w = 1.0 / 128;

/* Faces are cut where they leave NDC -64..64. That is far outside the image, so few are cut, but
 * within SCREEN_LIMIT for the largest image. */
static const double guard_band = 64;

/* A convex polygon gains at most one corner at each plane. Where coordinates differ by many orders
 * of magnitude, rounding can dent the polygon, and n corners become up to n + n/2 at each of the
 * five planes: 3, 4, 6, 9, 13, 19. */
enum { CLIP_PLANES = 5, POLYGON_LIMIT = 19 };

/* A corner of a polygon while it is clipped. */
struct clip_corner {
    struct vec4 clip;
    struct vec3 weight; /* where it is between the corners of the face; sum 1 */
};

struct polygon {
    struct clip_corner corner[POLYGON_LIMIT];
    size_t count;
};

/* The signed distance of a position from plane 0..4, 0 on it and positive inside. */
static double plane_distance(struct vec4 p, int plane) {
    /* BEGIN SOLUTION 8e.1 near plane */
    if (plane == 0) {
        return p.w - near_w;
    }
    /* STARTER
    // to do 8e.1: the distance from the near plane, which is plane 0
    END SOLUTION */
    /* BEGIN SOLUTION 8e.2 guard band */
    switch (plane) {
    case 1:
        return guard_band * p.w + p.x;
    case 2:
        return guard_band * p.w - p.x;
    case 3:
        return guard_band * p.w + p.y;
    default:
        return guard_band * p.w - p.y;
    }
    /* STARTER
    (void)p, (void)plane;
    return 1; // to do 8e.2: the distances from planes 1 to 4; until then all is inside
    END SOLUTION */
}

/* BEGIN SOLUTION 8e.1 near plane */
static double mix(double from, double to, double t) {
    return from + t * (to - from);
}

/* Where an edge crosses the plane. Always computed from the inner corner to the outer one, so that
 * both faces at an edge find the very same point, and no gap opens between them. */
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
/* END SOLUTION */

/* What plane 0..4 leaves of a polygon (Sutherland and Hodgman, "Reentrant Polygon Clipping",
 * 1974). */
static struct polygon clip_at_plane(const struct polygon *polygon, int plane) {
    struct polygon result = {.count = 0};
    /* BEGIN SOLUTION 8e.1 near plane */
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
    /* STARTER
    (void)polygon, (void)plane, (void)plane_distance;
    // to do 8e.1: keep the corners inside, cut the edges that cross
    END SOLUTION */
    return result;
}

/* The sides of the view. A face with all corners beyond one of the first five is not drawn; a face
 * with a corner beyond one of the last two is clipped. */
enum {
    BEYOND_LEFT = 1,
    BEYOND_RIGHT = 2,
    BEYOND_BOTTOM = 4,
    BEYOND_TOP = 8,
    BEYOND_NEAR = 16,
    BEYOND_GUARD_BAND = 32
};

/* The sides that a position is beyond. A position that is not a number is beyond all of them. */
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

/* ---- A face on its way to the screen ---- */

/* A corner of a face, as the model has it. */
struct face_corner {
    struct vec3 position, normal;
    struct vec2 uv;
};

/* The corners of a face in clip space. */
static struct polygon transform_face(const struct canvas *canvas,
                                     const struct face_corner face[3]) {
    const struct vec4 a = mat4_point(&canvas->to_clip, face[0].position);
    const struct vec4 b = mat4_point(&canvas->to_clip, face[1].position);
    const struct vec4 c = mat4_point(&canvas->to_clip, face[2].position);
    return (struct polygon){.corner = {{a, {1, 0, 0}}, {b, {0, 1, 0}}, {c, {0, 0, 1}}}, .count = 3};
}

/* Keep what the camera may see of a face: nothing if all of it is beyond one side of the view. */
static void clip_face(struct polygon *face) {
    const unsigned a = find_beyond(face->corner[0].clip), b = find_beyond(face->corner[1].clip);
    const unsigned c = find_beyond(face->corner[2].clip);
    const bool crosses = ((a | b | c) & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0;
    if ((a & b & c & ~(unsigned)BEYOND_GUARD_BAND) != 0) {
        face->count = 0;
    }
    for (int plane = 0; crosses && plane < CLIP_PLANES && face->count > 0; plane++) {
        *face = clip_at_plane(face, plane);
    }
}

/* The intensity of lesson 7, with the normal taken to the world. */
static double light_on(const struct canvas *canvas, struct vec3 model_normal) {
    struct vec3 normal = vec3_normalized(mat4_direction(&canvas->normals_to_world, model_normal));
    double cosine = vec3_dot(normal, canvas->light);
    return cosine > 0 ? cosine : 0;
}

/* Draw what clipping left of a face, as a fan of triangles around its first corner; nothing if a
 * corner has no place on the screen. A triangle whose corners run clockwise there shows its inside:
 * a closed body always has something else in front of it. */
static void draw_polygon(const struct canvas *canvas, const struct face_corner face[3],
                         const struct polygon *left) {
    const size_t count = left->count;
    struct vertex v[POLYGON_LIMIT];
    const double light[3] = {light_on(canvas, face[0].normal), light_on(canvas, face[1].normal),
                             light_on(canvas, face[2].normal)};
    for (size_t i = 0; i < count; i++) {
        const struct vec3 weight = left->corner[i].weight;
        if (!place(left->corner[i].clip, &canvas->to_screen, &v[i])) {
            return;
        }
        v[i].intensity = interpolate(weight, light[0], light[1], light[2]);
        v[i].uv = vec2_interpolate(weight, face[0].uv, face[1].uv, face[2].uv);
    }
    for (size_t i = 2; i < count; i++) {
        const struct vertex corners[3] = {v[0], v[i - 1], v[i]};
        struct edges edges;
        if (edges_setup(&edges, v[0].position, v[i - 1].position, v[i].position,
                        canvas->image->width, canvas->image->height) &&
            !edges.clockwise) {
            triangle(canvas, &edges, corners);
        }
    }
}

static void draw_face(const struct canvas *canvas, const struct face_corner face[3]) {
    struct polygon polygon = transform_face(canvas, face);
    clip_face(&polygon);
    if (polygon.count >= 3) {
        draw_polygon(canvas, face, &polygon);
    }
}

/* ---- A model ---- */

static void fetch_face(const struct model *model, size_t face, struct face_corner corner[3]) {
    for (size_t i = 0; i < 3; i++) {
        corner[i] = (struct face_corner){model_position(model, face, i),
                                         model_normal(model, face, i), model_uv(model, face, i)};
    }
}

/* Draw all faces; as facets, each has the colour of its middle. */
static void draw_model(struct drawing *drawing, struct canvas *canvas, bool facets) {
    for (size_t i = 0; drawing_take_part(drawing, i); i++) {
        const struct model *model = drawing->model;
        canvas->texture = drawing->diffuse;
        for (size_t face = 0; face < model->face_count; face++) {
            struct face_corner c[3];
            fetch_face(model, face, c);
            if (facets) {
                const struct vec3 third = {1.0 / 3, 1.0 / 3, 1.0 / 3};
                c[0].normal = c[1].normal = c[2].normal = model_face_normal(model, face);
                c[0].uv = c[1].uv = c[2].uv = vec2_interpolate(third, c[0].uv, c[1].uv, c[2].uv);
            }
            draw_face(canvas, c);
        }
    }
}

#include "scenes.h"

int main(int argc, char **argv) {
    return program_main(&step08_projection, argc, argv);
}
