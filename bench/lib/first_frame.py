"""The part first_frame: what `--device auto` makes of an empty kernel cache, and that it never ends later than the device
alone, whatever the cache holds."""

import os
import pathlib
import shutil
import statistics
import sys
import tempfile

from lib import job, kernel_cache, machine, processes, tables

DEMOS = machine.ROOT / "demos"
# Milliseconds at most.
FIRST_FILE, SMALL_JOB = 150, 150
LONG_SHOTS = ["pyramid_to_cube", "sphere_to_cube"]
THREADS = [1, 2]
# A machine that is shared repeats a time to within this share, a short one to within these milliseconds.
NOISE, NOISE_MS = 0.05, 20
COLUMNS = ["round", "shot", "frames", "size", "threads", "cache", "device", "first_file_ms", "last_file_ms", "end_ms",
           "rendered",
           "by_reference"]


class Runner:
    """Runs the tool on a shot of demos/ in fresh folders, and keeps a row a run."""

    def __init__(self, programs, folder, threads):
        self.programs, self.folder, self.rows = programs, folder, []
        self.warmed = kernel_cache.warmed(programs, folder / "warm", threads)

    def run(self, number, shot, cache, device, threads, frames=None, size=None):
        output, empty = self.folder / "frames", self.folder / "none"
        command = [self.programs["tool"], "render", DEMOS / f"{shot}.toml", "-o", output / "frame.####.exr",
                   "--threads", threads, "--device", device, "--json", "--quiet"]
        command += ["--frames", frames] if frames else []
        command += ["--size", size] if size else []
        environment = self.warmed if cache == "warm" else kernel_cache.empty(empty)
        # On one thread the tool has one processor as well, as in a job of a farm that asks for one.
        command = (["taskset", "-c", "0"] if threads == 1 else []) + command
        watched = processes.watch([command], environment)
        for used in (output, empty):
            shutil.rmtree(used, ignore_errors=True)
        self.rows.append({"round": number, "shot": shot, "frames": frames or "all", "size": size or "its own",
                          "threads": threads, "cache": cache, "device": device,
                          "first_file_ms": 1000 * watched.frames[0][0],
                          "last_file_ms": 1000 * watched.frames[-1][0], "end_ms": 1000 * watched.seconds,
                          "rendered": len(watched.drawn_by), "by_reference": watched.drawn_by.count("reference")})

    def figures(self, key, **wanted):
        return [row[key] for row in self.rows if all(row[name] == value for name, value in wanted.items())]

    def median(self, key, **wanted):
        return statistics.median(self.figures(key, **wanted))

    def median_of_pairs(self, key, device, other, **where):
        """What a round's figure for `device` is of the same round's for `other`."""
        return statistics.median(a / b for a, b in zip(self.figures(key, device=device, **where),
                                                       self.figures(key, device=other, **where)))


def goals(runner, threads):
    """Lines of the table of what is aimed at from an empty cache. What is compared is of the same round."""
    lines = []

    def line(what, measured, most, aim=0):
        """Lists of a figure a round; `most` may be one number."""
        bounds = most if isinstance(most, list) else [most] * len(measured)
        share = statistics.median(a / b for a, b in zip(measured, bounds))
        lines.append([what, f"{statistics.median(measured):.0f}", f"{statistics.median(bounds):.0f}",
                      f"{aim:.0f}" if aim else "", f"**{share:.2f}**"])
    line("first file of `pyramid_to_cube`, 1920 × 1080",
         runner.figures("first_file_ms", shot="pyramid_to_cube", frames="0", cache="empty", device="auto"), FIRST_FILE)
    line("20 frames of `pyramid_to_cube`, 256 × 256, to the end",
         runner.figures("end_ms", shot="pyramid_to_cube", frames="0-19", cache="empty", device="auto"), SMALL_JOB)
    for shot in LONG_SHOTS:
        def rounds(key, cache, device):
            return runner.figures(key, shot=shot, frames="0-99", threads=threads, cache=cache, device=device)
        compiling = [cold - kept for cold, kept in zip(rounds("first_file_ms", "empty", "0"),
                                                       rounds("first_file_ms", "warm", "0"))]
        warm = rounds("end_ms", "warm", "0")
        line(f"100 frames of `{shot}`, 1920 × 1080, to the last file (its kernels compile in "
             f"{statistics.median(compiling):.0f} ms; warm, the device takes {statistics.median(warm):.0f} ms)",
             rounds("last_file_ms", "empty", "auto"), [a + 1.1 * b for a, b in zip(compiling, warm)],
             1.3 * statistics.median(warm) + 300)
    return tables.table(["from an empty cache", "ms", "at most", "aim", "of the most"], lines)


