/* Tests of reading options: whatever the order, and what is wrong is named. */
#include "arguments.h"
#include "unit/unit.h"

#include <string.h>

enum { ARGUMENT_LIMIT = 8 };

static void test_command_lines(void) {
    static const struct {
        const char *line, *others; /* what is no option */
        const char *text;
        size_t number;
        bool flag;
        const char *error;
    } cases[] = {
        {"", "", "none", 1, false, ""},
        {"a b", "a b", "none", 1, false, ""},
        {"--text t --number 12 --flag", "", "t", 12, true, ""},
        {"a --flag b --text t c", "a b c", "t", 1, true, ""},
        {"--text --flag", "", "--flag", 1, false, ""},
        {"--text t --text u", "", "u", 1, false, ""},
        {"--number 1000000000 --", "", "none", 1000000000, false, ""},
        {"--flag -- --text -- a", "--text -- a", "none", 1, true, ""},
        {"--nonsense", "", NULL, 0, false, "unknown option '--nonsense'"},
        {"-", "", NULL, 0, false, "unknown option '-'"},
        {"--text", "", NULL, 0, false, "--text needs a value"},
        {"--number 0", "", NULL, 0, false, "--number 0: not understood"},
        {"--number 1000000001", "", NULL, 0, false, "--number 1000000001: not understood"},
        {"--number 3x", "", NULL, 0, false, "--number 3x: not understood"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char words[128], program[] = "program", others[128] = "", *argv[ARGUMENT_LIMIT] = {program};
        const char *text = "none";
        size_t number = 1;
        bool flag = false;
        int argc = 1;
        struct error error = {.message = ""};
        const struct argument known[] = {
            {"--text", "TEXT", "", argument_text, &text},
            {"--number", "N", "", argument_number, &number},
            {"--flag", "", "", argument_flag, &flag},
        };
        snprintf(words, sizeof words, "%s", cases[i].line);
        for (char *word = strtok(words, " "); word != NULL; word = strtok(NULL, " ")) {
            argv[argc++] = word;
        }
        int count = arguments_read(known, 3, argc, argv, &error);
        CHECK_TEXT(error.message, cases[i].error);
        CHECK_ROW((count < 0) == (cases[i].text == NULL), cases[i].line);
        for (int k = 1; k <= count; k++) {
            strcat(strcat(others, k > 1 ? " " : ""), argv[k]);
        }
        CHECK_TEXT(others, cases[i].others);
        if (cases[i].text != NULL) {
            CHECK_TEXT(text, cases[i].text);
            CHECK_ROW(number == cases[i].number && flag == cases[i].flag, cases[i].line);
            CHECK_ROW(argv[count + 1] == NULL, cases[i].line);
        }
    }
}

static void test_help_is_wanted(void) {
    char program[] = "program", help[] = "--help", h[] = "-h", flag[] = "--flag";
    CHECK(arguments_want_help(2, (char *[]){program, help, NULL}));
    CHECK(arguments_want_help(2, (char *[]){program, h, NULL}));
    CHECK(!arguments_want_help(2, (char *[]){program, flag, NULL}));
    CHECK(!arguments_want_help(3, (char *[]){program, help, flag, NULL}));
    CHECK(!arguments_want_help(1, (char *[]){program, NULL}));
}

UNIT_MAIN(TEST(test_command_lines), TEST(test_help_is_wanted))
