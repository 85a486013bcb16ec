/* Where a model lies, and moving it into view: see fit.h. */
#include "files/fit.h"

#include <string.h>

/* At 1 the outermost lines would lie on the edge of the image. */
static const double reach_in_parallel_view = 0.95;

/* A ball of radius r around the point that the camera looks at, at distance d, appears as large as
 * r / sqrt(1 - (r / d)^2): 0.97 for 7/8 at the distance 2. */
static const double reach_all_around = 0.875;

/* Position `i` of those that faces name, three for each, and then lines; NULL behind the last. */
static const struct vec3 *named_position(const struct model *model, size_t i) {
    const size_t corners = 3 * model->face_count;
    const size_t end = i < corners ? 0 : i - corners;
    return i < corners ? &model->positions[model->faces[i / 3].corner[i % 3].position]
           : end < 2 * model->line_count ? &model->positions[model->lines[end / 2][end % 2]]
                                         : NULL;
}

struct box3 model_box(const struct model *model) {
    const double far = INFINITY;
    struct box3 box = {{far, far, far}, {-far, -far, -far}};
    const struct vec3 *p;
    for (size_t i = 0; (p = named_position(model, i)) != NULL; i++) {
        struct vec3 a = box.least, b = box.greatest;
        box = (struct box3){{fmin(a.x, p->x), fmin(a.y, p->y), fmin(a.z, p->z)},
                            {fmax(b.x, p->x), fmax(b.y, p->y), fmax(b.z, p->z)}};
    }
    return box;
}

bool box_reaches_out(struct box3 box) {
    struct vec3 a = box.least, b = box.greatest;
    return a.x < -1 || a.y < -1 || a.z < -1 || b.x > 1 || b.y > 1 || b.z > 1;
}

static double longest_side(struct box3 box) {
    struct vec3 sides = vec3_sub(box.greatest, box.least);
    return fmax(sides.x, fmax(sides.y, sides.z));
}

bool box_is_tiny(struct box3 box) {
    return longest_side(box) < 0.4;
}

struct vec3 vec3_quarter_turned(struct vec3 v, const int turns[3]) {
    for (int i = turns[0] & 3; i > 0; i--) {
        v = (struct vec3){v.x, -v.z, v.y};
    }
    for (int i = turns[1] & 3; i > 0; i--) {
        v = (struct vec3){v.z, v.y, -v.x};
    }
    for (int i = turns[2] & 3; i > 0; i--) {
        v = (struct vec3){-v.y, v.x, v.z};
    }
    return v;
}

void model_turn(struct model *model, const int turns[3]) {
    for (size_t i = 0; i < model->position_count; i++) {
        model->positions[i] = vec3_quarter_turned(model->positions[i], turns);
    }
    for (size_t i = 0; i < model->normal_count; i++) {
        float *n = model->normals[i];
        struct vec3 turned = vec3_quarter_turned((struct vec3){n[0], n[1], n[2]}, turns);
        n[0] = (float)turned.x;
        n[1] = (float)turned.y;
        n[2] = (float)turned.z;
    }
    memcpy(model->turns, turns, sizeof model->turns);
}

static double distance_from_origin(const struct model *model) {
    double farthest = 0;
    const struct vec3 *p;
    for (size_t i = 0; (p = named_position(model, i)) != NULL; i++) {
        farthest = fmax(farthest, vec3_length(*p));
    }
    return farthest;
}

void model_fit(struct model *model, bool all_around) {
    struct box3 box = model_box(model);
    struct vec3 middle = vec3_scale(vec3_add(box.least, box.greatest), 0.5);
    double side = longest_side(box), half = side > 0 ? side / 2 : 1;
    for (size_t i = 0; i < model->position_count; i++) {
        struct vec3 p = vec3_sub(model->positions[i], middle);
        model->positions[i] = (struct vec3){p.x / half, p.y / half, p.z / half};
    }
    double reach = all_around ? distance_from_origin(model) : 1;
    double scale = (all_around ? reach_all_around : reach_in_parallel_view) / fmax(reach, 1);
    for (size_t i = 0; i < model->position_count; i++) {
        model->positions[i] = vec3_scale(model->positions[i], scale);
    }
}
