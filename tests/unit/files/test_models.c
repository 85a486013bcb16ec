/*
 * The sculpted models: closed, manifold, facing outwards, with sound texture coordinates, normals
 * and textures. Reads what the sculptor wrote into the directory COURSE_MODELS.
 *
 * Nothing is compared with numbers of the sculptor's own: these are properties that any good model
 * has, volumes known from formulas, and the order of brightness that skin has.
 */
#include "unit/unit.h"

#include "files/image_file.h"
#include "files/model_file.h"
#include "model.h"

#include <math.h>
#include <stdlib.h>

#ifndef COURSE_MODELS
#define COURSE_MODELS COURSE_BUILD "/models"
#endif

/* ---- Topology ---- */

/* An edge as one face runs along it. */
struct half_edge {
    uint32_t from, to;
    size_t face;
};

static int compare_half_edges(const void *a, const void *b) {
    const struct half_edge *l = a, *r = b;
    if (l->from != r->from) {
        return l->from < r->from ? -1 : 1;
    }
    return l->to == r->to ? 0 : l->to < r->to ? -1 : 1;
}

static struct half_edge *sorted_half_edges(const struct model *model) {
    struct half_edge *edges = malloc(3 * model->face_count * sizeof *edges);
    for (size_t i = 0; edges != NULL && i < model->face_count; i++) {
        for (int k = 0; k < 3; k++) {
            edges[3 * i + (size_t)k] =
                (struct half_edge){.from = model->faces[i].corner[k].position,
                                   .to = model->faces[i].corner[(k + 1) % 3].position,
                                   .face = i};
        }
    }
    if (edges != NULL) {
        qsort(edges, 3 * model->face_count, sizeof *edges, compare_half_edges);
    }
    return edges;
}

static const struct half_edge *find_edge(const struct half_edge *edges, size_t count, uint32_t from,
                                         uint32_t to) {
    struct half_edge key = {.from = from, .to = to};
    return bsearch(&key, edges, count, sizeof *edges, compare_half_edges);
}

static uint32_t corner_after(const struct model *model, size_t face, uint32_t position) {
    const struct corner *c = model->faces[face].corner;
    return c[0].position == position   ? c[1].position
           : c[1].position == position ? c[2].position
                                       : c[0].position;
}

/* The number of faces around a vertex, walking from face to face over shared edges. */
static size_t fan_size(const struct model *model, const struct half_edge *edges, size_t first) {
    uint32_t center = edges[first].from;
    size_t face = edges[first].face, size = 0;
    do {
        uint32_t next = corner_after(model, face, center);
        const struct half_edge *twin = find_edge(edges, 3 * model->face_count, next, center);
        if (twin == NULL || ++size > model->face_count) {
            return 0;
        }
        face = twin->face;
    } while (face != edges[first].face);
    return size;
}

/* Every edge has exactly one twin, every vertex one closed fan of faces, no two vertices the same
 * place, everything hangs together; and vertices - edges + faces is as expected. */
static void check_manifold(const struct model *model, const char *name, long characteristic) {
    size_t count = 3 * model->face_count, repeated = 0, open = 0, bad_fans = 0, used = 0;
    struct half_edge *edges = sorted_half_edges(model);
    if (!CHECK_ROW(edges != NULL, name)) {
        return;
    }
    for (size_t i = 0; i < count; i++) {
        repeated += i > 0 && compare_half_edges(&edges[i - 1], &edges[i]) == 0;
        open += find_edge(edges, count, edges[i].to, edges[i].from) == NULL;
    }
    CHECK_ROW(repeated == 0, name);
    if (CHECK_ROW(open == 0, name)) {
        for (size_t i = 0, end; i < count; i = end) {
            for (end = i; end < count && edges[end].from == edges[i].from; end++) {
            }
            bad_fans += fan_size(model, edges, i) != end - i;
            used++;
        }
        CHECK_ROW(bad_fans == 0, name);
        CHECK_ROW(used == model->position_count, name);
        CHECK_ROW((long)model->position_count - (long)(count / 2) + (long)model->face_count ==
                      characteristic,
                  name);
    }
    free(edges);
}

