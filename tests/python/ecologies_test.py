# SPDX-License-Identifier: MIT
"""The module that steps ecologies: the same bytes as a program's run, what is refused, agents that come and go, files, threads."""
from __future__ import annotations

import json
import os
import pathlib
import subprocess
import threading

import numpy
import pytest

trophic_ecologies = pytest.importorskip(
    "trophic_ecologies", reason="the module was not built: apt-get install pybind11-dev python3-dev"
)

PAPER = {"rule_table": "paper", "engine": "kinematic", "seed": 3, "ecology": {"duration_s": 200.0}}
POND = {"rule_table": "pond", "engine": "kinematic", "seed": 1, "ecology.duration_s": 300.0}


def started(description: dict, **options) -> trophic_ecologies.Ecology:
    ecology = trophic_ecologies.Ecology(description)
    ecology.reset(**options)
    return ecology


def run_by_its_own(ecology: trophic_ecologies.Ecology, ticks: int | None = None) -> int:
    """Decides by the brains of the table; returns the number of ticks."""
    count = 0
    while count != ticks and ecology.sense():
        ecology.decide(ecology.own_outputs())
        count += 1
    return count


def tables_in(folder: pathlib.Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.suffix == ".csv"}


def test_own_brains_give_the_bytes_of_a_programs_run(tmp_path):
    program = os.environ["TROPHIC_PREDATOR_PREY"]
    options = ["--backend", "kinematic", "--seed", "3", "--duration", "200", "--out", tmp_path / "program"]
    subprocess.run([program, *map(str, options)], check=True, stdout=subprocess.DEVNULL)
    assert run_by_its_own(started(PAPER, out=str(tmp_path / "stepped"))) == 101
    assert tables_in(tmp_path / "program") == tables_in(tmp_path / "stepped")
    assert len(tables_in(tmp_path / "stepped")) == 4
    manifest = json.loads((tmp_path / "stepped" / "manifest.json").read_text())
    assert manifest["status"] == "complete"
    assert manifest["description"]["name"] == "paper with brain = outside"
    assert manifest["rules"]["brain"] == "outside"
    assert len(manifest["decisions"]) == 16
    with pytest.raises(ValueError, match="exists already; runs are never overwritten"):
        started(PAPER, out=str(tmp_path / "stepped"))


def test_other_decisions_have_another_hash(tmp_path):
    hashes = []
    for turn in (1.0, 1.0, -1.0):
        folder = tmp_path / str(len(hashes))
        ecology = started(PAPER, out=str(folder))
        while ecology.sense():
            ecology.decide(numpy.full((len(ecology.ids), 2), turn))
        hashes.append(json.loads((folder / "manifest.json").read_text())["decisions"])
    assert hashes[0] == hashes[1] != hashes[2]


def test_a_run_that_was_stopped_resumes_to_the_same_bytes(tmp_path):
    run_by_its_own(started(PAPER, out=str(tmp_path / "whole")))
    first = started(PAPER, out=str(tmp_path / "parts"))
    assert run_by_its_own(first, ticks=40) == 40
    first.close()
    assert json.loads((tmp_path / "parts" / "manifest.json").read_text())["status"] == "stopped"
    assert run_by_its_own(started(PAPER, out=str(tmp_path / "parts"), resume=True)) == 61
    assert tables_in(tmp_path / "whole") == tables_in(tmp_path / "parts")
    decisions = [
        json.loads((tmp_path / name / "manifest.json").read_text())["decisions"] for name in ("whole", "parts")
    ]
    assert decisions[0] == decisions[1]


@pytest.mark.parametrize("table", trophic_ecologies.rule_tables())
def test_every_table_has_spaces_that_hold(table):
    ecology = started({"rule_table": table, "engine": "torus" if table in TORUS else "kinematic", "seed": 5})
    spaces = ecology.spaces
    assert list(spaces["inputs"]) == ecology.species_names
    for _ in range(20):
        assert ecology.sense()
        inputs, species = ecology.inputs, ecology.species
        assert inputs.shape[0] == len(species) == len(ecology.ids) == len(ecology.bodies) == len(ecology.genomes())
        for place, name in enumerate(ecology.species_names):
            own = inputs[species == place]
            for column, (_, _, least, most) in enumerate(spaces["inputs"][name]):
                assert ((least <= own[:, column]) & (own[:, column] <= most)).all()
        outputs = ecology.own_outputs()
        assert outputs.shape == (len(species), len(spaces["outputs"]))
        ecology.decide(outputs)


