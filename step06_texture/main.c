/*
 * Step 6: pictures on triangles.
 *
 * Every corner of a face carries a texture coordinate (u,v): a place in a picture. Inside the face
 * u and v are interpolated like the depth, and the colour is looked up in the picture.
 *
 * Scenes: `texture` draws a model with its diffuse texture, nearest texel, times the intensity of
 * the face. `checker` draws a plane that reaches towards the horizon, with perspective-correct
 * texture coordinates, and a mip level chosen for every pixel.
 *
 * The samplers give the same values as those of common/texture.h, which later lessons use.
 */
#include "program.h"
#include "texture.h"

#include <math.h>
#include <stdlib.h>

/* ---- Samplers: from a place in a picture to a colour ---- */

/* `value` brought into 0..last; what is not a number becomes 0. */
static double clamp(double value, double last) {
    double positive = value > 0 ? value : 0;
    return positive < last ? positive : last;
}

/* The texel (pixel of a texture) that holds a coordinate, on an axis of `size` texels. Texel i
 * covers i/size <= coordinate < (i+1)/size, so this is floor(coordinate * size). Outside 0..1 the
 * edge texel is repeated. */
static size_t texel_index(double coordinate, size_t size) {
    return (size_t)clamp(floor(coordinate * (double)size), (double)(size - 1));
}

/* A stored texel is blue | green << 8 | red << 16 | alpha << 24. */
static struct color color_from_texel(uint32_t texel) {
    return (struct color){
        .b = (uint8_t)(texel & 255),
        .g = (uint8_t)(texel >> 8 & 255),
        .r = (uint8_t)(texel >> 16 & 255),
        .a = (uint8_t)(texel >> 24),
    };
}

/* Sampler 1: the colour of the texel that holds the point. */
static struct color sample_nearest(const struct texture *texture, struct vec2 uv) {
    const struct texture_level *level = &texture->level[0];
    size_t x = texel_index(uv.x, level->width), y = texel_index(uv.y, level->height);
    return color_from_texel(level->texels[y * level->width + x]);
}

/* Two neighbouring texels on one axis, and where the point lies between their centres. */
struct neighbours {
    size_t first, second;
    double part; /* 0 at the centre of the first, towards 1 at the centre of the second */
};

/* The centre of texel i lies at coordinate (i + 0.5) / size, so the point lies
 * coordinate * size - 0.5 texels beyond the centre of texel 0. Before the first and after the last
 * centre there is nothing to mix with: the edge texel alone counts. */
static struct neighbours find_neighbours(double coordinate, size_t size) {
    double position = clamp(coordinate * (double)size - 0.5, (double)(size - 1));
    size_t first = (size_t)position;
    return (struct neighbours){
        .first = first,
        .second = first + 1 < size ? first + 1 : first,
        .part = position - (double)first,
    };
}

/* Red, green, blue, alpha as x, y, z, w. */
static struct vec4 channels_from_texel(uint32_t texel) {
    struct color c = color_from_texel(texel);
    return (struct vec4){c.r, c.g, c.b, c.a};
}

/* a where part is 0, b where part is 1. */
static struct vec4 mix(struct vec4 a, struct vec4 b, double part) {
    return (struct vec4){
        .x = a.x + (b.x - a.x) * part,
        .y = a.y + (b.y - a.y) * part,
        .z = a.z + (b.z - a.z) * part,
        .w = a.w + (b.w - a.w) * part,
    };
}

/* Sampler 2: mixed from the four texels whose centres lie around the point, on one mip level. The
 * channels are 0..255 and not rounded. */
static struct vec4 sample_bilinear(const struct texture *texture, struct vec2 uv, size_t number) {
    const struct texture_level *level = &texture->level[number];
    struct neighbours x = find_neighbours(uv.x, level->width);
    struct neighbours y = find_neighbours(uv.y, level->height);
    const uint32_t *lower = level->texels + y.first * level->width;
    const uint32_t *upper = level->texels + y.second * level->width;
    struct vec4 below =
        mix(channels_from_texel(lower[x.first]), channels_from_texel(lower[x.second]), x.part);
    struct vec4 above =
        mix(channels_from_texel(upper[x.first]), channels_from_texel(upper[x.second]), x.part);
    return mix(below, above, y.part);
}

