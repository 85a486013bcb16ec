/* Lesson 10's functions called with numbers. */
#ifndef LESSON
#define LESSON "../step10_phong/main.c"
#endif
#include "lane_numbers.h"

static struct lanes3 called_vector_in(int lane, const double *v) {
    return vector_in_one_lane(lane, xyz(v[0], v[1], v[2]));
}

/* ---- The technique ---- */

/* Base, power, largest power. */
static struct shown called_power_in(int lane, const double *v) {
    return show_lane(
        integer_power(in_one_lane(lane, v[0], 0.25), in_one_lane(lane, v[1], 0), (int)v[2]), lane);
}

/* Normal, to light. */
static struct shown called_reflect_in(int lane, const double *v) {
    return show_vector_lane(reflect(called_vector_in(lane, v), called_vector_in(lane, v + 3)),
                            lane);
}

/* Normal, to light, to eye, power. */
static struct lanes2 called_phong_lanes(int lane, const double *v) {
    return phong(called_vector_in(lane, v), called_vector_in(lane, v + 3),
                 called_vector_in(lane, v + 6), lanes_all((real)v[9]), (int)v[9]);
}

static struct shown called_diffuse_in(int lane, const double *v) {
    return show_lane(called_phong_lanes(lane, v).x, lane);
}

static struct shown called_specular_in(int lane, const double *v) {
    return show_lane(called_phong_lanes(lane, v).y, lane);
}

/* What your reflect() and integer_power() make of it, where your diffuse light is above 0. */
static struct shown called_specular_of(const double *v) {
    if (!(called_phong_lanes(0, v).x[0] > 0)) {
        return show("0");
    }
    lanes mirrored = lanes3_dot(reflect(called_vector_in(0, v), called_vector_in(0, v + 3)),
                                called_vector_in(0, v + 6));
    return show_lane(
        integer_power(lanes_max(mirrored, lanes_all(0)), lanes_all((real)v[9]), (int)v[9]), 0);
}

#define DIFFUSE(normal, light, right)                                                              \
    TEXT("10a.1", "phong(" #normal ", " #light ", ...).x",                                         \
         in_each_lane(called_diffuse_in, called_joined(xyz normal, xyz light, xyz(0, 0, 1), -1)),  \
         right)
/* Against an r that points the other way than it should, the eye is on the other side, too: what is
 * called shines, as it should. */
static const double *called_facing(double *v) {
    struct lanes3 r = reflect(called_vector_in(0, v), called_vector_in(0, v + 3));
    struct vec3 n = xyz(v[0], v[1], v[2]), l = xyz(v[3], v[4], v[5]), eye = xyz(v[6], v[7], v[8]);
    bool shines = 2 * vec3_dot(n, l) * vec3_dot(n, eye) - vec3_dot(l, eye) > 0;
    double way = shines && lanes3_dot(r, lanes3_all(eye))[0] < 0 ? -1 : 1;
    for (int i = 6; i < 9; i++) {
        v[i] *= way;
    }
    return v;
}

#define SPECULAR(normal, light, eye, power, right)                                                 \
    TEXT_WITH(                                                                                     \
        "10b.3+10b.1", "phong(" #normal ", " #light ", " #eye ", " #power ", " #power ").y",       \
        in_each_lane(called_specular_in,                                                           \
                     called_facing(called_joined(xyz normal, xyz light, xyz eye, power))),         \
        right,                                                                                     \
        called_specular_of(called_facing(called_joined(xyz normal, xyz light, xyz eye, power))))

static double *called_joined(struct vec3 a, struct vec3 b, struct vec3 c, double power) {
    static double v[10];
    const double all[10] = {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, power};
    memcpy(v, all, sizeof v);
    return v;
}

/* ---- Surfaces ---- */

static struct vec3 positions[] = {{0, 0, 0}, {0.5, 0.5, 0}, {0, 1, 0}};
static float normals[][3] = {{1, 0, 0}, {0, 3, 4}}, uvs[][2] = {{0, 0}, {0.25f, 0.75f}};
static struct face faces[] = {{{{0, 0, 0}, {1, 1, 1}, {2, 0, 0}}}};
static const struct model model = {
    .positions = positions, .normals = normals, .uvs = uvs, .faces = faces, .face_count = 1};
static struct texture called_colors, map, specular;
static size_t called_levels[3]; /* of these */

/* In the light of the text's worked example, seen from the front. */
static struct uniforms called_uniforms_of(struct material material) {
    return (struct uniforms){
        .model = &model,
        .diffuse = &called_colors,
        .normal_map = &map,
        .specular = &specular,
        .diffuse_level = called_levels[0],
        .normal_level = called_levels[1],
        .specular_level = called_levels[2],
        .eye = {1, 2, 3},
        .to_light = {0.6, 0, 0.8},
        .material = material,
    };
}

