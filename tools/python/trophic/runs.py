# SPDX-License-Identifier: MIT
"""Reads folders of runs, sets of runs and analyses as pandas frames.

docs/files.md lists the files, docs/tables.md the columns. Needs pandas."""
from __future__ import annotations

import contextlib
import dataclasses
import functools
import html
import io
import itertools
import json
import os
import pathlib
import shutil
import zlib
from collections.abc import Iterable, Iterator, Sequence
from typing import BinaryIO

import numpy
import pandas

from . import description, programs
from .errors import RunError
from .values import MOST_NUMBER, one_sided_name, one_sided_species

TABLES = ("events", "agents", "phylogeny", "genomes", "senses", "states")
# Columns of texts, whose empty cells are empty texts.
_TEXT = (
    "same_as",
    "null",
    "compared",
    "event",
    "species",
    "cause",
    "cause_of_death",
    "origin",
    "unit",
    "metric",
    "group",
    "baseline",
    "set",
    "swap",
    "tag_outcome",
    "ancestor_list",
)
# Columns of whole numbers that are never empty. All other numbers may have empty cells or fractions in some run.
_WHOLE = ("tick", "id", "body", "genome_id", "active", "tag", "tag_at_birth")
_CATEGORIES = ("event", "species", "cause", "cause_of_death", "origin", "tag_outcome", "run", "set")


@dataclasses.dataclass(frozen=True)
class Run:
    """The folder of one run. Its tables are read at first use; a table that was modified after the run raises RunError."""

    path: pathlib.Path
    manifest: dict = dataclasses.field(repr=False)
    """manifest.json: rules, parameters, seed, versions, and the status of the run."""

    @property
    def complete(self) -> bool:
        return self.manifest["status"] == "complete"

    @property
    def seed(self) -> int:
        return self.manifest["seed"]

    @property
    def builds(self) -> list[str]:
        """The codes of the programs that made it; several if another build resumed it with --accept-other-build."""
        programs = [self.manifest, self.manifest.get("origin", {}), *self.manifest.get("continued", [])]
        return sorted({program["code"] for program in programs if "code" in program})

    @property
    def fingerprint(self) -> str:
        """Identifies rules, parameters, models and backend at the start; equal for runs that share them."""
        return self.manifest["fingerprint"]

    @property
    def identity(self) -> str:
        """The fingerprint, with a suffix if parameters changed during the run or it began from another run. Equal for replicates."""
        return description.identity(self)

    def table(self, name: str, columns: list[str] | None = None, *, categories: bool = False) -> pandas.DataFrame:
        """Reads events, agents, phylogeny, genomes, senses (--senses), states (--states) or an own table; only `columns`, if given. With
        `categories`, species, events, causes and origins are categories, which take less memory.
        """
        file = f"{name}.csv"
        table = _table(self.path / file, columns, self.manifest.get("tables", {}).get(file))
        if name in ("events", "agents"):
            _check_rows(self.path / file, table, self.manifest.get("species"))
        return _categorised(table, categories)

    def to_newick(self) -> str:
        """Returns the phylogeny in Newick format for ape and ggtree, one tree per line for each founder or random newcomer. Branch lengths are
        times between births in seconds; a terminal branch ends with the individual's death, or with the run. Raises RunError if an individual has
        several parents, which Newick cannot have.
        """
        tree = self.phylogeny
        several = tree[tree.ancestor_list.str.contains(",")]
        if not several.empty:
            raise RunError(
                f"{self.path / 'phylogeny.csv'}: id {several.id.iloc[0]}: ancestor_list = {several.ancestor_list.iloc[0]}: must be at most one "
                "parent, because Newick trees have no second parent"
            )
        return _newick(tree)

    def show(self, out: str | os.PathLike | None = None):
        """Makes a page of the run (`trophic show`), which a notebook displays; `out` is a new file for it."""
        if not (self.path / "replay.trp").exists():
            raise RunError(f"{self.path}: has no recording, replay.trp")
        return programs.show(self.path, out)

    def add_table(self, name: str, frame: pandas.DataFrame) -> pathlib.Path:
        """Writes an own table, NAME.csv, into the run's folder, for `trophic analyze --column NAME.csv:COLUMN`. Raises RunError if it exists."""
        path = self.path / f"{name}.csv"
        from .writing import write_new

        write_new(path, frame.to_csv(index=False, lineterminator="\n", na_rep="nan"))
        return path

    def _repr_html_(self) -> str:
        one = description.describe(Runs(self.path, [self]))
        return description.card(
            str(self.path),
            {**one.facts(), "seed": self.seed, "status": self.manifest["status"], **self.manifest.get("result", {})},
        )

    @functools.cached_property
    def events(self) -> pandas.DataFrame:
        """Births, activations, tag switches, catches and deaths, one per row."""
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
        """Contacts of every robot, and inputs and outputs of its brain, for a run with --senses. `inputs` names input0, input1, ..."""
        return self.table("senses")

    @functools.cached_property
    def states(self) -> pandas.DataFrame:
        """States of rules for every robot, for a run with --states: a column SLOT.MEMBER for each member of each State."""
        return self.table("states")

    @property
    def inputs(self) -> list[str]:
        """The names of the sensors input0, input1, ... of `senses`. Raises KeyError for a run without that table."""
        return self.manifest["senses"]["inputs"]


