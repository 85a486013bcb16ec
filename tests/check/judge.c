#define _POSIX_C_SOURCE 200809L

#include "judge.h"

#include "base/file.h"
#include "build.h"
#include "compare.h"
#include "diagnose.h"
#include "drawn.h"
#include "fault.h"
#include "files/image_file.h"
#include "files/png.h"
#include "judging.h"
#include "legend.h"
#include "looks.h"
#include "numbers.h"
#include "run.h"
#include "todo.h"
#include "verdict.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    TIMEOUT_LIMIT = 3, /* times that a step's program is waited for in vain; then only shortly */
    SOURCE_LIMIT = 1 << 20, /* bytes of main.c */
    FILE_EXTRA = 8192       /* bytes on the disk of a picture's file, around its pixels */
};

/* ---- What a picture shows ---- */

/* 1597 as "1,597". */
struct count_text {
    char text[32];
};

static struct count_text show_count(uint64_t count) {
    struct count_text shown = {""};
    char digits[24];
    int length = snprintf(digits, sizeof digits, "%llu", (unsigned long long)count);
    for (int i = 0; i < length; i++) {
        bool begins_group = i > 0 && (length - i) % 3 == 0;
        strncat(strcat(shown.text, begins_group ? "," : ""), digits + i, 1);
    }
    return shown;
}

/* Where the first of these pixels is, your colour there and the right one. */
static void describe_first(struct item_result *item, const struct tally *tally,
                           const struct image *reference, const struct image *yours) {
    item->x = tally->x;
    item->y = tally->y;
    item->got = image_get(yours, (int)tally->x, (int)tally->y);
    item->wanted = image_get(reference, (int)tally->x, (int)tally->y);
    result_say(&item->message, ", first at (%zu,%zu): yours %d,%d,%d, right %d,%d,%d", item->x,
               item->y, item->got.r, item->got.g, item->got.b, item->wanted.r, item->wanted.g,
               item->wanted.b);
}

/* Judge a picture that is not exact by its limits. Returns the pixels to report. */
static const struct tally *judge_shares(struct item_result *item) {
    const struct comparison *shares = &item->shares;
    const struct verdict verdict = verdict_find(shares, item->rule);
    const uint64_t drawn = shares->drawn, differing = shares->differing.count;
    if (verdict.passes) {
        item->state = RESULT_PASS;
        result_say(&item->message, "%s differ (%s pixel%s)", share_show(differing, drawn, 0).text,
                   show_count(differing).text, differing == 1 ? "" : "s");
    } else if (item->rule->exact && differing == drawn) {
        result_say(&item->message, "no drawn pixel is right (must be exact)");
    } else if (item->rule->exact) {
        result_say(&item->message, "%s of %s drawn pixels differ (must be exact)",
                   show_count(differing).text, show_count(drawn).text);
    } else if (verdict.what == NULL) {
        const double lighter = compare_lighter(shares);
        result_say(&item->message, "too %s by %.1f values on average (limit %g)",
                   lighter > 0 ? "light" : "dark", fabs(lighter), COMPARE_LIGHTER / 1000.0);
    } else {
        result_say(&item->message, "%s of drawn pixels %s (limit %g %%)",
                   share_show(verdict.tally->count, drawn, verdict.limit).text, verdict.what,
                   verdict.limit / 1000.0);
    }
    return verdict.tally;
}

/* Add to a file, "" for none, which whoever keeps limits and signs of mistakes has asked for. */
void judging_append(const char *path, const char *format, ...) {
    if (path[0] == '\0') {
        return;
    }
    FILE *file = fopen(path, "a");
    va_list arguments;
    va_start(arguments, format);
    if (file == NULL || vfprintf(file, format, arguments) < 0 || fclose(file) != 0) {
        fprintf(stderr, "check: %s: %s\n", path, strerror(errno));
    }
    va_end(arguments);
}

/* At the end how far the picture is from the mistake that it looks like, or - when like none. */
static void write_shares(const char *path, const char *step, const struct item_result *item,
                         const struct likeness *likeness) {
    char distance[24] = "-";
    const struct comparison *shares = &item->shares;
    const double share = 100 / (shares->drawn > 0 ? (double)shares->drawn : 1);
    if (likeness->row > 0) {
        snprintf(distance, sizeof distance, "%zu", likeness->distance);
    }
    judging_append(path, "%s %s %.4f %.4f %.4f %.4f %.4f %s\n", step, item->scene,
                   share * (double)shares->wrong.count, share * (double)shares->apart.count,
                   share * (double)shares->coverage.count, share * (double)shares->near.count,
                   compare_lighter(shares), distance);
}

