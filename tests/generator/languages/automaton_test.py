"""The automaton of all valences in another language answers as exact.hpp does, that of the shipped cost and one that tells
turns apart. Digests of the answers are compared, a line for each position, which the programs print that the generator writes
beside it: of all keys up to k = 8, or 4 where turns are told, beyond which keys are drawn. That a wrong number shows is tested
with one altered at a time. The example of docs/languages.md is run and prints what stands there.

  automaton_test.py LANGUAGE --dump PROGRAM --other-dump PROGRAM --automata FOLDER --scratch FOLDER --with PROGRAM…

--dump is restrip-dump-tables, --other-dump the same of the automaton of cost 1,1,0.
"""
import re

from language_test import ROOT, LANGUAGES, Shader, altered_number, arguments, compare, example_of, must_be_equal, run

LARGEST = {"c": 61, "rust": 61, "json": 20, "glsl": 28, "wgsl": 28}
# Operations that read an array. When its first number is altered some must differ, and no others.
ARRAYS = {"next": "01234", "meetings": "02"}
ALTERED_K = 4


def altered(text, array):
    return altered_number(text, re.search(rf'"{array}": \[|restrip_{array}\[\d+\] = |const {array.upper()}: .* = &', text)[0])


def altered_answers(language, folder, scratch):
    if isinstance(language, Shader):
        return language.others  # asked at once, because a device takes long to start
    text = (folder / language.file).read_text(encoding="utf-8")
    answers = {}
    for array in ARRAYS:
        for file in folder.iterdir():
            (scratch / "altered" / file.name).write_bytes(file.read_bytes())
        (scratch / "altered" / language.file).write_text(altered(text, array), encoding="utf-8")
        answers[array] = language.answers(scratch / "altered", scratch, ALTERED_K)
    return answers


def expected(dump, max_k):
    """Of the C++ look-up, in the order in which the other programs print them."""
    *lines, end = run(dump, "--automaton", "--digests", "--max-k", max_k).splitlines(True)
    return "".join(sorted(lines, key=lambda line: [int(word) for word in line.split()[:4]])) + end


def main():
    given = arguments(__doc__, "dump", "other-dump", "automata")
    language = LANGUAGES[given.language](*given.programs)
    language.stem, language.asked, language.families = "restrip_automaton", ("automaton",), ARRAYS
    (given.scratch / "altered").mkdir()
    for cost, dump in ("strips", given.dump), ("1,1,0", given.other_dump):
        folder, largest = given.automata / cost, LARGEST[given.language]
        answers = language.answers(folder, given.scratch, largest)
        must_be_equal(f"{language.file} of cost {cost}", answers, expected(dump, largest))
        noticed = altered_answers(language, folder, given.scratch)
        for array, others in noticed.items():
            differ = compare("altered", others, expected(dump, ALTERED_K))
            if not differ or not set(differ) <= set(ARRAYS[array]):
                raise SystemExit(f"cost {cost}: a number of {array} was altered, and operations {differ} differ, not those of {ARRAYS[array]}")
        if noticed.keys() != ARRAYS.keys():
            raise SystemExit(f"{list(noticed)} were altered, not {list(ARRAYS)}")
        print(f"{language.file} of cost {cost}: {len(answers.splitlines())} digests agree, {len(noticed)} altered numbers were noticed")

    folder = given.automata / "strips"
    page = (ROOT / "docs/languages.md").read_text(encoding="utf-8")
    text, wanted = example_of(page[page.index("## Fans of any valence"):], "js" if given.language == "json" else language.block)
    printed = run(language.node, "--input-type=module", "-e", text, cwd=folder) if given.language == "json" else language.example(text, folder, given.scratch)
    if printed != wanted:
        raise SystemExit(f"the example of docs/languages.md prints\n{printed}instead of\n{wanted}")
    if given.language == "json":
        language.as_schema_says(folder, "docs/automaton.schema.json")
        language.as_schema_says(given.automata / "1,1,0", "docs/automaton.schema.json")
    else:
        language.more(folder, given.scratch, lambda max_k: expected(given.dump, max_k))


if __name__ == "__main__":
    main()
