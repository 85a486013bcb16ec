/* Pieces sorted into bands of rows. See pipeline.h. */
#include "pipeline.h"

#include "pipeline/parts.h"

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
