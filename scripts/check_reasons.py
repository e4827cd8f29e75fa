#!/usr/bin/env python3
"""Checks every row of certificates from their text and docs/notation.md, docs/certificate.md alone: that it is sound,
and by its reason that nothing is preferred to it. Copies are checked by their symmetry. Nothing is searched, but for the
lists of linked rules, which are held against all recolourings.

  scripts/check_reasons.py tables/certificates/*.cert

Prints a line for each file. Exit code: 0 all is well, 1 a row is wrong (its line is named), 2 a file cannot be read.
Which rows there must be is not checked here.
"""
import sys


class Wrong(Exception):
    pass


class Patch:
    """Nodes, inner edges and the owner of each port after an operation."""

    def __init__(self, order, ring, chord, owners):
        self.nodes, self.owners = order, owners
        self.inner = list(zip(order, order[1:])) + [(order[-1], order[0])] * ring + [("A", "D")] * chord

    def solid(self, edges):
        """The solid edges of a mask, inner edges first, then ports; a port ends outside, at its number."""
        ends = self.inner + [(owner, ("out", p)) for p, owner in enumerate(self.owners)]
        return [ends[bit] for bit in range(len(ends)) if edges >> bit & 1]

    def strips(self, edges):
        """The port numbers of each strip, or None when a degree exceeds two or a strip closes."""
        degree, strip = {}, {}
        for u, v in self.solid(edges):
            for node in (u, v):
                degree[node] = degree.get(node, 0) + 1
            one, other = strip.get(u, {u}), strip.get(v, {v})
            if one is other or degree[u] > 2 or degree[v] > 2:
                return None
            one |= other
            strip.update((node, one) for node in one)
        return {frozenset(n[1] for n in s if n[0] == "out") for s in strip.values()}

    def isolated(self, edges):
        met = {node for edge in self.solid(edges) for node in edge}
        return sum(node not in met for node in self.nodes)


def patch_of(family, position):
    """The patch after an operation, from the words behind "section"."""
    if family == "flip":
        return Patch(["L", "R"], False, False, ["R", "L", "L", "R"])
    k, places = int(position[1]), [int(word) for word in position[3:]]
    fan = ["t%d" % i for i in range(k)]
    if family in ("collapse", "fan-collapse"):
        return Patch(fan, family == "collapse", False, fan)
    a, d = {"split": [0] + places, "open-split": places, "boundary-split": places + [None]}[family]
    order = [n for i in range(k + 1) for n in (["A"] * (i == a) + ["D"] * (i == d) + fan[i:i + 1])]
    return Patch(order, family == "split", family != "boundary-split", fan)


class Row:
    """The question that a row answers, and its answer: what may be dashed, what may be joined, what is solid."""

    def __init__(self, family, patch, words):
        masks = [int(word, 16) for word in words[1:5 if family == "flip" else 4]]
        self.patch, self.ports = patch, masks[0]
        inner, all_inner = len(patch.inner), (1 << len(patch.inner)) - 1
        if family == "flip":
            before = Patch(["L", "R"], False, False, ["L", "L", "R", "R"])
            self.joined = {s for s in before.strips(masks[1] | masks[0] << 1) if len(s) == 2}
            self.fixed, self.edges, self.own = 0, all_inner | masks[0] << inner, masks[3] | masks[2] << inner
        else:
            solid = [p for p in range(len(patch.owners)) if masks[0] >> p & 1]
            self.joined = {frozenset((p, solid[i - 1])) for i, p in enumerate(solid) if masks[1] >> p & 1}
            self.fixed, self.edges, self.own = masks[0] << inner, all_inner, masks[2]

    def sound(self, edges):
        strips = self.patch.strips(edges | self.fixed)
        return strips is not None and all(len(s) < 2 or s in self.joined for s in strips)

    def loss(self, dashed):
        """Dashed edges; isolated triangles and ports given up; ports given up."""
        given_up = bin(dashed >> len(self.patch.inner)).count("1")
        return bin(dashed).count("1"), self.patch.isolated(self.edges & ~dashed | self.fixed) + given_up, given_up

    def own_loss(self):
        if self.own & ~self.edges or not self.sound(self.own):
            raise Wrong("unsound")
        return self.loss(self.edges & ~self.own)

    def prove(self, words, solid=0, dashed=0):
        """Uses up the words of a reason."""
        if words[0] == "if":
            edge = 1 << int(words[1])
            if edge & ~self.edges or edge & (solid | dashed) or words[2] != "then":
                raise Wrong("no such case")
            del words[:3]
            self.prove(words, solid | edge, dashed)
            if not words or words.pop(0) != "else":
                raise Wrong("the dashed case is missing")
            return self.prove(words, solid, dashed | edge)
        taken, surely_dashed, shown = solid | dashed, dashed, bin(dashed).count("1")
        while words and words[0] != "else":
            word = words.pop(0)
            if word == "-":
                continue
            edges = int(word, 16)
            if edges & ~self.edges or edges & taken or self.sound(edges | solid):
                raise Wrong("the set %x has a foreign or a used edge or may be solid" % edges)
            taken, shown = taken | edges, shown + 1
            surely_dashed |= edges if edges & (edges - 1) == 0 else 0
        if (shown,) + self.loss(surely_dashed)[1:] < self.own_loss():
            raise Wrong("a case shows too little")

    def image(self, kind, n):
        """Ports and joined pairs where the symmetry takes them, when it is one of the patch."""
        count = len(self.patch.owners)
        to = [((n - p) if kind == "mirror" else (n + p)) % count for p in range(count)]
        for new in ({"A": "A", "D": "D"}, {"A": "D", "D": "A"}):
            moved = dict(new, **{o: self.patch.owners[to[p]] for p, o in enumerate(self.patch.owners)})
            if {frozenset(map(moved.get, e)) for e in self.patch.inner} == set(map(frozenset, self.patch.inner)) and all(
                    moved[o] == self.patch.owners[to[p]] for p, o in enumerate(self.patch.owners)):
                ports = sum(1 << to[p] for p in range(count) if self.ports >> p & 1)
                return ports, frozenset(frozenset(map(to.__getitem__, pair)) for pair in self.joined)
        raise Wrong("no symmetry of the patch")


