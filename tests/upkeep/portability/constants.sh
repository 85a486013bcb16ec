#!/bin/sh
# Do lessons 9 and 10 draw the same bytes with other values of the pipeline's constants, and do the
# sanitizers find nothing?
#
#   constants.sh DIR [NAME=VALUE...]
cd "$(dirname "$0")/../../.." || exit 1
mkdir -p "$1" && where=$(cd "$1" && pwd) || exit 1
shift
[ $# -gt 0 ] || set -- BAND_HEIGHT=8 BAND_HEIGHT=16 TILE_HEIGHT=4 TILE_HEIGHT=16 CHUNK_WIDTH=32 BLOCK_SIZE=16
frame=common/pipeline/frame.h
for change in "$@"; do
    copy=$where/${change%=*}-${change#*=}
    rm -rf "$copy" && mkdir "$copy" && git ls-files -z | xargs -0 cp --parents -t "$copy" || exit 1
    sed "s/\(\b${change%=*} =\) [0-9]*/\1 ${change#*=}/" $frame >"$copy/$frame"
    ! cmp -s $frame "$copy/$frame" || { echo "$frame: no ${change%=*}, or with that value"; exit 1; }
    echo "$change:"
    for step in 09 10; do
        CHECK_EXACT=1 make -s -C "$copy" check STEP=$step \
            CFLAGS="-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all" || exit 1
    done
    rm -rf "$copy"
done
