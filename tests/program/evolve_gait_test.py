#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""evolve_gait_test.py TROPHIC [unittest arguments]: gaits evolved and measured as users do it."""

import csv
import pathlib
import signal
import subprocess
import sys
import unittest

from in_folder import InFolder

TROPHIC = sys.argv.pop(1)
ROBOTS = pathlib.Path(__file__).resolve().parents[2] / "models/robots"
EVOLVE = [TROPHIC, "evolve-gait"]
MEASURE = [TROPHIC, "measure-gait"]
FILES = ["settings.toml", "checkpoint.toml", "gait.toml", "phylogeny.csv"]
SMALL = [
    "--generations",
    3,
    "--set",
    "plan.population=4",
    "--set",
    "plan.parents=4",
    "--set",
    "plan.children=4",
    "--set",
    "trial.duration_s=6",
]


class EvolveGait(InFolder):
    def evolve(self, *arguments):
        return self.run_ok(*EVOLVE, *arguments)

    def interrupt(self, out, how, after):
        """Starts a run, waits until that file exists, and ends the run."""
        running = subprocess.Popen(
            [*EVOLVE, *map(str, SMALL), "--out", out], cwd=self.folder, stdout=subprocess.PIPE, text=True
        )
        self.wait_for(f"{out}/{after}", running)
        running.send_signal(how)
        printed, _ = running.communicate(timeout=60)
        return running.returncode, printed

    def assert_same_files(self, one, other):
        for file in FILES:
            self.assertEqual((self.folder / one / file).read_bytes(), (self.folder / other / file).read_bytes(), file)

    def test_killed_or_stopped_anywhere_and_resumed_gives_the_same_bytes(self):
        self.evolve(*SMALL, "--threads", 1, "--out", "whole")
        for after in ("settings.toml", "checkpoint.toml", "gait.toml"):
            self.interrupt("killed-" + after, signal.SIGKILL, after)
            self.evolve(*SMALL, "--threads", 2, "--out", "killed-" + after)
            self.assert_same_files("whole", "killed-" + after)
        code, printed = self.interrupt("stopped", signal.SIGINT, "gait.toml")
        self.assertIn(code, (0, 3))
        self.assertTrue(
            (code == 3 and "repeat the command to resume" in printed) or "generation 3 of 3" in printed, printed
        )
        self.evolve("--config", "stopped/settings.toml", "--out", "stopped")
        self.assert_same_files("whole", "stopped")

        rows = self.rows("whole/phylogeny.csv")
        self.assertEqual([int(row["id"]) for row in rows], list(range(16)))
        self.assertEqual(sum(row["destruction_time"] == "inf" for row in rows), 4)
        self.assertEqual([int(row["origin_time"]) for row in rows], [birth for birth in range(4) for _ in range(4)])

        walked = self.run_ok(*MEASURE, "--gait", "whole/gait.toml", "--duration", "6")
        table = list(csv.DictReader(walked.stdout.splitlines()))
        self.assertEqual([float(row["target_angle_rad"]) for row in table], [0.7, 0.0, -0.7])
        self.assertAlmostEqual(float(table[1]["timestep_s"]), 0.0012)

    def test_a_walk_that_diverges_is_an_error_in_one_sentence(self):
        failed = self.call(*MEASURE, "--robot", "gecko", "--table", "released", "--duration", "20")
        self.assertEqual(failed.returncode, 1, failed.stdout)
        self.assertRegex(
            failed.stderr,
            r"\Atrophic.*: gecko with gecko_steered, mujoco .*, rk4 0.012 s: simulation diverged at .*\n\Z",
        )

    def test_a_robot_that_walks_backwards_or_sideways_is_remarked_on(self):
        spider = (ROBOTS / "spider.toml").read_text()
        for forward_deg, part in ((45 + 180, "walks backwards"), (45 + 60, "more to its side than ahead"), (45, "")):
            turned = spider.replace("forward_deg = 45", f"forward_deg = {forward_deg}")
            (self.folder / f"{forward_deg}.toml").write_text(turned)
            measured = self.run_ok(*MEASURE, "--robot", f"{forward_deg}.toml", "--duration", "10")
            self.assertIn(part, measured.stderr)
            self.assertEqual(bool(part), bool(measured.stderr))

    def test_without_a_name_it_takes_the_next_free_folder(self):
        for number in (1, 2):
            self.evolve(*SMALL, "--generations", 0)
            self.assertTrue((self.folder / f"runs/spider-{number}/gait.toml").is_file())

    def test_a_pre_experiment_whose_every_trial_diverged_is_a_failure_and_leaves_no_gait(self):
        failed = self.call(
            *EVOLVE,
            "--robot",
            "gecko",
            "--generations",
            0,
            "--threads",
            1,
            "--set",
            "trial.duration_s=2",
            "--set",
            "physics.timestep_s=0.006",
            "--out",
            "diverged",
        )
        self.assertEqual(failed.returncode, 1, failed.stdout)
        self.assertIn(
            "every trial of 20 candidates diverged, so there is no gait: physics.timestep_s = 0.006", failed.stderr
        )
        self.assertFalse((self.folder / "diverged/gait.toml").exists())

    def test_what_cannot_be_measured_is_an_error(self):
        lines = (ROBOTS / "spider.toml").read_text().splitlines(keepends=True)
        (self.folder / "bare.toml").write_text("".join(line for line in lines if not line.startswith("gait ")))
        refused = self.call(*MEASURE, "--robot", "bare.toml")
        self.assertEqual(refused.stdout, "")
        self.assert_refused(refused, "--gait: must name a gait")

    def test_one_program_at_a_time_continues(self):
        self.evolve(*SMALL, "--out", "whole")
        self.interrupt("run", signal.SIGKILL, "checkpoint.toml")
        pipes = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "text": True}
        programs = [
            subprocess.Popen([*EVOLVE, *map(str, SMALL), "--out", "run"], cwd=self.folder, **pipes) for _ in range(4)
        ]
        for program in programs:
            errors = program.communicate(timeout=60)[1]
            said = "" if program.returncode == 0 else "trophic evolve-gait: run: another program is running in it\n"
            self.assertEqual(errors, said)
        self.assertIn(0, [program.returncode for program in programs])
        self.assert_same_files("whole", "run")

    def test_settings_read_back(self):
        printed = self.evolve(
            "--table", "released", "--robot", "gecko", "--set", "variation.weight_limit=3", "--print-config"
        )
        (self.folder / "numbers.toml").write_text(printed.stdout)
        again = self.evolve("--config", "numbers.toml", "--print-config")
        self.assertEqual(again.stdout, printed.stdout)
        self.assertIn("rule_table = 'released'", printed.stdout)
        for fitness, facing in (("displacement_minus_x", "core_x"), ("steered_displacement", "forward_axis")):
            numbers = self.evolve("--table", "released", "--fitness", fitness, "--print-config").stdout
            self.assertIn("robot = 'spider_released'", numbers)
            self.assertIn(f"facing = '{facing}'", numbers)

    def test_refusals(self):
        (self.folder / "taken").mkdir()
        (self.folder / "broken.toml").write_text("name = 'x'\nhinges = [")
        for part, program, arguments in (
            ("exists already", EVOLVE, [*SMALL, "--out", "taken"]),
            ("no joints", EVOLVE, ["--backend", "kinematic", "--out", "new"]),
            ("--table late: must be paper or released", EVOLVE, ["--table", "late", "--out", "new"]),
            ("trial.duration_s = -1: must be > 0", EVOLVE, ["--set", "trial.duration_s=-1", "--out", "new"]),
            ("plan.size: unknown key", EVOLVE, ["--set", "plan.size=3", "--out", "new"]),
            ('no robot "centaur"', EVOLVE, ["--robot", "centaur", "--out", "new"]),
            ("broken.toml:2:", EVOLVE, ["--robot", "./broken.toml", "--out", "new"]),
            ("broken.toml:2:", MEASURE, ["--gait", "./broken.toml"]),
            ("--duration 1: must be >= 5.1", MEASURE, ["--duration", "1"]),
            ("--backend kinematic: has no joints", MEASURE, ["--backend", "kinematic"]),
            ("did you mean --generations?", EVOLVE, ["--generation", 3, "--out", "new"]),
            ("did you mean plan.children?", EVOLVE, ["--set", "plan.childen=3", "--out", "new"]),
            ("does not fit robot gecko", MEASURE, ["--robot", "gecko", "--gait", "spider_published"]),
        ):
            with self.subTest(part=part):
                self.assert_refused(self.call(*program, *arguments), part)
        self.assertFalse((self.folder / "new").exists())


if __name__ == "__main__":
    unittest.main()
