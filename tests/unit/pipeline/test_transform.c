/* The positions of a model, as many at once as this machine takes. */
#include "pipeline_again.h"

#include "transform_tests.h"
