# SPDX-License-Identifier: MIT
"""Tests of programs that leave files: each test works in a temporary folder of its own."""

import json
import pathlib
import tempfile
import unittest
import zlib


def sealed_text(value):
    """A manifest or a list of replicates as trophic writes it, with its checksum at the end."""
    body = json.dumps({key: entry for key, entry in value.items() if key != "crc32"}, indent=2)[:-2]
    return f'{body},\n  "crc32": {zlib.crc32(body.encode())}\n}}\n'


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))


class InFolderWithSets(InFolder):
    """Also has `sets`, a folder that a class fills once with `make_sets` for all of its tests."""

    @classmethod
    def setUpClass(cls):
        cls.sets = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.make_sets()
