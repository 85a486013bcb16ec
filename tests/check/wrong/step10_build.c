/* A mistake that the compiler finds. */
#include "picture.h"

int main(void) {
    return no_such_variable;
}
