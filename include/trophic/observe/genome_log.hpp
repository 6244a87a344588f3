// SPDX-License-Identifier: MIT
// genomes.csv: the weights that every individual was born with.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <trophic/observe/csv.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/population/view.hpp>

namespace trophic::observe {

/// One row per birth. Columns: id (of the individual), genome_id, time_s, w0, w1, ... (exact). Where genomes are shared, a later
/// row of the same genome_id holds what everybody who shares it has from then on.
class GenomeLog {
 public:
  explicit GenomeLog(std::filesystem::path path) : path_{std::move(path)} {}

  void on_event(const Event& event, const View& view) {
    if (event.kind != EventKind::birth) return;
    const Genome& genome = *event.individual.genome;
    if (!file_) file_.emplace(path_, header(genome.weights.size()));
    file_->cell(event.individual.id);
    file_->cell(genome.id);
    file_->cell(view.time_s);
    for (const double weight : genome.weights) file_->cell(weight);
    file_->end_row();
  }
  void on_tick(const View&) {
    if (file_) file_->flush();
  }

 private:
  static std::string header(std::size_t weights) {
    std::string text = "id,genome_id,time_s";
    for (std::size_t i = 0; i < weights; ++i) text += ",w" + std::to_string(i);
    return text;
  }

  std::filesystem::path path_;
  std::optional<CsvFile> file_;
};

}  // namespace trophic::observe
