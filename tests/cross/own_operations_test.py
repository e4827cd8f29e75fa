#!/usr/bin/env python3
"""A custom family is taken as a custom operation is: the generator solves every position up to --max-k, the
verifier proves the certificate, and refuses one that was forged or is for other positions. Files that make no family or no
operation on a mesh are refused by both programs, which say where and why.

  own_operations_test.py GENERATOR VERIFIER CORPUS FAMILIES CERTIFICATES SCRATCH
"""
import copy
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from generator_table import described  # noqa: E402

GENERATOR, VERIFIER, CORPUS, FAMILIES, CERTIFICATES, SCRATCH = map(Path, sys.argv[1:])
MAX_K = "6"

FAN = {
    "restrip_operation": 1,
    "name": "fan-own",
    "numbers": ["k", "i"],
    "where": "k >= 3, i < k",
    "position": "k {k} i {i}",
    "before": [["v", "u[j]", "u[j+1]", "j[0,k-1)"], ["v", "u[k-1]", "u[0]"]],
    "after": [["u[0]", "u[j]", "u[j+1]", "j[1,k-1)"]],
    "give_up": "all",
}
# Each fault: what is other in the family, and a word of each program.
REFUSED = {
    "no position so small": ({"where": "k >= 9, i < k"}, "fan-own has no position up to 6", "has no position up to 6"),
    "positions of one name": ({"position": "k {k}"}, 'also "{i}"', 'also "{i}"'),
    "an unknown number": ({"where": "k >= 2, j < k"}, "where", "expected a sum of k, i"),
    "four numbers": ({"numbers": ["k", "i", "j", "l"]}, "numbers: expected a list of at most 3 numbers, found a list of 4", "numbers"),
    # Between a and b, a row of vertices inside a quadrilateral: an operation, were there not 18 triangles and more.
    "too many triangles": (
        {"before": [["a", "u[j]", "u[j+1]", "j[0,3 k)"], ["b", "u[j+1]", "u[j]", "j[0,3 k)"]], "after": [["a", "u[0]", "b"], ["b", "u[3 k]", "a"]]},
        "before: expected 1 to 16 triangles", "before: expected 1 to 16 triangles"),
    "too many edges": ({"before": [["v", "u[j]", "u[j+1]", "j[0,11)"], ["v", "u[11]", "u[0]"]], "after": [["u[0]", "u[j]", "u[j+1]", "j[1,11)"]]},
                       "at most 22 edges and ports together", "at most 22 edges and ports together, found 12 and 12"),
    "a cost that cannot be searched": (
        {"before": [["v", "u[j]", "u[j+1]", "j[0,9)"], ["v", "u[9]", "u[0]"]], "after": [["u[0]", "u[j]", "u[j+1]", "j[1,9)"]], "give_up": "none",
         "cost": [[{"count": "isolated"}]]}, "has no sound recolouring", "beyond 8 only rules of the default cost can be verified"),
    "a term too many": ({"where": "k >= 2, i < k" + " + k - k" * 8}, "at most 16 terms of a sum", "a sum of at most 16 terms"),
    "a range of millions": ({"before": [["v", "u[j]", "u[j+1]", "j[0,9999 k)"]]}, "expected 1 to 16 triangles", "expected numbers from 0 to 16"),
    "a number twice": ({"numbers": ["k", "i", "k"]}, "numbers[2]: this number is listed already", "numbers[2]: expected each number once"),
    "the place of a number": ({"position": "k {k} i {i} {0}"}, "expected braces only around", "braces only around"),
    "no list of bounds": ({"at_most": 1}, "at_most: expected a list of at most 64 bounds, found 1", "at_most: expected a list of at most 64 bounds, found 1"),
    "a bound of nothing known": ({"at_most": [{"swaps": 1}]}, "at_most[0].swaps: unknown member", "at_most[0].swaps: unknown member"),
}

