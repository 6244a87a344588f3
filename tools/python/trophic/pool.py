# SPDX-License-Identifier: MIT
"""Sets of runs: the folders that may be pooled, and why others may not; their nulls; and the tables of a run."""
from __future__ import annotations

import concurrent.futures
import dataclasses
import io
import json
import math
import multiprocessing
import os
import pathlib
import re
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import pandas

from . import metrics, runs
from .description import changes_of, describe, lived_s
from .errors import RunError, printable
from .metrics import Measuring, Web, bodies, kinds, own, walls
from .runs import Run
from .values import CLONES, MOST_NUMBER, NEUTRAL, SHADOW, MeasuredSet, RunValues, one_sided_name, one_sided_species
from .words import NO_NEUTRAL, excerpt, number_text

SHADOW_SLOT, POLICIES = "heredity", {SHADOW: "nothing_inherited", CLONES: "one_genome_for_all"}
"""The slot in which a table and its nulls differ, and the policies there; of the neutral null neutral_HEREDITY, of the one-sided world of a species
"HEREDITY, nothing_inherited for SPECIES"."""
MOST_TIME_S = 1e8
"""The longest run that is made and analysed: three years of its clock."""
_LONGEST_TICK_S = 3600.0  # a run's last tick may end after its duration, by less than this
_MOST_SPECIES = 1000
# The cells of events.csv and agents.csv.
_NAMES = {
    "event": ("birth", "activation", "tag_switch", "catch", "death"),
    "origin": ("random", "inherited"),
    "cause": ("", "caught", "starved", "sacrificed", "senescence", "diverged"),
}
_NUMBERS = ("time_s", "x_m", "y_m")
_OPTIONAL = ("victim_id", "parent_id", "adversary_id", "hunger_ticks")
_TYPES = {
    **dict.fromkeys(("time_s", "species", *_NAMES), "category"),
    **dict.fromkeys(("tick", "id", "body", "tag", "active"), "int64"),
}  # others: numbers


