#!/usr/bin/env python3
"""Claim: a fault of one token in any shipped file is refused by a shipped command, and a run that did not read the file
reports that. The faults are in headers of tables, formats, look-ups, automata, tables and look-ups in C, Rust, JSON,
GLSL and WGSL, families.json and operation files; docs/explanation/what-is-proven.md lists the kinds. Each is put into a
copy alone, or with others that another run judges, and the command must exit with an error and a sentence that names
it. Without a fault every command ends by naming its input.

  faults_test.py BIN COMPILER ROOT --c-compiler CC [--rustc RUSTC] [--node NODE] [--chromium CHROMIUM] [--glslang GLSLANG --vulkan DRIVER]

BIN is the folder of the programs. Languages whose tools are not given are left out and reported.
"""
import argparse
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "generator/languages"))
import language_test

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("bin", type=Path)
parser.add_argument("compiler")
parser.add_argument("root", type=Path)
for tool in ("c-compiler", "rustc", "node", "chromium", "glslang", "vulkan"):
    parser.add_argument("--" + tool)
ARGUMENTS = parser.parse_args()
BIN, ROOT = ARGUMENTS.bin.resolve(), ARGUMENTS.root.resolve()
TOOLS = {"c": (ARGUMENTS.c_compiler,), "rust": (ARGUMENTS.rustc,), "json": (ARGUMENTS.node,), "glsl": (ARGUMENTS.glslang, ARGUMENTS.vulkan),
         "wgsl": (ARGUMENTS.node, ARGUMENTS.chromium)}
MAX_K = 5
TABLES, RULES = "tables/include/restrip/tables", "runtime/include/restrip/rules"


def number_behind(opening):
    """Another number in place of the first after these words."""
    return re.compile(rf"({opening})(\d+)"), lambda found: found[1] + str(int(found[2]) ^ 1)


RULE = number_behind(r"    \},\n    \{\n    ")  # of a table: after the starts of its blocks


def token(old, new):
    return re.compile(re.escape(old)), lambda _: new


