# Reads lists of mutants; prints a line for each mutant and writes its changed source.
#
#   awk -v directory=DIR -v only=PATTERN -f parse.awk LIST.txt...
#
# A list has paragraphs, with empty lines between them, and comments like this one:
#
#   file common/geometry.c
#   test_geometry
#
#   mutant dot_sign
#   - a.x * b.x + a.y * b.y
#   + a.x * b.x - a.y * b.y
#
# The text after `- ` stands exactly once in the file (in several lines, each after `- `); that
# after `+ ` takes its place. The test that must notice is
#
#   test_NAME              a unit test, built without sanitizers
#   sanitized test_NAME    the same with them
#   NAME.sh                a script of tests/unit
#   stress SHARE PROPERTY  as STRESS=SHARE make stress PROPERTY=...
#   check NN               the pictures of a lesson must all be exact
#   equivalent: REASON     none can: nothing that is promised changes
#   awaits: WHAT           none does yet
#
# `file` and a test hold for all mutants that follow, or within a mutant's paragraph for it alone.
#
# Prints, with tabs between: number, LIST/NAME, source file, test. DIR/NUMBER is the source file with
# the mutation. What is wrong with a list is reported on standard error with file and line; then the
# exit status is 1.

function wrong(line, what) {
    print path ":" line ": " what | "cat 1>&2"
    failed = 1
}

# The whole text of a source file, read once.
function source_text(source,    line, text) {
    if (!(source in sources)) {
        text = ""
        while ((getline line < source) > 0) {
            text = text line "\n"
        }
        close(source)
        sources[source] = text
    }
    return sources[source]
}

function is_test(test) {
    return test ~ /^(sanitized )?test_[a-z0-9_]+$/ || test ~ /^[a-z_]+\.sh$/ ||
           test ~ /^check [0-9][0-9]$/ || test ~ /^stress [0-9.]+ ./ ||
           test ~ /^equivalent: ./ || test ~ /^awaits: ./
}

# The mutant that began at `begin` is complete.
function finish(    text, at, before, after) {
    if (name == "") {
        return
    }
    if (seen[list "/" name]++) {
        wrong(begin, "a second mutant " name)
    }
    if (!is_test(test)) {
        wrong(begin, name ": no such kind of test: " test)
    }
    text = source_text(file)
    at = index(text, old)
    if (old == "" || at == 0) {
        wrong(begin, name ": the text does not occur in " file)
    } else {
        before = substr(text, 1, at - 1)
        after = substr(text, at + length(old))
        if (index(substr(text, at + 1), old) > 0) {
            wrong(begin, name ": the text occurs more than once in " file)
        }
        if (old == new) {
            wrong(begin, name ": changes nothing")
        }
        if (index(list "/" name, only) > 0) {
            count++
            printf "%s", before new after > (directory "/" count)
            close(directory "/" count)
            printf "%d\t%s/%s\t%s\t%s\n", count, list, name, file, test
        }
    }
    name = ""
    file = list_file
    test = list_test
}

FNR == 1 {
    finish() # the last of the list before
    list = path = FILENAME
    sub(/.*\//, "", list)
    sub(/\.txt$/, "", list)
    file = test = list_file = list_test = name = ""
}

/^#/ { next }
/^$/ { finish(); next }

# Before a mutant they hold for all that follow, within one for it alone.
/^file / {
    file = substr($0, 6)
    if (name == "") {
        list_file = file
    }
    next
}
/^(test_|sanitized |check |stress |equivalent: |awaits: |[a-z_]+\.sh$)/ {
    test = $0
    if (name == "") {
        list_test = test
    }
    next
}
/^mutant / {
    finish()
    name = substr($0, 8)
    begin = FNR
    old = new = ""
    old_lines = new_lines = 0
    next
}
/^- / { old = old (old_lines++ > 0 ? "\n" : "") substr($0, 3); next }
/^\+ / { new = new (new_lines++ > 0 ? "\n" : "") substr($0, 3); next }
/^\+$/ { next } # the text goes, and nothing takes its place
{ wrong(FNR, "a line that means nothing: " $0) }

END {
    finish()
    exit failed
}
