/*
 * Lesson 3's benchmark: ways to fill a triangle, on a mesh of small ones and on a fan of large
 * ones that reach far beyond the image. Every other side of the fan goes through many pixel
 * centres; the values at the rest need more digits than a float has.
 *
 * All versions write rows with image_fill_row(), except the one by borders, which fills columns.
 * Each triangle has its own colour, and each version too: so the picture of the last run says which
 * triangle each pixel shows. The error counts the pixels for which 128-bit integers say another
 * one.
 */
#define LESSON "../step03_triangle/main.c"
#include "lesson.h"

#include "../../../step03_triangle/attempts.h"

#include "bench/bench.h"
#include "oracle/oracle.h"

#include <stdlib.h>

/* ---- Attempt 8, which needs the edge functions of the lesson ---- */

enum { ATTEMPT_BLOCK = 8 }; /* pixels a side */

enum block_kind { BLOCK_OUTSIDE, BLOCK_INSIDE, BLOCK_MIXED };

/* Where the pixel centres of the block at (x,y) lie, from the values of each edge function at the
 * two of them that are farthest in and farthest out. */
static enum block_kind attempt_block_kind(const struct edges *edges, int x, int y) {
    enum block_kind kind = BLOCK_INSIDE;
    for (int i = 0; i < 3; i++) {
        const struct edge *e = &edges->edge[i];
        int64_t value = e->origin + e->dx * x + e->dy * y;
        int64_t across = e->dx * (ATTEMPT_BLOCK - 1), up = e->dy * (ATTEMPT_BLOCK - 1);
        int64_t most = value + (across > 0 ? across : 0) + (up > 0 ? up : 0);
        int64_t least = value + (across < 0 ? across : 0) + (up < 0 ? up : 0);
        if (most < e->least) {
            return BLOCK_OUTSIDE;
        }
        if (least < e->least) {
            kind = BLOCK_MIXED;
        }
    }
    return kind;
}

/* Attempt 8: blocks of 8x8 pixels, with exact edge functions: a block is outside, inside, or its
 * pixels are tested one by one. Right. It pays where a block can be left out as a whole (a coarse
 * depth, for example) and on graphics processors; for small triangles nearly all blocks are mixed,
 * and pixels outside are tested all the time. */
static void attempt_8_blocks(struct image *image, const struct vec2 p[3], struct color color) {
    struct fixed2 corner[3];
    struct edges edges;
    if (!snap_corners(p, corner) ||
        !edges_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        return;
    }
    struct attempt_box box = attempt_box(image, p);
    for (int y = edges.y_begin; y < edges.y_end; y += ATTEMPT_BLOCK) {
        for (int x = box.x_begin; x < box.x_end; x += ATTEMPT_BLOCK) {
            enum block_kind kind = attempt_block_kind(&edges, x, y);
            int y_end = y + ATTEMPT_BLOCK < edges.y_end ? y + ATTEMPT_BLOCK : edges.y_end;
            int x_end = x + ATTEMPT_BLOCK < edges.width ? x + ATTEMPT_BLOCK : edges.width;
            for (int v = y; v < y_end && kind != BLOCK_OUTSIDE; v++) {
                int begin = kind == BLOCK_INSIDE ? x : -1;
                for (int u = x; u < x_end && kind == BLOCK_MIXED; u++) {
                    attempt_test(image, &begin, u, v, edges_cover(&edges, u, v), color);
                }
                attempt_test(image, &begin, x_end, v, false, color);
            }
        }
    }
}

/* ---- What is drawn ---- */

enum {
    SIDE = 800,                    /* of the image */
    LARGE_REACH = 668 * SUBPIXELS, /* the rim of the fan is 6 times as far from its middle */
};

/* ---- Meshes, and which triangle each pixel shows ---- */

struct filled {
    struct fixed2 snapped[3];
    struct vec2 corner[3]; /* the same in pixels */
};

struct mesh {
    struct filled *triangles;
    size_t count;
    uint32_t shown[SIDE * SIDE]; /* triangle + 1 at each pixel of the image, 0 for none */
    size_t pixel_count;          /* that show one */
};

enum { SMALL, LARGE, MESH_COUNT };

static struct {
    struct mesh meshes[MESH_COUNT];
    struct image image; /* IMAGE_BGR, as the scenes are */
} bench;

