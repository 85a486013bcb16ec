# Lines `NAME task STEP TASK STATE POINTS MOST`, for sums.awk, of what `check --json` wrote:
#
#     awk -v name=NAME -f report.awk -f tasks.awk report.json
BEGIN { OFS = "\t" }
is_task() { print name, "task", step, text_of("task"), text_of("state"), number_of("points"), number_of("most") }
