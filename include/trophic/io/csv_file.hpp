// SPDX-License-Identifier: MIT
// A file of lines and one of rows, which are never overwritten and never fail silently.
#pragma once

#include <filesystem>
#include <sstream>
#include <trophic/io/column.hpp>
#include <trophic/io/csv.hpp>
#include <trophic/io/growing_file.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::io {

/// Number of rows of a table, without its header, the CRC-32 of its file, and the names and types (type_name) of its columns.
struct TableSum {
  std::uint64_t rows = 0;
  std::uint32_t crc32 = 0;
  std::vector<std::pair<std::string, std::string_view>> columns = {};
};

/// A file that grows by lines. Throws std::runtime_error naming the file if it exists, cannot be written, or begins too long.
class LineFile {
 public:
  static constexpr std::size_t longest_header = std::size_t{1} << 20U;  ///< bytes of the first lines

  /// Writes the first lines at once into a new file.
  LineFile(const std::filesystem::path& path, std::string first, Opening opening = Opening::created)
      : file_{path, opening}, buffer_{std::move(first)} {
    if (buffer_.size() > longest_header) throw std::runtime_error{path.string() + ": its first line is longer than 1 MiB"};
    if (opening == Opening::resumed) buffer_.clear();
    flush();
  }

  /// The text that the next flush writes.
  [[nodiscard]] std::string& buffer() { return buffer_; }

  /// Passes all text so far to the system.
  void flush() {
    file_.append(buffer_);
    lines_ += static_cast<std::uint64_t>(std::ranges::count(buffer_, '\n'));
    buffer_.clear();
  }

  /// Passes all text to the system and waits until it is on the disk.
  void finish() {
    flush();
    file_.sync();
  }

  /// Takes part in checkpoints: see GrowingFile.
  void persist(Archive& archive) {
    if (!archive.reads()) flush();
    archive(file_, lines_);
  }

  /// `types`: of the columns; the last is that of all further ones. Without it the sum has no columns.
  [[nodiscard]] TableSum sum(const std::vector<std::string_view>& types = {}) const {
    TableSum sum{.rows = lines_ == 0 ? 0 : lines_ - 1, .crc32 = file_.checksum()};
    const std::string beginning = types.empty() ? "" : read_part(file_.path(), longest_header);
    std::istringstream names{beginning.substr(0, beginning.find('\n'))};
    for (std::string name; std::getline(names, name, ',');)
      sum.columns.emplace_back(name, types[std::min(sum.columns.size(), types.size() - 1)]);
    return sum;
  }

 private:
  GrowingFile file_;
  std::string buffer_;
  std::uint64_t lines_ = 0;
};

/// A file of rows. Errors as those of LineFile.
template <TableRow Row>
class CsvFile {
 public:
  /// Writes the header at once into a new file; `like`: as header_of.
  explicit CsvFile(const std::filesystem::path& path, const Row& like = {}, Opening opening = Opening::created)
      : file_{path, header_of(like), opening} {}
  CsvFile(const std::filesystem::path& path, Opening opening) : CsvFile{path, {}, opening} {}

  void write(const Row& row, const FoodWeb& web) { append_row(file_.buffer(), row, web); }
  void write(const Row& row) { write(row, FoodWeb{{}, {}}); }
  void flush() { file_.flush(); }
  void finish() { file_.finish(); }
  void persist(Archive& archive) { archive(file_); }
  [[nodiscard]] TableSum sum() const { return file_.sum(column_types<Row>()); }

 private:
  LineFile file_;
};

}  // namespace trophic::io
