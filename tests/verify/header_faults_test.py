"""A fault of one token in the code that answers out of the tables, and the verifier names the answer that is wrong.

The shipped headers are copied, every fault below is inserted with a switch, and the dump program is built from the copy,
once. With no fault switched on the verifier must accept its dump; with any, it must refuse, with exit code 1 and a line
that names the table and the configuration.

Fans up to k = 5 are enough for every fault. cross.demo and scripts/prove.sh judge the true headers for k <= 8.

  header_faults_test.py SOURCE_DIR COMPILER RESTRIP_VERIFY
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

source, compiler, verifier = sys.argv[1:4]
MAX_K = "5"

# File, what stands before the expression, the expression, the faulty ones, and in which table the first must show.
KEY, RULES = "rules/key.hpp", "rules/rules.hpp"
SITES = [
    (KEY, "if (!patch.has_chord() || !", "has(inner, patch.chord())", ["true", "false"], "collapse"),
    (RULES, "return turned_down(inner & low_bits(k + 2), exchange ? ", "arc + 1", ["arc", "a + 1"], "split"),
    (RULES, "const std::size_t by = exchange ? ", "a", ["k - a"], "split"),
    (RULES, "turned_down(ports, by, k), turned_down(joined, ", "by", ["0"], "split"),
    (RULES, "rule(ring_with_chord(at.k, ", "at.a", ["at.k - at.a"], "collapse"),
    (RULES, "before.joined(", "inner", ["inner >> 1"], "split"),
    (RULES, "rule(open_fan(at.k), path_with_chord(at.k, at.i, ", "at.j", ["at.k"], "open-split"),
    (RULES, "rule(open_fan(at.k), path(at.k, ", "at.i", ["at.k - at.i"], "boundary-split"),
    (RULES, "rule(path_with_chord(at.k, at.i, ", "at.j", ["at.k"], "open-collapse"),
    (RULES, "rule(path(at.k, ", "at.i", ["at.k - at.i"], "boundary-collapse"),
    (RULES, "tables::flip[static_cast<std::size_t>(", "inner", ["!inner"], "flip"),
]
SWITCH = """#include <cstdlib>
#include <type_traits>
inline const int restrip_fault_number = std::atoi(std::getenv("RESTRIP_FAULT"));
constexpr bool restrip_fault(int n) { return !std::is_constant_evaluated() && n == restrip_fault_number; }
"""


def replaced(text, old, new, file):
    assert text.count(old) == 1, "%s: not once: %s" % (file, old)
    return text.replace(old, new)


def put_in(include):
    """Puts all faults into the copied headers; returns (number, what, table) of each fault."""
    faults, texts = [], {}
    for file in (KEY, RULES):
        with open(os.path.join(include, "restrip", file), encoding="ascii") as opened:
            texts[file] = opened.read()
    for file, context, right, wrong, table in SITES:
        expression = right
        for token in wrong:
            faults.append((len(faults) + 1, "%s: %s%s -> %s" % (file, context, right, token), table))
            expression = "restrip_fault(%d) ? (%s) : (%s)" % (len(faults), token, expression)
        texts[file] = replaced(texts[file], context + right, "%s(%s)" % (context, expression), file)
    for file, text in texts.items():
        with open(os.path.join(include, "restrip", file), "w", encoding="ascii") as opened:
            opened.write(text)
    return faults


def verify(program, fault):
    """Exit code and output of the verifier on the dump."""
    command = "RESTRIP_FAULT=%d '%s' --max-k %s" % (fault, program, MAX_K)
    done = subprocess.run([os.path.abspath(verifier), "--headers", "--max-k", MAX_K, "--dump-command", command], capture_output=True, text=True, timeout=60, check=False)
    return done.returncode, done.stdout + done.stderr


with tempfile.TemporaryDirectory() as folder:
    include = os.path.join(folder, "include")
    for part in ("runtime", "tables"):
        shutil.copytree(os.path.join(source, part, "include"), include, dirs_exist_ok=True)
    faults = put_in(include)
    with open(os.path.join(folder, "switch.hpp"), "w", encoding="ascii") as opened:
        opened.write(SWITCH)
    program = os.path.join(folder, "dump")
    subprocess.run([compiler, "-std=c++20", "-O1", "-include", os.path.join(folder, "switch.hpp"), "-I", include, "-o", program]
                   + [os.path.join(source, "tables", "dump", name) for name in ("dump_tables.cpp", "dump_automaton.cpp", "dump_digests.cpp")], check=True)
    code, output = verify(program, 0)
    assert code == 0 and "\nverified: " in output, output
    survivors = []
    for number, what, table in faults:
        code, output = verify(program, number)
        if code == 0:
            survivors.append(what)
            continue
        assert code == 1, (what, code, output)
        named = re.findall(r"table (\S+)[^,\n]*(?:, inner [0-9a-f]+, ports [0-9a-f]+|: )", output)
        assert any(name.startswith(table) for name in named), (what, table, output)
    assert not survivors, "\n".join(["not noticed:"] + survivors)
print("%d faults noticed" % len(faults))
