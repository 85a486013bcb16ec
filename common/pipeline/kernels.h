/*
 * Private to the pipeline: what its parts share, and the loops over pixels, in a header because
 * SHADER() compiles them anew for every shader. pipeline.h includes it at its end.
 */
#ifndef COMMON_PIPELINE_KERNELS_H
#define COMMON_PIPELINE_KERNELS_H

#ifndef COMMON_PIPELINE_H
#error "include pipeline.h instead"
#endif

/* The kernels below call a shader that is a constant where they are used. Only when they are
 * inlined there can the compiler inline the shader into them in turn. */
#if defined(__GNUC__)
#define KERNEL static inline __attribute__((always_inline))
#else
#define KERNEL static inline
#endif

#include "pipeline/planes.h"

/* Rows are drawn in bands of this many, whose depths stay in the cache. */
enum { BAND_HEIGHT = 32 };
_Static_assert(BAND_HEIGHT <= 32, "`touched` has a bit for each row");

/* A row is divided into chunks of this many pixels, for however many LANES: what is touched is
 * known by the chunk; and what is farthest, by the tile of some chunks one above the other. */
enum { CHUNK = 16, TILE_HEIGHT = 8, BAND_TILES = BAND_HEIGHT / TILE_HEIGHT };
_Static_assert(BAND_HEIGHT % TILE_HEIGHT == 0, "no tile lies in two bands");

/* What `skip` switches on and off, so that each can be measured alone. */
enum shortcut {
    SHORTCUT_OUTSIDE = 1, /* objects beyond a side of the view are not transformed */
    SHORTCUT_VISIBLE = 2, /* what is visible is found before anything is shaded */
    SHORTCUT_BEHIND =
        4, /* the nearest objects are covered first; what is behind them, not at all */
    SHORTCUTS = 7
};

#define NOT_CLIPPED UINT32_MAX

/* Do the bytes of a texel in memory have the order of a BGRA image? */
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
enum { IS_LITTLE_ENDIAN = 1 };
#else
enum { IS_LITTLE_ENDIAN = 0 };
#endif

/* A triangle on the screen: a face of the model, or a part that clipping left of one. One cache
 * line. */
struct piece {
    struct fixed2 corner[3]; /* counterclockwise */
    double depth[3];         /* z/w at the corners, linear on the screen */
    uint32_t face;
    uint32_t clipped;       /* which entry of `clipped` it has; NOT_CLIPPED for a whole face */
    uint8_t face_corner[3]; /* which corner of the face each corner is */
    bool dropped;           /* covers pixels but must not be drawn (culled, with skip off) */
    uint32_t draw;          /* of which draw call */
};

/* Corners of a clipped piece as weights of its face's corners, and their 1/w. */
struct clipped_corners {
    struct vec3 weight[3]; /* of the corners in the order of `face_corner` of the whole face */
    double recip_w[3];
};

/* Where something may cover pixels, and what no depth of it is above: infinite where it may reach
 * the near plane. */
struct screen_place {
    struct span columns, rows;
    double nearest;
};

/* A recorded draw call. */
struct draw {
    struct draw_call call;
    const struct shader *shader;
    size_t uniforms;                 /* where they are in the pipeline's `uniforms` */
    size_t round;                    /* in which it is covered */
    size_t first_block, block_count; /* none while it is not assembled, or hidden as a whole */
    size_t first_recip_w;            /* of its positions, in `recip_w` */
    struct screen_place place;       /* first of the box around it, then of its pieces */
    bool has_boxes;                  /* around batches of its faces */
    size_t first_boxes;              /* in the pipeline's `boxes` */
};

/* The pieces of a band that come in one round: `binned[first]` to `binned[first + count - 1]`. In a
 * band pieces are numbered from 1 on, round after round, those of one round from `number + 1` on. A
 * pixel has the number of its piece, or 0 where nothing is drawn. */
struct bin {
    size_t first, count;
    uint32_t number;
};

