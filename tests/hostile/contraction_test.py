#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""contraction_test.py PREDATOR_PREY NATIVE: one run by the headers alone, compiled with -march=native, has the bytes and the fingerprint of the
same run by the compiled library, without. Skipped where the processor has no fused multiply-add."""

import json
import pathlib
import subprocess
import sys
import tempfile

if " fma " not in pathlib.Path("/proc/cpuinfo").read_text():
    print("no fused multiply-add here")
    sys.exit(77)
PORTABLE, NATIVE = sys.argv[1:]
SAME_RUN = ["--backend", "kinematic", "--seed", "42", "--duration", "3000", "--out"]  # as contraction.cpp has it
with tempfile.TemporaryDirectory() as folder:
    portable, native = (pathlib.Path(folder) / name for name in ("portable", "native"))
    subprocess.run([PORTABLE, *SAME_RUN, portable], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([NATIVE, native], check=True)
    for name in ("events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "replay.trp"):
        assert (portable / name).read_bytes() == (native / name).read_bytes(), name
    fingerprints = [json.loads((out / "manifest.json").read_text())["fingerprint"] for out in (portable, native)]
    assert fingerprints[0] == fingerprints[1]
# The test would pass if -march=native changed nothing.
of_newer_processors = "vmulsd"
assert (
    of_newer_processors in subprocess.run(["objdump", "-d", NATIVE], capture_output=True, text=True, check=True).stdout
)
