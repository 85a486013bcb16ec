/* Tests of the list of known mistakes, and of what the check says of those a program may make. */
#define _POSIX_C_SOURCE 200809L

#include "base/file.h"
#include "mistakes.h"
#include "unit/unit.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- Reading ---- */

/* Read that text as a list. The caller frees it. */
static struct mistake_list read_list(const char *text, size_t size) {
    char path[] = "/tmp/test_mistakes.XXXXXX";
    struct mistake_list mistakes;
    struct error error;
    CHECK(close(mkstemp(path)) == 0 && file_write(path, text, size, &error));
    CHECK(mistakes_read(&mistakes, path) == (mistakes.text.data != NULL));
    unlink(path);
    return mistakes;
}

static void test_lists(void) {
    static const struct {
        const char *text;
        size_t count;
    } cases[] = {
        {"", 0},
        {"# words\n", 0},
        {"- 0 - words", 1},
        {"10b.12 1234 a:2:7;b:-:c=5 a \"b\"  7", 1},
        {"5.2\n", 0},
        {"5.2 4\n", 0},
        {"5.2 4 -\n", 0},
        {"5.2 4 - \n", 0},
        {"5.2 no - figure\n", 0},
        {"5.2 4x - figure\n", 0},
        {"5.2 12345 - figures\n", 0},
        {"5.2000000000 0 - too long for a task\n", 0},
        {" 0 - no task\n", 0},
        {"5.2  - no figure\n", 0},
        {"\n", 0},
    };
    static const char line[] = "5.2 4 depth:2:7;depth:rbr:tested=5 words\n";
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        /* One bad line, and nothing is known. */
        char *both = string_format("%s%s", line, cases[i].text);
        bool is_bad = cases[i].count == 0 && cases[i].text[0] != '\0' && cases[i].text[0] != '#';
        struct mistake_list mistakes = read_list(both, strlen(both));
        CHECK_ROW(mistakes.count == (is_bad ? 0 : cases[i].count + 1), cases[i].text);
        mistakes_free(&mistakes);
        free(both);
    }
    struct mistake_list none;
    CHECK(!mistakes_read(&none, "/tmp/there is no such file") && none.count == 0);
}

static void test_fields(void) {
    static const char text[] = "- 0 - a\n10b.12 14 a:2:7;b:-:c=5 a \"b\"  7\n";
    struct mistake_list mistakes = read_list(text, strlen(text));
    CHECK(mistakes.count == 2);
    CHECK_TEXT(mistakes.list[0].task.text, "");
    CHECK(mistakes.list[0].figure == 0 && mistake_next_sign(mistakes.list[0].signs) == NULL);
    CHECK_TEXT(mistakes.list[1].task.text, "10b.12");
    CHECK(mistakes.list[1].figure == 14);
    CHECK_TEXT(mistakes.list[1].words, "a \"b\"  7");
    CHECK_TEXT(mistakes.list[1].signs, "a:2:7;b:-:c=5");
    CHECK_TEXT(mistake_next_sign(mistakes.list[1].signs), "b:-:c=5");
    mistakes_free(&mistakes);
}

/* ---- Telling ---- */

static const struct mistake known[] = {
    {.task = {"5.2"}, .figure = 4, .words = "one"},
    {.task = {"5.2"}, .figure = 4, .words = "two"},
    {.task = {"5.3"}, .figure = 7, .words = "three"},
    {.task = {""}, .figure = 0, .words = "four"},
};

static void test_what_is_told(void) {
    static const struct {
        const char *doubts; /* of each, a digit; a blank for one that is not in the set */
        const char *words, *tasks;
        unsigned figures[3];
        bool only_may_be;
    } cases[] = {
        {"    ", "", "", {0}, false},
        {"0   ", "\"one\"", "5.2", {4}, false},
        {"   0", "\"four\"", "", {0}, false},
        {"00  ", "\"one\" or \"two\"", "5.2", {4}, false},
        {"0000", "\"one\" or \"two\" or \"three\" or \"four\"", "5.2 5.3", {4, 7}, false},
        {"0123", "\"one\"", "5.2", {4}, false},
        {"1213", "\"one\" or \"three\"", "5.2 5.3", {4, 7}, false},
        {"3123", "\"two\"", "5.2", {4}, false},
        {"3322", "\"three\" or \"four\"", "5.3", {7}, true},
        {"3333", "", "", {0}, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct item_result item = {.scene = "scene"};
        struct mistake_set set = {.count = 0};
        char tasks[LOOKS_NAME_LIMIT * TASK_NAME_LIMIT] = "";
        for (size_t k = 0; k < LOOKS_NAME_LIMIT; k++) {
            if (cases[i].doubts[k] != ' ' && CHECK(mistake_set_add(&set, &known[k]))) {
                set.doubts[set.count - 1] = (enum mistake_doubt)(cases[i].doubts[k] - '0');
            }
        }
        mistakes_tell(&item, &set);
        for (size_t k = 0; k < item.looks_task_count; k++) {
            strcat(strcat(tasks, k > 0 ? " " : ""), item.looks_tasks[k].text);
        }
        CHECK_TEXT(item.looks.text, cases[i].words);
        CHECK_TEXT(tasks, cases[i].tasks);
        CHECK_ROW(item.only_may_be == cases[i].only_may_be, cases[i].doubts);
        for (size_t k = 0; k < 3; k++) {
            unsigned figure = k < item.looks_figure_count ? item.looks_figures[k] : 0;
            CHECK_ROW(figure == cases[i].figures[k], cases[i].doubts);
        }
    }
    struct mistake_set full = {.count = LOOKS_NAME_LIMIT};
    CHECK(!mistake_set_add(&full, &known[0]) && full.count == LOOKS_NAME_LIMIT);
}

UNIT_MAIN(TEST(test_lists), TEST(test_fields), TEST(test_what_is_told))
