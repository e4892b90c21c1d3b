"""How the tool's peak memory grows with triangles and pixels, and the straight line through it."""

import dataclasses
import statistics

from lib import processes, series, shots


@dataclasses.dataclass
class Growth:
    name: str
    axis: str
    points: list  # (x, MB)
    megabytes_at_0: float = 0
    bytes_each: float = 0
    largest_deviation: float = 0  # of a point from the line, as a share of the point

    def __post_init__(self):
        (slope, self.megabytes_at_0) = statistics.linear_regression(*zip(*self.points))
        self.bytes_each = slope * 2**20
        self.largest_deviation = max(abs(y - self.megabytes_at_0 - slope * x) / y for x, y in self.points)


def peak(programs, shot, folder, environment, threads):
    """MB, of a run that writes two frames."""
    return processes.watch([[programs["tool"], "render", shot, "-o", folder / "frame.####.exr", "--frames", "0-1",
                             "--threads", threads, "--device", 0, "--json", "--quiet"]], environment).peak_megabytes


def measure(programs, folder, environment, options):
    amounts = [10**5, 10**6] if options.quick else [10**5, 10**6, 3_160_000, 10**7]
    sizes = [size for name, size in series.PIXELS.items() if not options.quick or name in ("480p", "1080p")]
    by_triangles = [(amount, peak(programs, shots.write(programs, folder, "heavy", frames=24, amount=amount), folder,
                                  environment, options.threads)) for amount in amounts]
    by_pixels = [(width * height, peak(programs, shots.write(programs, folder, "morph", frames=24,
                                                             size=f"{width}x{height}"), folder, environment,
                                       options.threads)) for width, height in sizes]
    return [Growth("triangles", "triangles", by_triangles), Growth("pixels", "pixels", by_pixels)]
