/*
 * Tests of what tells a mistake where no picture does: a program that counts the same, with the
 * same pictures right, makes that mistake; in doubt none.
 */
#define _POSIX_C_SOURCE 200809L

#include "base/file.h"
#include "counters.h"
#include "unit/unit.h"

#include <stdio.h>
#include <stdlib.h>
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
        item->state = state == 'r'   ? RESULT_PASS
                      : state == '?' ? RESULT_TODO
                      : state == 'c' ? RESULT_CRASH
                      : state == 'd' ? RESULT_CRASH
                                     : RESULT_FAIL;
        item->blank = state == 'b' || state == 'c' || state == '?';
        item->divided = state == 'd' || state == '?';
    }
}

static void check_counters(const char *output, const char *wanted) {
    CHECK_TEXT(counters_of(output, "depth").text, wanted);
}

static void test_counters(void) {
    char long_output[2 * COUNTERS_LIMIT], exact[2 * COUNTERS_LIMIT];
    check_counters("", "-");
    check_counters("depth.tested: 5\n", "tested=5");
    check_counters("depth.tested: 5", "tested=5");
    check_counters("rows.a: 1\ndepth.b_2: 0\ndeep.c: 3\ndepth.a: 18446744073709551616\n",
                   "b_2=0,a=18446744073709551616");
    check_counters("depth2.tested: 5\nadepth.tested: 5\ndepths: 5\ndepth: 5\n", "-");
    check_counters("depth.tested: 5\ndepth.tested: 6\n", "tested=5,tested=6");
    /* What is no counter makes all of the scene unclear. */
    check_counters("depth.tested: 5\ndepth.seconds: 1.5\n", "");
    check_counters("depth.tested: -5\n", "");
    check_counters("depth.tested:5\n", "");
    check_counters("depth.tested: \n", "");
    check_counters("depth.: 5\n", "");
    check_counters("depth.\n", "");
    check_counters("depth.a b: 5\n", "");
    check_counters("depth.a=1,b: 5\n", "");
    check_counters("depth.tested\n: 5\n", "");
    /* As long as there is room for, and one more. */
    for (int more = 0; more <= 1; more++) {
        int zeros = COUNTERS_LIMIT - 1 - (int)strlen("tested=") + more;
        snprintf(long_output, sizeof long_output, "depth.tested: %0*d\n", zeros, 7);
        snprintf(exact, sizeof exact, "tested=%0*d", zeros, 7);
        check_counters(long_output, more == 0 ? exact : "");
        snprintf(long_output, sizeof long_output, "depth.a: 1\ndepth.tested: %0*d\n", zeros - 4, 7);
        snprintf(exact, sizeof exact, "a=1,tested=%0*d", zeros - 4, 7);
        check_counters(long_output, more == 0 ? exact : "");
    }
}

static void test_pictures(void) {
    static const struct {
        const char *states, *letters;
    } cases[] = {{"rrr", "rrr"}, {"rb?", "rb?"}, {"wbr", "xbr"}, {"rrc", "rrx"}, {"rdb", "rdb"}};
    struct fixture f;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        set_up(&f, cases[i].states);
        CHECK_TEXT(counters_pictures(&f.result).text, cases[i].letters);
    }
    struct item_result many[COUNTERS_SCENE_LIMIT];
    set_up(&f, "rrr");
    for (size_t count = COUNTERS_SCENE_LIMIT - 1; count <= COUNTERS_SCENE_LIMIT; count++) {
        for (size_t i = 0; i < count; i++) {
            many[i] = f.items[0];
        }
        const struct step_result result = {.items = many, .item_count = count};
        bool fits = count < COUNTERS_SCENE_LIMIT;
        CHECK(strlen(counters_pictures(&result).text) == (fits ? count : 1));
        CHECK(counters_pictures(&result).text[0] == (fits ? 'r' : 'x'));
    }
}

