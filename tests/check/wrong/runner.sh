#!/bin/sh
# What shuts programs in ends as a shell does: with 128 and the signal's number.
[ -n "$MALLOC_PERTURB_" ] || exit # memory that nobody has written is 0 by luck
"$@"
exit $?
