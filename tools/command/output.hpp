// SPDX-License-Identifier: MIT
// Output of a program whose loss is an error.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/support/control_characters.hpp>

namespace trophic::command {

/// A path as it is printed: in one line, with control characters as \x0a.
[[nodiscard]] inline std::string shown(const std::filesystem::path& path) {
  constexpr std::string_view digits = "0123456789abcdef";
  const std::string text = path.string();
  std::string line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t control = control_bytes(std::string_view{text}.substr(i));
    if (control == 0) line += text[i];
    for (std::size_t end = i + control; i < end; ++i) {
      const auto byte = static_cast<unsigned char>(text[i]);
      line += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
    }
    if (control > 0) --i;
  }
  return line;
}

/// Flushes standard output. Throws std::runtime_error if that fails.
inline void flush_output() {
  std::cout.flush();
  if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
}

/// Throws std::invalid_argument, naming the option, if the path of a new file exists already.
inline void check_new_file(const std::string& option, const std::filesystem::path& path) {
  if (!std::filesystem::exists(std::filesystem::symlink_status(path))) return;
  throw std::invalid_argument{option + " " + path.string() + ": exists already; files are never overwritten"};
}

/// A default for --out: the name of a file or folder with a different ending, in the working folder, followed by -2, -3, ... if
/// it is taken.
[[nodiscard]] inline std::string free_name(const std::filesystem::path& of, const std::string& ending) {
  const std::filesystem::path whole = std::filesystem::absolute(of).lexically_normal();
  const std::string stem = (whole.has_filename() ? whole : whole.parent_path()).stem().string();
  std::string name = stem + ending;
  for (std::size_t number = 2; std::filesystem::exists(std::filesystem::symlink_status(name)); ++number) {
    name = stem + "-" + std::to_string(number) + ending;
  }
  return name;
}

/// A number of bytes as "6.2 MB".
[[nodiscard]] inline std::string megabytes_text(std::size_t bytes) {
  return std::to_string(bytes / 1000000) + "." + std::to_string(bytes / 100000 % 10) + " MB";
}

/// Prints a text and returns 0, the exit code of a command that only prints.
[[nodiscard]] inline int print_text(const std::string& text) {
  std::cout << text;
  flush_output();
  return 0;
}

}  // namespace trophic::command
