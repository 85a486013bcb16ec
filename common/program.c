/* What the main() of every step shares: see program.h. */
#define _POSIX_C_SOURCE 200809L /* clock_gettime, mkdir */
#include "program.h"

#include "png.h"
#include "text.h"

#include <assert.h>
#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

/* The Makefile tells where it builds, so that a step runs from any working directory. */
#ifndef COURSE_BUILD
#define COURSE_BUILD "build"
#endif
#define DEFAULT_MODEL COURSE_BUILD "/models/bust.obj"

enum { STATUS_DONE = 0, STATUS_FAILED = 1, STATUS_USAGE = 2 };
enum { REPEAT_LIMIT = 1000000 };
enum { FRAME_DELAY_MS = 40 }; /* of an animation: 25 frames a second */

enum file_format { FORMAT_TGA, FORMAT_PNG, FORMAT_PPM };

struct vec3_option {
    bool given;
    struct vec3 value;
};

struct options {
    const char *input;     /* model or text scene; NULL when none was named */
    const char *directory; /* -o; NULL for the default */
    const char *only;      /* --only; NULL for all scenes */
    size_t width, height;  /* -s; 0 for the scene's own */
    enum file_format format;
    struct vec3_option eye, center, up, light;
    size_t repeat; /* 0 without --repeat */
    bool stats, skip, help;
};

/* ---- Options ---- */

static void print_scene_names(FILE *stream, const struct program *program) {
    for (size_t i = 0; i < program->scene_count; i++) {
        fprintf(stream, " %s", program->scenes[i].name);
    }
    fprintf(stream, "\n");
}

static const char *input_name(const struct program *program) {
    if (program->text_scene.draw != NULL) {
        return " [scene.txt]";
    }
    return program->takes_model ? " [model.obj | model.off]" : "";
}

static void print_help(const struct program *program) {
    printf("%s: %s\n\n", program->name, program->summary);
    printf("usage: %s [options]%s\n\n", program->name, input_name(program));
    printf("  -o DIR          where the images go (default " COURSE_BUILD "/out/%s)\n",
           program->name);
    printf("  -s WxH          image size, each 1 to %d\n", DRAW_LIMIT);
    printf("  --only SCENE    draw just this scene, one of:");
    print_scene_names(stdout, program);
    printf("  --format F      tga (default), png, ppm\n");
    if (program->takes_camera) {
        printf("  --eye X,Y,Z     where the camera stands\n");
        printf("  --center X,Y,Z  the point that it looks at\n");
        printf("  --up X,Y,Z      the direction that appears upwards\n");
    }
    if (program->takes_light) {
        printf("  --light X,Y,Z   where the light goes, comes from or stands: see the lesson\n");
    }
    printf("  --repeat N      draw N times; print the median milliseconds of one frame\n");
    printf("  --stats         print what was done and what was skipped\n");
    printf("  --no-skip       do everything; the image must not change\n");
    printf("  -h, --help      this text\n");
    if (program->text_scene.draw != NULL) {
        printf("\nA text scene draws what its lines say; '-' reads standard input.\n");
    } else if (program->takes_model) {
        printf("\nWithout a model: " DEFAULT_MODEL "\n");
    }
}

static bool parse_size(const char *text, size_t *width, size_t *height) {
    const char *cross = strchr(text, 'x');
    if (cross == NULL) {
        return false;
    }
    int64_t w, h;
    struct word first = {text, (size_t)(cross - text)}, second = {cross + 1, strlen(cross + 1)};
    if (!word_to_integer(first, &w) || !word_to_integer(second, &h) || w < 1 || h < 1 ||
        w > DRAW_LIMIT || h > DRAW_LIMIT) {
        return false;
    }
    *width = (size_t)w;
    *height = (size_t)h;
    return true;
}

/* Three finite numbers with commas between them. */
static bool parse_vec3(const char *text, struct vec3_option *option) {
    double value[3];
    for (int i = 0; i < 3; i++) {
        size_t length = strcspn(text, ",");
        if (!word_to_double((struct word){text, length}, &value[i]) || !isfinite(value[i]) ||
            (text[length] == ',') != (i < 2)) {
            return false;
        }
        text += length + (i < 2);
    }
    *option = (struct vec3_option){true, {value[0], value[1], value[2]}};
    return true;
}

