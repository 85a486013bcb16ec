/* The frame of what `make renderer` writes: see renderer.awk. What stands here is given; a comment
 * with an @ says where the functions of a lesson go. */
#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* @common geometry raster tgaimage camera lines parallel_view triangles: Vectors, matrices, places
 * on the screen (given) */

static struct vec4 mat4_point(const struct mat4 *a, struct vec3 p) {
    double to[4];
    for (int i = 0; i < 4; i++) {
        to[i] = a->m[i][0] * p.x + a->m[i][1] * p.y + a->m[i][2] * p.z + a->m[i][3];
    }
    return (struct vec4){to[0], to[1], to[2], to[3]};
}

/* A depth inside a triangle, exact where all three are equal. */
static double interpolate_depth(struct vec3 weight, double a, double b, double c) {
    return a + weight.y * (b - a) + weight.z * (c - a);
}

/* The pixels of a row or column whose centres lie in least..most (1/256 pixel), cut to 0..size. */
static struct span centers_between(int32_t least, int32_t most, size_t size) {
    const int64_t begin = ((int64_t)least + 127) >> 8, end = ((int64_t)most + 128) >> 8;
    return (struct span){(int)(begin > 0 ? begin : 0),
                         (int)(end < (int64_t)size ? end : (int64_t)size)};
}

/* Of length 1, in the same direction; zero stays zero. */
static struct vec3 vec3_normalized(struct vec3 a) {
    const double square = vec3_dot(a, a);
    return square > 0 ? vec3_scale(a, 1 / sqrt(square)) : a;
}

/* (cos, sin) of an angle in whole turns. */
static struct vec2 turn_direction(double turns) {
    return (struct vec2){cos(turns * 6.283185307179586), sin(turns * 6.283185307179586)};
}

/* @frame: Images, textures, models, and their files (given) */

static _Noreturn void fail(const char *problem, const char *path) {
    fprintf(stderr, "renderer: %s%s\n", problem, path);
    exit(1);
}

/* Memory for so many things, those of `old` first. */
static void *memory(void *old, size_t count, size_t size) {
    void *larger = count <= SIZE_MAX / size ? realloc(old, count * size) : NULL;
    if (larger == NULL) {
        fail("out of memory", "");
    }
    return larger;
}

enum image_format { IMAGE_GREY = 1, IMAGE_BGR = 3 }; /* bytes of a pixel */

struct image {
    size_t width, height;
    enum image_format format;
    uint8_t *pixels; /* grey, or blue, green, red; row by row from the bottom */
};

/* False where there is no such pixel. */
static bool image_set(struct image *image, int x, int y, struct color color) {
    if (x < 0 || y < 0 || (size_t)x >= image->width || (size_t)y >= image->height) {
        return false;
    }
    memcpy(image->pixels + ((size_t)y * image->width + (size_t)x) * image->format, &color,
           image->format);
    return true;
}

struct texture_level {
    size_t width, height, pitch;
    uint32_t *texels; /* blue | green << 8 | red << 16 | alpha << 24 */
};

/* One level, halved until it suits the picture. */
struct texture {
    size_t level_count; /* 0 where there is no file */
    struct texture_level level[1];
    bool clamp;
};

/* Red, green, blue, alpha as x, y, z, w. */
static struct vec4 channels_from_texel(uint32_t texel) {
    return (struct vec4){texel >> 16 & 255, texel >> 8 & 255, texel & 255, texel >> 24};
}

/* Indices into the model's lists. Index 0 is a zero vector, for whatever a file leaves out. */
struct corner {
    uint32_t position, uv, normal;
};

struct face {
    struct corner corner[3]; /* counterclockwise as seen from outside */
};

struct uv {
    float x, y;
};

struct model {
    size_t position_count, uv_count, normal_count, face_count;
    struct vec3 *positions, *normals;
    struct uv *uvs;
    struct face *faces;
};

static struct vec3 model_position(const struct model *model, size_t face, size_t corner) {
    return model->positions[model->faces[face].corner[corner].position];
}

static struct vec2 model_uv(const struct model *model, size_t face, size_t corner) {
    const struct uv uv = model->uvs[model->faces[face].corner[corner].uv];
    return (struct vec2){uv.x, uv.y};
}

static struct vec3 model_normal(const struct model *model, size_t face, size_t corner) {
    return model->normals[model->faces[face].corner[corner].normal];
}

/* @common texture bilinear model faces: */

