/* Lines, triangles and models from a seed: see inputs.h. */
#include "inputs.h"

#include "base/file.h"
#include "geometry.h"
#include "tgaimage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    UNIT = 1024, /* parts of 1 in a model's positions, parts of 1 pixel in a triangle's */
    SHAPES = 24, /* lines or triangles of a text scene */
    GRID = 7,    /* faces along an edge of the octahedron that a body is made from */
    BODY_POSITIONS = 4 * GRID * GRID + 2,
    BODY_FACES = 8 * GRID * GRID,
    BODIES = 2,
    TEXTURE_SIZE = 64,
    TEXTURE_BLOCK = 4 /* texels of a side that have the same colour */
};

/* ---- Numbers ---- */

uint64_t random_next(struct random *random) {
    uint64_t z = random->state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
}

int random_between(struct random *random, int least, int most) {
    return least + (int)(random_next(random) % (uint64_t)(most - least + 1));
}

/* 0 to count - 1 in some order. */
static void shuffle(size_t *order, size_t count, uint64_t seed, bool shuffled) {
    struct random random = {seed};
    for (size_t i = 0; i < count; i++) {
        order[i] = i;
    }
    for (size_t i = count; shuffled && i > 1; i--) {
        size_t j = (size_t)(random_next(&random) % i), kept = order[i - 1];
        order[i - 1] = order[j];
        order[j] = kept;
    }
}

/* ---- Text scenes ---- */

struct shape {
    int x[3], y[3]; /* pixels of a line's ends; 1/UNIT pixels of a triangle's corners */
    int color[3][3];
};

static void make_colors(struct shape *shape, struct random *random, bool one_color) {
    for (int i = 0; i < 3; i++) {
        for (int channel = 0; channel < 3; channel++) {
            shape->color[i][channel] =
                i > 0 && one_color ? shape->color[0][channel] : random_between(random, 40, 255);
        }
    }
}

/* How far it is from one end to the other along the axis in which that is more. */
static int run_of(const struct shape *line) {
    int across = abs(line->x[1] - line->x[0]), up = abs(line->y[1] - line->y[0]);
    return across > up ? across : up;
}

/* In how many directions that are drawn without any rounding a line goes: along x, y, both, one
 * against the other, nowhere. */
enum { PLAIN_DIRECTIONS = 5 };

static void make_plain(struct shape *line, int direction) {
    static const int across[PLAIN_DIRECTIONS] = {1, 0, 1, 1, 0},
                     up[PLAIN_DIRECTIONS] = {0, 1, 1, -1, 0};
    int length = (line->x[1] - line->x[0]) % 100;
    line->x[1] = line->x[0] + across[direction] * length;
    line->y[1] = line->y[0] + up[direction] * length;
}

/* Lines of all directions, some of which leave the image; the first ones are special. */
static void make_lines(struct shape *shapes, struct random *random, enum input_kind kind) {
    bool one_color = kind != INPUT_GRADIENT_LINES;
    for (int i = 0; i < SHAPES; i++) {
        struct shape *line = &shapes[i];
        for (int j = 0; j < 2; j++) {
            line->x[j] = random_between(random, one_color ? -100 : 0, one_color ? 350 : 255);
            line->y[j] = random_between(random, one_color ? -100 : 0, one_color ? 350 : 255);
        }
        if (i < 4 || kind == INPUT_AXIS_LINES) {
            make_plain(line, (i + 1) % PLAIN_DIRECTIONS);
        } else if (kind == INPUT_ODD_LINES) {
            while (run_of(line) % 2 == 0) {
                line->x[1] += run_of(line) == abs(line->x[1] - line->x[0]);
                line->y[1] += run_of(line) == abs(line->y[1] - line->y[0]);
            }
        }
        make_colors(line, random, one_color);
    }
}

