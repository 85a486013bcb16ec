/*
 * Private to the pipeline: fetch and shade, for one draw call in one band.
 *
 * Fetch: the band has the number of a piece at each pixel. The call's visible pieces are listed,
 * and the shader's vertex function is asked for the varyings at their corners, from which planes.h
 * makes what the pixels need. Shade: LANES pixels of a row are shaded at once. Mostly they belong
 * to one piece, but they need not:
 *
 *     numbers     7  7  7  7  7  3  3  3      two runs of equal numbers
 *     planes      of piece 7     of piece 3   taken run by run
 *     varyings    one division by w, and one call of the shader's fragment function, for all lanes
 *
 * This is a header because SHADER() compiles these loops once more for each shader. All functions
 * are inlined where `shader` is a constant, so that the compiler can inline the shader's functions,
 * too. pipeline.h includes it at its end.
 */
#ifndef COMMON_PIPELINE_SHADE_H
#define COMMON_PIPELINE_SHADE_H

#ifndef COMMON_PIPELINE_H
#error "include pipeline.h instead"
#endif

#include "pipeline/frame.h"
#include "pipeline/planes.h"

/* Are the bytes of a texel in memory ordered as those of a BGRA pixel? */
enum { IS_LITTLE_ENDIAN = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ };

/* ---- Fetching: once for each visible piece of a draw call ---- */

/* Put a corner of a whole face into `to`, as corner c of piece i. */
LANES_INLINE void put_corner(const struct call_band *band, const struct shader *shader,
                             uint32_t face, size_t corner, struct corners_together *to, size_t c,
                             size_t i) {
    const struct recorded_call *call = band->call;
    size_t position = call->call.model->faces[face].corner[corner].position;
    double varyings[VARYING_LIMIT];
    shader->vertex(band->uniforms, face, shader->flat ? 0 : corner, varyings);
    to->recip_w[c][i] = band->frame->recip_w[call->first_position + position];
    for (size_t k = 0; k < shader->varying_count; k++) {
        to->varyings[c][k][i] = varyings[k];
    }
}

/* Put the corners of a triangle that is left of a clipped face into `to`, as those of piece i.
 * Their varyings are mixed from those at the face's corners. */
LANES_INLINE void put_clipped_corners(const struct call_band *band, const struct shader *shader,
                                      const struct piece *piece, struct corners_together *to,
                                      size_t i) {
    struct polygon polygon = pipeline_clip_face(band->call, piece->face);
    const size_t fan[3] = {0, piece->fan_triangle, piece->fan_triangle + 1U};
    double whole[3][VARYING_LIMIT];
    for (size_t c = 0; c < 3; c++) {
        shader->vertex(band->uniforms, piece->face, shader->flat ? 0 : c, whole[c]);
    }
    for (size_t c = 0; c < 3; c++) {
        const struct clip_corner *corner = &polygon.corner[fan[piece->face_corner[c]]];
        to->recip_w[c][i] = 1 / corner->clip.w;
        for (size_t k = 0; k < shader->varying_count; k++) {
            to->varyings[c][k][i] =
                shader->flat ? whole[c][k]
                             : interpolate(corner->weight, whole[0][k], whole[1][k], whole[2][k]);
        }
    }
}

/* Put the corners of a piece into `to`, as those of piece i. */
LANES_INLINE void put_corners(const struct call_band *band, const struct shader *shader,
                              const struct piece *piece, struct corners_together *to, size_t i) {
    for (size_t c = 0; c < 3; c++) {
        to->x[c][i] = piece->corner[c].x;
        to->y[c][i] = piece->corner[c].y;
        if (piece->fan_triangle == 0) {
            put_corner(band, shader, piece->face, piece->face_corner[c], to, c, i);
        }
    }
    if (piece->fan_triangle != 0) {
        put_clipped_corners(band, shader, piece, to, i);
    }
}

/* The visible piece of a number. All pieces count as hidden at first; the first band that shows a
 * piece takes it out of this count. */
static inline const struct piece *uncount_hidden(const struct call_band *band, uint32_t number) {
    struct piece *piece = band->scratch->pieces[number - 1];
    bool is_first = !piece->in_several_bands || !atomic_exchange(&piece->shown, true);
    band->stats[STAT_FACES_HIDDEN] -= is_first;
    return piece;
}

