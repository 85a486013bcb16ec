/* Whole meshes: the same image in every order, no gaps when clipped. */
#include "oracle/shown.h"
#include "pipeline.h"
#include "stress.h"

#include <stdio.h>
#include <string.h>

enum { SIZE = 24, POSITION_LIMIT = 288, FACE_LIMIT = 160 };

/* A mesh is made again from its seed when it is needed: a case stays small. */
struct mesh_case {
    uint64_t seed;
    uint64_t kind;
};

static void make_mesh_case(struct random *random, uint64_t index, void *made) {
    *(struct mesh_case *)made = (struct mesh_case){random_bits(random), index % 3};
}

/* ---- The same image in every order ---- */

struct world_mesh {
    struct model model;
    struct vec3 positions[POSITION_LIMIT];
    struct face faces[FACE_LIMIT];
};

static void set_face(struct face *face, uint32_t a, uint32_t b, uint32_t c) {
    *face = (struct face){
        {{a, MODEL_NONE, MODEL_NONE}, {b, MODEL_NONE, MODEL_NONE}, {c, MODEL_NONE, MODEL_NONE}}};
}

/* Triangles through each other, at places that are whole 1/4096 of the image: a shift by whole
 * pixels is exact in them. */
static void build_soup(uint64_t seed, struct world_mesh *mesh) {
    struct random random = {seed};
    mesh->model = (struct model){.positions = mesh->positions, .faces = mesh->faces};
    size_t faces = (size_t)random_between(&random, 1, 24);
    for (size_t i = 0; i < 3 * faces; i++) {
        struct vec3 *p = &mesh->positions[i];
        p->x = (double)random_between(&random, -1000, 1000) / 1024;
        p->y = (double)random_between(&random, -1000, 1000) / 1024;
        p->z = random_real(&random, -1, 1);
    }
    for (size_t i = 0; i < faces; i++) {
        uint32_t first = (uint32_t)(3 * i);
        set_face(&mesh->faces[i], first, first + 1, first + 2);
    }
    mesh->model.position_count = 3 * faces;
    mesh->model.face_count = faces;
}

struct place_uniforms {
    const struct model *model;
};

static void place_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct place_uniforms *u = uniforms;
    struct vec3 p = model_position(u->model, face, corner);
    varyings[0] = p.x;
    varyings[1] = p.y;
    varyings[2] = p.z;
}

static lanes_mask place_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(128 + 120 * varyings[0], 128 + 120 * varyings[1], 128 + 120 * varyings[2]);
    return lanes_all_set();
}

SHADER(place_shader, .varying_count = 3, .vertex = place_vertex, .fragment = place_fragment);

/* Draw in a viewport at (left, bottom) of an image twice as large. */
static bool draw_soup(const struct world_mesh *mesh, double distance, int left, int bottom,
                      bool skip, struct image *image) {
    struct error error;
    struct pipeline pipeline;
    struct place_uniforms uniforms = {&mesh->model};
    struct draw_call call = {.model = &mesh->model,
                             .to_clip = mat4_projection(distance),
                             .viewport = {left, bottom, SIZE, SIZE}};
    if (!image_create(image, 2 * SIZE, 2 * SIZE, IMAGE_BGR, &error)) {
        return false;
    }
    if (!pipeline_create(&pipeline, 2 * SIZE, 2 * SIZE, &error)) {
        return false;
    }
    pipeline.skip = skip;
    pipeline_use_threads(&pipeline, 1 + (size_t)(left * bottom) % 61 / 59);
    bool done =
        draw_frame(&pipeline, &call, &place_shader, &uniforms, sizeof uniforms, image, &error);
    pipeline_free(&pipeline);
    return done;
}

/* Faces in another order, each beginning with another corner. */
static void shuffle(struct world_mesh *mesh, struct random *random) {
    size_t n = mesh->model.face_count;
    for (size_t i = n - 1; i > 0; i--) {
        size_t k = (size_t)random_between(random, 0, (int64_t)i);
        struct face kept = mesh->faces[i];
        mesh->faces[i] = mesh->faces[k];
        mesh->faces[k] = kept;
    }
    for (size_t i = 0; i < n; i++) {
        struct face *f = &mesh->faces[i], kept = *f;
        size_t turn = (size_t)random_between(random, 0, 2);
        for (size_t k = 0; k < 3; k++) {
            f->corner[k] = kept.corner[(k + turn) % 3];
        }
    }
}

