# SPDX-License-Identifier: MIT
"""The genomes of a run, forests of drift, and the inputs that brains met."""
import collections
import math
import re
import stat

import numpy
import pytest
from hand_written import write_run
from pytest import approx
from trophic import pool
from trophic.errors import RunError
from trophic.metrics import Measuring, drift
from trophic.metrics.drift import Descent, drift_of, read_descent, stream
from trophic.values import METRIC

ALIVE = math.inf


def descent(*rows):
    """(parents, birth_s, death_s, weight[, species]) each."""
    parents, births, deaths, weights, species = zip(*((*row, "prey")[:5] for row in rows))
    return Descent(
        list(range(len(rows))),
        numpy.array(births, float),
        numpy.array(deaths, float),
        list(species),
        [list(one) for one in parents],
        numpy.array(weights, float)[:, None],
        {"prey": 1, "predator": 1},
    )


def test_the_stream_is_that_of_the_program(monkeypatch):
    monkeypatch.setattr(drift, "_NULL_MODEL", 0)
    assert stream(0, 0)() == (0x16554D9ECA36314C >> 11) * 2.0**-53  # the published answer of Philox 4x64-10 to zeros


def test_parents_are_drawn_evenly_among_the_living_and_mutations_are_permuted():
    # 0 and 1 may be the parent of 5; 2 has died at its birth, 3 is of another species, 4 is born with it. 7 is a later root.
    run = descent(
        ([], 0, ALIVE, 0),
        ([], 0, ALIVE, 10),
        ([], 0, 5, 20),
        ([], 0, ALIVE, 30, "predator"),
        ([], 5, ALIVE, 40),
        ([0], 5, ALIVE, 0.5),
        ([5], 6, ALIVE, 0.25),
        ([], 7, ALIVE, 50),
    )
    parents, mutations, founders = (collections.Counter() for _ in range(3))
    for seed in range(2000):
        drifted = drift_of(run, ["prey", "predator"], stream(seed, 0))
        weights = drifted.weights[:, 0].tolist()
        (parent,) = drifted.parents[5]
        mutation = weights[5] - weights[parent]
        parents[parent] += 1
        mutations[round(mutation, 9)] += 1
        founders[tuple(weights[:3])] += 1
        assert weights[6] - weights[drifted.parents[6][0]] == approx(0.25 - mutation)
        assert (weights[3], weights[4] + weights[7], drifted.parents[4]) == (30, 90, [])
    assert parents.keys() == {0, 1} and parents[0] / 2000 == approx(0.5, abs=0.04)
    assert mutations.keys() == {0.5, -0.25} and mutations[0.5] / 2000 == approx(0.5, abs=0.04)
    assert len(founders) == 6 and all(count / 2000 == approx(1 / 6, abs=0.03) for count in founders.values())


def test_without_another_member_alive_parent_and_genome_are_kept():
    run = descent(([], 0, 5, 1.0), ([0], 5, ALIVE, 1.5))
    drifted = drift_of(run, ["prey"], stream(1, 0))
    assert drifted.parents == [[], [0]] and drifted.weights.tolist() == run.weights.tolist()


def test_two_parents_become_two_others_with_a_crossover_of_the_run():
    run = descent(([], 0, ALIVE, 1), ([], 0, ALIVE, 3), ([], 0, ALIVE, 9), ([0, 1], 5, ALIVE, 2.5))
    seen = set()
    for seed in range(100):
        drifted = drift_of(run, ["prey"], stream(seed, 0))
        a, b = drifted.parents[3]
        seen |= {a, b}
        assert a != b and drifted.weights[3, 0] == approx(0.5 + (drifted.weights[a, 0] + drifted.weights[b, 0]) / 2)
    assert seen == {0, 1, 2}


PHYLOGENY = "id,ancestor_list,ancestor_id,origin_time,destruction_time,species\n0,[none],0,0,20,prey\n5,[none],5,0,inf,predator\n7,[0],0,10,inf,prey\n"
GENOMES = "id,genome_id,time_s,w0,w1\n0,0,0,0.25,0.5\n5,5,0,1,\n7,7,10,3,4\n"
SENSES = "species,input0,input1\nprey,1,0.5\nprey,,\nprey,1,0.5\npredator,-1,\nprey,0,1\n"


def written(folder, **more):
    write_run(
        folder,
        until_s=40.0,
        **{
            "result": {"reached_s": 40.0},
            "senses": {"inputs": ["a", "b"]},
            "params": {"seed": 1},
            "files": {"phylogeny.csv": PHYLOGENY, "genomes.csv": GENOMES, "senses.csv": SENSES},
            **more,
        },
    )
    return pool.read_pooled(folder)


def test_a_run_has_individuals_in_the_order_of_births(tmp_path):
    of = read_descent(written(tmp_path / "run"))
    assert (of.ids, of.parents, of.species, of.sizes) == (
        [0, 5, 7],
        [[], [], [0]],
        ["prey", "predator", "prey"],
        {"prey": 2, "predator": 1},
    )
    assert of.weights.tolist() == [[0.25, 0.5], [1, 0], [3, 4]] and of.death_s.tolist() == [20, ALIVE, ALIVE]