static void judge_picture(const struct judging *judging, size_t i, const struct image *yours) {
    bool is_near = false; /* does it fail only for pixels that are near? */
    struct item_result *item = &judging->result->items[i];
    const struct image *reference = &judging->references[i];
    struct likeness likeness = {.row = 0};
    item->shares = compare_images(reference, yours);
    item->compared = true;
    item->exact = item->shares.differing.count == 0;
    item->blank = image_is_blank(yours);
    if (item->exact) {
        item->state = RESULT_PASS;
    } else {
        const struct tally *tally = judge_shares(item);
        describe_first(item, tally, reference, yours);
        is_near = tally == &item->shares.near;
    }
    if (item->state == RESULT_FAIL) {
        const uint64_t apart = item->shares.apart.count;
        if (is_near) {
            likeness = looks_find(&judging->looks[i], reference, yours, 0);
        }
        if (likeness.row == 0) {
            likeness = looks_find(&judging->looks[i], reference, yours, apart);
        }
        looks_compare(&judging->looks[i], yours);
        item->looks_row = likeness.row;
        item->seen = seen_find(reference, yours);
    }
    write_shares(judging->options->shares, judging->step->name, item, &likeness);
}

/* ---- The pictures that are kept ---- */

/* DIFFERENCES/STEP/PLACE/SCENE.png; PLACE/ may be "". */
static struct result_path kept_path(const struct judging *judging, const char *place,
                                    const char *scene) {
    struct result_path path;
    snprintf(path.text, sizeof path.text, "%s/%s/%s%s.png", judging->options->differences,
             judging->step->name, place, scene);
    return path;
}

static struct result_path reference_path(const struct judging *judging, const char *scene) {
    struct result_path path;
    snprintf(path.text, sizeof path.text, "%s/%s/%s.png", judging->options->references,
             judging->step->name, scene);
    return path;
}

/* Write the picture, and make the directory above it. Returns its path, or none. */
static struct result_path keep_picture(const struct image *picture, struct result_path path) {
    struct error error;
    struct result_path directory = path;
    *strrchr(directory.text, '/') = '\0';
    if (!directory_create(directory.text, &error) || !png_write(picture, path.text, &error)) {
        fprintf(stderr, "check: no difference image: %s\n", error.message);
        path.text[0] = '\0';
    }
    return path;
}

static void keep_pictures(const struct judging *judging, struct item_result *item,
                          const struct image *reference, const struct image *yours) {
    struct image picture;
    struct error error;
    item->reference = reference_path(judging, item->scene);
    if (yours->pixels != NULL) {
        item->yours = keep_picture(yours, kept_path(judging, "yours/", item->scene));
    }
    if (legend_picture(&picture, reference, yours, verdict_find(&item->shares, item->rule).pixels,
                       &error)) {
        item->difference = keep_picture(&picture, kept_path(judging, "", item->scene));
    } else {
        fprintf(stderr, "check: no difference image: %s\n", error.message);
    }
    image_free(&picture);
}

/* One that is not there has no name, which is no file's. */
void judging_drop_picture(struct result_path *path) {
    unlink(path->text);
    path->text[0] = '\0';
}

/* A scene that was missing, and is exact where it is drawn alone, has none. */
static void drop_pictures(struct item_result *item) {
    judging_drop_picture(&item->yours);
    judging_drop_picture(&item->difference);
    item->reference.text[0] = '\0';
}

/* A picture of an earlier check must not be taken for one of this check. */
static void remove_old_pictures(const struct judging *judging) {
    for (size_t i = 0; i < judging->step->scene_count; i++) {
        unlink(kept_path(judging, "", judging->step->items[i].scene).text);
        unlink(kept_path(judging, "yours/", judging->step->items[i].scene).text);
    }
}

/* ---- How a program ended ---- */

bool judging_ended_well(const struct run_result *end) {
    return end->end == RUN_EXITED && end->number == 0;
}

