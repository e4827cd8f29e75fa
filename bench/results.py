"""Results of benchmarks: JSON files of Google Benchmark's shape, as medians over their repetitions."""
import json
import re
import statistics
import sys


class Results:
    """All benchmarks of a folder by name; a name without what Google Benchmark appends (/iterations:3, /manual_time)."""

    def __init__(self, folder, programs):
        self.runs = {}
        self.context = {}
        for program in programs:
            path = folder / f"{program}.json"
            try:
                text = json.loads(path.read_text())
                entries = text["benchmarks"]
            except (OSError, ValueError, KeyError) as error:
                sys.exit(f"render.py: {path}: {error}; run scripts/performance.sh --only {program}")
            self.context[program] = text.get("context", {})
            # Mixed repetitions come in any order; this is the one in which they were registered.
            for entry in sorted(entries, key=lambda entry: entry.get("family_index", 0)):
                if entry.get("run_type", "iteration") == "iteration":
                    name = re.sub(r"/(iterations:\d+|repeats:\d+|manual_time|process_time)", "", entry["run_name"])
                    self.runs.setdefault(name, []).append(entry)

    def has(self, name):
        return name in self.runs

    def figures(self, name, *fields):
        """One figure for each repetition; of several fields a tuple."""
        try:
            runs = [tuple(run[field] for field in fields) for run in self.runs[name]]
        except KeyError as missing:
            sys.exit(f"render.py: benchmark {name}: {missing} was not recorded; run scripts/performance.sh --only {name.split('/')[0]}")
        return [run[0] for run in runs] if len(fields) == 1 else runs

    def median(self, name, field):
        return statistics.median(self.figures(name, field))

    def ratio(self, name, above, below):
        """The median of the ratios, each of two figures of the same repetition."""
        return statistics.median(a / b for a, b in self.figures(name, above, below))

    def parts(self, pattern):
        """The groups of each name that matches, in the order of the files, each once."""
        found = (re.fullmatch(pattern, name) for name in self.runs)
        return list(dict.fromkeys(match.groups() if match.re.groups > 1 else match.group(1) for match in found if match))


def plain(value, digits=3):
    """A number with about that many significant digits, thousands grouped: 0.0123, 4.56, 789, 12,345."""
    if value == 0:
        return "0"
    decimals = max(0, digits - 1 - len(str(int(abs(value)))) + (1 if abs(value) >= 1 else 0))
    if 0 < abs(value) < 1:
        decimals = digits
    return f"{value:,.{decimals}f}"


def duration(ns):
    """Nanoseconds in the unit that suits them."""
    for limit, unit in ((1e3, "ns"), (1e6, "µs"), (1e9, "ms")):
        if abs(ns) < limit:
            return f"{plain(ns / (limit / 1e3))} {unit}"
    return f"{plain(ns / 1e9)} s"


def times(ratio):
    return f"{ratio:.{2 if ratio >= 0.1 else 3}f}x" if ratio < 10 else f"{ratio:,.0f}x"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join("---" for _ in head) + " |"]
    for row in rows:
        if len(row) != len(head):
            sys.exit(f"render.py: a row of {len(row)} cells under {len(head)} headings: {row}")
        lines.append("| " + " | ".join(str(cell) for cell in row) + " |")
    return "\n".join(lines)