@dataclasses.dataclass(frozen=True)
class PooledRun(Run):
    """A run with a manifest that was checked. Its tables end at `until_s`."""

    until_s: float
    """s: planned, or where --until cuts it"""

    @property
    def web(self) -> Web:
        return Web(self.manifest["species"], [(link["hunter"], link["victim"]) for link in self.manifest["food_web"]])

    @property
    def floor(self) -> walls.Floor:
        return walls.Floor(float(self.manifest["arena"]["half_side_m"]), self.manifest["arena"].get("obstacles", ()))

    @property
    def every_ticks(self) -> int:
        """agents.csv has only ticks that are multiples of this."""
        return self.manifest.get("agents_every_ticks", 1)

    @property
    def tags(self) -> list[int]:
        """The tags that the rule table's brains may choose."""
        return self.manifest.get("tags", [-1, 1])

    @property
    def reached_s(self) -> float | None:
        """None for a run that was killed or is still running."""
        return self.manifest.get("result", {}).get("reached_s")

    @property
    def end_s(self) -> float | None:
        if self.manifest["status"] == "complete" and self.reached_s is None:
            return self.manifest["clock"]["until_s"]
        return self.reached_s

    @property
    def lived_s(self) -> float:
        """How much of `until_s` the run lasted: less if it ended early, by ecology.ends_when, a signal or a kill. No rate, window or half of a
        metric goes
        beyond it."""
        return min(self.until_s, lived_s(self))

    @property
    def begins(self) -> str:
        """ "at 700 s of runs/a (seed 7)" for a run that begins at a moment of another one, else empty."""
        origin = self.manifest.get("origin")
        return "" if origin is None else f"at {origin['at_s']} s of {printable(origin['run'])} (seed {origin['seed']})"

    def table(self, name: str, columns: list[str] | None = None, *, categories: bool = False) -> pandas.DataFrame:
        """As Run.table, without the rows after `until_s`, if the table has times."""
        table = super().table(name, columns, categories=categories)
        return table[table.time_s <= self.until_s] if "time_s" in table else table

    def load(self, file: str, columns: Sequence[str], remarks: list[str]) -> pandas.DataFrame:
        """Reads columns of events.csv or agents.csv up to `until_s`; the incomplete end that a killed program left goes, with a remark. A table
        whose checksum is in the manifest is what the program wrote; the cells of any other are checked. Raises RunError, naming file, line and
        column, for a cell that cannot be."""
        content, is_whole = self._lines(file, remarks)
        runs.check_header(self.path / file, content, [*columns, "tick"])
        if file in self.manifest.get("tables", {}):
            types = {name: _TYPES.get(name, "float64") for name in columns}
            # The parser is exact for at most 15 digits, which all numbers but times have; those are few, as texts.
            frame = _parsed(
                self.path / file,
                content,
                usecols=list(columns),
                dtype=types,
                float_precision="high",
                na_values={name: [""] for name in columns if types[name] == "float64"},
            )
            for name in columns:
                if types[name] == "float64" and (wrong := frame[name].abs() > MOST_NUMBER).any():
                    cell = number_text(frame[name][place := wrong.idxmax()])
                    raise RunError(f"{self.path / file}:{place + 2}: {name} = {cell}: must be >= -1e60 and <= 1e60")
            frame["time_s"] = self._times(file, frame.time_s)
        else:
            frame = _checked(
                self, file, _parsed(self.path / file, content, usecols=list({*columns, "tick"}), dtype=str)
            )
            if file == "agents.csv" and not is_whole and len(frame):
                frame = frame[frame.tick != frame.tick.iloc[-1]]
        return frame[frame.time_s <= self.until_s] if len(frame) and frame.time_s.iloc[-1] > self.until_s else frame

    def _times(self, file: str, texts: pandas.Series) -> pandas.Series:
        """Times as exact numbers. Raises RunError, naming the line, for a text that is not one."""
        try:
            return texts.astype("category").cat.rename_categories(float).astype(float)
        except ValueError:
            place = pandas.to_numeric(texts, errors="coerce").isna().idxmax()
            raise RunError(
                f'{self.path / file}:{place + 2}: time_s = "{excerpt(texts[place])}": must be a number'
            ) from None

    def texts(self, file: str, columns: Sequence[str], optional: Sequence[str], remarks: list[str]) -> pandas.DataFrame:
        """The cells of any table in the folder as texts: `columns`, and those of `optional` that it has."""
        content, _ = self._lines(file, remarks)
        header = runs.check_header(self.path / file, content, columns)
        return _parsed(self.path / file, content, usecols=[*columns, *(set(optional) & set(header))], dtype=str)

    def _lines(self, file: str, remarks: list[str]) -> tuple[bytes, bool]:
        path = self.path / file
        whole = runs.content(path)
        content = runs.whole_lines(path, self.manifest.get("tables", {}).get(file), whole)
        if len(content) < len(whole):
            remarks.append(
                f"{path}:{content.count(10) + 1}: truncated in the middle of a line (killed run?); all lines before it are used"
            )
        return content, len(content) == len(whole)


def read_set(
    paths: Iterable[str | os.PathLike], shadow: str | os.PathLike | None = None, how: Measuring | None = None
) -> MeasuredSet:
    """Reads and measures runs that may be pooled, and their nulls: the shadow named, or else what is in the folders PATH/shadow, the neutral
    null in PATH/neutral, the clones in PATH/clones and the one-sided worlds in PATH/one_sided_SPECIES.

    Raises RunError before anything is measured for runs that are not replicates, a null that is not theirs, an own column that a run lacks, a
    name that is taken, and a choice that names no metric; and for a run that cannot be read.
    """
    how = how or Measuring()
    folders = [pathlib.Path(path) for path in paths]
    (pooled, remarks), nulls = pooled_sets(folders, shadow, how)
    every = [*pooled, *(run for its_runs, _ in nulls.values() for run in its_runs)]
    shipped = metrics.names(pooled[0], how)
    inherited = metrics.inherited(shipped, how)
    if inherited and NEUTRAL not in nulls:
        remarks.append(f"{pooled[0].path}: {NO_NEUTRAL}")
    is_shipped = not how.bodies and not how.kinds and how.lineages is None
    if is_shipped and (lost := metrics.lost_to_thinning(pooled[0].every_ticks)):
        remarks.append(lost)
    for run in every:
        for column in how.columns:
            own.check_column(column, run)  # type: ignore[arg-type]
        if how.bodies:
            bodies.check(run)
        if how.kinds:
            kinds.check(run, how.kinds)
    metrics.check_names(shipped, how)
    if how.lineages is not None:
        from .metrics import lineages  # type: ignore[attr-defined]

        how = lineages.prepared(pooled, nulls.get(SHADOW, ([], []))[0], every, how)
    values = measure(every, how)
    metrics.same_metrics(values, how.metrics)
    rest = iter(values)

    def measured(these: list[PooledRun], remarks: list[str]) -> MeasuredSet:
        its = [next(rest) for _ in these]
        return MeasuredSet(
            "", list(these), its, None, these[0].until_s, [*remarks, *(remark for run in its for remark in run.remarks)]
        )

    found = measured(pooled, remarks)
    found.inherited, found.planned = inherited, sum(map(planned_in, folders))
    found.own = frozenset([*(one.name for one in how.functions), *(one.column for one in how.columns)])  # type: ignore[union-attr]
    for name, (its_runs, its_remarks) in nulls.items():
        if species := one_sided_species(name):
            found.one_sided[species] = measured(its_runs, its_remarks)
        else:
            setattr(found, name, measured(its_runs, its_remarks))
    for name, each in found.nulls.items():
        is_named = name == SHADOW and shadow is not None
        each.planned = sum(map(planned_in, [pathlib.Path(shadow)] if is_named else null_folders(folders, name)))  # type: ignore[arg-type]
    for each in (found, *found.nulls.values()):
        each.label = describe(found).label
    return found


