/* The frame of what `make renderer` writes: see renderer.awk. What stands here is given; a comment
 * with an @ says where the functions of a lesson go. */
#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Pixel (0,0) is the bottom-left one. */
enum image_format { IMAGE_GREY = 1, IMAGE_BGR = 3, IMAGE_BGRA = 4 }; /* bytes of a pixel */

struct image {
    size_t width, height;
    enum image_format format;
    uint8_t *pixels; /* blue, green, red, alpha; row by row from the bottom */
};

struct texture_level {
    size_t width, height, pitch;
    uint32_t *texels; /* blue | green << 8 | red << 16 | alpha << 24 */
};

struct texture {
    size_t level_count;
    struct texture_level level[17]; /* 0 is the picture, each next half of it */
    bool clamp;
};

#define MODEL_NONE UINT32_MAX /* a corner without this attribute */

struct model {
    size_t position_count, uv_count, normal_count, face_count;
    struct vec3 *positions;
    float (*uvs)[2];
    float (*normals)[3];
    struct face *faces;
};

/* In lesson 10 a `lanes` is the numbers of several pixels; here it is that of one. */
enum { LANES = 1 };
typedef float real;
typedef float lanes __attribute__((vector_size(sizeof(float))));
typedef int32_t lanes_mask __attribute__((vector_size(sizeof(int32_t))));
typedef int32_t lanes_int __attribute__((vector_size(sizeof(int32_t))));
typedef uint32_t lanes_texel __attribute__((vector_size(sizeof(uint32_t))));

/* @common: vectors, matrices, places on the screen, models (given) */

/* Of length 1, in the same direction; zero stays zero. */
static struct vec3 vec3_normalized(struct vec3 a) {
    const double square = vec3_dot(a, a);
    return square > 0 ? vec3_scale(a, 1 / sqrt(square)) : a;
}

/* (cos, sin) of an angle in whole turns. */
static struct vec2 turn_direction(double turns) {
    return (struct vec2){cos(turns * 6.283185307179586), sin(turns * 6.283185307179586)};
}

/* @frame: files: TGA and OBJ (given) */

static bool image_create(struct image *image, size_t width, size_t height,
                         enum image_format format) {
    *image = (struct image){width, height, format, calloc(width * height, format)};
    return image->pixels != NULL;
}

static bool image_set(struct image *image, int x, int y, struct color color) {
    if (x < 0 || y < 0 || (size_t)x >= image->width || (size_t)y >= image->height) {
        return false;
    }
    memcpy(image->pixels + ((size_t)y * image->width + (size_t)x) * image->format, &color,
           image->format);
    return true;
}

/* The whole file, and a 0 behind it; NULL where it cannot be read. */
static uint8_t *read_file(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    uint8_t *data = NULL, *more;
    size_t room = 0;
    *size = 0;
    while (file != NULL && *size == room && (more = realloc(data, 2 * room + 65537)) != NULL) {
        data = more;
        room = 2 * room + 65536;
        *size += fread(data + *size, 1, room - *size, file);
    }
    if (file != NULL && (*size == room || ferror(file))) {
        free(data);
        data = NULL;
    }
    if (file != NULL) {
        fclose(file);
    }
    if (data != NULL) {
        data[*size] = 0;
    }
    return data;
}

/* Grey, 24 and 32 bits, raw or run-length coded, from any corner. */
static bool tga_decode(struct image *image, const uint8_t *data, size_t size) {
    const int kind = size < 18 ? 0 : data[2] & ~8;
    if (size < 18 || data[1] != 0 || (kind != 2 && kind != 3) || (data[2] & ~11) != 0) {
        return false;
    }
    const size_t width = data[12] + 256u * data[13], height = data[14] + 256u * data[15];
    const size_t bytes = data[16] / 8u, pixels = width * height;
    const bool packed = data[2] & 8;
    size_t at = 18u + data[0], left = 0; /* of a packet */
    bool repeats = false;
    if ((bytes != 1 && bytes != 3 && bytes != 4) || pixels == 0 || pixels / 128 > size ||
        !image_create(image, width, height, IMAGE_BGRA)) {
        return false;
    }
    for (size_t i = 0; i < pixels; i++) {
        if (packed && left == 0 && at < size) {
            repeats = data[at] & 128;
            left = data[at++] % 128u + 1;
        }
        if (at + bytes > size) {
            free(image->pixels);
            return false;
        }
        const size_t x = data[17] & 16 ? width - 1 - i % width : i % width;
        const size_t y = data[17] & 32 ? height - 1 - i / width : i / width;
        uint8_t *to = image->pixels + (y * width + x) * 4;
        for (size_t k = 0; k < 4; k++) {
            to[k] = k == 3 && bytes < 4 ? 255 : data[at + (bytes == 1 ? 0 : k)];
        }
        left -= packed;
        at += packed && repeats && left > 0 ? 0 : bytes;
    }
    return true;
}

