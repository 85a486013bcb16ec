/*
 * Transform and assemble: a round of draw calls becomes pieces, triangles on the screen, and each
 * piece is listed in the bands that it reaches. See pipeline.h.
 *
 * The round's calls are cut into blocks, and threads go through all blocks twice. First they
 * transform the positions of a block, each one once, however many faces share it, and note which
 * sides of the view it is beyond. Then they classify the faces of a block, a batch at a time: faces
 * off screen, culled or between pixel centres are only counted, those that leave the view are
 * clipped, and the others become pieces. At last the block sorts its pieces into bands.
 *
 * The pieces keep the order of the faces, whichever thread made them, and a piece is the same to
 * the last bit whichever corner of its face the model lists first.
 */
#include "pipeline.h"

/* Faces are not clipped at the sides of the viewport but at the guard band, NDC -64..64, which few
 * faces reach. For large viewports it is narrower, 2^16 pixels to each side of the middle: then no
 * edge is longer than 2^25 steps of 1/256 pixel, and a double holds all values of an edge function
 * exactly. */
static double guard_band_of(const struct rectangle *viewport) {
    int side = viewport->width > viewport->height ? viewport->width : viewport->height;
    return fmin(64, 0x1p17 / side);
}

/* Positions with a depth beyond this are not drawn: sums of such depths might overflow. */
static const double depth_limit = 1e280;

/* ---- Positions ---- */

/* TOGETHER positions in clip space. */
struct clip_positions {
    doubles x, y, z, w;
};

/* One position, TOGETHER times. */
LANES_INLINE struct clip_positions clip_positions_all(struct vec4 p) {
    return (struct clip_positions){doubles_all(p.x), doubles_all(p.y), doubles_all(p.z),
                                   doubles_all(p.w)};
}

/* TOGETHER positions on the screen; 0 where one has no place there. */
struct screen_positions {
    ints x, y; /* in 1/256 pixel */
    doubles depth, recip_w;
    longs placed; /* a mask: has a place */
};

/* The value where the mask is set, otherwise 0. */
LANES_INLINE doubles doubles_where(longs mask, doubles value) {
    return (doubles)(mask & (longs)value);
}

/* The sides of the view that each position is beyond. Each test is negated, so that NaN is beyond
 * all of them. */
LANES_INLINE longs find_beyond(const struct clip_positions *p, double guard_band) {
    doubles guard = guard_band * p->w;
    longs in_guard_band = (doubles_abs(p->x) <= guard) & (doubles_abs(p->y) <= guard);
    return (~(p->x >= -p->w) & BEYOND_LEFT) | (~(p->x <= p->w) & BEYOND_RIGHT) |
           (~(p->y >= -p->w) & BEYOND_BOTTOM) | (~(p->y <= p->w) & BEYOND_TOP) |
           (~(p->w >= NEAR_W) & BEYOND_NEAR) | (~in_guard_band & BEYOND_GUARD_BAND);
}

/* Round screen coordinates within SCREEN_LIMIT to the nearest 1/256 pixel, halves up. */
LANES_INLINE ints snap(doubles screen) {
    doubles place = screen * SUBPIXELS + 0.5;
    /* The conversion rounds towards 0. Where that was up, go one down. */
    doubles whole = __builtin_convertvector(__builtin_convertvector(place, ints), doubles);
    whole -= doubles_where(whole > place, doubles_all(1));
    return __builtin_convertvector(whole, ints);
}

/* Project the wanted positions to the screen. */
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

/* Transform position `at` of the model and the next ones to clip space, with the sums of
 * mat4_point(). Past the end, the last position is repeated. */
LANES_INLINE struct clip_positions transform(const struct draw_call *call, size_t at) {
    const struct model *model = call->model;
    const double(*m)[4] = call->to_clip.m;
    const size_t last = model->position_count - 1;
    doubles x = {0}, y = {0}, z = {0};
    for (size_t i = 0; i < TOGETHER; i++) {
        const struct vec3 *position = &model->positions[at + i < last ? at + i : last];
        x[i] = position->x;
        y[i] = position->y;
        z[i] = position->z;
    }
    return (struct clip_positions){
        .x = m[0][0] * x + m[0][1] * y + m[0][2] * z + m[0][3],
        .y = m[1][0] * x + m[1][1] * y + m[1][2] * z + m[1][3],
        .z = m[2][0] * x + m[2][1] * y + m[2][2] * z + m[2][3],
        .w = m[3][0] * x + m[3][1] * y + m[3][2] * z + m[3][3],
    };
}

