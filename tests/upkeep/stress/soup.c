/* Random triangles in perspective: see soup.h. */
#include "soup.h"

#include "oracle/shown.h"
#include "pipeline.h"

#include <math.h>
#include <string.h>

static const long double near_w = 1.0L / 128;

/* ---- The camera and the viewport ---- */

static void choose_viewport(struct soup *soup, struct random *random) {
    soup->width = (size_t)random_between(random, 8, 26);
    soup->height = (size_t)random_between(random, 8, 26);
    if (soup->kind >= SOUP_WIDE) {
        soup->width = soup->kind == SOUP_WIDE ? DRAW_LIMIT : 12;
        soup->height = soup->kind == SOUP_HIGH ? DRAW_LIMIT : 12;
    }
    int left = (int)random_between(random, 0, 4), bottom = (int)random_between(random, 0, 4);
    int right = (int)random_between(random, 0, 3), top = (int)random_between(random, 0, 3);
    soup->viewport = (struct rectangle){left, bottom, (int)soup->width - left - right,
                                        (int)soup->height - bottom - top};
}

/* Positions are (x, y, w) of clip space themselves, and z is any linear function of them, in steps
 * of 1/4: exact in doubles. */
static void choose_matrix(struct soup *soup, struct random *random) {
    soup->to_clip = (struct mat4){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 1, 0}}};
    for (int i = 0; i < 4; i++) {
        soup->to_clip.m[2][i] = (double)random_between(random, -8, 8) / 4;
    }
    for (int i = 0; i < 16; i++) {
        soup->exact_to_clip[i / 4][i % 4] = (long double)soup->to_clip.m[i / 4][i % 4];
    }
}

static void choose_camera(struct soup *soup, struct random *random) {
    do {
        soup->eye = random_vec3(random, 4);
        soup->center = random_vec3(random, 4);
        soup->up = random_vec3(random, 2);
    } while (vec3_length(vec3_sub(soup->eye, soup->center)) < 0.5 ||
             oracle_frame(soup->eye, soup->center, soup->up).sine < 0.1L);
    soup->zoom = random_real(random, 0.3, 1.5);
    oracle_camera(soup->eye, soup->center, soup->up, soup->zoom, soup->exact_to_clip);
    soup->to_clip = camera_call(&soup->model, soup->eye, soup->center, soup->up, soup->zoom,
                                soup->viewport, CULL_NONE)
                        .to_clip;
}

/* ---- Corners ---- */

/* Where corners of the largest images lie: inside, just outside, far out, farther still. */
static double far_place(const struct soup *soup, struct random *random) {
    double guard = (double)soup->guard_band, inner = 0.98 * guard, outer = 0.998 * guard;
    const double least[] = {-1, 0.97, -1.1, inner, -outer, 9000, -10000};
    const double most[] = {1, 1.1, -0.97, outer, -inner, 10000, -9000};
    uint64_t choice = random_bits(random) % 12;
    choice = choice < 7 ? choice : 0;
    return random_real(random, least[choice], most[choice]);
}

/* A place in NDC from which, with w, a position is made. */
static struct vec2 ndc_place(const struct soup *soup, struct random *random) {
    double reach = random_bits(random) % 8 == 0 && soup->kind == SOUP_STEEP ? 60 : 2;
    double x = random_real(random, -reach, reach), y = random_real(random, -reach, reach);
    x = soup->kind == SOUP_WIDE ? far_place(soup, random) : x;
    y = soup->kind == SOUP_HIGH ? far_place(soup, random) : y;
    return (struct vec2){x, y};
}

static struct vec3 choose_position(const struct soup *soup, struct random *random) {
    if (soup->kind == SOUP_CAMERA) {
        static const double reaches[] = {2, 6, 6, 60, 300};
        double reach = reaches[random_bits(random) % 5];
        return vec3_add(soup->center, random_vec3(random, reach));
    }
    struct vec2 ndc = ndc_place(soup, random);
    double w = (double)random_between(random, 8, 64) / 16;
    if (soup->kind == SOUP_STEEP) {
        w = ldexp(random_real(random, 1, 2), (int)random_between(random, -6, 9));
    }
    double step = soup->kind == SOUP_WHOLE ? 0x1p-12 : 0x1p-40;
    return (struct vec3){floor(ndc.x * w / step) * step, floor(ndc.y * w / step) * step, w};
}

