# SPDX-License-Identifier: MIT
"""Reads the folders that runs and sets of runs leave, and what `trophic analyze` made of them, as pandas frames.

docs/files.md says which files there are, docs/tables.md has the columns. Needs pandas."""

import dataclasses
import functools
import io
import json
import os
import pathlib
import zlib

import pandas

TABLES = ("events", "agents", "phylogeny", "genomes", "senses", "states")
# Ids and counts may be absent; what is empty in a text column is an empty text.
_TEXT = ("event", "species", "cause", "cause_of_death", "origin", "unit", "metric", "group", "baseline", "set", "swap", "tag_outcome")


class RunError(ValueError):
    """A folder that is no run, or no set of runs; the message names it."""


@dataclasses.dataclass(frozen=True)
class Run:
    """A folder of one run. Tables are read when they are first asked for; RunError for one that is not what the run wrote."""

    path: pathlib.Path
    manifest: dict
    """manifest.json: rules, numbers, seed, versions, and how the run ended."""

    @property
    def complete(self) -> bool:
        return self.manifest["status"] == "complete"

    @property
    def seed(self) -> int:
        return self.manifest["seed"]

    @property
    def builds(self) -> list[str]:
        """The codes of the programs that made it: several if another build resumed it with --accept-other-build."""
        programs = [self.manifest, self.manifest.get("origin", {}), *self.manifest.get("continued", [])]
        return sorted({program["code"] for program in programs if "code" in program})

    @property
    def fingerprint(self) -> str:
        """Runs that share it have the same rules, numbers, models and backend."""
        return self.manifest["fingerprint"]

    def table(self, name: str, columns: list[str] | None = None) -> pandas.DataFrame:
        """events, agents, phylogeny, genomes, senses of a run with --senses, or states of one with --states; only these columns, if given."""
        file = f"{name}.csv"
        return _table(self.path / file, columns, self.manifest.get("tables", {}).get(file))

    @functools.cached_property
    def events(self) -> pandas.DataFrame:
        """Births, activations, tag switches, catches and deaths, one a row."""
        return self.table("events")

    @functools.cached_property
    def agents(self) -> pandas.DataFrame:
        """Every robot at every tick."""
        return self.table("agents")

    @functools.cached_property
    def phylogeny(self) -> pandas.DataFrame:
        """Every individual, in the ALife data standard."""
        return self.table("phylogeny")

    @functools.cached_property
    def genomes(self) -> pandas.DataFrame:
        """A row a birth."""
        return self.table("genomes")

    @functools.cached_property
    def senses(self) -> pandas.DataFrame:
        """What every robot touched, was told and answered, of a run with --senses. `inputs` has the names of input0, input1, ..."""
        return self.table("senses")

    @functools.cached_property
    def states(self) -> pandas.DataFrame:
        """What rules keep for every robot, of a run with --states: a column SLOT.MEMBER for each member of each State."""
        return self.table("states")

    @property
    def inputs(self) -> list[str]:
        """The sensors that input0, input1, ... of `senses` are the values of. KeyError for a run without that table."""
        return self.manifest["senses"]["inputs"]


@dataclasses.dataclass(frozen=True)
class Runs:
    """Replicates: runs that differ in their seeds only, and the runs of their neutral shadow, if there is one."""

    path: pathlib.Path
    runs: list[Run]
    shadow: "Runs | None" = None

    def __len__(self) -> int:
        return len(self.runs)

    def __iter__(self):
        return iter(self.runs)

    def __getitem__(self, index: int) -> Run:
        return self.runs[index]

    def table(self, name: str, columns: list[str] | None = None) -> pandas.DataFrame:
        """That table of all runs, with the columns `run` (the folder's name) and `seed` in front."""
        tables = []
        for run in self.runs:
            table = run.table(name, columns)
            table.insert(0, "run", run.path.name)
            table.insert(1, "seed", run.seed)
            tables.append(table)
        return pandas.concat(tables, ignore_index=True)


@dataclasses.dataclass(frozen=True)
class Analysis:
    """What `trophic analyze` wrote."""

    path: pathlib.Path
    metrics: pandas.DataFrame
    """metrics.csv: every value and every curve of every run, one value a row. Texts that are empty stay empty texts."""
    summary: dict
    """summary.json: means, intervals and verdicts of each set."""


def read_run(path: str | os.PathLike) -> Run:
    """The run in this folder. Raises RunError for a folder that is none."""
    path = pathlib.Path(path)
    try:
        manifest = json.loads((path / "manifest.json").read_text())
        if not {"status", "seed", "fingerprint", "rule_table"} <= manifest.keys():
            raise RunError(f"{path}/manifest.json: not a run's")
    except FileNotFoundError:
        raise RunError(f"{path}: no run: it has no manifest.json") from None
    except json.JSONDecodeError as error:
        raise RunError(f"{path}/manifest.json: broken: {error}") from None
    return Run(path, manifest)


