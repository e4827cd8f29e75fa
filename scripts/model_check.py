#!/usr/bin/env python3
"""Proves the look-ups in C by a bounded model checker, CBMC 6 or later: for each position one formula says that for some
colours, ports and recolouring the answer is missing, unsound, tells a wrong number of strips or is not the best, or that
something is read out of bounds or overflows. verify/bounded/look_up.c judges, and key_look_up.c the automaton, which is asked
by keys; the patches are written here, in their words of docs/notation.md, as in check_reasons.py. Fans above --max-k make such
formulas too large. So up to --walk-k the automaton's look-up is held against the one of verify/formal/Statements.v, of which
Coq proves that it answers soundly and best (verify/bounded/walk.c); --numbers tells whether it reads the numbers of that proof.

  scripts/model_check.py --header DIR/restrip_tables.h                   every position up to k = 8
  scripts/model_check.py --header DIR/restrip_tables.h --max-k 5         a part of them
  scripts/model_check.py --operation tables/operations/bisect.json --header DIR/restrip_bisect.h
  restrip-dump-tables --automaton > DIR/automaton.dump
  scripts/model_check.py --automaton --header DIR/restrip_automaton.h --numbers DIR/automaton.dump --max-k 4

Each formula has assertions that must fail, so that a formula that says nothing is noticed. Exit code: 0 all is proved, 1
something is not (the position and the assertion are named), 2 a file cannot be read, or there is no CBMC.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from check_reasons import fan_patch, graphs_of  # noqa: E402

JUDGES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "verify", "bounded")
ARRAY = r"^static const uint\d+_t (restrip_\w+)\[(\d+)\] = \{([^}]*)\};$"
MOST = {"strips": 2, "forest": 3, "matching": 1}


def row(k, ring, *gaps):
    """Triangles, inner edges and owners of a fan; with two gaps A and D are joined."""
    fan = ["t%d" % i for i in range(k)]
    order = []
    for i in range(k + 1):
        order += [name for name, gap in zip("AD", gaps) if gap == i] + fan[i:i + 1]
    patch = fan_patch(order, ring, len(gaps) == 2, fan)
    at = order.index
    return len(order), [(at(one), at(other)) for one, other in patch.inner], [at(owner) for owner in fan]


def families(max_k, min_k=1):
    """Every position of every operation in the tables: its name, its question, before, after."""
    question = "const restrip_rule r = restrip_%s(%s, inner, ports); return (answer){r.colors, r.valid ? ports : 0, r.strips, r.valid};"
    for k in range(min_k, max_k + 1):
        closed = [("split", (a,), True, (0, a)) for a in range(1, k)] if k > 2 else []
        opened = [("open_split", (i, j), False, (i, j)) for j in range(k + 1) for i in range(j)]
        boundary = [("boundary_split", (i,), False, (i,)) for i in range(k + 1)]
        for name, numbers, ring, gaps in closed + opened + boundary:
            fan, refined = row(k, ring), row(k, ring, *gaps)
            for operation, one, other in (name, fan, refined), (name.replace("split", "collapse"), refined, fan):
                called = ", ".join(str(n) for n in (k,) + numbers)
                yield "%s(%s)" % (operation, called), question % (operation, called), one, other, {}
    flip = "const restrip_flip_rule r = restrip_flip(inner, ports); return (answer){r.inner, r.ports, r.strips, r.valid};"
    yield "flip()", flip, (2, [(0, 1)], [0, 0, 1, 1]), (2, [(0, 1)], [1, 0, 0, 1]), {"MAY_GO": 15}


def keyed(header, max_k, min_k=1):
    """Every position of the automaton: its name, its question, the side after, twice."""
    with open(header, encoding="utf-8") as file:
        cost = re.search(r"cost, which is (\d+) for a strip, (\d+) for a swap and\n// (\d+) for", file.read())
    if not cost:
        raise ValueError("%s: it says no cost; restrip-generate automaton --language c writes what is read here" % header)
    if cost[2] != "0" and max_k > 0:
        raise ValueError("%s: swaps have a price, which is not judged; --max-k 0 asks any arguments alone" % header)
    question = ("const restrip_key key = {ports, joined, 0, 0}; const restrip_recoloring r = restrip_best_%s(%s, key); "
                "return (answer){(u32)r.colors, r.valid && r.colors >> 32 == 0};")
    for k in range(min_k, max_k + 1):
        closed = [("split", (a,), True, (0, a)) for a in range(1, k)] + [("collapse", (), True, ())] if k > 2 else []
        opened = [("open_split", (i, j), False, (i, j)) for j in range(k + 1) for i in range(j)]
        boundary = [("boundary_split", (i,), False, (i,)) for i in range(k + 1)] + [("fan_collapse", (), False, ())]
        for name, numbers, ring, gaps in closed + opened + boundary:
            called, after = ", ".join(str(n) for n in (k,) + numbers), row(k, ring, *gaps)
            yield "%s(%s)" % (name, called), question % (name, called), after, after, {
                "ARGUMENTS": "u32 ports, u32 joined", "CLOSED": int(ring), "RESTART": int(cost[1]), "ISOLATED": int(cost[3])}


def own(path):
    """The one position of an operation file."""
    with open(path, encoding="utf-8") as file:
        said = json.load(file)
    constraint = said.get("constraint", "strips")
    if "cost" in said or constraint not in MOST:
        raise ValueError("%s: an order of preference of its own" % path)
    before, after = graphs_of(said)
    gives, matching = said.get("give_up", "none"), constraint == "matching"
    ports = {"none": [], "all": range(len(before[2]))}[gives] if isinstance(gives, str) else gives
    identifier = said["name"].replace("-", "_")
    question = "const restrip_operation_rule r = restrip_rule_of_%s(inner, ports); return (answer){r.colors, r.ports, r.strips, r.valid};"
    yield identifier + "()", question % identifier, before, after, {
        "MOST": MOST[constraint], "MAY_GO": sum(1 << p for p in ports), "COUNTS": int(not matching), "ANY_COLORS": int(matching)}


def position_text(header, question, before, after, words):
    lines = ['#include "%s"' % os.path.abspath(header)]
    for when, (triangles, edges, owners) in ("before", before), ("after", after):
        lines += ["enum { TRIANGLES_%s = %d, EDGES_%s = %d };" % (when.upper(), triangles, when.upper(), len(edges))]
        for name, numbers in ("one", [e[0] for e in edges]), ("other", [e[1] for e in edges]), ("owner", owners):
            lines.append("static const unsigned char %s_%s[] = {%s};" % (when, name, ", ".join(str(n) for n in numbers or [0])))
    words = dict(words)
    arguments = words.pop("ARGUMENTS", "u32 inner, u32 ports")
    counted = {"PORTS": len(before[2]), "MOST": 2, "MAY_GO": 0, "COUNTS": 1, "ANY_COLORS": 0, **words}
    lines += [] if after[1] or counted["MAY_GO"] else ["#define ONE_RECOLORING"]
    lines += ["enum { %s = %d };" % pair for pair in counted.items()]
    return "\n".join(lines + ["static answer ask(%s) { %s }" % (arguments, question)]) + "\n"


def with_reads(text, number):
    """An implementation, and how long its arrays are. What is read of an array is any number up to the largest that the array
    holds: whatever is proved of that holds with the arrays themselves. `number` is an expression in C for read i of NAME."""
    lengths = {}
    for name, length, numbers in re.findall(ARRAY, text, re.M):
        text = text.replace("] = {%s};" % numbers, "];")
        while read := re.search(r"(?<!_t )\b%s\[" % name, text):
            end, depth = read.end(), 1
            while depth:
                depth += {"[": 1, "]": -1}.get(text[end], 0)
                end += 1
            text = "%s%s_at(%s)%s" % (text[:read.start()], name, text[read.end():end - 1], text[end:])
        lengths[name], largest = int(length), max(integers(numbers))
        text = re.sub(r"^static const uint\d+_t %s\[.*$" % name, "uint32_t __CPROVER_uninterpreted_%s(uint32_t);\nstatic uint32_t %s_at(uint32_t i) {\n"
                      "  const uint32_t n = %s;\n  __CPROVER_assert(i < %s, \"%s is read in bounds\");\n  __CPROVER_assume(n <= %d);\n  return n;\n}"
                      % (name, name, number.replace("NAME", name).replace("LARGEST", str(largest)), length, name, largest), text, flags=re.M)
    return "#include <stdint.h>\nuint32_t nondet_u32(void);\nuint64_t nondet_u64(void);\n" + text, lengths


def integers(text):
    return [int(number) for number in text.replace(",", " ").split()]


def without_data(text):
    """An implementation in which each read gives any number, and a read of an arc any entry, as each that is stored is one. Long
    chains of reads make formulas that are too large."""
    text, lengths = with_reads(text, "nondet_u32()")
    stored, read = "arc->entries[arc->size++] = entry;", "arc->entries[m - 1]"
    if text.count("entries[") != 3 or stored not in text or read not in text:
        raise ValueError("the arcs of this automaton are not stored as they were")
    text = text.replace(stored, '__CPROVER_assert(arc->size < %s && entry < %d, "an entry is stored in bounds");\n  ++arc->size;' % (
        "sizeof arc->entries / sizeof *arc->entries", lengths["restrip_next"]))
    return text.replace("static void restrip_read(", "static uint32_t restrip_entry_at(uint32_t i) {\n  const uint32_t n = nondet_u32();\n"
                        "  __CPROVER_assert(i <= RESTRIP_AUTOMATON_MAX_K, \"an entry is read in bounds\");\n  __CPROVER_assume(n < %d);\n  return n;\n}\n\n"
                        "static void restrip_read(" % lengths["restrip_next"], 1).replace(read, "restrip_entry_at(m - 1)")


def walks(header, max_k, number="__CPROVER_uninterpreted_NAME(i)"):
    """The questions for walk.c: an operation, its text. Equal reads give equal numbers."""
    with open(header, encoding="utf-8") as file:
        text, _ = with_reads(file.read(), number)
    for name, asked, possible in (
            ("split", "k, i", "k > 2 && 0 < i && i < k"), ("collapse", "k", "k > 2"), ("open_split", "k, i, j", "i < j && j <= k"),
            ("boundary_split", "k, i", "k > 0 && i <= k"), ("fan_collapse", "k", "k > 0")):
        yield name, "\n".join([
            text, "enum { MOST_K = %d };" % max_k, "#define possible(k, i, j) (%s)" % possible,
            "#define ask(k, i, j, key) restrip_best_%s(%s, key)" % (name, asked), "#define answer(k, i, j, s, J) %s_answer(%s, s, J)" % (name, asked)]) + "\n"


def other_numbers(header, dump):
    """The arrays of an automaton in C that do not hold the numbers of a dump (docs/certificate.md, "Dump of the automaton")."""
    with open(header, encoding="utf-8") as file:
        text = file.read()
    held = {name[len("restrip_"):]: integers(numbers) for name, _, numbers in re.findall(ARRAY, text, re.M)}
    held["seconds"] = integers(re.search(r"^#define RESTRIP_SECONDS (\d+)U$", text, re.M)[1])
    with open(dump, encoding="utf-8") as file:
        lines = file.read().split("\n")
    dumped = {}
    for at, line in enumerate(lines):
        if head := re.fullmatch(r"array ([a-z]+) (\d+)", line):
            dumped[head[1]] = [int(number, 16) for number in lines[at + 1:at + 1 + int(head[2])]]
    if "before" not in dumped or "next" not in dumped:
        raise ValueError("%s: no dump of an automaton" % dump)
    dumped["before"] = [half for number in dumped["before"] for half in (number & 0xffffffff, number >> 32)]
    dumped["next"] = [0 if number == 0xff else number for number in dumped["next"]]  # of a letter that is not allowed
    return sorted(name for name in held.keys() | dumped.keys() if held.get(name) != dumped.get(name))


def any_argument(header, automaton):
    """Programs that call the functions of a header with any arguments: all of them, or of the automaton one at a time."""
    with open(header, encoding="utf-8") as file:
        text = file.read()
    declared = re.findall(r"^(restrip_\w+) (restrip_\w+)\((.*)\);$", text, re.M)
    head = [without_data(text) if automaton else '#include "%s"\nuint32_t nondet_u32(void);' % os.path.abspath(header), "int main(void) {"]
    calls = []
    key = "(restrip_key){nondet_u64(), nondet_u64(), nondet_u64(), nondet_u64()}"
    for kind, name, arguments in declared:
        asked = ", ".join(key if one.strip() == "restrip_key key" else "nondet_u32()" for one in arguments.split(","))
        calls.append('  { const %s r = %s(%s); __CPROVER_assert(!r.valid, "control: %s has no answers"); }' % (kind, name, asked, name))
    for part in [[call] for call in calls] if automaton else [calls]:
        yield "\n".join(head + part + ["}"]) + "\n"


def faults(cbmc, header, formula):
    """Checks one formula: how many assertions it has, and what does not hold of them."""
    with open(header, encoding="utf-8") as file:
        implementation = re.search(r"^#ifdef (\w+_IMPLEMENTATION)$", file.read(), re.M).group(1)
    with tempfile.TemporaryDirectory() as folder:
        written = os.path.join(folder, "position.h" if formula.judge else "any_argument.c")
        with open(written, "w", encoding="utf-8") as file:
            file.write(formula.text)
        run = subprocess.run([cbmc, formula.judge or written, "-D" + implementation, "-I", folder, "--unwind", str(formula.unwind)], capture_output=True, text=True)
    found = re.findall(r"^\[\S+\] (?:line \d+ )?(.*): ([A-Z]+)$", run.stdout, re.M)
    if not any(name.startswith("control") for name, _ in found):
        raise ValueError("%s: it said nothing of the assertions: %s" % (cbmc, (run.stdout + run.stderr).strip()[-1000:]))
    expected = lambda name: "FAILURE" if name.startswith("control") else "SUCCESS"
    return len(found), sorted({name for name, verdict in found if verdict != expected(name)})


def group_of(name):
    """Of "split(5, 2)": "split k = 5"."""
    operation, numbers = name[:-1].split("(")
    return operation + (" k = " + numbers.split(",")[0] if numbers else "")


def model_checker():
    """The path of CBMC, or what is missing. 5.12 fails on arrays of the tables' size."""
    cbmc = shutil.which("cbmc")
    if not cbmc:
        raise ValueError("there is no cbmc; Debian 13 has a package of this name")
    version = subprocess.run([cbmc, "--version"], capture_output=True, text=True).stdout.strip()
    if int(version.split(".")[0] or 0) < 6:
        raise ValueError("cbmc %s is too old: 6 or later is needed" % version)
    return cbmc


