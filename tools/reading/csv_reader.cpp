// SPDX-License-Identifier: MIT
// Definitions of csv_reader.hpp.
#include <tools/reading/csv_reader.hpp>

namespace trophic::analysis {

CsvReader::CsvReader(const std::filesystem::path& path, std::initializer_list<std::string_view> columns) : file_{path.string()} {
  try {
    const std::string beginning = read_part(path, io::TableSum::longest_header);
    if (beginning.find('\0') != std::string::npos ||
        (beginning.size() == io::TableSum::longest_header && beginning.find('\n') == std::string::npos)) {
      throw std::invalid_argument{file_ + ":1: is not the header of a table"};
    }
    text_ = read_whole_file(path, largest_table);
  } catch (const std::invalid_argument& reason) {
    throw std::runtime_error{reason.what()};
  }
  if (!split_line()) throw error("has no header");
  header_.assign(cells_.begin(), cells_.end());
  for (auto name = header_.begin(); name != header_.end(); ++name) {
    if (std::find(header_.begin(), name, *name) != name) throw error(1, "column \"" + excerpt(*name) + "\" twice: must be once");
  }
  for (const std::string_view column : columns) want(column);
}

void CsvReader::want(std::string_view column) {
  const auto found = std::ranges::find(header_, column);
  if (found == header_.end()) throw error(1, "no column \"" + std::string{column} + "\"; another kind of file?");
  wanted_.push_back({std::string{column}, static_cast<std::size_t>(found - header_.begin())});
}

bool CsvReader::next() {
  if (!split_line()) return false;
  if (cells_.size() != header_.size()) {
    throw error(line_, std::to_string(cells_.size()) + " cells, the header has " + std::to_string(header_.size()));
  }
  return true;
}

std::size_t CsvReader::place_of(std::string_view column) const {
  return static_cast<std::size_t>(std::ranges::find(wanted_, column, &Wanted::name) - wanted_.begin());
}

[[noreturn]] void CsvReader::reject(std::size_t column, std::string_view must) const {
  throw error(line_, wanted_.at(column).name + " = \"" + excerpt(text(column)) + "\": must be " + std::string{must});
}

std::runtime_error CsvReader::error(std::size_t line, const std::string& what) const {
  return std::runtime_error{file_ + ":" + std::to_string(line) + ": " + what};
}

bool CsvReader::split_line() {
  const std::size_t end = text_.find('\n', at_);
  if (end == std::string::npos) {
    truncated_ = at_ < text_.size();
    return false;
  }
  ++line_;
  std::string_view rest = std::string_view{text_}.substr(at_, end - at_);
  if (rest.ends_with('\r')) rest.remove_suffix(1);
  at_ = end + 1;
  cells_.clear();
  for (bool more = true; more;) {
    const bool is_quoted = rest.starts_with('"') && rest.find('"', 1) != std::string_view::npos;
    const std::size_t comma = rest.find(',', is_quoted ? rest.find('"', 1) : 0);
    more = comma != std::string_view::npos;
    const std::string_view cell = rest.substr(0, comma);
    cells_.push_back(is_quoted && cell.size() >= 2 && cell.ends_with('"') ? cell.substr(1, cell.size() - 2) : cell);
    rest.remove_prefix(more ? comma + 1 : 0);
  }
  return true;
}

}  // namespace trophic::analysis
