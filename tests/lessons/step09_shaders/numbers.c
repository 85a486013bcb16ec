/* Lesson 9's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step09_shaders/main.c"
#endif
#include "lane_numbers.h"

/* ---- 9a.1 ---- */

static struct vec3 positions[] = {{0, 0, 0},   {0.5, -1, 1}, {1, 1, -2}, {0, 0, 2},  {0, 0, 3},
                                  {1e9, 0, 0}, {2, 0, 0},    {0, 2, 0},  {0, 0, -9}, {0, 0, 1.99}};
static float normals[][3] = {{0, 0, 1}, {2, 0, 0}, {0, 0, -1}}, uvs[][2] = {{0, 0}, {0.25f, 0.75f}};
static struct face faces[] = {
    {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}, /* in front of the eye */
    {{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}}, /* w is 0 at one */
    {{{4, 0, 0}, {0, 0, 0}, {1, 0, 0}}}, /* and below 0 */
    {{{0, 0, 0}, {5, 0, 0}, {1, 0, 0}}}, /* one is too far for the screen */
    {{{0, 0, 0}, {6, 1, 1}, {7, 0, 2}}}, /* counterclockwise, with normals */
    {{{0, 0, 0}, {7, 0, 2}, {6, 1, 1}}}, /* clockwise */
    {{{8, 0, 0}, {9, 0, 0}, {2, 0, 0}}}, /* far away, and just before the eye: only placed */
};
enum { CALLED_FACES = 6, CALLED_FRONT = 4, CALLED_BACK = 5 };
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

/* Does place_face() fill in what it says it does? Otherwise the rest of a face is what was in
 * memory before, and whoever draws it can't help that. */
static bool called_places_whole_faces(void) {
    const struct draw_call call = called_call_of(CULL_NONE);
    bool whole = true;
    for (size_t i = 0; i < CALLED_FACES; i++) {
        struct placed_face a, b;
        memset(&a, 0, sizeof a);
        memset(&b, 0x11, sizeof b);
        const bool placed = place_face(&call, i, &a);
        whole = whole && place_face(&call, i, &b) == placed &&
                (!placed || (memcmp(a.position, b.position, sizeof a.position) == 0 &&
                             memcmp(a.depth, b.depth, sizeof a.depth) == 0 &&
                             memcmp(a.recip_w, b.recip_w, sizeof a.recip_w) == 0));
    }
    return whole;
}

/* ---- 9a.2 ---- */

/* Varying 1, as grey; what is below 30 may be discarded. Or varyings 1 to 3 as a colour. */
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

static bool called_color_pixel(const void *called_uniforms, const double *varyings,
                               struct vec3 *rgb) {
    (void)called_uniforms;
    *rgb = xyz(varyings[1], varyings[2], varyings[3]);
    return true;
}

typedef bool called_pixel_function(const void *called_uniforms, const double *varyings,
                                   struct vec3 *rgb);

enum { CALLED_WIDTH = 3, CALLED_HEIGHT = 2 };

enum called_part { CALLED_GREYS, CALLED_DEPTHS, CALLED_COLOR, CALLED_CALLS, CALLED_ROWS };

/* Rows of three numbers: "1 2 3 / 4 5 6". */
static struct shown called_in_rows(const double *values, int count) {
    struct shown shown = {""};
    for (int i = 0; i < count; i++) {
        const char *between = i == 0 ? "" : i % CALLED_WIDTH == 0 ? " / " : " ";
        shown = show("%.150s%s%.4g", shown.text, between, values[i]);
    }
    return shown;
}

/* What is red in an image of 3 pixels a row, which is freed. */
static struct shown called_reds(struct image *image) {
    double reds[CALLED_WIDTH * (CALLED_HEIGHT + 1)];
    const int count = (int)(image->width * image->height);
    for (int i = 0; i < count; i++) {
        reds[i] = image_get(image, i % CALLED_WIDTH, i / CALLED_WIDTH).r;
    }
    image_free(image);
    return called_in_rows(reds, count);
}

/* A triangle with the corners (0, 0), (8, 0) and (0, 8) over 3 x 2 pixels: what is in the image,
 * its first pixel's colour, or what is in the depth buffer, which was `before`. The triangle's
 * depth is 0.5, 1.5, 2.5 in its columns, its varying 1 is 0, 80 and 160 at its corners. */