def pooled_sets(
    paths: Iterable[str | os.PathLike], shadow: str | os.PathLike | None, how: Measuring
) -> tuple[tuple[list[PooledRun], list[str]], dict[str, tuple[list[PooledRun], list[str]]]]:
    """The runs of some folders, and those of their nulls by name, each with remarks. Raises RunError as `read_set`."""
    folders = [pathlib.Path(path) for path in paths]
    pooled, nulls = pooled_runs(folders, how), {}
    sides = map(one_sided_name, pooled[0][0].web.species)
    for name in (SHADOW, *sides, NEUTRAL, *([] if how.bodies or how.kinds or how.lineages else [CLONES])):
        its_folders = [pathlib.Path(shadow)] if name == SHADOW and shadow is not None else null_folders(folders, name)
        if its_folders:
            nulls[name] = pooled_runs(its_folders, how)
            _check_null(pooled[0], nulls[name][0], name, how)
    return pooled, nulls


def measure(
    of: Sequence[PooledRun], how: Measuring, keep: Callable[[RunValues], Any] = lambda values: values
) -> list[Any]:
    """Measures runs, several at a time in processes, with a line of progress on a terminal. Returns what `keep` keeps of each, all of it by
    default. Raises the RunError of the first run, in their order, that cannot be measured, and gives up the others.
    """
    shows = sys.stderr.isatty()

    def counted(found: Iterable[Any]) -> list[Any]:
        values = []
        for value in found:
            values.append(value)
            if shows:
                last = len(values) == len(of)
                print(
                    f"\r{'' if last else f'measured {len(values)} of {len(of)} runs'}\033[K",
                    end="",
                    file=sys.stderr,
                    flush=True,
                )
        return values

    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    jobs = min(how.jobs or cores, len(of))
    if jobs <= 1:
        return counted(keep(metrics.measure_run(run, how)) for run in of)
    # A forked process has the functions of a user, which need not be importable.
    executor = concurrent.futures.ProcessPoolExecutor(
        jobs, multiprocessing.get_context("fork"), _share, (of, how, keep)
    )
    try:
        return counted(executor.map(_measure_shared, range(len(of))))
    finally:
        executor.shutdown(wait=True, cancel_futures=True)


_shared: tuple[Sequence[PooledRun], Measuring, Callable[[RunValues], Any]]


def _share(*what: Any) -> None:
    global _shared
    _shared = what  # type: ignore[assignment]
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that waits for them ends them
    threading.Thread(target=lambda: (multiprocessing.parent_process().join(), os._exit(1)), daemon=True).start()  # type: ignore[union-attr]


def _measure_shared(place: int) -> Any:
    of, how, keep = _shared
    return keep(metrics.measure_run(of[place], how))