/* A position in the strip along a side (1 or -1), at most 2 % inside it. */
static struct vec3 moved_beside(const struct soup *soup, struct random *random,
                                struct vec3 position, double side) {
    double place = side * random_real(random, 0.985, 1.03) * position.z;
    struct vec3 wide = {place, position.y, position.z}, high = {position.x, place, position.z};
    return soup->kind == SOUP_WIDE ? wide : high;
}

/* ---- What is seen of a face ---- */

/* A place on a face: x, y, z, w of clip space, and the attribute. */
struct place {
    long double at[5];
};

static struct place place_of(const struct soup *soup, size_t face, size_t corner) {
    const struct vec3 position = model_position(&soup->model, face, corner);
    struct place place;
    for (int row = 0; row < 4; row++) {
        const long double *m = soup->exact_to_clip[row];
        place.at[row] = m[0] * (long double)position.x + m[1] * (long double)position.y +
                        m[2] * (long double)position.z + m[3];
    }
    place.at[4] = (long double)soup->value[3 * face + corner];
    return place;
}

enum { PLANES = 5 };

/* How far inside it is: what w is above the near plane, or the distance to a side of the guard
 * band. */
static long double distance_inside(const struct soup *soup, const struct place *place, int plane) {
    long double w = place->at[3], side = place->at[plane / 2];
    return plane == PLANES - 1 ? w - near_w
                               : soup->guard_band * w + (plane % 2 == 0 ? side : -side);
}

/* Cuts off what of a polygon is outside a plane. False where that is not sure. */
static bool cut(const struct soup *soup, int plane, struct place polygon[SOUP_POLYGON_LIMIT],
                size_t *count) {
    struct place kept[2 * SOUP_POLYGON_LIMIT] = {{{0}}};
    size_t n = 0;
    for (size_t i = 0; i < *count; i++) {
        const struct place *a = &polygon[i], *b = &polygon[(i + 1) % *count];
        long double inside = distance_inside(soup, a, plane);
        long double next_inside = distance_inside(soup, b, plane);
        if (fabsl(inside) < 1e-12L * (fabsl(a->at[3]) + fabsl(a->at[plane / 2]) + near_w)) {
            return false;
        }
        if (inside > 0) {
            kept[n++] = *a;
        }
        if ((inside > 0) != (next_inside > 0)) {
            for (int k = 0; k < 5; k++) {
                kept[n].at[k] =
                    (next_inside * a->at[k] - inside * b->at[k]) / (next_inside - inside);
            }
            n++;
        }
    }
    *count = n;
    memcpy(polygon, kept, (n < SOUP_POLYGON_LIMIT ? n : SOUP_POLYGON_LIMIT) * sizeof *polygon);
    return n <= SOUP_POLYGON_LIMIT;
}

/* Round to 1/256 pixel. False where both neighbours are about as near. */
static bool snap(long double screen, long double size, int32_t *snapped) {
    long double steps = screen * 256 + 0.5L;
    *snapped = (int32_t)floorl(steps);
    long double margin = 1e-6L + 1e-8L * size;
    return steps - floorl(steps) > margin && steps - floorl(steps) < 1 - margin;
}

static bool place_corner(const struct soup *soup, const struct place *place,
                         struct soup_corner *placed) {
    const long double *clip = place->at;
    const struct rectangle *v = &soup->viewport;
    long double x = v->x + (clip[0] / clip[3] + 1) * v->width / 2;
    long double y = v->y + (clip[1] / clip[3] + 1) * v->height / 2;
    placed->z = clip[2];
    placed->w = clip[3];
    placed->value = (double)clip[4];
    return snap(x, v->width, &placed->screen.x) && snap(y, v->height, &placed->screen.y);
}

/* Does it turn only one way? Rounded corners may say otherwise: it depends on how such a polygon is
 * cut into triangles what is covered. */
static bool is_convex(const struct soup_polygon *polygon) {
    bool turns[3] = {false, false, false};
    for (size_t i = 0; i < polygon->count; i++) {
        for (size_t k = i + 1; k < polygon->count; k++) {
            for (size_t j = k + 1; j < polygon->count; j++) {
                const struct soup_corner *c = polygon->corner;
                turns[oracle_turn(c[i].screen, c[k].screen, c[j].screen) + 1] = true;
            }
        }
    }
    return !(turns[0] && turns[2]);
}

