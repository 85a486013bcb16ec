/* Step 9: the loops over pixels in double, for sixteen pixels at once. */
#undef REAL
#define REAL double
#undef LANES
#define LANES 16
#define WAYS  ways_double
#include "loops.h"
