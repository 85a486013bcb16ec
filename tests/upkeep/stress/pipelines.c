/* The pipeline, by pipeline_draw() alone: what shows at each pixel, its depth, its attributes. */
#include "oracle/shown.h"
#include "pipeline.h"
#include "soup.h"
#include "stress.h"

#include <math.h>
#include <string.h>

/* Soups of one kind and of another, in turn. */
#define MAKE_SOUPS(name, kind, other)                                                              \
    static void name(struct random *random, uint64_t index, void *made) {                          \
        const enum soup_kind kinds[2] = {kind, other};                                             \
        *(struct soup_case *)made = (struct soup_case){random_bits(random), kinds[index % 2]};     \
    }

MAKE_SOUPS(make_whole, SOUP_WHOLE, SOUP_WHOLE)
MAKE_SOUPS(make_seen_by_camera, SOUP_CAMERA, SOUP_CAMERA)
MAKE_SOUPS(make_steep, SOUP_STEEP, SOUP_CAMERA)
MAKE_SOUPS(make_uncut, SOUP_WHOLE, SOUP_STEEP)
MAKE_SOUPS(make_largest, SOUP_WIDE, SOUP_HIGH)

/* ---- Drawing a soup ---- */

/* What a drawing shows in the four bytes of a pixel: the number of the face, or that part of the
 * bits of its interpolated value. */
enum { SHOW_FACE = -1 };

struct soup_uniforms {
    const struct soup *soup;
    size_t first_face; /* of the draw call */
    int shown;         /* SHOW_FACE, or a part from 0 */
};

static void soup_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct soup_uniforms *u = uniforms;
    uint32_t position = u->soup->faces[u->first_face + face].corner[corner].position;
    varyings[0] = (double)(position / 3 + 1);
    varyings[1] = u->soup->value[position];
}

/* Transparent on purpose: the pipeline must not make it opaque. */
enum { ALPHA = 7 };

static lanes_mask soup_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    const struct soup_uniforms *u = uniforms;
    if (u->shown == SHOW_FACE) {
        *color = lanes_rgb(varyings[0], varyings[0], varyings[0]);
        *color = (*color & 0xFFFFFF) | (uint32_t)ALPHA << 24;
    } else {
        *color = show_part(varyings[1], (size_t)u->shown);
    }
    return lanes_all_set();
}

SHADER(soup_shader, .varying_count = 2, .vertex = soup_vertex, .fragment = soup_fragment);
SHADER(discarding_shader, .varying_count = 2, .vertex = soup_vertex, .fragment = soup_fragment,
       .discards = true);

/* The ways to draw, which all must give the same image. */
enum way { SHADE_VISIBLE, SHADE_ALL, SHADE_DISCARDING, WAYS };

enum { UNTOUCHED = 0xA5 }; /* all bytes of the image before it is drawn on */

/* A soup's faces in two draw calls, the first of which has `split` faces. */
static bool draw_calls(struct pipeline *pipeline, const struct soup *soup, size_t split,
                       enum way way, int shown, struct image *image) {
    struct error error;
    struct model models[2] = {soup->model, soup->model};
    models[0].face_count = split;
    models[1].faces += split;
    models[1].face_count -= split;
    memset(image->pixels, UNTOUCHED, image->width * image->height * image->format);
    pipeline_clear(pipeline);
    pipeline->skip = way != SHADE_ALL;
    for (size_t i = 0; i < 2; i++) {
        struct soup_uniforms uniforms = {soup, i * split, shown};
        struct draw_call call = {
            .model = &models[i], .to_clip = soup->to_clip, .viewport = soup->viewport};
        const struct shader *shader = way == SHADE_DISCARDING ? &discarding_shader : &soup_shader;
        if (!pipeline_draw(pipeline, &call, shader, &uniforms, sizeof uniforms, &error)) {
            return false;
        }
    }
    return pipeline_finish(pipeline, image, &error);
}