/* The block's range of the `count` positions, or faces, of its call. */
static struct index_range block_range(const struct block *block, size_t count) {
    size_t end = block->begin + BLOCK_SIZE < count ? block->begin + BLOCK_SIZE : count;
    return (struct index_range){block->begin < end ? block->begin : end, end};
}

static void transform_block(void *context, size_t index, size_t worker) {
    (void)worker;
    struct frame *frame = context;
    const struct block *block = &frame->blocks[frame->round_block + index];
    struct recorded_call *recorded = block->call;
    const struct draw_call call = recorded->call; /* a copy: the compiler knows that it stays */
    const struct index_range range = block_range(block, call.model->position_count);
    const double guard_band = recorded->guard_band;
    struct screen_position *to = frame->positions + recorded->first_position;
    double *recip_w = frame->recip_w + recorded->first_position;
    uint8_t *beyonds = frame->beyonds + recorded->first_position;
    longs any = {0};
    for (size_t at = range.begin; at < range.end; at += TOGETHER) {
        struct clip_positions clip = transform(&call, at);
        longs beyond = find_beyond(&clip, guard_band);
        longs may_be_placed = (beyond & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0;
        struct screen_positions found = project(&clip, may_be_placed, &call.viewport);
        beyond |= may_be_placed & ~found.placed & BEYOND_ALL;
        any |= beyond;
        memcpy(recip_w + at, &found.recip_w, sizeof found.recip_w);
        for (size_t i = 0; i < TOGETHER; i++) {
            to[at + i] = (struct screen_position){{found.x[i], found.y[i]}, found.depth[i]};
            beyonds[at + i] = (uint8_t)beyond[i];
        }
    }
    for (int i = 0; i < TOGETHER; i++) {
        atomic_fetch_or_explicit(&recorded->beyond, (unsigned)any[i], memory_order_relaxed);
    }
}

/* ---- Pieces ---- */

/* Room for that many pieces more. */
static bool reserve_pieces(struct block *block, size_t count) {
    return array_extend(&block->pieces, &block->piece_capacity, block->piece_count + count,
                        sizeof *block->pieces) &&
           array_extend(&block->bands, &block->band_capacity, block->piece_count + count,
                        sizeof *block->bands);
}

/* Add triangle `at` of a batch, a whole one, unless earlier rounds hide it. The corners of a piece
 * go counterclockwise from the lowest one, so that a face gives the same bits whichever corner
 * comes first. */
static void add_piece(const struct frame *frame, struct block *block, const struct batch *batch,
                      size_t at, size_t face, size_t fan_triangle, const double depth[3]) {
    struct span columns = {batch->left[at], batch->right[at] + 1};
    struct span rows = {batch->bottom[at], batch->top[at] + 1};
    if (frame->round.begin > 0) {
        const struct screen_place place = {columns, rows, nearest_of_depths(depth)};
        if (is_behind(frame, frame->chunks, &place)) {
            block->stats[STAT_FACES_HIDDEN]++;
            block->stats[STAT_FACES_BEHIND]++;
            return;
        }
    }
    const struct band_span bands = {(uint16_t)(rows.begin / BAND_HEIGHT),
                                    (uint16_t)((rows.end - 1) / BAND_HEIGHT)};
    block->bands[block->piece_count] = bands;
    struct piece *piece = &block->pieces[block->piece_count++];
    int order[3] = {batch->first[at], batch->second[at], 3 - batch->first[at] - batch->second[at]};
    for (int i = 0; i < 3; i++) {
        piece->corner[i] = (struct fixed2){batch->x[order[i]][at], batch->y[order[i]][at]};
        piece->depth[i] = depth[order[i]];
        piece->face_corner[i] = (uint8_t)order[i];
    }
    piece->face = (uint32_t)face;
    piece->fan_triangle = (uint8_t)fan_triangle;
    piece->call = (uint32_t)(block->call - frame->calls);
    piece->in_several_bands = bands.last > bands.first;
    atomic_init(&piece->shown, false);
    block->columns = span_around(block->columns, columns);
    block->rows = span_around(block->rows, rows);
}

/* Count a triangle that is not drawn, by its reason. */
static void count_left_out(struct block *block, int32_t kind) {
    block->stats[STAT_FACES_OUTSIDE] += kind == TRIANGLE_OUTSIDE;
    block->stats[STAT_FACES_TURNED_AWAY] += kind == TRIANGLE_TURNED_AWAY;
    block->stats[STAT_FACES_WITHOUT_PIXEL] += kind == TRIANGLE_WITHOUT_PIXEL;
}

/* Add triangle n of the fan that a clipped polygon is cut into: corners 0, n and n + 1. */
static void add_fan_triangle(const struct frame *frame, struct block *block, size_t face,
                             const struct polygon *polygon, size_t n) {
    const struct draw_call *call = &block->call->call;
    const size_t fan[3] = {0, n, n + 1};
    struct batch batch = {.count = 1};
    double depth[3];
    for (int i = 0; i < 3; i++) {
        struct clip_positions clip = clip_positions_all(polygon->corner[fan[i]].clip);
        struct screen_positions found = project(&clip, ~(longs){0}, &call->viewport);
        if (!found.placed[0]) {
            return;
        }
        batch.x[i][0] = found.x[0];
        batch.y[i][0] = found.y[0];
        depth[i] = found.depth[0];
    }
    batch_classify(&batch, call, frame->pipeline->skip);
    count_left_out(block, batch.kind[0]);
    if (batch.kind[0] == TRIANGLE_WHOLE) {
        add_piece(frame, block, &batch, 0, face, n, depth);
    }
}

/* Clip a face, and add the triangles that are left. There is still room for the other faces of the
 * batch afterwards. False when memory runs out. */
static bool add_clipped_face(const struct frame *frame, struct block *block, size_t face) {
    struct polygon polygon = pipeline_clip_face(block->call, face);
    if (polygon.count < 3) {
        block->stats[STAT_FACES_OUTSIDE]++;
        return true;
    }
    block->stats[STAT_FACES_CLIPPED]++;
    bool reserved = reserve_pieces(block, polygon.count + BATCH_SIZE);
    for (size_t n = 1; reserved && n + 1 < polygon.count; n++) {
        add_fan_triangle(frame, block, face, &polygon, n);
    }
    return reserved;
}

/* ---- Faces ---- */

/* Put the corners of faces on the screen into a batch. */
static void fill_corners(const struct frame *frame, struct batch *batch,
                         const struct recorded_call *call, const struct face *faces) {
    const struct screen_position *positions = frame->positions + call->first_position;
    for (size_t at = 0; at < batch->count; at++) {
        for (int i = 0; i < 3; i++) {
            struct fixed2 screen = positions[faces[at].corner[i].position].at;
            batch->x[i][at] = screen.x;
            batch->y[i][at] = screen.y;
        }
    }
}

/* Put the sides of the view that corners of faces are beyond into a batch. */
static void fill_beyonds(const struct frame *frame, struct batch *batch,
                         const struct recorded_call *call, const struct face *faces) {
    const uint8_t *beyonds = frame->beyonds + call->first_position;
    for (size_t at = 0; at < batch->count; at++) {
        const struct corner *corner = faces[at].corner;
        uint8_t a = beyonds[corner[0].position], b = beyonds[corner[1].position],
                c = beyonds[corner[2].position];
        batch->beyond_all[at] = a & b & c;
        batch->beyond_any[at] = a | b | c;
    }
}

/* List the faces of a batch that may be drawn, in their order, and count the others; without a
 * branch for a single face, for the reason that classify.c gives. */
static size_t list_drawn(struct block *block, const struct batch *batch,
                         uint32_t list[BATCH_SIZE]) {
    size_t count = 0;
    for (uint32_t at = 0; at < batch->count; at++) {
        list[count] = at;
        count += batch->kind[at] >= TRIANGLE_CLIPPED;
    }
    for (size_t at = 0; at < batch->count; at++) {
        count_left_out(block, batch->kind[at]);
    }
    return count;
}

/* Add the pieces of a batch, whose triangles are the faces from `first_face` on. False when memory
 * runs out. */
static bool add_batch(const struct frame *frame, struct block *block, const struct batch *batch,
                      size_t first_face) {
    const struct recorded_call *call = block->call;
    const struct screen_position *positions = frame->positions + call->first_position;
    uint32_t list[BATCH_SIZE];
    size_t count = list_drawn(block, batch, list);
    bool reserved = reserve_pieces(block, count);
    for (size_t i = 0; reserved && i < count; i++) {
        size_t face = first_face + list[i];
        if (batch->kind[list[i]] == TRIANGLE_CLIPPED) {
            reserved = add_clipped_face(frame, block, face);
        } else {
            const struct corner *c = call->call.model->faces[face].corner;
            const double depth[3] = {positions[c[0].position].depth, positions[c[1].position].depth,
                                     positions[c[2].position].depth};
            add_piece(frame, block, batch, list[i], face, 0, depth);
        }
    }
    return reserved;
}

/* ---- Pieces sorted into bands ---- */

/* List a block's pieces band by band, in their order, by a counting sort. With three bands, and
 * piece 1 in all of them:
 *
 *     sorted    0 1 3 | 1 2 | 1       pieces 0, 1, 3 reach band 0; 1, 2 reach band 1
 *     starts    0       3     5   6
 *
 * At first `starts` counts the pieces of each band. Then it holds the end of each list. The lists
 * are filled from behind, and so it holds their beginnings at last. False when memory runs out. */
static bool sort_block(const struct frame *frame, struct block *block) {
    size_t bands = band_count(frame);
    uint32_t *starts = frame->band_starts + (size_t)(block - frame->blocks) * (bands + 1);
    memset(starts, 0, (bands + 1) * sizeof *starts);
    for (size_t i = 0; i < block->piece_count; i++) {
        for (int band = block->bands[i].first; band <= block->bands[i].last; band++) {
            starts[band]++;
        }
    }
    for (size_t band = 1; band <= bands; band++) {
        starts[band] += starts[band - 1];
    }
    if (!array_extend(&block->sorted, &block->sorted_capacity, starts[bands],
                      sizeof *block->sorted)) {
        return false;
    }
    for (size_t i = block->piece_count; i-- > 0;) {
        for (int band = block->bands[i].first; band <= block->bands[i].last; band++) {
            block->sorted[--starts[band]] = (uint32_t)i;
        }
    }
    return true;
}

static void assemble_block(void *context, size_t index, size_t worker) {
    struct frame *frame = context;
    struct block *block = &frame->blocks[frame->round_block + index];
    const struct recorded_call *call = block->call;
    struct batch batch = {.count = 0}; /* beyond nothing */
    const struct face *faces = call->call.model->faces;
    struct index_range range = block_range(block, call->call.model->face_count);
    bool reserved = true;
    block->stats = frame->scratch[worker].stats;
    for (size_t first = range.begin; reserved && first < range.end; first += BATCH_SIZE) {
        batch.count = range.end - first < BATCH_SIZE ? range.end - first : BATCH_SIZE;
        fill_corners(frame, &batch, call, faces + first);
        if (call->beyond != 0) {
            fill_beyonds(frame, &batch, call, faces + first);
        }
        batch_classify(&batch, &call->call, frame->pipeline->skip);
        reserved = add_batch(frame, block, &batch, first);
    }
    block->stats[STAT_FACES_HIDDEN] += block->piece_count; /* until a band shows one */
    if (!reserved || !sort_block(frame, block)) {
        frame->exhausted = true;
    }
}

/* ---- A round ---- */

/* Add a block, with the memory of one of the last frame if there is one left. */
static bool add_block(struct frame *frame, struct recorded_call *call, size_t begin) {
    if (!array_extend(&frame->blocks, &frame->block_capacity, frame->block_count + 1,
                      sizeof *frame->blocks)) {
        return false;
    }
    struct block *block = &frame->blocks[frame->block_count++];
    if (frame->block_count > frame->blocks_made) {
        *block = (struct block){.piece_count = 0};
        frame->blocks_made++;
    }
    block->call = call;
    block->begin = begin;
    block->piece_count = 0;
    block->columns = block->rows = (struct span){INT_MAX, 0};
    return true;
}

/* Cut a call's positions and faces into blocks. */
static bool add_blocks(struct frame *frame, struct recorded_call *call) {
    size_t positions = call->call.model->position_count, faces = call->call.model->face_count;
    size_t count = positions > faces ? positions : faces;
    bool reserved = true;
    call->first_position = frame->position_count;
    call->guard_band = guard_band_of(&call->call.viewport);
    call->beyond = 0;
    call->first_block = frame->block_count;
    for (size_t begin = 0; reserved && begin < count; begin += BLOCK_SIZE) {
        reserved = add_block(frame, call, begin);
    }
    call->block_count = frame->block_count - call->first_block;
    frame->position_count += (positions + TOGETHER - 1) / TOGETHER * TOGETHER;
    frame->pipeline->stats[STAT_VERTICES_TRANSFORMED] += positions;
    return reserved;
}

/* Add the calls of the round that are not hidden, and count those that are. */
static bool add_calls(struct frame *frame, struct error *error) {
    uint64_t *stats = frame->pipeline->stats;
    frame->round_block = frame->block_count;
    for (size_t i = frame->round.begin; i < frame->round.end; i++) {
        struct recorded_call *call = frame->order[i];
        if (is_hidden(frame, &call->place)) {
            stats[STAT_CALLS_HIDDEN]++;
            stats[STAT_FACES_HIDDEN] += call->call.model->face_count;
            stats[STAT_FACES_BEHIND] += call->call.model->face_count;
        } else if (!add_blocks(frame, call)) {
            return error_out_of_memory(error);
        }
    }
    return true;
}

static bool reserve_round(struct frame *frame, struct error *error) {
    size_t starts = frame->block_count * (band_count(frame) + 1);
    return (array_extend(&frame->positions, &frame->position_capacity, frame->position_count,
                         sizeof *frame->positions) &&
            array_extend(&frame->recip_w, &frame->recip_w_capacity, frame->position_count,
                         sizeof *frame->recip_w) &&
            array_extend(&frame->beyonds, &frame->beyond_capacity, frame->position_count,
                         sizeof *frame->beyonds) &&
            array_extend(&frame->band_starts, &frame->start_capacity, starts,
                         sizeof *frame->band_starts)) ||
           error_out_of_memory(error);
}

/* Find where the round's calls are on the screen, and how many pieces all bands have, from what the
 * blocks have found. */
static bool add_up_blocks(struct frame *frame, struct error *error) {
    for (size_t i = frame->round_block; i < frame->block_count; i++) {
        const struct block *block = &frame->blocks[i];
        struct screen_place *place = &block->call->place;
        if (i == block->call->first_block) {
            place->columns = place->rows = (struct span){INT_MAX, 0};
        }
        place->columns = span_around(place->columns, block->columns);
        place->rows = span_around(place->rows, block->rows);
        frame->sorted_count += frame->band_starts[(i + 1) * (band_count(frame) + 1) - 1];
    }
    return frame->sorted_count <= INT_MAX ||
           error_set(error, "more than %d triangles in one frame", INT_MAX);
}

bool pipeline_assemble_round(struct frame *frame, struct error *error) {
    if (!add_calls(frame, error) || !reserve_round(frame, error)) {
        return false;
    }
    size_t count = frame->block_count - frame->round_block;
    workers_run(frame->workers, count, transform_block, frame);
    workers_run(frame->workers, count, assemble_block, frame);
    return frame->exhausted ? error_out_of_memory(error) : add_up_blocks(frame, error);
}
