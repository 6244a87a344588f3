# SPDX-License-Identifier: MIT
"""`trophic cross-check`: what depends on the engine, by two one-sided tests of equivalence: one gait at several timesteps and settings, and the metrics
of two sets of runs."""
from __future__ import annotations

import pathlib
from collections.abc import Iterator, Sequence
from typing import Any

import numpy
import pandas

from . import pool
from .errors import RunError
from .report.columns import names
from .report.tables import csv_text, publish, write_new
from .statistics import EquivalenceTest, contrast, estimate, test_equivalence
from .values import MeasuredSet
from .words import Reading, columns, metric_title, number_text

MARGIN_SHARE, SMALLEST_SCALE = 0.10, 1e-3
QUANTITIES = {"speed_m_s": ("m/s", 100.0), "turn_rate_rad_s": ("rad/s", 60.0), "power_W": ("W", 1.0), "torque_N_m": ("N m", 1.0)}
"""Measures of walks: the unit, and the factor to the unit of the terminal."""
AFTER_S = 10.0
"""When the distance of two robots is taken."""
MARGINS = {("attribution_caught", "all"): 0.05, ("attribution_catches", "all"): 0.05, ("attribution_catchers", "all"): 0.05, ("velocity", "all"): 0.005,
           ("velocity", "inherited"): 0.005, ("velocity", "random"): 0.005, ("wall_sticking", "all"): 0.1, ("wall_sticking_gap", "all"): 0.1,
           ("tag_symmetry", "inherited"): 0.05, ("deaths", "all"): 0.2}
"""The difference of a metric and group between engines that would still leave the paper's conclusion alone: shares by 0.05 and wall sticking by 0.1, a
fraction of what separates the published values from their baselines; velocities by 0.5 cm/s; deaths by this share of the first set's."""
SHARES_OF_FIRST = ("deaths",)
_CONDITION = ["engine", "settings", "timestep_s", "target_angle_rad"]
_TABLE = "cross_check.csv"


def run(request: dict) -> int:
    """Compares the walks in `folder` (walks.csv and trajectories.csv) and the two sets of `runs`, writes cross_check.csv into the folder, prints both and names the folder `out`.
    Either may be missing."""
    folder = pathlib.Path(request["folder"])
    rows: list[dict[str, Any]] = []
    if (folder / "walks.csv").exists():
        rows += walks(folder)
        print(walks_text(pandas.DataFrame(rows)), end="")
    if request.get("runs"):
        sets = [pool.read_set([path]) for path in request["runs"]]
        check(*sets)
        found = list(metrics(*sets))
        print(("\n" if rows else "") + metrics_text(sets, found), end="")
        rows += [row for pair in found for row in pair]
    write_new(folder / _TABLE, csv_text(pandas.DataFrame(rows, columns=names(_TABLE))))
    publish(folder, pathlib.Path(request["out"]))
    print(f"files   {request['out']}")
    return 0


def _row(part: str, engine: str, quantity: str, unit: str, values: Sequence[float] | numpy.ndarray, test: EquivalenceTest | None, **more: Any) -> dict[str, Any]:
    ours = estimate(values)
    lower, upper = ours.interval or (None, None)
    row = {"part": part, "engine": engine, "quantity": quantity, "unit": unit, "mean": ours.mean, "lower": lower, "upper": upper, "n": ours.runs, **more}
    if test is not None:
        lower, upper = test.interval or (None, None)
        row |= {"margin": test.margin, "difference": test.difference, "difference_lower": lower, "difference_upper": upper, "conclusion": test.conclusion}
    return row


def walks(folder: pathlib.Path) -> list[dict[str, Any]]:
    """The rows of cross_check.csv about walks. Differences are from MuJoCo's walk at its default timestep, the first for each target angle; margins are a
    share of what MuJoCo's robots do on the first angle of all, on which they turn."""
    walked, paths = (pandas.read_csv(folder / file, float_precision="round_trip") for file in ("walks.csv", "trajectories.csv"))
    places = {condition: of.sort_values("robot")[["x_m", "y_m"]].to_numpy() for condition, of in paths[paths["time_s"] == AFTER_S].groupby(_CONDITION, sort=False)}
    scales = None
    rows = []
    for angle, of_angle in walked.groupby("target_angle_rad", sort=False):
        outcomes = {condition: of.sort_values("robot") for condition, of in of_angle.groupby(_CONDITION, sort=False)}
        reference = next(iter(outcomes.values()))
        if scales is None:
            scales = {name: max(abs(reference[name].mean()), SMALLEST_SCALE) for name in QUANTITIES}
        finest = {engine: min(condition for condition in outcomes if condition[:2] == (engine, "default")) for engine, *_ in outcomes}
        for condition, outcome in outcomes.items():
            at = dict(zip(_CONDITION, condition))
            for name, (unit, _) in QUANTITIES.items():
                test = test_equivalence(contrast((-1.0, reference[name]), (1.0, outcome[name])), MARGIN_SHARE * scales[name])
                rows.append(_row("gait", at.pop("engine", condition[0]), name, unit, outcome[name], test, **at))
            for name, other in (("distance_to_mujoco_m", finest["mujoco"]), ("distance_to_own_m", finest[condition[0]])):
                if condition in places:
                    rows.append(_row("gait", condition[0], name, "m", numpy.linalg.norm(places[condition] - places[other], axis=1), None, **at))
    return rows


