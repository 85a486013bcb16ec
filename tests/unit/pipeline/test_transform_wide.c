/* The same positions, eight at once: as on a processor with registers of 64 bytes. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 16
#include "pipeline_again.h"

#include "transform_tests.h"
