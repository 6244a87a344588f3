# SPDX-License-Identifier: MIT
"""The module that steps ecologies: the same bytes as a program's run, what is refused, agents that come and go, files, threads."""
from __future__ import annotations

import json
import os
import pathlib
import re
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


TORUS = ("wolf_sheep", "rosenzweig_macarthur", "lotka_volterra")
#: Few robots, for engines that are slow.
FEW = {
    "pond": {"rules.recruitment.spare_bodies": 10, "rules.community.predators": 6},
    "pond_with_refuges": {"rules.recruitment.spare_bodies": 10, "rules.community.predators": 6},
    "pond_with_conditions": {"rules.recruitment.energy.spare_bodies": 10, "rules.community.predators": 6},
    "pond_race": {"rules.recruitment.spare_bodies": 10, "rules.community.predators": 6},
    "two_foods": {"rules.recruitment.spare_bodies": 10, "rules.community.predators": 6},
    "mating_zones": {"rules.recruitment.spare_bodies": 10},
    "food_chain": {
        "rules.recruitment.grazer.spare_bodies": 10,
        "rules.community.hunters": 8,
        "rules.community.apex": 4,
    },
}
RUNS = [
    (table, engine)
    for table in trophic_ecologies.rule_tables()
    for engine in (("torus",) if table in TORUS else ("kinematic", "mujoco", "ode"))
]
DURATIONS_S = {"torus": 30, "kinematic": 200, "mujoco": 40, "ode": 6}


@pytest.mark.parametrize("table,engine", RUNS)
def test_own_brains_give_the_bytes_of_a_programs_run(tmp_path, table, engine):
    settings = {"ecology.duration_s": DURATIONS_S[engine]}
    if engine in ("mujoco", "ode") and table in FEW:
        settings |= {"ecology.robots": 40, **FEW[table]}
    try:
        ecology = started({"rule_table": table, "engine": engine, "seed": 3, **settings}, out=tmp_path / "stepped")
    except ValueError as error:
        if "engine" not in str(error):
            raise
        pytest.skip(str(error))  # an engine that was not built
    assert run_by_its_own(ecology) >= 4
    program = [os.environ["TROPHIC_PREDATOR_PREY" if table in ("paper", "released") else "TROPHIC_WORLDS"]]
    program += ["--rules", table, "--backend", engine, "--seed", "3", "--out", tmp_path / "program"]
    for path, value in settings.items():
        program += ["--set", f"{path}={value}"]
    subprocess.run(program, check=True, stdout=subprocess.DEVNULL)
    assert tables_in(tmp_path / "program") == tables_in(tmp_path / "stepped")
    assert len(tables_in(tmp_path / "stepped")) >= 4


def test_the_manifest_of_a_run_that_is_decided_from_outside(tmp_path):
    run_by_its_own(started(PAPER, out=tmp_path / "stepped"))
    manifest = json.loads((tmp_path / "stepped" / "manifest.json").read_text())
    assert manifest["status"] == "complete"
    assert manifest["description"]["name"] == "paper with brain = outside"
    assert manifest["rules"]["brain"] == "outside"
    assert len(manifest["decisions"]) == 16
    with pytest.raises(ValueError, match="exists already; runs are never overwritten"):
        started(PAPER, out=tmp_path / "stepped")
    program = [os.environ["TROPHIC_PREDATOR_PREY"], "--backend", "kinematic", "--duration", "200", "--resume", "--out"]
    resumed = subprocess.run([*program, tmp_path / "stepped"], capture_output=True, text=True)
    assert resumed.returncode == 2 and "paper with brain = outside" in resumed.stderr


def test_runs_are_analysed_compared_shown_and_cited_as_any_others(tmp_path):
    for side, turn in (("left", -1.0), ("right", 1.0)):
        for seed in range(6):
            ecology = started({**PAPER, "seed": seed}, out=tmp_path / side / f"replicate-0{seed}")
            while ecology.sense():
                outputs = ecology.own_outputs()
                outputs[ecology.species == 0, 0] = turn
                ecology.decide(outputs)
        listed = {"replicates": [{"folder": f"replicate-0{seed}", "seed": seed} for seed in range(6)]}
        (tmp_path / side / "replicates.json").write_text(json.dumps(listed))
    analyzed = trophic("analyze", tmp_path / "left", "--out", tmp_path / "analysis")
    assert "6 runs of 200 s" in analyzed and "paper with brain = outside" in analyzed
    compared = trophic("analyze", "--compare", tmp_path / "left", tmp_path / "right", "--out", tmp_path / "differences")
    assert compared.count("6 runs of 200 s") == 2
    cited = trophic("cite", tmp_path / "right")
    assert "6 runs of 200 s on kinematic" in cited and "the rule table `paper with brain = outside`" in cited
    trophic("show", tmp_path / "left" / "replicate-00", "-o", tmp_path / "run.html")
    assert (tmp_path / "run.html").stat().st_size > 100_000


