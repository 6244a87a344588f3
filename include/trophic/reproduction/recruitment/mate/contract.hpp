// SPDX-License-Identifier: MIT
// The contract of a part of recruitment::WithMate: a preference among possible mates.
#pragma once

#include <trophic/params/policy.hpp>
#include <trophic/population/view.hpp>

namespace trophic::reproduction::recruitment {

/// `weight(self, other, view)`: returns the weight, >= 0 and finite, with which the individual in the body `self` chooses that in
/// the body `other`; with 0 it never does.
template <class P>
concept MatePreference = requires(const P policy, BodyIndex self, BodyIndex other, const View& view) {
  { P::name } -> std::convertible_to<std::string_view>;
  { policy.weight(self, other, view) } -> std::same_as<double>;
};

}  // namespace trophic::reproduction::recruitment
