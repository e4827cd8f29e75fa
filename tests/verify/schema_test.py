"""docs/operation.schema.json and the verifier's reader agree: every operation file that is shipped or in the corpus, families
included, is as the schema says, and of altered ones the schema refuses what the reader refuses, but for what its description says that a
schema cannot.

  schema_test.py SCHEMA VERIFIER SCRATCH STRIDE FILE…
"""
import copy
import itertools
import json
import re
import subprocess
import sys
from pathlib import Path

try:
    import jsonschema  # says whether we read the schema as others do
except ImportError:
    jsonschema = None

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from json_schema import fits

GOOD = {
    "restrip_operation": 1,
    "name": "two",
    "about": "Two triangles.",
    "constraint": "strips",
    "before": [["a", "b", "c"], ["b", "a", "d"]],
    "after": [["c", "a", "d"], ["d", "b", "c"]],
    "give_up": [0, 1],
    "cost": [
        [{"count": "strips", "weight": 2}, {"count": "kept", "ports": [1]}],
        [{"count": "solid", "edges": [0]}, {"count": "ends", "triangles": [0, 1]}, {"count": "ends_at_port"}],
    ],
}
BOUNDARY = GOOD | {
    "boundary": [["b", "c"], ["c", "a"]],
    "give_up": "all",
    "cost": [[{"count": "strips"}]],
}
FAMILY = {
    "restrip_operation": 1,
    "name": "own",
    "certificate": "owns",
    "numbers": ["k", "i"],
    "where": "3 <= k, 1 <= i < k - 1",
    "listed": "2 i <= k",
    "position": "k {k} at {i}",
    "section": "k {k} i {i}",
    "before": [["v", "u[j]", "u[j+1]", "j[0,i)"], ["v", "u[j]", "u[j+1]", "j[i,k)"]],
    "after": [["v", "u[j]", "u[j+1]", "j[0,k)"]],
    "at_most": [{"where": "i = 1", "strips": 1, "isolated": 0}],
}
TURNS = {
    "restrip_operation": 1,
    "name": "turns",
    "numbers": ["n"],
    "where": "n >= 2",
    "boundary": [["u[n]", "u[0]"]],
    "before": [["u[0]", "u[i]", "u[i+1]", "i[1,n)"], ["u[0]", "u[n]", "v"]],
    "after": [["v", "u[i]", "u[i+1]", "i[0,n)"]],
    "give_up": "all",
}
LIST = {"restrip_operation": 1, "operations": [{member: FAMILY[member] for member in ("name", "numbers", "where", "before", "after")}]}
VALUES = [None, True, -1, 0, 1, 2, 3, 8, 9, 16, 17, 1.5, 1000001, "", "none", "all", "strips", "matching", "kept",
          "squares", "two-2", "Two", "a", "v_1", ["a", "b", "c"], ["b", "c"], ["a", "b", "a"], "a--b", "a" * 60, "a" * 61, "One.\nTwo.", "One. \\ two", "One. */", "One. ??/ two", "\u2028", "\ufeffOne.", [], [0], [0, 0], [[0, 1]], {}, [[{"count": "joined"}]],
          [[{"count": "strips"}]] * 9, [[{"count": "strips"}] * 65]]
# The reader's messages about faults that the schema's description leaves to it.
BEYOND = re.compile(r"from 0 to \d+, found \d|one of the \w+s 0 to \d+, found \d|edges and ports of triangle|each edge once|same number of ports as before|"
                    r"expected each|edges and ports together|the same outline|opposite directions|fan|connected over|Euler characteristic|"
                    r"1 to 12 ports|stretches that are apart|on both sides|expected a list of (edges|ports|triangles)s?, found a list|"
                    r"expected a sum of|each number in braces|expected all numbers|has no position|cannot serve both|"
                    r"each triangle once|no triangle is named|three different vertices|expected numbers from 0 to|not both|ring of three|"
                    r"expected an index of|negative index|given by their triangles|1 to 16 triangles|two different|found none \(")


def places(value, path=()):
    """The paths to all values inside."""
    yield path
    inside = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, member in inside:
        yield from places(member, path + (key,))


def all_altered(good):
    """Every value replaced by each of VALUES, every member left out, an unknown one put in."""
    for path in places(good):
        for number in range(len(VALUES) + 2):
            operation = copy.deepcopy(good)
            inside = operation
            for key in path[:-1]:
                inside = inside[key]
            if number < len(VALUES):
                if not path:
                    continue
                inside[path[-1]] = copy.deepcopy(VALUES[number])
            elif number == len(VALUES):
                if not path:
                    continue
                del inside[path[-1]]
            else:
                target = inside[path[-1]] if path else operation
                if not isinstance(target, dict):
                    continue
                target["more"] = 1
            yield operation


def altered(stride):
    """Every `stride`th of the altered files."""
    return itertools.islice(itertools.chain(*map(all_altered, (GOOD, BOUNDARY, FAMILY, TURNS, LIST))), 0, None, stride)


def main():
    schema_file, verifier, scratch, stride, *files = sys.argv[1:]
    schema = json.loads(Path(schema_file).read_text(encoding="utf-8"))
    validator = jsonschema and jsonschema.Draft202012Validator(schema)

    def is_as_it_says(value):
        fit = fits(schema, value, schema)
        if validator and validator.is_valid(value) != fit:
            raise SystemExit(f"{json.dumps(value)}\nis {'' if fit else 'not '}as the schema says, by what is here; jsonschema disagrees")
        return fit

    for file in files:
        if not is_as_it_says(json.loads(Path(file).read_text(encoding="utf-8"))):
            raise SystemExit(f"{file} is not as {schema_file} says")
    path = Path(scratch) / "altered.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    accepted = refused = beyond = 0
    for operation in altered(int(stride)):
        path.write_text(json.dumps(operation), encoding="utf-8")
        # The reader comes first: that this is not a header of a table is another matter, exit code 1.
        done = subprocess.run([verifier, "--operation", path, "--header", "/dev/null"], capture_output=True, text=True, check=False)
        if done.returncode not in (1, 2):
            raise SystemExit(f"{verifier} ended with {done.returncode}: {done.stderr}")
        by_reader, by_schema = done.returncode == 1, is_as_it_says(operation)
        if by_reader and by_schema:
            accepted += 1
        elif not by_reader and not by_schema:
            refused += 1
        elif by_schema and BEYOND.search(done.stderr):
            beyond += 1
        else:
            raise SystemExit(f"{json.dumps(operation)}\nis {'' if by_schema else 'not '}as the schema says; the reader: "
                             f"{done.stderr or 'accepts it'}")
    print(f"{len(files)} files; of altered ones {accepted} accepted, {refused} refused, {beyond} refused by the reader alone")
    if len(files) < 20 or min(accepted, refused, beyond) < 10:
        raise SystemExit("too few to be conclusive")


main()
