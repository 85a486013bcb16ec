#!/bin/sh
# Makes a directory with a program that draws, for a student to change.
#
#     new.sh MAKE NAME [AFTER]        MAKE as in '$(MAKE) -s', AFTER as 3
#
# NAME/main.c is new.c with this name in it, which draws with the pipeline. After one of lessons 1 to 8 it
# is what she wrote in that lesson, and a loop from after.txt that draws with it. `make NAME` finds the
# directory by the file NAME/.new, which holds AFTER.
#
# Exit status: 0 done; 1 it cannot be done, and nothing is left behind; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
LC_ALL=C
export LC_ALL
make=$1
name=$2
after=$3

# fail STATUS MESSAGE...
fail() {
    status=$1
    shift
    printf '%s\n' "make new: $*" >&2
    exit "$status"
}

# Is it a target of make, such as check?
is_target() {
    $make -pq help 2>/dev/null | grep -q "^$1 *:"
}

[ -n "$name" ] || fail 2 "say a name, for example make new NAME=mine"
case $name in
*[!A-Za-z0-9_]*) fail 2 "a name has letters A-Z and a-z, digits and _ only: \"$name\" does not" ;;
esac
case $name in step[0-9]*) fail 2 "$name is a lesson's name: take another one" ;; esac
[ ! -e "$name" ] || fail 1 "$name is here already: take another name"
! is_target "$name" || fail 2 "make $name does something else already: take another name"

lesson=$(ls -d "step0${after#0}"_* 2>/dev/null)
case $after in
'' | 9 | 09 | 10)
    [ -f tests/student/new.c ] || fail 2 "say after which lesson, for example make new NAME=$name AFTER=3:" \
        "without that it draws with the pipeline, which comes with the hand-outs of lessons 9 and 10"
    after=
    ;;
*) [ -f "$lesson/main.c" ] || fail 2 "AFTER=$after is none of the lessons that are here" ;;
esac

# What she wrote in the lesson, as the compiler sees it, and what draws with it.
write_after() {
    number=${after#0}
    echo "/* $name: a program of your own. It begins with what you wrote in lesson $number: change all of it. */"
    if grep -q 'BEGIN [S]OLUTION [1-9]' "$lesson/main.c"; then
        awk -v mode=solution -f tests/student/marks.awk "$lesson/main.c"
    else
        cat "$lesson/main.c"
    fi | sed '/^[ 	]*#[ 	]*include[ 	]*"scenes.h"/,$d'
    awk -v number="$number" -v name="$name" '
        $1 == "@" {
            chosen = $2 == number || $2 == "end"
            if ($2 == number) {
                needs = $3 ~ /^NEEDS/ ? $3 : 0
                gsub(/[|]/, " | ", needs)
                summary = $0
                sub(/^@ [0-9] (NEEDS[^ ]* )?/, "", summary)
            }
            getline # an empty line
            next
        }
        chosen {
            sub(/\.needs = NEEDS/, ".needs = " needs)
            sub(/SUMMARY/, summary)
            sub(/CAMERA/, number == 8 ? "true" : "false")
            sub(/"NAME"/, "\"" name "\"")
            print
        }' tests/student/after.txt
}

write() {
    if [ -n "$after" ]; then
        write_after
    else
        sed "s/NAME/$name/g" tests/student/new.c
    fi
}

new=.new.$$ # in the same directory, so that mv only renames
trap 'rm -rf "$new"' EXIT
trap 'exit 1' HUP INT TERM
mkdir "$new" 2>/dev/null && write >"$new/main.c" &&
    echo "$after" >"$new/.new" && mv "$new" "$name" || fail 1 "cannot write $name/main.c"
echo "$name/main.c is your own program: make $name builds it and draws a picture${after:+ with your lesson $after}."
