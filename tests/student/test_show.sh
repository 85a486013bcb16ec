#!/bin/sh
# Does `make show` show the pictures that are asked for, in a size that fits?
. "$(dirname "$0")/../unit/script.sh"
unset NO_COLOR WT_SESSION
export COLORTERM=truecolor TERM=xterm
cd "$work" || exit 1

# tga FILE WIDTH HEIGHT BYTE: a grey picture; sizes below 256, bytes in octal.
tga() {
    {
        # shellcheck disable=SC2059 # octal numbers made here
        printf "\\0\\0\\3\\0\\0\\0\\0\\0\\0\\0\\0\\0\\$(printf %o "$2")\\0\\$(printf %o "$3")\\0\\10\\0"
        i=0
        while [ $i -lt $(($2 * $3)) ]; do
            # shellcheck disable=SC2059
            printf "\\$4"
            i=$((i + 1))
        done
    } >"$1"
}

# show STATUS COLUMNS LINES WHICH YOURS REFERENCE: of no scene, or the one of `scene`.
scene='step01_line none'
show() {
    # shellcheck disable=SC2086 # three words
    said_by "$1" "$build/show" "$2" "$3" $scene "$4" blocks "$5" "$6"
}

# size WIDTH HEIGHT: so many half blocks below title and names, so many lines that have some.
size() {
    width=$(sed -n 3p "$said" | awk '{ print gsub(/\342\226\200/, "") }')
    height=$(grep -c "$(printf '\342\226\200')" "$said")
    [ "$width $height" = "$1 $2" ] || wrong "$width x $height characters, not $1 x $2"
}

tga white.tga 10 10 377
tga grey.tga 10 10 100
tga wide.tga 200 4 377

show 0 40 25 '' white.tga none.tga # 4 times as large: 5 would be too high
size 40 20
says '38;2;255;255;255m'
show 0 29 100 '' white.tga none.tga # twice as large, as whole numbers go
size 20 10
show 0 50 25 '' wide.tga none.tga # a quarter
size 50 1
# One red pixel on black: as red when the picture is shrunk.
{
    printf '\0\0\2\0\0\0\0\0\0\0\0\0\144\0\144\0\30\0'
    head -c 15000 /dev/zero
    printf '\0\0\377'
    head -c 14997 /dev/zero
} >point.tga
show 0 40 25 '' point.tga none.tga
size 40 20
says ';2;255;0;0m'
# Where a few pixels of it are wrong, its part around the first of them is shown.
{
    printf '\0\0\2\0\0\0\0\0\0\0\0\0\144\0\144\0\30\0'
    head -c 30000 /dev/zero
} >black.tga
show 0 80 25 '' point.tga black.tga # one below the other
says 'Only x 0 to 79, y 30 to 69: (0,50) is the first wrong pixel.'
says 'WHICH=yours,reference,difference shows all of them.'
[ "$(sed -n '12p; 33p' "$said" | grep -o ';2;255;0;0m' | wc -l)" -eq 2 ] || wrong "not in yours and in the difference"
show 0 154 25 '' point.tga black.tga # 50 columns each, the reference as well
says 'Only x 0 to 49, y 30 to 69: (0,50) is the first wrong pixel.'
says 'WHICH=yours,reference,difference shows all of them.'
show 0 80 25 yours point.tga black.tga
silent 'Only x'
silent 'WHICH='
show 0 80 25 '' point.tga point.tga
silent 'Only x'
show 0 320 55 '' point.tga black.tga # all of it has room
silent 'Only x'
silent 'WHICH='
tga white100.tga 100 100 377
show 0 80 25 '' white100.tga black.tga # all is wrong: a part says less than the whole
silent 'Only x'
show 0 10 1 '' white.tga none.tga # one line at least
size 2 1
show 0 154 15 '' white.tga grey.tga # side by side: 20 + 2 + 20 + 2 + 20
size 64 10
[ "$(sed -n 2p "$said")" = "yours                 reference             difference" ] ||
    wrong "not side by side"
