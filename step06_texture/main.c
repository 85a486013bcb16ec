/*
 * Lesson 6: textures, which are pictures on triangles.
 *
 * Each corner of a face has a texture coordinate (u,v), a place in a picture. Inside the face u and
 * v are interpolated like the depth, and the colour of a pixel is looked up in the picture.
 */
#include "program.h"
#include "texture.h"

#include <math.h>

/* ---- From a place in a picture to a colour ---- */

/* Where a picture repeats, all coordinates mean one in 0 <= u < 1, 0 <= v < 1: that one. */
static struct vec2 repeat(struct vec2 uv) {
    /* BEGIN SOLUTION 6b.1 repeat */
    return (struct vec2){uv.x - floor(uv.x), uv.y - floor(uv.y)};
    /* STARTER
    return uv; // to do 6b.1: -0.7, 0.3 and 1.3 all mean 0.3
    END SOLUTION */
}

/* The place in a picture that repeats; (u,v) as it is in a picture that is clamped. */
static struct vec2 place_in(const struct texture *texture, struct vec2 uv) {
    if (texture->clamp) {
        return uv;
    }
    struct vec2 part = repeat(uv);
    return (struct vec2){texture_clamp(part.x, 1), texture_clamp(part.y, 1)};
}

/* BEGIN SOLUTION 6a.1 nearest texel */
/* The texel that holds the coordinate, on an axis of `size` texels: i where i/size <= coordinate <
 * (i+1)/size. Outside 0..1 it is the texel at the edge. */
static size_t texel_index(double coordinate, size_t size) {
    return (size_t)texture_clamp(floor(coordinate * (double)size), (double)(size - 1));
}
/* END SOLUTION */

/* Sampler 1: the colour of the texel that holds the point. */
static struct color sample_nearest(const struct texture *texture, struct vec2 uv) {
    uv = place_in(texture, uv);
    /* BEGIN SOLUTION 6a.1 nearest texel */
    const struct texture_level *level = &texture->level[0];
    size_t x = texel_index(uv.x, level->width), y = texel_index(uv.y, level->height);
    return color_from_texel(texture_texel(level, x, y));
    /* STARTER
    (void)texture, (void)uv; // to do 6a.1: which texel of texture->level[0] holds uv?
    return color_from_texel(0);
    END SOLUTION */
}

/* ---- Triangles ---- */

/* A corner of a triangle on the screen. */
struct vertex {
    struct fixed2 position; /* on the screen */
    double depth;           /* larger is nearer */
    struct vec2 uv;
    double recip_w; /* 1/w, where w is the distance from the camera; only in perspective */
};

/* How a pixel in perspective finds its colour. */
enum sampler { SAMPLE_NEAREST, SAMPLE_BILINEAR, SAMPLE_TRILINEAR };

/* The image with its depth buffer, and how to draw on it. */
struct canvas {
    struct image *image;
    double *depth;        /* of each pixel, row by row from the bottom; none in perspective */
    enum sampler sampler; /* in perspective; the first two read level 0 */
};

/* A texture's colour times an intensity 0..1. */
static struct color shade(struct color texel, double intensity) {
    return color_rgb(level_from(texel.r * intensity), level_from(texel.g * intensity),
                     level_from(texel.b * intensity));
}

/* The triangle of lesson 5 with u and v interpolated like the depth. Without perspective everything
 * is linear on the screen. */
static void triangle(const struct canvas *canvas, const struct vertex v[3],
                     const struct texture *texture, double intensity) {
    struct image *image = canvas->image;
    struct edges edges;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                     image->height)) {
        return;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        /* BEGIN SOLUTION 6a.2 texture on a triangle */
        double *row = canvas->depth + (size_t)y * image->width;
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(&edges, x, y);
            double depth = interpolate_depth(weight, v[0].depth, v[1].depth, v[2].depth);
            if (depth > row[x]) {
                row[x] = depth;
                struct vec2 uv = vec2_interpolate(weight, v[0].uv, v[1].uv, v[2].uv);
                image_set(image, x, y, shade(sample_nearest(texture, uv), intensity));
            }
        }
        /* STARTER
        // to do 6a.2: lesson 5, but each pixel in the colour of its texel times the intensity
        (void)span, (void)texture, (void)intensity, (void)sample_nearest, (void)shade;
        END SOLUTION */
    }
}

/* ---- Triangles in perspective ---- */

/* u/w, v/w and 1/w as x, y and z. In perspective these are linear on the screen, while u and v are
 * not (Heckbert and Moreton, "Interpolation for polygon texture mapping and shading", 1991). */
struct quotients {
    struct edges edges;
    struct vec3 corner[3]; /* their values at the corners */
    struct vec3 right, up; /* what they gain in a step to the right, and in a step up */
};

