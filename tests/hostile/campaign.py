#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""campaign.py BIN PART... [--cases N] [--seed N]: attacks at random on the programs in a folder, for scripts/hostile. Another seed makes other attacks.

kills      a run, a set with nulls or the runs of a plan, of any table, is killed or stopped at random moments: resumed, its tables have the same bytes
damages    a random file of a run, set, sweep or result is damaged, half of them with checksums that fit, and commands read it
options    random options with random values to every program
texts      a hostile text as the name of a folder, sweep, robot, arena, column, metric, figure or option, and what is then printed and written
live       wrong requests, frames and wishes to a live page: the run goes on, and its tables are those of the same run without a page

A command may end with code 0, or with 1 or 2 and one line on standard error. It may not crash, hang, print a Python traceback or a control
character, leave files behind when it refuses, or write a page in which a text of the user's is a tag. The last line counts the attacks, and the exit
code is 1 if one succeeded."""

import argparse
import html.parser
import importlib
import json
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import traceback
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
import figures_python  # noqa: E402

figures_python.continue_with_pandas()
from in_folder import sealed_text  # noqa: E402
from live_page import LiveRun  # noqa: E402

RAW = re.compile(
    r"Traceback|terminate called|Segmentation|Assertion|json\.exception|std::|Error:|Errno|core dumped|Warning:|<module|/trophic/\w+\.py"
)
CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")
MEMORY, CPU_S = 6 << 30, 60
QUICK = ("--backend", "kinematic", "--robots", "16", "--set", "rules.community.predators=8")


def limits():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_S, CPU_S + 5))


class Campaign:
    def __init__(self, bin_folder, seed):
        self.bin = pathlib.Path(bin_folder).resolve()
        self.draw = random.Random(seed)
        self.seed = seed
        self.ends = {}
        self.found = []
        self.environment = {
            **os.environ,
            "PATH": f"{self.bin}:{os.environ['PATH']}",
            "MPLCONFIGDIR": tempfile.gettempdir(),
        }
        self.environment["OPENBLAS_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"
        self.has_modules = self.load_modules()

    def load_modules(self):
        """Loads the package of the programs once: a command that Python does is then a fork, which takes a tenth of the time."""
        package = next((self.bin.parent / "share/trophic/python").glob("trophic"), None)
        if package is None:
            return False
        sys.path.insert(0, str(package.parent))
        for name in (
            "report.analyze",
            "report.page",
            "sweeps.report",
            "contests",
            "contest_plan",
            "cross_check",
            "cite",
            "plan",
            "help",
            "selection",
            "metrics.forests",
            "metrics.bodies",
        ):
            importlib.import_module(f"trophic.{name}")
        from trophic import plot

        plot._import_matplotlib()
        importlib.import_module("trophic.figures.paper")
        return True

    def program(self, name):
        return str(self.bin / name)

    def find(self, what, *about):
        self.found.append(what)
        print(f"FOUND {what}: {' | '.join(str(one)[-1500:] for one in about)}", flush=True)

    def call(self, *words, cwd):
        words = [str(word) for word in words]
        if self.has_modules and words[0] == self.program("trophic") and words[1:2] and words[1] in IN_PYTHON:
            more = ["--jobs", "1"] if words[1] == "analyze" and "--jobs" not in words and "--help" not in words else []
            return self.forked([*words, *more], cwd)
        return subprocess.run(
            words,
            cwd=cwd,
            capture_output=True,
            timeout=600,
            preexec_fn=limits,
            env=self.environment,
            stdin=subprocess.DEVNULL,
        )

    def forked(self, words, cwd):
        """As the program trophic-VERB does it."""
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as errors:
            child = os.fork()
            if child == 0:
                try:
                    os.chdir(cwd)
                    os.environ.update(self.environment, TROPHIC_BIN=str(self.bin))
                    limits()
                    for stream, number in (
                        (os.open(os.devnull, os.O_RDONLY), 0),
                        (out.fileno(), 1),
                        (errors.fileno(), 2),
                    ):
                        os.dup2(stream, number)
                    sys.stdout, sys.stderr = (open(number, "w", encoding="utf-8", closefd=False) for number in (1, 2))
                    from trophic import command

                    command.main(words[1:])
                except SystemExit as ended:
                    sys.stderr.flush()
                    os._exit(ended.code or 0)
                except BaseException:
                    traceback.print_exc()
                    sys.stderr.flush()
                finally:
                    os._exit(1)
            until = time.monotonic() + 600
            while (ended := os.waitpid(child, os.WNOHANG))[0] == 0:
                if time.monotonic() > until:
                    os.kill(child, signal.SIGKILL)
                    os.waitpid(child, 0)
                    raise subprocess.TimeoutExpired(words, 600)
                time.sleep(0.005)
            out.seek(0)
            errors.seek(0)
            return subprocess.CompletedProcess(words, os.waitstatus_to_exitcode(ended[1]), out.read(), errors.read())

    def ok(self, *words, cwd):
        done = self.call(*words, cwd=cwd)
        assert done.returncode == 0, f"{words}: {done.stderr.decode()[-2000:]}"
        return done.stdout.decode()

    def judged(self, *words, cwd, may_fail=True, stopped=False):
        """Runs a command whose input is hostile, and reports what it must not do."""
        before = files_in(cwd)
        try:
            done = self.call(*words, cwd=cwd)
        except subprocess.TimeoutExpired:
            self.find("hangs", words)
            return None
        except ValueError:  # a word that no command can have
            return None
        out, errors = done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")
        code = done.returncode
        self.ends[code] = self.ends.get(code, 0) + 1
        if sum(self.ends.values()) % 25 == 0:
            print(f"{sum(self.ends.values())} commands", flush=True)
        about = (words, f"exit {code}", out[-300:], errors)
        if code == -signal.SIGXCPU or code == -signal.SIGKILL or code == 3:
            if not stopped:
                self.find("takes too long", *about)
            return done
        if code not in (0, 1, 2):
            self.find(f"exit code {code}", *about)
        if RAW.search(errors) or "Traceback" in out:
            self.find("raw error", *about)
        if CONTROL.search(errors) or CONTROL.search(out):
            self.find("control character", *about)
        if code in (1, 2):
            lines = [
                line
                for line in errors.splitlines()
                if not line.startswith(("all output so far is in", "remark", "to resume only these"))
                and ": left out: " not in line
            ]
            if len(lines) != 1:
                self.find(f"{len(lines)} lines on standard error", *about)
            elif len(lines[0]) > 2000 + max(map(len, map(str, words))):
                self.find("a long sentence", *about)
            left = files_in(cwd) - before
            if code == 2 and left:
                self.find("refused, and left files", *about, left)
        if code and not may_fail:
            self.find("refused", *about)
        for page in cwd.rglob("*.htm*"):
            if page.is_file() and page.relative_to(cwd) not in before:
                self.look_at(page, words)
        return done

    def look_at(self, page, words):
        """A page may have no tag and no attribute of the user's."""
        reader = Tags()
        reader.feed(page.read_text(errors="replace"))
        if reader.wrong:
            self.find("a tag of the user's", words, reader.wrong)


