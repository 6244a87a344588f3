# SPDX-License-Identifier: MIT
"""Tables of the documents between <!-- table: NAME --> and <!-- /table -->, from results/data."""
import re
import sys

import answers
import data_rows
import provenance
from page_tables import bodies_race, evolution, open_ended, paper, ponds, races, zones
from page_tables.cells import table

MARKED = re.compile(r"(<!-- table: ([\w ]+) -->\n).*?(<!-- /table -->)", re.S)


class Data:
    """The rows of data files by their names; `used` are those read since it was last emptied."""

    def __init__(self, folder):
        self.folder = folder
        self.origins = provenance.read(folder)
        self.used = []

    def __call__(self, name):
        self.used += [name] if name not in self.used else []
        path = self.folder / f"{name}.csv"
        if not path.exists():
            raise SystemExit(f"{path}: no such file; the stage of studies/reproduce that writes it has not run")
        return data_rows.read(path)


def tables(data, choices):
    """The function that makes each table."""
    made = {
        "open choices": lambda: paper.open_choices(choices),
        "conclusions": lambda: table(answers.conclusion_heads(), answers.conclusions(data)),
        "answers": lambda: table(answers.HEADS, answers.evolved(data) + answers.choices_that_matter(data)),
    }
    for module in (paper, races, evolution, ponds, open_ended, bodies_race, zones):
        made |= module.tables(data)
    return made


def pages_of(studies):
    return sorted((studies / "results").glob("*.md"))


def with_line(data, make):
    """A table, and the line that says where its data come from."""
    data.used.clear()
    text = make()
    if missing := [name for name in data.used if name not in data.origins]:
        raise SystemExit(f"{data.folder / 'provenance.csv'}: has no row of {', '.join(missing)}")
    return text + ("\n" + provenance.line([data.origins[name] for name in data.used]) if data.used else "")


def pages_of_data(studies, choices):
    """{data: the pages with a table of it}."""
    data, found = Data(studies / "results/data"), {}
    made = tables(data, choices)
    for path in pages_of(studies):
        for match in MARKED.finditer(path.read_text()):
            data.used.clear()
            made[match[2]]()
            for name in data.used:
                pages = found.setdefault(name, [])
                pages += [path.name] if path.name not in pages else []
    return found


def update(studies, choices, check=False):
    """Writes the tables of all pages; with `check` only reports differences from the data. Returns the exit code."""
    data = Data(studies / "results/data")
    made = tables(data, choices)
    differing = []
    for path in pages_of(studies):
        page = path.relative_to(studies.parent)
        old = path.read_text()

        def renewed(match):
            if match[2] not in made:
                raise SystemExit(f"{page}: table {match[2]}: must be one of {', '.join(made)}")
            new = match[1] + with_line(data, made[match[2]]) + match[3]
            if new != match[0]:
                differing.append(f"{page}: {match[2]}")
            return new

        text = MARKED.sub(renewed, old)
        if not check and text != old:
            path.write_text(text)
    if check and differing:
        print(
            "tables differ from results/data; run studies/reproduce --tables: " + ", ".join(differing), file=sys.stderr
        )
        return 1
    return 0
