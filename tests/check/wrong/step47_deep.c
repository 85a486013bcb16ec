/* It nests directories deeper than files can be open, under a name to which the check would move
 * them, and waits until it is stopped for that. */
#include "picture.h"

#include <sys/stat.h>
#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL || chdir(directory) != 0) {
        return 2;
    }
    for (int i = 0; i < 700; i++) {
        if (mkdir("lifted.0", 0700) != 0 || chdir("lifted.0") != 0) {
            return 3;
        }
    }
    sleep(60);
    return 0;
}