# A name, the file, the fault, the key of the command below, and its expected message. The faults of one program are
# compiled together: each is in another table, and judged separately.
HEADERS = {
    "numbers": [
        ("a rule of splits", f"{TABLES}/split.hpp", RULE, "split", "table split k 3 a "),
        ("a rule of collapses", f"{TABLES}/collapse.hpp", RULE, "collapse", "table collapse k "),
        ("a rule of the flip", f"{TABLES}/flip.hpp", number_behind(r"FlipTable flip\{\n    "), "flip", "table flip"),
        ("a number of the automaton", f"{TABLES}/automaton.hpp", token("1, 2, 3, 4, 5,", "1, 2, 3, 4, 6,"), "automaton", "next[4]: the table holds 6"),
    ],
    "layout": [
        ("where the rows of a table start", f"{TABLES}/rows.hpp", token("6, 7, 11, 0,", "6, 7, 10, 0,"), "split", "table split k "),
        ("the format of automata", f"{TABLES}/automaton_format.hpp", token("solid = 3", "solid = 2"), "automaton", "the certificate's answers give"),
    ],
    "readers": [
        ("the look-up in tables", f"{RULES}/rules.hpp", token("const std::size_t by = exchange ? a : 0;", "const std::size_t by = exchange ? k : 0;"), "split", "table split k "),
        ("the reader of the automaton", f"{RULES}/exact.hpp", token("4 * end", "3 * end"), "automaton", "the certificate's answers give"),
    ],
    "questions": [
        ("what open splits ask the automaton", f"{RULES}/rules.hpp", token("rule(open_fan(at.k), path_with_chord(at.k, at.i, at.j)", "rule(open_fan(at.k), path_with_chord(at.k, at.i, at.k)"), "open-split", "table open-split k "),
        ("what collapses onto open fans ask it", f"{RULES}/rules.hpp", token("rule(path(at.k, at.i)", "rule(path(at.k, 0)"), "fan-collapse", "table boundary-collapse k "),
    ],
    "stated": [
        ("the strips that a rule states", f"{RULES}/rules.hpp", token("nodes - count_difference(colors, inner)", "nodes + count_difference(colors, inner)"), "open-split", "the table states "),
        ("the isolated triangles that a flip states", f"{RULES}/rules.hpp", token("isolated_one(inner, ports, 0, 1)", "isolated_one(inner, ports, 0, 2)"), "flip", "isolated triangles, but there are"),
        ("what an answer of the automaton is worth", f"{RULES}/exact.hpp", token("count_bits(result.colors), detail", "count_bits(ports), detail"), "automaton", "the certificate's answers give"),
    ],
}
# For a single operation, by the command of docs/tutorials/custom-operation.md.
OPERATION = [
    ("the entry of an operation's header", "include/restrip/tables/operations/bisect.hpp", token("112, 113, 210", "112, 112, 210"), 'the table answers "7 0"'),
    ("a triangle of an operation's header", "include/restrip/tables/operations/bisect.hpp", token("{0, 64, 65}", "{0, 65, 64}"), "expected the triangles"),
    ("the format of operations", "include/restrip/tables/operation_format.hpp", token("strips_after - strips_before", "strips_before - strips_after"), "the table states "),
    ("the certificate of an operation", "certificates/operations/bisect.cert", token("rule 0 0 7 0", "rule 0 0 6 0"), "was altered"),
    ("an operation file", "operations/bisect.json", token('["b", "a", "d"]', '["a", "b", "d"]'), "is an operation of restrip"),
    ("what an operation file asks for", "operations/bisect.json", token('"strips"', '"matching"'), ""),
]
# For files that are not compiled: these are refused by their sums, and families even if the sums fit.
FILES = [
    ("a number of a header", "include/restrip/tables/collapse.hpp", RULE, "collapse.hpp: wrong checksum"),
    ("the layout of tables", "include/restrip/tables/format.hpp", token("std::array<std::uint8_t, 32>", "std::array<std::int8_t, 32>"), "format.hpp: wrong size"),
    ("the automaton", "include/restrip/tables/automaton.hpp", token("1, 2, 3, 4, 5,", "1, 2, 3, 4, 6,"), "automaton.hpp: wrong checksum"),
    ("a certificate", "certificates/flip.cert", token("rule 0 0 1 0", "rule 0 0 0 0"), "flip.cert: wrong checksum"),
    ("the rows of a header in the MANIFEST", "MANIFEST", token(" 12411 include", " 999 include"), "split.hpp: 999 rows listed, 12411 found"),
    ("families", "families.json", token('"at_most": [{"strips": 1, "isolated": 2, "indices": 4}]', '"at_most": [{"strips": 1, "isolated": 3, "indices": 4}]'), "families.json: wrong checksum"),
]
# For its look-up in C, which prints its answers as a dump.
OPERATION_IN_C = [
    ("an entry in C", "restrip_rule_of_bisect.h", token("112, 113, 210", "112, 112, 210"), 'the table answers "7 0"'),
    ("a token in C", "restrip_rule_of_bisect.h", token("rule.colors = entry >> port_count", "rule.colors = entry << port_count"), "line 3: table bisect: expected"),
    ("the changes that an answer in C states", "restrip_rule_of_bisect.h", token("restrip_after_of_bisect[place] - ", "restrip_after_of_bisect[place] + "), "the table states "),
]
# Tables in other languages: the digests of the answers or of their stated changes differ. Both shaders read the same data.
LANGUAGES = [
    ("a number in C", "c", "restrip_tables.h", number_behind(r"restrip_split_rules\[\d+\] = \{\s*")),
    ("a token in C", "c", "restrip_tables.h", token("exchange ? arc + 1 : 0", "exchange ? arc + 2 : 0")),
    ("a number in Rust", "rust", "restrip_tables.rs", number_behind(r"const COLLAPSE_RULES: .* = &\[\s*")),
    ("a token in Rust", "rust", "restrip_tables.rs", token("{ arc + 1 }", "{ arc + 2 }")),
    ("a number in JSON", "json", "restrip_tables.json", number_behind(r'"flip": \[\s*')),
    ("a token of the reader of JSON", "json", "restrip_tables.mjs", token("turned(ports, p, k)", "turned(ports, k, p)")),
    ("a number in the data of GLSL", "glsl", "restrip_tables.bin", None),
    ("a number in the data of WGSL", "wgsl", "restrip_tables.bin", None),
    ("a token in GLSL", "glsl", "restrip_tables.glsl", token("exchange ? arc + 1u : 0u", "exchange ? arc + 2u : 0u")),
    ("a token in WGSL", "wgsl", "restrip_tables.wgsl", token("select(0u, arc + 1u, exchange)", "select(0u, arc + 2u, exchange)")),
]


def put_in(file, fault):
    """Puts the fault into the file, once."""
    pattern, other = fault
    text = file.read_text(encoding="utf-8")
    altered, count = pattern.subn(other, text, count=1)
    if count != 1 or altered == text:
        raise SystemExit(f"{file}: the fault does not fit: {pattern.pattern}")
    file.write_text(altered, encoding="utf-8")


def alter_data(folder):
    """Another first rule of splits in the data of the shaders."""
    place = re.search(r"RESTRIP_SPLIT_RULES = uvec2\((\d+)u", (folder / "restrip_tables.glsl").read_text(encoding="utf-8"))
    data = bytearray((folder / "restrip_tables.bin").read_bytes())
    data[4 * int(place[1])] ^= 1
    (folder / "restrip_tables.bin").write_bytes(data)


