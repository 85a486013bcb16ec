/* Lines, words and exact numbers; see text.h. */
#include "base/text.h"

#include "base/exact.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- Messages ---- */

struct shown_word word_show(struct word word) {
    struct shown_word shown = {{0}};
    size_t room = sizeof shown.text - 1;
    if (word.length <= room) {
        memcpy(shown.text, word.start, word.length);
        return shown;
    }
    size_t length = room - 3;
    /* Do not cut a UTF-8 character in two: its later bytes are 10xxxxxx. */
    while (length > 0 && ((unsigned char)word.start[length] & 0xC0) == 0x80) {
        length--;
    }
    memcpy(shown.text, word.start, length);
    memcpy(shown.text + length, "...", 3);
    return shown;
}

bool text_error(struct error *error, size_t line, const char *format, ...) {
    char message[sizeof error->message];
    va_list arguments;
    va_start(arguments, format);
    if (vsnprintf(message, sizeof message, format, arguments) < 0) {
        message[0] = '\0';
    }
    va_end(arguments);
    error_set(error, "%s", message);
    error->line = line;
    return false;
}

/* ---- Lines and words ---- */

static bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* One past the line's end that stands at p (nothing, at the end of the text). */
static const char *over_line_end(const char *p, const char *end) {
    if (p < end && *p == '\r') {
        p++;
        return p < end && *p == '\n' ? p + 1 : p;
    }
    return p < end ? p + 1 : p;
}

