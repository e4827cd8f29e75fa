#!/usr/bin/env python3
"""Runs clang-tidy over every room but the tests.

Nearly all of its time goes into headers, ours and the system's, so the sources of a room are one unit: build/tidy/rooms has a file
for each room that includes them all, with the flags of its targets (preset tidy, where nothing is built). In such a unit two
sources share their unnamed namespaces: names there differ within a room. What each program defines for itself, `main` and
`register_benchmarks`, is renamed in each.
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "tidy"
ROOMS = ["bindings", "common", "examples", "generator", "runtime", "tools", "bench", "verify", "web"]
OF_EACH_PROGRAM = ["main", "register_benchmarks"]
# They include tables that only a build makes.
LEFT_OUT = ["examples/own_operation.cpp", "examples/own_family.cpp", "examples/own_cost.cpp"]


def fail(message):
    sys.exit(f"tidy.py: {message}")


def flags_of(command):
    """The arguments of a compile command that say how, not what; an option and its argument as one."""
    words = iter(shlex.split(command)[1:])
    for word in words:
        if word in ("-o", "-c"):
            next(words)
        elif word in ("-isystem", "-include"):
            yield (word, next(words))
        else:
            yield (word,)


def sources_of(unit):
    """The sources that a unit of CMake's includes, or the unit itself."""
    if "Unity" not in unit.parts:
        return [unit]
    return [pathlib.Path(source) for source in re.findall(r'^#include "(.*)"$', unit.read_text(), re.MULTILINE)]


def room_units():
    """By the name of a unit: its flags and its sources. A source that CMake keeps out of the units of its target stays alone."""
    units = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        for source in sources_of(pathlib.Path(entry["file"])):
            if source.suffix != ".cpp" or not source.is_relative_to(ROOT):
                continue
            place = source.relative_to(ROOT)
            if str(place) in LEFT_OUT:
                continue
            room = "_".join(place.parts[:2]) if place.parts[0] == "bindings" else place.parts[0]
            alone = source == pathlib.Path(entry["file"]) and f"{room}_{source.stem}"
            flags, sources = units.setdefault(alone or room, ({}, {}))
            flags.update(dict.fromkeys(flags_of(entry["command"])))
            sources[place] = None
    return {name: (list(flags), list(sources)) for name, (flags, sources) in units.items()}


def write_units(units, folder):
    folder.mkdir(exist_ok=True)
    commands = []
    for name, (flags, sources) in units.items():
        text = ""
        for number, source in enumerate(sources):
            text += "".join(f"#define {word} {word}_{number}\n" for word in OF_EACH_PROGRAM)
            text += f'#include "{ROOT / source}"\n' + "".join(f"#undef {word}\n" for word in OF_EACH_PROGRAM)
        unit = folder / f"{name}.cpp"
        unit.write_text(text)
        # A main without a return at its end is not a main here; the compilers check other functions.
        arguments = ["clang++", *(word for flag in flags for word in flag), "-Wno-return-type", "-c", str(unit)]
        commands.append({"directory": str(BUILD), "file": str(unit), "arguments": arguments})
    (folder / "compile_commands.json").write_text(json.dumps(commands, indent=1))
    return [pathlib.Path(command["file"]) for command in commands]


def clean(tidy, unit):
    run = subprocess.run(
        [tidy, "--quiet", "--checks=-bugprone-suspicious-include", "-p", str(unit.parent), str(unit)],
        capture_output=True, text=True)
    if run.returncode != 0:
        print(run.stdout + run.stderr, file=sys.stderr)
    return run.returncode == 0


def main():
    os.chdir(ROOT)
    # Other versions have other warnings.
    version = re.search(r"version (\d+)", pathlib.Path(".clang-format").read_text())[1]
    tidy = sys.argv[1] if len(sys.argv) > 1 else f"clang-tidy-{version}"
    if not shutil.which(tidy):
        fail(f"{tidy} is not installed; call it as tidy.py PROGRAM if it has another name")
    subprocess.run(["cmake", "--preset", "tidy"], check=True, stdout=subprocess.DEVNULL)
    listed = subprocess.run(["git", "ls-files", *(f"{room}/*.cpp" for room in ROOMS), ":!verify/formal",
                             ":!web/maker/module",  # for WebAssembly's compiler alone
                             *(f":!{source}" for source in LEFT_OUT)],
                            check=True, capture_output=True, text=True).stdout.split()
    units = room_units()
    read = {str(source) for _, sources in units.values() for source in sources}
    for source in listed:
        if source not in read:
            fail(f"no unit has {source}")
        # The check of included sources, which units must do without.
        if re.search(r'^ *# *include.*\.cpp[">]', pathlib.Path(source).read_text(), re.MULTILINE):
            fail(f"{source} includes a source")
    # The largest first, so that all processors finish together.
    by_size = sorted(write_units(units, BUILD / "rooms"),
                     key=lambda unit: -sum(source.stat().st_size for source in units[unit.stem][1]))
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        if not all(list(pool.map(lambda unit: clean(tidy, unit), by_size))):
            fail("see above")
    print(f"clang-tidy: {len(listed)} sources in {len(by_size)} units")


if __name__ == "__main__":
    main()
