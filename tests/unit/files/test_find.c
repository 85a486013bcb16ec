/* Files that other files name: where they are, and which does as well. */
#define _XOPEN_SOURCE 700 /* POSIX.1-2008 with mkdtemp() */

#include "files/find.h"
#include "unit/place.h"

#include <sys/stat.h>

static void test_find_named(void) {
    static const struct {
        const char *name, *found; /* behind the directory */
        bool is_picture, is_there;
    } rows[] = {
        {"pic.png", "pic.png", true, true},
        {"Pic.PNG", "pic.png", true, true},
        {"\"pic.png\"", "pic.png", true, true},
        {"PIC.PNG # of wood", "pic.png", true, true},
        {"pic.png -clamp on", "pic.png", true, true},
        {"C:\\my maps\\Pic.png", "pic.png", true, true},
        {"none/PIC.png", "pic.png", true, true},
        {"none/a.mtl # by hand", "a.mtl", false, true},
        /* What is not read, and what it was converted to. */
        {"pic.jpg", "pic.png", true, true},
        {"both.jpg", "both.png", true, true},
        {"Both.TIF", "both.png", true, true},
        {"both.tga", "both.tga", true, true},
        {"both.png", "both.png", true, true},
        {"old.jpeg", "old.TGA", true, true},
        {"old.png", "old.TGA", true, true},
        {"photo.jpg", "photo.jpg", true, true},
        {"PHOTO.jpg", "photo.jpg", true, true},
        {"photo.bmp", "photo.bmp", true, false},
        {"pic.jpg", "pic.jpg", false, false},
        {"no_ending", "no_ending.png", true, true},
        /* Blanks as in URLs and in shells, unless a file has the name as it is written. */
        {"two%20words.mtl", "two words.mtl", false, true},
        {"two\\ words.mtl", "two words.mtl", false, true},
        {"TWO%20Words.mtl # by hand", "two words.mtl", false, true},
        {"a%20b.png", "a%20b.png", true, true},
        {"A%20B.jpg", "a%20b.png", true, true},
        {"file:///home/me/%4daps/p%69c.PNG", "pic.png", true, true},
        {"/home/me/two\\ words.mtl", "two words.mtl", false, true},
        {"maps/pic.%70ng", "pic.png", true, true},
        {"none%20.png", "none%20.png", true, false},
        {"both%2ejpg", "both.jpg", true, true},
        {"pic%2.png", "pic%2.png", true, false},
        {"%", "%", true, false},
        {"pic.png%", "pic.png%", false, false},
        {"two\\", "two/", false, false},
        /* Directories. */
        {"maps/Sand.png", "Maps/sand.png", true, true},
        {"MAPS\\SAND.JPG", "Maps/sand.png", true, true},
        {"Maps//sand.png", "Maps//sand.png", true, true},
        {"./maps/../Pic.png", "./Maps/../pic.png", true, true},
        {"mapz/sand.png", "mapz/sand.png", true, false},
        /* Two files fit, or one that is written just so. */
        {"Twin.png", "Twin.png", true, false},
        {"twin.png", "twin.png", true, true},
        {"twin.jpg", "twin.png", true, true},
        {"a.MTL", "a.mtl", false, true},
        {"two words.mtl # made by hand", "two words.mtl", false, true},
        {"two", "two", false, false},
        {"none.png # x", "none.png", true, false},
    };
    static const char *const files[] = {"pic.png",       "both.jpg",  "both.png",      "both.tga",
                                        "old.TGA",       "photo.jpg", "twin.png",      "TWIN.png",
                                        "no_ending.png", "a.mtl",     "two words.mtl", "a b.png",
                                        "a%20b.png"};
    struct place place = place_create();
    char directory[60], long_name[9000];
    CHECK(mkdir(name_file(&place, "Maps"), 0777) == 0 &&
          put_text(name_file(&place, "Maps/sand.png"), ""));
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        CHECK(put_text(name_file(&place, files[i]), ""));
    }
    snprintf(directory, sizeof directory, "%s/", place.directory);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct word name = {rows[i].name, strlen(rows[i].name)};
        bool found;
        char *path = find_named(name, directory, rows[i].is_picture, &found);
        CHECK_ROW(found == rows[i].is_there, rows[i].name);
        if (CHECK_ROW(path != NULL, rows[i].name)) {
            CHECK_TEXT(path, name_file(&place, rows[i].found));
        }
        free(path);
    }
    /* Hostile ones. */
    bool found = true;
    CHECK(find_named((struct word){"", 0}, directory, true, &found) == NULL && !found);
    for (size_t i = 0; i < sizeof long_name; i++) {
        long_name[i] = i % 2 == 0 ? 'x' : '/';
    }
    char *path = find_named((struct word){long_name, sizeof long_name}, directory, true, &found);
    CHECK(path != NULL && !found && strlen(path) > sizeof long_name);
    free(path);
    CHECK(unlink(name_file(&place, "Maps/sand.png")) == 0 && rmdir(name_file(&place, "Maps")) == 0);
    place_remove(&place, "pic.png,both.jpg,both.png,both.tga,old.TGA,photo.jpg,twin.png,TWIN.png,"
                         "no_ending.png,a.mtl,two words.mtl,a b.png,a%20b.png");
}

UNIT_MAIN(TEST(test_find_named))
