"""The C interface (restrip.h) by ctypes: the shared library in this package, and the types of its functions."""
from __future__ import annotations

import contextlib
import ctypes as c
import os
import pathlib
import signal
import threading
from typing import Any, Iterator, List

NONE = 0xFFFFFFFF
OUT_OF_MEMORY = 108  # RESTRIP_OUT_OF_MEMORY
ABI = 4  # RESTRIP_ABI_VERSION

AT_HALFEDGE = ("collapse", "flip", "split_face", "join_faces", "bisect", "merge")  # in the order of RESTRIP_COLLAPSE to RESTRIP_MERGE

_u32, _size, _mesh, _int = c.c_uint32, c.c_size_t, c.c_void_p, c.c_int32


class BuildReport(c.Structure):
    _fields_ = [(name, _size) for name in ("degenerate_triangles", "out_of_range_triangles", "boundary_edges", "non_manifold_edges",
                                           "inconsistent_edges", "non_manifold_vertices")]


class Coloring(c.Structure):
    _fields_ = [("triangles", _size), ("strips", _size), ("isolated", _size), ("valid", _int)]


class Cost(c.Structure):
    _fields_ = [("restart", c.c_uint16), ("swap", c.c_uint16), ("isolated", c.c_uint16)]


class Change(c.Structure):
    _fields_ = [("halfedge", _u32), ("valence", _u32), ("strips", _int), ("isolated", _int)]


class Operation(c.Structure):
    _fields_ = [("ports", _u32), ("edges_before", _u32), ("edges_after", _u32), ("vertices", _u32), ("matching", _int), ("before", c.c_void_p), ("before_count", _size),
                ("after", c.c_void_p), ("after_count", _size), ("entries", c.c_void_p), ("entry_count", _size)]


class Range(c.Structure):
    _fields_ = [("first", _size), ("count", _size)]


class Format(c.Structure):
    _fields_ = [("form", _int), ("index_bits", _int), ("most_vertices", _size), ("most_indices", _size), ("keep_strips", _int)]


class Layout(c.Structure):
    _fields_ = [("cache", _u32), ("waste", _u32), ("work", _u32)]


class Cache(c.Structure):
    _fields_ = [("size", _u32), ("weight", c.c_double)]


class BufferView(c.Structure):
    _fields_ = [("indices", c.c_void_p), ("index_count", _size), ("index_bits", _int), ("form", _int), ("draws", c.POINTER(Range)),
                ("draw_count", _size), ("triangles", _size)]


_change = c.POINTER(Change)
Stop = c.CFUNCTYPE(_int, c.c_void_p)
# Functions that return a status: the types of their arguments.
_checked = {
    "mesh_build_u32": [c.c_void_p, _size, _size, c.POINTER(BuildReport), c.c_void_p, c.POINTER(_mesh)],
    "mesh_corners": [_mesh, _u32, c.c_void_p],
    "mesh_get_colors": [_mesh, c.c_void_p, _size],
    "mesh_set_colors": [_mesh, c.c_void_p, _size],
    "mesh_check": [_mesh, c.POINTER(Coloring)],
    "mesh_strip_count": [_mesh, c.POINTER(_size)],
    "mesh_stripify_until": [_mesh, _int, c.POINTER(Cost), c.c_uint64, Stop, c.c_void_p, c.POINTER(_size)],
    "mesh_keep": [_mesh, _int, c.POINTER(Cost)],
    "mesh_split": [_mesh, _u32, _u32, _u32, _change],
    **{f"mesh_{name}": [_mesh, _u32, _change] for name in AT_HALFEDGE},
    "mesh_split_at": [_mesh, _u32, _u32, _u32, _u32, _change],
    **{f"mesh_{name}_at": [_mesh, _u32, _u32, _change] for name in ("collapse", "flip")},
    "mesh_replace": [_mesh, c.c_void_p, _size, c.c_void_p, _size, _change],
    "table_make": [c.POINTER(Operation), c.c_char_p, _size, c.POINTER(c.c_void_p)],
    "mesh_apply": [_mesh, c.c_void_p, _u32, _change, c.c_void_p, c.POINTER(_size)],
    "mesh_find_each": [_mesh, _size, c.c_void_p, c.c_void_p, c.c_void_p],
    "mesh_check_each": [_mesh, _int, _size, c.c_void_p, c.c_void_p],
    "mesh_apply_each": [_mesh, _int, _size, c.c_void_p, c.c_void_p, c.c_void_p],
    "mesh_improve": [_mesh, _size, c.POINTER(_size)],
    "mesh_strips": [_mesh, c.c_void_p, _size, c.c_void_p, _size],
    "mesh_play": [_mesh, c.c_void_p, _size, _int, c.POINTER(_size)],
    "mesh_buffer": [_mesh, c.POINTER(Cache), c.POINTER(Format), c.POINTER(c.c_void_p)],
    "buffer_read": [c.c_void_p, c.POINTER(BufferView)],
    "live_begin": [_mesh, c.POINTER(Format), c.POINTER(Layout), _size],
    "live_update": [_mesh, _size, _size, c.POINTER(c.POINTER(Range)), c.POINTER(_size), c.POINTER(_int)],
    "live_buffer": [_mesh, c.POINTER(BufferView), c.POINTER(_size)],
    "mesh_save": [_mesh, c.POINTER(c.c_void_p), c.POINTER(_size)],
    "mesh_load": [c.c_char_p, _size, _size, c.c_char_p, _size, c.POINTER(_mesh)],
    **{f"live_{name}": [_mesh, c.POINTER(_int)] for name in ("undo", "redo")},
    "live_history_size": [_mesh, c.POINTER(_size), c.POINTER(_size)],
}
# Functions that return a value.
_plain = {
    "abi_version": (_u32, []), "version": (c.c_char_p, []), "describe": (c.c_char_p, [_int]), "mesh_free": (None, [_mesh]), "buffer_free": (None, [c.c_void_p]),
    "table_free": (None, [c.c_void_p]),
    **{f"mesh_{name}": (_size, [_mesh]) for name in ("triangle_count", "triangle_bound", "vertex_bound")},
    "mesh_find": (_u32, [_mesh, _u32, _u32]),
    **{f"mesh_{name}": (_u32, [_mesh, _u32]) for name in ("spoke", "next", "opposite", "from", "to", "triangle")},
    "mesh_solid": (c.c_int, [_mesh, _u32]),
    "mesh_check_split": (_int, [_mesh, _u32, _u32, _u32]),
}


