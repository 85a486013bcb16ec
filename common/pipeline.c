/* The passes of the pipeline that no shader takes part in: see pipeline.h. */
#include "pipeline.h"

#include "array.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Nearer than this part of the camera's distance nothing is drawn: 1/w would grow without bound. */
static const double near_w = 1.0 / 128;

/* Faces are cut where they leave NDC -64..64: far outside the image, so that few are, but within
 * SCREEN_LIMIT for the largest image. */
static const double guard_band = 64;

/* A depth beyond this is no place to draw at: sums and differences of such might overflow. */
static const double depth_limit = 1e280;

enum { CLIP_PLANES = 5 };

/* Rows are shared out among threads in bands of this many. */
enum { BAND_HEIGHT = 16, BANDS_FOR_THREADS = 4 /* fewer are not worth waking one */ };

/* A convex polygon gains at most one corner at each plane. Where coordinates differ by many
 * orders of magnitude, rounding can make the polygon not convex, and n corners become up to n +
 * n/2 at each of the five planes: 3, 4, 6, 9, 13, 19. */
enum { POLYGON_LIMIT = 19 };

/* Sides of the view that a position is beyond. */
enum {
    BEYOND_LEFT = 1,
    BEYOND_RIGHT = 2,
    BEYOND_BOTTOM = 4,
    BEYOND_TOP = 8,
    BEYOND_NEAR = 16,
    BEYOND_GUARD_BAND = 32
};

/* A transformed position. */
struct position {
    struct vec4 clip;
    struct fixed2 screen; /* these three only without BEYOND_NEAR and BEYOND_GUARD_BAND */
    double depth;
    double recip_w;
    unsigned beyond;
};

/* A corner of a polygon while it is clipped. */
struct clip_corner {
    struct vec4 clip;
    struct vec3 weight; /* of the face's corners; sum 1 */
};

struct polygon {
    struct clip_corner corner[POLYGON_LIMIT];
    size_t count;
};

/* ---- Memory ---- */

/* Room for that many elements. False, with the array as it was, when memory runs out. */
static bool reserve_positions(struct pipeline *p, size_t count, struct error *error) {
    struct position *positions =
        array_reserve(p->positions, &p->position_capacity, count, sizeof *positions);
    p->positions = positions != NULL ? positions : p->positions;
    return positions != NULL || error_out_of_memory(error);
}

static bool reserve_pieces(struct pipeline *p, size_t count, struct error *error) {
    struct piece *pieces = array_reserve(p->pieces, &p->piece_capacity, count, sizeof *pieces);
    p->pieces = pieces != NULL ? pieces : p->pieces;
    return pieces != NULL || error_out_of_memory(error);
}

static bool reserve_clipped(struct pipeline *p, size_t count, struct error *error) {
    struct clipped_corners *clipped =
        array_reserve(p->clipped, &p->clipped_capacity, count, sizeof *clipped);
    p->clipped = clipped != NULL ? clipped : p->clipped;
    return clipped != NULL || error_out_of_memory(error);
}

static bool reserve_attributes(struct pipeline *p, size_t count, struct error *error) {
    double *attributes =
        array_reserve(p->attributes, &p->attribute_capacity, count, sizeof *attributes);
    p->attributes = attributes != NULL ? attributes : p->attributes;
    return attributes != NULL || error_out_of_memory(error);
}

bool pipeline_create(struct pipeline *pipeline, size_t width, size_t height, struct error *error) {
    *pipeline = (struct pipeline){0};
    if (width < 1 || height < 1 || width > DRAW_LIMIT || height > DRAW_LIMIT) {
        return error_set(error, "cannot draw %zux%zu pixels: a side has 1 to %d", width, height,
                         DRAW_LIMIT);
    }
    pipeline->width = width;
    pipeline->height = height;
    pipeline->skip = true;
    pipeline->depth = malloc(width * height * sizeof *pipeline->depth);
    pipeline->number = malloc(width * height * sizeof *pipeline->number);
    pipeline->band_work = malloc((height / BAND_HEIGHT + 1) * sizeof *pipeline->band_work);
    if (pipeline->depth == NULL || pipeline->number == NULL || pipeline->band_work == NULL) {
        pipeline_free(pipeline);
        return error_out_of_memory(error);
    }
    pipeline_clear(pipeline);
    return true;
}

