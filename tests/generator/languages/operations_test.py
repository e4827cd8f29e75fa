"""The tables of operation files in another language. restrip-verify proves all answers of the look-up, as the dump of a table;
the reported changes of strips are checked here. The look-up is asked for every configuration of shipped operations, of matchings,
and of families with one to three numbers, which are named like keywords of the languages, and for bits outside the
patch and positions that do not exist. All look-ups are in one program. If one entry is altered, the verifier refuses the answers.
The example of docs/how-to/other-languages.md prints the output shown there.

  operations_test.py LANGUAGE --generate PROGRAM --verify PROGRAM --scratch FOLDER --with PROGRAM…
"""
import json
import shlex
import subprocess

import language_test
from language_test import ROOT, arguments, check_example, run

MAX_K = 5
NONE = (0, 0, 0, 0)  # valid, colours, ports, strips
# Gaps of open fans, with numbers whose names are keywords.
THREE_NUMBERS = {
    "restrip_operation": 1, "name": "union", "constraint": "strips", "numbers": ["int", "fn", "let"],
    "where": "int >= 2, 1 <= fn < let <= int",
    "before": [["v", "u[i]", "u[i+1]", "i[0,fn)"], ["v", "u[i]", "u[i+1]", "i[fn,let)"], ["v", "u[i]", "u[i+1]", "i[let,int)"]],
    "after": [["v", "u[i]", "u[i+1]", "i[0,int)"]], "boundary": [["u[int]", "u[0]"]],
}
# With a separate rule for each configuration that a shader's words hold in 8 bits.
FILES = (*sorted((ROOT / "tables/operations").glob("*.json")), *sorted((ROOT / "tests/corpus/operations/families").glob("*.json")),
         ROOT / "tests/corpus/operations/bisect-costs.json")


class Operation:
    """An operation file, and the configurations for which its look-up is asked."""

    def __init__(self, file, generate, out):
        self.file = file
        self.name = json.loads(file.read_text(encoding="utf-8"))["name"]
        self.identifier = self.name.replace("-", "_")
        self.more = ["--max-k", str(MAX_K)] if "numbers" in json.loads(file.read_text(encoding="utf-8")) else []
        run(generate, "rules", "--operation", file, *self.more, "--out", out, *(f"--language={name}" for name in ("c++", "c", "rust", "json", "glsl", "wgsl")))
        # The verifier derives the positions from the operation file: a dump must have them all.
        self.table = json.loads((out / f"restrip_rule_of_{self.identifier}.json").read_text(encoding="utf-8"))
        self.proofs = ["--certificate", out / f"certificates/operations/{self.name}.cert",
                       "--header", out / f"include/restrip/tables/operations/{self.identifier}.hpp"]

    def questions(self):
        """Position, inner edges, ports: of all configurations."""
        for at in self.table["positions"]:
            for inner in range(1 << at["before"]["edges"]):
                for ports in range(1 << at["ports"]):
                    yield at, inner, ports

    def questions_outside(self):
        first, last = self.table["positions"][0], self.table["positions"][-1]
        for at in (first, last):
            yield at, 1 << at["before"]["edges"], 0
            yield at, 0, 1 << at["ports"]
            yield at, 0xffffffff, 0xffffffff
        there = {tuple(at["numbers"]) for at in self.table["positions"]}
        for place in range(len(first["numbers"])):
            for number in (0, MAX_K + 1, MAX_K + 2, 0x80000000, 0xffffffff):
                for at in (first, last):
                    numbers = [*at["numbers"]]
                    numbers[place] = number
                    if tuple(numbers) not in there:
                        yield {"numbers": numbers}, 0, 0

    def dump(self, answers):
        """As a program that prints a table, after the answers were looked at where the verifier sees nothing of them."""
        questions, outside = list(self.questions()), list(self.questions_outside())
        if len(answers) != len(questions) + len(outside):
            raise SystemExit(f"{self.name}: {len(answers)} answers to {len(questions)} and {len(outside)} questions")
        if any(answer != NONE for answer in answers[len(questions):]):
            raise SystemExit(f"{self.name}: rules where none exist: {list(zip(outside, answers[len(questions):]))}")
        tables, of_matching = [], {}
        for (at, inner, ports), (valid, colors, kept, strips) in zip(questions, answers):
            if not valid and (colors, kept, strips) != (0, 0, 0):
                raise SystemExit(f"{self.name}: {at}, {inner:x} {ports:x}: no rule, and {colors:x} {kept:x} {strips}")
            change = (at["after"]["triangles"] - colors.bit_count() - kept.bit_count()) - (
                at["before"]["triangles"] - inner.bit_count() - ports.bit_count())
            if valid and strips != change:
                raise SystemExit(f"{self.name}: {at}, {inner:x} {ports:x}: {strips} strips more, and not {change}")
            if inner == 0 and ports == 0:
                tables.append(f"table {self.name}{self.position(at)}\n")
            if not self.table["matching"] or inner == 0:
                tables[-1] += f"{inner:x} {ports:x} " + (f"{colors:x} {kept:x} {strips}\n" if valid else "-\n")
                of_matching[ports] = (valid, colors, kept)
            elif of_matching[ports] != (valid, colors, kept):
                raise SystemExit(f"{self.name}: the rule of a matching depends on its inner edges")
        lines = sum(table.count("\n") - 1 for table in tables)
        return "restrip-table-dump 4\n" + "".join(tables) + f"end {lines}\n"

    def position(self, at):
        pattern = json.loads(self.file.read_text(encoding="utf-8")).get("position", " ".join(f"{name} {{{name}}}" for name in self.table["numbers"]))
        return f" {pattern.format(**dict(zip(self.table['numbers'], at['numbers'])))}" if at["numbers"] else ""

    def judged(self, verify, answers, scratch):
        """Whether the verifier accepts the answers."""
        dump = scratch / "dump.txt"
        dump.write_text(self.dump(answers), encoding="utf-8")
        return self.judges(verify, f"cat {shlex.quote(str(dump))}")

    def judges(self, verify, command):
        done = subprocess.run([verify, "--operation", self.file, *self.more, *self.proofs, "--dump-command", command],
                              capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1):
            raise SystemExit(f"{self.name}: {done.stderr}")
        return done.returncode == 0, done.stdout


