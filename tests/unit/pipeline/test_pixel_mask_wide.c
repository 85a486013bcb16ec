/* Masks of eight pixels: as on a processor with registers of 64 bytes. */
#undef REAL
#define REAL float
#undef LANES
#define LANES 16
#include "pixel_mask_tests.h"
