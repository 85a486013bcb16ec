/* Lines and words of text.h, and its numbers against the C library's strtof() and strtod(), which
 * glibc documents as correctly rounded. */
#include "base/text.h"
#include "unit/images.h"

#include <math.h>

/* ---- Lines and words ---- */

/* Every line's words joined by '|', every line begun with its number: "1:a|b 2:c". */
static void take_apart(const char *data, size_t size, bool continuation, char *out, size_t room) {
    struct text text;
    struct error error;
    out[0] = '\0';
    if (!text_begin(&text, data, size, continuation, &error)) {
        snprintf(out, room, "error %zu: %.200s", error.line, error.message);
        return;
    }
    while (text_next_line(&text)) {
        string_append(out, room, "%s%zu:", out[0] != '\0' ? " " : "", text.line);
        for (bool first = true;; first = false) {
            struct word word = text_next_word(&text);
            if (word.length == 0) {
                break;
            }
            string_append(out, room, "%s%.*s", first ? "" : "|", (int)word.length, word.start);
        }
    }
}

/* What is left of a line has no more words. */
static void test_rest_of_line(void) {
    struct text text;
    struct error error;
    CHECK(text_begin(&text, "a b  c \nd", 9, false, &error) && text_next_line(&text));
    CHECK(word_is(text_next_word(&text), "a") && word_is(text_rest_of_line(&text), "b  c"));
    CHECK(text_next_word(&text).length == 0 && text_next_line(&text));
    CHECK(word_is(text_next_word(&text), "d"));
}

