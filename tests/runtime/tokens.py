#!/usr/bin/env python3
"""Alters, one token at a time, the look-ups, the keys, the readers of the automaton and of the linked tables, the layout of the
tables, and the look-ups in C that the generator writes. The programs of tokens/, which ask them everything, must not compile, must
fail, or must answer something else. Survivors are in token_survivors.txt, each with the reason why it changes no answer.

  tokens.py ROOT GENERATE                  all tokens, half an hour of processor time
  tokens.py ROOT GENERATE --only rules.hpp the files whose names end so, one or more
  tokens.py ROOT GENERATE --again          those that are listed as survivors
  tokens.py ROOT GENERATE --sample 12      every so-many-th token that is not listed, 12 in all

GENERATE is restrip-generate: it writes the look-ups in C, and an automaton that tells turns. The list is compared with the sources
in any case. A line of it: file | the line of code | which of its tokens, counted from 1, or * for all | reason. Left alone are
preconditions, which are checked in debug builds only (tests/runtime/precondition_test.cpp), and static_asserts. Exit code: 0 all is
well, 1 a mutant survives without a reason, or a reason has no place or its token no longer survives.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import queue
import re
import shutil
import subprocess
import sys
import tempfile
import threading

RULES, TABLES, LINKED = "runtime/include/restrip/rules/", "tables/include/restrip/tables/", "runtime/include/restrip/operations/"
TEMPLATES = "generator/languages/templates/"
# Each file, and the programs of tokens/ that are asked first; the others that include it follow.
FILES = {
    RULES + "bits.hpp": ["bits"], RULES + "rules.hpp": ["rules"], RULES + "key.hpp": ["keys"],
    RULES + "impl/layout.hpp": ["keys"], RULES + "impl/key_any_length.hpp": ["keys"],
    RULES + "exact.hpp": ["automaton"], RULES + "impl/arc_walk.hpp": ["automaton"],
    RULES + "row.hpp": ["rows"], RULES + "impl/row_walk.hpp": ["rows"],
    TABLES + "format.hpp": ["rules"], TABLES + "automaton_format.hpp": ["automaton"],
    TABLES + "operation_format.hpp": ["operations"], TABLES + "operation_dump.hpp": ["operations"],
    LINKED + "impl/outlook.hpp": ["linked"], LINKED + "linked.hpp": ["linked"],
    TEMPLATES + "tables.h": ["tables"], TEMPLATES + "operation.h": ["operation"],
}
EMITTED = {"tables": ["restrip_tables.h"], "operation": ["restrip_bisect.h", "restrip_bisect_matching.h", "restrip_corner_turns.h"]}
OPERATIONS = ["tables/operations/bisect", "tables/operations/bisect-matching", "tests/corpus/operations/families/corner-turns"]
UP_TO = {LINKED + "linked.hpp": "/// Follows the strips that leave a patch."}  # what lies behind works on meshes
PROGRAMS = ["bits", "operations", "automaton", "automaton-turns", "keys", "rules", "linked", "rows"]
HEADERS = ["boundary_split", "collapse", "fan_collapse", "flip", "open_split", "rows", "split", "automaton", "linked"]

SWAPS = ["< <=", "> >=", "== !=", "+ -", "& |", "<< >>", "&& ||", "+= -=", "&= |=", "++ --", "true false"]
SWAPPED = {a: b for pair in SWAPS for a, b in (pair.split(), reversed(pair.split()))}
SWAPPED.update({"*": "+", "/": "*", "%": "/", "^": "|", "^=": "|=", "!": "", "~": "", "?": "|| true ?"})
TOKEN = re.compile(r"0x[0-9a-fA-F]+|\b\d+|\btrue\b|\bfalse\b|<=>|<<=|>>=|->|::|<<|>>|<=|>=|==|!=|&&|\|\||\+\+|--|\+=|-=|&=|\|=|\^=|[-+*/%&|^<>!~?]")
UNARY = "!~"


def code_of(text):
    """The text with comments, strings, preprocessor lines, preconditions and static_asserts blank, places kept."""
    blank = lambda found: re.sub(r"[^\n]", " ", found[0])
    text = re.sub(r"//[^\n]*|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)'|^#[^\n]*", blank, text, flags=re.M)
    return re.sub(r"\b(?:RESTRIP_ASSERT|static_assert)\([^;]*;|^ *template <[^;{]*?>$", blank, text, flags=re.M)


def name_of(file):
    """As the list of survivors has it."""
    return re.sub(r"^.*?/(?:restrip|languages)/", "", file)


class Mutant:
    def __init__(self, file, start, old, new, line, ordinal):
        self.file, self.start, self.old, self.new, self.line, self.ordinal = file, start, old, new, line, ordinal

    def applied(self, text):
        return text[:self.start] + self.new + text[self.start + len(self.old):]

    def keys(self):
        """Its names in the list of survivors."""
        return [(name_of(self.file), self.line, which) for which in (str(self.ordinal), "*")]

    def __str__(self):
        return "%s | %s | %d | %s -> %s" % (*self.keys()[0][:2], self.ordinal, self.old, self.new or "nothing")


def mutants_of(file, text):
    code, found, ordinals = code_of(text[:text.index(UP_TO[file])] if file in UP_TO else text), [], {}
    for token in TOKEN.finditer(code):
        old, start = token[0], token.start()
        around = code[start - 1] + code[token.end()]
        if old[0].isdigit():
            new = hex(int(old, 16) + 1) if old.startswith("0x") else str(int(old) + 1)
        elif old in UNARY or old in ("++", "--"):
            new = SWAPPED[old]
        elif old == "-" and not around[1].isspace():
            new = ""  # a sign
        elif old not in SWAPPED or not (old[0].isalpha() or around.isspace() and len(around) == 2):
            continue  # a reference, a pointer, the brackets of a template
        else:
            new = SWAPPED[old]
        number = code.count("\n", 0, start)
        ordinals[number] = ordinals.get(number, 0) + 1
        found.append(Mutant(file, start, old, new, text.split("\n")[number].strip(), ordinals[number]))
    return found


def right_operand(code, place):
    """The text from a place to where an operand of && or || ends."""
    depth, start = 0, place
    while not (depth == 0 and re.match(r"&&|\|\||[;?,{})\]]", code[place:])):
        depth += {"(": 1, "[": 1, ")": -1, "]": -1}.get(code[place], 0)
        place += 1
    return code[start:place]


def with_switches(text, mutants):
    """The text with all of these tokens as tokens/switch.hpp reads them, and the numbers of those; the others are as they were."""
    code, pieces, at, switched = code_of(text), [], 0, set()
    for number, mutant in enumerate(mutants):
        old, end = mutant.old, mutant.start + len(mutant.old)
        altered = "::restrip_tokens::altered(%d)" % number
        if re.match(r"using |(?:(?:inline|static) )?constexpr [^(]* = ", mutant.line):
            continue  # compilers evaluate it
        if old[0].isalnum():
            suffix = re.match(r"[uUlL]*", text[end:])[0]
            new, end = "(%s ? %s : %s)" % (altered, mutant.new + suffix, old + suffix), end + len(suffix)
        elif old == "?":
            new = "|| %s ?" % altered
        elif old in ("++", "--") or old in ("&&", "||") and re.search(r"[\[?]|->|stays_open|std::f", right_operand(code, end)):
            continue  # of && and || where the right operand may only be evaluated behind the left one
        elif mutant.new == "":
            new = "::restrip_tokens::%s<%d>{}->*" % ({"!": "Not", "~": "Inverse", "-": "Minus"}[old], number)
        else:
            new = "%s ::restrip_tokens::Token<%d>{} %s" % (old, number, old)
        pieces += [text[at:mutant.start], new]
        at = end
        switched.add(number)
    return "".join(pieces) + text[at:], switched


class Workshop:
    """Compiles the programs against headers, the changed one first, and compares what they print. All tokens of a file that can be are
    altered in one program, when it starts; what is not noticed so, and the others, are altered in the text and compiled one by one."""

    FLAGS = ["-std=c++20", "-O0", "-w", "-D_GLIBCXX_ASSERTIONS", "-DNDEBUG", "-fstack-protector-all"]
    LIMITS = "ulimit -t 3; ulimit -v 4000000; exec \"$@\""  # of a program, which takes a second at most

    def __init__(self, root, generate, folder):
        self.root, self.folder, self.programs = root, folder, folder / "tokens"
        shutil.copytree(root / "tests/runtime/tokens", self.programs)
        self.include = [root / "runtime/include", root / "tables/include"]
        self.made, self.locks, self.lock = {}, {}, threading.Lock()  # of what is made once
        sources = [path.read_text(encoding="utf-8") for path in sorted(self.programs.glob("*.?pp"))]
        self.standard = sorted(set(re.findall(r"^#include <.*>\n", "".join(sources), re.M)))
        self.generate = generate

    def once(self, name, make):
        """What make() returns; it is called for the first who asks."""
        with self.lock:
            lock = self.locks.setdefault(name, threading.RLock())
        with lock:
            if name not in self.made:
                self.made[name] = make()
            return self.made[name]

    def precompiled(self, name):
        """A header with the standard headers of the programs; all but "standard" have the tables, too."""
        lines = self.standard if name == "standard" else self.standard + [
            "#include <%s>\n" % word for word in ("array", "span", "type_traits", "limits")] + [
            "#include \"restrip/tables/" + word + ".hpp\"\n" for word in HEADERS]
        header = self.folder / (name + ".hpp")
        header.write_text("".join(lines))
        folders = [word for each in self.folders(name) for word in ("-I", each)]
        subprocess.run(["c++", *self.FLAGS, *folders, "-x", "c++-header", header, "-o", str(header) + ".gch"], check=True)
        return header

    def folders(self, program):
        name = program.split("-")[-1]
        options = {"turns": ["--cost", "1,1,0"], "rows": ["--operation", self.root / "examples/own_family.json"]}.get(name)
        if options is None:
            return self.include
        self.once(name, lambda: subprocess.run([self.generate, "automaton", *options, "--out", self.folder / "automata" / name], check=True, capture_output=True))
        return [self.folder / "automata" / name / "include"] + self.include

    def reads(self, program):
        """The files that it includes."""
        listed = subprocess.run(["c++", *self.FLAGS, *[word for each in self.folders(program) for word in ("-I", each)], "-M", self.source(program)],
                                check=True, capture_output=True, text=True)
        return {file for file in FILES if str(self.root / file) in listed.stdout.split()}

    def right(self, program):
        """What it prints as it is; the same is in a file."""
        if program in EMITTED:
            return self.run_in_c(program, self.once("emitted", self.emitted), self.folder / program).stdout
        told = self.built(program, "tables", [], self.folder / program)
        if told is not None:
            raise ValueError("%s: %s" % (program, told))
        done = subprocess.run([self.folder / program], capture_output=True, check=True)
        (self.folder / (program + ".right")).write_bytes(done.stdout)
        return done.stdout

    def source(self, program):
        return self.programs / (program.split("-")[0] + ".cpp")

    def built(self, program, precompiled, first, output):
        """What the compiler says against it, or None."""
        header = precompiled + ("-turns" if program.endswith("-turns") and precompiled == "tables" else "")
        command = ["c++", *self.FLAGS, "-include", self.once(header, lambda: self.precompiled(header))]
        command += [word for each in first + self.folders(program) for word in ("-I", each)]
        done = subprocess.run(command + [self.source(program), "-o", output], capture_output=True, text=True)
        if done.returncode != 0 and (" error: " not in done.stderr or "internal compiler error" in done.stderr or "Killed" in done.stderr):
            raise ValueError("the compiler failed: " + done.stderr)
        return done.stderr if done.returncode != 0 else None

    def emitted(self):
        """The look-ups in C as the generator writes them."""
        out = self.folder / "emitted"
        subprocess.run([self.generate, "tables", "--max-k", "5", "--language", "c", "--out", out], check=True, capture_output=True)
        for file in OPERATIONS:
            more = ["--max-k", "4"] if "families" in file else []
            subprocess.run([self.generate, "rules", "--operation", self.root / (file + ".json"), *more, "--language", "c", "--out", out], check=True, capture_output=True)
        return out

    def run_in_c(self, program, headers, output):
        """What the program ends with and prints, or None where it does not compile."""
        flags = ["-std=c99", "-w", "-O0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-I", headers]
        done = subprocess.run(["cc", *flags, self.programs / (program + ".c"), "-o", output], capture_output=True, text=True)
        return subprocess.run(["sh", "-c", "ulimit -t 3; exec \"$@\"", "sh", output], capture_output=True) if done.returncode == 0 else None

    def write_emitted(self, program, text, changed, folder):
        """The headers as a changed template makes them."""
        pieces, changed = (re.split(r"@\w+@\n?", template) for template in (text, changed))  # a line of its own goes where nothing is filled in
        for header in EMITTED[program]:
            filled = re.fullmatch("(.*?)".join(map(re.escape, pieces)), (self.once("emitted", self.emitted) / header).read_text(encoding="utf-8"), re.S)
            if not filled:
                raise ValueError(header + ": not as the template has it")
            (folder / header).write_text("".join(piece + value for piece, value in zip(changed, (*filled.groups(), ""))))

    def switched(self, program, file, text, mutants):
        """The program with all tokens of the file to be altered when it starts, and the numbers of those that can be."""
        own = self.folder / ("switched-" + program + "-" + file.replace("/", "-"))
        changed = own / "changed" / file.split("include/", 1)[-1]
        changed.parent.mkdir(parents=True, exist_ok=True)
        new, numbers = with_switches(text, mutants)
        command = ["c++", "-std=c++20", "-O1", *self.FLAGS[2:], "-Wno-narrowing", "-include", self.programs / "switch.hpp"]
        if file.startswith(TEMPLATES):
            self.write_emitted(program, text, new, own)
            command += ["-I", own, "-x", "c++", self.programs / (program + ".c")]
        else:
            changed.write_text(new)
            command += [word for each in [own / "changed"] + self.folders(program) for word in ("-I", each)] + [self.source(program)]
        right, done = self.right_of(program), subprocess.run(command + ["-o", own / "program"], capture_output=True, text=True)
        if done.returncode != 0 or self.ran(own / "program", program, -1).stdout != right:
            raise ValueError("%s: with all tokens to be altered: %s" % (file, done.stderr[-5000:]))
        return own / "program", numbers

    def ran(self, binary, program, number):
        return subprocess.run(["sh", "-c", self.LIMITS, "sh", binary, self.folder / (program + ".right")], capture_output=True,
                              env={**os.environ, "RESTRIP_TOKEN": str(number)})

    def right_of(self, program):
        return self.once("right " + program, lambda: self.right(program))

    def fate_switched(self, mutant, text, mutants):
        number = mutants.index(mutant)
        for program in self.asked(mutant.file):
            binary, numbers = self.once((program, mutant.file), lambda: self.switched(program, mutant.file, text, mutants))
            if number not in numbers:
                break
            run = self.ran(binary, program, number)
            if run.returncode not in (0, 1):
                return "ends badly"
            if run.stdout != self.right_of(program):
                return "answers otherwise"
        return None

    def asked(self, file):
        """The programs that include it, first those that are likely to notice."""
        if file.startswith(TEMPLATES):
            return FILES[file]
        first = FILES[file] + [first + "-turns" for first in FILES[file]]
        return [program for program in sorted(PROGRAMS, key=lambda name: name not in first)
                if file in self.once("reads " + program, lambda: self.reads(program))]

    def fate_in_c(self, mutant, text, own):
        program = FILES[mutant.file][0]
        right = self.right_of(program)
        self.write_emitted(program, text, mutant.applied(text), own)
        run = self.run_in_c(program, own, own / "program")
        if run is None:
            return "does not compile"
        return "ends badly" if run.returncode != 0 else "answers otherwise" if run.stdout != right else "survives"

    def fate(self, mutant, text, mutants, own):
        """What becomes of it: "does not compile", "ends badly", "answers otherwise" or "survives"."""
        if mutants and (became := self.fate_switched(mutant, text, mutants)) is not None:
            return became
        if mutant.file.startswith(TEMPLATES):
            return self.fate_in_c(mutant, text, own)
        changed = own / "changed" / mutant.file.split("include/", 1)[1]
        changed.parent.mkdir(parents=True, exist_ok=True)
        changed.write_text(mutant.applied(text))
        precompiled = "standard" if mutant.file.startswith(TABLES) else "tables"
        try:
            for program in self.asked(mutant.file):
                if self.built(program, precompiled, [own / "changed"], own / "program") is not None:
                    return "does not compile"
                run = self.ran(own / "program", program, -1)
                if run.returncode not in (0, 1):
                    return "ends badly"
                if run.stdout != self.right_of(program):
                    return "answers otherwise"
            return "survives"
        finally:
            changed.unlink()


def reasons(path):
    found = {}
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        parts = [part.strip() for part in line.split(" | ")]
        if len(parts) < 4 or not parts[-1]:
            raise ValueError("%s:%d: expected file | line of code | which token | reason" % (path, number))
        found[parts[0], " | ".join(parts[1:-2]), parts[-2]] = number
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("generate")
    parser.add_argument("--only", nargs="+", default=[""])
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--sample", type=int, default=0)
    options = parser.parse_args()
    root = options.root.resolve()
    listed = reasons(root / "tests/runtime/token_survivors.txt")
    texts = {file: (root / file).read_text(encoding="utf-8") for file in FILES}
    of_file = {file: mutants_of(file, texts[file]) for file in FILES}
    mutants = [mutant for file in FILES for mutant in of_file[file]]
    places = {key for mutant in mutants for key in mutant.keys()}
    faults = ["token_survivors.txt:%d: there is no such token: %s" % (number, " | ".join(key)) for key, number in listed.items() if key not in places]
    reason_of = lambda mutant: any(key in listed for key in mutant.keys())
    chosen = [mutant for mutant in mutants if mutant.file.endswith(tuple(options.only)) and (reason_of(mutant) or not options.again)]
    if options.sample:
        unlisted = [mutant for mutant in chosen if not reason_of(mutant)]
        chosen = unlisted[len(unlisted) // options.sample // 2::max(1, len(unlisted) // options.sample)][:options.sample]
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        workshop = Workshop(root, options.generate, folder)
        idle = queue.SimpleQueue()
        for number in range(options.jobs):
            (folder / str(number)).mkdir()
            idle.put(folder / str(number))

        def fate(mutant):
            own = idle.get()
            try:
                return workshop.fate(mutant, texts[mutant.file], [] if options.sample else of_file[mutant.file], own)
            finally:
                idle.put(own)

        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            for number, (mutant, became) in enumerate(zip(chosen, pool.map(fate, chosen)), 1):
                counts[became] += 1
                if (became == "survives") != reason_of(mutant):
                    faults.append(("survives: %s" if became == "survives" else "listed, but " + became + ": %s") % mutant)
                    print(faults[-1], flush=True)
                if sys.stderr.isatty() or number % 10 == 0:
                    print("\r%d of %d" % (number, len(chosen)), end="", file=sys.stderr, flush=True)
    survived = counts["survives"]
    reasonless = sum(fault.startswith("survives") for fault in faults)
    print("%d of %d mutants: %d do not compile, %d end badly, %d answer otherwise, %d survive with a reason, %d without" %
          (len(chosen), len(mutants), counts["does not compile"], counts["ends badly"], counts["answers otherwise"], survived - reasonless, reasonless))
    for fault in faults:
        if fault.startswith("token_survivors"):
            print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
