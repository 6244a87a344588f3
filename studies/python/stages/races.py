# SPDX-License-Identifier: MIT
"""Stages of races: of arms, of the Red Queen, and of paces."""
import json
import re
import sys
import tomllib

import data_rows
import designs
import race_rows
from page_tables import races
from study import STUDIES


# The cells of which lineages and historical progress are measured: criterion and ageing. The genomes of `released` are shared, so they have no lineages.
LINEAGED = ["paper", "paper_most_escapes", "paper_ageing", "paper_most_escapes_ageing"]


def progress_rows(study, name, runs, cell, epochs, *options, teams=6, program="trophic-arms-race"):
    """Rows of progress in contests of the runs in these folders."""
    return race_rows.progress_rows(
        cell,
        study.made(
            f"{name}-contests",
            "progress.csv",
            "trophic",
            "contest",
            *runs,
            "--program",
            study.program(program),
            "--epochs",
            ",".join(map(str, epochs)),
            "--teams",
            teams,
            *options,
            "--jobs",
            study.jobs,
        ),
    )


def velocities(study, name, runs):
    """The summary of the velocities of one set of runs."""
    return json.loads(
        study.made(
            f"{name}-velocity",
            "summary.json",
            "trophic",
            "analyze",
            runs,
            "--metric",
            "velocity:prey:inherited",
            "velocity:predator:inherited",
            "--jobs",
            study.jobs,
        ).read_text()
    )


def lineage_rows(study, name, runs, cell):
    """Lineage measures of one set of runs, over the shadow and over drift."""
    return race_rows.lineage_rows(
        cell,
        json.loads(
            study.made(
                f"{name}-lineages",
                "summary.json",
                "trophic",
                "analyze",
                "--lineages",
                runs,
                "--program",
                study.programs / "trophic-arms-race",
                "--jobs",
                study.jobs,
            ).read_text()
        ),
    )


def raced_sweep(study, name, epochs):
    """A sweep of the study: progress and velocity in its cells, and lineage measures of some."""
    runs = study.out / "runs/arms-race" / name
    text = (STUDIES / f"arms_race/{name}.toml").read_text()
    if study.quick:
        text = re.sub(
            r"^replicates = .*",
            "replicates = 2",
            re.sub(r"^ecology.duration_s = .*", "ecology.duration_s = 400.0", text, flags=re.M),
            flags=re.M,
        )
        epochs = [0, 200, 300, 400]
    sweep = study.out / f"{name}.toml"
    sweep.write_text(text)
    study.sweep("trophic-arms-race", sweep, runs)
    cells, lineages = [], []
    for number, settings in designs.cells_of(runs, tomllib.loads(text)["grid"]):
        cell = {"backend": "kinematic", "cell": settings}
        named, of_cell = f"arms-race/{name}-{number:03}", runs / f"cell-{number:03}"
        against = "both" if settings in LINEAGED else "others"
        cells += progress_rows(study, named, [of_cell], cell, epochs, "--against", against, "--split", epochs[1])
        cells += race_rows.raced_rows(cell, velocities(study, named, of_cell))
        if settings in LINEAGED:
            lineages += lineage_rows(study, named, of_cell, cell)
            study.figures(f"{named}-contests", {"contests_predator_prey_others": f"arms_race_{settings}"})
        study.write(f"race_{name}", cells, f"arms-race/{name}")
    if lineages:
        study.write(f"race_{name}_lineages", lineages, f"arms-race/{name}")


def arms_race(study):
    """Criterion and ageing, their free numbers, and more room, without bodies."""
    raced_sweep(study, "arms_race", [0, 2000, 4000, 6000])
    raced_sweep(study, "ranges", [0, 2000, 4000, 6000])
    raced_sweep(study, "room", [0, 2000, 31000, 60000])


