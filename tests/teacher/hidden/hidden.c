/*
 * Hidden scenes: lets a step's program and a solution draw what nobody has seen, from a seed, and
 * compares the pictures with the limits of the scenes' table.
 *
 *     hidden PROGRAMS SOLUTIONS SEED MAKE STEP...
 *
 * PROGRAMS and SOLUTIONS are directories. Where the command MAKE is not empty, each program is
 * built first, as the check does it, and until the end no check works in PROGRAMS. STEP is a name
 * like step05_zbuffer; its solution is SOLUTIONS/step05_zbuffer/step05_zbuffer. Of a scene that is
 * wrong only the class is printed:
 *
 *     step05_zbuffer  HIDDEN 11/12
 *       hidden: depth of a model in another size: wrong
 *
 * and at the end `HIDDEN 59/60`, the sum. A scene that does not depend on the model that is given
 * is drawn in another size, unless all sizes have the same picture: it is no secret. A program
 * that draws a reference where the input asks for another picture, or never any for what is new, is
 * to be looked at by a person; nothing else is told of it, and no point is taken:
 *
 *     step05_zbuffer  look at it: draws the reference where another picture is asked for: 3
 *
 * Exit status: 0 all right, 1 something is wrong, 2 it cannot be tried.
 */
#define _POSIX_C_SOURCE 200809L

#include "check/build.h"
#include "check/compare.h"
#include "check/drawn.h"
#include "check/inputs.h"
#include "check/options.h"
#include "check/run.h"
#include "check/scenes.h"
#include "check/unseen.h"

#include "base/file.h"
#include "files/image_file.h"
#include "geometry.h"

#include <errno.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    STATUS_WRONG = 1,
    STATUS_CANNOT_WORK = 2,
    SECONDS = 30,
    OPTION_TEXT = 48,
    FIRST_SIZE = 600, /* of images in another size: these, and up to LAST_SIZE */
    LAST_SIZE = 900,
    KNOWN_LEAST = 50,   /* drawn pixels of a picture that nobody draws by chance */
    SHARED_LEAST = 5000 /* and of one that is judged by shares of them */
};

/* What is drawn, and the program's other options. */
struct hidden_case {
    const char *says;
    enum input_kind kind;
    unsigned first, last; /* the steps in which it is tried, inclusive */
    bool size, light, camera;
    bool fixed; /* in scenes that do not depend on the model, and not in those that do */
};

static const struct hidden_case cases[] = {
    {"lines", INPUT_LINES, 1, 1, false, false, false, false},
    {"lines that no tie decides", INPUT_ODD_LINES, 1, 1, false, false, false, false},
    {"lines along the axes and diagonals", INPUT_AXIS_LINES, 1, 1, false, false, false, false},
    {"lines of two colours", INPUT_GRADIENT_LINES, 1, 1, false, false, false, false},
    {"wireframe of a model", INPUT_MODEL, 2, 2, true, false, false, false},
    {"triangles", INPUT_TRIANGLES, 3, 3, false, false, false, false},
    {"more triangles", INPUT_TRIANGLES, 3, 3, false, false, false, false},
    {"triangles of three colours", INPUT_GRADIENT_TRIANGLES, 3, 3, false, false, false, false},
    {"a new model", INPUT_MODEL, 2, 10, false, false, false, false},
    {"a model without normals", INPUT_MODEL_OFF, 2, 5, true, false, false, false},
    {"a model in another size", INPUT_MODEL, 2, 10, true, false, false, false},
    {"a model in another light", INPUT_MODEL, 4, 10, false, true, false, false},
    {"a model from another camera", INPUT_MODEL, 8, 10, true, true, true, false},
    {"another size", INPUT_MODEL, 2, 10, true, false, false, true},
    {"one more size", INPUT_MODEL, 2, 10, true, false, false, true},
};

enum { CASE_COUNT = sizeof cases / sizeof cases[0] };

