// SPDX-License-Identifier: MIT
// Two rules for the heading of a robot, each also reversed on its back.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/perception/heading/forward_axis_heading.hpp>
#include <trophic/perception/heading/reversed_on_back.hpp>
#include <trophic/perception/heading/root_yaw_heading.hpp>

#include "either.hpp"

namespace trophic::readings {

/// Behaves as ForwardAxisHeading or RootYawHeading; with the second reading of `on_back`, as ReversedOnBack of it.
struct AnyHeading {
  static constexpr std::string_view name = "any_heading";

  struct Params {
    Reading reading = Reading::first;
    Reading on_back = Reading::first;
    static constexpr auto fields() {
      return std::tuple{field("reading", &Params::reading, "first: along the forward axis, second: by the yaw of the root"),
                        field("on_back", &Params::on_back, "first: as upright, second: reversed")};
    }
  };
  Params params;

  [[nodiscard]] double heading_rad(const Pose& root, double forward_rad) const {
    const auto by = [&]<class Rule>(Rule rule) {
      if (params.on_back == Reading::first) return rule.heading_rad(root, forward_rad);
      return perception::heading::ReversedOnBack<Rule>{}.heading_rad(root, forward_rad);
    };
    if (params.reading == Reading::first) return by(perception::heading::ForwardAxisHeading{});
    return by(perception::heading::RootYawHeading{});
  }
};
static_assert(perception::Heading<AnyHeading>);

}  // namespace trophic::readings
