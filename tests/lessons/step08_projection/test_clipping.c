/* Lesson 8's clipping against its definition in long double. The pipeline has the same text (see
 * same_text.sh). make stress tries find_beyond(), and whole faces. */
#define LESSON "../step08_projection/main.c"
#include "lesson.h"

#include "oracle/oracle.h"
#include "unit/unit.h"

static struct random random_state = {81};

static double random_unit(void) { /* -1..1 */
    return random_real(&random_state, -1, 1);
}

/* Of any size between 2^-reach and 2^reach. */
static double random_sized(int reach) {
    return ldexp(random_unit(), (int)random_between(&random_state, -reach, reach));
}

static struct clip_corner random_corner(int reach, struct vec3 weight) {
    return (struct clip_corner){
        {random_sized(reach), random_sized(reach), random_sized(reach), random_sized(reach)},
        weight};
}

static struct polygon random_triangle(int reach) {
    return (struct polygon){{random_corner(reach, (struct vec3){1, 0, 0}),
                             random_corner(reach, (struct vec3){0, 1, 0}),
                             random_corner(reach, (struct vec3){0, 0, 1})},
                            3};
}

/* ---- The cut of one edge ---- */

static long double exact_mix(double from, double to, long double t) {
    return (long double)from + t * ((long double)to - (long double)from);
}

/* Not farther from the exact number than a few roundings of what is added up. */
static bool is_mixed(double got, double from, double to, long double t) {
    long double added =
        fabsl((long double)from) + fabsl(exact_mix(from, to, t) - (long double)from);
    return fabsl((long double)got - exact_mix(from, to, t)) <= 6 * 0x1p-53L * added;
}

/* Accurate where the corner outside is 2^40 times as far as the one inside. */
static void test_cut_is_accurate(void) {
    for (int i = 0; i < 5000; i++) {
        int reach = i % 41;
        struct clip_corner p = random_corner(1, (struct vec3){1, 0, 0});
        struct clip_corner q = random_corner(reach, (struct vec3){0, 1, 0});
        double inside = fabs(random_sized(2)), outside = -fabs(random_sized(reach)) - 1e-9;
        struct clip_corner cut = cut_edge(&p, &q, inside, outside);
        long double t = (long double)inside / ((long double)inside - (long double)outside);
        CHECK(is_mixed(cut.clip.x, p.clip.x, q.clip.x, t));
        CHECK(is_mixed(cut.clip.y, p.clip.y, q.clip.y, t));
        CHECK(is_mixed(cut.clip.z, p.clip.z, q.clip.z, t));
        CHECK(is_mixed(cut.clip.w, p.clip.w, q.clip.w, t));
        CHECK(is_mixed(cut.weight.x, 1, 0, t) && is_mixed(cut.weight.y, 0, 1, t));
        CHECK(cut.weight.z == 0);
    }
}

static bool same_clip(struct vec4 a, struct vec4 b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}

static bool has_corner(const struct polygon *polygon, struct vec4 clip) {
    for (size_t i = 0; i < polygon->count; i++) {
        if (same_clip(polygon->corner[i].clip, clip)) {
            return true;
        }
    }
    return false;
}

/* Both faces of an edge, which go along it in opposite directions, cut it at the same point, to the
 * last bit; of the corners those inside stay. */
static void test_cut_from_both_ends(void) {
    int cuts = 0;
    for (int i = 0; i < 5000; i++) {
        int plane = i % CLIP_PLANES;
        struct polygon forwards = random_triangle(4), backwards = random_triangle(4);
        struct vec4 a = forwards.corner[0].clip, b = forwards.corner[1].clip;
        backwards.corner[0].clip = b;
        backwards.corner[1].clip = a;
        struct polygon one = clip_at_plane(&forwards, plane);
        struct polygon other = clip_at_plane(&backwards, plane);
        bool a_inside = plane_distance(a, plane) >= 0, b_inside = plane_distance(b, plane) >= 0;
        CHECK(has_corner(&one, a) == a_inside && has_corner(&other, b) == b_inside);
        if (a_inside != b_inside) { /* the cut comes after a or before b, and the other way round */
            size_t at = a_inside ? 1 : 0, other_at = a_inside ? 0 : 1;
            CHECK(same_clip(one.corner[at].clip, other.corner[other_at].clip));
            cuts++;
        }
    }
    CHECK(cuts > 1000);
}

/* A corner on the plane is inside: nothing is cut. */
static void test_corner_on_plane(void) {
    for (int plane = 0; plane < CLIP_PLANES; plane++) {
        static const struct vec4 on_plane[CLIP_PLANES] = {
            {0, 0, 0, 1.0 / 128}, {-64, 0, 0, 1}, {64, 0, 0, 1}, {0, -64, 0, 1}, {0, 64, 0, 1}};
        struct polygon triangle = {{{on_plane[plane], {1, 0, 0}},
                                    {{0.5, 0.25, 0, 1}, {0, 1, 0}},
                                    {{0.25, 0.5, 0, 1}, {0, 0, 1}}},
                                   3};
        struct polygon same = clip_at_plane(&triangle, plane);
        CHECK(same.count == 3);
        for (size_t i = 0; i < 3; i++) {
            CHECK(same_clip(same.corner[i].clip, triangle.corner[i].clip));
        }
        /* Before one that is outside it stays, too. */
        triangle.corner[1].clip.w = -1;
        struct polygon rest = clip_at_plane(&triangle, plane);
        CHECK(has_corner(&rest, on_plane[plane]));
    }
}

UNIT_MAIN(TEST(test_cut_is_accurate), TEST(test_cut_from_both_ends), TEST(test_corner_on_plane))