TRIANGLES = {
    "restrip_operation": 1,
    "name": "hub-own",
    "numbers": ["k", "i"],
    "where": "k >= 4, i < 1",
    "before": [["v", "u[j]", "u[j+1]", "j[0,k-1)"], ["v", "u[k-1]", "u[0]"]],
    "after": [["u[0]", "u[j]", "u[j+1]", "j[1,k-1)"]],
    "give_up": "all",
}
BEFORE, LAST = TRIANGLES["before"]
REFUSED_TRIANGLES = {
    "no such number": ({"after": [["u[0]", "u[j]", "u[j+m]", "j[1,k-1)"]]}, "expected a number of the family", "expected a sum of k, i, j"),
    "an index without values": ({"after": [["u[0]", "u[j]", "u[j+1]"]]}, "expected a number of the family", "expected a sum of k, i"),
    "an index that is a number": ({"after": [["u[0]", "u[i]", "u[i+1]", "i[1,k-1)"]]}, "other than the numbers of the family", "other than the numbers of the family"),
    "an index without end": ({"after": [["u[0]", "u[j]", "u[j+1]", "j"]]}, "expected an index with its values", "expected a range"),
    "five words": ({"after": [["u[0]", "u[j]", "u[j+1]", "j[1,k-1)", "j"]]}, "three vertices, and an index", "three vertices, and an index"),
    "an open bracket": ({"after": [["u[0]", "u[j]", "u[j+1", "j[1,k-1)"]]}, 'expected "]"', "expected a vertex as"),
    "a negative index": ({"before": [["v", "u[j-1]", "u[j]", "j[0,k-1)"], LAST]}, "u[-1] is not a vertex (hub-own k 4 i 0)", "no negative index"),
    "values below 0": ({"after": [["u[0]", "u[j]", "u[j+1]", "j[k-5,k-1)"]]}, "is not a range of indices", "expected numbers from 0 to 16"),
    "a rim that is another": (
        {"after": [["u[0]", "u[j]", "u[j+1]", "j[1,k-2)"]]}, "hub-own.json:1:177: after: u_0 u_1 u_2: u_2 u_0 is an edge of the outline",
        "before[0]: expected the same outline on both sides"),
    "a rim with a gap": ({"before": [BEFORE]}, "hub-own.json:1:152: after: u_0 u_2 u_3: u_3 u_0 is an edge of the outline", "(k = 4, i = 0)"),
    "triangles that overlap": ({"before": [BEFORE, LAST, LAST]}, "the edge v u_3 has two triangles already", "at most two triangles at the edge"),
    "too many triangles": ({"before": [["v", "u[j]", "u[j+1]", "j[0,4 k)"], LAST]}, "expected 1 to 16 triangles", "expected 1 to 16 triangles"),
    "a stretch to nowhere": ({"boundary": [["u[0]", "u[k]"]]}, "boundary: expected vertices of the outline", "boundary[0]: expected vertices that the outline has"),
    "another form": ({"after": {"path": ["u[0,k-2)"]}}, "after: expected a list of 1 to 16 triangles", "after: expected a list of 1 to 16 triangles"),
    "a section for all": ({"section": "k {k}"}, "has a section for each position", "expected all numbers"),
}
# Of the corpus: the place that both name, and a word of each.
REFUSED_ON_A_MESH = {
    "bad-name": ("before[0]", "20 letters", "20 letters"),
    "closed": ("before", "close up", "Euler characteristic 2"),
    "crossed-ports": ("after[0]|before[1]", "c b is an edge of the outline after", "a d is on it before"),
    "disconnected": ("before[1]", "not connected to triangle 0", "connected over edges"),
    "handle": ("before", "handle", "Euler characteristic -1"),
    "no-port": ("before", "expected 1 to 12 ports", "expected 1 to 12 ports, found 0"),
    "overlapping-stretches": ("boundary[1]", "in a stretch already", "in two"),
    "parity": ("after[0]|before[0]", "a m is an edge of the outline after", "a b is on it before"),
    "pinched": ("before", "around a are 2 fans", "around a are several"),
    "ring": ("before", "several parts", "Euler characteristic 0"),
    "stretch-to-nowhere": ("boundary[0]", "m is not one before", '"m" is not on it before'),
    "three-at-an-edge": ("before[2]", "has two triangles already", "found three"),
    "too-many-ports": ("before", "expected 1 to 12 ports", "expected 1 to 12 ports, found 13"),
    "turned-triangle": ("before[1]", "is one of them clockwise?", "opposite directions"),
    "vanishing-rim": ("after[0]|before[1]", "edge of the outline", "the same outline"),
    "vertex-twice": ("before[0]", "three different vertices", "three different vertices"),
}


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


