/* SVG charts: see chart.h. Coordinates here are SVG's: y goes down. */
#include "chart.h"

#include "geometry.h"

#include <assert.h>
#include <math.h>
#include <string.h>

enum {
    CHART_WIDTH = 820,
    HEAD_HEIGHT = 52,   /* the lesson's title and the key */
    PANEL_HEIGHT = 460, /* a panel with its title and axes */
    FOOT_HEIGHT = 29,
    PLOT_LEFT = 76,
    PLOT_RIGHT = 800,
    PLOT_TOP = 44,     /* below the panel's top */
    PLOT_BOTTOM = 380, /* also below the panel's top */
    PLOT_MARGIN = 24,  /* from the plot's sides to the ends of the scale for errors */
    EXACT_WIDTH = 220, /* of the place next to that scale, for errors of 0 */
    EXACT_RIGHT = PLOT_LEFT + EXACT_WIDTH,
    LABEL_HEIGHT = 15,
    MARK_RADIUS = 5,
    TAKEN_LIMIT = 4096
};

/* A generous guess of how wide a letter of a label (12 pixels high) is, in any sans-serif font. */
static const double letter_width = 7.0;

/* ---- Output ---- */

/* With nothing in it that markup would want escaped. */
static void put_text(FILE *svg, const char *class, double x, double y, const char *text) {
    assert(strpbrk(text, "<&") == NULL);
    fprintf(svg, "<text class=\"%s\" x=\"%.1f\" y=\"%.1f\">%s</text>\n", class, x, y, text);
}

static void put_line(FILE *svg, const char *class, double x0, double y0, double x1, double y1) {
    fprintf(svg, "<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n", class,
            x0, y0, x1, y1);
}

/* ---- Axes ---- */

/* A logarithmic scale: values from low to high lie at from_px to to_px. */
struct axis {
    double low, high;
    double from_px, to_px;
};

static double axis_px(const struct axis *axis, double value) {
    double part = log10(value / axis->low) / log10(axis->high / axis->low);
    return axis->from_px + (axis->to_px - axis->from_px) * part;
}

/* The smallest of 1, 2, 5 times a power of ten that is more than `value`. */
static double round_number_above(double value) {
    double power = pow(10, floor(log10(value) + 1e-9)), leading = value / power;
    return power * (leading < 0.999 ? 1 : leading < 1.999 ? 2 : leading < 4.999 ? 5 : 10);
}

/* Its ends are round numbers, with some room. */
static struct axis make_axis(double least, double most, double from_px, double to_px) {
    struct axis axis = {.from_px = from_px, .to_px = to_px};
    axis.high = round_number_above(most * 1.1);
    axis.low = 1 / round_number_above(1.1 / least);
    return axis;
}

/* The next of the round numbers on the axis: 1 2 5 10 20 50 ..., or powers of ten on a long one. */
static double next_tick(const struct axis *axis, double tick) {
    double next = round_number_above(tick);
    return axis->high / axis->low < 2000 ? next : pow(10, ceil(log10(next) - 1e-9));
}

static double first_tick(const struct axis *axis) {
    return next_tick(axis, 0.99 * axis->low);
}

/* A tick's number: "0.05", "20", "1000000" would be too wide: "1e6". */
static void show_tick(double value, char text[32]) {
    int power = (int)floor(log10(value) + 1e-9);
    if (power < -3 || power > 5) {
        snprintf(text, 32, "%.2ge%d", value / pow(10, power), power);
    } else {
        snprintf(text, 32, "%.6g", value);
    }
}

/* ---- Where things are ---- */

struct box {
    double left, top, right, bottom;
};

/* A version on the chart. */
struct mark {
    const struct bench_version *version;
    const struct bench_result *result;
    const char *color;             /* the class that gives it its colour */
    double x, y, y_upper, y_lower; /* the dot, and the ends of its bar */
    double label_x, label_y;       /* where its label begins or ends, half-way up */
    const char *anchor;            /* the class that says which: "start", "middle", "end" */
    double leader; /* the part of the way there that a line leads; 0: the label is near */
};

