/* The first part of the pipeline: from a model to pieces on the screen. See pipeline.h. */
#include "pipeline.h"

#include "pipeline/parts.h"

#include <assert.h>

/* Faces are cut where they leave the guard band, NDC -64..64: far outside of the viewport, so that
 * few are. For large viewports it is narrower, 2^16 pixels to each side of the middle: so no side
 * is longer than 2^25 steps, and every edge function is a whole number that a double holds. */
static double guard_band_of(const struct rectangle *viewport) {
    int side = viewport->width > viewport->height ? viewport->width : viewport->height;
    return fmin(64, 0x1p17 / side);
}

/* A depth beyond this is no place to draw at: sums and differences of such might overflow. */
static const double depth_limit = 1e280;

enum { CLIP_PLANES = 5 };

/* Positions and faces are shared out among threads in blocks of this many. */
enum { BLOCK_SIZE = 1024 };
_Static_assert(BLOCK_SIZE / BATCH_SIZE % TOGETHER == 0, "no struct boxes is of two blocks");

/* A convex polygon gains at most one corner at each plane. Where coordinates differ by many
 * orders of magnitude, rounding can make the polygon not convex, and n corners become up to n +
 * n/2 at each of the five planes: 3, 4, 6, 9, 13, 19. */
enum { POLYGON_LIMIT = 19 };

/* The transformed positions of a draw call. What is beyond the near plane or the guard band has no
 * place on the screen: all but `beyond` is 0. */
