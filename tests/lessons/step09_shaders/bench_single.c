/* Step 9: the loops over pixels in float, for one pixel at a time. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 1
#define WAYS  ways_single
#include "loops.h"
