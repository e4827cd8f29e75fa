"""Triangle strips, made from scratch and maintained while a mesh changes, by proven rules.

>>> import numpy, restrip
>>> restrip.strips_of(numpy.array([[0, 1, 2], [2, 1, 3], [2, 3, 4]]))
array([0, 1, 2, 3, 4], dtype=uint16)

`strips_of` is for meshes that do not change. `LiveMesh` has the operations of a mesh that changes, maintains its strips, and
returns the parts of its index buffer that changed. Faces go in as arrays of any integer type with three columns, such as
`trimesh.Trimesh.faces`, or `mesh.regular_faces` of pyvista.
"""
from __future__ import annotations

import ctypes
import warnings
from typing import Callable, Iterable, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _library as lib
from ._library import NONE, RestripError

__all__ = ["Change", "Coloring", "LiveMesh", "NONE", "Report", "RestripError", "faces_of", "strips_of"]
__version__: str = lib.plain("version").decode()

Cost = Union[str, Tuple[int, int, int]]
Index = Union[str, int]
Progress = Callable[[int, int, int], Optional[bool]]

_COSTS = {"strips": (1, 0, 0), "indices": (3, 1, 0)}
_EFFORTS = ("fast", "full", "best")
_POLICIES = ("bare", "rules", "local", "linked", "quick", "full", "best")
_FORMATS = ("restart", "stitched", "strips", "vtk")
_FORMS = {"restart": 0, "stitched": 1, "list": 3}
_LENGTHS = 2
_SLICES = 50


class Change(NamedTuple):
    """The result of an operation."""

    halfedge: int  #: as restrip.h says for each operation
    valence: int  #: triangles of the patch; 0 under the policy "bare"
    strips: int  #: change in the number of strips of the mesh
    isolated: int  #: change in the number of triangles that are a strip by themselves


class Coloring(NamedTuple):
    """Strips counted from their definition."""

    triangles: int
    strips: int
    isolated: int
    valid: bool  #: False is an error in the library


class Report(NamedTuple):
    """A report on the faces given."""

    degenerate_triangles: int  #: left out: a corner twice
    out_of_range_triangles: int  #: left out: a corner that is not below vertex_count
    boundary_edges: int
    non_manifold_edges: int  #: edges of three triangles or more: no strip crosses them
    inconsistent_edges: int  #: edges of two triangles that disagree in orientation: no strip crosses them
    non_manifold_vertices: int  #: operations refuse them


def _one_of(what: str, value: str, known: Sequence[str]) -> int:
    if value not in known:
        raise ValueError(f"{what} {value!r}: expected one of {', '.join(known)}")
    return known.index(value)


def _form(form: str) -> int:
    _one_of("form", form, tuple(_FORMS))
    return _FORMS[form]


def _cost(cost: Cost) -> lib.Cost:
    if isinstance(cost, str):
        _one_of("cost", cost, tuple(_COSTS))
        cost = _COSTS[cost]
    restart, swap, isolated = cost
    if not (1 <= restart <= 1000 and 0 <= swap <= 1000 and 0 <= isolated <= 1000):
        raise ValueError(f"cost {cost}: expected (restart, swap, isolated), restart from 1 to 1000, the others from 0 to 1000")
    return lib.Cost(restart, swap, isolated)


def _corners(faces, most: int) -> np.ndarray:
    faces = np.asarray(faces)
    if faces.size == 0:
        faces = faces.reshape(-1, 3).astype(np.uint32)
    if faces.ndim != 2 or faces.shape[1] != 3 or faces.dtype.kind not in "iu":
        raise ValueError(f"faces: expected integers with three columns, found {faces.dtype} of shape {faces.shape}")
    if faces.size and (faces.min() < 0 or faces.max() >= most):
        raise ValueError(f"faces: expected vertices from 0 to {most - 1}, found {faces.min()} to {faces.max()}")
    return np.ascontiguousarray(faces, dtype=np.uint32)


def _bits(index: Index) -> int:
    if index not in ("auto", 16, 32):
        raise ValueError(f"index {index!r}: expected 'auto', 16 or 32")
    return 0 if index == "auto" else int(index)


def _array(view: lib.BufferView) -> np.ndarray:
    """The indices of a view, while it is valid."""
    dtype = np.dtype(np.uint16 if view.index_bits == 16 else np.uint32)
    if not view.index_count:
        return np.empty(0, dtype)
    return np.frombuffer((ctypes.c_uint8 * (view.index_count * dtype.itemsize)).from_address(view.indices), dtype)


