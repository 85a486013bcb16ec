/*
 * Runs all properties: stress [NAME ...]
 *
 * Environment: STRESS=10 tries ten times the cases (also fractions: 0.1), SEED=7 another sequence
 * of them, CASE=12 one case of each property, for a debugger. Prints a line a property: what it is
 * held against, cases tried and failed; after a failing property the first case that fails.
 * Exit status 0: all hold; 1: some do not; 2: wrong usage.
 */
#include "stress.h"

#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const against_name[AGAINST_KINDS] = {
    [AGAINST_NOT_SAID] = "(not said)",
    [AGAINST_INTEGERS] = "exact integers",
    [AGAINST_FRACTIONS] = "exact fractions",
    [AGAINST_LONG_DOUBLE] = "long double",
    [AGAINST_ITSELF] = "itself",
    [AGAINST_BOUNDS] = "bounds",
};

struct outcome {
    uint64_t failed, first_failure;
    struct tally tally; /* of all cases */
};

/* Every case has its own seed. */
static struct random case_random(uint64_t seed, const char *name, uint64_t index) {
    struct random random = {seed};
    for (const char *c = name; *c != '\0'; c++) {
        random.state = (random.state ^ (unsigned char)*c) * 0x100000001b3u;
    }
    random.state ^= index * 0xd1342543de82ef95u;
    random_bits(&random);
    return random;
}

static void make_case(const struct property *property, uint64_t seed, uint64_t index, void *made) {
    struct random random = case_random(seed, property->name, index);
    memset(made, 0, property->size);
    property->make(&random, index, made);
}

static bool try_case(const struct property *property, const void *tried, struct tally *tally) {
    bool right = true;
    if (property->error != NULL) {
        tally->error = property->error(tried);
        right = property->limit == 0 || tally->error <= property->limit;
    }
    right = right && (property->holds == NULL || property->holds(tried));
    return right && (property->judge == NULL || property->judge(tried, tally));
}

/* The cases begin..end - 1. */
static struct outcome try_cases(const struct property *property, uint64_t seed, uint64_t begin,
                                uint64_t end) {
    uint64_t failed = 0, first_failure = UINT64_MAX, asked = 0, left_out = 0;
    double worst = 0;
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 16) reduction(+ : failed, asked, left_out)              \
    reduction(min : first_failure) reduction(max : worst)
#endif
    for (uint64_t i = begin; i < end; i++) {
        union {
            unsigned char bytes[CASE_SIZE_LIMIT];
            max_align_t aligned;
        } tried;
        make_case(property, seed, i, &tried);
        struct tally tally = {0};
        if (!try_case(property, &tried, &tally)) {
            failed++;
            first_failure = i < first_failure ? i : first_failure;
        }
        worst = fmax(worst, tally.error);
        asked += tally.asked;
        left_out += tally.left_out;
    }
    return (struct outcome){failed, first_failure, {worst, asked, left_out}};
}

/* What the environment asks for. */
struct wish {
    double factor;
    int64_t seed, only; /* this case alone; -1: all */
};

static bool run_property(const struct property *property, const struct wish *wish) {
    uint64_t seed = (uint64_t)wish->seed, begin = wish->only < 0 ? 0 : (uint64_t)wish->only;
    double factor = property->all ? 1 : wish->factor;
    uint64_t cases = wish->only < 0 ? (uint64_t)fmax(1, (double)property->cases * factor) : 1;
    struct outcome outcome = try_cases(property, seed, begin, begin + cases);
    printf("%-35s %-15s  %s %7llu, failed %llu", property->name, against_name[property->against],
           property->all ? "all" : "cases", (unsigned long long)cases,
           (unsigned long long)outcome.failed);
    if (property->error_unit != NULL) {
        printf(", largest error %.3g %s", outcome.tally.error, property->error_unit);
    }
    if (outcome.tally.asked > 0) {
        printf(", %llu pixels, %llu more left out as ties", (unsigned long long)outcome.tally.asked,
               (unsigned long long)outcome.tally.left_out);
    }
    printf("\n");
    if (outcome.failed > 0) {
        printf("  the first is CASE=%llu\n", (unsigned long long)outcome.first_failure);
    }
    fflush(stdout);
    return outcome.failed == 0;
}

static bool is_asked_for(const char *name, int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        if (strstr(name, argv[i]) != NULL) {
            return true;
        }
    }
    return argc < 2;
}

static bool read_whole(const char *name, int64_t *value) {
    const char *text = getenv(name);
    if (text == NULL || *text == '\0' ||
        word_to_integer((struct word){text, strlen(text)}, value)) {
        return true;
    }
    fprintf(stderr, "stress: %s wants a whole number, not '%s'\n", name, text);
    return false;
}

static bool read_environment(struct wish *wish) {
    const char *text = getenv("STRESS");
    *wish = (struct wish){.factor = 1, .seed = 1, .only = -1};
    if (text != NULL && *text != '\0' &&
        (!word_to_double((struct word){text, strlen(text)}, &wish->factor) ||
         !(wish->factor > 0 && wish->factor <= 1e6))) {
        fprintf(stderr, "stress: STRESS wants a number from 0 to 1000000, not '%s'\n", text);
        return false;
    }
    return read_whole("SEED", &wish->seed) && read_whole("CASE", &wish->only);
}

int main(int argc, char **argv) {
    static const struct property *const tables[] = {
        line_properties,     triangle_properties, pipeline_properties, camera_properties,
        texture_properties,  small_properties,    lesson04_properties, lesson05_properties,
        lesson06_properties, lesson07_properties, lesson08_properties, lesson09_properties,
        lesson10_properties,
    };
    struct wish wish;
    if (!read_environment(&wish)) {
        return 2;
    }
    size_t held = 0, broken = 0;
    for (size_t i = 0; i < sizeof tables / sizeof tables[0]; i++) {
        for (const struct property *p = tables[i]; p->name != NULL; p++) {
            if (is_asked_for(p->name, argc, argv)) {
                bool holds = run_property(p, &wish);
                held += holds;
                broken += !holds;
            }
        }
    }
    if (held + broken == 0) {
        fprintf(stderr, "stress: no property has such a name\n");
        return 2;
    }
    printf("%zu properties hold, %zu do not (SEED=%llu)\n", held, broken,
           (unsigned long long)wish.seed);
    return broken > 0;
}
