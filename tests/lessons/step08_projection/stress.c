/* Lesson 8: what is beyond the sides of the view, and whole pictures. Its lookat() has the text of
 * the house version, which cameras.c tries. */
#define LESSON "../step08_projection/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/soup.h"
#include "upkeep/stress/stress.h"

#include <string.h>

/* ---- Which sides a position is beyond ---- */

/* Often exactly on a side or as near to it as doubles go. */
static void make_side(struct random *random, uint64_t index, void *made) {
    static const double ws[] = {0, 1.0 / 128, 1.0 / 256, 1, -1, NAN, INFINITY, 1e-300};
    static const double parts[] = {0, 1, -1, 64, -64, 0.99, -0.99, 63, NAN, INFINITY};
    struct vec4 *p = made;
    p->w = index % 2 ? ws[random_bits(random) % 8] : random_real(random, -0.01, 3);
    p->x = p->w * (random_bits(random) % 2 ? parts[random_bits(random) % 10]
                                           : random_real(random, -70, 70));
    p->y = p->w * (random_bits(random) % 2 ? parts[random_bits(random) % 10]
                                           : random_real(random, -70, 70));
    double *moved = random_bits(random) % 2 ? &p->x : &p->w;
    if (index % 3 == 0 && isfinite(*moved)) {
        *moved = nextafter(*moved, random_bits(random) % 2 ? 1e9 : -1e9);
    }
}

static bool sides_are_right(const void *tried) {
    const struct vec4 *p = tried;
    long double x = p->x, y = p->y, w = p->w;
    unsigned exact = 0;
    exact |= -w <= x ? 0 : BEYOND_LEFT;
    exact |= w >= x ? 0 : BEYOND_RIGHT;
    exact |= -w <= y ? 0 : BEYOND_BOTTOM;
    exact |= w >= y ? 0 : BEYOND_TOP;
    exact |= 128 * w >= 1 ? 0 : BEYOND_NEAR;
    exact |= -64 * w <= x && x <= 64 * w && -64 * w <= y && y <= 64 * w ? 0 : BEYOND_GUARD_BAND;
    return find_beyond(*p) == exact;
}

/* ---- Soups: random faces in perspective, drawn by the lesson ---- */

/* Images are small, so that the soup's guard band is the lesson's: NDC -64..64. */
static void make_soup(struct random *random, uint64_t index, void *made) {
    *(struct soup_case *)made = (struct soup_case){random_bits(random), index % (SOUP_CAMERA + 1)};
}

/* What a soup shows at the corners: the same light and texture for a whole face, or the value as
 * intensity or as a texture coordinate. */
enum look { LOOK_FACE, LOOK_INTENSITY, LOOK_U, LOOK_V };

enum { SOUP_PIXELS = 26 * 26 };

/* A soup with everything the lesson draws from, and what it draws on. */
struct scenery {
    struct soup soup;
    float uv[SOUP_CORNERS][2], normal[SOUP_CORNERS][3];
    struct face faces[SOUP_FACES];
    struct model model;
    uint32_t texels[2 * SOUP_FACES + 2];
    struct texture texture;
    uint8_t pixels[3 * SOUP_PIXELS];
    double depth[SOUP_PIXELS];
    struct image image;
};

/* Are the corners counterclockwise on the screen? */
static bool shows_front(const struct soup_polygon *polygon) {
    int turn = 0;
    for (size_t i = 2; i < polygon->count && turn == 0; i++) {
        turn = oracle_turn(polygon->corner[0].screen, polygon->corner[i - 1].screen,
                           polygon->corner[i].screen);
    }
    return turn > 0;
}

/* Of faces that show their back nothing is to be seen. */
static void scenery_make(struct scenery *s, const struct soup_case *c) {
    *s = (struct scenery){.image = {0}};
    soup_make(&s->soup, c->seed, (enum soup_kind)c->kind);
    for (size_t i = 0; i < SOUP_FACES; i++) {
        if (!shows_front(&s->soup.polygons[i])) {
            s->soup.polygons[i].count = 0;
        }
    }
    s->model = s->soup.model;
    s->model.faces = s->faces;
    s->model.uvs = s->uv;
    s->model.normals = s->normal;
    s->model.uv_count = s->model.normal_count = SOUP_CORNERS;
    for (uint32_t i = 0; i < SOUP_CORNERS; i++) {
        s->faces[i / 3].corner[i % 3] = (struct corner){i, i, i};
    }
    s->image = (struct image){s->soup.width, s->soup.height, IMAGE_BGR, s->pixels};
    depth_clear(s->depth, SOUP_PIXELS);
}

/* A texture with a column a face, in levels first, first + 1...: each face has its own. */
static void look_like_faces(struct scenery *s, uint32_t first) {
    s->texture = texture_from(s->texels, SOUP_FACES, 1);
    for (uint32_t i = 0; i < SOUP_FACES; i++) {
        s->texels[i] = (first + i) * 0x010101;
    }
    for (int i = 0; i < SOUP_CORNERS; i++) {
        s->uv[i][0] = (float)((i / 3 + 0.5) / SOUP_FACES);
        s->uv[i][1] = 0.5F;
        s->normal[i][2] = 1;
    }
}

