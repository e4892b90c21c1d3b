"""demo_models_test.py: demos/models/make_models.py makes the models that lie beside it, byte for byte."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

MODELS = pathlib.Path(__file__).resolve().parents[2] / "demos" / "models"
LARGEST_BYTES = 400_000


class DemoModels(unittest.TestCase):
    def test_the_script_makes_the_files(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-B", MODELS / "make_models.py", folder], check=True)
            made = {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}
        kept = {path.name: path.read_bytes() for path in MODELS.glob("*.gltf")}
        self.assertEqual(sorted(made), sorted(kept))
        for name, content in kept.items():
            self.assertEqual(made[name], content, f"{name} is not what make_models.py writes")
            self.assertLess(len(content), LARGEST_BYTES, name)

    def test_every_petal_belongs_to_two_targets(self):
        model = json.loads((MODELS / "water_lily.gltf").read_text())
        names = model["meshes"][0]["extras"]["targetNames"]
        rows = [f"{number:02}" for number in range(1, 13)]
        self.assertEqual(names, [f"{step}_{row}" for row in rows for step in ("lift", "open")] + ["spread"])
        counts = [model["accessors"][target["POSITION"]]["sparse"]["count"]
                  for target in model["meshes"][0]["primitives"][0]["targets"]]
        self.assertEqual(counts[:-1], [4 * 5 * 8] * 24)


if __name__ == "__main__":
    unittest.main()
