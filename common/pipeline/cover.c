/*
 * Cover: which piece is nearest at each pixel of a band? Then the band is shaded. See pipeline.h.
 *
 * A band has a depth buffer and a visibility buffer, the piece's number at each pixel. A piece is
 * covered in its bounding box, as far as this is in the band. Three edge functions tell whether a
 * pixel's centre is inside. TOGETHER pixels of a row are tested at once, so the box is cut into
 * strips TOGETHER columns wide, from left to right, and a strip is covered from its lowest row up:
 *
 *     +---------+---------+---------+
 *     | . . . . | . . # # | # # # # |
 *     | . . . . | # # # # | # . . . |
 *     | . . # # | # # . . | . . . . |
 *     | # # . . | . . . . | . . . . |
 *     +---------+---------+---------+
 *       strip 0   strip 1   strip 2
 *
 * In a high box, each strip is covered only in the rows where an edge function may be inside: strip
 * 2 of this box has two such rows.
 *
 * Edge functions are whole numbers that a double holds exactly, so the pixels are those of
 * raster.c; a depth is computed from them, without adding up steps.
 */
#include "pipeline.h"

/* In boxes higher than this many rows it pays to find the rows in which a strip may be inside. */
enum { HIGH_BOX = 8 };

/* ---- Edges at the pixels of a box ---- */

LANES_INLINE double4 to_double4(int4 whole) {
#if LANES >= 8 && defined(__AVX2__) /* gcc 12 converts one half after the other */
    return (double4)_mm256_cvtepi32_pd((__m128i)whole);
#else
    return __builtin_convertvector(whole, double4);
#endif
}

/* The edge functions of a triangle in its box: their values at the centre of the box's pixel (0,0),
 * their steps to the next pixel, and the least value that is inside, 0 or, by the top-left rule, 1.
 * All are whole numbers that a double holds: see guard_band_of(). */
struct box_edges {
    double4 origin, dx, dy, least;
};

/* Edge i lies opposite corner i. Pixel (0,0) of the box is pixel (left,bottom) of the image. */
static struct box_edges find_box_edges(const struct fixed2 c[3], int left, int bottom) {
    int4 ax = {c[1].x, c[2].x, c[0].x}, ay = {c[1].y, c[2].y, c[0].y};
    int4 bx = {c[2].x, c[0].x, c[1].x}, by = {c[2].y, c[0].y, c[1].y};
    double4 x_distance = to_double4(bx - ax), y_distance = to_double4(by - ay);
    double4 a_right = to_double4(ax - (left * SUBPIXELS + SUBPIXELS / 2));
    double4 a_up = to_double4(ay - (bottom * SUBPIXELS + SUBPIXELS / 2));
    long4 top_left = IS_TOP_LEFT(x_distance, y_distance);
    double4 zero = {0};
    return (struct box_edges){
        .origin = y_distance * a_right - x_distance * a_up,
        .dx = y_distance * -SUBPIXELS,
        .dy = x_distance * SUBPIXELS,
        .least = VECTOR_SELECT(top_left, zero, zero + 1),
    };
}

/* The depth of a piece at a pixel is z0 + e1 k1 + e2 k2, where e1 and e2 are the exact values of
 * edge functions. (Steps from pixel to pixel would be far larger than the depth in a sliver, and so
 * would their rounding errors.) */
struct depth_slopes {
    double origin, k1, k2; /* z0, (z1 - z0) / area, (z2 - z0) / area */
};

static struct depth_slopes find_depth_slopes(const struct piece *piece, double area) {
    double scale = 1 / area;
    const double *z = piece->depth;
    return (struct depth_slopes){z[0], (z[1] - z[0]) * scale, (z[2] - z[0]) * scale};
}

LANES_INLINE doubles depths_at(const struct depth_slopes *s, doubles e1, doubles e2) {
    return s->origin + e1 * s->k1 + e2 * s->k2;
}

