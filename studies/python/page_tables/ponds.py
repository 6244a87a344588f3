# SPDX-License-Identifier: MIT
"""Tables and figures of the pond, in which energy alone decides births."""
import ponds
from data_rows import p_text
from page_tables.cells import family, share, signed, star, table


def living(rows):
    """Measures of the pond and of its nulls, described: numbers change, so the shadow is not a control of one species."""
    lines, nulls = [], [null for null in ("shadow", "clones", "mean_field") if any(row[null] for row in rows)]
    for row in rows:
        if (
            row["set"] != "pond"
            or not row["mean"]
            or row["metric"]
            in ("persists", "trophic_efficiency", "pyramid_numbers", "search_rate_holling", "handling_time")
        ):
            continue
        scale, unit = (100.0, "cm/s") if row["unit"] == "m/s" else (1.0, "" if row["unit"] == "1" else row["unit"])
        name = ", ".join(filter(None, [row["metric"] + (" (inherited)" if unit == "cm/s" else ""), unit]))
        lines.append(
            [
                name,
                row["species"],
                signed(row, ("mean", "lower", "upper"), scale, ""),
                *(row[null] and f"{scale * float(row[null]):.3g}" for null in nulls),
                signed(row, ("difference", "difference_lower", "difference_upper"), scale),
            ]
        )
    return table(["measure", "of", "pond", *(null.replace("_", " ") for null in nulls), "over the shadow"], lines)


def settings(rows):
    """Persistence and velocity in each setting of the pond."""
    lines = []
    for name in dict.fromkeys(row["set"] for row in rows):
        of = {(row["metric"], row["species"]): row for row in rows if row["set"] == name}
        shares = [of["persists", species] for species in ("all", "prey", "predator")]
        lines.append(
            [
                name,
                *(f"{float(row['mean']):.2f} [{float(row['lower']):.2f}, {float(row['upper']):.2f}]" for row in shares),
                *(
                    "{:+.2f} [{:+.2f}, {:+.2f}]".format(
                        *(
                            100.0 * float(of["velocity", species][key])
                            for key in ("difference", "difference_lower", "difference_upper")
                        )
                    )
                    for species in ("prey", "predator")
                ),
                shares[0]["runs"],
            ]
        )
    return table(
        [
            "setting",
            "both persist",
            "prey",
            "predators",
            "prey over the shadow, cm/s",
            "predators over the shadow, cm/s",
            "runs",
        ],
        lines,
    )


def worlds(rows):
    """Persistence in the four worlds of the pond, and velocities over the one-sided world of their species."""
    lines = []
    for world in ponds.WORLDS:
        of = {(row["metric"], row["species"], row["family"]): row for row in rows if row["set"] == world}
        tested = [of["velocity", species, "behaviour"] for species in ponds.TESTED]
        lines.append(
            [world, share(of["persists", "all", "described"])]
            + [cell for row in tested for cell in (family(row, 100.0), p_text(row["p_holm"]))]
            + [of["persists", "all", "described"]["runs"]]
        )
    head = ["world", "both persist", "active prey over those that inherit nothing, cm/s", "p (Holm)"]
    return table([*head, "predators over those that inherit nothing, cm/s", "p (Holm)", "runs"], lines)


def world_contrasts(rows):
    """What one condition changes: in what evolves in prey, and in how long both species live."""
    lines = []
    for name, (first, second) in ponds.CONTRASTS.items():
        evolved, lived = (
            next(row for row in rows if (row["set"], row["family"]) == (name, kind))
            for kind in ("contrast", "survival")
        )
        longer = family(lived, places=0) if lived["p"] else "none dies out"
        cells = [family(evolved, 100.0), p_text(evolved["p_holm"]), longer, p_text(lived["p_holm"])]
        lines.append([name, f"{first} less {second}", *cells])
    head = ["condition", "worlds", "active prey, cm/s", "p (Holm)", "both live longer by, s", "p (log-rank, Holm)"]
    return table(head, lines)


def world_activity(rows):
    """Activity in the four worlds, and velocities that are described."""
    lines = []
    for world in ponds.WORLDS:
        of = {
            (row["metric"], row["species"], row["group"], row["null"]): row
            for row in rows
            if (row["set"], row["family"]) == (world, "described")
        }
        shares = [f"{float(of[*key, '']['mean']):.3g}" for key in ponds.ACTIVITY]
        keys = [(*key, ponds.one_sided(key)) for key in ponds.DESCRIBED]
        keys += [(*key, "shadow") for key in ponds.TESTED.values()]
        lines.append([world, *shares, *(family(of[key], 100.0) if key in of else "" for key in keys)])
    head = ["world", "inactive share of prey", "newborn inactive, s"]
    head += [
        "inactive prey over those that inherit nothing, cm/s",
        "all prey, cm/s",
        "active prey over the shadow, cm/s",
    ]
    return table([*head, "predators over the shadow, cm/s"], lines)


def world_selection(rows):
    """Price's terms of turns_to over the neutral null in the four worlds; * after Holm's correction for all."""
    lines = []
    for world in ponds.WORLDS:
        of = {(row["species"], row["group"]): row for row in rows if row["set"] == world}
        keys = [(species, term) for species in ponds.TESTED for term in ponds.TERMS]
        lines.append([world, *(family(of[key]) + star(of[key]["p_holm"]) for key in keys)])
    names = ["prey, survival", "prey, parenthood", "predators, survival", "predators, parenthood"]
    return table(["world", *names], lines)


