/* The picture is right, but the program says that it failed. */
#include "picture.h"

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    picture(directory, "depth", 0, 1);
    fprintf(stderr, "\n-----\nstep09_status: bust.obj:17: face names\tvertex 99 of 12\nmore\n");
    return 1;
}
