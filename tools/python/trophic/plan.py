# SPDX-License-Identifier: MIT
"""`trophic plan`: the list of runs that a sweep file describes, for `PROGRAM --plan FOLDER/plan.jsonl`.

A sweep file is TOML:

    rule_table = "paper"           # the program's first, if it is not given
    engine = "kinematic"           # the program's default
    replicates = 10                # runs of each cell
    seed = 1                       # the seeds of all runs follow from it
    paired = true                  # replicate k has the same seed in every cell
    shadow = false                 # each run's neutral shadow, too
    one_sided = false              # each run's one-sided worlds, too: for each species the one in which it alone inherits nothing
    replay_hz = 0.0                # frames of each run's recording in a simulated second: 0, 5, 10 or 30
    agents_every = 1               # each agents.csv has the ticks whose number is a multiple of it
    senses = false                 # each run's senses.csv, too
    states = false                 # each run's states.csv, too
    [set]                          # in every run
    ecology.duration_s = 3000.0
    [grid]                         # every value with every other; the last key changes fastest
    rules.capture.reach_m = [0.5, 1.0]
    [zip]                          # lists of one length: the first values together, then the second, ...
    rules.floor.floor = [6, 7]
    rules.minimum_predators.below = [6, 7]
    [[runs]]                       # settings that belong together
    rule_table = "released"

Keys are paths of parameters, rule_table and engine, in the order of the file."""
from __future__ import annotations

import contextlib
import dataclasses
import difflib
import itertools
import json
import math
import os
import pathlib
import re
import resource
import shlex
import shutil
import subprocess
import tempfile
import zlib
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy

from .programs import program_named
from .errors import RunError, printable
from .sweeps.grid import PLAN, read_plan
from .values import one_sided_name
from .words import number_text, one_line

DURATION = "ecology.duration_s"
MOST_RUNS = 1_000_000  # more are a typing error
STOPPED = 3  # the exit code after a signal
_STREAM_OF_REPLICATES = 9  # include/trophic/support/rng.hpp

Settings = dict[str, Any]
"""Values by the paths of their parameters, rule_table and engine."""


@dataclasses.dataclass
class Sweep:
    """A sweep file."""

    path: pathlib.Path
    text: str
    replicates: int = 10
    seed: int = 1
    paired: bool = True
    shadow: bool = False
    one_sided: bool = False
    replay_hz: float = 0.0
    agents_every: int = 1
    senses: bool = False
    states: bool = False
    set: Settings = dataclasses.field(default_factory=dict)
    grid: dict[str, list] = dataclasses.field(default_factory=dict)
    zip: dict[str, list] = dataclasses.field(default_factory=dict)
    runs: list[Settings] = dataclasses.field(default_factory=list)


# The file


def _json(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False)


def _leaves(table: Mapping[str, Any], prefix: str = "") -> Iterable[tuple[str, Any]]:
    for key, value in table.items():
        path = f"{prefix}.{key}" if prefix else key
        if isinstance(value, Mapping):
            yield from _leaves(value, path)
        else:
            yield path, _plain(value)


def _plain(value: Any) -> Any:
    """The same without numpy's types, as TOML has it."""
    if isinstance(value, (numpy.generic, numpy.ndarray)):
        value = value.tolist()
    return [_plain(one) for one in value] if isinstance(value, (list, tuple)) else value


def _value(value: Any, where: str) -> Any:
    if (
        isinstance(value, (bool, str))
        or type(value) is int
        and -(2**63) <= value < 2**63
        or isinstance(value, float)
        and math.isfinite(value)
    ):
        return value
    raise RunError(f"{where} = {value}: must be a finite number, a text, true or false")


def settings_of_table(table: Mapping[str, Any]) -> Settings:
    """The values of a table, flat or nested, by their paths. Raises RunError for one that no parameter can have."""
    return {path: _value(value, path) for path, value in _leaves(table)}


