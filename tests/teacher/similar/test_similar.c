/* Tokens, fingerprints, what is common knowledge, and which pairs are listed. */
#include "common.h"
#include "matches.h"
#include "pairs.h"

#include "unit/unit.h"

#include <stdlib.h>

/* ---- Tokens ---- */

static struct tokens read_tokens(const char *text) {
    struct tokens tokens = {0};
    CHECK(tokens_append(&tokens, (const unsigned char *)text, strlen(text), 1));
    return tokens;
}

static bool are_alike(const char *text, const char *other) {
    struct tokens a = read_tokens(text), b = read_tokens(other);
    bool alike = a.count == b.count;
    for (size_t i = 0; i < a.count && alike; i++) {
        alike = a.all[i].code == b.all[i].code;
    }
    tokens_free(&a);
    tokens_free(&b);
    return alike;
}

static void test_what_does_not_count(void) {
    static const struct {
        const char *text, *other;
    } alike[] = {
        {"int sum = a + b;", "int\ttotal=left+right ;"},
        {"f(x); /* one */ g(y);", "h(z); // two\n k(w);"},
        {"x = 0x1p-3 + .5e+7f;", "x = 1 + 2;"},
        {"puts(\"/* no comment */\");", "puts(\"a \\\" b\");"},
        {"c = '\\'';", "c = '\"';"},
        {"a // goes on \\\n here\n + b", "a + b"},
        {"a /* goes on // \n */ + b", "a + b"},
        {"#define A \\\r\n 1\r\n", "#define B 2\n"},
        {"f\\\n(x)", "f(x)"},
        {"gr\xc3\xb6\xc3\x9f"
         "e = 1;",
         "size = 1;"},
        {"", "  \n\t /* nothing"},
    };
    for (size_t i = 0; i < sizeof alike / sizeof alike[0]; i++) {
        CHECK_ROW(are_alike(alike[i].text, alike[i].other), alike[i].text);
    }
}

static void test_what_counts(void) {
    static const struct {
        const char *text, *other;
    } different[] = {
        {"while (a) b;", "if (a) b;"},
        {"a + b;", "a - b;"},
        {"int a;", "double a;"},
        {"f(a);", "f(1);"},
        {"f('a');", "f(\"a\");"},
        {"a = b;", "a == b;"},
        {"/* a */ b /* c */", "/* a"},
        {"\"a\n b c", "\"a\" b"},
        {"a->b", "a.b"},
        {"structure a;", "struct a;"},
    };
    for (size_t i = 0; i < sizeof different / sizeof different[0]; i++) {
        CHECK_ROW(!are_alike(different[i].text, different[i].other), different[i].text);
    }
}

static void test_lines(void) {
    struct tokens tokens = read_tokens("a\n/* \n\n */ b \"x\\\ny\" c\nd // \\\n\ne '\n f");
    static const size_t lines[] = {1, 4, 4, 5, 6, 8, 8, 9};
    CHECK(tokens.count == sizeof lines / sizeof lines[0]);
    for (size_t i = 0; i < tokens.count && i < sizeof lines / sizeof lines[0]; i++) {
        CHECK(tokens.all[i].line == lines[i]);
    }
    tokens_free(&tokens);
}

/* ---- Fingerprints ---- */

static uint64_t next_random(uint64_t *state) {
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return *state >> 33;
}

/* Tokens of `kinds` kinds, one a line. */
static struct tokens draw_tokens(uint64_t seed, size_t count, uint64_t kinds) {
    struct tokens tokens = {calloc(count + 1, sizeof(struct token)), count, count};
    for (size_t i = 0; i < count; i++) {
        tokens.all[i] = (struct token){next_random(&seed) % kinds, i + 1};
    }
    return tokens;
}

static struct fingerprints choose(const struct tokens *tokens, const struct set *given) {
    struct fingerprints chosen = {0};
    CHECK(fingerprints_choose(&chosen, tokens, given));
    return chosen;
}

static size_t count_shared(const struct fingerprints *a, const struct fingerprints *b) {
    size_t count = 0;
    for (size_t i = 0; i < a->count; i++) {
        for (size_t k = 0; k < b->count; k++) {
            count += a->all[i].hash == b->all[k].hash;
        }
    }
    return count;
}

