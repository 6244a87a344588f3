# SPDX-License-Identifier: MIT
"""Reads the folders that runs and sets of runs leave, and what `trophic analyze` made of them, as pandas frames.

docs/files.md says which files there are, docs/tables.md has the columns. Needs pandas."""
from __future__ import annotations

import dataclasses
import functools
import html
import io
import json
import os
import pathlib
import zlib

import pandas

TABLES = ("events", "agents", "phylogeny", "genomes", "senses", "states")
# Ids and counts may be absent; what is empty in a text column is an empty text.
_TEXT = ("same_as", "null", "compared", "event", "species", "cause", "cause_of_death", "origin", "unit", "metric", "group", "baseline", "set", "swap", "tag_outcome")


_CATEGORIES = ("event", "species", "cause", "cause_of_death", "origin", "tag_outcome", "run", "set")


class RunError(ValueError):
    """A folder that is not a run, or not a set of runs; the message names it."""


def _card(title: str, facts: dict) -> str:
    """A few facts as a small table for notebooks."""
    rows = "".join(f"<tr><td>{html.escape(str(name))}</td><td>{html.escape(str(value))}</td></tr>" for name, value in facts.items())
    return f"<b>{html.escape(title)}</b><table>{rows}</table>"


@dataclasses.dataclass(frozen=True)
class Run:
    """A folder of one run. Tables are read when they are first asked for; RunError for one that is not what the run wrote."""

    path: pathlib.Path
    manifest: dict = dataclasses.field(repr=False)
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

    def table(self, name: str, columns: list[str] | None = None, *, categories: bool = False) -> pandas.DataFrame:
        """events, agents, phylogeny, genomes, senses of a run with --senses, states of one with --states, or a table of one's own; only these
        columns, if given. With `categories`, species, events, causes and origins are categories, which take less memory."""
        file = f"{name}.csv"
        return _categorised(_table(self.path / file, columns, self.manifest.get("tables", {}).get(file)), categories)

    def to_newick(self) -> str:
        """The phylogeny in Newick format, a line for each founder or random newcomer; branch lengths are times between births in seconds, and
        the last piece of a line is the individual's life. ggtree and ape read it."""
        return _newick(self.phylogeny)

    def show(self, out: str | os.PathLike | None = None):
        """A page of the run (`trophic show`), which a notebook displays; `out` is a new file for it."""
        from .start import show
        return show(self, out)

    def add_table(self, name: str, frame: pandas.DataFrame) -> pathlib.Path:
        """Writes a table of one's own, NAME.csv, into the run's folder, for `trophic analyze --column NAME.csv:COLUMN`. Raises RunError if there is
        one."""
        path = self.path / f"{name}.csv"
        try:
            with open(path, "x", newline="") as file:
                frame.to_csv(file, index=False, lineterminator="\n", na_rep="nan")
        except FileExistsError:
            raise RunError(f"{path}: exists already; nothing is overwritten") from None
        return path

    def _repr_html_(self) -> str:
        m = self.manifest
        return _card(str(self.path), {"rules": m["rule_table"], "backend": m.get("backend"), "seed": self.seed, "status": m["status"],
                                      "fingerprint": self.fingerprint, **m.get("result", {})})

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
    runs: list[Run] = dataclasses.field(repr=False)
    shadow: "Runs | None" = None

    def __len__(self) -> int:
        return len(self.runs)

    def __iter__(self):
        return iter(self.runs)

    def __getitem__(self, index: int) -> Run:
        return self.runs[index]

    def table(self, name: str, columns: list[str] | None = None, *, categories: bool = False) -> pandas.DataFrame:
        """That table of all runs, with the columns `run` (the folder's name) and `seed` in front."""
        tables = []
        for run in self.runs:
            table = run.table(name, columns)
            table.insert(0, "run", run.path.name)
            table.insert(1, "seed", run.seed)
            tables.append(table)
        return _categorised(pandas.concat(tables, ignore_index=True), categories)

    def measure(self, name: str, function) -> None:
        """A metric of one's own: writes NAME.csv into the folder of each run and of its shadow, for `trophic analyze --column NAME.csv:NAME`.

        `function` takes a Run and returns a number, or a frame with the columns NAME and, as it likes, time_s, species and group. nan is a value
        that cannot be computed. Raises RunError, naming the run, if the function throws, returns something else or the file exists; then
        nothing is written.
        """
        tables = []
        for run in [*self.runs, *(self.shadow or [])]:
            if (run.path / f"{name}.csv").exists():
                raise RunError(f"{run.path / name}.csv: exists already; nothing is overwritten")
            try:
                value = function(run)
            except Exception as error:
                raise RunError(f"{run.path}: {name}: {type(error).__name__}: {error}") from error
            if not isinstance(value, pandas.DataFrame):
                try:
                    value = pandas.DataFrame({name: [float(value)]})
                except (TypeError, ValueError):
                    raise RunError(f"{run.path}: {name}: must return a number or a frame, not {type(value).__name__}") from None
            if name not in value.columns:
                raise RunError(f"{run.path}: {name}: the frame has no column {name}")
            tables.append((run, value))
        for run, value in tables:
            run.add_table(name, value)

    def _repr_html_(self) -> str:
        first = self.runs[0]
        return _card(str(self.path), {"rules": first.manifest["rule_table"], "backend": first.manifest.get("backend"), "runs": len(self.runs),
                                      "shadow": len(self.shadow) if self.shadow else "none", "fingerprint": first.fingerprint})


