#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""effects_test.py PREDATOR_PREY: nothing is without effect and silent. Each parameter changes a short run, or the run's remarks name
it; studies/tests/test_ablations.py has the rules of the two tables. tests/unit/core has the rules that are refused, and the parameters of every
table on backends of points."""

import json
import pathlib
import re
import sys
import tomllib
import unittest

from in_folder import InFolder, call

PREDATOR_PREY = sys.argv.pop(1)
# A crowd in which every rule acts soon: ticks of a tenth of their simulated time.
CROWD = {
    "ecology.arena": "small.toml",
    "ecology.robots": 14,
    "ecology.duration_s": 500,
    "ecology.clock_scale": 0.05,
    "ecology.first_tick_s": 0.0,
    "rules.community.predators": 5,
    "rules.placement.half_extent_m": 1.5,
    "rules.activation.distance_m": 0.7,
    "rules.capture.min_age_s": 20,
    "rules.floor.floor": 4,
    "rules.minimum_predators.below": 4,
    "rules.starvation.interval.base_ticks": 9,
    "rules.tag_switch.cool_down_s": 10,
    "rules.tag_switch.period_s": 6,
    "rules.starvation.interval.only_above": 2,
}
# Those that another value than twice the number, or the number and one, shows.
OTHER = {
    "ecology.arena": "wide.toml",
    "ecology.first_tick_s": 20,
    "ecology.robot": "gecko",
    "ecology.gait": "spider_paper",
    "ecology.idle_control_steps": 5,
    "physics.timestep_s": 0.001,
    "rules.community.predators": 6,
    "rules.placement.half_extent_m": 1.0,
    "rules.newborn_tag.founder_tag": -1,
    "rules.brain.turn_angle_rad": 0.1,
    "rules.parent.starved.range_m": 0.3,
    "rules.mutation.sd": 0.9,
    "rules.mutation.half_width": 0.9,
    "rules.mutation.limit": 0.2,
    "rules.capture.reach_m": 0.5,
    "rules.capture.min_age_s": 300,
    "rules.floor.floor": 9,
    "rules.minimum_predators.below": 8,
    "rules.starvation.interval.base_ticks": 30,
    "rules.starvation.interval.min_interval_ticks": 40,
    "rules.starvation.interval.only_above": 12,
    "rules.starvation.exemption.range_m": 1.5,
    "backend.timestep_s": 0.07,
    "backend.box_depth": "whole",
}
# The length of the run, how an engine computes the same motion, and stops of hinges that these gaits do not reach.
LEFT_OUT = {
    "ecology.duration_s",
    "ecology.ends_when",
    "backend.threads",
    "backend.stepping",
    "backend.limit_stiffness_N_m_rad",
    "backend.limit_damping_N_m_s_rad",
}


def flat(tree, path=""):
    for name, part in tree.items():
        yield from flat(part, f"{path}{name}.") if isinstance(part, dict) else [(path + name, part)]


class Effects(InFolder):
    def setUp(self):
        super().setUp()
        for name, side_m in (("small", 6.0), ("wide", 6.5)):
            (self.folder / f"{name}.toml").write_text(
                f'name = "{name}"\nside_m = {side_m}\nfriction = {0.2 * side_m}\n'
            )

    def parameters(self, *options, program=PREDATOR_PREY):
        """Each parameter with its value, and the other values of the enumerations."""
        printed = call(program, *options, "--print-config").stdout
        listed = re.findall(r"^(\w+) = '\w*'  # .*?((?:\w+(?: \(\w+\))?(?:, | or ))+\w+(?: \(\w+\))?)$", printed, re.M)
        names = {name: re.sub(r" \(\w+\)", "", words) for name, words in listed}
        values = dict(
            flat({name: part for name, part in tomllib.loads(printed).items() if name not in ("rule_table", "engine")})
        )
        return values, {
            path: re.split(", | or ", names[path.split(".")[-1]]) for path in values if path.split(".")[-1] in names
        }

    def run_with(self, out, settings, *options, program=PREDATOR_PREY):
        """The rows of a run, and those of its remarks that state "no effect", up to these words."""
        sets = [part for path, value in settings.items() for part in ("--set", f"{path}={json.dumps(value)}")]
        self.run_ok(program, *options, *sets, "--replay-hz", 0, "--out", out)
        run = self.folder / out
        return [(run / name).read_bytes() for name in ("events.csv", "agents.csv")], [
            remark.split(" no effect")[0]
            for remark in json.loads((run / "manifest.json").read_text())["remarks"]
            if " no effect" in remark
        ]


class Parameters(Effects):
    def check(self, engine):
        for table in ("paper", "released"):
            values, names = self.parameters("--rules", table, "--backend", engine)
            options = [
                "--rules",
                table,
                "--backend",
                engine,
                *(["--threads", 1] if "backend.threads" in values else []),
            ]
            crowd = {path: value for path, value in CROWD.items() if path in values} | (
                {"physics.timestep_s": 0.005} if table == "released" else {}
            )
            if engine == "ode":  # slow; rules act on any engine
                crowd |= {"ecology.duration_s": 60}
                values = {
                    path: value
                    for path, value in values.items()
                    if not path.startswith("rules.") or path.startswith("rules.steering.")
                }
            rows, remarked = self.run_with(f"{engine}-{table}", crowd, *options)
            for path, value in values.items():
                if path in LEFT_OUT:
                    continue
                now = crowd.get(path, value)
                others = [name for name in names.get(path, []) if name != value]
                other = OTHER.get(path, others[0] if others else now + 1 if isinstance(now, int) else 2 * now or 1.0)
                with self.subTest(engine=engine, table=table, path=path, value=other):
                    its_rows, remarks = self.run_with(f"{engine}-{table}-{path}", crowd | {path: other}, *options)
                    self.assertEqual(its_rows == rows, any(path in remark for remark in [*remarks, *remarked]), remarks)

    def test_each_parameter_changes_a_run_or_has_a_remark(self):
        engines = re.search(r"--backend TEXT +physics: ([\w, ]+) \(", call(PREDATOR_PREY, "--help").stdout)[1].split(
            ", "
        )
        for points in ("torus", "kinematic"):  # tests/unit/core/every_parameter_test.cpp has them, and every table
            engines.remove(points)
        for engine in engines:
            self.check(engine)


class Policies(Effects):
    def test_a_policy_of_each_slot_is_swapped_somewhere(self):
        """So the ecology asks each slot; each policy's own test shows what it answers."""
        root = pathlib.Path(__file__).parents[2]
        include = root / "include/trophic"
        slots = {}
        for kind in (
            "perception",
            "control/brain",
            "death",
            "reproduction",
            "energy",
            "initialization/community",
            "initialization/placement",
        ):
            for path in sorted((include / kind).rglob("*.hpp")):
                if (
                    path.parent.parent != include
                    and path.stem not in ("contract", "list")
                    and "detail" not in path.parts
                ):
                    slots.setdefault(path.parent.relative_to(include), set()).add(path.stem)
        self.assertGreater(len(slots), 20)
        tables = [
            *(include / "rules").glob("*.hpp"),
            *(include / "worlds").glob("*.hpp"),
            *(root / "studies").glob("*/*.hpp"),
            root / "tests/unit/core/effects_test.cpp",
            root / "docs/how-to/a-living-world.md",  # tests run its tables
        ]
        swapped = {name for path in tables for name in re.findall(r"/(\w+)\.hpp>", path.read_text())}
        self.assertEqual([str(slot) for slot, policies in slots.items() if not policies & swapped], [])


