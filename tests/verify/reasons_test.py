"""scripts/check_reasons.py, which shares nothing with our programs, accepts what is right and rejects what was damaged: the small
tables, and the certificates of operations.

  reasons_test.py check_reasons.py restrip-generate TABLES CORPUS SCRATCH CERTIFICATE…
"""
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # leaves no files next to the script
spec = importlib.util.spec_from_file_location("check_reasons", sys.argv[1])
script = importlib.util.module_from_spec(spec)
spec.loader.exec_module(script)


def with_sums(lines):
    above = "".join(line + "\n" for line in lines[:-1]).encode()
    return lines[:-1] + [
        "%s %d %d" % (" ".join(lines[-1].split()[:2]), sum(above), sum((i + 1) * b for i, b in enumerate(above)))]


def damages(lines):
    """(line number, altered line) pairs; each alteration is wrong."""
    for number, line in enumerate(lines, 1):
        words = line.split(" ")
        if words[0] == "end":
            yield number, " ".join(words[:2] + [str(int(words[2]) + 1)] + words[3:])
            yield number, " ".join(words[:1] + [str(int(words[1]) + 1)] + words[2:])
        if words[0] == "alternative":
            mask = int(words[2], 16)
            if mask:
                yield number, " ".join(words[:2] + ["%x" % (mask & (mask - 1))])
            yield number, " ".join(words[:2] + ["%x" % (mask | mask + 1)])
            yield number, line + " 0"
            yield number, line.replace("alternative", "rule")
        if words[0] == "copy":
            yield number, line.replace("copy", "rule")
        if words[0] in ("rule", "copy") and number % 7 == 0:  # other notations, and more ports than there are
            for other in ("0" + words[1], "+" + words[1], "-" + words[1], words[1] + "_0", "%x" % (int(words[1], 16) | 1 << 40)):
                yield number, " ".join([words[0], other] + words[2:])
        if words[0] != "rule":
            continue
        yield number, " ".join(words[:words.index("because")])
        if words[-1] not in ("-", "because"):
            yield number, " ".join(words[:-1] + ["-"] if words[-2] in ("because", "else") else words[:-1])
            yield number, line + " " + words[-1]
        own = words.index("because") - 1
        if words[own] != "0":
            yield number, " ".join(words[:own] + ["%x" % (int(words[own], 16) & (int(words[own], 16) - 1))] + words[own + 1:])
        if "else" in words:
            yield number, " ".join(words[:words.index("else")])


def verdict(lines, path):
    with open(path, "w", encoding="ascii") as file:
        file.write("".join(line + "\n" for line in lines))
    try:
        return script.check(path, 4)
    except script.Wrong as wrong:
        return str(wrong)


def small_tables(certificates):
    """The small tables are accepted, and no table that was damaged: sums brought up to date, so that rows and reasons have to speak for
    themselves, or left, so that the sums have to."""
    tried = 0
    with tempfile.TemporaryDirectory() as folder:
        bad = os.path.join(folder, "bad.cert")
        for certificate in certificates:
            with open(certificate, encoding="ascii") as opened:
                good = opened.read().splitlines()
            assert "rules are sound" in verdict(with_sums(good), bad), certificate
            for number, line in damages(good):
                tried += 1
                altered = good[:number - 1] + [line] + good[number:]
                summed = altered if number == len(good) else with_sums(altered)
                found = verdict(summed, bad)
                named = "bad.cert:%d: " % number in found
                assert named, (certificate, number, line, found)
            def refused(altered, crime):
                """With sums brought up to date: what is there is right, and something is missing, or counted wrongly."""
                found = verdict(with_sums(altered), bad)
                assert "bad.cert:" in found and crime in found, (certificate, crime, found)

            def counted_again(lines):
                rows = sum(line.split(" ")[0] in ("rule", "copy") for line in lines)
                return lines[:-1] + ["end %d 0 0" % rows]

            heads = [number for number, line in enumerate(good) if line.startswith("section ")] + [len(good) - 1]
            for first, second in zip(heads, heads[1:]):  # each section is cut out, the last one as well
                tried += 1
                refused(counted_again(good[:first] + good[second:]), "expected section")
            for number, line in enumerate(good):
                if line.startswith("claim "):
                    tried += 1
                    refused(good[:number] + good[number + 1:], "is missing")
                    refused(good[:number] + [line] + good[number:], "made twice")
                    if line.split(" ")[1] == "configurations" or (
                            line.split(" ")[1] == "valid" and "collapse" not in certificate):
                        refused(good[:number] + [line + "0"] + good[number + 1:], "recounted")
                # No copy follows from a copy, so that any may be left out, and is missed by its key alone.
                if number % 7 != 0:  # a seventh of the copies is enough, and takes less time than all
                    continue
                if line.startswith("copy ") and "collapse" not in certificate:
                    tried += 1
                    refused(counted_again(good[:number] + good[number + 1:]), "has no row")
                if line.startswith("copy "):
                    refused(counted_again(good[:number] + [line] + good[number:]), "ascending order")
            claim = next(number for number, line in enumerate(good) if line.startswith("claim "))
            altered = good[:claim] + [good[claim] + "0"] + good[claim + 1:]
            assert "bad.cert:" in verdict(altered, bad), certificate
    assert tried > 400, tried
    print(tried, "damages noticed")


def checked(script, operation, certificate):
    return subprocess.run([script, "--operation", operation, certificate], capture_output=True, text=True, check=False)


def sealed(lines):
    """The rows with their last line."""
    above = "".join(line + "\n" for line in lines).encode()
    rows = sum(line.startswith(("rule ", "copy ")) for line in lines)
    return above + b"end %d %d %d\n" % (rows, sum(above), sum(place * byte for place, byte in enumerate(above, 1)))


def operations(script, generate, tables, corpus, scratch):
    """Every row of an operation's certificate is found sound and its reason sufficient, whether the reason is a smallest one or a larger
    one that was made at once; certificates with a row missing, a rule worse than need be, a reason that shows too little, or a foreign
    copy are rejected."""
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


small_tables(sys.argv[6:])
operations(*(Path(word).resolve() for word in sys.argv[1:6]))
