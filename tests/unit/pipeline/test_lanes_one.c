/* Pixel arithmetic for a debugger: one pixel at a time, plain numbers. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 1
#include "lanes_tests.h"
