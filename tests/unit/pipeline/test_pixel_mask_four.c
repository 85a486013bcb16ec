/* Masks of two pixels: as on a processor with registers of 16 bytes. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 4
#include "pixel_mask_tests.h"
