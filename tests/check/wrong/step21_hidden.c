/* The picture is right; a directory that nobody may read is left behind. */
#include "picture.h"

#include <sys/stat.h>
#include <unistd.h>

int main(int argc, char **argv) {
    const char *directory = argc == 3 && strcmp(argv[1], "-o") == 0 ? argv[2] : NULL;
    if (directory == NULL) {
        return 2;
    }
    picture(directory, "depth", 0, 1);
    return mkdir("a", 0777) + mkdir("a/b", 0777) + symlink("/", "a/b/root") + chmod("a/b", 0) +
           chmod("a", 0);
}
