"""The tables in another language answer as the C++ look-up does: every operation in every position with k <= 8, all
colours and ports, valid or not. Digests of the answers are compared, a line for each position, which the programs print
that the generator writes beside the tables. That a wrong rule shows is tested with one number altered at a time: exactly the
operations that read it must differ. The example of docs/languages.md is run and prints what stands there.

  language_test.py LANGUAGE --dump-tables PROGRAM --tables FOLDER --scratch FOLDER --with PROGRAM…

--dump-tables is restrip-dump-tables; --tables is the folder of restrip-generate's files; --with names what the language
needs, in the order of its class below. Software devices for shaders are asked less (first_collapses), unless
RESTRIP_EVERY_POSITION is set.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
MAX_K = 8
# The operations that read the rules of a family, by their numbers in the lines of digests.
READERS = {"split": "0", "collapse": "1", "open_split": "2", "fan_collapse": "35", "boundary_split": "4", "flip": "6"}


def run(*command, **more):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **more)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}: ended with {done.returncode}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    if done.stderr:
        raise SystemExit(f"{' '.join(map(str, command))}: said\n{done.stderr[-3000:]}")
    return done.stdout


def first_collapses(lines):
    """Without collapses beyond k = 6 but the first of each k: what software devices are asked, for time."""
    kept, seen = [], set()
    for line in lines.splitlines(True):
        words = line.split()
        if words[0] in "135" and int(words[1]) > 6:
            if (words[0], words[1]) in seen:
                continue
            seen.add((words[0], words[1]))
        kept.append(line)
    return "".join(kept)


def compare(what, found, expected):
    """The operations of the lines that differ, sorted; "r" is the last line, rules where there must be none."""
    lines, wanted = found.splitlines(), expected.splitlines()
    if len(wanted) < 30 or [line.split()[:4] for line in lines] != [line.split()[:4] for line in wanted]:
        raise SystemExit(f"{what}: positions are missing, or there are too many:\n{found}")
    return "".join(sorted({line[0] for line, other in zip(lines, wanted) if line != other}))


def must_be_equal(what, found, expected):
    wrong = compare(what, found, expected)
    if wrong:
        raise SystemExit(f"{what}: other answers than those of C++, in operations {wrong}:\n{found}\nexpected:\n{expected}")


def altered_number(text, opening):
    """The text with another number in place of the first that is not 0 behind `opening`, and not 255."""
    begin = text.index(opening) + len(opening)
    number = re.compile(r"\b(?!0\b|255\b)\d+").search(text, begin)
    return text[:number.start()] + str(int(number[0]) ^ 1) + text[number.end():]


class Language:
    """`stem` is "restrip_tables" or "restrip_automaton", of which the files of a language are."""
    stem = "restrip_tables"

    @property
    def file(self):
        return self.stem + self.extension


class Text(Language):
    """Languages whose tables are in their text."""

    def wanted(self, answers):
        return answers

    def altered_answers(self, folder, scratch):
        """The answers up to k = 4 with a rule of each family altered."""
        text = (folder / self.file).read_text(encoding="utf-8")
        altered = scratch / "altered"
        answers = {}
        for family in READERS:
            (altered / self.file).write_text(self.altered(text, family), encoding="utf-8")
            answers[family] = self.answers(altered, scratch, 4)
        return answers


class C(Text):
    extension = ".h"
    block = "c"

    def __init__(self, gcc):
        self.gcc = gcc

    def compiled(self, folder, scratch, *flags):
        program = scratch / "driver"
        run(self.gcc, "-std=c99", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror", *flags,
            folder / f"{self.stem}_check.c", "-o", program)
        return program

    def answers(self, folder, scratch, max_k):
        return run(self.compiled(folder, scratch, "-O1" if max_k >= MAX_K else "-O0"), max_k)

    def altered(self, text, family):
        return altered_number(text, re.search(rf"restrip_{family}_rules\[\d+\] = ", text)[0])

    def example(self, text, folder, scratch):
        (scratch / "example.c").write_text(text, encoding="utf-8")
        run(self.gcc, "-std=c99", "-Wall", "-Wextra", "-Werror", "-I", folder, scratch / "example.c", "-o", scratch / "example")
        return run(scratch / "example")

    def more(self, folder, scratch, expected):
        """No undefined behaviour, no library, and C++ takes it as well."""
        checked = self.compiled(folder, scratch, "-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
        must_be_equal("with sanitizers", run(checked, 6), expected(6))
        data = scratch / "data.c"
        data.write_text(f'#define {self.stem.upper()}_IMPLEMENTATION\n#include "{self.file}"\n', encoding="utf-8")
        run(self.gcc, "-std=c99", "-O2", "-ffreestanding", "-I", folder, "-c", data, "-o", scratch / "data.o")
        called = run("nm", "--undefined-only", scratch / "data.o")
        if called:
            raise SystemExit(f"the data and bodies call something:\n{called}")
        run(self.gcc, "-x", "c++", "-std=c++20", "-Wall", "-Wextra", "-Werror", "-I", folder, "-fsyntax-only", data)


class Json(Text):
    extension = ".json"
    block = "python"

    def __init__(self, node, python):
        self.node, self.python = node, python

    def answers(self, folder, scratch, max_k):
        return run(self.node, folder / f"{self.stem}_check.mjs", max_k)

    def altered(self, text, family):
        return altered_number(text, '"flip": [' if family == "flip" else
                              text[:text.index('"rules": [', text.index(f'\n"{family}": {{')) + 10])

    def example(self, text, folder, scratch):
        return run(self.python, "-c", text, cwd=folder)

    def more(self, folder, scratch, expected):
        """The file is as the schema says; files that are not are told apart."""
        schema, tables = self.as_schema_says(folder, "docs/tables.schema.json")
        for arrays in tables["families"].values():
            del arrays["rules"][5:]  # enough to be spoilt
        for member in tables:
            if not list(against(schema, {name: value for name, value in tables.items() if name != member}, schema)):
                raise SystemExit(f"docs/tables.schema.json does without {member}")
        for spoil in (lambda t: t["rows"].update(closed=[]), lambda t: t["flip"].pop(), lambda t: t.update(max_k=14),
                      lambda t: t["families"]["split"]["rules"].append(65536), lambda t: t.update(version=2),
                      lambda t: t["families"].update(other={}), lambda t: t["operations"][0].update(name="other")):
            spoilt = json.loads(json.dumps(tables))
            spoil(spoilt)
            if not list(against(schema, spoilt, schema)):
                raise SystemExit("docs/tables.schema.json takes tables that are wrong")

    def as_schema_says(self, folder, page):
        schema = json.loads((ROOT / page).read_text(encoding="utf-8"))
        tables = json.loads((folder / self.file).read_text(encoding="utf-8"))
        faults = list(against(schema, tables, schema))
        if faults:
            raise SystemExit(f"{self.file} is not as {page} says: {faults[0]}")
        return schema, tables


KNOWN = set()  # schemas looked at


class Rust(Text):
    extension = ".rs"
    block = "rust"

    def __init__(self, rustc):
        self.rustc = rustc

    def compiled(self, folder, scratch, source, *flags):
        """The source beside the module, where `mod` looks for it."""
        work = scratch / "crate"
        work.mkdir(exist_ok=True)
        shutil.copy(folder / self.file, work)
        (work / "program.rs").write_text(source, encoding="utf-8")
        run(self.rustc, "--edition", "2021", "-D", "warnings", *flags, work / "program.rs", "-o", work / "program")
        return work / "program"

    def answers(self, folder, scratch, max_k):
        source = (folder / f"{self.stem}_check.rs").read_text(encoding="utf-8")
        flags = ("-C", "opt-level=1") if max_k >= MAX_K else ()
        return run(self.compiled(folder, scratch, source, "-C", "overflow-checks=on", *flags), max_k)

    def altered(self, text, family):
        return altered_number(text, re.search(rf"const {family.upper()}_RULES: .* = &", text)[0])

    def example(self, text, folder, scratch):
        return run(self.compiled(folder, scratch, text))

    def more(self, folder, scratch, expected):
        """The module does without the standard library and without unsafe code."""
        self.compiled(folder, scratch, "#![no_std]\n#![forbid(unsafe_code)]\npub mod " + self.stem + ";\n", "--crate-type", "lib")


class Shader(Language):
    """Languages of shaders: the driver takes several files of tables at once. `asked` are the words before K."""
    asked = ()
    families = tuple(READERS)

    def wanted(self, answers):
        return answers if "RESTRIP_EVERY_POSITION" in os.environ else first_collapses(answers)

    def answers(self, folder, scratch, max_k):
        """Of the tables; and, because a device takes long to start, of those with an altered rule."""
        shader = self.shader(folder, scratch, (folder / (self.stem + self.check)).read_text(encoding="utf-8"))
        printed = self.run(shader, scratch, *self.asked, max_k, folder / f"{self.stem}.bin", *self.altered_files(folder, scratch))
        answers, *others = re.split("^== .*\n", printed, flags=re.M)
        self.others = dict(zip(self.families, others))
        return answers

    def altered_files(self, folder, scratch):
        """For each family a file in which the first byte of its rules that is not 0 is altered."""
        data = (folder / f"{self.stem}.bin").read_bytes()
        text = (folder / self.file).read_text(encoding="utf-8")
        for family in self.families:
            word = int(re.search(rf"RESTRIP_{family.upper()}_(?:RULES|OF_AUTOMATON) = u?vec2(?:<u32>)?\((\d+)u,", text)[1])
            at = next(i for i in range(4 * word, len(data)) if data[i] not in (0, 255))
            file = scratch / "altered" / f"{family}.bin"
            file.write_bytes(data[:at] + bytes([data[at] ^ 1]) + data[at + 1:])
            yield file

    def altered_answers(self, folder, scratch):
        return self.others

    def example(self, text, folder, scratch):
        return self.run(self.shader(folder, scratch, text), scratch, "words", 4, folder / f"{self.stem}.bin")

    def more(self, folder, scratch, expected):
        """The first word of the data is the checksum of the others, which the look-up names."""
        words = memoryview((folder / f"{self.stem}.bin").read_bytes()).cast("I")
        checksum = 0x811c9dc5
        for word in words[1:]:
            checksum = (checksum ^ word) * 0x01000193 & 0xffffffff
        named = re.search(r"RESTRIP_CHECKSUM(?:_OF_AUTOMATON)? = (0x[0-9a-f]{8})u;", (folder / self.file).read_text(encoding="utf-8"))[1]
        if not words[0] == checksum == int(named, 16):
            raise SystemExit(f"checksums: {words[0]:#x} in the data, {checksum:#x} of the data, {named} in {self.file}")


class Wgsl(Shader):
    extension, block, check = ".wgsl", "wgsl", "_check.wgsl"

    def __init__(self, node, chromium):
        self.node, self.chromium = node, chromium

    def shader(self, folder, scratch, source):
        (scratch / "shader.wgsl").write_text((folder / self.file).read_text(encoding="utf-8") + source, encoding="utf-8")
        return scratch / "shader.wgsl"

    def run(self, shader, scratch, *words):
        return run(self.node, HERE / "driver_wgsl.mjs", self.chromium, scratch, shader, *words)


class Glsl(Shader):
    extension, block, check = ".glsl", "glsl", "_check.comp"

    def __init__(self, glslang, vulkan):
        self.glslang, self.vulkan = glslang, vulkan

    def shader(self, folder, scratch, source):
        (scratch / "shader.comp").write_text(source, encoding="utf-8")
        said = subprocess.run([self.glslang, "-V", f"-I{folder}", scratch / "shader.comp", "-o", scratch / "shader.spv"],
                              capture_output=True, text=True, check=False)
        if said.returncode != 0 or "WARNING" in said.stdout:
            raise SystemExit(f"glslangValidator: {said.stdout}{said.stderr}")
        return scratch / "shader.spv"

    def run(self, shader, scratch, *words):
        return run(self.vulkan, shader, *words)


def against(schema, value, whole):
    """Faults of a value; of the words of JSON Schema those that our schema uses."""
    if "$ref" in schema:
        yield from against(whole["$defs"][schema["$ref"].split("/")[-1]], value, whole)
        return
    unknown = () if id(schema) in KNOWN else set(schema) - {"$schema", "$id", "$defs", "title", "description", "type", "const", "enum", "minimum", "maximum",
                             "properties", "required", "additionalProperties", "items", "minItems", "maxItems"}
    if unknown:
        raise SystemExit(f"docs/tables.schema.json uses {unknown}, which this test does not know")
    KNOWN.add(id(schema))
    kinds = {"object": dict, "array": list, "integer": int, "string": str, "boolean": bool}
    if "type" in schema and (not isinstance(value, kinds[schema["type"]]) or schema["type"] == "integer" and isinstance(value, bool)):
        yield f"{str(value)[:50]} is not of type {schema['type']}"
        return
    if "const" in schema and value != schema["const"] or "enum" in schema and value not in schema["enum"]:
        yield f"{value} is not {schema.get('const', schema.get('enum'))}"
    if isinstance(value, int) and not schema.get("minimum", value) <= value <= schema.get("maximum", value):
        yield f"{value} is out of range"
    if isinstance(value, list):
        if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)):
            yield f"{len(value)} elements"
        for element in value:
            yield from against(schema.get("items", {}), element, whole)
    if isinstance(value, dict):
        yield from (f"{name} is missing" for name in schema.get("required", []) if name not in value)
        for name, member in value.items():
            if name in schema.get("properties", {}):
                yield from against(schema["properties"][name], member, whole)
            elif not schema.get("additionalProperties", True):
                yield f"{name} is unknown"


LANGUAGES = {"c": C, "json": Json, "rust": Rust, "glsl": Glsl, "wgsl": Wgsl}


def arguments(doc, *options):
    """Of the command line; language and programs are made into the language's object."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("language", choices=LANGUAGES)
    for option in ("scratch", *options):
        parser.add_argument("--" + option, required=True, type=Path)
    parser.add_argument("--with", required=True, nargs="+", dest="programs")
    given = parser.parse_args()
    shutil.rmtree(given.scratch, ignore_errors=True)
    given.scratch.mkdir(parents=True)
    return given


