#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Does one species' evolution keep the other's going? Runs four worlds, in which both species inherit, one of them, or none, lets their last living and
those of earlier times meet a panel, and writes what a species does more where the other one inherits.

    red_queen.py --program build/my_program --rules my_table --trophic build/trophic --out runs/queen

The table has `by_species<Switched<...>>` as its Heredity and a brain that change.py reads, or a heritable trait that --trait names, whose measures are
those of traits.py. A stopped command continues. studies/results/red-queen.md and pond-race.md define measures and families."""
import argparse
import itertools
import math
import pathlib
import shutil
import subprocess
import sys

import numpy
import pandas

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent / "python")]
import installed

installed.make_importable()
import change
import traits
import trophic
from trophic import contests, selection, statistics
from trophic.metrics import Measuring

WORLDS = {"both": (True, True), "prey": (True, False), "predator": (False, True), "none": (False, False)}
SIDES = ("prey", "predator")


def call(*words):
    print("$", *words, flush=True)
    done = subprocess.run([str(word) for word in words], stdout=subprocess.DEVNULL)
    if done.returncode != 0:
        raise SystemExit(f"red_queen: exit code {done.returncode} of {words[0]}")


def switches(inherited):
    """The parameters of a world in which these sides inherit."""
    return [f"rules.heredity.{side}.inherited={str(on).lower()}" for side, on in zip(SIDES, inherited)]


def make_runs(options, name, inherited, seed, count, *more):
    out = options.out / name
    call(
        options.program,
        "--rules",
        options.rules,
        "--backend",
        options.backend,
        "--replicates",
        count,
        "--seed",
        seed,
        "--duration",
        options.duration,
        "--agents-every",
        1000 if options.trait else 6,
        "--replay-hz",
        0,
        "--jobs",
        options.jobs,
        *(word for switch in switches(inherited) for word in ("--set", switch)),
        *(word for assignment in options.set for word in ("--set", assignment)),
        *more,
        "--out",
        out,
        *(["--resume"] if out.exists() else []),
    )


def living_runs(options, world):
    """The folders of the runs of a world in which every species lives to the end."""
    return [
        run.path
        for run in trophic.read_runs(str(options.out / world))
        if traits.living(run)["species"].nunique() == len(run.manifest["species"])
    ]


def living_panel(options):
    """A folder with the runs of the panel in which every species lives to the end."""
    panel, living = options.out / "panel", options.out / "panel_living"
    living.mkdir(exist_ok=True)
    shutil.copy(panel / "replicates.json", living)
    for path in living_runs(options, "panel"):
        if not (living / path.name).exists():
            (living / path.name).symlink_to(path.resolve())
    return living


def make_contests(options, world, panel, epochs, teams):
    """The contests of a world's runs against the last living of another set or, if `panel` is "others", among these runs, as a frame."""
    out = options.out / f"contests/{world}-{panel}"
    if not (out / "progress.csv").exists():
        out.parent.mkdir(exist_ok=True)
        call(
            options.trophic,
            "contest",
            *(living_runs(options, world) if options.trait else [options.out / world]),
            *(
                ["--against", panel]
                if panel == "others"
                else ["--panel", living_panel(options) if options.trait else options.out / panel]
            ),
            "--program",
            options.program,
            "--backend",
            options.contests_on or options.backend,
            "--jobs",
            options.jobs,
            "--teams",
            teams,
            "--team-size",
            options.team_size,
            "--epochs",
            ",".join(map(str, epochs)),
            "--split",
            epochs[-2],
            "--out",
            out,
        )
    return pandas.read_csv(out / "contests.csv", dtype={"hunters_run": str, "victims_run": str})


