# SPDX-License-Identifier: MIT
"""Each line of docs/how-to/read-in-pandas.md reads every table of a run of 6000 s, with the types in its manifest."""
import importlib
import json
import os
import pathlib
import shutil
import subprocess

import pandas
import pytest

PAGE = (pathlib.Path(__file__).resolve().parents[3] / "docs/how-to/read-in-pandas.md").read_text().splitlines()
PROGRAM = os.environ.get("TROPHIC_PREDATOR_PREY")


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    if not PROGRAM:
        pytest.skip("no program")
    folder = tmp_path_factory.mktemp("types") / "run"
    options = "--backend kinematic --rules released --duration 6000 --seed 5 --senses --states --replay-hz 0 --out"
    subprocess.run([PROGRAM, *options.split(), folder], check=True, capture_output=True)
    types = {
        file: table["columns"] for file, table in json.loads((folder / "manifest.json").read_text())["tables"].items()
    }
    return folder, types, {file: pandas.read_csv(folder / file, dtype=str, keep_default_na=False) for file in types}


def test_types_are_of_all_columns_and_hold_their_cells(run):
    assert len(run[1]) == len(list(run[0].glob("*.csv"))) == 6
    for file, frame in run[2].items():
        assert list(frame.columns) == list(run[1][file])
        for name, kind in run[1][file].items():
            cells = frame[name][frame[name] != ""]
            assert (
                not cells.str.fullmatch("[-0-9.e]+").any()
                if kind == "string"
                else cells.map(int if kind == "int64" else float).size == cells.size
            )


@pytest.mark.parametrize("reader", ["pandas", "polars", "pyarrow.csv", "duckdb"])
def test_the_page_reads_every_table(run, reader):
    pytest.importorskip(reader)
    line = next(line for line in PAGE if line.startswith(f"{reader}.read_csv(f"))
    for file, frame in run[2].items():
        names = {
            reader.split(".")[0]: importlib.import_module(reader.split(".")[0]),
            "run": str(run[0]),
            "types": run[1],
        }
        assert len(eval(line.replace("events.csv", file), names)) == len(frame)


def test_the_page_reads_every_table_in_r(run):
    if (
        not shutil.which("Rscript")
        or subprocess.run(["Rscript", "-e", "library(jsonlite)"], capture_output=True).returncode
    ):
        pytest.skip("no R with jsonlite")
    lines = "; ".join(
        line.replace("runs/first-1", str(run[0])) for line in PAGE if line.startswith(("types <- ", "events <- "))
    )
    for file, frame in run[2].items():
        done = subprocess.run(
            ["Rscript", "-e", f"{lines.replace('events.csv', file)}; stopifnot(nrow(events) == {len(frame)})"],
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stderr
