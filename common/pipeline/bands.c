/* The pixels of a frame, band by band: cover, then shade. See pipeline.h. */
#include "pipeline.h"

#include "pipeline/parts.h"

/* ---- Cover: which piece is nearest at each pixel ---- */

/* In boxes higher than this many pixels it pays to ask in which rows a strip lies outside. */
enum { HIGH_BOX = 8 };

/* A band that is being covered. */
struct band {
    const struct pipeline *pipeline;
    size_t index;
    struct visibility *visibility;
    struct span rows;
    bool reordered;                            /* the nearest draw calls are covered first: */
    struct span changed_columns, changed_rows; /* where pieces of the draw call were covered */
    uint64_t behind;
    uint64_t covered, passed; /* depth tests */
};

/* Mark that something may be drawn in these rows of the columns from x on. */
static void touch(const struct band *band, int x, struct span rows) {
    int begin = rows.begin - band->rows.begin, end = rows.end - band->rows.begin;
    uint64_t before_end = (UINT64_C(1) << end) - 1;
    band->visibility->touched[x / CHUNK] |= (uint32_t)(before_end >> begin << begin);
}

/* The draw call of a piece of the band. */
static uint32_t draw_of_number(const struct band *band, uint32_t number) {
    const struct pipeline *p = band->pipeline;
    const struct bin *bins = p->bins.data;
    size_t bands = band_count(p), bin = band->index;
    while (number > bins[bin].number + bins[bin].count) {
        bin += bands;
    }
    const uint32_t *binned = (const uint32_t *)p->binned.data + bins[bin].first;
    return ((const struct piece *)p->pieces.data)[binned[number - bins[bin].number - 1]].draw;
}

/* Where depths are equal: which of the old numbers are of a draw call that was drawn later than
 * that? Rare, so one by one. */
static doubles_mask find_later(const struct band *band, doubles_mask equal, const uint32_t *numbers,
                               uint32_t draw) {
    doubles later = {0};
    for (int i = 0; i < TOGETHER; i++) {
        later[i] = mask_is_set(equal, i) && draw_of_number(band, numbers[i]) > draw;
    }
    return mask_above(equal, later, doubles_all(0));
}

/* What is drawn at pixels that a piece covers. */
struct shown {
    uint32_t number, draw;
};

/* The depth test. Depths and numbers of neighbours become those of the piece where it is `inside`
 * and nearer; of equal depths that of the first drawn stays: the one that is there, except with
 * `reordered`, when the draw calls are asked. Without branches: each line is an instruction or two
 * for all pixels. Returns where the piece is shown now. */
LANES_INLINE doubles_mask cover_pixels(const struct band *band, double *depths, uint32_t *numbers,
                                       doubles_mask inside, doubles z, struct shown piece,
                                       bool reordered) {
    doubles old_z;
    ints old_number;
    memcpy(&old_z, depths, sizeof old_z);
    memcpy(&old_number, numbers, sizeof old_number);
    doubles_mask nearer = mask_above(inside, z, old_z);
    if (reordered) {
        doubles_mask equal = mask_not_below(inside, z, old_z) & ~nearer;
        if (mask_any(equal)) {
            nearer |= find_later(band, equal, numbers, piece.draw);
        }
    }
    z = doubles_select(nearer, z, old_z);
    old_number = ints_select(nearer, (int32_t)piece.number - (ints){0}, old_number);
    memcpy(depths, &z, sizeof z);
    memcpy(numbers, &old_number, sizeof old_number);
    return nearer;
}

/* depth_at() for several pixels. */
LANES_INLINE doubles depths_at(const struct depth_slopes *s, doubles e1, doubles e2) {
    return s->origin + e1 * s->k1 + e2 * s->k2;
}

/* A number for each corner or edge of a triangle, and a fourth that is of no use. */
typedef double three __attribute__((vector_size(4 * sizeof(double))));
typedef int32_t three_ints __attribute__((vector_size(4 * sizeof(int32_t))));
typedef int64_t three_longs __attribute__((vector_size(4 * sizeof(int64_t))));

LANES_INLINE three three_select(three_longs mask, three a, three b) {
    return (three)((mask & (three_longs)a) + (~mask & (three_longs)b));
}

LANES_INLINE three to_three(three_ints whole) {
#if LANES >= 8 && defined(__AVX2__) /* gcc 12 converts one half after the other */
    return (three)_mm256_cvtepi32_pd((__m128i)whole);
#else
    return __builtin_convertvector(whole, three);
#endif
}

