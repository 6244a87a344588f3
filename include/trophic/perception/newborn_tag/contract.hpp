// SPDX-License-Identifier: MIT
// The contract of a slot: the tag of an individual at birth.
#pragma once

#include <concepts>
#include <optional>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_NewbornTag                                               \
  "int tag(std::optional<int> body_tag, std::span<const int> tags, Rng&) const; " \
  "see trophic/perception/newborn_tag/contract.hpp"

namespace trophic::perception {

/// `tag(body_tag, tags, rng)`: returns the tag of an individual at birth, one of the brain's `tags`. body_tag is that of the
/// body's previous occupant, empty for a founder.
template <class P>
concept NewbornTag = requires(const P policy, std::optional<int> body_tag, std::span<const int> tags, Rng& rng) {
  { policy.tag(body_tag, tags, rng) } -> std::same_as<int>;
};

}  // namespace trophic::perception