def pooled_runs(paths: Iterable[pathlib.Path], how: Measuring) -> tuple[list[PooledRun], list[str]]:
    """The runs of some folders, which may be pooled, and remarks. Raises RunError if they differ in fingerprint, build, beginning, changes,
    status, duration or the ticks in agents.csv, if one is given twice, if a manifest cannot be read, or if there is no run.
    """
    remarks: list[str] = []
    found: list[PooledRun] = []
    for folder in [folder for path in paths for folder in run_folders(path, remarks)]:
        run = read_pooled(folder)
        for other in found:
            if why := why_not_pooled(run, other, how.until_s is not None, how.accept_other_build):
                raise RunError(why)
        found.append(run)
    if not found:
        raise RunError(f"no runs found{': ' + remarks[0] if remarks else ''}")
    builds = sorted({build for run in found for build in run.builds})
    if len(builds) > 1:
        remarks.append(
            f"{len(builds)} different builds made these runs: {builds_text(builds)}; their rules may have the same names but other code"
        )
    if len(found) > 1 and found[0].begins:
        remarks.append(
            f"all runs begin {found[0].begins}: they share that past, so intervals cover its possible futures, not independent runs"
        )
    found = [run if how.until_s is None else _cut(run, how.until_s) for run in found]
    if early := sorted(
        run.lived_s for run in found if run.lived_s < run.until_s and "ended" in run.manifest.get("result", {})
    ):
        between = number_text(early[0]) + (f" to {number_text(early[-1])}" if early[-1] > early[0] else "")
        remarks.append(
            f"{len(early)} of {len(found)} runs ended early, by ecology.ends_when, after {between} s: metrics, windows and halves cover the "
            "time that each run lasted; persists omits the species that were alive at its end"
        )
    return found, remarks


def run_folders(path: pathlib.Path, remarks: list[str]) -> list[pathlib.Path]:
    """The folders of the runs that a path stands for: the path itself, or the replicates that its replicates.json lists. A listed folder that
    is missing gets a remark. Raises RunError for a path that is not a folder or a broken list.
    """
    if not path.is_dir():
        raise RunError(f"{path}: {'is not a folder' if path.exists() else 'does not exist'}")
    if (names := runs.listed(path)) is None:
        return [path]
    remarks += [
        f"{path / name}: is missing, because the replicate was not run" for name in names if not (path / name).is_dir()
    ]
    return [path / name for name in names if (path / name).is_dir()]


def planned_in(path: pathlib.Path) -> int:
    """How many runs a path stands for, those that are missing included."""
    return 1 if (names := runs.listed(path)) is None else len(names)


