/* The same positions, four at once: as on a processor with registers of 32 bytes. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 8
#include "pipeline_again.h"

#include "transform_tests.h"
