#!/usr/bin/env python3
"""Makes generic faults in the sources of a folder and lists those that its tests do not notice.

A fault is another comparison, operator or constant, two arguments swapped, or a dropped statement, chosen by a seed. All are
planted in a copy of the tree, each selected at run time, so that the tests are built once; faults that do not compile
are left out. The checkout is never touched. Survivors are not all gaps in the tests: some faults change nothing.
"""
import argparse
import os
import random
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SWITCH = """#ifndef RESTRIP_FAULT_SWITCH
#define RESTRIP_FAULT_SWITCH
#include <cstdlib>
inline const int restrip_fault_number = std::getenv("RESTRIP_FAULT") == nullptr ? 0 : std::atoi(std::getenv("RESTRIP_FAULT"));
constexpr bool restrip_fault(int n) { return !__builtin_is_constant_evaluated() && restrip_fault_number == n; }
#endif
"""
OTHER = {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ", " && ": " || ", " || ": " && ",
         " + ": " - ", " - ": " + "}
CONDITION = re.compile(r"\b(?:if|while) \(")
VALUE = re.compile(r"\breturn ([^;{}]+);|\bfor \([^;{}]*; ([^;{}]+);")
STATEMENT = re.compile(r"(?<=[;{})])\s*\n\s*((?!return\b|using\b|break\b|continue\b|throw\b|delete\b)[\w.:]+(?:\[[^\];]*\])?(?:->[\w.]+)?"
                       r"(?:\([^;{}]*\)| [-+*|&^]?= [^;{}]*);)")


class Fault:
    def __init__(self, file, begin, end, faulty, what):
        self.file, self.begin, self.end, self.faulty, self.what = file, begin, end, faulty, what
        self.number = 0


def without_texts(source):
    """The source with blanks for its comments and literals."""
    return re.sub(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'""", lambda text: re.sub(r"[^\n]", " ", text[0]), source,
                  flags=re.S)


def closing(source, at):
    depth = 0
    for i in range(at, len(source)):
        depth += (source[i] == "(") - (source[i] == ")")
        if depth == 0:
            return i
    return None


def changed(source, plain, begin, end, choice):
    """The expression with one change, and what is changed; or nothing."""
    changes = [(m.start(), m.end(), OTHER[m[0]]) for m in re.finditer(r" (?:[<>]=?|==|!=|&&|\|\||[-+]) ", plain[begin:end])]
    changes += [(m.start(), m.end(), str(int(m[0]) + 1)) for m in re.finditer(r"(?<![\w.])\d{1,4}(?![\w.])", plain[begin:end])]
    changes += [(m.start(1), m.end(2), "%s, %s" % (m[2], m[1]))
                for m in re.finditer(r"\w\(([\w.]+), ([\w.]+)\)", plain[begin:end]) if m[1] != m[2]]
    if not changes:
        return None
    text = source[begin:end]
    first, last, other = choice.choice(changes)
    return text[:first] + other + text[last:], "%s -> %s" % (text[first:last].strip(), other.strip())


def faults_in(file, source, choice):
    plain = without_texts(source)
    for match in CONDITION.finditer(plain):
        begin, end = match.end(), closing(plain, match.end() - 1)
        if end and not re.search(r"[;{]|\b(?:const|auto)\b", plain[begin:end]):
            if change := changed(source, plain, begin, end, choice):
                yield Fault(file, begin, end, *change)
    for match in VALUE.finditer(plain):
        begin, end = match.span(match.lastindex)
        if change := changed(source, plain, begin, end, choice):
            yield Fault(file, begin, end, *change)
    for match in STATEMENT.finditer(plain):
        yield Fault(file, match.start(1), match.end(1), None, "dropped: " + " ".join(source[match.start(1):match.end(1)].split())[:70])


def planted(source, faults):
    for fault in sorted(faults, key=lambda one: -one.begin):
        text = source[fault.begin:fault.end]
        new = ("{ if (!restrip_fault(%d)) %s }" % (fault.number, text) if fault.faulty is None
               else "(restrip_fault(%d) ? (%s) : (%s))" % (fault.number, fault.faulty, text))
        source = source[:fault.begin] + new + source[fault.end:]
    return source.replace("#pragma once\n", "#pragma once\n" + SWITCH, 1) if "#pragma once\n" in source else SWITCH + source


def apart(faults):
    """Without those that overlap an earlier one of the same file."""
    kept = []
    for fault in faults:
        if all(fault.file != one.file or fault.end <= one.begin or one.end <= fault.begin for one in kept):
            kept.append(fault)
    return kept