def expect(condition, what):
    if not condition:
        sys.exit(what)


def up_to(max_k):
    """The option of families; none of single operations."""
    return ("--max-k", max_k) if max_k else ()


def solve(file, max_k=MAX_K):
    return run(GENERATOR, "rules", "--operation", file, "--out", SCRATCH, *up_to(max_k))


def certificate(name):
    return SCRATCH / "certificates/operations" / (name + ".cert")


def verify(file, name, *options, max_k=MAX_K):
    return run(VERIFIER, "--operation", file, "--certificate", certificate(name), *up_to(max_k), *options)


def sealed(lines):
    """The lines of a certificate, without its last, with a last one that fits."""
    text = ("\n".join(lines) + "\n").encode()
    rows = sum(line.startswith(("rule ", "copy ")) for line in lines)
    return text + b"end %d %d %d\n" % (rows, sum(text), sum(place * byte for place, byte in enumerate(text, 1)))


def forge(name, change):
    """Writes the certificate again with one row changed."""
    lines = certificate(name).read_text().splitlines()[:-1]
    place = next(i for i in reversed(range(len(lines))) if change(lines[i]) != lines[i])
    lines[place] = change(lines[place])
    certificate(name).write_bytes(sealed(lines))


def without(column):
    """A rule with no solid edges in this column: R (3), or K (4)."""
    def change(row):
        words = row.split()
        if words[0] != "rule" or words[column] == "0":
            return row
        return " ".join([*words[:column], "0", *words[column + 1:]])
    return change


def check_own_families():
    files = sorted(CORPUS.glob("families/*.json"))
    expect(len(files) >= 4, "files are missing")
    for file in files:
        name = file.stem
        made = solve(file)
        expect(made.returncode == 0 and " bytes\n" in made.stdout, f"{name}: {made.stderr}{made.stdout}")
        sections = [line for line in certificate(name).read_text().splitlines() if line.startswith("section ")]
        expect(len(sections) >= 3, f"{name}: only {sections}")
        proved = verify(file, name)
        expect(proved.returncode == 0 and "\nverified: " in proved.stdout, f"{name}: {proved.stderr}{proved.stdout}")
        gives_up = "give_up" in json.loads(file.read_text())
        expect(("as good, no sound recolouring has fewer given_up" in proved.stdout) or not gives_up, f"{name}: {proved.stdout}")
        fewer = verify(file, name, max_k="5")
        expect(fewer.returncode == 2 and "section" in fewer.stderr, f"{name}: k to 6 taken for k to 5: {fewer.stderr}")
        forge(name, without(4 if gives_up else 3))
        forged = verify(file, name)
        expect(forged.returncode == 1 and "no sound recolouring has fewer" in forged.stdout, f"{name}: forged, and taken")
        expect("NOT verified" in forged.stdout, f"{name}: {forged.stdout}")


def check_ports_given_up():
    """Splits that may give ports up: how many configurations then cost a strip is what docs/explanation/theory.md says of each position."""
    for k, a, costing in ((5, 2, 4), (4, 2, 2), (6, 3, 9)):
        operation = {**described("split", k, a), "give_up": "all"}
        file = SCRATCH / f"{operation['name']}.json"
        file.write_text(json.dumps(operation))
        expect(solve(file, None).returncode == 0, file)
        proved = verify(file, operation["name"], max_k=None)
        expect(proved.returncode == 0 and "\nverified: " in proved.stdout, f"{file}: {proved.stderr}{proved.stdout}")
        expect(f"\nclaim costing {costing}\n" in certificate(operation["name"]).read_text(), f"{file}: not {costing} configurations")


def check_shipped_names():
    """A shipped operation's name is for its file: with another description under it the library would use the user's table."""
    for shipped in sorted(FAMILIES.parent.glob("operations/*.json")):
        expect(solve(shipped, None).returncode == 0, shipped)
        description = json.loads(shipped.read_text())
        file = SCRATCH / shipped.name
        file.write_text(json.dumps({**description, "after": [triangle[1:] + triangle[:1] for triangle in description["after"]]}))
        for done in (solve(file, None), verify(file, shipped.stem, max_k=None)):
            expect(done.returncode == 2 and f'{shipped.stem}.json:1' in done.stderr and "is an operation of restrip" in done.stderr, done.stderr)


