/*
 * Tests of what shows a mistake where no picture does: a program that counts the same, with the
 * same pictures right, makes that mistake; in doubt none.
 */
#define _POSIX_C_SOURCE 200809L

#include "counters.h"
#include "unit/unit.h"

#include <string.h>

enum { SCENES = 3, ITEMS = 4 };

/* A lesson of three scenes, of which the second has a counter. */
struct fixture {
    struct item_result items[ITEMS];
    struct step_result result;
};

/* The pictures are `states`: r right, b blank, d divided by 0, ? to do, w wrong, c crashed. */
static void set_up(struct fixture *f, const char *states) {
    static const char *const scenes[ITEMS] = {"rows", "depth", "deep", "depth"};
    memset(f, 0, sizeof *f);
    f->result = (struct step_result){.items = f->items, .item_count = ITEMS};
    for (size_t i = 0; i < ITEMS; i++) {
        struct item_result *item = &f->items[i];
        char state = (char)(i < SCENES ? states[i] : 'w');
        item->scene = scenes[i];
        item->counter = i < SCENES ? "" : "tested";
        item->kind = i < SCENES ? ITEM_PICTURE : ITEM_COUNTER;
        item->state = state == 'r'   ? RESULT_PASS
                      : state == '?' ? RESULT_TODO
                      : state == 'c' ? RESULT_CRASH
                      : state == 'd' ? RESULT_CRASH
                                     : RESULT_FAIL;
        item->blank = state == 'b' || state == 'c' || state == '?';
        item->divided = state == 'd' || state == '?';
    }
}

/* What the check says of the item when the program prints that; "" for nothing. */
static const char *text_of(struct counted *counted, const char *states, size_t item,
                           const char *output) {
    struct fixture f;
    set_up(&f, states);
    return counted_of(counted, &f.result, &f.items[item], output) ? counted->text : "";
}

static void test_texts(void) {
    static const struct {
        size_t item;
        const char *states, *output, *text;
    } cases[] = {
        {1, "rbr", "", "depth:rbr:-"},
        {1, "bbb", "", "depth:bbb:-"},
        {1, "rdb", "depth.tested: 5", "depth:rdb:-"},
        {3, "rrr", "rows.a: 1\ndepth.b_2: 0\ndeep.c: 3\ndepth.a: 18446744073709551616\n",
         "depth:-:b_2=0,a=18446744073709551616"},
        {3, "rrr", "depth.a: 5\ndepth.a: 6\n", "depth:-:a=5,a=6"},
        {3, "?rr", "depth.tested: 5\n", "depth:-:tested=5"},
        {3, "rrr", "depth2.a: 5\nadepth.a: 5\ndepths: 5\ndepth: 5\n", ""},
        {3, "rrr", "", ""},
        /* A picture that is wrong in another way says more, as a crash does. */
        {1, "rbw", "", ""},
        {1, "rbc", "", ""},
        {3, "wrr", "depth.tested: 5\n", ""},
        {3, "rrb", "depth.tested: 5\n", ""},
        {3, "drr", "depth.tested: 5\n", ""},
        /* It has not come so far. */
        {1, "rb?", "", ""},
        /* What is no counter makes all of the scene unclear. */
        {3, "rrr", "depth.tested: 5\ndepth.seconds: 1.5\n", ""},
        {3, "rrr", "depth.tested: -5\n", ""},
        {3, "rrr", "depth.tested:5\n", ""},
        {3, "rrr", "depth.tested: \n", ""},
        {3, "rrr", "depth.: 5\n", ""},
        {3, "rrr", "depth.a b: 5\n", ""},
        {3, "rrr", "depth.a=1,b: 5\n", ""},
        {3, "rrr", "depth.tested\n: 5\n", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct counted counted;
        CHECK_TEXT(text_of(&counted, cases[i].states, cases[i].item, cases[i].output),
                   cases[i].text);
    }
}

/* As long as there is room for, and one more. */
static void test_long_texts(void) {
    char output[2 * COUNTED_LIMIT], text[2 * COUNTED_LIMIT];
    struct counted counted;
    for (int more = 0; more <= 1; more++) {
        int zeros = COUNTED_LIMIT - 1 - (int)strlen("depth:-:a=1,b=") + more;
        snprintf(output, sizeof output, "depth.a: 1\ndepth.b: %0*d\n", zeros, 7);
        snprintf(text, sizeof text, "depth:-:a=1,b=%0*d", zeros, 7);
        CHECK_TEXT(text_of(&counted, "rrr", 3, output), more == 0 ? text : "");
    }
}

static struct mistake known[] = {
    {.words = "five", .signs = "depth:-:tested=5;deep:-:tested=7"},
    {.words = "none", .signs = "depth:-:tested=0"},
    {.words = "none, again", .signs = "depth:-:tested=0"},
    {.words = "nothing", .signs = "rows:2:1000;depth:rbb:-;deep:rbb:-"},
    {.words = MISTAKE_STARTER, .signs = "depth:bbb:-"},
    {.words = "a", .signs = "depth:-:tested=1;depth:-:tested=2"},
    {.words = "b", .signs = "depth:-:tested=1;depth:-:tested=2"},
    {.words = "c", .signs = "depth:-:tested=1;depth:-:tested=2"},
    {.words = "d", .signs = "depth:-:tested=1;depth:-:tested=2"},
    {.words = "e", .signs = "depth:-:tested=2"},
};

static void test_what_is_found(void) {
    static const struct {
        const char *yours;
        size_t count;
        const char *first; /* mistake of those that show it */
    } cases[] = {
        {"depth:-:tested=5", 1, "five"},
        {"deep:-:tested=7", 1, "five"},
        {"depth:-:tested=50", 0, ""},
        {"depth:-:tested=", 0, ""},
        {"depth:-:tested=5,written=0", 0, ""},
        {"dept:-:tested=5", 0, ""},
        {"depth:-:tested=0", 2, "none"},
        {"depth:rbb:-", 1, "nothing"},
        {"deep:rbb:-", 1, "nothing"},
        {"depth:rbr:-", 0, ""},
        {"depth:b:-", 0, ""},   /* only this scene was drawn */
        {"depth:bbb:-", 0, ""}, /* the starter makes no mistake */
        {"depth:-:tested=1", 4, "a"},
        {"depth:-:tested=2", 0, ""}, /* five of them */
    };
    const struct mistake_list list = {.list = known, .count = sizeof known / sizeof known[0]};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct counted yours;
        strcpy(yours.text, cases[i].yours);
        struct mistake_set set = counted_find(&list, &yours);
        CHECK_ROW(set.count == cases[i].count, cases[i].yours);
        CHECK_TEXT(set.count > 0 ? set.list[0]->words : "", cases[i].first);
    }
}

UNIT_MAIN(TEST(test_texts), TEST(test_long_texts), TEST(test_what_is_found))