static void test_lines(void) {
    static const struct {
        const char *name, *text;
        size_t size; /* 0: the string's length */
        bool continuation;
        const char *expected;
    } rows[] = {
        {"empty", "", 0, true, ""},
        {"one word, no final newline", "a", 0, true, "1:a"},
        {"words", "  a\tb  c \n", 0, true, "1:a|b|c"},
        {"vertical tab and form feed are blanks", "a\vb\fc", 0, true, "1:a|b|c"},
        {"empty lines count", "\r\n\na\n\n", 0, true, "1: 2: 3:a 4:"},
        {"CRLF", "a\r\nb\r\n", 0, true, "1:a 2:b"},
        {"CR only", "a\rb\r\rc\r", 0, true, "1:a 2:b 3: 4:c"},
        {"mixed line ends", "a\n\rb\r\n\nc", 0, true, "1:a 2: 3:b 4: 5:c"},
        {"comment", "a # b c\nd #\n#e\nf#g", 0, true, "1:a 2:d 3: 4:f#g"},
        {"byte-order mark", "\xEF\xBB\xBFv 1\n", 0, true, "1:v|1"},
        {"byte-order mark alone", "\xEF\xBB\xBF", 0, true, ""},
        {"continued", "a b\\\nc\nd", 0, true, "1:a|b|c 3:d"},
        {"continued with CRLF and CR", "a\\\r\nb\\\rc\r\nd", 0, true, "1:a|b|c 4:d"},
        {"continued twice over an empty line", "a \\\n \\\n b\nc", 0, true, "1:a|b 4:c"},
        {"continued at the end", "a\\", 0, true, "1:a"},
        {"continued over blanks", "a \\ \t\r\nb\\ ", 0, true, "1:a|b"},
        {"not continued over blanks", "a\\ \nb", 0, false, "1:a\\ 2:b"},
        {"zero bytes at the end", "a\nb\0\0", 5, true, "1:a 2:b"},
        {"backslash inside", "a\\b \\ c", 0, true, "1:a\\b|\\|c"},
        {"not continued", "a\\\nb", 0, false, "1:a\\ 2:b"},
        {"comment is not continued", "# c:\\\na", 0, true, "1: 2:a"},
        {"zero byte", "a\nb\r\nc\rd\re\0f", 12, true,
         "error 5: not a text file: it holds a zero byte"},
        {"bytes above 127", "\xEF\xBB\xBE \xFF\n", 0, true, "1:\xEF\xBB\xBE|\xFF"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char got[256];
        size_t size = rows[i].size > 0 ? rows[i].size : strlen(rows[i].text);
        char *copy = exact_copy(rows[i].text, size);
        take_apart(copy, size, rows[i].continuation, got, sizeof got);
        free(copy);
        CHECK_ROW(CHECK_TEXT(got, rows[i].expected), rows[i].name);
    }
}

/* Going to the next line passes over words that were not asked for, and over joined lines. */
static void test_skipped_lines(void) {
    static const char data[] = "g a b \\ \n c # d\nf 1 2 # \\\nv\n";
    struct text text;
    struct error error;
    CHECK(text_begin(&text, data, sizeof data - 1, true, &error));
    CHECK(text_next_line(&text) && text.line == 1);
    CHECK(text_next_line(&text) && text.line == 3);
    CHECK(word_is(text_next_word(&text), "f"));
    CHECK(text_next_line(&text) && text.line == 4);
    CHECK(word_is(text_next_word(&text), "v"));
    CHECK(!text_next_line(&text));
    CHECK(!text_next_line(&text));
    CHECK(!text_begin(&text, "\0 ", 2, true, &error));
    CHECK(text_begin(&text, "v\0\0", 3, true, &error) && text.end == text.next + 1);
    CHECK(text_begin(&text, "", 1, true, &error) && !text_next_line(&text));
    CHECK(text_begin(&text, NULL, 0, true, &error) && !text_next_line(&text));
    CHECK(text_next_word(&text).length == 0);
}

/* One line of 8 MB, as blanks, as one word, as a comment: linear time, or this test never ends. */
static void test_long_line(void) {
    const size_t size = 8 << 20;
    char *data = new_memory(size);
    for (const char *fill = "a #\\"; *fill != '\0'; fill++) {
        memset(data, *fill, size);
        struct text text;
        struct error error;
        size_t words = 0;
        CHECK(text_begin(&text, data, size, true, &error) && text_next_line(&text));
        while (text_next_word(&text).length > 0) {
            words++;
        }
        CHECK(words == (*fill == 'a' || *fill == '\\' ? 1U : 0U));
        CHECK(!text_next_line(&text));
    }
    free(data);
}

static void test_words(void) {
    CHECK(word_is(word_of("vt"), "vt"));
    CHECK(!word_is(word_of("v"), "vt"));
    CHECK(!word_is(word_of("vt"), "v"));
    CHECK(word_is(word_of(""), ""));
    CHECK(word_begins(word_of("aZ"), "Az") && !word_begins((struct word){"abc", 2}, "abc"));
    CHECK_TEXT(word_show(word_of("")).text, "");
    CHECK_TEXT(word_show(word_of("012345678901234567890123456789012345678")).text,
               "012345678901234567890123456789012345678");
    CHECK_TEXT(word_show(word_of("exactly thirty-nine characters long ....")).text,
               "exactly thirty-nine characters long ...");
    CHECK_TEXT(word_show(word_of("0123456789012345678901234567890123456789")).text,
               "012345678901234567890123456789012345...");
    CHECK_TEXT(word_show(word_of("01234567890123456789012345678901234\xE2\x83\xAC 56789")).text,
               "01234567890123456789012345678901234...");
    char strange[51] = ""; /* later bytes of UTF-8 characters without a first one */
    memset(strange, 0x80, 50);
    CHECK_TEXT(word_show(word_of(strange)).text, "...");
    struct error error;
    CHECK(!text_error(&error, 17, "face names vertex %d", 99));
    CHECK_ERROR(error, "17: face names vertex 99");
}

static void test_integers(void) {
    static const struct {
        const char *text;
        bool valid;
        int64_t value;
    } rows[] = {
        {"0", true, 0},
        {"-0", true, 0},
        {"+7", true, 7},
        {"007", true, 7},
        {"-12", true, -12},
        {"4294967297", true, INT64_C(4294967297)},
        {"9223372036854775807", true, INT64_MAX},
        {"-9223372036854775808", true, INT64_MIN},
        {"9223372036854775808", true, INT64_MAX},
        {"-9223372036854775809", true, INT64_MIN},
        {"-9223372036854775810", true, INT64_MIN},
        {"99999999999999999999", true, INT64_MAX},
        {"", false, 0},
        {"-", false, 0},
        {"+-1", false, 0},
        {"1.0", false, 0},
        {"1e3", false, 0},
        {"0x10", false, 0},
        {":", false, 0}, /* the characters next to the digits */
        {"1:", false, 0},
        {"/", false, 0},
        {"1/", false, 0},
        {"1 ", false, 0},
        {"\xD9\xA1", false, 0}, /* an Arabic digit */
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        int64_t value = 0;
        bool valid = word_to_integer(word_of(rows[i].text), &value);
        CHECK_ROW(valid == rows[i].valid && (!valid || value == rows[i].value), rows[i].text);
    }
}

/* ---- Numbers ---- */

static bool same_double(double a, double b) {
    return memcmp(&a, &b, sizeof a) == 0;
}

/* As a word, and as the end of a text of just its size. */
static void check_number(const char *string) {
    double expected = strtod(string, NULL), as_word = 0, in_text = 0;
    size_t length = strlen(string);
    char *copy = exact_copy(string, length);
    struct text text = {.next = copy, .end = copy + length, .line = 1};
    CHECK_ROW(word_to_double((struct word){copy, length}, &as_word) &&
                  same_double(as_word, expected),
              string);
    struct word word = text_next_number(&text, &in_text);
    CHECK_ROW(word.start == copy && word.length == length && text.next == text.end, string);
    CHECK_ROW(same_double(in_text, expected), string);
    free(copy);
}

/* Numbers in a line, and what is none. */
static void test_numbers_of_a_line(void) {
    static const struct {
        const char *text;
        double number[4];
    } rows[] = {
        {"1 -2.5e1\t3\n4", {1, -25, 3, 0}},
        {"1\\\n2 # 3\n4", {1, 2, 0, 0}},
        {"1\\2 3,4 5", {NAN, NAN, 5, 0}},
        {" x 7e 8#", {NAN, NAN, NAN, 0}},
        {"\v.5\f5.\r6", {0.5, 5, 0, 0}},
        {"# 1", {0, 0, 0, 0}},
        {"", {0, 0, 0, 0}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct text text;
        struct error error;
        CHECK(text_begin(&text, rows[i].text, strlen(rows[i].text), true, &error));
        text_next_line(&text);
        for (int k = 0; k < 4; k++) {
            double number = 0, expected = rows[i].number[k];
            bool is_word = text_next_number(&text, &number).length > 0;
            CHECK_ROW(is_word == (expected != 0), rows[i].text);
            CHECK_ROW(!is_word || number == expected || (isnan(number) && isnan(expected)),
                      rows[i].text);
        }
    }
}

/* Among them what is just too large for a product of exact numbers, and middles between doubles. */
static void test_chosen_numbers(void) {
    char numbers[] =
        "0 -0 +0 0.0 -0.0e10 0e999999999999999999999 .5 5. -.5e1 5.e1 1e-30 1E+30 1e0 "
        "1e-0 00012.500 0.1 0.3 9007199254740992 9007199254740993 "
        "9007199254740992.99999999999999999999999 "
        "9007199254740993.00000000000000000000000000000001 1e39 -1e39 "
        "1e400 1e-400 1e99999999999999999999 1e-99999999999999999999 "
        "1.7976931348623158e308 1.7976931348623159e308 7.0064923216240854e-46 "
        "4.9406564584124654e-324 2.4703282292062327e-324 2.4703282292062328e-324 "
        "123456789012345678901234567890 0.000000000000000000000000000000000001 "
        "9999999999999999999 10000000000000000000 18446744073709551616 1e22 1e23 8.5e22 "
        "-1.5e-22 6.02214076e23 ";
    for (const char *number = strtok(numbers, " "); number != NULL; number = strtok(NULL, " ")) {
        check_number(number);
    }
}

/* Many digits before and behind the point that the exponent takes back. */
static void test_long_numbers(void) {
    enum { ZEROS = 100000 };
    char *string = new_memory(ZEROS + 100);
    double d;
    memset(string, '0', ZEROS);
    string[0] = '1';
    strcpy(string + ZEROS, "e-99999");
    CHECK(word_to_double(word_of(string), &d) && d == 1);
    string[0] = '0';
    string[1] = '.';
    strcpy(string + ZEROS, "25e99998");
    CHECK(word_to_double(word_of(string), &d) && d == 0.25);
    /* The middle between 1 and the next double, with one digit far behind that decides. */
    static const char middle[] = "1.00000000000000011102230246251565404236316680908203125";
    memset(string, '0', ZEROS);
    memcpy(string, middle, sizeof middle - 1);
    strcpy(string + ZEROS, "000");
    CHECK(word_to_double(word_of(string), &d) && d == 1);
    strcpy(string + ZEROS, "100");
    CHECK(word_to_double(word_of(string), &d) && d == nextafter(1, 2));
    strcpy(string + ZEROS, "001");
    CHECK(word_to_double(word_of(string), &d) && d == nextafter(1, 2));
    free(string);
    /* (2^53 + 3) 2^-200, the middle between two doubles: to even, up. */
    check_number(
        "5.605193857299270150599501691502176668340263901543335264103923751909304261078426"
        "84285620296406351868330844693771408508708997686653674463741481304168701171875e-45");
}

static void test_refused_numbers(void) {
    static const char *const strings[] = {
        "",      ".",        "-",    "+",    "e5",    ".e5",  "1e",    "1e+",    "1e-",
        "1.2.3", "1,5",      "nan",  "NaN",  "inf",   "-inf", "INF",   "1f",     "0x1p3",
        "1e5.5", "--1",      "+-1",  "1-",   "1d5",   "1e5e", "1 ",    " 1",     "1_0",
        "1e--",  "infinity", ":",    "/",    "1:",    "1/",   "1.:",   "1./",    "1e:",
        "1e/",   "1e1:",     "1e1/", "123:", "1234:", "123/", "1234/", "12345:", "12345/"};
    for (size_t i = 0; i < sizeof strings / sizeof strings[0]; i++) {
        double d;
        CHECK_ROW(!word_to_double(word_of(strings[i]), &d), strings[i]);
    }
}

static void random_digits(char *string, unsigned digits, uint32_t *state) {
    unsigned point = next_random(state) % (digits + 1), reach = next_random(state) % 2 ? 350 : 20;
    for (unsigned i = 0; i < digits; i++) {
        if (i == point) {
            *string++ = '.';
        }
        *string++ = (char)('0' + (next_random(state) % 3 == 0 ? 0 : next_random(state) % 10));
    }
    sprintf(string, "e%d", (int)(next_random(state) % (2 * reach)) - (int)reach);
}

/* Digits of any number, of which few are exact by a product and many have to be copied. */
static void test_random_numbers(void) {
    char string[2048];
    uint32_t state = 9;
    for (unsigned i = 0; i < 30000; i++) {
        random_digits(string, next_random(&state) % (i % 64 == 0 ? 1500 : 24) + 1, &state);
        check_number(string);
    }
}

/* Characters of each length, at both ends of it, and a pair, in either order of bytes. */
static void test_utf16(void) {
    static const struct {
        uint16_t units[4];
        const char *utf8;
    } rows[] = {
        {{'v', ' ', '1', '\n'}, "v 1\n"},
        {{0x7F, 0x80, 0x7FF, 0x800}, "\x7F\xC2\x80\xDF\xBF\xE0\xA0\x80"},
        {{0xE000, 0xFFFD, 0xD83D, 0xDE00}, "\xEE\x80\x80\xEF\xBF\xBD\xED\xA0\xBD\xED\xB8\x80"},
    };
    CHECK(!text_is_utf16("v 1", 4) && !text_is_utf16("\0v\0v", 3) && !text_is_utf16("\0v\0\0", 4));
    CHECK(!text_is_utf16("v\0\0\0", 4) && !text_is_utf16("\0\0\0\0", 4));
    CHECK(!text_is_utf16("\xFF\xFE", 1) && text_is_utf16("\xFF\xFE", 2) && !text_is_utf16(NULL, 0));
    CHECK(!text_is_utf16("\xFF\xFF", 2) && !text_is_utf16("\xFE\xFE", 2));
    CHECK(text_is_utf16("\0\1\0\1", 4) && text_is_utf16("\1\0\1\0", 4));
    for (size_t i = 0; i < sizeof rows / sizeof rows[0] * 4; i++) {
        const unsigned high = i & 1, odd = i >> 1 & 1; /* the first byte is the larger part */
        struct bytes utf8 = {0}, utf16 = {0};
        for (int k = -1; k < 4; k++) {
            unsigned unit = k < 0 ? 0xFEFF : rows[i / 4].units[k];
            unsigned char pair[] = {(unsigned char)(unit >> 8 * high), (unsigned char)(unit >> 8)};
            pair[1] = high ? (unsigned char)unit : pair[1];
            CHECK(bytes_append(&utf16, pair, 2));
        }
        CHECK(bytes_append(&utf16, "!", odd));
        unsigned char *exact = malloc(utf16.size);
        memcpy(exact, utf16.data, utf16.size);
        CHECK(text_is_utf16(exact, utf16.size) && text_from_utf16(&utf8, exact, utf16.size));
        CHECK(bytes_append(&utf8, "", 1));
        CHECK_TEXT((const char *)utf8.data, rows[i / 4].utf8);
        if (i / 4 == 0) { /* letters alone, without the mark before them */
            bytes_free(&utf8);
            utf8 = (struct bytes){0};
            CHECK(text_is_utf16(exact + 2, 8) && text_from_utf16(&utf8, exact + 2, 8));
            CHECK(utf8.size == 4 && memcmp(utf8.data, "v 1\n", 4) == 0);
        }
        free(exact);
        bytes_free(&utf8);
        bytes_free(&utf16);
    }
    struct bytes daggers = {0}; /* of three bytes each, and just as much room */
    char blanks[200];
    memset(blanks, ' ', sizeof blanks);
    CHECK(text_from_utf16(&daggers, blanks, 200) && daggers.size == 300 && daggers.capacity == 300);
    bytes_free(&daggers);
}

UNIT_MAIN(TEST(test_rest_of_line), TEST(test_utf16), TEST(test_lines), TEST(test_skipped_lines),
          TEST(test_long_line), TEST(test_words), TEST(test_integers), TEST(test_numbers_of_a_line),
          TEST(test_chosen_numbers), TEST(test_long_numbers), TEST(test_refused_numbers),
          TEST(test_random_numbers))
