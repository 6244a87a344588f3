# SPDX-License-Identifier: MIT
"""Cycles of numbers: their period and amplitude, distinguished from noise by simulation."""
from __future__ import annotations

from typing import NamedTuple

import numpy

from ..statistics import is_significant

MOST_POINTS = 512
"""A longer series is averaged to at most so many points."""
SURROGATES = 499
_LEAST_CYCLES = 3
"""That a series must last for its period to be known."""


class Cycle(NamedTuple):
    """nan without a cycle."""

    period: float
    """In points of the series."""
    amplitude: float
    """Half the distance between crest and trough, as a share of the mean."""
    p: float
    """How often red noise of the same memory has so strong a cycle; nan for a series that is constant or too short."""

    @property
    def is_there(self) -> float:
        """1 or 0; nan if it cannot be known."""
        return float(self.period == self.period) if self.p == self.p else numpy.nan


def thinned(series: numpy.ndarray) -> tuple[numpy.ndarray, int]:
    """Means over successive points along the last axis, at most MOST_POINTS, and how many points each averages."""
    every = -(-series.shape[-1] // MOST_POINTS)
    whole = series[..., : series.shape[-1] // every * every]
    return whole.reshape(*whole.shape[:-1], -1, every).mean(axis=-1), every


def autocorrelation(series: numpy.ndarray) -> numpy.ndarray:
    """Returns that of each series along the last axis, less its linear trend, up to a third of its length; long lags are damped."""
    from scipy import fft

    n = series.shape[-1]
    line = numpy.arange(n) - (n - 1) / 2
    rest = series - series.mean(axis=-1, keepdims=True)
    rest = rest - (rest @ line)[..., None] / (line @ line) * line
    size = fft.next_fast_len(n + n // _LEAST_CYCLES + 1, real=True)
    sums = fft.irfft(numpy.abs(fft.rfft(rest, size)) ** 2, size)[..., : n // _LEAST_CYCLES + 1]
    return sums / sums[..., :1]


def _rises(correlation: numpy.ndarray) -> numpy.ndarray:
    """By how much each autocorrelation exceeds the lowest value before it; 0 before its first zero."""
    after = numpy.logical_or.accumulate(correlation < 0.0, axis=-1)
    return numpy.where(
        after, correlation - numpy.minimum.accumulate(numpy.where(after, correlation, 1.0), axis=-1), 0.0
    )


def _peak(correlation: numpy.ndarray) -> numpy.ndarray:
    return _rises(correlation).max(axis=-1)


def _first(correlation: numpy.ndarray) -> int:
    """The lag of the first crest of an autocorrelation that rises half as high as the highest: a cycle is not twice its period."""
    rises = _rises(correlation)
    start = int((rises >= 0.5 * rises.max()).argmax())
    return start + int(correlation[start : start + start // 2 + 1].argmax())


def _memory(correlation: numpy.ndarray) -> numpy.ndarray:
    """The lag at which each autocorrelation first falls below 1/e, interpolated."""
    below = correlation < numpy.exp(-1.0)
    lag = numpy.where(below.any(axis=-1), below.argmax(axis=-1), correlation.shape[-1] - 1)
    before, at = (
        numpy.take_along_axis(correlation, numpy.maximum(lag - back, 0)[..., None], -1)[..., 0] for back in (1, 0)
    )
    return lag - numpy.where(before > at, (numpy.exp(-1.0) - at) / numpy.where(before > at, before - at, 1.0), 0.0)


def red_noise(memory: float, points: int, count: int, rng: numpy.random.Generator) -> numpy.ndarray:
    """Stationary autoregressive noise whose correlation falls to 1/e at this lag; white for a lag of 0. Shape (count, points)."""
    keep = numpy.exp(-1.0 / memory) if memory > 0.0 else 0.0
    noise = rng.standard_normal((points, count))
    noise[0] /= numpy.sqrt(1.0 - keep**2)
    for before, now in zip(noise, noise[1:]):
        now += keep * before
    return noise.T


def cycle_of(series: numpy.ndarray, surrogates: int = SURROGATES, seed: int = 0) -> Cycle:
    """The cycle of a series of numbers: the greatest rise of its autocorrelation after the first zero, if at most 5 % of series of red noise
    have as great a one. The noise has the memory that makes its estimated one, which is too short in short series, that of the series.
    """
    none = Cycle(numpy.nan, numpy.nan, numpy.nan)
    if len(series) < 8 * _LEAST_CYCLES or numpy.ptp(series) == 0.0:
        return none
    correlation = autocorrelation(series)
    rise = float(_peak(correlation))
    memory, rng = float(_memory(correlation)), numpy.random.default_rng(seed)
    asked = memory
    for _ in range(3):
        asked *= memory / _memory(autocorrelation(red_noise(asked, len(series), 49, rng))).mean()
        asked = min(asked, float(len(series)))
    p = (1.0 + (_peak(autocorrelation(red_noise(asked, len(series), surrogates, rng))) >= rise).sum()) / (
        surrogates + 1.0
    )
    if not is_significant(p) or series.mean() <= 0.0:
        return none._replace(p=p)
    lag = _first(correlation)
    period = float(lag)
    if 0 < lag < len(correlation) - 1:
        left, at, right = correlation[lag - 1 : lag + 2]
        period += (left - right) / (2.0 * (left - 2.0 * at + right)) if left - 2.0 * at + right < 0.0 else 0.0
    swing = max(float(correlation[lag]), -float(correlation[: lag + 1].min())) * series.var()
    return Cycle(period, float(numpy.sqrt(2.0 * swing) / series.mean()), p)
