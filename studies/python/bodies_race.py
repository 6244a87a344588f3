# SPDX-License-Identifier: MIT
"""The race with bodies: walks of single robots at different paces, and pace, or the gait's frequency, that is inherited in the pond on MuJoCo."""
import itertools
import pathlib
import sys
import tomllib
from collections.abc import Callable
from typing import NamedTuple

import data_rows
import installed
import numpy
import pandas
import ponds

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "red_queen"))
import traits
from red_queen import SIDES as SPECIES
from red_queen import WORLDS, switches
from trophic import contests, metrics, selection, statistics

# Walks of single robots

SERVO, GRAVITY = (5.0, 0.05), 9.81
VARIANTS = {
    "as shipped": (1.0, SERVO, GRAVITY),
    "friction 0.3": (0.3, SERVO, GRAVITY),
    "friction 3": (3.0, SERVO, GRAVITY),
    "servo of a sixteenth": (1.0, (0.3125, 0.0125), GRAVITY),
    "servo of a quarter": (1.0, (1.25, 0.025), GRAVITY),
    "servo of four times": (1.0, (20.0, 0.1), GRAVITY),
    "half the gravity": (1.0, SERVO, GRAVITY / 2.0),
    "twice the gravity": (1.0, SERVO, GRAVITY * 2.0),
}
"""The spider's sliding friction, which the floor has too, the gains of its servos by position, N m/rad, and velocity, N m s/rad, and gravity, m/s^2."""
MEASURED = ("error_rad", "swing", "slip_m_s", "airborne", "overturned")


def walk_rows(variant, table):
    """A row for each steering and pace of a table of trophic-walks: the mean speed of its walks with its interval, means of the other measures, and
    how many walks are upright throughout."""
    walks = pandas.read_csv(table)
    walks["steering"] = numpy.where(walks["target_angle_rad"] == 0.0, "straight", "steered")
    rows = []
    for (steering, pace), of in walks.groupby(["steering", "pace"], sort=False):
        speed = statistics.estimate(of["speed_m_s"])
        rows.append(
            {
                "variant": variant,
                "steering": steering,
                "pace": f"{pace:g}",
                "walks": len(of),
                "upright_walks": int((of["overturned"] == 0.0).sum()),
                "speed_m_s": data_rows.number(speed.mean),
                **dict(zip(("lower", "upper"), map(data_rows.number, speed.interval or (None, None)))),
                **{name: data_rows.number(of[name].mean()) for name in MEASURED},
            }
        )
    return rows


def walk_facts(table):
    """The origin of each walk of a table of trophic-walks, as provenance.facts has that of a run."""
    return [
        {
            "revision": row["revision"],
            "engine": row["engine"],
            "table": "spider",
            "seed": "none",
            "master": None,
            "null": "",
        }
        for row in data_rows.read(table)
    ]


def of_walks(rows, variant, steering):
    return [row for row in rows if (row["variant"], row["steering"]) == (variant, steering)]


def ceiling(rows):
    """Of the rows of a variant and steering: the fastest of the paces up to which every walk is upright throughout, and the first pace beyond."""
    upright, beyond = [], None
    for row in sorted(rows, key=lambda row: float(row["pace"])):
        if row["upright_walks"] != row["walks"]:
            beyond = row
            break
        upright.append(row)
    return max(upright, key=lambda row: float(row["speed_m_s"]), default=None), beyond


# Worlds

SETTINGS = [*ponds.SPACE, "rules.metabolism.predator.efficiency=0.3"]
"""The numbers of `pond`: pond_race is larger, and its predators get less from their prey."""
FAMILY = (
    *((species, kind, "neutral") for kind in ("end", "late_change") for species in SPECIES),
    *((species, "end", "alone") for species in SPECIES),
)
"""What is tested where both inherit: a species' trait, when, and over what."""
AGAIN = FAMILY[:2]