/* Sampler 3: mixed from the two mip levels next to `level` (Williams, "Pyramidal parametrics",
 * 1983). Level 0 is the whole picture, each next level has half its width and height. */
static struct vec4 sample_trilinear(const struct texture *texture, struct vec2 uv, double level) {
    size_t last = texture->level_count - 1;
    double clamped = clamp(level, (double)last);
    size_t finer = (size_t)clamped, coarser = finer < last ? finer + 1 : last;
    return mix(sample_bilinear(texture, uv, finer), sample_bilinear(texture, uv, coarser),
               clamped - (double)finer);
}

/* The mip level whose texels are as large as the step from one pixel to the next: log2 of the
 * number of texels in it. `right` and `up` say how far u and v move, in units of the whole picture,
 * from a pixel to its right and its upper neighbour; the longer of the two counts.
 *
 * log2 of 2^e * (1 + f) is taken as e + f, a chord of the curve: exact at powers of 2, elsewhere at
 * most 0.09 too small, and the same on every machine. Halved, because the square was measured. */
static double mip_level(struct vec2 right, struct vec2 up, const struct texture *texture) {
    double width = (double)texture->level[0].width, height = (double)texture->level[0].height;
    double across = right.x * width * (right.x * width) + right.y * height * (right.y * height);
    double along = up.x * width * (up.x * width) + up.y * height * (up.y * height);
    double square = across > along ? across : along;
    if (!(square > 1)) {
        return 0; /* a texel is larger than a pixel: magnified */
    }
    if (square > 0x1p40) {
        return (double)(texture->level_count - 1); /* beyond all levels; infinity ends here too */
    }
    int exponent;
    double fraction = frexp(square, &exponent); /* square = fraction * 2^exponent, 0.5..1 */
    double level = 0.5 * ((exponent - 1) + (2 * fraction - 1));
    return clamp(level, (double)(texture->level_count - 1));
}

/* ---- Light: as in step 4 ---- */

/* How directly the light falls on a face: 1 straight, 0 along the face, negative from behind.
 * `light` has length 1 and is the direction in which the light travels. The normal is taken so that
 * it points into the model; it agrees with `light` where the light falls on the outside. */
static double face_intensity(const struct model *model, size_t face, struct vec3 light) {
    struct vec3 w0 = model_position(model, face, 0), w1 = model_position(model, face, 1);
    struct vec3 w2 = model_position(model, face, 2);
    struct vec3 normal = vec3_normalized(vec3_cross(vec3_sub(w2, w0), vec3_sub(w1, w0)));
    return vec3_dot(normal, light);
}

/* ---- Triangles ---- */

/* A corner of a triangle that is to be drawn. */
struct vertex {
    struct fixed2 position; /* on the screen */
    double depth;           /* larger is nearer */
    struct vec2 uv;
    double recip_w; /* 1/w, w being the distance from the camera; used with perspective only */
};

/* What is drawn on, and the work done on it. */
struct canvas {
    struct image *image;
    double *depth;          /* one a pixel, row by row from the bottom; NULL without depth test */
    bool skip;              /* fetch a texel only where it will be seen */
    uint64_t pixels_tested; /* covered by a triangle */
    uint64_t pixels_written;
    uint64_t texels_fetched;
};

static void clear_depth(double *depth, size_t pixel_count) {
    for (size_t i = 0; i < pixel_count; i++) {
        depth[i] = -INFINITY;
    }
}

/* A texture's colour times an intensity 0..1. */
static struct color shade(struct color texel, double intensity) {
    return color_rgb(level_from(texel.r * intensity), level_from(texel.g * intensity),
                     level_from(texel.b * intensity));
}

