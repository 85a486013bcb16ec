/* What speaks against a mistake: see doubt.h. */
#include "doubt.h"

#include "todo.h"

/* Where a mistake makes so many pixels wrong, other arithmetic leaves one of ten of them so. */
enum { MANY_APART = 100, LEFT_APART = 10 };

/* Is the scene right, which the mistake would have made wrong? */
static bool is_right_without(const struct item_result *item, const struct look *look) {
    bool passes = item->state == RESULT_PASS && look->apart >= MANY_APART;
    return (item->exact && look->apart > 0) ||
           (passes && item->shares.apart.count * LEFT_APART < look->apart);
}

/* Is the scene wrong in another way than the mistake makes it? (What a mistake draws that draws
 * nothing is not kept.) */
static bool is_wrong_otherwise(const struct item_result *item, const struct looks *scene,
                               const struct look *look) {
    if (scene->explains == NULL) {
        return false;
    }
    bool is_apart = item->shares.apart.count > 0 && !item->blank;
    return look->row > 0 ? !scene->explains[look->row] : look->apart == 0 && is_apart;
}

enum mistake_doubt doubt_find(const struct suspicion *suspicion, const struct mistake *mistake) {
    const struct step_result *result = suspicion->result;
    const char *task = mistake->task.text;
    bool is_doubtful = false;
    if (task[0] != '\0' && result_numbers_blame_others(result, suspicion->item, task)) {
        return MISTAKE_IMPOSSIBLE;
    }
    for (size_t i = 0; i < suspicion->scene_count; i++) {
        const struct item_result *other = &result->items[i];
        const struct looks *scene = &suspicion->looks[i];
        if (scene->list == NULL) {
            continue;
        }
        const struct look *look = &scene->list[mistake - scene->mistakes->list];
        if (is_right_without(other, look)) {
            return MISTAKE_IMPOSSIBLE;
        }
        is_doubtful |= other->state == RESULT_FAIL &&
                       credit_covers(suspicion->item->credit, other->credit) &&
                       is_wrong_otherwise(other, scene, look);
    }
    if ((is_doubtful || suspicion->item->only_may_be) && result_calls_are_right(result, task)) {
        return MISTAKE_IMPOSSIBLE;
    }
    return is_doubtful ? MISTAKE_DOUBTFUL
           : result_is_right(result, task) || todo_has_task(suspicion->source, task)
               ? MISTAKE_UNLIKELY
               : MISTAKE_LIKELY;
}
