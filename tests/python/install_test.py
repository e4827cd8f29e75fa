"""The Python package installs into a fresh virtual environment, from a folder of wheels or from its source archive, without a package
index, without the repository and without a trace in the sources; its tests pass there, and its example and README's lines print what is expected.

    install_test.py PACKAGE SCRATCH [WHEELS]
"""
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys

# Triangles are drawn whatever the strips are.
EXAMPLE = r"""1058 triangles, 1[01]\d\d indices in \d+ strips, uint16
at first: 1058 triangles in \d+ strips, 2\d{3} bytes written
after 200 bisections: 1458 triangles in \d+ strips, \d{2,3} bytes written for each
after improving: 1458 triangles in \d+ strips; valid: True
"""

package, scratch = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
here = pathlib.Path(__file__).parent


def run(*command):
    print(*command, flush=True)
    return subprocess.run([str(word) for word in command], check=True, cwd=scratch, stdout=subprocess.PIPE, text=True).stdout


shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)
before = sorted(package.rglob("*"))
run(sys.executable, "-m", "venv", "--system-site-packages", scratch / "venv")
python = scratch / "venv/bin/python"
if len(sys.argv) == 3:
    subprocess.run([sys.executable, "-B", "setup.py", "-q", "sdist", "-d", str(scratch / "archive")], check=True, cwd=package)
    source, = (scratch / "archive").glob("restrip-*.tar.gz")
else:
    source, = pathlib.Path(sys.argv[3]).glob("restrip-*.whl")
    assert "-py3-none-" in source.name and not source.name.endswith("-any.whl"), source
    if importlib.util.find_spec("auditwheel"):
        said = run(sys.executable, "-m", "auditwheel", "show", source)
        assert "manylinux_" in said, said
    else:
        print("without auditwheel: the manylinux tag of the wheel is not tested")
run(python, "-m", "pip", "install", "--no-index", "--no-deps", "--no-build-isolation", "--disable-pip-version-check", source)
assert sorted(package.rglob("*")) == before and not list(package.rglob("*.egg-info")), set(package.rglob("*")) ^ set(before)
where = run(python, "-c", "import restrip; print(restrip.__file__)")
metadata = run(python, "-c", "import importlib.metadata as m; d = m.metadata('restrip'); print(d['Author'], d['License'], d['Keywords'], d.get_all('Classifier'), d.get_all('Project-URL'))")
for word in ("restrip authors", "MIT", "triangle strips", "Typing :: Typed", "https://"):
    assert word in metadata, (word, metadata)
wheel = run(python, "-c", "import importlib.metadata as m; print(m.distribution('restrip').read_text('WHEEL'))")
assert "Root-Is-Purelib: false" in wheel, wheel
assert str(scratch / "venv") in where, where
run(python, "-B", here / "package_test.py")
found = run(python, "-B", package / "example.py")
assert re.fullmatch(EXAMPLE, found), found
readme = re.search(r"```python\n(.*?)```", (package / "README.md").read_text(), re.S)[1]
found = run(python, "-B", "-c", readme)
assert re.fullmatch(r"\[[\d\s]+\]\n", found), found
