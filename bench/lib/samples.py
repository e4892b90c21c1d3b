"""The part samples: several samples a pixel beside llvmpipe and beside one sample, blended surfaces, and the pictures
in which one sample gains the least over llvmpipe."""

import dataclasses
import os
import statistics
import sys

from lib import pictures, processes, tables

RESOLVES = ["blit", "shader"]  # how llvmpipe makes one sample of several: the faster one counts
THEIR_SAMPLES = 4  # the most that llvmpipe draws before Mesa 25.3
# Few where a frame takes long. Many where bins grow as the shape changes: a frame that they were too small for is drawn
# twice, and among a few frames would weigh in the mean of processor time. Elsewhere the scene's own number.
FRAMES = {"llvmpipe": {"heavy": 12, "many": 12, "blended": 6}, "morphcl": {"heavy": 60, "many": 60, "blended": 6}}
COLUMNS = ["round", "scene", "program", "samples", "resolve", "depth", "width", "height", "threads", "frames",
           "frame_ms", "fastest_ms", "cpu_ms", "covered", "mean_red"]


@dataclasses.dataclass(frozen=True)
class Picture:
    """What both programs draw."""
    scene: str
    size: str = ""  # WIDTHxHEIGHT; the scene's own unless given
    depth: bool = False  # whether morphcl makes Z too, as in the part draw


@dataclasses.dataclass(frozen=True)
class Drawing:
    """How one program draws it."""
    program: str
    samples: int
    resolve: str = ""  # of llvmpipe's several samples

    def __str__(self):
        return " ".join(filter(None, [self.program, str(self.samples), self.resolve]))


@dataclasses.dataclass(frozen=True)
class Comparison:
    """How many times faster than llvmpipe: at least, and what is aimed at; empty where nothing is."""
    picture: Picture
    ours: int  # samples a pixel
    theirs: int
    least: object = ""
    aim: object = ""


# Lines of the two tables beside llvmpipe. The scene `blended` comes sorted to both, which llvmpipe needs.
SEVERAL_SAMPLES = [
    Comparison(Picture("morph"), 4, THEIR_SAMPLES, 12, 25),
    Comparison(Picture("heavy"), 4, THEIR_SAMPLES, 8, 12),
    Comparison(Picture("many"), 4, THEIR_SAMPLES, 10, 20),
    Comparison(Picture("morph"), 16, THEIR_SAMPLES, 6, 12),
    Comparison(Picture("heavy"), 16, THEIR_SAMPLES, 4, 7),
    Comparison(Picture("blended"), 4, THEIR_SAMPLES),
]
ONE_SAMPLE = [
    Comparison(Picture("blended"), 1, 1, 1, 3),
    Comparison(Picture("heavy", "3840x2160", depth=True), 1, 1, 5.5, 8),
    Comparison(Picture("morph", "640x360", depth=True), 1, 1, 3.5, 6),
    Comparison(Picture("wire", depth=True), 1, 1, 3, 5),
]
# Four samples: at most how many times the time of one, and what is aimed at.
FOUR_AGAINST_ONE = {"morph": (1.6, 1.2), "heavy": (2.2, 1.7), "overdraw_ftb": (1.6, 1.3), "overdraw_btf": (1.6, 1.3)}


def drawings(resolves, peers):
    """Picture -> what draws it, without doubles, morphcl first: what the tables need."""
    wanted = {}

    def want(picture, *found):
        wanted.setdefault(picture, {}).update(dict.fromkeys(found))
    lines = SEVERAL_SAMPLES + ONE_SAMPLE
    for scene in FOUR_AGAINST_ONE:
        want(Picture(scene), Drawing("morphcl", 1), Drawing("morphcl", 4))
    for line in lines:
        want(line.picture, Drawing("morphcl", line.ours))
    if "llvmpipe" in peers:
        for line in lines:
            want(line.picture, *peer_drawings(line.theirs, resolves))
    return {picture: list(found) for picture, found in wanted.items()}


def peer_drawings(samples, resolves):
    return [Drawing("llvmpipe", samples, resolve) for resolve in (resolves if samples > 1 else [""])]


def usable_resolves(programs):
    """Those by which the driver makes one sample of several: not each driver has several samples of half RGBA."""
    if "llvmpipe" not in programs.paths:
        return []
    return [resolve for resolve in RESOLVES
            if processes.has_device(programs["llvmpipe"], "--samples", THEIR_SAMPLES, "--resolve", resolve)]


def command_of(programs, picture, drawing, options):
    command = [programs.drawing()[drawing.program], picture.scene, "--threads", options.threads, "--samples",
               drawing.samples]
    if drawing.resolve:
        command += ["--resolve", drawing.resolve]
    if drawing.program == "morphcl" and not picture.depth:
        command.append("--colors-only")
    if picture.size:
        command += ["--size", picture.size]
    frames = 6 if options.quick else FRAMES[drawing.program].get(picture.scene)
    return command + (["--frames", frames] if frames else [])


def measure(number, picture, found, programs, options):
    """A row a drawing, in the order of `found`. Who comes first changes from round to round."""
    reports = {drawing: processes.report(command_of(programs, picture, drawing, options))
               for drawing in (found if number % 2 else reversed(found))}
    check_same(picture, {drawing: reports[drawing] for drawing in found})
    return [{"round": number, **reports[drawing], **dataclasses.asdict(picture), **dataclasses.asdict(drawing)}
            for drawing in found]


def check_same(picture, reports):
    several = any(drawing.samples > 1 for drawing in reports)
    pictures.check_same(picture.scene, {str(drawing): report for drawing, report in reports.items()},
                        pictures.COVERED_SHARE_BY_SAMPLES if several else pictures.COVERED_SHARE)


