/* Step 9: the loops over pixels in float, for sixteen pixels at once: as the pipeline has them. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 16
#define WAYS  ways_float
#include "loops.h"
