# SPDX-License-Identifier: MIT
"""Tables and a figure of the race with bodies."""
import bodies_race
import numpy
from data_rows import p_text
from page_tables.cells import SIDES, signed, star, table
from page_tables.races import race_sets


def walked(row):
    """A speed with its interval, cm/s."""
    return signed(row, ("speed_m_s", "lower", "upper"), 100.0, "")


def walks(rows):
    """How the spider as shipped walks at each pace."""
    of = [bodies_race.of_walks(rows, "as shipped", steering) for steering in ("straight", "steered")]
    lines = []
    for straight, steered in zip(*of):
        line = [straight["pace"]]
        for row in (straight, steered):
            line += [walked(row), f"{row['upright_walks']} of {row['walks']}"]
        error, swing, airborne = (float(steered[name]) for name in ("error_rad", "swing", "airborne"))
        lines.append(
            [*line, f"{error:.3f}", f"{swing:.3f}", f"{100.0 * float(steered['slip_m_s']):.1f}", f"{airborne:.2f}"]
        )
    head = ["pace", "straight, cm/s", "upright walks", "steered, cm/s", "upright walks"]
    return table([*head, "tracking error, rad", "swing", "slip, cm/s", "airborne"], lines)


def walk_ceilings(rows):
    """The ceiling of each variant and steering, and where it lies."""
    lines = []
    for variant in bodies_race.VARIANTS:
        for steering in ("straight", "steered"):
            of = bodies_race.of_walks(rows, variant, steering)
            at_one = next(row for row in of if row["pace"] == "1")
            best, beyond = bodies_race.ceiling(of)
            times = float(best["speed_m_s"]) / float(at_one["speed_m_s"])
            lines.append(
                [
                    variant,
                    steering,
                    walked(at_one),
                    walked(best),
                    best["pace"],
                    f"{times:.1f}",
                    f"{float(best['error_rad']):.3f}",
                    f"{float(best['swing']):.3f}",
                    f"{100.0 * float(best['slip_m_s']):.1f}",
                    f"{float(best['airborne']):.2f}",
                    f"{beyond['upright_walks']} of {beyond['walks']} at {beyond['pace']}" if beyond else "",
                ]
            )
    head = ["spider", "steering", "at pace 1, cm/s", "ceiling, cm/s", "at pace", "times pace 1", "tracking error, rad"]
    return table([*head, "swing", "slip, cm/s", "airborne", "upright walks beyond"], lines)


def raced_with_bodies(data, name):
    """The family of tests of the race with bodies, and persistence; a sentence if no run is complete."""
    if not (data.folder / f"{name}.csv").exists():
        return "No run of this design is complete.\n"
    rows = data(name)
    words = {"end": "at the end", "late_change": "late change"}
    lines = []
    for row in rows:
        if row["metric"] == "persists":
            continue
        lines.append(
            [
                {"both": "both inherit", "prey": "prey alone", "predator": "predators alone"}.get(
                    row["set"], row["set"]
                ),
                {"predator": "predators"}.get(row["species"], row["species"]),
                words[row["group"]],
                row["mean"] and f"{float(row['mean']):.3g}",
                row["null_mean"] and f"{float(row['null_mean']):.3g}",
                signed(row, ("difference", "difference_lower", "difference_upper")) + star(row["p_holm"]),
                p_text(row["p_holm"]),
                row["detectable"] and f"{float(row['detectable']):.2g}",
                row["runs"] + (f" and {row['null_runs'] or 0}" if row["null"] == "alone" else ""),
            ]
        )
    persists = [
        [row["set"], signed(row, ("mean", "lower", "upper"), 1.0, ""), row["runs"]]
        for row in rows
        if row["metric"] == "persists"
    ]
    head = [
        "world",
        "of",
        "when",
        "mean",
        "null, or alone",
        "difference",
        "p (Holm)",
        "found in 80 %",
        "runs that persist",
    ]
    return table(head, lines) + "\n" + table(["who inherits", "both persist", "runs"], persists)


