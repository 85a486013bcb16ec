#!/bin/sh
# Does `make watch` check and show at every save, and leave nothing behind when it is ended?
#
# Exit status 0: all of that is so; 1: something is not.

top=$(cd "$(dirname "$0")/../.." && pwd) || exit 1
work=$(mktemp -d) || exit 1
watching=
trap '[ -z "$watching" ] || kill $watching 2>/dev/null; rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
failed=0

wrong() {
    echo "watch: $*"
    sed 's/^/    /' said
    failed=1
}

mkdir -p "$work/tests" "$work/step05_zbuffer" && cd "$work" || exit 1
cp -R "$top/tests/starter" "$top/tests/help" tests || exit 1
# In place of make: it says what it is told to, and whether main.c builds.
cat >fake_make <<'EOF'
#!/bin/sh
echo "make:$MAKEFLAGS: $*"
case $2:$(cat step05_zbuffer/main.c) in check:*wrong*) echo 'step05_zbuffer  BUILD main.c:1: error' ;; esac
EOF
chmod +x fake_make
echo 'int a;' >step05_zbuffer/main.c
: >said

# lines COUNT: waits until so many saves were worked off, 10 s at most.
lines() {
    tries=0
    while [ "$(grep -c '^Waiting' said)" -lt "$1" ] && [ $tries -lt 10 ]; do
        sleep 1
        tries=$((tries + 1))
    done
    [ "$(grep -c '^Waiting' said)" -eq "$1" ] || wrong "$2"
}

MAKEFLAGS='s -j2 --jobserver-auth=3,4 -- CC=clang' \
    tests/student/watch.sh some/build "./fake_make -s" 5 depth >said 2>&1 &
watching=$!
lines 1 "not checked at the beginning"
grep -qx 'make:s -- CC=clang: -s check STEP=step05_zbuffer' said || wrong "no check, or not so"
grep -qx 'make:s -- CC=clang: -s show STEP=step05_zbuffer SCENE=depth BUILD=some/build' said ||
    wrong "not shown, or not so"
touch step05_zbuffer/main.c
sleep 2
lines 1 "checked though nothing was saved"
echo 'int b;' >step05_zbuffer/scenes.h
lines 2 "a second file that was saved is not seen"
rm step05_zbuffer/main.c # as an editor may, before it writes the new one
sleep 2
lines 2 "checked without a main.c"
echo 'wrong' >step05_zbuffer/main.c
lines 3 "a save is not seen"
[ "$(grep -c ' show ' said)" -eq 2 ] || wrong "shown though it does not build"
: >files # before find looks
find . -type f | sort >files
kill $watching
wait $watching
status=$?
watching=
[ $status -eq 0 ] || wrong "status $status when it is ended"
find . -type f | sort | diff files - || wrong "files are left behind"

tests/student/watch.sh build ./fake_make 7 '' >said 2>&1
status=$?
[ $status -eq 2 ] || wrong "status $status for an unknown step"

exit $failed