def check_unchanged():
    """Files that have their bytes are left alone, and all others are written."""
    out, file = SCRATCH / "unchanged", SCRATCH / "first.json"
    text = {**json.loads((CORPUS / "split-face-own.json").read_text()), "name": "first"}
    file.write_text(json.dumps(text))
    header, certificate = (Path(path) for path in ("include/restrip/tables/operations/first.hpp", "certificates/operations/first.cert"))

    def writes(expected, *command):
        for path in out.rglob("*"):  # whatever the clock's resolution
            os.utime(path, ns=(0, 0))
        done = run(GENERATOR, *command, "--out", out)
        expect(done.returncode == 0 and " bytes" in done.stdout, f"{command}: {done.stdout}{done.stderr}")
        written = {path.relative_to(out) for path in out.rglob("*") if path.is_file() and path.stat().st_mtime_ns != 0}
        expect(written == expected, f"{command}: {written}")

    rules = ("rules", "--operation", file)
    writes({header, certificate}, *rules)
    writes(set(), *rules)
    writes({Path("restrip_rule_of_first.h"), Path("restrip_check_of_first.c")}, *rules, "--language", "c++,c")
    bytes_of = (out / header).read_bytes()
    for altered in (bytes_of + b"\n", bytes_of[:-1], bytes_of.replace(b"0", b"1", 1), b""):
        (out / header).write_bytes(altered)
        writes({header}, *rules)
        expect((out / header).read_bytes() == bytes_of, "an altered header stays")
    (out / certificate).unlink()
    writes({certificate}, *rules)
    file.write_text(json.dumps({**text, "about": "Another sentence."}))
    writes({header}, *rules)
    expect(b"Another sentence." in (out / header).read_bytes(), "the old header stays")
    automaton = {Path("include/restrip/tables/automaton.hpp"), Path("certificates/automaton.cert")}
    tables = ("tables", "--max-k", "3")
    writes({Path("MANIFEST"), Path("include/restrip/tables/rows.hpp"), *automaton} |
           {Path(path.format(name)) for name in ("split", "collapse", "flip") for path in ("include/restrip/tables/{}.hpp", "certificates/{}.cert")}, *tables)
    writes(set(), *tables)
    (out / "MANIFEST").unlink()
    writes({Path("MANIFEST")}, *tables)
    (out / "include/restrip/tables/automaton.hpp").unlink()
    writes({Path("include/restrip/tables/automaton.hpp")}, "automaton")


REFINE_FACE = {
    "restrip_operation": 1, "name": "refine-own",
    "before": [list(corners) for corners in ("abc", "baz", "cbx", "acy")],
    "after": [list(corners) for corners in ("rpq", "pra", "qpb", "rqc", "azp", "zbp", "bxq", "xcq", "cyr", "yar")],
}


def check_bounds():
    """A bound is verified exactly if it is no less than what the rules add, at all positions of a header."""
    def judged(description, *options, max_k=None):
        name = description["name"]
        file = SCRATCH / f"{name}.json"
        file.write_text(json.dumps(description))
        made = solve(file, max_k)
        expect(made.returncode == 0, made.stderr)
        return verify(file, name, *options, max_k=max_k)

    join = {**REFINE_FACE, "name": "join-own", "before": [list(corners) for corners in ("abm", "bcm", "mca")], "after": [list("abc")], "give_up": "all"}
    for description, most in ((REFINE_FACE, 6), (join, 2)):
        for bound in (most - 2, most - 1, most):
            done = judged({**description, "at_most": [{"indices": bound}]})
            expect(done.returncode == int(bound < most) and f"adds at most {most} to 3 strips + swaps" in done.stdout, f"{bound}: {done.stdout}{done.stderr}")
            expect((f"adds {most} to 3 strips + swaps, the family claims at most {bound}" in done.stdout) == (bound < most), done.stdout)
    splits = {"restrip_operation": 1, "name": "bs-own", "numbers": ["k", "i"], "where": "k >= 1, i <= k", 
              "boundary": [["u[k]", "u[0]"]], "before": [["v", "u[j]", "u[j+1]", "j[0,k)"]],
              "after": [["v", "u[j]", "u[j+1]", "j[0,i)"], ["v", "u[i]", "w"], ["w", "u[j]", "u[j+1]", "j[i,k)"]]}
    header = SCRATCH / "include/restrip/tables/operations/bs_own.hpp"
    for listed, strips, failing in (("2 i <= k", 1, ()), ("2 i <= k", 0, ("no rule costs above 1 strip", "no answer exceeds what the family claims")),
                                    ("i = 1", 0, ("images of ones with rules", "no answer exceeds what the family claims")),
                                    ("i = 1", 1, ("images of ones with rules",))):
        done = judged({**splits, "listed": listed, "at_most": [{"strips": strips}]}, "--header", header, max_k="4")
        fails = [line for line in done.stdout.splitlines() if line.startswith("FAILS")]
        expect(done.returncode == bool(failing) and len(fails) == len(failing) and all(what in line for what, line in zip(failing, fails)), done.stdout)


