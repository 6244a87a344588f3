# SPDX-License-Identifier: MIT
"""How far a species moves late in a run: metrics for `trophic analyze --metric-file`, of runs whose brain is the paper's network.

Each is the root mean square difference, over genes or over 30 inputs, between the means of the living in the middle and in the last sixth of a run."""
import numpy
import pandas
import trophic

DISTANCES, TAG_RATIOS = (0.05, 0.15, 0.25, 0.35, 0.45), (-0.2, 0.0, 0.2)
INPUTS = numpy.array([(side, far, tags) for side in (-1.0, 1.0) for far in DISTANCES for tags in TAG_RATIOS])


def moved(run, values):
    """A frame with the distance of each species. `values`: of each individual, shape (individuals, values), in the order of genomes.csv."""
    lives, end_s = run.table("phylogeny"), run.manifest["result"]["reached_s"]
    lives = lives.set_index("id").loc[run.table("genomes")["id"]]
    rows = []
    for species in run.manifest["species"]:
        means = []
        for from_s in (end_s / 3.0, end_s * 5.0 / 6.0):
            until_s = from_s + end_s / 6.0
            lived_s = (lives["destruction_time"].clip(upper=until_s) - lives["origin_time"].clip(lower=from_s)).clip(lower=0.0).to_numpy()
            weights = lived_s * (lives["species"] == species).to_numpy()
            means.append(weights @ values / weights.sum() if weights.sum() > 0.0 else numpy.full(values.shape[1], numpy.nan))
        rows.append((species, float(numpy.sqrt(numpy.mean((means[1] - means[0]) ** 2)))))
    return rows


def weights_of(run):
    genomes = run.table("genomes")
    return genomes[[name for name in genomes if name.startswith("w")]].dropna(axis=1).to_numpy()


@trophic.metric(inherited=True)
def gene_change(run):
    return pandas.DataFrame(moved(run, weights_of(run)), columns=["species", "gene_change"])


@trophic.metric(inherited=True)
def turn_change(run):
    """The change of the share that turns right, over inputs."""
    weights = weights_of(run)
    biases = 3 if weights.shape[1] == 20 else 0
    hidden = numpy.tanh(INPUTS @ weights[:, :9].reshape(-1, 3, 3).transpose(0, 2, 1) + (weights[:, None, 9:12] if biases else 0.0))
    right = (hidden @ weights[:, 9 + biases:12 + biases, None])[..., 0] + (weights[:, None, 18] if biases else 0.0) > 0.0
    return pandas.DataFrame(moved(run, right), columns=["species", "turn_change"])
