# SPDX-License-Identifier: MIT
"""The origin of results: a row of data/provenance.csv for each data file, the line of a page that comes from it, and the code that changed since."""
import csv
import json
import pathlib
import re
import subprocess

FIELDS = ("data", "stage", "tables", "engine", "seeds", "runs", "revision")
NULLS = ("shadow", "neutral", "clones", "one_sided")
BEFORE = "at or before "  # begins the revision of data whose manifests are gone: that of the commit that added them


def master_of(run, folder):
    """The seed from which the seed of a run is drawn, or None if it is its own: that of the nearest replicates.json up to `folder`."""
    for parent in run.parents:
        if (parent / "replicates.json").exists():
            return json.loads((parent / "replicates.json").read_text())["master_seed"]
        if parent == folder:
            break
    return None


def facts(folder):
    """Of each run under a folder: its revision, engine, rule table, seed and null, from its manifest, and its master seed."""
    found, folder = [], pathlib.Path(folder)
    for path in sorted(folder.rglob("manifest.json")):
        manifest, parts = json.loads(path.read_text()), path.relative_to(folder).parts
        if "contests" in parts or "rule_table" not in manifest:
            continue  # not a run of an ecology
        null = next((null for null in NULLS for part in parts if part == null or part.startswith(f"{null}_")), "")
        found.append(
            {
                "revision": manifest.get("trophic_revision", manifest["source_revision"]),
                "engine": manifest["backend"],
                "table": manifest["rule_table"].split(" with ")[0] if null else manifest["rule_table"],
                "seed": manifest["seed"],
                "master": master_of(path.parent, folder),
                "null": null,
            }
        )
    return found


def seeds_of(runs):
    """The seeds of runs in words: "30 of master seed 1", or each that is its own."""
    masters = {}
    for run in runs:
        masters.setdefault(run["master"], set()).add(run["seed"])
    own = [str(seed) for seed in sorted(masters.pop(None, ()))]
    return ", ".join([f"{len(seeds)} of master seed {master}" for master, seeds in sorted(masters.items())] + own)


def row(data, stage, runs):
    """The row of a data file that a stage made of these runs."""
    counts = {}
    for run in runs:
        counts[run["null"]] = counts.get(run["null"], 0) + 1
    return {
        "data": data,
        "stage": stage,
        "tables": ", ".join(sorted({run["table"] for run in runs})),
        "engine": ", ".join(sorted({run["engine"] for run in runs})),
        "seeds": seeds_of(runs),
        "runs": " + ".join(f"{count} {null.replace('_', '-')}".strip() for null, count in sorted(counts.items())),
        "revision": ", ".join(sorted({run["revision"] for run in runs})),
    }


def read(folder):
    """{data: row} of provenance.csv in the folder of data."""
    path = folder / "provenance.csv"
    if not path.exists():
        return {}
    with open(path, newline="") as file:
        return {row["data"]: row for row in csv.DictReader(file)}


def write(folder, new):
    """Writes this row into provenance.csv, in place of an older one of the same data."""
    rows = read(folder) | {new["data"]: new}
    with open(folder / "provenance.csv", "w", newline="") as file:
        table = csv.DictWriter(file, FIELDS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows[data] for data in sorted(rows))


def line(rows):
    """What a page says of the data of a table: a sentence for each origin."""
    sentences = {}
    for of in rows:
        key = tuple(of[field] for field in FIELDS[1:])
        sentences.setdefault(key, []).append(of["data"])
    words = []
    for stage, tables, engine, seeds, runs, revision in sentences:
        names = [f"`{name}`" if re.fullmatch(r"\w+", name) else name for name in tables.split(", ")]
        tables = (
            " and ".join(filter(None, [", ".join(names[:-1]), names[-1]])) if len(names) < 6 else f"{len(names)} tables"
        )
        words.append(
            f"`studies/reproduce {stage}`: {runs} runs of {tables}, {engine}, seeds: {seeds}, revision {revision}."
        )
    return "*" + " ".join(words) + "*\n"


# The folders and files that decide the runs of every stage, and those of an engine; a stage adds its own sources.
RUNS = ("include/trophic", "src", "models")
ENGINES = {"mujoco": "backends/mujoco", "ode": "backends/ode"}
STUDY = {
    "ablations": ("studies/ablations",),
    "arms-race": ("studies/arms_race",),
    "arms-race-mujoco": ("studies/arms_race",),
    "bodies": ("studies/readings",),
    "evolution": ("studies/bodies",),
    "evolution-again": ("studies/bodies",),
    "evolvable-bodies": ("studies/bodies",),
    "inheritance": ("studies/sweeps",),
    "no-criterion-bodies": ("studies/bodies",),
    "no-criterion-gaits": ("studies/bodies",),
    "open-ended": ("studies/open_ended",),
    "pond-race": ("studies/red_queen",),
    "pond-race-again": ("studies/red_queen",),
    "pond-race-more": ("studies/red_queen",),
    "pond-race-small-steps": ("studies/red_queen",),
    "pond-sight": ("studies/red_queen", "studies/race"),
    "race-with-bodies-gaits": ("studies/bodies",),
    "race-with-bodies-walks": ("studies/race_with_bodies",),
    "ranges": ("studies/readings",),
    "red-queen": ("studies/red_queen", "studies/arms_race"),
    "red-queen-mujoco": ("studies/red_queen", "studies/arms_race"),
    "screen": ("studies/readings",),
}


def code_of(of):
    """The paths on which the runs of a row depend."""
    engines = [path for engine, path in ENGINES.items() if of["engine"].lower().find(engine) >= 0]
    return [*RUNS, *engines, *STUDY.get(of["stage"], ())]


def git(root, *arguments):
    done = subprocess.run(["git", "-C", str(root), *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"reproduce --check: git {' '.join(arguments)}: {done.stderr.strip()}")
    return done.stdout


def changes(root, of):
    """Commits after the revision of a row that touch the code of its runs, the newest first."""
    revisions = re.findall(r"\b[0-9a-f]{8,40}\b", of["revision"])
    if not revisions:
        raise SystemExit(f"provenance.csv: {of['data']}: revision: {of['revision']}: must name a commit")
    newer = [
        set(git(root, "log", "--format=%h", f"{revision}..HEAD", "--", *code_of(of)).split()) for revision in revisions
    ]
    return sorted(set().union(*newer))


def stale(root, folder):
    """[(data, revision, number of commits)] of the data that are older than the code on which their runs depend."""
    found = []
    for data, of in read(folder).items():
        if newer := changes(root, of):
            found.append((data, of["revision"], len(newer)))
    return found