def check_links():
    """An output that leads to the operation file is refused; an operation file may be a pipe."""
    file = SCRATCH / "symlinked.json"
    text = (CORPUS / "split-face-own.json").read_text()
    file.write_text(text)
    for folder, name in (("include/restrip/tables/operations", "split_face_own.hpp"), ("certificates/operations", "split-face-own.cert")):
        out = SCRATCH / "links" / folder
        out.mkdir(parents=True, exist_ok=True)
        (out / name).unlink(missing_ok=True)
        (out / name).symlink_to(file)
        done = run(GENERATOR, "rules", "--operation", file, "--out", SCRATCH / "links")
        expect(done.returncode == 2 and f"{name}: is the input" in done.stderr and file.read_text() == text, done.stderr)
        (out / name).unlink()
    expect(solve(file, None).returncode == 0, "without links")
    report = run(VERIFIER, "--operation", file, "--certificate", certificate("split-face-own"), "--json", file)
    expect(report.returncode == 2 and "is the input" in report.stderr and file.read_text() == text, report.stderr)
    piped = subprocess.run([VERIFIER, "--operation", "/dev/stdin", "--certificate", certificate("split-face-own")], input=text, capture_output=True,
                           text=True, check=False)
    expect(piped.returncode == 0 and "\nverified: " in piped.stdout, piped.stderr)


def check_refused(without_fault, refused):
    name = without_fault["name"]
    file = SCRATCH / (name + ".json")
    for what, (change, by_generator, by_verifier) in {"nothing": ({}, "", ""), **refused}.items():
        family = copy.deepcopy(without_fault)
        family.update(change)
        file.write_text(json.dumps(family))
        if change:
            certificate(name).write_text("")
        for done, words in ((solve(file), by_generator), (verify(file, name), by_verifier)):
            if not change:
                expect(done.returncode == 0, f"the family without a fault: {done.stderr}{done.stdout}")
                continue
            expect(done.returncode == 2, f"{what}: taken by {done.args[0]}: {done.stdout}{done.stderr}")
            expect(any(word in done.stderr for word in words.split("|")), f"{what}: {done.stderr}")