/* Grey, 24 and 32 bits, raw or run-length coded, from any corner. False for others. */
static bool tga_read(struct texture_level *level, FILE *file) {
    uint8_t head[18] = {0}, p[4] = {0, 0, 0, 255};
    const long size = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : 0;
    rewind(file);
    const bool known = fread(head, 1, sizeof head, file) == sizeof head && head[1] == 0 &&
                       (head[2] & ~9) == 2 && fseek(file, head[0], SEEK_CUR) == 0;
    const size_t width = head[12] + 256u * head[13], height = head[14] + 256u * head[15];
    const size_t bytes = head[16] / 8u, pixels = width * height, colors = bytes > 1;
    const bool packed = head[2] & 8;
    if (!known || (bytes != 1 && bytes != 3 && bytes != 4) || pixels == 0 ||
        pixels / 128 > (size_t)size) {
        return false;
    }
    *level = (struct texture_level){width, height, width, memory(NULL, pixels, sizeof(uint32_t))};
    int left = 0; /* of a packet */
    bool repeats = false;
    for (size_t i = 0; i < pixels; i++, left -= packed) {
        const bool same = repeats && left > 0;
        if (packed && left == 0) {
            const int packet = getc(file);
            repeats = packet >= 128;
            left = packet % 128 + 1;
        }
        if (!same && fread(p, 1, bytes, file) != bytes) {
            free(level->texels);
            return false;
        }
        const size_t x = head[17] & 16 ? width - 1 - i % width : i % width;
        const size_t y = head[17] & 32 ? height - 1 - i / width : i / width;
        level->texels[y * width + x] =
            p[0] | (uint32_t)p[colors] << 8 | (uint32_t)p[2 * colors] << 16 | (uint32_t)p[3] << 24;
    }
    return true;
}

/* Grey of 8 bits, or colours of 24. */
static void tga_write(const struct image *image, const char *path) {
    const size_t w = image->width, h = image->height, bytes = image->format;
    const uint8_t kind = bytes == 1 ? 3 : 2, bits = 8 * bytes & 255;
    const uint8_t head[18] = {[2] = kind,     [12] = w & 255,      [13] = w >> 8 & 255,
                              [14] = h & 255, [15] = h >> 8 & 255, [16] = bits};
    FILE *file = fopen(path, "wb");
    if (file == NULL || fwrite(head, sizeof head, 1, file) != 1 ||
        fwrite(image->pixels, bytes * w, h, file) != h || fclose(file) != 0) {
        fail("cannot write ", path);
    }
}

/* Half the width and height, each texel the mean of four. */
static void halve(struct texture_level *level) {
    const struct texture_level from = *level;
    const size_t w = from.width / 2, h = from.height > 1 ? from.height / 2 : 1;
    const size_t above = from.height > 1 ? from.width : 0;
    *level = (struct texture_level){w, h, w, memory(NULL, w * h, sizeof *from.texels)};
    for (size_t i = 0; i < w * h; i++) {
        const uint32_t *p = from.texels + 2 * (i / w) * from.width + 2 * (i % w);
        level->texels[i] = 0;
        for (int shift = 0; shift < 32; shift += 8) {
            const uint32_t sum = (p[0] >> shift & 255) + (p[1] >> shift & 255) +
                                 (p[above] >> shift & 255) + (p[above + 1] >> shift & 255);
            level->texels[i] |= (sum + 2) / 4 << shift;
        }
    }
    free(from.texels);
}

/* Read head_nm.tga, given "head.obj" and "_nm.tga", and halve it until it suits so many pixels.
 * Without that file the texture is one white texel. */
static void texture_read(struct texture *texture, const char *model, const char *ending,
                         double pixels) {
    char path[4096];
    const char *dot = strrchr(model, '.');
    const int length = dot != NULL ? (int)(dot - model) : (int)strlen(model);
    snprintf(path, sizeof path, "%.*s%s", length, model, ending);
    FILE *file = fopen(path, "rb");
    texture->clamp = false;
    texture->level_count = file != NULL && tga_read(texture->level, file);
    if (texture->level_count == 0) {
        *texture->level = (struct texture_level){1, 1, 1, memory(NULL, 1, sizeof(uint32_t))};
        *texture->level->texels = UINT32_MAX;
    }
    while ((double)texture->level->width / 2 > 1.5 * pixels) {
        halve(texture->level);
    }
    if (file != NULL) {
        fclose(file);
    }
}

/* The list with room for one more behind `count`: doubled at each power of two. */
static void *with_room(void *list, size_t count, size_t size) {
    return (count & (count - 1)) == 0 ? memory(list, count > 0 ? 2 * count : 1, size) : list;
}

