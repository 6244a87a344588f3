# SPDX-License-Identifier: MIT
"""`trophic contest`: the contests of some runs and their shadow. Teams of each epoch are drawn here, and PROGRAM --play plays them.

The draw: a team meets the teams of its number of all epochs, at the same places, so that a difference between epochs is not one of opponents or
places. Teams, partners and places are drawn for each replicate: drawn alike in all, their errors would not cancel over replicates, and no interval
would show them. The shadow of a replicate has its places. Every draw is one of numpy's RandomState, whose numbers numpy never changes, seeded by
(seed, purpose, numbers of what is drawn)."""
from __future__ import annotations

import dataclasses
import itertools
import json
import math
import os
import pathlib
import re
import subprocess
import time
import zlib
from collections.abc import Iterator, Sequence
from typing import Any

import numpy
import pandas

from . import contests, pool
from .errors import RunError, remark
from .metrics import Measuring
from .pool import MOST_TIME_S, PooledRun
from .programs import chosen_program
from .runs import verify
from .sweeps.runs import is_sweep
from .words import number_text
from .writing import csv_text, result_folder, write_new

PLAYED = "played.jsonl"
"""Outcomes while contests are played, one per line, so that repeating the command resumes a killed one."""
_TEAM, _PARTNER, _PLACES = range(3)  # purposes of draws
_DEFAULT_EPOCHS = 4
_BATCH_S = 20.0  # how long a call of the program shall take
_RECORD_HZ, _MOST_RECORDED = 10, 100


@dataclasses.dataclass
class Size:
    """How many contests there are, of what."""

    epochs_s: list[float]
    against: Sequence[str]
    """own and others; none of them with a panel"""
    teams: int
    team_size: int
    seed: int


@dataclasses.dataclass
class Planned:
    """The teams and matches of a plan as JSON, and each match's row of contests.csv but for its outcome."""

    teams: list[dict] = dataclasses.field(default_factory=list)
    matches: list[list[int]] = dataclasses.field(default_factory=list)
    rows: list[dict[str, Any]] = dataclasses.field(default_factory=list)


# The draw


def _stream(seed: int, purpose: int, *numbers: int) -> numpy.random.RandomState:
    return numpy.random.RandomState([seed & 0xFFFFFFFF, seed >> 32, purpose, *numbers])


def members(seed: int, team: Sequence[int], living: int, size: int) -> list[int]:
    """`size` of `living` individuals, all of them before any twice. `team`: replicate, 1 for the shadow, epoch, species and number."""
    stream = _stream(seed, _TEAM, *team)
    return list(
        itertools.chain.from_iterable(stream.permutation(living).tolist() for _ in range(math.ceil(size / living)))
    )[:size]


def partner(seed: int, replicates: int, replicate: int, team: int) -> int:
    """The replicate whose victims the hunters of this one meet, never itself; each is the partner of exactly one, of another one for each team as
    long as there are."""
    order = _stream(seed, _PARTNER).permutation(replicates).tolist()
    return order[(order.index(replicate) + 1 + team % (replicates - 1)) % replicates]


def places(seed: int, replicate: int, team: int) -> int:
    """The seed of an arena's places."""
    return int(_stream(seed, _PLACES, replicate, team).randint(0, 2**48, dtype=numpy.int64))


# The teams


def check_epoch(run: PooledRun, epoch_s: float) -> None:
    """Raises RunError unless a run was written to its end and reached an epoch."""
    path = run.path / "manifest.json"
    if run.reached_s is None:
        raise RunError(
            f'{path}: status "{run.manifest["status"]}": phylogeny.csv has those alive only at a run\'s end; resume the run'
        )
    if run.reached_s < epoch_s:
        raise RunError(
            f"{path}: the run reached {number_text(run.reached_s)} s: must be >= {number_text(epoch_s)} s, an epoch"
        )


def _known(numbers: numpy.ndarray) -> list[float]:
    return numbers[~numpy.isnan(numbers)].tolist()


