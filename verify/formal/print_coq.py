"""Prints what other programs have written as Coq files. Anything unexpected ends the script with a message.

  print_coq.py rows DIRECTORY < FAMILY.cert      a certificate (docs/certificate.md) as Rows_FAMILY.v
  print_coq.py automaton DIRECTORY < dump        a dump of the automaton (there as well) as AutomatonNumbers.v

Rows: the recolouring of a copy is left out: Rows.v works it out again from the symmetry. Reasons and sums are left out,
too: the proof searches. At the end of the file stands the function from positions, lists of numbers such as [8; 3], to
the rows of their sections.

Automaton: the numbers of the arrays as they are; the answers as lists of families, positions and digests. Header.v and
Automaton.v say what is digested.
"""
import os
import re
import sys

HEXADECIMAL = r"[0-9a-f]+"


def fail(what):
    sys.exit("print_coq: " + what)


def matched(pattern, line):
    found = re.fullmatch(pattern, line)
    return found or fail("bad line: " + line)


def write(directory, name, text):
    with open(os.path.join(directory, name), "w", encoding="ascii") as file:
        file.write(text)


def joined_to_preceding(pairs, ports, count, closed):
    """The theory has a bit for each port that is joined to the solid port before it; a certificate has pairs of ports,
    bit j (j - 1) / 2 + i for i < j."""
    joined = 0
    for port in range(count):
        if not ports >> port & 1:
            continue
        for step in range(1, count if closed else port + 1):
            other = (port - step) % count
            if ports >> other & 1:
                low, high = sorted((port, other))
                joined |= (pairs >> high * (high - 1) // 2 + low & 1) << port
                break
    return joined


def symmetry_of(to):
    """A permutation of the ports as the turn or mirror that it is."""
    k = len(to)
    for word, image in (("Turn", lambda i: (i + to[0]) % k), ("Mirror", lambda i: (to[0] - i) % k)):
        if all(to[i] == image(i) for i in range(k)):
            return "(%s %d)" % (word, to[0])
    return fail("neither a turn nor a mirror")


def row_of(line, count, closed):
    """`rule P J R K because …` or `copy P J R K by port…`, as a row of Rows.v."""
    mask = "(" + HEXADECIMAL + ")"
    kind, ports, joined, recoloring, kept, behind = matched(
        "(rule|copy) %s %s %s %s (because .*|by [0-9 ]*)" % (mask, mask, mask, mask), line).groups()
    to = [int(port) for port in behind.split()[1:]] if kind == "copy" and behind.startswith("by ") else []
    if ports != kept or (len(to) != count if kind == "copy" else not behind.startswith("because ")):
        fail("bad row: " + line)
    key = "0x%s 0x%x" % (ports, joined_to_preceding(int(joined, 16), int(ports, 16), count, closed))
    return "Copy %s %s" % (key, symmetry_of(to)) if kind == "copy" else "Rule %s 0x%s" % (key, recoloring)


def text_of_section(name, rows, chunk=500):
    text = ""
    for i, row in enumerate(rows):
        if i % chunk == 0:
            text += "Definition rows_%s_part_%d : list row := [\n" % (name, i // chunk)
        text += row + ("].\n" if i % chunk + 1 == chunk or i + 1 == len(rows) else ";\n" if i % 6 == 5 else "; ")
    parts = "".join("rows_%s_part_%d ++ " % (name, part) for part in range((len(rows) + chunk - 1) // chunk))
    return text + "Definition rows_%s : list row := %s[].\n" % (name, parts)


def print_rows(lines, directory):
    if lines[0] != "restrip-certificate 3":
        fail("not a certificate")
    family = matched("operation ([a-z-]+)", lines[1]).group(1)
    closed = family in ("split", "collapse")
    sections = []  # numbers of the position, rows
    for line in lines[2:-1]:
        if line.startswith("section "):
            sections.append((re.findall(r"(?<= )[0-9]+\b", line), []))
            if not sections[-1][0]:
                fail("a section without a number")
        elif not line.startswith("claim "):
            if not sections:
                fail("a row before the first section: " + line)
            position, rows = sections[-1]
            rows.append(row_of(line, int(position[0]), closed))
    matched("end %d [0-9]+ [0-9]+" % sum(len(rows) for _, rows in sections), lines[-1])
    text = "(* Printed by print_coq.py from a certificate. *)\nRequire Import NArith List.\nImport ListNotations.\nRequire Import Rows.\n"
    text += "".join(text_of_section("_".join(position), rows) for position, rows in sections)
    text += "Definition rows (position : list nat) : list row :=\n  match position with\n"
    text += "".join("  | [%s] => rows_%s\n" % ("; ".join(position), "_".join(position)) for position, _ in sections)
    write(directory, "Rows_%s.v" % family.replace("-", "_"), text + "  | _ => []\n  end.\n")


FAMILIES = {"split": "Splits", "collapse": "Collapses", "open-split": "OpenSplits", "boundary-split": "BoundarySplits",
            "fan-collapse": "FanCollapses"}


def print_automaton(lines, directory):
    if lines[0] != "restrip-automaton-dump 2":
        fail("not a dump of the automaton")
    text = "(* Printed by print_coq.py from the dump of the shipped header. *)\nRequire Import NArith List.\nImport ListNotations.\nRequire Import Header.\n"
    digests, told = [], []
    count, at = 0, 1
    while not lines[at].startswith("end "):
        if lines[at].startswith("array "):
            name, size = matched("array ([a-z_]+) ([1-9][0-9]*)", lines[at]).groups()
            numbers = ["0x" + matched(HEXADECIMAL, line).group() for line in lines[at + 1:at + 1 + int(size)]]
            rows = ["; ".join(numbers[first:first + 16]) for first in range(0, len(numbers), 16)]
            text += "Definition %s_numbers : list N := [%s]%%N.\n" % (name, ";\n".join(rows))
            at += int(size)
            count += int(size)
        else:
            family, position, digest, told_digest = matched(
                "answers (%s)((?: [0-9]+)+) keys [0-9]+ digest (%s) told (%s)" % ("|".join(FAMILIES), HEXADECIMAL, HEXADECIMAL), lines[at]).groups()
            place = "(%s, [%s], 0x" % (FAMILIES[family], "; ".join(position.split()))
            digests.append(place + digest + "%N)")
            told.append(place + told_digest + "%N)")
            count += 1
        at += 1
        if at >= len(lines):
            fail("the dump is cut off")
    if lines[at:] != ["end %d" % count]:
        fail("the dump does not end with `end %d`" % count)
    for name, all_of_them in (("digests", digests), ("told_digests", told)):
        text += "Definition %s : list (walked_family * list nat * N) := [\n%s].\n" % (name, ";\n".join(all_of_them))
    write(directory, "AutomatonNumbers.v", text)


if len(sys.argv) != 3 or sys.argv[1] not in ("rows", "automaton"):
    fail("usage: print_coq.py (rows|automaton) DIRECTORY < input")
with sys.stdin as given:
    all_lines = given.read().split("\n")
if len(all_lines) < 4 or all_lines.pop() != "":
    fail("what is read is cut off")
(print_rows if sys.argv[1] == "rows" else print_automaton)(all_lines, sys.argv[2])
