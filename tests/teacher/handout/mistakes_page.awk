# The page of a lesson's mistakes, which needs nothing but the pictures next to it.
#
#   awk -v lesson=step05_zbuffer -v work=WORK -v page=DIR -f mistakes_page.awk WORK/table
#
# WORK has what draw.sh keeps of each mistake; the pictures are DIR/mistakes/NAME.png and
# DIR/reference/SCENE.png.

function escaped(text) {
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    return text
}

function lines_of(path,    line, text) {
    text = ""
    while ((getline line <path) > 0) text = text escaped(line) "\n"
    close(path)
    return text
}

# Small pictures are shown enlarged, pixel by pixel. The width is in a PNG at byte 16.
function kind_of(picture,    command, byte) {
    command = "od -An -tu1 -j16 -N4 '" picture "'"
    command | getline byte
    close(command)
    split(byte, digit, " ")
    return digit[3] * 256 + digit[4] < 400 ? "small" : "large"
}

function print_picture(path, caption) {
    printf "<figure><a href=\"%s\"><img class=\"%s\" src=\"%s\" alt=\"\" loading=\"lazy\"></a>" \
           "<figcaption>%s</figcaption></figure>\n", path, kind_of(page "/" path), path, caption
}

# The first thing that is wrong in what the check says. What it takes the picture for is a line
# there.
function finding(said,    part, count, i) {
    sub(/\n$/, "", said)
    named = said ~ /;   looks like "/
    count = split(said, part, "; ")
    for (i = 2; i < count && part[i] !~ / (FAIL|TIME|CRASH|BUILD|ERROR) [0-9]/; i++);
    return count > 1 ? part[i] : part[1]
}

function is_there(path,    line, there) {
    there = (getline line <path) > 0
    close(path)
    return there
}

BEGIN {
    FS = "\t"
    getline title <(lesson "/README.md")
    sub(/^# /, "", title)
    title = escaped(title)
    print "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">"
    print "<meta name=\"viewport\" content=\"width=device-width\">"
    print "<title>Mistakes: " title "</title>\n<style>"
    print ":root { color-scheme: light dark }"
    print "body { font-family: sans-serif; max-width: 52em; margin: 1em auto; padding: 0 1em }"
    print "article { border-top: 1px solid gray }"
    print ".pictures { display: flex; flex-wrap: wrap; gap: 1em }"
    print "figure { margin: 0; flex: 0 1 24em; min-width: 10em }"
    print "img { width: 100%; height: auto } .small { image-rendering: pixelated }"
    print "pre { overflow-x: auto; border-left: 3px solid gray; padding-left: 1em }"
    print "</style>\n</head>\n<body>\n<h1>" title ": mistakes</h1>"
    print "<p>What students write wrong, each as a change of the solution, and what it draws in the"
    print "scene that shows it. A click on a picture opens it alone.</p>"
}

$2 == lesson && $3 == "mistake" {
    said = finding(lines_of(work "/" $1 ".said"))
    print "<article id=\"" $4 "\">\n<h2>" $4 "</h2>"
    print "<p>" escaped($9) ($8 == "-" ? "" : " (task " $8 ")") "</p>"
    print "<div class=\"pictures\">"
    mistaken = "mistakes/" $4 ".png"
    if (is_there(page "/" mistaken)) print_picture(mistaken, "this mistake, scene " $5)
    else print "<p>It leaves no wrong picture.</p>"
    if ($5 != "numbers") print_picture("reference/" $5 ".png", "the reference")
    print "</div>\n<p>The check: <code>" said "</code>" \
        (named ? ", and it knows the mistake" : "") ".</p>"
    if ($6 != "-") print "<p>Built with CC=" escaped($6) "</p>"
    if ($7 != "-") print "<p>Built with CFLAGS=" escaped($7) "</p>"
    print "<pre>" lines_of(work "/" $1 ".diff") "</pre>\n</article>"
}

END { print "</body>\n</html>" }
