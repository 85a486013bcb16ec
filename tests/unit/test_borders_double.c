/* The same borders in double, eight pixels at once. */
#define REAL  double
#define LANES 8
#include "pipeline_again.h"

#include "borders_tests.h"
