/*
 * Lesson 9: shaders.
 *
 * Lessons 4 to 8 repeated one loop over faces and one over pixels, and changed only what a corner
 * hands over and what a pixel makes of it. Part a writes the loops once, and passes them the two
 * functions that differ: a shader. Part b writes eight shaders. Part c writes what their pixels do
 * for the pipeline of common/pipeline.h, which draws the same pictures faster. Part d makes a
 * pipeline of part a's loops, stage by stage.
 */
#include "pipeline_program.h"

#include <string.h>

/* What is the same for all pixels of a drawing. */
struct uniforms {
    const struct model *model;
    const struct texture *diffuse, *normal_map; /* NULL where the shader reads none */
    size_t diffuse_level, normal_level;         /* mip levels */
    struct vec3 to_light;                       /* of length 1 */
};

/* ---- Part a: one draw() for all looks ---- */

/* What makes one look differ from another. Both functions get the `uniforms` of the drawing. */
struct simple_shader {
    size_t varying_count; /* numbers that a corner hands to the pixels, at most VARYING_LIMIT */
    /* Give the varyings of corner 0..2 of a face. */
    void (*vertex)(const void *uniforms, size_t face, size_t corner, double *varyings);
    /* Give red, green, blue (0..255) of a pixel from its interpolated varyings. False: the pixel is
     * discarded, as if the face had a hole there. */
    bool (*pixel)(const void *uniforms, const double *varyings, struct vec3 *rgb);
};

/* What is drawn on. */
struct canvas {
    struct image *image;
    double *depth; /* one a pixel of the image, row by row from the bottom */
};

/* A face on the screen, and what its corners hand over. */
struct placed_face {
    struct fixed2 position[3];
    double depth[3];   /* z/w, linear on the screen; larger is nearer */
    double recip_w[3]; /* 1/w */
    double varyings[3][VARYING_LIMIT];
};

/* Where the corners of a face lie on the screen. False when one of them has no place there: it is
 * not in front of the eye, or too far outside. (Lesson 8 cuts such a face. Here it is left out.) */
static bool place_face(const struct draw_call *call, size_t face, struct placed_face *placed) {
    /* BEGIN SOLUTION 9a.1 corners on the screen */
    const struct rectangle *view = &call->viewport;
    for (size_t i = 0; i < 3; i++) {
        struct vec4 clip = mat4_point(&call->to_clip, model_position(call->model, face, i));
        if (!(clip.w > 0)) {
            return false;
        }
        struct vec2 screen = {view->x + (clip.x / clip.w + 1) * view->width / 2,
                              view->y + (clip.y / clip.w + 1) * view->height / 2};
        if (!screen_snap(screen, &placed->position[i])) {
            return false;
        }
        placed->depth[i] = clip.z / clip.w;
        placed->recip_w[i] = 1 / clip.w;
    }
    return true;
    /* STARTER
    (void)call, (void)face, (void)placed;
    return false; // to do 9a.1: for each corner to_clip, then w, then the viewport, then snap
    END SOLUTION */
}

/* Colour the pixels of the viewport where the face is nearest so far, and is not discarded. */
static void draw_pixels(const struct canvas *canvas, const struct rectangle *view,
                        const struct edges *edges, const struct placed_face *placed,
                        const struct simple_shader *shader, const void *uniforms) {
    /* BEGIN SOLUTION 9a.2 the loop over pixels */
    const double *z = placed->depth;
    const double(*corner)[VARYING_LIMIT] = placed->varyings;
    struct span rows = span_overlap((struct span){edges->y_begin, edges->y_end},
                                    (struct span){view->y, view->y + view->height});
    for (int y = rows.begin; y < rows.end; y++) {
        struct span span =
            span_overlap(edges_span(edges, y), (struct span){view->x, view->x + view->width});
        double *row = canvas->depth + (size_t)y * canvas->image->width;
        for (int x = span.begin; x < span.end; x++) {
            struct vec3 on_screen = edges_weights(edges, x, y), rgb;
            double depth = interpolate_depth(on_screen, z[0], z[1], z[2]);
            if (depth > row[x]) {
                struct vec3 weight = perspective_weights(on_screen, placed->recip_w);
                double varyings[VARYING_LIMIT];
                for (size_t k = 0; k < shader->varying_count; k++) {
                    varyings[k] = interpolate(weight, corner[0][k], corner[1][k], corner[2][k]);
                }
                if (shader->pixel(uniforms, varyings, &rgb)) {
                    row[x] = depth;
                    image_set(canvas->image, x, y,
                              color_rgb(level_from(rgb.x), level_from(rgb.y), level_from(rgb.z)));
                }
            }
        }
    }
    /* STARTER
    // to do 9a.2: triangle() of lesson 8, with the varyings and the pixel function of the shader
    (void)canvas, (void)view, (void)edges, (void)placed, (void)shader, (void)uniforms;
    END SOLUTION */
}

