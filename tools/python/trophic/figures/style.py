# SPDX-License-Identifier: MIT
"""Common to all figures: sizes, fonts, colours, captions, saving, and the message for missing data."""
from __future__ import annotations

import json
import sys
import textwrap

import matplotlib.pyplot as plt

from ..errors import RunError
from ..words import latex_text, one_line
from ..writing import encoded

# Okabe and Ito's colours, distinguishable with every common colour blindness and, with the line styles, in grey.
COLOURS = {"prey": "#0072B2", "predator": "#D55E00"}
# Colours of others: those that stay farthest apart in CIELAB under protanopia, deuteranopia and tritanopia, alone and next to those two.
OTHER_COLOURS = ["#E69F00", "#332288", "#56B4E9", "#882255"]
BESIDE_COLOURS = ["#882255", "#56B4E9", "#E69F00", "#332288"]
LINES = ["-", (0, (4, 1.5)), (0, (1, 1)), (0, (5, 1, 1, 1, 1, 1)), (0, (7, 2, 1, 2))]
NULL_COLOUR = "#555555"

_SIZES = {
    "font.size": 8,
    "axes.titlesize": 8,
    "axes.labelsize": 8,
    "legend.fontsize": 7,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "lines.linewidth": 1.2,
    "legend.frameon": False,
    "pdf.fonttype": 42,
    "figure.constrained_layout.use": True,
    "text.parse_math": False,
}  # a $ in a name of a user is a $
_SERIF = {
    "font.family": "serif",
    "font.serif": ["Times New Roman", "Nimbus Roman", "Liberation Serif", "STIXGeneral"],
    "mathtext.fontset": "stix",
}
# Inches of a column and of a page, and how letters look.
STYLES = {"plain": (3.5, 7.16, {}), "serif": (3.5, 7.16, _SERIF), "ieee": (3.487, 7.14, _SERIF)}
_WIDTH_IN = [3.5]


def use(style="plain", columns=1):
    """Makes all figures that follow in a style (plain, serif or ieee), one or two columns wide."""
    column_in, page_in, look = STYLES[style]
    plt.rcParams.update({**plt.rcParamsDefault, "backend": plt.rcParams["backend"], **_SIZES, **look})
    _WIDTH_IN[0] = page_in if columns == 2 else column_in


def width_in():
    """How wide a figure is to be, in inches."""
    return _WIDTH_IN[0]


use()


class Missing(Exception):
    """The data of a figure are not there."""


def colour(species, all_species):
    others = [s for s in all_species if s not in COLOURS]
    if species in COLOURS:
        return COLOURS[species]
    colours = OTHER_COLOURS if len(others) == len(list(all_species)) else BESIDE_COLOURS
    return colours[others.index(species) % len(colours)]


def line(species, all_species):
    """A line style of a species' own: the second sign, next to its colour, that distinguishes it."""
    return LINES[list(all_species).index(species) % len(LINES)]


def caption(figure, text):
    """Adds a caption, for captions.json and captions.tex: the meaning of bands, points and lines, and the number of runs."""
    figure.caption = " ".join(text.split())
    return figure


def legend_above(ax, columns=2, **options):
    """A legend above the axes, where it hides no data, in at most so many columns: fewer if labels are long. A long legend makes the figure taller.
    Returns its rows."""
    labels = ax.get_legend_handles_labels()[1]
    if not labels:
        return 0
    figure, room_in = ax.figure, (ax.figure.get_figwidth() - 0.7) / ax.get_subplotspec().get_gridspec().ncols
    for count in range(columns, 0, -1):
        legend = ax.legend(
            loc="lower left",
            bbox_to_anchor=(0, 1.0),
            ncol=count,
            borderaxespad=0.2,
            columnspacing=1,
            handlelength=1.6,
            **options,
        )
        if legend.get_window_extent().width < room_in * figure.dpi:
            break
    rows = -(-len(labels) // count)
    figure.set_figheight(figure.get_figheight() + 0.15 * max(0, rows - 4))
    return rows


def wrapped(text):
    """The text in lines as wide as a figure."""
    return "\n".join(textwrap.wrap(text, int(14 * width_in())))


def letter_panels(figure):
    """a, b, c, ... at the upper left of each panel of a figure that has several."""
    panels = [ax for ax in figure.axes if ax.get_label() != "<colorbar>" and ax.axison]
    if len(panels) > 1:
        for number, ax in enumerate(panels):
            ax.annotate(
                chr(ord("a") + number % 26),
                (0, 1),
                xytext=(-20, 4),
                xycoords="axes fraction",
                textcoords="offset points",
                fontweight="bold",
                fontsize=9,
                annotation_clip=False,
            )
    return figure


def _with_caption(figure):
    lines = textwrap.wrap(figure.caption, int(figure.get_figwidth() * 20.5))
    figure.set_figheight(
        figure.get_figheight() + len(lines) * 6 * 1.15 / 72
    )  # so panels stay as large as without a caption
    figure.supxlabel("\n".join(lines), fontsize=6, color="#444444", x=0.01, ha="left", linespacing=1.15)


def captions_tex(captions, folder="."):
    """A \\newcommand for the caption of each figure: \\trophicVelocity for velocity."""

    def command(name):
        return "trophic" + "".join(
            part.capitalize() for part in "".join(c if c.isalpha() else " " for c in name).split()
        )

    superscript = r"\textsuperscript{2}"
    lines = ["% \\input{captions}; then \\includegraphics{velocity} \\caption{\\trophicVelocity}"]
    return (
        "\n".join(
            lines
            + [
                f"\\newcommand{{\\{command(name)}}}{{{latex_text(one_line(text)).replace('²', superscript)}}}"
                for name, text in captions.items()
            ]
        )
        + "\n"
    )


_UNFIT = (
    ArithmeticError,
    AttributeError,
    LookupError,
    TypeError,
    ValueError,
)  # of values that a table of trophic's never has


def save_all(figures, out, with_captions=False):
    """Draws each of (name, function) into the folder OUT, which may be there, as PNG and PDF, with captions.json and captions.tex; one whose data are missing
    is left out with a line. Returns how many were drawn."""
    out.mkdir(parents=True, exist_ok=True)
    drawn = 0
    captions = {}
    for name, draw in figures:
        try:
            figure = draw()
            letter_panels(figure)
            if with_captions and getattr(figure, "caption", ""):
                _with_caption(figure)
            for ending in ("png", "pdf"):
                figure.savefig(
                    out / f"{name}.{ending}", dpi=300, metadata={"CreationDate": None} if ending == "pdf" else None
                )
        except Missing as why:
            print(f"{name}: left out: {why}", file=sys.stderr)
            plt.close("all")
            continue
        except RunError:
            raise
        except _UNFIT as error:
            raise RunError(
                f"{name}: cannot be drawn from tables that are not as trophic writes them: {error}"
            ) from None
        captions[name] = getattr(figure, "caption", "")
        plt.close(figure)
        drawn += 1
    (out / "captions.json").write_text(json.dumps(captions, indent=2) + "\n", encoding="utf-8")
    (out / "captions.tex").write_bytes(encoded(captions_tex(captions)))
    return drawn
