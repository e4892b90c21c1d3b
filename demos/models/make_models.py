#!/usr/bin/env python3
"""Writes the models beside it: colored_cube.gltf and face.gltf, each with its buffer inside."""

import base64
import json
import math
import pathlib
import struct

FLOAT, SHORT = 5126, 5123


class Model:
    """A glTF file of one mesh; arrays are appended to its buffer."""

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
        flat = [x for row in rows for x in row]
        bounds = {"min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]}
        return self.accessor("VEC3", FLOAT, len(rows), bufferView=self.view(flat, "f"), **bounds)

    def indices(self, triangles):
        flat = [i for triangle in triangles for i in triangle]
        return self.accessor("SCALAR", SHORT, len(flat), bufferView=self.view(flat, "H"))

    def sparse_vectors(self, count, moved):
        """moved: vertex -> displacement; the others stay."""
        order = sorted(moved)
        zero_or = [[0.0] * 3] * (len(order) < count) + list(moved.values())
        bounds = {"min": [min(c) for c in zip(*zero_or)], "max": [max(c) for c in zip(*zero_or)]}
        sparse = {
            "count": len(order),
            "indices": {"bufferView": self.view(order, "H"), "componentType": SHORT},
            "values": {"bufferView": self.view([x for v in order for x in moved[v]], "f")},
        }
        return self.accessor("VEC3", FLOAT, count, sparse=sparse, **bounds)

    def write(self, name, primitive, target_names=()):
        mesh = {"name": name, "primitives": [primitive]}
        if target_names:
            mesh |= {"extras": {"targetNames": list(target_names)}, "weights": [0.0] * len(target_names)}
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        gltf = {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"name": name, "mesh": 0}],
            "meshes": [mesh],
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.data), "uri": uri}],
        }
        folder = pathlib.Path(__file__).parent
        (folder / f"{name}.gltf").write_text(json.dumps(gltf, separators=(",", ":")) + "\n")


def rounded(rows):
    """What a float holds, so that bounds are those of the data."""
    return [list(struct.unpack(f"<{len(row)}f", struct.pack(f"<{len(row)}f", *row))) for row in rows]


def colored_cube():
    """Six faces of four corners; a corner's colour is its place."""
    positions, normals, triangles = [], [], []
    for axis in range(3):
        for side in (-1.0, 1.0):
            first = len(positions)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner, normal = [0.0] * 3, [0.0] * 3
                corner[axis], normal[axis] = side, side
                corner[(axis + 1) % 3], corner[(axis + 2) % 3] = u * side, float(v)
                positions.append(corner)
                normals.append(normal)
            triangles += [[first, first + 1, first + 2], [first, first + 2, first + 3]]
    model = Model()
    attributes = {
        "POSITION": model.vectors(positions),
        "NORMAL": model.vectors(normals),
        "COLOR_0": model.vectors([[0.5 + 0.5 * x for x in p] for p in positions]),
    }
    model.write("colored_cube", {"attributes": attributes, "indices": model.indices(triangles)})


def face():
    """The front of a head with a nose, and 52 shapes: each lifts or pulls the skin around one place of it."""
    columns, rows = 25, 31

    def surface(u, v):
        x, y = 0.75 * math.sin(1.35 * u), math.sin(1.4 * v)
        nose = 0.3 * math.exp(-40 * u * u - 12 * (v + 0.1) ** 2)
        return [x, y, 0.8 * math.cos(1.35 * u) * math.cos(1.2 * v) + nose]

    grid = [(2 * i / (columns - 1) - 1, 2 * j / (rows - 1) - 1) for j in range(rows) for i in range(columns)]
    positions = rounded([surface(u, v) for u, v in grid])
    normals = []
    for u, v in grid:
        du = [a - b for a, b in zip(surface(u + 1e-4, v), surface(u - 1e-4, v))]
        dv = [a - b for a, b in zip(surface(u, v + 1e-4), surface(u, v - 1e-4))]
        n = [du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2], du[0] * dv[1] - du[1] * dv[0]]
        length = math.sqrt(sum(x * x for x in n))
        normals.append([x / length for x in n])
    triangles = []
    for j in range(rows - 1):
        for i in range(columns - 1):
            a, b, c, d = j * columns + i, j * columns + i + 1, (j + 1) * columns + i + 1, (j + 1) * columns + i
            triangles += [[a, b, c], [a, c, d]]

    model = Model()
    attributes = {"POSITION": model.vectors(positions), "NORMAL": model.vectors(rounded(normals))}
    targets, names = [], []
    for shape in range(52):
        u0, v0 = -0.8 + 1.6 * (shape % 13) / 12, -0.75 + 1.5 * (shape // 13) / 3
        moved = {}
        for vertex, (u, v) in enumerate(grid):
            fall = math.exp(-60 * ((u - u0) ** 2 + (v - v0) ** 2))
            if fall > 0.1:
                moved[vertex] = rounded([[0.0, (0.12 if shape % 2 else -0.12) * fall, 0.08 * fall]])[0]
        targets.append({"POSITION": model.sparse_vectors(len(positions), moved)})
        names.append(f"shape_{shape + 1:02}")
    primitive = {"attributes": attributes, "indices": model.indices(triangles), "targets": targets}
    model.write("face", primitive, names)


if __name__ == "__main__":
    colored_cube()
    face()