struct plot {
    struct axis error, time;
    bool has_scale, has_exact; /* errors above 0, errors of 0 */
    double top, bottom;
    const char *series[BENCH_SERIES_LIMIT];
    int series_count;
    struct mark marks[BENCH_VERSION_LIMIT];
    size_t count;
    struct box taken[TAKEN_LIMIT]; /* by marks, lines of series, and labels */
    size_t taken_count;
};

static void plot_axes(struct plot *plot, const struct bench_result *results) {
    double least = INFINITY, most = 0, fastest = INFINITY, slowest = 0;
    for (size_t i = 0; i < plot->count; i++) {
        double error = results[i].error;
        plot->has_exact = plot->has_exact || error == 0;
        plot->has_scale = plot->has_scale || error > 0;
        least = error > 0 ? fmin(least, error) : least;
        most = fmax(most, error);
        fastest = fmin(fastest, results[i].lower);
        slowest = fmax(slowest, results[i].upper);
    }
    double left = PLOT_LEFT + PLOT_MARGIN + (plot->has_exact ? EXACT_WIDTH : 0);
    if (plot->has_scale) {
        plot->error = make_axis(least, most, left, PLOT_RIGHT - PLOT_MARGIN);
    }
    plot->time = make_axis(fastest, slowest, plot->bottom, plot->top);
}

/* The colour of a version: of its series, or of the useful ones without. */
static const char *find_color(struct plot *plot, const struct bench_version *version, bool useful) {
    static const char *const colors[BENCH_SERIES_LIMIT] = {"s0", "s1", "s2", "s3"};
    int k = 0;
    if (version->series == NULL) {
        return useful ? "best" : "plain";
    }
    while (k < plot->series_count && strcmp(plot->series[k], version->series) != 0) {
        k++;
    }
    if (k == plot->series_count) {
        assert(k < BENCH_SERIES_LIMIT);
        plot->series[plot->series_count++] = version->series;
    }
    return colors[k];
}

static struct box box_around(double x, double y, double half_width, double half_height) {
    return (struct box){x - half_width, y - half_height, x + half_width, y + half_height};
}

static void take(struct plot *plot, struct box box) {
    assert(plot->taken_count < TAKEN_LIMIT);
    plot->taken[plot->taken_count++] = box;
}

/* The mark that the line of a series comes from to mark i; NULL where it begins. */
static const struct mark *before_in_series(const struct plot *plot, size_t i) {
    const char *series = plot->marks[i].version->series;
    while (series != NULL && i-- > 0) {
        const char *other = plot->marks[i].version->series;
        if (other != NULL && strcmp(other, series) == 0) {
            return &plot->marks[i];
        }
    }
    return NULL;
}

/* Many points of a line take a small box each. */
static void take_line(struct plot *plot, const struct mark *from, const struct mark *to) {
    int count = (int)(hypot(to->x - from->x, to->y - from->y) / 6) + 1;
    for (int i = 1; i < count; i++) {
        double x = from->x + (to->x - from->x) * i / count;
        double y = from->y + (to->y - from->y) * i / count;
        take(plot, box_around(x, y, 3, 3));
    }
}

static void plot_marks(struct plot *plot, const struct bench_panel *panel,
                       const struct bench_result *results) {
    for (size_t i = 0; i < plot->count; i++) {
        const struct bench_result *r = &results[i];
        struct mark m = {
            .version = &panel->versions[i],
            .result = r,
            .color = find_color(plot, &panel->versions[i], r->front),
            .x = r->error > 0 ? axis_px(&plot->error, r->error) : PLOT_LEFT + PLOT_MARGIN,
            .y = axis_px(&plot->time, r->median),
            .y_upper = axis_px(&plot->time, r->upper),
            .y_lower = axis_px(&plot->time, r->lower),
        };
        double middle = (m.y_upper + m.y_lower) / 2, half = (m.y_lower - m.y_upper) / 2;
        take(plot, box_around(m.x, m.y, MARK_RADIUS + 4, MARK_RADIUS + 4));
        take(plot, box_around(m.x, middle, MARK_RADIUS, half));
        plot->marks[i] = m;
        const struct mark *before = before_in_series(plot, i);
        if (before != NULL) {
            take_line(plot, before, &plot->marks[i]);
        }
    }
}

