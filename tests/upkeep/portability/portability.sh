#!/bin/bash
# Are the pictures the same bytes with every compiler, on every machine?
#
#   portability.sh [-b DIR] [NAME...]    all configurations, or only those named
#   portability.sh -l                    list the configurations
#
# Each row of the table below builds the sculptor and all lessons in DIR/NAME (DIR is
# build/portability), sculpts its own models, draws every scene with them, and some in other formats,
# and must get the bytes that this machine's compiler gets, which `make check` holds against
# tests/reference.
#
# One line a configuration: PASS; FAIL, with how many files differ; SKIP, with what is not installed.
# The last line counts. Exit status 0; 1 when a configuration failed, or was named and skipped; 2 for
# a wrong command line.
# shellcheck disable=SC2317 # each() calls the functions
cd "$(dirname "$0")/../../.." || exit 2
. tests/upkeep/each.sh

# name | compiler | flags | run by | Debian packages
# The slowest come first, so that none of them is left alone at the end. Those that CI draws are built
# with -O1, which takes half the time that -O3 does, and draw as fast; what -O3 makes of the code the
# others show. The x87, which computes in
# more bits than it stores, draws other bytes, in lessons 9 and 10 even when set to 53 bits, and has no
# row. WebAssembly has a stack of 64 KiB unless told otherwise, and overwrites data where it ends.
table() {
    cat <<'END'
s390x | s390x-linux-gnu-gcc | -O1 -fexcess-precision=fast | qemu-s390x -L /usr/s390x-linux-gnu | gcc-s390x-linux-gnu libc6-dev-s390x-cross qemu-user
ppc64 | powerpc64-linux-gnu-gcc | -O3 | qemu-ppc64 -L /usr/powerpc64-linux-gnu | gcc-powerpc64-linux-gnu libc6-dev-ppc64-cross qemu-user
arm64 | aarch64-linux-gnu-gcc | -O1 | qemu-aarch64 -L /usr/aarch64-linux-gnu | gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user
arm64-clang | clang | -O3 --target=aarch64-linux-gnu | qemu-aarch64 -L /usr/aarch64-linux-gnu | clang gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user
wasm | clang | -O1 --target=wasm32-wasi -Wno-unused-command-line-argument -Wl,--stack-first,-z,stack-size=1048576 | node --no-warnings tests/upkeep/portability/run_wasm.js | clang lld llvm wasi-libc libclang-rt-14-dev-wasm32 nodejs
arm32 | arm-linux-gnueabihf-gcc | -O3 -mfpu=neon-vfpv4 | qemu-arm -L /usr/arm-linux-gnueabihf | gcc-arm-linux-gnueabihf libc6-dev-armhf-cross qemu-user
riscv64 | riscv64-linux-gnu-gcc | -O3 | qemu-riscv64 -L /usr/riscv64-linux-gnu | gcc-riscv64-linux-gnu libc6-dev-riscv64-cross qemu-user
musl | musl-gcc | -O3 | | musl-tools
windows | x86_64-w64-mingw32-gcc | -O1 -static | wine | gcc-mingw-w64-x86-64 wine
i386-sse | i686-linux-gnu-gcc | -O3 -msse2 -mfpmath=sse -static | | gcc-i686-linux-gnu libc6-dev-i386-cross
i386-clang | clang | -O3 --target=i686-linux-gnu -msse2 -static | | clang gcc-i686-linux-gnu libc6-dev-i386-cross
END
    for compiler in gcc clang; do
        cat <<END
$compiler-O0 | $compiler | -O0 | | $compiler
$compiler-O2 | $compiler | -O2 | | $compiler
$compiler-O3 | $compiler | -O3 | | $compiler
$compiler-Os | $compiler | -Os | | $compiler
$compiler-native | $compiler | -O3 -march=native | | $compiler
$compiler-threads | $compiler | -O3 | | $compiler
$compiler-x86-64 | $compiler | -O3 -march=x86-64 | | $compiler
$compiler-x86-64-v2 | $compiler | -O3 -march=x86-64-v2 | | $compiler
$compiler-x86-64-v3 | $compiler | -O3 -march=x86-64-v3 | | $compiler
$compiler-x86-64-v4 | $compiler | -O3 -march=x86-64-v4 -mprefer-vector-width=512 | | $compiler
END
    done
}

# use NAME: that row's fields become variables. `reference` is what all others are compared with.
use() {
    IFS='|' read -r name compiler flags runner packages <<<"$({
        table
        echo "reference | ${CC:-cc} | -O2 | |"
    } | grep "^$1 |")"
    name=${name% }
    work=$build/$name
    # GNU ar makes no index of WebAssembly objects, without which wasm-ld does not link. And there are
    # no threads.
    case $name in
        wasm) archiver=llvm-ar threaded= ;;
        windows)
            archiver=x86_64-w64-mingw32-ar threaded=-pthread
            export WINEPREFIX="$work/wine" WINEDEBUG=fixme-all WINEDLLOVERRIDES='mscoree,mshtml='
            ;;
        *) archiver=ar threaded=-pthread ;;
    esac
    [ -n "$name" ]
}

