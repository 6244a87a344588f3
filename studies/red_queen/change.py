# SPDX-License-Identifier: MIT
"""How far a species moves late in a run: metrics for `trophic analyze --metric-file`, of runs whose brain is the paper's network, or grows and has the
senses of studies/arms_race/room.hpp.

Each is the root mean square difference, over genes or over 30 inputs, between the means of the living in the middle and in the last sixth of a run.
The one gene of a brain that grows is its number of links."""
import numpy
import pandas
import trophic

DISTANCES, TAG_RATIOS = (0.05, 0.15, 0.25, 0.35, 0.45), (-0.2, 0.0, 0.2)
INPUTS = numpy.array([(side, far, tags) for side in (-1.0, 1.0) for far in DISTANCES for tags in TAG_RATIOS])
BANDS = numpy.maximum(0.0, 1.0 - 20.0 * INPUTS[:, 1:2] / (2.0, 5.0, 15.0))  # of a floor of 20 m
NINE = numpy.column_stack(
    [INPUTS[:, 0], BANDS, INPUTS[:, 2], numpy.tile((0.0, 0.0, 1.0, 1.0), (30, 1))]
)  # walks far from walls with tag +1


def moved(run, values):
    """A frame with the distance of each species. `values`: of each row of genomes.csv, shape (rows, values). A genome that several share has them from
    the time of its row until that of its next."""
    lives, end_s = run.table("phylogeny"), run.manifest["result"]["reached_s"]
    rows = run.table("genomes")[["id", "genome_id", "time_s"]].rename_axis("row").reset_index()
    rows["until_s"] = rows.groupby("genome_id")["time_s"].shift(-1, fill_value=numpy.inf)
    held = rows[["id", "genome_id"]].merge(rows.drop(columns="id"), on="genome_id").merge(lives, on="id")
    begins, ends = held[["origin_time", "time_s"]].max(axis=1), held[["destruction_time", "until_s"]].min(
        axis=1
    )  # an individual's time with a row's values
    found = []
    for species in run.manifest["species"]:
        means = []
        for from_s, until_s in ((end_s / 3.0, end_s / 2.0), (end_s * 5.0 / 6.0, end_s)):
            weights = (ends.clip(upper=until_s) - begins.clip(lower=from_s)).clip(lower=0.0).to_numpy() * (
                held["species"] == species
            ).to_numpy()
            means.append(
                weights @ values[held["row"]] / weights.sum()
                if weights.sum() > 0.0
                else numpy.full(values.shape[1], numpy.nan)
            )
        found.append((species, float(numpy.sqrt(numpy.mean((means[1] - means[0]) ** 2)))))
    return found


def genes_of(run):
    """The weights of each individual of genomes.csv, shape (individuals, weights), or a list of the genes of brains that grow."""
    genomes = run.table("genomes")
    if run.manifest["rules"]["brain"] != "growing_brain":
        return genomes[[name for name in genomes if name.startswith("w")]].dropna(axis=1).to_numpy()
    of = {id: genes.to_numpy() for id, genes in run.table("genes").query("part == 'brain'").groupby("id")["value"]}
    return [of[id] for id in genomes["id"]]


def right_of(genes):
    """Whether a brain turns right at each of NINE, by its genes: hidden neurons, the ends of each link, the weight of each link."""
    links = len(genes) // 3
    start, end = genes[1 : 1 + 2 * links].astype(int).reshape(-1, 2).T
    neurons = numpy.vstack([NINE.T, numpy.zeros((int(genes[0]) + 2, 30))])
    for to in range(9, len(neurons)):
        neurons[to] = numpy.tanh(genes[1 + 2 * links :][end == to] @ neurons[start[end == to]])
    return neurons[-2] > 0.0


def turns_right(run):
    """Whether each individual of genomes.csv turns right, shape (individuals, inputs)."""
    weights = genes_of(run)
    if isinstance(weights, list):
        return numpy.array([right_of(genes) for genes in weights])
    biases = 3 if weights.shape[1] == 20 else 0
    hidden = numpy.tanh(
        INPUTS @ weights[:, :9].reshape(-1, 3, 3).transpose(0, 2, 1) + (weights[:, None, 9:12] if biases else 0.0)
    )
    return (hidden @ weights[:, 9 + biases : 12 + biases, None])[..., 0] + (
        weights[:, None, 18] if biases else 0.0
    ) > 0.0


def turns_to(run):
    """The share of inputs at which each individual turns to its adversary, by id. In `released` the side of prey is the one that leads away."""
    species = run.table("phylogeny").set_index("id")["species"].loc[run.table("genomes")["id"]]
    is_away = (species == "prey") & str(run.manifest["rules"]["sensors"]).startswith("side_away_from_hunter")
    shares = (turns_right(run) == (INPUTS[:, 0] > 0.0)).mean(axis=1)
    return pandas.Series(numpy.where(is_away, 1.0 - shares, shares), index=species.index).groupby(level=0).first()


@trophic.metric(inherited=True)
def gene_change(run):
    genes = genes_of(run)
    if isinstance(genes, list):
        genes = numpy.array([[len(each) // 3] for each in genes])
    return pandas.DataFrame(moved(run, genes), columns=["species", "gene_change"])


@trophic.metric(inherited=True)
def turn_change(run):
    """The change of the share that turns right, over inputs."""
    return pandas.DataFrame(moved(run, turns_right(run)), columns=["species", "turn_change"])
