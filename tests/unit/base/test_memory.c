/*
 * When memory runs out: every allocation of every reader, writer, of the pipeline and of a whole
 * program fails in turn, the first, the second and so on, one in each run. Each time the function
 * must return an error with a message, leave its results empty or as they were, and lose no memory.
 *
 * This program is linked with -Wl,--wrap=malloc and the like, so that the calls of the course's
 * code come to the functions __wrap_... below (GNU ld manual, option --wrap).
 */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "base/array.h"
#include "base/bytes.h"
#include "base/error.h"
#include "base/file.h"
#include "files/image_file.h"
#include "files/model_file.h"
#include "files/normals.h"
#include "files/png.h"
#include "files/ppm.h"
#include "model.h"
#include "program.h"
#include "run/parts.h"
#include "run/text_scene.h"
#include "tgaimage.h"
#include "unit/frames.h"
#include "unit/images.h"
#include "unit/place.h"
#include "unit/streams.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- Allocations that fail ---- */

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *block, size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void __real_free(void *block);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *block, size_t size);
void *__wrap_aligned_alloc(size_t alignment, size_t size);
void __wrap_free(void *block);

enum { NEVER = -1 };

static struct {
    bool on;
    long calls;   /* allocations asked for */
    long failing; /* the call that fails, from 0, or NEVER */
    bool failed;
    long live; /* blocks that are not yet freed */
} memory = {.failing = NEVER};

/* Does this allocation fail? */
static bool fails(void) {
    if (!memory.on || memory.calls++ != memory.failing) {
        return false;
    }
    memory.failed = true;
    errno = ENOMEM;
    return true;
}

static void *counted(void *block) {
    memory.live += memory.on && block != NULL;
    return block;
}

void *__wrap_malloc(size_t size) {
    return fails() ? NULL : counted(__real_malloc(size));
}

void *__wrap_calloc(size_t count, size_t size) {
    return fails() ? NULL : counted(__real_calloc(count, size));
}

void *__wrap_realloc(void *block, size_t size) {
    if (fails()) {
        return NULL;
    }
    return block == NULL ? counted(__real_realloc(NULL, size)) : __real_realloc(block, size);
}

void *__wrap_aligned_alloc(size_t alignment, size_t size) {
    return fails() ? NULL : counted(__real_aligned_alloc(alignment, size));
}

void __wrap_free(void *block) {
    memory.live -= memory.on && block != NULL;
    __real_free(block);
}

/* ---- What is tried ---- */

/* Made once, with memory to spare. */
static struct {
    struct image grey, color, clear;                        /* 8, 24 and 32 bits */
    struct bytes long_scene, long_obj, one_color, long_off; /* so long that arrays grow twice */
    struct bytes two_ways;                                  /* OFF that may have edges or not */
    struct model cube, many;                                /* without normals; see make_models() */
} inputs;

static struct place place; /* of the files */

/* A whole task: makes, uses and frees everything. True when all of it was done. */
struct task {
    const char *name;
    bool (*run)(struct error *error);
    long spared; /* so many of its first allocations it can do without */
};

static bool is_message(const char *message) {
    return strstr(message, "emory") != NULL && strchr(message, '\n') == NULL;
}

/* Fail each allocation of a task in turn. Returns how many there are. */
static long fail_each(const struct task *task) {
    for (long n = 0;; n++) {
        struct error error = {0};
        memory.calls = memory.live = 0;
        memory.failing = n;
        memory.failed = false;
        memory.on = true;
        bool done = task->run(&error);
        memory.on = false;
        CHECK_ROW(memory.live == 0, task->name);
        if (!memory.failed) {
            CHECK_ROW(done, task->name);
            return n;
        }
        if (!CHECK_ROW(done == (n < task->spared), task->name) ||
            !CHECK_ROW(done || is_message(error.message), task->name)) {
            fprintf(stderr, "    at allocation %ld\n", n);
        }
    }
}

/* ---- The inputs ---- */

