"""The automaton of all valences in another language gives the same answers as exact.hpp. It compares digests of the answers, a
line for each position, printed by the programs that the generator writes with it: of all keys up to k = 8, and of random keys
beyond. Numbers altered one at a time must change them. The example of docs/how-to/other-languages.md is run and prints the
output shown there.

  automaton_test.py LANGUAGE --dump PROGRAM --automata FOLDER --scratch FOLDER --with PROGRAM…

--dump is restrip-dump-tables.
"""
import shutil

from language_test import LANGUAGES, Json, arguments, check_example, compare, must_be_equal, run

LARGEST = {"c": 61, "rust": 61, "json": 20, "glsl": 28, "wgsl": 28}
# The operations that read an array. If its first number is altered, some of their answers must differ, and no others.
ARRAYS = {"next": "01234", "meetings": "02"}
OPENINGS = {"c": r"restrip_{family}\[\d+\] = ", "rust": r"const {FAMILY}: .* = &", "json": r'"{family}": \['}
ALTERED_K = 4


class JavaScript(Json):
    """The reader of the data in JSON."""
    block = "js"

    def example(self, text, folder, scratch):
        return run(self.node, "--input-type=module", "-e", text, cwd=folder)

    def more(self, folder, scratch):
        self.as_schema_says(folder, "docs/automaton.schema.json")


def expected(dump, max_k):
    """Of the C++ look-up, in the order in which the other programs print them."""
    *lines, end = run(dump, "--automaton", "--digests", "--max-k", max_k).splitlines(True)
    return "".join(sorted(lines, key=lambda line: [int(word) for word in line.split()[:4]])) + end


def main():
    given = arguments(__doc__, "dump", "automata")
    language = (JavaScript if given.language == "json" else LANGUAGES[given.language])(*given.programs)
    language.stem, language.families, language.rules = "restrip_automaton", tuple(ARRAYS), OPENINGS.get(given.language)
    language.expected = lambda max_k: expected(given.dump, max_k)
    largest = LARGEST[given.language]
    shutil.copytree(given.automata, given.scratch / "altered", dirs_exist_ok=True)
    answers = language.answers(given.automata, given.scratch, largest)
    must_be_equal(language.file, answers, language.expected(largest))
    noticed = language.altered_answers(given.automata, given.scratch)
    for array, others in noticed.items():
        differ = compare("altered", others, language.expected(ALTERED_K))
        if not differ or not set(differ) <= set(ARRAYS[array]):
            raise SystemExit(f"a number of {array} was altered, and operations {differ} differ instead of {ARRAYS[array]}")
    if noticed.keys() != ARRAYS.keys():
        raise SystemExit(f"{list(noticed)} were altered, not {list(ARRAYS)}")
    print(f"{language.file}: {len(answers.splitlines())} digests agree, {len(noticed)} altered numbers were noticed")
    check_example(language, "## Fans of any size", given.automata, given.scratch)
    language.more(given.automata, given.scratch)


if __name__ == "__main__":
    main()