def read_pooled(folder: pathlib.Path) -> PooledRun:
    """Reads a run's manifest. Raises RunError "FILE: FIELD ..." for one that is not of a run that can be analysed."""
    path = folder / "manifest.json"
    if not path.exists():
        raise RunError(f"{path}: cannot be read: No such file or directory; is {folder} a run's folder?")
    run = runs.read_run(folder)
    manifest = run.manifest

    def refuse(what: str) -> None:
        raise RunError(f"{path}: {what}")

    def whole(value: Any, name: str, least: int, most: int) -> None:
        if type(value) is not int or not least <= value <= most:
            refuse(f"{name} = {json.dumps(value)}: must be a whole number from {least} to {most}")

    def number(section: str, name: str, least: float, most: float) -> None:
        value = manifest[section][name]
        if type(value) not in (int, float) or not least <= value <= most:
            refuse(
                f"{section}.{name} = {json.dumps(value)}: must be >= {number_text(least)} and <= {number_text(most)}"
            )

    def texts(of: list[dict], key: str, is_needed: bool = False) -> None:
        for value in [one[key] for one in of if is_needed or key in one]:
            if type(value) is not str:
                refuse(f"{key} = {json.dumps(value)}: must be text")

    # Those that may have a path, and are printed as such.
    free = ("command_line", "error", "origin", "description", "continued")
    if text := _not_plain({key: value for key, value in manifest.items() if key not in free}):
        refuse(f"{json.dumps(text)}: must be text without control characters")
    try:
        whole(manifest["seed"], "seed", 0, 2**64 - 1)
        texts([manifest], "backend", is_needed=True)
        number("clock", "until_s", 0.0, MOST_TIME_S)
        number("arena", "half_side_m", sys.float_info.min, sys.float_info.max)
        for one in manifest["arena"].get("obstacles", []):
            if not (
                isinstance(one, list)
                and len(one) == 6
                and all(isinstance(value, (int, float)) and math.isfinite(value) for value in one)
            ):
                refuse(f"arena.obstacles: {json.dumps(one)}: must be six numbers")
        if "result" in manifest:
            number("result", "reached_s", 0.0, MOST_TIME_S + _LONGEST_TICK_S)
        whole(manifest.get("agents_every_ticks", 1), "agents_every_ticks", 1, 2**63 - 1)
        species = manifest["species"]
        if (
            not isinstance(species, list)
            or len(species) > _MOST_SPECIES
            or not all(isinstance(name, str) for name in species)
        ):
            refuse(f"species: must be <= {_MOST_SPECIES} names")
        for link in manifest["food_web"]:
            for end in ("hunter", "victim"):
                if link[end] not in species:
                    refuse(f"food_web: {end} = {json.dumps(link[end])}: must be one of {', '.join(species)}")
        for tag in manifest.get("tags", []):
            whole(tag, "tags", -(2**31), 2**31 - 1)
        for file, expected in manifest.get("tables", {}).items():
            if pathlib.PurePath(file).name != file:
                refuse(f"tables: {file}: must be the name of a file")
            whole(expected["rows"], "rows", 0, 2**64 - 1)
            whole(expected["crc32"], "crc32", 0, 2**32 - 1)
        if "recording" in manifest:
            whole(manifest["recording"]["crc32"], "crc32", 0, 2**32 - 1)
        origin = [manifest["origin"]] if "origin" in manifest else []
        for key in ("at_s", "run", "seed", "fingerprint"):
            texts(origin, key, is_needed=True)
        texts([manifest, *origin, *manifest.get("continued", [])], "code")
    except (KeyError, TypeError, AttributeError) as error:
        refuse(
            f"{error}: is missing; trophic always writes it"
            if isinstance(error, KeyError)
            else f"is not what trophic writes: {error}"
        )
    return PooledRun(folder, manifest, manifest["clock"]["until_s"])


def why_not_pooled(run: PooledRun, other: PooledRun, is_cut: bool, any_build: bool = False) -> str:
    """Why two runs are not pooled, a sentence that names both; empty if they may be. `is_cut`: all will be cut to one duration. `any_build`:
    also runs that different builds of a program made."""
    here, there = f"{run.path}: ", other.path
    if run.fingerprint != other.fingerprint:

        def named(of: PooledRun) -> str:
            return f"{of.fingerprint} ({of.manifest['rule_table']} on {of.manifest['backend']})"

        return f"{here}fingerprint {named(run)}, but {there} has {named(other)}; runs with different rules or parameters are not pooled: use --compare"
    if run.builds != other.builds and not any_build:
        return f"{here}made by {builds_text(run.builds)}, but {there} by {builds_text(other.builds)}; rules may have the same names but other code in different builds: --accept-other-build pools them"
    if run.seed == other.seed:
        return f"{here}seed {run.seed} as in {there}; a run counts only once as a replicate"
    if run.begins != other.begins:
        begins, others = (f"begins {of.begins or 'at its beginning'}" for of in (run, other))
        return f"{here}{begins}, but {there} {others}; runs that share a past are not pooled with other runs"
    if run.identity != other.identity:
        return (
            f"{here}{len(changes_of(run))} changes of parameters (changes.csv), but {there} has {len(changes_of(other))}, or others; runs with "
            "different changes are not pooled"
        )
    if run.every_ticks != other.every_ticks:
        return f"{here}agents_every_ticks {run.every_ticks}, but {there} has {other.every_ticks}; runs with different detail in agents.csv are not pooled"
    if not is_cut and (run.manifest["status"] != other.manifest["status"] or not lasted_alike(run, other)):
        return f"{here}{lasted_text(run)}, but {there} has {lasted_text(other)}; runs of different length are not pooled: omit some, or cut all with --until"
    return ""


def check_apart(first: Sequence[Run], second: Sequence[Run]) -> None:
    """Raises RunError, naming both, for a run that is in both of two sets that are compared."""

    def kept(run: Run) -> tuple:
        tables = run.manifest.get("tables", {})
        return run.identity, run.seed, *sorted((name, one["crc32"]) for name, one in tables.items())

    for run in second:
        for other in first:
            is_copy = run.manifest.get("tables") and kept(run) == kept(other)
            if is_copy or run.path.resolve() == other.path.resolve():
                raise RunError(
                    f"{run.path}: must not be in both of the compared sets: it is the same run as {other.path}"
                )


