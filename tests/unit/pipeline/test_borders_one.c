/* The same borders with one pixel at a time, for a debugger. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 1
#include "pipeline_again.h"

#include "borders_tests.h"