static void check_connected(const struct model *model, const char *name) {
    bool *reached = calloc(model->position_count, sizeof *reached);
    CHECK_ROW(reached != NULL, name);
    if (reached == NULL) {
        return;
    }
    reached[model->faces[0].corner[0].position] = true;
    for (bool grew = true; grew;) {
        grew = false;
        for (size_t i = 0; i < model->face_count; i++) {
            const struct corner *c = model->faces[i].corner;
            bool any = reached[c[0].position] || reached[c[1].position] || reached[c[2].position];
            for (int k = 0; any && k < 3; k++) {
                grew |= !reached[c[k].position];
                reached[c[k].position] = true;
            }
        }
    }
    size_t missed = 0;
    for (size_t i = 0; i < model->position_count; i++) {
        missed += !reached[i];
    }
    CHECK_ROW(missed == 0, name);
    free(reached);
}

static int compare_numbers(double a, double b) {
    return (a > b) - (a < b);
}

static int compare_positions(const void *a, const void *b) {
    const struct vec3 *l = a, *r = b;
    int x = compare_numbers(l->x, r->x), y = compare_numbers(l->y, r->y);
    return x != 0 ? x : (y != 0 ? y : compare_numbers(l->z, r->z));
}

/* A sorted copy of the positions; the caller frees it. */
static struct vec3 *sorted_positions(const struct model *model) {
    struct vec3 *sorted = malloc(model->position_count * sizeof *sorted);
    if (sorted != NULL) {
        memcpy(sorted, model->positions, model->position_count * sizeof *sorted);
        qsort(sorted, model->position_count, sizeof *sorted, compare_positions);
    }
    return sorted;
}

static void check_positions(const struct model *model, const char *name) {
    struct vec3 *sorted = sorted_positions(model);
    if (!CHECK_ROW(sorted != NULL, name)) {
        return;
    }
    size_t twice = 0, outside = 0;
    for (size_t i = 0; i < model->position_count; i++) {
        twice += i > 0 && compare_positions(&sorted[i - 1], &sorted[i]) == 0;
        struct vec3 p = sorted[i];
        outside += !(fabs(p.x) <= 1 && fabs(p.y) <= 1 && fabs(p.z) <= 1);
    }
    CHECK_ROW(twice == 0, name);
    CHECK_ROW(outside == 0, name);
    free(sorted);
}

/* ---- Shape ---- */

/* The cross product of two sides: along the normal, as long as twice the area. */
static struct vec3 twice_area(const struct model *model, size_t face) {
    struct vec3 a = model_position(model, face, 0);
    return vec3_cross(vec3_sub(model_position(model, face, 1), a),
                      vec3_sub(model_position(model, face, 2), a));
}

static double volume(const struct model *model) {
    double sum = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        sum += vec3_dot(model_position(model, i, 0), twice_area(model, i)) / 6;
    }
    return sum;
}

/* No face is a needle: its height over its longest side is a fair part of that side. */
static void check_faces(const struct model *model, const char *name) {
    size_t needles = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        double longest = 0;
        for (size_t k = 0; k < 3; k++) {
            struct vec3 side =
                vec3_sub(model_position(model, i, (k + 1) % 3), model_position(model, i, k));
            longest = fmax(longest, vec3_dot(side, side));
        }
        needles += !(vec3_length(twice_area(model, i)) > 0.01 * longest);
    }
    CHECK_ROW(needles == 0, name);
}

/* Each corner has a normal of length 1 on the face's outer side. */
static void check_normals(const struct model *model, const char *name) {
    size_t bad_length = 0, turned = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        struct vec3 out = twice_area(model, i);
        for (size_t k = 0; k < 3; k++) {
            if (!CHECK_ROW(model->faces[i].corner[k].normal < model->normal_count, name)) {
                return;
            }
            struct vec3 n = model_normal(model, i, k);
            bad_length += !(fabs(vec3_length(n) - 1) < 3e-6);
            turned += !(vec3_dot(n, out) > 0);
        }
    }
    CHECK_ROW(bad_length == 0, name);
    CHECK_ROW(turned == 0, name);
}