def run(*command, **more):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **more)


REFUSED = []


def refused(what, sentence, done):
    said = done.stdout + done.stderr
    if done.returncode not in (1, 2) or sentence not in said or re.search("^verified: ", said, re.M):
        raise SystemExit(f"{what}: ended with {done.returncode}; expected: {sentence}\n{said[-3000:]}")
    REFUSED.append(what)


def accepted(what, read, done):
    if done.returncode != 0 or not re.search(rf"^verified: .*; read: {read}\n\Z", done.stdout, re.M):
        raise SystemExit(f"{what}: ended with {done.returncode}; expected: read: {read}\n{done.stdout[-3000:]}{done.stderr}")


def copied(scratch, name, *parts):
    copy = scratch / name
    for part in parts:
        shutil.copytree(ROOT / part, copy / part)
    return copy


def dump_program(copy, scratch):
    """The dump program, compiled from the headers of the copy; or what the compiler said."""
    program = scratch / (copy.name + "-dump")
    done = run(ARGUMENTS.compiler, "-std=c++20", "-O0", "-I", copy / "runtime/include", "-I", copy / "tables/include",
               *(ROOT / f"tables/dump/dump_{part}.cpp" for part in ("automaton", "digests", "tables")), "-o", program)
    return program if done.returncode == 0 else done


def judge(program, part):
    """The commands that read compiled headers; `part` is what is judged of them."""
    if part == "automaton":
        return run(BIN / "restrip-verify", "automaton", "--tables-dir", ROOT / "tables", "--max-k", "3", "--dump-command", f"'{program}' --automaton")
    return run(BIN / "restrip-verify", "--headers", "--family", part, "--max-k", MAX_K, "--dump-command", f"'{program}' --max-k {MAX_K}")


def check_headers(scratch):
    sound = BIN / "restrip-dump-tables"
    accepted("the shipped tables", "compiled tables only; no certificate was read", judge(sound, "split"))
    accepted("the shipped automaton", "certificates and compiled automaton", judge(sound, "automaton"))
    for name, faults in HEADERS.items():
        copy = copied(scratch, name, "tables/include", "runtime/include")
        for _, file, fault, _, _ in faults:
            put_in(copy / file, fault)
        program = dump_program(copy, scratch)
        if not isinstance(program, Path):
            raise SystemExit(f"{name}: {program.stderr[-3000:]}")
        for what, file, _, part, sentence in faults:
            refused(f"{what} ({file})", sentence, judge(program, part))
    copy = copied(scratch, "format", "tables/include", "runtime/include")
    put_in(copy / TABLES / "format.hpp", token("std::array<std::uint8_t, 32>", "std::array<std::int8_t, 32>"))
    done = dump_program(copy, scratch)
    if isinstance(done, Path) or "narrowing" not in done.stderr:
        raise SystemExit(f"the layout of tables: {done}")
    REFUSED.append(f"the layout of tables ({TABLES}/format.hpp), by the compiler")


def check_operation(scratch):
    def verify(copy):
        tables = copy / "tables"
        source, program = copy / "print.cpp", copy / "print"
        source.write_text('#include "restrip/tables/operation_dump.hpp"\n#include "restrip/tables/operations/bisect.hpp"\n'
                          'int main() { return restrip::tables::print_dump("bisect", restrip::tables::bisect_rules); }\n', encoding="utf-8")
        run(ARGUMENTS.compiler, "-std=c++20", "-I", tables / "include", source, "-o", program)
        return run(BIN / "restrip-verify", "--operation", tables / "operations/bisect.json", "--certificate", tables / "certificates/operations/bisect.cert",
                   "--header", tables / "include/restrip/tables/operations/bisect.hpp", "--dump-command", program)

    accepted("an operation", "certificates, header texts and compiled tables", verify(copied(scratch, "operation", "tables")))
    for number, (what, file, fault, sentence) in enumerate(OPERATION):
        copy = copied(scratch, f"operation-{number}", "tables")
        put_in(copy / "tables" / file, fault)
        refused(f"{what} (tables/{file})", sentence, verify(copy))