def _axes(table: dict[str, Any], section: str) -> dict[str, list]:
    axes = {}
    for path, values in _leaves(table):
        where = f"[{section}] {path}"
        if not isinstance(values, list):
            raise RunError(
                f"{where} = {values}: must be a list of values; values that are the same in all runs belong in [set]"
            )
        if not values:
            raise RunError(f"{where} = []: must have a value")
        axes[path] = [_value(value, where) for value in values]
    if not axes:
        raise RunError(f"[{section}]: is empty")
    return axes


def _whole(least: int, most: int):
    return (lambda value: type(value) is int and least <= value <= most), f"a whole number >= {least} and <= {most}"


_SWITCH = (lambda value: isinstance(value, bool)), "true or false"
_KEYS = {
    "replicates": _whole(1, MOST_RUNS),
    "seed": _whole(0, 2**53),
    "paired": _SWITCH,
    "shadow": _SWITCH,
    "one_sided": _SWITCH,
    "replay_hz": ((lambda value: type(value) in (int, float) and value in (0, 5, 10, 30)), "0, 5, 10 or 30"),
    "agents_every": _whole(1, 1_000_000),
    "senses": _SWITCH,
    "states": _SWITCH,
}
_CHOICES = ("rule_table", "engine")


def read_sweep(path: str | os.PathLike) -> Sweep:
    """Reads a sweep file. Raises RunError "FILE: ..." for a bad one: an unknown key, an axis without values, lists of [zip] of different lengths,
    a key in two places, no setting that varies, more than MOST_RUNS. The program checks the settings.
    """
    import tomllib  # of Python 3.11

    path = pathlib.Path(path)
    try:
        text = path.read_text(encoding="utf-8")
        return _sweep(path, text, tomllib.loads(text))
    except OSError as error:
        raise RunError(f"{path}: cannot be read: {error.strerror}") from None
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise RunError(f"{path}: is not TOML: {error}") from None
    except RunError as error:
        raise RunError(f"{path}: {error}") from None


def sweep_of(table: Mapping[str, Any]) -> Sweep:
    """The sweep of a dictionary that has the keys of a sweep file. Raises RunError "sweep: ..." for a bad one."""
    path = pathlib.Path("sweep")
    try:
        sweep = _sweep(path, "", {key: value if key == "runs" else _plain(value) for key, value in table.items()})
    except RunError as error:
        raise RunError(f"{path}: {error}") from None
    sections: list[tuple[str, Mapping]] = [
        ("", {key: value for key, value in table.items() if key != "runs" and not isinstance(value, Mapping)})
    ]
    sections += [(f"[{key}]", value) for key, value in table.items() if isinstance(value, Mapping)]
    sections += [("[[runs]]", one) for one in table.get("runs", [])]
    for title, values in sections:
        sweep.text += f"{title}\n" if title else ""
        sweep.text += "".join(f"{path} = {_json(value)}\n" for path, value in _leaves(values))
    return sweep


def _sweep(path: pathlib.Path, text: str, table: dict[str, Any]) -> Sweep:
    sweep = Sweep(path, text)
    for section in ("set", "grid", "zip"):
        if section in table and not isinstance(table[section], dict):
            raise RunError(f"{section}: must be a section, [{section}]")
    listed = table.pop("runs", None)
    if listed is not None and not (
        isinstance(listed, list) and listed and all(isinstance(one, dict) for one in listed)
    ):
        raise RunError("runs: must be sections, [[runs]]")
    sweep.set = settings_of_table(table.pop("set", {}))
    sweep.grid = _axes(table.pop("grid"), "grid") if "grid" in table else {}
    sweep.zip = _axes(table.pop("zip"), "zip") if "zip" in table else {}
    sweep.runs = [settings_of_table(one) for one in listed or []]
    if "neutral" in table:
        raise RunError("neutral: is not possible in a sweep; run a cell's settings with --replicates and --neutral")
    for key, value in table.items():
        if key in _CHOICES:
            if not isinstance(value, str):
                raise RunError(f"{key} = {value}: must be a text")
            if key in sweep.set:
                raise RunError(f"{key}: is given twice")
            sweep.set[key] = value
        elif key in _KEYS:
            is_right, must = _KEYS[key]
            if not is_right(value):
                raise RunError(f"{key} = {value}: must be {must}")
            setattr(sweep, key, value)
        else:
            known = ["set", "grid", "zip", "runs", *_CHOICES, *_KEYS]
            near = difflib.get_close_matches(key, known, 1)
            raise RunError(
                f"{f'[{key}]' if isinstance(value, dict) else key}: unknown key"
                + (f"; did you mean {near[0]}?" if near else f"; known here: {', '.join(known)}")
            )
    _check(sweep)
    return sweep


