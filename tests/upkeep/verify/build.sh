#!/bin/sh
# Builds one program, as the check would have it built by make:
#
#     build.sh COMMANDS -s DIRECTORY/STEP
#
# from DIRECTORY/main.c and the headers of STEP. COMMANDS has in three lines how to compile, how to
# link, and with what.
program=$3
compile=$(sed -n 1p "$1")
link=$(sed -n 2p "$1")
libraries=$(sed -n 3p "$1")
eval "$compile -I'${program##*/}' -c '${program%/*}/main.c' -o '$program.o'" &&
    eval "$link '$program.o' $libraries -o '$program'"
