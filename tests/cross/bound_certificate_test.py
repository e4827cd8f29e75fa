#!/usr/bin/env python3
"""Claims: the certificates that `restrip stripify --bound-certificate` writes are those of the bound that it tells; they
are accepted by restrip-verify-bound, and refused for another mesh and when a claim is raised; they are the same bytes in
each run. The bunny's is among them where RESTRIP_MESHES names a folder that has it.

    bound_certificate_test.py restrip restrip-verify-bound SCRATCH
"""
import json
import os
import pathlib
import re
import subprocess
import sys

restrip, verifier, scratch = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
scratch.mkdir(parents=True, exist_ok=True)


def run(*command, code=0):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert done.returncode == code, (command, done.returncode, done.stdout, done.stderr)
    return done.stdout


def stripify(*arguments):
    return json.loads(run(restrip, "stripify", *arguments, "--json", "-"))


def certificate_of(mesh, name, *options):
    file = scratch / name
    told = stripify(mesh, "--bound-certificate", file, *options)
    said = run(verifier, mesh, file)
    assert f"fewer than {told['lower_bound_indices']:,} indices" in said, (said, told)
    return file, told


def refuse_one_unit_more(mesh, text, cut):
    word, multiplier, *vertices = cut.split()
    more = " ".join([word, str(int(multiplier) + 1), *vertices])
    (scratch / "heavy.bound").write_text(text.replace(f"\n{cut}\n", f"\n{more}\n"))
    assert "loaded by more than the denominator" in run(verifier, mesh, scratch / "heavy.bound", code=1)


def check(mesh):
    file, told = certificate_of(mesh, "a.bound")
    text = file.read_text()
    assert told["triangles"] < told["lower_bound_indices"] <= told["indices"]
    # Whatever the strips, and in each run, the same.
    again, _ = certificate_of(mesh, "b.bound", "--cost", "indices")
    assert again.read_bytes() == file.read_bytes()
    # Single vertices alone prove no more.
    quick = stripify(mesh)
    full = stripify(mesh, "--effort", "full", "--limit", 1)
    assert quick["lower_bound_indices"] <= told["lower_bound_indices"] == full["lower_bound_indices"]
    assert max(len(line.split()) for line in text.splitlines()) > 3  # sets of several vertices
    # One index more, however it is claimed.
    for word, count in re.findall(r"(?m)^(arrows|indices) (\d+)$", text):
        raised = f"{word} {int(count) + 1}"
        (scratch / "raised.bound").write_text(text.replace(f"\n{word} {count}\n", f"\n{raised}\n"))
        assert f"claims {int(count) + 1} {word}, but" in run(verifier, mesh, scratch / "raised.bound", code=1)
    # All multipliers are as large as they can be.
    cuts = re.findall(r"(?m)^cut .*$", text)
    for cut in cuts[:: max(1, len(cuts) // 10)]:
        refuse_one_unit_more(mesh, text, cut)
    return file, told


made = scratch / "made.obj"
run(restrip, "make-mesh", "--triangles", 2000, "-o", made)
file, whole = check(made)
other = scratch / "other.obj"
run(restrip, "make-mesh", "--triangles", 3000, "-o", other)
assert "but the mesh has" in run(verifier, other, file, code=1)
# A degenerate triangle and a vertex without triangles.
lines = made.read_text().splitlines(keepends=True)
bad = scratch / "degenerate.obj"
bad.write_text("".join(lines) + "v 1 2 3\nf 1 1 2\n")
_, told = certificate_of(bad, "degenerate.bound")
assert told["left_out"] == 1 and told["triangles"] == whole["triangles"]
# The certificate is no input.
run(restrip, "stripify", made, "--bound-certificate", made, code=2)

bunny = pathlib.Path(os.environ.get("RESTRIP_MESHES", "")) / "bunny.obj"
if bunny.is_file():
    file, told = certificate_of(bunny, "bunny.bound")
    print(f"bunny: {told['lower_bound_indices'] / told['triangles']:.4f} indices per triangle")
    assert told["lower_bound_indices"] >= 1.07 * told["triangles"]
    text = file.read_text()
    refuse_one_unit_more(bunny, text, text[text.index("\ncut ", len(text) // 2) + 1:].split("\n")[0])
