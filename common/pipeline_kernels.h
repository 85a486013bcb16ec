/*
 * Private to the pipeline: the loops over pixels, in a header because SHADER() compiles them anew
 * for every shader. pipeline.h includes it at its end; nothing else does.
 */
#ifndef COMMON_PIPELINE_KERNELS_H
#define COMMON_PIPELINE_KERNELS_H

#ifndef COMMON_PIPELINE_H
#error "include pipeline.h instead"
#endif

/* A triangle on the screen: a face of the model, or a part that clipping left of one. */
struct piece {
    struct edges edges;
    double depth[3];   /* z/w at the corners, linear on the screen */
    double recip_w[3]; /* 1/w at the corners */
    uint32_t face;
    uint32_t first_corner; /* of the face: corner i of the piece is (first_corner + i) % 3 */
    uint32_t clipped;      /* which entry of `clipped` it has; NOT_CLIPPED for a whole face */
    uint32_t attributes;   /* which entry of `attributes` it has, once it is known to be visible */
    bool dropped;          /* covers pixels but must not be drawn (culled, with skip off) */
};

#define NOT_CLIPPED UINT32_MAX

/* Corners of a clipped piece as weights of its face's corners (counted from first_corner). */
struct clipped_corners {
    struct vec3 weight[3];
};

/* The kernels below call a shader that is a constant where they are used. Only when they are
 * inlined there can the compiler inline the shader into them in turn. */
#if defined(__GNUC__)
#define KERNEL static inline __attribute__((always_inline))
#else
#define KERNEL static inline
#endif

/* The rows of a band that a piece may cover. */
static inline struct span rows_in_band(const struct piece *piece, struct span band) {
    const struct edges *e = &piece->edges;
    return span_overlap((struct span){e->y_begin, e->y_end}, band);
}

/* The covered pixels of a row that lie in the viewport. */
static inline struct span span_in_viewport(const struct pipeline *pipeline,
                                           const struct piece *piece, int y) {
    int left = pipeline->viewport.x, right = left + pipeline->viewport.width;
    return span_overlap(edges_span(&piece->edges, y), (struct span){left, right});
}

/* Depth along a row of a piece: begin + step * (x - the span's first pixel). */
struct depth_row {
    double begin, step;
};

static inline struct depth_row depth_along_row(const struct piece *piece, int x, int y) {
    const struct edge *e = piece->edges.edge;
    double scale = 1 / (double)piece->edges.area;
    struct vec3 weight = edges_weights(&piece->edges, x, y);
    const double *z = piece->depth;
    return (struct depth_row){
        .begin = interpolate_depth(weight, z[0], z[1], z[2]),
        .step = (double)e[1].dx * scale * (z[1] - z[0]) + (double)e[2].dx * scale * (z[2] - z[0]),
    };
}

/* The varyings of the corners of a piece, those of corner i at varyings[i * varying_count]. */
KERNEL void fetch_attributes(const struct pipeline *pipeline, const struct piece *piece,
                             const struct shader *shader, const void *uniforms, double *varyings) {
    size_t n = shader->varying_count;
    for (size_t corner = 0; corner < 3; corner++) {
        size_t face_corner = (piece->first_corner + corner) % 3;
        shader->vertex(uniforms, piece->face, face_corner, varyings + corner * n);
    }
    if (piece->clipped == NOT_CLIPPED) {
        return;
    }
    const struct vec3 *weight = pipeline->clipped[piece->clipped].weight;
    for (size_t i = 0; i < n; i++) {
        double a = varyings[i], b = varyings[n + i], c = varyings[2 * n + i];
        for (size_t corner = 0; corner < 3; corner++) {
            varyings[corner * n + i] = interpolate(weight[corner], a, b, c);
        }
    }
}

/* Shade a run of pixels of row y, all of one piece. With `depths`, those of the row, only where the
 * piece is nearer than the depth there, which then becomes its own. Returns how many. */
