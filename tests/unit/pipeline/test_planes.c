/* Planes of several pieces at once, as the tests are built. */
#include "planes_tests.h"