# A formula: what a report says of it and of those beside it, its own name, its text, who judges it, and what no loop exceeds.
Formula = collections.namedtuple("Formula", "group name text judge unwind")


def formulas(options):
    """All that is to be proved, and how many positions are judged."""
    if options.operation:
        asked = list(own(options.operation))
    elif options.automaton:
        asked = list(keyed(options.header, options.max_k, options.min_k))
    else:
        asked = list(families(options.max_k, options.min_k))
    if options.min_k > options.max_k > 0:
        raise ValueError("there are no positions from k = %d to %d" % (options.min_k, options.max_k))
    work = [Formula("any arguments", "any arguments", text, None, 64 if options.automaton else 34)
            for text in any_argument(options.header, options.automaton)]
    if options.automaton and options.max_k > 0:
        for operation, text in walks(options.header, options.walk_k):
            name = "%s answers as Lookup does, k <= %d" % (operation, options.walk_k)
            work.append(Formula(name, name, text, os.path.join(JUDGES, "walk.c"), options.walk_k + 3))
    judge = os.path.join(JUDGES, "key_look_up.c" if options.automaton else "look_up.c")
    counted = collections.Counter(group_of(name) for name, *_ in asked)
    for name, *rest in asked:
        group = "%s, positions: %d" % (group_of(name), counted[group_of(name)])
        work.append(Formula(group, name, position_text(options.header, *rest), judge, 34))
    return work, len(asked)


