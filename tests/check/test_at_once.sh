#!/bin/sh
# Can a program be run while another make links it? Two `make check` at once do that, and a file that
# is being written cannot be run.
#
# Exit status 0: it can; 1: it cannot.

top=$(cd "$(dirname "$0")/../.." && pwd) || exit 1
work=$(mktemp -d) || exit 1
linking=
trap '[ -z "$linking" ] || wait $linking; rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
unset MAKEFLAGS MFLAGS MAKELEVEL STEP BUILD CFLAGS MARCH # of the make that runs this test
failed=0

mkdir -p "$work/step01_line" "$work/common" "$work/tests/check" && cd "$work" || exit 1
cp "$top/Makefile" . || exit 1
echo 'extern int nothing;' >common/nothing.c
printf '#include <stdio.h>\nint main(void) {\n    puts("first");\n}\n' >step01_line/main.c
cp step01_line/main.c tests/check/check.c

# A compiler that takes its time: while `slow` is there it holds what it links open for 2 s.
cat >compiler <<'EOF'
#!/bin/sh
for word; do
    case $before in -o) out=$word ;; esac
    before=$word
done
case " $* " in
*' -c '* | *probe*) ;;
*)
    if [ -f slow ]; then
        : >linking
        exec 3>>"$out"
        sleep 2
        exec 3>&-
    fi
    ;;
esac
exec cc "$@"
EOF
chmod +x compiler

for program in step01_line check; do
    make -s CC=./compiler MARCH= CHECKER= build/$program >log 2>&1 || { cat log; exit 1; }
    source=$(find . -name "main.c" -path "*$program*" -o -name "$program.c")
    sed 's/first/second/' "$source" >new && cp new "$source"
    rm -f linking
    : >slow
    make -s CC=./compiler MARCH= CHECKER= build/$program >log 2>&1 &
    linking=$!
    tries=0
    while [ ! -f linking ] && [ $tries -lt 20 ]; do
        sleep 1
        tries=$((tries + 1))
    done
    said=$(build/$program 2>&1)
    [ "$said" = first ] || { echo "at_once: $program while it is linked: $said"; failed=1; }
    wait $linking
    linking=
    rm slow
    said=$(build/$program 2>&1)
    [ "$said" = second ] || { echo "at_once: $program when it is linked: $said"; failed=1; }
done
[ "$(find build -name '*.[0-9]*')" = "" ] || { echo "at_once: left behind: $(ls build)"; failed=1; }
exit $failed
