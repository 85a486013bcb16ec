/*
 * Tests of what a report makes of text that means something to its format, or to a terminal:
 * message, diagnosis and what a compiler said come from a submission.
 */
#include "export.h"
#include "unit/unit.h"

#include <stdlib.h>
#include <string.h>

/* A step with one picture, of which everything is said in the same words. */
struct fixture {
    struct credit credit;
    struct item_result item;
    struct task_result task;
    struct step_result step;
    struct check_result result;
};

static void set_up(struct fixture *f, enum result_state state, const char *text) {
    *f = (struct fixture){
        .credit = {.tasks = {{"5.2"}}, .task_count = 1, .points = 4},
        .item = {.scene = "depth", .counter = "", .state = state, .credit = &f->credit},
        .task = {.name = {"5.2"}, .state = state, .most = 4},
        .step = {.name = "step05_zbuffer",
                 .state = state,
                 .items = &f->item,
                 .item_count = 1,
                 .tasks = &f->task,
                 .task_count = 1,
                 .most = 4},
        .result = {.steps = &f->step,
                   .step_count = 1,
                   .failed = 1,
                   .most = 4,
                   .references = "tests/none"},
    };
    result_say(&f->item.message, "%s", text);
    result_say(&f->item.looks, "%s", text);
    result_say(&f->step.reason, "%s", text);
    CHECK(bytes_append(&f->step.messages, text, strlen(text) + 1));
}

/* The report, which the caller frees. */
static char *report_of(export_function *export, const struct fixture *f) {
    struct bytes report = {.data = NULL};
    struct error error;
    CHECK(export(&report, &f->result, &error) && bytes_append(&report, "", 1));
    return (char *)report.data;
}

/* Does the report hold `before`, the text, `after`? */
static void check_report(export_function *export, const struct fixture *f, const char *before,
                         const char *text, const char *after) {
    char *report = report_of(export, f), *wanted = string_format("%s%s%s", before, text, after);
    if (wanted != NULL) {
        CHECK_ROW(report != NULL && strstr(report, wanted) != NULL, wanted);
    }
    free(report);
    free(wanted);
}