/* The colour of a pixel. A model without texture coordinates has no texture (NULL): white. */
static struct color texture_color(struct canvas *canvas, const struct texture *texture,
                                  struct vec2 uv, double intensity) {
    if (texture == NULL) {
        return shade(color_grey(255), intensity);
    }
    canvas->texels_fetched++;
    return shade(sample_nearest(texture, uv), intensity);
}

/* The triangle of step 5 with u and v interpolated like the depth. There is no perspective here, so
 * everything is linear on the screen. False when no pixel centre can be inside. */
static bool triangle(struct canvas *canvas, const struct vertex v[3], const struct texture *texture,
                     double intensity) {
    struct image *image = canvas->image;
    struct edges edges;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                     image->height)) {
        return false;
    }
    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        double *row = canvas->depth + (size_t)y * image->width;
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(&edges, x, y);
            double depth = interpolate(weight, v[0].depth, v[1].depth, v[2].depth);
            bool seen = depth > row[x];
            struct color color = {0};
            canvas->pixels_tested++;
            if (seen || !canvas->skip) { /* what is hidden needs no colour */
                struct vec2 uv = vec2_interpolate(weight, v[0].uv, v[1].uv, v[2].uv);
                color = texture_color(canvas, texture, uv, intensity);
            }
            if (!seen) {
                continue;
            }
            row[x] = depth;
            image_set(image, x, y, color);
            canvas->pixels_written++;
        }
    }
    return true;
}

/* The part after the point, always 0 <= part < 1: the picture repeats. */
static struct vec2 repeat(struct vec2 uv) {
    return (struct vec2){uv.x - floor(uv.x), uv.y - floor(uv.y)};
}

/* The same in perspective. On the screen u and v are not linear, but u/w, v/w and 1/w are: these
 * are interpolated, and a division per pixel gives u and v back (Heckbert and Moreton,
 * "Interpolation for polygon texture mapping and shading", 1991). */
static void perspective_triangle(struct canvas *canvas, const struct vertex v[3],
                                 const struct texture *texture) {
    struct image *image = canvas->image;
    struct edges edges;
    if (!edges_setup(&edges, v[0].position, v[1].position, v[2].position, image->width,
                     image->height)) {
        return;
    }
    double q[3]; /* 1/w of each corner */
    struct vec2 p[3];
    for (int i = 0; i < 3; i++) {
        q[i] = v[i].recip_w;
        p[i] = vec2_scale(v[i].uv, q[i]); /* (u/w, v/w) */
    }
    /* What the weights gain in one step to the right and in one step up is the same everywhere; so
     * is what u/w, v/w and 1/w gain. */
    const struct edge *e = edges.edge;
    double area = (double)edges.area;
    struct vec3 step_right = {(double)e[0].dx / area, (double)e[1].dx / area,
                              (double)e[2].dx / area};
    struct vec3 step_up = {(double)e[0].dy / area, (double)e[1].dy / area, (double)e[2].dy / area};
    double q_right = interpolate(step_right, q[0], q[1], q[2]);
    double q_up = interpolate(step_up, q[0], q[1], q[2]);
    struct vec2 p_right = vec2_interpolate(step_right, p[0], p[1], p[2]);
    struct vec2 p_up = vec2_interpolate(step_up, p[0], p[1], p[2]);

    for (int y = edges.y_begin; y < edges.y_end; y++) {
        struct span span = edges_span(&edges, y);
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 weight = edges_weights(&edges, x, y);
            double w = 1 / interpolate(weight, q[0], q[1], q[2]);
            struct vec2 uv = vec2_scale(vec2_interpolate(weight, p[0], p[1], p[2]), w);
            /* The derivative of the quotient u = (u/w) / (1/w). */
            struct vec2 right = vec2_scale(vec2_sub(p_right, vec2_scale(uv, q_right)), w);
            struct vec2 up = vec2_scale(vec2_sub(p_up, vec2_scale(uv, q_up)), w);
            double level = mip_level(right, up, texture);
            bool one_level = canvas->skip && level == 0; /* the second would count for nothing */
            struct vec4 c = one_level ? sample_bilinear(texture, repeat(uv), 0)
                                      : sample_trilinear(texture, repeat(uv), level);
            canvas->texels_fetched += one_level ? 4 : 8;
            image_set(image, x, y, color_rgb(level_from(c.x), level_from(c.y), level_from(c.z)));
            canvas->pixels_written++;
        }
    }
}