def lasted_text(run: PooledRun) -> str:
    """How a run ended and when, of how much."""
    end = "an unknown time" if run.end_s is None else number_text(run.end_s)
    return f'status "{run.manifest["status"]}" at {end} of {number_text(run.until_s)} s'


def lasted_alike(a: PooledRun, b: PooledRun) -> bool:
    """Whether two runs are known to have lasted equally long, of the same time. A complete one may have ended early, by ecology.ends_when."""
    complete = a.manifest["status"] == b.manifest["status"] == "complete"
    return a.until_s == b.until_s and a.end_s is not None and (complete or a.end_s == b.end_s)


def builds_text(builds: Sequence[str]) -> str:
    """ "0aaa, 0bbb and 0ccc"; "an unknown build" if there is none."""
    return " and ".join(filter(None, [", ".join(builds[:-1]), *builds[-1:]])) or "an unknown build"


def null_folders(paths: Iterable[pathlib.Path], name: str = SHADOW) -> list[pathlib.Path]:
    """The folders PATH/NAME that exist, into which --shadow, --one-sided, --neutral and --clones put the nulls of these runs."""
    return [path / name for path in paths if (path / name).is_dir()]


def _check_null(runs: Sequence[PooledRun], null: Sequence[PooledRun], name: str, how: Measuring) -> None:
    check_shadow(runs[0], null[0], name=name)
    if runs[0].builds != null[0].builds and not how.accept_other_build:
        raise RunError(
            f"{null[0].path}: made by {builds_text(null[0].builds)}: must be made by {builds_text(runs[0].builds)}, as "
            f"{runs[0].path} (--accept-other-build takes it)"
        )
    if name == NEUTRAL and (others := [run for run in null if run.seed not in {run.seed for run in runs}]):
        raise RunError(f"{others[0].path}: seed {others[0].seed}: must be that of a run that it repeats")


def check_shadow(run: PooledRun, shadow: PooledRun, any_parent: bool = False, name: str = SHADOW) -> None:
    """Raises RunError, naming both runs and what differs, unless `shadow` is a run of the same rules, parameters, engine and duration with
    nothing inherited or, with the name of the neutral null, with its heredity. Seeds may differ. With `any_parent` the rule in slot parent may
    differ too: if nothing is inherited, it changes parents and labels, and no genome and no motion.
    """
    species = one_sided_species(name)

    def refuse(why: str) -> None:
        what = f"{'set of' if name == CLONES else 'neutral'} {name.replace(NEUTRAL, 'null')}"
        if species:
            what = f"one-sided world of {species}"
        raise RunError(f"{shadow.path}: is not a {what} of {run.path}: {why}")

    policy, own_policy = (one.manifest.get("rules", {}).get(SHADOW_SLOT, "unknown") for one in (shadow, run))
    wanted = POLICIES.get(name, f"{NEUTRAL}_{own_policy}")
    if species:
        wanted = f"{own_policy}, {POLICIES[SHADOW]} for {species}"
    if policy != wanted:
        refuse(f"its rule in slot {SHADOW_SLOT} is {policy}: must be {wanted}")
    free = {SHADOW_SLOT, "parent"} if any_parent else {SHADOW_SLOT}

    def rest(of: PooledRun) -> dict:
        params = {key: value for key, value in of.manifest.get("params", {}).items() if key != "seed"}
        if "rules" in params:
            params["rules"] = {slot: value for slot, value in params["rules"].items() if slot not in free}
        return {
            "backend": of.manifest["backend"],
            "params": params,
            "rules": {slot: rule for slot, rule in of.manifest.get("rules", {}).items() if slot not in free},
        }

    if why := first_difference(rest(run), rest(shadow)):
        refuse(why)
    if changes_of(run) != changes_of(shadow):
        refuse("its parameters change differently during the run (changes.csv)")
    if not lasted_alike(run, shadow):
        refuse(f"it has {lasted_text(shadow)}: must have {lasted_text(run)}")


