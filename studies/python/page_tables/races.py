# SPDX-License-Identifier: MIT
"""Tables and a figure of races: of arms, of the Red Queen, and of paces."""
import itertools

import data_rows
from data_rows import p_text
from page_tables.cells import SIDES, estimated, signed, star, table
from trophic import statistics


def seconds(row, places=1):
    """A difference from the shadow with its interval."""
    if not row or not row["lower"]:
        return "too few runs"
    return "{} [{}, {}]".format(
        *(data_rows.fixed(float(row[key]), places, "+") for key in ("over_shadow", "lower", "upper"))
    )


def race_answer(late, cells):
    """The decision rule of the study: late global progress of both species above the shadow, Holm over the two, corrected for the cells of the table."""
    better = [
        species
        for species, row in late.items()
        if row["p_holm"] and cells * float(row["p_holm"]) <= 0.05 and float(row["over_shadow"]) > 0.0
    ]
    if any(not row["p_holm"] for row in late.values()):
        return "too few runs"
    return (
        "arms race"
        if len(better) == 2
        else f"progress of {better[0].replace('predator', 'predators')}"
        if better
        else "none found"
    )


RACED = [
    ("velocity", "prey", "prey, cm/s"),
    ("velocity", "predator", "predators, cm/s"),
    ("global early", "predator", "predators early, s"),
    ("global early", "prey", "prey early, s"),
    ("global late", "predator", "predators late, s"),
    ("global late", "prey", "prey late, s"),
]


def race(rows):
    """Velocity and global progress over the shadow, as far as they are measured, and the answer of the decision rule, in each cell."""
    columns = [column for column in RACED if any((row["measure"], row["species"]) == column[:2] for row in rows)]
    lines = []
    cells = list(dict.fromkeys(row["cell"] for row in rows))
    for cell in cells:
        of_cell = {(row["measure"], row["species"]): row for row in rows if row["cell"] == cell}
        late = {species: of_cell["global late", species] for species in ("predator", "prey")}
        lines.append(
            [
                f"`{cell}`",
                *(
                    seconds(of_cell.get((measure, species)), 2 if measure == "velocity" else 1)
                    for measure, species, _ in columns
                ),
                late["prey"]["runs"],
                race_answer(late, len(cells)),
            ]
        )
    return table(["cell", *(head for _, _, head in columns), "runs", "arms race"], lines)


def historical(rows):
    """Progress against opponents from the same run."""
    lines = []
    for cell in dict.fromkeys(row["cell"] for row in rows if row["measure"].startswith("historical")):
        of_cell = {(row["measure"], row["species"]): row for row in rows if row["cell"] == cell}
        lines.append(
            [
                f"`{cell}`",
                *(
                    seconds(of_cell.get((f"historical {period}", species)))
                    for period in ("early", "late")
                    for species in ("predator", "prey")
                ),
            ]
        )
    return table(["cell", "predators early, s", "prey early, s", "predators late, s", "prey late, s"], lines)


QUEEN = {
    "gene_change": "gene_change",
    "turn_change": "turn_change",
    "progress_late": "progress, late, s",
    "progress_early": "progress, early, s",
}


def queen(rows, primary, *names):
    """Differences of a side between worlds in which the other one inherits and does not, in these tables; * after Holm's correction for the family."""
    lines = []
    for row in rows:
        name = row["table"].removesuffix("_by_side")
        if name not in names or (row["family"] == "primary") != primary or row["measure"].startswith("mutation"):
            continue
        words = QUEEN.get(
            row["measure"],
            row["measure"].replace("_all", " of `turns_to`").replace("_late", " of `turns_to`, last third"),
        )
        lines.append(
            [
                f"`{name}`",
                words,
                {"predator": "predators"}.get(row["side"], row["side"]),
                *(row[key] and f"{float(row[key]):+.3g}" for key in ("both", row["side"])),
                signed(row, ("difference", "lower", "upper")) + star(row["p_holm"]),
                p_text(row["p_holm"]),
                row["detectable"] and f"{float(row['detectable']):.2g}",
                row["runs"],
            ]
        )
    return table(
        [
            "table",
            "measure",
            "side",
            "both inherit",
            "this side alone",
            "both less alone",
            "p (Holm)",
            "found in 80 %",
            "runs",
        ],
        lines,
    )


PACE = {
    "trait_end": "pace at the end",
    "trait_slope": "rise of pace in the last third, per 1000 s",
    "trait_common": "pace near 8000 s, all runs",
    "trait_last_both": "pace at the last time with both, all runs",
    "sight_m_trait_end": "sight at the end, m",
    "sight_m_trait_slope": "rise of sight in the last third, m per 1000 s",
    "at_bound": "share within 5 % of the bound",
    "number": "number in the last third",
    "progress_early": "progress to 8000 s, s",
    "progress_third": "progress in the last third, s",
    "progress_late": "progress from 8000 s on, s",
}