def living_genomes(run: PooledRun, epochs_s: Sequence[float]) -> list[dict[str, list[list[list[float]]]]]:
    """The genomes, [weights, genes of gait, of body, traits], of the individuals that were alive after the rules of each epoch's tick: for each epoch
    by species, in the order of their ids. A genome that several share changes at later births: the last one up to the epoch counts.
    """
    for epoch_s in epochs_s:
        check_epoch(run, epoch_s)
    born, genomes = run.table("phylogeny"), run.table("genomes")
    genes = (
        run.table("genes") if (run.path / "genes.csv").exists() else pandas.DataFrame(columns=["id", "part", "value"])
    )
    parts = {key: of.tolist() for key, of in genes.groupby(["id", "part"], sort=False)["value"]}
    weights = [name for name in genomes if name[0] == "w" and name[1:].isdigit()]
    traits = [name for name in genomes if name not in ("id", "genome_id", "time_s", *weights)]
    living = []
    for epoch_s in epochs_s:
        gone_s = pandas.to_numeric(born["destruction_time"]).fillna(math.inf)
        alive = born[(born["origin_time"] <= epoch_s) & (gone_s > epoch_s)].sort_values("id")
        last = genomes[genomes["time_s"] <= epoch_s].drop_duplicates("genome_id", keep="last").set_index("genome_id")
        by_species: dict[str, list] = {}
        rows = last.index.get_indexer(alive["genome_id"])
        ids, own, of_traits = last["id"].to_numpy(), last[weights].to_numpy(float), last[traits].to_numpy(float)
        for one, row in zip(alive.itertuples(index=False), rows):
            if row < 0:
                raise RunError(f"{run.path / 'genomes.csv'}: has no genome of individual {one.id}")
            brain, gait, body = (parts.get((int(ids[row]), part), []) for part in ("brain", "gait", "body"))
            genome = [brain or _known(own[row]), gait, body, _known(of_traits[row])]
            by_species.setdefault(one.species, []).append(genome)
        living.append(by_species)
    return living


class _Teams:
    """Teams of one set of runs, each drawn when first asked for."""

    def __init__(self, runs: Sequence[PooledRun], size: Size, is_shadow: bool, planned: Planned):
        self.runs, self.size, self.is_shadow, self.planned = runs, size, is_shadow, planned
        self.species = list(runs[0].manifest["species"])
        self.living = [living_genomes(run, size.epochs_s) for run in runs]
        self.numbers: dict[tuple, int] = {}

    def __call__(self, replicate: int, epoch: int, species: str, team: int) -> int:
        """The number of the team in the plan."""
        key = replicate, epoch, species, team
        if key not in self.numbers:
            living = self.living[replicate][epoch].get(species)
            if not living:
                raise RunError(
                    f"{self.runs[replicate].path}: no {species} is alive at {number_text(self.size.epochs_s[epoch])} s, an epoch"
                )
            number = self.species.index(species)
            drawn = members(
                self.size.seed, (replicate, int(self.is_shadow), epoch, number, team), len(living), self.size.team_size
            )
            self.numbers[key] = len(self.planned.teams)
            self.planned.teams.append({"species": number, "genomes": [living[one] for one in drawn]})
        return self.numbers[key]


# The matches