def walks_text(rows: pandas.DataFrame) -> str:
    """A line for each condition of walks."""
    lines: list[tuple[str, ...]] = [("engine", "settings", "step ms", "angle", "speed cm/s", "turning rad/min", "power W", "torque Nm", "off cm", "own cm",
                                     "speed differs", "turning differs")]
    scale = {name: row.margin / MARGIN_SHARE for name, row in rows[rows["margin"].notna()].drop_duplicates("quantity").set_index("quantity").iterrows()}
    for condition, of in rows.groupby(_CONDITION, sort=False):
        by = of.set_index("quantity")
        line = [condition[0], condition[1], f"{1e3 * condition[2]:.1f}", f"{condition[3]:.1f}"]
        for name, (_, factor) in QUANTITIES.items():
            mean, lower, upper = factor * by.loc[name, ["mean", "lower", "upper"]].astype(float)
            line.append(f"{mean:.2f} [{lower:.2f}, {upper:.2f}]" if factor != 1.0 else f"{mean:.4f}")
        line += [f"{100.0 * by.loc[name, 'mean']:.2f}" if name in by.index else "" for name in ("distance_to_mujoco_m", "distance_to_own_m")]
        if condition[0] != rows.loc[0, "engine"]:
            line += [f"{100.0 * by.loc[name, 'difference'] / scale[name]:.1f} % {by.loc[name, 'conclusion']}" for name in ("speed_m_s", "turn_rate_rad_s")]
        lines.append(tuple(line))
    return ("one gait: mean over robots [95 %]; difference to mujoco in % of its value at target angle 0.7, with conclusion for a margin of 10 %;\n"
            "distance after 10 s to the same robot at mujoco's and at the engine's own finest step\n" + columns(lines))


def metrics(first: MeasuredSet, second: MeasuredSet) -> Iterator[tuple[dict[str, Any], dict[str, Any]]]:
    """Yields the rows of each metric with a margin, of the first set and of the second."""
    for metric in first.metrics():
        margin = MARGINS.get((metric.metric, metric.group))
        if margin is None:
            continue
        values = [of.baseline(metric, "") for of in (first, second)]
        if metric.metric in SHARES_OF_FIRST:
            margin *= max(1.0, estimate(values[0]).mean or 1.0)
        test = test_equivalence(contrast((-1.0, values[0]), (1.0, values[1])), margin)
        one, other = (_row("ecology", str(of.runs[0].manifest["backend"]), metric.metric, metric.unit, its, tested, species=metric.species, group=metric.group)
                      for of, its, tested in ((first, values[0], None), (second, values[1], test)))
        yield one, other


def check(first: MeasuredSet, second: MeasuredSet) -> None:
    """Raises RunError if rules, parameters other than the engine's, or durations of two sets differ."""
    a, b = (of.runs[0] for of in (first, second))

    def ecology(manifest: dict) -> dict:
        params = {key: value for key, value in manifest["params"].items() if key not in ("seed", "physics", "backend")}
        if "ecology" in params:
            params["ecology"] = {key: value for key, value in params["ecology"].items() if key != "duration_s"}
        return {"rule_table": manifest["rule_table"], "rules": manifest["rules"], "params": params}
    if why := pool.first_difference(ecology(a.manifest), ecology(b.manifest)):
        raise RunError(f"{b.path}: {why} as in {a.path}")
    if not pool.lasted_alike(a, b):  # type: ignore[arg-type]
        raise RunError(f"{b.path}: {pool.lasted_text(b)}: must be as {pool.lasted_text(a)}, as in {a.path}")  # type: ignore[arg-type]


def metrics_text(sets: Sequence[MeasuredSet], found: Sequence[tuple[dict[str, Any], dict[str, Any]]]) -> str:
    """A line for each metric."""
    lines: list[tuple[str, ...]] = [("metric", "first [95 %]", "second [95 %]", "margin", "difference [90 %]", "conclusion")]
    by_title = {(metric.metric, metric.species, metric.group): metric for metric in sets[0].metrics()}
    for one, other in found:
        metric = by_title[one["quantity"], one["species"], one["group"]]
        reading = Reading(metric)
        lines.append((metric_title(metric), *(reading.with_interval(row["mean"], None if row["lower"] is None else (row["lower"], row["upper"])) for row in (one, other)),
                      reading(other["margin"]), reading.with_interval(other["difference"], None if other["difference_lower"] is None else
                                                                      (other["difference_lower"], other["difference_upper"])), other["conclusion"]))
    first, second = (of.runs[0].manifest["backend"] for of in sets)
    remarks = "".join(f"remark: {remark}\n" for of in sets for remark in of.remarks)
    return (f"rules {sets[0].runs[0].manifest['rule_table']}: first {first}, {len(sets[0].runs)} runs; second {second}, {len(sets[1].runs)} runs; "
            f"{number_text(sets[0].until_s)} s each\n" + columns(lines) + remarks)
