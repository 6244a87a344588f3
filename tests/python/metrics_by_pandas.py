#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""metrics_by_pandas.py PREDATOR_PREY TROPHIC: the paper's five metrics, from the CSVs by pandas alone, agree with `trophic analyze`."""
import json, pathlib, subprocess, sys, tempfile  # noqa: E401

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "program"))
import figures_python  # noqa: E402

figures_python.continue_with_pandas()
import pandas as pd  # noqa: E402


def groups(rows):
    return {
        "all": rows,
        "random": rows[rows.origin == "random"],
        "inherited": rows[rows.origin == "inherited"],
        "active": rows[rows.active == 1],
    }


def locked(agents):
    """Whether each row's body is within 0.3 m of another one at seven consecutive ticks or more around it."""
    two = agents.merge(agents, on="tick", suffixes=("", "_b"))
    near = two[
        (two.body != two.body_b) & ((two.x_m - two.x_m_b) ** 2 + (two.y_m - two.y_m_b) ** 2 <= 0.09)
    ].sort_values(["body", "body_b", "tick"])
    near["stretch"] = (near.groupby(["body", "body_b"]).tick.diff() != 1).cumsum()
    near = near[near.groupby("stretch").tick.transform("size") >= 7]
    return pd.MultiIndex.from_frame(agents[["tick", "body"]]).isin(pd.MultiIndex.from_frame(near[["tick", "body"]]))


def metrics(folder):
    """{(metric, species, group): value} of one run with ticks of 2 s."""
    manifest = json.loads((folder / "manifest.json").read_text())
    half_side_m = manifest["arena"]["half_side_m"]
    events, agents = pd.read_csv(folder / "events.csv"), pd.read_csv(folder / "agents.csv")
    caught, catches = events[(events.cause == "caught") & (events.species == "prey")], events[events.event == "catch"]
    share = lambda rows: (rows.origin == "inherited").mean()  # noqa: E731
    values = {
        ("attribution_caught", "prey", "all"): share(caught),
        ("attribution_catches", "predator", "all"): share(catches),
        ("attribution_catchers", "predator", "all"): share(catches.drop_duplicates("id")),
    }
    agents["to_wall_m"], agents["locked"] = half_side_m - agents[["x_m", "y_m"]].abs().max(axis=1), locked(agents)
    agents["before"] = agents.tick + 1
    for metric, rows, species in (("caught", caught, "prey"), ("catches", catches, "predator")):
        was = rows.join(agents.set_index(["before", "id"]).locked.rename("was"), on=["tick", "id"]).was
        values[f"attribution_{metric}_not_locked", species, "all"] = share(rows[was != True])  # noqa: E712
    place = agents.set_index(["tick", "id"])[["x_m", "y_m", "time_s", "body"]]
    agents["stored"] = (
        agents.join(place.add_prefix("its_"), on=["tick", "adversary_id"]).its_body.groupby(agents.body).ffill()
    )
    agents["end"] = agents.tick + 6
    walk = agents.join(place.add_prefix("later_"), on=["end", "id"])
    of_body = agents.set_index(["tick", "body"])[["x_m", "y_m"]]
    seen = (place, "adversary_id")
    for metric, others, key, who in (
        ("velocity", *seen, walk.end > 0),
        ("velocity_points", *seen, walk.end % 100 == 0),
        ("velocity_stored", of_body, "stored", walk.end > 0),
        ("velocity_simulated", *seen, walk.end > 0),
        ("velocity_not_locked", *seen, ~walk.locked),
        ("velocity_open", *seen, walk.to_wall_m > 1),
    ):
        a = walk[who].join(others.add_prefix("its_"), on=["tick", key]).dropna(subset=["its_x_m", "later_x_m"])
        distances = [
            ((a.its_x_m - a[f"{at}x_m"]) ** 2 + (a.its_y_m - a[f"{at}y_m"]) ** 2) ** 0.5 for at in ("", "later_")
        ]
        slower = manifest["clock"]["simulated_s_per_clock_s"] if metric == "velocity_simulated" else 1
        a = a.assign(
            v=(distances[0] - distances[1]) / (a.later_time_s - a.time_s) / slower,
            window=(a.tick - 1).clip(lower=0) // 100,
        )
        for group, rows in groups(a).items():
            mean = rows.groupby(["species", "window"]).v.mean().groupby("species").mean()
            values.update({(metric, species, group): value for species, value in mean.items()})
    agents["at_wall"] = agents.to_wall_m <= 1
    for suffix, those in (("", agents), ("_not_locked", agents[~agents.locked])):
        for group, rows in groups(those).items():
            walls = rows.groupby(["tick", "species"]).at_wall.mean().groupby("species").mean()
            values.update({(f"wall_sticking{suffix}", species, group): value for species, value in walls.items()})
            if group in ("all", "active"):
                values[f"wall_sticking_gap{suffix}", "prey-predator", group] = walls.prey - walls.predator
        for group, rows in (("inherited", those), ("inherited_active", those[those.active == 1])):
            tags = rows[rows.origin == "inherited"].groupby(["tick", "species"]).tag.mean().unstack().dropna()
            values[f"tag_symmetry{suffix}", "prey+predator", group] = tags.sum(axis=1).abs().mean()
    return values


with tempfile.TemporaryDirectory() as name:
    for rules in ("paper", "released"):
        run, out = pathlib.Path(name, rules), pathlib.Path(name, f"{rules}-out")
        subprocess.run(
            [sys.argv[1], "--backend", "kinematic", "--rules", rules, "--duration", "1500", "--out", run],
            check=True,
            stdout=-3,
        )
        subprocess.run([sys.argv[2], "analyze", run, "--out", out], check=True, stdout=-3)
        table = pd.read_csv(out / "metrics.csv")
        table = table[
            table.baseline.isna()
            & table.time_s.isna()
            & table.metric.str.contains("attribution_ca|velocity|wall_s|tag")
        ]
        theirs, ours = table.set_index(["metric", "species", "group"]).value.to_dict(), metrics(run)
        assert len(ours) == 77 and ours.keys() == theirs.keys(), ours.keys() ^ theirs.keys()
        wrong = {
            key: (ours[key], theirs[key])
            for key in ours
            if not abs(ours[key] - theirs[key]) <= 1e-12 * abs(theirs[key])
        }
        assert not wrong, wrong
