#!/usr/bin/env python3
"""Claims: on a terminal long commands show each of their steps, and how far it has come if that is known, and wipe the line in the
end; if standard error is not a terminal they show nothing.

    progress_test.py restrip SCRATCH
"""
import os
import pathlib
import pty
import subprocess
import sys

from program import Program

run, scratch = Program(sys.argv[1]), pathlib.Path(sys.argv[2])
scratch.mkdir(parents=True, exist_ok=True)


try:
    for end in pty.openpty():
        os.close(end)
except OSError as error:  # a container or chroot without /dev/pts
    print(f"left out: progress on a terminal: {error}")
    sys.exit(0)


def on_a_terminal(*arguments):
    mine, its = pty.openpty()
    with subprocess.Popen([sys.argv[1], *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=its) as process:
        os.close(its)
        said = b""
        while True:
            try:
                part = os.read(mine, 4096)
            except OSError:  # the other end is closed
                break
            if not part:
                break
            said += part
    os.close(mine)
    assert process.returncode == 0, said
    assert said.endswith(b"\r\033[K"), said[-40:]
    return said.decode()


mesh = scratch / "torus.obj"
run("make-mesh", "--triangles", 2000, "-o", mesh)
bake = ("bake", mesh, "--base", 0.3, "--effort", 2000, "-o", scratch / "torus.baked")
for arguments, steps in ((bake, ("simplifying", "baking")),
                         (("simplify", mesh, "--base", 0.3, "-o", scratch / "torus.pm"), ("simplifying",)),
                         (("replay", scratch / "torus.pm", "--repeats", 0), ("replaying", "keeping an index buffer"))):
    said = on_a_terminal(*arguments)
    at = [said.index(f"{step} \u2026 0 %") for step in steps]
    assert at == sorted(at), said
    assert said.count("%") > 50, said
    assert run(*arguments).stderr == ""
# One step that does not know how much is left.
for arguments, steps in ((("stripify", mesh, "--effort", "best", "--limit", 10), ("making strips",)),
                         (("make-mesh", "--triangles", 2000, "-o", scratch / "other.obj"), ("making a mesh",))):
    said = on_a_terminal(*arguments)
    assert all(f"{step} \u2026" in said for step in steps), said
    assert run(*arguments).stderr == ""
print("progress: all hold")
