"""The version has one source, project() in CMakeLists.txt: every file that names the version of restrip names that one. Build files,
packages and programs derive it; the files listed here cannot, so they are compared."""
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCE = "CMakeLists.txt", r"project\(restrip VERSION ([0-9.]+)"
WHOLE = [  # file, pattern of the whole version
    ("CITATION.cff", r"^version: ([0-9.]+)$"),
    ("CHANGELOG.md", r"\A# Changes\n\n## ([0-9.]+)"),
    ("bindings/c/include/restrip.h", r'Version of restrip, such as "([0-9.]+)"'),
    ("tests/cross/toolkit/subdirectory/CMakeLists.txt", r"GIT_TAG v([0-9.]+)\)"),
    ("docs/how-to/cmake.md", r"GIT_TAG v([0-9.]+)\)"),
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
    wrong = []
    for files, wanted in ((WHOLE, version), (SHORT, short)):
        for file, pattern in files:
            found = re.findall(pattern, text_of(file), re.M)
            if not found or set(found) != {wanted}:
                wrong.append(f"{file}: names version {', '.join(found) or '(none)'}, CMakeLists.txt has {version}")
    return wrong + [f"{file}: does not contain {words}" for file, words in DERIVED.items() if words not in text_of(file)]


def text_of(file):
    return (ROOT / file).read_text(encoding="utf-8")


class Version(unittest.TestCase):
    def test_the_tree(self):
        self.assertEqual(faults(text_of), [])

    def test_a_file_with_another_version(self):
        for file in {file for file, _ in WHOLE + SHORT} | set(DERIVED):
            altered = lambda name, file=file: re.sub(r"\d+\.\d+|@PROJECT_VERSION@|VERSION", "0.0", text_of(name)) if name == file else text_of(name)
            self.assertTrue(any(line.startswith(f"{file}: ") for line in faults(altered)), file)


unittest.main()