class Trait(NamedTuple):
    """An inherited trait of individuals: its name, the genes of a run by id, shape (individuals, genes), and the values that it makes of genes, shape
    (..., genes). Each gene begins at `first` and mutates by normal deviates within bounds, at the first birth too."""

    name: str
    genes: Callable
    of: Callable
    first: numpy.ndarray
    sd: float
    bounds: tuple

    def values(self, run):
        """The trait of each individual, as a column, by id."""
        genes = self.genes(run)
        return pandas.DataFrame(self.of(genes.to_numpy())[:, None], index=genes.index)

    def drift(self, run, inherits, draws=traits.DRAWS):
        """The same if nothing selects, as traits.dropped has it: a column a draw. `inherits`: by species."""
        born = pandas.read_csv(run / "phylogeny.csv", usecols=["id", "ancestor_id", "species"])
        born = born.sort_values("id", ignore_index=True)
        rule = {"sd": self.sd, **dict(zip(("least", "most"), self.bounds))}
        generator = numpy.random.default_rng(len(born))
        genes = [traits.dropped(born, rule | {"first": first}, inherits, generator, draws) for first in self.first]
        return pandas.DataFrame(self.of(numpy.stack(genes, axis=-1)), index=born["id"])


def paces(run):
    return pandas.read_csv(run / "genomes.csv", usecols=["id", "walking_pace"]).set_index("id")


def gaits(run):
    """The ten weights of each individual's pattern generator, in the order of control/gait/inherited_cpg.hpp."""
    genes = pandas.read_csv(run / "genes.csv").query("part == 'gait'")
    return genes.pivot(index="id", columns="index", values="value")


def generator(weights):
    """The matrix of a pattern generator of four hinges, shape (..., 8, 8): w_i of each hinge, then c_ij of each pair."""
    matrix = numpy.zeros((*weights.shape[:-1], 8, 8))
    for i in range(4):
        matrix[..., i, 4 + i], matrix[..., 4 + i, i] = weights[..., i], -weights[..., i]
    for place, (i, j) in enumerate(itertools.combinations(range(4), 2)):
        matrix[..., i, j], matrix[..., j, i] = weights[..., 4 + place], -weights[..., 4 + place]
    return matrix


def frequency(weights):
    """The highest frequency of a pattern generator, as a multiple of that of the shipped gait."""
    highest, shipped = (numpy.abs(numpy.linalg.eigvals(generator(of)).imag).max(axis=-1) for of in (weights, SHIPPED))
    return highest / shipped


GAIT = tomllib.loads((installed.models() / "gaits/spider_published.toml").read_text())
SHIPPED = numpy.array([*GAIT["internal"], *(pair["weight"] for pair in GAIT["coupling"])])
PACE = Trait("pace", paces, lambda genes: genes[..., 0], numpy.ones(1), 0.1, (0.2, 10.0))
FREQUENCY = Trait("frequency", gaits, frequency, SHIPPED, 0.05, (-10.0, 10.0))


def means_of(run, values, from_s, until_s):
    """The mean of each column of values, by id, of the living of each species over a time."""
    lives = pandas.read_csv(run / "phylogeny.csv", usecols=["id", "species", "origin_time", "destruction_time"])
    ends = lives["destruction_time"].clip(upper=until_s)
    weights = (ends - lives["origin_time"].clip(lower=from_s)).clip(lower=0.0).to_numpy()
    found = {}
    for species in SPECIES:
        of = (lives["species"] == species).to_numpy() * weights
        found[species] = of @ values.loc[lives["id"]].to_numpy() / of.sum()
    return found


def values_of(world, folder, trait, end_s):
    """The values of each run of a world and of its neutral null: whether both species live to the end and, if they do, the mean trait of the living
    in the last sixth, and how much more that is than in the fourth sixth."""
    rows = []
    for run in selection.read_sets([folder], None, metrics.Measuring())[0]["runs"]:
        lives, number = ponds.lives_of(run.path), ponds.number_of(run)
        rows += [ponds.row_of(world, number, "", key, value) for key, value in lives.items()]
        if lives["persists", "all", "all"] == 0.0 or world == "none":
            continue
        for null, values in (
            ("", trait.values(run.path)),
            ("neutral", trait.drift(run.path, dict(zip(SPECIES, WORLDS[world])))),
        ):
            middle, end = (means_of(run.path, values, end_s * part / 6.0, end_s * (part + 1) / 6.0) for part in (3, 5))
            for species in (species for species, on in zip(SPECIES, WORLDS[world]) if on):
                of = {"end": end[species], "late_change": end[species] - middle[species]}
                rows += [
                    ponds.row_of(world, number, null, (trait.name, species, kind), value.mean())
                    for kind, value in of.items()
                ]
    return rows


