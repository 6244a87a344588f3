// SPDX-License-Identifier: MIT
// Joins words to one text at compile time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <trophic/support/cpp20.hpp>

namespace trophic {

/// `Words::words`, an array of std::string_view, joined by `Words::separator`.
template <class Words>
struct JoinedText {
  static constexpr std::size_t length = [] {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < Words::words.size(); ++i) sum += Words::words[i].size() + (i > 0 ? Words::separator.size() : 0);
    return sum;
  }();
  static constexpr std::array<char, length> text = [] {
    std::array<char, length> joined{};
    auto* end = joined.data();
    for (std::size_t i = 0; i < Words::words.size(); ++i) {
      if (i > 0) end = std::ranges::copy(Words::separator, end).out;
      end = std::ranges::copy(Words::words[i], end).out;
    }
    return joined;
  }();
  static constexpr std::string_view view{text.data(), text.size()};
};

}  // namespace trophic