def first_difference(a: dict, b: dict) -> str:
    """The first value in which two objects differ, as "KEY = THAT OF b: must be THAT OF a", a's keys first; empty if none does."""
    flat_a, flat_b = _flat(a), _flat(b)
    for key in [*flat_a, *flat_b]:
        here, there = flat_a.get(key, "missing"), flat_b.get(key, "missing")
        if here != there:
            return f"{key} = {there}: must be {here}"
    return ""


def _cut(run: PooledRun, until_s: float) -> PooledRun:
    reached_s = run.until_s if "ended" in run.manifest.get("result", {}) else run.reached_s
    if reached_s is None:
        times = run.load("agents.csv", metrics.AGENTS, [])["time_s"]
        reached_s = float(times.iloc[-1]) if len(times) else 0.0
    if reached_s < until_s:
        raise RunError(
            f"{run.path}: reached {number_text(reached_s)} s (status {run.manifest['status']}): must be >= {number_text(until_s)} s, as "
            "--until asks"
        )
    return dataclasses.replace(run, until_s=until_s)


def _flat(of: Any, at: str = "") -> dict[str, str]:
    if not isinstance(of, (dict, list)) or not of:
        return {at: json.dumps(of)}
    items = of.items() if isinstance(of, dict) else enumerate(of)
    return {
        key: value for name, part in items for key, value in _flat(part, f"{at}/{name}" if at else str(name)).items()
    }


def _is_plain(text: str) -> bool:
    return re.search("[\x00-\x1f\x7f-\x9f]", text) is None


def _not_plain(value: Any) -> str | None:
    """The first text with a control character in a value of a JSON file."""
    if isinstance(value, str):
        return None if _is_plain(value) else value
    parts = (
        [part for item in value.items() for part in item]
        if isinstance(value, dict)
        else value
        if isinstance(value, list)
        else []
    )
    return next((found for part in parts if (found := _not_plain(part)) is not None), None)


def _parsed(path: pathlib.Path, content: bytes, **how: Any) -> pandas.DataFrame:
    try:
        return pandas.read_csv(io.BytesIO(content), keep_default_na=False, **how)
    except (ValueError, OverflowError) as error:
        raise RunError(f"{path}: cannot be read: {error}") from None


def _checked(run: PooledRun, file: str, texts: pandas.DataFrame) -> pandas.DataFrame:
    """Texts of events.csv or agents.csv as numbers and names. Raises RunError for the first cell of a column that cannot be."""
    frame = pandas.DataFrame(index=texts.index)

    def refuse_first(wrong: pandas.Series, must: str) -> None:
        if wrong.any():
            place = wrong.idxmax()
            raise RunError(
                f'{run.path / file}:{place + 2}: {wrong.name} = "{excerpt(texts[wrong.name][place])}": must be {must}'
            )

    for name in texts:
        cells = texts[name]
        if name == "species":
            refuse_first(~cells.isin(run.web.species), "a species of the run's manifest")
        elif name in _NAMES:
            refuse_first(~cells.isin(_NAMES[name]), "one of the names that the program writes")
        elif name == "active":
            refuse_first(~cells.isin(["0", "1"]), "0 or 1")
        elif name in _NUMBERS:
            numbers = pandas.to_numeric(cells, errors="coerce")
            refuse_first(
                cells.str.lower().isin(["nan", "-nan", "inf", "-inf"]) | (numbers.abs() == float("inf")), "finite"
            )
            refuse_first(numbers.isna(), "a number")
            refuse_first((numbers.abs() > MOST_NUMBER) & (name != "time_s"), ">= -1e60 and <= 1e60")
        else:
            is_whole = cells.str.fullmatch(r"-?\d{1,18}" if name == "tag" else r"\d{1,18}")
            refuse_first(~(is_whole | ((cells == "") & (name in _OPTIONAL))), "a whole number in range")
        is_text = name == "species" or name in _NAMES
        frame[name] = (
            cells if is_text else cells.replace("", "nan").astype(float if name in _NUMBERS + _OPTIONAL else "int64")
        )
    refuse_first(~frame.time_s.between(0.0, MOST_TIME_S + _LONGEST_TICK_S), f">= 0 and <= {number_text(MOST_TIME_S)}")
    if file == "agents.csv":
        refuse_first(frame.tick % run.every_ticks != 0, f"a multiple of {run.every_ticks}, as its manifest says")
    refuse_first(frame.tick.diff() < 0, ">= that of the row before")
    return frame
