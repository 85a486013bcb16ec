#!/bin/sh
# Do the lessons quote what is there? Every ```c block of a lesson's texts has 12 lines at most,
# and is word for word (except for white space at the beginning of lines) in one file of the
# lesson's directory, or in one header of common. A line `...` means lines left out. main.c is
# quoted without its marks, as solution or as starter.
. "$(dirname "$0")/../unit/script.sh"

# find_quotes TEXT FILE...: each quote of the text in one of the files.
find_quotes() {
    readme=$1
    shift
    awk -v readme="$readme" '
        function wrong(message) {
            print readme ":" begin ": " message
            failed = 1
        }

        # Do the parts of the quote, between lines `...`, follow each other in the file?
        function stands_in(rest,   i, part, at) {
            quote[quoted + 1] = "..."
            part = "\n"
            for (i = 1; i <= quoted + 1; i++) {
                if (quote[i] != "...") {
                    part = part quote[i] "\n"
                    continue
                }
                at = index(rest, part)
                if (!at) return 0
                rest = substr(rest, at + length(part) - 1)
                part = "\n"
            }
            return 1
        }

        function check_quote(   file) {
            if (quoted > 12) wrong("a quote of " quoted " lines; 12 are the limit")
            for (file in text) if (stands_in("\n" text[file])) return
            wrong("is neither in a file of the lesson nor in a header of common")
        }

        { sub(/^[ \t]+/, "") }
        FILENAME != readme { text[FILENAME] = text[FILENAME] $0 "\n"; next }
        inside && /^```/ { inside = 0; check_quote(); next }
        inside { quote[++quoted] = $0; next }
        /^```c( |$)/ { inside = 1; begin = FNR; quoted = 0 }
        END {
            if (inside) wrong("a quote without an end")
            exit failed
        }' "$@" "$readme" || failed=1
}

for lesson in step*; do
    for mode in starter solution; do
        awk -v mode=$mode -f tests/student/marks.awk "$lesson/main.c" >"$work/$mode" || failed=1
    done
    files=$(find "$lesson" -name '*.[ch]' ! -name main.c -o -name '*.txt')
    for text in "$lesson"/*.md; do
        # shellcheck disable=SC2086
        find_quotes "$text" "$work/starter" "$work/solution" $files common/*.h
    done
done
exit $failed
