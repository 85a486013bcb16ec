# The answers in a lesson's README.md, which stand behind its questions:
#
#     <details><summary>Answer</summary>
#     ...the answer...
#     </details>
#
#   awk -v mode=MODE -f answers.awk step05_zbuffer/README.md
#
# MODE without prints the text without them, as students get it; only prints the title and the
# section of the questions, with the answers to be seen.
#
# Exit status 1: an answer that begins does not end, or the other way round.

function wrong(what) {
    print FILENAME ":" FNR ": " what | "cat 1>&2"
    failed = 1
    exit 1
}

# A gap that an answer leaves is closed before the next question.
function print_without() {
    if (gap && /^ *$/) return
    if (gap && !/^ *[0-9]+\. /) print ""
    gap = 0
    print
}

/^## / { in_questions = /^## Questions/ }

/<details><summary>Answer<\/summary>/ {
    if (inside) wrong("an answer in an answer")
    inside = 1
    if (mode == "only") print "   **Answer:**"
    next
}
inside && /<\/details>/ {
    inside = 0
    gap = mode == "without"
    skipped = mode == "only"
    next
}
mode == "without" && !inside { print_without() }
# Where the end of an answer stood, one empty line is enough.
FNR == 1 && mode == "only" { print $0 "\n" }
mode == "only" && in_questions && !(skipped && /^$/) { print; skipped = 0 }

END {
    if (inside && !failed) wrong("this answer has no end")
    exit failed
}
