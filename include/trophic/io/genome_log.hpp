// SPDX-License-Identifier: MIT
// genomes.csv: the weights of every individual at birth.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <trophic/io/csv_file.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/population/view.hpp>
#include <utility>

namespace trophic::io {

/// Writes a GenomeRow per birth. The file begins with the first one, which sets the number of weights.
class GenomeLog {
 public:
  explicit GenomeLog(std::filesystem::path path, Opening opening = Opening::created) : path_{std::move(path)} {
    if (opening == Opening::resumed) file_.emplace(path_, opening);
  }

  void on_event(const observe::Event& event, const View& view) {
    if (event.kind != observe::EventKind::birth) return;
    const Genome& genome = *event.individual.genome;
    const GenomeRow row{.id = event.individual.id, .genome = genome.id, .time_s = view.time_s, .weights = genome.weights};
    if (!file_) file_.emplace(path_, row);
    file_->write(row);
  }
  void on_tick(const View&) {
    if (file_) file_->flush();
  }
  void on_end(const View&) {
    if (file_) file_->finish();
  }

  void persist(Archive& archive) {
    if (!file_) throw std::runtime_error{path_.string() + ": no individual was born, so there is no file to continue"};
    archive(*file_);
  }
  [[nodiscard]] TableSum sum() const { return file_ ? file_->sum() : TableSum{}; }

 private:
  std::filesystem::path path_;
  std::optional<CsvFile<GenomeRow>> file_;
};

}  // namespace trophic::io