def draw_worlds(rows, runs, end_s, path):
    """How long both species live in the four worlds, and velocities over the one-sided world of their species."""
    import matplotlib.pyplot as plt

    fig, axes = plt.subplots(1, 3, figsize=(10, 2.9), layout="constrained", width_ratios=(1.3, 1, 1))
    values, colors = ponds.Values(runs), ("#1b7837", "#b2abd2", "#e66101", "#5e3c99")
    for number, (world, color) in enumerate(zip(ponds.WORLDS, colors)):
        lives = values.lives(world, end_s)
        times = sorted(lives.ends_s[lives.died])
        steps = [(0.0, 1.0), *((time, 1.0 - (k + 1) / len(lives.died)) for k, time in enumerate(times))]
        steps.append((end_s, steps[-1][1]))
        axes[0].step(*zip(*steps), where="post", color=color, label=world, ls="-" if number != 1 else ":", lw=2)
        for ax, (species, key) in zip(axes[1:], ponds.TESTED.items()):
            row = next(
                row for row in rows if (row["set"], row["family"], row["species"]) == (world, "behaviour", species)
            )
            middle, low, high = (
                100.0 * float(row[name] or "nan") for name in ("difference", "together_lower", "together_upper")
            )
            ax.errorbar(middle, -number, xerr=[[middle - low], [high - middle]], fmt="o", color=color, capsize=3)
    axes[0].set(xlabel="time [s]", ylabel="share of runs with both species", ylim=(0, 1.03))
    axes[0].legend(fontsize=8, loc="lower left")
    for ax, words in zip(axes[1:], ("active prey", "predators")):
        ax.axvline(0.0, color="grey", lw=0.8)
        ax.set(title=words, xlabel="difference [cm/s]", yticks=[0, -1, -2, -3], ylim=(-3.5, 0.5))
        ax.set_yticklabels(list(ponds.WORLDS) if ax is axes[1] else [""] * 4, fontsize=8)
    fig.savefig(path, dpi=150)


def draw_atlas(rows, path):
    """Maps of persistence and of velocities over the shadow, by reach and growth of food. Bold: the 95 % interval of a cell's difference excludes 0."""
    import matplotlib.pyplot as plt

    fig, axes = plt.subplots(1, 3, figsize=(12, 3.4), sharey=True, layout="constrained")
    towards = "{} over the shadow [cm/s]\n+ towards {}, - away from them"
    for ax, metric, species, key, scale, words in (
        (axes[0], "persists", "all", "mean", 1, "both species live on\n[share of runs]"),
        (axes[1], "velocity", "predator", "over_shadow", 100, towards.format("predators", "prey")),
        (axes[2], "velocity", "prey", "over_shadow", 100, towards.format("prey", "predators")),
    ):
        cells = {
            (float(row["growth_1_s"]), float(row["reach_m"])): row
            for row in rows
            if (row["metric"], row["species"]) == (metric, species)
        }
        of = {at: scale * float(row[key] or "nan") for at, row in cells.items()}
        growths, reaches = (sorted(set(values)) for values in zip(*of))
        limit = max(abs(value) for value in of.values() if value == value)
        image = ax.imshow(
            [[of[growth, reach] for reach in reaches] for growth in growths],
            origin="lower",
            aspect="auto",
            cmap="Greys" if metric == "persists" else "RdBu_r",
            vmin=0 if metric == "persists" else -limit,
            vmax=2 if metric == "persists" else limit,
            alpha=0.7,
        )
        bar = fig.colorbar(image, ax=ax)
        if metric == "persists":
            bar.ax.set_ylim(0, 1)
        for row, growth in enumerate(growths):
            for column, reach in enumerate(reaches):
                cell = cells[growth, reach]
                lower, upper = (float(cell[f"over_{end}"] or "nan") for end in ("lower", "upper"))
                ax.text(
                    column,
                    row,
                    f"{of[growth, reach]:{'.1f' if scale == 1 else '+.2f'}}".replace("+nan", "no run"),
                    ha="center",
                    va="center",
                    fontsize=8,
                    weight="bold" if lower > 0 or upper < 0 else "normal",
                )
        ax.set_title(words, fontsize=9)
        ax.set(
            xlabel="reach of predators [m]",
            xticks=range(len(reaches)),
            xticklabels=reaches,
            yticks=range(len(growths)),
            yticklabels=growths,
        )
    axes[0].set_ylabel("growth of food [1/s]")
    counts = {row["runs"] for row in rows if row["metric"] == "persists"}
    fig.supxlabel(
        f"n = {' to '.join(sorted(counts))} runs and as many shadows a cell; bold: the 95 % interval of the difference from the shadow excludes 0, each cell alone",
        fontsize=8,
    )
    fig.savefig(path, dpi=150)


def tables(data):
    """The function that makes each table of these."""
    return {
        "worlds": lambda: worlds(data("no_criterion")),
        "worlds contrasts": lambda: world_contrasts(data("no_criterion")),
        "worlds activity": lambda: world_activity(data("no_criterion")),
        "worlds selection": lambda: world_selection(data("no_criterion_selection")),
        "living": lambda: living([row for row in data("no_criterion_settings") if row["metric"] != "velocity"]),
        "living settings": lambda: settings(data("no_criterion_settings")),
        "living mujoco": lambda: living([row for row in data("no_criterion_mujoco") if row["metric"] == "velocity"]),
    }
