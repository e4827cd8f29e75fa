"""Operations and families as files describe them (docs/reference/operation-file.md): the patches of their positions as graphs, and
their certificates (docs/reference/certificate.md)."""
import functools
import itertools
import json
import re
from collections import Counter
from dataclasses import dataclass, field

MOST = {"strips": 2, "matching": 1}  # solid edges of a triangle


class Refused(Exception):
    pass


@dataclass(frozen=True)
class Side:
    """A patch before an operation or after it. Triangles that go by one name on both sides are the same."""
    names: tuple             # of its triangles
    edges: tuple             # inner edges, as two triangles each
    owners: tuple            # the triangle of each port
    corners: tuple = ()      # three vertices of each triangle, counter-clockwise, if the file names them
    rim: tuple = ()          # its rim, from port 0: the number of the port, or None on the boundary, and both ends


@dataclass(frozen=True)
class Position:
    description: "Description"
    text: str                # as in reports
    section: str             # of the certificate
    before: Side
    after: Side


# ---- sides: triangles, or the fans of tables/families.json

def sum_of(text, numbers):
    """"2 a + k - 1"."""
    total, rest = 0, text.replace(" ", "")
    for sign, factor, name in re.findall(r"([+-]?)(\d*)([a-z]*)", rest):
        if factor or name:
            total += (-1 if sign == "-" else 1) * int(factor or 1) * (numbers[name] if name else 1)
    return total


def holds(conditions, numbers):
    """"k >= 1, 0 <= i < j <= k"."""
    compare = {"<": int.__lt__, "<=": int.__le__, ">=": int.__ge__, "=": int.__eq__}
    for condition in conditions.split(",") if conditions else ():
        first, *rest = re.split(r"(<=|>=|<|>|=)", condition)
        for sign, then in zip(rest[::2], rest[1::2]):
            if not compare[sign](sum_of(first, numbers), sum_of(then, numbers)):
                return False
            first = then
    return True


def filled(pattern, numbers):
    """"k {k} a {a}"."""
    return re.sub(r"{(\w+)}", lambda named: str(numbers[named[1]]), pattern)


def side_of_fan(given, numbers):
    """The triangles t_i by their index, then the inserted ones; edges along the ring or path, then the chord."""
    kind = "ring" if "ring" in given else "path"
    row = []
    for word in given[kind]:
        named, low, high = re.fullmatch(r"(\w+)(?:\[(.+),(.+)\))?", word).groups()
        row += [named] if low is None else [f"{named}{i}" for i in range(sum_of(low, numbers), sum_of(high, numbers))]
    fan = [name for name in row if name not in given[kind]]
    names = fan + [name for name in row if name in given[kind]]
    pairs = list(zip(row, row[1:] + row[:1] if kind == "ring" else row[1:])) + ([given["chord"]] if "chord" in given else [])
    return Side(tuple(names), tuple((names.index(u), names.index(v)) for u, v in pairs), tuple(range(len(fan))))


def triangles_at(given, numbers):
    """Triangles of a family at one position: "u[i+1]" is u_3 if i is 2."""
    def vertex(word, known):
        name, index = re.fullmatch(r"(\w+)(?:\[(.+)\])?", word).groups()
        return name if index is None else f"{name}_{sum_of(index, known)}"

    for *corners, last in (words if len(words) == 4 else (*words, None) for words in given):
        name, low, high = re.fullmatch(r"([a-z]+)\[(.+),(.+)\)", last).groups() if last else ("", "0", "1")
        for i in range(sum_of(low, numbers), sum_of(high, numbers)):
            yield [vertex(word, {**numbers, name: i}) for word in corners]


def sides_of(corners):
    return [(corners[n], corners[(n + 1) % 3]) for n in range(3)]


def rim_of(triangles):
    """The edges that have one triangle, in the order of the rim, from the first that one meets."""
    directed = [side for corners in triangles for side in sides_of(corners)]
    there = set(directed)
    rim = [side for side in directed if side[::-1] not in there]
    after = dict(rim)
    if not rim or len(there) < len(directed) or len(after) < len(rim):
        raise Refused("its triangles are not a disc")
    out = [rim[0]]
    while (end := out[-1][1]) != out[0][0]:
        out.append((end, after[end]))
    inner = (len(directed) - len(rim)) // 2
    if len(out) < len(rim) or len({v for side in directed for v in side}) - inner - len(rim) + len(triangles) != 1:
        raise Refused("its triangles are not a disc")
    return out