/* Draw the model of the call as the shader says. */
static void simple_draw(const struct canvas *canvas, const struct draw_call *call,
                        const struct simple_shader *shader, const void *uniforms) {
    /* BEGIN SOLUTION 9a.3 the loop over faces */
    for (size_t face = 0; face < call->model->face_count; face++) {
        struct placed_face placed;
        struct edges edges;
        if (!place_face(call, face, &placed) ||
            !edges_setup(&edges, placed.position[0], placed.position[1], placed.position[2],
                         canvas->image->width, canvas->image->height) ||
            call->cull == (edges.clockwise ? CULL_BACK : CULL_FRONT)) {
            continue;
        }
        for (size_t i = 0; i < 3; i++) {
            shader->vertex(uniforms, face, i, placed.varyings[i]);
        }
        draw_pixels(canvas, &call->viewport, &edges, &placed, shader, uniforms);
    }
    /* STARTER
    // to do 9a.3: place each face, set up its edges, cull it or ask its corners, draw its pixels
    (void)canvas, (void)call, (void)shader, (void)uniforms, (void)place_face, (void)draw_pixels;
    END SOLUTION */
}

/* A first shader, as an example: the normals as colours. -1..1 becomes 0..255. */
static void normal_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    struct vec3 normal = vec3_normalized(model_normal(u->model, face, corner));
    varyings[0] = normal.x;
    varyings[1] = normal.y;
    varyings[2] = normal.z;
}

static bool normal_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    (void)uniforms;
    *rgb = (struct vec3){127.5 * (varyings[0] + 1), 127.5 * (varyings[1] + 1),
                         127.5 * (varyings[2] + 1)};
    return true;
}

static const struct simple_shader simple_normals = {3, normal_vertex, normal_pixel};

/* ---- Part b: eight looks ---- */

/* How much light a surface with this normal (of any length) gets: 0 when it is turned away. */
static double lambert(struct vec3 normal, struct vec3 to_light) {
    /* BEGIN SOLUTION 9b.1 light on a surface */
    double intensity = vec3_dot(vec3_normalized(normal), to_light);
    return intensity > 0 ? intensity : 0;
    /* STARTER
    (void)normal, (void)to_light;
    return 0; // to do 9b.1: normal of length 1 times to_light, but not below 0
    END SOLUTION */
}

/* Flat: one intensity for a face. */
static void flat_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    (void)corner;
    /* BEGIN SOLUTION 9b.2 flat and Gouraud */
    varyings[0] = lambert(model_face_normal(u->model, face), u->to_light);
    /* STARTER
    (void)face;
    varyings[0] = lambert((struct vec3){0, 0, 0}, u->to_light); // to do 9b.2: the face's normal
    END SOLUTION */
}

/* Gouraud: an intensity for each corner. */
static void gouraud_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    /* BEGIN SOLUTION 9b.2 flat and Gouraud */
    varyings[0] = lambert(model_normal(u->model, face, corner), u->to_light);
    /* STARTER
    (void)u, (void)face, (void)corner;
    varyings[0] = 0; // to do 9b.2: the light on the corner's own normal
    END SOLUTION */
}

