/* Lesson 9: what its shaders compute at a corner and at a pixel. */
#define LESSON "../step09_shaders/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

struct shader_case {
    struct one_face face;
    struct vec3 to_light;
    struct picture diffuse, normal_map;
    struct vec2 uv;
    double intensity;
};

static void make_shader_case(struct random *random, uint64_t index, void *made) {
    struct shader_case *c = made;
    make_face(random, index, &c->face);
    make_picture(random, &c->diffuse);
    make_picture(random, &c->normal_map);
    c->to_light = random_direction(random);
    c->uv = random_uv(random);
    c->intensity =
        index % 4 == 0 ? (double)random_between(random, -1, 6) / 5 : random_real(random, -0.2, 1.2);
}

/* ---- At the corners ---- */

static long double positive(long double a) {
    return a > 0 ? a : 0;
}

/* Each vertex function, at each corner of the face. */
static bool corners_are_right(const void *tried) {
    struct shader_case c = *(const struct shader_case *)tried;
    struct model model = model_of(&c.face);
    const struct uniforms u = {.model = &model, .to_light = c.to_light};
    struct real3 light = real3_from(c.to_light);
    long double uncertainty;
    long double cosine = real3_dot(real3_unit(face_cross(&c.face, &uncertainty)), light);
    long double slack = 16 * 0x1p-53L * (1 + uncertainty);
    bool right = true;
    for (size_t i = 0; i < 3 && right; i++) {
        long double smooth = real3_dot(face_normal(&c.face, i), light);
        double v[9] = {0}, gu = (double)c.face.uv[i][0], gv = (double)c.face.uv[i][1];
        flat_vertex(&u, 0, i, v);
        gouraud_vertex(&u, 0, i, v + 1);
        flat_textured_vertex(&u, 0, i, v + 2);
        gouraud_textured_vertex(&u, 0, i, v + 5);
        two_sided_vertex(&u, 0, i, v + 8);
        right = is_near(v[0], positive(cosine), slack) && !signbit(v[0]) &&
                is_near(v[1], positive(smooth), 1e-15L) && !signbit(v[1]) && v[2] == gu &&
                v[3] == gv && v[4] == v[0] && v[5] == gu && v[6] == gv && v[7] == v[1] &&
                is_near(v[8], fabsl(cosine), slack);
    }
    return right;
}

/* ---- The corners on the screen ---- */

/* Seen from a place that may be inside or behind the face. */
static bool face_is_placed(const void *tried) {
    struct shader_case c = *(const struct shader_case *)tried;
    struct model model = model_of(&c.face);
    const struct rectangle view = {7, 5, 300, 200};
    const struct draw_call call =
        camera_call(&model, vec3_scale(c.to_light, 2), (struct vec3){0, 0, 0},
                    (struct vec3){0, 1, 0}, 1, view, CULL_NONE);
    struct placed_face placed;
    bool in_front = true, far_away = false, too_near = false, right = true;
    bool is_placed = place_face(&call, 0, &placed);
    for (size_t i = 0; i < 3; i++) {
        struct vec4 clip = mat4_point(&call.to_clip, c.face.position[i]);
        long double w = clip.w, x = view.x + (clip.x / w + 1) * view.width / 2;
        long double y = view.y + (clip.y / w + 1) * view.height / 2;
        too_near = too_near || fabsl(w) < 1e-9L; /* in front of the eye or behind it */
        in_front = in_front && w > 0;
        far_away = far_away || fabsl(x) > SCREEN_LIMIT - 1 || fabsl(y) > SCREEN_LIMIT - 1;
        right =
            right && (!is_placed ||
                      (is_snapped(placed.position[i].x, x) && is_snapped(placed.position[i].y, y) &&
                       is_near(placed.depth[i], clip.z / w, 1e-12L * fabsl(clip.z / w)) &&
                       is_near(placed.recip_w[i], 1 / w, 1e-12L / w)));
    }
    return too_near || (is_placed ? in_front && right : !in_front || far_away);
}

/* ---- At the pixels ---- */

