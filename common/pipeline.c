/* The pipeline: recording, and the bands of a frame. See pipeline.h. */
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
    return true;
}

static void scratch_free(struct scratch *scratch) {
    free(scratch->depth);
    free(scratch->number);
    free(scratch->touched);
    free(scratch->plane_place);
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
    free(pipeline->uniforms.data);
    free(pipeline->vertices.data);
    free(pipeline->blocks.data);
    free(pipeline->pieces.data);
    free(pipeline->clipped.data);
    free(pipeline->band_counts.data);
    free(pipeline->bins.data);
    free(pipeline->binned.data);
    free(pipeline->band_work.data);
    free(pipeline->scratch.data);
    *pipeline = (struct pipeline){0};
}

/* Memory for one band, whose bin has at most that many pieces. */
static bool scratch_reserve(struct scratch *scratch, const struct pipeline *p, size_t bin_size,
                            struct error *error) {
    size_t pixels = band_stride(p) * BAND_HEIGHT;
    if (scratch->depth == NULL) {
        scratch->depth = malloc(pixels * sizeof *scratch->depth);
        scratch->number = calloc(pixels, sizeof *scratch->number);
        scratch->touched = calloc(pixels / CHUNK, sizeof *scratch->touched);
        if (scratch->depth == NULL || scratch->number == NULL || scratch->touched == NULL) {
            scratch_free(scratch);
            return error_out_of_memory(error);
        }
        depth_clear(scratch->depth, pixels);
    }
    uint32_t *places = array_reserve(scratch->plane_place, &scratch->bin_capacity, bin_size + 1,
                                     sizeof *scratch->plane_place);
    scratch->plane_place = places != NULL ? places : scratch->plane_place;
    size_t visible = bin_size < pixels ? bin_size : pixels;
    struct planes *planes = array_reserve(scratch->planes, &scratch->plane_capacity, visible + 1,
                                          sizeof *scratch->planes);
    scratch->planes = planes != NULL ? planes : scratch->planes;
    return (places != NULL && planes != NULL) || error_out_of_memory(error);
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
    "faces",         "faces_outside", "faces_turned_away", "faces_without_pixel",
    "faces_clipped", "faces_hidden",  "pixels_covered",    "pixels_shaded",
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
    pipeline->piece_end = pipeline->clipped_end = 0;
    memset(pipeline->stats, 0, sizeof pipeline->stats);
}

/* Uniforms lie at multiples of this, so that everything in them is aligned. */
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
    const struct draw *last = (struct draw *)p->draws.data + p->draw_count - 1;
    struct draw *draw = (struct draw *)p->draws.data + p->draw_count;
    *draw = (struct draw){
        .call = *call,
        .shader = shader,
        .uniforms = p->uniforms_end,
        .first_block = p->draw_count > 0 ? last->first_block + last->block_count : 0,
    };
    if (!pipeline_assemble(p, draw, error)) {
        return false;
    }
    if (size > 0) {
        memcpy((char *)p->uniforms.data + p->uniforms_end, uniforms, size);
    }
    p->uniforms_end += (size + UNIFORMS_ALIGNMENT - 1) / UNIFORMS_ALIGNMENT * UNIFORMS_ALIGNMENT;
    p->draw_count++;
    return true;
}

/* ---- Sorting pieces into bands ---- */

static struct span rows_of_piece(const struct piece *piece, const struct draw *draw) {
    const struct fixed2 *c = piece->corner;
    struct span rows = {(least_of(c[0].y, c[1].y, c[2].y) + SUBPIXELS / 2 - 1) >> 8,
                        ((most_of(c[0].y, c[1].y, c[2].y) - SUBPIXELS / 2) >> 8) + 1};
    int bottom = draw->call.viewport.y;
    return span_overlap(rows, (struct span){bottom, bottom + draw->call.viewport.height});
}

/* What the threads that draw a frame share. */
struct frame {
    struct pipeline *pipeline;
    struct image *image;
    size_t block_count;
};

/* Write the pieces of a draw call's blocks into the bands' lists; `band_counts` are the places of
 * the next ones. */
static void bin_block(const struct pipeline *p, const struct draw *draw, size_t index) {
    const struct block *block = (const struct block *)p->blocks.data + index;
    const struct piece *pieces = (const struct piece *)p->pieces.data + block->first_piece;
    uint32_t *next = (uint32_t *)p->band_counts.data + index * band_count(p);
    uint32_t *binned = p->binned.data;
    for (size_t i = 0; i < block->piece_count; i++) {
        struct span rows = rows_of_piece(&pieces[i], draw);
        for (int band = rows.begin / BAND_HEIGHT; band <= (rows.end - 1) / BAND_HEIGHT; band++) {
            binned[next[band]++] = (uint32_t)(block->first_piece + i);
        }
    }
}