/* 24 bits, run-length coded; no packet crosses a row. */
static bool tga_write(const struct image *image, const char *path) {
    const size_t w = image->width, h = image->height, bytes = image->format;
    const uint8_t header[18] = {[2] = 10,       [12] = w & 255,      [13] = w >> 8 & 255,
                                [14] = h & 255, [15] = h >> 8 & 255, [16] = 24};
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        return false;
    }
    fwrite(header, 1, sizeof header, file);
    for (size_t i = 0, run; i < w * h; i += run) {
        const uint8_t *p = image->pixels + bytes * i;
        for (run = 1; run < 128 && (i + run) % w != 0 && memcmp(p, p + bytes * run, bytes) == 0;) {
            run++;
        }
        fputc((int)(run + 127), file);
        for (size_t k = 0; k < 3; k++) {
            fputc(p[bytes == 1 ? 0 : k], file);
        }
    }
    const bool failed = ferror(file);
    return fclose(file) == 0 && !failed;
}

/* Half the width and height, each texel the mean of four. */
static bool texture_shrink(const struct texture_level *from, struct texture_level *to) {
    const size_t w = from->width > 1 ? from->width / 2 : 1, last = from->width - 1;
    const size_t h = from->height > 1 ? from->height / 2 : 1, top = from->height - 1;
    *to = (struct texture_level){w, h, w, malloc(w * h * sizeof *to->texels)};
    for (size_t i = 0; to->texels != NULL && i < w * h; i++) {
        const size_t x = 2 * (i % w), y = 2 * (i / w);
        to->texels[i] = 0;
        for (int shift = 0; shift < 32; shift += 8) {
            uint32_t sum = 2;
            for (size_t k = 0; k < 4; k++) {
                const size_t column = x + k % 2 < last ? x + k % 2 : last;
                const size_t row = y + k / 2 < top ? y + k / 2 : top;
                sum += from->texels[row * from->width + column] >> shift & 255;
            }
            to->texels[i] |= sum / 4 << shift;
        }
    }
    return to->texels != NULL;
}

/* "head.obj" and "_nm.tga" are the file head_nm.tga. No levels where there is none. */
static void texture_read(struct texture *texture, const char *model, const char *ending) {
    char path[4096];
    const char *dot = strrchr(model, '.');
    const int length = dot != NULL ? (int)(dot - model) : (int)strlen(model);
    size_t size = 0;
    struct image image;
    snprintf(path, sizeof path, "%.*s%s", length, model, ending);
    uint8_t *data = read_file(path, &size);
    *texture = (struct texture){0};
    if (data != NULL && tga_decode(&image, data, size)) {
        struct texture_level *level = texture->level;
        const size_t count = image.width * image.height;
        *level = (struct texture_level){image.width, image.height, image.width, malloc(4 * count)};
        for (size_t i = 0; level->texels != NULL && i < count; i++) {
            const uint8_t *p = image.pixels + 4 * i;
            level->texels[i] =
                p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
        }
        for (bool more = level->texels != NULL; more; level++) {
            texture->level_count++;
            more = (level->width > 1 || level->height > 1) && texture_shrink(level, level + 1);
        }
        free(image.pixels);
    }
    free(data);
}

static void texture_free(struct texture *texture) {
    for (size_t i = 0; i < texture->level_count; i++) {
        free(texture->level[i].texels);
    }
}

static void model_free(struct model *model) {
    free(model->positions);
    free(model->uvs);
    free(model->normals);
    free(model->faces);
    *model = (struct model){0};
}

/* The list with room for one more behind `count`, doubled at each power of two; NULL when memory
 * runs out, and the list stays as it is. */
static void *with_room(void *list, size_t count, size_t size) {
    return (count & (count - 1)) == 0 ? realloc(list, (count > 0 ? 2 * count : 1) * size) : list;
}

