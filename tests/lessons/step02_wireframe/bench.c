/*
 * Lesson 2's benchmark: wireframes that draw sides twice, test every pixel, or cut lines badly.
 *
 * In the first panel the work is the bust with a hole, enlarged so that most of it lies outside the
 * image. The other panels cut single lines, ever longer ones, in the ways of the textbooks; all of
 * them set pixels with image_set(). The error counts wrong and missing pixels of the picture that
 * was timed, against the exact pixels of each line.
 */
#define LESSON "../step02_wireframe/main.c"
#include "lesson.h"

#include "../../../step02_wireframe/attempts.h"

#include "bench/bench.h"
#include "oracle/oracle.h"

#include <string.h>

enum { SIDE = 800 }; /* of the image */

/* How much the model is enlarged about its middle: the face fills the image. */
static const double enlargement = 6;
static const double middle_y = 0.25, hole = 0.06; /* before that */

enum { LINE_COUNT = 200, LENGTH_COUNT = 3 }; /* the lines of the other panels */

/* How many times as long as the image is wide the lines of each panel are. */
static const int lengths[LENGTH_COUNT] = {1, 32, 1024};

/* A picture as it should be. */
struct picture {
    struct image image; /* IMAGE_GREY, 255 where something is drawn */
    size_t pixel_count;
};

struct frame {
    struct model model;
    struct drawing drawing;
    struct wireframe wireframe; /* the list of sides, each once */
    struct image timed;         /* IMAGE_GREY */
    struct picture exact;       /* of the model */
    uint64_t walked;            /* pixels, in the last run */

    struct pixel ends[LENGTH_COUNT][LINE_COUNT][2];
    struct picture exact_lines[LENGTH_COUNT];
};

/* ---- Exact pictures ---- */

static bool picture_create(struct picture *picture, struct error *error) {
    return image_create(&picture->image, SIDE, SIDE, IMAGE_GREY, error);
}

/* Set the exact pixels of a line that lie in the image: the ideal line tells where to look, the
 * oracle which pixel of three it is. */
static void picture_add_line(struct picture *picture, struct pixel a, struct pixel b) {
    int64_t dx = (int64_t)b.x - a.x, dy = (int64_t)b.y - a.y;
    bool steep = llabs(dy) > llabs(dx);
    int64_t run = steep ? dy : dx, rise = steep ? dx : dy;
    for (int u = 0; u < SIDE; u++) {
        int64_t along = u - (steep ? a.y : a.x);
        if (run != 0 ? along * run < 0 || llabs(along) > llabs(run) : along != 0) {
            continue;
        }
        int v = (int)((steep ? a.x : a.y) + (run != 0 ? rise * along / run : 0));
        for (int candidate = v - 1; candidate <= v + 1; candidate++) {
            struct pixel p = {steep ? candidate : u, steep ? u : candidate};
            if (oracle_line_has(a, b, p)) {
                image_set(&picture->image, p.x, p.y, color_grey(255));
            }
        }
    }
}

static void picture_count(struct picture *picture) {
    picture->pixel_count = 0;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        picture->pixel_count += picture->image.pixels[i] != 0;
    }
}

/* Wrong and missing pixels per 1000 of a picture, drawn with a grey level. */
static double picture_error(const struct picture *exact, const struct image *drawn, int level) {
    size_t wrong = 0;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        wrong += (drawn->pixels[i] == level) != (exact->image.pixels[i] != 0);
    }
    return 1000 * (double)wrong / (double)exact->pixel_count;
}

/* ---- The bust ---- */

enum frame_version {
    EVERY_TESTED,
    EVERY_CUT,
    ONCE_TESTED,
    ONE_DIRECTION,
    ENDS_ROUNDED,
    LIST_ANEW,
    HOUSE
};

