# SPDX-License-Identifier: MIT
"""Stages of the pond, in which energy alone decides births."""
import data_rows
import page_tables.ponds
import ponds
from stages.races import progress_rows


# Settings of the pond: rule table and parameters.
PONDS = {
    "pond": ["pond"],
    "refuges": ["pond_with_refuges"],
    "reach 1.6 m": ["pond", "rules.capture.reach_m=1.6"],
    "floor and rescue": ["pond_with_conditions", "rules.floor.floor=7", "rules.minimum_predators.below=7"],
    "prey escape before a birth": ["pond_with_conditions", "rules.recruitment.escapes=1"],
    "predators 1.3 times as fast": ["pond_with_conditions", "rules.pace.predator.factor=1.3"],
}


def pond_progress(study, name, duration_s, program):
    """Rows of early and late progress, over the shadow, of the runs in which both species live on."""
    runs, end_s = study.out / "runs" / name, duration_s // 20 if study.quick else duration_s
    living = [runs / run for run in ponds.persisting(study.out / "analysis" / name / "metrics.csv")]
    return progress_rows(
        study,
        name,
        living,
        {"cell": "pond"},
        [0, end_s // 2, end_s],
        "--team-size",
        10,
        "--shadow",
        runs / "shadow",
        "--duration",
        10 if study.quick else 300,
        program=program,
    )


def four_world(study, world, engine, *nulls, **how):
    """The runs of one of the four worlds of the pond with their one-sided worlds and other nulls. Returns their folder."""
    table, *changes = ponds.WORLDS[world]
    return study.make(
        "trophic-worlds",
        f"{study.stage}/{world.replace(' ', '-')}",
        *("--backend", engine, "--rules", table),
        *(part for change in changes for part in ("--set", change)),
        *("--one-sided", *nulls, "--agents-every", 6),
        **how,
        seed=101,
    )


def no_criterion(study):
    """Four worlds of the pond, each with its one-sided worlds, neutral null and shadow: values of single runs, and what they say."""
    runs, terms = [], []
    for world in ponds.WORLDS:
        folder = four_world(study, world, "kinematic", "--neutral", count=30, duration_s=12000)
        runs += ponds.values_of(world, folder)
        terms += ponds.term_values(world, folder)
    end_s = 600 if study.quick else 12000
    results = ponds.results(runs, end_s)
    study.write("no_criterion_runs", runs)
    study.write("no_criterion", results)
    study.write("no_criterion_selection_runs", terms)
    study.write("no_criterion_selection", ponds.selected(ponds.Values(terms)))
    page_tables.ponds.draw_worlds(results, runs, end_s, study.data.parent / "no_criterion_worlds.png")


def no_criterion_age_mujoco(study):
    """The pond with bodies in which age protects the newborn, and its one-sided worlds."""
    folder = four_world(study, ponds.BY_AGE, "mujoco", count=6, duration_s=4000, shadow=False)
    runs = ponds.values_of(ponds.BY_AGE, folder)
    values = ponds.Values(runs)
    study.write("no_criterion_age_mujoco_runs", runs)
    study.write("no_criterion_age_mujoco", [*ponds.evolved(values, [ponds.BY_AGE]), *ponds.described(values)])


def no_criterion_settings(study):
    """Settings of the pond with their shadow, and contests of the pond. Contests leave out runs in which a species is gone."""
    rows = []
    for name, (table, *changes) in PONDS.items():
        summary = study.replicates(
            "trophic-worlds",
            "no-criterion-settings/" + name.replace(" ", "-"),
            "--backend",
            "kinematic",
            "--rules",
            table,
            *(part for change in changes for part in ("--set", change)),
            *(["--clones"] if name == "pond" else []),
            "--agents-every",
            6,
            count=30,
            duration_s=12000,
        )
        rows += ponds.living_rows(name, summary)
        study.write("no_criterion_settings", rows)
    study.write("no_criterion_progress", pond_progress(study, "no-criterion-settings/pond", 12000, "trophic-worlds"))


def no_criterion_mujoco(study):
    """`pond` with bodies, and its shadow."""
    study.write(
        "no_criterion_mujoco",
        ponds.living_rows(
            "pond",
            study.replicates(
                "trophic-worlds",
                "no-criterion-mujoco",
                "--backend",
                "mujoco",
                "--rules",
                "pond",
                "--agents-every",
                6,
                count=10,
                duration_s=12000,
            ),
        ),
    )


def evolving_pond(name, rate):
    """`evolving_pond` with this mutation of bodies, its shadow, selection on speed away from walls, and contests."""

    def stage(study):
        rates = [
            part for species in ("prey", "predator") for part in ("--set", f"rules.body_plan.{species}.rate={rate}")
        ]
        file, options = name.replace("-", "_"), [
            "--backend",
            "mujoco",
            "--rules",
            "evolving_pond",
            "--set",
            "physics.timestep_s=0.002",
        ]
        summary = study.replicates(
            "trophic-bodies", name, *options, *rates, "--agents-every", 6, count=8, duration_s=4000
        )
        study.write(file, ponds.living_rows("pond", summary))
        study.write(f"{file}_selection", [row for row in study.selection(name, "open_speed") if row["p"]])
        study.write(f"{file}_progress", pond_progress(study, name, 4000, "trophic-bodies"))

    return stage


def atlas(study):
    """Persistence and evolution of `pond` over the reach of predators and the growth of food, with shadows."""
    runs, sweep, (count, duration_s) = (
        study.out / "runs/atlas",
        study.out / "atlas.toml",
        (2, 300) if study.quick else (10, 6000),
    )
    sweep.write_text(
        f"rule_table = 'pond'\nengine = 'kinematic'\nreplicates = {count}\nseed = 1\nshadow = true\nagents_every = 6\n"
        f"set.ecology.duration_s = {duration_s}.0\ngrid.rules.capture.reach_m = [0.4, 0.7, 1.0, 1.3, 1.6, 2.0]\n"
        "grid.rules.resource.growth_1_s = [0.0015, 0.003, 0.006, 0.012, 0.024]\n"
    )
    study.sweep("trophic-worlds", sweep, runs)
    study.write(
        "atlas",
        ponds.atlas_rows(
            study.made(
                "atlas",
                "sweep_metrics.csv",
                "trophic",
                "analyze",
                runs,
                "--metric",
                "persists:all",
                "velocity:predator:inherited",
                "velocity:prey:inherited",
            ).parent
        ),
    )
    page_tables.ponds.draw_atlas(data_rows.read(study.data / "atlas.csv"), study.data.parent / "no_criterion_atlas.png")


STAGES = {
    "no-criterion": no_criterion,
    "no-criterion-settings": no_criterion_settings,
    "no-criterion-age-mujoco": no_criterion_age_mujoco,
    "no-criterion-mujoco": no_criterion_mujoco,
    "no-criterion-gaits": evolving_pond("no-criterion-gaits", 0.0),
    "no-criterion-bodies": evolving_pond("no-criterion-bodies", 0.1),
    "atlas": atlas,
}
