/*
 * The pipeline from outside: its memory, the recorded draw calls, and a frame from its first stage
 * to its last. See pipeline.h.
 *
 * A frame reserves the memory of a stage before threads begin with it. All memory stays for the
 * next frame, which allocates nothing if it needs no more than this one. Only assembling can run
 * out of memory in a thread; then the frame ends before a pixel of the image has changed.
 */
#include "pipeline.h"

#include <assert.h>

/* ---- Memory ---- */

bool pipeline_create(struct pipeline *pipeline, size_t width, size_t height, struct error *error) {
    *pipeline = (struct pipeline){0};
    if (width < 1 || height < 1 || width > DRAW_LIMIT || height > DRAW_LIMIT) {
        return error_set(error, "cannot draw %zux%zu pixels: a side has 1 to %d", width, height,
                         DRAW_LIMIT);
    }
    struct frame *frame = calloc(1, sizeof *frame);
    if (frame == NULL) {
        return error_out_of_memory(error);
    }
    *pipeline = (struct pipeline){.width = width, .height = height, .skip = true, .frame = frame};
    return true;
}

static void free_chunks(struct frame *frame) {
    free(frame->chunks);
    frame->chunks = NULL;
    frame->chunk_capacity = 0;
}

static void free_workers(struct frame *frame) {
    for (size_t i = 0; frame->scratch != NULL && i < workers_count(frame->workers); i++) {
        free(frame->scratch[i].pieces);
        free(frame->scratch[i].is_visible);
        free(frame->scratch[i].visible);
        free(frame->scratch[i].colors);
        free(frame->scratch[i].plane_place);
        free(frame->scratch[i].planes);
        free(frame->scratch[i].before);
    }
    free(frame->scratch);
    frame->scratch = NULL;
    workers_free(frame->workers);
    frame->workers = NULL;
}

static void free_blocks(struct frame *frame) {
    for (size_t i = 0; i < frame->blocks_made; i++) {
        free(frame->blocks[i].pieces);
        free(frame->blocks[i].bands);
        free(frame->blocks[i].sorted);
    }
    free(frame->blocks);
}

void pipeline_free(struct pipeline *pipeline) {
    struct frame *frame = pipeline->frame;
    if (frame != NULL) {
        free_chunks(frame);
        free_workers(frame);
        free_blocks(frame);
        free(frame->calls);
        free(frame->uniforms);
        free(frame->order);
        free(frame->positions);
        free(frame->recip_w);
        free(frame->beyonds);
        free(frame->band_starts);
        free(frame);
    }
    free(pipeline->depth);
    *pipeline = (struct pipeline){0};
}

/* Room for that many chunks, in which nothing is visible yet. */
static bool reserve_chunks(struct frame *frame, size_t count) {
    if (count <= frame->chunk_capacity) {
        return true;
    }
    free_chunks(frame);
    frame->chunks = aligned_alloc(CACHE_LINE, count * sizeof *frame->chunks);
    for (size_t i = 0; frame->chunks != NULL && i < count; i++) {
        frame->chunks[i].touched = ALL_ROWS;
        chunk_clear(&frame->chunks[i]);
    }
    frame->chunk_capacity = frame->chunks != NULL ? count : 0;
    return frame->chunks != NULL;
}

/* Memory for the pieces of one band: for as many as there are in all bands, since untouched memory
 * costs nothing. */
static bool scratch_reserve(struct scratch *scratch, const struct frame *frame) {
    size_t pixels = chunk_count(frame) * CHUNK_WIDTH * BAND_HEIGHT, count = frame->sorted_count + 1;
    size_t visible = (count < pixels ? count : pixels) + TOGETHER; /* written at once */
    return array_extend(&scratch->pieces, &scratch->piece_capacity, count,
                        sizeof(struct piece *)) &&
           array_extend(&scratch->is_visible, &scratch->is_visible_capacity, count,
                        sizeof *scratch->is_visible) &&
           array_extend(&scratch->visible, &scratch->visible_capacity, count,
                        sizeof *scratch->visible) &&
           array_extend(&scratch->colors, &scratch->color_capacity, count,
                        sizeof *scratch->colors) &&
           array_extend(&scratch->plane_place, &scratch->plane_place_capacity, count,
                        sizeof *scratch->plane_place) &&
           array_extend(&scratch->planes, &scratch->plane_capacity, visible,
                        PLANES_SIZE(VARYING_LIMIT) * sizeof *scratch->planes) &&
           (!frame->discards || array_extend(&scratch->before, &scratch->before_capacity,
                                             chunk_count(frame), sizeof *scratch->before));
}

/* ---- Draw calls ---- */

void pipeline_use_threads(struct pipeline *pipeline, size_t thread_count) {
    struct frame *frame = pipeline->frame;
    if (frame->thread_count != thread_count) {
        free_workers(frame);
        frame->thread_count = thread_count;
    }
}

const char *const pipeline_stat_name[PIPELINE_STATS] = {
    "calls",          "calls_outside", "calls_hidden",      "vertices_transformed",
    "faces",          "faces_outside", "faces_turned_away", "faces_without_pixel",
    "faces_clipped",  "faces_hidden",  "faces_behind",      "attribute_sets",
    "pixels_covered", "pixels_passed", "pixels_shaded",
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
    struct frame *frame = pipeline->frame;
    frame->call_count = frame->uniforms_end = 0;
    frame->discards = false;
    memset(pipeline->stats, 0, sizeof pipeline->stats);
}

