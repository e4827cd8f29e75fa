"""Every claim of docs/explanation/what-is-proven.md and every guarantee of README.md has a row in docs/coverage.csv, every row a check of
scripts/prove.sh, and the table of the page has those rows. scripts/coverage.py reports every deviation, and refuses a
report in which something fails or is missing, or that has a claim that it does not know. Nothing is proved here.

  coverage_test.py BIN: the folder with the programs, whose claims are all known
"""
import importlib.util
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FILES = ["docs/explanation/what-is-proven.md", "docs/coverage.csv", "README.md", "scripts/prove.sh", "verify/formal/Main.v"]
spec = importlib.util.spec_from_file_location("coverage", ROOT / "scripts/coverage.py")
coverage = importlib.util.module_from_spec(spec)
spec.loader.exec_module(coverage)

RUN = """  judged: split: 12, k <= 5
  judged: collapse: 7, k <= 4
accepted: the trace was read to its end; read: a trace
"""


def faults(file=None, alter=None):
    """The faults of the tree, or of a copy in which one file was altered."""
    with tempfile.TemporaryDirectory() as folder:
        for name in FILES:
            (Path(folder) / name).parent.mkdir(parents=True, exist_ok=True)
            text = (ROOT / name).read_text(encoding="utf-8")
            if name == file:
                text, before = alter(text), text
                assert text != before, f"nothing was altered in {name}"
            (Path(folder) / name).write_text(text, encoding="utf-8")
        return coverage.Coverage(Path(folder)).check()


class Examples(unittest.TestCase):
    def test_are_rules_of_the_section_that_the_page_names(self):
        page = (ROOT / FILES[0]).read_text(encoding="utf-8")
        certificate = (ROOT / "tables/certificates/split.cert").read_text(encoding="ascii")
        section = re.search(r"Take `(section [^`]+)`", page)[1]
        rows = re.split(r"^(?=section )", certificate, flags=re.M)
        rows = next(part for part in rows if part.startswith(section + "\n")).splitlines()
        examples = re.findall(r"`(rule [0-9a-f]+ [^`]+)`", page)
        self.assertGreaterEqual(len(examples), 2)
        for example in examples:
            self.assertIn(example, rows)


