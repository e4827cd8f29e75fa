#!/usr/bin/env python3
"""Headers compile after the macros that system headers leave defined: those of <windows.h>, min and max
included, X11, curses, <sys/sysmacros.h>, <complex.h>, Qt. No header uses such a name; one program compiles with all of
them defined, and one for Windows after <windows.h>.

usage: system_macros_test.py SOURCE COMPILER SCRATCH"""
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

NAMES = """near far small hyper interface pascal cdecl IN OUT OPTIONAL ERROR CONST VOID TRUE FALSE DELETE STRICT IGNORE INFINITE ABSOLUTE
RELATIVE TRANSPARENT OPAQUE FAR NEAR THIS PURE DOMAIN OVERFLOW UNDERFLOW Yield GetObject CreateWindow GetMessage SendMessage
DrawText major minor makedev unix linux Bool None Status Success True False Always Never Above Below Convex Complex Nonconvex
CursorShape Expose KeyPress ControlMask Unsorted BadRequest GrayScale DirectColor CurrentTime I complex imaginary PI check verify
require nil YES NO signals slots emit foreach forever rad1 rad2""".split()
ROOT, COMPILER, SCRATCH = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
STANDARD = "algorithm array atomic bit compare concepts cstddef cstdint cstdio cstdlib cstring deque functional limits memory mutex new " \
           "numeric optional random span stdexcept string string_view thread tuple type_traits utility variant vector".split()
PROGRAM = """
#include <restrip/restrip.hpp>
int main() {
  restrip::LiveMesh live(std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3}, 4);
  live.flip(live.edge(1, 2));
  return live.update().size() > 4;
}
"""


def used(text):
    text = re.sub(r'"(\\.|[^"\\\n])*"', '""', re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S))
    return set(re.findall(r"\b[A-Za-z_]\w*", text)) & set(NAMES)


def compiled(compiler, name, before):
    SCRATCH.mkdir(parents=True, exist_ok=True)
    source = SCRATCH / name
    source.write_text("".join(f"#include <{header}>\n" for header in STANDARD) + before + PROGRAM)
    includes = [f"-I{ROOT / folder / 'include'}" for folder in ("runtime", "tables")]
    return subprocess.run([compiler, "-std=c++20", "-fsyntax-only", *includes, str(source)], capture_output=True, text=True)


class Macros(unittest.TestCase):
    def test_no_header_uses_such_a_name(self):
        headers = [path for folder in ("runtime", "tables", "bindings/c") for path in (ROOT / folder / "include").rglob("*.h*")]
        self.assertGreater(len(headers), 40)
        for header in headers:
            self.assertEqual(used(header.read_text()), set(), header)
        self.assertEqual(used('int near = far(1);  // small\n"IN"'), {"near", "far"})

    def test_headers_compile_after_all_of_them(self):
        define = "".join(f"#undef {name}\n#define {name}\n" for name in NAMES)
        define += "#define min(a, b) ((a) < (b) ? (a) : (b))\n#define max(a, b) ((a) > (b) ? (a) : (b))\n"
        run = compiled(COMPILER, "macros.cpp", define)
        self.assertEqual(run.returncode, 0, run.stderr[:2000])

    def test_headers_compile_for_windows(self):
        compiler = shutil.which("x86_64-w64-mingw32-g++-posix")
        if compiler is None:
            print("left out: headers for Windows: x86_64-w64-mingw32-g++-posix (package g++-mingw-w64-x86-64) is not there")
            self.skipTest("no compiler for Windows")
        run = compiled(compiler, "windows.cpp", "#include <windows.h>\n")
        self.assertEqual(run.returncode, 0, run.stderr[:2000])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