static const struct draw *draw_of_block(const struct pipeline *p, size_t block) {
    const struct draw *draw = p->draws.data;
    while (block >= draw->first_block + draw->block_count) {
        draw++;
    }
    return draw;
}

static void bin_one_block(void *context, size_t index, size_t worker) {
    (void)worker;
    const struct frame *frame = context;
    bin_block(frame->pipeline, draw_of_block(frame->pipeline, index), index);
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
    if (place >= UINT32_MAX) {
        return error_set(error, "more than %lu triangles in one frame", (unsigned long)UINT32_MAX);
    }
    return buffer_reserve(&p->binned, place, sizeof(uint32_t), error);
}

/* ---- Cover: which piece is nearest at each pixel ---- */

/* Boxes of at most this many pixels are covered without spans, with 32-bit edge functions. */
enum { SMALL_BOX = 64 };

/* A band that is being covered. */
struct band {
    const struct pipeline *pipeline;
    struct scratch *scratch;
    struct span rows;
    size_t stride;
    uint64_t covered;
};

static void touch(const struct band *band, int y, int x) {
    size_t row = (size_t)(y - band->rows.begin) * (band->stride / CHUNK);
    band->scratch->touched[row + (size_t)(x / CHUNK)] = true;
}

/* Pixels are covered as many at a time as depths fit into the processor's registers. */
#ifndef COVERED
enum { COVERED = LANES > 4 ? LANES / 2 : 4 };
#endif
typedef int32_t eight_ints __attribute__((vector_size(COVERED * sizeof(int32_t))));
typedef int64_t eight_longs __attribute__((vector_size(COVERED * sizeof(int64_t))));
typedef double eight_depths __attribute__((vector_size(COVERED * sizeof(double))));

LANES_INLINE eight_ints ints_from(int first) {
    eight_ints from;
    for (int i = 0; i < COVERED; i++) {
        from[i] = i;
    }
    return from + first;
}

LANES_INLINE eight_depths depths_from(int first) {
    eight_depths from;
    for (int i = 0; i < COVERED; i++) {
        from[i] = i;
    }
    return from + first;
}

/* Depth and number become those of the piece where it covers (`inside`: all bits or none) and is
 * nearer. Without branches: each line is one or two instructions for all eight. */
LANES_INLINE void cover_eight(double *depths, uint32_t *numbers, eight_ints inside, eight_depths z,
                              uint32_t number) {
    eight_depths old_z;
    eight_ints old_number;
    memcpy(&old_z, depths, sizeof old_z);
    memcpy(&old_number, numbers, sizeof old_number);
    eight_longs nearer = __builtin_convertvector(inside, eight_longs) & (z > old_z);
    z = (eight_depths)((nearer & (eight_longs)z) | (~nearer & (eight_longs)old_z));
    eight_ints is_new = __builtin_convertvector(nearer, eight_ints);
    old_number = (is_new & (int32_t)number) | (~is_new & old_number);
    memcpy(depths, &z, sizeof z);
    memcpy(numbers, &old_number, sizeof old_number);
}

/* depth_at() for eight pixels. */
LANES_INLINE eight_depths depths_at(const struct depth_slopes *s, eight_depths e1,
                                    eight_depths e2) {
    return s->origin + e1 * s->k1 + e2 * s->k2;
}

/* The span of each row, found exactly. */
static void cover_by_spans(struct band *band, const struct draw *draw, const struct piece *piece,
                           uint32_t number) {
    const struct rectangle *viewport = &draw->call.viewport;
    const struct fixed2 *c = piece->corner;
    struct edges edges;
    if (!edges_setup(&edges, c[0], c[1], c[2], band->pipeline->width, band->pipeline->height)) {
        return;
    }
    struct depth_slopes slopes = find_depth_slopes(piece, edges.area);
    const struct edge *e1 = &edges.edge[1], *e2 = &edges.edge[2];
    struct span rows = span_overlap(rows_of_piece(piece, draw), band->rows);
    for (int y = rows.begin; y < rows.end; y++) {
        struct span span = span_overlap(edges_span(&edges, y),
                                        (struct span){viewport->x, viewport->x + viewport->width});
        size_t row = (size_t)(y - band->rows.begin) * band->stride;
        band->covered += span.end > span.begin ? (uint64_t)(span.end - span.begin) : 0;
        for (int x = span.begin / COVERED * COVERED; x < span.end; x += COVERED) {
            eight_ints at = ints_from(x);
            eight_depths right = depths_from(x % CHUNK);
            eight_depths first = edge_at(e1, x / CHUNK * CHUNK, y) + (double)e1->dx * right;
            eight_depths second = edge_at(e2, x / CHUNK * CHUNK, y) + (double)e2->dx * right;
            touch(band, y, x);
            cover_eight(band->scratch->depth + row + x, band->scratch->number + row + x,
                        (at >= span.begin) & (at < span.end), depths_at(&slopes, first, second),
                        number);
        }
    }
}