static void test_hostile_texts(void) {
    static const struct {
        const char *text, *markup, *json;
    } cases[] = {
        {"plain", "plain", "plain"},
        {"\"a\" & 'b' <c>", "&quot;a&quot; &amp; &#39;b&#39; &lt;c&gt;", "\\\"a\\\" & 'b' <c>"},
        {"]]>--></pre></script>", "]]&gt;--&gt;&lt;/pre&gt;&lt;/script&gt;",
         "]]>--></pre></script>"},
        {"&amp;\\u0041", "&amp;amp;\\u0041", "&amp;\\\\u0041"},
        {"\x1b[31m\x07\x01\x7f", "?[31m???", "?[31m???"},
        {"a\tb\r", "a b?", "a b?"},
        {"\xe2\x80\xae \xc2\x9b", "??? ??", "??? ??"}, /* U+202E, U+009B */
        {"\xff \xc3 \xc3\xa9", "? ? \xc3\xa9", "? ? \xc3\xa9"},
        {"\xef\xbf\xbe\xef\xbf\xbf", "??????", "??????"}, /* not in XML */
        {"a\nb\n", "a\nb\n", "a\\nb\\n"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct fixture f;
        set_up(&f, RESULT_FAIL, cases[i].text);
        check_report(export_junit, &f, " message=\"", cases[i].markup, "\"/>\n");
        check_report(export_junit, &f, "<system-err>", cases[i].markup, "</system-err>\n");
        check_report(export_json, &f, ", \"message\": \"", cases[i].json, "\"");
        check_report(export_json, &f, ", \"looks_like\": \"", cases[i].json, "\"");
        check_report(export_json, &f, "\"reason\": \"", cases[i].json, "\"");
        check_report(export_json, &f, "\"messages\": \"", cases[i].json, "\"");
        check_report(export_html, &f, "<p>FAIL 0/4: ", cases[i].markup, "</p>");
        check_report(export_html, &f, "<pre tabindex=0>", cases[i].markup, "</pre>");
        check_report(export_html, &f, "<p>looks like ", cases[i].markup, "; make hint");
        bytes_free(&f.step.messages);
    }
}

/* What is seen of a picture that looks like no mistake. */
static void test_seen(void) {
    struct fixture f;
    set_up(&f, RESULT_FAIL, "");
    snprintf(f.item.seen.text, sizeof f.item.seen.text, "upside down");
    check_report(export_json, &f, ", \"seen\": \"", "upside down", "\"}");
    check_report(export_html, &f, "<aside class=looks><p>", "upside down",
                 "; make hint STEP=05 TASK=5.2</p>");
    bytes_free(&f.step.messages);
}

/* The figures that show what it looks like. */
static void test_figures(void) {
    struct fixture f;
    set_up(&f, RESULT_FAIL, "five");
    check_report(export_json, &f, "\"looks_like\": \"five\"", "}", "");
    f.item.looks_figures[f.item.looks_figure_count++] = 4;
    check_report(export_json, &f, "\"looks_like\": \"five\", \"figures\": [", "4", "]}");
    check_report(export_html, &f, "<p>looks like five: see ", "step05_zbuffer/WRONG.md, figure 4",
                 "; make hint STEP=05 TASK=5.2</p>");
    f.item.looks_figures[f.item.looks_figure_count++] = 12;
    check_report(export_json, &f, "\"looks_like\": \"five\", \"figures\": [", "4, 12", "]}");
    check_report(export_html, &f, "<p>looks like five: see ",
                 "step05_zbuffer/WRONG.md, figure 4 or 12", "; make hint STEP=05 TASK=5.2</p>");
    bytes_free(&f.step.messages);
}

/* A counter's look is written as a picture's is. */
static void test_counters(void) {
    struct fixture f;
    set_up(&f, RESULT_FAIL, "five");
    f.item.counter = "tested";
    f.item.kind = ITEM_COUNTER;
    f.item.counted = 5;
    check_report(export_json, &f, "\"counter\": \"tested\", \"counted\": 5, \"enough\": 0, ", "",
                 "\"message\": \"five\", \"looks_like\": \"five\"");
    check_report(export_html, &f, "<aside class=looks><p>looks like five; make hint STEP=05 ",
                 "TASK=5.2", "</p>\n</aside>\n");
    bytes_free(&f.step.messages);
}

/* How often is a text in another? (Not by strstr(), which the sanitizers make slow.) */
static size_t count_of(const char *text, const char *wanted) {
    size_t count = 0, length = strlen(wanted);
    for (; *text != '\0'; text++) {
        count += strncmp(text, wanted, length) == 0;
    }
    return count;
}

/* Long messages are not cut. */
static void test_long_texts(void) {
    enum { LENGTH = 1 << 16 };
    static const struct {
        export_function *export;
        const char *escaped;
    } cases[] = {
        {export_junit, "&lt;&#39;\n"}, {export_html, "&lt;&#39;\n"}, {export_json, "<'\\n"}};
    struct bytes text = {.data = NULL};
    struct fixture f;
    for (size_t i = 0; i < LENGTH; i++) {
        bytes_append(&text, "<'\n", 3);
    }
    CHECK(bytes_append(&text, "", 1) && text.size == 3 * LENGTH + 1);
    set_up(&f, RESULT_FAIL, "");
    bytes_free(&f.step.messages);
    f.step.messages = text;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char *report = report_of(cases[i].export, &f);
        CHECK(report != NULL && count_of(report, cases[i].escaped) == LENGTH);
        free(report);
    }
    bytes_free(&text);
}

UNIT_MAIN(TEST(test_hostile_texts), TEST(test_seen), TEST(test_figures), TEST(test_counters),
          TEST(test_long_texts))
