#!/bin/sh
# Do the lessons' tables of wrong pictures (WRONG.md), their mistakes.txt and the pictures in figures agree?
#
# Exit status 0: they do; 1: not, named (tests/upkeep/verify/figures.awk).
. "$(dirname "$0")/../../unit/script.sh"

# shellcheck disable=SC2046 # one word a file
awk -f tests/upkeep/verify/figures.awk \
    $(find step[0-9]*_* -name WRONG.md -o -name mistakes.txt | sort) || failed=1
exit $failed