static uint64_t frame_draw_rounded(struct frame *frame) {
    uint64_t walked = 0;
    for (size_t i = 0; i < frame->wireframe.side_count; i++) {
        const struct model *model = &frame->model;
        struct side side = frame->wireframe.sides[i];
        struct pixel a, b;
        if (to_pixel(model->positions[side.low], SIDE, SIDE, &a) &&
            to_pixel(model->positions[side.high], SIDE, SIDE, &b)) {
            walked += attempt_line_ends_rounded(&frame->timed, a, b, color_grey(255));
        }
    }
    return walked;
}

/* The scene as main.c draws it, from the list of sides made before or, with `anew`, made now. */
static void frame_draw_house(struct frame *frame, bool anew) {
    struct wireframe fresh = {0};
    struct error error;
    struct drawing *drawing = &frame->drawing;
    drawing->counter_count = 0;
    drawing->state = anew ? &fresh : &frame->wireframe;
    if (!anew || prepare(drawing, SIDE, SIDE, &error)) {
        draw_wireframe(drawing, &frame->timed, &error);
    }
    if (anew) {
        finish(drawing);
    }
}

/* A frame begins with an empty image. */
static void frame_run(void *state, int choice) {
    struct frame *frame = state;
    const struct model *model = &frame->model;
    const struct wireframe *list = &frame->wireframe;
    image_clear(&frame->timed, color_grey(0));
    switch (choice) {
    case EVERY_TESTED:
        frame->walked = attempt_1_every_side_tested(&frame->timed, model).tested;
        break;
    case EVERY_CUT:
        frame->walked = attempt_2_every_side_cut(&frame->timed, model).tested;
        break;
    case ONCE_TESTED:
        frame->walked =
            attempt_3_each_once_tested(&frame->timed, model, list->sides, list->side_count).tested;
        break;
    case ONE_DIRECTION:
        frame->walked = attempt_4_one_direction(&frame->timed, model).tested;
        break;
    case ENDS_ROUNDED:
        frame->walked = frame_draw_rounded(frame);
        break;
    default:
        frame_draw_house(frame, choice == LIST_ANEW);
    }
}

static double frame_error(void *state, int choice) {
    const struct frame *frame = state;
    (void)choice;
    return picture_error(&frame->exact, &frame->timed, 255);
}

/* What main.c walks it does not count: the same lines once more, counted. */
static uint64_t frame_count_house(const struct frame *frame) {
    struct work work = {0};
    struct image *image = (struct image *)&frame->timed;
    for (size_t i = 0; i < frame->wireframe.side_count; i++) {
        struct side side = frame->wireframe.sides[i];
        attempt_side(image, &frame->model, side.low, side.high, true, &work);
    }
    return work.tested;
}

static double frame_walked(const void *state, int choice) {
    const struct frame *frame = state;
    bool is_house = choice == HOUSE || choice == LIST_ANEW;
    uint64_t walked = is_house ? frame_count_house(frame) : frame->walked;
    return (double)walked / (double)frame->exact.pixel_count;
}

/* Read the bust, enlarged, with the middle of the face in the middle of the image. A square hole is
 * cut into it, so that it has a border. */
static bool frame_read_model(struct model *model, struct error *error) {
    if (!bench_read_model(model, "bust.obj", error)) {
        return false;
    }
    size_t kept = 0;
    for (size_t face = 0; face < model->face_count; face++) {
        struct vec3 p = model_position(model, face, 0);
        if (fabs(p.x) > hole || fabs(p.y - middle_y) > hole) {
            model->faces[kept++] = model->faces[face];
        }
    }
    model->face_count = kept;
    for (size_t i = 0; i < model->position_count; i++) {
        model->positions[i].x *= enlargement;
        model->positions[i].y = (model->positions[i].y - middle_y) * enlargement;
    }
    return true;
}

static void frame_find_exact(struct frame *frame) {
    const struct model *model = &frame->model;
    for (size_t face = 0; face < model->face_count; face++) {
        for (size_t i = 0; i < 3; i++) {
            struct pixel a, b;
            if (to_pixel(model_position(model, face, i), SIDE, SIDE, &a) &&
                to_pixel(model_position(model, face, (i + 1) % 3), SIDE, SIDE, &b)) {
                picture_add_line(&frame->exact, a, b);
            }
        }
    }
    picture_count(&frame->exact);
}