struct hidden {
    char runner[DRAWN_PATH_LIMIT]; /* what submissions are run by, or "" */
    char *programs, *solutions;
    bool builds;          /* or the programs are built already */
    struct options check; /* what a check would be told to build the programs */
    uint64_t seed;
    struct scene_table table;
    size_t right, tried;
    /* Of the present step: */
    struct image *references; /* by its scenes, empty where there is none */
    size_t known;             /* pictures that are references */
    size_t missing;           /* and none at all, of programs that end well */
    struct bytes wrong;       /* a line each */
};

/* ---- The program's options ---- */

struct told {
    char text[UNSEEN_OPTION_LIMIT][OPTION_TEXT];
    const char *list[UNSEEN_OPTION_LIMIT + 1]; /* ends with NULL */
    size_t count;
};

static void tell(struct told *told, const char *format, ...) PRINTF_LIKE(2, 3);

static void tell(struct told *told, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(told->text[told->count], OPTION_TEXT, format, arguments);
    va_end(arguments);
    told->list[told->count] = told->text[told->count];
    told->list[++told->count] = NULL;
}

/* Three numbers from -reach to reach, in hundredths, the last one `away` from 0. Returns them. */
static struct vec3 tell_vector(struct told *told, struct random *random, const char *option,
                               int reach, int away) {
    double x = random_between(random, -reach, reach) / 100.0;
    double y = random_between(random, -reach, reach) / 100.0;
    double z = random_between(random, away, away + reach) / 100.0;
    tell(told, "%s", option);
    tell(told, "%.2f,%.2f,%.2f", x, y, z);
    return (struct vec3){x, y, z};
}

/* In lessons 4 to 6 light is a direction that goes away from the viewer, along -z. */
static void tell_all(struct told *told, const struct hidden_case *hidden_case, unsigned step,
                     uint64_t seed) {
    struct random random = {seed};
    told->count = 0;
    told->list[0] = NULL;
    if (step >= 2 && step != 3) {
        tell(told, "--only");
        tell(told, "all");
    }
    if (hidden_case->size) {
        int width = random_between(&random, FIRST_SIZE, LAST_SIZE);
        tell(told, "-s");
        tell(told, "%dx%d", width, random_between(&random, FIRST_SIZE, LAST_SIZE));
    }
    if (hidden_case->light) {
        tell_vector(told, &random, "--light", 150, step <= 6 ? -170 : 20);
    }
    if (hidden_case->camera) {
        struct vec3 eye = tell_vector(told, &random, "--eye", 80, 150);
        struct vec3 center = tell_vector(told, &random, "--center", 20, -10);
        struct vec3 up = {random_between(&random, -30, 30) / 100.0, 1, 0};
        int kind = random_between(&random, 0, 3); /* now and then along the view, or against it */
        if (kind < 2) {
            up = vec3_scale(vec3_sub(eye, center), kind == 0 ? 1 : -1);
        }
        tell(told, "--up");
        tell(told, "%.2f,%.2f,%.2f", up.x, up.y, up.z);
    }
}

/* ---- Building ---- */

/* What is judged is main.c as it is now, whatever was built of it before. One that does not
 * build is gone, and draws nothing. */
static bool build_yours(const struct hidden *hidden, const char *step, struct error *error) {
    struct build_result result = {.reason = {""}};
    if (!hidden->builds) {
        return true;
    }
    bool done = build_step(&hidden->check, step, false, &result, error);
    bytes_free(&result.messages);
    return done && (run_caught_signal() == 0 || error_set(error, "interrupted"));
}

/* ---- Drawing ---- */

/* Both drew the same input. */
struct pair {
    struct unseen_place yours;
    char solution[DRAWN_PATH_LIMIT]; /* the directory of its pictures */
};

/* How a program ended, and what it said. */
struct ending {
    bool well;
    struct message_line said;
};