def _check(sweep: Sweep) -> None:
    if not (sweep.grid or sweep.zip or sweep.runs):
        raise RunError("has no [grid], [zip] or [[runs]], so nothing varies")
    seen: dict[str, str] = {}
    for section, keys in (
        ("[set]", sweep.set),
        ("[grid]", sweep.grid),
        ("[zip]", sweep.zip),
        *(("[[runs]]", run) for run in sweep.runs),
    ):
        for key in keys:
            other = seen.setdefault(key, section)
            if other != section:
                raise RunError(f"{key}: is in {other} and in {section}")
            if key in ("seed", "backend.threads"):
                raise RunError(f"{section} {key}: is not allowed in a sweep")
    for key, values in sweep.zip.items():
        first, of_first = next(iter(sweep.zip.items()))
        if len(values) != len(of_first):
            raise RunError(f"[zip] {key}: has {len(values)} values: must have {len(of_first)}, as {first}")
    rows = len(next(iter(sweep.zip.values()), [0]))
    if (
        sweep.replicates
        * (1 + sweep.shadow + 2 * sweep.one_sided)
        * max(1, len(sweep.runs))
        * rows
        * math.prod(map(len, sweep.grid.values()))
        > MOST_RUNS
    ):
        raise RunError(f"makes too many runs (cells x replicates): must be <= {MOST_RUNS}")


def cells_of(sweep: Sweep) -> list[Settings]:
    """The settings of each cell: [[runs]] x [zip] x [grid], the last key of [grid] fastest, each with those of [set]."""
    rows = [dict(zip(sweep.zip, values)) for values in zip(*sweep.zip.values())] or [{}]
    points = [dict(zip(sweep.grid, values)) for values in itertools.product(*sweep.grid.values())]
    return [
        {**sweep.set, **run, **row, **point} for run, row, point in itertools.product(sweep.runs or [{}], rows, points)
    ]


def settings_of(sweep: Sweep) -> list[Settings]:
    """The `settings` of the runs of each cell in the plan."""
    return [{key: value for key, value in cell.items() if key not in _CHOICES} for cell in cells_of(sweep)]


def text_of(cell: Settings, sweep: Sweep) -> str:
    """ "rules.capture.reach_m=0.5 rules.mutation.sd=0.1": those settings of a cell that are not in [set]."""
    return " ".join(
        f"{key}={value if isinstance(value, str) else _json(value)}"
        for key, value in cell.items()
        if key not in sweep.set
    )


# The plan

Line = dict[str, Any]
"""A line of plan.jsonl."""


def seed_of(master_seed: int, replicate: int) -> int:
    """The seed of a replicate, as `--replicates` has it: 53 bits of the stream (master seed, replicate), whatever the number of replicates."""
    counter = ((replicate << 64) - 1) % 2**256  # numpy counts before it draws
    return int(numpy.random.Philox(key=master_seed + (_STREAM_OF_REPLICATES << 64), counter=counter).random_raw()) >> 11


def cell_name(cell: int) -> str:
    return f"cell-{cell:03}"


