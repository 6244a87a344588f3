// SPDX-License-Identifier: MIT
// The latest values of acts, by body.
#pragma once

#include <span>
#include <string_view>
#include <trophic/population/individual.hpp>

namespace trophic {

namespace detail {

/// An object for each type of act, whose address identifies the type.
template <class Act>
inline constexpr char act_key = 0;

/// An act whose value is a member of an individual: Turn and Tag.
template <class Act>
concept KeptByIndividual = requires(const Individual& self) {
  Act::of(self);
};

}  // namespace detail

/// The values of acts at the last decision of each body; empty in a table whose robots only turn and choose a tag.
struct ActValues {
  std::span<const char* const> acts = {};        ///< `&detail::act_key<Act>` of each act
  std::span<const std::string_view> names = {};  ///< one per act; empty for an act that is stored in the individual
  std::span<const double> values = {};           ///< one per body and act

  /// The value of an act, or its default in a table without it.
  template <class Act>
  [[nodiscard]] auto of(BodyIndex body) const {
    using Value = std::remove_cv_t<decltype(Act::by_default)>;
    for (std::size_t place = 0; place < acts.size(); ++place) {
      if (acts[place] == &detail::act_key<Act>) return static_cast<Value>(values[body * acts.size() + place]);
    }
    return Act::by_default;
  }
};

}  // namespace trophic