@dataclasses.dataclass(frozen=True)
class Runs:
    """Replicates, which are runs that differ only in their seeds, and the runs of their nulls, if there are any."""

    path: pathlib.Path
    runs: list[Run] = dataclasses.field(repr=False)
    shadow: "Runs | None" = None
    neutral: "Runs | None" = None
    one_sided: "dict[str, Runs]" = dataclasses.field(default_factory=dict)
    """by species: the worlds in which it alone inherits nothing"""
    planned: int = 0
    """how many runs replicates.json lists; 0 without it"""

    @property
    def nulls(self) -> "dict[str, Runs]":
        """The existing nulls, by the names of their folders."""
        one_sided = {one_sided_name(species): of for species, of in self.one_sided.items()}
        return {
            name: of
            for name, of in {"shadow": self.shadow, **one_sided, "neutral": self.neutral}.items()
            if of is not None
        }

    def __len__(self) -> int:
        return len(self.runs)

    def __iter__(self):
        return iter(self.runs)

    def __getitem__(self, index: int) -> Run:
        return self.runs[index]

    def table(self, name: str, columns: list[str] | None = None, *, categories: bool = False) -> pandas.DataFrame:
        """Reads a table of all runs, with the columns `run` (the folder's name) and `seed` in front."""
        tables = []
        for run in self.runs:
            table = run.table(name, columns)
            table.insert(0, "run", run.path.name)
            table.insert(1, "seed", run.seed)
            tables.append(table)
        return _categorised(pandas.concat(tables, ignore_index=True), categories)

    def measure(self, name: str, function) -> None:
        """Computes your own metric: writes NAME.csv into the folder of each run and of its nulls, for `trophic analyze --column NAME.csv:NAME`.

        `function` takes a Run and returns a number, or a frame with the column NAME and optionally time_s, species and group. nan means that the
        value cannot be computed. Raises RunError, naming the run, if the function raises, returns something else or the file exists; then
        nothing is written.
        """
        tables = []
        for run in [*self.runs, *itertools.chain(*self.nulls.values())]:
            if (run.path / f"{name}.csv").exists():
                raise RunError(f"{run.path / name}.csv: exists already; files are never overwritten")
            try:
                value = function(run)
            except Exception as error:
                raise RunError(f"{run.path}: {name}: {type(error).__name__}: {error}") from error
            if not isinstance(value, pandas.DataFrame):
                try:
                    value = pandas.DataFrame({name: [float(value)]})
                except (TypeError, ValueError):
                    raise RunError(
                        f"{run.path}: {name}: must return a number or a frame, not {type(value).__name__}"
                    ) from None
            if name not in value.columns:
                raise RunError(f"{run.path}: {name}: the frame has no column {name}")
            tables.append((run, value))
        for run, value in tables:
            run.add_table(name, value)

    def _repr_html_(self) -> str:
        return description.card(str(self.path), description.describe(self).facts())