def arms_race_mujoco(study):
    """Four cells of `paper` on MuJoCo: criterion and ageing. One shadow serves both criteria.

    Contests cost as much as runs, so those on MuJoCo are between the late epochs alone, short and of smaller teams. The genomes also meet without bodies.
    """
    runs, on_bodies, of_brains = study.out / "runs/arms-race", [], []
    epochs = [0, 100, 200] if study.quick else [0, 2000, 4000]
    for base in ("paper", "paper_ageing"):
        for table in (base, base.replace("paper", "paper_most_escapes")):
            name, cell = f"arms-race/mujoco-{table}", {"backend": "mujoco", "cell": table}
            study.replicates(
                "trophic-arms-race",
                name,
                "--backend",
                "mujoco",
                "--rules",
                table,
                count=6,
                duration_s=4000,
                shadow=table == base,
            )
            ours, shadow = runs / f"mujoco-{table}", runs / f"mujoco-{base}/shadow"
            over = None if table == base else velocities(study, f"arms-race/mujoco-{base}-shadow", shadow)
            on_bodies += race_rows.raced_rows(cell, velocities(study, name, ours), over)
            on_bodies += progress_rows(
                study,
                name,
                [ours],
                cell,
                epochs[1:],
                "--shadow",
                shadow,
                "--team-size",
                10,
                "--duration",
                10 if study.quick else 150,
                teams=2,
            )
            of_brains += progress_rows(
                study,
                f"{name}-brains",
                [ours],
                {**cell, "backend": "kinematic"},
                epochs,
                "--shadow",
                shadow,
                "--backend",
                "kinematic",
                "--against",
                "both",
                teams=2,
            )
            study.write("race_mujoco", on_bodies)
            study.write("race_mujoco_brains", of_brains)


def red_queen(backend, name, program="trophic-arms-race", options=(), **tables):
    """Four worlds of each table, in which both sides inherit, one of them, or none: changes, progress on a panel, selection and meetings. With a
    trait among the options: its course, progress, and whether both go on."""
    others = ("goes_on", "through_time", "values", "series") if "--trait" in options else ("meetings",)

    def stage(study):
        found = {}
        for table, (duration_s, count) in tables.items():
            out = study.out / f"runs/{name}/{table}"
            out.parent.mkdir(parents=True, exist_ok=True)
            if not (out / f"{others[0]}.csv").exists():
                study.call(
                    sys.executable,
                    STUDIES / "red_queen/red_queen.py",
                    "--program",
                    study.program(program),
                    "--trophic",
                    study.program("trophic"),
                    "--rules",
                    table,
                    "--backend",
                    backend,
                    "--contests-on",
                    "kinematic",
                    "--duration",
                    duration_s // 10 if study.quick else duration_s,
                    "--replicates",
                    6 if study.quick else count,
                    "--jobs",
                    study.jobs,
                    *options,
                    "--out",
                    out,
                )
            study.note(f"{name}/{table}")
            for file in ("red_queen", *others):
                parts = [out / f"{file}.csv"] if (out / f"{file}.csv").exists() else sorted((out / file).glob("*.csv"))
                rows = [{"table": table, **row} for part in parts for row in data_rows.read(part)]
                found[file] = found.get(file, []) + rows
        for file, rows in found.items():
            study.write(name.replace("-", "_") + ("" if file == "red_queen" else f"_{file}"), rows)

    return stage


def race_of(name, program, table, seed, count, *more):
    """Four worlds of a table whose individuals inherit their pace, on their own seeds."""
    options = ("--trait", "walking_pace", *more, "--panel-runs", 12, "--seed", seed)
    return red_queen("kinematic", name, program, options, **{table: (24000, count)})


def pond_race(name, seed, count):
    """The race of paces, and its figure."""
    make = race_of(name, "trophic-worlds", "pond_race", seed, count)

    def stage(study):
        make(study)
        sets = [study.data / f"{of}_series.csv" for of in races.RACE]
        rows = [
            {**row, "run": f"{path.stem} {row['run']}"}
            for path in sets
            if path.exists()
            for row in data_rows.read(path)
        ]
        races.draw_race(rows, study.data.parent / "pond_race.png")

    return stage


STAGES = {
    "arms-race": arms_race,
    "arms-race-mujoco": arms_race_mujoco,
    "red-queen": red_queen(
        "kinematic", "red-queen", paper_by_side=(6000, 30), pond_by_side=(6000, 30), growing_by_side=(60000, 10)
    ),
    "red-queen-mujoco": red_queen("mujoco", "red-queen-mujoco", released_by_side=(4000, 6)),
    "pond-race": pond_race("pond-race", 1, 12),
    "pond-race-again": pond_race("pond-race-again", 2, 20),
    "pond-race-more": pond_race("pond-race-more", 5, 28),
    "pond-race-small-steps": race_of(
        "pond-race-small-steps", "trophic-worlds", "pond_race", 3, 20, "--set", "rules.traits.walking_pace.sd=0.03"
    ),
    "pond-sight": race_of("pond-sight", "trophic-race", "pond_sight", 4, 20, "--trait", "sight_m"),
}