/* ---- Scene: texture ---- */

/* Memory of a scene that is used again at every drawing. */
struct state {
    double *depth;                 /* one a pixel; scene texture */
    const struct texture *diffuse; /* belongs to the model; NULL without texture coordinates */
    struct texture checker;        /* scene checker */
};

/* Parallel view: x and y in -1..1 fill the image, and z is the depth. False for a corner too far
 * off the image to draw. */
static bool place_corner(const struct model *model, size_t face, size_t corner,
                         const struct image *image, struct vertex *vertex) {
    struct vec3 world = model_position(model, face, corner);
    struct vec2 screen = {(world.x + 1) * (double)image->width / 2,
                          (world.y + 1) * (double)image->height / 2};
    vertex->depth = world.z;
    return screen_snap(screen, &vertex->position);
}

static bool place_face(const struct model *model, size_t face, const struct image *image,
                       struct vertex vertices[3]) {
    for (size_t i = 0; i < 3; i++) {
        if (!place_corner(model, face, i, image, &vertices[i])) {
            return false;
        }
        vertices[i].uv = model_uv(model, face, i);
    }
    return true;
}

/* All faces on which light falls, as in step 4. */
static bool draw_texture(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct state *state = drawing->state;
    const struct model *model = drawing->model;
    const struct vec3 light = vec3_normalized(drawing->light);
    struct canvas canvas = {.image = image, .depth = state->depth, .skip = drawing->skip};
    uint64_t unlit = 0, placed = 0, off_limits = 0, without_pixel = 0;
    clear_depth(state->depth, image->width * image->height);
    for (size_t face = 0; face < model->face_count; face++) {
        struct vertex vertices[3];
        double intensity = face_intensity(model, face, light);
        bool lit = intensity > 0;
        unlit += !lit;
        if (!lit && drawing->skip) {
            continue; /* it will not be drawn: where it lies does not matter */
        }
        placed++;
        if (!place_face(model, face, image, vertices)) {
            off_limits += lit;
        } else if (lit && !triangle(&canvas, vertices, state->diffuse, intensity)) {
            without_pixel++;
        }
    }
    count(drawing, "faces", model->face_count);
    count(drawing, "faces_unlit", unlit);
    count(drawing, "faces_placed", placed);
    count(drawing, "faces_off_limits", off_limits);
    count(drawing, "faces_without_pixel", without_pixel);
    count(drawing, "pixels_tested", canvas.pixels_tested);
    count(drawing, "pixels_hidden", canvas.pixels_tested - canvas.pixels_written);
    count(drawing, "pixels_written", canvas.pixels_written);
    count(drawing, "texels_fetched", canvas.texels_fetched);
    return true;
}

/* ---- Scene: checker ---- */

enum { CHECKER_SIZE = 256 }; /* texels a side: a picture of two by two tiles */

/* The edges of the picture run through the middle of tiles, so both sides of the seam between two
 * repeated pictures have the same colour, on every mip level. */
static bool make_checker(struct texture *texture, struct error *error) {
    const struct color light = color_rgb(245, 235, 215), dark = color_rgb(150, 45, 30);
    struct image image;
    if (!image_create(&image, CHECKER_SIZE, CHECKER_SIZE, IMAGE_BGR, error)) {
        return false;
    }
    for (int y = 0; y < CHECKER_SIZE; y++) {
        for (int x = 0; x < CHECKER_SIZE; x++) {
            int column = (x + CHECKER_SIZE / 4) / (CHECKER_SIZE / 2); /* 0, 1 or 2 */
            int row = (y + CHECKER_SIZE / 4) / (CHECKER_SIZE / 2);
            image_set(&image, x, y, (column + row) % 2 == 0 ? light : dark);
        }
    }
    bool done = texture_create(texture, &image, error);
    image_free(&image);
    return done;
}