class Check(unittest.TestCase):
    def test_the_tree(self):
        done = subprocess.run([sys.executable, ROOT / "scripts/coverage.py", "check"], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(faults(), [])

    def test_a_claim_without_a_row(self):
        for claim in coverage.Coverage(ROOT).claims:
            said = faults("docs/coverage.csv", lambda text: "".join(line for line in text.splitlines(True) if not line.startswith(claim + ",")))
            self.assertIn(f"{claim}: a claim without a row in docs/coverage.csv", said)
        said = faults("docs/explanation/what-is-proven.md", lambda text: text.replace("**Whole mesh.**", "**Other mesh.**"))
        self.assertEqual(said, ["Other mesh: a claim without a row in docs/coverage.csv",
                                "Whole mesh: rows of docs/coverage.csv name it, and docs/explanation/what-is-proven.md does not claim it"])

    def test_a_guarantee_that_is_not_a_claim(self):
        self.assertEqual(faults("README.md", lambda text: text.replace("**Bounded.**", "**Cheap.**")),
                         ["Cheap: a guarantee of README.md that docs/explanation/what-is-proven.md does not claim"])

    def test_a_row_without_a_check_and_a_check_without_a_row(self):
        self.assertEqual(faults("scripts/prove.sh", lambda text: text.replace("check reasons ", "check causes ")),
                         ["reasons: not a check of scripts/prove.sh", "causes: a check of scripts/prove.sh without a row"])

    def test_a_theorem_that_is_not_there(self):
        self.assertEqual(faults("verify/formal/Main.v", lambda text: text.replace("Theorem whole_mesh ", "Theorem whole_mash ")),
                         ["whole_mesh: a theorem that is expected, and that verify/formal/Main.v does not have"])

    def test_lists_that_are_not_found(self):
        for file in ("docs/explanation/what-is-proven.md", "README.md"):
            self.assertIn("docs/explanation/what-is-proven.md lists no claims, or README.md no guarantees", faults(file, lambda text: text.replace("**", "")))


class Tables(unittest.TestCase):
    def test_a_table_that_was_altered(self):
        for page in ("docs/explanation/what-is-proven.md",):
            text = (ROOT / page).read_text(encoding="utf-8")
            altered = text.replace("| Coq ", "| by hand ")
            self.assertNotEqual(altered, text)
            with tempfile.TemporaryDirectory() as folder:
                for words, code in ((text, 0), (altered, 1)):
                    (Path(folder) / "page.md").write_text(words, encoding="utf-8")
                    done = subprocess.run([sys.executable, ROOT / "scripts/figures.py", "--check", "--only", "scripts/coverage.py", Path(folder) / "page.md"],
                                          capture_output=True, text=True, check=False)
                    self.assertEqual(done.returncode, code, done.stderr)


class Reports(unittest.TestCase):
    def test_what_a_report_says(self):
        rows = coverage.rows_of("run", RUN)
        self.assertEqual({row.operation for row in rows}, {"split", "collapse"})
        self.assertEqual({(row.k, row.read, row.check) for row in rows}, {("0", "a trace", "run")})

    def test_a_report_that_does_not_hold(self):
        for text, why in (("FAILS  split\n" + RUN, "something fails"), (RUN + "NOT verified\n", "something fails"),
                          (RUN.replace("  judged", "  met"), "no line matches"), ("", "no line matches"), (RUN.replace("read: a trace", "read: nothing"), "were not read")):
            with self.assertRaisesRegex(coverage.Wrong, why):
                coverage.rows_of("run", text)

    def test_an_operation_that_was_not_checked(self):
        """One row stands for all operation files, so each must be in the report."""
        row = coverage.Row("Sound", "", "0", coverage.SEARCH, coverage.CERTIFICATES, "operations")
        names = sorted(path.stem for path in (ROOT / "tables/operations").glob("*.json"))
        rows = [row._replace(operation=name) for name in names]
        self.assertEqual(coverage.of_files(rows), {row._replace(operation="operation files")})
        self.assertEqual({row.operation for row in coverage.of_files(row for row in rows if "matching" not in row.operation)}, {"operation files of strips"})
        with self.assertRaisesRegex(coverage.Wrong, f"operations: Sound: the report lacks {names[0]}"):
            coverage.of_files(rows[1:])

    def test_every_check_has_its_report(self):
        self.assertEqual(set(coverage.REPORTS), set(coverage.Coverage(ROOT).checks))

    def test_a_claim_that_is_not_known(self):
        new = "holds  split           every rule is short                               counted    12     0.00\n"
        with self.assertRaisesRegex(coverage.Wrong, "neither in the coverage nor left out: holds  split +every rule is short"):
            coverage.rows_of("run", RUN + new)

    def test_rows_that_differ(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "run.log").write_text(RUN, encoding="utf-8")
            said = coverage.Coverage(ROOT).compare(Path(folder), ["run"])
        self.assertTrue(said and all(line.startswith("docs/coverage.csv has the row ") and line.endswith(",run, and no report makes it") for line in said), said)
        self.assertFalse(any(",split," in line or ",collapse," in line for line in said), said)

    def test_every_claim_of_the_verifiers_is_known(self):
        """Of an operation, of small tables and of the automaton; scripts/prove.sh refuses any other as well."""
        small, printed = ROOT / "tests/corpus/accept/small", ""
        for check, *words in (("operations", "restrip-verify", "--operation", ROOT / "tables/operations/bisect.json", "--certificate",
                               ROOT / "tables/certificates/operations/bisect.cert", "--header", ROOT / "tables/include/restrip/tables/operations/bisect.hpp"),
                              ("search", "restrip-verify", "--tables-dir", small, "--max-k", "4"),
                              ("automaton", "restrip-verify", "automaton", "--tables-dir", ROOT / "tables", "--max-k", "4")):
            done = subprocess.run([BIN / words[0], *words[1:]], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, coverage.unknown_claims(check, done.stdout)), (0, []), done.stderr)
            printed += done.stdout
        # What is left out exists: in these reports or, of compiled tables, in the sources.
        sources = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "verify").rglob("*.cpp"))
        self.assertEqual([claim for claim in coverage.LEFT_OUT if claim not in printed and f'"{claim}"' not in sources], [])


BIN = Path(sys.argv.pop())
unittest.main()
