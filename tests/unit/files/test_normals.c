/* Normals computed from faces against acosl() and atan2l(), and colours from normals. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "files/normals.h"
#include "oracle/oracle.h"
#include "oracle/reals.h"
#include "oracle/shown.h"
#include "unit/models.h"

#include <math.h>

static struct random random_state = {1};

static int random_int(int least, int most) { /* both inclusive */
    return (int)random_between(&random_state, least, most);
}

static struct vec3 random_vector(double scale) {
    return random_vec3(&random_state, scale);
}

/* ---- Normals ---- */

static void test_angles(void) {
    const long double pi = 3.14159265358979323846L;
    for (int i = 0; i < 20000; i++) {
        /* Angles of every size, also near 0 and pi: b is a, plus something large or tiny. */
        double size = pow(10, random_int(-12, 2)), sign = random_int(0, 1) == 0 ? 1 : -1;
        struct vec3 a = random_vector(1), b = vec3_add(vec3_scale(a, sign), random_vector(size));
        struct real3 u = real3_from(a), v = real3_from(b);
        long double expected = atan2l(real3_length(real3_cross(u, v)), real3_dot(u, v));
        CHECK(fabsl((long double)model_angle(a, b) - expected) < 1e-15L * pi);
    }
    struct vec3 zero = {0, 0, 0}, across = {1, 0, 0}, back = {-3, 0, 0}, up = {0, 1e-300, 0};
    CHECK(model_angle(zero, across) == 0 && model_angle(across, zero) == 0);
    CHECK(model_angle(zero, zero) == 0);
    CHECK(model_angle(across, across) == 0);
    CHECK(fabsl(model_angle(across, back) - pi) < 1e-15L * pi);
    CHECK(fabsl(model_angle(across, up) - pi / 2) < 1e-15L * pi);
}

/* The sum over the faces around a position of their unit normals times their angles, by acosl(). */
static struct real3 normal_by_definition(const struct model *m, uint32_t position) {
    struct real3 sum = {0, 0, 0}, at = real3_from(m->positions[position]);
    for (size_t i = 0; i < 3 * m->face_count; i++) {
        const struct corner *corner = m->faces[i / 3].corner;
        if (corner[i % 3].position == position) {
            struct vec3 to = m->positions[corner[(i + 1) % 3].position];
            struct vec3 from = m->positions[corner[(i + 2) % 3].position];
            struct real3 u = real3_unit(real3_sub(real3_from(to), at));
            struct real3 v = real3_unit(real3_sub(real3_from(from), at));
            struct real3 normal = real3_unit(real3_cross(u, v));
            sum = real3_add(sum, normal, acosl(fminl(1, fmaxl(-1, real3_dot(u, v)))));
        }
    }
    return sum;
}

/* No edge is hard. */
static bool smooth_all(struct model *m) {
    m->hard_given = true;
    m->hard_degrees = 180;
    return true;
}

/* Faces, every tenth with its own normal, between random places. */
static bool make_faces(struct model *m) {
    struct bytes text = {0};
    struct error error;
    double scale = pow(10, random_int(-10, 10));
    for (int i = 0; i < 20; i++) { /* so many normals that others need room */
        struct vec3 p = random_vector(scale);
        CHECK(bytes_print(&text, "v %.9g %.9g %.9g\nvn 5 6 7\n", p.x, p.y, p.z));
    }
    for (int i = 0; i < 30; i++) {
        const char *own = i % 10 == 9 ? "//1" : "";
        int a = random_int(1, 20), b = random_int(1, 20), c = random_int(1, 20);
        CHECK(bytes_print(&text, "f %d%s %d%s %d%s\n", a, own, b, own, c, own));
    }
    bool made = CHECK(model_decode(m, text.data, text.size, &error));
    bytes_free(&text);
    return made;
}

static void check_normal(const struct model *m, size_t face, size_t corner) {
    const struct corner *c = &m->faces[face].corner[corner];
    if (!CHECK(c->normal < m->normal_count) || face % 10 == 9) {
        CHECK(c->normal == 0);
        return;
    }
    struct real3 sum = normal_by_definition(m, c->position);
    struct real3 normal = real3_from(model_normal(m, face, corner));
    if (real3_length(sum) < 1e-3L) { /* nearly cancelled: its direction is mere noise */
        CHECK(fabsl(real3_dot(normal, normal) - 1) < 1e-6L);
    } else {
        CHECK(real3_length(real3_sub(normal, real3_unit(sum))) < 1.2e-7L);
    }
}