/* The triangles in their order, each over those before it. */
static void mesh_find_shown(struct mesh *mesh) {
    for (size_t i = 0; i < mesh->count; i++) {
        const struct fixed2 *c = mesh->triangles[i].snapped;
        struct rectangle box = oracle_box(c, SIDE, SIDE);
        for (int y = box.y; y < box.y + box.height; y++) {
            for (int x = box.x; x < box.x + box.width; x++) {
                if (oracle_covers(c[0], c[1], c[2], x, y)) {
                    mesh->shown[y * SIDE + x] = (uint32_t)i + 1;
                }
            }
        }
    }
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        mesh->pixel_count += mesh->shown[i] != 0;
    }
}

static void mesh_add(struct mesh *mesh, const struct fixed2 corner[3]) {
    struct filled *t = &mesh->triangles[mesh->count++];
    for (int i = 0; i < 3; i++) {
        t->snapped[i] = corner[i];
        t->corner[i] =
            (struct vec2){(double)corner[i].x / SUBPIXELS, (double)corner[i].y / SUBPIXELS};
    }
}

/* The faces of the bust that are turned to us. */
static bool make_bust(struct mesh *mesh, const struct image *image, struct error *error) {
    struct model model;
    if (!model_read(&model, BENCH_MODEL("bust.obj"), error)) {
        return false;
    }
    mesh->triangles = bench_memory(model.face_count, sizeof *mesh->triangles);
    for (size_t face = 0; face < model.face_count; face++) {
        struct vec2 screen[3];
        struct fixed2 corner[3];
        face_on_screen(&model, face, image, screen);
        if (snap_corners(screen, corner) && !is_turned_away(screen)) {
            mesh_add(mesh, corner);
        }
    }
    model_free(&model);
    mesh_find_shown(mesh);
    return true;
}

/* The middle of the fan is a pixel centre, and so is every other corner on its rim, which lies
 * some whole number of times as far as a pixel centre near by: then many centres lie on the side
 * between. */
static void make_fan(struct mesh *mesh) {
    struct random random = {3};
    const int center = SIDE / 2 * SUBPIXELS + SUBPIXELS / 2;
    struct fixed2 rim[FAN_BLADES + 1];
    for (int i = 0; i < FAN_BLADES; i++) {
        struct pixel p = fan_rim(i);
        int32_t stray = i % 2 != 0 ? 0 : (int32_t)random_between(&random, 1, LARGE_REACH / 2);
        rim[i] =
            (struct fixed2){center + p.x * LARGE_REACH + stray, center + p.y * LARGE_REACH - stray};
    }
    rim[FAN_BLADES] = rim[0];
    mesh->triangles = bench_memory(FAN_BLADES, sizeof *mesh->triangles);
    for (int i = 0; i < FAN_BLADES; i++) {
        mesh_add(mesh, (const struct fixed2[3]){{center, center}, rim[i], rim[i + 1]});
    }
    mesh_find_shown(mesh);
}

/* ---- Spans without a division a row ---- */

/* The end of the span at one edge, floor(a / b) + 1 for an `a` that changes by the same from row to
 * row: whole quotient and remainder are carried along (the lesson's question 7). */
struct carried {
    int64_t quotient, remainder, step, step_remainder, divisor;
    bool is_begin; /* of the span; else its end */
};

static inline struct carried carried_from(const struct edge *e, int y) {
    int64_t missing = e->least - (e->origin + e->dy * y), divisor = llabs(e->dx);
    int64_t start = e->dx > 0 ? missing - 1 : -missing, change = e->dx > 0 ? -e->dy : e->dy;
    int64_t quotient = floor_divide(start, divisor), step = floor_divide(change, divisor);
    return (struct carried){
        quotient, start - quotient * divisor, step, change - step * divisor, divisor, e->dx > 0};
}

static inline void carried_next(struct carried *c) {
    c->quotient += c->step;
    c->remainder += c->step_remainder;
    bool full = c->remainder >= c->divisor;
    c->quotient += full;
    c->remainder -= full ? c->divisor : 0;
}

/* A horizontal edge leaves rows out as a whole: exactly those below or above it. */
static inline void narrow_rows(struct edges *edges, const struct edge *e) {
    for (; edges->y_begin < edges->y_end && e->origin + e->dy * edges->y_begin < e->least;
         edges->y_begin++) {
    }
    for (; edges->y_begin < edges->y_end && e->origin + e->dy * (edges->y_end - 1) < e->least;
         edges->y_end--) {
    }
}

