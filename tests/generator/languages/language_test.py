"""The tables in another language answer as the C++ look-up does: splits and collapses of closed fans in every position
with k <= 8, and the flip, all colours and ports, valid or not. Digests of the answers are compared, a line for each position, which the programs print
that the generator writes with the tables. That a wrong rule shows is tested with one number altered at a time: exactly the
operations that read it must differ. The example of docs/how-to/other-languages.md is run and prints what stands there.

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
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from json_schema import fits

MAX_K = 8
# The operations that read the rules of a family, by their numbers in the lines of digests.
READERS = {"split": "0", "collapse": "1", "flip": "6"}


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
        if words[0] == "1" and int(words[1]) > 6:
            if (words[0], words[1]) in seen:
                continue
            seen.add((words[0], words[1]))
        kept.append(line)
    return "".join(kept)


def compare(what, found, expected):
    """The operations of the lines that differ, sorted; "r" is the last line, rules where there must be none."""
    lines, wanted = found.splitlines(), expected.splitlines()
    if len(wanted) < 12 or [line.split()[:4] for line in lines] != [line.split()[:4] for line in wanted]:
        raise SystemExit(f"{what}: positions are missing, or there are too many:\n{found}")
    return "".join(sorted({line[0] for line, other in zip(lines, wanted) if line != other}))


def must_be_equal(what, found, expected):
    wrong = compare(what, found, expected)
    if wrong:
        raise SystemExit(f"{what}: other answers than C++, in operations {wrong}:\n{found}\nexpected:\n{expected}")


class Language:
    """How the programs of a language are made and run. `stem` is what its files begin with; `check` is the program that prints
    digests; `flags` are used for all of them; `expected` gives the digests of C++ up to some k. `rules` finds what is
    altered for each of `families`."""
    stem = "restrip_tables"
    families = tuple(READERS)
    flags = ()
    expected = None

    @property
    def file(self):
        return self.stem + self.extension

    @property
    def check(self):
        return f"{self.stem}_check{self.check_extension}"

    def digests(self, folder, scratch, max_k):
        """The command that prints the digests up to this k."""
        return *self.program((folder / self.check).read_text(encoding="utf-8"), folder, scratch, *(self.flags if max_k >= MAX_K else ())), max_k

    def wanted(self, answers):
        return answers

    def answers(self, folder, scratch, max_k):
        return run(*self.digests(folder, scratch, max_k))

    def altered_answers(self, folder, scratch):
        """The answers up to k = 4 with a rule of each family altered: the first number of its rules that is not 0, and not 255."""
        text = (folder / self.file).read_text(encoding="utf-8")
        altered = scratch / "altered"
        answers = {}
        for family in self.families:
            rules = re.search(self.rules.format(family=family, FAMILY=family.upper()), text)
            number = re.compile(r"\b(?!0\b|255\b)\d+").search(text, rules.end())
            (altered / self.file).write_text(text[:number.start()] + str(int(number[0]) ^ 1) + text[number.end():], encoding="utf-8")
            answers[family] = self.answers(altered, scratch, 4)
        return answers

    def example(self, text, folder, scratch):
        return run(*self.program(text, folder, scratch))


class C(Language):
    extension, check_extension, block = ".h", ".c", "c"
    rules = r"restrip_{family}_rules\[\d+\] = "
    flags = ("-O1",)
    sanitizers = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")

    def __init__(self, gcc):
        self.gcc = gcc

    def program(self, source, folder, scratch, *flags):
        (scratch / "program.c").write_text(source, encoding="utf-8")
        run(self.gcc, "-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-pedantic", "-Werror", *flags, "-I", folder,
            scratch / "program.c", "-o", scratch / "program")
        return (scratch / "program",)

    def taken_as_cpp(self, source, folder):
        run(self.gcc, "-x", "c++", "-std=c++20", "-Wall", "-Wextra", "-Werror", "-I", folder, "-fsyntax-only", source)

    def more(self, folder, scratch):
        """No undefined behaviour, no library, and C++ takes it as well."""
        source = (folder / self.check).read_text(encoding="utf-8")
        must_be_equal("with sanitizers", run(*self.program(source, folder, scratch, "-O1", *self.sanitizers), 6), self.expected(6))
        data = scratch / "data.c"
        data.write_text(f'#define {self.stem.upper()}_IMPLEMENTATION\n#include "{self.file}"\n', encoding="utf-8")
        run(self.gcc, "-std=c99", "-O2", "-ffreestanding", "-I", folder, "-c", data, "-o", scratch / "data.o")
        called = run("nm", "--undefined-only", scratch / "data.o")
        if called:
            raise SystemExit(f"the data and bodies call something:\n{called}")
        self.taken_as_cpp(data, folder)
        self.any_arguments(self.stem, folder, scratch)

    def any_arguments(self, stem, folder, scratch):
        """Whatever the arguments are, nothing is read out of bounds, and an answer that is not valid is 0. That a read out of
        bounds would be noticed is seen of a header that forgets what it checks."""
        text = (folder / f"{stem}.h").read_text(encoding="utf-8")
        members = {name: re.findall(r"(\w+)[,;]", body) for name, body in re.findall(r"^typedef struct (\w+) \{([^}]*)\}", text, re.M)}
        calls = []
        for answer, function, parameters in re.findall(r"^(restrip_\w+) (\w+)\(((?:uint32_t|restrip_key) .*)\);$", text, re.M):
            given = ", ".join("(restrip_key){any(), any()}" if one.startswith("restrip_key") else "(uint32_t)any()"
                              for one in parameters.split(", "))
            not_zero = " || ".join(f"answer.{member} != 0" for member in members[answer])
            calls.append(f"  for (int i = 0; i < 300000; ++i) {{\n    const {answer} answer = {function}({given});\n"
                         f"    if (answer.valid) ++valid;\n    else if ({not_zero}) return 1;\n  }}\n"
                         '  printf("%d\\n", valid);\n  valid = 0;\n')
        source = (f'#include <stdio.h>\n#define {stem.upper()}_IMPLEMENTATION\n#include "{stem}.h"\n'
                  "static uint64_t state = UINT64_C(20261126);\nstatic uint64_t any(void) {  /* small numbers, masks, ends of masks */\n"
                  "  state ^= state << 13;\n  state ^= state >> 7;\n  state ^= state << 17;\n  const uint64_t bits = state >> 6;\n"
                  "  const uint32_t size = (uint32_t)(state & 63);\n"
                  "  return size < 48 ? bits % (UINT64_C(1) << size / 4) : size < 52 ? (UINT64_C(1) << bits % 64) - 1 : bits;\n}\n"
                  "int main(void) {\n  int valid = 0;\n" + "".join(calls) + "  return 0;\n}\n")
        counts = run(*self.program(source, folder, scratch, "-O1", *self.sanitizers)).split()
        if not calls or len(counts) != len(calls) or any(not 0 < int(count) < 300000 for count in counts):
            raise SystemExit(f"{stem}.h: of 300000 answers for any arguments these are valid: {counts}")
        careless = scratch / "careless"
        careless.mkdir(exist_ok=True)
        (careless / f"{stem}.h").write_text(re.sub(r"k > RESTRIP_\w+_MAX_K|inner >> edges != 0", "false", text), encoding="utf-8")
        done = subprocess.run(self.program(source, careless, scratch, "-w", "-O1", *self.sanitizers), capture_output=True, text=True, check=False)
        if done.returncode == 0 or "runtime error" not in done.stderr and "AddressSanitizer" not in done.stderr:
            raise SystemExit(f"{stem}.h: without a check of its arguments no read out of bounds is noticed")


class Json(Language):
    extension, check_extension, block = ".json", ".mjs", "python"
    rules = r'"{family}": (?:\[|\{{(?s:.*?)"rules": \[)'

    def __init__(self, node, python=None):
        self.node, self.python = node, python

    def digests(self, folder, scratch, max_k):
        return self.node, folder / self.check, max_k

    def example(self, text, folder, scratch):
        return run(self.python, "-c", text, cwd=folder)

    def more(self, folder, scratch):
        """The file is as the schema says; others are refused."""
        schema, tables = self.as_schema_says(folder, "docs/tables.schema.json")
        for arrays in tables["families"].values():
            del arrays["rules"][5:]  # enough to be spoilt
        for member in tables:
            if fits(schema, {name: value for name, value in tables.items() if name != member}, schema):
                raise SystemExit(f"docs/tables.schema.json does without {member}")
        for spoil in (lambda t: t.update(rows=[]), lambda t: t["flip"].pop(), lambda t: t.update(max_k=14),
                      lambda t: t["families"]["split"]["rules"].append(65536), lambda t: t.update(version=1),
                      lambda t: t["families"].update(other={}), lambda t: t["operations"][0].update(name="other")):
            spoilt = json.loads(json.dumps(tables))
            spoil(spoilt)
            if fits(schema, spoilt, schema):
                raise SystemExit("docs/tables.schema.json takes tables that are wrong")

    def as_schema_says(self, folder, page):
        """Schema and file."""
        schema = json.loads((ROOT / page).read_text(encoding="utf-8"))
        tables = json.loads((folder / self.file).read_text(encoding="utf-8"))
        if not fits(schema, tables, schema):
            raise SystemExit(f"{self.file} is not as {page} says")
        return schema, tables


class Rust(Language):
    extension, check_extension, block = ".rs", ".rs", "rust"
    rules = r"const {FAMILY}_RULES: .* = &"
    flags = ("-C", "opt-level=1")

    def __init__(self, rustc):
        self.rustc = rustc

    def program(self, source, folder, scratch, *flags):
        """The source next to the modules, where `mod` looks for them."""
        work = scratch / "crate"
        work.mkdir(exist_ok=True)
        for module in folder.glob("restrip_*.rs"):
            shutil.copy(module, work)
        (work / "program.rs").write_text(source, encoding="utf-8")
        run(self.rustc, "--edition", "2021", "-D", "warnings", "-C", "overflow-checks=on", *flags, work / "program.rs", "-o", work / "program")
        return (work / "program",)

    def core_alone(self, module, folder, scratch):
        """The module does without the standard library and without unsafe code."""
        self.program(f"#![no_std]\n#![forbid(unsafe_code)]\npub mod {module};\n", folder, scratch, "--crate-type", "lib")

    def more(self, folder, scratch):
        self.core_alone(self.stem, folder, scratch)


class Shader(Language):
    """Languages of shaders: the driver takes several files of tables at once."""

    def digests(self, folder, scratch, max_k):
        program = self.program((folder / self.check).read_text(encoding="utf-8"), folder, scratch)
        return *program, self.lines(scratch, max_k), folder / f"{self.stem}.bin"

    def lines(self, scratch, max_k):
        """A file that says which positions are asked."""
        file = scratch / f"lines-{max_k}.txt"
        file.write_text(self.wanted(self.expected(max_k)), encoding="utf-8")
        return file

    def wanted(self, answers):
        return answers if "RESTRIP_EVERY_POSITION" in os.environ else first_collapses(answers)

    def answers(self, folder, scratch, max_k):
        """Of the tables; and, because a device takes long to start, of those with an altered rule."""
        answers, *others = re.split("^== .*\n", run(*self.digests(folder, scratch, max_k), *self.altered_files(folder, scratch)), flags=re.M)
        self.others = dict(zip(self.families, others))
        return answers

    def altered_files(self, folder, scratch):
        """For each family a file in which the first byte of its rules that is not 0 is altered."""
        data = (folder / f"{self.stem}.bin").read_bytes()
        text = (folder / self.file).read_text(encoding="utf-8")
        for family in self.families:
            word = int(re.search(rf"RESTRIP_{family.upper()}_(?:RULES|IN_AUTOMATON) = u?vec2(?:<u32>)?\((\d+)u,", text)[1])
            at = next(i for i in range(4 * word, len(data)) if data[i] not in (0, 255))
            file = scratch / "altered" / f"{family}.bin"
            file.write_bytes(data[:at] + bytes([data[at] ^ 1]) + data[at + 1:])
            yield from (self.lines(scratch, 4), file)

    def altered_answers(self, folder, scratch):
        return self.others

    def example(self, text, folder, scratch):
        return run(*self.program(text, folder, scratch), "words", 4, folder / f"{self.stem}.bin")

    def more(self, folder, scratch):
        """The first word of the data is the checksum of the others, which the look-up names."""
        words = memoryview((folder / f"{self.stem}.bin").read_bytes()).cast("I")
        checksum = 0x811c9dc5
        for word in words[1:]:
            checksum = (checksum ^ word) * 0x01000193 & 0xffffffff
        named = re.search(r"RESTRIP_CHECKSUM(?:_IN_AUTOMATON)? = (0x[0-9a-f]{8})u;", (folder / self.file).read_text(encoding="utf-8"))[1]
        if not words[0] == checksum == int(named, 16):
            raise SystemExit(f"checksums: {words[0]:#x} in the data, {checksum:#x} of the data, {named} in {self.file}")


class Wgsl(Shader):
    extension, check_extension, block = ".wgsl", ".wgsl", "wgsl"

    def __init__(self, node, chromium):
        self.node, self.chromium = node, chromium

    def program(self, source, folder, scratch, *names):
        """The source after the look-up, or after the look-ups of these names."""
        texts = [(folder / name).read_text(encoding="utf-8") for name in names or (self.file,)]
        (scratch / "shader.wgsl").write_text("".join(texts) + source, encoding="utf-8")
        return self.node, HERE / "driver_wgsl.mjs", self.chromium, scratch, scratch / "shader.wgsl"


class Glsl(Shader):
    extension, check_extension, block = ".glsl", ".comp", "glsl"

    def __init__(self, glslang, vulkan):
        self.glslang, self.vulkan = glslang, vulkan

    def program(self, source, folder, scratch):
        (scratch / "shader.comp").write_text(source, encoding="utf-8")
        said = run(self.glslang, "-V", f"-I{folder}", scratch / "shader.comp", "-o", scratch / "shader.spv")
        if "WARNING" in said:
            raise SystemExit(f"glslangValidator: {said}")
        return self.vulkan, scratch / "shader.spv"


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


def check_example(language, heading, folder, scratch):
    """The program that docs/how-to/other-languages.md has after this heading prints the output shown there."""
    page = (ROOT / "docs/how-to/other-languages.md").read_text(encoding="utf-8").split(heading, 1)[1]
    example = re.search(rf"```{language.block}\n(.+?)```\n\n[^\n]*:\n\n```text\n(.+?)```", page, re.S)
    if not example:
        raise SystemExit(f"docs/how-to/other-languages.md has no ```{language.block} block followed by a line that ends with a colon and a ```text block")
    printed = language.example(example[1], folder, scratch)
    if printed != example[2]:
        raise SystemExit(f"the example of docs/how-to/other-languages.md prints\n{printed}instead of\n{example[2]}")


def main():
    given = arguments(__doc__, "dump-tables", "tables")
    language = LANGUAGES[given.language](*given.programs)
    shutil.copytree(given.tables, given.scratch / "altered")
    language.expected = lambda max_k: run(given.dump_tables, "--digests", "--max-k", max_k)
    all_answers = language.wanted(language.expected(MAX_K))
    must_be_equal(language.file, language.answers(given.tables, given.scratch, MAX_K), all_answers)

    few_answers = language.expected(4)
    noticed = 0
    for family, answers in language.altered_answers(given.tables, given.scratch).items():
        differ = compare("altered", answers, few_answers)
        if differ != READERS[family]:
            raise SystemExit(f"a rule of {family} was altered, and operations {differ} differ, not {READERS[family]}")
        noticed += 1
    if noticed != len(READERS):
        raise SystemExit(f"{noticed} altered rules were asked for, not {len(READERS)}")

    check_example(language, "\n", given.tables, given.scratch)
    language.more(given.tables, given.scratch)
    print(f"{language.file}: {len(all_answers.splitlines())} digests agree, {noticed} altered rules were noticed")


if __name__ == "__main__":
    main()
