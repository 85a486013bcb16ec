/* The borders of bands, chunks, blocks and viewports, as the tests are built. */
#include "borders_tests.h"
