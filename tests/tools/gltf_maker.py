"""glTF files made by the specification, with no code of restrip's."""
import base64
import copy
import json
import struct

BYTE, UBYTE, SHORT, USHORT, UINT, FLOAT = 5120, 5121, 5122, 5123, 5125, 5126
LETTER = {BYTE: "b", UBYTE: "B", SHORT: "h", USHORT: "H", UINT: "I", FLOAT: "f"}


def glb_bytes(doc, binary):
    text = json.dumps(doc).encode()
    text += b" " * (-len(text) % 4)
    binary = bytes(binary) + b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def edited_glb(data, edit):
    """The bytes of a GLB after edit(doc, binary)."""
    (size,) = struct.unpack_from("<I", data, 12)
    doc, binary = json.loads(data[20:20 + size]), bytearray(data[28 + size:])
    edit(doc, binary)
    return glb_bytes(doc, binary)


class File:
    """A document and the buffer that it grows."""

    def __init__(self, required=()):
        self.binary = b""
        self.doc = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": 0}], "bufferViews": [], "accessors": [],
                    "meshes": [{"primitives": []}]}
        if required:
            self.doc |= {"extensionsUsed": list(required), "extensionsRequired": list(required)}

    def view(self, data, stride=None):
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        self.doc["bufferViews"].append(view | ({"byteStride": stride} if stride else {}))
        self.binary += data
        self.doc["buffers"][0]["byteLength"] = len(self.binary)
        return len(self.doc["bufferViews"]) - 1

    def accessor(self, values, kind, component, stride=None, before=0, **more):
        rows = [struct.pack(f"<{len(row)}{LETTER[component]}", *row) for row in values]
        data = b"".join(row.ljust(stride or 0, b"\xAA") for row in rows)
        view = self.view(b"\xBB" * before + data, stride)
        about = {"bufferView": view, "componentType": component, "count": len(values), "type": kind} | more
        self.doc["accessors"].append(about | ({"byteOffset": before} if before else {}))
        return len(self.doc["accessors"]) - 1

    def positions(self, points, **more):
        return self.accessor(points, "VEC3", 5126, **more)

    def indices(self, indices, component=5123):
        return self.accessor([[i] for i in indices], "SCALAR", component)

    def primitive(self, positions, indices=None, mode=None, mesh=0, **attributes):
        about = {"attributes": {"POSITION": positions} | attributes}
        about |= {} if indices is None else {"indices": indices}
        self.doc["meshes"][mesh]["primitives"].append(about | ({} if mode is None else {"mode": mode}))

    def glb(self):
        return glb_bytes(self.doc, self.binary)

    def gltf(self, uri=None):
        doc = copy.deepcopy(self.doc)
        doc["buffers"][0]["uri"] = uri or "data:application/octet-stream;base64," + base64.b64encode(self.binary).decode()
        return json.dumps(doc).encode()