static struct image make_image(size_t width, size_t height, enum image_format format) {
    struct image image = new_image(width, height, format);
    for (size_t i = 0; i < width * height * (size_t)format; i++) {
        image.pixels[i] = (uint8_t)(i * i * 7 + i / 5);
    }
    return image;
}

static const char cube_obj[] = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
                               "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                               "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

/* Append `count` copies of a line. */
static bool repeat_line(struct bytes *text, const char *line, size_t count) {
    bool done = true;
    for (size_t i = 0; i < count; i++) {
        done = done && bytes_append(text, line, strlen(line));
    }
    return done;
}

static bool make_texts(void) {
    struct bytes *obj = &inputs.long_obj, *first = &inputs.one_color, *off = &inputs.long_off;
    return repeat_line(&inputs.long_scene, "line 0 0 4 4 1 2 3\n", 100) &&
           /* Positions with colours from the second on, faces, polygons, of which one has a corner
            * that turns inwards. */
           repeat_line(obj, "v 0 0 0\nvt 0 0\nvn 0 0 1\n", 1) &&
           repeat_line(obj, "v 0 0 0 1 1 1\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/2/1 -1//-1\n", 100) &&
           repeat_line(obj, "v 4 0 0\nv 4 4 0\nv 1 1 0\nv 0 4 0\nv 0 0 0\n", 20) &&
           repeat_line(obj, "mtllib a\nusemtl a\nf -5 -4 -3 -2\n", 1) && repeat_line(obj, "f", 1) &&
           repeat_line(obj, " -5 -4 -3 -2", 70) &&
           /* Colours only at the first position: the others are added when all are known. */
           repeat_line(first, "v 0 0 0 1 1 1\n", 1) && repeat_line(first, "v 1 2 3\n", 100) &&
           repeat_line(first, "f 1 2 3\n", 1) &&
           /* Faces without a colour before and after those with one. */
           repeat_line(off, "STCNOFF 100 110\n", 1) &&
           repeat_line(off, "0 0 0  0 0 1  1 1 1  0 0\n", 100) &&
           repeat_line(off, "4 0 1 2 3\n", 70) && repeat_line(off, "4 0 1 2 3 255 0 0\n", 20) &&
           repeat_line(off, "4 0 1 2 3\n", 20) &&
           repeat_line(&inputs.two_ways, "OFF\n4 1\n3\n0 0 0\n1 0 0\n1 1 0\n0 1 3\n3 0 1 2\n", 1);
}

/* A cube; and one face that is cut into several pieces, with more whole ones than there is room
 * left for. */
static bool make_models(void) {
    struct bytes text = {0};
    struct error error;
    bool made = model_decode(&inputs.cube, cube_obj, strlen(cube_obj), &error) &&
                repeat_line(&text, "v -90 -90 0\nv 90 -90 0\nv 0 90 0\nv 0 0.5 0\nv 0 0 0\n", 1) &&
                repeat_line(&text, "v 0.5 0 0\nf 1 2 3\n", 1) &&
                repeat_line(&text, "f 4 5 6\n", 20) &&
                model_decode(&inputs.many, text.data, text.size, &error);
    bytes_free(&text);
    return made;
}

static bool make_inputs(void) {
    static const char materials_obj[] =
        "mtllib x m.mtl\nusemtl m\nv 0 0 0\nvt 0 0\nf 1/1 1/1 1/1\n";
    static const uint_least16_t wide[] =
        u"\uFEFFOFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"; /* UTF-16 */
    struct error error;
    inputs.grey = make_image(31, 9, IMAGE_GREY);
    inputs.color = make_image(20, 10, IMAGE_BGR);
    inputs.clear = make_image(9, 20, IMAGE_BGRA);
    place = place_create();
    return make_texts() && make_models() &&
           file_write(name_file(&place, "scene.txt"), inputs.long_scene.data,
                      inputs.long_scene.size, &error) &&
           put_text(name_file(&place, "cube.obj"), cube_obj) &&
           put_text(name_file(&place, "m.obj"), materials_obj) &&
           put_text(name_file(&place, "m.mtl"), "newmtl m\nmap_Kd maps/m.obj\nbump x/m.mtl\n") &&
           file_write(name_file(&place, "cube.off"), wide, sizeof wide - sizeof wide[0], &error) &&
           tga_write(&inputs.color, name_file(&place, "cube_diffuse.tga"), &error) &&
           png_write(&inputs.color, name_file(&place, "cube_nm.png"), &error);
}

