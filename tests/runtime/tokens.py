#!/usr/bin/env python3
"""Alters the look-ups, the keys, the automaton's reader and the layout of the tables one token at a time; tokens_judge.cpp, which
asks them everything, must not compile, must fail, or must answer something else. Survivors are in token_survivors.txt, each with
the reason why it changes no answer.

  tokens.py ROOT GENERATE                  all tokens, half an hour; GENERATE is restrip-generate, for an automaton that tells turns
  tokens.py ROOT GENERATE --only rules.hpp the files whose names end so
  tokens.py ROOT GENERATE --sample 12      every so-many-th token, 12 in all; the list is compared with the sources in any case

A line of token_survivors.txt: file | the line of code | which of its tokens, counted from 1, or * for all | reason. Preconditions
are left alone: they are checked in debug builds only, and tests/runtime/precondition_test.cpp is about them. Exit code: 0 all is
well, 1 a mutant survives without a reason, or a reason without a place.
"""
import argparse
import concurrent.futures
import os
import pathlib
import queue
import re
import subprocess
import sys
import tempfile

FILES = ["runtime/include/restrip/rules/" + name for name in
         ("bits.hpp", "rules.hpp", "key.hpp", "impl/layout.hpp", "impl/key_any_length.hpp", "exact.hpp", "impl/arc_walk.hpp")] + \
        ["tables/include/restrip/tables/" + name for name in ("format.hpp", "automaton_format.hpp", "operation_format.hpp")]
SWAPS = ["< <=", "> >=", "== !=", "+ -", "& |", "<< >>", "&& ||", "+= -=", "&= |=", "++ --", "true false"]
SWAPPED = {a: b for pair in SWAPS for a, b in (pair.split(), reversed(pair.split()))}
SWAPPED.update({"*": "+", "/": "*", "%": "/", "^": "|", "!": "", "~": ""})
TOKEN = re.compile(r"0x[0-9a-fA-F]+|\b\d+|\btrue\b|\bfalse\b|<=>|<<=|>>=|->|::|<<|>>|<=|>=|==|!=|&&|\|\||\+\+|--|\+=|-=|&=|\|=|[-+*/%&|^<>!~]")
UNARY = "!~"
TURNING = ("arc_walk.hpp", "automaton_format.hpp", "exact.hpp")  # asked a second time, with an automaton that tells turns
TIMEOUT = 10  # seconds; the judge takes a fraction of one


def code_of(text):
    """The text with comments, strings, preprocessor lines, preconditions and static_asserts blank, places kept."""
    blank = lambda found: re.sub(r"[^\n]", " ", found[0])
    text = re.sub(r"//[^\n]*|\"(?:[^\"\\\n]|\\.)*\"|^#[^\n]*", blank, text, flags=re.M)
    return re.sub(r"\b(?:RESTRIP_ASSERT|static_assert)\([^;]*;|^ *template <[^;{]*?>$", blank, text, flags=re.M)


class Mutant:
    def __init__(self, file, start, old, new, line, ordinal):
        self.file, self.start, self.old, self.new, self.line, self.ordinal = file, start, old, new, line, ordinal

    def applied(self, text):
        return text[:self.start] + self.new + text[self.start + len(self.old):]

    def __str__(self):
        return "%s | %s | %d | %s -> %s" % (self.file.split("restrip/", 1)[1], self.line, self.ordinal, self.old, self.new or "nothing")


def mutants_of(file, text):
    code, found, ordinals = code_of(text), [], {}
    for token in TOKEN.finditer(code):
        old, start = token[0], token.start()
        around = code[start - 1] + code[token.end()]
        if old[0].isdigit():
            new = hex(int(old, 16) + 1) if old.startswith("0x") else str(int(old) + 1)
        elif old in UNARY or old in ("++", "--"):
            new = SWAPPED[old]
        elif old not in SWAPPED or not (old[0].isalpha() or around.isspace() and len(around) == 2):
            continue  # a reference, a pointer, a sign, the brackets of a template
        else:
            new = SWAPPED[old]
        number = code.count("\n", 0, start)
        ordinals[number] = ordinals.get(number, 0) + 1
        found.append(Mutant(file, start, old, new, text.split("\n")[number].strip(), ordinals[number]))
    return found


