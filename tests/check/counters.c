/* Mistakes that no picture tells: see counters.h. */
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
    for (size_t i = 0; i < result->item_count && result->items[i].counter[0] == '\0'; i++) {
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
    counted->tells |= line[name + 2] != '0';
    int written = snprintf(counted->text + used, room, "%s%.*s=%.*s",
                           counted->text[used - 1] == ':' ? "" : ",", (int)name, line, (int)digits,
                           line + name + 2);
    return (size_t)written < room;
}

/* Add all that is counted in the scene, "-" for nothing. False where it cannot be told. */
static bool add_counters(struct counted *counted, const char *output, const char *scene) {
    const size_t prefix = strlen(scene);
    for (size_t length; *output != '\0'; output += length + (output[length] == '\n')) {
        length = strcspn(output, "\n");
        bool is_scene = strncmp(output, scene, prefix) == 0 && output[prefix] == '.';
        if (is_scene && !add_counter(counted, output + prefix + 1, length - prefix - 1)) {
            return false;
        }
    }
    size_t used = strlen(counted->text);
    if (counted->text[used - 1] == ':' && used + 1 < sizeof counted->text) {
        strcat(counted->text, "-");
    }
    return true;
}

bool counted_of(struct counted *counted, const struct step_result *result,
                const struct item_result *item, const char *output) {
    enum { PICTURE_LIMIT = 256 };
    char pictures[PICTURE_LIMIT];
    bool is_counter = item->counter[0] != '\0';
    list_pictures(pictures, sizeof pictures, result);
    if (strchr(pictures, 'x') != NULL || (is_counter && strpbrk(pictures, "bd") != NULL)) {
        return false;
    }
    counted->tells = false;
    snprintf(counted->text, sizeof counted->text, "%s:%s:", item->scene,
             is_counter ? "-" : pictures);
    if (!add_counters(counted, output, item->scene)) {
        return false;
    }
    counted->tells |=
        is_counter || (strchr(pictures, '?') == NULL && strchr(pictures, 'r') != NULL);
    return !is_counter || strchr(counted->text, '=') != NULL;
}

bool counted_tells(const struct counted *yours, size_t count) {
    bool tells = false;
    for (size_t i = 0; i < count; i++) {
        tells |= yours[i].tells;
    }
    return tells;
}

/* ---- Comparing ---- */

/* Is it this sign, except for what is to do? */
static bool is_sign(const char *sign, const char *yours) {
    size_t i = 0;
    while (yours[i] != '\0' && sign[i] != '\0' && (yours[i] == sign[i] || yours[i] == '?')) {
        i++;
    }
    return yours[i] == '\0' && (sign[i] == '\0' || sign[i] == ';');
}

static bool shows(const struct mistake *mistake, const char *yours) {
    const char *sign = mistake->signs;
    while (sign != NULL && !is_sign(sign, yours)) {
        sign = mistake_next_sign(sign);
    }
    return sign != NULL;
}

struct mistake_set counted_find(const struct mistake_list *mistakes, const struct counted *yours,
                                size_t count) {
    const struct mistake_set none = {.count = 0};
    struct mistake_set set = none;
    for (size_t k = 0; k < mistakes->count; k++) {
        const struct mistake *mistake = &mistakes->list[k];
        bool shows_all = true;
        for (size_t i = 0; i < count; i++) {
            shows_all &= shows(mistake, yours[i].text);
        }
        if (shows_all && !mistake_set_add(&set, mistake)) {
            return none;
        }
    }
    return set;
}