@dataclasses.dataclass(frozen=True)
class Analysis:
    """Results of `trophic analyze`, as `trophic.analyze` returns and `read_analysis` reads them."""

    path: pathlib.Path | None
    """The folder of the tables; None for an analysis in memory."""
    metrics: pandas.DataFrame = dataclasses.field(repr=False)
    """metrics.csv: every value and every curve of every run, one value a row."""
    summary: dict = dataclasses.field(repr=False)
    """summary.json: means, intervals, test results and findings of each set."""

    @functools.cached_property
    def means(self) -> pandas.DataFrame:
        """means.csv: each metric with each of its nulls."""
        return _table(self._file("means.csv"))

    @functools.cached_property
    def differences(self) -> pandas.DataFrame:
        """differences.csv of two compared sets. Raises RunError for an analysis of one set."""
        return _table(self._file("differences.csv"))

    @property
    def findings(self) -> list[str]:
        """The findings in sentences, each fact once and the paper's questions first."""
        return [finding["sentence"] for finding in self.summary["findings"]]

    def _file(self, name: str) -> pathlib.Path:
        if self.path is None:
            raise RunError(f"{name}: this analysis has no such table")
        return self.path / name

    def _repr_html_(self) -> str:
        sets = {one["set"]: one["description"] for one in self.summary["sets"]}
        sentences = [*self.findings, self.summary["family"]["sentence"]]
        return (
            description.card(str(self.path or "analysis"), sets)
            + "<ul>"
            + "".join(f"<li>{html.escape(one)}</li>" for one in sentences)
            + "</ul>"
        )


def read_run(path: str | os.PathLike) -> Run:
    """Reads the run in this folder. Raises RunError if it is not one."""
    path = pathlib.Path(path)
    if not (path / "manifest.json").exists():
        raise RunError(f"{path}: is not a run: it has no manifest.json")
    manifest = sealed(path / "manifest.json")
    kinds = {"status": str, "seed": int, "fingerprint": str, "rule_table": str}
    if any(type(manifest.get(key)) is not kind for key, kind in kinds.items()):
        raise RunError(f"{path}/manifest.json: not a run's")
    return Run(path, manifest)


def read_runs(path: str | os.PathLike, *, incomplete: bool = False, accept_other_build: bool = False) -> Runs:
    """Reads the replicates in this folder, in order, and those of its nulls. `incomplete` includes incomplete ones.

    Raises RunError for a folder without replicates, for runs with different fingerprints, which are not replicates, and, unless
    `accept_other_build`, for runs of different builds of a program, whose rules may have the same names but other code.
    """
    path = pathlib.Path(path)
    numbered = {folder.name.removeprefix("replicate-"): folder for folder in path.glob("replicate-*")}
    folders = [numbered[number] for number in sorted(filter(str.isdigit, numbered), key=int)]
    runs = [
        run
        for folder in folders
        if (folder / "manifest.json").exists() and ((run := read_run(folder)).complete or incomplete)
    ]
    if not runs:
        raise RunError(f"{path}: no {'' if incomplete else 'complete '}replicates")
    identities = {run.identity for run in runs}
    if len(identities) > 1:
        raise RunError(f"{path}: runs with different fingerprints: {', '.join(sorted(identities))}")
    builds = {tuple(run.builds) for run in runs}
    if len(builds) > 1 and not accept_other_build:
        raise RunError(
            f"{path}: made by different builds: {', '.join(' and '.join(each) or 'unknown' for each in sorted(builds))}; "
            "accept_other_build=True reads them"
        )
    nulls = {
        name: read_runs(path / name, incomplete=incomplete, accept_other_build=accept_other_build)
        for name in ("shadow", "neutral", *map(one_sided_name, runs[0].manifest.get("species", [])))
        if (path / name).is_dir()
    }
    shadow, neutral = nulls.pop("shadow", None), nulls.pop("neutral", None)
    one_sided = {one_sided_species(name): of for name, of in nulls.items()}
    return Runs(path, runs, shadow, neutral, one_sided, len(listed(path) or runs))


