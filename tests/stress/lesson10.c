#include "stress.h"
const struct property lesson10_properties[] = {{.name = NULL}};
