"""What the series have to show, and whether they do."""

import math

from lib import series, tables

# The lines of the series `pixels` and `objects` that the statements are about.
ALL_COVERED, FIFTH_COVERED = "morphcl, all covered", "morphcl, a fifth covered"
ALL_OBJECTS, VISIBLE_OBJECTS = "morphcl", "morphcl, only those in view"
STRAIGHT = 0.1  # how far a point may be from the straight line, as a share of it


def at(points, wanted):
    """Those of the points whose x is wanted, in order."""
    return [(x, y) for x, y in sorted(points) if x in wanted]


def spread_each(points):
    """Largest over smallest time / x; None for fewer than two points."""
    each = [y / x for x, y in points]
    return max(each) / min(each) if len(each) > 1 else None


def spread_further(points):
    """Largest over smallest time of a further one, from each point to the next; infinite where more take no longer, which
    only noise does; None for fewer than three points."""
    further = [(y1 - y0) / (x1 - x0) for (x0, y0), (x1, y1) in zip(points, points[1:])]
    if len(further) < 2:
        return None
    return max(further) / min(further) if min(further) > 0 else math.inf


def checks(curves, grown):
    """(statement, limit, value) of each; value None where the series is too short to tell."""
    amounts = (10**5, 10**6, 10**7)
    same_size = at(curves["triangles"][series.SAME_SIZE], amounts)
    triangles = at(curves["triangles"]["morphcl"], amounts)
    sizes = [width * height for width, height in (series.PIXELS[name] for name in ("1080p", "4K", "8K"))]
    yield "time / triangles, 10⁵ to 10⁷ of the same size: largest / smallest", 1.5, spread_each(same_size)
    yield "time / triangles, 10⁵ to 10⁷ in the same picture: largest / smallest", 1.5, spread_each(triangles)
    # A frame of few triangles costs what its pixels do; the triangles show in what more of them add.
    yield "time of a further triangle, 10⁵ to 10⁶ and 10⁶ to 10⁷: largest / smallest", 1.5, spread_further(triangles)
    for curve in (ALL_COVERED, FIFTH_COVERED):
        pixels, what = at(curves["pixels"][curve], sizes), curve.split(", ")[1]
        yield f"time / pixels, 1080p to 8K, {what}: largest / smallest", 1.5, spread_each(pixels)
        yield (f"time of a further pixel, 1080p to 4K and 4K to 8K, {what}: largest / smallest", 1.5,
               spread_further(pixels))
    most, time = max(curves["objects"][ALL_OBJECTS])
    yield (f"{most:,} objects against only those in view: times the time", 3.0,
           time / dict(curves["objects"][VISIBLE_OBJECTS])[most])
    rig = dict(curves["targets"]["morphcl"])
    yield f"{max(rig)} targets with 5 active against 5 targets: times the time", 1.2, rig[max(rig)] / rig[5]
    for growth in grown:
        yield (f"memory over {growth.axis}: furthest from a straight line, as a share", STRAIGHT,
               growth.largest_deviation if len(growth.points) > 2 else None)


def text(value):
    return "" if value is None else f"{value:.2f}"


def table(curves, processor_curves, grown):
    """`curves`: series -> curve -> [(x, ms)], by the clock, which decides; `processor_curves`: in processor time."""
    lines = []
    for (statement, limit, value), (_, _, busy) in zip(checks(curves, grown), checks(processor_curves, grown)):
        verdict = "" if value is None else "yes" if value < limit else "**no**"
        lines.append([statement, limit, text(value), verdict, text(busy)])
    return tables.table(["what", "less than", "measured", "holds", "in processor time"], lines)
