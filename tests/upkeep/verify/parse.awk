# Reads the lists of mistakes and of correct programs; prints a line for each entry and writes its
# main.c.
#
#   awk -v directory=DIR -v only=PATTERN -f replace.awk -f parse.awk LIST.txt...
#
# stepNN_name/mistakes.txt has paragraphs like this one (tests/upkeep/verify/replace.awk says how a text of main.c
# is replaced):
#
#   mistake least_positive
#   says depth cleared to the smallest positive float
#   scene zbuffer
#   - double far = INFINITY, near = -INFINITY;
#   + double far = INFINITY, near = DBL_MIN;
#
# `scene` names the scene of tests/check/scenes.txt that must show it, or `numbers`. The task that is at fault is
# that of the marks around the changed text; a line `task 2a.3` names another one.
#
#   figure 4
#
# names the row of the table in stepNN_name/WRONG.md that it belongs to. The
# first one with that figure gives its picture: of its scene, the part around everything wrong, or
# another part: `figure 4 60x40+10+20` is 60 pixels wide and 40 high, from (10,20) on.
#
# tests/lessons/stepNN_name/alternatives.txt has programs that are correct, `accept NAME`: all scenes must pass, so it
# names none. Both may have
#
#   build CC=clang         another compiler
#   build CFLAGS=-O3       other flags; without the line as entry.sh says
#
# and where one of them is, nothing need be replaced.
#
# Prints, with tabs between: number, lesson, mistake or accept, name, scene, compiler, flags, task,
# what it says, the figure (0 for none), and of who gives its picture the part (`auto`, where none
# is named); - where there is nothing. DIR/NUMBER/main.c is its source.

# Is the scene one of the lesson's?
function is_scene(lesson, scene,    line, part) {
    if (!scenes_read++) {
        while ((getline line < "tests/check/scenes.txt") > 0) {
            split(line, part)
            scenes[part[1] == "call" ? part[2] "/numbers" : part[1] "/" part[2]] = 1
        }
    }
    return (lesson "/" scene) in scenes
}

# step05_zbuffer, of step05_zbuffer/mistakes.txt or tests/lessons/step05_zbuffer/alternatives.txt.
function find_lesson(    lesson) {
    lesson = path
    sub(/\/[a-z]*\.txt$/, "", lesson)
    sub(/.*\//, "", lesson)
    return lesson
}

# The task of the marks around the first changed text that has some, or -.
function task_of(source,    i, before, part) {
    for (i = 1; i <= changes; i++) {
        before = substr(source, 1, index(source, old[i]) + length(old[i]))
        sub(/.*END SOLUTION/, "", before)
        if (sub(/.*BEGIN SOLUTION /, "", before)) {
            split(before, part, " ")
            return part[1]
        }
    }
    return "-"
}

function write_source(text,    place) {
    place = directory "/" count
    system("mkdir '" place "'")
    printf "%s", text > (place "/main.c")
    close(place "/main.c")
}

function check_entry() {
    if (seen[lesson "/" name]++) {
        wrong(begin, "a second " name)
    }
    if (says == "") {
        wrong(begin, name ": no line `says ...`")
    }
    if (kind == "accept" && scene != "-") {
        wrong(begin, name ": a correct program is correct in all scenes")
    } else if (kind == "mistake" && !is_scene(lesson, scene)) {
        wrong(begin, name ": no scene of " lesson ": " scene)
    }
    if (changes == 0 && compiler == "-" && flags == "-") {
        wrong(begin, name ": changes nothing")
    }
    if (kind == "accept" && figure > 0) {
        wrong(begin, name ": a correct program has no figure")
    }
}

# Only one mistake gives the picture of a figure.
function check_figure() {
    if (figure > 0 && !shown[lesson "/" figure]++) {
        part = part == "-" ? "auto" : part
    } else if (part != "-") {
        wrong(begin, name ": the picture of figure " figure " is that of a mistake before it")
    }
}

# The entry that began at `begin` is complete.
function finish(    text) {
    if (name == "") {
        return
    }
    check_entry()
    check_figure()
    text = changed_text(lesson "/main.c", name)
    if (task == "-" && kind == "mistake") {
        task = task_of(source_text(lesson "/main.c"))
    }
    if (index(name, only) > 0) {
        count++
        write_source(text)
        printf "%d\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%d\t%s\n", \
            count, lesson, kind, name, scene, compiler, flags, task, says, figure, part
    }
    name = ""
}

function begin_list() {
    lesson = find_lesson()
    if (source_text(lesson "/main.c") == "") {
        wrong(1, "there is no lesson for " path)
    }
    name = ""
}

/^(mistake|accept) [a-z0-9_]+$/ {
    finish()
    kind = $1
    name = $2
    says = ""
    scene = task = compiler = flags = part = "-"
    figure = 0
    begin_changes()
    if ((kind == "mistake") != (path ~ /\/mistakes\.txt$/)) {
        wrong(FNR, "mistakes are in stepNN_name/mistakes.txt, correct programs in alternatives.txt")
    }
    next
}
name == "" { wrong(FNR, "this is in no paragraph of a mistake: " $0); next }
/^says ./ { says = substr($0, 6); next }
/^scene ./ { scene = $2; next }
/^task [1-9][0-9]*[a-z]?\.[1-9][0-9]*$/ { task = $2; next }
/^figure [1-9][0-9]*( [0-9]+x[0-9]+\+[0-9]+\+[0-9]+)?$/ {
    figure = $2
    part = NF == 3 ? $3 : "-"
    next
}
/^build CC=./ { compiler = substr($0, 10); next }
/^build CFLAGS=./ { flags = substr($0, 14); next }
{ wrong(FNR, "a line that means nothing: " $0) }
