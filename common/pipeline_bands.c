/* The pixels of a frame, band by band: cover, then shade. See pipeline.h. */
#include "pipeline.h"

#include "pipeline_parts.h"

/* ---- Cover: which piece is nearest at each pixel ---- */

/* In boxes higher than this many pixels it pays to ask in which rows a strip lies outside. */
enum { HIGH_BOX = 16 };

/* A band that is being covered. */
struct band {
    const struct pipeline *pipeline;
    struct scratch *scratch;
    struct span rows;
    bool reordered;      /* the nearest draw calls are covered first */
    struct span columns; /* those of its draw calls so far */
    uint64_t behind;
    longs covered; /* depth tests, to be added up */
};

/* Mark that something may be drawn in these rows of the columns from x on. */
static void touch(const struct band *band, int x, struct span rows) {
    int begin = rows.begin - band->rows.begin, end = rows.end - band->rows.begin;
    uint64_t before_end = (UINT64_C(1) << end) - 1;
    band->scratch->touched[x / CHUNK] |= (uint32_t)(before_end >> begin << begin);
}

LANES_INLINE longs longs_from(int first) {
    longs from = {0};
    for (int i = 0; i < TOGETHER; i++) {
        from[i] = i;
    }
    return from + first;
}

LANES_INLINE doubles doubles_from(int first) {
    doubles from = {0};
    for (int i = 0; i < TOGETHER; i++) {
        from[i] = i;
    }
    return from + first;
}

/* Depths and numbers of neighbours become those of the piece where it covers (`outside`: no bit, or
 * all) and is nearer; with `reordered`, of equal depths that of the lowest number stays, otherwise
 * the first one. Without branches: each line is one or two instructions for all pixels. A depth of
 * all bits is no number, and not nearer than anything. */
LANES_INLINE void cover_pixels(double *depths, uint32_t *numbers, longs outside, doubles z,
                               uint32_t number, bool reordered) {
    doubles old_z;
    ints old_number;
    memcpy(&old_z, depths, sizeof old_z);
    memcpy(&old_number, numbers, sizeof old_number);
    z = (doubles)((longs)z | outside);
    longs nearer = z > old_z;
    if (reordered) {
        ints is_later = old_number > (int32_t)number;
        nearer |= (z == old_z) & __builtin_convertvector(is_later, longs);
    }
    z = (doubles)((nearer & (longs)z) + (~nearer & (longs)old_z)); /* `+`: see lanes_select() */
    ints is_new = __builtin_convertvector(nearer, ints);
    old_number = (is_new & (int32_t)number) | (~is_new & old_number);
    memcpy(depths, &z, sizeof z);
    memcpy(numbers, &old_number, sizeof old_number);
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
    return __builtin_convertvector(whole, three);
}

/* The edge functions at the centres of the pixels of a box: their values at its pixel (0,0), their
 * steps, and what makes them negative where 0 is not inside. All are whole numbers that a double
 * holds: see guard_band_of(). */
struct box_edges {
    three origin, dx, dy, bias;
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
        .bias = three_select(top_left, zero, zero - 1),
    };
}

/* Those of TOGETHER pixels from x on that lie outside of the columns. */
LANES_INLINE longs columns_beyond(int x, struct span columns) {
    longs at = longs_from(x);
    return (at < columns.begin) | (at >= columns.end);
}

/* Where the mask is set the other number. */
LANES_INLINE doubles doubles_where_not(longs mask, doubles values, double other) {
    return (doubles)((~mask & (longs)values) + (mask & (longs)(other + (doubles){0})));
}

/* The rows of a strip of pixels in which some may be inside all edges: there the greatest value of
 * each edge function in the strip, now that of row rows.begin, is not negative. A row more does no
 * harm. */