/* Each adds one to the model; false when memory runs out. */
static bool add_position(struct model *model, struct vec3 p) {
    void *larger = with_room(model->positions, model->position_count, sizeof *model->positions);
    if (larger != NULL) {
        model->positions = larger;
        model->positions[model->position_count++] = p;
    }
    return larger != NULL;
}

static bool add_uv(struct model *model, struct vec2 uv) {
    void *larger = with_room(model->uvs, model->uv_count, sizeof *model->uvs);
    if (larger != NULL) {
        model->uvs = larger;
        float *to = model->uvs[model->uv_count++];
        to[0] = (float)uv.x, to[1] = (float)uv.y;
    }
    return larger != NULL;
}

static bool add_normal(struct model *model, struct vec3 n) {
    void *larger = with_room(model->normals, model->normal_count, sizeof *model->normals);
    if (larger != NULL) {
        model->normals = larger;
        float *to = model->normals[model->normal_count++];
        to[0] = (float)n.x, to[1] = (float)n.y, to[2] = (float)n.z;
    }
    return larger != NULL;
}

static bool add_face(struct model *model, struct corner a, struct corner b, struct corner c) {
    void *larger = with_room(model->faces, model->face_count, sizeof *model->faces);
    if (larger != NULL) {
        model->faces = larger;
        model->faces[model->face_count++] = (struct face){{a, b, c}};
    }
    return larger != NULL;
}

/* An index as files have it, from 1 or, if negative, from the last one; and the slash behind it. */
static uint32_t read_index(char **at, size_t count) {
    long long i = isspace((unsigned char)**at) ? 0 : strtoll(*at, at, 10);
    *at += **at == '/';
    i = i < 0 ? (long long)count + i : i - 1;
    return i >= 0 && (size_t)i < count ? (uint32_t)i : MODEL_NONE;
}

/* A polygon becomes a fan of triangles, up to a corner that cannot be read. */
static bool read_face(struct model *model, char *at) {
    struct corner corner, first = {0, 0, 0}, last = {0, 0, 0};
    for (int i = 0;; i++, last = corner) {
        while (isspace((unsigned char)*at)) {
            at++;
        }
        corner.position = read_index(&at, model->position_count);
        corner.uv = read_index(&at, model->uv_count);
        corner.normal = read_index(&at, model->normal_count);
        if (corner.position == MODEL_NONE || (*at != '\0' && !isspace((unsigned char)*at))) {
            return true;
        }
        first = i == 0 ? corner : first;
        if (i >= 2 && !add_face(model, first, last, corner)) {
            return false;
        }
    }
}

/* One line: v, vt, vn or f; others say nothing here. */
static bool read_line(struct model *model, char *line) {
    char *at = line + strcspn(line, " \t");
    const char kind = at - line == 1 && *line == 'v'   ? 'v'
                      : at - line == 2 && *line == 'v' ? line[1]
                                                       : 0;
    double n[3] = {0, 0, 0};
    if (at - line == 1 && *line == 'f') {
        return read_face(model, at);
    }
    for (int i = 0; i < 3 && kind != 0; i++) {
        n[i] = strtod(at, &at);
        n[i] = fabs(n[i]) <= 1e30 ? n[i] : 0;
    }
    return kind == 'v'   ? add_position(model, (struct vec3){n[0], n[1], n[2]})
           : kind == 't' ? add_uv(model, (struct vec2){n[0], n[1]})
           : kind == 'n' ? add_normal(model, (struct vec3){n[0], n[1], n[2]})
                         : true;
}

/* Normals of positions, the sums of those of the faces there, for a file that has none. */
static bool make_normals(struct model *model) {
    model->normals = calloc(model->position_count, sizeof *model->normals);
    for (size_t i = 0; model->normals != NULL && i < 3 * model->face_count; i++) {
        struct corner *corner = &model->faces[i / 3].corner[i % 3];
        const struct vec3 a = model_position(model, i / 3, 0);
        const struct vec3 n = vec3_cross(vec3_sub(model_position(model, i / 3, 1), a),
                                         vec3_sub(model_position(model, i / 3, 2), a));
        float *sum = model->normals[corner->position];
        corner->normal = corner->position;
        sum[0] += (float)n.x, sum[1] += (float)n.y, sum[2] += (float)n.z;
    }
    model->normal_count = model->position_count;
    return model->normals != NULL;
}