def add_matches(
    planned: Planned, runs: Sequence[PooledRun], size: Size, is_shadow: bool, panel: Sequence[PooledRun]
) -> None:
    """Adds the contests of a set of runs: every epoch with every other or, with a panel, with the last living of one of its runs, the same in all
    epochs, sets and studies."""
    teams = _Teams(runs, size, is_shadow, planned)
    epochs = range(len(size.epochs_s))

    def add(against: str, link: tuple[str, str], team: int, replicate: int, hunters: tuple, victims: tuple) -> None:
        planned.matches.append([hunters[0], victims[0], places(size.seed, replicate, team)])
        planned.rows.append(
            {
                "shadow": int(is_shadow),
                "against": against,
                "hunters_run": str(hunters[1]),
                "victims_run": str(victims[1]),
                "team": team,
                "hunter": link[0],
                "victim": link[1],
                "hunter_epoch_s": hunters[2],
                "victim_epoch_s": victims[2],
            }
        )

    if panel:
        last = dataclasses.replace(size, epochs_s=[panel[0].reached_s or 0.0])
        opponents = _Teams(panel, last, False, planned)
    for hunter, victim in runs[0].web.links:
        for against in size.against:
            for replicate, team, p, q in itertools.product(range(len(runs)), range(size.teams), epochs, epochs):
                other = replicate if against == "own" else partner(size.seed, len(runs), replicate, team)
                add(
                    against,
                    (hunter, victim),
                    team,
                    replicate,
                    (teams(replicate, p, hunter, team), runs[replicate].path, size.epochs_s[p]),
                    (teams(other, q, victim, team), runs[other].path, size.epochs_s[q]),
                )
        if panel:
            for replicate, team, epoch, hunts in itertools.product(
                range(len(runs)), range(size.teams), epochs, (True, False)
            ):
                other = (replicate + team) % len(panel)
                ours = (
                    teams(replicate, epoch, hunter if hunts else victim, team),
                    runs[replicate].path,
                    size.epochs_s[epoch],
                )
                theirs = opponents(other, 0, victim if hunts else hunter, team), panel[other].path, last.epochs_s[0]
                add(
                    "panel_victims" if hunts else "panel_hunters",
                    (hunter, victim),
                    team,
                    replicate,
                    ours if hunts else theirs,
                    theirs if hunts else ours,
                )


def table_of(run: PooledRun) -> str:
    """Teams of a shadow or of a one-sided world meet in the arena of the table that it is the null of."""
    table = run.manifest["rule_table"]
    return re.sub(r" with heredity = (nothing_inherited|\w+, nothing_inherited for .*)$", "", table)


def _kind_of(run: PooledRun) -> str:
    """The table, and whether the runs were only screened."""
    is_screened = run.manifest["params"].get("backend", {}).get("stepping") == "screening"
    return table_of(run) + (" with backend.stepping = screening" if is_screened else "")


def _whole_runs(paths: Sequence[pathlib.Path], how: Measuring) -> tuple[list[PooledRun], list[str]]:
    """The runs of a set, with remarks. Raises RunError for one with a file that is not what the run wrote."""
    runs, remarks = pool.pooled_runs(paths, how)
    for run in runs:
        verify(run.path)
    return runs, remarks


def plan_for(first: PooledRun, duration_s: float, reach_m: float, planned: Planned) -> dict:
    """The plan that a program plays, of contests by the table and parameters of a run."""
    return {
        "format": "trophic contests",
        "version": 1,
        "rule_table": table_of(first),
        "engine": first.manifest["backend"].split()[0],
        "fingerprint": first.fingerprint,
        "params": first.manifest["params"],
        "duration_s": duration_s,
        "reach_m": reach_m,
        "teams": planned.teams,
        "matches": planned.matches,
    }


