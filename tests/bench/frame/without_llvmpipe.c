/* Stands in for llvmpipe.c where Mesa is not installed. */
#include "llvmpipe.h"

const struct llvmpipe_functions *const llvmpipe = NULL;
