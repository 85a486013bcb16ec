#include "counters.h"

#include "base/array.h"
#include "base/bytes.h"
#include "base/error.h"
#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Reading ---- */

static bool is_known_pictures(const struct counters_pictures *pictures) {
    return strcmp(pictures->text, "-") == 0 ||
           strspn(pictures->text, "rbd") == strlen(pictures->text);
}

/* Take the next word of a line, up to a blank. False when there is none, or no room for it. */
static bool take_word(const char **line, const char *end, char *word, size_t size) {
    const char *start = *line;
    while (*line < end && **line != ' ') {
        (*line)++;
    }
    size_t length = (size_t)(*line - start);
    if (length == 0 || length >= size) {
        return false;
    }
    memcpy(word, start, length);
    word[length] = '\0';
    *line += *line < end;
    return true;
}

/* "4" is 4. False when it is no such number. */
static bool read_figure(const char *word, unsigned *figure) {
    int end = 0;
    bool is_number = strspn(word, "0123456789") == strlen(word);
    return is_number && sscanf(word, "%4u%n", figure, &end) == 1 && word[end] == '\0';
}

/* "zbuffer - pixels_tested=5 5.2 4 words": a line of the list. */
static bool read_counted(struct counted_list *list, const char *line, const char *end) {
    struct counted counted = {.scene = ""};
    char figure[8];
    struct look *look = &counted.look;
    if (!take_word(&line, end, counted.scene, sizeof counted.scene) ||
        !take_word(&line, end, counted.pictures.text, sizeof counted.pictures.text) ||
        !take_word(&line, end, counted.counters.text, sizeof counted.counters.text) ||
        !take_word(&line, end, look->task.text, sizeof look->task.text) ||
        !take_word(&line, end, figure, sizeof figure) || !read_figure(figure, &look->figure) ||
        line == end || !is_known_pictures(&counted.pictures)) {
        return false;
    }
    if (strcmp(look->task.text, "-") == 0) {
        look->task.text[0] = '\0';
    }
    look->row = 1;
    snprintf(look->words, sizeof look->words, "%.*s", (int)(end - line), line);
    struct counted *grown =
        array_reserve(list->list, &list->capacity, list->count + 1, sizeof *grown);
    if (grown == NULL) {
        return false;
    }
    list->list = grown;
    grown[list->count++] = counted;
    return true;
}

void counted_read(struct counted_list *list, const char *directory, const char *step) {
    char path[DRAWN_PATH_LIMIT];
    struct bytes file = {.data = NULL};
    struct error ignored;
    *list = (struct counted_list){.count = 0};
    snprintf(path, sizeof path, "%s/%s/counters.list", directory, step);
    bool done = file_read(path, &file, &ignored) && bytes_append(&file, "", 1);
    for (const char *line = (const char *)file.data; done && *line != '\0';) {
        const char *end = line + strcspn(line, "\n");
        done = line[0] == '#' || read_counted(list, line, end);
        line = end + (*end == '\n');
    }
    bytes_free(&file);
    if (!done) {
        counted_free(list);
    }
}

void counted_free(struct counted_list *list) {
    free(list->list);
    *list = (struct counted_list){.count = 0};
}

/* ---- What a program shows ---- */

/* Add "pixels_tested: 5" as pixels_tested=5. False where it is something else, or too long. */
static bool add_counter(struct counters *counters, const char *line, size_t length) {
    const char *const name_bytes = "abcdefghijklmnopqrstuvwxyz0123456789_";
    size_t name = strspn(line, name_bytes), used = strlen(counters->text);
    size_t digits = strncmp(line + name, ": ", 2) == 0 ? strspn(line + name + 2, "0123456789") : 0;
    if (name == 0 || digits == 0 || name + 2 + digits != length || length > COUNTERS_LIMIT) {
        return false;
    }
    size_t room = sizeof counters->text - used;
    int written = snprintf(counters->text + used, room, "%s%.*s=%.*s", used > 0 ? "," : "",
                           (int)name, line, (int)digits, line + name + 2);
    return written >= 0 && (size_t)written < room;
}

