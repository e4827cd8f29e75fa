"""References in documents and comments exist: every file whose path is named, every relative link with its anchor, every heading
that is quoted after the name of a page, every section that is cited by its number. Blocks of code in documents are not read.
Also a claim about scripts/words.py: it finds the words that this project drops, and leaves others alone."""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SLASHES = {".hpp", ".cpp", ".h", ".c", ".in", ".comp", ".rs", ".glsl", ".wgsl", ".js", ".mjs", ".ts"}
HASHES = {".py", ".sh", ".cmake", ".txt", ".yml"}

PATH = re.compile(r"(?<![\w/.<>*$}:~-])(?:[\w.-]+/)*[\w-][\w-]*(?:\.[\w-]+)*\.(?:md|hpp|cpp|h|py|sh|cmake|mjs|ts|v|cert|svg)(?![\w/*(]|\.\w)")
PAGE = r"(?<![\w/-])([\w./-]+\.md)(?:\]\([^)]*\))?[`)]*,?\s+"
TITLE = re.compile(PAGE + r'"([^"]{1,120})"')
SECTIONS = re.compile(PAGE + r"sections?\s+(\d+(?:(?:,| and)\s+\d+)*)")
HERE = re.compile(r'"([^"]{1,120})"\s+(?:above|below)')
LINK = re.compile(r"(?<!`)\[[^\]`]*(?:`[^`]*`[^\]`]*)*\]\(([^)\s]+)\)")

# Named and not in the tree: patterns (NAME.cpp, x.hpp), what a build or an installation makes, files of the reader's own.
ELSEWHERE = re.compile(r"(?:.*[/_])?(?:NAME|FAMILY|TEST|DIR)(?:[/_.].*)?|x\.\w+|(?:main|use|print-[a-z-]+)\.cpp|restrip_(?:(?:automaton|tables)(?:_check)?|rule_of_bisect|check_of_bisect)\.\w+"
                       r"|(?:sheet|level|terrain)\.svg|play\.cpp|AutomatonNumbers\.v|(?:faults|fault_names)\.hpp|share/restrip/restrip\.hpp|rules/(?:include|certificates)/.*")
# Names files as they were called then.
HISTORY = "CHANGELOG.md"


def tree_of(root):
    """All files except builds and version control."""
    skipped = re.compile(r"build.*|\..+|__pycache__|node_modules")
    folders = [root]
    while folders:
        for entry in sorted(folders.pop().iterdir()):
            if entry.is_file():
                yield entry
            elif not skipped.fullmatch(entry.name):
                folders.append(entry)


def prose_of(file):
    """The lines of a document or the comments of a source, each in its line; None of other files."""
    if file.suffix not in SLASHES | HASHES | {".md", ".v"}:
        return None
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".md":
        return re.sub(r"^ *```.*?^ *```$", lambda block: "\n" * block[0].count("\n"), text, flags=re.M | re.S)
    if file.suffix == ".v":
        return "".join(re.findall(r"\(\*.*?\*\)|\n", text, flags=re.S))
    mark = r"(?<![:\"'])//+[<!]?|^ */?\*+" if file.suffix in SLASHES else r"#+"
    kept = []
    quoted = False  # inside a string of several lines, which in Python is a manual
    for line in text.split("\n"):
        begins = re.search(mark, line)
        kept.append(line if quoted else line[begins.end():].rstrip("*/") if begins else "")
        if file.suffix == ".py" and '"""' in line:
            kept[-1] = line
            quoted ^= line.count('"""') % 2 == 1
    return "\n".join(kept)


def words(text):
    return " ".join(re.sub(r"[`*]", "", text).split())


