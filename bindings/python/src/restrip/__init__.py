"""Triangle strips, made from scratch and maintained while a mesh changes, by proven rules.

>>> import numpy, restrip
>>> restrip.strips_of(numpy.array([[0, 1, 2], [2, 1, 3], [2, 3, 4]]))
array([0, 1, 2, 3, 4], dtype=uint16)

`strips_of` is for meshes that do not change. `LiveMesh` has the operations of a mesh that changes, maintains its strips,
and returns the parts of its index buffer that changed. Faces go in as arrays of any integer type with three columns,
such as `trimesh.Trimesh.faces`, or `mesh.regular_faces` of pyvista.
"""
from __future__ import annotations

import ctypes
import operator
import sys
import warnings
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Literal, NamedTuple, Optional, Sequence, Tuple, Union, overload

import numpy as np

from . import _library as lib
from ._library import NONE, RestripError, describe

__all__ = ["Change", "Coloring", "LiveMesh", "NONE", "Report", "RestripError", "Table", "describe", "faces_of", "strips_of"]
__version__: str = lib.plain("version").decode()

# For type checkers; __init__ and the functions name the same words when a value is none of them.
Policy = Literal["bare", "rules", "local", "quick", "full"]
Effort = Literal["fast", "full", "best"]
Cost = Union[Literal["strips", "indices"], Tuple[int, int, int]]
Form = Literal["restart", "stitched", "list"]
Operation = Literal["collapse", "flip", "split_face", "join_faces", "bisect", "merge"]
Format = Literal["restart", "stitched", "strips", "vtk"]
Index = Literal["auto", 16, 32]
Progress = Callable[[int, int, int], Optional[bool]]
if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Indices = Union[NDArray[np.uint16], NDArray[np.uint32]]
    Numbers = NDArray[np.uint32]

_COSTS = {"strips": (1, 0, 0), "indices": (3, 1, 0)}
_EFFORTS = ("fast", "full", "best")
_POLICIES = {"bare": 0, "rules": 1, "local": 2, "quick": 3, "full": 4}
_FORMATS = ("restart", "stitched", "strips", "vtk")
_FORMS = {"restart": 0, "stitched": 1, "list": 3}
_LENGTHS = 2
_SLICES = 50
_SLICE = 1 << 16  # of searched states or collapses between looks at signals: some hundredths of a second
_TOO_LARGE = 103  # RESTRIP_TOO_LARGE
_MOST_NEW = 18  # RESTRIP_MOST_NEW_VERTICES
_MOST = 2 * sys.maxsize + 1  # of size_t
_GAP = 1 << 20  # vertex numbers further above the number of corners are sparse
_NEEDS_32 = "vertex 65,535 needs 32-bit indices; use index='auto'"


class Change(NamedTuple):
    """The result of an operation:
      halfedge  to the new vertex; after collapse one that leaves the vertex that stays, after flip the turned edge
      valence   triangles of the patch; 0 under the policy "bare"
      strips    change in the number of strips of the mesh
      isolated  change in the number of triangles that are a strip by themselves"""

    halfedge: int
    valence: int
    strips: int
    isolated: int


class Coloring(NamedTuple):
    """Strips counted from their definition."""

    triangles: int
    strips: int
    isolated: int
    valid: bool  #: False is an error in the library


class Report(NamedTuple):
    """A report on the faces given:
      degenerate_triangles    left out: a corner twice
      out_of_range_triangles  left out: a corner that is not below vertex_count
      boundary_edges          edges of one triangle
      non_manifold_edges      edges of three triangles or more: strips cross them in pairs of triangles wound alike
      inconsistent_edges      edges of two triangles that disagree in orientation: no strip crosses them
      non_manifold_vertices   of several fans, or on one of these edges: operations at them are refused"""

    degenerate_triangles: int
    out_of_range_triangles: int
    boundary_edges: int
    non_manifold_edges: int
    inconsistent_edges: int
    non_manifold_vertices: int


def _one_of(what: str, value: str, known: Union[Sequence[str], Dict[str, int]]) -> int:
    if value not in known:
        raise ValueError(f"{what} {value!r}: expected one of {', '.join(known)}")
    return known[value] if isinstance(known, dict) else known.index(value)


def _weight(value) -> float:
    try:
        weight = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"cache_weight must be a number, not {value!r}") from None
    if not 0 <= weight <= 1000:
        raise ValueError(f"cache_weight: expected 0 to 1000, found {value!r}")
    return weight


def _number(what: str, value, most: int = NONE) -> int:
    """An integer of Python or numpy from 0 to `most`."""
    try:
        number = operator.index(value)
    except TypeError:
        number = -1
    if not 0 <= number <= most:
        raise ValueError(f"{what} {value!r}: expected an integer from 0 to {most}")
    return number