/* The rows of TOGETHER neighbouring strips in which a pixel may be inside all edges, counted from
 * the lowest row of the box. */
struct strip_rows {
    int32_t begin[TOGETHER], end[TOGETHER];
};

/* In a row of a strip, an edge function is greatest at one of the two ends. If even this value is
 * outside, the row is. From row to row it grows by dy, so it is 0 at the row `greatest` / -dy.
 * Where dy is positive, the rows from there on may be inside, and `begin` is this quotient, rounded
 * up; where it is negative, those before, and `end` is the quotient rounded down, plus 1.
 *
 * Rounding must not lose a row. The quotient is of whole numbers with a divisor up to 2^33, so it
 * is a whole number or more than `little` away from one, and our rounding error is smaller:
 * `little` is taken away before rounding up, and added before rounding down. */
LANES_INLINE struct strip_rows rows_of_strips(const struct box_edges *e, int row_count) {
    const double little = 0x1p-40;
    const doubles all = doubles_all(row_count), x = doubles_count() * TOGETHER;
    const doubles none = doubles_all(0);
    doubles begin = none, end = all;
    double4 per_value = -1 / e->dy;
    for (int i = 0; i < 3; i++) {
        double to_greatest = e->dx[i] > 0 ? e->dx[i] * (TOGETHER - 1) : 0;
        doubles greatest = e->origin[i] - e->least[i] + to_greatest + e->dx[i] * x;
        doubles row = greatest * per_value[i], dy = doubles_all(e->dy[i]);
        begin = dy[0] > 0 ? doubles_max(begin, row) : begin;
        end = dy[0] < 0 ? doubles_min(end, row + (1 + little)) : end;
    }
    struct strip_rows rows;
    ints first = __builtin_convertvector(doubles_min(begin + (1 - little), all), ints);
    ints behind = __builtin_convertvector(doubles_max(end, none), ints);
    memcpy(rows.begin, &first, sizeof first);
    memcpy(rows.end, &behind, sizeof behind);
    return rows;
}

/* ---- Cover: which piece is nearest at each pixel ---- */

/* What the loops over pixels do besides covering. cover_call() passes constants, so that the
 * compiler makes a loop for each case, without questions at a pixel. */
struct cover_how {
    bool reordered; /* calls come nearest first: of equal depths, find which was drawn first */
    bool counts;    /* count depth tests */
};

/* The box of a piece that is being covered. */
struct box {
    const struct piece *piece;
    uint32_t number;
    struct span columns, rows;
    bool cut;               /* the piece has pixels in other columns, which must stay */
    struct box_edges edges; /* from the next strip on */
    struct depth_slopes slopes;
    /* For each edge, in each column of a strip: what the edge function grows by from the strip's
     * first column to this one, its step to the next row, and the least value that is inside. */
    doubles right[3], up[3], least[3];
};

/* Where depths are equal: which of the old numbers belong to a call that was drawn later than the
 * piece's? This is rare, so pixels are asked one by one. */
static doubles_mask find_later(const struct call_band *band, doubles_mask equal,
                               const uint32_t *numbers, const struct piece *piece) {
    doubles later = {0};
    for (int i = 0; i < TOGETHER; i++) {
        later[i] =
            mask_is_set(equal, i) && band->scratch->pieces[numbers[i] - 1]->call > piece->call;
    }
    return mask_above(equal, later, doubles_all(0));
}

/* The depth test, for TOGETHER pixels: where the piece is `inside` and nearer, it replaces depth
 * and number. Of equal depths the first drawn stays. This is the one that is there, but with
 * `reordered` the calls must be compared. There are no branches for a single pixel: each line is an
 * instruction or two for all of them. Returns where the piece is shown now. */
