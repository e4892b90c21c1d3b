"""Line plots with gnuplot: small SVG files."""

import shutil
import subprocess

PACKAGES = "gnuplot-nox"
# By the first word of a curve's label: who it is about. A second curve of the same one differs by dashes and points.
COLORS = {"morphcl": "#1b6ca8", "llvmpipe": "#d1495b"}
OTHER_COLOR = "#4d4d4d"
POINTS = [7, 6, 5, 4, 9, 8]


def available():
    return shutil.which("gnuplot") is not None


def lines(path, title, x_label, y_label, curves, *, log_x=True, log_y=True, ticks=None, fits=()):
    """`curves`: label -> [(x, y), ...]; those named in `fits` are lines without points, and the others then points
    without lines. `ticks`: {x: label}, or gnuplot's own. A linear y axis starts at 0."""
    script = ["set terminal svg size 720,360 dynamic enhanced font 'sans-serif,13' background '#ffffff'",
              f"set output {quoted(path)}", f"set title {quoted(title)} noenhanced",
              f"set xlabel {quoted(x_label)} noenhanced", f"set ylabel {quoted(y_label)} noenhanced",
              "set grid lw 0.5 lc rgb '#cccccc'", "set border 3", "set tics nomirror",
              "set key outside right center noenhanced samplen 3 Left reverse"]
    if log_x:
        script += ["set logscale x 10", "set format x '10^{%T}'"]
    if log_y:
        script += ["set logscale y 10", "set format y '%g'"]
    else:
        script.append("set yrange [0:*]")
    if ticks:
        places = ", ".join(f"{quoted(label)} {x}" for x, label in ticks.items())
        script += ["set format x '%g'", f"set xtics ({places})"]
    for index, points in enumerate(curves.values()):
        script += [f"$curve{index} << EOD", *(f"{x} {y}" for x, y in points), "EOD"]
    script.append("plot " + ", ".join(f"$curve{index} using 1:2 {style} title {quoted(label)}"
                                      for index, (label, style) in enumerate(styles(curves, fits))))
    subprocess.run(["gnuplot"], input="\n".join(script), text=True, check=True)


def styles(curves, fits):
    seen = {}
    for label in curves:
        owner = label.split()[0].rstrip(",")
        color, turn = COLORS.get(owner, OTHER_COLOR), seen.setdefault(owner, 0)
        seen[owner] += 1
        kind = "lines" if label in fits else "points" if fits else "linespoints"
        point = "" if label in fits else f" pt {POINTS[turn % len(POINTS)]} ps {0.9 if fits else 0.5}"
        yield label, f"with {kind} lc rgb '{color}'{point}" + ("" if kind == "points" else f" lw 2 dt {turn + 1}")


def quoted(text):
    return "'" + str(text).replace("'", "''") + "'"
