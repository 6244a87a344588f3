# SPDX-License-Identifier: MIT
"""Stages of what evolves: brains, gaits, bodies, and how selection acts on behaviour."""
import tomllib

import designs
import evolution_rows
from study import STUDIES


def selection(study):
    """Where selection acts on turning to the adversary in `paper` without bodies, over the shadow and the neutral null."""
    velocities = ("velocity:prey:inherited", "velocity:predator:inherited")
    study.replicates(
        "trophic-predator-prey",
        "selection",
        "--backend",
        "kinematic",
        "--rules",
        "paper",
        "--neutral",
        count=60,
        only=velocities,
    )
    distances = (f"turns_to:{distance}" for distance in ("0.05", "0.15", "0.25", "0.35", "0.45"))
    study.write("selection", study.selection("selection", "turns_to", *distances))


def evolving_sets(study, sweep, again="", **other):
    """Runs both tables of a sweep of bodies as sets, and analyses their difference. Returns the folder of the analysis and the sets'."""
    plan, name = tomllib.loads((STUDIES / f"bodies/{sweep}.toml").read_text()) | other, sweep + again
    settings = dict(designs.flat(plan["set"]))
    duration_s = settings.pop("ecology.duration_s")
    has_neutral = plan["engine"] == "kinematic"
    options = [
        "--backend",
        plan["engine"],
        "--agents-every",
        plan["agents_every"],
        *(part for key, value in settings.items() for part in ("--set", f"{key}={value}")),
    ]
    tables = plan["grid"]["rule_table"]
    for table in tables:
        neutral = ["--neutral"] if has_neutral and table == tables[0] else []
        study.replicates(
            "trophic-bodies",
            f"evolution/{name}-{table}",
            *options,
            *neutral,
            "--rules",
            table,
            count=plan["replicates"],
            duration_s=duration_s,
            seed=plan["seed"],
            shadow=plan["shadow"] and table == tables[0],
        )
    analysis = study.out / f"analysis/evolution/{name}-bodies"
    ours, survival = folders = [study.out / f"runs/evolution/{name}-{table}" for table in tables]
    for kind, compared in (
        ("means", [ours]),
        ("differences", ["--compare", survival, ours]),
        ("neutral", ["--compare", ours / "neutral", ours]),
    ):
        if kind == "neutral" and not has_neutral:
            continue
        study.made(f"evolution/{name}-bodies/{kind}", "summary.json", "trophic", "analyze", "--bodies", *compared)
    return analysis, folders


def evolution(study):
    """Brains, gaits and bodies that evolve, over survival alone and over the shadow: the sweeps of bodies, as sets."""
    evolved, lives = [], []
    for name in ("brains", "gaits", "bodies"):
        analysis, folders = evolving_sets(study, name)
        drawn = ("measures", "morphospace", "plans") if name == "bodies" else ("measures",)
        study.figures(
            f"evolution/{name}-bodies/differences", {figure: f"evolution_{name}_{figure}" for figure in drawn}
        )
        neutral = analysis / "neutral/differences.csv"
        evolved += evolution_rows.evolved_rows(
            name,
            analysis / "differences/differences.csv",
            analysis / "means/means.csv",
            neutral if neutral.exists() else None,
        )
        lives += [
            {"study": name, "table": folder.name.removeprefix(f"{name}-"), **evolution_rows.lives_of(folder)}
            for folder in folders
        ]
        study.write("evolution", evolved)
        study.write("evolution_lives", lives)


def evolution_again(study):
    """The one measure that the runs of evolving bodies suggested, in runs of other seeds."""
    analysis, _ = evolving_sets(study, "bodies", "_again", replicates=14, seed=1001, shadow=False)
    study.write("evolution_again", evolution_rows.walked_rows(analysis / "differences/differences.csv"))


def evolvable_bodies(study):
    """Slow bodies and gaits that mutate little, with their neutral null: where selection acts on their speed away from walls."""
    study.replicates(
        "trophic-bodies",
        "evolvable-bodies",
        "--config",
        STUDIES / "bodies/evolvable.toml",
        "--neutral",
        "--agents-every",
        2,
        count=6,
        duration_s=5000,
        shadow=False,
    )
    generations = evolution_rows.generations_of(study.out / "runs/evolvable-bodies")
    study.write(
        "evolvable_bodies",
        [
            {**row, "generations": generations[row["species"]]}
            for row in study.selection("evolvable-bodies", "open_speed")
        ],
    )


STAGES = {
    "selection": selection,
    "evolution": evolution,
    "evolution-again": evolution_again,
    "evolvable-bodies": evolvable_bodies,
}