static void test_normals(void) {
    for (int round = 0; round < 40; round++) {
        struct model m;
        struct error error;
        if (make_faces(&m) && CHECK(smooth_all(&m) && model_need_normals(&m, &error))) {
            size_t count = m.normal_count;
            CHECK(count > 20 && count <= 40 && same3(m.normals[0], 5, 6, 7));
            for (size_t i = 0; i < 3 * m.face_count; i++) {
                check_normal(&m, i / 3, i % 3);
            }
            CHECK(model_need_normals(&m, &error) && m.normal_count == count);
        }
        model_free(&m);
    }
}

static void test_no_normal(void) {
    static const char text[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 3e38 3e38 3e38\nv -3e38 1e-45 3e38\n"
                               "v 2 0 0\nf 1 2 3\nf 1 3 2\nf 1 4 5\nf 2 6 2\n";
    struct model m;
    struct error error;
    if (!decode_right(&m, text) || !CHECK(smooth_all(&m) && model_need_normals(&m, &error))) {
        return;
    }
    struct vec3 both_sides = model_normal(&m, 0, 2), degenerate = model_normal(&m, 3, 1);
    CHECK(both_sides.x == 0 && both_sides.y == 0 && both_sides.z == 1);
    CHECK(degenerate.x == 0 && degenerate.y == 0 && degenerate.z == 1);
    for (size_t i = 0; i < m.normal_count; i++) {
        CHECK(isfinite(m.normals[i][0]) && isfinite(m.normals[i][1]) && isfinite(m.normals[i][2]));
    }
    model_free(&m);
}

/* Two faces back to back: what rounding leaves of their normals is not taken for a direction. */
static void test_back_to_back(void) {
    for (int i = 0; i < 50; i++) {
        struct vec3 positions[3] = {random_vector(1), random_vector(1), random_vector(1)};
        struct face faces[2];
        struct model m =
            plain_model(positions, 3, faces, 2, (const uint32_t[][3]){{0, 1, 2}, {2, 1, 0}});
        struct error error;
        CHECK(smooth_all(&m) && model_need_normals(&m, &error));
        for (size_t k = 0; k < 3; k++) {
            struct vec3 n = model_normal(&m, 0, k);
            CHECK(n.x == 0 && n.y == 0 && n.z == 1);
        }
        free(m.normals);
    }
}

/* No direction is invented: a normal that is computed points as the face does. */
static void test_computed_normals(void) {
    static const char *const texts[] = {
        SQUARE "f 1//1 2//1 3//1\n",
        SQUARE "vn 0 0 1\nf 1 2//1 3//1\n",
        SQUARE "vn 0 0 0\nf 1//1 2//1 3//1\n",
        SQUARE "vn 1 0 0\nvn nan nan nan\nf 1//2 2//2 3//2\n",
        "NOFF\n3 1\n0 0 0 0 0 0\n1 0 0 nan nan nan\n0 1 0 -nan(ind) 0 0\n3 0 1 2\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        struct model m;
        struct error error;
        if (decode_right(&m, texts[i])) {
            CHECK_ROW(model_need_normals(&m, &error), texts[i]);
            for (size_t k = 0; k < 3; k++) {
                struct vec3 normal = model_normal(&m, 0, k);
                CHECK_ROW(normal.x == 0 && normal.y == 0 && normal.z == 1, texts[i]);
            }
            model_free(&m);
        }
    }
}

/* A corner of a hundred-thousandth of a radian is no noise: it has the normal of its face. */
static void test_narrow_corner(void) {
    static const char text[] = "v 0 0 0\nv 0 1 0\nv 0 1 0.00001\nf 1 2 3\n";
    struct model m;
    struct error error;
    if (decode_right(&m, text) && CHECK(model_need_normals(&m, &error))) {
        CHECK(same3(m.normals[0], 1, 0, 0));
    }
    model_free(&m);
}

/* ---- Hard edges ---- */

/* How many normals there are around the corners of a solid: 24 of a cube of hard edges, 36 where
 * each triangle is flat, 8 of one like a pillow. `hard`: an angle, or -1 for none. */
static void test_hard_edges(void) {
#define FRONT  "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
#define CUBE   FRONT "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
#define BOTTOM "f 1 2 3 4\nf 6 5 8 7\n"
#define SIDES  "f 2 6 7 3\nf 5 1 4 8\nf 4 3 7 8\nf 5 6 2 1\n"
    static const struct {
        const char *name, *text;
        double hard;
        size_t normals;
    } rows[] = {
        {"cube", CUBE BOTTOM SIDES, -1, 24},
        {"cube, 89", CUBE BOTTOM SIDES, 89, 24},
        {"cube, 90", CUBE BOTTOM SIDES, 90, 8},
        {"cube, all smooth", CUBE BOTTOM SIDES, 180, 8},
        {"off", CUBE "s off\n" BOTTOM SIDES, -1, 36},
        {"off, in capitals", CUBE "S OFF\n" BOTTOM SIDES, -1, 36},
        {"one group", CUBE "s 1\n" BOTTOM SIDES, -1, 8},
        {"on", CUBE "s on\n" BOTTOM SIDES, -1, 8},
        {"two groups", CUBE "s 1\n" BOTTOM "s 2\n" SIDES, -1, 16},
        {"one smooth, four flat", CUBE "s 7\n" BOTTOM "s 0\n" SIDES, -1, 32},
        {"the same group again", CUBE "s 1\n" BOTTOM "s 2\ns 1\n" SIDES, -1, 8},
        {"none, then a group", CUBE BOTTOM "s 3\n" SIDES, -1, 16},
        {"the option before groups", CUBE "s 1\n" BOTTOM SIDES, 60, 24},
        {"the option before off", CUBE "s off\n" BOTTOM SIDES, 180, 8},
        {"column of six", "COLUMN 6", -1, 12},
        {"column of five", "COLUMN 5", -1, 20},
        {"column of five, 73", "COLUMN 5", 73, 10},
        {"flat, though in one plane", SQUARE "s off\nf 1 2 3\nf 1 3 4\n", -1, 6},
        {"angle in one plane", SQUARE "f 1 2 3\nf 1 3 4\n", 0, 4},
        {"a face without area between two", SQUARE "f 1 2 3\nf 1 3 3\nf 1 3 4\n", 0, 4},
        {"both sides of a sheet", SQUARE "f 1 2 3 4\nf 4 3 2 1\n", -1, 8},
        {"two sheets of two sides", SQUARE "v 2 0 0\nf 1 2 3\nf 3 2 1\nf 2 5 3\nf 3 5 2\n", -1, 8},
        {"two tips that touch",
         "v 0 0 0\nv 1 0 1\nv 0 1 1\nv -1 0 -1\nv 0 -1 -1\nf 1 2 3\nf 1 4 5\n", 179, 6},
        {"with normals", SQUARE "s off\nvn 0 0 1\nf 1//1 2//1 3//1\n", -1, 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char column[1200] = "";
        size_t sides = 0;
        if (sscanf(rows[i].text, "COLUMN %zu", &sides) == 1) { /* to six digits, as files have */
            for (size_t k = 0; k < sides; k++) {
                double angle = 6.283185307179586 * (double)k / (double)sides;
                string_append(column, sizeof column, "v %.6f %.6f 0\nv %.6f %.6f 1\n", cos(angle),
                              sin(angle), cos(angle), sin(angle));
            }
            for (size_t k = 0; k < sides; k++) {
                size_t a = 2 * k + 1, b = 2 * ((k + 1) % sides) + 1;
                string_append(column, sizeof column, "f %zu %zu %zu %zu\n", a, b, b + 1, a + 1);
            }
        }
        struct model m;
        struct error error;
        if (!decode_right(&m, sides > 0 ? column : rows[i].text)) {
            continue;
        }
        m.hard_given = rows[i].hard >= 0;
        m.hard_degrees = rows[i].hard;
        CHECK_ROW(model_need_normals(&m, &error), rows[i].name);
        if (!CHECK_ROW(m.normal_count == rows[i].normals, rows[i].name)) {
            printf("    %zu normals\n", m.normal_count);
        }
        for (size_t k = 0; k < 3 * m.face_count; k++) { /* each looks as its face, more or less */
            struct vec3 n = model_normal(&m, k / 3, k % 3), face = model_face_normal(&m, k / 3);
            CHECK_ROW(vec3_dot(n, face) > 0 || vec3_length(face) == 0, rows[i].name);
        }
        model_free(&m);
    }
}

/* More faces around a position, and at an edge, than could be compared each with each. */
static void test_many_around(void) {
    enum { COUNT = 200000 };
    struct bytes text = {0};
    struct model m;
    struct error error;
    CHECK(bytes_print(&text, "v 0 0 0\nv 1 0 0\nv 0 1 0\n"));
    for (int i = 0; i < COUNT; i++) {
        CHECK(bytes_print(&text, "f 1 2 3\n"));
    }
    if (CHECK(model_decode(&m, text.data, text.size, &error)) &&
        CHECK(model_need_normals(&m, &error))) {
        CHECK(m.normal_count == 3 && same3(m.normals[0], 0, 0, 1));
    }
    model_free(&m);
    bytes_free(&text);
}

/* ---- Colours ---- */

static void test_colors_from_normals(void) {
    static const char text[] = "v 9 9 9\n" SQUARE "vn 0 0 -5\nvn 3 4 0\nvn 0 0 0\n"
                               "f 2//1 3//2 4//3\nf 2//2 4//2 5\n";
    struct model m;
    struct error error;
    if (!decode_right(&m, text) || !CHECK(model_need_colors(&m, &error))) {
        return;
    }
    CHECK(same3(m.colors[1], 0.5F, 0.5F, 0)); /* the first face decides */
    CHECK(same3(m.colors[2], 0.8F, 0.9F, 0.5F));
    CHECK(same3(m.colors[3], 0.5F, 0.5F, 1));    /* computed: the one given has no length */
    CHECK(same3(m.colors[4], 0.5F, 0.5F, 1));    /* computed: none is given */
    CHECK(same3(m.colors[0], 0.5F, 0.5F, 0.5F)); /* of no face */
    model_free(&m);
}

/* Faces have the colours of their materials, or white where one of them has a colour. */
static void test_colors_of_materials(void) {
    struct model m;
    struct error error;
    for (int grey = 0; grey < 2; grey++) {
        if (!decode_right(&m, SQUARE "f 1 2 3\nusemtl a\nf 1 2 4\nusemtl b\nf 2 3 4\n")) {
            return;
        }
        m.materials[0].color[0] = m.materials[0].color[1] = m.materials[0].color[2] = 0.25F;
        m.materials[1].color[2] = grey ? 1 : 0.5F;
        CHECK(model_need_colors(&m, &error) && (m.face_colors == NULL) == grey);
        struct vec3 white = model_color(&m, 0, 2), a = model_color(&m, 1, 0);
        struct vec3 b = model_color(&m, 2, 1);
        CHECK(grey || (white.x == 1 && white.y == 1 && white.z == 1 && a.x == 0.25 && b.x == 1 &&
                       b.z == 0.5));
        CHECK(!grey || same3(m.colors[0], 0.5F, 0.5F, 1)); /* of the normal */
        model_free(&m);
    }
}

/* Colours that the file gives stay, and no normals are made for them. */
static void test_given_colors(void) {
    static const char *const texts[] = {
        "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "OFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        struct model m;
        struct error error;
        if (decode_right(&m, texts[i]) && CHECK(model_need_colors(&m, &error))) {
            struct vec3 color = model_color(&m, 0, 0);
            CHECK(color.x == 1 && color.y == 0 && color.z == 0);
            CHECK((m.colors == NULL) == (m.face_colors != NULL) && m.normal_count == 0);
        }
        model_free(&m);
    }
}

UNIT_MAIN(TEST(test_angles), TEST(test_normals), TEST(test_no_normal), TEST(test_back_to_back),
          TEST(test_computed_normals), TEST(test_narrow_corner), TEST(test_hard_edges),
          TEST(test_many_around), TEST(test_colors_from_normals), TEST(test_colors_of_materials),
          TEST(test_given_colors))