LANES_INLINE doubles_mask cover_pixels(const struct call_band *band, const struct box *box,
                                       double *depths, uint32_t *numbers, doubles_mask inside,
                                       doubles z, bool reordered) {
    doubles old_z;
    ints old_number;
    memcpy(&old_z, depths, sizeof old_z);
    memcpy(&old_number, numbers, sizeof old_number);
    doubles_mask nearer = mask_above(inside, z, old_z);
    if (reordered) {
        doubles_mask equal = mask_not_below(inside, z, old_z) & ~nearer;
        if (mask_any(equal)) {
            nearer |= find_later(band, equal, numbers, box->piece);
        }
    }
    z = doubles_select(nearer, z, old_z);
    old_number = ints_select(nearer, (int32_t)box->number - (ints){0}, old_number);
    memcpy(depths, &z, sizeof z);
    memcpy(numbers, &old_number, sizeof old_number);
    return nearer;
}

/* Mark that something may be drawn in these rows of the chunk at x. */
static void touch(const struct call_band *band, int x, struct span rows) {
    uint64_t before_end = (UINT64_C(1) << (rows.end - band->rows.begin)) - 1;
    int begin = rows.begin - band->rows.begin;
    band->chunks[(size_t)x / CHUNK_WIDTH].touched |= (uint32_t)(before_end >> begin << begin);
}

/* Cover some rows of a strip, which is the TOGETHER columns from x on. */
LANES_INLINE void cover_strip(const struct call_band *band, const struct box *box, int x,
                              struct span rows, struct cover_how how) {
    double4 first = box->edges.origin + box->edges.dy * (rows.begin - box->rows.begin);
    doubles e0 = first[0] + box->right[0], e1 = first[1] + box->right[1];
    doubles e2 = first[2] + box->right[2];
    if (box->cut) {
        doubles at = doubles_count() + x;
        doubles_mask within = mask_not_below(mask_all(), at, doubles_all(box->columns.begin));
        within = mask_above(within, doubles_all(box->columns.end), at);
        e0 = doubles_select(within, e0, doubles_all(-INFINITY));
    }
    struct chunk *chunk = &band->chunks[(size_t)x / CHUNK_WIDTH];
    const size_t row = (size_t)(rows.begin - band->rows.begin), column = (size_t)x % CHUNK_WIDTH;
    double *depths = &chunk->depth[row][column];
    uint32_t *numbers = &chunk->number[row][column];
    for (int y = rows.begin; y < rows.end; y++) {
        doubles_mask inside = mask_not_below(mask_all(), e0, box->least[0]);
        inside = mask_not_below(inside, e1, box->least[1]);
        inside = mask_not_below(inside, e2, box->least[2]);
        doubles z = depths_at(&box->slopes, e1, e2);
        doubles_mask nearer = cover_pixels(band, box, depths, numbers, inside, z, how.reordered);
        if (how.counts) {
            band->stats[STAT_PIXELS_COVERED] += mask_count(inside);
            band->stats[STAT_PIXELS_PASSED] += mask_count(nearer);
        }
        e0 += box->up[0];
        e1 += box->up[1];
        e2 += box->up[2];
        depths += CHUNK_WIDTH;
        numbers += CHUNK_WIDTH;
    }
    touch(band, x, rows);
}

/* Cover the strips of a box, from left to right; in a high box only the rows of a strip that may be
 * inside. */
LANES_INLINE void cover_strips(const struct call_band *band, struct box *box, int left,
                               struct cover_how how) {
    int row_count = box->rows.end - box->rows.begin, bottom = box->rows.begin, x = left;
    if (row_count <= HIGH_BOX) {
        for (; x < box->columns.end; x += TOGETHER) {
            cover_strip(band, box, x, box->rows, how);
            box->edges.origin += box->edges.dx * TOGETHER;
        }
        return;
    }
    while (x < box->columns.end) {
        struct strip_rows strips = rows_of_strips(&box->edges, row_count);
        for (int i = 0; i < TOGETHER && x < box->columns.end; i++, x += TOGETHER) {
            struct span rows = {bottom + strips.begin[i], bottom + strips.end[i]};
            if (rows.begin < rows.end) {
                cover_strip(band, box, x, rows, how);
            }
            box->edges.origin += box->edges.dx * TOGETHER;
        }
    }
}