/* No files were left behind that nobody asked for. */
static void free_inputs(void) {
    image_free(&inputs.grey);
    image_free(&inputs.color);
    image_free(&inputs.clear);
    bytes_free(&inputs.long_scene);
    bytes_free(&inputs.long_obj);
    bytes_free(&inputs.one_color);
    bytes_free(&inputs.long_off);
    bytes_free(&inputs.two_ways);
    model_free(&inputs.cube);
    model_free(&inputs.many);
    place_remove(&place, "scene.txt,cube.obj,cube.off,cube_diffuse.tga,cube_nm.png,m.obj,m.mtl");
}

/* ---- Files ---- */

static bool read_pipe(struct error *error) {
    struct bytes bytes;
    int ends[2] = {-1, -1};
    CHECK(pipe(ends) == 0 && write(ends[1], "some text", 9) == 9);
    close(ends[1]);
    struct streams streams = streams_lead(ends[0], -1, -1);
    bool done = file_read("-", &bytes, error);
    streams_restore(&streams);
    close(ends[0]);
    CHECK(done ? bytes.size == 9 : bytes.data == NULL);
    bytes_free(&bytes);
    return done;
}

/* ---- Images ---- */

/* Encoders append: what was there stays, also after an error. */
static bool kept_start(const struct bytes *out) {
    return out->size >= 3 && memcmp(out->data, "abc", 3) == 0;
}

static bool encode_all(struct error *error) {
    const struct image *const images[] = {&inputs.grey, &inputs.color, &inputs.clear};
    struct bytes out = {0};
    bool done = bytes_append(&out, "abc", 3) || error_out_of_memory(error);
    for (size_t i = 0; i < 3 && done; i++) {
        for (int way = 0; way < 4 && done; way++) {
            size_t before = out.size;
            done = way == 0   ? tga_encode(images[i], &out, error)
                   : way == 1 ? png_encode(images[i], &out, error)
                   : way == 2 ? ppm_encode(images[i], &out, error)
                              : apng_encode(images[i], 1, 40, &out, error);
            CHECK(done ? out.size > before : out.size == before);
            CHECK(kept_start(&out));
        }
    }
    bytes_free(&out);
    return done;
}

/* More than one block, so that memory can run out between two. Words that nearly repeat make the
 * compressor look ahead. */
static bool encode_large(struct error *error) {
    struct image image = {0};
    struct bytes out = {0};
    uint32_t state = 3;
    bool done = image_create(&image, 300, 299, IMAGE_GREY, error);
    CHECK(done || strstr(error->message, "300x299 pixels") != NULL);
    for (size_t i = 0; done && i < 300 * (size_t)299; i++) {
        state = state * 1664525u + 1013904223u;
        size_t back = 1 + (state >> 8) % 900;
        image.pixels[i] = i > 1000 && state >> 29 != 0 ? image.pixels[i - back / 300 * 300 - 7]
                                                       : (uint8_t)(state >> 12);
    }
    done = done && png_encode(&image, &out, error);
    CHECK(done || out.size == 0);
    image_free(&image);
    bytes_free(&out);
    return done;
}

/* ---- Models ---- */

static bool decode_model(const struct bytes *text, struct error *error) {
    struct model model;
    bool done = model_decode(&model, text->data, text->size, error);
    CHECK(done || (model.positions == NULL && model.faces == NULL && model.face_count == 0));
    model_free(&model);
    return done;
}

static bool decode_models(struct error *error) {
    return decode_model(&inputs.long_obj, error) && decode_model(&inputs.one_color, error) &&
           decode_model(&inputs.long_off, error) && decode_model(&inputs.two_ways, error);
}