says '38;2;64;64;64m'  # the reference
says '38;2;255;0;0m'   # the difference: another colour
silent 'WHICH='
show 0 153 15 '' white.tga grey.tga # no room for three
size 42 10
[ "$(sed -n 2p "$said")" = "yours                 difference" ] || wrong "not these two"
says 'WHICH=yours,reference,difference shows all of them.'
show 0 102 15 '' white.tga white.tga # the reference, where there is no difference
[ "$(sed -n 2p "$said")" = "yours                 reference" ] || wrong "not these two"
silent 'WHICH='
show 0 80 24 '' white.tga grey.tga # the usual terminal: one below the other
[ "$(grep -x -e yours -e reference -e difference "$said" | xargs)" = 'yours difference' ] ||
    wrong "not these two, one below the other"
says 'WHICH=yours,reference,difference shows all of them.'
show 0 101 10 reference,yours white.tga grey.tga # one below the other
[ "$(grep -cx -e yours -e reference "$said")" -eq 2 ] || wrong "not one below the other"
show 0 94 15 reference none.tga grey.tga
size 20 10

# ---- The title ----

title() { # TEXT YOURS REFERENCE
    show 0 80 24 '' "$2" "$3"
    [ "$(head -n 1 "$said")" = "step01_line none$1" ] || wrong "the title is not '$1'"
}
title '' white.tga none.tga
title ': exact' white.tga white.tga
title ': 1 pixel differs, the first wrong one at (0,50)' point.tga black.tga
title ': 100 pixels differ, the first wrong one at (0,0)' white.tga grey.tga
title ': 10x10 pixels, not 200x4' white.tga wide.tga
show 0 80 24 difference white.tga white.tga # is only said
[ "$(cat "$said")" = 'step01_line none: exact' ] || wrong "more than that it is exact"

# ---- Colours ----

# colors FOUND NAME=VALUE...: in the first line of blocks or characters of a red picture.
printf '\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\30\0\0\0\377' >red.tga
colors() {
    found=$1
    shift
    said_by 0 env -u COLORTERM "$@" "$build/show" 1 9 step01_line none '' blocks red.tga none.tga
    [ "$(sed -n 3p "$said" | tr -d '\033')" = "$found" ] || wrong "$* gives not $found"
}
half=$(printf '\342\226\200')
colors "[38;2;255;0;0m[48;2;0;0;0m$half[0m" COLORTERM=24bit
colors "[38;2;255;0;0m[48;2;0;0;0m$half[0m" TERM=xterm-direct
colors "[38;2;255;0;0m[48;2;0;0;0m$half[0m" WT_SESSION=1
colors "[38;5;196m[48;5;16m$half[0m" TERM=xterm-256color
colors "[38;5;196m[48;5;16m$half[0m" TERM=foot
colors "[91m[40m$half[0m" TERM=linux
colors "[91m[40m$half[0m" TERM=
colors '@' TERM=dumb
colors '@' TERM=vt220
colors '@' NO_COLOR=1 COLORTERM=truecolor
colors "[38;2;255;0;0m[48;2;0;0;0m$half[0m" NO_COLOR= COLORTERM=truecolor

# A level less counts where the scene must be exact.
tga near.tga 10 10 376
show 0 80 24 difference white.tga near.tga
says '38;2;0;96;0m'
cd "$top" || exit 1
scene='step01_line line'
show 0 80 24 difference "$work/white.tga" "$work/near.tga"
cd "$work" || exit 1
says '38;2;255;0;0m'

show 1 80 24 '' none.tga none.png
says 'show: no such picture: none.tga, none.png'
echo no picture >bad.tga
show 1 80 24 '' bad.tga white.tga
says 'bad.tga: '
for size in '0 24' '80 x' '2001 24' '80'; do
    # shellcheck disable=SC2086 # three words
    show 2 $size '' white.tga grey.tga
