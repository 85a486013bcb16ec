/* The same pieces with double for pixel arithmetic. */
#undef REAL
#define REAL double
#undef LANES
#define LANES 16
#include "pipeline_again.h"

#include "planes_tests.h"