class Asked:
    """Languages whose program asks the look-ups. It reads rows of seven numbers: three of a position, the first mask of inner edges
    and how many there are, the same of ports. `loops` is how it asks one operation, `u` ends a number."""
    u = "u"

    def asked(self, operation):
        rows = [(at["numbers"], 0, 1 << at["before"]["edges"], 0, 1 << at["ports"]) for at in operation.table["positions"]]
        rows += [(at["numbers"], inner, 1, ports, 1) for at, inner, ports in operation.questions_outside()]
        words = [word for numbers, *masks in rows for word in (*numbers, *[0] * (3 - len(numbers)), *masks)]
        at = [f"rows[i + {place}{self.u}]" for place in range(7)]
        call = ", ".join((*at[:len(operation.table["numbers"])], f"{at[3]} + inner", f"{at[5]} + ports"))
        return self.loops.format(size=len(words), rows=", ".join(f"{word}{self.u}" for word in words), call=call, name=operation.identifier,
                                 NAME=operation.identifier.upper())

    def answers(self, folder, scratch, operations):
        source = self.source(operations, "".join(map(self.asked, operations)))
        numbers = [int(word) for word in run(*self.program(source, folder, scratch, *self.flags)).split()]
        self.more_of(source, folder, scratch)
        return [tuple(numbers[i:i + 4]) for i in range(0, len(numbers), 4)]


class C(Asked, language_test.C):
    extension = ".h"
    flags = language_test.C.sanitizers
    loops = """  {{
    static const uint32_t rows[{size}] = {{{rows}}};
    for (uint32_t i = 0; i < {size}u; i += 7u)
      for (uint32_t inner = 0; inner < rows[i + 4u]; ++inner)
        for (uint32_t ports = 0; ports < rows[i + 6u]; ++ports) say(restrip_rule_of_{name}({call}));
  }}
"""

    def source(self, operations, asked):
        headers = "".join(f"#include \"restrip_rule_of_{one.identifier}.h\"\n" for one in operations)
        bodies = "".join(f"#define RESTRIP_RULE_OF_{one.identifier.upper()}_IMPLEMENTATION\n" for one in operations) + headers
        return (f"#include <stdio.h>\n{headers}{bodies}static void say(restrip_operation_rule r) {{\n"
                '  printf("%d %u %u %d\\n", r.valid, (unsigned)r.colors, (unsigned)r.ports, (int)r.strips);\n}\n'
                f"int main(void) {{\n{asked}  return 0;\n}}\n")

    def more_of(self, source, folder, scratch):
        self.taken_as_cpp(scratch / "program.c", folder)
        self.any_arguments("restrip_rule_of_bisect", folder, scratch)