def proved(cbmc, header, work, jobs):
    """Prints what is proved, and what is not; how many assertions there were, and how many formulas do not hold."""
    left, broken, assertions, wrong = collections.Counter(one.group for one in work), set(), 0, 0
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for number, (one, (count, failed)) in enumerate(zip(work, pool.map(lambda one: faults(cbmc, header, one), work)), 1):
            if sys.stderr.isatty():
                print("\r%d of %d formulas" % (number, len(work)), end="\r\n"[number == len(work)], file=sys.stderr, flush=True)
            if failed:
                print("%s: NOT PROVED: %s" % (one.name, "; ".join(failed)), flush=True)
                broken.add(one.group)
            assertions, wrong = assertions + count, wrong + bool(failed)
            left[one.group] -= 1
            if left[one.group] == 0 and one.group not in broken:
                print("proved: %s" % one.group, flush=True)
    return assertions, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--header", help="the look-up in C, as restrip-generate writes it; without it, only CBMC is looked for")
    parser.add_argument("--operation", help="the operation file that it is of; without, it is of the families")
    parser.add_argument("--automaton", action="store_true", help="the look-up is that of `restrip-generate automaton`")
    parser.add_argument("--max-k", type=int, help="the largest fan (8); 0: nothing but that any arguments are safe")
    parser.add_argument("--min-k", type=int, help="the smallest fan (1), to share the work among machines")
    parser.add_argument("--walk-k", type=int, help="the largest fan of which the automaton's answers are compared with Lookup's (12)")
    parser.add_argument("--numbers", metavar="FILE", help="what restrip-dump-tables --automaton prints, to be compared with the automaton's numbers")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="how many at a time")
    options = parser.parse_args()
    if options.operation and (options.automaton or options.max_k is not None or options.min_k is not None):
        parser.error("--operation: it has one position; --automaton, --max-k and --min-k are for families")
    if not options.automaton and (options.numbers or options.walk_k is not None):
        parser.error("--numbers and --walk-k are for --automaton")
    options.max_k, options.min_k, options.walk_k = (given if given is not None else usual for given, usual in (
        (options.max_k, 8), (options.min_k, 1), (options.walk_k, 12)))
    try:
        cbmc = model_checker()
        if not options.header:
            return 0
        work, positions = formulas(options)
        other = other_numbers(options.header, options.numbers) if options.numbers else []
        if options.numbers:
            print("NOT those of %s: %s" % (options.numbers, ", ".join(other)) if other else "proved: the numbers are those of %s" % options.numbers)
        assertions, wrong = proved(cbmc, options.header, work, options.jobs)
        wrong += bool(other)
    except (AttributeError, OSError, ValueError, KeyError, TypeError) as error:
        print("model_check.py: %s" % error, file=sys.stderr)
        return 2
    print("%s: %d positions, %d assertions; read: the %s in C, %s" % (
        "NOT proved (%d faults)" % wrong if wrong else "proved in all", positions, assertions, "automaton" if options.automaton else "look-up",
        os.path.basename(options.header)))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
