"""The part stages: where the processor time of a frame goes, kernel by kernel, seen by perf.

PoCL compiles each kernel into a shared library of its name, so samples a library are samples a kernel.
"""

import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

from lib import limits, processes, tables

PACKAGES = "linux-perf"
WARM_UP_FRAMES = 3  # of morphcl_bench_draw
SAMPLES_A_SECOND = 4000
FRAMES = {"morph": 1000, "heavy": 100, "overdraw_btf": 200, "overdraw_ftb": 200, "many": 100, "wire": 1000}
COLUMNS = ["round", "scene", "stage", "cpu_ms", "share"]
# Kernels in the order of a frame; others follow by name.
ORDER = ["plan", "project_vertices", "clip_primitives", "bin_primitives", "shade_tiles"]
SHARED_LAUNCHES = {"light_and_bin_primitives": "bin_primitives", "project_light_and_bin": "bin_primitives"}
REST = "rest: launches, waiting, page faults"


def available():
    """Whether perf is there and may sample."""
    if shutil.which("perf") is None:
        return False
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run(["perf", "record", "-q", "-e", "cpu-clock", "-o", f"{folder}/data", "true"],
                              capture_output=True).returncode == 0


def library_milliseconds(data):
    """Shared library -> milliseconds of processor time, all threads together."""
    text = processes.output(["perf", "report", "-i", data, "--stdio", "--sort", "dso", "--show-total-period"])
    found = re.findall(r"^\s+[\d.]+%\s+(\d+)\s+(\S+)", text, re.MULTILINE)
    return {name: int(period) / 1e6 for period, name in found}


def measure(programs, scene, folder, options):
    """Stage -> milliseconds of processor time a frame, and the program's report."""
    data = folder / "perf.data"
    frames = FRAMES[scene] // (10 if options.quick else 1)
    report = processes.report(["perf", "record", "-q", "-e", "cpu-clock", "-F", SAMPLES_A_SECOND, "-o", data,
                               programs["draw"], scene, "--frames", frames, "--threads", options.threads])
    kernels = {}
    for name, milliseconds in library_milliseconds(data).items():
        if name.endswith(".so") and not name.startswith(("lib", "self_test")):
            kernel = name.removesuffix(".so")
            stage = SHARED_LAUNCHES.get(kernel, kernel)
            kernels[stage] = kernels.get(stage, 0) + milliseconds / (frames + WARM_UP_FRAMES)
    stages = {"plan": report["plan_ms"], **kernels}
    return {**stages, REST: max(0.0, report["cpu_ms"] - sum(stages.values()))}, report


def in_order(stages):
    return sorted(stages, key=lambda name: (name == REST, ORDER.index(name) if name in ORDER else len(ORDER), name))


def table(rows, scenes):
    names = in_order({row["stage"] for row in rows})
    lines = []
    for scene in scenes:
        times = medians(rows, scene)
        whole = sum(times.values())
        lines.append([scene, f"{whole:.2f}", *(f"{times[name]:.2f} ({100 * times[name] / whole:.0f} %)"
                                               if name in times else "" for name in names)])
    return tables.table(["scene", "all, ms", *names], lines)


def medians(rows, scene):
    """Stage -> milliseconds of processor time a frame."""
    values = {}
    for row in rows:
        if row["scene"] == scene:
            values.setdefault(row["stage"], []).append(row["cpu_ms"])
    return {stage: statistics.median(times) for stage, times in values.items()}


def run(programs, options):
    if not available():
        print(f"left out: perf is missing or may not sample (Debian package {PACKAGES}, kernel.perf_event_paranoid)",
              file=sys.stderr)
        return
    load = os.getloadavg()[0]
    rounds = options.rounds or (1 if options.quick else 3)
    rows, reports, bandwidth = [], {}, {}
    with tempfile.TemporaryDirectory(prefix="morphcl-bench-") as folder:
        for number in range(1, rounds + 1):
            measured = json.loads(processes.output([programs["bandwidth"], options.threads]))
            bandwidth = {key: max(value, bandwidth.get(key, 0)) for key, value in measured.items()}  # the best of all
            for scene in options.scenes:
                stages, reports[scene] = measure(programs, scene, pathlib.Path(folder), options)
                whole = sum(stages.values())
                rows += [{"round": number, "scene": scene, "stage": name, "cpu_ms": milliseconds,
                          "share": milliseconds / whole} for name, milliseconds in stages.items()]
            print(f"round {number}/{rounds}", file=sys.stderr)
    tables.write_csv(options.results / "stages.csv", rows, COLUMNS)
    body = [*table(rows, options.scenes), "", "## Beside the memory's speed", "", limits.INTRODUCTION, "",
            *limits.table({scene: medians(rows, scene) for scene in options.scenes}, reports, bandwidth)]
    tables.write_page(options.results / "stages.md", "Where the time of a frame goes",
                      "Milliseconds of processor time a frame, all threads together, and the share; written by "
                      "`bench/run stages`. What is measured and how to read it: [README](../README.md).", body,
                      [f"- {options.threads} threads; medians of {rounds} rounds; {SAMPLES_A_SECOND} samples a second",
                       "- plan: by the clock, on the host; the others: kernels, by samples in their libraries; "
                       "bin_primitives with light_faces and, in frames of one chunk, project_vertices",
                       f"- memory, GB/s of {options.threads} threads: fill {bandwidth['fill']:.1f}, read "
                       f"{bandwidth['read']:.1f}, copy {bandwidth['copy']:.1f}"], load)