#define ADD(m, item, ...)                                                                          \
    ((m)->item##s = with_room((m)->item##s, (m)->item##_count, sizeof *(m)->item##s),              \
     (m)->item##s[(m)->item##_count++] = __VA_ARGS__)

/* Read an index, which counts from 1 or, if negative, from the end, and the slash behind it. */
static uint32_t read_index(char **at, size_t count) {
    long long i = strtoll(*at, at, 10);
    *at += **at == '/';
    i = i < 0 ? (long long)count + i : i;
    return i > 0 && i < (long long)count ? (uint32_t)i : 0;
}

/* A polygon becomes a fan of triangles, up to a corner that cannot be read. */
static void read_face(struct model *model, char *words) {
    struct corner corner, first = {0, 0, 0}, last = {0, 0, 0};
    char *at = strtok(words, " \t\r\n");
    for (int i = 0; at != NULL; i++, at = strtok(NULL, " \t\r\n"), last = corner) {
        corner.position = read_index(&at, model->position_count);
        corner.uv = read_index(&at, model->uv_count);
        corner.normal = read_index(&at, model->normal_count);
        if (corner.position == 0 || *at != '\0') {
            return;
        }
        first = i == 0 ? corner : first;
        if (i >= 2) {
            ADD(model, face, (struct face){{first, last, corner}});
        }
    }
}

/* For a file without normals: at each position the sum of the normals of its faces. */
static void make_normals(struct model *model) {
    while (model->normal_count < model->position_count) {
        ADD(model, normal, (struct vec3){0});
    }
    for (size_t i = 0; i < 3 * model->face_count; i++) {
        struct corner *corner = &model->faces[i / 3].corner[i % 3];
        const struct vec3 a = model_position(model, i / 3, 0);
        const struct vec3 n = vec3_cross(vec3_sub(model_position(model, i / 3, 1), a),
                                         vec3_sub(model_position(model, i / 3, 2), a));
        struct vec3 *sum = &model->normals[corner->position];
        corner->normal = corner->position;
        *sum = (struct vec3){sum->x + n.x, sum->y + n.y, sum->z + n.z};
    }
}

/* Move and scale a model into -1..1, where it reaches beyond or is tiny. */
static void model_fit(struct model *model) {
    struct vec3 least = model->positions[1], most = least;
    double reach = 0;
    for (size_t i = 1; i < model->position_count; i++) {
        const struct vec3 p = model->positions[i];
        least = (struct vec3){fmin(least.x, p.x), fmin(least.y, p.y), fmin(least.z, p.z)};
        most = (struct vec3){fmax(most.x, p.x), fmax(most.y, p.y), fmax(most.z, p.z)};
        reach = fmax(fmax(reach, fabs(p.x)), fmax(fabs(p.y), fabs(p.z)));
    }
    const struct vec3 size = vec3_sub(most, least);
    const double longest = fmax(size.x, fmax(size.y, size.z));
    for (size_t i = 1; i < model->position_count && longest > 0; i++) {
        if (reach > 1 || longest < 0.2) {
            const struct vec3 p = vec3_sub(model->positions[i], least);
            model->positions[i] = vec3_scale(vec3_sub(p, vec3_scale(size, 0.5)), 1.9 / longest);
        }
    }
}

static void model_read(struct model *model, const char *path) {
    char line[65536];
    FILE *file = fopen(path, "rb");
    *model = (struct model){0};
    ADD(model, position, (struct vec3){0});
    ADD(model, uv, (struct uv){0});
    ADD(model, normal, (struct vec3){0});
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        char kind[3] = "";
        struct vec3 v = {0};
        sscanf(line, "%2s %lf %lf %lf", kind, &v.x, &v.y, &v.z);
        if (!(vec3_dot(v, v) <= 1e60)) { /* a broken file's */
            v = (struct vec3){0};
        }
        if (strcmp(kind, "v") == 0) {
            ADD(model, position, v);
        } else if (strcmp(kind, "vt") == 0) {
            ADD(model, uv, (struct uv){(float)v.x, (float)v.y});
        } else if (strcmp(kind, "vn") == 0) {
            ADD(model, normal, v);
        } else if (strcmp(kind, "f") == 0) {
            read_face(model, strchr(line, 'f') + 1);
        }
    }
    if (model->face_count == 0) {
        fail("cannot read a model from ", path);
    }
    fclose(file);
    if (model->normal_count == 1) {
        make_normals(model);
    }
    model_fit(model);
}

