/* Step 9: what its shaders compute at a corner and at a pixel. */
#define LESSON "../step09_shaders/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <stdio.h>

struct shader_case {
    struct mesh_data mesh;
    struct vec3 to_light;
    struct picture_data diffuse, normal_map;
    size_t diffuse_level, normal_level;
    struct vec2 uv;
    double intensity;
};

static void make_shader_case(struct random *random, uint64_t index, void *made) {
    struct shader_case *c = made;
    for (int i = 0; i < 3; i++) {
        c->mesh.position[i] = random_vector(random, 2);
        mesh_set(c->mesh.normal[i], random_vector(random, index % 2 ? 1 : 60));
        c->mesh.uv[i][0] = (float)random_real(random, -1, 2);
        c->mesh.uv[i][1] = (float)random_real(random, -1, 2);
    }
    if (index % 32 == 0) { /* no area */
        c->mesh.position[2] = c->mesh.position[1];
    }
    c->to_light = random_direction(random);
    make_picture(random, &c->diffuse);
    make_picture(random, &c->normal_map);
    c->diffuse_level = (size_t)random_between(random, 0, PICTURE_LEVELS - 1);
    c->normal_level = (size_t)random_between(random, 0, PICTURE_LEVELS - 1);
    c->uv = (struct vec2){random_real(random, -0.2, 1.2), random_real(random, -0.2, 1.2)};
    c->intensity =
        index % 4 == 0 ? (double)random_between(random, -1, 6) / 5 : random_real(random, -0.2, 1.2);
}

/* ---- At the corners ---- */

static long double positive(long double a) {
    return a > 0 ? a : 0;
}

/* In ulp of 1; the clamped half must be 0 itself. */
static double lambert_error(const void *tried) {
    const struct shader_case *c = tried;
    struct real3 normal = mesh_get(c->mesh.normal[0]);
    double got =
        lambert((struct vec3){(double)normal.x, (double)normal.y, (double)normal.z}, c->to_light);
    long double cosine = real3_dot(real3_unit(normal), real3_from(c->to_light));
    if (cosine < -1e-15L && (got != 0 || signbit(got))) {
        return INFINITY;
    }
    return (double)fabsl(positive(cosine) - (long double)got) * 0x1p52;
}

static bool is_near(double got, long double exact, long double slack) {
    return fabsl(exact - (long double)got) <= slack;
}

/* Each vertex function, at each corner of the face. */
static bool corners_are_right(const void *tried) {
    struct shader_case c = *(const struct shader_case *)tried;
    struct mesh mesh;
    mesh_from(&mesh, &c.mesh, 1);
    const struct uniforms u = {.model = &mesh.model, .to_light = c.to_light};
    struct real3 first = real3_from(c.mesh.position[0]), light = real3_from(c.to_light);
    struct real3 a = real3_sub(real3_from(c.mesh.position[1]), first);
    struct real3 b = real3_sub(real3_from(c.mesh.position[2]), first);
    struct real3 face_normal = real3_cross(a, b);
    long double area = real3_length(face_normal);
    long double cosine = area > 0 ? real3_dot(face_normal, light) / area : 0;
    /* The direction of a sliver is less certain. */
    long double slack =
        16 * 0x1p-53L * (1 + (area > 0 ? real3_length(a) * real3_length(b) / area : 0));
    for (size_t i = 0; i < 3; i++) {
        long double smooth = real3_dot(real3_unit(mesh_get(c.mesh.normal[i])), light);
        double v[10] = {0};
        flat_vertex(&u, 0, i, v);
        gouraud_vertex(&u, 0, i, v + 1);
        flat_textured_vertex(&u, 0, i, v + 2);
        gouraud_textured_vertex(&u, 0, i, v + 5);
        two_sided_vertex(&u, 0, i, v + 8);
        bool same_uv = v[2] == (double)c.mesh.uv[i][0] && v[3] == (double)c.mesh.uv[i][1] &&
                       v[5] == v[2] && v[6] == v[3];
        if (!(same_uv && is_near(v[0], positive(cosine), slack) &&
              is_near(v[1], positive(smooth), 1e-15L) && v[4] == v[0] && v[7] == v[1] &&
              is_near(v[8], fabsl(cosine), slack))) {
            return false;
        }
    }
    return true;
}

/* ---- At the pixels ---- */

