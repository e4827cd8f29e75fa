#!/usr/bin/env python3
"""Checks every row of certificates from their text and docs/reference/notation.md, docs/reference/certificate.md alone: that it is sound,
and by its reason that nothing is preferred to it. Copies are checked by their symmetry. Nothing is searched.

  scripts/check_reasons.py tables/certificates/*.cert
  scripts/check_reasons.py --operation tables/operations/bisect.json tables/certificates/operations/bisect.cert

The second line is for a custom operation, by docs/reference/operation-file.md: its file describes one operation, and has
reasons (strips, fewest strips first). It must have a row for every valid configuration; "configurations", "valid"
and "keys" are recounted.

Prints a line for each file, and what was read. Exit code: 0 all is well, 1 a row is wrong (its line is named), 2 a file cannot
be read or is not for this script.
Every section must be there, with each claim once and its rows in ascending order. Splits and the flip must have a row for
every valid configuration. Claims are recounted as far as this takes no walk over the configurations of
collapses: "configurations" in all families, "valid" of splits and the flip. Which rows a collapse must have, and the other claims, are not checked here.
"""
import json
import re
import sys
from functools import partial
from itertools import combinations

CLAIMS = ("configurations", "valid", "orbits", "valid-orbits", "keys", "costing", "worst-strips", "worst-isolated")


class Wrong(Exception):
    pass


class NotServed(Exception):
    pass


def report(path, rules, copies):
    """What is printed of a certificate that holds."""
    return "%s: %s, %s" % (path, "1 rule is sound and has its reason" if rules == 1 else "%d rules are sound and have their reasons" % rules,
                              "1 copy follows" if copies == 1 else "%d copies follow" % copies)


class Patch:
    """Nodes, inner edges and the owner of each port after an operation."""

    def __init__(self, nodes, inner, owners):
        self.nodes, self.inner, self.owners = nodes, inner, owners
        self.known, self.moves = {}, {}

    def paths(self, edges):
        """Of solid inner edges alone: the degree of each node, and its path; no paths when three edges meet or one closes."""
        inner = edges & (1 << len(self.inner)) - 1
        if inner not in self.known:
            degree, path = dict.fromkeys(self.nodes, 0), {node: node for node in self.nodes}
            for u, v in (ends for bit, ends in enumerate(self.inner) if inner >> bit & 1):
                degree[u] += 1
                degree[v] += 1
                if path and path[u] == path[v]:
                    path = None
                elif path:
                    path.update([(node, path[u]) for node in self.nodes if path[node] == path[v]])
            self.known[inner] = degree, path if max(degree.values()) <= 2 else None
        return self.known[inner]

    def ports(self, edges):
        """The numbers of the solid ports of a mask, inner edges first, then ports."""
        return [p for p in range(len(self.owners)) if edges >> len(self.inner) + p & 1]

    def strips(self, edges):
        """The port numbers of each strip that has any, or None when a degree is too large or a strip closes."""
        degree, path = self.paths(edges)
        if path is None:
            return None
        room, strip = {}, {}
        for p in self.ports(edges):
            owner = self.owners[p]
            room[owner] = room.get(owner, 2 - degree[owner]) - 1
            if room[owner] < 0:
                return None
            strip.setdefault(path[owner], []).append(p)
        return {frozenset(ports) for ports in strip.values()}

    def isolated(self, edges):
        degree, _ = self.paths(edges)
        met = {self.owners[p] for p in self.ports(edges)}
        return sum(degree[node] == 0 and node not in met for node in self.nodes)

    def allows(self, to):
        """Whether the ports can go there: the nodes can follow, each edge onto an edge."""
        edges = {frozenset(edge) for edge in self.inner}

        def extends(moved):
            if len(set(moved.values())) < len(moved) or any(
                    frozenset((moved[u], moved[v])) not in edges for u, v in self.inner if u in moved and v in moved):
                return False
            rest = [node for node in self.nodes if node not in moved]
            return not rest or any(extends({**moved, rest[0]: node}) for node in self.nodes if node not in moved.values())

        if to not in self.moves:
            moved = {owner: self.owners[to[p]] for p, owner in enumerate(self.owners)}
            follows = all(moved[owner] == self.owners[to[p]] for p, owner in enumerate(self.owners))
            self.moves[to] = sorted(to) == list(range(len(self.owners))) and follows and extends(moved)
        return self.moves[to]


