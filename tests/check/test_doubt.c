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

static void test_likely(void) {
    struct fixture f;
    set_up(&f);
    CHECK(find(&f) == MISTAKE_LIKELY);
    f.items[1].state = RESULT_PASS; /* but not exact: near is near */
    f.credits[1].task_count = 2;
    f.explains[1][2] = false;
    CHECK(find(&f) == MISTAKE_LIKELY);
    f.items[1].exact = true;
    f.lists[1][0].apart = 0; /* a scene that does not show it */
    CHECK(find(&f) == MISTAKE_LIKELY);
}

static void test_impossible(void) {
    struct fixture f;
    set_up(&f);
    f.items[1].state = RESULT_PASS;
    f.items[1].exact = true;
    CHECK(find(&f) == MISTAKE_IMPOSSIBLE);
    f.items[1].exact = false;
    f.items[1].shares.apart.count = 9;
    CHECK(find(&f) == MISTAKE_IMPOSSIBLE);
    f.items[1].shares.apart.count = 10; /* other arithmetic hides some of it */
    CHECK(find(&f) == MISTAKE_UNLIKELY);
    f.items[1].shares.apart.count = 0;
    f.lists[1][0].apart = 99; /* or all, where it is little */
    CHECK(find(&f) == MISTAKE_UNLIKELY);
    f.items[1].exact = true;
    CHECK(find(&f) == MISTAKE_IMPOSSIBLE);
    f.looks[1].list = NULL; /* nothing is known of the scene */
    CHECK(find(&f) == MISTAKE_UNLIKELY);
}

static void test_unlikely(void) {
    struct fixture f;
    set_up(&f);
    f.source = "x // to do 5.2: y";
    CHECK(find(&f) == MISTAKE_UNLIKELY);
    f.source = "x // to do 5.3: y";
    CHECK(find(&f) == MISTAKE_LIKELY);
    f.items[1].state = RESULT_PASS;
    CHECK(find(&f) == MISTAKE_UNLIKELY);
}

static void test_doubtful(void) {
    struct fixture f;
    set_up(&f);
    f.explains[1][2] = false;
    CHECK(find(&f) == MISTAKE_DOUBTFUL);
    f.items[1].state = RESULT_CRASH;
    CHECK(find(&f) == MISTAKE_LIKELY);
    f.items[1].state = RESULT_TODO;
    CHECK(find(&f) == MISTAKE_LIKELY);
    f.items[1].state = RESULT_FAIL;
    f.looks[1].explains = NULL; /* not known */
    CHECK(find(&f) == MISTAKE_LIKELY);
    /* one that the mistake leaves right */
    set_up(&f);
    f.lists[1][0].row = 0;
    CHECK(find(&f) == MISTAKE_LIKELY);
    f.lists[1][0].apart = 0;
    CHECK(find(&f) == MISTAKE_DOUBTFUL);
    f.items[1].blank = true;
    CHECK(find(&f) == MISTAKE_LIKELY);
    f.items[1].blank = false;
    f.items[1].shares.apart.count = 0; /* and that is near */
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

UNIT_MAIN(TEST(test_likely), TEST(test_impossible), TEST(test_unlikely), TEST(test_doubtful),
          TEST(test_other_tasks))
