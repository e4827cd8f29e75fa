"""Claims about scripts/setup.sh, on made-up releases (programs in the place of apt-get, apt-cache and dpkg-query): it takes the
name that the release has for a package, the newest Clang that is complete, or a complete one that is installed; it leaves out what
the release does not have, in one line; and it asks for nothing twice. No script and no build file names a version of Clang."""
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = {
    "dpkg-query": 'shift 2; for name; do grep -qxF "$name" installed && echo "installed $name"; done; true',
    "apt-cache": """case $1 in
      pkgnames) cat offered installed | grep "^$2" || true ;;
      policy) shift; for name; do if grep -qxF "$name" offered; then printf '%s:\\n  Candidate: 1\\n' "$name"; fi; done ;;
    esac""",
    "apt-get": """echo "$*" >>asked
    case "$*" in *install*) for name; do case $name in -* | install | DPkg*) ;; *) echo "$name" >>installed ;; esac; done ;; esac""",
    "sudo": 'exec "$@"',
}


def clang(version, *without):
    return [name for name in (f"clang-{version}", f"lld-{version}", f"libclang-rt-{version}-dev", f"libclang-rt-{version}-dev-wasm32",
                              f"libc++-{version}-dev-wasm32") if name not in without]


class Release:
    def __init__(self, folder, offered, installed=()):
        self.folder = Path(folder)
        (self.folder / "bin").mkdir()
        for name, text in PROGRAMS.items():
            (self.folder / "bin" / name).write_text(f"#!/bin/sh\ncd '{folder}'\n{text}\n")
            (self.folder / "bin" / name).chmod(0o755)
        self.write("offered", offered)
        self.write("installed", installed)
        self.write("asked", [])

    def write(self, name, lines):
        (self.folder / name).write_text("".join(line + "\n" for line in lines))

    def lines(self, name):
        return (self.folder / name).read_text().split("\n")[:-1]

    def run(self, commands):
        done = subprocess.run(["bash", "-Eeuo", "pipefail", "-c", f"source scripts/setup.sh; {commands}; echo \"Clang: ${{RESTRIP_CLANG:-}}\""],
                              cwd=ROOT, capture_output=True, text=True, check=False,
                              env={**os.environ, "RESTRIP_CLANG": "", "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"})
        return done.returncode, done.stdout + done.stderr


class Setup(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)

    def release(self, *packages, installed=()):
        return Release(self.scratch.name, packages, installed)

    def test_the_name_that_the_release_has(self):
        release = self.release("g++", "second")
        self.assertEqual(release.run('need g++ "first|second"')[0], 0)
        self.assertEqual(release.lines("installed"), ["g++", "second"])

    def test_either_name_that_is_installed_will_do(self):
        release = self.release("first", "second", installed=["second"])
        self.assertEqual(release.run('need "first|second"')[0], 0)
        self.assertEqual(release.lines("asked"), [])

    def test_what_the_release_lacks_is_left_out_in_a_line(self):
        release = self.release("g++")
        code, said = release.run('need g++ browser "first|second"; printf "again: %s\\n" "${left_out[@]}"')
        self.assertEqual(code, 0, said)
        for what in ("browser", "first or second"):
            self.assertEqual(re.findall(f"(?m)^(.*)left out: package {what}: this release does not have it$", said), ["", "again: "])
        self.assertEqual(release.lines("installed"), ["g++"])

    def test_the_newest_complete_clang(self):
        release = self.release("wasi-libc", *clang(9), *clang(22), *clang(21), *clang(23, "libc++-23-dev-wasm32"))
        code, said = release.run("need_clang")
        self.assertEqual((code, said.split("\n")[-2]), (0, "Clang: clang++-22"), said)
        self.assertEqual(release.lines("installed"), clang(22) + ["wasi-libc"])
        asked = release.lines("asked")
        self.assertEqual((release.run("need_clang")[0], release.lines("asked")), (0, asked))

    def test_a_complete_clang_that_is_installed(self):
        release = self.release("wasi-libc", *clang(22), installed=clang(14) + ["wasi-libc", "clang-15"])
        self.assertIn("Clang: clang++-14\n", release.run("need_clang")[1])
        self.assertEqual(release.lines("asked"), [])

    def test_an_incomplete_clang_is_better_than_none(self):
        release = self.release("wasi-libc", *clang(15, "lld-15"))
        code, said = release.run("need_clang")
        self.assertEqual(code, 0, said)
        self.assertIn("left out: package lld-15: this release does not have it\n", said)
        self.assertIn("Clang: clang++-15\n", said)

    def test_without_clang(self):
        code, said = self.release("wasi-libc").run("need_clang")
        self.assertEqual(code, 0, said)
        self.assertIn("left out: Clang: this release does not have it\n", said)


class Versions(unittest.TestCase):
    def test_none_is_named(self):
        named = re.compile(r"(?:clang(?:\+\+|-tidy|-format|-rt)?|lld|libc\+\+)-\d+")
        folders = [ROOT / folder for folder in ("scripts", "cmake", "tests", "web", "bench", ".ci")]
        files = [ROOT / "CMakePresets.json", ROOT / "CMakeLists.txt", *(file for folder in folders for file in folder.rglob("*"))]
        files = [file for file in files if file.suffix in {".sh", ".py", ".cmake", ".txt", ".json", ".mjs", ""} and file.is_file()
                 and "recorded" not in file.parts and file != Path(__file__).resolve()]
        self.assertGreater(len(files), 50)
        for file in files:
            self.assertEqual(named.findall(file.read_text(encoding="utf-8", errors="replace")), [], file)


if __name__ == "__main__":
    unittest.main()
