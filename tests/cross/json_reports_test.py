#!/usr/bin/env python3
"""Claims: every command with a report takes --json FILE in one way. With a file it prints its text, and the file is JSON;
with - standard output is the same JSON alone; a name that does not end in .json is refused before any work, and nothing is
written.

    json_reports_test.py FOLDER_OF_PROGRAMS ROOT SCRATCH
"""
import json
import pathlib
import shutil
import subprocess
import sys

programs, root, scratch = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]).resolve()
shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)
bisect, certificate = root / "tables/operations/bisect.json", root / "tables/certificates/operations/bisect.cert"
mesh = scratch / "made.obj"


def run(command, *more, code=0):
    done = subprocess.run([str(word) for word in (programs / command[0], *command[1:], *more)], capture_output=True, text=True)
    assert done.returncode == code, (command, more, done)
    return done


def without_times(report):
    if isinstance(report, dict):
        return {name: without_times(value) for name, value in report.items() if "seconds" not in name}
    return [without_times(value) for value in report] if isinstance(report, list) else report


run(["restrip", "make-mesh", "--triangles", "200", "-o", mesh])
commands = {
    "automaton": (["restrip-generate", "automaton", "--out", scratch / "automaton"], "classes"),
    "rules": (["restrip-generate", "rules", "--operation", bisect, "--out", scratch / "rules"], "operations"),
    "tables": (["restrip-generate", "tables", "--max-k", "3", "--out", scratch / "tables"], "files"),
    "operation": (["restrip-verify", "--operation", bisect, "--certificate", certificate], "claims"),
    "explain": (["restrip-verify", "explain", "--operation", bisect, "--before", "1", "--ports", "0"], "sets"),
    "families": (["restrip-verify", "--tables-dir", root / "tables", "--family", "flip"], "claims"),
    "arcs": (["restrip-verify-automaton", "--tables-dir", root / "tables", "--max-k", "3", "--every", "1000"], "claims"),
}
for name, (command, member) in commands.items():
    wrong = run(command, "--json", scratch / "report.txt", code=2)
    assert "report.txt" in wrong.stderr and not (scratch / "report.txt").exists() and not wrong.stdout, (name, wrong)
    alone = json.loads(run(command, "--json", "-").stdout)
    file = scratch / (name + ".json")
    text = run(command, "--json", file).stdout
    assert text and not text.startswith("{"), (name, text)
    assert member in alone and without_times(json.loads(file.read_text())) == without_times(alone), name

for path in json.loads((scratch / "tables.json").read_text())["files"]:
    assert (scratch / "tables" / path["path"]).stat().st_size == path["bytes"], path
print("%d commands" % len(commands))
