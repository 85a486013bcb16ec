#!/bin/sh
# Do `make` and `make check` redo what changed, and nothing else? In a small course of two lessons
# all files are made old; then one is changed, and what make writes anew is listed.
#
# Exit status 0: all of that is so; 1: something is not.

one=step01_line
two=step02_copy
top=$(cd "$(dirname "$0")/../.." && pwd) || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
unset MAKEFLAGS MFLAGS MAKELEVEL STEP BUILD CFLAGS MARCH WERROR # of the make that runs this test
failed=0

cp -R "$top/Makefile" "$top/common" "$top/$one" "$work" && cd "$work" || exit 1
mkdir -p tests/reference && cp -R "$top/tests/check" "$top/tests/help" tests || exit 1
cp -R $one $two && sed "s/$one/$two/" $one/scenes.h >$two/scenes.h
for lesson in $one $two; do
    cp -R "$top/tests/reference/$one" "tests/reference/$lesson"
done
sed -n "s/^$one /$one /p; s/^$one /$two /p" "$top/tests/check/scenes.txt" | sort >tests/check/scenes
mv tests/check/scenes tests/check/scenes.txt

# The sculptor only makes its files: these lessons draw none of them.
rm -rf common/sculptor && mkdir common/sculptor || exit 1
cat >common/sculptor/sculpt.c <<'EOF'
#include <stdio.h>
int main(int count, char **arguments) {
    static const char *const names[] = {"bust.obj", "bust_diffuse.tga", "bust_nm.tga",
                                        "bust_spec.tga", "knot.off", "sphere.obj", "torus.obj"};
    for (int i = 0; count == 2 && i < 7; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", arguments[1], names[i]);
        FILE *file = fopen(path, "w");
        fputs(names[i], file);
        fclose(file);
    }
}
EOF

words() {
    tr ' ' '\n' | grep . | LC_ALL=C sort | tr '\n' ' '
}

# redone EXPECTED TARGET...: is that what make writes anew? The compiler's probes, and what the check
# keeps of a run, do not count.
redone() {
    expected=$1
    shift
    make CFLAGS=-O1 MARCH= "$@" >log 2>&1 || { tail -n 20 log; failed=1; }
    found=$(find build -type f -newer old ! -name 'probe*' ! -name check.lock |
        sed 's:^build/::' | words)
    if [ "$found" != "$(echo "$expected" | words)" ]; then
        echo "redo: make $* after a change of '$changed' wrote '$found', not '$expected'"
        failed=1
    fi
}

