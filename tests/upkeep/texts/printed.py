#!/usr/bin/env python3
"""Are the numbers in the lessons those that are printed?

In a lesson's texts a line `<!-- printed -->` is before each table that `make figures` prints:
either as it is printed, indented, or as a table in which each row begins with words of a printed
line, and all its numbers are in such lines, except those of columns headed "ms". And "`zbuffer`
takes 40 million instructions (`make counts STEP=05`): 5 for loading, ..." is what
tests/bench/counts.txt says.

What a text says of its chart is in a line before the paragraph, and rounds to what the chart shows:

    <!-- chart 2: 3 to 7 = box | blocks / spans; 3.52 = spans; 24 = error of box -->

Panel 2 of figures/bench.svg has versions whose names begin so. `3 to 7` are the least and the largest
of the times, here divided by another one; in the paragraph, or table, a number may be a word, 0.2 "a fifth".

    printed.py BUILD        after `make figures` or `make lesson-figures` with that BUILD

Exit status 1 and a line for each row that is not printed; also where no table is marked at all.
"""
import pathlib
import re
import sys

build = pathlib.Path(sys.argv[1]).resolve()
top = pathlib.Path(__file__).parents[3]
wrong = []
checked = 0
WORDS = {"2": "two", "3": "three", "4": "four", "5": "five", "6": "six", "7": "seven", "8": "eight",
         "9": "nine", "10": "ten", "0.1": "a tenth", "0.2": "a fifth", "0.4": "two fifths", "0.5": "half|halves",
         "0.6": "three fifths", "0.8": "four fifths"}


def numbers_of(text):
    return set(re.findall(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?", text.replace(",", "")))


def rows_of(table):
    """Each row as its words at the left and its numbers: without the head and the line below it."""
    cells = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table]
    head = cells[0] if cells else []
    for line, row in zip(table[2:], cells[2:]):
        numbers = [cell for name, cell in zip(head[1:], row[1:])
                   if name != "ms" and re.fullmatch(r"[-+0-9.,e ]+", cell)]
        yield line, row[0].split(" (")[0], numbers_of(" ".join(numbers))


def judge_text(path, printed):
    global checked
    for block in path.read_text().split("<!-- printed -->\n")[1:]:
        end = re.search(r"^(?! {4}|\||$)", block, re.MULTILINE)
        table = [line for line in block[:end.start() if end else None].split("\n") if line]
        if table and table[0].startswith("    "):
            checked += len(table)
            wrong.extend(f"{path}: not printed: {line}" for line in table if line[4:] not in printed)
            continue
        for line, label, wanted in rows_of(table):
            checked += 1
            found = numbers_of("\n".join(text for text in printed if " " + label in " " + text))
            wrong.extend(f"{path}: {number} is not printed: {line}" for number in wanted - found)


def marks_of(chart):
    """For each panel its marks: names, and (error, time)."""
    panels = []
    for title, name, error, time in re.findall(
            r'<text class="(title)"|<title>([^<]*): error ([^,]*), time ([^<]*)</title>', chart.read_text()):
        if title:
            panels.append({})
        else:
            panels[-1][name] = (float(error), float(time))
    return panels


def shown(version, marks):
    column = 0 if version.startswith("error of ") else 1
    name = version.removeprefix("error of ")
    return next((mark[column] for full, mark in marks.items() if full.startswith(name)), float("nan"))


def judge_chart(text, panels):
    """Numbers rounded as they are written."""
    global checked
    for panel, claims, paragraph in re.findall(r"<!-- chart (\d+): (.*?) -->\n\n(.*?)(?:\n\n|$)",
                                               text.read_text(), re.DOTALL):
        paragraph = " ".join(paragraph.split())
        for claim in claims.split("; "):
            said, names = claim.split(" = ")
            above, _, below = names.partition(" / ")
            marks = panels[int(panel) - 1]
            values = [shown(version, marks) for version in above.split(" | ")]
            unit = shown(below, marks) if below else 1
            for number, value in zip(said.split(" to "), (min(values), max(values))):
                checked += 1
                digits = len(number.partition(".")[2])
                if number != f"{value / unit:.{digits}f}":
                    wrong.append(f"{text}: {claim}: the chart shows {value / unit:.4g}")
            if not re.search(rf"\b({said}|{WORDS.get(said)})\b", paragraph):
                wrong.append(f"{text}: {said} is not in: {paragraph[:60]}")


def judge_counts(readme, counts):
    """Instructions: each number rounded as it is written."""
    global checked
    text = " ".join(readme.read_text().split())
    for match in re.finditer(r"`(\w+)` takes ([\d.]+) million instructions \(`make counts STEP=\d+`\):"
                             r"(.*?)(?:\. |$)", text):
        row = dict(zip(("all", "loading", "drawing", "saving"), counts[readme.parent.name, match[1]]))
        checked += 1
        written = [(match[2], "all")] + re.findall(r"([\d.]+) for (loading|drawing|saving)", match[3])
        for number, what in written:
            digits = len(number.partition(".")[2])
            if number != f"{float(row[what]):.{digits}f}":
                wrong.append(f"{readme}: {number} million instructions are {row[what]}")


for output in sorted((build / "figures").glob("step*.txt")):
    for text in sorted((top / output.stem).glob("*.md")):
        judge_text(text, output.read_text().split("\n"))
for chart in sorted(top.glob("step*/figures/bench.svg")):
    for text in sorted(chart.parents[1].glob("*.md")):
        judge_chart(text, marks_of(chart))
rows = [line.split() for line in (top / "tests/bench/counts.txt").read_text().split("\n")]
for readme in sorted(top.glob("step*/*.md")):
    judge_counts(readme, {(row[0], row[1]): row[2:] for row in rows if len(row) > 2})
for line in wrong:
    print(line)
print(checked, "rows are compared with what is printed")
sys.exit(bool(wrong) or checked == 0)
