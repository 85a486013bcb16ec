# The steps of a report as a table of Markdown:
#
#   awk -f tests/check/report.awk -f .github/summary.awk report.json
BEGIN { print "| lesson | state | points |\n| --- | --- | ---: |" }
/^      "state": / { state = text_of("state") }
/^      "points": / { points = number_of("points") }
/^      "most": / { print "| " step " | " state " | " points "/" number_of("most") " |" }