/* Orange in five steps; on the border of two either is right. */
static bool toon_is_right(double intensity) {
    struct pixel_color pixel = shade_pixel(toon_fragment, NULL, &intensity, 1);
    bool right = false;
    for (int side = -1; side <= 1; side += 2) {
        long double step = floorl(5 * (long double)intensity + side * 16 * real_ulp);
        struct real3 orange = {255, 155, 0};
        right =
            right || color_is_near(pixel.color, real3_scale(orange, (step < 4 ? step : 4) / 4), 4);
    }
    return pixel.drawn && right;
}

static bool white_is_right(double intensity) {
    long double level = 255 * (long double)intensity;
    struct real3 exact = {level, level, level};
    struct pixel_color white = shade_pixel(white_fragment, NULL, &intensity, 1);
    struct pixel_color lit = shade_pixel(lit_only_fragment, NULL, &intensity, 1);
    return white.drawn && color_is_near(white.color, exact, 4) && lit.drawn == (intensity > 0) &&
           (!lit.drawn || color_is_near(lit.color, exact, 4));
}

static bool textures_are_right(const struct shader_case *c, const struct texture *diffuse,
                               const struct texture *normal_map) {
    const struct uniforms u = {.diffuse = diffuse,
                               .normal_map = normal_map,
                               .diffuse_level = c->diffuse_level,
                               .normal_level = c->normal_level,
                               .to_light = c->to_light};
    const double varyings[3] = {c->uv.x, c->uv.y, c->intensity};
    struct real3 texel = exact_color(diffuse, c->diffuse_level, c->uv);
    struct real3 normal = exact_normal(normal_map, c->normal_level, c->uv);
    long double cosine = real3_dot(normal, real3_from(c->to_light));
    struct pixel_color textured = shade_pixel(textured_fragment, &u, varyings, 3);
    struct pixel_color mapped = shade_pixel(normal_map_fragment, &u, varyings, 3);
    return textured.drawn &&
           color_is_near(textured.color, real3_scale(texel, c->intensity), TEXEL_ROUNDINGS) &&
           mapped.drawn &&
           color_is_near(mapped.color, real3_scale(texel, positive(cosine)),
                         TEXEL_ROUNDINGS + normal_roundings(normal_map, c->normal_level, c->uv));
}

/* What simple_draw() calls: in double, so nearly exact before the rounding to 0..255. */
static bool rgb_is_near(struct vec3 rgb, struct real3 exact) {
    return is_near(rgb.x, exact.x, 1e-9L) && is_near(rgb.y, exact.y, 1e-9L) &&
           is_near(rgb.z, exact.z, 1e-9L);
}

static bool simple_pixels_are_right(const struct shader_case *c, const struct texture *diffuse,
                                    const struct texture *normal_map) {
    const struct uniforms u = {.diffuse = diffuse,
                               .normal_map = normal_map,
                               .diffuse_level = c->diffuse_level,
                               .normal_level = c->normal_level,
                               .to_light = c->to_light};
    const double varyings[3] = {c->uv.x, c->uv.y, c->intensity}, step = floor(5 * c->intensity);
    struct real3 texel = exact_color(diffuse, c->diffuse_level, c->uv), white = {255, 255, 255};
    struct real3 orange = {255, 155, 0}, normal = exact_normal(normal_map, c->normal_level, c->uv);
    long double cosine = real3_dot(normal, real3_from(c->to_light));
    struct vec3 plain, sampled, stepped, mapped, lit;
    bool drawn = white_pixel(&u, &c->intensity, &plain) && textured_pixel(&u, varyings, &sampled) &&
                 toon_pixel(&u, &c->intensity, &stepped) && normal_map_pixel(&u, varyings, &mapped);
    return drawn && lit_only_pixel(&u, &c->intensity, &lit) == (c->intensity > 0) &&
           rgb_is_near(plain, real3_scale(white, c->intensity)) &&
           rgb_is_near(sampled, real3_scale(texel, c->intensity)) &&
           rgb_is_near(stepped, real3_scale(orange, (step < 4 ? step : 4) / 4)) &&
           (normal_roundings(normal_map, c->normal_level, c->uv) > 1e5L ||
            rgb_is_near(mapped, real3_scale(texel, positive(cosine))));
}