/* ---- Ways to cut a line ---- */

enum cut_version {
    COHEN_INT,
    COHEN_FLOAT,
    COHEN_DOUBLE,
    LIANG_FLOAT,
    LIANG_DOUBLE,
    EXACT_CUT,
    KEPT = 8 /* added where the ends are kept as they are, and not rounded to pixels */
};

/* The visible part of a line in numbers of one kind, from (x0,y0) to (x1,y1). */
struct part_float {
    float x0, y0, x1, y1;
};

struct part_double {
    double x0, y0, x1, y1;
};

struct part_int {
    int64_t x0, y0, x1, y1;
};

/* a / b to the nearest whole number, halves up. */
static inline int64_t nearest_quotient(int64_t a, int64_t b) {
    int64_t divisor = 2 * llabs(b);
    return floor_divide(b < 0 ? -2 * a - b : 2 * a + b, divisor);
}

static inline float quotient_float(float a, float b) {
    return a / b;
}

static inline double quotient_double(double a, double b) {
    return a / b;
}

/* Cohen and Sutherland: a bit for each border that an end lies beyond; one end after the other is
 * moved to a border until both are in the image, or both beyond the same border. (Newman, Sproull,
 * "Principles of Interactive Computer Graphics", 1973.) */
#define DEFINE_COHEN_SUTHERLAND(name, number, part, quotient)                                      \
    static inline unsigned beyond_##name(number x, number y) {                                     \
        return (x < 0 ? 1U : x > SIDE - 1 ? 2U : 0U) | (y < 0 ? 4U : y > SIDE - 1 ? 8U : 0U);      \
    }                                                                                              \
    static inline bool cohen_##name(struct pixel a, struct pixel b, struct part *cut) {            \
        struct part p = {(number)a.x, (number)a.y, (number)b.x, (number)b.y};                      \
        unsigned first = beyond_##name(p.x0, p.y0), last = beyond_##name(p.x1, p.y1);              \
        while ((first | last) != 0 && (first & last) == 0) {                                       \
            unsigned bits = first != 0 ? first : last;                                             \
            number x, y, dx = p.x1 - p.x0, dy = p.y1 - p.y0;                                       \
            if ((bits & 12) != 0) {                                                                \
                y = (bits & 4) != 0 ? 0 : SIDE - 1;                                                \
                x = p.x0 + quotient(dx * (y - p.y0), dy);                                          \
            } else {                                                                               \
                x = (bits & 1) != 0 ? 0 : SIDE - 1;                                                \
                y = p.y0 + quotient(dy * (x - p.x0), dx);                                          \
            }                                                                                      \
            if (first != 0) {                                                                      \
                p.x0 = x;                                                                          \
                p.y0 = y;                                                                          \
                first = beyond_##name(x, y);                                                       \
            } else {                                                                               \
                p.x1 = x;                                                                          \
                p.y1 = y;                                                                          \
                last = beyond_##name(x, y);                                                        \
            }                                                                                      \
        }                                                                                          \
        *cut = p;                                                                                  \
        return (first | last) == 0;                                                                \
    }

DEFINE_COHEN_SUTHERLAND(int, int64_t, part_int, nearest_quotient)
DEFINE_COHEN_SUTHERLAND(float, float, part_float, quotient_float)
DEFINE_COHEN_SUTHERLAND(double, double, part_double, quotient_double)

/* Liang and Barsky: the share of the line's length at which it enters and leaves, the same for all
 * four borders. ("A New Concept and Method for Line Clipping", 1984.) */
