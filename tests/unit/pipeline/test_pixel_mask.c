/* Masks of as many pixels as this machine takes at once. */
#include "pixel_mask_tests.h"