class Rust(Asked, language_test.Rust):
    extension = ".rs"
    u = ""
    flags = ()
    loops = """    let rows: [u32; {size}] = [{rows}];
    for i in (0..{size}).step_by(7) {{
        for inner in 0..rows[i + 4] {{
            for ports in 0..rows[i + 6] {{
                say(restrip_rule_of_{name}::rule({call}).map(|r| (r.colors, r.ports, r.strips)));
            }}
        }}
    }}
"""

    def source(self, operations, asked):
        modules = "".join(f"mod restrip_rule_of_{one.identifier};\n" for one in operations)
        return (f"{modules}const _: () = assert!(restrip_rule_of_split_face::rule(0, 0).is_some());\nfn say(rule: Option<(u32, u32, i32)>) {{\n"
                '    let (c, p, s) = rule.unwrap_or((0, 0, 0));\n    println!("{} {} {} {}", rule.is_some() as u32, c, p, s);\n}\n'
                f"fn main() {{\n{asked}}}\n")

    def more_of(self, source, folder, scratch):
        self.core_alone("restrip_rule_of_bisect", folder, scratch)


class Json(language_test.Json):
    extension = ".json"

    def answers(self, folder, _scratch, operations):
        """Reads the file as docs/how-to/other-languages.md describes."""
        found = []
        for operation in operations:
            table = json.loads((folder / f"restrip_rule_of_{operation.identifier}.json").read_text(encoding="utf-8"))
            for at, inner, ports in (*operation.questions(), *operation.questions_outside()):
                place = next((one for one in table["positions"] if one["numbers"] == at["numbers"]), None)
                if place is None or inner >> place["before"]["edges"] or ports >> place["ports"]:
                    found.append(NONE)
                    continue
                entry = table["entries"][place["first"] + (ports if table["matching"] else inner << place["ports"] | ports)]
                if entry == table["none"]:
                    found.append(NONE)
                    continue
                strips = place["after"]["triangles"] - entry.bit_count() - place["before"]["triangles"] + inner.bit_count() + ports.bit_count()
                found.append((1, entry >> place["ports"], entry & ((1 << place["ports"]) - 1), strips))
        return found