/* Sets up a triangle. False when edges_setup() says so. */
static bool plane_begin(struct quotients *plane, const struct image *image,
                        const struct vertex v[3]) {
    struct edges *edges = &plane->edges;
    if (!edges_setup(edges, v[0].position, v[1].position, v[2].position, image->width,
                     image->height)) {
        return false;
    }
    struct vec3 *c = plane->corner;
    /* BEGIN SOLUTION 6b.2 linear on the screen */
    for (int i = 0; i < 3; i++) {
        c[i] = (struct vec3){v[i].uv.x * v[i].recip_w, v[i].uv.y * v[i].recip_w, v[i].recip_w};
    }
    /* STARTER
    c[0] = c[1] = c[2] = (struct vec3){0, 0, 1}; // to do 6b.2: u/w, v/w and 1/w of each corner
    END SOLUTION */
    /* BEGIN SOLUTION 6e.1 one step */
    const struct edge *e = edges->edge;
    double area = (double)edges->area;
    struct vec3 right = {(double)e[0].dx / area, (double)e[1].dx / area, (double)e[2].dx / area};
    struct vec3 up = {(double)e[0].dy / area, (double)e[1].dy / area, (double)e[2].dy / area};
    plane->right = vec3_interpolate(right, c[0], c[1], c[2]);
    plane->up = vec3_interpolate(up, c[0], c[1], c[2]);
    /* STARTER
    plane->right = plane->up = (struct vec3){0, 0, 0}; // to do 6e.1: what c gains in one step
    END SOLUTION */
    return true;
}

/* The place in the picture that a pixel shows, and its distance. */
static struct vec2 plane_uv(const struct quotients *plane, int x, int y, double *w) {
    /* BEGIN SOLUTION 6b.3 divided back */
    const struct vec3 *c = plane->corner;
    struct vec3 over_w = vec3_interpolate(edges_weights(&plane->edges, x, y), c[0], c[1], c[2]);
    *w = 1 / over_w.z;
    return vec2_scale((struct vec2){over_w.x, over_w.y}, *w);
    /* STARTER
    (void)plane, (void)x, (void)y; // to do 6b.3: interpolate u/w, v/w and 1/w, then divide once
    *w = 1;
    return (struct vec2){0, 0};
    END SOLUTION */
}

/* ---- The same at every distance ---- */

/* BEGIN SOLUTION 6c.1 bilinear */
/* Two neighbouring texels on one axis, and where the point is between their centres. */
struct neighbours {
    size_t first, second;
    double part; /* 0 at the centre of the first, 1 at the centre of the second */
};

/* The centre of texel i is at coordinate (i + 0.5) / size, so the point is
 * coordinate * size - 0.5 texels beyond the centre of texel 0. Beyond the last texel comes the
 * first one again; where the picture is clamped, the edge texel alone counts. */
static struct neighbours find_neighbours(double coordinate, size_t size, bool clamp) {
    double position = coordinate * (double)size - 0.5, last = (double)(size - 1);
    if (clamp) {
        position = texture_clamp(position, last);
    }
    double first = floor(position);
    return (struct neighbours){
        .first = first < 0 ? size - 1 : (size_t)first,
        .second = first < last ? (size_t)(first + 1)
                  : clamp      ? size - 1
                               : 0,
        .part = position - first,
    };
}

/* Mixed along u in one row of texels. */
static struct vec4 mix_in_row(const struct texture_level *level, size_t row, struct neighbours x) {
    uint32_t first = texture_texel(level, x.first, row);
    uint32_t second = texture_texel(level, x.second, row);
    return texture_mix(channels_from_texel(first), channels_from_texel(second), x.part);
}
/* END SOLUTION */

/* Bilinear (sampler 2): mixed from the four texels around the point, on one mip level. The
 * channels are 0..255 and not rounded. */
static struct vec4 sample_bilinear(const struct texture *texture, struct vec2 uv, size_t number) {
    uv = place_in(texture, uv);
    /* BEGIN SOLUTION 6c.1 bilinear */
    const struct texture_level *level = &texture->level[number];
    struct neighbours x = find_neighbours(uv.x, level->width, texture->clamp);
    struct neighbours y = find_neighbours(uv.y, level->height, texture->clamp);
    return texture_mix(mix_in_row(level, y.first, x), mix_in_row(level, y.second, x), y.part);
    /* STARTER
    (void)texture, (void)uv, (void)number; // to do 6c.1: mix four texels of texture->level[number]
    return channels_from_texel(0);
    END SOLUTION */
}

/* Sampler 3: mixed from the two mip levels next to `level` (Williams, "Pyramidal parametrics",
 * 1983). Level 0 is the whole picture, and each level has half the width and height of the one
 * before. */
