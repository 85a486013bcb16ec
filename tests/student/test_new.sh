#!/bin/sh
# Does `make new` begin a program that works? In a hand-out of lesson 10 it is built without a warning
# and draws the course's head, then two models. So is one that begins with an earlier lesson's main.c.
# Wrong names make nothing. A hand-out without the pipeline asks for a lesson.
. "$(dirname "$0")/../unit/script.sh"

# ---- Names, in the whole course ----

mkdir "$work/course" && cd "$work/course" && ln -s "$top"/* . && rm -f build && mkdir build || exit 1

# refused STATUS TEXT NAME: says it, in one line besides make's own, and leaves nothing behind.
refused() {
    ls -A >"$work/before"
    said_by "$1" make -s new NAME="$3"
    says "$2"
    [ "$(grep -cv '^make: ' "$said")" -eq 1 ] || wrong "NAME=$3 says more than one line"
    ls -A | diff "$work/before" - || wrong "NAME=$3 leaves something behind"
}
refused 2 'say a name' ''
for name in 'a b' a/b ../a a.b a-b "a'b" 'a"b' 'a;b' 'a*' ä; do
    refused 2 'letters A-Z and a-z' "$name"
done
for name in check new grade verify step05_zbuffer all; do
    [ -e "$name" ] || refused 2 'another' "$name"
done
refused 2 'make help does something else' help
refused 1 'common is here already' common
refused 2 "a lesson's name" step05_sphere
said_by 2 env NAME=environment make -s new
says 'say a name'
[ ! -e environment ] || wrong "a NAME of the environment counts"

mkdir "$work/bin" && printf '#!/bin/sh\nexit 1\n' >"$work/bin/mv" && chmod +x "$work/bin/mv" || exit 1
path=$PATH
PATH=$work/bin:$PATH
refused 1 'cannot write mine/main.c' mine
PATH=$path

said_by 0 make -s new NAME=My_2nd
refused 1 'My_2nd is here already' My_2nd
make -s -n My_2nd >/dev/null 2>&1 || wrong "make does not know My_2nd"

# ---- A hand-out of lesson 10: build, draw, look ----

cd "$top" && said_by 0 make -s handout OUT="$work/ten" LESSONS=10
cd "$work/ten" && mkdir -p build && cp -R "$build/models" build || exit 1

# hand_out ARGUMENTS...: make there, with the models that are there.
hand_out() {
    said_by "$1" make -s -o build/models/bust.obj CFLAGS=-O1 MARCH= WERROR=-Werror "$2" ${3:+"$3"}
}
hand_out 0 new NAME=mine
hand_out 0 mine
silent warning
says build/out/mine/turn.png

# Its size, how many frames it has, and how many of them change it; of both halves of the first, how many
# pixels in a hundred are not black, in how many reds; how many are not black in the two columns in the
# middle; and the largest red.
cat >look.c <<'END'
#include "base/file.h"
#include "files/image_file.h"
#include <stdio.h>
#include <string.h>
static unsigned number(const unsigned char *b) { return (unsigned)b[2] << 8 | b[3]; }
int main(int argc, char **argv) {
    struct bytes file = {0};
    struct image image;
    struct error error;
    static char seen[2][256];
    size_t frames = 0, changes = 0, drawn[2] = {0, 0}, reds[2] = {0, 0}, middle = 0, largest = 0;
    if (argc != 2 || !file_read(argv[1], &file, &error) || !image_read(&image, argv[1], &error)) {
        return 1;
    }
    for (size_t i = 0; i + 24 < file.size; i++) {
        const unsigned char *at = (const unsigned char *)file.data + i;
        if (memcmp(at, "fcTL", 4) == 0) {
            frames++;
            changes += number(at + 8) * number(at + 12) > 1000;
        }
    }
    for (size_t y = 0; y < image.height; y++) {
        for (size_t x = 0; x < image.width; x++) {
            struct color c = image_get(&image, (int)x, (int)y);
            size_t half = 2 * x >= image.width, is_drawn = c.r + c.g + c.b > 0;
            drawn[half] += is_drawn;
            middle += is_drawn && (x + 1 == image.width / 2 || x == image.width / 2);
            reds[half] += !seen[half][c.r];
            seen[half][c.r] = 1;
            largest = c.r > largest ? c.r : largest;
        }
    }
    size_t pixels = image.width * image.height / 2;
    printf("%zux%zu frames %zu changes %zu drawn %zu %zu reds %zu %zu middle %zu largest %zu\n",
           image.width, image.height, frames, changes, drawn[0] * 100 / pixels,
           drawn[1] * 100 / pixels, reds[0], reds[1], middle, largest);
}
END
cc -std=c17 -Icommon look.c build/libcommon.a -lm -pthread -o look || exit 1

# looks SIZE CONDITION: 36 frames, all different; in both halves something is drawn, and in shades. Of
# what is in the middle and of the largest red the condition says more.
looks() {
    ./look build/out/mine/turn.png >"$work/look" || wrong "turn.png cannot be read"
    awk -v size="$1" '{ middle = $13; largest = $15 }
        { exit !($1 == size && $3 == 36 && $5 == 36 && $7 >= 10 && $8 >= 10 && $7 <= 90 && $8 <= 90 &&
                 $10 >= 100 && $11 >= 100 && '"$2"') }' "$work/look" ||
        wrong "the picture: $(cat "$work/look")"
}
looks 400x400 'middle > 100'
cp build/out/mine/turn.png one.png
# (The knot has no normals. Where the sphere looks towards the light, it is brightest.)
hand_out 0 mine MODEL='build/models/knot.off build/models/sphere.obj'
looks 400x400 'middle == 0 && largest == 255'
hand_out 0 mine
cmp one.png build/out/mine/turn.png || wrong "the same command draws another picture"
hand_out 1 mine MODEL=nowhere.obj
says 'nowhere.obj: No such file'
cmp one.png build/out/mine/turn.png || wrong "a model that is not there changes the picture"
hand_out 2 mine MODEL='a b c d e'
says "one argument too many: 'e'"

# A change is built, and what the compiler says is shown.
echo 'int' >>mine/main.c
hand_out 1 mine
says 'mine/main.c'

# ---- After each of lessons 1 to 8 ----

for n in 1 2 3 4 5 6 7 8; do
    cd "$work/course" && said_by 0 make -s new NAME=own$n AFTER=$n && cd "$work/ten" || exit 1
    said_by 0 cc -std=c17 -Icommon -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-unused -Wno-psabi -Werror \
        -DCOURSE_LESSON=$n "$work/course/own$n/main.c" build/libcommon.a -lm -pthread -o "$work/own$n"
    # shellcheck disable=SC2046 # no word after lesson 1
    said_by 0 "$work/own$n" -o "$work" --format png $([ $n -eq 1 ] || echo build/models/bust.obj)
    ./look "$work/picture.png" >"$work/look" || wrong "its picture cannot be read"
    awk '{ exit !($1 == "400x400" && $7 > 2 && $8 > 2) }' "$work/look" || wrong "after lesson $n: $(cat "$work/look")"
done
cd "$work/course" && said_by 2 make -s new NAME=later AFTER=11
says 'AFTER=11 is none of the lessons'

# ---- A hand-out without the pipeline ----

cd "$top" && said_by 0 make -s handout OUT="$work/one" LESSONS=1
cd "$work/one" && said_by 2 make -s new NAME=mine
says 'make new NAME=mine AFTER=3'
[ ! -e mine ] || wrong "mine is made all the same"
exit $failed
