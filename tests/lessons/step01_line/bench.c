/*
 * Lesson 1's benchmark: the attempts at a line, and sums in numbers of all kinds beside them.
 *
 * In the first panel every line has a small image of its own, and every version a grey level of its
 * own: what the last run drew can be told from what others left. In the other panels the lines are
 * lists of their pixels, as line_list() makes them, and all versions write them with put(). The
 * error counts wrong pixels, against exact integers.
 */
#define LESSON "../step01_line/main.c"
#include "lesson.h"

#include "../../../step01_line/attempts.h"

#include "bench/bench.h"
#include "oracle/oracle.h"

enum {
    SIDE = 256,       /* pixels of a small image */
    PAIR_COUNT = 48,  /* lines in small images, each in both directions */
    SHORT_COUNT = 64, /* lists of 500 pixels */
    SHORT_LENGTH = 500,
    LONG_COUNT = 4, /* lists of a million pixels */
    LONG_LENGTH = 1000000,
    HOUSE_LINE = LINE_ATTEMPT_COUNT, /* choices below it are attempts */
    LONG_LISTS = 128                 /* added to the choices of the versions that make lists */
};

/* Lines of one length, as lists one after the other. */
struct lists {
    struct pixel ends[SHORT_COUNT][2];
    size_t count, length; /* lines, and pixels of each */
    struct pixel *drawn, *exact;
};

struct lines {
    struct pixel ends[2 * PAIR_COUNT][2];
    struct image images[2 * PAIR_COUNT]; /* IMAGE_GREY */
    size_t pixel_count;                  /* of these lines, as they should be */
    struct lists short_lists, long_lists;
};

/* ---- Attempts, in small images ---- */

static uint8_t version_level(int choice) {
    return (uint8_t)(choice + 1);
}

static void images_run(void *state, int choice) {
    struct lines *lines = state;
    line_function *draw = choice == HOUSE_LINE ? line : line_attempt(choice).draw;
    for (int i = 0; i < 2 * PAIR_COUNT; i++) {
        draw(&lines->images[i], lines->ends[i][0], lines->ends[i][1],
             color_grey(version_level(choice)));
    }
}

static double images_units(const void *state, int base) {
    (void)base;
    return (double)((const struct lines *)state)->pixel_count;
}

static double images_error(void *state, int choice) {
    struct lines *lines = state;
    size_t wrong = 0;
    for (int i = 0; i < 2 * PAIR_COUNT; i++) {
        const uint8_t *pixels = lines->images[i].pixels;
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                bool is_set = pixels[y * SIDE + x] == version_level(choice);
                wrong += is_set != oracle_line_has(lines->ends[i][0], lines->ends[i][1],
                                                   (struct pixel){x, y});
            }
        }
    }
    return 1000 * (double)wrong / (double)lines->pixel_count;
}

static struct pixel random_pixel(struct random *random) {
    int x = (int)random_between(random, 0, SIDE - 1), y = (int)random_between(random, 0, SIDE - 1);
    return (struct pixel){x, y};
}

static bool images_setup(struct lines *lines, struct random *random, struct error *error) {
    for (int i = 0; i < 2 * PAIR_COUNT; i++) {
        struct pixel *ends = lines->ends[i];
        ends[0] = i % 2 != 0 ? lines->ends[i - 1][1] : random_pixel(random);
        ends[1] = i % 2 != 0 ? lines->ends[i - 1][0] : random_pixel(random);
        lines->pixel_count += line_length(ends[0], ends[1]);
        if (!image_create(&lines->images[i], SIDE, SIDE, IMAGE_GREY, error)) {
            return false;
        }
    }
    return true;
}

/* ---- Sums in numbers of all kinds, into lists ---- */

/* A line turned so that it goes to the right and at most as far up: it sets (u + i, v + v_step * j)
 * for i = 0 .. run, where j is the whole number nearest to rise * i / run, the smaller at a tie. */
struct flat {
    int u, v, v_step;
    int64_t run, rise;
    bool steep; /* u is y and v is x */
};

static inline struct flat flat_line(struct pixel a, struct pixel b) {
    bool steep = make_flat(&a, &b);
    return (struct flat){a.x, a.y, b.y < a.y ? -1 : 1, b.x - a.x, llabs((int64_t)b.y - a.y), steep};
}

static inline void put(struct pixel *list, const struct flat *flat, int64_t i, int64_t j) {
    int u = flat->u + (int)i, v = flat->v + flat->v_step * (int)j;
    list[i] = flat->steep ? (struct pixel){v, u} : (struct pixel){u, v};
}

/* Fixed point with so many bits after the point. The slope is rounded down and the sum begins just
 * below 1/2: a tie stays a tie or falls below, and goes the right way. */