def check_automaton():
    """Families that the automaton answers get a look-up; others a sentence."""
    refused = {
        "spoke-flips": "it may give ports up", "hub-goes": "it may give ports up",
        "bisect": "it is an operation with one position",
    }
    for name in ("fan-becomes-star", "corner-turns", *refused):
        file = next(CORPUS.glob(f"**/{name}.json"), None) or FAMILIES.parent / f"operations/{name}.json"
        done = run(GENERATOR, "automaton", "--operation", file, "--out", SCRATCH)
        header = SCRATCH / f"include/restrip/automaton/{name.replace('-', '_')}.hpp"
        if name in refused:
            expect(done.returncode == 2 and refused[name] in done.stderr and not header.exists(), f"{name}: {done.stderr}")
        else:
            expect(done.returncode == 0 and done.stdout.split() == [str(header.relative_to(SCRATCH))], f"{name}: {done.stderr}{done.stdout}")
            expect(f" best_of_{name.replace('-', '_')}(" in header.read_text(), f"{name}: {header.read_text()}")
    for change, sentence in (({"constraint": "matching"}, "its solid edges are not strips"), ({"cost": [[{"count": "isolated"}]]}, "a custom cost"),
                             ({"before": FAN["before"], "after": FAN["after"]}, "is not a fan with one port at each triangle")):
        family = {**FAN, "give_up": "none", "before": FAN["after"], "after": FAN["before"], **change}
        file = SCRATCH / "fan-own.json"
        file.write_text(json.dumps(family))
        done = run(GENERATOR, "automaton", "--operation", file, "--out", SCRATCH)
        expect(done.returncode == 2 and sentence in done.stderr, f"{sentence}: {done.stderr}")
    hub = [["v", "u[i]", "u[i+1]", "i[0,k-1)"], ["v", "u[k-1]", "u[0]"]]
    row = [["u[0]", "u[i]", "u[i+1]", "i[1,k-1)"]]
    late = ["u[1]", "u[0]", "x[i]", "i[9,k)"]  # a range that ends before it begins, up to k = 8
    file.write_text(json.dumps({"restrip_operation": 1, "name": "fan-own", "numbers": ["k"], "where": "3 <= k <= 10",
                                "before": row + [late], "after": hub + [late], "give_up": "none"}))
    done = run(GENERATOR, "automaton", "--operation", file, "--out", SCRATCH)
    expect(done.returncode == 2 and "its ranges as a sum give" in done.stderr, f"a range that ends before it begins: {done.stderr}")
    file = CORPUS / "families/corner-turns.json"
    report = json.loads(run(GENERATOR, "automaton", "--operation", file, "--json", "-", "--out", SCRATCH).stdout)
    expect([one["path"] for one in report["files"]] == ["include/restrip/automaton/corner_turns.hpp"], report)


def check_corpus():
    """Single operations: ones that are impossible on a mesh, and valid ones."""
    refused = json.loads((CORPUS.parent / "refused_operations.json").read_text())
    expect(refused.keys() == REFUSED_ON_A_MESH.keys(), f"files and expectations differ: {refused.keys() ^ REFUSED_ON_A_MESH.keys()}")
    for name, (place, *words) in REFUSED_ON_A_MESH.items():
        file = SCRATCH / f"{name}.json"
        file.write_text(json.dumps(refused[name], indent=1))
        certificate(name).write_text("")
        for done, word in zip((solve(file, None), verify(file, name, max_k=None)), words):
            expect(done.returncode != 0, f"{name}: taken")
            where = "|".join(re.escape(p) for p in place.split("|"))
            expect(re.search(rf"{name}\.json:\d+(:\d+)?: ({where}): ", done.stderr), f"{name}: the place is not {place}: {done.stderr}")
            expect(word in done.stderr, f"{name}: expected {word}: {done.stderr}")
    shipped = sorted((FAMILIES.parent / "operations").glob("*.json"))
    expect(len(shipped) >= 10, "files are missing")
    for file in shipped:
        for done in (solve(file, None), verify(file, file.stem, max_k=None)):
            expect(done.returncode == 0, f"{file.stem}: {done.stderr}{done.stdout[-300:]}")


def check_proven():
    """What the generator makes of the corpus, with all kinds of costs, constraints and ports given up, is proven."""
    files = sorted(CORPUS.glob("*.json"))
    expect(len(files) >= 6, "operations are missing")
    for file in files:
        header = SCRATCH / "include/restrip/tables/operations" / (file.stem.replace("-", "_") + ".hpp")
        for done in (solve(file, None), verify(file, file.stem, "--header", header, max_k=None)):
            expect(done.returncode == 0, f"{file.stem}: {done.stderr}{done.stdout[-300:]}")


def check_single():
    done = solve(CORPUS / "split-face-own.json")
    expect(done.returncode == 2 and "not a family, so --max-k has no effect" in done.stderr, done.stderr)


shutil.rmtree(SCRATCH, ignore_errors=True)
SCRATCH.mkdir(parents=True)
check_own_families()
check_ports_given_up()
check_refused(FAN, REFUSED)
check_refused(TRIANGLES, REFUSED_TRIANGLES)
check_automaton()
check_corpus()
check_proven()
check_single()
check_bounds()
check_shipped_names()
check_links()
check_unchanged()