def sides_of_triangles(before, after, stretches):
    """Both sides: their ports are on the outline before."""
    ports, out = None, []
    for triangles in (before, after):
        rim = rim_of(triangles)
        boundary = set()
        for start, end in stretches:
            at = [side[0] for side in rim].index(start)
            stretch = rim[at:] + rim[:at]
            boundary.update(stretch[:1 + [side[1] for side in stretch].index(end)])
        met = [side for corners in triangles for side in sides_of(corners) if side in rim and side not in boundary]
        at = rim.index(ports[0] if ports and ports[0] in rim else met[0])
        rim = rim[at:] + rim[:at]
        ports = ports or [side for side in rim if side not in boundary]
        if ports != [side for side in rim if side not in boundary]:
            raise Refused("its rim differs before and after")
        at = {side: n for n, corners in enumerate(triangles) for side in sides_of(corners)}
        edges = [(at[end, start], n) for n, corners in enumerate(triangles) for start, end in sides_of(corners) if at.get((end, start), n) < n]
        names = tuple(" ".join(min(corners[n:] + corners[:n] for n in range(3))) for corners in triangles)
        out.append(Side(names, tuple(edges), tuple(at[port] for port in ports), tuple(map(tuple, triangles)),
                        tuple((ports.index(side) if side in ports else None, *side) for side in rim)))
    return out


# ---- descriptions

@dataclass(frozen=True)
class Description:
    given: dict = field(hash=False)
    name: str

    @property
    def about(self):
        return self.given.get("about", "")

    @property
    def certificate(self):
        return self.given.get("certificate", self.name)

    @property
    def has_table(self):
        return self.given.get("table", True)

    @property
    def constraint(self):
        return self.given.get("constraint", "strips")

    @property
    def gives_up(self):
        return self.given.get("give_up", "none") not in ("none", [])

    def sides(self, numbers):
        before, after = self.given["before"], self.given["after"]
        if isinstance(before, list) and isinstance(after, list):
            boundary = self.given.get("boundary", [])
            if numbers:
                before, after = (list(triangles_at(side, numbers)) for side in (before, after))
                boundary = [ends[:2] for ends in triangles_at(([*ends, ends[1]] for ends in boundary), numbers)]
            return sides_of_triangles(before, after, boundary)
        return [side_of_fan(side, numbers) for side in (before, after)]

    def positions(self, largest):
        """Those that have rules, as far as the first number goes."""
        words = self.given.get("numbers", [])
        for chosen in itertools.product(range(largest + 1), repeat=len(words)):
            numbers = dict(zip(words, chosen))
            if max(chosen, default=0) == (chosen or (0,))[0] and all(holds(self.given.get(m), numbers) for m in ("where", "listed")):
                text = filled(self.given.get("position", " ".join(f"{word} {{{word}}}" for word in words) or self.name), numbers)
                section = filled(self.given.get("section", text), numbers)
                yield Position(self, text, section, *self.sides(numbers))


def descriptions(path):
    try:
        given = json.loads(path.read_text(encoding="utf-8"))
        if given["restrip_operation"] != 1:
            raise Refused("restrip_operation: only version 1 is known here")
        out = [Description(each, each["name"]) for each in given.get("operations", [given])]
        for word in (word for each in out for word in (each.name, each.certificate)):  # names of files and anchors
            if len(word) > 60 or not re.fullmatch("[a-z][a-z0-9]*(-[a-z0-9]+)*", word):
                raise Refused("a name has at most 60 lower-case letters, digits and single hyphens between them")
        return out
    except Refused as fault:
        raise Refused(f"{path}: {fault}") from None
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as fault:
        raise Refused(f"{path}: is not an operation file: {fault!r}") from None


def positions_of(path, largest=8):
    """All positions of all descriptions in a file."""
    for description in descriptions(path):
        try:
            yield from description.positions(largest)
        except Refused as fault:
            raise Refused(f"{path}: {description.name}: {fault}") from None
        except (ValueError, KeyError, TypeError, AttributeError, IndexError):
            raise Refused(f"{path}: {description.name}: is not described as docs/reference/operation-file.md says; "
                          "restrip-generate rules names the fault") from None


# ---- certificates

@dataclass
class Section:
    text: str
    claims: dict = field(default_factory=dict)
    rules: list = field(default_factory=list)   # P, J, R, K, reason or None
    copies: list = field(default_factory=list)  # P, J, R, K, where each port goes


def reason(words):
    """The case tree, from words; returns it and the words left."""
    if words[0] == "if":
        edge = int(words[1])
        solid, rest = reason(words[3:])
        dashed, rest = reason(rest[1:])
        return (edge, solid, dashed), rest
    sets = list(itertools.takewhile(lambda word: word != "else", words))
    return [int(word, 16) for word in sets if word != "-"], words[len(sets):]


