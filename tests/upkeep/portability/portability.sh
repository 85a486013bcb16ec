#!/bin/sh
# Are the pictures the same bytes with every compiler, on every machine?
#
#   portability.sh [-b DIR] [NAME...]    all configurations, or only those named
#   portability.sh -l                    list the configurations
#
# Each configuration of the table below builds the sculptor and all steps in DIR/NAME (DIR is
# build/portability), sculpts its own models, draws every scene of tests/check/scenes.txt with them,
# and must get the bytes of the configuration `reference`, which `make check` holds against
# tests/reference. Some files in other formats (PNG, animated PNG, PPM, OFF) are compared as well.
#
# One line a configuration: PASS; FAIL, with the files that differ; SKIP, with what is not installed;
# or NOTE: a difference that is expected, shown and not counted. The last line counts. Exit status 0;
# 1 when a configuration failed, or was named and skipped; 2 for a wrong command line.

top=$(cd "$(dirname "$0")/../../.." && pwd) || exit 2

# name | verdict | compiler | flags | run by | Debian packages
#   verdict: exact    every byte as in the reference
#            threads  the same, drawn with 1, 2, ... 8 threads
#            note     the number of differing files is printed and not counted
# The slowest stand first, so that none of them is left alone at the end. The x87 computes in 64 bits
# and rounds when it stores; set to 53 bits (-mpc64), it gives the same bytes as every other machine.
# WebAssembly has a stack of 64 KiB unless told otherwise, and overwrites data where it ends.
table() {
    cat <<'END'
s390x          | exact   | s390x-linux-gnu-gcc        | -O2 -fexcess-precision=fast | qemu-s390x -L /usr/s390x-linux-gnu | gcc-s390x-linux-gnu libc6-dev-s390x-cross qemu-user
ppc64          | exact   | powerpc64-linux-gnu-gcc    | -O3 | qemu-ppc64 -L /usr/powerpc64-linux-gnu | gcc-powerpc64-linux-gnu libc6-dev-ppc64-cross qemu-user
arm64          | exact   | aarch64-linux-gnu-gcc      | -O3 | qemu-aarch64 -L /usr/aarch64-linux-gnu | gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user
arm64-clang    | exact   | clang                      | -O3 --target=aarch64-linux-gnu | qemu-aarch64 -L /usr/aarch64-linux-gnu | clang gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user
wasm           | exact   | clang | -O3 --target=wasm32-wasi -Wno-unused-command-line-argument -Wl,--stack-first,-z,stack-size=1048576 | node --no-warnings tests/upkeep/portability/run_wasm.js | clang lld llvm wasi-libc libclang-rt-14-dev-wasm32 nodejs
arm32          | exact   | arm-linux-gnueabihf-gcc    | -O3 -mfpu=neon-vfpv4 | qemu-arm -L /usr/arm-linux-gnueabihf | gcc-arm-linux-gnueabihf libc6-dev-armhf-cross qemu-user
riscv64        | exact   | riscv64-linux-gnu-gcc      | -O3 | qemu-riscv64 -L /usr/riscv64-linux-gnu | gcc-riscv64-linux-gnu libc6-dev-riscv64-cross qemu-user
gcc-O0         | exact   | gcc   | -O0                 | | gcc
gcc-O2         | exact   | gcc   | -O2                 | | gcc
gcc-O3         | exact   | gcc   | -O3                 | | gcc
gcc-Os         | exact   | gcc   | -Os                 | | gcc
gcc-native     | exact   | gcc   | -O3 -march=native   | | gcc
gcc-threads    | threads | gcc   | -O3                 | | gcc
gcc-x86-64     | exact   | gcc   | -O3 -march=x86-64   | | gcc
gcc-x86-64-v2  | exact   | gcc   | -O3 -march=x86-64-v2 | | gcc
gcc-x86-64-v3  | exact   | gcc   | -O3 -march=x86-64-v3 | | gcc
gcc-x86-64-v4  | exact   | gcc   | -O3 -march=x86-64-v4 -mprefer-vector-width=512 | | gcc
clang-O0       | exact   | clang | -O0                 | | clang
clang-O2       | exact   | clang | -O2                 | | clang
clang-O3       | exact   | clang | -O3                 | | clang
clang-Os       | exact   | clang | -Os                 | | clang
clang-native   | exact   | clang | -O3 -march=native   | | clang
clang-threads  | threads | clang | -O3                 | | clang
clang-x86-64   | exact   | clang | -O3 -march=x86-64   | | clang
clang-x86-64-v2 | exact  | clang | -O3 -march=x86-64-v2 | | clang
clang-x86-64-v3 | exact  | clang | -O3 -march=x86-64-v3 | | clang
clang-x86-64-v4 | exact  | clang | -O3 -march=x86-64-v4 -mprefer-vector-width=512 | | clang
musl           | exact   | musl-gcc | -O3              | | musl-tools
i386-sse       | exact   | i686-linux-gnu-gcc | -O3 -msse2 -mfpmath=sse -static | | gcc-i686-linux-gnu libc6-dev-i386-cross
i386-clang     | exact   | clang | -O3 --target=i686-linux-gnu -msse2 -static | | clang gcc-i686-linux-gnu libc6-dev-i386-cross
x87            | note    | i686-linux-gnu-gcc | -O3 -mfpmath=387 -static -fexcess-precision=standard | | gcc-i686-linux-gnu libc6-dev-i386-cross
x87-fast       | note    | i686-linux-gnu-gcc | -O3 -mfpmath=387 -static -fexcess-precision=fast | | gcc-i686-linux-gnu libc6-dev-i386-cross
x87-store      | note    | i686-linux-gnu-gcc | -O3 -mfpmath=387 -static -ffloat-store | | gcc-i686-linux-gnu libc6-dev-i386-cross
x87-clang      | note    | clang | -O3 --target=i686-linux-gnu -mno-sse -static | | clang gcc-i686-linux-gnu libc6-dev-i386-cross
x87-53bits     | note    | i686-linux-gnu-gcc | -O3 -mfpmath=387 -static -fexcess-precision=fast -ffloat-store -mpc64 | | gcc-i686-linux-gnu libc6-dev-i386-cross
END
}