static bool same_in_every_order(const void *tried) {
    const struct mesh_case *c = tried;
    struct world_mesh mesh;
    struct image image = {0}, other = {0};
    struct random random = {c->seed ^ 0x5555};
    double distance = c->kind == 0 ? INFINITY : 2.5;
    build_soup(c->seed, &mesh);
    int dx = (int)random_between(&random, 0, SIZE), dy = (int)random_between(&random, 0, SIZE);
    bool same = draw_soup(&mesh, distance, 0, 0, true, &image);
    shuffle(&mesh, &random);
    same = same && draw_soup(&mesh, distance, dx, dy, c->kind != 2, &other);
    for (int y = 0; same && y < SIZE; y++) {
        for (int x = 0; same && x < SIZE; x++) {
            struct color a = image_get(&image, x, y), b = image_get(&other, x + dx, y + dy);
            same = a.r == b.r && a.g == b.g && a.b == b.b;
        }
    }
    image_free(&image);
    image_free(&other);
    return same;
}

static void print_soup(const void *failing) {
    const struct mesh_case *c = failing;
    struct world_mesh mesh;
    build_soup(c->seed, &mesh);
    printf("    # camera at distance %s, %s\n", c->kind == 0 ? "infinity" : "2.5",
           c->kind == 2 ? "shaded at once" : "visible only");
    for (size_t i = 0; i < mesh.model.position_count; i++) {
        struct vec3 p = mesh.positions[i];
        printf("    v %.17g %.17g %.17g\n", p.x, p.y, p.z);
    }
    for (size_t i = 0; i < mesh.model.face_count; i++) {
        printf("    f %zu %zu %zu\n", 3 * i + 1, 3 * i + 2, 3 * i + 3);
    }
}

/* ---- Clipping without gaps ---- */

/* A plane that goes through the camera's near plane and far out of the guard band, in up to 98
 * triangles. Each pixel that sees the inside of the plane must be drawn once, all others never. */
enum { COUNT_SIZE = 16 };

struct count_uniforms {
    const struct model *model;
    size_t reversed; /* how many faces are listed in reverse; 0: they are listed in order */
};

/* The number of the face, from 1. */
static void count_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct count_uniforms *u = uniforms;
    (void)corner;
    varyings[0] = (double)(u->reversed > 0 ? u->reversed - face : face + 1);
}

static lanes_mask count_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    *color = lanes_rgb(varyings[0], varyings[0], varyings[0]);
    return lanes_all_set();
}

SHADER(count_shader, .varying_count = 1, .flat = true, .vertex = count_vertex,
       .fragment = count_fragment);

struct plane {
    struct world_mesh mesh;
    struct vec3 origin, u, v; /* the mesh covers origin + a u + b v for 0 <= a, b <= 1 */
    struct mat4 to_clip;
};

static float rounded(double x) {
    return (float)x;
}

static void build_plane(const struct mesh_case *c, struct plane *plane) {
    struct random random = {c->seed};
    static const double sizes[] = {3, 30, 1000, 1e5};
    double size = sizes[c->kind % 4];
    size_t n = (size_t)random_between(&random, 1, 7);
    /* Sides u and v at right angles, in any direction, around a point near the camera at z = 2. */
    struct vec3 a = {random_real(&random, -1, 1), random_real(&random, -1, 1),
                     random_real(&random, -1, 1)};
    struct vec3 b = {random_real(&random, -1, 1), random_real(&random, -1, 1),
                     random_real(&random, -1, 1)};
    struct vec3 u = vec3_normalized(a);
    struct vec3 v = vec3_normalized(vec3_cross(u, b));
    struct vec3 middle = {random_real(&random, -1, 1), random_real(&random, -1, 1),
                          random_real(&random, -1, 3)};
    plane->u = vec3_scale(u, size);
    plane->v = vec3_scale(v, size);
    plane->origin = vec3_sub(middle, vec3_scale(vec3_add(plane->u, plane->v), 0.5));
    plane->to_clip = mat4_projection(2);
    plane->mesh.model =
        (struct model){.positions = plane->mesh.positions, .faces = plane->mesh.faces};
    struct model *model = &plane->mesh.model;
    for (size_t i = 0; i <= n; i++) {
        for (size_t k = 0; k <= n; k++) {
            struct vec3 p =
                vec3_add(plane->origin, vec3_add(vec3_scale(plane->u, (double)i / (double)n),
                                                 vec3_scale(plane->v, (double)k / (double)n)));
            plane->mesh.positions[model->position_count++] =
                (struct vec3){rounded(p.x), rounded(p.y), rounded(p.z)};
        }
    }
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < n; k++) {
            uint32_t p = (uint32_t)(i * (n + 1) + k), q = p + (uint32_t)n + 1;
            struct face *f = &plane->mesh.faces[model->face_count];
            set_face(f, p, q, random_bits(&random) % 2 ? q + 1 : p + 1);
            bool other_way = f->corner[2].position == p + 1;
            set_face(f + 1, other_way ? q : p, q + 1, p + 1);
            model->face_count += 2;
        }
    }
}