/* Texture coordinates lie in the texture, and each face covers some of it, not mirrored. */
static void check_uvs(const struct model *model, const char *name) {
    size_t outside = 0, turned = 0;
    for (size_t i = 0; i < model->uv_count; i++) {
        for (int k = 0; k < 2; k++) {
            outside += !(model->uvs[i][k] >= 0 && model->uvs[i][k] <= 1);
        }
    }
    for (size_t i = 0; i < model->face_count; i++) {
        if (!CHECK_ROW(model->faces[i].corner[0].uv < model->uv_count, name)) {
            return;
        }
        struct vec2 a = model_uv(model, i, 0);
        struct vec2 b = vec2_sub(model_uv(model, i, 1), a), c = vec2_sub(model_uv(model, i, 2), a);
        turned += !(b.x * c.y - b.y * c.x > 1e-7);
    }
    CHECK_ROW(outside == 0, name);
    CHECK_ROW(turned == 0, name);
}

/* Does the edge from p to q pass through the face with corners t? */
static bool pierces(struct vec3 p, struct vec3 q, const struct vec3 t[3]) {
    struct vec3 normal = vec3_cross(vec3_sub(t[1], t[0]), vec3_sub(t[2], t[0]));
    double from = vec3_dot(normal, vec3_sub(p, t[0])), to = vec3_dot(normal, vec3_sub(q, t[0]));
    if ((from < 0) == (to < 0)) {
        return false;
    }
    struct vec3 hit = vec3_add(p, vec3_scale(vec3_sub(q, p), from / (from - to)));
    bool inside = true;
    for (int k = 0; k < 3; k++) {
        struct vec3 side = vec3_sub(t[(k + 1) % 3], t[k]);
        inside &= vec3_dot(normal, vec3_cross(side, vec3_sub(hit, t[k]))) > 0;
    }
    return inside;
}

/* The number of edges of face i that pass through face j without touching its corners. */
static size_t piercings(const struct model *model, size_t i, size_t j) {
    const struct corner *ci = model->faces[i].corner, *cj = model->faces[j].corner;
    struct vec3 a[3], b[3];
    bool shared[3] = {false, false, false};
    for (size_t k = 0; k < 3; k++) {
        a[k] = model_position(model, i, k);
        b[k] = model_position(model, j, k);
        for (size_t l = 0; l < 3; l++) {
            shared[k] |= ci[k].position == cj[l].position;
        }
    }
    size_t count = 0;
    for (int k = 0; k < 3; k++) {
        int next = (k + 1) % 3;
        count += !shared[k] && !shared[next] && pierces(a[k], a[next], b);
    }
    return count;
}

/* The surface nowhere passes through itself. */
static void check_embedded(const struct model *model, const char *name) {
    double(*boxes)[4] = malloc(model->face_count * sizeof *boxes); /* least and greatest x and y */
    if (!CHECK_ROW(boxes != NULL, name)) {
        return;
    }
    for (size_t i = 0; i < model->face_count; i++) {
        struct vec3 a = model_position(model, i, 0), b = model_position(model, i, 1);
        struct vec3 c = model_position(model, i, 2);
        boxes[i][0] = fmin(a.x, fmin(b.x, c.x));
        boxes[i][1] = fmax(a.x, fmax(b.x, c.x));
        boxes[i][2] = fmin(a.y, fmin(b.y, c.y));
        boxes[i][3] = fmax(a.y, fmax(b.y, c.y));
    }
    size_t crossings = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        for (size_t j = 0; j < model->face_count; j++) {
            bool apart = boxes[i][1] < boxes[j][0] || boxes[j][1] < boxes[i][0] ||
                         boxes[i][3] < boxes[j][2] || boxes[j][3] < boxes[i][2];
            crossings += apart || i == j ? 0 : piercings(model, i, j);
        }
    }
    CHECK_ROW(crossings == 0, name);
    free(boxes);
}

/* ---- The models ---- */

