// SPDX-License-Identifier: MIT
// Reads a table file into the rows that it was written from.
#pragma once

#include <tools/reading/csv_reader.hpp>

namespace trophic::analysis {

/// The rows of a file by their columns, which may stand anywhere; other columns are the row's named ones or passed over.
template <io::TableRow Row>
class TableReader {
 public:
  /// `web` names the species; it must outlive the reader. Throws std::runtime_error as CsvReader.
  TableReader(const std::filesystem::path& path, const FoodWeb& web) : csv_{path, {}}, web_{web} {
    io::for_each_column<Row>([&](const auto& column) {
      if constexpr (io::is_list_columns<std::remove_cvref_t<decltype(column)>>) {
        for (; csv_.has(name_in_list(column.name, list_size_)); ++list_size_) csv_.want(name_in_list(column.name, list_size_));
      } else if constexpr (io::is_named_columns<std::remove_cvref_t<decltype(column)>>) {
        for (const std::string& name : csv_.header()) {
          if (csv_.is_wanted(name)) continue;
          csv_.want(name);
          names_.push_back(name);
        }
      } else if (!lacks(column)) {
        csv_.want(column.name);
      }
    });
  }

  /// Reads the next row; false after the last. Throws std::runtime_error "FILE:LINE: COLUMN = "TEXT": must be ...".
  bool next(Row& row) {
    if (!csv_.next()) return false;
    std::size_t place = 0;
    io::for_each_column<Row>([&](const auto& column) {
      using Kind = std::remove_cvref_t<decltype(column)>;
      auto& value = row.*column.member;
      if (lacks(column)) return;
      if constexpr (io::is_list_columns<Kind>) {
        std::size_t size = list_size_;  // the last cells of a smaller brain are empty
        while (size > 0 && csv_.text(place + size - 1).empty()) --size;
        value.clear();
        for (std::size_t i = 0; i < size; ++i) value.push_back(csv_.get<double>(place + i));
        place += list_size_;
      } else if constexpr (io::is_named_columns<Kind>) {
        value = {.names = names_, .values = {}};
        for (std::size_t i = 0; i < names_.size(); ++i) value.values.push_back(csv_.get<double>(place++));
      } else if constexpr (io::is_species_column<Kind>) {
        value = species(place++);
      } else if constexpr (requires { value.has_value(); }) {
        value = csv_.get_optional<typename std::remove_cvref_t<decltype(value)>::value_type>(place++, column.written.none);
      } else {
        value = csv_.get<std::remove_cvref_t<decltype(value)>>(place++);
      }
    });
    return true;
  }

  [[nodiscard]] const CsvReader& csv() const { return csv_; }

  /// Throws std::runtime_error about a cell of the row at hand.
  [[noreturn]] void reject(std::string_view column, std::string_view must) const { csv_.reject(csv_.place_of(column), must); }

 private:
  /// Whether the column is one of those that only some files have, and this one has not.
  [[nodiscard]] bool lacks(const auto& column) const { return io::is_left_out(column, Row{}) && !csv_.has(column.name); }

  [[nodiscard]] static std::string name_in_list(std::string_view name, std::size_t i) {
    return std::string{name} + std::to_string(i);
  }

  [[nodiscard]] Species species(std::size_t place) const {
    for (Species species = 0; species < web_.size(); ++species) {
      if (web_.name(species) == csv_.text(place)) return species;
    }
    csv_.reject(place, "a species of the run's manifest");
  }

  CsvReader csv_;
  const FoodWeb& web_;
  std::size_t list_size_ = 0;
  std::vector<std::string> names_ = {};  ///< of the row's named columns
};

}  // namespace trophic::analysis
