/* Mistakes that no picture shows: see counters.h. */
#include "counters.h"

#include <stdio.h>
#include <string.h>

/* ---- What a program shows ---- */

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

/* The letters of all pictures; x is one that is wrong in another way. */
static void list_pictures(char *letters, size_t size, const struct step_result *result) {
    size_t count = 0;
    for (size_t i = 0; i < result->item_count && result->items[i].kind == ITEM_PICTURE; i++) {
        if (count + 1 < size) {
            letters[count++] = letter_of(&result->items[i]);
        }
    }
    letters[count] = '\0';
}

/* Add "pixels_tested: 5" as pixels_tested=5. False where it is something else, or too long. */
static bool add_counter(struct counted *counted, const char *line, size_t length) {
    size_t name = strspn(line, "abcdefghijklmnopqrstuvwxyz0123456789_");
    size_t digits = strncmp(line + name, ": ", 2) == 0 ? strspn(line + name + 2, "0123456789") : 0;
    size_t used = strlen(counted->text), room = sizeof counted->text - used;
    if (name == 0 || digits == 0 || name + 2 + digits != length || length > room) {
        return false;
    }
    int written = snprintf(counted->text + used, room, "%s%.*s=%.*s",
                           counted->text[used - 1] == ':' ? "" : ",", (int)name, line, (int)digits,
                           line + name + 2);
    return (size_t)written < room;
}

/* Add everything counted in the scene. False where nothing is, or it cannot be found out. */
static bool add_counters(struct counted *counted, const char *output, const char *scene) {
    const size_t prefix = strlen(scene);
    for (size_t length; *output != '\0'; output += length + (output[length] == '\n')) {
        length = strcspn(output, "\n");
        bool is_scene = strncmp(output, scene, prefix) == 0 && output[prefix] == '.';
        if (is_scene && !add_counter(counted, output + prefix + 1, length - prefix - 1)) {
            return false;
        }
    }
    return counted->text[strlen(counted->text) - 1] != ':';
}

bool counted_of(struct counted *counted, const struct step_result *result,
                const struct item_result *item, const char *output) {
    enum { PICTURE_LIMIT = 256 };
    char pictures[PICTURE_LIMIT];
    bool is_counter = item->kind != ITEM_PICTURE;
    list_pictures(pictures, sizeof pictures, result);
    snprintf(counted->text, sizeof counted->text, "%s:%s:%s", item->scene,
             is_counter ? "-" : pictures, is_counter ? "" : "-");
    return strpbrk(pictures, is_counter ? "xbd" : "x?") == NULL &&
           (!is_counter || add_counters(counted, output, item->scene));
}

/* ---- Comparing ---- */

static bool shows(const struct mistake *mistake, const char *yours) {
    const size_t length = strlen(yours);
    const char *sign = strcmp(mistake->words, MISTAKE_STARTER) != 0 ? mistake->signs : NULL;
    while (sign != NULL &&
           (strncmp(sign, yours, length) != 0 || (sign[length] != '\0' && sign[length] != ';'))) {
        sign = mistake_next_sign(sign);
    }
    return sign != NULL;
}

struct mistake_set counted_find(const struct mistake_list *mistakes, const struct counted *yours) {
    struct mistake_set set = {.count = 0};
    for (size_t k = 0; k < mistakes->count; k++) {
        if (shows(&mistakes->list[k], yours->text) && !mistake_set_add(&set, &mistakes->list[k])) {
            return (struct mistake_set){.count = 0};
        }
    }
    return set;
}
