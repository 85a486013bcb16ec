/* Triangles classified several at once, as the tests are built. */
#include "batch_tests.h"
