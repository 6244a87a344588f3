# SPDX-License-Identifier: MIT
"""Stages of growth at the end of long runs."""
import pickle

import open_ended
import page_tables.open_ended
import ponds


def open_ended_cell(study, cell, seed, count):
    """The curves of a cell of the two by two and the values of its runs, which are deleted once measured."""
    name = f"{study.stage}/{seed}-{cell.replace(', ', '-').replace(' ', '-')}"
    kept, met = study.out / f"analysis/{name}.pickle", study.out / f"runs/{study.stage}/senses"
    if not kept.exists():
        if not met.exists():
            met.parent.mkdir(parents=True, exist_ok=True)
            options = ["--backend", "kinematic", "--seed", 9001, "--duration", 1000, "--replay-hz", 0, "--senses"]
            study.call("trophic-open-ended", *options, "--out", met)
        settings = ["ecology.ends_when=a_species_is_gone", *open_ended.CELLS.get(cell, [])]
        sets = [part for setting in settings for part in ("--set", setting)]
        table = "growing_race_two_foods" if cell == open_ended.TWO_FOODS else "growing_race"
        options = ["--backend", "kinematic", "--rules", table, "--neutral", "--agents-every", 1000, *sets]
        how = {"count": count, "duration_s": 30000, "seed": seed, "shadow": False}
        folder = study.make("trophic-open-ended", name, *options, **how)
        found = open_ended.measured(cell, folder, study.program("trophic-open-ended"), met)
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_bytes(pickle.dumps(found))
        study.forget(name)
    study.note(name)
    return pickle.loads(kept.read_bytes())


def open_ended_stage(study):
    """The race's pond with brains that grow, in small and large space, with low and high limits, and with two foods, each run with its neutral null."""
    curves, rows = [], []
    for cell in dict.fromkeys([open_ended.BOTH, *open_ended.CELLS, open_ended.TWO_FOODS]):
        found, values = open_ended_cell(study, cell, 101, 14 if cell.startswith("small") else 10)
        curves += found
        rows += values + open_ended.ends_of(found)
        means = open_ended.means_of(curves)
        study.write("open_ended_runs", rows)
        study.write("open_ended_curves", means)
        study.write("open_ended", open_ended.results(rows))
        page_tables.open_ended.draw_two_by_two(means, study.data.parent / "open_ended_curves.png")


def open_ended_again(study):
    """The cell with two foods again, on fresh seeds."""
    found, values = open_ended_cell(study, open_ended.TWO_FOODS, 201, 10)
    rows = values + open_ended.ends_of(found)
    study.write("open_ended_again_runs", rows)
    study.write("open_ended_again", open_ended.results_of_foods(ponds.Values(rows)))


STAGES = {"open-ended": open_ended_stage, "open-ended-again": open_ended_again}
