"""Pages of Markdown and files of comma-separated values."""

import csv
import re

from lib import machine


def table(head, rows):
    """Lines of a Markdown table."""
    return [f"| {' | '.join(head)} |", "|" + "---|" * len(head), *(f"| {' | '.join(map(str, row))} |" for row in rows)]


def write_csv(path, rows, columns):
    """`rows`: dictionaries; what a column lacks stays empty."""
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: f"{value:.5f}" if isinstance(value, float) else value for key, value in row.items()}
                         for row in rows)


def write_page(path, title, introduction, body, foot, load_before):
    """`body`: lines. `foot`: list items beside those on the machine."""
    lines = [f"# {title}", "", introduction, "", *body, "", *foot, *machine.lines(load_before)]
    path.write_text(re.sub(r"\n{3,}", "\n\n", "\n".join(lines)) + "\n")
    print(path.read_text())
