// SPDX-License-Identifier: MIT
// Individuals that lived at given times of a run, with their genomes.
#pragma once

#include <span>
#include <tools/reading/run_manifest.hpp>
#include <trophic/population/individual.hpp>

namespace trophic::analysis {

/// An individual at an epoch, with its genome at that time: one that several individuals share changes at later births, and the
/// last row of genomes.csv up to the epoch counts.
struct LivingGenome {
  IndividualId id = 0;
  Species species = 0;
  Genome genome = {};
};

/// The individuals that were alive after the rules of each epoch's tick, by id. Throws std::invalid_argument, a sentence that
/// names the file, if the run did not reach an epoch or was killed, or if phylogeny.csv or genomes.csv is missing, cut, changed
/// since the run, or lacks a genome.
[[nodiscard]] std::vector<std::vector<LivingGenome>> living_genomes(const RunManifest& run, std::span<const double> epochs_s);

/// Throws std::invalid_argument, a sentence that names the run, unless it was written to its end and reached `epoch_s`.
void check_epoch(const RunManifest& run, double epoch_s);

}  // namespace trophic::analysis