/* What a ray through a pixel's centre must find. It is unsure near the plane's border and the near
 * plane, where rounding of the corners decides: such a pixel may be drawn, but only once. A
 * plane seen edge-on is as thin as the snapping to 1/256 pixel, which may turn a triangle over:
 * nothing is asked. */
enum ray { RAY_MISSES, RAY_HITS, RAY_UNSURE, RAY_EDGE_ON };

static enum ray follow_ray(const struct plane *plane, int x, int y) {
    long double hits[2] = {0, 0};
    long double nx = (x + 0.5L) * 2 / COUNT_SIZE - 1, ny = (y + 0.5L) * 2 / COUNT_SIZE - 1;
    /* The ray from the eye (0, 0, 2) with direction (nx, ny, -2): there w = 1 at z = 0. */
    long double dx = nx, dy = ny, dz = -2;
    struct vec3 n = vec3_cross(plane->u, plane->v), o = plane->origin;
    long double along = (long double)n.x * dx + (long double)n.y * dy + (long double)n.z * dz;
    long double to_plane = (long double)n.x * (long double)o.x +
                           (long double)n.y * (long double)o.y +
                           (long double)n.z * ((long double)o.z - 2);
    long double length = sqrtl((long double)vec3_dot(n, n));
    long double size = sqrtl((long double)vec3_dot(plane->u, plane->u));
    bool through_eye = fabsl(to_plane) < (0.001L + 1e-6L * size) * length;
    if (through_eye || fabsl(along) < 0.05L * length) {
        return RAY_EDGE_ON;
    }
    long double w = to_plane / along; /* = depth along the ray, with w = 1 at z = 0 */
    if (fabsl(w - 1.0L / 128) < 0.002L) {
        return RAY_UNSURE;
    }
    long double px = dx * w - (long double)o.x, py = dy * w - (long double)o.y;
    long double pz = 2 + dz * w - (long double)o.z;
    const struct vec3 *sides[2] = {&plane->u, &plane->v};
    enum ray ray = w > 1.0L / 128 ? RAY_HITS : RAY_MISSES;
    for (int i = 0; i < 2; i++) {
        const struct vec3 *s = sides[i];
        hits[i] = (px * (long double)s->x + py * (long double)s->y + pz * (long double)s->z) /
                  (long double)vec3_dot(*s, *s);
        /* A border moves by what snapping and the floats of the corners allow: some of a pixel. */
        long double tolerance = 0.02L + 0.1L * fabsl(w) / sqrtl((long double)vec3_dot(*s, *s));
        if (ray == RAY_HITS && (fabsl(hits[i]) < tolerance || fabsl(hits[i] - 1) < tolerance)) {
            return RAY_UNSURE;
        }
        if (hits[i] < 0 || hits[i] > 1) {
            ray = RAY_MISSES;
        }
    }
    return ray;
}

/* Which face shows at each pixel, from 1, when all have the same depth: the first one that covers
 * it; the last one when they are drawn in reverse. */