def check_operation_in_c(scratch):
    tables = ROOT / "tables"

    def verify(folder):
        (folder / "print.c").write_text("""#include <stdio.h>
#define RESTRIP_RULE_OF_BISECT_IMPLEMENTATION
#include "restrip_rule_of_bisect.h"
int main(void) {
  uint32_t inner, ports;
  printf("restrip-table-dump 4\\ntable bisect\\n");
  for (inner = 0; inner < 2; ++inner)
    for (ports = 0; ports < 16; ++ports) {
      const restrip_operation_rule rule = restrip_rule_of_bisect(inner, ports);
      printf("%x %x ", (unsigned)inner, (unsigned)ports);
      if (rule.valid)
        printf("%x %x %d\\n", (unsigned)rule.colors, (unsigned)rule.ports, (int)rule.strips);
      else
        printf("-\\n");
    }
  printf("end 32\\n");
  return 0;
}
""", encoding="utf-8")
        language_test.run(ARGUMENTS.c_compiler, "-std=c99", folder / "print.c", "-o", folder / "print")
        return run(BIN / "restrip-verify", "--operation", tables / "operations/bisect.json", "--certificate", tables / "certificates/operations/bisect.cert",
                   "--header", tables / "include/restrip/tables/operations/bisect.hpp", "--dump-command", folder / "print")

    sound = scratch / "operation-c"
    language_test.run(BIN / "restrip-generate", "rules", "--operation", tables / "operations/bisect.json", "--language", "c", "--out", sound)
    accepted("an operation in C", "certificates, header texts and compiled tables", verify(sound))
    for number, (what, file, fault, sentence) in enumerate(OPERATION_IN_C):
        copy = scratch / f"operation-c-{number}"
        shutil.copytree(sound, copy)
        put_in(copy / file, fault)
        refused(f"{what}, of an operation ({file})", sentence, verify(copy))


def check_files(scratch):
    def verify(copy):
        return run(BIN / "restrip-verify", "--tables-dir", copy / "tables", "--family", "flip")

    accepted("the files", "certificates only; no header was read", verify(copied(scratch, "files", "tables")))
    for number, (what, file, fault, sentence) in enumerate(FILES):
        copy = copied(scratch, f"files-{number}", "tables")
        put_in(copy / "tables" / file, fault)
        refused(f"{what} (tables/{file})", sentence, verify(copy))
        # With a MANIFEST that fits the altered file, a run that reads no header says so; other families are detected.
        if file.endswith(".hpp") or file == "families.json":
            resum(copy / "tables", file)
            if file == "families.json":
                refused("families, with their checksum", "families.json: differs from the families that this program was built with", verify(copy))
            else:
                accepted(what, "certificates only; no header was read", verify(copy))


def check_languages(scratch):
    tables = scratch / "languages"
    drivers = {name: language_test.LANGUAGES[name](*tools) for name, tools in TOOLS.items() if all(tools)}

    for driver in drivers.values():
        driver.expected = lambda max_k: language_test.run(BIN / "restrip-dump-tables", "--digests", "--max-k", max_k)

    def judged(language, folder):
        """The digests of the shipped headers' answers equal the language's."""
        return run(BIN / "restrip-verify", "--headers", "--max-k", MAX_K, "--dump-command", f"'{BIN}/restrip-dump-tables' --max-k {MAX_K}",
                   "--digest-command", shlex.join(map(str, drivers[language].digests(folder, folder, MAX_K))))

    language_test.run(BIN / "restrip-generate", "tables", "--max-k", MAX_K, "--out", tables, *(f"--language={name}" for name in TOOLS))
    for name in drivers:
        shutil.copytree(tables, scratch / name)
        accepted(name, "compiled tables and digests of other languages only; no certificate was read", judged(name, scratch / name))
    for number, (what, name, file, fault) in enumerate(LANGUAGES):
        if name not in drivers:
            print(f"left out, a tool is missing: {what} ({file})")
            continue
        copy = scratch / f"{name}-{number}"
        shutil.copytree(tables, copy)
        if fault:
            put_in(copy / file, fault)
        else:
            alter_data(copy)
        refused(f"{what} ({file})", "the judged answers give", judged(name, copy))


def resum(tables, file):
    """Makes the MANIFEST's line of the file again."""
    done = run("sha256sum", tables / file)
    manifest = (tables / "MANIFEST").read_text(encoding="ascii")
    size = (tables / file).stat().st_size
    line = re.compile(rf"^[0-9a-f]{{64}} \d+ (\d+) {re.escape(file)}$", re.M)
    (tables / "MANIFEST").write_text(line.sub(rf"{done.stdout.split()[0]} {size} \1 {file}", manifest), encoding="ascii")


def main():
    with tempfile.TemporaryDirectory() as name:
        scratch = Path(name)
        check_files(scratch)
        check_operation(scratch)
        check_operation_in_c(scratch)
        check_headers(scratch)
        check_languages(scratch)
    print("\n".join(f"refused: {what}" for what in REFUSED))
    if len(REFUSED) < 20:
        raise SystemExit("fewer than twenty")


main()
