/*
 * The stress run: named properties, each tried on very many cases, most of them hostile.
 *
 * Case number i of a property is made from (seed, property, i) alone, so that any case can be made
 * again, in any order and by any number of threads.
 */
#ifndef TESTS_UPKEEP_STRESS_STRESS_H
#define TESTS_UPKEEP_STRESS_STRESS_H

#include "oracle/oracle.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { CASE_SIZE_LIMIT = 4096 }; /* bytes of a case */

/* What the program's answer is compared with. The first three are answers computed in another way
 * than the program computes them. */
enum against {
    AGAINST_NOT_SAID,
    AGAINST_INTEGERS,    /* exact: 64 or 128 bits, nothing is rounded */
    AGAINST_FRACTIONS,   /* exact: of 128-bit integers, within an error that the property names */
    AGAINST_LONG_DOUBLE, /* 11 more bits than double, within an error that the property names */
    AGAINST_ITSELF,      /* the same work in another order or place must give the same result */
    AGAINST_BOUNDS,      /* what must hold of any result, such as a length of 1 */
    AGAINST_KINDS
};

/* What the judge of a case tells besides yes or no. Starts as zero. */
struct tally {
    double error;      /* the greatest, in the property's unit */
    uint64_t asked;    /* pixels that were judged */
    uint64_t left_out; /* pixels that were not: two answers are too close to tell which is right */
};

struct property {
    const char *name;
    enum against against;
    uint64_t cases; /* of a run of ordinary length */
    bool all;       /* these are all cases there are, in a run of any length */
    size_t size;    /* bytes of a case, which is plain data */
    void (*make)(struct random *random, uint64_t index, void *made);
    /* Does the property hold for this case? Any of the three that are given must say so: error() is
     * at most `limit` (unless that is 0), holds(), and judge(), which also counts. */
    double (*error)(const void *tried);
    double limit;
    const char *error_unit; /* of error(), or of judge()'s; NULL where there is none */
    bool (*holds)(const void *tried);
    bool (*judge)(const void *tried, struct tally *tally);
};

/* A property of cases of that type, and by name what it has of error(), holds() and judge(). */
#define PROPERTY(title, answer, count, type, maker, ...)                                           \
    {                                                                                              \
        .name = (title), .against = (answer), .cases = (count), .size = sizeof(type),              \
        .make = (maker), __VA_ARGS__                                                               \
    }

/* A property of all cases there are, whose answer is in integers. */
#define ALL(title, count, type, maker, exact)                                                      \
    PROPERTY(title, AGAINST_INTEGERS, count, type, maker, .all = true, .holds = (exact))

/* ---- Triangles of any kind on a small screen ---- */

enum { SCREEN_WIDTH = 12, SCREEN_HEIGHT = 9 }; /* pixels */

/* Slivers, points and lines, triangles smaller than a pixel and as far out as is allowed; corners
 * and edges on pixel centres. `index` chooses the kind: each 32 of them have all. */
void random_triangle(struct random *random, uint64_t index, struct fixed2 corner[3]);

/* ---- Properties ---- */

/* Tables that end with a property without a name. */
extern const struct property line_properties[];
extern const struct property triangle_properties[];
extern const struct property pipeline_properties[];
extern const struct property camera_properties[];
extern const struct property texture_properties[];
extern const struct property small_properties[];
extern const struct property lesson04_properties[];
extern const struct property lesson05_properties[];
extern const struct property lesson06_properties[];
extern const struct property lesson07_properties[];
extern const struct property lesson08_properties[];
extern const struct property lesson09_properties[];
extern const struct property lesson10_properties[];

#endif
