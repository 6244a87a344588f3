# SPDX-License-Identifier: MIT
"""Tests of programs that leave files: each test works in a temporary folder of its own."""

import pathlib
import tempfile
import unittest


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))


class InFolderWithSets(InFolder):
    """Also has `sets`, a folder that a class fills once with `make_sets` for all of its tests."""

    @classmethod
    def setUpClass(cls):
        cls.sets = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.make_sets()
