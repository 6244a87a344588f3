// SPDX-License-Identifier: MIT
// A body and its gait, as an individual's genes express them.
#pragma once

#include <cstdint>
#include <memory>
#include <trophic/support/cpp20.hpp>

namespace trophic {

namespace body {
struct Design;
}  // namespace body
struct Gait;
struct RobotModel;

/// The body that an individual was born with, and the gait by which it walks. Null: the habitat's, as all have it.
struct Phenotype {
  std::uint64_t individual = 0;  ///< that was born with it
  std::shared_ptr<const body::Design> design;
  std::shared_ptr<const RobotModel> robot;
  std::shared_ptr<const Gait> gait;
};

}  // namespace trophic
