#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""paper_tables_test.py PREDATOR_PREY TROPHIC: every LaTeX table and captions.tex in a column of two and on a page, by pdflatex: no overfull box.

Exit code 77, skipped, without pdflatex (Debian: texlive-latex-base texlive-latex-recommended)."""

import re
import shutil
import sys
import unittest

import figures_python
from in_folder import InFolderWithSets, run_ok

PREDATOR_PREY, TROPHIC = (sys.argv.pop(1) for _ in range(2))
if shutil.which("pdflatex") is None:
    print("no pdflatex")
    sys.exit(77)

DOCUMENT = r"""\documentclass[%s]{article}
\usepackage[T1]{fontenc}
\usepackage{booktabs,tabularx,graphicx}
%s
\begin{document}
\begin{%s}
\caption{A table.}
\input{%s}
\end{%s}
Text.
\end{document}
"""


class PaperTables(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        for rules in ("paper", "released"):
            cls.call(
                PREDATOR_PREY,
                "--backend",
                "kinematic",
                "--rules",
                rules,
                "--duration",
                1000,
                "--replicates",
                6,
                "--jobs",
                2,
                "--shadow",
                "--out",
                rules,
            )
        cls.call(TROPHIC, "analyze", "--compare", "paper", "released", "--out", "analysis")
        cls.call(TROPHIC, "analyze", "paper", "--out", "one")

    @classmethod
    def call(cls, *arguments):
        return run_ok(*arguments, cwd=cls.sets).stdout

    def compiled(self, options, environment, table, preamble=""):
        (self.folder / "paper.tex").write_text(DOCUMENT % (options, preamble, environment, table, environment))
        done = self.run_ok("pdflatex", "-interaction=nonstopmode", "paper.tex")
        self.assertEqual(
            re.findall(r"^(?:Overfull|LaTeX Warning: Float too large).*", done.stdout, re.M),
            [],
            f"{table} in {environment}",
        )

    def test_results_fit_a_page(self):
        for table in ("means", "differences"):
            shutil.copy(self.sets / f"analysis/{table}.tex", self.folder)
        # means.tex of a comparison has a table for each set.
        for place, part in enumerate((self.folder / "means.tex").read_text().split("% \\usepackage")[1:]):
            (self.folder / f"means{place}.tex").write_text("% " + part)
            self.compiled("", "table", f"means{place}")
            self.compiled("twocolumn", "table*", f"means{place}")
        shutil.copy(self.sets / "one/answers.tex", self.folder)
        self.compiled("", "table", "answers")
        self.compiled("", "table", "differences")
        self.compiled("twocolumn", "table*", "differences")

    @unittest.skipUnless(figures_python.PYTHON, "needs matplotlib and pandas")
    def test_figures_and_captions_go_into_a_document(self):
        self.call(TROPHIC, "plot", "analysis", "--style", "ieee", "--out", self.folder / "figures")
        for path in (self.folder / "figures").iterdir():
            shutil.copy(path, self.folder)
        (self.folder / "figure.tex").write_text("\\includegraphics{forest}\\par\\trophicForest\n")
        self.compiled("twocolumn", "figure*", "figure", preamble="\\input{captions}")


if __name__ == "__main__":
    unittest.main()