def fan_patch(order, ring, chord, owners):
    """Nodes in the order of a path or ring, and perhaps the chord."""
    return Patch(order, list(zip(order, order[1:])) + [(order[-1], order[0])] * ring + [("A", "D")] * chord, owners)


def patch_of(family, position):
    """The patch after an operation, from the words after "section"."""
    if family == "flip":
        return fan_patch(["L", "R"], False, False, ["R", "L", "L", "R"])
    k, places = int(position[1]), [int(word) for word in position[3:]]
    fan = ["t%d" % i for i in range(k)]
    if family == "collapse":
        return fan_patch(fan, True, False, fan)
    [a] = places
    return fan_patch(["A"] + fan[:a] + ["D"] + fan[a:], True, True, fan)


def positions(family, max_k):
    """The words after "section" in all sections that a certificate must have, in order."""
    if family == "flip":
        return ["flip"]
    if family == "split":
        return ["k %d a %d" % (k, a) for k in range(3, max_k + 1) for a in range(1, k // 2 + 1)]
    if family == "collapse":
        return ["k %d" % k for k in range(3, max_k + 1)]
    raise Wrong("unknown family " + family)


def configurations(family, position):
    """The number of configurations before the operation, over all positions of the section."""
    if family == "flip":
        return 32
    k = int(position.split()[1])
    return k // 2 << 2 * k + 3 if family == "collapse" else 1 << 2 * k


def natural(word, base=10):
    """A number as certificates write it: Python also reads signs, underscores, spaces and the digits of other alphabets."""
    if not re.fullmatch("0|[1-9a-f][0-9a-f]*" if base == 16 else "0|[1-9][0-9]*", word):
        raise Wrong("%r is not a number" % word)
    return int(word, base)


def mask_of(groups):
    """The pairs of ports that are in one group: bit j (j - 1) / 2 + i is the pair i < j."""
    return sum(1 << max(pair) * (max(pair) - 1) // 2 + min(pair) for group in groups for pair in combinations(group, 2))


def pairs_of(mask, ports):
    pairs = {frozenset((i, j)) for j in range(ports) for i in range(j) if mask >> j * (j - 1) // 2 + i & 1}
    if mask_of(pairs) != mask:
        raise Wrong("a pair of missing ports")
    return pairs


def valid_keys(family, position, known={}):
    """How many valid configurations a split or the flip has, and their keys. All pairs that these join some recolouring joins."""
    k = None if family == "flip" else int(position.split()[1])
    if k not in known:
        fan = ["t%d" % i for i in range(k)] if k else []
        before = fan_patch(fan, True, False, fan) if k else fan_patch(["L", "R"], False, False, ["L", "L", "R", "R"])
        inner, count, keys = len(before.inner), 0, set()
        for edges in range(1 << inner + len(before.owners)):
            strips = before.strips(edges)
            if strips is None:
                continue
            count += 1
            keys.add((edges >> inner, mask_of(strips)))
        known[k] = count, keys
    return known[k]


def recounted(family, position):
    """Claims of a section of a shipped family; of splits and the flip the keys."""
    counted, keys = {"configurations": configurations(family, position)}, None
    if family != "collapse":
        counted["valid"], keys = valid_keys(family, position)
        counted["keys"] = len(keys)
    return counted, keys


class Section:
    """The claims and rows of a section seen so far. When it is closed, all must have been seen."""

    def __init__(self, position, recounted):
        """`recounted`: a function that has the claims that can be counted, and the keys if these are known."""
        self.position, self.recounted, self.claims, self.keys = position, recounted, {}, []

    def claim(self, word, number):
        if word not in CLAIMS or word in self.claims:
            raise Wrong("unknown claim, or made twice")
        if self.keys:
            raise Wrong("a claim after the rows")
        self.claims[word] = -natural(number[1:]) if number.startswith("-") else natural(number)
        if list(self.claims) != list(CLAIMS[:len(self.claims)]):
            raise Wrong("a claim out of order, or the one before it is missing")

    def row(self, key):
        if self.keys and self.keys[-1] >= key:
            raise Wrong("rows are not in ascending order, or one is duplicated")
        self.keys.append(key)

    def close(self):
        missing = set(CLAIMS) - set(self.claims)
        counted, keys = self.recounted()
        for key in sorted(keys.symmetric_difference(self.keys) if keys else []):
            raise Wrong("section %s above: the key %x %x %s" % (
                (self.position,) + key + ("has no row" if key in keys else "is of no valid configuration",)))
        if not self.keys:
            raise Wrong("section %s above has no row" % self.position)
        if missing:
            raise Wrong("section %s above: claim %s is missing" % (self.position, min(missing)))
        for word, number in counted.items():
            if self.claims[word] != number:
                raise Wrong("section %s above: claim %s %d, recounted %d" % (self.position, word, self.claims[word], number))


class Row:
    """The question that a row answers, and its answer: what may be dashed, what may be joined, what is solid."""

    def __init__(self, patch, may_go, words):
        """`may_go`: ports that may be given up."""
        self.patch, (self.ports, joined, colors, kept) = patch, (natural(word, 16) for word in words[1:5])
        if self.ports >> len(patch.owners):
            raise Wrong("a port that the patch does not have")
        inner, all_inner = len(patch.inner), (1 << len(patch.inner)) - 1
        self.joined = pairs_of(joined, len(patch.owners))
        self.key, may_go = (self.ports, joined), self.ports & may_go
        self.fixed, self.edges = (self.ports & ~may_go) << inner, all_inner | may_go << inner
        self.own = colors | (kept & may_go) << inner
        if kept & ~self.ports or self.ports & ~kept & ~may_go or colors & ~all_inner:
            raise Wrong("a port is taken, or a port that must stay is given up")

    def sound(self, edges):
        strips = self.patch.strips(edges | self.fixed)
        return strips is not None and all(frozenset(pair) in self.joined for s in strips for pair in combinations(s, 2))

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
            edge = 1 << min(natural(words[1]), 64)
            if edge & ~self.edges or edge & (solid | dashed) or words[2] != "then":
                raise Wrong("an impossible case")
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
            edges = natural(word, 16)
            if edges & ~self.edges or edges & taken or self.sound(edges | solid):
                raise Wrong("the set %x has a foreign or a used edge or may be solid" % edges)
            taken, shown = taken | edges, shown + 1
            surely_dashed |= edges if edges & (edges - 1) == 0 else 0
        if (shown,) + self.loss(surely_dashed)[1:] < self.own_loss():
            raise Wrong("a case shows too little")

    def image(self, to, may_go):
        """The key to which the symmetry maps this one, if it is a symmetry of the patch that preserves the ports that may be given up."""
        if not self.patch.allows(to) or any((may_go >> p ^ may_go >> to[p]) & 1 for p in range(len(to))):
            raise Wrong("not a symmetry of the patch")
        return sum(1 << to[p] for p in range(len(to)) if self.ports >> p & 1), mask_of({to[p] for p in pair} for pair in self.joined)


def graphs_of(said):
    """Triangles, inner edges and owners of the ports, before and after, of an operation file."""
    sides = []
    for triangles in (said["before"], said["after"]):
        met, inner = {}, []  # directed sides by their triangle; finally only the outline
        for number, (a, b, c) in enumerate(triangles):
            for start, end in ((a, b), (b, c), (c, a)):
                if (end, start) in met:
                    inner.append((met.pop((end, start)), number))
                else:
                    met[start, end] = number
        boundary = set()
        for start, goal in said.get("boundary", []):
            while start != goal:
                (start, end), = [side for side in met if side[0] == start]
                boundary.add((start, end))
                start = end
        sides.append((len(triangles), inner, met, boundary))
    _, _, rim, boundary = sides[0]
    ports, at = [], next(side for side in rim if side not in boundary)
    for _ in rim:
        ports += [at] if at not in boundary else []
        at, = [side for side in rim if side[0] == at[1]]
    return [(count, inner, [rim[side] for side in ports]) for count, inner, rim, _ in sides]


class Operation:
    """An operation file, and the rows that its certificate must have."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            said = json.load(file)
        if "operations" in said or said.get("numbers"):
            raise NotServed("%s: describes a family or a list; only single operations are checked here" % path)
        self.name = said["name"]
        usual = [["strips"], ["isolated", "given_up"], ["given_up"]]
        counted = [[term.get("count") for term in criterion if term.get("weight", 1) == 1] for criterion in said.get("cost", [])[:3]]
        if said.get("constraint", "strips") != "strips" or "cost" in said and (counted != usual or [len(c) for c in said["cost"][:3]] != [1, 2, 1]):
            raise NotServed("%s: an operation without reasons: matchings have none, nor costs that do not begin like the default cost" % path)
        self.before, self.after = (Patch(list(range(count)), inner, owners) for count, inner, owners in graphs_of(said))
        give_up = said.get("give_up", "none")
        self.may_go = sum(1 << p for p in ({"none": [], "all": range(len(self.before.owners))}[give_up] if isinstance(give_up, str) else give_up))

    def recounted(self):
        """Claims, and the keys of all valid configurations: ports, and joined pairs that some recolouring of these joins."""
        shift, ports = len(self.after.inner), len(self.after.owners)
        joins = {}  # by the ports kept
        for edges in range(1 << shift + ports):
            groups = self.after.strips(edges)
            joins[edges >> shift] = joins.get(edges >> shift, 0) | (mask_of(groups) if groups is not None else 0)
        relevant = {}
        for solid in range(1 << ports):
            relevant[solid] = 0
            for kept, joined in joins.items():
                if kept & ~solid == 0 and solid & ~kept & ~self.may_go == 0:
                    relevant[solid] |= joined
        count, keys, inner = 0, set(), len(self.before.inner)
        for edges in range(1 << inner + ports):
            groups = self.before.strips(edges)
            if groups is not None:
                count += 1
                keys.add((edges >> inner, mask_of(groups) & relevant[edges >> inner]))
        return {"configurations": 1 << inner + ports, "valid": count, "keys": len(keys)}, keys


def check(path, max_k=8, operation=None):
    """Of a shipped family, or of a custom operation."""
    with open(path, "rb") as file:
        lines = file.read().split(b"\n")
    family, section, rules, copies = "", None, 0, 0
    for number, line in enumerate(lines, 1):
        words = line.decode("ascii", "replace").split(" ")
        try:
            if number == 1 and words != ["restrip-certificate", "3"] and lines[1] != b"family automaton":
                raise Wrong("not a certificate of version 3")
            if number == 2 and words[1:] == ["automaton"]:
                return "%s: not looked at, an automaton has no reasons; restrip-verify automaton checks it" % path
            if number == 2 and words[0] == "operation":
                family, waiting = words[1], [operation.name] if operation else positions(words[1], max_k)
                if operation and family != operation.name:
                    raise Wrong("expected operation " + operation.name)
            elif words[0] == "section":
                if section:
                    section.close()
                if not waiting or " ".join(words[1:]) != waiting[0]:
                    raise Wrong("expected " + ("section " + waiting[0] if waiting else "end"))
                position = waiting.pop(0)
                section = Section(position, operation.recounted if operation else partial(recounted, family, position))
                patch = operation.after if operation else patch_of(family, words[1:])
                may_go = operation.may_go if operation else 15 if family == "flip" else 0
                proved = {}
            elif words[0] in ("rule", "copy"):
                row = Row(patch, may_go, words)
                section.row(row.key)
                rest = words[5:]
                if words[0] == "rule" and rest.pop(0) == "because":
                    row.prove(rest)
                    proved[row.key] = row.own_loss()
                    rules += 1
                elif words[0] == "copy" and rest.pop(0) == "by":
                    to, rest = tuple(natural(word) for word in rest), []
                    if proved.get(row.image(to, may_go)) != row.own_loss():
                        raise Wrong("no rule that it is a copy of")
                    copies += 1
                if rest:
                    raise Wrong("more words than a row has")
            elif words[0] == "end":
                if waiting:
                    raise Wrong("expected section " + waiting[0])
                section.close()
                above = b"".join(text + b"\n" for text in lines[:number - 1])
                sums = [rules + copies, sum(above), sum(place * byte for place, byte in enumerate(above, 1))]
                if words[1:] != [str(one) for one in sums] or lines[number:] != [b""]:
                    raise Wrong("expected end %d %d %d and the end of the file" % tuple(sums))
                return report(path, rules, copies)
            elif words[0] == "claim" and len(words) == 3:
                section.claim(words[1], words[2])
            elif number > 1:
                raise Wrong("unknown line")
        except (Wrong, ValueError, IndexError, KeyError, AttributeError, TypeError, UnboundLocalError) as error:
            raise Wrong("%s:%d: %s" % (path, number, error)) from None
    raise Wrong("%s:%d: no last line" % (path, len(lines)))


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        sys.exit(0 if len(sys.argv) > 1 else 2)
    try:
        if sys.argv[1] == "--operation" and len(sys.argv) == 4:
            print(check(sys.argv[3], operation=Operation(sys.argv[2])))
        else:
            for name in sys.argv[1:]:
                print(check(name))
            print("k <= 8; read: certificates only; no header was read")
    except Wrong as wrong:
        sys.exit("check_reasons.py: " + str(wrong))
    except (NotServed, OSError, json.JSONDecodeError, UnicodeDecodeError) as error:
        print("check_reasons.py:", error, file=sys.stderr)
        sys.exit(2)
