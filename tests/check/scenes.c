#include "scenes.h"

#include "base/array.h"
#include "base/text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Names become file names, so nothing but letters, digits, '_' and '-' is let in. */
static bool name_copy(char name[SCENE_NAME_LIMIT], struct word word) {
    if (word.length == 0 || word.length >= SCENE_NAME_LIMIT) {
        return false;
    }
    for (size_t i = 0; i < word.length; i++) {
        if (!isalnum((unsigned char)word.start[i]) && !strchr("_-", word.start[i])) {
            return false;
        }
    }
    memcpy(name, word.start, word.length);
    name[word.length] = '\0';
    return true;
}

/* The number of "step05_zbuffer": 5; -1 for another kind of name. */
static long step_number(const char *name) {
    if (strncmp(name, "step", 4) != 0 || !isdigit((unsigned char)name[4])) {
        return -1;
    }
    char *end;
    long number = strtol(name + 4, &end, 10);
    return *end == '_' ? number : -1;
}

/* The table's last step if it has this name and only pictures so far, otherwise a new one; NULL
 * with a message. */
static struct checked_step *find_or_add_step(struct scene_table *table, struct text *text,
                                             struct word word, struct error *error) {
    char name[SCENE_NAME_LIMIT];
    if (!name_copy(name, word) || step_number(name) < 0) {
        text_error(error, text->line, "'%s' is not the name of a step, like step05_zbuffer",
                   word_show(word).text);
        return NULL;
    }
    for (size_t i = 0; i < table->step_count; i++) {
        if (strcmp(table->steps[i].name, name) == 0) {
            struct checked_step *step = &table->steps[i];
            if (i + 1 == table->step_count && step->item_count == step->scene_count) {
                return step;
            }
            text_error(error, text->line, "the scenes of %s must be together", name);
            return NULL;
        }
    }
    if (!array_extend(&table->steps, &table->step_capacity, table->step_count + 1,
                      sizeof *table->steps)) {
        error_out_of_memory(error);
        return NULL;
    }
    struct checked_step *step = &table->steps[table->step_count++];
    memset(step, 0, sizeof *step);
    memcpy(step->name, name, sizeof name);
    return step;
}

/* Is it the number of a task, like 5.2 or 8b.2? Or of a part, 8b, where that is `allowed`. */
static bool is_task(const char *text, bool part_allowed) {
    for (int part = 0; part < 2; part++) {
        size_t digits = strspn(text, "0123456789");
        if (digits == 0 || text[0] == '0') {
            return false;
        }
        text += digits;
        if (part == 0) {
            bool has_letter = islower((unsigned char)*text) != 0;
            text += has_letter;
            if (*text == '\0' && has_letter && part_allowed) {
                return true;
            }
            if (*text++ != '.') {
                return false;
            }
        }
    }
    return *text == '\0';
}

bool task_is_among(const struct task_name *tasks, size_t count, const char *task) {
    bool found = false;
    for (size_t i = 0; i < count; i++) {
        found |= strcmp(tasks[i].text, task) == 0;
    }
    return found;
}

/* Is the task, or the part "8b" of a task 8b.2, among these? */
static bool is_covered(const struct task_name *tasks, size_t count, const char *task) {
    bool found = false;
    for (size_t i = 0; i < count; i++) {
        size_t length = strlen(tasks[i].text);
        found |= strncmp(tasks[i].text, task, length) == 0 &&
                 (task[length] == '\0' || task[length] == '.');
    }
    return found;
}

bool credit_needs(const struct credit *credit, const char *task) {
    return is_covered(credit->needs, credit->need_count, task);
}

bool credit_relies_on(const struct credit *credit, const char *task) {
    return credit_needs(credit, task) || is_covered(credit->spoilers, credit->spoiler_count, task);
}

bool credit_has(const struct credit *credit, const char *task) {
    return task_is_among(credit->tasks, credit->task_count, task) || credit_relies_on(credit, task);
}

bool credit_covers(const struct credit *credit, const struct credit *other) {
    bool covers = true;
    for (size_t i = 0; i < other->task_count; i++) {
        covers &= credit_has(credit, other->tasks[i].text);
    }
    for (size_t i = 0; i < other->need_count; i++) {
        covers &= credit_has(credit, other->needs[i].text);
    }
    return covers;
}

/* What a task is to a scene, in the order of the table, and the signs before the others. */
enum role { ROLE_SHOWN, ROLE_NEEDED, ROLE_SPOILER };
static const char role_signs[] = "\0+~";

