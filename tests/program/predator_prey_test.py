#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""predator_prey_test.py PROGRAM [unittest arguments]: options, files, errors and exit codes of the predator_prey program."""

import itertools
import json
import pathlib
import platform
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest

from in_folder import InFolder, call

PROGRAM = sys.argv.pop(1)
ROOT = pathlib.Path(__file__).resolve().parents[2]
HELP = call(PROGRAM, "--help").stdout
HAS_MUJOCO = ", mujoco" in HELP
HAS_ODE = ", ode" in HELP
FILES = ["events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "manifest.json"]
TABLES = FILES[:4]


class PredatorPrey(InFolder):
    program = (PROGRAM,)

    def call_by_shell(self, script, *arguments):
        return call("bash", "-c", script, "bash", PROGRAM, *arguments, cwd=self.folder)

    def run_out(self, out, *arguments):
        return self.run_ok(*([] if "--backend" in arguments else ["--backend", "kinematic"]), "--out", out, *arguments)


class Runs(PredatorPrey):
    def test_births_and_deaths_balance(self):
        for rules in ("paper", "released"):
            with self.subTest(rules=rules):
                self.run_out(rules, "--rules", rules, "--seed", 3)
                events = self.rows(rules, "events.csv")
                births = [e for e in events if e["event"] == "birth"]
                deaths = [e for e in events if e["event"] == "death"]
                self.assertEqual(len(births), len(deaths) + 30)
                self.assertGreater(len(deaths), 100)
                self.assertEqual({d["cause"] for d in deaths}, {"caught", "starved", "sacrificed"})
                for death in deaths:
                    self.assertEqual(bool(death["killer_id"]), death["cause"] == "caught")
                if rules == "paper":
                    for birth in births:
                        self.assertEqual(bool(birth["parent_id"]), birth["origin"] == "inherited")

                agents = self.rows(rules, "agents.csv")
                ticks = {}
                for agent in agents:
                    ticks.setdefault(int(agent["tick"]), []).append(agent["species"])
                self.assertEqual(sorted(ticks), list(range(3001 if rules == "paper" else 3251)))
                for species in ticks.values():
                    self.assertEqual(len(species), 30)
                    self.assertGreaterEqual(species.count("prey"), 7 if rules == "paper" else 6)
                    self.assertGreaterEqual(species.count("predator"), 7 if rules == "paper" else 8)

                lineage = self.rows(rules, "phylogeny.csv")
                ids = {row["id"] for row in lineage}
                self.assertEqual(len(ids), len(births))
                self.assertEqual(sum(row["destruction_time"] == "inf" for row in lineage), 30)
                for row in lineage:
                    ancestor = row["ancestor_list"].strip("[]")
                    self.assertTrue(ancestor == "none" or ancestor in ids)
                    self.assertEqual(row["ancestor_id"], row["id"] if ancestor == "none" else ancestor)
                self.assertEqual(self.manifest(rules)["status"], "complete")

    def test_manifest_names_program_engine_and_rules(self):
        self.run_out("run", "--duration", 10, "--seed", 2**53)
        manifest = self.manifest("run")
        self.assertEqual(manifest["tags"], [-1, 1])
        self.assertEqual((manifest["seed"], manifest["params"]["seed"]), (2**53, 2**53))
        self.assertRegex(manifest["compiler"], r"^(g|clang)\+\+ \d+\.\d+\.\d+$")
        self.assertEqual(manifest["architecture"], platform.machine())
        self.assertRegex(manifest["c_library"], r"^glibc \d+\.\d+|^unknown$")
        self.assertIn("--duration 10", manifest["command_line"])
        self.assertTrue(manifest["host"])
        self.assertTrue(manifest["build"])
        git = ["git", "-C", str(ROOT)]
        top = call(*git, "rev-parse", "--show-toplevel")
        if top.returncode != 0 or pathlib.Path(top.stdout.strip()) != ROOT:
            self.assertRegex(manifest["source_revision"], r"^(unknown|[0-9a-f]{12})$")  # 12 digits in a release archive
            return
        commit = re.fullmatch(r"(?:.*-g)?([0-9a-f]{7,40})(-dirty)?", manifest["source_revision"])
        self.assertTrue(commit, manifest["source_revision"])
        self.assertEqual(call(*git, "cat-file", "-e", commit[1] + "^{commit}").returncode, 0)

    def test_under_paper_parents_keep_their_genomes(self):
        self.run_out("run", "--duration", 3000)
        genomes = [row["genome_id"] for row in self.rows("run", "genomes.csv")]
        self.assertEqual(len(genomes), len(set(genomes)))

    def test_same_seed_same_bytes(self):
        for out, seed in (("a", 5), ("b", 5), ("c", 6)):
            self.run_out(out, "--seed", seed, "--duration", 1000)
        for file in TABLES:
            first = (self.folder / "a" / file).read_bytes()
            self.assertEqual(first, (self.folder / "b" / file).read_bytes(), file)
            self.assertNotEqual(first, (self.folder / "c" / file).read_bytes(), file)

    @unittest.skipUnless(HAS_MUJOCO, "no MuJoCo in this build")
    def test_threads_do_not_change_mujoco_results(self):
        for threads in (1, 2):
            self.run_ok("--duration", 20, "--threads", threads, "--out", f"threads{threads}")
        for file in TABLES:
            self.assertEqual(
                (self.folder / "threads1" / file).read_bytes(), (self.folder / "threads2" / file).read_bytes(), file
            )

    @unittest.skipUnless(HAS_ODE, "no ODE in this build")
    def test_ode_takes_every_option(self):
        few = [
            "--backend",
            "ode",
            "--robots",
            4,
            "--set",
            "rules.community.predators=2",
            "--set",
            "backend.sweeps=4",
            "--duration",
            10,
        ]
        printed = self.call(*few, "--print-config")
        self.assertIn("sweeps = 4", printed.stdout)
        (self.folder / "numbers.toml").write_text(printed.stdout)
        for threads in (1, 2):
            self.run_ok("--config", "numbers.toml", "--threads", threads, "--out", f"ode{threads}")
        for file in TABLES:
            self.assertEqual(
                (self.folder / "ode1" / file).read_bytes(), (self.folder / "ode2" / file).read_bytes(), file
            )
        for more in (["--replicates", 1], ["--replicates", 2, "--jobs", 2, "--resume"]):
            self.run_out("set", *few, *more)
        self.assertEqual(self.manifest("set/replicate-01")["status"], "complete")

    @unittest.skipUnless(HAS_ODE, "no ODE in this build")
    def test_ode_runs_the_released_rules_and_prints_its_settings(self):
        released = ["--rules", "released", "--backend", "ode", "--duration", 2]
        for more in ([], ["--replicates", 1]):
            result = self.run_out(f"released{len(more)}", *released, *more)
            self.assertIn("physics.integrator = rk4 has no effect", result.stderr)
        [remark] = self.manifest("released0")["remarks"]
        self.assertIn("physics.integrator = rk4 has no effect", remark)
        result = self.call(*released, "--set", "physics.integrator=semi_implicit_euler", "--out", "own")
        self.assertEqual(self.manifest("own")["remarks"], [])
        self.assertNotIn("remark", result.stdout + result.stderr)

    @unittest.skipUnless(HAS_ODE, "no ODE in this build")
    def test_only_mujoco_writes_mjcf(self):
        self.assert_refused(
            self.call("--backend", "ode", "--save-mjcf", "ecology.xml", "--out", "run"),
            "--save-mjcf",
            "--backend mujoco",
        )
        self.assertEqual(list(self.folder.iterdir()), [])

    @unittest.skipUnless(HAS_MUJOCO, "no MuJoCo in this build")
    def test_fast_stepping_has_the_same_events_as_mujoco_alone(self):
        for stepping in ("fast", "islands"):
            self.run_out(
                stepping,
                "--backend",
                "mujoco",
                "--duration",
                24,
                "--robots",
                16,
                "--set",
                f"backend.stepping={stepping}",
            )
        self.assertGreaterEqual(len(self.rows("fast", "events.csv")), 16)
        self.assertEqual(
            (self.folder / "fast" / "events.csv").read_bytes(), (self.folder / "islands" / "events.csv").read_bytes()
        )

    @unittest.skipUnless(HAS_MUJOCO, "no MuJoCo in this build")
    def test_the_released_physics_runs(self):
        self.run_out("released", "--backend", "mujoco", "--rules", "released", "--duration", 10)
        physics = self.manifest("released")["params"]["physics"]
        self.assertEqual((physics["timestep_s"], physics["integrator"]), (0.012, "rk4"))

    def test_any_robot_can_be_chosen(self):
        self.run_out("gecko", "--robot", "gecko", "--duration", 100)
        self.assertTrue(self.manifest("gecko")["params"]["ecology"]["gait"].startswith("gecko"))

    def test_neutral_shadow_of_the_replicates(self):
        self.run_out(
            "set",
            "--rules",
            "released",
            "--replicates",
            2,
            "--shadow",
            "--duration",
            1500,
            "--set",
            "rules.mutation.half_width=0.01",
        )
        self.assertEqual(
            [
                json.loads((self.folder / out / "replicates.json").read_text())["master_seed"]
                for out in ("set", "set/shadow")
            ],
            [1, 1],
        )
        for replicate in ("replicate-00", "replicate-01"):
            table, shadow = self.manifest(f"set/{replicate}"), self.manifest(f"set/shadow/{replicate}")
            self.assertEqual(table["params"], shadow["params"])
            self.assertEqual(table["rules"].pop("heredity"), "shared_copy")
            self.assertEqual(shadow["rules"].pop("heredity"), "nothing_inherited")
            self.assertEqual(table["rules"], shadow["rules"])
            distances = {}
            for run in (replicate, f"shadow/{replicate}"):
                births = [b for b in self.rows(f"set/{run}", "phylogeny.csv") if b["ancestor_list"] != "[none]"]
                self.assertGreater(len(births), 5)
                distances[run] = [float(b["mutation_distance"]) for b in births]
            self.assertLess(max(distances[replicate]), 0.01 * 15**0.5)
            self.assertEqual(max(distances[f"shadow/{replicate}"]), 0.0)  # drawn, not mutated
        self.assert_refused(
            self.call("--backend", "kinematic", "--shadow", "--duration", 100, "--out", "alone"),
            "--shadow",
            "needs --replicates",
        )

    def test_one_sided_worlds_of_the_replicates(self):
        self.run_out("set", "--replicates", 2, "--one-sided", "--duration", 1500)
        worlds = ("one_sided_prey", "one_sided_predator")
        self.assertEqual({path.name for path in (self.folder / "set").glob("*_*")}, set(worlds))
        self.assertEqual(
            [json.loads((self.folder / "set" / out / "replicates.json").read_text())["master_seed"] for out in worlds],
            [1, 1],
        )
        for replicate, world in itertools.product(("replicate-00", "replicate-01"), worlds):
            table, its = self.manifest(f"set/{replicate}"), self.manifest(f"set/{world}/{replicate}")
            species = world.removeprefix("one_sided_")
            self.assertEqual((table["params"], table["seed"]), (its["params"], its["seed"]))
            self.assertEqual(its["rule_table"], f"paper with heredity = own_copy, nothing_inherited for {species}")
            table["rules"]["heredity"] += f", nothing_inherited for {species}"
            self.assertEqual(table["rules"], its["rules"])
            self.assertNotEqual(table["fingerprint"], its["fingerprint"])
            births = [
                b for b in self.rows(f"set/{world}/{replicate}", "phylogeny.csv") if b["ancestor_list"] != "[none]"
            ]
            distances = {True: [], False: []}
            for birth in births:
                distances[birth["species"] == species].append(float(birth["mutation_distance"]))
            self.assertEqual(set(distances[True]), {0.0})  # drawn weights do not mutate
            self.assertGreater(max(distances[False]), 0.0)
        self.assert_refused(
            self.call("--backend", "kinematic", "--one-sided", "--duration", 100, "--out", "alone"),
            "--one-sided",
            "needs --replicates",
        )

    def test_neutral_null_of_the_replicates(self):
        self.run_out("set", "--replicates", 2, "--neutral", "--duration", 1000)

        def lives(run):
            return [
                {key: value for key, value in row.items() if key not in ("tag", "x_m", "y_m")}
                for row in self.rows(f"set/{run}", "events.csv")
                if row["event"] != "tag_switch"
            ]

        for replicate in ("replicate-00", "replicate-01"):
            self.assertEqual(lives(replicate), lives(f"neutral/{replicate}"))
            self.assertNotEqual(
                self.rows(f"set/{replicate}", "genomes.csv"), self.rows(f"set/neutral/{replicate}", "genomes.csv")
            )
            self.assertEqual(self.manifest(f"set/neutral/{replicate}")["rules"]["heredity"], "neutral_own_copy")
        (self.folder / "set/replicate-01/events.csv").write_text("cut")
        shutil.rmtree(self.folder / "set/neutral/replicate-01")
        self.run_out("set", "--replicates", 2, "--neutral", "--duration", 1000, "--resume")
        self.assertEqual(lives("replicate-01"), lives("neutral/replicate-01"))

    def test_printed_configuration_makes_the_same_run(self):
        printed = self.run_ok(
            "--backend", "kinematic", "--rules", "released", "--set", "rules.mutation.half_width=0.1", "--print-config"
        )
        (self.folder / "numbers.toml").write_text(printed.stdout)
        self.run_out("direct", "--rules", "released", "--set", "rules.mutation.half_width=0.1", "--duration", 500)
        self.run_ok("--config", "numbers.toml", "--duration", 500, "--out", "configured")
        for file in TABLES:
            self.assertEqual(
                (self.folder / "direct" / file).read_bytes(), (self.folder / "configured" / file).read_bytes()
            )
        self.assertEqual(self.manifest("direct")["fingerprint"], self.manifest("configured")["fingerprint"])

    def test_without_out_each_run_has_its_own_folder(self):
        for number in (1, 2):
            result = self.run_ok("--backend", "kinematic", "--duration", 10)
            folder = f"runs/{pathlib.Path(PROGRAM).name}-{number}"
            self.assertIn(folder, result.stdout)
            self.assertEqual(self.manifest(folder)["status"], "complete")
        self.run_ok("--backend", "kinematic", "--print-config")
        self.assertEqual(len(list((self.folder / "runs").iterdir())), 2)

    def test_progress_is_silent_when_piped(self):
        self.assertEqual(self.run_out("quiet", "--duration", 100).stderr, "")

    def test_interrupt_ends_cleanly(self):
        command = [PROGRAM, "--backend", "kinematic", "--duration", "100000000", "--out", "long"]
        with subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, text=True) as process:
            self.wait_for("long/agents.csv", process)
            time.sleep(0.2)
            process.send_signal(signal.SIGINT)
            printed, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3)
        self.assertIn("births", printed)
        self.assertEqual(self.manifest("long")["status"], "stopped")
        births = sum(e["event"] == "birth" for e in self.rows("long", "events.csv"))
        self.assertEqual(len(self.rows("long", "phylogeny.csv")), births)
        self.assertEqual(len(self.rows("long", "agents.csv")) % 30, 0)


