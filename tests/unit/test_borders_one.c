/* The same borders with one pixel at a time, for a debugger. */
#define REAL  float
#define LANES 1
#include "pipeline_again.h"

#include "borders_tests.h"
