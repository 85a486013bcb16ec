/* Normals computed from faces against acosl() and atan2l(), and colours from normals. */
#include "files/normals.h"

#include "files/model_file.h"
#include "oracle/oracle.h"
#include "unit/unit.h"

#include <math.h>

static struct random random_state = {1};

static int random_int(int least, int most) { /* both inclusive */
    return (int)random_between(&random_state, least, most);
}

static double random_unit(void) { /* -1..1 */
    return random_real(&random_state, -1, 1);
}

static bool decode(struct model *model, const char *text, struct error *error) {
    return model_decode(model, text, strlen(text), error);
}

static bool same3(const float *a, float x, float y, float z) {
    return a[0] == x && a[1] == y && a[2] == z;
}

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

/* ---- Normals ---- */

static void test_angles(void) {
    const long double pi = 3.14159265358979323846L;
    for (int i = 0; i < 20000; i++) {
        /* Angles of every size, also near 0 and pi: b is a, plus something large or tiny. */
        double size = pow(10, random_int(-12, 2)), sign = random_int(0, 1) == 0 ? 1 : -1;
        struct vec3 a = {random_unit(), random_unit(), random_unit()};
        struct vec3 b = {sign * a.x + size * random_unit(), sign * a.y + size * random_unit(),
                         sign * a.z + size * random_unit()};
        long double x = (long double)a.y * b.z - (long double)a.z * b.y;
        long double y = (long double)a.z * b.x - (long double)a.x * b.z;
        long double z = (long double)a.x * b.y - (long double)a.y * b.x;
        long double dot = (long double)a.x * b.x + (long double)a.y * b.y + (long double)a.z * b.z;
        long double expected = atan2l(sqrtl(x * x + y * y + z * z), dot);
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
static void normal_by_definition(const struct model *m, uint32_t position, long double sum[3]) {
    sum[0] = sum[1] = sum[2] = 0;
    for (size_t i = 0; i < m->face_count; i++) {
        for (int j = 0; j < 3; j++) {
            if (m->faces[i].corner[j].position != position) {
                continue;
            }
            long double u[3], v[3], n[3], uu = 0, vv = 0, uv = 0, nn = 0;
            struct vec3 p = m->positions[position];
            struct vec3 q = m->positions[m->faces[i].corner[(j + 1) % 3].position];
            struct vec3 r = m->positions[m->faces[i].corner[(j + 2) % 3].position];
            const long double at[3] = {p.x, p.y, p.z}, to[3] = {q.x, q.y, q.z};
            const long double from[3] = {r.x, r.y, r.z};
            for (int k = 0; k < 3; k++) {
                u[k] = to[k] - at[k];
                v[k] = from[k] - at[k];
                uu += u[k] * u[k];
                vv += v[k] * v[k];
                uv += u[k] * v[k];
            }
            for (int k = 0; k < 3; k++) {
                n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
                nn += n[k] * n[k];
            }
            if (nn > 0) {
                long double angle = acosl(fminl(1, fmaxl(-1, uv / sqrtl(uu * vv))));
                for (int k = 0; k < 3; k++) {
                    sum[k] += n[k] / sqrtl(nn) * angle;
                }
            }
        }
    }
}

static void test_normals(void) {
    for (int round = 0; round < 40; round++) {
        struct bytes bytes = {0};
        struct model m;
        struct error error;
        char line[128];
        double scale = pow(10, random_int(-10, 10));
        for (int i = 0; i < 20; i++) {
            int length = snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", scale * random_unit(),
                                  scale * random_unit(), scale * random_unit());
            CHECK(bytes_append(&bytes, line, (size_t)length));
            CHECK(bytes_append(&bytes, "vn 5 6 7\n", 9)); /* so many that others need room */
        }
        for (int i = 0; i < 30; i++) { /* every tenth face brings a normal of its own */
            const char *own = i % 10 == 9 ? "//1" : "";
            int a = random_int(1, 20), b = random_int(1, 20), c = random_int(1, 20);
            int length = snprintf(line, sizeof line, "f %d%s %d%s %d%s\n", a, own, b, own, c, own);
            CHECK(bytes_append(&bytes, line, (size_t)length));
        }
        if (CHECK(model_decode(&m, bytes.data, bytes.size, &error)) &&
            CHECK(model_need_normals(&m, &error))) {
            size_t count = m.normal_count;
            CHECK(count > 20 && count <= 40 && same3(m.normals[0], 5, 6, 7));
            for (size_t i = 0; i < m.face_count; i++) {
                for (size_t j = 0; j < 3; j++) {
                    const struct corner *c = &m.faces[i].corner[j];
                    if (!CHECK(c->normal < m.normal_count) || i % 10 == 9) {
                        CHECK(c->normal == 0);
                        continue;
                    }
                    long double sum[3];
                    normal_by_definition(&m, c->position, sum);
                    long double length = sqrtl(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
                    const float *n = m.normals[c->normal];
                    if (length < 1e-3L) { /* nearly cancelled: its direction is mere noise */
                        CHECK(fabs((double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2] -
                                   1) < 1e-6);
                        continue;
                    }
                    for (int k = 0; k < 3; k++) {
                        CHECK(fabsl(n[k] - sum[k] / length) < 1e-7L);
                    }
                }
            }
            CHECK(model_need_normals(&m, &error) && m.normal_count == count);
        }
        model_free(&m);
        bytes_free(&bytes);
    }
}

static void test_no_normal(void) {
    static const char text[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 3e38 3e38 3e38\nv -3e38 1e-45 3e38\n"
                               "v 2 0 0\nf 1 2 3\nf 1 3 2\nf 1 4 5\nf 2 6 2\n";
    struct model m;
    struct error error;
    if (!CHECK(decode(&m, text, &error)) || !CHECK(model_need_normals(&m, &error))) {
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
        char text[400];
        struct model m;
        struct error error;
        size_t used = 0;
        for (int k = 0; k < 3; k++) {
            used += (size_t)snprintf(text + used, sizeof text - used, "v %.9g %.9g %.9g\n",
                                     random_unit(), random_unit(), random_unit());
        }
        snprintf(text + used, sizeof text - used, "f 1 2 3\nf 3 2 1\n");
        if (CHECK(decode(&m, text, &error)) && CHECK(model_need_normals(&m, &error))) {
            for (size_t k = 0; k < 3; k++) {
                struct vec3 n = model_normal(&m, 0, k);
                CHECK(n.x == 0 && n.y == 0 && n.z == 1);
            }
        }
        model_free(&m);
    }
}

/* A corner of a hundred-thousandth of a radian is no noise: it has the normal of its face. */
static void test_narrow_corner(void) {
    static const char text[] = "v 0 0 0\nv 0 1 0\nv 0 1 0.00001\nf 1 2 3\n";
    struct model m;
    struct error error;
    if (CHECK(decode(&m, text, &error)) && CHECK(model_need_normals(&m, &error))) {
        CHECK(same3(m.normals[0], 1, 0, 0));
    }
    model_free(&m);
}

/* ---- Colours ---- */

static void test_colors_from_normals(void) {
    static const char text[] = SQUARE "v 9 9 9\nvn 0 0 -5\nvn 3 4 0\nvn 0 0 0\n"
                                      "f 1//1 2//2 3//3\nf 1//2 3//2 4\n";
    struct model m;
    struct error error;
    if (!CHECK(decode(&m, text, &error)) || !CHECK(model_need_colors(&m, &error))) {
        return;
    }
    CHECK(same3(m.colors[0], 0.5F, 0.5F, 0)); /* the first face decides */
    CHECK(same3(m.colors[1], 0.8F, 0.9F, 0.5F));
    CHECK(same3(m.colors[2], 0.5F, 0.5F, 1));    /* computed: the one given has no length */
    CHECK(same3(m.colors[3], 0.5F, 0.5F, 1));    /* computed: none is given */
    CHECK(same3(m.colors[4], 0.5F, 0.5F, 0.5F)); /* of no face */
    model_free(&m);
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
        if (CHECK(decode(&m, texts[i], &error)) && CHECK(model_need_colors(&m, &error))) {
            struct vec3 color = model_color(&m, 0, 0);
            CHECK(color.x == 1 && color.y == 0 && color.z == 0);
            CHECK((m.colors == NULL) == (m.face_colors != NULL) && m.normal_count == 0);
        }
        model_free(&m);
    }
}

UNIT_MAIN(TEST(test_angles), TEST(test_normals), TEST(test_no_normal), TEST(test_back_to_back),
          TEST(test_narrow_corner), TEST(test_colors_from_normals), TEST(test_given_colors))