/* ---- Labels ---- */

static bool is_free(const struct plot *plot, struct box box) {
    bool free = box.left > PLOT_LEFT && box.right < PLOT_RIGHT && box.top > plot->top &&
                box.bottom < plot->bottom;
    for (size_t i = 0; i < plot->taken_count; i++) {
        const struct box *other = &plot->taken[i];
        free = free && !(box.left < other->right && other->left < box.right &&
                         box.top < other->bottom && other->top < box.bottom);
    }
    return free;
}

/* Try places in circles around the dot, first at its right, then at its left. The first that is
 * free is the label's; where none is, the last. */
static void place_label(struct plot *plot, struct mark *mark) {
    enum { DIRECTIONS = 16, CIRCLES = 12 };
    const double pi = 3.14159265358979;
    double width = letter_width * (double)strlen(mark->version->name) + 4;
    struct box box = {0};
    for (int i = 0; i < DIRECTIONS * CIRCLES; i++) {
        double angle = pi * (i % 2) + 2 * pi * (i % DIRECTIONS / 2) / DIRECTIONS;
        double far = MARK_RADIUS + 5 + 6 * (i / DIRECTIONS);
        const struct vec2 way = {cos(angle), 1.3 * sin(angle)};
        int side = way.x > 0.3 ? 1 : way.x < -0.3 ? -1 : 0; /* of the dot; 0 is above or below */
        mark->label_x = mark->x + far * way.x;
        mark->label_y = mark->y + far * way.y;
        mark->anchor = side > 0 ? "start" : side < 0 ? "end" : "middle";
        mark->leader = i < 2 * DIRECTIONS ? 0 : 1 - 6 / far;
        box = box_around(mark->label_x + side * width / 2, mark->label_y, width / 2,
                         LABEL_HEIGHT / 2.0);
        if (is_free(plot, box)) {
            break;
        }
    }
    take(plot, box);
}

/* ---- Drawing ---- */

static void draw_style(FILE *svg) {
    fputs("<style>\n"
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
          ".bar, .leader { stroke: #818b98; stroke-width: 1; }\n"
          /* A series colours what belongs to it with `color`. */
          ".plain { color: #3d444d; }\n"
          ".best, .s0 { color: #0a5cc2; }\n"
          ".s1 { color: #b35900; }\n"
          ".s2 { color: #1a7f37; }\n"
          ".s3 { color: #8250df; }\n"
          ".dot { fill: #ffffff; stroke: currentColor; stroke-width: 1.5; }\n"
          ".filled { fill: currentColor; stroke: currentColor; stroke-width: 1.5; }\n"
          ".series { stroke: currentColor; stroke-width: 1; opacity: 0.6; }\n"
          ".name { fill: currentColor; }\n"
          "@media (prefers-color-scheme: dark) {\n"
          "text { fill: #e6edf3; }\n"
          ".tick, .foot, .label { fill: #a0aab5; }\n"
          ".paper { fill: #0d1117; }\n"
          ".plot { fill: #151b23; stroke: #3d444d; }\n"
          ".grid { stroke: #2b323b; }\n"
          ".bar, .leader { stroke: #8b949e; }\n"
          ".plain { color: #c5ccd3; }\n"
          ".best, .s0 { color: #79b8ff; }\n"
          ".s1 { color: #f0a050; }\n"
          ".s2 { color: #56d364; }\n"
          ".s3 { color: #d2a8ff; }\n"
          ".dot { fill: #151b23; }\n"
          ".filled, .name { fill: currentColor; }\n"
          "}\n"
          "</style>\n",
          svg);
}

