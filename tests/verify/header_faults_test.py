"""A fault of one token in the code that answers out of the tables, and the verifier names the answer that is wrong.

The shipped headers are copied, every fault below is inserted with a switch, and the dump program is built from the copy,
once. With no fault switched on the verifier must accept both of its dumps; with any, it must refuse, with exit code 1
and a line that names the table and the configuration. The loops of the look-up are bounded in the copy: a fault that
makes one of them endless ends the dump program after MOST_STEPS steps, which counts as noticed, and says so.

Fans up to k = 5 are enough for every fault. That the true headers hold for larger ones is cross.demo (all
that the rules answer, k <= 8), verify.linked_look_up (k <= 7) and scripts/prove.sh (both, k <= 8).

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
MOST_STEPS = 100  # a path meets each of eight ports twice at most, and the longest list has 82 rows

# File, what stands before the expression, the expression, the faulty ones, and in which table the first must show.
KEY, RULES, LINKED = "rules/key.hpp", "rules/rules.hpp", "operations/linked.hpp"
OUTLOOK = "operations/impl/outlook.hpp"
SITES = [
    (KEY, "if (!", "has(inner, k + 2)", ["true", "false"], "collapse"),
    (KEY, "return {back(along | name_of_pair(ring, pair, elements)), ", "back(pair)", ["0"], "linked-collapse"),
    (RULES, "reversed(seen, ", "k + 1", ["k"], "open-split"),
    (RULES, "return turned_down(inner & low_bits(k + 2), exchange ? ", "arc + 1", ["arc", "a + 1"], "split"),
    (RULES, "const std::size_t by = exchange ? ", "a", ["k - a"], "split"),
    (RULES, "turned_down(ports, by, k), turned_down(joined, ", "by", ["0"], "split"),
    (RULES, "k, mirrored ? k - i : i, seen_ports,\n                                 joined_open(k, ", "seen_loop",
     ["loop"], "boundary-split"),
    (RULES, "return detail::rule(mirrored ? detail::reversed(seen, ", "k", ["k - 1"], "boundary-split"),
    (RULES, "return {0, count_bits(inner) - 2, false};\n  const Word joined = joined_ring(k, ", "a", ["k - a"], "collapse"),
    (RULES, "fan_collapse_colors(k, ports, joined_path_with_chord(k, i, ", "j", ["k"], "open-collapse"),
    (RULES, "fan_collapse_colors(k, ports, joined_path(k, ", "i", ["k - i"], "boundary-collapse"),
    (RULES, "tables::flip[static_cast<std::size_t>(", "inner", ["!inner"], "flip"),
    # "false" is not a fault: the loop below the line finds the same, later.
    (OUTLOOK, "if (", "after == before_ || after == Pairs{}", ["true"], "linked-"),
    (LINKED, "exchange ? ", "arc + 1", ["arc"], "linked-split"),
    (LINKED, "const std::size_t by = exchange ? ", "a", ["k - a"], "linked-split"),
    (OUTLOOK, "(*look_out_)(turn(", "i + by_", ["i"], "linked-split"),
    (OUTLOOK, "turn(static_cast<std::size_t>(seen) + ", "k_ - by_", ["k_"], "linked-split"),
    (OUTLOOK, "if (port == home) return ", "comes_back", ["strip_ends"], "linked-"),
    (OUTLOOK, "if (one < 0) return ", "one == strip_ends", ["true", "false"], "linked-"),
    # "true" is not a fault: a path that is out of sight from one end does not come back from the other.
    (OUTLOOK, "if (two < 0) return ", "two == strip_ends", ["false"], "linked-"),
    (OUTLOOK, "return ", "inside != start &&\n           (inside == static_cast<std::size_t>(two) || follow(before_, inside, start, ignored) == two)",
     ["true", "false", "inside != start", "inside != start && inside == static_cast<std::size_t>(two)"], "linked-"),
    (OUTLOOK, "before_.partner(i) != j && ", "!stays_open(after, i, j, path)", ["stays_open(after, i, j, path)"], "linked-"),
    (LINKED, "detail::turned_down(joined_closed(k, loop, ports), ", "by", ["0"], "linked-split"),
]
# Loops, and what they are in the copy.
LOOPS = [
    (OUTLOOK, "for (;;) {", "for (int steps = 0;; restrip_step(++steps)) {"),
    (LINKED, "while (outlook.may_close(TablePairs{tables::pairings[table.rules[at].pairing]}) != 0) ++at;",
     "for (int steps = 0; outlook.may_close(TablePairs{tables::pairings[table.rules[at].pairing]}) != 0; restrip_step(++steps))\n"
     "    if (++at == table.rules.size()) restrip_step(%d);" % MOST_STEPS),
]
SWITCH = """#include <cstdio>
#include <cstdlib>
#include <type_traits>
inline const int restrip_fault_number = std::atoi(std::getenv("RESTRIP_FAULT"));
constexpr bool restrip_fault(int n) { return !std::is_constant_evaluated() && n == restrip_fault_number; }
inline void restrip_step(int steps) {
  if (steps < %d) return;
  std::fputs("the look-up does not end\\n", stderr);
  std::_Exit(3);
}
""" % MOST_STEPS


def replaced(text, old, new, file):
    assert text.count(old) == 1, "%s: not once: %s" % (file, old)
    return text.replace(old, new)


def put_in(include):
    """Puts all faults into the copied headers, and bounds their loops; returns (number, what, table) of each fault."""
    faults, texts = [], {}
    for file in (KEY, RULES, LINKED, OUTLOOK):
        with open(os.path.join(include, "restrip", file), encoding="ascii") as opened:
            texts[file] = opened.read()
    for file, old, new in LOOPS:
        texts[file] = replaced(texts[file], old, new, file)
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
    """Exit code and output of the verifier on both dumps."""
    command = "RESTRIP_FAULT=%d '%s' --max-k %s" % (fault, program, MAX_K)
    done = subprocess.run([os.path.abspath(verifier), "--headers", "--max-k", MAX_K, "--dump-command", command, "--linked-dump-command",
                           command + " --linked"], capture_output=True, text=True, timeout=60, check=False)
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
                   + [os.path.join(source, "runtime", name) for name in ("dump_tables.cpp", "dump_automaton.cpp", "dump_digests.cpp", "dump_linked.cpp")], check=True)
    code, output = verify(program, 0)
    assert code == 0 and "\nverified: " in output, output
    survivors, endless = [], 0
    for number, what, table in faults:
        code, output = verify(program, number)
        if code == 0:
            survivors.append(what)
            continue
        assert code == 1, (what, code, output)
        named = re.findall(r"table (\S+)[^,\n]*(?:, inner [0-9a-f]+, ports [0-9a-f]+|: )", output)
        if not any(name.startswith(table) for name in named):
            assert "the look-up does not end" in output, (what, table, output)
            endless += 1
    assert not survivors, "\n".join(["not noticed:"] + survivors)
print("%d faults noticed: %d named by table, %d because a look-up did not end" % (len(faults), len(faults) - endless, endless))