/* ---- Hierarchical z: the farthest depth of a tile ---- */

/* Cut rows of the image to the band, and count them from its lowest row. */
static struct span rows_in_band(const struct call_band *band, struct span rows) {
    rows = span_overlap(rows, band->rows);
    return (struct span){rows.begin - band->rows.begin, rows.end - band->rows.begin};
}

/* Find the farthest depth of a tile in a chunk; minus infinity as long as a row is empty. Pixels
 * beyond the image do not count. */
static double find_farthest(const struct call_band *band, int index, int tile) {
    const struct chunk *chunk = &band->chunks[index];
    double least[CHUNK_WIDTH];
    int columns = (int)band->frame->pipeline->width - index * CHUNK_WIDTH;
    int begin = tile * TILE_HEIGHT, rows = band->rows.end - band->rows.begin - begin;
    uint32_t all = (UINT32_C(1) << (rows < TILE_HEIGHT ? rows : TILE_HEIGHT)) - 1;
    if ((chunk->touched >> begin & all) != all) {
        return -INFINITY;
    }
    const double *depth = chunk->depth[begin];
    for (int i = 0; i < CHUNK_WIDTH; i++) {
        least[i] = INFINITY;
    }
    for (int row = 0; row < rows && row < TILE_HEIGHT; row++) {
        for (int i = 0; i < CHUNK_WIDTH; i++) {
            least[i] = depth[i] < least[i] ? depth[i] : least[i];
        }
        depth += CHUNK_WIDTH;
    }
    for (int i = 1; i < CHUNK_WIDTH && i < columns; i++) {
        least[0] = least[i] < least[0] ? least[i] : least[0];
    }
    return least[0];
}

/* Find the farthest depths again, after a call, in the tiles that it may have changed. */
static void update_farthest(const struct call_band *band) {
    struct span columns = band->columns, rows = rows_in_band(band, band->changed_rows);
    for (int x = columns.begin / CHUNK_WIDTH; x * CHUNK_WIDTH < columns.end; x++) {
        for (int tile = rows.begin / TILE_HEIGHT; tile * TILE_HEIGHT < rows.end; tile++) {
            band->chunks[x].farthest[tile] = find_farthest(band, x, tile);
        }
    }
}

/* ---- The pieces of a call ---- */

/* Cover a piece in its bounding box, unless it is behind all that is there. Strip by strip, because
 * a processor predicts badly where the rows of a triangle end. */
LANES_INLINE void cover_piece(struct call_band *band, uint32_t number, struct cover_how how) {
    const struct piece *piece = band->scratch->pieces[number - 1];
    const struct fixed2 *c = piece->corner;
    const struct rectangle *v = &band->call->call.viewport;
    struct span whole = box_centers(c[0].x, c[1].x, c[2].x);
    struct box box = {.piece = piece, .number = number};
    box.columns = span_overlap(whole, columns_of(v));
    box.rows = span_overlap(box_centers(c[0].y, c[1].y, c[2].y), rows_of(v));
    box.rows = span_overlap(box.rows, band->rows);
    box.cut = box.columns.begin > whole.begin || box.columns.end < whole.end;
    if (how.reordered) {
        const struct screen_place place = {box.columns, rows_in_band(band, box.rows),
                                           nearest_of_depths(piece->depth)};
        if (is_behind(band->frame, band->chunks, &place)) {
            band->stats[STAT_FACES_BEHIND]++;
            return;
        }
        band->columns = span_around(band->columns, box.columns);
        band->changed_rows = span_around(band->changed_rows, box.rows);
    }
    int left = box.columns.begin & -TOGETHER;
    struct box_edges e = box.edges = find_box_edges(c, left, box.rows.begin);
    box.slopes = find_depth_slopes(piece, e.origin[0] + e.origin[1] + e.origin[2]);
    for (int i = 0; i < 3; i++) {
        box.right[i] = e.dx[i] * doubles_count();
        box.up[i] = doubles_all(e.dy[i]);
        box.least[i] = doubles_all(e.least[i]);
    }
    cover_strips(band, &box, left, how);
}