static void draw_error_axis(FILE *svg, const struct plot *plot) {
    double last = 0, end = plot->has_scale ? plot->error.high * 1.001 : 0;
    for (double tick = first_tick(&plot->error); tick < end; tick = next_tick(&plot->error, tick)) {
        char text[32];
        double x = axis_px(&plot->error, tick);
        put_line(svg, "grid", x, plot->top, x, plot->bottom);
        if (x - last > 40) { /* room for its number */
            show_tick(tick, text);
            put_text(svg, "tick middle", x, plot->bottom + 16, text);
            last = x;
        }
    }
    if (plot->has_exact) {
        put_text(svg, "middle", PLOT_LEFT + PLOT_MARGIN, plot->bottom + 16, "exact");
        put_line(svg, "bar", EXACT_RIGHT, plot->top, EXACT_RIGHT, plot->bottom + 8);
    }
}

static void draw_time_axis(FILE *svg, const struct plot *plot) {
    double last = INFINITY, end = plot->time.high * 1.001;
    for (double tick = first_tick(&plot->time); tick < end; tick = next_tick(&plot->time, tick)) {
        char text[32];
        double y = axis_px(&plot->time, tick);
        put_line(svg, "grid", PLOT_LEFT, y, PLOT_RIGHT, y);
        if (last - y > 13) {
            show_tick(tick, text);
            put_text(svg, "tick end", PLOT_LEFT - 6, y + 4, text);
            last = y;
        }
    }
}

/* The names of the series above the plot, up to its right end. */
static void draw_legend(FILE *svg, const struct plot *plot) {
    double left = PLOT_RIGHT, y = plot->top - 11;
    for (int k = plot->series_count - 1; k >= 0; k--) {
        char class[32];
        left -= letter_width * (double)strlen(plot->series[k]) + 28;
        fprintf(svg, "<circle class=\"filled s%d\" cx=\"%.1f\" cy=\"%.1f\" r=\"4\"/>\n", k,
                left + 20, y - 4);
        snprintf(class, sizeof class, "name s%d", k);
        put_text(svg, class, left + 28, y, plot->series[k]);
    }
}

/* From quartile to quartile, and the way to a label that is farther away. */
static void draw_bar(FILE *svg, const struct mark *mark) {
    if (mark->leader > 0) {
        put_line(svg, "leader", mark->x, mark->y,
                 mark->x + mark->leader * (mark->label_x - mark->x),
                 mark->y + mark->leader * (mark->label_y - mark->y));
    }
    fprintf(svg, "<path class=\"bar\" d=\"M%.1f,%.1fh8m-4,0V%.1fm-4,0h8\"/>\n", mark->x - 4,
            mark->y_upper, mark->y_lower);
}

static void draw_dot(FILE *svg, const struct mark *mark) {
    char error[32], median[32];
    const struct bench_version *version = mark->version;
    bench_show_number(mark->result->error, error);
    bench_show_number(mark->result->median, median);
    fprintf(svg, "<circle class=\"%s %s\" cx=\"%.1f\" cy=\"%.1f\" r=\"%d\"><title>",
            mark->result->front ? "filled" : "dot", mark->color, mark->x, mark->y, MARK_RADIUS);
    fprintf(svg, "%s%s%s: error %s, time %s</title></circle>\n",
            version->series != NULL ? version->series : "", version->series != NULL ? ", " : "",
            version->name, error, median);
}

static void draw_label(FILE *svg, const struct mark *mark) {
    char class[64];
    snprintf(class, sizeof class, "name %s %s%s", mark->anchor, mark->color,
             mark->version->is_house ? " house" : "");
    put_text(svg, class, mark->label_x, mark->label_y + 4, mark->version->name);
}

