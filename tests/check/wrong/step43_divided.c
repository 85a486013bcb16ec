/* Draws one picture, and then ends as a division by 0 does. */
#include "picture.h"

#include <signal.h>

int main(int argc, char **argv) {
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    picture(directory, "depth", 0, 1);
    raise(SIGFPE);
}
