#!/bin/sh
# What shuts programs in ends as a shell does: with 128 and the signal's number.
"$@"
exit $?