/* `runner` is what the program is run by, or "": a solution needs none, which could hide it. */
static bool draw(struct unseen_place *place, const char *runner, const char *programs,
                 const char *step, const struct told *told, enum input_kind kind, uint64_t seed,
                 struct ending *ending, struct error *error) {
    const struct run_limits limits = run_program_limits(SECONDS);
    const struct variant plain = {.turned = 0};
    struct drawn_path program;
    struct run_result result;
    if (!drawn_program(&program, programs, step, error)) {
        return false;
    }
    setenv("CHECK_RUNNER", runner, 1);
    bool done =
        unseen_draw(place, program.text, told->list, kind, seed, &plain, &limits, &result, error);
    ending->well = done && result.end == RUN_EXITED && result.number == 0;
    ending->said = drawn_message(done ? (const char *)result.messages.data : "");
    if (done && run_caught_signal() != 0) {
        done = error_set(error, "interrupted");
    }
    bytes_free(&result.messages);
    return done;
}

/* The solution's pictures of case `number`, drawn once for all programs: SOLUTIONS/STEP/drawn,
 * where it exists, keeps them. `directory` becomes theirs; the caller ends `place` after use. */
static bool draw_solution(const struct hidden *hidden, struct unseen_place *place, const char *step,
                          const struct told *told, enum input_kind kind, size_t number,
                          char *directory, struct error *error) {
    char solutions[DRAWN_PATH_LIMIT];
    struct ending ending;
    snprintf(solutions, sizeof solutions, "%s/%s", hidden->solutions, step);
    snprintf(directory, DRAWN_PATH_LIMIT, "%s/%s/drawn/%" PRIu64 ".%zu", hidden->solutions, step,
             hidden->seed, number);
    if (file_exists(directory)) {
        return true;
    }
    if (!unseen_begin(place, error) || !draw(place, "", solutions, step, told, kind,
                                             hidden->seed * 1000 + number, &ending, error)) {
        return false;
    }
    if (!ending.well) {
        return error_set(error, "%s: the solution does not draw %s: %s", step,
                         number < CASE_COUNT ? cases[number].says : "a model", ending.said.text);
    }
    bool kept = rename(place->pictures, directory) == 0; /* nobody was first */
    if (!kept) {
        snprintf(directory, DRAWN_PATH_LIMIT, "%s", place->pictures);
    }
    return true;
}

/* ---- Judging ---- */

static void read_references(struct hidden *hidden, const struct checked_step *step) {
    for (size_t i = 0; i < step->scene_count; i++) {
        char path[DRAWN_PATH_LIMIT];
        struct error ignored;
        snprintf(path, sizeof path, "tests/reference/%s/%s.png", step->name, step->items[i].scene);
        image_read(&hidden->references[i], path, &ignored);
    }
}

/* Does the picture differ from the reference that everybody has, or is there none (NULL)? */
static bool is_secret(const struct image *picture, const struct image *reference) {
    return reference == NULL || !is_same_picture(reference, picture);
}

/* The limits were chosen between correct programs and mistakes on the scenes of the course. Faces
 * made here are fewer and larger, and their colours differ more: so much more is allowed, in
 * thousandths of a percent. (The worst correct program needed 0.8 %, 1.2 % and 0.1 %.) Where a
 * reference must be exact, a new model's corner may lie where float or double decides, and moves a
 * line by a pixel: 3.2 % of the worst picture. */
enum { MORE_WRONG = 1000, MORE_APART = 2000, MORE_COVERAGE = 200, MORE_MOVED = 4000 };

static bool is_right(const struct image *solution, const struct image *yours,
                     const struct checked_item *limits, bool exact) {
    if (yours->width != solution->width || yours->height != solution->height || exact) {
        return is_same_picture(solution, yours);
    }
    struct comparison found = compare_images(solution, yours);
    unsigned apart = limits->exact ? MORE_MOVED : limits->apart_limit + MORE_APART;
    unsigned coverage = limits->exact ? MORE_MOVED : limits->coverage_limit + MORE_COVERAGE;
    return share_within(found.wrong.count, found.drawn, limits->wrong_limit + MORE_WRONG) &&
           share_within(found.apart.count, found.drawn, apart) &&
           share_within(found.coverage.count, found.drawn, coverage);
}

