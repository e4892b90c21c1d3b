"""The machine and the sources that the figures belong to."""

import os
import pathlib
import subprocess
import sys

PACKAGES = ["g++", "libpocl2", "libgl1-mesa-dri", "libopenexr-dev", "libisal-dev", "libdeflate-dev"]
ROOT = pathlib.Path(__file__).resolve().parents[2]


def processors():
    return len(os.sched_getaffinity(0))


def processor_name():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "unknown processor"


def run_ahead():
    """From now on this process and its children run ahead of ordinary ones."""
    try:
        os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(1))
    except PermissionError:
        sys.exit("--ahead: needs root")


def run_as_usual():
    """The opposite."""
    os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))


def is_ahead():
    return os.sched_getscheduler(0) != os.SCHED_OTHER


def commit():
    git = ["git", "-C", ROOT]
    head = subprocess.run([*git, "rev-parse", "--short", "HEAD"], capture_output=True, text=True)
    if head.returncode != 0:
        return "unknown"
    changed = subprocess.run([*git, "diff", "--quiet", "HEAD", "--", "anim", "cli", "host", "kernels", "bench",
                              ":!bench/results"]).returncode != 0
    return head.stdout.strip() + (" with changes" if changed else "")


def versions():
    """Debian packages that the figures depend on, with versions; empty on other systems."""
    try:
        known = subprocess.run(["dpkg-query", "-W", "-f=${Package}\t${Version}\n", *PACKAGES], capture_output=True,
                               text=True).stdout
    except FileNotFoundError:
        return []
    return [" ".join(line.split("\t")) for line in known.splitlines() if not line.endswith("\t")]


def lines(load_before):
    """For the foot of a page, as Markdown list items."""
    return [f"- machine: {processor_name()}, {processors()} processors, Linux {os.uname().release}; load average "
            f"before the first round {load_before:.1f}; {'' if is_ahead() else 'not '}run ahead of other programs",
            *(f"- {', '.join(found)}" for found in [versions()] if found), f"- commit {commit()}"]