static const struct material called_matt = {0.1, 0.5, 0, -1, {0, 255, 0}};
static const struct material called_shining = {0.1, 1, 1.5, 10, {0, 255, 0}};
static const struct material called_faint = {0.1, 1, 0.5, 10, {0, 255, 0}};

/* Where the way to the eye has any length. */
static double called_varyings[VARYING_LIMIT] = {0, 0, 2, 0.5, 0.5};

static void called_fill_varyings(lanes *all) {
    for (int i = 0; i < VARYING_LIMIT; i++) {
        all[i] = lanes_all((real)called_varyings[i]);
    }
}

static struct vec3 called_to_eye = {0, 0, 2};

/* These are the surface's own: the material's are others. */
static struct surface called_surface_of(struct vec3 color, double weight, int power) {
    return (struct surface){
        .color = lanes3_all(color),
        .normal = lanes3_all(xyz(0, 0, 1)),
        .to_eye = lanes3_all(called_to_eye),
        .specular = lanes_all((real)weight),
        .power = lanes_all((real)power),
        .largest_power = power,
    };
}

/* The three parts of a surface, by your phong(). */
static struct vec3 called_sum_of(const struct material *material, const struct surface *surface) {
    struct lanes2 light =
        phong(surface->normal, lanes3_all(xyz(0.6, 0, 0.8)),
              lanes3_all(vec3_normalized(called_to_eye)), surface->power, surface->largest_power);
    double scattered = material->ambient + material->diffuse * (double)light.x[0];
    double mirrored = 255 * (double)surface->specular[0] * (double)light.y[0];
    return xyz((double)surface->color.x[0] * scattered + mirrored,
               (double)surface->color.y[0] * scattered + mirrored,
               (double)surface->color.z[0] * scattered + mirrored);
}

static struct color called_illuminated(struct material material, struct surface surface) {
    const struct uniforms u = called_uniforms_of(material);
    return texel_lane(illuminate(&u, &surface), 0);
}

typedef lanes_mask called_fragment_function(const void *uniforms, const lanes *called_varyings,
                                            lanes_texel *color);

static struct color called_fragment_of(called_fragment_function *fragment,
                                       struct material material) {
    const struct uniforms u = called_uniforms_of(material);
    lanes all[VARYING_LIMIT];
    lanes_texel color = lanes_black();
    called_fill_varyings(all);
    fragment(&u, all, &color);
    return texel_lane(color, 0);
}

static struct vec3 called_vec3_of(struct color c) {
    return xyz(c.r, c.g, c.b);
}

/* As one program rounds, and another cuts off. */
static bool called_is_about(struct color c, struct vec3 v) {
    return fabs(c.r - fmin(v.x, 255)) <= 1 && fabs(c.g - fmin(v.y, 255)) <= 1 &&
           fabs(c.b - fmin(v.z, 255)) <= 1;
}

/* A colour, or that which your other functions make of it. */
#define ABOUT(task, name, call, right, own)                                                        \
    do {                                                                                           \
        if (number_begin(task, name, show_color(right))) {                                         \
            const struct color yours = call;                                                       \
            number_end(show_color(yours), called_is_about(yours, called_vec3_of(right)) ||         \
                                              (called_is_about(yours, own) &&                      \
                                               !says_nothing(show_color(yours).text)));            \
        }                                                                                          \
    } while (0)

/* With the map's normal, and this part of the weight, or another power. */
static struct vec3 called_mapped_sum(struct material material, double part, int power,
                                     int largest_power) {
    lanes all[VARYING_LIMIT];
    const struct uniforms u = called_uniforms_of(material);
    called_fill_varyings(all);
    struct surface surface = textured_surface(&u, all);
    surface.normal = mapped_normal(&u, all);
    surface.specular *= (real)part;
    surface.power = power >= 0 ? lanes_all((real)power) : surface.power;
    surface.largest_power = power >= 0 ? largest_power : surface.largest_power;
    return called_vec3_of(called_illuminated(material, surface));
}

static bool called_make_textures(uint8_t value) {
    const struct color one[] = {rgb(200, 100, 50), rgb(128, 128, 255), color_grey(value)};
    memset(called_levels, 0, sizeof called_levels);
    texture_free(&called_colors);
    texture_free(&map);
    texture_free(&specular);
    return called_make_texture(&called_colors, &one[0], 1) &&
           called_make_texture(&map, &one[1], 1) && called_make_texture(&specular, &one[2], 1);
}

