/* The exact picture: see exact.h. */
#include "exact.h"

#include "bench/memory.h"
#include "oracle/oracle.h"
#include "oracle/reals.h"
#include "oracle/texels.h"

#include <math.h>
#include <stdlib.h>

/* ---- What is seen ---- */

static bool place(struct exact *exact, size_t position, struct error *error) {
    const struct draw_call *call = &exact->scene->call;
    const struct rectangle *r = &call->viewport;
    struct vec4 clip = mat4_point(&call->to_clip, call->model->positions[position]);
    double recip_w = 1 / clip.w;
    struct vec2 screen = {r->x + (clip.x * recip_w + 1) * (r->width / 2.0),
                          r->y + (clip.y * recip_w + 1) * (r->height / 2.0)};
    exact->recip_w[position] = recip_w;
    if (!(clip.w > 0.01 && fabs(clip.x) <= 32 * clip.w && fabs(clip.y) <= 32 * clip.w)) {
        return error_set(error, "the model reaches the eye; its corners should lie in -1..1");
    }
    return screen_snap(screen, &exact->screen[position]);
}

/* The weights of a triangle's corners in space at the centre of a pixel. */
struct weights {
    long double corner[3];
};

static struct weights weights_at(const struct fixed2 screen[3], const double recip_w[3], int x,
                                 int y) {
    struct weights weights;
    for (int i = 0; i < 3; i++) {
        const double one[3] = {i == 0, i == 1, i == 2};
        weights.corner[i] = oracle_interpolate(screen, recip_w, one, x, y);
    }
    return weights;
}

/* 1/w there, which is linear on the screen. */
static double depth_at(const struct fixed2 screen[3], const double recip_w[3], int x, int y) {
    static const double flat[3] = {1, 1, 1};
    return (double)oracle_interpolate(screen, flat, recip_w, x, y);
}

static void find_corners(const struct exact *exact, size_t face, struct fixed2 screen[3],
                         double recip_w[3]) {
    const struct corner *corner = exact->scene->call.model->faces[face].corner;
    for (int i = 0; i < 3; i++) {
        screen[i] = exact->screen[corner[i].position];
        recip_w[i] = exact->recip_w[corner[i].position];
    }
}

static struct span overlap_of(int32_t a, int32_t b, int32_t c, int begin, int end) {
    return span_overlap(centers_between(least_of(a, b, c), most_of(a, b, c), (size_t)end),
                        (struct span){begin, end});
}

static void cover_face(struct exact *exact, size_t face) {
    const struct rectangle *r = &exact->scene->call.viewport;
    struct fixed2 p[3];
    double recip_w[3];
    find_corners(exact, face, p, recip_w);
    if (oracle_turn(p[0], p[1], p[2]) <= 0) {
        return; /* turned away */
    }
    struct span columns = overlap_of(p[0].x, p[1].x, p[2].x, r->x, r->x + r->width);
    struct span rows = overlap_of(p[0].y, p[1].y, p[2].y, r->y, r->y + r->height);
    for (int y = rows.begin; y < rows.end; y++) {
        for (int x = columns.begin; x < columns.end; x++) {
            size_t pixel = (size_t)y * exact->scene->width + (size_t)x;
            if (!oracle_covers(p[0], p[1], p[2], x, y)) {
                continue;
            }
            double depth = depth_at(p, recip_w, x, y);
            if (depth > exact->depths[pixel]) {
                exact->visible += exact->faces[pixel] == 0;
                exact->depths[pixel] = depth;
                exact->faces[pixel] = (uint32_t)face + 1;
            }
        }
    }
}

bool exact_begin(struct exact *exact, const struct frame_scene *scene, struct error *error) {
    const struct model *model = scene->call.model;
    size_t pixels = scene->width * scene->height;
    *exact = (struct exact){
        .scene = scene,
        .screen = bench_memory(model->position_count, sizeof *exact->screen),
        .recip_w = bench_memory(model->position_count, sizeof *exact->recip_w),
        .faces = bench_memory(pixels, sizeof *exact->faces),
        .depths = bench_memory(pixels, sizeof *exact->depths),
    };
    bool done = true;
    for (size_t i = 0; done && i < model->position_count; i++) {
        done = place(exact, i, error);
    }
    for (size_t i = 0; done && i < model->face_count; i++) {
        cover_face(exact, i);
    }
    return done;
}

void exact_end(struct exact *exact) {
    free(exact->screen);
    free(exact->recip_w);
    free(exact->faces);
    free(exact->depths);
    *exact = (struct exact){0};
}

/* ---- Light ---- */

static struct real3 sample(const struct frame_scene *scene, enum model_texture_kind kind,
                           const long double uv[2]) {
    const struct frame_texture *from = &scene->textures[kind];
    return real3_bilinear(&from->texture->level[from->level], uv[0], uv[1]);
}

