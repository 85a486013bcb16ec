/* One picture is right, two are black. */
#include "picture.h"

int main(int argc, char **argv) {
    static const struct picture black;
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    picture(directory, "depth", 0, 1);
    picture_save(&black, PICTURE_SIZE, directory, "depth2");
    picture_save(&black, PICTURE_SIZE, directory, "depth3");
    if (argc > 3 && strcmp(argv[3], "--stats") == 0) {
        printf("depth.pixels: 5\ndepth2.pixels: 5\ndepth3.pixels: 0\n");
    }
}
