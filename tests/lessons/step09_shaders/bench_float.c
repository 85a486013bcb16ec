/* Step 9: the loops over pixels in float, for sixteen pixels at once: as the pipeline has them. */
#undef REAL
#undef LANES
#undef REAL
#define REAL float
#undef LANES
#define LANES 16
#define WAYS  ways_float
#define main  step09_float_main
int step09_float_main(int argc, char **argv);
#include "loops.h"