/* How many fingerprints two long texts share that have a run of this length in common. */
static size_t share_run(uint64_t seed, size_t length) {
    const struct set nothing = {0};
    struct tokens a = draw_tokens(seed, 200, 1000), b = draw_tokens(seed + 1, 300, 1000);
    for (size_t i = 0; i < length; i++) {
        b.all[200 + i].code = a.all[50 + i].code;
    }
    struct fingerprints first = choose(&a, &nothing), second = choose(&b, &nothing);
    size_t shared = count_shared(&first, &second);
    fingerprints_free(&first);
    fingerprints_free(&second);
    tokens_free(&a);
    tokens_free(&b);
    return shared;
}

/* The promise of winnowing: no long run is missed, and no short one is seen. */
static void test_winnowing(void) {
    for (uint64_t seed = 0; seed < 300; seed++) {
        CHECK(share_run(seed * 2, GRAM_TOKENS + WINDOW_GRAMS - 1) >= 1);
        CHECK(share_run(seed * 2, GRAM_TOKENS - 1) == 0);
    }
}

static void test_density(void) {
    const struct set nothing = {0};
    struct tokens tokens = draw_tokens(5, 60000, 1000);
    struct fingerprints chosen = choose(&tokens, &nothing);
    double expected = 2.0 / (WINDOW_GRAMS + 1) * 60000; /* the paper's density */
    CHECK((double)chosen.count > expected * 0.95 && (double)chosen.count < expected * 1.05);
    fingerprints_free(&chosen);
    tokens_free(&tokens);
}

/* Of equal hashes one in a window is enough. */
static void test_repetition(void) {
    const struct set nothing = {0};
    struct tokens tokens = draw_tokens(5, 10000, 1);
    struct fingerprints chosen = choose(&tokens, &nothing);
    CHECK(chosen.count > 0 && chosen.count <= 10000 / WINDOW_GRAMS + 1);
    fingerprints_free(&chosen);
    tokens_free(&tokens);
}

static void test_short(void) {
    const struct set nothing = {0};
    for (size_t count = 0; count < GRAM_TOKENS + 3; count++) {
        struct tokens tokens = draw_tokens(5, count, 1000);
        struct fingerprints chosen = choose(&tokens, &nothing);
        CHECK(chosen.count == (count >= GRAM_TOKENS));
        fingerprints_free(&chosen);
        tokens_free(&tokens);
    }
}

/* A text with something of one's own in lines 101 to 200 of it. */
static void test_given(void) {
    struct set given = {0};
    struct tokens course = draw_tokens(5, 200, 1000), own = draw_tokens(6, 300, 1000);
    CHECK(fingerprints_give(&given, &course));
    set_sort(&given);
    struct fingerprints nothing = choose(&course, &given);
    CHECK(nothing.count == 0);
    for (size_t i = 0; i < 100; i++) {
        own.all[i].code = course.all[i].code;
        own.all[200 + i].code = course.all[100 + i].code;
    }
    struct fingerprints chosen = choose(&own, &given);
    CHECK(chosen.count > 20);
    for (size_t i = 0; i < chosen.count; i++) {
        CHECK(chosen.all[i].first > 100 && chosen.all[i].last <= 200);
    }
    fingerprints_free(&nothing);
    fingerprints_free(&chosen);
    tokens_free(&course);
    tokens_free(&own);
    set_free(&given);
}

static void test_any_bytes(void) {
    static const char pieces[][4] = {"/*", "*/", "//", "\\\n", "\"", "'",  "\n",   "\r\n",
                                     "a",  "1",  ".",  "->",   "{",  "\\", "\xff", "#"};
    const struct set nothing = {0};
    for (uint64_t seed = 0; seed < 300; seed++) {
        struct bytes text = {0};
        uint64_t state = seed;
        for (size_t i = 0; i < 200; i++) {
            uint64_t piece = next_random(&state);
            CHECK(bytes_append(&text, pieces[piece % 16],
                               piece % 17 == 0 ? 1 : strlen(pieces[piece % 16])));
        }
        struct tokens tokens = {0};
        CHECK(tokens_append(&tokens, text.data, text.size, 1));
        for (size_t i = 1; i < tokens.count; i++) {
            CHECK(tokens.all[i - 1].line <= tokens.all[i].line);
        }
        struct fingerprints chosen = choose(&tokens, &nothing);
        fingerprints_free(&chosen);
        tokens_free(&tokens);
        bytes_free(&text);
    }
}