/* False where it is not sure what is seen. */
static bool see_face(const struct soup *soup, size_t face, struct soup_polygon *polygon) {
    struct place places[SOUP_POLYGON_LIMIT];
    polygon->count = 3;
    polygon->scale = 1;
    for (size_t i = 0; i < 3; i++) {
        places[i] = place_of(soup, face, i);
    }
    for (int plane = 0; plane < PLANES; plane++) {
        if (!cut(soup, plane, places, &polygon->count)) {
            return false;
        }
    }
    for (size_t i = 0; i < polygon->count; i++) {
        struct soup_corner *placed = &polygon->corner[i];
        if (!place_corner(soup, &places[i], placed)) {
            return false;
        }
        polygon->scale = fmax(polygon->scale, fabs((double)(placed->z / placed->w)));
    }
    return is_convex(polygon);
}

/* ---- Soups ---- */

static void choose_corners(struct soup *soup, struct random *random, size_t face) {
    bool beside = soup->kind >= SOUP_WIDE && random_bits(random) % 2 == 0;
    double side = random_bits(random) % 2 ? 1 : -1;
    for (size_t i = 0; i < 3; i++) {
        struct vec3 position = choose_position(soup, random);
        soup->positions[3 * face + i] =
            beside ? moved_beside(soup, random, position, side) : position;
    }
}

static void make_face(struct soup *soup, struct random *random, size_t face) {
    for (size_t i = 0; i < 3; i++) {
        soup->value[3 * face + i] = random_real(random, 0, 1);
    }
    do {
        choose_corners(soup, random, face);
    } while (!see_face(soup, face, &soup->polygons[face]));
}

static long double guard_band_of(const struct rectangle *viewport) {
    long double larger = viewport->width > viewport->height ? viewport->width : viewport->height;
    return fminl(64, SOUP_REACH / (larger / 2));
}

void soup_make(struct soup *soup, uint64_t seed, enum soup_kind kind) {
    struct random random = {seed};
    *soup = (struct soup){.kind = kind};
    soup->model = plain_model(soup->positions, SOUP_CORNERS, soup->faces, SOUP_FACES, NULL);
    choose_viewport(soup, &random);
    soup->guard_band = guard_band_of(&soup->viewport);
    if (kind == SOUP_CAMERA) {
        choose_camera(soup, &random);
    } else {
        choose_matrix(soup, &random);
    }
    for (size_t i = 0; i < SOUP_FACES; i++) {
        make_face(soup, &random, i);
    }
}

/* ---- What is seen at a pixel ---- */

static void widen(struct range *range, long double value) {
    range->least = fminl(range->least, value);
    range->most = fmaxl(range->most, value);
}

/* The depth of a whole triangle of SOUP_WHOLE: there z is a multiple of 2^-14, and w of 2^-4. */
static long double exact_depth(const struct soup_corner *corner, int x, int y) {
    struct fixed2 screen[3];
    int64_t z[3], w[3];
    for (int i = 0; i < 3; i++) {
        screen[i] = corner[i].screen;
        z[i] = (int64_t)(corner[i].z * 0x1p14L);
        w[i] = (int64_t)(corner[i].w * 0x1p4L);
    }
    return oracle_perspective_depth(screen, z, w, x, y) / 0x1p10L;
}

/* The triangle of three of the polygon's corners. */
static void look_at_triangle(const struct soup_corner *const corner[3], int x, int y,
                             struct soup_hit *hit) {
    static const double parallel[3] = {1, 1, 1};
    struct fixed2 screen[3];
    double depth[3], recip_w[3], value[3];
    for (int i = 0; i < 3; i++) {
        screen[i] = corner[i]->screen;
        depth[i] = (double)(corner[i]->z / corner[i]->w);
        recip_w[i] = (double)(1 / corner[i]->w);
        value[i] = corner[i]->value;
    }
    if (oracle_covers(screen[0], screen[1], screen[2], x, y)) {
        hit->covered = true;
        widen(&hit->depth, oracle_interpolate(screen, parallel, depth, x, y));
        widen(&hit->value, oracle_interpolate(screen, recip_w, value, x, y));
        hit->value_terms =
            fmax(hit->value_terms, (double)oracle_rounding_scale(screen, recip_w, value, x, y));
    }
}