static bool show_faces(const struct plane *plane, bool reverse,
                       uint8_t shown[COUNT_SIZE * COUNT_SIZE], uint64_t stats[PIPELINE_STATS]) {
    struct error error;
    struct pipeline pipeline;
    uint8_t pixels[COUNT_SIZE * COUNT_SIZE * 3] = {0};
    struct image image = {COUNT_SIZE, COUNT_SIZE, IMAGE_BGR, pixels};
    struct face faces[FACE_LIMIT];
    struct model model = plane->mesh.model;
    model.faces = faces;
    for (size_t i = 0; i < model.face_count; i++) {
        faces[i] = plane->mesh.faces[reverse ? model.face_count - 1 - i : i];
    }
    struct count_uniforms uniforms = {&model, reverse ? model.face_count : 0};
    struct draw_call call = {
        .model = &model, .to_clip = plane->to_clip, .viewport = {0, 0, COUNT_SIZE, COUNT_SIZE}};
    memset(call.to_clip.m[2], 0, sizeof call.to_clip.m[2]);
    bool done = pipeline_create(&pipeline, COUNT_SIZE, COUNT_SIZE, &error);
    pipeline.counts_tests = true;
    done = done &&
           draw_frame(&pipeline, &call, &count_shader, &uniforms, sizeof uniforms, &image, &error);
    memcpy(stats, pipeline.stats, sizeof pipeline.stats);
    pipeline_free(&pipeline);
    for (size_t i = 0; i < COUNT_SIZE * COUNT_SIZE; i++) {
        shown[i] = pixels[3 * i];
    }
    return done;
}

/* How often each pixel is drawn: 2 stands for more than once, by different faces. That no face
 * draws one twice by itself is seen in `all`, how often pixels are drawn altogether. */
static bool count_plane(const struct plane *plane, unsigned char times[COUNT_SIZE][COUNT_SIZE],
                        uint64_t *all) {
    uint64_t stats[PIPELINE_STATS];
    uint8_t first[COUNT_SIZE * COUNT_SIZE] = {0}, last[COUNT_SIZE * COUNT_SIZE] = {0};
    bool done = show_faces(plane, true, last, stats) && show_faces(plane, false, first, stats);
    for (size_t i = 0; i < COUNT_SIZE * COUNT_SIZE; i++) {
        times[i / COUNT_SIZE][i % COUNT_SIZE] =
            (unsigned char)((first[i] > 0) + (first[i] != last[i]));
    }
    *all = stats[STAT_PIXELS_COVERED];
    return done;
}

static bool clipped_without_gaps(const void *tried) {
    struct plane plane;
    unsigned char times[COUNT_SIZE][COUNT_SIZE];
    uint64_t all, sum = 0;
    bool edge_on = false;
    build_plane(tried, &plane);
    if (!count_plane(&plane, times, &all)) {
        return false;
    }
    for (int y = 0; y < COUNT_SIZE; y++) {
        for (int x = 0; x < COUNT_SIZE; x++) {
            enum ray ray = follow_ray(&plane, x, y);
            unsigned least = ray == RAY_HITS, most = ray != RAY_MISSES;
            if (ray != RAY_EDGE_ON && (times[y][x] < least || times[y][x] > most)) {
                return false;
            }
            edge_on = edge_on || ray == RAY_EDGE_ON;
            sum += times[y][x];
        }
    }
    return edge_on || sum == all;
}

static void make_plane_case(struct random *random, uint64_t index, void *made) {
    *(struct mesh_case *)made = (struct mesh_case){random_bits(random), index % 4};
}

static void print_plane(const void *failing) {
    struct plane plane;
    build_plane(failing, &plane);
    printf("    # camera at z = 2, image %dx%d\n", COUNT_SIZE, COUNT_SIZE);
    for (size_t i = 0; i < plane.mesh.model.position_count; i++) {
        struct vec3 p = plane.mesh.positions[i];
        printf("    v %.17g %.17g %.17g\n", p.x, p.y, p.z);
    }
    for (size_t i = 0; i < plane.mesh.model.face_count; i++) {
        const struct corner *c = plane.mesh.faces[i].corner;
        printf("    f %u %u %u\n", (unsigned)c[0].position + 1, (unsigned)c[1].position + 1,
               (unsigned)c[2].position + 1);
    }
}

static const struct case_kind mesh_in_order_cases = {sizeof(struct mesh_case), make_mesh_case,
                                                     print_soup};
static const struct case_kind plane_cases = {sizeof(struct mesh_case), make_plane_case,
                                             print_plane};

const struct property mesh_properties[] = {
    PROPERTY("mesh: same image in every order", AGAINST_ITSELF, 20000, mesh_in_order_cases,
             .holds = same_in_every_order),
    PROPERTY("mesh: clipped without gaps", AGAINST_LONG_DOUBLE, 40000, plane_cases,
             .holds = clipped_without_gaps), /* of 32 triangles in the mean: more than a million */
    {.name = NULL},
};