LANES_INLINE struct span rows_of_strip(const struct box_edges *e, struct span rows) {
    three none = {0}, all = none + (rows.end - rows.begin);
    three most = e->origin + e->bias + three_select(e->dx > 0, e->dx * (TOGETHER - 1), none);
    three row_of_zero = -most / e->dy;
    three first = three_select(e->dy > 0, row_of_zero, none);
    three last = three_select(e->dy < 0, row_of_zero + 1, all);
    double begin = most_of_three((double[]){first[0], first[1], first[2]});
    double end = least_of_three((double[]){last[0], last[1], last[2]});
    if (!(begin < end)) {
        return (struct span){rows.begin, rows.begin};
    }
    return (struct span){rows.begin + (int)begin, rows.begin + (int)ceil(end)};
}

/* All pixels of a box, several tested at once: strip by strip, each from its lowest row on.
 * (Row by row, a processor would often be wrong about where the row ends.) `cut`: the piece reaches
 * beyond the columns. */
static void cover_box(struct band *band, const struct piece *piece, struct span columns,
                      struct span rows, bool cut, uint32_t number) {
    const struct scratch *scratch = band->scratch;
    int left = columns.begin / TOGETHER * TOGETHER;
    bool reordered = band->reordered, high = rows.end - rows.begin > HIGH_BOX;
    struct box_edges e = find_box_edges(piece->corner, left, rows.begin);
    struct depth_slopes slopes = find_depth_slopes(piece, e.origin[0] + e.origin[1] + e.origin[2]);
    longs covered = band->covered;
    doubles right[3], up[3], bias[3];
    for (int i = 0; i < 3; i++) {
        right[i] = e.dx[i] * doubles_from(0);
        up[i] = e.dy[i] + (doubles){0};
        bias[i] = e.bias[i] + (doubles){0};
    }
    for (int x = left; x < columns.end; x += TOGETHER) {
        struct span within = rows;
        three first = e.origin;
        if (high) {
            within = rows_of_strip(&e, rows);
            first += e.dy * (within.begin - rows.begin);
        }
        doubles e0 = first[0] + e.bias[0] + right[0];
        doubles e1 = first[1] + right[1], e2 = first[2] + right[2];
        if (cut) {
            e0 = doubles_where_not(columns_beyond(x, columns), e0, -INFINITY);
        }
        size_t place = place_in_band(within.begin - band->rows.begin, x);
        double *depths = scratch->depth + place;
        uint32_t *numbers = scratch->number + place;
        for (int y = within.begin; y < within.end; y++) {
            doubles biased1 = e1 + bias[1], biased2 = e2 + bias[2];
            longs outside = ((longs)e0 | (longs)biased1 | (longs)biased2) < 0; /* by their signs */
            covered += outside;
            cover_pixels(depths, numbers, outside, depths_at(&slopes, e1, e2), number, reordered);
            e0 += up[0];
            e1 += up[1];
            e2 += up[2];
            depths += CHUNK;
            numbers += CHUNK;
        }
        covered += within.end - within.begin; /* and -1 for each outside */
        touch(band, x, within);
        e.origin += e.dx * TOGETHER;
    }
    band->covered = covered;
}

/* ---- What is behind ---- */

/* Find the farthest depth of a column of chunks. */
static double find_farthest(const struct band *band, size_t chunk) {
    double least[CHUNK];
    int rows = band->rows.end - band->rows.begin;
    const double *depth = band->scratch->depth + chunk * CHUNK * BAND_HEIGHT;
    if (band->scratch->touched[chunk] != (uint32_t)((UINT64_C(1) << rows) - 1)) {
        return -INFINITY;
    }
    for (int i = 0; i < CHUNK; i++) {
        least[i] = INFINITY;
    }
    for (int row = 0; row < rows; row++) {
        for (int i = 0; i < CHUNK; i++) {
            least[i] = depth[i] < least[i] ? depth[i] : least[i];
        }
        depth += CHUNK;
    }
    for (int i = 1; i < CHUNK; i++) {
        least[0] = least[i] < least[0] ? least[i] : least[0];
    }
    return least[0];
}

static void update_farthest(const struct band *band, const struct draw *draw) {
    for (int x = draw->columns.begin / CHUNK; x * CHUNK < draw->columns.end; x++) {
        band->scratch->farthest[x] = find_farthest(band, (size_t)x);
    }
}

