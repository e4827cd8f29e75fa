#!/usr/bin/env python3
"""Two rule sets for splits that need no search, as CSV for `restrip-verify rules`, and what they cost.

inherit:        both halves of a cut edge inherit its colour; the two new triangles join if both are isolated
clear:          every inner edge is cleared
table PROGRAM:  the table of docs/explanation/paper.md, by PROGRAM, a restrip-verify
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
from strips_table import header, line  # noqa: E402


def inherit(k, a, loop):
    """Inner edges (docs/reference/notation.md, "Ring with chord"): A, t_0 … t_{a-1}, D, t_a … t_{k-1}, and back to A."""
    at_a, at_d = loop >> (k - 1) & 1, loop >> (a - 1) & 1
    inner = at_a | at_d << a | at_d << (a + 1) | at_a << (k + 1) | int(not at_a and not at_d) << (k + 2)
    for i in range(k - 1):  # e_i joins t_i and t_{i+1}
        if i != a - 1:
            inner |= (loop >> i & 1) << (i + 1 if i < a - 1 else i + 2)
    return inner


RULES = {"inherit": inherit, "clear": lambda k, a, loop: 0}


def rows(rule):
    """All valid configurations up to k = 8."""
    for k in range(3, 9):
        for a in range(1, k // 2 + 1):
            for loop in range((1 << k) - 1):  # all solid would be a cycle
                before = loop << 1 & (1 << k) - 1 | loop >> (k - 1)  # e_{i-1} at bit i
                for ports in range(1 << k):
                    if not loop & before & ports:
                        yield f"{k},{a},{loop},{ports},{rule(k, a, loop)}\n"


def main():
    if len(sys.argv) == 2 and sys.argv[1] in RULES:
        sys.stdout.write("k,a,loop,ports,inner\n")
        sys.stdout.writelines(rows(RULES[sys.argv[1]]))
    elif len(sys.argv) == 3 and sys.argv[1] == "table":
        header("rules", "configurations", "sound", "best", "strips lost per split")
        for name, rule in RULES.items():
            with tempfile.TemporaryDirectory() as folder:
                file = Path(folder) / "rules.csv"
                file.write_text("k,a,loop,ports,inner\n" + "".join(rows(rule)))
                done = subprocess.run([sys.argv[2], "rules", file, "--json", "-"], capture_output=True, text=True)
            if done.returncode not in (0, 1):
                sys.exit(done.stderr)
            found = json.loads(done.stdout)
            share = f"{found['best']:,} ({100 * found['best'] / found['rows']:.1f} %)"
            line([f"`{name}`", f"{found['rows']:,}", f"{found['sound']:,}", share, f"{found['strips_lost'] / found['rows']:.2f}"])
    else:
        sys.exit(__doc__)


main()
