# SPDX-License-Identifier: MIT
"""`trophic cite`: how a paper cites a run or a set of runs."""
from __future__ import annotations

import pathlib
from collections.abc import Sequence

from . import description
from .errors import RunError
from .pool import planned_in, read_pooled, run_folders
from .runs import Runs, verify
from .words import latex_text

ENTRIES = """@misc{trophic,
  title = {trophic: ecologies of simulated robots with rules at compile time and physics behind an adapter},
  author = {{The trophic authors}},
  year = {2026},
  note = {Software, %s}
}
@article{kachler2023,
  title = {Open-endedness induced through a predator-prey scenario using modular robots},
  author = {Kachler, Dimitri and Miras, Karine},
  journal = {arXiv:2309.11275},
  year = {2023},
  doi = {10.48550/arXiv.2309.11275}
}
"""


def run(request: dict) -> int:
    """Prints a sentence about the run or the replicates in the folder `run` of the request, and BibTeX entries."""
    folder = pathlib.Path(request["run"])
    if (folder / "plan.jsonl").exists():
        raise RunError(f"{folder}: is a sweep; give one of its cells")
    folders = run_folders(folder, [])
    if not folders:
        raise RunError(f"{folder}: no runs found")
    runs = [read_pooled(one) for one in folders if one == folder or (one / "manifest.json").exists()]
    if not runs:
        raise RunError(f"{folder}: no runs found")
    for cited in runs:
        verify(cited.path)
    others = sorted({one.identity for one in runs} - {runs[0].identity})
    if others:
        raise RunError(
            f"{folder}: runs with different fingerprints: {', '.join([runs[0].identity, *others])}; cite them separately"
        )
    first = runs[0].manifest
    versions, revisions, sources = (
        sorted({one.manifest.get(key, "unknown") for one in runs})
        for key in ("trophic", "trophic_revision", "source_revision")
    )
    seed = f"master seed {first['master_seed']}" if "master_seed" in first else f"seed {first['seed']}"
    one = description.describe(Runs(folder, list(runs), planned=planned_in(folder)))
    its = [] if revisions == ["unknown"] else [f"revision {_all(revisions)}"]
    by = [] if sources == revisions else [f"program of revision {_all(sources)}"]
    made = f"in trophic {_all(versions)} ({', '.join([*its, *by, f'fingerprint {one.identity}', seed])})"
    note = ", ".join([f"version {latex_text(_all(versions))}", *map(latex_text, its)])
    also = "" if "description" in first else " The parameters are in manifest.json."
    print(f"{one.sentence(made)}{also}\n\n{ENTRIES % note}", end="")
    return 0


def _all(texts: Sequence[str]) -> str:
    return " and ".join(texts)
