// SPDX-License-Identifier: MIT
// Definitions of lineages.hpp.
#include <tools/analysis/data/lineages.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tools/analysis/data/read_run.hpp>
#include <trophic/io/tables.hpp>
#include <unordered_map>
#include <utility>

namespace trophic::analysis {

namespace {

constexpr std::array lineage_tables{"phylogeny.csv", "genomes.csv"};

[[noreturn]] void refuse_shared(const RunManifest& run) {
  throw std::invalid_argument{(run.folder / "genomes.csv").string() +
                              ": rule heredity = " + run.policies.value("heredity", std::string{"unknown"}) +
                              ": must give each individual a genome of its own, as own_copy; a genome that several share changes "
                              "after birth"};
}

}  // namespace

void check_lineages(const RunManifest& run) {
  if (!run.reached_s) {
    throw std::invalid_argument{(run.folder / "manifest.json").string() + ": status \"" + run.status +
                                "\": phylogeny.csv has those alive only at a run's end; resume the run"};
  }
  for (const std::string_view name : lineage_tables) {
    if (std::filesystem::exists(run.folder / name)) continue;
    throw std::invalid_argument{(run.folder / name).string() + ": is missing: lineage measures need phylogeny and genomes"};
  }
  if (run.policies.value("heredity", std::string{}) == "shared_copy") refuse_shared(run);
}

Forest read_lineages(const RunManifest& run) {
  check_lineages(run);
  std::vector<io::TaxonRow> rows;
  for_each_row<io::TaxonRow>(run, lineage_tables[0], [&](const io::TaxonRow& row) { rows.push_back(row); });
  std::ranges::sort(rows, {}, &io::TaxonRow::id);
  std::unordered_map<IndividualId, std::size_t> places;
  Forest forest;
  for (const io::TaxonRow& row : rows) {
    Taxon taxon{.parent = {}, .birth_s = row.origin_time, .species = row.species};
    if (row.destruction_time) taxon.death_s = *row.destruction_time;
    if (row.ancestor != row.id) {
      const auto parent = places.find(row.ancestor);
      if (parent == places.end()) {
        throw std::invalid_argument{(run.folder / lineage_tables[0]).string() + ": id " + std::to_string(row.id) +
                                    ": its parent " + std::to_string(row.ancestor) + " is not among those born before it"};
      }
      taxon.parent = parent->second;
    }
    places.emplace(row.id, forest.size());
    forest.push_back(std::move(taxon));
  }
  std::unordered_map<std::uint64_t, IndividualId> owners;
  for_each_row<io::GenomeRow>(run, lineage_tables[1], [&](const io::GenomeRow& row) {
    if (owners.emplace(row.genome, row.id).first->second != row.id) refuse_shared(run);
    if (const auto place = places.find(row.id); place != places.end()) forest[place->second].weights = row.weights;
  });
  for (const auto& [id, place] : places) {
    if (!forest[place].weights.empty()) continue;
    throw std::invalid_argument{(run.folder / lineage_tables[1]).string() + ": has no genome of individual " +
                                std::to_string(id)};
  }
  return forest;
}

}  // namespace trophic::analysis