done
show 2 80 24 yours,mine white.tga grey.tga

# ---- A program that hangs or crashes ----

# Instead of a lesson's program: a scene a line of `draws`, as a command that draws it or does not.
mkdir -p course/tests/check course/step05_zbuffer course/build/models course/build/quick || exit 1
cp -R "$top/tests/student" course/tests || exit 1
cp "$build/show" course/build && cp grey.tga course && cd course || exit 1
printf 'step05_zbuffer %s\n' first bad last >tests/check/scenes.txt
cat >build/quick/step05_zbuffer <<'EOF'
#!/bin/sh
[ "$1 $2" = '-o build/out/step05_zbuffer' ] || exit 2
for scene in first bad last; do
    if [ "$3 $4" = '--only all' ] || [ "$3 $4" = "--only $scene" ]; then
        if [ $scene = bad ]; then eval "$(cat bad)"; fi
        cp grey.tga "$2/$scene.tga"
    fi
done
EOF
chmod +x build/quick/step05_zbuffer

# draws BAD STATUS SCENE...: BAD is what the program does for `bad`.
draws() {
    echo "$1" >bad
    touch build/quick/step05_zbuffer
    touch build/models/bust.obj
    sleep 1 # a file system may count seconds
    said_by "$2" env CHECK_TIMEOUT=1 sh tests/student/show.sh build 5 "$3" yours blocks
    shift 3
    [ "$(grep -o '^step05_zbuffer [a-z]*$' "$said" | cut -d ' ' -f 2 | xargs)" = "$*" ] ||
        wrong "not $*"
}

draws : 0 '' first bad last
draws 'kill -SEGV $$' 0 '' first
says 'make show: step05_zbuffer crashed: SIGSEGV'
draws 'kill -SEGV $$' 0 last last
draws 'kill -SEGV $$' 1 bad
says 'step05_zbuffer has not drawn bad'
draws 'while :; do :; done' 0 '' first
says 'make show: step05_zbuffer was stopped after 1 s'
draws 'exit 3' 0 '' first
says 'make show: step05_zbuffer ended with status 3'
draws 'exit 3' 2 none
says 'there is no scene "none" in step05_zbuffer. There are: first bad last'
cd "$work" || exit 1

# ---- make show ----

make_show() { # STATUS ARGUMENT...
    status=$1
    shift
    said_by "$status" make -s show BUILD="$build" KIND=blocks "$@"
}

cd "$top" || exit 1
make_show 0 STEP=01 SCENE=line WHICH=yours
says 'step01_line line'
[ "$(grep -c '^step01_line' "$said")" -eq 1 ] || wrong "more than the scene that was asked for"
make_show 0 STEP=1 WHICH=yours
[ "$(grep -c '^step01_line' "$said")" -gt 1 ] || wrong "not all scenes"
make_show 1 STEP=01 SCENE=lines
says 'make show: there is no scene "lines" in step01_line. There are: '
make_show 1 STEP=77
says 'make show: there is no step "77"'
make_show 1 STEP=01 WHICH=mine
says 'show: WHICH=mine is none of yours,reference,difference'
make_show 1 STEP=01 WHICH=yours KIND=paper
says 'show: KIND=paper is none of blocks, kitty'

# A terminal of 50 lines and 160 columns is filled; one that does not know its size is taken for 24
# lines of 80, and shows one picture below the other.
if script -qec true /dev/null >/dev/null 2>&1; then
    for size in '50 160 46' '0 0 41'; do
        # shellcheck disable=SC2086 # three words
        set -- $size
        script -qec "stty rows $1 cols $2; sh tests/student/show.sh '$build' 5 zbuffer '' blocks" /dev/null >"$work/filled"
        lines=$(grep -c . "$work/filled")
        [ "$lines" -ge $((${3} - 4)) ] && [ "$lines" -le "$3" ] || wrong "$lines lines where the terminal has $1"
    done
fi

exit $failed
