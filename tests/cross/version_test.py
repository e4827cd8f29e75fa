"""Version, date, authors and repository of a release have one source, CMakeLists.txt: every file that names them names these. Build
files, packages and programs derive them; the files listed here cannot, so they are compared. No document names a tag: the repository
may lack it. The npm package has links to a repository exactly when CMakeLists.txt names one."""
import json
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCE = "CMakeLists.txt", r"project\(restrip VERSION ([0-9.]+)"
WHOLE = [  # file, pattern of the whole version
    ("CITATION.cff", r"^version: ([0-9.]+)$"),
    ("CHANGELOG.md", r"\A# Changes\n\n## ([0-9.]+)"),
    ("bindings/c/include/restrip.h", r'Version of restrip, such as "([0-9.]+)"'),
]
DATE_SOURCE = "CMakeLists.txt", r"set\(RESTRIP_RELEASE_DATE ([0-9-]+)\)"
DATES = [
    ("CITATION.cff", r"^date-released: ([0-9-]+)$"),
    ("CHANGELOG.md", r"\A# Changes\n\n## [0-9.]+, ([0-9-]+)$"),
]
AUTHORS_SOURCE = "CMakeLists.txt", r'set\(RESTRIP_AUTHORS "(.+)"\)'
AUTHORS = [("CITATION.cff", r"- name: (.+)$"), ("LICENSE", r"^Copyright \(c\) \d+ (.+)$"), ("bindings/python/setup.py", r'author="(.+?)"')]
SHORT = [  # file, pattern of MAJOR.MINOR
    ("tests/cross/consumer/CMakeLists.txt", r"find_package\(restrip ([0-9.]+) "),
    ("tests/cross/toolkit/CMakeLists.txt", r"find_package\(restrip ([0-9.]+) "),
    ("docs/how-to/cmake.md", r"find_package\(restrip ([0-9.]+) "),
]
DERIVED = {  # file, what stands there instead of a version
    "bindings/js/package.json": '"version": "@PROJECT_VERSION@"',
    "bindings/python/setup.py": "version=VERSION",
    "cmake/Packages.cmake": 'CPACK_PACKAGE_CONTACT "${RESTRIP_AUTHORS}"',
    "cmake/restrip.pc.in": "Version: @PROJECT_VERSION@",
    "cmake/restrip-c.pc.in": "Version: @PROJECT_VERSION@",
}


def faults(text_of):
    """Sentences about files that name another version, or none. `text_of` returns the text of a file."""
    version = re.search(SOURCE[1], text_of(SOURCE[0]))[1]
    short = ".".join(version.split(".")[:2])
    date = re.search(DATE_SOURCE[1], text_of(DATE_SOURCE[0]))[1]
    authors = re.search(AUTHORS_SOURCE[1], text_of(AUTHORS_SOURCE[0]))[1]
    wrong = []
    for files, wanted in ((WHOLE, version), (SHORT, short), (DATES, date), (AUTHORS, authors)):
        for file, pattern in files:
            found = re.findall(pattern, text_of(file), re.M)
            if not found or set(found) != {wanted}:
                wrong.append(f"{file}: names {', '.join(found) or '(none)'}, CMakeLists.txt has {wanted}")
    return wrong + [f"{file}: does not contain {words}" for file, words in DERIVED.items() if words not in text_of(file)]


def text_of(file):
    return (ROOT / file).read_text(encoding="utf-8")


class Version(unittest.TestCase):
    def test_the_tree(self):
        self.assertEqual(faults(text_of), [])

    def test_no_document_names_a_tag(self):
        for page in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md"), *(ROOT / "tests/cross/toolkit").rglob("CMakeLists.txt")]:
            self.assertNotRegex(page.read_text(encoding="utf-8"), r"GIT_TAG v?[0-9]", page)

    def package_json(self, repository):
        """As the build writes it."""
        with tempfile.TemporaryDirectory() as folder:
            script, made = Path(folder) / "write.cmake", Path(folder) / "package.json"
            script.write_text(f"cmake_minimum_required(VERSION 3.22)\ninclude({ROOT}/bindings/js/package.cmake)\nrestrip_package_json({made})\n", encoding="utf-8")
            subprocess.run(["cmake", "-DPROJECT_VERSION=1.2.3", "-DRESTRIP_AUTHORS=Some authors", f"-DRESTRIP_REPOSITORY={repository}", "-P", script], check=True)
            return json.loads(made.read_text(encoding="utf-8"))

    def test_links_of_the_npm_package(self):
        address = "https://code.example/someone/restrip"
        links = {"homepage": f"{address}#readme", "repository": {"type": "git", "url": f"git+{address}.git"}, "bugs": {"url": f"{address}/issues"}}
        linked, without = self.package_json(address), self.package_json("")
        self.assertEqual({name: linked[name] for name in links}, links)
        self.assertEqual((linked["version"], linked["author"]), ("1.2.3", "Some authors"))
        self.assertEqual(without, {name: value for name, value in linked.items() if name not in links})

    def test_a_file_with_another_version(self):
        for file in {file for file, _ in WHOLE + SHORT + DATES + AUTHORS} | set(DERIVED):
            altered = lambda name, file=file: re.sub(r"\d+\.\d+|\d+-\d+-\d+|@PROJECT_VERSION@|VERSION|restrip authors|RESTRIP_AUTHORS", "0.0", text_of(name)) if name == file else text_of(name)
            self.assertTrue(any(line.startswith(f"{file}: ") for line in faults(altered)), file)


unittest.main()
