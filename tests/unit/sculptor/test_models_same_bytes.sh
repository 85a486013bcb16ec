#!/bin/sh
# Do all compilers sculpt the same bytes? Builds the sculptor with each compiler at -O0 and -O3 and
# compares every file that it writes, also over two runs of one program. The Makefile must build it
# so whatever CFLAGS say (a student's -Ofast reaches neither the models nor the library), and again
# when one of its files is missing.
#
#   models_same_bytes.sh            gcc and clang, those that are installed
#   CC="cc" models_same_bytes.sh    these commands only, separated by blanks
#
# Exit status 0: the same bytes; 1: a difference, or nothing could be built.

top=$(cd "$(dirname "$0")/../../.." && pwd) || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
unset MAKEFLAGS MFLAGS # of the make that runs this test

compilers=${CC:-}
if [ -z "$compilers" ]; then
    for compiler in gcc clang; do
        if command -v "$compiler" >/dev/null 2>&1; then
            compilers="$compilers $compiler"
        else
            echo "models_same_bytes: $compiler is not installed, skipped"
        fi
    done
fi

# sculpt_with NAME COMMAND...: build with that command and sculpt into $work/NAME.
sculpt_with() {
    name=$1
    shift
    mkdir "$work/$name" || return 1
    "$@" -std=c17 -ffp-contract=off -I"$top/common" "$top"/common/sculptor/*.c \
        "$top/common/base/array.c" "$top/common/base/file.c" "$top/common/geometry.c" \
        "$top/common/base/large_pages.c" "$top/common/tgaimage.c" \
        -lm -o "$work/sculpt" && "$work/sculpt" "$work/$name"
}

# make_with COMPILER TARGET...: as a student may, who wants speed. (clang has no such constants.)
make_with() {
    compiler=$1
    shift
    flags=-Ofast
    ! echo 'int a;' | "$compiler" -Werror -fsingle-precision-constant -x c -c -o /dev/null - \
        2>/dev/null || flags="$flags -fsingle-precision-constant -w"
    make -s -C "$top" CC="$compiler" CFLAGS="$flags" BUILD="$work/build" "$@"
}

# compare NAME: are its files those of the first build, no more and no less?
compare() {
    if [ "$(ls "$work/$first")" != "$(ls "$work/$1")" ]; then
        echo "models_same_bytes: $1 wrote other files than $first"
        failed=1
        return
    fi
    for file in "$work/$first"/*; do
        if ! cmp -s "$file" "$work/$1/$(basename "$file")"; then
            echo "models_same_bytes: $(basename "$file") differs between $first and $1"
            failed=1
        fi
    done
}

failed=0
first=
for compiler in $compilers; do
    for level in -O0 -O3; do
        name=$(basename "$compiler")$level
        if ! sculpt_with "$name" "$compiler" "$level"; then
            echo "models_same_bytes: cannot sculpt with $compiler $level"
            failed=1
        elif [ -z "$first" ]; then
            first=$name
            mkdir "$work/again" && "$work/sculpt" "$work/again" && compare again
        else
            compare "$name"
        fi
    done
    name=$(basename "$compiler")-Ofast
    if ! make_with "$compiler" models "$work/build/step01_line" ||
        ! rm "$work/build/models/bust_nm.tga" || ! make_with "$compiler" models; then
        echo "models_same_bytes: cannot sculpt with $compiler -Ofast"
        failed=1
    else
        mv "$work/build/models" "$work/$name" && compare "$name"
    fi
    # The processor rounds numbers next to 0 to 0 where this function is called before main().
    if nm "$work/build/step01_line" | grep set_fast_math; then
        echo "models_same_bytes: $compiler -Ofast changes the arithmetic of a whole lesson"
        failed=1
    fi
    rm -rf "$work/build"
done

if [ -z "$first" ]; then
    echo "models_same_bytes: nothing was sculpted"
    exit 1
fi
[ "$failed" -eq 0 ] && echo "models_same_bytes: the same bytes from$(printf ' %s' $compilers) at -O0, -O3, -Ofast"
exit "$failed"