/* The corners of a face on the screen, seen from a place that may be inside or behind the face. */
static bool face_is_placed(const void *tried) {
    struct shader_case c = *(const struct shader_case *)tried;
    struct mesh mesh;
    mesh_from(&mesh, &c.mesh, 1);
    const struct rectangle view = {7, 5, 300, 200};
    const struct draw_call call =
        camera_call(&mesh.model, vec3_scale(c.to_light, 2), (struct vec3){0, 0, 0},
                    (struct vec3){0, 1, 0}, 1, view, CULL_NONE);
    const double(*m)[4] = call.to_clip.m;
    struct placed_face placed;
    bool in_front = true, far_away = false, right = true;
    for (size_t i = 0; i < 3; i++) {
        struct real3 p = real3_from(c.mesh.position[i]);
        long double clip[4];
        for (int k = 0; k < 4; k++) {
            clip[k] = m[k][0] * p.x + m[k][1] * p.y + m[k][2] * p.z + m[k][3];
        }
        if (fabsl(clip[3]) < 1e-9L) {
            return true; /* in front of the eye or behind it: too near to tell */
        }
        in_front = in_front && clip[3] > 0;
        long double x = view.x + (clip[0] / clip[3] + 1) * view.width / 2;
        long double y = view.y + (clip[1] / clip[3] + 1) * view.height / 2;
        far_away = far_away || fabsl(x) > SCREEN_LIMIT - 1 || fabsl(y) > SCREEN_LIMIT - 1;
    }
    if (place_face(&call, 0, &placed) != in_front) {
        return in_front && far_away;
    }
    for (size_t i = 0; in_front && i < 3; i++) {
        struct vec4 clip = mat4_point(&call.to_clip, c.mesh.position[i]);
        double x = view.x + (clip.x / clip.w + 1) * view.width / 2;
        double y = view.y + (clip.y / clip.w + 1) * view.height / 2;
        right = right && fabs(placed.position[i].x - x * SUBPIXELS) <= 0.51 &&
                fabs(placed.position[i].y - y * SUBPIXELS) <= 0.51 &&
                fabs(placed.depth[i] * clip.w - clip.z) <= 1e-12 * (1 + fabs(clip.z)) &&
                fabs(placed.recip_w[i] * clip.w - 1) <= 1e-12;
    }
    return right;
}

static bool pixels_are_right(const void *tried) {
    const struct shader_case *c = tried;
    struct texture diffuse = {0}, normal_map = {0};
    bool right = texture_of_picture(&c->diffuse, &diffuse) &&
                 texture_of_picture(&c->normal_map, &normal_map) &&
                 textures_are_right(c, &diffuse, &normal_map) &&
                 simple_pixels_are_right(c, &diffuse, &normal_map) &&
                 white_is_right(c->intensity) && toon_is_right(c->intensity);
    texture_free(&diffuse);
    texture_free(&normal_map);
    return right;
}

static void print_shader_case(const void *failing) {
    const struct shader_case *c = failing;
    for (int i = 0; i < 3; i++) {
        const struct vec3 p = c->mesh.position[i];
        const float *n = c->mesh.normal[i];
        printf("    v %.17g %.17g %.17g  vn %.9g %.9g %.9g\n", p.x, p.y, p.z, (double)n[0],
               (double)n[1], (double)n[2]);
    }
    printf("    to light %.17g %.17g %.17g, uv %.17g %.17g, mip levels %zu and %zu, intensity "
           "%.17g\n",
           c->to_light.x, c->to_light.y, c->to_light.z, c->uv.x, c->uv.y, c->diffuse_level,
           c->normal_level, c->intensity);
}

static const struct case_kind shader_cases = {sizeof(struct shader_case), make_shader_case,
                                              print_shader_case, NULL};

const struct property lesson09_properties[] = {
    PROPERTY("lesson09: light on a surface", AGAINST_LONG_DOUBLE, 200000, shader_cases,
             .error = lambert_error, .limit = 4, .error_unit = "ulp of 1"),
    PROPERTY("lesson09: at the corners", AGAINST_LONG_DOUBLE, 200000, shader_cases,
             .holds = corners_are_right),
    PROPERTY("lesson09: corners on the screen", AGAINST_LONG_DOUBLE, 100000, shader_cases,
             .holds = face_is_placed),
    PROPERTY("lesson09: at the pixels", AGAINST_LONG_DOUBLE, 200000, shader_cases,
             .holds = pixels_are_right),
    {.name = NULL},
};
