// SPDX-License-Identifier: MIT
// The error for an invalid return value of a policy, with its slot, the value and the bound.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// A policy returned a value that does not exist or violates its contract: an error in the rule, not in its parameters.
class RuleError : public std::logic_error {
 public:
  explicit RuleError(const std::string& sentence) : std::logic_error{sentence} {}
  RuleError(std::string_view slot, const std::string& what);
};

namespace detail {

[[noreturn]] void reject_index(std::string_view slot, std::string_view what, std::size_t value, std::size_t size);

}  // namespace detail

/// Throws RuleError unless `value` < `size`.
inline void check_index(std::string_view slot, std::string_view what, std::size_t value, std::size_t size) {
  if (value >= size) detail::reject_index(slot, what, value, size);
}

/// Throws RuleError unless a brain lists at least one tag and each tag once.
void check_tags(std::span<const int> tags);

/// Throws RuleError unless `tag` is one of the brain's tags.
void check_tag(std::span<const int> tags, int tag, std::string_view slot);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/rule_error.ipp>
#endif
