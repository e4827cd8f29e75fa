#!/usr/bin/env python3
"""Claims: a program whose standard output cannot be written says so and fails, whatever it prints: a report, JSON, a dump of
megabytes, or a line of help that a buffer holds until the end.

    full_output_test.py BIN SCRATCH
"""
import pathlib
import subprocess
import sys

folder, scratch = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
scratch.mkdir(parents=True, exist_ok=True)
(scratch / "one.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
(scratch / "one.trace").write_text("restrip-trace 1\nclaim best\nt 0 1 2\nend 0\n")
COMMANDS = {
    "restrip": ("--help", "--version", "stats --help", "stats one.obj", "stats one.obj --json -", "convert one.obj -o - --to ply"),
    "restrip-generate": ("--help", "--version", "tables --help", "dump --family flip", "dump --family split --k 7"),
    "restrip-verify": ("--help", "explain --help", "rules --help"),
    "restrip-verify-automaton": ("--help",),
    "restrip-dump-tables": ("--help", "--max-k 3", "--max-k 7", "--digests --max-k 3", "--automaton --max-k 3"),
    "restrip-check": ("--help", "one.trace", "one.trace --json -"),
}
tried = 0
for program, lines in COMMANDS.items():
    if not (folder / program).exists():
        assert program == "restrip-check", program  # needs OCaml
        continue
    for line in lines:
        def run(output, command=(folder / program, *line.split())):
            with open(output, "wb") as file:
                return subprocess.run(command, stdout=file, stderr=subprocess.PIPE, text=True, check=False, cwd=scratch)
        good = run(scratch / "out")
        assert good.returncode == 0 and (scratch / "out").stat().st_size > 0, (program, line, good)
        full = run("/dev/full")
        assert full.returncode not in (0, -11, -6) and program in full.stderr, (program, line, full)
        tried += 1
programs = {path.name for path in folder.glob("restrip*") if "_" not in path.name}
assert programs - {"restrip-make-small-tables", "restrip-fuzz"} <= COMMANDS.keys(), programs
print(f"full output: {tried} commands, all fail with a sentence")
