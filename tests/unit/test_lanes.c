/* Pixel arithmetic in float, sixteen pixels at once. */
#define REAL  float
#define LANES 16
#include "lanes_tests.h"
