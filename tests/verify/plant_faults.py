#!/usr/bin/env python3
"""Copies the verifier's sources and plants the deliberate faults of a list in the copy, each selected at run time.

  plant_faults.py LIST SOURCES COPY

LIST has three lines for each fault, between blank lines; # begins a comment:

  NAME FILE FUNCTION [SUITE.TEST]
    why it is wrong; the test is one that notices it and is run first
    the faulty expression => what takes its place, in which $ is the expression

The expression is found once in the definitions of that function, whatever its blanks and line breaks; where it occurs more
often, it stands in «» between text next to it. COPY also gets faults.hpp with active_fault, and fault_names.hpp. Exit
code 1: a block is malformed, or its expression is not found exactly once.
"""
import re
import sys
from pathlib import Path

HEADER = "#pragma once\nnamespace restrip {\ninline int active_fault = 0;\n}  // namespace restrip\n"
NAMES = """#pragma once
namespace restrip {
struct FaultName {
  const char* name;
  const char* test;  ///< one that notices it; empty: none is named
};
/// Fault number N is fault_names[N - 1].
inline constexpr FaultName fault_names[] = {
%s};
}  // namespace restrip
"""


def without_texts(source):
    """The source with blanks for its comments and literals."""
    return re.sub(r"""//[^\n]*|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'""", lambda text: " " * len(text[0]), source)


def end_of(source, at):
    """Behind the bracket that closes the one at this place."""
    depth = 0
    while True:
        depth += (source[at] in "({") - (source[at] in ")}")
        at += 1
        if depth == 0:
            return at


def bodies(source, function):
    """Where the definitions of a function begin and end."""
    source = without_texts(source)
    for head in re.finditer(r"\b%s\(" % re.escape(function), source):
        at = end_of(source, head.end() - 1)
        if between := re.compile(r"[^;{}]*?(\{)").match(source, at):
            if re.match(r"\s*(const|noexcept|->|:|\{)", source[at:]):
                yield between.start(1), end_of(source, between.start(1))


def place(source, function, text):
    """Where the faulty expression begins and ends."""
    before, inside, after = re.fullmatch(r"(.*)«(.*)»(.*)", text).groups() if "«" in text else ("", text, "")
    parts = [r"\s*".join(map(re.escape, re.findall(r"\w+|[^\w\s]", part))) for part in (before, inside, after)]
    found = [match.span(1) for begin, end in bodies(source, function)
             for match in re.compile(r"%s\s*(%s)\s*%s" % tuple(parts)).finditer(source, begin, end)]
    if len(set(found)) != 1:
        raise ValueError("found %d times: %s" % (len(set(found)), text))
    return found[0]


def planted(source, faults, begin, end):
    """The source from begin to end with these (place, number, fault); those inside others are planted first."""
    result, at = "", begin
    faults = sorted(faults, key=lambda one: (one[0][0], -one[0][1]))
    while faults:
        (first, last), number, fault = faults.pop(0)
        inner = [one for one in faults if one[0][0] < last]
        faults = faults[len(inner):]
        text = planted(source, inner, first, last)
        result += source[at:first] + "(active_fault == %d ? (%s) : (%s))" % (number, fault.replace("$", source[first:last]), text)
        at = last
    return result + source[at:end]


def main(list_file, folder, copy):
    text = re.sub(r"(?m)^#.*\n", "", Path(list_file).read_text(encoding="utf-8"))
    blocks = [[line.strip() for line in block.strip().splitlines()] for block in re.split(r"\n\s*\n", text) if block.strip()]
    sources = {path.relative_to(folder).as_posix(): path.read_text() for path in Path(folder).rglob("*.[ch]pp")}
    faults, names, wrong = {}, "", []
    for number, block in enumerate(blocks, 1):
        try:
            head, _, change = block
            name, file, function, test = (head.split() + [""])[:4]
            expression, fault = change.split(" => ")
            faults.setdefault(file, []).append((place(sources[file], function, expression), number, fault))
            names += '    {"%s", "%s"},\n' % (name, test)
        except (ValueError, KeyError) as error:
            wrong.append("%s: %s: %s" % (list_file, block[0], error))
    if wrong:
        sys.exit("\n".join(wrong))
    for file, some in faults.items():
        sources[file] = '#include "faults.hpp"\n' + planted(sources[file], some, 0, len(sources[file]))
    for file, source in {**sources, "faults.hpp": HEADER, "fault_names.hpp": NAMES % names}.items():
        path = Path(copy) / file
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text() != source:
            path.write_text(source)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
