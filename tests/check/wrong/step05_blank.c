/* Nothing is drawn into the picture. */
#include "picture.h"

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    static struct picture p;
    picture_save(&p, PICTURE_SIZE, directory, "depth");
}
