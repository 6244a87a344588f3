# SPDX-License-Identifier: MIT
"""Every text of every figure lies inside it, in every style and width, and no labels of one axis overlap."""
import itertools
import json

import numpy
import pandas
import pytest
from trophic.report.columns import names as column_names

pytest.importorskip("matplotlib").use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from figure_texts import problems  # noqa: E402
from trophic.figures import bodies, contests, cross_check, paper, style, sweep  # noqa: E402

RNG = numpy.random.default_rng(7)
TIMES_S = [200.0 * (i + 1) for i in range(10)]
LABEL = "released (2 changes; from 700 s)"


def write(folder, name, frame):
    folder.mkdir(parents=True, exist_ok=True)
    frame.to_csv(folder / name, index=False)


def rows_of(label, run, metric, species, group, unit="1", baseline="", curve=True):
    scale = {"m/s": 0.02, "1": 0.5}.get(unit, 20.0)
    values = [(float("nan"), RNG.normal(scale, 0.1 * scale))] + (
        [(time_s, RNG.normal(scale, 0.2 * scale)) for time_s in TIMES_S] if curve else []
    )
    return [
        [label, f"replicate-{run:02}", run, metric, species, group, baseline, time_s, value, unit]
        for time_s, value in values
    ]


def write_run(folder, species, with_bodies):
    """The tables that pictures of one run need."""
    count, births = 30, RNG.uniform(0.0, 1500.0, 30)
    births[:5] = 0.0
    lives = pandas.DataFrame(
        {
            "id": range(count),
            "ancestor_list": ["[none]"] + [f"[{max(0, i - 5)}]" for i in range(1, count)],
            "origin_time": births,
            "destruction_time": births + 400.0,
            "species": [species[i % len(species)] for i in range(count)],
        }
    )
    lives.loc[20:, "destruction_time"] = float("inf")
    write(folder, "phylogeny.csv", lives)
    write(
        folder,
        "events.csv",
        pandas.DataFrame({"event": "catch", "x_m": RNG.uniform(-9, 9, 400), "y_m": RNG.uniform(-9, 9, 400)}),
    )
    write(
        folder,
        "agents.csv",
        pandas.DataFrame(
            [
                {
                    "time_s": 2.0 * t,
                    "body": b,
                    "species": species[b % len(species)],
                    "x_m": RNG.normal(),
                    "y_m": RNG.normal(),
                }
                for t in range(50)
                for b in range(6)
            ]
        ),
    )
    (folder / "manifest.json").write_text(json.dumps({"params": {"ecology": {"tick_s": 2.0}}}))
    if with_bodies:
        write(
            folder,
            "bodies.csv",
            pandas.DataFrame(
                {
                    "id": range(count),
                    "time_s": births,
                    "species": lives["species"],
                    "plan": [i // 3 for i in range(count)],
                    "parent_plan": [max(0, i // 3 - 1) for i in range(count)],
                    "modules_text": "core front:brick0",
                    **{name: RNG.uniform(size=count) for name in bodies.DESCRIPTORS},
                }
            ),
        )


def analysis(folder, labels, species, with_bodies=False):
    """What `trophic analyze` writes of one set or of two, as far as figures read it."""
    rows, sets = [], []
    for label in labels:
        for run, baseline, one in itertools.product(range(6), ("", "shadow"), species):
            for metric, group, unit in (
                ("velocity", "all", "m/s"),
                ("velocity", "inherited", "m/s"),
                ("velocity", "random", "m/s"),
                ("population", "all", "1"),
                ("hunger", "all", "ticks"),
                ("wall_sticking", "all", "1"),
                ("deaths", "all", "1"),
                ("deaths", "caught", "1"),
                ("deaths", "starved", "1"),
                ("deaths", "senescence", "1"),
                ("path_length_of_robots", "all", "m"),
            ):
                rows += rows_of(label, run, metric, one, group, unit, baseline)
            for metric in ("attribution_caught", "attribution_credited", "attribution_catches", "mass_of_the_living"):
                rows += rows_of(label, run, metric, one, "all", baseline=baseline, curve=False)
            rows += rows_of(label, run, "wall_sticking", one, "all", baseline="uniform_density", curve=False)
            for name in bodies.MEASURES if with_bodies else ():
                rows += rows_of(
                    label,
                    run,
                    name,
                    one,
                    "all",
                    "m/s" if name == "walked" else "kg" if name == "body_mass" else "1",
                    baseline,
                )
            if with_bodies:
                rows += rows_of(label, run, "body_size", one, "all", baseline=baseline, curve=False)
        for run, baseline in itertools.product(
            range(0 if with_bodies else 6), ("", "shadow", "permuted_tags", "bernoulli_tags", "uniform_pairs")
        ):
            rows += rows_of(label, run, "tag_symmetry", "prey+predator", "inherited", baseline=baseline, curve=False)
        runs = [folder / f"{label} {run}" for run in range(6)]
        for run in runs:
            write_run(run, species, with_bodies)
        published = [
            {"metric": metric, "species": one, "group": group, "published": 0.4}
            for metric, one, group in (
                ("attribution_caught", "prey", "all"),
                ("velocity", "prey", "all"),
                ("wall_sticking", "prey", "all"),
                ("tag_symmetry", "prey+predator", "inherited"),
            )
        ]
        sets.append(
            {
                "set": label,
                "backend": "mujoco 3.1.6",
                "runs": [{"folder": str(run), "half_side_m": 10.0} for run in runs],
                "metrics": published,
            }
        )
    write(folder, "metrics.csv", pandas.DataFrame(rows, columns=column_names("metrics.csv")))
    summary = {"trophic": "0", "sets": sets}
    if len(labels) == 2:
        of = {"deviation": 1.0}
        summary["differences"] = [
            {
                "metric": f"attribution_of_{i}",
                "species": "prey+top_predator",
                "group": "inherited_active",
                "same_as": None,
                "a": of,
                "b": of,
                "raw": {"value": i - 20.0, "lower": i - 21.0, "upper": i - 19.0, "p": i / 50, "differs": i < 10},
                "over_shadow": {
                    "value": i - 20.0,
                    "lower": i - 21.0,
                    "upper": i - 19.0,
                    "p": i / 50,
                    "differs": i < 10,
                },
            }
            for i in range(40)
        ]
    (folder / "summary.json").write_text(json.dumps(summary))


def swept(folder, axes):
    """An analysed sweep of a grid: `axes`, values by name."""
    from test_sweeps import analysis_of, plan_of
    from trophic.sweeps import report
    from trophic.sweeps.cells import SweepValues
    from trophic.values import Metric

    settings = [dict(zip(axes, values)) for values in itertools.product(*axes.values())]
    plan = plan_of(len(settings), 6, True, True, settings.__getitem__)
    metrics = [
        Metric("velocity", one, group, "m/s") for one in ("prey", "top_predator") for group in ("all", "inherited")
    ] + [Metric("deaths", "prey", "caught", "1"), Metric("velocity_of_own", "", "all", "m/s")]
    values = numpy.array([RNG.normal(run.cell * (not run.shadow), 0.5, len(metrics)) for run in plan])
    folder.mkdir()
    report.write(analysis_of(plan, SweepValues(metrics, values, [True] * len(plan)), len(settings) // 2), folder)


def contested(folder):
    rows = [
        ("own", shadow, run, run, hunter, victim, "top_predator", "predator", RNG.uniform(5, 120))
        for shadow in (0, 1)
        for run in range(6)
        for hunter in range(0, 6000, 1000)
        for victim in range(0, 6000, 1000)
    ]
    write(
        folder,
        "contests.csv",
        pandas.DataFrame(
            rows,
            columns=[
                "against",
                "shadow",
                "hunters_run",
                "victims_run",
                "hunter_epoch_s",
                "victim_epoch_s",
                "hunter",
                "victim",
                "contact_s",
            ],
        ),
    )


def cross_checked(folder):
    ecology = [
        {
            "engine": "mujoco 3.1.6",
            "quantity": quantity,
            "species": species,
            "group": group,
            "unit": "1",
            "mean": 1.0,
            "margin": 1.0,
            "difference": 0.3,
            "difference_lower": -0.5,
            "difference_upper": 1.1,
            "conclusion": "inconclusive",
        }
        for quantity in ("attribution_credited", "velocity_stored")
        for species in ("prey", "top_predator")
        for group in ("all", "inherited_active")
    ]
    ecology.append({**ecology[0], "engine": "ode 0.16.2", "conclusion": None})
    write(folder, "cross_check.csv", pandas.DataFrame(ecology).reindex(columns=column_names("cross_check.csv")))


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """Analyses by name, each with the module that draws it."""
    at = tmp_path_factory.mktemp("analyses")
    analysis(at / "one", ["paper"], ["prey", "predator"])
    analysis(at / "two", [LABEL, "paper"], ["prey", "predator", "top_predator"])
    analysis(at / "bodies", ["evolving_bodies", "evolving_bodies_by_survival"], ["prey", "predator"], with_bodies=True)
    swept(at / "sweep", {"rules.mutation.sd": [0.05, 0.1, 0.2]})
    swept(
        at / "grid",
        {
            "ecology.duration_s": [round(1e-5 * 3**i, 7) for i in range(9)],
            "rules.starvation.interval.base_ticks": [15, 25, 35],
            "ecology.robot": ["spider", "a_gecko_with_a_long_name"],
        },
    )
    contested(at / "contests")
    cross_checked(at / "cross_check")
    modules = {
        "one": paper,
        "two": paper,
        "bodies": bodies,
        "sweep": sweep,
        "grid": sweep,
        "contests": contests,
        "cross_check": cross_check,
    }
    return {name: (at / name, module) for name, module in modules.items()}


@pytest.mark.parametrize("look, columns", [*((look, 1) for look in style.STYLES), ("plain", 2)])
@pytest.mark.parametrize("name", ["one", "two", "bodies", "sweep", "grid", "contests", "cross_check"])
def test_every_text_lies_in_its_figure(folders, monkeypatch, look, columns, name):
    monkeypatch.setattr(bodies, "picture_of", lambda *_: numpy.ones((150, 180, 3)))
    folder, module = folders[name]
    style.use(look, columns)
    drawn, found = 0, []
    for figure_name, draw in module.figures_of(folder):
        if not figure_name.endswith("film_strip") and not figure_name.startswith(
            "paper-"
        ):  # the second of two sets is as the first
            figure = style.letter_panels(draw())
            if columns == 2:
                style._with_caption(figure)
            found += [f"{figure_name}: {problem}" for problem in problems(figure)]
            plt.close(figure)
            drawn += 1
    assert drawn > 0 and found == []


@pytest.mark.parametrize(
    "make, part",
    [
        (
            lambda axes: axes.set_xlabel("a label far longer than a small figure is wide, which is cut"),
            "leaves the figure by",
        ),
        (lambda axes: axes.set_xticks([0, 0.01], ["one", "another"]), "'one' overlaps 'another'"),
        (lambda axes: axes.figure.text(0.99, 0.5, "beyond"), "'beyond' leaves the figure by"),
    ],
)
def test_a_text_that_is_cut_or_hidden_is_found(make, part):
    style.use()
    figure, axes = plt.subplots(figsize=(2.0, 1.5))
    assert problems(figure) == []
    make(axes)
    assert part in " ".join(problems(figure))
    plt.close(figure)