def certificate(path):
    """The operation's name and the sections."""
    try:
        lines = path.read_text(encoding="ascii").split("\n")
    except (OSError, ValueError) as fault:
        raise Refused(f"{path}: {fault}") from None
    if lines[0] != "restrip-certificate 3" or len(lines) < 4 or not lines[-2].startswith("end "):
        raise Refused(f"{path}: is not a complete certificate")
    sections, rows = [], 0
    for number, line in enumerate(lines[2:-2], start=3):
        try:
            word, *words = line.split()
            if word == "section":
                sections.append(Section(" ".join(words)))
            elif word == "claim":
                sections[-1].claims[words[0]] = int(words[1])
            elif word in ("rule", "copy"):
                rows += 1
                masks, rest = [int(mask, 16) for mask in words[:4]], words[5:]
                if word == "copy":
                    sections[-1].copies.append((*masks, [int(port) for port in rest]))
                else:
                    tree, rest = reason(rest) if rest else (None, [])
                    sections[-1].rules.append((*masks, tree))
                    if rest:
                        raise ValueError
            else:
                raise ValueError
        except (ValueError, IndexError):
            raise Refused(f"{path}:{number}: is not a line of a certificate: {line}") from None
    if rows != int(lines[-2].split()[1]):
        raise Refused(f"{path}: has {rows} rows, not the number that it states")
    return lines[1].removeprefix("operation "), sections


# ---- keys

def bits(mask):
    return [i for i in range(mask.bit_length()) if mask >> i & 1]


def pairs_of(joined):
    """Pairs of ports i < j, of which bit j (j - 1) / 2 + i is the mask."""
    return [(i, j) for j in range(joined.bit_length() + 1) for i in range(j) if joined >> j * (j - 1) // 2 + i & 1]


@functools.lru_cache(maxsize=None)
def ports_within(owners, room):
    """Port masks that give no triangle more solid ports than it has room for, with the mask of all pairs of their ports."""
    out = []
    for ports in range(1 << len(owners)):
        solid = bits(ports)
        if all(number <= room[owner] for owner, number in Counter(owners[i] for i in solid).items()):
            out.append((ports, sum(1 << j * (j - 1) // 2 + i for i in solid for j in solid if i < j)))
    return out


@functools.lru_cache(maxsize=None)
def inner_colors(side, most):
    """What valid colours of the inner edges leave to the ports, how many do by their number of solid edges, and the first of
    those with the fewest: {(room at each triangle, pairs of ports at one component): (Counter, colours)}."""
    out = {}
    has = Counter(side.owners)

    def go(edge, colors, degree, part):
        if edge == len(side.edges):
            room = tuple(min(most - degree[n], has[n]) for n in range(len(side.names)))
            pairs = sum(1 << j * (j - 1) // 2 + i for j, v in enumerate(side.owners) for i, u in enumerate(side.owners[:j])
                        if part[u] == part[v] and room[u] > 0 and room[v] > 0)
            count, best = out.setdefault((room, pairs), (Counter(), colors))
            count[colors.bit_count()] += 1
            if (colors.bit_count(), colors) < (best.bit_count(), best):
                out[room, pairs] = count, colors
            return
        go(edge + 1, colors, degree, part)
        u, v = side.edges[edge]
        if degree[u] < most and degree[v] < most and part[u] != part[v]:
            more = [d + (n in (u, v)) for n, d in enumerate(degree)]
            go(edge + 1, colors | 1 << edge, more, [part[u] if p == part[v] else p for p in part])

    go(0, 0, [0] * len(side.names), list(range(len(side.names))))
    return out


def strips_left(side, constraint, edges, ports):
    """Strips of a patch with this many solid edges, less its solid ports; for matchings, the unpaired triangles."""
    return len(side.names) - (2 if constraint == "matching" else 1) * edges - ports


def strips_added(position, before, colors, ports, kept):
    """By a recolouring, if `before` was strips_left(); for a matching, a port given up leaves a triangle outside alone."""
    constraint = position.description.constraint
    given_up = (ports & ~kept).bit_count() if constraint == "matching" else 0
    return strips_left(position.after, constraint, colors.bit_count(), kept.bit_count()) + given_up - before


def configurations(positions, section):
    """By key: how many valid configurations before have it, by strips_left(); and of those with the fewest solid edges the
    first, as the number of its position and its inner edges. Pairs of ports that no row of these ports has do not matter."""
    matters, out = Counter(), {}
    for ports, joined, *_ in section.rules + section.copies:
        matters[ports] |= joined
    for n, position in enumerate(positions):
        side, constraint = position.before, position.description.constraint
        for (room, pairs), (counts, colors) in inner_colors(side, MOST[constraint]).items():
            for ports, both in ports_within(side.owners, room):
                key = ports, pairs & both & matters[ports]
                known, best = out.setdefault(key, (Counter(), (99,)))
                for solid, count in counts.items():
                    known[strips_left(side, constraint, solid, ports.bit_count())] += count
                out[key] = known, min(best, (colors.bit_count(), n, colors))
    return {key: (known, *best[1:]) for key, (known, best) in out.items()}
