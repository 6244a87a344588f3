// SPDX-License-Identifier: MIT
// Definitions of lineages.hpp.
#include <tools/reading/lineages.hpp>

#include <filesystem>
#include <tools/reading/checked_rows.hpp>
#include <tools/reading/epoch_genomes.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/params/params.hpp>
#include <unordered_map>

namespace trophic::analysis {

namespace {

constexpr std::array lineage_tables{"phylogeny.csv", "genomes.csv"};

[[noreturn]] void refuse_shared(const RunManifest& run) {
  throw std::invalid_argument{(run.folder / "genomes.csv").string() +
                              ": rule heredity = " + run.policies.value("heredity", std::string{"unknown"}) +
                              ": must give each individual a genome of its own, as own_copy; a genome that several share changes "
                              "after birth"};
}

[[noreturn]] void refuse(const RunManifest& run, IndividualId id, const std::string& what) {
  throw std::invalid_argument{(run.folder / lineage_tables[0]).string() + ": id " + std::to_string(id) + ": " + what};
}

}  // namespace

void check_lineages(const RunManifest& run) {
  check_epoch(run, 0.0);
  for (const std::string_view name : lineage_tables) {
    if (std::filesystem::exists(run.folder / name)) continue;
    throw std::invalid_argument{(run.folder / name).string() + ": is missing: lineage measures need phylogeny and genomes"};
  }
  if (run.policies.value("heredity", std::string{}) == "shared_copy") refuse_shared(run);
}

void check_taxon(const io::TaxonRow& row, const RunManifest& run) {
  const double end_s = run.reached_s.value_or(longest_run_s);
  constexpr double rounding_s = 1e-6;
  if (!(row.origin_time >= 0.0 && row.origin_time <= end_s + rounding_s)) {
    refuse(run, row.id,
           "origin_time = " + number_text(row.origin_time) + ": must be >= 0 and <= " + number_text(end_s) + ", the run's end");
  }
  const double death_s = row.destruction_time.value_or(std::max(end_s, row.origin_time));
  if (!(death_s >= row.origin_time && death_s <= end_s + rounding_s)) {
    refuse(run, row.id,
           "destruction_time = " + number_text(death_s) + ": must be >= its origin_time, " + number_text(row.origin_time) +
               ", and <= " + number_text(end_s) + ", the run's end");
  }
  const std::string parent = row.ancestor == row.id ? "[none" : "[" + std::to_string(row.ancestor);
  const std::string more = row.ancestor_list.substr(std::min(parent.size(), row.ancestor_list.size()));
  const bool fits = row.ancestor_list.starts_with(parent) && (more == "]" || (row.ancestor != row.id && more.starts_with(',')));
  if (!fits || !parents_in(row.ancestor_list))
    refuse(run, row.id, "ancestor_list = " + row.ancestor_list + ": must be " + parent + "], as its ancestor_id");
}

std::optional<std::vector<IndividualId>> parents_in(std::string_view ancestor_list) {
  std::vector<IndividualId> parents;
  if (ancestor_list == "[none]") return parents;
  if (!ancestor_list.starts_with('[') || !ancestor_list.ends_with(']')) return std::nullopt;
  std::string_view rest = ancestor_list.substr(1);
  while (!rest.empty()) {
    IndividualId parent = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), parent);
    if (error != std::errc{} || (*end != ',' && *end != ']')) return std::nullopt;
    parents.push_back(parent);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()) + 1);
  }
  return parents;
}

Forest read_lineages(const RunManifest& run) {
  check_lineages(run);
  std::vector<io::TaxonRow> rows;
  for_each_row<io::TaxonRow>(run, lineage_tables[0], [&](const io::TaxonRow& row) {
    check_taxon(row, run);
    rows.push_back(row);
  });
  std::ranges::sort(rows, {}, &io::TaxonRow::id);
  std::unordered_map<IndividualId, std::size_t> places;
  Forest forest;
  for (const io::TaxonRow& row : rows) {
    Taxon taxon{.id = row.id, .parent = {}, .birth_s = row.origin_time, .species = row.species};
    if (row.destruction_time) taxon.death_s = *row.destruction_time;
    const std::vector<IndividualId> parents = parents_in(row.ancestor_list).value();
    for (const IndividualId one : parents) {
      const auto parent = places.find(one);
      if (parent == places.end()) refuse(run, row.id, "its parent " + std::to_string(one) + " is not among those born before it");
      if (taxon.parent) taxon.others.push_back(parent->second);
      taxon.parent = taxon.parent.value_or(parent->second);
    }
    if (!places.emplace(row.id, forest.size()).second) refuse(run, row.id, "has two rows");
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
