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
#     show=A,B      one or two things to touch: values, frame, light, camera, points (corners, ends, values
#                   NAME_x and NAME_y), pixel; wrong is also: against the same without its attempt
#     at=X,Y        the pixel at first, counted from the lower left
#     tell=A,B      the line of numbers: counters of --stats, and words of what --probe says of the pixel
# The picture is what the program draws so, and may be enlarged: the page's own one replaces it.

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
            if (name ~ /_x$/) can[scene, "points"] = 1
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
            can[scene, "frame"] = least[scene, "frame"] = 1
            most[scene, "frame"] = frames
        }
    }
    next
}

function check(title,    option, show, i, count, scene, name, value, at, shows) {
    count = split(title, option, /, /)
    scene = option[1]
    if (!(scene in known)) {
        wrong("the program has no scene `" scene "`")
        return
    }
    for (i = 2; i <= count; i++) {
        name = value = option[i]
        sub(/=.*/, "", name)
        sub(/^[^=]*=?/, "", value)
        if (name == "show") shows = value
        else if (name == "at" && value ~ /^[0-9]+,[0-9]+$/) at = value
        else if (name == "tell" && value != "") {}
        else if (name == "text" && (scene, "text") in can) {}
        else if (!((scene, name) in least)) wrong("scene `" scene "` has no number `" name "`")
        else if (value !~ /^-?[0-9]+(\.[0-9]+)?$/ || value + 0 < least[scene, name] || value + 0 > most[scene, name])
            wrong("`" name "` goes from " least[scene, name] " to " most[scene, name])
    }
    count = split(shows, show, ",")
    if (count < 1 || count > 2) wrong("show= names one or two things to touch, and here " count)
    for (i = 1; i <= count; i++) {
        if (!((scene, show[i]) in can) || show[i] == "text") wrong("scene `" scene "` lets nobody change `" show[i] "`")
        if (show[i] == "pixel" && at == "") wrong("a pixel to touch begins somewhere: at=X,Y")
    }
}

/"live:/ {
    cells = split($0, cell, /^\| | \| | \|$/)
    for (i = 1; i <= cells; i++) {
        if (cell[i] !~ /"live:/) continue
        if (cell[i] ~ /^!\[[^]]+\]\([^ ()]+\.png "live: [^"]*"\)$/) {
            sub(/^.*"live: /, "", cell[i])
            check(substr(cell[i], 1, length(cell[i]) - 2))
        } else wrong("a living figure is alone on its line, as ![what it shows](picture.png \"live: scene, show=...\")")
    }
}

END { exit status }