# The build takes no setting from a `make` that runs this script.
make_with() {
    env -u MAKEFLAGS -u MAKEOVERRIDES -u MFLAGS make -s -k -j1 BUILD="$work" CC="$compiler" \
        AR="$archiver" CFLAGS="$flags" MARCH= THREADED="$threaded" OPENMP= WERROR=-Werror "$@"
}

# run PROGRAM ARGUMENT..., with absolute paths only.
run() {
    # shellcheck disable=SC2086 # the runner is several words, or none
    $runner "$work/$1" "${@:2}" </dev/null >/dev/null
}

# The models (an emulated processor, which would need minutes for the bust, sculpts a coarse one), every
# scene as TGA, one again over its file, and PNG written and read (as a texture, where names are not
# ASCII), animated PNG, PPM, a model in OFF, and a frame of --live without its first two lines.
draw() {
    rm -rf "$work"/{models,coarse,out} && mkdir -p "$work"/{models,coarse,out/formats/Köpfe}
    run sculptor "$work/coarse" 4 || return
    if [ -z "${runner// /}" ]; then
        run sculptor "$work/models" || return
    else
        cp "$build"/reference/models/* "$work/models"
    fi
    for step in step*_*; do
        mkdir "$work/out/$step"
        run "$step" -o "$work/out/$step" || return
    done
    formats=$work/out/formats
    run step10_phong --only four --format png -o "$formats" &&
        run step10_phong --only four --format png -o "$formats" &&
        run step10_phong --only turn --format png -s 40x40 -o "$formats" &&
        run step04_flat --only flat --format ppm -o "$formats" "$work/models/knot.off" &&
        cp "$work/models/bust.obj" "$formats/Köpfe/bust.obj" &&
        cp "$formats/four.png" "$formats/Köpfe/bust_diffuse.png" &&
        run step06_texture --only texture -o "$formats/Köpfe" "$formats/Köpfe/bust.obj" &&
        echo '-s 100x100' | $runner "$work/step04_flat" --live | tail -n +3 >"$formats/live"
}

# Which files are not the reference's?
compare() {
    for directory in models coarse out; do
        diff -rq "$build/reference/$directory" "$work/$directory"
    done
}

# judge NAME: its line. What compilers and programs say goes to the file log.
judge() {
    use "$1"
    mkdir -p "$work" || exit 1
    : >"$work/log"
    verdict=$(judge_row 2>"$work/log")
    printf '%-16s %s\n' "$name" "${verdict/LOG/see $work/log}"
}

judge_row() {
    for tool in ${compiler%% *} $archiver ${runner%% *}; do
        command -v "$tool" >/dev/null || { echo "SKIP  $tool is missing (Debian: $packages)"; return; }
    done
    # shellcheck disable=SC2086 # several words
    if ! $compiler $flags -x c - -o "$work/probe.new" <<<'int main(void) { return 0; }' || ! run probe.new; then
        echo "SKIP  an empty program is not built or does not run (Debian: $packages; LOG)"
        return
    fi
    # shellcheck disable=SC2046 # one word a program
    make_with $(printf "$work/%s " step*_*) "$work/sculptor" >&2 || { echo "FAIL  does not build (LOG)"; return; }
    case $name in *-threads) counts='1 2 3 4 5 6 7 8' ;; *) counts=${THREADS:-0} ;; esac
    for THREADS in $counts; do
        [ "$THREADS" = 0 ] && unset THREADS || export THREADS
        draw
        status=$?
        if [ $status -eq 132 ]; then # SIGILL
            echo "SKIP  this processor lacks instructions of $flags"
            return
        elif [ $status -ne 0 ]; then
            echo "FAIL  a program ended with status $status (LOG)"
            return
        fi
        different=$(compare | tee /dev/stderr | wc -l)
        [ "$different" -eq 0 ] || { echo "FAIL  $different files differ${THREADS:+ with $THREADS threads} (LOG)"; return; }
    done
    echo "PASS  $(find "$work/out" -type f | wc -l) pictures${THREADS:+, with each of 1 to $THREADS threads}"
}

# The reference itself: are its pixels those of tests/reference?
judge_reference() {
    judge reference
    if ! CHECK_EXACT=1 make_with check >"$work/check.log" 2>&1; then
        echo "reference        FAIL  not the pixels of tests/reference (see $work/check.log)"
        false
    fi
}

build=build/portability
while getopts b:l option; do
    case $option in
        b) build=$OPTARG ;;
        l) table; exit 0 ;;
        *) exit 2 ;;
    esac
done
shift $((OPTIND - 1))
build=$(mkdir -p "$build" && cd "$build" && pwd) || exit 2
named=$#
# shellcheck disable=SC2046 # names are single words
[ $# -gt 0 ] || set -- $(table | awk '{ print $1 }')
for wanted; do
    use "$wanted" || {
        echo "portability.sh: no configuration is called '$wanted'; portability.sh -l lists them" >&2
        exit 2
    }
done
export build
export -f table use make_with run draw compare judge judge_row
{ judge_reference && each judge "$@"; } | tee "$build/results"
awk -v named="$named" '
    { count[$2]++ }
    END {
        printf "%d passed, %d failed, %d skipped\n", count["PASS"], count["FAIL"], count["SKIP"]
        exit count["PASS"] == 0 || count["FAIL"] > 0 || (named > 0 && count["SKIP"] > 0)
    }' "$build/results"
