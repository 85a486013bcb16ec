/* Whole meshes: the same image in every order. */
#include "oracle/shown.h"
#include "pipeline.h"
#include "stress.h"

#include <string.h>

enum { SIZE = 24, FACE_LIMIT = 24, POSITION_LIMIT = 3 * FACE_LIMIT };

/* A mesh is made again from its seed when it is needed: a case stays small. */
struct mesh_case {
    uint64_t seed;
    uint64_t kind;
};

static void make_mesh_case(struct random *random, uint64_t index, void *made) {
    *(struct mesh_case *)made = (struct mesh_case){random_bits(random), index % 3};
}

struct world_mesh {
    struct model model;
    struct vec3 positions[POSITION_LIMIT];
    struct face faces[FACE_LIMIT];
};

/* Triangles through each other, at places that are whole 1/4096 of the image: a shift by whole
 * pixels is exact in them. */
static void build_soup(uint64_t seed, struct world_mesh *mesh) {
    struct random random = {seed};
    mesh->model = (struct model){.positions = mesh->positions, .faces = mesh->faces};
    size_t faces = (size_t)random_between(&random, 1, FACE_LIMIT);
    for (size_t i = 0; i < 3 * faces; i++) {
        struct vec3 *p = &mesh->positions[i];
        p->x = (double)random_between(&random, -1000, 1000) / 1024;
        p->y = (double)random_between(&random, -1000, 1000) / 1024;
        p->z = random_real(&random, -1, 1);
    }
    for (size_t i = 0; i < faces; i++) {
        for (uint32_t k = 0; k < 3; k++) {
            mesh->faces[i].corner[k] =
                (struct corner){(uint32_t)(3 * i) + k, MODEL_NONE, MODEL_NONE};
        }
    }
    mesh->model.position_count = 3 * faces;
    mesh->model.face_count = faces;
}

static void place_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    struct vec3 p = model_position(uniforms, face, corner);
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
    bool done = draw_frame(&pipeline, &call, &place_shader, &mesh->model, sizeof mesh->model, image,
                           &error);
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

const struct property mesh_properties[] = {
    PROPERTY("mesh: same image in every order", AGAINST_ITSELF, 20000, struct mesh_case,
             make_mesh_case, .holds = same_in_every_order),
    {.name = NULL},
};
