/* Lesson 9's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step09_shaders/main.c"
#endif
#include "lane_numbers.h"

/* ---- 9a.1 ---- */

static struct vec3 positions[] = {{0, 0, 0}, {0.5, -1, 1}, {1, 1, -2}, {0, 0, 2},
                                  {0, 0, 3}, {1e9, 0, 0},  {2, 0, 0},  {0, 2, 0}};
static float normals[][3] = {{0, 0, 1}, {2, 0, 0}, {0, 0, -1}}, uvs[][2] = {{0, 0}, {0.25f, 0.75f}};
static struct face faces[] = {
    {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}, /* in front of the eye */
    {{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}}, /* w is 0 at one */
    {{{4, 0, 0}, {0, 0, 0}, {1, 0, 0}}}, /* and below 0 */
    {{{0, 0, 0}, {5, 0, 0}, {1, 0, 0}}}, /* one is too far for the screen */
    {{{0, 0, 0}, {6, 1, 1}, {7, 0, 2}}}, /* counterclockwise, with normals */
    {{{0, 0, 0}, {7, 0, 2}, {6, 1, 1}}}, /* clockwise */
};
enum { CALLED_FACES = sizeof faces / sizeof faces[0], CALLED_FRONT = 4, CALLED_BACK = 5 };
static const struct model model = {
    .positions = positions,
    .normals = normals,
    .uvs = uvs,
    .faces = faces,
    .face_count = CALLED_FACES,
};

/* w = 1 - z / 2; a viewport of odd size. */
static struct draw_call called_call_of(enum cull cull) {
    struct draw_call call = {&model, mat4_identity(), {10, 20, 101, 51}, cull};
    call.to_clip.m[3][2] = -0.5;
    return call;
}

enum placed_part { CALLED_POSITION, CALLED_DEPTH, CALLED_RECIP_W };

static struct shown called_placed(size_t face, enum placed_part part) {
    const struct draw_call call = called_call_of(CULL_NONE);
    struct placed_face p = {.depth = {0}};
    if (!place_face(&call, face, &p)) {
        return show("false");
    }
    const struct fixed2 *at = p.position;
    return part == CALLED_DEPTH ? show_reals(p.depth, 3)
           : part == CALLED_RECIP_W
               ? show_reals(p.recip_w, 3)
               : show("(%g, %g) (%g, %g) (%g, %g)", at[0].x / 256.0, at[0].y / 256.0,
                      at[1].x / 256.0, at[1].y / 256.0, at[2].x / 256.0, at[2].y / 256.0);
}

/* ---- 9a.2 ---- */

/* Varying 1, as grey; what is below 30 may be discarded. */
static bool called_grey_pixel(const void *called_uniforms, const double *varyings,
                              struct vec3 *rgb) {
    (void)called_uniforms;
    *rgb = xyz(varyings[1], varyings[1], varyings[1]);
    return true;
}

static bool called_light_pixel(const void *called_uniforms, const double *varyings,
                               struct vec3 *rgb) {
    return called_grey_pixel(called_uniforms, varyings, rgb) && varyings[1] >= 30;
}

enum { CALLED_WIDTH = 3, CALLED_HEIGHT = 2 };

/* Two rows of three numbers: "1 2 3 / 4 5 6". */
static struct shown called_two_rows(const double values[CALLED_WIDTH * CALLED_HEIGHT], int count) {
    struct shown shown = {""};
    for (int i = 0; i < count; i++) {
        const char *between = i == 0 ? "" : i == CALLED_WIDTH ? " / " : " ";
        shown = show("%.150s%s%.4g", shown.text, between, values[i]);
    }
    return shown;
}

/* A triangle with the corners (0, 0), (8, 0) and (0, 8) over 3 x 2 pixels: what is in the image or,
 * where `depths`, in the depth buffer, which was `before`. The triangle's depth is 0.5, 1.5, 2.5 in
 * its columns, its varying 0, 80 and 160 at its corners. */
