/* Pixel arithmetic in float, four pixels at once. */
#define REAL  float
#define LANES 4
#include "lanes_tests.h"
