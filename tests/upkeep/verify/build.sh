#!/bin/sh
# Builds one program, as the check would have it built by make:
#
#     build.sh COMMANDS -s DIRECTORY/STEP        or DIRECTORY/numbers/STEP, which calls its functions
#
# from DIRECTORY/main.c, which stays as it is, and the headers of STEP: once for all checks. (What the
# check asks to be tried meanwhile it asks for again, where it is not there.) COMMANDS has in three
# lines how to compile, how to link, and with what.
program=$3
[ ! -f "$program.kept" ] || exec ln -f "$program.kept" "$program"
compile=$(sed -n 1p "$1")
link=$(sed -n 2p "$1")
libraries=$(sed -n 3p "$1")
step=${program##*/}
place=${program%/*}
number=${step#step}
number=${number%%_*}
compile="$compile -DCOURSE_LESSON=${number#0}"
case $place in
*/numbers)
    source=tests/lessons/$step/numbers.c
    compile="$compile -O0 -w -I. -Itests -DLESSON='\"${place%/numbers}/main.c\"'"
    mkdir -p "$place"
    ;;
*)
    source=$place/main.c
    if [ -f "tests/lessons/$step/trials.c" ]; then
        source=tests/lessons/$step/trials.c
        compile="$compile -iquote . -Itests -DLESSON='\"$place/main.c\"'"
    fi
    ;;
esac
eval "$compile -I'$step' -c '$source' -o '$program.o'" &&
    eval "$link '$program.o' $libraries -o '$program'" && ln -f "$program" "$program.kept"
