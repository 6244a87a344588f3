// SPDX-License-Identifier: MIT
// Files of lines and of rows, which are never overwritten and never fail silently.
#pragma once

#include <filesystem>
#include <trophic/io/csv.hpp>
#include <trophic/io/growing_file.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::io {

/// A file that grows by lines. Throws std::runtime_error naming the file if it exists, cannot be written, or has too long a first
/// line.
class LineFile {
 public:
  /// Writes the first lines at once into a new file.
  LineFile(const std::filesystem::path& path, std::string first, Opening opening = Opening::created)
      : file_{path, opening}, buffer_{std::move(first)} {
    if (buffer_.size() > TableSum::longest_header)
      throw std::runtime_error{path.string() + ": its first line is longer than 1 MiB"};
    if (opening == Opening::resumed) buffer_.clear();
    flush();
  }

  /// The text that the next flush writes; a long text is flushed soon. Call this at the beginning of a line.
  [[nodiscard]] std::string& buffer() {
    if (buffer_.size() > (std::size_t{1} << 16U)) flush();
    return buffer_;
  }

  /// Passes all text written so far to the operating system.
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

  /// `columns`: as in add_columns. Without them the sum has none.
  [[nodiscard]] TableSum sum(const std::vector<TypedColumn>& columns = {}) const {
    TableSum sum{.rows = lines_ == 0 ? 0 : lines_ - 1, .crc32 = file_.checksum()};
    if (!columns.empty()) sum.add_columns(read_part(file_.path(), TableSum::longest_header), columns);
    return sum;
  }

 private:
  GrowingFile file_;
  std::string buffer_;
  std::uint64_t lines_ = 0;
};

/// A file of rows, with the errors of LineFile.
template <TableRow Row>
class CsvFile {
 public:
  /// Writes the header at once into a new file; `like`: as header_of; none: `begin` writes the header.
  explicit CsvFile(const std::filesystem::path& path, const std::optional<Row>& like = Row{}, Opening opening = Opening::created)
      : file_{path, like ? header_of(*like) : "", opening}, lacks_header_{!like && opening == Opening::created} {}
  CsvFile(const std::filesystem::path& path, Opening opening) : CsvFile{path, Row{}, opening} {}

  void begin(const Row& like) {
    if (std::exchange(lacks_header_, false)) file_.buffer() = header_of(like);
  }

  void write(const Row& row, const FoodWeb& web) { append_row(file_.buffer(), row, web); }
  void write(const Row& row) { write(row, FoodWeb{{}, {}}); }
  void flush() { file_.flush(); }
  void finish() { file_.finish(); }
  void persist(Archive& archive) { archive(file_); }
  [[nodiscard]] TableSum sum() const { return file_.sum(typed_columns<Row>()); }

 private:
  LineFile file_;
  bool lacks_header_;
};

}  // namespace trophic::io
