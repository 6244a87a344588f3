# SPDX-License-Identifier: MIT
"""Stages of mating zones."""
import data_rows
import numpy
import page_tables.zones
import zones


def zone_runs(study, name, engine, number, offspring, assignments, **how):
    """The rows of the runs of `mating_zones` with these parameters; the runs are deleted then."""
    kept = study.out / f"analysis/{study.stage}/{name}.csv"
    name = f"{study.stage}/{name}"
    if not kept.exists():
        changes = [f"rules.resource.zones={number}", f"rules.recruitment.offspring={offspring}", *assignments]
        sets = [part for assignment in changes for part in ("--set", assignment)]
        runs = study.make("trophic-worlds", name, "--backend", engine, "--rules", "mating_zones", *sets, **how)
        kept.parent.mkdir(parents=True, exist_ok=True)
        data_rows.write(kept, zones.values_of(runs))
        study.forget(name)
    study.note(name)
    return data_rows.read(kept)


def mating_zones(study):
    """The number of zones at which extinction changes to explosion, with robots on a torus and without robots."""
    counts, rng = [], numpy.random.default_rng(1)
    for robots, offspring, numbers in zones.ZONES:
        for number in numbers[:2] if study.quick else numbers:
            cell = {"robots": robots, "offspring": offspring, "zones": number}
            if robots == "mean field":
                found = [zones.mean_field(rng, number, offspring)[0] for _ in range(10 if study.quick else 100)]
                counts.append({**cell, **zones.counts_of(found)})
                continue
            rows = zone_runs(
                study,
                f"{robots}-{offspring}-{number}",
                "torus",
                number,
                offspring,
                zones.STANDING if robots == "standing" else zones.ON_TORUS,
                count=30,
                seed=1,
                shadow=robots == "walking",
            )
            for null, name in (("", robots), ("shadow", "walking, nothing inherited")):
                if found := [row["outcome"] for row in rows if row["null"] == null]:
                    counts.append({**cell, "robots": name, **zones.counts_of(found)})
            study.write("mating_zones_counts", counts)
            study.write("mating_zones_critical", zones.critical_rows(counts))
    page_tables.zones.draw(counts, study.data.parent / "mating_zones_critical.png")


def zone_rules(name, seed, rules):
    """Each rule alone and both, at three numbers of zones, on a torus: which makes runs last, with progress over the shadow?"""

    def stage(study):
        rows = []
        for rule, offspring in rules:
            for number in zones.TRIED[:1] if study.quick else zones.TRIED:
                set_name = f"{rule.replace(' ', '-').replace(',', '')}-{offspring}-{number}"
                values = zone_runs(
                    study,
                    set_name,
                    "torus",
                    number,
                    offspring,
                    [*zones.RULES[rule], *zones.ON_TORUS],
                    senses=True,
                    shadow=rule in zones.LASTING,
                    count=30,
                    seed=seed,
                )
                rows.append(zones.cell_rows(set_name, rule, offspring, number, values))
                study.write(name.replace("-", "_"), zones.with_answers([dict(row) for row in rows]))

    return stage


def mating_zones_mujoco(study):
    """The same rules with bodies between walls, where newborns appear next to a parent."""
    rows = []
    for rule in list(zones.RULES)[:4]:
        for number in zones.TRIED:
            set_name = f"{rule.replace(' ', '-')}-{number}"
            assignments = [*zones.RULES[rule], "rules.recruitment.step_m=0"]
            values = zone_runs(
                study,
                set_name,
                "mujoco",
                number,
                1,
                assignments,
                senses=True,
                shadow=rule in zones.LASTING,
                count=6,
                seed=1,
            )
            rows.append(zones.cell_rows(set_name, rule, 1, number, values))
            study.write("mating_zones_mujoco", zones.with_answers([dict(row) for row in rows]))


STAGES = {
    "mating-zones": mating_zones,
    "mating-zones-rules": zone_rules("mating-zones-rules", 1, zones.TRIED_RULES),
    "mating-zones-again": zone_rules("mating-zones-again", 2001, zones.AGAIN),
    "mating-zones-mujoco": mating_zones_mujoco,
}
