/* Textures of all small sizes, sampled everywhere: inside, at the edges, far outside, nowhere. The
 * samplers are the three of lesson 6 and the house version of the second. */
#include "lessons.h"
#include "stress.h"

struct texture_case {
    struct picture picture;
    double u, v;
    double mip_level;
};

static double any_coordinate(struct random *random, int size) {
    switch (random_bits(random) % 8) {
    case 0: /* on texel borders and centres */
        return (double)random_between(random, -4, 2 * size + 4) / (2 * size);
    case 1:
        return random_real(random, -3, 4);
    case 2:
        return ldexp(random_real(random, -1, 1), (int)random_between(random, 0, 1000));
    case 3: {
        static const double special[] = {NAN, INFINITY, -INFINITY, 0, 1, -0.0, 1e-320, 1 - 1e-16};
        return special[random_bits(random) % 8];
    }
    default:
        return random_real(random, 0, 1);
    }
}

static double any_mip_level(struct random *random) {
    static const double special[] = {0, 1, 3, 99, -5, NAN, INFINITY, -INFINITY};
    uint64_t choice = random_bits(random) % 16;
    return choice < 8 ? special[choice] : random_real(random, -0.5, 4);
}

static void make_texture(struct random *random, uint64_t index, void *made) {
    struct texture_case *c = made;
    make_picture(random, &c->picture);
    if (index % 16 == 0) {
        c->picture.width = c->picture.height = 1;
    }
    c->u = any_coordinate(random, (int)c->picture.width);
    c->v = any_coordinate(random, (int)c->picture.height);
    c->mip_level = any_mip_level(random);
}

/* The least for no number. */
static long double bounded(long double x, long double least, long double most) {
    return !(x >= least) ? least : x > most ? most : x;
}

/* The texel that holds a place in texels, found by trying them all. */
static int texel_at(long double place, int size) {
    int found = 0;
    for (int i = 1; i < size; i++) {
        if (place >= i) {
            found = i;
        }
    }
    return found;
}

/* The coordinate in the picture that repeats. */
static long double in_picture(long double coordinate, bool clamp) {
    return clamp ? coordinate : bounded(coordinate - floorl(coordinate), 0, 1);
}

/* How far a product of a coordinate and a size may be off: nothing where it is exact, as for sizes
 * that are powers of two. Elsewhere the texel on either side of a border is right. */
static long double product_error(double coordinate, int size, bool clamp) {
    double part = clamp ? coordinate : coordinate - floor(coordinate);
    long double place = in_picture(coordinate, clamp) * size;
    return (long double)(part * size) == place ? 0 : 1e-12L;
}

static bool nearest_is_exact(const void *tried) {
    const struct texture_case *c = tried;
    struct texture texture;
    if (!texture_of_picture(&c->picture, &texture)) {
        return false;
    }
    struct color got = lesson06_nearest(&texture, (struct vec2){c->u, c->v});
    texture_free(&texture);
    int width = (int)c->picture.width, height = (int)c->picture.height;
    bool clamp = c->picture.clamp;
    for (int i = 0; i < 4; i++) {
        long double x_error = product_error(c->u, width, clamp) * (i % 2 == 0 ? -1 : 1);
        long double y_error = product_error(c->v, height, clamp) * (i / 2 == 0 ? -1 : 1);
        int x = texel_at(in_picture(c->u, clamp) * width + x_error, width);
        int y = texel_at(in_picture(c->v, clamp) * height + y_error, height);
        const uint8_t *texel = c->picture.channel[y * width + x];
        if (got.b == texel[0] && got.g == texel[1] && got.r == texel[2] && got.a == texel[3]) {
            return true;
        }
    }
    return false;
}

/* The weight of texel i: a tent of width 2 around its centre, and around its copy one picture
 * further on; or, where it clamps, everything outside given to the edge. */
