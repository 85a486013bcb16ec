/* Pixel arithmetic in double, eight pixels at once. */
#define REAL  double
#define LANES 8
#include "lanes_tests.h"