/* Into -1..1, where the model is far outside of that or tiny. */
static void model_fit(struct model *model) {
    struct vec3 least = model->positions[0], most = least;
    for (size_t i = 0; i < model->position_count; i++) {
        const struct vec3 p = model->positions[i];
        least = (struct vec3){fmin(least.x, p.x), fmin(least.y, p.y), fmin(least.z, p.z)};
        most = (struct vec3){fmax(most.x, p.x), fmax(most.y, p.y), fmax(most.z, p.z)};
    }
    const struct vec3 size = vec3_sub(most, least), middle = vec3_scale(vec3_sub(most, least), 0.5);
    const double longest = fmax(size.x, fmax(size.y, size.z));
    const double reach =
        fmax(fmax(fmax(-least.x, most.x), fmax(-least.y, most.y)), fmax(-least.z, most.z));
    for (size_t i = 0; longest > 0 && (reach > 1 || longest < 0.2) && i < model->position_count;
         i++) {
        const struct vec3 p = vec3_sub(vec3_sub(model->positions[i], least), middle);
        model->positions[i] = vec3_scale(p, 1.9 / longest);
    }
}

/* False, and no faces, where it cannot be read. */
static bool model_read(struct model *model, const char *path) {
    size_t size;
    char *data = (char *)read_file(path, &size), *next = data;
    bool read = data != NULL;
    *model = (struct model){0};
    for (char *line = data; read && line != NULL && line < data + size; line = next) {
        next = strchr(line, '\n');
        if (next != NULL) {
            *next++ = '\0';
        }
        read = read_line(model, line);
    }
    free(data);
    read = read && model->face_count > 0 && (model->normal_count > 0 || make_normals(model));
    if (!read) {
        model_free(model);
    } else {
        model_fit(model);
    }
    return read;
}

/* @lesson step01_line line: a line */

/* @lesson step02_wireframe struct.side list_sides keep_one_of_each line_inside: each side once,
 * cut to the picture */

/* @lesson step03_triangle triangle_setup triangle_span triangle_weights: the pixels of a triangle
 * */

/* @lesson step04_flat face_intensity: light on a face */

/* @lesson step05_zbuffer show_depths: depths as a picture */

/* @lesson step06_texture sample_bilinear: textures */

/* @lesson step07_gouraud corner_intensity: light at a corner */

/* @lesson step08_projection projection lookat correct_weights struct.clip_corner struct.polygon
 * POLYGON_LIMIT CLIP_PLANES clip_at_plane BEYOND_NEAR BEYOND_GUARD_BAND find_beyond: perspective,
 * camera, clipping */

/* @frame: numbers of one pixel (given) */

static lanes lanes_select(lanes_mask mask, lanes a, lanes b) {
    return mask[0] != 0 ? a : b;
}

static lanes lanes_floor(lanes a) {
    return (lanes){floorf(a[0])};
}

static lanes lanes_max(lanes a, lanes b) {
    return a[0] > b[0] ? a : b;
}

static struct lanes3 lanes3_normalized(struct lanes3 a) {
    const real square = lanes3_dot(a, a)[0];
    return lanes3_scale(a, lanes_all(1 / sqrtf(square > 0 ? square : 1)));
}

static lanes_texel lanes_rgb(lanes red, lanes green, lanes blue) {
    return (lanes_texel){level_from(blue[0]) | (uint32_t)level_from(green[0]) << 8 |
                         (uint32_t)level_from(red[0]) << 16 | UINT32_C(0xFF000000)};
}

static struct lanes3 texture_lanes(const struct texture *texture, struct lanes2 uv, size_t level) {
    const size_t last = texture->level_count - 1;
    const struct vec4 c =
        texture_bilinear(texture, (struct vec2){uv.x[0], uv.y[0]}, level < last ? level : last);
    return (struct lanes3){{(real)c.x}, {(real)c.y}, {(real)c.z}};
}

/* Lesson 10 asks for the texels of several textures before it mixes any. */
struct texel_place {
    char unused;
};

struct texels {
    struct lanes3 mixed;
};

static struct texels texture_fetch(const struct texture *texture, struct lanes2 uv, size_t level,
                                   struct texel_place *place) {
    (void)place;
    return (struct texels){texture_lanes(texture, uv, level)};
}

static struct lanes3 texels_mix(const struct texels *texels) {
    return texels->mixed;
}

