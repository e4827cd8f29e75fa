#!/usr/bin/env python3
"""Claims about all programs: options, JSON reports, and output that cannot be written (see the three functions).

  programs_test.py BIN ROOT SCRATCH
"""
import json
import os
import pty
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

BIN, ROOT, SCRATCH = Path(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3]).resolve()
COMMANDS = {
    "restrip": ("--help", "--version", "stats --help", "stats one.obj", "stats one.obj --json -", "convert one.obj -o - --to ply"),
    "restrip-generate": ("--help", "--version", "tables --help", "dump --family flip", "dump --family split --k 7"),
    "restrip-verify": ("--help", "automaton --help", "explain --help", "rules --help"),
    "restrip-dump-tables": ("--help", "--max-k 3", "--max-k 7", "--digests --max-k 3", "--automaton --max-k 3"),
    "restrip-check": ("--help", "one.trace", "one.trace --json -"),
}
REFUSED = [
    ("restrip-generate tables --cost 5,2,0 --language c --out {out}", "The following arguments were not expected: 5,2,0 --cost"),
    ("restrip-generate dump --family flip --k 4", "--family flip: it has one position, without --k"),
    ("restrip-verify --headers --dump-command false --tables-dir tables", "--headers reads no certificates, so --tables-dir has no effect"),
    ("restrip-verify --headers --dump-command false --threads 2", "so --threads has no effect; leave it out"),
    ("restrip-verify --family split --dump-command false --digest-command false", "--digest-command judges all rules, so --family has no effect"),
    ("restrip-verify --family open-split", '"open-split" has no certificate, because the automaton answers it; give --dump-command'),
    ("restrip-verify --digest-command false", "--digest-command requires --dump-command"),
    ("restrip-verify --max-k 9 --dump-command false --digest-command false", "--digest-command judge fans of up to 8 triangles"),
    ("restrip-verify --operation {bisect} --dump-command false --certificate {certificate}", "--dump-command with --operation needs --header"),
    ("restrip-verify --operation {bisect} --max-k 4 --certificate {certificate}", "describes no family, so --max-k has no effect"),
    ("restrip-verify --header {bisect}", "--header requires --operation"),
    ("restrip-generate automaton --operation {bisect} --language c --out {out}", "excludes"),
    ("restrip-verify automaton --digest-max-k 8", "--digest-max-k requires --digest-command"),
    ("restrip-dump-tables --digests --max-k 9", "the tables answer fans of up to 8 triangles"),
]
JOIN = """{"restrip_operation": 1, "name": "join", "constraint": "strips",
  "before": [["m", "a", "b"], ["m", "b", "c"], ["m", "c", "a"]], "after": [["a", "b", "c"]]}
"""
ONE = """{"restrip_operation": 1, "name": "one", "constraint": "matching",
  "before": [["a", "b", "c"]], "after": [["a", "b", "c"]], "boundary": [["b", "a"]]}
"""


def on_terminal(command):
    """Standard error on a terminal; None if there are no terminals, as in a chroot without /dev/pts."""
    try:
        ours, theirs = pty.openpty()
    except OSError as error:
        print(f"left out: progress on a terminal: {error}")
        subprocess.run(command, capture_output=True, check=True)
        return None
    subprocess.run(command, stderr=theirs, stdout=subprocess.DEVNULL, check=True)
    os.close(theirs)
    shown = b""
    try:
        while block := os.read(ours, 4096):
            shown += block
    except OSError:  # the end, on Linux
        pass
    os.close(ours)
    return shown.decode()