void pipeline_free(struct pipeline *pipeline) {
    free(pipeline->depth);
    free(pipeline->number);
    free(pipeline->band_work);
    workers_free(pipeline->workers);
    free(pipeline->positions);
    free(pipeline->pieces);
    free(pipeline->clipped);
    free(pipeline->attributes);
    *pipeline = (struct pipeline){0};
}

void pipeline_use_threads(struct pipeline *pipeline, size_t thread_count) {
    if (pipeline->thread_count != thread_count) {
        workers_free(pipeline->workers);
        pipeline->workers = NULL;
        pipeline->alone = false;
        pipeline->thread_count = thread_count;
    }
}

void pipeline_clear(struct pipeline *pipeline) {
    size_t pixels = pipeline->width * pipeline->height;
    depth_clear(pipeline->depth, pixels);
    memset(pipeline->number, 0, pixels * sizeof *pipeline->number);
    pipeline->next_number = 1;
    memset(pipeline->stats, 0, sizeof pipeline->stats);
}

/* ---- Draw calls ---- */

const char *const pipeline_stat_name[PIPELINE_STATS] = {
    "faces",         "faces_outside", "faces_turned_away", "faces_without_pixel",
    "faces_clipped", "faces_hidden",  "pixels_covered",    "pixels_shaded",
};

struct draw_call camera_call(const struct model *model, struct vec3 eye, struct vec3 center,
                             struct vec3 up, double zoom, struct rectangle viewport,
                             enum cull cull) {
    double distance = vec3_length(vec3_sub(eye, center));
    struct mat4 clip = mat4_mul(mat4_projection(distance), mat4_lookat(eye, center, up));
    return (struct draw_call){
        .model = model,
        .to_clip = mat4_mul(mat4_scaling((struct vec3){zoom, zoom, 1}), clip),
        .viewport = viewport,
        .cull = cull,
    };
}

size_t wrapped_level(const struct texture *texture, double pixels) {
    size_t level = 0;
    if (texture != NULL) {
        double texels = (double)texture->level[0].width / 2;
        while (texels > 1.5 * pixels && level + 1 < texture->level_count) {
            texels /= 2;
            level++;
        }
    }
    return level;
}

/* ---- Positions ---- */

/* NDC to the screen, snapped. False when the result is no place on the screen. */
static bool project(struct vec4 clip, const struct rectangle *viewport, struct fixed2 *screen,
                    double *depth, double *recip_w) {
    *recip_w = 1 / clip.w;
    *depth = clip.z * *recip_w;
    double half_width = viewport->width / 2.0, half_height = viewport->height / 2.0;
    struct vec2 position = {viewport->x + (clip.x * *recip_w + 1) * half_width,
                            viewport->y + (clip.y * *recip_w + 1) * half_height};
    return fabs(*depth) <= depth_limit && screen_snap(position, screen);
}

/* Written so that what is not a number is beyond everything. */
static unsigned find_beyond(struct vec4 p) {
    unsigned beyond = 0;
    beyond |= p.x >= -p.w ? 0 : BEYOND_LEFT;
    beyond |= p.x <= p.w ? 0 : BEYOND_RIGHT;
    beyond |= p.y >= -p.w ? 0 : BEYOND_BOTTOM;
    beyond |= p.y <= p.w ? 0 : BEYOND_TOP;
    beyond |= p.w >= near_w ? 0 : BEYOND_NEAR;
    double guard = guard_band * p.w;
    beyond |= fabs(p.x) <= guard && fabs(p.y) <= guard ? 0 : BEYOND_GUARD_BAND;
    return beyond;
}

