#!/usr/bin/env python3
"""Claims: the program behaves as documented: exit codes, JSON keys, files written whole or not at all, working examples; every
command reports counts in correct English, with a singular for one.

    program_test.py restrip SCRATCH [DIVISOR]

Of the large meshes every test takes one DIVISOR-th: usually a quarter shows the same.
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import unittest

PROGRAM, SCRATCH = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
DIVISOR = int(sys.argv[3]) if len(sys.argv) > 3 else 1


class Folder(unittest.TestCase):
    """Each test in its own folder, where commands run. Output is text of one character a byte."""
    maxDiff = None

    def setUp(self):
        self.folder = SCRATCH / self.id().rpartition("__main__.")[2]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.addCleanup(shutil.rmtree, self.folder)

    def run_with(self, arguments, errors=False):
        """Exit code and standard output, followed by standard error if `errors`. The arguments are words in one text, or a list."""
        words = shlex.split(arguments) if isinstance(arguments, str) else arguments
        done = subprocess.run([PROGRAM, *words], cwd=self.folder, stdout=subprocess.PIPE, check=False,
                              stderr=subprocess.STDOUT if errors else subprocess.DEVNULL)
        return done.returncode, done.stdout.decode("latin-1")

    def shell(self, command):
        """Exit code and standard output of a shell command, in which $restrip is the program."""
        done = subprocess.run(["sh", "-c", command], cwd=self.folder, env={**os.environ, "restrip": PROGRAM},
                              stdout=subprocess.PIPE, check=False)
        return done.returncode, done.stdout.decode("latin-1")

    def done(self, arguments):
        """Standard output of a command that succeeds."""
        code, out = self.run_with(arguments)
        self.assertEqual(code, 0, arguments)
        return out

    def report(self, arguments):
        return json.loads(self.done(arguments + " --json -"))

    def refuses(self, arguments, said):
        """Exit code 2, and one line that says this."""
        code, out = self.run_with(arguments, errors=True)
        self.assertEqual(code, 2, (arguments, out))
        self.assertEqual(out.find("\n"), len(out) - 1, out)
        self.assertIn(said, out, arguments)

    def put(self, name, content):
        (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def contents(self):
        """Every file below the folder with its bytes; links with where they lead."""
        return {path.relative_to(self.folder): os.readlink(path) if path.is_symlink() else path.is_file() and path.read_bytes()
                for path in self.folder.rglob("*")}


class Commands(Folder):
    def test_help_and_version(self):
        self.assertTrue(self.done("--version").startswith("restrip "))
        for command in ("", "stats", "replay", "simplify", "convert", "make-mesh", "stripify", "bake", "draw", "paper"):
            self.assertIn("Example: restrip ", self.done(command + " --help"), command)
            self.assertEqual(self.done(command + " --version"), self.done("--version"))
        described = [line.split(":")[0].strip() for line in self.done("replay --help").splitlines()]
        for policy in ("rules", "local", "quick", "full", "baked", "paper"):
            self.assertEqual(described.count(policy), 1, policy)

    def test_misspelt_values_are_named(self):
        for arguments, said in {"replay --built-in --policy quik": "--policy: quik is not a value; there are rules, local, quick, full, ",
                                "stripify x.obj --effort fas": "there are fast, full, best and file", "stripify x.obj --cost index": "there are strips and indices",
                                "convert x.obj -o x --to glbb": "glbb is not a value; there are ", "simplfy x.obj": "unknown subcommand 'simplfy'; there are stats, replay, simplify, "}.items():
            code, out = self.run_with(arguments, errors=True)
            self.assertEqual(code, 2)
            self.assertIn(said, out)

    def test_wrong_usage_is_two(self):
        for command, wrong in {
                "": ("", "fly"),
                "stats": ("", "/no/such/mesh.obj"),
                "replay": ("", "x.obj --built-in"),
                "replay --built-in": ("--base 0", "--boundary melt", "--levels 1", "--policy better", "--states 9",
                                      "--states 9 --policy local", "--tie-break indices", "--policy full --tie-break beauty",
                                      "--policy quick --tie-break indices", "--policy rules --cost indices",
                                      "--policy baked --cost indices", "--cost swaps"),
                "stripify x.obj": ("--effort some", "--cost bytes", "--limit 9", "--effort best --limit 0", "--effort full --seed 2",
                                   "--cost indices --seed 2", "--effort full --cost indices --seed -1"),
                "draw": ("-o /no/such/folder/a.json",),
                "make-mesh": ("-o /no/such/folder/a.obj", "--triangles 5 -o a.obj")}.items():
            for options in wrong:
                self.assertEqual(self.run_with(f"{command} {options}")[0], 2, (command, options))

    def test_bad_numbers_are_named(self):
        for command, wrong in {
                "replay --built-in": ("--base nan", "--walk -1", "--base -1", "--base 1e999", "--levels 1e3", "--cycles -1", "--walk x",
                                      "--walk 5 --seed -1", "--policy full --states 0", "--triangles 99999999999999999999"),
                "make-mesh -o x.obj": ("--triangles -5", "--seed 99999999999999999999"),
                "bake x.pm -o x.baked": ("--effort 0",)}.items():
            for options in wrong:
                code, out = self.run_with(f"{command} {options}", errors=True)
                self.assertEqual(code, 2, (command, options))
                self.assertIn("-5" if "-5" in options else options.split()[-2], out)
        code, out = self.run_with("replay --built-in --base 2", errors=True)
        self.assertEqual(code, 2)
        self.assertIn("2 is not a share of the triangles; give a number above 0 and at most 1", out)

    def test_full_circle(self):
        self.done("make-mesh --triangles 2000 -o a.ply")
        stats = self.report("stats a.ply")
        self.assertEqual(stats["genus"], 1)
        self.done("simplify a.ply --base 0.1 -o a.pm")
        code, out = self.run_with("replay a.pm --policy local --cost strips --repeats 1 --cycles 2 --walk 500 --seed 9 --json -", True)
        self.assertEqual(code, 0)
        replay = json.loads(out)  # and nothing else on either stream: silent in a pipe
        self.assertEqual(replay["triangles"], stats["triangles"])
        self.assertEqual(replay["walk"]["seed"], 9)
        self.assertEqual(len(replay["cycles"]), 2)

    def built_in(self, triangles, policy, cost, more=""):
        """The report of a replay of the built-in mesh."""
        return self.report(f"replay --built-in --triangles {triangles // DIVISOR} --repeats 0 --policy {policy} --cost {cost} {more}")

    def test_larger_searches_keep_fewer_strips(self):
        few, usual, many = (self.built_in(20000, "quick", "strips", states)["levels"][-1]["strips"]
                            for states in ("--states 10", "", "--states 200"))
        self.assertGreater(few, usual)
        self.assertLess(many, usual)

    def test_policies_keep_longer_strips(self):
        local, quick, full = (self.built_in(6000, policy, "strips", "--cycles 1")["levels"][-1]["strips"]
                              for policy in ("local", "quick", "full"))
        self.assertLess(5 * quick, local)
        self.assertLess(full, quick)

    def expect_indices_add_up(self, counts):
        self.assertEqual(counts["indices"], counts["triangles"] + 3 * counts["strips"] + counts["swaps"] - 1)

    def test_replays_keep_indices_few_where_they_are_the_cost(self):
        def indices_per_triangle(policy, cost):
            replay = self.built_in(6000, policy, cost)
            self.assertEqual(replay["cost"], cost)
            self.assertEqual(len(replay["levels"]), len(replay["levels_down"]))
            levels = replay["levels"] + replay["levels_down"]
            for level in levels:
                self.expect_indices_add_up(level)
            return max(level["indices"] / level["triangles"] for level in levels if level["triangles"] > 1000)

        for policy, at_most in (("local", 1.55), ("quick", 1.42), ("full", 1.36)):
            indices = indices_per_triangle(policy, "indices")
            self.assertLess(indices, at_most, policy)
            self.assertLess(indices, indices_per_triangle(policy, "strips") * 0.95, policy)

    def test_stripify_counts_strips(self):
        self.done("make-mesh --triangles 4000 -o a.off")
        fast = self.report("stripify a.off --cost strips")
        full = self.report("stripify a.off --cost strips --effort full")
        self.assertTrue(fast["valid"] and full["valid"])
        self.assertNotIn("lower_bound_indices", fast)  # only --bound computes it
        self.assertLess(full["strips"], fast["strips"])
        self.assertLessEqual(full["strips"], 2)
        # n triangles, two more indices a strip, one restart between two strips, one for each swap.
        self.assertGreaterEqual(full["indices"], 4000)

    def test_stripify_reports_the_cost_of_indices(self):
        self.done("make-mesh --triangles 2000 -o a.off")

        def stripified(options):
            report = self.report("stripify a.off --bound " + options)
            self.assertTrue(report["valid"])
            self.expect_indices_add_up(report)
            self.assertGreaterEqual(report["indices"], report["lower_bound_indices"])
            self.assertGreater(report["lower_bound_indices"], report["triangles"])
            self.assertGreaterEqual(report["acmr"], 0.5)  # a closed mesh has half as many vertices as triangles
            self.assertLessEqual(report["acmr"] * report["triangles"], report["indices"])
            for key in ("seconds", "seconds_to_build", "seconds_to_order", "seconds_to_write"):
                self.assertGreaterEqual(report.pop(key), 0)
            return report

        strips = stripified("--effort full --cost strips")
        fast = stripified("")
        self.assertEqual(fast, stripified("--effort fast --cost indices"))
        full = stripified("--effort full --cost indices")
        self.assertEqual(full, stripified("--effort full --cost indices --seed 1"))
        best = stripified("--effort best --cost indices --limit 300")
        self.assertLess(full["indices"], fast["indices"])
        self.assertLess(full["indices"], strips["indices"])
        self.assertLess(strips["strips"], full["strips"])
        self.assertLessEqual(best["indices"], full["indices"])

    def test_stripify_for_a_vertex_cache(self):
        self.done("make-mesh --triangles 2000 -o a.off")
        plain = self.report("stripify a.off")
        for size, key in (16, "acmr"), (32, "acmr_32"):
            light, usual, heavy = (self.report(f"stripify a.off --cache {size}{weight}")
                                   for weight in (" --cache-weight 0.1", "", " --cache-weight 20"))
            for report in light, usual, heavy:
                self.assertTrue(report["valid"])
                self.expect_indices_add_up(report)
            self.assertLess(usual[key], 0.9 * plain[key])
            self.assertLess(light["indices"], 1.01 * usual["indices"])  # ties of the search move it by a fraction
            self.assertLess(usual["indices"], heavy["indices"])

    def test_baked_strips_are_played(self):
        self.done("make-mesh --triangles 3000 -o a.ply")
        made = self.report("bake a.ply --base 0.1 -o a.baked")
        self.assertEqual(made["most_strips"], 1)
        self.assertEqual(made["bytes"], len(self.bytes_of("a.baked")))
        # A baked mesh is played by default; its mesh can also be replayed by the rules, or baked again.
        for policy in ("", "--policy baked", "--policy local"):
            replay = self.report("replay a.baked --repeats 1 " + policy)
            self.assertEqual(replay["triangles"], made["triangles"])
            baked = policy != "--policy local"
            self.assertEqual("baked" in replay, baked)
            self.assertEqual(replay["most_strips"] == 1, baked)
            if baked:
                self.assertEqual(replay["policy"], "baked")
                self.assertEqual(replay["baked"]["levels_compared"], 2 * len(replay["levels"]))
        self.done("bake a.baked -o b.baked")
        self.done("stats a.baked")
        self.done("replay --built-in --triangles 1000 --repeats 0 --policy baked")
        self.put("a.baked", self.bytes_of("a.baked")[:-1])
        code, out = self.run_with("replay a.baked", errors=True)
        self.assertEqual(code, 2)
        self.assertIn("truncated or altered", out)

    def test_an_output_that_is_not_a_file_is_written_to(self):
        self.put("target", "old")
        (self.folder / "link.json").symlink_to("target")
        self.done("replay --built-in --triangles 500 --repeats 0 --json link.json")
        self.assertTrue((self.folder / "link.json").is_symlink())
        self.assertTrue(json.loads(self.bytes_of("target"))["valid"])
        # A pipe: the output arrives, and the pipe still exists.
        self.assertTrue(self.done("replay --built-in --triangles 500 --repeats 0 --json /dev/stdout").startswith("{"))

    def test_json_has_its_keys(self):
        self.done("replay --built-in --triangles 3000 --policy local --cost strips --repeats 1 --json a.json")
        replay = json.loads(self.bytes_of("a.json"))
        for key in ("triangles", "operations", "operations_without_rule", "operations_isolating", "operations_adding_strip", "by_valence",
                    "levels", "ns_per_operation", "ns_per_operation_bare", "valid", "triangles_per_strip", "left_out"):
            self.assertIn(key, replay)
        self.assertGreaterEqual(len(replay["levels"]), 10)
        for key in ("triangles", "strips", "isolated", "indices"):
            self.assertIn(key, replay["levels"][0])
        self.assertIs(replay["valid"], True)

    def test_live_buffers_are_measured(self):
        def replayed(options):
            return self.report("replay --built-in --triangles 3000 --repeats 0 --walk 1000 " + options)

        plain = replayed("")
        text = self.done("replay --built-in --triangles 3000 --repeats 0 --walk 1000")
        for report, states in (plain, ["base", "finest level", "base again"]), (plain["walk"], ["start", "end"]):
            self.assertEqual([buffer["operations_per_update"] for buffer in report["live_buffers"]], [1, 100])
            for buffer in report["live_buffers"]:
                self.assertEqual([state["at"] for state in buffer["states"]], states)
                self.assertIn("ns_per_update", buffer)
                self.assertIn("ns_per_update_with_history", buffer)
                self.assertIn(f"{buffer['bytes_per_operation']:.0f} bytes an operation", text)
                for state in buffer["states"]:
                    self.assertGreaterEqual(state["indices"], state["strip_indices"])
                    self.assertGreaterEqual(state["acmr"], state["acmr_32"])
                    self.assertRegex(text, f"{state['at']} +{state['triangles']} +{state['indices']} .*{state['acmr']:.3f} +{state['acmr_32']:.3f}")
        one = replayed("--operations-per-update 7")
        self.assertEqual(len(one["live_buffers"]), 1)
        self.assertEqual(one["walk"]["live_buffers"][0]["operations_per_update"], 7)
        for wrong in ("--operations-per-update 0",):
            code, out = self.run_with("replay --built-in --repeats 0 " + wrong, errors=True)
            self.assertEqual(code, 2)
            self.assertIn(wrong.replace(" ", ": "), out)


class Meshes(Folder):
    """A mesh in three formats."""

    def setUp(self):
        super().setUp()
        self.done("make-mesh --triangles 500 -o a.obj")
        self.done("simplify a.obj -o a.pm")
        self.done("bake a.pm -o a.baked")

    def test_simplifying_what_is_progressive_is_refused(self):
        for name in ("a.pm", "a.baked"):
            for arguments in (f"replay {name} --base 0.5", f"replay {name} --boundary lock", f"bake {name} --base 0.5 -o b.baked"):
                self.refuses(arguments, "--base and --boundary do not apply")

    def test_levels_are_read_wherever_a_mesh_is(self):
        # Where a mesh is expected, a progressive or baked one stands for its finest level.
        for arguments in ("stats {}", "stripify {} -o out.ply", "convert {} -o out.ply", "simplify {} --base 0.5 -o out.ply",
                          "stats {} --weld"):
            wanted, *found = (self.report(arguments.format(name))["triangles"] for name in ("a.obj", "a.pm", "a.baked"))
            self.assertEqual(found, [wanted, wanted], arguments)
        self.assertIn("a.pm (its finest level)", self.done("stats a.pm"))

    def test_an_input_is_never_an_output(self):
        (self.folder / "link.pm").symlink_to("a.obj")
        (self.folder / "report").mkdir()
        for mesh, other in (("a.obj", "hard.svg"), ("a.pm", "hard.baked"), ("a.obj", "hard.json"), ("a.obj", "report/report.json")):
            os.link(self.folder / mesh, self.folder / other)
        before = self.contents()
        for arguments in ("simplify a.obj -o a.obj", "simplify a.obj -o link.pm", "bake a.pm -o hard.baked",
                          f"bake a.baked -o '{self.folder}/a.baked'", "draw a.obj -o hard.json", "draw a.obj -o hard.svg",
                          "replay a.obj --json hard.json", "paper a.obj --out report"):
            self.refuses(arguments, "is the input")
        self.assertEqual(self.contents(), before)

    def test_no_file_is_written_twice(self):
        # For every subcommand: no output is another output, nor a file that the input names.
        self.put("x.gltf", json.dumps({
            "asset": {"version": "2.0"}, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "x.bin"}]}))
        self.put("x.bin", struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0))
        os.link(self.folder / "x.bin", self.folder / "hard.json")
        (self.folder / "link.json").symlink_to("new.json")
        buffer = self.bytes_of("x.bin")
        for arguments in ("stripify x.gltf -o x.bin", "convert x.gltf -o x.bin", "stats x.gltf --json hard.json",
                          "simplify x.gltf -o x.bin", "replay x.gltf -o x.bin", "bake x.gltf -o b.baked --json hard.json",
                          "draw x.gltf -o hard.json", "paper x.gltf --out report --json hard.json"):
            self.refuses(arguments, "is the input")
        for arguments in ("draw -o new.json --json new.json", f"draw -o new.json --json '../{self.folder.name}/new.json'",
                          "draw -o new.json --json link.json", "paper a.obj --out report --json report/report.json",
                          "replay a.pm --trace /dev/stdout --json -"):
            self.refuses(arguments, "as well")
        self.assertEqual(self.bytes_of("x.bin"), buffer)
        self.assertFalse((self.folder / "new.json").exists())

    def test_pipes_are_read_and_written(self):
        # Pipes have no name: the format is detected from the first bytes, for every readable format, or named by the user.
        self.done("stripify a.obj -o a.glb")
        for to in ("off", "ply", "stl"):
            self.done(f"convert a.obj -o a.{to}")
        triangles = self.report("stats a.obj")["triangles"]
        for name in ("a.obj", "a.off", "a.ply", "a.stl", "a.glb", "a.pm", "a.baked"):
            for command in (f"$restrip stats - --json - < {name}", f"cat {name} | $restrip stats /dev/stdin --json -",
                            f"cp {name} bare; $restrip stats bare --json -"):
                self.assertEqual(json.loads(self.shell(command)[1])["triangles"], triangles, command)
        obj = self.bytes_of("a.obj").decode()
        for command in ("$restrip convert a.obj -o - --to off 2>/dev/null | $restrip convert - -o - --to obj 2>/dev/null",
                        "$restrip make-mesh --triangles 500 -o - --to obj 2>/dev/null",
                        "cp a.off a.txt; $restrip convert a.txt --from off -o same --to obj > text && cat same"):
            self.assertEqual(self.shell(command)[1], obj, command)
        self.assertTrue(self.done("draw a.obj -o - --to svg").startswith("<svg"))
        # Standard output contains only the file written there.
        self.assertEqual(self.done("bake a.pm -o -").encode("latin-1"), self.bytes_of("a.baked"))
        self.refuses("convert a.obj -o -", "name it by --to")
        self.refuses("convert a.obj -o b.off --to obj", "has the extension")

    def test_an_output_is_of_its_format(self):
        for arguments, out in (("simplify a.obj -o", "b.off"), ("convert a.obj -o", "b.xyz"), ("bake a.pm -o", "b.pm"),
                               ("draw -o", "x.gif"), ("make-mesh -o", "x.xyz"), ("make-mesh -o", "x"),
                               ("replay --built-in --json", "b.baked")):
            self.refuses(f"{arguments} {out}", "has the extension")
            self.assertFalse((self.folder / out).exists())

    def test_outputs_are_tested_before_the_work(self):
        # So a bad output is reported even if the input is at fault as well.
        (self.folder / "folder.pm").mkdir()
        for arguments, said in (
                ("simplify none.obj -o none/b.pm", "does not exist; make it first"),
                ("simplify none.obj -o folder.pm", "it is a folder; name a file inside it"),
                ("simplify none.obj -o a.pm/b.pm", "Not a directory"),
                ("bake none.pm -o none/b.baked", "does not exist; make it first"),
                ("draw none.obj -o none/draw.json", "does not exist; make it first"),
                ("replay none.obj --json none/b.json", "does not exist; make it first"),
                ("replay none.obj --json /proc/self/b.json", "name a file in a folder that you may write to"),
                ("paper none.obj --out a.obj", "Not a directory; name a file in a folder"),
                ("paper none.obj --out /proc/self/report", "name a folder that you may write to")):
            self.refuses(arguments, said)

    def test_inputs_that_cannot_be_read_are_named(self):
        self.put("bad.obj", "v 0 0 1e300\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        whole = self.bytes_of("a.pm")
        self.put("nan.pm", whole[:20] + struct.pack("<f", float("nan")) + whole[24:])
        (self.folder / "folder.obj").mkdir()
        self.put("what", "what is this?\n")
        pictures = {"photo.png": b"\x89PNG\r\n\x1a\n\0\0", "photo.jpeg": b"\xff\xd8\xff\xe0 JFIF", "photo.GIF": b"GIF89a",
                    "photo.webp": b"RIFF\x10\0\0\0WEBPVP8 ", "photo": b"\x89PNG\r\n\x1a\n\0\0"}
        for name, start in pictures.items():
            self.put(name, start)
        for name in ("zero.xyz", "zero.obj"):
            (self.folder / name).symlink_to("/dev/zero")
        # A line of many megabytes, and a file of a terabyte: both are sparse and take no room on the disk.
        for name, size in (("line.off", 65 << 20), ("huge.ply", 1 << 40)):
            self.put(name, "")
            os.truncate(self.folder / name, size)
        for arguments, said in (
                ("stats none.obj", "none.obj: no such file; check the path"),
                ("stats folder.obj", "folder.obj: is a directory; name a file inside it"),
                (f"stats '{self.folder}'", "is a directory"),
                ("stats bad.obj", "bad.obj:1: vertex 0 has a coordinate that is infinite or not a number; mend or remove it"),
                ("stats nan.pm", "vertex 0 has a coordinate that is infinite or not a number"),
                ("stats zero.xyz", "unknown extension '.xyz'; name the format by --from"),
                ("stats zero.obj", "larger than 256 MiB, the limit"),
                ("stats /dev/null", "the file is empty"),
                *((f"stats {name}", "a picture, which has no triangles; give a mesh: .obj") for name in pictures),
                ("stats what", "neither its name nor how it begins says what it is; name the format by --from"),
                ("stats line.off", "line.off:1: a line of more than 64 MiB, the limit"),
                ("stats huge.ply", "huge.ply: is larger than 16 GiB, the limit for a file"),
                ("replay none.pm", "none.pm: no such file"),
                ("bake none.baked -o b.baked", "none.baked: no such file"),
                ("paper none.obj --out report", "none.obj: no such file")):
            self.refuses(arguments, said)
        self.assertFalse((self.folder / "report").exists())  # created by the test of the output, and removed again

    def test_meshes_that_no_trace_can_record_are_refused(self):
        points = "".join(f"v {x} {x * x} {x * x * x}\n" for x in range(5))
        for faces, edges in {"f 1 2 3\nf 2 1 4\nf 1 2 5\n": "1 edge", "f 1 2 3\nf 1 2 4\n": "1 edge",
                             "f 1 2 3\nf 1 2 3\n": "3 edges"}.items():
            self.put("a.obj", points + faces)
            self.refuses("replay a.obj --trace a.trace", f"a.obj: {edges} of more than two triangles")
            self.assertFalse((self.folder / "a.trace").exists())
            self.done("replay a.obj --repeats 0")

    def test_a_full_disk_leaves_the_target_alone(self):
        self.put("old.json", "mine")
        (self.folder / "link.json").symlink_to("old.json")
        before = self.contents()
        # The limit on file sizes, at most a kilobyte, simulates a full disk.
        for name in ("old.json", "link.json"):
            code, out = self.shell(f"ulimit -f 1; $restrip replay --built-in --triangles 500 --repeats 0 --json {name} 2>&1")
            self.assertEqual(code, 2)
            self.assertIn("cannot be written: File too large", out)
        self.assertEqual(self.contents(), before)

    def test_a_progressive_mesh_that_does_not_fit_is_named(self):
        self.put("bad.pm", self.bytes_of("a.pm")[:-4] + b"\1\0\0\0")
        for arguments in ("draw bad.pm -o b.svg", "bake bad.pm -o b.baked", "stats bad.pm", "convert bad.pm -o b.obj",
                          "replay bad.pm --policy baked"):
            self.refuses(arguments, "bad.pm: split ")
        code, out = self.run_with("replay bad.pm")
        self.assertEqual(code, 1)
        self.assertIn("FAULT", out)

    def test_messages_are_plain_and_short(self):
        # A terminal executes some bytes, and a line of a megabyte is unreadable.
        self.put("bad.ply", b"ply\nformat \033[2J\xc2\x9b1m\xff\n")
        name = "\033]0;x\a".ljust(100_000, "n")
        self.put("long.gltf", f'{{"asset":{{"version":"2.0"}},"extensionsRequired":[{{"{name}":1}}]}}')
        self.put("long.ply", f"ply\nformat ascii 1.0\nelement vertex 1\nproperty float {name}\nelement face 1\n"
                             f"property list uchar int {name}\nend_header\n0\n9\n")
        for arguments in ("stats bad.ply", "stats long.gltf", "stats long.ply", ["stats", "\033[31m.obj"],
                          ["stats", "--json", "\033[31m", "a.obj"], ["stats", "--\033[31m"]):
            code, out = self.run_with(arguments, errors=True)
            self.assertEqual(code, 2, arguments)
            self.assertLess(len(out), 2000, arguments)
            for raw in ("\033", "\a", "\xc2\x9b", "\xff"):
                self.assertNotIn(raw, out, arguments)
        self.refuses("stats bad.ply", r"\x1b[2J\xc2\x9b1m\xff")


# "1 strips", "1 degenerate triangles", "1 vertices lie".
PLURAL_OF_ONE = re.compile(r"(?:^|[^\d.,])(1 (?:(?:degenerate|connected|solid) )?(?!(?:is|has|was|as)\b)[a-z]+s)\b")


class Counts(Folder):
    def says(self, arguments, words):
        """What a command reports on both streams has these words, and is correct English."""
        code, out = self.run_with(arguments, errors=True)
        self.assertEqual(code, 0, (arguments, out))
        self.assertIsNone(PLURAL_OF_ONE.search(out), out)
        self.assertIn(words, out, arguments)

    def test_the_plural_of_one_is_recognised(self):
        for wrong in ("1 strips", "1 degenerate triangles", "1 vertices", "1 connected components"):
            self.assertEqual(PLURAL_OF_ONE.search(f"2 of them in {wrong} here")[1], wrong)
        for right in ("in 1 strip", "1 degenerate triangle left out", "0.1 strips", "21 strips", "1 edge lies", "1 is solid",
                      "1,001 strips"):
            self.assertIsNone(PLURAL_OF_ONE.search(right), right)

    def test_one_triangle(self):
        self.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.says("stats a.obj", "in 1 loop\n")
        self.says("stripify a.obj -o a.glb", "1 triangle (0 degenerate ones left out) in 1 strip, 1 connected component\n")
        self.says("convert a.obj -o a.ply", "3 vertices, 1 triangle\n")
        self.says("simplify a.obj -o a.pm", "1 triangle and 0 splits to 1\n")
        self.says("simplify a.obj -o b.glb", "1 of 1 triangle, in 1 strip\n")
        self.says("replay a.obj -o a.bin", "1 triangle in 1 strip\n")
        self.says("replay a.obj --repeats 0 --walk 1 --seed 1", "walk of 1 step, seed 1: ")
        self.says("bake a.obj -o a.baked", "1 triangle and 0 records to 1\n1 strip at the base")
        self.says("draw a.obj -o a.svg", "1 triangle in 1 strip; ")
        self.says("paper a.obj -o figures", "a.obj: 1 triangle, base 1\n")

    def test_one_fault(self):
        self.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\nf 1 1 2\n")
        self.says("stripify a.obj", "(1 degenerate one left out)")
        self.says("stripify a.obj", "\n1 edge lies between")
        self.says("stripify a.obj --orient", "oriented: 1 triangle turned\n")
        self.says("replay a.obj --repeats 0", "left out: 1 degenerate triangle\n")
        self.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 2 4 5\n")
        self.says("stripify a.obj", "\n1 vertex lies where others do")
        self.says("stripify a.obj --weld", "welded: 1 vertex with others")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
