#!/bin/sh
# Does `make help` list what there is? Each `make NAME` of it is a target that the Makefile, or what
# it includes, calls .PHONY, and each of those is listed, except for a few that are steps on the way.
# (`make mine` is one after `make new NAME=mine`.)
. "$(dirname "$0")/../unit/script.sh"

make -s help | sed -n 's/^  make \([a-z][a-z-]*\)\( .*\)*$/\1/p' | grep -vx mine | sort -u >"$work/listed"
sed -e :a -e '/\\$/{N;s/\\\n//;ba' -e '}' Makefile tests/*/*.mk | sed -n 's/^\.PHONY: //p' | tr ' ' '\n' | grep -v '[$%]' |
    grep -vxE 'all|programs|models|common|tests|force|commands|tools|marked' | sort -u >"$work/targets"
for target in $(comm -23 "$work/listed" "$work/targets"); do
    wrong "there is no target $target"
done
for target in $(comm -13 "$work/listed" "$work/targets"); do
    wrong "make help does not list $target"
done
exit $failed