/* The work of a band. */
struct pixel_work {
    uint64_t fetched; /* attribute sets */
    uint64_t behind;  /* pieces that were not covered */
    uint64_t covered; /* depth tests */
    uint64_t passed;  /* of these */
    uint64_t shaded;  /* pixels */
};

/* What is visible of a band, so far. A thread's, for one band after the other; or, where a frame
 * takes several rounds, a band's. */
struct visibility {
    double *depth;       /* of each pixel, at place_in_band(); minus infinity: nothing is drawn */
    uint32_t *number;    /* the same, of its piece */
    uint32_t *touched;   /* of each column of chunks, bit i: something may be drawn in row i */
    double *farthest;    /* of each tile, those of a column together: at most every pixel's depth */
    struct span columns; /* those of its draw calls so far */
};

/* The memory of a thread, for one band after the other. */
struct scratch {
    /* By a piece's number: 0 while nothing of it is visible, otherwise 1; and once its draw call is
     * shaded, what was fetched for it: the colour of a flat piece, or where its planes are. */
    uint32_t *fetched;
    /* Of the visible pieces of a draw call: their numbers, and their planes: see planes_of(). */
    uint32_t *visible;
    real *planes;
    size_t fetched_capacity, visible_capacity, plane_capacity; /* elements */
};

/* One draw call in one band: what a shade_function works on. */
struct shading {
    const struct pipeline *pipeline;
    const struct draw *draw;
    const struct shader *shader;
    const void *uniforms;
    struct visibility *visibility;
    struct scratch *scratch;
    const uint32_t *bin; /* piece indices: number n of the band's round is bin[n - 1] */
    struct span numbers; /* those of the draw call: begin + 1 to end */
    struct span rows;    /* of the band */
    struct image *image; /* NULL: only decide what covers, for shaders that discard */
    bool at_once;        /* cover and shade piece by piece; otherwise shade what is visible */
    struct pixel_work *work;
};

static inline size_t chunk_columns(const struct pipeline *pipeline) {
    return (pipeline->width + CHUNK - 1) / CHUNK;
}

/* Where a pixel of a band is in memory: chunk above chunk, and column of chunks beside column. So
 * what lies above is near, and as many rows as are wanted are read in turn. */
static inline size_t place_in_band(int row, int x) {
    return ((size_t)x / CHUNK * BAND_HEIGHT + (size_t)row) * CHUNK + (size_t)x % CHUNK;
}

static inline bool takes_shortcut(const struct pipeline *pipeline, enum shortcut shortcut) {
    return pipeline->skip && (pipeline->shortcuts & (unsigned)shortcut) != 0;
}

/* ---- Fetching: once for each visible piece of a draw call ---- */

/* 1/w at the corners of a piece. */
static inline void find_recip_w(const struct pipeline *p, const struct draw *draw,
                                const struct piece *piece, double recip_w[3]) {
    const struct corner *corners = draw->call.model->faces[piece->face].corner;
    const double *of_positions = (const double *)p->recip_w.data + draw->first_recip_w;
    const struct clipped_corners *clipped = p->clipped.data;
    for (size_t i = 0; i < 3; i++) {
        size_t corner = piece->face_corner[i];
        if (piece->clipped != NOT_CLIPPED) {
            recip_w[i] = clipped[piece->clipped].recip_w[corner];
        } else {
            recip_w[i] = of_positions[corners[corner].position];
        }
    }
}