/* Add a task in this role. */
static bool add_credited_task(struct credit *credit, enum role role, const char *start,
                              size_t length) {
    struct task_name *lists[] = {credit->tasks, credit->needs, credit->spoilers};
    size_t *counts[] = {&credit->task_count, &credit->need_count, &credit->spoiler_count};
    struct task_name task = {""};
    if (length >= sizeof task.text || *counts[role] == SCENE_TASK_LIMIT) {
        return false;
    }
    memcpy(task.text, start, length);
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        if (task_is_among(lists[i], *counts[i], task.text)) {
            return false;
        }
    }
    lists[role][(*counts[role])++] = task;
    return is_task(task.text, role != ROLE_SHOWN);
}

/* The role that begins with the sign, or the same one, for a comma. */
static bool find_role(char sign, enum role *role) {
    const char *found = strchr(role_signs + *role + 1, sign);
    *role = found != NULL && sign != ',' ? (enum role)(found - role_signs) : *role;
    return sign == ',' || found != NULL;
}

/* `5.2` or `5.1,5.2` or `8e.1+8b,8d.1` or `8b.1+8a~8c`. */
static bool read_tasks(struct credit *credit, struct text *text, struct error *error) {
    struct word word = text_next_word(text);
    bool done = true;
    enum role role = ROLE_SHOWN;
    for (size_t start = 0; done && start <= word.length;) {
        size_t end = start;
        while (end < word.length && strchr(",+~", word.start[end]) == NULL) {
            end++;
        }
        done = add_credited_task(credit, role, word.start + start, end - start) &&
               (end == word.length || find_role(word.start[end], &role));
        start = end + 1;
    }
    return done || text_error(error, text->line, "'%s' are no tasks, like 5.2 or 5.1,5.2",
                              word_show(word).text);
}

static bool read_points(struct credit *credit, struct text *text, struct error *error) {
    struct word word = text_next_word(text);
    double points;
    if (!word_to_double(word, &points) || !(points >= 1 && points <= SCENE_POINT_LIMIT) ||
        points != (unsigned)points) {
        return text_error(error, text->line, "'%s' is not a number of points, 1..%d",
                          word_show(word).text, SCENE_POINT_LIMIT);
    }
    credit->points = (unsigned)points;
    return credit->points % credit->task_count == 0 ||
           text_error(error, text->line, "%u points cannot be shared out evenly to %zu tasks",
                      credit->points, credit->task_count);
}

static bool read_credit(struct credit *credit, struct text *text, struct error *error) {
    return read_tasks(credit, text, error) && read_points(credit, text, error);
}

static bool read_limit(unsigned *limit, struct text *text, struct word word, struct error *error) {
    double percent;
    if (!word_to_double(word, &percent) || !(percent >= 0 && percent <= 100)) {
        return text_error(error, text->line, "'%s' is neither 'exact' nor a percentage of 0..100",
                          word_show(word).text);
    }
    *limit = (unsigned)(percent * 1000 + 0.5);
    return true;
}

/* `exact`, or three limits and perhaps a fourth: without it any number of pixels may be near. */
static bool read_limits(struct checked_item *item, struct text *text, struct error *error) {
    unsigned *limits[] = {&item->wrong_limit, &item->apart_limit, &item->coverage_limit,
                          &item->near_limit};
    struct word word = text_next_word(text);
    item->exact = word_is(word, "exact");
    item->near_limit = item->exact ? 0 : 100 * 1000;
    bool done = true;
    for (size_t i = 0; done && !item->exact && i < 4 && (i < 3 || word.length > 0); i++) {
        done = read_limit(limits[i], text, word, error);
        word = i < 3 ? text_next_word(text) : word;
    }
    return done;
}

static bool read_count(uint64_t *count, struct text *text, struct word word, struct error *error) {
    double number;
    if (!word_to_double(word, &number) || !(number >= 0 && number <= 1e15) ||
        number != (double)(uint64_t)number) {
        return text_error(error, text->line, "'%s' is not what a counter can count to",
                          word_show(word).text);
    }
    *count = (uint64_t)number;
    return true;
}

static bool read_counter(struct checked_item *item, struct text *text, struct error *error) {
    struct word word = text_next_word(text);
    if (!name_copy(item->counter, word)) {
        return text_error(error, text->line, "'%s' is not the name of a counter",
                          word_show(word).text);
    }
    if (!read_count(&item->most, text, text_next_word(text), error)) {
        return false;
    }
    word = text_next_word(text);
    return word.length == 0 || read_count(&item->least, text, word, error);
}

