#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""live_cost.py [--rounds N] PROGRAM OPTIONS...: processor time of a run with --live and an open page, relative to the same run without.

Both run as fast as they can, in turn, so that a busy machine slows both. The run's own thread and the server's are reported apart."""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from live_page import LiveRun  # noqa: E402

TICK_S = 1 / os.sysconf("SC_CLK_TCK")


def thread_s(pid, thread):
    """Processor seconds of a thread."""
    fields = pathlib.Path(f"/proc/{pid}/task/{thread}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) * TICK_S


def alone_s(command, folder):
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    assert status == 0
    return usage.ru_utime + usage.ru_stime


def live_s(command, folder):
    """Of the run's thread, and of all others."""
    with LiveRun(command, folder) as run, run.page() as page:
        page.send({"do": "speed", "value": 0})
        page.until(lambda message: message["kind"] == "state" and message["over"])
        pid = run.process.pid
        threads = [int(name) for name in os.listdir(f"/proc/{pid}/task")]
        return thread_s(pid, pid), sum(thread_s(pid, one) for one in threads if one != pid)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("options", nargs=argparse.REMAINDER)
    given = parser.parse_args()
    alone, own, others = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        for number in range(given.rounds):
            command = [str(given.program.resolve()), *given.options, "--out"]
            alone.append(alone_s([*command, f"alone-{number}"], folder))
            run, server = live_s([*command, f"live-{number}"], folder)
            own.append(run)
            others.append(server)
    ratios = [with_page / without for with_page, without in zip(own, alone)]
    print(f"alone {statistics.mean(alone):.2f} s, live {statistics.mean(own):.2f} s, server {statistics.mean(others):.2f} s")
    print(f"run's thread: x{statistics.mean(ratios):.3f}, from {min(ratios):.3f} to {max(ratios):.3f}, {given.rounds} rounds")


if __name__ == "__main__":
    main()