class Changes(Effects):
    def test_a_change_without_effect_is_refused_before_the_run(self):
        options = ["--backend", "kinematic", "--duration", 100]
        self.run_with("origin", {}, *options)
        for change, why in (
            (
                ("rules.community.predators", 10),
                "must be given to a new run, with --set rules.community.predators=10, because a run reads it",
            ),
            (("rules.steering.exponent", 3), "must be omitted, because it has no effect: kinematic has no joints"),
        ):
            path, value = change
            (self.folder / "changes.csv").write_text(
                f"time_s,number,value\n40,{path},{value}\n98,rules.capture.reach_m,2\n"
            )
            refusal = f"{path} = {value}: {why}"
            self.assert_refused(self.call(PREDATOR_PREY, *options, "--changes", "changes.csv", "--out", "run"), refusal)
            branch = ["--from", "origin", "--at", 50, "--set", f"{path}={value}", "--out", "branch"]
            self.assert_refused(self.call(PREDATOR_PREY, *options[:2], *branch), refusal)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir() if path.is_dir()), ["origin"])

    def test_each_parameter_says_when_it_is_read(self):
        printed = call(PREDATOR_PREY, "--backend", "kinematic", "--print-config").stdout
        for line in (
            "predators = 14  # number of founders that are predators; the others are prey; read at the start",
            "limit = 1.0  # bound on the absolute value of weights; read at the start and at births without a parent",
            "sd = 0.05  # standard deviation; read at births",
            "reach_m = 1.0  # distance within which a victim is caught",
        ):
            self.assertIn(f"\n{line}\n", printed)


if __name__ == "__main__":
    unittest.main()