def _numbers_of(what: str, values) -> np.ndarray:
    """Integers from 0 to NONE."""
    array = np.asarray(values)
    if array.size == 0:
        array = array.astype(np.uint32)
    if array.dtype.kind not in "iu":
        raise ValueError(f"{what}: expected an array of integers, found {array.dtype}")
    if array.size and not 0 <= array.min() <= array.max() <= NONE:
        raise ValueError(f"{what}: expected integers from 0 to {NONE}, found {array.min()} to {array.max()}")
    return np.ascontiguousarray(array, np.uint32).reshape(array.shape)


def _form(form: str) -> int:
    return _one_of("form", form, _FORMS)


def _cost(cost: Cost) -> lib.Cost:
    if isinstance(cost, str):
        _one_of("cost", cost, tuple(_COSTS))
        cost = _COSTS[cost]
    try:
        restart, swap, isolated = map(operator.index, cost)
        known = 1 <= restart <= 1000 and 0 <= swap <= 1000 and 0 <= isolated <= 1000
    except (TypeError, ValueError):
        known = False
    if not known:
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


def _numbers(address: Optional[int], count: int, dtype) -> np.ndarray:
    """The numbers there, while they are valid."""
    if not count:
        return np.empty(0, dtype)
    return np.frombuffer((ctypes.c_uint8 * (count * np.dtype(dtype).itemsize)).from_address(address), dtype)


def _array(view: lib.BufferView) -> Indices:
    """The indices of a view, while it is valid."""
    return _numbers(view.indices, view.index_count, np.uint16 if view.index_bits == 16 else np.uint32)


def _fitted(index: Optional[Index], name: str, *arguments) -> None:
    """lib.call, for indices of this width: too few bits are an error that names the remedy."""
    try:
        lib.call(name, *arguments)
    except RestripError as error:
        if error.code != _TOO_LARGE or index != 16:
            raise
        raise RestripError(error.code, f"{lib.shown(name)}: {_NEEDS_32}") from None


def _explained(name: str, *arguments) -> None:
    """lib.call, whose last arguments but one receive a text that says what is wrong."""
    text = ctypes.create_string_buffer(200)
    try:
        lib.call(name, *arguments[:-1], text, len(text), arguments[-1])
    except RestripError as error:
        if not text.value:
            raise
        raise RestripError(error.code, f"{lib.shown(name)}: {text.value.decode()}") from None


def _slots(kind: type) -> Tuple[str, ...]:
    slots = kind.__dict__.get("__slots__", ())
    return tuple(name for name in ((slots,) if isinstance(slots, str) else slots) if name not in ("__dict__", "__weakref__"))


def _loaded(kind: type, data: bytes) -> LiveMesh:
    """A copy of a mesh, of a class that may have another load()."""
    return LiveMesh.load.__func__(kind, data)  # type: ignore[attr-defined]


def _address(array: np.ndarray) -> ctypes.c_void_p:
    return array.ctypes.data_as(ctypes.c_void_p)


class Table:
    """The table of a custom operation, for LiveMesh.apply: `data` is the JSON that `restrip-generate rules --language json` or the page
    Make a rule writes, as json.load reads it. ValueError for a table that could spoil a mesh."""

    def __init__(self, data: Dict[str, Any]):
        self._positions: List[int] = []
        if not isinstance(data, dict) or data.get("format") != "restrip-operation-table":
            raise ValueError("Table: this is not the table of an operation; make one with restrip-generate rules --language json")
        for at in data["positions"]:
            if "triangles_before" not in at:
                raise ValueError(f"Table: {data['name']} has no triangles; make it with restrip-generate rules --language json")
            before, after = (np.asarray(at[f"triangles_{side}"], np.uint8).reshape(-1, 8) for side in ("before", "after"))
            size = 1 << (at["ports"] + (0 if data["matching"] else at["before"]["edges"]))
            entries = np.asarray(data["entries"][at["first"]:at["first"] + size], np.uint32)
            entries[entries == data["none"]] = NONE
            table = ctypes.c_void_p()
            _explained("table_make", lib.Operation(at["ports"], at["before"]["edges"], at["after"]["edges"], at["vertices"], bool(data["matching"]), _address(before),
                                                   len(before), _address(after), len(after), _address(entries), len(entries)), table)
            assert table.value is not None
            self._positions.append(table.value)

    def __del__(self) -> None:
        for address in getattr(self, "_positions", ()):
            lib.plain("table_free", address)