/* Are there so few pixels that a share of them says nothing? In a head of 1,480 pixels, a correct
 * program had 24 that were apart; in one of 2,131, 6 that were drawn in one picture only. */
static bool is_small(const struct image *solution) {
    return compare_images(solution, solution).drawn < SHARED_LEAST;
}

/* Is it one of the lesson's references? */
static bool is_reference(const struct hidden *hidden, const struct checked_step *step,
                         const struct image *yours) {
    bool is_known = false;
    for (size_t i = 0; i < step->scene_count && !is_known; i++) {
        is_known = !is_secret(yours, &hidden->references[i]);
    }
    return is_known && compare_images(yours, yours).drawn >= KNOWN_LEAST;
}

/* Compare the pictures PICTURE.tga of both; counts it, and says when it is wrong. What everybody
 * has, which is `reference` (NULL: nothing), is not counted. */
static void judge(struct hidden *hidden, const struct pair *pair, const struct ending *ending,
                  const struct checked_step *step, const char *picture,
                  const struct image *reference, const struct checked_item *scene,
                  const char *says) {
    struct image solution, yours;
    struct error ignored;
    if (drawn_read(&solution, pair->solution, picture, NULL, &ignored) != DRAWN_READ) {
        return; /* the scene does not take this input */
    }
    bool is_exact = reference == NULL && scene->exact; /* whole numbers are, a new model is not */
    if (!is_secret(&solution, reference) || (reference != NULL && is_small(&solution))) {
        image_free(&solution);
        return;
    }
    enum drawn_state state = drawn_read(&yours, pair->yours.pictures, picture, &solution, &ignored);
    bool right = is_right(&solution, &yours, scene, is_exact);
    hidden->tried++;
    hidden->right += right;
    hidden->missing += ending->well && state == DRAWN_MISSING;
    if (!right) {
        hidden->known += is_reference(hidden, step, &yours);
        char line[320];
        int length = snprintf(line, sizeof line, "  hidden: %s: wrong\n", says);
        bytes_append(&hidden->wrong, line, (size_t)length); /* without memory it is only not told */
    }
    image_free(&solution);
    image_free(&yours);
}

/* The scene of the table whose limits hold for a text scene. */
static const struct checked_item *limits_for(const struct hidden *hidden, const char *step,
                                             enum input_kind kind) {
    bool lines = strncmp(step, "step01_", 7) == 0;
    bool gradient = kind == INPUT_GRADIENT_LINES || kind == INPUT_GRADIENT_TRIANGLES;
    return scene_table_find(&hidden->table, step,
                            gradient ? "gradient"
                            : lines  ? "line"
                                     : "triangle");
}

/* Scenes that are left to the references, since correct programs of alternatives.txt differ in
 * them. `square` and `cards` have corners that other sizes put between two pixels, where float and
 * sixteenths of a pixel decide otherwise, and `rows` has few pixels: in 18 seeds, -Ofast was wrong
 * in one. */
static bool is_left_out(const char *step, const char *scene) {
    static const struct {
        const char *step, *scene;
    } list[] = {{"step02_", "square"}, {"step05_", "rows"}, {"step05_", "cards"}};
    bool is_listed = false;
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        is_listed = is_listed || (strncmp(step, list[i].step, strlen(list[i].step)) == 0 &&
                                  strcmp(scene, list[i].scene) == 0);
    }
    return is_listed;
}

/* What a scene is good for. */
enum use {
    USE_NONE,  /* nothing */
    USE_MODEL, /* it depends on the model: it differs from its reference without any options */
    USE_FIXED  /* it does not */
};

/* What scenes are drawn for in that case. */
static enum use use_of(const struct hidden_case *hidden_case) {
    return hidden_case->fixed ? USE_FIXED : USE_MODEL;
}