/* The varyings of the corners of a piece, those of corner i at varyings[i * varying_count]. */
KERNEL void fetch_varyings(const struct shading *s, const struct shader *shader,
                           const struct piece *piece, double *varyings) {
    size_t n = shader->varying_count;
    if (piece->clipped == NOT_CLIPPED || shader->flat) {
        for (size_t i = 0; i < 3; i++) {
            size_t corner = shader->flat ? 0 : piece->face_corner[i];
            shader->vertex(s->uniforms, piece->face, corner, varyings + i * n);
        }
        return;
    }
    double whole[3 * VARYING_LIMIT];
    for (size_t i = 0; i < 3; i++) {
        shader->vertex(s->uniforms, piece->face, i, whole + i * n);
    }
    const struct clipped_corners *clipped = s->pipeline->clipped.data;
    for (size_t i = 0; i < 3; i++) {
        struct vec3 weight = clipped[piece->clipped].weight[piece->face_corner[i]];
        for (size_t k = 0; k < n; k++) {
            varyings[i * n + k] = interpolate(weight, whole[k], whole[n + k], whole[2 * n + k]);
        }
    }
}

/* The corners of a piece become number i of those. */
KERNEL void put_corners(const struct shading *s, const struct shader *shader,
                        const struct piece *piece, struct corners_together *to, size_t i) {
    size_t n = shader->varying_count;
    double varyings[3 * VARYING_LIMIT], recip_w[3];
    fetch_varyings(s, shader, piece, varyings);
    find_recip_w(s->pipeline, s->draw, piece, recip_w);
    for (size_t c = 0; c < 3; c++) {
        to->x[c][i] = piece->corner[c].x;
        to->y[c][i] = piece->corner[c].y;
        to->recip_w[c][i] = recip_w[c];
        for (size_t k = 0; k < n; k++) {
            to->varyings[c][k][i] = varyings[c * n + k];
        }
    }
}

/* The planes of one piece, number 0 of those. */
KERNEL void fetch_planes(const struct shading *s, const struct shader *shader,
                         const struct piece *piece, real *planes) {
    struct corners_together corners = {0};
    put_corners(s, shader, piece, &corners, 0);
    find_planes(&corners, shader, planes);
}

/* The piece of a number, seen: some pixel of it is visible. Several threads may see it. */
static inline const struct piece *see_piece(const struct shading *s, uint32_t number) {
    uint32_t index = s->bin[number - 1];
    atomic_store_explicit((atomic_uchar *)s->pipeline->visible.data + index, 1,
                          memory_order_relaxed);
    return (const struct piece *)s->pipeline->pieces.data + index;
}

/* What a fragment finds in its varyings. */
KERNEL void prepare_varyings(const struct shading *s, const struct shader *shader,
                             lanes *varyings) {
    if (shader->prepare != NULL) {
        shader->prepare(s->uniforms, varyings);
    }
}

/* LANES flat pieces whose colour is asked for. */
struct flat_pieces {
    int count;
    uint32_t number[LANES];
    real varyings[VARYING_LIMIT][LANES];
};

KERNEL void find_flat_colors(const struct shading *s, const struct shader *shader,
                             struct flat_pieces *pieces) {
    lanes varyings[VARYING_LIMIT];
    lanes_texel colors;
    memcpy(varyings, pieces->varyings, sizeof varyings);
    prepare_varyings(s, shader, varyings);
    shader->fragment(s->uniforms, varyings, &colors);
    for (int i = 0; i < pieces->count; i++) {
        s->scratch->fetched[pieces->number[i]] = lanes_texel_at(colors, i);
    }
    pieces->count = 0;
}

/* List the numbers of the visible pieces of the draw call; returns how many they are. Without a
 * branch: no processor could foresee it. */
KERNEL uint32_t list_visible(const struct shading *s) {
    uint32_t *visible = s->scratch->visible, count = 0;
    for (uint32_t number = (uint32_t)s->numbers.begin + 1; number <= (uint32_t)s->numbers.end;
         number++) {
        visible[count] = number;
        count += s->scratch->fetched[number];
    }
    return count;
}

