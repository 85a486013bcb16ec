#include "verdict.h"

struct verdict verdict_find(const struct comparison *shares, const struct checked_item *scene) {
    const struct verdict limits[] = {
        {false, COMPARE_UNMATCHED, &shares->wrong, scene->wrong_limit, "wrong"},
        {false, COMPARE_COVERAGE, &shares->coverage, scene->coverage_limit, "missing or too many"},
        {false, COMPARE_APART, &shares->apart, scene->apart_limit, "with another colour"},
        {false, COMPARE_DIFFERING, &shares->near, scene->near_limit, "a little too light or dark"},
    };
    if (scene->exact) {
        bool passes = shares->differing.count == 0;
        return (struct verdict){passes, COMPARE_DIFFERING, &shares->differing, 0, NULL};
    }
    for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        if (limits[i].tally == &shares->near && !is_as_light(shares)) {
            return (struct verdict){false, COMPARE_DIFFERING, &shares->near, 0, NULL};
        }
        if (!share_within(limits[i].tally->count, shares->drawn, limits[i].limit)) {
            return limits[i];
        }
    }
    return (struct verdict){true, COMPARE_UNMATCHED, &shares->differing, 0, NULL};
}