def described(program: str, drafts: Sequence[Line]) -> list[Line]:
    """The facts that a program prints of runs: rule_table, engine, until_s, work, fingerprint, species. Raises _BadRun for the first that it cannot
    make."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "draft.jsonl"
        path.write_text("".join(_json(draft) + "\n" for draft in drafts), encoding="utf-8", errors="surrogateescape")
        try:
            done = subprocess.run(
                [program, "--plan", path, "--describe"],
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                encoding="utf-8",
                errors="surrogateescape",
            )
        except OSError as error:
            raise RunError(f"--program {program}: {error.strerror}") from None
        if done.returncode == 0:
            return [json.loads(line) for line in done.stdout.splitlines()]
        said = done.stderr.strip()
        if found := re.search(re.escape(str(path)) + r":(\d+): (.*)", said, re.DOTALL):
            raise _BadRun(int(found[1]) - 1, found[2])
        raise RunError(said or f"--program {program}: exit code {done.returncode}")


class _BadRun(Exception):
    def __init__(self, index: int, why: str):
        super().__init__(why)
        self.index = index


def plan_of(sweep: Sweep, program: str, there: Sequence[Line] = ()) -> list[Line]:
    """The lines of a sweep's plan. Cells and runs that are in `there`, the plan of the sweep's folder, have their numbers and places there; others
    follow. Raises RunError "FILE: cell 3 (SETTINGS): ..." for the first cell that the program cannot run, and for two cells that are the same experiment.
    """
    cells = cells_of(sweep)

    def refuse(cell: int, why: str) -> None:
        text = text_of(cells[cell], sweep)
        raise RunError(f"{sweep.path}: cell {cell}{f' ({text})' if text else ''}: {why}")

    def with_facts(nulls: Sequence[tuple[int, str]]) -> list[Line]:
        """The lines of cells under nulls, with what the program says of them."""
        drafts = [_draft(sweep, cells[cell], null, str(number)) for number, (cell, null) in enumerate(nulls)]
        try:
            return [{**draft, **fact} for draft, fact in zip(drafts, described(program, drafts) if drafts else [])]
        except _BadRun as bad:
            refuse(nulls[bad.index][0], str(bad))
            raise

    for number, cell in enumerate(cells):
        for key in _CHOICES:
            if not isinstance(cell.get(key, ""), str):
                refuse(number, f"{key} = {cell[key]}: must be a text")
    lines = list(enumerate(with_facts([(number, "none") for number in range(len(cells))])))
    nulls = [(cell, null) for cell, line in lines for null in _nulls(sweep, line["species"])]
    lines = sorted([*lines, *zip((cell for cell, _ in nulls), with_facts(nulls))], key=lambda line: line[0])
    seen: dict[tuple, int] = {}
    numbers = _CellNumbers(there)
    plan = []
    for cell, line in lines:
        del line["species"]
        if line["null"] == "none":
            other = seen.setdefault((line["fingerprint"], line["until_s"]), cell)
            if other != cell:
                refuse(cell, f"is the same experiment as cell {other}")
            own = numbers.of(line)
        master_seed = sweep.seed if sweep.paired else seed_of(sweep.seed, own)
        folder = cell_name(own) + ("" if line["null"] == "none" else f"/{line['null']}")
        plan += [
            {
                "cell": own,
                "replicate": k,
                **line,
                "seed": seed_of(master_seed, k),
                "folder": f"{folder}/replicate-{k:02}",
            }
            for k in range(sweep.replicates)
        ]
    places = {line["folder"]: place for place, line in enumerate(there)}
    return sorted(plan, key=lambda line: places.get(line["folder"], len(places)))


def _draft(sweep: Sweep, cell: Settings, null: str, folder: str) -> Line:
    return {
        **{key: cell[key] for key in _CHOICES if key in cell},
        "settings": {key: value for key, value in cell.items() if key not in _CHOICES},
        "seed": 0,
        "null": null,
        "folder": folder,
        "replay_hz": sweep.replay_hz,
        "agents_every": sweep.agents_every,
        "senses": sweep.senses,
        "states": sweep.states,
    }


def _nulls(sweep: Sweep, species: Sequence[str]) -> list[str]:
    """The nulls of a cell whose table has these species."""
    return ["shadow"] * sweep.shadow + [one_sided_name(one) for one in species if sweep.one_sided]


class _CellNumbers:
    """The numbers of cells: that of a plan's cell with the same settings, or else with the same ones but for the duration if there is one such
    cell, or else the next."""

    def __init__(self, there: Sequence[Line]):
        self.next = 1 + max((line["cell"] for line in there), default=-1)
        self.exact: dict[str, int] = {}
        self.similar: dict[str, set[int]] = {}
        for line in there:
            self.exact.setdefault(self._key(line, True), line["cell"])
            self.similar.setdefault(self._key(line, False), set()).add(line["cell"])

    def of(self, line: Line) -> int:
        similar = self.similar.get(self._key(line, False), set())
        if (exact := self.exact.get(self._key(line, True))) is not None:
            return exact
        if len(similar) == 1:
            return next(iter(similar))
        self.next += 1
        return self.next - 1

    @staticmethod
    def _key(line: Line, with_duration: bool) -> str:
        settings = sorted(
            (path, value) for path, value in line["settings"].items() if with_duration or path != DURATION
        )
        return _json([line["rule_table"], line["engine"], [[path, _json(value)] for path, value in settings]])


def _differences(there: Line, here: Line) -> list[str]:
    """The fields that differ between a run of a folder and one of a sweep, the engine first."""
    found = []

    def compare(name: str, its: Any, ours: Any) -> None:
        if its != ours:
            found.append(f"{name} = {_json(its)} there, {_json(ours)} here")

    compare("engine", there["engine"], here["engine"])
    compare("rule_table", there["rule_table"], here["rule_table"])
    for path in {**there["settings"], **here["settings"]}:
        if path != DURATION:
            compare(path, there["settings"].get(path), here["settings"].get(path))
    if there["until_s"] > here["until_s"]:
        compare("until_s", there["until_s"], here["until_s"])
    for name in ("replicate", "null", "seed", "replay_hz", "agents_every", "senses", "states", "fingerprint"):
        compare(name, there[name], here[name])
    return found


def check_grown(path: pathlib.Path, there: Sequence[Line], plan: Sequence[Line]) -> None:
    """Raises RunError unless a plan has every run of a folder's, to the same end or a later one."""
    same = {line["folder"]: line for line in plan}
    for number, line in enumerate(there, 1):
        if line["folder"] in same and not _differences(line, same[line["folder"]]):
            continue
        least = min((_differences(line, here) for here in plan), key=len)
        if least:
            raise RunError(
                f"{path}:{number}: the folder has another plan, with a run that the sweep lacks: {'; '.join(least[:3])}; a sweep can only grow "
                "in values, replicates and time; use another --out"
            )


