/* Pixel arithmetic in float, two pixels at once: without an instruction for that, in plain C. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 2
#include "lanes_tests.h"
