#!/usr/bin/env python3
"""Writes the measured times of docs/results.md that the race shows: times.py FILE OUT

The table is the one below the heading "Moving the level of detail by 1 %", its column "of the list". A heading, column
or row that is not there is an error."""
import re
import sys
from pathlib import Path

HEADING, COLUMN = "Moving the level of detail by 1 %", "of the list"
ROWS = {"List with slots": "`TriangleListBuffer`", "Maintained strips, local": "`local`", "Maintained strips, quick": "`quick`",
        "Maintained strips, full": "`full`", "Strips from scratch": "from scratch: `stripify`"}


def ratios(file):
    """The ratio of each row, as it is written."""
    section = re.search(rf"^## {HEADING}\n(.*?)(?=^## |\Z)", file.read_text(encoding="utf-8"), re.S | re.M)
    if not section:
        sys.exit(f"times.py: {file}: has no heading {HEADING!r}")
    table = [[cell.strip() for cell in line.strip("|").split("|")] for line in section[1].splitlines() if line.startswith("|")]
    if not table or COLUMN not in table[0]:
        sys.exit(f"times.py: {file}: the table below {HEADING!r} has no column {COLUMN!r}")
    column, out = table[0].index(COLUMN), {}
    for name, start in ROWS.items():
        found = [row[column] for row in table if row[0].startswith(start)]
        if len(found) != 1 or not re.fullmatch(r"[\d.,]+x", found[0]):
            sys.exit(f"times.py: {file}: below {HEADING!r} there is not one row that begins with {start} and has a ratio such as 2.1x")
        out[name] = found[0]
    return out


def main():
    results, out = map(Path, sys.argv[1:])
    found = ratios(results)
    most = max(float(ratio[:-1].replace(",", "")) for ratio in found.values())
    rows = "".join(f'<tr style="--written:{100 * float(ratio[:-1].replace(",", "")) / most:.1f}%;--all:0%"><th scope="row">{name}</th><td>{ratio}</td></tr>\n'
                   for name, ratio in found.items())
    out.write_text(f'<table class="bars" id="times">\n<caption>Time of a change of 1 %, of a list with slots</caption>\n<tbody>\n{rows}</tbody>\n</table>\n', encoding="utf-8")


if __name__ == "__main__":
    main()
