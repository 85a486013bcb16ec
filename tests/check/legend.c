#include "legend.h"

enum {
    LEAST_SIZE = 400, /* pixels of a panel in the picture, along its shorter side */
    MOST_TIMES = 16,  /* how much it is enlarged at most */
    GAP = 8,          /* pixels between two panels, enlarged as they are */
    DOT = 2,          /* pixels along the side of a letter's dot */
    LETTER_WIDTH = 5, /* dots */
    LETTER_HEIGHT = 7,
    LETTER_STEP = 6 * DOT, /* from a letter to the next */
    LINE_STEP = 12 * DOT,  /* from a line of text to the next */
    MARGIN = (LINE_STEP - LETTER_HEIGHT * DOT) / 2,
    WORDS_WIDTH = 45 * LETTER_STEP /* of the longest explanation */
};

/* The capital letters and the comma: seven rows from the top, bit 4 is the leftmost dot. */
static const uint8_t letters[27][LETTER_HEIGHT] = {
    {0x0E, 0x11, 0x11, 0x1F, 0x11, 0x11, 0x11}, {0x1E, 0x11, 0x11, 0x1E, 0x11, 0x11, 0x1E},
    {0x0E, 0x11, 0x10, 0x10, 0x10, 0x11, 0x0E}, {0x1E, 0x11, 0x11, 0x11, 0x11, 0x11, 0x1E},
    {0x1F, 0x10, 0x10, 0x1E, 0x10, 0x10, 0x1F}, {0x1F, 0x10, 0x10, 0x1E, 0x10, 0x10, 0x10},
    {0x0E, 0x11, 0x10, 0x17, 0x11, 0x11, 0x0E}, {0x11, 0x11, 0x11, 0x1F, 0x11, 0x11, 0x11},
    {0x0E, 0x04, 0x04, 0x04, 0x04, 0x04, 0x0E}, {0x07, 0x02, 0x02, 0x02, 0x02, 0x12, 0x0C},
    {0x11, 0x12, 0x14, 0x18, 0x14, 0x12, 0x11}, {0x10, 0x10, 0x10, 0x10, 0x10, 0x10, 0x1F},
    {0x11, 0x1B, 0x15, 0x15, 0x11, 0x11, 0x11}, {0x11, 0x19, 0x15, 0x13, 0x11, 0x11, 0x11},
    {0x0E, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0E}, {0x1E, 0x11, 0x11, 0x1E, 0x10, 0x10, 0x10},
    {0x0E, 0x11, 0x11, 0x11, 0x15, 0x12, 0x0D}, {0x1E, 0x11, 0x11, 0x1E, 0x14, 0x12, 0x11},
    {0x0F, 0x10, 0x10, 0x0E, 0x01, 0x01, 0x1E}, {0x1F, 0x04, 0x04, 0x04, 0x04, 0x04, 0x04},
    {0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0E}, {0x11, 0x11, 0x11, 0x11, 0x11, 0x0A, 0x04},
    {0x11, 0x11, 0x11, 0x15, 0x15, 0x15, 0x0A}, {0x11, 0x11, 0x0A, 0x04, 0x0A, 0x11, 0x11},
    {0x11, 0x11, 0x0A, 0x04, 0x04, 0x04, 0x04}, {0x1F, 0x01, 0x02, 0x04, 0x08, 0x10, 0x1F},
    {0x00, 0x00, 0x00, 0x00, 0x04, 0x04, 0x08},
};

/* The colours of a mark in compare.c, and what they mean. */
static const struct {
    struct color color;
    const char *words;
} explanations[] = {
    {{.r = 255, .g = 0, .b = 0, .a = 255}, "SHOULD NOT BE THERE, OR HAS ANOTHER COLOUR"},
    {{.r = 0, .g = 0, .b = 255, .a = 255}, "MISSING"},
    {{.r = 0, .g = 96, .b = 0, .a = 255}, "DIFFERS, BUT DOES NOT COUNT"},
};
enum { EXPLANATIONS = sizeof explanations / sizeof explanations[0] };

