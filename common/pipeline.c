/* The pipeline: recording draw calls, and what a frame takes besides the pixels. See pipeline.h. */
#include "pipeline.h"

#include "base/array.h"
#include "pipeline/parts.h"

#include <assert.h>
#include <stdlib.h>

/* ---- Memory ---- */

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

static void visibility_free(struct visibility *visibility) {
    free(visibility->depth);
    free(visibility->number);
    free(visibility->touched);
    free(visibility->farthest);
    *visibility = (struct visibility){0};
}

static void free_all_visibility(struct pipeline *p) {
    struct visibility *visibility = p->visibility.data;
    for (size_t i = 0; i < p->visibility_count; i++) {
        visibility_free(&visibility[i]);
    }
    p->visibility_count = 0;
}

static void free_all_scratch(struct pipeline *p) {
    struct scratch *scratch = p->scratch.data;
    for (size_t i = 0; i < p->scratch_count; i++) {
        free(scratch[i].fetched);
        free(scratch[i].visible);
        free(scratch[i].planes);
    }
    p->scratch_count = 0;
}

void pipeline_free(struct pipeline *pipeline) {
    free_all_visibility(pipeline);
    free_all_scratch(pipeline);
    workers_free(pipeline->workers);
    free(pipeline->depth);
    free(pipeline->draws.data);
    free(pipeline->order.data);
    free(pipeline->boxes.data);
    free(pipeline->uniforms.data);
    free(pipeline->assemblies.data);
    free(pipeline->screens.data);
    free(pipeline->depths.data);
    free(pipeline->beyonds.data);
    free(pipeline->recip_w.data);
    free(pipeline->blocks.data);
    free(pipeline->pieces.data);
    free(pipeline->piece_bands.data);
    free(pipeline->clipped.data);
    free(pipeline->visible.data);
    free(pipeline->visibility.data);
    free(pipeline->band_work.data);
    free(pipeline->band_counts.data);
    free(pipeline->bins.data);
    free(pipeline->binned.data);
    free(pipeline->scratch.data);
    free(pipeline->last_touched.data);
    *pipeline = (struct pipeline){0};
}

/* Room for a band, in which nothing is visible yet; left as it was when memory runs out. */
static bool visibility_create(struct visibility *visibility, const struct pipeline *p,
                              struct error *error) {
    size_t columns = chunk_columns(p), pixels = columns * CHUNK * BAND_HEIGHT;
    /* Behind the last number one more is read: see find_runs(). */
    size_t depth_size = pixels * sizeof *visibility->depth;
    size_t number_size = (pixels + CHUNK) * sizeof *visibility->number;
    struct visibility made = {
        .depth = aligned_alloc(CACHE_LINE, depth_size),
        .number = aligned_alloc(CACHE_LINE, number_size),
        .touched = calloc(columns, sizeof *made.touched),
        .farthest = malloc(columns * BAND_TILES * sizeof *made.farthest),
        .columns = {(int)p->width, 0},
    };
    if (made.depth == NULL || made.number == NULL || made.touched == NULL ||
        made.farthest == NULL) {
        visibility_free(&made);
        return error_out_of_memory(error);
    }
    depth_clear(made.depth, pixels);
    memset(made.number, 0, number_size);
    depth_clear(made.farthest, columns * BAND_TILES);
    *visibility = made;
    return true;
}