static struct shown called_drawn(bool depths, double before, double recip_w, struct rectangle view,
                                 bool (*pixel)(const void *, const double *, struct vec3 *)) {
    double depth[CALLED_WIDTH * CALLED_HEIGHT], shown[CALLED_WIDTH * CALLED_HEIGHT];
    struct image image = black_image(CALLED_WIDTH, CALLED_HEIGHT);
    struct edges edges;
    const struct simple_shader shader = {2, NULL, pixel};
    const struct canvas canvas = {&image, depth};
    const struct placed_face face = {
        .position = {{0, 0}, {2048, 0}, {0, 2048}},
        .depth = {0, 8, 0},
        .recip_w = {1, recip_w, 1},
        .varyings = {{200, 0}, {200, 80}, {200, 160}},
    };
    for (size_t i = 0; i < CALLED_WIDTH * CALLED_HEIGHT; i++) {
        depth[i] = before;
    }
    edges_setup(&edges, face.position[0], face.position[1], face.position[2], CALLED_WIDTH,
                CALLED_HEIGHT);
    draw_pixels(&canvas, &view, &edges, &face, &shader, NULL);
    for (int i = 0; i < CALLED_WIDTH * CALLED_HEIGHT; i++) {
        shown[i] = depths ? depth[i] : image_get(&image, i % CALLED_WIDTH, i / CALLED_WIDTH).r;
    }
    image_free(&image);
    return called_two_rows(shown, CALLED_WIDTH * CALLED_HEIGHT);
}

/* ---- 9a.3 ---- */

/* Which corners of a face were asked for. */
static bool called_asked[CALLED_FACES][3];

static void called_asking_vertex(const void *called_uniforms, size_t face, size_t corner,
                                 double *varyings) {
    (void)called_uniforms;
    varyings[0] = varyings[1] = 0;
    called_asked[face][corner] = true;
}

/* "0:012 4:012": the corners of faces 0 and 4. */
static struct shown called_listed(void) {
    struct shown shown = {""};
    for (int i = 0; i < CALLED_FACES; i++) {
        if (called_asked[i][0] || called_asked[i][1] || called_asked[i][2]) {
            shown = show("%.150s%s%d:%s%s%s", shown.text, shown.text[0] == '\0' ? "" : " ", i,
                         called_asked[i][0] ? "0" : "", called_asked[i][1] ? "1" : "",
                         called_asked[i][2] ? "2" : "");
        }
    }
    memset(called_asked, 0, sizeof called_asked);
    return shown;
}

enum { CALLED_SIDE = 128 };

static struct shown called_asked_by_draw(enum cull cull) {
    static double depth[CALLED_SIDE * CALLED_SIDE];
    struct image image = black_image(CALLED_SIDE, CALLED_SIDE);
    const struct canvas canvas = {&image, depth};
    const struct simple_shader shader = {2, called_asking_vertex, called_grey_pixel};
    const struct draw_call call = called_call_of(cull);
    simple_draw(&canvas, &call, &shader, NULL);
    image_free(&image);
    return called_listed();
}

/* Those that your place_face() places. */
static struct shown called_asked_of_placed(enum cull cull) {
    const struct draw_call call = called_call_of(cull);
    for (size_t i = 0; i < CALLED_FACES; i++) {
        struct placed_face p;
        struct edges edges;
        bool draws =
            place_face(&call, i, &p) && edges_setup(&edges, p.position[0], p.position[1],
                                                    p.position[2], CALLED_SIDE, CALLED_SIDE);
        for (size_t k = 0; k < 3; k++) {
            called_asked[i][k] = draws && cull != (edges.clockwise ? CULL_BACK : CULL_FRONT);
        }
    }
    return called_listed();
}

/* ---- Part b ---- */

static struct texture called_colors, grey, map;
static struct uniforms called_uniforms = {
    .model = &model, .diffuse = &called_colors, .normal_map = &map, .to_light = {0.6, 0, 0.8}};

