/* Strips of as many columns as this machine covers at once. */
#include "pipeline_again.h"

#include "strips_tests.h"