/* The edge functions at the centres of the pixels of a box: their values at its pixel (0,0), their
 * steps, and the least that is inside: 0, or 1 where 0 is not. All are whole numbers that a double
 * holds: see guard_band_of(). */
struct box_edges {
    three origin, dx, dy, least;
};

/* Edge i lies opposite corner i; pixel (0,0) of the box is (left,bottom) of the image. */
static struct box_edges find_box_edges(const struct fixed2 c[3], int left, int bottom) {
    three_ints ax = {c[1].x, c[2].x, c[0].x}, ay = {c[1].y, c[2].y, c[0].y};
    three_ints bx = {c[2].x, c[0].x, c[1].x}, by = {c[2].y, c[0].y, c[1].y};
    three x_distance = to_three(bx - ax), y_distance = to_three(by - ay);
    three a_right = to_three(ax - (left * SUBPIXELS + SUBPIXELS / 2));
    three a_up = to_three(ay - (bottom * SUBPIXELS + SUBPIXELS / 2));
    three_longs top_left = (y_distance < 0) | ((y_distance == 0) & (x_distance < 0));
    three zero = {0};
    return (struct box_edges){
        .origin = y_distance * a_right - x_distance * a_up,
        .dx = y_distance * -SUBPIXELS,
        .dy = x_distance * SUBPIXELS,
        .least = three_select(top_left, zero, zero + 1),
    };
}

/* Of TOGETHER strips of pixels beside each other, TOGETHER columns each: the rows in which some may
 * be inside all edges, from the lowest row of the box on. */
struct strip_rows {
    int32_t begin[TOGETHER], end[TOGETHER];
};

/* In a strip, the greatest value of each edge function is as much as is inside. The row where that
 * becomes 0 is a fraction of whole numbers, the lower of them up to 2^33: it is a whole number, or
 * farther from one than `little`; and what is found for it, nearer to it than that. */