#define DEFINE_LIANG_BARSKY(number, part)                                                          \
    static inline bool liang_##number(struct pixel a, struct pixel b, struct part *cut) {          \
        number x = (number)a.x, y = (number)a.y, dx = (number)b.x - x, dy = (number)b.y - y;       \
        const number step[4] = {-dx, dx, -dy, dy};                                                 \
        const number room[4] = {x, SIDE - 1 - x, y, SIDE - 1 - y};                                 \
        number enter = 0, leave = 1;                                                               \
        for (int i = 0; i < 4; i++) {                                                              \
            if (step[i] == 0 && room[i] < 0) {                                                     \
                return false;                                                                      \
            }                                                                                      \
            number share = step[i] != 0 ? room[i] / step[i] : 0;                                   \
            enter = step[i] < 0 && share > enter ? share : enter;                                  \
            leave = step[i] > 0 && share < leave ? share : leave;                                  \
        }                                                                                          \
        *cut = (struct part){x + enter * dx, y + enter * dy, x + leave * dx, y + leave * dy};      \
        return enter <= leave;                                                                     \
    }

DEFINE_LIANG_BARSKY(float, part_float)
DEFINE_LIANG_BARSKY(double, part_double)

/* ---- Cut lines, drawn ---- */

/* The loop of main.c's line(): all lines that begin and end at pixels are drawn with it. */
static inline void draw_steps(struct image *image, const struct course *course, struct steps inside,
                              struct color color) {
    int64_t climbed = 2 * inside.first * course->rise;
    int64_t moved = course->run > 0 ? (climbed + course->run - 1) / (2 * course->run) : 0;
    int64_t error = climbed - course->run - 2 * course->run * moved;
    int64_t u = course->u + inside.first, v = course->v + course->v_step * moved;
    for (int64_t k = inside.first; k <= inside.last; k++) {
        image_set(image, (int)(course->steep ? v : u), (int)(course->steep ? u : v), color);
        u++;
        error += 2 * course->rise;
        if (error > 0) {
            v += course->v_step;
            error -= 2 * course->run;
        }
    }
}

static inline void draw_rounded(struct image *image, struct part_int part, struct color color) {
    struct pixel a = {(int)part.x0, (int)part.y0}, b = {(int)part.x1, (int)part.y1};
    struct course course = course_from(a, b);
    draw_steps(image, &course, (struct steps){0, course.run}, color);
}

static inline struct part_int rounded_float(struct part_float p) {
    return (struct part_int){(int)(p.x0 + 0.5F), (int)(p.y0 + 0.5F), (int)(p.x1 + 0.5F),
                             (int)(p.y1 + 0.5F)};
}

static inline struct part_int rounded_double(struct part_double p) {
    return (struct part_int){(int)(p.x0 + 0.5), (int)(p.y0 + 0.5), (int)(p.x1 + 0.5),
                             (int)(p.y1 + 0.5)};
}

/* A line whose ends are not pixels: from column to column (row to row), at the height of its
 * middle. */
#define DEFINE_DRAW_KEPT(number, part)                                                             \
    static inline void draw_##number(struct image *image, struct part p, struct color color) {     \
        const number half = (number)0.5;                                                           \
        number dx = p.x1 - p.x0, dy = p.y1 - p.y0;                                                 \
        bool steep = (dy < 0 ? -dy : dy) > (dx < 0 ? -dx : dx), back = (steep ? dy : dx) < 0;      \
        number u = back ? (steep ? p.y1 : p.x1) : (steep ? p.y0 : p.x0);                           \
        number v = back ? (steep ? p.x1 : p.y1) : (steep ? p.x0 : p.y0);                           \
        number run = steep ? dy : dx, rise = steep ? dx : dy;                                      \
        number slope = run != 0 ? rise / run : 0;                                                  \
        int last = (int)(u + (back ? -run : run) + half);                                          \
        for (int i = (int)(u + half); i <= last; i++) {                                            \
            int j = (int)(v + slope * ((number)i - u) + half);                                     \
            image_set(image, steep ? j : i, steep ? i : j, color);                                 \
        }                                                                                          \
    }

