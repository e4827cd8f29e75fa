#!/usr/bin/env python3
"""Claim: whatever an operation file says, its header has the same tokens as the header of a plain file, except the name,
and so have the files in other languages; they compile whatever the name. Generator and verifier refuse any other content,
and both refuse the same files. A dump program is not run if its header has any other content.

Of random patches, whole and damaged, both take the same ones, and number triangles, edges and ports alike: the verifier takes the
certificates and headers of all that are taken.

  hostile_operations_test.py BIN COMPILER ROOT
"""
import itertools
import json
import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SEEDS = (7, 2024)
LANGUAGES = ("c++", "c", "rust", "json", "glsl", "wgsl")
FILES_OF_A_SEED = 90
PATCHES_OF_A_SEED = 60
PLAIN = {
    "restrip_operation": 1,
    "name": "plain",
    "about": "A new vertex inside a triangle.",
    "constraint": "strips",
    "before": [["a", "b", "c"]],
    "after": [["a", "b", "m"], ["b", "c", "m"], ["m", "c", "a"]],
}
# What ends lines, comments or strings somewhere, or looks as if it did; and plain words.
PIECES = ["\n", "\r", "\r\n", "\v", "\f", "\0", "\x1b[2K", "\x7f", "\x85", "\u2028", "\u2029", "\u202e", "\u200b", "\ufeff", "\\", "\\\n", "\\u000a",
          "??/", "??/\n", "?", "/", "*", "*/", "/*", "//", "\"", "'", ")json\"", "R\"(", "`", "#", "#include <cstdlib>", "%:", "<%", "{", "}", ";",
          "int owned;", "@name@", "$ENV{HOME}", "${name}", "$(id)", "\u00e9", "\u20ac", "\U0001f600", "\ud7ff", "\ufdd0", "\ufffe", "\U000e0041",
          "a", "word", " ", "  ", "<!--", "-->", "]]>", "*)", "(*", "--", "'''", "\"\"\"", "\t"]
# Keywords, macros, types and library names of the emitted languages, and names of restrip.
NAMES = ["union", "int", "class", "main", "open-rows", "co-await", "split", "flip", "collapse", "automaton", "tables", "tables-check",
         "rule-of", "fn", "self", "vec2", "highp", "unix", "linux", "errno", "assert", "std", "restrict", "noncoherent", "i32", "h", "operation"]
# Sentences that would be read as code somewhere.
ABOUTS = ["The next line belongs to this one \\", "\ufeffHarmless.", "Harmless.\rint owned;", "Harmless. */ int owned; /*", "Harmless.\x1b[2J",
          "Harmless.\fint owned;", "Harmless.\n#include <cstdlib>\ninline const int owned = std::system(\"touch owned\");",
          "Harmless.\u2028int owned;", "Harmless.\x85int owned;", "Harmless.\0int owned;", "Harmless.\u2029int owned;",
          "The next line belongs to this one ??/", "Harmless. \u202etxet denrut", "Harmless.\vint owned;"]
SYLLABLES = ["a", "x2", "bi", "sect", "int", "co", "await", "rule", "of", "open", "split", "static", "cast", "vec2", "i32", "if", "for", "m8"]

# docs/reference/operation-file.md, "Words": code points that no sentence has, first and last.
HIDDEN = [(0, 0x1f), (0x7f, 0x9f), (0xad, 0xad), (0x61c, 0x61c), (0x180e, 0x180e), (0x200b, 0x200f), (0x2028, 0x202e), (0x2060, 0x206f),
          (0xfdd0, 0xfdef), (0xfeff, 0xfeff), (0xfff0, 0xfffb), (0xfffe, 0xffff), (0x1fffe, 0x1ffff), (0xdfffe, 0x10ffff)]


def tokens(text):
    """As a compiler of C++ that is easily deceived sees it: any character that ends a line anywhere does, backslash or
    trigraph and white space before it join lines, comments go."""
    text = re.sub("\r\n|[\r\v\f\x85\u2028\u2029\0]", "\n", text)
    text = re.sub(r"(\\|\?\?/)[ \t]*\n", "", text)
    text = re.sub(r'"(?:[^"\\\n]|\\.)*"|//[^\n]*|/\*.*?\*/', lambda found: found[0] if found[0][0] == '"' else " ", text, flags=re.S)
    return re.findall(r'"(?:[^"\\\n]|\\.)*"|\w+|[^\w\s]', text)


