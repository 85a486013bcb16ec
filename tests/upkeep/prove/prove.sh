#!/bin/sh
# What holds of raster.c for every input there is, by Frama-C's Eva (Debian: frama-c-base): each number is
# an interval, each `assert` of raster_proof.c must hold for all of it, and no sum, product or conversion of
# whole numbers may overflow. Then three faults in copies of common, each of which must raise an alarm.
#
#   prove.sh DIR        DIR: for the copies
#
# Exit status 0: all is proved, and each fault is found; 1: not; 77: there is no Frama-C.
cd "$(dirname "$0")/../../.." || exit 1
if ! command -v frama-c >/dev/null; then
    echo 'prove: frama-c is missing; on Debian: apt-get install frama-c-base' >&2
    exit 77
fi
rm -rf "$1" && mkdir -p "$1" || exit 1
failed=0

# eva COMMON FUNCTION [OPTION...]: does it raise no alarm? What it says stays in DIR/said. A conversion to
# int is no overflow in C, but it is for us: all are looked at but the last one of line_begin(), whose
# result Eva can't bound (`make stress` tries it).
eva() {
    common=$2
    function=$3
    said=$1/said
    shift 3
    frama-c -eva -eva-precision 5 -warn-special-float none -machdep gcc_x86_64 -main "$function" "$@" \
        -cpp-extra-args="-I$common -std=c17" tests/upkeep/prove/raster_proof.c >"$said" 2>&1 &&
        grep -q '^  0 alarms' "$said" && ! grep -q 'got status' "$said"
}

# proves DIR WHAT FUNCTION [OPTION...]
proves() {
    where=$1
    what=$2
    shift 2
    if eva "$where" common "$@"; then
        echo "proved  $what"
    else
        echo "NOT     $what:"
        grep -A 4 'eva:alarm\|got status\|rror' "$where/said"
        failed=1
    fi
}

# finds DIR WHAT FUNCTION FILE OLD NEW: an alarm where that line of a file of common has the fault.
finds() {
    cp -R common "$1/common" && sed "s/$5/$6/" "common/$4" >"$1/common/$4"
    if cmp -s "common/$4" "$1/common/$4" || eva "$1" "$1/common" "$3" -warn-signed-downcast ||
        ! grep -q 'eva:alarm' "$1/said"; then
        echo "NOT     found: $2"
        failed=1
    else
        echo "found   $2"
    fi
    rm -r "$1/common"
}

proves "$1" 'any corners, any image, row and pixel: no overflow; spans lie in the image' \
    prove_triangles -warn-signed-downcast
proves "$1" 'in the guard band a double holds every value of an edge function' \
    prove_guard_band -warn-signed-downcast
proves "$1" 'any line, any image: no overflow, no division by 0' prove_lines -eva-partition-history 1
proves "$1" 'any two numbers snapped; any row of centres; any cell of a grid' \
    prove_numbers -warn-signed-downcast -eva-partition-history 1
finds "$1" 'an int for the distances of an edge' prove_triangles raster.c \
    'int64_t x_distance = sign . ((int64_t)q.x - p.x), y_distance = sign . ((int64_t)q.y - p.y)' \
    'int x_distance = sign * (q.x - p.x), y_distance = sign * (q.y - p.y)'
finds "$1" 'corners up to 2^31 steps away' prove_triangles raster.h 'SCREEN_LIMIT = 1 << 21' 'SCREEN_LIMIT = 1 << 23'
finds "$1" 'a span that is not cut to the image' prove_triangles raster.c \
    'span.end = end > span.begin ? (int)end : span.begin' 'span.end = (int)end'
exit $failed
