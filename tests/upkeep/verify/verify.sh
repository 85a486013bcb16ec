#!/bin/sh
# Does the check fail every mistake, and pass every correct program? For every lesson: the solution
# must pass exactly, the starter must be to do, a solution in which one task is as in the starter must
# fail nothing that does not need it, each mistake of stepNN_name/mistakes.txt must fail in
# the scene that it names and look like itself there (tests/check/looks.h), draw its lesson's figure
# where it gives one, and in the whole lesson cost no earlier part a point and lead to no hint for a
# task whose calls are right; each program of tests/lessons/stepNN_name/alternatives.txt must pass, and the
# solution in each of the ways to build it of tests/lessons/builds.txt.
#
#   tests/upkeep/verify/verify.sh BUILD MAKE [STEP [PATTERN]]
#
# MAKE builds a program; STEP is 5, 05 or step05_zbuffer; PATTERN: only mistakes and programs with
# it in their names. Works in BUILD, where the check, the library and the models must be built. As
# many at a time as there are processors; WORKERS=1 in the environment for one, VERIFY_SHARE=0/32 to
# 31/32 for one of 32 of all these programs.
#
# Prints each finding as it comes, with what the check said, then how many of each lesson were judged
# rightly.
# Exit status 0: no finding; 1: some, or a list is wrong.
cd "$(dirname "$0")/../../.." || exit 1
build=$1
make=$2
wanted=${3:-}
only=${4:-}
share=${VERIFY_SHARE:-}
workers=${WORKERS:-$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)}
work=$(mktemp -d "$build/verify.XXXXXX") || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

fail() {
    echo "verify: $*" >&2
    exit 1
}

# Sets lessons to those that are wanted, and lists to theirs.
find_lessons() {
    lessons=
    lists=
    for lesson in step[0-9]*_*/main.c; do
        lesson=${lesson%/main.c}
        number=${lesson#step}
        number=${number%%_*}
        case $wanted in '' | "$lesson" | "$number" | "${number#0}") ;; *) continue ;; esac
        lessons="$lessons $lesson"
        for list in "$lesson/mistakes.txt" "tests/lessons/$lesson/alternatives.txt"; do
            [ ! -s "$list" ] || lists="$lists $list"
        done
    done
    [ -n "$lessons" ] || fail "there is no step '$wanted'"
}

# add_program LESSON KIND NAME MARKS...: adds what marks.awk makes of the lesson, with these options.
add_program() {
    program_lesson=$1
    kind=$2
    name=$3
    shift 3
    mkdir "$work/$program_lesson.$name" &&
        awk "$@" -f tests/student/marks.awk "$program_lesson/main.c" \
            >"$work/$program_lesson.$name/main.c" || exit 1
    printf '%s\t%s\t%s\t%s\t-\t-\t-\t-\t-\t0\t-\n' "$program_lesson.$name" "$program_lesson" "$kind" \
        "$name" >>"$work/table"
}

# add_builds LESSON: adds its solution, built in each of the ways of tests/lessons/builds.txt.
add_builds() {
    [ -f tests/lessons/builds.txt ] || return 0
    sed '/^#/d' tests/lessons/builds.txt | while read -r name compiler flags; do
        case $name in *"$only"*) ;; *) continue ;; esac
        mkdir "$work/$1.$name" &&
            awk -v mode=solution -f tests/student/marks.awk "$1/main.c" >"$work/$1.$name/main.c" ||
            exit 1
        printf '%s\t%s\taccept\t%s\t-\t%s\t%s\t-\tbuilt otherwise\t0\t-\n' "$1.$name" "$1" "$name" \
            "$compiler" "$flags" >>"$work/table"
    done || exit 1
}

# The entries of the lists, then what is made of each lesson's solution, in $work/table.
make_table() {
    : >"$work/table"
    # shellcheck disable=SC2086 # one word a list
    [ -z "$lists" ] || awk -v directory="$work" -v only="$only" -f tests/upkeep/verify/replace.awk \
        -f tests/upkeep/verify/parse.awk $lists >"$work/table" || exit 1
    for lesson in $lessons; do
        add_builds "$lesson"
    done
    if [ -n "$only" ]; then
        [ -s "$work/table" ] || fail "no name has '$only' in it"
        return
    fi
    for lesson in $lessons; do
        add_program "$lesson" starter starter -v mode=starter
        add_program "$lesson" solution solution -v mode=solution
        for task in $(awk -v mode=tasks -f tests/student/marks.awk "$lesson/main.c" | cut -f 1); do
            add_program "$lesson" undone "$task" -v mode=solution -v "undone=$task"
        done
    done
}

# count LESSON KIND RESULT: how many of those have that result.
count() {
    awk -v lesson="$1" -v kind="$2" -v result="$3" \
        '$1 == lesson && $2 == kind && (result == "" || $3 == result) { n++ } END { print n + 0 }' \
        "$work/results"
}

# share LESSON KIND: right ones / all of them.
share() {
    echo "$(count "$1" "$2" right)/$(count "$1" "$2" '')"
}

# named LESSON: of the mistakes that are found, those that the check names.
named() {
    awk -v lesson="$1" '$1 == lesson && $2 == "mistake" { n++; named += $4 == "yes" }
        END { print named + 0 "/" n + 0 }' "$work/results"
}

# one LESSON KIND WORDS: the words, when it is right.
one() {
    case $(share "$1" "$2") in 1/1) echo "$3" ;; 0/0) echo - ;; *) echo wrong ;; esac
}

print_table() {
    format='%-20s %14s %8s %20s %12s  %-8s %s\n'
    # shellcheck disable=SC2059 # the same for all rows
    {
        printf "$format" lesson 'mistakes found' named 'alternatives passed' 'tasks undone' starter \
            solution
        for lesson in $lessons; do
            printf "$format" "$lesson" "$(share "$lesson" mistake)" "$(named "$lesson")" \
                "$(share "$lesson" accept)" "$(share "$lesson" undone)" \
                "$(one "$lesson" starter "to do")" "$(one "$lesson" solution exact)"
        done
    }
}

find_lessons
make_table
if [ -n "$share" ]; then
    awk -v share="$share" 'BEGIN { split(share, part, "/") } NR % part[2] == part[1] % part[2]' \
        "$work/table" >"$work/part" && mv "$work/part" "$work/table" || exit 1
    [ -s "$work/table" ] || fail "there is nothing in this share"
fi
: >"$work/results"
cut -f 1 "$work/table" |
    xargs -P "$workers" -n 1 sh tests/upkeep/verify/try.sh "$build" "$make" "$work" || fail "stopped"
echo
print_table
! grep -q ' wrong ' "$work/results"