def renamed(words, name):
    """The tokens of the plain file's files with another name."""
    return [re.sub("(?<![a-z])plain(?![a-z])", name, re.sub("(?<![A-Z])PLAIN(?![A-Z])", name.upper(), word)) for word in words]


class Programs:
    def __init__(self, folder, scratch):
        self.folder, self.scratch = folder, scratch

    def generate(self, file, out):
        """What the generator says of the file; empty when it takes it."""
        return self.said([self.folder / "restrip-generate", "rules", "--operation", file, "--out", out,
                          *(f"--language={language}" for language in LANGUAGES)], (0, 2))

    def verify(self, file, *more):
        return self.said([self.folder / "restrip-verify", "--operation", file, *more], (0, 1, 2))

    @staticmethod
    def said(command, codes):
        done = subprocess.run(command, capture_output=True, check=False)
        if done.returncode not in codes:
            raise SystemExit(f"{command} ended with {done.returncode}: {done.stderr!r}")
        if done.returncode != 2:
            return ""
        if not done.stderr:
            raise SystemExit(f"{command} ended with 2 and said nothing")
        return done.stderr.decode("utf-8", "backslashreplace")


def refused_alike(programs, file, out):
    """Whether both programs refuse the file; what they say names file, place and remedy."""
    made, judged = programs.generate(file, out), programs.verify(file, "--header", "/dev/null")
    if bool(made) != bool(judged):
        raise SystemExit(f"{file}: the generator says {made!r}, the verifier {judged!r}")
    for words in (made, judged):
        if words and not re.match(rf"restrip-\w+: {re.escape(str(file))}:\d+:", words):
            raise SystemExit(f"{file}: {words!r} does not name the place")
        if words and any(ord(c) < 32 and c != "\n" for c in words):
            raise SystemExit(f"{file}: {words!r} has control characters")
    return bool(made)


def hostile(random_numbers):
    name = random_numbers.choice(NAMES) if random_numbers.random() < 0.2 else "-".join(
        random_numbers.choice(SYLLABLES) for _ in range(random_numbers.randint(1, 3)))
    if random_numbers.random() < 0.1:
        name += random_numbers.choice(PIECES)
    about = "".join(random_numbers.choice(PIECES) for _ in range(random_numbers.choice((0, 1, 1, 2, 4))))
    return name, "Words. " * random_numbers.randint(0, 1) + about


def turned(triangle, steps):
    return triangle[steps:] + triangle[:steps]


def triangle_at(triangles, a, b):
    """The triangle to the left of the edge from a to b, turned so that the edge is its first; or None."""
    return next((turned(t, s) for t in triangles for s in range(3) if turned(t, s)[:2] == [a, b]), None)


def patch(random_numbers):
    """A disc of triangles, the same after flips and with new vertices, perhaps an edge on the boundary; half of them are damaged."""
    fresh = (f"v{number}" for number in itertools.count())
    any_of = lambda triangles: turned(random_numbers.choice(triangles), random_numbers.randrange(3))
    before = [[next(fresh) for _ in range(3)]]
    for _ in range(random_numbers.randrange(3)):
        a, b, _ = any_of(before)
        if not triangle_at(before, b, a):
            before.append([b, a, next(fresh)])
    after = list(before)
    for _ in range(random_numbers.randrange(3)):
        a, b, c = any_of(after)
        beyond = triangle_at(after, b, a)
        gone = [t for t in after if set(t) == {a, b, c} or (beyond and set(t) == set(beyond))]
        if beyond and random_numbers.random() < 0.5:
            after = [t for t in after if t not in gone] + [[c, a, beyond[2]], [beyond[2], b, c]]
        else:
            inside = next(fresh)
            after = [t for t in after if set(t) != {a, b, c}] + [[a, b, inside], [b, c, inside], [c, a, inside]]
    boundary = [any_of(before)[:2]] if random_numbers.random() < 0.3 else []
    sides = [[turned(list(t), random_numbers.randrange(3)) for t in random_numbers.sample(side, len(side))] for side in (before, after)]
    if random_numbers.random() < 0.5:
        side = random_numbers.choice(sides)
        corners, other = random_numbers.choice(side), random_numbers.choice(side)
        random_numbers.choice((
            lambda: corners.reverse(), lambda: side.remove(corners), lambda: side.append(list(other)),
            lambda: side.append([corners[0], next(fresh), next(fresh)]), lambda: boundary.append([corners[0], other[1]]),
            lambda: corners.__setitem__(random_numbers.randrange(3), random_numbers.choice(other)),
            lambda: corners.__setitem__(random_numbers.randrange(3), random_numbers.choice(("", "not a name")))))()
    return dict(PLAIN, name="patch", give_up="all", before=sides[0], after=sides[1], **({"boundary": boundary} if boundary else {}))