/* Cover the pieces of a call in the band. */
LANES_INLINE void cover_pieces(struct call_band *band, struct cover_how how) {
    enum { AHEAD = 8 }; /* so that the memory is asked for a piece before it is covered */
    for (int i = band->numbers.begin; i < band->numbers.end; i++) {
        if (i + AHEAD < band->numbers.end) {
            __builtin_prefetch(band->scratch->pieces[i + AHEAD]);
        }
        cover_piece(band, (uint32_t)i + 1, how);
    }
}

/* Shade what is visible of the pieces that have numbers. */
static void shade(const struct call_band *band) {
    const struct shader *shader = band->call->shader;
    if (shader->shade != NULL) {
        shader->shade(band);
    } else {
        shade_visible(band, shader);
    }
}

/* Keep what is visible in some rows of the columns, so that it can come back where pixels are
 * discarded. */
static void keep_before(const struct call_band *band, struct span rows) {
    int begin = rows.begin - band->rows.begin;
    size_t count = (size_t)(rows.end - rows.begin) * CHUNK_WIDTH;
    for (int x = band->columns.begin / CHUNK_WIDTH; x * CHUNK_WIDTH < band->columns.end; x++) {
        const struct chunk *now = &band->chunks[x];
        struct chunk *before = &band->scratch->before[x];
        memcpy(before->depth[begin], now->depth[begin], count * sizeof now->depth[0][0]);
        memcpy(before->number[begin], now->number[begin], count * sizeof now->number[0][0]);
    }
}

/* Cover and shade the pieces of a call one by one: each is shaded before the next one is
 * covered. */
static void draw_pieces(struct call_band *band) {
    const struct span numbers = band->numbers;
    const struct cover_how how = {false, band->frame->pipeline->counts_tests};
    for (int i = numbers.begin; i < numbers.end; i++) {
        const struct fixed2 *c = band->scratch->pieces[i]->corner;
        band->numbers = (struct span){i, i + 1};
        band->columns = span_overlap(box_centers(c[0].x, c[1].x, c[2].x),
                                     columns_of(&band->call->call.viewport));
        if (band->call->shader->discards) {
            keep_before(band, span_overlap(box_centers(c[0].y, c[1].y, c[2].y), band->rows));
        }
        cover_piece(band, (uint32_t)i + 1, how);
        band->scratch->is_visible[i + 1] = true;
        shade(band);
    }
}

static void cover_call(struct call_band *band) {
    const struct cover_how how = {band->frame->reordered, band->frame->pipeline->counts_tests};
    if (shades_at_once(band->frame, band->call->shader)) {
        draw_pieces(band);
    } else if (how.counts) {
        cover_pieces(band, how);
    } else if (how.reordered) {
        cover_pieces(band, (struct cover_how){true, false});
    } else {
        cover_pieces(band, (struct cover_how){false, false});
    }
}

/* ---- A band ---- */

/* Mark the pieces that some pixel of the band shows. */
static void mark_visible(const struct call_band *band) {
    bool *is_visible = band->scratch->is_visible;
    memset(is_visible, 0, ((size_t)band->numbers.end + 1) * sizeof *is_visible);
    for (size_t i = 0; i < chunk_count(band->frame); i++) {
        const uint32_t *number = band->chunks[i].number[0];
        for (uint32_t rows = band->chunks[i].touched; rows != 0; rows >>= 1) {
            for (int k = 0; (rows & 1) != 0 && k < CHUNK_WIDTH; k++) {
                is_visible[number[k]] = true;
            }
            number += CHUNK_WIDTH;
        }
    }
}

