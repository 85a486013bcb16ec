# Reads what `check --json FILE` writes, which has one line for each task and each item:
# for programs of awk that follow this one (-f report.awk -f other.awk FILE).

# What follows "name": in this line; empty when nothing does. Text is as JSON has it, with
# its \" and \n.
function text_of(name,    rest) {
    if (!match($0, "\"" name "\": \"([^\"\\\\]|\\\\.)*\"")) return ""
    rest = substr($0, RSTART, RLENGTH - 1)
    return substr(rest, length(name) + 6)
}

function number_of(name) {
    return match($0, "\"" name "\": [0-9]+") ? substr($0, RSTART + length(name) + 4) + 0 : 0
}

# The tasks of an item, as JSON has them between [ and ].
function tasks_of() {
    return match($0, /"tasks": \[[^]]*/) ? substr($0, RSTART + 10, RLENGTH - 10) : ""
}

# The figures of the lesson that show what an item looks like: "4 or 12".
function figures_of(    figures) {
    figures = match($0, /"figures": \[[^]]*/) ? substr($0, RSTART + 12, RLENGTH - 12) : ""
    gsub(/, /, " or ", figures)
    return figures
}

function is_task() { return /^ *[{]"task": / }
function is_item() { return /^ *[{]"scene": / }

# A picture, or a counter of work.
function item_name() {
    return text_of("scene") (text_of("counter") == "" ? "" : ": " text_of("counter"))
}

/^ *"step": / { step = text_of("step") }
