#!/usr/bin/env python3
"""A family of one's own is taken as an operation of one's own is: the generator solves every position up to --max-k, the
verifier proves the certificate, and refuses one that was forged or is for other positions. The shipped families under other
names get the shipped rules, linked ones included. Files that make no family are refused by both programs with a sentence.

  family_files_test.py GENERATOR VERIFIER CORPUS FAMILIES CERTIFICATES SCRATCH
"""
import copy
import json
import subprocess
import sys
from pathlib import Path

GENERATOR, VERIFIER, CORPUS, FAMILIES, CERTIFICATES, SCRATCH = map(Path, sys.argv[1:])
MAX_K = "6"

FAN = {
    "restrip_operation": 1,
    "name": "fan-own",
    "numbers": ["k", "i"],
    "where": "k >= 2, i < k",
    "position": "k {k} i {i}",
    "section": "k {k}",
    "before": {"ring": ["A", "t[0,i)", "D", "t[i,k)"]},
    "after": {"path": ["t[0,k)"]},
    "give_up": "all",
}
# Each fault: what is other in the family, and a word of each program.
REFUSED = {
    "no position so small": ({"where": "k >= 9, i < k"}, "fan-own has no position up to 6", "has no position up to 6"),
    "a section for what differs": ({"section": "i {i}"}, "section i 0 cannot serve fan-own", "cannot serve both"),
    "a section that leaves out what is after": (
        {"section": "k {k}", "after": {"path": ["t[0,i)", "t[i,k)"], "chord": ["t[0,1)", "t[i,i+1)"]}}, "fan-own", "after"),
    "positions of one name": ({"position": "k {k}"}, '"position"|{i} is missing', 'also "{i}"'),
    "an unknown number": ({"where": "k >= 2, j < k"}, "where", "expected a sum of k, i"),
    "four numbers": ({"numbers": ["k", "i", "j", "l"]}, "3 numbers at most", "numbers"),
    "other ports after": ({"after": {"path": ["t[0,k-1)"]}}, "2 ports before and 1 after", "expected as many ports as before"),
    "too many triangles": (
        {"before": {"ring": ["t[0,k)", "s[0,3 k)"], "ports": ["t[0,k)"]}}, "fan-own k 5 i 0: expected 1 to 16 triangles",
        "before: expected 1 to 16 triangles, found 20"),
    "no such triangle": ({"after": {"path": ["t[0,k)"], "chord": ["t[0,1)", "N"]}}, "N is not in it", "no triangle is named N"),
    "linked rules that give ports up": ({"linked": True}, "linked rules are for strips", "linked rules are for strips"),
}


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


def expect(condition, what):
    if not condition:
        sys.exit(what)


def solve(file, max_k=MAX_K):
    return run(GENERATOR, "rules", "--operation", file, "--out", SCRATCH, "--max-k", max_k)


def certificate(name):
    return SCRATCH / "certificates/operations" / (name + ".cert")


def verify(file, name, *options, max_k=MAX_K):
    return run(VERIFIER, "--operation", file, "--certificate", certificate(name), "--max-k", max_k, *options)


def sealed(lines):
    """The lines of a certificate, without its last, with a last one that fits."""
    text = ("\n".join(lines) + "\n").encode()
    rows = sum(line.startswith(("rule ", "copy ")) for line in lines)
    return text + b"end %d %d %d\n" % (rows, sum(text), sum(place * byte for place, byte in enumerate(text, 1)))


def forge(name, change):
    """Writes the certificate anew with one row changed."""
    lines = certificate(name).read_text().splitlines()[:-1]
    place = next(i for i in reversed(range(len(lines))) if change(lines[i]) != lines[i])
    lines[place] = change(lines[place])
    certificate(name).write_bytes(sealed(lines))


def gives_all_up(row):
    words = row.split()
    if words[0] != "rule" or words[4] == "0":
        return row
    return " ".join([*words[:4], "0", *words[5:]])


def check_own_families():
    files = sorted(CORPUS.glob("families/*.json"))
    expect(len(files) >= 2, "files are missing")
    for file in files:
        name = file.stem
        made = solve(file)
        expect(made.returncode == 0 and " bytes\n" in made.stdout, f"{name}: {made.stderr}{made.stdout}")
        sections = [line for line in certificate(name).read_text().splitlines() if line.startswith("section ")]
        expect(len(sections) >= 3, f"{name}: only {sections}")
        proved = verify(file, name)
        expect(proved.returncode == 0 and "\nverified: " in proved.stdout, f"{name}: {proved.stderr}{proved.stdout}")
        expect("as good, no sound recolouring has less given_up" in proved.stdout, f"{name}: {proved.stdout}")
        fewer = verify(file, name, max_k="5")
        expect(fewer.returncode == 2 and "section" in fewer.stderr, f"{name}: k to 6 taken for k to 5: {fewer.stderr}")
        forge(name, gives_all_up)
        forged = verify(file, name)
        expect(forged.returncode == 1 and "no sound recolouring has less" in forged.stdout, f"{name}: forged, and taken")
        expect("NOT verified" in forged.stdout, f"{name}: {forged.stdout}")


def check_shipped_families():
    families = json.loads(FAMILIES.read_text())
    certificates = set()
    for family in families["operations"]:
        shared = family.get("certificate", family["name"])
        certificates.add(shared)
        family["name"], family["certificate"] = "my-" + family["name"], "my-" + shared
    all_own = SCRATCH / "my-families.json"
    all_own.write_text(json.dumps(families))
    made = solve(all_own)
    expect(made.returncode == 0, made.stderr)
    linked = {"linked-split", "linked-collapse"}
    for name in certificates | linked:
        own = certificate("linked-my-" + name[7:] if name in linked else "my-" + name).read_text().splitlines()[2:-1]
        shipped = (CERTIFICATES / (name + ".cert")).read_text().splitlines()[2:]
        expect(len(own) > 10 and own == shipped[:len(own)], f"{name}: other rules than the shipped ones")
    one = {"restrip_operation": 1, "operations": [family for family in families["operations"] if family["name"] == "my-collapse"]}
    file = SCRATCH / "my-collapse.json"
    file.write_text(json.dumps(one))
    proved = verify(file, "my-collapse", "--linked-certificate", certificate("linked-my-collapse"))
    expect(proved.returncode == 0 and " alternatives, " in proved.stdout, proved.stderr + proved.stdout[-500:])
    many = verify(all_own, "my-split")
    expect(many.returncode == 2 and "expected the operations of one certificate" in many.stderr, many.stderr)


def check_refused():
    file = SCRATCH / "fan-own.json"
    for what, (change, by_generator, by_verifier) in {"nothing": ({}, "", ""), **REFUSED}.items():
        family = copy.deepcopy(FAN)
        family.update(change)
        file.write_text(json.dumps(family))
        if change:
            certificate("fan-own").write_text("")
        for done, words in ((solve(file), by_generator), (verify(file, "fan-own"), by_verifier)):
            if not change:
                expect(done.returncode == 0, f"the family without a fault: {done.stderr}{done.stdout}")
                continue
            expect(done.returncode == 2, f"{what}: taken by {done.args[0]}: {done.stdout}{done.stderr}")
            expect(any(word in done.stderr for word in words.split("|")), f"{what}: {done.stderr}")
    done = run(GENERATOR, "rules", "--operation", CORPUS / "split-face.json", "--out", SCRATCH, "--max-k", MAX_K)
    expect(done.returncode == 2 and "no family, so --max-k has no effect" in done.stderr, done.stderr)


SCRATCH.mkdir(parents=True, exist_ok=True)
check_own_families()
check_shipped_families()
check_refused()
