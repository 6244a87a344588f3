#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""metrics_by_pandas.py PREDATOR_PREY TROPHIC: the paper's five metrics, from the CSVs by pandas alone, agree with `trophic analyze`."""
import json, pathlib, subprocess, sys, tempfile  # noqa: E401
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "program"))
import figures_python  # noqa: E402
figures_python.continue_with_pandas()
import pandas as pd  # noqa: E402

def groups(rows):
    return {"all": rows, "random": rows[rows.origin == "random"], "inherited": rows[rows.origin == "inherited"], "active": rows[rows.active == 1]}

def metrics(folder):
    """{(metric, species, group): value} of one run with ticks of 2 s."""
    half_side_m = json.loads((folder / "manifest.json").read_text())["arena"]["half_side_m"]
    events, agents = pd.read_csv(folder / "events.csv"), pd.read_csv(folder / "agents.csv")
    caught, catches = events[(events.cause == "caught") & (events.species == "prey")], events[events.event == "catch"]
    share = lambda rows: (rows.origin == "inherited").mean()  # noqa: E731
    values = {("attribution_caught", "prey", "all"): share(caught), ("attribution_catches", "predator", "all"): share(catches),
              ("attribution_catchers", "predator", "all"): share(catches.drop_duplicates("id"))}
    place = agents.set_index(["tick", "id"])[["x_m", "y_m", "time_s", "body"]]
    agents["stored"] = agents.join(place.add_prefix("its_"), on=["tick", "adversary_id"]).its_body.groupby(agents.body).ffill()
    agents["end"] = agents.tick + 6
    walk = agents.join(place.add_prefix("later_"), on=["end", "id"])
    of_body = agents.set_index(["tick", "body"])[["x_m", "y_m"]]
    for metric, others, key, ends in (("velocity", place, "adversary_id", 1), ("velocity_points", place, "adversary_id", 100),
                                      ("velocity_stored", of_body, "stored", 1)):
        a = walk[walk.end % ends == 0].join(others.add_prefix("its_"), on=["tick", key]).dropna(subset=["its_x_m", "later_x_m"])
        distances = [((a.its_x_m - a[f"{at}x_m"]) ** 2 + (a.its_y_m - a[f"{at}y_m"]) ** 2) ** 0.5 for at in ("", "later_")]
        a = a.assign(v=(distances[0] - distances[1]) / (a.later_time_s - a.time_s), window=(a.tick - 1).clip(lower=0) // 100)
        for group, rows in groups(a).items():
            mean = rows.groupby(["species", "window"]).v.mean().groupby("species").mean()
            values.update({(metric, species, group): value for species, value in mean.items()})
    agents["at_wall"] = half_side_m - agents[["x_m", "y_m"]].abs().max(axis=1) <= 1
    for group, rows in groups(agents).items():
        walls = rows.groupby(["tick", "species"]).at_wall.mean().groupby("species").mean()
        values.update({("wall_sticking", species, group): value for species, value in walls.items()})
        if group in ("all", "active"):
            values["wall_sticking_gap", "prey-predator", group] = walls.prey - walls.predator
    for group, rows in (("inherited", agents), ("inherited_active", agents[agents.active == 1])):
        tags = rows[rows.origin == "inherited"].groupby(["tick", "species"]).tag.mean().unstack().dropna()
        values["tag_symmetry", "prey+predator", group] = tags.sum(axis=1).abs().mean()
    return values

with tempfile.TemporaryDirectory() as name:
    for rules in ("paper", "released"):
        run, out = pathlib.Path(name, rules), pathlib.Path(name, f"{rules}-out")
        subprocess.run([sys.argv[1], "--backend", "kinematic", "--rules", rules, "--duration", "1500", "--out", run], check=True, stdout=-3)
        subprocess.run([sys.argv[2], "analyze", run, "--out", out], check=True, stdout=-3)
        table = pd.read_csv(out / "metrics.csv")
        table = table[table.baseline.isna() & table.time_s.isna() & table.metric.str.contains("attribution_ca|velocity|wall|tag")]
        theirs, ours = table.set_index(["metric", "species", "group"]).value.to_dict(), metrics(run)
        assert len(ours) == 39 and ours.keys() == theirs.keys(), ours.keys() ^ theirs.keys()
        wrong = {key: (ours[key], theirs[key]) for key in ours if not abs(ours[key] - theirs[key]) <= 1e-12 * abs(theirs[key])}
        assert not wrong, wrong
