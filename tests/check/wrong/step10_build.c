/* A mistake that the compiler finds. */
#include <stdio.h>

int main(void) {
    return no_such_variable;
}
