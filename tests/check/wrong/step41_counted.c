/* Right pictures, too little work in both. */
#include "picture.h"

int main(int argc, char **argv) {
    const char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    picture(directory, "depth", 0, 1);
    picture(directory, "depth2", 0, 1);
    if (argc > 3 && strcmp(argv[3], "--stats") == 0) {
        printf("depth.pixels: 5\ndepth.rows: 7\ndepth2.pixels: 5\ndepth2.rows: 8\n");
    }
}
