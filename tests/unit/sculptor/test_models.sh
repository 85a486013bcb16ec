#!/bin/sh
# The sculptor makes the same models, byte by byte, with every compiler and on every machine. After a
# change of a model that is meant, look at it, and let cksum fill models.txt.
. "$(dirname "$0")/../script.sh"

sums=$top/tests/unit/sculptor/models.txt
cd "$build/models" || exit 1
# shellcheck disable=SC2046 # one word a file
cksum $(cut -d " " -f 3 "$sums") >"$work/sums"
said_by 0 diff "$sums" "$work/sums"
exit $failed
