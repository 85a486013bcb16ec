# Are a lesson's living figures what its program can draw? Each line that is wrong is said, and fails.
#
#     build/moving/step01_line --live </dev/null | awk -f figures.awk - step01_line/README.md
#
# A living figure is a picture alone on its line, or in a table's cell, whose title GitHub shows as a hint:
#
#     ![two lines](figures/two.png "live: your own, attempt=1, show=points,wrong, tell=pixels_wrong")
#
# First its scene, then in any order
#     NAME=NUMBER   of the scene's values, as with --set, or frame
#     text=...      of `your own`: its lines, with "; " between them
#     show=A,B      one or two things to touch: values, frame, play (the frames, to and fro), light, camera,
#                   points (corners, ends, values NAME_x and NAME_y), pixel; wrong is also: against the same
#                   without its attempt
#     at=X,Y        the pixel at first, counted from the lower left
#     tell=A,B      the line of numbers: counters of --stats, and words of what --probe says of the pixel
# The picture is what the program draws so, and may be enlarged: the page's own one replaces it.
#
# Words of a text may belong to the figure above or below them, by remarks, which GitHub does not show:
#
#     with <!-- above: cuts -->2<!-- / --> cuts       a number that is dragged: cuts, or #5, the fifth number of text=
#     <!-- below: cuts=6 look=0 -->this one<!-- / -->   a click brings the figure there; also at=X,Y and #5=2
#     <!-- above: @point1-point2 --> ... <!-- / -->   pointed at, it lights parts of the figure, and they it
#
# Parts are pixel, light, point1, point2 and so on, NAME of the values NAME_x and NAME_y, two of these
# with a line between them, @X,Y, a pixel, and words of tell=. A block of code begins with "```c above: 3=@error"
# then: its third line.

function wrong(message) {
    print FILENAME ":" FNR ": " message >"/dev/stderr"
    status = 1
}

