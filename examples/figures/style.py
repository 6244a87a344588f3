# SPDX-License-Identifier: MIT
"""Shared by the figures' scripts: sizes, colours, captions, and saving of figures."""
import json
import sys
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLUMN_IN = 3.5
# Okabe and Ito's colours: distinguishable with every common colour blindness and, by their line styles, in grey.
COLOURS = {"prey": "#0072B2", "predator": "#D55E00"}
# Other species: the colours with the largest distances in CIELAB under protanopia, deuteranopia and tritanopia, alone and next to those two.
OTHER_COLOURS = ["#E69F00", "#332288", "#56B4E9", "#882255"]
BESIDE_COLOURS = ["#882255", "#56B4E9", "#E69F00", "#332288"]
LINES = ["-", (0, (4, 1.5)), (0, (1, 1)), (0, (5, 1, 1, 1, 1, 1)), (0, (7, 2, 1, 2))]
NULL_COLOUR = "#555555"

plt.rcParams.update({"font.size": 8, "axes.titlesize": 8, "axes.labelsize": 8, "legend.fontsize": 7, "xtick.labelsize": 7,
                     "ytick.labelsize": 7, "axes.spines.top": False, "axes.spines.right": False, "lines.linewidth": 1.2,
                     "legend.frameon": False, "pdf.fonttype": 42, "figure.constrained_layout.use": True})


class Missing(Exception):
    """The data of a figure are missing."""


def colour(species, all_species):
    others = [s for s in all_species if s not in COLOURS]
    if species in COLOURS:
        return COLOURS[species]
    colours = OTHER_COLOURS if len(others) == len(list(all_species)) else BESIDE_COLOURS
    return colours[others.index(species) % len(colours)]


def line(species, all_species):
    """The line style of a species, which distinguishes it in addition to its colour."""
    return LINES[list(all_species).index(species) % len(LINES)]


def caption(figure, text):
    """Writes the meaning of bands, points and lines and the number of runs below the figure, and into captions.json."""
    figure.caption = " ".join(text.split())
    width = int(figure.get_figwidth() * 20.5)
    figure.supxlabel("\n".join(textwrap.wrap(figure.caption, width)), fontsize=6, color="#444444", x=0.01, ha="left", linespacing=1.15)
    return figure


def save_all(figures, out):
    """Draws each of (name, function) into OUT as PNG and PDF, and writes their captions to captions.json. A figure without data is omitted
    with a message. Returns the number of figures drawn."""
    out.mkdir(parents=True, exist_ok=True)
    drawn = 0
    captions = {}
    for name, draw in figures:
        try:
            figure = draw()
        except Missing as why:
            print(f"{name}: left out: {why}", file=sys.stderr)
            plt.close("all")
            continue
        for ending in ("png", "pdf"):
            figure.savefig(out / f"{name}.{ending}", dpi=300, metadata={"CreationDate": None} if ending == "pdf" else None)
        captions[name] = getattr(figure, "caption", "")
        plt.close(figure)
        drawn += 1
    (out / "captions.json").write_text(json.dumps(captions, indent=2) + "\n")
    return drawn
