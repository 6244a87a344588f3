# SPDX-License-Identifier: MIT
"""The tables of claims: each question with the answer, the effect, its interval and the number of runs, all from results/data."""
import data_rows

SETS = {
    "mujoco_released": ("released code, MuJoCo", "released-on-mujoco.md"),
    "mujoco_paper": ("text's rules, MuJoCo", "paper-on-mujoco.md"),
    "kinematic_released": ("released code, no bodies", "released-without-bodies.md"),
    "kinematic_paper": ("text's rules, no bodies", "paper-without-bodies.md"),
}
SWAPPED_INTO = {"paper": "swap into the text's rules", "released": "swap into the released code"}

HEADS = ["question", "answer", "effect [95 % interval]", "runs", "runs for 80 % power", "study"]

# The published figure whose margin, one deviation between runs, is the smallest effect of interest of each question.
SMALLEST = {
    "Do predators evolve to chase prey?": ("velocity of predators", ""),
    "Do prey evolve to flee?": ("velocity of prey", ""),
    "Do inherited predators make more of the catches?": ("attribution of predators", "catches count"),
    "Does wall-following of prey evolve?": ("prey at walls", ""),
    "Does wall-following of predators evolve?": ("predators at walls", ""),
    "Do the tags of the two species become more alike?": ("tag symmetry", ""),
}


def signed(row, keys):
    """Effect and interval with their unit, as readers see them."""
    speed = row["metric"].startswith("velocity")
    scale, places = (100.0, 2) if speed else (1.0, 3)
    middle, lower, upper = (data_rows.fixed(scale * float(row[key]), places, "+") for key in keys)
    return f"{middle} [{lower}, {upper}]" + (" cm/s" if speed else "")


def of(rows, **wanted):
    return next(row for row in rows if all(row[key] == value for key, value in wanted.items()))


def line(question, answer, effect, runs, where, needed=""):
    name, page = where
    return [question, answer, effect, str(runs), needed, f"[{name}]({page})"]


def power(question, row, published, tests):
    """The runs and shadows with which 80 % of studies find the smallest effect of interest, at 5 % over the tests of a set, which Holm asks of the first."""
    claim, counting = SMALLEST[question]
    smallest = float(next(of["margin"] for of in published if of["claim"] == claim and counting in of["counting"]))
    runs = data_rows.runs_for(row, smallest, 0.05 / tests)
    words = f"{100.0 * smallest:.2f} cm/s" if row["metric"].startswith("velocity") else f"{smallest:.3f}"
    return f"{runs or 'more than 1000'} (for {words})"


def evolved(data):
    """The answers to the questions in each set, with simultaneous intervals. A question is written in the first of its lines."""
    answers = {name: data(f"{name}_answers") for name in SETS}
    tests = {name: sum(row["p_holm"] != "" for row in data(name)) for name in SETS}
    lines = []
    for questions in zip(*answers.values()):
        for number, (name, row) in enumerate(zip(SETS, questions)):
            lines.append(
                line(
                    "" if number else row["question"],
                    row["answer"],
                    signed(data_rows.together(row, tests[name]), ("difference", "lower", "upper")),
                    row["runs"],
                    SETS[name],
                    power(row["question"], row, data(f"{name}_published"), tests[name]),
                )
            )
    return lines


def choices_that_matter(data):
    """The effects of single choices, rules and numbers."""
    lines = []
    keys = ("difference", "difference_lower", "difference_upper")
    question = "Do prey evolve to flee, by the parent of a newborn prey and the range in which it is looked for?"
    for parent, words in (("active", "parent must be active"), ("any", "parent may be inactive")):
        for range_m in ("12", "4"):
            row = of(
                data("ranges"),
                parent=parent,
                range_m=range_m,
                activation_m="5",
                metric="velocity",
                species="prey",
                group="inherited",
            )
            answer = f"{words}, range {range_m} m. {row['flee'][0].upper()}{row['flee'][1:]}"
            lines.append(
                line(
                    "" if lines else question,
                    answer,
                    signed(row, keys),
                    row["runs"],
                    ("readings of the text", "readings.md"),
                )
            )
    rows = [row for row in data("ablations") if row["metric"] == "wall_sticking" and row["species"] == "prey"]
    if any(row["swap"] != "brain_with_biases" for row in data("ablations")):
        raise SystemExit(
            "ablations.csv: another rule swap is significant, and answers.py says that biases are the only one"
        )
    for number, row in enumerate(rows):
        question = "" if number else "Which single difference between text and code changes a metric significantly?"
        answer = "biases in the network: prey " + ("less at walls" if float(row["difference"]) < 0 else "more at walls")
        effect = signed(row, ("difference", "lower", "upper"))
        lines.append(line(question, answer, effect, 10, (SWAPPED_INTO[row["from"]], "ablations.md")))
    for number, value in enumerate(("0.2", "0.8")):
        row = of(
            data("inheritance"),
            axis="rules.mutation.sd",
            value=value,
            metric="velocity",
            species="predator",
            group="inherited",
        )
        question = "" if number else "Do larger mutations reduce chasing?"
        keys = ("difference", "lower", "upper")
        answer = (
            f"yes, at sd {value} instead of 0.05"
            if float(row["p_holm"]) <= 0.05 and float(row["difference"]) < 0
            else "undecided"
        )
        lines.append(line(question, answer, signed(row, keys), row["seeds"], ("three parameters", "inheritance.md")))
    return lines


def conclusions(data):
    """Each published figure in each set: what its readings have in common, or the choice that it depends on."""
    published = {name: data(f"{name}_published") for name in SETS}
    claims = list(dict.fromkeys(row["claim"] for row in published["mujoco_released"]))
    return [[claim, *(of(rows, claim=claim)["summary"] for rows in published.values())] for claim in claims]


def conclusion_heads():
    return ["published figure", *(f"[{name}]({page})" for name, page in SETS.values())]
