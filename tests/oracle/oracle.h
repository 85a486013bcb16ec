/*
 * Independent answers: what is exactly right, computed in another way than the course computes it.
 *
 * Nothing here calls or copies common/geometry.c or pipeline.c; only their structs are shared.
 * Integers are 128 bits wide, so that no product can overflow; reals are long double. (Machines
 * without 128-bit integers cannot run these tests.)
 */
#ifndef TESTS_ORACLE_ORACLE_H
#define TESTS_ORACLE_ORACLE_H

#include "oracle/reals.h"
#include "raster.h"

#include <stdbool.h>
#include <stdint.h>

__extension__ typedef __int128 int128;

/* ---- Random numbers: the same sequence for the same seed on every machine ---- */

struct random {
    uint64_t state;
};

/* 64 random bits (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", 2014). */
uint64_t random_bits(struct random *random);
int64_t random_between(struct random *random, int64_t least, int64_t most); /* both inclusive */
double random_real(struct random *random, double least, double most);
struct vec3 random_vec3(struct random *random, double reach); /* each from -reach to reach */

/* ---- Lines ---- */

/* Is pixel p on the line from a to b? The line is drawn along its longer axis (x where both are
 * equal); in each column (row) it has the pixel at most half a pixel from the ideal segment; at a
 * tie the one nearer to the left (lower) end's row (column). */
bool oracle_line_has(struct pixel a, struct pixel b, struct pixel p);

/* ---- Triangles ---- */

/* Is the centre of pixel (x,y) covered by the triangle? The rule "left and top edges belong to the
 * triangle" is applied as a symbolic shift of the centre by an infinitely small step to the right
 * and a still smaller one downwards: then no centre is ever on an edge (Edelsbrunner and Muecke,
 * "Simulation of Simplicity", 1990). */
bool oracle_covers(struct fixed2 a, struct fixed2 b, struct fixed2 c, int64_t x, int64_t y);

/* All pixels of an image that the triangle can cover, and few others. */
struct rectangle oracle_box(const struct fixed2 corner[3], int width, int height);

/* Which way the corners turn on the screen: 1 counterclockwise, -1 clockwise, 0 on one line. */
int oracle_turn(struct fixed2 a, struct fixed2 b, struct fixed2 c);

/* Compare the depths of two triangles at the centre of pixel (x,y): the sign of first - second,
 * exact. Depths at the corners are whole numbers of at most 2^24 and coordinates at most 2^20
 * (1/256 pixel), or, at pixels that both cover, depths of 0..2^52 and coordinates of 0..2^18. */
int oracle_compare_depth(const struct fixed2 first[3], const int64_t first_depth[3],
                         const struct fixed2 second[3], const int64_t second_depth[3], int64_t x,
                         int64_t y);

/* The depth z/w of a triangle in perspective at the centre of pixel (x,y): a fraction of 128-bit
 * integers, rounded once. z and w of the corners are whole numbers, |z| < 2^22 and 0 < w < 2^7,
 * coordinates at most 2^15 (1/256 pixel; 2^20 where each w is 1). */
long double oracle_perspective_depth(const struct fixed2 corner[3], const int64_t z[3],
                                     const int64_t w[3], int64_t x, int64_t y);

/* ---- Interpolation ---- */

/* The value at the centre of pixel (x,y) of an attribute that is linear on the triangle in space:
 * solves for the plane's point behind the pixel in long double. */
long double oracle_interpolate(const struct fixed2 corner[3], const double recip_w[3],
                               const double value[3], int64_t x, int64_t y);

/* How much is added up, at most, for that value when it is computed as a quotient of two planes on
 * the screen, each from its value at some pixel of the triangle's box on: 1 ulp of it is what one
 * rounding may cost. Much more than the value itself where the triangle is a sliver, or where w
 * differs much from corner to corner. */
long double oracle_rounding_scale(const struct fixed2 corner[3], const double recip_w[3],
                                  const double value[3], int64_t x, int64_t y);

/* ---- Cameras ---- */

/* The axes of a camera's frame: x to the right, y up, z from center to eye. Zero where they are not
 * certain: z where eye and center are equal, x and y also where up is 0 or within 1e-9 of z. */
struct oracle_frame {
    struct real3 axis[3];
    long double sine; /* of the angle between up and z; 0 where x and y are not certain */
};

struct oracle_frame oracle_frame(struct vec3 eye, struct vec3 center, struct vec3 up);

/* World to clip for a camera at eye that looks at center: x and y are `zoom` times the distance
 * from the line of sight, z is the place along it, from center to eye, and w the distance from the
 * eye along it, in units of the distance of the center. The frame must be certain. */
void oracle_camera(struct vec3 eye, struct vec3 center, struct vec3 up, double zoom,
                   long double to_clip[4][4]);

/* ---- Matrices ---- */

/* The exact determinant of a matrix of whole numbers of at most 2^24, by cofactors. */
int128 oracle_determinant(const int64_t m[4][4]);

/* Entry (row, column) of the exact inverse of such a matrix, times its determinant: a fraction's
 * numerator (Cramer's rule). */
int128 oracle_inverse_numerator(const int64_t m[4][4], int row, int column);

#endif