def options():
    """Every option does what it says, or is refused with a sentence; progress is shown on a terminal only; one is singular."""
    folder, root = BIN, ROOT
    with tempfile.TemporaryDirectory() as scratch_name:
        scratch = Path(scratch_name)
        places = {"out": scratch / "out", "bisect": root / "tables/operations/bisect.json",
                  "certificate": root / "tables/certificates/operations/bisect.cert"}
        programs = ("restrip-generate", "restrip-verify", "restrip-dump-tables")
        versions = {subprocess.run([folder / name, "--version"], capture_output=True, check=True).stdout for name in programs if (folder / name).exists()}
        if len(versions) != 1 or not re.fullmatch(rb"\d+\.\d+\.\d+\n", *versions):
            sys.exit(f"--version: {versions}")
        for line, sentence in REFUSED:
            words = line.format(**places).split()
            if not (folder / words[0]).exists():
                raise SystemExit(f"{words[0]} is not built")
            done = subprocess.run([folder / words[0], *words[1:]], capture_output=True, text=True, check=False)
            if done.returncode != 2 or sentence not in done.stderr:
                raise SystemExit(f"{line}: ended with {done.returncode}: {done.stderr}")
        if places["out"].exists():
            raise SystemExit("something was written all the same")

        generate, verify = folder / "restrip-generate", folder / "restrip-verify"
        (scratch / "join.json").write_text(JOIN, encoding="utf-8")
        done = subprocess.run([generate, "rules", "--operation", scratch / "join.json", "--out", places["out"]], capture_output=True, text=True,
                              check=False)
        if done.returncode != 2 or not re.search(r"operation join: the configuration 0 3 \(.*as in a dump\) has no sound recolouring", done.stderr):
            raise SystemExit(done.stderr)

        # Progress, also of the reasons, if they take more than a moment.
        operation = root / "tests/corpus/operations/seven-to-five.json"
        rules = [generate, "rules", "--operation", operation, "--out", places["out"]]
        shown = on_terminal(rules)
        for words in ("finding reasons … 99 %", "finding rules … 99 %", "\r\x1b[K"):
            if shown is not None and words not in shown:
                raise SystemExit(f"a terminal shows {shown!r}")
        done = subprocess.run(rules, capture_output=True, text=True, check=True)
        if done.stderr or not re.fullmatch(r"seven-to-five +16384 configurations +821 rules +32768 bytes\n", done.stdout):
            raise SystemExit(done.stdout + done.stderr)

        # One of each.
        (scratch / "one.json").write_text(ONE, encoding="utf-8")
        done = subprocess.run([generate, "rules", "--operation", scratch / "one.json", "--out", places["out"]], capture_output=True, text=True,
                              check=True)
        printed = done.stdout + subprocess.check_output(
            [verify, "--operation", scratch / "one.json", "--certificate", places["out"] / "certificates/operations/one.cert"], text=True)
        printed += subprocess.check_output([verify, "--tables-dir", root / "tables", "--family", "flip"], text=True)
        printed += subprocess.check_output([generate, "tables", "--max-k", "3", "--out", places["out"]], text=True)
        if found := re.findall(r"(?<![\d.,])1 +[a-z]+s\b(?! =)", printed):
            raise SystemExit(f"{printed}\n{found}")
        if "1 section " not in printed or "costs above 1 strip," not in printed:
            raise SystemExit(printed)


def without_times(report):
    if isinstance(report, dict):
        return {name: without_times(value) for name, value in report.items() if "seconds" not in name}
    return [without_times(value) for value in report] if isinstance(report, list) else report


def json_reports():
    """Every command with a report takes --json FILE in one way. With a file it prints its text, and the file is JSON; with - standard
    output is the same JSON alone; a name that does not end in .json is refused before any work, and nothing is written."""
    scratch = SCRATCH / "json_reports"
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    bisect, certificate = ROOT / "tables/operations/bisect.json", ROOT / "tables/certificates/operations/bisect.cert"
    mesh = scratch / "made.obj"

    def run(command, *more, code=0):
        done = subprocess.run([str(word) for word in (BIN / command[0], *command[1:], *more)], capture_output=True, text=True)
        assert done.returncode == code, (command, more, done)
        return done

    run(["restrip", "make-mesh", "--triangles", "200", "-o", mesh])
    commands = {
        "automaton": (["restrip-generate", "automaton", "--out", scratch / "automaton"], "classes"),
        "rules": (["restrip-generate", "rules", "--operation", bisect, "--out", scratch / "rules"], "operations"),
        "tables": (["restrip-generate", "tables", "--max-k", "3", "--out", scratch / "tables"], "files"),
        "operation": (["restrip-verify", "--operation", bisect, "--certificate", certificate], "claims"),
        "explain": (["restrip-verify", "explain", "--operation", bisect, "--before", "1", "--ports", "0"], "sets"),
        "families": (["restrip-verify", "--tables-dir", ROOT / "tables", "--family", "flip"], "claims"),
        "arcs": (["restrip-verify", "automaton", "--tables-dir", ROOT / "tables", "--max-k", "3", "--every", "1000"], "claims"),
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


def full_output():
    """A program whose standard output cannot be written says so and fails, whatever it prints: a report, JSON, a dump of megabytes, or
    a line of help that a buffer holds until the end."""
    scratch = SCRATCH / "full_output"
    scratch.mkdir(parents=True, exist_ok=True)
    (scratch / "one.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (scratch / "one.trace").write_text("restrip-trace 1\nclaim best\nt 0 1 2\nend 0\n")
    tried = 0
    for program, lines in COMMANDS.items():
        if not (BIN / program).exists():
            assert program == "restrip-check", program  # needs OCaml
            continue
        for line in lines:
            def run(output, command=(BIN / program, *line.split())):
                with open(output, "wb") as file:
                    return subprocess.run(command, stdout=file, stderr=subprocess.PIPE, text=True, check=False, cwd=scratch)
            good = run(scratch / "out")
            assert good.returncode == 0 and (scratch / "out").stat().st_size > 0, (program, line, good)
            full = run("/dev/full")
            assert full.returncode not in (0, -11, -6) and program in full.stderr, (program, line, full)
            tried += 1
    programs = {path.name for path in BIN.glob("restrip*") if "_" not in path.name}
    assert programs - {"restrip-make-small-tables", "restrip-fuzz"} <= COMMANDS.keys(), programs
    print(f"full output: {tried} commands, all fail with a sentence")


options()
json_reports()
full_output()
