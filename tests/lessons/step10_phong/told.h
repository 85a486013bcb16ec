/*
 * Lesson 10 under the mouse: what is said of the light at a pixel. It contains answers of its
 * tasks, so that no hand-out has it.
 */

/* The weights of a face's corners at the probed pixel, where it covers that and is nearer than
 * `depth`, which becomes its own. */
static bool told_face(const struct drawing *drawing, const struct image *image,
                      const struct draw_call *call, size_t face, double *depth,
                      struct vec3 *weight) {
    struct fixed2 p[3];
    double z[3], recip_w[3];
    struct edges edges;
    for (size_t i = 0; i < 3; i++) {
        const struct vec4 c = mat4_point(&call->to_clip, model_position(call->model, face, i));
        const struct rectangle *view = &call->viewport;
        if (!(c.w > 0) || !screen_snap((struct vec2){view->x + (c.x / c.w + 1) * view->width / 2,
                                                     view->y + (c.y / c.w + 1) * view->height / 2},
                                       &p[i])) {
            return false;
        }
        z[i] = c.z / c.w;
        recip_w[i] = 1 / c.w;
    }
    if (!edges_setup(&edges, p[0], p[1], p[2], image->width, image->height) || edges.clockwise ||
        !edges_cover(&edges, drawing->probe.x, drawing->probe.y)) {
        return false;
    }
    const struct vec3 w = edges_weights(&edges, drawing->probe.x, drawing->probe.y);
    const double there = interpolate(w, z[0], z[1], z[2]);
    if (!(there > *depth)) {
        return false;
    }
    *depth = there;
    *weight = perspective_weights(w, recip_w);
    return true;
}

/* The vectors of Phong's light at the probed pixel, with the normals of the corners. */
static void told_note(struct drawing *drawing, const struct image *image,
                      const struct draw_call *call, const struct uniforms *u) {
    const struct model *m = call->model;
    struct vec3 w, n = {0, 0, 0}, place = {0, 0, 0};
    double depth = -INFINITY;
    for (size_t face = 0; drawing->probed && face < m->face_count; face++) {
        if (told_face(drawing, image, call, face, &depth, &w)) {
            n = vec3_normalized(vec3_interpolate(
                w, model_normal(m, face, 0), model_normal(m, face, 1), model_normal(m, face, 2)));
            place = vec3_interpolate(w, model_position(m, face, 0), model_position(m, face, 1),
                                     model_position(m, face, 2));
        }
    }
    if (depth > -INFINITY) {
        const struct vec3 l = u->to_light, v = vec3_normalized(vec3_sub(drawing->eye, place));
        const struct vec3 r = vec3_sub(vec3_scale(n, 2 * vec3_dot(n, l)), l);
        drawing_note(drawing, "n %+.3f %+.3f %+.3f", n.x, n.y, n.z);
        drawing_note(drawing, "l %+.3f %+.3f %+.3f   n.l %+.3f", l.x, l.y, l.z, vec3_dot(n, l));
        drawing_note(drawing, "r %+.3f %+.3f %+.3f", r.x, r.y, r.z);
        drawing_note(drawing, "v %+.3f %+.3f %+.3f   r.v %+.3f, to the power of %d: %.3f", v.x, v.y,
                     v.z, vec3_dot(r, v), u->material.power,
                     pow(fmax(vec3_dot(r, v), 0), u->material.power));
    }
}