def _list_text(sweep: Sweep, line: Line) -> str:
    """replicates.json of a cell, by which its runs are found and analysed alone."""
    master_seed = sweep.seed if sweep.paired else seed_of(sweep.seed, line["cell"])
    runs = [{"folder": f"replicate-{k:02}", "seed": seed_of(master_seed, k)} for k in range(sweep.replicates)]
    content = {
        "format": 2,
        "rule_table": line["rule_table"],
        "backend": line["engine"],
        "fingerprint": line["fingerprint"],
        "until_s": line["until_s"],
        "master_seed": master_seed,
        "count": sweep.replicates,
        "replicates": runs,
    }
    body = json.dumps(content, indent=2)[:-2]
    return f'{body},\n  "crc32": {zlib.crc32(body.encode())}\n}}\n'


def _replace(path: pathlib.Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f"{path.name}.{os.getpid()}.part")  # two programs may replace it at once
    try:
        with part.open("w", encoding="utf-8", errors="surrogateescape") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        part.replace(path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise


def make_plan(sweep: Sweep, program: str, out: pathlib.Path) -> list[Line]:
    """Makes the folder with plan.jsonl and sweep.toml or, if it has a plan all of whose runs are in this one, replaces that. Raises RunError for a
    folder with another plan, naming the first run that differs, and for one that does not have a plan.
    """
    path = out / PLAN
    if os.path.lexists(out) and not path.is_file():
        raise RunError(f"{out}: exists already and does not have {PLAN}; runs are never overwritten")
    there: list[Line] = []
    if path.exists():
        read_plan(path)
        there = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]
    plan = plan_of(sweep, program, there)
    check_grown(path, there, plan)
    with contextlib.ExitStack() as stack:
        place = out
        if not there:
            out.parent.mkdir(parents=True, exist_ok=True)
            place = pathlib.Path(tempfile.mkdtemp(prefix=f".{out.name}.making-", dir=out.parent))
            place.chmod(0o777 & ~_umask())
            stack.callback(shutil.rmtree, place, ignore_errors=True)
        for line in plan:
            if line["replicate"] == 0:
                _replace(place / pathlib.Path(line["folder"]).parent / "replicates.json", _list_text(sweep, line))
        _replace(place / "sweep.toml", sweep.text)
        _replace(place / PLAN, "".join(_json(line) + "\n" for line in plan))
        if place != out:
            try:
                place.rename(out)
            except OSError:
                if not out.is_dir():
                    raise
                raise RunError(f"{out}: exists already: another program made it at the same moment") from None
    return plan


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


