/* The quick way to read OBJ files: which files it takes, and that its numbers are the nearest. */
#include "files/obj.h"
#include "files/obj_quick.h"
#include "unit/same_model.h"
#include "unit/unit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* From memory of just that size. */
static enum obj_quick_result read_quickly(struct model *model, const void *text, size_t size) {
    struct error error = {0};
    struct model_reader reader = {.model = model, .error = &error, .parts = MODEL_ALL_PARTS};
    char *copy = malloc(size + 1);
    enum obj_quick_result result = OBJ_QUICK_OUT_OF_MEMORY;
    if (CHECK(copy != NULL)) {
        memcpy(copy + 1, text, size);
        result = obj_quick_read(&reader, copy + 1, size);
    }
    model_reader_free(&reader);
    free(copy);
    return result;
}

/* The model must be the same in the careful way. */
static void check_same(const struct model *quick, const char *text) {
    struct model careful = {0};
    struct error error = {0};
    CHECK_ROW(obj_decode_carefully(&careful, text, strlen(text), MODEL_ALL_PARTS, &error), text);
    CHECK_ROW(same_model(quick, &careful), text);
    model_free(&careful);
}

#define POINTS "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

static void test_what_is_taken(void) {
    static const struct {
        const char *text;
        bool taken;
    } rows[] = {
        {POINTS "f 1 2 3\n", true},
        {"# by hand\no body\n" POINTS "\n  \n usemtl clay\nf\t1  2 3 \n", true},
        {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", true},
        {POINTS "vt 0\nvt 1 0\nvt 0 1 7\nvn 0 0 1\nf 1/1/1 2//1 -1/3\n", true},
        {"v -1.5e-3 +.5 5.\nv 1E2 0 0\nv 0 1 0\nf 1 2 3\n", true},
        {POINTS "f 1 2 3\n\n", true}, /* short lines at the end */
        {POINTS "f 1 2 3\n\n\n\n", true},
        {POINTS "v 1 1 0\nf 1 2 4 3 \n", true}, /* cut into triangles */
        {POINTS "v 2 1 0\nv 1 2 0\nf 1 2 4 5 3\nf 1 3 2\n", true},
        {"v 12345 -1234.5678 +0.12345678\nv 1234 12345678 -.1234\nv 0 0 0\nf 1 2 3\n", true},
        {POINTS "f 1 2 3", false}, /* no line's end at the end */
        {POINTS "f 1 2 3\no body", false},
        {POINTS "o body\\\nf 1 2 3\nf 1 2 3\n", false},
        {POINTS "\vf 1 2 3\nf 1 2 3\n", false},
        {"v 0 0 \\\n0\nv 1 0 0\nf 1 2 2\n", false}, /* joined lines */
        {"v 0 0 0 1 0 0\nv 1 0 0\nf 1 2 2\n", false},
        {"v 0 0 0 # first\n" POINTS "f 1 2 3\n", false},
        {"f 1 2 3\n" POINTS, false}, /* what comes further down */
        {"v 0 0 0\rv 1 0 0\n", false},
        {"\xEF\xBB\xBF" POINTS, false},
        {POINTS "f 1 2\n", false},
        {POINTS "f 1 2 4\n", false},
        {POINTS "f 1 2 3 4\n", false},
        {POINTS "f 1 2 0003\n", true},
        {POINTS "f 1 2 00003\n", true},
        {POINTS "f 1 2 1003\n", false},
        {"v 1 2 000:\n", false},
        {"v 1 2\n\n\n", false}, /* a number is looked for where the line ends */
        {"v 1e5-3 2\n", false},
        {POINTS "f 0 1 2\n", false},
        {POINTS "f -4 1 2\n", false},
        {POINTS "f 1/ 2 3\n", false},
        {POINTS "f 18446744073709551617 2 3\n", false}, /* 2^64 + 1 */
        {POINTS "f 1 2 3x\n", false},
        {POINTS "f\n", false},
        {"v 1 2\n", false},
        {"v 1 2 nan\n", false},
        {"v 1e39 0 0\n", false},
        {"v 1 2 3e\n", false},
        {"v 1 2 .\n", false},
        {"v 12345678901234567890 0 0\n", false},
        {"v 0.1234567890123456789 0 0\n", false},
        {"v 9007199254740993 0 0\n", false}, /* 2^53 + 1 */
        {"v 1e-30 0 0\n", false},
        {"v 1e30 0 0\n", false},
        {"v 1e18446744073709551616 0 0\n", false},
        {"v 1-2 3\n", false},
        {"v 18446744073709551617 0 0\n", false},
        {POINTS "f 1-2 3\n", false},
        {"# \x01\n" POINTS "f 1 2 3\n", false},
        {"v 1\v2 3\n", false},
        {"v 1 2 3x\n" POINTS, false},
        {"vx 1 2 3\n" POINTS, false},
        {"vt1 2 3\n" POINTS, false},
        {"v 1 2 000\xB0\n", false}, /* a zero but for the highest bit */
        {"v 1 2 000\xBA\n", false},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        enum obj_quick_result wanted = rows[i].taken ? OBJ_QUICK_DONE : OBJ_QUICK_DECLINED;
        struct model model = {0};
        enum obj_quick_result result = read_quickly(&model, rows[i].text, strlen(rows[i].text));
        if (CHECK_ROW(result == wanted, rows[i].text) && rows[i].taken) {
            check_same(&model, rows[i].text);
        }
        model_free(&model);
    }
    struct model model = {0};
    CHECK(read_quickly(&model, "", 0) == OBJ_QUICK_DECLINED);
    CHECK(read_quickly(&model, "o \0\n", 4) == OBJ_QUICK_DECLINED);
    model_free(&model);
}

/* A corner more than the quick way takes. */
static void test_many_corners(void) {
    enum { TAKEN = 1000 };
    for (int corners = TAKEN; corners <= TAKEN + 1; corners++) {
        struct bytes text = {0};
        struct model model = {0};
        CHECK(bytes_print(&text, POINTS "f"));
        for (int i = 0; i < corners; i++) {
            CHECK(bytes_print(&text, " 1"));
        }
        CHECK(bytes_print(&text, "\n"));
        enum obj_quick_result result = read_quickly(&model, text.data, text.size);
        CHECK(result == (corners <= TAKEN ? OBJ_QUICK_DONE : OBJ_QUICK_DECLINED));
        model_free(&model);
        bytes_free(&text);
    }
}

/* A file is read in pieces of some 65536 bytes: one line after a comment that fills the first. */
static void test_pieces(void) {
    static const struct {
        const char *text;
        bool taken;
    } rows[] = {
        {"f 1 2 3\n", true},    {"f 1 2 3\n\n", true}, {"f 1 2 3\nf 1 3 2\n", true},
        {"v 1 2\n\n\n", false}, {"o a\\b\n", false},
    };
    for (size_t i = 0; i < 20 * sizeof rows / sizeof rows[0]; i++) {
        struct bytes text = {0};
        struct model model = {0};
        const char *line = rows[i / 20].text;
        int length = 65536 - 10 + (int)(i % 20) - (int)strlen(POINTS);
        CHECK(bytes_print(&text, POINTS "#%*s\n%s", length, "", line));
        enum obj_quick_result wanted = rows[i / 20].taken ? OBJ_QUICK_DONE : OBJ_QUICK_DECLINED;
        enum obj_quick_result result = read_quickly(&model, text.data, text.size);
        if (CHECK_ROW(result == wanted, line) && rows[i / 20].taken) {
            CHECK(bytes_append(&text, "", 1));
            check_same(&model, (const char *)text.data);
        }
        model_free(&model);
        bytes_free(&text);
    }
}

/* Numbers of up to 17 digits and powers of ten to beyond the limits: the nearest doubles. */
static void test_numbers(void) {
    uint32_t seed = 5;
    for (int i = 0; i < 20000; i++) {
        char text[256], number[3][48];
        for (int k = 0; k < 3; k++) {
            seed = seed * 1664525u + 1013904223u;
            unsigned digits = 1 + (seed >> 8) % 17, point = (seed >> 16) % (digits + 1);
            size_t used = (seed >> 28) % 2;
            number[k][0] = '-';
            for (unsigned d = 0; d < digits; d++) {
                seed = seed * 1664525u + 1013904223u;
                if (d == point) {
                    number[k][used++] = '.';
                }
                number[k][used++] = (char)('0' + (seed >> 24) % 10);
            }
            int exponent = (int)((seed >> 12) % 50) - 30;
            number[k][used] = '\0';
            if ((seed >> 20) % 2) {
                snprintf(number[k] + used, sizeof number[k] - used, "e%d", exponent);
            }
        }
        snprintf(text, sizeof text, "v %s %s %s\nf 1 1 1\n", number[0], number[1], number[2]);
        struct model quick = {0};
        struct error error = {0};
        CHECK_ROW(obj_decode(&quick, text, strlen(text), MODEL_ALL_PARTS, &error), text);
        check_same(&quick, text);
        model_free(&quick);
    }
}

UNIT_MAIN(TEST(test_what_is_taken), TEST(test_many_corners), TEST(test_pieces), TEST(test_numbers))
