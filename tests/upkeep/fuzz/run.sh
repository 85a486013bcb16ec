#!/bin/bash
# Builds the fuzz targets of this directory and runs each for some time, as many at a time as there
# are processors. Called by `make fuzz`.
#
#   tests/upkeep/fuzz/run.sh BUILD MAKE SECONDS [NAME...]      NAME: png of fuzz_png.c, ...; none means all
#
# What is found grows in BUILD/fuzz/corpus/NAME, beginning with the files of
# tests/upkeep/fuzz/corpus/NAME.tar. FUZZ_MERGE=1 puts back into the latter the fewest of all these files
# that reach as much of the code.
# Exit status: 0 all is well, 1 a target found something, 2 clang or its runtime is missing.
# shellcheck disable=SC2317 # each() calls the functions
cd "$(dirname "$0")/../../.." || exit 1
. tests/upkeep/each.sh
work=$1/fuzz
make=$2
seconds=$3
shift 3
# shellcheck disable=SC2046 # one word a target
[ $# -gt 0 ] || set -- $(sh tests/upkeep/fuzz/corpus.sh names)
mkdir -p "$work/found" || exit 1
if ! echo 'int LLVMFuzzerTestOneInput(void) { return 0; }' |
    clang -fsanitize=fuzzer -x c - -o "$work/probe" 2>"$work/log"; then
    cat "$work/log" >&2
    echo "fuzz: clang cannot build fuzz targets; on Debian: apt-get install clang libclang-rt-14-dev" >&2
    echo "fuzz: (the number is that of clang --version)" >&2
    exit 2
fi

# Puts the fewest files into the target's archive.
merge() {
    rm -rf "$work/merged/$1"
    mkdir -p "$work/merged/$1" &&
        "$work/fuzz_$1" -merge=1 -use_counters=0 -max_len=2048 "$work/merged/$1" "$kept" "$grown" \
            >"$log" 2>&1 &&
        sh tests/upkeep/fuzz/corpus.sh pack "$1" "$work/merged/$1" &&
        echo "$1: $(find "$work/merged/$1" -type f | wc -l) files kept"
}

fuzz() {
    grown=$work/corpus/$1
    kept=$work/kept/$1
    log=$work/$1.log
    mkdir -p "$grown" && sh tests/upkeep/fuzz/corpus.sh unpack "$1" "$kept" || return 1
    if [ -n "${FUZZ_MERGE:-}" ]; then
        merge "$1"
        return
    fi
    words=
    [ ! -f "tests/upkeep/fuzz/$1.dict" ] || words=-dict=tests/upkeep/fuzz/$1.dict
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

sanitize='-fno-sanitize-recover=all -fsanitize=fuzzer-no-link,address,undefined'
unset MAKEFLAGS MFLAGS # of the make that calls
$make CC=clang BUILD="$work" WERROR=-Werror SANITIZED="-O2 -g -fno-omit-frame-pointer $sanitize" \
    "${@/#/$work/fuzz_}" || exit 1
export work seconds
export -f fuzz merge
each fuzz "$@"
