/* SVG charts: see chart.h. Coordinates here are SVG's: y goes down. */
#include "chart.h"

#include "check/page/escape.h"
#include "report.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum {
    CHART_WIDTH = 820,
    HEAD_HEIGHT = 44,   /* the lesson's title and the key */
    PANEL_HEIGHT = 460, /* a panel with its title and axes */
    FOOT_HEIGHT = 37,
    PLOT_LEFT = 76,
    PLOT_RIGHT = 800,
    PLOT_TOP = 44,            /* below the panel's top */
    PLOT_BOTTOM = 380,        /* also below the panel's top */
    PLACE_WIDTH = 200,        /* of the place next to the scale, for errors of 0 */
    PLACE_WIDTH_SERIES = 110, /* the same where labels are short */
    TICK_LIMIT = 64,
    LABEL_HEIGHT = 15,
    MARK_RADIUS = 5
};

/* A generous guess of how wide a letter of a label (12 pixels high) is, in any sans-serif font. */
static const double letter_width = 7.0;

/* ---- Output ---- */

/* A text to which much is appended: after the first failure, which leaves its message, nothing more
 * is. */
struct output {
    struct bytes *text;
    struct error *error;
    bool done;
};

static void put(struct output *output, const char *format, ...) PRINTF_LIKE(2, 3);

/* Append as printf does, at most 1023 characters at a time. */
static void put(struct output *output, const char *format, ...) {
    char piece[1024];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(piece, sizeof piece, format, arguments);
    va_end(arguments);
    if (output->done && (length < 0 || length >= (int)sizeof piece)) {
        output->done = error_set(output->error, "a line of the report is too long");
    }
    output->done = output->done && (bytes_append(output->text, piece, (size_t)length) ||
                                    error_out_of_memory(output->error));
}

static void put_escaped(struct output *output, const char *text) {
    output->done =
        output->done && (escape_markup(output->text, text) || error_out_of_memory(output->error));
}

static void put_text(struct output *output, const char *class, double x, double y,
                     const char *text) {
    put(output, "<text class=\"%s\" x=\"%.1f\" y=\"%.1f\">", class, x, y);
    put_escaped(output, text);
    put(output, "</text>\n");
}

static void put_line(struct output *output, const char *class, double x0, double y0, double x1,
                     double y1) {
    put(output, "<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n", class, x0,
        y0, x1, y1);
}

/* ---- Axes ---- */

/* Values from low to high lie at from_px to to_px. */
struct axis {
    bool logarithmic;
    double low, high;
    double from_px, to_px;
};

static double axis_px(const struct axis *axis, double value) {
    double part = axis->logarithmic ? log10(value / axis->low) / log10(axis->high / axis->low)
                                    : (value - axis->low) / (axis->high - axis->low);
    return axis->from_px + (axis->to_px - axis->from_px) * part;
}

/* The largest of 1, 2, 5 times a power of ten that is at most `value`, or the smallest that is at
 * least. */
static double round_number(double value, bool up) {
    static const double steps[] = {1, 2, 5, 10};
    double power = pow(10, floor(log10(value) + 1e-9)), rounded = power;
    for (int i = 0; i < 4; i++) {
        double step = steps[i] * power;
        if (up ? step >= value * (1 - 1e-9) : step <= value * (1 + 1e-9)) {
            rounded = step;
            if (up) {
                break;
            }
        }
    }
    return rounded;
}

/* A scale for positive values least..most: logarithmic where they differ by more than `ratio`,
 * otherwise from 0. */
static struct axis make_axis(double least, double most, double ratio, double from_px,
                             double to_px) {
    struct axis axis = {.logarithmic = most > ratio * least, .from_px = from_px, .to_px = to_px};
    if (axis.logarithmic) {
        axis.low = round_number(least / 1.02, false);
        axis.high = round_number(most * 1.02, true);
    } else {
        double step = round_number(most / 5, true);
        axis.high = step * ceil(most * 1.08 / step);
    }
    return axis;
}

