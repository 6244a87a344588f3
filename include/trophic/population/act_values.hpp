// SPDX-License-Identifier: MIT
// The last values of acts, by body.
#pragma once

#include <span>
#include <string_view>
#include <trophic/population/individual.hpp>

namespace trophic {

namespace detail {

/// An object for each type of act, so that its address names the type.
template <class Act>
inline constexpr char act_key = 0;

/// An act whose value is a member of an individual: Turn and Tag.
template <class Act>
concept KeptByIndividual = requires(const Individual& self) {
  Act::of(self);
};

}  // namespace detail

/// The values of acts at the last decision of each body; without acts in a table whose robots only turn and choose a tag.
struct ActValues {
  std::span<const char* const> acts = {};        ///< `&detail::act_key<Act>` of each act
  std::span<const std::string_view> names = {};  ///< of each act; empty of one that an individual keeps
  std::span<const double> values = {};           ///< of each body, one for each act

  /// The value of an act; its default in a table without it.
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
