"""The part scaling: how time and memory grow with triangles, pixels, layers, targets, objects and threads."""

import os
import pathlib
import statistics
import sys
import tempfile

from lib import growth_checks, kernel_cache, memory, pictures, plot, processes, series, tables

COLUMNS = ["round", "series", "curve", "x", "program", "scene", "width", "height", "objects", "triangles", "threads",
           "frames", "frame_ms", "fastest_ms", "cpu_ms", "plan_ms", "covered", "mean_red"]


def measure(programs, wanted, rounds):
    """One row a point and round."""
    rows = []
    for number in range(1, rounds + 1):
        # Round after round through all points, so that a machine that slows down for a while touches all alike.
        for part in wanted:
            for point in part.points:
                report = processes.report([programs.drawing()[point.program], *point.arguments])
                rows.append({"round": number, "series": part.name, "curve": point.curve, "x": point.x, **report})
            print(f"round {number}/{rounds}  {part.name}", file=sys.stderr)
    return rows


def check_pictures(rows):
    """What several programs drew at the same step with the same arguments has to look the same."""
    steps = {}
    for row in rows:
        scene = row["scene"].removesuffix("_in_view")
        key = (row["series"], scene, row["x"], row["width"], row["frames"])
        steps.setdefault(key, {}).setdefault(row["curve"], row)
    for (name, scene, x, _, _), figures in steps.items():
        pictures.check_same(f"{name} {scene} {x}", figures)


def curves_of(rows, name, key="frame_ms"):
    """Curve -> [(x, median over the rounds)]."""
    values = {}
    for row in rows:
        if row["series"] == name:
            values.setdefault(row["curve"], {}).setdefault(row["x"], []).append(row[key])
    return {curve: [(x, statistics.median(times)) for x, times in sorted(points.items())]
            for curve, points in values.items()}


def table(part, curves):
    xs = sorted({x for points in curves.values() for x, _ in points})
    lines = []
    for x in xs:
        cells = [f"{x:,}"]
        for points in curves.values():
            milliseconds = dict(points).get(x)
            cells.append("" if milliseconds is None else f"{milliseconds:.2f}")
            if part.per_x:
                cells.append("" if milliseconds is None else f"{1e6 * milliseconds / x:.2f}")
        lines.append(cells)
    head = [part.axis]
    for curve in curves:
        head += [f"{curve}, ms"] + ([part.per_x] if part.per_x else [])
    return tables.table(head, lines)


def write_plots(wanted, rows, grown, folder):
    for part in wanted:
        curves = curves_of(rows, part.name)
        ticks = {x: f"{x:g}" for points in curves.values() for x, _ in points} if part.small_x else None
        plot.lines(folder / f"scaling_{part.name}.svg", f"Time of a frame over {part.axis}", part.axis, "ms a frame",
                   curves, log_x=not part.small_x, ticks=ticks)
        if part.per_x:
            plot.lines(folder / f"scaling_{part.name}_each.svg", f"Time of a frame over {part.axis}, {part.per_x}",
                       part.axis, part.per_x,
                       {curve: [(x, 1e6 * y / x) for x, y in points] for curve, points in curves.items()})
    for growth in grown:
        top = max(x for x, _ in growth.points)
        line = [(x / 1e6, growth.megabytes_at_0 + growth.bytes_each / 2**20 * x) for x in (0, top)]
        fit = f"{growth.megabytes_at_0:.0f} MB + {growth.bytes_each:.0f} bytes each"
        plot.lines(folder / f"memory_{growth.name}.svg", f"Peak memory over {growth.axis}", f"million {growth.axis}",
                   "MB", {"morphcl render": [(x / 1e6, y) for x, y in growth.points], fit: line}, log_x=False,
                   log_y=False, fits=[fit])


def memory_table(grown):
    return tables.table(["grows with", "from", "to", "MB at 0", "bytes each", "furthest from the line"],
                        [[growth.axis, *(f"{y:.0f} MB at {x:,}" for x, y in (growth.points[0], growth.points[-1])),
                          f"{growth.megabytes_at_0:.0f}", f"{growth.bytes_each:.1f}",
                          f"{100 * growth.largest_deviation:.0f} %"] for growth in grown])


def run(programs, options):
    load = os.getloadavg()[0]
    rounds = options.rounds or (1 if options.quick else 3)
    wanted = series.all_series(programs, options)
    rows = measure(programs, wanted, rounds)
    check_pictures(rows)
    with tempfile.TemporaryDirectory(prefix="morphcl-bench-") as folder:
        folder = pathlib.Path(folder)
        environment = kernel_cache.warmed(programs, folder / "cache", options.threads)
        grown = memory.measure(programs, folder, environment, options)

    tables.write_csv(options.results / "scaling.csv", rows, COLUMNS)
    tables.write_csv(options.results / "memory.csv", [{"grows_with": growth.axis, "x": x, "peak_megabytes": y}
                                                      for growth in grown for x, y in growth.points],
                     ["grows_with", "x", "peak_megabytes"])
    pictured = plot.available()
    if pictured:
        write_plots(wanted, rows, grown, options.results)
    by_clock, by_processor = ({part.name: curves_of(rows, part.name, key) for part in wanted}
                              for key in ("frame_ms", "cpu_ms"))
    body = ["## What has to hold", "", *growth_checks.table(by_clock, by_processor, grown), ""]
    for part in wanted:
        body += [f"## {part.name.capitalize()}", ""]
        body += [f"![Time over {part.axis}](scaling_{part.name}.svg)", ""] if pictured else []
        body += [f"![{part.per_x}](scaling_{part.name}_each.svg)", ""] if pictured and part.per_x else []
        body += [*table(part, curves_of(rows, part.name)), ""]
    body += ["## Memory", ""]
    body += [f"![Peak memory over {growth.axis}](memory_{growth.name}.svg)" for growth in grown] if pictured else []
    body += ["", *memory_table(grown), "", *programs.missing()]
    body += [] if pictured else [f"No plots: gnuplot is missing (Debian package {plot.PACKAGES})."]
    tables.write_page(options.results / "scaling.md", "How time and memory grow",
                      "Milliseconds from the frame number to pixels in host memory; written by `bench/run scaling`. "
                      "What is measured and how to read it: [README](../README.md).", body,
                      [f"- medians of {rounds} rounds through all series; {options.threads} threads but where they "
                       "are what grows; 1920 × 1080 but where pixels grow, alone or with the triangles"], load)
