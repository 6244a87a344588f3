// SPDX-License-Identifier: MIT
// genomes.csv and genes.csv: the genome of every individual at birth.
#pragma once

#include <trophic/io/csv_file.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {

/// Writes a GenomeRow per birth, with a column for each heritable trait. The file has as many weights as the largest brain of a
/// species; smaller brains leave the last cells empty.
class GenomeLog {
 public:
  static constexpr std::string_view file_name = "genomes.csv";

  explicit GenomeLog(std::filesystem::path path, Opening opening = Opening::created) : path_{std::move(path)} {
    if (opening == Opening::resumed) file_.emplace(path_, opening);
  }

  void on_start(const observe::RunDescription& run, const View&) { weights_ = run.brain_weights.value_or(0); }
  void on_event(const observe::Event& event, const View& view) {
    if (event.kind != observe::EventKind::birth) return;
    const Genome& genome = *event.individual.genome;
    GenomeRow row{.id = event.individual.id, .genome = genome.id, .time_s = view.time_s, .weights = genome.weights};
    row.weights.resize(weights_, std::numeric_limits<double>::quiet_NaN());
    row.traits = {.names = {view.traits.begin(), view.traits.end()}, .values = genome.traits};
    if (!file_) file_.emplace(path_, row);
    file_->write(row, view.web);
  }
  void on_tick(const View&) {
    if (file_) file_->flush();
  }

  void persist(Archive& archive) {
    if (!file_) throw std::runtime_error{path_.string() + ": no individual was born, so there is no file to resume"};
    file_->persist(archive);
  }
  [[nodiscard]] TableSum sum() const { return file_ ? file_->sum() : TableSum{}; }

 private:
  std::filesystem::path path_;
  std::optional<CsvFile<GenomeRow>> file_;
  std::size_t weights_ = 0;  ///< number of weights of the largest brain; 0 if brains grow
};

/// Writes a GeneRow per gene of a newborn: the genes of its gait, its body and, if brains grow, its brain.
class GeneLog : public CsvFile<GeneRow> {
 public:
  static constexpr std::string_view file_name = "genes.csv";
  using CsvFile<GeneRow>::CsvFile;

  void on_start(const observe::RunDescription& run, const View&) { brains_grow_ = !run.brain_weights; }
  void on_event(const observe::Event& event, const View&) {
    if (event.kind != observe::EventKind::birth) return;
    const Genome& genome = *event.individual.genome;
    if (brains_grow_) write_all(event.individual.id, GenomePart::brain, genome.weights);
    write_all(event.individual.id, GenomePart::gait, genome.gait_genes);
    write_all(event.individual.id, GenomePart::body, genome.body_genes);
  }
  void on_tick(const View&) { flush(); }

 private:
  void write_all(IndividualId id, GenomePart part, const std::vector<double>& genes) {
    for (std::size_t i = 0; i < genes.size(); ++i) write({.id = id, .part = part, .index = i, .value = genes[i]});
  }
  bool brains_grow_ = false;
};

}  // namespace trophic::io