/* List the numbers of the call's visible pieces, and return how many there are. Without a branch,
 * which no processor could predict. */
LANES_INLINE uint32_t list_visible(const struct call_band *band) {
    uint32_t *visible = band->scratch->visible, count = 0;
    for (uint32_t number = (uint32_t)band->numbers.begin + 1; number <= (uint32_t)band->numbers.end;
         number++) {
        visible[count] = number;
        count += band->scratch->is_visible[number];
    }
    return count;
}

/* Find the planes of the visible pieces. */
LANES_INLINE void fetch_planes(const struct call_band *band, const struct shader *shader,
                               uint32_t count) {
    const uint32_t *visible = band->scratch->visible;
    struct corners_together corners = {0};
    for (uint32_t i = 0; i < count; i++) {
        const struct piece *piece = uncount_hidden(band, visible[i]);
        band->scratch->plane_place[visible[i]] = (uint32_t)planes_place(shader, i);
        put_corners(band, shader, piece, &corners, i % TOGETHER);
        if (i % TOGETHER == TOGETHER - 1 || i == count - 1) {
            find_planes(&corners, shader,
                        band->scratch->planes + planes_place(shader, i / TOGETHER * TOGETHER));
        }
    }
}

/* Does the shader give a whole piece one colour? (One that discards decides at each pixel.) */
LANES_INLINE bool has_colors(const struct shader *shader) {
    return shader->flat && !shader->discards;
}

/* Find the colours of the visible pieces, LANES at once. */
LANES_INLINE void fetch_colors(const struct call_band *band, const struct shader *shader,
                               uint32_t count) {
    const uint32_t *visible = band->scratch->visible;
    for (uint32_t first = 0; first < count; first += LANES) {
        uint32_t some = count - first < LANES ? count - first : LANES;
        real values[VARYING_LIMIT][LANES] = {{0}};
        lanes varyings[VARYING_LIMIT];
        lanes_texel colors;
        for (uint32_t i = 0; i < some; i++) {
            const struct piece *piece = uncount_hidden(band, visible[first + i]);
            double asked[VARYING_LIMIT];
            shader->vertex(band->uniforms, piece->face, 0, asked);
            for (size_t k = 0; k < shader->varying_count; k++) {
                values[k][i] = (real)asked[k];
            }
        }
        memcpy(varyings, values, sizeof varyings);
        shader->fragment(band->uniforms, varyings, &colors);
        for (uint32_t i = 0; i < some; i++) {
            band->scratch->colors[visible[first + i]] = lanes_texel_at(colors, (int)i);
        }
    }
}

/* Fetch what the call's visible pieces need, in the order of the model, in which the faces are
 * close together in memory. Returns how many pieces there are. */
LANES_INLINE uint32_t fetch_visible(const struct call_band *band, const struct shader *shader) {
    uint32_t count = list_visible(band);
    if (has_colors(shader)) {
        fetch_colors(band, shader, count);
    } else {
        fetch_planes(band, shader, count);
    }
    band->stats[STAT_ATTRIBUTE_SETS] += count;
    return count;
}

/* ---- The varyings of several pixels at once ---- */

/* The values of the planes at LANES neighbours of a row, which may belong to several pieces, and
 * the number that each plane has of its piece's corners. */
struct lanes_planes {
    lanes at[VARYING_LIMIT + 1], corner[VARYING_LIMIT + 1];
};

/* From lane `first` on, take the planes of a piece at pixels x of row y. */
LANES_INLINE void take_planes(struct lanes_planes *to, int first, const struct shader *shader,
                              const real *from, lanes x, real y) {
    lanes right = x - from[PLANES_X0 * TOGETHER];
    real up = y - from[PLANES_Y0 * TOGETHER];
    for (size_t k = 0; k <= shader->varying_count; k++) {
        real row = plane_at(from, k, PLANE_ORIGIN) + up * plane_at(from, k, PLANE_DY);
        lanes at = right * plane_at(from, k, PLANE_DX) + row;
        to->at[k] = lanes_join(to->at[k], first, at);
        to->corner[k] =
            lanes_join(to->corner[k], first, lanes_all(plane_at(from, k, PLANE_CORNER)));
    }
}

