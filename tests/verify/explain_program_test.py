#!/usr/bin/env python3
"""Claims: `restrip-verify explain` and `rules` end with the codes that they state; the examples of their --help run; bad
input is refused with its place, and nothing is written; JSON is whole; one altered row of a rule set is
found and named, and what is printed with it explains it.

  explain_program_test.py BIN ROOT SCRATCH
"""
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

bin_folder, root, scratch = Path(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3])
shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)


def run(command, code, says=""):
    done = subprocess.run(f"PATH={bin_folder}:$PATH; {command}", shell=True, cwd=scratch, capture_output=True, text=True)
    assert done.returncode == code and says in done.stdout + done.stderr, (command, code, says, done)
    return done.stdout


def verify(arguments, code, says=""):
    return run("restrip-verify " + arguments, code, says)


# The examples of the help.
for command, code in (("explain", 1), ("rules", 0)):
    run(re.search(r"Example:\n +(.*)", verify(command + " --help", 0))[1], code)

# Verdicts, text and JSON the same.
split = "explain --family split --k 5 --at 2 --before 18 --ports 5"
bisect = f"explain --operation {root}/tables/operations/bisect.json --before 1 --ports 0"
for arguments, code, verdict in (
        (split, 0, None), (split + " --after 109", 0, "best"), (split + " --after 0", 1, "worse"),
        (split + " --after 255", 1, "not valid"), (split + " --after 1 --ports-after 4", 1, "not valid"),
        ("explain --family flip --before 0 --ports 6 --after 0", 1, "unsound"),
        ("explain --family flip --before 0 --ports 6 --after 1 --ports-after 4", 0, "equally good"),
        ("explain --family open-split --k 4 --at 0,2 --before 0 --ports 1 --after 0", 1, "worse"), (bisect, 0, None),
        (split.replace("18", "0x12") + " --after 0x6d", 0, "best")):
    verify(arguments, code, f"\nverdict   {verdict}" if verdict else "\nwhy       ")
    report = json.loads(verify(arguments + " --json -", code))
    assert report.get("verdict") == verdict, report
    assert report["cheaper"] == sum(one["excluded"] for one in report["sets"]), report
    assert (verdict == "unsound") == bool((report.get("obstacle") or {}).get("world")), report

# Bad input.
shutil.copy(root / "tables/operations/bisect.json", scratch / "own.json")
for arguments, says in (
        (split.replace("18", "31"), "not a valid configuration: triangle t0 has 3 solid edges"),
        (split.replace("18", "32"), "--before 32: expected a mask of at most 5 bits, decimal as in dumps or hexadecimal after 0x"),
        (split + " --after zz", "--after zz: expected a mask of at most 8 bits"),
        (split + " --ports-after 5", "--ports-after requires --after"),
        (split.replace("--at 2", "--at 5"), "split has no position (5, 5)"),
        (split.replace("--at 2", ""), "split needs the numbers k, a: --k gives the first, --at the others"),
        (bisect + " --k 3", "bisect has no numbers: leave out --k and --at"),
        (split.replace("--k 5", "--k 9"), "split k 9 a 2 has 9 ports, at most 8 are searched"),
        (split.replace("split", "spilt"), "--family spilt: expected one of split collapse"),
        (bisect.replace(str(root), "nowhere"), "nowhere/tables/operations/bisect.json: no such file"),
        ("--max-k 4 " + split, "--max-k cannot be used with a subcommand"),
        (split + " --json why.txt", "why.txt"),
        ("explain --operation own.json --before 1 --ports 0 --json own.json", "own.json"),
        ("rules nowhere.csv", "nowhere.csv: no such file")):
    verify(arguments + (" --json why.json" if "--json" not in arguments else ""), 2, says)
    assert not list(scratch.glob("why.*")), arguments

# Rule sets: a good one, one with one bad row, and files that are not rule sets.
families = {"split": 5, "collapse": 4, "open-split": 3, "open-collapse": 3, "boundary-split": 4, "boundary-collapse": 4}
for family, k in families.items():
    run(f"restrip-generate dump --family {family} --k {k} > rules.csv", 0)
    verify("rules rules.csv", 0, f"{family}: ")
run("restrip-generate dump --family flip > rules.csv", 0)
verify("rules rules.csv", 0, "flip: ")
operations = sorted((root / "tables/operations").glob("*.json")) + sorted((root / "tests/corpus/operations/families").glob("*.json"))
assert len(operations) > 12
for file in operations:
    max_k = " --max-k 4" * ("numbers" in json.loads(file.read_text()))
    run(f"restrip-generate dump --operation {file}{max_k} > rules.csv", 0)
    text = verify(f"rules rules.csv --operation {file}", 0, f"{file.stem}: ")
    assert re.search(r"\nwithout a row +0\n", text) and "positions without any row" not in text, text
