# SPDX-License-Identifier: MIT
"""Stages of the paper's rules: the published tables, readings of the text, ablations and inheritance."""
import json
import tomllib

import data_rows
import designs
from page_tables import paper
from page_tables.cells import key_of
from study import STUDIES


def choices():
    return tomllib.loads((STUDIES / "readings/open_choices.toml").read_text())["choice"]


def screen(study):
    """The open choices that act without bodies, two readings each, in a fractional factorial design."""
    factors = [choice for choice in choices() if choice["screen"]]
    cells = []
    for number, levels in enumerate(designs.two_levels(len(factors))):
        name = f"screen/cell-{number:02}"
        second = [factor for factor, level in zip(factors, levels) if level]
        settings = [part for choice in second for setting in choice["second"] for part in ("--set", setting)]
        study.replicates("trophic-readings", name, "--backend", "kinematic", *settings, count=10)
        study.forget(name)
        cells.append((levels, designs.runs_of(study.out / "analysis" / name / "metrics.csv")))
    names = [factor["name"] for factor in factors]
    study.write("screen_cells", designs.cell_rows(names, cells))
    study.write("screen_effects", designs.effect_rows(names, cells))


def ranges(study):
    """The parent's range and activity, and the distance of activation, in a grid."""
    rows, values = [], []
    for reading in ("first", "second"):
        for distance_m in (5,) if study.quick else (5, 2):
            for range_m in (4, 12) if study.quick else (4, 6, 8, 10, 12, 16, 30):
                name = f"ranges/{reading}-{range_m}-{distance_m}"
                study.replicates(
                    "trophic-readings",
                    name,
                    "--backend",
                    "kinematic",
                    "--set",
                    f"rules.parent.starved.reading={reading}",
                    "--set",
                    f"rules.parent.starved.{reading}.range_m={range_m}",
                    "--set",
                    f"rules.activation.first.distance_m={distance_m}",
                    count=10,
                )
                summary = json.loads((study.out / "analysis" / name / "summary.json").read_text())
                cell = {
                    "parent": "active" if reading == "first" else "any",
                    "range_m": range_m,
                    "activation_m": distance_m,
                    "flee": next(
                        (row["answer"] for row in data_rows.answer_rows(summary) if "flee" in row["question"]), ""
                    ),
                }
                orphans = designs.orphans(study.out / "runs" / name)
                rows += [
                    {**cell, **row, "parent_found": orphans}
                    for row in data_rows.set_rows(name, summary)
                    if key_of(row) in paper.GRID
                ]
                values += study.runs_of(name, paper.GRID)
                study.forget(name)
    study.write("ranges", rows)
    study.write("ranges_runs", values)


def table_on(backend, table, count):
    def stage(study):
        name = f"{backend}-{table}"
        summary = study.replicates("trophic-predator-prey", name, "--backend", backend, "--rules", table, count=count)
        study.write(f"{backend}_{table}", data_rows.set_rows(name, summary))
        study.write(f"{backend}_{table}_answers", data_rows.answer_rows(summary))
        published = data_rows.claim_rows(study.published(name))
        study.write(f"{backend}_{table}_published", published)
        keys = {*paper.AGAINST_SHADOW, *((row["metric"], row["species"], row["group"]) for row in published)}
        study.write(f"{backend}_{table}_runs", study.runs_of(name, keys, ("", "-published")))
        study.figures(
            name,
            {
                figure: f"{backend}_{table}_{figure}"
                for figure in ("attribution", "velocity", "wall_sticking", "tag_symmetry", "population")
            },
        )

    return stage


# Swaps in `paper` on MuJoCo: choices of the screening design, and other possible causes of slow predators.
ON_BODIES = {
    "paper": [],
    "any prey is a parent": ["rules.parent.starved.reading=second"],
    "active from 2 m on": ["rules.activation.first.distance_m=2"],
    "biases": ["rules.brain.reading=second"],
    "heading by yaw": ["rules.heading.reading=second"],
    "step 0.012 s, RK4": ["physics.timestep_s=0.012", "physics.integrator=rk4"],
}