static bool white_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    (void)uniforms;
    /* BEGIN SOLUTION 9b.2 flat and Gouraud */
    static const struct vec3 white = {255, 255, 255};
    *rgb = vec3_scale(white, varyings[0]);
    /* STARTER
    (void)varyings;
    *rgb = (struct vec3){0, 0, 0}; // to do 9b.2: white times the intensity
    END SOLUTION */
    return true;
}

static const struct simple_shader simple_flat = {1, flat_vertex, white_pixel};
static const struct simple_shader simple_gouraud = {1, gouraud_vertex, white_pixel};

/* The same two with the texture's colours. */
static void uv_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    /* BEGIN SOLUTION 9b.3 flat and Gouraud with the texture */
    struct vec2 uv = model_uv(u->model, face, corner);
    varyings[0] = uv.x;
    varyings[1] = uv.y;
    /* STARTER
    (void)u, (void)face, (void)corner;
    varyings[0] = varyings[1] = 0; // to do 9b.3: u and v of the corner
    END SOLUTION */
}

static void flat_textured_vertex(const void *uniforms, size_t face, size_t corner,
                                 double *varyings) {
    uv_vertex(uniforms, face, corner, varyings);
    flat_vertex(uniforms, face, corner, varyings + 2);
}

static void gouraud_textured_vertex(const void *uniforms, size_t face, size_t corner,
                                    double *varyings) {
    uv_vertex(uniforms, face, corner, varyings);
    gouraud_vertex(uniforms, face, corner, varyings + 2);
}

/* The bilinear sample of lesson 6, without its alpha. */
static struct vec3 sample(const struct texture *texture, const double *uv, size_t level) {
    struct vec4 rgba = texture_bilinear(texture, (struct vec2){uv[0], uv[1]}, level);
    return (struct vec3){rgba.x, rgba.y, rgba.z};
}

static bool textured_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    const struct uniforms *u = uniforms;
    /* BEGIN SOLUTION 9b.3 flat and Gouraud with the texture */
    *rgb = vec3_scale(sample(u->diffuse, varyings, u->diffuse_level), varyings[2]);
    /* STARTER
    (void)u, (void)varyings, (void)sample;
    *rgb = (struct vec3){0, 0, 0}; // to do 9b.3: the texture's colour times varying 2
    END SOLUTION */
    return true;
}

static const struct simple_shader simple_flat_textured = {3, flat_textured_vertex, textured_pixel};
static const struct simple_shader simple_gouraud_textured = {3, gouraud_textured_vertex,
                                                             textured_pixel};

/* Toon: Gouraud in five steps. */
static bool toon_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    (void)uniforms;
    /* BEGIN SOLUTION 9b.4 toon */
    static const struct vec3 orange = {255, 155, 0};
    double step = fmin(floor(varyings[0] * 5), 4);
    *rgb = vec3_scale(orange, step / 4);
    /* STARTER
    (void)varyings;
    *rgb = (struct vec3){0, 0, 0}; // to do 9b.4: orange in five steps
    END SOLUTION */
    return true;
}

static const struct simple_shader simple_toon = {1, gouraud_vertex, toon_pixel};

/* Normals from the normal map, pixel by pixel. */
static bool normal_map_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    const struct uniforms *u = uniforms;
    /* BEGIN SOLUTION 9b.5 normals from a picture */
    struct vec3 n = sample(u->normal_map, varyings, u->normal_level);
    struct vec3 normal = {n.x / 127.5 - 1, n.y / 127.5 - 1, n.z / 127.5 - 1};
    *rgb = vec3_scale(sample(u->diffuse, varyings, u->diffuse_level), lambert(normal, u->to_light));
    /* STARTER
    (void)u, (void)varyings;
    *rgb = (struct vec3){0, 0, 0}; // to do 9b.5: the texture's colour in the light on the normal
    END SOLUTION */
    return true;
}

static const struct simple_shader simple_normal_mapped = {2, uv_vertex, normal_map_pixel};

