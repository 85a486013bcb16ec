/* Lesson 8's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step08_projection/main.c"
#endif
#include "numbers.h"

/* ---- Matrices: what they make of a point, or of a direction ---- */

/* Where a matrix takes a point of the plane. */
static struct vec2 called_in_plane(struct mat4 matrix, double x, double y) {
    struct vec4 p = mat4_point(&matrix, xyz(x, y, 0));
    return xy(p.x / p.w, p.y / p.w);
}

static struct vec3 called_in_space(struct mat4 matrix, struct vec3 p) {
    struct vec4 q = mat4_point(&matrix, p);
    return xyz(q.x / q.w, q.y / q.w, q.z / q.w);
}

static struct vec4 called_in_clip_space(struct mat4 matrix, struct vec3 p) {
    return mat4_point(&matrix, p);
}

/* The largest coordinate made 1: the length of a normal may be any. */
static struct vec3 called_as_normal(struct mat4 matrix, struct vec3 normal) {
    struct vec3 n = mat4_direction(&matrix, normal);
    return vec3_scale(n, 1 / fmax(fabs(n.x), fmax(fabs(n.y), fabs(n.z))));
}

static struct vec3 called_weighted(struct vec3 screen, struct vec3 recip_w) {
    const double three[3] = {recip_w.x, recip_w.y, recip_w.z};
    return correct_weights(screen, three);
}

/* Maps that the texts of calls name. */
static struct mat4 called_move(double x, double y, double z) {
    return mat4_translation(xyz(x, y, z));
}

static struct mat4 called_scale(double x, double y, double z) {
    return mat4_scaling(xyz(x, y, z));
}

/* x becomes x + amount * y. */
static struct mat4 called_lean(double amount) {
    struct mat4 map = mat4_identity();
    map.m[0][1] = amount;
    return map;
}

/* w becomes 1 + amount * x. */
static struct mat4 called_away(double amount) {
    struct mat4 map = mat4_identity();
    map.m[3][0] = amount;
    return map;
}

/* How many of the nine maps leave z as it is? */
static int called_heights_kept(void) {
    int kept = 0;
    for (int panel = 0; panel < 9; panel++) {
        kept += fabs(called_in_space(panel_map(panel), xyz(0, 0, 1)).z - 1) < 1e-9;
    }
    return kept;
}

#define VIEWPORT(width, height, x, y, right)                                                       \
    AS_VECTOR("8a.1", "viewport(" #width ", " #height ") * (" #x ", " #y ")", vec2,                \
              called_in_plane(viewport(width, height), x, y), right)
#define PANEL(panel, x, y, right)                                                                  \
    AS_VECTOR("8a.3", "panel_map(" #panel ") * (" #x ", " #y ")", vec2,                            \
              called_in_plane(panel_map(panel), x, y), right)
