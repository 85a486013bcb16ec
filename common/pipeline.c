/* The pipeline: recording draw calls, and what a frame takes besides the pixels. See pipeline.h. */
#include "pipeline.h"

#include "array.h"
#include "pipeline_parts.h"

#include <assert.h>
#include <stdlib.h>

/* ---- Memory ---- */

bool buffer_reserve(struct buffer *buffer, size_t count, size_t element_size, struct error *error) {
    void *data = array_reserve(buffer->data, &buffer->capacity, count, element_size);
    buffer->data = data != NULL ? data : buffer->data;
    return data != NULL || error_out_of_memory(error);
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
    pipeline->shortcuts = SHORTCUTS;
    return true;
}

static void scratch_free(struct scratch *scratch) {
    free(scratch->depth);
    free(scratch->number);
    free(scratch->touched);
    free(scratch->farthest);
    free(scratch->fetched);
    free(scratch->planes);
    *scratch = (struct scratch){0};
}

static void free_all_scratch(struct pipeline *p) {
    struct scratch *scratch = p->scratch.data;
    for (size_t i = 0; i < p->scratch_count; i++) {
        scratch_free(&scratch[i]);
    }
    p->scratch_count = 0;
}

void pipeline_free(struct pipeline *pipeline) {
    free_all_scratch(pipeline);
    workers_free(pipeline->workers);
    free(pipeline->depth);
    free(pipeline->draws.data);
    free(pipeline->order.data);
    free(pipeline->uniforms.data);
    free(pipeline->screens.data);
    free(pipeline->depths.data);
    free(pipeline->beyonds.data);
    free(pipeline->recip_w.data);
    free(pipeline->blocks.data);
    free(pipeline->pieces.data);
    free(pipeline->piece_bands.data);
    free(pipeline->clipped.data);
    free(pipeline->visible.data);
    free(pipeline->band_work.data);
    free(pipeline->band_counts.data);
    free(pipeline->bins.data);
    free(pipeline->binned.data);
    free(pipeline->scratch.data);
    free(pipeline->last_touched.data);
    *pipeline = (struct pipeline){0};
}

/* Of the processor's cache. What is read at once does not reach into two lines. */
enum { CACHE_LINE = 64 };

/* Memory for one band, whose bin has at most that many pieces. */
static bool scratch_reserve(struct scratch *scratch, const struct pipeline *p, size_t bin_size,
                            struct error *error) {
    size_t columns = chunk_columns(p), pixels = columns * CHUNK * BAND_HEIGHT;
    if (scratch->depth == NULL) {
        /* Behind the last number one more is read: see find_runs(). */
        size_t depth_size = pixels * sizeof *scratch->depth;
        size_t number_size = (pixels + CHUNK) * sizeof *scratch->number;
        scratch->depth = aligned_alloc(CACHE_LINE, depth_size);
        scratch->number = aligned_alloc(CACHE_LINE, number_size);
        scratch->touched = calloc(columns, sizeof *scratch->touched);
        scratch->farthest = malloc(columns * sizeof *scratch->farthest);
        if (scratch->depth == NULL || scratch->number == NULL || scratch->touched == NULL ||
            scratch->farthest == NULL) {
            scratch_free(scratch);
            return error_out_of_memory(error);
        }
        depth_clear(scratch->depth, pixels);
        memset(scratch->number, 0, number_size);
    }
    uint32_t *fetched = array_reserve(scratch->fetched, &scratch->fetched_capacity, bin_size + 1,
                                      sizeof *scratch->fetched);
    scratch->fetched = fetched != NULL ? fetched : scratch->fetched;
    size_t visible = bin_size < pixels ? bin_size : pixels;
    struct planes *planes = array_reserve(scratch->planes, &scratch->plane_capacity, visible + 1,
                                          sizeof *scratch->planes);
    scratch->planes = planes != NULL ? planes : scratch->planes;
    return (fetched != NULL && planes != NULL) || error_out_of_memory(error);
}

/* ---- Threads ---- */

void pipeline_use_threads(struct pipeline *pipeline, size_t thread_count) {
    if (pipeline->thread_count != thread_count) {
        free_all_scratch(pipeline);
        workers_free(pipeline->workers);
        pipeline->workers = NULL;
        pipeline->alone = false;
        pipeline->thread_count = thread_count;
    }
}

static void start_workers(struct pipeline *p) {
    if (p->workers == NULL && !p->alone) {
        p->workers = workers_create(p->thread_count);
        p->alone = p->workers == NULL;
    }
}

void pipeline_run(struct pipeline *p, size_t count, worker_function *work, void *context) {
    if (count > 1) {
        start_workers(p);
    }
    workers_run(p->workers, count, work, context);
}

/* ---- Draw calls ---- */

