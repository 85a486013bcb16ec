#!/bin/bash
# Build the fuzz targets beside this script and run each for some time, as many at a time as there
# are processors. Called by `make fuzz`.
#
#   tests/upkeep/fuzz/run.sh BUILD SECONDS [NAME...]      NAME: png of fuzz_png.c, ...; none means all
#
# What is found grows in BUILD/fuzz/corpus/NAME, beginning with the files of
# tests/upkeep/fuzz/corpus/NAME.tar. FUZZ_MERGE=1 puts back into the latter the fewest of all these files
# that reach as much of the code.
# Exit status: 0 all is well, 1 a target found something, 2 clang or its runtime is missing.
# shellcheck disable=SC2317 # each() calls the functions
cd "$(dirname "$0")/../../.." || exit 1
. tests/upkeep/each.sh
build=${1:-build}
seconds=${2:-60}
if [ $# -ge 2 ]; then shift 2; else shift $#; fi
clang=${FUZZ_CC:-clang}
work=$build/fuzz
mkdir -p "$work/objects" "$work/found" || exit 1

flags="-std=c17 -O2 -g -ffp-contract=off -fno-omit-frame-pointer -fno-sanitize-recover=all
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wstrict-prototypes -Wmissing-prototypes -Werror
    -Icommon -Itests/fuzz"
sanitize=address,undefined

echo 'int LLVMFuzzerTestOneInput(const char *d, long n); int LLVMFuzzerTestOneInput(const char *d,
    long n) { return d == 0 && n < 0; }' >"$work/probe.c"
if ! "$clang" -fsanitize=fuzzer,$sanitize "$work/probe.c" -o "$work/probe" 2>"$work/log"; then
    echo "fuzz: $clang cannot build fuzz targets; on Debian: apt-get install clang libclang-rt-14-dev" >&2
    echo "fuzz: (the number is that of clang --version); what it said:" >&2
    cat "$work/log" >&2
    exit 2
fi

compile() { # SOURCE
    # shellcheck disable=SC2086
    "$clang" $flags -fsanitize=fuzzer-no-link,$sanitize -c "$1" \
        -o "$work/objects/$(basename "$1" .c).o"
}

# The target of a name: built, and merged or run.
fuzz() {
    grown=$work/corpus/$1
    kept=$work/kept/$1
    log=$work/$1.log
    mkdir -p "$grown" && tests/upkeep/fuzz/corpus.sh unpack "$1" "$kept" || return 1
    # shellcheck disable=SC2086
    "$clang" $flags -fsanitize=fuzzer,$sanitize "tests/upkeep/fuzz/fuzz_$1.c" "$work"/objects/*.o -lm \
        -o "$work/fuzz_$1" || return 1
    if [ "${FUZZ_MERGE:-0}" = 1 ]; then
        rm -rf "$work/merged/$1"
        mkdir -p "$work/merged/$1" || return 1
        "$work/fuzz_$1" -merge=1 -use_counters=0 -max_len=2048 "$work/merged/$1" "$kept" "$grown" \
            >"$log" 2>&1 || return 1
        tests/upkeep/fuzz/corpus.sh pack "$1" "$work/merged/$1" || return 1
        echo "$1: $(find "$work/merged/$1" -type f | wc -l) files kept"
        return
    fi
    words=
    [ -f "tests/upkeep/fuzz/$1.dict" ] && words=-dict=tests/upkeep/fuzz/$1.dict
    # shellcheck disable=SC2086
    if "$work/fuzz_$1" -max_total_time="$seconds" -max_len=4096 -timeout=20 -rss_limit_mb=2048 \
        -malloc_limit_mb=512 -print_final_stats=1 -artifact_prefix="$work/found/$1-" $words \
        "$grown" "$kept" >"$log" 2>&1; then
        sed -n "s/^Done \(.*\)/$1: \1, nothing found/p" "$log"
    else
        tail -n 40 "$log"
        echo "$1: FAILED; the file is in $work/found; try it again with $work/fuzz_$1 FILE"
        return 1
    fi
}

export clang flags sanitize work seconds
export -f compile fuzz
sources=
for source in common/*.c; do
    # Command lines are not hostile files.
    [ "$source" = common/program.c ] || sources="$sources $source"
done
# shellcheck disable=SC2046 # one word a target
[ $# -gt 0 ] || set -- $(tests/upkeep/fuzz/corpus.sh names)
# shellcheck disable=SC2086 # one word a source
each compile $sources && each fuzz "$@" || exit 1