static struct vec4 sample_trilinear(const struct texture *texture, struct vec2 uv, double level) {
    /* BEGIN SOLUTION 6d.1 trilinear */
    size_t last = texture->level_count - 1;
    double clamped = texture_clamp(level, (double)last);
    size_t finer = (size_t)clamped, coarser = finer < last ? finer + 1 : last;
    return texture_mix(sample_bilinear(texture, uv, finer), sample_bilinear(texture, uv, coarser),
                       clamped - (double)finer);
    /* STARTER
    (void)level; // to do 6d.1: mix the two levels; there are texture->level_count
    return sample_bilinear(texture, uv, 0);
    END SOLUTION */
}

/* What u and v gain in a step: the derivative of the quotient u = (u/w) / (1/w). `gain` is what
 * u/w, v/w and 1/w gain. */
static struct vec2 uv_step(struct vec3 gain, struct vec2 uv, double w) {
    /* BEGIN SOLUTION 6e.1 one step */
    return (struct vec2){(gain.x - uv.x * gain.z) * w, (gain.y - uv.y * gain.z) * w};
    /* STARTER
    (void)gain, (void)uv, (void)w; // to do 6e.1: what u and v gain
    return (struct vec2){0, 0};
    END SOLUTION */
}

/* The mip level whose texels are as large as the step from one pixel to the next: log2 of the
 * step's length in texels. `right` and `up` are what u and v gain, in units of the whole picture,
 * from a pixel to its right and to its upper neighbour. The longer step counts. */
static double mip_level(struct vec2 right, struct vec2 up, const struct texture *texture) {
    /* BEGIN SOLUTION 6e.2 mip level */
    double width = (double)texture->level[0].width, height = (double)texture->level[0].height;
    double last = (double)(texture->level_count - 1);
    double across = right.x * width * (right.x * width) + right.y * height * (right.y * height);
    double along = up.x * width * (up.x * width) + up.y * height * (up.y * height);
    double square = across > along ? across : along;
    if (!(square > 1)) {
        return 0; /* a texel is larger than a pixel: magnified */
    }
    if (square > 0x1p40) {
        return last; /* beyond all levels, also when it is infinite */
    }
    /* e + f instead of log2 of 2^e * (1 + f): exact at powers of 2, at most 0.0861 too small
     * between them, and the same on every machine. The level is half of it, because this is the
     * square of the length; so it is at most 0.0431 too small. */
    int exponent;
    double fraction = frexp(square, &exponent); /* square = fraction * 2^exponent, 0.5..1 */
    return texture_clamp(0.5 * ((exponent - 1) + (2 * fraction - 1)), last);
    /* STARTER
    (void)right, (void)up, (void)texture; // to do 6e.2: how many texels does a pixel move?
    return 0;
    END SOLUTION */
}

/* ---- The colour of a pixel in perspective ---- */

/* The colour by the canvas's sampler. Sampler 3 needs the mip level of this pixel. */
static struct color color_at(const struct canvas *canvas, const struct quotients *plane, int x,
                             int y, const struct texture *texture) {
    double w;
    struct vec2 uv = plane_uv(plane, x, y, &w);
    if (canvas->sampler == SAMPLE_NEAREST) {
        return sample_nearest(texture, uv);
    }
    if (canvas->sampler == SAMPLE_BILINEAR) {
        struct vec4 four = sample_bilinear(texture, uv, 0);
        return color_rgb(level_from(four.x), level_from(four.y), level_from(four.z));
    }
    /* BEGIN SOLUTION 6e.3 the level of the pixel */
    double level = mip_level(uv_step(plane->right, uv, w), uv_step(plane->up, uv, w), texture);
    /* At level 0 a second level would count for nothing. */
    struct vec4 c =
        level > 0 ? sample_trilinear(texture, uv, level) : sample_bilinear(texture, uv, 0);
    return color_rgb(level_from(c.x), level_from(c.y), level_from(c.z));
    /* STARTER
    (void)mip_level, (void)uv_step;
    struct vec4 t = sample_bilinear(texture, uv, 0); // to do 6e.3: sampler 3 at its level
    return color_rgb(level_from(t.x), level_from(t.y), level_from(t.z));
    END SOLUTION */
}

/* A triangle in perspective, without depth test and light. */
static void perspective_triangle(const struct canvas *canvas, const struct vertex v[3],
                                 const struct texture *texture) {
    struct quotients plane;
    if (!plane_begin(&plane, canvas->image, v)) {
        return;
    }
    for (int y = plane.edges.y_begin; y < plane.edges.y_end; y++) {
        struct span span = edges_span(&plane.edges, y);
        for (int x = span.begin; x < span.end; x++) {
            image_set(canvas->image, x, y, color_at(canvas, &plane, x, y, texture));
        }
    }
}

#include "scenes.h"

int main(int argc, char **argv) {
    return program_main(&step06_texture, argc, argv);
}