def listed(path: pathlib.Path) -> list[str] | None:
    """The folders that replicates.json lists in a folder; None without that file. Raises RunError for a broken list."""
    listing = path / "replicates.json"
    if not listing.exists():
        return None
    try:
        names = [replicate["folder"] for replicate in sealed(listing)["replicates"]]
    except (TypeError, KeyError):
        raise RunError(f"{listing}: replicates: must be a list of folders, as trophic writes it") from None
    for name in names:
        if not isinstance(name, str) or any(ord(letter) < 32 or 127 <= ord(letter) < 160 for letter in name):
            raise RunError(f"{listing}: folder = {json.dumps(name)}: must be text without control characters")
        if pathlib.PurePath(name).name != name or name in ("", ".."):
            raise RunError(f"{listing}: folder = {name}: must be the name of a folder next to it")
    return names


def _is_null(folder: str) -> bool:
    return folder in ("shadow", "neutral", "clones") or one_sided_species(folder) != ""


def read_study(
    path: str | os.PathLike, *, incomplete: bool = False, accept_other_build: bool = False
) -> dict[str, Runs]:
    """Reads every set of runs below this folder, by its path from there: a sweep."""
    path = pathlib.Path(path)
    folders = sorted(file.parent for file in path.rglob("replicates.json") if not _is_null(file.parent.name))
    if not folders:
        raise RunError(f"{path}: contains no set of runs (replicates.json)")
    return {
        str(folder.relative_to(path)): read_runs(folder, incomplete=incomplete, accept_other_build=accept_other_build)
        for folder in folders
    }


def read_analysis(path: str | os.PathLike) -> Analysis:
    """Reads the folder of `trophic analyze --out`. Raises RunError if it is not one."""
    path = pathlib.Path(path)
    try:
        return Analysis(
            path, _table(path / "metrics.csv"), json.loads((path / "summary.json").read_text(encoding="utf-8"))
        )
    except (FileNotFoundError, json.JSONDecodeError, pandas.errors.ParserError, KeyError, RunError) as error:
        raise RunError(f"{path}: not what trophic analyze writes: {error}") from None


def verify(path: str | os.PathLike, loaded: Sequence[str] = ()) -> None:
    """Compares a run's manifest, tables, recording and checkpoint with their checksums. Raises RunError, naming the file, for the first one that
    differs from what the run wrote. A killed run has no checksums of tables. `loaded`: tables that were compared when they were read.
    """
    run = read_run(path)
    try:
        for name, expected in run.manifest.get("tables", {}).items():
            if name in loaded:
                continue
            check_sum(run.path / name, content(run.path / name), expected)
        if "recording" in run.manifest:
            recording, expected = (run.path / "replay.trp", run.manifest["recording"]["crc32"])
            if (found := _sum_of(recording)) != expected:
                raise RunError(
                    f"{recording}: has checksum {found}: must be {expected}, as its manifest says; the recording was cut or modified after the run"
                )
    except (AttributeError, KeyError, TypeError):
        raise RunError(f"{run.path}/manifest.json: tables, recording: must be as trophic writes them") from None
    if run.complete and "format" in run.manifest and (run.path / "checkpoint.bin").exists():
        _check_checkpoint(run)


