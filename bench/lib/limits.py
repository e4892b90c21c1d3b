"""What a stage moves through memory at the least, and the time that takes at this machine's bandwidth."""

from lib import tables

INTRODUCTION = (
    "At least: the bytes that the stage cannot do without, read and written once, at the bandwidth that was measured "
    "beside it. A stage near this is as fast as the memory; one far above it computes, or waits for what it reads here "
    "and there; more than 100 % has found in a cache what it reads. Scenes whose objects are partly out of view are "
    "left out, as what is drawn of them is not counted.")
# Bytes of one item.
POSITION = NORMAL = 12  # three floats, of every state that is mixed
VERTEX = ATTRIBUTES = 16  # a projected vertex; its normal
INDICES = 12  # of a triangle
PIXEL = 4 * 2 + 4  # half R, G, B, A and float Z
STATES = 2
SMOOTH = ("heavy", "overdraw_btf", "overdraw_ftb")
WHOLE = ("morph", *SMOOTH)  # scenes that are wholly in view


def least_bytes(scene, report):
    """Stage -> (bytes read, bytes written)."""
    vertices, triangles, covered = report["vertices"], report["triangles"], report["covered"]
    attributes = ATTRIBUTES if scene in SMOOTH else 0
    normals = NORMAL if scene in SMOOTH else 0
    return {"project_vertices": (vertices * STATES * (POSITION + normals), vertices * (VERTEX + attributes)),
            "bin_primitives": (triangles * INDICES + vertices * VERTEX, 0),
            "shade_tiles": (vertices * attributes, covered * PIXEL)}


def table(stages, reports, bandwidth):
    """`stages`: scene -> {stage: ms of processor time}; `bandwidth`: GB/s of all threads together."""
    lines = []
    for scene in (scene for scene in WHOLE if scene in stages):
        for stage, (read, written) in least_bytes(scene, reports[scene]).items():
            # Processor time: every thread waits for its share of the bandwidth.
            least = bandwidth["threads"] * (read / bandwidth["read"] + written / bandwidth["fill"]) / 1e6
            took = stages[scene].get(stage, 0.0)
            if least >= 0.05 and took >= 0.05:  # what moves next to nothing has no such limit; samples are too few
                lines.append([scene, stage, f"{(read + written) / 1e6:.1f}", f"{least:.2f}", f"{took:.2f}",
                              f"{100 * least / took:.0f} %"])
    return tables.table(["scene", "stage", "MB, at least", "ms, at least", "ms", "of the memory's speed"], lines)