struct drawing {
    struct pipeline pipeline;
    struct image faces, bits[REAL_PARTS];
};

static void drawing_free(struct drawing *drawing) {
    pipeline_free(&drawing->pipeline);
    image_free(&drawing->faces);
    for (size_t i = 0; i < REAL_PARTS; i++) {
        image_free(&drawing->bits[i]);
    }
}

/* Now and then with several threads. */
static bool drawing_create(struct drawing *drawing, size_t width, size_t height, uint64_t seed) {
    struct error error;
    *drawing = (struct drawing){0};
    bool done = pipeline_create(&drawing->pipeline, width, height, &error) &&
                image_create(&drawing->faces, width, height, IMAGE_BGRA, &error);
    for (size_t i = 0; i < REAL_PARTS; i++) {
        done = done && image_create(&drawing->bits[i], width, height, IMAGE_BGRA, &error);
    }
    drawing->pipeline.keep_depth = true;
    pipeline_use_threads(&drawing->pipeline, seed / 32 % 64 == 0 ? 2 + seed / 2048 % 7 : 1);
    return done;
}

/* The faces in one of the ways, chosen by the seed; false where another way gives other bytes. */
static bool draw_faces(struct drawing *drawing, const struct soup *soup, uint64_t seed) {
    size_t split = seed % (soup->model.face_count + 1);
    size_t size = soup->width * soup->height * IMAGE_BGRA;
    bool same = true;
    for (unsigned i = 0; i < WAYS && same; i++) {
        enum way way = (enum way)((seed / 8 + i) % WAYS);
        struct image *image = i == 0 ? &drawing->bits[0] : &drawing->faces;
        same = draw_calls(&drawing->pipeline, soup, split, way, SHOW_FACE, image) &&
               (i == 0 || memcmp(image->pixels, drawing->bits[0].pixels, size) == 0);
    }
    return same;
}

static bool draw_values(struct drawing *drawing, const struct soup *soup, uint64_t seed) {
    enum way way = (enum way)(seed / 8 % WAYS);
    size_t split = seed % (soup->model.face_count + 1);
    bool done = true;
    for (int i = 0; i < REAL_PARTS; i++) {
        done = done && draw_calls(&drawing->pipeline, soup, split, way, i, &drawing->bits[i]);
    }
    return done;
}

/* ---- Judging what was drawn ---- */

/* The face that shows at a pixel, from 0; -1 where nothing was drawn, -2 for what cannot be. */
static int face_at(const struct soup *soup, const struct drawing *drawing, size_t pixel) {
    const uint8_t *p = drawing->faces.pixels + 4 * pixel;
    if (texel_at(&drawing->faces, pixel) == UNTOUCHED * 0x01010101u) {
        return drawing->pipeline.depth[pixel] == (double)-INFINITY ? -1 : -2;
    }
    bool possible = p[0] == p[1] && p[1] == p[2] && p[3] == ALPHA && p[0] >= 1 &&
                    p[0] <= soup->model.face_count;
    return possible ? p[0] - 1 : -2;
}

/* In the largest images not all pixels are judged: some, and those that are the first or last of
 * their face along the longer side. */
static bool is_chosen(const struct soup *soup, const struct image *faces, int x, int y) {
    bool wide = soup->kind == SOUP_WIDE;
    int place = wide ? x : y, size = wide ? (int)soup->width : (int)soup->height;
    size_t pixel = (size_t)y * soup->width + (size_t)x, step = wide ? 1 : soup->width;
    return soup->kind < SOUP_WIDE || (x + y) % 41 == 0 || place == 0 || place == size - 1 ||
           texel_at(faces, pixel - step) != texel_at(faces, pixel) ||
           texel_at(faces, pixel + step) != texel_at(faces, pixel);
}

