/* Strips of eight columns: as on a processor with registers of 64 bytes. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 16
#include "pipeline_again.h"

#include "strips_tests.h"
