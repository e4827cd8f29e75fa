#!/usr/bin/env python3
"""How each claim is checked: docs/coverage.csv, and the table made from it.

  scripts/coverage.py read FOLDER CHECK…     the reports FOLDER/CHECK.log have all lines that are expected, and no other claim
  scripts/coverage.py record FOLDER CHECK…   they become the rows of these checks in docs/coverage.csv
  scripts/coverage.py compare FOLDER CHECK…  the rows of these checks in docs/coverage.csv are what the reports say
  scripts/coverage.py table                  the table of docs/explanation/what-is-proven.md
  scripts/coverage.py check [ROOT]           each claim has a row, each row a check of scripts/prove.sh, each check a row, and
                                             each theorem that is expected is in verify/formal/Main.v

scripts/prove.sh runs the checks and then "record", so every row comes from a line that a run has printed. A report with
a failure, without a line that REPORTS expects, or with a claim that neither REPORTS nor LEFT_OUT has, is refused. Exit
code: 0 all is well, 1 not.
"""
import csv
import json
import re
import sys
from collections import namedtuple
from pathlib import Path

FANS = ["split", "collapse", "open split", "open collapse", "boundary split", "boundary collapse"]
ALL = FANS + ["flip"]
TABLED = ["split", "collapse", "flip"]  # the automaton answers the others
CERTIFICATES, TABLES, AUTOMATON = "certificates", "compiled tables", "compiled automaton"
SEARCH, COQ = "every recolouring tried", "Coq"
RULE = ("Complete", "Sound", "Locally optimal")
ROOT = Path(__file__).resolve().parent.parent
Row = namedtuple("Row", "claim operation k how read check")

# A line of a report, its claims, the method, and the input that was read. The line or this table names the operations;
# k is in the line, or the largest k of the report, or "every", or irrelevant.
Line = namedtuple("Line", "pattern claims how read operations k", defaults=(None, None))


def holds(claim, *rest, subject=r"(?P<operation>[a-z-]+)", **more):
    """A line of restrip-verify."""
    return Line(rf"^holds +{subject} +{claim} ", *rest, **more)


def automaton_lines():
    """The lines of restrip-verify automaton."""
    line = lambda *words, **more: holds(*words, subject="automaton", operations=FANS, **more)
    return [
        line("every meeting is sound and best", ("Sound", "Locally optimal", "Checkable"), "every pair of kinds of arcs", CERTIFICATES, k="every"),
        line("every number of the header is the certificate's", ("Compiled",), "compared", AUTOMATON, k="every"),
        line("every answer of the header is the certificate's +k <= (?P<k>[0-9]+),", ("Compiled", "Reported"), "compared", AUTOMATON),
        line("every answer with k = (?P<k>[0-9]+) is sound and best", ("Sound", "Locally optimal"), SEARCH, CERTIFICATES),
    ]