/* The camera stands at the origin and looks along -z. The plane lies PLANE_BELOW under it, rolled
 * about the line of sight so that the distance changes along every row too: (COSINE, SINE) points
 * to the right in the plane. The plane is cut off at PLANE_NEAR, below the image, and PLANE_FAR. */
#define PLANE_COSINE 0.96
#define PLANE_SINE   0.28
#define PLANE_BELOW  1.5
#define PLANE_SIDE   72.0
#define PLANE_NEAR   0.75
#define PLANE_FAR    60.0

/* A corner of the plane: `side` units to the right of the line of sight, `distance` before the
 * camera. In perspective a point appears at its x and y divided by w, the distance. One unit of the
 * plane is one picture: two tiles. */
static struct vertex place_on_plane(double side, double distance, const struct image *image) {
    double x = PLANE_COSINE * side + PLANE_SINE * PLANE_BELOW;
    double y = PLANE_SINE * side - PLANE_COSINE * PLANE_BELOW;
    struct vec2 screen = {(0.5 + 0.5 * x / distance) * (double)image->width,
                          (0.75 + 0.5 * y / distance) * (double)image->height};
    struct vertex vertex = {.uv = {side, distance}, .recip_w = 1 / distance};
    screen_snap(screen, &vertex.position); /* never beyond the limit: 0.5 * 72 / 0.75 images */
    return vertex;
}

/* The plane's corners, counterclockwise. */
static void place_plane(const struct image *image, struct vertex corners[4]) {
    corners[0] = place_on_plane(-PLANE_SIDE, PLANE_NEAR, image);
    corners[1] = place_on_plane(PLANE_SIDE, PLANE_NEAR, image);
    corners[2] = place_on_plane(PLANE_SIDE, PLANE_FAR, image);
    corners[3] = place_on_plane(-PLANE_SIDE, PLANE_FAR, image);
}

static bool draw_checker(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    const struct state *state = drawing->state;
    struct vertex corners[4];
    place_plane(image, corners);
    const struct vertex first[3] = {corners[0], corners[1], corners[2]};
    const struct vertex second[3] = {corners[0], corners[2], corners[3]};
    struct canvas canvas = {.image = image, .skip = drawing->skip};
    perspective_triangle(&canvas, first, &state->checker);
    perspective_triangle(&canvas, second, &state->checker);
    count(drawing, "pixels_written", canvas.pixels_written);
    count(drawing, "texels_fetched", canvas.texels_fetched);
    return true;
}

/* ---- The program ---- */

static bool prepare(struct drawing *drawing, size_t width, size_t height, struct error *error) {
    struct state *state = drawing->state;
    if (drawing->model == NULL) {
        return make_checker(&state->checker, error);
    }
    state->depth = malloc(width * height * sizeof *state->depth);
    if (state->depth == NULL) {
        return error_set(error, "not enough memory for a depth buffer of %zux%zu pixels", width,
                         height);
    }
    if (drawing->model->uv_count == 0) {
        return true; /* no corner says where it lies in a picture: none is read */
    }
    state->diffuse = model_texture(drawing->model, MODEL_DIFFUSE, error);
    return state->diffuse != NULL;
}

static void finish(struct drawing *drawing) {
    struct state *state = drawing->state;
    free(state->depth);
    texture_free(&state->checker);
}

int main(int argc, char **argv) {
    static const struct scene scenes[] = {
        {
            .name = "texture",
            .width = 800,
            .height = 800,
            .needs_model = true,
            .light = {0, 0, -1},
            .draw = draw_texture,
        },
        {.name = "checker", .width = 800, .height = 800, .draw = draw_checker},
    };
    static const struct program program = {
        .name = "step06_texture",
        .summary = "pictures on triangles: nearest, bilinear and mip-mapped",
        .takes_model = true,
        .takes_light = true,
        .scenes = scenes,
        .scene_count = sizeof scenes / sizeof scenes[0],
        .state_size = sizeof(struct state),
        .prepare = prepare,
        .finish = finish,
    };
    return program_main(&program, argc, argv);
}
