# SPDX-License-Identifier: MIT
"""The tables of claims: each question with the answer, the effect, its interval and the number of runs, all from docs/results/data."""

SETS = {"mujoco_released": ("released code, MuJoCo", "released-on-mujoco.md"), "mujoco_paper": ("text's rules, MuJoCo", "paper-on-mujoco.md"),
        "kinematic_released": ("released code, no bodies", "released-without-bodies.md"),
        "kinematic_paper": ("text's rules, no bodies", "paper-without-bodies.md")}
SWAPPED_INTO = {"paper": "swap into the text's rules", "released": "swap into the released code"}

# question, metric, answer if above the shadow, answer if below
EVOLVED = [("Do predators evolve to chase prey?", ("velocity", "predator", "inherited"), "yes, they approach faster", "no, they approach more slowly"),
           ("Do prey evolve to flee?", ("velocity", "prey", "inherited"), "no, they approach", "yes, they move away faster"),
           ("Do inherited predators make more of the catches?", ("attribution_catches", "predator", "all"), "yes, more", "no, less"),
           ("Does wall-following of prey evolve?", ("wall_sticking", "prey", "all"), "yes, more at walls", "yes, less at walls"),
           ("Does wall-following of predators evolve?", ("wall_sticking", "predator", "all"), "yes, more at walls", "yes, less at walls"),
           ("Do the tags of the two species become more alike?", ("tag_symmetry", "prey+predator", "inherited"), "yes, more alike", "no, less alike")]


def signed(row, keys):
    """Effect and interval with their unit, as readers see them."""
    speed = row["metric"].startswith("velocity")
    scale, places = (100.0, 2) if speed else (1.0, 3)
    middle, lower, upper = (f"{scale * float(row[key]):+.{places}f}" for key in keys)
    return f"{middle} [{lower}, {upper}]" + (" cm/s" if speed else "")


def said(row, keys, above, below):
    """The answer, "barely" if the interval ends within a twentieth of its length from zero."""
    lower, upper = (float(row[key]) for key in keys[1:])
    if lower <= 0 <= upper:
        return "no significant difference"
    return (above if lower > 0 else below) + (", barely" if min(abs(lower), abs(upper)) < 0.05 * (upper - lower) else "")


def of(rows, **wanted):
    return next(row for row in rows if all(row[key] == value for key, value in wanted.items()))


def line(question, answer, effect, runs, where):
    name, page = where
    return [question, answer, effect, str(runs), f"[{name}]({page})"]


def evolved(data, sets=SETS, questions=EVOLVED, folder=""):
    """Each set with its neutral shadow. A question is written in the first of its lines."""
    lines = []
    keys = ("difference", "difference_lower", "difference_upper")
    for question, (metric, species, group), above, below in questions:
        for number, name in enumerate(sets):
            row = of(data(name), metric=metric, species=species, group=group)
            where = (sets[name][0], folder + sets[name][1])
            lines.append(line("" if number else question, said(row, keys, above, below), signed(row, keys), row["runs"], where))
    return lines


def in_brief(data):
    """The two questions about evolution on bodies, for the README."""
    return evolved(data, {name: SETS[name] for name in ("mujoco_released", "mujoco_paper")}, EVOLVED[:2], "docs/results/")


def choices_that_matter(data):
    """The effects of single choices, rules and numbers."""
    lines = []
    keys = ("difference", "difference_lower", "difference_upper")
    question = "Does evolution of prey depend on whether an inactive newborn may be a parent?"
    for parent, words in (("active", "parent must be active: "), ("any", "parent may be inactive: ")):
        row = of(data("ranges"), parent=parent, range_m="12", activation_m="5", metric="velocity", species="prey", group="inherited")
        answer = words + said(row, keys, "prey evolve to approach", "prey evolve to flee")
        lines.append(line("" if lines else question, answer, signed(row, keys), row["runs"], ("readings of the text", "readings.md")))
    rows = [row for row in data("ablations") if row["metric"] == "wall_sticking" and row["species"] == "prey"]
    if any(row["swap"] != "brain_with_biases" for row in data("ablations")):
        raise SystemExit("ablations.csv: another rule swap is significant, and scripts/results/answers.py says that biases are the only one")
    for number, row in enumerate(rows):
        question = "" if number else "Which single difference between text and code changes a metric significantly?"
        answer = "biases in the network: " + said(row, ("difference", "lower", "upper"), "prey more at walls", "prey less at walls")
        effect = signed(row, ("difference", "lower", "upper"))
        lines.append(line(question, answer, effect, 10, (SWAPPED_INTO[row["from"]], "ablations.md")))
    for number, value in enumerate(("0.2", "0.8")):
        row = of(data("inheritance"), axis="rules.mutation.sd", value=value, metric="velocity", species="predator", group="inherited")
        question = "" if number else "Do larger mutations reduce chasing?"
        keys = ("difference", "lower", "upper")
        answer = said(row, keys, f"no, more at sd {value}", f"yes, at sd {value} instead of 0.05")
        lines.append(line(question, answer, signed(row, keys), row["seeds"], ("three parameters", "inheritance.md")))
    return lines


def best(rows):
    """The best conclusion about a published figure, and under how many readings of the text it holds."""
    for conclusion in ("reproduced", "inconclusive", "not reproduced"):
        count = sum(row["conclusion"] == conclusion for row in rows)
        if count:
            of_all = f" ({count} of {len(rows)} readings)" if count < len(rows) else ""
            return conclusion + of_all
    raise SystemExit(f"{rows[0]['claim']}: no conclusion")


def conclusions(data):
    """Each published figure in each set: the best conclusion of its readings."""
    published = {name: data(f"{name}_published") for name in SETS}
    claims = list(dict.fromkeys(row["claim"] for row in published["mujoco_released"]))
    return [[claim, *(best([row for row in rows if row["claim"] == claim]) for rows in published.values())] for claim in claims]


def conclusion_heads():
    return ["published figure", *(f"[{name}]({page})" for name, page in SETS.values())]
