/* Right in both scenes, or in the one that is wanted. */
#include "picture.h"

int main(int argc, char **argv) {
    int one = argc == 5 && strcmp(argv[3], "--only") == 0;
    const char *directory = (argc == 3 || one) && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    if (one) {
        witness("one scene of %ld\n", 2);
    }
    if (!one || strcmp(argv[4], "depth") == 0) {
        picture(directory, "depth", 0, 1);
    }
    if (!one || strcmp(argv[4], "depth2") == 0) {
        picture(directory, "depth2", 0, 1);
    }
}
