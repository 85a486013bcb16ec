# Reads lists of mutants; prints a line for each mutant and writes its changed source.
#
#   awk -v directory=DIR -v only=PATTERN -f replace.awk -f parse.awk LIST.txt...
#
# A list has paragraphs like this one (tests/upkeep/verify/replace.awk says how a text is replaced):
#
#   file common/geometry.c
#   test_geometry
#
#   mutant dot_sign
#   - a.x * b.x + a.y * b.y
#   + a.x * b.x - a.y * b.y
#
# The test that must notice is
#
#   test_NAME              a unit test, built without sanitizers
#   sanitized test_NAME    the same with them
#   NAME.sh                a script of tests/unit
#   stress SHARE PROPERTY  as STRESS=SHARE make stress PROPERTY=...
#   check NN               the pictures of a lesson must all be exact
#   equivalent: REASON     none can: nothing that is promised changes
#   awaits: WHAT           none does yet
#   on MACRO TEST          one of these, where the compiler defines that for this machine
#
# `file` and a test hold for all mutants that follow, or within a mutant's paragraph for it alone.
#
# Prints, with tabs between: number, LIST/NAME, source file, test. DIR/NUMBER is the source file with
# the mutation.

function is_test(test) {
    sub(/^on [A-Za-z0-9_]+ /, "", test)
    return test ~ /^(sanitized )?test_[a-z0-9_]+$/ || test ~ /^[a-z_]+\.sh$/ ||
           test ~ /^check [0-9][0-9]$/ || test ~ /^stress [0-9.]+ ./ ||
           test ~ /^equivalent: ./ || test ~ /^awaits: ./
}

# The mutant that began at `begin` is complete.
function finish(    text) {
    if (name == "") {
        return
    }
    if (seen[list "/" name]++) {
        wrong(begin, "a second mutant " name)
    }
    if (!is_test(test)) {
        wrong(begin, name ": no such kind of test: " test)
    }
    if (changes == 0) {
        wrong(begin, name ": changes nothing")
    }
    text = changed_text(file, name)
    if (index(list "/" name, only) > 0) {
        count++
        printf "%s", text > (directory "/" count)
        close(directory "/" count)
        printf "%d\t%s/%s\t%s\t%s\n", count, list, name, file, test
    }
    name = ""
    file = list_file
    test = list_test
}

function begin_list() {
    file = test = list_file = list_test = name = ""
}

# Before a mutant they hold for all that follow, within one for it alone.
/^file / {
    file = substr($0, 6)
    if (name == "") {
        list_file = file
    }
    next
}
/^(on |test_|sanitized |check |stress |equivalent: |awaits: |[a-z_]+\.sh$)/ {
    test = $0
    if (name == "") {
        list_test = test
    }
    next
}
/^mutant / {
    finish()
    name = substr($0, 8)
    begin_changes()
    next
}
{ wrong(FNR, "a line that means nothing: " $0) }
