#!/bin/sh
# Makes a directory with a program that draws, for a student to change.
#
#     new.sh MAKE NAME          MAKE as in '$(MAKE) -s'
#
# NAME/main.c is new.c with this name in it; `make NAME` finds the directory by the file NAME/.new.
#
# Exit status: 0 done; 1 it cannot be done, and nothing is left behind; 2 wrong usage.

cd "$(dirname "$0")/../.." || exit 1
LC_ALL=C
export LC_ALL
make=$1
name=$2

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

[ -f tests/student/new.c ] ||
    fail 1 "it needs the pipeline, which comes with the hand-outs of lessons 9 and 10"
[ -n "$name" ] || fail 2 "say a name, for example make new NAME=mine"
case $name in
*[!A-Za-z0-9_]*) fail 2 "a name has letters A-Z and a-z, digits and _ only: \"$name\" does not" ;;
esac
case $name in step[0-9]*) fail 2 "$name is a lesson's name: take another one" ;; esac
[ ! -e "$name" ] || fail 1 "$name is here already: take another name"
! is_target "$name" || fail 2 "make $name does something else already: take another name"

new=.new.$$ # in the same directory, so that mv only renames
trap 'rm -rf "$new"' EXIT
trap 'exit 1' HUP INT TERM
mkdir "$new" 2>/dev/null && sed "s/NAME/$name/g" tests/student/new.c >"$new/main.c" &&
    : >"$new/.new" && mv "$new" "$name" || fail 1 "cannot write $name/main.c"
echo "$name/main.c is your own program: make $name builds it and draws a picture that moves."