DEFINE_DRAW_KEPT(float, part_float)
DEFINE_DRAW_KEPT(double, part_double)

static inline void cut_float(struct image *image, struct pixel a, struct pixel b, int choice,
                             struct color color) {
    struct part_float part;
    bool is_seen =
        choice % KEPT == COHEN_FLOAT ? cohen_float(a, b, &part) : liang_float(a, b, &part);
    if (is_seen && choice >= KEPT) {
        draw_float(image, part, color);
    } else if (is_seen) {
        draw_rounded(image, rounded_float(part), color);
    }
}

static inline void cut_double(struct image *image, struct pixel a, struct pixel b, int choice,
                              struct color color) {
    struct part_double part;
    bool is_seen =
        choice % KEPT == COHEN_DOUBLE ? cohen_double(a, b, &part) : liang_double(a, b, &part);
    if (is_seen && choice >= KEPT) {
        draw_double(image, part, color);
    } else if (is_seen) {
        draw_rounded(image, rounded_double(part), color);
    }
}

static inline void cut_int(struct image *image, struct pixel a, struct pixel b,
                           struct color color) {
    struct part_int part;
    if (cohen_int(a, b, &part)) {
        draw_rounded(image, part, color);
    }
}

static inline void cut_exactly(struct image *image, struct pixel a, struct pixel b,
                               struct color color) {
    struct course course = course_from(a, b);
    draw_steps(image, &course, steps_inside(&course, SIDE, SIDE), color);
}

/* Choices of the other panels: so many for each length of the lines. Every one has a grey level of
 * its own, to tell what it drew from what others left. */
enum { CUTS = 2 * KEPT };

static uint8_t cut_level(int choice) {
    return (uint8_t)(1 + choice);
}

static void cut_run(void *state, int choice) {
    struct frame *frame = state;
    struct color color = color_grey(cut_level(choice));
    const int version = choice % CUTS;
    for (size_t i = 0; i < LINE_COUNT; i++) {
        struct pixel a = frame->ends[choice / CUTS][i][0], b = frame->ends[choice / CUTS][i][1];
        switch (version % KEPT) {
        case COHEN_FLOAT:
        case LIANG_FLOAT:
            cut_float(&frame->timed, a, b, version, color);
            break;
        case COHEN_DOUBLE:
        case LIANG_DOUBLE:
            cut_double(&frame->timed, a, b, version, color);
            break;
        case EXACT_CUT:
            cut_exactly(&frame->timed, a, b, color);
            break;
        default:
            cut_int(&frame->timed, a, b, color);
        }
    }
}

static double cut_error(void *state, int choice) {
    const struct frame *frame = state;
    return picture_error(&frame->exact_lines[choice / CUTS], &frame->timed, cut_level(choice));
}

static double cut_units(const void *state, int base) {
    (void)state;
    (void)base;
    return LINE_COUNT;
}

/* Lines through points of the image in all directions; the point lies anywhere in the middle part
 * of its line. */
static bool lines_setup(struct frame *frame, size_t panel, struct error *error) {
    struct random random = {5};
    if (!picture_create(&frame->exact_lines[panel], error)) {
        return false;
    }
    for (size_t i = 0; i < LINE_COUNT; i++) {
        double x = random_real(&random, 0, SIDE), y = random_real(&random, 0, SIDE);
        struct vec3 way = {random_real(&random, -1, 1), random_real(&random, -1, 1), 0};
        double length = (double)lengths[panel] * SIDE, before = random_real(&random, 0.2, 0.8);
        way = vec3_scale(vec3_normalized(way), length);
        struct pixel *ends = frame->ends[panel][i];
        ends[0] = (struct pixel){(int)(x - before * way.x), (int)(y - before * way.y)};
        ends[1] = (struct pixel){(int)(x + (1 - before) * way.x), (int)(y + (1 - before) * way.y)};
        picture_add_line(&frame->exact_lines[panel], ends[0], ends[1]);
    }
    picture_count(&frame->exact_lines[panel]);
    return true;
}

