"""Version, date, authors and addresses of a release have one source, cmake/project.cmake: every file that names them names these.
Build files, packages and programs derive them; the files listed here cannot, so they are compared. No document names a tag: the
repository may lack it. The npm package and CITATION.cff have links to a repository exactly when the source names one.

A clone with core.autocrlf=true, Git for Windows' default, has the bytes of the repository: .gitattributes asks for LF in every text
file, so tables verify and scripts run."""
import json
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCE = "cmake/project.cmake"
COMPARED = [  # value of the source, file, pattern of what it names
    ("VERSION", "CITATION.cff", r"^version: ([0-9.]+)$"),
    ("VERSION", "CHANGELOG.md", r"\A# Changes\n\n## ([0-9.]+)"),
    ("VERSION", "bindings/c/include/restrip.h", r'Version of restrip, such as "([0-9.]+)"'),
    ("RELEASE_DATE", "CITATION.cff", r"^date-released: ([0-9-]+)$"),
    ("RELEASE_DATE", "CHANGELOG.md", r"\A# Changes\n\n## [0-9.]+, ([0-9-]+)$"),
    ("AUTHORS", "CITATION.cff", r"- name: (.+)$"),
    ("AUTHORS", "LICENSE", r"^Copyright \(c\) \d+ (.+)$"),
    ("REPOSITORY", "CITATION.cff", r"^repository-code: (.*)$"),
    ("SHORT", "tests/cross/consumer/CMakeLists.txt", r"find_package\(restrip ([0-9.]+) "),
    ("SHORT", "tests/cross/toolkit/CMakeLists.txt", r"find_package\(restrip ([0-9.]+) "),
    ("SHORT", "docs/how-to/cmake.md", r"find_package\(restrip ([0-9.]+) "),
]
DERIVED = {  # file, what stands there instead of a value
    "bindings/js/package.json": '"version": "@RESTRIP_VERSION@"',
    "bindings/python/setup.py": 'VERSION = PROJECT["VERSION"]',
    "cmake/Packages.cmake": 'CPACK_PACKAGE_CONTACT "${RESTRIP_AUTHORS}',
    "cmake/restrip.pc.in": "Version: @PROJECT_VERSION@",
    "cmake/restrip-c.pc.in": "Version: @PROJECT_VERSION@",
}


def project(text_of):
    """The values of the source, and MAJOR.MINOR as SHORT."""
    values = dict(re.findall(r'^set\(RESTRIP_(\w+) "?(.*?)"?\)', text_of(SOURCE), re.M))
    return {**values, "SHORT": ".".join(values["VERSION"].split(".")[:2])}


def faults(text_of):
    """Sentences about files that name another value, or none. `text_of` returns the text of a file."""
    values = project(text_of)
    wrong = []
    for key, file, pattern in COMPARED:
        found = set(re.findall(pattern, text_of(file), re.M))
        if found != ({values[key]} if values[key] else set()):
            wrong.append(f"{file}: names {', '.join(found) or '(none)'}, {SOURCE} has {values[key] or '(none)'}")
    return wrong + [f"{file}: does not contain {words}" for file, words in DERIVED.items() if words not in text_of(file)]


def text_of(file):
    return (ROOT / file).read_text(encoding="utf-8")


class Version(unittest.TestCase):
    def test_the_tree(self):
        self.assertEqual(faults(text_of), [])

    def test_no_document_names_a_tag(self):
        for page in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md"), *(ROOT / "tests/cross/toolkit").rglob("CMakeLists.txt")]:
            self.assertNotRegex(page.read_text(encoding="utf-8"), r"GIT_TAG v?[0-9]", page)

    def package_json(self, **addresses):
        """As the build writes it."""
        with tempfile.TemporaryDirectory() as folder:
            script, made = Path(folder) / "write.cmake", Path(folder) / "package.json"
            script.write_text(f"cmake_minimum_required(VERSION 3.22)\ninclude({ROOT}/bindings/js/package.cmake)\nrestrip_package_json({made})\n", encoding="utf-8")
            defined = {"VERSION": "1.2.3", "AUTHORS": "Some authors", "DESCRIPTION": "Text", "REPOSITORY": "", "HOMEPAGE": "", "ISSUES": "", **addresses}
            subprocess.run(["cmake", *(f"-DRESTRIP_{name}={value}" for name, value in defined.items()), "-P", script], check=True)
            return json.loads(made.read_text(encoding="utf-8"))

    def test_links_of_the_npm_package(self):
        address = "https://code.example/someone/restrip"
        links = {"homepage": "https://restrip.example", "repository": {"type": "git", "url": f"git+{address}.git"}, "bugs": {"url": f"{address}/issues"}}
        linked = self.package_json(REPOSITORY=address, HOMEPAGE="https://restrip.example", ISSUES=f"{address}/issues")
        without = self.package_json()
        self.assertEqual({name: linked[name] for name in links}, links)
        self.assertEqual((linked["version"], linked["author"]), ("1.2.3", "Some authors"))
        self.assertEqual(without, {name: value for name, value in linked.items() if name not in links})
        self.assertEqual(self.package_json(ISSUES=f"{address}/issues"), {**without, "bugs": links["bugs"]})

    def test_a_file_with_another_value(self):
        wrong = r"\d+\.\d+|\d+-\d+-\d+|@(?:PROJECT|RESTRIP)_VERSION@|\"VERSION\"|restrip authors|RESTRIP_AUTHORS"
        for file in {file for _, file, _ in COMPARED} | set(DERIVED):
            altered = lambda name, file=file: re.sub(wrong, "0.0", text_of(name)) if name == file else text_of(name)
            self.assertTrue(any(line.startswith(f"{file}: ") for line in faults(altered)), file)

    def test_a_citation_without_the_repository(self):
        named = lambda name: re.sub('REPOSITORY ".*?"', 'REPOSITORY "https://code.example/restrip"', text_of(name))
        self.assertTrue(any(line.startswith("CITATION.cff: ") for line in faults(named)))


def git(folder, *arguments):
    return subprocess.run(["git", "-C", folder, "-c", "safe.directory=*", *arguments], check=True, capture_output=True).stdout


class LineEnds(unittest.TestCase):
    def setUp(self):
        if not (ROOT / ".git").exists():
            self.skipTest("left out: this is not a checkout of git")

    def test_a_checkout_with_carriage_returns(self):
        with tempfile.TemporaryDirectory() as folder:
            # The index of the working tree, uncommitted files included, as a separate repository.
            git(folder, "init", "-q", ".")
            listed = git(ROOT, "ls-files", "-z", "-co", "--exclude-standard").decode().rstrip("\0").split("\0")
            kept = [name for name in listed if (ROOT / name).is_file()]
            for name in kept:
                copy = Path(folder) / name
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_bytes((ROOT / name).read_bytes())
            git(folder, "-c", "core.autocrlf=false", "add", "-A")
            git(folder, "-c", "user.name=test", "-c", "user.email=test", "commit", "-qm", "all")
            clone = folder + "/clone"
            git(folder, "-c", "core.autocrlf=true", "clone", "-q", "-c", "core.autocrlf=true", folder, clone)
            self.assertGreater(len(kept), 500)
            changed = [name for name in kept if (Path(clone) / name).read_bytes() != (ROOT / name).read_bytes()]
            self.assertEqual(changed, [])


unittest.main()