def trophic(*command) -> str:
    program = [os.environ["TROPHIC_PROGRAM"], *map(str, command)]
    return subprocess.run(program, check=True, capture_output=True, text=True).stdout


def test_other_decisions_have_another_hash(tmp_path):
    hashes = []
    for turn in (1.0, 1.0, -1.0):
        folder = tmp_path / str(len(hashes))
        ecology = started(PAPER, out=folder)
        while ecology.sense():
            ecology.decide(numpy.full((len(ecology.ids), 2), turn))
        hashes.append(json.loads((folder / "manifest.json").read_text())["decisions"])
    assert hashes[0] == hashes[1] != hashes[2]


def test_a_run_that_was_stopped_resumes_to_the_same_bytes(tmp_path):
    run_by_its_own(started(PAPER, out=tmp_path / "whole"))
    with started(PAPER, out=tmp_path / "parts") as first:
        assert run_by_its_own(first, ticks=40) == 40
    assert json.loads((tmp_path / "parts" / "manifest.json").read_text())["status"] == "stopped"
    assert run_by_its_own(started(PAPER, out=tmp_path / "parts", resume=True)) == 61
    assert tables_in(tmp_path / "whole") == tables_in(tmp_path / "parts")
    decisions = [
        json.loads((tmp_path / name / "manifest.json").read_text())["decisions"] for name in ("whole", "parts")
    ]
    assert decisions[0] == decisions[1]


def test_a_run_that_was_closed_while_robots_wait_resumes_to_the_same_bytes(tmp_path):
    run_by_its_own(started(PAPER, out=tmp_path / "whole"))
    with started(PAPER, out=tmp_path / "parts") as stopped:
        run_by_its_own(stopped, ticks=40)
    again = started(PAPER, out=tmp_path / "parts", resume=True)
    run_by_its_own(again, ticks=5)
    assert again.sense()
    again.close()
    with pytest.raises(RuntimeError, match="^the ecology has no run: call reset first$"):
        again.decide(numpy.zeros((30, 2)))
    assert run_by_its_own(started(PAPER, out=tmp_path / "parts", resume=True)) == 61
    assert tables_in(tmp_path / "whole") == tables_in(tmp_path / "parts")


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


def test_the_program_of_the_how_to(tmp_path, monkeypatch):
    page = pathlib.Path(__file__).parents[2] / "docs/how-to/my-program.md"
    (program,) = re.findall(r"```python\n(.*?)```", page.read_text(), re.DOTALL)
    monkeypatch.chdir(tmp_path)
    exec(program, {})
    assert json.loads((tmp_path / "runs/outside/manifest.json").read_text())["status"] == "complete"


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
        living = ecology.individuals()
        assert set(living["id"].tolist()) == alive
        assert set(ecology.ids.tolist()) <= alive
        assert (living["energy_J"] > 0.0).any()
        assert (numpy.abs(living["x_m"]) <= ecology.half_side_m).all()
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
    with pytest.raises(TypeError, match="^outputs = 'left': must be an array of numbers$"):
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
        ({**PAPER, "rules.mutation.sd": float("nan")}, "^rules.mutation.sd = nan: must be finite$"),
        (
            {**PAPER, "rules": {"mutation": {"sd": None}}},
            "^rules.mutation.sd = None: must be a number, a text, True or ",
        ),
        ({**PAPER, "seed": 2**64}, "^seed = 18446744073709551616: must be "),
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


def resident_kB() -> int:
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") // 1024


def test_many_steps_and_runs_leave_no_memory():
    small = {"robots": 6, "duration_s": 1e7}
    description = {**PAPER, "ecology": small, "rules.community.predators": 3, "rules.floor.floor": 1}
    ecology = started({**description, "rules.minimum_predators.below": 1})
    outputs = numpy.ones((6, 2))

    def steps(number: int) -> int:
        for _ in range(number):
            assert ecology.sense()
            ecology.decide(outputs)
        return resident_kB()

    before = steps(5_000)
    assert steps(100_000) - before < 2000
    for _ in range(20):
        ecology.reset()
        steps(2)
    before = resident_kB()
    for _ in range(200):
        ecology.reset()
        steps(2)
    assert resident_kB() - before < 2000