/* Triangles that are not thin. All are of one colour where their order must not matter. */
static void make_triangles(struct shape *shapes, struct random *random, bool one_color) {
    for (int i = 0; i < SHAPES; i++) {
        int64_t area = 0;
        while (llabs(area) < (int64_t)900 * UNIT * UNIT) {
            for (int j = 0; j < 3; j++) {
                shapes[i].x[j] = random_between(random, -40 * UNIT, 296 * UNIT) / 4 * 4;
                shapes[i].y[j] = random_between(random, -40 * UNIT, 296 * UNIT) / 4 * 4;
            }
            const int *x = shapes[i].x, *y = shapes[i].y;
            area = (int64_t)(x[1] - x[0]) * (y[2] - y[0]) - (int64_t)(x[2] - x[0]) * (y[1] - y[0]);
        }
        make_colors(&shapes[i], random, one_color);
        if (one_color && i > 0) {
            memcpy(shapes[i].color, shapes[0].color, sizeof shapes[i].color);
        }
    }
}

/* A line of a text scene: where its ends or corners are, then their colours. */
static bool put_shape(struct bytes *out, const struct shape *shape, int corners,
                      const struct variant *variant, bool one_color) {
    const bool is_line = corners == 2;
    const double unit = is_line ? 1 : UNIT;
    const int digits = is_line ? 0 : 10, first = is_line ? variant->reversed : variant->turned;
    bool done = bytes_print(out, is_line ? "line" : "triangle");
    for (int i = 0; i < corners && done; i++) {
        int corner = (i + first) % corners;
        done = bytes_print(out, " %.*f %.*f", digits, shape->x[corner] / unit + variant->right,
                           digits, shape->y[corner] / unit + variant->up);
    }
    for (int i = 0; i < (one_color ? 1 : corners) && done; i++) {
        const int *color = shape->color[(i + first) % corners];
        done = bytes_print(out, " %d %d %d", color[0], color[1], color[2]);
    }
    return done && bytes_print(out, "\n");
}

static bool put_text_scene(struct bytes *out, enum input_kind kind, uint64_t seed,
                           const struct variant *variant) {
    struct shape shapes[SHAPES];
    struct random random = {seed};
    size_t order[SHAPES];
    bool lines = kind <= INPUT_GRADIENT_LINES;
    bool one_color = kind != INPUT_GRADIENT_LINES && kind != INPUT_GRADIENT_TRIANGLES;
    if (lines) {
        make_lines(shapes, &random, kind);
    } else {
        make_triangles(shapes, &random, one_color);
    }
    shuffle(order, SHAPES, seed, variant->shuffled);
    bool done = bytes_print(out, "size %d %d\n", INPUT_SIZE, INPUT_SIZE);
    for (size_t i = 0; i < SHAPES && done; i++) {
        done = put_shape(out, &shapes[order[i]], lines ? 2 : 3, variant, one_color);
    }
    return done;
}

/* ---- Models ---- */

struct mesh {
    struct vec3 position[BODIES * BODY_POSITIONS]; /* multiples of 1/UNIT */
    struct vec3 normal[BODIES * BODY_POSITIONS];   /* of length 1 */
    struct vec2 uv[BODIES * BODY_POSITIONS];
    size_t face[BODIES * BODY_FACES][3]; /* counterclockwise seen from outside */
    size_t position_count, face_count;
};

static double snap(double value) {
    return floor(value * UNIT + 0.5) / UNIT;
}

/* A body: an octahedron with a grid on each side, blown up to an ellipsoid, then dented. */
struct body {
    struct vec3 center, radius;
    size_t number[2 * GRID + 1][2 * GRID + 1][2 * GRID + 1]; /* of positions, plus 1 */
};

/* The number of the position over the grid point (x, y, z), |x| + |y| + |z| = GRID. */
static size_t grid_position(struct mesh *mesh, struct body *body, struct random *random, int x,
                            int y, int z) {
    size_t *number = &body->number[x + GRID][y + GRID][z + GRID];
    if (*number == 0) {
        size_t i = mesh->position_count++;
        struct vec3 to = vec3_normalized((struct vec3){x, y, z}), r = body->radius;
        double size = random_between(random, 750, 1000) / 1000.0;
        mesh->position[i] = (struct vec3){snap(body->center.x + to.x * r.x * size),
                                          snap(body->center.y + to.y * r.y * size),
                                          snap(body->center.z + to.z * r.z * size)};
        mesh->normal[i] = vec3_normalized((struct vec3){to.x / r.x, to.y / r.y, to.z / r.z});
        mesh->uv[i] = (struct vec2){snap(0.5 + 0.45 * to.x), snap(0.5 + 0.45 * to.y)};
        *number = i + 1;
    }
    return *number - 1;
}

