// SPDX-License-Identifier: MIT
// `trophic evolve-gait`.
#include <trophic/command/evolve_gait.hpp>

#include "commands.hpp"

trophic::command::Command commands::evolve_gait() {
  return trophic::command::evolve_gait();
}