def check_patches(programs, file, out):
    counts = {True: 0, False: 0}
    for seed in SEEDS:
        random_numbers = random.Random(seed)
        for _ in range(PATCHES_OF_A_SEED):
            file.write_text(json.dumps(patch(random_numbers)), encoding="utf-8")
            refused = refused_alike(programs, file, out)
            counts[not refused] += 1
            if not refused:
                programs.said([programs.folder / "restrip-verify", "--operation", file, "--certificate", out / "certificates/operations/patch.cert",
                               "--header", out / "include/restrip/tables/operations/patch.hpp"], (0,))
    print(counts[True], "patches accepted,", counts[False], "refused")
    if min(counts.values()) < 30:
        raise SystemExit("too few to be conclusive")


def main():
    folder, compiler, root = Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3])
    with tempfile.TemporaryDirectory() as scratch_name:
        scratch = Path(scratch_name)
        programs = Programs(folder, scratch)
        file, out = scratch / "operation.json", scratch / "out"
        headers = out / "include/restrip/tables/operations"

        def made_of(name, about):
            """The texts of the files but for the data of shaders, by how their names end; or None when the file is refused."""
            file.write_text(json.dumps(dict(PLAIN, name=name, about=about), ensure_ascii=random_numbers.random() < 0.5), encoding="utf-8")
            if refused_alike(programs, file, out):
                return None
            identifier = name.replace("-", "_")
            header = headers / (identifier + ".hpp")
            if not json.loads(programs_json(header))["verified"]:
                raise SystemExit(f"{name!r}, {about!r}: the verifier does not take the header")
            texts = {other.suffix: other.read_text(encoding="utf-8") for other in (header, *out.glob(f"restrip_rule_of_{identifier}.*")) if other.suffix != ".bin"}
            table = json.loads(texts.pop(".json"))
            if (table["name"], table["about"]) != (name, about):
                raise SystemExit(f"{name!r}, {about!r}: {table['name']!r}, {table['about']!r} in JSON")
            tables.append({member: value for member, value in table.items() if member not in ("name", "about")})
            return texts

        def programs_json(header):
            return subprocess.run([folder / "restrip-verify", "--operation", file, "--header", header, "--json", "-"], capture_output=True, text=True,
                                  check=False).stdout

        tables = []  # of JSON, without its words
        random_numbers = random.Random(0)
        plain = {ending: tokens(text) for ending, text in made_of("plain", PLAIN["about"]).items()}
        counts = {True: 0, False: 0}
        for seed in SEEDS:
            print("seed", seed)
            random_numbers = random.Random(seed)
            for _ in range(FILES_OF_A_SEED):
                name, about = hostile(random_numbers)
                texts = made_of(name, about)
                counts[texts is not None] += 1
                for ending, text in (texts or {}).items():
                    if tokens(text) != renamed(plain[ending], name.replace("-", "_")):
                        raise SystemExit(f"seed {seed}: {name!r}, {about!r}: other tokens:\n{text}")
        if len(plain) != len(LANGUAGES) - 1 or len(tables) != counts[True] + 1 or any(table != tables[0] for table in tables):
            raise SystemExit("there are languages missing, or tables in JSON that differ")
        print(counts[True], "accepted,", counts[False], "refused")
        if min(counts.values()) < 30:
            raise SystemExit("too few to be conclusive")

        # Every name is free.
        for name in NAMES:
            for ending, text in made_of(name, PLAIN["about"]).items():
                if tokens(text) != renamed(plain[ending], name.replace("-", "_")):
                    raise SystemExit(f"{name}: other tokens:\n{text}")

        # All accepted ones compile together with everything shipped, even if unix and linux are macros.
        names = sorted(header.name for header in headers.glob("*.hpp"))
        source = scratch / "all.cpp"
        shipped = sorted((root / "tables/include/restrip/tables").glob("*.hpp"))
        source.write_text("".join(f'#include "restrip/tables/{header.name}"\n' for header in shipped) +
                          "".join(f'#include "{headers / name}"\n' for name in names) + "int main() {}\n", encoding="utf-8")
        subprocess.run([compiler, "-std=gnu++20", "-Wall", "-Wextra", "-Wtrigraphs", "-Wcomment", "-Werror", "-fsyntax-only", "-I",
                        root / "tables/include", source], check=True)
        # So they do in the other languages that have a compiler here, with the tables and the automaton of restrip.
        for what in ("tables", "automaton"):
            programs.said([folder / "restrip-generate", what, *(["--max-k", "4"] if what == "tables" else []), "--language", "c,rust", "--out", out], (0,))
        c_headers = sorted(out.glob("restrip_*.h"))
        source = out / "all.c"
        source.write_text("".join(f"#define {file.stem.upper()}_IMPLEMENTATION\n#include \"{file.name}\"\n" for file in c_headers) +
                          "int main(void) { return 0; }\n", encoding="utf-8")
        subprocess.run([compiler, "-x", "c", "-std=gnu11", "-Wall", "-Wextra", "-Wtrigraphs", "-Wcomment", "-Werror", "-fsyntax-only", source], check=True)
        if shutil.which("rustc"):
            source = out / "all.rs"
            source.write_text("".join(f"mod {file.stem};\n" for file in sorted(out.glob("restrip_*.rs")) if
                                      not file.stem.startswith("restrip_check_of_") and file.stem not in ("restrip_tables_check", "restrip_automaton_check")) + "fn main() {}\n", encoding="utf-8")
            subprocess.run(["rustc", "--edition=2021", "-Dwarnings", "--emit=metadata", "-o", scratch / "all.rmeta", source], check=True)
        if shutil.which("glslangValidator"):
            source = out / "all.comp"
            shaders = [out / f"restrip_rule_of_{name.replace('-', '_')}.glsl" for name in NAMES]
            source.write_text("#version 450\n" + "".join(
                f"layout(std430, set = 0, binding = {place}) readonly buffer Table{place} {{ uint restrip_words_of_{file.stem[16:]}[]; }};\n" +
                file.read_text(encoding="utf-8") for place, file in enumerate(shaders)) + "void main() {}\n", encoding="utf-8")
            subprocess.run(["glslangValidator", "-V", "-o", scratch / "all.spv", source], stdout=subprocess.DEVNULL, check=True)

        check_patches(programs, file, out)

        # Each is refused by both; so are bytes that are not UTF-8, and a byte order mark.
        plain = json.dumps(PLAIN).encode()
        for bad in [json.dumps(dict(PLAIN, about=about)).encode() for about in ABOUTS] + [
                plain.replace(b"A new vertex", b"A new vertex\xc0\x8a"), b"\xef\xbb\xbf" + plain]:
            file.write_bytes(bad)
            if not refused_alike(programs, file, out):
                raise SystemExit(f"{bad!r} is accepted")
        # Every code point at the edge of those that may not be there.
        for code in sorted({code for first, last in HIDDEN for code in (first - 1, first, last, last + 1)} - {-1, 0x110000}):
            file.write_text(json.dumps(dict(PLAIN, about=f"a{chr(code)}b")), encoding="utf-8")
            if refused_alike(programs, file, out) != any(first <= code <= last for first, last in HIDDEN):
                raise SystemExit(f"U+{code:04X} is not taken as docs/reference/operation-file.md says")

        # A header with code in it: the program that was made of it is not run.
        file.write_text(json.dumps(PLAIN), encoding="utf-8")
        if programs.generate(file, out):
            raise SystemExit("the plain file is refused")
        text = (headers / "plain.hpp").read_text(encoding="utf-8")
        mark, bad = scratch / "was-run", scratch / "bad.hpp"
        for altered in (text.replace("#pragma once\n", "#pragma once\ninline const int owned = [] { return 1; }();\n"),
                        text.replace("    {\n", "    {\n    owned(),\n"), text + "int owned;\n", text.replace(" 24,", " 024,", 1),
                        text.replace("    }},\n", "    1, }},\n", 1), ""):
            if altered == text:
                raise SystemExit("an alteration has no effect on the header")
            bad.write_text(altered, encoding="utf-8")
            done = subprocess.run([folder / "restrip-verify", "--operation", file, "--header", bad, "--dump-command", f"touch {mark}"],
                                  capture_output=True, text=True, check=False)
            if done.returncode != 1 or mark.exists() or "was not run" not in done.stdout or f"{bad}:" not in done.stdout:
                raise SystemExit(f"{altered}\n{done.stdout}{done.stderr}")
        subprocess.run([folder / "restrip-verify", "--operation", file, "--header", headers / "plain.hpp", "--dump-command", f"touch {mark}"],
                       capture_output=True, check=False)
        if not mark.exists():
            raise SystemExit("the program of a good header is not run either")
        print(len(names), "headers compiled together")
        if len(names) < 20:
            raise SystemExit("too few to be conclusive")


main()
