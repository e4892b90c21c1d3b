"""The programs that are compared: how they are built, and why one may be missing."""

import dataclasses
import pathlib
import re
import subprocess
import sys

from lib import machine

# Name -> cmake target, path in the build folder.
NEEDED = {
    "tool": ("morphcl_tool", "cli/morphcl"),
    "draw": ("morphcl_bench_draw", "bench/morphcl_bench_draw"),
    "shot": ("morphcl_bench_shot", "bench/morphcl_bench_shot"),
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
    paths: dict  # of NEEDED and of those of PEERS that could be built: name -> path
    kernel_benches: list  # paths

    def __getitem__(self, name):
        return self.paths[name]

    def drawing(self):
        """Programs that draw scenes, by the name of their figures: morphcl first."""
        return {"morphcl": self.paths["draw"], **{name: self.paths[name] for name in PEERS if name in self.paths}}

    def leave_out(self, name):
        self.paths.pop(name, None)

    def missing(self):
        """Markdown lines that name the peers that are left out."""
        return [f"Left out, as it could not be built or found nothing to draw with: {name} (Debian packages: "
                f"{packages})." for name, (_, _, packages) in PEERS.items() if name not in self.paths]


def build(folder):
    """Configures and builds into `folder`. Raises CalledProcessError when what is needed cannot be built."""
    subprocess.run(["cmake", "-S", machine.ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DMORPHCL_BUILD_BENCH=ON"], check=True, stdout=subprocess.DEVNULL)
    known = subprocess.run(["cmake", "--build", folder, "--target", "help"], check=True, capture_output=True,
                           text=True).stdout
    wanted = {name: (target, path) for name, (target, path) in NEEDED.items()}
    wanted |= {name: (target, path) for name, (target, path, _) in PEERS.items() if f"{target}:" in known}
    others = {target for target, _ in wanted.values()} | {"morphcl_bench_common"}
    kernel_targets = sorted(set(re.findall(r"^(morphcl_bench_\w+):", known, re.MULTILINE)) - others)
    targets = [target for target, _ in wanted.values()] + kernel_targets
    subprocess.run(["cmake", "--build", folder, "--target", *targets], check=True, stdout=sys.stderr)
    folder = pathlib.Path(folder)
    return Programs({name: folder / path for name, (_, path) in wanted.items()},
                    [folder / KERNEL_BENCHES / target for target in kernel_targets])
