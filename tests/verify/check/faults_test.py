#!/usr/bin/env python3
"""Claim: check_test.py notices deliberate faults of restrip-check, so what it shows to be refused is not refused by chance.
Each fault is compiled into a copy of the sources.

    faults_test.py ocamlopt VERIFY_CHECK check_test.py ARGUMENTS…
    ARGUMENTS: those of check_test.py but for the first and the last, and a folder for copies
"""
import pathlib
import shutil
import subprocess
import sys

compiler, sources, test = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
*arguments, folder = sys.argv[4:]
scratch = pathlib.Path(folder)
WRITTEN = ["mesh.ml", "trace.ml", "patch.ml", "step.ml", "run.ml", "main.ml"]
# What is wrong, the file, the text, and what takes its place.
FAULTS = (
    ("nothing", "step.ml", "", ""),
    ("stated changes are believed", "step.ml", "if stated <> found then", "if false then"),
    ("a cycle is accepted", "step.ml", '| Round (a, b, c) -> refuse "the solid edges through triangle %d %d %d form a cycle" a b c', "| Round _ -> (0, 0)"),
    ("two triangles lie on one side of an edge", "mesh.ml", "if has_left mesh u v then refuse", "if false then refuse"),
    ("a worse recolouring is accepted", "run.ml", "if worse then", "if false then"),
    ("one of the best is any", "run.ml", "if claim = Best && not verdict.chosen then", "if false then"),
    ("triangles elsewhere pay for a worse rule", "run.ml", 'List.iter (expect_in_patch (among olds) "is removed" family) operation.gone;', ""),
)


def compile_in(copy, *words):
    subprocess.run([compiler, "-w", "-a", *words], cwd=copy, check=True)


def notices(number, file, text, other):
    copy = scratch / str(number)
    shutil.copytree(scratch / "judge", copy)
    for name in WRITTEN:
        source = (sources / name).read_text(encoding="utf-8")
        if name == file:
            assert not text or source.count(text) == 1, f"{file}: {text} is not there once"
            source = source.replace(text, other) if text else source
        (copy / name).write_text(source, encoding="utf-8")
    compile_in(copy, "-o", "restrip-check", "judge.cmx", "version.ml", *WRITTEN)
    done = subprocess.run([sys.executable, "-B", test, copy / "restrip-check", *arguments, copy / "traces"], capture_output=True, check=False)
    return done.returncode != 0


shutil.rmtree(scratch, ignore_errors=True)
(scratch / "judge").mkdir(parents=True)
for name in ("judge.mli", "judge.ml"):
    shutil.copy(sources / name, scratch / "judge")
(scratch / "judge/version.ml").write_text('let number = "0"\n', encoding="utf-8")
compile_in(scratch / "judge", "-c", "judge.mli", "judge.ml")
for number, (why, *fault) in enumerate(FAULTS):
    assert notices(number, *fault) == (number != 0), f"not noticed: {why}" if number else "the test fails without a fault"
    print(f"noticed: {why}" if number else "without a fault: all hold")
shutil.rmtree(scratch)
