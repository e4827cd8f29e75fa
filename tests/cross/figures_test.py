"""Every table of the documents that has figures names the command that prints it, and scripts/figures.py notices it where one
does not, where a command is not there, and where a figure was altered."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "figures.py"
TABLE = "| what | how many |\n| --- | --- |\n| files | 7 |\n"
PRINTS_IT = "printf '| what | how many |\\n| --- | --- |\\n| files | 7 |\\n'"


def figures(text, *arguments):
    """What figures.py says about a document of this text, and the document afterwards."""
    with tempfile.TemporaryDirectory() as folder:
        document = Path(folder) / "document.md"
        document.write_text(text)
        done = subprocess.run([sys.executable, SCRIPT, *arguments, document], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr, document.read_text()


def marked(command, table=TABLE, kind=""):
    return f"Text.\n\n<!-- {kind}figures: {command} -->\n{table}<!-- /figures -->\n"


class Figures(unittest.TestCase):
    def test_a_table_without_a_command_is_listed_with_its_line(self):
        code, said, _ = figures("Text.\n\n" + TABLE, "--bare")
        self.assertEqual(code, 1)
        self.assertIn("document.md:3: no command: | what | how many |", said)

    def test_tables_of_words_and_marked_tables_are_not_listed(self):
        self.assertEqual(figures(marked(PRINTS_IT) + TABLE.replace("7", "seven"), "--bare")[0], 0)

    def test_a_command_that_does_not_exist_is_listed(self):
        code, said, _ = figures(marked("scripts/no_such_script.py", kind="timed "), "--bare")
        self.assertEqual(code, 1)
        self.assertIn("no_such_script.py is not there", said)

    def test_the_page_of_one_command_needs_no_other(self):
        self.assertEqual(figures("<!-- page: scripts/performance.sh -->\n" + TABLE, "--bare")[0], 0)
        self.assertEqual(figures("<!-- page: scripts/no_such_script.sh -->\n" + TABLE, "--bare")[0], 1)

    def test_an_altered_figure_is_noticed_and_mended(self):
        altered = marked(PRINTS_IT, TABLE.replace("7", "8"))
        code, said, after = figures(altered, "--check")
        self.assertEqual((code, after), (1, altered))
        self.assertIn("differs", said)
        self.assertEqual(figures(altered)[2], marked(PRINTS_IT))
        self.assertEqual(figures(marked(PRINTS_IT), "--check")[0], 0)

    def test_a_check_that_compared_nothing_fails(self):
        for kind in ("timed ", "long "):
            self.assertEqual(figures(marked(PRINTS_IT, kind=kind), "--check")[0], 1)

    def test_a_command_that_fails_in_any_part_is_an_error_and_the_table_stays(self):
        for command, why in {"exit 3": "ended with 3", "false; echo": "ended with 1", "false | cat": "ended with 1",
                             "build/release/bin/no_such_program; echo": "is not there"}.items():
            for arguments in ((), ("--check",)):
                code, said, after = figures(marked(command), "--bin", "/no_such_folder", *arguments)
                self.assertEqual((code, after), (1, marked(command)))
                self.assertIn(f"{why}: {command}", said)
                self.assertNotIn("Traceback", said)

    def test_a_document_that_cannot_be_read_is_named(self):
        done = subprocess.run([sys.executable, SCRIPT, "/no_such_folder/a.md"], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1))
        self.assertIn("a.md", done.stderr)


if __name__ == "__main__":
    unittest.main()