def _check_checkpoint(run: Run) -> None:
    """Raises RunError unless checkpoint.bin is complete and belongs to the run of the manifest."""
    path = run.path / "checkpoint.bin"
    with _opened(path) as file:
        whole = file.read(_PIECE)  # has the texts at the beginning
        size = file.seek(0, os.SEEK_END)
        file.seek(max(0, size - 4))
        last = file.read()
    if not whole.startswith(b"trophic checkpoint\n") or _sum_of(path, size - 4) != int.from_bytes(last, "little"):
        raise RunError(
            f"{path}: is cut short or damaged: its checksum differs; without this file the run can be read but not resumed"
        )
    at = whole.find(b"\n") + 5  # after the first line and the version of the format
    texts = []
    for _ in range(3):  # fingerprint, version and code of the program
        length = int.from_bytes(whole[at : at + 8], "little")
        texts.append(whole[at + 8 : at + 8 + length].decode(errors="replace"))
        at += 8 + length
    if (texts[0], seed := int.from_bytes(whole[at : at + 8], "little")) != (run.fingerprint, run.seed):
        raise RunError(
            f"{path}: is of fingerprint {texts[0]}, seed {seed}: must be of {run.fingerprint}, {run.seed}, as manifest.json"
        )


def sealed(path: pathlib.Path) -> dict:
    """Reads a JSON object that trophic wrote with its own checksum as the last entry. Raises RunError if it was modified since. An object
    without `format` and `crc32` is from an older program and is accepted unchecked."""
    whole = content(path, 1 << 28)
    try:
        value = json.loads(whole.decode())
    except (ValueError, RecursionError):
        value = None
    if not isinstance(value, dict):
        raise RunError(f"{path}: is not a JSON object")
    if "format" in value or "crc32" in value:
        body, _, end = whole.rpartition(b',\n  "crc32": ')
        if end != b"%d\n}\n" % zlib.crc32(body):
            raise RunError(f"{path}: was cut short or modified after trophic wrote it: its checksum differs")
    return value


_PIECE = 1 << 20  # bytes that are read at a time


@contextlib.contextmanager
def _opened(path: pathlib.Path) -> Iterator[BinaryIO]:
    """A file to be read. Raises RunError if it cannot be, or if it is a pipe, on which reading would wait."""
    try:
        if path.exists() and not path.is_file():
            raise RunError(f"{path}: is not a regular file")
        with path.open("rb") as file:
            yield file
    except OSError as error:
        raise RunError(f"{path}: cannot be read: {error.strerror}") from None


def _sum_of(path: pathlib.Path, size: int | None = None) -> int:
    """The checksum of the first `size` bytes of a file, or of all of them, in the memory of a piece."""
    found, left = 0, float("inf") if size is None else size
    with _opened(path) as file:
        while left > 0 and (piece := file.read(int(min(_PIECE, left)))):
            found, left = zlib.crc32(piece, found), left - len(piece)
    return found


def content(path: pathlib.Path, most: int | None = None) -> bytes:
    """Reads a whole file. Raises RunError if it cannot be read, if it is a pipe, on which reading would wait, or if it has more bytes than `most`."""
    with _opened(path) as file:
        if most is not None and (size := os.fstat(file.fileno()).st_size) > most:
            raise RunError(f"{path}: has {size} bytes: must be <= {most}")
        return file.read()


def _check_rows(path: pathlib.Path, table: pandas.DataFrame, species: list[str] | None) -> None:
    """Raises RunError for a number that is not finite or beyond 1e60, and for a species that the manifest does not name."""
    for column in table.columns if len(table) > 0 else ():
        if column == "species" and species is not None:
            if unknown := sorted(set(table[column]) - set(species)):
                raise RunError(f"{path}: species = {unknown[0]!r}: must be a species of the run's manifest")
        elif column not in _TEXT:
            _check_numbers(path, table[column])


def _check_numbers(path: pathlib.Path, column: pandas.Series) -> None:
    if not pandas.api.types.is_numeric_dtype(column) or column.abs().max() > MOST_NUMBER:
        raise RunError(f"{path}: {column.name}: must be finite numbers, >= -1e60 and <= 1e60")


