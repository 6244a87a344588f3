# SPDX-License-Identifier: MIT
"""Tables and a figure of mating zones."""
import data_rows
import zones
from page_tables.cells import table


def critical_numbers(rows):
    """The number of zones at which as many runs explode as die out, for each kind of robot."""
    lines = []
    for row in rows:
        number = (
            "none"
            if row["n_c"] == ""
            else "{:.1f} [{:.1f}, {:.1f}]".format(*(float(row[name]) for name in ("n_c", "lower", "upper")))
        )
        lines.append([row["robots"], row["offspring"], row["runs"], row["lasted"], number])
    return table(["robots", "newborns of a pair", "runs", "last", "n_c"], lines)


def rules(rows):
    """How runs end under each rule, and their progress over the shadow."""

    def mean(row, name, places):
        return "" if row[name] == "" else f"{float(row[name]):.{places}f}"

    def ranged(row, name, places):
        numbers = [row[f"{name}_{part}"] for part in ("difference", "lower", "upper")]
        if "" in numbers:
            return ""
        return "{} [{}, {}]".format(*(f"{float(number):+.{places}f}" for number in numbers))

    lines = []
    for row in rows:
        ends = " / ".join(row[outcome] for outcome in zones.OUTCOMES)
        lines.append(
            [
                row["rule"],
                row["offspring"],
                row["zones"],
                ends,
                f"{float(row['mean_field_lasted']):.2f}",
                mean(row, "minutes", 0),
                mean(row, "robots", 0),
                f"{mean(row, 'turns', 3)}, {mean(row, 'turns_shadow', 3)}".strip(", "),
                ranged(row, "turns", 3),
                data_rows.p_text(row["p_holm"]),
                ranged(row, "distance_m", 1),
                row["answer"],
            ]
        )
    head = [
        "rule",
        "newborns",
        "zones",
        "die out / explode / last",
        "last without robots",
        "median minutes",
        "robots late",
        "turns to a zone, in the shadow",
        "difference",
        "p (Holm)",
        "distance, m, over the shadow",
        "answer",
    ]
    return table(head, lines)


def draw(cells, path):
    """The order parameter of the paper, explosions less extinctions over all runs, over the number of zones."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, 2, figsize=(9.0, 3.4), sharey=True, layout="constrained")
    for axis, offspring in zip(axes, ("1", "2")):
        for robots in dict.fromkeys(row["robots"] for row in cells):
            of = [row for row in cells if row["robots"] == robots and str(row["offspring"]) == offspring]
            order = [
                (int(row["exploded"]) - int(row["extinct"])) / sum(int(row[one]) for one in zones.OUTCOMES)
                for row in of
            ]
            axis.plot([int(row["zones"]) for row in of], order, marker="o", markersize=3, label=robots)
        axis.axhline(0.0, color="0.6", linewidth=0.8)
        axis.axvline(14.7, color="0.6", linestyle=":", linewidth=0.8)
        axis.set(xlabel="zones", title=f"{offspring} newborn{'s' if offspring == '2' else ''} of a pair", xlim=(0, 41))
    axes[0].set_ylabel("(explosions - extinctions) / runs")
    axes[0].legend(frameon=False, fontsize=8)
    figure.savefig(path, dpi=150)
    pyplot.close(figure)


def tables(data):
    """The function that makes each table of these."""
    made = {"zones critical": lambda: critical_numbers(data("mating_zones_critical"))}
    for name in ("rules", "again", "mujoco"):
        made[f"zones {name}"] = lambda name=name: rules(data(f"mating_zones_{name}"))
    return made
