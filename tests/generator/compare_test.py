"""restrip-generate compare: rules that are the same, others that cost the same, and the first that costs more, with its
witness; files that it must refuse.

  compare_test.py GENERATE DUMP_TABLES ROOT
"""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

GENERATE, DUMP_TABLES, ROOT = sys.argv[1], sys.argv[2], Path(sys.argv[3])


def said(*words, code):
    done = subprocess.run([GENERATE, *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode != code or (code == 2) != bool(done.stderr):
        raise SystemExit(f"{words}: ended with {done.returncode}, not {code}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def must_be(found, wanted):
    if found != wanted:
        raise SystemExit(f"{found!r}, and not {wanted!r}")


def compared(a, b, code, *more):
    return json.loads(said("compare", a, b, "--json", "-", *more, code=code))


def sealed(text):
    """A certificate's text with the last line for its other lines."""
    body = text[:text.rindex("end ")].encode()
    rows = len(re.findall(rb"^(?:rule|copy|alternative) ", body, re.M))
    return body.decode() + f"end {rows} {sum(body)} {sum((i + 1) * byte for i, byte in enumerate(body))}\n"


def certificates(folder):
    """Of equally good rules; of rules one of which is worse; of fewer positions; of linked rules."""
    strips, indices, small = folder / "strips", folder / "indices", folder / "small"
    said("tables", "--max-k", 5, "--out", strips, code=0)
    said("tables", "--max-k", 5, "--tie-break", "indices", "--out", indices, code=0)
    said("tables", "--max-k", 4, "--out", small, code=0)
    split = "certificates/split.cert"
    text = (strips / split).read_text()
    rules = len(re.findall("^(?:rule|copy) ", text, re.M))
    must_be(said("compare", strips / split, strips / split, code=0), f"the same {rules} rules\n")
    same = compared(strips / split, indices / split, 0)
    must_be((same["verdict"], same["rules"], same["better_in_a"], same["better_in_b"], same["in_one_file"]), ("same costs", rules, 0, 0, 0))
    # What differs is counted in another way: lines without what shows that they are right.
    rows = [[re.sub(r" (?:because|by) .*", "", line).split()[1:] for line in (side / split).read_text().splitlines()[:-1]] for side in (strips, indices)]
    if not 0 < same["other"] == sum(x != y for x, y in zip(*rows)):
        raise SystemExit(f"{same['other']} rules of {rules} are others")

    # All dashed inside is sound; with k = 4, a = 2, ports 5 joined, 6 triangles of which 2 have a port leave 4 strips.
    section, row = "section k 4 a 2\n", re.search(r"^section k 4 a 2\n(?:.*\n)*?((?:rule|copy) 5 2 )(\w+)( 5 .*)\n", text, re.M)
    at = text.index(section)
    worse = folder / "worse.cert"
    worse.write_text(sealed(text[:at] + text[at:].replace(row[1] + row[2] + row[3], f"{row[1]}0{row[3]}", 1)))
    better = int(row[2], 16).bit_count()
    for a, b, side, other in ((strips / split, worse, "a", "b"), (worse, strips / split, "b", "a")):
        found = compared(a, b, 1)
        must_be((found["verdict"], found["other"], found[f"better_in_{side}"], found[f"better_in_{other}"]), ("different", 1, 1, 0))
        first = found["first"]
        must_be((first["place"], first["ports"], first["joined"], first["criteria"]),
                ("split k 4 a 2", "5", [[0, 2]], ["strips", "isolated + given_up", "given_up"]))
        must_be(first[other], {"inner": "0", "ports": "5", "cost": [6 - 2, 6 - 2, 0]})
        must_be((first[side]["inner"], first[side]["cost"][0]), (row[2], 6 - better - 2))
    told = said("compare", strips / split, worse, code=1)
    must_be(told.splitlines()[1:], [
        "the first: split k 4 a 2, ports 5, joined 0-2",
        f"  A: inner edges {row[2]}, ports kept 5: strips {4 - better}, isolated + given_up {first['b']['cost'][1]}, given_up 0",
        "  B: inner edges 0, ports kept 5: strips 4, isolated + given_up 4, given_up 0"])

    found = compared(strips / split, small / split, 1)
    must_be((found["rules"], found["first"]["place"], found["first"]["b"]), (len(re.findall("^(?:rule|copy) ", (small / split).read_text(), re.M)), "split k 5 a 1", None))
    must_be(compared(small / split, strips / split, 1)["in_one_file"], rules - found["rules"])
    lists = "certificates/linked-split.cert"
    must_be(compared(strips / lists, strips / lists, 0)["verdict"], "same rules")
    must_be(compared(strips / lists, indices / lists, 1)["first"]["place"], "linked-split k 3 a 1")
    # Sections that serve several positions.
    for name in ("collapse", "fan-collapse", "flip", "open-split", "boundary-split"):
        must_be(compared(strips / f"certificates/{name}.cert", indices / f"certificates/{name}.cert", 0)["better_in_a"], 0)
    return strips / split, text, row, at


def refused(folder, good, text, row, at):
    """Files that are no certificates of the same operation, each with what is said of it."""
    bad = folder / "bad.cert"
    joins = next(line for line in text[at:].splitlines() if line.startswith(("rule 5 0 ", "copy 5 0 ")))
    for altered, words in (
            (text[:-9], "has no last line"),
            (text[:text.rindex("end ")], "where the last line should be"),
            (text.replace("claim valid", "claim Valid", 1), "the last line for these bytes"),
            (sealed(text.replace(row[1] + row[2], row[1] + "g", 1)), "the row of a rule"),
            (sealed(text[:at] + text[at:].replace(joins, joins + "\n" + joins, 1)), "has a rule for the same"),
            (sealed(text[:at] + text[at:].replace(joins, re.sub(r" 0 \w+ ", f" 0 {row[2]} ", joins, count=1), 1)), "the rule is not sound"),
            (sealed(text[:at] + text[at:].replace(row[1] + row[2] + " 5", row[1] + row[2] + " 1", 1)), "these ports cannot be kept"),
            (sealed(text[:at] + text[at:].replace(row[1] + row[2] + " 5", row[1] + "7f 5", 1)), "the colours after are not valid"),
            (sealed(text.replace("section k 4 a 1", "section k 3 a 1", 1)), "is there already"),
            (text.replace("certificate 3", "certificate 2", 1), "'restrip-certificate 3' should be"),
            (text.replace("restrip-", "nothing-", 1), "the first line of a certificate or a table dump"),
            (sealed(text.replace("operation split", "operation flip", 1)), "compare rules of one operation"),
            ("", "has no last line")):
        bad.write_text(altered)
        found = said("compare", good, bad, code=2)
        if words not in found or str(bad) not in found:
            raise SystemExit(f"{words}: {found}")
    bad.write_text(sealed(text[:at] + text[at:].replace(joins + "\n", "", 1)))
    found = compared(good, bad, 1)
    must_be((found["in_one_file"], found["first"]["ports"], found["first"]["joined"], found["first"]["b"]), (1, "5", [], None))
    for more in ((good, folder / "nothing.cert"), (good,), (good, good, "--operation", folder / "nothing.json")):
        said("compare", *more, code=2)


def dump_of(table):
    """As a program prints it that was compiled with the table."""
    at = table["positions"][0]
    lines = []
    for index, entry in enumerate(table["entries"]):
        inner, ports = index >> at["ports"], index & ((1 << at["ports"]) - 1)
        lines.append(f"{inner:x} {ports:x} " + ("-" if entry == table["none"] else f"{entry >> at['ports']:x} {entry & ((1 << at['ports']) - 1):x} 0"))
    return "\n".join(["restrip-table-dump 4", f"table {table['name']}", *lines, f"end {len(lines)}", ""])


def dumps(folder, good):
    file = ROOT / "tables/operations/bisect.json"
    said("rules", "--operation", file, "--language", "json", "--language", "c++", "--out", folder, code=0)
    text = dump_of(json.loads((folder / "restrip_bisect.json").read_text()))
    a, b = folder / "a.txt", folder / "b.txt"
    a.write_text(text)
    must_be(said("compare", a, a, code=0), "the same 32 rules\n")
    must_be(said("compare", folder / "certificates/operations/bisect.cert", ROOT / "tables/certificates/operations/bisect.cert", code=0), "the same 20 rules\n")
    worse = re.sub("^1 9 7 9 0$", "1 9 0 9 0", text, flags=re.M)
    b.write_text(worse)
    found = said("compare", a, b, code=2)
    if "--operation" not in found:
        raise SystemExit(found)
    first = compared(a, b, 1, "--operation", file)["first"]
    must_be({name: first[name] for name in ("place", "inner", "ports", "joined")}, {"place": "bisect", "inner": "1", "ports": "9", "joined": [[0, 3]]})
    must_be((first["a"], first["b"]), ({"inner": "7", "ports": "9", "cost": [-1, 0, 0]}, {"inner": "0", "ports": "9", "cost": [2, 2, 0]}))
    for altered, words, code in ((re.sub("^1 9 7 9 0$", "1 9 -", text, flags=re.M), "not valid", 1), (re.sub("^1 9 7 9 0\n", "", text, flags=re.M), "'end 31'", 2),
                                 (re.sub("^1 9 7 9 0$", "1 9 7 9", text, flags=re.M), "an entry", 2), (text.replace("table bisect", "table merge"), "different operations", 2)):
        b.write_text(altered)
        found = said("compare", a, b, "--operation", file, code=code)
        if words not in found:
            raise SystemExit(f"{words}: {found}")
    if "one kind" not in said("compare", a, good, code=2):
        raise SystemExit("a dump and a certificate are compared")
    # The shipped families: with themselves, up to k = 4.
    shipped = subprocess.run([DUMP_TABLES], stdout=subprocess.PIPE, text=True, check=True).stdout
    few = "".join(table for table in re.findall(r"^table (?:.*\n)(?:[^te].*\n)+", shipped, re.M) if re.match(r"table (?:flip|\S+ k [1-4]\b)", table))
    entries = few.count("\n") - len(re.findall("^table ", few, re.M))
    a.write_text(f"restrip-table-dump 4\n{few}end {entries}\n")
    must_be(compared(a, a, 0)["rules"], entries)
    # An open split, told as the image of another in the certificate: k = 2, gaps 1 and 2.
    row = re.search(r"^table open-split k 2 gaps 1 2\n(?:.*\n)*?1 3 (\w+) 3 (.*)\n", few, re.M)
    b.write_text(a.read_text().replace(row[0], row[0].replace(f"1 3 {row[1]} 3 {row[2]}\n", "1 3 0 3 0\n")))
    first = compared(a, b, 1)["first"]
    must_be((first["place"], first["joined"], first["b"]["cost"]), ("open-split k 2 gaps 1 2", [[0, 1]], [2, 2, 0]))


def main():
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        good, *rest = certificates(folder)
        refused(folder, good, *rest)
        dumps(folder, good)
        # The example of the help.
        for line in re.findall(r"^ +restrip-generate (.*)$", said("compare", "--help", code=0), re.M):
            said(*line.replace("/tmp/", f"{folder}/").split(), code=0)
    print("compared")


main()
