"""The Python package: strips and buffers draw the faces given, windings included, under every operation, policy and form;
what is refused has a reason and changes nothing. Run it in an environment that has the package."""
import contextlib
import copy
import importlib.util
import io
import os
import pathlib
import pickle
import pydoc
import random
import re
import signal
import threading
import unittest
import warnings

import numpy as np

import restrip


def grid(n, dtype=np.int64):
    place = np.arange(n * n, dtype=dtype).reshape(n, n)
    a, b, c, d = (part.ravel() for part in (place[:-1, :-1], place[:-1, 1:], place[1:, 1:], place[1:, :-1]))
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def rotated(faces):
    """A sorted list, each triangle from its smallest corner on: equal if triangles and windings are equal."""
    return sorted(tuple(np.roll(face, -int(np.argmin(face))).tolist()) for face in np.asarray(faces))


def drawn(indices):
    """The triangles of a strip with restart, one index after the other."""
    end, faces, strip = np.iinfo(indices.dtype).max, [], []
    for index in [*indices.tolist(), end]:
        if index == end:
            faces += [strip[i:i + 3] if i % 2 == 0 else [strip[i + 1], strip[i], strip[i + 2]] for i in range(len(strip) - 2)]
            strip = []
        else:
            strip.append(index)
    return [face for face in faces if len(set(face)) == 3]