RULES = [
    holds("every valid configuration has a row", ["Complete"], SEARCH, CERTIFICATES),
    holds("every row is sound", ["Sound"], SEARCH, CERTIFICATES),
    holds("(as good, )?no sound recolouring has fewer [a-z_+ ]+[a-z]", ["Locally optimal"], SEARCH, CERTIFICATES),
    holds("every rule has a reason why nothing is preferred to it", ["Checkable"], "reasons", CERTIFICATES),
]
# Claims of the verifiers that are no claims of docs/explanation/what-is-proven.md, and why.
LEFT_OUT = {
    "the files match the MANIFEST": "of files, not of rules",
    "the files have the listed numbers of rows": "of files, not of rules",
    "every row has a valid configuration": "a row too many does no harm",
    "no port is taken, and ports that must stay are kept": "part of soundness",
    "copies follow from rules by symmetry": "copies are judged like rules",
    "the stated numbers": "of the certificate, not of rules",
    "the published counts": "of the problem, not of rules",
    "positions without rules are images of ones with rules": "their answers are judged in compiled tables",
    "no answer exceeds what the family claims": "the claims are in the files of operations",
    "adds at most": "of indices; docs/explanation/theory.md proves it for every k",
    "the header is exactly the text of a table": "of a text, so that it can be compiled",
    # of the automaton, on the way to its first claim of the page
    "an arc and a following letter matter by their cases": "a premise of the meetings",
    "each witness is a shortest arc of its class": "a premise of the meetings",
    "the values are the least costs": "a premise of the meetings",
    "what a letter costs": "a premise of the meetings",
    "every case comes from the stated case": "a premise of the meetings",
    "every closing is sound and best": "the meetings' claim for closed fans",
    "every answer costs the same as the rule of": "compared with other certificates",
}
ANSWERS = [
    (r"every answer is the certificate's row, in its positions +[^,]*dump,", ["Compiled"], "compared", TABLES),
    ("every answer is sound and best, in other positions", ["Sound", "Locally optimal"], SEARCH, TABLES),
    ("every answer reports what it changes", ["Reported"], "counted before and after", TABLES),
]
JUDGED = r"^  judged: (?P<operation>[a-z ]+): \d+(, k <= \d+)?$"
THEOREM = r"^{} +[0-9]+  Closed under the global context$"
REPORTS = {
    "search": RULES + [
        holds("no rule costs above [0-9]+ strips?, isolates above [0-9]+", ["Bounded"], SEARCH, CERTIFICATES),
    ] + [holds(*answer, subject="shipped headers", operations=TABLED if answer[1] == ["Compiled"] else "answered") for answer in ANSWERS],
    "automaton": automaton_lines(),
    # Shipped operation files have no positions without rules.
    "operations": RULES + [holds(*answer) for answer in ANSWERS if "other positions" not in answer[0]] + [
        holds("every answer is the certificate's row, in its positions +the header's text,", ["Compiled"], "compared", "header texts"),
    ],
    "reasons": [
        Line(r"/(?P<operation>[a-z-]+)\.cert: \d+ rules are sound and have their reasons", ["Sound", "Locally optimal", "Checkable"],
             "reasons, without a search", CERTIFICATES),
    ],
    "run": [
        Line(JUDGED, ["Reported"], "the operations of a run, judged by functions extracted from Coq", "a trace", k="those met"),
        Line(JUDGED, ["Sound", "Locally optimal"], "the operations of a run with the cost of strips, judged by functions extracted from Coq", "a trace", k="those met"),
    ],
    "theorem": [
        Line(THEOREM.format("rules_right"), [*RULE, "Bounded"], COQ, TABLES, FANS),
        Line(THEOREM.format("flip_right"), [*RULE, "Bounded"], COQ, TABLES, ["flip"]),
        Line(THEOREM.format("every_rule_right"), RULE, COQ, "nothing: a fold written in Coq", FANS, "every"),
        Line(THEOREM.format("correct_tables_cost"), ["Bounded"], COQ, "nothing: every correct table costs the same", FANS, "every"),
        Line(THEOREM.format("automaton_serves"), RULE, COQ, "numbers of the compiled automaton", FANS, "every"),
        Line(THEOREM.format("answers_tell"), ["Reported"], COQ, TABLES, ALL, "stated"),
        Line(THEOREM.format("automaton_told"), ["Reported"], f"{COQ}, digests compared", AUTOMATON, FANS, "looked up"),
        Line(THEOREM.format("automaton_looked_up"), ["Compiled"], f"{COQ}, digests compared", AUTOMATON, FANS, "looked up"),
        Line(THEOREM.format("sequences_right"), ["Sequences"], COQ, TABLES, FANS),
        Line(THEOREM.format("every_sequence_right"), ["Sequences"], COQ, "nothing: every correct table", FANS, "every"),
        Line(THEOREM.format("whole_mesh"), ["Whole mesh"], COQ, "nothing: every valid colouring", ["any mesh"], "every"),
    ],
}

THEOREMS = [line.pattern.split()[0].lstrip("^") for line in REPORTS["theorem"]]


class Wrong(Exception):
    pass


def operations_of(line, found, report):
    """The names that a line says, as notation.md has them."""
    if line.operations == "answered":
        listed = re.search(r"^answers of the shipped headers proved: .*\((.*)\)$", report, re.M)
        said = [name.rsplit(" ", 1)[0] for name in listed[1].split(", ")] if listed else []
    else:
        said = line.operations or [found["operation"]]
    names = [name.replace("_", "-") for name in said]
    names = [new for name in names for new in (["open-collapse", "boundary-collapse"] if name == "fan-collapse" else [name])]
    return [name.replace("-", " ") if name.replace("-", " ") in ALL else name for name in names]


