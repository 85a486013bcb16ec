/* Pixel arithmetic for a debugger: one pixel at a time, plain numbers. */
#define REAL  float
#define LANES 1
#include "lanes_tests.h"
