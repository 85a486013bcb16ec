/* Pixel arithmetic in double, eight pixels at once. */
#undef REAL
#define REAL double
#undef LANES
#define LANES 8
#include "lanes_tests.h"
