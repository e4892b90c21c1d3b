"""Runs a program once and reads its figures."""

import dataclasses
import json
import os
import subprocess
import sys
import tempfile
import time

NO_DEVICE = 69  # exit status: there is nothing to draw with


def completed(command, environment):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          env={**os.environ, **(environment or {})})


def output(command, environment=None):
    """What a program prints. A failure ends this process."""
    done = completed(command, environment)
    if done.returncode != 0:
        sys.exit(f"{command[0]}: {done.stderr.strip() or f'exit status {done.returncode}'}")
    return done.stdout


def report(command, environment=None):
    """The JSON line that a drawing program prints last. A failure ends this process."""
    return json.loads(output(command, environment).splitlines()[-1])


def has_device(program):
    """Whether a drawing program finds something to draw with. Any other failure ends this process."""
    done = completed([program, "morph", "--frames", 1, "--size", "16x16"], None)
    if done.returncode not in (0, NO_DEVICE):
        sys.exit(f"{program}: {done.stderr.strip()}")
    print(done.stderr, end="", file=sys.stderr)
    return done.returncode == 0


@dataclasses.dataclass
class Watched:
    """Times in seconds from before the first process was started."""
    frames: list  # (time, path) of each file, in the order they were complete
    reports: list  # other lines of JSON, such as the closing report of each process
    seconds: float  # until the last process had ended
    peak_megabytes: float  # the largest resident size, all processes together


def watch(commands, environment=None):
    """Runs commands at the same time that print a line of JSON {"frame": ..., "path": ...} when a file is complete,
    each in one write, as they share a pipe. Any failure ends this process."""
    reading, writing = os.pipe()
    with tempfile.TemporaryFile(mode="w+") as errors:
        start = time.monotonic()
        processes = [subprocess.Popen([str(part) for part in command], stdout=writing, stderr=errors,
                                      env={**os.environ, **(environment or {})}) for command in commands]
        os.close(writing)
        frames, reports = [], []
        with os.fdopen(reading) as lines:
            for line in lines:
                now, values = time.monotonic() - start, json.loads(line)
                if "frame" in values:
                    frames.append((now, values.get("path")))
                else:
                    reports.append(values)
        peak_kilobytes = 0
        for process in processes:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            peak_kilobytes += usage.ru_maxrss
        seconds = time.monotonic() - start
        errors.seek(0)
        for process, command in zip(processes, commands):
            if process.returncode != 0:
                sys.exit(f"{command[0]}: {errors.read().strip() or f'exit status {process.returncode}'}")
    return Watched(frames, reports, seconds, peak_kilobytes / 1024)
