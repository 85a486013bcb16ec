# What the lists of changes share (stepNN_name/mistakes.txt, tests/lessons/stepNN_name/alternatives.txt):
# they have paragraphs, with empty lines between them, comments after # at the start of a line, and
# texts that take the place of others:
#
#   - a.x * b.x + a.y * b.y
#   + a.x * b.x - a.y * b.y
#
# The text after `- ` is in the file exactly once (in several lines, each after `- `); that
# after `+ ` takes its place, and `+` alone leaves nothing. Another `- ` after that begins another
# replacement.
#
# Stands before the program that reads the list, which has begin_list() and finish(): the list at
# `path` begins; a paragraph ends. What is wrong with a list is reported on standard error with file
# and line; then the exit status is 1.

function wrong(line, what) {
    print path ":" line ": " what | "cat 1>&2"
    failed = 1
}

# The whole text of a file, read once; empty when there is none.
function source_text(path,    line, text) {
    if (!(path in sources)) {
        text = ""
        while ((getline line < path) > 0) {
            text = text line "\n"
        }
        close(path)
        sources[path] = text
    }
    return sources[path]
}

# From here on replacements are those of another paragraph, which begins at this line.
function begin_changes() {
    begin = FNR
    changes = 0
}

# The text of a file with the replacements of the paragraph, which is called `name` in messages.
function changed_text(file, name,    text, at, i) {
    text = source_text(file)
    for (i = 1; i <= changes; i++) {
        at = index(text, old[i])
        if (old[i] == "" || at == 0) {
            wrong(old_line[i], name ": the text does not occur in " file)
        } else if (index(substr(text, at + 1), old[i]) > 0) {
            wrong(old_line[i], name ": the text occurs more than once in " file)
        } else if (old[i] == new[i]) {
            wrong(old_line[i], name ": changes nothing")
        } else {
            text = substr(text, 1, at - 1) new[i] substr(text, at + length(old[i]))
        }
    }
    return text
}

FNR == 1 {
    finish() # the last one of the list before
    path = list = FILENAME
    sub(/.*\//, "", list)
    sub(/\.txt$/, "", list)
    begin_list()
}

/^#/ { next }
/^$/ { finish(); next }

/^- / && (changes == 0 || new_lines > 0) {
    changes++
    old_line[changes] = FNR
    old[changes] = new[changes] = ""
    old_lines = new_lines = 0
}
/^- / { old[changes] = old[changes] (old_lines++ > 0 ? "\n" : "") substr($0, 3); next }
/^\+/ && changes == 0 { wrong(FNR, "no text to be replaced"); next }
/^\+ / { new[changes] = new[changes] (new_lines++ > 0 ? "\n" : "") substr($0, 3); next }
/^\+$/ { new_lines++; next }

END {
    finish()
    exit failed
}
