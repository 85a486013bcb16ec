/*
 * Lesson 1's benchmark: the attempts at a line.
 *
 * Every line has its own small image, and every version its own grey value: what the
 * last run drew can be told from what others left. The error counts wrong pixels, against exact
 * integers.
 */
#define LESSON "../step01_line/main.c"
#include "lesson.h"

#include "../../../step01_line/attempts.h"

#include "bench/bench.h"
#include "oracle/oracle.h"

enum {
    SIDE = 256,                /* pixels of an image */
    LINE_COUNT = 96,           /* half of them from the end of the one before to its start */
    HOUSE_LINE = ATTEMPT_COUNT /* ways below it are attempts */
};

static struct {
    struct pixel ends[LINE_COUNT][2];
    struct image images[LINE_COUNT]; /* IMAGE_GREY */
    size_t pixel_count;              /* of these lines, as they should be */
} lines;

static uint8_t version_level(struct bench_choice choice) {
    return (uint8_t)(choice.way + 1);
}

static void lines_run(struct bench_choice choice) {
    attempt_function *draw = choice.way == HOUSE_LINE ? line : attempt_at(choice.way);
    for (int i = 0; i < LINE_COUNT; i++) {
        draw(&lines.images[i], lines.ends[i][0], lines.ends[i][1],
             color_grey(version_level(choice)));
    }
}

static double lines_error(struct bench_choice choice) {
    size_t wrong = 0;
    for (int i = 0; i < LINE_COUNT; i++) {
        const uint8_t *pixels = lines.images[i].pixels;
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                bool is_set = pixels[y * SIDE + x] == version_level(choice);
                wrong += is_set !=
                         oracle_line_has(lines.ends[i][0], lines.ends[i][1], (struct pixel){x, y});
            }
        }
    }
    return 1000 * (double)wrong / (double)lines.pixel_count;
}

static struct pixel random_pixel(struct random *random) {
    int x = (int)random_between(random, 0, SIDE - 1), y = (int)random_between(random, 0, SIDE - 1);
    return (struct pixel){x, y};
}

static bool lines_setup(struct error *error) {
    struct random random = {1};
    for (int i = 0; i < LINE_COUNT; i++) {
        struct pixel *ends = lines.ends[i];
        ends[0] = i % 2 != 0 ? lines.ends[i - 1][1] : random_pixel(&random);
        ends[1] = i % 2 != 0 ? lines.ends[i - 1][0] : random_pixel(&random);
        lines.pixel_count += line_length(ends[0], ends[1]);
        if (!image_create(&lines.images[i], SIDE, SIDE, IMAGE_GREY, error)) {
            return false;
        }
    }
    return true;
}

static const struct bench_version lines_versions[] = {
    VERSION("1: t += 0.01", 0),        VERSION("2: t += 0.1", 1),
    VERSION("3: step per column", 2),  VERSION("4: axes swapped", 3),
    VERSION("5: division outside", 4), VERSION("6: y accumulated", 5),
    VERSION("7: two parts", 6),        VERSION("by cases", 7),
    VERSION("Bresenham by runs", 8),   VERSION("t += dt", 9),
    VERSION("t in whole numbers", 10), HOUSE_VERSION("Bresenham: line()", HOUSE_LINE),
};

static const struct bench_panel lines_panels[] = {
    {
        .title = "The attempts: 48 lines in images of 256x256 pixels, in both directions",
        .error_label = "wrong and missing pixels per 1000",
        .time_label = "ns per pixel",
        .against = "exact integers",
        .house_within = BENCH_EXACT,
        .run = lines_run,
        .error = lines_error,
        .units = &lines.pixel_count,
        BENCH_VERSIONS(lines_versions),
    },
};

const struct bench_lesson bench_step01 =
    BENCH_LESSON("step01_line", "Lesson 1: a line", lines_setup, lines_panels);
