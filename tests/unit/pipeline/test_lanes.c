/* Pixel arithmetic in float, sixteen pixels at once. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 16
#include "lanes_tests.h"
