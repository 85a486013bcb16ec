#!/bin/sh
# Tries every file of the fuzz targets' archives on them again, whatever compiler has built them.
# Called by `make test`, which builds the targets; CHECK_PROGRAMS names the build directory.
#
# Exit status 0: every promise holds for every file; 1: one does not, or a file is missing.
cd "$(dirname "$0")/../../.." || exit 1
build=${CHECK_PROGRAMS:-build}
log=$build/fuzz/replay.log
failed=0

for name in $(sh tests/upkeep/fuzz/corpus.sh names); do
    kept=$build/fuzz/replayed/$name
    sh tests/upkeep/fuzz/corpus.sh unpack "$name" "$kept" || exit 1
    if "$build/tests/upkeep/fuzz/fuzz_$name" "$kept"/* >"$log" 2>&1; then
        echo "$name: $(find "$kept" -type f | wc -l) files, all is well"
    else
        tail -n 20 "$log"
        echo "$name: FAILED at the last file named; try it with $build/tests/upkeep/fuzz/fuzz_$name FILE"
        failed=1
    fi
done
exit $failed