/* What may be told of item 1, the blank picture, and of item 3, the counter. */
static void test_what_may_be_told(void) {
    static const struct {
        size_t item;
        const char *states, *output;
        bool wanted;
    } cases[] = {
        {1, "rbr", "", true},                   /* another one is right */
        {1, "bbb", "", false},                  /* nothing is there */
        {1, "rb?", "", false},                  /* has not come so far */
        {1, "rb?", "depth.tested: 0\n", false}, /* counts nothing either */
        {1, "rb?", "depth.tested: 50\n", true}, /* it has tried to draw */
        {1, "?b?", "depth.tested: 50\n", true}, /* */
        {1, "bbb", "depth.tested: 50\n", true}, /* */
        {1, "bbb", "deep.tested: 50\n", false}, /* counted elsewhere */
        {1, "bbb", "depth.a: 0\ndepth.b: 3\n", true},
        {1, "rbw", "depth.tested: 50\n", false},  /* a wrong picture tells more */
        {1, "rbc", "depth.tested: 50\n", false},  /* and so does a crash */
        {1, "rbr", "depth.tested: 5.0\n", false}, /* unclear */
        {3, "rrr", "depth.tested: 5\n", true},
        {3, "rrr", "depth.tested: 0\n", true}, /* nothing is counted: that is what is wrong */
        {3, "?r?", "depth.tested: 5\n", true},
        {3, "rrr", "", false},
        {3, "rrr", "depth.tested: no\n", false},
        {3, "rrb", "depth.tested: 5\n", false}, /* a picture is wrong, too */
        {3, "wrr", "depth.tested: 5\n", false},
        {3, "drr", "depth.tested: 5\n", false},
        {1, "rdd", "", true},
        {1, "rd?", "", false}, /* it may have begun anywhere */
        {1, "ddd", "", false},
        {1, "rdc", "", false},
    };
    struct fixture f;
    struct counted counted;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char what[80];
        snprintf(what, sizeof what, "%zu: item %zu of %s", i, cases[i].item, cases[i].states);
        set_up(&f, cases[i].states);
        bool told = counted_of(&counted, &f.result, &f.items[cases[i].item], cases[i].output) &&
                    counted_tells(&counted, 1);
        CHECK_ROW(told == cases[i].wanted, what);
        CHECK_TEXT(counted.scene, "depth");
    }
    set_up(&f, "rb?");
    CHECK(counted_of(&counted, &f.result, &f.items[1], "depth.tested: 5\n"));
    CHECK_TEXT(counted.pictures.text, "rb?");
    CHECK_TEXT(counted.counters.text, "tested=5");
    set_up(&f, "?rr");
    CHECK(counted_of(&counted, &f.result, &f.items[3], "depth.tested: 5\n"));
    CHECK_TEXT(counted.pictures.text, "-");
}

/* ---- Files ---- */

/* What is read of a list: DIRECTORY/a/counters.list. The caller frees it. */
static struct counted_list read_list(const char *text, size_t size) {
    char directory[] = "/tmp/test_counters.XXXXXX", path[64], command[80];
    struct counted_list list;
    struct error error;
    CHECK(mkdtemp(directory) != NULL);
    snprintf(path, sizeof path, "%s/a", directory);
    CHECK(directory_create(path, &error));
    snprintf(path, sizeof path, "%s/a/counters.list", directory);
    CHECK(file_write(path, text, size, &error));
    counted_read(&list, directory, "a");
    snprintf(command, sizeof command, "rm -rf '%s'", directory);
    CHECK(system(command) == 0);
    return list;
}

