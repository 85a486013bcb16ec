#!/bin/sh
# Does `make watch` check and show at every save, and leave nothing behind when it is ended?
. "$(dirname "$0")/../unit/script.sh"

mkdir -p "$work/tests" "$work/step05_zbuffer" && cd "$work" || exit 1
cp -R "$top/tests/student" tests || exit 1
# Instead of make: it says what it is asked to, and whether main.c builds.
cat >fake_make <<'END_OF_MAKE'
#!/bin/sh
echo "make:$MAKEFLAGS: $*"
case $2:$(cat step05_zbuffer/main.c) in check:*wrong*) echo 'step05_zbuffer  BUILD main.c:1: error' ;; esac
END_OF_MAKE
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
says 'make:s -- CC=clang: -s check STEP=step05_zbuffer'
says 'make:s -- CC=clang: -s show STEP=step05_zbuffer SCENE=depth BUILD=some/build'
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
[ "$(grep -c ' show ' said)" -eq 2 ] || wrong "shown though it does not build"
: >files # before find looks
find . -type f | sort >files
kill $running
wait $running || wrong "status $? when it is ended"
running=
find . -type f | sort | diff files - || wrong "files are left behind"
said_by 2 sh tests/student/watch.sh build ./fake_make 7 ''
exit $failed
