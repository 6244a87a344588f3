// SPDX-License-Identifier: MIT
// Definitions of epoch_genomes.hpp.
#include <tools/reading/epoch_genomes.hpp>

#include <tools/reading/checked_rows.hpp>
#include <tools/reading/lineages.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/params/params.hpp>
#include <unordered_map>

namespace trophic::analysis {

void check_epoch(const RunManifest& run, double epoch_s) {
  const std::string path = (run.folder / "manifest.json").string();
  if (!run.reached_s) {
    throw std::invalid_argument{path + ": status \"" + run.status +
                                "\": phylogeny.csv has those alive only at a run's end; resume the run"};
  }
  if (*run.reached_s >= epoch_s) return;
  throw std::invalid_argument{path + ": the run reached " + number_text(*run.reached_s) +
                              " s: must be >= " + number_text(epoch_s) + " s, an epoch"};
}

std::vector<std::vector<LivingGenome>> living_genomes(const RunManifest& run, std::span<const double> epochs_s) {
  for (const double epoch_s : epochs_s) check_epoch(run, epoch_s);
  std::vector<std::vector<LivingGenome>> living(epochs_s.size());
  std::unordered_map<std::uint64_t, std::vector<std::pair<std::size_t, std::size_t>>> wanted;  // epoch and place
  for_each_row<io::TaxonRow>(run, "phylogeny.csv", [&](const io::TaxonRow& row) {
    check_taxon(row, run);
    for (std::size_t epoch = 0; epoch < epochs_s.size(); ++epoch) {
      const double t = epochs_s[epoch];
      if (row.origin_time > t || row.destruction_time.value_or(t + 1.0) <= t) continue;
      wanted[row.genome].emplace_back(epoch, living[epoch].size());
      living[epoch].push_back({.id = row.id, .species = row.species});
    }
  });
  std::unordered_map<IndividualId, Genome> parts;  // gaits, bodies and brains that grow have a table of their own
  if (std::filesystem::exists(run.folder / "genes.csv")) {
    constexpr std::array genes{&Genome::weights, &Genome::gait_genes, &Genome::body_genes};  // in the order of io::GenomePart
    for_each_row<io::GeneRow>(run, "genes.csv", [&](const io::GeneRow& row) {
      (parts[row.id].*genes.at(static_cast<std::size_t>(row.part))).push_back(row.value);
    });
  }
  for_each_row<io::GenomeRow>(run, "genomes.csv", [&](const io::GenomeRow& row) {
    const auto found = wanted.find(row.genome);
    if (found == wanted.end()) return;
    for (const auto& [epoch, place] : found->second) {
      if (row.time_s > epochs_s[epoch]) continue;
      Genome& genome = living[epoch][place].genome = parts[row.id];
      if (genome.weights.empty()) genome.weights = row.weights;
      genome.traits = row.traits.values;
    }
  });
  for (std::vector<LivingGenome>& at_epoch : living) {
    for (const LivingGenome& one : at_epoch)
      if (one.genome.weights.empty())
        throw std::invalid_argument{(run.folder / "genomes.csv").string() + ": has no genome of individual " +
                                    std::to_string(one.id)};
    std::ranges::sort(at_epoch, {}, &LivingGenome::id);
  }
  return living;
}

}  // namespace trophic::analysis
