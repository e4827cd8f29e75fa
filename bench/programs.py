#!/usr/bin/env python3
"""Times what is run and not called: the generator for each largest valence, the verifier claim by claim, the compilation of the
headers. Writes JSON of Google Benchmark's shape, so that one program renders everything.

Example: bench/programs.py --bin build/release/bin --out build/performance/programs.json
"""
import argparse
import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEADERS = ["restrip/rules/rules.hpp", "restrip/operations/operations.hpp", "restrip/operations/linked.hpp", "restrip/search/keeper.hpp", "restrip/operations/batch.hpp",
           "restrip/restrip.hpp"]


def run(command):
    """Runs a command to its end; returns its processor time in seconds and what it printed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(f"programs.py: {' '.join(map(str, command))} ended with {done.returncode}:\n{done.stderr or done.stdout}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def generator(programs, largest, repeats):
    for k in range(3, largest + 1):
        for _ in range(repeats if k <= 8 else 1):
            with tempfile.TemporaryDirectory() as folder:
                seconds, _ = run([programs / "restrip-generate", "tables", "--max-k", str(k), "--out", folder])
                size = sum(f.stat().st_size for f in Path(folder).glob("certificates/*"))
            yield {"run_name": f"generator/{k}", "seconds": seconds, "certificate_bytes": size}


def verifier(programs, families):
    command = [programs / "restrip-verify", "--tables-dir", ROOT / "tables", "--dump-command", programs / "restrip-dump-tables",
               "--json", "-", "--threads", "1"]
    for family in families:
        command += ["--family", family]
    seconds, text = run(command)
    report = json.loads(text)
    for claim in report["claims"]:
        yield {"run_name": f"verifier/{claim['family']}/{claim['claim']}", "seconds": claim["seconds"], "cases": claim["cases"]}
    yield {"run_name": "verifier/all", "seconds": seconds, "rules": report["rules"]}


def compilation(repeats):
    compilers = [c for c in ("g++", Path(os.environ.get("RESTRIP_CLANG", "clang++")).name) if shutil.which(c)]
    with tempfile.TemporaryDirectory() as folder:
        sources = {}
        for name in ["nothing", "vector"] + HEADERS:
            sources[name] = Path(folder) / (name.replace("/", "_") + ".cpp")
            sources[name].write_text("" if name == "nothing" else f"#include <{name}>\n")
        # By turns, so that a slow moment of the machine strikes all alike.
        for _ in range(repeats):
            for compiler in compilers:
                for name, source in sources.items():
                    seconds, _ = run([compiler, "-std=c++20", "-fsyntax-only", "-I", ROOT / "runtime/include", "-I",
                                      ROOT / "tables/include", source])
                    yield {"run_name": f"compile/{compiler}/{name}", "seconds": seconds}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, required=True, help="the folder of restrip-generate, restrip-verify, restrip-dump-tables")
    parser.add_argument("--out", type=Path, required=True, help="the JSON file to write")
    parser.add_argument("--quick", action="store_true", help="small valences, one small family, one repetition")
    given = parser.parse_args()
    entries = []
    parts = [generator(given.bin, 4 if given.quick else 9, 1 if given.quick else 3),
             verifier(given.bin, ["flip"] if given.quick else []), compilation(1 if given.quick else 5)]
    for part in parts:
        for entry in part:
            print(f"{entry['run_name']}: {entry['seconds']:.2f} s", flush=True)
            entries.append({"name": entry["run_name"], **entry})
    partial = given.out.with_name(given.out.name + ".partial")
    partial.write_text(json.dumps({"context": {}, "benchmarks": entries}, indent=1) + "\n")
    os.replace(partial, given.out)


if __name__ == "__main__":
    main()
