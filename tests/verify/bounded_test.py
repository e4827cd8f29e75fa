#!/usr/bin/env python3
"""Claims: verify/bounded/look_up.c holds for what the generator writes in C and its controls fail, in small positions of
every operation and for operation files; after a change of any one of some entries it does not hold. Here each question is
asked of a program, as no model checker need be installed; where CBMC is, it is asked too. Without it, scripts/model_check.py
says what is missing. The same of the automaton, which is asked by keys and judged by key_look_up.c; and walk.c holds for it
whatever its numbers are, and no longer after a change of its code. Its numbers are those of the dump.

    bounded_test.py restrip-generate restrip-dump-tables ROOT SCRATCH
"""
import itertools
import os
import pathlib
import re
import subprocess
import sys

generate, dumped, root, scratch = *sys.argv[1:3], pathlib.Path(sys.argv[3]), pathlib.Path(sys.argv[4]).resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(root / "scripts"))
import model_check  # noqa: E402

CONTROLS = {"control: nothing is as good", "control: nothing is worse"}
scratch.mkdir(parents=True, exist_ok=True)


def printed(driver, question, *options):
    """The lines of a program that stands in for the model checker, asked this question."""
    (scratch / "position.h").write_text(question)
    subprocess.run(["cc", "-std=c11", "-O1", *options, "-I", scratch, "-I", root / "verify/bounded", root / "tests/verify" / driver,
                    "-o", scratch / "driver"], check=True)
    return subprocess.run([scratch / "driver"], capture_output=True, text=True, check=True).stdout.splitlines()


def failed(header, position, judge="look_up.c", bits="EDGES_BEFORE, PORTS, EDGES_AFTER, PORTS"):
    """The assertions that fail for a header at a position of model_check.py, and those that must."""
    name, *rest = position
    implementation = re.search(r"^#ifdef (\w+_IMPLEMENTATION)$", header.read_text(), re.M)[1]
    found = printed("bounded_driver.c", model_check.position_text(header, *rest), "-D" + implementation, f'-DJUDGE="{judge}"', "-DBITS=" + bits)
    after, may_go = rest[2], rest[3].get("MAY_GO", 0)
    return set(found), CONTROLS if after[1] or may_go else {"control: nothing is as good"}


def holds(header, position):
    found, controls = failed(header, position)
    assert found == controls, (position[0], found)


subprocess.run([generate, "tables", "--language", "c", "--max-k", "4", "--out", scratch], check=True, capture_output=True)
families = scratch / "restrip_tables.h"
positions = {position[0]: position for position in model_check.families(4)}
assert len(positions) == 1 + 2 * (2 + 3) + 2 * (1 + 3 + 6 + 10) + 2 * (2 + 3 + 4 + 5), len(positions)
for name in ("split(3, 1)", "split(3, 2)", "collapse(3, 2)", "open_split(2, 0, 2)", "open_split(3, 1, 2)", "open_collapse(3, 0, 3)",
             "boundary_split(3, 2)", "boundary_collapse(3, 0)", "boundary_collapse(1, 0)", "flip()"):
    holds(families, positions[name])

altered = scratch / "altered.h"
refused = 0
for name in ("bisect", "merge-boundary", "flip-matching"):
    file = root / "tables/operations" / (name + ".json")
    subprocess.run([generate, "rules", "--operation", file, "--language", "c", "--out", scratch], check=True, capture_output=True)
    header = scratch / ("restrip_%s.h" % name.replace("-", "_"))
    position, = model_check.own(file)
    holds(header, position)
    text = header.read_text()
    data = text.index("restrip_entries_of_")
    for number in itertools.islice(re.finditer(r"\b\d+\b,", text[text.index("{", data):]), 2, 9, 3):
        start = text.index("{", data) + number.start()
        altered.write_text(text[:start] + str(int(number[0][:-1]) ^ 1) + text[start + len(number[0]) - 1:])
        found, controls = failed(altered, position)
        assert found - CONTROLS, (name, number[0])
        refused += 1
assert refused == 9, refused

script = [sys.executable, "-B", root / "scripts/model_check.py"]
(scratch / "empty").mkdir(exist_ok=True)
run = subprocess.run(script, capture_output=True, text=True, env={**os.environ, "PATH": str(scratch / "empty")})
assert run.returncode == 2 and "there is no cbmc" in run.stderr, run
if subprocess.run(script, capture_output=True).returncode == 0:
    run = subprocess.run(script + ["--header", families, "--max-k", "1"], capture_output=True, text=True)
    assert run.returncode == 0 and "proved: flip, positions: 1\nproved in all: 7 positions, " in run.stdout, run
    run = subprocess.run(script + ["--operation", file, "--header", altered], capture_output=True, text=True)
    assert run.returncode == 1 and "NOT PROVED" in run.stdout, run

subprocess.run([generate, "automaton", "--language", "c", "--out", scratch], check=True, capture_output=True)
automaton = scratch / "restrip_automaton.h"
KEYED = "key_look_up.c", "PORTS, PORTS, EDGES_AFTER"
keyed = {position[0]: position for position in model_check.keyed(automaton, 4)}
assert len(keyed) == 4 + 7 + 14 + 20, len(keyed)
text = automaton.read_text()
next_of_empty = text.index("{", text.index("restrip_next[")) + 1
altered.write_text(text[:next_of_empty] + re.sub(r"^\s*1,", " 2,", text[next_of_empty:]))
for name in ("split(3, 1)", "collapse(4)", "open_split(3, 0, 2)", "boundary_split(3, 1)", "fan_collapse(4)", "fan_collapse(1)"):
    found, controls = failed(automaton, keyed[name], *KEYED)
    assert found == controls, (name, found)
found, controls = failed(altered, keyed["split(3, 1)"], *KEYED)
assert "nothing is better" in found, found
dump = scratch / "automaton.dump"
dump.write_bytes(subprocess.run([dumped, "--automaton", "--max-k", "3"], check=True, capture_output=True).stdout)
assert model_check.other_numbers(automaton, dump) == [] and model_check.other_numbers(altered, dump) == ["next"]


def walked(header):
    """Of each operation the assertions of walk.c that fail."""
    for _, text in model_check.walks(header, 4, 'any_number("NAME", i, LARGEST)'):
        yield printed("walk_driver.c", text, "-DRESTRIP_AUTOMATON_IMPLEMENTATION")


SAME, THERE, CONTROL = "the answers are the same", "there are answers where there is a position", "control: nothing is solid"
assert list(walked(automaton)) == list(walked(altered)) == [[CONTROL]] * 5, list(walked(automaton))  # whatever the numbers are
for now, then, what in (
        ("a >= k) return", "a > k) return", THERE), ("<< (a + 1)", "<< a", SAME), ("(links & restrip_low_bits(above)) << from", "links << from", SAME),
        ("meeting >> 4 & 15", "meeting & 15", SAME), ("key.joined &= closed ? ports : but_one", "key.joined &= ports", SAME),
        ("(end >> 3)", "(end >> 2)", SAME), ("restrip_read(&other, RESTRIP_LETTERS - 1)", "restrip_read(&other, 0)", SAME),
        ("i > k) return", "i >= k) return", THERE), ("restrip_read_fan(&arc, key, i, k)", "restrip_read_fan(&arc, key, 0, k)", SAME)):
    assert now in text, now
    altered.write_text(text.replace(now, then))
    assert any(what in failing for failing in walked(altered)), now

print("%d headers with one entry changed are refused" % refused)