/* Of the values, or of the faces and their depths. */
static bool judge_pixel(const struct soup *soup, const struct drawing *drawing, int x, int y,
                        bool values, struct tally *tally) {
    size_t pixel = (size_t)y * soup->width + (size_t)x;
    int face = face_at(soup, drawing, pixel);
    double depth = drawing->pipeline.depth[pixel];
    if (values && face >= 0) {
        double value = shown_real(drawing->bits, pixel);
        return soup_value_is_right(soup, x, y, face, value, tally);
    }
    return face >= -1 && (values || soup_face_is_right(soup, x, y, face, depth, tally));
}

static bool judge_soup(const struct soup_case *c, bool values, struct tally *tally) {
    struct soup soup;
    struct drawing drawing;
    soup_make(&soup, c->seed, (enum soup_kind)c->kind);
    bool right = drawing_create(&drawing, soup.width, soup.height, c->seed) &&
                 draw_faces(&drawing, &soup, c->seed) &&
                 (!values || draw_values(&drawing, &soup, c->seed));
    for (int y = 0; right && y < (int)soup.height; y++) {
        for (int x = 0; right && x < (int)soup.width; x++) {
            right = !is_chosen(&soup, &drawing.faces, x, y) ||
                    judge_pixel(&soup, &drawing, x, y, values, tally);
        }
    }
    drawing_free(&drawing);
    return right;
}

static bool judge_faces(const void *tried, struct tally *tally) {
    return judge_soup(tried, false, tally);
}

static bool judge_values(const void *tried, struct tally *tally) {
    return judge_soup(tried, true, tally);
}

/* Faces in another order, each beginning with another corner. */
static void shuffle(struct soup *soup, struct random *random) {
    for (size_t i = SOUP_FACES; i-- > 0;) {
        struct face *other = &soup->faces[random_bits(random) % (i + 1)], kept = *other;
        size_t turn = random_bits(random) % 3;
        *other = soup->faces[i];
        for (size_t k = 0; k < 3; k++) {
            soup->faces[i].corner[k] = kept.corner[(k + turn) % 3];
        }
    }
}

/* Every bit of the values stays, of whole faces and where no two are equally near. */
static bool same_in_every_order(const void *tried) {
    const struct soup_case *c = tried;
    struct random random = {c->seed};
    struct soup soup;
    struct drawing drawing, other = {0};
    soup_make(&soup, c->seed, (enum soup_kind)c->kind);
    bool same = drawing_create(&drawing, soup.width, soup.height, c->seed) &&
                draw_values(&drawing, &soup, c->seed);
    shuffle(&soup, &random);
    same = same && drawing_create(&other, soup.width, soup.height, random_bits(&random)) &&
           draw_values(&other, &soup, random_bits(&random));
    for (size_t i = 0; same && i < soup.width * soup.height; i++) {
        if (shown_real(drawing.bits, i) != shown_real(other.bits, i)) {
            struct soup_seen seen = soup_see(&soup, (int)(i % soup.width), (int)(i / soup.width));
            same = soup_candidates(&soup, &seen) > 1;
        }
    }
    drawing_free(&drawing);
    drawing_free(&other);
    return same;
}

const struct property pipeline_properties[] = {
    PROPERTY("pipeline: the nearest by z/w", AGAINST_FRACTIONS, 15000, struct soup_case, make_whole,
             .error_unit = "ulp of depth", .judge = judge_faces),
    PROPERTY("pipeline: cut near and far", AGAINST_LONG_DOUBLE, 15000, struct soup_case,
             make_seen_by_camera, .error_unit = "ulp of depth", .judge = judge_faces),
    PROPERTY("pipeline: attributes in perspective", AGAINST_LONG_DOUBLE, 15000, struct soup_case,
             make_steep, .error_unit = "1/256 texel of 1024", .judge = judge_values),
    PROPERTY("pipeline: same values in every order", AGAINST_ITSELF, 20000, struct soup_case,
             make_uncut, .holds = same_in_every_order),
    PROPERTY("pipeline: 16384 pixels wide or high", AGAINST_LONG_DOUBLE, 300, struct soup_case,
             make_largest, .error_unit = "ulp of depth", .judge = judge_faces),
    {.name = NULL},
};
