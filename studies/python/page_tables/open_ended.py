# SPDX-License-Identifier: MIT
"""Tables and a figure of growth at the end of long runs."""
import open_ended
from data_rows import p_text
from page_tables.cells import family, share, signed, table


def growth(rows, name="slope"):
    """Slopes at the end in a cell, over the neutral null, and their upper bounds."""
    lines = []
    for row in (row for row in rows if row["family"] == name):
        bound = row["difference_upper"] and row["generation_s"]
        per_generation = f"{float(row['difference_upper']) * float(row['generation_s']) / 1000.0:+.2f}" if bound else ""
        lines.append(
            [
                row["metric"],
                row["species"],
                signed(row, ("mean", "lower", "upper")),
                row["null_mean"] and f"{float(row['null_mean']):+.3g}",
                family(row) if row["together_lower"] else "",
                p_text(row["p_holm"]),
                row["difference_upper"] and f"{float(row['difference_upper']):+.2f}",
                per_generation,
                row["smallest"] and f"{float(row['smallest']):.2f}",
                row["runs"],
            ]
        )
    head = ["measure", "species", "slope per 1000 s", "null", "over the null", "p (Holm)", "at most per 1000 s"]
    return table([*head, "at most per generation", "found in 80 % of studies", "runs"], lines)


def two_by_two(rows, group):
    """Levels or slopes over the neutral null in the cells that are there, and the interaction of all four."""
    of = {
        (row["set"], row["metric"], row["species"], row["group"]): row for row in rows if row["family"] == "described"
    }
    cells = [cell for cell in open_ended.CELLS if any(cell == key[0] for key in of)]
    both = {(row["metric"], row["species"]): row for row in rows if row["family"] == f"interaction of {group}s"}
    described = [(metric, species) for metric in open_ended.DESCRIBED for species in open_ended.SPECIES]
    keys, lines = ("difference", "difference_lower", "difference_upper"), []
    for metric, species in [*open_ended.PAIRS, *described]:
        row = both.get((metric, species))
        lines.append([metric, species, *(signed(of[cell, metric, species, group], keys) for cell in cells)])
        lines[-1] += [family(row), p_text(row["p_holm"])] if row and row["difference"] else ["", ""]
    return table(["measure", "species", *cells, "interaction", "p (Holm)"], lines)


def by_foods(rows):
    """Slopes over the neutral null with two foods, less those with one."""
    of = [row for row in rows if row["family"] == "two foods"]
    lines = [
        [row["metric"], row["species"], family(row), p_text(row["p_holm"]), f"{float(row['smallest'] or 'nan'):.2f}"]
        for row in of
        if row["difference"]
    ]
    return table(["measure", "species", "two foods less one", "p (Holm)", "found in 80 % of studies"], lines)


def kinds_of_diet(first, again):
    """Specialists and clusters among prey with two foods, over their nulls, in the first runs and on fresh seeds."""
    lines = []
    for seeds, rows in (("first", first), ("fresh", again)):
        for row in (row for row in rows if row["family"] == "kinds of diet"):
            mean = signed(row, ("mean", "lower", "upper"))
            null = row["null_mean"] and f"{float(row['null_mean']):+.3g}"
            lines.append(
                [row["metric"], seeds, mean, row["null"], null, family(row), p_text(row["p_holm"]), row["runs"]]
            )
    return table(["measure", "seeds", "mean", "null", "its mean", "over the null", "p (Holm)", "runs"], lines)


def persisting_cells(rows):
    """The share of runs in which both species live to the end, by cell."""
    of = [row for row in rows if row["metric"] == "persists"]
    return table(["cell", "both persist", "runs"], [[row["set"], share(row), row["runs"]] for row in of])


def draw_two_by_two(rows, path):
    """Mean curves of the four cells and of their neutral nulls."""
    import matplotlib.pyplot as plt

    curves = {}
    for row in rows:
        key = (row["metric"], row["species"], row["set"], row["null"])
        curves.setdefault(key, []).append((float(row["time_s"]) / 1000.0, float(row["value"])))
    fig, axes = plt.subplots(2, 4, figsize=(12, 5), layout="constrained", sharex=True)
    colors = dict(zip(open_ended.CELLS, ("#b2abd2", "#5e3c99", "#fdb863", "#e66101")))
    named = {"links": "links in use", "most_links": "greatest links in use", "new_types": "new types", "pace": "pace"}
    for line, species in zip(axes, open_ended.SPECIES):
        for ax, (metric, words) in zip(line, named.items()):
            for cell, color in colors.items():
                for null, style in (("", "-"), ("neutral", ":")):
                    points = curves.get((metric, species, cell, null))
                    label = cell if not null else None
                    if points:
                        ax.plot(*zip(*points), color=color, ls=style, lw=1.6, label=label)
            ax.set(title=f"{words}, {species}" if species == "prey" else f"{words}, predators", ylim=(0, None))
            if species == "predator":
                ax.set_xlabel("time [1000 s]")
    axes[0][0].legend(fontsize=7, loc="lower left")
    fig.savefig(path, dpi=130)
    plt.close(fig)


def tables(data):
    """The function that makes each table of these."""
    return {
        "open ended": lambda: growth(data("open_ended")),
        "open ended two foods": lambda: growth(data("open_ended"), "slope with two foods"),
        "open ended foods": lambda: by_foods(data("open_ended")),
        "open ended kinds": lambda: kinds_of_diet(data("open_ended"), data("open_ended_again")),
        "open ended levels": lambda: two_by_two(data("open_ended"), "level"),
        "open ended slopes": lambda: two_by_two(data("open_ended"), "slope"),
        "open ended persistence": lambda: persisting_cells(data("open_ended")),
    }
