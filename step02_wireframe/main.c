/*
 * Lesson 2: a model made of lines.
 *
 * A face of a model has three edges. Each becomes a line: x and y of its ends are mapped to the
 * image, and z is ignored. An edge that two faces share is drawn once. A line may reach far beyond
 * the image: line_inside() walks only over the part inside, which has the same pixels as the whole.
 */
#include "program.h"

#include <stdlib.h>

/* ---- The edges of the faces ---- */

/* An edge joins two positions of the model, the smaller number first: so an edge that two faces
 * share looks the same in both. */
struct side {
    uint32_t low, high;
};

/* All three edges of every face, one face after the other; `sides` has room for 3 a face. */
static void list_sides(const struct model *model, struct side *sides) {
    /* BEGIN SOLUTION 2a.1 the edges of the faces */
    for (size_t i = 0; i < model->face_count; i++) {
        const struct corner *corner = model->faces[i].corner;
        for (size_t j = 0; j < 3; j++) {
            uint32_t p = corner[j].position, q = corner[(j + 1) % 3].position;
            *sides++ = p < q ? (struct side){p, q} : (struct side){q, p};
        }
    }
    /* STARTER
    (void)model, (void)sides; // to do 2a.1: three sides a face, the smaller number first
    END SOLUTION */
}

/* BEGIN SOLUTION 2a.4 each edge once */
static int compare_sides(const void *a, const void *b) {
    const struct side *p = a, *q = b;
    if (p->low != q->low) {
        return p->low < q->low ? -1 : 1;
    }
    return (p->high > q->high) - (p->high < q->high);
}

/* END SOLUTION */

/* Sort the sides, so that equal ones are neighbours, and keep one of each. Returns how many. */
static size_t keep_one_of_each(struct side *sides, size_t side_count) {
    /* BEGIN SOLUTION 2a.4 each edge once */
    qsort(sides, side_count, sizeof *sides, compare_sides);
    size_t kept = 0;
    for (size_t i = 0; i < side_count; i++) {
        if (kept == 0 || compare_sides(&sides[i], &sides[kept - 1]) != 0) {
            sides[kept++] = sides[i];
        }
    }
    return kept;
    /* STARTER
    (void)sides;
    return side_count; // to do 2a.4: keep one of each side, at the beginning of the list
    END SOLUTION */
}

/* ---- From the model to the image ---- */

/* x and y in -1..1 fill the image. False, with `pixel` unchanged, for a position too far away to
 * draw lines there. */
static bool to_pixel(struct vec3 position, size_t width, size_t height, struct pixel *pixel) {
    /* BEGIN SOLUTION 2a.2 from the model to the image */
    double x = floor((position.x + 1) * (double)width / 2);
    double y = floor((position.y + 1) * (double)height / 2);
    if (!(fabs(x) <= LINE_LIMIT && fabs(y) <= LINE_LIMIT)) {
        return false;
    }
    *pixel = (struct pixel){(int)x, (int)y};
    return true;
    /* STARTER
    (void)position, (void)width, (void)height, (void)pixel;
    return false; // to do 2a.2: test the limit before you convert to int
    END SOLUTION */
}

/* ---- A line ---- */

/* Draw a whole line, as in lesson 1. Returns how many pixels it walked over, in the image or
 * not. */
static uint64_t line(struct image *image, struct pixel a, struct pixel b, struct color color) {
    /* BEGIN SOLUTION 2a.3 a line */
    int64_t x_distance = (int64_t)b.x - a.x, y_distance = (int64_t)b.y - a.y;
    bool steep = llabs(y_distance) > llabs(x_distance);
    if (steep ? y_distance < 0 : x_distance < 0) {
        struct pixel kept = a;
        a = b;
        b = kept;
    }
    int64_t u = steep ? a.y : a.x, v = steep ? a.x : a.y;
    int v_step = (steep ? b.x < a.x : b.y < a.y) ? -1 : 1;
    int64_t run = llabs(steep ? y_distance : x_distance);
    int64_t rise = llabs(steep ? x_distance : y_distance), error = -run;
    for (int64_t k = 0; k <= run; k++) {
        image_set(image, (int)(steep ? v : u), (int)(steep ? u : v), color);
        u++;
        error += 2 * rise;
        if (error > 0) {
            v += v_step;
            error -= 2 * run;
        }
    }
    return (uint64_t)run + 1;
    /* STARTER
    image_set(image, a.x, a.y, color); // to do 2a.3: the line of lesson 1, not only its ends
    image_set(image, b.x, b.y, color);
    return 2; // how many pixels it has
    END SOLUTION */
}

/* ---- A line cut to the image ---- */

/* Some steps of a line's walk, which begins with step 0. */
struct steps {
    int64_t first, last; /* inclusive; none when first > last */
};

/* BEGIN SOLUTION 2b.1 the steps in the image */
/* Where a line begins and how it goes on: u is the axis along which it is longer, v the other.
 * After k steps along u (0 <= k <= run) it has moved by floor((2 * k * rise + run - 1) / (2 * run))
 * along v: k * rise / run to the nearest whole number, halves down. */
