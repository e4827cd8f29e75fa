#!/usr/bin/env python3
"""Claims: restrip-lrat accepts the LRAT proofs that restrip-sat writes, and none of them with a line or a hint missing; it
accepts no proof of a formula that has a model; and it refuses files that are not exactly of their format, naming the file
and the line.

    lrat_test.py restrip-lrat SCRATCH [restrip-sat TABLES]
"""
import itertools
import pathlib
import random
import re
import subprocess
import sys

checker, scratch, prover = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
scratch.mkdir(parents=True, exist_ok=True)


def check(formula, proof):
    files = []
    for name, text in (("f.cnf", formula), ("p.lrat", proof)):
        files.append(scratch / name)
        files[-1].write_text(text)
    return subprocess.run([checker, *map(str, files)], capture_output=True, text=True, check=False)


def accepted(formula, proof):
    done = check(formula, proof)
    assert (done.returncode, done.stdout) in ((0, "s VERIFIED UNSAT\n"), (1, "s NOT VERIFIED\n")), done
    return done.returncode == 0


def refused(formula, proof, said):
    done = check(formula, proof)
    assert done.returncode == 1 and done.stdout == "", (formula, proof, done)
    assert re.search(said, done.stderr), (said, done.stderr)


def text_of(clauses, variables):
    return f"p cnf {variables} {len(clauses)}\n" + "".join(" ".join(map(str, [*clause, 0])) + "\n" for clause in clauses)


# ---- by hand: every clause over three variables
THREE = [list(signs) for signs in itertools.product(*((v, -v) for v in (1, 2, 3)))]
FORMULA = text_of(THREE, 3)
PROOF = "9 1 2 0 1 2 0\n9 d 1 2 0\n10 1 0 9 3 4 0\n11 -1 2 0 5 6 0\n12 0 10 11 7 8 0\n"
assert accepted(FORMULA, PROOF)
assert accepted("c a comment\n" + FORMULA, PROOF + "13 d 9 0\n")
assert accepted("p cnf 0 1\n0\n", "2 0 1 0\n")
assert accepted("p cnf 2 3\n1 0\n2 -1 2 0\n-2 -2 0\n", "4 0 1 2 3 0\n")  # a literal twice
assert not accepted(FORMULA, "")
assert not accepted(FORMULA, PROOF.replace("9 d 1 2 0", "9 d 1 2 3 0"))  # clause 3 is needed later
assert not accepted(text_of(THREE[:-1], 3), PROOF.replace(" 8 0", " 0"))
refused(FORMULA, "9 1 2 0 1 -2 0\n", r"p\.lrat: line 1: -2: RAT")
refused(FORMULA, PROOF.rstrip("\n"), r"p\.lrat: line 5: the file ends in the middle")
refused(FORMULA, "9 1 4 0 1 2 0\n", r"p\.lrat: line 1: there is no variable 4")
refused(FORMULA, "9 1 2 0 1 2\n", r"p\.lrat: line 1: the closing 0 is missing")
refused(FORMULA, "9 1 2 0 1 2 0 7\n", r"p\.lrat: line 1: the line goes on")
refused(FORMULA, "9 1 2 0 1 x 0\n", r'p\.lrat: line 1: "x" is not a number')
refused(FORMULA, "\n", r"p\.lrat: line 1: ")
refused(FORMULA.replace("p cnf 3 8", "p cnf 3 9"), PROOF, r"f\.cnf: line 1: 9 clauses announced, 8 found")
refused(FORMULA.replace("p cnf 3 8\n", ""), PROOF, r"f\.cnf: line \d+: \"p cnf")
refused(FORMULA.replace("1 2 3 0", "1 2 4 0"), PROOF, r"f\.cnf: line 2: there is no variable 4")
refused("", PROOF, r"f\.cnf: line 0: ")
assert subprocess.run([checker], capture_output=True, check=False).returncode == 2
assert subprocess.run([checker, "missing", "missing"], capture_output=True, check=False).returncode == 1

# ---- at random: whatever is accepted has no model
dice = random.Random(30)
right = wrong = 0
for _ in range(150):
    clauses = [[dice.choice((-1, 1)) * dice.randint(1, 3) for _ in range(dice.choice((1, 1, 2)))] for _ in range(dice.randint(5, 9))]
    proof = "".join(f"{len(clauses) + 1 + i} {dice.choice(('', '1 ', '-2 '))}0 " +
                    " ".join(str(dice.randint(1, len(clauses) + i)) for _ in range(dice.randint(2, 8))) + " 0\n" for i in range(3))
    has_model = any(all(any((l > 0) == signs[abs(l) - 1] for l in c) for c in clauses) for signs in itertools.product((False, True), repeat=3))
    found = accepted(text_of(clauses, 3), proof)
    assert not (found and has_model), (clauses, proof)
    right, wrong = right + found, wrong + (not found)
assert right > 10 and wrong > 10, (right, wrong)

# ---- proofs of restrip-sat: each line and each hint is needed
if prover:
    kept = scratch / "kept"
    done = subprocess.run([prover[0], "--tables-dir", prover[1], "--family", "flip", "--out", str(kept), "--lrat-checker", checker],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done
    last = done.stdout.splitlines()[-1]
    assert re.search(rf"proof lines checked by restrip-sat, the \d+ on which they rest by {re.escape(checker)};", last), last
    formula, lines = (kept / "flip.cnf").read_text(), (kept / "flip.lrat").read_text().splitlines()
    assert len(lines) > 20 and accepted(formula, "\n".join(lines) + "\n")
    for i, line in enumerate(lines):
        assert not accepted(formula, "".join(other + "\n" for other in lines[:i] + lines[i + 1:])), line
        words = line.split()
        hint = dice.randrange(words.index("0", 1) + 1, len(words) - 1)
        assert not accepted(formula, "".join(other + "\n" for other in [*lines[:i], " ".join(words[:hint] + words[hint + 1:]), *lines[i + 1:]])), line
    refusing = subprocess.run([prover[0], "--tables-dir", prover[1], "--family", "flip", "--lrat-checker", "false"],
                              capture_output=True, text=True, check=False)
    assert refusing.returncode == 1 and "NOT PROVED: false does not accept the proof" in refusing.stdout, refusing
print("the proofs of restrip-sat were checked too" if prover else "restrip-sat was left out")
