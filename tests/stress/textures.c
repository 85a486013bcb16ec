/* Textures of all small sizes, sampled everywhere: inside, at the edges, far outside, nowhere. */
#include "stress.h"
#include "texture.h"

#include <stdio.h>

enum { SIDE_LIMIT = 9 };

struct texture_case {
    int width, height;
    uint8_t level[SIDE_LIMIT * SIDE_LIMIT]; /* grey */
    double u, v;
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

static void make_texture(struct random *random, uint64_t index, void *made) {
    struct texture_case *c = made;
    c->width = index % 16 == 0 ? 1 : (int)random_between(random, 1, SIDE_LIMIT);
    c->height = index % 16 == 0 ? 1 : (int)random_between(random, 1, SIDE_LIMIT);
    for (int i = 0; i < SIDE_LIMIT * SIDE_LIMIT; i++) {
        c->level[i] = (uint8_t)random_bits(random);
    }
    c->u = any_coordinate(random, c->width);
    c->v = any_coordinate(random, c->height);
}

static bool make(const struct texture_case *c, struct texture *texture) {
    struct error error;
    uint8_t pixels[SIDE_LIMIT * SIDE_LIMIT];
    for (int i = 0; i < c->width * c->height; i++) {
        pixels[i] = c->level[i];
    }
    struct image image = {(size_t)c->width, (size_t)c->height, IMAGE_GREY, pixels};
    return texture_create(texture, &image, &error);
}

/* A coordinate as texture.h says: 0 for no number, the edge repeated outside. */
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

/* Where the product u * width rounds to a border, the texel on either side of it is right. */
static bool nearest_is_exact(const void *tried) {
    static const long double nudge[] = {-1e-12L, 1e-12L};
    const struct texture_case *c = tried;
    struct texture texture;
    if (!make(c, &texture)) {
        return false;
    }
    uint8_t got = texture_nearest(&texture, (struct vec2){c->u, c->v}).g;
    texture_free(&texture);
    for (int i = 0; i < 4; i++) {
        int x = texel_at((long double)c->u * c->width + nudge[i % 2], c->width);
        int y = texel_at((long double)c->v * c->height + nudge[i / 2], c->height);
        if (got == c->level[y * c->width + x]) {
            return true;
        }
    }
    return false;
}

/* The weight of texel i: a tent of width 2 around its centre, everything outside given to the
 * edge. */
static long double tent(double coordinate, int i, int size) {
    long double place = bounded((long double)coordinate * size - 0.5L, 0, size - 1);
    long double distance = fabsl(place - i);
    return distance < 1 ? 1 - distance : 0;
}

static double bilinear_error(const void *tried) {
    const struct texture_case *c = tried;
    struct texture texture;
    if (!make(c, &texture)) {
        return INFINITY;
    }
    long double sum = 0;
    for (int y = 0; y < c->height; y++) {
        for (int x = 0; x < c->width; x++) {
            sum += c->level[y * c->width + x] * tent(c->u, x, c->width) * tent(c->v, y, c->height);
        }
    }
    struct vec4 got = texture_bilinear(&texture, (struct vec2){c->u, c->v}, 0);
    texture_free(&texture);
    double error = (double)fabsl((long double)got.y - sum);
    return isnan(error) ? INFINITY : error;
}

static bool bilinear_is_right(const void *tried) {
    return bilinear_error(tried) <= 1e-10;
}

/* Whatever the level, a sample is a mean of levels: never outside the darkest and the brightest. */
static bool trilinear_is_bounded(const void *tried) {
    const struct texture_case *c = tried;
    struct texture texture;
    if (!make(c, &texture)) {
        return false;
    }
    int least = 255, most = 0;
    for (int i = 0; i < c->width * c->height; i++) {
        least = c->level[i] < least ? c->level[i] : least;
        most = c->level[i] > most ? c->level[i] : most;
    }
    static const double levels[] = {0, 0.3, 1, 1.9, 3, 99, -5, NAN, INFINITY, -INFINITY};
    bool right = true;
    for (size_t i = 0; i < sizeof levels / sizeof levels[0]; i++) {
        double got = texture_trilinear(&texture, (struct vec2){c->u, c->v}, levels[i]).y;
        right = right && got >= least - 1e-9 && got <= most + 1e-9;
    }
    texture_free(&texture);
    return right;
}

static void print_texture(const void *failing) {
    const struct texture_case *c = failing;
    printf("    at u %.17g v %.17g of %dx%d grey levels, bottom row first:\n", c->u, c->v, c->width,
           c->height);
    for (int y = 0; y < c->height; y++) {
        printf("   ");
        for (int x = 0; x < c->width; x++) {
            printf(" %d", c->level[y * c->width + x]);
        }
        printf("\n");
    }
}

const struct property texture_properties[] = {
    {.name = "texture: nearest texel",
     .cases = 300000,
     .case_size = sizeof(struct texture_case),
     .make = make_texture,
     .holds = nearest_is_exact,
     .print = print_texture},
    {.name = "texture: bilinear",
     .cases = 300000,
     .case_size = sizeof(struct texture_case),
     .make = make_texture,
     .holds = bilinear_is_right,
     .print = print_texture,
     .error_unit = "level of 255",
     .error = bilinear_error},
    {.name = "texture: mip-mapped within bounds",
     .cases = 300000,
     .case_size = sizeof(struct texture_case),
     .make = make_texture,
     .holds = trilinear_is_bounded,
     .print = print_texture},
    {.name = NULL},
};
