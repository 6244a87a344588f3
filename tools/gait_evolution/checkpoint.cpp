// SPDX-License-Identifier: MIT
// Definitions of checkpoint.hpp.
#include <tools/gait_evolution/checkpoint.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tools/command/toml_writer.hpp>
#include <tools/gait_evolution/genome_toml.hpp>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic::gait_evolution {

std::string to_toml(const Lineage& lineage, std::string_view fingerprint) {
  TomlWriter writer;
  writer.put("fingerprint", fingerprint);
  writer.put("generations", lineage.generations);
  writer.put("innovation_links", lineage.innovations.links());
  std::vector<Innovations::Ends> splits;
  for (const auto& [link, node] : lineage.innovations.splits()) splits.emplace_back(link, node);
  writer.put("innovation_splits", splits);
  for (const Individual& individual : lineage.individuals) {
    writer.element("individual");
    writer.put("parents", individual.parents);
    writer.put("born", individual.born);
    if (individual.died) writer.put("died", *individual.died);
    if (std::isfinite(individual.fitness)) writer.put("fitness", individual.fitness);
    put_genome(writer, individual.genome);
  }
  return writer.text();
}

namespace {

using trophic::detail::TomlTable;

std::size_t whole(const TomlTable& table, std::string_view key, double number, std::size_t below) {
  if (!(number >= 0.0) || number >= static_cast<double>(below) || number != std::floor(number)) {
    table.fail(key, " = " + number_text(number) + ": must be a whole number >= 0 and < " + number_text(below));
  }
  return static_cast<std::size_t>(number);
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> read_pairs(const TomlTable& table, std::string_view key) {
  constexpr std::size_t limit = std::size_t{1} << 32U;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const std::vector<double>& row : table.rows(key)) {
    if (row.size() != 2) table.fail(key, ": must be rows of two numbers");
    pairs.emplace_back(whole(table, key, row[0], limit), whole(table, key, row[1], limit));
  }
  return pairs;
}

}  // namespace

Lineage read_lineage(const trophic::detail::TomlTable& file, std::string_view fingerprint) {
  if (const std::string found = file.text("fingerprint"); found != fingerprint) {
    file.fail("fingerprint", " = \"" + found + "\": must be \"" + std::string{fingerprint} +
                                 "\"; robot, parameters or engine are not those that the checkpoint was made with");
  }
  std::vector<Innovations::Split> splits;
  for (const auto& [link, node] : read_pairs(file, "innovation_splits")) splits.push_back({link, node});
  Lineage lineage{.generations = file.whole_number("generations", 0),
                  .individuals = {},
                  .innovations = {read_pairs(file, "innovation_links"), std::move(splits)}};
  if (lineage.generations > 0) {
    for (const auto& table : file.tables("individual")) {
      Individual individual{.born = table.whole_number("born", 0)};
      for (const double parent : table.numbers("parents")) {
        individual.parents.push_back(whole(table, "parents", parent, lineage.individuals.size()));
      }
      if (table.has("died")) individual.died = table.whole_number("died", 0);
      if (table.has("fitness")) individual.fitness = table.number("fitness", any_number());
      individual.genome = read_genome(table);
      table.no_other_keys();
      lineage.individuals.push_back(std::move(individual));
    }
  }
  file.no_other_keys();
  // At least one individual is born in each generation, and at least one survives it.
  bool is_whole = lineage.generations <= lineage.individuals.size();
  for (std::size_t generation = 0; is_whole && generation < lineage.generations; ++generation) {
    is_whole = std::ranges::any_of(lineage.individuals, [&](const Individual& one) { return one.survived(generation); });
  }
  if (!is_whole) file.fail("generations", " = " + std::to_string(lineage.generations) + ": must be as many as have survivors");
  return lineage;
}

}  // namespace trophic::gait_evolution