static bool is_used(const struct checked_step *step, const enum use *uses, enum use use) {
    size_t i = 0;
    while (i < step->scene_count && uses[i] != use) {
        i++;
    }
    return i < step->scene_count;
}

static bool find_uses(const struct hidden *hidden, const struct checked_step *step, enum use *uses,
                      struct error *error) {
    static const struct hidden_case plain = {.size = false};
    struct told told;
    char solution[DRAWN_PATH_LIMIT];
    struct unseen_place place = {.whole = {""}};
    tell_all(&told, &plain, (unsigned)strtoul(step->name + 4, NULL, 10), hidden->seed);
    bool done =
        draw_solution(hidden, &place, step->name, &told, INPUT_MODEL, CASE_COUNT, solution, error);
    for (size_t i = 0; i < step->scene_count && done; i++) {
        struct image image;
        struct error ignored;
        drawn_read(&image, solution, step->items[i].scene, NULL, &ignored);
        if (image.width > 0 && !is_left_out(step->name, step->items[i].scene)) {
            uses[i] = is_secret(&image, &hidden->references[i]) ? USE_MODEL : USE_FIXED;
        }
        image_free(&image);
    }
    unseen_end(&place);
    return done;
}

static bool try_case(struct hidden *hidden, const struct checked_step *step, size_t number,
                     const enum use *uses, struct error *error) {
    const struct hidden_case *hidden_case = &cases[number];
    unsigned step_number = (unsigned)strtoul(step->name + 4, NULL, 10);
    uint64_t seed = hidden->seed * 1000 + number;
    struct told told;
    struct pair pair = {.yours = {.whole = {""}}};
    struct unseen_place solution = {.whole = {""}};
    struct ending yours;
    char says[256];
    tell_all(&told, hidden_case, step_number, seed);
    bool done = draw_solution(hidden, &solution, step->name, &told, hidden_case->kind, number,
                              pair.solution, error) &&
                unseen_begin(&pair.yours, error) &&
                draw(&pair.yours, hidden->runner, hidden->programs, step->name, &told,
                     hidden_case->kind, seed, &yours, error);
    if (done && unseen_takes_text(step->name)) {
        judge(hidden, &pair, &yours, step, "scene", NULL,
              limits_for(hidden, step->name, hidden_case->kind), hidden_case->says);
    }
    for (size_t i = 0; i < step->scene_count && done && !unseen_takes_text(step->name); i++) {
        if (uses[i] == use_of(hidden_case)) {
            snprintf(says, sizeof says, "%s %s %s", step->items[i].scene,
                     hidden_case->fixed ? "in" : "of", hidden_case->says);
            judge(hidden, &pair, &yours, step, step->items[i].scene, &hidden->references[i],
                  &step->items[i], says);
        }
    }
    unseen_end(&pair.yours);
    unseen_end(&solution);
    return done;
}

/* What a person should look at, whose program it is. */
static void print_look_at(const struct hidden *hidden, const char *step, size_t tried) {
    if (hidden->known > 0) {
        printf("%s  look at it: draws the reference where another picture is asked for: %zu\n",
               step, hidden->known);
    } else if (hidden->missing == tried) {
        printf("%s  look at it: draws no picture of anything that is new\n", step);
    }
}