# after FILE [TEXT]: this file is new, with more text at its end, and all the others are old.
after() {
    changed=$*
    find . -type f -exec touch -t 200001010000 {} +
    [ $# -eq 0 ] || echo "$2" >>"$1"
}

# Built without a warning, and with one.
program() {
    echo "$(warned "$1") built/$1"
}

warned() {
    echo "$1 $1.d $1.o $1.said"
}

drawn() {
    echo "drawn/$1"
    pictures "$1"
}

pictures() {
    echo "out/$1/.drawn"
    for picture in "tests/reference/$1"/*.png; do
        echo "out/$1/$(basename "$picture" .png).tga"
    done
}

nothing_said() {
    [ ! -s log ] || { echo "redo: make with nothing to do says: $(cat log)"; failed=1; }
}

# One after the other: the check removes programs.
make_all() {
    { make -s CFLAGS=-O1 MARCH= && make -s CFLAGS=-O1 MARCH= check; } >log 2>&1 || {
        tail -n 20 log
        false
    }
}

touch -t 200001010000 old
make_all || exit 1
used='const int used = 1;' # a program that this is a part of is another one
used_too='const int used_too = 1;'

after
redone ''
nothing_said
after $two/main.c "$used"
redone "sums/$two $(program $two) $(drawn $two)"
after $one/scenes.h "$used"
redone "sums/$one $(program $one) $(drawn $one)"

# A file that was unpacked or copied keeps its date: what it holds counts.
after $two/main.c "$used_too"
touch -t 199901010000 $two/main.c
redone "sums/$two $(program $two) $(drawn $two)"

# A comment makes a program of the same bytes, which need not draw again.
after $two/main.c '/* The end. */'
redone "sums/$two $(program $two)"
after common/raster.c '/* The end. */'
redone "common/raster.d common/raster.o libcommon.a sculpt $(program $one) $(program $two)"
after common/program.c 'const int used_by_all = 1;'
redone "common/program.d common/program.o libcommon.a sculpt \
    $(program $one) $(drawn $one) $(program $two) $(drawn $two)"

# The check judges the programs that make has built, and builds anew what is not one of these, in
# every byte: dates may lie. After it make has nothing to draw.
after
redone '' check
[ "$(tail -n 1 log)" = '2 passed, 0 failed' ] || { tail -n 20 log; failed=1; }
redone ''
nothing_said
changed='a program that is another one of the same size'
LC_ALL=C tr ab ba <build/$two >other && cat other >build/$two
touch -t 200001010000 build/$two
redone "$(program $two)" check
after
changed='a copy that is gone'
rm build/built/$one
redone "$(program $one)" check
after
changed='a list of headers that is gone'
rm build/$one.d
redone "$(program $one)" check
after tests/check/run.c '/* The end. */'
redone "check tests/check/run.d tests/check/run.o" check STEP=02

# A header or a main.c that keeps its date is found by what it holds.
after $two/main.c 'const int used_by_check = 1;'
touch -t 199901010000 $two/main.c
redone "sums/$two $(program $two)" check
after common/run/scene.h 'extern const int used_in_scenes;'
touch -t 199901010000 common/run/scene.h
redone "sums/$one sums/$two $(program $one) $(program $two)" check
mkdir $two/parts && echo 'const int used_in_part = 1;' >$two/parts/part.c
mkdir given && echo 'const int used_in_given = 1;' >given/given.c
printf '#include "parts/part.c"\n#include "../given/given.c"\n' >>$two/main.c
make_all || failed=1
after $two/parts/part.c 'const int used_in_part_too = 1;'
touch -t 199901010000 $two/parts/part.c
redone "sums/$two $(program $two)" check
after given/given.c 'const int used_in_given_too = 1;'
redone "$(program $two)" check
cp "$top/$one/main.c" $two
make_all || failed=1

# Every check shows the warnings, whoever has built the program; make after it has nothing to do.
unused_is_shown() {
    grep -q 'warning: .unused_here. defined but not used' log || { tail -n 20 log; failed=1; }
}
after $two/main.c 'static int unused_here;'
redone "sums/$two $(warned $two)"
unused_is_shown
after
redone "$(warned $two)" check
unused_is_shown
redone "$(warned $two)" check
unused_is_shown
after
redone ''
nothing_said
cp "$top/$one/main.c" $two
make_all || failed=1

# A model that is not as it was sculpted is no lesson's fault: it is made again, before the check.
models='bust.obj bust_diffuse.tga bust_nm.tga bust_spec.tga knot.off sphere.obj torus.obj'
sculpted="sums/models $(for model in $models; do echo "models/$model"; done)"
after
changed='a texture that somebody wrote over'
echo damaged >build/models/bust_diffuse.tga
redone "$sculpted $(pictures $one) $(pictures $two)"
after
changed='a directory in place of a model'
rm build/models/knot.off
mkdir build/models/knot.off
redone "$sculpted" check

# The line() that the second lesson draws with is that of the first one's main.c as it is now.
rm $two/mine.c
cp "$top/$one"/*.[ch] $one
make -s CFLAGS=-O1 MARCH= LINE=mine build/$two >log 2>&1 || { tail -n 20 log; exit 1; }
after $one/main.c 'const int used_by_mine = 1;'
touch -t 199901010000 $one/main.c
redone "sums/$one mine/$one.d mine/$one.o $(program $two)" LINE=mine build/$two

# What was built from a main.c that is gone does not count.
mv $one/main.c gone.c
if make CFLAGS=-O1 MARCH= check STEP=01 >log 2>&1 ||
    ! grep -q "^$one  BUILD 0/.*: there is no $one/main.c\$" log; then
    echo "redo: without $one/main.c the check says"
    cat log
    failed=1
fi
exit $failed
