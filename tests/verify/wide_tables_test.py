#!/usr/bin/env python3
"""Claim: restrip-verify judges tables of k = 9, which it does not search: it accepts them as the generator makes them, and
refuses each forgery by the claim that it breaks, although sums, counts and MANIFEST fit the forgery.

  wide_tables_test.py restrip-verify TABLES
"""
import hashlib
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

VERIFY, TABLES = sys.argv[1], Path(sys.argv[2])
SPLIT = "\nsection k 9 a 2\n"

# Family, section, what is replaced there for the first time, by what, and the claim that must fail.
FORGERIES = [
    ("split", SPLIT, "\nrule 20 0 77f 20 because c0 80c\n", "\nrule 20 0 77e 20 because c0 80c\n",
     "every rule has a reason why nothing is preferred to it"),
    ("split", SPLIT, "\nrule 20 0 77f 20 because c0 80c\n", "\nrule 20 0 77f 20 because c0 804\n",
     "every rule has a reason why nothing is preferred to it"),
    ("split", SPLIT, "\nrule 20 0 77f 20 because c0 80c\n", "\nrule 20 0 7ff 20 because c0 80c\n", "every row is sound"),
    ("split", SPLIT, "\nrule 3 1 7fd 3 because 3 80c\n", "\n", "every valid configuration has a row"),
    ("split", SPLIT, "\nclaim costing 270\n", "\nclaim costing 269\n", "the stated numbers"),
]


def verdict(folder, families, max_k=("--max-k", "9")):
    """Exit code, and the claims that do not hold."""
    command = [VERIFY, "--tables-dir", folder, *max_k]
    for family in families:
        command += ["--family", family]
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, [line for line in done.stdout.splitlines() if line.startswith("FAILS")], done.stdout


def sealed(text):
    """The certificate with the number of its rows and its sums as they must be."""
    body = text[:text.rindex("\nend ") + 1]
    rows = len(re.findall(r"^(?:rule|copy) ", body, re.M))
    data = body.encode()
    weighted = sum((i + 1) * byte for i, byte in enumerate(data))
    return f"{body}end {rows} {sum(data)} {weighted}\n", rows


def forge(folder, family, section, old, new):
    path = folder / "certificates" / f"{family}.cert"
    text = path.read_text()
    before = sealed(text)[1]
    at = text.index(section)
    forged, count = re.subn(old, new, text[at:], count=1)
    assert count == 1, f"{path}: {old!r} is not in {section!r}"
    text, rows = sealed(text[:at] + forged)
    path.write_text(text)
    manifest = folder / "MANIFEST"
    line = f"{hashlib.sha256(text.encode()).hexdigest()} {len(text)} {rows} certificates/{family}.cert"
    # The header has the rows of its certificates.
    header = f" include/restrip/tables/{family.replace('-', '_')}.hpp"
    more = rows - before
    lines = []
    for old_line in manifest.read_text().splitlines():
        if old_line.endswith(f" certificates/{family}.cert"):
            old_line = line
        elif old_line.endswith(header):
            old_line = re.sub(r" (\d+) include", lambda found: f" {int(found[1]) + more} include", old_line)
        lines.append(old_line)
    manifest.write_text("\n".join(lines) + "\n")


code, failed, printed = verdict(TABLES, ["split"])
assert code == 0 and not failed and "definition, k <= 8" in printed, printed
code, _, printed = verdict(TABLES, ["split"], ())
assert code == 2 and 'found "section k 9' in printed and "raise --max-k" in printed, printed
for family, section, old, new, claim in FORGERIES:
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "tables"
        shutil.copytree(TABLES, folder)
        forge(folder, family, section, old, new)
        code, failed, printed = verdict(folder, [family])
        assert code == 1 and any(claim in line for line in failed), f"{old!r} -> {new!r}: {code}\n{printed}"
        assert all(claim in line or "the stated numbers" in line or "every row has" in line for line in failed), printed
print(f"{len(FORGERIES)} forgeries refused")
