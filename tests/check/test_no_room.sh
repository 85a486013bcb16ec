#!/bin/sh
# A disk that is full is no fault of a main.c: is that told as the check's own error, and only that?
# And is nothing handed out then, instead of a part of it? A small file system in memory is TMPDIR,
# or where it is handed out to; where none may be mounted, nothing is tried.
. "$(dirname "$0")/../unit/script.sh"
unset CHECK_RUNNER

if [ -z "${NO_ROOM:-}" ]; then
    unshare -rm mount -t tmpfs none "$work" 2>/dev/null || skip "nothing may be mounted here"
    NO_ROOM=1 unshare -rm sh "$top/tests/check/test_no_room.sh"
    exit
fi

# judges SIZE STATUS WORDS COMMAND: with so much memory for its files, a program that COMMAND makes.
judges() {
    mkdir -p "$work/disk" && mount -t tmpfs -o "size=$1" none "$work/disk" || exit 1
    said_by "$2" env TMPDIR="$work/disk" "$build/check" --root "$top" --programs "$work/programs" \
        --differences "$work/differences" --scenes "$work/scenes.txt" --make "$4; true" 01
    grep -q "$3" "$said" || wrong "with $1, nothing says $3"
    umount "$work/disk"
}

mkdir -p "$work/programs" && grep -v '^call ' tests/check/scenes.txt >"$work/scenes.txt" || exit 1
printf '#!/bin/sh\nexit 1\n' >"$work/stop"
printf '#!/bin/sh\ncat /dev/zero >here\n' >"$work/fill"
chmod +x "$work/stop" "$work/fill"
program=$work/programs/step01_line
full="step01_line  ERROR 0/.*No space left on device"
fails='{ echo "main.c:9: fatal error: error writing to x.s: No space left on device" >&2; exit 1; }'
judges 100m 0 'step01_line  PASS' "cp '$build/quick/step01_line' '$program'"
judges 20k 2 "$full" "cp '$build/quick/step01_line' '$program'"
judges 4k 2 "$full" "cp '$build/quick/step01_line' '$program'"
judges 100m 1 'step01_line  FAIL' "cp '$work/stop' '$program'"
judges 100m 1 'step01_line  BUILD' "$fails"
judges 64k 2 "$full" "$fails"
judges 64k 1 'step01_line  BUILD' '{ echo "main.c:9: error: no" >&2; exit 1; }'
judges 50m 1 'step01_line  FAIL' "cp '$work/fill' '$program'" # which has room without that

# hands_out SIZE PLACE: nothing where there is only so much room, which ends in that directory: so much
# is for pictures, and then for some of the headers, which another program writes.
hands_out() {
    mkdir -p "$work/disk" && mount -t tmpfs -o "size=$1" none "$work/disk" || exit 1
    said_by 1 sh tests/teacher/handout/handout.sh "$work/disk/out" 1
    grep -q "^make handout: cannot write .*/$2.*" "$said" || wrong "with $1, it says something else"
    [ -z "$(ls "$work/disk")" ] || wrong "with $1, it leaves $(ls "$work/disk")"
    umount "$work/disk"
}

hands_out 270k tests/reference/step01_line
hands_out 500k common
exit $failed