def measured(options, world):
    """The values of each run of a world, by (measure, species)."""
    found = {}
    for metric in (change.gene_change, change.turn_change):
        own, null = (
            pandas.concat(
                [metric(run).set_index("species")[metric.metric] for run in trophic.read_runs(str(folder))], axis=1
            )
            for folder in (options.out / world, options.out / world / "neutral")
        )
        found |= {(metric.metric, side): own.loc[side].to_numpy() - null.loc[side].to_numpy() for side in SIDES}
    end_s = options.duration
    played = make_contests(options, world, "panel", [0, end_s / 3, end_s], 6)
    for side, role in zip(SIDES, ("victim", "hunter")):
        of_role = played[played["against"] != f"panel_{role}s"]
        for period, times in (("early", (0, end_s / 3)), ("late", (end_s / 3, end_s))):
            found[f"progress_{period}", side] = contests.progress_of_runs(
                of_role, role, contests.epochs_of(played), *times
            )
    runs = selection.read_sets([options.out / world], None, Measuring())[0]["runs"]
    turns = [(selection.events_of(run), change.turns_to(run), run.lived_s) for run in runs]
    for side in SIDES:
        terms = [selection.terms(events, z, side, end_s) for events, z, end_s in turns]
        found |= {
            (f"{term}_{name}", side): numpy.array([of[term, period] for of in terms])
            for term in ("survival", "parenthood", "mutation")
            for name, period in (("all", "all"), ("late", "third"))
        }
    return found


def measured_trait(options, world):
    """The values of each run of a world, by (measure, species), in a frame that is kept, and the trait by time. The tables that are large are deleted."""
    kept, by_time = (options.out / f"{name}/{world}.csv" for name in ("values", "series"))
    if not kept.exists():
        make_runs(options, world, WORLDS[world], options.seed, options.replicates)
        end_s = options.duration
        thirds = [0, end_s / 3, end_s * 2 / 3, end_s]
        played = make_contests(options, world, "panel", thirds, options.teams)
        if world == "both":
            make_contests(options, world, "others", [0, end_s / 2, end_s], options.teams)
        rows, courses = [], []
        for run in trophic.read_runs(str(options.out / world)):
            of_traits = [traits.Course(run, trait) for trait in options.trait]
            courses += [traits.series(course, world, run.path.name, 5) for course in of_traits]
            of_run = played[played["hunters_run"].str.endswith(f"{world}/{run.path.name}")]
            as_prey = played[played["victims_run"].str.endswith(f"{world}/{run.path.name}")]
            for side, role, of in zip(SIDES, ("victim", "hunter"), (as_prey, of_run)):
                first, *others = (course.values(side) for course in of_traits)
                values = dict(first)
                for trait, found in zip(options.trait[1:], others):
                    values |= {
                        f"{trait}_{name}": value for name, value in found.items() if name not in ("lived_s", "number")
                    }
                for period, times in zip(
                    ("early", "middle", "third", "late"), (*zip(thirds, thirds[1:]), thirds[1::2])
                ):
                    found = contests.progress_of_runs(of, role, contests.epochs_of(played), *times) if len(of) else ()
                    values[f"progress_{period}"] = float(found[0]) if len(found) else math.nan
                rows += [(world, run.path.name, side, measure, value) for measure, value in values.items()]
        for path, frame in (
            (by_time, pandas.concat(courses)),
            (kept, pandas.DataFrame(rows, columns=["world", "run", "side", "measure", "value"])),
        ):
            path.parent.mkdir(exist_ok=True)
            frame.to_csv(path, index=False, float_format="%.5g", lineterminator="\n")
        for path in (options.out / world).glob("replicate-*/field.csv"):
            path.unlink()
    frame = pandas.read_csv(kept)
    return {
        key: of["value"].to_numpy()[~of["value"].isna().to_numpy()]
        for key, of in frame.groupby(["measure", "side"], sort=False)
    }


PRIMARY = ("gene_change", "turn_change", "trait_end", "progress_late")


def tested(rows):
    """The rows with the differences `of`, their intervals and p, which are corrected in each family (Holm)."""
    for family in {row["family"] for row, _ in rows}:
        statistics.adjust_together([of for row, of in rows if row["family"] == family])
    return pandas.DataFrame(
        [
            {
                **row,
                "difference": of.value,
                "lower": of.interval and of.interval[0],
                "upper": of.interval and of.interval[1],
                "p": of.p,
                "p_holm": of.adjusted,
            }
            for row, of in rows
        ]
    )


def differences(values):
    """A row for each measure and side: the world in which both inherit less that in which this side alone does. The primary measures of both sides
    are one family, the others another (Holm)."""
    rows, primary = [], sum(measure in PRIMARY for measure, _ in values["both"])
    for measure, side in values["both"]:
        both, alone = values["both"][measure, side], values[side][measure, side]
        of = statistics.contrast((1.0, both), (-1.0, alone))
        rows.append(
            (
                {
                    "measure": measure,
                    "side": side,
                    "family": "primary" if measure in PRIMARY else "other",
                    "runs": len(both),
                    "alone_runs": len(alone),
                    **{world: values[world][measure, side].mean() for world in WORLDS},
                    "detectable": statistics.detectable_difference(of, 0.05 / primary) if of else None,
                },
                statistics.difference_of(both.mean() - alone.mean(), of),
            )
        )
    return tested(rows)


