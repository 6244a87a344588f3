# SPDX-License-Identifier: MIT
"""Runs written by hand, from a few rows: robots at ticks of 2 s, events, and the folder of a run."""
import json
import pathlib
import zlib

import pandas
import pytest
from in_folder import sealed_text

from trophic.metrics import AGENTS, EVENTS, Agents, Web
from trophic.runs import RunError

EVENT_COLUMNS = (
    "time_s tick event id species body tag active origin parent_id genome_id cause killer_id victim_id x_m y_m".split()
)
AGENT_COLUMNS = (
    "time_s tick body id species origin active tag x_m y_m heading_rad target_angle_rad adversary_id adversary_distance_m "
    "hunger_ticks"
).split()
WEB = Web(["prey", "predator"], [("predator", "prey")])
NONE = float("nan")


def robot(
    tick,
    id,
    species,
    x_m=0.0,
    y_m=0.0,
    adversary_id=NONE,
    origin="inherited",
    tag=1,
    active=1,
    hunger_ticks=NONE,
    body=None,
):
    """A row of agents.csv; the body has the number of the individual unless it is named."""
    return {
        **dict.fromkeys(AGENT_COLUMNS, 0.0),
        "time_s": 2.0 * tick,
        "tick": tick,
        "body": id if body is None else body,
        "id": id,
        "species": species,
        "origin": origin,
        "active": active,
        "tag": tag,
        "x_m": x_m,
        "y_m": y_m,
        "adversary_id": adversary_id,
        "adversary_distance_m": NONE,
        "hunger_ticks": hunger_ticks,
    }


def event(kind, time_s, id, species, body=None, origin="random", cause="", victim_id=NONE, **more):
    """A row of events.csv."""
    return {
        **dict.fromkeys(EVENT_COLUMNS, 0),
        "time_s": time_s,
        "tick": int(time_s // 2),
        "event": kind,
        "id": id,
        "species": species,
        "body": id if body is None else body,
        "tag": 1,
        "active": 1,
        "origin": origin,
        "parent_id": NONE,
        "genome_id": id,
        "cause": cause,
        "killer_id": NONE,
        "victim_id": victim_id,
        **more,
    }


def agents(*rows, web=WEB):
    """Rows of robots as metrics take them."""
    return Agents(pandas.DataFrame(rows, columns=list(AGENTS)), web)


def events(*rows):
    """Events as metrics take them."""
    return pandas.DataFrame(rows, columns=list(EVENTS))


CATCH = (
    event("birth", 0, 0, "prey", origin="inherited"),
    event("birth", 0, 1, "predator", origin="inherited"),
    event("catch", 2, 1, "predator", origin="inherited", victim_id=0),
    event("death", 2, 0, "prey", origin="inherited", cause="caught", killer_id=1),
    event("birth", 2, 2, "predator", body=0),
)
"""A predator catches a prey; both inherited their genomes. The prey's body goes to a random predator."""
WALK = (
    robot(0, 0, "prey", 9.5, 2.0),
    robot(0, 1, "predator", 1.0, 2.0, adversary_id=0, hunger_ticks=0),
    robot(1, 2, "predator", 1.0, 2.0, origin="random", hunger_ticks=0, body=0),
    robot(1, 1, "predator", 1.0, 2.0, hunger_ticks=0),
)


def refusal(call, *arguments, **named):
    """The words of the RunError that a call raises."""
    with pytest.raises(RunError) as error:
        call(*arguments, **named)
    return str(error.value)


def write_run(
    folder,
    seed=1,
    *,
    heredity="own_copy",
    of_agents=WALK,
    of_events=CATCH,
    status="complete",
    until_s=6000.0,
    sums=False,
    files=(),
    **manifest,
):
    """Writes the folder of a run and returns it. `sums`: the manifest has the checksums of the tables, as that of a complete run. `files`: more
    of them, frames or texts by name. Further entries of the manifest by name; None leaves one out."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    frames = {
        "events.csv": pandas.DataFrame(of_events, columns=EVENT_COLUMNS),
        "agents.csv": pandas.DataFrame(of_agents, columns=AGENT_COLUMNS),
        **dict(files),
    }
    for file, frame in frames.items():
        whole = ("id", "body", "parent_id", "killer_id", "victim_id", "adversary_id", "hunger_ticks")
        if not isinstance(frame, str):
            frame = frame.astype({name: "Int64" for name in whole if name in frame}).to_csv(index=False)
        (folder / file).write_text(frame)
    entries = {
        "fingerprint": "aa",
        "rule_table": "paper",
        "backend": "kinematic 1",
        "status": status,
        "seed": seed,
        "clock": {"until_s": until_s},
        "arena": {"half_side_m": 10.0},
        "species": WEB.species,
        "food_web": [{"hunter": "predator", "victim": "prey"}],
        "tags": [-1, 1],
        "rules": {"heredity": heredity, "floor": "victim_floor"},
        "params": {"seed": seed, "rules": {"floor": {"floor": 7}}},
        **manifest,
    }
    if sums:
        entries["tables"] = {file: sum_of(folder / file) for file in frames}
    (folder / "manifest.json").write_text(
        json.dumps({key: value for key, value in entries.items() if value is not None})
    )
    return folder


def write_sealed_run(folder):
    """Writes the folder of a complete run with checksums of all of its files, a recording and a checkpoint, and returns it."""
    folder = write_run(folder, sums=True)
    (folder / "replay.trp").write_bytes(bytes(range(256)))
    texts = b"".join(len(text).to_bytes(8, "little") + text for text in (b"aa", b"0.1.0", b"code"))
    checkpoint = b"trophic checkpoint\n" + (5).to_bytes(4, "little") + texts + (1).to_bytes(8, "little") + bytes(100)
    (folder / "checkpoint.bin").write_bytes(checkpoint + zlib.crc32(checkpoint).to_bytes(4, "little"))
    manifest = json.loads((folder / "manifest.json").read_text())
    recording = {"frames": 1, "crc32": zlib.crc32(bytes(range(256)))}
    (folder / "manifest.json").write_text(sealed_text({"format": 2, **manifest, "recording": recording}))
    return folder


def sum_of(path):
    """Rows and checksum of a table, as a manifest lists them."""
    content = pathlib.Path(path).read_bytes()
    return {"rows": content.count(b"\n") - 1, "crc32": zlib.crc32(content)}


def write_set(folder, runs=6, shadow=True, **of_runs):
    """Writes replicates, their list and their shadow, as --replicates and --shadow do, and returns the folder."""
    folder = pathlib.Path(folder)
    names = [f"replicate-{i:02}" for i in range(runs)]
    for i, name in enumerate(names):
        write_run(folder / name, seed=i + 1, **of_runs)
    (folder / "replicates.json").write_text(json.dumps({"replicates": [{"folder": name} for name in names]}))
    if shadow:
        write_set(
            folder / "shadow", runs, shadow=False, **{"fingerprint": "bb", **of_runs, "heredity": "nothing_inherited"}
        )
    return folder
