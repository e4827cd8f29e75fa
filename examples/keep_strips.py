"""Maintains strips from Python, by ctypes and the shared library: keep_strips.py [LIBRARY]"""
import ctypes
import sys
from ctypes import POINTER, byref, c_char_p, c_int32, c_size_t, c_uint16, c_uint32, c_uint64, c_void_p

lib = ctypes.CDLL(sys.argv[1] if len(sys.argv) > 1 else "librestrip_c.so.4")
NONE = 0xFFFFFFFF
EFFORT_FULL, POLICY_QUICK = 1, 3


class Change(ctypes.Structure):
    _fields_ = [("halfedge", c_uint32), ("valence", c_uint32), ("strips", c_int32), ("isolated", c_int32)]


class Format(ctypes.Structure):
    _fields_ = [("form", c_int32), ("index_bits", c_int32), ("most_vertices", c_size_t), ("most_indices", c_size_t), ("keep_strips", c_int32)]


class View(ctypes.Structure):
    _fields_ = [("indices", POINTER(c_uint16)), ("count", c_size_t), ("index_bits", c_int32), ("form", c_int32), ("draws", c_void_p), ("draw_count", c_size_t),
                ("triangles", c_size_t)]


def declare(name, result, *arguments):
    function = getattr(lib, "restrip_" + name)
    function.restype, function.argtypes = result, arguments
    return function


describe = declare("describe", c_char_p, c_int32)


def checked(name, *arguments):
    """The function, with an exception instead of a code."""
    function = declare(name, c_int32, *arguments)

    def call(*values):
        status = function(*values)
        if status != 0:
            raise RuntimeError(describe(status).decode())
    return call


build = checked("mesh_build_u32", POINTER(c_uint32), c_size_t, c_size_t, c_void_p, c_void_p, POINTER(c_void_p))
stripify = checked("mesh_stripify", c_void_p, c_int32, c_void_p, c_uint64, POINTER(c_size_t))
keep = checked("mesh_keep", c_void_p, c_int32, c_void_p)
split = checked("mesh_split", c_void_p, c_uint32, c_uint32, c_uint32, POINTER(Change))
collapse = checked("mesh_collapse", c_void_p, c_uint32, POINTER(Change))
flip = checked("mesh_flip", c_void_p, c_uint32, POINTER(Change))
buffer_of = checked("mesh_buffer", c_void_p, c_void_p, POINTER(Format), POINTER(c_void_p))
read_buffer = checked("buffer_read", c_void_p, POINTER(View))
free_buffer = declare("buffer_free", None, c_void_p)
find = declare("mesh_find", c_uint32, c_void_p, c_uint32, c_uint32)
free = declare("mesh_free", None, c_void_p)
if declare("abi_version", c_uint32)() != 4:
    sys.exit("the library has another interface")


def strip_indices(mesh):
    buffer, view = c_void_p(), View()
    buffer_of(mesh, None, Format(0, 16, 0, 0, 1), byref(buffer))
    read_buffer(buffer, byref(view))
    indices = ["|" if i == 0xFFFF else i for i in view.indices[:view.count]]
    free_buffer(buffer)
    return indices


faces = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5]  # an octahedron
mesh, strips, change = c_void_p(), c_size_t(), Change()
build((c_uint32 * len(faces))(*faces), len(faces), 6, None, None, byref(mesh))
stripify(mesh, EFFORT_FULL, None, 0, byref(strips))
print("strips from scratch:", strips.value)
print(*strip_indices(mesh))

keep(mesh, POLICY_QUICK, None)
split(mesh, find(mesh, 4, 0), find(mesh, 4, 1), NONE, byref(change))
print(f"a split changed the number of strips by {change.strips:+d}")
print(*strip_indices(mesh))
try:
    flip(mesh, find(mesh, 0, 1), None)
except RuntimeError as error:
    print("a flip was refused:", error)
collapse(mesh, change.halfedge, byref(change))
print(f"and the collapse back by {change.strips:+d}")
free(mesh)
