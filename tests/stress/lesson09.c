#include "stress.h"
const struct property lesson09_properties[] = {{.name = NULL}};
