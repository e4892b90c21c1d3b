"""The part startup: from before the process is started to the first complete EXR file."""

import os
import pathlib
import shutil
import statistics
import sys
import tempfile

from lib import job, kernel_cache, processes, shots, tables

SCENES = ["morph", "heavy", "wire"]
# Milliseconds of morphcl, at most, and what is aimed at.
GOALS = {"kept": (150, 80), "empty": (2500, "")}
COLUMNS = ["round", "scene", "program", "cache", "first_file_ms", "end_ms", "scene_ms"]


def commands(programs, folder, options):
    """(program, scene) -> the command that writes frame 0 into `folder`."""
    made = {}
    for scene in SCENES:
        shot = shots.write(programs, folder, scene, frames=24)
        made["morphcl", scene] = [programs["tool"], "render", shot, "-o", folder / "frame.####.exr", "--frames", "0",
                                  "--threads", options.threads, "--device", 0, "--json", "--quiet"]
        if "llvmpipe" in programs.paths:
            made["llvmpipe", scene] = [programs["llvmpipe"], scene, "--frames", 1, "--out", folder, "--threads",
                                       options.threads, "--zip-level", 1]
    return made


def measure(command, environment):
    watched = processes.watch([command], environment)
    # The peer's programs make the scene's arrays and fit the camera themselves, which a user's would read from a file.
    scene_ms = watched.reports[-1].get("scene_ms", 0.0)
    return {"first_file_ms": 1000 * watched.frames[0][0] - scene_ms, "end_ms": 1000 * watched.seconds - scene_ms,
            "scene_ms": scene_ms}


def table(rows):
    lines = []
    for cache in ("kept", "empty"):
        for scene in SCENES:
            def median(program, key):
                values = [row[key] for row in rows
                          if (row["program"], row["scene"], row["cache"]) == (program, scene, cache)]
                return f"{statistics.median(values):.0f}" if values else ""
            most, aim = GOALS[cache]
            lines.append([scene, cache, f"**{median('morphcl', 'first_file_ms')}**", most, aim,
                          median("llvmpipe", "first_file_ms"), median("morphcl", "end_ms"),
                          median("llvmpipe", "end_ms")])
    return tables.table(["scene", "kernel cache", "morphcl, first file, ms", "at most", "aim",
                         "llvmpipe, first file, ms", "morphcl, end, ms", "llvmpipe, end, ms"], lines)


def run(programs, options):
    load = os.getloadavg()[0]
    rounds = options.rounds or (2 if options.quick else 7)
    rows = []
    with tempfile.TemporaryDirectory(dir=job.MEMORY_FOLDER, prefix="morphcl-bench-") as folder:
        folder = pathlib.Path(folder)
        all_commands = commands(programs, folder, options)
        kept = kernel_cache.warmed(programs, folder / "kept", options.threads)
        for command in all_commands.values():
            processes.watch([command], kept)  # fills the peer's cache, and the file system's
        for number in range(1, rounds + 1):
            order = list(all_commands.items())
            for (program, scene), command in order if number % 2 else reversed(order):
                rows.append({"round": number, "scene": scene, "program": program, "cache": "kept",
                             **measure(command, kept)})
                rows.append({"round": number, "scene": scene, "program": program, "cache": "empty",
                             **measure(command, kernel_cache.empty(folder / "none"))})
                shutil.rmtree(folder / "none", ignore_errors=True)  # a program may keep nothing
            print(f"round {number}/{rounds}", file=sys.stderr)

    tables.write_csv(options.results / "startup.csv", rows, COLUMNS)
    tables.write_page(options.results / "startup.md", "Start-up",
                      "Milliseconds from before the process is started to the first complete EXR file of 1920 × 1080 "
                      "(`wire`: 600 × 600), and to the process's end; written by `bench/run startup`. What is measured "
                      "and how to read it: [README](../README.md).", [*table(rows), "", *programs.missing()],
                      [f"- {options.threads} threads; medians of {rounds} rounds, the programs in turn in each; files "
                       "and caches in a file system in memory",
                       "- kernel cache kept: after `morphcl warm`, and for llvmpipe after a run; empty: nothing "
                       "compiled before. A run that compiled kernels stores them after its first file",
                       "- llvmpipe: less the time for making the scene's arrays; half RGBA at zlib level 1, where "
                       "morphcl writes Z too"], load)
