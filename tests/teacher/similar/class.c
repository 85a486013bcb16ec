/* The submissions of a class: see class.h. */
#include "class.h"

#include <stdlib.h>

static bool give_file(struct class *class, const struct source *file) {
    struct tokens tokens = {0};
    bool done = tokens_append(&tokens, file->text.data, file->text.size, 1) &&
                fingerprints_give(&class->given, &tokens);
    tokens_free(&tokens);
    return done;
}

static bool give_directory(struct class *class, const char *starters, const char *name,
                           struct error *error) {
    struct sources sources = {0};
    char *path = string_format("%s/%s", starters, name);
    bool done = path != NULL ? sources_read(&sources, path, GIVEN_SIZE_LIMIT, error)
                             : error_out_of_memory(error);
    for (size_t i = 0; i < sources.count && done; i++) {
        done = give_file(class, &sources.files[i]) || error_out_of_memory(error);
    }
    sources_free(&sources);
    free(path);
    return done;
}

bool class_read_given(struct class *class, const char *starters, struct error *error) {
    if (!sources_list_lessons(&class->lessons, starters, error)) {
        return false;
    }
    if (class->lessons.count == 0) {
        error_set(error, "has no lesson, like step05_zbuffer/main.c");
        return error_name_file(error, starters);
    }
    bool done = give_directory(class, starters, "common", error);
    for (size_t i = 0; i < class->lessons.count && done; i++) {
        done = give_directory(class, starters, class->lessons.all[i], error);
    }
    set_sort(&class->given);
    return done;
}

static bool choose_from(const struct class *class, const struct sources *sources,
                        struct fingerprints *chosen) {
    struct tokens tokens = {0};
    bool done = true;
    for (size_t i = 0; i < sources->count && done; i++) {
        const struct source *file = &sources->files[i];
        done = tokens_append(&tokens, file->text.data, file->text.size, file->first_line);
    }
    done = done && fingerprints_choose(chosen, &tokens, &class->given);
    tokens_free(&tokens);
    return done;
}

/* "anna: step05_zbuffer: main.c is not a plain file" */
static bool add_note(struct class *class, const char *name, const char *message) {
    char *note = string_format("%s: %s", name, message);
    if (note == NULL) {
        return false;
    }
    text_make_printable(note, '?');
    bool done = bytes_print(&class->notes, "%s\n", note);
    free(note);
    return done;
}

/* A lesson that cannot be read is noted and has no fingerprints. */
static bool read_lesson(struct class *class, struct submission *submission, size_t lesson) {
    struct sources sources = {0};
    struct error error;
    char *path = string_format("%s/%s", submission->path, class->lessons.all[lesson]);
    bool done = path != NULL;
    if (done && !sources_read(&sources, path, LESSON_SIZE_LIMIT, &error)) {
        done = add_note(class, submission->name, error.message);
        submission->has_files = true;
    }
    done = done && choose_from(class, &sources, &submission->lessons[lesson]);
    submission->has_files = submission->has_files || sources.count > 0;
    sources_free(&sources);
    free(path);
    return done;
}

static bool read_submission(struct class *class, struct submission *submission) {
    submission->lessons = calloc(class->lessons.count, sizeof *submission->lessons);
    bool done = submission->lessons != NULL;
    for (size_t lesson = 0; lesson < class->lessons.count && done; lesson++) {
        done = read_lesson(class, submission, lesson);
    }
    return done && (submission->has_files ||
                    add_note(class, submission->name, "has no lesson, like step05_zbuffer/main.c"));
}

bool class_read(struct class *class) {
    for (size_t i = 0; i < class->submission_count; i++) {
        if (!read_submission(class, &class->submissions[i])) {
            return false;
        }
    }
    return true;
}

void class_free(struct class *class) {
    for (size_t i = 0; i < class->submission_count; i++) {
        struct fingerprints *lessons = class->submissions[i].lessons;
        for (size_t lesson = 0; lesson < class->lessons.count && lessons != NULL; lesson++) {
            fingerprints_free(&lessons[lesson]);
        }
        free(lessons);
    }
    free(class->submissions);
    names_free(&class->lessons);
    set_free(&class->given);
    bytes_free(&class->notes);
    *class = (struct class){0};
}
