# A report as Gradescope takes it (run_autograder says where from): a test for each picture and each
# counter.
#
#   awk -v visibility=visible -v note=TEXT -f report.awk -f results.awk report.json
function line(text) { return text == "" ? "" : text "\\n" }

# What the compiler or the program said, of the whole step.
/^      "reason": / { output = output line(step ": " text_of("reason")) }
/^      "messages": / { output = output line(text_of("messages")) }
is_item() {
    looks = text_of("looks_like")
    may_be = text_of("may_be")
    see = figures_of() == "" ? "" : ": see " step "/WRONG.md, figure " figures_of()
    tests = tests (tests == "" ? "" : ",") "\n    {\"name\": \"" step " " item_name() \
        "\", \"score\": " number_of("points") ", \"max_score\": " number_of("most") \
        ", \"output\": \"" text_of("state") "\\n" line(text_of("message")) \
        line(looks == "" ? "" : "looks like " looks see) \
        line(may_be == "" ? "" : "may be " may_be see) \
        "\", \"tags\": [" tasks_of() \
        "], \"visibility\": \"" visibility "\"}"
}
END {
    gsub(/\n/, "\\n", note)
    printf "{\"output\": \"%s%s\", \"visibility\": \"%s\", \"stdout_visibility\": \"hidden\",\n", \
        line(note), output, visibility
    printf " \"tests\": [%s\n]}\n", tests
}
