/* Every value that is drawn is three too light, or three too dark: all colours agree. */
#include "picture.h"

static void add(struct picture *p, int levels) {
    unsigned char *values = p->bgr[0][0];
    for (size_t i = 0; i < sizeof p->bgr; i++) {
        values[i] = (unsigned char)(values[i] > 0 ? values[i] + levels : 0);
    }
}

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    static struct picture p;
    if (directory == NULL) {
        return 2;
    }
    picture_draw(&p, 0, 1);
    add(&p, 3);
    picture_save(&p, PICTURE_SIZE, directory, "depth");
    add(&p, -6);
    picture_save(&p, PICTURE_SIZE, directory, "depth2");
}