/* Textures whose texels differ from level to level; each has its own level with the right one. */
static bool called_make_textures_of_levels(void) {
    const struct color black = {0}, colors[] = {black, rgb(200, 100, 50), rgb(0, 0, 255), black};
    const struct color out_of_z[] = {rgb(255, 128, 128), rgb(128, 255, 128), rgb(128, 128, 255),
                                     rgb(0, 128, 128)};
    const struct color values[] = {black, color_grey(255), color_grey(200), color_grey(102)};
    for (size_t i = 0; i < 3; i++) {
        called_levels[i] = i + 1;
    }
    texture_free(&called_colors);
    texture_free(&map);
    texture_free(&specular);
    return called_make_levels(&called_colors, colors, 4) && called_make_levels(&map, out_of_z, 4) &&
           called_make_levels(&specular, values, 4);
}

/* ---- What a corner hands over, and what a pixel makes of it ---- */

static struct shown called_handed_over(void (*vertex)(const void *, size_t, size_t, double *),
                                       size_t first, size_t count) {
    const struct uniforms u = called_uniforms_of(called_matt);
    double handed[VARYING_LIMIT] = {0};
    vertex(&u, 0, 1, handed);
    return show_reals(handed + first, count);
}

static struct shown called_normal_in(int lane, const double *v) {
    struct lanes3 n = called_vector_in(lane, v);
    const lanes all[VARYING_LIMIT] = {[5] = n.x, [6] = n.y, [7] = n.z};
    return show_vector_lane(mesh_normal(all), lane);
}

/* Tenths: 127.5 and 128 are both taken for the middle of the map's values. */
static struct shown called_map_normal_in(int lane, const double *v) {
    struct lanes3 n = normal_from_values(called_vector_in(lane, v));
    return show("(%.1f, %.1f, %.1f)", round((double)n.x[lane] * 10) / 10 + 0,
                round((double)n.y[lane] * 10) / 10 + 0, round((double)n.z[lane] * 10) / 10 + 0);
}

static struct vec3 called_color_of_texture(void) {
    const struct uniforms u = called_uniforms_of(called_shining);
    lanes all[VARYING_LIMIT];
    called_fill_varyings(all);
    struct lanes3 color = textured_surface(&u, all).color;
    return xyz((double)color.x[0], (double)color.y[0], (double)color.z[0]);
}

#define POWER_MAP(value, power, right)                                                             \
    called_make_textures(value);                                                                   \
    ABOUT("10c.3+10b.1", "power_map_fragment() of value " #value,                                  \
          called_fragment_of(power_map_fragment, called_faint), right,                             \
          called_mapped_sum(called_faint, 1, power, 32))

