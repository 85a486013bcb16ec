/*
 * Lesson 1's benchmark: all attempts at a line, against the pixels that are exactly nearest.
 *
 * The error counts, for each line from a to b and once more from b to a, the pixels that were set
 * and should not be (not the nearest) and those that were not set and should be (gaps). A version
 * that sets other pixels in the other direction is wrong in at least one of them.
 */
#define main step01_main
int step01_main(int argc, char **argv);
#include "../../step01_line/main.c"
#undef main

#include "../../step01_line/attempts.h"

#include "bench.h"
#include "oracle.h"

#include <string.h>

enum {
    SIDE = 512,       /* of the image */
    LINE_COUNT = 400, /* timed: in all directions, of all lengths up to a whole side */
    LONG_COUNT = 8,   /* for the error only: a million columns (rows), the last of them seen */
    LONG_LENGTH = 1000000,
    HOUSE_LINE = LINE_ATTEMPT_COUNT /* choices below it are attempts */
};

struct lines {
    struct pixel ends[LINE_COUNT + LONG_COUNT][2];
    size_t pixel_count;        /* of the timed lines, as they should be */
    struct image timed;        /* IMAGE_BGR, as the scenes are */
    struct image drawn, exact; /* IMAGE_GREY */
};

static line_function *lines_version(int choice) {
    return choice == HOUSE_LINE ? line : line_attempt(choice).draw;
}

static struct pixel lines_random_pixel(struct random *random, int64_t most) {
    int x = (int)random_between(random, 0, most), y = (int)random_between(random, 0, most);
    return (struct pixel){x, y};
}

static void lines_choose(struct lines *lines) {
    static const int sizes[] = {31, 127, SIDE - 1, SIDE - 1};
    struct random random = {1};
    for (int i = 0; i < LINE_COUNT; i++) {
        struct pixel *ends = lines->ends[i];
        ends[0] = lines_random_pixel(&random, sizes[i % 4]);
        ends[1] = lines_random_pixel(&random, sizes[i % 4]);
        lines->pixel_count += line_length(ends[0], ends[1]);
    }
    for (int i = LINE_COUNT; i < LINE_COUNT + LONG_COUNT; i++) {
        struct pixel *ends = lines->ends[i];
        int far = -LONG_LENGTH, aside = (int)random_between(&random, far, -far);
        ends[0] = i % 2 == 0 ? (struct pixel){far, aside} : (struct pixel){aside, far};
        ends[1] = (struct pixel){SIDE - 1, SIDE / 2};
        if (i % 2 != 0) {
            ends[1] = transposed(ends[1]);
        }
    }
}

static bool lines_setup(void **state, struct error *error) {
    struct lines *lines = calloc(1, sizeof *lines);
    *state = lines;
    if (lines == NULL) {
        return error_set(error, "out of memory for lines");
    }
    lines_choose(lines);
    return image_create(&lines->timed, SIDE, SIDE, IMAGE_BGR, error) &&
           image_create(&lines->drawn, SIDE, SIDE, IMAGE_GREY, error) &&
           image_create(&lines->exact, SIDE, SIDE, IMAGE_GREY, error);
}

static void lines_teardown(void *state) {
    struct lines *lines = state;
    if (lines != NULL) {
        image_free(&lines->timed);
        image_free(&lines->drawn);
        image_free(&lines->exact);
    }
    free(lines);
}

static double lines_units(const void *state) {
    return (double)((const struct lines *)state)->pixel_count;
}

static void lines_run(void *state, int choice) {
    struct lines *lines = state;
    line_function *draw = lines_version(choice);
    for (int i = 0; i < LINE_COUNT; i++) {
        draw(&lines->timed, lines->ends[i][0], lines->ends[i][1], color_rgb(255, 128, 0));
    }
}

/* Set the exact pixels of a line that lie in the image. The ideal line tells where to look, the
 * oracle which pixel of three it is. Returns how many there are. */
static size_t lines_draw_exact(struct image *image, struct pixel a, struct pixel b) {
    int64_t dx = (int64_t)b.x - a.x, dy = (int64_t)b.y - a.y, count = 0;
    bool steep = llabs(dy) > llabs(dx);
    int64_t run = steep ? dy : dx, rise = steep ? dx : dy;
    for (int u = 0; u < SIDE; u++) {
        int64_t along = u - (steep ? a.y : a.x);
        int v = (int)((steep ? a.x : a.y) + (run != 0 ? rise * along / run : 0));
        for (int candidate = v - 1; candidate <= v + 1; candidate++) {
            struct pixel p = {steep ? candidate : u, steep ? u : candidate};
            if (oracle_line_has(a, b, p)) {
                count += image_set(image, p.x, p.y, color_grey(255));
            }
        }
    }
    return (size_t)count;
}

static size_t lines_count_differences(const struct image *a, const struct image *b) {
    size_t count = 0;
    for (size_t y = 0; y < SIDE; y++) {
        const uint8_t *row_a = a->pixels + y * SIDE, *row_b = b->pixels + y * SIDE;
        if (memcmp(row_a, row_b, SIDE) != 0) {
            for (size_t x = 0; x < SIDE; x++) {
                count += row_a[x] != row_b[x];
            }
        }
    }
    return count;
}

static double lines_error(void *state, int choice) {
    struct lines *lines = state;
    size_t wrong = 0, right = 0;
    for (int i = 0; i < LINE_COUNT + LONG_COUNT; i++) {
        struct pixel a = lines->ends[i][0], b = lines->ends[i][1];
        image_clear(&lines->exact, color_grey(0));
        size_t exact_count = lines_draw_exact(&lines->exact, a, b);
        for (int direction = 0; direction < 2; direction++) {
            image_clear(&lines->drawn, color_grey(0));
            lines_version(choice)(&lines->drawn, direction ? b : a, direction ? a : b,
                                  color_grey(255));
            wrong += lines_count_differences(&lines->drawn, &lines->exact);
            right += exact_count;
        }
    }
    return 1000 * (double)wrong / (double)right;
}

static const struct bench_version lines_versions[] = {
    {"1: t += 0.01", 0, false, lines_run, lines_error},
    {"2: t += 0.1", 1, false, lines_run, lines_error},
    {"3: step per column", 2, false, lines_run, lines_error},
    {"4: axes swapped", 3, false, lines_run, lines_error},
    {"5: division outside", 4, false, lines_run, lines_error},
    {"6: y accumulated", 5, false, lines_run, lines_error},
    {"7: two parts", 6, false, lines_run, lines_error},
    {"by cases", 7, false, lines_run, lines_error},
    {"Bresenham by runs", 8, false, lines_run, lines_error},
    {"Bresenham: line()", HOUSE_LINE, true, lines_run, lines_error},
};

static const struct bench_panel lines_panels[] = {
    {
        .title = "400 lines in an image of 512x512 pixels",
        .error_label = "wrong and missing pixels per 1000, both directions, long lines included",
        .time_label = "ns per pixel",
        .against = "exact integers",
        .units = lines_units,
        .versions = lines_versions,
        .version_count = sizeof lines_versions / sizeof lines_versions[0],
    },
};

const struct bench_lesson bench_step01 = {
    .step = "step01_line",
    .title = "Step 1: a line",
    .setup = lines_setup,
    .teardown = lines_teardown,
    .panels = lines_panels,
    .panel_count = 1,
};
