#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""senses_test.py PREDATOR_PREY: --senses adds senses.csv and --states states.csv to a run's folder, for all kinds of runs, and
neither changes another file."""

import collections
import math
import sys
import unittest

from in_folder import InFolder, call, planned

PROGRAM = sys.argv.pop(1)
ENGINES = ["kinematic"] + (["mujoco"] if ", mujoco" in call(PROGRAM, "--help").stdout else [])
OTHERS = ["events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "replay.trp", "checkpoint.bin"]


class Senses(InFolder):
    def run_ok(self, *arguments, backend="kinematic"):
        given = [] if "--plan" in arguments or "--from" in arguments else ["--backend", backend]
        return super().run_ok(PROGRAM, *given, *arguments)

    def rows(self, out, table="senses.csv"):
        return super().rows(out, table)

    def test_with_senses_every_other_file_is_the_same(self):
        for backend in ENGINES:
            with self.subTest(backend=backend):
                duration = 600 if backend == "kinematic" else 12
                told = self.run_ok("--duration", duration, "--senses", "--out", f"with-{backend}", backend=backend)
                self.run_ok("--duration", duration, "--out", f"without-{backend}", backend=backend)
                self.assertIn(
                    "/{events,agents,phylogeny,genomes,senses}.csv, manifest.json, replay.trp, checkpoint.bin",
                    told.stdout,
                )
                for name in OTHERS[:-1]:
                    self.assertEqual(
                        *((self.folder / f"{out}-{backend}" / name).read_bytes() for out in ("with", "without")), name
                    )
                self.assertFalse((self.folder / f"without-{backend}/senses.csv").exists())
                manifests = [self.manifest(f"{out}-{backend}") for out in ("with", "without")]
                self.assertEqual(
                    manifests[0].pop("senses"),
                    {"inputs": ["side_of_adversary", "distance_over_terrain", "tag_ratio_of_all"]},
                )
                self.assertEqual(manifests[0]["tables"].pop("senses.csv")["rows"], 30 * (duration // 2 + 1))
                for manifest in manifests:
                    for name in ("wall_s", "command", "command_line", "host", "crc32"):
                        manifest.pop(name, None)
                self.assertEqual(*manifests)

    def test_rows_of_senses_agree_with_the_other_tables(self):
        self.run_ok("--duration", 3000, "--senses", "--out", "run", "--seed", 3, "--rules", "released")
        agents = self.rows("run", "agents.csv")
        senses = self.rows("run")
        self.assertEqual(
            [(a["tick"], a["body"], a["id"]) for a in agents], [(s["tick"], s["body"], s["id"]) for s in senses]
        )
        switches = {(e["tick"], e["id"]) for e in self.rows("run", "events.csv") if e["event"] == "tag_switch"}
        self.assertEqual(switches, {(s["tick"], s["id"]) for s in senses if s["tag_outcome"] == "switched"})
        kinds = collections.Counter(s["tag_outcome"] for s in senses)
        self.assertEqual(set(kinds), {"", "kept", "switched", "denied"})
        exempt = 0
        for agent, sense in zip(agents, senses):
            for bodily in ("height_m", "tilt_rad", "touches_wall", "robots_touched"):
                self.assertEqual(sense[bodily], "")  # points have none
            self.assertEqual(sense["exempt"] == "", sense["species"] == "prey")
            exempt += sense["exempt"] == "1"
            asked = sense["tag_outcome"] != ""
            for cell in ("chosen_tag", "angle_output", "tag_output", "input0", "input1", "input2"):
                self.assertEqual(sense[cell] != "", asked, cell)
            if asked:
                self.assertEqual(agent["tag"] == sense["chosen_tag"], sense["tag_outcome"] != "denied")
                self.assertEqual(float(sense["tag_output"]) > 0, sense["chosen_tag"] == "1")
                self.assertEqual(float(sense["angle_output"]) > 0, float(agent["target_angle_rad"]) > 0)
        self.assertGreater(exempt, 0)

    @unittest.skipUnless("mujoco" in ENGINES, "built without MuJoCo")
    def test_bodies_have_a_height_a_tilt_and_contacts(self):
        self.run_ok("--duration", 20, "--senses", "--out", "run", backend="mujoco")
        rows = self.rows("run")
        for row in rows:
            self.assertTrue(0.0 < float(row["height_m"]) < 0.5)
            self.assertTrue(0.0 <= float(row["tilt_rad"]) <= math.pi)
            self.assertIn(row["touches_wall"], "01")
        self.assertEqual(sum(int(row["robots_touched"]) for row in rows) % 2, 0)

    def test_senses_with_thinned_agents_and_without_a_recording(self):
        self.run_ok("--duration", 600, "--senses", "--agents-every", 7, "--replay-hz", 0, "--out", "thin")
        self.run_ok("--duration", 600, "--senses", "--out", "whole")
        self.assertEqual(self.rows("thin"), [row for row in self.rows("whole") if int(row["tick"]) % 7 == 0])
        self.assertFalse((self.folder / "thin/replay.trp").exists())

    def test_senses_of_replicates_their_shadow_and_a_resumed_set(self):
        common = ("--duration", 300, "--replicates", 2, "--shadow", "--out", "set")
        self.run_ok(*common, "--senses")
        for run in ("replicate-00", "replicate-01", "shadow/replicate-00", "shadow/replicate-01"):
            self.assertEqual(len(self.rows(f"set/{run}")), 30 * 151)
        before = (self.folder / "set/replicate-01/senses.csv").read_bytes()
        self.run_ok("--duration", 300, "--replicates", 3, "--senses", "--resume", "--out", "set")
        self.assertEqual((self.folder / "set/replicate-01/senses.csv").read_bytes(), before)
        self.assertEqual(len(self.rows("set/replicate-02")), 30 * 151)

    def test_a_run_that_is_extended_keeps_the_tables_of_its_start(self):
        self.run_ok("--duration", 600, "--senses", "--out", "whole")
        self.run_ok("--duration", 300, "--senses", "--out", "parts")
        self.run_ok("--duration", 600, "--resume", "--out", "parts")
        for name in ("senses.csv", *OTHERS[:-2]):
            self.assertEqual(*((self.folder / out / name).read_bytes() for out in ("whole", "parts")), name)
        self.assertIn("senses", self.manifest("parts"))

    def test_a_run_that_begins_from_another_has_its_past(self):
        self.run_ok("--duration", 600, "--senses", "--out", "whole", "--checkpoint-s", 200)
        for at in (100, 450):
            self.run_ok("--from", "whole", "--at", at, "--duration", 600, "--out", f"at{at}")
            self.assertEqual(
                (self.folder / f"at{at}/senses.csv").read_bytes(), (self.folder / "whole/senses.csv").read_bytes()
            )

    def test_a_sweep_has_a_key_for_senses(self):
        (self.folder / "grid.toml").write_text(
            'engine = "kinematic"\nreplicates = 1\nsenses = true\n[set]\necology.duration_s = 20.0\n'
            "[grid]\nrules.capture.reach_m = [0.5, 1.0]\n"
        )
        self.run_ok(*planned(PROGRAM, "grid.toml", "sweep", self.folder)[1:])
        tables = list((self.folder / "sweep").rglob("senses.csv"))
        self.assertEqual(len(tables), 2)

    def test_states_of_a_table_whose_rules_keep_some(self):
        rules = ("--rules", "released", "--seed", 3)
        self.run_ok("--duration", 600, *rules, "--out", "without")
        self.run_ok("--duration", 600, *rules, "--states", "--out", "with")
        for name in OTHERS[:-1]:
            self.assertEqual(*((self.folder / out / name).read_bytes() for out in ("with", "without")), name)
        states, agents = self.rows("with", "states.csv"), self.rows("with", "agents.csv")
        self.assertEqual(
            [(s["tick"], s["body"], s["id"]) for s in states], [(a["tick"], a["body"], a["id"]) for a in agents]
        )
        self.assertEqual(
            list(states[0])[4:],
            [
                "parent.starved.body",
                "parent.starved.victim",
                "parent.sacrificed.killer",
                "starvation.exemption.adversary_distance_m",
            ],
        )
        self.assertTrue(any(row["parent.sacrificed.killer"] for row in states))
        self.assertEqual(self.manifest("with")["tables"]["states.csv"]["rows"], len(states))

        self.run_ok("--duration", 300, *rules, "--states", "--out", "parts")
        self.run_ok("--duration", 600, *rules, "--resume", "--out", "parts")
        self.run_ok("--from", "with", "--at", 400, "--duration", 600, "--out", "again")
        for out in ("parts", "again"):
            self.assertEqual(
                (self.folder / out / "states.csv").read_bytes(), (self.folder / "with/states.csv").read_bytes(), out
            )

    def test_states_of_replicates_of_a_sweep_and_of_rules_without_any(self):
        self.run_ok("--duration", 20, "--rules", "released", "--replicates", 1, "--shadow", "--states", "--out", "set")
        for run in ("replicate-00", "shadow/replicate-00"):
            self.assertEqual(len(self.rows(f"set/{run}", "states.csv")), 30 * 11)
        (self.folder / "grid.toml").write_text(
            'engine = "kinematic"\nreplicates = 1\nstates = true\n[set]\necology.duration_s = 20.0\n'
            "[grid]\nrules.capture.reach_m = [0.5, 1.0]\n"
        )
        self.run_ok(*planned(PROGRAM, "grid.toml", "sweep", self.folder)[1:])
        tables = list((self.folder / "sweep").rglob("states.csv"))
        self.assertEqual(len(tables), 2)
        self.assertEqual(tables[0].read_text().splitlines()[0], "time_s,tick,body,id")


if __name__ == "__main__":
    unittest.main()