/* Round numbers on an axis, from low to high. Returns how many. */
static int axis_ticks(const struct axis *axis, double ticks[TICK_LIMIT]) {
    int count = 0;
    if (!axis->logarithmic) {
        double step = round_number(axis->high / 5, true);
        for (int i = 0; i * step <= axis->high * (1 + 1e-9) && count < TICK_LIMIT; i++) {
            ticks[count++] = i * step;
        }
        return count;
    }
    double decades = log10(axis->high / axis->low);
    for (double tick = axis->low; tick <= axis->high * (1 + 1e-9) && count < TICK_LIMIT;) {
        bool power = fabs(log10(tick) - floor(log10(tick) + 0.5)) < 1e-6;
        if (decades <= 3.2 || power) {
            ticks[count++] = tick;
        }
        tick = round_number(tick * 1.9, true); /* 1 2 5 10 20 50 ... */
    }
    return count;
}

/* A tick's number: "0.05", "20", "1000000" would be too wide: "1e6". */
static void show_tick(double value, char text[32]) {
    double size = fabs(value);
    if (size != 0 && (size < 0.9e-3 || size > 0.9e6)) {
        int power = (int)floor(log10(size) + 1e-9);
        snprintf(text, 32, "%.2ge%d", value / pow(10, power), power);
    } else {
        snprintf(text, 32, "%.6g", value);
    }
}

/* ---- Where things are ---- */

struct label_box {
    double left, top, right, bottom;
};

