"""The part job: `morphcl render` writing ZIP files into memory, beside the peer's best throughput: as many processes as
processors, each on one thread, that take the frames in turn."""

import os
import pathlib
import shutil
import statistics
import sys
import tempfile

from lib import kernel_cache, pictures, processes, shots, tables

FRAMES = {"morph": 100, "heavy": 60}
# How many times faster than llvmpipe: at least, and what is aimed at.
GOALS = {"morphcl": {"morph": (7, 10), "heavy": (5.5, 8)}, "morphcl with Z": {"morph": (5, 9), "heavy": (5, 8)}}
COLUMNS = ["round", "scene", "program", "frames", "threads", "frame_ms", "with_start_ms", "mean_bytes", "covered",
           "mean_red", "peak_megabytes"]
MEMORY_FOLDER = pathlib.Path("/dev/shm")  # a file system in memory, so that no disk is measured


def variants(programs, folder, scene, frames, options):
    """Name -> commands that together write all frames into `folder`/NAME."""
    shot = shots.write(programs, folder, scene, frames=frames)

    def tool(name, channels):
        return [[programs["tool"], "render", shot, "-o", folder / name / "frame.####.exr", "--channels", channels,
                 "--compression", "zip", "--threads", options.threads, "--device", 0, "--json", "--quiet"]]
    commands = {"morphcl": tool("morphcl", "RGBA"), "morphcl with Z": tool("morphcl with Z", "RGBA,Z")}
    if "llvmpipe" in programs.paths:
        commands["llvmpipe"] = [[programs["llvmpipe"], scene, "--frames", frames, "--threads", 1, "--out",
                                 folder / "llvmpipe", "--zip-level", 1, "--part", f"{part}/{options.threads}"]
                                for part in range(options.threads)]
    return commands


def measure(programs, name, commands, folder, environment):
    """The files are measured, looked at and removed."""
    output = folder / name
    output.mkdir()
    watched = processes.watch(commands, environment)
    times, paths = zip(*watched.frames)
    sizes = [os.path.getsize(path) for path in paths]
    figures = pictures.figures_of_file(programs, max(paths))
    shutil.rmtree(output)
    return {"frames": len(times), "frame_ms": 1000 * (times[-1] - times[0]) / (len(times) - 1),
            "with_start_ms": 1000 * watched.seconds / len(times), "mean_bytes": statistics.mean(sizes),
            "peak_megabytes": watched.peak_megabytes, **figures}


def figures_of(rows, scene, name, key):
    """Round after round."""
    return [row[key] for row in rows if row["scene"] == scene and row["program"] == name]


def beside_peer(rows, scene, name):
    """Cells: times faster, at least, aim, lowest to highest round; and times faster with start and end."""
    def ratios(key):
        return [theirs / ours for ours, theirs in zip(figures_of(rows, scene, name, key),
                                                      figures_of(rows, scene, "llvmpipe", key))]

    def ratio(key):
        ours, theirs = (statistics.median(figures_of(rows, scene, who, key)) for who in (name, "llvmpipe"))
        return theirs / ours
    rounds = ratios("frame_ms")
    return [f"**{ratio('frame_ms'):.1f}**", *GOALS[name][scene], f"{min(rounds):.1f} to {max(rounds):.1f}",
            f"{ratio('with_start_ms'):.1f}"]


def table(rows, scenes, names):
    lines = []
    for scene in scenes:
        for name in names:
            frame, whole, size, peak = (statistics.median(figures_of(rows, scene, name, key)) for key in
                                        ("frame_ms", "with_start_ms", "mean_bytes", "peak_megabytes"))
            with_peer = name != "llvmpipe" and "llvmpipe" in names
            *compared, compared_whole = beside_peer(rows, scene, name) if with_peer else [""] * 5
            lines.append([scene, name, f"{frame:.2f}", *compared, f"{whole:.2f}", compared_whole, f"{size / 1000:.1f}",
                          f"{peak:.0f}"])
    return tables.table(["scene", "program", "ms a frame", "times faster", "at least", "aim", "lowest to highest round",
                         "ms a frame with start and end", "times faster", "kB a file", "peak memory, MB"], lines)


def run(programs, options):
    load = os.getloadavg()[0]
    rounds = options.rounds or (2 if options.quick else 5)
    rows, names = [], []
    with tempfile.TemporaryDirectory(dir=MEMORY_FOLDER, prefix="morphcl-bench-") as folder:
        folder = pathlib.Path(folder)
        environment = kernel_cache.warmed(programs, folder / "cache", options.threads)
        for number in range(1, rounds + 1):
            for scene, frames in FRAMES.items():
                commands = variants(programs, folder, scene, 20 if options.quick else frames, options)
                names = list(commands)
                found = {name: measure(programs, name, commands[name], folder, environment)
                         for name in (names if number % 2 else reversed(names))}
                pictures.check_same(scene, {name: found[name] for name in names})
                rows += [{"round": number, "scene": scene, "program": name, "threads": options.threads, **found[name]}
                         for name in names]
                print(f"round {number}/{rounds}  {scene:6}" +
                      "".join(f"  {name} {found[name]['frame_ms']:.2f} ms" for name in names), file=sys.stderr)

    tables.write_csv(options.results / "job.csv", rows, COLUMNS)
    frames = " and ".join(f"{'20' if options.quick else count} frames of `{scene}`" for scene, count in FRAMES.items())
    tables.write_page(
        options.results / "job.md", "Time of a whole job",
        f"`morphcl render` writes {frames} at 1920 × 1080 as ZIP-compressed EXR; written by `bench/run job`. The first "
        "figure runs from the first complete file to the last; the second from before the process is started to its "
        "end. What is measured and how to read it: [README](../README.md).",
        table(rows, FRAMES, names) + ["", *programs.missing()],
        [f"- morphcl: half RGBA, and with float Z; one process, {options.threads} threads",
         f"- llvmpipe: half RGBA, OpenEXR at zlib level 1; {options.threads} processes of one thread that take the "
         "frames in turn; peak memory of all together",
         f"- medians of {rounds} rounds, the programs in turn in each; files in a file system in memory"], load)