static const char *const relation_names[RELATION_COUNT] = {"shuffled", "turned", "reversed",
                                                           "moved", "halved"};

/* Note the relation of that name; false when there is none, or it is noted already. */
static bool add_relation(struct checked_item *item, struct word name) {
    for (size_t i = 0; i < RELATION_COUNT; i++) {
        if (word_is(name, relation_names[i]) && !item->relations[i]) {
            item->relations[i] = true;
            return true;
        }
    }
    return false;
}

/* What a report calls them: "drawn again (shuffled, moved)". */
static void name_relations(struct checked_item *item) {
    const char *before = "drawn again (";
    item->counter[0] = '\0';
    for (size_t i = 0; i < RELATION_COUNT; i++) {
        if (item->relations[i]) {
            strcat(strcat(item->counter, before), relation_names[i]);
            before = ", ";
        }
    }
    strcat(item->counter, ")");
}

/* `shuffled,moved  0.1`. */
static bool read_relations(struct checked_item *item, struct text *text, struct error *error) {
    struct word word = text_next_word(text);
    for (size_t start = 0; start <= word.length;) {
        size_t end = start;
        while (end < word.length && word.start[end] != ',') {
            end++;
        }
        if (!add_relation(item, (struct word){word.start + start, end - start})) {
            return text_error(error, text->line, "'%s' are no relations", word_show(word).text);
        }
        start = end + 1;
    }
    name_relations(item);
    return read_limit(&item->limit, text, text_next_word(text), error);
}

/* Nothing more; the task's name is the counter's. */
static bool read_numbers(struct checked_item *item, struct text *text, struct error *error) {
    (void)text, (void)error;
    strcpy(item->counter, item->credit.tasks[0].text);
    return true;
}

/* The kinds of lines: those behind the pictures by their first word. */
static const struct {
    const char *word, *what;
    bool (*read)(struct checked_item *item, struct text *text, struct error *error);
} kinds[ITEM_KIND_COUNT] = {
    [ITEM_PICTURE] = {"", "scenes", read_limits},
    [ITEM_COUNTER] = {"work", "work", read_counter},
    [ITEM_RELATIONS] = {"same", "relations", read_relations},
    [ITEM_NUMBERS] = {"call", "numbers", read_numbers},
};

static enum item_kind find_kind(struct word word) {
    int kind = ITEM_PICTURE + 1;
    while (kind < ITEM_KIND_COUNT && !word_is(word, kinds[kind].word)) {
        kind++;
    }
    return kind < ITEM_KIND_COUNT ? (enum item_kind)kind : ITEM_PICTURE;
}

static const struct checked_item *find_scene(const struct checked_step *step, const char *name) {
    for (size_t i = 0; i < step->scene_count; i++) {
        if (strcmp(step->items[i].scene, name) == 0) {
            return &step->items[i];
        }
    }
    return NULL;
}

/* A new scene's name, or one that the step has. */
static bool read_scene(struct checked_item *item, const struct checked_step *step,
                       struct text *text, struct error *error) {
    struct word word = text_next_word(text);
    if (!name_copy(item->scene, word)) {
        return text_error(error, text->line, "'%s' is not the name of a scene",
                          word_show(word).text);
    }
    const bool is_known = item->kind == ITEM_NUMBERS ? word_is(word, "numbers")
                                                     : find_scene(step, item->scene) != NULL;
    if (item->kind == ITEM_PICTURE) {
        return !is_known || text_error(error, text->line, "%s is here twice", item->scene);
    }
    return is_known ||
           text_error(error, text->line, "%s has no scene '%s'", step->name, item->scene);
}

/* The step that a line names: other kinds follow its pictures. NULL with a message. */
static struct checked_step *read_step(struct scene_table *table, enum item_kind kind,
                                      struct text *text, struct word word, struct error *error) {
    if (kind == ITEM_PICTURE) {
        return find_or_add_step(table, text, word, error);
    }
    struct checked_step *last = table->step_count > 0 ? &table->steps[table->step_count - 1] : NULL;
    if (last != NULL && word_is(word, last->name)) {
        return last;
    }
    text_error(error, text->line, "%s of '%s' must follow its scenes", kinds[kind].what,
               word_show(word).text);
    return NULL;
}

static bool read_end(struct text *text, struct error *error) {
    struct word word = text_next_word(text);
    return word.length == 0 ||
           text_error(error, text->line, "unexpected '%s'", word_show(word).text);
}

