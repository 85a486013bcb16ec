#!/bin/sh
# Lines of options answered with frames (common/run/live.h): sizes, pixels, counters, messages, a text
# scene, and that what a program prints does not come between the frames.
. "$(dirname "$0")/../../unit/script.sh"

# answers PROGRAM: to what standard input asks; in $work/answer, without the description.
answers() {
    "$build/moving/$1" --live >"$work/all" 2>"$work/errors" || wrong "$1 fails: $(cat "$work/errors")"
    head -n 1 "$work/all" | grep -q "^{\"program\":\"$1\",.*}$" || wrong "$1 is not described"
    tail -c +$(($(head -n 1 "$work/all" | wc -c) + 1)) "$work/all" >"$work/answer"
}

# has LINE TEXT
has() {
    [ "$(sed -n "$1p" "$work/answer" | tr -d '\000')" = "$2" ] || wrong "line $1 of the answer is not \"$2\""
}

# One pixel of 100x100: red, in the row that is the 59th from the top.
printf '%s\n' '--only pixel' | answers step01_line
head -n 1 "$work/answer" | grep -qx 'frame 100 100 [0-9.]* 0' || wrong "another head"
head=$(head -n 1 "$work/answer" | wc -c)
[ "$(wc -c <"$work/answer")" -eq $((head + 40000)) ] || wrong "another size"
[ "$(od -An -tu1 -j $((head + 4 * (5800 + 52))) -N 8 "$work/answer" | tr -s ' ')" = ' 255 0 0 255 0 0 0 255' ] ||
    wrong "the pixel is elsewhere"

# Each line is answered, also a wrong one, and a text scene between two marks.
printf '%s\n' '--only nothing' '--live' 'model.obj' '--only pixel text' 'line 1 2 3 x 1 1 1' end '' | answers step01_line
has 1 "error --only wants a scene or all: pixel, line, octants, gradient, not 'nothing'"
has 2 'error the model and --live belong on the command line'
has 3 'error the model and --live belong on the command line'
has 4 "error coordinate 'x' is not a whole number"
printf '%s\n' 'text' 'size 3 2' 'line 0 0 2 0 9 8 7' end | answers step01_line
[ "$(tail -c 24 "$work/answer" | od -An -tu1 | tr -s ' \n' ' ')" = \
    ' 0 0 0 255 0 0 0 255 0 0 0 255 9 8 7 255 9 8 7 255 9 8 7 255 ' ] || wrong "not the lowest row of three"

# Counters, as --stats prints them; light, size and a frame of an animation are the options' own.
printf '%s\n' '--only zbuffer -s 8x8 --stats' | answers step05_zbuffer
head -n 1 "$work/answer" | grep -qx 'frame 8 8 [0-9.]* 3' || wrong "not three counters"
"$build/step05_zbuffer" --only zbuffer -s 8x8 --stats -o "$work" | sed -n 's/zbuffer\.//; s/: / /; 1,3p' >"$work/stats"
sed -n 2,4p "$work/answer" | cmp -s - "$work/stats" || wrong "other counters than --stats"

# Numbers of a scene: in the description, and chosen, within their range.
printf '%s\n' '--only zbuffer --set faces=0 --stats' '--set faces=2' '--set corners=1' | answers step05_zbuffer
head -n 1 "$work/all" | grep -qF '"values":[{"name":"faces","help":"share of the faces that are drawn","least":0,"most":1,' ||
    wrong "no values in the description"
sed -n 4p "$work/answer" | grep -qx 'pixels_written 0' || wrong "faces are drawn"
[ "$(grep -ac "^error --set wants NAME=N, a scene's number: faces of zbuffer, 0 to 1 (1), not" "$work/answer")" -eq 2 ] ||
    [ "$(tail -n 2 "$work/answer" | grep -ac 'error --set wants')" -eq 2 ] || wrong "numbers out of range are taken"

# A text scene's numbers, the text that one begins with, and what is said about a pixel.
printf '%s\n' '--set attempt=1 --set wrong=1 --probe 1,0 --stats text' 'size 3 2' 'line 0 0 2 1 9 8 7' end \
    '--probe 1,x' '--probe 16384,0' | answers step01_line
grep -aqF '{"name":"your own","frames":1,"text":"size 100 100\nline 13' "$work/all" || wrong "no text to begin with"
has 2 'pixels_wrong 0'
has 3 'pixels_missing 1'
has 4 ' at x = 1 the line is at y = 0 + 1 * 1/2 = 0.500, error -0.500'
[ "$(grep -ac 'error --probe wants a pixel X,Y, not' "$work/answer")" -eq 2 ] || wrong "any pixel is taken"
exit $failed