struct shader {
    size_t varying_count;
    void (*vertex)(const void *uniforms, size_t face, size_t corner, double *varyings);
    lanes_mask (*fragment)(const void *uniforms, const lanes *varyings, lanes_texel *color);
};

#define SHADER(name, ...) static const struct shader name = {__VA_ARGS__}

/* @lesson step09_shaders struct.simple_shader struct.canvas struct.kept_face struct.band
 * keep_faces visible_draw toon_pixel: each visible pixel once */

/* @lesson step10_phong struct.uniforms plain textured full weight_mapped turning_light: Phong */

/* @frame: the parts together (given) */

/* A square picture of the model, seen from the eye. */
static struct draw_call camera_call(const struct model *model, struct vec3 eye, int size) {
    const double zoom = 0.85;
    const struct mat4 camera =
        mat4_mul(mat4_projection(vec3_length(eye)),
                 mat4_lookat(eye, (struct vec3){0, 0, 0}, (struct vec3){0, 1, 0}));
    return (struct draw_call){.model = model,
                              .to_clip =
                                  mat4_mul(mat4_scaling((struct vec3){zoom, zoom, 1}), camera),
                              .viewport = {0, 0, size, size},
                              .cull = CULL_BACK};
}

/* ---- Clipping: what is left of faces becomes faces of the model for a while ---- */

/* A corner between those of a face. */
static bool add_corner(struct model *model, size_t face, struct vec3 weight,
                       struct corner *corner) {
    struct vec3 p[3], n[3];
    struct vec2 uv[3];
    for (size_t i = 0; i < 3; i++) {
        p[i] = model_position(model, face, i);
        n[i] = model_normal(model, face, i);
        uv[i] = model_uv(model, face, i);
    }
    *corner = (struct corner){(uint32_t)model->position_count, (uint32_t)model->uv_count,
                              (uint32_t)model->normal_count};
    return add_position(model, vec3_interpolate(weight, p[0], p[1], p[2])) &&
           add_uv(model, (struct vec2){interpolate(weight, uv[0].x, uv[1].x, uv[2].x),
                                       interpolate(weight, uv[0].y, uv[1].y, uv[2].y)}) &&
           add_normal(model, vec3_interpolate(weight, n[0], n[1], n[2]));
}

