"""What the series have to show, and whether they do."""

from lib import tables

# The lines of the series `pixels` and `objects` that the statements are about.
ALL_COVERED, FIFTH_COVERED = "morphcl, all covered", "morphcl, a fifth covered"
ALL_OBJECTS, VISIBLE_OBJECTS = "morphcl", "morphcl, only those in view"
STRAIGHT = 0.1  # how far a point may be from the straight line, as a share of it


def spread_each(points, lowest, highest, base=0.0):
    """Largest over smallest (time - base) / x of the points whose x is in the range; None for fewer than two."""
    each = [(y - base) / x for x, y in points if lowest <= x <= highest]
    return max(each) / min(each) if len(each) > 1 else None


def checks(curves, grown):
    """(statement, limit, value, unit) of each; value None where the series is too short to tell."""
    yield ("time a triangle, 10⁵ to 10⁷: largest / smallest", 1.5,
           spread_each(curves["triangles"]["morphcl"], 0.9e5, 1.1e7))
    # A frame of few triangles costs what its pixels do.
    fewest = min(curves["triangles"]["morphcl"])[1]
    yield ("the same, less the time of the smallest mesh, which is mostly that of its pixels", 1.5,
           spread_each(curves["triangles"]["morphcl"], 0.9e5, 1.1e7, fewest))
    for curve in (ALL_COVERED, FIFTH_COVERED):
        yield (f"time a pixel, 1080p to 8K, {curve.split(', ')[1]}: largest / smallest", 1.5,
               spread_each(curves["pixels"][curve], 1920 * 1080, 1e9))
    most, time = max(curves["objects"][ALL_OBJECTS])
    yield (f"{most:,} objects against only those in view: times the time", 3.0,
           time / dict(curves["objects"][VISIBLE_OBJECTS])[most])
    rig = dict(curves["targets"]["morphcl"])
    yield (f"{max(rig)} targets with 5 active against 5 targets: times the time", 1.2, rig[max(rig)] / rig[5])
    for growth in grown:
        yield (f"memory over {growth.axis}: furthest from a straight line, as a share", STRAIGHT,
               growth.largest_deviation if len(growth.points) > 2 else None)


def table(curves, grown):
    return tables.table(["what", "less than", "measured", "holds"],
                        [[statement, limit, "" if value is None else f"{value:.2f}",
                          "" if value is None else "yes" if value < limit else "**no**"]
                         for statement, limit, value in checks(curves, grown)])
