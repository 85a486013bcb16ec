#!/bin/sh
# A disk that is full is no fault of a main.c: is that told as the check's own error, and only that?
# And is nothing handed out then, instead of a part of it? A small file system in memory is TMPDIR,
# or where it is handed out to; where none may be mounted, nothing is tried.
#
# Exit status 0: all of that is so; 1: something is not.

if [ -z "${NO_ROOM_WORK:-}" ]; then
    NO_ROOM_WORK=$(mktemp -d) || exit 1
    export NO_ROOM_WORK
    trap 'rm -rf "$NO_ROOM_WORK"' EXIT
    trap 'exit 1' HUP INT TERM
    if ! unshare -rm mount -t tmpfs none "$NO_ROOM_WORK" 2>/dev/null; then
        echo "no_room: skipped, nothing may be mounted here"
        exit 0
    fi
    unshare -rm "$0"
    exit
fi

top=$(cd "$(dirname "$0")/../.." && pwd) || exit 1
build=$(cd "$top" && cd "${CHECK_PROGRAMS:-build}" && pwd) || exit 1
work=$NO_ROOM_WORK
unset MAKEFLAGS MFLAGS CHECK_EXACT CHECK_RUNNER # of the make that runs this test
failed=0

# judges SIZE STATUS WORDS COMMAND: with so much memory for its files, a program that COMMAND makes.
judges() {
    mkdir -p "$work/disk" && mount -t tmpfs -o "size=$1" none "$work/disk" || exit 1
    TMPDIR=$work/disk "$build/check" --root "$top" --programs "$work/programs" --first '' \
        --differences "$work/differences" --make "$4; true" 01 >"$work/said" 2>&1
    status=$?
    if [ $status -ne "$2" ] || ! grep -q "$3" "$work/said"; then
        echo "no_room: with $1, $4 ended with $status, not $2:"
        cat "$work/said"
        failed=1
    fi
    umount "$work/disk"
}

mkdir -p "$work/programs" || exit 1
printf '#!/bin/sh\nexit 1\n' >"$work/stop"
printf '#!/bin/sh\ncat /dev/zero >here\n' >"$work/fill"
chmod +x "$work/stop" "$work/fill"
program=$work/programs/step01_line
full="step01_line  ERROR 0/.*No space left on device"
fails='{ echo "main.c:9: fatal error: error writing to x.s: No space left on device" >&2; exit 1; }'
judges 100m 0 'step01_line  PASS' "cp '$build/step01_line' '$program'"
judges 20k 2 "$full" "cp '$build/step01_line' '$program'"
judges 4k 2 "$full" "cp '$build/step01_line' '$program'"
judges 100m 1 'step01_line  FAIL' "cp '$work/stop' '$program'"
judges 100m 1 'step01_line  BUILD' "$fails"
judges 64k 2 "$full" "$fails"
judges 64k 1 'step01_line  BUILD' '{ echo "main.c:9: error: no" >&2; exit 1; }'
judges 50m 1 'step01_line  FAIL' "cp '$work/fill' '$program'" # which has room without that

# hands_out SIZE PLACE: nothing where there is only so much room, which ends in that directory: so much
# is for pictures, and then for some of the headers, which another program writes.
hands_out() {
    mkdir -p "$work/disk" && mount -t tmpfs -o "size=$1" none "$work/disk" || exit 1
    if (cd "$top" && tests/teacher/handout/handout.sh "$work/disk/out" 1) >"$work/said" 2>&1 ||
        ! grep -q "^make handout: cannot write .*/$2.*" "$work/said" ||
        [ -n "$(ls "$work/disk")" ]; then
        echo "no_room: with $1, make handout ended so, and left '$(ls "$work/disk")':"
        cat "$work/said"
        failed=1
    fi
    umount "$work/disk"
}

hands_out 300k tests/reference/step01_line
hands_out 600k common
exit $failed
