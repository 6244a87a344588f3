# SPDX-License-Identifier: MIT
"""A study: the folder of its runs, how long and how many they are, and what makes and writes them."""
import json
import os
import pathlib
import shutil
import subprocess
import sys

import data_rows
import installed
import provenance

STUDIES = pathlib.Path(__file__).resolve().parents[1]


class Study:
    """The folder, length and number of runs."""

    def __init__(self, options):
        self.out = options.out.resolve()
        self.programs = options.programs.resolve()
        self.path = os.pathsep.join([str(self.programs), os.environ.get("PATH", os.defpath)])
        self.jobs = options.jobs
        self.quick = options.quick
        self.data = self.out / "data" if options.quick else STUDIES / "results/data"
        self.data.mkdir(parents=True, exist_ok=True)
        self.stage, self.made_of = "", {}

    def begin(self, stage):
        """Starts a stage: data come from the sets of runs that it makes from here on."""
        self.stage, self.made_of = stage, {}

    def note(self, name):
        """Keeps the facts of a set's manifests, also for later calls in which its runs are gone."""
        kept, runs = self.out / f"provenance/{name}.json", self.out / "runs" / name
        if runs.exists():
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_text(json.dumps(provenance.facts(runs)))
        if not kept.exists():
            raise SystemExit(
                f"reproduce: {kept}: is not there, nor are the runs in {runs}: delete the set's analysis to make it again"
            )
        self.made_of[name] = json.loads(kept.read_text())

    def program(self, name):
        """The path of a program of the studies, or of the trophic of PATH."""
        found = shutil.which(name, path=self.path)
        if found is None:
            raise SystemExit(
                f"reproduce: {name}: is neither in {self.programs}, the folder of --programs, nor in PATH: {STUDIES / 'README.md'} says how to build it"
            )
        return found

    def call(self, program, *arguments):
        command = [self.program(program), *map(str, arguments)]
        print("$", " ".join(command), flush=True)
        done = subprocess.run(
            command, cwd=self.out, stdout=subprocess.DEVNULL, env={"TROPHIC_PYTHON": sys.executable, **os.environ}
        )
        if done.returncode != 0:
            raise SystemExit(f"reproduce: exit code {done.returncode} of {' '.join(command)}")

    def output(self, program, *arguments):
        """What a program prints."""
        command = [self.program(program), *map(str, arguments)]
        print("$", " ".join(command), flush=True)
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True)
        if done.returncode != 0:
            raise SystemExit(f"reproduce: exit code {done.returncode} of {' '.join(command)}")
        return done.stdout

    def replicates(self, program, name, *arguments, only=(), **how):
        """Runs a set of replicates, with its shadow, and analyses it, or `only` these metrics. An analysed set is not repeated."""
        runs, analysis = self.out / "runs" / name, self.out / "analysis" / name
        if not (analysis / "summary.json").exists():
            self.make(program, name, *arguments, **how)
            shutil.rmtree(analysis, ignore_errors=True)
            self.call("trophic", "analyze", runs, *(["--metric", *only] if only else []), "--out", analysis)
        self.note(name)
        return json.loads((analysis / "summary.json").read_text())

    def make(self, program, name, *arguments, count, duration_s=6000, seed=1, shadow=True, senses=False):
        """Runs a set of replicates, with its shadow, or what is missing of it. Returns its folder."""
        runs = self.out / "runs" / name
        if self.quick:
            count, duration_s = 2, duration_s / 20
        options = ["--replicates", count, "--jobs", self.jobs, "--seed", seed, "--duration", duration_s]
        self.call(
            program,
            *arguments,
            *options,
            *("--replay-hz", 0, "--out", runs),
            *(["--shadow"] if shadow else []),
            *(["--senses", "--agents-every", 20] if senses else []),
            *(["--resume"] if runs.exists() else []),
        )
        self.note(name)
        return runs

    def sweep(self, program, sweep, runs):
        """Plans the runs of a sweep file and makes those that are not complete."""
        self.call("trophic", "plan", sweep, "--program", self.program(program), "--out", runs)
        self.call(program, "--plan", runs / "plan.jsonl", "--jobs", self.jobs)
        self.note(str(runs.relative_to(self.out / "runs")))

    def made(self, name, file, *command):
        """A file of an analysis that this command writes."""
        folder = self.out / "analysis" / name
        if not (folder / file).exists():
            shutil.rmtree(folder, ignore_errors=True)
            folder.parent.mkdir(parents=True, exist_ok=True)
            self.call(*command, "--out", folder)
        return folder / file

    def published(self, name):
        """The summary of `trophic analyze --published` for a set."""
        return json.loads(
            self.made(
                f"{name}-published", "summary.json", "trophic", "analyze", "--published", self.out / "runs" / name
            ).read_text()
        )

    def figures(self, name, copies):
        """Draws the figures of an analysis and copies some, {figure: its name there}, to results, except in a quick study."""
        analysis = self.out / "analysis" / name
        shutil.rmtree(analysis / "figures", ignore_errors=True)
        self.call("trophic", "plot", analysis, "--with-captions")
        for figure, copy in {} if self.quick else copies.items():
            shutil.copy(analysis / f"figures/{figure}.png", STUDIES / f"results/{copy}.png")

    def selection(self, name, *traits):
        """The rows of `trophic analyze --selection` of a set over whole runs."""
        found = self.made(
            f"{name}-selection", "selection.csv", "trophic", "analyze", self.out / "runs" / name, "--selection", *traits
        )
        return [row for row in data_rows.read(found) if row["period"] == "all"]

    def with_friction(self, model, friction, servo=None):
        """The path of a copy of a model with another sliding friction, and of a robot with other gains of its servos, by position and velocity."""
        kind = f"friction-{friction}" + ("-servo-{}-{}".format(*servo) if servo else "")
        copy = self.out / "models" / f"{model}-{kind}.toml"
        copy.parent.mkdir(parents=True, exist_ok=True)
        lines = [
            line
            for line in (installed.models() / f"{model}.toml").read_text().splitlines()
            if not line.startswith("friction =")
        ]
        name = next(number for number, line in enumerate(lines) if line.startswith("name ="))
        gains = ["[servo]", *map("{} = {}".format, ("position_gain", "velocity_gain"), servo)] if servo else []
        copy.write_text("\n".join([*lines[: name + 1], f"friction = {friction}", *lines[name + 1 :], *gains]) + "\n")
        return copy

    def forget(self, name):
        """Deletes the runs of an analysed set."""
        shutil.rmtree(self.out / "runs" / name, ignore_errors=True)

    def runs_of(self, name, keys, analyses=("",), called=""):
        """The values of these (metric, species, group) in each run of a set and of its nulls, from its analyses; `called`: the set's name in the rows."""
        rows = []
        for analysis in analyses:
            for row in data_rows.read(self.out / f"analysis/{name}{analysis}/metrics.csv"):
                key = (row["metric"], row["species"], row["group"])
                is_run = not row["baseline"] or row["baseline"].startswith(provenance.NULLS)
                if is_run and key in keys and not row["time_s"] and row["value"]:
                    of = {"set": called or name, "run": row["run"].removeprefix("replicate-"), "null": row["baseline"]}
                    value = {
                        "metric": key[0],
                        "species": key[1],
                        "group": key[2],
                        "value": f"{float(row['value']):.6g}",
                    }
                    rows += [of | value] if of | value not in rows else []
        return rows

    def write(self, name, rows, of=""):
        """Writes a data file, and its origin: the sets of this stage whose names begin with `of`."""
        if not rows:
            print(f"{name}: nothing to write", flush=True)
            return
        data_rows.write(self.data / f"{name}.csv", rows)
        runs = [run for made, of_set in self.made_of.items() if made.startswith(of) for run in of_set]
        provenance.write(self.data, provenance.row(name, self.stage, runs))
