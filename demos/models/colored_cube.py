"""Six faces of four corners; a corner's colour is its place."""

from gltf_file import GltfFile


def write(path):
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
    file = GltfFile()
    attributes = {
        "POSITION": file.vectors(positions),
        "NORMAL": file.vectors(normals),
        "COLOR_0": file.vectors([[0.5 + 0.5 * x for x in p] for p in positions]),
    }
    file.write(path, {"attributes": attributes, "indices": file.indices(triangles)})