/* Ask the memory for a piece that will be fetched soon, and for the face of a sooner one. */
KERNEL void expect_pieces(const struct shading *s, const uint32_t *visible, uint32_t count) {
    enum { PIECES_AHEAD = 16, FACES_AHEAD = 8 };
    const struct piece *pieces = s->pipeline->pieces.data;
    if (count > PIECES_AHEAD) {
        __builtin_prefetch(&pieces[s->bin[visible[PIECES_AHEAD] - 1]]);
    }
    if (count > FACES_AHEAD) {
        uint32_t face = pieces[s->bin[visible[FACES_AHEAD] - 1]].face;
        const struct corner *corner = s->draw->call.model->faces[face].corner;
        __builtin_prefetch(&corner[0]);
        __builtin_prefetch(&corner[2].normal);
    }
}

/* Fetch the planes of the visible pieces. */
KERNEL void fetch_all_planes(const struct shading *s, const struct shader *shader, uint32_t count) {
    const uint32_t *visible = s->scratch->visible;
    struct corners_together corners = {0};
    for (uint32_t i = 0; i < count; i++) {
        expect_pieces(s, visible + i, count - i);
        s->scratch->fetched[visible[i]] = i;
        put_corners(s, shader, see_piece(s, visible[i]), &corners, i % TOGETHER);
        if (i % TOGETHER == TOGETHER - 1 || i == count - 1) {
            find_planes(&corners, shader,
                        s->scratch->planes +
                            i / TOGETHER * TOGETHER * PLANES_SIZE(shader->varying_count));
        }
    }
}

/* And the colours, of a flat shader. */
KERNEL void fetch_all_colors(const struct shading *s, const struct shader *shader, uint32_t count) {
    const uint32_t *visible = s->scratch->visible;
    struct flat_pieces flat = {0};
    for (uint32_t i = 0; i < count; i++) {
        double varyings[VARYING_LIMIT];
        shader->vertex(s->uniforms, see_piece(s, visible[i])->face, 0, varyings);
        for (size_t k = 0; k < shader->varying_count; k++) {
            flat.varyings[k][flat.count] = (real)varyings[k];
        }
        flat.number[flat.count++] = visible[i];
        if (flat.count == LANES || i == count - 1) {
            find_flat_colors(s, shader, &flat);
        }
    }
}

/* Fetch what the visible pieces of the draw call need, in the order of the model, whose faces lie
 * close together in memory there. Returns how many these are. */
KERNEL uint32_t fetch_visible(const struct shading *s, const struct shader *shader) {
    uint32_t count = list_visible(s);
    if (shader->flat) {
        fetch_all_colors(s, shader, count);
    } else {
        fetch_all_planes(s, shader, count);
    }
    s->work->fetched += count;
    return count;
}

/* ---- The varyings of several pixels at once ---- */

/* Planes at LANES neighbours of a row, which may belong to several pieces, and what each has of its
 * piece's corners. */
struct lanes_planes {
    lanes at[VARYING_LIMIT + 1], corner[VARYING_LIMIT + 1];
};