static bool called_make_textures(void) {
    const struct color two[] = {{.r = 200, .g = 100, .b = 50}, {.r = 201, .g = 101, .b = 51}};
    const struct color one = color_grey(100);
    return called_make_texture(&called_colors, two, 2) && called_make_texture(&grey, &one, 1);
}

/* For a normal map of one colour, a grey texture and the light (2, 3, 6) / 7. */
static struct uniforms called_mapped(int r, int g, int b) {
    const struct color color = rgb(r, g, b);
    struct uniforms u = called_uniforms;
    texture_free(&map);
    called_make_texture(&map, &color, 1);
    u.diffuse = &grey;
    u.to_light = xyz(2.0 / 7, 3.0 / 7, 6.0 / 7);
    return u;
}

static struct shown called_first_varyings(void (*vertex)(const void *, size_t, size_t, double *),
                                          size_t face, size_t corner, size_t count) {
    double varyings[VARYING_LIMIT] = {0};
    vertex(&called_uniforms, face, corner, varyings);
    return count == 1 ? show("%.5g", varyings[0]) : show_reals(varyings, count);
}

static struct shown called_light_on(struct vec3 normal) {
    return show("%.5g", lambert(normal, called_uniforms.to_light));
}

typedef bool called_pixel_function(const void *called_uniforms, const double *varyings,
                                   struct vec3 *rgb);

static struct vec3 called_pixel_of(called_pixel_function *pixel, struct uniforms u, double a,
                                   double b, double c) {
    const double varyings[VARYING_LIMIT] = {a, b, c};
    struct vec3 rgb = {0, 0, 0};
    pixel(&u, varyings, &rgb);
    return rgb;
}

static bool called_is_drawn(called_pixel_function *pixel, double intensity) {
    const double varyings[VARYING_LIMIT] = {intensity};
    struct vec3 rgb;
    return pixel(&called_uniforms, varyings, &rgb);
}

/* Whole numbers: 127.5 and 128 are both taken for the middle of the map's values. */
static struct shown called_mapped_pixel(struct uniforms u) {
    struct vec3 c = called_pixel_of(normal_map_pixel, u, 0.5, 0.25, 0.125);
    return show("%.0f,%.0f,%.0f", c.x, c.y, c.z);
}

static struct shown called_grey_in_light(double x, double y, double z) {
    double value = 100 * lambert(xyz(x, y, z), xyz(2.0 / 7, 3.0 / 7, 6.0 / 7));
    return show("%.0f,%.0f,%.0f", value, value, value);
}

/* ---- Part c ---- */

typedef lanes_mask called_fragment_function(const void *called_uniforms, const lanes *varyings,
                                            lanes_texel *color);

/* What a fragment function makes of three varyings: a colour, and whether it is drawn. */
static struct shown called_shaded(called_fragment_function *fragment, const struct uniforms *u,
                                  int lane, const double *v) {
    const lanes varyings[VARYING_LIMIT] = {in_one_lane(lane, v[0], 0.25),
                                           in_one_lane(lane, v[1], 0.25),
                                           in_one_lane(lane, v[2], 0.25)};
    lanes_texel color = lanes_black();
    bool is_drawn = lanes_is_set(fragment(u, varyings, &color), lane);
    return fragment == lit_only_fragment ? show_truth(is_drawn)
                                         : show_color(texel_lane(color, lane));
}

static called_fragment_function *called_fragment; /* that called_fragment_in() calls */

static struct shown called_fragment_in(int lane, const double *v) {
    return called_shaded(called_fragment, &called_uniforms, lane, v);
}

static struct shown called_in_lanes(called_fragment_function *fragment, double a, double b,
                                    double c) {
    called_fragment = fragment;
    return in_each_lane(called_fragment_in, (double[]){a, b, c});
}

