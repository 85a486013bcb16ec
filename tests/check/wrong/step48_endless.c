/* All but the last scene take for ever, and so does the program when it draws all of them. */
#include "picture.h"

#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    while (argc < 5 || strcmp(argv[4], "depth5") != 0) {
        sleep(1);
    }
    picture(directory, "depth5", 0, 1);
}
