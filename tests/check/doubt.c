#include "doubt.h"

#include "todo.h"

#include <string.h>

static bool is_same(const struct look *a, const struct look *b) {
    return strcmp(a->words, b->words) == 0 && strcmp(a->task.text, b->task.text) == 0;
}

/* Are pixels of that scene apart in a program with this mistake? */
static bool shows_mistake(const struct looks *scene, const struct look *mistake) {
    bool found = false;
    for (size_t i = 0; i < scene->count; i++) {
        found |= scene->list[i].apart > 0 && is_same(&scene->list[i], mistake);
    }
    return found;
}

/* Is the scene wrong in another way than the mistake makes it, if it makes it wrong at all? (What a
 * mistake draws that draws nothing is not kept.) */
static bool is_wrong_otherwise(const struct item_result *item, const struct looks *scene,
                               const struct look *mistake) {
    bool found = false, is_apart = item->shares.apart.count > 0 && !item->blank;
    for (size_t i = 0; i < scene->count && scene->explains != NULL; i++) {
        const struct look *look = &scene->list[i];
        bool otherwise = look->row > 0 ? !scene->explains[look->row] : look->apart == 0 && is_apart;
        found |= is_same(look, mistake) && otherwise;
    }
    return found;
}

static bool is_right_where_shown(const struct suspicion *suspicion, const struct look *mistake) {
    bool found = false;
    for (size_t i = 0; i < suspicion->scene_count; i++) {
        found |= suspicion->result->items[i].exact && shows_mistake(&suspicion->looks[i], mistake);
    }
    return found;
}

static bool is_contradicted(const struct suspicion *suspicion, const struct look *mistake) {
    bool found = false;
    for (size_t i = 0; i < suspicion->scene_count; i++) {
        const struct item_result *other = &suspicion->result->items[i];
        found |= other->state == RESULT_FAIL &&
                 credit_covers(suspicion->item->credit, other->credit) &&
                 is_wrong_otherwise(other, &suspicion->looks[i], mistake);
    }
    return found;
}

enum looks_doubt doubt_find(const void *context, const struct look *mistake) {
    const struct suspicion *suspicion = context;
    const char *task = mistake->task.text;
    if (is_right_where_shown(suspicion, mistake)) {
        return LOOKS_IMPOSSIBLE;
    }
    if (is_contradicted(suspicion, mistake)) {
        return LOOKS_DOUBTFUL;
    }
    return result_is_right(suspicion->result, task) || todo_has_task(suspicion->source, task)
               ? LOOKS_UNLIKELY
               : LOOKS_LIKELY;
}
