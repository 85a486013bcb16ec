/* What the main() of every step shares: see program.h. */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "program.h"

#include "base/file.h"
#include "base/large_pages.h"
#include "base/platform.h"
#include "files/fit.h"
#include "files/image_file.h"
#include "files/model_file.h"
#include "run/live.h"
#include "run/options.h"
#include "run/stage.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { STATUS_DONE = 0, STATUS_FAILED = 1, STATUS_USAGE = 2 };
enum { FRAME_DELAY_MS = 40 }; /* of an animation: 25 frames a second */

/* ---- Timing ---- */

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
    return (values[(value_count - 1) / 2] + values[value_count / 2]) / 2;
}

/* ---- Scenes ---- */

static bool is_chosen(const struct options *options, const struct scene *scene) {
    bool of_another = options->input_count > 0 && scene->detail;
    return options->only != NULL ? options->only == scene
           : options->all        ? !scene->extra
                                 : !scene->extra && !scene->trial && !of_another;
}

static bool same_point(struct vec3 a, struct vec3 b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* A camera at the point that it looks at looks nowhere; the square of their distance must not be so
 * small that bits of it are lost, nor too large for the float of a fragment. */
static bool check_camera(const struct scene *scene, struct error *error) {
    double distance = vec3_length(vec3_sub(scene->eye, scene->center));
    const char *fault = same_point(scene->eye, scene->center) ? "the same point"
                        : distance > 1                        ? "too far from each other"
                                                              : "too near to each other";
    return (distance >= 1e-140 && distance <= 1e18) ||
           error_set(error, "scene %s: the eye and the center are %s", scene->name, fault);
}

/* The frames of a scene, and how many of them lie side by side on a sheet. In a file that moves
 * each has the size of the scene; those of a sheet share it out. One picture is one frame. */
struct frames {
    struct image *frame;
    size_t count, columns, rows;
    size_t width, height; /* pixels of each */
};

static struct frames lay_out(const struct options *options, const struct scene *scene) {
    size_t count = options->format->write_frames != NULL ? 1 : scene->frames, columns = 1;
    while (columns * columns < count) {
        columns++;
    }
    size_t rows = (count + columns - 1) / columns;
    return (struct frames){
        .count = scene->frames,
        .columns = columns,
        .rows = rows,
        .width = scene->width / columns,
        .height = scene->height / rows,
    };
}

static bool check_size(const struct options *options, const struct scene *scene,
                       struct error *error) {
    const struct frames frames = lay_out(options, scene);
    return (frames.width > 0 && frames.height > 0) ||
           error_set(error, "scene %s: %zu frames need at least %zux%zu pixels", scene->name,
                     frames.count, frames.columns, frames.rows);
}

/* Do the options go together with the scenes? */
static bool check_options(const struct options *options, struct error *error) {
    const struct program *program = options->program;
    bool moved = options->eye.given || options->center.given;
    for (size_t i = 0; i < program->scene_count; i++) {
        const struct scene scene = scene_complete(options, &program->scenes[i]);
        bool right =
            !is_chosen(options, &program->scenes[i]) ||
            (check_size(options, &scene, error) && (!moved || check_camera(&scene, error)));
        if (!right) {
            return false;
        }
    }
    return true;
}

/* ---- Frames ---- */

static bool frames_create(struct frames *frames, const struct options *options,
                          const struct scene *scene, struct error *error) {
    *frames = lay_out(options, scene);
    frames->frame = calloc(frames->count, sizeof *frames->frame);
    if (frames->frame == NULL) {
        return error_out_of_memory(error);
    }
    for (size_t i = 0; i < frames->count; i++) {
        if (!image_create(&frames->frame[i], frames->width, frames->height, scene->format, error)) {
            return false;
        }
    }
    return true;
}

static void frames_free(struct frames *frames) {
    for (size_t i = 0; frames->frame != NULL && i < frames->count; i++) {
        image_free(&frames->frame[i]);
    }
    free(frames->frame);
    *frames = (struct frames){0};
}

/* Copy a frame into its place on the sheet, the first one top left. */
static void place_frame(struct image *image, const struct frames *frames, size_t index) {
    const struct image *frame = &frames->frame[index];
    size_t left = index % frames->columns * frame->width;
    size_t bottom = (frames->rows - 1 - index / frames->columns) * frame->height;
    size_t row_size = frame->width * frame->format;
    for (size_t y = 0; y < frame->height; y++) {
        memcpy(image->pixels + ((bottom + y) * image->width + left) * frame->format,
               frame->pixels + y * row_size, row_size);
    }
}

/* ---- Saving ---- */

static bool write_frames(const char *path, const struct options *options, const struct scene *scene,
                         const struct frames *frames, struct error *error) {
    const struct image_file_format *format = options->format;
    if (frames->count == 1) {
        return format->write(&frames->frame[0], path, error);
    }
    if (format->write_frames != NULL) {
        return format->write_frames(frames->frame, frames->count, FRAME_DELAY_MS, path, error);
    }
    struct image sheet;
    if (!image_create(&sheet, scene->width, scene->height, scene->format, error)) {
        return false;
    }
    for (size_t i = 0; i < frames->count; i++) {
        place_frame(&sheet, frames, i);
    }
    bool done = format->write(&sheet, path, error);
    image_free(&sheet);
    return done;
}

static bool save(const struct run *run, const struct scene *scene, const struct frames *frames,
                 struct error *error) {
    const struct options *options = &run->options;
    const char *extension = image_file_extension(options->format, &frames->frame[0]);
    char *directory = options->directory != NULL
                          ? string_format("%s", options->directory)
                          : string_format("%s/%s", OUTPUT_DIRECTORY, run->options.program->name);
    char *path =
        directory != NULL ? string_format("%s/%s.%s", directory, scene->name, extension) : NULL;
    bool done = path != NULL ? directory_create(directory, error) &&
                                   write_frames(path, options, scene, frames, error)
                             : error_out_of_memory(error);
    if (done && !options->stats && options->repeat == 0) {
        printf("%s\n", path);
    }
    free(directory);
    free(path);
    return done;
}

/* ---- Warnings: what a picture does not tell ---- */

static void say(const struct run *run, const struct error *error) {
    fprintf(stderr, "%s: %s\n", run->options.program->name, error->message);
}

/* Say once what was wrong with the file of a model that is drawn all the same. */
static void warn_of_file(const struct run *run, struct model *model) {
    for (int i = 0; i < MODEL_WARNINGS; i++) {
        struct error warning;
        if (model->warning_line[i] > 0) {
            const char *name = model->warning_name[i], *quote = name != NULL ? "'" : "";
            error_set(&warning, "%s%s%s%s%s", quote, name != NULL ? name : "", quote,
                      name != NULL ? " " : "", model_warning_text((enum model_warning)i));
            warning.line = model->warning_line[i];
            error_name_input(&warning, model->path);
            say(run, &warning);
        }
        model->warning_line[i] = 0;
    }
}

/* Print the warnings about all models, and about textures that are replaced. */
static void warn_of_files(struct run *run) {
    for (size_t i = 0; i < run->model_count; i++) {
        warn_of_file(run, &run->model[i]);
    }
    for (int i = 0; i < MODEL_TEXTURE_KINDS; i++) {
        struct error *replaced = &run->replaced[i];
        if (replaced->message[0] != '\0') {
            say(run, replaced);
        }
        replaced->message[0] = '\0';
    }
}

/* Say once that the model of the command line may be out of view, or hard to see. Who places
 * the camera knows. */
static void suggest_fit(struct run *run, const struct model *model) {
    const struct options *options = &run->options;
    bool placed = options->fit || options->eye.given || options->center.given;
    if (model == NULL || options->input_count == 0 || placed || run->fit_suggested) {
        return;
    }
    run->fit_suggested = true;
    struct box3 box = model_box(model);
    struct error advice;
    if (box_reaches_out(box)) {
        error_set(&advice, "reaches out of -1..1; --fit brings it into view");
    } else if (box_is_tiny(box)) {
        error_set(&advice, "fills little of -1..1; --fit makes it larger");
    } else {
        return;
    }
    error_name_input(&advice, options->input[0]);
    say(run, &advice);
}

/* All frames are black, or a single picture has a background and nothing before it. */
static bool shows_nothing(const struct stage *stage, const struct frames *frames) {
    const double *depth = stage->drawing.depth;
    if (frames->count == 1 && depth != NULL) {
        size_t far = 0;
        while (far < stage->pixel_count && depth[far] == -INFINITY) {
            far++;
        }
        return far == stage->pixel_count;
    }
    for (size_t i = 0; i < frames->count; i++) {
        const struct image *image = &frames->frame[i];
        size_t size = image->width * image->height * image->format, black = 0;
        while (black < size && image->pixels[black] == 0) {
            black++;
        }
        if (black < size) {
            return false;
        }
    }
    return true;
}

/* Does a face turn its outside to the eye? One that is seen from its edge, or has no area but what
 * rounding gives it, does not. */
static bool is_a_face_seen(const struct stage *stage) {
    const double noise = 1e-12;
    const struct model *model = stage->drawing.model;
    for (size_t i = 0; i < model->face_count; i++) {
        struct vec3 a = model_position(model, i, 0), along_z = {0, 0, 1}; /* in a parallel view */
        struct vec3 side = vec3_sub(model_position(model, i, 1), a);
        struct vec3 other = vec3_sub(model_position(model, i, 2), a);
        struct vec3 to_eye =
            stage->program->takes_camera ? vec3_sub(stage->drawing.eye, a) : along_z;
        double most = vec3_length(side) * vec3_length(other) * vec3_length(to_eye);
        if (vec3_dot(model_face_normal(model, i), to_eye) > noise * most) {
            return true;
        }
    }
    return false;
}

/* Why a scene may show nothing, or what may help. */
static const char *advise(const struct run *run, const struct stage *stage) {
    const struct options *options = &run->options;
    const struct program *program = run->options.program;
    struct box3 box = model_box(stage->drawing.model);
    if (stage->drawing.parts != NULL && stage->drawing.part_count == 0) {
        return ": its materials hide all faces (d 0)";
    }
    bool placed =
        program->takes_camera && !(same_point(stage->scene.eye, program->defaults.eye) &&
                                   same_point(stage->scene.center, program->defaults.center));
    const int *turns = options->turns;
    const bool turned = turns[0] != 0 || turns[1] != 0 || turns[2] != 0;
    if (!options->fit && (box_reaches_out(box) || box_is_tiny(box))) {
        return placed && !options->center.given ? "; what may help: --fit --center"
                                                : "; what may help: --fit";
    }
    if ((stage->scene.needs & NEEDS_LINES) == 0 && !is_a_face_seen(stage)) {
        return options->two_sided ? turned ? ": all faces lie edge-on"
                                           : ": all faces lie edge-on; what may help: --turn"
               : turned ? ": all faces look away or lie edge-on; what may help: --two-sided"
                        : ": all faces look away or lie edge-on; what may help: --two-sided --turn";
    }
    if (placed) {
        return options->center.given ? "" : "; what may help: --center";
    }
    return program->takes_light && !options->light.given ? "; what may help: --light" : "";
}

/* Say that a scene shows nothing of its model, where an option chose what is in view. Without one
 * it is the lesson that is not yet written. What is true of several scenes is said of the first. */
static void warn_of_nothing(struct run *run, const struct stage *stage,
                            const struct frames *frames) {
    const struct options *options = &run->options;
    bool chosen = options->input_count > 0 || options->eye.given || options->center.given ||
                  options->light.given;
    if (!chosen || !scene_needs_model(&stage->scene) || !shows_nothing(stage, frames)) {
        return;
    }
    const char *advice = advise(run, stage);
    if (run->advice == NULL || strcmp(run->advice, advice) != 0) {
        fprintf(stderr, "%s: scene %s: nothing was drawn%s\n", run->options.program->name,
                stage->scene.name, advice);
    }
    run->advice = advice;
}

/* ---- Drawing ---- */

/* Draw all frames once, each on black, which they are the first time. */
static bool draw_frames(struct stage *stage, const struct frames *frames, bool again,
                        struct error *error) {
    stage->drawing.counter_count = 0;
    for (size_t i = 0; i < frames->count; i++) {
        if (again) {
            image_clear(&frames->frame[i], (struct color){0, 0, 0, 0});
        }
        if (!stage_draw(stage, &frames->frame[i], i, error)) {
            return false;
        }
    }
    return true;
}

/* Draw `repeat` times and print the median time of one frame. */
static bool draw_timed(struct stage *stage, const struct frames *frames, size_t repeat,
                       struct error *error) {
    double *times = malloc(repeat * sizeof *times);
    if (times == NULL) {
        return error_out_of_memory(error);
    }
    bool done = true;
    for (size_t i = 0; done && i < repeat; i++) {
        double begin = now_ms();
        done = draw_frames(stage, frames, i > 0, error);
        times[i] = (now_ms() - begin) / (double)frames->count;
    }
    if (done) {
        printf("%s: %.3f ms\n", stage->scene.name, median(times, repeat));
    }
    free(times);
    return done;
}

static void print_counters(const struct stage *stage) {
    for (size_t i = 0; i < stage->drawing.counter_count; i++) {
        printf("%s.%s: %llu\n", stage->scene.name, stage->drawing.counters[i].name,
               (unsigned long long)stage->drawing.counters[i].value);
    }
}

/* How many textures there are and were read, in all. */
static void print_loaded(const struct run *run) {
    const struct loaded loaded = run_loaded(run);
    printf("files.textures_present: %llu\n", (unsigned long long)loaded.textures_present);
    printf("files.textures_read: %llu\n", (unsigned long long)loaded.textures_read);
}

/* Load, draw and save one scene. */
static bool draw_scene(struct run *run, const struct scene *given, struct error *error) {
    const struct options *options = &run->options;
    const struct scene scene = scene_complete(options, given);
    struct frames frames = {0};
    struct stage stage = {0};
    bool done = frames_create(&frames, options, &scene, error) &&
                stage_begin(&stage, run, &scene, frames.width, frames.height, error);
    warn_of_files(run);
    if (done) {
        suggest_fit(run, stage.drawing.model);
    }
    if (done && options->repeat > 0) {
        done = draw_timed(&stage, &frames, options->repeat, error);
    } else if (done) {
        done = draw_frames(&stage, &frames, false, error);
    }
    done = done && save(run, &scene, &frames, error);
    if (done) {
        warn_of_nothing(run, &stage, &frames);
    }
    if (done && options->stats) {
        print_counters(&stage);
    }
    stage_end(&stage);
    frames_free(&frames);
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
    return length <= INT_MAX ? string_format("%.*s", (int)length, base) : NULL;
}

/* The scene that draws what is in the text, from now on. */
static struct scene scene_of_text(struct run *run, const struct text_scene *text,
                                  const char *name) {
    run->text = text;
    return (struct scene){
        .name = name,
        .width = text->width,
        .height = text->height,
        .values = run->options.program->text_values,
        .draw = run->options.program->draw_text,
    };
}

static bool draw_text(struct run *run, struct error *error) {
    const char *path = run->options.input[0];
    struct text_scene text = {0};
    char *name = text_scene_name(path);
    bool done = name != NULL ? text_scene_read(&text, path, run->options.program->text_kind, error)
                             : error_out_of_memory(error);
    if (done) {
        const struct scene scene = scene_of_text(run, &text, name);
        done = draw_scene(run, &scene, error);
    }
    text_scene_free(&text);
    free(name);
    return done;
}

/* A scene that cannot be drawn does not keep the next from being drawn, but a model of the command
 * line that cannot be read does. Each message is said once, the last one by main(). */
static bool draw_scenes(struct run *run, struct error *error) {
    const struct options *options = &run->options;
    const struct program *program = options->program;
    bool done = true;
    for (size_t i = 0; i < program->scene_count; i++) {
        const struct scene *scene = &program->scenes[i];
        run->needs |= is_chosen(options, scene) ? scene->needs : 0;
    }
    bool readable = true;
    for (size_t i = 0; i < program->scene_count && readable; i++) {
        const struct scene *scene = &program->scenes[i];
        struct error fault;
        if (!is_chosen(options, scene) || draw_scene(run, scene, &fault)) {
            continue;
        }
        if (!done && strcmp(error->message, fault.message) != 0) {
            say(run, error);
        }
        *error = fault;
        done = false;
        readable =
            options->input_count == 0 || run->model_file != NULL || !scene_needs_model(scene);
    }
    if (run->options.stats && run->model_file != NULL) {
        print_loaded(run);
    }
    return done;
}

/* ---- --live ---- */

/* Draw one frame of the scene and write it. */
static bool answer_scene(struct run *run, const struct scene *given, FILE *out,
                         struct error *error) {
    const struct scene scene = scene_complete(&run->request, given);
    struct image image = {.pixels = NULL};
    struct stage stage = {0};
    size_t frame = run->request.frame > 0 ? run->request.frame - 1 : 0;
    bool done = image_create(&image, scene.width, scene.height, scene.format, error) &&
                stage_begin(&stage, run, &scene, scene.width, scene.height, error);
    double begin = now_ms();
    done = done && stage_draw(&stage, &image, frame % scene.frames, error);
    if (done) {
        live_write_frame(&image, now_ms() - begin, &stage.drawing, out);
    }
    stage_end(&stage);
    image_free(&image);
    return done;
}

static bool answer_text(struct run *run, const struct bytes *lines, FILE *out,
                        struct error *error) {
    const struct program *program = run->options.program;
    struct text_scene text;
    if (program->draw_text == NULL) {
        return error_set(error, "takes no text scene");
    }
    if (!text_scene_decode(&text, lines->data, lines->size, program->text_kind, error)) {
        return false;
    }
    const struct scene scene = scene_of_text(run, &text, "text");
    bool done = answer_scene(run, &scene, out, error);
    run->text = NULL;
    text_scene_free(&text);
    return done;
}

/* Options of the request; the model, turned and fitted or not, is that of the command line. */
static bool answer(void *context, struct live_request *request, FILE *out, struct error *error) {
    struct run *run = context;
    const struct program *program = run->options.program;
    run->asked = &run->request;
    if (!options_parse(&run->request, program, request->argc, request->argv, error) ||
        !check_options(&run->request, error)) {
        return false;
    }
    if (run->request.input_count > 0 || run->request.live) {
        return error_set(error, "the model and --live belong on the command line");
    }
    if (request->has_text) {
        return answer_text(run, &request->text, out, error);
    }
    const struct scene *scene = run->request.only;
    return answer_scene(run, scene != NULL ? scene : &program->scenes[0], out, error);
}

/* What a student's program prints must not come between the frames: it goes to standard error, line
 * by line, so that it is there before a crash. */
static FILE *live_output(void) {
#ifdef __wasi__ /* which has no dup() */
    return stdout;
#else
    int output = dup(STDOUT_FILENO);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    return output >= 0 && dup2(STDERR_FILENO, STDOUT_FILENO) >= 0 ? fdopen(output, "wb") : NULL;
#endif
}

/* All that any scene needs of the model is read at once. */
static bool answer_all(struct run *run, struct error *error) {
    const struct program *program = run->options.program;
    run->needs = program_needs(program);
    FILE *out = live_output();
    if (out == NULL) {
        return error_set(error, "cannot write to standard output");
    }
    live_describe(program, out);
    bool done = live_loop(program, stdin, out, answer, run, error);
    if (out != stdout) {
        fclose(out);
    }
    return done;
}

/* ---- The program ---- */

static bool run_command(struct run *run, struct error *error) {
    const struct program *program = run->options.program;
    bool text = run->options.input_count > 0 && program->draw_text != NULL;
    bool done = true;
    if (run->options.help) {
        options_print_help(program);
    } else if (run->options.live) {
        done = answer_all(run, error);
    } else {
        done = text ? draw_text(run, error) : draw_scenes(run, error);
    }
    if (done && (fflush(stdout) != 0 || ferror(stdout))) {
        done = error_set(error, "cannot write to standard output: %s", strerror(errno));
    }
    return done;
}

int program_main(const struct program *program, int argc, char **argv) {
    struct run run = {.text = NULL};
    struct error error = {0};
    int status = STATUS_USAGE;
#ifdef _WIN32
    windows_begin(&argc, &argv);
#endif
    keep_freed_memory();
    run.asked = &run.options;
    if (options_parse(&run.options, program, argc, argv, &error) &&
        check_options(&run.options, &error)) {
        status = run_command(&run, &error) ? STATUS_DONE : STATUS_FAILED;
    }
    if (status != STATUS_DONE) {
        fprintf(stderr, "%s: %s\n", program->name, error.message);
    }
    run_free(&run);
    return status;
}
