#!/bin/sh
# Can a program be run while another make links it? Two `make check` at once do that, and a file that
# is being written cannot be run.
. "$(dirname "$0")/../unit/script.sh"

mkdir -p "$work/step01_line" "$work/common" "$work/tests/check" && cd "$work" || exit 1
cp "$top/Makefile" . && cp "$top/tests/check/check.mk" tests/check && : >step01_line/README.md || exit 1
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
    said_by 0 make -s CC=./compiler MARCH= CHECKER_FILES=common/nothing.c build/$program
    source=$(find . -name "main.c" -path "*$program*" -o -name "$program.c")
    sed 's/first/second/' "$source" >new && cp new "$source"
    rm -f linking
    : >slow
    make -s CC=./compiler MARCH= CHECKER_FILES=common/nothing.c build/$program >"$said" 2>&1 &
    running=$!
    tries=0
    while [ ! -f linking ] && [ $tries -lt 20 ]; do
        sleep 1
        tries=$((tries + 1))
    done
    printed=$(build/$program 2>&1)
    [ "$printed" = first ] || wrong "$program while it is linked"
    wait $running
    running=
    rm slow
    printed=$(build/$program 2>&1)
    [ "$printed" = second ] || wrong "$program when it is linked"
done
[ "$(find build -name '*.[0-9]*')" = "" ] || wrong "left behind: $(ls build)"
exit $failed