/* ---- A class ---- */

/* A class of one or more lessons without anything in them. */
static struct class make_class(size_t submission_count, size_t lesson_count) {
    struct class class = {.submission_count = submission_count};
    class.lessons.count = lesson_count;
    class.lessons.all = calloc(lesson_count, sizeof *class.lessons.all);
    class.submissions = calloc(submission_count + 1, sizeof *class.submissions);
    for (size_t i = 0; i < submission_count; i++) {
        class.submissions[i].lessons = calloc(lesson_count, sizeof(struct fingerprints));
    }
    return class;
}

/* Add a run of tokens that is drawn from the seed. */
static void add_text(struct class *class, size_t submission, size_t lesson, uint64_t seed,
                     size_t token_count) {
    const struct set nothing = {0};
    struct tokens tokens = draw_tokens(seed, token_count, 1000);
    CHECK(fingerprints_choose(&class->submissions[submission].lessons[lesson], &tokens, &nothing));
    tokens_free(&tokens);
}

/* The pairs that are listed once what is common knowledge is gone. */
static struct pairs list_pairs(struct class *class) {
    const struct limits limits = {DEFAULT_PERCENT_OF_ALL / 100.0,
                                  DEFAULT_PERCENT_OF_LESSON / 100.0};
    struct pairs pairs = {0};
    CHECK(common_forget(class) && pairs_find(&pairs, class, limits));
    return pairs;
}

static void test_copy_is_listed(void) {
    struct class class = make_class(5, 2);
    for (size_t i = 0; i < 5; i++) {
        add_text(&class, i, 0, i == 3 ? 1 : i, 300); /* 3 has what 1 has */
        add_text(&class, i, 1, i == 3 ? 101 : i + 100, 300);
    }
    struct pairs pairs = list_pairs(&class);
    CHECK(pairs.count == 1);
    if (pairs.count == 1) {
        CHECK(pairs.all[0].a == 1 && pairs.all[0].b == 3 && pairs.all[0].lesson_count == 2);
        CHECK(pairs.all[0].all.shared == pairs.all[0].all.of_a);
        CHECK(common_share(pairs.all[0].all) == 1);
    }
    pairs_free(&pairs);
    class_free(&class);
}

/* Half of all is enough in two lessons, not in one; four fifths of one lesson are. */
static void test_limits(void) {
    struct class class = make_class(6, 2);
    for (size_t lesson = 0; lesson < 2; lesson++) {
        add_text(&class, 0, lesson, 10 + lesson, 260); /* 0 and 1: a bit more than half of both */
        add_text(&class, 1, lesson, 10 + lesson, 260);
        add_text(&class, 0, lesson, 20 + lesson, 200);
        add_text(&class, 1, lesson, 30 + lesson, 200);
    }
    add_text(&class, 2, 0, 40, 260); /* 2 and 3: as much, of the only lesson */
    add_text(&class, 3, 0, 40, 260);
    add_text(&class, 2, 0, 41, 200);
    add_text(&class, 3, 0, 42, 200);
    add_text(&class, 4, 0, 50, 300); /* 4 and 5: one lesson, and another is their own */
    add_text(&class, 5, 0, 50, 300);
    add_text(&class, 4, 1, 51, 900);
    add_text(&class, 5, 1, 52, 900);
    struct pairs pairs = list_pairs(&class);
    CHECK(pairs.count == 2);
    if (pairs.count == 2) {
        CHECK(pairs.all[0].a == 0 && pairs.all[0].b == 1);
        CHECK(pairs.all[1].a == 4 && pairs.all[1].b == 5 && pairs.all[1].most_lesson == 0);
    }
    pairs_free(&pairs);
    class_free(&class);
}

/* Who copied all, and wrote as much again and again, is found with what was copied. */
static void test_part_of_more(void) {
    struct class class = make_class(2, 1);
    add_text(&class, 0, 0, 1, 300);
    add_text(&class, 1, 0, 1, 300);
    add_text(&class, 1, 0, 2, 900);
    struct pairs pairs = list_pairs(&class);
    CHECK(pairs.count == 1 && common_share(pairs.all[0].most) == 1);
    pairs_free(&pairs);
    class_free(&class);
}

