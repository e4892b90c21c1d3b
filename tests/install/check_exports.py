"""A shared library exports what the public headers declare, and nothing of the rooms behind them.

Takes nm and the library.
"""

import subprocess
import sys

DECLARED = ["morphcl::run(", "morphcl::Planner::plan(", "morphcl::context_of(", "typeinfo for morphcl::Error",
            "morphcl::Transform<float>::points("]
HIDDEN = ["morphcl::PixelHasher", "morphcl::FramePattern", "morphcl::MeshStore", "morphcl::reference::", "morphcl::checked"]


def main():
    nm, library = sys.argv[1:]
    table = subprocess.run([nm, "--dynamic", "--defined-only", "--demangle", library],
                           capture_output=True, text=True, check=True).stdout
    missing = [name for name in DECLARED if name not in table]
    shown = [line for line in table.splitlines() if any(name in line for name in HIDDEN)]
    for name in missing:
        print(f"{name} is not exported")
    for line in shown:
        print(f"exported: {line}")
    return 1 if missing or shown else 0


sys.exit(main())