const char *const pipeline_stat_name[PIPELINE_STATS] = {
    "objects",       "objects_outside",   "vertices_transformed", "faces",
    "faces_outside", "faces_turned_away", "faces_without_pixel",  "faces_clipped",
    "faces_hidden",  "faces_behind",      "attribute_sets",       "pixels_covered",
    "pixels_shaded",
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

void pipeline_clear(struct pipeline *pipeline) {
    pipeline->draw_count = pipeline->uniforms_end = 0;
    pipeline->piece_end = pipeline->clipped_end = pipeline->recip_w_end = 0;
    pipeline->boxed = NULL;
    pipeline->discards = false;
    memset(pipeline->stats, 0, sizeof pipeline->stats);
}

/* The blocks of all draw calls so far. */
static size_t block_count(const struct pipeline *p) {
    if (p->draw_count == 0) {
        return 0;
    }
    const struct draw *last = (const struct draw *)p->draws.data + p->draw_count - 1;
    return last->first_block + last->block_count;
}

/* Uniforms lie at multiples of this: each in a line of the cache of its own, and, since malloc()
 * aligns for every type, aligned as well as a variable is. */
enum { UNIFORMS_ALIGNMENT = 64 };

bool pipeline_draw(struct pipeline *p, const struct draw_call *call, const struct shader *shader,
                   const void *uniforms, size_t size, struct error *error) {
    const struct rectangle *v = &call->viewport;
    assert(shader->varying_count <= VARYING_LIMIT);
    assert(v->x >= 0 && v->y >= 0 && v->width >= 0 && v->height >= 0);
    assert((size_t)v->x + (size_t)v->width <= p->width);
    assert((size_t)v->y + (size_t)v->height <= p->height);
    if (!buffer_reserve(&p->draws, p->draw_count + 1, sizeof(struct draw), error) ||
        !buffer_reserve(&p->uniforms, p->uniforms_end + size, 1, error)) {
        return false;
    }
    struct draw *draw = (struct draw *)p->draws.data + p->draw_count;
    *draw = (struct draw){
        .call = *call,
        .shader = shader,
        .uniforms = p->uniforms_end,
        .first_block = block_count(p),
    };
    if (!pipeline_assemble(p, draw, error)) {
        return false;
    }
    if (size > 0) {
        memcpy((char *)p->uniforms.data + p->uniforms_end, uniforms, size);
    }
    p->uniforms_end += (size + UNIFORMS_ALIGNMENT - 1) / UNIFORMS_ALIGNMENT * UNIFORMS_ALIGNMENT;
    p->draw_count++;
    p->discards |= shader->discards;
    return true;
}

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
        if (draw->columns.begin < draw->columns.end) {
            columns = span_around(columns, draw->columns);
            rows = span_around(rows, draw->rows);
            sum += span_product(draw->columns, draw->rows);
        }
    }
    return sum > 0 && sum > span_product(columns, rows);
}

/* A shader that discards needs the order of drawing. */
static bool reorders_draws(const struct pipeline *p) {
    return takes_shortcut(p, SHORTCUT_VISIBLE) && takes_shortcut(p, SHORTCUT_BEHIND) &&
           !p->discards && draws_overlap(p);
}

/* ---- Sorting pieces into bands ---- */

/* Write the pieces of a draw call's blocks into the bands' lists; `band_counts` are the places of
 * the next ones. */
static void bin_block(const struct pipeline *p, size_t index) {
    struct block *block = (struct block *)p->blocks.data + index;
    const struct piece *pieces = (const struct piece *)p->pieces.data + block->first_piece;
    const struct band_span *bands =
        (const struct band_span *)p->piece_bands.data + block->first_piece;
    uint32_t *next = (uint32_t *)p->band_counts.data + index * band_count(p);
    uint32_t *binned = p->binned.data;
    for (size_t i = 0; i < block->piece_count; i++) {
        for (int band = bands[i].first; band <= bands[i].last; band++) {
            binned[next[band]++] = (uint32_t)(block->first_piece + i);
        }
        if (p->reordered) {
            double nearest = nearest_of_piece(&pieces[i]);
            block->nearest = nearest > block->nearest ? nearest : block->nearest;
        }
    }
}

static void bin_one_block(void *context, size_t index, size_t worker) {
    (void)worker;
    const struct frame *frame = context;
    bin_block(frame->pipeline, index);
}

/* Find where the list of each band begins, and in it the pieces of each block: counts become
 * places. Returns the size of the largest list. */
static bool lay_out_bins(struct frame *frame, size_t *largest, struct error *error) {
    struct pipeline *p = frame->pipeline;
    size_t bands = band_count(p), place = 0;
    *largest = 0;
    if (!buffer_reserve(&p->bins, bands, sizeof(struct bin), error)) {
        return false;
    }
    uint32_t *counts = p->band_counts.data;
    struct bin *bins = p->bins.data;
    for (size_t band = 0; band < bands; band++) {
        bins[band].first = place;
        for (size_t block = 0; block < frame->block_count; block++) {
            uint32_t *count = &counts[block * bands + band];
            place += *count;
            *count = (uint32_t)(place - *count);
        }
        bins[band].count = place - bins[band].first;
        *largest = bins[band].count > *largest ? bins[band].count : *largest;
    }
    if (place > INT_MAX) {
        return error_set(error, "more than %d triangles in one frame", INT_MAX);
    }
    return buffer_reserve(&p->binned, place, sizeof(uint32_t), error);
}

