"""Line plots with gnuplot: small SVG files."""

import shutil
import subprocess

PACKAGES = "gnuplot-nox"
COLORS = ["#1b6ca8", "#d1495b", "#66a182", "#edae49", "#6a4c93", "#3d3d3d"]


def available():
    return shutil.which("gnuplot") is not None


def number_label(value):
    """100000 -> 10^5, as gnuplot writes it."""
    return f"{value:g}"


def lines(path, title, x_label, y_label, curves, *, log_x=True, log_y=True, ticks=None):
    """`curves`: label -> [(x, y), ...]. `ticks`: {x: label}, or gnuplot's own. Both axes start where the values do; a
    linear y axis starts at 0."""
    script = ["set terminal svg size 640,400 dynamic enhanced font 'sans-serif,13' background '#ffffff'",
              f"set output {quoted(path)}", f"set title {quoted(title)} noenhanced",
              f"set xlabel {quoted(x_label)} noenhanced", f"set ylabel {quoted(y_label)} noenhanced",
              "set grid lw 0.5 lc rgb '#cccccc'", "set key top left noenhanced", "set border 3", "set tics nomirror"]
    if log_x:
        script += ["set logscale x 10", "set format x '10^{%T}'"]
    if log_y:
        script += ["set logscale y 10", "set format y '%g'"]
    else:
        script.append("set yrange [0:*]")
    if ticks:
        script += ["set format x '%g'", f"set xtics ({', '.join(f'{quoted(label)} {x}' for x, label in ticks.items())})"]
    for index, points in enumerate(curves.values()):
        script += [f"$curve{index} << EOD", *(f"{x} {y}" for x, y in points), "EOD"]
    script.append("plot " + ", ".join(
        f"$curve{index} using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '{COLORS[index % len(COLORS)]}' "
        f"title {quoted(label)}" for index, label in enumerate(curves)))
    subprocess.run(["gnuplot"], input="\n".join(script), text=True, check=True)


def quoted(text):
    return "'" + str(text).replace("'", "''") + "'"
