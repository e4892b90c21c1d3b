"""scripts/lib/same_bits_table.py finds rows that differ, frames that one way lacks, and hashes that a page has."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "lib" / "same_bits_table.py"
A, B = "a" * 32, "b" * 32


class TableTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, name, text):
        path = pathlib.Path(self.folder.name) / name
        path.write_text(text)
        return path

    def run_it(self, *arguments):
        done = subprocess.run([sys.executable, SCRIPT, *map(str, arguments)], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def test_equal_rows(self):
        one = self.file("one", f"here: GCC\tcube\t0\t{A}\nhere: Clang\tcube\t0\t{A}\n")
        code, text = self.run_it("frames", one)
        self.assertEqual(code, 0, text)
        self.assertIn(f"| cube | 0 | `{A}` |", text)

    def test_rows_of_two_systems_that_differ(self):
        one, other = self.file("one", f"12: GCC\tcube\t0\t{A}\n"), self.file("two", f"13: GCC\tcube\t0\t{B}\n")
        code, text = self.run_it("frames", one, other)
        self.assertEqual(code, 1)
        self.assertIn("cube 0 differs", text)
        self.assertIn(f"{B}  13: GCC", text)

    def test_a_frame_that_was_not_drawn(self):
        one = self.file("one", f"GCC\tcube\t0\t{A}\nGCC\tcube\t5\t{B}\nClang\tcube\t0\t{A}\n")
        code, text = self.run_it("frames", one)
        self.assertEqual(code, 1)
        self.assertIn("cube 5 was not drawn by Clang", text)

    def test_the_page_is_compared_and_written(self):
        page = self.file("page", "# Hashes\n<!-- hashes: written by scripts/same_bits --write -->\n"
                                 f"| cube | 0 | `{B}` |\n<!-- end of hashes -->\nEnd.\n")
        one = self.file("one", f"GCC\tcube\t0\t{A}\n")
        code, text = self.run_it("frames", "--documented", page, one)
        self.assertEqual(code, 1)
        self.assertIn(f"{B}  {page}", text)
        self.assertEqual(self.run_it("frames", "--documented", page, "--write=yes", one)[0], 0)
        self.assertEqual(self.run_it("frames", "--documented", page, one)[0], 0)
        self.assertTrue(page.read_text().startswith("# Hashes\n") and page.read_text().endswith("\nEnd.\n"))

    def test_accuracy_may_differ_where_it_calls_the_c_library(self):
        def report(digest, naive):
            results = [{"family": "wide", "variant": "fp32", "place": "host", "hash": digest, "c_library": True},
                       {"family": "wide", "variant": "ours", "place": "host", "hash": naive}]
            return json.dumps({"type": "operation", "operation": "slerp", "results": results}) + "\n"

        one, naive = self.file("one", report("1", "2")), self.file("naive", report("3", "2"))
        ours = self.file("ours", report("1", "4"))
        self.assertEqual(self.run_it("accuracy", one, naive)[0], 0)
        code, text = self.run_it("accuracy", one, ours)
        self.assertEqual(code, 1)
        self.assertIn("differs: slerp / wide / ours / host", text)


if __name__ == "__main__":
    unittest.main()
