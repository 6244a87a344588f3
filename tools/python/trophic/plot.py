# SPDX-License-Identifier: MIT
"""`trophic plot`: every figure of an analysis, or the curves of one run, into a new folder, as PNG and PDF with captions.json and captions.tex."""
from __future__ import annotations

import logging
import os
import pathlib


def _import_matplotlib() -> None:
    """Figures are of the analysis alone: no matplotlibrc of the user, of the working folder or of the environment is read."""
    os.environ["MATPLOTLIBRC"] = os.devnull
    logging.getLogger("matplotlib").setLevel(logging.ERROR)  # without a home it works in a temporary folder
    os.environ.pop("MPLBACKEND", None)
    here = os.getcwd()
    os.chdir(pathlib.Path(__file__).parent)
    try:
        import matplotlib
    finally:
        os.chdir(here)
    matplotlib.use("Agg")


def run(request: dict) -> int:
    """Draws the figures of the folder `analysis`; the request has the options of `trophic plot`. Returns the exit code."""
    _import_matplotlib()
    from .figures import bodies, contests, cross_check, paper, run as of_run, style, sweep
    from .writing import check_new, result_folder
    from .errors import RunError, printable
    from .runs import read_analysis

    folder = pathlib.Path(request["analysis"])
    if not folder.is_dir():
        raise RunError(f"{folder}: {'is not a folder' if folder.exists() else 'does not exist'}")
    which, metrics, axes = (request["run"] or 0, request["metric"] or [], request["axes"] or [])
    if request["out"] is not None:
        check_new(request["out"])
    is_sweep = (folder / "sweep_metrics.csv").exists()
    if not is_sweep and (metrics or axes):
        raise RunError("--metric and --axes: need the analysis of a sweep, a folder with sweep_metrics.csv")
    style.use(request["style"], request["columns"])
    try:
        if (folder / "manifest.json").exists():
            figures = of_run.figures_of(folder)
        elif is_sweep:
            figures = sweep.figures_of(folder, metrics, axes)
        elif (folder / "cross_check.csv").exists():
            figures = cross_check.figures_of(folder)
        elif (folder / "contests.csv").exists():
            figures = contests.figures_of(folder)
        elif bodies.has_bodies(read_analysis(folder).metrics):
            figures = bodies.figures_of(folder, which)
        else:
            figures = paper.figures_of(folder, which)
    except RunError:
        raise
    except IndexError as error:
        raise RunError(error) from None
    except KeyError as error:
        option = str(error.args[0])
        raise RunError(
            option if option.startswith("--") else f"{folder}: no {error}: is this folder an output of trophic analyze?"
        ) from None
    except (OSError, ValueError, AttributeError) as error:
        raise RunError(f"{folder}: is not what trophic analyze writes: {error}") from None
    with result_folder(request["out"], name=str(folder / "figures")) as part:
        drawn = style.save_all(figures, part, request["with_captions"])
        if not drawn:
            raise RunError(f"{folder}: has no data for any figure")
    print(
        f"{drawn} figure{'s' * (drawn > 1)} in {printable(str(part.with_suffix('')))}, with captions.json and captions.tex"
    )
    return 0
