// SPDX-License-Identifier: MIT
// The share of random controllers, a parameter of two genome sources.
#pragma once

#include <trophic/params/params.hpp>

namespace trophic::reproduction::genome_source::detail {

struct RandomShare {
  double random_share = 1.0 / 3.0;
  static constexpr auto fields() {
    return std::tuple{
        field("random_share", &RandomShare::random_share, between(0.0, 1.0), "probability that a new controller is random")};
  }
};

}  // namespace trophic::reproduction::genome_source::detail
