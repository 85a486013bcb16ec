#!/bin/sh
# Does `make help` list what there is? Each `make NAME` of it is a target that the Makefile, or what
# it includes, calls .PHONY, and each of those is listed, but for a few that are steps on the way.
#
# Exit status 0: both; 1: not, named.

cd "$(dirname "$0")/../.." || exit 1
unset MAKEFLAGS MFLAGS MAKELEVEL STEP # of the make that runs this test
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

make -s help | sed -n 's/^  make \([a-z][a-z-]*\)\( .*\)*$/\1/p' | sort -u >"$work/listed"
sed -n 's/^\.PHONY: //p' Makefile tests/targets.mk tests/*/*.mk | tr ' ' '\n' | grep -v '[$%]' |
    grep -vxE 'all|programs|models|common|tests|force|found|has-mesa' | sort -u >"$work/targets"
comm -23 "$work/listed" "$work/targets" | sed 's/^/help: there is no target /' >"$work/wrong"
comm -13 "$work/listed" "$work/targets" | sed 's/^/help: make help does not list /' >>"$work/wrong"
[ ! -s "$work/wrong" ] || {
    cat "$work/wrong"
    exit 1
}
echo "help: lists all targets"