static bool parse_format(const char *text, enum file_format *format) {
    static const char *const names[] = {"tga", "png", "ppm"};
    for (int i = 0; i < 3; i++) {
        if (strcmp(text, names[i]) == 0) {
            *format = (enum file_format)i;
            return true;
        }
    }
    return false;
}

static bool parse_repeat(const char *text, size_t *repeat) {
    int64_t value;
    if (!word_to_integer((struct word){text, strlen(text)}, &value) || value < 1 ||
        value > REPEAT_LIMIT) {
        return false;
    }
    *repeat = (size_t)value;
    return true;
}

static const struct scene *find_scene(const struct program *program, const char *name) {
    for (size_t i = 0; i < program->scene_count; i++) {
        if (strcmp(program->scenes[i].name, name) == 0) {
            return &program->scenes[i];
        }
    }
    return NULL;
}

/* Options without a value. False when `name` is none of them. */
static bool parse_switch(const char *name, struct options *options) {
    if (strcmp(name, "--stats") == 0) {
        options->stats = true;
    } else if (strcmp(name, "--no-skip") == 0) {
        options->skip = false;
    } else if (strcmp(name, "-h") == 0 || strcmp(name, "--help") == 0) {
        options->help = true;
    } else {
        return false;
    }
    return true;
}

/* Options with a value (NULL when the command line ends before it). */
static bool parse_value(const struct program *program, const char *name, const char *value,
                        struct options *options, struct error *error) {
    bool camera = program->takes_camera, light = program->takes_light;
    struct {
        const char *name, *wants;
        bool known;
    } known[] = {
        {"-o", "a directory", true},
        {"-s", "WxH, each 1 to 16384", true},
        {"--only", "the name of a scene (see --help)", true},
        {"--format", "tga, png or ppm", true},
        {"--eye", "three numbers X,Y,Z", camera},
        {"--center", "three numbers X,Y,Z", camera},
        {"--up", "three numbers X,Y,Z", camera},
        {"--light", "three numbers X,Y,Z", light},
        {"--repeat", "a number from 1 to 1000000", true},
    };
    size_t i = 0, count = sizeof known / sizeof known[0];
    while (i < count && (strcmp(known[i].name, name) != 0 || !known[i].known)) {
        i++;
    }
    if (i == count) {
        return error_set(error, "unknown option '%s'; try --help", name);
    }
    if (value == NULL) {
        return error_set(error, "%s wants %s", name, known[i].wants);
    }
    bool good = false;
    switch (i) {
    case 0:
        options->directory = value;
        good = value[0] != '\0';
        break;
    case 1:
        good = parse_size(value, &options->width, &options->height);
        break;
    case 2:
        options->only = value;
        good = find_scene(program, value) != NULL;
        break;
    case 3:
        good = parse_format(value, &options->format);
        break;
    case 4:
        good = parse_vec3(value, &options->eye);
        break;
    case 5:
        good = parse_vec3(value, &options->center);
        break;
    case 6:
        good = parse_vec3(value, &options->up);
        break;
    case 7:
        good = parse_vec3(value, &options->light);
        break;
    case 8:
        good = parse_repeat(value, &options->repeat);
        break;
    }
    return good || error_set(error, "%s wants %s, not '%s'", name, known[i].wants, value);
}

static bool parse_options(const struct program *program, int argc, char **argv,
                          struct options *options, struct error *error) {
    *options = (struct options){.skip = true};
    bool takes_input = program->takes_model || program->text_scene.draw != NULL;
    for (int i = 1; i < argc; i++) {
        if (argv[i][0] != '-' || strcmp(argv[i], "-") == 0) {
            if (!takes_input || options->input != NULL) {
                return error_set(error, "one argument too many: '%s'; try --help", argv[i]);
            }
            options->input = argv[i];
        } else if (!parse_switch(argv[i], options)) {
            const char *value = i + 1 < argc ? argv[i + 1] : NULL;
            if (!parse_value(program, argv[i], value, options, error)) {
                return false;
            }
            i++;
        }
    }
    if (options->only != NULL && program->text_scene.draw != NULL && options->input != NULL) {
        return error_set(error, "--only and a text scene do not go together");
    }
    return true;
}

/* ---- Counting and timing ---- */

void count(struct drawing *drawing, const char *name, uint64_t amount) {
    size_t i = 0;
    while (i < drawing->counter_count && strcmp(drawing->counters[i].name, name) != 0) {
        i++;
    }
    if (i == drawing->counter_count) {
        assert(i < COUNTER_LIMIT);
        drawing->counters[i] = (struct counter){.name = name};
        drawing->counter_count++;
    }
    drawing->counters[i].value += amount;
}

