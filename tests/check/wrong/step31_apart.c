/* Everything is one pixel further to the right, where the table allows less than that of edges. */
#include "picture.h"

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    picture(directory, "depth", 1, 1);
}
