# SPDX-License-Identifier: MIT
"""What the figures' scripts share: sizes, colours, how a figure is saved, and what is said where its data are missing."""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLUMN_IN = 3.5
# Okabe and Ito's colours, told apart with every common colour blindness and, with the line styles, in grey.
COLOURS = {"prey": "#0072B2", "predator": "#D55E00"}
OTHER_COLOURS = ["#009E73", "#CC79A7", "#E69F00", "#56B4E9"]
NULL_COLOUR = "#555555"

plt.rcParams.update({"font.size": 8, "axes.titlesize": 8, "axes.labelsize": 8, "legend.fontsize": 7, "xtick.labelsize": 7,
                     "ytick.labelsize": 7, "axes.spines.top": False, "axes.spines.right": False, "lines.linewidth": 1.2,
                     "legend.frameon": False, "pdf.fonttype": 42, "figure.constrained_layout.use": True})


class Missing(Exception):
    """The data of a figure are not there."""


def colour(species, all_species):
    others = [s for s in all_species if s not in COLOURS]
    return COLOURS[species] if species in COLOURS else OTHER_COLOURS[others.index(species) % len(OTHER_COLOURS)]


def save_all(figures, out):
    """Draws each of (name, function) into OUT as PNG and PDF; one whose data are missing is left out with a line. How many were drawn."""
    out.mkdir(parents=True, exist_ok=True)
    drawn = 0
    for name, draw in figures:
        try:
            figure = draw()
        except Missing as why:
            print(f"{name}: left out: {why}", file=sys.stderr)
            plt.close("all")
            continue
        for ending in ("png", "pdf"):
            figure.savefig(out / f"{name}.{ending}", dpi=300, metadata={"CreationDate": None} if ending == "pdf" else None)
        plt.close(figure)
        drawn += 1
    return drawn
