// SPDX-License-Identifier: MIT
// The error for an invalid return value of a policy, with its slot, the value and the bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/support/cpp20.hpp>

namespace trophic {

/// Thrown if a policy returns a value that does not exist or violates its contract: an error in the rule, not in its parameters.
class RuleError : public std::logic_error {
 public:
  explicit RuleError(const std::string& sentence) : std::logic_error{sentence} {}
  RuleError(std::string_view slot, const std::string& what)
      : std::logic_error{"the policy in rules." + std::string{slot} + " returned " + what} {}
};

/// Throws RuleError unless `value` < `size`.
inline void check_index(std::string_view slot, std::string_view what, std::size_t value, std::size_t size) {
  if (value < size) return;
  throw RuleError{slot, std::string{what} + " " + std::to_string(value) + ": must be < " + std::to_string(size)};
}

/// Throws RuleError unless all numbers are finite.
inline void check_finite(std::string_view slot, std::string_view what, std::span<const double> numbers) {
  if (std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); })) return;
  throw RuleError{slot, std::string{what} + ": must be finite"};
}

/// Throws RuleError unless a brain lists at least one tag and each tag once.
inline void check_tags(std::span<const int> tags) {
  if (tags.empty()) throw RuleError{"brain", "no tags(): must list every tag that it may choose"};
  for (auto tag = tags.begin(); tag != tags.end(); ++tag) {
    if (std::find(tags.begin(), tag, *tag) == tag) continue;
    throw RuleError{"brain", "tags() with " + std::to_string(*tag) + " twice: must list each tag once"};
  }
}

/// Throws RuleError unless `tag` is one of the brain's tags.
inline void check_tag(std::span<const int> tags, int tag, std::string_view slot) {
  if (std::ranges::find(tags, tag) != tags.end()) return;
  std::string known;
  for (const int one : tags) known += (known.empty() ? "" : ", ") + std::to_string(one);
  throw RuleError{slot, "tag " + std::to_string(tag) + ": must be one of the brain's tags() (" + known + ")"};
}

}  // namespace trophic