static void print_counters(const struct scene *scene, const struct drawing *drawing) {
    for (size_t i = 0; i < drawing->counter_count; i++) {
        printf("%s.%s: %llu\n", scene->name, drawing->counters[i].name,
               (unsigned long long)drawing->counters[i].value);
    }
}

static double now_ms(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

static int compare_doubles(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, size_t value_count) {
    qsort(values, value_count, sizeof *values, compare_doubles);
    size_t middle = value_count / 2;
    return value_count % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/* ---- Saving ---- */

/* What printf would print, in memory to be freed; NULL when memory runs out. */
static char *format_string(const char *format, ...) PRINTF_LIKE(1, 2);

static char *format_string(const char *format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    char *string = length >= 0 ? malloc((size_t)length + 1) : NULL;
    if (string != NULL) {
        vsnprintf(string, (size_t)length + 1, format, again);
    }
    va_end(again);
    va_end(arguments);
    return string;
}

/* Make the directory and those above it, as mkdir -p does. */
static bool make_directories(const char *path, struct error *error) {
    char *partial = format_string("%s", path);
    if (partial == NULL) {
        return error_set(error, "%s: out of memory", path);
    }
    for (size_t i = 1; i <= strlen(path); i++) {
        if (path[i] != '/' && path[i] != '\0') {
            continue;
        }
        partial[i] = '\0';
        struct stat status;
        if (mkdir(partial, 0777) != 0 &&
            (stat(partial, &status) != 0 || !S_ISDIR(status.st_mode))) {
            int reason = errno == EEXIST ? ENOTDIR : errno;
            error_set(error, "%s: cannot make the directory: %s", partial, strerror(reason));
            free(partial);
            return false;
        }
        partial[i] = path[i];
    }
    free(partial);
    return true;
}

/* Several frames become one animation (PNG) or one sheet with all frames (the others). */
static bool save_as(const char *path, enum file_format format, const struct image *sheet,
                    const struct image *frames, size_t frame_count, struct error *error) {
    switch (format) {
    case FORMAT_PNG:
        return frame_count > 1 ? apng_write(frames, frame_count, FRAME_DELAY_MS, path, error)
                               : png_write(sheet, path, error);
    case FORMAT_PPM:
        return ppm_write(sheet, path, error);
    default:
        return tga_write(sheet, path, error);
    }
}

static bool save(const struct program *program, const struct options *options, const char *name,
                 const struct image *sheet, const struct image *frames, size_t frame_count,
                 struct error *error) {
    static const char *const extensions[] = {"tga", "png", "ppm"};
    const char *extension = extensions[options->format];
    if (options->format == FORMAT_PPM && sheet->format == IMAGE_GREY) {
        extension = "pgm";
    }
    bool done = false;
    char *directory = options->directory != NULL
                          ? format_string("%s", options->directory)
                          : format_string(COURSE_BUILD "/out/%s", program->name);
    char *path = directory != NULL ? format_string("%s/%s.%s", directory, name, extension) : NULL;
    if (path == NULL) {
        error_set(error, "out of memory");
        goto end;
    }
    done = make_directories(directory, error) &&
           save_as(path, options->format, sheet, frames, frame_count, error);
    if (done && !options->stats && options->repeat == 0) {
        printf("%s\n", path);
    }
end:
    free(directory);
    free(path);
    return done;
}

/* ---- Drawing ---- */

/* Copy a frame into its place on the sheet, `columns` frames in a row, the first one top left. */
static void place_frame(struct image *sheet, const struct image *frame, size_t index,
                        size_t columns, size_t rows) {
    size_t left = index % columns * frame->width;
    size_t bottom = (rows - 1 - index / columns) * frame->height;
    size_t row_size = frame->width * frame->format;
    for (size_t y = 0; y < frame->height; y++) {
        memcpy(sheet->pixels + ((bottom + y) * sheet->width + left) * frame->format,
               frame->pixels + y * row_size, row_size);
    }
}

/* How many frames stand side by side, and how many rows of them there are. */
static void sheet_layout(size_t frame_count, size_t *columns, size_t *rows) {
    *columns = 1;
    while (*columns * *columns < frame_count) {
        (*columns)++;
    }
    *rows = (frame_count + *columns - 1) / *columns;
}

static bool make_sheet(struct image *sheet, size_t width, size_t height, const struct image *frames,
                       size_t frame_count, struct error *error) {
    size_t columns, rows;
    sheet_layout(frame_count, &columns, &rows);
    if (!image_create(sheet, width, height, frames[0].format, error)) {
        return false;
    }
    for (size_t i = 0; i < frame_count; i++) {
        place_frame(sheet, &frames[i], i, columns, rows);
    }
    return true;
}

/* Draw all frames once. */
static bool draw_frames(const struct scene *scene, struct drawing *drawing, struct image *frames,
                        size_t frame_count, struct error *error) {
    drawing->counter_count = 0;
    for (size_t i = 0; i < frame_count; i++) {
        image_clear(&frames[i], (struct color){0, 0, 0, 0});
        drawing->frame = i;
        if (!scene->draw(drawing, &frames[i], error)) {
            return false;
        }
    }
    return true;
}

/* Draw as often as --repeat says and print the median time of one frame. */
static bool draw_timed(const struct scene *scene, struct drawing *drawing, struct image *frames,
                       size_t frame_count, size_t repeat, struct error *error) {
    double *times = malloc(repeat * sizeof *times);
    if (times == NULL) {
        return error_set(error, "out of memory");
    }
    for (size_t i = 0; i < repeat; i++) {
        double begin = now_ms();
        if (!draw_frames(scene, drawing, frames, frame_count, error)) {
            free(times);
            return false;
        }
        times[i] = (now_ms() - begin) / (double)frame_count;
    }
    printf("%s: %.3f ms\n", scene->name, median(times, repeat));
    free(times);
    return true;
}

static struct vec3 chosen(const struct vec3_option *option, struct vec3 otherwise) {
    return option->given ? option->value : otherwise;
}

/* The image has the size that the scene or -s says. Each frame of an animation has it, too;
 * those of a sheet share it out. */
static bool frame_size(const struct scene *scene, const struct options *options, size_t *width,
                       size_t *height, struct error *error) {
    size_t columns = 1, rows = 1;
    if (scene->frames > 1 && options->format != FORMAT_PNG) {
        sheet_layout(scene->frames, &columns, &rows);
    }
    *width /= columns;
    *height /= rows;
    return (*width > 0 && *height > 0) ||
           error_set(error, "scene %s: %zu frames need at least %zux%zu pixels", scene->name,
                     scene->frames, columns, rows);
}

static bool draw_scene(const struct program *program, const struct scene *scene,
                       const struct options *options, struct drawing *drawing,
                       struct error *error) {
    size_t frame_count = scene->frames > 1 ? scene->frames : 1;
    const size_t sheet_width = options->width > 0 ? options->width : scene->width;
    const size_t sheet_height = options->width > 0 ? options->height : scene->height;
    size_t width = sheet_width, height = sheet_height;
    enum image_format format = scene->format != 0 ? scene->format : IMAGE_BGR;
    if (!frame_size(scene, options, &width, &height, error)) {
        return false;
    }
    struct image sheet = {0};
    bool done = false;
    struct image *frames = calloc(frame_count, sizeof *frames);
    drawing->state = calloc(1, program->state_size > 0 ? program->state_size : 1);
    if (frames == NULL || drawing->state == NULL) {
        error_set(error, "out of memory");
        goto end;
    }
    for (size_t i = 0; i < frame_count; i++) {
        if (!image_create(&frames[i], width, height, format, error)) {
            goto end;
        }
    }
    drawing->eye = chosen(&options->eye, scene->eye);
    drawing->center = chosen(&options->center, scene->center);
    drawing->up = chosen(&options->up, scene->up);
    drawing->light = chosen(&options->light, scene->light);
    done = program->prepare == NULL || program->prepare(drawing, width, height, error);
    if (done && options->repeat > 0) {
        done = draw_timed(scene, drawing, frames, frame_count, options->repeat, error);
    } else if (done) {
        done = draw_frames(scene, drawing, frames, frame_count, error);
    }
    if (program->finish != NULL) {
        program->finish(drawing);
    }
    done = done && (frame_count == 1 || options->format == FORMAT_PNG ||
                    make_sheet(&sheet, sheet_width, sheet_height, frames, frame_count, error));
    done = done && save(program, options, scene->name, sheet.pixels != NULL ? &sheet : &frames[0],
                        frames, frame_count, error);
    if (done && options->stats) {
        print_counters(scene, drawing);
    }
end:
    for (size_t i = 0; frames != NULL && i < frame_count; i++) {
        image_free(&frames[i]);
    }
    image_free(&sheet);
    free(frames);
    free(drawing->state);
    drawing->state = NULL;
    return done;
}

/* The name of a text scene's image: that of its file, without directory and extension. */
static char *text_scene_name(const char *path) {
    if (strcmp(path, "-") == 0) {
        path = "stdin";
    }
    const char *slash = strrchr(path, '/');
    const char *base = slash != NULL ? slash + 1 : path;
    const char *dot = strrchr(base, '.');
    size_t length = dot != NULL && dot != base ? (size_t)(dot - base) : strlen(base);
    return length <= INT_MAX ? format_string("%.*s", (int)length, base) : NULL;
}

static bool draw_text(const struct program *program, const struct options *options,
                      struct error *error) {
    struct text_scene text = {0};
    char *name = NULL;
    bool done = text_scene_read(&text, options->input, program->text_kind, error);
    if (done) {
        name = text_scene_name(options->input);
        struct scene scene = program->text_scene;
        scene.name = name;
        if (text.width > 0) {
            scene.width = text.width;
            scene.height = text.height;
        }
        struct drawing drawing = {.text = &text, .skip = options->skip};
        done = name != NULL ? draw_scene(program, &scene, options, &drawing, error)
                            : error_set(error, "out of memory");
    }
    free(name);
    text_scene_free(&text);
    return done;
}

static bool file_exists(const char *path) {
    struct stat status;
    return stat(path, &status) == 0;
}

static bool load_model(const struct options *options, struct model *model, struct error *error) {
    if (options->input == NULL && !file_exists(DEFAULT_MODEL)) {
        return error_set(error, DEFAULT_MODEL ": no such file; `make` sculpts it");
    }
    return model_read(model, options->input != NULL ? options->input : DEFAULT_MODEL, error);
}

/* A camera at the point that it looks at looks nowhere. */
static bool check_camera(const struct program *program, const struct options *options,
                         struct error *error) {
    for (size_t i = 0; program->takes_camera && i < program->scene_count; i++) {
        struct vec3 eye = chosen(&options->eye, program->scenes[i].eye);
        struct vec3 center = chosen(&options->center, program->scenes[i].center);
        bool same = eye.x == center.x && eye.y == center.y && eye.z == center.z;
        bool drawn = options->only == NULL || strcmp(options->only, program->scenes[i].name) == 0;
        if (same && drawn && (options->eye.given || options->center.given)) {
            return error_set(error, "scene %s: the eye and the center are the same point",
                             program->scenes[i].name);
        }
    }
    return true;
}

static bool draw_scenes(const struct program *program, const struct options *options,
                        struct error *error) {
    struct model model = {0};
    bool done = true;
    for (size_t i = 0; done && i < program->scene_count; i++) {
        const struct scene *scene = &program->scenes[i];
        if (options->only != NULL && strcmp(options->only, scene->name) != 0) {
            continue;
        }
        if (scene->needs_model && model.face_count == 0) {
            done = load_model(options, &model, error);
        }
        struct drawing drawing = {.model = scene->needs_model ? &model : NULL,
                                  .skip = options->skip};
        done = done && draw_scene(program, scene, options, &drawing, error);
    }
    model_free(&model);
    return done;
}

int program_main(const struct program *program, int argc, char **argv) {
    struct options options;
    struct error error = {0};
    if (!parse_options(program, argc, argv, &options, &error) ||
        !check_camera(program, &options, &error)) {
        fprintf(stderr, "%s: %s\n", program->name, error.message);
        return STATUS_USAGE;
    }
    bool text = options.input != NULL && program->text_scene.draw != NULL;
    bool done = true;
    if (options.help) {
        print_help(program);
    } else {
        done = text ? draw_text(program, &options, &error) : draw_scenes(program, &options, &error);
    }
    if (done && (fflush(stdout) != 0 || ferror(stdout))) {
        done = error_set(&error, "cannot write to standard output: %s", strerror(errno));
    }
    if (!done) {
        fprintf(stderr, "%s: %s\n", program->name, error.message);
        return STATUS_FAILED;
    }
    return STATUS_DONE;
}
