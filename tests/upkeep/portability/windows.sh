#!/bin/sh
# Does make check work as Windows itself runs it? With mingw-w64, and wine: it needs no WSL.
#
#     windows.sh BUILD
#
# BUILD is the absolute path of a directory, for what is built. The solutions of three lessons pass
# exactly; wrong programs get their verdicts. make and its shell are those of Linux. Exit status: 0
# or 1; 77 without mingw-w64 or wine.
cd "$(dirname "$0")/../../.." || exit 1
top=$PWD
build=$1
compiler=x86_64-w64-mingw32-gcc
command -v $compiler && command -v wine || { echo "no $compiler, or no wine"; exit 77; }
make -s models && rm -rf "$build/course" && mkdir -p "$build/course/build" "$build/bin" &&
    cp -r Makefile common tests step* "$build/course" && cp -r build/models "$build/course/build" &&
    cd "$build/course" || exit 1
export WINEPREFIX="$build/wine" WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml,winedbg.exe='
export WINEPATH="Z:$build/bin" SAID="$build/said" CHECK_EXACT=1
make="make -s CC=$compiler AR=x86_64-w64-mingw32-ar CFLAGS='-O0 -static' MARCH= WERROR=-Werror BUILT=Z:$PWD/build"
$compiler -O1 -static tests/upkeep/portability/wine_sh.c -o "$build/bin/sh.exe" &&
    eval "$make" build/check || exit 1
failed=0

# judged STATUS STEP TEXT...: the check ends so, and says each text.
judged() {
    wanted=$1
    lesson=$2
    shift 2
    wine build/check --make "$make" "$lesson" >"$build/says" 2>&1
    status=$?
    for text; do
        [ $status = "$wanted" ] && grep -qF "$text" "$build/says" && continue
        echo "status $status; nothing says: $text"
        cat "$build/says"
        failed=1
    done
}

# with TEXT: lesson 1's program does this, too, before its first pixel.
with() {
    sed "s|image_set(image, 52, 41, .*|$1 &|" "$top/step01_line/main.c" >step01_line/main.c
}

for lesson in 1 3 5; do
    judged 0 $lesson 'PASS' 'exact'
done
with 'image_set(image, 41, 52, color_rgb(255, 0, 0)); return;'
judged 1 1 'pixel FAIL' 'x and y exchanged'
with 'for (;;) {}'
judged 1 1 'pixel TIME' 'does not return' 'SCORE 20/22'
with '*(volatile int *)(intptr_t)image->width = 1;'
judged 1 1 'pixel CRASH' 'SIGSEGV'
with 'abort();'
judged 1 1 'pixel CRASH' 'SIGABRT'
with 'volatile int zero = 0; zero = 7 / zero;'
judged 1 1 'pixel CRASH' 'SIGFPE'
with 'oops();'
judged 1 1 'BUILD' "implicit declaration of function 'oops'"
for lesson in 1 3 5; do
    make -s start STEP=$lesson >"$build/says" || failed=1
    judged 1 $lesson 'TODO 0/' 'is to do'
done
exit $failed
