// SPDX-License-Identifier: MIT
// Checks of option values for which CLI11 has no clear message or different rules.
#pragma once

#include <algorithm>
#include <charconv>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <tools/command/option.hpp>
#include <tools/command/words.hpp>

namespace trophic::command::detail {

/// Throws std::invalid_argument "--seed -1: must be >= 0" for texts that CLI11 reads as another number: -1 as 2^64 - 1, 010 as
/// 8.
inline void check_whole_number(const std::string& option, const std::string& text) {
  const auto refuse = [&](const std::string& must) { throw std::invalid_argument{option + " " + text + ": must be " + must}; };
  const auto all_digits = [](std::string_view digits) {
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  };
  if (text.starts_with('-') && all_digits(std::string_view{text}.substr(1))) refuse(">= 0");
  if (!all_digits(text) || (text.size() > 1 && text.front() == '0')) refuse("a whole number in decimal digits");
  std::uint64_t value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) {
    refuse("<= " + std::to_string(std::numeric_limits<std::uint64_t>::max()));
  }
}

/// Throws std::invalid_argument for texts that are not plain decimal numbers, some of which CLI11 accepts: 0x10, 1e, an empty
/// text.
inline void check_decimal_number(const std::string& option, const std::string& text) {
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool all = read.ptr == text.data() + text.size() && !text.empty();
  if (!all || (read.ec != std::errc{} && read.ec != std::errc::result_out_of_range)) {
    throw std::invalid_argument{option + " " + text + ": must be a number in decimal digits"};
  }
}

/// Throws std::invalid_argument for an empty text: `--config "$FILE"` with FILE unset would otherwise run a different experiment.
inline void check_text(const std::string& option, const std::string& text) {
  if (text.empty()) throw std::invalid_argument{option + ": must not be empty"};
}

/// Throws std::invalid_argument for a word that the option does not accept.
inline void check_word(const Option& option, const std::string& word) {
  if (std::ranges::find(option.words, word) != option.words.end()) return;
  throw std::invalid_argument{must_be_one_of(option.name + " " + word, option.words) +
                              did_you_mean(nearest_word(word, option.words))};
}

}  // namespace trophic::command::detail