static bool give_normals_and_colors(struct error *error) {
    struct model model;
    bool done = model_read(&model, name_file(&place, "cube.off"), error);
    if (done) {
        done = model_need_normals(&model, error) && model_need_colors(&model, error);
        CHECK(model.face_count == 1); /* still a valid model */
    }
    model_free(&model);
    return done;
}

static bool create_texture(struct error *error) {
    struct texture texture;
    bool done = texture_create(&texture, &inputs.color, error);
    CHECK((texture.level_count > 0) == done);
    texture_free(&texture);
    return done;
}

/* The files of the maps are next to the model, and not where its materials say. */
static bool read_materials(struct error *error) {
    struct model model;
    bool done = model_read(&model, name_file(&place, "m.obj"), error);
    CHECK(done ? model.materials[0].bumps != NULL : model.materials == NULL);
    model_free(&model);
    return done;
}

/* The diffuse texture is a TGA, the normal map a PNG. */
static bool read_textures(struct error *error) {
    struct model model;
    bool done = model_read(&model, name_file(&place, "cube.obj"), error) &&
                model_texture(&model, MODEL_DIFFUSE, error) != NULL &&
                model_texture(&model, MODEL_NORMAL_MAP, error) != NULL;
    model_free(&model);
    return done;
}

/* ---- The pipeline ---- */

static void no_vertex(const void *uniforms, size_t face, size_t corner, double *varyings) {
    (void)uniforms, (void)face;
    varyings[0] = (double)corner;
}

static lanes_mask white(const void *uniforms, const lanes *varyings, lanes_texel *color) {
    (void)uniforms, (void)varyings;
    *color = lanes_rgb(lanes_all(255), lanes_all(255), lanes_all(255));
    return lanes_all_set();
}

enum { IMAGE_SIDE = 40 }; /* several bands of rows */

static bool start(struct target *target, struct error *error) {
    *target = (struct target){.image = {0}};
    return pipeline_create(&target->pipeline, IMAGE_SIDE, IMAGE_SIDE, error) &&
           image_create(&target->image, IMAGE_SIDE, IMAGE_SIDE, IMAGE_BGR, error);
}

/* Record a model, seen from `eye`. */
static bool record(struct target *target, const struct model *model, struct vec3 eye, double zoom,
                   struct error *error) {
    static const struct shader shader = {
        .varying_count = 1, .vertex = no_vertex, .fragment = white};
    struct draw_call call =
        camera_call(model, eye, (struct vec3){0, 0, 0}, (struct vec3){0, 1, 0}, zoom,
                    (struct rectangle){0, 0, IMAGE_SIDE, IMAGE_SIDE}, CULL_NONE);
    return pipeline_draw(&target->pipeline, &call, &shader, &zoom, sizeof zoom, error);
}

/* An image that cannot be finished stays as it was: black. */
static bool finish(struct target *target, struct error *error) {
    bool done = pipeline_finish(&target->pipeline, &target->image, error);
    CHECK(image_get(&target->image, IMAGE_SIDE / 2, IMAGE_SIDE / 2).r == (done ? 255 : 0));
    return done;
}

static const struct vec3 far_eye = {1, 2, 8}, near_eye = {0.1, 0.2, 0.9};

/* Draw the cube whole, then from near by: there it is clipped. */
static bool draw_cube(bool skip, struct error *error) {
    struct target target;
    bool done = start(&target, error);
    target.pipeline.skip = skip;
    target.pipeline.keep_depth = true;
    done = done && record(&target, &inputs.cube, far_eye, 0.5, error) &&
           record(&target, &inputs.cube, near_eye, 0.5, error) && finish(&target, error);
    CHECK(!done || target.pipeline.stats[STAT_FACES_CLIPPED] > 0);
    target_free(&target);
    return done;
}

static bool draw_both_ways(struct error *error) {
    return draw_cube(true, error) && draw_cube(false, error);
}