def bodies(study):
    """Some choices alone in `paper` on MuJoCo."""
    rows, values = [], []
    for name, assignments in ON_BODIES.items():
        sets = [part for assignment in assignments for part in ("--set", assignment)]
        rows += data_rows.set_rows(
            name,
            study.replicates(
                "trophic-readings",
                "bodies/" + name.replace(" ", "-").replace(",", ""),
                "--backend",
                "mujoco",
                *sets,
                count=6,
                duration_s=3000,
                shadow=False,
            ),
        )
        values += study.runs_of("bodies/" + name.replace(" ", "-").replace(",", ""), paper.GRID, called=name)
        study.write("bodies", rows)
        study.write("bodies_runs", values)


def walls(study):
    """Possible causes of predators at walls in `released` on MuJoCo: friction, the gait's phase at birth, the length of a tick."""
    rows, values = [], []
    for name, friction, assignments in (
        ("released", None, []),
        ("friction 0.6", 0.6, []),
        ("friction 1.5", 1.5, []),
        ("gait reset at birth", None, ["ecology.phase_at_birth=reset"]),
        ("ticks of 2.014 s", None, ["ecology.tick_s=2.013888888888889"]),
    ):
        if friction is not None:
            assignments = [
                f"ecology.robot={study.with_friction('robots/spider_released', friction)}",
                f"ecology.arena={study.with_friction('arenas/height_field', friction)}",
            ]
        sets = [part for assignment in assignments for part in ("--set", assignment)]
        rows += data_rows.set_rows(
            name,
            study.replicates(
                "trophic-predator-prey",
                "walls/" + name.replace(" ", "-"),
                "--backend",
                "mujoco",
                "--rules",
                "released",
                *sets,
                count=6,
                duration_s=3000,
                shadow=False,
            ),
        )
        values += study.runs_of("walls/" + name.replace(" ", "-"), paper.GRID, called=name)
        study.write("walls", rows)
        study.write("walls_runs", values)


def ablations(study):
    """`paper` and `released`, each with every rule of the other, without bodies: two sweeps, each analysed against its first cell."""
    rows = []
    for table, other in (("paper", "released"), ("released", "paper")):
        name = f"ablations/from_{table}"
        sweep, runs = STUDIES / f"ablations/from_{table}.toml", study.out / "runs" / name
        if study.quick:
            text = sweep.read_text().replace("replicates = 10", "replicates = 6").replace("6000.0", "300.0")
            sweep = study.out / f"ablations_from_{table}.toml"
            sweep.write_text(text)
        study.sweep("trophic-ablations", sweep, runs)
        made = study.made(
            name, "sweep_differences.csv", "trophic", "analyze", runs, "--reference", 0, "--jobs", study.jobs
        )
        rows += designs.swap_rows(table, other, made.parent)
    study.write("ablations", rows)


SWEPT = [
    "velocity:prey:inherited",
    "velocity:predator:inherited",
    "attribution_credited:predator",
    "attribution_caught:prey",
    "tag_symmetry:prey+predator:inherited",
    "wall_sticking_gap:prey-predator:all",
]


def inheritance(study):
    """Reach, mutation and the share of random genomes over a grid, without bodies."""
    runs, analysis = study.out / "runs/inheritance", study.out / "analysis/inheritance"
    if not analysis.exists():
        sweep = STUDIES / "sweeps/inheritance.toml"
        if study.quick:
            short = (
                sweep.read_text()
                .replace("replicates = 10", "replicates = 2")
                .replace("[grid]", "[set]\necology.duration_s = 200.0\n\n[grid]")
            )
            sweep = study.out / "inheritance.toml"
            sweep.write_text(short)
        study.sweep("trophic-predator-prey", sweep, runs)
        study.call("trophic", "analyze", runs, "--reference", 28, "--metric", *SWEPT, "--out", analysis)
    study.write("inheritance", designs.sweep_rows(analysis / "sweep_effects.csv"))


STAGES = {
    "kinematic-paper": table_on("kinematic", "paper", 30),
    "kinematic-released": table_on("kinematic", "released", 30),
    "ranges": ranges,
    "screen": screen,
    "mujoco-paper": table_on("mujoco", "paper", 10),
    "mujoco-released": table_on("mujoco", "released", 6),
    "bodies": bodies,
    "walls": walls,
    "ablations": ablations,
    "inheritance": inheritance,
}
