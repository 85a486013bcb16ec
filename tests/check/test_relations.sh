#!/bin/sh
# Does the check find a program that draws its own scenes right, and what is new to it wrong? Copies
# of lesson 5 that go wrong only in an image of another size than the scenes': each breaks one
# relation of tests/check/relation.h.
. "$(dirname "$0")/../unit/script.sh"

lesson=step05_zbuffer
mkdir -p "$work/tests/reference" && cd "$work" || exit 1
cp -R "$top/Makefile" "$top/common" "$top/$lesson" . || exit 1
cp -R "$top/tests/check" "$top/tests/student" "$top/tests/upkeep/verify/replace.awk" tests &&
    cp "$top"/tests/*.h tests && mkdir tests/lessons && cp -R "$top/tests/lessons/$lesson" tests/lessons || exit 1
cp -R "$top/tests/reference/$lesson" tests/reference || exit 1
cp $lesson/main.c main.c
{
    grep "^$lesson *zbuffer " tests/check/scenes.txt
    echo "same $lesson zbuffer 5.2 1 shuffled,turned,moved 0.1"
    echo "same $lesson zbuffer 5.2 1 halved 2"
} >scenes.txt

# judge STATUS PATTERN SED_EXPRESSION: the check of main.c changed so ends so, and says that.
judge() {
    sed "$3" main.c >$lesson/main.c
    ! cmp -s main.c $lesson/main.c || [ "$3" = "" ] || wrong "changes nothing: $3"
    said_by "$1" "$build/check" --scenes scenes.txt --programs "$work/build/quick" --only zbuffer \
        --make "make -s BUILD='$work/build' MARCH= CFLAGS=-O1" 05
    grep -q "$2" "$said" || wrong "nothing says \"$2\" of $3"
}

# What the models are built from stays as it is: they are taken from the build directory.
mkdir build && cp -R "$build/models" build
judge 0 'PASS 3/3' ''
new='image->width != 800'
judge 1 'again (shuffled, turned, moved) FAIL 0/1: in another order: [0-9]* of [0-9]* pixels of a new scene differ' \
    "s/if (depth > row\\[x\\])/if ($new || depth > row[x])/"
judge 1 'again (shuffled, turned, moved) FAIL 0/1: the corners of each triangle turned: ' \
    "s/if (depth > row\\[x\\])/if (depth > row[x] \\&\\& !($new \\&\\& v[0].depth > v[1].depth))/"
judge 1 'again (shuffled, turned, moved) FAIL 0/1: moved by (3,2): ' \
    "s/if (depth > row\\[x\\])/if (depth > row[x] \\&\\& !($new \\&\\& x % 5 == 0))/"
judge 1 'again (halved) FAIL 0/1: drawn twice as large and halved: ' \
    "s/if (depth > row\\[x\\])/if (depth > row[x] \\&\\& !(image->width == 512 \\&\\& y > 300))/"
judge 1 'again (shuffled, turned, moved) FAIL 0/1: a new scene is not drawn' \
    "s/^    for (int y = edges.y_begin;/    image = $new ? NULL : image;\\n&/"
judge 1 'again (shuffled, turned, moved) FAIL 0/1: of a new scene nothing is drawn' \
    "s/if (depth > row\\[x\\])/if (depth > row[x] \\&\\& !($new))/"

# A mistake that is known: the hint that is named is one for the task of this scene.
judge 1 'make hint STEP=05 TASK=5\.2$' "s/if (depth > row\\[x\\])/if (true)/"

exit $failed