/* Drawing a picture a second time allocates nothing. */
static void check_other_frames(void) {
    struct target target;
    struct error error;
    bool done = CHECK(start(&target, &error));
    for (int frame = 0; frame < 100 && done; frame++) {
        memory.calls = 0;
        memory.failing = NEVER;
        memory.on = true;
        pipeline_clear(&target.pipeline);
        done = record(&target, &inputs.cube, far_eye, 0.5, &error) &&
               record(&target, &inputs.cube, near_eye, 0.5, &error) && finish(&target, &error);
        memory.on = false;
        CHECK(done && (frame < 2 || memory.calls == 0));
    }
    target_free(&target);
}

static bool draw_many(struct error *error) {
    struct target target;
    bool done = start(&target, error) &&
                record(&target, &inputs.many, (struct vec3){0, 0, 1}, 1, error) &&
                finish(&target, error);
    CHECK(!done || target.pipeline.stats[STAT_FACES_CLIPPED] == 1);
    target_free(&target);
    return done;
}

/* A draw call that failed is left out, and the frame can be finished without it. */
static bool draw_after_a_failure(struct error *error) {
    struct target target;
    bool done = start(&target, error);
    bool first = done && record(&target, &inputs.cube, near_eye, 0.5, error);
    bool second = done && record(&target, &inputs.cube, near_eye, 0.5, error);
    bool finished = done && (first || second) && finish(&target, error);
    target_free(&target);
    return first && second && finished;
}

/* A frame of several rounds that fails when some of them are covered; and after it an empty one,
 * where nothing of the first may be left. */
static bool draw_nothing_after_a_failure(struct error *error) {
    struct target target;
    bool done = start(&target, error), drawn = done;
    target.pipeline.keep_depth = true;
    for (int i = 0; i < 20 && drawn; i++) { /* from ever nearer: all but the last are hidden */
        drawn = record(&target, &inputs.cube, (struct vec3){1, 2, 30 - i}, 1 + i, error);
    }
    bool finished = drawn && finish(&target, error);
    if (done && !finished) { /* only one allocation fails */
        struct error other;
        pipeline_clear(&target.pipeline);
        CHECK(pipeline_finish(&target.pipeline, &target.image, &other));
        for (size_t i = 0; i < (size_t)IMAGE_SIDE * IMAGE_SIDE; i++) {
            CHECK(target.pipeline.depth[i] == (double)-INFINITY);
        }
    }
    target_free(&target);
    return finished;
}

static bool make_parts(struct error *error) {
    static const char text[] =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1 2 3\nusemtl a\nf 1/1 2/1 3/1\n";
    struct error missing = {0};
    struct parts parts = {0};
    struct model model;
    bool done = model_decode(&model, text, sizeof text - 1, error);
    if (done) {
        model.materials[0].scale[0] = 2;
        done = parts_move_coordinates(&model, error) && parts_make(&parts, &model, &missing, error);
    }
    parts_free(&parts);
    model_free(&model);
    return done;
}

/* ---- A whole program ---- */

static bool draw_dot(struct drawing *drawing, struct image *image, struct error *error) {
    (void)error;
    image_set(image, 1, (int)drawing->frame, color_rgb(1, 2, 3));
    if (drawing->depth != NULL) {
        drawing->depth[0] = 0; /* or nothing was drawn */
    }
    drawing_count(drawing, "dots", 1);
    return true;
}

static const struct scene scenes[] = {
    {.name = "dot",
     .width = 4,
     .height = 3,
     .needs = NEEDS_NORMALS | NEEDS_COLORS | NEEDS_DEPTH,
     .draw = draw_dot},
    {.name = "film", .width = 5, .height = 4, .frames = 3, .draw = draw_dot},
};

static const struct program model_program = {
    .name = "probe", .summary = "draws dots", .scenes = scenes, .scene_count = 2, .state_size = 8};

static const struct program text_program = {.name = "probe",
                                            .summary = "draws text",
                                            .draw_text = draw_dot,
                                            .defaults = {.width = 5, .height = 5},
                                            .scenes = scenes,
                                            .scene_count = 2};

