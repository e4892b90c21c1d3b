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


def has_device(program, *options):
    """Whether a drawing program finds something to draw with, so. Any other failure ends this process."""
    done = completed([program, "morph", "--frames", 1, "--size", "16x16", *options], None)
    if done.returncode not in (0, NO_DEVICE):
        sys.exit(f"{program}: {done.stderr.strip()}")
    print(done.stderr, end="", file=sys.stderr)
    return done.returncode == 0


@dataclasses.dataclass
class Watched:
    """Times in seconds from before the first process was started."""
    frames: list  # (time, path) of each file, in the order they were complete
    reports: list  # other lines of JSON, such as the closing report of each process
    drawn_by: list  # which renderer drew each of them, as far as it is said: the tool does for those it did not copy
    seconds: float  # until the last process had ended
    peak_megabytes: float  # the largest resident size, all processes together


def is_on_device(command):
    words = [str(part) for part in command]
    return "--device" in words and words[words.index("--device") + 1].isdigit()


def watch(commands, environment=None):
    """Runs commands at the same time that print a line of JSON {"frame": ..., "path": ...} when a file is complete,
    each in one write, as they share a pipe. Any failure ends this process, and so does a command that names a device by
    its number where the reference draws in its place."""
    reading, writing = os.pipe()
    with tempfile.TemporaryFile(mode="w+") as errors:
        start = time.monotonic()
        processes = [subprocess.Popen([str(part) for part in command], stdout=writing, stderr=errors,
                                      env={**os.environ, **(environment or {})}) for command in commands]
        os.close(writing)
        frames, drawn_by, reports = [], [], []
        with os.fdopen(reading) as lines:
            for line in lines:
                now, values = time.monotonic() - start, json.loads(line)
                if "frame" in values:
                    frames.append((now, values.get("path")))
                    drawn_by += [values["drawn_by"]] if "drawn_by" in values else []
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
    if any(is_on_device(command) for command in commands) and "reference" in drawn_by:
        sys.exit(f"{commands[0][0]}: a frame was not drawn by the device that is named")
    return Watched(frames, reports, drawn_by, seconds, peak_kilobytes / 1024)