def figures_of(rows, picture, drawing, key="frame_ms"):
    """Round after round."""
    wanted = {**dataclasses.asdict(picture), **dataclasses.asdict(drawing)}
    return [row[key] for row in rows if all(row[name] == value for name, value in wanted.items())]


def median(rows, picture, drawing, key="frame_ms"):
    return statistics.median(figures_of(rows, picture, drawing, key))


def times(rows, picture, slower, faster, key="frame_ms"):
    """How many times the time of `faster` the other one takes: by the medians, and round by round."""
    rounds = [a / b for a, b in zip(*(figures_of(rows, picture, each, key) for each in (slower, faster)))]
    return median(rows, picture, slower, key) / median(rows, picture, faster, key), rounds


def size_of(rows, picture):
    row = next(row for row in rows if row["scene"] == picture.scene and row["size"] == picture.size)
    return f"{row['width']} × {row['height']}"


def compared(rows, line, resolves):
    """Cells of a line, `resolves` a cell each; none where llvmpipe does not draw it."""
    peers = peer_drawings(line.theirs, resolves)
    if not peers:
        return []
    ours = Drawing("morphcl", line.ours)
    milliseconds = {peer.resolve: median(rows, line.picture, peer) for peer in peers}
    best = min(peers, key=lambda peer: milliseconds[peer.resolve])
    faster, rounds = times(rows, line.picture, best, ours)
    processor, _ = times(rows, line.picture, best, ours, "cpu_ms")
    theirs = [f"{milliseconds[resolve]:.2f}" if resolve in milliseconds else ""
              for resolve in (RESOLVES if line.theirs > 1 else [""])]
    return [line.picture.scene, size_of(rows, line.picture), f"{median(rows, line.picture, ours):.2f}", *theirs,
            f"**{faster:.1f}**", line.least, line.aim, f"{min(rounds):.1f} to {max(rounds):.1f}",
            f"{processor:.1f}"]


COMPARED_END = ["times faster", "at least", "aim", "lowest to highest round", "in processor time"]


def several_table(rows, resolves):
    lines = []
    for line in SEVERAL_SAMPLES:
        cells = compared(rows, line, resolves)
        if cells:
            lines.append([*cells[:2], f"{line.ours} and {line.theirs}", *cells[2:]])
    return tables.table(["scene", "size", "samples, morphcl and llvmpipe", "morphcl, ms",
                         *(f"llvmpipe by {resolve}, ms" for resolve in RESOLVES), *COMPARED_END], lines)


def one_table(rows):
    return tables.table(["scene", "size", "morphcl, ms", "llvmpipe, ms", *COMPARED_END],
                        [compared(rows, line, []) for line in ONE_SAMPLE])


def four_table(rows):
    lines = []
    one, four = Drawing("morphcl", 1), Drawing("morphcl", 4)
    for scene, (most, aim) in FOUR_AGAINST_ONE.items():
        picture = Picture(scene)
        by_clock, rounds = times(rows, picture, four, one)
        by_processor, processor_rounds = times(rows, picture, four, one, "cpu_ms")
        lines.append([scene, size_of(rows, picture), f"{median(rows, picture, one):.2f}",
                      f"{median(rows, picture, four):.2f}", f"**{by_clock:.2f}**", most, aim,
                      f"{min(rounds):.2f} to {max(rounds):.2f}", f"{by_processor:.2f}",
                      f"{min(processor_rounds):.2f} to {max(processor_rounds):.2f}"])
    return tables.table(["scene", "size", "1 sample, ms", "4 samples, ms", "times the time", "at most", "aim",
                         "lowest to highest round", "in processor time", "lowest to highest round"], lines)


def body_of(rows, programs, resolves):
    body = []
    if "llvmpipe" in programs.paths:
        body += ["## Several samples beside llvmpipe", "", *several_table(rows, resolves), "",
                 "## One sample beside llvmpipe", "", *one_table(rows), ""]
        refused = [resolve for resolve in RESOLVES if resolve not in resolves]
        if refused:
            body += [f"Left out, as the driver refuses {THEIR_SAMPLES} samples so: {' and '.join(refused)}.", ""]
    return [*body, "## Four samples beside one", "", *four_table(rows), "", *programs.missing()]


def run(programs, options):
    load = os.getloadavg()[0]
    rounds = options.rounds or (2 if options.quick else 5)
    resolves = usable_resolves(programs)
    rows, renderers = [], {}
    for number in range(1, rounds + 1):
        for picture, found in drawings(resolves, programs.drawing()).items():
            measured = measure(number, picture, found, programs, options)
            rows += measured
            renderers |= {row["program"]: row["renderer"] for row in measured}
            print(f"round {number}/{rounds}  {picture.scene:13}" +
                  "".join(f"  {drawing} {row['frame_ms']:.2f}" for drawing, row in zip(found, measured)) + "  ms",
                  file=sys.stderr)

    tables.write_csv(options.results / "samples.csv", rows, COLUMNS)
    foot = [f"- {options.threads} threads each; {rounds} rounds, the programs in turn in each",
            f"- of llvmpipe's two ways to make one sample of {THEIR_SAMPLES}, by glBlitFramebuffer and by a shader, the "
            "faster one is compared with",
            "- morphcl: half RGBA; in the table of one sample with float Z too, but for `blended`",
            *(f"- {name}: {renderer}" for name, renderer in renderers.items())]
    tables.write_page(options.results / "samples.md", "Several samples a pixel, and transparency",
                      "Milliseconds from the frame number to pixels in host memory, medians; written by `bench/run "
                      "samples`. What is measured and how to read it: [README](../README.md).",
                      body_of(rows, programs, resolves), foot, load)
