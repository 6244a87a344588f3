# SPDX-License-Identifier: MIT
"""The one description of a set of runs: rule table, parameters, changes during the run, branch, engine, builds, replicates, length, nulls.

The program writes what it knows of a run's rules into the manifest (`identity`, `description`); terminal, page, tables and `trophic cite` print
what stands here."""
from __future__ import annotations

import dataclasses
import html
import pathlib
import zlib
from typing import Any, NamedTuple, Protocol, Sequence

import pandas

from .errors import printable


class Parameter(NamedTuple):
    """A parameter that is not the rule table's."""

    path: str
    value: str
    table: str
    """The table's own value."""


class Change(NamedTuple):
    """A parameter that another value replaced during the run."""

    time_s: float
    number: str
    value: str
    before: str


class SetOfRuns(Protocol):
    """`trophic.runs.Runs` and `trophic.values.MeasuredSet`."""

    @property
    def runs(self) -> Sequence[Any]:
        ...

    @property
    def shadow(self) -> Any:
        ...

    @property
    def neutral(self) -> Any:
        ...

    @property
    def one_sided(self) -> dict[str, Any]:
        ...

    @property
    def planned(self) -> int:
        ...


@dataclasses.dataclass(frozen=True)
class Description:
    """A set of runs; `describe` makes it."""

    label: str
    """Short name of the rules: the rule table, with what differs from it in brackets. The `set` of tables."""
    rules: str
    """The same as a part of a sentence: "rule table `paper` and its parameters"."""
    table: str
    engine: str
    parameters: tuple[Parameter, ...]
    changes: tuple[Change, ...]
    begins: str
    """"at 700 s of runs/a (seed 7)"; empty for runs from time 0."""
    identity: str
    """The fingerprint, which a suffix follows if parameters changed during the run or it began from another one."""
    builds: tuple[str, ...]
    """Codes of the programs that made the runs."""
    versions: tuple[str, ...]
    replicates: int
    planned: int
    """How many runs the lists of their folders name (replicates.json)."""
    nulls: dict[str, int]
    """How many runs of each null there are, by its name in a sentence: "shadow", "one-sided world of prey"."""
    until_s: float
    """Simulated time that is measured, s; less in a run that lived less."""
    whole_s: float
    """Simulated time that was planned, s."""
    lived_s: tuple[float, float]
    """The least and the most simulated time that a run lived, s."""
    ends: tuple[str, ...]
    """How runs ended that did not live as long as planned, a text for each kind: "stopped", "2 ended early, by ecology.ends_when"."""

    def title(self) -> str:
        """ "paper on kinematic 1"."""
        return f"{self.label} on {self.engine}"

    def length(self) -> str:
        """ "10 runs of 6000 s", "A run of 20 s", "4 of 10 planned runs of 150 to 6000 s (1 stopped; 6000 s planned)"."""
        runs = f"{self.replicates} runs" if self.replicates > 1 else "A run"
        if self.planned > self.replicates:
            runs = f"{self.replicates} of {self.planned} planned runs"
        lived = " to ".join(f"{time_s:.10g}" for time_s in dict.fromkeys(self.lived_s))
        cut = f"the first {self.until_s:.10g} of " if self.until_s < self.lived_s[1] else ""
        ends = f" ({', '.join(self.ends)}; {self.whole_s:.10g} s planned)" if self.ends else ""
        return f"{runs} of {cut}{lived} s{ends}"

    def sentence(self, made: str = "") -> str:
        """One sentence; `made`: what comes behind the engine, such as version and seed."""
        builds = f"; {len(self.builds)} builds of the program made them" if len(self.builds) > 1 else ""
        return f"{self.length()} on {self.engine}{made and ' '}{made}, with the {self.rules}{builds}."

    def facts(self) -> dict[str, str]:
        """(what, which) for cards and pages."""
        nulls = [f", {count} of the {title}" for title, count in self.nulls.items()]
        facts = {"runs": self.length() + "".join(nulls), "rules": self.rules, "engine": self.engine}
        facts["fingerprint"] = self.identity
        facts[
            "program"
        ] = f"trophic {', '.join(self.versions)}, {'builds' if len(self.builds) > 1 else 'build'} {' and '.join(self.builds) or 'unknown'}"
        return facts


def _nulls(of: SetOfRuns) -> list[tuple[str, Any]]:
    one_sided = [(f"one-sided world of {species}", its) for species, its in of.one_sided.items()]
    return [("shadow", of.shadow), *one_sided, ("neutral null", of.neutral)]


