/*
 * Clip: a face that crosses the near plane or leaves the guard band is cut at one plane after the
 * other, as section 8e of lesson 8 teaches. (Sutherland and Hodgman, "Reentrant Polygon Clipping",
 * 1974.) What is left is a convex polygon, drawn as a fan of triangles around its corner 0:
 *
 *            3----------2       triangle 1: corners 0, 1, 2
 *          / |        .'|       triangle 2: corners 0, 2, 3
 *        4   |     .'   |       triangle 3: corners 0, 3, 4
 *         \  |  .'      |
 *          \ |.'        |
 *            0----------1
 *
 * Two faces that share an edge cut it at the very same point, so that no gap opens between them;
 * and a face gives the same polygon whichever corner the model lists first.
 */
#include "pipeline.h"

static const double near_w = NEAR_W;

enum { CLIP_PLANES = 5 };

/* The signed distance of a position from a plane, positive inside. */
static double plane_distance(struct vec4 p, int plane, double guard_band) {
    if (plane == 0) {
        return p.w - near_w;
    }
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
}

static double mix(double from, double to, double t) {
    return from + t * (to - from);
}

/* The point where an edge crosses the plane. It is always computed from the corner inside to the
 * one outside, so that both faces of the edge find the very same point. */
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

/* The part of a polygon on the inner side of a plane. */
static struct polygon clip_at_plane(const struct polygon *polygon, int plane, double guard_band) {
    struct polygon result = {.count = 0};
    for (size_t i = 0; i < polygon->count; i++) {
        const struct clip_corner *a = &polygon->corner[i];
        const struct clip_corner *b = &polygon->corner[(i + 1) % polygon->count];
        double a_distance = plane_distance(a->clip, plane, guard_band);
        double b_distance = plane_distance(b->clip, plane, guard_band);
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

/* Is position a before b, in an order that does not depend on the model's? */
static bool is_before(struct vec4 a, struct vec4 b) {
    return a.y < b.y ||
           (a.y == b.y && (a.x < b.x || (a.x == b.x && (a.z < b.z || (a.z == b.z && a.w < b.w)))));
}

/* The part of a face that can be drawn. Clipping starts at the corner that comes first in the order
 * of is_before(); the weights belong to the corners as the model lists them. */
struct polygon pipeline_clip_face(const struct recorded_call *recorded, size_t face) {
    const struct draw_call *call = &recorded->call;
    static const struct vec3 weight[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct vec4 clip[3];
    size_t first = 0;
    for (size_t i = 0; i < 3; i++) {
        clip[i] = mat4_point(&call->to_clip, model_position(call->model, face, i));
        first = i > 0 && is_before(clip[i], clip[first]) ? i : first;
    }
    struct polygon polygon = {.count = 3};
    for (size_t i = 0; i < 3; i++) {
        size_t from = (first + i) % 3;
        polygon.corner[i] = (struct clip_corner){clip[from], weight[from]};
    }
    for (int plane = 0; plane < CLIP_PLANES && polygon.count > 0; plane++) {
        polygon = clip_at_plane(&polygon, plane, recorded->guard_band);
    }
    return polygon;
}
