/* Interleaved measurements: see measure.h. */
#define _POSIX_C_SOURCE 200809L
#include "measure.h"

#include "timing.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>

enum { ROUNDS_LEAST = 5, ROUNDS_WANTED = 31, ROUNDS_MOST = 501, CALLS_MOST = 1000000 };

/* A sample is no longer than this where a run is not: many short samples make a better median than
 * a few long ones. */
static const double sample_seconds_most = 0.002;

static struct bench_choice choice_of(const struct bench_panel *panel, size_t i) {
    return (struct bench_choice){panel->versions[i].way, panel->on + panel->versions[i].on};
}

/* Seconds of one call. */
static double time_calls(const struct bench_panel *panel, size_t i, size_t calls) {
    struct stopwatch start = stopwatch_start();
    for (size_t k = 0; k < calls; k++) {
        panel->run(choice_of(panel, i));
    }
    return stopwatch_seconds(start) / (double)calls;
}

/* Run a version until it has had its share of the warm-up, and find from that how many runs make a
 * sample of `sample_seconds`. */
static size_t warm_up(const struct bench_panel *panel, size_t i, double sample_seconds) {
    double best = time_calls(panel, i, 1), start = now();
    while (now() - start < sample_seconds) {
        double again = time_calls(panel, i, 1);
        best = again < best ? again : best;
    }
    double calls = best > 0 ? floor(sample_seconds / best + 0.5) : CALLS_MOST;
    return calls < 1 ? 1 : calls > CALLS_MOST ? CALLS_MOST : (size_t)calls;
}

static void summarize(struct bench_result *result, double *samples, double scale) {
    sort_doubles(samples, result->rounds);
    result->median = scale * quantile(samples, result->rounds, 0.5);
    result->lower = scale * quantile(samples, result->rounds, 0.25);
    result->upper = scale * quantile(samples, result->rounds, 0.75);
}

/* Is error a as small as error b? One per cent more counts as equal: the inputs are a sample. */
static bool as_accurate(double a, double b) {
    return a <= b * 1.01;
}

/* Times tremble: what differs by less than 2 per cent, or whose quartiles overlap, is equal. So
 * chance does not decide who is useful. */
static bool is_faster(const struct bench_result *a, const struct bench_result *b) {
    return a->median < 0.98 * b->median && a->upper < b->lower;
}

static bool is_better(const struct bench_result *a, const struct bench_result *b) {
    bool as_good = as_accurate(a->error, b->error) && !is_faster(b, a);
    return as_good && (!as_accurate(b->error, a->error) || is_faster(a, b));
}

static void mark_front(const struct bench_panel *panel, struct bench_result *results) {
    const struct bench_version *versions = panel->versions;
    for (size_t i = 0; i < panel->version_count; i++) {
        results[i].front = true;
        for (size_t j = 0; j < panel->version_count; j++) {
            bool compared = !panel->many_inputs || versions[i].on == versions[j].on;
            results[i].front &= !(compared && is_better(&results[j], &results[i]));
        }
    }
}

static void measure_panel(const struct bench_panel *panel, double seconds,
                          struct bench_result *results) {
    const size_t count = panel->version_count;
    double samples[BENCH_VERSION_LIMIT][ROUNDS_MOST + 1];
    size_t rounds = 0;
    assert(count <= BENCH_VERSION_LIMIT);
    double start = now();
    double sample_seconds =
        fmin(seconds / (double)(count * (ROUNDS_WANTED + 2)), sample_seconds_most);
    for (size_t i = 0; i < count; i++) {
        results[i].calls = warm_up(panel, i, sample_seconds);
    }
    while (rounds < ROUNDS_LEAST || (rounds < ROUNDS_MOST && now() - start < seconds)) {
        for (size_t k = 0; k < count; k++) {
            /* Each round begins with another version, and every other one goes backwards: nobody
             * always runs after the same neighbour. */
            size_t turn = (k + rounds / 2) % count, i = rounds % 2 ? count - 1 - turn : turn;
            samples[i][rounds] = time_calls(panel, i, results[i].calls);
        }
        rounds++;
    }
    double scale = panel->units != NULL ? 1e9 / (double)*panel->units : 1e3;
    for (size_t i = 0; i < count; i++) {
        /* The last sample is judged before the next version overwrites it. */
        samples[i][rounds] = time_calls(panel, i, results[i].calls);
        results[i].error = panel->error(choice_of(panel, i));
        results[i].rounds = rounds + 1;
        summarize(&results[i], samples[i], scale);
    }
    mark_front(panel, results);
}

static double panel_share(const struct bench_panel *panel) {
    return panel->budget > 0 ? panel->budget : 1;
}

bool bench_measure(const struct bench_lesson *lesson, double seconds, struct bench_results *results,
                   struct error *error) {
    double shares = 0;
    assert(lesson->panel_count <= BENCH_PANEL_LIMIT);
    for (size_t i = 0; i < lesson->panel_count; i++) {
        shares += panel_share(&lesson->panels[i]);
    }
    bool ready = lesson->setup(error);
    for (size_t i = 0; ready && i < lesson->panel_count; i++) {
        const struct bench_panel *panel = &lesson->panels[i];
        measure_panel(panel, seconds * panel_share(panel) / shares, results->of[i]);
    }
    return ready;
}

void bench_show_number(double value, char text[32]) {
    double size = fabs(value);
    if (size != 0 && (size < 1e-3 || size >= 1e6)) {
        snprintf(text, 32, "%.2e", value);
        return;
    }
    int decimals = size >= 100 || size == 0 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
    decimals = size != 0 && size < 0.1 ? size < 0.01 ? 5 : 4 : decimals;
    snprintf(text, 32, "%.*f", decimals, value);
}
