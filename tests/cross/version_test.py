"""Version and date of the release have one source, CMakeLists.txt: every file that names them names these. Build files, packages and
programs derive them; the files listed here cannot, so they are compared. No document names a tag: the repository may lack it."""
import re
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
SHORT = [  # file, pattern of MAJOR.MINOR
    ("tests/cross/consumer/CMakeLists.txt", r"find_package\(restrip ([0-9.]+) "),
    ("tests/cross/toolkit/CMakeLists.txt", r"find_package\(restrip ([0-9.]+) "),
    ("docs/how-to/cmake.md", r"find_package\(restrip ([0-9.]+) "),
]
DERIVED = {  # file, what stands there instead of a version
    "bindings/js/package.json": '"version": "@PROJECT_VERSION@"',
    "bindings/python/setup.py": "version=VERSION",
    "cmake/restrip.pc.in": "Version: @PROJECT_VERSION@",
    "cmake/restrip-c.pc.in": "Version: @PROJECT_VERSION@",
}


def faults(text_of):
    """Sentences about files that name another version, or none. `text_of` returns the text of a file."""
    version = re.search(SOURCE[1], text_of(SOURCE[0]))[1]
    short = ".".join(version.split(".")[:2])
    date = re.search(DATE_SOURCE[1], text_of(DATE_SOURCE[0]))[1]
    wrong = []
    for files, wanted in ((WHOLE, version), (SHORT, short), (DATES, date)):
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

    def test_a_file_with_another_version(self):
        for file in {file for file, _ in WHOLE + SHORT + DATES} | set(DERIVED):
            altered = lambda name, file=file: re.sub(r"\d+\.\d+|\d+-\d+-\d+|@PROJECT_VERSION@|VERSION", "0.0", text_of(name)) if name == file else text_of(name)
            self.assertTrue(any(line.startswith(f"{file}: ") for line in faults(altered)), file)


unittest.main()
