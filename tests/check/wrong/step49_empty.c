/* A program without main(). */
#include "picture.h"