/* Run in its own directory, standard output thrown away and standard error kept. Status 1 is
 * an error of which the message was printed; images that were saved before it are complete, and
 * nothing else is there. */
static bool run_program(const struct program *program, char *arguments[5], struct error *error) {
    static const char *const names[] = {"dot.tga", "film.tga", "dot.ppm", "film.ppm", "scene.ppm"};
    char *argv[8] = {(char *)"probe", (char *)"-o"};
    struct place images = place_create();
    memcpy(argv + 3, arguments, 5 * sizeof *arguments);
    argv[2] = images.directory;
    int nowhere = open("/dev/null", O_WRONLY),
        log = open(name_file(&images, "log"), O_CREAT | O_RDWR, 0600);
    struct streams streams = streams_lead(-1, nowhere, log);
    int status = program_main(program, 8, argv);
    streams_restore(&streams);
    ssize_t size = pread(log, error->message, sizeof error->message - 1, 0);
    close(nowhere);
    close(log);
    if (CHECK(size >= 0)) {
        error->message[strcspn(error->message, "\n")] = '\0';
        CHECK(size == 0 || (size_t)size == strlen(error->message) + 1); /* one line */
    }
    size_t saved = 0;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        saved += unlink(name_file(&images, names[i])) == 0;
    }
    place_remove(&images, "log"); /* nothing else was in it */
    CHECK(status == 0 || status == 1);
    CHECK((status == 0) == (size == 0));
    CHECK(status != 0 || saved > 0);
    return status == 0;
}

static bool run_repeated(struct error *error) {
    char *arguments[] = {(char *)"--repeat", (char *)"3", (char *)"--fit", (char *)"--two-sided",
                         (char *)name_file(&place, "cube.obj")};
    return run_program(&model_program, arguments, error);
}

static bool run_text(struct error *error) {
    char *arguments[] = {(char *)"--format", (char *)"ppm", (char *)"--stats", (char *)"--",
                         (char *)name_file(&place, "scene.txt")};
    return run_program(&text_program, arguments, error);
}

#ifdef __GLIBC__
enum { SPARED = 1 }; /* that of keep_freed_memory() */
#else
enum { SPARED = 0 };
#endif

static void test_each_allocation(void) {
    static const struct task tasks[] = {
        {"file_read of a pipe", read_pipe, 0},
        {"tga_encode, ppm_encode, png_encode", encode_all, 0},
        {"png_encode of a large image", encode_large, 0},
        {"model_decode", decode_models, 0},
        {"model_need_normals", give_normals_and_colors, 0},
        {"texture_create", create_texture, 0},
        {"model_read with materials", read_materials, 0},
        {"model_texture", read_textures, 0},
        {"pipeline_draw of many faces", draw_many, 0},
        {"pipeline_draw", draw_both_ways, 0},
        {"pipeline_draw of a model after one that failed", draw_after_a_failure, 0},
        {"a frame after one that failed", draw_nothing_after_a_failure, 0},
        {"parts_make", make_parts, 0},
        {"a program with --repeat", run_repeated, SPARED},
        {"a program with a text scene", run_text, SPARED},
    };
    setenv("THREADS", "1", 1); /* a thread that is there takes memory, but at no certain time */
    CHECK(make_inputs());
    for (size_t i = 0; i < sizeof tasks / sizeof tasks[0]; i++) {
        CHECK_ROW(fail_each(&tasks[i]) > 0, tasks[i].name); /* or nothing is wrapped */
    }
    check_other_frames();
    free_inputs();
    unsetenv("THREADS");
}

/* More elements than a size can count the bytes of; the array stays as it was. */
static void test_too_many_elements(void) {
    size_t capacity = 0;
    char *array = NULL;
    CHECK(!array_extend(&array, &capacity, SIZE_MAX / 16 + 2, 16) && capacity == 0);
    CHECK(!array_extend(&array, &capacity, SIZE_MAX / 8 + 2, 8) && array == NULL);
}

UNIT_MAIN(TEST(test_too_many_elements), TEST(test_each_allocation))
