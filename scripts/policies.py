#!/usr/bin/env python3
"""Writes the copies of the table of policies (runtime/include/restrip/search/policy.hpp), or compares them with it (--check).

The copies: README's table, the codes in restrip.h, the types of JavaScript, the names in Python, the menus of the viewer.
The prices in the table are those of docs/results-policies.csv, which --measure writes.
"""
import argparse
import csv
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SEARCH = ROOT / "runtime/include/restrip/search"
MEASURED = ROOT / "docs/results-policies.csv"


class Row:
    def __init__(self, code, name, description, for_indices, state, price):
        self.code, self.name, self.description, self.for_indices, self.state, self.price = code, name, description, for_indices, state, price


def rows():
    """In the order of the table; the code is the number in the enumeration."""
    names = re.search(r"enum class Policy[^{]*\{([^}]*)\}", (SEARCH.parent / "fwd.hpp").read_text())[1].replace(" ", "").split(",")
    text = (SEARCH / "policy.hpp").read_text()
    found = re.findall(r"PolicyRow\{\s*Policy::(\w+),((?:\s*\"[^\"]*\",){5})", text)
    if sorted(policy for policy, _ in found) != sorted(names):
        sys.exit("policies.py: the table does not have one row for each policy of the enumeration")
    return [Row(names.index(policy), *re.findall(r'"([^"]*)"', texts)) for policy, texts in found]


def prices():
    """By policy: the least and the greatest time of an operation, in times of the mesh update alone, to two digits."""
    times = {"bare": [1.0]}
    with open(MEASURED, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            times.setdefault(row["policy"], []).extend(float(row[part]) for part in ("split", "collapse"))
    ends = {policy: [f"{float(f'{end(all_of):.2g}'):,g}" for end in (min, max)] for policy, all_of in times.items()}
    return {policy: least if least == most_of_all else f"{least} to {most_of_all}" for policy, (least, most_of_all) in ends.items()}


def expect_prices(listed):
    measured = prices()
    for row in listed:
        if row.price != measured.get(row.name):
            sys.exit(f"policies.py: the price of {row.name} in policy.hpp is {row.price}, by {MEASURED.name} "
                     f"{measured.get(row.name, 'unknown; run scripts/policies.py --measure')}")


def measure(program, meshes, listed):
    """Replays each mesh from 2 % of its triangles to all of them and back."""
    with open(MEASURED, "w", encoding="utf-8", newline="\n") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["policy", "cost", "mesh", "split", "collapse"])
        for row in listed:
            if row.name == "bare":
                continue
            for cost in ("strips",) if row.for_indices == "nothing" else ("strips", "indices"):
                for mesh in meshes:
                    report = json.loads(subprocess.check_output(
                        [program, "replay", mesh, "--base", "0.02", "--policy", row.name, "--cost", cost, "--json", "-"]))
                    times = [report[time] / report[time + "_bare"] for time in ("ns_per_operation", "ns_per_collapse")]
                    table.writerow([row.name, cost, Path(mesh).stem, *(f"{time:.3g}" for time in times)])


def most(what):
    return re.search(rf"most_{what}_added = (\d+)", (SEARCH / "policy.hpp").read_text())[1]


def readme(listed):
    def bounds(row):
        if row.name == "bare":
            return ["–", "–"]
        return [most("strips"), "grows with the valence" if row.name == "rules" else most("indices") + " + new triangles"]
    return "".join("| " + " | ".join([f"`{row.name}`", row.description, row.for_indices, row.state, row.price, *bounds(row)]) + " |\n"
                   for row in listed)


def c(listed):
    def comment(row):
        return "no rule, dual edges of changed triangles become dashed" if row.name == "bare" else row.for_indices
    heads = [f"  RESTRIP_POLICY_{row.name.upper()} = {row.code}," for row in listed]
    heads.append("  RESTRIP_POLICY_BAKED = 255")
    comments = [f"/* {comment(row)}; {row.price} */\n" for row in listed]
    comments.append("/* of restrip_baked_read: plays stored strips; restrip_mesh_keep refuses it */\n")
    width = max(map(len, heads))
    return "".join(f"{head:{width}} {comment}" for head, comment in zip(heads, comments))


def quoted(listed, quote, between):
    return between.join(quote + row.name + quote for row in listed)


def menu(listed):
    """Of the policies that search after a rule; the default is selected."""
    default = re.search(r"default_policy = Policy::(\w+);", (SEARCH.parent / "fwd.hpp").read_text())[1]
    return "".join(f'            <option value="{row.name}"{" selected" * (row.name == default)}>{row.name}: {row.for_indices}</option>\n'
                   for row in listed if row.for_indices not in ("nothing", "the same"))


COPIES = [  # a file, what is before the copy, what is after it, and the copy
    ("README.md", r"<!-- tested: cross\.policies -->\n\|[^\n]*\n\|[^\n]*\n", r"<!-- /tested -->", readme),
    ("bindings/c/include/restrip.h", r"enum \{\n(?=  RESTRIP_POLICY_)", r"\};\n", c),
    ("bindings/js/restrip.d.ts", r"export type Policy = ", r" \| 'baked';", lambda listed: quoted(listed, "'", " | ")),
    ("bindings/js/restrip.mjs", r"\nconst policies = \[", r"\];\n", lambda listed: quoted(listed, "'", ", ")),
    ("bindings/python/src/restrip/__init__.py", r"\n_POLICIES = \{", r"\}\n", lambda listed: ", ".join(f'"{row.name}": {row.code}' for row in listed)),
    ("bindings/python/src/restrip/__init__.py", r"\nPolicy = Literal\[", r"\]\n", lambda listed: quoted(listed, '"', ", ")),
    ("bindings/python/src/restrip/__init__.py", r"    `policy` \(", r": docs/reference/policies\.md", lambda listed: quoted(listed, '"', ", ")),
    ("web/viewer/viewer.html", r'<select id="policy">\n', r' *<option value="baked">', menu),
    ("web/viewer/race.html", r'<select id="race-policy">\n', r" *</select>", menu),
]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/policies.py --check")
    parser.add_argument("--check", action="store_true", help="write nothing; exit status 1 if a copy or a price differs")
    parser.add_argument("--measure", nargs="+", metavar=("RESTRIP", "MESH"),
                        help="the program, and meshes of some 50,000 triangles: write docs/results-policies.csv first")
    arguments = parser.parse_args()
    listed = rows()
    if arguments.measure:
        measure(arguments.measure[0], arguments.measure[1:], listed)
    expect_prices(listed)
    stale = []
    for file, before, after, copy in COPIES:
        path = ROOT / file
        text = path.read_text(encoding="utf-8")
        place = re.search(f"({before})(.*?)({after})", text, re.S)
        if not place:
            sys.exit(f"policies.py: {file} has no place for the policies: {before}")
        if place[2] != copy(listed):
            stale.append(file)
            if not arguments.check:
                path.write_text(text[:place.start(2)] + copy(listed) + text[place.end(2):], encoding="utf-8", newline="\n")
    if arguments.check and stale:
        sys.exit(f"policies.py: not as in policy.hpp: {', '.join(stale)}; run scripts/policies.py")


if __name__ == "__main__":
    main()
