"""Benchmark scenes as shot files for the tool."""

from lib import processes


def write(programs, folder, scene, *, frames, amount=None, size=None):
    """Returns the shot's path. Scenes: morph, wire, heavy; amount and size as of morphcl_bench_shot."""
    command = [programs["shot"], scene, "--frames", frames]
    if amount:
        command += ["--amount", amount]
    if size:
        command += ["--size", size]
    path = folder / f"{scene}{f'-{amount}' if amount else ''}{f'-{size}' if size else ''}.toml"
    path.write_text(processes.output(command))
    return path