/* Red, green, blue, intensity. */
static struct shown called_shade_in(int lane, const double *v) {
    return show_color(
        texel_lane(shade(lanes3_all(xyz(v[0], v[1], v[2])), in_one_lane(lane, v[3], 0.25)), lane));
}

/* A normal. */
static struct shown called_light_in(int lane, const double *v) {
    struct lanes3 normal = vector_in_one_lane(lane, xyz(v[0], v[1], v[2]));
    return show_lane(lambert_lanes(normal, called_uniforms.to_light), lane);
}

/* The map's colour. */
static struct shown called_mapped_in(int lane, const double *v) {
    const struct uniforms u = called_mapped((int)v[0], (int)v[1], (int)v[2]);
    return called_shaded(normal_map_fragment, &u, lane, (double[]){0.5, 0.25, 0.125});
}

static struct shown called_mapped_in_lanes(int r, int g, int b) {
    return in_each_lane(called_mapped_in, (double[]){r, g, b});
}

/* ---- Part d ---- */

/* The faces of the model that are kept: "0 4". */
static struct shown called_kept(enum cull cull) {
    static struct kept_face kept[CALLED_FACES + 1];
    const struct image image = {.width = CALLED_SIDE, .height = CALLED_SIDE};
    const struct canvas canvas = {(struct image *)&image, NULL};
    const struct draw_call call = called_call_of(cull);
    size_t count = keep_faces(&canvas, &call, kept);
    struct shown shown = {""};
    for (size_t i = 0; i < count && i < CALLED_FACES; i++) {
        shown = show("%.150s%s%zu", shown.text, i > 0 ? " " : "", kept[i].face);
    }
    return shown;
}

/* The triangle of 9a.2 over 3 x 2 pixels, or a lower one. */
static void called_keep_triangle(struct kept_face *kept, size_t face, double depth, int height) {
    *kept = (struct kept_face){
        .face = face,
        .placed = {.position = {{0, 0}, {2048, 0}, {0, height}},
                   .depth = {depth, depth + 8, depth},
                   .recip_w = {1, 1, 1}},
    };
    const struct fixed2 *corner = kept->placed.position;
    edges_setup(&kept->edges, corner[0], corner[1], corner[2], CALLED_WIDTH, CALLED_HEIGHT);
}

/* The numbers, or the depths, of a band after a face with number 7 is drawn. */
static struct shown called_covered(struct span rows, bool depths, double before) {
    double depth[CALLED_WIDTH * CALLED_HEIGHT], shown[CALLED_WIDTH * CALLED_HEIGHT];
    uint32_t nearest[CALLED_WIDTH * CALLED_HEIGHT] = {0};
    const struct band band = {rows, CALLED_WIDTH, depth, nearest};
    struct kept_face kept;
    called_keep_triangle(&kept, 0, 0, 2048);
    for (int i = 0; i < CALLED_WIDTH * CALLED_HEIGHT; i++) {
        depth[i] = before;
    }
    cover_face(&band, &kept, 7);
    for (int i = 0; i < CALLED_WIDTH * CALLED_HEIGHT; i++) {
        shown[i] = depths ? depth[i] : nearest[i];
    }
    return called_two_rows(shown, CALLED_WIDTH * (rows.end - rows.begin));
}

/* How often each function of the shader below was called. */
static int called_corners, called_pixels;

/* Varying 1 is 0, 80 and 160 at the corners of face 0, and 100 more in face 1. */
static void called_counting_vertex(const void *u, size_t face, size_t corner, double *varyings) {
    (void)u;
    varyings[0] = 200;
    varyings[1] = 80 * (double)corner + 100 * (double)face;
    called_corners++;
}

static bool called_counting_pixel(const void *u, const double *varyings, struct vec3 *rgb) {
    called_pixels++;
    return called_grey_pixel(u, varyings, rgb);
}

enum called_part { CALLED_GREYS, CALLED_CALLS, CALLED_ROWS };

