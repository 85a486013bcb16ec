/* A program without main(). */
#include <stdio.h>
