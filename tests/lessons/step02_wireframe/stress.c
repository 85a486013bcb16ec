/* Step 2: its line() is lent to lines.c; here its way to the image. */
#define LESSON "../step02_wireframe/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <stdio.h>

uint64_t lesson02_line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    return line(image, a, b, color);
}

struct place_case {
    double x, y;
    int width, height;
};

static double any_place(struct random *random) {
    static const double special[] = {NAN, INFINITY, -INFINITY, 1, -1, 0, 1e300, -1e300};
    switch (random_bits(random) % 4) {
    case 0:
        return special[random_bits(random) % 8];
    case 1:
        return ldexp(random_real(random, -1, 1), (int)random_between(random, 0, 40));
    default:
        return random_real(random, -1.1, 1.1);
    }
}

static void make_place(struct random *random, uint64_t index, void *made) {
    struct place_case *c = made;
    (void)index;
    c->x = any_place(random);
    c->y = any_place(random);
    c->width = (int)random_between(random, 1, DRAW_LIMIT);
    c->height = (int)random_between(random, 1, DRAW_LIMIT);
}

static long double in_pixels(double place, int size) {
    return ((long double)place + 1) * size / 2;
}

/* Is it the pixel that holds the place? At the border of two pixels either is right. */
static bool pixel_holds(int pixel, double place, int size) {
    long double exact = in_pixels(place, size), slack = 1e-15L * (fabsl(exact) + size);
    return pixel <= exact + slack && exact < pixel + 1 + slack;
}

/* Neither is true of places at the limit, nor the first of what is no number. */
static bool is_inside(double place, int size) {
    return fabsl(in_pixels(place, size)) <= LINE_LIMIT - 1;
}

static bool is_outside(double place, int size) {
    return !(fabsl(in_pixels(place, size)) <= LINE_LIMIT + 1);
}

static bool place_is_right(const void *tried) {
    const struct place_case *c = tried;
    struct pixel p = {-7, -9};
    struct vec3 position = {c->x, c->y, NAN};
    if (!to_pixel(position, (size_t)c->width, (size_t)c->height, &p)) {
        return p.x == -7 && p.y == -9 && !(is_inside(c->x, c->width) && is_inside(c->y, c->height));
    }
    return !is_outside(c->x, c->width) && !is_outside(c->y, c->height) &&
           pixel_holds(p.x, c->x, c->width) && pixel_holds(p.y, c->y, c->height);
}

static void print_place(const void *failing) {
    const struct place_case *c = failing;
    printf("    v %.17g %.17g 0, %dx%d pixels\n", c->x, c->y, c->width, c->height);
}

static const struct case_kind place_cases = {sizeof(struct place_case), make_place, print_place};

const struct property lesson02_properties[] = {
    PROPERTY("lesson02: from model to image", AGAINST_LONG_DOUBLE, 500000, place_cases,
             .holds = place_is_right),
    {.name = NULL},
};