static bool read_model(struct model *model, const char *path) {
    struct error error = {0};
    bool is_read = model_read(model, path, &error);
    if (!is_read) {
        fprintf(stderr, "%s\n", error.message);
    }
    return CHECK(is_read) && CHECK(model->face_count > 0);
}

static void check_solid(const char *path, const char *name, bool is_obj, long characteristic,
                        double expected_volume) {
    struct model model;
    if (!read_model(&model, path)) {
        return;
    }
    check_manifold(&model, name, characteristic);
    check_connected(&model, name);
    check_positions(&model, name);
    check_faces(&model, name);
    check_embedded(&model, name);
    /* Flat faces cut a little off a round solid. */
    double share = volume(&model) / expected_volume;
    CHECK_ROW(share > 0.9 && share < 1, name);
    if (is_obj) {
        check_normals(&model, name);
        check_uvs(&model, name);
    }
    model_free(&model);
}

static const double pi = 3.14159265358979323846;

static void test_sphere(void) {
    check_solid(COURSE_MODELS "/sphere.obj", "sphere", true, 2, 4 * pi / 3 * 0.9 * 0.9 * 0.9);
}

static void test_torus(void) {
    check_solid(COURSE_MODELS "/torus.obj", "torus", true, 0, 2 * pi * pi * 0.6 * 0.3 * 0.3);
}

/* A tube's volume is its cross-section times its length (Pappus), whatever way it winds. */
static void test_knot(void) {
    double length = 0;
    for (int i = 0; i < 3000; i++) {
        double ends[2][3];
        for (int k = 0; k < 2; k++) {
            double a = 2 * pi * (i + k) / 3000, reach = 0.5 + 0.21 * cos(3 * a);
            ends[k][0] = reach * cos(2 * a);
            ends[k][1] = reach * sin(2 * a);
            ends[k][2] = 0.26 * sin(3 * a);
        }
        length += sqrt((ends[1][0] - ends[0][0]) * (ends[1][0] - ends[0][0]) +
                       (ends[1][1] - ends[0][1]) * (ends[1][1] - ends[0][1]) +
                       (ends[1][2] - ends[0][2]) * (ends[1][2] - ends[0][2]));
    }
    check_solid(COURSE_MODELS "/knot.off", "knot", false, 0, length * pi * 0.15 * 0.15);
}

static void test_bust_mesh(void) {
    struct model model;
    if (!read_model(&model, COURSE_MODELS "/bust.obj")) {
        return;
    }
    CHECK(model.face_count >= 2500 && model.face_count <= 5000);
    check_manifold(&model, "bust", 2);
    check_connected(&model, "bust");
    check_positions(&model, "bust");
    check_faces(&model, "bust");
    check_normals(&model, "bust");
    check_uvs(&model, "bust");
    check_embedded(&model, "bust");
    CHECK(volume(&model) > 0);
    size_t uv_apart = 0, normal_apart = 0;
    for (size_t i = 0; i < model.face_count; i++) {
        for (int k = 0; k < 3; k++) {
            const struct corner *c = &model.faces[i].corner[k];
            uv_apart += c->uv != c->position;
            normal_apart += c->normal != c->position;
        }
    }
    CHECK(uv_apart > 0 && normal_apart > 0); /* a reader that mixes the indices up is found out */
    model_free(&model);
}

/* The two halves mirror each other. */
static void test_bust_symmetry(void) {
    struct model model;
    if (!read_model(&model, COURSE_MODELS "/bust.obj")) {
        return;
    }
    struct vec3 *sorted = sorted_positions(&model);
    size_t lonely = 0;
    for (size_t i = 0; sorted != NULL && i < model.position_count; i++) {
        struct vec3 image = {0 - sorted[i].x, sorted[i].y, sorted[i].z};
        lonely += bsearch(&image, sorted, model.position_count, sizeof *sorted,
                          compare_positions) == NULL;
    }
    CHECK(sorted != NULL && lonely == 0);
    free(sorted);
    model_free(&model);
}

/* The head fills the frame, and what stands where on it: a nose before the lips, ears at the side,
 * a neck that is narrower than the jaw, shoulders that are wider than both. */
