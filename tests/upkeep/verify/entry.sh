# shellcheck shell=sh disable=SC2034 # its readers use what it sets
# What try.sh and draw.sh share: sets what the line of WORK/table tells of a program, and gives them
# check(). They are called with BUILD MAKE WORK NUMBER.
build=$1
make=$2
work=$3
number=$4
tab=$(printf '\t')
IFS=$tab read -r _ lesson kind name scene compiler flags task says figure part <<END
$(grep "^$number$tab" "$work/table")
END
place=$work/$number
# -O0 builds in a third of the time that -O1 takes, and draws the same; but lessons 6 and 8 draw
# longer than that saves. Lessons 9 and 10 build twice as fast where what is always inlined elsewhere
# is a function.
case $lesson in
step06_* | step08_*) fast=-O1 ;;
step09_* | step10_*) fast='-O0 -Dalways_inline=unused -Dflatten=unused' ;;
*) fast=-O0 ;;
esac
# (VERIFY_FLAGS: others, for programs that draw often.)
[ "$flags" != - ] || flags=${VERIFY_FLAGS:-$fast}
# Without optimizing, clang draws several pixels at once three times as fast as gcc.
case $kind/$lesson in
mistake/step09_* | mistake/step10_*)
    [ "$compiler" != - ] || ! command -v clang >/dev/null || compiler=clang
    ;;
esac
[ "$compiler" = - ] && cc= || cc="CC='$compiler'"
# The commands that make would call for such a program, asked once: build.sh calls them without make,
# which would take a fifth of the time.
commands=$work/commands.$(echo "$compiler $flags" | cksum | tr ' ' .)
if [ ! -s "$commands" ]; then
    eval "$make --no-print-directory $cc CFLAGS='$flags' WERROR= commands" >"$commands.$number" 2>"$place/errors" &&
        mv "$commands.$number" "$commands" || { cat "$place/errors" >&2 && exit 1; }
fi
export CHECK_EXACT=0
# Correct programs have time: they may be built with sanitizers, on a busy machine.
export CHECK_BUILD_TIMEOUT="${CHECK_BUILD_TIMEOUT:-600}"
[ "$kind" = mistake ] || export CHECK_TIMEOUT="${CHECK_TIMEOUT:-60}"
# A mistake may want all memory there is. (Not in POSIX, but in every sh.)
# shellcheck disable=SC3045
[ "$kind" != mistake ] || ulimit -v 4000000

# check [OPTION...]: sets status, and said to the verdict and what follows it, as one line.
check() {
    said=$("$build/check" --programs "$place" --sources "$place/sources" \
        --differences "$place/differences" --shares "$place/shares" \
        --make "sh tests/upkeep/verify/build.sh $commands" "$@" "$lesson" 2>"$place/errors")
    status=$?
    said=$(echo "$said" | awk '/^SCORE/ { exit }
        /^  / { printf "; %s", substr($0, 3); next }
        { sub(/^[^ ]+  /, ""); printf "%s", $0 }')
    [ -n "$said" ] || said=$(cat "$place/errors")
}
