/* The same borders in double, eight pixels at once. */
#undef REAL
#define REAL double
#undef LANES
#define LANES 8
#include "pipeline_again.h"

#include "borders_tests.h"