class LiveMesh:
    """A triangle mesh that changes, and its strips.

    `faces` has three columns, counter-clockwise; vertices are numbers below `vertex_count` (by default the largest plus
    one). Strips are made from scratch by `effort` ("fast", "full", "best"; None: every triangle is a strip) and maintained by
    `policy` ("bare", "rules", "local", "quick", "full": docs/reference/policies.md has figures) for `cost`: "strips",
    "indices", or a triple (restart, swap, isolated) of weights. Memory is linear in the faces and in the largest vertex
    number, about 17 bytes for each. Sparse vertices are refused: renumber them by
    `used, corners = np.unique(faces, return_inverse=True)`; with `corners.reshape(-1, 3)` in place of `faces`, `used[i]` is vertex i.

    Attributes: `report`, a Report, counts defects of the faces; faces that are left out give a warning. `outgrown` says
    whether the last update() needs a new buffer on the device, and `room` how many indices that buffer should hold.

    A halfedge is a number: a directed mesh edge whose triangle lies to its left. Side s of triangle t, 4 t + s, leads from
    corner s to corner s + 1 (after 2 comes 0). Other numbers name halfedges on the boundary, which have no triangle. Triangles
    are numbered in the order of their faces, without faces that are left out. One mesh may be read by several threads, or be
    changed by one.
    """

    report: Report
    outgrown: bool
    room: int

    def __init__(self, faces: ArrayLike, vertex_count: Optional[int] = None, *, policy: Policy = "quick", cost: Cost = "indices",
                 effort: Optional[Effort] = "fast"):
        self._handle: Optional[int] = None
        self.outgrown, self.room, self._index = False, 0, None
        corners = _corners(faces, NONE)
        if vertex_count is None:
            vertex_count = int(corners.max()) + 1 if corners.size else 0
            if vertex_count > corners.size + _GAP:
                raise ValueError(f"faces: vertex {vertex_count - 1} of {len(corners)} faces needs memory for all vertices below it; renumber sparse vertices "
                                 "by used, corners = numpy.unique(faces, return_inverse=True), or give vertex_count if you want that many")
        vertex_count = _number("vertex_count", vertex_count, NONE // 8)
        kept = _one_of("policy", policy, _POLICIES)
        report, mesh, weights = lib.BuildReport(), ctypes.c_void_p(), _cost(cost)
        lib.call("mesh_build_u32", _address(corners), corners.size, vertex_count, report, None, mesh)
        self._handle = mesh.value
        self.report = Report(*(getattr(report, name) for name in Report._fields))
        left_out = self.report.degenerate_triangles + self.report.out_of_range_triangles
        if left_out:
            warnings.warn(f"restrip: {left_out} of {len(corners)} faces are left out: {self.report}", stacklevel=2)
        if effort is not None:
            self.stripify(effort, cost)
        lib.call("mesh_keep", self._mesh, kept, weights)

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            lib.plain("mesh_free", self._handle)

    def close(self) -> None:
        """Frees the memory of the mesh now; it must not be used afterwards. `with LiveMesh(…) as mesh:` does this at the end."""
        if self._handle is not None:
            lib.plain("mesh_free", self._handle)
            self._handle = None

    @property
    def _mesh(self) -> int:
        if self._handle is None:
            raise ValueError("this LiveMesh is closed")
        return self._handle

    def __enter__(self) -> LiveMesh:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def __len__(self) -> int:
        """The number of triangles."""
        return self.triangle_count

    def __bool__(self) -> bool:
        return True

    def __repr__(self) -> str:
        if self._handle is None:
            return "<restrip.LiveMesh, closed>"
        return f"<restrip.LiveMesh of {self.triangle_count} triangles in {self.strip_count} strips>"

    def __reduce__(self) -> Tuple[Any, ...]:
        """With what programs noted on it; the history is not copied."""
        noted = {name: value for name, value in self.__dict__.items() if name not in ("_handle", "outgrown", "room")}
        slots = {name: getattr(self, name) for kind in type(self).__mro__ for name in _slots(kind) if hasattr(self, name)}
        return _loaded, (type(self), self.save()), (noted, slots)

    def save(self) -> bytes:
        """Faces, numbers, colours, policy, cost and format, the same on every machine: 13 bytes a face, and a bit for each number.
        Frames of undo() are not saved, and the loaded mesh begins its buffer again. Copies and pickles are made of these bytes and of the
        attributes that programs add."""
        data, size = ctypes.c_void_p(), ctypes.c_size_t()
        lib.call("mesh_save", self._mesh, data, size)
        return ctypes.string_at(data, size.value)

    @classmethod
    def load(cls, data: bytes, history: int = 0) -> LiveMesh:
        """The mesh that save() has written; copy buffer() to a device with `room` indices. `history` is as in begin_buffer().
        RestripError for bytes that are truncated or altered; bytes from an untrusted source are safe."""
        data, mesh, view, room = bytes(data), ctypes.c_void_p(), lib.BufferView(), ctypes.c_size_t()
        _explained("mesh_load", data, len(data), _number("history", history, _MOST), mesh)
        self = cls.__new__(cls)
        self._handle, self.report, self._index = mesh.value, Report(0, 0, 0, 0, 0, 0), None
        lib.call("live_buffer", self._mesh, view, room)
        self.outgrown, self.room = False, room.value
        return self

    # ---- size and counts

    @property
    def triangle_count(self) -> int:
        return lib.plain("mesh_triangle_count", self._mesh)

    @property
    def triangle_bound(self) -> int:
        """An upper bound: triangle numbers are below it. A triangle keeps its number until it is removed; then the next new
        triangle takes it. The numbers in use are those of strips()."""
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
        """The vertices of a triangle, counter-clockwise. RestripError if no triangle has this number."""
        found = np.empty(3, np.uint32)
        try:
            lib.call("mesh_corners", self._mesh, _number("triangle", triangle), _address(found))
        except RestripError as error:
            raise RestripError(error.code, f"corners: no triangle has the number {triangle}") from None
        a, b, c = found.tolist()
        return a, b, c

    def faces(self) -> Numbers:
        """All triangles, three columns, in the order of the strips. O(triangles)."""
        return self.indices("list", 32).reshape(-1, 3)

    # ---- halfedges: NONE if it does not exist

    def find(self, v: int, w: int) -> int:
        """The halfedge from vertex v to vertex w; NONE if the mesh has no such edge."""
        return lib.plain("mesh_find", self._mesh, _number("vertex", v), _number("vertex", w))

    def find_each(self, v: ArrayLike, w: ArrayLike) -> Numbers:
        """find() for arrays of vertices, or an array and a vertex: an array of halfedges, in one call."""
        v, w = np.broadcast_arrays(_numbers_of("vertex", v), _numbers_of("vertex", w))
        v, w, found = np.ascontiguousarray(v), np.ascontiguousarray(w), np.empty(v.shape, np.uint32)
        lib.call("mesh_find_each", self._mesh, found.size, _address(v), _address(w), _address(found))
        return found

    def spoke(self, v: int) -> int:
        """A halfedge that leaves v; NONE if v has no triangles. On the boundary turning counter-clockwise from it meets all
        triangles of v."""
        return lib.plain("mesh_spoke", self._mesh, _number("vertex", v))

    def next(self, halfedge: int) -> int:
        """The next one around the triangle; NONE on the boundary."""
        return lib.plain("mesh_next", self._mesh, _number("halfedge", halfedge))

    def opposite(self, halfedge: int) -> int:
        """The same mesh edge in the other direction. At the boundary it has no triangle."""
        return lib.plain("mesh_opposite", self._mesh, _number("halfedge", halfedge))

    def ends(self, halfedge: int) -> Tuple[int, int]:
        """The vertices that it leaves and leads to."""
        halfedge = _number("halfedge", halfedge)
        return lib.plain("mesh_from", self._mesh, halfedge), lib.plain("mesh_to", self._mesh, halfedge)

    def triangle(self, halfedge: int) -> int:
        """The triangle to its left; NONE on the boundary."""
        return lib.plain("mesh_triangle", self._mesh, _number("halfedge", halfedge))

    def solid(self, halfedge: int) -> bool:
        """Whether a strip crosses the mesh edge."""
        return bool(lib.plain("mesh_solid", self._mesh, _number("halfedge", halfedge)))

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

    def split_at(self, v: int, left: int, right: int, vertex: int = NONE) -> Change:
        """split() along the edges from vertex v to the vertices `left` and `right`, of which one may be NONE on the boundary."""
        return self._done("mesh_split_at", v, left, right, vertex)

    def collapse_at(self, v: int, w: int) -> Change:
        """collapse() of the edge from v to w, which goes."""
        return self._done("mesh_collapse_at", v, w)

    def flip_at(self, v: int, w: int) -> Change:
        """flip() of the edge between v and w."""
        return self._done("mesh_flip_at", v, w)

    def replace(self, triangles: ArrayLike, faces: ArrayLike) -> Change:
        """Any change of a few triangles: removes `triangles`, adds `faces`, three vertices each; either may be empty. Vertices that are
        not in use become new ones, vertices left without triangles go. Refused unless the mesh stays a manifold with boundary."""
        gone, made, change = _numbers_of("triangles", triangles).ravel(), _corners(faces, NONE), lib.Change()
        _fitted(self._index, "mesh_replace", self._mesh, _address(gone), gone.size, _address(made), len(made), change)
        return Change(change.halfedge, change.valence, change.strips, change.isolated)

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

    def apply(self, table: Table, halfedge: int) -> Tuple[Change, List[int]]:
        """Does a custom operation; the halfedge is the side from the first vertex to the second of the first triangle under `before`
        of its file. Returns the change, whose halfedge is the same side of the first triangle under `after`, and the new vertices
        in the order of the file. Of a family the first position that fits is done."""
        halfedge, refusal = _number("halfedge", halfedge), None
        for address in table._positions:
            added, count, change = np.empty(_MOST_NEW, np.uint32), ctypes.c_size_t(), lib.Change()
            try:
                _fitted(self._index, "mesh_apply", self._mesh, address, halfedge, change, _address(added), count)
            except RestripError as error:
                refusal = refusal or error
            else:
                return Change(change.halfedge, change.valence, change.strips, change.isolated), added[:count.value].tolist()
        raise refusal or ValueError("apply: the table has no positions")

    def play(self, records: ArrayLike, forward: bool = True) -> None:
        """Splits vertices by records, in their order; with forward=False collapses them again, the last one first. A record, of four
        columns, splits v_t off v_s, between v_l and v_r (NONE on the boundary). Records come from a simplifier: `restrip simplify
        -o x.pm` writes them, or yours, by collapse(find(v_s, v_t)); v_l and v_r are the third vertices of the faces to its left and
        right before it, and the last collapse is the first record. RestripError if the mesh refuses one: the earlier ones are
        played."""
        records = _numbers_of("records", records)
        if records.ndim != 2 or records.shape[1] != 4:
            raise ValueError(f"records: expected four columns, found the shape {records.shape}")
        done, total = 0, len(records)
        while done < total:
            size, played = min(_SLICE, total - done), ctypes.c_size_t()
            part = np.ascontiguousarray(records[done:done + size] if forward else records[total - done - size:total - done])
            try:
                lib.call("mesh_play", self._mesh, _address(part), size, int(forward), played)
            except RestripError as error:
                at = done + played.value
                raise RestripError(error.code, f"record {at if forward else total - 1 - at}: {self._refusal(error.code)}") from None
            done += size

    def why_not(self, operation: str, *arguments: int) -> Optional[str]:
        """Why an operation of this name would be refused; None: it would be done."""
        _one_of("operation", operation, ("split", *lib.AT_HALFEDGE))
        if operation == "split" and len(arguments) == 2:
            arguments = (*arguments, NONE)
        if len(arguments) != (3 if operation == "split" else 1):
            needed = "left, right and perhaps vertex" if operation == "split" else "a halfedge"
            raise TypeError(f"why_not: {operation} needs {needed}, found {arguments}")
        values = [_number(operation, each) for each in arguments]
        code = lib.plain("mesh_check_split", self._mesh, *values) if operation == "split" else int(self.check_each(operation, values)[0])
        return None if code == 0 else self._refusal(code)

    def check_each(self, operation: Operation, halfedges: ArrayLike) -> NDArray[np.int32]:
        """Whether each operation would be done, by itself: an array of codes, 0 if it would, else the `code` of the RestripError
        that refuses it; describe(code) says why. One call for all."""
        return self._each("mesh_check_each", operation, halfedges)

    def apply_each(self, operation: Operation, halfedges: ArrayLike) -> Tuple[NDArray[np.int32], NDArray[Any]]:
        """Does the operation at each halfedge, in their order and in one call; those that are refused are left out. Returns the
        codes, as check_each, and an array with the fields of Change: `changes["halfedge"][codes == 0]`. The halfedge of a
        refusal is NONE. An operation may remove the halfedge of a later one."""
        given = _numbers_of("halfedge", halfedges)
        changes = np.zeros(given.shape, np.dtype(lib.Change))
        changes["halfedge"] = NONE
        return self._each("mesh_apply_each", operation, given, _address(changes)), changes

    # ---- strips

    def stripify(self, effort: Effort = "fast", cost: Cost = "indices") -> int:
        """Strips from scratch; returns their number. Ctrl-C ends it, with the best strips found so far."""
        count = ctypes.c_size_t()
        with lib.interrupted() as stop:
            lib.call("mesh_stripify_until", self._mesh, _one_of("effort", effort, _EFFORTS), _cost(cost), 0, stop, None, count)
        return count.value

    def keep(self, policy: Policy, cost: Cost = "indices") -> None:
        """From now on operations maintain the strips by this policy, for this cost."""
        lib.call("mesh_keep", self._mesh, _one_of("policy", policy, _POLICIES), _cost(cost))

    def improve(self, budget: int, progress: Optional[Progress] = None) -> int:
        """Examines about `budget` states of searches for better strips, a few hundred nanoseconds each; returns how much
        the cost is lower. `progress(done, budget, saved)` is called some fifty times; it may stop the search by returning
        True."""
        budget = _number("budget", budget, _MOST)
        saved, done, part = 0, 0, ctypes.c_size_t()
        while done < budget:
            size = min(budget - done, _SLICE if progress is None else max(1, budget // _SLICES))
            lib.call("mesh_improve", self._mesh, size, part)
            done, saved = done + size, saved + part.value
            if progress is not None and progress(done, budget, saved):
                break
        return saved

    def indices(self, form: Form = "restart", index: Index = "auto", *, cache_size: int = 0, cache_weight: float = 0) -> Indices:
        """The index buffer of the strips, in one of the forms
          "restart"   one triangle strip with primitive restart: all bits set between two strips,
          "stitched"  one triangle strip without: repeated indices lead from strip to strip,
          "list"      a triangle list.
        `index` is 16, 32 or "auto", 16 bits if all vertices are below 65,535. With `cache_size` the strips are cut, joined
        and ordered for a first-in-first-out vertex cache of that many vertices, 16 for most hardware; the mesh keeps its own. `cache_weight`, up
        to 1000, is the number of indices that a miss is worth; 0 is the default."""
        return self._made(_form(form), index, cache_size, cache_weight)[0]

    def strip_indices(self, index: Index = "auto", *, cache_size: int = 0, cache_weight: float = 0) -> List[Indices]:
        """The indices of each strip; an index is repeated if a strip turns twice the same way. For the cache see `indices`."""
        indices, draws = self._made(_LENGTHS, index, cache_size, cache_weight)
        return [indices[first:first + count] for first, count in draws]

    def strips(self) -> List[Numbers]:
        """The triangles of each strip, by their numbers, in their order."""
        triangles, starts = np.empty(self.triangle_count, np.uint32), np.empty(self.strip_count + 1, np.uintp)
        lib.call("mesh_strips", self._mesh, _address(triangles), triangles.size, _address(starts), starts.size)
        return np.split(triangles, starts[1:-1]) if len(triangles) else []

    @property
    def colors(self) -> NDArray[np.uint8]:
        """One byte for each triangle number: bit s is set when a strip crosses side s. May be set to such an array."""
        colors = np.empty(self.triangle_bound, np.uint8)
        lib.call("mesh_get_colors", self._mesh, _address(colors), colors.size)
        return colors

    @colors.setter
    def colors(self, colors: ArrayLike) -> None:
        colors = np.asarray(colors)
        if colors.size == 0:
            colors = colors.astype(np.uint8)
        if colors.ndim != 1 or colors.dtype.kind not in "iu" or (colors.size and not 0 <= colors.min() <= colors.max() <= 7):
            raise ValueError(f"colors: expected integers from 0 to 7 in one dimension, one for each triangle number, found {colors.dtype} of shape "
                             f"{colors.shape}" + (f", {colors.min()} to {colors.max()}" if colors.size and colors.dtype.kind in "iuf" else ""))
        if colors.size != self.triangle_bound:
            raise ValueError(f"colors: expected {self.triangle_bound} numbers, one for each triangle number, found {colors.size}")
        colors = np.ascontiguousarray(colors, dtype=np.uint8)
        lib.call("mesh_set_colors", self._mesh, _address(colors), colors.size)

    # ---- the index buffer that follows the mesh

    def begin_buffer(self, form: Form = "restart", index: Index = "auto", history: int = 0, *, cache_size: int = 32, waste: int = 95,
                     work: int = 5) -> None:
        """Starts the index buffer of the mesh, instead of a previous one, in a form of `indices`; without this call the first
        update starts it in the form "restart". An update of "list"
        writes less than an update of strips. With "auto" it has 16 bits until a vertex needs 32; with 16, operations that would
        add such a vertex are refused. With a `history` each update, from the next one on,
        ends a frame that can be undone; all frames together keep about that many changed triangles, 50 bytes each. Strips are
        put in order for a cache of `cache_size` vertices, up to 64 (0: no order); gaps and cuts may add `waste` per mille of the
        indices, and an update moves up to `work` indices for each changed one to keep it so."""
        history = _number("history", history, _MOST)
        layout = lib.Layout(_number("cache_size", cache_size, 64), _number("waste", waste, 1_000_000), _number("work", work, 100))
        lib.call("live_begin", self._mesh, lib.Format(_form(form), _bits(index), 0, 0, 1), layout, history)
        self._index = index

    def undo(self) -> bool:
        """Undoes the last frame; changes since the last update are a frame. Faces, numbers and strips are
        restored, and the next update draws them as after any change. False if no frame is left. Linear in the frame."""
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

    def update(self, merge_gap: int = 0, align: int = 4) -> List[Tuple[int, Indices]]:
        """Brings the buffer in step with the mesh. Returns the parts that may have changed, each with its first place, to be
        copied to the device. Parts at most `merge_gap` indices apart are joined, and begin and end at multiples of `align`
        bytes: 2, or a multiple of 4. Then `outgrown` says whether the buffer has outgrown the `room` that it had, or its
        width: the device needs a new one, of `room` indices, and the only part is the whole buffer. Linear in the changes."""
        merge_gap, align = _number("merge_gap", merge_gap, _MOST), _number("align", align, _MOST)
        if align != 2 and (align == 0 or align % 4 != 0):
            raise ValueError(f"align {align}: expected 2 or a multiple of 4")
        ranges, count, outgrown = ctypes.POINTER(lib.Range)(), ctypes.c_size_t(), ctypes.c_int32()
        _fitted(self._index, "live_update", self._mesh, merge_gap, align, ranges, count, outgrown)
        view, room = lib.BufferView(), ctypes.c_size_t()
        lib.call("live_buffer", self._mesh, view, room)
        self.outgrown, self.room = bool(outgrown.value), room.value
        indices = _array(view)
        return [(ranges[i].first, indices[ranges[i].first:ranges[i].first + ranges[i].count].copy()) for i in range(count.value)]

    @property
    def index_count(self) -> int:
        """The number of indices to draw after the last update: the length of the buffer, or of a list three for each triangle.
        O(1)."""
        view = lib.BufferView()
        lib.call("live_buffer", self._mesh, view, None)
        return sum(view.draws[i].count for i in range(view.draw_count))

    def buffer(self) -> Indices:
        """A copy of the whole buffer after the last update, a multiple of four bytes: a 16-bit list may end with an index
        that does not belong to a triangle and is not counted by `index_count`."""
        view = lib.BufferView()
        lib.call("live_buffer", self._mesh, view, None)
        return _array(view).copy()

    # ---- private

    def _stepped(self, name: str) -> bool:
        done = ctypes.c_int32()
        lib.call(name, self._mesh, done)
        return bool(done.value)

    def _made(self, form: int, index: Index, cache_size: int = 0, cache_weight: float = 0) -> Tuple[np.ndarray, List[Tuple[int, int]]]:
        """A buffer of the strips, and the ranges to draw separately."""
        buffer, view = ctypes.c_void_p(), lib.BufferView()
        wanted = lib.Format(form, _bits(index), 0, 0, 1)
        _fitted(index, "mesh_buffer", self._mesh, lib.Cache(_number("cache_size", cache_size), _weight(cache_weight)), wanted, buffer)
        try:
            lib.call("buffer_read", buffer, view)
            return _array(view).copy(), [(view.draws[i].first, view.draws[i].count) for i in range(view.draw_count)]
        finally:
            lib.plain("buffer_free", buffer)

    def _done(self, name: str, *arguments: int) -> Change:
        change = lib.Change()
        _fitted(self._index, name, self._mesh, *(_number("halfedge", each) for each in arguments), change)
        return Change(change.halfedge, change.valence, change.strips, change.isolated)

    def _each(self, name: str, operation: str, halfedges, *changes: object) -> np.ndarray:
        halfedges = _numbers_of("halfedge", halfedges)
        codes = np.empty(halfedges.shape, np.int32)
        lib.call(name, self._mesh, _one_of("operation", operation, lib.AT_HALFEDGE), codes.size, _address(halfedges), _address(codes), *changes)
        if (codes == lib.OUT_OF_MEMORY).any():
            raise MemoryError(lib.describe(lib.OUT_OF_MEMORY))
        return codes

    def _refusal(self, code: int) -> str:
        return _NEEDS_32 if code == _TOO_LARGE and self._index == 16 else lib.describe(code)


_Strips = Literal["strips"]
_Restart = Literal["restart", "stitched"]


@overload
def strips_of(faces: ArrayLike, cost: Cost = ..., format: _Restart = ..., *, effort: Effort = ..., vertex_count: Optional[int] = ..., index: Index = ...,
              cache_size: int = ..., cache_weight: float = ..., progress: Optional[Progress] = ...) -> Indices: ...
@overload
def strips_of(faces: ArrayLike, cost: Cost, format: _Strips, *, effort: Effort = ..., vertex_count: Optional[int] = ..., index: Index = ...,
              cache_size: int = ..., cache_weight: float = ..., progress: Optional[Progress] = ...) -> List[Indices]: ...
@overload
def strips_of(faces: ArrayLike, cost: Cost = ..., *, format: _Strips, effort: Effort = ..., vertex_count: Optional[int] = ..., index: Index = ...,
              cache_size: int = ..., cache_weight: float = ..., progress: Optional[Progress] = ...) -> List[Indices]: ...
@overload
def strips_of(faces: ArrayLike, cost: Cost, format: Literal["vtk"], *, effort: Effort = ..., vertex_count: Optional[int] = ..., index: Index = ...,
              cache_size: int = ..., cache_weight: float = ..., progress: Optional[Progress] = ...) -> NDArray[np.int64]: ...
@overload
def strips_of(faces: ArrayLike, cost: Cost = ..., *, format: Literal["vtk"], effort: Effort = ..., vertex_count: Optional[int] = ..., index: Index = ...,
              cache_size: int = ..., cache_weight: float = ..., progress: Optional[Progress] = ...) -> NDArray[np.int64]: ...
@overload
def strips_of(faces: ArrayLike, cost: Cost = ..., format: Format = ..., *, effort: Effort = ..., vertex_count: Optional[int] = ..., index: Index = ...,
              cache_size: int = ..., cache_weight: float = ..., progress: Optional[Progress] = ...) -> Union[Indices, List[Indices], NDArray[np.int64]]: ...
def strips_of(faces: ArrayLike, cost: Cost = "indices", format: Format = "restart", *, effort: Effort = "fast", vertex_count: Optional[int] = None,
              index: Index = "auto", cache_size: int = 0, cache_weight: float = 0,
              progress: Optional[Progress] = None) -> Union[Indices, List[Indices], NDArray[np.int64]]:
    """Triangle strips of a mesh.

    `format` is
      "restart"   one array of indices, to be drawn as a triangle strip with primitive restart (all bits set),
      "stitched"  one array, a triangle strip without restart: repeated indices lead from strip to strip,
      "strips"    a list of arrays, one for each strip,
      "vtk"       one array, in which each strip follows the number of its indices, as in vtkPolyData and pyvista.
    Windings are kept; an index is repeated if a strip turns twice the same way. `index` is 16, 32 or "auto". `cache_size` and
    `cache_weight` are as for LiveMesh.indices.
    Memory is linear in the faces, whatever the vertex numbers. If a triangle list has fewer indices than the array that is returned, a warning says so. With `progress` the strips of the
    effort "fast" are improved step by step, and progress(done, budget, saved) is called in between; it may stop that by
    returning True.
    """
    _one_of("format", format, _FORMATS)
    _one_of("effort", effort, _EFFORTS)
    corners = _corners(faces, NONE)
    if vertex_count is None:
        vertex_count = int(corners.max()) + 1 if corners.size else 0
    used = None
    if _number("vertex_count", vertex_count) > corners.size + _GAP:  # sparse: renumbered without gaps
        used, inverse = np.unique(corners, return_inverse=True)
        corners, vertex_count = inverse.reshape(-1, 3), int(np.searchsorted(used, vertex_count))
    mesh = LiveMesh(corners, vertex_count, policy="full", cost=cost, effort=effort if progress is None else "fast")
    if progress is not None:
        mesh.improve({"fast": 1, "full": 40, "best": 400}[effort] * max(1, mesh.triangle_count), progress)
    if format in _FORMS:
        indices = _renamed(mesh.indices(format, index if used is None else 32, cache_size=cache_size, cache_weight=cache_weight), used, index)
        if len(indices) > 3 * mesh.triangle_count:
            warnings.warn(f"restrip: these strips have {len(indices)} indices, a triangle list has {3 * mesh.triangle_count}", stacklevel=2)
        return indices
    strips = mesh.strip_indices(index if used is None else 32, cache_size=cache_size, cache_weight=cache_weight)
    if used is not None and strips:
        strips = np.split(_renamed(np.concatenate(strips), used, index), np.cumsum([len(strip) for strip in strips])[:-1])
    if format == "strips":
        return strips
    parts = [part for strip in strips for part in (np.array([len(strip)], np.int64), strip.astype(np.int64))]
    return np.concatenate(parts) if parts else np.empty(0, np.int64)


def _renamed(indices: np.ndarray, used: Optional[np.ndarray], index: Index) -> np.ndarray:
    """Indices of 32 bits with the vertices used[i] in place of i, in the width `index`; the same indices if `used` is None."""
    if used is None:
        return indices
    restarts = indices == NONE
    named = used[np.where(restarts, 0, indices)] if used.size else indices
    narrow = not named.size or named.max() < 0xFFFF
    if _bits(index) == 16 and not narrow:
        raise RestripError(_TOO_LARGE, f"indices: {_NEEDS_32}")
    dtype = np.dtype(np.uint16 if narrow and index != 32 else np.uint32)
    return np.where(restarts, np.iinfo(dtype).max, named).astype(dtype)


def faces_of(indices: ArrayLike) -> Indices:
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
