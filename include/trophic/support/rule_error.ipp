// SPDX-License-Identifier: MIT
// Definitions of rule_error.hpp.
#pragma once

#include <algorithm>
#include <trophic/support/rule_error.hpp>

namespace trophic {

TROPHIC_INLINE RuleError::RuleError(std::string_view slot, const std::string& what)
    : std::logic_error{"the policy in rules." + std::string{slot} + " returned " + what} {}

namespace detail {

TROPHIC_INLINE void reject_index(std::string_view slot, std::string_view what, std::size_t value, std::size_t size) {
  throw RuleError{slot, std::string{what} + " " + std::to_string(value) + ": must be < " + std::to_string(size)};
}

}  // namespace detail

TROPHIC_INLINE void check_tags(std::span<const int> tags) {
  if (tags.empty()) throw RuleError{"brain", "no tags(): must list every tag that it may choose"};
  for (auto tag = tags.begin(); tag != tags.end(); ++tag) {
    if (std::find(tags.begin(), tag, *tag) == tag) continue;
    throw RuleError{"brain", "tags() with " + std::to_string(*tag) + " twice: must list each tag once"};
  }
}

TROPHIC_INLINE void check_tag(std::span<const int> tags, int tag, std::string_view slot) {
  if (std::ranges::find(tags, tag) != tags.end()) return;
  std::string known;
  for (const int one : tags) known += (known.empty() ? "" : ", ") + std::to_string(one);
  throw RuleError{slot, "tag " + std::to_string(tag) + ": must be one of the brain's tags() (" + known + ")"};
}

}  // namespace trophic