class Judge:
    """Compiles tokens_judge.cpp against headers, the changed one first, and says what it prints; None where it does not."""

    FLAGS = ["-std=c++20", "-O1", "-w", "-D_GLIBCXX_ASSERTIONS"]

    def __init__(self, root, shared, own):
        self.source, self.own, self.standard, self.turning = root / "tests/runtime/tokens_judge.cpp", own, shared / "standard.hpp", shared / "indices/include"
        self.include = [root / "runtime/include", root / "tables/include"]
        own.mkdir()

    def compile_standard_headers(self):
        lines = re.findall(r"^#include <.*>\n", self.source.read_text(encoding="utf-8"), re.M)
        self.standard.write_text("".join(lines))
        subprocess.run(["c++", *self.FLAGS, "-x", "c++-header", self.standard, "-o", str(self.standard) + ".gch"], check=True)

    def says(self, file=None, text="", turns=False):
        changed = self.own / "changed" / file.split("include/", 1)[1] if file else None
        if changed:
            changed.parent.mkdir(parents=True, exist_ok=True)
            changed.write_text(text)
        try:
            folders = [self.own / "changed"] + [self.turning] * turns + self.include
            command = ["c++", *self.FLAGS, "-include", self.standard] + [word for folder in folders for word in ("-I", folder)]
            if subprocess.run(command + [self.source, "-o", self.own / "judge"], capture_output=True).returncode != 0:
                return None
            run = subprocess.run([self.own / "judge"], capture_output=True, timeout=TIMEOUT)
            return run.stdout if run.returncode == 0 else None
        except subprocess.TimeoutExpired:
            return None
        finally:
            if changed:
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
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--sample", type=int, default=0)
    options = parser.parse_args()
    root = options.root.resolve()
    listed = reasons(root / "tests/runtime/token_survivors.txt")
    texts = {file: (root / file).read_text(encoding="utf-8") for file in FILES}
    mutants = [mutant for file in FILES for mutant in mutants_of(file, texts[file])]
    key_of = lambda mutant, which: (mutant.file.split("restrip/", 1)[1], mutant.line, which)
    places = {key for mutant in mutants for key in (key_of(mutant, str(mutant.ordinal)), key_of(mutant, "*"))}
    faults = ["token_survivors.txt:%d: there is no such token: %s" % (number, " | ".join(key)) for key, number in listed.items() if key not in places]
    chosen = [mutant for mutant in mutants if mutant.file.endswith(options.only)]
    if options.sample:
        unlisted = [mutant for mutant in chosen if not {key_of(mutant, str(mutant.ordinal)), key_of(mutant, "*")} & set(listed)]
        chosen = unlisted[len(unlisted) // options.sample // 2::max(1, len(unlisted) // options.sample)][:options.sample]
    refused, survived = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        shared = pathlib.Path(folder)
        subprocess.run([options.generate, "automaton", "--cost", "indices", "--out", shared / "indices"], check=True, capture_output=True)
        idle = queue.SimpleQueue()
        judges = [Judge(root, shared, shared / str(number)) for number in range(options.jobs)]
        judges[0].compile_standard_headers()
        right, right_turns = judges[0].says(), judges[0].says(turns=True)
        if not right or not right_turns:
            raise ValueError("the judge says nothing of the sources as they are")
        for judge in judges:
            idle.put(judge)

        def survives(mutant):
            judge = idle.get()
            try:
                text = mutant.applied(texts[mutant.file])
                return judge.says(mutant.file, text) == right and (
                    not mutant.file.endswith(TURNING) or judge.says(mutant.file, text, turns=True) == right_turns)
            finally:
                idle.put(judge)

        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            for number, (mutant, lives) in enumerate(zip(chosen, pool.map(survives, chosen)), 1):
                refused, survived = refused + (not lives), survived + lives
                if lives and not {key_of(mutant, str(mutant.ordinal)), key_of(mutant, "*")} & set(listed):
                    faults.append("survives: %s" % mutant)
                    print(faults[-1], flush=True)
                if sys.stderr.isatty():
                    print("\r%d of %d" % (number, len(chosen)), end="", file=sys.stderr, flush=True)
    print("%d of %d tokens altered: %d refused, %d survive, %d without a reason" %
          (len(chosen), len(mutants), refused, survived, sum(fault.startswith("survives") for fault in faults)))
    for fault in faults:
        if not fault.startswith("survives"):
            print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