static void test_bust_proportions(void) {
    struct model model;
    if (!read_model(&model, COURSE_MODELS "/bust.obj")) {
        return;
    }
    double low = 1, high = -1, nose_z = -1, nose_y = 0, brow_z = -1, lip_z = -1;
    double head = 0, neck = 1, shoulders = 0;
    for (size_t i = 0; i < model.position_count; i++) {
        double x = fabs(model.positions[i].x), y = model.positions[i].y;
        double z = model.positions[i].z;
        low = fmin(low, y);
        high = fmax(high, y);
        if (z > nose_z) {
            nose_z = z;
            nose_y = y;
        }
        brow_z = y > 0.42 && y < 0.5 ? fmax(brow_z, z) : brow_z;
        lip_z = y > -0.06 && y < 0.06 ? fmax(lip_z, z) : lip_z;
        head = y > 0.3 ? fmax(head, x) : head;
        shoulders = y < -0.6 ? fmax(shoulders, x) : shoulders;
    }
    /* The neck's width at its narrowest: of all heights there, the smallest reach to the side. */
    for (int step = 0; step < 6; step++) {
        double reach = 0, y = -0.40 + 0.03 * step;
        for (size_t i = 0; i < model.position_count; i++) {
            if (fabs(model.positions[i].y - y) < 0.03) {
                reach = fmax(reach, fabs(model.positions[i].x));
            }
        }
        neck = fmin(neck, reach);
    }
    CHECK(low < -0.9 && high > 0.9);
    CHECK(nose_z > brow_z && nose_z > lip_z);
    CHECK(nose_y > 0.05 && nose_y < 0.3);
    CHECK(neck < head && head < shoulders);
    model_free(&model);
}

/* ---- The textures ---- */

static bool read_texture(struct image *image, const char *path, enum image_format format) {
    struct error error = {0};
    bool is_read = image_read(image, path, &error);
    if (!is_read) {
        fprintf(stderr, "%s\n", error.message);
    }
    return CHECK(is_read) && CHECK(image->width == 1024 && image->height == 1024) &&
           CHECK(image->format == format);
}

static struct color texel_at(const struct image *image, struct vec2 uv) {
    return image_get(image, (int)(uv.x * (double)image->width),
                     (int)(uv.y * (double)image->height));
}

static struct vec3 normal_from(struct color c) {
    return (struct vec3){c.r / 127.5 - 1, c.g / 127.5 - 1, c.b / 127.5 - 1};
}

