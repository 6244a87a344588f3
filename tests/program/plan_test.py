#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""plan_test.py PREDATOR_PREY TROPHIC SWEEPS [--engines a,b] [--long] [unittest arguments]: one plan, run in every way there is, gives
the same files, and what cannot be run is refused in one line.

SWEEPS: the folder of examples with a script for MPI and a Snakefile. The quick part has a small grid; --long runs 24 cells x 3."""

import argparse
import csv
import filecmp
import json
import os
import pathlib
import random
import shutil
import signal
import socket
import subprocess
import sys
import time
import unittest

from in_folder import InFolderWithSets, call, run_ok

PARSER = argparse.ArgumentParser()
PARSER.add_argument("program")
PARSER.add_argument("trophic")
PARSER.add_argument("sweeps", type=pathlib.Path)
PARSER.add_argument("--engines", default="kinematic")
PARSER.add_argument("--long", action="store_true")
OPTIONS, REST = PARSER.parse_known_args()
ENGINES = OPTIONS.engines.split(",")

SHORT = f"""
replicates = 2
agents_every = 2
[set]
ecology.duration_s = 10.0
[grid]
engine = {json.dumps(ENGINES)}
rules.capture.reach_m = [0.5, 1.0]
rules.mutation.sd = [0.05, 0.2]
"""
LONG = f"""
replicates = 3
[set]
ecology.duration_s = 40.0
[grid]
engine = {json.dumps(ENGINES)}
rules.capture.reach_m = [0.5, 1.0, 2.0]
rules.mutation.sd = [0.0125, 0.05, 0.2, 0.8]
"""
# Runs that take long enough to be killed in the middle.
KILLED = """
engine = "kinematic"
replicates = 2
[set]
ecology.duration_s = 8000.0
[grid]
rules.capture.reach_m = [0.5, 1.0]
"""
# Parts of a manifest that describe the program that made a run, not the run.
OF_PROGRAM = ["command_line", "host", "wall_s", "continued", "trophic_revision", "source_revision", "crc32"]


def files_of(folder):
    """Paths of all files but checkpoints, which contain the name of the program that wrote them, and what was set aside."""
    return sorted(
        path.relative_to(folder)
        for path in folder.rglob("*")
        if path.is_file() and path.name != "checkpoint.bin" and ".incomplete-" not in str(path.relative_to(folder))
    )


class Sweeps(InFolderWithSets):
    """`sets` holds the folders "one": the files of an undisturbed sweep."""

    @classmethod
    def make_sets(cls):
        pass

    @classmethod
    def make(cls, text):
        (cls.sets / "sweep.toml").write_text(text)
        run_ok(OPTIONS.trophic, "plan", "sweep.toml", "--program", OPTIONS.program, "--out", "one", cwd=cls.sets)
        began = time.monotonic()
        run_ok(OPTIONS.program, "--plan", "one/plan.jsonl", "--jobs", 1, cwd=cls.sets, timeout=3600)
        cls.whole_s = time.monotonic() - began

    def setUp(self):
        super().setUp()
        self.write("sweep.toml", LONG if OPTIONS.long else SHORT)
        self.write("killed.toml", KILLED)

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def call(self, *words, **how):
        return super().call(*words, timeout=3600, **how)

    def run_ok(self, *words, **how):
        return super().run_ok(*words, timeout=3600, **how)

    def plan(self, *arguments, file="sweep.toml", out="out", run=None):
        where = () if "--dry-run" in arguments else ("--out", out)
        return (run or self.run_ok)(OPTIONS.trophic, "plan", file, "--program", OPTIONS.program, *where, *arguments)

    def words(self, out, *arguments):
        return [OPTIONS.program, "--plan", f"{out}/plan.jsonl", *arguments]

    def make_runs(self, *arguments, out="out", run=None):
        return (run or self.run_ok)(*self.words(out, *arguments))

    def sweep(self, *arguments, file="sweep.toml", out="out"):
        self.plan(file=file, out=out)
        return self.make_runs(*arguments, out=out)

    def start(self, *words):
        return subprocess.Popen(words, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def assert_same(self, out="out"):
        one, two = self.sets / "one", self.folder / out
        self.assertEqual(files_of(one), files_of(two))
        for path in files_of(one):
            if path.name != "manifest.json":
                self.assertTrue(filecmp.cmp(one / path, two / path, shallow=False), path)
                continue
            manifests = [json.loads((folder / path).read_text()) for folder in (one, two)]
            for manifest in manifests:
                self.assertEqual(manifest["status"], "complete")
                for key in OF_PROGRAM:
                    manifest.pop(key, None)
            self.assertEqual(*manifests)


class Ways(Sweeps):
    @classmethod
    def make_sets(cls):
        cls.make(LONG if OPTIONS.long else SHORT)

    def test_plan(self):
        runs = [json.loads(line) for line in (self.sets / "one/plan.jsonl").read_text().splitlines()]
        self.assertEqual(len({run["folder"] for run in runs}), len(runs))
        seeds = {}
        for run in runs:
            seeds.setdefault(run["replicate"], set()).add(run["seed"])
            manifest = json.loads((self.sets / "one" / run["folder"] / "manifest.json").read_text())
            self.assertEqual(manifest["seed"], run["seed"])
            self.assertEqual(manifest["fingerprint"], run["fingerprint"])
            self.assertEqual(manifest["clock"]["until_s"], run["until_s"])
            self.assertEqual(
                manifest["params"]["rules"]["capture"]["reach_m"], run["settings"]["rules.capture.reach_m"]
            )
        self.assertTrue(all(len(each) == 1 for each in seeds.values()), "replicate k has one seed in all cells")
        self.assertEqual(
            sorted(path.name for path in (self.sets / "one").iterdir() if not path.name.startswith("cell-")),
            ["plan.jsonl", "sweep.toml"],
        )

    @unittest.skipIf(OPTIONS.long, "the long sweep has every tick")
    def test_agents_of_every_other_tick(self):
        for run in (self.sets / "one").glob("cell-*/replicate-*"):
            with open(run / "agents.csv", newline="") as file:
                times = {float(row["time_s"]) for row in csv.DictReader(file)}
            self.assertEqual(times, {0.0, 4.0, 8.0})

    def test_jobs(self):
        self.sweep("--jobs", "2")
        self.assert_same()

    def test_a_plan_that_is_cut_short_has_runs_of_every_cell(self):
        tables = (self.sets / "one").glob("cell-*/replicate-*/genomes.csv")
        ends = {table.parent: table.stat().st_mtime_ns for table in tables}
        order = [folder.name for folder in sorted(ends, key=ends.get)]
        self.assertEqual(order, sorted(order))
        self.assertLess(len(set(order)), len(order))

    def test_again_runs_nothing(self):
        times = lambda: {path: path.stat().st_mtime_ns for path in (self.sets / "one").rglob("*.csv")}
        before = times()
        self.make_runs(out=self.sets / "one")
        self.assertEqual(before, times())

    def runs(self, out="one"):
        return len((self.sets / out / "plan.jsonl").read_text().splitlines())

    def test_runs_by_their_numbers_in_any_order(self):
        numbers = [str(i) for i in random.sample(range(self.runs()), self.runs())]
        self.sweep("--run", *numbers[:3])
        self.assertEqual(len(list(self.folder.glob("out/cell-*/*/manifest.json"))), 3)
        for number in numbers:  # the first three are complete
            self.make_runs("--run", number)
        self.assert_same()

    def test_programs_that_make_the_same_runs_at_once(self):
        self.plan()
        words = self.words("out", "--jobs", "1")
        programs = [self.start(*words, *more) for more in ([], [], ["--run", "0"], ["--run", "0"])]
        self.assertLessEqual({program.wait(3600) for program in programs}, {0, 1})
        self.run_ok(*words)
        self.assert_same()

    @unittest.skipUnless(shutil.which("mpirun"), "needs MPI")
    def test_mpi(self):
        for ranks in (2, 3):
            out = f"ranks-{ranks}"
            words = [
                "mpirun",
                "--allow-run-as-root",
                "--oversubscribe",
                "--mca",
                "orte_abort_on_non_zero_status",
                "0",
                "-n",
                str(ranks),
            ]
            self.plan(out=out)
            self.run_ok(*words, OPTIONS.sweeps / "mpi.sh", OPTIONS.program, f"{out}/plan.jsonl")
            self.assert_same(out)

    @unittest.skipUnless(shutil.which("parallel"), "needs GNU parallel")
    def test_gnu_parallel_and_its_log(self):
        self.plan()

        def by_parallel(guard):
            command = f"{guard}{OPTIONS.program} --plan out/plan.jsonl --run {{}}"
            return self.call(
                "bash", "-c", f"seq 0 {self.runs() - 1} | parallel --jobs 2 --joblog log --resume-failed '{command}'"
            )

        self.assertEqual(by_parallel("[ {} -ne 1 ] && ").returncode, 1)
        self.assertEqual(by_parallel("").returncode, 0)
        self.assert_same()

    def test_printed_slurm_script_by_array_ids(self):
        for out, tasks in (("out", (2, 1, 3)), ("base0", (0, 1, 2))):
            printed = self.plan("--sbatch", 3, out=out)
            self.assertEqual(printed.stderr, "")
            for line in (
                r"#SBATCH --array=1-3",
                r"#SBATCH --time=\d+:\d\d:00",
                r"#SBATCH --mem=\d+M",
                r"#SBATCH --output=slurm-%A_%a.log",
                r"#SBATCH --signal=B:TERM@120",
                r"# \d+ runs in \d+ cells, about .* of one core",
            ):
                self.assertRegex(printed.stdout, rf"(?m)^{line}")
            self.write("job.sh", printed.stdout)
            for task in tasks:
                self.run_ok(
                    "bash",
                    "-c",
                    f"cd / && bash '{self.folder / 'job.sh'}'",
                    env={**os.environ, "SLURM_ARRAY_TASK_ID": str(task)},
                )
            self.assert_same(out)
        for array in ({"SLURM_ARRAY_TASK_COUNT": "2"}, {"SLURM_ARRAY_TASK_COUNT": "3", "SLURM_ARRAY_TASK_STEP": "2"}):
            half = self.call("bash", "job.sh", env={**os.environ, "SLURM_ARRAY_TASK_ID": "1", **array})
            self.assert_refused(half, "--array: must be 3 consecutive indices; otherwise some runs would be omitted")
        most = self.plan("--sbatch", 1000)
        self.assertIn(f"#SBATCH --array=1-{self.runs()}\n", most.stdout)

    @unittest.skipUnless(shutil.which("snakemake"), "needs Snakemake")
    def test_snakemake(self):
        words = [
            "snakemake",
            "--cores",
            "2",
            "--snakefile",
            OPTIONS.sweeps / "Snakefile",
            "--config",
            "sweep=sweep.toml",
            "out=out",
            f"program={OPTIONS.program}",
            f"trophic={OPTIONS.trophic}",
        ]
        self.run_ok(*words, env={**os.environ, "HOME": str(self.folder)})
        self.assert_same()

    def test_a_signal_of_slurm_ends_a_task_well(self):
        self.write("job.sh", self.plan("--sbatch", 1, file="killed.toml", out="signalled").stdout)
        running = subprocess.Popen(
            ["bash", "job.sh"],
            cwd=self.folder,
            env={**os.environ, "SLURM_ARRAY_TASK_ID": "1"},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.wait_for("signalled/cell-*/*/agents.csv", running)
        running.send_signal(signal.SIGTERM)
        said = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 3, said)
        self.assertTrue(list(self.folder.glob("signalled/cell-*/*/checkpoint.bin")), said)

    @unittest.skipUnless(
        shutil.which("slurmctld", path=os.environ["PATH"] + ":/usr/sbin") and shutil.which("sbatch"), "needs Slurm"
    )
    def test_slurm(self):
        self.write("job.sh", self.plan("--sbatch", 3).stdout)
        self.write("base0.sh", self.plan("--sbatch", 3, out="base0").stdout)
        with Slurm(self.folder) as environment:
            done = [
                self.call("sbatch", "--wait", *words, env=environment)
                for words in (["job.sh"], ["--array=0-2", "base0.sh"])
            ]
        said = "".join(path.read_text() for path in self.folder.glob("slurm-*.log"))
        self.assertEqual([each.returncode for each in done], [0, 0], str(done) + said)
        self.assert_same()
        self.assert_same("base0")


class Slurm:
    """A cluster of this machine alone, for one test."""

    def __init__(self, folder):
        self.folder = folder / "slurm"
        self.programs = []

    def free_port(self):
        with socket.socket() as one:
            one.bind(("127.0.0.1", 0))
            return one.getsockname()[1]

    def __enter__(self):
        self.folder.mkdir()
        host = socket.gethostname()
        user = run_ok("id", "-un").stdout.strip()
        numbers = {
            "ClusterName": "one",
            "SlurmctldHost": f"{host}(127.0.0.1)",
            "AuthType": "auth/none",
            "CredType": "cred/none",
            "SlurmUser": user,
            "SlurmdUser": user,
            "SlurmctldPort": self.free_port(),
            "SlurmdPort": self.free_port(),
            "StateSaveLocation": self.folder / "state",
            "SlurmdSpoolDir": self.folder / "spool",
            "SlurmctldPidFile": self.folder / "ctld.pid",
            "SlurmdPidFile": self.folder / "d.pid",
            "ProctrackType": "proctrack/linuxproc",
            "TaskPlugin": "task/none",
            "SelectType": "select/cons_tres",
            "SelectTypeParameters": "CR_Core",
            "AccountingStorageType": "accounting_storage/none",
            "JobAcctGatherType": "jobacct_gather/none",
            "ReturnToService": 2,
            "SwitchType": "switch/none",
            "MpiDefault": "none",
        }
        text = "".join(f"{key}={value}\n" for key, value in numbers.items())
        text += f"NodeName={host} NodeAddr=127.0.0.1 RealMemory=1000 CPUs={os.cpu_count()}\nPartitionName=all Nodes=ALL Default=YES State=UP\n"
        configuration = self.folder / "slurm.conf"
        configuration.write_text(text)
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        environment = {**os.environ, "SLURM_CONF": str(configuration)}
        paths = os.environ["PATH"] + ":/usr/sbin"
        for daemon in ("slurmctld", "slurmd"):
            with (self.folder / f"{daemon}.log").open("w") as log:
                words = [shutil.which(daemon, path=paths), "-D"]
                self.programs.append(subprocess.Popen(words, env=environment, stdout=log, stderr=log))
        for _ in range(100):
            state = call("sinfo", "--noheader", "--format=%T", env=environment)
            if state.stdout.strip() == "idle":
                return environment
            time.sleep(0.1)
        self.__exit__()
        raise unittest.SkipTest("no node of Slurm can be started here:\n" + (self.folder / "slurmd.log").read_text())

    def __exit__(self, *_):
        for program in reversed(self.programs):
            program.terminate()
            program.wait(30)


class Killed(Sweeps):
    at_work = 0.1  # of the whole: the sweep cannot be done yet

    @classmethod
    def make_sets(cls):
        cls.make(KILLED)

    def wait_for_work(self, share=0.5):
        """Until runs have begun, and at most this share of what one program took for all of them."""
        for _ in range(3000):
            if list((self.folder / "out").glob("cell-*/*.lock")):
                break
            time.sleep(0.01)
        time.sleep(random.uniform(0.0, share * self.whole_s))

    def test_program_that_is_killed_and_started_again(self):
        self.plan(file="killed.toml")
        words = self.words("out", "--jobs", "2", "--checkpoint-s", "50")
        for _ in range(2):
            program = self.start(*words)
            self.wait_for_work()
            program.kill()
            program.wait()
        self.run_ok(*words)
        self.assert_same()

    def status(self):
        done = self.make_runs("--status")
        self.assertEqual(done.stderr, "")
        return done.stdout

    def test_status_says_what_runs_is_interrupted_and_is_done(self):
        self.plan(file="killed.toml")
        words = self.words("out", "--jobs", "2", "--checkpoint-s", "50")
        program = self.start(*words)
        self.wait_for_work(self.at_work)
        running = self.status()
        self.assertRegex(running, r"out: 4 runs: 0 done, [12] running, 0 failed, \d interrupted, \d missing\n")
        self.assertIn("  running: cell-00", running)
        self.assertIn("left: unknown", running)
        program.kill()
        program.wait()
        killed = self.status()
        self.assertRegex(killed, r"0 done, 0 running, 0 failed, [12] interrupted, [23] missing\n")
        self.assertIn("  interrupted: cell-00", killed)
        self.run_ok(*words)
        self.assertEqual(self.status(), "out: 4 runs: 4 done, 0 running, 0 failed, 0 interrupted, 0 missing\n")
        shutil.rmtree(self.folder / "out/cell-001/replicate-01")
        self.assertRegex(
            self.status(),
            r"3 done, 0 running, 0 failed, 0 interrupted, 1 missing\nleft: about .* of one core \(0.\d+ core-hours\)",
        )

    def test_one_of_two_is_killed(self):
        self.plan(file="killed.toml")
        words = self.words("out", "--jobs", "1", "--checkpoint-s", "50")
        lives, dies = self.start(*words), self.start(*words)
        self.wait_for_work()
        dies.kill()
        dies.wait()
        self.assertIn(lives.wait(600), (0, 1))
        self.run_ok(*words)
        self.assert_same()

    def test_a_run_that_is_made_is_refused_and_one_that_was_killed_resumes(self):
        self.plan(file="killed.toml")
        words = self.words("out", "--checkpoint-s", "50", "--run", "2")
        program = self.start(*words)
        self.wait_for("out/cell-001/replicate-00/checkpoint.bin", program)
        refused = self.call(*words)
        self.assertEqual(refused.returncode, 1, refused.stdout)
        self.assertIn("cell-001/replicate-00: another program is running it\n", refused.stderr)
        program.kill()
        program.wait()
        self.run_ok(*words)
        self.assertIn("continued", json.loads((self.folder / "out/cell-001/replicate-00/manifest.json").read_text()))
        self.make_runs("--checkpoint-s", "50")
        self.assert_same()

    def test_stopped_program_prints_how_to_continue(self):
        self.plan(file="killed.toml")
        words = self.words("out", "--jobs", "1")
        program = subprocess.Popen(words, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.wait_for_work(self.at_work)
        program.send_signal(signal.SIGTERM)
        said = program.communicate(timeout=600)
        self.assertEqual(program.returncode, 3, said)
        self.assertIn("to resume only these, repeat the command", said[1])
        self.run_ok(*words)
        self.assert_same()


class Refusals(Sweeps):
    def refused(self, *arguments, file="sweep.toml", out="out"):
        done = self.plan(*arguments, file=file, out=out, run=self.call)
        self.assert_refused(done)
        self.assertFalse((self.folder / out / "cell-000").exists())
        return done.stderr

    def test_cells(self):
        for text, says in {
            "[grid]\nrules.capture.reach = [1.0]\n": "cell 0 (rules.capture.reach=1.0): rules.capture.reach: unknown key; did you mean",
            "[grid]\nrules.capture.reach_m = [1.0, -1.0]\n": "cell 1 (rules.capture.reach_m=-1.0): rules.capture.reach_m = -1: must be",
            '[grid]\nrules.capture.reach_m = ["far"]\n': "rules.capture.reach_m = 'far': must be a number",
            "[grid]\nrules.capture = [1.0]\n": "rules.capture",
            '[grid]\nrule_table = ["papre"]\n': "rule_table = papre: must be paper or released; did you mean paper?",
            '[grid]\nengine = ["kinetic"]\n': "engine = kinetic: must be",
            "[grid]\nrules.capture.reach_m = [1.0, 1]\n": "cell 1 (rules.capture.reach_m=1): is the same experiment as cell 0",
            "[set]\necology.robots = 0\n[grid]\nrules.capture.reach_m = [1.0]\n": "ecology.robots = 0: must be",
            "[grid]\n": "[grid]: is empty",
            "neutral = true\n[grid]\nrules.capture.reach_m = [1.0]\n": "neutral: is not possible in a sweep; run a cell's settings with",
        }.items():
            self.write("bad.toml", 'engine = "kinematic"\n' + text if "engine" not in text else text)
            self.assertIn(says, self.refused(file="bad.toml"), text)

    @unittest.skipUnless("mujoco" in ENGINES, "needs an engine of bodies")
    def test_cell_that_diverges_prints_no_advice_to_resume(self):
        self.write(
            "diverges.toml",
            'engine = "mujoco"\nreplicates = 1\n[set]\necology.duration_s = 600.0\n'
            "physics.timestep_s = 0.02\necology.control_hz = 50\n[grid]\nrules.capture.reach_m = [1.0]\n",
        )
        self.plan(file="diverges.toml")
        done = self.make_runs(run=self.call)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("1 diverged, and will diverge again with the same parameters\n", done.stderr)
        self.assertNotIn("resume", done.stderr)

    def test_file_that_is_not_a_plan(self):
        for name, text, says in (
            ("none", None, "none: cannot be read: No such file"),
            ("empty", "", "empty: must list at least one run"),
            ("grid", "[grid]\n", "grid:1: must be a JSON object"),
        ):
            if text is not None:
                self.write(name, text)
            for arguments in ([], ["--status"], ["--describe"]):
                done = self.call(OPTIONS.program, "--plan", name, *arguments)
                self.assert_refused(done, says)
                self.assertEqual(done.stdout, "")

    def test_plan_that_the_program_would_make_otherwise_is_refused(self):
        self.plan()
        path = self.folder / "out/plan.jsonl"
        first, *others = path.read_text().splitlines()
        line = json.loads(first)
        for changes, says in (
            ({"fingerprint": "0" * 16}, 'fingerprint = "0000000000000000": must be "'),
            ({"until_s": 11.0}, "until_s = 11.0: must be 10.0"),
            ({"rule_table": "papre"}, "rule_table = papre: must be paper or released; did you mean paper?"),
            ({"settings": {"rules.capture.reach": 1.0}}, "rules.capture.reach: unknown key; did you mean"),
            ({"settings": {"seed": 3}}, "seed: is not allowed in a plan"),
        ):
            path.write_text("\n".join([json.dumps({**line, **changes}), *others]) + "\n")
            self.assert_refused(self.make_runs(run=self.call), "out/plan.jsonl:1: ", says)
            self.assertEqual(list(self.folder.glob("out/*/replicate-*")), [])

    def test_neutral_null_repeats_the_run_of_the_plan(self):
        line = {
            "rule_table": "paper",
            "engine": "kinematic",
            "settings": {"ecology.duration_s": 100.0},
            "seed": 5,
            "replay_hz": 0,
            "agents_every": 1,
            "senses": False,
            "states": False,
        }
        lines = [{**line, "null": null, "folder": null} for null in ("neutral", "none", "clones")]
        self.write("draft", "".join(json.dumps(line) + "\n" for line in lines))
        facts = self.run_ok(OPTIONS.program, "--plan", "draft", "--describe").stdout.splitlines()
        self.write(
            "mine.jsonl", "".join(json.dumps({**line, **json.loads(fact)}) + "\n" for line, fact in zip(lines, facts))
        )
        refused = self.call(OPTIONS.program, "--plan", "mine.jsonl", "--run", "0")
        self.assertIn("needs none to be complete", refused.stderr)
        self.run_ok(OPTIONS.program, "--plan", "mine.jsonl")

        self.assertEqual(*(self.rows(run, "phylogeny.csv")[-1]["id"] for run in ("neutral", "none")))

    def test_options(self):
        for arguments, says in {("--sbatch", "0"): "--sbatch 0: must be >= 1"}.items():
            self.assertIn(says, self.refused(*arguments), arguments)
        both = self.call(OPTIONS.trophic, "plan", "sweep.toml", "--dry-run", "--out", "out")
        self.assert_refused(both, "--out: not with --dry-run")
        self.plan()
        for arguments, says in {
            ("--run", "3", "99"): "--run 99: must be < ",
            ("--run", "3", "--status"): "--run: not with --status, which combines with",
            ("--jobs", "0"): "--jobs 0: must be >= 1",
            ("--set", "rules.mutation.sd=0.1"): "--set: not with --plan",
            ("--replicates", "3"): "--replicates: not with --plan",
            ("--senses",): "--senses: not with --plan, which combines with --jobs",
            ("--live",): "--live: not with --plan",
            ("--seed", "3"): "--seed: not with --plan",
            ("--resume",): "--resume: not with --plan",
        }.items():
            self.assert_refused(self.make_runs(*arguments, run=self.call), says)
        for arguments in (["--run", "1"], ["--describe"], ["--status"]):
            self.assert_refused(self.call(OPTIONS.program, "--backend", "kinematic", *arguments), ": needs --plan\n")

    def test_plan_that_changed_half_way_is_refused(self):
        self.write(
            "small.toml",
            'engine = "kinematic"\nreplicates = 1\n[set]\necology.duration_s = 10.0\n'
            "[grid]\nrules.mutation.sd = [0.05, 0.2]\n",
        )
        self.sweep(file="small.toml", out="small")
        text = (self.folder / "small.toml").read_text()
        self.write("small.toml", text.replace("0.2", "0.3"))
        other = dict(file="small.toml", out="small", run=self.call)
        self.assert_refused(self.plan(**other), "small/plan.jsonl:2: the folder has another plan")
        for keeps in ("replay_hz = 5.0", "agents_every = 2", "senses = true"):
            self.write("small.toml", f"{keeps}\n{text}")
            self.assert_refused(self.plan(**other), "small/plan.jsonl:1: the folder has another plan")

    def test_sweep_gets_longer_and_more_to_the_same_bytes(self):
        text = 'engine = "kinematic"\nshadow = true\none_sided = true\nreplicates = {}\n[set]\necology.duration_s = {}\n[grid]\nrules.mutation.sd = [0.05, 0.2{}]\n'
        for name, *values in (("small", 1, 20.0, ""), ("whole", 2, 40.0, ", 0.8")):
            self.write(f"{name}.toml", text.format(*values))
            self.sweep(file=f"{name}.toml", out=name)
        plan = [json.loads(line) for line in (self.folder / "small/plan.jsonl").read_text().splitlines()]
        self.sweep(file="whole.toml", out="small")
        for path in (self.folder / "whole").rglob("*"):
            if path.suffix == ".csv" or path.name == "replicates.json":
                self.assertEqual(
                    path.read_bytes(),
                    (self.folder / "small" / path.relative_to(self.folder / "whole")).read_bytes(),
                    path,
                )
        grown = [json.loads(line) for line in (self.folder / "small/plan.jsonl").read_text().splitlines()]
        self.assertEqual([run["folder"] for run in grown[: len(plan)]], [run["folder"] for run in plan])
        self.assertEqual(len(grown), 24)
        for before, after, sentence in (
            (
                "0.2, ",
                "",
                "small/plan.jsonl:5: the folder has another plan, with a run that the sweep lacks: rules.mutation.sd = 0.2 there",
            ),
            ("40.0", "30.0", "until_s = 40.0 there, 30.0 here"),
            ("replicates = 2", "replicates = 1", "replicate = 1 there, 0 here"),
            (
                "[grid]\nrules.mutation.sd",
                '"rule_table" = "released"\n[grid]\nrules.mutation.half_width',
                'rule_table = "paper" there, "released" here; ',
            ),
        ):
            self.write("whole.toml", text.format(2, 40.0, ", 0.8").replace(before, after))
            self.assert_refused(self.plan(file="whole.toml", out="small", run=self.call), sentence)

    def test_set_gets_longer_to_the_same_bytes(self):
        words = [
            OPTIONS.program,
            "--backend",
            "kinematic",
            "--replicates",
            "2",
            "--shadow",
            "--neutral",
            "--one-sided",
            "--duration",
        ]
        self.run_ok(*words, "200", "--out", "set")
        self.run_ok(*words, "400", "--out", "whole")
        self.run_ok(*words, "400", "--out", "set", "--resume")
        for path in (self.folder / "whole").rglob("*.csv"):
            self.assertEqual(
                path.read_bytes(), (self.folder / "set" / path.relative_to(self.folder / "whole")).read_bytes(), path
            )
        self.assertIn("until_s = 400.0: must be 200.0", self.call(*words, "200", "--out", "set", "--resume").stderr)
        if "mujoco" in ENGINES:
            self.assertIn(
                'engine = "kinematic 1" there, "mujoco',
                self.call(*words[:1], *words[3:], "400", "--out", "set", "--resume").stderr,
            )

    def test_folder_of_something_else_is_refused(self):
        (self.folder / "out").mkdir()
        self.assertIn("out: exists already and does not have plan.jsonl", self.refused())

    def test_without_a_name_the_folder_has_the_name_of_the_sweep(self):
        for _ in range(2):  # the same plan again
            planned = self.run_ok(OPTIONS.trophic, "plan", "sweep.toml", "--program", OPTIONS.program)
        self.assertIn("--plan runs/sweep/plan.jsonl", planned.stdout)
        self.assertTrue((self.folder / "runs/sweep/plan.jsonl").is_file())

    def test_dry_run_prints_what_would_be_run(self):
        done = self.plan("--dry-run")
        self.assertIn("rules.capture.reach_m=0.5 rules.mutation.sd=0.05", done.stdout)
        self.assertRegex(done.stdout, r"\d+ runs in \d+ cells, about .* of one core \(.* core-hours\)")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["killed.toml", "sweep.toml"])

    def test_dry_run_that_is_stopped_prints_no_time(self):
        self.write(
            "long.toml",
            'engine = "kinematic"\nreplicates = 1\n[set]\necology.duration_s = 1e8\n[grid]\nrules.mutation.sd = [0.05, 0.2]\n',
        )
        environment = {**os.environ, "TMPDIR": str(self.folder)}
        run = subprocess.Popen(
            [OPTIONS.trophic, "plan", "long.toml", "--program", OPTIONS.program, "--dry-run"],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=environment,
        )
        self.wait_for("trophic-probe-*/run/events.csv", run)
        run.send_signal(signal.SIGTERM)
        printed, errors = run.communicate(timeout=60)
        self.assertEqual(run.returncode, 3, errors)
        self.assertNotIn("core-hours", printed)
        self.assertEqual(list(self.folder.glob("trophic-probe-*")), [])

    def test_the_example(self):
        self.assertIn(
            "1200 runs planned", self.plan(file=OPTIONS.sweeps.parents[1] / "studies/sweeps/inheritance.toml").stdout
        )


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *REST])