/* The state that an end gives to what was not drawn, or RESULT_FAIL. */
static enum result_state state_of_end(const struct run_result *end) {
    return end->end == RUN_OUT_OF_TIME ? RESULT_TIME
           : end->end == RUN_KILLED    ? RESULT_CRASH
                                       : RESULT_FAIL;
}

/* Has a sanitizer ended it? */
static bool is_fault(const struct judging *judging, const struct run_result *end,
                     struct result_text *text) {
    return end->end != RUN_OUT_OF_TIME && !judging_ended_well(end) &&
           fault_describe(text, judging->step->name, (const char *)end->messages.data);
}

/* What malloc() and free() of glibc say where a program has spoilt their lists. */
static bool is_spoilt_memory(const char *said) {
    return strstr(said, "malloc()") != NULL || strstr(said, "free()") != NULL ||
           strstr(said, "corrupted") != NULL || strstr(said, "munmap_chunk()") != NULL;
}

/* How it ended, when not well, and what it said. */
static void describe_end(struct result_text *text, const struct run_result *end,
                         const struct run_limits *limits) {
    const struct message_line said = drawn_message((const char *)end->messages.data);
    const struct run_text ended = run_ended_by(end, limits);
    const bool speaks = said.text[0] != '\0' && (end->end == RUN_KILLED || end->end == RUN_EXITED);
    const bool spoilt = end->end == RUN_KILLED && is_spoilt_memory(said.text);
    if (ended.text[0] != '\0') {
        result_say(text, "%s%s%s%s", ended.text, speaks ? ": " : "",
                   spoilt ? "memory was written outside of an array: " : "",
                   speaks ? said.text : "");
    }
}

/* ---- Pictures ---- */

/* Read the references and what is known of mistakes. A bad reference stays empty, its scene is an
 * ERROR. */
static void read_references(struct judging *judging) {
    char list[DRAWN_PATH_LIMIT];
    snprintf(list, sizeof list, "%s/%s/looks/signs.txt", judging->options->looks,
             judging->step->name);
    mistakes_read(&judging->mistakes, list);
    for (size_t i = 0; i < judging->step->scene_count; i++) {
        looks_read(&judging->looks[i], &judging->mistakes, judging->options->looks,
                   judging->step->name, judging->step->items[i].scene);
        struct item_result *item = &judging->result->items[i];
        struct result_path path = reference_path(judging, item->scene);
        struct image *reference = &judging->references[i];
        struct error error;
        if (image_read(reference, path.text, &error) && image_is_blank(reference)) {
            error_set(&error, "%.900s: is blank", path.text);
            image_free(reference);
        }
        if (reference->pixels == NULL) {
            item->state = RESULT_ERROR;
            result_say(&item->message, "no reference: %s", drawn_message(error.message).text);
        }
    }
}

/* Judge scene i by the picture that the program has left. */
static enum drawn_state judge_scene(const struct judging *judging, size_t i) {
    struct item_result *item = &judging->result->items[i];
    const struct image *reference = &judging->references[i];
    struct image yours;
    struct error error;
    item->message.text[0] = '\0';
    enum drawn_state state =
        drawn_read(&yours, judging->directory.path, item->scene, reference, &error);
    if (state == DRAWN_READ) {
        judge_picture(judging, i, &yours);
    } else {
        result_say(&item->message, "%s", drawn_message(error.message).text);
    }
    if (item->exact) {
        drop_pictures(item);
    } else {
        keep_pictures(judging, item, reference, &yours);
    }
    image_free(&yours);
    return state;
}

/* Let the state and the text say how the program ended, when not well. */
static void judge_end(const struct judging *judging, enum result_state *state,
                      struct result_text *text, const struct run_result *end) {
    text->text[0] = '\0';
    if (is_fault(judging, end, text)) {
        *state = RESULT_CRASH;
        judging->result->sanitized = true;
    } else {
        *state = state_of_end(end);
        describe_end(text, end, &judging->limits);
    }
}

static void blame(const struct judging *judging, struct item_result *item,
                  const struct run_result *end) {
    item->blamed = true;
    item->divided = end->end == RUN_KILLED && end->number == SIGFPE;
    judge_end(judging, &item->state, &item->message, end);
}

