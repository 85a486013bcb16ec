#!/bin/sh
# Does figures.awk find each wrong title of a living figure, by its file and line, and no right one?
. "$(dirname "$0")/../../unit/script.sh"

program='{"program":"p","scenes":[{"name":"one","width":8,"height":8,"frames":1,"light":[0,0,-1],"values":[{"name":"attempt","help":"0 a, 1 b","least":0,"most":1,"step":1,"value":0},{"name":"end_x","help":"end","least":-2,"most":2,"step":0.5,"value":0}]},{"name":"turn","width":8,"height":8,"frames":9},{"name":"your own","frames":1,"text":"size 9 9\n"}]}'

# judged TITLE: what is said of a figure with this title, in the second line.
judged() {
    printf 'text\n![a picture](figures/a.png "live: %s")\n' "$1" >"$work/README.md"
    printf '%s\n' "$program" | awk -f tests/teacher/site/figures.awk - "$work/README.md" 2>&1 && echo right
}

expect() {
    case $(judged "$1") in
    "$2") ;;
    *) wrong "$1: $(judged "$1")" ;;
    esac
}

line=$work/README.md:2:
expect 'one, attempt=1, show=attempt,light, tell=pixels_wrong' right
expect 'one, end_x=-1.5, at=2,3, show=pixel,points' right
expect 'turn, frame=3, show=frame' right
expect 'your own, text=size 3 3; line 0 0 2 2 9 9 9, show=points' right
expect 'two, show=attempt' "$line the program has no scene \`two\`"
expect 'one, color=1, show=attempt' "$line scene \`one\` has no number \`color\`"
expect 'one, attempt=2, show=attempt' "$line \`attempt\` goes from 0 to 1"
expect 'one, attempt=, show=attempt' "$line \`attempt\` goes from 0 to 1"
expect 'one, text=size 3 3, show=attempt' "$line scene \`one\` has no number \`text\`"
expect 'one, show=camera' "$line scene \`one\` lets nobody change \`camera\`"
expect 'turn, show=points' "$line scene \`turn\` lets nobody change \`points\`"
expect 'one, show=attempt,light,points' "$line show= names one or two things to touch, and here 3"
expect 'one' "$line show= names one or two things to touch, and here 0"
expect 'one, show=pixel' "$line a pixel to touch begins somewhere: at=X,Y"
printf '%s\n' '| ![a](a.png "live: one, show=light") | ![b](b.png "live: two, show=light") |' 'See ![a](a.png "live: one, show=light").' >"$work/README.md"
printf '%s\n' "$program" | awk -f tests/teacher/site/figures.awk - "$work/README.md" 2>"$work/said" && wrong "no line is wrong"
[ "$(sed 's/.*README.md:\([0-9]*\):.*/\1/' "$work/said" | tr '\n' ' ')" = '1 2 ' ] || wrong "$(cat "$work/said")"
exit $failed
