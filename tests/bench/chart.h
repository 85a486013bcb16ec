/*
 * Charts of run time against error, as SVG: error across, time up, the useful versions filled.
 *
 * The same numbers give the same bytes. Colours follow the reader's light or dark scheme; labels
 * are placed so that they cover neither each other nor the marks.
 */
#ifndef TESTS_BENCH_CHART_H
#define TESTS_BENCH_CHART_H

#include "measure.h"

#include <stdio.h>

/* Write the chart of a lesson, its panels one above the other, to `svg`. */
void chart_draw(const struct bench_lesson *lesson, const struct bench_results *results, FILE *svg);

#endif
