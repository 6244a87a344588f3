#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""growth.py FILE.csv: whether memory and processor time that the program soak measured all along a run grew. Exit code 1 if the memory did, or if
the test is inconclusive in a run that is long enough."""
import pathlib
import sys

sys.path[:0] = [
    str(pathlib.Path(__file__).resolve().parents[2] / folder) for folder in ("tests/program", "tools/python")
]
import system_python  # noqa: E402

system_python.need("numpy", "pandas", "scipy")
import numpy  # noqa: E402
import pandas  # noqa: E402
from trophic.statistics import EquivalenceTest, contrast, test_equivalence  # noqa: E402

SAME_WITHIN = 0.1  # by how much halves of a run may differ to count as the same, as a share of the first half's mean
PARTS_OF_HALF = 10
UNKNOWN = EquivalenceTest(None, None, 0.0, "unknown")


def growth_of(measured) -> EquivalenceTest:
    """The first tenth of the measurements is left out, as a run has to settle, and so are as many of its first as do not fill twenty parts alike. The
    means of ten parts of each half are then compared by two one-sided tests; parts must be long enough to be independent of each other.
    """
    measured = numpy.asarray(measured, float)
    part = (len(measured) - len(measured) // 10) // (2 * PARTS_OF_HALF)
    if part == 0:
        return UNKNOWN
    means = measured[-2 * PARTS_OF_HALF * part :].reshape(2 * PARTS_OF_HALF, part).mean(axis=1)
    early, late = means[:PARTS_OF_HALF], means[PARTS_OF_HALF:]
    margin = SAME_WITHIN * early.mean()
    return test_equivalence(contrast((-1.0, early), (1.0, late)), margin) if margin > 0.0 else UNKNOWN


def main() -> int:
    table = pandas.read_csv(sys.argv[1])
    flat = True
    for column in ("least_allocated_mb", "resident_mb", "processor_s"):
        growth = growth_of(table[column])
        if growth.interval is None:
            print(f"{column}: too few rows for a test")
            continue
        print(
            f"{column}: second half of the run minus first {growth.difference:.6g}, 90 % interval [{growth.interval.lower:.6g}, {growth.interval.upper:.6g}], "
            f"margin {growth.margin:.6g}: {growth.conclusion}"
        )
        flat = flat and (column == "processor_s" or growth.conclusion == "equivalent")
    return 0 if flat else 1


if __name__ == "__main__":
    sys.exit(main())
