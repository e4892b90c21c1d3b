"""The part transform: batch transforms beside other ways of doing the same, and beside copying as many bytes."""

import json
import os
import statistics
import sys

from lib import kernels, processes, programs as programs_module, tables

PROGRAM = "morphcl_bench_transform"
COLUMNS = ["threads", "precision", "layout", "what", "who", "vertices", "median_ns", "deviation_percent",
           "gigabytes_per_second"]
LAYOUTS = {"separate": "x, y and z in arrays of their own", "xyz": "records of x, y, z", "xyzw": "records of x, y, z, w"}
COPY = ("copy", "past_cache")  # what is 100 %
# The order of the tables' lines.
WHAT = ["copy", "points", "project", "normals", "points_by_index", "points_blended"]
WHO = ["morphcl", "past_cache", "memcpy", "loop", "glm", "eigen"]


def measure(path, threads, repetitions, quick):
    """Everything in random order, `repetitions` times: rows by COLUMNS."""
    command = [path, f"--threads={threads}", "--benchmark_format=json", f"--benchmark_repetitions={repetitions}",
               "--benchmark_report_aggregates_only=true", "--benchmark_enable_random_interleaving=true",
               f"--benchmark_min_time={0.02 if quick else 0.1}"]
    rows = []
    for row in kernels.rows_of(PROGRAM, json.loads(processes.output(command))):
        precision, layout, what, who, vertices = row["benchmark"].split("/")[:5]
        rows.append(row | {"threads": threads, "precision": precision, "layout": layout, "what": what, "who": who,
                           "vertices": int(vertices)})
    return rows


def value(rows, key, **wanted):
    """Of the one row that has what is wanted; None if there is none."""
    found = [row[key] for row in rows if all(row[name] == value for name, value in wanted.items())]
    return found[0] if found else None


def speed_table(rows, precision, layout, counts):
    """GB/s and the fraction of copying for each thread count."""
    large = max(row["vertices"] for row in rows)
    mine = [row for row in rows if (row["precision"], row["layout"], row["vertices"]) == (precision, layout, large)]
    lines = []
    ways = {(row["what"], row["who"]) for row in mine}
    for what, who in sorted(ways, key=lambda way: (WHAT.index(way[0]), WHO.index(way[1]))):
        cells = [f"{what.replace('_', ' ')}, {who.replace('_', ' ')}"]
        for threads in counts:
            speed = value(mine, "gigabytes_per_second", threads=threads, what=what, who=who)
            copying = value(mine, "gigabytes_per_second", threads=threads, what=COPY[0], who=COPY[1])
            cells += [f"{speed:.1f}", f"{100 * speed / copying:.0f} %"]
        lines.append(cells)
    head = [f"{precision}, {layout}"]
    for threads in counts:
        head += [f"GB/s, {threads} thread{'s' if threads > 1 else ''}", "of copying"]
    return tables.table(head, lines)


def small_table(rows, counts):
    """Times of small batches: as they come, on the device alone, by the host alone."""
    small = [row for row in rows if (row["precision"], row["layout"], row["what"]) == ("f32", "separate", "points")]
    sizes = sorted({row["vertices"] for row in small if row["who"] == "device"})
    ways = [(threads, who) for threads in counts for who in ("morphcl", "device")] + [(counts[0], "host")]
    names = {"morphcl": "as it comes", "device": "device alone", "host": "host alone"}
    head = ["vertices"] + [f"{names[who]}, {threads} thread{'s' if threads > 1 else ''}" for threads, who in ways]
    return tables.table(head, [[size] + [kernels.time_text(value(small, "median_ns", threads=threads, who=who,
                                                                 vertices=size)) for threads, who in ways]
                               for size in sizes])


def lowest_fraction(rows, counts):
    """The smallest fraction of copying that points, one matrix for all, reach in any layout and precision."""
    large = max(row["vertices"] for row in rows)
    fractions = []
    for row in rows:
        if (row["what"], row["who"], row["vertices"]) == ("points", "morphcl", large):
            same = {"threads": row["threads"], "precision": row["precision"], "layout": row["layout"], "what": COPY[0],
                    "who": COPY[1], "vertices": large}
            fractions.append(row["gigabytes_per_second"] / value(rows, "gigabytes_per_second", **same))
    return min(fractions), statistics.median(fractions)


def run(programs, options):
    paths = [path for path in programs_module.build_kernel_benches(programs.folder) if path.name == PROGRAM]
    if not paths:
        print(f"left out: there is no {programs_module.KERNEL_PACKAGES}", file=sys.stderr)
        return
    load = os.getloadavg()[0]
    repetitions = options.rounds or (2 if options.quick else 5)
    counts = sorted({1, options.threads})
    rows = [row for threads in counts for row in measure(paths[0], threads, repetitions, options.quick)]
    lowest, middle = lowest_fraction(rows, counts)
    body = [f"Points reach {100 * middle:.0f} % of the speed of copying (median over layouts, precisions and thread "
            f"counts; lowest {100 * lowest:.0f} %).", ""]
    for layout, text in LAYOUTS.items():
        body += [f"## {text}", ""]
        for precision in ("f32", "f64"):
            body += [*speed_table(rows, precision, layout, counts), ""]
    body += ["## Small batches", "", "Points, f32, separate arrays. \"As it comes\" is done by the host below 8192 vertices, "
             "and makes buffers of the caller's arrays above.", "", *small_table(rows, counts), ""]
    tables.write_csv(options.results / "transform.csv", rows, COLUMNS)
    tables.write_page(options.results / "transform.md", "Batch transforms",
                      "Bytes read and written, by time; written by `bench/run transform`. 100 % is copying as many bytes "
                      "past the cache. What is measured and how to read it: [README](../README.md).", body,
                      [f"- {max(row['vertices'] for row in rows):,} vertices; {repetitions} repetitions each, in random "
                       "order; medians"], load)
