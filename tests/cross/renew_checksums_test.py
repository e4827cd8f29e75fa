"""scripts/renew_checksums.py: a rule that is changed by hand is refused for its sums; with new sums it is judged by the definition, and
a configuration in which it fails is named. Sums that are right stay, and files that are no certificates are refused unchanged.

    renew_checksums_test.py VERIFIER SCRATCH
"""
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
verifier, scratch = sys.argv[1], pathlib.Path(sys.argv[2])
shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)


def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def judged(name, certificate):
    return run(verifier, "--operation", ROOT / f"tables/operations/{name}.json", "--certificate", certificate)


for name in ("bisect", "split-face", "merge"):
    shipped = (ROOT / f"tables/certificates/operations/{name}.cert").read_bytes()
    changed = scratch / f"{name}.cert"
    changed.write_bytes(shipped)
    code, said = run(sys.executable, "-B", ROOT / "scripts/renew_checksums.py", changed)
    assert code == 0 and said.endswith("the sums were right\n") and changed.read_bytes() == shipped, said
    # The last rule with solid edges loses or gains its lowest edge.
    rule = list(re.finditer(rb"\nrule (\w+) (\w+) ([1-9a-f]\w*) ", shipped))[-1]
    other = b"%x" % (int(rule[3], 16) ^ 1)
    changed.write_bytes(shipped[:rule.start(3)] + other + shipped[rule.end(3):])
    code, said = judged(name, changed)
    assert code == 2 and "according to the sums in the last line" in said, said
    code, said = run(sys.executable, "-B", ROOT / "scripts/renew_checksums.py", changed)
    assert code == 0 and said.endswith("new sums; not proven\n"), said
    code, said = judged(name, changed)
    assert code == 1 and "according to the sums" not in said, said
    assert re.search(r"FAILS .*\n", said) and f"    {name}, inner " in said and "NOT verified: " in said, said

bad = scratch / "no.cert"
for text in (b"", b"end 1 2\n", b"rule 1 2 3\n", b"end 1 2 3\nrule"):
    bad.write_bytes(text)
    code, said = run(sys.executable, "-B", ROOT / "scripts/renew_checksums.py", bad)
    assert code == 1 and "expected a certificate" in said and bad.read_bytes() == text, said
code, said = run(sys.executable, "-B", ROOT / "scripts/renew_checksums.py", scratch / "missing.cert")
assert code == 1 and "missing.cert: No such file" in said, said