def files_in(folder):
    return {path.relative_to(folder) for path in folder.rglob("*")}


class Tags(html.parser.HTMLParser):
    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.wrong = []

    def handle_starttag(self, tag, attrs):
        is_replay = tag == "iframe" and dict(attrs).get("title") == "replay"
        if (
            tag in ("evil", "iframe", "object", "embed", "base")
            and not is_replay
            or any(name.startswith("on") or name == "evil" for name, _ in attrs)
        ):
            self.wrong.append((tag, attrs[:3]))


# Kills


def tables_of(campaign, folder):
    """(program, table, backend) of all shipped tables."""
    found = []
    for program in ("trophic-predator-prey", "trophic-worlds"):
        text = campaign.ok(campaign.program(program), "--help", cwd=folder)
        names = re.search(r"rule table: (.*) \(\w+\)$", text, re.M)[1]
        for table in re.split(r", | or ", names):
            probe = [
                campaign.program(program),
                "--rules",
                table,
                "--backend",
                "kinematic",
                "--duration",
                1,
                "--out",
                f"probe-{table}",
            ]
            refusal = re.search(r"must be on (\w+)", campaign.call(*probe, cwd=folder).stderr.decode())
            found.append((campaign.program(program), table, refusal[1] if refusal else "kinematic"))
    return found


def made(out):
    """The tables and recordings in a folder of runs."""
    return {
        str(path.relative_to(out)): path.read_bytes()
        for path in sorted(out.rglob("*"))
        if path.suffix in (".csv", ".trp") and ".incomplete" not in str(path)
    }


def kills(campaign, folder, cases):
    draw, tables, killed = campaign.draw, tables_of(campaign, folder), 0
    for case in range(cases):
        program, table, backend = draw.choice(tables)
        work = folder / f"kill-{case}"
        work.mkdir()
        duration = draw.randrange(200, 1500) if table in ("paper", "released") else draw.randrange(20, 80)
        command = [
            program,
            "--rules",
            table,
            "--backend",
            backend,
            "--duration",
            duration,
            "--seed",
            draw.randrange(10**6),
        ]
        command += ["--checkpoint-s", draw.choice((2, 4, 20, 50))]
        for option in ("--senses", "--states"):
            command += [option] if draw.random() < 0.3 else []
        command += ["--agents-every", draw.choice((1, 7))]
        kind = draw.choice(("run", "run", "set", "plan"))
        if kind == "set":
            command += [
                "--replicates",
                2,
                "--jobs",
                draw.choice((1, 2)),
                *draw.choice(((), ("--shadow",), ("--one-sided",), ("--neutral",))),
            ]
        command += ["--out", "out"]
        whole = ["--out", "whole"]
        if kind == "plan":
            (work / "sweep.toml").write_text(
                f'rule_table = "{table}"\nengine = "{backend}"\nreplicates = 2\nseed = {draw.randrange(10**6)}\n'
                f"[set]\necology.duration_s = {duration}.0\n[grid]\necology.idle_control_steps = [0, 1]\n"
            )
            for out in ("whole", "out"):
                campaign.ok(
                    campaign.program("trophic"), "plan", "sweep.toml", "--program", program, "--out", out, cwd=work
                )
            command = [program, "--plan", "out/plan.jsonl", "--jobs", draw.choice((1, 2))]
        command = [str(word) for word in command]
        began = time.monotonic()
        done = campaign.call(
            *(
                [word.replace("out/plan", "whole/plan") for word in command]
                if kind == "plan"
                else [*command[:-2], *whole]
            ),
            cwd=work,
        )
        wall_s = time.monotonic() - began
        if done.returncode != 0:
            if kind == "set":  # a null that this table lacks
                shutil.rmtree(work)
                continue
            campaign.find("the run itself fails", command, done.stderr.decode())
            continue

        def resumed():
            return [*command, *(["--resume"] if kind != "plan" and (work / "out").exists() else [])]

        for _ in range(draw.choice((1, 1, 2, 4))):
            running = subprocess.Popen(
                resumed(), cwd=work, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=campaign.environment
            )
            try:
                _, errors = running.communicate(timeout=draw.uniform(0.0, 1.1 * wall_s))
                if running.returncode != 0:
                    campaign.find("does not resume", resumed(), errors.decode())
                break
            except subprocess.TimeoutExpired:
                number = draw.choice((signal.SIGKILL,) * 4 + (signal.SIGTERM, signal.SIGINT, signal.SIGHUP))
                running.send_signal(number)
                _, errors = running.communicate(timeout=120)
                killed += 1
                if (
                    number != signal.SIGKILL
                    and running.returncode not in (0, 3, -number)
                    or b"terminate called" in errors
                ):
                    campaign.find(f"exit {running.returncode} after signal {number}", command, errors.decode())
        complete = resumed()
        done = campaign.call(*complete, cwd=work)
        if done.returncode != 0:
            campaign.find("does not resume", complete, done.stderr.decode())
        elif made(work / "out") != made(work / "whole"):
            one, two = made(work / "out"), made(work / "whole")
            campaign.find(
                "other bytes", complete, [name for name in one.keys() | two.keys() if one.get(name) != two.get(name)]
            )
        else:
            shutil.rmtree(work)
    return f"{cases} runs, sets and plans, {killed} kills and signals"


