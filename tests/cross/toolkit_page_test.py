#!/usr/bin/env python3
"""The steps of docs/toolkit.md, done as they stand there: file, commands and program; each must print what the page says.

  toolkit_page_test.py PROGRAMS COMPILER
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def blocks(page):
    """(language, text) of every fenced block, in order."""
    return re.findall(r"^```(\w+)\n(.*?)^```$", page, re.M | re.S)


def run(command, folder):
    done = subprocess.run(command, cwd=folder, shell=isinstance(command, str), text=True, capture_output=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    programs, compiler = sys.argv[1:]
    printed = None
    compared = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for language, text in blocks((ROOT / "docs/toolkit.md").read_text(encoding="utf-8")):
            if language == "json":
                (folder / "pair-flip.json").write_text(text, encoding="utf-8")
            elif language == "sh":
                printed = run(text.replace("build/demo/bin/", programs + "/"), folder)
            elif language == "cpp":
                (folder / "use.cpp").write_text(text, encoding="utf-8")
                run([compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-Irules/include", f"-I{ROOT}/tables/include",
                     "use.cpp", "-o", "use"], folder)
                printed = run(["./use"], folder)
            elif language == "text":
                if printed is None or not printed.endswith(text):
                    raise SystemExit(f"docs/toolkit.md says\n{text}but this was printed:\n{printed}")
                compared += 1
    if compared != 3:
        raise SystemExit(f"docs/toolkit.md: {compared} printed results were compared, not 3")


main()
