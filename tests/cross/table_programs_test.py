#!/usr/bin/env python3
"""Claim: the programs that make and verify tables do what every option says, or refuse it with a sentence; they show
progress on a terminal only; counts of one are singular.

  table_programs_test.py BIN ROOT
"""
import os
import pty
import re
import subprocess
import sys
import tempfile
from pathlib import Path

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
    ("restrip-verify-automaton --digest-max-k 8", "--digest-max-k requires --digest-command"),
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


def main():
    folder, root = Path(sys.argv[1]), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as scratch_name:
        scratch = Path(scratch_name)
        places = {"out": scratch / "out", "bisect": root / "tables/operations/bisect.json",
                  "certificate": root / "tables/certificates/operations/bisect.cert"}
        programs = ("restrip-generate", "restrip-verify", "restrip-verify-automaton", "restrip-dump-tables")
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


main()