# Damages


VALUES = [
    None,
    True,
    -1,
    0,
    1e300,
    1e-300,
    "nan",
    "",
    [],
    {},
    "x",
    "<evil>",
    "\x1b[2J",
    [1],
    {"a": 1},
    2**64,
    -(2**63),
    [[]],
    [None],
    "../../etc/passwd",
    "a" * 5000,
    0.5,
    "1",
]
CELLS = [
    "",
    "nan",
    "inf",
    "-1",
    "1e300",
    "1e61",
    "-0",
    "0x10",
    "99999999999999999999",
    '"',
    "<evil>",
    "a" * 3000,
    "\x1b[2J",
    "1.5",
    "=1+1",
    "prey",
    "\xff",
    "[]",
    "[1,2]",
    "none",
]


def damaged_json(draw, value):
    node = value
    while node:
        keys = list(node) if isinstance(node, dict) else range(len(node))
        key = draw.choice(list(keys))
        if isinstance(node[key], (dict, list)) and node[key] and draw.random() < 0.8:
            node = node[key]
        elif isinstance(node, dict) and draw.random() < 0.25:
            node.pop(key)
            return
        elif isinstance(node, dict) and draw.random() < 0.1:
            node["<evil>"] = node.pop(key)
            return
        else:
            node[key] = draw.choice(VALUES)
            return