def _address(array: np.ndarray) -> ctypes.c_void_p:
    return array.ctypes.data_as(ctypes.c_void_p)


class LiveMesh:
    """A triangle mesh that changes, and its strips.

    `faces` has three columns, counter-clockwise; vertices are numbers below `vertex_count` (by default the largest plus
    one). Strips are made from scratch by `effort` ("fast", "full", "best"; None: every triangle is a strip) and maintained by
    `policy` ("bare", "rules", "local", "linked", "quick", "full", "best": docs/reference/policies.md has figures) for `cost`: "strips",
    "indices", or a triple (restart, swap, isolated) of weights. `report` counts defects of the faces; faces that are
    left out give a warning.

    A halfedge is a number: a directed mesh edge whose triangle lies to its left. One mesh may be read by several threads,
    or be changed by one.
    """

    report: Report
    outgrown: bool  #: see update
    room: int

    def __init__(self, faces, vertex_count: Optional[int] = None, *, policy: str = "quick", cost: Cost = "indices",
                 effort: Optional[str] = "fast"):
        self._mesh: Optional[int] = None
        self.outgrown, self.room = False, 0
        corners = _corners(faces, NONE)
        if vertex_count is None:
            vertex_count = int(corners.max()) + 1 if corners.size else 0
        kept = _one_of("policy", policy, _POLICIES)
        report, mesh, weights = lib.BuildReport(), ctypes.c_void_p(), _cost(cost)
        lib.call("mesh_build_u32", _address(corners), corners.size, vertex_count, report, None, mesh)
        self._mesh = mesh.value
        self.report = Report(*(getattr(report, name) for name in Report._fields))
        left_out = self.report.degenerate_triangles + self.report.out_of_range_triangles
        if left_out:
            warnings.warn(f"restrip: {left_out} of {len(corners)} faces are left out: {self.report}", stacklevel=2)
        if effort is not None:
            self.stripify(effort, cost)
        lib.call("mesh_keep", self._mesh, kept, weights)

    def __del__(self) -> None:
        if getattr(self, "_mesh", None):
            lib.plain("mesh_free", self._mesh)

    # ---- size and counts

    @property
    def triangle_count(self) -> int:
        return lib.plain("mesh_triangle_count", self._mesh)

    @property
    def triangle_bound(self) -> int:
        """An upper bound: triangle numbers are below it. A triangle keeps its number until it is removed."""
        return lib.plain("mesh_triangle_bound", self._mesh)

    @property
    def vertex_bound(self) -> int:
        """An upper bound: vertex numbers are below it."""
        return lib.plain("mesh_vertex_bound", self._mesh)

    @property
    def strip_count(self) -> int:
        """O(1)."""
        count = ctypes.c_size_t()
        lib.call("mesh_strip_count", self._mesh, count)
        return count.value

    def check(self) -> Coloring:
        """Counts the strips from their definition. O(triangles)."""
        coloring = lib.Coloring()
        lib.call("mesh_check", self._mesh, coloring)
        return Coloring(coloring.triangles, coloring.strips, coloring.isolated, bool(coloring.valid))

    def corners(self, triangle: int) -> Tuple[int, int, int]:
        found = np.empty(3, np.uint32)
        lib.call("mesh_corners", self._mesh, triangle, _address(found))
        a, b, c = found.tolist()
        return a, b, c

    def faces(self) -> np.ndarray:
        """All triangles, three columns, in the order of the strips. O(triangles)."""
        return self.indices("list", 32).reshape(-1, 3)

    # ---- halfedges: NONE if it does not exist

    def find(self, v: int, w: int) -> int:
        """The halfedge from vertex v to vertex w."""
        return lib.plain("mesh_find", self._mesh, v, w)

    def spoke(self, v: int) -> int:
        """A halfedge that leaves v. On the boundary turning counter-clockwise from it meets all triangles of v."""
        return lib.plain("mesh_spoke", self._mesh, v)

    def next(self, halfedge: int) -> int:
        """The next one around the triangle."""
        return lib.plain("mesh_next", self._mesh, halfedge)

    def opposite(self, halfedge: int) -> int:
        """The same mesh edge in the other direction."""
        return lib.plain("mesh_opposite", self._mesh, halfedge)

    def ends(self, halfedge: int) -> Tuple[int, int]:
        """The vertices that it leaves and leads to."""
        return lib.plain("mesh_from", self._mesh, halfedge), lib.plain("mesh_to", self._mesh, halfedge)

    def triangle(self, halfedge: int) -> int:
        """The triangle to its left."""
        return lib.plain("mesh_triangle", self._mesh, halfedge)

    def solid(self, halfedge: int) -> bool:
        """Whether a strip crosses the mesh edge."""
        return bool(lib.plain("mesh_solid", self._mesh, halfedge))

    # ---- operations: each is done, or refused with a RestripError that says why, and then nothing changed

    def split(self, left: int, right: int, vertex: int = NONE) -> Change:
        """Splits the vertex that the spokes `left` and `right` leave: the new vertex takes the triangles met when turning
        counter-clockwise from `right` to `left`. On the boundary one of them may be NONE. `vertex` is the number of the new
        vertex, by default the next free one; the halfedge of the change leads to it."""
        return self._done("mesh_split", left, right, vertex)

    def collapse(self, halfedge: int) -> Change:
        """Removes the mesh edge and the vertex that it leads to."""
        return self._done("mesh_collapse", halfedge)

    def flip(self, halfedge: int) -> Change:
        """Turns the mesh edge to the other diagonal of its two triangles."""
        return self._done("mesh_flip", halfedge)

    def split_face(self, halfedge: int) -> Change:
        """A new vertex inside the triangle; the halfedge of the change leads to it."""
        return self._done("mesh_split_face", halfedge)

    def join_faces(self, halfedge: int) -> Change:
        """Removes the vertex that it leads to, which has three triangles."""
        return self._done("mesh_join_faces", halfedge)

    def bisect(self, halfedge: int) -> Change:
        """A new vertex on the mesh edge; the halfedge of the change leads to it."""
        return self._done("mesh_bisect", halfedge)

    def merge(self, halfedge: int) -> Change:
        """Removes the vertex that it leads to, which has four triangles, or two on the boundary."""
        return self._done("mesh_merge", halfedge)

    def why_not(self, operation: str, *arguments: int) -> Optional[str]:
        """Why an operation of this name would be refused; None: it would be done."""
        _one_of("operation", operation, ("split", "collapse", "flip", "split_face", "join_faces", "bisect", "merge"))
        if operation == "split" and len(arguments) == 2:
            arguments = (*arguments, NONE)
        code = lib.plain("mesh_check_" + operation, self._mesh, *arguments)
        return None if code == 0 else lib.describe(code)

    def split_batch(self, requests: Iterable[Tuple[int, int, int]], threads: int = 1) -> List[Change]:
        """Many splits (left, right, vertex) at once, all or none; no two may overlap. `threads` 0: one for each
        processor."""
        asked = [lib.SplitRequest(*request) for request in requests]
        return self._batch("mesh_split_batch", (lib.SplitRequest * len(asked))(*asked), len(asked), threads)

    def collapse_batch(self, halfedges, threads: int = 1) -> List[Change]:
        """Many collapses at once, all or none; no two may overlap."""
        asked = np.ascontiguousarray(halfedges, dtype=np.uint32).ravel()
        return self._batch("mesh_collapse_batch", _address(asked), asked.size, threads)

    # ---- strips

    def stripify(self, effort: str = "fast", cost: Cost = "indices") -> int:
        """Strips from scratch; returns their number."""
        count = ctypes.c_size_t()
        lib.call("mesh_stripify", self._mesh, _one_of("effort", effort, _EFFORTS), _cost(cost), 0, count)
        return count.value

    def keep(self, policy: str, cost: Cost = "indices") -> None:
        """From now on operations maintain the strips by this policy, for this cost."""
        lib.call("mesh_keep", self._mesh, _one_of("policy", policy, _POLICIES), _cost(cost))

    def improve(self, budget: int, progress: Optional[Progress] = None) -> int:
        """Examines about `budget` states of searches for better strips, a few hundred nanoseconds each; returns how much
        the cost is lower. `progress(done, budget, saved)` is called some fifty times; it may stop the search by returning
        True."""
        saved, done, part = 0, 0, ctypes.c_size_t()
        while done < budget:
            size = budget if progress is None else min(budget - done, max(1, budget // _SLICES))
            lib.call("mesh_improve", self._mesh, size, part)
            done, saved = done + size, saved + part.value
            if progress is not None and progress(done, budget, saved):
                break
        return saved

    def indices(self, form: str = "restart", index: Index = "auto", *, cache_size: int = 0) -> np.ndarray:
        """The index buffer of the strips, in one of the forms
          "restart"   one triangle strip with primitive restart: all bits set between two strips,
          "stitched"  one triangle strip without: repeated indices lead from strip to strip,
          "list"      a triangle list.
        `index` is 16, 32 or "auto", 16 bits if all vertices are below 65,535. `cache_size` orders the strips
        for a vertex cache of that many vertices."""
        return self._made(_form(form), index, cache_size)[0]

    def strip_indices(self, index: Index = "auto") -> List[np.ndarray]:
        """The indices of each strip; an index is repeated if a strip turns twice the same way."""
        indices, draws = self._made(_LENGTHS, index, 0)
        return [indices[first:first + count] for first, count in draws]

    def strips(self) -> List[np.ndarray]:
        """The triangles of each strip, by their numbers, in their order."""
        triangles = self._filled("mesh_strip_triangles", np.uint32)
        return np.split(triangles, self._filled("mesh_strip_starts", np.uintp)[1:-1]) if len(triangles) else []

    @property
    def colors(self) -> np.ndarray:
        """One byte for each triangle number: bit s is set when a strip crosses side s. May be set to such an array."""
        colors = np.empty(self.triangle_bound, np.uint8)
        lib.call("mesh_get_colors", self._mesh, _address(colors), colors.size)
        return colors

    @colors.setter
    def colors(self, colors) -> None:
        colors = np.ascontiguousarray(colors, dtype=np.uint8)
        lib.call("mesh_set_colors", self._mesh, _address(colors), colors.size)

    # ---- the index buffer that follows the mesh

    def begin_buffer(self, form: str = "restart", index: Index = "auto", history: int = 0) -> None:
        """Starts the index buffer of the mesh, instead of a previous one, in a form of `indices`. An update of "list"
        writes less. With "auto" it has 16 bits until a vertex needs 32. With a `history` each update, from the next one on,
        ends a frame that can be undone; all frames together keep about that many changed triangles, 100 bytes each."""
        lib.call("live_begin_format", self._mesh, lib.Format(_form(form), _bits(index), 0, 0, 1))
        lib.call("live_history", self._mesh, history)

    def undo(self) -> bool:
        """Undoes the last frame; changes since the last update are a frame. Restores faces, numbers and strips exactly.
        False if no frame is left. The next update returns the whole buffer. Linear in the mesh."""
        return self._stepped("live_undo")

    def redo(self) -> bool:
        """Redoes the frame that was undone last, in the same way."""
        return self._stepped("live_redo")

    @property
    def history(self) -> Tuple[int, int]:
        """The number of frames that can be undone, and redone."""
        undoable, redoable = ctypes.c_size_t(), ctypes.c_size_t()
        lib.call("live_history_size", self._mesh, undoable, redoable)
        return undoable.value, redoable.value

    def update(self, merge_gap: int = 0, align: int = 4) -> List[Tuple[int, np.ndarray]]:
        """Brings the buffer in step with the mesh. Returns the parts that may have changed, each with its first place, to be
        copied to the device. Parts at most `merge_gap` indices apart are joined, and begin and end at multiples of `align`
        bytes: 2, or a multiple of 4. Then `outgrown` says whether the buffer has outgrown the `room` that it had, or its
        width: the device needs a new one, of `room` indices. Linear in the changes."""
        ranges, count, outgrown = ctypes.POINTER(lib.Range)(), ctypes.c_size_t(), ctypes.c_int32()
        lib.call("live_update_with", self._mesh, merge_gap, align, ranges, count, outgrown)
        view, room = lib.BufferView(), ctypes.c_size_t()
        lib.call("live_buffer", self._mesh, view, room)
        self.outgrown, self.room = bool(outgrown.value), room.value
        indices = _array(view)
        return [(ranges[i].first, indices[ranges[i].first:ranges[i].first + ranges[i].count].copy()) for i in range(count.value)]

    def buffer(self) -> np.ndarray:
        """A copy of the whole buffer after the last update, a multiple of four bytes: a 16-bit list may end with an index
        that does not belong to a triangle."""
        view = lib.BufferView()
        lib.call("live_buffer", self._mesh, view, None)
        return _array(view).copy()

    # ---- private

    def _stepped(self, name: str) -> bool:
        done = ctypes.c_int32()
        lib.call(name, self._mesh, done)
        return bool(done.value)

    def _made(self, form: int, index: Index, cache_size: int) -> Tuple[np.ndarray, List[Tuple[int, int]]]:
        """A buffer of the strips, and the ranges to draw separately."""
        buffer, view = ctypes.c_void_p(), lib.BufferView()
        lib.call("mesh_buffer", self._mesh, lib.Format(form, _bits(index), 0, 0, 1), cache_size, buffer)
        try:
            lib.call("buffer_read", buffer, view)
            return _array(view).copy(), [(view.draws[i].first, view.draws[i].count) for i in range(view.draw_count)]
        finally:
            lib.plain("buffer_free", buffer)

    def _done(self, name: str, *arguments: int) -> Change:
        change = lib.Change()
        lib.call(name, self._mesh, *arguments, change)
        return Change(change.halfedge, change.valence, change.strips, change.isolated)

    def _batch(self, name: str, asked, count: int, threads: int) -> List[Change]:
        changes, fault = (lib.Change * max(1, count))(), (ctypes.c_size_t * 2)()
        try:
            lib.call(name, self._mesh, asked, count, threads, changes, fault)
        except RestripError as error:
            raise RestripError(error.code, f"{error} (request {fault[0]}, with {fault[1]})") from None
        return [Change(one.halfedge, one.valence, one.strips, one.isolated) for one in changes[:count]]

    def _filled(self, name: str, dtype) -> np.ndarray:
        count = ctypes.c_size_t()
        lib.call(name, self._mesh, None, 0, count)
        array = np.empty(count.value, dtype)
        if count.value:
            lib.call(name, self._mesh, _address(array), array.size, count)
        return array


def strips_of(faces, cost: Cost = "indices", format: str = "restart", *, effort: str = "fast", vertex_count: Optional[int] = None,
              index: Index = "auto", progress: Optional[Progress] = None):
    """Triangle strips of a mesh.

    `format` is
      "restart"   one array of indices, to be drawn as a triangle strip with primitive restart (all bits set),
      "stitched"  one array, a triangle strip without restart: repeated indices lead from strip to strip,
      "strips"    a list of arrays, one for each strip,
      "vtk"       one array, in which each strip follows the number of its indices, as in vtkPolyData and pyvista.
    Windings are kept; an index is repeated if a strip turns twice the same way. `index` is 16, 32 or "auto".
    If a triangle list has fewer indices than the array that is returned, a warning says so. With `progress` the strips of the
    effort "fast" are improved step by step, and progress(done, budget, saved) is called in between; it may stop that by
    returning True.
    """
    _one_of("format", format, _FORMATS)
    _one_of("effort", effort, _EFFORTS)
    mesh = LiveMesh(faces, vertex_count, policy="full", cost=cost, effort=effort if progress is None else "fast")
    if progress is not None:
        mesh.improve({"fast": 1, "full": 40, "best": 400}[effort] * max(1, mesh.triangle_count), progress)
    if format in _FORMS:
        indices = mesh.indices(format, index)
        if len(indices) > 3 * mesh.triangle_count:
            warnings.warn(f"restrip: these strips have {len(indices)} indices, a triangle list has {3 * mesh.triangle_count}", stacklevel=2)
        return indices
    strips = mesh.strip_indices(index)
    if format == "strips":
        return strips
    parts = [part for strip in strips for part in (np.array([len(strip)], np.int64), strip.astype(np.int64))]
    return np.concatenate(parts) if parts else np.empty(0, np.int64)


def faces_of(indices) -> np.ndarray:
    """The triangles that a triangle strip with primitive restart draws, three columns; degenerate ones are left out."""
    indices = np.asarray(indices)
    if indices.ndim != 1 or indices.dtype not in (np.uint16, np.uint32):
        raise ValueError(f"indices: expected uint16 or uint32 in one dimension, found {indices.dtype} of shape {indices.shape}")
    if indices.size < 3:
        return np.empty((0, 3), indices.dtype)
    restart = indices == np.iinfo(indices.dtype).max
    places = np.arange(indices.size)
    starts = np.maximum.accumulate(np.where(restart, places + 1, 0))
    triples = np.lib.stride_tricks.sliding_window_view(indices, 3).copy()
    odd = (places - starts)[:-2] % 2 == 1
    triples[odd] = triples[odd][:, [1, 0, 2]]
    whole = ~(restart[:-2] | restart[1:-1] | restart[2:])
    a, b, c = triples.T
    return triples[whole & (a != b) & (b != c) & (c != a)]
