// SPDX-License-Identifier: MIT
// A CSV file that is never overwritten and never fails silently.
#pragma once

#include <array>
#include <cerrno>
#include <charconv>
#include <concepts>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/params/params.hpp>
#include <type_traits>

namespace trophic::observe {

/// A number written with a fixed count of decimals: metres to the micrometre.
struct Decimal {
  double value = 0.0;
  int decimals = 6;
};

/// Writes rows of plain values: numbers in their shortest exact form, Decimal as it says, none and NaN as an empty cell,
/// enumerators by name, texts as they are (they must not contain a comma). Throws std::runtime_error naming the file when it
/// exists or the system refuses to write.
class CsvFile {
 public:
  CsvFile(const std::filesystem::path& path, std::string_view header) : path_{path}, file_{std::fopen(path.c_str(), "wx")} {
    if (!file_) fail("create");
    buffer_.append(header).push_back('\n');
    flush();
  }

  template <class... Cells>
  void row(const Cells&... cells) {
    (cell(cells), ...);
    end_row();
  }

  /// One more cell of the row that end_row() ends.
  template <class Cell>
  void cell(const Cell& value) {
    append(value);
    buffer_.push_back(',');
  }
  void end_row() { buffer_.back() = '\n'; }

  /// Hands everything written so far to the system.
  void flush() {
    const bool written = std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) == buffer_.size();
    buffer_.clear();
    if (!written || std::fflush(file_.get()) != 0) fail("write");
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  template <class Cell>
  void append(const Cell& value) {
    if constexpr (std::same_as<Cell, bool>) {
      buffer_.push_back(value ? '1' : '0');
    } else if constexpr (std::floating_point<Cell>) {
      if (value == value) append_number(value);
    } else if constexpr (std::integral<Cell>) {
      append_number(value);
    } else if constexpr (std::same_as<Cell, Decimal>) {
      if (value.value == value.value) append_number(value.value, std::chars_format::fixed, value.decimals);
    } else if constexpr (NamedEnum<Cell>) {
      buffer_.append(enum_name(value));
    } else if constexpr (requires { value.has_value(); }) {
      if (value) append(*value);
    } else {
      buffer_.append(value);
    }
  }

  template <class... Arguments>
  void append_number(Arguments... arguments) {
    std::array<char, 400> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), arguments...);
    buffer_.append(text.data(), end.ptr);
  }

  [[noreturn]] void fail(std::string_view what) const {
    throw std::runtime_error{"cannot " + std::string{what} + " " + path_.string() + ": " + std::strerror(errno)};
  }

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string buffer_;
};

}  // namespace trophic::observe
