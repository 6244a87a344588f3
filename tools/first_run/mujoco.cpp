// SPDX-License-Identifier: MIT
// The engine of parts.hpp.
#include <trophic/backend/mujoco.hpp>

#include "parts.hpp"

namespace trophic::first_run {

BackendChoice mujoco() {
  return backend::Mujoco::Params{.threads = 2};
}

}  // namespace trophic::first_run