static struct shown called_drawn(enum called_part part, double before, double recip_w,
                                 struct rectangle view, called_pixel_function *pixel) {
    double depth[CALLED_WIDTH * CALLED_HEIGHT];
    struct image image = black_image(CALLED_WIDTH, CALLED_HEIGHT);
    struct edges edges;
    const struct simple_shader shader = {4, NULL, pixel};
    const struct canvas canvas = {&image, depth};
    const struct placed_face face = {
        .position = {{0, 0}, {2048, 0}, {0, 2048}},
        .depth = {0, 8, 0},
        .recip_w = {1, recip_w, 1},
        .varyings = {{200, 0, 0, 0}, {200, 80, 160, 240}, {200, 160, 320, 480}},
    };
    for (size_t i = 0; i < CALLED_WIDTH * CALLED_HEIGHT; i++) {
        depth[i] = before;
    }
    edges_setup(&edges, face.position[0], face.position[1], face.position[2], CALLED_WIDTH,
                CALLED_HEIGHT);
    draw_pixels(&canvas, &view, &edges, &face, &shader, NULL);
    const struct color first = image_get(&image, 0, 0);
    const struct shown reds = called_reds(&image);
    return part == CALLED_GREYS   ? reds
           : part == CALLED_COLOR ? show_color(first)
                                  : called_in_rows(depth, CALLED_WIDTH * CALLED_HEIGHT);
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

enum { CALLED_ACROSS = 128, CALLED_UP = 80 }; /* of the image for the model */

static struct shown called_asked_by_draw(enum cull cull) {
    static double depth[CALLED_ACROSS * CALLED_UP];
    struct image image = black_image(CALLED_ACROSS, CALLED_UP);
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
                                                    p.position[2], CALLED_ACROSS, CALLED_UP);
        for (size_t k = 0; k < 3; k++) {
            called_asked[i][k] = draws && cull != (edges.clockwise ? CULL_BACK : CULL_FRONT);
        }
    }
    return called_listed();
}

/* Varying 1 is 0, 100 and 200 at the corners. */
static void called_ramp_vertex(const void *called_uniforms, size_t face, size_t corner,
                               double *varyings) {
    (void)called_uniforms, (void)face;
    varyings[0] = 200;
    varyings[1] = 100 * (double)corner;
}

/* The greys of two pixels of a face, as simple_draw() draws it; or `by_parts`, as your place_face()
 * and draw_pixels() do. */
static struct shown called_face_greys(bool by_parts) {
    static double depth[CALLED_ACROSS * CALLED_UP];
    struct image image = black_image(CALLED_ACROSS, CALLED_UP);
    const struct canvas canvas = {&image, depth};
    const struct simple_shader shader = {2, called_ramp_vertex, called_grey_pixel};
    struct model one = model;
    struct draw_call call = called_call_of(CULL_NONE);
    struct placed_face p;
    struct edges edges;
    one.faces = faces + CALLED_FRONT;
    one.face_count = 1;
    call.model = &one;
    depth_clear(depth, sizeof depth / sizeof *depth);
    if (!by_parts) {
        simple_draw(&canvas, &call, &shader, NULL);
    } else if (place_face(&call, 0, &p) && edges_setup(&edges, p.position[0], p.position[1],
                                                       p.position[2], CALLED_ACROSS, CALLED_UP)) {
        for (size_t i = 0; i < 3; i++) {
            called_ramp_vertex(NULL, 0, i, p.varyings[i]);
        }
        draw_pixels(&canvas, &call.viewport, &edges, &p, &shader, NULL);
    }
    const struct shown shown =
        show("%d %d", image_get(&image, 100, 50).r, image_get(&image, 61, 60).r);
    image_free(&image);
    return shown;
}

/* ---- Part b ---- */

static struct texture called_colors, grey, map, called_greys;
static struct uniforms called_uniforms = {
    .model = &model, .diffuse = &called_colors, .normal_map = &map, .to_light = {0.6, 0, 0.8}};

static bool called_make_textures(void) {
    const struct color two[] = {{.r = 200, .g = 100, .b = 50}, {.r = 201, .g = 101, .b = 51}};
    const struct color one = color_grey(100);
    const struct color levels[3] = {color_grey(50), color_grey(100), color_grey(200)};
    return called_make_texture(&called_colors, two, 2) && called_make_texture(&grey, &one, 1) &&
           called_make_levels(&called_greys, levels, 3);
}

/* The texture is read at level 1, the normal map at level 2, where they have the greys 100 and the
 * normal (0, 0, 1). */
