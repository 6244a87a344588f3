// SPDX-License-Identifier: MIT
// `trophic measure-gait`.
#include <trophic/command/measure_gait.hpp>

#include "commands.hpp"

trophic::command::Command commands::measure_gait() {
  return trophic::command::measure_gait();
}