def speeds(rows, fewest=1000):
    """How fast individuals move in the pond by their pace; those with fewer rows of data than `fewest` are left out."""
    paces, lines = {}, []
    for row in rows:
        if int(row["rows"]) >= fewest:
            of_pace = paces.setdefault((float(row["pace_from"]), row["pace_to"]), {})
            of_pace[row["species"]] = f"{float(row['speed_cm_s']):.3g}"
    for (low, high), of in sorted(paces.items()):
        lines.append([f"{low:g} to {high}", *(of.get(species, "") for species in SIDES)])
    return table(["pace", *(f"{words}, cm/s" for words in SIDES.values())], lines)


def contests_with_bodies(data):
    """Progress on MuJoCo of genomes that evolved without bodies, in the first runs and on fresh seeds."""
    sets = {"race_with_bodies_contests": "first", "race_with_bodies_contests_again": "fresh"}
    lines = [
        [
            SIDES[row["species"]],
            words,
            signed(row, ("mean", "lower", "upper")),
            row["null_mean"] and f"{float(row['null_mean']):+.3g}",
            signed(row, ("difference", "difference_lower", "difference_upper")) + star(row["p_holm"]),
            p_text(row["p_holm"]),
            row["detectable"] and f"{float(row['detectable']):.2g}",
            f"{row['runs']}, {row['null_runs']}",
        ]
        for words, row in race_sets(data, "", sets)
    ]
    head = ["progress of", "seeds", "both inherit, s", "none, s", "difference, s", "p (Holm)", "found in 80 %"]
    return table([*head, "runs: both, none"], lines)


def draw_walks(rows, path):
    """Speed, and the share of the time upside down, against pace."""
    import matplotlib.pyplot as plt

    fig, axes = plt.subplots(2, 2, figsize=(10, 5.6), layout="constrained", sharex=True, sharey="row")
    colors = ("black", "#e66101", "#b35806", "#7fbf7b", "#5aae61", "#1b7837", "#67a9cf", "#2166ac")
    for column, steering in zip(axes.T, ("straight", "steered")):
        for (variant, color), marker in zip(zip(bodies_race.VARIANTS, colors), "os^DPv<>"):
            of = bodies_race.of_walks(rows, variant, steering)
            paces, speeds, lower, upper, overturned = (
                numpy.array([float(row[name] or "nan") for row in of])
                for name in ("pace", "speed_m_s", "lower", "upper", "overturned")
            )
            bars = 100.0 * numpy.array([speeds - lower, upper - speeds])
            style = {"color": color, "marker": marker, "ms": 3.5, "lw": 1.0, "label": variant}
            column[0].errorbar(paces, 100.0 * speeds, yerr=bars, capsize=2, **style)
            column[1].plot(paces, overturned, **style)
        column[0].axhline(0.0, color="grey", lw=0.8)
        column[0].set_title({"straight": "straight ahead", "steered": "steered by ±0.7 rad"}[steering], fontsize=10)
        column[1].set(xlabel="pace [fraction of the gait's frequency]", xscale="log")
        column[1].set_xticks([0.2, 0.5, 1, 2, 4, 10], ["0.2", "0.5", "1", "2", "4", "10"])
    axes[0, 0].set_ylabel("speed along the heading [cm/s]")
    axes[1, 0].set_ylabel("share of the time upside down")
    axes[0, 0].legend(fontsize=8)
    fig.supxlabel("means of 10 walks of 180 s; bars: 95 % intervals", fontsize=8)
    fig.savefig(path, dpi=150)


def tables(data):
    """The function that makes each table of these."""
    return {
        "walks": lambda: walks(data("race_with_bodies_walks")),
        "walks ceilings": lambda: walk_ceilings(data("race_with_bodies_walks")),
        "race with bodies contests": lambda: contests_with_bodies(data),
        "race with bodies": lambda: raced_with_bodies(data, "race_with_bodies"),
        "race with bodies speeds": lambda: speeds(data("race_with_bodies_speeds")),
        "race with bodies again": lambda: raced_with_bodies(data, "race_with_bodies_again"),
        "race with bodies gaits": lambda: raced_with_bodies(data, "race_with_bodies_gaits"),
    }