static struct uniforms called_at_levels(void) {
    const struct color levels[3] = {rgb(255, 128, 128), rgb(128, 255, 128), rgb(128, 128, 255)};
    struct uniforms u = called_uniforms;
    texture_free(&map);
    called_make_levels(&map, levels, 3);
    u.diffuse = &called_greys;
    u.diffuse_level = 1;
    u.normal_level = 2;
    u.to_light = xyz(2.0 / 7, 3.0 / 7, 6.0 / 7);
    return u;
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

/* The light of flat_vertex() on that face, after the same in another light. */
static struct shown called_flat_again(size_t face) {
    struct uniforms u = called_uniforms;
    double varyings[VARYING_LIMIT] = {0};
    flat_vertex(&u, face, 0, varyings);
    u.to_light = xyz(0, 0, 1);
    flat_vertex(&u, face, 0, varyings);
    return show("%.5g", varyings[0]);
}

/* The light of two_sided_vertex() on the face whose normal points to us, in a light behind it. */
static struct shown called_lit_from_behind(void) {
    struct uniforms u = called_uniforms;
    double varyings[VARYING_LIMIT] = {0};
    u.to_light = xyz(0.6, 0, -0.8);
    two_sided_vertex(&u, CALLED_FRONT, 1, varyings);
    return show("%.5g", varyings[0]);
}

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

/* What these values of a map mean, of length 1. */
static struct vec3 called_map_normal(int r, int g, int b) {
    return vec3_normalized(xyz(r - 127.5, g - 127.5, b - 127.5));
}

/* The grey that your lambert() makes of this normal. */
static struct shown called_grey_in_light(int r, int g, int b) {
    double value = 100 * lambert(called_map_normal(r, g, b), xyz(2.0 / 7, 3.0 / 7, 6.0 / 7));
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

/* The grey of a map's colour in that light, by your shade(). */
static struct shown called_shaded_grey(int r, int g, int b) {
    const double part = vec3_dot(called_map_normal(r, g, b), xyz(2.0 / 7, 3.0 / 7, 6.0 / 7));
    return IN_LANES(called_shade_in, 100, 100, 100, part);
}

static struct shown called_textured_at_level_in(int lane, const double *v) {
    const struct uniforms u = called_at_levels();
    return called_shaded(textured_fragment, &u, lane, v);
}

static struct shown called_mapped_at_levels_in(int lane, const double *v) {
    const struct uniforms u = called_at_levels();
    return called_shaded(normal_map_fragment, &u, lane, v);
}

/* ---- Part d ---- */

enum called_kept_part { CALLED_NUMBERS, CALLED_NOT_ASKED, CALLED_ROWS_OF };

/* The faces of the model that are kept, "0 4"; "yes" for each whose corners are not yet asked; or
 * the rows of the image over which they reach, "0-59 46-80". */
static struct shown called_list_kept(const struct kept_face *kept, size_t count,
                                     enum called_kept_part part) {
    struct shown shown = {""};
    for (size_t i = 0; i < count && i < CALLED_FACES; i++) {
        const struct kept_face *k = &kept[i];
        const char *between = i > 0 ? " " : "";
        shown = part == CALLED_NUMBERS ? show("%.150s%s%zu", shown.text, between, k->face)
                : part == CALLED_NOT_ASKED
                    ? show("%.150s%s%s", shown.text, between, k->asked ? "asked" : "no")
                    : show("%.150s%s%d-%d", shown.text, between, k->edges.y_begin, k->edges.y_end);
    }
    return shown;
}

static struct shown called_kept(enum cull cull, enum called_kept_part part) {
    static struct kept_face kept[CALLED_FACES + 1];
    const struct image image = {.width = CALLED_ACROSS, .height = CALLED_UP};
    const struct canvas canvas = {(struct image *)&image, NULL};
    const struct draw_call call = called_call_of(cull);
    for (size_t i = 0; i < CALLED_FACES; i++) {
        kept[i].asked = true; /* by a drawing before */
    }
    return called_list_kept(kept, keep_faces(&canvas, &call, kept), part);
}

/* Those that your place_face() places. */
static struct shown called_kept_of_placed(enum cull cull, enum called_kept_part part) {
    static struct kept_face kept[CALLED_FACES];
    const struct draw_call call = called_call_of(cull);
    size_t count = 0;
    for (size_t i = 0; i < CALLED_FACES; i++) {
        struct kept_face *k = &kept[count];
        const struct fixed2 *at = k->placed.position;
        *k = (struct kept_face){.face = i};
        count += place_face(&call, i, &k->placed) &&
                 edges_setup(&k->edges, at[0], at[1], at[2], CALLED_ACROSS, CALLED_UP) &&
                 cull != (k->edges.clockwise ? CULL_BACK : CULL_FRONT);
    }
    return called_list_kept(kept, count, part);
}

/* The triangle of 9a.2, or a lower one, over 3 pixels a row. */
static void called_keep_triangle(struct kept_face *kept, size_t face, double depth, int top,
                                 double recip_w, int height) {
    *kept = (struct kept_face){
        .face = face,
        .placed = {.position = {{0, 0}, {2048, 0}, {0, top}},
                   .depth = {depth, depth + 8, depth},
                   .recip_w = {1, recip_w, 1}},
    };
    const struct fixed2 *corner = kept->placed.position;
    edges_setup(&kept->edges, corner[0], corner[1], corner[2], CALLED_WIDTH, (size_t)height);
}

/* The numbers, or the depths, of a band after a face with number 7 is drawn. */
static struct shown called_covered(struct span rows, bool depths, double before) {
    double depth[CALLED_WIDTH * CALLED_HEIGHT], shown[CALLED_WIDTH * CALLED_HEIGHT];
    uint32_t nearest[CALLED_WIDTH * CALLED_HEIGHT] = {0};
    const struct band band = {rows, CALLED_WIDTH, depth, nearest};
    struct kept_face kept;
    called_keep_triangle(&kept, 0, 0, 2048, 4, CALLED_HEIGHT);
    for (int i = 0; i < CALLED_WIDTH * CALLED_HEIGHT; i++) {
        depth[i] = before;
    }
    cover_face(&band, &kept, 7);
    for (int i = 0; i < CALLED_WIDTH * CALLED_HEIGHT; i++) {
        shown[i] = depths ? depth[i] : nearest[i];
    }
    return called_in_rows(shown, CALLED_WIDTH * (rows.end - rows.begin));
}

/* The depths of row 1 as a band, after a face whose depth is 0.5 in row 0 and 1.5 in row 1. */
static struct shown called_covered_upwards(void) {
    double depth[CALLED_WIDTH];
    uint32_t nearest[CALLED_WIDTH] = {0};
    const struct band band = {{1, 2}, CALLED_WIDTH, depth, nearest};
    struct kept_face kept;
    called_keep_triangle(&kept, 0, 0, 2048, 4, CALLED_HEIGHT);
    kept.placed.depth[1] = 0;
    kept.placed.depth[2] = 8;
    depth_clear(depth, CALLED_WIDTH);
    cover_face(&band, &kept, 7);
    return called_in_rows(depth, CALLED_WIDTH);
}

/* How often each function of the shader below was called. */
static int called_corners, called_pixels;

enum { CALLED_A = 3, CALLED_B = 4 }; /* faces of a model, kept as 0 and 1 */

/* Varying 1 is 0, 80 and 160 at the corners of face A, and 100 more in face B. */
static void called_counting_vertex(const void *u, size_t face, size_t corner, double *varyings) {
    (void)u;
    varyings[0] = 200;
    varyings[1] = 80 * (double)corner + 100 * ((double)face - CALLED_A);
    called_corners++;
}

static bool called_counting_pixel(const void *u, const double *varyings, struct vec3 *rgb) {
    called_pixels++;
    return called_grey_pixel(u, varyings, rgb);
}

/* Two such faces, B nearer, by shade_band() in these rows of 3 x 2 pixels: in its first row it
 * finds A, none and A, in its second one none, B and A. The greys, or the calls. */
static struct shown called_shaded_band(struct span rows, double recip_w,
                                       called_pixel_function *pixel, enum called_part part) {
    uint32_t nearest[CALLED_WIDTH * CALLED_HEIGHT] = {1, 0, 1, 0, 2, 1};
    struct image image = black_image(CALLED_WIDTH, CALLED_HEIGHT);
    const struct canvas canvas = {&image, NULL};
    const struct simple_shader shader = {2, called_counting_vertex, pixel};
    const struct band band = {rows, CALLED_WIDTH, NULL, nearest};
    struct kept_face kept[3] = {{0}}; /* the last for a number that is taken for an index */
    called_keep_triangle(&kept[0], CALLED_A, 0, 2048, recip_w, CALLED_HEIGHT);
    called_keep_triangle(&kept[1], CALLED_B, 1, 2048, recip_w, CALLED_HEIGHT);
    called_corners = called_pixels = 0;
    shade_band(&canvas, &band, kept, &shader, NULL);
    const struct shown reds = called_reds(&image);
    return part == CALLED_GREYS ? reds
                                : show("%d corners, %d pixels", called_corners, called_pixels);
}

/* visible_draw(), or the same by your cover_face() and shade_band(). */
static void called_draw_bands(bool by_parts, const struct canvas *canvas, struct band band,
                              struct kept_face *kept, const struct simple_shader *shader) {
    const int step = band.rows.end, height = (int)canvas->image->height;
    if (!by_parts) {
        visible_draw(canvas, band, kept, 2, shader, NULL);
        return;
    }
    for (int y = 0; y < height; y += step) {
        band.rows = (struct span){y, y + step < height ? y + step : height};
        band_clear(&band);
        cover_face(&band, &kept[0], 1);
        cover_face(&band, &kept[1], 2);
        shade_band(canvas, &band, kept, shader, NULL);
    }
}

/* Both faces over 3 pixels a row, where B reaches over row 0 only, in bands of that many rows:
 * the greys, the calls, or how many rows of the memory for bands are written, with what is behind
 * it. */
static struct shown called_drawn_visibly(bool by_parts, int height, int band_rows,
                                         enum called_part part) {
    enum { CALLED_MEMORY = 6 };
    double depth[CALLED_WIDTH * CALLED_MEMORY];
    uint32_t nearest[CALLED_WIDTH * CALLED_MEMORY];
    struct image image = black_image(CALLED_WIDTH, (size_t)height);
    const struct canvas canvas = {&image, depth};
    const struct simple_shader shader = {2, called_counting_vertex, called_counting_pixel};
    const struct band band = {{0, band_rows}, CALLED_WIDTH, depth, nearest};
    struct kept_face kept[3] = {{0}}; /* the last for a number that is taken for an index */
    int rows = 0;
    called_keep_triangle(&kept[0], CALLED_A, 0, 2048, 1, height);
    called_keep_triangle(&kept[1], CALLED_B, 1, 307, 1, height);
    called_corners = called_pixels = 0;
    for (int i = 0; i < CALLED_WIDTH * CALLED_MEMORY; i++) {
        depth[i] = 99;
        nearest[i] = 2; /* a face that there is: no crash where it is read too early */
    }
    called_draw_bands(by_parts, &canvas, band, kept, &shader);
    for (int i = 0; i < CALLED_WIDTH * CALLED_MEMORY; i++) {
        rows = nearest[i] == 2 && depth[i] == 99 ? rows : i / CALLED_WIDTH + 1;
    }
    const struct shown reds = called_reds(&image);
    return part == CALLED_GREYS   ? reds
           : part == CALLED_CALLS ? show("%d corners, %d pixels", called_corners, called_pixels)
                                  : show("%d", rows);
}

#define PLACED(face, part, name, right)                                                            \
    TEXT("9a.1", "place_face(call, " #face ", placed)" name, called_placed(face, part), right)
#define DRAWN(name, part, before, recip_w, view, pixel, right)                                     \
    TEXT("9a.2", "draw_pixels() " name, called_drawn(part, before, recip_w, view, pixel), right)
/* A row of a task that has your place_face() place its faces: it's right where these aren't
 * whole. */
#define PLACED_BY_YOU(task, name, call, right, own)                                                \
    TEXT_WITH(task, name, called_places_whole_faces() ? (call) : show("-"), right,                 \
              called_places_whole_faces() ? (own) : show("-"))
#define ASKED(cull, right)                                                                         \
    PLACED_BY_YOU("9a.3+9a.1", "simple_draw(), " #cull, called_asked_by_draw(cull), right,         \
                  called_asked_of_placed(cull))
#define PIXEL(task, pixel, a, right)                                                               \
    AS_VECTOR(task, #pixel "(" #a ")", vec3, called_pixel_of(pixel, called_uniforms, a, 0, 0),     \
              right)
#define TOON(a, right, level)                                                                      \
    TEXT_WITH("9c.2", "toon_fragment(" #a ")", called_in_lanes(toon_fragment, a, 0, 0), right,     \
              IN_LANES(called_shade_in, 255, 155, 0, level))
/* A map of one colour. */
#define MAPPED_PIXEL(rgb, right)                                                                   \
    TEXT_WITH("9b.5", "normal_map_pixel() of " #rgb, called_mapped_pixel(called_mapped rgb),       \
              right, called_grey_in_light rgb)
#define MAPPED_FRAGMENT(rgb, right)                                                                \
    TEXT_WITH("9c.3", "normal_map_fragment() of " #rgb, called_mapped_in_lanes rgb, right,         \
              called_shaded_grey rgb)
#define KEPT(name, cull, part, right)                                                              \
    PLACED_BY_YOU("9d.1+9a.1", "keep_faces(), " name, called_kept(cull, part), right,              \
                  called_kept_of_placed(cull, part))
#define COVERED(name, begin, depths, before, right)                                                \
    TEXT("9d.2", "cover_face() " name, called_covered((struct span){begin, 2}, depths, before),    \
         right)
#define SHADED(name, begin, recip_w, pixel, part, right)                                           \
    TEXT("9d.3", "shade_band() of 1 0 1 / 0 2 1" name,                                             \
         called_shaded_band((struct span){begin, 2}, recip_w, pixel, part), right)
#define VISIBLE(name, height, rows, part, right)                                                   \
    TEXT_WITH("9d.4+9d.2,9d.3", "visible_draw() in bands of " name,                                \
              called_drawn_visibly(false, height, rows, part), right,                              \
              called_drawn_visibly(true, height, rows, part))

static void numbers(void) {
    const double none = -INFINITY;
    const struct rectangle all = {0, 0, CALLED_WIDTH, CALLED_HEIGHT}, low = {0, 0, 2, 1},
                           last = {2, 1, 1, 1};
    if (!called_make_textures()) {
        return;
    }
    PLACED(0, CALLED_POSITION, ", position", "(60.5, 45.5) (111, -5.5) (85.75, 58.25)");
    PLACED(0, CALLED_DEPTH, ", depth", "(0, 2, -1)");
    PLACED(0, CALLED_RECIP_W, ", recip_w", "(1, 2, 0.5)");
    PLACED(1, CALLED_POSITION, "", "false");
    PLACED(2, CALLED_POSITION, "", "false");
    PLACED(3, CALLED_POSITION, "", "false");
    PLACED(6, CALLED_DEPTH, ", from far away to the eye: depth", "(-1.6364, 398, -1)");
    DRAWN("on 3 x 2 pixels", CALLED_GREYS, none, 1, all, called_grey_pixel, "15 25 35 / 35 45 55");
    DRAWN("of four varyings, the first pixel", CALLED_COLOR, none, 1, all, called_color_pixel,
          "15,30,45");
    DRAWN("in perspective", CALLED_GREYS, none, 4, all, called_grey_pixel, "25 45 57 / 42 58 67");
    DRAWN("over depths of 1.5", CALLED_GREYS, 1.5, 1, all, called_grey_pixel, "0 0 35 / 0 0 55");
    DRAWN("over depths of 1, depths", CALLED_DEPTHS, 1, 4, all, called_grey_pixel,
          "1 1.5 2.5 / 1 1.5 2.5");
    DRAWN("in a viewport of 2 x 1 pixels", CALLED_GREYS, none, 1, low, called_grey_pixel,
          "15 25 0 / 0 0 0");
    DRAWN("in a viewport of the last pixel, depths", CALLED_DEPTHS, 0, 1, last, called_grey_pixel,
          "0 0 0 / 0 0 2.5");
    DRAWN("that discards", CALLED_GREYS, none, 1, all, called_light_pixel, "0 0 35 / 35 45 55");
    DRAWN("that discards, depths", CALLED_DEPTHS, 0, 1, all, called_light_pixel,
          "0 0 2.5 / 0.5 1.5 2.5");
    ASKED(CULL_BACK, "0:012 4:012");
    ASKED(CULL_FRONT, "5:012");
    ASKED(CULL_NONE, "0:012 4:012 5:012");
    PLACED_BY_YOU("9a.3+9a.1", "simple_draw(), varyings 0, 100, 200: at (100, 50) and (61, 60)",
                  called_face_greys(false), "59 60", called_face_greys(true));
    REAL("9b.1", lambert(xyz(0, 0, 2), xyz(0.6, 0, 0.8)), 0.8);
    REAL("9b.1", lambert(xyz(3, 0, 4), xyz(0.6, 0, 0.8)), 1);
    REAL("9b.1", lambert(xyz(0, 0, -2), xyz(0.6, 0, 0.8)), 0);
    PIXEL("9b.2", white_pixel, 0.5, xyz(127.5, 127.5, 127.5));
    TEXT_WITH("9b.2", "flat_vertex(face of normal (0, 0, 4))",
              called_first_varyings(flat_vertex, CALLED_FRONT, 1, 1), "0.8",
              called_light_on(xyz(0, 0, 4)));
    TEXT_WITH("9b.2", "flat_vertex(face of normal (0, 0, 4)), then in the light (0, 0, 1)",
              called_flat_again(CALLED_FRONT), "1",
              show("%.5g", lambert(xyz(0, 0, 4), xyz(0, 0, 1))));
    TEXT_WITH("9b.2", "flat_vertex(face of normal (0, 0, -4))",
              called_first_varyings(flat_vertex, CALLED_BACK, 1, 1), "0",
              called_light_on(xyz(0, 0, -4)));
    TEXT_WITH("9b.2", "gouraud_vertex(corner of normal (2, 0, 0))",
              called_first_varyings(gouraud_vertex, CALLED_FRONT, 1, 1), "0.6",
              called_light_on(xyz(2, 0, 0)));
    TEXT("9b.3", "uv_vertex(corner of uv (0.25, 0.75))",
         called_first_varyings(uv_vertex, CALLED_FRONT, 1, 2), "(0.25, 0.75)");
    AS_VECTOR("9b.3", "textured_pixel(0.5, 0.25, 0.6)", vec3,
              called_pixel_of(textured_pixel, called_uniforms, 0.5, 0.25, 0.6),
              xyz(120.3, 60.3, 30.3));
    AS_VECTOR("9b.3", "textured_pixel(0.5, 0.25, 0.6), grey 100 at the texture's level", vec3,
              called_pixel_of(textured_pixel, called_at_levels(), 0.5, 0.25, 0.6), xyz(60, 60, 60));
    PIXEL("9b.4", toon_pixel, 0.8001, xyz(255, 155, 0));
    PIXEL("9b.4", toon_pixel, 0.8, xyz(255, 155, 0));
    PIXEL("9b.4", toon_pixel, 0.7999, xyz(191.25, 116.25, 0));
    PIXEL("9b.4", toon_pixel, 0.1999, xyz(0, 0, 0));
    PIXEL("9b.4", toon_pixel, 1, xyz(255, 155, 0));
    MAPPED_PIXEL((255, 128, 128), "29,29,29");
    MAPPED_PIXEL((128, 255, 128), "43,43,43");
    MAPPED_PIXEL((128, 128, 255), "86,86,86");
    TEXT_WITH("9b.5", "normal_map_pixel(), grey 100 and normal (0, 0, 1) at their levels",
              called_mapped_pixel(called_at_levels()), "86,86,86",
              called_grey_in_light(128, 128, 255));
    TEXT("9b.6", "two_sided_vertex(face of normal (0, 0, 4))",
         called_first_varyings(two_sided_vertex, CALLED_FRONT, 1, 1), "0.8");
    TEXT("9b.6", "two_sided_vertex(face of normal (0, 0, -4))",
         called_first_varyings(two_sided_vertex, CALLED_BACK, 1, 1), "0.8");
    TEXT("9b.6", "two_sided_vertex(face of normal (0, 0, 4)) in the light (0.6, 0, -0.8)",
         called_lit_from_behind(), "0.8");
    TEXT("9b.7", "lit_only_pixel(0)", show_truth(called_is_drawn(lit_only_pixel, 0)), "false");
    TEXT("9b.7", "lit_only_pixel(0.001)", show_truth(called_is_drawn(lit_only_pixel, 0.001)),
         "true");
    TEXT("9c.1", "shade((200, 100, 50), 0.6)", IN_LANES(called_shade_in, 200, 100, 50, 0.6),
         "120,60,30");
    TEXT("9c.1", "shade((200, 100, 50), 0.333)", IN_LANES(called_shade_in, 200, 100, 50, 0.333),
         "67,33,17");
    TEXT("9c.1", "white_fragment(0.6)", called_in_lanes(white_fragment, 0.6, 0, 0), "153,153,153");
    TEXT("9c.1", "textured_fragment(0.5, 0.25, 0.6)",
         called_in_lanes(textured_fragment, 0.5, 0.25, 0.6), "120,60,30");
    TEXT("9c.1", "textured_fragment(0.5, 0.25, 0.6), grey 100 at the texture's level",
         IN_LANES(called_textured_at_level_in, 0.5, 0.25, 0.6), "60,60,60");
    TOON(0.8001, "255,155,0", 1);
    TOON(0.8, "255,155,0", 1);
    TOON(0.7999, "191,116,0", 0.75);
    TOON(0.1999, "0,0,0", 0);
    TOON(1, "255,155,0", 1);
    TEXT("9c.3", "lambert_lanes((0, 0, 2), (0.6, 0, 0.8))", IN_LANES(called_light_in, 0, 0, 2),
         "0.8");
    TEXT("9c.3", "lambert_lanes((0, 0, -2), (0.6, 0, 0.8))", IN_LANES(called_light_in, 0, 0, -2),
         "0");
    MAPPED_FRAGMENT((255, 128, 128), "29,29,29");
    MAPPED_FRAGMENT((128, 255, 128), "43,43,43");
    MAPPED_FRAGMENT((128, 128, 255), "86,86,86");
    TEXT_WITH("9c.3", "normal_map_fragment(), grey 100 and normal (0, 0, 1) at their levels",
              IN_LANES(called_mapped_at_levels_in, 0.5, 0.25, 0.6), "86,86,86",
              called_shaded_grey(128, 128, 255));
    TEXT("9c.4", "lit_only_fragment(0)", called_in_lanes(lit_only_fragment, 0, 0, 0), "false");
    TEXT("9c.4", "lit_only_fragment(0.001)", called_in_lanes(lit_only_fragment, 0.001, 0, 0),
         "true");
    KEPT("CULL_NONE", CULL_NONE, CALLED_NUMBERS, "0 4 5");
    KEPT("CULL_BACK", CULL_BACK, CALLED_NUMBERS, "0 4");
    KEPT("CULL_FRONT", CULL_FRONT, CALLED_NUMBERS, "5");
    KEPT("CULL_BACK: are they asked", CULL_BACK, CALLED_NOT_ASKED, "no no");
    KEPT("CULL_BACK: rows of 128 x 80 pixels", CULL_BACK, CALLED_ROWS_OF, "0-59 45-80");
    COVERED("with number 7: numbers", 0, false, none, "7 7 7 / 7 7 7");
    COVERED("over depth 1: numbers", 0, false, 1, "0 7 7 / 0 7 7");
    COVERED("over depth 1: depths", 0, true, 1, "1 1.5 2.5 / 1 1.5 2.5");
    COVERED("over depth 1.5: numbers", 0, false, 1.5, "0 0 7 / 0 0 7");
    COVERED("in a band of row 1: numbers", 1, false, 1, "0 7 7");
    TEXT("9d.2", "cover_face() in a band of row 1, where each row is nearer: depths",
         called_covered_upwards(), "1.5 1.5 1.5");
    SHADED("", 0, 1, called_counting_pixel, CALLED_GREYS, "15 0 35 / 0 145 55");
    SHADED(", in perspective", 0, 4, called_counting_pixel, CALLED_GREYS, "25 0 57 / 0 158 67");
    SHADED(", which discards", 0, 1, called_light_pixel, CALLED_GREYS, "0 0 35 / 0 145 55");
    SHADED(": row 1 alone", 1, 1, called_counting_pixel, CALLED_GREYS, "0 0 0 / 35 0 55");
    SHADED(": calls", 0, 1, called_counting_pixel, CALLED_CALLS, "6 corners, 4 pixels");
    VISIBLE("1 row", CALLED_HEIGHT, 1, CALLED_GREYS, "172 182 192 / 35 45 55");
    VISIBLE("1 row: calls", CALLED_HEIGHT, 1, CALLED_CALLS, "6 corners, 6 pixels");
    VISIBLE("1 row: rows of memory", CALLED_HEIGHT, 1, CALLED_ROWS, "1");
    VISIBLE("2 rows, the last band cut", 3, 2, CALLED_GREYS, "172 182 192 / 35 45 55 / 55 65 75");
    VISIBLE("2 rows, the last band cut: calls", 3, 2, CALLED_CALLS, "6 corners, 9 pixels");
    VISIBLE("4 rows, of 2 that there are", CALLED_HEIGHT, 4, CALLED_GREYS,
            "172 182 192 / 35 45 55");
    VISIBLE("4 rows, of 2 that there are: rows of memory", CALLED_HEIGHT, 4, CALLED_ROWS, "2");
}