TORUS = ("wolf_sheep", "rosenzweig_macarthur", "lotka_volterra")


def test_who_lives_follows_from_births_and_deaths():
    ecology = started(POND)
    alive: set[int] = set()
    ever: set[int] = set()
    births = deaths = 0
    while ecology.sense():
        for tick, time_s, event, individual, species, other, cause in ecology.events():
            if event == "birth":
                assert individual not in ever
                assert other == -1 or other in ever
                ever.add(individual)
                alive.add(individual)
                births += 1
            if event == "death":
                assert cause != ""
                alive.remove(individual)
                deaths += 1
        everybody = ecology.individuals()
        assert set(everybody["id"].tolist()) == alive
        assert set(ecology.ids.tolist()) <= alive
        assert (everybody["energy_J"] > 0.0).any()
        assert (numpy.abs(everybody["x_m"]) <= ecology.half_side_m).all()
        ecology.decide(ecology.own_outputs())
    assert births > 30 and deaths > 0


def test_what_is_refused_is_one_sentence_and_loses_nothing():
    ecology = trophic_ecologies.Ecology(PAPER)
    with pytest.raises(RuntimeError, match="^the ecology has no run: call reset first$"):
        ecology.sense()
    ecology.reset()
    with pytest.raises(RuntimeError, match="^decide: no robot waits for a decision"):
        ecology.decide(numpy.zeros((30, 2)))
    assert ecology.sense()
    good = ecology.own_outputs()
    with pytest.raises(
        ValueError, match=r"^outputs of shape \(30, 3\): must be \(30, 2\), a row for each robot that waits$"
    ):
        ecology.decide(numpy.zeros((30, 3)))
    with pytest.raises(ValueError, match=r"^outputs: row 4, individual 4 \(\w+\): turn = nan: must be finite$"):
        bad = good.copy()
        bad[4, 0] = numpy.nan
        ecology.decide(bad)
    with pytest.raises(TypeError):
        ecology.decide("left")
    assert ecology.waits
    ecology.decide(good)
    rest = run_by_its_own(ecology)
    assert rest == 100
    assert (
        ecology.step_batch is not None
        and not ecology.sense()
        and len(ecology.ids) == 0
        and ecology.inputs.shape == (0, 3)
    )
    for description, sentence in (
        ({"rule_table": "papr"}, "^rule_table = papr: must be .*; did you mean paper\\?$"),
        ({**PAPER, "rules.mutation.sd": -1.0}, "^rules.mutation.sd = -1: must be "),
        ({**PAPER, "rules.mutation.sd": float("nan")}, "Out of range float values"),
    ):
        with pytest.raises(ValueError, match=sentence):
            trophic_ecologies.Ecology(description)


def test_step_batch_and_another_seed():
    ecology = started(PAPER)
    assert ecology.sense()
    inputs = ecology.inputs
    for _ in range(100):
        inputs = ecology.step_batch(ecology.own_outputs())
        assert inputs.shape == (30, 3)
    assert ecology.step_batch(ecology.own_outputs()).shape == (0, 3)
    assert ecology.time_s == 200.0
    ecology.reset(seed=4)
    assert ecology.time_s == 0.0 and ecology.description()["seed"] == 4
    ecology.close()


def test_two_threads_give_what_each_gives_alone():
    def final(ecology) -> bytes:
        run_by_its_own(ecology)
        return ecology.individuals()["x_m"].tobytes()

    alone = [final(started({**PAPER, "seed": seed})) for seed in (1, 2)]
    together = [b"", b""]

    def work(place: int) -> None:
        together[place] = final(started({**PAPER, "seed": place + 1}))

    threads = [threading.Thread(target=work, args=(place,)) for place in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert together == alone


def test_many_runs_leave_no_memory():
    import resource

    def peak_kb() -> int:
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    ecology = trophic_ecologies.Ecology({**PAPER, "ecology": {"duration_s": 40.0}})
    for _ in range(20):
        ecology.reset()
        run_by_its_own(ecology)
    before = peak_kb()
    for _ in range(200):
        ecology.reset()
        run_by_its_own(ecology, ticks=15)
    assert peak_kb() - before < 4000
