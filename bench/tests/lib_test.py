"""Tests of what bench/run computes from the figures: python3 -m unittest discover bench/tests -p '*_test.py'"""

import argparse
import contextlib
import csv
import io
import math
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from lib import (growth_checks, job, kernels, machine, memory, pictures, plot, processes, programs,  # noqa: E402
                 samples, scaling, series, stages, tables)


def picture(**changes):
    return {"width": 1920, "height": 1080, "covered": 435_000, "mean_red": 0.115, **changes}


class Pictures(unittest.TestCase):
    def test_programs_may_differ_by_what_rounding_explains(self):
        pictures.check_same("morph", {"a": picture(), "b": picture(covered=435_207, mean_red=0.1159)})

    def test_another_silhouette_stops(self):
        with self.assertRaisesRegex(SystemExit, "a and b draw different pictures: covered"):
            pictures.check_same("morph", {"a": picture(), "b": picture(covered=435_208)})

    def test_another_colour_stops(self):
        with self.assertRaisesRegex(SystemExit, "a and c draw different pictures: mean_red"):
            pictures.check_same("morph", {"a": picture(), "b": picture(), "c": picture(mean_red=0.1162)})

    def test_patterns_of_samples_may_reach_as_far_beyond_an_outline_as_samples_lie(self):
        share = pictures.COVERED_SHARE_BY_SAMPLES
        pictures.check_same("morph", {"a": picture(), "b": picture(covered=435_000 + 16_588)}, share)
        with self.assertRaisesRegex(SystemExit, "covered"):
            pictures.check_same("morph", {"a": picture(), "b": picture(covered=435_000 + 16_589)}, share)
        with self.assertRaisesRegex(SystemExit, "mean_red"):
            pictures.check_same("morph", {"a": picture(), "b": picture(mean_red=0.1162)}, share)


