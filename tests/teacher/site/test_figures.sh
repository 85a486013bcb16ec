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

# Words that belong to a figure: judged_words BEFORE AFTER, in the first line and in the third.
figure='one, attempt=1, end_x=1, at=2,3, show=pixel,points, tell=E'
judged_words() {
    printf '%s\n![a picture](figures/a.png "live: %s")\n%s\n' "$1" "$figure" "$2" >"$work/README.md"
    printf '%s\n' "$program" | awk -f tests/teacher/site/figures.awk - "$work/README.md" 2>&1 && echo right
}

expect_words() {
    [ "$(judged_words "$1" "$2")" = "$3" ] || wrong "$1, $2: $(judged_words "$1" "$2")"
}

third=$work/README.md:3:
expect_words 'with <!-- below: end_x -->1<!-- / -->,' 'and <!-- above: attempt=0 at=4,4 -->none<!-- / -->' right
expect_words 'a <!-- below: @end -->b<!-- / -->' 'a <!-- above: @E0 @pixel @2,3 @end-pixel -->b<!-- / -->' right
expect_words '' '```c above: 1=@E 2=@end' right
expect_words '' 'a <!-- above: end_x -->2<!-- / -->' "$third \`end_x\` is 1 in the figure, and here 2"
expect_words '' 'a <!-- above: start_x -->2<!-- / -->' "$third the figure's scene \`one\` has no \`start_x\` that can be 2"
expect_words '' 'a <!-- above: end_x=3 -->b<!-- / -->' "$third the figure's scene \`one\` has no \`end_x\` that can be 3"
expect_words '' 'a <!-- above: @start -->b<!-- / -->' "$third the figure has no part \`start\`"
expect_words '' '```c above: 1=@start' "$third the figure has no part \`start\`"
expect_words '' 'a <!-- above: end_x -->1' "$third the words of a figure end on their line, by <!-- / -->"
expect_words '' 'a <!-- below: end_x -->1<!-- / -->' "$third no figure comes below"
expect_words 'a <!-- above: end_x -->1<!-- / -->' '' "$work/README.md:1: no figure is above"
expect_words '' '<!-- above: @end -->b<!-- / -->' "$third a remark at the start of a line ends the paragraph on GitHub"

printf '%s\n' '| ![a](a.png "live: one, show=light") | ![b](b.png "live: two, show=light") |' 'See ![a](a.png "live: one, show=light").' >"$work/README.md"
printf '%s\n' "$program" | awk -f tests/teacher/site/figures.awk - "$work/README.md" 2>"$work/said" && wrong "no line is wrong"
[ "$(sed 's/.*README.md:\([0-9]*\):.*/\1/' "$work/said" | tr '\n' ' ')" = '1 2 ' ] || wrong "$(cat "$work/said")"
exit $failed
