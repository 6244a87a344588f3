# SPDX-License-Identifier: MIT
"""Whether every text of a matplotlib figure can be read: inside the figure, and no label of an axis on another."""
import itertools

from matplotlib.text import Text

SLACK = 3.0  # pixels of 1/300 inch


def problems(figure):
    """A sentence for each text that leaves the figure, and for each two labels of one axis that overlap."""
    figure.set_dpi(300)  # as they are saved
    for _ in range(2):  # as PNG and as PDF; the layout moves a little each time
        figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    hidden, found, ticks = set(), [], []
    for axes in figure.findobj(lambda one: hasattr(one, "xaxis")):
        for axis in (axes.xaxis, axes.yaxis):
            labels = [
                label
                for tick in [*axis.get_major_ticks(), *axis.get_minor_ticks()]
                for label in (tick.label1, tick.label2)
            ]
            hidden.update(labels)
            drawn = (
                [label for tick in axis._update_ticks() for label in (tick.label1, tick.label2)]
                if axes.axison and axes.get_visible()
                else []
            )
            drawn = [label for label in drawn if label.get_visible() and label.get_text()]
            ticks += drawn
            for a, b in itertools.combinations(drawn, 2):
                if overlap(a, b, renderer):
                    found.append(f"{a.get_text()!r} overlaps {b.get_text()!r}")
        if not axes.axison:
            hidden.update(text for axis in (axes.xaxis, axes.yaxis) for text in axis.findobj(Text))
    for text in [*ticks, *(text for text in figure.findobj(Text) if text not in hidden)]:
        box = text.get_window_extent(renderer)
        outside = max(-box.x0, -box.y0, box.x1 - figure.bbox.x1, box.y1 - figure.bbox.y1)
        if text.get_visible() and text.get_text().strip() and outside > SLACK:
            found.append(f"{text.get_text()!r} leaves the figure by {outside:.0f} pixels")
    return found


def overlap(a, b, renderer):
    if a.get_rotation() % 90:  # turned labels are thinner than their boxes
        return False
    a, b = (text.get_window_extent(renderer) for text in (a, b))
    return min(a.x1, b.x1) - max(a.x0, b.x0) > SLACK and min(a.y1, b.y1) - max(a.y0, b.y0) > SLACK
