#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""contraction_test.py PORTABLE NATIVE: one run by the headers alone, compiled without and with -march=native, is the same bytes and has
the same fingerprint. Skipped where the processor has no fused multiply-add."""

import json
import pathlib
import subprocess
import sys
import tempfile

if " fma " not in pathlib.Path("/proc/cpuinfo").read_text():
    print("no fused multiply-add here")
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    outs = [pathlib.Path(folder) / name for name in ("portable", "native")]
    for program, out in zip(sys.argv[1:], outs, strict=True):
        subprocess.run([program, out], check=True)
    for name in ("events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "replay.trp"):
        assert (outs[0] / name).read_bytes() == (outs[1] / name).read_bytes(), name
    manifests = [json.loads((out / "manifest.json").read_text()) for out in outs]
    assert manifests[0]["fingerprint"] == manifests[1]["fingerprint"]
    # They are two programs: the test would pass if -march=native changed nothing.
    assert manifests[0]["code"] != manifests[1]["code"]
