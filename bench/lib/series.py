"""The series of the part scaling: what grows, and what is drawn at each step."""

import dataclasses

SAME_SIZE = "morphcl, triangles of the same size"  # 1080p for a million

PIXELS = {"480p": (854, 480), "720p": (1280, 720), "1080p": (1920, 1080), "4K": (3840, 2160), "8K": (7680, 4320)}


@dataclasses.dataclass
class Point:
    curve: str  # which line of the plot it lies on
    x: float
    program: str  # morphcl or a peer
    arguments: list  # of the drawing program


@dataclasses.dataclass
class Series:
    name: str
    axis: str  # what x is
    points: list
    per_x: str = ""  # unit of time / x where that is of interest: "ns a triangle"
    small_x: bool = False  # x is not logarithmic


def sized(width, height):
    return ["--size", f"{width}x{height}"]


def triangles(programs, quick):
    amounts = [10**4, 10**5, 10**6] if quick else [10**4, 31_684, 10**5, 316_000, 10**6, 3_160_000, 10**7]
    points = []
    for amount in amounts:
        heavy = ["heavy", "--amount", amount, "--frames", 3 if amount > 2e6 else 8]
        points += [Point(name, amount, name, heavy) for name in programs.drawing()]
        # A picture that grows with the mesh: triangles keep their size, so nothing but their number changes.
        height = round(1080 * (amount / 1e6) ** 0.5)
        points.append(Point(SAME_SIZE, amount, "morphcl", [*heavy, *sized(round(height * 16 / 9), height)]))
    return Series("triangles", "triangles", points, "ns a triangle")


def pixels(programs, quick):
    sizes = {name: size for name, size in PIXELS.items() if not quick or name in ("480p", "1080p")}
    return Series("pixels", "pixels", [
        Point(f"{name}, {label}", width * height, name, [*scene, *sized(width, height), "--frames", 8])
        for width, height in sizes.values()
        for scene, label in ((["morph"], "a fifth covered"), (["overdraw_ftb", "--amount", 1], "all covered"))
        for name in programs.drawing()], "ns a pixel")


def layers(programs, quick):
    amounts = [1, 8, 64] if quick else [1, 2, 4, 8, 16, 32, 64]
    return Series("layers", "layers", [
        Point(f"{name}, {label}", amount, name, [scene, "--amount", amount, "--frames", 6])
        for amount in amounts
        for scene, label in (("overdraw_btf", "back to front"), ("overdraw_ftb", "front to back"))
        for name in programs.drawing()])


def targets(programs, quick):
    amounts = [5, 256] if quick else [1, 2, 5, 16, 64, 256]
    return Series("targets", "morph targets, at most 5 active", [
        Point("morphcl", amount, "morphcl", ["rig", "--amount", amount, "--frames", 24]) for amount in amounts])


def objects(programs, quick):
    amounts = [100, 10**4] if quick else [1, 10, 100, 1000, 10**4, 10**5]
    return Series("objects", "objects, 1 % in view", [
        point for amount in amounts for point in (
            Point("morphcl", amount, "morphcl", ["crowd", "--amount", amount, "--frames", 8]),
            Point("morphcl, only those in view", amount, "morphcl",
                  ["crowd_in_view", "--amount", amount, "--frames", 8]),
            *(Point(name, amount, name, ["crowd", "--amount", amount, "--frames", 4])
              for name in programs.drawing() if name != "morphcl"))])


def threads(programs, most_threads):
    counts = sorted({count for count in (1, 2, 4, 8, 16, 32, most_threads) if count <= most_threads})
    return Series("threads", "threads", [
        Point(f"{name}, {scene}", count, name, [scene, "--threads", count, "--frames", 8])
        for count in counts for scene in ("morph", "heavy", "many") for name in programs.drawing()], small_x=True)


def all_series(programs, options):
    made = [make(programs, options.quick) for make in (triangles, pixels, layers, targets, objects)]
    for series in made:
        for point in series.points:
            point.arguments = [*point.arguments, "--threads", options.threads]
    return [*made, threads(programs, options.threads)]
