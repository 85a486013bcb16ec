/* Step 9: the loops over pixels in float, for one pixel at a time. */
#undef REAL
#undef LANES
#undef REAL
#define REAL float
#undef LANES
#define LANES 1
#define WAYS  ways_single
#define main  step09_single_main
int step09_single_main(int argc, char **argv);
#include "loops.h"