/* Too little to tell. */
static void test_short_copy(void) {
    struct class class = make_class(2, 1);
    add_text(&class, 0, 0, 1, 26);
    add_text(&class, 1, 0, 1, 26);
    struct pairs pairs = list_pairs(&class);
    CHECK(pairs_compare(&class, 0, 0, 1).shared > 0 && pairs.count == 0);
    pairs_free(&pairs);
    class_free(&class);
}

/* Nearly all that anyone has is what everyone writes. */
static void test_common_knowledge(void) {
    struct class class = make_class(20, 1);
    for (size_t i = 0; i < 20; i++) {
        add_text(&class, i, 0, 7, 400);
        add_text(&class, i, 0, i == 19 ? 118 : i + 100, 150); /* 19 copied that of 18 */
    }
    CHECK(pairs_compare(&class, 0, 0, 1).shared > 100);
    struct pairs pairs = list_pairs(&class);
    CHECK(pairs_compare(&class, 0, 0, 1).shared == 0);
    CHECK(pairs.count == 1 && pairs.all[0].a == 18 && pairs.all[0].b == 19);
    pairs_free(&pairs);
    class_free(&class);
}

/* What half of the class has copied is no common knowledge. */
static void test_many_copies(void) {
    struct class class = make_class(20, 1);
    for (size_t i = 0; i < 20; i++) {
        add_text(&class, i, 0, i < 10 ? 7 : i, 400);
    }
    struct pairs pairs = list_pairs(&class);
    CHECK(pairs.count == 45);
    pairs_free(&pairs);
    class_free(&class);
}

static void test_empty_class(void) {
    for (size_t count = 0; count < 3; count++) {
        struct class class = make_class(count, 1);
        struct pairs pairs = list_pairs(&class);
        CHECK(pairs.count == 0);
        pairs_free(&pairs);
        class_free(&class);
    }
}

/* ---- Where they are alike ---- */

/* b has lines 101 to 200 of a first, then its lines 1 to 100. */
static void test_blocks(void) {
    const struct set nothing = {0};
    struct tokens a = draw_tokens(5, 200, 1000), b = draw_tokens(5, 200, 1000);
    for (size_t i = 0; i < 200; i++) {
        b.all[i].code = a.all[(i + 100) % 200].code;
    }
    struct fingerprints first = choose(&a, &nothing), second = choose(&b, &nothing);
    struct matches matches;
    CHECK(matches_find(&matches, &first, 200, &second, 200));
    CHECK(matches.count == 2);
    if (matches.count == 2) {
        const struct block *block = matches.blocks;
        CHECK(block[0].a.first < 10 && block[0].a.last > 90 && block[0].a.last <= 100);
        CHECK(block[0].b.first == block[0].a.first + 100 &&
              block[0].b.last == block[0].a.last + 100);
        CHECK(block[1].a.first > 100 && block[1].a.last > 190);
        CHECK(block[1].b.first == block[1].a.first - 100 &&
              block[1].b.last == block[1].a.last - 100);
        CHECK(matches.marked_a[block[0].a.first] && !matches.marked_a[block[0].a.last + 1]);
        CHECK(matches.marked_b[block[1].b.last] && !matches.marked_b[block[1].b.last + 1]);
    }
    matches_free(&matches);
    CHECK(matches_find(&matches, &first, 50, &second, 120)); /* the files have become shorter */
    for (size_t i = 0; i < matches.count; i++) {
        CHECK(matches.blocks[i].a.last <= 50 && matches.blocks[i].b.last <= 120);
    }
    CHECK(matches.count == 1);
    matches_free(&matches);
    fingerprints_free(&first);
    fingerprints_free(&second);
    tokens_free(&a);
    tokens_free(&b);
}

UNIT_MAIN(TEST(test_what_does_not_count), TEST(test_what_counts), TEST(test_lines),
          TEST(test_winnowing), TEST(test_density), TEST(test_repetition), TEST(test_short),
          TEST(test_given), TEST(test_any_bytes), TEST(test_copy_is_listed), TEST(test_limits),
          TEST(test_part_of_more), TEST(test_short_copy), TEST(test_common_knowledge),
          TEST(test_many_copies), TEST(test_empty_class), TEST(test_blocks))