/* Uniforms lie at multiples of this: each in its own cache line and, since malloc()
 * aligns for every type, aligned as well as a variable is. */
enum { UNIFORMS_ALIGNMENT = 64 };

bool pipeline_draw(struct pipeline *pipeline, const struct draw_call *call,
                   const struct shader *shader, const void *uniforms, size_t size,
                   struct error *error) {
    struct frame *frame = pipeline->frame;
    const struct rectangle *v = &call->viewport;
    assert(shader->varying_count <= VARYING_LIMIT);
    assert(v->x >= 0 && v->y >= 0 && v->width >= 0 && v->height >= 0);
    assert((size_t)v->x + (size_t)v->width <= pipeline->width);
    assert((size_t)v->y + (size_t)v->height <= pipeline->height);
    if (!array_extend(&frame->calls, &frame->call_capacity, frame->call_count + 1,
                      sizeof *frame->calls) ||
        !array_extend(&frame->uniforms, &frame->uniforms_capacity, frame->uniforms_end + size, 1)) {
        return error_out_of_memory(error);
    }
    pipeline->stats[STAT_CALLS]++;
    pipeline->stats[STAT_FACES] += call->model->face_count;
    frame->calls[frame->call_count++] = (struct recorded_call){
        .call = *call,
        .shader = shader,
        .uniforms = frame->uniforms_end,
        .place = {columns_of(v), rows_of(v), INFINITY},
    };
    if (size > 0) {
        memcpy(frame->uniforms + frame->uniforms_end, uniforms, size);
    }
    frame->uniforms_end +=
        (size + UNIFORMS_ALIGNMENT - 1) / UNIFORMS_ALIGNMENT * UNIFORMS_ALIGNMENT;
    frame->discards |= shader->discards;
    return true;
}

/* ---- The frame ---- */

static bool reserve_depth(struct pipeline *p) {
    if (!p->keep_depth) {
        free(p->depth);
        p->depth = NULL;
    } else if (p->depth == NULL) {
        p->depth = malloc(p->width * p->height * sizeof *p->depth);
        return p->depth != NULL;
    }
    return true;
}

/* Threads, where there are none yet, and memory for each. */
static bool reserve_workers(struct frame *frame) {
    if (frame->scratch == NULL) {
        workers_free(frame->workers);
        frame->workers = workers_create(frame->thread_count);
        frame->scratch = calloc(workers_count(frame->workers), sizeof *frame->scratch);
    }
    return frame->scratch != NULL;
}

/* Begin with nothing drawn and nothing counted. */
static void begin_frame(struct frame *frame, struct image *image) {
    frame->image = image;
    frame->round = (struct index_range){0, 0};
    frame->position_count = frame->block_count = frame->sorted_count = 0;
    frame->kept = false;
    frame->exhausted = false;
    for (size_t i = 0; i < workers_count(frame->workers); i++) {
        memset(frame->scratch[i].stats, 0, sizeof frame->scratch[i].stats);
    }
}

/* Memory for each thread, and the chunks to draw in: those of one band for each thread or, where
 * they are kept from round to round, those of every band. */
static bool reserve_bands(struct frame *frame, struct error *error) {
    size_t threads = workers_count(frame->workers);
    size_t bands = frame->kept ? band_count(frame) : threads;
    bool reserved = reserve_chunks(frame, bands * chunk_count(frame));
    for (size_t i = 0; reserved && i < threads; i++) {
        reserved = scratch_reserve(&frame->scratch[i], frame);
    }
    return reserved || error_out_of_memory(error);
}

/* All stages but shading, round by round. If there is only one round, covering is left to
 * pipeline_draw_band(), which shades the band while it is still in the cache. */
static bool draw_rounds(struct frame *frame, struct error *error) {
    do {
        pipeline_next_round(frame);
        frame->kept |= frame->round.end < frame->order_count;
        if (!pipeline_assemble_round(frame, error) || !reserve_bands(frame, error)) {
            return false;
        }
        if (frame->kept) {
            workers_run(frame->workers, band_count(frame), pipeline_cover_band, frame);
            frame->round.begin = frame->round.end;
        }
    } while (frame->round.end < frame->order_count);
    return true;
}

bool pipeline_finish(struct pipeline *p, struct image *image, struct error *error) {
    assert(image->width == p->width && image->height == p->height && image->format != IMAGE_GREY);
    struct frame *frame = p->frame;
    frame->pipeline = p;
    if (!reserve_depth(p) || !reserve_workers(frame)) {
        return error_out_of_memory(error);
    }
    begin_frame(frame, image);
    if (!pipeline_order(frame, error) || !draw_rounds(frame, error)) {
        free_chunks(frame); /* some may hold pixels of this frame */
        return false;
    }
    workers_run(frame->workers, band_count(frame), pipeline_draw_band, frame);
    for (size_t i = 0; i < workers_count(frame->workers); i++) {
        for (int k = 0; k < PIPELINE_STATS; k++) {
            p->stats[k] += frame->scratch[i].stats[k];
        }
    }
    return true;
}