/* A texture that becomes brighter to the right or upwards, and the value of each corner as its
 * intensity or as a coordinate. */
static void look_like_values(struct scenery *s, enum look look) {
    s->texture = texture_from(s->texels, look == LOOK_U ? 2 : 1, look == LOOK_V ? 2 : 1);
    s->texels[0] = look == LOOK_INTENSITY ? 0xFFFFFF : 0;
    s->texels[1] = 0xFFFFFF;
    for (int i = 0; i < SOUP_CORNERS; i++) {
        double value = s->soup.value[i], shade = look == LOOK_INTENSITY ? value : 1;
        s->uv[i][0] = look == LOOK_U ? (float)value : 0.5F;
        s->uv[i][1] = look == LOOK_V ? (float)value : 0.5F;
        s->normal[i][1] = (float)(3 * sqrt(1 - shade * shade));
        s->normal[i][2] = (float)(3 * shade);
    }
}

/* All faces, or without `skip` also those that are beyond a side, cut at every plane. */
static void draw_scenery(struct scenery *s, bool skip) {
    const struct drawing drawing = {.diffuse = &s->texture, .depth = s->depth, .light = {0, 0, 7}};
    const struct canvas canvas =
        make_canvas(&drawing, &s->image, s->soup.viewport, s->soup.to_clip);
    for (size_t face = 0; face < s->model.face_count; face++) {
        struct face_corner corner[3];
        fetch_face(&s->model, face, corner);
        struct polygon polygon = transform_face(&canvas, corner);
        if (skip) {
            clip_face(&polygon);
        }
        for (int plane = 0; !skip && plane < CLIP_PLANES; plane++) {
            polygon = clip_at_plane(&polygon, plane);
        }
        draw_polygon(&canvas, corner, &polygon);
    }
}

static bool face_is_right(const struct scenery *s, int x, int y, struct tally *tally) {
    size_t pixel = (size_t)y * s->soup.width + (size_t)x;
    int face = s->pixels[3 * pixel] - 1;
    return face < SOUP_FACES && soup_face_is_right(&s->soup, x, y, face, s->depth[pixel], tally);
}

/* The same faces once more, in other levels and with nothing skipped, must change nothing. */
static bool second_drawing_is_hidden(struct scenery *s) {
    uint8_t before[sizeof s->pixels];
    memcpy(before, s->pixels, sizeof before);
    look_like_faces(s, 100);
    draw_scenery(s, false);
    return memcmp(before, s->pixels, sizeof before) == 0;
}

static bool judge_nearest(const void *tried, struct tally *tally) {
    struct scenery s;
    bool right = true;
    scenery_make(&s, tried);
    look_like_faces(&s, 1);
    draw_scenery(&s, true);
    for (int y = 0; right && y < (int)s.soup.height; y++) {
        for (int x = 0; right && x < (int)s.soup.width; x++) {
            right = face_is_right(&s, x, y, tally);
        }
    }
    return right && second_drawing_is_hidden(&s);
}

/* The level that a value becomes. Between its two texels' centres a texture is linear. */
static long double level_of_value(long double value, enum look look) {
    long double share = look == LOOK_INTENSITY ? value : 2 * value - 0.5L;
    return 255 * fmaxl(0, fminl(1, share));
}

static bool value_is_right(const struct scenery *s, enum look look, int x, int y) {
    struct soup_seen seen = soup_see(&s->soup, x, y);
    long double level = image_get(&s->image, x, y).g;
    bool right = false, any = false;
    for (size_t i = 0; i < SOUP_FACES; i++) {
        if (soup_may_show(&s->soup, &seen, i)) {
            struct range value = seen.hit[i].value;
            any = true; /* floats of the model move a level by less than 0.001 */
            right = right || (level >= level_of_value(value.least, look) - 0.501L &&
                              level <= level_of_value(value.most, look) + 0.501L);
        }
    }
    return right || !any;
}

static bool values_are_right(const void *tried) {
    const struct soup_case *c = tried;
    enum look look = (enum look)(LOOK_INTENSITY + c->seed % 3);
    struct scenery s;
    bool right = true;
    scenery_make(&s, c);
    look_like_values(&s, look);
    draw_scenery(&s, true);
    for (int y = 0; right && y < (int)s.soup.height; y++) {
        for (int x = 0; right && x < (int)s.soup.width; x++) {
            right = value_is_right(&s, look, x, y);
        }
    }
    return right;
}

const struct property lesson08_properties[] = {
    PROPERTY("lesson08: beyond which sides", AGAINST_LONG_DOUBLE, 300000, struct vec4, make_side,
             .holds = sides_are_right),
    PROPERTY("lesson08: the nearest by z/w", AGAINST_LONG_DOUBLE, 10000, struct soup_case,
             make_soup, .judge = judge_nearest),
    PROPERTY("lesson08: values in perspective", AGAINST_LONG_DOUBLE, 10000, struct soup_case,
             make_soup, .holds = values_are_right),
    {.name = NULL},
};