def shots_table(runner, shots):
    lines = []
    for shot in shots:
        for threads in THREADS:
            for cache in ("empty", "warm"):
                where = {"shot": shot, "frames": "all", "threads": threads, "cache": cache}
                by_turns, device = (runner.median("end_ms", device=name, **where) for name in ("auto", "0"))
                share = runner.median_of_pairs("end_ms", "auto", "0", **where)
                first = [runner.median("first_file_ms", device=name, **where) for name in ("auto", "0")]
                drawn = runner.median("by_reference", device="auto", **where)
                later = share > 1 + NOISE and (share - 1) * device > NOISE_MS
                lines.append([shot, threads, cache, *(f"{value:.0f}" for value in first), f"{by_turns:.0f}",
                              f"{device:.0f}", f"**{share:.2f}**", "later" if later else "",
                              f"{drawn:.0f} of {runner.median('rendered', device='auto', **where):.0f}"])
    return tables.table(["shot", "threads", "cache", "auto, first file, ms", "device, first file, ms", "auto, end, ms",
                         "device, end, ms", "of the device's", "", "frames by the reference"], lines)


def run(programs, options):
    load = os.getloadavg()[0]
    rounds = options.rounds or (2 if options.quick else 7)
    shots = sorted(path.stem for path in DEMOS.glob("*.toml"))
    if options.quick:
        shots = ["pyramid_to_cube", "floor_plan"]
    with tempfile.TemporaryDirectory(dir=job.MEMORY_FOLDER, prefix="morphcl-bench-") as folder:
        runner = Runner(programs, pathlib.Path(folder), options.threads)
        for number in range(1, rounds + 1):
            order = ("auto", "0") if number % 2 else ("0", "auto")
            for device in order:
                runner.run(number, "pyramid_to_cube", "empty", device, options.threads, "0", "1920x1080")
                runner.run(number, "pyramid_to_cube", "empty", device, options.threads, "0-19", "256x256")
            for shot in LONG_SHOTS:
                for cache in ("empty", "warm"):
                    for device in order:
                        runner.run(number, shot, cache, device, options.threads, "0-99", "1920x1080")
            for shot in shots:
                for threads in THREADS:
                    for cache in ("empty", "warm"):
                        for device in order:
                            runner.run(number, shot, cache, device, threads)
            print(f"round {number}/{rounds}", file=sys.stderr)

    tables.write_csv(options.results / "first_frame.csv", runner.rows, COLUMNS)
    tables.write_page(options.results / "first_frame.md", "The first frame",
                      "`--device auto` beside `--device 0`, milliseconds from before the process is started to the "
                      "first complete file and to the process's end; written by `bench/run first_frame`. What is "
                      "measured and how to read it: [README](../README.md).",
                      [*goals(runner, options.threads), "", "The shots of `demos/`, whole:", "",
                       *shots_table(runner, shots)],
                      [f"- medians of {rounds} rounds, both ways in turn in each, and of what they are of each other in a round; {options.threads} threads in the first "
                       "table; one thread is one processor; files and caches in a file system in memory",
                       "- empty: nothing compiled before, in a folder of its own; warm: after `morphcl warm`. Both ways "
                       "store what they compiled and drew with before they end",
                       f"- later: by more than {100 * NOISE:.0f} % and {NOISE_MS} ms"], load)