/* Two-sided: a face seen from behind is lit as if its normal pointed to that side. */
static void two_sided_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    const struct uniforms *u = uniforms;
    (void)corner;
    /* BEGIN SOLUTION 9b.6 two sides */
    struct vec3 normal = vec3_normalized(model_face_normal(u->model, face));
    varyings[0] = fabs(vec3_dot(normal, u->to_light));
    /* STARTER
    (void)u, (void)face;
    varyings[0] = 0; // to do 9b.6: as flat, but as bright from behind
    END SOLUTION */
}

static const struct simple_shader simple_two_sided = {1, two_sided_vertex, white_pixel};

/* Culled by the light, as in lessons 4 to 7: what gets no light is not drawn at all. */
static bool lit_only_pixel(const void *uniforms, const double *varyings, struct vec3 *rgb) {
    /* BEGIN SOLUTION 9b.7 culled by the light */
    return white_pixel(uniforms, varyings, rgb) && varyings[0] > 0;
    /* STARTER
    return white_pixel(uniforms, varyings, rgb); // to do 9b.7: discard what gets no light
    END SOLUTION */
}

static const struct simple_shader simple_lit_only = {1, flat_vertex, lit_only_pixel};

/* ---- Part c: the same looks for the pipeline ---- */

/* Red, green, blue 0..255, times an intensity, as a pixel's colour. */
static lanes_texel shade(struct lanes3 rgb, lanes intensity) {
    /* BEGIN SOLUTION 9c.1 white and textured */
    return lanes_rgb(rgb.x * intensity, rgb.y * intensity, rgb.z * intensity);
    /* STARTER
    (void)rgb, (void)intensity;
    return lanes_black(); // to do 9c.1: each channel times the intensity, through lanes_rgb()
    END SOLUTION */
}

static lanes_mask white_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    /* BEGIN SOLUTION 9c.1 white and textured */
    static const struct vec3 white = {255, 255, 255};
    *color = shade(lanes3_all(white), varyings[0]);
    /* STARTER
    static const struct vec3 black = {0, 0, 0}; // to do 9c.1: white
    *color = shade(lanes3_all(black), varyings[0]);
    END SOLUTION */
    return lanes_all_set();
}

static lanes_mask textured_fragment(const void *uniforms, const lanes *varyings,
                                    lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct lanes2 uv = {varyings[0], varyings[1]};
    /* BEGIN SOLUTION 9c.1 white and textured */
    *color = shade(texture_lanes(u->diffuse, uv, u->diffuse_level), varyings[2]);
    /* STARTER
    (void)u, (void)uv;
    *color = lanes_black(); // to do 9c.1: the texture's colour times varying 2
    END SOLUTION */
    return lanes_all_set();
}

static lanes_mask toon_fragment(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms;
    /* BEGIN SOLUTION 9c.2 toon */
    static const struct vec3 orange = {255, 155, 0};
    lanes step = lanes_min(lanes_floor(varyings[0] * 5), lanes_all(4));
    *color = shade(lanes3_all(orange), step / 4);
    /* STARTER
    (void)varyings;
    *color = lanes_black(); // to do 9c.2: orange in five steps
    END SOLUTION */
    return lanes_all_set();
}

/* lambert() for several pixels. */
static lanes lambert_lanes(struct lanes3 normal, struct vec3 to_light) {
    /* BEGIN SOLUTION 9c.3 normals from a picture */
    lanes intensity = lanes3_dot(lanes3_normalized(normal), lanes3_all(to_light));
    return lanes_max(intensity, lanes_all(0));
    /* STARTER
    (void)normal, (void)to_light;
    return lanes_all(0); // to do 9c.3: as lambert()
    END SOLUTION */
}

