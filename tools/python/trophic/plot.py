# SPDX-License-Identifier: MIT
"""`trophic plot`: every figure of an analysis into a new folder, as PNG and PDF with captions.json and captions.tex."""
from __future__ import annotations

import argparse
import pathlib
import sys


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="trophic plot", description=__doc__)
    parser.add_argument("analysis", type=pathlib.Path, help="folder that `trophic analyze`, `trophic contest` or `trophic cross-check` wrote")
    parser.add_argument("--out", type=pathlib.Path, help="new folder for the figures (ANALYSIS/figures)")
    parser.add_argument("--style", choices=["plain", "serif", "ieee"], default="plain", help="fonts and widths (plain)")
    parser.add_argument("--columns", type=int, choices=[1, 2], default=1, help="width of a figure, in columns of a page (1)")
    parser.add_argument("--with-captions", action="store_true", help="draw the captions into the figures, too")
    parser.add_argument("--run", type=int, default=0, help="whose phylogeny, paths and catch are drawn: the K-th run of a set (0)")
    parser.add_argument("--trophic", default="trophic", help="the program that draws the film strip (trophic)")
    parser.add_argument("--metric", nargs="+", help="for a sweep: draw only these")
    parser.add_argument("--axes", nargs="+", help="for a sweep: what to draw along x, as lines and as panels")
    options = parser.parse_args(arguments)

    def refuse(why):
        print(f"trophic plot: {why}", file=sys.stderr)
        return 2

    try:
        import matplotlib
        matplotlib.use("Agg")
        from .runs import RunError, read_analysis
        from .figures import bodies, contests, cross_check, paper, style, sweep
    except ModuleNotFoundError as error:
        return refuse(f"needs the Python module {error.name}, which {sys.executable} lacks: apt-get install python3-matplotlib python3-pandas "
                      "python3-scipy, or TROPHIC_PYTHON=/usr/bin/python3 if it is installed there")
    folder = options.analysis
    out = options.out or folder / "figures"
    if out.exists() or out.is_symlink():
        return refuse(f"--out {out}: exists already; nothing is overwritten")
    is_sweep = (folder / "sweep_metrics.csv").exists()
    if not is_sweep and (options.metric or options.axes):
        return refuse("--metric and --axes: only of an analysed sweep, a folder with sweep_metrics.csv")
    style.use(options.style, options.columns)
    try:
        if is_sweep:
            figures = sweep.figures_of(folder, options.metric, options.axes)
        elif (folder / "cross_check.csv").exists():
            figures = cross_check.figures_of(folder)
        elif (folder / "contests.csv").exists():
            figures = contests.figures_of(folder)
        elif bodies.has_bodies(read_analysis(folder).metrics):
            figures = bodies.figures_of(folder, options.run, options.trophic)
        else:
            figures = paper.figures_of(folder, options.run, options.trophic)
    except (RunError, IndexError) as error:
        return refuse(error)
    except KeyError as error:
        return refuse(error.args[0] if str(error.args[0]).startswith("--") else f"{folder}: no {error}: is it what trophic analyze wrote?")
    except (OSError, ValueError, AttributeError) as error:
        return refuse(f"{folder}: is not what trophic analyze writes: {error}")
    drawn = style.save_all(figures, out, options.with_captions)
    print(f"{drawn} figures in {out}, with captions.json and captions.tex")
    return 0 if drawn else 1


if __name__ == "__main__":
    sys.exit(main())
