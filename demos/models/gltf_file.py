"""Writes glTF files of one mesh with the buffer inside."""

import base64
import json
import pathlib
import struct

BYTE, SHORT, FLOAT = 5121, 5123, 5126


def as_floats(row):
    """What a file holds of these numbers: five digits behind the point, so that the last bits of a machine's sine do
    not matter, rounded to binary32, so that bounds are those of the data."""
    digits = [round(x, 5) + 0.0 for x in row]
    return list(struct.unpack(f"<{len(row)}f", struct.pack(f"<{len(row)}f", *digits)))


class GltfFile:
    """Arrays are appended to its buffer; accessors are named by their numbers."""

    def __init__(self):
        self.data = b""
        self.views, self.accessors = [], []

    def view(self, values, code):
        raw = struct.pack(f"<{len(values)}{code}", *values)
        self.data += b"\0" * (-len(self.data) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(raw)})
        self.data += raw
        return len(self.views) - 1

    def accessor(self, kind, component, count, **more):
        self.accessors.append({"componentType": component, "count": count, "type": kind, **more})
        return len(self.accessors) - 1

    def vectors(self, rows):
        rows = [as_floats(row) for row in rows]
        flat = [x for row in rows for x in row]
        bounds = {"min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]}
        return self.accessor("VEC3", FLOAT, len(rows), bufferView=self.view(flat, "f"), **bounds)

    def colors(self, rows):
        """Linear red, green, blue from 0 to 1, in 256 steps."""
        flat = [round(255 * x) for row in rows for x in (*row, 1)]
        return self.accessor("VEC4", BYTE, len(rows), normalized=True, bufferView=self.view(flat, "B"))

    def indices(self, triangles):
        flat = [i for triangle in triangles for i in triangle]
        return self.accessor("SCALAR", SHORT, len(flat), bufferView=self.view(flat, "H"))

    def displacements(self, count, vertices, rows):
        """Of some of `count` vertices; `vertices` is the view of their numbers, which ascend. The others stay."""
        rows = [as_floats(row) for row in rows]
        with_zero = [[0.0] * 3, *rows]
        bounds = {"min": [min(c) for c in zip(*with_zero)], "max": [max(c) for c in zip(*with_zero)]}
        sparse = {
            "count": len(rows),
            "indices": {"bufferView": vertices, "componentType": SHORT},
            "values": {"bufferView": self.view([x for row in rows for x in row], "f")},
        }
        return self.accessor("VEC3", FLOAT, count, sparse=sparse, **bounds)

    def write(self, path, primitive, target_names=(), material=None):
        name = pathlib.Path(path).stem
        mesh = {"name": name, "primitives": [primitive]}
        if target_names:
            mesh |= {"extras": {"targetNames": list(target_names)}, "weights": [0.0] * len(target_names)}
        if material:
            primitive["material"] = 0
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        gltf = {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"name": name, "mesh": 0}],
            "meshes": [mesh],
            **({"materials": [material]} if material else {}),
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.data), "uri": uri}],
        }
        pathlib.Path(path).write_text(json.dumps(gltf, separators=(",", ":")) + "\n")