/* Planes for lanes of no piece: all varyings are 0. */
LANES_INLINE void clear_planes(struct lanes_planes *planes, const struct shader *shader) {
    for (size_t i = 0; i <= shader->varying_count; i++) {
        planes->at[i] = lanes_all(0);
        planes->corner[i] = lanes_all(i < shader->varying_count ? 0 : 1);
    }
}

/* Perspective-correct varyings: what the numerators are, divided by the denominator. */
LANES_INLINE void divide_planes(const struct lanes_planes *planes, const struct shader *shader,
                                lanes *varyings) {
    size_t n = shader->varying_count;
    lanes w = 1 / lanes_max(planes->at[n], planes->corner[n]);
    for (size_t i = 0; i < n; i++) {
        varyings[i] = planes->corner[i] + planes->at[i] * w;
    }
}

/* ---- Writing pixels ---- */

static inline void write_texel(struct image *image, uint8_t *pixel, uint32_t texel) {
    pixel[0] = (uint8_t)texel;
    pixel[1] = (uint8_t)(texel >> 8);
    pixel[2] = (uint8_t)(texel >> 16);
    if (image->format == IMAGE_BGRA) {
        pixel[3] = (uint8_t)(texel >> 24);
    }
}

/* Write the lanes that are `drawn`. The image is read only if some of its pixels stay, since it may
 * be far from the cache. */
LANES_INLINE void write_lanes(struct image *image, int x, int y, lanes_texel color,
                              lanes_int drawn) {
    uint8_t *pixels = image->pixels + ((size_t)y * image->width + (size_t)x) * image->format;
    if (IS_LITTLE_ENDIAN && image->format == IMAGE_BGRA && (size_t)x + LANES <= image->width) {
        if (lanes_bits(~drawn) != 0) {
            lanes_texel old;
            memcpy(&old, pixels, sizeof old);
            color = VECTOR_SELECT(drawn, color, old);
        }
        memcpy(pixels, &color, sizeof color);
        return;
    }
    uint32_t texels[LANES];
    int32_t write[LANES];
    memcpy(texels, &color, sizeof texels);
    memcpy(write, &drawn, sizeof write);
    for (int i = 0; i < LANES; i++) {
        if (write[i]) {
            write_texel(image, pixels + (size_t)i * image->format, texels[i]);
        }
    }
}

/* ---- Shading what is visible ---- */

/* Is it a number of the current draw call? */
LANES_INLINE bool has_number(const struct call_band *band, uint32_t number) {
    return number > (uint32_t)band->numbers.begin && number <= (uint32_t)band->numbers.end;
}

/* Where do runs of equal numbers begin, but the first one? Bit i of the result is set where pixel i
 * has another number than pixel i - 1. The number behind the LANES pixels is read, too. */
LANES_INLINE uint32_t find_runs(const uint32_t number[LANES + 1]) {
    lanes_texel here, next;
    memcpy(&here, number, sizeof here);
    memcpy(&next, number + 1, sizeof next);
    uint32_t ends = lanes_bits((lanes_int)(here != next));
    return ends << 1 & ((UINT32_C(1) << LANES) - 1);
}

/* Find the varyings of LANES pixels: take the planes run by run, and divide once. False if none of
 * the pixels belongs to this draw call. */
LANES_INLINE bool gather_varyings(const struct call_band *band, const struct shader *shader,
                                  const uint32_t number[LANES + 1], int x, int y, lanes *varyings) {
    struct lanes_planes planes;
    const real *all = band->scratch->planes;
    const uint32_t *place = band->scratch->plane_place;
    const lanes columns = lanes_from(x);
    bool found = has_number(band, number[0]);
    clear_planes(&planes, shader);
    if (found) {
        take_planes(&planes, 0, shader, all + place[number[0]], columns, (real)y);
    }
    for (uint32_t runs = find_runs(number); runs != 0; runs &= runs - 1) {
        int first = __builtin_ctz(runs);
        if (has_number(band, number[first])) {
            take_planes(&planes, first, shader, all + place[number[first]], columns, (real)y);
            found = true;
        }
    }
    if (found) {
        divide_planes(&planes, shader, varyings);
    }
    return found;
}

/* LANES pixels that are about to be shaded. */
struct pixels {
    int x, y;
    lanes_int drawn; /* those of this draw call */
    const uint32_t *number;
    lanes varyings[VARYING_LIMIT];
};

/* Find what there is to shade in the LANES pixels from (x,y) on. False if none of them belongs to
 * this draw call. */
