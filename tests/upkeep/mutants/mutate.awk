# Small changes of C source files, which some test should notice.
#
#     awk -f mutate.awk FILE...
#
# prints them, one a line, with tabs between: line, operator, the function whose arguments are
# swapped or -, file, the line before, the line after.
#
# Only lines inside functions are changed: no comment, string, preprocessor line or assertion, and of
# a declaration only the values. Whether a change compiles, the compiler decides. The sources are
# formatted by clang-format: ` * ` is a product, ` *` isn't, and a statement begins on its own line.

# Put a text instead of `size` characters at `at`; of the function `name` the arguments are swapped.
function change(operator, at, size, text, name,    start) {
    start = substr($0, 1, at - 1)
    if (at >= first && !index(start, "/*") && gsub(/"/, "&", start) % 2 == 0) {
        printf "%d\t%s\t%s\t%s\t%s\t%s%s%s\n", FNR, operator, name == "" ? "-" : name, FILENAME,
            $0, start, text, substr($0, at + size)
    }
}

# A word wherever it is; blanks around it stay.
function change_words(operator, word, text,    at, found) {
    for (at = 1; (found = index(substr($0 " ", at), word)) > 0; at += found) {
        change(operator, at + found - 1, length(word), text)
    }
}

# Whole numbers become one more and one less, others one more, and 1e-9 becomes 1e-4.
function change_numbers(    at, number, suffix) {
    for (at = 1; match(substr($0, at), /[A-Za-z_0-9.]+/); at += RLENGTH) {
        at += RSTART - 1
        number = substr($0, at, RLENGTH)
        if (number ~ /^[0-9]+[uUlL]*$/) {
            suffix = number
            sub(/^[0-9]+/, "", suffix)
            change("constant", at, RLENGTH, (number + 1) suffix)
            if (number + 0 > 0) {
                change("constant", at, RLENGTH, (number - 1) suffix)
            }
        } else if (number ~ /^[0-9]+e$/ && match(substr($0, at), /^[0-9]+e-[0-9]+/)) {
            change("constant", at, RLENGTH, number "-" int(substr($0, at + length(number) + 1) / 2))
        } else if (number ~ /^[0-9]/) {
            change("constant", at, RLENGTH, "(" number " + 1)")
        }
    }
}

# Each argument of a call with the next one, where none is a call.
function swap_arguments(    at, call, name, count, argument, i, begin) {
    for (at = 1; match(substr($0, at), /[A-Za-z_0-9]+\([^(){}]+, [^(){}]+\)/); at += RLENGTH) {
        at += RSTART - 1
        call = substr($0, at, RLENGTH)
        name = substr(call, 1, index(call, "(") - 1)
        begin = at + length(name) + 1
        count = split(substr(call, length(name) + 2, length(call) - length(name) - 2), argument, ", ")
        for (i = 1; i < count; begin += length(argument[i++]) + 2) {
            change("swapped", begin, length(argument[i] ", " argument[i + 1]),
                argument[i + 1] ", " argument[i], name)
        }
    }
}

# The condition of an if or while that fits into its line.
function change_branch(    begin, size, condition) {
    begin = index($0, "(") + 1
    size = length($0) - begin - 2
    condition = substr($0, begin, size)
    change("branch", begin, size, "!(" condition ")")
    change("branch", begin, size, "0 && (" condition ")")
    if (/if \(/) {
        change("branch", begin, size, "1 || (" condition ")")
    }
}

BEGIN {
    pairs = split("< <= <= < > >= >= > == != != == + - - + * / / * % / += -= -= += *= /= /= *= & | " \
        "| & ^ | &= |= |= &= << >> >> << && || || &&", pair, " ")
}
FNR == 1 || /^}/ { inside = 0 }
!inside { inside = /\) \{$/; starts = 1; next }
/^ *(\/\*|\* |\*\/)/ || /^#/ || /assert\(/ || /^ *$/ { next }
{
    declares = /^ *(const|static|struct|enum|union) / ||
        (/^ *[A-Za-z_0-9]+ \**[A-Za-z_0-9]+( = |;|,|\[)/ && !/^ *(return|goto) /)
    first = !starts || !declares ? 1 : / = / ? index($0, " = ") : length($0) + 1
    for (i = 1; i < pairs; i += 2) {
        change_words(i <= 12 ? "comparison" : i > pairs - 4 ? "branch" : "arithmetic",
            " " pair[i] " ", " " pair[i + 1] " ")
    }
    change_words("branch", " ? ", " || 1 ? ")
    change_words("branch", " ? ", " && 0 ? ")
    change_words("arithmetic", "++", "--")
    change_words("arithmetic", "--", "++")
    if (match($0, / [-!][A-Za-z_0-9(]/)) {
        change(substr($0, RSTART + 1, 1) == "!" ? "branch" : "arithmetic", RSTART + 1, 1, "")
    }
    change_numbers()
    swap_arguments()
    if (/^ *(} else )?(if|while) \(.*\) \{$/) {
        change_branch()
    } else if (starts && /;$/ && !declares && !/^ *(return|goto) /) {
        change("deleted", match($0, /[^ ]/), length($0), "")
    }
    starts = /[;:{}]$/
}
