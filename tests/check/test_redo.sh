#!/bin/sh
# Do `make` and `make check` redo what changed, and nothing else? In a small course of two lessons
# all files are made old; then one is changed, and what make writes again is listed.

one=step01_line
two=step02_copy
. "$(dirname "$0")/../unit/script.sh"

cp -R "$top/Makefile" "$top/common" "$top/$one" "$work" && cd "$work" || exit 1
mkdir -p tests/reference && cp -R "$top/tests/check" "$top/tests/student" tests || exit 1
cp -R $one $two && sed "s/$one/$two/g" $one/scenes.h >$two/scenes.h &&
    sed "s/$one/$two/g" $one/main.c >$two/main.c
for scene in $(sed -n 's/.*\.name = "\([a-z]*\)", .*/\1/p' $one/scenes.h); do # not those of trials.c
    for lesson in $one $two; do
        mkdir -p "tests/reference/$lesson" &&
            cp "$top/tests/reference/$one/$scene.png" "tests/reference/$lesson" || exit 1
        sed -n "s/^$one  *$scene /$lesson $scene /p" "$top/tests/check/scenes.txt"
    done
done | sort >tests/check/scenes
mv tests/check/scenes tests/check/scenes.txt

# The sculptor only makes its file: these lessons draw none of it.
rm -rf common/sculptor && mkdir common/sculptor || exit 1
cat >common/sculptor/sculpt.c <<'END'
#include <stdio.h>
int main(int count, char **arguments) {
    char path[4096];
    snprintf(path, sizeof path, "%s/bust.obj", count == 2 ? arguments[1] : ".");
    fclose(fopen(path, "w"));
}
END

words() {
    tr ' ' '\n' | grep . | LC_ALL=C sort | tr '\n' ' '
}

# redone EXPECTED TARGET...: is that what make writes again? (What the check keeps of a run does not
# count.)
redone() {
    expected=$1
    shift
    make -s CFLAGS=-O0 MARCH= "$@" >log 2>&1 || wrong "make $*: $(tail -n 20 log)"
    found=$(find build -type f -newer old ! -name check.lock | sed 's:^build/::' | words)
    [ "$found" = "$(echo "$expected" | words)" ] ||
        wrong "make $* after a change of '$changed' wrote '$found', not '$expected'"
}

# after FILE [TEXT]: this file is new, with more text at its end, and all the others are old.
after() {
    changed=$*
    find . -type f -exec touch -t 200001010000 {} +
    [ $# -eq 0 ] || echo "$2" >>"$1"
}

program() {
    echo "$1 $1.begun $1.d $1.o $1.said"
}

drawn() {
    echo "out/$1/.drawn"
    for picture in "tests/reference/$1"/*.png; do
        echo "out/$1/$(basename "$picture" .png).tga"
    done
}

touch -t 200001010000 old
make -s CFLAGS=-O0 MARCH= >log 2>&1 && make -s CFLAGS=-O0 MARCH= check >log 2>&1 ||
    { tail -n 20 log; exit 1; }

after
redone ''
[ ! -s log ] || wrong "make with nothing to do says: $(cat log)"
redone '' check
[ "$(tail -n 1 log)" = '2 passed, 0 failed' ] || wrong "$(tail -n 20 log)"

# What a file holds counts, not its date: one that was unpacked or copied keeps an old one.
after $two/main.c 'extern const int used;'
touch -t 199901010000 $two/main.c
redone "$two.text $(program $two) $(drawn $two)"
after $one/scenes.h 'extern const int used;'
touch -t 199901010000 $one/scenes.h
redone "$one.text $(program quick/$one)" check
mkdir $two/parts && echo 'extern const int used_in_part;' >$two/parts/part.h
echo '#include "parts/part.h"' >>$two/main.c
make -s CFLAGS=-O0 MARCH= >log 2>&1 || wrong "$(cat log)"
after $two/parts/part.h 'extern const int used_in_part_too;'
touch -t 199901010000 $two/parts/part.h
redone "$two.text $(program $two) $(drawn $two)"
after common/raster.c '/* The end. */'
redone "common/raster.d common/raster.o libcommon.a \
    quick/common/raster.d quick/common/raster.o quick/libcommon.a sculptor models/bust.obj \
    $(program $one) $(drawn $one) $(program $two) $(drawn $two)"
after tests/check/run.c '/* The end. */'
redone "check quick/tests/check/all.d quick/tests/check/all.o" check STEP=02

# What is saved while make compiles is compiled next, even if another make has seen it meanwhile.
cp $two/main.c kept
compiler=$(make -s MARCH= -f Makefile --eval 'said: ; @echo $(CC)' said)
mkdir wrapped && cat >"wrapped/$compiler" <<END && chmod +x "wrapped/$compiler"
#!/bin/sh
"$(command -v "$compiler")" "\$@" || exit 1
case " \$* " in *" -c "*) : >compiled ;; *) exit 0 ;; esac
[ ! -f saved ] || { mv saved $two/main.c && cat $two/*.[ch] $two/*/*.[ch] >build/$two.text; }
END
echo 'extern const int saved_before;' >>$two/main.c
cp kept saved
wrapped() {
    PATH=$PWD/wrapped:$PATH make -s CFLAGS=-O0 MARCH= build/$two >log 2>&1 || wrong "$(cat log)"
}
wrapped
[ ! -f saved ] || wrong "nothing was saved while make compiled"
rm compiled
wrapped
[ -f compiled ] || wrong "what was saved while make compiled is not compiled"

# Every check shows the warnings, whoever has built the program.
unused_is_shown() {
    grep -q 'warning: .unused_here. defined but not used' log || wrong "no warning: $(cat log)"
}
after $two/main.c 'static int unused_here;'
redone "$two.text $(program $two) $(drawn $two)"
unused_is_shown
after $two/main.c 'extern const int used_again;'
redone "$two.text $(program quick/$two)" check
unused_is_shown
after
redone "$(program quick/$two)" check
unused_is_shown

# What was built from a main.c that is gone does not count.
mv $one/main.c gone.c
if make -s CFLAGS=-O0 MARCH= check STEP=01 >log 2>&1 ||
    ! grep -q "^$one  BUILD 0/.*: there is no $one/main.c\$" log; then
    wrong "without $one/main.c the check says $(cat log)"
fi
exit $failed
