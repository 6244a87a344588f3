// SPDX-License-Identifier: MIT
// A body and its gait, as expressed by an individual's genes.
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

/// The body with which an individual was born, and the gait with which it walks. Null pointers mean the habitat's body and gait.
struct Phenotype {
  std::uint64_t individual = 0;  ///< the individual born with it
  std::shared_ptr<const body::Design> design;
  std::shared_ptr<const RobotModel> robot;
  std::shared_ptr<const Gait> gait;
};

}  // namespace trophic
