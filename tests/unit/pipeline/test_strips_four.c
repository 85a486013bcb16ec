/* Strips of two columns: as on a processor with registers of 16 bytes. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 4
#include "pipeline_again.h"

#include "strips_tests.h"