/* The face over three grid points of the octant with these signs, given there counterclockwise. */
static void add_face(struct mesh *mesh, struct body *body, struct random *random, const int sign[3],
                     const int point[3][2]) {
    size_t *face = mesh->face[mesh->face_count++];
    bool mirrored = sign[0] * sign[1] * sign[2] < 0;
    for (int i = 0; i < 3; i++) {
        int x = point[i][0], y = point[i][1], z = GRID - x - y;
        face[mirrored ? 2 - i : i] =
            grid_position(mesh, body, random, sign[0] * x, sign[1] * y, sign[2] * z);
    }
}

static void add_body(struct mesh *mesh, struct body *body, struct random *random) {
    for (int octant = 0; octant < 8; octant++) {
        const int sign[3] = {octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1};
        for (int x = 0; x < GRID; x++) {
            for (int y = 0; x + y < GRID; y++) {
                const int lower[3][2] = {{x, y}, {x + 1, y}, {x, y + 1}};
                const int upper[3][2] = {{x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
                add_face(mesh, body, random, sign, lower);
                if (x + y + 1 < GRID) {
                    add_face(mesh, body, random, sign, upper);
                }
            }
        }
    }
}

/* A number from least to most, in thousandths. */
static double random_part(struct random *random, int least, int most) {
    return random_between(random, least, most) / 1000.0;
}

static void make_mesh(struct mesh *mesh, uint64_t seed) {
    struct random random = {seed};
    for (int i = 0; i < BODIES; i++) {
        struct body body = {
            .radius = {random_part(&random, 400, 650), random_part(&random, 400, 650),
                       random_part(&random, 300, 500)},
            .center = {random_part(&random, -100, 100), random_part(&random, -100, 100), 0},
        };
        if (i > 0) { /* in front, half inside of the first */
            body.radius = vec3_scale(body.radius, 0.5);
            body.center = (struct vec3){random_part(&random, -300, 300),
                                        random_part(&random, -300, 300), 0.3};
        }
        add_body(mesh, &body, &random);
    }
}

static bool put_positions(struct bytes *out, const struct mesh *mesh, const char *before,
                          const struct variant *variant) {
    const struct vec3 moved = {2.0 * variant->right / INPUT_SIZE, 2.0 * variant->up / INPUT_SIZE,
                               0};
    bool done = true;
    for (size_t i = 0; i < mesh->position_count && done; i++) {
        struct vec3 p = vec3_add(mesh->position[i], moved);
        done = bytes_print(out, "%s%.10f %.10f %.10f\n", before, p.x, p.y, p.z);
    }
    return done;
}

static bool put_obj(struct bytes *out, const struct mesh *mesh, const size_t *order,
                    const struct variant *variant) {
    bool done = put_positions(out, mesh, "v ", variant);
    for (size_t i = 0; i < mesh->position_count && done; i++) {
        struct vec3 n = mesh->normal[i];
        done = bytes_print(out, "vt %.10f %.10f\nvn %.10f %.10f %.10f\n", mesh->uv[i].x,
                           mesh->uv[i].y, n.x, n.y, n.z);
    }
    for (size_t i = 0; i < mesh->face_count && done; i++) {
        done = bytes_print(out, "f");
        for (int j = 0; j < 3 && done; j++) {
            size_t number = mesh->face[order[i]][(j + variant->turned) % 3] + 1;
            done = bytes_print(out, " %zu/%zu/%zu", number, number, number);
        }
        done = done && bytes_print(out, "\n");
    }
    return done;
}

static bool put_off(struct bytes *out, const struct mesh *mesh, const size_t *order,
                    const struct variant *variant) {
    bool done = bytes_print(out, "OFF\n%zu %zu 0\n", mesh->position_count, mesh->face_count) &&
                put_positions(out, mesh, "", variant);
    for (size_t i = 0; i < mesh->face_count && done; i++) {
        const size_t *face = mesh->face[order[i]];
        done = bytes_print(out, "3 %zu %zu %zu\n", face[variant->turned],
                           face[(variant->turned + 1) % 3], face[(variant->turned + 2) % 3]);
    }
    return done;
}

static bool put_model(struct bytes *out, enum input_kind kind, uint64_t seed,
                      const struct variant *variant) {
    struct mesh *mesh = calloc(1, sizeof *mesh);
    size_t order[BODIES * BODY_FACES];
    if (mesh == NULL) {
        return false;
    }
    make_mesh(mesh, seed);
    shuffle(order, mesh->face_count, seed, variant->shuffled);
    bool done = (kind == INPUT_MODEL_OFF ? put_off : put_obj)(out, mesh, order, variant);
    free(mesh);
    return done;
}

/* ---- Textures ---- */

/* Blocks of random colours. */
static struct color diffuse_texel(struct random *random) {
    return color_rgb((uint8_t)random_between(random, 60, 255),
                     (uint8_t)random_between(random, 60, 255),
                     (uint8_t)random_between(random, 60, 255));
}

/* Blocks of normals that look to all sides of the front. */
static struct color normal_texel(struct random *random) {
    double x = random_part(random, -1000, 1000), y = random_part(random, -1000, 1000);
    struct vec3 n = vec3_normalized((struct vec3){x, y, random_part(random, 200, 1000)});
    return color_rgb((uint8_t)floor((n.x + 1) * 127.5 + 0.5),
                     (uint8_t)floor((n.y + 1) * 127.5 + 0.5),
                     (uint8_t)floor((n.z + 1) * 127.5 + 0.5));
}

static struct color specular_texel(struct random *random) {
    return color_grey((uint8_t)random_between(random, 5, 80));
}

static bool write_texture(const char *model, const char *ending, uint64_t seed,
                          struct color (*texel)(struct random *random), struct error *error) {
    struct image image;
    struct random random = {seed};
    char *path = string_format("%.*s%s", (int)(strrchr(model, '.') - model), model, ending);
    if (path == NULL || !image_create(&image, TEXTURE_SIZE, TEXTURE_SIZE, IMAGE_BGR, error)) {
        free(path);
        return error_out_of_memory(error);
    }
    for (int y = 0; y < TEXTURE_SIZE; y += TEXTURE_BLOCK) {
        for (int x = 0; x < TEXTURE_SIZE; x += TEXTURE_BLOCK) {
            struct color color = texel(&random);
            for (int row = y; row < y + TEXTURE_BLOCK; row++) {
                image_fill_row(&image, row, x, x + TEXTURE_BLOCK, color);
            }
        }
    }
    bool done = tga_write(&image, path, error);
    image_free(&image);
    free(path);
    return done;
}

static bool write_textures(const char *model, uint64_t seed, struct error *error) {
    return write_texture(model, "_diffuse.tga", seed + 1, diffuse_texel, error) &&
           write_texture(model, "_nm.tga", seed + 2, normal_texel, error) &&
           write_texture(model, "_spec.tga", seed + 3, specular_texel, error);
}

/* ---- Files ---- */

const char *input_name(enum input_kind kind) {
    switch (kind) {
    case INPUT_MODEL:
        return "scene.obj";
    case INPUT_MODEL_OFF:
        return "scene.off";
    default:
        return "scene.txt";
    }
}

bool input_write(const char *path, enum input_kind kind, uint64_t seed,
                 const struct variant *variant, struct error *error) {
    struct bytes out = {.data = NULL};
    bool model = kind == INPUT_MODEL;
    bool text = strcmp(input_name(kind), "scene.txt") == 0;
    bool made = (text ? put_text_scene : put_model)(&out, kind, seed, variant);
    bool done = (made || error_out_of_memory(error)) &&
                file_write(path, out.data, out.size, error) &&
                (!model || write_textures(path, seed, error));
    bytes_free(&out);
    return done;
}
