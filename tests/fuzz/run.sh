#!/bin/sh
# Build the fuzz targets beside this script and run each for some time. Called by `make fuzz`.
#
#   tests/fuzz/run.sh BUILD SECONDS [NAME...]      NAME: png of fuzz_png.c, ...; none means all
#
# What is found grows in BUILD/fuzz/corpus/NAME, beginning with the files of
# tests/fuzz/corpus/NAME.tar. FUZZ_MERGE=1 puts back into the latter the fewest of all these files
# that reach as much of the code.
# Exit status: 0 all is well, 1 a target found something, 2 clang or its runtime is missing.
cd "$(dirname "$0")/../.." || exit 1
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

for source in common/*.c; do
    [ "$source" = common/program.c ] && continue # command lines are not hostile files
    # shellcheck disable=SC2086
    "$clang" $flags -fsanitize=fuzzer-no-link,$sanitize -c "$source" \
        -o "$work/objects/$(basename "$source" .c).o" || exit 1
done

# shellcheck disable=SC2046 # one word a target
[ $# -gt 0 ] || set -- $(tests/fuzz/corpus.sh names)
failed=0
for name in "$@"; do
    grown=$work/corpus/$name
    kept=$work/kept/$name
    mkdir -p "$grown" && tests/fuzz/corpus.sh unpack "$name" "$kept" || exit 1
    # shellcheck disable=SC2086
    "$clang" $flags -fsanitize=fuzzer,$sanitize "tests/fuzz/fuzz_$name.c" "$work"/objects/*.o -lm \
        -o "$work/fuzz_$name" || exit 1
    if [ "${FUZZ_MERGE:-0}" = 1 ]; then
        rm -rf "$work/merged"
        mkdir "$work/merged" || exit 1
        "$work/fuzz_$name" -merge=1 -use_counters=0 -max_len=2048 "$work/merged" "$kept" "$grown" \
            >"$work/log" 2>&1 || exit 1
        tests/fuzz/corpus.sh pack "$name" "$work/merged" || exit 1
        echo "$name: $(find "$work/merged" -type f | wc -l) files kept"
        continue
    fi
    words=
    [ -f "tests/fuzz/$name.dict" ] && words=-dict=tests/fuzz/$name.dict
    # shellcheck disable=SC2086
    if "$work/fuzz_$name" -max_total_time="$seconds" -max_len=4096 -timeout=20 -rss_limit_mb=2048 \
        -malloc_limit_mb=512 -print_final_stats=1 -artifact_prefix="$work/found/$name-" $words \
        "$grown" "$kept" >"$work/log" 2>&1; then
        sed -n "s/^Done \(.*\)/$name: \1, nothing found/p" "$work/log"
    else
        tail -n 40 "$work/log"
        echo "$name: FAILED; the file is in $work/found; try it again with $work/fuzz_$name FILE"
        failed=1
    fi
done
exit $failed
