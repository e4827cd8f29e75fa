"""Claim: scripts/check_reasons.py, which shares nothing with our programs, finds every row of an operation's certificate
sound and its reason sufficient, whether the reason is a smallest one or a larger one that was made at once; and it rejects
certificates with a row missing, a rule worse than need be, a reason that shows too little, a foreign copy.

  operation_reasons_test.py check_reasons.py restrip-generate TABLES CORPUS SCRATCH
"""
import re
import subprocess
import sys
from pathlib import Path


def checked(script, operation, certificate):
    return subprocess.run([script, "--operation", operation, certificate], capture_output=True, text=True, check=False)


def sealed(lines):
    """The rows with their last line."""
    above = "".join(line + "\n" for line in lines).encode()
    rows = sum(line.startswith(("rule ", "copy ")) for line in lines)
    return above + b"end %d %d %d\n" % (rows, sum(above), sum(place * byte for place, byte in enumerate(above, 1)))


def main():
    script, generate, tables, corpus, scratch = (Path(word).resolve() for word in sys.argv[1:])
    accepted = 0
    for operation in sorted((tables / "operations").glob("*.json")):
        if '"matching"' in operation.read_text(encoding="utf-8"):
            continue  # has no reasons
        done = checked(script, operation, tables / "certificates/operations" / (operation.stem + ".cert"))
        if done.returncode != 0 or "have their reasons" not in done.stdout:
            raise SystemExit(done.stdout + done.stderr)
        accepted += 1
    operation = corpus / "seven-to-five.json"
    subprocess.run([generate, "rules", "--operation", operation, "--operation", corpus / "merge-face.json", "--out", scratch], check=True,
                   stdout=subprocess.DEVNULL)
    for name in ("seven-to-five", "merge-face"):
        done = checked(script, corpus / (name + ".json"), scratch / f"certificates/operations/{name}.cert")
        if done.returncode != 0:
            raise SystemExit(done.stdout + done.stderr)
    certificate = scratch / "certificates/operations/seven-to-five.cert"
    lines = certificate.read_text(encoding="ascii").splitlines()[:-1]
    most_cases = max(line.count(" if ") for line in lines)
    if most_cases < 20:
        raise SystemExit(f"no reason has more than {most_cases} cases")

    at = next(i for i, line in enumerate(lines) if re.fullmatch(r"rule \w+ \w+ \w+ \w+ because \w+( \w+){2,}", line))
    copy = next(i for i, line in enumerate(lines) if line.startswith("copy"))
    words = lines[at].split(" ")
    solid = next(bit for bit in range(4) if int(words[3], 16) >> bit & 1)
    altered = {
        "a row is missing": lines[:at] + lines[at + 1:],
        "a rule has an edge less": lines[:at] + [" ".join(words[:3] + [f"{int(words[3], 16) & ~(1 << solid):x}"] + words[4:])] + lines[at + 1:],
        "a reason has a set less": lines[:at] + [" ".join(words[:-1])] + lines[at + 1:],
        "a set is larger than it may be": lines[:at] + [" ".join(words[:-2] + ["7ff"])] + lines[at + 1:],
        "a copy by another permutation": lines[:copy] + [lines[copy].split(" by ")[0] + " by 0 1 2 3 4 5 6"] + lines[copy + 1:],
        "a copy by what is not a symmetry": lines[:copy] + [lines[copy].split(" by ")[0] + " by 1 0 2 3 4 5 6"] + lines[copy + 1:],
        "another number of keys": [re.sub(r"^(claim keys) \d+$", r"\1 820", line) for line in lines],
    }
    bad = scratch / "bad.cert"
    for crime, text in altered.items():
        bad.write_bytes(sealed(text))
        done = checked(script, operation, bad)
        if text == lines or done.returncode != 1 or "bad.cert" not in done.stderr:
            raise SystemExit(f"{crime}: {done.returncode} {done.stdout}{done.stderr}")
    bad.write_bytes(sealed(lines))
    if checked(script, operation, bad).returncode != 0:
        raise SystemExit("what is not altered is rejected")
    print(accepted, "shipped certificates accepted,", len(altered), "altered ones rejected")
    if accepted < 6:
        raise SystemExit("too few to be conclusive")


main()
