#!/usr/bin/env python3
"""The steps of a page of docs/tutorials/, done as printed: files, commands and programs; each command must print what the page says
and write what it names. In the table of custom-operation.md a number is then altered: the command that proves it must refuse it.

  tutorials_test.py PAGE PROGRAMS COMPILER
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLE = "rules/include/restrip/tables/operations/divide_face.hpp"


def blocks(page):
    """(language, text, name) of every fenced block in order; `name` is the file that it is to be saved as, or empty."""
    return [(language, text, name) for name, language, text in
            re.findall(r"^(?:[^\n]*(?:\n[^\n]+)*?Save\s+this\s+as\s+`([\w.-]+)`[^\n]*(?:\n[^\n`]+)*:\n\n)?```(\w+)\n(.*?)^```$", page, re.M | re.S)]


def run(command, folder, may_fail=False):
    done = subprocess.run(command, cwd=folder, shell=True, text=True, capture_output=True, check=False)
    if (done.returncode != 0) != may_fail:
        raise SystemExit(f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def follow(page, programs, compiler, folder):
    """The commands of the page that were run, and how many outputs were compared."""
    printed, commands, compared = None, [], 0
    for language, text, saved_as in blocks(page):
        if saved_as:
            (folder / saved_as).write_text(text, encoding="utf-8")
        elif language == "sh":
            command = text.replace("build/programs/bin/", programs + "/").replace("g++ ", f"{compiler} -Wall -Wextra -Werror ")
            command = re.sub(r"-I(runtime|tables)/include", rf"-I{ROOT}/\1/include", command)
            command = command.replace("-Lbuild/programs/runtime ", f"-L{Path(programs).parent}/runtime ")
            command = "set -e\n" + re.sub(r"^python3 ", f"{sys.executable} {ROOT}/", command, flags=re.M)
            printed = run(command, folder)
            commands.append(command)
        elif language == "text":
            if printed is None or not printed.endswith(text):
                raise SystemExit(f"the page says\n{text}but this was printed:\n{printed}")
            compared += 1
    if compared == 0:
        raise SystemExit("the page compares nothing")
    return commands, compared


def refuse_altered_table(commands, folder):
    proof = next(command for command in commands if "./print-divide-face" in command)
    if (folder / "pages/divide-face.html").read_text(encoding="utf-8").count("<tr id=") != 3:
        raise SystemExit("the page of the atlas does not have 3 rules")
    table = (folder / TABLE).read_text(encoding="utf-8")
    altered, count = re.subn(r"(\{\n +)(\d+)", lambda number: number[1] + str(int(number[2]) ^ 1), table, count=1)
    if count != 1:
        raise SystemExit(f"{TABLE} has no list of numbers")
    (folder / TABLE).write_text(altered, encoding="utf-8")
    if "divide-face" not in run(proof, folder, may_fail=True):
        raise SystemExit("the altered table was refused without naming it")
    # The verifier reads the header itself, so it refuses one that was altered after the program was compiled.
    (folder / TABLE).write_text(table, encoding="utf-8")
    run(proof, folder)
    (folder / TABLE).write_text(altered, encoding="utf-8")
    if "the header's text" not in run(re.sub(r"^.*-o print-divide-face\n", "", proof, flags=re.M), folder, may_fail=True):
        raise SystemExit("the altered header was accepted with a program compiled before")


def main():
    name, programs, compiler = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        commands, compared = follow((ROOT / "docs/tutorials" / name).read_text(encoding="utf-8"), programs, compiler, folder)
        pictures = [picture for picture in folder.glob("*.svg") if "<svg" in picture.read_text(encoding="utf-8")]
        if not pictures:
            raise SystemExit(f"{name} ends in nothing visible")
        if name == "custom-operation.md":
            refuse_altered_table(commands, folder)
    print(f"{name}: {len(commands)} commands, {compared} outputs compared, {len(pictures)} pictures")


main()