#define PIXELS(map, p, right)                                                                      \
    do {                                                                                           \
        const struct mat4 matrix = map;                                                            \
        AS_VECTOR("8a.2", "to_pixels(" #map ", " #p ")", vec2, to_pixels(&matrix, xy p), right);   \
    } while (0)
#define PROJECTION(distance, p, right)                                                             \
    AS_VECTOR("8b.2", "projection(" #distance ") * " #p, vec4,                                     \
              called_in_clip_space(projection(distance), xyz p), right)
#define WEIGHTED(screen, recip_w, right)                                                           \
    AS_VECTOR("8c.1", "correct_weights(" #screen ", " #recip_w ")", vec3,                          \
              called_weighted(xyz screen, xyz recip_w), right)
#define NORMAL(map, normal, right)                                                                 \
    AS_VECTOR("8c.2", "normals_to_world(" #map ") * " #normal, vec3,                               \
              called_as_normal(normals_to_world(map), xyz normal), right)
#define SEEN(eye, center, up, p, right)                                                            \
    AS_VECTOR("8d.1", "lookat(" #eye ", " #center ", " #up ") * " #p, vec3,                        \
              called_in_space(lookat(xyz eye, xyz center, xyz up), xyz p), right)

/* ---- 8b.1 ---- */

/* A screen of 100 x 100 pixels. */
static const struct mat4 called_screen = {
    {{50, 0, 0, 50}, {0, 50, 0, 50}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

static struct shown called_vertex(bool placed, struct vertex v) {
    return placed ? show("position (%g, %g), depth %g, recip_w %g", v.position.x / 256.0,
                         v.position.y / 256.0, v.depth, v.recip_w)
                  : show("false");
}

static struct shown called_placed(struct vec4 clip) {
    struct vertex v = {.position = {0, 0}};
    bool placed = place(clip, &called_screen, &v);
    return called_vertex(placed, v);
}

/* What place() must give if it calls the student's to_pixels(). */
static struct shown called_placed_by_hers(struct vec4 clip) {
    struct vertex v = {.depth = clip.z / clip.w, .recip_w = 1 / clip.w};
    struct vec2 screen = to_pixels(&called_screen, xy(clip.x / clip.w, clip.y / clip.w));
    bool placed = isfinite(v.depth) && screen_snap(screen, &v.position);
    return called_vertex(placed, v);
}

#define PLACED(clip, right)                                                                        \
    TEXT_WITH("8b.1", "place(" #clip ", ...)", called_placed(xyzw clip), right,                    \
              called_placed_by_hers(xyzw clip))

/* ---- Clipping ---- */

/* A triangle with the weights of a face's own corners, clipped. It is listed from the corner on
 * that is most like the first: a program may begin with another one. */
struct listed {
    struct polygon left;
    size_t count, first;
};

static struct listed called_clipped(struct vec4 a, struct vec4 b, struct vec4 c, int plane) {
    const struct polygon triangle = {
        .corner = {{a, {1, 0, 0}}, {b, {0, 1, 0}}, {c, {0, 0, 1}}},
        .count = 3,
    };
    struct listed listed = {.left = clip_at_plane(&triangle, plane)};
    listed.count = listed.left.count < 6 ? listed.left.count : 6;
    for (size_t i = 1; i < listed.count; i++) {
        const struct clip_corner *corner = listed.left.corner;
        listed.first = corner[i].weight.x > corner[listed.first].weight.x ? i : listed.first;
    }
    return listed;
}

/* The corners, or their weights, to six digits; -0 + 0 is 0. */
static struct shown called_listed(struct listed listed, bool weights) {
    struct shown shown = show(listed.count == 0 ? "nothing" : "");
    for (size_t i = 0; i < listed.count; i++) {
        struct clip_corner c = listed.left.corner[(listed.first + i) % listed.count];
        struct vec4 p = weights ? xyzw(c.weight.x, c.weight.y, c.weight.z, 0) : c.clip;
        shown = show("%.140s%s(%.6g,%.6g,%.6g", shown.text, i > 0 ? " " : "", p.x + 0, p.y + 0,
                     p.z + 0);
        shown = weights ? show("%.190s)", shown.text) : show("%.170s,%.6g)", shown.text, p.w + 0);
    }
    return shown;
}

/* Cut at the plane that must give `right`, whichever number it has, or else at this one. */
static struct shown called_cut_at(bool weights, struct vec4 a, struct vec4 b, struct vec4 c,
                                  int plane, const char *right) {
    for (int other = 0; other < CLIP_PLANES; other++) {
        struct shown shown = called_listed(called_clipped(a, b, c, other), weights);
        if (same_text(shown.text, right)) {
            return shown;
        }
    }
    return called_listed(called_clipped(a, b, c, plane), weights);
}

/* Seven corners around (0, 0, 0, 1), the last one behind the camera: how many are left? */
static size_t called_corners_of_seven(void) {
    struct polygon seven = {.count = 7};
    for (size_t i = 0; i < seven.count; i++) {
        const double angle = 6.2831853 / 7 * (double)i;
        seven.corner[i].clip = xyzw(cos(angle), sin(angle), 0, i < 6 ? 1 : -1);
    }
    return clip_at_plane(&seven, 0).count;
}

/* Do two faces find the very same points on the sides that they share, which one of them walks the
 * other way round? */
static bool called_same_from_both_ends(void) {
    const struct clip_corner inside = {{0.1, 0.2, 0.3, 0.7}, {1, 0, 0}};
    for (int i = 1; i <= 20; i++) {
        const struct clip_corner one = {{i, 0.3, -i / 3.0, -i / 7.0}, {0, 1, 0}};
        const struct clip_corner other = {{-i, 0.7, i / 9.0, -i / 11.0}, {0, 0, 1}};
        const struct polygon face = {.corner = {inside, one, other}, .count = 3};
        const struct polygon back = {.corner = {inside, other, one}, .count = 3};
        const struct polygon a = clip_at_plane(&face, 0), b = clip_at_plane(&back, 0);
        for (size_t k = 0; k < 3 && a.count == 3 && b.count == 3; k++) {
            const struct vec4 p = a.corner[k].clip;
            bool found = false;
            for (size_t n = 0; n < 3; n++) {
                const struct vec4 q = b.corner[n].clip;
                found = found || (p.x == q.x && p.y == q.y && p.z == q.z && p.w == q.w);
            }
            if (!found) {
                return false;
            }
        }
    }
    return true;
}

#define CLIP(task, plane, a, b, c, right)                                                          \
    TEXT(task, "clip_at_plane(" #a " " #b " " #c ", " #plane ")",                                  \
         called_cut_at(false, xyzw a, xyzw b, xyzw c, plane, right), right)
#define WEIGHTS(plane, a, b, c, right)                                                             \
    TEXT("8e.1", "clip_at_plane(" #a " " #b " " #c ", " #plane "), weights",                       \
         called_cut_at(true, xyzw a, xyzw b, xyzw c, plane, right), right)

static void numbers(void) {
    VIEWPORT(800, 800, 0.5, -1, xy(600, 0));
    VIEWPORT(800, 600, -1, -1, xy(0, 0));
    VIEWPORT(405, 363, 0, 0, xy(202.5, 181.5));
    VIEWPORT(405, 363, 1, 1, xy(405, 363));
    PIXELS(called_move(3, 0, 0), (2, 1), xy(5, 1));
    PIXELS(called_away(0.5), (2, 3), xy(1, 1.5));
    PIXELS(called_lean(0.25), (-1, 2), xy(-0.5, 2));
    PANEL(0, 2, 2, xy(3, 1));
    PANEL(1, 1, 1, xy(1.6, 1));
    PANEL(2, 1, 0, xy(sqrt(0.5), sqrt(0.5)));
    PANEL(3, 1, 1, xy(sqrt(0.5), 2 * sqrt(0.5)));
    PANEL(4, 1, 1, xy(0, sqrt(0.5)));
    PANEL(5, 1, 0.8, xy(1, 0.8));
    PANEL(5, 2, 0.8, xy(1 + sqrt(0.5), 0.8 + sqrt(0.5)));
    PANEL(6, 1, 1, xy(0.5 * sqrt(0.5), -0.1 * sqrt(0.5)));
    PANEL(7, 1, 1, xy(-0.8, sqrt(2) - 1.3));
    PANEL(8, 2, 1, xy(1, 0.5));
    AS_WHOLE("8a.3", "panel_map(), heights kept", called_heights_kept(), 9);
    PLACED((0.4, 0.2, 1, 0.5), "position (90, 70), depth 2, recip_w 2");
    PLACED((0.41, -0.8, -2, 2), "position (60.25, 30), depth -1, recip_w 0.5");
    PLACED((0, 0, 1e308, 0.01), "false");
    PLACED((1e9, 0, 0, 1), "false");
    PROJECTION(2, (0.4, 0.2, 1), xyzw(0.4, 0.2, 1, 0.5));
    PROJECTION(2, (0.4, 0.2, -2), xyzw(0.4, 0.2, -2, 2));
    PROJECTION(4, (1, 2, 3), xyzw(1, 2, 3, 0.25));
    PROJECTION(INFINITY, (1, 2, 3), xyzw(1, 2, 3, 1));
    WEIGHTED((0.5, 0.5, 0), (1, 0.25, 1), xyz(0.8, 0.2, 0));
    WEIGHTED((0.2, 0.3, 0.5), (1, 1, 1), xyz(0.2, 0.3, 0.5));
    WEIGHTED((0.5, 0.25, 0.25), (1, 2, 4), xyz(0.25, 0.25, 0.5));
    WEIGHTED((0.5, 0.5, 0), (1, 1.02, 1), xyz(1 / 2.02, 1.02 / 2.02, 0));
    NORMAL(called_scale(2, 1, 1), (1, -1, 0), xyz(0.5, -1, 0));
    NORMAL(called_lean(1), (1, 0, 0), xyz(1, -1, 0));
    NORMAL(called_move(5, 6, 7), (0.5, -1, 0), xyz(0.5, -1, 0));
    NORMAL(called_scale(1, 1, 0), (0.5, 0, 1), xyz(0.5, 0, 1));
    SEEN((3, 0, 0), (1, 0, 0), (0, 1, 0), (1, 0, -1), xyz(1, 0, 0));
    SEEN((0, 0, 5), (0, 0, 2), (0, 2, 2), (1, 2, 4), xyz(1, 2, 2));
    SEEN((0, 0, 2), (0, 0, 0), (1, 0, 0), (1, 2, 3), xyz(-2, 1, 3));
    SEEN((0, 3, 0), (0, 0, 0), (0, 1, 0), (1, 2, 3), xyz(3, 1, 2));
    SEEN((0, 3, 0), (0, 0, 0), (0, 1, 1e-12), (1, 2, 3), xyz(3, 1, 2));
    SEEN((0, 3, 0), (0, 0, 0), (0, 1, 1e-9), (1, 2, 3), xyz(-1, 3, 2));
    SEEN((2, 4, 2), (0, 3, 0), (-2, -1, -2), (1, 5, 3), xyz(-sqrt(2), 4 / sqrt(18), 10.0 / 3));
    CLIP("8e.1", 0, (0, 0, 0, 0.5), (0, 8, 4, 0.5), (4, 0, 8, -0.5),
         "(0,0,0,0.5) (0,8,4,0.5) (1.96875,4.0625,5.96875,0.0078125) (1.96875,0,3.9375,0.0078125)");
    WEIGHTS(0, (0, 0, 0, 0.5), (0, 8, 4, 0.5), (4, 0, 8, -0.15625),
            "(1,0,0) (0,1,0) (0,0.25,0.75) (0.25,0,0.75)");
    CLIP("8e.1", 0, (0, 0, 0, 0.5), (0, 8, 4, 0.5), (2e15, 0, 0, -1e15),
         "(0,0,0,0.5) (0,8,4,0.5) (0.984375,8,4,0.0078125) (0.984375,0,0,0.0078125)");
    AS_WHOLE("8e.1", "clip_at_plane(7 corners, one of them behind, 0): corners",
             called_corners_of_seven(), 8);
    TEXT("8e.1", "clip_at_plane(), the same edge from either end: the very same point",
         show_truth(called_same_from_both_ends()), "true");
    CLIP("8e.2+8e.1", 1, (0, 0, 0, 0.5), (0, 8, 4, 0.5), (-128, 0, 8, 0.5),
         "(0,0,0,0.5) (0,8,4,0.5) (-32,6,5,0.5) (-32,0,2,0.5)");
    CLIP("8e.2+8e.1", 2, (0, 0, 0, 0.5), (128, 0, 8, 0.5), (0, 8, 4, 0.5),
         "(0,0,0,0.5) (32,0,2,0.5) (32,6,5,0.5) (0,8,4,0.5)");
    CLIP("8e.2+8e.1", 3, (0, 0, 0, 0.5), (8, -128, 0, 0.5), (8, -128, 4, 0.5),
         "(0,0,0,0.5) (2,-32,0,0.5) (2,-32,1,0.5)");
    CLIP("8e.2+8e.1", 4, (0, 0, 0, 0.5), (8, 128, 0, 0.5), (8, 128, 4, 0.5),
         "(0,0,0,0.5) (2,32,0,0.5) (2,32,1,0.5)");
}
