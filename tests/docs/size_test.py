#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""size_test.py ROOT: scripts/size finds a ceiling that is passed, a stale figure and a file without a purpose, and nothing else."""

import importlib.util
import sys
from importlib.machinery import SourceFileLoader

ROOT = sys.argv[1]
loader = SourceFileLoader("size", f"{ROOT}/scripts/size")
size = importlib.util.module_from_spec(importlib.util.spec_from_loader("size", loader))
sys.dont_write_bytecode = True
loader.exec_module(size)

ceiling = dict(tuple(row[:2]) for row in size.PURPOSES)["film"]
small = {"tools/film/film.cpp": "x\n" * 500, "README.md": "x\n", "models/robots/spider.toml": "x\n", "tools/viewer/page/index.html": "x\n"}
ledger = size.document(size.count(small)[0])
passed = {"tools/film/film.cpp": "x\n" * int(1.02 * ceiling)}

CASES = [  # files, text of docs/size.md, starts of the offences
    (small, ledger, []),
    ({**small, "tools/film/film.cpp": "x\n" * 540}, ledger, []),
    ({**small, "tools/film/film.cpp": "x\n" * 560}, ledger, ["docs/size.md: film: says 500", "docs/size.md: tools/", "docs/size.md: all"]),
    ({**small, "include/trophic/attic/old.hpp": "x\n"}, ledger, ["include/trophic/attic/old.hpp: belongs to no purpose"]),
    ({**small, "tools/film.lua": "x\n"}, ledger, ["tools/film.lua: belongs to no purpose"]),
    (passed, size.document(size.count(passed)[0]), ["film: "]),
    (small, ledger.replace("| film |", "| pictures |"), ["docs/size.md: film: says nothing"]),
]

failed = 0
for number, (files, written, expected) in enumerate(CASES):
    found = size.offences(files, written)
    if sorted(expected) != sorted(next((start for start in expected if offence.startswith(start)), offence) for offence in found):
        print(f"case {number}: expected {expected}, found {found}")
        failed += 1
sys.exit(1 if failed else 0)
