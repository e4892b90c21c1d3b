#!/usr/bin/env python3
"""make_models.py [FOLDER]: writes the models of the demo shots, colored_cube.gltf and water_lily.gltf; beside itself,
or into FOLDER. The same bytes on every machine."""

import pathlib
import sys

import colored_cube
import water_lily


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent
    colored_cube.write(folder / "colored_cube.gltf")
    water_lily.write(folder / "water_lily.gltf")


if __name__ == "__main__":
    main()
