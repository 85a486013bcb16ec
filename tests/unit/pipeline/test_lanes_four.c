/* Pixel arithmetic in float, four pixels at once. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 4
#include "lanes_tests.h"
