// SPDX-License-Identifier: MIT
// The rule tables that trophic ships.
#pragma once

#include <trophic/support/linkage.hpp>

namespace trophic {

namespace rules {

struct Paper;
struct Released;

}  // namespace rules

/// Whether trophic::compiled has the ecology of a table, and checked the table when it was compiled.
template <class Rules>
inline constexpr bool is_compiled = false;
template <>
inline constexpr bool is_compiled<rules::Paper> = !TROPHIC_HEADER_ONLY;
template <>
inline constexpr bool is_compiled<rules::Released> = !TROPHIC_HEADER_ONLY;

}  // namespace trophic