def tested(name, key, null, ours, others, comparisons):
    """A row of results that is one of so many comparisons, with the smallest difference that 80 % of studies would find."""
    of = statistics.contrast((1.0, ours), (-1.0, others))
    row = ponds.result(name, key, "primary", ours, null, others, ponds.difference((1.0, ours), (-1.0, others)))
    return row | {"detectable": data_rows.number(of and statistics.detectable_difference(of, 0.05 / comparisons))}


def results(rows, name, family=FAMILY):
    """One family (Holm): a trait over its neutral null where both inherit, at the end and its late change, and at the end less than where this side
    alone inherits, or some of these. Then what is described."""
    values, compared = ponds.Values(rows), []
    for species, kind, null in family:
        key, both = (name, species, kind), values("both", (name, species, kind))
        if null == "neutral":
            compared.append(tested("both", key, null, both, values("both", key, null), len(family)))
        else:
            compared.append(tested("both less alone", key, null, both, values(species, key), len(family)))
    worlds = [world for world in WORLDS if len(values(world, ("persists", "all", "all")))]
    described = [
        ponds.result(world, ("persists", "all", "all"), "described", values(world, ("persists", "all", "all")))
        for world in worlds
    ]
    described += [
        ponds.over(values, world, (name, species, "end"), "described", "neutral")
        for world in worlds
        for species, on in zip(SPECIES, WORLDS[world])
        if on and world != "both"
    ]
    for row in described:
        row["detectable"] = ""
    missing = [row for row in compared if row["of"].p is None]
    for row in missing:  # it counts in the family before its runs are made
        row["of"].p = 1.0
    found = ponds.with_tests(compared)
    for row in missing:
        row["p"] = row["p_holm"] = ""
    return [*found, *ponds.with_tests(described, are_tested=False)]


def speeds_of(folder, width=0.25):
    """Of the individuals of the runs below this folder: how far apart two of their rows are, by time, cm/s, and by their pace. Rows near walls and
    others count."""
    found = []
    for table in sorted(folder.glob("*/replicate-*/agents.csv")):
        agents = pandas.read_csv(table, usecols=["time_s", "id", "species", "x_m", "y_m", "walking_pace"])
        agents = agents.sort_values(["id", "time_s"])
        before = agents.groupby("id")[["time_s", "x_m", "y_m"]].shift()
        took_s = agents["time_s"] - before["time_s"]
        speed = numpy.hypot(agents["x_m"] - before["x_m"], agents["y_m"] - before["y_m"]) / took_s
        of = {"species": agents["species"], "pace": agents["walking_pace"], "speed": speed}
        found.append(pandas.DataFrame(of).dropna())
    every = pandas.concat(found)
    every["from"] = numpy.floor(every["pace"] / width) * width
    return [
        {
            "species": species,
            "pace_from": f"{low:g}",
            "pace_to": f"{low + width:g}",
            "rows": len(of),
            "speed_cm_s": data_rows.number(100.0 * of["speed"].mean()),
        }
        for (species, low), of in every.groupby(["species", "from"])
    ]


def progress_rows(world, table, end_s):
    """Rows of the progress of each run in a table of contests, from the start to the end, over its teams."""
    played, rows = pandas.read_csv(table), []
    for species, role in (("predator", "hunter"), ("prey", "victim")):
        values = contests.progress_of_runs(played, role, contests.epochs_of(played), 0.0, end_s)
        for number, value in enumerate(values):
            rows.append(ponds.row_of(world, f"{number:02}", "", ("progress", species, "all"), value))
    return rows


def progress(rows):
    """Progress of both species of runs in which both inherit, over runs in which none does: one family."""
    values, found = ponds.Values(rows), []
    for species in SPECIES:
        key = ("progress", species, "all")
        both, none = values("both", key), values("none", key)
        found.append(tested("both", key, "none", both, none, len(SPECIES)))
    return ponds.with_tests(found)


TITLES = ("predators of the start hunt prey of the start", "predators of the end hunt the same prey")


def meetings(played, end_s, team="0"):
    """The rows of contests of one run in which victims of the start meet hunters of the start and of the end."""
    return [
        row
        for hunters_s in (0.0, end_s)
        for row, of in enumerate(played)
        if (of["team"], float(of["victim_epoch_s"]), float(of["hunter_epoch_s"])) == (team, 0.0, hunters_s)
    ]


def stack(pictures, path):
    """Writes pictures of one width below each other."""
    from matplotlib import image

    image.imsave(path, numpy.vstack([image.imread(picture) for picture in pictures]))
