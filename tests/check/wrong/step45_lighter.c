/* Every value that is drawn is three too light, or three too dark: all colours agree. */
#include "picture.h"

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    static struct picture p;
    if (directory == NULL) {
        return 2;
    }
    picture_draw(&p, 0, 1);
    picture_add(&p, 3);
    picture_save(&p, PICTURE_SIZE, directory, "depth");
    picture_add(&p, -6);
    picture_save(&p, PICTURE_SIZE, directory, "depth2");
}