class RestripError(ValueError):
    """The library refused a call, and nothing changed. `code` is the number of restrip.h, 1 to 99 if
    an operation would damage the mesh."""

    def __init__(self, code: int, what: str):
        super().__init__(what)
        self.code = code


def _load() -> c.CDLL:
    named = os.environ.get("RESTRIP_C_LIBRARY")
    if named:
        found = [pathlib.Path(named)]
    else:
        found = [file for pattern in ("librestrip_c.*", "restrip_c.dll") for file in sorted(pathlib.Path(__file__).parent.glob(pattern))]
    if not found:
        raise ImportError("restrip: the C library is not in this package; install it with pip, or name the library by RESTRIP_C_LIBRARY")
    library = c.CDLL(str(found[0]))
    library.restrip_abi_version.restype = _u32
    if library.restrip_abi_version() != ABI:
        raise ImportError(f"restrip: {found[0]} has interface {library.restrip_abi_version()}, this package needs {ABI}")
    for name, (result, arguments) in {**_plain, **{name: (_int, arguments) for name, arguments in _checked.items()}}.items():
        function = getattr(library, "restrip_" + name)
        function.restype, function.argtypes = result, arguments
    return library


_library = _load()


def plain(name: str, *arguments):
    """The result of a function that cannot fail."""
    return getattr(_library, "restrip_" + name)(*arguments)


def describe(code: int) -> str:
    """What a `code` says: of RestripError, check_each() or apply_each()."""
    return plain("describe", code).decode()


def shown(name: str) -> str:
    """A function by its name in this package."""
    return {"live_begin": "begin_buffer", "mesh_buffer": "indices", "mesh_build_u32": "LiveMesh", "table_make": "Table", "mesh_stripify_until": "stripify"}.get(name, name.split("_", 1)[1])


@contextlib.contextmanager
def interrupted() -> Iterator[Any]:
    """A Stop that ends a call on Ctrl-C; the exception is raised when the call has ended. A callback cannot raise it, and
    Python handles signals in its main thread alone."""
    raised: List[BaseException] = []
    before = signal.getsignal(signal.SIGINT) if threading.current_thread() is threading.main_thread() else None

    def handle(number, frame) -> None:
        try:
            before(number, frame)
        except BaseException as error:
            raised.append(error)
    if callable(before):
        signal.signal(signal.SIGINT, handle)
    try:
        yield Stop(lambda _: len(raised))
    finally:
        if callable(before):
            signal.signal(signal.SIGINT, before)
    if raised:
        raise raised[0]


def call(name: str, *arguments) -> None:
    """Calls a function that returns a status. RestripError unless it succeeds; MemoryError if memory runs out."""
    code = getattr(_library, "restrip_" + name)(*arguments)
    if code == OUT_OF_MEMORY:
        raise MemoryError(describe(code))
    if code != 0:
        raise RestripError(code, f"{shown(name)}: {describe(code)}")
