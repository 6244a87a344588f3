# SPDX-License-Identifier: MIT
"""The gallery: pages of runs, a catch, the picture of a page, and the shipped robots. Parts that need programs are left out without them."""

import pathlib
import shutil
import subprocess

# Runs of a study: about it, program, rule table, length in s, parameters.
RUNS = {
    "pond": ("A pond without a criterion ([the study](@ref page_studies_results_no_criterion)).", "trophic-worlds", "pond", 12000),
    "atlas_flee": ("A cell of its atlas: predators chase and prey flee.", "trophic-worlds", "pond", 6000, "rules.capture.reach_m=0.7", "rules.resource.growth_1_s=0.024"),
    "atlas_approach": ("Predators reach 2 m and food grows slowly.", "trophic-worlds", "pond", 6000, "rules.capture.reach_m=2", "rules.resource.growth_1_s=0.0015"),
    "atlas_end": ("Predators reach 2 m and die out.", "trophic-worlds", "pond", 6000, "rules.capture.reach_m=2", "rules.resource.growth_1_s=0.006"),
}


def make_pages(programs: pathlib.Path, out: pathlib.Path) -> None:
    """Writes the page of each of RUNS that is missing, `out`/NAME.html."""
    out.mkdir(exist_ok=True)
    for name, (_, program, table, duration_s, *changes) in RUNS.items():
        run, page = out / f"{name}-run", out / f"{name}.html"
        if not page.exists():
            shutil.rmtree(run, ignore_errors=True)
            command = [programs / program, "--backend", "kinematic", "--rules", table, "--replicates", "1", "--seed", "1", "--duration", str(duration_s)]
            subprocess.run([*command, *(part for change in changes for part in ("--set", change)), "--out", run], check=True, stdout=subprocess.DEVNULL)
            subprocess.run([programs / "trophic", "show", run / "replicate-00", "--out", page], check=True, stdout=subprocess.DEVNULL)
            shutil.rmtree(run)


def made_by_programs(root: pathlib.Path, programs: pathlib.Path, images: pathlib.Path) -> list[str]:
    """Writes pages of runs and pictures of robots; returns the page's lines."""
    make_pages(programs, images)
    lines = ["## Runs {#gallery_runs}\n\nRuns without physics, as `trophic show` makes their pages. Each opens at a catch; `?` lists the keys.\n"]
    lines += [f'- @htmlonly<a href="{name}.html">{name}</a>@endhtmlonly: {about}\n' for name, (about, *_) in RUNS.items()]
    lines += [
        '@htmlonly<iframe class="replay" src="pond.html" title="a run of pond"></iframe>@endhtmlonly\n',
        "## Robots {#gallery_robots}\n\nThe shipped robot files, drawn by `trophic film --robot`.\n",
    ]
    for robot in sorted((root / "models/robots").glob("*.toml")):
        picture = images / f"robot_{robot.stem}.png"
        picture.unlink(missing_ok=True)
        done = subprocess.run([programs / "trophic", "film", "--robot", robot, "--size", "960x540", "--out", picture], capture_output=True, text=True)
        if done.returncode != 0:
            return [*lines, f"They cannot be drawn here: {done.stderr.strip()}\n"]
        lines.append(f'@htmlonly<img src="{picture.name}" alt="the robot {robot.stem}"/>@endhtmlonly\n')
    return lines


def write(root: pathlib.Path, out: pathlib.Path, images: pathlib.Path, programs: pathlib.Path | None) -> None:
    lines = ["Gallery {#page_gallery}", "=" * 20, ""]
    if programs:
        lines += made_by_programs(root, programs, images)
    for picture, about in (
        ("docs/images/chase.gif", "A predator catches a prey of a pond in MuJoCo: `trophic film RUN --catch best --size 480x300 --fps 12 -o chase.gif`."),
        ("docs/show.png", "The page of a run at a catch: `trophic show RUN -o run.html`."),
    ):
        name = pathlib.PurePath(picture).name
        shutil.copy(root / picture, images / name)
        lines += [f"{about}\n", f'@htmlonly<img src="{name}" alt="{about.split(":")[0]}"/>@endhtmlonly\n']
    (out / "gallery.md").write_text("\n".join(lines))