LANES_INLINE bool gather_pixels(const struct call_band *band, const struct shader *shader,
                                const uint32_t number[LANES + 1], int x, int y,
                                struct pixels *pixels) {
    lanes_texel numbers;
    memcpy(&numbers, number, sizeof numbers);
    pixels->x = x;
    pixels->y = y;
    pixels->number = number;
    pixels->drawn = (lanes_int)((numbers > (uint32_t)band->numbers.begin) &
                                (numbers <= (uint32_t)band->numbers.end));
    if (lanes_bits(pixels->drawn) == 0) {
        return false;
    }
    return has_colors(shader) || gather_varyings(band, shader, number, x, y, pixels->varyings);
}

/* Let the pixels that the shader discards show again what they showed before. Returns those that it
 * keeps. */
LANES_INLINE lanes_int take_back(const struct call_band *band, const struct pixels *pixels,
                                 lanes_mask kept) {
    size_t chunk = (size_t)pixels->x / CHUNK_WIDTH, first = (size_t)pixels->x % CHUNK_WIDTH;
    int row = pixels->y - band->rows.begin;
    struct chunk *now = &band->chunks[chunk], *before = &band->scratch->before[chunk];
    lanes_int drawn = pixels->drawn;
    for (int i = 0; i < LANES; i++) {
        if (drawn[i] != 0 && !lanes_is_set(kept, i)) {
            now->depth[row][first + (size_t)i] = before->depth[row][first + (size_t)i];
            now->number[row][first + (size_t)i] = before->number[row][first + (size_t)i];
            drawn[i] = 0;
        }
    }
    return drawn;
}

LANES_INLINE void shade_pixels(const struct call_band *band, const struct shader *shader,
                               const struct pixels *pixels) {
    lanes_texel color;
    lanes_int drawn = pixels->drawn;
    if (has_colors(shader)) { /* of other draw calls' numbers anything, which is not drawn */
        color = lanes_fetch(band->scratch->colors, pixels->number);
    } else {
        lanes_mask kept = shader->fragment(band->uniforms, pixels->varyings, &color);
        drawn = shader->discards ? take_back(band, pixels, kept) : drawn;
    }
    write_lanes(band->frame->image, pixels->x, pixels->y, color, drawn);
}

/* Shade the draw call's pixels in LANES columns of the band. All of them are gathered before the
 * first is shaded: a processor predicts badly how many runs there are, and when it was
 * wrong it would drop the reads of texels that it had begun. (A piece of one colour reads none, so
 * its pixels are shaded at once, in 0.94 of the time of a frame.) Returns the pixels of each
 * column. */
LANES_INLINE lanes_int shade_columns(const struct call_band *band, const struct shader *shader,
                                     int x) {
    const struct chunk *chunk = &band->chunks[(size_t)x / CHUNK_WIDTH];
    const uint32_t *number = chunk->number[0] + x % CHUNK_WIDTH;
    uint32_t touched = chunk->touched;
    struct pixels pixels[BAND_HEIGHT];
    int count = 0;
    lanes_int shaded = {0};
    for (int y = band->rows.begin; y < band->rows.end; y++) {
        if ((touched & 1) != 0 && gather_pixels(band, shader, number, x, y, &pixels[count])) {
            shaded += pixels[count].drawn & 1;
            if (has_colors(shader)) {
                shade_pixels(band, shader, &pixels[count]);
            } else {
                count++;
            }
        }
        number += CHUNK_WIDTH;
        touched >>= 1;
    }
    for (int i = 0; i < count; i++) {
        shade_pixels(band, shader, &pixels[i]);
    }
    return shaded;
}

/* Shade each visible pixel of the draw call once. SHADER() compiles this for a shader. It goes
 * column by column, because the pixels above mostly belong to the same pieces, and their texels are
 * next to those just fetched. */
LANES_INLINE void shade_visible(const struct call_band *band, const struct shader *shader) {
    lanes_int shaded = {0};
    if (fetch_visible(band, shader) == 0) {
        return;
    }
    for (int x = band->columns.begin / CHUNK_WIDTH * CHUNK_WIDTH; x < band->columns.end;
         x += LANES) {
        shaded += shade_columns(band, shader, x);
    }
    band->stats[STAT_PIXELS_SHADED] += lanes_sum(shaded);
}

#endif
