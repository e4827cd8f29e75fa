"""Claims of docs/reference/stability.md about the C interface: what a program compiled with the header of a release relies on stays as long
as RESTRIP_ABI_VERSION does. The declarations are recorded, without comments: none may change or vanish; new ones are allowed.

    stability_test.py            compares
    stability_test.py --record   writes the record, for a new number or new declarations
"""
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HEADER = ROOT / "bindings/c/include/restrip.h"
RECORD = Path(__file__).with_name("stability_c.txt")


def declarations(text):
    """The declarations of a header, one line each, sorted: the number first, types with their members, functions, numbers."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.S)
    numbers = re.findall(r"^#define (RESTRIP_\w+) +(\(?-?\w+\)?)$", text, re.M)
    text = re.sub(r"^#.*(?:\\\n.*)*$", "", text, flags=re.M).replace('extern "C" {', "").replace("RESTRIP_API ", "")
    found = [f"{name} = {value}" for name, value in numbers]
    for body in re.findall(r"enum\s*\w*\s*\{([^}]*)\}", text):
        found += [" ".join(item.split()) for item in body.split(",") if item.strip()]
    text = re.sub(r"enum\s*\w*\s*\{[^}]*\}\s*;", "", text)
    depth, begin = 0, 0
    for at, sign in enumerate(text):
        depth += (sign == "{") - (sign == "}")
        if sign == ";" and depth == 0:
            words = " ".join(text[begin:at].split())
            if words.strip("} "):
                found.append(words.lstrip("} "))
            begin = at + 1
    return sorted(set(found), key=lambda line: (not line.startswith("RESTRIP_ABI_VERSION"), line))


def faults(recorded, now):
    """What a program compiled with the recorded header misses."""
    if recorded[0] != now[0]:
        return [f"{now[0]}; the record is of {recorded[0]}: write it again by --record"]
    return [f"changed or gone: {line}" for line in recorded if line not in now]


class Interface(unittest.TestCase):
    def test_nothing_recorded_changes(self):
        recorded = RECORD.read_text(encoding="utf-8").splitlines()
        self.assertGreater(len(recorded), 100)
        self.assertEqual(faults(recorded, declarations(HEADER.read_text(encoding="utf-8"))), [])

    def test_changes_are_noticed(self):
        text = HEADER.read_text(encoding="utf-8")
        recorded = declarations(text)
        for old, new in (("restrip_mesh_triangle_count(const restrip_mesh", "restrip_mesh_triangle_count(restrip_mesh"),
                         ("RESTRIP_OK = 0", "RESTRIP_OK = 1"), ("restrip_mesh_free", "restrip_mesh_release"), ("size_t first", "uint32_t first")):
            self.assertIn(old, text)
            self.assertEqual(len(faults(recorded, declarations(text.replace(old, new)))) > 0, True, old)
        self.assertEqual(faults(recorded, declarations(text.replace("RESTRIP_OK = 0,", "RESTRIP_OK = 0,\n  RESTRIP_NEW = 99,"))), [])


if __name__ == "__main__":
    if sys.argv[1:] == ["--record"]:
        now = declarations(HEADER.read_text(encoding="utf-8"))
        old = RECORD.read_text(encoding="utf-8").splitlines() if RECORD.exists() else now
        broken = faults(old, now) if old[0] == now[0] else []
        if broken:
            sys.exit("\n".join(["the number must change:", *broken]))
        RECORD.write_text("".join(line + "\n" for line in now), encoding="utf-8")
    else:
        unittest.main()
