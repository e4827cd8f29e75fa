"""Prints what other programs have written as Coq files. Anything unexpected ends the script with a message.

  print_coq.py tables DIRECTORY < dump           a table dump (docs/reference/verifiers.md) as Tables_FAMILY.v and Changes_FAMILY.v
  print_coq.py rows DIRECTORY < FAMILY.cert      a certificate (there as well) as Rows_FAMILY.v
  print_coq.py automaton DIRECTORY < dump        a dump of the automaton (there as well) as AutomatonNumbers.v

Tables: a table becomes the list of the nodes of a binary trie, equal subtrees once; Table.v says how they are read. The
stated changes become a trie as well, which Changes.v reads. Only the
flip may keep fewer ports; the mask of its answer is after | kept << 1. At the end of a file is the
function from positions, lists of numbers such as [8; 3], to the family's tables. Printed to the standard output: each
family, how many positions it has, and how many answers.

Rows: the recolouring of a copy is left out: Rows.v derives it from the symmetry. Reasons and sums are left out,
too: the proof searches. At the end of the file is the function from positions, lists of numbers such as [8; 3], to
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


BITS = {  # of the masks before and after, given k
    "split": (0, 3), "collapse": (3, 0), "open-split": (-1, 2), "open-collapse": (2, -1), "boundary-split": (-1, 0),
    "boundary-collapse": (0, -1)}
LEAF = 0xffff  # instead of a fork's first node; followed by the mask
PIECE = 2000  # digits of a text
PART = 500  # rows of a list


class Table:
    """What the head of a table says: the family, the position, and how many bits each mask has."""

    def __init__(self, head):
        words = head.split()
        self.family = words[1]
        self.position = [word for word in words[2:] if word.isdigit()]
        if head == "table flip":
            self.ports, self.before, self.after = 4, 1, 5
            return
        if self.family not in BITS or not self.position or not 1 <= int(self.position[0]) <= 12:
            fail("no head of a table: " + head)
        self.ports = int(self.position[0])
        before, after = BITS[self.family]
        self.before = self.ports + before
        self.after = self.ports + after

    def read_answers(self, lines):
        """The masks of the answers and their stated changes, by before << ports | ports; -1 for no answer."""
        known = [{"-": (-1, -1)} for _ in range(1 << self.ports)]  # by ports: what the rest of a line says
        answers, told = [], []
        for before in range(1 << self.before):
            for ports, of_ports in enumerate(known):
                line = next(lines, "")
                start = "%x %x " % (before, ports)
                if not line.startswith(start):
                    fail("%s: line out of order: %s" % (self.family, line))
                rest = line[len(start):]
                if rest not in of_ports:
                    of_ports[rest] = self.numbers(rest, ports)
                answer, tells = of_ports[rest]
                answers.append(answer)
                told.append(tells)
        return answers, told

    def numbers(self, rest, ports):
        recoloring, kept, strips, isolated = matched("(%s) (%s) (-?[0-9]+) (-?[0-9]+)" % (HEXADECIMAL, HEXADECIMAL), rest).groups()
        answer, strips, isolated = int(recoloring, 16), int(strips), int(isolated)
        if self.family == "flip":
            answer |= int(kept, 16) << 1
        elif int(kept, 16) != ports:
            fail("%s: a port changes: %s" % (self.family, rest))
        if answer >> self.after or not -128 <= strips <= 127 or not -128 <= isolated <= 127:
            fail("%s: too wide: %s" % (self.family, rest))
        return answer, 256 * (strips + 128) + isolated + 128


def trie_of(leaves):
    """The nodes, eight digits each: a fork of two nodes by number, or LEAF and the mask; node 0 has no leaf. The lowest
    bit of an index decides first."""
    known = {}  # children of each node, (-1, mask) for a leaf
    level = [known.setdefault((-1, leaf), len(known) + 1) if leaf >= 0 else 0 for leaf in leaves]
    while len(level) > 1:
        half = len(level) // 2
        level = [known.setdefault(pair, len(known) + 1) if pair != (0, 0) else 0
                 for pair in zip(level[:half], level[half:])]
    children, numbers, digits = [None, *known], {0: 0}, []

    def visit(node):
        if node not in numbers:
            first, second = children[node]
            digits.append((LEAF, second) if first < 0 else (visit(first), visit(second)))
            numbers[node] = len(digits)
        return numbers[node]

    visit(level[0])
    if len(digits) >= LEAF:
        fail("too many nodes for four digits")
    return "".join("%04x%04x" % pair for pair in digits)


class TableFile:
    """The file of one family. A table is a text of hexadecimal digits, cut into pieces, and what is made of it."""

    def __init__(self):
        self.text = ("(* Printed by print_coq.py from a table dump. *)\nRequire Import List Number.\nImport ListNotations.\n"
                     "Require Import Table.\nLocal Open Scope hex_uint_scope.\n")
        self.cases = ""
        self.positions = self.answers = 0

    def add(self, table, digits, reader):
        name = "_".join(table.position)
        pieces = [digits[at:at + PIECE] for at in range(0, len(digits), PIECE)]
        for number, piece in enumerate(pieces):
            self.text += "Definition text_%s_%d : Number.uint := 0x1%s.\n" % (name, number, piece)
        texts = "; ".join("text_%s_%d" % (name, number) for number in range(len(pieces)))
        self.text += "Definition table_%s : trie := %s [%s].\n" % (name, reader, texts)
        self.cases += "  | [%s]%%nat => table_%s\n" % ("; ".join(table.position), name)
        self.positions += 1
        self.answers += 1 << table.ports + table.before

    def write(self, directory, name):
        write(directory, name, "%sDefinition table (position : list nat) : trie :=\n  match position with\n%s  | _ => Nothing\n  end.\n"
              % (self.text, self.cases))


def print_tables(lines, directory):
    if next(lines, "") != "restrip-table-dump 4":
        fail("not a table dump")
    files, told_files = {}, {}
    line = next(lines, "")
    while line.startswith("table "):
        table = Table(line)
        answers, told = table.read_answers(lines)
        files.setdefault(table.family, TableFile()).add(table, trie_of(answers), "table_of %d%%nat" % table.after)
        told_files.setdefault(table.family, TableFile()).add(table, trie_of(told), "table_of 16%nat")
        line = next(lines, "")
    count = sum(file.answers for file in files.values())
    if line != "end %d" % count or next(lines, None) is not None:
        fail("the dump does not end with `end %d`" % count)
    for kind, all_of_kind in (("Tables", files), ("Changes", told_files)):
        for family, file in all_of_kind.items():
            file.write(directory, "%s_%s.v" % (kind, family.replace("-", "_")))
    for family, file in files.items():
        print(family.replace("-", "_"), file.positions, file.answers)


def joined_to_preceding(pairs, ports, count):
    """The theory has a bit for each port that is joined to the solid port before it around the closed fan; a certificate
    has pairs of ports, bit j (j - 1) / 2 + i for i < j."""
    joined = 0
    for port in range(count):
        if not ports >> port & 1:
            continue
        for step in range(1, count):
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


def row_of(line, count):
    """`rule P J R K because …` or `copy P J R K by port…`, as a row of Rows.v."""
    mask = "(" + HEXADECIMAL + ")"
    kind, ports, joined, recoloring, kept, behind = matched(
        "(rule|copy) %s %s %s %s (because .*|by [0-9 ]*)" % (mask, mask, mask, mask), line).groups()
    to = [int(port) for port in behind.split()[1:]] if kind == "copy" and behind.startswith("by ") else []
    if ports != kept or (len(to) != count if kind == "copy" else not behind.startswith("because ")):
        fail("bad row: " + line)
    key = "0x%s 0x%x" % (ports, joined_to_preceding(int(joined, 16), int(ports, 16), count))
    return "Copy %s %s" % (key, symmetry_of(to)) if kind == "copy" else "Rule %s 0x%s" % (key, recoloring)


def text_of_section(name, rows):
    text = ""
    for i, row in enumerate(rows):
        if i % PART == 0:
            text += "Definition rows_%s_part_%d : list row := [\n" % (name, i // PART)
        text += row + ("].\n" if i % PART + 1 == PART or i + 1 == len(rows) else ";\n" if i % 6 == 5 else "; ")
    parts = "".join("rows_%s_part_%d ++ " % (name, part) for part in range((len(rows) + PART - 1) // PART))
    return text + "Definition rows_%s : list row := %s[].\n" % (name, parts)


def print_rows(lines, directory):
    if lines[0] != "restrip-certificate 3":
        fail("not a certificate")
    family = matched("operation ([a-z-]+)", lines[1]).group(1)
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
            rows.append(row_of(line, int(position[0])))
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


PRINTERS = {"tables": print_tables, "rows": print_rows, "automaton": print_automaton}
if len(sys.argv) != 3 or sys.argv[1] not in PRINTERS:
    fail("usage: print_coq.py (tables|rows|automaton) DIRECTORY < input")
if sys.argv[1] == "tables":  # millions of lines
    print_tables((line.rstrip("\n") for line in sys.stdin), sys.argv[2])
else:
    all_lines = sys.stdin.read().split("\n")
    if len(all_lines) < 4 or all_lines.pop() != "":
        fail("the input is cut off")
    PRINTERS[sys.argv[1]](all_lines, sys.argv[2])
