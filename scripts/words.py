#!/usr/bin/env python3
"""Names the words of this project's own that changed lines have and readers stop at, with what to write instead.

words.py BASE: the lines that differ from the commit BASE, and new files. Always ends with 0: some uses are right."""
import re
import subprocess
import sys

DROPPED = [  # pattern, what to write
    (r"anew", "again, from scratch"),
    (r"told|tells?\b(?= (?:that|what|which|whether|the))", "reported, stated, returned, known"),
    (r"(?:is|are|was) no (?!longer|more|less|other|such)\w+|there is none|that there (?:is|are)", "is not a X, does not exist"),
    (r"(?:those|that) of(?! (?:course))", "the noun again, or a genitive"),
    (r"of (?:one's|your|its|their|our|my) own", "custom, your"),
    (r"beside|behind", "with, next to, after (right in space)"),
    (r"strangers?|somebody|nobody", "user, caller; or the passive"),
    (r"(?:so|as) many(?! as)", "N, the same number"),
    (r"comes? to|amounts? to|goes on", "is, totals, continues"),
    (r"rungs?|ladders?", "check, checks"),
    (r"adopt(?:s|ed|ing)?|orphan(?:s|ed|ing)?|dash(?:es|ed|ing)|(?:to|it|which|and) lights?", "set, clear (of edges)"),
    (r"local rules", "the rules"),
    (r"piece", "connected component"),
]
WORDS = [(re.compile(rf"(?<![\w-])(?:{pattern})(?![\w-])", re.IGNORECASE), instead) for pattern, instead in DROPPED]
PROSE = re.compile(r".*\.(?:md|hpp|cpp|h|c|in|py|sh|cmake|txt|mjs|ts|js|html|css|v|ml|yml|cff)")
GENERATED = re.compile(r"tables/include/.*|tables/certificates/.*|scripts/words\.py|CHANGELOG\.md")


def dropped(line):
    """The dropped words of a line, each with its replacement."""
    return [(found[0], instead) for pattern, instead in WORDS for found in pattern.finditer(line)]


def changed_lines(base):
    """(file, number, line) of all lines that the commit does not have."""
    run = lambda *arguments: subprocess.run(["git", *arguments], check=True, capture_output=True, text=True, errors="replace").stdout
    file, number = "", 0
    for line in run("diff", "-U0", "--no-color", "--no-prefix", "--diff-filter=d", base).split("\n"):
        if line.startswith("+++ "):
            file = line[4:]
        elif line.startswith("@@"):
            number = int(re.search(r"\+(\d+)", line)[1])
        elif line.startswith("+"):
            yield file, number, line[1:]
            number += 1
    for file in run("ls-files", "--others", "--exclude-standard").split("\n")[:-1]:
        if PROSE.fullmatch(file):
            for number, line in enumerate(open(file, encoding="utf-8", errors="replace"), 1):
                yield file, number, line


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] == "--help":
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    for file, number, line in changed_lines(sys.argv[1]):
        if PROSE.fullmatch(file) and not GENERATED.fullmatch(file):
            for word, instead in dropped(line):
                print(f"{file}:{number}: \"{word}\": write {instead}")
