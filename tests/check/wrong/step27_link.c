/* In place of its directory it leaves a link that leads nowhere. */
#include "picture.h"

#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    return rmdir(directory) != 0 || symlink("/nowhere/at/all", directory) != 0;
}