def k_of(line, found, report):
    """"every", or the largest; 0 if there is no k, as for operation files, or if no k is covered completely."""
    if line.k == "every":
        return line.k
    if line.k == "those met":
        return 0
    if "k" in found.groupdict():
        return int(found["k"] or 0)
    words = {"stated": r"^the stated changes of answers .*k <= (\d+)", "looked up": r"^the automaton's answers .*k <= (\d+)"}.get(line.k, r"(?:^|[ ,])k <= (\d+)")
    return max(map(int, re.findall(words, report, re.M)), default=0)


def unknown_claims(check, report):
    """The claims of a report that neither REPORTS nor LEFT_OUT has."""
    return [line for line in report.splitlines() if re.match("(holds|FAILS) ", line) and not any(words in line for words in LEFT_OUT)
            and not any(re.search(known.pattern, re.sub("^FAILS", "holds", line)) for known in REPORTS[check])]


def rows_of(check, report):
    """The rows of a report; raises Wrong if it is not complete."""
    if re.search(r"^FAILS|NOT ", report, re.M):
        raise Wrong(f"{check}: something fails")
    read = re.findall(r"read: (.*)$", report, re.M)
    largest = {}  # k for the rest of a row
    for line in REPORTS[check]:
        every = list(re.finditer(line.pattern, report, re.M))
        if not every:
            raise Wrong(f"{check}: no line matches {line.pattern}")
        if read and not line.read.startswith("nothing") and not any(line.read in words for words in read):
            raise Wrong(f"{check}: {line.read} were not read")
        for found in every:
            k = k_of(line, found, report)
            for operation in operations_of(line, found, report):
                for claim in line.claims:
                    what = claim, operation, line.how, line.read, k == "every"
                    largest[what] = k if k == "every" else max(k, largest.get(what, 0))
    for line in unknown_claims(check, report):
        raise Wrong(f"{check}: a claim that is neither in the coverage nor left out: {line}")
    rows = {Row(claim, operation, str(k), how, read, check) for (claim, operation, how, read, _), k in largest.items()}
    return of_files(rows) if check == "operations" else rows


def of_files(rows):
    """One row in place of the rows of all operation files, or of those of strips, which have reasons; raises Wrong if one is missing."""
    files = {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in ROOT.glob("tables/operations/*.json")}
    strips = {name for name, file in files.items() if file["constraint"] == "strips"}
    names = {}
    for row in rows:
        names.setdefault(row._replace(operation=""), set()).add(row.operation)
    for row, found in names.items():
        if found not in (set(files), strips):
            raise Wrong(f"operations: {row.claim}: the report lacks {', '.join(sorted(set(files) - found))}")
    return {row._replace(operation="operation files" if found == set(files) else "operation files of strips") for row, found in names.items()}


def bold_of(text, heading):
    """The names of a numbered list "1. **Name.** …" below a heading."""
    return re.findall(r"^\d+\. \*\*([^*]+?)\.\*\*", text.split(f"\n{heading}\n")[1].split("\n## ")[0], re.M)


