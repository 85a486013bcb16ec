/* In place of its directory it leaves a link to another one, and crashes: what is started there
 * next says where it is. */
#include "picture.h"

#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    char here[1000], moved[1010];
    if (directory == NULL || getcwd(here, sizeof here) == NULL) {
        return 2;
    }
    if (argc > 3) { /* --only */
        witness("one scene in %s\n", here);
        return 1;
    }
    snprintf(moved, sizeof moved, "%s.moved", directory);
    if (rename(directory, moved) == 0 && symlink("/usr", directory) == 0) {
        abort();
    }
    return 1;
}
