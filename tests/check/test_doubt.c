/* Tests of what speaks against a mistake that a picture looks like. */
#include "doubt.h"
#include "unit/unit.h"

#include <string.h>

enum { SCENES = 2, ROWS = 4 };

static struct mistake known = {.task = {"5.2"}, .words = "a"};

/* Two scenes that fail. In the first one it is asked for the known mistake: row 2 in both. */
struct fixture {
    struct item_result items[SCENES];
    struct credit credits[SCENES];
    struct mistake_list mistakes;
    struct looks looks[SCENES];
    struct look lists[SCENES][1];
    bool explains[SCENES][ROWS];
    struct step_result result;
    const char *source;
};

static void add_task(struct credit *credit, bool is_need, const char *task) {
    struct task_name *tasks = is_need ? credit->needs : credit->tasks;
    size_t *count = is_need ? &credit->need_count : &credit->task_count;
    strcpy(tasks[(*count)++].text, task);
}

static void set_up(struct fixture *f) {
    memset(f, 0, sizeof *f);
    f->mistakes = (struct mistake_list){.list = &known, .count = 1};
    for (size_t i = 0; i < SCENES; i++) {
        f->items[i] = (struct item_result){.scene = i == 0 ? "first" : "second",
                                           .counter = "",
                                           .credit = &f->credits[i],
                                           .state = RESULT_FAIL};
        f->items[i].shares.apart.count = 100;
        add_task(&f->credits[i], false, "5.2");
        f->lists[i][0] = (struct look){.row = 2, .apart = 100};
        f->explains[i][2] = true;
        f->looks[i] = (struct looks){
            .mistakes = &f->mistakes, .list = f->lists[i], .explains = f->explains[i]};
    }
    f->result = (struct step_result){.items = f->items, .item_count = SCENES};
    f->source = "";
}

static enum mistake_doubt find(const struct fixture *f) {
    const struct suspicion suspicion = {.result = &f->result,
                                        .looks = f->looks,
                                        .scene_count = SCENES,
                                        .source = f->source,
                                        .item = &f->items[0]};
    return doubt_find(&suspicion, &known);
}

/* The second scene, and what the mistake makes of it. */
static void test_second_scene(void) {
    enum { YES = 1, NO = 0, UNKNOWN = -1 };
    static const struct {
        const char *what;
        enum result_state state;
        bool exact, blank;
        uint64_t apart;
        struct look look;
        int explained; /* by the mistake's picture? */
        enum mistake_doubt doubt;
    } cases[] = {
        {"as the mistake makes it", RESULT_FAIL, 0, 0, 100, {2, 100}, YES, MISTAKE_LIKELY},
        {"other pixels are wrong", RESULT_FAIL, 0, 0, 100, {2, 100}, NO, MISTAKE_DOUBTFUL},
        {"not known", RESULT_FAIL, 0, 0, 100, {2, 100}, UNKNOWN, MISTAKE_LIKELY},
        {"it crashes", RESULT_CRASH, 0, 0, 100, {2, 100}, NO, MISTAKE_LIKELY},
        {"it is to do", RESULT_TODO, 0, 0, 100, {2, 100}, NO, MISTAKE_LIKELY},
        {"the mistake draws nothing", RESULT_FAIL, 0, 0, 100, {0, 100}, NO, MISTAKE_LIKELY},
        {"the mistake leaves it right", RESULT_FAIL, 0, 0, 100, {0, 0}, NO, MISTAKE_DOUBTFUL},
        {"so, and blank", RESULT_FAIL, 0, 1, 100, {0, 0}, NO, MISTAKE_LIKELY},
        {"so, and near", RESULT_FAIL, 0, 0, 0, {0, 0}, NO, MISTAKE_LIKELY},
        {"exact", RESULT_PASS, 1, 0, 0, {2, 100}, NO, MISTAKE_IMPOSSIBLE},
        {"exact, as it leaves it", RESULT_PASS, 1, 0, 0, {2, 0}, NO, MISTAKE_UNLIKELY},
        {"a tenth is left", RESULT_PASS, 0, 0, 10, {2, 100}, NO, MISTAKE_UNLIKELY},
        {"less is left", RESULT_PASS, 0, 0, 9, {2, 100}, NO, MISTAKE_IMPOSSIBLE},
        {"little was wrong", RESULT_PASS, 0, 0, 0, {2, 99}, NO, MISTAKE_UNLIKELY},
        {"little was, but it is exact", RESULT_PASS, 1, 0, 0, {2, 99}, NO, MISTAKE_IMPOSSIBLE},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct fixture f;
        set_up(&f);
        f.items[1].state = cases[i].state;
        f.items[1].exact = cases[i].exact;
        f.items[1].blank = cases[i].blank;
        f.items[1].shares.apart.count = cases[i].apart;
        f.lists[1][0] = cases[i].look;
        f.explains[1][2] = cases[i].explained == YES;
        f.looks[1].explains = cases[i].explained == UNKNOWN ? NULL : f.explains[1];
        CHECK_ROW(find(&f) == cases[i].doubt, cases[i].what);
    }
}

static void test_unlikely(void) {
    struct fixture f;
    set_up(&f);
    f.source = "x // to do 5.2: y";
    CHECK(find(&f) == MISTAKE_UNLIKELY);
    f.source = "x // to do 5.3: y";
    CHECK(find(&f) == MISTAKE_LIKELY);
    f.items[1].state = RESULT_PASS; /* but not exact: near is near */
    CHECK(find(&f) == MISTAKE_UNLIKELY);
    f.credits[1].task_count = 2;
    CHECK(find(&f) == MISTAKE_LIKELY);
    f.items[1].exact = true;
    CHECK(find(&f) == MISTAKE_IMPOSSIBLE);
    f.looks[1].list = NULL; /* nothing is known of the scene */
    CHECK(find(&f) == MISTAKE_LIKELY);
}

/* Where another task is shown or needed, that may be wrong, too. */
static void test_other_tasks(void) {
    struct fixture f;
    set_up(&f);
    f.explains[1][2] = false;
    add_task(&f.credits[1], false, "5.3");
    CHECK(find(&f) == MISTAKE_LIKELY);
    add_task(&f.credits[0], true, "5.3");
    CHECK(find(&f) == MISTAKE_DOUBTFUL);
    add_task(&f.credits[1], true, "6b.2");
    CHECK(find(&f) == MISTAKE_LIKELY);
    add_task(&f.credits[0], true, "6b");
    CHECK(find(&f) == MISTAKE_DOUBTFUL);
    add_task(&f.credits[1], true, "6c");
    CHECK(find(&f) == MISTAKE_LIKELY);
    add_task(&f.credits[0], true, "6c.1"); /* not all of the part */
    CHECK(find(&f) == MISTAKE_LIKELY);
}

UNIT_MAIN(TEST(test_second_scene), TEST(test_unlikely), TEST(test_other_tasks))
