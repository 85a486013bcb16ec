/*
 * Lesson 1: one pixel, a line, and a line whose colour changes on its way.
 *
 * A line between two pixels is walked along the axis on which it is longer, called u here; the
 * other axis is v. Every u between the two ends gets exactly one pixel: the one nearest to the
 * ideal line. Where two are equally near, the one nearer to where the walk starts (the left end, or
 * the lower end of a steep line) is taken. So the pixels do not depend on the order of the end
 * points. All arithmetic is on integers: nothing is rounded and nothing drifts.
 */
#include "program.h"

#include <stdlib.h>
#include <string.h>

/* ---- A pixel ---- */

/* Pixel (52,41) becomes red. */
static void first_pixel(struct image *image) {
    /* BEGIN SOLUTION 1.1 one pixel */
    image_set(image, 52, 41, color_rgb(255, 0, 0));
    /* STARTER
    (void)image; // to do 1.1: one call of image_set()
    END SOLUTION */
}

/* ---- Lines ---- */

/* BEGIN SOLUTION 1.2 a line */
/* A place on the way along a line. */
struct walk {
    int64_t u, u_last; /* now, and at the end (inclusive) */
    int64_t v;
    int v_step;        /* +1 or -1 */
    int64_t run, rise; /* length along u and along v, neither negative */
    int64_t error;     /* (how far the ideal line lies beyond v, minus 1/2) times 2 * run */
    bool steep;        /* u is y and v is x */
};

/* Start at the left end, or at the lower end of a steep line. */
static struct walk walk_begin(struct pixel a, struct pixel b) {
    int64_t x_distance = (int64_t)b.x - a.x, y_distance = (int64_t)b.y - a.y;
    bool steep = llabs(y_distance) > llabs(x_distance);
    if (steep ? y_distance < 0 : x_distance < 0) {
        struct pixel kept = a;
        a = b;
        b = kept;
    }
    int64_t u_start = steep ? a.y : a.x, u_end = steep ? b.y : b.x;
    int64_t v_start = steep ? a.x : a.y, v_end = steep ? b.x : b.y;
    return (struct walk){
        .u = u_start,
        .u_last = u_end,
        .v = v_start,
        .v_step = v_end < v_start ? -1 : 1,
        .run = u_end - u_start,
        .rise = llabs(v_end - v_start),
        .error = -(u_end - u_start),
        .steep = steep,
    };
}

/* One step along u. The ideal line moves on by rise / run; when it has come more than half a pixel
 * beyond v, the next v is nearer. Multiplied by 2 * run, all of this is whole numbers. (Bresenham,
 * "Algorithm for computer control of a digital plotter", 1965.) */
static void walk_next(struct walk *walk) {
    walk->u++;
    walk->error += 2 * walk->rise;
    if (walk->error > 0) {
        walk->v += walk->v_step;
        walk->error -= 2 * walk->run;
    }
}

static struct pixel walk_pixel(const struct walk *walk) {
    return walk->steep ? (struct pixel){(int)walk->v, (int)walk->u}
                       : (struct pixel){(int)walk->u, (int)walk->v};
}

/* END SOLUTION */

/* Draw a line in one colour. Coordinates may lie far outside the image, in -1000000..1000000;
 * image_set() refuses what is outside. */
static void line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    /* BEGIN SOLUTION 1.2 a line */
    for (struct walk walk = walk_begin(a, b); walk.u <= walk.u_last; walk_next(&walk)) {
        struct pixel p = walk_pixel(&walk);
        image_set(image, p.x, p.y, color);
    }
    /* STARTER
    (void)image, (void)a, (void)b, (void)color; // to do 1.2: begin with attempt 1
    END SOLUTION */
}

/* ---- A line as a list of its pixels ---- */

/* The number of pixels of a line. */
static size_t line_length(struct pixel a, struct pixel b) {
    /* BEGIN SOLUTION 1.3 the length of a line */
    int64_t width = llabs((int64_t)b.x - a.x), height = llabs((int64_t)b.y - a.y);
    return (size_t)(width > height ? width : height) + 1;
    /* STARTER
    (void)a, (void)b;
    return 1; // to do 1.3: how many pixels does the line have?
    END SOLUTION */
}

/* The pixels of a line in list[0], list[1], ..., from the left (lower) end on. There is room for
 * line_length() of them. */
static void line_list(struct pixel a, struct pixel b, struct pixel list[]) {
    /* BEGIN SOLUTION 1.4 a line as a list */
    size_t count = 0;
    for (struct walk walk = walk_begin(a, b); walk.u <= walk.u_last; walk_next(&walk)) {
        list[count++] = walk_pixel(&walk);
    }
    /* STARTER
    list[0] = a;
    (void)b; // to do 1.4: the same walk as in line()
    END SOLUTION */
}

/* ---- Colours along a line ---- */

/* BEGIN SOLUTION 1.5 colours along a line */
/* The whole number nearest to from + (to - from) * k / n, halves up; n > 0, 0 <= k <= n. */
static uint8_t mix_value(uint8_t from, uint8_t to, int64_t k, int64_t n) {
    return (uint8_t)((2 * (from * (n - k) + to * k) + n) / (2 * n));
}

/* END SOLUTION */

/* The colour of pixel p of the line from a (in color_a) to b (in color_b), mixed by how far along
 * the longer axis p is from a. A point has color_a. */
static struct color color_along(struct pixel a, struct pixel b, struct color color_a,
                                struct color color_b, struct pixel p) {
    /* BEGIN SOLUTION 1.5 colours along a line */
    int64_t x_length = llabs((int64_t)b.x - a.x), y_length = llabs((int64_t)b.y - a.y);
    bool steep = y_length > x_length;
    int64_t k = steep ? llabs((int64_t)p.y - a.y) : llabs((int64_t)p.x - a.x);
    int64_t n = steep ? y_length : x_length;
    if (n == 0) {
        return color_a;
    }
    return color_rgb(mix_value(color_a.r, color_b.r, k, n), mix_value(color_a.g, color_b.g, k, n),
                     mix_value(color_a.b, color_b.b, k, n));
    /* STARTER
    (void)a, (void)b, (void)color_a, (void)color_b, (void)p;
    return color_rgb(0, 0, 0); // to do 1.5: mix each value
    END SOLUTION */
}

#include "scenes.h"

int main(int argc, char **argv) {
    return program_main(&step01_line, argc, argv);
}