class Refusals(PredatorPrey):
    def test_bad_arguments(self):
        for arguments, parts in [
            (["--rules", "nope"], ["--rules nope", "paper or released"]),
            (["--rules", "relased"], ["paper or released", "did you mean released?"]),
            (["--backend", "kinematics"], ["--backend kinematics", "did you mean kinematic?"]),
            (["--backend", "nope"], ["--backend nope", "kinematic"]),
            (["--robots", "0"], ["ecology.robots = 0", ">= 1"]),
            (["--robots", "10"], ["rules.community.predators = 14", "<= 10"]),
            (["--robots", "1000000"], ["ecology.robots = 1000000", "must be <="]),
            (["--duration", "-5"], ["ecology.duration_s = -5", "> 0"]),
            (["--duration", "nan"], ["ecology.duration_s = nan", "finite"]),
            (["--threads", "0"], ["--threads 0", ">= 1"]),
            (["--seed", "-1"], ["--seed -1", ">= 0"]),
            (["--seed", str(2**53 + 2)], ["seed = 9007199254740994", "<= 9007199254740992"]),
            (["--robots", "-1"], ["--robots -1", ">= 0"]),
            (["--threads", "-1"], ["--threads -1", ">= 0"]),
            (["--replicates", "-1"], ["--replicates -1", ">= 0"]),
            (["--replicates", "2", "--jobs", "-1"], ["--jobs -1", ">= 0"]),
            (["--set", "seed=-1"], ["seed = -1", ">= 0"]),
            (["--set", "ecology.robots=-1"], ["ecology.robots = -1", ">= 0"]),
            (["--set", "seed=9007199254740994"], ["seed = 9007199254740994", "<= 9007199254740992"]),
            (["--set", "rules.mutation.sdd=1"], ["rules.mutation.sdd", "unknown key", "sd"]),
            (["--set", "rules.mutatoin.sd=1"], ["rules.mutatoin.sd: unknown key", "did you mean rules.mutation.sd?"]),
            (["--set", "mutation.sd=1"], ["mutation.sd: unknown key", "did you mean rules.mutation.sd?"]),
            (["--set", "ecology.nothing_like_it=1"], ["ecology.nothing_like_it: unknown key; known here: robots"]),
            (["--set", "rules.mutation.sd=-1"], ["rules.mutation.sd = -1", ">= 0"]),
            (["--set", "rules.mutation.sd=wide"], ["rules.mutation.sd", "a number"]),
            (["--set", "rules.mutation.sd=9007199254740993"], ["rules.mutation.sd = 9007199254740993", "2^53"]),
            (["--set", "physics.timestep_s=0"], ["physics.timestep_s = 0", "> 0"]),
            (["--set", "physics.integrator=euler"], ["physics.integrator", "semi_implicit_euler or rk4"]),
            (["--set", "ecology.tick_s=0.001"], ["ecology.tick_s", "whole number"]),
            (["--set", "nonsense"], ["nonsense", "PATH=VALUE"]),
        ]:
            with self.subTest(arguments=arguments):
                options = arguments if "--backend" in arguments else ["--backend", "kinematic", *arguments]
                self.assert_refused(self.call("--out", "refused", *options), *parts)
                self.assertFalse((self.folder / "refused").exists())

    def test_unknown_option(self):
        self.assert_refused(self.call("--bogus"), "--bogus: unknown option")
        self.assert_refused(self.call("--replicate", 2), "--replicate: unknown option; did you mean --replicates?")
        self.assert_refused(self.call("--replicate=2"), "--replicate: unknown option; did you mean --replicates?")
        self.assert_refused(self.call("nonsense"), "nonsense: unexpected argument")

    def test_configuration_of_another_backend_or_table(self):
        for name, options in (
            ("other", ["--backend", "ode"] if HAS_ODE else ["--backend", "mujoco"]),
            ("kinematic", ["--backend", "kinematic"]),
        ):
            if name == "other" and not (HAS_ODE or HAS_MUJOCO):
                continue
            (self.folder / f"{name}.toml").write_text(self.call(*options, "--print-config").stdout)
        if HAS_ODE or HAS_MUJOCO:
            engine = "ode" if HAS_ODE else "mujoco"
            refused = self.call("--config", "other.toml", "--backend", "kinematic", "--out", "x")
            self.assert_refused(
                refused, f'other.toml: was written for engine = "{engine}"', "[backend]", f"--backend {engine}"
            )
        refused = self.call("--config", "kinematic.toml", "--rules", "released", "--out", "x")
        self.assert_refused(refused, 'kinematic.toml: was written for rule_table = "paper"', "[rules]", "--rules paper")
        (self.folder / "ecology.toml").write_text('engine = "mujoco"\nrule_table = "paper"\n[ecology]\nrobots = 20\n')
        shared = self.run_ok(
            "--config", "ecology.toml", "--rules", "released", "--backend", "kinematic", "--print-config"
        )
        self.assertIn("robots = 20", shared.stdout)
        self.assertFalse((self.folder / "x").exists())

    @unittest.skipUnless(HAS_MUJOCO, "no MuJoCo in this build")
    def test_timesteps_of_the_control_period_and_of_screening(self):
        self.assert_refused(
            self.call("--out", "refused", "--set", "physics.timestep_s=0.02"),
            "physics.timestep_s = 0.02",
            "control period",
        )
        self.assertIn("timestep_s = 0.002 ", self.call("--set", "backend.stepping=screening", "--print-config").stdout)
        self.assert_refused(
            self.call("--out", "refused", "--set", "backend.stepping=screening", "--set", "physics.timestep_s=0.001"),
            "physics.timestep_s = 0.001 with backend.stepping = screening: must be 0.002",
        )

    def test_resuming_needs_the_folder(self):
        self.assert_refused(self.call("--backend", "kinematic", "--replicates", 2, "--resume"), "--resume", "--out")

    def test_existing_output_is_not_changed(self):
        self.run_out("run", "--duration", 10)
        before = {file: (self.folder / "run" / file).read_bytes() for file in FILES}
        self.assert_refused(
            self.call("--backend", "kinematic", "--duration", 20, "--out", "run"), "run", "never overwritten"
        )
        self.assertEqual(before, {file: (self.folder / "run" / file).read_bytes() for file in FILES})
        self.assert_refused(self.call("--backend", "kinematic", "--out", "/dev/full"), "/dev/full", "never overwritten")

    def test_folder_that_cannot_be_made(self):
        (self.folder / "file").write_text("")
        self.assert_refused(
            self.call("--backend", "kinematic", "--out", "file/run"), "file/run", "cannot be made", code=1
        )

    def test_broken_files(self):
        (self.folder / "bad.toml").write_text("[ecology]\nrobots = = 3\n")
        self.assert_refused(self.call("--config", "bad.toml", "--out", "x"), "bad.toml:2")
        self.assert_refused(self.call("--config", "missing.toml", "--out", "x"), "missing.toml")
        self.assert_refused(self.call("--robot", "nosuch", "--out", "x"), "nosuch", "searched")
        (self.folder / "robot.toml").write_text('name = "x"\n[core.front]\nmodule = "wheel"\n')
        self.assert_refused(self.call("--robot", "./robot.toml", "--out", "x"), "robot.toml", "wheel")
        (self.folder / "numbers.toml").write_text("seed = -1\n")
        self.assert_refused(self.call("--config", "numbers.toml", "--out", "x"), "seed = -1", ">= 0")
        (self.folder / "numbers.toml").write_text("[ecology]\nrobot_count = 3\n")
        self.assert_refused(
            self.call("--config", "numbers.toml", "--out", "x"), "numbers.toml: ecology.robot_count", "unknown key"
        )

    def test_full_disk_keeps_what_was_written(self):
        result = self.call_by_shell('trap "" XFSZ; ulimit -f 200; exec "$@"', "--backend", "kinematic", "--out", "full")
        self.assertEqual(result.returncode, 1)
        self.assertIn("agents.csv", result.stderr)
        self.assertEqual(self.manifest("full")["status"], "failed")
        self.assertGreater(len(self.rows("full", "events.csv")), 30)

    def test_full_standard_output_is_an_error(self):
        for arguments in (["--print-config"], ["--backend", "kinematic", "--duration", 10, "--out", "run"]):
            self.assertEqual(self.call_by_shell('exec "$@" > /dev/full', *arguments).returncode, 1)
        self.assertEqual(self.manifest("run")["status"], "complete")

    @unittest.skipUnless(HAS_MUJOCO, "no MuJoCo in this build")
    def test_divergence_names_time_and_robot_and_keeps_the_run(self):
        result = self.call(
            "--out", "diverged", "--duration", 600, "--set", "physics.timestep_s=0.02", "--set", "ecology.control_hz=50"
        )
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertRegex(result.stderr, r"diverged at t = [\d.]+ s, robot \d+")
        self.assertEqual(self.manifest("diverged")["status"], "failed")
        self.assertIn("diverged", self.manifest("diverged")["error"])
        self.assertGreaterEqual(len(self.rows("diverged", "agents.csv")), 30)


if __name__ == "__main__":
    unittest.main()