/* ---- The lesson ---- */

static bool frame_setup(void *state, struct error *error) {
    struct frame *frame = state;
    frame->drawing =
        (struct drawing){.model = &frame->model, .skip = true, .state = &frame->wireframe};
    if (!frame_read_model(&frame->model, error) ||
        !image_create(&frame->timed, SIDE, SIDE, IMAGE_GREY, error) ||
        !picture_create(&frame->exact, error) || !prepare(&frame->drawing, SIDE, SIDE, error)) {
        return false;
    }
    frame_find_exact(frame);
    return lines_setup(frame, 0, error) && lines_setup(frame, 1, error) &&
           lines_setup(frame, 2, error);
}

static void frame_teardown(void *state) {
    struct frame *frame = state;
    frame->drawing.state = &frame->wireframe;
    finish(&frame->drawing);
    model_free(&frame->model);
    image_free(&frame->timed);
    image_free(&frame->exact.image);
    for (size_t i = 0; i < LENGTH_COUNT; i++) {
        image_free(&frame->exact_lines[i].image);
    }
}

static const struct bench_version frame_versions[] = {
    VERSION("every side, pixels tested", EVERY_TESTED),
    VERSION("every side, cut", EVERY_CUT),
    VERSION("each once, pixels tested", ONCE_TESTED),
    VERSION("one direction only", ONE_DIRECTION),
    VERSION("each once, ends rounded", ENDS_ROUNDED),
    VERSION("list made every time", LIST_ANEW),
    HOUSE_VERSION("each once, cut (main.c)", HOUSE),
};

static const struct bench_version cut_versions[] = {
    VERSION("Cohen-S. int, rounded", COHEN_INT),
    VERSION("Cohen-S. float, rounded", COHEN_FLOAT),
    VERSION("Cohen-S. double, rounded", COHEN_DOUBLE),
    VERSION("Liang-B. float, rounded", LIANG_FLOAT),
    VERSION("Liang-B. double, rounded", LIANG_DOUBLE),
    VERSION("Cohen-S. float, kept", KEPT + COHEN_FLOAT),
    VERSION("Cohen-S. double, kept", KEPT + COHEN_DOUBLE),
    VERSION("Liang-B. float, kept", KEPT + LIANG_FLOAT),
    VERSION("Liang-B. double, kept", KEPT + LIANG_DOUBLE),
    HOUSE_VERSION("exact steps (main.c)", EXACT_CUT),
};

#define CUT_PANEL(heading, length)                                                                 \
    {                                                                                              \
        .title = (heading), .error_label = "wrong and missing pixels per 1000",                    \
        .time_label = "ns per line", .against = "exact integers", .house_within = BENCH_EXACT,     \
        .base = (length)*CUTS, .run = cut_run, .error = cut_error, .units = cut_units,             \
        BENCH_VERSIONS(cut_versions), .budget = 0.7                                                \
    }

static const struct bench_panel frame_panels[] = {
    {
        .title = "The bust with a hole, six times enlarged, on 800x800 pixels",
        .error_label = "wrong and missing pixels per 1000",
        .time_label = "ms per frame",
        .against = "exact integers",
        .house_within = BENCH_EXACT,
        BENCH_VERSIONS(frame_versions),
        .run = frame_run,
        .error = frame_error,
        .size = frame_walked,
        .size_label = "pixels walked for each that is seen",
    },
    CUT_PANEL("200 lines as long as the image is wide, cut at its borders: ends rounded or kept",
              0),
    CUT_PANEL("The same, 32 times as long", 1),
    CUT_PANEL("The same, 1,024 times as long", 2),
};

const struct bench_lesson bench_step02 = {
    .step = "step02_wireframe",
    .title = "Step 2: a wireframe",
    .state_size = sizeof(struct frame),
    .setup = frame_setup,
    .teardown = frame_teardown,
    .panels = frame_panels,
    .panel_count = sizeof frame_panels / sizeof frame_panels[0],
};