class Processes(unittest.TestCase):
    def test_each_file_has_its_time_and_the_report_is_apart(self):
        # A line is one write, as the compared programs do it: processes share the pipe.
        program = "import os, time\nfor i in range(2):\n os.write(1, b'{\"frame\": 1, \"path\": \"p\"}\\n'); " \
                  "time.sleep(0.05)\nos.write(1, b'{\"done\": 1}\\n')"
        watched = processes.watch([[sys.executable, "-c", program]] * 2)
        self.assertEqual([path for _, path in watched.frames], ["p"] * 4)
        times = [time for time, _ in watched.frames]
        self.assertEqual(times, sorted(times))
        self.assertGreaterEqual(watched.seconds, times[-1] + 0.05)
        self.assertEqual(watched.reports, [{"done": 1}, {"done": 1}])
        self.assertGreater(watched.peak_megabytes, 2)
        self.assertEqual(watched.drawn_by, [])

    def test_a_named_device_has_to_draw_all(self):
        line = '{"frame": 1, "path": "p", "drawn_by": "%s"}'
        for renderer, device, right in (("cpu", "0", True), ("reference", "auto", True), ("reference", "0", False)):
            command = [sys.executable, "-c", f"print('{line % renderer}')", "--device", device]
            if right:
                self.assertEqual(processes.watch([command]).drawn_by, [renderer])
            else:
                with self.assertRaisesRegex(SystemExit, "not drawn by the device"):
                    processes.watch([command])

    def test_what_a_failing_program_says_ends_the_run(self):
        with self.assertRaisesRegex(SystemExit, "went wrong"):
            processes.watch([[sys.executable, "-c", "import sys; sys.exit('went wrong')"]])

    def test_a_peer_without_a_device(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "peer"
            for status, found in ((0, True), (69, False)):
                program.write_text(f"#!/bin/sh\nexit {status}\n")
                program.chmod(0o755)
                self.assertEqual(processes.has_device(program), found)


class Growth(unittest.TestCase):
    def test_spread_of_the_time_of_one(self):
        self.assertAlmostEqual(growth_checks.spread_each([(100, 300), (1000, 1200)]), 3 / 1.2)
        self.assertIsNone(growth_checks.spread_each([(100, 300)]))

    def test_spread_of_the_time_of_a_further_one(self):
        self.assertAlmostEqual(growth_checks.spread_further([(10, 100), (20, 110), (40, 170)]), 3)
        self.assertIsNone(growth_checks.spread_further([(10, 100), (20, 110)]))
        self.assertEqual(growth_checks.spread_further([(10, 100), (20, 90), (40, 170)]), math.inf)

    def test_only_the_wanted_points(self):
        self.assertEqual(growth_checks.at([(3, 1), (1, 2), (2, 3)], (1, 3)), [(1, 2), (3, 1)])

    def test_line_through_memory(self):
        growth = memory.Growth("n", "n", [(0, 50), (2**20, 150), (2 * 2**20, 250)])
        self.assertAlmostEqual(growth.megabytes_at_0, 50)
        self.assertAlmostEqual(growth.bytes_each, 100)
        self.assertAlmostEqual(growth.largest_deviation, 0)
        bent = memory.Growth("n", "n", [(0, 50), (1, 50), (2, 110)])
        self.assertAlmostEqual(bent.largest_deviation, 0.4)

    def test_a_limit_that_is_passed_is_said_to_fail(self):
        curves = {"triangles": {"morphcl": [(1e4, 1), (1e5, 2), (1e7, 300)],
                                series.SAME_SIZE: [(1e5, 2), (1e6, 10), (1e7, 200)]},
                  "pixels": {growth_checks.ALL_COVERED: [(1920 * 1080, 1), (7680 * 4320, 16)],
                             growth_checks.FIFTH_COVERED: [(1920 * 1080, 1)]},
                  "objects": {growth_checks.ALL_OBJECTS: [(100_000, 7)], growth_checks.VISIBLE_OBJECTS: [(100_000, 2)]},
                  "targets": {"morphcl": [(5, 10), (256, 11)]}}
        found = {statement: value for statement, _, value in growth_checks.checks(curves, [])}
        self.assertAlmostEqual(found["time / pixels, 1080p to 8K, all covered: largest / smallest"], 1)
        self.assertIsNone(found["time / pixels, 1080p to 8K, a fifth covered: largest / smallest"])
        self.assertAlmostEqual(found["time / triangles, 10⁵ to 10⁷ of the same size: largest / smallest"], 2)
        self.assertAlmostEqual(found["100,000 objects against only those in view: times the time"], 3.5)
        self.assertAlmostEqual(found["256 targets with 5 active against 5 targets: times the time"], 1.1)
        busy = {**curves, "targets": {"morphcl": [(5, 10), (256, 30)]}}
        lines = growth_checks.table(curves, busy, [])
        self.assertTrue(any("3.50 | **no** | 3.50" in line for line in lines))
        self.assertTrue(any("1.10 | yes | 3.00" in line for line in lines))

    def test_medians_of_the_rounds(self):
        rows = [{"series": "s", "curve": "c", "x": x, "frame_ms": ms} for x, ms in ((2, 9), (1, 1), (1, 8), (1, 3))]
        self.assertEqual(scaling.curves_of(rows, "s"), {"c": [(1, 3), (2, 9)]})

    def test_pictures_of_a_step_are_compared_between_all_curves(self):
        base = {"series": "objects", "x": 1, "frames": 2}
        rows = [{**base, "scene": "crowd", "curve": "a", **picture()},
                {**base, "scene": "crowd_in_view", "curve": "b", **picture(covered=1)}]
        with self.assertRaisesRegex(SystemExit, "different pictures"):
            scaling.check_pictures(rows)


class Job(unittest.TestCase):
    def test_beside_the_peer(self):
        rows = [{"scene": "morph", "program": name, "frame_ms": frame, "with_start_ms": whole}
                for name, frame, whole in (("morphcl", 2.0, 4.0), ("llvmpipe", 20.0, 30.0), ("morphcl", 4.0, 4.0),
                                           ("llvmpipe", 24.0, 30.0), ("morphcl", 4.0, 4.0), ("llvmpipe", 32.0, 20.0))]
        self.assertEqual(job.beside_peer(rows, "morph", "morphcl"),
                         ["**6.0**", *job.GOALS["morphcl"]["morph"], "6.0 to 10.0", "7.5"])


class Samples(unittest.TestCase):
    def run_part(self, *, peers=("llvmpipe",), refused=(), covered=9000):
        """The page and the rows of the CSV, of programs that take as many milliseconds as samples, llvmpipe ten times
        as many, and one less by its shader."""
        def report(command):
            name, scene, *words = map(str, command)
            values = dict(zip(words, words[1:]))
            peer = name == "llvmpipe"
            ms = int(values["--samples"]) * (10 if peer else 1) - (values.get("--resolve") == "shader")
            width, height = map(int, values.get("--size", "1920x1080").split("x"))
            return {"renderer": "none", "width": width, "height": height, "threads": 2, "frames": 6, "frame_ms": ms,
                    "fastest_ms": ms, "cpu_ms": 3 * ms, "covered": covered if peer else 9000, "mean_red": 0.1}

        def has_device(_, *words):
            return words[-1] not in refused
        paths = {"draw": "morphcl", **{peer: peer for peer in peers}}
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()), \
                contextlib.redirect_stderr(io.StringIO()), mock.patch.object(processes, "report", report), \
                mock.patch.object(processes, "has_device", has_device):
            options = argparse.Namespace(rounds=2, quick=True, threads=2, results=pathlib.Path(folder))
            samples.run(programs.Programs(folder, paths), options)
            with open(options.results / "samples.csv") as file:
                return (options.results / "samples.md").read_text(), list(csv.DictReader(file))

    def test_the_faster_resolve_is_compared_with_and_both_are_stated(self):
        page, rows = self.run_part()
        self.assertIn("| morph | 1920 × 1080 | 4 and 4 | 4.00 | 40.00 | 39.00 | **9.8** | 12 | 25 | 9.8 to 9.8 | 9.8 |",
                      page)
        self.assertIn("| morph | 1920 × 1080 | 16 and 4 | 16.00 | 40.00 | 39.00 | **2.4** | 6 | 12 |", page)
        self.assertIn("| heavy | 3840 × 2160 | 1.00 | 10.00 | **10.0** | 5.5 | 8 | 10.0 to 10.0 | 10.0 |", page)
        self.assertIn("| heavy | 1920 × 1080 | 1.00 | 4.00 | **4.00** | 2.2 | 1.7 | 4.00 to 4.00 | 4.00 |", page)
        self.assertEqual({row["round"] for row in rows}, {"1", "2"})

    def test_z_is_drawn_beside_one_sample_of_a_single_surface_only(self):
        _, rows = self.run_part()
        self.assertEqual({(row["scene"], row["samples"]) for row in rows if row["depth"] == "True"},
                         {("heavy", "1"), ("morph", "1"), ("wire", "1")})
        commands = [samples.command_of(programs.Programs(None, {"draw": "d"}), samples.Picture("morph", depth=depth),
                                       samples.Drawing("morphcl", 4), argparse.Namespace(threads=2, quick=False))
                    for depth in (False, True)]
        self.assertEqual(commands[0], [*commands[1], "--colors-only"])

    def test_a_resolve_that_the_driver_refuses_is_left_out_and_named(self):
        page, rows = self.run_part(refused=["shader"])
        self.assertIn("| morph | 1920 × 1080 | 4 and 4 | 4.00 | 40.00 |  | **10.0** |", page)
        self.assertIn("refuses 4 samples so: shader", page)
        self.assertEqual({row["resolve"] for row in rows}, {"", "blit"})

    def test_without_the_peer_four_samples_stand_beside_one(self):
        page, rows = self.run_part(peers=())
        self.assertIn("| morph | 1920 × 1080 | 1.00 | 4.00 | **4.00** | 1.6 | 1.2 |", page)
        self.assertIn("Left out", page)
        self.assertNotIn("beside llvmpipe", page)
        self.assertEqual({row["program"] for row in rows}, {"morphcl"})

    def test_another_picture_stops(self):
        with self.assertRaisesRegex(SystemExit, "morph: morphcl 1 and llvmpipe 4 blit draw different pictures"):
            self.run_part(covered=9000 + 16_589)