class Page:
    """The headings of a document, and the first words that it sets off: "**Families.** Each …"."""

    def __init__(self, file):
        text = prose_of(file)
        headings = re.findall(r"^#+ (.*)$", text, flags=re.M)
        set_off = re.findall(r"^(?:- |\d+\. )?(\*{1,2})(?!\s)(.+?)\1", text, flags=re.M | re.S)
        self.titles = {words(title).rstrip(".:") for title in headings + [first for _, first in set_off]}
        self.anchors = {self.anchor(heading) for heading in headings}

    @staticmethod
    def anchor(heading):
        """As GitHub makes it."""
        heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")

    def has(self, title):
        """Without its number and without what explains it: "Oaks" is "1. Oaks: the large ones"."""
        named = {re.sub(r"^\d+\. ", "", mine) for mine in self.titles}
        return any(words(title) in (mine, mine.split(":")[0]) for mine in self.titles | named)

    def has_section(self, number):
        return any(title.startswith(number + ". ") for title in self.titles)


class References:
    def __init__(self, root):
        self.root = root
        self.files = [file.relative_to(root) for file in tree_of(root)]
        self.ends = {"/".join(file.parts[i:]) for file in self.files for i in range(len(file.parts))}
        self.pages = {}
        self.checked = 0
        self.faults = []

    def page(self, name, at):
        """The document of this name, next to the file `at` or anywhere; None if it does not exist."""
        for file in (at.parent / name, self.root / name, self.root / "docs" / name):
            if file.is_file():
                return self.pages.setdefault(file.resolve(), Page(file))
        return None

    def judge(self, at, text, found, right, what):
        self.checked += 1
        if not right:
            line = text.count("\n", 0, found.start()) + 1
            self.faults.append(f"{at.relative_to(self.root)}:{line}: {what}")

    def check(self):
        for file in self.files:
            at = self.root / file
            text = prose_of(at)
            if text is None or at == Path(__file__).resolve():
                continue
            if file.suffix == ".md":
                self.check_links(at, text)
                text = LINK.sub(lambda link: re.sub(r"\S", " ", link[0]) if "://" in link[1] else link[0], text)
                text = re.sub(r"https?://\S+", "", text)
            self.check_text(at, text)
        return self

    def check_links(self, at, text):
        for found in LINK.finditer(text):
            target = found[1]
            if "://" in target or target.startswith("mailto:"):
                continue
            name, _, anchor = target.partition("#")
            to = at if not name else at.parent / name
            self.judge(at, text, found, to.exists(), f"the link {target} leads nowhere")
            if anchor and to.is_file():
                anchors = self.pages.setdefault(to.resolve(), Page(to)).anchors
                self.judge(at, text, found, anchor in anchors, f"{target}: no heading has this anchor")

    def check_text(self, at, text):
        for found in PATH.finditer(text) if at.name != HISTORY else []:
            name = found[0]
            there = (at.parent / name).exists() or name.lstrip("./") in self.ends or ELSEWHERE.fullmatch(name)
            self.judge(at, text, found, there, f"{name} does not exist")
        for found in TITLE.finditer(text):
            page = self.page(found[1], at)
            if page:
                self.judge(at, text, found, page.has(found[2]), f'{found[1]} has no heading "{words(found[2])}"')
        for found in SECTIONS.finditer(text):
            page = self.page(found[1], at)
            for number in re.findall(r"\d+", found[2]) if page else []:
                self.judge(at, text, found, page.has_section(number), f"{found[1]} has no section {number}")
        if at.suffix == ".md":
            for found in HERE.finditer(text):
                self.judge(at, text, found, self.page(at.name, at).has(found[1]), f'this page has no heading "{words(found[1])}"')