static void test_bust_normal_map(void) {
    struct image map = {0};
    struct model model = {0};
    if (!read_texture(&map, COURSE_MODELS "/bust_nm.tga", IMAGE_BGR) ||
        !read_model(&model, COURSE_MODELS "/bust.obj")) {
        image_free(&map);
        return;
    }
    size_t bad = 0;
    for (int y = 0; y < 1024; y++) {
        for (int x = 0; x < 1024; x++) {
            bad += !(fabs(vec3_length(normal_from(image_get(&map, x, y))) - 1) < 0.01);
        }
    }
    CHECK(bad == 0);
    /* On the whole the map agrees with the mesh: were x, y and z mixed up, it would not. But it
     * holds more than the mesh: within a face it is not the same everywhere. */
    double agreement = 0;
    size_t finer = 0;
    for (size_t i = 0; i < model.face_count; i++) {
        struct vec3 face = vec3_normalized(twice_area(&model, i));
        struct vec2 a = model_uv(&model, i, 0), b = model_uv(&model, i, 1),
                    c = model_uv(&model, i, 2);
        struct vec2 middle = {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
        struct vec2 beside = {(middle.x + a.x) / 2, (middle.y + a.y) / 2};
        struct vec3 n = vec3_normalized(normal_from(texel_at(&map, middle)));
        agreement += vec3_dot(face, n) / (double)model.face_count;
        finer += vec3_dot(n, vec3_normalized(normal_from(texel_at(&map, beside)))) < 0.9998;
    }
    CHECK(agreement > 0.85);
    CHECK(finer > model.face_count / 2);
    image_free(&map);
    model_free(&model);
}

/* The texture coordinate of the foremost point at (x, y), as seen from the front. */
static struct vec2 uv_in_front(const struct model *model, double x, double y) {
    struct vec2 best = {0, 0};
    double nearest = -2;
    for (size_t i = 0; i < model->face_count; i++) {
        struct vec3 a = model_position(model, i, 0), b = model_position(model, i, 1);
        struct vec3 c = model_position(model, i, 2);
        double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        double wb = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
        double wc = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
        struct vec3 weight = {1 - wb - wc, wb, wc};
        double z = interpolate(weight, a.z, b.z, c.z);
        if (area > 0 && weight.x >= 0 && wb >= 0 && wc >= 0 && z > nearest) {
            nearest = z;
            best = vec2_interpolate(weight, model_uv(model, i, 0), model_uv(model, i, 1),
                                    model_uv(model, i, 2));
        }
    }
    CHECK(nearest > -2);
    return best;
}

struct mean {
    double r, g, b;
};

/* The mean of the (2 * reach + 1) squared texels around a point of the face. */
static struct mean mean_near(const struct image *image, const struct model *model,
                             struct vec2 point, int reach) {
    struct vec2 uv = uv_in_front(model, point.x, point.y);
    int x = (int)(uv.x * (double)image->width), y = (int)(uv.y * (double)image->height);
    struct mean sum = {0, 0, 0};
    double count = (2 * reach + 1) * (2 * reach + 1);
    for (int j = y - reach; j <= y + reach; j++) {
        for (int i = x - reach; i <= x + reach; i++) {
            struct color c = image_get(image, i, j);
            sum.r += c.r / count;
            sum.g += c.g / count;
            sum.b += c.b / count;
        }
    }
    return sum;
}

/* Points of the face seen from the front, by the proportions of any drawing manual for a head that
 * reaches from -0.22 to 0.95. */
static const struct vec2 forehead = {0, 0.60}, nose = {0, 0.18}, lip = {0.03, -0.03};
static const struct vec2 cheek = {0.20, 0.16}, eyebrow = {0.14, 0.46}, jaw = {0.17, -0.08};
static const struct vec2 hair = {0.08, 0.88};

static void test_bust_shine(void) {
    struct image map = {0};
    struct model model = {0};
    if (read_texture(&map, COURSE_MODELS "/bust_spec.tga", IMAGE_GREY) &&
        read_model(&model, COURSE_MODELS "/bust.obj")) {
        double dull = mean_near(&map, &model, cheek, 12).r;
        CHECK(mean_near(&map, &model, forehead, 12).r > 1.3 * dull);
        CHECK(mean_near(&map, &model, nose, 8).r > 1.3 * dull);
        CHECK(mean_near(&map, &model, lip, 6).r > 1.3 * dull);
    }
    image_free(&map);
    model_free(&model);
}

static void test_bust_colors(void) {
    struct image map = {0};
    struct model model = {0};
    if (read_texture(&map, COURSE_MODELS "/bust_diffuse.tga", IMAGE_BGR) &&
        read_model(&model, COURSE_MODELS "/bust.obj")) {
        struct mean brow = mean_near(&map, &model, forehead, 12);
        struct mean mouth = mean_near(&map, &model, lip, 6);
        struct mean beard = mean_near(&map, &model, jaw, 12);
        CHECK(brow.r > brow.g && brow.g > brow.b);                   /* skin */
        CHECK(mean_near(&map, &model, eyebrow, 2).g < 0.7 * brow.g); /* dark brows */
        CHECK(mean_near(&map, &model, hair, 12).g < 0.7 * brow.g);   /* dark hair */
        CHECK(mouth.r / mouth.g > 1.15 * brow.r / brow.g);           /* red lips */
        CHECK(beard.g < 0.95 * brow.g);                              /* stubble */
    }
    image_free(&map);
    model_free(&model);
}

UNIT_MAIN(TEST(test_sphere), TEST(test_torus), TEST(test_knot), TEST(test_bust_mesh),
          TEST(test_bust_symmetry), TEST(test_bust_proportions), TEST(test_bust_normal_map),
          TEST(test_bust_shine), TEST(test_bust_colors))