def check_sum(path: pathlib.Path, whole: bytes, expected: dict) -> None:
    """Raises RunError for a table that does not have the rows and the checksum that its run's manifest lists."""
    lines = int(numpy.count_nonzero(numpy.frombuffer(whole, numpy.uint8) == 10))  # ten times as fast as bytes.count
    found = {"rows": max(0, lines - 1), "crc32": zlib.crc32(whole)}
    if found != {"rows": expected["rows"], "crc32": expected["crc32"]}:
        raise RunError(
            f"{path}: has {found['rows']} rows and checksum {found['crc32']}: must be {expected['rows']} and {expected['crc32']}, as its "
            "manifest says; the table was cut or modified after the run"
        )


def whole_lines(path: pathlib.Path, expected: dict | None, whole: bytes | None = None) -> bytes:
    """The lines of a table without the incomplete last one of a killed program. Raises RunError if it was changed, or is not a table. `whole`:
    the file's bytes, if they were read. A table with the checksum that the manifest lists is as the program wrote it; the lines of any other are checked.
    """
    whole = content(path) if whole is None else whole
    if expected is not None:
        check_sum(path, whole, expected)
    lines = whole[: whole.rfind(b"\n") + 1]
    if lines.startswith(b"\xef\xbb\xbf"):
        raise RunError(f"{path}:1: begins with a byte order mark; another kind of file?")
    if not lines:
        raise RunError(f"{path}: has no header")
    names = lines[: lines.index(b"\n")].split(b",")
    commas = len(names) - 1
    if twice := [name.decode(errors="replace") for place, name in enumerate(names) if name in names[:place]]:
        raise RunError(f"{path}:1: column {twice[0][:100]!r}: must be there once")
    for number, line in enumerate(lines[:-1].split(b"\n") if expected is None else (), 1):
        cells = line if b'"' not in line else b"".join(line.split(b'"')[::2])  # commas in quotes separate nothing
        if cells.count(b",") != commas:
            raise RunError(f"{path}:{number}: {cells.count(b',') + 1} cells, the header has {commas + 1}")
    return lines


def check_header(path: pathlib.Path, content: bytes, columns: Iterable[str]) -> list[str]:
    """The names in the header of a table. Raises RunError if one of `columns` is missing."""
    header = content[: content.index(b"\n")].decode(errors="replace").rstrip("\r").split(",")
    for name in columns:
        if name not in header:
            raise RunError(f'{path}:1: no column "{name}"; another kind of file?')
    return header


def _table(path: pathlib.Path, columns: list[str] | None = None, expected: dict | None = None) -> pandas.DataFrame:
    lines = whole_lines(path, expected)
    check_header(path, lines, columns or ())
    header = pandas.read_csv(io.BytesIO(lines), nrows=0).columns
    texts = {name: str for name in header if name in _TEXT or name == "run"}
    numbers = {name: [""] for name in header if name not in texts}
    table = pandas.read_csv(
        io.BytesIO(lines),
        usecols=columns,
        dtype=texts,
        keep_default_na=False,
        na_values=numbers,
        float_precision="round_trip",
    )  # else the last bit of a number may be another
    if (
        "tick" in table
        and len(table) > 0
        and not (pandas.api.types.is_numeric_dtype(table["tick"]) and table["tick"].is_monotonic_increasing)
    ):
        raise RunError(f"{path}: tick: must be >= that of the row before")
    if "time_s" in table and len(table) > 0:
        _check_numbers(path, table["time_s"])
    return table


def study_frames(study: Runs | dict[str, Runs], name: str) -> Iterator[pandas.DataFrame]:
    """Yields a table of every run of replicates, or of a study as read_study returns it, and of its nulls, with the columns set, null, run
    and seed in front; `null` is "none" or the name of the null's folder.

    All frames have the same columns of the same types, so they can be written one after another into one file. A column that a run lacks,
    such as the weights of a larger brain, is empty there. Raises RunError, naming the file, for a run without the table.
    """
    sets = study if isinstance(study, dict) else {study.path.name: study}
    runs = [
        (label, null, run)
        for label, of in sets.items()
        for null, part in {"none": of, **of.nulls}.items()
        for run in part
    ]
    types: dict[str, str] = {}
    for _, _, run in runs:
        for column, its_type in _types(run, name).items():
            types[column] = max(types.get(column, ""), its_type, key=("", "int64", "float64", "object").index)
    for label, null, run in runs:
        frame = run.table(name).reindex(columns=list(types))
        for column, its_type in types.items():
            frame[column] = (
                frame[column].fillna("").astype(str) if its_type == "object" else frame[column].astype(its_type)
            )
        for place, (column, value, its_type) in enumerate(
            (
                ("set", label, "object"),
                ("null", null, "object"),
                ("run", run.path.name, "object"),
                ("seed", run.seed, "uint64"),
            )
        ):
            frame.insert(place, column, pandas.Series(value, index=frame.index, dtype=its_type))
        yield frame