static long double tent(double coordinate, size_t i, size_t size, bool clamp) {
    long double most = (long double)size - 1;
    long double place = in_picture(coordinate, clamp) * (long double)size - 0.5L;
    if (clamp) {
        return fmaxl(0, 1 - fabsl(bounded(place, 0, most) - (long double)i));
    }
    long double distance = fabsl(place - (long double)i);
    return fmaxl(0, 1 - distance) + fmaxl(0, 1 - fabsl((long double)size - distance));
}

struct sample exact_bilinear(const struct texture *texture, size_t number, double u, double v) {
    static const int shift[4] = {16, 8, 0, 24};
    const struct texture_level *level = &texture->level[number];
    struct sample sum = {{0, 0, 0, 0}};
    for (size_t y = 0; y < level->height; y++) {
        for (size_t x = 0; x < level->width; x++) {
            long double weight = tent(u, x, level->width, texture->clamp) *
                                 tent(v, y, level->height, texture->clamp);
            uint32_t texel = texture_texel(level, x, y);
            for (int i = 0; i < 4; i++) {
                sum.channel[i] += weight * (texel >> shift[i] & 0xFF);
            }
        }
    }
    return sum;
}

/* The exact trilinear sample: of the levels below and above, each counted by how near it is. */
static struct sample exact_trilinear(const struct texture *texture, double u, double v,
                                     double mip_level) {
    struct sample sum = {{0, 0, 0, 0}};
    long double place = bounded(mip_level, 0, (long double)texture->level_count - 1);
    for (size_t k = 0; k < texture->level_count; k++) {
        long double distance = fabsl(place - (long double)k);
        struct sample sample = exact_bilinear(texture, k, u, v);
        for (int i = 0; i < 4 && distance < 1; i++) {
            sum.channel[i] += (1 - distance) * sample.channel[i];
        }
    }
    return sum;
}

/* The largest difference of a channel, in levels. */
static double sample_error(struct vec4 got, struct sample exact) {
    const double channel[4] = {got.x, got.y, got.z, got.w};
    double worst = 0;
    for (int i = 0; i < 4; i++) {
        double error = (double)fabsl((long double)channel[i] - exact.channel[i]);
        worst = isnan(error) ? (double)INFINITY : fmax(worst, error);
    }
    return worst;
}

/* Of the lesson's version and of the house version. */
static double bilinear_error(const void *tried) {
    const struct texture_case *c = tried;
    struct texture texture;
    if (!texture_of_picture(&c->picture, &texture)) {
        return INFINITY;
    }
    struct vec2 uv = {c->u, c->v};
    struct sample exact = exact_bilinear(&texture, 0, c->u, c->v);
    double lesson_error = sample_error(lesson06_bilinear(&texture, uv, 0), exact);
    double house_error = sample_error(texture_bilinear(&texture, uv, 0), exact);
    texture_free(&texture);
    return fmax(lesson_error, house_error);
}

static double trilinear_error(const void *tried) {
    const struct texture_case *c = tried;
    struct texture texture;
    if (!texture_of_picture(&c->picture, &texture)) {
        return INFINITY;
    }
    struct vec4 got = lesson06_trilinear(&texture, (struct vec2){c->u, c->v}, c->mip_level);
    double error = sample_error(got, exact_trilinear(&texture, c->u, c->v, c->mip_level));
    texture_free(&texture);
    return error;
}

const struct property texture_properties[] = {
    PROPERTY("texture: nearest texel", AGAINST_LONG_DOUBLE, 300000, struct texture_case,
             make_texture, .holds = nearest_is_exact),
    PROPERTY("texture: bilinear", AGAINST_LONG_DOUBLE, 300000, struct texture_case, make_texture,
             .error = bilinear_error, .limit = 1e-10, .error_unit = "level of 255"),
    PROPERTY("texture: mip-mapped", AGAINST_LONG_DOUBLE, 300000, struct texture_case, make_texture,
             .error = trilinear_error, .limit = 1e-10, .error_unit = "level of 255"),
    {.name = NULL},
};