/* What is left of a face that must be cut; of others there is nothing to add. */
static struct polygon clip_face(const struct draw_call *call, size_t face) {
    static const struct vec3 corner[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct polygon polygon = {.count = 3};
    unsigned all = ~0u, any = 0;
    for (size_t i = 0; i < 3; i++) {
        const struct vec4 clip = mat4_point(&call->to_clip, model_position(call->model, face, i));
        polygon.corner[i] = (struct clip_corner){.clip = clip, .weight = corner[i]};
        all &= find_beyond(clip);
        any |= find_beyond(clip);
    }
    if (all != 0 || (any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0) {
        polygon.count = 0;
    }
    for (int plane = 0; plane < CLIP_PLANES && polygon.count > 0; plane++) {
        polygon = clip_at_plane(&polygon, plane);
    }
    return polygon;
}

/* Add them to the model, whose counts the caller keeps. */
static bool add_clipped(struct model *model, const struct draw_call *call) {
    const size_t count = model->face_count;
    bool done = true;
    for (size_t i = 0; done && i < count; i++) {
        const struct polygon polygon = clip_face(call, i);
        struct corner corner[POLYGON_LIMIT];
        for (size_t k = 0; done && k < polygon.count; k++) {
            done = add_corner(model, i, polygon.corner[k].weight, &corner[k]);
        }
        for (size_t k = 2; done && k < polygon.count; k++) {
            done = add_face(model, corner[0], corner[k - 1], corner[k]);
        }
    }
    return done;
}

/* ---- Looks ---- */

/* What shaders are given here: those of lesson 10 have uniforms of their own. */
struct frame {
    const struct model *model;
    struct vec3 to_light;
    const struct shader *shader;
    struct uniforms uniforms;
};

static void flat_look(const void *frame, size_t face, size_t corner, double *varyings) {
    const struct frame *f = frame;
    (void)corner;
    varyings[0] = face_intensity(f->model, face, f->to_light);
}

static void gouraud_look(const void *frame, size_t face, size_t corner, double *varyings) {
    const struct frame *f = frame;
    varyings[0] =
        corner_intensity(vec3_normalized(model_normal(f->model, face, corner)), f->to_light);
}

static bool white_look(const void *frame, const double *varyings, struct vec3 *rgb) {
    (void)frame;
    *rgb = vec3_scale((struct vec3){255, 255, 255}, varyings[0]);
    return true;
}

static void phong_look(const void *frame, size_t face, size_t corner, double *varyings) {
    const struct frame *f = frame;
    f->shader->vertex(&f->uniforms, face, corner, varyings);
}

static bool phong_pixel(const void *frame, const double *varyings, struct vec3 *rgb) {
    const struct frame *f = frame;
    lanes numbers[VARYING_LIMIT];
    lanes_texel color = {0};
    for (size_t i = 0; i < f->shader->varying_count; i++) {
        numbers[i] = lanes_all((real)varyings[i]);
    }
    const bool drawn = f->shader->fragment(&f->uniforms, numbers, &color)[0] != 0;
    const uint32_t texel = color[0];
    *rgb = (struct vec3){texel >> 16 & 255, texel >> 8 & 255, texel & 255};
    return drawn;
}

enum look { LOOK_PHONG, LOOK_TOON, LOOK_GOURAUD, LOOK_FLAT, LOOK_DEPTH, LOOK_LINES, LOOKS };

static const char *const look_names[LOOKS] = {"phong", "toon",  "gouraud",
                                              "flat",  "depth", "wireframe"};

static const struct simple_shader look_shaders[] = {
    {0, phong_look, phong_pixel}, {1, gouraud_look, toon_pixel}, {1, gouraud_look, white_look},
    {1, flat_look, white_look},   {1, flat_look, white_look},
};

/* Where a position in front of the eye is on the screen; false for others. */
static bool to_screen(const struct draw_call *call, struct vec3 position, struct pixel *pixel) {
    const struct vec4 p = mat4_point(&call->to_clip, position);
    const double half = call->viewport.width / 2.0;
    *pixel = (struct pixel){(int)floor((p.x / p.w + 1) * half), (int)floor((p.y / p.w + 1) * half)};
    return (find_beyond(p) & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0;
}

static bool is_inside(const struct image *image, struct pixel p) {
    return p.x >= 0 && p.y >= 0 && p.x < (int)image->width && p.y < (int)image->height;
}

/* The sides of the faces: whole lines as in lesson 1, those that leave the picture as in 2. */
static bool draw_lines(struct image *image, const struct draw_call *call) {
    const struct model *model = call->model;
    const struct color white = color_rgb(255, 255, 255);
    struct side *sides = malloc(3 * model->face_count * sizeof *sides);
    size_t count = 0;
    if (sides != NULL) {
        list_sides(model, sides);
        count = keep_one_of_each(sides, 3 * model->face_count);
    }
    for (size_t i = 0; i < count; i++) {
        struct pixel a, b;
        if (!to_screen(call, model->positions[sides[i].low], &a) ||
            !to_screen(call, model->positions[sides[i].high], &b)) {
            continue;
        }
        if (is_inside(image, a) && is_inside(image, b)) {
            line(image, a, b, white);
        } else {
            line_inside(image, a, b, white);
        }
    }
    free(sides);
    return sides != NULL;
}

static bool draw_faces(struct image *image, const struct draw_call *call, enum look look,
                       const struct frame *frame, struct model *model) {
    const size_t pixels = image->width * image->height, faces = model->face_count;
    const size_t counts[] = {model->position_count, model->uv_count, model->normal_count};
    struct simple_shader shader = look_shaders[look];
    struct canvas canvas = {.image = image};
    struct band band = {.rows = {0, look == LOOK_DEPTH ? (int)image->height : 32},
                        .width = image->width,
                        .depth = malloc(pixels * sizeof *band.depth),
                        .nearest = malloc(pixels * sizeof *band.nearest)};
    bool done = band.depth != NULL && band.nearest != NULL && add_clipped(model, call);
    struct kept_face *kept = done ? malloc((model->face_count + 1) * sizeof *kept) : NULL;
    if (look == LOOK_PHONG) {
        shader.varying_count = frame->shader->varying_count;
    }
    if (kept != NULL) {
        const size_t count = keep_faces(&canvas, call, kept);
        visible_draw(&canvas, band, kept, (uint32_t)count, &shader, frame);
        if (look == LOOK_DEPTH) {
            show_depths(image, band.depth);
        }
    }
    model->position_count = counts[0], model->uv_count = counts[1];
    model->normal_count = counts[2], model->face_count = faces;
    free(kept);
    free(band.depth);
    free(band.nearest);
    return kept != NULL;
}

/* ---- The program ---- */

struct options {
    struct vec3 eye;
    int size, frames, repeat, look;
};

static bool read_options(struct options *options, int argc, char **argv) {
    struct vec3 *eye = &options->eye;
    bool good = argc >= 2 && argc % 2 == 0;
    for (int i = 2; i < argc && good; i += 2) {
        const char *name = argv[i], *value = argv[i + 1];
        if (strcmp(name, "--look") == 0) {
            options->look = 0;
            while (options->look < LOOKS && strcmp(look_names[options->look], value) != 0) {
                options->look++;
            }
            continue;
        }
        int *number = strcmp(name, "--size") == 0     ? &options->size
                      : strcmp(name, "--frames") == 0 ? &options->frames
                      : strcmp(name, "--repeat") == 0 ? &options->repeat
                                                      : NULL;
        good = number != NULL ? sscanf(value, "%d", number) == 1
                              : strcmp(name, "--eye") == 0 &&
                                    sscanf(value, "%lf,%lf,%lf", &eye->x, &eye->y, &eye->z) == 3;
    }
    return good && options->size >= 1 && options->size <= DRAW_LIMIT && options->look < LOOKS &&
           vec3_length(*eye) > 0;
}

int main(int argc, char **argv) {
    struct options o = {.eye = {1, 0.5, 3}, .size = 800, .frames = 36, .repeat = 1};
    if (!read_options(&o, argc, argv)) {
        fprintf(stderr,
                "renderer model.obj [--look phong|toon|gouraud|flat|depth|wireframe]\n"
                "                   [--eye 1,0.5,3] [--size 800] [--frames 36] [--repeat 1]\n");
        return 2;
    }
    struct model model;
    struct image image;
    struct texture diffuse, normals, shine;
    if (!model_read(&model, argv[1])) {
        fprintf(stderr, "renderer: cannot read %s\n", argv[1]);
        return 1;
    }
    texture_read(&diffuse, argv[1], "_diffuse.tga");
    texture_read(&normals, argv[1], "_nm.tga");
    texture_read(&shine, argv[1], "_spec.tga");
    const enum image_format format = o.look == LOOK_DEPTH ? IMAGE_GREY : IMAGE_BGRA;
    const double seen = 0.85 * o.size;
    const struct draw_call call = camera_call(&model, o.eye, o.size);
    struct frame frame = {
        .model = &model,
        .shader = diffuse.level_count == 0   ? &plain
                  : normals.level_count == 0 ? &textured
                  : shine.level_count == 0   ? &full
                                             : &weight_mapped,
        .uniforms = {.model = &model,
                     .diffuse = &diffuse,
                     .normal_map = &normals,
                     .specular = &shine,
                     .diffuse_level = texture_wrapped_level(&diffuse, seen),
                     .normal_level = texture_wrapped_level(&normals, seen),
                     .specular_level = texture_wrapped_level(&shine, seen),
                     .eye = o.eye,
                     .material = {0.1, 1, 1, 10, {255, 255, 255}}},
    };
    bool done = image_create(&image, (size_t)o.size, (size_t)o.size, format);
    for (int i = 0; i < o.frames && done; i++) {
        char path[64];
        frame.to_light = frame.uniforms.to_light = turning_light((double)i / o.frames);
        const clock_t begin = clock();
        for (int k = 0; k < o.repeat && done; k++) {
            memset(image.pixels, 0, image.width * image.height * image.format);
            done = o.look == LOOK_LINES
                       ? draw_lines(&image, &call)
                       : draw_faces(&image, &call, (enum look)o.look, &frame, &model);
        }
        if (o.repeat > 1) {
            printf("%.2f ms\n", 1000.0 * (double)(clock() - begin) / CLOCKS_PER_SEC / o.repeat);
        }
        snprintf(path, sizeof path, "turn_%03d.tga", i);
        done = done && tga_write(&image, path);
    }
    if (!done) {
        fprintf(stderr, "renderer: out of memory, or a picture cannot be written\n");
    }
    texture_free(&diffuse);
    texture_free(&normals);
    texture_free(&shine);
    model_free(&model);
    free(image.pixels);
    return !done;
}
