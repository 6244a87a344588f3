# SPDX-License-Identifier: MIT
"""Stages of the race with bodies."""
import bodies_race
import data_rows
import page_tables.bodies_race


def race_with_bodies_walks(study):
    """Single spiders at paces from 0.2 to 10, as shipped, and with other friction, servos and gravity."""
    rows = []
    for variant, (friction, servo, gravity) in bodies_race.VARIANTS.items():
        walked = study.out / "walks" / f"{variant.replace(' ', '-')}.csv"
        if not walked.exists():
            model = study.with_friction("robots/spider", friction, servo)
            table = study.output("trophic-walks", 10 if study.quick else 180, gravity, model)
            walked.parent.mkdir(parents=True, exist_ok=True)
            walked.write_text(table)
        study.made_of[variant] = bodies_race.walk_facts(walked)
        rows += bodies_race.walk_rows(variant, walked)
    study.write("race_with_bodies_walks", rows)
    page_tables.bodies_race.draw_walks(rows, study.data.parent / "race_with_bodies_walks.png")


def race_with_bodies(
    program, table, settings, trait, seed=7201, worlds=tuple(bodies_race.WORLDS), family=bodies_race.FAMILY
):
    """Worlds of the pond on MuJoCo, in which both species inherit this trait, one of them, or none. The data are written after each world."""

    def stage(study):
        file, values = study.stage.replace("-", "_"), []
        for world in worlds:
            changes = [*bodies_race.SETTINGS, *settings, *bodies_race.switches(bodies_race.WORLDS[world])]
            folder = study.make(
                program,
                f"{study.stage}/{world}",
                *("--backend", "mujoco", "--rules", table, "--agents-every", 6),
                *(part for change in changes for part in ("--set", change)),
                count=10,
                duration_s=12000,
                seed=seed,
                shadow=False,
            )
            values += bodies_race.values_of(world, folder, trait, 600 if study.quick else 12000)
            study.write(f"{file}_runs", values)
            study.write(file, bodies_race.results(values, trait.name, family))
            if study.stage == "race-with-bodies":
                study.write(f"{file}_speeds", bodies_race.speeds_of(study.out / "runs" / study.stage))

    return stage


INHERITED_PACE = ("trophic-worlds", "pond_race", ["rules.traits.walking_pace.most=10"], bodies_race.PACE)


def race_with_bodies_contests(seed):
    """Genomes that evolved without bodies meet on MuJoCo: those of the start and of the end of runs of the race in which both species inherit, or none."""

    def stage(study):
        end_s, rows = 1200 if study.quick else 24000, []
        for world in ("both", "none"):
            changes = bodies_race.switches(bodies_race.WORLDS[world])
            sets = [part for change in changes for part in ("--set", change)]
            options = ["--backend", "kinematic", "--rules", "pond_race", "--agents-every", 1000, *sets]
            how = {"count": 12, "duration_s": 24000, "seed": seed, "shadow": False}
            runs = sorted(study.make("trophic-worlds", f"{study.stage}/{world}", *options, **how).glob("replicate-*"))
            teams = ["--epochs", f"0,{end_s}", "--teams", 3, "--team-size", 15]
            program = ["--program", study.program("trophic-worlds"), "--backend", "mujoco", "--jobs", study.jobs]
            table = study.made(f"{study.stage}/{world}", "contests.csv", "trophic", "contest", *runs, *program, *teams)
            rows += bodies_race.progress_rows(world, table, end_s)
        file = study.stage.replace("-", "_")
        study.write(f"{file}_runs", rows)
        study.write(file, bodies_race.progress(rows))

    return stage


def race_with_bodies_picture(study):
    """The same early prey from the same places, hunted on MuJoCo by early and by late predators of a run without bodies: pictures and a film."""
    runs, end_s = study.out / "runs/race-with-bodies-picture", 600 if study.quick else 24000
    if not runs.exists():
        options = ["--backend", "kinematic", "--seed", 1, "--duration", end_s, "--agents-every", 60, "--replay-hz", 0]
        study.call("trophic-worlds", "--rules", "pond_race", *options, "--out", runs)
    teams = ["--against", "own", "--epochs", f"0,{end_s}", "--teams", 2, "--team-size", 30, "--duration", 90]
    program = ["--program", study.program("trophic-worlds"), "--backend", "mujoco", "--jobs", study.jobs]
    name = "race-with-bodies-picture"
    met = study.made(name, "contests.csv", "trophic", "contest", runs, *program, *teams, "--record").parent
    sheets, films = [], []
    for number, title in zip(bodies_race.meetings(data_rows.read(met / "contests.csv"), end_s), bodies_race.TITLES):
        for files, ending, options in (
            (sheets, "png", ["--sheet", "3x1", "--from", 0, "--to", 80, "--size", "480x400"]),
            (films, "gif", ["--speed", 12, "--fps", 8, "--size", "560x520", "--title", title]),
        ):
            files.append(met / f"contest-{number}.{ending}")
            files[-1].unlink(missing_ok=True)
            study.call("trophic", "film", met / f"contest-{number}", *options, "--view", "top", "-o", files[-1])
    bodies_race.stack(sheets, study.data.parent / "race_with_bodies_meeting.png")
    beside = "hstack,split[a][b];[a]palettegen=max_colors=64[p];[b][p]paletteuse=dither=none:diff_mode=rectangle"
    inputs = [part for film in films for part in ("-i", film)]
    film = study.data.parent / "race_with_bodies_meeting.gif"
    study.call("ffmpeg", "-v", "error", *inputs, "-filter_complex", beside, "-y", film)


STAGES = {
    "race-with-bodies-walks": race_with_bodies_walks,
    "race-with-bodies": race_with_bodies(*INHERITED_PACE),
    "race-with-bodies-again": race_with_bodies(*INHERITED_PACE, 7202, ("both",), bodies_race.AGAIN),
    "race-with-bodies-gaits": race_with_bodies("trophic-bodies", "gaits_race", [], bodies_race.FREQUENCY),
    "race-with-bodies-contests": race_with_bodies_contests(1),
    "race-with-bodies-contests-again": race_with_bodies_contests(2),
    "race-with-bodies-picture": race_with_bodies_picture,
}
