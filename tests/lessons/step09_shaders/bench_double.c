/* Step 9: the loops over pixels in double, for sixteen pixels at once. */
#undef REAL
#undef LANES
#undef REAL
#define REAL double
#undef LANES
#define LANES 16
#define WAYS  ways_double
#define main  step09_double_main
int step09_double_main(int argc, char **argv);
#include "loops.h"