# "step05_zbuffer zbuffer", one scene a line
scenes() {
    awk '/^step/ { print $1, $2 }' "$top/tests/check/scenes.txt"
}

steps() {
    scenes | awk '{ print $1 }' | uniq
}

# ---- One configuration; it works in $work, and its messages go to $work/log ----

# GNU ar makes no index of WebAssembly objects, and without one wasm-ld does not link.
archiver() {
    case $flags in
        *--target=wasm*) echo llvm-ar ;;
        *) echo ar ;;
    esac
}

# WebAssembly has no threads; elsewhere they are drawn with, as usual.
threaded() {
    case $flags in
        *--target=wasm*) ;;
        *) echo -pthread ;;
    esac
}

# Build everything but the pictures. The build takes no setting from a `make` that runs this script.
build() {
    (unset MAKEFLAGS MAKEOVERRIDES MFLAGS
     # shellcheck disable=SC2046 # one word a program
     make -C "$top" -s -k -j1 BUILD="$work" CC="$compiler" AR="$(archiver)" CFLAGS="$flags" MARCH= \
         THREADED="$(threaded)" OPENMP= WERROR=-Werror $(steps | sed "s|^|$work/|") "$work/sculpt") >"$work/log" 2>&1
}

# Can a program of this compiler run here? Vectors that the processor lacks are found here, too.
build_probe() {
    cat >"$work/probe.c" <<'END'
int main(void) {
#if defined __AVX512F__
    return !(__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"));
#elif defined __AVX2__
    return !(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"));
#elif defined __SSE4_2__
    return !__builtin_cpu_supports("sse4.2");
#else
    return 0;
#endif
}
END
    # shellcheck disable=SC2086 # flags are several words
    $compiler $flags "$work/probe.c" -o "$work/probe" >"$work/log" 2>&1
}

# run PROGRAM ARGUMENT..., with absolute paths only: the runner's own path begins at $top.
run() {
    program=$1
    shift
    # shellcheck disable=SC2086 # the runner is several words, or none
    (cd "$top" && $runner "$work/$program" "$@") </dev/null >/dev/null 2>>"$work/log"
}

sculpt() {
    rm -rf "$work/models" "$work/out" && mkdir -p "$work/models" && run sculpt "$work/models"
}

# Every scene as TGA, into $work/out/STEP.
draw() {
    rm -rf "$work/out"
    for step in $(steps); do
        mkdir -p "$work/out/$step"
        run "$step" -o "$work/out/$step" || echo "$step failed" >>"$work/log"
    done
}

# PNG written and read (as a texture), animated PNG, PPM, and a model in OFF.
draw_formats() {
    formats=$work/out/formats
    mkdir -p "$formats/textured"
    run step10_phong --only four --format png -o "$formats"
    run step10_phong --only turn --format png -s 40x40 -o "$formats"
    run step04_flat --only flat --format ppm -o "$formats" "$work/models/knot.off"
    cp "$work/models/bust.obj" "$formats/textured/bust.obj"
    cp "$formats/four.png" "$formats/textured/bust_diffuse.png"
    run step06_texture --only texture -o "$formats/textured" "$formats/textured/bust.obj"
}

# All files that are compared, by their paths in $work.
files() {
    for model in bust.obj bust_diffuse.tga bust_nm.tga bust_spec.tga sphere.obj torus.obj knot.off; do
        echo "models/$model"
    done
    scenes | sed 's|\(.*\) \(.*\)|out/\1/\2.tga|'
    for format in four.png turn.png flat.ppm textured/texture.tga; do
        echo "out/formats/$format"
    done
}

# The files that are missing or not equal to the reference's; a space before each.
differing() {
    files | while read -r file; do
        cmp -s "$build/reference/$file" "$work/$file" || printf ' %s' "$file"
    done
}

# say VERDICT TEXT: the line of this configuration
say() {
    printf '%-16s %s  %s\n' "$name" "$1" "$2"
}

# How many scenes differ when only they, not the models, are made by this configuration?
count_with_reference_models() {
    rm -rf "$work/models"
    cp -r "$build/reference/models" "$work/models"
    draw
    differing | tr ' ' '\n' | grep -c '^out/step'
}

# judge DIFFERENT_FILES: the verdict on them
judge() {
    different=$1
    scene_count=$(scenes | wc -l)
    wrong_scenes=$(echo "$different" | tr ' ' '\n' | grep -c '^out/step')
    # shellcheck disable=SC2086 # a list of paths
    set -- $different
    few=${1:-}${2:+, $2}${3:+, $3}${4:+, ...}
    if [ $# -eq 0 ]; then
        say PASS "$((scene_count)) scenes$threads_text"
    elif [ "$verdict" = note ]; then
        echo "different: $*" >>"$work/log"
        say NOTE "$wrong_scenes of $((scene_count)) scenes differ, $(count_with_reference_models) with the reference's models; not counted ($flags)"
    else
        say FAIL "$# of $(($(files | wc -l))) files differ: $few (see $work/log)"
    fi
}

# Draw and compare, once or with each number of threads.
check_pictures() {
    threads_text=
    if [ "$verdict" != threads ]; then
        draw
        draw_formats
        judge "$(differing)"
        return
    fi
    for threads in 1 2 3 4 5 6 7 8; do
        export THREADS="$threads"
        draw
        draw_formats
        different=$(differing)
        threads_text=", with each of 1 to $threads threads"
        [ -z "$different" ] || break
    done
    judge "$different"
}

check_configuration() {
    work=$build/$name
    mkdir -p "$work" || exit 1
    for tool in "${compiler%% *}" "$(archiver)" "${runner%% *}"; do
        if [ -n "$tool" ] && ! command -v "$tool" >/dev/null 2>&1; then
            say SKIP "$tool is not installed (Debian: $packages)"
            return
        fi
    done
    if ! build_probe; then
        say SKIP "$compiler $flags cannot build an empty program (Debian: $packages)"
    elif ! run probe; then
        say SKIP "what $compiler $flags builds does not run here (see $work/log)"
    elif ! build; then
        say FAIL "does not build (see $work/log)"
    elif ! sculpt; then
        say FAIL "the sculptor failed (see $work/log)"
    else
        check_pictures
    fi
}

# The configuration that all others are compared with; itself compared with tests/reference.
check_reference() {
    name=reference compiler=${CC:-cc} flags=-O2 runner=
    work=$build/reference
    mkdir -p "$work" || exit 1
    if ! build || ! sculpt; then
        say FAIL "does not build (see $work/log)"
        return 1
    fi
    draw
    draw_formats
    for file in $(files); do
        if ! [ -s "$work/$file" ]; then
            say FAIL "$file is not drawn (see $work/log)"
            return 0
        fi
    done
    if ! (unset MAKEFLAGS MAKEOVERRIDES MFLAGS
          make -C "$top" -s BUILD="$work" CC="$compiler" CFLAGS="$flags" MARCH= \
              OPENMP= check) >"$work/check.log" 2>&1; then
        say FAIL "make check fails (see $work/check.log)"
    elif [ "$(grep -c '^step.* PASS .* exact$' "$work/check.log")" -ne "$(steps | wc -l)" ]; then
        say FAIL "not the pixels of tests/reference (see $work/check.log)"
    else
        say PASS "$(($(scenes | wc -l))) scenes, as in tests/reference"
    fi
}

# ---- Command line ----

# Read the row of configuration $1 into variables; false when there is none.
read_row() {
    row=$(table | awk -F '[[:space:]]*[|][[:space:]]*' -v name="$1" '$1 == name')
    field() {
        echo "$row" | awk -F '[[:space:]]*[|][[:space:]]*' -v i="$1" '{ print $i }'
    }
    name=$(field 1) verdict=$(field 2) compiler=$(field 3) flags=$(field 4)
    runner=$(field 5) packages=$(field 6)
    [ -n "$row" ]
}

build=$top/build/portability
one=
while getopts b:l1: option; do
    case $option in
        b) mkdir -p "$OPTARG" && build=$(cd "$OPTARG" && pwd) || exit 2 ;;
        l) table; exit 0 ;;
        1) one=$OPTARG ;; # used below: this configuration and no other, after the reference
        *) exit 2 ;;
    esac
done
shift $((OPTIND - 1))

if [ -n "$one" ]; then
    read_row "$one" && check_configuration
    exit
fi

for wanted in "$@"; do
    read_row "$wanted" || {
        echo "portability.sh: no configuration is called '$wanted'; portability.sh -l lists them" >&2
        exit 2
    }
done
named=$#
[ $# -gt 0 ] || {
    # shellcheck disable=SC2046 # names are single words
    set -- $(table | awk '{ print $1 }')
}

mkdir -p "$build" || exit 1
{
    check_reference &&
        printf '%s\n' "$@" |
        xargs -n 1 -P "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)" sh "$0" -b "$build" -1
} | tee "$build/results"
awk -v named="$named" '
    { count[$2]++ }
    END {
        printf "%d passed, %d failed, %d skipped\n", count["PASS"], count["FAIL"], count["SKIP"]
        exit NR == 0 || count["FAIL"] > 0 || (named > 0 && count["SKIP"] > 0)
    }' "$build/results"