# How long it takes


@dataclasses.dataclass
class Estimate:
    """How long a plan takes, by short runs on this machine."""

    rates: dict[tuple[str, str], float]
    """core-seconds for one unit of `work`, by table and engine"""
    probes: int

    def core_s(self, lines: Iterable[Line]) -> float:
        return sum(line["work"] * self.rates[line["rule_table"], line["engine"]] for line in lines)

    def text(self, plan: Sequence[Line]) -> str:
        core_s = self.core_s(plan)
        return f"{len(plan)} runs in {len({line['cell'] for line in plan})} cells, about {_duration_text(core_s)} of one core ({number_text(math.ceil(core_s / 36.0) / 100.0)} core-hours), estimated from {self.probes} short {'run' if self.probes == 1 else 'runs'} on this machine"


def _duration_text(seconds: float) -> str:
    for size, unit in ((86400.0, "d"), (3600.0, "h"), (60.0, "min")):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds:.3g} s"


def estimate(program: str, plan: Sequence[Line]) -> Estimate:
    """By short runs of up to three cells of each table and engine, longer until they take half a second."""
    kinds: dict[tuple[str, str], list[Line]] = {}
    for line in plan:
        if line["replicate"] == 0 and line["null"] == "none":
            kinds.setdefault((line["rule_table"], line["engine"]), []).append(line)
    found = Estimate({}, 0)
    for kind, lines in kinds.items():
        count = min(3, len(lines))
        probes = [_probe(program, lines[i * (len(lines) - 1) // max(1, count - 1)]) for i in range(count)]
        found.rates[kind] = sum(probes) / count
        found.probes += count
    return found


def _probe(program: str, line: Line) -> float:
    """Core-seconds for one unit of a run's `work`."""
    words = [
        program,
        "--rules",
        line["rule_table"],
        "--backend",
        line["engine"],
        "--threads",
        "1",
        "--seed",
        str(line["seed"]),
        "--replay-hz",
        "0",
    ]
    for path, value in line["settings"].items():
        if path != DURATION:
            words += ["--set", f"{path}={_json(value)}"]
    until_s = min(line["until_s"], 60.0)
    while True:
        with tempfile.TemporaryDirectory(prefix="trophic-probe-") as folder:
            run = pathlib.Path(folder) / "run"
            done = subprocess.run(
                [*words, "--duration", repr(until_s), "--out", run],
                stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE,
                encoding="utf-8",
                errors="surrogateescape",
            )
            if done.returncode == STOPPED:
                raise KeyboardInterrupt
            if done.returncode != 0:
                raise RunError(f"a short run of {line['folder']}: {done.stderr.strip()}")
            wall_s = float(json.loads((run / "manifest.json").read_text(encoding="utf-8"))["wall_s"])
        if wall_s > 0.5 or until_s >= line["until_s"]:
            return wall_s / (line["work"] * until_s / line["until_s"])
        until_s = min(line["until_s"], 4.0 * until_s)


def dry_run(sweep: Sweep, program: str) -> str:
    """The cells, and how long all of it will take on one core."""
    plan = plan_of(sweep, program)
    cells = cells_of(sweep)
    text = "".join(
        f"{cell_name(line['cell'])}  {sweep.replicates} x {number_text(line['until_s'])} s, {line['rule_table']} on {line['engine']}, "
        f"{text_of(cells[line['cell']], sweep)}\n"
        for line in plan
        if line["replicate"] == 0 and line["null"] == "none"
    )
    return text + estimate(program, plan).text(plan) + "\n"


def job_script(program: str, out: pathlib.Path, plan: Sequence[Line], tasks: int) -> str:
    """A job script for Slurm, each of whose N array tasks makes every N-th run. Any N indices in a row will do."""
    found = estimate(program, plan)
    tasks = min(tasks, len(plan))
    longest_s = max(found.core_s(plan[task::tasks]) for task in range(tasks))
    minutes = math.ceil((1.5 * longest_s + 600.0) / 60.0)  # nodes differ, and checkpoints and start take time
    megabytes = max(512, 2 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024)
    path = shlex.quote(str(out / PLAN))
    return f"""#!/bin/bash
# {found.text(plan)}. The time limit is 1.5 times the longest task's, plus ten minutes.
# Submit it again to finish what was interrupted; `{one_line(pathlib.Path(program).name)} --plan {one_line(str(out / PLAN))} --status` lists it.
#SBATCH --job-name={shlex.quote(one_line(pathlib.Path(program).name))}
#SBATCH --array=1-{tasks}
#SBATCH --cpus-per-task=1
#SBATCH --time={minutes // 60}:{minutes % 60:02}:00
#SBATCH --mem={megabytes}M
#SBATCH --output=slurm-%A_%a.log
#SBATCH --signal=B:TERM@120
if [ "${{SLURM_ARRAY_TASK_COUNT:-{tasks}}}" != {tasks} ] || [ "${{SLURM_ARRAY_TASK_STEP:-1}}" != 1 ]; then
  echo "job.sh: --array: must be {tasks} consecutive indices; otherwise some runs would be omitted" >&2
  exit 2
fi
cd {shlex.quote(os.getcwd())} || exit 2
exec {shlex.quote(program)} --plan {path} --jobs 1 --run $(seq $((SLURM_ARRAY_TASK_ID % {tasks})) {tasks} {len(plan) - 1})
"""


def run(request: dict) -> int:
    """`trophic plan`. `request`: `sweep`, `experiment`, the program that makes the runs, `out`, `dry_run` and `sbatch`."""
    out, sbatch = request["out"], request["sbatch"]
    if request["dry_run"] and (out is not None or sbatch is not None):
        raise RunError(f"--{'out' if out is not None else 'sbatch'}: not with --dry-run")
    if sbatch is not None and sbatch < 1:
        raise RunError(f"--sbatch {sbatch}: must be >= 1")
    if out is None and not request["dry_run"]:
        out = os.path.join("runs", pathlib.Path(request["sweep"]).stem)
    sweep = read_sweep(request["sweep"])
    named, program = request["experiment"], program_named(request["experiment"])
    if out is None:
        text = dry_run(sweep, program)
    else:
        plan = make_plan(sweep, program, pathlib.Path(out))
        text = (
            printable(
                f"{len(plan)} runs planned; next: {shlex.quote(named)} --plan {shlex.quote(str(pathlib.Path(out) / PLAN))}"
            )
            + "\n"
            if sbatch is None
            else job_script(program, pathlib.Path(out), plan, sbatch)
        )
    print(text, end="")
    return 0