def _types(run: Run, name: str) -> dict[str, str]:
    """The type of each column of a table, the same for all runs that have it. The cells of an own table decide."""
    if name in TABLES and name != "states":
        path = run.path / f"{name}.csv"
        try:
            with path.open(encoding="utf-8", errors="replace") as file:
                header = file.readline().rstrip("\n").split(",")
        except OSError as error:
            raise RunError(f"{path}: cannot be read: {error.strerror}") from None
        return {
            column: "object" if column in _TEXT else "int64" if column in _WHOLE else "float64" for column in header
        }
    return {column: "object" if dtype == object else "float64" for column, dtype in run.table(name).dtypes.items()}


def to_parquet(
    study: Runs | dict[str, Runs],
    folder: str | os.PathLike,
    names: tuple[str, ...] = ("events", "agents", "phylogeny", "genomes"),
) -> list[pathlib.Path]:
    """Writes the tables of replicates or of a study, as study_frames yields them, into few files: FOLDER/events.parquet and so on. Returns their
    paths. The folder must be new; it appears under its name when it is complete. Needs pyarrow.
    """
    folder = pathlib.Path(folder)
    if folder.exists():
        raise RunError(f"{folder}: exists already; files are never overwritten")
    try:
        import pyarrow
        import pyarrow.parquet
    except ModuleNotFoundError:
        raise RunError("to_parquet: needs the Python module pyarrow: pip install pyarrow") from None
    part = folder.with_name(folder.name + ".part")
    shutil.rmtree(part, ignore_errors=True)
    part.mkdir(parents=True)
    for name in names:
        writer = None
        try:
            for frame in study_frames(study, name):
                schema = pyarrow.schema(
                    [
                        (column, pyarrow.string() if dtype == object else pyarrow.from_numpy_dtype(dtype))
                        for column, dtype in frame.dtypes.items()
                    ]
                )
                writer = writer or pyarrow.parquet.ParquetWriter(part / f"{name}.parquet", schema)
                writer.write_table(pyarrow.Table.from_pandas(frame, schema=schema, preserve_index=False))
        finally:
            if writer is not None:
                writer.close()
    part.rename(folder)
    return [folder / f"{name}.parquet" for name in names]


def _categorised(frame: pandas.DataFrame, categories: bool) -> pandas.DataFrame:
    if not categories:
        return frame
    return frame.astype({column: "category" for column in frame.columns if column in _CATEGORIES})


def first_parents(tree: pandas.DataFrame) -> pandas.Series:
    """Of each individual of a phylogeny.csv, by its ancestor_list; <NA> without a parent."""
    return tree.ancestor_list.str.extract(r"\[(\d+)", expand=False).astype("Int64")


def _newick(tree: pandas.DataFrame) -> str:
    """Each individual is a node at its birth; below it its offspring in order of birth and the end of its own life, a leaf."""
    born = dict(zip(tree.id, tree.origin_time))
    ends = tree.destruction_time.replace(float("inf"), float("nan"))
    last_s = max(ends.max() if ends.notna().any() else 0.0, tree.origin_time.max())
    died = dict(zip(tree.id, ends.fillna(last_s)))
    parents = dict(zip(tree.id, first_parents(tree)))
    children: dict = {}
    roots = []
    for child, parent in parents.items():
        if parent not in born:
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
