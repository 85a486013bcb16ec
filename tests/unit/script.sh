# shellcheck shell=sh disable=SC2034 # for the tests that read this
# What the tests that are scripts have in common; each reads this with `.` first. They work in the
# course's directory, `top`, with its programs in `build`, and an empty directory, `work`, that goes
# when they end. They say what is wrong by wrong(), and end with `exit $failed`: 0, or 1 after that.
test=$(basename "$0" .sh)
cd "$(dirname "$0")" || exit 1
until [ -d tests/reference ]; do
    [ "$PWD" != / ] && cd .. || exit 1
done
top=$PWD
build=$(cd "${CHECK_PROGRAMS:-build}" 2>/dev/null && pwd)
work=$(mktemp -d) || exit 1
running= # a process that ends with the test
trap '[ -z "$running" ] || kill $running 2>/dev/null; rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
failed=0

# Settings of the make that runs the test are not for those that it calls.
unset MAKEFLAGS MFLAGS MAKELEVEL BUILD CC CFLAGS MARCH WERROR
unset STEP SCENE WHICH KIND TASK AGAIN LESSONS NAME HIDDEN SOLUTION CHECK_EXACT
unset DISPLAY WAYLAND_DISPLAY # where `make open` would open a window

# wrong WORDS...: and what was said, where that is in $said.
wrong() {
    echo "$test: $*"
    [ -z "${said:-}" ] || sed 's/^/    /' "$said"
    failed=1
}

# skip WORDS...: ends the test, for which this machine lacks what they name; make test counts it.
skip() {
    echo "$test: skipped: $*"
    exit 77
}

# said_by STATUS COMMAND...: runs it and keeps what it says in $said. A make ends with 0 or with 2:
# then any status but 0 is as good as 1.
said=
said_by() {
    wanted=$1
    shift
    said=$work/said
    "$@" >"$said" 2>&1
    got=$?
    [ "$got" -eq "$wanted" ] || [ "$1 $wanted $got" = 'make 1 2' ] ||
        wrong "status $got, not $wanted: $*"
}

# says TEXT, silent TEXT: the last one said it somewhere, or did not.
says() {
    grep -qF -e "$1" "$said" || wrong "nothing says: $1"
}

silent() {
    ! grep -qF -e "$1" "$said" || wrong "something says: $1"
}

# pages LESSON: those with tasks, one a line.
pages() {
    grep -l '^### Task ' "$1"/*.md
}