class Coverage:
    def __init__(self, root):
        self.root, self.path = root, root / "docs/coverage.csv"
        self.claims = bold_of((root / "docs/explanation/what-is-proven.md").read_text(encoding="utf-8"), "## What is claimed")
        self.guarantees = bold_of((root / "README.md").read_text(encoding="utf-8"), "## What is guaranteed")
        self.checks = re.findall(r"^ *check ([a-z]+) \"", (root / "scripts/prove.sh").read_text(encoding="utf-8"), re.M)
        self.theorems = re.findall(r"^Theorem (\w+)", (root / "verify/formal/Main.v").read_text(encoding="utf-8"), re.M)
        with open(self.path, encoding="utf-8", newline="") as file:
            self.rows = {Row(**row) for row in csv.DictReader(file)}

    def check(self):
        """Sentences about inconsistencies."""
        claimed, run = {row.claim for row in self.rows}, {row.check for row in self.rows}
        return (["docs/explanation/what-is-proven.md lists no claims, or README.md no guarantees"] if not self.claims or not self.guarantees else []) + \
            [f"{claim}: a claim without a row in docs/coverage.csv" for claim in self.claims if claim not in claimed] + \
            [f"{claim}: a guarantee of README.md that docs/explanation/what-is-proven.md does not claim" for claim in self.guarantees if claim not in self.claims] + \
            [f"{claim}: rows of docs/coverage.csv name it, and docs/explanation/what-is-proven.md does not claim it" for claim in sorted(claimed - set(self.claims))] + \
            [f"{check}: not a check of scripts/prove.sh" for check in sorted(run - set(self.checks))] + \
            [f"{check}: a check of scripts/prove.sh without a row" for check in self.checks if check not in run] + \
            [f"{name}: a theorem that is expected, and that verify/formal/Main.v does not have" for name in THEOREMS if name not in self.theorems]

    def read(self, folder, checks):
        """The rows that the reports of these checks make."""
        return {row for check in checks for row in rows_of(check, (folder / f"{check}.log").read_text(encoding="utf-8"))}

    def compare(self, folder, checks):
        """Sentences about rows that differ."""
        found, listed = self.read(folder, checks), {row for row in self.rows if row.check in checks}
        return [f"docs/coverage.csv has no row {','.join(row)}" for row in sorted(found - listed)] + \
            [f"docs/coverage.csv has the row {','.join(row)}, and no report makes it" for row in sorted(listed - found)]

    def record(self, folder, checks):
        self.rows = {row for row in self.rows if row.check not in checks and row.check in self.checks} | self.read(folder, checks)
        with open(self.path, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(Row._fields)
            writer.writerows(sorted(self.rows))

    def operations(self, names):
        for some, words in ((set(ALL), "all"), (set(FANS), "all but flips"), ({"any mesh"}, "any mesh")):
            if names == some:
                return words
        return ", ".join([name + "s" for name in ALL if name in names] + sorted(f"the {name}" for name in names - set(ALL)))

    def merged(self, wanted):
        """Cells of the rows with a wanted claim: claims, operations, k, how, read, check. Rows of one check
        that differ only in the operation or in the claim are merged."""
        some = {}
        for row in sorted(self.rows, key=lambda row: (list(REPORTS).index(row.check), row.k == "every", row)):
            some.setdefault(row[2:], {}).setdefault(row.claim, set()).add(row.operation)
        for (k, *rest), claims in some.items():
            for other in [claims for at, claims in some.items() if at[0] not in ("0", "every") and list(at[1:]) == rest]:
                for claim in [claim for claim in claims if k == "0" and claim in other]:
                    other[claim] |= claims.pop(claim)  # a flip has no k
        rows = []
        for (k, *rest), claims in some.items():
            of = {claim: self.operations(names) for claim, names in claims.items() if claim in wanted}
            for operations in dict.fromkeys(of.values()):
                listed = [claim for claim in wanted if of.get(claim) == operations]
                rows.append([", ".join(listed), operations, k if k == "every" else "–" if k == "0" else f"<= {k}", *rest])
        return sorted(rows, key=lambda row: wanted.index(row[0].split(", ")[0]))

    def table(self):
        return table_of(["claims", "operations", "k", "method", "input checked"], [list(cells) for cells in dict.fromkeys(tuple(cells) for *cells, _ in self.merged(self.claims))])


def table_of(head, lines):
    return "".join("| " + " | ".join(cells) + " |\n" for cells in [head, ["---"] * len(head), *lines])


def main():
    if len(sys.argv) > 3 and sys.argv[1] in ("read", "record"):
        getattr(Coverage(ROOT), sys.argv[1])(Path(sys.argv[2]), sys.argv[3:])
    elif len(sys.argv) > 3 and sys.argv[1] == "compare":
        sys.exit("\n".join(Coverage(ROOT).compare(Path(sys.argv[2]), sys.argv[3:])) or 0)
    elif sys.argv[1:] == ["table"]:
        print(Coverage(ROOT).table(), end="")
    elif sys.argv[1:2] == ["check"] and len(sys.argv) <= 3:
        faults = Coverage(Path(sys.argv[2]) if len(sys.argv) == 3 else ROOT).check()
        sys.exit("\n".join(faults) or 0)
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    try:
        main()
    except Wrong as wrong:
        sys.exit(f"coverage.py: {wrong}")