RACE = {"pond_race": "first", "pond_race_again": "fresh", "pond_race_more": "further"}


OTHER_RACES = {"pond_race_small_steps": "sd 0.03", "pond_sight": "sight, square costs"}


def race_sets(data, file, sets):
    """The rows of sets of runs that are made, with their names in words."""
    return [
        (words, row) for name, words in sets.items() if f"{name}{file}" in data.origins for row in data(name + file)
    ]


def paces(data, sets=RACE):
    """Primary differences of a side between the world in which both inherit and that in which it alone does; * after Holm's correction."""
    lines = [
        [
            PACE[row["measure"]],
            SIDES[row["side"]],
            words,
            *(row[key] and f"{float(row[key]):+.3g}" for key in ("both", row["side"], "none")),
            signed(row, ("difference", "lower", "upper")) + star(row["p_holm"]),
            p_text(row["p_holm"]),
            row["detectable"] and f"{float(row['detectable']):.2g}",
            f"{row['runs']}, {row['alone_runs']}",
        ]
        for words, row in race_sets(data, "", sets)
        if row["family"] == "primary"
    ]
    lines.sort(key=lambda line: (list(PACE.values()).index(line[0]), list(SIDES.values()).index(line[1])))
    head = ["measure", "side", "seeds", "both inherit", "this side alone", "none", "both less alone", "p (Holm)"]
    return table([*head, "found in 80 %", "runs: both, alone"], lines)


def in_each_world(data, sets=RACE):
    """The mean of each measure of a side, with its interval over runs, in the worlds in which the side inherits."""
    found = {}
    for words, row in race_sets(data, "_values", sets):
        if row["measure"] in PACE and row["value"]:
            found.setdefault((row["measure"], row["side"], words), {}).setdefault(row["world"], []).append(
                float(row["value"])
            )
    lines = []
    for measure, words in PACE.items():
        for side, sides in SIDES.items():
            for of_set in sets.values():
                worlds = found.get((measure, side, of_set), {})
                cells = [statistics.estimate(worlds.get(world, [])) for world in ("both", side)]
                if any(cell.runs for cell in cells):
                    lines.append([words, sides, of_set, *(estimated(cell) for cell in cells)])
    return table(["measure", "side", "seeds", "both inherit", "this side alone"], lines)


QUESTIONS = {
    "Does it go on?": ("_goes_on", {"trait_slope": "pace", "progress_third": "contests"}, "goes on"),
    "Does the other side drive it?": ("", {"trait_end": "pace", "progress_late": "contests"}, "driven"),
}


def race_answers(data):
    """The answers by the rule of the design: yes, if both measures of a side are greater after correction in two sets that follow one another."""
    lines = []
    for question, (file, measures, word) in QUESTIONS.items():
        rows = race_sets(data, file, RACE)
        for side, sides in SIDES.items():
            greater = {
                words: [
                    name
                    for measure, name in measures.items()
                    for of, row in rows
                    if (of, row["side"], row["measure"]) == (words, side, measure)
                    and star(row["p_holm"])
                    and float(row["difference"]) > 0.0
                ]
                for words in dict.fromkeys(of for of, _ in rows)
            }
            all_of = [len(greater.get(of, [])) == len(measures) for of in RACE.values()]
            answer = word if any(all(pair) for pair in itertools.pairwise(all_of)) else "undecided"
            lines.append(
                [
                    question,
                    sides,
                    *(" and ".join(greater.get(of, ["not run"])) or "neither" for of in RACE.values()),
                    answer,
                ]
            )
    return table(["question", "side", *(f"greater in the {of} runs" for of in RACE.values()), "answer"], lines)


def pooled_paces(data):
    """Differences of a side between the world in which both inherit and that in which it alone does, over the runs of all sets; described."""
    values = {}
    for _, row in race_sets(data, "_values", RACE):
        if row["value"]:
            values.setdefault((row["measure"], row["side"], row["world"]), []).append(float(row["value"]))
    lines = []
    for measure, side in itertools.product(QUESTIONS["Does the other side drive it?"][1], SIDES):
        both, alone = (values.get((measure, side, world), []) for world in ("both", side))
        if of := statistics.contrast((1.0, both), (-1.0, alone)):
            interval = "{:+.3g} [{:+.3g}, {:+.3g}]".format(of.value, *statistics.interval_of(of))
            lines.append([PACE[measure], SIDES[side], interval, f"{len(both)}, {len(alone)}"])
    return table(["measure", "side", "both less alone", "runs: both, alone"], lines)