struct course {
    bool steep;        /* u is y and v is x */
    int64_t u, v;      /* where it starts: the left end, or the lower end of a steep line */
    int64_t run, rise; /* lengths along u and v, neither negative */
    int v_step;        /* +1 or -1 */
};

static struct course course_from(struct pixel a, struct pixel b) {
    int64_t x_distance = (int64_t)b.x - a.x, y_distance = (int64_t)b.y - a.y;
    bool steep = llabs(y_distance) > llabs(x_distance);
    bool back = steep ? y_distance < 0 : x_distance < 0;
    struct pixel start = back ? b : a, end = back ? a : b;
    return (struct course){
        .steep = steep,
        .u = steep ? start.y : start.x,
        .v = steep ? start.x : start.y,
        .run = steep ? llabs(y_distance) : llabs(x_distance),
        .rise = steep ? llabs(x_distance) : llabs(y_distance),
        .v_step = (steep ? end.x < start.x : end.y < start.y) ? -1 : 1,
    };
}

/* The first step after which the line has moved by `move` or more along v; run + 1 when it never
 * moves as far. From (2 * k * rise + run - 1) / (2 * run) >= move, solved for k. With coordinates
 * from -2^29 to 2^29 all products are below 2^62. */
static int64_t first_step_moved(const struct course *course, int64_t move) {
    if (move <= 0) {
        return 0;
    }
    if (move > course->rise) {
        return course->run + 1;
    }
    return ceil_divide(2 * course->run * move - course->run + 1, 2 * course->rise);
}

/* END SOLUTION */

/* The steps of the line from a to b whose pixels lie in an image of that size. v only ever moves
 * one way, so these steps follow each other: from the first one that has moved far enough to come
 * in, to the last one that has not moved too far. */
static struct steps steps_inside(struct pixel a, struct pixel b, size_t width, size_t height) {
    /* BEGIN SOLUTION 2b.1 the steps in the image */
    const struct course course = course_from(a, b);
    int64_t u_size = (int64_t)(course.steep ? height : width);
    int64_t v_size = (int64_t)(course.steep ? width : height);
    bool up = course.v_step > 0;
    int64_t least_move = up ? -course.v : course.v - (v_size - 1);
    int64_t most_move = up ? v_size - 1 - course.v : course.v;
    int64_t first = first_step_moved(&course, least_move);
    int64_t last = first_step_moved(&course, most_move + 1) - 1;
    int64_t u_first = -course.u, u_last = u_size - 1 - course.u;
    first = first > u_first ? first : u_first;
    last = last < u_last ? last : u_last;
    return (struct steps){first, last};
    /* STARTER
    (void)width, (void)height; // to do 2b.1: only those steps, not all
    int64_t x_length = llabs((int64_t)b.x - a.x), y_length = llabs((int64_t)b.y - a.y);
    return (struct steps){0, x_length > y_length ? x_length : y_length};
    END SOLUTION */
}

/* BEGIN SOLUTION 2b.2 the walk from there on */
/* Where Bresenham's walk is after k steps, as if it had come there from the start of the line. */
struct place {
    int64_t u, v, error;
};

static struct place place_after(const struct course *course, int64_t k) {
    int64_t climbed = 2 * k * course->rise;
    int64_t moved = course->run > 0 ? (climbed + course->run - 1) / (2 * course->run) : 0;
    return (struct place){
        .u = course->u + k,
        .v = course->v + course->v_step * moved,
        .error = climbed - course->run - 2 * course->run * moved,
    };
}

/* END SOLUTION */

/* Draw these steps of the line from a to b, and walk over no others. */
static void draw_steps(struct image *image, struct pixel a, struct pixel b, struct steps steps,
                       struct color color) {
    /* BEGIN SOLUTION 2b.2 the walk from there on */
    const struct course course = course_from(a, b);
    struct place at = place_after(&course, steps.first);
    for (int64_t k = steps.first; k <= steps.last; k++) {
        image_set(image, (int)(course.steep ? at.v : at.u), (int)(course.steep ? at.u : at.v),
                  color);
        at.u++;
        at.error += 2 * course.rise;
        if (at.error > 0) {
            at.v += course.v_step;
            at.error -= 2 * course.run;
        }
    }
    /* STARTER
    // to do 2b.2: where is the walk at the first of these steps, and what is its error there?
    (void)image, (void)a, (void)b, (void)steps, (void)color;
    END SOLUTION */
}

/* Draw the part of a line that lies in the image. Returns how many pixels it has. */
static uint64_t line_inside(struct image *image, struct pixel a, struct pixel b,
                            struct color color) {
    struct steps steps = steps_inside(a, b, image->width, image->height);
    if (steps.first > steps.last) {
        return 0;
    }
    draw_steps(image, a, b, steps, color);
    return (uint64_t)(steps.last - steps.first + 1);
}

#include "scenes.h"

int main(int argc, char **argv) {
    return program_main(&step02_wireframe, argc, argv);
}
