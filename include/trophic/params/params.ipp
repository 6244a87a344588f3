// SPDX-License-Identifier: MIT
// Definitions of params.hpp.
#pragma once

#include <cmath>
#include <stdexcept>
#include <trophic/params/params.hpp>

namespace trophic {

TROPHIC_INLINE std::string bound_text(const Bound& bound) {
  const bool has_upper = std::isfinite(bound.upper);
  if (!std::isfinite(bound.lower)) return has_upper ? "must be <= " + number_text(bound.upper) : "must be finite";
  const std::string lower = (bound.lower_excluded ? "must be > " : "must be >= ") + number_text(bound.lower);
  return has_upper ? lower + " and <= " + number_text(bound.upper) : lower;
}

TROPHIC_INLINE std::string join_path(std::string_view prefix, std::string_view name) {
  return prefix.empty() ? std::string{name} : std::string{prefix} + "." + std::string{name};
}

namespace detail {

TROPHIC_INLINE void reject_number(std::string_view prefix, std::string_view name, double value, const std::string& text,
                                  const Bound& bound) {
  throw std::invalid_argument{join_path(prefix, name) + " = " + text + ": " +
                              (std::isfinite(value) ? bound_text(bound) : "must be finite")};
}

}  // namespace detail

}  // namespace trophic