@pytest.mark.parametrize(
    "change, why",
    [
        (
            {"rules": {"heredity": "shared_copy"}},
            "genomes.csv: rule heredity = shared_copy: must give each individual its own genome",
        ),
        (
            {"status": "running", "result": None},
            'manifest.json: status "running": phylogeny.csv lists living individuals only at the end of a run; resume the run',
        ),
        ({"genomes.csv": None}, "genomes.csv: is missing; lineage measures need the phylogeny and the genomes"),
        ({"genomes.csv": GENOMES.replace("5,5,0", "5,0,0")}, "a shared genome changes"),
        ({"genomes.csv": GENOMES[: -len("7,7,10,3,4\n")]}, "genomes.csv: has no genome of individual 7"),
        ({"genomes.csv": GENOMES[:-2]}, "genomes.csv: the last line is truncated"),
        (
            {"phylogeny.csv": PHYLOGENY.replace("[0],0,10", "[1],1,10")},
            "phylogeny.csv: id 7: its parent 1 was not born before it",
        ),
        (
            {"phylogeny.csv": PHYLOGENY.replace("[0],0,10,inf", "[0],0,-1,inf")},
            "id 7: origin_time = -1: must be >= 0 and <= 40, the run's end",
        ),
        ({"phylogeny.csv": PHYLOGENY.replace("10,inf", "41,inf")}, "id 7: origin_time = 41: must be >= 0 and <= 40"),
        (
            {"phylogeny.csv": PHYLOGENY.replace("10,inf", "10,9")},
            "id 7: destruction_time = 9: must be >= its origin_time, 10, and <= 40",
        ),
        (
            {"phylogeny.csv": PHYLOGENY.replace("7,[0],0", '7,"[0,]",0')},
            "id 7: ancestor_list = [0,]: must be [none] or its parents, as [7,9]",
        ),
        ({"phylogeny.csv": PHYLOGENY + "5,[none],5,10,inf,prey\n"}, "id 5: has two rows"),
    ],
)
def test_what_a_run_cannot_give_is_refused(tmp_path, change, why):
    files = {
        "phylogeny.csv": PHYLOGENY,
        "genomes.csv": GENOMES,
        **{name: text for name, text in change.items() if "." in name},
    }
    run = written(
        tmp_path / "run",
        files={name: text for name, text in files.items() if text is not None},
        **{name: value for name, value in change.items() if "." not in name},
    )
    with pytest.raises(RunError, match=re.escape(why)):
        read_descent(run)


def test_met_inputs_are_each_once_by_species(tmp_path):
    run = written(tmp_path / "run")
    prey, predator = drift.met_inputs([run])
    assert sorted(prey) == [[0.0, 1.0], [1.0, 0.5]] and predator == [[-1.0]] and len(drift.met_inputs([run], 1)[0]) == 1
    (tmp_path / "run/senses.csv").unlink()
    with pytest.raises(
        RunError, match="senses.csv: is missing; lineage measures need it from the first run: run with --senses"
    ):
        drift.met_inputs([run])


PROGRAM = """#!{python}
import json, struct, sys
with open(sys.argv[2], "rb") as file:
    head = json.loads(file.readline())
    for species, size in zip(head["species"], head["sizes"]):
        print(int(struct.unpack(f"<{{size}}d", file.read(8 * size))[0] > 2), 3 + species)
assert head["fingerprint"] == "aa" and len(head["inputs"]) == 2
"""


def test_a_program_says_of_which_types_the_genomes_are(tmp_path):
    import sys

    program = tmp_path / "program"
    program.write_text(PROGRAM.format(python=sys.executable))
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    run = written(tmp_path / "run")
    of = read_descent(run)
    (types, complexity), (again, _) = drift.ask(str(program), run, drift.met_inputs([run]), [of, of])
    assert types.tolist() == again.tolist() == [0, 0, 1] and complexity.tolist() == [3, 4, 3]
    grown = [numpy.array([3.0]), numpy.array([1.0, 3.0, 3.0])]
    assert drift.signatures(str(program), run, drift.met_inputs([run]), [0, 1], grown).tolist() == [[1, 3], [0, 4]]
    values = pool.read_set([tmp_path / "run"], how=Measuring(lineages=str(program))).values[0].values
    depth = values[(values.metric == "descent_greatest_depth") & (values.species == "prey")]
    assert depth.value.tolist() == [1, 1] and not values.duplicated([*METRIC, "baseline"]).any()
    program.write_text(f"#!{sys.executable}\nimport sys\nsys.exit('program: rule table ageing: must be paper')\n")
    with pytest.raises(RunError, match="^program: rule table ageing: must be paper$"):
        drift.ask(str(program), run, [[], []])