def write_if_new(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_bytes() != text:
        path.write_bytes(text)


def copy_tree(tree):
    for name in subprocess.check_output(["git", "ls-files"], cwd=ROOT, text=True).splitlines():
        if (ROOT / name).is_file():
            write_if_new(tree / name, (ROOT / name).read_bytes())


def programs_of(build, wanted):
    """The programs of the build that the wanted tests run."""
    listed = subprocess.check_output(["ninja", "-t", "targets", "all"], cwd=build, text=True).splitlines()
    targets = {line.split(":")[0] for line in listed}
    programs = set()
    for file in [*build.rglob("CTestTestfile.cmake"), *build.rglob("*_include.cmake")]:
        for name, command in re.findall(r"^ *add_test\((?:\[=*\[)?([^\]\s]+)(.*)\)$", file.read_text(encoding="utf-8"), re.M):
            if name.endswith("_NOT_BUILT"):  # a program whose tests are only known when it is built
                program = name[:-len("_NOT_BUILT")]
                room = program.split("_")[0]
                tests = [".".join((room, *test)) for source in (ROOT / "tests" / room).rglob("*_test.cpp")
                         for test in re.findall(r"^TEST(?:_[FP])?\((\w+), (\w+)", source.read_text(encoding="utf-8"), re.M)]
                if any(wanted.search(test) for test in tests):
                    programs |= {target for target in targets if os.path.basename(target) == program}
            elif wanted.search(name):
                words = re.findall(r'[^"\s]+', command)
                programs |= {os.path.relpath(word, build) for word in words if word.startswith(str(build))} & targets
    return sorted(programs)


def passed(build, tests, number, limit):
    """Whether the tests pass with this fault."""
    environment = {**os.environ, "RESTRIP_FAULT": str(number)}
    try:
        return subprocess.run(["ctest", "-R", tests, "-j2", "--stop-on-failure", "--timeout", str(limit)], cwd=build, env=environment,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False, timeout=20 * limit).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example:\n  scripts/mutate.py verify --count 40 --tests '^verify[.](Description|TableDump)'\n")
    parser.add_argument("folder", help="whose sources get faults: verify, or runtime/include/restrip/rules")
    parser.add_argument("--seed", type=int, default=1, help="of the choice of faults (1)")
    parser.add_argument("--count", type=int, default=40, help="the number of faults (40)")
    parser.add_argument("--build", type=Path, default=ROOT / "build/mutate", help="where the copy is built (build/mutate)")
    parser.add_argument("--tests", help="a regular expression of names of tests; by default those of the folder's name")
    options = parser.parse_args()
    folder = Path(options.folder)
    tests = options.tests or re.escape(folder.name) + "[.]"
    tree, build = options.build.resolve() / "tree", options.build.resolve() / "build"

    choice = random.Random(options.seed)
    files = sorted(path for path in (ROOT / folder).rglob("*.[ch]pp"))
    sources = {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in files}
    every = [fault for file, source in sources.items() for fault in faults_in(file, source, choice)]
    choice.shuffle(every)
    faults = apart(every)[:options.count]
    if not faults:
        sys.exit("mutate.py: %s has no sources in which a fault is possible" % folder)
    for number, fault in enumerate(faults, 1):
        fault.number = number

    copy_tree(tree)
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    subprocess.run(["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG -w",
                    "-DRESTRIP_ALLOW_MISSING=ON", "-DRESTRIP_WARNINGS_AS_ERRORS=OFF", *launcher], check=True, stdout=subprocess.DEVNULL)
    programs = programs_of(build, re.compile(tests))
    if not programs:
        sys.exit("mutate.py: no test with a program matches %s" % tests)
    while True:
        for file, source in sources.items():
            own = [fault for fault in faults if fault.file == file]
            write_if_new(tree / file, (planted(source, own) if own else source).encode())
        made = subprocess.run(["ninja", "-k", "0", *programs], cwd=build, capture_output=True, text=True, check=False)
        if made.returncode == 0:
            break
        wrong = set()
        for file, line in re.findall(r"([^\s:]+):(\d+):\d+: error", made.stdout):
            name = os.path.relpath(build / file, tree)
            if name in sources:
                around = (tree / name).read_text(encoding="utf-8").split("\n")[max(0, int(line) - 4):int(line) + 3]
                text = "\n".join(around)
                wrong |= {int(number) for number in re.findall(r"restrip_fault\((\d+)\)", text)}
        if not wrong & {fault.number for fault in faults}:
            sys.exit(made.stdout[-3000:] + "mutate.py: the copy does not build")
        faults = [fault for fault in faults if fault.number not in wrong]

    start = time.monotonic()
    if not passed(build, tests, 0, 1500):
        sys.exit("mutate.py: the tests fail without a fault")
    limit = max(20, int(5 * (time.monotonic() - start)))
    survivors = []
    for fault in faults:
        noticed = not passed(build, tests, fault.number, limit)
        line = sources[fault.file].count("\n", 0, fault.begin) + 1
        print("%s %s:%d: %s" % ("noticed " if noticed else "SURVIVES", fault.file, line, fault.what), flush=True)
        survivors += [] if noticed else [fault]
    print("%d of %d faults survive (seed %d, tests %s)" % (len(survivors), len(faults), options.seed, tests))


main()
