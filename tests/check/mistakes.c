/* The known mistakes of a lesson: see mistakes.h. */
#include "mistakes.h"

#include "base/array.h"
#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Reading ---- */

/* Cut the next word off the line; what is behind the blank is left. NULL when there is none. */
static char *cut_word(char **line) {
    char *word = *line, *blank = strchr(word, ' ');
    if (blank == NULL || blank == word) {
        return NULL;
    }
    *blank = '\0';
    *line = blank + 1;
    return word;
}

/* "5.2 4 zbuffer:2:5234;depth:3:10 depth cleared to 0" */
static bool read_mistake(struct mistake *mistake, char *line) {
    const char *task = cut_word(&line);
    const char *figure = task != NULL ? cut_word(&line) : NULL;
    const char *signs = figure != NULL ? cut_word(&line) : NULL;
    int end = 0;
    if (signs == NULL || line[0] == '\0' || strlen(task) >= sizeof mistake->task.text ||
        sscanf(figure, "%4u%n", &mistake->figure, &end) != 1 || figure[end] != '\0') {
        return false;
    }
    strcpy(mistake->task.text, strcmp(task, "-") == 0 ? "" : task);
    mistake->signs = signs;
    mistake->words = line;
    return true;
}

static bool add_mistake(struct mistake_list *mistakes, const struct mistake *mistake) {
    if (!array_extend(&mistakes->list, &mistakes->capacity, mistakes->count + 1, sizeof *mistake)) {
        return false;
    }
    mistakes->list[mistakes->count++] = *mistake;
    return true;
}

bool mistakes_read(struct mistake_list *mistakes, const char *path) {
    struct error ignored;
    struct mistake mistake;
    *mistakes = (struct mistake_list){.count = 0};
    bool done = file_read(path, &mistakes->text, &ignored) && bytes_append(&mistakes->text, "", 1);
    for (char *line = (char *)mistakes->text.data, *next; done && *line != '\0'; line = next) {
        size_t length = strcspn(line, "\n");
        next = line + length + (line[length] == '\n');
        line[length] = '\0';
        done = line[0] == '#' || (read_mistake(&mistake, line) && add_mistake(mistakes, &mistake));
    }
    if (!done) {
        mistakes_free(mistakes);
    }
    return done;
}

void mistakes_free(struct mistake_list *mistakes) {
    free(mistakes->list);
    bytes_free(&mistakes->text);
    *mistakes = (struct mistake_list){.count = 0};
}

const char *mistake_next_sign(const char *sign) {
    sign = strchr(sign, ';');
    return sign != NULL ? sign + 1 : NULL;
}

/* ---- Telling ---- */

bool mistake_set_add(struct mistake_set *set, const struct mistake *mistake) {
    bool has_room = set->count < LOOKS_NAME_LIMIT;
    if (has_room) {
        set->list[set->count++] = mistake;
    }
    return has_room;
}

/* Note the task at fault, "" for none's, once. */
static void add_task(struct item_result *item, const char *task) {
    if (task[0] != '\0' && !task_is_among(item->looks_tasks, item->looks_task_count, task)) {
        snprintf(item->looks_tasks[item->looks_task_count++].text, TASK_NAME_LIMIT, "%s", task);
    }
}

/* Note the figure that shows it, 0 for none, once. */
static void add_figure(struct item_result *item, unsigned figure) {
    bool is_new = figure > 0;
    for (size_t i = 0; i < item->looks_figure_count; i++) {
        is_new &= item->looks_figures[i] != figure;
    }
    if (is_new) {
        item->looks_figures[item->looks_figure_count++] = figure;
    }
}

void mistakes_tell(struct item_result *item, const struct mistake_set *set) {
    enum mistake_doubt least = MISTAKE_IMPOSSIBLE;
    for (size_t i = 0; i < set->count; i++) {
        least = set->doubts[i] < least ? set->doubts[i] : least;
    }
    for (size_t i = 0; i < set->count && least < MISTAKE_IMPOSSIBLE; i++) {
        if (set->doubts[i] == least) {
            result_say(&item->looks, "%s\"%s\"", item->looks.text[0] != '\0' ? " or " : "",
                       set->list[i]->words);
            add_task(item, set->list[i]->task.text);
            add_figure(item, set->list[i]->figure);
        }
    }
    item->only_may_be |= least == MISTAKE_DOUBTFUL;
}