/* The nearest first; of equally near ones the first drawn. */
static int compare_draws(const void *left, const void *right) {
    const struct draw_order *a = left, *b = right;
    if (a->nearest != b->nearest) {
        return a->nearest > b->nearest ? -1 : 1;
    }
    return (a->draw > b->draw) - (a->draw < b->draw);
}

static void order_draws(struct pipeline *p) {
    struct draw *draws = p->draws.data;
    const struct block *blocks = p->blocks.data;
    struct draw_order *order = p->order.data;
    for (size_t i = 0; i < p->draw_count; i++) {
        draws[i].nearest = -INFINITY;
        for (size_t k = 0; k < draws[i].block_count; k++) {
            draws[i].nearest = fmax(draws[i].nearest, blocks[draws[i].first_block + k].nearest);
        }
        order[i] = (struct draw_order){draws[i].nearest, i};
    }
    if (p->reordered) {
        qsort(order, p->draw_count, sizeof *order, compare_draws);
    }
}

/* ---- The frame ---- */

static bool reserve_scratch(struct pipeline *p, size_t largest_bin, struct error *error) {
    size_t count = workers_count(p->workers);
    if (!buffer_reserve(&p->scratch, count, sizeof(struct scratch), error)) {
        return false;
    }
    struct scratch *scratch = p->scratch.data;
    for (; p->scratch_count < count; p->scratch_count++) {
        scratch[p->scratch_count] = (struct scratch){0};
    }
    bool reserved = true;
    for (size_t i = 0; i < count && reserved; i++) {
        reserved = scratch_reserve(&scratch[i], p, largest_bin, error);
    }
    return reserved;
}

static bool reserve_depth(struct pipeline *p, struct error *error) {
    if (!p->keep_depth) {
        free(p->depth);
        p->depth = NULL;
    } else if (p->depth == NULL) {
        p->depth = malloc(p->width * p->height * sizeof *p->depth);
        return p->depth != NULL || error_out_of_memory(error);
    }
    return true;
}

/* Room for what the frame touches, if it is to be remembered; and do we know it of the last one? */
static bool reserve_touched(struct frame *frame, struct error *error) {
    struct pipeline *p = frame->pipeline;
    const struct image *image = frame->image, *last = &p->last_image;
    bool remembers = p->clearing == CLEAR_LAST_FRAME;
    frame->knows_last = remembers && last->pixels == image->pixels && last->format == image->format;
    return !remembers || buffer_reserve(&p->last_touched, band_count(p) * chunk_columns(p),
                                        sizeof(uint32_t), error);
}

/* Count the pieces of which nothing was visible. Where all is shaded at once, nobody knows. */
static void count_hidden(struct pipeline *p) {
    const struct draw *draws = p->draws.data;
    const struct block *blocks = p->blocks.data;
    const atomic_uchar *visible = p->visible.data;
    for (size_t i = 0; takes_shortcut(p, SHORTCUT_VISIBLE) && i < p->draw_count; i++) {
        for (size_t k = 0; k < draws[i].block_count && !draws[i].shader->discards; k++) {
            const struct block *block = &blocks[draws[i].first_block + k];
            for (size_t piece = 0; piece < block->piece_count; piece++) {
                p->stats[STAT_FACES_HIDDEN] += visible[block->first_piece + piece] == 0;
            }
        }
    }
}

bool pipeline_finish(struct pipeline *p, struct image *image, struct error *error) {
    assert(image->width == p->width && image->height == p->height && image->format != IMAGE_GREY);
    struct frame frame = {p, image, block_count(p), false};
    size_t bands = band_count(p), largest_bin;
    p->reordered = reorders_draws(p);
    if (bands > 1) {
        start_workers(p);
    }
    if (!lay_out_bins(&frame, &largest_bin, error) || !reserve_depth(p, error) ||
        !reserve_touched(&frame, error) ||
        !buffer_reserve(&p->order, p->draw_count, sizeof(struct draw_order), error) ||
        !buffer_reserve(&p->visible, p->piece_end, sizeof(atomic_uchar), error) ||
        !buffer_reserve(&p->band_work, bands, sizeof(struct pixel_work), error) ||
        !reserve_scratch(p, largest_bin, error)) {
        return false;
    }
    atomic_uchar *visible = p->visible.data;
    memset(visible, 0, p->piece_end * sizeof *visible);
    pipeline_run(p, frame.block_count, bin_one_block, &frame);
    order_draws(p);
    pipeline_run(p, bands, pipeline_draw_band, &frame);
    p->last_image = p->clearing == CLEAR_LAST_FRAME ? *image : (struct image){0};
    const struct pixel_work *work = p->band_work.data;
    for (size_t i = 0; i < bands; i++) {
        p->stats[STAT_ATTRIBUTE_SETS] += work[i].fetched;
        p->stats[STAT_FACES_BEHIND] += work[i].behind;
        p->stats[STAT_PIXELS_COVERED] += work[i].covered;
        p->stats[STAT_PIXELS_SHADED] += work[i].shaded;
    }
    count_hidden(p);
    return true;
}
