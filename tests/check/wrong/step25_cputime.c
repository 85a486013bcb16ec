/* The signal of a program that has used up its processor time. */
#include "picture.h"

#include <signal.h>

int main(void) {
    raise(SIGXCPU);
    return 0;
}
