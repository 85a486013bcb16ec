/* The same borders with sixteen pixels at once: a chunk is one step. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 16
#include "pipeline_again.h"

#include "borders_tests.h"
