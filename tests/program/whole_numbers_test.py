#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""whole_numbers_test.py PROGRAM..., each with its subcommand after a comma: no program takes a negative number, or one that it reads otherwise than it is written, as an
unsigned one. The options are those that its --help marks N."""

import pathlib
import re
import sys
import unittest

from in_folder import InFolder

PROGRAMS = [program.split(",") for program in sys.argv[1:]]
BAD = {
    "-1": ">= [01]",
    "18446744073709551616": "<= 18446744073709551615",
    **dict.fromkeys(("1.5", "1e3", "0x10", "010", "many"), "a whole number in decimal digits"),
}


class WholeNumbers(InFolder):
    def test_every_unsigned_option_of_every_program(self):
        self.assertGreaterEqual(len(PROGRAMS), 2)
        for program in PROGRAMS:
            name = " ".join([pathlib.Path(program[0]).name, *program[1:]])
            options = re.findall(r"^ *(--[\w-]+) N\b", self.call(*program, "--help").stdout, re.MULTILINE)
            self.assertGreaterEqual(len(options), 1, name)
            for option in options:
                for text, must in BAD.items():
                    with self.subTest(program=name, option=option, text=text):
                        result = self.call(*program, option, text)
                        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
                        self.assertRegex(result.stderr, rf"^{re.escape(f'{name}: {option} {text}')}: must be {must}\n$")
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