KERNEL uint64_t shade_run(const struct piece *piece, const double *corners,
                          const struct shader *shader, const void *uniforms, struct image *image,
                          struct span run, int y, double *depths) {
    const struct edge *e = piece->edges.edge;
    size_t n = shader->varying_count;
    struct depth_row depth = depth_along_row(piece, run.begin, y);
    uint8_t *pixel = image->pixels + ((size_t)y * image->width + (size_t)run.begin) * image->format;
    uint64_t shaded = 0;
    for (int x = run.begin; x < run.end; x++, pixel += image->format) {
        double z = depth.begin + depth.step * (x - run.begin);
        if (depths != NULL && !(z > depths[x])) {
            continue;
        }
        /* Exact edge values: the weights on the screen times the area. */
        struct vec3 screen = {(double)(e[0].origin + e[0].dx * x + e[0].dy * y),
                              (double)(e[1].origin + e[1].dx * x + e[1].dy * y),
                              (double)(e[2].origin + e[2].dx * x + e[2].dy * y)};
        struct vec3 weight = perspective_weights(screen, piece->recip_w);
        double varyings[VARYING_LIMIT];
        for (size_t i = 0; i < n; i++) {
            varyings[i] = interpolate(weight, corners[i], corners[n + i], corners[2 * n + i]);
        }
        struct color color;
        shaded++;
        if (!shader->fragment(uniforms, varyings, &color)) {
            continue;
        }
        if (depths != NULL) {
            depths[x] = z;
        }
        pixel[0] = color.b;
        pixel[1] = color.g;
        pixel[2] = color.r;
        if (image->format == IMAGE_BGRA) {
            pixel[3] = color.a;
        }
    }
    return shaded;
}

/* Pass 2 for a band of rows: find the runs of equal number and shade those of this draw call. */
KERNEL struct pixel_work shade_visible_rows(const struct pipeline *pipeline,
                                            const struct shader *shader, const void *uniforms,
                                            struct image *image, struct span rows) {
    int left = pipeline->viewport.x, right = left + pipeline->viewport.width;
    size_t stride = 3 * shader->varying_count;
    struct pixel_work work = {0, 0};
    for (int y = rows.begin; y < rows.end; y++) {
        const uint32_t *number = pipeline->number + (size_t)y * pipeline->width;
        for (struct span run = {left, left}; run.begin < right; run.begin = run.end) {
            while (run.end < right && number[run.end] == number[run.begin]) {
                run.end++;
            }
            if (number[run.begin] >= pipeline->first_number) {
                const struct piece *piece =
                    &pipeline->pieces[number[run.begin] - pipeline->first_number];
                const double *corners = pipeline->attributes + piece->attributes * stride;
                work.shaded += shade_run(piece, corners, shader, uniforms, image, run, y, NULL);
            }
        }
    }
    return work;
}

/* Both passes in one for a band of rows, for shaders that discard and with skip off: shade whatever
 * is nearest so far. */
KERNEL struct pixel_work shade_rows_at_once(const struct pipeline *pipeline,
                                            const struct shader *shader, const void *uniforms,
                                            struct image *image, struct span band) {
    struct pixel_work work = {0, 0};
    for (size_t i = 0; i < pipeline->piece_count; i++) {
        const struct piece *piece = &pipeline->pieces[i];
        struct span rows = rows_in_band(piece, band);
        if (rows.begin >= rows.end) {
            continue;
        }
        double corners[3 * VARYING_LIMIT];
        fetch_attributes(pipeline, piece, shader, uniforms, corners);
        for (int y = rows.begin; y < rows.end; y++) {
            struct span span = span_in_viewport(pipeline, piece, y);
            if (span.begin < span.end) {
                work.covered += (uint64_t)(span.end - span.begin);
                if (!piece->dropped) {
                    work.shaded += shade_run(piece, corners, shader, uniforms, image, span, y,
                                             pipeline->depth + (size_t)y * pipeline->width);
                }
            }
        }
    }
    return work;
}

/* The whole loop over pixels. A shader that discards needs only one of the two. */
KERNEL struct pixel_work shade_rows(const struct pipeline *pipeline, const struct shader *shader,
                                    const void *uniforms, struct image *image, struct span rows,
                                    bool at_once) {
    if (shader->discards || at_once) {
        return shade_rows_at_once(pipeline, shader, uniforms, image, rows);
    }
    return shade_visible_rows(pipeline, shader, uniforms, image, rows);
}

#endif
