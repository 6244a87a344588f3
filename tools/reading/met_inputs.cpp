// SPDX-License-Identifier: MIT
// Definitions of met_inputs.hpp.
#include <tools/reading/met_inputs.hpp>

#include <set>
#include <tools/reading/checked_rows.hpp>
#include <tools/reading/csv_reader.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::analysis {

namespace {

using Met = std::vector<std::set<Inputs>>;

void add_met(const RunManifest& run, Met& met) {
  const std::filesystem::path path = run.folder / "senses.csv";
  if (!std::filesystem::exists(path)) {
    throw std::invalid_argument{path.string() + ": is missing: lineage measures need it of the first run; run with --senses"};
  }
  CsvReader table{path, {"species"}};
  std::size_t size = 0;
  for (; table.has("input" + std::to_string(size)); ++size) table.want("input" + std::to_string(size));
  while (table.next()) {
    if (size == 0 || table.text(1).empty()) continue;  // the brain was not asked
    Inputs inputs;                                     // cells beyond those of a species are empty
    for (std::size_t i = 0; i < size && !table.text(i + 1).empty(); ++i) inputs.push_back(table.get<double>(i + 1));
    for (Species species = 0; species < run.web.size(); ++species)
      if (run.web.name(species) == table.text(0)) met[species].insert(inputs);
  }
  if (table.truncated()) throw std::invalid_argument{path.string() + ": the last line is truncated; resume the run"};
}

}  // namespace

std::vector<std::vector<Inputs>> met_inputs(std::span<const RunManifest> runs, std::size_t most) {
  Met met(runs.front().web.size());
  try {
    for (const RunManifest& run : runs) add_met(run, met);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
  std::vector<std::vector<Inputs>> drawn;
  for (const std::set<Inputs>& of_species : met) {
    std::vector<Inputs> all(of_species.begin(), of_species.end());
    Rng rng{0, Stream::null_model, drawn.size()};
    rng.shuffle(std::span{all});
    all.resize(std::min(most, all.size()));
    drawn.push_back(std::move(all));
  }
  return drawn;
}

}  // namespace trophic::analysis
