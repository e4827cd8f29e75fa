"""Maintains strips from Python, by ctypes and the shared library: keep_strips.py [LIBRARY]"""
import ctypes
import sys
from ctypes import POINTER, byref, c_char_p, c_int32, c_size_t, c_uint16, c_uint32, c_uint64, c_void_p

lib = ctypes.CDLL(sys.argv[1] if len(sys.argv) > 1 else "librestrip_c.so.3")
NONE = 0xFFFFFFFF
EFFORT_FULL, POLICY_QUICK = 1, 3


class Change(ctypes.Structure):
    _fields_ = [("halfedge", c_uint32), ("valence", c_uint32), ("strips", c_int32), ("isolated", c_int32)]


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
indices_u16 = checked("mesh_strip_indices_u16", c_void_p, POINTER(c_uint16), c_size_t, POINTER(c_size_t))
find = declare("mesh_find", c_uint32, c_void_p, c_uint32, c_uint32)
free = declare("mesh_free", None, c_void_p)
if declare("abi_version", c_uint32)() != 3:
    sys.exit("the library has another interface")


def strip_indices(mesh):
    count = c_size_t()
    indices_u16(mesh, None, 0, byref(count))
    buffer = (c_uint16 * count.value)()
    indices_u16(mesh, buffer, count, byref(count))
    return ["|" if i == 0xFFFF else i for i in buffer]


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
