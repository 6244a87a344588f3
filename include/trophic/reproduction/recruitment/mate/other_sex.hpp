// SPDX-License-Identifier: MIT
// Females choose males.
#pragma once

#include <trophic/reproduction/recruitment/mate/contract.hpp>
#include <trophic/reproduction/traits/list.hpp>
#include <trophic/reproduction/traits/sex.hpp>

namespace trophic::reproduction::recruitment::mate {

/// Rule: a female chooses among males, w = 1; all other pairs have w = 0. So each birth has a mother, who is the first parent,
/// and a father.   Reads: the trait Sex.   Random draws: 0.
struct OtherSex {
  static constexpr std::string_view name = "other_sex";
  static constexpr std::string_view source = "not in the paper";
  using ReadsTraits = traits::List<traits::Sex>;

  [[nodiscard]] double weight(BodyIndex self, BodyIndex other, const View& view) const {
    return view.trait<traits::Sex>(self) == 1.0 && view.trait<traits::Sex>(other) == 0.0 ? 1.0 : 0.0;
  }
};
static_assert(MatePreference<OtherSex>);

}  // namespace trophic::reproduction::recruitment::mate