/* Two such faces, face 1 nearer, of which shade_band() finds face 0 in three pixels, face 1 in one;
 * or all of visible_draw(), where face 1 reaches over row 0 only, in bands of that many rows: its
 * greys, its calls, or how many rows of the memory for bands it writes. */
static struct shown called_drawn_visibly(int band_rows, enum called_part part) {
    double depth[CALLED_WIDTH * CALLED_HEIGHT], greys[CALLED_WIDTH * CALLED_HEIGHT];
    uint32_t nearest[CALLED_WIDTH * CALLED_HEIGHT] = {1, 0, 1, 0, 2, 1};
    struct image image = black_image(CALLED_WIDTH, CALLED_HEIGHT);
    const struct canvas canvas = {&image, depth};
    const struct simple_shader shader = {2, called_counting_vertex, called_counting_pixel};
    struct band band = {{0, CALLED_HEIGHT}, CALLED_WIDTH, depth, nearest};
    struct kept_face kept[2];
    called_keep_triangle(&kept[0], 0, 0, 2048);
    called_keep_triangle(&kept[1], 1, 1, band_rows == 0 ? 2048 : 307);
    called_corners = called_pixels = 0;
    if (band_rows == 0) {
        shade_band(&canvas, &band, kept, &shader, NULL);
    } else {
        band.rows.end = band_rows;
        nearest[CALLED_WIDTH] = 99;
        visible_draw(&canvas, band, kept, 2, &shader, NULL);
    }
    for (int i = 0; i < CALLED_WIDTH * CALLED_HEIGHT; i++) {
        greys[i] = image_get(&image, i % CALLED_WIDTH, i / CALLED_WIDTH).r;
    }
    return part == CALLED_GREYS   ? called_two_rows(greys, CALLED_WIDTH * CALLED_HEIGHT)
           : part == CALLED_CALLS ? show("%d corners, %d pixels", called_corners, called_pixels)
                                  : show("%d", nearest[CALLED_WIDTH] == 99 ? 1 : CALLED_HEIGHT);
}