# What the program says of itself (common/run/live.h).
FNR == NR {
    count = split($0, part, /\{"name":"/)
    for (i = 2; i <= count; i++) {
        name = substr(part[i], 1, index(part[i], "\"") - 1)
        if (part[i] ~ /^[^"]*","help":/) {
            match(part[i], /"least":[^,]*,"most":[^,]*/)
            range = substr(part[i], RSTART + 8, RLENGTH - 8)
            least[scene, name] = range + 0
            sub(/.*:/, "", range)
            most[scene, name] = range + 0
            match(part[i], /"value":[-0-9.e]+/)
            usual[scene, name] = substr(part[i], RSTART + 8, RLENGTH - 8)
            if (name ~ /_x$/) can[scene, "points"] = points[scene, substr(name, 1, length(name) - 2)] = 1
            if (name == "attempt") can[scene, "wrong"] = 1
            can[scene, name] = 1
            continue
        }
        scene = name
        known[scene] = can[scene, "pixel"] = 1
        if (part[i] ~ /"light":/) can[scene, "light"] = 1
        if (part[i] ~ /"eye":/) can[scene, "camera"] = 1
        if (part[i] ~ /"text":/) can[scene, "text"] = can[scene, "points"] = 1
        if (match(part[i], /"frames":[0-9]+/) && (frames = substr(part[i], RSTART + 9, RLENGTH - 9) + 0) > 1) {
            can[scene, "frame"] = can[scene, "play"] = least[scene, "frame"] = usual[scene, "frame"] = 1
            most[scene, "frame"] = frames
        }
    }
    next
}

function is_number(scene, name, value) {
    return (scene, name) in least && value ~ /^-?[0-9]+(\.[0-9]+)?$/ && value + 0 >= least[scene, name] && value + 0 <= most[scene, name]
}

# The words of a remark, about the figure that was checked last; and what stands between it and its end.
function check_touch(words, text,    word, count, i, name, value, part, parts, k) {
    count = split(words, word, " ")
    for (i = 1; i <= count; i++) {
        name = value = word[i]
        sub(/=.*/, "", name)
        if (!sub(/^[^=]*=/, "", value)) value = count > 1 ? "" : text
        if (word[i] ~ /^@[0-9]+,[0-9]+$/) continue
        if (sub(/^@/, "", word[i])) {
            parts = split(word[i], part, "-")
            for (k = 1; k <= parts; k++) {
                name = part[k]
                sub(/[0-9]$/, "", name) # E0 is the first of what tell=E tells
                if (!(part[k] in lights || name in lights)) wrong("the figure has no part `" part[k] "`")
            }
        } else if (name == "at" ? value !~ /^[0-9]+,[0-9]+$/ : name ~ /^#/ ? !(name in lights) || value !~ /^-?[0-9.]+$/ \
                                                           : !is_number(last_scene, name, value))
            wrong("the figure's scene `" last_scene "` has no `" name "` that can be " value)
        else if (words !~ /=/ && value + 0 != now[name] + 0) wrong("`" name "` is " now[name] " in the figure, and here " value)
    }
}

# What a figure has that words may light, and its numbers.
function note_parts(scene, shows, tells, text,    i, count, part, word) {
    split("", lights)
    last_scene = scene
    count = split(shows "," tells, part, ",")
    for (i = 1; i <= count; i++) lights[part[i]] = 1
    for (i in points) {
        split(i, part, SUBSEP)
        if (part[1] == scene && "points" in lights) lights[part[2]] = 1
    }
    for (i = 1; "points" in lights && i < 20; i++) lights["point" i] = 1
    gsub(/[^-0-9. ]/, " ", text)
    count = split(text, word, " ")
    for (i = 1; i <= count; i++) lights["#" i] = now["#" i] = word[i]
}

function check(title,    option, show, i, count, scene, name, value, at, shows, tells, text, key) {
    count = split(title, option, /, /)
    scene = option[1]
    if (!(scene in known)) {
        wrong("the program has no scene `" scene "`")
        return
    }
    split("", now)
    for (key in usual) if (index(key, scene SUBSEP) == 1) now[substr(key, length(scene) + 2)] = usual[key]
    for (i = 2; i <= count; i++) {
        name = value = option[i]
        sub(/=.*/, "", name)
        sub(/^[^=]*=?/, "", value)
        if (name == "show") shows = value
        else if (name == "at" && value ~ /^[0-9]+,[0-9]+$/) at = value
        else if (name == "tell" && value != "") tells = value
        else if (name == "text" && (scene, "text") in can) text = value
        else if (!((scene, name) in least)) wrong("scene `" scene "` has no number `" name "`")
        else if (!is_number(scene, name, value)) wrong("`" name "` goes from " least[scene, name] " to " most[scene, name])
        else now[name] = value
    }
    note_parts(scene, shows, tells, text)
    count = split(shows, show, ",")
    if (count < 1 || count > 2) wrong("show= names one or two things to touch, and here " count)
    for (i = 1; i <= count; i++) {
        if (!((scene, show[i]) in can) || show[i] == "text") wrong("scene `" scene "` lets nobody change `" show[i] "`")
        if (show[i] == "pixel" && at == "") wrong("a pixel to touch begins somewhere: at=X,Y")
    }
}

# ---- The text: figures, and words that belong to them ----

FNR == 1 { end_text() }

function end_text() {
    if (waiting > 0) wrong("no figure comes below")
    waiting = 0
    last_scene = ""
}

function touch(where, words, text) {
    if (where == "below") waiting_for[++waiting] = words "\t" text
    else if (last_scene == "") wrong("no figure is above")
    else check_touch(words, text)
}

/"live:/ {
    cells = split($0, cell, /^\| | \| | \|$/)
    for (i = 1; i <= cells; i++) {
        if (cell[i] !~ /"live:/) continue
        if (cell[i] ~ /^!\[[^]]+\]\([^ ()]+\.png "live: [^"]*"\)$/) {
            sub(/^.*"live: /, "", cell[i])
            check(substr(cell[i], 1, length(cell[i]) - 2))
            for (; waiting > 0; waiting--) {
                split(waiting_for[waiting], part, "\t")
                check_touch(part[1], part[2])
            }
        } else if (cell[i] ~ /<img/ && match(cell[i], /title="live: [^"]*"/)) check(substr(cell[i], RSTART + 13, RLENGTH - 14))
        else wrong("a living figure is alone on its line, as ![what it shows](picture.png \"live: scene, show=...\")")
    }
}

{
    line = $0
    if (line ~ /^ *<!-- (above|below): /) wrong("a remark at the start of a line ends the paragraph on GitHub")
    while (match(line, /<!-- (above|below): [^>]* -->/)) {
        words = substr(line, RSTART + 5, RLENGTH - 9)
        line = substr(line, RSTART + RLENGTH)
        if (!match(line, /<!-- \/ -->/)) wrong("the words of a figure end on their line, by <!-- / -->")
        else touch(substr(words, 1, 5), substr(words, 8), substr(line, 1, RSTART - 1))
    }
}

/^ *```[a-z]+ (above|below): / {
    line = $0
    sub(/^ *```[a-z]+ /, "", line)
    count = split(substr(line, 8), word, " ")
    for (i = 1; i <= count; i++) {
        if (word[i] !~ /^[0-9]+=@/) wrong("of a block of code, a line lights parts: 3=@pixel")
        sub(/^[0-9]+=/, "", word[i])
        touch(substr(line, 1, 5), word[i], "")
    }
}

END {
    end_text()
    exit status
}
