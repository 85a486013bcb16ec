#!/bin/sh
# Lets the check judge one program of the table that verify.sh has made: builds it, draws the scene
# or all of them, compares.
#
#   tests/verify/try.sh BUILD MAKE WORK NUMBER
#
# Prints a finding, or nothing. Adds `LESSON KIND right` or `... wrong` to WORK/results, and to
# WORK/shares, for each picture, `KIND NAME LESSON SCENE WRONG APART COVERAGE` with percentages.
build=$1
make=$2
work=$3
number=$4
tab=$(printf '\t')
IFS=$tab read -r _ lesson kind name scene compiler flags says <<END
$(grep "^$number$tab" "$work/table")
END
place=$work/$number

# finding WORDS: prints them with the name; the result is wrong.
finding() {
    result=wrong
    case $kind in
    starter | solution) echo "$1 $lesson/$name: $2" ;;
    *) echo "$1 ${lesson%%_*}/$name: $2" ;;
    esac
}

# check [OPTION...]: sets status, and said to the verdict and what follows it, as one line.
check() {
    said=$("$build/check" --programs "$place" --sources "$place/sources" --first '' \
        --differences "$place/differences" --shares "$place/shares" \
        --make "$make CFLAGS='$flags' WERROR= $compiler" "$@" "$lesson" 2>"$place/errors")
    status=$?
    said=$(echo "$said" | awk '/^SCORE/ { exit }
        /^  / { printf "; %s", substr($0, 3); next }
        { sub(/^[^ ]+  /, ""); printf "%s", $0 }')
    [ -n "$said" ] || said=$(cat "$place/errors")
}

# A mistake that the scene does not show: whether others do.
describe_others() {
    check
    [ "$status" -eq 1 ] && echo "; all scenes: $said"
}

judge() {
    case $kind:$status:$said in
    mistake:1:BUILD*) finding ERROR "$said" ;;
    mistake:1:* | starter:1:TODO\ 0/* | accept:0:* | solution:0:*' exact') ;; # as it should be
    mistake:0:*) finding PASSES "${said#PASS } ($says)$(describe_others)" ;;
    accept:1:*) finding FAILS "$said ($says)" ;;
    starter:[01]:* | solution:[01]:*) finding WRONG "$said" ;;
    *) finding ERROR "$said" ;;
    esac
}

if [ "$compiler" != - ] && ! command -v "$compiler" >/dev/null; then
    echo "SKIPPED ${lesson%%_*}/$name: there is no $compiler"
    exit 0
fi
[ "$flags" != - ] || flags=-O0 # builds in a third of the time that -O1 takes, and draws the same
[ "$compiler" = - ] && compiler= || compiler="CC='$compiler'"
result=right
export CHECK_EXACT=0
# Correct programs have time: they may be built with sanitizers, on a busy machine.
export CHECK_BUILD_TIMEOUT="${CHECK_BUILD_TIMEOUT:-600}"
[ "$kind" = mistake ] || export CHECK_TIMEOUT="${CHECK_TIMEOUT:-60}"
# A starter's main.c says what is to do.
if [ "$kind" = starter ]; then
    mkdir -p "$place/sources/$lesson" && cp "$place/main.c" "$place/sources/$lesson" || exit 1
fi
# A mistake may want all memory there is. (Not in POSIX, but in every sh.)
# shellcheck disable=SC3045
[ "$kind" != mistake ] || ulimit -v 4000000
case $scene in -) check ;; *) check --only "$scene" ;; esac
[ ! -f "$place/shares" ] || sed "s/^/$kind $name /" "$place/shares" >>"$work/shares"
judge
echo "$lesson $kind $result" >>"$work/results"
rm -rf "$place"