static void fill_carried(struct image *image, const struct fixed2 corner[3], struct color color) {
    struct edges edges;
    struct carried ends[3];
    int count = 0;
    if (!triangle_setup(&edges, corner[0], corner[1], corner[2], image->width, image->height)) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        if (edges.edge[i].dx == 0) {
            narrow_rows(&edges, &edges.edge[i]);
        }
    }
    for (int i = 0; i < 3; i++) {
        if (edges.edge[i].dx != 0) {
            ends[count++] = carried_from(&edges.edge[i], edges.y_begin);
        }
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        int64_t begin = 0, end = edges.width;
        for (int i = 0; i < count; i++) {
            int64_t border = ends[i].quotient + 1;
            begin = ends[i].is_begin && border > begin ? border : begin;
            end = !ends[i].is_begin && border < end ? border : end;
            carried_next(&ends[i]);
        }
        if (begin < end) {
            image_fill_row(image, y, (int)begin, (int)end, color);
        }
    }
}

/* ---- The attempts ---- */

enum { HOUSE = 0, BORDERS = 8, BLOCKS, CARRIED }; /* 1 to 8 are those of attempts.h */

static void fill(const struct filled *t, int way, struct image *image, struct color color) {
    if (way == HOUSE) {
        triangle(image, t->snapped, color);
    } else if (way == CARRIED) {
        fill_carried(image, t->snapped, color);
    } else if (way == BLOCKS) {
        attempt_8_blocks(image, t->corner, color);
    } else {
        attempt_fill(way)(image, t->corner, color);
    }
}

/* ---- Running and judging ---- */

/* The number of a triangle in blue and green; red tells which version of which panel drew it. */
static struct color triangle_color(size_t i, int tag) {
    return (struct color){.b = (uint8_t)(i & 255), .g = (uint8_t)(i >> 8), .r = (uint8_t)tag};
}

static int tag_of(struct bench_choice choice) {
    return 1 + choice.way + 16 * choice.on;
}

static void run(struct bench_choice choice) {
    const struct mesh *mesh = &bench.meshes[choice.on];
    for (size_t i = 0; i < mesh->count; i++) {
        fill(&mesh->triangles[i], choice.way, &bench.image, triangle_color(i, tag_of(choice)));
    }
}

static double error_of(struct bench_choice choice) {
    const struct mesh *mesh = &bench.meshes[choice.on];
    size_t wrong = 0;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        const uint8_t *pixel = bench.image.pixels + 3 * i;
        uint32_t shown = pixel[2] == tag_of(choice) ? (uint32_t)(pixel[0] + 256 * pixel[1]) + 1 : 0;
        wrong += shown != mesh->shown[i];
    }
    return 1e3 * (double)wrong / (double)mesh->pixel_count;
}

/* ---- The lesson ---- */

static bool fill_setup(struct error *error) {
    make_fan(&bench.meshes[LARGE]);
    return image_create(&bench.image, SIDE, SIDE, IMAGE_BGR, error) &&
           make_bust(&bench.meshes[SMALL], &bench.image, error);
}

static const struct bench_version attempt_versions[] = {
    VERSION("1: sweep, whole numbers", 1),
    VERSION("2: sweep in float", 2),
    VERSION("3: box in float", 3),
    VERSION("4: box in double", 4),
    VERSION("5: box, open", 5),
    VERSION("6: box, epsilon", 6),
    VERSION("7: edges summed in float", 7),
    VERSION("8: blocks, exact", BLOCKS),
    VERSION("by three borders", BORDERS),
    VERSION("spans by remainders", CARRIED),
    HOUSE_VERSION("spans, exact (main.c)", HOUSE),
};

#define FILL_PANEL(mesh, share, heading)                                                           \
    {                                                                                              \
        .title = (heading), .error_label = "pixels that show the wrong triangle, per 1000",        \
        .time_label = "ns per pixel", .against = "128-bit integers", .house_within = BENCH_EXACT,  \
        .on = (mesh), .run = run, .error = error_of, .units = &bench.meshes[mesh].pixel_count,     \
        BENCH_VERSIONS(attempt_versions), .budget = (share),                                       \
    }

static const struct bench_panel fill_panels[] = {
    FILL_PANEL(SMALL, 1, "Small triangles: the faces of the bust, on 800x800 pixels"),
    FILL_PANEL(LARGE, 2, "Large triangles: a fan of 24 that reaches far beyond the image"),
};

const struct bench_lesson bench_step03 =
    BENCH_LESSON("step03_triangle", "Lesson 3: a triangle", fill_setup, fill_panels);