class StripsOf(unittest.TestCase):
    def test_every_format_draws_the_faces(self):
        for faces in (grid(9), grid(9, np.uint8), grid(9)[::-1].astype(np.int32), np.asfortranarray(grid(7))):
            for cost in ("strips", "indices", (5, 2, 1)):
                for effort in ("fast", "full", "best"):
                    indices = restrip.strips_of(faces, cost, effort=effort)
                    self.assertEqual(indices.dtype, np.uint16)
                    self.assertEqual(rotated(drawn(indices)), rotated(faces))
                    self.assertEqual(rotated(restrip.faces_of(indices)), rotated(faces))
                    stitched = restrip.strips_of(faces, cost, "stitched", effort=effort)
                    self.assertNotIn(65535, stitched)
                    self.assertEqual(rotated(drawn(stitched)), rotated(faces))
                    strips = restrip.strips_of(faces, cost, "strips", effort=effort)
                    self.assertEqual(np.concatenate([[*strip, 65535] for strip in strips])[:-1].tolist(), indices.tolist())
                    cells = restrip.strips_of(faces, cost, "vtk", effort=effort)
                    for strip in strips:
                        self.assertEqual(cells[0], len(strip))
                        self.assertEqual(cells[1:1 + len(strip)].tolist(), strip.tolist())
                        cells = cells[1 + len(strip):]
                    self.assertEqual(len(cells), 0)

    def test_width_of_indices(self):
        faces = grid(3)
        for size in (3, 16, 32):  # cut and ordered for a cache: the same triangles, and heavier misses mean more indices
            many = [restrip.strips_of(grid(30), cache_size=size, cache_weight=weight) for weight in (0.1, 0, 50)]
            for indices in many:
                self.assertEqual(rotated(restrip.faces_of(indices)), rotated(grid(30)))
            self.assertLess(len(many[0]), len(many[2]))
        for weight in (-1, 1001, float("nan")):
            with self.assertRaisesRegex(ValueError, "cache_weight: expected 0 to 1000"):
                restrip.strips_of(faces, cache_size=16, cache_weight=weight)
        self.assertEqual(restrip.strips_of(faces, index=32).dtype, np.uint32)
        self.assertEqual(restrip.strips_of(faces + 65535 - 9).dtype, np.uint16)
        self.assertEqual(restrip.strips_of(faces + 65536 - 9).dtype, np.uint32)
        with self.assertRaisesRegex(restrip.RestripError, "vertex 65,535 needs 32-bit indices; use index='auto'"):
            restrip.strips_of(faces + 65536 - 9, index=16)

    def test_progress_is_reported_and_can_stop(self):
        calls = []
        indices = restrip.strips_of(grid(30), progress=lambda *call: calls.append(call))
        self.assertEqual(rotated(drawn(indices)), rotated(grid(30)))
        self.assertGreater(len(calls), 10)
        self.assertEqual(calls, sorted(calls))
        self.assertEqual(calls[-1][0], calls[-1][1])
        few = []
        restrip.strips_of(grid(30), progress=lambda *call: few.append(call) or len(few) == 3)
        self.assertEqual(few, calls[:3])

    def test_looks_like_a_container_and_can_be_closed(self):
        with restrip.LiveMesh(grid(3)) as mesh:
            self.assertEqual(len(mesh), 8)
            self.assertTrue(mesh)
            self.assertRegex(repr(mesh), r"<restrip.LiveMesh of 8 triangles in \d+ strips>")
        self.assertEqual(repr(mesh), "<restrip.LiveMesh, closed>")
        mesh.close()
        for use in (lambda: mesh.triangle_count, lambda: mesh.find(0, 1), lambda: mesh.flip(3), lambda: mesh.faces(), lambda: mesh.indices(),
                    mesh.begin_buffer, mesh.update, mesh.strips, mesh.check, lambda: mesh.corners(0)):
            with self.assertRaisesRegex(ValueError, "closed"):
                use()

    def test_nothing_and_little(self):
        self.assertEqual(len(restrip.strips_of([])), 0)
        self.assertEqual(restrip.strips_of([], format="strips"), [])
        self.assertEqual(len(restrip.strips_of([], format="vtk")), 0)
        self.assertEqual(restrip.faces_of(restrip.strips_of([[0, 1, 2]])).tolist(), [[0, 1, 2]])
        with self.assertWarnsRegex(UserWarning, "7 indices, a triangle list has 6"):
            restrip.strips_of([[0, 1, 2], [3, 4, 5]])

    def test_bad_input_is_named(self):
        for faces, said in (([[0, 1]], "three columns"), ([0, 1, 2], "three columns"), ([[0.0, 1.0, 2.0]], "float64"), ([[0, 1, -1]], "-1 to 1"),
                            ([[0, 1, 2 ** 32]], "4294967296")):
            with self.assertRaisesRegex(ValueError, said):
                restrip.strips_of(faces)
        for options, said in (({"cost": "turns"}, "strips, indices"), ({"cost": (0, 1, 1)}, "1 to 1000"), ({"cost": (3, 1)}, r"cost \(3, 1\): expected \(restart, swap, isolated\)"),
                              ({"cost": 3}, "cost 3: expected"), ({"cost": (1, 0.5, 0)}, "1 to 1000"), ({"vertex_count": 9.5}, "vertex_count 9.5: expected an integer"),
                              ({"vertex_count": -1}, "vertex_count -1"), ({"format": "fans"}, "restart, stitched, strips, vtk"),
                              ({"effort": "most"}, "fast, full, best"), ({"index": 8}, "16 or 32")):
            with self.assertRaisesRegex(ValueError, said):
                restrip.strips_of(grid(3), **options)

    def test_sparse_vertices_take_no_memory(self):
        far, near = 4_000_000_000, grid(4)
        names = np.arange(near.max() + 1, dtype=np.int64) * 150_000_000
        faces = names[near]
        drawn = lambda corners: sorted(tuple(np.roll(face, -int(np.argmin(face))).tolist()) for face in corners)
        for options in ({}, {"vertex_count": far}, {"cost": "strips"}):
            for index in ("auto", 32):
                self.assertEqual(drawn(restrip.faces_of(restrip.strips_of(faces, index=index, **options))), drawn(faces))
        strips, close = restrip.strips_of(faces, format="strips"), restrip.strips_of(near, format="strips")
        self.assertEqual([strip.tolist() for strip in strips], [names[strip].tolist() for strip in close])
        self.assertEqual(len(restrip.strips_of(faces, format="vtk")), len(restrip.strips_of(near, format="vtk")))
        self.assertEqual(restrip.strips_of([[0, 1, 2]], vertex_count=far).dtype, np.uint16)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            self.assertEqual(restrip.strips_of([[0, 1, 2], [2, 1, far]], vertex_count=far, index=16).tolist(), [0, 1, 2])
        self.assertIn("1 of 2 faces are left out", str(caught[0].message))
        with self.assertRaisesRegex(restrip.RestripError, "index='auto'"):
            restrip.strips_of([[0, 1, far]], index=16)
        with self.assertRaisesRegex(ValueError, "vertex 4000000000 of 1 faces.*numpy.unique"):
            restrip.LiveMesh([[0, 1, far]])
        with self.assertRaisesRegex(ValueError, "vertex_count 4000000001"):
            restrip.LiveMesh([[0, 1, far]], far + 1)

    def test_what_is_left_out_gives_a_warning(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            mesh = restrip.LiveMesh([[0, 1, 2], [2, 2, 1], [1, 3, 7]], vertex_count=4)
        self.assertEqual(mesh.report[:2], (1, 1))
        self.assertEqual(mesh.triangle_count, 1)
        self.assertIn("2 of 3 faces are left out", str(caught[0].message))


class Play(unittest.TestCase):
    @staticmethod
    def levels(faces, count):
        """The faces that are left after collapses of the first edges that may collapse, and the records, from coarse to fine."""
        mesh, records = restrip.LiveMesh(faces, policy="bare"), []
        while mesh.triangle_count > count:
            edges = mesh.find_each(*mesh.faces()[:, :2].T)
            edge = int(edges[np.argmin(mesh.check_each("collapse", edges))])
            apexes = (mesh.ends(mesh.next(side))[1] for side in (edge, mesh.opposite(edge)))
            records.insert(0, [*mesh.ends(edge), *apexes])
            mesh.collapse(edge)
        return mesh.faces(), np.array(records)

    def test_records_lead_back(self):
        faces = grid(20)
        base, records = self.levels(faces, 100)
        self.assertLessEqual(len(base), 100)
        mesh, twin = (restrip.LiveMesh(base, 400) for _ in range(2))
        for v_s, v_t, v_l, v_r in records.tolist():
            twin.split(*(restrip.NONE if v == restrip.NONE else twin.find(v_s, v) for v in (v_l, v_r)), v_t)
        mesh.play(records)
        self.assertEqual(rotated(mesh.faces()), rotated(faces))
        self.assertEqual(mesh.faces().tolist(), twin.faces().tolist())
        mesh.play(records[-50:], forward=False)
        with self.assertRaisesRegex(restrip.RestripError, f"^record {len(records) - 1}: "):
            mesh.play(records, forward=False)
        mesh.play(records[:-50], forward=False)
        self.assertEqual(rotated(mesh.faces()), rotated(base))
        with self.assertRaisesRegex(restrip.RestripError, "^record 1: "):
            mesh.play(records[[0, 0]])
        for wrong in (records[:, :3], records.ravel(), records + 0.5):
            with self.assertRaisesRegex(ValueError, "records: expected"):
                mesh.play(wrong)
        self.assertTrue(mesh.check().valid)


class Live(unittest.TestCase):
    def test_buffers_follow_random_operations(self):
        for policy in ("rules", "quick"):  # tests/c drives every policy and form
            for form, index in (("restart", 16), ("stitched", 32), ("list", "auto")):
                generator = random.Random(f"{policy} {form} {index}")
                mesh = restrip.LiveMesh(grid(8), policy=policy, effort="full")
                mesh.begin_buffer(form, index)
                device = np.zeros(5000, np.uint32)
                done, outgrown = {}, 0
                for _ in range(60):
                    operation = generator.choice(["collapse", "flip", "split_face", "join_faces", "bisect", "merge"])
                    h = 4 * generator.randrange(mesh.triangle_bound) + generator.randrange(3)
                    before = (mesh.strip_count, rotated(mesh.faces()))
                    refused = mesh.why_not(operation, h)
                    if refused is not None:
                        with self.assertRaisesRegex(restrip.RestripError, refused):
                            getattr(mesh, operation)(h)
                        self.assertEqual((mesh.strip_count, rotated(mesh.faces())), before)
                        continue
                    change = getattr(mesh, operation)(h)
                    done[operation] = done.get(operation, 0) + 1
                    self.assertEqual(mesh.strip_count, before[0] + change.strips)
                    for first, part in mesh.update(merge_gap=generator.choice([0, 8]), align=generator.choice([2, 4, 16])):
                        device[first:first + len(part)] = part
                    buffer = mesh.buffer()
                    drawn_of_it = mesh.index_count
                    self.assertEqual(drawn_of_it, 3 * mesh.triangle_count if form == "list" else len(buffer))
                    self.assertEqual(device[:len(buffer)].tolist(), buffer.tolist())
                    self.assertGreaterEqual(mesh.room, len(buffer))
                    outgrown += mesh.outgrown
                    faces = drawn(buffer) if form != "list" else [f for f in buffer[:drawn_of_it].reshape(-1, 3) if len(set(f.tolist())) == 3]
                    self.assertEqual(rotated(faces), rotated(mesh.faces()))
                self.assertLess(outgrown, 20)
                coloring = mesh.check()
                self.assertEqual((coloring.valid, coloring.strips, coloring.triangles), (True, mesh.strip_count, mesh.triangle_count))
                self.assertGreaterEqual(len(done), 3, done)

    def test_many_operations_in_one_call(self):
        mesh, twin = restrip.LiveMesh(grid(9)), restrip.LiveMesh(grid(9))
        corners = grid(9)
        sides = mesh.find_each(corners, np.roll(corners, -1, 1))  # side s of triangle t
        self.assertEqual((sides.dtype, sides.tolist()), (np.uint32, (4 * np.arange(128)[:, None] + np.arange(3)).tolist()))
        self.assertEqual(mesh.find_each(40, [41, 40, 3]).tolist(), [mesh.find(40, w) for w in (41, 40, 3)])
        wanted = sides.ravel()[::-1]  # not contiguous
        for operation in ("flip", "bisect", "merge", "split_face", "join_faces", "collapse"):
            if operation == "collapse":
                wanted = np.arange(4 * mesh.triangle_bound, dtype=np.uint32)
            codes = mesh.check_each(operation, wanted)
            reasons = [mesh.why_not(operation, h) for h in wanted]
            self.assertEqual([restrip.describe(code) if code else None for code in codes], reasons)
            codes, changes = mesh.apply_each(operation, wanted)
            for h, code, change in zip(wanted, codes, changes):
                if code == 0:
                    self.assertEqual(getattr(twin, operation)(h), tuple(change))
                    continue
                with self.assertRaisesRegex(restrip.RestripError, restrip.describe(code)) as refused:
                    getattr(twin, operation)(h)
                self.assertEqual((refused.exception.code, change["halfedge"]), (code, restrip.NONE))
            self.assertEqual((mesh.faces().tolist(), mesh.strip_count), (twin.faces().tolist(), twin.strip_count))
            self.assertTrue((codes == 0).any() and (operation in ("bisect", "split_face") or (codes != 0).any()), operation)
        self.assertTrue(mesh.check().valid)
        self.assertEqual([mesh.find_each([], []).shape, mesh.check_each("flip", []).shape, mesh.apply_each("flip", [])[1].shape], [(0,)] * 3)
        for wrong, said in ((lambda: mesh.find_each([1.0], [2]), "vertex: expected an array of integers, found float64"),
                            (lambda: mesh.check_each("flip", [3, -1]), "halfedge: expected integers from 0 to 4294967295, found -1 to 3"),
                            (lambda: mesh.apply_each("flip", [2 ** 32]), "found 4294967296"), (lambda: mesh.apply_each("split", [3]), "collapse, flip"),
                            (lambda: mesh.find_each([1, 2], [1, 2, 3]), "broadcast")):
            with self.assertRaisesRegex(ValueError, said):
                wrong()

    def test_frames_are_undone(self):
        mesh = restrip.LiveMesh(grid(8))
        self.assertEqual((mesh.undo(), mesh.history), (False, (0, 0)))
        mesh.begin_buffer(history=10_000)
        mesh.update()
        self.assertEqual((mesh.undo(), mesh.history), (False, (0, 0)))
        state = lambda: (mesh.faces().tolist(), mesh.colors.tolist())
        states = [state()]
        for v in (9, 18, 27):
            mesh.collapse(mesh.find(v, v + 1))
            if v == 18:
                mesh.stripify("full", "strips")
            mesh.update()
            states.append(state())
        for at in (2, 1, 0):
            self.assertTrue(mesh.undo())
            self.assertEqual(mesh.history, (at, 3 - at))
            self.assertEqual(state(), states[at])
            mesh.update()
            self.assertEqual(rotated(drawn(mesh.buffer())), rotated(mesh.faces()))
        self.assertEqual((mesh.undo(), mesh.redo(), mesh.history), (False, True, (1, 2)))
        self.assertEqual(state(), states[1])

    def test_a_saved_mesh_is_loaded(self):
        mesh = restrip.LiveMesh(grid(12), policy="full", cost="strips")
        mesh.begin_buffer("stitched", 32, history=1000, cache_size=16, waste=200, work=3)
        mesh.collapse(mesh.find(30, 31))
        mesh.update()
        loaded = restrip.LiveMesh.load(mesh.save(), history=1000)
        device = loaded.buffer()
        self.assertEqual((loaded.history, device.dtype), ((0, 0), np.uint32))
        copied = pickle.loads(pickle.dumps(mesh))
        self.assertEqual((copied.report, repr(copied)), (mesh.report, repr(mesh)))
        for other in (loaded, copied, copy.copy(mesh), copy.deepcopy(mesh)):
            self.assertEqual((other.faces().tolist(), other.colors.tolist()), (mesh.faces().tolist(), mesh.colors.tolist()))
            self.assertEqual(other.save(), mesh.save())
        for v in (40, 60, 80):
            loaded.bisect(loaded.find(v, v + 1))
            for first, part in loaded.update():
                device = np.resize(device, len(loaded.buffer()))
                device[first:first + len(part)] = part
            self.assertEqual(device.tolist(), loaded.buffer().tolist())
        while loaded.undo():
            pass
        self.assertEqual(loaded.faces().tolist(), mesh.faces().tolist())
        saved = mesh.save()
        for damaged, said in ((saved[:-1], "truncated"), (saved[:50] + b"x" + saved[51:], "altered"), (b"", "truncated"), (b"ply" * 9, "not a saved")):
            with self.assertRaisesRegex(restrip.RestripError, f"^load: .*{said}"):
                restrip.LiveMesh.load(damaged)

    def test_copies_are_of_the_class_and_keep_attributes(self):
        class Terrain(restrip.LiveMesh):
            __slots__ = ("name",)

            def __init__(self, faces, heights):
                super().__init__(faces)
                self.heights, self.name = heights, "hill"

        mesh = Terrain(grid(4), list(range(16)))
        mesh.begin_buffer(history=100)
        for other in (copy.copy(mesh), copy.deepcopy(mesh)):
            self.assertEqual((type(other), other.heights, other.name, other.report), (Terrain, mesh.heights, "hill", mesh.report))
            self.assertEqual(rotated(other.faces()), rotated(mesh.faces()))
            other.collapse(other.find(5, 6))
            self.assertEqual(mesh.triangle_count, 18)
            other.close()
        self.assertIs(copy.copy(mesh).heights, mesh.heights)
        self.assertIsNot(copy.deepcopy(mesh).heights, mesh.heights)
        mesh = restrip.LiveMesh(grid(4))
        mesh.note = {"of": "mine"}
        self.assertEqual(pickle.loads(pickle.dumps(mesh)).note, {"of": "mine"})

    def test_custom_operations_are_tables(self):
        data = {"format": "restrip-operation-table", "name": "divide-face", "matching": False, "none": 255, "entries": [24, 25, 50, 51, 44, 29, 46, 255],
                "positions": [{"numbers": [], "before": {"triangles": 1, "edges": 0}, "after": {"triangles": 3, "edges": 3}, "ports": 3, "first": 0, "vertices": 4,
                               "triangles_before": [[0, 0, 0, 1, 2, 64, 65, 66]],
                               "triangles_after": [[0, 0, 0, 1, 3, 64, 0, 2], [0, 1, 3, 1, 2, 0, 65, 1], [1, 2, 3, 2, 0, 1, 66, 2]]}]}
        table, mesh = restrip.Table(data), restrip.LiveMesh(grid(6))
        corners = mesh.corners(7)
        change, vertices = mesh.apply(table, 4 * 7)
        self.assertEqual((mesh.ends(change.halfedge), vertices, mesh.triangle_count), (corners[:2], [36], 52))
        self.assertTrue(mesh.check().valid)
        with self.assertRaisesRegex(restrip.RestripError, "apply: the halfedge is not one of this mesh"):
            mesh.apply(table, restrip.NONE)
        with self.assertRaisesRegex(ValueError, "Table: .*entry 0 is not a sound rule"):
            restrip.Table({**data, "entries": [56, *data["entries"][1:]]})
        with self.assertRaisesRegex(ValueError, "this is not the table of an operation"):
            restrip.Table({})

    def test_vertices_name_operations_and_triangles_are_replaced(self):
        mesh, other = restrip.LiveMesh(grid(6)), restrip.LiveMesh(grid(6))
        for at_vertices, at_halfedges in ((lambda: mesh.flip_at(7, 14), lambda: other.flip(other.find(7, 14))),
                                          (lambda: mesh.collapse_at(21, 22), lambda: other.collapse(other.find(21, 22))),
                                          (lambda: mesh.split_at(14, 8, 20), lambda: other.split(other.find(14, 8), other.find(14, 20)))):
            self.assertEqual(at_vertices(), at_halfedges())
            np.testing.assert_array_equal(mesh.faces(), other.faces())
        for wrong in (lambda: mesh.flip_at(0, 40), lambda: mesh.collapse_at(1000, 0), lambda: mesh.split_at(1000, 0, 1)):
            with self.assertRaisesRegex(restrip.RestripError, "halfedge is not one"):
                wrong()
        before, t = rotated(mesh.faces()), mesh.triangle(mesh.spoke(16))
        corners = mesh.corners(t)
        mesh.replace([t], [])
        self.assertEqual(len(mesh), len(before) - 1)
        mesh.replace([], [corners])
        self.assertEqual(rotated(mesh.faces()), before)
        with self.assertRaisesRegex(restrip.RestripError, "manifold"):
            mesh.replace([], [corners])

    def test_ctrl_c_ends_a_long_search(self):
        mesh = restrip.LiveMesh(grid(150), cost="indices")
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            for _ in range(1000):
                mesh.stripify("best")
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
        self.assertTrue(mesh.check().valid)
        mesh.stripify("full")

    def test_layouts_are_checked(self):
        mesh = restrip.LiveMesh(grid(6))
        for wrong in ({"cache_size": 65}, {"waste": -1}, {"work": 101}):
            with self.assertRaisesRegex(ValueError, "expected an integer from 0 to"):
                mesh.begin_buffer(**wrong)

    def test_splits_undo_collapses(self):
        mesh = restrip.LiveMesh(grid(6))
        h = mesh.find(14, 15)
        self.assertEqual(mesh.ends(h), (14, 15))
        self.assertEqual(mesh.ends(mesh.opposite(h)), (15, 14))
        self.assertEqual(mesh.ends(mesh.next(h))[0], 15)
        self.assertIn(15, mesh.corners(mesh.triangle(h)))
        left, right = mesh.ends(mesh.next(h))[1], mesh.ends(mesh.next(mesh.opposite(h)))[1]
        faces = rotated(mesh.faces())
        mesh.collapse(h)
        self.assertEqual(mesh.find(14, 15), restrip.NONE)
        change = mesh.split(mesh.find(14, left), mesh.find(14, right), 15)
        self.assertEqual(mesh.ends(change.halfedge), (14, 15))
        self.assertEqual(rotated(mesh.faces()), faces)
        with self.assertRaisesRegex(restrip.RestripError, "split: "):
            mesh.split(mesh.find(14, left), mesh.find(14, left))

    def test_colors_go_out_and_in(self):
        mesh = restrip.LiveMesh(grid(7), effort="best")
        colors, strips = mesh.colors, mesh.strips()
        self.assertEqual(sorted(np.concatenate(strips).tolist()), list(range(mesh.triangle_count)))
        self.assertEqual(len(strips), mesh.strip_count)
        mesh.stripify("fast", "indices")
        mesh.colors = colors
        self.assertEqual([strip.tolist() for strip in mesh.strips()], [strip.tolist() for strip in strips])
        with self.assertRaises(restrip.RestripError):
            mesh.colors = np.full(mesh.triangle_bound, 7)
        with self.assertRaisesRegex(ValueError, "colors: expected 72 numbers, one for each triangle number, found 71"):
            mesh.colors = colors[1:]
        with self.assertRaisesRegex(restrip.RestripError, "corners: no triangle has the number 72"):
            mesh.corners(72)
        for wrong in (colors.astype(int) + 256, colors - 0.0, colors.astype(int) - 8, colors == 1, [8] * len(colors), colors.reshape(-1, 1), "no"):
            with self.assertRaisesRegex(ValueError, "colors: expected integers from 0 to 7"):
                mesh.colors = wrong
        mesh.colors = colors.tolist()
        self.assertEqual(mesh.colors.tolist(), colors.tolist())

    def test_the_first_update_begins_a_buffer(self):
        mesh = restrip.LiveMesh(grid(3))
        self.assertEqual(mesh.index_count, 0)
        (first, indices), = mesh.update()
        self.assertEqual((first, indices.dtype, mesh.outgrown), (0, np.uint16, True))
        self.assertEqual(rotated(drawn(indices)), rotated(mesh.faces()))

    def test_sixteen_bits_are_kept(self):
        mesh = restrip.LiveMesh(np.concatenate([grid(20), grid(20) + 65534 - 399]))
        mesh.begin_buffer(index=16)
        mesh.update()
        before, h = rotated(mesh.faces()), mesh.find(30, 31)
        said = "vertex 65,535 needs 32-bit indices; use index='auto'"
        for operation, arguments in (("bisect", [h]), ("split_face", [h]), ("split", [h, mesh.find(30, 10)]), ("split", [h, mesh.find(30, 10), 65535])):
            self.assertEqual(mesh.why_not(operation, *arguments), said)
            with self.assertRaisesRegex(restrip.RestripError, f"^{operation}: {said}$"):
                getattr(mesh, operation)(*arguments)
        self.assertEqual(rotated(mesh.faces()), before)
        self.assertEqual(mesh.update(), [])
        mesh.collapse(mesh.find(50, 51))
        self.assertEqual(mesh.ends(mesh.bisect(h).halfedge)[1], 51)
        mesh.update()
        mesh.begin_buffer()
        mesh.update()
        self.assertEqual(mesh.buffer().dtype, np.uint16)
        self.assertEqual(mesh.ends(mesh.bisect(mesh.find(30, 10)).halfedge)[1], 65535)
        mesh.update()
        self.assertEqual((mesh.outgrown, mesh.buffer().dtype), (True, np.uint32))

    def test_arguments_are_checked(self):
        mesh = restrip.LiveMesh(grid(5))
        mesh.begin_buffer()
        mesh.update()
        h = np.int64(mesh.find(6, 7))
        self.assertEqual(mesh.ends(h), (6, 7))
        for wrong in (5.5, -1, 2 ** 32, "6", None):
            for call in (lambda: mesh.bisect(wrong), lambda: mesh.find(6, wrong), lambda: mesh.spoke(wrong), lambda: mesh.next(wrong), lambda: mesh.opposite(wrong),
                         lambda: mesh.ends(wrong), lambda: mesh.triangle(wrong), lambda: mesh.solid(wrong), lambda: mesh.corners(wrong), lambda: mesh.split(h, wrong),
                         lambda: mesh.why_not("flip", wrong),
                         lambda: mesh.indices(cache_size=wrong)):
                with self.assertRaisesRegex(ValueError, f"{wrong!r}: expected an integer from 0 to 4294967295"):
                    call()
        for call in (lambda: mesh.improve(-5), lambda: mesh.improve(2.5), lambda: mesh.begin_buffer(history=-1), lambda: mesh.update(merge_gap=-1)):
            with self.assertRaisesRegex(ValueError, "expected an integer from 0"):
                call()
        for align in (0, 3, 6):
            with self.assertRaisesRegex(ValueError, f"align {align}: expected 2 or a multiple of 4"):
                mesh.update(align=align)
        for arguments in ((), (h, h)):
            with self.assertRaisesRegex(TypeError, "why_not: flip needs a halfedge"):
                mesh.why_not("flip", *arguments)
        with self.assertRaisesRegex(TypeError, "why_not: split needs left, right and perhaps vertex"):
            mesh.why_not("split", h)
        self.assertEqual((mesh.update(), rotated(mesh.faces())), ([], rotated(grid(5))))

    def test_help_names_what_users_need(self):
        manual = pydoc.render_doc(restrip, renderer=pydoc.plaintext)
        for words in ("Side s of triangle t, 4 t + s", "`outgrown` says", "degenerate_triangles    left out", "NONE if the mesh has no such edge", "np.unique"):
            self.assertIn(words, manual)

    @unittest.skipUnless(importlib.util.find_spec("trimesh"), "without the package trimesh the program of docs/how-to/python.md is not run")
    def test_the_page_with_trimesh_runs(self):
        page = (pathlib.Path(__file__).resolve().parents[2] / "docs/how-to/python.md").read_text(encoding="utf-8")
        program, = re.findall(r"```python\n(.*?)```", page, re.S)
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            exec(program, {})
        self.assertRegex(said.getvalue(), r"^True True\nTrue 1280 [1-9]\d+\n$")

    def test_types_and_licence_are_shipped(self):
        folder = pathlib.Path(restrip.__file__).parent
        self.assertTrue((folder / "py.typed").exists())
        self.assertIn("MIT License", (folder / "LICENSE").read_text())


if __name__ == "__main__":
    unittest.main()
