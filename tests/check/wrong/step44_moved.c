/* It draws in a new directory of the name that its own had, and leaves its own under another; given
 * a scene that is new, it does the same with the directory above, and leaves a link that leads
 * nowhere. */
#include "picture.h"

#include <sys/stat.h>
#include <unistd.h>

static int move_above(char *directory) {
    char moved[1000];
    *strrchr(directory, '/') = '\0';
    snprintf(moved, sizeof moved, "%s.above", directory);
    return rename(directory, moved) != 0 || symlink("/nowhere/at/all", directory) != 0;
}

static int move(const char *directory) {
    char moved[1000];
    snprintf(moved, sizeof moved, "%s.moved", directory);
    picture(directory, "depth", 0, 0);
    if (rename(directory, moved) != 0 || mkdir(directory, 0700) != 0) {
        return 1;
    }
    picture(directory, "depth", 0, 1);
    return 0;
}

int main(int argc, char **argv) {
    char *directory = argc >= 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    return argc == 3 ? move(directory) : move_above(directory);
}