def describe(of: SetOfRuns) -> Description:
    """Describes replicates, or one run as `Runs(path, [run])`. Runs with other rules than the first one are not looked at: `trophic.pool` refuses them."""
    first = of.runs[0]
    manifest = first.manifest
    said = manifest.get("description", {})
    changes = changes_of(first)
    begins = _begins(manifest)
    name, rules = said.get("name"), said.get("sentence")
    if name is None:  # made by a program that did not describe it
        parts = ([f"{len(changes)} change{'s'[: len(changes) != 1]}"] if changes else []) + (
            [f"from {manifest['origin']['at_s']} s"] if begins else []
        )
        name = manifest["rule_table"] + (f" ({'; '.join(parts)})" if parts else "")
        rules = f"rule table `{manifest['rule_table']}`" + "".join(
            f"; at {c.time_s:.10g} s {c.number} changes from {c.before} to {c.value}" for c in changes
        )
        rules += f"; begins {begins}" if begins else ""
    whole_s = float(manifest["clock"]["until_s"])
    until_s = float(getattr(of, "until_s", whole_s))
    lived = [lived_s(run) for run in of.runs]
    return Description(
        label=printable(name),
        rules=printable(rules),
        table=manifest["rule_table"],
        engine=manifest.get("backend", "unknown"),
        parameters=tuple(Parameter(one["path"], one["value"], one["table"]) for one in said.get("parameters", ())),
        changes=changes,
        begins=begins,
        identity=identity(first),
        builds=tuple(sorted({build for run in of.runs for build in run.builds})),
        versions=tuple(sorted({run.manifest.get("trophic", "unknown") for run in of.runs})),
        replicates=len(of.runs),
        planned=max(len(of.runs), of.planned),
        nulls={title: len(its.runs) for title, its in _nulls(of) if its},
        until_s=until_s,
        whole_s=whole_s,
        lived_s=(min(lived), max(lived)),
        ends=_ends(of.runs),
    )


def lived_s(run: Any) -> float:
    """Simulated time that a run lived, s: planned, if it reached its end, else where it ended; of a killed run that of the last row that it wrote."""
    manifest = run.manifest
    result = manifest.get("result", {})
    if manifest["status"] == "complete" and "ended" not in result:
        return float(manifest["clock"]["until_s"])
    if "reached_s" in result:
        return float(result["reached_s"])
    return max(map(_last_time, (run.path / "events.csv", run.path / "agents.csv")))


def _last_time(table: pathlib.Path) -> float:
    """The time of the last whole row of a table, whose first column is time_s; 0 without one."""
    try:
        with table.open("rb") as file:
            file.seek(max(0, file.seek(0, 2) - 10_000))
            return float(file.read().split(b"\n")[-2].split(b",")[0])
    except (OSError, IndexError, ValueError):
        return 0.0


_ENDS = {"running": "killed or still running"}


def _ends(runs: Sequence[Any]) -> tuple[str, ...]:
    kinds = []
    for run in runs:
        if (status := run.manifest["status"]) != "complete":
            kinds.append(_ENDS.get(status, status))
        elif "ended" in run.manifest.get("result", {}):
            kinds.append("ended early, by ecology.ends_when")
    return tuple(f"{kinds.count(one)} {one}" if len(runs) > 1 else one for one in dict.fromkeys(kinds))


def distinct(labels: Sequence[str]) -> list[str]:
    """The labels; those that several sets have are distinguished by (a), (b), ..."""
    return [
        label if list(labels).count(label) == 1 else f"{label} ({chr(ord('a') + list(labels[:i]).count(label))})"
        for i, label in enumerate(labels)
    ]


def identity(run: Any) -> str:
    """Name of a run's rules: its fingerprint, with a suffix if parameters changed during it or it began from another run. Runs are replicates if it is equal."""
    manifest = run.manifest
    if "identity" in manifest:
        return manifest["identity"]
    # The program's `identity` (trophic/observe/run_description.hpp), for runs made before manifests had it.
    origin = manifest.get("origin")
    text = f"{origin['at_s']} {origin['seed']} {origin['fingerprint']}\n" if origin else ""
    text += "".join(f"{row.tick} {row.number}={row.value}\n" for row in _effective(run).itertuples())
    return manifest["fingerprint"] + (f"+{zlib.crc32(text.encode()):08x}" if text else "")


def card(title: str, facts: dict[str, Any]) -> str:
    """A few facts as a small table for notebooks."""
    rows = "".join(
        f"<tr><td>{html.escape(str(name))}</td><td>{html.escape(str(value))}</td></tr>" for name, value in facts.items()
    )
    return f"<b>{html.escape(title)}</b><table>{rows}</table>"


def _begins(manifest: dict) -> str:
    origin = manifest.get("origin")
    return printable(f"at {origin['at_s']} s of {origin['run']} (seed {origin['seed']})") if origin else ""


def changes_of(run: Any) -> tuple[Change, ...]:
    """The changes of a run's parameters that had an effect, in the order of time."""
    said = run.manifest.get("description", {})
    if "changes" in said:
        return tuple(Change(one["time_s"], one["number"], one["value"], one["before"]) for one in said["changes"])
    return tuple(Change(row.time_s, row.number, row.value, row.before) for row in _effective(run).itertuples())


def _effective(run: Any) -> pandas.DataFrame:
    """The rows of changes.csv that had an effect: for each tick and parameter the last value, if it is not the first."""
    file = run.path / "changes.csv"
    if not file.exists():
        return pandas.DataFrame(columns=["time_s", "tick", "number", "value", "before"])
    rows = pandas.read_csv(file, dtype=str, keep_default_na=False).astype({"time_s": float, "tick": int})
    rows = rows.groupby(["tick", "number"], as_index=False).agg(
        time_s=("time_s", "first"), value=("value", "last"), before=("before", "first")
    )
    return rows[rows["value"] != rows["before"]]