static void keep_depth(const struct call_band *band) {
    const struct pipeline *p = band->frame->pipeline;
    for (int y = band->rows.begin; y < band->rows.end; y++) {
        for (size_t x = 0; x < p->width; x++) {
            p->depth[(size_t)y * p->width + x] =
                band->chunks[x / CHUNK_WIDTH].depth[y - band->rows.begin][x % CHUNK_WIDTH];
        }
    }
}

/* Clear the band's rows of the image. This is done here because the shaders write to them next, and
 * find them in the cache. */
static void clear_image(const struct call_band *band) {
    const struct image *image = band->frame->image;
    size_t row_size = image->width * image->format;
    memset(image->pixels + (size_t)band->rows.begin * row_size, 0,
           (size_t)(band->rows.end - band->rows.begin) * row_size);
}

/* Make the call at that place in the order the band's current one, and number its pieces behind
 * those of the calls before it. False where it has none in the band. */
static bool next_call(struct call_band *band, size_t place) {
    const struct frame *frame = band->frame;
    const struct recorded_call *call = frame->order[place];
    size_t bands = band_count(frame), index = (size_t)band->rows.begin / BAND_HEIGHT;
    struct piece **next = band->scratch->pieces + band->numbers.end;
    for (size_t i = call->first_block; i < call->first_block + call->block_count; i++) {
        const struct block *block = &frame->blocks[i];
        const uint32_t *start = frame->band_starts + i * (bands + 1) + index;
        for (uint32_t k = start[0]; k < start[1]; k++) {
            *next++ = &block->pieces[block->sorted[k]];
        }
    }
    band->call = call;
    band->uniforms = frame->uniforms + call->uniforms;
    band->numbers = (struct span){band->numbers.end, (int)(next - band->scratch->pieces)};
    return band->numbers.begin < band->numbers.end;
}

/* Cover the pieces of the round's calls in the band. Pieces of earlier rounds are only numbered. */
static void cover_calls(struct call_band *band) {
    struct index_range round = band->frame->round;
    for (size_t i = 0; i < round.end; i++) {
        if (next_call(band, i) && i >= round.begin) {
            band->columns = band->changed_rows = (struct span){INT_MAX, 0};
            cover_call(band);
            if (band->frame->reordered) {
                update_farthest(band);
            }
        }
    }
}

/* Shade the visible pixels of all calls in the band. */
static void shade_calls(struct call_band *band) {
    band->numbers.end = 0;
    for (size_t i = 0; i < band->frame->order_count; i++) {
        if (next_call(band, i) && !shades_at_once(band->frame, band->call->shader)) {
            band->columns = band->call->place.columns;
            shade(band);
        }
    }
}

static struct call_band begin_band(struct frame *frame, size_t index, size_t worker) {
    int bottom = (int)index * BAND_HEIGHT, height = (int)frame->pipeline->height;
    return (struct call_band){
        .frame = frame,
        .rows = {bottom, height - bottom < BAND_HEIGHT ? height : bottom + BAND_HEIGHT},
        .chunks = frame->chunks + (frame->kept ? index : worker) * chunk_count(frame),
        .scratch = &frame->scratch[worker],
        .stats = frame->scratch[worker].stats,
    };
}

void pipeline_cover_band(void *context, size_t index, size_t worker) {
    struct call_band band = begin_band(context, index, worker);
    cover_calls(&band);
}

void pipeline_draw_band(void *context, size_t index, size_t worker) {
    struct frame *frame = context;
    struct call_band band = begin_band(frame, index, worker);
    if (frame->pipeline->clears_image) {
        clear_image(&band);
    }
    cover_calls(&band);
    mark_visible(&band);
    shade_calls(&band);
    if (frame->pipeline->depth != NULL) {
        keep_depth(&band);
    }
    for (size_t i = 0; i < chunk_count(frame); i++) {
        chunk_clear(&band.chunks[i]);
    }
}