/* From lane `first` on, the planes become those of a piece at pixels x of row y. */
KERNEL void take_planes(struct lanes_planes *to, int first, const struct shader *shader,
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

/* Planes that are 0 everywhere. */
KERNEL void clear_planes(struct lanes_planes *planes, const struct shader *shader) {
    for (size_t i = 0; i <= shader->varying_count; i++) {
        planes->at[i] = lanes_all(0);
        planes->corner[i] = lanes_all(i < shader->varying_count ? 0 : 1);
    }
}

KERNEL void divide_planes(const struct lanes_planes *planes, const struct shader *shader,
                          lanes *varyings) {
    size_t n = shader->varying_count;
    lanes w = 1 / lanes_max(planes->at[n], planes->corner[n]);
    for (size_t i = 0; i < n; i++) {
        varyings[i] = planes->corner[i] + planes->at[i] * w;
    }
}

/* The varyings of pixels x, x + 1, ... of row y, all of one piece. */
KERNEL void interpolate_varyings(const struct shader *shader, const real *planes, int x, int y,
                                 lanes *varyings) {
    struct lanes_planes same;
    clear_planes(&same, shader);
    take_planes(&same, 0, shader, planes, lanes_from(x), (real)y);
    divide_planes(&same, shader, varyings);
    for (size_t k = 0; shader->flat && k < shader->varying_count; k++) {
        varyings[k] = lanes_all(plane_at(planes, k, PLANE_CORNER));
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

/* Write the lanes that are `drawn`. What is in the image is read only where some stays: it may be
 * far from the cache. */
KERNEL void write_lanes(struct image *image, int x, int y, lanes_texel color, lanes_int drawn) {
    uint8_t *pixels = image->pixels + ((size_t)y * image->width + (size_t)x) * image->format;
    if (IS_LITTLE_ENDIAN && image->format == IMAGE_BGRA && (size_t)x + LANES <= image->width) {
        if (lanes_bits(~drawn) != 0) {
            lanes_texel old;
            memcpy(&old, pixels, sizeof old);
            color = lanes_texel_select(drawn, color, old);
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

KERNEL bool has_number(const struct shading *s, uint32_t number) {
    return number > (uint32_t)s->numbers.begin && number <= (uint32_t)s->numbers.end;
}

/* Where runs of equal numbers begin: bit 0, and bit i where pixel i has another number than the one
 * before it. The number behind the LANES pixels is read, too. */
KERNEL uint32_t find_runs(const uint32_t number[LANES + 1]) {
    lanes_texel here, next;
    memcpy(&here, number, sizeof here);
    memcpy(&next, number + 1, sizeof next);
    uint32_t ends = lanes_bits((lanes_int)(here != next));
    return (ends << 1 & ((UINT32_C(1) << LANES) - 1)) | 1;
}

/* The varyings of LANES pixels, which may belong to several pieces: the planes are taken run by
 * run, and divided by w once. False when none of the pixels is of this draw call. */
KERNEL bool gather_varyings(const struct shading *s, const struct shader *shader,
                            const uint32_t number[LANES + 1], int x, int y, lanes *varyings) {
    const uint32_t *fetched = s->scratch->fetched;
    struct lanes_planes planes;
    lanes columns = lanes_from(x);
    bool found = has_number(s, number[0]);
    clear_planes(&planes, shader);
    if (found) {
        take_planes(&planes, 0, shader, planes_of(s->scratch->planes, shader, fetched[number[0]]),
                    columns, (real)y);
    }
    uint32_t runs = find_runs(number);
    for (runs &= runs - 1; runs != 0; runs &= runs - 1) {
        int first = __builtin_ctz(runs);
        if (has_number(s, number[first])) {
            take_planes(&planes, first, shader,
                        planes_of(s->scratch->planes, shader, fetched[number[first]]), columns,
                        (real)y);
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

/* Find what is to be shaded at (x,y). False when none of the pixels is of this draw call. */
KERNEL bool gather_pixels(const struct shading *s, const struct shader *shader,
                          const uint32_t number[LANES + 1], int x, int y, struct pixels *pixels) {
    lanes_texel numbers;
    memcpy(&numbers, number, sizeof numbers);
    pixels->x = x;
    pixels->y = y;
    pixels->number = number;
    pixels->drawn =
        (lanes_int)((numbers > (uint32_t)s->numbers.begin) & (numbers <= (uint32_t)s->numbers.end));
    if (s->pipeline->reordered && lanes_bits(pixels->drawn) == 0) {
        return false; /* found sooner than run by run */
    }
    if (shader->flat) {
        return true;
    }
    return gather_varyings(s, shader, number, x, y, pixels->varyings);
}

KERNEL void shade_pixels(const struct shading *s, const struct shader *shader,
                         const struct pixels *pixels) {
    lanes_texel color;
    if (shader->flat) { /* colours of other draw calls are of no use */
        color = lanes_fetch(s->scratch->fetched, pixels->number);
    } else {
        shader->fragment(s->uniforms, pixels->varyings, &color);
    }
    write_lanes(s->image, pixels->x, pixels->y, color, pixels->drawn);
}

/* The pixels of the draw call in LANES columns of the band. All are gathered, and prepared, before
 * the first is shaded: a processor foresees badly how many pieces there are, and would begin anew
 * with texels that are on their way. (Flat ones wait for none: at once, in 0.94 of the time of a
 * frame.) Returns how many pixels there were in each column. */
KERNEL lanes_int shade_columns(const struct shading *s, const struct shader *shader, int x) {
    const uint32_t *number = s->visibility->number + place_in_band(0, x);
    uint32_t touched = s->visibility->touched[x / CHUNK];
    struct pixels pixels[BAND_HEIGHT];
    int count = 0;
    lanes_int shaded = {0};
    for (int y = s->rows.begin; y < s->rows.end; y++) {
        if ((touched & 1) != 0 && gather_pixels(s, shader, number, x, y, &pixels[count])) {
            shaded += pixels[count].drawn & 1;
            if (shader->flat) {
                shade_pixels(s, shader, &pixels[count]);
            } else {
                count++;
            }
        }
        number += CHUNK;
        touched >>= 1;
    }
    for (int i = 0; i < count; i++) {
        prepare_varyings(s, shader, pixels[i].varyings);
    }
    for (int i = 0; i < count; i++) {
        shade_pixels(s, shader, &pixels[i]);
    }
    return shaded;
}

/* Each visible pixel of the draw call once, in columns: what lies above a chunk is mostly of the
 * same pieces, and its texels lie beside those just fetched. */
KERNEL void shade_visible(const struct shading *s, const struct shader *shader) {
    struct span columns = s->draw->place.columns;
    lanes_int shaded = {0};
    if (fetch_visible(s, shader) == 0) {
        return;
    }
    for (int x = columns.begin / CHUNK * CHUNK; x < columns.end; x += LANES) {
        shaded += shade_columns(s, shader, x);
    }
    s->work->shaded += lanes_sum(shaded);
}

/* ---- Covering and shading at once ---- */

/* The depth of a piece at a pixel is z0 + e1 k1 + e2 k2, with its exact edge functions e. */
struct depth_slopes {
    double origin, k1, k2; /* z0, (z1 - z0) / area, (z2 - z0) / area */
};

static inline struct depth_slopes find_depth_slopes(const struct piece *piece, double area) {
    double scale = 1 / area;
    const double *z = piece->depth;
    return (struct depth_slopes){z[0], (z[1] - z[0]) * scale, (z[2] - z[0]) * scale};
}

/* At a pixel whose edge functions are e1 and e2. (Not from a neighbour's depth and the step to this
 * one: in a sliver these are far larger than the depth, and so are their roundings.) */
static inline double depth_at(const struct depth_slopes *s, double e1, double e2) {
    return s->origin + e1 * s->k1 + e2 * s->k2;
}

/* An edge function at pixel (x,y), exact: see guard_band_of(). */
static inline double edge_at(const struct edge *e, int x, int y) {
    return (double)(e->origin + e->dx * x + e->dy * y);
}

/* Draw the pixels of a chunk that a piece covers and where it is nearest so far. With an image,
 * write their colours; without one, their numbers, for shade_visible(). */
KERNEL void shade_chunk_at_once(const struct shading *s, const struct shader *shader,
                                const real *planes, uint32_t number, struct span span, int x, int y,
                                const struct edges *edges, const struct depth_slopes *slopes) {
    size_t first = place_in_band(y - s->rows.begin, x);
    double *depths = s->visibility->depth + first;
    for (int lane = 0; lane < CHUNK; lane += LANES) {
        double depth[LANES];
        uint32_t drawn[LANES];
        uint64_t count = 0;
        for (int i = 0; i < LANES; i++) {
            int at = x + lane + i;
            depth[i] =
                depth_at(slopes, edge_at(&edges->edge[1], at, y), edge_at(&edges->edge[2], at, y));
            drawn[i] = at >= span.begin && at < span.end && depth[i] > depths[lane + i];
            count += drawn[i];
        }
        if (count == 0) {
            continue;
        }
        lanes varyings[VARYING_LIMIT];
        lanes_texel color;
        interpolate_varyings(shader, planes, x + lane, y, varyings);
        prepare_varyings(s, shader, varyings);
        lanes_mask kept = shader->fragment(s->uniforms, varyings, &color);
        for (int i = 0; i < LANES; i++) {
            drawn[i] = drawn[i] && lanes_is_set(kept, i);
            depths[lane + i] = drawn[i] ? depth[i] : depths[lane + i];
            uint32_t *old_number = &s->visibility->number[first + (size_t)(lane + i)];
            *old_number = drawn[i] ? number : *old_number;
        }
        s->work->passed += count;
        s->work->shaded += count;
        s->visibility->touched[x / CHUNK] |= UINT32_C(1) << (y - s->rows.begin);
        if (s->image != NULL) {
            lanes_int mask;
            for (int i = 0; i < LANES; i++) {
                drawn[i] = drawn[i] ? UINT32_MAX : 0;
            }
            memcpy(&mask, drawn, sizeof mask);
            write_lanes(s->image, x + lane, y, color, mask);
        }
    }
}

KERNEL void shade_piece_at_once(const struct shading *s, const struct shader *shader,
                                const struct piece *piece, uint32_t number) {
    const struct pipeline *p = s->pipeline;
    const struct rectangle *viewport = &s->draw->call.viewport;
    struct edges edges;
    const struct fixed2 *c = piece->corner;
    if (!edges_setup(&edges, c[0], c[1], c[2], p->width, p->height)) {
        return;
    }
    real planes[PLANES_SIZE(VARYING_LIMIT) * TOGETHER];
    fetch_planes(s, shader, piece, planes);
    s->work->fetched++;
    struct depth_slopes slopes = find_depth_slopes(piece, (double)edges.area);
    struct span rows = span_overlap((struct span){edges.y_begin, edges.y_end}, s->draw->place.rows);
    rows = span_overlap(rows, s->rows);
    for (int y = rows.begin; y < rows.end; y++) {
        struct span span = span_overlap(edges_span(&edges, y),
                                        (struct span){viewport->x, viewport->x + viewport->width});
        if (span.begin >= span.end) {
            continue;
        }
        s->work->covered += (uint64_t)(span.end - span.begin);
        for (int x = span.begin / CHUNK * CHUNK; x < span.end && !piece->dropped; x += CHUNK) {
            shade_chunk_at_once(s, shader, planes, number, span, x, y, &edges, &slopes);
        }
    }
}

KERNEL void shade_at_once(const struct shading *s, const struct shader *shader) {
    const struct piece *pieces = s->pipeline->pieces.data;
    for (int i = s->numbers.begin; i < s->numbers.end; i++) {
        shade_piece_at_once(s, shader, &pieces[s->bin[i]], (uint32_t)i + 1);
    }
}

/* Is a shader called by loops of its own? Where pieces are shaded at once, only one that discards
 * is. Others do so only where nothing is to be skipped: loops of their own take 0.93 of the time
 * there, but as long to compile as all the rest of the shader. */
static inline bool has_own_loops(const struct shading *s, const struct shader *shader) {
    return shader->shade != NULL && (!s->at_once || shader->discards);
}

/* What SHADER() compiles for a shader. */
KERNEL void shade_by_own_loops(const struct shading *s, const struct shader *shader) {
    if (shader->discards && s->at_once) {
        shade_at_once(s, shader);
    } else {
        shade_visible(s, shader);
    }
}

/* All loops over pixels for any shader. */
KERNEL void shade_pieces(const struct shading *s, const struct shader *shader) {
    if (s->at_once) {
        shade_at_once(s, shader);
    } else {
        shade_visible(s, shader);
    }
}

#endif