static lanes_mask normal_map_fragment(const void *uniforms, const lanes *varyings,
                                      lanes_texel *color) {
    const struct uniforms *u = uniforms;
    struct lanes2 uv = {varyings[0], varyings[1]};
    /* BEGIN SOLUTION 9c.3 normals from a picture */
    struct lanes3 n = texture_lanes(u->normal_map, uv, u->normal_level);
    struct lanes3 normal = {n.x / 127.5f - 1, n.y / 127.5f - 1, n.z / 127.5f - 1};
    lanes intensity = lambert_lanes(normal, u->to_light);
    *color = shade(texture_lanes(u->diffuse, uv, u->diffuse_level), intensity);
    /* STARTER
    (void)uv;
    struct lanes3 normal = {lanes_all(0), lanes_all(0), lanes_all(1)}; // to do 9c.3: the map's
    *color = shade(normal, lambert_lanes(normal, u->to_light)); // to do 9c.3: the texture's colour
    END SOLUTION */
    return lanes_all_set();
}

/* Where the mask that it returns is not set, the pixel is discarded. */
static lanes_mask lit_only_fragment(const void *uniforms, const lanes *varyings,
                                    lanes_texel *color) {
    /* BEGIN SOLUTION 9c.4 culled by the light */
    return white_fragment(uniforms, varyings, color) & (varyings[0] > 0);
    /* STARTER
    // to do 9c.4: discard what gets no light
    return white_fragment(uniforms, varyings, color);
    END SOLUTION */
}

/* Where all corners of a face give the same varyings, .flat asks corner 0 alone. */
SHADER(flat, .varying_count = 1, .flat = true, .vertex = flat_vertex, .fragment = white_fragment);
SHADER(gouraud, .varying_count = 1, .vertex = gouraud_vertex, .fragment = white_fragment);
SHADER(flat_textured, .varying_count = 3, .vertex = flat_textured_vertex,
       .fragment = textured_fragment);
SHADER(gouraud_textured, .varying_count = 3, .vertex = gouraud_textured_vertex,
       .fragment = textured_fragment);
SHADER(toon, .varying_count = 1, .vertex = gouraud_vertex, .fragment = toon_fragment);
SHADER(normal_mapped, .varying_count = 2, .vertex = uv_vertex, .fragment = normal_map_fragment);
SHADER(two_sided, .varying_count = 1, .flat = true, .vertex = two_sided_vertex,
       .fragment = white_fragment);
SHADER(culled_by_light, .varying_count = 1, .flat = true, .vertex = flat_vertex,
       .fragment = lit_only_fragment, .discards = true);

/* ---- Part d: a pipeline of your own ---- */

/* A face that may be seen. */
struct kept_face {
    size_t face; /* of the model */
    bool asked;  /* its corners, for their varyings */
    struct placed_face placed;
    struct edges edges;
};

/* Some rows of the picture, and what each of their pixels shows so far. */
struct band {
    struct span rows;  /* of the picture */
    size_t width;      /* of a row */
    double *depth;     /* one a pixel, the band's lowest row first */
    uint32_t *nearest; /* one a pixel: 1 + the index of the nearest kept face; 0: none */
};

/* Nothing is drawn yet in these rows. */
static void band_clear(const struct band *band) {
    const size_t pixels = (size_t)(band->rows.end - band->rows.begin) * band->width;
    depth_clear(band->depth, pixels);
    memset(band->nearest, 0, pixels * sizeof *band->nearest);
}

/* Keep the faces of a call that may be seen; its viewport is the whole image. Returns how many. */
static size_t keep_faces(const struct canvas *canvas, const struct draw_call *call,
                         struct kept_face *kept) {
    size_t count = 0;
    /* BEGIN SOLUTION 9d.1 faces that may be seen */
    for (size_t i = 0; i < call->model->face_count; i++) {
        struct kept_face *k = &kept[count];
        const struct fixed2 *corner = k->placed.position;
        k->face = i;
        k->asked = false;
        if (place_face(call, i, &k->placed) &&
            edges_setup(&k->edges, corner[0], corner[1], corner[2], canvas->image->width,
                        canvas->image->height) &&
            call->cull != (k->edges.clockwise ? CULL_BACK : CULL_FRONT)) {
            count++;
        }
    }
    /* STARTER
    (void)canvas, (void)call, (void)kept; // to do 9d.1: the first half of simple_draw()
    END SOLUTION */
    return count;
}