/* @lesson step01_line line: a line */

/* @lesson step02_wireframe struct.side list_sides keep_one_of_each line_inside: each side once,
 * cut to the picture */

/* @lesson step03_triangle triangle_setup triangle_span triangle_weights: a triangle's pixels */

/* @lesson step04_flat face_intensity: light on a face */

/* @lesson step05_zbuffer show_depths: depths as a picture */

/* @lesson step06_texture sample_bilinear: textures */

/* @lesson step07_gouraud corner_intensity: light at a corner */

/* @lesson step08_projection projection lookat correct_weights struct.clip_corner struct.polygon
 * POLYGON_LIMIT CLIP_PLANES clip_at_plane BEYOND_NEAR BEYOND_GUARD_BAND find_beyond: perspective,
 * camera, clipping */

/* @frame: Numbers of one pixel (given) */

/* Lesson 10 computes with `lanes`, the numbers of several pixels. Here they are those of one. */
typedef float real;
typedef float lanes;
typedef int lanes_mask;
typedef uint32_t lanes_texel;
#define LANES                    1
#define lanes_all(value)         ((real)(value))
#define lanes_all_set()          1
#define lanes_select(mask, a, b) ((mask) ? (a) : (b))
#define lanes_floor              floorf
#define lanes_max                fmaxf

/* @common lanes: */

static struct lanes3 lanes3_normalized(struct lanes3 a) {
    const lanes square = lanes3_dot(a, a);
    return square > 0 ? lanes3_scale(a, 1 / sqrtf(square)) : a;
}

static lanes_texel lanes_rgb(lanes red, lanes green, lanes blue) {
    return level_from(blue) | (uint32_t)level_from(green) << 8 | (uint32_t)level_from(red) << 16;
}

static struct lanes3 texture_lanes(const struct texture *texture, struct lanes2 uv, size_t level) {
    const struct vec4 c = texture_bilinear(texture, (struct vec2){uv.x, uv.y}, level);
    return (struct lanes3){(real)c.x, (real)c.y, (real)c.z};
}

/* Lesson 10 fetches several textures before it mixes any. Here each is mixed at once. */
struct texels {
    struct lanes3 mixed;
};

#define texel_place                    lanes2
#define texels_mix(fetched)            ((fetched)->mixed)
#define texture_fetch(t, uv, level, p) ((void)(p), (struct texels){texture_lanes(t, uv, level)})
#define SHADER(name, ...)              static const struct shader name = {__VA_ARGS__}

struct shader {
    size_t varying_count;
    void (*vertex)(const void *uniforms, size_t face, size_t corner, double *varyings);
    lanes_mask (*fragment)(const void *uniforms, const lanes *varyings, lanes_texel *color);
};

/* @common pipeline: */

/* @lesson step09_shaders struct.simple_shader struct.canvas struct.kept_face struct.band
 * keep_faces visible_draw toon_pixel: each visible pixel once */

/* @lesson step10_phong struct.uniforms textured weight_mapped turning_light: Phong */

/* @frame: Clipping, looks, the program (given) */

/* Add a corner between those of a face. */
static struct corner add_corner(struct model *model, size_t face, struct vec3 weight) {
    struct vec3 p[3], n[3];
    struct vec2 uv[3];
    for (size_t i = 0; i < 3; i++) {
        p[i] = model_position(model, face, i);
        uv[i] = model_uv(model, face, i);
        n[i] = model_normal(model, face, i);
    }
    ADD(model, position, vec3_interpolate(weight, p[0], p[1], p[2]));
    ADD(model, uv,
        (struct uv){(float)interpolate(weight, uv[0].x, uv[1].x, uv[2].x),
                    (float)interpolate(weight, uv[0].y, uv[1].y, uv[2].y)});
    ADD(model, normal, vec3_interpolate(weight, n[0], n[1], n[2]));
    return (struct corner){(uint32_t)model->position_count - 1, (uint32_t)model->uv_count - 1,
                           (uint32_t)model->normal_count - 1};
}