static inline void list_fixed(struct flat flat, struct pixel *list, int bits) {
    uint64_t slope = ((uint64_t)flat.rise << bits) / (uint64_t)flat.run;
    uint64_t sum = (UINT64_C(1) << (bits - 1)) - 1;
    for (int64_t i = 0; i <= flat.run; i++) {
        put(list, &flat, i, (int64_t)(sum >> bits));
        sum += slope;
    }
}

static inline void list_float_sum(struct flat flat, struct pixel *list) {
    float slope = (float)flat.rise / (float)flat.run, sum = 0.5F - 0x1p-25F;
    for (int64_t i = 0; i <= flat.run; i++) {
        put(list, &flat, i, (int)sum);
        sum += slope;
    }
}

static inline void list_double_sum(struct flat flat, struct pixel *list) {
    double slope = (double)flat.rise / (double)flat.run, sum = 0.5 - 0x1p-54;
    for (int64_t i = 0; i <= flat.run; i++) {
        put(list, &flat, i, (int)sum);
        sum += slope;
    }
}

static inline void list_float_product(struct flat flat, struct pixel *list) {
    float slope = (float)flat.rise / (float)flat.run;
    for (int64_t i = 0; i <= flat.run; i++) {
        put(list, &flat, i, (int)((float)(int)i * slope + (0.5F - 0x1p-25F)));
    }
}

/* As line_list(), in 32 bits: the coordinates are small enough. */
static inline void list_bresenham(struct flat flat, struct pixel *list) {
    int run = (int)flat.run, rise = (int)flat.rise, error = -run;
    for (int i = 0, j = 0; i <= run; i++) {
        put(list, &flat, i, j);
        error += 2 * rise;
        if (error > 0) {
            j++;
            error -= 2 * run;
        }
    }
}

/* As line_by_runs() of the attempts. */
static inline void list_runs(struct flat flat, struct pixel *list) {
    int64_t divisor = flat.rise > 0 ? 2 * flat.rise : 1;
    int64_t end = (flat.run + divisor) / divisor, remainder = (flat.run + divisor) % divisor;
    const int64_t length = 2 * flat.run / divisor, length_remainder = 2 * flat.run % divisor;
    int64_t i = 0;
    for (int64_t j = 0; j < flat.rise; j++) {
        for (; i < end; i++) {
            put(list, &flat, i, j);
        }
        end += length;
        remainder += length_remainder;
        if (remainder >= divisor) {
            remainder -= divisor;
            end++;
        }
    }
    for (; i <= flat.run; i++) {
        put(list, &flat, i, flat.rise);
    }
}

enum list_version {
    FLOAT_SUM,
    FLOAT_PRODUCT,
    DOUBLE_SUM,
    BRESENHAM_32,
    BY_RUNS,
    HOUSE_LIST,
    FIXED /* and more: bits after the point */
};

static void list_draw(struct pixel a, struct pixel b, struct pixel *list, int choice) {
    switch (choice) {
    case FLOAT_SUM:
        list_float_sum(flat_line(a, b), list);
        break;
    case FLOAT_PRODUCT:
        list_float_product(flat_line(a, b), list);
        break;
    case DOUBLE_SUM:
        list_double_sum(flat_line(a, b), list);
        break;
    case BRESENHAM_32:
        list_bresenham(flat_line(a, b), list);
        break;
    case BY_RUNS:
        list_runs(flat_line(a, b), list);
        break;
    case HOUSE_LIST:
        line_list(a, b, list);
        break;
    default:
        list_fixed(flat_line(a, b), list, choice - FIXED);
    }
}

static struct lists *chosen_lists(struct lines *lines, int choice) {
    return choice < LONG_LISTS ? &lines->short_lists : &lines->long_lists;
}

static void lists_run(void *state, int choice) {
    struct lists *lists = chosen_lists(state, choice);
    for (size_t i = 0; i < lists->count; i++) {
        list_draw(lists->ends[i][0], lists->ends[i][1], lists->drawn + i * lists->length,
                  choice % LONG_LISTS);
    }
}

static double lists_error(void *state, int choice) {
    const struct lists *lists = chosen_lists(state, choice);
    size_t wrong = 0, pixel_count = lists->count * lists->length;
    for (size_t i = 0; i < pixel_count; i++) {
        wrong += lists->drawn[i].x != lists->exact[i].x || lists->drawn[i].y != lists->exact[i].y;
    }
    return 1000 * (double)wrong / (double)pixel_count;
}

static double lists_units(const void *state, int base) {
    (void)state;
    return base == LONG_LISTS ? (double)LONG_COUNT * LONG_LENGTH : SHORT_COUNT * SHORT_LENGTH;
}