run(f"restrip-generate dump --operation {operations[0]} --max-k 3", 2, "not a family, so --max-k has no effect")
one, other = ({"name": name, "before": [["a", "b", "c"]], "after": [["a", "b", "c"]]} for name in ("one", "other"))
(scratch / "list.json").write_text(json.dumps({"restrip_operation": 1, "operations": [one, other]}))
run("restrip-generate dump --operation list.json", 2, "dump a file of one at a time")
run("restrip-generate dump --family split --k 5 > rules.csv", 0)
rows = (scratch / "rules.csv").read_text().splitlines()
(scratch / "marked.csv").write_bytes(b"\xef\xbb\xbf" + "\r\n".join([*rows, ""]).encode())  # as spreadsheets write it
verify("rules marked.csv", 0, f"split: {len(rows) - 1:,} rows")
for column, verdict in ((4, "worse|unsound|not valid"), (5, "best|equally good"), (2, "not a configuration")):
    words = rows[700].split(",")
    words[column] = {2: "31", 4: "0", 5: str(int(words[5]) + 1)}[column]
    (scratch / "bad.csv").write_text("\n".join(rows[:700] + [",".join(words)] + rows[701:]) + "\n")
    found = re.search(r"\nline 701: (.*?): .*\n  restrip-verify (.*)\n", verify("rules bad.csv", 1))
    assert re.fullmatch(verdict, found[1]), found
    verify(found[2], *((2, "not a valid configuration: ") if column == 2 else (int(column == 4), f"verdict   {found[1]}")))
    report = json.loads(verify("rules bad.csv --json -", 1))
    assert report["rows"] == len(rows) - 1 and len(report["worst"]) == 1, report
    assert [report["best"] == report["rows"], report["misstated"], report["not_configurations"]] == [column == 5, int(column != 2), int(column == 2)], report
    assert report["configurations_without_row"] == len(report["first_without_row"]) == int(column == 2), report
run("for k in 3 4; do restrip-generate dump --family split --k $k; done > rules.csv", 0)
verify("rules rules.csv", 0, "split: 364 rows at 3 positions")
(scratch / "some.csv").write_text("\n".join(rows[:11]) + "\n")
report = json.loads(verify("rules some.csv --json -", 0))
assert report["configurations_without_row"] == 572 - 10 and report["positions_without_rows"] == ["k 5 a 2"], report
for text, says in (("k,b\n1,2\n", "bad.csv:1: expected one of these headers"), (rows[0] + "\n", "bad.csv: has no rows"),
                   (rows[0] + "\n" + rows[1], "newline"), ("\n".join((rows[0], rows[1], rows[1], "")), "bad.csv:3: the configuration of line 2 again"),
                   (rows[0] + "\n5,1,0,0\n", "bad.csv:2: expected 7 columns"), (rows[0] + "\n5,1,0,99,0,0,0\n", "bad.csv:2: expected 0 to 31 in column 4"),
                   (rows[0] + "\n5,9,0,0,0,0,0\n", "split has no position (5, 9)")):
    (scratch / "bad.csv").write_text(text)
    verify("rules bad.csv", 2, says)

# Numbers beyond a byte, and beyond 32 bits, are not taken for the rest of a division.
for more in (1 << 8, 1 << 32, -(1 << 32), 1 << 64):
    for column in (5, 6):
        words = rows[1].split(",")
        words[column] = str(int(words[column]) + more)
        (scratch / "bad.csv").write_text("\n".join([rows[0], ",".join(words), *rows[2:]]) + "\n")
        verify("rules bad.csv", 2, f"bad.csv:2: expected {'-28 to 28 in column ' + str(column + 1) if more < 1 << 63 else 'a decimal number'}")

# Two operations with the same columns: one must be named, and the commands that are printed name it.
first, second = "turned-over", "left-alone"
side, turned = [["a", "b", "c"], ["b", "a", "d"]], [["c", "a", "d"], ["d", "b", "c"]]
(scratch / "two.json").write_text(json.dumps({"restrip_operation": 1, "operations": [
    {"name": first, "before": side, "after": turned}, {"name": second, "before": side, "after": side}]}))
(scratch / "a.csv").write_text("inner,ports,inner_after,ports_after\n0,0,1,0\n1,6,1,6\n")
verify("rules a.csv --operation two.json", 2, f"a.csv:1: the columns of {first} and of {second}: expected --family with one of these names")
verify(f"rules a.csv --operation two.json --family {second}", 0, f"{second}: 2 rows")
text = verify(f"rules a.csv --operation two.json --family {first}", 1)
command = re.search(r"\nline 3: not valid: .*\n  restrip-verify (explain --operation two.json --family .*)\n", text)[1]
verify(command, 1, "verdict   not valid")
verify("rules a.csv --operation two.json --family third", 2, f"--family third: expected one of {first} {second}")
verify("rules a.csv --family split", 2, "a.csv:1: expected one of these headers")
print("explained")