struct counters counters_of(const char *output, const char *scene) {
    const struct counters unclear = {""};
    struct counters counters = {""};
    const size_t prefix = strlen(scene);
    for (const char *line = output; *line != '\0';) {
        size_t length = strcspn(line, "\n");
        bool is_scene = strncmp(line, scene, prefix) == 0 && line[prefix] == '.';
        if (is_scene && !add_counter(&counters, line + prefix + 1, length - prefix - 1)) {
            return unclear;
        }
        line += length + (line[length] == '\n');
    }
    return counters.text[0] != '\0' ? counters : (struct counters){"-"};
}

static char letter_of(const struct item_result *item) {
    switch (item->state) {
    case RESULT_PASS:
        return 'r';
    case RESULT_TODO:
        return '?';
    case RESULT_FAIL:
        return (char)(item->blank ? 'b' : 'x');
    case RESULT_CRASH:
        return (char)(item->divided ? 'd' : 'x');
    default:
        return 'x';
    }
}

struct counters_pictures counters_pictures(const struct step_result *result) {
    struct counters_pictures pictures = {""};
    for (size_t i = 0; i < result->item_count && result->items[i].counter[0] == '\0'; i++) {
        if (i + 1 == sizeof pictures.text) {
            return (struct counters_pictures){"x"};
        }
        pictures.text[i] = letter_of(&result->items[i]);
    }
    return pictures;
}

/* Does it count something other than 0? */
static bool is_counted(const struct counters *counters) {
    for (const char *at = strchr(counters->text, '='); at != NULL; at = strchr(at + 1, '=')) {
        if (at[1] != '0') {
            return true;
        }
    }
    return false;
}

bool counted_of(struct counted *counted, const struct step_result *result,
                const struct item_result *item, const char *output) {
    *counted = (struct counted){.pictures = counters_pictures(result),
                                .counters = counters_of(output, item->scene)};
    snprintf(counted->scene, sizeof counted->scene, "%s", item->scene);
    bool is_clear = strchr(counted->pictures.text, 'x') == NULL;
    if (item->counter[0] != '\0') {
        is_clear &= strpbrk(counted->pictures.text, "bd") == NULL;
        counted->pictures = (struct counters_pictures){"-"};
        return is_clear && strchr(counted->counters.text, '=') != NULL;
    }
    return is_clear && counted->counters.text[0] != '\0';
}

bool counted_tells(const struct counted *yours, size_t count) {
    bool tells = false;
    for (size_t i = 0; i < count; i++) {
        const char *pictures = yours[i].pictures.text;
        tells |= strcmp(pictures, "-") == 0 || is_counted(&yours[i].counters) ||
                 (strchr(pictures, '?') == NULL && strchr(pictures, 'r') != NULL);
    }
    return tells;
}

/* ---- Comparing ---- */

/* Are yours those of the mistake, but for what is to do? */
static bool are_same_pictures(const char *mistake, const char *yours) {
    size_t i = 0;
    while (mistake[i] != '\0' && (yours[i] == mistake[i] || yours[i] == '?')) {
        i++;
    }
    return mistake[i] == '\0' && yours[i] == '\0';
}

static bool is_same(const struct counted *known, const struct counted *yours) {
    return strcmp(known->scene, yours->scene) == 0 &&
           strcmp(known->counters.text, yours->counters.text) == 0 &&
           are_same_pictures(known->pictures.text, yours->pictures.text);
}

/* Does this mistake show all that yours shows? */
static bool shows_all(const struct counted_list *list, const struct look *mistake,
                      const struct counted *yours, size_t count) {
    size_t same = 0;
    for (size_t i = 0; i < count; i++) {
        bool found = false;
        for (size_t k = 0; k < list->count && !found; k++) {
            const struct counted *known = &list->list[k];
            found = strcmp(known->look.words, mistake->words) == 0 &&
                    strcmp(known->look.task.text, mistake->task.text) == 0 &&
                    is_same(known, &yours[i]);
        }
        same += found;
    }
    return same == count;
}

size_t counted_find(const struct counted_list *list, const struct counted *yours, size_t count,
                    struct look found[LOOKS_NAME_LIMIT]) {
    size_t names = 0;
    for (size_t i = 0; i < list->count && count > 0; i++) {
        const struct counted *known = &list->list[i];
        if (is_same(known, &yours[0]) && shows_all(list, &known->look, yours, count)) {
            if (names == LOOKS_NAME_LIMIT) {
                return 0;
            }
            found[names++] = known->look;
        }
    }
    return names;
}