static void fill(struct image *image, size_t x, size_t y, size_t width, size_t height,
                 struct color color) {
    for (size_t j = y; j < y + height; j++) {
        for (size_t i = x; i < x + width; i++) {
            image_set(image, (int)i, (int)j, color);
        }
    }
}

/* (x,y) is the bottom-left corner of the first letter. */
static void write_words(struct image *image, size_t x, size_t y, const char *words) {
    for (; *words != '\0'; words++, x += LETTER_STEP) {
        if (*words == ' ') {
            continue;
        }
        const uint8_t *rows = letters[*words == ',' ? 26 : *words - 'A'];
        for (size_t row = 0; row < LETTER_HEIGHT; row++) {
            for (size_t column = 0; column < LETTER_WIDTH; column++) {
                if (rows[row] >> (LETTER_WIDTH - 1 - column) & 1) {
                    fill(image, x + column * DOT, y + (LETTER_HEIGHT - 1 - row) * DOT, DOT, DOT,
                         color_grey(255));
                }
            }
        }
    }
}

/* How many explanations are side by side in a picture of that width. */
static size_t explanation_columns(size_t width) {
    size_t columns = width / WORDS_WIDTH;
    return columns < 1 ? 1 : columns > EXPLANATIONS ? EXPLANATIONS : columns;
}

static void write_explanations(struct image *image, size_t columns) {
    size_t rows = (EXPLANATIONS + columns - 1) / columns;
    for (size_t i = 0; i < EXPLANATIONS; i++) {
        size_t x = MARGIN + i % columns * WORDS_WIDTH;
        size_t y = (rows - 1 - i / columns) * LINE_STEP + MARGIN;
        fill(image, x, y, LETTER_HEIGHT * DOT, LETTER_HEIGHT * DOT, explanations[i].color);
        write_words(image, x + 2 * LETTER_STEP, y, explanations[i].words);
    }
}

/* Every pixel of a panel of the reference's size becomes a square, (x,y) the bottom-left one. What
 * the panel lacks is background, what it has besides is cut off. */
static void put_panel(struct image *picture, const struct image *panel,
                      const struct image *reference, size_t times, size_t x, size_t y) {
    for (size_t j = 0; j < reference->height; j++) {
        for (size_t i = 0; i < reference->width; i++) {
            bool is_there = i < panel->width && j < panel->height;
            fill(picture, x + i * times, y + j * times, times, times,
                 is_there ? image_get(panel, (int)i, (int)j) : color_grey(0));
        }
    }
}

/* How many times a panel is enlarged. */
static size_t find_times(size_t width, size_t height) {
    size_t shorter = width < height ? width : height;
    size_t times = (LEAST_SIZE + shorter - 1) / shorter;
    return times > MOST_TIMES ? MOST_TIMES : times;
}

bool legend_picture(struct image *picture, const struct image *reference, const struct image *yours,
                    enum compare_pixels wrong, struct error *error) {
    static const char *const names[] = {"REFERENCE", "YOURS", "DIFFERENCE"};
    size_t times = find_times(reference->width, reference->height);
    size_t panels_width = (3 * reference->width + 2 * GAP) * times;
    size_t columns = explanation_columns(panels_width);
    size_t bottom = (EXPLANATIONS + columns - 1) / columns * LINE_STEP;
    size_t height = reference->height * times, top = bottom + height;
    struct image difference;
    *picture = (struct image){.pixels = NULL};
    bool done = compare_difference(&difference, reference, yours, wrong, error) &&
                image_create(picture, panels_width, top + LINE_STEP, IMAGE_BGR, error);
    if (done) {
        const struct image *const panels[] = {reference, yours, &difference};
        image_clear(picture, color_grey(64));
        fill(picture, 0, bottom, panels_width, height, color_grey(128));
        write_explanations(picture, columns);
        for (size_t i = 0; i < 3; i++) {
            size_t begin = i * (reference->width + GAP) * times;
            put_panel(picture, panels[i], reference, times, begin, bottom);
            write_words(picture, begin + MARGIN, top + MARGIN, names[i]);
        }
    }
    image_free(&difference);
    return done;
}