/* Memory for the numbers of one band, 1 to that. */
static bool scratch_reserve(struct scratch *scratch, const struct pipeline *p, size_t number,
                            struct error *error) {
    uint32_t *fetched =
        array_reserve(scratch->fetched, &scratch->fetched_capacity, number + 1, sizeof *fetched);
    scratch->fetched = fetched != NULL ? fetched : scratch->fetched;
    uint32_t *visible =
        array_reserve(scratch->visible, &scratch->visible_capacity, number + 1, sizeof *visible);
    scratch->visible = visible != NULL ? visible : scratch->visible;
    size_t pixels = chunk_columns(p) * CHUNK * BAND_HEIGHT;
    size_t most = (number < pixels ? number : pixels) + TOGETHER; /* which are written at once */
    real *planes = array_reserve(scratch->planes, &scratch->plane_capacity, most,
                                 PLANES_SIZE(VARYING_LIMIT) * sizeof *planes);
    scratch->planes = planes != NULL ? planes : scratch->planes;
    return (fetched != NULL && visible != NULL && planes != NULL) || error_out_of_memory(error);
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

/* ---- Draw calls ---- */

const char *const pipeline_stat_name[PIPELINE_STATS] = {
    "objects",        "objects_outside", "objects_hidden",    "vertices_transformed",
    "faces",          "faces_outside",   "faces_turned_away", "faces_without_pixel",
    "faces_clipped",  "faces_hidden",    "faces_behind",      "attribute_sets",
    "pixels_covered", "pixels_passed",   "pixels_shaded",
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

void pipeline_clear(struct pipeline *pipeline) {
    pipeline->draw_count = pipeline->uniforms_end = 0;
    pipeline->discards = false;
    memset(pipeline->stats, 0, sizeof pipeline->stats);
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
    p->stats[STAT_OBJECTS]++;
    p->stats[STAT_FACES] += call->model->face_count;
    struct draw *draws = p->draws.data;
    draws[p->draw_count++] = (struct draw){
        .call = *call,
        .shader = shader,
        .uniforms = p->uniforms_end,
        .place = {{v->x, v->x + v->width}, {v->y, v->y + v->height}, INFINITY},
    };
    if (size > 0) {
        memcpy((char *)p->uniforms.data + p->uniforms_end, uniforms, size);
    }
    p->uniforms_end += (size + UNIFORMS_ALIGNMENT - 1) / UNIFORMS_ALIGNMENT * UNIFORMS_ALIGNMENT;
    p->discards |= shader->discards;
    return true;
}

/* ---- The frame ---- */

/* One for each thread, or, where it is kept from round to round, for each band. */
static bool reserve_visibility(struct pipeline *p, size_t count, struct error *error) {
    if (!buffer_reserve(&p->visibility, count, sizeof(struct visibility), error)) {
        return false;
    }
    struct visibility *visibility = p->visibility.data;
    bool reserved = true;
    while (reserved && p->visibility_count < count) {
        reserved = visibility_create(&visibility[p->visibility_count], p, error);
        p->visibility_count += reserved;
    }
    return reserved;
}

/* The most numbers that a band has. */
static size_t most_numbers(const struct pipeline *p, size_t rounds) {
    size_t bands = band_count(p), most = 0;
    const struct bin *last = (const struct bin *)p->bins.data + (rounds - 1) * bands;
    for (size_t band = 0; band < bands; band++) {
        size_t numbers = last[band].number + last[band].count;
        most = numbers > most ? numbers : most;
    }
    return most;
}

static bool reserve_scratch(struct pipeline *p, size_t rounds, struct error *error) {
    size_t count = workers_count(p->workers);
    if (!buffer_reserve(&p->scratch, count, sizeof(struct scratch), error)) {
        return false;
    }
    struct scratch *scratch = p->scratch.data;
    for (; p->scratch_count < count; p->scratch_count++) {
        scratch[p->scratch_count] = (struct scratch){0};
    }
    size_t numbers = most_numbers(p, rounds);
    bool reserved = true;
    for (size_t i = 0; i < count && reserved; i++) {
        reserved = scratch_reserve(&scratch[i], p, numbers, error);
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

/* Room for what does not depend on the model. */
static bool begin_frame(struct frame *frame, struct error *error) {
    struct pipeline *p = frame->pipeline;
    size_t bands = band_count(p);
    p->piece_end = p->clipped_end = p->recip_w_end = p->block_end = p->binned_end = 0;
    if (bands > 1) {
        pipeline_start_workers(p);
    }
    if (!reserve_depth(p, error) || !reserve_touched(frame, error) || !pipeline_order(p, error) ||
        !buffer_reserve(&p->band_work, bands, sizeof(struct pixel_work), error)) {
        return false;
    }
    memset(p->band_work.data, 0, bands * sizeof(struct pixel_work));
    return true;
}

/* All but the shading. With one round only, pixels are not covered yet: that is done for a band
 * when it is shaded, while it is in the cache. */
static bool draw_rounds(struct frame *frame, struct error *error) {
    struct pipeline *p = frame->pipeline;
    do {
        size_t first_block = p->block_end;
        pipeline_next_round(frame);
        frame->kept |= frame->draws.end < p->order_count;
        size_t count = frame->kept ? band_count(p) : workers_count(p->workers);
        if (!reserve_visibility(p, count, error) || !pipeline_assemble_round(frame, error) ||
            !pipeline_sort_round(frame, first_block, error)) {
            return false;
        }
        if (!p->reordered) {
            pipeline_reorder(p);
        }
        if (frame->kept) {
            pipeline_run(p, band_count(p), pipeline_cover_band, frame);
        }
    } while (frame->draws.end < p->order_count);
    return true;
}

/* What was done and skipped in the bands. */
static void add_up_bands(struct pipeline *p) {
    const struct pixel_work *work = p->band_work.data;
    for (size_t i = 0; i < band_count(p); i++) {
        p->stats[STAT_ATTRIBUTE_SETS] += work[i].fetched;
        p->stats[STAT_FACES_BEHIND] += work[i].behind;
        p->stats[STAT_PIXELS_COVERED] += p->counts_tests ? work[i].covered : 0;
        p->stats[STAT_PIXELS_PASSED] += p->counts_tests ? work[i].passed : 0;
        p->stats[STAT_PIXELS_SHADED] += work[i].shaded;
    }
    count_hidden(p);
}

bool pipeline_finish(struct pipeline *p, struct image *image, struct error *error) {
    assert(image->width == p->width && image->height == p->height && image->format != IMAGE_GREY);
    struct frame frame = {.pipeline = p, .image = image};
    if (!begin_frame(&frame, error) || !draw_rounds(&frame, error) ||
        !buffer_reserve(&p->visible, p->piece_end, sizeof(atomic_uchar), error) ||
        !reserve_scratch(p, frame.round + 1, error)) {
        free_all_visibility(p); /* of some bands, perhaps, there is something in it */
        return false;
    }
    atomic_uchar *visible = p->visible.data;
    memset(visible, 0, p->piece_end * sizeof *visible);
    pipeline_run(p, band_count(p), pipeline_draw_band, &frame);
    p->last_image = p->clearing == CLEAR_LAST_FRAME ? *image : (struct image){0};
    add_up_bands(p);
    return true;
}