/* The program ended badly before it had drawn this scene, and perhaps before it began it: let it
 * draw nothing else. */
static bool judge_alone(const struct judging *judging, size_t i, struct error *error) {
    const struct options *options = judging->options;
    struct item_result *item = &judging->result->items[i];
    struct run_result end;
    bool done = drawn_run(options->programs, judging->step->name, judging->directory.path,
                          item->scene, NULL, &judging->limits, &end, error);
    if (done && end.end != RUN_INTERRUPTED && judge_scene(judging, i) == DRAWN_MISSING &&
        !judging_ended_well(&end)) {
        blame(judging, item, &end);
    }
    bytes_free(&end.messages);
    return done;
}

/* After enough waits in vain: a tenth of the time, but at least a second. */
static struct run_limits hurried_limits(double seconds) {
    double tenth = seconds / 10 > 1 ? seconds / 10 : 1;
    return run_program_limits(tenth < seconds ? tenth : seconds);
}

static bool judge_pictures(const struct judging *judging, const struct run_result *end,
                           struct error *error) {
    const struct checked_step *step = judging->step;
    struct item_result *items = judging->result->items;
    struct judging alone = *judging;
    int stopped = end->end == RUN_OUT_OF_TIME; /* so many times; nobody waits long for each scene */
    bool done = true;
    for (size_t i = 0; i < step->scene_count && done; i++) {
        if (items[i].state == RESULT_ERROR) {
            judging->result->state = RESULT_ERROR;
        } else if (judge_scene(judging, i) == DRAWN_MISSING && !judging_ended_well(end)) {
            if (step->scene_count > 1) {
                if (stopped >= TIMEOUT_LIMIT) {
                    alone.limits = hurried_limits(judging->limits.seconds);
                }
                done = judge_alone(&alone, i, error);
                stopped += items[i].state == RESULT_TIME;
            } else {
                blame(judging, &items[i], end);
            }
        }
    }
    return done;
}

/* ---- Work ---- */

/* The number in the last line "SCENE.COUNTER: NUMBER" of a text; false when there is none. */
static bool find_counter(const char *text, const struct item_result *item, uint64_t *number) {
    char start[2 * SCENE_NAME_LIMIT + 8];
    snprintf(start, sizeof start, "%s.%s: ", item->scene, item->counter);
    bool found = false;
    for (; *text != '\0'; text += strcspn(text, "\n"), text += *text == '\n') {
        if (strncmp(text, start, strlen(start)) == 0) {
            *number = strtoull(text + strlen(start), NULL, 10);
            found = true;
        }
    }
    return found;
}

/* "pixels written" for "pixels_written". */
static struct result_text counter_words(const char *counter) {
    struct result_text words = {""};
    result_say(&words, "%s", counter);
    for (char *blank = words.text; (blank = strchr(blank, '_')) != NULL;) {
        *blank = ' ';
    }
    return words;
}

/* What is wrong with a count, if anything is. A number that wraps round was below 0. */
static void say_count(struct item_result *item) {
    const struct count_text counted = show_count(item->counted), most = show_count(item->most);
    const struct result_text words = counter_words(item->counter);
    if (item->counted > INT64_MAX) {
        result_say(&item->message, "-%s %s, but a count is never below 0",
                   show_count(0 - item->counted).text, words.text);
    } else if (item->most == item->least && item->counted != item->most) {
        result_say(&item->message, "%s %s, but %s are right", counted.text, words.text, most.text);
    } else if (item->counted > item->most) {
        result_say(&item->message, "%s %s, but %s are enough", counted.text, words.text, most.text);
    } else if (item->counted < item->least) {
        result_say(&item->message, "%s %s, but it must count %s or more", counted.text, words.text,
                   show_count(item->least).text);
    }
}

/* Judge a counter by what the program has printed. */
static void judge_counter(const struct judging *judging, struct item_result *item,
                          const char *output, const struct run_result *end) {
    bool found = find_counter(output, item, &item->counted);
    if (!judging_ended_well(end)) {
        blame(judging, item, end);
    } else if (!found) {
        result_say(&item->message, "--stats does not print it");
    } else {
        say_count(item);
        item->state = item->message.text[0] == '\0' ? RESULT_PASS : item->state;
    }
}