def plan_of(request: dict) -> tuple[dict, list[dict[str, Any]], list[str]]:
    """The plan that a program plays, the rows of contests.csv without outcomes, and remarks. Raises RunError if the runs cannot give these contests."""
    paths = [pathlib.Path(path) for path in request["runs"]]
    how = Measuring(accept_other_build=request["accept_other_build"])
    for path in paths:
        if is_sweep(path):
            raise RunError(f"{path}: is a sweep; give one of its cells")
    runs, remarks = _whole_runs(paths, how)
    first = runs[0]
    if not first.web.links:
        raise RunError(f"{first.path}: this food web has no hunting species; a contest needs hunters and victims")
    shadow: list[PooledRun] = []
    if of_shadow := [pathlib.Path(request["shadow"])] if request["shadow"] else pool.null_folders(paths):
        shadow = _whole_runs(of_shadow, how)[0]
        pool.check_shadow(first, shadow[0], True)
    panel: list[PooledRun] = []
    if request["panel"]:
        panel = _whole_runs([pathlib.Path(request["panel"])], how)[0]
        if (kind := _kind_of(panel[0])) != _kind_of(first):
            raise RunError(f"--panel {request['panel']}: has runs of {kind}: must have runs of {_kind_of(first)}")
        for run in panel:
            check_epoch(run, panel[0].reached_s or 0.0)
    for run in runs:
        check_epoch(run, 0.0)
    against = () if panel else ("own", "others") if request["against"] == "both" else (request["against"],)
    if len(runs) < 2 and "others" in against:
        raise RunError(f"--against others: needs at least two replicates; {first.path} is one")
    epochs_s = _epochs_of(request["epochs"] or "") or [
        (first.reached_s or 0.0) * i / (_DEFAULT_EPOCHS - 1) for i in range(_DEFAULT_EPOCHS)
    ]
    _check_epochs(epochs_s, request["split"])
    size = Size(
        epochs_s,
        against,
        request["teams"],
        request["team_size"] or max(1, first.manifest["params"]["ecology"]["robots"] // 2),
        request["seed"],
    )
    planned = Planned()
    for is_shadow, of in ((False, runs), (True, shadow)):
        if of:
            add_matches(planned, of, size, is_shadow, panel)
    plan = plan_for(first, request["duration"], request["reach"], planned)
    if request["backend"] and request["backend"] != plan["engine"]:
        plan |= {
            "engine": request["backend"],
            "fingerprint": "",
            "params": {key: of for key, of in plan["params"].items() if key != "backend"},
        }
    return plan, planned.rows, remarks


def _epochs_of(text: str) -> list[float]:
    try:
        epochs_s = [float(part) for part in text.split(",")] if text else []
    except ValueError:
        epochs_s = [math.nan]
    if not all(map(math.isfinite, epochs_s)):
        raise RunError(f"--epochs {text}: must be comma-separated times in seconds, e.g. 0,2000,6000")
    return epochs_s


def _check_epochs(epochs_s: Sequence[float], split_s: float | None) -> None:
    if len(epochs_s) < 2:
        raise RunError(f"--epochs: {len(epochs_s)} epochs: must be at least 2")
    for before_s, epoch_s in zip([None, *epochs_s], epochs_s):
        if epoch_s < 0.0:
            raise RunError(f"--epochs {number_text(epoch_s)}: must be >= 0")
        if before_s is not None and epoch_s <= before_s:
            raise RunError(f"--epochs {number_text(epoch_s)}: must be > {number_text(before_s)}, the epoch before it")
    if split_s is not None and split_s not in epochs_s:
        raise RunError(
            f"--split {number_text(split_s)}: must be one of the epochs, {', '.join(map(number_text, epochs_s))} s"
        )


# Playing


def _played(path: pathlib.Path, head: str) -> dict[int, list[float]]:
    """The outcomes that a program left that played the same plan; what was cut short is not one."""
    found: dict[int, list[float]] = {}
    if path.exists() and (whole := path.read_text(encoding="utf-8")).startswith(head):
        for line in whole[len(head) :].splitlines(keepends=True):
            if not line.endswith("\n"):
                break
            match, *outcome = json.loads(line)
            found[match] = outcome
    path.unlink(missing_ok=True)
    if found:
        played = "".join(json.dumps([match, *outcome]) + "\n" for match, outcome in found.items())
        path.write_text(head + played, encoding="utf-8")
    return found


def play(plan: dict, program: str, jobs: int, folder: pathlib.Path) -> list[list[float]]:
    """Lets a program play the matches of a plan and returns their outcomes. It is called for some of them at a time, whose outcomes are kept in the
    folder. Raises RunError with the program's sentence if it refuses."""
    head = json.dumps([zlib.crc32(json.dumps(plan).encode())]) + "\n"
    known = _played(folder / PLAYED, head)
    left = [match for match in range(len(plan["matches"])) if match not in known]
    if known:
        remark("trophic contest", f"{len(known)} of {len(plan['matches'])} contests have been played already")
    size = 4 * jobs
    while left:
        batch, left = left[:size], left[size:]
        began = time.monotonic()
        found = dict(zip(batch, _play_some(plan, batch, program, jobs, folder)))
        with (folder / PLAYED).open("a", encoding="utf-8") as file:  # made when there is an outcome
            file.write(
                ("" if known else head)
                + "".join(json.dumps([match, *outcome]) + "\n" for match, outcome in found.items())
            )
            file.flush()
            os.fsync(file.fileno())
        known |= found
        size = max(jobs, int(size * min(4.0, _BATCH_S / (time.monotonic() - began + 1e-3))))
    return [known[match] for match in range(len(plan["matches"]))]


def _play_some(
    plan: dict, matches: Sequence[int], program: str, jobs: int, folder: pathlib.Path
) -> Iterator[list[float]]:
    chosen = [plan["matches"][match] for match in matches]
    teams = {team: number for number, team in enumerate(dict.fromkeys(team for match in chosen for team in match[:2]))}
    path = folder / "plan.json"
    outcomes = path.with_name("plan.json.outcomes")
    outcomes.unlink(missing_ok=True)
    path.write_text(
        json.dumps(
            {
                **plan,
                "teams": [plan["teams"][team] for team in teams],
                "matches": [[teams[hunters], teams[victims], at] for hunters, victims, at in chosen],
            }
        )
        + "\n",
        encoding="utf-8",
    )
    try:
        process = subprocess.Popen(
            [program, "--play", path, "--jobs", str(jobs)],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            encoding="utf-8",
            errors="surrogateescape",
        )
    except OSError as error:
        raise RunError(f"--program {program}: {error.strerror}") from None
    try:
        said = process.communicate()[1].strip()
    except BaseException:
        process.terminate()
        process.wait()
        raise
    if process.returncode == 3:
        raise KeyboardInterrupt
    if process.returncode != 0 or not outcomes.exists():
        raise RunError(said or f"--program {program}: did not play the contests: exit code {process.returncode}")
    found = json.loads(outcomes.read_text(encoding="utf-8"))
    for each in (path, outcomes):
        each.unlink()
    if "record_hz" in plan:
        runs = folder / "plan.json.runs"
        for number, match in enumerate(matches):
            (runs / str(number)).rename(folder / f"contest-{match}")
        runs.rmdir()
    return iter(found)


# The command


def run(request: dict) -> int:
    """`trophic contest`. `request`: runs, shadow, panel, record, epochs, against, split, teams, team_size, duration, reach, seed, backend, `experiment` (the
    program), jobs, accept_other_build and out."""
    for name in ("duration", "reach"):
        if not 0.0 < request[name] <= MOST_TIME_S:
            raise RunError(f"--{name} {number_text(request[name])}: must be > 0 and <= {number_text(MOST_TIME_S)}")
    if not 2 <= request["teams"] <= 1000:
        raise RunError(
            f"--teams {request['teams']}: must be >= 2 and <= 1000; a single team does not represent its epoch"
        )
    if request["team_size"] is not None and not 1 <= request["team_size"] <= 10_000:
        raise RunError(f"--team-size {request['team_size']}: must be >= 1 and <= 10000")
    if request["jobs"] == 0:
        raise RunError("--jobs 0: must be >= 1")
    plan, rows, remarks = plan_of(request)
    if request["record"]:
        if len(rows) > _MOST_RECORDED:
            raise RunError(
                f"--record: {len(rows)} contests: must be <= {_MOST_RECORDED}; fewer runs, --teams or --epochs make fewer"
            )
        plan["record_hz"] = _RECORD_HZ
    for what in remarks:
        remark(request["who"], what)
    program = chosen_program(request)
    out = request["out"]
    try:
        with result_folder(out, keeps="" if request["record"] else PLAYED, name="contests") as folder:
            out, began = str(folder.with_suffix("")), time.monotonic()
            outcomes = play(plan, program, request["jobs"] or os.cpu_count() or 1, folder)
            table = pandas.DataFrame(
                [
                    {**row, "contact_s": contact_s, "contacted": contacted}
                    for row, (contact_s, contacted) in zip(rows, outcomes)
                ]
            )
            write_new(folder / "contests.csv", csv_text(table))
            (folder / PLAYED).unlink(missing_ok=True)
            text = contests.report(folder, request, time.monotonic() - began)
    except (KeyboardInterrupt, SystemExit):
        remark(request["who"], f"interrupted; to resume, repeat the command with --out {out}")
        raise
    print(text, end="")
    return 0