@dataclasses.dataclass(frozen=True)
class Analysis:
    """What `trophic analyze` wrote."""

    path: pathlib.Path
    metrics: pandas.DataFrame = dataclasses.field(repr=False)
    """metrics.csv: every value and every curve of every run, one value a row. Texts that are empty stay empty texts."""
    summary: dict = dataclasses.field(repr=False)
    """summary.json: means, intervals and test results of each set."""

    @functools.cached_property
    def means(self) -> pandas.DataFrame:
        """means.csv: each metric next to each of its nulls."""
        return _table(self.path / "means.csv")

    def _repr_html_(self) -> str:
        frame = self.means[self.means.same_as == ""].dropna(subset=["p_holm"]).sort_values("p")
        shown = frame[["metric", "species", "group", "mean", "null", "null_mean", "difference", "p_holm", "n"]].head(10)
        return _card(str(self.path), {s["set"]: f"{len(s['runs'])} runs" for s in self.summary["sets"]}) + shown.to_html(index=False, float_format="%.4g")


def read_run(path: str | os.PathLike) -> Run:
    """The run in this folder. Raises RunError for another folder."""
    path = pathlib.Path(path)
    try:
        manifest = json.loads((path / "manifest.json").read_text())
        if not {"status", "seed", "fingerprint", "rule_table"} <= manifest.keys():
            raise RunError(f"{path}/manifest.json: not a run's")
    except FileNotFoundError:
        raise RunError(f"{path}: is not a run: it has no manifest.json") from None
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
    """Every set of runs below this folder, by its path from there: a sweep, or the swaps of an ablation study."""
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


def to_parquet(runs: Runs | dict[str, Runs], folder: str | os.PathLike, names: tuple[str, ...] = ("events", "agents", "phylogeny", "genomes")) -> list[pathlib.Path]:
    """Replicates, or a study as read_study gives it, in a few files: FOLDER/events.parquet and so on, with the columns set, shadow, run and seed in
    front. The folder must be new. Needs pyarrow."""
    try:
        import pyarrow
        import pyarrow.parquet
    except ModuleNotFoundError:
        raise RunError("to_parquet: needs the Python module pyarrow: pip install pyarrow") from None
    folder = pathlib.Path(folder)
    if folder.exists():
        raise RunError(f"{folder}: exists already; nothing is overwritten")
    study = runs if isinstance(runs, dict) else {runs.path.name: runs}
    folder.mkdir(parents=True)
    paths = []
    for name in names:
        path = folder / f"{name}.parquet"
        writer = None
        try:
            for label, of in study.items():
                for is_shadow, part in ((False, of), (True, of.shadow)):
                    for run in part or []:
                        frame = run.table(name)
                        for place, (column, value) in enumerate((("set", label), ("shadow", is_shadow), ("run", run.path.name), ("seed", run.seed))):
                            frame.insert(place, column, value)
                        table = pyarrow.Table.from_pandas(frame, schema=writer.schema if writer else None, preserve_index=False)
                        if writer is None:
                            writer = pyarrow.parquet.ParquetWriter(path, table.schema)
                        writer.write_table(table)
        finally:
            if writer is not None:
                writer.close()
        paths.append(path)
    return paths


def _categorised(frame: pandas.DataFrame, categories: bool) -> pandas.DataFrame:
    if not categories:
        return frame
    return frame.astype({column: "category" for column in frame.columns if column in _CATEGORIES})


def _newick(tree: pandas.DataFrame) -> str:
    """Each individual is a node at its birth; below it its offspring in order of birth and the end of its own life, a leaf."""
    born = dict(zip(tree.id, tree.origin_time))
    ends = tree.destruction_time.replace(float("inf"), float("nan"))
    last_s = max(ends.max() if ends.notna().any() else 0.0, tree.origin_time.max())
    died = dict(zip(tree.id, ends.fillna(last_s)))
    parents = dict(zip(tree.id, tree.ancestor_id))
    children: dict = {}
    roots = []
    for child, parent in zip(tree.id, tree.ancestor_id):
        if pandas.isna(parent) or parent == child or parent not in born:
            roots.append(child)
        else:
            children.setdefault(parent, []).append(child)
    lines = []
    for root in roots:
        pieces, waiting = [], [("open", root)]
        while waiting:  # without recursion: lineages are thousands long
            step, one = waiting.pop()
            if step == "text":
                pieces.append(one)
                continue
            length = 0.0 if one == root else born[one] - born[parents[one]]
            young = sorted(children.get(one, []), key=lambda child: (born[child], child))
            if not young:
                pieces.append(f"{one}:{length + died[one] - born[one]:g}")
                continue
            waiting.append(("text", f",{one}:{died[one] - born[one]:g})n{one}:{length:g}"))
            for place, child in reversed(list(enumerate(young))):
                waiting.append(("open", child))
                if place > 0:
                    waiting.append(("text", ","))
            pieces.append("(")
        text = "".join(pieces)
        lines.append((text if text.startswith("(") else f"({text})n{root}:0") + ";")  # ape reads no tree of a tip alone
    return "\n".join(lines) + "\n"