static void transform_positions(struct pipeline *p, const struct draw_call *call) {
    const struct model *model = call->model;
    for (size_t i = 0; i < model->position_count; i++) {
        struct position *to = &p->positions[i];
        to->clip = mat4_point(&call->to_clip, model->positions[i]);
        to->beyond = find_beyond(to->clip);
        if ((to->beyond & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0 &&
            !project(to->clip, &call->viewport, &to->screen, &to->depth, &to->recip_w)) {
            to->beyond = ~0u;
        }
    }
}

/* ---- Clipping ---- */

/* Signed distances to the planes, positive inside. */
static double plane_distance(struct vec4 p, int plane) {
    switch (plane) {
    case 0:
        return p.w - near_w;
    case 1:
        return guard_band * p.w + p.x;
    case 2:
        return guard_band * p.w - p.x;
    case 3:
        return guard_band * p.w + p.y;
    default:
        return guard_band * p.w - p.y;
    }
}

static double mix(double from, double to, double t) {
    return from + t * (to - from);
}

/* Where an edge crosses the plane. Always computed from the corner inside to the one outside, so
 * that both faces of an edge find the very same point, and no gap opens between them. */
static struct clip_corner cut_edge(const struct clip_corner *inside,
                                   const struct clip_corner *outside, double inside_distance,
                                   double outside_distance) {
    double t = inside_distance / (inside_distance - outside_distance);
    struct vec4 p = inside->clip, q = outside->clip;
    struct vec3 v = inside->weight, w = outside->weight;
    return (struct clip_corner){
        .clip = {mix(p.x, q.x, t), mix(p.y, q.y, t), mix(p.z, q.z, t), mix(p.w, q.w, t)},
        .weight = {mix(v.x, w.x, t), mix(v.y, w.y, t), mix(v.z, w.z, t)},
    };
}

/* The part of a polygon on the inner side of a plane (Sutherland and Hodgman, "Reentrant Polygon
 * Clipping", 1974). */
static struct polygon clip_at_plane(const struct polygon *polygon, int plane) {
    struct polygon result = {.count = 0};
    for (size_t i = 0; i < polygon->count; i++) {
        const struct clip_corner *a = &polygon->corner[i];
        const struct clip_corner *b = &polygon->corner[(i + 1) % polygon->count];
        double a_distance = plane_distance(a->clip, plane);
        double b_distance = plane_distance(b->clip, plane);
        bool a_inside = a_distance >= 0, b_inside = b_distance >= 0;
        if (a_inside) {
            result.corner[result.count++] = *a;
        }
        if (a_inside && !b_inside) {
            result.corner[result.count++] = cut_edge(a, b, a_distance, b_distance);
        } else if (!a_inside && b_inside) {
            result.corner[result.count++] = cut_edge(b, a, b_distance, a_distance);
        }
    }
    return result;
}

/* ---- Pieces ---- */

/* Cut the rows to the viewport. False when none is left. */
static bool rows_in_viewport(struct edges *edges, const struct rectangle *viewport) {
    int bottom = viewport->y, top = viewport->y + viewport->height;
    edges->y_begin = edges->y_begin > bottom ? edges->y_begin : bottom;
    edges->y_end = edges->y_end < top ? edges->y_end : top;
    return edges->y_begin < edges->y_end;
}

/* Is a triangle with this winding culled? */
static bool is_culled(bool clockwise, enum cull cull) {
    return (cull == CULL_BACK && clockwise) || (cull == CULL_FRONT && !clockwise);
}

/* Twice the signed area, in 1/256 pixel squared; positive when counterclockwise. */
static int64_t signed_area(const struct fixed2 *p) {
    return ((int64_t)p[1].x - p[0].x) * ((int64_t)p[2].y - p[0].y) -
           ((int64_t)p[1].y - p[0].y) * ((int64_t)p[2].x - p[0].x);
}

/* Add a triangle to `pieces` (which have room) if it must be drawn; count why it need not. */
static bool add_piece(struct pipeline *p, const struct draw_call *call, const struct fixed2 *screen,
                      const struct piece *description) {
    int64_t area = signed_area(screen);
    bool culled = area != 0 && is_culled(area < 0, call->cull);
    if (culled && p->skip) {
        p->stats[STAT_FACES_TURNED_AWAY]++;
        return false;
    }
    struct piece *piece = &p->pieces[p->piece_count];
    *piece = *description;
    if (!edges_setup(&piece->edges, screen[0], screen[1], screen[2], p->width, p->height) ||
        !rows_in_viewport(&piece->edges, &call->viewport)) {
        p->stats[STAT_FACES_WITHOUT_PIXEL]++;
        return false;
    }
    piece->attributes = UINT32_MAX;
    piece->dropped = culled;
    p->piece_count++;
    return true;
}

/* The first corner in a fixed order of positions, so that a face whose corners are listed from
 * another one on is computed in the same way, to the last bit. */
static uint32_t find_first_corner(const struct position *const corner[3]) {
    uint32_t first = 0;
    for (uint32_t i = 1; i < 3; i++) {
        struct vec4 a = corner[i]->clip, b = corner[first]->clip;
        if (a.y < b.y ||
            (a.y == b.y &&
             (a.x < b.x || (a.x == b.x && (a.z < b.z || (a.z == b.z && a.w < b.w)))))) {
            first = i;
        }
    }
    return first;
}

static void add_whole_face(struct pipeline *p, const struct draw_call *call,
                           const struct position *const corner[3], uint32_t face,
                           uint32_t first_corner) {
    struct fixed2 screen[3];
    struct piece piece = {.face = face, .first_corner = first_corner, .clipped = NOT_CLIPPED};
    for (int i = 0; i < 3; i++) {
        screen[i] = corner[i]->screen;
        piece.depth[i] = corner[i]->depth;
        piece.recip_w[i] = corner[i]->recip_w;
    }
    add_piece(p, call, screen, &piece);
}

/* One triangle of the fan that a clipped polygon is cut into. */
static void add_part(struct pipeline *p, const struct draw_call *call,
                     const struct clip_corner *const corner[3], uint32_t face,
                     uint32_t first_corner) {
    struct fixed2 screen[3];
    struct piece piece = {
        .face = face, .first_corner = first_corner, .clipped = (uint32_t)p->clipped_count};
    struct clipped_corners *clipped = &p->clipped[p->clipped_count];
    for (int i = 0; i < 3; i++) {
        if (!project(corner[i]->clip, &call->viewport, &screen[i], &piece.depth[i],
                     &piece.recip_w[i])) {
            return;
        }
        clipped->weight[i] = corner[i]->weight;
    }
    if (add_piece(p, call, screen, &piece)) {
        p->clipped_count++;
    }
}

static bool add_clipped_face(struct pipeline *p, const struct draw_call *call,
                             const struct position *const corner[3], uint32_t face,
                             uint32_t first_corner, struct error *error) {
    struct polygon polygon = {.corner = {{corner[0]->clip, {1, 0, 0}},
                                         {corner[1]->clip, {0, 1, 0}},
                                         {corner[2]->clip, {0, 0, 1}}},
                              .count = 3};
    for (int plane = 0; plane < CLIP_PLANES && polygon.count > 0; plane++) {
        polygon = clip_at_plane(&polygon, plane);
    }
    if (polygon.count < 3) {
        p->stats[STAT_FACES_OUTSIDE]++;
        return true;
    }
    p->stats[STAT_FACES_CLIPPED]++;
    if (!reserve_pieces(p, p->piece_count + POLYGON_LIMIT, error) ||
        !reserve_clipped(p, p->clipped_count + POLYGON_LIMIT, error)) {
        return false;
    }
    for (size_t i = 2; i < polygon.count; i++) {
        const struct clip_corner *part[3] = {&polygon.corner[0], &polygon.corner[i - 1],
                                             &polygon.corner[i]};
        add_part(p, call, part, face, first_corner);
    }
    return true;
}

static bool add_face(struct pipeline *p, const struct draw_call *call, size_t index,
                     struct error *error) {
    const struct corner *corner = call->model->faces[index].corner;
    const struct position *given[3] = {&p->positions[corner[0].position],
                                       &p->positions[corner[1].position],
                                       &p->positions[corner[2].position]};
    unsigned beyond_one_side = given[0]->beyond & given[1]->beyond & given[2]->beyond;
    if ((beyond_one_side & ~(unsigned)BEYOND_GUARD_BAND) != 0) {
        p->stats[STAT_FACES_OUTSIDE]++;
        return true;
    }
    uint32_t first = find_first_corner(given);
    const struct position *ordered[3] = {given[first], given[(first + 1) % 3],
                                         given[(first + 2) % 3]};
    unsigned beyond_any = given[0]->beyond | given[1]->beyond | given[2]->beyond;
    if ((beyond_any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0) {
        return add_clipped_face(p, call, ordered, (uint32_t)index, first, error);
    }
    add_whole_face(p, call, ordered, (uint32_t)index, first);
    return true;
}

bool pipeline_assemble(struct pipeline *p, const struct draw_call *call, struct error *error) {
    const struct model *model = call->model;
    const struct rectangle *v = &call->viewport;
    assert(v->x >= 0 && v->y >= 0 && v->width >= 0 && v->height >= 0);
    assert((size_t)v->x + (size_t)v->width <= p->width);
    assert((size_t)v->y + (size_t)v->height <= p->height);
    p->viewport = call->viewport;
    p->piece_count = p->clipped_count = 0;
    p->first_number = p->next_number;
    p->stats[STAT_FACES] += model->face_count;
    if (!reserve_positions(p, model->position_count, error) ||
        !reserve_pieces(p, model->face_count, error)) {
        return false;
    }
    transform_positions(p, call);
    for (size_t i = 0; i < model->face_count; i++) {
        if (!reserve_pieces(p, p->piece_count + 1, error) || !add_face(p, call, i, error)) {
            return false;
        }
    }
    if (p->piece_count > UINT32_MAX - p->next_number) {
        return error_set(error, "more than %lu triangles in one frame", (unsigned long)UINT32_MAX);
    }
    p->next_number += (uint32_t)p->piece_count;
    return true;
}

/* ---- Pass 1 ---- */

/* Write depth and number where the piece is nearer. Plain selects without branches: compilers turn
 * the loop into vector instructions. */
static void cover_span(double *restrict depth, uint32_t *restrict number, int pixels,
                       struct depth_row row, uint32_t piece_number) {
    for (int i = 0; i < pixels; i++) {
        double z = row.begin + row.step * i;
        bool nearer = z > depth[i];
        depth[i] = nearer ? z : depth[i];
        number[i] = nearer ? piece_number : number[i];
    }
}

static uint64_t cover_band(const struct pipeline *p, struct span band) {
    uint64_t covered = 0;
    for (size_t i = 0; i < p->piece_count; i++) {
        const struct piece *piece = &p->pieces[i];
        struct span rows = rows_in_band(piece, band);
        for (int y = rows.begin; y < rows.end; y++) {
            struct span span = span_in_viewport(p, piece, y);
            if (span.begin < span.end) {
                size_t first = (size_t)y * p->width + (size_t)span.begin;
                cover_span(p->depth + first, p->number + first, span.end - span.begin,
                           depth_along_row(piece, span.begin, y), p->first_number + (uint32_t)i);
                covered += (uint64_t)(span.end - span.begin);
            }
        }
    }
    return covered;
}

/* The band of rows that begins at y, in a viewport that ends at `top`. */
static struct span band_at(int y, int top) {
    return (struct span){y, y + BAND_HEIGHT < top ? y + BAND_HEIGHT : top};
}

/* What is done with each band of the viewport: it is covered, or shaded when there is a shader. */
struct band_loop {
    struct pipeline *pipeline;
    const struct shader *shader; /* NULL: cover */
    const void *uniforms;
    struct image *image;
    bool at_once;
};

static void do_band(void *context, size_t index) {
    const struct band_loop *loop = context;
    struct pipeline *p = loop->pipeline;
    const struct shader *shader = loop->shader;
    struct span band =
        band_at(p->viewport.y + (int)index * BAND_HEIGHT, p->viewport.y + p->viewport.height);
    if (shader == NULL) {
        p->band_work[index] = (struct pixel_work){.covered = cover_band(p, band)};
    } else if (shader->band != NULL) {
        p->band_work[index] = shader->band(p, loop->uniforms, loop->image, band, loop->at_once);
    } else {
        p->band_work[index] =
            shade_rows(p, shader, loop->uniforms, loop->image, band, loop->at_once);
    }
}

/* Share out the bands among threads, which are started when there is enough to do for the first
 * time. */
static void do_bands(struct pipeline *p, struct band_loop *loop) {
    size_t band_count = ((size_t)p->viewport.height + BAND_HEIGHT - 1) / BAND_HEIGHT;
    if (p->workers == NULL && !p->alone && band_count >= BANDS_FOR_THREADS) {
        p->workers = workers_create(p->thread_count);
        p->alone = p->workers == NULL;
    }
    workers_run(band_count >= BANDS_FOR_THREADS ? p->workers : NULL, band_count, do_band, loop);
    for (size_t i = 0; i < band_count; i++) {
        p->stats[STAT_PIXELS_COVERED] += p->band_work[i].covered;
        p->stats[STAT_PIXELS_SHADED] += p->band_work[i].shaded;
    }
}

void pipeline_cover(struct pipeline *p) {
    struct band_loop loop = {.pipeline = p};
    do_bands(p, &loop);
}

/* ---- Between the passes ---- */

/* Give each visible piece a place in `attributes`. Returns how many there are. */
static uint32_t number_visible(struct pipeline *p) {
    uint32_t visible = 0;
    for (int y = p->viewport.y; y < p->viewport.y + p->viewport.height; y++) {
        const uint32_t *row = p->number + (size_t)y * p->width + (size_t)p->viewport.x;
        uint32_t last = 0;
        for (int x = 0; x < p->viewport.width; x++) {
            if (row[x] != last && row[x] >= p->first_number) {
                struct piece *piece = &p->pieces[row[x] - p->first_number];
                if (piece->attributes == UINT32_MAX) {
                    piece->attributes = visible++;
                }
            }
            last = row[x];
        }
    }
    return visible;
}

bool pipeline_fetch_visible(struct pipeline *p, const struct shader *shader, const void *uniforms,
                            struct error *error) {
    size_t stride = 3 * shader->varying_count;
    uint32_t visible = number_visible(p);
    p->stats[STAT_FACES_HIDDEN] += p->piece_count - visible;
    if (!reserve_attributes(p, visible * stride, error)) {
        return false;
    }
    for (size_t i = 0; i < p->piece_count; i++) {
        const struct piece *piece = &p->pieces[i];
        if (piece->attributes != UINT32_MAX) {
            fetch_attributes(p, piece, shader, uniforms,
                             p->attributes + piece->attributes * stride);
        }
    }
    return true;
}

/* ---- Drawing ---- */

bool pipeline_draw(struct pipeline *p, const struct draw_call *call, const struct shader *shader,
                   const void *uniforms, struct image *image, struct error *error) {
    assert(shader->varying_count <= VARYING_LIMIT);
    assert(image->width == p->width && image->height == p->height && image->format != IMAGE_GREY);
    bool at_once = shader->discards || !p->skip;
    if (!pipeline_assemble(p, call, error)) {
        return false;
    }
    if (!at_once) {
        pipeline_cover(p);
        if (!pipeline_fetch_visible(p, shader, uniforms, error)) {
            return false;
        }
    }
    struct band_loop loop = {p, shader, uniforms, image, at_once};
    do_bands(p, &loop);
    return true;
}
