/* Scenes as triangles for OpenGL: see picture.h. */
#include "picture.h"

#include "base/array.h"
#include "context.h"

#include <stdlib.h>
#include <string.h>

/* ---- Faces that are cut ---- */

/* A corner before it is placed: x, y, z, w in clip space, the position in the model, varyings. All
 * are linear along an edge. */
enum { PLAIN = 4, VARYING = 7, NUMBERS = VARYING + VARYINGS };

/* Cut as the course does: what is nearer than NEAR_W, and what is outside NDC -64..64. Each of the
 * five planes adds half as many corners at most, however the numbers are rounded. */
enum { PLANES = 5, CORNERS = 19 };
static const double guard_band = 64;

/* Positive inside of a plane, and 0 on it. */
static double plane_distance(const double *p, int plane) {
    const double bound = guard_band * p[3];
    const double distances[PLANES] = {p[3] - NEAR_W, bound + p[0], bound - p[0], bound + p[1],
                                      bound - p[1]};
    return distances[plane];
}

/* Where an edge crosses the plane, from its inner corner: so both faces of the edge find the same
 * point. */
static void cross_plane(const double *inside, const double *outside, int plane, double *cut) {
    double distance = plane_distance(inside, plane);
    double part = distance / (distance - plane_distance(outside, plane));
    for (int i = 0; i < NUMBERS; i++) {
        cut[i] = inside[i] + part * (outside[i] - inside[i]);
    }
}

/* Cut a polygon; returns how many corners are left. */
static size_t cut_at_plane(double corners[CORNERS][NUMBERS], size_t count, int plane) {
    double from[CORNERS][NUMBERS];
    size_t kept = 0;
    memcpy(from, corners, count * sizeof *from);
    for (size_t i = 0; i < count; i++) {
        const double *a = from[i], *b = from[(i + 1) % count];
        bool a_inside = plane_distance(a, plane) >= 0, b_inside = plane_distance(b, plane) >= 0;
        if (a_inside) {
            memcpy(corners[kept++], a, sizeof *from);
        }
        if (a_inside != b_inside) {
            cross_plane(a_inside ? a : b, a_inside ? b : a, plane, corners[kept++]);
        }
    }
    return kept;
}

/* ---- Corners ---- */

static void to_floats(float *floats, const double *numbers, int count) {
    for (int i = 0; i < count; i++) {
        floats[i] = (float)numbers[i];
    }
}

/* Divide by w and snap. The snapped position lands there when OpenGL divides and goes back to
 * pixels in float, which rounds far less than 1/512 pixel near the picture. */
static bool make_corner(const struct picture *picture, const struct rectangle *viewport,
                        const double *numbers, struct gl_corner *corner) {
    const double recip_w = 1 / numbers[3], depth = numbers[2] * recip_w;
    const double w = (double)(float)(1 / recip_w), half = SNAPPED_VIEWPORT / 2.0;
    struct vec2 screen = {viewport->x + (numbers[0] * recip_w + 1) * (viewport->width / 2.0),
                          viewport->y + (numbers[1] * recip_w + 1) * (viewport->height / 2.0)};
    *corner = (struct gl_corner){
        .plain = {0, 0, 0, 1}, .face = (float)picture->face_count, .depth = depth};
    if (!screen_snap(screen, &corner->screen)) {
        return error_set(picture->error, "a face is too far off the picture");
    }
    double x = (double)corner->screen.x / SUBPIXELS - (double)(picture->width / 2);
    double y = (double)corner->screen.y / SUBPIXELS - (double)(picture->height / 2);
    to_floats(corner->plain, numbers + PLAIN, 3);
    to_floats(corner->snapped, (double[]){x / half * w, y / half * w, depth * w, w}, 4);
    to_floats(corner->varyings, numbers + VARYING, VARYINGS);
    return true;
}

/* What cutting leaves of a face, as a fan of triangles around its first corner. */
static bool add_face(struct picture *picture, const struct gl_part *part,
                     double numbers[CORNERS][NUMBERS]) {
    struct gl_corner corners[CORNERS];
    size_t count = 3;
    for (int plane = 0; plane < (part->not_cut ? 0 : PLANES); plane++) {
        count = cut_at_plane(numbers, count, plane);
    }
    for (size_t i = 0; i < count; i++) {
        if (!make_corner(picture, &part->viewport, numbers[i], &corners[i])) {
            return false;
        }
    }
    struct gl_corner *grown = array_reserve(picture->corners, &picture->corner_capacity,
                                            picture->corner_count + 3 * count, sizeof *grown);
    if (grown == NULL) {
        return error_out_of_memory(picture->error);
    }
    picture->corners = grown;
    for (size_t i = 2; i < count; i++) {
        grown[picture->corner_count++] = corners[0];
        grown[picture->corner_count++] = corners[i - 1];
        grown[picture->corner_count++] = corners[i];
    }
    return true;
}

bool picture_add(struct picture *picture, const struct gl_part *part, size_t face_count,
                 corner_function *corner, const void *given) {
    struct gl_part *grown = array_reserve(picture->parts, &picture->part_capacity,
                                          picture->part_count + 1, sizeof *grown);
    if (grown == NULL) {
        return error_out_of_memory(picture->error);
    }
    picture->parts = grown;
    struct gl_part *added = &grown[picture->part_count++];
    *added = *part;
    added->first = picture->corner_count;
    for (size_t face = 0; face < face_count; face++) {
        double numbers[CORNERS][NUMBERS] = {{0}};
        bool drawn = true;
        for (size_t i = 0; i < 3; i++) {
            struct corner_data data = {0};
            drawn = corner(given, face, i, &data) && drawn;
            struct vec3 p = data.position;
            struct vec4 clip = mat4_point(&part->to_clip, p);
            memcpy(numbers[i], (double[]){clip.x, clip.y, clip.z, clip.w, p.x, p.y, p.z},
                   VARYING * sizeof **numbers);
            memcpy(numbers[i] + VARYING, data.varyings, sizeof data.varyings);
        }
        picture->face_count++;
        if (drawn && !add_face(picture, added, numbers)) {
            return false;
        }
    }
    added->count = picture->corner_count - added->first;
    return true;
}

void picture_free(struct picture *picture) {
    free(picture->parts);
    free(picture->corners);
    *picture = (struct picture){0};
}

/* ---- What several lessons need ---- */

struct rectangle whole_picture(const struct picture *picture) {
    return (struct rectangle){0, 0, (int)picture->width, (int)picture->height};
}

struct mat4 parallel_clip(struct mat4 to_clip) {
    for (int column = 0; column < 4; column++) {
        to_clip.m[2][column] = to_clip.m[2][column] / 4 + to_clip.m[3][column] / 2;
    }
    return to_clip;
}

static bool lit_corner(const void *given, size_t face, size_t corner, struct corner_data *to) {
    const struct drawing *drawing = given;
    const struct model *model = drawing->model;
    double intensity = model_face_intensity(model, face, vec3_normalized(drawing->light));
    struct vec2 uv = model_uv(model, face, corner);
    *to = (struct corner_data){model_position(model, face, corner), {intensity, uv.x, uv.y}};
    return intensity > 0;
}

bool picture_add_lit_faces(struct picture *picture, struct gl_part part) {
    const struct drawing *drawing = picture->drawing;
    part.viewport = whole_picture(picture);
    part.to_clip = parallel_clip(mat4_identity());
    return picture_add(picture, &part, drawing->model->face_count, lit_corner, drawing);
}