def damaged_bytes(draw, content, others):
    at, end = sorted(draw.randrange(len(content) + 1) for _ in range(2))
    kind = draw.randrange(8)
    if kind == 0:
        return content[:at]
    if kind == 1:
        return content[:at] + content[at + (end - at) // 50 :]
    if kind == 2:
        return content[:at] + bytes(draw.randrange(256) for _ in range(draw.randrange(1, 64))) + content[at:]
    if kind == 3:
        return content[:at] + bytes(64) + content[at + 64 :]
    if kind == 4:
        return draw.choice(others)
    if kind == 5:
        return content + content[at:end][:2000]
    if kind == 6:
        return b""
    changed = bytearray(content)
    for _ in range(draw.choice((1, 1, 3, 30))):
        if changed:
            changed[draw.randrange(len(changed))] ^= 1 << draw.randrange(8)
    return bytes(changed)


def damaged_table(draw, content):
    """A table whose lines are still lines: a cell, a row or a column is another."""
    lines = content.decode(errors="replace").split("\n")
    row = draw.randrange(max(1, len(lines) - 1)) if draw.random() < 0.85 else 0
    cells = lines[row].split(",")
    cells[draw.randrange(len(cells))] = draw.choice(CELLS)
    kind = draw.randrange(6)
    if kind < 4:
        lines[row] = ",".join(cells)
    elif kind == 4:
        lines.insert(row, lines[draw.randrange(len(lines))])
    else:
        del lines[row]
    return "\n".join(lines).encode("utf-8", "replace")


def reseal(draw, run, table):
    """Gives the manifest next to a table the table's checksum and rows."""
    path = run / "manifest.json"
    manifest = json.loads(path.read_text())
    content = table.read_bytes()
    if table.name in manifest.get("tables", {}):
        manifest["tables"][table.name]["crc32"] = zlib.crc32(content)
        manifest["tables"][table.name]["rows"] = content.count(b"\n") - 1
    elif table.suffix == ".trp" and "recording" in manifest:
        manifest["recording"]["crc32"] = zlib.crc32(content)
    path.write_text(sealed_text(manifest))


def prepared(campaign, folder):
    """Runs, sets, a sweep and results, and the commands that read each."""
    trophic, paper, worlds = (campaign.program(name) for name in ("trophic", "trophic-predator-prey", "trophic-worlds"))
    every = ("--senses", "--states")
    campaign.ok(paper, *QUICK, "--duration", 100, *every, "--out", "run", cwd=folder)
    campaign.ok(worlds, "--backend", "kinematic", "--duration", 60, *every, "--out", "pond", cwd=folder)
    campaign.ok(worlds, "--rules", "wolf_sheep", "--duration", 12, "--out", "wolves", cwd=folder)
    campaign.ok(
        paper,
        *QUICK,
        "--duration",
        100,
        "--replicates",
        2,
        "--shadow",
        "--one-sided",
        "--neutral",
        "--out",
        "set",
        cwd=folder,
    )
    campaign.ok(
        paper, *QUICK[2:], "--backend", "torus", "--duration", 100, "--replicates", 2, "--out", "torus", cwd=folder
    )
    (folder / "sweep.toml").write_text(
        'engine = "kinematic"\nreplicates = 2\nshadow = true\n[set]\necology.robots = 16\nrules.community.predators = 8\necology.duration_s = 60.0\n'
        "[grid]\nrules.mutation.sd = [0.05, 0.1]\n"
    )
    campaign.ok(trophic, "plan", "sweep.toml", "--program", paper, "--out", "sweep", cwd=folder)
    campaign.ok(paper, "--plan", "sweep/plan.jsonl", cwd=folder)
    campaign.ok(trophic, "analyze", "set", "--out", "analysis", cwd=folder)
    campaign.ok(trophic, "analyze", "sweep", "--out", "of_sweep", cwd=folder)
    campaign.ok(
        trophic,
        "contest",
        "set",
        "--duration",
        10,
        "--teams",
        2,
        "--team-size",
        2,
        "--epochs",
        "0,50",
        "--out",
        "contests",
        cwd=folder,
    )
    campaign.ok(trophic, "cross-check", "set", "torus", "--out", "engines", cwd=folder)
    campaign.ok(trophic, "plot", "analysis", "--out", "figures", cwd=folder)
    one = lambda name: [
        [trophic, "cite", name],
        [trophic, "analyze", name, "--all", "--out", "new"],
        [trophic, "analyze", name, "--html", "new.html"],
        [trophic, "analyze", name, "--lineages", "--out", "new"],
        [trophic, "analyze", name, "--selection", "turns_to", "--out", "new"],
        [trophic, "analyze", name, "--bodies", "--out", "new"],
    ]
    alone = lambda name: [
        *one(name),
        *([[trophic, "show", name, "--out", "new.html"]] * 3),
        *([[trophic, "export", name, "--out", "new.glb"]] * 2),
        *([[trophic, "film", name, "--size", "160x90", "--out", "new.png"]] * 2),
    ]
    return {
        "run": [*alone("run"), [paper, "--from", "run", "--at", 50, "--seed", 3, "--duration", 60, "--out", "new"], *([[paper, *QUICK, "--duration", 120, "--resume", "--out", "run"]] * 2)],
        "pond": [*alone("pond"), [worlds, "--backend", "kinematic", "--duration", 70, "--resume", "--out", "pond"], [trophic, "analyze", "pond", "--selection", "trait:0", "--out", "new"]],
        "wolves": [*alone("wolves"), [worlds, "--rules", "wolf_sheep", "--duration", 14, "--resume", "--out", "wolves"]],
        "set": [*one("set"), [trophic, "show", "set", "--out", "new.html"], [trophic, "contest", "set", "--duration", 10, "--teams", 2, "--out", "new"], [trophic, "analyze", "--compare", "set", "sweep/cell-000", "--out", "new"], [trophic, "analyze", "set", "--published", "--out", "new"], [trophic, "cross-check", "set", "torus", "--out", "new"], [paper, *QUICK, "--duration", 100, "--replicates", 3, "--resume", "--out", "set"]],
        "sweep": [[trophic, "analyze", "sweep", "--out", "new"], [trophic, "analyze", "sweep", "--allow-missing", "--out", "new"], [paper, "--plan", "sweep/plan.jsonl"], [paper, "--plan", "sweep/plan.jsonl", "--status"], [paper, "--plan", "sweep/plan.jsonl", "--describe"], [trophic, "plan", "sweep/sweep.toml", "--program", paper, "--out", "sweep"], [trophic, "analyze", "sweep/cell-000", "--out", "new"]],
        "analysis": [[trophic, "plot", "analysis", "--out", "new"]],
        "of_sweep": [[trophic, "plot", "of_sweep", "--out", "new"]],
        "contests": [[trophic, "plot", "contests", "--out", "new"]],
        "engines": [[trophic, "plot", "engines", "--out", "new"]],
        "figures": [[trophic, "analyze", "set", "--html", "new.html", "--figures", "figures", "--out", "new"]],
    }  # fmt: skip


def damages(campaign, folder, cases):
    draw = campaign.draw
    master = folder / "master"
    master.mkdir()
    commands = prepared(campaign, master)
    contents = [
        path.read_bytes() for path in sorted(master.rglob("*")) if path.is_file() and path.stat().st_size < 10**6
    ]
    tried, sealed = 0, 0
    weights = {"run": 18, "pond": 18, "wolves": 6, "set": 15, "sweep": 15}  # figures take seconds
    for case in range(cases):
        work = folder / "work"
        name = draw.choices(list(commands), [weights.get(one, 1) for one in commands])[0]
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir()
        for other in master.iterdir():  # only what is damaged is copied
            (work / other.name).symlink_to(other) if other.name != name else shutil.copytree(other, work / name)
        path = draw.choice(
            [
                path
                for path in sorted((work / name).rglob("*"))
                if path.is_file() and path.suffix not in (".png", ".pdf")
            ]
        )
        manifest = path.parent / "manifest.json"
        content = path.read_bytes()
        kind = draw.random()
        if path.suffix == ".json" and kind < 0.6:
            try:
                value = json.loads(content)
            except ValueError:
                continue
            damaged_json(draw, value)
            path.write_text(sealed_text(value) if "crc32" in value else json.dumps(value))
            sealed += 1
        elif path.suffix == ".csv" and kind < 0.7:
            path.write_bytes(damaged_table(draw, content))
            if manifest.exists():
                reseal(draw, path.parent, path)
                sealed += 1
        elif path.suffix == ".jsonl" and kind < 0.6:
            lines = content.decode().splitlines()
            at = draw.randrange(len(lines))
            value = json.loads(lines[at])
            damaged_json(draw, value)
            lines[at] = json.dumps(value)
            path.write_text("\n".join(lines) + "\n")
        elif kind < 0.75:
            path.unlink()
            if draw.random() < 0.3:
                path.mkdir()
        else:
            path.write_bytes(damaged_bytes(draw, content, contents))
            if path.suffix == ".trp" and draw.random() < 0.5:
                reseal(draw, path.parent, path)
                sealed += 1
        for words in draw.sample(commands[name], min(2, len(commands[name]))):
            tried += 1
            found = len(campaign.found)
            campaign.judged(*words, cwd=work)
            if len(campaign.found) > found:
                kept = folder / f"found-{case}"
                if not kept.exists():
                    shutil.copytree(work / name, kept / name)
                print(f"  case {case}: {path.relative_to(work)}, kept in {kept}", flush=True)
            for left in work.glob("new*"):
                shutil.rmtree(left) if left.is_dir() else left.unlink()
    return f"{cases} damages, {sealed} of them with checksums that fit, {tried} commands"


# Options


WORDS = ["", "-1", "0", "1", "2", "7", "-0", "0.5", "1e3", "nan", "inf", "-inf", "1e999", "1e-300", "18446744073709551616", "9223372036854775807", "4294967296", "0x10", "010", "+5", " 5", "5 ", "1,5", "1_000",
         "٣", "--", "-", "a", "a\nb", "\x01", "\x1b[2J", "é", "\udcff", "a" * 5000, "/", ".", "..", "/dev/null", "/dev/full", "no/such", "run", "set", "new", "new.html", "new.png", "new.toml", "%s%n", "$(touch pwned)", "`id`", "'", '"', "<evil>", "{{7*7}}",
         "paper", "released", "pond", "kinematic", "torus", "mujoco", "ode", "velocity", "velocity:prey", "trait:0", "turns_to", "agents.csv:x_m:m", "others", "serif", "0,40", "plan.jsonl", "run/manifest.json", "run/agents.csv", "*", "~", "true", "None"]  # fmt: skip
BASES = {
    "trophic-predator-prey": [[*QUICK, "--duration", "6"], ["--from", "run", "--at", "20", "--duration", "26", "--seed", "9"], []],
    "trophic-worlds": [["--backend", "kinematic", "--duration", "4"], ["--rules", "wolf_sheep", "--duration", "3"], []],
    "show": [["run"], []],
    "film": [["run", "--size", "160x90", "--out", "new.png"], []],
    "export": [["run", "--out", "new.glb"], []],
    "evolve-gait": [["--generations", "1", "--backend", "kinematic", "--set", "plan.population=4", "--set", "plan.parents=2", "--set", "plan.children=2"]],
    "measure-gait": [["--duration", "5.1"]],
    "convert": [["body.txt", "--out", "new.toml"], []],
    "analyze": [["run"], ["set"], ["--compare", "run", "set"], []],
    "cite": [["run"], ["set"], []],
    "contest": [["set", "--epochs", "0,20", "--duration", "4", "--teams", "2", "--team-size", "2"]],
    "cross-check": [["set", "run"], []],
    "help": [["slots"], []],
    "plan": [["sweep.toml", "--program", "trophic-predator-prey"], []],
    "plot": [["analysis"], []],
}  # fmt: skip
LONG = (
    "--duration",
    "--replicates",
    "--robots",
    "--generations",
    "--live",
    "--jobs",
)  # of work that is asked for, or that waits for a page
IN_PYTHON = ("analyze", "cite", "contest", "cross-check", "help", "plan", "plot")


def verbs_of(campaign, folder):
    """All commands of trophic, by its own list, but for the experiment programs."""
    text = campaign.ok(campaign.program("trophic"), "--help", cwd=folder)
    own = re.findall(r"^  ([a-z][a-z-]+)  ", text.split("\nCommands:\n")[1], re.M)
    other = re.search(r"^Further commands, each with its own --help: (.*)$", text, re.M)[1].split(", ")
    return [verb for verb in [*own, *other] if not (campaign.bin / f"trophic-{verb}").exists() or verb in IN_PYTHON]


def options(campaign, folder, cases):
    draw = campaign.draw
    trophic, paper = campaign.program("trophic"), campaign.program("trophic-predator-prey")
    work = folder / "work"
    work.mkdir()
    campaign.ok(paper, *QUICK, "--duration", 40, "--out", "run", cwd=work)
    campaign.ok(paper, *QUICK, "--duration", 40, "--replicates", 2, "--out", "set", cwd=work)
    campaign.ok(trophic, "analyze", "set", "--out", "analysis", cwd=work)
    (work / "body.txt").write_text("0 CoreComponent Core 0\n\t0 ActiveHinge Hip 1\n")
    (work / "sweep.toml").write_text(
        'engine = "kinematic"\nreplicates = 1\n[set]\necology.duration_s = 4.0\n[grid]\nrules.mutation.sd = [0.05]\n'
    )
    verbs = verbs_of(campaign, work)
    assert set(verbs) <= set(BASES), f"no base for {set(verbs) - set(BASES)}"
    listed, numbers = {}, {}
    for name in BASES:
        program = [campaign.program(name)] if name.startswith("trophic-") else [trophic, name]
        text = campaign.ok(*program, "--help", cwd=work)
        listed[name] = re.findall(r"^  (?:-\w, ?)?(--[a-z-]+)(?: (N|X|TEXT)\b)?", text, re.M)
    for name, rules in (("trophic-predator-prey", "paper"), ("trophic-worlds", "pond")):
        config = campaign.ok(
            campaign.program(name), "--rules", rules, "--backend", "kinematic", "--print-config", cwd=work
        )
        section, numbers[name] = "", []
        for line in config.splitlines():
            if found := re.match(r"\[(.+)\]", line):
                section = found[1] + "."
            elif found := re.match(r"(\w+) = (.*)", line):
                numbers[name].append((section + found[1], found[2].split(" #")[0].strip()))
    whole = files_in(work)
    tried = 0
    while tried < cases:
        # the programs in Python take ten times as long
        name = draw.choices(
            list(BASES),
            [
                0.12 if name in IN_PYTHON and name != "help" else 6 if name.startswith("trophic-") else 1
                for name in BASES
            ],
        )[0]
        program = [campaign.program(name)] if name.startswith("trophic-") else [trophic, name]
        words = list(draw.choice(BASES[name]))
        asks = False
        for _ in range(draw.choice((1, 1, 2, 3))):
            if name in numbers and draw.random() < 0.35:
                path, value = draw.choice(numbers[name])
                value = draw.choice((value, draw.choice(WORDS), f"{value}0", f"-{value}", f"{value}e2"))
                words += ["--set", f"{path}={value}"]
                continue
            option, kind = draw.choice(listed[name])
            if option == "--live":
                continue
            asks = asks or option in LONG
            if kind:
                value = draw.choice(WORDS)
                if option in (
                    "--duration",
                    "--replicates",
                    "--robots",
                    "--generations",
                    "--jobs",
                    "--threads",
                ) and re.fullmatch(r"\d{3,}|1e3", value):
                    value = "3"
                words += [option, value] if draw.random() < 0.8 else [f"{option}={value}"]
            else:
                words += [option] + ([draw.choice(WORDS)] if draw.random() < 0.15 else [])
        if name.startswith("trophic-"):  # a table's own engine and length are minutes
            words += [] if "--duration" in words or "--plan" in words else ["--duration", "2"]
            words += [] if "--backend" in words or "--from" in words else ["--backend", "kinematic"]
            words += ["--robots", "4"] if {"mujoco", "ode"} & set(words) else []
        if draw.random() < 0.05:
            words += [draw.choice(WORDS)]
        tried += 1
        campaign.judged(*program, *words, cwd=work, stopped=True)
        for path in sorted(files_in(work) - whole, reverse=True):
            at = work / path
            at.rmdir() if at.is_dir() and not at.is_symlink() else at.unlink()
        lost = whole - files_in(work)
        if lost:
            campaign.find("removes files of the user's", words, lost)
            break
    return f"{tried} commands with random options"


# Texts


TEXTS = ["<evil>", '"><evil onload=x>', "</script><evil>", "--><evil>", "{{7*7}}{% raw %}", "${7*7}", "a,b", 'a"b', "a'b", "a\nb", "a\r\nb", "\x1b[2J", "\u202eevil", "\u2028", "$(touch pwned)", "`touch pwned`", "; touch pwned", "| touch pwned",
         "=cmd|' /C calc'!A0", "\\input{/etc/passwd}", "100%_&#^~\\", "a" * 200, "é ü", "\udcff", "-rf", "--help", "%s%n%x", "%(prog)s", "nul", "a:b", "a=b", "a#b", "[a]", "*", " ", "a ", "~", "a\tb", "https://evil/", "javascript:evil()", "0", "nan", "true"]  # fmt: skip


def texts(campaign, folder, cases):
    draw = campaign.draw
    trophic, paper, worlds = (campaign.program(name) for name in ("trophic", "trophic-predator-prey", "trophic-worlds"))
    spider = campaign.bin.parent / "share/trophic/models/robots/spider.toml"
    base = folder / "base"
    base.mkdir()
    campaign.ok(paper, *QUICK, "--duration", 60, "--replicates", 2, "--shadow", "--out", "set", cwd=base)
    tried = 0

    def toml(text):
        return json.dumps(text, ensure_ascii=True).replace("\\udcff", "?")

    def in_folder(text, work):
        name = work / text
        shutil.copytree(base / "set", name)
        return [
            [trophic, "analyze", f"./{text}", "--all", "--out", "new"],
            [trophic, "analyze", f"./{text}", "--html", "new.html"],
            [trophic, "cite", f"./{text}"],
            [trophic, "show", f"./{text}/replicate-00", "--out", "new.html"],
            [
                trophic,
                "contest",
                f"./{text}",
                "--duration",
                4,
                "--teams",
                2,
                "--team-size",
                2,
                "--epochs",
                "0,30",
                "--out",
                "new",
            ],
            [trophic, "cross-check", f"./{text}", base / "set", "--out", "new"],
            [trophic, "analyze", "--compare", f"./{text}", base / "set", "--out", "new"],
            [paper, *QUICK, "--duration", 60, "--replicates", 3, "--shadow", "--out", f"./{text}", "--resume"],
            [paper, "--from", f"./{text}/replicate-00", "--at", 30, "--seed", 4, "--duration", 40, "--out", "new"],
            [trophic, "export", f"./{text}/replicate-00", "--out", "new.glb"],
            [trophic, "film", f"./{text}/replicate-00", "--size", "160x90", "--out", "new.png"],
        ]

    def as_out(text, work):
        return [
            [paper, *QUICK, "--duration", 20, "--out", f"./{text}"],
            [paper, *QUICK, "--duration", 20, "--replicates", 2, "--out", f"./{text}/x"],
            [trophic, "analyze", base / "set", "--out", f"./{text}"],
            [trophic, "show", base / "set/replicate-00", "--out", f"./{text}.html"],
            [trophic, "analyze", base / "set", "--html", f"./{text}.html"],
        ]

    def made_and_read(*options):
        return [
            [paper, *QUICK, "--duration", 20, *options, "--out", "run"],
            [trophic, "cite", "run"],
            [trophic, "show", "run", "--out", "new.html"],
            [trophic, "analyze", "run", "--html", "new.html"],
        ]

    def as_robot(text, work):
        (work / "robot.toml").write_text(
            re.sub(r"^name = .*$", lambda _: f"name = {toml(text)}", spider.read_text(), flags=re.M)
        )
        return made_and_read("--robot", "./robot.toml")

    def as_arena(text, work):
        (work / "arena.toml").write_text(f"name = {toml(text)}\nhalf_side_m = 20\n[[zone]]\nname = {toml(text)}\n")
        return made_and_read("--set", "ecology.arena=./arena.toml")

    def as_column(text, work):
        shutil.copytree(base / "set", work / "set")
        cell = '"' + text.replace('"', '""') + '"'
        for run in (work / "set").rglob("replicate-*"):
            (run / "own.csv").write_text(
                f"time_s,{cell},species\n0,1.5,prey\n4,2.5,{cell}\n", encoding="utf-8", errors="surrogateescape"
            )
        return [
            [trophic, "analyze", "set", "--column", f"own.csv:{text}", "--out", "new"],
            [trophic, "analyze", "set", "--column", f"own.csv:{text}:{text}", "--html", "new.html"],
            [trophic, "analyze", "set", "--column", f"{text}.csv:x", "--out", "new"],
        ]

    def as_metric(text, work):
        shutil.copytree(base / "set", work / "set")
        (work / "mine.py").write_text(
            f"import trophic\n@trophic.metric(name={text!r}, unit={text!r})\ndef mine(run):\n    return float(len(run.events))\n",
            encoding="utf-8",
            errors="backslashreplace",
        )
        return [
            [trophic, "analyze", "set", "--metric-file", "mine.py", "--all", "--out", "analysis"],
            [trophic, "analyze", "set", "--metric-file", "mine.py", "--html", "new.html"],
            [trophic, "plot", "analysis", "--out", "new"],
        ]

    def as_sweep(text, work):
        (work / "robot.toml").write_text(spider.read_text())
        shutil.copy(work / "robot.toml", work / "other.toml")
        (work / "sweep.toml").write_text(
            f'engine = "kinematic"\nreplicates = 1\nname = {toml(text)}\n[set]\necology.duration_s = 8.0\n[grid]\necology.robot = ["./robot.toml", {toml(text)}]\n'
        )
        (work / "other.sweep.toml").write_text(
            f'engine = "kinematic"\nreplicates = 1\n[set]\necology.duration_s = 8.0\n[[runs]]\nname = {toml(text)}\nrules.mutation.sd = 0.1\n[grid]\n{toml(text)} = [1]\n'
        )
        return [
            [trophic, "plan", f"{name}sweep.toml", "--program", paper, "--out", f"sweep{name}"]
            for name in ("", "other.")
        ]

    def in_manifest(text, work):
        shutil.copytree(base / "set", work / "set")
        path = work / "set/replicate-00/manifest.json"
        manifest = json.loads(path.read_text())
        for key in draw.sample(
            [
                "rule_table",
                "backend",
                "host",
                "command_line",
                "compiler",
                "trophic_revision",
                "source_revision",
                "build",
            ],
            2,
        ):
            manifest[key] = text
        manifest["description"]["sentence"] = manifest["description"]["name"] = text
        manifest["species"][0] = text
        path.write_text(sealed_text(manifest), errors="surrogateescape")
        return [
            [trophic, "analyze", "set/replicate-00", "--all", "--out", "new"],
            [trophic, "analyze", "set/replicate-00", "--html", "new.html"],
            [trophic, "cite", "set/replicate-00"],
            [trophic, "show", "set/replicate-00", "--out", "new.html"],
        ]

    def as_caption(text, work):
        if not (base / "figures").exists():
            campaign.ok(trophic, "analyze", "set", "--out", "analysis", cwd=base)
            campaign.ok(trophic, "plot", "analysis", "--out", "figures", cwd=base)
        shutil.copytree(base / "figures", work / "figures")
        captions = json.loads((work / "figures/captions.json").read_text())
        for value in captions if isinstance(captions, list) else captions.values():
            for key in value if isinstance(value, dict) else ():
                if isinstance(value[key], str) and draw.random() < 0.5:
                    value[key] = text
        (work / "figures/captions.json").write_text(json.dumps(captions))
        return [[trophic, "analyze", base / "set", "--html", "new.html", "--figures", "figures"]]

    def as_body(text, work):
        (work / "body.txt").write_text(f"0 CoreComponent Core 0\n\t0 ActiveHinge {text} 1\n", errors="surrogateescape")
        return [
            [trophic, "convert", "body.txt", "--out", "new.toml", "--name", text],
            [trophic, "convert", "body.txt", "--out", "new.toml"],
        ]

    places = (in_folder, as_out, as_robot, as_arena, as_column, as_metric, as_sweep, in_manifest, as_caption, as_body)
    pairs = [(text, place) for text in TEXTS for place in places if place not in (in_folder, as_out) or "/" not in text]
    draw.shuffle(pairs)
    used = set()
    while tried < cases and pairs:
        text, place = pairs.pop()
        used.add(text)
        work = folder / "work"
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir()
        commands = place(text, work)
        for words in draw.sample(commands, min(3, len(commands))) if place in (in_folder, as_out) else commands:
            tried += 1
            campaign.judged(*words, cwd=work)
            if any(folder.rglob("pwned")):
                campaign.find("a text is a command", words)
            for table in work.glob("new/*.tex"):
                if "\\input{/etc" in table.read_text(errors="replace"):
                    campaign.find("LaTeX of the user's", words, table)
            for left in work.glob("new*"):
                shutil.rmtree(left) if left.is_dir() else left.unlink()
    return f"{tried} commands on {len(used)} hostile texts in {len(places)} places"


# Live


def live(campaign, folder, cases):
    draw = campaign.draw
    tried = 0
    for number in range((cases + 39) // 40):
        work = folder / f"live-{number}"
        work.mkdir()
        command = [
            campaign.program("trophic-predator-prey"),
            *QUICK,
            "--seed",
            str(draw.randrange(1000)),
            "--duration",
            "60",
        ]
        with LiveRun([*command, "--out", "run"], work) as run:
            with run.page() as page:
                page.send({"do": "pause"})
                page.until(lambda message: message["kind"] == "state" and message["paused"])
                for _ in range(min(40, cases - tried)):
                    tried += 1
                    attack(campaign, run, page)
                    if run.process.poll() is not None:
                        campaign.find("the run ended", run.process.communicate()[1])
                        return f"{tried} attacks"
                if run.get(f"/?token={run.token}")[0] != 200:
                    campaign.find("the page is not shown any more")
                page.send({"do": "speed", "value": 0})
                page.send({"do": "play"})
                page.until(lambda message: message["kind"] == "state" and message["over"])
            code, errors = run.wait()
            if code != 0 or RAW.search(errors):
                campaign.find(f"exit {code}", errors)
        changed = (work / "run/changes.csv").read_text()
        if changed != "time_s,tick,number,value,before\n":
            campaign.find("an attack changed the run", changed)
        campaign.ok(*command, "--out", "alone", cwd=work)
        ours, alone = made(work / "run"), made(work / "alone")
        ours.pop("changes.csv")
        if ours != alone:
            campaign.find("other bytes", command)
    return f"{tried} attacks on live pages"


def attack(campaign, run, page):
    draw = campaign.draw
    host, token = f"127.0.0.1:{run.port}", run.token
    wrong_host = draw.choice(
        [
            "evil.example",
            f"evil.example:{run.port}",
            "127.0.0.1.evil.example",
            f"127.0.0.1:{run.port}@evil",
            "",
            "[::1]evil",
            "localhost:x",
            "0",
            "127.0.0.1\t",
            f"127.0.0.2:{run.port}",
        ]
    )
    wrong_token = draw.choice(
        [
            "",
            "0" * 32,
            token[:-1],
            token + "0",
            token.upper() if token.upper() != token else "x",
            token[::-1],
            "%00",
            "a" * 9000,
            f"{token}&x",
        ]
    )
    kind = draw.randrange(12)
    refused = None
    if kind == 0:
        status, body = run.ask(bytes(draw.randrange(256) for _ in range(draw.randrange(1, 3000))) + b"\r\n\r\n")
        refused = status in (None, 400, 403, 404, 405)
    elif kind == 1:
        method = draw.choice(["POST", "PUT", "DELETE", "OPTIONS", "HEAD", "CONNECT", "TRACE", "PATCH", "EVIL"])
        status, body = run.ask(
            f"{method} /?token={token} HTTP/1.1\r\nHost: {host}\r\nContent-Length: 0\r\n\r\n".encode()
        )
        refused = status in (None, 400, 405)
    elif kind == 2:
        status, body = run.ask(f"GET /?token={token} HTTP/1.1\r\nHost: {wrong_host}\r\n\r\n".encode())
        refused = status in (None, 400, 403)
    elif kind == 3:
        status, body = run.get(f"/?token={wrong_token}", host=host)
        refused = status in (None, 400, 403)
    elif kind == 4:
        path = draw.choice(
            [
                "/../../etc/passwd",
                "/%2e%2e/",
                "//evil",
                "/live",
                "/run/manifest.json",
                "*",
                "http://evil/",
                "/\x00",
                "/;",
                "/?",
                "/??token=",
            ]
        )
        status, body = run.get(f"{path}?token={token}", host=host)
        refused = status in (None, 400, 403, 404)
    elif kind == 5:
        wrong = draw.choice(
            [
                {"origin": "http://evil.example"},
                {"origin": "null"},
                {"origin": f"https://{host}"},
                {"origin": f"http://{host}.evil"},
                {"token": wrong_token},
                {"host": "evil.example"},
                {"origin": f"http://localhost:{run.port}"},
            ]
        )
        try:
            with run.page(**wrong) as other:
                refused, body = other.status == 403, ""
        except (EOFError, ConnectionError):
            refused, body = True, ""
    elif kind in (6, 7, 8):  # wishes of the page itself
        wishes = ["", "{", "[]", "null", "1", '"x"', "{}", '{"do": null}', '{"do": {}}', '{"do": "set"}', '{"do": "set", "number": 1, "value": 1}', '{"do": "set", "number": "rules.capture.reach_m", "value": "<evil>"}',
                  '{"do": "set", "number": "ecology.duration_s", "value": "1"}', '{"do": "set", "number": "rules.capture.reach_m", "value": "1e999"}', '{"do": "set", "number": "__proto__", "value": "1"}', '{"do": "speed", "value": -1}',
                  '{"do": "speed", "value": 1e999}', '{"do": "speed", "value": null}', '{"do": "restart"}', '{"do": "restart", "seed": -1, "rules": "paper"}', '{"do": "restart", "seed": 1, "rules": "../x"}', '{"do": "restart", "seed": 1e30, "rules": "paper"}',
                  "[" * 2000, '{"a":' * 500, "\x00", '{"do": "\\ud800"}', '{"do": "set", "number": "rules.mutation.sd\\n", "value": "1"}', '{"do": "set", "number": "seed", "value": "1"}', '{"do": "set", "number": "rules.mutation.sd", "value": "0.1 # x"}',
                  '{"do": "set", "number": "rules.mutation.sd", "value": "[1]"}', '{"do": "exec", "value": "id"}', '{"do": "set", "number": "' + "a." * 300 + '", "value": "1"}']  # fmt: skip
        wish = draw.choice(wishes)
        page.send(wish)
        message = page.until_kind("refused")
        refused, body = (
            len(message["text"].splitlines()) == 1
            and not CONTROL.search(message["text"])
            and "json.exception" not in message["text"],
            message["text"],
        )
    elif kind == 9:  # a second page, which may not steer
        with run.page() as other:
            other.send(
                draw.choice(
                    [
                        '{"do": "play"}',
                        '{"do": "set", "number": "rules.mutation.sd", "value": "0.7"}',
                        '{"do": "restart", "seed": 1, "rules": "paper"}',
                    ]
                )
            )
            body = other.until_kind("refused")["text"]
            refused = "Another page steers" in body
    elif kind == 10:  # broken frames of a second page
        with run.page() as other:
            other.socket.sendall(
                draw.choice(
                    [
                        b"\x81\x05hello",
                        b"\x81\xff" + b"\xff" * 8,
                        b"\xf1\x80abcd",
                        b"\x83\x80abcd",
                        bytes(draw.randrange(256) for _ in range(200)),
                        b"\x88\x81abcd\x00",
                        b"\x01\x80abcd" * 50,
                    ]
                )
            )
        refused, body = True, ""
    else:  # half of a request, or many headers
        import socket

        with socket.create_connection(("127.0.0.1", run.port), timeout=20) as connection:
            connection.sendall(
                draw.choice(
                    [
                        b"GET / HT",
                        b"GET /?token="
                        + token.encode()
                        + b" HTTP/1.1\r\nHost: "
                        + host.encode()
                        + b"\r\n"
                        + b"A: b\r\n" * draw.choice((1, 5000)),
                        b"\x16\x03\x01\x02\x00\x01",
                    ]
                )
            )
        refused, body = True, ""
    if not refused:
        campaign.find(f"attack {kind} is not refused", body)
    if token in body and kind != 0:
        campaign.find("the token is told", kind, body)


PARTS = {"kills": kills, "damages": damages, "options": options, "texts": texts, "live": live}


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("bin")
    parser.add_argument("parts", nargs="+", choices=list(PARTS))
    parser.add_argument("--cases", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", help="folder for what was found")
    asked = parser.parse_args()
    wrong = 0
    for part in asked.parts:
        campaign = Campaign(asked.bin, f"{part} {asked.seed}")
        folder = pathlib.Path(asked.keep or tempfile.mkdtemp()) / part
        folder.mkdir(parents=True)
        try:
            what = PARTS[part](campaign, folder, asked.cases)
        finally:
            if not asked.keep:
                shutil.rmtree(folder.parent, ignore_errors=True)
        ends = ", ".join(f"{number} with code {code}" for code, number in sorted(campaign.ends.items()))
        print(f"{part}: {what}; {ends or 'all compared'}; {len(campaign.found)} found", flush=True)
        wrong += len(campaign.found)
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
