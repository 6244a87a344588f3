#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""live_test.py PREDATOR_PREY [SUITE] [--sessions=N]: a live run by its web socket: it is steered, made again to the byte, and shown to its
own page alone."""

import contextlib
import os
import pathlib
import random
import resource
import shutil
import socket
import subprocess
import sys
import time
import unittest

from in_folder import InFolder, said_by
from live_page import LiveRun

PROGRAM = sys.argv.pop(1)
SESSIONS = int(sys.argv.pop().removeprefix("--sessions=")) if sys.argv[-1].startswith("--sessions=") else 4
RUN = [PROGRAM, "--backend", "kinematic", "--seed", "5"]


def files_of(folder):
    """Name and bytes of the files of a run that have no times of the clock on the wall."""
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir() if path.suffix in (".csv", ".trp")}


def changed(page, number=1):
    """Waits for a change, which comes alone; returns it."""
    return page.until(
        lambda message: message["kind"] == "state" and message["changes"] and message["changes_from"] == number - 1
    )["changes"][0]


class Live(InFolder):
    def start(self, *options):
        return self.enterContext(LiveRun([*RUN, "--out", "run", *options], self.folder))

    def drive(self, duration="60"):
        """A run with two changes, to its end. Returns its folder."""
        run = self.start("--duration", duration)
        with run.page() as page:
            page.send({"do": "pause"})
            page.until(lambda message: message["kind"] == "state" and message["paused"])
            page.send({"do": "set", "number": "rules.capture.reach_m", "value": "0.5"})
            first = changed(page, 1)
            for _ in range(5):
                page.send({"do": "tick"})
                page.until_kind("tick")
            page.send({"do": "set", "number": "rules.mutation.sd", "value": "0.7"})
            second = changed(page, 2)
            self.assertEqual([first["value"], second["value"]], ["0.5", "0.7"])
            self.assertEqual(second["time_s"] - first["time_s"], 10.0)
            page.send({"do": "speed", "value": 0})
            page.send({"do": "play"})
            seen = []
            page.until(lambda message: seen.append(message) or (message["kind"] == "state" and message["over"]))
            self.assertEqual([message["time_s"] for message in seen if message["kind"] == "tick"][-1], float(duration))
        code, errors = run.wait()
        self.assertEqual((code, said_by(errors)), (0, []))
        return self.folder / "run"

    def test_live_run_with_two_changes_is_made_again_to_the_byte(self):
        live = self.drive()
        rows = self.rows(live / "changes.csv")
        self.assertEqual(
            [(row["number"], row["value"]) for row in rows],
            [("rules.capture.reach_m", "0.5"), ("rules.mutation.sd", "0.7")],
        )
        self.run_ok(*RUN, "--duration", 60, "--changes", live / "changes.csv", "--out", "again")
        self.run_ok(*RUN, "--duration", 60, "--out", "without")
        made = files_of(self.folder / "again")
        self.assertEqual(files_of(live), made)
        self.assertNotEqual(files_of(self.folder / "without")["agents.csv"], made["agents.csv"])

    def test_page_is_shown_with_its_token_alone(self):
        run = self.start("--duration", "60")
        status, body = run.get(f"/?token={run.token}")
        self.assertEqual(status, 200)
        self.assertIn("connect-src 'self'", body)
        self.assertEqual(run.get("/")[0], 403)
        self.assertEqual(run.get(f"/?token={'0' * 32}")[0], 403)
        self.assertEqual(run.get(f"/other?token={run.token}")[0], 404)
        self.assertEqual(run.get(f"/?token={run.token}", host="evil.example")[0], 403)
        self.assertEqual(run.get(f"/?token={run.token}", host="localhost:8000")[0], 200, "ssh forwards another port")

    def test_post_of_a_foreign_page_is_refused_in_one_sentence(self):
        run = self.start("--duration", "60")
        body = b'{"do": "set", "number": "rules.capture.reach_m", "value": "0.5"}'
        head = f"POST /live?token={run.token} HTTP/1.1\r\nHost: 127.0.0.1:{run.port}\r\nOrigin: http://evil.example\r\nContent-Length: {len(body)}\r\n\r\n"
        status, text = run.ask(head.encode() + body)
        self.assertEqual(status, 405)
        self.assertEqual(len(text.splitlines()), 1)

    def test_web_socket_of_a_foreign_page_is_refused(self):
        run = self.start("--duration", "60")
        for wrong in (
            {"origin": "http://evil.example"},
            {"token": "0" * 32},
            {"token": ""},
            {"host": "evil.example"},
            {"origin": f"http://localhost:{run.port}"},
        ):
            with self.subTest(**wrong), run.page(**wrong) as page:
                self.assertEqual(page.status, 403)
                self.assertEqual(len(page.body().splitlines()), 1)
        with run.page() as page:
            self.assertEqual(page.status, 101)

    def test_wrong_wishes_are_refused_in_one_sentence_and_change_nothing(self):
        run = self.start("--duration", "60")
        with run.page() as page:
            page.send({"do": "pause"})
            page.until(lambda message: message["kind"] == "state" and message["paused"])
            for wish, sentence in [
                ("", "JSON object"),
                ("[1, 2", "JSON object"),
                ({"do": 5}, "JSON object"),
                ({"do": "explode"}, "must be"),
                ({"do": "speed", "value": -1}, "speed = -1: must be 0"),
                ({"do": "speed", "value": "fast"}, "JSON object"),
                (
                    {"do": "set", "number": "rules.capture.reach_m", "value": "-1"},
                    "rules.capture.reach_m = -1: must be > 0",
                ),
                (
                    {"do": "set", "number": "rules.capture.reach_m", "value": "nan"},
                    "rules.capture.reach_m = nan: must be finite",
                ),
                ({"do": "set", "number": "rules.capture.reach_m", "value": "far"}, "must be a number"),
                (
                    {"do": "set", "number": "rules.newborn_tag.founder_tag", "value": "7"},
                    "rules.newborn_tag.founder_tag = 7: must be given to a new run",
                ),
                ({"do": "set", "number": "rules.capture.reach_m", "value": "1" * 201}, "must have <= 200 bytes"),
                ({"do": "set", "number": "ecology.robots", "value": "7"}, "is not a rule parameter"),
                ({"do": "set", "number": "rules.capture.reach_m", "value": "1\nx = 2"}, "one number"),
                ({"do": "restart", "seed": -3, "rules": "paper"}, "seed = -3"),
                ({"do": "restart", "seed": 3, "rules": "nonsense"}, "rules = nonsense"),
            ]:
                with self.subTest(wish=wish):
                    page.send(wish)
                    text = page.until_kind("refused")["text"]
                    self.assertIn(sentence, text)
                    self.assertEqual(len(text.splitlines()), 1)
        self.assertEqual((self.folder / "run/changes.csv").read_text(), "time_s,tick,number,value,before\n")

    def test_too_long_message_ends_the_connection_and_not_the_run(self):
        run = self.start("--duration", "60")
        with run.page() as page:
            page.until_kind("state")
            page.send_bytes(b" " * 5000)
            with self.assertRaises((EOFError, ConnectionError)):
                for _ in page.messages():
                    pass
        status, _ = run.ask(b"GET /" + b"a" * 20000 + b" HTTP/1.1\r\n\r\n")
        self.assertIsNone(status)
        with run.page() as page:
            page.until_kind("state")

    def test_connections_beyond_a_bound_are_closed_and_leave_the_run_its_files(self):
        run = self.start("--duration", "60")
        with contextlib.ExitStack() as idle:
            for _ in range(100):
                last = idle.enter_context(socket.create_connection(("127.0.0.1", run.port), timeout=20))
            self.assertEqual(last.recv(1), b"", "closed without a request")
            self.assertLess(len(os.listdir(f"/proc/{run.process.pid}/fd")), 90)
        until = time.monotonic() + 20
        while (status := run.get(f"/?token={run.token}")[0]) != 200 and time.monotonic() < until:
            time.sleep(0.05)
        self.assertEqual(status, 200, "once they are closed")

    def test_second_page_looks_on_and_steers_once_the_first_one_is_closed(self):
        run = self.start("--duration", "60")
        with run.page() as first:
            self.assertTrue(first.until_kind("state")["steers"])
            with run.page() as second:
                self.assertFalse(second.until_kind("state")["steers"])
                second.send({"do": "set", "number": "rules.capture.reach_m", "value": "0.5"})
                self.assertEqual(
                    second.until_kind("refused")["text"], "Another page steers this run; this one only shows it."
                )
                first.socket.close()
                self.assertTrue(
                    second.until(lambda message: message["kind"] == "state" and message["steers"])["steers"]
                )
        self.assertEqual((self.folder / "run/changes.csv").read_text(), "time_s,tick,number,value,before\n")

    def test_restart_makes_another_run_with_the_numbers_as_they_are(self):
        run = self.start("--duration", "20")
        with run.page() as page:
            page.send({"do": "pause"})
            page.send({"do": "set", "number": "rules.capture.reach_m", "value": "0.5"})
            changed(page)
            page.send({"do": "restart", "seed": 9, "rules": "paper"})
            facts = page.until_kind("run")
            self.assertEqual(facts["head"]["seed"], 9)
            at_start = {number["path"].split(".")[1] for number in facts["numbers"] if number["acts_at_start"]}
            self.assertEqual(at_start - {"placement"}, {"community", "newborn_tag", "steering"})
            self.assertEqual(
                [number["value"] for number in facts["numbers"] if number["path"] == "rules.capture.reach_m"], ["0.5"]
            )
            page.send({"do": "restart", "seed": 10, "rules": "released"})
            self.assertEqual(page.until_kind("run")["head"]["rule_table"], "released")
            page.send({"do": "speed", "value": 0})
            page.send({"do": "play"})
            page.until(lambda message: message["kind"] == "state" and message["over"])
        self.assertEqual(run.wait()[0], 0)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["run", "run-1", "run-2"])
        self.run_ok(*RUN[:3], "--seed", 10, "--rules", "released", "--duration", 20, "--out", "alone")
        made = files_of(self.folder / "run-2")
        self.assertEqual(made.pop("changes.csv"), b"time_s,tick,number,value,before\n")
        self.assertEqual(files_of(self.folder / "alone"), made)

    def test_signal_ends_a_paused_run_that_resume_continues(self):
        run = self.start("--duration", "60")
        with run.page() as page:
            page.send({"do": "set", "number": "rules.capture.reach_m", "value": "0.5"})
            changed(page)
            page.send({"do": "pause"})
            page.until(lambda message: message["kind"] == "state" and message["paused"])
            run.process.terminate()
            self.assertEqual(run.wait()[0], 3)
        self.run_ok(*RUN, "--duration", 60, "--out", "run", "--resume")
        self.run_ok(*RUN, "--duration", 60, "--out", "again", "--changes", "run/changes.csv")
        self.assertEqual(files_of(self.folder / "run"), files_of(self.folder / "again"))
        resumed, again = map(self.manifest, ("run", "again"))
        self.assertEqual(
            [resumed[key] for key in ("identity", "description")], [again[key] for key in ("identity", "description")]
        )
        self.assertEqual([one["value"] for one in resumed["description"]["changes"]], ["0.5"])

    def test_failure_reaches_the_page_and_those_that_come_later(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (60_000, 60_000))  # as a full disk
        run = self.enterContext(LiveRun([*RUN, "--duration", "6000", "--out", "run"], self.folder, preexec_fn=limit))
        with run.page() as page:
            page.send({"do": "speed", "value": 0})
            self.assertIn("The run ended: cannot write run/", page.until_kind("refused")["text"])
            with run.page() as later:
                self.assertIn("The run ended: cannot write run/", later.until_kind("refused")["text"])
        self.assertEqual(run.wait()[0], 1)

    def test_run_whose_address_cannot_be_printed_ends(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run(
                [*RUN, "--live", "--out", "run"],
                cwd=self.folder,
                stdout=full,
                stderr=subprocess.PIPE,
                text=True,
                timeout=60,
            )
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("cannot write to standard output", done.stderr)
        self.assertFalse((self.folder / "run").exists())

    def test_wrong_options_are_refused(self):
        self.assert_refused(self.call(*RUN, "--live", "--replicates", 2), "--live: not with --replicates")
        self.assert_refused(self.call(*RUN, "--live-port", 4000), "--live-port: needs --live")
        self.assert_refused(self.call(*RUN, "--live", "--live-port", 80), "--live-port 80: must be >= 1024")


class Sessions(InFolder):
    """Random sessions at a page, made again by the changes that they recorded."""

    def wish(self, draw, numbers):
        number = draw.choice(numbers)
        text = number["value"]
        if text in ("true", "false"):
            value = draw.choice(("true", "false"))
        elif not text.replace(".", "").replace("-", "").replace("e", "").replace("+", "").isdigit():
            value = draw.choice((text, "together", "0"))
        else:
            value = draw.choice(
                (
                    text,
                    "0",
                    "-0",
                    "-0.0",
                    "1",
                    "-1",
                    "7",
                    "1e-300",
                    "0.10",
                    "9007199254740993",
                    "9007199254740994.0",
                    "12345678901234567890.0",
                    str(round(draw.uniform(0, 2) * float(text), draw.randrange(6))),
                    str(draw.randrange(12)),
                    "+0.5",
                    "1_0",
                    "0x10",
                )
            )
        return {"do": "set", "number": number["path"], "value": value}

    def session(self, seed):
        draw = random.Random(seed)
        options = [
            PROGRAM,
            "--backend",
            "kinematic",
            "--rules",
            draw.choice(("paper", "released")),
            "--seed",
            str(seed),
            "--duration",
            str(draw.choice((30, 61, 200))),
        ]
        with LiveRun([*options, "--out", "live"], self.folder) as run:
            with run.page() as page:
                page.send({"do": "pause"})
                numbers = [
                    number
                    for number in page.until_kind("run")["numbers"]
                    if (draw.random() < 0.3 or "reach" in number["path"]) and not number["acts_at_start"]
                ]
                is_over = False
                for _ in range(draw.randrange(1, 12)):
                    for _ in range(draw.choice((1, 1, 2, 8))):
                        page.send(draw.choice((self.wish(draw, numbers[:1]), self.wish(draw, numbers))))
                    if draw.random() < 0.6 and not is_over:
                        page.send({"do": "tick"})
                        is_over = (
                            page.until(
                                lambda message: message["kind"] == "tick"
                                or message["kind"] == "state"
                                and message["over"]
                            )["kind"]
                            == "state"
                        )
                page.send({"do": "speed", "value": 0})
                page.send({"do": "play"})
                is_over or page.until(lambda message: message["kind"] == "state" and message["over"])
            code, errors = run.wait()
        done = self.call(*options, "--changes", "live/changes.csv", "--out", "again")
        self.assertEqual((done.returncode, done.stderr.replace("again", "live")), (code, errors))
        live, again = (files_of(self.folder / name) for name in ("live", "again"))
        self.assertEqual([name for name in live if live[name] != again[name]], [])
        said = [self.manifest(name) for name in ("live", "again")]
        self.assertEqual(
            [said[0][key] for key in ("identity", "description", "remarks")],
            [said[1][key] for key in ("identity", "description", "remarks")],
        )
        changes = len(self.rows("live/changes.csv"))
        for name in ("live", "again"):
            shutil.rmtree(self.folder / name)
        return changes, code

    def test_random_sessions_are_made_again_to_the_byte(self):
        made = [self.session(seed) for seed in range(SESSIONS)]
        self.assertGreater(sum(changes for changes, _ in made), 2 * SESSIONS)
        if SESSIONS > 4:
            print(
                f"{SESSIONS} sessions, {sum(changes for changes, _ in made)} changes, {sum(code != 0 for _, code in made)} ended by an error"
            )


class Changes(InFolder):
    def run_with(self, text, *options):
        (self.folder / "changes.csv").write_text(text)
        return self.call(*RUN, "--duration", 40, "--changes", "changes.csv", "--out", "run", *options)

    def test_wrong_files_are_refused_before_any_work(self):
        head = "time_s,number,value\n"
        for text, words in [
            ("", "line 1: the column time_s is missing"),
            ("time_s,number\n", "line 1: the column value is missing"),
            (head + "soon,rules.capture.reach_m,1\n", "line 2: time_s = soon: must be >= 0"),
            (head + "-1,rules.capture.reach_m,1\n", "line 2: time_s = -1: must be >= 0"),
            (head + "8,rules.capture.reach_m,1\n4,rules.capture.reach_m,2\n", "line 3: time_s = 4: must be >= 8"),
            (head + "8,rules.capture.reach_m\n", "line 2: 2 cells: must be 3"),
            (head + "8,,1\n", "line 2: number: must not be empty"),
            (head + "8,rules.capture.reach_m,-1\n", "rules.capture.reach_m = -1: must be > 0"),
            (head + "8,rules.capture.reach,1\n", "rules.capture.reach: unknown key; did you mean"),
            (head + "8,ecology.robots,40\n", "ecology.robots: cannot change during a run"),
            (
                head + "40,rules.capture.reach_m,1\n",
                "time_s = 40: must be <= 38, the last moment that a decision step follows",
            ),
        ]:
            with self.subTest(text=text):
                self.assert_refused(self.run_with(text), words)
                self.assertFalse((self.folder / "run").exists())

    def test_replicates_and_their_shadow_change_as_one_run_does(self):
        text = "time_s,number,value\n20,rules.capture.reach_m,0.5\n"
        self.assertEqual(self.run_with(text, "--replicates", "2", "--shadow").returncode, 0)
        for folder in ("replicate-00", "replicate-01", "shadow/replicate-00", "shadow/replicate-01"):
            rows = self.rows("run", folder, "changes.csv")
            self.assertEqual([(row["time_s"], row["value"], row["before"]) for row in rows], [("20", "0.5", "1")])

    def test_as_many_changes_as_a_page_made_are_made_again(self):
        values = [str((index % 97 + 1) / 100) for index in range(2500)]
        text = "time_s,number,value\n" + "".join(
            f"{2 * (index // 150)},rules.capture.reach_m,{value}\n" for index, value in enumerate(values)
        )
        self.assertEqual(self.run_with(text).returncode, 0)
        self.assertEqual([row["value"] for row in self.rows("run/changes.csv")], values)
        self.run_ok(*RUN, "--duration", 40, "--changes", "run/changes.csv", "--out", "again")
        self.assertEqual(files_of(self.folder / "run"), files_of(self.folder / "again"))

    def test_of_a_number_that_changes_again_the_last_change_counts(self):
        reach, sd = "rules.capture.reach_m", "rules.mutation.sd"
        text = f"time_s,number,value\n4,{reach},0.5\n8,{sd},0.7\n8,{reach},0.4\n20,{sd},0.6\n20,{reach},1\n"
        self.assertEqual(self.run_with(text).returncode, 0)
        rows = self.rows("run/changes.csv")
        self.assertEqual(
            [(row["value"], row["before"]) for row in rows if row["number"] == reach],
            [("0.5", "1"), ("0.4", "0.5"), ("1", "0.4")],
        )
        self.assertEqual([(row["value"], row["before"]) for row in rows if row["number"] == sd][1:], [("0.6", "0.7")])


if __name__ == "__main__":
    unittest.main()
