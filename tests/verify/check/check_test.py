#!/usr/bin/env python3
"""Claims: restrip-check accepts what `restrip replay --trace` records, under every policy, and counts what is there; it refuses
a trace in which anything was changed, and names the file, the line and what is wrong.

    check_test.py restrip-check restrip docs/how-to/check-a-run.md SCRATCH [long]

With `long` also a run on the bunny, if the environment variable RESTRIP_MESHES names its folder.
"""
import json
import os
import pathlib
import re
import subprocess
import sys

checker, program, document, scratch = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]), pathlib.Path(sys.argv[4])
scratch.mkdir(parents=True, exist_ok=True)


def run(*command, code=0):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    assert done.returncode == code, (command, done.returncode, done.stderr, done.stdout[-500:])
    return done


def traced(name, mesh, *options):
    """The trace of a replay, and what the checker says of it."""
    trace = scratch / f"{name}.trace"
    run(program, "replay", *mesh, "--repeats", 0, "--trace", trace, *options)
    return trace, accepted(trace)


def accepted(trace):
    facts = json.loads(run(checker, "--json", "-", trace).stdout)
    assert facts["accepted"] is True, facts
    last = run(checker, trace).stdout.splitlines()[-1]
    assert last.startswith("accepted: the trace was read to its end; after each of "), last
    assert str(facts["operations"]) in last, last
    return facts


def refused(text, said, name="damaged"):
    trace = scratch / f"{name}.trace"
    trace.write_bytes(text if isinstance(text, bytes) else text.encode())
    done = run(checker, trace, code=1)
    assert done.stdout == "", done.stdout
    assert re.fullmatch(rf"{re.escape(str(trace))}: line \d+: .*(?:{said}).*\n", done.stderr), (said, done.stderr)


# ---- accepted
torus = ("--built-in", "--triangles", 400)
for policy, claim in (("rules", "best"), ("local", "no-worse"), ("quick", "no-worse")):
    _, facts = traced(policy, torus, "--policy", policy, "--cost", "strips")
    assert facts["claim"] == claim and facts["splits"] == facts["collapses"] > 150, facts
    assert facts["operations"] == facts["splits"] + facts["collapses"], facts
_, facts = traced("indices", torus, "--policy", "quick", "--cost", "indices")
assert facts["claim"] == "valid" and facts["splits"] > 150, facts

# A mesh with a boundary, on which a walk does everything, flips included.
side = 12
grid = scratch / "grid.obj"
grid.write_text("".join(f"v {x} {y} {x * y % 3}\n" for y in range(side) for x in range(side)) +
                "".join(f"f {a + 1} {a + 2} {a + side + 2}\nf {a + 1} {a + side + 2} {a + side + 1}\n"
                        for y in range(side - 1) for a in range(y * side, y * side + side - 1)))
for policy in ("rules", "local", "quick"):
    _, facts = traced(f"walk-{policy}", (grid,), "--policy", policy, "--cost", "strips", "--walk", 1500)
    assert min(facts["splits"], facts["collapses"], facts["flips"]) > 100, facts
    assert len(facts["judged"]) == 7 and sum(facts["judged"].values()) == facts["operations"], facts

shown = scratch / "shown.trace"
shown.write_text(re.search(r"^(restrip-trace 1\n.*?)^```", document.read_text(), re.M | re.S)[1])
assert accepted(shown)["flips"] == 1

if "RESTRIP_MESHES" in os.environ and sys.argv[5:] == ["long"]:
    bunny = pathlib.Path(os.environ["RESTRIP_MESHES"]) / "bunny.obj"
    _, facts = traced("bunny", (bunny,), "--policy", "local", "--cost", "strips")
    assert facts["splits"] == facts["collapses"] > 30000, facts

# ---- steps: n log n, except for judging a patch, which takes n^2 for its n triangles. Words that the program allocates
# are counted instead.
def words_of(trace):
    done = subprocess.run([checker, trace], capture_output=True, text=True, check=True, env={**os.environ, "OCAMLRUNPARAM": "v=0x400"})
    return float(re.search(r"^minor_words: (\d+)", done.stderr, re.M)[1])


