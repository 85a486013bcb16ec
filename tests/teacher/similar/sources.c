/* The C files of a lesson: see sources.h. */
#define _POSIX_C_SOURCE 200809L

#include "sources.h"

#include "base/array.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* ---- Names in a directory ---- */

typedef bool name_test(const char *name);

static bool names_add(struct names *names, const char *name) {
    char **all = array_reserve(names->all, &names->capacity, names->count + 1, sizeof *all);
    if (all == NULL) {
        return false;
    }
    names->all = all;
    all[names->count] = string_format("%s", name);
    return all[names->count++] != NULL;
}

/* main.c comes first. */
static int compare_names(const void *a, const void *b) {
    const char *first = *(char *const *)a, *second = *(char *const *)b;
    int difference = (strcmp(second, "main.c") == 0) - (strcmp(first, "main.c") == 0);
    return difference != 0 ? difference : strcmp(first, second);
}

/* All names in the directory that pass the test, sorted. */
static bool list_names(struct names *names, const char *path, name_test *wanted,
                       struct error *error) {
    DIR *directory = opendir(path);
    if (directory == NULL) {
        error_set(error, "%s", strerror(errno));
        return error_name_file(error, path);
    }
    bool done = true;
    for (struct dirent *entry; done && (entry = readdir(directory)) != NULL;) {
        done = !wanted(entry->d_name) || names_add(names, entry->d_name);
    }
    closedir(directory);
    if (!done) {
        return error_out_of_memory(error);
    }
    if (names->count > 0) {
        qsort(names->all, names->count, sizeof *names->all, compare_names);
    }
    return true;
}

void names_free(struct names *names) {
    for (size_t i = 0; i < names->count; i++) {
        free(names->all[i]);
    }
    free(names->all);
    *names = (struct names){0};
}

static bool is_lesson(const char *name) {
    return strncmp(name, "step", 4) == 0 && isdigit((unsigned char)name[4]);
}

bool sources_list_lessons(struct names *names, const char *directory, struct error *error) {
    *names = (struct names){0};
    bool done = list_names(names, directory, is_lesson, error);
    if (!done) {
        names_free(names);
    }
    return done;
}

/* ---- The files of a lesson ---- */

static bool is_source(const char *name) {
    const char *end = strrchr(name, '.');
    return end != NULL && (strcmp(end, ".c") == 0 || strcmp(end, ".h") == 0);
}

static size_t count_lines(const struct bytes *text) {
    size_t count = 1;
    for (size_t i = 0; i < text->size; i++) {
        count += text->data[i] == '\n';
    }
    return count;
}

static bool too_large(size_t size_limit, struct error *error) {
    return error_set(error, "more than %d files or %zu KiB of C", SOURCES_FILE_LIMIT,
                     size_limit / 1024);
}

/* Append what was read of a file, whose name is copied. */
static bool append(struct sources *sources, struct source source, struct error *error) {
    struct source *files =
        array_reserve(sources->files, &sources->capacity, sources->count + 1, sizeof *files);
    if (files == NULL) {
        bytes_free(&source.text);
        return error_out_of_memory(error);
    }
    source.name = string_format("%s", source.name);
    source.first_line = sources->line_count + 1;
    source.line_count = count_lines(&source.text);
    sources->files = files;
    sources->files[sources->count++] = source;
    sources->size += source.text.size;
    sources->line_count += source.line_count;
    return source.name != NULL || error_out_of_memory(error);
}

/* Add the file; one that is no plain file is passed over, but for main.c. */
static bool add_file(struct sources *sources, const char *path, char *name, size_t size_limit,
                     struct error *error) {
    struct stat status;
    struct source source = {.name = name};
    if (lstat(path, &status) != 0 || !S_ISREG(status.st_mode)) {
        return strcmp(name, "main.c") != 0 || error_set(error, "main.c is not a plain file");
    }
    if (sources->count == SOURCES_FILE_LIMIT ||
        (uint64_t)status.st_size > size_limit - sources->size) {
        return too_large(size_limit, error);
    }
    return file_read(path, &source.text, error) && append(sources, source, error) &&
           (sources->size <= size_limit || too_large(size_limit, error)); /* has it grown? */
}

static bool add_files(struct sources *sources, const char *directory, const struct names *names,
                      size_t size_limit, struct error *error) {
    for (size_t i = 0; i < names->count; i++) {
        char *path = string_format("%s/%s", directory, names->all[i]);
        bool done = path != NULL ? add_file(sources, path, names->all[i], size_limit, error)
                                 : error_out_of_memory(error);
        free(path);
        if (!done) {
            return error_name_file(error, directory);
        }
    }
    return true;
}

bool sources_read(struct sources *sources, const char *directory, size_t size_limit,
                  struct error *error) {
    struct names names = {0};
    struct stat status;
    *sources = (struct sources){0};
    if (lstat(directory, &status) != 0) {
        error_set(error, "%s", strerror(errno));
        return errno == ENOENT || error_name_file(error, directory);
    }
    if (!S_ISDIR(status.st_mode)) {
        error_set(error, "is not a plain directory");
        return error_name_file(error, directory);
    }
    bool done = list_names(&names, directory, is_source, error) &&
                add_files(sources, directory, &names, size_limit, error);
    names_free(&names);
    if (!done) {
        sources_free(sources);
    }
    return done;
}

void sources_free(struct sources *sources) {
    for (size_t i = 0; i < sources->count; i++) {
        free(sources->files[i].name);
        bytes_free(&sources->files[i].text);
    }
    free(sources->files);
    *sources = (struct sources){0};
}