/* Clip the faces that need it, and add their parts to the model, as faces. */
static void add_clipped(struct model *model, const struct draw_call *call) {
    for (size_t face = 0, count = model->face_count; face < count; face++) {
        struct polygon polygon = {.count = 3};
        struct corner corner[POLYGON_LIMIT];
        unsigned all = ~0u, any = 0;
        for (size_t i = 0; i < 3; i++) {
            const struct vec4 clip = mat4_point(&call->to_clip, model_position(model, face, i));
            polygon.corner[i] = (struct clip_corner){clip, {i == 0, i == 1, i == 2}};
            all &= find_beyond(clip);
            any |= find_beyond(clip);
        }
        if (all != 0 || (any & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0) {
            continue;
        }
        for (int plane = 0; plane < CLIP_PLANES; plane++) {
            polygon = clip_at_plane(&polygon, plane);
        }
        for (size_t i = 0; i < polygon.count; i++) {
            corner[i] = add_corner(model, face, polygon.corner[i].weight);
            if (i >= 2) {
                ADD(model, face, (struct face){{corner[0], corner[i - 1], corner[i]}});
            }
        }
    }
}

enum look { LOOK_PHONG, LOOK_TOON, LOOK_GOURAUD, LOOK_FLAT, LOOK_DEPTH, LOOK_LINES, LOOKS };

static const char *const looks[LOOKS] = {"phong", "toon", "gouraud", "flat", "depth", "wireframe"};

/* The uniforms of the shader below, with those of lesson 10 in them. */
struct frame {
    enum look look;
    const struct shader *phong;
    struct uniforms uniforms;
};

static void look_vertex(const void *frame, size_t face, size_t corner, double *varyings) {
    const struct frame *f = frame;
    const struct uniforms *u = &f->uniforms;
    if (f->look == LOOK_PHONG) {
        f->phong->vertex(u, face, corner, varyings);
    } else if (f->look == LOOK_FLAT) {
        varyings[0] = face_intensity(u->model, face, u->to_light);
    } else {
        const struct vec3 normal = vec3_normalized(model_normal(u->model, face, corner));
        varyings[0] = corner_intensity(normal, u->to_light);
    }
}

static bool look_pixel(const void *frame, const double *varyings, struct vec3 *rgb) {
    const struct frame *f = frame;
    lanes_texel texel = 0;
    if (f->look == LOOK_TOON) {
        return toon_pixel(&f->uniforms, varyings, rgb);
    }
    if (f->look != LOOK_PHONG) {
        *rgb = vec3_scale((struct vec3){255, 255, 255}, varyings[0]);
        return true;
    }
    lanes numbers[VARYING_LIMIT];
    for (size_t i = 0; i < f->phong->varying_count; i++) {
        numbers[i] = (real)varyings[i];
    }
    const bool drawn = f->phong->fragment(&f->uniforms, numbers, &texel);
    *rgb = (struct vec3){texel >> 16 & 255, texel >> 8 & 255, texel & 255};
    return drawn;
}

static struct pixel to_pixel(struct vec4 clip, double half) {
    return (struct pixel){(int)floor((clip.x / clip.w + 1) * half),
                          (int)floor((clip.y / clip.w + 1) * half)};
}

/* Draw the edges: a whole line as in lesson 1, one that leaves the picture as in lesson 2. */
static void draw_lines(struct image *image, const struct draw_call *call) {
    const struct model *model = call->model;
    const struct color white = color_rgb(255, 255, 255);
    const double half = (double)image->width / 2;
    struct side *sides = memory(NULL, 3 * model->face_count, sizeof *sides);
    list_sides(model, sides);
    const size_t count = keep_one_of_each(sides, 3 * model->face_count);
    for (size_t i = 0; i < count; i++) {
        const struct vec4 a = mat4_point(&call->to_clip, model->positions[sides[i].low]);
        const struct vec4 b = mat4_point(&call->to_clip, model->positions[sides[i].high]);
        const unsigned beyond = find_beyond(a) | find_beyond(b);
        if (beyond == 0) {
            line(image, to_pixel(a, half), to_pixel(b, half), white);
        } else if ((beyond & (BEYOND_NEAR | BEYOND_GUARD_BAND)) == 0) {
            line_inside(image, to_pixel(a, half), to_pixel(b, half), white);
        }
    }
    free(sides);
}

/* Draw the faces. Those that had to be clipped have their parts in the model. */
static void draw_faces(struct image *image, const struct draw_call *call,
                       const struct frame *frame) {
    const size_t pixels = image->width * image->height;
    const bool is_phong = frame->look == LOOK_PHONG, is_depth = frame->look == LOOK_DEPTH;
    const struct simple_shader shader = {is_phong ? frame->phong->varying_count : 1, look_vertex,
                                         look_pixel};
    const struct canvas canvas = {.image = image};
    const struct band band = {.rows = {0, is_depth ? (int)image->height : 32},
                              .width = image->width,
                              .depth = memory(NULL, pixels, sizeof *band.depth),
                              .nearest = memory(NULL, pixels, sizeof *band.nearest)};
    struct kept_face *kept = memory(NULL, call->model->face_count, sizeof *kept);
    const size_t count = keep_faces(&canvas, call, kept);
    visible_draw(&canvas, band, kept, (uint32_t)count, &shader, frame);
    if (is_depth) {
        show_depths(image, band.depth);
    }
    free(kept);
    free(band.depth);
    free(band.nearest);
}

/* A square picture of the model, seen from the eye. */
static struct draw_call camera_call(const struct model *model, struct vec3 eye, int size) {
    const struct mat4 view = mat4_lookat(eye, (struct vec3){0}, (struct vec3){0, 1, 0});
    struct mat4 zoom = mat4_identity();
    zoom.m[0][0] = zoom.m[1][1] = 0.85;
    zoom = mat4_mul(zoom, mat4_mul(mat4_projection(sqrt(vec3_dot(eye, eye))), view));
    return (struct draw_call){model, zoom, {0, 0, size, size}, CULL_BACK};
}

struct options {
    struct vec3 eye;
    size_t size;
    int frames;
    enum look look;
};

static bool read_options(struct options *o, int argc, char **argv) {
    bool good = argc >= 2 && argc % 2 == 0;
    for (int i = 2; i < argc && good; i += 2) {
        char option[100];
        snprintf(option, sizeof option, "%s %s", argv[i], argv[i + 1]);
        good = sscanf(option, "--eye %lf,%lf,%lf", &o->eye.x, &o->eye.y, &o->eye.z) == 3 ||
               sscanf(option, "--size %zu", &o->size) == 1 ||
               sscanf(option, "--frames %d", &o->frames) == 1;
        for (int look = 0; look < LOOKS && strcmp(argv[i], "--look") == 0; look++) {
            if (strcmp(argv[i + 1], looks[look]) == 0) {
                o->look = (enum look)look;
                good = true;
            }
        }
    }
    return good && o->size >= 1 && o->size <= DRAW_LIMIT && vec3_dot(o->eye, o->eye) > 0;
}

int main(int argc, char **argv) {
    static const char *const endings[3] = {"_diffuse.tga", "_nm.tga", "_spec.tga"};
    struct options o = {.eye = {1, 0.5, 3}, .size = 800, .frames = 36};
    struct model model;
    struct texture map[3];
    if (!read_options(&o, argc, argv)) {
        fprintf(stderr, "renderer model.obj [--look phong|toon|gouraud|flat|depth|wireframe]\n"
                        "                   [--eye 1,0.5,3] [--size 800] [--frames 36]\n");
        return 2;
    }
    model_read(&model, argv[1]);
    for (int i = 0; i < 3; i++) {
        texture_read(&map[i], argv[1], endings[i], 0.85 * (double)o.size);
    }
    struct frame frame = {.look = o.look,
                          .phong = map[1].level_count > 0 ? &weight_mapped : &textured,
                          .uniforms = {.model = &model,
                                       .diffuse = &map[0],
                                       .normal_map = &map[1],
                                       .specular = &map[2],
                                       .eye = o.eye,
                                       .material = {0.1, 1, 1, 10, {255, 255, 255}}}};
    const enum image_format format = o.look == LOOK_DEPTH ? IMAGE_GREY : IMAGE_BGR;
    struct image image = {o.size, o.size, format, memory(NULL, o.size * o.size, format)};
    const struct draw_call call = camera_call(&model, o.eye, (int)o.size);
    if (o.look != LOOK_LINES) {
        add_clipped(&model, &call);
    }
    for (int drawn = 0; drawn < o.frames; drawn++) {
        char path[64];
        const clock_t begin = clock();
        memset(image.pixels, 0, o.size * o.size * format);
        frame.uniforms.to_light = turning_light((double)drawn / o.frames);
        if (o.look == LOOK_LINES) {
            draw_lines(&image, &call);
        } else {
            draw_faces(&image, &call, &frame);
        }
        snprintf(path, sizeof path, "turn_%03d.tga", drawn);
        printf("%s %.1f ms\n", path, 1000.0 * (double)(clock() - begin) / CLOCKS_PER_SEC);
        tga_write(&image, path);
    }
    for (int i = 0; i < 3; i++) {
        free(map[i].level->texels);
    }
    free(model.positions);
    free(model.uvs);
    free(model.normals);
    free(model.faces);
    free(image.pixels);
    return 0;
}
