# SPDX-License-Identifier: MIT
"""strangers_price.py RUN [COLUMN]: Price's equation for a column of genomes.csv, from the tables of a run by pandas and loops alone."""
import json
import pathlib
import sys

import pandas


def weights_of(chosen, moments):
    """How often each class of age and origin is chosen, of greatest conditional likelihood: {class: weight}. `chosen`: of each choice its class;
    `moments`: of each choice the classes of all that live then."""
    classes = sorted({one for living in moments for one in living})
    weights = dict.fromkeys(classes, 1.0)
    for _ in range(30):
        due = dict.fromkeys(classes, 0.0)
        for living in moments:
            total = sum(weights[one] for one in living)
            for one in living:
                due[one] += weights[one] / total
        weights = {one: weights[one] * (chosen.count(one) + 0.5) / (due[one] + 0.5) for one in classes}
    return weights


def expected(choices):
    """Of each choice, (age of the chosen, its origin, {id: (z, age, origin)} of the living), the mean z of the living by these weights."""
    ages = sorted(age for age, _, _ in choices)
    count = min(6, len(ages) // 10)
    edges = sorted({pandas.Series(ages).quantile(number / count) for number in range(1, count)}) if count > 1 else None

    def class_of(age, origin):
        return (sum(age > edge for edge in edges), origin) if edges is not None else (0, 0)

    moments = [[class_of(age, origin) for _, age, origin in living.values()] for _, _, living in choices]
    weights = weights_of([class_of(age, origin) for age, origin, _ in choices], moments)
    return [
        sum(weights[one] * z for one, (z, _, _) in zip(classes, living.values())) / sum(weights[one] for one in classes)
        for classes, (_, _, living) in zip(moments, choices)
    ]


def price(folder, column):
    """{(species, term): value} of a run."""
    folder = pathlib.Path(folder)
    manifest = json.loads((folder / "manifest.json").read_text())
    events = pandas.read_csv(folder / "events.csv")
    trait = pandas.read_csv(folder / "genomes.csv").set_index("id")[column].to_dict()
    found = {}
    for species in manifest["species"]:
        living, born_s, ended_s, offspring, children, inherited = {}, {}, {}, {}, [], set()
        sums = dict.fromkeys(("survival", "parenthood", "mutation", "newcomers", "cohorts"), 0.0)
        start = None
        kinds, rest = {}, {}  # by cause of death or "parent": choices, and (z, mean z, n) of each
        for event in events[(events.species == species) & events.event.isin(["birth", "death"])].itertuples():
            n, z = len(living), trait[event.id]
            now = {id: (of, event.time_s - born_s[id], id in inherited) for id, of in living.items()}
            mean = sum(living.values()) / n if n else None
            start = mean if start is None and event.tick > 0 else start
            if event.event == "death":
                kinds.setdefault(event.cause, []).append((*now[event.id][1:], now))
                rest.setdefault(event.cause, []).append((z, mean, n))
                del living[event.id]
                ended_s[event.id] = event.time_s
                continue
            if event.tick > 0:
                if pandas.isna(event.parent_id):
                    sums["newcomers"] += (z - mean) / (n + 1)
                else:
                    parent = trait[int(event.parent_id)]
                    kinds.setdefault("parent", []).append((*now[int(event.parent_id)][1:], now))
                    rest.setdefault("parent", []).append((parent, mean, n))
                    sums["mutation"] += (z - parent) / (n + 1)
            if not pandas.isna(event.parent_id):
                offspring[int(event.parent_id)] = offspring.get(int(event.parent_id), 0) + 1
                children.append(event.id)
                inherited.add(event.id)
            living[event.id] = z
            born_s[event.id] = event.time_s
        for kind, choices in kinds.items():
            name = "parenthood" if kind == "parent" else f"survival_{kind}"
            sums[name] = sums.get(name, 0.0)
            for due, (z, mean, n) in zip(expected(choices), rest[kind]):
                if kind == "parent":
                    sums[name] += (z - due) / (n + 1)
                    sums["cohorts"] += (due - mean) / (n + 1)
                elif n > 1:
                    sums[name] -= (z - due) / (n - 1)
                    sums["survival"] -= (z - due) / (n - 1)
                    sums["cohorts"] -= (due - mean) / (n - 1)
        sums["start"], sums["end"] = start, sum(living.values()) / len(living)
        sums["change"] = sums["end"] - sums["start"]
        lives = [
            (trait[id], ended_s.get(id, manifest["clock"]["until_s"]) - born_s[id], offspring.get(id, 0))
            for id in born_s
        ]
        mean = sum(z for z, _, _ in lives) / len(lives)
        by_length = sum(z * life_s for z, life_s, _ in lives) / sum(life_s for _, life_s, _ in lives)
        by_offspring = sum(z * w for z, _, w in lives) / sum(w for _, _, w in lives)
        sums |= {"lives": by_offspring - mean, "lives_length": by_length - mean, "lives_rate": by_offspring - by_length}
        parents = events[events.event == "birth"].set_index("id").parent_id
        pairs = pandas.DataFrame([(trait[int(parents[id])], trait[id]) for id in children], columns=["parent", "child"])
        sums["offspring_on_parent"] = pairs.cov().loc["parent", "child"] / pairs.parent.var()
        sums["mutation_a_birth"] = (pairs.child - pairs.parent).mean()
        found |= {(species, term): value for term, value in sums.items()}
    return found


if __name__ == "__main__":
    print(pandas.Series(price(sys.argv[1], (sys.argv + ["w0"])[2])).to_string())