/* An edge function at the centres of the pixels of a small box: its value at pixel (0,0) of the
 * box, less what is not inside, and its steps. */
struct small_edge {
    int32_t origin, dx, dy, bias;
};

static struct small_edge small_edge(struct fixed2 a, struct fixed2 b) {
    int32_t x_distance = b.x - a.x, y_distance = b.y - a.y;
    bool top_left = y_distance < 0 || (y_distance == 0 && x_distance < 0);
    return (struct small_edge){
        .origin = y_distance * a.x - x_distance * a.y,
        .dx = -y_distance * SUBPIXELS,
        .dy = x_distance * SUBPIXELS,
        .bias = top_left ? 0 : -1,
    };
}

/* All pixels of a small box, tested eight at once. */
static void cover_box(struct band *band, const struct piece *piece, struct span columns,
                      struct span rows, uint32_t number) {
    int left = columns.begin / COVERED * COVERED;
    struct fixed2 c[3];
    for (int i = 0; i < 3; i++) { /* from the centre of the box's first pixel */
        c[i].x = piece->corner[i].x - left * SUBPIXELS - SUBPIXELS / 2;
        c[i].y = piece->corner[i].y - rows.begin * SUBPIXELS - SUBPIXELS / 2;
    }
    struct small_edge e[3] = {small_edge(c[1], c[2]), small_edge(c[2], c[0]),
                              small_edge(c[0], c[1])};
    struct depth_slopes slopes = find_depth_slopes(piece, e[0].origin + e[1].origin + e[2].origin);
    eight_ints covered = {0}, right[3], next[3];
    for (int i = 0; i < 3; i++) {
        right[i] = e[i].dx * ints_from(0);
        next[i] = e[i].dx * COVERED + (eight_ints){0};
    }
    for (int y = rows.begin; y < rows.end; y++) {
        size_t row = (size_t)(y - band->rows.begin) * band->stride;
        eight_ints e0 = e[0].origin + right[0];
        eight_ints e1 = e[1].origin + right[1];
        eight_ints e2 = e[2].origin + right[2];
        for (int x = left; x < columns.end; x += COVERED) {
            eight_ints inside = ((e0 + e[0].bias) | (e1 + e[1].bias) | (e2 + e[2].bias)) >= 0;
            eight_depths first = __builtin_convertvector(e1, eight_depths);
            eight_depths second = __builtin_convertvector(e2, eight_depths);
            covered -= inside;
            touch(band, y, x);
            cover_eight(band->scratch->depth + row + x, band->scratch->number + row + x, inside,
                        depths_at(&slopes, first, second), number);
            e0 += next[0];
            e1 += next[1];
            e2 += next[2];
        }
        for (int i = 0; i < 3; i++) {
            e[i].origin += e[i].dy;
        }
    }
    for (int i = 0; i < COVERED; i++) {
        band->covered += (uint64_t)covered[i];
    }
}

static void cover_piece(struct band *band, const struct draw *draw, const struct piece *piece,
                        uint32_t number) {
    const struct fixed2 *c = piece->corner;
    int32_t least_x = least_of(c[0].x, c[1].x, c[2].x), most_x = most_of(c[0].x, c[1].x, c[2].x);
    int32_t least_y = least_of(c[0].y, c[1].y, c[2].y), most_y = most_of(c[0].y, c[1].y, c[2].y);
    struct span columns = {(least_x + SUBPIXELS / 2 - 1) >> 8, ((most_x - SUBPIXELS / 2) >> 8) + 1};
    const struct rectangle *v = &draw->call.viewport;
    if (most_x - least_x <= SMALL_BOX * SUBPIXELS && most_y - least_y <= SMALL_BOX * SUBPIXELS &&
        columns.begin >= v->x && columns.end <= v->x + v->width) {
        cover_box(band, piece, columns, span_overlap(rows_of_piece(piece, draw), band->rows),
                  number);
    } else {
        cover_by_spans(band, draw, piece, number);
    }
}

/* ---- A band ---- */

