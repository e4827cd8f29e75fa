#!/usr/bin/env python3
"""Copies headers and sources and puts the deliberate faults of a list into the copy, each selected at run time.

  mutate.py LIST SOURCES COPY [PREFIX]

LIST has a block of four lines for each fault, between blank lines; # begins a comment:

  NAME FILE [endless | equivalent] [SUITE.TEST]
    why it is wrong, or with `equivalent` why it changes nothing; `endless`: a loop that does not end. The test is one that
    notices it and is run first; where others notice it sooner, none need be named
    text of PREFIX FILE, found there once, with the faulty expression in «»; PREFIX is restrip/ unless it is given
    the expression that takes its place

An expression E becomes `(restrip_mutant(N) ? (F) : (E))`. Blanks and line breaks of the text need not match FILE. COPY
gets two headers more: mutants.hpp with restrip_mutant(), and mutant_names.hpp, which only the main program includes, so that
an edit of the list recompiles what includes the changed headers. Exit code 1: a block is malformed, or its text is not found
exactly once.
"""
import re
import sys
from pathlib import Path

HEADER = """#pragma once
#include <type_traits>
namespace restrip {
inline int active_mutant = 0;
/// Never true where the compiler evaluates.
constexpr bool restrip_mutant(int number) noexcept { return !std::is_constant_evaluated() && active_mutant == number; }
}  // namespace restrip
"""

NAMES = """#pragma once
namespace restrip {
struct MutantName {
  const char* name;
  bool endless;
  bool equivalent;
  const char* test;  ///< one that notices it, to be run first; empty: none is named
};
/// Fault number N is mutant_names[N - 1].
inline constexpr MutantName mutant_names[] = {
%s};
}  // namespace restrip
"""


class Malformed(Exception):
    pass


class Mutant:
    def __init__(self, number, lines, prefix):
        words = lines[0].split()
        form = re.fullmatch(r"([a-z0-9_]+) ([\w/.]+)( endless| equivalent)?( [\w/]+\.[\w/]+)?", lines[0])
        if len(lines) != 4 or not form:
            raise Malformed("'%s': a block is a line NAME FILE [endless | equivalent] [SUITE.TEST] and three more" % lines[0])
        self.number, self.name, self.file = number, form[1], prefix + form[2]
        self.kind, self.test = (form[3] or "").strip(), (form[4] or "").strip()
        self.text, self.fault = lines[2].strip(), lines[3].strip()
        if self.text.count("«") != 1 or self.text.count("»") != 1:
            raise Malformed("%s: the third line has one «expression»" % self.name)

    def place(self, source):
        """Where the expression begins and ends in the source."""
        before, rest = self.text.split("«")
        inside, after = rest.split("»")
        pattern = [r"\s*".join(map(re.escape, re.findall(r"\w+|[^\w\s]", part))) for part in (before, inside, after)]
        found = list(re.finditer(r"%s\s*(%s)\s*%s" % tuple(pattern), source))
        if len(found) != 1:
            raise Malformed("%s: found %d times in %s: %s" % (self.name, len(found), self.file, self.text))
        return found[0].span(1)


def mutated(source, mutants, begin, end):
    """The source from begin to end with these (place, mutant); those inside others are put in first."""
    result, at = "", begin
    mutants = sorted(mutants, key=lambda item: (item[0][0], -item[0][1]))
    while mutants:
        (first, last), mutant = mutants.pop(0)
        inner = [item for item in mutants if item[0][0] < last]
        mutants = mutants[len(inner):]
        for (_, inner_last), other in inner:
            if inner_last > last:
                raise Malformed("%s and %s overlap" % (mutant.name, other.name))
        result += source[at:first]
        result += "(restrip_mutant(%d) ? (%s) : (%s))" % (mutant.number, mutant.fault, mutated(source, inner, first, last))
        at = last
    return result + source[at:end]


def main(list_file, headers, copy, prefix="restrip/"):
    text = re.sub(r"(?m)^#.*\n", "", Path(list_file).read_text(encoding="utf-8"))
    blocks = [block.splitlines() for block in re.split(r"\n\s*\n", text) if block.strip()]
    mutants = [Mutant(number, [line for line in lines if line.strip()], prefix) for number, lines in enumerate(blocks, 1)]
    if len({mutant.name for mutant in mutants}) != len(mutants) or not mutants:
        raise Malformed("no fault, or two of the same name")
    headers, copy = Path(headers), Path(copy)
    sources = {path.relative_to(headers).as_posix(): path.read_text() for path in headers.rglob("*.[ch]pp")}
    placed, wrong = {}, []
    for mutant in mutants:
        try:
            placed.setdefault(mutant.file, []).append((mutant.place(sources.get(mutant.file, "")), mutant))
        except Malformed as error:
            wrong.append(str(error))
    if wrong:
        raise Malformed("\n".join(wrong))
    for file, faults in placed.items():
        source = sources[file]
        source = mutated(source, faults, 0, len(source))
        if file.endswith(".cpp"):
            source = "#pragma once\n" + source
        if "#pragma once\n" not in source:
            raise Malformed("%s: without #pragma once" % file)
        once = "" if file.endswith(".cpp") else "#pragma once\n"
        sources[file] = source.replace("#pragma once\n", once + '#include "mutants.hpp"\n', 1)
    names = ['    {"%s", %s, %s, "%s"},\n' % (mutant.name, str(mutant.kind == "endless").lower(),
                                              str(mutant.kind == "equivalent").lower(), mutant.test) for mutant in mutants]
    sources["mutants.hpp"], sources["mutant_names.hpp"] = HEADER, NAMES % "".join(names)
    for file, source in sources.items():
        path = copy / file
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text() != source:
            path.write_text(source)


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    try:
        main(*sys.argv[1:])
    except Malformed as error:
        sys.exit("mutate.py: %s: %s" % (sys.argv[1], error))
