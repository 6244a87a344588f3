# SPDX-License-Identifier: MIT
"""strangers_price.py RUN [COLUMN]: Price's equation for a column of genomes.csv, from the tables of a run by pandas and loops alone."""
import json
import pathlib
import sys

import pandas


def price(folder, column):
    """{(species, term): value} of a run."""
    folder = pathlib.Path(folder)
    manifest = json.loads((folder / "manifest.json").read_text())
    events = pandas.read_csv(folder / "events.csv")
    trait = pandas.read_csv(folder / "genomes.csv").set_index("id")[column].to_dict()
    found = {}
    for species in manifest["species"]:
        living, born_s, ended_s, offspring, children = {}, {}, {}, {}, []
        sums = dict.fromkeys(("survival", "parenthood", "mutation", "newcomers"), 0.0)
        start = None
        for event in events[(events.species == species) & events.event.isin(["birth", "death"])].itertuples():
            n, z = len(living), trait[event.id]
            mean = sum(living.values()) / n if n else None
            start = mean if start is None and event.tick > 0 else start
            if event.event == "death":
                if n > 1:
                    sums["survival"] += -(z - mean) / (n - 1)
                    sums[f"survival_{event.cause}"] = sums.get(f"survival_{event.cause}", 0.0) - (z - mean) / (n - 1)
                del living[event.id]
                ended_s[event.id] = event.time_s
                continue
            if event.tick > 0:
                if pandas.isna(event.parent_id):
                    sums["newcomers"] += (z - mean) / (n + 1)
                else:
                    parent = trait[int(event.parent_id)]
                    sums["parenthood"] += (parent - mean) / (n + 1)
                    sums["mutation"] += (z - parent) / (n + 1)
            if not pandas.isna(event.parent_id):
                offspring[int(event.parent_id)] = offspring.get(int(event.parent_id), 0) + 1
                children.append(event.id)
            living[event.id] = z
            born_s[event.id] = event.time_s
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
