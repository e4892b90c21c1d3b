"""Plots with gnuplot: small SVG files."""

import shutil
import subprocess

PACKAGES = "gnuplot-nox"
# By the first word of a curve's label: who it is about. A second curve of the same one differs by dashes and points.
COLORS = {"morphcl": "#1b6ca8", "llvmpipe": "#d1495b"}
OTHER_COLOR = "#4d4d4d"
MARK_COLORS = ["#4d4d4d", "#edae49"]
POINTS = [7, 6, 5, 4, 9, 8]


def available():
    return shutil.which("gnuplot") is not None


def head(path, title, x_label, y_label):
    return ["set terminal svg size 720,360 dynamic enhanced font 'sans-serif,13' background '#ffffff'",
            f"set output {quoted(path)}", f"set title {quoted(title)} noenhanced",
            f"set xlabel {quoted(x_label)} noenhanced", f"set ylabel {quoted(y_label)} noenhanced",
            "set grid lw 0.5 lc rgb '#cccccc'", "set border 3", "set tics nomirror",
            "set key outside right center noenhanced samplen 3 Left reverse"]


def draw(script):
    subprocess.run(["gnuplot"], input="\n".join(script), text=True, check=True)


def bars(path, title, y_label, values, marks):
    """One bar a name with its number at its foot, on a logarithmic axis from 1. `values`: name -> number; `marks`: label ->
    {name: number}, drawn as short lines across the bars."""
    names = list(values)
    script = [*head(path, title, "", y_label), "set logscale y 10", f"set yrange [1:{3 * max(values.values())}]",
              "set format y '%g'", "set boxwidth 0.6", "set style fill solid", "unset xlabel", "set key inside top right",
              f"set xrange [-0.6:{len(names) - 0.4}]",
              "set xtics (" + ", ".join(f"{quoted(name)} {i}" for i, name in enumerate(names)) + ") noenhanced",
              "$values << EOD", *(f"{i} {values[name]:.5g}" for i, name in enumerate(names)), "EOD"]
    plots = [f"$values using 1:2 with boxes lc rgb '{COLORS['morphcl']}' notitle",
             "$values using 1:(1.3):(sprintf('%.1f', $2)) with labels tc rgb '#ffffff' notitle"]
    for index, (label, places) in enumerate(marks.items()):
        script += [f"$mark{index} << EOD",
                   *(f"{i - 0.38} {places[name]} 0.76" for i, name in enumerate(names) if name in places), "EOD"]
        plots.append(f"$mark{index} using 1:2:3:(0) with vectors nohead lw 2 dt {index + 1} lc rgb "
                     f"'{MARK_COLORS[index % len(MARK_COLORS)]}' title {quoted(label)}")
    draw([*script, "plot " + ", ".join(plots)])


def lines(path, title, x_label, y_label, curves, *, log_x=True, log_y=True, ticks=None, fits=()):
    """`curves`: label -> [(x, y), ...]; those named in `fits` are lines without points, and the others then points
    without lines. `ticks`: {x: label}, or gnuplot's own. A linear y axis starts at 0."""
    script = head(path, title, x_label, y_label)
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
    draw(script)


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