struct vertices {
    struct fixed2 *screen;
    double *depth;
    double *recip_w;
    uint8_t *beyond;
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

/* A draw call that is assembled, and what the threads that do it share. */
struct assembly {
    struct pipeline *pipeline;
    struct draw *draw;
    size_t first_position;     /* in the pipeline's arrays */
    size_t first_vertex_block; /* of all of the round */
    struct vertices vertices;
    double guard_band;
    atomic_uint beyond; /* the sides that any of the vertices is beyond */
};

/* ---- Positions ---- */

/* Where they are on the screen; 0 where they have no place there. */
struct screen_positions {
    ints x, y; /* in 1/256 pixel */
    doubles depth, recip_w;
    longs placed; /* which have one */
};

/* Where the mask is set, the value, otherwise 0. */
LANES_INLINE doubles doubles_where(longs mask, doubles value) {
    return (doubles)(mask & (longs)value);
}

LANES_INLINE longs find_beyond(const struct clip_positions *p, double guard_band) {
    doubles guard = guard_band * p->w;
    longs in_guard_band = (doubles_abs(p->x) <= guard) & (doubles_abs(p->y) <= guard);
    return find_beyond_sides(p) | (~in_guard_band & BEYOND_GUARD_BAND);
}

/* screen_snap() of what is within SCREEN_LIMIT. */
LANES_INLINE ints snap(doubles screen) {
    doubles place = screen * SUBPIXELS + 0.5;
    /* Towards 0, which may be upwards: */
    doubles whole = doubles_from_ints(__builtin_convertvector(place, ints));
    whole -= doubles_where(whole > place, doubles_all(1));
    return __builtin_convertvector(whole, ints);
}

/* Where those are that are `wanted`. */
LANES_INLINE struct screen_positions project(const struct clip_positions *clip, longs wanted,
                                             const struct rectangle *viewport) {
    doubles recip_w = 1 / clip->w, depth = clip->z * recip_w;
    doubles x = viewport->x + (clip->x * recip_w + 1) * (viewport->width / 2.0);
    doubles y = viewport->y + (clip->y * recip_w + 1) * (viewport->height / 2.0);
    longs placed = wanted & (doubles_abs(depth) <= depth_limit) & (doubles_abs(x) <= SCREEN_LIMIT) &
                   (doubles_abs(y) <= SCREEN_LIMIT);
    return (struct screen_positions){
        .x = snap(doubles_where(placed, x)),
        .y = snap(doubles_where(placed, y)),
        .depth = doubles_where(placed, depth),
        .recip_w = doubles_where(placed, recip_w),
        .placed = placed,
    };
}

/* Positions of the model from number `at` on; behind the last one that again. As mat4_point(). */
LANES_INLINE struct clip_positions transform(const struct draw_call *call, size_t at) {
    const struct model *model = call->model;
    const double(*m)[4] = call->to_clip.m;
    const struct vec3 *positions = model->positions + at;
    struct vec3 last_ones[TOGETHER];
    doubles x = {0}, y = {0}, z = {0};
    if (model->position_count - at < TOGETHER) {
        size_t last = model->position_count - 1;
        for (size_t i = 0; i < TOGETHER; i++) {
            last_ones[i] = model->positions[at + i < last ? at + i : last];
        }
        positions = last_ones;
    }
    for (size_t i = 0; i < TOGETHER; i++) {
        x[i] = positions[i].x;
        y[i] = positions[i].y;
        z[i] = positions[i].z;
    }
    return (struct clip_positions){
        .x = m[0][0] * x + m[0][1] * y + m[0][2] * z + m[0][3],
        .y = m[1][0] * x + m[1][1] * y + m[1][2] * z + m[1][3],
        .z = m[2][0] * x + m[2][1] * y + m[2][2] * z + m[2][3],
        .w = m[3][0] * x + m[3][1] * y + m[3][2] * z + m[3][3],
    };
}

static void keep(const struct vertices *vertices, size_t at, const struct screen_positions *p,
                 longs beyond) {
    typedef uint8_t bytes __attribute__((vector_size(TOGETHER)));
    bytes narrow = __builtin_convertvector(beyond, bytes);
    memcpy(vertices->depth + at, &p->depth, sizeof p->depth);
    memcpy(vertices->recip_w + at, &p->recip_w, sizeof p->recip_w);
    for (size_t i = 0; i < TOGETHER; i++) {
        vertices->screen[at + i] = (struct fixed2){p->x[i], p->y[i]};
    }
    memcpy(vertices->beyond + at, &narrow, sizeof narrow);
}

/* The elements of a block. */
static struct range block_range(size_t index, size_t count) {
    size_t begin = index * BLOCK_SIZE;
    return (struct range){begin, count - begin < BLOCK_SIZE ? count : begin + BLOCK_SIZE};
}

static void transform_block(void *context, size_t index, size_t worker) {
    (void)worker;
    struct assembly *assembly = context;
    /* Copies: the compiler need not fear that what is written changes them. */
    const struct draw_call call = assembly->draw->call;
    const struct vertices vertices = assembly->vertices;
    struct range range = block_range(index, call.model->position_count);
    longs any = {0};
    for (size_t i = range.begin; i < range.end; i += TOGETHER) {
        struct clip_positions clip = transform(&call, i);
        longs beyond = find_beyond(&clip, assembly->guard_band);
        longs may_be_placed = (beyond & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0;
        struct screen_positions positions = project(&clip, may_be_placed, &call.viewport);
        beyond |= may_be_placed & ~positions.placed & BEYOND_ALL;
        keep(&vertices, i, &positions, beyond);
        any |= beyond;
    }
    for (int i = 0; i < TOGETHER; i++) {
        atomic_fetch_or_explicit(&assembly->beyond, (unsigned)any[i], memory_order_relaxed);
    }
}

/* ---- Clipping ---- */

/* Signed distances to the planes, positive inside. */
static double plane_distance(struct vec4 p, int plane, double guard_band) {
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
static struct polygon clip_at_plane(const struct polygon *polygon, int plane, double guard_band) {
    struct polygon result = {.count = 0};
    for (size_t i = 0; i < polygon->count; i++) {
        const struct clip_corner *a = &polygon->corner[i];
        const struct clip_corner *b = &polygon->corner[(i + 1) % polygon->count];
        double a_distance = plane_distance(a->clip, plane, guard_band);
        double b_distance = plane_distance(b->clip, plane, guard_band);
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

/* ---- Triangles on the screen ---- */

/* What the corners of a face are beyond: all of them, and any of them. */
struct face_beyond {
    unsigned all, any;
};

static inline struct face_beyond find_face_beyond(const struct assembly *a,
                                                  const struct corner corner[3]) {
    const uint8_t *beyond = a->vertices.beyond;
    unsigned b[3] = {beyond[corner[0].position], beyond[corner[1].position],
                     beyond[corner[2].position]};
    return (struct face_beyond){b[0] & b[1] & b[2], b[0] | b[1] | b[2]};
}

/* Where all positions are beyond nothing, `inside`, that is not asked, and was 0 before. */
static inline void batch_put(struct batch *batch, const struct assembly *a,
                             const struct corner corner[3], bool inside) {
    size_t at = batch->count++;
    for (int i = 0; i < 3; i++) {
        struct fixed2 screen = a->vertices.screen[corner[i].position];
        batch->x[i][at] = screen.x;
        batch->y[i][at] = screen.y;
    }
    if (!inside) {
        struct face_beyond beyond = find_face_beyond(a, corner);
        batch->beyond_all[at] = (int32_t)beyond.all;
        batch->beyond_any[at] = (int32_t)beyond.any;
    }
}

/* Where a block's pieces go. */
struct output {
    struct block *block;
    struct piece *pieces;
    struct band_span *piece_bands;
    struct clipped_corners *clipped;
    uint32_t *band_counts;
    const struct pipeline *hiding; /* rounds before this one hide what lies behind; or NULL */
    uint32_t draw;                 /* which draw call the pieces are of */
};

/* Add a triangle of a batch that is whole. Corner 0 becomes the lowest, so that a face whose
 * corners are listed from another one on is computed in the same way, to the last bit; and the rest
 * follows counterclockwise. Not added, but counted, where it is hidden already. */
static void add_piece(struct output *to, const struct batch *batch, size_t at, size_t face,
                      uint32_t clipped, const double depth[3]) {
    struct block *block = to->block;
    struct span columns = {batch->left[at], batch->right[at] + 1};
    struct span rows = {batch->bottom[at], batch->top[at] + 1};
    const struct screen_place place = {columns, rows, nearest_of_depths(depth)};
    if (to->hiding != NULL && pipeline_is_hidden(to->hiding, &place)) {
        block->stats[STAT_FACES_HIDDEN]++;
        block->stats[STAT_FACES_BEHIND]++;
        return;
    }
    struct band_span *bands = &to->piece_bands[block->piece_count];
    struct piece *piece = &to->pieces[block->piece_count++];
    int order[3] = {batch->first[at], batch->second[at], 3 - batch->first[at] - batch->second[at]};
    for (int i = 0; i < 3; i++) {
        piece->corner[i] = (struct fixed2){batch->x[order[i]][at], batch->y[order[i]][at]};
        piece->depth[i] = depth[order[i]];
        piece->face_corner[i] = (uint8_t)order[i];
    }
    piece->face = (uint32_t)face;
    piece->clipped = clipped;
    piece->dropped = batch->culled[at] != 0;
    piece->draw = to->draw;
    block->columns = span_around(block->columns, columns);
    block->rows = span_around(block->rows, rows);
    bands->first = (uint16_t)(rows.begin / BAND_HEIGHT);
    bands->last = (uint16_t)((rows.end - 1) / BAND_HEIGHT);
    for (int band = bands->first; band <= bands->last; band++) {
        to->band_counts[band]++;
    }
}

/* Count a triangle that is not drawn. */
static void count_left_out(struct block *block, enum triangle_kind kind) {
    block->stats[STAT_FACES_OUTSIDE] += kind == TRIANGLE_OUTSIDE;
    block->stats[STAT_FACES_TURNED_AWAY] += kind == TRIANGLE_TURNED_AWAY;
    block->stats[STAT_FACES_WITHOUT_PIXEL] += kind == TRIANGLE_WITHOUT_PIXEL;
}

/* ---- Faces that are clipped ---- */

/* Is position a before b, in a fixed order? */
static bool is_before(struct vec4 a, struct vec4 b) {
    return a.y < b.y ||
           (a.y == b.y && (a.x < b.x || (a.x == b.x && (a.z < b.z || (a.z == b.z && a.w < b.w)))));
}

/* The part of a face that can be drawn. Cut from its first corner on, in a fixed order of
 * positions; the weights are of the face's corners as the model lists them. */
static struct polygon clip_face(const struct assembly *a, size_t face) {
    const struct draw_call *call = &a->draw->call;
    static const struct vec3 weight[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct vec4 clip[3];
    size_t first = 0;
    for (size_t i = 0; i < 3; i++) {
        clip[i] = mat4_point(&call->to_clip, model_position(call->model, face, i));
        first = i > 0 && is_before(clip[i], clip[first]) ? i : first;
    }
    struct polygon polygon = {.count = 3};
    for (size_t i = 0; i < 3; i++) {
        size_t from = (first + i) % 3;
        polygon.corner[i] = (struct clip_corner){clip[from], weight[from]};
    }
    for (int plane = 0; plane < CLIP_PLANES && polygon.count > 0; plane++) {
        polygon = clip_at_plane(&polygon, plane, a->guard_band);
    }
    return polygon;
}

/* One triangle of the fan that a clipped polygon is cut into. */
static void add_part(const struct assembly *a, struct output *to, size_t face,
                     const struct clip_corner *const corner[3]) {
    struct clipped_corners clipped;
    struct batch batch = {.count = 1};
    double depth[3];
    for (int i = 0; i < 3; i++) {
        struct clip_positions clip = clip_positions_all(corner[i]->clip);
        struct screen_positions position = project(&clip, ~(longs){0}, &a->draw->call.viewport);
        if (!position.placed[0]) {
            return;
        }
        batch.x[i][0] = position.x[0];
        batch.y[i][0] = position.y[0];
        depth[i] = position.depth[0];
        clipped.recip_w[i] = position.recip_w[0];
        clipped.weight[i] = corner[i]->weight;
    }
    batch_classify(&batch, &a->draw->call, a->pipeline->skip);
    if (batch.kind[0] != TRIANGLE_WHOLE) {
        count_left_out(to->block, (enum triangle_kind)batch.kind[0]);
        return;
    }
    size_t index = to->block->first_clipped + to->block->clipped_count;
    add_piece(to, &batch, 0, face, (uint32_t)index, depth);
    to->clipped[to->block->clipped_count++] = clipped;
}

static void add_clipped_face(const struct assembly *a, struct output *to, size_t face) {
    struct polygon polygon = clip_face(a, face);
    if (polygon.count < 3) {
        to->block->stats[STAT_FACES_OUTSIDE]++;
        return;
    }
    to->block->stats[STAT_FACES_CLIPPED]++;
    for (size_t i = 2; i < polygon.count; i++) {
        const struct clip_corner *part[3] = {&polygon.corner[0], &polygon.corner[i - 1],
                                             &polygon.corner[i]};
        add_part(a, to, face, part);
    }
}

/* ---- Batches and blocks of faces ---- */

/* Those that may be drawn, in their order; without a branch, see batch.c. */
static size_t list_drawn(const struct batch *batch, uint32_t list[BATCH_SIZE]) {
    size_t count = 0;
    for (uint32_t at = 0; at < batch->count; at++) {
        list[count] = at;
        count += batch->kind[at] >= TRIANGLE_CLIPPED;
    }
    return count;
}

/* Add the faces of a batch from `first_face` on, or count why they need not be drawn. */
static void add_batch(const struct assembly *a, struct output *to, const struct batch *batch,
                      size_t first_face) {
    uint32_t list[BATCH_SIZE];
    size_t count = list_drawn(batch, list);
    for (size_t at = 0; at < batch->count; at++) {
        count_left_out(to->block, (enum triangle_kind)batch->kind[at]);
    }
    for (size_t i = 0; i < count; i++) {
        size_t face = first_face + list[i];
        if (batch->kind[list[i]] == TRIANGLE_CLIPPED) {
            add_clipped_face(a, to, face);
        } else {
            const struct corner *corner = a->draw->call.model->faces[face].corner;
            const double *depths = a->vertices.depth;
            const double depth[3] = {depths[corner[0].position], depths[corner[1].position],
                                     depths[corner[2].position]};
            add_piece(to, batch, list[i], face, NOT_CLIPPED, depth);
        }
    }
}

/* Constant where it is called: see batch_put(). */
LANES_INLINE void fill_batch(struct batch *batch, const struct assembly *a, struct range faces,
                             bool inside) {
    const struct face *face = a->draw->call.model->faces;
    batch->count = 0;
    for (size_t i = faces.begin; i < faces.end; i++) {
        batch_put(batch, a, face[i].corner, inside);
    }
}

/* Can the batch of faces in that place be left out: outside the view, or hidden by the rounds
 * before this one? Then its faces are counted. */
static bool leave_out_batch(const struct assembly *a, const struct screen_place *place,
                            size_t faces, uint64_t stats[PIPELINE_STATS]) {
    bool outside = place_is_empty(place);
    bool hidden = a->draw->round > 0 && pipeline_is_hidden(a->pipeline, place);
    stats[STAT_FACES_OUTSIDE] += outside ? faces : 0;
    stats[STAT_FACES_HIDDEN] += hidden ? faces : 0;
    stats[STAT_FACES_BEHIND] += hidden ? faces : 0;
    return outside || hidden;
}

static void assemble_block(void *context, size_t index, size_t worker) {
    (void)worker;
    const struct assembly *a = context;
    const struct pipeline *p = a->pipeline;
    struct block *block = (struct block *)p->blocks.data + a->draw->first_block + index;
    size_t bands = band_count(p);
    struct output to = {
        .block = block,
        .pieces = (struct piece *)p->pieces.data + block->first_piece,
        .piece_bands = (struct band_span *)p->piece_bands.data + block->first_piece,
        .clipped = (struct clipped_corners *)p->clipped.data + block->first_clipped,
        .band_counts = (uint32_t *)p->band_counts.data + (a->draw->first_block + index) * bands,
        .hiding = a->draw->round > 0 ? p : NULL,
        .draw = (uint32_t)(a->draw - (const struct draw *)p->draws.data),
    };
    memset(to.band_counts, 0, bands * sizeof *to.band_counts);
    struct range block_faces = block_range(index, a->draw->call.model->face_count);
    const struct boxes *boxes =
        a->draw->has_boxes ? (const struct boxes *)p->boxes.data + a->draw->first_boxes : NULL;
    struct screen_place place[TOGETHER];
    struct batch batch = {.count = 0};
    for (size_t i = 0; i * BATCH_SIZE < block_faces.end - block_faces.begin; i++) {
        struct range faces = batch_range(block_faces, i);
        if (boxes != NULL && i % TOGETHER == 0) {
            pipeline_place(&a->draw->call, &boxes[faces.begin / BATCH_SIZE / TOGETHER], place);
        }
        if (boxes != NULL &&
            leave_out_batch(a, &place[i % TOGETHER], faces.end - faces.begin, block->stats)) {
            continue;
        }
        if (a->beyond == 0) {
            fill_batch(&batch, a, faces, true);
        } else {
            fill_batch(&batch, a, faces, false);
        }
        batch_classify(&batch, &a->draw->call, p->skip);
        add_batch(a, &to, &batch, faces.begin);
    }
}

/* How many pieces the faces of a block may need, counted into `block`. */
static void count_pieces(const struct assembly *a, struct range faces, struct block *block) {
    for (size_t face = faces.begin; face < faces.end; face++) {
        struct face_beyond beyond = find_face_beyond(a, a->draw->call.model->faces[face].corner);
        bool outside = (beyond.all & BEYOND_ONE_SIDE) != 0;
        bool cut = (beyond.any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0;
        if (!outside && cut) {
            size_t corners = clip_face(a, face).count;
            block->clipped_count += corners > 2 ? corners - 2 : 0;
        }
        block->piece_count += !outside && !cut;
    }
    block->piece_count += block->clipped_count;
}

/* Give each block of the draw call its part of `pieces` and `clipped`. */
static bool lay_out_blocks(struct pipeline *p, const struct assembly *a, struct error *error) {
    const struct draw *draw = a->draw;
    size_t face_count = draw->call.model->face_count;
    bool clips = (a->beyond & (BEYOND_NEAR | BEYOND_GUARD_BAND)) != 0; /* some face, perhaps */
    struct block *blocks = p->blocks.data;
    size_t pieces = p->piece_end, clipped = p->clipped_end;
    for (size_t i = 0; i < draw->block_count; i++) {
        struct block *block = &blocks[draw->first_block + i];
        struct range faces = block_range(i, face_count);
        *block = (struct block){.columns = {INT_MAX, 0}, .rows = {INT_MAX, 0}};
        if (clips) {
            count_pieces(a, faces, block);
        } else {
            block->piece_count = faces.end - faces.begin;
        }
        block->first_piece = pieces;
        block->first_clipped = clipped;
        pieces += block->piece_count;
        clipped += block->clipped_count;
        block->piece_count = block->clipped_count = 0; /* so far */
    }
    if (pieces >= UINT32_MAX) {
        return error_set(error, "more than %lu triangles in one frame", (unsigned long)UINT32_MAX);
    }
    if (!buffer_reserve(&p->pieces, pieces, sizeof(struct piece), error) ||
        !buffer_reserve(&p->piece_bands, pieces, sizeof(struct band_span), error) ||
        !buffer_reserve(&p->clipped, clipped, sizeof(struct clipped_corners), error)) {
        return false;
    }
    p->piece_end = pieces;
    p->clipped_end = clipped;
    return true;
}

/* What the blocks of a draw call have counted. */
static void add_up_blocks(struct pipeline *p, struct draw *draw) {
    const struct block *blocks = p->blocks.data;
    draw->place.columns = draw->place.rows = (struct span){INT_MAX, 0};
    for (size_t i = draw->first_block; i < draw->first_block + draw->block_count; i++) {
        draw->place.columns = span_around(draw->place.columns, blocks[i].columns);
        draw->place.rows = span_around(draw->place.rows, blocks[i].rows);
        for (int stat = 0; stat < PIPELINE_STATS; stat++) {
            p->stats[stat] += blocks[i].stats[stat];
        }
    }
}

/* ---- A round ---- */

/* The draw calls of a round that are not hidden. */
struct round {
    struct assembly *assembly;
    size_t count;
    size_t first_block; /* of those with faces */
    size_t vertex_blocks, positions;
};

/* Rounded up, so that TOGETHER of them can be written at once. */
static size_t room_for_positions(const struct draw *draw) {
    return (draw->call.model->position_count + TOGETHER - 1) / TOGETHER * TOGETHER;
}

/* Add a draw call to the round, and its share to all that must be allocated. */
static void add_draw(struct round *round, struct pipeline *p, struct draw *draw) {
    const struct model *model = draw->call.model;
    struct assembly *assembly = &round->assembly[round->count++];
    *assembly = (struct assembly){
        .pipeline = p,
        .draw = draw,
        .first_position = round->positions,
        .first_vertex_block = round->vertex_blocks,
        .guard_band = guard_band_of(&draw->call.viewport),
    };
    draw->first_block = p->block_end;
    draw->block_count = (model->face_count + BLOCK_SIZE - 1) / BLOCK_SIZE;
    draw->first_recip_w = p->recip_w_end;
    round->positions += room_for_positions(draw);
    round->vertex_blocks += (model->position_count + BLOCK_SIZE - 1) / BLOCK_SIZE;
    p->block_end += draw->block_count;
    p->recip_w_end += room_for_positions(draw);
    p->stats[STAT_VERTICES_TRANSFORMED] += model->position_count;
}

/* Find the draw calls that are not hidden, and count those that are. */
static bool list_draws(const struct frame *frame, struct round *round, struct error *error) {
    struct pipeline *p = frame->pipeline;
    const struct draw_order *order = p->order.data;
    size_t most = frame->draws.end - frame->draws.begin;
    if (!buffer_reserve(&p->assemblies, most, sizeof(struct assembly), error)) {
        return false;
    }
    *round = (struct round){.assembly = p->assemblies.data, .first_block = p->block_end};
    for (size_t i = frame->draws.begin; i < frame->draws.end; i++) {
        struct draw *draw = (struct draw *)p->draws.data + order[i].draw;
        draw->round = frame->round;
        if (frame->round > 0 && pipeline_is_hidden(p, &draw->place)) {
            p->stats[STAT_OBJECTS_HIDDEN]++;
            p->stats[STAT_FACES_HIDDEN] += draw->call.model->face_count;
            p->stats[STAT_FACES_BEHIND] += draw->call.model->face_count;
        } else {
            add_draw(round, p, draw);
        }
    }
    return true;
}

/* Room for all positions and blocks of the round. */
static bool reserve_round(struct pipeline *p, struct round *round, struct error *error) {
    if (!buffer_reserve(&p->screens, round->positions, sizeof(struct fixed2), error) ||
        !buffer_reserve(&p->depths, round->positions, sizeof(double), error) ||
        !buffer_reserve(&p->beyonds, round->positions, sizeof(uint8_t), error) ||
        !buffer_reserve(&p->recip_w, p->recip_w_end, sizeof(double), error) ||
        !buffer_reserve(&p->blocks, p->block_end, sizeof(struct block), error) ||
        !buffer_reserve(&p->band_counts, p->block_end * band_count(p), sizeof(uint32_t), error)) {
        return false;
    }
    for (size_t i = 0; i < round->count; i++) {
        struct assembly *a = &round->assembly[i];
        a->vertices = (struct vertices){
            .screen = (struct fixed2 *)p->screens.data + a->first_position,
            .depth = (double *)p->depths.data + a->first_position,
            .recip_w = (double *)p->recip_w.data + a->draw->first_recip_w,
            .beyond = (uint8_t *)p->beyonds.data + a->first_position,
        };
    }
    return true;
}

/* The round's first block of a draw call: of positions, or of faces. */
static size_t first_of(const struct round *round, const struct assembly *a, bool faces) {
    return faces ? a->draw->first_block - round->first_block : a->first_vertex_block;
}

/* Whose block it is: of the last draw call that begins with it, or before. (One that has no block
 * begins with the next one's.) */
static struct assembly *find_assembly(const struct round *round, size_t block, bool faces) {
    size_t first = 0, end = round->count;
    while (end - first > 1) {
        size_t middle = first + (end - first) / 2;
        bool is_after = first_of(round, &round->assembly[middle], faces) > block;
        first = is_after ? first : middle;
        end = is_after ? middle : end;
    }
    return &round->assembly[first];
}

/* Blocks of all draw calls are shared out together: who waited for the other threads after each
 * small object would do so most of the time. */

static void transform_any_block(void *context, size_t index, size_t worker) {
    struct assembly *a = find_assembly(context, index, false);
    transform_block(a, index - first_of(context, a, false), worker);
}

static void assemble_any_block(void *context, size_t index, size_t worker) {
    struct assembly *a = find_assembly(context, index, true);
    assemble_block(a, index - first_of(context, a, true), worker);
}

bool pipeline_assemble_round(const struct frame *frame, struct error *error) {
    struct pipeline *p = frame->pipeline;
    struct round round;
    if (!list_draws(frame, &round, error) || !reserve_round(p, &round, error)) {
        return false;
    }
    pipeline_run(p, round.vertex_blocks, transform_any_block, &round);
    for (size_t i = 0; i < round.count; i++) {
        if (!lay_out_blocks(p, &round.assembly[i], error)) {
            return false;
        }
    }
    pipeline_run(p, p->block_end - round.first_block, assemble_any_block, &round);
    for (size_t i = 0; i < round.count; i++) {
        add_up_blocks(p, round.assembly[i].draw);
    }
    return true;
}
