#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""authors_log.py COUNTRIES_CSV OUT: a log of positions of the paper's released code as a run's folder, which `trophic analyze OUT` takes.

The log has a row for each body every 2 s of its clock, without deaths. A body whose species changes has another individual. Its adversary is the
one that the code stores, which the robot may not see any more. Tables of events are empty, so attribution and deaths have no value."""
import json
import pathlib
import sys
import zlib

import pandas

COLUMNS = "time_s tick body id species origin active tag x_m y_m heading_rad target_angle_rad adversary_id adversary_distance_m hunger_ticks".split()
EVENTS = (
    "time_s tick event id species body tag active origin parent_id genome_id cause killer_id victim_id x_m y_m".split()
)


def agents(log: pandas.DataFrame) -> pandas.DataFrame:
    """The rows of agents.csv. Raises KeyError for a log without a column: those before 18 June 2023 lack immCheck and RanW."""
    bodies = log.id.nunique()
    place = log.position.str.strip("[]").str.split(expand=True).astype(float)
    species = log.predprey.map({"prey": "prey", "pred": "predator"})
    changes = species.ne(species.groupby(log.id).shift()).groupby(log.id).cumsum() - 1
    rows = pandas.DataFrame(
        {
            "time_s": log.simTime,
            "tick": pandas.factorize(log.simTime)[0] + 1,
            "body": log.id,
            "id": log.id + bodies * changes,
            "species": species,
            "origin": log.RanW.map({True: "random", False: "inherited"}),
            "active": log.immCheck.astype(int),
            "tag": log.tag,
            "x_m": place[0].round(6),
            "y_m": place[1].round(6),
            "heading_rad": log.angle,
            "body_b": log.otherID,
        }
    )
    its = rows[["tick", "body", "id", "species"]].rename(
        columns={"body": "body_b", "id": "adversary_id", "species": "species_b"}
    )
    rows = rows.merge(its, how="left", on=["tick", "body_b"])
    return rows.assign(adversary_id=rows.adversary_id.where(rows.species != rows.species_b).astype("Int64")).reindex(
        columns=COLUMNS
    )


def write(source: pathlib.Path, out: pathlib.Path) -> None:
    rows = agents(pandas.read_csv(source))
    out.mkdir(parents=True)
    rows.to_csv(out / "agents.csv", index=False)
    pandas.DataFrame(columns=EVENTS).to_csv(out / "events.csv", index=False)
    end_s = float(rows.time_s.max())
    manifest = {
        "fingerprint": f"{zlib.crc32(source.read_bytes()):08x}",
        "rule_table": "authors_code",
        "backend": "mujoco",
        "status": "complete",
        "seed": 0,
        "clock": {"tick_s": 2.0, "simulated_s_per_clock_s": 1.2, "until_s": end_s},
        "result": {"reached_s": end_s},
        "arena": {"half_side_m": 28 / 3},
        "species": ["prey", "predator"],
        "food_web": [{"hunter": "predator", "victim": "prey"}],
        "description": {"name": "authors' log", "sentence": f"rules of the authors' code, from {source.name}"},
    }
    (out / "manifest.json").write_text(json.dumps(manifest, indent=1) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 3 or pathlib.Path(sys.argv[2]).exists():
        sys.exit(f"usage: {sys.argv[0]} COUNTRIES_CSV OUT, a folder that does not exist")
    write(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
