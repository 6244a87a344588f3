#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""live_cost.py [--rounds N] [--instructions] PROGRAM OPTIONS...: what --live with an open page costs a run, relative to the same run without.

Both run as fast as they can, in turn, so that a busy machine slows both. The run's own thread and the server's are reported apart.
Processor time: the ratio of the least times is least disturbed by other programs. --instructions counts by callgrind instead; it is exact, but so
slow that every tick is sent, where a fast run sends one in 4 ms."""

import argparse
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from live_page import LiveRun  # noqa: E402


def thread_s(pid, thread):
    """Processor seconds of a thread."""
    return int(pathlib.Path(f"/proc/{pid}/task/{thread}/schedstat").read_text().split()[0]) * 1e-9


def alone_s(command, folder):
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    assert status == 0
    return usage.ru_utime + usage.ru_stime


def play(page):
    """Lets the run go to its end as fast as it can."""
    page.send({"do": "speed", "value": 0})
    page.until(lambda message: message["kind"] == "state" and message["over"])


def live_s(command, folder):
    """Processor time of the run's thread, and of all others."""
    with LiveRun(command, folder) as run, run.page() as page:
        play(page)
        pid = run.process.pid
        threads = [int(name) for name in os.listdir(f"/proc/{pid}/task")]
        return thread_s(pid, pid), sum(thread_s(pid, one) for one in threads if one != pid)


def counted(folder, name):
    """Instructions of the first thread, and of all others, that callgrind wrote."""
    threads = sorted(pathlib.Path(folder).glob(f"{name}.callgrind-*"))
    counts = [int(re.search(r"^(?:totals|summary): (\d+)", one.read_text(), re.MULTILINE)[1]) for one in threads]
    return counts[0], sum(counts[1:])


def instructions(command, folder):
    """Millions of the run alone, of the run's thread with a page, and of its other threads."""
    tool = ["valgrind", "-q", "--tool=callgrind", "--separate-threads=yes"]
    alone_s([*tool, f"--callgrind-out-file={folder}/alone.callgrind", *command, "alone"], folder)
    with LiveRun([*tool, f"--callgrind-out-file={folder}/live.callgrind", *command, "live"], folder) as run:
        with run.page() as page:
            play(page)
        run.wait()
    alone, _ = counted(folder, "alone")
    own, others = counted(folder, "live")
    return alone / 1e6, own / 1e6, others / 1e6


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--instructions", action="store_true")
    parser.add_argument("options", nargs=argparse.REMAINDER)
    given = parser.parse_args()
    alone, own, others = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        command = [str(given.program.resolve()), *given.options, "--out"]
        if given.instructions:
            without, run, server = instructions(command, folder)
            print(
                f"alone {without:.1f} M instructions, live {run:.1f}, server {server:.1f}; run's thread: x{run / without:.3f}"
            )
            return
        for number in range(given.rounds):
            alone.append(alone_s([*command, f"alone-{number}"], folder))
            run, server = live_s([*command, f"live-{number}"], folder)
            own.append(run)
            others.append(server)
    ratios = [with_page / without for with_page, without in zip(own, alone)]
    print(
        f"alone {min(alone):.2f} s, live {min(own):.2f} s, server {min(others):.2f} s, each the least of {given.rounds} rounds"
    )
    print(
        f"run's thread: x{min(own) / min(alone):.3f}; by rounds x{statistics.median(ratios):.3f}, from {min(ratios):.3f} to {max(ratios):.3f}"
    )


if __name__ == "__main__":
    main()
