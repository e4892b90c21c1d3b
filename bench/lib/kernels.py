"""The part kernels: single kernels and stages by Google Benchmark, as one table."""

import json
import os
import sys

from lib import processes, programs as programs_module, tables

COLUMNS = ["program", "benchmark", "median_ns", "deviation_percent", "gigabytes_per_second", "items_per_second",
           "label"]
OWN_PART = ["morphcl_bench_transform"]
UNIT_NS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}


def measure(path, repetitions, quick):
    command = [path, "--benchmark_format=json", f"--benchmark_repetitions={repetitions}",
               "--benchmark_report_aggregates_only=true", f"--benchmark_min_time={0.05 if quick else 0.2}"]
    return rows_of(path.name, json.loads(processes.output(command)))


def rows_of(program, found):
    """One row a benchmark, from the aggregates of its repetitions."""
    rows = {}
    for entry in found["benchmarks"]:
        row = rows.setdefault(entry["run_name"], {"program": program, "benchmark": entry["run_name"],
                                                  "label": entry.get("label", "")})
        if entry["aggregate_name"] == "median":
            row["median_ns"] = entry["real_time"] * UNIT_NS[entry["time_unit"]]
            for key, name, scale in (("bytes_per_second", "gigabytes_per_second", 1e9),
                                     ("items_per_second", "items_per_second", 1)):
                if key in entry:
                    row[name] = entry[key] / scale
        elif entry["aggregate_name"] == "cv":
            row["deviation_percent"] = 100 * entry["real_time"]
    return list(rows.values())


def time_text(nanoseconds):
    for unit, scale in (("ms", 1e6), ("µs", 1e3)):
        if nanoseconds >= scale:
            return f"{nanoseconds / scale:.3g} {unit}"
    return f"{nanoseconds:.3g} ns"


def table(rows):
    return tables.table(["benchmark", "time, median", "deviation", "GB/s", "million items/s", ""],
                        [[row["benchmark"], time_text(row["median_ns"]), f"{row.get('deviation_percent', 0):.0f} %",
                          f"{row['gigabytes_per_second']:.1f}" if "gigabytes_per_second" in row else "",
                          f"{row['items_per_second'] / 1e6:.1f}" if "items_per_second" in row else "", row["label"]]
                         for row in rows])


def run(programs, options):
    paths = [path for path in programs_module.build_kernel_benches(programs.folder) if path.name not in OWN_PART]
    if not paths:
        print(f"left out: there are no programs in bench/kernels, or no {programs_module.KERNEL_PACKAGES}",
              file=sys.stderr)
        return
    load = os.getloadavg()[0]
    repetitions = options.rounds or (2 if options.quick else 5)
    rows, body = [], []
    for path in paths:
        found = measure(path, repetitions, options.quick)
        rows += found
        body += [f"## {path.name}", "", *table(found), ""]
    tables.write_csv(options.results / "kernels.csv", rows, COLUMNS)
    tables.write_page(options.results / "kernels.md", "Single kernels and stages",
                      "By Google Benchmark; written by `bench/run kernels`. What is measured and how to read it: "
                      "[README](../README.md).", body,
                      [f"- {repetitions} repetitions each; deviation: standard deviation / mean"],
                      load)