/* Let the program draw a scene once more, "" for all, and count: `output` becomes what it prints,
 * with a NUL at its end. The caller frees output, and end->messages. */
bool judging_count(const struct judging *judging, const char *scene, struct bytes *output,
                   struct run_result *end, struct error *error) {
    struct run_directory directory;
    char path[RUN_PATH_LIMIT + 8];
    struct error ignored;
    *output = (struct bytes){.data = NULL};
    *end = (struct run_result){.end = RUN_EXITED};
    if (!run_directory_create(&directory, error)) {
        return false;
    }
    snprintf(path, sizeof path, "%s/.stats", directory.path);
    bool done = drawn_run(judging->options->programs, judging->step->name, directory.path, scene,
                          path, &judging->limits, end, error);
    if (done && !file_read(path, output, &ignored)) {
        bytes_free(output); /* it has made something else of the file */
    }
    run_directory_remove(directory.path);
    return done && (bytes_append(output, "", 1) || error_out_of_memory(error));
}

static bool judge_work(const struct judging *judging, struct item_result *item,
                       struct error *error) {
    struct bytes output;
    struct run_result end;
    bool done = judging_count(judging, item->scene, &output, &end, error);
    if (done && end.end != RUN_INTERRUPTED) {
        judge_counter(judging, item, (const char *)output.data, &end);
    }
    bytes_free(&output);
    bytes_free(&end.messages);
    return done;
}

/* Let the program draw something new in two ways that must give the same picture. The first
 * relation that does not hold is reported. */
static bool judge_relations(const struct judging *judging, struct item_result *item,
                            struct error *error) {
    for (int i = 0; i < RELATION_COUNT; i++) {
        struct relation_result tried;
        if (!item->rule->relations[i]) {
            continue;
        }
        if (!relation_try(judging->options->programs, judging->step->name, item->scene,
                          (enum relation)i, &judging->limits, &tried, error)) {
            return false;
        }
        if (!tried.drawn || !share_within(tried.differing, tried.drawn_pixels, item->rule->limit)) {
            result_say(&item->message, "%s", tried.text);
            return true;
        }
    }
    item->state = RESULT_PASS;
    return true;
}

/* Little work is no merit where the picture is wrong. */
static bool judge_works(const struct judging *judging, struct error *error) {
    struct step_result *result = judging->result;
    bool done = true;
    for (size_t i = judging->step->scene_count; i < result->item_count && done; i++) {
        struct item_result *item = &result->items[i];
        if (item->kind == ITEM_NUMBERS) {
            continue;
        }
        const struct item_result *picture = result_picture_of(result, item);
        if (picture->state == RESULT_PASS) {
            done = item->rule->kind == ITEM_RELATIONS ? judge_relations(judging, item, error)
                                                      : judge_work(judging, item, error);
        } else {
            item->state = picture->state;
            item->unjudged = true;
            result_say(&item->message, "its picture must pass before this is judged");
        }
    }
    return done;
}

/* ---- One step ---- */

/* Something is not drawn: could it have been? What the program has left is gone, so a disk that it
 * has filled itself has room again. */
static bool had_room(const struct judging *judging, struct error *error) {
    const struct step_result *result = judging->result;
    size_t bytes = 0;
    bool is_missing = false;
    for (size_t i = 0; i < result->item_count; i++) {
        const struct item_result *item = &result->items[i];
        is_missing |= item->state != RESULT_PASS && !item->compared;
    }
    for (size_t i = 0; i < judging->step->scene_count; i++) {
        const struct image *reference = &judging->references[i];
        bytes += (size_t)4 * reference->width * reference->height + FILE_EXTRA;
    }
    return !is_missing || run_has_room(run_temporary(), bytes, error);
}

/* Does a function never return that a program will call for its pictures, too? */
static bool has_endless_numbers(const struct step_result *result) {
    bool found = false;
    for (size_t i = 0; i < result->item_count; i++) {
        found |= result->items[i].kind == ITEM_NUMBERS && result->items[i].state == RESULT_TIME;
    }
    return found;
}