/* Try the step, and print what came of it. */
static bool try_step(struct hidden *hidden, const struct checked_step *step, struct error *error) {
    unsigned number = (unsigned)strtoul(step->name + 4, NULL, 10);
    bool text = unseen_takes_text(step->name);
    enum use *uses = calloc(step->scene_count, sizeof *uses);
    size_t right = hidden->right, tried = hidden->tried;
    hidden->known = hidden->missing = 0;
    hidden->references = calloc(step->scene_count, sizeof *hidden->references);
    bool done = uses != NULL && hidden->references != NULL;
    if (done) {
        read_references(hidden, step);
    } else {
        error_out_of_memory(error);
    }
    done = done && build_yours(hidden, step->name, error) &&
           (text || find_uses(hidden, step, uses, error));
    for (size_t i = 0; i < CASE_COUNT && done; i++) {
        bool text_case = strcmp(input_name(cases[i].kind), "scene.txt") == 0;
        if (number >= cases[i].first && number <= cases[i].last && text == text_case &&
            (text || is_used(step, uses, use_of(&cases[i])))) {
            done = try_case(hidden, step, i, uses, error);
        }
    }
    if (done && hidden->tried == tried) {
        done = error_set(error, "%s: the solution draws nothing new: nothing can be compared",
                         step->name);
    }
    if (done) {
        printf("%s  HIDDEN %zu/%zu\n%.*s", step->name, hidden->right - right, hidden->tried - tried,
               (int)hidden->wrong.size,
               hidden->wrong.size > 0 ? (const char *)hidden->wrong.data : "");
        print_look_at(hidden, step->name, hidden->tried - tried);
        fflush(stdout);
    }
    for (size_t i = 0; i < step->scene_count && hidden->references != NULL; i++) {
        image_free(&hidden->references[i]);
    }
    free(hidden->references);
    free(uses);
    bytes_free(&hidden->wrong);
    return done;
}

static bool try_all(struct hidden *hidden, char **steps, int step_count, struct error *error) {
    if (!scene_table_read(&hidden->table, "tests/check/scenes.txt", error)) {
        return false;
    }
    for (int i = 0; i < step_count; i++) {
        if (!scene_table_select(&hidden->table, steps[i], error)) {
            return false;
        }
    }
    for (size_t i = 0; i < hidden->table.step_count; i++) {
        const struct checked_step *step = &hidden->table.steps[i];
        if (step->selected && !try_step(hidden, step, error)) {
            return false;
        }
    }
    printf("HIDDEN %zu/%zu\n", hidden->right, hidden->tried);
    return (fflush(stdout) == 0 && !ferror(stdout)) ||
           error_set(error, "the score could not be written to standard output");
}

/* ---- What is wanted ---- */

static int try_and_tell(struct hidden *hidden, const char *make, char **steps, int step_count) {
    struct error error;
    run_catch_signals();
    bool done = options_begin(&hidden->check, &error);
    hidden->check.programs = hidden->programs;
    hidden->check.make = make;
    hidden->builds = make[0] != '\0';
    if (done && hidden->builds) { /* nobody else builds or removes them until this process ends */
        done = build_lock(&hidden->check, &error);
    }
    done = done && try_all(hidden, steps, step_count, &error);
    scene_table_free(&hidden->table);
    if (run_caught_signal() != 0) {
        run_die_of_signal();
    }
    if (!done) {
        fprintf(stderr, "hidden: %s\n", error.message);
        return STATUS_CANNOT_WORK;
    }
    return hidden->right == hidden->tried ? EXIT_SUCCESS : STATUS_WRONG;
}

int main(int argc, char **argv) {
    enum { PROGRAMS = 1, SOLUTIONS, SEED, MAKE, FIRST_STEP };
    if (argc <= FIRST_STEP) {
        fputs("usage: hidden PROGRAMS SOLUTIONS SEED MAKE STEP...\n", stderr);
        return STATUS_CANNOT_WORK;
    }
    const char *seed = argv[SEED], *runner = getenv("CHECK_RUNNER");
    char *end;
    struct hidden hidden = {
        .programs = argv[PROGRAMS], .solutions = argv[SOLUTIONS], .seed = strtoull(seed, &end, 10)};
    if (seed[0] < '0' || seed[0] > '9' || *end != '\0') {
        fprintf(stderr, "hidden: '%s' is no seed: a number is wanted\n", seed);
        return STATUS_CANNOT_WORK;
    }
    snprintf(hidden.runner, sizeof hidden.runner, "%s", runner != NULL ? runner : "");
    return try_and_tell(&hidden, argv[MAKE], argv + FIRST_STEP, argc - FIRST_STEP);
}