/* Is all that is no nearer than that behind what these columns of the band already show? */
static bool is_behind(const struct band *band, double nearest, struct span columns) {
    bool behind = true;
    for (int x = columns.begin / CHUNK; behind && x * CHUNK < columns.end; x++) {
        behind = nearest < band->scratch->farthest[x];
    }
    return behind;
}

static void cover_piece(struct band *band, const struct draw *draw, const struct piece *piece,
                        uint32_t number) {
    const struct rectangle *v = &draw->call.viewport;
    struct span whole = columns_of(piece->corner), columns = columns_in(whole, v);
    bool cut = columns.begin > whole.begin || columns.end < whole.end;
    struct span rows = span_overlap(rows_in(rows_of(piece->corner), v), band->rows);
    if (band->reordered && is_behind(band, nearest_of_piece(piece), columns)) {
        band->behind++;
    } else {
        cover_box(band, piece, columns, rows, cut, number);
    }
}

/* ---- A band ---- */

/* The columns of chunks that may be touched. */
static struct span chunks_of_band(const struct band *band) {
    return (struct span){band->columns.begin / CHUNK, (band->columns.end + CHUNK - 1) / CHUNK};
}

/* Mark the pieces of which a pixel is visible. */
static void mark_visible(const struct band *band) {
    const struct scratch *scratch = band->scratch;
    struct span chunks = chunks_of_band(band);
    for (int i = chunks.begin; i < chunks.end; i++) {
        const uint32_t *number = scratch->number + place_in_band(0, i * CHUNK);
        for (uint32_t rows = scratch->touched[i]; rows != 0; rows >>= 1) {
            for (int k = 0; (rows & 1) != 0 && k < CHUNK; k++) {
                scratch->fetched[number[k]] = 1;
            }
            number += CHUNK;
        }
    }
}

/* Make the band what it was: nothing is drawn. Only what was touched has changed. */
static void clear_band(const struct band *band) {
    const struct scratch *scratch = band->scratch;
    struct span chunks = chunks_of_band(band);
    for (int i = chunks.begin; i < chunks.end; i++) {
        size_t place = place_in_band(0, i * CHUNK);
        for (uint32_t rows = scratch->touched[i]; rows != 0; rows >>= 1) {
            if ((rows & 1) != 0) {
                for (int k = 0; k < CHUNK; k++) {
                    scratch->depth[place + (size_t)k] = -INFINITY;
                }
                memset(scratch->number + place, 0, CHUNK * sizeof *scratch->number);
            }
            place += CHUNK;
        }
        scratch->touched[i] = 0;
    }
}

static void keep_depth(const struct band *band) {
    const struct pipeline *p = band->pipeline;
    for (int y = band->rows.begin; y < band->rows.end; y++) {
        for (size_t x = 0; x < p->width; x++) {
            p->depth[(size_t)y * p->width + x] =
                band->scratch->depth[place_in_band(y - band->rows.begin, (int)x)];
        }
    }
}

/* What `touched` was in a band when the last frame was done: a number for each column of chunks. */
static uint32_t *last_touched(const struct pipeline *p, size_t band) {
    return (uint32_t *)p->last_touched.data + band * chunk_columns(p);
}

