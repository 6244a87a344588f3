// SPDX-License-Identifier: MIT
// Definitions of lineages.hpp.
#include <tools/reading/lineages.hpp>

#include <trophic/io/tables.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

namespace {

[[noreturn]] void refuse(const RunManifest& run, IndividualId id, const std::string& what) {
  throw std::invalid_argument{(run.folder / "phylogeny.csv").string() + ": id " + std::to_string(id) + ": " + what};
}

}  // namespace

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
  const std::string list = "ancestor_list = " + row.ancestor_list + ": must be ";
  const std::string parent = "[" + (row.ancestor == row.id ? "none" : std::to_string(row.ancestor.value_or(0))) + "]";
  if (row.ancestor && row.ancestor_list != parent) refuse(run, row.id, list + parent + ", as its ancestor_id");
  if (!parents_in(row.ancestor_list)) refuse(run, row.id, list + "[none] or its parents, as [7,9]");
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

}  // namespace trophic::analysis