struct soup_hit soup_look(const struct soup *soup, size_t face, int x, int y) {
    const struct soup_polygon *polygon = &soup->polygons[face];
    const struct soup_corner *c = polygon->corner;
    const struct range nothing = {(long double)INFINITY, (long double)-INFINITY};
    struct soup_hit hit = {false, nothing, nothing, 0};
    for (size_t i = 0; i < polygon->count; i++) {
        for (size_t k = i + 1; k < polygon->count; k++) {
            for (size_t j = k + 1; j < polygon->count; j++) {
                look_at_triangle((const struct soup_corner *[3]){&c[i], &c[k], &c[j]}, x, y, &hit);
            }
        }
    }
    if (hit.covered && soup->kind == SOUP_WHOLE) {
        long double depth = exact_depth(c, x, y);
        hit.depth = (struct range){depth, depth};
    }
    return hit;
}

struct soup_seen soup_see(const struct soup *soup, int x, int y) {
    struct soup_seen seen = {.nearest = (long double)-INFINITY};
    const struct rectangle *v = &soup->viewport;
    if (x < v->x || x >= v->x + v->width || y < v->y || y >= v->y + v->height) {
        return seen;
    }
    for (size_t i = 0; i < soup->model.face_count; i++) {
        seen.hit[i] = soup_look(soup, i, x, y);
        if (seen.hit[i].covered) {
            seen.nearest = fmaxl(seen.nearest, seen.hit[i].depth.least);
        }
    }
    return seen;
}

/* Doubles lose this much, floats thousands of times as much. */
static double depth_tolerance(const struct soup *soup, size_t face) {
    return soup->polygons[face].scale * (soup->kind == SOUP_WHOLE ? 0x1p-48 : 0x1p-40);
}

/* Values are interpolated in `real`: some roundings of what is added up; and where a face was cut,
 * what rounding its corners costs. */
static double value_tolerance(const struct soup *soup, const struct soup_hit *hit) {
    double ulp = sizeof(real) == sizeof(float) ? 0x1p-24 : 0x1p-53;
    return 3 * ulp * hit->value_terms + (soup->kind <= SOUP_STEEP ? 0 : 0x1p-38);
}

bool soup_may_show(const struct soup *soup, const struct soup_seen *seen, size_t face) {
    const struct soup_hit *hit = &seen->hit[face];
    return hit->covered && hit->depth.most + depth_tolerance(soup, face) >= seen->nearest;
}

unsigned soup_candidates(const struct soup *soup, const struct soup_seen *seen) {
    unsigned candidates = 0;
    for (size_t i = 0; i < soup->model.face_count; i++) {
        candidates += soup_may_show(soup, seen, i);
    }
    return candidates;
}

/* How far a value lies outside a range; infinitely far where it is no number. */
static double distance_outside(double value, struct range range) {
    long double v = (long double)value;
    return isnan(value) ? (double)INFINITY
                        : (double)fmaxl(0, fmaxl(range.least - v, v - range.most));
}

bool soup_face_is_right(const struct soup *soup, int x, int y, int face, double depth,
                        struct tally *tally) {
    struct soup_seen seen = soup_see(soup, x, y);
    unsigned candidates = soup_candidates(soup, &seen);
    if (face < 0) {
        tally->asked++;
        return candidates == 0 && depth == (double)-INFINITY;
    }
    tally->asked += candidates <= 1;
    tally->left_out += candidates > 1;
    double error = distance_outside(depth, seen.hit[face].depth);
    tally->error = fmax(tally->error, error / soup->polygons[face].scale * 0x1p52);
    return soup_may_show(soup, &seen, (size_t)face) && error <= depth_tolerance(soup, (size_t)face);
}

bool soup_value_is_right(const struct soup *soup, int x, int y, int face, double value,
                         struct tally *tally) {
    struct soup_hit hit = soup_look(soup, (size_t)face, x, y);
    double error = distance_outside(value, hit.value);
    tally->asked++;
    tally->error = fmax(tally->error, error * 1024 * 256);
    return hit.covered && error <= value_tolerance(soup, &hit);
}