static void numbers(void) {
    if (!called_make_textures(102)) {
        return;
    }
    /* First: what needs it is not called where it never returns. */
    TEXT("10b.1", "integer_power(0.8, 10, 10)", IN_LANES(called_power_in, 0.8, 10, 10), "0.1074");
    TEXT("10b.1", "integer_power(0.9, 1, 1)", IN_LANES(called_power_in, 0.9, 1, 1), "0.9");
    TEXT("10b.1", "integer_power(0.8, 2, 2)", IN_LANES(called_power_in, 0.8, 2, 2), "0.64");
    TEXT("10b.1", "integer_power(0.5, 0, 0)", IN_LANES(called_power_in, 0.5, 0, 0), "1");
    TEXT("10b.1", "integer_power(0.5, 3, 32)", IN_LANES(called_power_in, 0.5, 3, 32), "0.125");
    TEXT("10b.1", "integer_power(0.99, 200, 200)", IN_LANES(called_power_in, 0.99, 200, 200),
         "0.134");
    DIFFUSE((0, 0, 1), (0.6, 0, 0.8), "0.8");
    DIFFUSE((0.6, 0, 0.8), (0.6, 0, 0.8), "1");
    DIFFUSE((0, 0, -1), (0.6, 0, 0.8), "0");
    const struct surface dull = called_surface_of(xyz(200, 100, 50), 0, -1);
    ABOUT("10a.2", "illuminate(), matt", called_illuminated(called_matt, dull), rgb(100, 50, 25),
          called_sum_of(&called_matt, &dull));
    const struct material light_grey = {0.5, 1, 0, -1, {0, 255, 0}};
    const struct surface bright_wall = called_surface_of(xyz(100, 50, 150), 0, -1);
    ABOUT("10a.2", "illuminate(), colour (100, 50, 150), ambient 0.5, diffuse 1",
          called_illuminated(light_grey, bright_wall), rgb(130, 65, 195),
          called_sum_of(&light_grey, &bright_wall));
    const struct material other = {0.1, 1, 0.25, 3, {0, 255, 0}};
    const struct surface bright = called_surface_of(xyz(255, 128, 255), 0.5, 10);
    ABOUT("10a.2+10b.1", "illuminate(), colour (255, 128, 255), specular weight 0.5, power 10",
          called_illuminated(other, bright), rgb(243, 129, 243), called_sum_of(&other, &bright));
    called_to_eye = xyz(-1, 0, sqrt(3)); /* near the mirrored light */
    const struct surface sharp = called_surface_of(xyz(100, 50, 0), 0.25, 80);
    ABOUT("10a.2+10b.1", "illuminate(), power 80", called_illuminated(other, sharp),
          rgb(126, 81, 36), called_sum_of(&other, &sharp));
    TEXT("10a.3", "vertex_with_normal(), normal (0, 3, 4)",
         called_handed_over(vertex_with_normal, 5, 3), "(0, 0.6, 0.8)");
    TEXT("10a.4", "mesh_normal((0.5, 0.5, 0))", IN_LANES(called_normal_in, 0.5, 0.5, 0),
         "(0.70711, 0.70711, 0)");
    TEXT("10a.4", "mesh_normal((0, 0.3, -0.4))", IN_LANES(called_normal_in, 0, 0.3, -0.4),
         "(0, 0.6, -0.8)");
    TEXT("10b.2", "reflect((0, 0, 1), (0.6, 0, 0.8))",
         IN_LANES(called_reflect_in, 0, 0, 1, 0.6, 0, 0.8), "(-0.6, 0, 0.8)");
    TEXT("10b.2", "reflect((0.6, 0.8, 0), (1, 0, 0))",
         IN_LANES(called_reflect_in, 0.6, 0.8, 0, 1, 0, 0), "(-0.28, 0.96, 0)");
    SPECULAR((0, 0, 1), (0.6, 0, 0.8), (0, 0, 1), 10, "0.1074");
    SPECULAR((0, 0, 1), (0.6, 0, 0.8), (0, 0.6, 0.8), 2, "0.4096");
    SPECULAR((0, 0, 1), (0.9999875, 0, 0.005), (-0.9999875, 0, 0.005), 1, "1");
    SPECULAR((0, 0, 1), (0.6, 0, 0.8), (1, 0, 0), 2, "0");
    SPECULAR((0, 0, 1), (0.6, 0, 0.8), (1, 0, 0), 0, "1");
    SPECULAR((0, 0, -1), (0.6, 0, 0.8), (-0.96, 0, -0.28), 2, "0");
    TEXT("10b.4", "vertex(), eye (1, 2, 3)", called_handed_over(vertex, 0, 5),
         "(0.5, 1.5, 3, 0.25, 0.75)");
    TEXT("10c.1", "normal_from_values((255, 127.5, 127.5))",
         IN_LANES(called_map_normal_in, 255, 127.5, 127.5), "(1.0, 0.0, 0.0)");
    TEXT("10c.1", "normal_from_values((127.5, 64, 127.5))",
         IN_LANES(called_map_normal_in, 127.5, 64, 127.5), "(0.0, -1.0, 0.0)");
    TEXT("10c.1", "normal_from_values((204, 127.5, 229.5))",
         IN_LANES(called_map_normal_in, 204, 127.5, 229.5), "(0.6, 0.0, 0.8)");
    AS_VECTOR("10c.2", "textured_surface(u, varyings).color", vec3, called_color_of_texture(),
              xyz(200, 100, 50));
    ABOUT("10c.2", "full_fragment(), matt", called_fragment_of(full_fragment, called_matt),
          rgb(100, 50, 25), called_mapped_sum(called_matt, 1, -1, -1));
    ABOUT("10c.3+10b.1", "weight_map_fragment() of value 102",
          called_fragment_of(weight_map_fragment, called_shining), rgb(198, 108, 63),
          called_mapped_sum(called_shining, 0.4, -1, -1));
    called_make_textures_of_levels();
    AS_VECTOR("10c.2", "textured_surface(), the texture at its level", vec3,
              called_color_of_texture(), xyz(200, 100, 50));
    ABOUT("10c.3+10b.1", "weight_map_fragment(), each texture at its level",
          called_fragment_of(weight_map_fragment, called_shining), rgb(198, 108, 63),
          called_mapped_sum(called_shining, 0.4, -1, -1));
    ABOUT("10c.3+10b.1", "power_map_fragment(), each texture at its level",
          called_fragment_of(power_map_fragment, called_faint), rgb(188, 98, 53),
          called_mapped_sum(called_faint, 1, 13, 32));
    POWER_MAP(87, 11, rgb(192, 102, 57));
    POWER_MAP(7, 1, rgb(255, 193, 148));
    POWER_MAP(8, 2, rgb(255, 173, 128));
    POWER_MAP(12, 2, rgb(255, 173, 128));
    called_varyings[0] = -1; /* near the mirrored light, where a large power shines, too */
    called_varyings[2] = sqrt(3);
    POWER_MAP(255, 32, rgb(255, 194, 149));
    VECTOR("10c.4", vec3, turning_light(0), xyz(0, 0, 1));
    VECTOR("10c.4", vec3, turning_light(0.25), xyz(1, 0, 0));
    VECTOR("10c.4", vec3, turning_light(0.125), xyz(sqrt(0.5), 0, sqrt(0.5)));
}