class Figures(unittest.TestCase):
    def test_google_benchmark(self):
        entries = [{"run_name": "copy/8", "aggregate_name": name, "real_time": time, "time_unit": "us",
                    "bytes_per_second": 3e9} for name, time in (("mean", 9.0), ("median", 2.0), ("cv", 0.05))]
        row, = kernels.rows_of("p", {"benchmarks": entries})
        self.assertEqual((row["median_ns"], row["deviation_percent"], row["gigabytes_per_second"]), (2000.0, 5.0, 3.0))

    def test_stages_stand_in_the_order_of_a_frame(self):
        self.assertEqual(stages.in_order({stages.REST, "zzz", "shade_tiles", "plan"}),
                         ["plan", "shade_tiles", "zzz", stages.REST])

    def test_page(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "page.md"
            tables.write_page(path, "Title", "Intro.", tables.table(["a", "b"], [[1, 2]]), ["- foot"], 0.5)
            text = path.read_text()
        self.assertIn("| a | b |\n|---|---|\n| 1 | 2 |\n\n- foot\n", text)
        self.assertIn(machine.processor_name(), text)

    @unittest.skipUnless(plot.available(), "no gnuplot")
    def test_plot(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "plot.svg"
            plot.lines(path, "What's up", "x", "y", {"morphcl, it's": [(1, 2), (10, 20)]})
            text = path.read_text()
        self.assertIn("What's up", text)
        self.assertIn("morphcl, it's", text)


if __name__ == "__main__":
    unittest.main()
