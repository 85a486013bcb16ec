/* An assertion fails. */
#include "picture.h"

#include <assert.h>

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    assert(directory[0] == 0);
}
