#!/bin/sh
# Does `make watch` show and check at every save, and leave nothing behind when it is ended?
. "$(dirname "$0")/../unit/script.sh"

mkdir -p "$work/tests" "$work/step05_zbuffer" && cd "$work" || exit 1
cp -R "$top/tests/student" tests || exit 1
# Instead of make: it says what it is asked to, and builds main.c where that is not wrong.
mkdir -p some/build/quick
cat >fake_make <<'END_OF_MAKE'
#!/bin/sh
echo "make:$MAKEFLAGS: $*" >>asked
case $2 in
check) echo 'It is checked.' ;;
*) grep -q wrong step05_zbuffer/main.c && echo 'It does not build.' >&2 && exit 1 ;;
esac
[ ! -t 1 ] || echo 'The check sees a terminal.'
echo ': >"$2/depth.tga"' >some/build/quick/step05_zbuffer
echo 'echo "shown: $4"' >some/build/show
chmod +x some/build/show some/build/quick/step05_zbuffer
END_OF_MAKE
: >asked
chmod +x fake_make
echo 'int a;' >step05_zbuffer/main.c
said=said
: >said

# waits COUNT WORDS: within 10 s so many saves are worked off.
waits() {
    tries=0
    while [ "$(grep -c '^Waiting' said)" -lt "$1" ] && [ $tries -lt 10 ]; do
        sleep 1
        tries=$((tries + 1))
    done
    [ "$(grep -c '^Waiting' said)" -eq "$1" ] || wrong "$2"
}

MAKEFLAGS='s -j2 --jobserver-auth=3,4 -- CC=clang' \
    sh tests/student/watch.sh some/build "./fake_make -s" 5 depth >said 2>&1 &
running=$!
waits 1 "not checked at the beginning"
grep -qx 'make:s -- CC=clang: -s some/build/quick/step05_zbuffer .* BUILD=some/build' asked || wrong "not built"
grep -qx 'make:s -- CC=clang: -s check STEP=step05_zbuffer BUILD=some/build' asked || wrong "not checked"
[ "$(xargs <said)" = 'shown: depth It is checked. Waiting for the next save of step05_zbuffer; Ctrl-C ends.' ] ||
    wrong "it says something else"
touch step05_zbuffer/main.c
sleep 2
waits 1 "checked though nothing was saved"
echo 'int b;' >step05_zbuffer/scenes.h
waits 2 "a second file that was saved is not seen"
rm step05_zbuffer/main.c # as an editor may, before it writes the new one
sleep 2
waits 2 "checked without a main.c"
echo 'wrong' >step05_zbuffer/main.c
waits 3 "a save is not seen"
[ "$(grep -c shown: said)" -eq 2 ] || wrong "shown though it does not build"
silent 'It does not build.' # the check says that
echo 'int c;' >step05_zbuffer/main.c
waits 4 "a save that repairs it is not seen"
[ "$(grep -c shown: said)" -eq 3 ] || wrong "not shown though it builds again"
: >files # before find looks
find . -type f | sort >files
kill $running
wait $running || wrong "status $? when it is ended"
running=
find . -type f | sort | diff files - || wrong "files are left behind"
said_by 2 sh tests/student/watch.sh build ./fake_make 7 ''

# At a terminal it says what `make check` says there.
if script -qec true /dev/null >/dev/null 2>&1; then
    said=typed
    timeout -s INT 5 script -qec "sh tests/student/watch.sh some/build './fake_make -s' 5 ''" /dev/null >typed 2>&1
    says 'The check sees a terminal.'
fi
exit $failed