class Shader(Asked):
    """One invocation asks all, of one operation at a time; the look-ups of all are in the program. There is one call in it:
    compilers of shaders put the look-up in place of each."""
    block = None
    extension = ".bin"

    def answers(self, folder, scratch, operations):
        jobs = []
        for operation in operations:
            count = sum(1 for questions in (operation.questions(), operation.questions_outside()) for _ in questions)
            tables = "".join(self.table.format(binding=0 if one is operation else 2 + place, name=one.identifier) for place, one in enumerate(operations))
            *command, shader = self.compiled(tables, self.asked(operation), folder, scratch, operations)
            jobs.append((shader.rename(scratch / f"{operation.identifier}{shader.suffix}"), "words", 2 * count + 1, folder / f"restrip_rule_of_{operation.identifier}.bin"))
        printed = iter(self.printed(command, jobs).split())
        found = []
        for shader, _, words, _ in jobs:
            if next(printed) != "1":
                raise SystemExit(f"{shader}: the checksum of the data is another")
            for _ in range(words // 2):
                flags, masks = int(next(printed)), int(next(printed))
                found.append((flags >> 8, masks >> 8, masks & 255, (flags & 255) - 64))
        return found


class Glsl(Shader, language_test.Glsl):
    table = "layout(std430, set = 0, binding = {binding}) readonly buffer Table{binding} {{ uint restrip_words_of_{name}[]; }};\n"
    loops = """void main() {{
  answers[0] = uint(restrip_words_of_{name}[0] == RESTRIP_CHECKSUM_OF_{NAME});
  uint n = 1u;
  const uint rows[{size}] = uint[{size}]({rows});
  for (uint i = 0u; i < {size}u; i += 7u)
    for (uint inner = 0u; inner < rows[i + 4u]; ++inner)
      for (uint ports = 0u; ports < rows[i + 6u]; ++ports) {{
        restrip_answer_of_{name} r = restrip_rule_of_{name}({call});
        answers[n++] = (uint(r.valid) << 8u) | uint(r.strips + 64);
        answers[n++] = (r.colors << 8u) | r.ports;
      }}
}}
"""

    def compiled(self, tables, asked, folder, scratch, operations):
        includes = "".join(f"#include \"restrip_rule_of_{one.identifier}.glsl\"\n" for one in operations)
        return self.program("#version 450\n#extension GL_GOOGLE_include_directive : require\nlayout(local_size_x = 1) in;\n" + tables +
                            f"layout(std430, set = 0, binding = 1) buffer Answers {{ uint answers[]; }};\n{includes}{asked}", folder, scratch)

    def printed(self, command, jobs):
        return "".join(run(*command, *job) for job in jobs)


class Wgsl(Shader, language_test.Wgsl):
    table = "@group(0) @binding({binding}) var<storage, read> restrip_words_of_{name}: array<u32>;\n"
    loops = """@group(0) @binding(1) var<storage, read_write> answers: array<u32>;
@compute @workgroup_size(1)
fn main() {{
  answers[0] = u32(restrip_words_of_{name}[0] == RESTRIP_CHECKSUM_OF_{NAME});
  var n = 1u;
  var rows = array<u32, {size}>({rows});
  for (var i = 0u; i < {size}u; i += 7u) {{
    for (var inner = 0u; inner < rows[i + 4u]; inner++) {{
      for (var ports = 0u; ports < rows[i + 6u]; ports++) {{
        let r = restrip_rule_of_{name}({call});
        answers[n] = (u32(r.valid) << 8u) | u32(r.strips + 64);
        answers[n + 1u] = (r.colors << 8u) | r.ports;
        n += 2u;
      }}
    }}
  }}
}}
"""

    def compiled(self, tables, asked, folder, scratch, operations):
        return self.program(tables + asked, folder, scratch, *(f"restrip_rule_of_{one.identifier}.wgsl" for one in operations))

    def printed(self, command, jobs):
        """In one browser, which takes long to start; `words` is said once."""
        (shader, *words), *more = jobs
        return run(*command, shader, *words, *(word for shader, _, *job in more for word in (shader, *job)))


LANGUAGES = {"c": C, "json": Json, "rust": Rust, "glsl": Glsl, "wgsl": Wgsl}


def altered(folder, scratch, language):
    """A folder in which the table of bisect has another rule: its first entry is 112, 7 inner edges and no port."""
    other = scratch / "altered"
    other.mkdir(exist_ok=True)
    for file in folder.glob("restrip_*"):
        data = file.read_bytes()
        if file.name == "restrip_rule_of_bisect" + language.extension:
            entry = (112).to_bytes(2, "little") if language.extension == ".bin" else b" 112, 113"
            assert entry in data
            data = data.replace(entry, (96).to_bytes(2, "little") if language.extension == ".bin" else b" 96, 113", 1)
        (other / file.name).write_bytes(data)
    return other


def judge_printed(verify, language, folder, scratch, operations):
    """The programs that the generator writes for a user print what the verifier takes, and of an altered table what it refuses."""
    printed = [operation for operation in operations if operation.name in ("bisect", "merge-matching", "union")]
    for operation, where, expected in (*((operation, folder, True) for operation in printed), (printed[0], altered(folder, scratch, language), False)):
        check = where / f"restrip_check_of_{operation.identifier}{language.check_extension}"
        if language.check_extension == ".mjs":
            command = (language.node, check)
        else:
            command = language.program(check.read_text(encoding="utf-8"), where, scratch)
        if operation.judges(verify, shlex.join(map(str, command)))[0] != expected:
            raise SystemExit(f"{check}: the verifier {'refuses' if expected else 'takes'} what it prints")


def main():
    given = arguments(__doc__, "generate", "verify")
    language = LANGUAGES[given.language](*given.programs)
    folder = given.scratch / "tables"
    numbered = given.scratch / "union.json"
    numbered.write_text(json.dumps(THREE_NUMBERS), encoding="utf-8")
    operations = [Operation(file, given.generate, folder) for file in (*FILES, numbered)]
    answers = language.answers(folder, given.scratch, operations)
    asked = 0
    for operation in operations:
        count = len(list(operation.questions())) + len(list(operation.questions_outside()))
        taken, said = operation.judged(given.verify, answers[asked:asked + count], given.scratch)
        if not taken:
            raise SystemExit(f"{operation.name}: {said}")
        asked += count
    if asked != len(answers) or asked < 8000:
        raise SystemExit(f"{len(answers)} answers, and {asked} of them were looked at")

    if language.check_extension in (".c", ".mjs", ".rs"):
        judge_printed(given.verify, language, folder, given.scratch, operations)

    bisect = [operation for operation in operations if operation.name in ("bisect", "split-face")]
    answers = language.answers(altered(folder, given.scratch, language), given.scratch, bisect)
    if bisect[0].judged(given.verify, answers[:len(answers) - sum(1 for _ in (*bisect[1].questions(), *bisect[1].questions_outside()))], given.scratch)[0]:
        raise SystemExit("the verifier takes an altered table")

    if language.block in ("c", "python"):
        check_example(language, "\n## Custom operations\n", folder, given.scratch)
    print(f"{len(operations)} operations, {asked} answers proved, an altered one refused")


main()