def going_on(data, sets=RACE):
    """Whether pace and contests still move in the last third where both inherit; * after Holm's correction."""
    lines = [
        [
            PACE[row["measure"]],
            SIDES[row["side"]],
            words,
            signed(row, ("difference", "lower", "upper")) + star(row["p_holm"]),
            {"none": "the world of none"}.get(row["over"], row["over"]),
            p_text(row["p_holm"]),
            row["detectable"] and f"{float(row['detectable']):.2g}",
            row["runs"],
        ]
        for words, row in race_sets(data, "_goes_on", sets)
    ]
    lines.sort(key=lambda line: (list(PACE.values()).index(line[0]), list(SIDES.values()).index(line[1])))
    return table(["measure", "side", "seeds", "both inherit", "over", "p (Holm)", "found in 80 %", "runs"], lines)


def through_time(data, sets=RACE):
    """How long hunters of each time take to reach victims of each time."""
    lines = {}
    for words, row in race_sets(data, "_through_time", sets):
        lines.setdefault((words, row["hunters_s"]), []).append(signed(row, ("contact_s", "lower", "upper"), 1.0, ""))
    times = ("the start", "12,000 s", "24,000 s")
    found = {words: [of for (set_, _), of in lines.items() if set_ == words] for words, _ in lines}
    return table(
        ["seeds", "predators of", *(f"prey of {time}" for time in times)],
        [[words, time, *of] for words, rows in found.items() for time, of in zip(times, rows)],
    )


def lasting(data, sets=RACE):
    """How many runs of each world keep both species to the end."""
    lives = {}
    for words, row in race_sets(data, "_values", sets):
        if row["measure"] == "lived_s" and row["side"] == "prey":
            lives.setdefault((words, row["world"]), []).append(float(row["value"]) >= 24000.0)
    worlds = {"both": "both inherit", "prey": "prey alone", "predator": "predators alone", "none": "none"}
    lines = [
        [
            words,
            *(
                f"{sum(of)} of {len(of)}" if of else "not run"
                for of in (lives.get((words, each), []) for each in worlds)
            ),
        ]
        for words in dict.fromkeys(words for words, _ in lives)
    ]
    return table(["seeds", *worlds.values()], lines)


def draw_race(rows, path):
    """The mean pace of each run by time: of each side, if both inherit and if it alone does, with the range of drift."""
    import matplotlib.pyplot as plt

    fig, axes = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained", sharey=True)
    colors = {"both": {"prey": "#1b7837", "predator": "#b2182b"}, "alone": "#8073ac"}
    for ax, (side, words) in zip(axes, SIDES.items()):
        other = SIDES["predator" if side == "prey" else "prey"]
        drift = {}
        for world in (side, "both"):
            of = [row for row in rows if (row["world"], row["side"], row["trait"]) == (world, side, "walking_pace")]
            if not of:
                continue
            color = colors["both"][side] if world == "both" else colors["alone"]
            label = f"{other} evolve too" if world == "both" else f"{words} alone evolve"
            lines, means = {}, {}
            for row in of:
                time_s = float(row["time_s"])
                lines.setdefault(row["run"], []).append((time_s, float(row["mean"])))
                means.setdefault(time_s, []).append(float(row["mean"]))
                drift.setdefault(time_s, []).append((float(row["drift_lower"]), float(row["drift_upper"])))
            for line in lines.values():
                ax.plot(*zip(*line), color=color, alpha=0.25, lw=0.8)
            mean = [(time_s, sum(of) / len(of)) for time_s, of in sorted(means.items())]
            ax.plot(*zip(*mean), color=color, lw=2.5, label=label)
        band = [(time_s, *(sum(each) / len(of) for each in zip(*of))) for time_s, of in sorted(drift.items())]
        times, low, high = zip(*band)
        ax.fill_between(times, low, high, color="grey", alpha=0.25, lw=0, label="drift of a run, 95 %")
        ax.set(title=words, xlabel="time [s]", xlim=(0, max(times)))
        ax.legend(fontsize=8, loc="upper left", frameon=False)
    axes[0].set(ylabel="mean walking pace", ylim=(0, None))
    fig.savefig(path, dpi=150)


def tables(data):
    """The function that makes each table of these."""
    made = {
        "historical": lambda: historical(data("race_arms_race")),
        "queen primary": lambda: queen(data("red_queen"), True, "paper", "pond", "growing"),
        "queen other": lambda: queen(data("red_queen"), False, "paper"),
        "queen mujoco": lambda: queen(data("red_queen_mujoco"), True, "released"),
        "paces worlds": lambda: in_each_world(data),
        "paces answers": lambda: race_answers(data),
        "paces driven": lambda: paces(data),
        "paces pooled": lambda: pooled_paces(data),
        "paces go on": lambda: going_on(data),
        "paces through time": lambda: through_time(data),
        "paces last": lambda: lasting(data, RACE | OTHER_RACES),
        "paces other driven": lambda: paces(data, OTHER_RACES),
        "paces other worlds": lambda: in_each_world(data, OTHER_RACES),
        "paces other go on": lambda: going_on(data, OTHER_RACES),
    }
    for name in ("arms_race", "ranges", "room", "mujoco", "mujoco_brains"):
        made[f"race {name}"] = lambda name=name: race(data(f"race_{name}"))
    return made