/* Make the band what it was: nothing is drawn. Only what was touched has changed. */
static void clear_band(const struct band *band) {
    const struct scratch *scratch = band->scratch;
    size_t chunks = band->stride / CHUNK * BAND_HEIGHT;
    for (size_t i = 0; i < chunks; i++) {
        if (scratch->touched[i]) {
            depth_clear(scratch->depth + i * CHUNK, CHUNK);
            memset(scratch->number + i * CHUNK, 0, CHUNK * sizeof *scratch->number);
        }
    }
    memset(scratch->touched, 0, chunks * sizeof *scratch->touched);
}

static void keep_depth(const struct band *band) {
    const struct pipeline *p = band->pipeline;
    for (int y = band->rows.begin; y < band->rows.end; y++) {
        memcpy(p->depth + (size_t)y * p->width,
               band->scratch->depth + (size_t)(y - band->rows.begin) * band->stride,
               p->width * sizeof *p->depth);
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
    for (int i = shading->numbers.begin; i < shading->numbers.end; i++) {
        cover_piece(band, shading->draw, &pieces[shading->bin[i]], (uint32_t)i + 1);
    }
}

/* Find the draw call's pieces in the band's list: `end` is where they end, set from where they
 * begin, which was the end of the draw call before. */
static struct span numbers_of_draw(const struct pipeline *p, const struct draw *draw, size_t band,
                                   int begin) {
    const struct bin *bins = p->bins.data;
    const uint32_t *ends = p->band_counts.data;
    if (draw->block_count == 0) {
        return (struct span){begin, begin};
    }
    size_t last_block = draw->first_block + draw->block_count - 1;
    size_t end = ends[last_block * band_count(p) + band] - bins[band].first;
    return (struct span){begin, (int)end};
}

static void draw_band(void *context, size_t index, size_t worker) {
    const struct frame *frame = context;
    struct pipeline *p = frame->pipeline;
    const struct bin *bin = (const struct bin *)p->bins.data + index;
    int top = (int)(index + 1) * BAND_HEIGHT;
    struct band band = {
        .pipeline = p,
        .scratch = (struct scratch *)p->scratch.data + worker,
        .rows = {(int)index * BAND_HEIGHT, top < (int)p->height ? top : (int)p->height},
        .stride = band_stride(p),
    };
    struct pixel_work *work = (struct pixel_work *)p->band_work.data + index;
    *work = (struct pixel_work){0};
    memset(band.scratch->plane_place, 0, (bin->count + 1) * sizeof *band.scratch->plane_place);
    band.scratch->plane_count = 0;
    for (int pass = 0; pass < (p->skip ? 2 : 1); pass++) {
        struct shading shading = {
            .pipeline = p,
            .scratch = band.scratch,
            .bin = (const uint32_t *)p->binned.data + bin->first,
            .rows = band.rows,
            .image = frame->image,
            .at_once = !p->skip,
            .work = work,
        };
        const struct draw *draws = p->draws.data;
        for (size_t i = 0; i < p->draw_count; i++) {
            shading.draw = &draws[i];
            shading.shader = draws[i].shader;
            shading.uniforms = (const char *)p->uniforms.data + draws[i].uniforms;
            shading.numbers = numbers_of_draw(p, &draws[i], index, shading.numbers.end);
            if (shading.numbers.begin == shading.numbers.end) {
                continue;
            }
            if (pass == 0) {
                cover_draw(&band, &shading);
            } else {
                call_shader(&shading);
            }
        }
    }
    work->covered += band.covered;
    if (p->depth != NULL) {
        keep_depth(&band);
    }
    clear_band(&band);
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

bool pipeline_finish(struct pipeline *p, struct image *image, struct error *error) {
    assert(image->width == p->width && image->height == p->height && image->format != IMAGE_GREY);
    const struct draw *draws = p->draws.data;
    const struct draw *last = p->draw_count > 0 ? &draws[p->draw_count - 1] : NULL;
    struct frame frame = {p, image, last != NULL ? last->first_block + last->block_count : 0};
    size_t bands = band_count(p), largest_bin;
    if (bands > 1) {
        start_workers(p);
    }
    if (!lay_out_bins(&frame, &largest_bin, error) || !reserve_depth(p, error) ||
        !buffer_reserve(&p->band_work, bands, sizeof(struct pixel_work), error) ||
        !reserve_scratch(p, largest_bin, error)) {
        return false;
    }
    pipeline_run(p, frame.block_count, bin_one_block, &frame);
    pipeline_run(p, bands, draw_band, &frame);
    const struct pixel_work *work = p->band_work.data;
    for (size_t i = 0; i < bands; i++) {
        p->stats[STAT_PIXELS_COVERED] += work[i].covered;
        p->stats[STAT_PIXELS_SHADED] += work[i].shaded;
    }
    return true;
}
