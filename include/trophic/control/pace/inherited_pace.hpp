// SPDX-License-Identifier: MIT
// A pace that is inherited.
#pragma once

#include <trophic/control/pace/contract.hpp>

namespace trophic::control::pace {

/// The heritable trait of InheritedPace, a fraction of the gait's frequency.
struct WalkingPace {
  static constexpr std::string_view name = "walking_pace";
  static constexpr double first = 1.0, least = 0.2, most = 4.0, sd = 0.1;
};

/// Rule: a robot walks at its own WalkingPace. `Traits` is the table's rule for traits, such as
/// reproduction::traits::List<WalkingPace>. Source: not in the paper. All parameters are free.   Reads: the traits.   Random
/// draws: 0.
template <class Traits>
struct InheritedPace {
  static constexpr std::string_view name = "inherited_pace";
  static constexpr std::string_view source = "not in the paper";
  using ReadsTraits = Traits;

  [[nodiscard]] double pace(BodyIndex self, const View& view) const { return view.trait<WalkingPace>(self); }
};

}  // namespace trophic::control::pace