/* A look: its two functions of a pixel, and the exact colours of which one is right. */
struct look {
    bool (*pixel)(const void *uniforms, const double *varyings, struct vec3 *rgb);
    fragment_function *fragment;
    const double *varyings;
    size_t varying_count;
    struct real3 exact[2];
    long double roundings;
    bool drawn;
};

/* What simple_draw() calls is in double, so nearly exact before the rounding to 0..255; only a
 * normal of next to no length leaves little. */
static bool look_is_right(const struct look *look, const struct uniforms *u) {
    struct pixel_color got = shade_pixel(look->fragment, u, look->varyings, look->varying_count);
    struct vec3 rgb;
    bool drawn = look->pixel(u, look->varyings, &rgb), near = false, right = false;
    for (int i = 0; i < 2; i++) {
        struct real3 exact = look->exact[i];
        right = right || color_is_near(got.color, exact, look->roundings);
        near = near || (is_near(rgb.x, exact.x, 1e-9L) && is_near(rgb.y, exact.y, 1e-9L) &&
                        is_near(rgb.z, exact.z, 1e-9L));
    }
    return drawn == look->drawn && got.drawn == look->drawn &&
           (!drawn || (right && (near || look->roundings > 1e5L)));
}

/* One of five steps; on the border of two either is right. */
static struct real3 exact_orange(double intensity, int side) {
    const struct real3 orange = {255, 155, 0};
    long double step = floorl(5 * (long double)intensity + side * real_slack(16));
    return real3_scale(orange, (step < 4 ? step : 4) / 4);
}

static bool looks_are_right(const struct shader_case *c, const struct texture *diffuse,
                            const struct texture *normal_map) {
    const struct uniforms u = {.diffuse = diffuse,
                               .normal_map = normal_map,
                               .diffuse_level = c->diffuse.level,
                               .normal_level = c->normal_map.level,
                               .to_light = c->to_light};
    const double *one = &c->intensity, three[3] = {c->uv.x, c->uv.y, c->intensity};
    long double roundings;
    struct real3 normal = exact_normal(normal_map, c->normal_map.level, c->uv, &roundings);
    struct real3 texel = exact_color(diffuse, c->diffuse.level, c->uv);
    struct real3 textured = real3_scale(texel, c->intensity);
    struct real3 mapped = real3_scale(texel, positive(real3_dot(normal, real3_from(c->to_light))));
    struct real3 white = real3_scale((struct real3){255, 255, 255}, c->intensity);
    struct real3 below = exact_orange(*one, -1), above = exact_orange(*one, 1);
    const struct look looks[] = {
        {white_pixel, white_fragment, one, 1, {white, white}, 4, true},
        {lit_only_pixel, lit_only_fragment, one, 1, {white, white}, 4, *one > 0},
        {toon_pixel, toon_fragment, one, 1, {below, above}, 4, true},
        {textured_pixel, textured_fragment, three, 3, {textured, textured}, TEXEL_ROUNDINGS, true},
        {normal_map_pixel,
         normal_map_fragment,
         three,
         3,
         {mapped, mapped},
         TEXEL_ROUNDINGS + roundings,
         true},
    };
    bool right = true;
    for (size_t i = 0; i < sizeof looks / sizeof looks[0]; i++) {
        right = right && look_is_right(&looks[i], &u);
    }
    return right;
}

static bool pixels_are_right(const void *tried) {
    const struct shader_case *c = tried;
    struct texture diffuse = {0}, normal_map = {0};
    bool right = texture_of_picture(&c->diffuse, &diffuse) &&
                 texture_of_picture(&c->normal_map, &normal_map) &&
                 looks_are_right(c, &diffuse, &normal_map);
    texture_free(&diffuse);
    texture_free(&normal_map);
    return right;
}

const struct property lesson09_properties[] = {
    PROPERTY("lesson09: at the corners", AGAINST_LONG_DOUBLE, 200000, struct shader_case,
             make_shader_case, .holds = corners_are_right),
    PROPERTY("lesson09: corners on the screen", AGAINST_LONG_DOUBLE, 100000, struct shader_case,
             make_shader_case, .holds = face_is_placed),
    PROPERTY("lesson09: at the pixels", AGAINST_LONG_DOUBLE, 200000, struct shader_case,
             make_shader_case, .holds = pixels_are_right),
    {.name = NULL},
};
