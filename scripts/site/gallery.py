# SPDX-License-Identifier: MIT
"""The gallery: a replay that plays, a catch, the page of a run, and the shipped robots. Parts that need programs are left out without them."""

import pathlib
import shutil
import subprocess

DURATION_S = 600


def made_by_programs(root: pathlib.Path, programs: pathlib.Path, images: pathlib.Path, scratch: pathlib.Path) -> list[str]:
    """Writes replay and pictures of robots; returns the page's lines."""
    run = scratch / "gallery-run"
    shutil.rmtree(run, ignore_errors=True)
    (images / "replay.html").unlink(missing_ok=True)
    subprocess.run([programs / "trophic-predator-prey", "--backend", "kinematic", "--seed", "4", "--duration", str(DURATION_S), "--out", run], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([programs / "trophic", "show", run, "--out", images / "replay.html"], check=True, stdout=subprocess.DEVNULL)
    lines = [
        f"## A replay {{#gallery_replay}}\n\nA run of {DURATION_S} s without physics, as `trophic show` makes it. It opens at a catch; `?` lists the keys.\n",
        '@htmlonly<iframe class="replay" src="replay.html" title="a replay of a run"></iframe>@endhtmlonly\n',
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
        lines += made_by_programs(root, programs, images, out.parent)
    for picture, about in (
        ("docs/images/chase.gif", "A predator catches a prey of a pond in MuJoCo: `trophic film RUN --catch best --size 480x300 --fps 12 -o chase.gif`."),
        ("docs/show.png", "The page of a run at a catch: `trophic show RUN -o run.html`."),
    ):
        name = pathlib.PurePath(picture).name
        shutil.copy(root / picture, images / name)
        lines += [f"{about}\n", f'@htmlonly<img src="{name}" alt="{about.split(":")[0]}"/>@endhtmlonly\n']
    (out / "gallery.md").write_text("\n".join(lines))
