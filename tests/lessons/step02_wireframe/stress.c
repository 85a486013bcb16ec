/* Step 2: its line() is lent to lines.c; here its sides and its way to the image. */
#define LESSON "../step02_wireframe/main.c"
#include "lesson.h"

#include "upkeep/stress/lessons.h"
#include "upkeep/stress/stress.h"

#include <stdio.h>

uint64_t lesson02_line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    return line(image, a, b, color);
}

/* ---- Sides ---- */

enum { NUMBERS = 7, FACES = 20, SIDES = 3 * FACES };

/* Faces that name few positions, so that most sides are shared. */
struct sides_case {
    uint32_t number[NUMBERS]; /* of a position; all different */
    uint8_t corner[FACES][3]; /* which of them */
    int face_count;
};

static void make_sides(struct random *random, uint64_t index, void *made) {
    struct sides_case *c = made;
    c->face_count = (int)random_between(random, 0, FACES);
    for (uint32_t i = 0; i < NUMBERS; i++) { /* as far apart as numbers can be */
        uint32_t any = (uint32_t)random_bits(random) / NUMBERS * NUMBERS;
        c->number[i] = index % 2 ? i : any - (any > UINT32_MAX - NUMBERS ? NUMBERS : 0) + i;
    }
    for (int i = 0; i < SIDES; i++) {
        c->corner[i / 3][i % 3] = (uint8_t)random_between(random, 0, NUMBERS - 1);
    }
}

/* How often each pair of positions is a side. */
struct side_counts {
    int count[NUMBERS][NUMBERS]; /* symmetric */
    bool stranger;               /* a side that is none, or whose larger number comes first */
};

static int place_of(const struct sides_case *c, uint32_t number) {
    int place = 0;
    while (place < NUMBERS && c->number[place] != number) {
        place++;
    }
    return place;
}

static struct side_counts count_sides(const struct sides_case *c, const struct side *sides,
                                      size_t n) {
    struct side_counts counts = {.stranger = false};
    for (size_t i = 0; i < n; i++) {
        int p = place_of(c, sides[i].low), q = place_of(c, sides[i].high);
        if (p == NUMBERS || q == NUMBERS || sides[i].low > sides[i].high) {
            counts.stranger = true;
            return counts;
        }
        counts.count[p][q]++;
        counts.count[q][p] += p != q;
    }
    return counts;
}

static struct side_counts exact_sides(const struct sides_case *c) {
    struct side_counts counts = {.stranger = false};
    for (int i = 0; i < 3 * c->face_count; i++) {
        int p = c->corner[i / 3][i % 3], q = c->corner[i / 3][(i + 1) % 3];
        counts.count[p][q]++;
        counts.count[q][p] += p != q;
    }
    return counts;
}

/* First all of them, then one of each. */
static bool sides_are_right(const void *tried) {
    const struct sides_case *c = tried;
    struct face faces[FACES];
    struct side sides[SIDES + 1] = {{0, 0}};
    for (int i = 0; i < SIDES; i++) {
        faces[i / 3].corner[i % 3].position = c->number[c->corner[i / 3][i % 3]];
    }
    struct model model = {.faces = faces, .face_count = (size_t)c->face_count};
    list_sides(&model, sides);
    struct side_counts all = count_sides(c, sides, 3 * model.face_count), exact = exact_sides(c);
    size_t kept = keep_one_of_each(sides, 3 * model.face_count);
    struct side_counts once = count_sides(c, sides, kept <= SIDES ? kept : 0);
    for (int i = 0; i < NUMBERS * NUMBERS; i++) {
        int wanted = exact.count[i / NUMBERS][i % NUMBERS];
        if (all.count[i / NUMBERS][i % NUMBERS] != wanted ||
            once.count[i / NUMBERS][i % NUMBERS] != (wanted > 0)) {
            return false;
        }
    }
    return !all.stranger && !once.stranger;
}

static void print_sides(const void *failing) {
    const struct sides_case *c = failing;
    for (int i = 0; i < c->face_count; i++) {
        printf("    f %llu %llu %llu\n", (unsigned long long)c->number[c->corner[i][0]] + 1,
               (unsigned long long)c->number[c->corner[i][1]] + 1,
               (unsigned long long)c->number[c->corner[i][2]] + 1);
    }
}

/* ---- From the model to the image ---- */

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

/* Is it the pixel that holds the place? Beside the border of two pixels either is right. */
static bool pixel_holds(int pixel, double place, int size) {
    long double exact = ((long double)place + 1) * size / 2;
    long double slack = 1e-15L * (fabsl(exact) + size);
    return pixel <= exact + slack && exact < pixel + 1 + slack;
}

/* Outside the limit by more than a pixel, or no number. */
static bool is_too_far(double place, int size) {
    return !(fabsl(((long double)place + 1) * size / 2) <= LINE_LIMIT + 1);
}

static bool is_near_enough(double place, int size) {
    return fabsl(((long double)place + 1) * size / 2) <= LINE_LIMIT - 1;
}

static bool place_is_right(const void *tried) {
    const struct place_case *c = tried;
    struct pixel p = {-7, -9};
    struct vec3 position = {c->x, c->y, NAN};
    bool placed = to_pixel(position, (size_t)c->width, (size_t)c->height, &p);
    if (!placed) {
        return p.x == -7 && p.y == -9 &&
               !(is_near_enough(c->x, c->width) && is_near_enough(c->y, c->height));
    }
    return !is_too_far(c->x, c->width) && !is_too_far(c->y, c->height) &&
           pixel_holds(p.x, c->x, c->width) && pixel_holds(p.y, c->y, c->height);
}

static void print_place(const void *failing) {
    const struct place_case *c = failing;
    printf("    v %.17g %.17g 0, %dx%d pixels\n", c->x, c->y, c->width, c->height);
}

static const struct case_kind sides_cases = {sizeof(struct sides_case), make_sides, print_sides,
                                             NULL};
static const struct case_kind place_cases = {sizeof(struct place_case), make_place, print_place,
                                             NULL};

const struct property lesson02_properties[] = {
    PROPERTY("lesson02: each side once", AGAINST_INTEGERS, 100000, sides_cases,
             .holds = sides_are_right),
    PROPERTY("lesson02: from model to image", AGAINST_LONG_DOUBLE, 500000, place_cases,
             .holds = place_is_right),
    {.name = NULL},
};