static bool draw_and_judge(struct judging *judging, struct error *error) {
    const struct options *options = judging->options;
    struct step_result *result = judging->result;
    struct run_result end;
    if (!run_directory_create(&judging->directory, error)) {
        return false;
    }
    bool done = drawn_run(options->programs, judging->step->name, judging->directory.path,
                          options->only, NULL, &judging->limits, &end, error);
    if (done && end.end != RUN_INTERRUPTED) {
        judge_end(judging, &result->state, &result->reason, &end);
        done = judge_pictures(judging, &end, error) && judge_works(judging, error);
        diagnose_to_do(judging);
        done = done && diagnose_mistakes(judging, error);
    }
    result->messages = end.messages;
    run_directory_remove(judging->directory.path);
    return done && had_room(judging, error);
}

/* A step that cannot be built; a missing reference is still reported. */
static void set_not_built(const struct judging *judging, const struct message_line *reason) {
    struct step_result *result = judging->result;
    result->state = RESULT_BUILD;
    result_say(&result->reason, "%s", reason->text);
    for (size_t i = 0; i < result->item_count; i++) {
        if (result->items[i].state != RESULT_ERROR) {
            result->items[i].state = RESULT_BUILD;
        }
    }
}

static bool has_numbers(const struct step_result *result) {
    bool found = false;
    for (size_t i = 0; i < result->item_count; i++) {
        found |= result->items[i].kind == ITEM_NUMBERS;
    }
    return found;
}

static bool build_and_judge(struct judging *judging, struct error *error) {
    struct step_result *result = judging->result;
    struct build_result built;
    result->sanitized = judging->options->sanitized;
    remove_old_pictures(judging);
    read_references(judging);
    if (judging->source.size > SOURCE_LIMIT) {
        struct message_line reason;
        snprintf(reason.text, sizeof reason.text, "main.c has %zu bytes; at most %d are judged",
                 judging->source.size, SOURCE_LIMIT);
        set_not_built(judging, &reason);
        return true;
    }
    bool done =
        build_step(judging->options, judging->step->name, has_numbers(result), &built, error);
    if (done && built.reason.text[0] != '\0') {
        result->messages = built.messages;
        result->build_stopped = built.stopped;
        set_not_built(judging, &built.reason);
        return true;
    }
    result_say(&result->warning, "%s", built.warning.text);
    result->more_warnings = built.more_warnings;
    bytes_free(&built.messages);
    done = done && numbers_judge(judging->options, judging->step,
                                 (const char *)judging->source.data, result, error);
    if (has_endless_numbers(result)) {
        judging->limits = hurried_limits(judging->options->seconds);
    }
    if (judging->step->scene_count == 0) {
        diagnose_to_do(judging);
        return done;
    }
    return done && draw_and_judge(judging, error);
}

static void set_error(struct step_result *result, const struct error *error) {
    result->state = RESULT_ERROR;
    result->reason.text[0] = '\0';
    result_say(&result->reason, "%s", error->message);
    for (size_t i = 0; i < result->item_count; i++) {
        struct item_result *item = &result->items[i];
        drop_pictures(item);
        item->state = RESULT_ERROR;
        item->exact = item->blamed = false;
        item->message.text[0] = item->looks.text[0] = '\0';
    }
}

void judge_step(const struct options *options, const struct checked_step *step,
                struct step_result *result) {
    struct error error = {.message = "out of memory"};
    struct judging judging = {
        .options = options,
        .step = step,
        .result = result,
        .references = calloc(step->scene_count + 1, sizeof *judging.references),
        .looks = calloc(step->scene_count + 1, sizeof *judging.looks),
        .limits = run_program_limits(options->seconds),
    };
    char path[DRAWN_PATH_LIMIT];
    snprintf(path, sizeof path, "%s/%s/main.c", options->sources, step->name);
    judging.source = todo_read(path);
    if (!step_result_begin(result, step, &error) || judging.references == NULL ||
        judging.looks == NULL || !build_and_judge(&judging, &error)) {
        set_error(result, &error);
    }
    step_result_finish(result);
    diagnose_waiting(&judging);
    bool has_lists = judging.references != NULL && judging.looks != NULL;
    for (size_t i = 0; has_lists && i < step->scene_count; i++) {
        image_free(&judging.references[i]);
        looks_free(&judging.looks[i]);
    }
    mistakes_free(&judging.mistakes);
    free(judging.looks);
    free(judging.references);
    bytes_free(&judging.source);
}