class Lists:
    """The lists of a section of linked rules: points 1 to 4 of docs/certificate.md."""

    def __init__(self, patch):
        self.patch, self.ports, self.taken = patch, -1, []

    def look(self, edges):
        """Solid edges, minus isolated triangles; pairs. None when degrees or cycles forbid it."""
        fixed = self.ports << len(self.patch.inner)
        strips = None if edges >> len(self.patch.inner) else self.patch.strips(edges | fixed)
        return None if strips is None else ((bin(edges).count("1"), -self.patch.isolated(edges | fixed)),
                                            {strip for strip in strips if len(strip) == 2})

    def add(self, ports, edges):
        if ports != self.ports:
            self.close()
            self.ports, self.taken = self.ports + 1, []
        own = self.look(edges)
        if ports != self.ports:
            raise Wrong("expected the list of the ports %x" % self.ports)
        if own is None:
            raise Wrong("the alternative is not legal")
        if self.taken and self.taken[-1][0] < own[0]:
            raise Wrong("the alternative is preferred to the one before it")
        if any(pairs <= own[1] for _, pairs in self.taken):
            raise Wrong("the alternative is covered by one before it")
        self.taken.append(own)

    def close(self, last=None):
        # What is legal stays so when an edge is made dashed: all that is legal is reached by one edge more at a time.
        waiting = [(0, 0)] if self.ports >= 0 else []
        while waiting:
            edges, first = waiting.pop()
            needed = self.look(edges)
            if needed is None:
                continue
            if not any(merit >= needed[0] and pairs <= needed[1] for merit, pairs in self.taken):
                raise Wrong("the list above, of the ports %x, has nothing as good as %x" % (self.ports, edges))
            waiting += [(edges | 1 << bit, bit + 1) for bit in range(first, len(self.patch.inner))]
        if last is not None and self.ports != last:
            raise Wrong("the lists above end with the ports %x" % self.ports)


def check(path):
    with open(path, "rb") as file:
        lines = file.read().split(b"\n")
    family, lists, rules, copies, alternatives = "", None, 0, 0, 0
    for number, line in enumerate(lines, 1):
        words = line.decode("ascii", "replace").split(" ")
        try:
            if number == 1 and words != ["restrip-certificate", "2"]:
                raise Wrong("not a certificate of version 2")
            if words[0] == "family":
                family = words[1]
            elif words[0] == "section":
                if lists:
                    lists.close((1 << len(patch.owners)) - 1)
                patch, proved = patch_of(family.replace("linked-", ""), words[1:]), {}
                lists = Lists(patch) if family.startswith("linked-") else None
            elif words[0] in ("rule", "copy") and not lists:
                row = Row(family, patch, words)
                rest = words[5 if family == "flip" else 4:]
                if words[0] == "rule" and rest.pop(0) == "because":
                    row.prove(rest)
                    proved[row.ports, frozenset(row.joined)] = row.own_loss()
                    rules += 1
                elif words[0] == "copy" and rest.pop(0) == "by":
                    if proved.get(row.image(rest.pop(0), int(rest.pop(0)))) != row.own_loss():
                        raise Wrong("no rule that it is a copy of")
                    copies += 1
                if rest:
                    raise Wrong("more words than a row has")
            elif words[0] == "alternative":
                lists.add(*(int(word, 16) for word in words[1:]))
                alternatives += 1
            elif words[0] == "end":
                if lists:
                    lists.close((1 << len(patch.owners)) - 1)
                above = b"".join(text + b"\n" for text in lines[:number - 1])
                sums = [rules + copies + alternatives, sum(above), sum(place * byte for place, byte in enumerate(above, 1))]
                if [int(word) for word in words[1:]] != sums or lines[number:] != [b""]:
                    raise Wrong("expected end %d %d %d and the end of the file" % tuple(sums))
                if alternatives:
                    return "%s: %d alternatives, the lists are complete" % (path, alternatives)
                return "%s: %d rules are sound and have their reasons, %d copies follow" % (path, rules, copies)
            elif words[0] != "claim" and number > 1:
                raise Wrong("unknown line")
        except (Wrong, ValueError, IndexError, KeyError, AttributeError, TypeError, UnboundLocalError) as error:
            raise Wrong("%s:%d: %s" % (path, number, error)) from None
    raise Wrong("%s:%d: no last line" % (path, len(lines)))


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        sys.exit(0 if len(sys.argv) > 1 else 2)
    try:
        for name in sys.argv[1:]:
            print(check(name))
    except Wrong as wrong:
        sys.exit("check_reasons.py: " + str(wrong))
    except OSError as error:
        print("check_reasons.py:", error, file=sys.stderr)
        sys.exit(2)
