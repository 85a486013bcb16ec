/* A function that is called and not there: the compiler warns of it, and the linker fails. */

int main(void) {
    return no_such_function();
}
