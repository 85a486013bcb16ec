#!/bin/sh
# Takes each lesson's main.c out of a submission into a course, and nothing else.
#
#   take.sh SUBMISSION COURSE
#
# SUBMISSION has step05_zbuffer/main.c, or, when COURSE has one lesson only, main.c alone. Links are
# not followed. It prints a line for each one that is missing; the starter replaces it.
#
# Exit status: 0 done; 1 something cannot be copied.
submission=$1
course=$2

# is_there FILE: a regular file, neither it nor its directory a link.
is_there() {
    [ -f "$1" ] && [ ! -L "$1" ] && [ ! -L "$(dirname "$1")" ]
}

mains=$(cd "$course" && echo step[0-9]*_*/main.c)
for main in $mains; do
    if is_there "$submission/$main"; then
        cp "$submission/$main" "$course/$main" || exit 1
    elif [ "$main" = "$mains" ] && is_there "$submission/main.c"; then
        cp "$submission/main.c" "$course/$main" || exit 1
    else
        echo "There is no $main in the submission."
    fi
done