static void test_files(void) {
    static const char line[] = "depth rbr tested=5 5.2 4 a \"b\" 7\n";
    static const struct {
        const char *text;
        size_t count;
    } cases[] = {
        {"", 0},
        {"# words\n", 0},
        {"depth - tested=5 - 0 not counted", 1},
        {"depth - tested=5 5.2\n", 0},
        {"depth - tested=5 5.2 \n", 0},
        {"depth - tested=5 5.2 no figure\n", 0},
        {"depth - tested=5 5.2 -4 no figure\n", 0},
        {"depth - tested=5 5.2 4x no figure\n", 0},
        {"depth - tested=5 5.2 12345 figures\n", 0},
        {"depth - tested=5 5.2 4\n", 0},
        {"depth - tested=5 5.2 1234 figures\n", 1},
        {"depth\n", 0},
        {"\n", 0},
        {"depth rbx tested=5 5.2 0 a letter that is none\n", 0},
        {"depth rbd - 5.2 0 black, and a crash\n", 1},
        {"depth rb? tested=5 5.2 0 what is to do is known of no mistake\n", 0},
        {"depth - tested=5 5.2000000000 0 too long for a task\n", 0},
        {"depth  tested=5 5.2 0 no word for the pictures\n", 0},
        {"depth rrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrrr - 5.2 0 "
         "long\n",
         0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct counted_list list = read_list(cases[i].text, strlen(cases[i].text));
        CHECK_ROW(list.count == cases[i].count, cases[i].text);
        counted_free(&list);
        /* One bad line, and nothing is known. */
        char *both = string_format("%s%s", line, cases[i].text);
        list = read_list(both, strlen(both));
        bool is_bad = cases[i].count == 0 && cases[i].text[0] != '\0' && cases[i].text[0] != '#';
        CHECK_ROW(list.count == (is_bad ? 0 : cases[i].count + 1), cases[i].text);
        counted_free(&list);
        free(both);
    }
    struct counted_list list = read_list(line, strlen(line));
    CHECK(list.count == 1);
    CHECK_TEXT(list.list[0].scene, "depth");
    CHECK_TEXT(list.list[0].pictures.text, "rbr");
    CHECK_TEXT(list.list[0].counters.text, "tested=5");
    CHECK_TEXT(list.list[0].look.task.text, "5.2");
    CHECK_TEXT(list.list[0].look.words, "a \"b\" 7");
    CHECK(list.list[0].look.figure == 4);
    counted_free(&list);
    list = read_list("depth - tested=5 - 0 a\n", 23);
    CHECK(list.count == 1 && list.list[0].look.task.text[0] == '\0');
    counted_free(&list);
    counted_read(&list, "/tmp/there is no such directory", "a");
    CHECK(list.count == 0 && list.list == NULL);
}

/* Lines that are too long, NULs, and no end: nothing is written beyond what there is room for. */
static void test_hostile_files(void) {
    enum { SIZE = 8192 };
    static char text[SIZE];
    static const char *const begins[] = {
        "", "depth ", "depth - ", "depth - a=1 ", "depth - a=1 5.2 ", "depth - a=1 5.2 0 "};
    for (size_t i = 0; i < sizeof begins / sizeof begins[0]; i++) {
        for (size_t size = 1; size <= SIZE; size *= 2) {
            memset(text, 'r', sizeof text);
            size_t length = strlen(begins[i]);
            memcpy(text, begins[i], length);
            struct counted_list list = read_list(text, size);
            for (size_t k = 0; k < list.count; k++) {
                CHECK(strlen(list.list[k].look.words) < LOOKS_WORDS_LIMIT);
            }
            CHECK(list.count == 0 || i + 1 == sizeof begins / sizeof begins[0]);
            counted_free(&list);
        }
    }
    struct counted_list list = read_list("depth - a=1 5.2 0 a\n\0depth - a=1 5.2 0 b\n", 41);
    CHECK(list.count == 1);
    counted_free(&list);
}

/* ---- Which mistake it is ---- */

static const char known[] = "# words\n"
                            "depth - tested=5 5.2 0 five\n"
                            "depth - tested=0 5.2 0 none\n"
                            "depth - tested=0 5.3 0 none, again\n"
                            "deep - tested=7 5.2 0 seven elsewhere\n"
                            "depth rbr tested=5 5.2 0 five, and black\n"
                            "depth bbr tested=5 5.2 0 five, and black from the begin\n"
                            "depth rbb - 5.3 0 nothing\n"
                            "depth - tested=1 - 0 a\n"
                            "depth - tested=1 - 0 b\n"
                            "depth - tested=1 - 0 c\n"
                            "depth - tested=1 - 0 d\n"
                            "depth - tested=2 - 0 a\n"
                            "depth - tested=2 - 0 b\n"
                            "depth - tested=2 - 0 c\n"
                            "depth - tested=2 - 0 d\n"
                            "depth - tested=2 - 0 e\n";

static void test_what_is_told(void) {
    static const struct {
        const char *scene, *pictures, *counters, *words; /* of the first; NULL: none */
        size_t count;
    } cases[] = {
        {"depth", "-", "tested=5", "five", 1},
        {"depth", "-", "tested=6", NULL, 0},
        {"depth", "-", "tested=50", NULL, 0},
        {"depth", "-", "tested=5,written=0", NULL, 0},
        {"depth", "-", "teste=5", NULL, 0},
        {"deep", "-", "tested=5", NULL, 0},
        {"dept", "-", "tested=5", NULL, 0},
        {"depth", "-", "tested=7", NULL, 0},
        {"depth", "-", "tested=0", "none", 2},
        {"depth", "rbr", "tested=5", "five, and black", 1},
        {"depth", "bbr", "tested=5", "five, and black from the begin", 1},
        {"depth", "?br", "tested=5", "five, and black", 2},
        {"depth", "rb?", "tested=5", "five, and black", 1},
        {"depth", "rbb", "tested=5", NULL, 0},
        {"depth", "rrr", "tested=5", NULL, 0},
        {"depth", "b", "tested=5", NULL, 0}, /* only this scene was drawn */
        {"depth", "rbrr", "tested=5", NULL, 0},
        {"depth", "rb", "tested=5", NULL, 0},
        {"depth", "rbb", "-", "nothing", 1},
        {"depth", "rbb", "", NULL, 0},
        {"depth", "rdd", "-", NULL, 0},
        {"depth", "-", "tested=1", "a", 4},
        {"depth", "-", "tested=2", NULL, 0}, /* five of them */
    };
    struct counted_list list = read_list(known, strlen(known));
    CHECK(list.count == 16);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct counted yours = {.scene = ""};
        struct look found[LOOKS_NAME_LIMIT];
        snprintf(yours.scene, sizeof yours.scene, "%s", cases[i].scene);
        snprintf(yours.pictures.text, sizeof yours.pictures.text, "%s", cases[i].pictures);
        snprintf(yours.counters.text, sizeof yours.counters.text, "%s", cases[i].counters);
        size_t count = counted_find(&list, &yours, 1, found);
        CHECK_ROW(count == cases[i].count, cases[i].counters);
        CHECK_ROW(count == 0 || found[0].row == 1, cases[i].counters);
        if (count > 0 && cases[i].words != NULL) {
            CHECK_TEXT(found[0].words, cases[i].words);
        }
    }
    counted_free(&list);
}

