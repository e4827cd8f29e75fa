#!/usr/bin/env python3
"""The steps of docs/toolkit.md, done as they stand there: files, commands and program; each must print what the page says. Then the
table is altered: the command that proves it must refuse it.

  toolkit_page_test.py PROGRAMS COMPILER
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLE = "rules/include/restrip/tables/operations/pair_flip.hpp"


def blocks(page):
    """(language, text, name) of every fenced block in order; `name` is the file that it is to be saved as, or empty."""
    return [(language, text, name) for name, language, text in
            re.findall(r"^(?:[^\n]*Save this as `([\w.-]+)`:\n\n)?```(\w+)\n(.*?)^```$", page, re.M | re.S)]


def run(command, folder, may_fail=False):
    done = subprocess.run(command, cwd=folder, shell=True, text=True, capture_output=True, check=False)
    if (done.returncode != 0) != may_fail:
        raise SystemExit(f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


DEMO_PROGRAMS = re.search(r"^  bin=(build.*)$", (ROOT / "scripts/demo.sh").read_text(encoding="utf-8"), re.M)[1]


def main():
    programs, compiler = sys.argv[1:]
    building = f"{compiler} -std=c++20 -Wall -Wextra -Werror -Irules/include -I{ROOT}/tables/include"
    printed = proof = None
    compared = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for language, text, saved_as in blocks((ROOT / "docs/toolkit.md").read_text(encoding="utf-8")):
            if saved_as:
                (folder / saved_as).write_text(text, encoding="utf-8")
            if saved_as == "use.cpp":
                printed = run(f"{building} use.cpp -o use && ./use", folder)
            elif language == "sh":
                command = re.sub(r"^python3 ", f"{sys.executable} {ROOT}/", text.replace(DEMO_PROGRAMS + "/", programs + "/"), flags=re.M)
                command = "set -e\n" + command.replace("g++ -std=c++20 -Irules/include -Itables/include", building)
                printed = run(command, folder)
                proof = command if "./print-pair-flip" in command else proof
            elif language == "text":
                if printed is None or not printed.endswith(text):
                    raise SystemExit(f"docs/toolkit.md says\n{text}but this was printed:\n{printed}")
                compared += 1
        if compared != 7 or proof is None:
            raise SystemExit(f"docs/toolkit.md: {compared} printed results were compared, not 7, or nothing judges the table")
        table = (folder / TABLE).read_text(encoding="utf-8")
        if (folder / "pages/pair-flip.html").read_text(encoding="utf-8").count("<tr id=") != 4 or "p3</text>" not in (folder / "pair-flip.svg").read_text(encoding="utf-8"):
            raise SystemExit("the page has not 4 rules, or the picture not 4 ports")
        altered, count = re.subn(r"(\{\n +)(\d+)", lambda number: number[1] + str(int(number[2]) ^ 1), table, count=1)
        if count != 1:
            raise SystemExit(f"{TABLE} has no list of numbers")
        (folder / TABLE).write_text(altered, encoding="utf-8")
        if "pair-flip" not in run(proof, folder, may_fail=True):
            raise SystemExit("the altered table was refused without a word on it")
        # Also where nobody compiled it anew: the verifier reads the header itself.
        (folder / TABLE).write_text(table, encoding="utf-8")
        run(proof, folder)
        (folder / TABLE).write_text(altered, encoding="utf-8")
        judging = re.sub(r"^.*-o print-pair-flip\n", "", proof, flags=re.M)
        if "the header's text" not in run(judging, folder, may_fail=True):
            raise SystemExit("the altered header was accepted where the program was compiled before")


main()