LANES_INLINE struct strip_rows rows_of_strips(const struct box_edges *e, int row_count) {
    const double little = 0x1p-40;
    const doubles all = doubles_all(row_count), x = doubles_count() * TOGETHER;
    const doubles none = doubles_all(0);
    doubles begin = none, end = all;
    three per_value = -1 / e->dy;
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

/* What is done besides; constant where a function is called with it. */
struct cover_how {
    bool reordered; /* see cover_pixels() */
    bool counts;    /* depth tests */
};

/* The box of a piece that is being covered. */
struct box {
    struct span columns, rows;
    bool cut; /* the piece reaches beyond the columns */
    struct shown shown;
    struct box_edges edges; /* at the next strip */
    struct depth_slopes slopes;
    doubles right[3], up[3], least[3];
};

/* Some rows of a strip, the TOGETHER columns from x on. */
LANES_INLINE void cover_strip(struct band *band, const struct box *box, int x, struct span rows,
                              struct cover_how how) {
    const struct visibility *visibility = band->visibility;
    three first = box->edges.origin + box->edges.dy * (rows.begin - box->rows.begin);
    doubles e0 = first[0] + box->right[0], e1 = first[1] + box->right[1];
    doubles e2 = first[2] + box->right[2];
    if (box->cut) {
        doubles at = doubles_count() + x;
        doubles_mask seen = mask_not_below(mask_all(), at, doubles_all(box->columns.begin));
        seen = mask_above(seen, doubles_all(box->columns.end), at);
        e0 = doubles_select(seen, e0, doubles_all(-INFINITY));
    }
    size_t place = place_in_band(rows.begin - band->rows.begin, x);
    double *depths = visibility->depth + place;
    uint32_t *numbers = visibility->number + place;
    for (int y = rows.begin; y < rows.end; y++) {
        doubles_mask inside = mask_not_below(mask_all(), e0, box->least[0]);
        inside = mask_not_below(inside, e1, box->least[1]);
        inside = mask_not_below(inside, e2, box->least[2]);
        doubles z = depths_at(&box->slopes, e1, e2);
        doubles_mask nearer =
            cover_pixels(band, depths, numbers, inside, z, box->shown, how.reordered);
        if (how.counts) {
            band->covered += mask_count(inside);
            band->passed += mask_count(nearer);
        }
        e0 += box->up[0];
        e1 += box->up[1];
        e2 += box->up[2];
        depths += CHUNK;
        numbers += CHUNK;
    }
    touch(band, x, rows);
}

/* Its strips, one beside the other. Of high ones, only the rows where something may be inside. */
LANES_INLINE void cover_strips(struct band *band, struct box *box, int left, struct cover_how how) {
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

/* All pixels of a box, several tested at once: strip by strip, each from its lowest row on.
 * (Row by row, a processor would often be wrong about where the row ends.) `cut`: the piece reaches
 * beyond the columns. */
LANES_INLINE void cover_box(struct band *band, const struct piece *piece, struct span columns,
                            struct span rows, bool cut, uint32_t number, struct cover_how how) {
    int left = columns.begin / TOGETHER * TOGETHER;
    struct box_edges e = find_box_edges(piece->corner, left, rows.begin);
    struct box box = {
        .columns = columns,
        .rows = rows,
        .cut = cut,
        .shown = {number, piece->draw},
        .edges = e,
        .slopes = find_depth_slopes(piece, e.origin[0] + e.origin[1] + e.origin[2]),
    };
    for (int i = 0; i < 3; i++) {
        box.right[i] = e.dx[i] * doubles_count();
        box.up[i] = doubles_all(e.dy[i]);
        box.least[i] = doubles_all(e.least[i]);
    }
    cover_strips(band, &box, left, how);
}

/* ---- What is behind ---- */

/* The rows of the band, counted from its lowest one, in which something is. */
static struct span rows_in_band(const struct band *band, struct span rows) {
    rows = span_overlap(rows, band->rows);
    return (struct span){rows.begin - band->rows.begin, rows.end - band->rows.begin};
}

/* Find the farthest depth of a tile in a column of chunks; beyond the image nothing is drawn. */
static double find_farthest(const struct band *band, int chunk, int tile) {
    double least[CHUNK];
    int columns = (int)band->pipeline->width - chunk * CHUNK;
    int begin = tile * TILE_HEIGHT, rows = band->rows.end - band->rows.begin - begin;
    uint32_t all = (UINT32_C(1) << (rows < TILE_HEIGHT ? rows : TILE_HEIGHT)) - 1;
    if ((band->visibility->touched[chunk] >> begin & all) != all) {
        return -INFINITY;
    }
    const double *depth = band->visibility->depth + place_in_band(begin, chunk * CHUNK);
    for (int i = 0; i < CHUNK; i++) {
        least[i] = INFINITY;
    }
    for (int row = 0; row < rows && row < TILE_HEIGHT; row++) {
        for (int i = 0; i < CHUNK; i++) {
            least[i] = depth[i] < least[i] ? depth[i] : least[i];
        }
        depth += CHUNK;
    }
    for (int i = 1; i < CHUNK && i < columns; i++) {
        least[0] = least[i] < least[0] ? least[i] : least[0];
    }
    return least[0];
}

/* After a draw call, where it has changed something. */
static void update_farthest(const struct band *band) {
    struct span columns = band->changed_columns, rows = rows_in_band(band, band->changed_rows);
    for (int x = columns.begin / CHUNK; x * CHUNK < columns.end; x++) {
        double *farthest = band->visibility->farthest + x * BAND_TILES;
        for (int tile = rows.begin / TILE_HEIGHT; tile * TILE_HEIGHT < rows.end; tile++) {
            farthest[tile] = find_farthest(band, x, tile);
        }
    }
}

/* Is all that is no nearer than that behind what a band shows in every tile that some columns, and
 * rows of the band, reach? */
static bool is_behind(const struct visibility *band, double nearest, struct span columns,
                      struct span rows) {
    bool behind = true;
    for (int x = columns.begin / CHUNK; behind && x * CHUNK < columns.end; x++) {
        const double *farthest = band->farthest + x * BAND_TILES;
        for (int tile = rows.begin / TILE_HEIGHT; behind && tile * TILE_HEIGHT < rows.end; tile++) {
            behind = nearest < farthest[tile];
        }
    }
    return behind;
}

bool pipeline_is_hidden(const struct pipeline *p, const struct screen_place *place) {
    const struct visibility *bands = p->visibility.data;
    struct span rows = place->rows;
    bool hidden = !place_is_empty(place);
    for (int y = rows.begin; hidden && y < rows.end; y = (y / BAND_HEIGHT + 1) * BAND_HEIGHT) {
        int bottom = y / BAND_HEIGHT * BAND_HEIGHT;
        struct span band = span_overlap(rows, (struct span){bottom, bottom + BAND_HEIGHT});
        hidden = is_behind(&bands[y / BAND_HEIGHT], place->nearest, place->columns,
                           (struct span){band.begin - bottom, band.end - bottom});
    }
    return hidden;
}

LANES_INLINE void cover_piece(struct band *band, const struct draw *draw, const struct piece *piece,
                              uint32_t number, struct cover_how how) {
    const struct rectangle *v = &draw->call.viewport;
    struct span whole = columns_of(piece->corner), columns = columns_in(whole, v);
    bool cut = columns.begin > whole.begin || columns.end < whole.end;
    struct span rows = span_overlap(rows_in(rows_of(piece->corner), v), band->rows);
    if (how.reordered && is_behind(band->visibility, nearest_of_depths(piece->depth), columns,
                                   rows_in_band(band, rows))) {
        band->behind++;
    } else {
        if (how.reordered) {
            band->changed_columns = span_around(band->changed_columns, columns);
            band->changed_rows = span_around(band->changed_rows, rows);
        }
        cover_box(band, piece, columns, rows, cut, number, how);
    }
}

/* ---- A band ---- */

/* The columns of chunks that may be touched. */
static struct span chunks_of_band(const struct band *band) {
    struct span columns = band->visibility->columns;
    return (struct span){columns.begin / CHUNK, (columns.end + CHUNK - 1) / CHUNK};
}

/* Mark the pieces of LANES neighbours. In large triangles these are three runs of equal numbers, or
 * fewer: one of each is enough, and a run twice does no harm. */
static void mark_neighbours(const uint32_t number[LANES + 1], uint32_t *visible) {
    const int last = LANES - 1;
    uint32_t second = find_runs(number) & ~UINT32_C(1); /* and the later ones */
    uint32_t third = second & (second - 1), fourth = third & (third - 1);
    if (fourth == 0) {
        visible[number[0]] = 1;
        visible[number[last]] = 1;
        visible[number[__builtin_ctz(second | UINT32_C(1) << last)]] = 1;
        return;
    }
    for (int i = 0; i < LANES; i++) {
        visible[number[i]] = 1;
    }
}

/* Mark the pieces of which a pixel is visible. */
static void mark_visible(const struct band *band, const struct scratch *scratch) {
    const struct visibility *visibility = band->visibility;
    struct span chunks = chunks_of_band(band);
    for (int i = chunks.begin; i < chunks.end; i++) {
        const uint32_t *number = visibility->number + place_in_band(0, i * CHUNK);
        for (uint32_t rows = visibility->touched[i]; rows != 0; rows >>= 1) {
            for (int k = 0; (rows & 1) != 0 && k < CHUNK; k += LANES) {
                mark_neighbours(number + k, scratch->fetched);
            }
            number += CHUNK;
        }
    }
}

/* Make the band what it was: nothing is drawn. Only what was touched has changed. */
static void clear_band(const struct band *band) {
    struct visibility *visibility = band->visibility;
    struct span chunks = chunks_of_band(band);
    for (int i = chunks.begin; i < chunks.end; i++) {
        size_t place = place_in_band(0, i * CHUNK);
        for (uint32_t rows = visibility->touched[i]; rows != 0; rows >>= 1) {
            if ((rows & 1) != 0) {
                for (int k = 0; k < CHUNK; k++) {
                    visibility->depth[place + (size_t)k] = -INFINITY;
                }
                memset(visibility->number + place, 0, CHUNK * sizeof *visibility->number);
            }
            place += CHUNK;
        }
        visibility->touched[i] = 0;
        for (int tile = 0; tile < BAND_TILES; tile++) {
            visibility->farthest[i * BAND_TILES + tile] = -INFINITY;
        }
    }
    visibility->columns = (struct span){(int)band->pipeline->width, 0};
}

static void keep_depth(const struct band *band) {
    const struct pipeline *p = band->pipeline;
    for (int y = band->rows.begin; y < band->rows.end; y++) {
        for (size_t x = 0; x < p->width; x++) {
            p->depth[(size_t)y * p->width + x] =
                band->visibility->depth[place_in_band(y - band->rows.begin, (int)x)];
        }
    }
}

/* What `touched` was in a band when the last frame was done: a number for each column of chunks. */
static uint32_t *last_touched(const struct pipeline *p, size_t band) {
    return (uint32_t *)p->last_touched.data + band * chunk_columns(p);
}

/* Ask the memory for the pixels of a row some columns further on. (No processor foresees what is
 * read in columns of a large image.) They may lie behind the last ones: then nothing happens. */
static void expect_pixels(const uint8_t *pixels) {
    enum { COLUMNS_AHEAD = 4 };
    uintptr_t ahead = (uintptr_t)pixels + COLUMNS_AHEAD * CHUNK * IMAGE_BGRA;
    __builtin_prefetch((const void *)ahead, 1);
}

/* Clear what the last frame has touched in some rows of the image. */
static void clear_touched(const struct image *image, struct span rows, const uint32_t *touched) {
    for (size_t x = 0; x < image->width; x += CHUNK) {
        uint8_t *pixels = image->pixels + ((size_t)rows.begin * image->width + x) * image->format;
        size_t size = (image->width - x < CHUNK ? image->width - x : CHUNK) * image->format;
        for (uint32_t left = touched[x / CHUNK]; left != 0; left >>= 1) {
            if ((left & 1) != 0 && size == CHUNK * IMAGE_BGRA) {
                expect_pixels(pixels);
                memset(pixels, 0, CHUNK * IMAGE_BGRA); /* one instruction or two */
            } else if ((left & 1) != 0) {
                memset(pixels, 0, size);
            }
            pixels += image->width * image->format;
        }
    }
}

/* While the rows are in the cache: the shaders write to them next. */
static void clear_image(const struct frame *frame, struct span rows, size_t band) {
    const struct image *image = frame->image;
    size_t row_size = image->width * image->format;
    if (frame->knows_last) {
        clear_touched(image, rows, last_touched(frame->pipeline, band));
    } else if (frame->pipeline->clearing != CLEAR_NOTHING) {
        memset(image->pixels + (size_t)rows.begin * row_size, 0,
               (size_t)(rows.end - rows.begin) * row_size);
    }
}

static void call_shader(const struct shading *shading) {
    if (has_own_loops(shading, shading->shader)) {
        shading->shader->shade(shading);
    } else {
        shade_pieces(shading, shading->shader);
    }
}

LANES_INLINE void cover_pieces(struct band *band, const struct shading *shading,
                               struct cover_how how) {
    const struct piece *pieces = band->pipeline->pieces.data;
    enum { PIECES_AHEAD = 8 }; /* so that the memory is asked for a piece before it is covered */
    for (int i = shading->numbers.begin; i < shading->numbers.end; i++) {
        if (i + PIECES_AHEAD < shading->numbers.end) {
            __builtin_prefetch(&pieces[shading->bin[i + PIECES_AHEAD]]);
        }
        cover_piece(band, shading->draw, &pieces[shading->bin[i]], (uint32_t)i + 1, how);
    }
}

LANES_INLINE void cover_draw_pieces(struct band *band, const struct shading *shading, bool counts) {
    if (band->reordered) {
        cover_pieces(band, shading, (struct cover_how){true, counts});
    } else {
        cover_pieces(band, shading, (struct cover_how){false, counts});
    }
}

static void cover_draw(struct band *band, const struct shading *shading) {
    if (shading->at_once || shading->shader->discards) {
        struct shading decide = *shading;
        decide.image = shading->at_once ? shading->image : NULL;
        decide.at_once = true;
        call_shader(&decide);
    } else if (band->pipeline->counts_tests) {
        cover_draw_pieces(band, shading, true);
    } else {
        cover_draw_pieces(band, shading, false);
    }
}

/* The band's pieces of a round. */
static const struct bin *bin_of(const struct band *band, size_t round) {
    const struct pipeline *p = band->pipeline;
    return (const struct bin *)p->bins.data + round * band_count(p) + band->index;
}

/* The numbers of a draw call's pieces in the band. */
static struct span numbers_of_draw(const struct band *band, const struct draw *draw) {
    const struct pipeline *p = band->pipeline;
    const struct bin *bin = bin_of(band, draw->round);
    size_t bands = band_count(p), begin = draw->first_block, end = begin + draw->block_count;
    const uint32_t *ends = (const uint32_t *)p->band_counts.data + band->index; /* of blocks */
    if (begin == end) {
        return (struct span){0, 0};
    }
    size_t before = begin > 0 ? ends[(begin - 1) * bands] : 0, number = bin->number;
    before = before > bin->first ? before - bin->first : 0;
    return (struct span){(int)(number + before),
                         (int)(number + ends[(end - 1) * bands] - bin->first)};
}

/* Go on to a draw call. False where it has no piece in the band. */
static bool next_draw(const struct band *band, struct shading *shading, size_t place) {
    const struct pipeline *p = band->pipeline;
    size_t index = ((const struct draw_order *)p->order.data)[place].draw;
    const struct draw *draw = (const struct draw *)p->draws.data + index;
    const struct bin *bin = bin_of(band, draw->round);
    shading->draw = draw;
    shading->shader = draw->shader;
    shading->uniforms = (const char *)p->uniforms.data + draw->uniforms;
    shading->bin = (const uint32_t *)p->binned.data + (bin->first - bin->number);
    shading->numbers = numbers_of_draw(band, draw);
    return shading->numbers.begin < shading->numbers.end;
}

static bool draw_is_behind(const struct band *band, const struct draw *draw) {
    return band->reordered && is_behind(band->visibility, draw->place.nearest, draw->place.columns,
                                        rows_in_band(band, draw->place.rows));
}

/* Cover the pieces of the round's draw calls in the band. */
static void cover_draws(struct band *band, struct shading *shading, struct range draws) {
    struct span *columns = &band->visibility->columns;
    for (size_t i = draws.begin; i < draws.end; i++) {
        if (!next_draw(band, shading, i)) {
            continue;
        }
        *columns = span_around(*columns, shading->draw->place.columns);
        if (draw_is_behind(band, shading->draw)) {
            band->behind += (uint64_t)(shading->numbers.end - shading->numbers.begin);
            continue;
        }
        band->changed_columns = band->changed_rows = (struct span){INT_MAX, 0};
        cover_draw(band, shading);
        if (band->reordered) {
            update_farthest(band);
        }
    }
}

/* Shade what is visible of all draw calls in the band. */
static void shade_draws(const struct band *band, struct shading *shading) {
    for (size_t i = 0; i < band->pipeline->order_count; i++) {
        if (next_draw(band, shading, i) && !draw_is_behind(band, shading->draw)) {
            call_shader(shading);
        }
    }
}

static struct band begin_band(const struct frame *frame, size_t index, size_t worker) {
    struct pipeline *p = frame->pipeline;
    int bottom = (int)index * BAND_HEIGHT, height = (int)p->height;
    return (struct band){
        .pipeline = p,
        .index = index,
        .visibility = (struct visibility *)p->visibility.data + (frame->kept ? index : worker),
        .rows = {bottom, height - bottom < BAND_HEIGHT ? height : bottom + BAND_HEIGHT},
        .reordered = p->reordered,
    };
}

static struct shading begin_shading(const struct frame *frame, const struct band *band) {
    struct pipeline *p = frame->pipeline;
    return (struct shading){
        .pipeline = p,
        .visibility = band->visibility,
        .rows = band->rows,
        .image = frame->image,
        .at_once = !takes_shortcut(p, SHORTCUT_VISIBLE),
        .work = (struct pixel_work *)p->band_work.data + band->index,
    };
}

static void add_covered(const struct band *band, struct pixel_work *work) {
    work->behind += band->behind;
    work->covered += band->covered;
    work->passed += band->passed;
}

void pipeline_cover_band(void *context, size_t index, size_t worker) {
    const struct frame *frame = context;
    struct band band = begin_band(frame, index, worker);
    struct shading shading = begin_shading(frame, &band);
    cover_draws(&band, &shading, frame->draws);
    add_covered(&band, shading.work);
}

void pipeline_draw_band(void *context, size_t index, size_t worker) {
    const struct frame *frame = context;
    struct pipeline *p = frame->pipeline;
    struct scratch *scratch = (struct scratch *)p->scratch.data + worker;
    struct band band = begin_band(frame, index, worker);
    struct shading shading = begin_shading(frame, &band);
    const struct bin *bin = bin_of(&band, frame->round); /* the last one */
    shading.scratch = scratch;
    memset(scratch->fetched, 0, (bin->number + bin->count + 1) * sizeof *scratch->fetched);
    clear_image(frame, band.rows, index);
    if (!frame->kept) {
        cover_draws(&band, &shading, frame->draws);
        add_covered(&band, shading.work);
    }
    if (!shading.at_once) {
        mark_visible(&band, scratch);
        shade_draws(&band, &shading);
    }
    if (p->depth != NULL) {
        keep_depth(&band);
    }
    if (p->clearing == CLEAR_LAST_FRAME) {
        memcpy(last_touched(p, index), band.visibility->touched,
               chunk_columns(p) * sizeof *band.visibility->touched);
    }
    clear_band(&band);
}
