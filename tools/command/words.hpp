// SPDX-License-Identifier: MIT
// Lists of words in sentences, and the nearest word to a misspelt one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trophic::command {

/// Number of letters to insert, delete, replace or swap with their neighbour to turn `a` into `b` (optimal string
/// alignment distance).
[[nodiscard]] inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

/// The nearest word to `word` (the first of several); `nullopt` if all differ by more than a third of the longer one's letters,
/// for the empty word, and for a word that is one of them.
[[nodiscard]] inline std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> words) {
  std::optional<std::string> nearest;
  std::size_t least = word.size();
  for (const std::string& candidate : words) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance == 0) return std::nullopt;
    if (distance < least && 3 * distance <= std::max(word.size(), candidate.size())) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

/// "; did you mean WORD?", or an empty text if no word is near.
[[nodiscard]] inline std::string did_you_mean(const std::optional<std::string>& word) {
  return word ? "; did you mean " + *word + "?" : "";
}

/// "a", "a or b", "a, b or c".
[[nodiscard]] inline std::string one_of(std::span<const std::string> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

/// "WORD: must be a, b or c".
[[nodiscard]] inline std::string must_be_one_of(const std::string& word, std::span<const std::string> words) {
  return word + ": must be " + one_of(words);
}

}  // namespace trophic::command