/* Where the exact pixel is, the ideal line tells to within one; the oracle tells which it is. */
static void find_exact_list(struct pixel a, struct pixel b, struct pixel *list) {
    struct flat flat = flat_line(a, b);
    for (int64_t i = 0; i <= flat.run; i++) {
        int64_t j = flat.rise * i / flat.run - 1;
        do {
            put(list, &flat, i, j++);
        } while (!oracle_line_has(a, b, list[i]));
    }
}

static bool lists_setup(struct lists *lists, size_t count, int length, struct random *random,
                        struct error *error) {
    *lists = (struct lists){.count = count, .length = (size_t)length};
    lists->drawn = calloc(count * lists->length, sizeof *lists->drawn);
    lists->exact = calloc(count * lists->length, sizeof *lists->exact);
    if (lists->drawn == NULL || lists->exact == NULL) {
        return error_set(error, "out of memory for lists of pixels");
    }
    for (size_t i = 0; i < count; i++) {
        int run = length - 1, rise = (int)random_between(random, -run, run);
        struct pixel *ends = lists->ends[i];
        ends[0] = (struct pixel){-run / 2, -rise / 2};
        ends[1] = (struct pixel){ends[0].x + run, ends[0].y + rise};
        if (i % 2 != 0) {
            ends[0] = transposed(ends[0]);
            ends[1] = transposed(ends[1]);
        }
        find_exact_list(ends[0], ends[1], lists->exact + i * lists->length);
    }
    return true;
}

static void lists_free(struct lists *lists) {
    free(lists->drawn);
    free(lists->exact);
}

/* ---- The lesson ---- */

static bool lines_setup(void *state, struct error *error) {
    struct lines *lines = state;
    struct random random = {1};
    return images_setup(lines, &random, error) &&
           lists_setup(&lines->short_lists, SHORT_COUNT, SHORT_LENGTH, &random, error) &&
           lists_setup(&lines->long_lists, LONG_COUNT, LONG_LENGTH, &random, error);
}

static void lines_teardown(void *state) {
    struct lines *lines = state;
    for (int i = 0; i < 2 * PAIR_COUNT; i++) {
        image_free(&lines->images[i]);
    }
    lists_free(&lines->short_lists);
    lists_free(&lines->long_lists);
}

static const struct bench_version image_versions[] = {
    VERSION("1: t += 0.01", 0),        VERSION("2: t += 0.1", 1),
    VERSION("3: step per column", 2),  VERSION("4: axes swapped", 3),
    VERSION("5: division outside", 4), VERSION("6: y accumulated", 5),
    VERSION("7: two parts", 6),        VERSION("by cases", 7),
    VERSION("Bresenham by runs", 8),   HOUSE_VERSION("Bresenham: line()", HOUSE_LINE),
};

static const struct bench_version list_versions[] = {
    VERSION("fixed, 8 bits", FIXED + 8),   VERSION("fixed, 16 bits", FIXED + 16),
    VERSION("fixed, 32 bits", FIXED + 32), VERSION("fixed, 43 bits", FIXED + 43),
    VERSION("float, sum", FLOAT_SUM),      VERSION("float, product", FLOAT_PRODUCT),
    VERSION("double, sum", DOUBLE_SUM),    VERSION("Bresenham, 32 bits", BRESENHAM_32),
    VERSION("Bresenham by runs", BY_RUNS), HOUSE_VERSION("Bresenham: line_list()", HOUSE_LIST),
};

static const struct bench_panel lines_panels[] = {
    {
        .title = "The attempts: 48 lines in images of 256x256 pixels, in both directions",
        .error_label = "wrong and missing pixels per 1000",
        .time_label = "ns per pixel",
        .against = "exact integers",
        .house_within = BENCH_EXACT,
        .run = images_run,
        .error = images_error,
        .units = images_units,
        BENCH_VERSIONS(image_versions),
    },
    {
        .title = "Lists of 500 pixels, in numbers of all kinds",
        .error_label = "wrong pixels per 1000",
        .time_label = "ns per pixel",
        .against = "exact integers",
        .house_within = BENCH_EXACT,
        .run = lists_run,
        .error = lists_error,
        .units = lists_units,
        BENCH_VERSIONS(list_versions),
    },
    {
        .title = "Lists of a million pixels",
        .error_label = "wrong pixels per 1000",
        .time_label = "ns per pixel",
        .against = "exact integers",
        .house_within = BENCH_EXACT,
        .base = LONG_LISTS,
        .run = lists_run,
        .error = lists_error,
        .units = lists_units,
        BENCH_VERSIONS(list_versions),
    },
};

const struct bench_lesson bench_step01 = {
    .step = "step01_line",
    .title = "Step 1: a line",
    .state_size = sizeof(struct lines),
    .setup = lines_setup,
    .teardown = lines_teardown,
    .panels = lines_panels,
    .panel_count = sizeof lines_panels / sizeof lines_panels[0],
};