static void draw_marks(FILE *svg, const struct plot *plot) {
    for (size_t i = 0; i < plot->count; i++) {
        const struct mark *mark = &plot->marks[i], *before = before_in_series(plot, i);
        if (before != NULL) {
            char class[32];
            snprintf(class, sizeof class, "series %s", mark->color);
            put_line(svg, class, before->x, before->y, mark->x, mark->y);
        }
        draw_bar(svg, mark);
    }
    for (size_t i = 0; i < plot->count; i++) {
        draw_dot(svg, &plot->marks[i]);
    }
    for (size_t i = 0; i < plot->count; i++) {
        draw_label(svg, &plot->marks[i]);
    }
}

static void draw_captions(FILE *svg, const struct bench_panel *panel, const struct plot *plot) {
    char text[512];
    put_text(svg, "title", 20, plot->top - 30, panel->title);
    snprintf(text, sizeof text, "%s, logarithmic scale", panel->time_label);
    put_text(svg, "label", 20, plot->top - 11, text);
    snprintf(text, sizeof text, "error: %s, against %s%s", panel->error_label, panel->against,
             plot->has_scale ? ", logarithmic scale" : "");
    put_text(svg, "label middle", (PLOT_LEFT + PLOT_RIGHT) / 2.0, plot->bottom + 35, text);
}

static void draw_panel(FILE *svg, const struct bench_panel *panel,
                       const struct bench_result *results, double top) {
    struct plot plot = {
        .count = panel->version_count,
        .top = top + PLOT_TOP,
        .bottom = top + PLOT_BOTTOM,
    };
    plot_axes(&plot, results);
    plot_marks(&plot, panel, results);
    for (size_t i = plot.count; i-- > 0;) {
        place_label(&plot, &plot.marks[i]);
    }
    fprintf(svg, "<rect class=\"plot\" x=\"%d\" y=\"%.1f\" width=\"%d\" height=\"%.1f\"/>\n",
            PLOT_LEFT, plot.top, PLOT_RIGHT - PLOT_LEFT, plot.bottom - plot.top);
    draw_captions(svg, panel, &plot);
    draw_time_axis(svg, &plot);
    draw_error_axis(svg, &plot);
    draw_legend(svg, &plot);
    draw_marks(svg, &plot);
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
    char line[256];
    FILE *file = fopen("/proc/cpuinfo", "r");
    name[0] = '\0';
    while (file != NULL && name[0] == '\0' && fgets(line, sizeof line, file) != NULL) {
        sscanf(line, "model name : %127[^\n]", name);
    }
    if (file != NULL) {
        fclose(file);
    }
}

void chart_draw(const struct bench_lesson *lesson, const struct bench_results *results, FILE *svg) {
    int height = HEAD_HEIGHT + (int)lesson->panel_count * PANEL_HEIGHT + FOOT_HEIGHT;
    char processor[128], text[512];
    snprintf(text, sizeof text, "%s: run time against error", lesson->title);
    fprintf(svg,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
            "height=\"%d\" role=\"img\">\n<title>%s</title>\n",
            CHART_WIDTH, height, CHART_WIDTH, height, text);
    draw_style(svg);
    fprintf(svg, "<rect class=\"paper\" width=\"%d\" height=\"%d\"/>\n", CHART_WIDTH, height);
    put_text(svg, "head", 20, 28, text);
    put_text(svg, "foot", 20, 46,
             "Filled dots: nothing is both faster and more accurate. Bold: the lesson's own. "
             "Bars: from quartile to quartile.");
    for (size_t i = 0; i < lesson->panel_count; i++) {
        draw_panel(svg, &lesson->panels[i], results->of[i], HEAD_HEIGHT + (double)i * PANEL_HEIGHT);
    }
    find_processor(processor);
    snprintf(text, sizeof text, "%s%s%s", compiler(), processor[0] != '\0' ? ", " : "", processor);
    put_text(svg, "foot", 20, height - 13, text);
    fputs("</svg>\n", svg);
}