def read_runs(path: str | os.PathLike, *, incomplete: bool = False, accept_other_build: bool = False) -> Runs:
    """The replicates in this folder, in order, and those of its shadow. Incomplete ones are left out unless they are asked for.

    Raises RunError for a folder without replicates, for runs of different fingerprints, which are not replicates, and for runs
    that different builds of a program made unless that is accepted: their rules may be other code under the same names.
    """
    path = pathlib.Path(path)
    numbered = {folder.name.removeprefix("replicate-"): folder for folder in path.glob("replicate-*")}
    folders = [numbered[number] for number in sorted(filter(str.isdigit, numbered), key=int)]
    runs = [run for folder in folders if (folder / "manifest.json").exists() and ((run := read_run(folder)).complete or incomplete)]
    if not runs:
        raise RunError(f"{path}: no {'' if incomplete else 'complete '}replicates")
    fingerprints = {run.fingerprint for run in runs}
    if len(fingerprints) > 1:
        raise RunError(f"{path}: runs of different fingerprints: {', '.join(sorted(fingerprints))}")
    builds = {tuple(run.builds) for run in runs}
    if len(builds) > 1 and not accept_other_build:
        raise RunError(f"{path}: made by different builds: {', '.join(' and '.join(each) or 'unknown' for each in sorted(builds))}; accept_other_build=True reads them")
    shadow = read_runs(path / "shadow", incomplete=incomplete, accept_other_build=accept_other_build) if (path / "shadow").is_dir() else None
    return Runs(path, runs, shadow)


def read_study(path: str | os.PathLike, *, incomplete: bool = False, accept_other_build: bool = False) -> dict[str, Runs]:
    """Every set of runs below this folder, by its path from there: a sweep, or the flips of an ablation study."""
    path = pathlib.Path(path)
    folders = sorted(file.parent for file in path.rglob("replicates.json") if file.parent.name != "shadow")
    if not folders:
        raise RunError(f"{path}: no set of runs (replicates.json) below it")
    return {str(folder.relative_to(path)): read_runs(folder, incomplete=incomplete, accept_other_build=accept_other_build) for folder in folders}


def read_analysis(path: str | os.PathLike) -> Analysis:
    """The folder that `trophic analyze --out` made. Raises RunError for another."""
    path = pathlib.Path(path)
    try:
        return Analysis(path, _table(path / "metrics.csv"), json.loads((path / "summary.json").read_text()))
    except (FileNotFoundError, json.JSONDecodeError, pandas.errors.ParserError, KeyError, RunError) as error:
        raise RunError(f"{path}: not what trophic analyze writes: {error}") from None


def _whole_lines(path: pathlib.Path, expected: dict | None) -> bytes:
    """The table; without the part of a line that a killed program left. RunError if it is not what the run wrote, or not a table."""
    try:
        content = path.read_bytes()
    except OSError as error:
        raise RunError(f"{path}: cannot be read: {error.strerror}") from None
    found = {"rows": max(0, content.count(b"\n") - 1), "crc32": zlib.crc32(content)}
    if expected is not None and found != expected:
        raise RunError(f"{path}: has {found['rows']} rows and checksum {found['crc32']}: must be {expected['rows']} and {expected['crc32']}, as its manifest says; the table was cut or changed after the run")
    content = content[: content.rfind(b"\n") + 1]
    if content.startswith(b"\xef\xbb\xbf"):
        raise RunError(f"{path}:1: begins with a byte order mark; another kind of file?")
    if not content:
        raise RunError(f"{path}: has no header")
    lines = content[:-1].split(b"\n")
    commas = lines[0].count(b",")
    for number, line in enumerate(lines, 1):
        cells = line if b'"' not in line else b"".join(line.split(b'"')[::2])  # commas in quotes separate nothing
        if cells.count(b",") != commas:
            raise RunError(f"{path}:{number}: {cells.count(b',') + 1} cells, the header has {commas + 1}")
    return content


def _table(path: pathlib.Path, columns: list[str] | None = None, expected: dict | None = None) -> pandas.DataFrame:
    content = _whole_lines(path, expected)
    header = pandas.read_csv(io.BytesIO(content), nrows=0).columns
    texts = {name: str for name in header if name in _TEXT or name == "run"}
    numbers = {name: [""] for name in header if name not in texts}
    table = pandas.read_csv(io.BytesIO(content), usecols=columns, dtype=texts, keep_default_na=False, na_values=numbers,
                            float_precision="round_trip")  # else the last bit of a number may be another
    if "tick" in table and not table["tick"].is_monotonic_increasing:
        raise RunError(f"{path}: tick: must be >= that of the row before")
    return table