def example_of(page, block):
    """A program of a page, and what it prints."""
    example = re.search(rf"```{block}\n(.+?)```\n\n[^\n]*:\n\n```text\n(.+?)```", page, re.S)
    if not example:
        raise SystemExit(f"docs/languages.md has no ```{block} block followed by a line that ends with a colon and a ```text block")
    return example[1], example[2]


def main():
    given = arguments(__doc__, "dump-tables", "tables")
    language = LANGUAGES[given.language](*given.programs)
    shutil.copytree(given.tables, given.scratch / "altered")

    def expected_answers(max_k):
        return run(given.dump_tables, "--digests", "--max-k", max_k)

    all_answers = language.wanted(expected_answers(MAX_K))
    must_be_equal(language.file, language.answers(given.tables, given.scratch, MAX_K), all_answers)

    few_answers = expected_answers(4)
    noticed = 0
    for family, answers in language.altered_answers(given.tables, given.scratch).items():
        differ = compare("altered", answers, few_answers)
        if differ != READERS[family]:
            raise SystemExit(f"a rule of {family} was altered, and operations {differ} differ, not {READERS[family]}")
        noticed += 1
    if noticed != len(READERS):
        raise SystemExit(f"{noticed} altered rules were asked for, not {len(READERS)}")

    text, wanted = example_of((ROOT / "docs/languages.md").read_text(encoding="utf-8"), language.block)
    printed = language.example(text, given.tables, given.scratch)
    if printed != wanted:
        raise SystemExit(f"the example of docs/languages.md prints\n{printed}instead of\n{wanted}")
    language.more(given.tables, given.scratch, expected_answers)
    print(f"{language.file}: {len(all_answers.splitlines())} digests agree, {noticed} altered rules were noticed")


if __name__ == "__main__":
    main()
