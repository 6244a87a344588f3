// SPDX-License-Identifier: MIT
// Joins words into one text at compile time.
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

/// A text as an argument of a template.
template <std::size_t size>
struct TemplateText {
  std::array<char, size> letters{};
  constexpr TemplateText(const char (&text)[size]) { std::ranges::copy(text, letters.begin()); }
  [[nodiscard]] constexpr std::string_view view() const { return {letters.data(), size - 1}; }
};

namespace detail {

template <TemplateText prefix, class Rule>
struct PrefixedWords {
  static constexpr std::array<std::string_view, 2> words{prefix.view(), Rule::name};
  static constexpr std::string_view separator = "_";
};

}  // namespace detail

/// The name of a policy that wraps another one: "PREFIX_NAME".
template <TemplateText prefix, class Rule>
inline constexpr std::string_view prefixed_name = JoinedText<detail::PrefixedWords<prefix, Rule>>::view;

}  // namespace trophic
