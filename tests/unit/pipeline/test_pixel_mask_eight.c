/* Masks of four pixels: as on a processor with registers of 32 bytes. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 8
#include "pixel_mask_tests.h"