void text_peek(struct text *text, const void *data, size_t size) {
    const char *start = data;
    *text = (struct text){.next = NULL};
    if (size > 0) { /* otherwise `data` may be NULL, on which nothing may be computed */
        text->end = start + size;
        text->next = start + (size >= 3 && memcmp(start, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0);
    }
}

bool text_begin(struct text *text, const void *data, size_t size, bool continuation,
                struct error *error) {
    const char *start = data;
    text_peek(text, data, size);
    text->continuation = continuation;
    const char *nul = size > 0 ? memchr(start, '\0', size) : NULL;
    if (nul != NULL) {
        size_t line = 1;
        for (const char *p = start; p < nul; p++) {
            line += *p == '\n' || (*p == '\r' && p[1] != '\n');
        }
        return text_error(error, line, "not a text file: it holds a zero byte");
    }
    return true;
}

bool text_next_line(struct text *text) {
    if (text->line > 0) {
        while (text_next_word(text).length > 0) {
        }
        text->next = over_line_end(text->next, text->end);
    }
    if (text->next == text->end) {
        return false;
    }
    text->line++;
    return true;
}

/* Does the backslash at p join this line with the next one? */
static bool joins_lines(const struct text *text, const char *p) {
    return text->continuation && *p == '\\' && (p + 1 == text->end || is_line_end(p[1]));
}

static const char *over_blanks(struct text *text) {
    const char *p = text->next;
    while (p < text->end) {
        if (is_blank(*p)) {
            p++;
        } else if (joins_lines(text, p)) {
            p = over_line_end(p + 1, text->end);
            text->line++;
        } else {
            break;
        }
    }
    return p;
}

struct word text_next_word(struct text *text) {
    const char *p = over_blanks(text);
    if (p < text->end && *p == '#') {
        while (p < text->end && !is_line_end(*p)) {
            p++;
        }
    }
    const char *start = p;
    while (p < text->end && !is_blank(*p) && !is_line_end(*p) && !joins_lines(text, p)) {
        p++;
    }
    text->next = p;
    return (struct word){start, start == NULL ? 0 : (size_t)(p - start)};
}

bool word_is(struct word word, const char *string) {
    size_t length = strlen(string);
    return word.length == length && (length == 0 || memcmp(word.start, string, length) == 0);
}

/* ---- Integers ---- */

bool word_to_integer(struct word word, int64_t *value) {
    size_t i = 0;
    bool negative = word.length > 0 && word.start[0] == '-';
    if (word.length > 0 && (word.start[0] == '-' || word.start[0] == '+')) {
        i++;
    }
    if (i == word.length) {
        return false;
    }
    int64_t result = 0; /* kept negative: there is one more number below zero than above */
    for (; i < word.length; i++) {
        if (!is_digit(word.start[i])) {
            return false;
        }
        int digit = word.start[i] - '0';
        if (result < (INT64_MIN + digit) / 10) {
            return false;
        }
        result = result * 10 - digit;
    }
    if (!negative && result == INT64_MIN) {
        return false;
    }
    *value = negative ? result : -result;
    return true;
}

/* ---- Decimal numbers: the digits ---- */

enum {
    HEAD_DIGITS = 19,  /* any 19 digits fit 64 bits */
    SLOW_DIGITS = 800, /* more digits than lie between two doubles: 767 (see below) */
    FAST_EXPONENT = 22 /* 10^22 is the largest power of ten that is exact in a double */
};

/* A decimal number taken apart: head * 10^exponent, and the digits after `head` on top of that. */
struct decimal {
    bool negative;
    uint64_t head;     /* the first HEAD_DIGITS significant digits */
    size_t count;      /* significant digits in all, from the first that is not 0 */
    int64_t exponent;  /* of ten, for the last digit of `head` */
    const char *first; /* the first significant digit */
    const char *end;   /* where the digits and their point end */
};

static size_t head_count(const struct decimal *decimal) {
    return decimal->count < HEAD_DIGITS ? decimal->count : HEAD_DIGITS;
}

/* [+-] digits, with at least one digit, up to `end`; of a huge one, some huge number. */
static bool read_exponent(const char *p, const char *end, int64_t *exponent) {
    const int64_t huge = INT64_C(100000000000000000);
    bool negative = p < end && *p == '-';
    if (p < end && (*p == '-' || *p == '+')) {
        p++;
    }
    if (p == end) {
        return false;
    }
    int64_t value = 0;
    for (; p < end; p++) {
        if (!is_digit(*p)) {
            return false;
        }
        value = value < huge ? value * 10 + (*p - '0') : value;
    }
    *exponent += negative ? -value : value;
    return true;
}

static bool decimal_parse(struct decimal *decimal, struct word word) {
    const char *p = word.start;
    const char *end = word.start + word.length;
    *decimal = (struct decimal){0};
    if (*p == '-' || *p == '+') {
        decimal->negative = *p == '-';
        p++;
    }
    bool any_digit = false, after_point = false;
    for (; p < end; p++) {
        if (*p == '.' && !after_point) {
            after_point = true;
            continue;
        }
        if (!is_digit(*p)) {
            break;
        }
        any_digit = true;
        if (decimal->count == 0 && *p != '0') {
            decimal->first = p;
        }
        if (decimal->first == NULL) { /* a leading zero only moves the point */
            decimal->exponent -= after_point;
            continue;
        }
        if (decimal->count < HEAD_DIGITS) {
            decimal->head = decimal->head * 10 + (uint64_t)(*p - '0');
            decimal->exponent -= after_point;
        } else {
            decimal->exponent += !after_point;
        }
        decimal->count++;
    }
    decimal->end = p;
    if (!any_digit || p == end) {
        return any_digit;
    }
    return (*p == 'e' || *p == 'E') && read_exponent(p + 1, end, &decimal->exponent);
}

/* ---- Decimal numbers: the exact way, with large integers ---- */

/* The largest number that is needed is below 10^1124 * 4 (see decimal_to_double): 3737 bits. */
enum { BIG_LIMBS = 120 };

/* A natural number in base 2^32, lowest limb first; the highest limb in use is not 0. */
struct big {
    uint32_t limb[BIG_LIMBS];
    int count;
};

/* big * factor + addend */
static void big_multiply_add(struct big *big, uint32_t factor, uint32_t addend) {
    uint64_t carry = addend;
    for (int i = 0; i < big->count; i++) {
        carry += (uint64_t)big->limb[i] * factor;
        big->limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry > 0) {
        assert(big->count < BIG_LIMBS);
        big->limb[big->count++] = (uint32_t)carry;
    }
}

static void big_times_power_of_ten(struct big *big, int64_t power) {
    for (; power >= 9; power -= 9) {
        big_multiply_add(big, 1000000000, 0);
    }
    for (; power > 0; power--) {
        big_multiply_add(big, 10, 0);
    }
}

static int big_bits(const struct big *big) {
    int bits = (big->count - 1) * 32;
    for (uint32_t top = big->limb[big->count - 1]; top > 0; top >>= 1) {
        bits++;
    }
    return bits;
}

static void big_shift_left(struct big *big, int bits) {
    int limbs = bits / 32;
    assert(big->count + limbs <= BIG_LIMBS);
    memmove(big->limb + limbs, big->limb, (size_t)big->count * sizeof big->limb[0]);
    memset(big->limb, 0, (size_t)limbs * sizeof big->limb[0]);
    big->count += limbs;
    big_multiply_add(big, UINT32_C(1) << bits % 32, 0);
}

/* Negative, 0 or positive as a is below, equal to or above b. */
static int big_compare(const struct big *a, const struct big *b) {
    if (a->count != b->count) {
        return a->count - b->count;
    }
    for (int i = a->count - 1; i >= 0; i--) {
        if (a->limb[i] != b->limb[i]) {
            return a->limb[i] < b->limb[i] ? -1 : 1;
        }
    }
    return 0;
}

/* a - b, where a >= b */
static void big_subtract(struct big *a, const struct big *b) {
    uint64_t borrow = 0;
    for (int i = 0; i < a->count; i++) {
        uint64_t take = (i < b->count ? b->limb[i] : 0) + borrow;
        borrow = a->limb[i] < take;
        a->limb[i] = (uint32_t)(a->limb[i] - take);
    }
    while (a->count > 0 && a->limb[a->count - 1] == 0) {
        a->count--;
    }
}

/* What a double can hold. */
enum {
    SIGNIFICAND_BITS = 53,
    LEAST_EXPONENT = -1074, /* of two, for the last bit of a subnormal */
    HIGHEST_POINT = 309,    /* 10^HIGHEST_POINT overflows for certain */
    LOWEST_POINT = -324     /* what is below 10^LOWEST_POINT is nearer to 0 than to anything */
};

/* The first SLOW_DIGITS digits as one number, and the exponent of its last digit. A middle between
 * two doubles has at most 768 significant digits, so of the digits after SLOW_DIGITS it only
 * matters whether one is not 0: a final digit 1 stands for them. */
static struct big big_digits(const struct decimal *decimal, int64_t *exponent) {
    struct big digits = {.count = 0};
    size_t used = 0;
    *exponent = decimal->exponent + (int64_t)head_count(decimal);
    for (const char *p = decimal->first; p < decimal->end; p++) {
        if (*p == '.') {
            continue;
        }
        if (used < SLOW_DIGITS || *p != '0') {
            big_multiply_add(&digits, 10, used < SLOW_DIGITS ? (uint32_t)(*p - '0') : 1);
            *exponent -= 1;
            used++;
        }
        if (used > SLOW_DIGITS) {
            break;
        }
    }
    return digits;
}

/* The nearest double, ties to even: the quotient of two large integers by long
 * division in base 2, one bit after the other, and the remainder compared with one half. */
static double decimal_to_double(const struct decimal *decimal) {
    int64_t point = decimal->exponent + (int64_t)head_count(decimal); /* value < 10^point */
    if (decimal->head == 0 || point <= LOWEST_POINT) {
        return 0;
    }
    if (point > HIGHEST_POINT) {
        return INFINITY;
    }
    int64_t exponent10;
    struct big value = big_digits(decimal, &exponent10);
    struct big divisor = {.limb = {1}, .count = 1};
    big_times_power_of_ten(exponent10 < 0 ? &divisor : &value,
                           exponent10 < 0 ? -exponent10 : exponent10);

    /* Scale by a power of two to 1 <= value / divisor < 2. */
    int exponent2 = big_bits(&value) - big_bits(&divisor);
    big_shift_left(exponent2 < 0 ? &value : &divisor, exponent2 < 0 ? -exponent2 : exponent2);
    if (big_compare(&value, &divisor) < 0) {
        big_shift_left(&value, 1);
        exponent2--;
    }

    int last_exponent = exponent2 - (SIGNIFICAND_BITS - 1);
    if (last_exponent < LEAST_EXPONENT) {
        last_exponent = LEAST_EXPONENT; /* a subnormal has fewer bits */
    }
    uint64_t quotient = 0;
    for (int i = exponent2; i >= last_exponent; i--) {
        quotient *= 2;
        if (big_compare(&value, &divisor) >= 0) {
            big_subtract(&value, &divisor);
            quotient++;
        }
        big_shift_left(&value, 1);
    }
    if (exponent2 < last_exponent - 1) { /* less than half of the smallest subnormal */
        return 0;
    }
    int half = big_compare(&value, &divisor); /* the remainder, doubled, against one */
    quotient += half > 0 || (half == 0 && quotient % 2 == 1);
    double result = ldexp((double)quotient, last_exponent);
    return result > DBL_MAX ? INFINITY : result;
}

/* ---- Decimal numbers: the fast ways ---- */

/* Powers of ten that are exact; for -FAST_EXPONENT to FAST_EXPONENT. */
static double power_of_ten(int64_t exponent) {
    static const double power[FAST_EXPONENT + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    return power[exponent < 0 ? -exponent : exponent];
}

/* With at most 15 digits (or 53 bits) one division or multiplication rounds once (Clinger, "How to
 * read floating point numbers accurately", 1990). */
static bool fast_double(const struct decimal *decimal, double *value) {
    if (decimal->count > HEAD_DIGITS || decimal->head > UINT64_C(1) << 53) {
        return false;
    }
    double head = (double)decimal->head, power = power_of_ten(decimal->exponent);
    *value = decimal->exponent < 0 ? head / power : head * power;
    return true;
}

/* With more digits the head is two doubles, and so is the quotient or product: `rounded` and,
 * nearly as exact again, `rest`. That is enough, unless it lies too near the middle between two
 * doubles. */
static bool fair_double(const struct decimal *decimal, double *value) {
    double high = (double)decimal->head, power = power_of_ten(decimal->exponent);
    double low = (double)(int64_t)(decimal->head - (uint64_t)high);
    double rounded = decimal->exponent < 0 ? high / power : high * power;
    double rest;
    if (decimal->exponent < 0) {
        struct exact back = exact_product(rounded, power);
        rest = (high - back.rounded - back.rest + low) / power;
    } else {
        rest = exact_product(high, power).rest + low * power;
    }
    /* The head has 10^18 or more, if digits after it were left out. */
    double margin = rounded * (decimal->count > HEAD_DIGITS ? 1.1e-18 : 1e-30);
    *value = rounded + (rest + margin);
    return rounded + (rest - margin) == *value;
}

/* The fast ways need powers of ten that are exact, and arithmetic in plain double. */
static bool is_ordinary(const struct decimal *decimal) {
    return FLT_EVAL_METHOD == 0 && decimal->exponent >= -FAST_EXPONENT &&
           decimal->exponent <= FAST_EXPONENT;
}

bool word_to_double(struct word word, double *value) {
    struct decimal decimal;
    if (word.length == 0 || !decimal_parse(&decimal, word)) {
        return false;
    }
    double magnitude;
    if (!is_ordinary(&decimal) ||
        (!fast_double(&decimal, &magnitude) && !fair_double(&decimal, &magnitude))) {
        magnitude = decimal_to_double(&decimal);
    }
    *value = decimal.negative ? -magnitude : magnitude;
    return true;
}