def faults_of(files):
    """What is wrong with a tree of these files, each given by its path and text."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            file = Path(folder) / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return References(Path(folder)).check().faults


PAGE_OF_TREES = "# Trees\nText.\n\n## 1. Oaks: the large ones\n*Leaves.* They fall.\n\n## `elm` and ash\nText.\n"


class Rejects(unittest.TestCase):
    def refused(self, name, text, *said):
        """The tree with a page of trees and this file has these faults, and none without the file."""
        files = {"docs/trees.md": PAGE_OF_TREES, "src/axe.hpp": "// Cuts.\n"}
        self.assertEqual(faults_of(files), [])
        self.assertEqual(faults_of({**files, name: text}), [f"{name}:{line}" for line in said])

    def test_what_exists_is_not_reported(self):
        self.refused("src/saw.hpp", '// As axe.hpp does (docs/trees.md, "Oaks", "Leaves"; docs/trees.md section 1).\n'
                                    "// See https://example.org/no.md and *.hpp.\n")
        self.refused("README.md", '[ash](docs/trees.md#elm-and-ash), [an axe](src/axe.hpp), [trees](docs)\n'
                                  '```\n[no](no.md)\n```\n"Saws" below.\n\n## Saws\n')

    def test_files(self):
        self.refused("src/saw.hpp", "// Text.\n#include \"no.hpp\"\n// As no.hpp does.\n", "3: no.hpp does not exist")
        self.refused("src/saw.py", '"""A saw (docs/bushes.md)."""\n', "1: docs/bushes.md does not exist")
        self.refused("src/saw.c", "/* A saw\n * (src/no/axe.hpp). */\n", "2: src/no/axe.hpp does not exist")
        self.refused("src/saw.cpp", "int x;  ///< see bushes.md\n", "1: bushes.md does not exist")

    def test_headings(self):
        self.refused("src/saw.hpp", '// Cuts oaks (docs/trees.md, "The large\n// ones").\n',
                     '1: docs/trees.md has no heading "The large ones"')
        self.refused("docs/saws.md", '[trees.md](trees.md), "Pines"\n', '1: trees.md has no heading "Pines"')
        self.refused("docs/saws.md", '"Blades" above.\n', '1: this page has no heading "Blades"')

    def test_sections(self):
        self.refused("src/saw.hpp", "// Cuts (docs/trees.md, sections 1 and 2).\n", "1: docs/trees.md has no section 2")

    def test_links(self):
        self.refused("README.md", "A [saw](src/saw.hpp).\n", "1: the link src/saw.hpp leads nowhere", "1: src/saw.hpp does not exist")
        self.refused("README.md", "[oaks](docs/trees.md#oaks)\n", "1: docs/trees.md#oaks: no heading has this anchor")


class Words(unittest.TestCase):
    def test_dropped_words(self):
        sys.path.insert(0, str(ROOT / "scripts"))
        from words import dropped
        for line in ("all strips anew", "what it is told", "the rules and those of a flip", "'nan' is no number", "Somebody may call it",
                     "as many indices", "one ladder of checks", "a place beside it"):
            self.assertEqual(len(dropped(line)), 1, line)
        for line in ("as many as before", "it is no longer used", "retold", "besides", "of course", "A newer table", "tell()"):
            self.assertEqual(dropped(line), [], line)


class OfTheProject(unittest.TestCase):
    cmake = None  # and a folder where the project is built

    def test_all_exist(self):
        project = References(ROOT).check()
        self.assertGreater(project.checked, 500)
        self.assertEqual("\n".join(project.faults), "")

    def test_links_of_installed_documents(self):
        if not self.cmake:
            self.skipTest("give CMake and a folder where the project is built")
        cmake, build = self.cmake
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run([cmake, "--install", build, "--prefix", prefix, "--component", "runtime"], check=True, capture_output=True)
            installed = References(Path(prefix))
            pages = [file for file in Path(prefix).rglob("*.md")]
            for page in pages:
                installed.check_links(page, prose_of(page))
            self.assertGreater(len(pages), 5)
            self.assertGreater(installed.checked, 100)
            self.assertIn("include/restrip/", "".join(page.read_text(encoding="utf-8") for page in pages))
            self.assertEqual("\n".join(installed.faults), "")


if __name__ == "__main__":
    if len(sys.argv) > 2:
        OfTheProject.cmake = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main()
