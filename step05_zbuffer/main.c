/*
 * Lesson 5: the depth buffer.
 *
 * Every pixel remembers the depth of what it shows. A triangle changes a pixel only where it is
 * nearer than what is there, so the order in which triangles come no longer matters.
 *
 * Depth: larger is nearer; minus infinity where nothing has been drawn.
 */
#include "program.h"

#include <math.h>

/* ---- One row ---- */

/* A line in the plane of the picture. Its viewer is above the upper edge and looks down the
 * page: the larger y, the nearer. */
struct segment {
    struct vec2 a, b; /* a.x < b.x */
    struct color color;
};

/* Draw a segment as its viewer sees it: into a row of the image, whose depths are `depths`. A pixel
 * is covered when its centre x + 0.5 lies in a.x <= x + 0.5 < b.x. */
static void draw_segment(const struct segment *s, struct image *image, int row, double *depths) {
    /* BEGIN SOLUTION 5.1 one row of depths */
    for (int x = 0; x < (int)image->width; x++) {
        double center = x + 0.5;
        if (center < s->a.x || center >= s->b.x) {
            continue;
        }
        double along = (center - s->a.x) / (s->b.x - s->a.x); /* 0 at a, 1 at b */
        double depth = s->a.y + (s->b.y - s->a.y) * along;
        if (depth > depths[x]) {
            depths[x] = depth;
            image_set(image, x, row, s->color);
        }
    }
    /* STARTER
    (void)s, (void)image, (void)row, (void)depths;
    // to do 5.1: for every covered pixel find the depth; keep the nearest with its colour
    END SOLUTION */
}

/* ---- Triangles ---- */

/* A corner of a triangle that is to be drawn. */
struct vertex {
    struct fixed2 position; /* on the screen */
    double depth;           /* larger is nearer */
};

/* What is drawn on, and the work done on it. */
struct canvas {
    struct image *image;
    double *depth;          /* one a pixel, row by row from the bottom */
    uint64_t pixels_tested; /* covered by a triangle */
    uint64_t pixels_written;
};

/* The triangle of lesson 4 with a depth at each corner, interpolated and compared at every pixel.
 * Where depths are equal, the first one drawn stays. */
static void triangle(struct canvas *canvas, const struct vertex v[3], struct color color) {
    struct image *image = canvas->image;
    struct edges edges;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                     image->height)) {
        return;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        /* BEGIN SOLUTION 5.2 depth test */
        double *row = canvas->depth + (size_t)y * image->width;
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(&edges, x, y);
            double depth = interpolate_depth(weight, v[0].depth, v[1].depth, v[2].depth);
            canvas->pixels_tested++;
            if (depth > row[x]) {
                row[x] = depth;
                image_set(image, x, y, color);
                canvas->pixels_written++;
            }
        }
        /* STARTER
        (void)span, (void)color; // to do 5.2: for each pixel of the span compare its depth
        END SOLUTION */
    }
}

/* ---- The depths as a picture ---- */

enum { DEPTH_LEVEL_FAR = 55, DEPTH_LEVEL_NEAR = 255 };

/* The grey image of the depths: the farthest that is seen is DEPTH_LEVEL_FAR, the nearest
 * DEPTH_LEVEL_NEAR, nothing 0. A single depth becomes DEPTH_LEVEL_FAR. */
static void show_depths(struct image *image, const double *depth) {
    /* BEGIN SOLUTION 5.3 depths as grey values */
    size_t pixel_count = image->width * image->height;
    double far = INFINITY, near = -INFINITY;
    for (size_t i = 0; i < pixel_count; i++) {
        if (depth[i] > -INFINITY) {
            far = depth[i] < far ? depth[i] : far;
            near = depth[i] > near ? depth[i] : near;
        }
    }
    double levels = DEPTH_LEVEL_NEAR - DEPTH_LEVEL_FAR;
    double range = near > far ? near - far : 1;
    for (size_t i = 0; i < pixel_count; i++) {
        double level = DEPTH_LEVEL_FAR + (depth[i] - far) * levels / range;
        image->pixels[i] = depth[i] > -INFINITY ? level_from(level) : 0;
    }
    /* STARTER
    (void)depth; // to do 5.3: find the farthest and the nearest depth, then the grey values
    image_clear(image, color_grey(0));
    END SOLUTION */
}

/* ---- Lines with depths ---- */

/* An end of a line. */
struct line_end {
    struct pixel pixel;
    double depth; /* larger is nearer */
};

/* Draw the line of lesson 2 with a depth at each end, interpolated along its longer axis and
 * compared at every pixel. A line of one pixel has the depth of a. */
static void hidden_line(struct canvas *canvas, struct line_end a, struct line_end b,
                        struct color color) {
    /* BEGIN SOLUTION 5.4 hidden lines */
    struct image *image = canvas->image;
    struct line_walk walk;
    bool more = line_begin(&walk, a.pixel, b.pixel, image->width, image->height);
    for (; more; more = line_next(&walk)) {
        int steps = walk.steep ? walk.y - a.pixel.y : walk.x - a.pixel.x; /* from a */
        int run = walk.steep ? b.pixel.y - a.pixel.y : b.pixel.x - a.pixel.x;
        double alpha = run != 0 ? (double)steps / run : 0; /* 0 at a, 1 at b */
        double depth = a.depth + (b.depth - a.depth) * alpha;
        double *there = &canvas->depth[(size_t)walk.y * image->width + (size_t)walk.x];
        if (depth > *there) {
            *there = depth;
            image_set(image, walk.x, walk.y, color);
        }
    }
    /* STARTER
    (void)canvas, (void)a, (void)b, (void)color; // to do 5.4: walk along the line; compare depths
    END SOLUTION */
}

#include "scenes.h"

int main(int argc, char **argv) {
    return program_main(&step05_zbuffer, argc, argv);
}