/* Clear what the last frame has touched in some rows of the image. */
static void clear_touched(const struct image *image, struct span rows, const uint32_t *touched) {
    for (size_t x = 0; x < image->width; x += CHUNK) {
        uint8_t *pixels = image->pixels + ((size_t)rows.begin * image->width + x) * image->format;
        size_t size = (image->width - x < CHUNK ? image->width - x : CHUNK) * image->format;
        for (uint32_t left = touched[x / CHUNK]; left != 0; left >>= 1) {
            if ((left & 1) != 0 && size == CHUNK * IMAGE_BGRA) {
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
    if (shading->shader->shade != NULL) {
        shading->shader->shade(shading);
    } else {
        shade_pieces(shading, shading->shader);
    }
}

static void cover_draw(struct band *band, struct shading *shading) {
    const struct piece *pieces = band->pipeline->pieces.data;
    if (shading->at_once || shading->shader->discards) {
        struct shading decide = *shading;
        decide.image = shading->at_once ? shading->image : NULL;
        decide.at_once = true;
        call_shader(&decide);
        return;
    }
    enum { PIECES_AHEAD = 8 }; /* so that the memory is asked for a piece before it is covered */
    for (int i = shading->numbers.begin; i < shading->numbers.end; i++) {
        if (i + PIECES_AHEAD < shading->numbers.end) {
            __builtin_prefetch(&pieces[shading->bin[i + PIECES_AHEAD]]);
        }
        cover_piece(band, shading->draw, &pieces[shading->bin[i]], (uint32_t)i + 1);
    }
}

/* The draw call's pieces in the band's list. */
static struct span numbers_of_draw(const struct pipeline *p, const struct draw *draw, size_t band) {
    const uint32_t *ends = p->band_counts.data;
    size_t first = ((const struct bin *)p->bins.data)[band].first, bands = band_count(p);
    size_t begin = draw->first_block, end = begin + draw->block_count; /* blocks */
    return (struct span){begin > 0 ? (int)(ends[(begin - 1) * bands + band] - first) : 0,
                         end > 0 ? (int)(ends[(end - 1) * bands + band] - first) : 0};
}

/* Cover (first) or shade the pieces of all draw calls in the band. */
static void draw_pieces(struct band *band, struct shading *shading, size_t index, bool cover) {
    const struct pipeline *p = band->pipeline;
    const struct draw_order *order = p->order.data;
    for (size_t i = 0; i < p->draw_count; i++) {
        const struct draw *draw = (const struct draw *)p->draws.data + order[i].draw;
        shading->draw = draw;
        shading->shader = draw->shader;
        shading->uniforms = (const char *)p->uniforms.data + draw->uniforms;
        shading->numbers = numbers_of_draw(p, draw, index);
        if (shading->numbers.begin == shading->numbers.end) {
            continue;
        }
        bool behind = band->reordered && is_behind(band, draw->nearest, draw->columns);
        band->columns = span_around(band->columns, draw->columns);
        if (cover && behind) {
            band->behind += (uint64_t)(shading->numbers.end - shading->numbers.begin);
        } else if (cover) {
            cover_draw(band, shading);
            if (band->reordered) {
                update_farthest(band, draw);
            }
        } else if (!behind) {
            call_shader(shading);
        }
    }
}

void pipeline_draw_band(void *context, size_t index, size_t worker) {
    const struct frame *frame = context;
    struct pipeline *p = frame->pipeline;
    const struct bin *bin = (const struct bin *)p->bins.data + index;
    struct pixel_work *work = (struct pixel_work *)p->band_work.data + index;
    struct scratch *scratch = (struct scratch *)p->scratch.data + worker;
    int bottom = (int)index * BAND_HEIGHT, height = (int)p->height;
    struct span rows = {bottom, height - bottom < BAND_HEIGHT ? height : bottom + BAND_HEIGHT};
    struct band band = {.pipeline = p,
                        .scratch = scratch,
                        .rows = rows,
                        .reordered = p->reordered,
                        .columns = {(int)p->width, 0}};
    struct shading shading = {
        .pipeline = p,
        .scratch = scratch,
        .bin = (const uint32_t *)p->binned.data + bin->first,
        .rows = rows,
        .image = frame->image,
        .at_once = !takes_shortcut(p, SHORTCUT_VISIBLE),
        .work = work,
    };
    *work = (struct pixel_work){0};
    memset(scratch->fetched, 0, (bin->count + 1) * sizeof *scratch->fetched);
    depth_clear(scratch->farthest, chunk_columns(p));
    clear_image(frame, rows, index);
    draw_pieces(&band, &shading, index, true);
    if (!shading.at_once) {
        mark_visible(&band);
        draw_pieces(&band, &shading, index, false);
    }
    work->behind = band.behind;
    for (int i = 0; i < TOGETHER; i++) {
        work->covered += (uint64_t)band.covered[i];
    }
    if (p->depth != NULL) {
        keep_depth(&band);
    }
    if (p->clearing == CLEAR_LAST_FRAME) {
        memcpy(last_touched(p, index), scratch->touched,
               chunk_columns(p) * sizeof *scratch->touched);
    }
    clear_band(&band);
}
