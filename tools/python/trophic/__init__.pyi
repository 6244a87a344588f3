# SPDX-License-Identifier: MIT
from . import (
    figures as figures,
    metrics as metrics,
    pool as pool,
    programs as programs,
    recording as recording,
    runs as runs,
    start as start,
)
from .ecologies import VectorEnv as VectorEnv
from .environment import Environment as Environment, OneAgent as OneAgent, env as env
from .errors import ProgramError as ProgramError, RunError as RunError
from .meetings import Meeting as Meeting, meet as meet
from .metrics.own import metric as metric
from .programs import Page as Page
from .recording import Recording as Recording, RecordingError as RecordingError, read_replay as read_replay
from .runs import (
    Analysis as Analysis,
    Run as Run,
    Runs as Runs,
    read_analysis as read_analysis,
    read_run as read_run,
    read_runs as read_runs,
    read_study as read_study,
    study_frames as study_frames,
    to_parquet as to_parquet,
    verify as verify,
)
from .start import analyze as analyze, run as run, show as show, sweep as sweep
from .sweeps import SweepAnalysis as SweepAnalysis, analyze_sweep as analyze_sweep

__version__: str
