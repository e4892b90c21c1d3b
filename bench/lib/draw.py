"""The part draw: time from the frame number to pixels in host memory, scene by scene, beside the peers."""

import os
import statistics
import sys

from lib import pictures, plot, processes, tables

SCENES = ["morph", "heavy", "overdraw_btf", "overdraw_ftb", "many", "wire"]
# How many times faster than llvmpipe: at least, and what is aimed at.
GOALS = {"morph": (6.5, 8), "heavy": (6.5, 9), "overdraw_btf": (80, 120), "overdraw_ftb": (30, 40), "many": (8, 15)}
COLUMNS = ["round", "scene", "program", "width", "height", "threads", "frames", "frame_ms", "fastest_ms", "cpu_ms",
           "plan_ms", "render_ms", "draw_ms", "read_ms", "covered", "mean_red"]


def measure(program, scene, options):
    command = [program, scene, "--threads", options.threads]
    if options.quick or options.frames:
        command += ["--frames", options.frames or 6]
    if options.size:
        command += ["--size", options.size]
    return processes.report(command)


def measure_scene(number, scene, programs, options):
    """One report a program. Who comes first changes from round to round, so that a machine that slows down or recovers
    favours nobody."""
    names = list(programs.drawing())
    reports = {}
    for name in names if number % 2 else reversed(names):
        reports[name] = measure(programs.drawing()[name], scene, options)
    return {name: reports[name] for name in names}


def median(rows, scene, program, key="frame_ms"):
    return statistics.median(times(rows, scene, program, key))


def times(rows, scene, program, key="frame_ms"):
    return [row[key] for row in rows if row["scene"] == scene and row["program"] == program]


def size_of(rows, scene):
    return next(f"{row['width']} × {row['height']}" for row in rows if row["scene"] == scene)


def compared(rows, scenes, peer):
    lines = []
    for scene in scenes:
        ours, theirs = (median(rows, scene, name) for name in ("morphcl", peer))
        our_cpu, their_cpu = (median(rows, scene, name, "cpu_ms") for name in ("morphcl", peer))
        rounds = [b / a for a, b in zip(*(times(rows, scene, name) for name in ("morphcl", peer)))]
        least, aim = GOALS.get(scene, ("", "")) if peer == "llvmpipe" else ("", "")
        lines.append([scene, size_of(rows, scene), f"{ours:.2f}", f"{theirs:.2f}", f"**{theirs / ours:.1f}**", least,
                      aim, f"{min(rounds):.1f} to {max(rounds):.1f}", f"{their_cpu / our_cpu:.1f}"])
    return tables.table(["scene", "size", "morphcl, ms", f"{peer}, ms", "times faster", "at least", "aim",
                         "lowest to highest round", "in processor time"], lines)


def write_plot(rows, scenes, peer, path):
    faster = {scene: median(rows, scene, peer) / median(rows, scene, "morphcl") for scene in scenes}
    marks = {label: {scene: goals[i] for scene, goals in GOALS.items()} for i, label in enumerate(("at least", "aim"))}
    plot.bars(path, f"Drawing a frame: how many times faster than {peer}", f"time of {peer} / time of morphcl", faster,
              marks)


def run(programs, options):
    load = os.getloadavg()[0]
    rounds = options.rounds or (2 if options.quick else 5)
    rows, renderers = [], {}
    for number in range(1, rounds + 1):
        for scene in options.scenes:
            reports = measure_scene(number, scene, programs, options)
            pictures.check_same(scene, reports)
            renderers |= {name: report["renderer"] for name, report in reports.items()}
            rows += [{"round": number, **report} for report in reports.values()]
            print(f"round {number}/{rounds}  {scene:13}" +
                  "".join(f"  {name} {report['frame_ms']:.2f} ms" for name, report in reports.items()), file=sys.stderr)

    tables.write_csv(options.results / "draw.csv", rows, COLUMNS)
    body = []
    for peer in (name for name in programs.drawing() if name != "morphcl"):
        body += compared(rows, options.scenes, peer) + [""]
        if plot.available():
            write_plot(rows, options.scenes, peer, options.results / f"draw_{peer}.svg")
            body += [f"![Times faster than {peer}](draw_{peer}.svg)", ""]
    if not body:
        body = tables.table(["scene", "size", "morphcl, ms"],
                            [[scene, size_of(rows, scene), f"{median(rows, scene, 'morphcl'):.2f}"]
                             for scene in options.scenes])
    body += programs.missing()
    foot = [f"- {options.threads} threads each; {rounds} rounds, the programs in turn in each",
            *(f"- {name}: {renderer}" for name, renderer in renderers.items())]
    tables.write_page(options.results / "draw.md", "Time to draw a frame",
                      "Milliseconds from the frame number to pixels in host memory, medians; written by `bench/run "
                      "draw`. What is measured and how to read it: [README](../README.md).", body, foot, load)
