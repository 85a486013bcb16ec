/*
 * The unit-test harness: each test file is its own program.
 *
 *     static void test_empty(void) { CHECK(list_size(&empty) == 0); }
 *     UNIT_MAIN(TEST(test_empty), TEST(test_full))
 *
 * A failed CHECK prints where and what, and the test goes on. The program prints one line a test
 * and exits with status 1 when any check failed.
 */
#ifndef TESTS_UNIT_UNIT_H
#define TESTS_UNIT_UNIT_H

#include <inttypes.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct unit_test {
    const char *name;
    void (*run)(void);
};

static size_t unit_checks;   /* made so far in the running test */
static size_t unit_failures; /* among them */

static inline bool unit_check(bool holds, const char *file, int line, const char *what) {
    unit_checks++;
    if (!holds) {
        unit_failures++;
        fprintf(stderr, "%s:%d: failed: %s\n", file, line, what);
    }
    return holds;
}

/* True when `condition` holds, so that `if (!CHECK(p != NULL)) return;` guards what follows. */
#define CHECK(condition) unit_check((condition), __FILE__, __LINE__, #condition)

/* CHECK() that names the row of a table which is being tested. */
#define CHECK_ROW(condition, row)                                                                  \
    (unit_check((condition), __FILE__, __LINE__, #condition)                                       \
         ? true                                                                                    \
         : (fprintf(stderr, "    in row: %s\n", (row)), false))

#define CHECK_TEXT(actual, expected) unit_check_text((actual), (expected), __FILE__, __LINE__)

static inline bool unit_check_text(const char *actual, const char *expected, const char *file,
                                   int line) {
    unit_checks++;
    if (strcmp(actual, expected) == 0) {
        return true;
    }
    unit_failures++;
    fprintf(stderr, "%s:%d: got      \"%s\"\n%s:%d: expected \"%s\"\n", file, line, actual, file,
            line, expected);
    return false;
}

/* A struct error: "LINE: MESSAGE" is expected where it has a line, otherwise "MESSAGE". */
#define CHECK_ERROR(error, expected)                                                               \
    unit_check_error((error).line, (error).message, (expected), __FILE__, __LINE__)

static inline bool unit_check_error(size_t error_line, const char *message, const char *expected,
                                    const char *file, int line) {
    char actual[1100];
    snprintf(actual, sizeof actual, "%zu: %s", error_line, message);
    return unit_check_text(error_line > 0 ? actual : message, expected, file, line);
}

#define TEST(function)                                                                             \
    { #function, function }

static inline int unit_run(const struct unit_test *tests, size_t count) {
    size_t failed_tests = 0;
    for (size_t i = 0; i < count; i++) {
        unit_checks = unit_failures = 0;
        tests[i].run();
        bool passed = unit_failures == 0 && unit_checks > 0; /* a test that asserts nothing fails */
        printf("%s %s (%zu checks)\n", passed ? "ok  " : "FAIL", tests[i].name, unit_checks);
        failed_tests += !passed;
    }
    return failed_tests != 0;
}

#define UNIT_MAIN(...)                                                                             \
    int main(void) {                                                                               \
        static const struct unit_test tests[] = {__VA_ARGS__};                                     \
        return unit_run(tests, sizeof tests / sizeof tests[0]);                                    \
    }

#endif
