"""The programs that are compared: how they are built, and why one may be missing."""

import dataclasses
import pathlib
import re
import subprocess
import sys

from lib import machine, processes

# Name -> cmake target, path in the build folder.
NEEDED = {
    "tool": ("morphcl_tool", "cli/morphcl"),
    "draw": ("morphcl_bench_draw", "bench/morphcl_bench_draw"),
    "shot": ("morphcl_bench_shot", "bench/morphcl_bench_shot"),
    "bandwidth": ("morphcl_bench_bandwidth", "bench/morphcl_bench_bandwidth"),
    "picture": ("morphcl_bench_picture", "bench/morphcl_bench_picture"),
}
# Name -> cmake target, path in the build folder, Debian packages without which it is left out.
PEERS = {
    "llvmpipe": ("morphcl_peer_llvmpipe", "bench/peers/llvmpipe/morphcl_peer_llvmpipe",
                 "libegl-dev libgl-dev libgl1-mesa-dri"),
}
KERNEL_BENCHES = "bench/kernels"
KERNEL_PACKAGES = "libbenchmark-dev"


@dataclasses.dataclass
class Programs:
    folder: pathlib.Path  # of the build
    paths: dict  # of NEEDED and of those of PEERS that could be built: name -> path

    def __getitem__(self, name):
        return self.paths[name]

    def drawing(self):
        """Programs that draw scenes, by the name of their figures: morphcl first."""
        return {"morphcl": self.paths["draw"], **{name: self.paths[name] for name in PEERS if name in self.paths}}

    def missing(self):
        """Markdown lines that name the peers that are left out."""
        return [f"Left out, as it could not be built or found nothing to draw with: {name} (Debian packages: "
                f"{packages})." for name, (_, _, packages) in PEERS.items() if name not in self.paths]


def known_targets(folder):
    text = subprocess.run(["cmake", "--build", folder, "--target", "help"], check=True, capture_output=True,
                          text=True).stdout
    return set(re.findall(r"^(\S+):", text, re.MULTILINE))


def build_targets(folder, targets):
    subprocess.run(["cmake", "--build", folder, "--target", *targets], check=True, stdout=sys.stderr,
                   preexec_fn=machine.run_as_usual)


def build(folder):
    """Configures and builds into `folder`. Raises CalledProcessError when what is needed cannot be built."""
    subprocess.run(["cmake", "-S", machine.ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DMORPHCL_BUILD_BENCH=ON"], check=True, stdout=subprocess.DEVNULL)
    known = known_targets(folder)
    wanted = {**NEEDED, **{name: (target, path) for name, (target, path, _) in PEERS.items() if target in known}}
    build_targets(folder, [target for target, _ in wanted.values()])
    paths = {name: folder / path for name, (_, path) in wanted.items()}
    idle = [name for name in PEERS if name in paths and not processes.has_device(paths[name])]
    return Programs(folder, {name: path for name, path in paths.items() if name not in idle})


def build_kernel_benches(folder):
    """Builds and returns the programs of bench/kernels, none where there is no Google Benchmark."""
    targets = (folder / "bench" / "kernel_programs.txt").read_text().split()
    if targets:
        build_targets(folder, targets)
    return [folder / KERNEL_BENCHES / target for target in targets]