/* Where the face is nearest so far, keep its depth and its number: pixels of the band only. */
static void cover_face(const struct band *band, const struct kept_face *kept, uint32_t number) {
    /* BEGIN SOLUTION 9d.2 what is nearest */
    const double *z = kept->placed.depth;
    struct span rows =
        span_overlap((struct span){kept->edges.y_begin, kept->edges.y_end}, band->rows);
    for (int y = rows.begin; y < rows.end; y++) {
        struct span span = edges_span(&kept->edges, y);
        size_t row = (size_t)(y - band->rows.begin) * band->width;
        for (int x = span.begin; x < span.end; x++) {
            double depth = interpolate_depth(edges_weights(&kept->edges, x, y), z[0], z[1], z[2]);
            if (depth > band->depth[row + (size_t)x]) {
                band->depth[row + (size_t)x] = depth;
                band->nearest[row + (size_t)x] = number;
            }
        }
    }
    /* STARTER
    (void)band, (void)kept, (void)number; // to do 9d.2: draw_pixels(), but keep the number only
    END SOLUTION */
}

/* Colour each pixel of the band once, by the face that is nearest there. */
static void shade_band(const struct canvas *canvas, const struct band *band, struct kept_face *kept,
                       const struct simple_shader *shader, const void *uniforms) {
    /* BEGIN SOLUTION 9d.3 each visible pixel once */
    for (int y = band->rows.begin; y < band->rows.end; y++) {
        const uint32_t *nearest = band->nearest + (size_t)(y - band->rows.begin) * band->width;
        for (int x = 0; x < (int)band->width; x++) {
            if (nearest[x] == 0) {
                continue;
            }
            struct kept_face *k = &kept[nearest[x] - 1];
            double(*corner)[VARYING_LIMIT] = k->placed.varyings;
            for (size_t i = 0; !k->asked && i < 3; i++) {
                shader->vertex(uniforms, k->face, i, corner[i]);
            }
            k->asked = true;
            struct vec3 rgb,
                weight = perspective_weights(edges_weights(&k->edges, x, y), k->placed.recip_w);
            double varyings[VARYING_LIMIT];
            for (size_t i = 0; i < shader->varying_count; i++) {
                varyings[i] = interpolate(weight, corner[0][i], corner[1][i], corner[2][i]);
            }
            if (shader->pixel(uniforms, varyings, &rgb)) {
                image_set(canvas->image, x, y,
                          color_rgb(level_from(rgb.x), level_from(rgb.y), level_from(rgb.z)));
            }
        }
    }
    /* STARTER
    // to do 9d.3: for each pixel that shows a face its varyings, then the shader's pixel function
    (void)canvas, (void)band, (void)kept, (void)shader, (void)uniforms;
    END SOLUTION */
}

/* Draw the kept faces, the first of `count` at kept[0]. `band` has room for the whole picture, and
 * its rows say how high a band should be. */
static void visible_draw(const struct canvas *canvas, struct band band, struct kept_face *kept,
                         uint32_t count, const struct simple_shader *shader, const void *uniforms) {
    const int height = (int)canvas->image->height;
    /* BEGIN SOLUTION 9d.4 bands */
    const int step = band.rows.end - band.rows.begin;
    for (int y = 0; y < height; y += step) {
        band.rows = (struct span){y, y + step < height ? y + step : height};
        band_clear(&band);
        for (uint32_t i = 0; i < count; i++) {
            cover_face(&band, &kept[i], i + 1);
        }
        shade_band(canvas, &band, kept, shader, uniforms);
    }
    /* STARTER
    band.rows = (struct span){0, height}; // to do 9d.4: this is one band; do it band by band
    band_clear(&band);
    for (uint32_t i = 0; i < count; i++) {
        cover_face(&band, &kept[i], i + 1);
    }
    shade_band(canvas, &band, kept, shader, uniforms);
    END SOLUTION */
}

#include "scenes.h"

int main(int argc, char **argv) {
    return program_main(&step09_shaders, argc, argv);
}