static long double light_on(const struct frame_scene *scene, const float normal[3]) {
    struct real3 n = {normal[0], normal[1], normal[2]};
    long double light = real3_dot(n, real3_from(scene->to_light));
    return light > 0 ? light : 0;
}

static void find_uv(const struct model *model, size_t face, const struct weights *weights,
                    long double uv[2]) {
    uv[0] = uv[1] = 0;
    for (size_t i = 0; i < 3; i++) {
        struct vec2 corner = model_uv(model, face, i);
        uv[0] += weights->corner[i] * corner.x;
        uv[1] += weights->corner[i] * corner.y;
    }
}

static struct real3 gouraud(const struct frame_scene *scene, size_t face,
                            const struct weights *weights) {
    const struct model *model = scene->call.model;
    long double uv[2], light = 0;
    find_uv(model, face, weights, uv);
    for (int i = 0; i < 3; i++) {
        light += weights->corner[i] *
                 light_on(scene, model->normals[model->faces[face].corner[i].normal]);
    }
    return real3_scale(sample(scene, MODEL_DIFFUSE, uv), light);
}

static struct real3 phong(const struct frame_scene *scene, size_t face,
                          const struct weights *weights) {
    const struct model *model = scene->call.model;
    const struct real3 to_light = real3_from(scene->to_light), ones = {1, 1, 1};
    struct real3 position = {0, 0, 0};
    long double uv[2];
    find_uv(model, face, weights, uv);
    for (size_t i = 0; i < 3; i++) {
        position =
            real3_add(position, real3_from(model_position(model, face, i)), weights->corner[i]);
    }
    struct real3 map = real3_scale(sample(scene, MODEL_NORMAL_MAP, uv), 1 / 127.5L);
    struct real3 normal = real3_unit(real3_sub(map, ones));
    struct real3 to_eye = real3_unit(real3_sub(real3_from(scene->eye), position));
    long double light = real3_dot(normal, to_light);
    long double near = 2 * light * real3_dot(normal, to_eye) - real3_dot(to_light, to_eye);
    long double shine = light > 0 && near > 0 ? powl(near, 10) : 0;
    struct real3 rgb = sample(scene, MODEL_DIFFUSE, uv);
    long double weight = sample(scene, MODEL_SPECULAR, uv).x;
    rgb = real3_scale(rgb, (long double)AMBIENT + (light > 0 ? light : 0));
    return real3_add(rgb, ones, shine * weight);
}

/* Red, green, blue in levels, not rounded. */
static struct real3 exact_color(const struct exact *exact, size_t face, int x, int y) {
    struct fixed2 screen[3];
    double recip_w[3];
    find_corners(exact, face, screen, recip_w);
    struct weights weights = weights_at(screen, recip_w, x, y);
    switch (exact->scene->look) {
    case FRAME_FLAT: {
        long double level = 255 * light_on(exact->scene, exact->scene->head->face_normals[face]);
        return (struct real3){level, level, level};
    }
    case FRAME_GOURAUD:
        return gouraud(exact->scene, face, &weights);
    default:
        return phong(exact->scene, face, &weights);
    }
}

/* ---- Comparing ---- */

static void compare_pixel(struct real3 exact, const uint8_t *bgra, struct deviation *d) {
    const long double values[3] = {real_clamped(exact.z, 255), real_clamped(exact.y, 255),
                                   real_clamped(exact.x, 255)};
    bool rounded = false;
    d->compared++;
    for (int i = 0; i < 3; i++) {
        double distance = (double)fabsl(bgra[i] - values[i]) - 0.5;
        rounded = rounded || distance > 0;
        d->beyond = distance > d->beyond ? distance : d->beyond;
        d->mean += fabs(bgra[i] - (double)floorl(values[i] + 0.5L));
    }
    d->rounded += rounded;
}

void exact_compare(const struct exact *exact, const uint8_t *const *pictures, size_t count,
                   struct deviation *deviations) {
    size_t width = exact->scene->width, pixels = width * exact->scene->height;
    for (size_t k = 0; k < count; k++) {
        deviations[k] = (struct deviation){0};
    }
    for (size_t i = 0; i < pixels; i++) {
        struct real3 color = {0, 0, 0};
        if (exact->faces[i] > 0) {
            color = exact_color(exact, exact->faces[i] - 1, (int)(i % width), (int)(i / width));
        }
        for (size_t k = 0; k < count; k++) {
            const uint8_t *pixel = pictures[k] + 4 * i;
            bool drawn = pixel[3] != 0, visible = exact->faces[i] > 0;
            deviations[k].outline += drawn != visible;
            if (drawn && visible) {
                compare_pixel(color, pixel, &deviations[k]);
            }
        }
    }
    for (size_t k = 0; k < count; k++) {
        deviations[k].mean /= 3 * (double)(deviations[k].compared + (deviations[k].compared == 0));
    }
}