static bool boxes_overlap(struct label_box a, struct label_box b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

struct point {
    double x, y;
};

/* Does the segment come into the box? Cut it to the box's slabs and see whether anything is left
 * (Liang and Barsky, "A New Concept and Method for Line Clipping", 1984). */
static bool segment_meets(struct point a, struct point b, struct label_box box) {
    double first = 0, last = 1;
    const double from[2] = {a.x, a.y}, step[2] = {b.x - a.x, b.y - a.y};
    const double low[2] = {box.left, box.top}, high[2] = {box.right, box.bottom};
    for (int i = 0; i < 2; i++) {
        if (step[i] == 0) {
            if (from[i] < low[i] || from[i] > high[i]) {
                return false;
            }
            continue;
        }
        double enter = (low[i] - from[i]) / step[i], leave = (high[i] - from[i]) / step[i];
        first = fmax(first, fmin(enter, leave));
        last = fmin(last, fmax(enter, leave));
    }
    return first < last;
}

/* A version on the chart. */
struct mark {
    const struct bench_version *version;
    const struct bench_result *result;
    int series;                    /* its place in plot.series; -1: none */
    double x, y, y_upper, y_lower; /* the dot, and the ends of its bar */
    struct label_box label;
    const char *anchor; /* the class that ties the text to the box's side: "", "middle", "end" */
    bool has_label, has_leader;
    struct point leader; /* where the leader line meets the label */
};

/* A line that a label should not cover, and how bad it is if it does. */
struct chart_line {
    struct point from, to;
    double cost;
};

struct plot {
    struct axis error, time;
    double exact_x; /* the place for an error of 0 */
    bool has_scale, has_exact;
    bool exact_apart; /* 0 is not on the scale, but in its own place at the left */
    double place_width;
    double top, bottom;
    const char *series[BENCH_SERIES_LIMIT];
    int series_count;
    struct mark marks[BENCH_VERSION_LIMIT];
    size_t count;
    size_t front[BENCH_VERSION_LIMIT]; /* the useful marks, from the most accurate to the fastest */
    size_t front_count;
    struct chart_line lines[3 * BENCH_VERSION_LIMIT];
    size_t line_count;
};

static void plot_axes(struct plot *plot, const struct bench_result *results) {
    double least = INFINITY, most = 0, fastest = INFINITY, slowest = 0;
    for (size_t i = 0; i < plot->count; i++) {
        double error = results[i].error;
        plot->has_exact = plot->has_exact || error == 0;
        if (error > 0) {
            plot->has_scale = true;
            least = fmin(least, error);
            most = fmax(most, error);
        }
        fastest = fmin(fastest, results[i].lower);
        slowest = fmax(slowest, results[i].upper);
    }
    plot->place_width = plot->series_count > 0 ? PLACE_WIDTH_SERIES : PLACE_WIDTH;
    if (plot->has_scale) {
        plot->error = make_axis(least, most, 4, PLOT_LEFT + 24, PLOT_RIGHT - 24);
        /* A scale from 0 has a place for 0 on it; a logarithmic one has none. */
        plot->exact_apart = plot->has_exact && plot->error.logarithmic;
        plot->error.from_px += plot->exact_apart ? plot->place_width : 0;
        plot->exact_x = PLOT_LEFT + 24;
    } else {
        plot->exact_x = PLOT_LEFT + (PLOT_RIGHT - PLOT_LEFT) / 3.0;
    }
    plot->time = make_axis(fastest, slowest, 10, plot->bottom, plot->top);
}

/* The place of a version's series among those that have appeared so far; -1 for none. */
static int series_place(struct plot *plot, const char *name) {
    int k = 0;
    while (k < plot->series_count && plot->series[k] != name) {
        k++;
    }
    if (name != NULL && k == plot->series_count) {
        assert(plot->series_count < BENCH_SERIES_LIMIT);
        plot->series[plot->series_count++] = name;
    }
    return name != NULL ? k : -1;
}

static void plot_marks(struct plot *plot, const struct bench_panel *panel,
                       const struct bench_result *results) {
    for (size_t i = 0; i < plot->count; i++) {
        const struct bench_result *r = &results[i];
        plot->marks[i] = (struct mark){
            .version = &panel->versions[i],
            .result = r,
            .series = plot->marks[i].series,
            .anchor = "",
            .x = r->error > 0 ? axis_px(&plot->error, r->error) : plot->exact_x,
            .y = axis_px(&plot->time, r->median),
            .y_upper = axis_px(&plot->time, r->upper),
            .y_lower = axis_px(&plot->time, r->lower),
        };
    }
}

static void plot_front(struct plot *plot) {
    for (size_t i = 0; i < plot->count; i++) {
        const struct bench_result *r = plot->marks[i].result;
        if (!r->front) {
            continue;
        }
        size_t k = plot->front_count++;
        for (; k > 0 && plot->marks[plot->front[k - 1]].result->error > r->error; k--) {
            plot->front[k] = plot->front[k - 1];
        }
        plot->front[k] = i;
    }
}

/* ---- Labels ---- */

static struct label_box dot_box(const struct mark *mark) {
    const double r = MARK_RADIUS + 2;
    return (struct label_box){mark->x - r, mark->y - r, mark->x + r, mark->y + r};
}

static struct label_box bar_box(const struct mark *mark) {
    return (struct label_box){mark->x - 5, fmin(mark->y_upper, mark->y) - 2, mark->x + 5,
                              fmax(mark->y_lower, mark->y) + 2};
}

/* The mark that the line of a series goes to from mark i; NULL at its end. */
static const struct mark *next_of_series(const struct plot *plot, size_t i) {
    for (size_t j = i + 1; plot->marks[i].series >= 0 && j < plot->count; j++) {
        if (plot->marks[j].series == plot->marks[i].series) {
            return &plot->marks[j];
        }
    }
    return NULL;
}

static void add_line(struct plot *plot, struct point from, struct point to, double cost) {
    plot->lines[plot->line_count++] = (struct chart_line){from, to, cost};
}

/* The lines of the series, and the stair of the useful versions. */
static void plot_lines(struct plot *plot) {
    for (size_t i = 0; i < plot->count; i++) {
        const struct mark *a = &plot->marks[i], *b = next_of_series(plot, i);
        if (b != NULL) {
            add_line(plot, (struct point){a->x, a->y}, (struct point){b->x, b->y}, 12);
        }
    }
    for (size_t k = 0; k + 1 < plot->front_count; k++) {
        const struct mark *a = &plot->marks[plot->front[k]], *b = &plot->marks[plot->front[k + 1]];
        const struct point corner = {b->x, a->y};
        add_line(plot, (struct point){a->x, a->y}, corner, 40);
        add_line(plot, corner, (struct point){b->x, b->y}, 40);
    }
}

/* So that two labels do not read as one. */
static struct label_box with_gap(struct label_box box) {
    enum { GAP = 4 };
    return (struct label_box){box.left - GAP, box.top, box.right + GAP, box.bottom};
}

/* How bad it is that a label or its leader would cover another mark, or that one's label or leader
 * this label. */
static double cost_beside(const struct mark *mark, const struct mark *other) {
    const struct point dot = {mark->x, mark->y}, other_dot = {other->x, other->y};
    double cost = boxes_overlap(mark->label, dot_box(other)) ? 200 : 0;
    cost += boxes_overlap(mark->label, bar_box(other)) ? 60 : 0;
    if (other == mark) {
        return cost;
    }
    if (mark->has_leader) {
        cost += segment_meets(dot, mark->leader, dot_box(other)) ? 6 : 0;
    }
    if (other->has_label) {
        cost += boxes_overlap(with_gap(mark->label), other->label) ? 500 : 0;
        cost += mark->has_leader && segment_meets(dot, mark->leader, other->label) ? 100 : 0;
        cost += other->has_leader && segment_meets(other_dot, other->leader, mark->label) ? 100 : 0;
    }
    return cost;
}

static double place_cost(const struct plot *plot, const struct mark *mark) {
    const struct label_box box = mark->label;
    bool outside = box.left < PLOT_LEFT + 2 || box.right > PLOT_RIGHT - 2 ||
                   box.top < plot->top + 1 || box.bottom > plot->bottom - 1;
    double along = (box.left + box.right) / 2 < mark->x ? box.right - mark->x : box.left - mark->x;
    double far = fabs(along) + 1.2 * fabs((box.top + box.bottom) / 2 - mark->y);
    double cost = (outside ? 1000 : 0) + far / 8;
    for (size_t i = 0; i < plot->line_count; i++) {
        const struct chart_line *line = &plot->lines[i];
        cost += segment_meets(line->from, line->to, box) ? line->cost : 0;
    }
    for (size_t i = 0; i < plot->count; i++) {
        cost += cost_beside(mark, &plot->marks[i]);
    }
    return cost;
}

enum side { TO_THE_RIGHT, TO_THE_LEFT, ABOVE_OR_BELOW };

/* Put the label at a distance from the dot; `down` is where the middle of its height lies. */
static void put_label(struct mark *mark, enum side side, double across, double down) {
    double width = letter_width * (double)strlen(mark->version->name) + 4;
    double left = mark->x - width / 2, middle = mark->y + down;
    mark->anchor = "middle";
    if (side == TO_THE_RIGHT) {
        left = mark->x + across;
        mark->anchor = "";
    } else if (side == TO_THE_LEFT) {
        left = mark->x - across - width;
        mark->anchor = "end";
    }
    mark->label = (struct label_box){left, middle - LABEL_HEIGHT / 2.0, left + width,
                                     middle + LABEL_HEIGHT / 2.0};
    double near = MARK_RADIUS + 15;
    mark->has_leader =
        side == ABOVE_OR_BELOW ? fabs(down) > near : fabs(down) > 9 || across > near - 4;
    mark->leader = (struct point){fmin(fmax(mark->x, left), left + width), middle};
    if (side == ABOVE_OR_BELOW) {
        mark->leader.y = down > 0 ? mark->label.top : mark->label.bottom;
    }
}

static void place_label(const struct plot *plot, struct mark *mark) {
    const double distances[] = {MARK_RADIUS + 5, MARK_RADIUS + 19, 44, 70, 100};
    double best_cost = INFINITY;
    struct mark best = *mark;
    for (enum side side = TO_THE_RIGHT; side <= ABOVE_OR_BELOW; side++) {
        for (size_t i = 0; i < sizeof distances / sizeof distances[0]; i++) {
            for (int step = -40; step <= 40; step++) {
                double down = 5 * step;
                if (side == ABOVE_OR_BELOW && (fabs(down) < MARK_RADIUS + 9 || i > 0)) {
                    continue;
                }
                put_label(mark, side, distances[i], down);
                double cost = place_cost(plot, mark);
                if (cost < best_cost) {
                    best_cost = cost;
                    best = *mark;
                }
            }
        }
    }
    *mark = best;
    mark->has_label = true;
}

/* Three times: after the first, each knows where all others are. */
static void place_labels(struct plot *plot) {
    for (size_t i = 0; i < 3 * plot->count; i++) {
        place_label(plot, &plot->marks[i % plot->count]);
    }
}

/* ---- Drawing ---- */

static void draw_style(struct output *output) {
    put(output, "<style>\n"
                "text { font-family: sans-serif; font-size: 12px; fill: #1f2328; }\n"
                ".head { font-size: 17px; font-weight: bold; }\n"
                ".title { font-size: 13px; font-weight: bold; }\n"
                ".tick, .foot { fill: #59636e; font-size: 11px; }\n"
                ".label { fill: #59636e; }\n"
                ".house { font-weight: bold; }\n"
                ".middle { text-anchor: middle; }\n"
                ".end { text-anchor: end; }\n"
                ".paper { fill: #ffffff; }\n"
                ".plot { fill: #f6f8fa; stroke: #d1d9e0; }\n"
                ".grid { stroke: #d8dee4; stroke-width: 1; }\n"
                ".bar, .leader, .break { stroke: #818b98; stroke-width: 1; }\n"
                ".gap { stroke: #ffffff; stroke-width: 5; }\n");
    /* A series colours what belongs to it with `color`. */
    put(output, ".plain { color: #818b98; }\n"
                ".best, .s0 { color: #0a5cc2; }\n"
                ".s1 { color: #b35900; }\n"
                ".s2 { color: #1a7f37; }\n"
                ".s3 { color: #8250df; }\n"
                ".dot { fill: #ffffff; stroke: currentColor; stroke-width: 1.5; }\n"
                ".filled { fill: currentColor; stroke: currentColor; stroke-width: 1.5; }\n"
                ".series { fill: none; stroke: currentColor; stroke-width: 1; opacity: 0.6; }\n"
                ".front { fill: none; stroke: #59636e; stroke-width: 1.5; "
                "stroke-dasharray: 5 4; }\n"
                ".name { fill: currentColor; }\n");
    put(output, "@media (prefers-color-scheme: dark) {\n"
                "text { fill: #e6edf3; }\n"
                ".tick, .foot, .label { fill: #a0aab5; }\n"
                ".paper { fill: #0d1117; }\n"
                ".plot { fill: #151b23; stroke: #3d444d; }\n"
                ".grid { stroke: #2b323b; }\n"
                ".bar, .leader, .break { stroke: #8b949e; }\n"
                ".gap { stroke: #0d1117; }\n"
                ".plain { color: #8b949e; }\n"
                ".best, .s0 { color: #79b8ff; }\n"
                ".s1 { color: #f0a050; }\n"
                ".s2 { color: #56d364; }\n"
                ".s3 { color: #d2a8ff; }\n"
                ".dot { fill: #151b23; }\n"
                ".front { stroke: #a0aab5; }\n"
                ".filled, .name { fill: currentColor; }\n"
                "}\n"
                "</style>\n");
}

/* Two strokes across the axis where it breaks off: what lies beyond is not on the scale. */
static void draw_break(struct output *output, const struct plot *plot, double x) {
    put_line(output, "grid", x, plot->top, x, plot->bottom);
    put_line(output, "gap", x, plot->bottom - 5, x, plot->bottom + 5);
    put_line(output, "break", x - 5, plot->bottom + 6, x - 1, plot->bottom - 6);
    put_line(output, "break", x + 1, plot->bottom + 6, x + 5, plot->bottom - 6);
}

static void draw_error_axis(struct output *output, const struct plot *plot) {
    double ticks[TICK_LIMIT];
    int count = plot->has_scale ? axis_ticks(&plot->error, ticks) : 0;
    double last = -1000;
    put(output, "<path class=\"grid\" d=\"");
    for (int i = 0; i < count; i++) {
        put(output, "M%.1f,%.1fV%.1f", axis_px(&plot->error, ticks[i]), plot->top, plot->bottom);
    }
    put(output, "\"/>\n");
    for (int i = 0; i < count; i++) {
        char text[32];
        double x = axis_px(&plot->error, ticks[i]);
        bool is_exact = ticks[i] == 0 && plot->has_exact; /* "exact" is written there */
        if (x - last > 40 && !is_exact) {                 /* room for its number */
            show_tick(ticks[i], text);
            put_text(output, "tick middle", x, plot->bottom + 16, text);
            last = x;
        }
    }
    if (plot->has_exact) {
        put_text(output, "middle", plot->exact_x, plot->bottom + 16, "exact");
    }
    if (plot->exact_apart) {
        draw_break(output, plot, PLOT_LEFT + plot->place_width);
    }
}

static void draw_time_axis(struct output *output, const struct plot *plot) {
    double ticks[TICK_LIMIT];
    int count = axis_ticks(&plot->time, ticks);
    double last = 1e6;
    put(output, "<path class=\"grid\" d=\"");
    for (int i = 0; i < count; i++) {
        put(output, "M%d,%.1fH%d", PLOT_LEFT, axis_px(&plot->time, ticks[i]), PLOT_RIGHT);
    }
    put(output, "\"/>\n");
    for (int i = 0; i < count; i++) {
        char text[32];
        double y = axis_px(&plot->time, ticks[i]);
        if (last - y > 13) {
            show_tick(ticks[i], text);
            put_text(output, "tick end", PLOT_LEFT - 6, y + 4, text);
            last = y;
        }
    }
}

/* The border of what the useful versions leave to no other: a stair. */
static void draw_front(struct output *output, const struct plot *plot) {
    if (plot->front_count < 2) {
        return;
    }
    put(output, "<polyline class=\"front\" points=\"");
    for (size_t k = 0; k < plot->front_count; k++) {
        const struct mark *mark = &plot->marks[plot->front[k]];
        if (k > 0) {
            put(output, "%.1f,%.1f ", mark->x, plot->marks[plot->front[k - 1]].y);
        }
        put(output, "%.1f,%.1f ", mark->x, mark->y);
    }
    put(output, "\"/>\n");
}

static void draw_series(struct output *output, const struct plot *plot) {
    for (int k = 0; k < plot->series_count; k++) {
        put(output, "<polyline class=\"series s%d\" points=\"", k);
        for (size_t i = 0; i < plot->count; i++) {
            if (plot->marks[i].series == k) {
                put(output, "%.1f,%.1f ", plot->marks[i].x, plot->marks[i].y);
            }
        }
        put(output, "\"/>\n");
    }
}

/* Of the name of a series with its dot and the space before it. */
static double legend_width(const char *name) {
    return letter_width * (double)strlen(name) + 28;
}

/* The names of the series above the plot, at its right. */
static void draw_legend(struct output *output, const struct plot *plot) {
    double left = PLOT_RIGHT, y = plot->top - 11;
    for (int k = 0; k < plot->series_count; k++) {
        left -= legend_width(plot->series[k]);
    }
    for (int k = 0; k < plot->series_count; k++) {
        char class[32];
        put(output, "<circle class=\"filled s%d\" cx=\"%.1f\" cy=\"%.1f\" r=\"4\"/>\n", k,
            left + 20, y - 4);
        snprintf(class, sizeof class, "name s%d", k);
        put_text(output, class, left + 28, y, plot->series[k]);
        left += legend_width(plot->series[k]);
    }
}

/* From quartile to quartile, and the way to a label that is farther away. */
static void draw_bars(struct output *output, const struct plot *plot) {
    for (size_t i = 0; i < plot->count; i++) {
        const struct mark *mark = &plot->marks[i];
        if (mark->has_leader) {
            put_line(output, "leader", mark->x, mark->y, mark->leader.x, mark->leader.y);
        }
        put(output, "<path class=\"bar\" d=\"M%.1f,%.1fh8m-4,0V%.1fm-4,0h8\"/>\n", mark->x - 4,
            mark->y_upper, mark->y_lower);
    }
}

/* The class that gives a mark its colour. */
static const char *mark_color(const struct mark *mark) {
    static const char *const classes[BENCH_SERIES_LIMIT] = {"s0", "s1", "s2", "s3"};
    if (mark->series >= 0) {
        return classes[mark->series];
    }
    return mark->result->front ? "best" : "plain";
}

static void draw_dot(struct output *output, const struct plot *plot, const struct mark *mark) {
    char error[32], median[32];
    bench_show_number(mark->result->error, error);
    bench_show_number(mark->result->median, median);
    put(output, "<circle class=\"%s %s\" cx=\"%.1f\" cy=\"%.1f\" r=\"%d\"><title>",
        mark->result->front ? "filled" : "dot", mark_color(mark), mark->x, mark->y, MARK_RADIUS);
    if (mark->series >= 0) {
        put_escaped(output, plot->series[mark->series]);
        put(output, ", ");
    }
    put_escaped(output, mark->version->name);
    put(output, ": error %s, time %s</title></circle>\n", error, median);
}

static void draw_label(struct output *output, const struct mark *mark) {
    char class[64];
    bool is_colored = mark->series >= 0 || mark->result->front;
    snprintf(class, sizeof class, "%s%s%s%s", mark->anchor, mark->version->is_house ? " house" : "",
             is_colored ? " name " : "", is_colored ? mark_color(mark) : "");
    double x = (mark->label.left + mark->label.right) / 2;
    if (strcmp(mark->anchor, "middle") != 0) {
        x = mark->anchor[0] == '\0' ? mark->label.left + 2 : mark->label.right - 2;
    }
    put_text(output, class, x, mark->label.bottom - 3.5, mark->version->name);
}

static void draw_captions(struct output *output, const struct bench_panel *panel,
                          const struct plot *plot, double top) {
    const double middle = (PLOT_LEFT + PLOT_RIGHT) / 2.0;
    char text[512];
    put_text(output, "title", 20, top + 14, panel->title);
    snprintf(text, sizeof text, "%s%s", panel->time_label,
             plot->time.logarithmic ? ", logarithmic scale" : ", from 0");
    put_text(output, "label", 20, top + 33, text);
    snprintf(text, sizeof text, "error: %s, against %s", panel->error_label, panel->against);
    put_text(output, "label middle", middle, plot->bottom + 35, text);
    snprintf(text, sizeof text, "%s%s",
             !plot->has_scale          ? ""
             : plot->error.logarithmic ? "logarithmic scale"
                                       : "linear scale from 0",
             plot->exact_apart ? "; 0 is left of the break" : "");
    put_text(output, "tick middle", middle, plot->bottom + 52, text);
}

static void draw_panel(struct output *output, const struct bench_panel *panel,
                       const struct bench_result *results, double top) {
    struct plot plot = {
        .count = panel->version_count,
        .top = top + PLOT_TOP,
        .bottom = top + PLOT_BOTTOM,
    };
    for (size_t i = 0; i < plot.count; i++) {
        plot.marks[i].series = series_place(&plot, report_series(panel, i));
    }
    plot_axes(&plot, results);
    plot_marks(&plot, panel, results);
    plot_front(&plot);
    plot_lines(&plot);
    place_labels(&plot);
    put(output, "<rect class=\"plot\" x=\"%d\" y=\"%.1f\" width=\"%d\" height=\"%.1f\"/>\n",
        PLOT_LEFT, plot.top, PLOT_RIGHT - PLOT_LEFT, plot.bottom - plot.top);
    draw_captions(output, panel, &plot, top);
    draw_legend(output, &plot);
    draw_time_axis(output, &plot);
    draw_error_axis(output, &plot);
    draw_front(output, &plot);
    draw_series(output, &plot);
    draw_bars(output, &plot);
    for (size_t i = 0; i < plot.count; i++) {
        draw_dot(output, &plot, &plot.marks[i]);
    }
    for (size_t i = 0; i < plot.count; i++) {
        draw_label(output, &plot.marks[i]);
    }
}

/* ---- All of it ---- */

static const char *compiler(void) {
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "gcc " __VERSION__;
#else
    return "an unknown compiler";
#endif
}

static void find_processor(char name[128]) {
    static const char key[] = "model name\t: ";
    char line[256];
    FILE *file = fopen("/proc/cpuinfo", "r");
    name[0] = '\0';
    while (file != NULL && name[0] == '\0' && fgets(line, sizeof line, file) != NULL) {
        if (strncmp(line, key, sizeof key - 1) == 0) {
            line[strcspn(line, "\n")] = '\0';
            snprintf(name, 128, "%.127s", line + sizeof key - 1);
        }
    }
    if (file != NULL) {
        fclose(file);
    }
}

bool chart_draw(const struct bench_lesson *lesson, const struct bench_results *results,
                struct bytes *svg, struct error *error) {
    struct output output = {svg, error, true};
    int height = HEAD_HEIGHT + (int)lesson->panel_count * PANEL_HEIGHT + FOOT_HEIGHT;
    char processor[128], text[512];
    put(&output,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
        "height=\"%d\" role=\"img\">\n<title>",
        CHART_WIDTH, height, CHART_WIDTH, height);
    put_escaped(&output, lesson->title);
    put(&output, ": run time against error</title>\n");
    draw_style(&output);
    put(&output, "<rect class=\"paper\" width=\"%d\" height=\"%d\"/>\n", CHART_WIDTH, height);
    snprintf(text, sizeof text, "%s: run time against error", lesson->title);
    put_text(&output, "head", 20, 28, text);
    put_text(&output, "foot", 20, 46,
             "Filled dots, dashed stair: nothing is both faster and more accurate. Bold: the "
             "lesson's own. Bars: from quartile to quartile.");
    for (size_t i = 0; i < lesson->panel_count; i++) {
        draw_panel(&output, &lesson->panels[i], results->of[i],
                   HEAD_HEIGHT + (double)i * PANEL_HEIGHT + 8);
    }
    find_processor(processor);
    snprintf(text, sizeof text, "%s%s%s", compiler(), processor[0] != '\0' ? ", " : "", processor);
    put_text(&output, "foot", 20, height - 13, text);
    put(&output, "</svg>\n");
    return output.done;
}