def long_trace(n, fan):
    """A closed fan of n triangles that is split, or a strip of n triangles that are replaced."""
    trace = scratch / f"long-{n}.trace"
    if fan:
        spokes = [(0, i + 1, (i + 1) % n + 1) for i in range(n)]
        new = [(n + 1, b, c) for _, b, c in spokes[:n // 2]] + [(0, 1, n + 1), (0, n + 1, n // 2 + 1)]
        before, lines = spokes, [f"split 0 {n + 1} 2 2 - {words(spokes[:n // 2])} + {words(new)}"]
        solid = []
    else:
        strip = [(i, i + 1, i + 2) if i % 2 == 0 else (i + 1, i, i + 2) for i in range(n)]
        solid = [(i + 1, i + 2) for i in range(n - 1)]
        moved = lambda all_: [tuple(v + n + 9 for v in one) for one in all_]
        before, lines = strip, [f"other 0 0 0 0 - {words(strip)} + {words(moved(strip))} d {words(solid)} s {words(moved(solid))}"]
    trace.write_text("\n".join(["restrip-trace 1", "claim valid"] + [f"t {words([t])}" for t in before] + [f"s {words([e])}" for e in solid] + lines + ["end 1", ""]))
    return trace


def words(all_):
    return " ".join(str(v) for one in all_ for v in one)


for fan in (True, False):
    once, twice = (words_of(long_trace(n, fan)) for n in (1000, 2000))
    assert once < twice < 2.3 * once, (fan, once, twice)

# ---- refused
whole = (scratch / "local.trace").read_text()
lines = whole.splitlines()
first = next(i for i, line in enumerate(lines) if line.startswith("split "))


def with_line(number, line):
    return "\n".join(lines[:number] + ([] if line is None else [line]) + lines[number + 1:]) + "\n"


def some(sign, count=5):
    """Operations that have such a list: its place, the words before it, its words, and those after it."""
    found = []
    for number in range(first, len(lines) - 1, 7):
        parts = re.split(r" (?=[-+ds] )", lines[number])
        for i, part in enumerate(parts[1:], 1):
            if part.startswith(sign + " "):
                found.append((number, parts[:i], part.split(" "), parts[i + 1:]))
    assert len(found) > count, sign
    return found[:: len(found) // count]


def rebuilt(before, words, after):
    return " ".join(before + ([" ".join(words)] if len(words) > 1 else []) + after)


# Colours: one edge fewer becomes solid or dashed, or one more.
for sign in "ds":
    for number, before, words, after in some(sign):
        refused(with_line(number, rebuilt(before, words[:-2], after)), "stated|solid|three solid edges|cycle")
        refused(with_line(number, rebuilt(before, words + words[-2:], after)), "solid already|is not solid")
solid = next(i for i, line in enumerate(lines) if line.startswith("s "))
refused(with_line(solid, None), "but|changes strips by")
refused(with_line(solid, lines[solid] + "\n" + lines[solid]), "solid already")

# The stated changes.
for number in range(first, len(lines) - 1, 97):
    words = lines[number].split(" ")
    for place, what in ((3, "strips"), (4, "isolated triangles")):
        for change in (-1, 1):
            other = words[:place] + [str(int(words[place]) + change)] + words[place + 1:]
            refused(with_line(number, " ".join(other)), f"{what}: stated ")

# Triangles: another corner, one fewer, two corners exchanged.
for sign in "-+":
    for number, before, words, after in some(sign):
        refused(with_line(number, rebuilt(before, [*words[:-1], "999999"], after)), "triangle|edge")
        refused(with_line(number, rebuilt(before, words[:-3], after)), "triangle|edge|stated")
        refused(with_line(number, rebuilt(before, [*words[:-2], words[-1], words[-2]], after)), "triangle|edge")
refused(with_line(2, None), "triangle|edge")
refused(with_line(2, lines[2] + "\n" + re.sub(r"\d+$", "999999", lines[2])), "already has one on that side")

# Lines that are missing, twice, or in the wrong order; a file that ends early, wherever that is.
for number in range(first, len(lines) - 1, 131):
    refused(with_line(number, None), "")
    refused(with_line(number, lines[number] + "\n" + lines[number]), "")
    refused(with_line(number, lines[number + 1] + "\n" + lines[number]), "")
refused("\n".join(lines[:-1]) + "\n", "ends without its last line")
refused(whole + "end 0\n", "text after the end")
refused(with_line(len(lines) - 1, "end 1"), "the end states 1 operations")
for size in range(0, len(whole) - 1, len(whole) // 15):
    refused(whole[:size], "")

# What is claimed of optimality, where all else is true.
def with_claim(name, claim):
    text = (scratch / f"{name}.trace").read_text()
    return re.sub("^claim .*$", f"claim {claim}", text, count=1, flags=re.M)


no_worse = r"a sound recolouring of the patch by [-+]\d+ and [-+]\d+"
refused(with_claim("indices", "no-worse"), no_worse)
refused(with_claim("indices", "best"), no_worse + "|is not one of the best")
refused(with_claim("quick", "best"), "is not one of the best sound recolourings")
damaged = scratch / "damaged.trace"
damaged.write_text(with_claim("rules", "no-worse"))
accepted(damaged)
for line in (f"split {lines[first].split(' ')[2]} {lines[first].split(' ')[1]} ", "collapse 0 1 ", "split 0 1 "):
    refused(with_line(first, line + lines[first].split(" ", 3)[3]), "is not a split|in the mesh|is not of the patch")
# The rule's last solid edge is left dashed, and the resulting strip and isolated triangles are stated.
for name, kind in (("rules", "split"), ("rules", "collapse"), ("walk-rules", "flip")):
    rules = (scratch / f"{name}.trace").read_text().splitlines()
    worse = 0
    for number, line in enumerate(rules):
        words = line.split(" ")
        if words[0] != kind or "s" not in words:
            continue
        shorter = words[5:-3] if words[-3] == "s" else words[5:-2]
        for isolated in range(3):
            line = " ".join([*words[:3], str(int(words[3]) + 1), str(int(words[4]) + isolated), *shorter])
            damaged.write_text("\n".join([*rules[:number], line, *rules[number + 1:]]) + "\n")
            worse += f"line {number + 1}: changes strips by" in run(checker, damaged, code=1).stderr
        if worse >= 3:
            break
    assert worse >= 3, (name, kind, worse)

# Triangles outside the patch that an operation removes or adds: removing two isolated ones would pay for a flip that costs
# two strips too many.
apart = "restrip-trace 1\nclaim no-worse\nt 0 1 2\nt 1 3 2\nt 10 11 12\nt 20 21 22\n"
flip = "flip 1 2 {} - 0 1 2 1 3 2{} + 0 1 3 0 3 2{}\nend 1\n"
damaged.write_text(apart + flip.format("-1 -2", "", " s 0 3"))
accepted(damaged)
refused(apart + flip.format("0 0", "", ""), no_worse)
refused(apart + flip.format("-2 -2", " 10 11 12 20 21 22", ""), "triangle 10 11 12 is removed, but is not of the patch of this flip")
refused(apart + flip.format("1 1", "", " 30 31 32"), "triangle 30 31 32 is added, but is not of the patch of this flip")
for kind in ("split", "collapse"):
    number = next(i for i, line in enumerate(lines) if line.startswith(kind))
    with_apart = lines[:2] + ["t 900001 900002 900003"] + lines[2:]
    words = lines[number].split(" ")
    words[3:5] = [str(int(words[3]) - 1), str(int(words[4]) - 1)]
    gone = words.index("-")
    words[gone + 1:gone + 1] = ["900001", "900002", "900003"]
    with_apart[number + 1] = " ".join(words)
    refused("\n".join(with_apart) + "\n", f"triangle 900001 900002 900003 is removed, but is not of the patch of this .*{kind}")

# Faults that arise away from the patch, or without a change of colour, whatever is claimed. A flip of two triangles stands apart from
# a fan with one dashed spoke, a strip, and from a triangle with two solid edges.
def mesh_of(claim):
    fan = [(100, 101 + i, 101 + (i + 1) % 6) for i in range(6)]
    star = [(200, 201, 202), (201, 200, 203), (202, 201, 204), (200, 202, 205)]
    solid = [(100, 101 + i) for i in range(6) if i != 1] + [(200, 201), (201, 202)]
    faces = [(0, 1, 2), (1, 3, 2), *fan, *star]
    return "\n".join(["restrip-trace 1", f"claim {claim}", *("t {} {} {}".format(*t) for t in faces), *("s {} {}".format(*e) for e in solid), ""])


for kind, claim in (("other", "valid"), ("flip", "valid"), ("other", "no-worse"), ("other", "best")):
    apart = kind + " 1 2 {} - 0 1 2 1 3 2 + 0 1 3 0 3 2 s 0 3{}\nend 1\n"
    damaged.write_text(mesh_of(claim) + apart.format("-1 -2", ""))
    accepted(damaged)
    refused(mesh_of(claim) + apart.format("-2 -2", " 100 102"), "triangle 100 .* form a cycle")
    refused(mesh_of(claim) + apart.format("-2 -3", " 202 200"), "triangle 200 201 202 has three solid edges")
    refused(mesh_of(claim) + apart.format("-1 -1", ""), r"isolated triangles: stated -1, found -2")
    refused(mesh_of(claim) + apart.format("0 -2", ""), r"strips: stated \+0, found -1")
    # Flipped in the fan: no colour changes, and the strip closes outside the two triangles.
    inside = kind + " 100 102 {} - 100 101 102 100 102 103 + 100 101 103 101 102 103{}\nend 1\n"
    refused(mesh_of(claim) + inside.format("0 1", ""), "triangle 100 101 103 form a cycle")
    refused(mesh_of(claim) + inside.format("0 0", " d 100 105 s 101 103"), "triangle 100 101 103 has three solid edges")
    refused(mesh_of(claim) + inside.format("0 1", " d 100 105"), r"strips: stated \+0, found \+1")
    if kind == "other":
        for right in (inside.format("1 1", " d 100 105"), inside.format("0 0", " d 100 101 s 101 103")):
            damaged.write_text(mesh_of(claim) + right)
            accepted(damaged)
    # The mesh at the beginning is judged as well.
    refused(mesh_of(claim) + "s 100 102\n" + apart.format("-1 -2", ""), "triangle 100 .* form a cycle")
    refused(mesh_of(claim) + "s 202 200\n" + apart.format("-1 -2", ""), "triangle 200 201 202 has three solid edges")

# Words that do not exist.
operation = lines[first].split(" ")
for wrong, said in (
    ("splits " + " ".join(operation[1:]), "is not the beginning of a line"),
    ("", "is not the beginning of a line"),
    (lines[first] + " ", "d?"),
    (lines[first] + " x", ""),
    (" ".join(operation[:4]), "two changes"),
    (" ".join([*operation[:3], "-0", *operation[4:]]), "is not a number"),
    (" ".join([*operation[:3], "1.5", *operation[4:]]), "is not a number"),
    (" ".join([operation[0], "4294967295", *operation[2:]]), "is beyond"),
    (" ".join([operation[0], "99999999999", *operation[2:]]), "is not a number"),
    ("t 1 2 3", "triangles before edges"),
):
    refused(with_line(first, wrong), said)
refused(whole.replace("restrip-trace 1", "restrip-trace 2", 1), "reads version 1")
refused(whole.replace("claim no-worse", "claim", 1), "second line")
refused(whole.replace("claim no-worse", "claim true", 1), "unknown claim")
refused(b"\xff\x00" + whole.encode(), "first line")

# ---- the program
done = run(checker, "--json", scratch / "report.json", scratch / "damaged.trace", code=1)
facts = json.loads((scratch / "report.json").read_text())
assert facts["accepted"] is False and facts["line"] == 1 and "first line" in facts["fault"], facts
assert run(checker, "--help").stdout.startswith("Checks a trace")
for wrong in ((), ("--json",), ("--json", "report.txt", "a.trace"), ("--jsn", "a.trace"), ("a.trace", "b.trace")):
    assert "--help" in run(checker, *wrong, code=2).stderr
assert "No such file" in run(checker, scratch / "none.trace", code=1).stderr
print("check: all hold")
