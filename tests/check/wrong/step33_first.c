/* The first scene ends the program; the second is right where it is drawn alone. */
#include "picture.h"

int main(int argc, char **argv) {
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    if (argc < 5 || strcmp(argv[4], "depth") == 0) {
        abort();
    }
    picture(directory, "depth2", 0, 1);
}