/* What follows the word that names the kind. */
static bool read_item(struct scene_table *table, enum item_kind kind, struct text *text,
                      struct word step_name, struct error *error) {
    struct checked_step *step = read_step(table, kind, text, step_name, error);
    struct checked_item item = {.kind = kind};
    if (step == NULL || !read_scene(&item, step, text, error) ||
        !read_credit(&item.credit, text, error) || !kinds[kind].read(&item, text, error) ||
        !read_end(text, error)) {
        return false;
    }
    if (!array_extend(&step->items, &step->item_capacity, step->item_count + 1, sizeof item)) {
        return error_out_of_memory(error);
    }
    step->items[step->item_count++] = item;
    step->scene_count += kind == ITEM_PICTURE;
    return true;
}

bool scene_table_read(struct scene_table *table, const char *path, struct error *error) {
    *table = (struct scene_table){.steps = NULL};
    struct bytes file = {.data = NULL};
    if (!file_read(path, &file, error)) {
        return false;
    }
    struct text text;
    bool done = text_begin(&text, file.data, file.size, false, error);
    while (done && text_next_line(&text)) {
        struct word word = text_next_word(&text);
        if (word.length > 0) {
            enum item_kind kind = find_kind(word);
            word = kind == ITEM_PICTURE ? word : text_next_word(&text);
            done = read_item(table, kind, &text, word, error);
        }
    }
    if (done && table->step_count == 0) {
        done = error_set(error, "there is no scene in it");
    }
    bytes_free(&file);
    if (!done) {
        scene_table_free(table);
        return error_name_input(error, path);
    }
    return true;
}

bool scene_table_select(struct scene_table *table, const char *step, struct error *error) {
    if (step[0] == '\0') {
        return true;
    }
    char *end;
    long number = isdigit((unsigned char)step[0]) ? strtol(step, &end, 10) : -1;
    bool is_number = number >= 0 && *end == '\0';
    bool found = false;
    for (size_t i = 0; i < table->step_count; i++) {
        const char *name = table->steps[i].name;
        if (is_number ? step_number(name) == number : strcmp(name, step) == 0) {
            table->steps[i].selected = found = true;
        }
    }
    if (found) {
        return true;
    }
    error_set(error, "there is no step '%s'; the steps are", step);
    for (size_t i = 0; i < table->step_count; i++) {
        size_t length = strlen(error->message);
        if (length + strlen(table->steps[i].name) + 2 < sizeof error->message) {
            strcat(strcat(error->message, " "), table->steps[i].name);
        }
    }
    return false;
}

void scene_table_select_all(struct scene_table *table) {
    for (size_t i = 0; i < table->step_count; i++) {
        table->steps[i].selected = true;
    }
}

const struct checked_item *scene_table_find(const struct scene_table *table, const char *step,
                                            const char *scene) {
    for (size_t i = 0; i < table->step_count; i++) {
        if (strcmp(table->steps[i].name, step) == 0) {
            return find_scene(&table->steps[i], scene);
        }
    }
    return NULL;
}

static bool keep_scene(struct checked_step *step, const char *scene) {
    size_t kept = 0;
    step->scene_count = 0;
    for (size_t i = 0; i < step->item_count; i++) {
        if (strcmp(step->items[i].scene, scene) == 0) {
            step->scene_count += step->items[i].kind == ITEM_PICTURE;
            step->items[kept++] = step->items[i];
        }
    }
    step->item_count = kept;
    return kept > 0;
}

bool scene_table_keep(struct scene_table *table, const char *scene, struct error *error) {
    for (size_t i = 0; i < table->step_count && scene[0] != '\0'; i++) {
        struct checked_step *step = &table->steps[i];
        if (step->selected && !keep_scene(step, scene)) {
            return error_set(error, "%s has no scene '%.100s'", step->name, scene);
        }
    }
    return true;
}

void scene_table_make_exact(struct scene_table *table) {
    for (size_t i = 0; i < table->step_count; i++) {
        for (size_t k = 0; k < table->steps[i].scene_count; k++) {
            struct checked_item *item = &table->steps[i].items[k];
            item->exact = true;
            item->wrong_limit = item->apart_limit = item->coverage_limit = 0;
            item->near_limit = 0;
        }
    }
}

void scene_table_free(struct scene_table *table) {
    for (size_t i = 0; i < table->step_count; i++) {
        free(table->steps[i].items);
    }
    free(table->steps);
    *table = (struct scene_table){.steps = NULL};
}
