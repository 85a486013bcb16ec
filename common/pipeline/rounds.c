/*
 * In which order draw calls are covered, in which rounds, and their pieces sorted into bands. See
 * pipeline.h.
 *
 * Where objects overlap the nearest ones are covered first: whatever lies behind them is dropped by
 * the tile. Where there are many, they come in rounds. The first has the nearest few; each one
 * after it has as many as all before it, less those that are hidden as a whole: these are never
 * assembled.
 */
#include "pipeline.h"

#include "pipeline/parts.h"

/* The draw calls of the first round; and how many there must be for more than one. */
enum { FIRST_ROUND = 4, MANY = 16 };

/* ---- The order of draw calls ---- */

static uint64_t span_product(struct span columns, struct span rows) {
    return (uint64_t)(columns.end - columns.begin) * (uint64_t)(rows.end - rows.begin);
}

/* Do the boxes of the draw calls on the screen overlap, for all that their areas tell? Pictures
 * side by side do not. */
static bool draws_overlap(const struct pipeline *p) {
    struct span columns = {INT_MAX, 0}, rows = columns;
    uint64_t sum = 0;
    for (size_t i = 0; i < p->draw_count; i++) {
        const struct draw *draw = (const struct draw *)p->draws.data + i;
        if (draw->columns.begin < draw->columns.end && draw->rows.begin < draw->rows.end) {
            columns = span_around(columns, draw->columns);
            rows = span_around(rows, draw->rows);
            sum += span_product(draw->columns, draw->rows);
        }
    }
    return sum > 0 && sum > span_product(columns, rows);
}

/* A shader that discards needs the order of drawing. */
static bool may_reorder(const struct pipeline *p) {
    return takes_shortcut(p, SHORTCUT_VISIBLE) && takes_shortcut(p, SHORTCUT_BEHIND) &&
           !p->discards && p->draw_count > 1;
}

/* The nearest first; of equally near ones the first drawn. */
static int compare_draws(const void *left, const void *right) {
    const struct draw_order *a = left, *b = right;
    if (a->nearest != b->nearest) {
        return a->nearest > b->nearest ? -1 : 1;
    }
    return (a->draw > b->draw) - (a->draw < b->draw);
}

static void sort_draws(struct pipeline *p) {
    const struct draw *draws = p->draws.data;
    struct draw_order *order = p->order.data;
    for (size_t i = 0; i < p->draw_count; i++) {
        order[i] = (struct draw_order){draws[i].nearest, i};
    }
    qsort(order, p->draw_count, sizeof *order, compare_draws);
    p->reordered = true;
}

bool pipeline_order(struct pipeline *p, struct error *error) {
    struct draw *draws = p->draws.data;
    if (!buffer_reserve(&p->order, p->draw_count, sizeof(struct draw_order), error)) {
        return false;
    }
    struct draw_order *order = p->order.data;
    bool is_many = may_reorder(p) && p->draw_count >= MANY;
    p->reordered = false;
    for (size_t i = 0; i < p->draw_count; i++) {
        order[i].draw = i;
        if (is_many) {
            pipeline_place(p, &draws[i]);
        }
    }
    if (is_many && draws_overlap(p)) {
        sort_draws(p);
        return pipeline_box_batches(p, error);
    }
    return true;
}

void pipeline_reorder(struct pipeline *p) {
    struct draw *draws = p->draws.data;
    if (!may_reorder(p) || !draws_overlap(p)) {
        return;
    }
    for (size_t i = 0; i < p->draw_count; i++) {
        const struct span columns = draws[i].columns, rows = draws[i].rows;
        pipeline_place(p, &draws[i]);
        draws[i].columns = columns;
        draws[i].rows = rows;
    }
    sort_draws(p);
}

void pipeline_next_round(struct frame *frame) {
    const struct pipeline *p = frame->pipeline;
    struct range *draws = &frame->draws;
    frame->round = draws->end == 0 ? 0 : frame->round + 1;
    draws->begin = draws->end;
    draws->end = draws->begin == 0 ? FIRST_ROUND : 2 * draws->begin;
    if (!p->reordered || draws->end > p->draw_count) {
        draws->end = p->draw_count;
    }
}

/* ---- Sorting pieces into bands ---- */

/* What the threads that sort share. */
struct sorting {
    const struct pipeline *pipeline;
    size_t first_block;
};

/* Write the pieces of a block into the bands' lists; `band_counts` are the places of the next
 * ones. */
static void sort_block(void *context, size_t index, size_t worker) {
    (void)worker;
    const struct sorting *sorting = context;
    const struct pipeline *p = sorting->pipeline;
    size_t number = sorting->first_block + index;
    const struct block *block = (const struct block *)p->blocks.data + number;
    const struct band_span *bands =
        (const struct band_span *)p->piece_bands.data + block->first_piece;
    uint32_t *next = (uint32_t *)p->band_counts.data + number * band_count(p);
    uint32_t *binned = p->binned.data;
    for (size_t i = 0; i < block->piece_count; i++) {
        for (int band = bands[i].first; band <= bands[i].last; band++) {
            binned[next[band]++] = (uint32_t)(block->first_piece + i);
        }
    }
}

/* Find where the list of each band begins, and in it the pieces of each block: counts become
 * places. */
static bool lay_out_bins(struct pipeline *p, size_t round, size_t first_block,
                         struct error *error) {
    size_t bands = band_count(p), place = p->binned_end;
    if (!buffer_reserve(&p->bins, (round + 1) * bands, sizeof(struct bin), error)) {
        return false;
    }
    uint32_t *counts = p->band_counts.data;
    struct bin *bins = (struct bin *)p->bins.data + round * bands;
    for (size_t band = 0; band < bands; band++) {
        const struct bin *before = round > 0 ? &bins[band] - bands : NULL;
        bins[band].first = place;
        bins[band].number = before != NULL ? before->number + (uint32_t)before->count : 0;
        for (size_t block = first_block; block < p->block_end; block++) {
            uint32_t *count = &counts[block * bands + band];
            place += *count;
            *count = (uint32_t)(place - *count);
        }
        bins[band].count = place - bins[band].first;
    }
    if (place > INT_MAX) {
        return error_set(error, "more than %d triangles in one frame", INT_MAX);
    }
    p->binned_end = place;
    return buffer_reserve(&p->binned, place, sizeof(uint32_t), error);
}

bool pipeline_sort_round(const struct frame *frame, size_t first_block, struct error *error) {
    struct pipeline *p = frame->pipeline;
    struct sorting sorting = {p, first_block};
    if (!lay_out_bins(p, frame->round, first_block, error)) {
        return false;
    }
    pipeline_run(p, p->block_end - first_block, sort_block, &sorting);
    return true;
}
