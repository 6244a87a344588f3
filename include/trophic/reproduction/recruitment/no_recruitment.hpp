// SPDX-License-Identifier: MIT
// No spare bodies: every death is followed by a birth in the same body.
#pragma once

#include <trophic/reproduction/recruitment/contract.hpp>

namespace trophic::reproduction::recruitment {

/// Rule: each body has an individual at all times, and a birth needs a death (Sec. "Birth").   Reads: nothing.   Random draws: 0.
struct NoRecruitment {
  static constexpr std::string_view name = "no_recruitment";
  static constexpr std::string_view source = "paper, Sec. \"Birth\"";
  using NamesOneParent = NoRecruitment;
  [[nodiscard]] std::size_t spare_bodies() const { return 0; }
  [[nodiscard]] bool leaves_spare(const Vacancy&, const View&) const { return false; }
  [[nodiscard]] std::vector<Recruit> recruits(const View&, Rng&) const { return {}; }
};
static_assert(Recruitment<NoRecruitment>);

}  // namespace trophic::reproduction::recruitment