/* Two scenes are black: what they count must be one mistake's, and one of them must tell it. */
static void test_of_two_scenes(void) {
    static const char list_text[] = "depth bb tested=5 5.2 0 five\n"
                                    "deep bb - 5.2 0 five\n"
                                    "depth bb tested=6 5.2 0 six\n"
                                    "deep bb - 5.2 0 six\n"
                                    "depth bb tested=5 5.3 0 five\n"
                                    "depth bb - 5.3 0 nothing\n"
                                    "deep bb - 5.3 0 nothing\n";
    static const struct {
        const char *counters, *words, *task;
        bool tells;
    } cases[] = {{"tested=5", "five", "5.2", true},
                 {"tested=6", "six", "5.2", true},
                 {"tested=7", NULL, NULL, true}, /* deep alone would be told */
                 {"-", "nothing", "5.3", false}};
    struct counted_list list = read_list(list_text, strlen(list_text));
    CHECK(list.count == 7);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        for (size_t first = 0; first < 2; first++) { /* in both orders */
            struct counted yours[2];
            struct look found[LOOKS_NAME_LIMIT];
            yours[first] = (struct counted){.scene = "depth", .pictures = {"bb"}};
            yours[1 - first] =
                (struct counted){.scene = "deep", .pictures = {"bb"}, .counters = {"-"}};
            strcpy(yours[first].counters.text, cases[i].counters);
            CHECK(counted_tells(yours, 2) == cases[i].tells);
            size_t count = counted_find(&list, yours, 2, found);
            CHECK_ROW(count == (cases[i].words != NULL), cases[i].counters);
            if (count == 1 && cases[i].words != NULL) {
                CHECK_TEXT(found[0].words, cases[i].words);
                CHECK_TEXT(found[0].task.text, cases[i].task);
            }
            CHECK(counted_find(&list, yours, 0, found) == 0 && !counted_tells(yours, 0));
        }
    }
    counted_free(&list);
}

UNIT_MAIN(TEST(test_counters), TEST(test_pictures), TEST(test_what_may_be_told), TEST(test_files),
          TEST(test_hostile_files), TEST(test_what_is_told), TEST(test_of_two_scenes))
