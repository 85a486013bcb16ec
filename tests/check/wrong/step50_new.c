/* Of a scene that is new the program dies. */
#include "picture.h"

int main(int argc, char **argv) {
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    if (argc > 3) {
        abort();
    }
    picture(directory, "depth", 0, 1);
}
