"""The tables of scripts/same_bits. Status 1 where a row differs.

    same_bits_table.py frames [--documented PAGE] [--write=yes] TABLE...   hashes.tsv of this system and of others
    same_bits_table.py accuracy JSON JSON                                  what `morphcl accuracy --json` printed
"""

import argparse
import collections
import json
import pathlib
import re
import sys

BEGIN, END = "<!-- hashes: written by scripts/same_bits --write -->", "<!-- end of hashes -->"
PAGE_ROW = re.compile(r"^\| (\S+) \| (-?\d+) \| `([0-9a-f]{32})` \|$", re.MULTILINE)


def read_tables(paths):
    """{(shot, frame): {hash: [ways of drawing it]}} and the ways, in their order."""
    rows, ways = collections.OrderedDict(), []
    for path in paths:
        for number, line in enumerate(pathlib.Path(path).read_text().splitlines(), 1):
            fields = line.split("\t")
            if len(fields) != 4:
                sys.exit(f"{path}:{number}: not a way of drawing, a shot, a frame and a hash")
            way, shot, frame, digest = fields
            if way not in ways:
                ways.append(way)
            rows.setdefault((shot, int(frame)), collections.OrderedDict()).setdefault(digest, []).append(way)
    return rows, ways


def add_documented(rows, page):
    text = pathlib.Path(page).read_text()
    for shot, frame, digest in PAGE_ROW.findall(text):
        if (shot, int(frame)) in rows:
            rows[shot, int(frame)].setdefault(digest, []).append(page)


def table_of(rows):
    lines = ["| shot | frame | hash |", "|---|---|---|"]
    lines += [f"| {shot} | {frame} | `{next(iter(hashes))}` |" for (shot, frame), hashes in rows.items()]
    return "\n".join(lines)


def differences(rows, ways):
    lines = []
    for (shot, frame), hashes in rows.items():
        if len(hashes) > 1:
            lines.append(f"{shot} {frame} differs:")
            lines += [f"  {digest}  {'; '.join(by)}" for digest, by in hashes.items()]
        drawn = {way for by in hashes.values() for way in by}
        lines += [f"{shot} {frame} was not drawn by {way}" for way in ways if way not in drawn]
    return lines


def frames(options):
    rows, ways = read_tables(options.tables)
    different = differences(rows, ways)
    if options.write == "yes":
        if different:
            print("\n".join(different))
            sys.exit("nothing is written: rows differ")
        page = pathlib.Path(options.documented)
        text = page.read_text()
        before, rest = text.split(BEGIN)
        after = rest.split(END)[1]
        drawn = "Drawn, each frame with one hash:\n\n" + "\n".join(f"- {way}" for way in ways)
        page.write_text(f"{before}{BEGIN}\n{drawn}\n\n{table_of(rows)}\n{END}{after}")
    elif options.documented:
        add_documented(rows, options.documented)
        different = differences(rows, ways)
    print(table_of(rows))
    print(f"{len(rows)} frames, each drawn in {len(ways)} ways:")
    print("\n".join(f"  {way}" for way in ways))
    print("\n".join(different) if different else "no row differs")
    return 1 if different else 0


def accuracy_hashes(path):
    """{(operation, family, variant, place): (hash, whether it leans on the C library)}"""
    found = {}
    for line in pathlib.Path(path).read_text().splitlines():
        report = json.loads(line)
        if report.get("type") != "operation":
            continue
        for result in report["results"]:
            key = report["operation"], result["family"], result["variant"], result["place"]
            found[key] = result["hash"], result.get("c_library", False)
    return found


def accuracy(options):
    first, second = map(accuracy_hashes, options.tables)
    different, naive = [], []
    for key in first.keys() | second.keys():
        if key not in first or key not in second or first[key][0] != second[key][0]:
            leans = key in first and key in second and first[key][1]
            (naive if leans else different).append(" / ".join(key))
    print(f"morphcl accuracy: {len(first)} hashes, {len(first) - len(different) - len(naive)} equal by both compilers")
    for name in sorted(naive):
        print(f"  differs, as it calls the C library: {name}")
    for name in sorted(different):
        print(f"  differs: {name}")
    if not first:
        sys.exit(f"{options.tables[0]} has no hashes")
    return 1 if different else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["frames", "accuracy"])
    parser.add_argument("--documented", metavar="PAGE")
    parser.add_argument("--write", choices=["yes", "no"], default="no")
    parser.add_argument("tables", nargs="+")
    options = parser.parse_args()
    return frames(options) if options.what == "frames" else accuracy(options)


if __name__ == "__main__":
    sys.exit(main())