def goes_on(values):
    """Whether the trait of either side still moves in the last third where both inherit, over drift, and whether contests are still won, over the
    world in which neither inherits: one family."""
    rows = []
    for measure, world in (("trait_slope", ""), ("progress_third", "none")):
        for side in SIDES:
            both, other = values["both"][measure, side], values[world][measure, side] if world else None
            terms = [(1.0, both), *([(-1.0, other)] if world else [])]
            of = statistics.contrast(*terms)
            row = {
                "measure": measure,
                "side": side,
                "family": "goes on",
                "runs": len(both),
                "both": both.mean(),
                "over": world or "drift",
                "of_other": other.mean() if world else 0.0,
                "detectable": statistics.detectable_difference(of, 0.05 / 4) if of else None,
            }
            rows.append((row, statistics.difference_of(of.value if of else None, of)))
    return tested(rows)


def through_time(options):
    """The contact time of hunters of each time and victims of each time where both inherit, of different runs: mean and interval over the hunters' runs."""
    played = pandas.read_csv(options.out / "contests/both-others/contests.csv", dtype={"hunters_run": str})
    rows = []
    for (hunters_s, victims_s), of in played.groupby(["hunter_epoch_s", "victim_epoch_s"]):
        means = of.groupby("hunters_run")["contact_s"].mean()
        lower, upper = statistics.interval_of_mean(means) or (None, None)
        row = {"hunters_s": hunters_s, "victims_s": victims_s, "runs": len(means), "contact_s": means.mean()}
        rows.append(row | {"lower": lower, "upper": upper})
    return pandas.DataFrame(rows)


def meetings(options):
    """The contact time of the last living hunters of each world and the last living victims of each other world: mean and interval over runs."""
    rows = []
    for world, other in itertools.combinations(WORLDS, 2):
        played = make_contests(options, world, other, [0, options.duration], 2)
        for hunters, victims, role, ours in ((world, other, "victims", "hunter"), (other, world, "hunters", "victim")):
            of = played[(played["against"] == f"panel_{role}") & (played[f"{ours}_epoch_s"] == options.duration)]
            means = of.groupby(f"{ours}s_run")["contact_s"].mean()
            lower, upper = statistics.interval_of_mean(means) or (None, None)
            rows.append(
                {
                    "hunters": hunters,
                    "victims": victims,
                    "runs": len(means),
                    "contact_s": means.mean(),
                    "lower": lower,
                    "upper": upper,
                }
            )
    return pandas.DataFrame(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("program", "rules", "trophic"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--backend", default="kinematic")
    for name, default in (("replicates", 30), ("duration", 6000), ("seed", 1), ("jobs", 1), ("team-size", 15)):
        parser.add_argument(f"--{name}", type=int, default=default)
    parser.add_argument("--contests-on", metavar="BACKEND", help="backend of the contests (default: the runs')")
    parser.add_argument(
        "--trait",
        action="append",
        default=[],
        help="a heritable trait of the table, the first one for the primary measures; only runs in which both species last meet in contests",
    )
    parser.add_argument("--teams", type=int, default=8, help="of a trait: teams of each run and epoch in contests")
    parser.add_argument("--panel-runs", type=int, help="runs of the panel (default: as many as replicates)")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="a parameter of all runs")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    make_runs(options, "panel", (True, True), options.seed + 1000, options.panel_runs or options.replicates)
    if options.trait:
        values = {world: measured_trait(options, world) for world in WORLDS}
        found = [
            ("red_queen", differences(values)),
            ("through_time", through_time(options)),
            ("goes_on", goes_on(values)),
        ]
    else:
        for world, inherited in WORLDS.items():
            make_runs(options, world, inherited, options.seed, options.replicates, "--neutral")
        found = [
            ("red_queen", differences({world: measured(options, world) for world in WORLDS})),
            ("meetings", meetings(options)),
        ]
    for name, frame in found:
        frame.to_csv(options.out / f"{name}.csv", index=False, float_format="%.6g", lineterminator="\n")
        print(frame.to_string(index=False, float_format="{:.3g}".format))


if __name__ == "__main__":
    main()
