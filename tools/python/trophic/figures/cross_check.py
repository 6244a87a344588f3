# SPDX-License-Identifier: MIT
"""One figure of a cross-check: convergence of speed and turning, paths, and equivalence of the ecology. Panels without data are blank."""
from __future__ import annotations

import cmath
import functools
import pathlib

import matplotlib.pyplot as plt
import pandas as pd

from .style import caption

COLOURS = {"mujoco": "#0072B2", "ode": "#D55E00"}
MARKERS = {0.7: "v", -0.7: "^", 0.0: "o"}
DEFAULT_STEP_S = 0.0012
QUANTITIES = {"speed_m_s": ("speed, cm/s", 100.0), "turn_rate_rad_s": ("turning, rad/min", 60.0)}


def draw_convergence(axes, gait, quantity):
    title, factor = QUANTITIES[quantity]
    rows = gait[(gait.quantity == quantity) & (gait.settings == "default")]
    for (engine, angle), group in rows.groupby(["engine", "target_angle_rad"]):
        group = group.sort_values("timestep_s")
        errors = [factor * (group["mean"] - group.lower), factor * (group.upper - group["mean"])]
        shift = 0.97 if engine == "mujoco" else 1.03
        axes.errorbar(1e3 * shift * group.timestep_s, factor * group["mean"], yerr=errors, color=COLOURS[engine], marker=MARKERS[angle],
                      markersize=4, linewidth=1, capsize=2, label=f"{engine}, target angle {angle:+.1f}")
    axes.set_xscale("log")
    axes.set_xticks([0.3, 0.6, 1.2], ["0.3", "0.6", "1.2"])
    axes.minorticks_off()
    axes.set_xlabel("timestep, ms")
    axes.set_ylabel(title)


def draw_paths(axes, paths):
    """All twelve robots of each engine, each path moved to start at 0 along x."""
    rows = paths[(paths.settings == "default") & (paths.timestep_s == DEFAULT_STEP_S)]
    for (engine, angle, _), path in rows.groupby(["engine", "target_angle_rad", "robot"]):
        path = path.sort_values("time_s")
        first = path.iloc[0]
        along = ((path.x_m - first.x_m) + 1j * (path.y_m - first.y_m)) * cmath.exp(-1j * first.heading_rad)
        axes.plot(along.to_numpy().real, along.to_numpy().imag, color=COLOURS[engine], linewidth=0.5, alpha=0.7)
    axes.set_aspect("equal", "datalim")
    axes.set_xlabel("ahead, m")
    axes.set_ylabel("to the left, m")


def draw_ecology(axes, ecology, engines):
    """Differences in units of their margins: equivalent if the bar stays within +-1. `engines`: of the first set and the second."""
    rows = ecology.iloc[::-1].reset_index(drop=True)
    names = [f"{r.quantity} {r.species}" + ("" if r.group == "all" else f" ({r.group})") for r in rows.itertuples()]
    middle = rows.difference / rows.margin
    errors = [middle - rows.difference_lower / rows.margin, rows.difference_upper / rows.margin - middle]
    axes.errorbar(middle, rows.index, xerr=errors, fmt="o", color="black", markersize=3, linewidth=1)
    axes.axvspan(-1, 1, color="#009E73", alpha=0.15)
    axes.axvline(0, color="#555555", linewidth=0.6)
    axes.set_yticks(rows.index, names, fontsize=6)
    axes.set_xlabel(" - ".join(engine.split()[0] for engine in reversed(engines)) + ", in margins [90 %]", loc="right")


def cross_check(folder):
    """The figure of a cross-check's folder."""
    folder = pathlib.Path(folder)
    table = pd.read_csv(folder / "cross_check.csv")
    gait = table[table.part == "gait"]
    ecology = table[(table.part == "ecology") & table.conclusion.notna()]
    figure, panels = plt.subplots(2, 2, figsize=(7.2, 6.0))
    if gait.empty:
        for panel in (panels[0, 0], panels[0, 1], panels[1, 0]):
            panel.axis("off")
    else:
        draw_convergence(panels[0, 0], gait, "speed_m_s")
        draw_convergence(panels[0, 1], gait, "turn_rate_rad_s")
        panels[0, 0].legend(fontsize=6, ncols=2, loc="lower left", bbox_to_anchor=(0.0, 1.02))
        draw_paths(panels[1, 0], pd.read_csv(folder / "trajectories.csv"))
    if ecology.empty:
        panels[1, 1].axis("off")
    else:
        draw_ecology(panels[1, 1], ecology, table[table.part == "ecology"].engine.unique())
    return caption(figure, "Gaits at several timesteps with 95 % intervals, paths from one start, and the ecology's differences between engines in "
                           "units of their margins with 90 % intervals: equivalent within the green band.")


def figures_of(folder):
    """(name, function) of the one figure."""
    return [("cross_check", functools.partial(cross_check, folder))]