#define PLACED(face, part, name, right)                                                            \
    TEXT("9a.1", "place_face(call, " #face ", placed)" name, called_placed(face, part), right)
#define DRAWN(name, depths, before, recip_w, view, pixel, right)                                   \
    TEXT("9a.2", "draw_pixels() " name, called_drawn(depths, before, recip_w, view, pixel), right)
#define ASKED(cull, right)                                                                         \
    TEXT_WITH("9a.3", "simple_draw(), " #cull, called_asked_by_draw(cull), right,                  \
              called_asked_of_placed(cull))
#define PIXEL(task, pixel, a, right)                                                               \
    AS_VECTOR(task, #pixel "(" #a ")", vec3, called_pixel_of(pixel, called_uniforms, a, 0, 0),     \
              right)
#define TOON(a, right, level)                                                                      \
    TEXT_WITH("9c.2", "toon_fragment(" #a ")", called_in_lanes(toon_fragment, a, 0, 0), right,     \
              IN_LANES(called_shade_in, 255, 155, 0, level))
/* A map of one colour; the direction that it means, and the part of its light. */
#define MAPPED_PIXEL(rgb, xyz, right)                                                              \
    TEXT_WITH("9b.5", "normal_map_pixel() of " #rgb, called_mapped_pixel(called_mapped rgb),       \
              right, called_grey_in_light xyz)
#define MAPPED_FRAGMENT(rgb, part, right)                                                          \
    TEXT_WITH("9c.3", "normal_map_fragment() of " #rgb, called_mapped_in_lanes rgb, right,         \
              IN_LANES(called_shade_in, 100, 100, 100, part))
#define KEPT(cull, right) TEXT("9d.1+9a.1", "keep_faces(), " #cull, called_kept(cull), right)
#define COVERED(name, begin, depths, before, right)                                                \
    TEXT("9d.2", "cover_face() " name, called_covered((struct span){begin, 2}, depths, before),    \
         right)
#define VISIBLE(task, name, rows, part, right)                                                     \
    TEXT(task, name, called_drawn_visibly(rows, part), right)

static void numbers(void) {
    const double none = -INFINITY;
    const struct rectangle all = {0, 0, CALLED_WIDTH, CALLED_HEIGHT}, one = {1, 0, 1, 1};
    if (!called_make_textures()) {
        return;
    }
    PLACED(0, CALLED_POSITION, ", position", "(60.5, 45.5) (111, -5.5) (85.75, 58.25)");
    PLACED(0, CALLED_DEPTH, ", depth", "(0, 2, -1)");
    PLACED(0, CALLED_RECIP_W, ", recip_w", "(1, 2, 0.5)");
    PLACED(1, CALLED_POSITION, "", "false");
    PLACED(2, CALLED_POSITION, "", "false");
    PLACED(3, CALLED_POSITION, "", "false");
    DRAWN("on 3 x 2 pixels", false, none, 1, all, called_grey_pixel, "15 25 35 / 35 45 55");
    DRAWN("in perspective", false, none, 4, all, called_grey_pixel, "25 45 57 / 42 58 67");
    DRAWN("over depths of 1.5", false, 1.5, 1, all, called_grey_pixel, "0 0 35 / 0 0 55");
    DRAWN("over depths of 1, depths", true, 1, 4, all, called_grey_pixel, "1 1.5 2.5 / 1 1.5 2.5");
    DRAWN("in a viewport of one pixel", false, none, 1, one, called_grey_pixel, "0 25 0 / 0 0 0");
    DRAWN("that discards, depths", true, 0, 1, all, called_light_pixel, "0 0 2.5 / 0.5 1.5 2.5");
    ASKED(CULL_BACK, "0:012 4:012");
    ASKED(CULL_FRONT, "5:012");
    ASKED(CULL_NONE, "0:012 4:012 5:012");
    REAL("9b.1", lambert(xyz(0, 0, 2), xyz(0.6, 0, 0.8)), 0.8);
    REAL("9b.1", lambert(xyz(3, 0, 4), xyz(0.6, 0, 0.8)), 1);
    REAL("9b.1", lambert(xyz(0, 0, -2), xyz(0.6, 0, 0.8)), 0);
    PIXEL("9b.2", white_pixel, 0.5, xyz(127.5, 127.5, 127.5));
    TEXT_WITH("9b.2", "flat_vertex(face of normal (0, 0, 4))",
              called_first_varyings(flat_vertex, CALLED_FRONT, 1, 1), "0.8",
              called_light_on(xyz(0, 0, 4)));
    TEXT_WITH("9b.2", "gouraud_vertex(corner of normal (2, 0, 0))",
              called_first_varyings(gouraud_vertex, CALLED_FRONT, 1, 1), "0.6",
              called_light_on(xyz(2, 0, 0)));
    TEXT("9b.3", "uv_vertex(corner of uv (0.25, 0.75))",
         called_first_varyings(uv_vertex, CALLED_FRONT, 1, 2), "(0.25, 0.75)");
    AS_VECTOR("9b.3", "textured_pixel(0.5, 0.25, 0.6)", vec3,
              called_pixel_of(textured_pixel, called_uniforms, 0.5, 0.25, 0.6),
              xyz(120.3, 60.3, 30.3));
    PIXEL("9b.4", toon_pixel, 0.8001, xyz(255, 155, 0));
    PIXEL("9b.4", toon_pixel, 0.7999, xyz(191.25, 116.25, 0));
    PIXEL("9b.4", toon_pixel, 0.1999, xyz(0, 0, 0));
    PIXEL("9b.4", toon_pixel, 1, xyz(255, 155, 0));
    MAPPED_PIXEL((255, 128, 128), (1, 0, 0), "29,29,29");
    MAPPED_PIXEL((128, 255, 128), (0, 1, 0), "43,43,43");
    MAPPED_PIXEL((128, 128, 255), (0, 0, 1), "86,86,86");
    TEXT("9b.6", "two_sided_vertex(face of normal (0, 0, 4))",
         called_first_varyings(two_sided_vertex, CALLED_FRONT, 1, 1), "0.8");
    TEXT("9b.6", "two_sided_vertex(face of normal (0, 0, -4))",
         called_first_varyings(two_sided_vertex, CALLED_BACK, 1, 1), "0.8");
    TEXT("9b.7", "lit_only_pixel(0)", show_truth(called_is_drawn(lit_only_pixel, 0)), "false");
    TEXT("9b.7", "lit_only_pixel(0.001)", show_truth(called_is_drawn(lit_only_pixel, 0.001)),
         "true");
    TEXT("9c.1", "shade((200, 100, 50), 0.6)", IN_LANES(called_shade_in, 200, 100, 50, 0.6),
         "120,60,30");
    TEXT("9c.1", "white_fragment(0.6)", called_in_lanes(white_fragment, 0.6, 0, 0), "153,153,153");
    TEXT("9c.1", "textured_fragment(0.5, 0.25, 0.6)",
         called_in_lanes(textured_fragment, 0.5, 0.25, 0.6), "120,60,30");
    TOON(0.8001, "255,155,0", 1);
    TOON(0.7999, "191,116,0", 0.75);
    TOON(0.1999, "0,0,0", 0);
    TOON(1, "255,155,0", 1);
    TEXT("9c.3", "lambert_lanes((0, 0, 2), (0.6, 0, 0.8))", IN_LANES(called_light_in, 0, 0, 2),
         "0.8");
    TEXT("9c.3", "lambert_lanes((0, 0, -2), (0.6, 0, 0.8))", IN_LANES(called_light_in, 0, 0, -2),
         "0");
    MAPPED_FRAGMENT((255, 128, 128), 2.0 / 7, "29,29,29");
    MAPPED_FRAGMENT((128, 255, 128), 3.0 / 7, "43,43,43");
    MAPPED_FRAGMENT((128, 128, 255), 6.0 / 7, "86,86,86");
    TEXT("9c.4", "lit_only_fragment(0)", called_in_lanes(lit_only_fragment, 0, 0, 0), "false");
    TEXT("9c.4", "lit_only_fragment(0.001)", called_in_lanes(lit_only_fragment, 0.001, 0, 0),
         "true");
    KEPT(CULL_NONE, "0 4 5");
    KEPT(CULL_BACK, "0 4");
    KEPT(CULL_FRONT, "5");
    COVERED("with number 7: numbers", 0, false, none, "7 7 7 / 7 7 7");
    COVERED("over depth 1: numbers", 0, false, 1, "0 7 7 / 0 7 7");
    COVERED("over depth 1: depths", 0, true, 1, "1 1.5 2.5 / 1 1.5 2.5");
    COVERED("over depth 1.5: numbers", 0, false, 1.5, "0 0 7 / 0 0 7");
    COVERED("in a band of row 1: numbers", 1, false, 1, "0 7 7");
    VISIBLE("9d.3", "shade_band() of 1 0 1 / 0 2 1", 0, CALLED_GREYS, "15 0 35 / 0 145 55");
    VISIBLE("9d.3", "shade_band() of 1 0 1 / 0 2 1: calls", 0, CALLED_CALLS, "6 corners, 4 pixels");
    VISIBLE("9d.4+9d.2,9d.3", "visible_draw() in bands of 1 row", 1, CALLED_GREYS,
            "172 182 192 / 35 45 55");
    VISIBLE("9d.4+9d.2,9d.3", "visible_draw() in bands of 1 row: calls", 1, CALLED_CALLS,
            "6 corners, 6 pixels");
    VISIBLE("9d.4+9d.2,9d.3", "visible_draw() in bands of 1 row: rows of memory", 1, CALLED_ROWS,
            "1");
}
