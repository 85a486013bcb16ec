/* Pixel arithmetic in float, eight pixels at once. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 8
#include "lanes_tests.h"
